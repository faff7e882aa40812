"""Files beside a program that are called as what it calls: a control has them in its memory too."""

from __future__ import annotations

import itertools
import os
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from cncsub import _core

if TYPE_CHECKING:
    from cncsub.library import Library

MOST_FILES = 2_000  # of a folder
MOST_FOLDERS = 20  # in a folder
MOST_ROUNDS = 100  # files that call files that call files


def with_files_beside(path: str, load: Callable[[list[str]], Library]) -> Library:
    """The program of a file, with the files beside it that its calls lead to. A name that several
    files have leads to none of them.
    """
    library = load([path])
    folders = folders_of(path)
    for _ in range(MOST_ROUNDS):
        found: dict[str, None] = {}
        for name in missing_programs(library):
            files = [file for folder in folders for file in files_named(folder, name, library)]
            if len(files) == 1:
                found[files[0]] = None
        if not found:
            break
        library = load([path, *library.files[1:], *found])
    return library


def folders_of(path: str) -> list[Path]:
    """The folder of a file, and of a link that of the file it leads to."""
    folder, real = Path(path).parent, Path(os.path.realpath(path)).parent
    return [folder] if real == Path(os.path.realpath(folder)) else [folder, real]


def _entries(folder: Path) -> list[os.DirEntry[str]]:
    """What lies in a folder, the first of many, by name; nothing where nobody may list it."""
    try:
        with os.scandir(folder) as entries:
            return sorted(itertools.islice(entries, MOST_FILES), key=lambda entry: entry.name)
    except OSError:
        return []


def folders_in(folder: Path) -> list[Path]:
    """The folders in a folder, the first of many, without those that are hidden."""
    try:
        inner = [e.name for e in _entries(folder) if not e.name.startswith(".") and e.is_dir()]
    except OSError:
        return []
    return [folder / name for name in inner[:MOST_FOLDERS]]


def missing_programs(library: Library) -> list[str]:
    """What calls of the memory name and the memory has not."""
    names: dict[str, None] = {}
    for _, _, (_, name, found, external, *_) in _core.all_calls(library._code):
        if name and found is None and not external:
            names[name] = None
    return list(names)


def files_named(folder: Path, name: str, library: Library) -> Iterator[str]:
    """Files of a folder that are called as a program is, and are not in the library."""
    digits = name.lstrip("Oo:%").lstrip("0")
    if not name:
        return
    read = {Path(file).resolve() for file in library.files}
    for entry in _entries(folder):
        stem = Path(entry.name).stem
        same = stem.upper() == name.upper()
        if digits.isdecimal():
            same |= re.fullmatch(rf"[Oo]?0*{digits}", stem) is not None
        if same and entry.is_file() and Path(entry.path).resolve() not in read:
            yield os.path.join(folder, entry.name)  # noqa: PTH118  (as it was named)
