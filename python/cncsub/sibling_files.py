"""Files beside a program with the names of what it calls: a control has them in its memory too."""

from __future__ import annotations

import itertools
import os
import re
from collections.abc import Callable, Collection, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from cncsub import _core
from cncsub.files import refused_entry
from cncsub.search_path import searched

if TYPE_CHECKING:
    from cncsub._core import Control
    from cncsub.library import Library

MOST_FILES = 2_000  # of a folder
MOST_FOLDERS = 20  # in a folder
MOST_LEVELS = 4  # of folders above a file: its own, that of workpieces, that of the memory
MOST_ROUNDS = 100  # files that call files that call files


def with_files_beside(path: str, load: Callable[[list[str], list[str]], Library]) -> Library:
    """Load the program of a file, with the files beside it that its calls lead to, and those in
    the folders of the control's search path that lie near it. A name that several files of a folder
    have leads to none of them.

    `load` takes the file and those beside it. They are files of a folder that was not named: what
    is left out of a folder, such as a link that leads out of it, is left out here.
    """
    siblings: dict[str, None] = {}
    library = load([path], [])
    for _ in range(MOST_ROUNDS):
        found: dict[str, None] = {}
        places = [folders_of(path), *([f] for f in searched_folders(path, library.control))]
        for name in missing_programs(library):
            files: list[str] = []
            for folders in places:
                files = files or [
                    file
                    for folder in folders
                    for file, fault in files_named(folder, name, library)
                    if fault is None
                ]
            if len(files) == 1 and files[0] not in siblings:
                found[files[0]] = None
        if not found:
            break
        siblings |= found
        library = load([path], list(siblings))
    return library


def folders_of(path: str) -> list[Path]:
    """Return the folder of a file, and for a link also the folder of the file it leads to."""
    folder, real = Path(path).parent, Path(os.path.realpath(path)).parent
    return [folder] if real == Path(os.path.realpath(folder)) else [folder, real]


def searched_folders(path: str, control: Control) -> list[Path]:
    """Return the folders of the control's search path that lie beside the folder of a file, or
    beside one that it lies in, in the order in which the control searches them.
    """
    around = list(Path(os.path.abspath(path)).parents)[:MOST_LEVELS]  # noqa: PTH100
    wanted = [
        {folder, "_N_" + folder.replace(".", "_"), on_disk.upper()}
        for folder, on_disk in searched(control)
    ]
    every: set[str] = set().union(*wanted)
    beside = [inner for folder in around for inner in folders_in(folder, every)] if every else []
    found = [inner for names in wanted for inner in beside if inner.name.upper() in names]
    return found if Path(path).is_absolute() else [Path(os.path.relpath(inner)) for inner in found]


def _entry_names(folder: Path, names: Collection[str] = ()) -> list[str]:
    """Return the names of at most `MOST_FILES` entries of a folder, in order; of these names, in
    capitals, where there are any. Return nothing where nobody may list it.
    """
    try:
        with os.scandir(folder) as entries:
            found = (entry.name for entry in entries if not names or entry.name.upper() in names)
            return sorted(itertools.islice(found, MOST_FILES))
    except OSError:
        return []


def folders_in(folder: Path, names: Collection[str] = ()) -> list[Path]:
    """Return at most `MOST_FOLDERS` folders in a folder, without those that are left alone; of
    these names, in capitals, where there are any.
    """
    root = Path(os.path.realpath(folder))
    inner = (folder / name for name in _entry_names(folder, names))
    folders = (path for path in inner if refused_entry(path, root) is None and path.is_dir())
    return list(itertools.islice(folders, MOST_FOLDERS))


def missing_programs(library: Library) -> list[str]:
    """Return the programs that calls of the memory name and the memory has not."""
    names: dict[str, None] = {}

    def take(_program: int, _n: int | None, _line: int, call: tuple[Any, ...]) -> None:
        _, name, found, external, *_ = call
        if name and found is None and not external:
            names[name] = None

    _core.each_call(library.code, take)  # a list of a million calls would take 360 MB
    return list(names)


def files_named(folder: Path, name: str, library: Library) -> Iterator[tuple[str, str | None]]:
    """Yield the files of a folder that have the name of a program and are not in the library, each
    with the reason for which it is left alone, if there is one.
    """
    digits = name.lstrip("Oo:%").lstrip("0")
    if not name:
        return
    root = Path(os.path.realpath(folder))
    read = {os.path.realpath(file) for file in library.files}
    for entry in _entry_names(folder):
        stem = Path(entry).stem
        same = stem.upper() == name.upper()
        if digits.isdecimal():
            same |= re.fullmatch(rf"[Oo]?0*{digits}", stem) is not None
        path = os.path.join(folder, entry)  # noqa: PTH118  (as it was named)
        if not same or os.path.isdir(path) or os.path.realpath(path) in read:  # noqa: PTH112
            continue
        yield path, refused_entry(Path(path), root)
