"""The differences between operating systems: no other file names one.

Everything else in the package works with paths, text and numbers, which Python makes alike. The
engine's part of this is `cpp/cncsub/system`.
"""

from __future__ import annotations

import contextlib
import errno
import os
import signal
import stat
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import IO, Any, BinaryIO

WINDOWS = sys.platform == "win32"


def may_be_entered(folder: str | os.PathLike[str]) -> bool:
    """Return whether the entries of a folder can be reached; Windows says so only when it
    is tried.
    """
    return os.access(folder, os.X_OK)


def cores() -> int:
    """The processors that this process may use.

    >>> from cncsub import system
    >>> system.cores() >= 1
    True
    """
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def leads_elsewhere(path: Path) -> bool:
    """Return whether a path stands for another place: a symbolic link, or a junction, which is what
    Windows calls a link to a folder that anybody may make.
    """
    if path.is_symlink():
        return True
    if not WINDOWS:
        return False
    junction = getattr(stat, "IO_REPARSE_TAG_MOUNT_POINT", None)
    tag = getattr(path.stat(follow_symlinks=False), "st_reparse_tag", 0)
    return tag != 0 and tag == junction


def is_hidden(path: Path) -> bool:
    """Return whether a file is hidden: by its name, as everywhere, or by its mark, as on
    Windows.
    """
    if path.name.startswith("."):
        return True
    if not WINDOWS:
        return False
    marks = getattr(path.stat(follow_symlinks=False), "st_file_attributes", 0)
    return bool(marks & stat.FILE_ATTRIBUTE_HIDDEN)


def is_ours(path: Path) -> bool:
    """Return whether a file belongs to the user who runs this, or to the system's; Windows is not
    asked.
    """
    if WINDOWS:
        return True
    return path.stat().st_uid in (os.geteuid(), 0)


def same_names(names: list[str]) -> list[str]:
    """Return what the names of one file in a folder have in common: on Windows O1.NC is o1.nc."""
    return [os.path.normcase(name) for name in names] if WINDOWS else names


def nobody_reads(error: BaseException) -> bool:
    """Return whether writing failed because the reader of the output has enough of it."""
    if isinstance(error, BrokenPipeError):
        return True
    if not (WINDOWS and isinstance(error, OSError)) or error.filename is not None:
        return False
    # The C library of Windows reports it with errors that are meant for something else.
    return error.errno in (errno.EINVAL, errno.EPIPE)


# The errors of a full disk, quota or table of the system, or of a failing device.
_LIMITS = {"ENOSPC", "EFBIG", "EDQUOT", "EIO", "EMFILE", "ENFILE", "ENOMEM", "ENOBUFS", "EAGAIN"}
_AT_LIMIT = {getattr(errno, name) for name in _LIMITS if hasattr(errno, name)}


def at_its_limit(error: BaseException) -> bool:
    """Return whether the system could not do what was rightly asked: no room, memory or files."""
    if isinstance(error, MemoryError):
        return True
    return isinstance(error, OSError) and error.errno in _AT_LIMIT


def say_nothing_more() -> None:
    """Discard what is still to be written to the standard output."""
    with contextlib.suppress(OSError, ValueError):  # it is no file of the system
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, sys.stdout.fileno())
        os.close(nowhere)


def takes_any_text(file: IO[Any]) -> bool:
    """Return whether a stream takes every character: its encoding is one of Unicode.

    >>> import io
    >>> from cncsub import system
    >>> system.takes_any_text(io.TextIOWrapper(io.BytesIO(), encoding="cp1252"))
    False
    """
    encoding = getattr(file, "encoding", None) or "utf-8"
    return encoding.lower().replace("_", "-").startswith(("utf", "u8", "cp65001"))


def write_what_can_be() -> None:
    """Write characters that the terminal or the pipe does not hold as escapes, where Python would
    refuse the whole line: a Chinese name in a window of Western Europe. Where the standard output
    or the error stream is closed, discard what is written there.
    """
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: SIM115, PTH123
    for file in (sys.stdout, sys.stderr):
        if not takes_any_text(file) and hasattr(file, "reconfigure"):
            file.reconfigure(errors="backslashreplace")


@contextlib.contextmanager
def started_without_main() -> Iterator[None]:
    """Keep processes that are spawned meanwhile from running the main module again. It is a
    launcher of our command, and not every launcher asks whether it is the main module.
    """
    known = sys.modules["__main__"]
    sys.modules["__main__"] = ModuleType("__main__")
    try:
        yield
    finally:
        sys.modules["__main__"] = known


@contextlib.contextmanager
def kept_from_children() -> Iterator[None]:
    """Keep Ctrl-C, which a terminal sends to all processes at once, from those that are started
    meanwhile: whoever started them ends them. Windows cannot hold it back.
    """
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    known = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, known)


@contextlib.contextmanager
def protocol_output() -> Iterator[BinaryIO]:
    """Give the standard output to a protocol alone: whatever else is printed is no message of it,
    and goes to the error stream. A client that is gone reads no more.
    """
    sys.stdout.flush()
    output = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())
    with contextlib.suppress(BrokenPipeError), output:
        yield output
