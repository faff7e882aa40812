"""What no source settles of a control, and short programs by which the owner of the machine can."""
