"""The command `cncsub debug`."""

from __future__ import annotations

import sys
from typing import Any

from cncsub.cli.options import (
    ControlName,
    Main,
    Paths,
    WrongUseError,
    of_extra,
    runs_programs,
    wrong_use,
)
from cncsub.cli.sessions import session_of
from cncsub.debugging import Session


@runs_programs()
def debug(
    paths: Paths = None, control: ControlName = None, main: Main = None, **shared: Any
) -> None:
    """Debug a program in the terminal: breakpoints, steps forwards and back, variables.

    `?` shows the keys. Needs `pip install 'cncsub[debug]'`.
    """
    if not on_terminal():
        raise WrongUseError("debug shows a screen: run it in a terminal, without a pipe")
    with of_extra("debug", "the debugger in the terminal", "textual", "plotille"):
        from cncsub.terminal.app import DebugApp
    if "-" in (paths or ()):
        raise WrongUseError("debug takes its keys from the standard input: give a file")
    options = {"paths": paths, "control": control, "main": main, "mdi": None, **shared}
    notes: list[str] = []
    with wrong_use():
        session = session_of(options, lambda told: notes.extend(f"note: {each}" for each in told))
        title = title_of(session, main)
    DebugApp(session, title, [*notes, *told_start(shared["start"])]).run()


def on_terminal() -> bool:
    return sys.stdin.isatty() and sys.stdout.isatty()


def title_of(session: Session, main: str | None) -> str:
    """Return what is debugged, on which control."""
    library = session.library
    program = library.main if main is None else library[main]
    name = "nothing" if program is None else program.name
    return f"cncsub debug: {name} on {library.control.title}"


def told_start(start: int | None) -> list[str]:
    """Return what is to be known of a run that begins in the middle of its program."""
    if start is None:
        return []
    return [
        f"--start {start}: begins at N{start} with the modes of power-on; what stands before it was"
        " not run"
    ]
