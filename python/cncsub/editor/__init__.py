"""What editors ask of a memory of NC programs: the server of the Language Server Protocol."""
