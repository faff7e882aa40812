"""The debugger in the terminal: a screen over a debugging session, drawn by Textual."""
