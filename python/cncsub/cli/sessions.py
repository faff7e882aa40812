"""The debugging session that the options of a command describe."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from cncsub.analysis.notes import Note
from cncsub.cli.memory import memory_of
from cncsub.cli.options import run_options
from cncsub.cli.output import tell_all
from cncsub.debugging import Session
from cncsub.run_options import stated

# The options of `cncsub run` that a session takes, as they are where nothing is asked for.
_UNASKED: dict[str, Any] = {
    **dict.fromkeys(("paths", "control", "main", "mdi", "external", "prefer", "encoding")),
    **dict.fromkeys(("param", "set", "variables", "skip", "setup", "inputs")),
    **{name: option.default for name, option in stated().items() if option.asked is not None},
}


def session_of(
    options: Mapping[str, Any], tell: Callable[[Sequence[Note]], None] = tell_all
) -> Session:
    """Return a session before its first block; the options mean what they mean to `cncsub run`, and
    may be left out. `tell` reports the notes on the memory.

    Raises `KeyError`, `TypeError`, `ValueError` and `OSError` as `wrong_use` takes them.
    """
    asked = {**_UNASKED, **options}
    if asked["mdi"] is not None:
        raise ValueError("a session debugs a program; --mdi has none to step through")
    library = memory_of(asked, tell)
    return Session(library, asked["main"], **run_options(asked, "moves"))
