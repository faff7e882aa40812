"""Files that are written: an error names the file, and what was there before survives it."""

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
        # Line ends are written as given: a file is the same on every system.
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

    A link stays, and so do the permissions; a file of several hard links becomes one of its own. A
    target that is no regular file, such as /dev/null or a pipe, is written to and stays as it is.
    """
    real = Path(os.path.realpath(path))
    if real.exists() and not real.is_file():
        write_whole(path, data)
        return
    try:
        put_whole(real, data, real.with_name(f".{real.name}.{os.getpid()}.part"), like=real)
    except OSError as error:
        error.filename = os.fspath(path)
        raise


def put_whole(target: Path, data: Any, made: Path, *, like: Path | None = None) -> None:
    """Write bytes to `made` beside a file, and put it in the file's place once they are on the
    disk.

    `like`: the file whose permissions it gets.
    """
    try:
        with opened(made, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        if like is not None:
            shutil.copymode(like, made)
        made.replace(target)
    except BaseException:
        with contextlib.suppress(OSError):
            made.unlink()
        raise
