"""The debugging session that the options of a command describe."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from cncsub.cli.options import memory_of, run_options
from cncsub.debugging import Session


def session_of(options: Mapping[str, Any]) -> Session:
    """Return a session before its first block; the options mean what they mean to `cncsub run`.

    Raises `KeyError`, `TypeError`, `ValueError` and `OSError` as `wrong_use` takes them.
    """
    if options.get("mdi") is not None:
        raise ValueError("a session debugs a program; --mdi has none to step through")
    library = memory_of(options)
    return Session(library, options.get("main"), **run_options(options, "moves"))
