"""Every program of some folders, by several processes, into one table."""
