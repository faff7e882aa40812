"""What agents ask of programs: the server of the Model Context Protocol."""
