"""The command `cncsub`."""

from cncsub.cli.commands import COMMANDS, app, main

__all__ = ["COMMANDS", "app", "main"]
