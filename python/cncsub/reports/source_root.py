"""Files as a repository names them, whatever way led to them: for tools that read findings."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path


class SourceRoot:
    """The folder from which other tools name the files: the top of their repository.

    Where there is no repository, it is the current folder if that holds them all, then the folder
    of the project, then the folder that they have in common.
    """

    def __init__(self, files: Iterable[str]) -> None:
        paths = [path for path in map(_absolute, files) if path is not None]
        self.folder = _root(paths)

    def relative(self, file: str) -> str | None:
        """Return a file as it is named from the root, with `/`; `None` where it is outside, or no
        file.
        """
        path = _absolute(file)
        if path is None or self.folder is None or not path.is_relative_to(self.folder):
            return None
        return path.relative_to(self.folder).as_posix()


def _absolute(file: str) -> Path | None:
    """Return where a file is. A name such as `<text>` is that of none."""
    path = Path(os.path.abspath(file))  # noqa: PTH100  # takes `..` away
    return path if os.path.lexists(path) else None


def _root(paths: list[Path]) -> Path | None:
    if not paths:
        return None
    repository = _top(paths[0], ".git")
    if repository is not None:
        return repository
    here = Path.cwd()
    if all(path.is_relative_to(here) for path in paths):
        return here
    common = Path(os.path.commonpath([path.parent for path in paths]))
    return _top(paths[0], "cncsub.toml") or common


def _top(path: Path, mark: str) -> Path | None:
    return next((folder for folder in path.parents if (folder / mark).exists()), None)
