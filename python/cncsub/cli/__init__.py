"""The command `cncsub`. It is made of what the extra `cli` installs, and says so where that is
missing; the other modules of this room that need it import it themselves.
"""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from cncsub.cli.commands import COMMANDS, app

__all__ = ["COMMANDS", "app", "main"]

_NEEDED = ("rich", "typer")  # the extra `cli`


def main() -> None:
    """Run the command `cncsub`."""
    try:
        from cncsub.cli import commands
    except ModuleNotFoundError as error:
        if error.name not in _NEEDED:
            raise
        sys.exit(_missing(error.name))
    commands.main()


def _missing(name: str) -> int:
    """Report that the command cannot run without this package, and return its exit status."""
    print(
        f"cncsub: the command needs {name}, which is not installed:"
        " pip install 'cncsub[cli]'; `import cncsub` works without it",
        file=sys.stderr,
    )
    return 2


def __getattr__(name: str) -> Any:
    if name not in ("COMMANDS", "app"):
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from cncsub.cli import commands

    return getattr(commands, name)
