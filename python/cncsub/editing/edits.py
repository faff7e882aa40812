"""Edits of programs: what changes, how the files look then, the proof that they do the same."""

from __future__ import annotations

import errno
import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Unpack

from cncsub.byte_edits import edited
from cncsub.checking import Edit
from cncsub.library import Library
from cncsub.lines import diff_of
from cncsub.run_options import FlattenOptions, takes
from cncsub.writing import replace_whole

if TYPE_CHECKING:
    from cncsub.editing.proof import Proof

_LISTED = 5  # of lines or names that are told


@dataclass(frozen=True)
class Edits:
    """What changes in the files of a library.

    `library`: the programs as they are. `edits`: the changes, by file and place; no two of them
    overlap. `notes`: what is told about them, a sentence each, as `O1, line 4: ...`. `files`: the
    files that need another name, old to new. `names`: the programs that are called otherwise
    afterwards, new name to old. `variables`: numbered variables, old to new. `machine`: the kind of
    machine for which the codes were read.
    """

    library: Library
    edits: tuple[Edit, ...]
    notes: tuple[str, ...] = ()
    files: Mapping[str, str] = field(default_factory=dict)
    names: Mapping[str, str] = field(default_factory=dict)
    variables: Mapping[int, int] = field(default_factory=dict)
    machine: str = ""

    @cached_property
    def texts(self) -> dict[str, str]:
        """The texts of the files that change, as they are afterwards."""
        return {
            name: _applied(data.decode("utf-8", "surrogateescape"), self._by_file[name])
            for name, data in self._read.items()
            if name in self._by_file
        }

    @cached_property
    def after(self) -> Library:
        """The library with the edits made."""
        return self.library.with_texts(self.library.control, self.texts, self.files)

    @property
    def empty(self) -> bool:
        """Whether nothing changes."""
        return not self.edits and not self.files

    def diff(self) -> str:
        """Return the changes as a unified diff; empty where nothing changes."""
        return "".join(
            diff_of(self._data(file), self.data_of(file), file, self.files.get(file))
            for file in dict.fromkeys([*self.texts, *self.files])
        )

    def write(self) -> list[str]:
        """Write the files that change, each as a whole, and return their names. Bytes that no edit
        names stay, with their encoding and line ends. A file that needs another name is renamed.

        Nothing is written where one of the files is not as it was read: `NoPlaceError`, a
        `ValueError`. Raises `FileExistsError` where the new name of a file is taken.
        """
        new = {file: self.data_of(file) for file in self._by_file}
        for name in self.files.values():
            if Path(name).exists():
                raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST), name)
        for file, data in new.items():
            replace_whole(file, data)
        for old, name in self.files.items():
            Path(old).replace(name)
        return [*new, *self.files.values()]

    def data_of(self, file: str) -> bytes:
        """Return the bytes of a file as they are afterwards: those of a text that no file holds are
        UTF-8. Raises `NoPlaceError` where the file is not as it was read.
        """
        shown = self._read[file].decode("utf-8", "surrogateescape")
        return edited(self._data(file), self._by_file.get(file, ()), shown)

    def _data(self, file: str) -> bytes:
        """Return the bytes of a file as they are."""
        return Path(file).read_bytes() if Path(file).is_file() else self._read[file]

    @cached_property
    def _read(self) -> dict[str, bytes]:
        return {name: data for name, _, data, outside in self.library.code.sources if not outside}

    @cached_property
    def _by_file(self) -> dict[str, list[Edit]]:
        found: dict[str, list[Edit]] = {}
        for edit in self.edits:
            found.setdefault(edit.file, []).append(edit)
        return found

    @takes(FlattenOptions)
    def prove(self, main: str | int | None = None, **options: Unpack[FlattenOptions]) -> Proof:
        """Compare the programs before and after, as they are written and as they run: see `Proof`.

        `main`: the program to run; without it, every one that no other calls. `options` are those
        of `Library.run`. Raises `EditError` where something differs.
        """
        from cncsub.editing.proof import prove

        return prove(self, main, options)


def known_files(library: Library, files: Iterable[str]) -> frozenset[str]:
    """Return the names of some files of a library. Raises `KeyError` for one that was not read,
    `TypeError` for a text in place of a list.
    """
    if isinstance(files, str):
        raise TypeError(f"files must be a list of names, not the text {files!r}")
    known = frozenset(files)
    for name in known - set(library.files):
        raise KeyError(f"no file {name!r} was read")
    return known


def listed(things: Sequence[object]) -> str:
    """Return the first of some lines or names, such as `4, 7, 9, 12, 20, ...`."""
    return ", ".join(map(str, things[:_LISTED])) + (", ..." if len(things) > _LISTED else "")


def _applied(text: str, edits: Iterable[Edit]) -> str:
    """Return the text of a file with its edits made. Raises `ValueError` for an edit whose old text
    is not where it says.
    """
    by_line: dict[int, list[Edit]] = {}
    for edit in edits:
        by_line.setdefault(edit.line, []).append(edit)
    lines = text.split("\n")
    for number, of_line in by_line.items():
        line = lines[number - 1]
        for edit in sorted(of_line, key=lambda edit: edit.column, reverse=True):
            at = edit.column - 1
            if not edit.old:
                at = len(line)
            elif not line.startswith(edit.old, at):
                raise ValueError(f"{edit.file}:{number}:{edit.column}: there is no {edit.old!r}")
            line = line[:at] + edit.new + line[at + len(edit.old) :]
        lines[number - 1] = line
    return "\n".join(lines)
