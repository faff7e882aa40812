"""Files that are written: what goes wrong names the file, and what was there before survives it."""

from __future__ import annotations

import contextlib
import os
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import IO, Any


@contextlib.contextmanager
def opened(path: str | os.PathLike[str], mode: str) -> Iterator[IO[Any]]:
    """Open a file to write, `"w"` as UTF-8 or `"wb"`; an error while writing names it too."""
    try:
        # Line ends are those that are written: a file is the same on every system.
        text: dict[str, Any] = (
            {}
            if "b" in mode
            else {
                "encoding": "utf-8",
                "errors": "replace",
                "newline": "",
            }
        )
        with Path(path).open(mode, **text) as file:
            yield file
    except OSError as error:
        if error.filename is None and error.errno is not None:
            error.filename = os.fspath(path)
        raise


def write_whole(path: str | os.PathLike[str], data: str | bytes) -> None:
    """Write a text as UTF-8, or bytes."""
    with opened(path, "wb") as file:
        file.write(data.encode(errors="replace") if isinstance(data, str) else data)


def replace_whole(path: str | os.PathLike[str], data: bytes) -> None:
    """Write over a file: it holds the new bytes or the old ones, whatever happens meanwhile.

    A link stays, and so do the permissions; a file of several hard links becomes one of its own.
    What is no regular file, such as /dev/null or a pipe, is written to and stays what it is.
    """
    real = Path(os.path.realpath(path))
    if real.exists() and not real.is_file():
        write_whole(path, data)
        return
    made = real.with_name(f".{real.name}.{os.getpid()}.part")
    try:
        with opened(made, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        shutil.copymode(real, made)
        made.replace(real)
    except BaseException as error:
        with contextlib.suppress(OSError):
            made.unlink()
        if isinstance(error, OSError):
            error.filename = os.fspath(path)
        raise
