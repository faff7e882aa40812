"""Ctrl-C: every command ends within a second of it, and says so by its exit status."""

from __future__ import annotations

import contextlib
import os
import signal
import threading
from collections.abc import Iterator
from typing import TYPE_CHECKING, NoReturn

if TYPE_CHECKING:
    from cncsub.run import Run


STATUS = 130  # what a shell says of a command that Ctrl-C ended
_GRACE = 0.8  # seconds until what holds on to the process is left behind


_pressed = threading.Event()


def uninterrupted(run: Run) -> Run:
    """The run; `KeyboardInterrupt` where Ctrl-C broke it off, for work that needs a whole one."""
    if run.stop == "interrupted":
        raise KeyboardInterrupt
    return run


def pressed() -> bool:
    """Whether Ctrl-C was pressed: what fails afterwards fails because of it."""
    return _pressed.is_set()


def answer_in_time() -> None:
    """From now on Ctrl-C ends this process soon, even where its exception gets lost.

    A process that was started to ignore it, as by `nohup`, goes on doing so.
    """
    if signal.getsignal(signal.SIGINT) is not signal.default_int_handler:
        return

    def press(*_: object) -> NoReturn:
        if _pressed.is_set():  # pressed again: whoever does so does not want to wait
            leave()
        _pressed.set()
        timer = threading.Timer(_GRACE, leave)
        timer.daemon = True
        timer.start()
        raise KeyboardInterrupt

    signal.signal(signal.SIGINT, press)


def end() -> None:
    """The command has its exit status: Ctrl-C, if it was pressed, is the reason for it, and comes
    too late from now on.
    """
    if pressed():
        leave()
    signal.signal(signal.SIGINT, lambda *_: None)


def leave() -> NoReturn:
    """End the process at once: to free gigabytes or to write into a full pipe takes time."""
    os._exit(STATUS)


@contextlib.contextmanager
def left_to_child() -> Iterator[None]:
    """While a pager has the terminal Ctrl-C is its business."""
    known = signal.signal(signal.SIGINT, lambda *_: None)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, known)
