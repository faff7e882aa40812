"""Ctrl-C: every command ends within a second of it, and says so by its exit status."""

from __future__ import annotations

import contextlib
import os
import signal
import sys
import threading
from collections.abc import Iterator
from typing import TYPE_CHECKING, NoReturn

if TYPE_CHECKING:
    from cncsub.run import Run


STATUS = 130  # what a shell says of a command that Ctrl-C ended
_GRACE = 0.8  # seconds until the process ends, whatever still holds it


_pressed = threading.Event()


def uninterrupted(run: Run) -> Run:
    """Return the run; raise `KeyboardInterrupt` where Ctrl-C broke it off, for work that needs all
    of it.
    """
    if run.stop == "interrupted":
        raise KeyboardInterrupt
    return run


def pressed() -> bool:
    """Return whether Ctrl-C was pressed: what fails afterwards fails because of it."""
    return _pressed.is_set()


def answer_in_time() -> None:
    """Make Ctrl-C end this process soon from now on, even where its exception gets lost.

    A process that was started to ignore Ctrl-C, as by `nohup`, goes on doing so.
    """
    if signal.getsignal(signal.SIGINT) is not signal.default_int_handler:
        return

    def press(*_: object) -> NoReturn:
        if _pressed.is_set():  # pressed again: the user does not want to wait
            leave()
        _pressed.set()
        timer = threading.Timer(_GRACE, leave)
        timer.daemon = True
        timer.start()
        raise KeyboardInterrupt

    told = sys.unraisablehook

    def tell(lost: sys.UnraisableHookArgs) -> None:
        # Python drops what is raised while it frees an object or ends an import. The timer ends
        # the process then, and there is nothing to tell.
        if not issubclass(lost.exc_type, KeyboardInterrupt):
            told(lost)

    signal.signal(signal.SIGINT, press)
    sys.unraisablehook = tell


def end() -> None:
    """Mark that the command has its exit status. If Ctrl-C was pressed, it is the reason for the
    status; from now on it comes too late.
    """
    if pressed():
        leave()
    signal.signal(signal.SIGINT, lambda *_: None)


def leave() -> NoReturn:
    """End the process at once: freeing gigabytes or writing into a full pipe takes time."""
    os._exit(STATUS)


@contextlib.contextmanager
def left_to_child() -> Iterator[None]:
    """Leave Ctrl-C to a pager while the pager has the terminal."""
    known = signal.signal(signal.SIGINT, lambda *_: None)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, known)
