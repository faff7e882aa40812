"""The memories behind the documents of an editor: which files, which control, in which version."""

from __future__ import annotations

import os
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import NamedTuple

from cncsub import _core
from cncsub._core import Control, Text, Texts
from cncsub.cli.project import Project, project_beside
from cncsub.editor.documents import Document, engine_text
from cncsub.editor.last_run import options_of
from cncsub.editor.snapshot import Snapshot
from cncsub.files import Piece, Reading, StrPath, clean, read_paths, walk
from cncsub.library import Library
from cncsub.sibling_files import with_files_beside

MOST_FILES = 5_000  # of a folder that no project names
MOST_BYTES = 64 << 20
MARK = "cncsub: control="  # what a comment in the head of a file says
_HEAD_LINES = 20

# A file as the engine takes it: its name, its stem, its text, whether it is on the device.
Source = tuple[str, str, bytes, bool]


@dataclass(frozen=True)
class Settings:
    """The wishes of the client: the control where neither the file nor a project names one; how
    programs are run in the background, and how much.
    """

    control: str | None = None
    runs: bool = True
    max_blocks: int = 200_000
    max_seconds: float = 0.5


class _Files(NamedTuple):
    """The files of a folder as they stand on the disk, and what was left out."""

    sources: list[Source]
    skipped: list[tuple[str, str]]


class _Key(NamedTuple):
    """What makes documents share a memory: the paths that are read, and the control."""

    paths: tuple[str, ...]
    control: Control
    project: Path | None


@dataclass
class Memories:
    """The open documents by path, and the memory of each of them.

    Any thread may ask: one that asks for a memory which another is reading waits for it.
    """

    units: str = "utf-16"
    folders: tuple[str, ...] = ()
    settings: Settings = field(default_factory=Settings)
    tell: Callable[[str], None] = lambda message: None
    documents: dict[str, Document] = field(default_factory=dict)
    _snapshots: dict[_Key, Snapshot] = field(default_factory=dict)
    _disk: dict[tuple[str, ...], _Files] = field(default_factory=dict)
    _projects: dict[Path, Project] = field(default_factory=dict)
    _small: dict[str, bool] = field(default_factory=dict)
    _told: set[str] = field(default_factory=set)
    _lock: threading.RLock = field(default_factory=threading.RLock)

    def put(self, path: str, document: Document) -> None:
        """Show a document, or its next version."""
        with self._lock:
            self.documents[path] = document
            self._snapshots.clear()

    def close(self, path: str) -> None:
        """Forget what an editor showed: the file on the disk counts again."""
        with self._lock:
            self.documents.pop(path, None)
            self.read_disk_again()

    def read_disk_again(self) -> None:
        """Read files and projects anew when they are next asked for."""
        with self._lock:
            self._disk.clear()
            self._projects.clear()
            self._small.clear()
            self._snapshots.clear()
            self._told.clear()

    def snapshot(self, path: str) -> Snapshot | None:
        """Return the memory of a document as it is now; `None` where no control is named for it,
        which is told once.
        """
        with self._lock:
            document = self.documents.get(path)
            if document is None or is_project(path):
                return None
            try:
                project = self._project(path)
                control = self._control(document, project)
                if control is None:
                    return None
                key = _Key(self._paths(path, project), control, project.file)
                found = self._snapshots.get(key)
                if found is None:
                    found = self._snapshots[key] = self._made(key, project)
            except (OSError, ValueError) as error:
                self._say(str(error))
                return None
            return found

    def _project(self, path: str) -> Project:
        folder = Path(path).parent
        found = self._projects.get(folder)
        if found is None:
            found = self._projects[folder] = project_beside(folder)
        return found

    def _say(self, message: str) -> None:
        if message not in self._told:
            self._told.add(message)
            self.tell(message)

    def _control(self, document: Document, project: Project) -> Control | None:
        """Return the control of a document: by a comment in its head, its project, the client."""
        name = named_in(document) or project.control or self.settings.control
        if not name:
            self._say(
                "cncsub: no control is named for this file. Name it in a comment,"
                f" ({MARK}fanuc-0i-f), in cncsub.toml beside the programs,"
                ' control = "fanuc-0i-f", or in the settings of the editor;'
                " `cncsub controls` lists all"
            )
            return None
        return project.configured(project.control_named(name), name)

    def _paths(self, path: str, project: Project) -> tuple[str, ...]:
        """Return the files and folders of a document's memory: those of its project, else the
        folder that the editor has opened, where it is not too large, else the file, with those
        beside it that its calls lead to.
        """
        if project.file is not None:
            paths = project.folders or (str(project.file.parent),)
            inside = any(Path(path).is_relative_to(each) for each in paths)
            return paths if inside else (*paths, path)
        for folder in self.folders:
            if Path(path).is_relative_to(folder):
                return (folder,) if self._is_small(folder) else (path,)
        return (path,)

    def _is_small(self, folder: str) -> bool:
        if folder not in self._small:
            self._small[folder] = self._counted(folder)
        return self._small[folder]

    def _counted(self, folder: str) -> bool:
        count = size = 0
        for before, names, _ in walk(Path(folder), Reading()):
            count += len(names)
            size += sum(_size(before + name) for name in names)
            if count > MOST_FILES or size > MOST_BYTES:
                self._say(
                    f"cncsub: {folder} has more than {MOST_FILES:,} files or"
                    f" {MOST_BYTES >> 20} MB; each file is read with those"
                    " that it calls. A cncsub.toml with"
                    ' folders = ["programs"] names the programs of a memory'
                )
                return False
        return True

    def _made(self, key: _Key, project: Project) -> Snapshot:
        files = self._files(key, project)
        sources = [self._shown(source) for source in files.sources]
        known = {name for name, *_ in sources}
        shown = {path for path in self.documents if self._belongs(path, key)}
        sources += [
            (path, clean(Path(path).stem), engine_text(self.documents[path].text), False)
            for path in self.documents
            if path in shown - known
        ]
        code = _compiled(key.control, sources, device=project.external is not None)
        try:
            options_of(project)
        except (OSError, ValueError) as error:
            self._say(f"cncsub: {error}; programs run without it")
            project = replace(project, places={})
        names = [name for name, _, _, outside in sources if not outside]
        documents = {path: self.documents[path] for path in self.documents if path in shown | known}
        closed = {name: text for name, _, text, _ in files.sources if name not in documents}
        return Snapshot(
            Library(code, names, files.skipped),
            documents,
            closed,
            project,
            self.units,
            self.settings.max_blocks if self.settings.runs else 0,
            self.settings.max_seconds,
        )

    def _files(self, key: _Key, project: Project) -> _Files:
        """Return the files on the disk. What a file alone calls may change with each key."""
        (first, *more), device = key.paths, project.external
        if not more and os.path.isfile(first) and project.file is None:  # noqa: PTH113
            return self._beside(first, key.control)
        if key.paths not in self._disk:
            self._disk[key.paths] = _read(key.paths, device)
        return self._disk[key.paths]

    def _beside(self, path: str, control: Control) -> _Files:
        """Return a file with the files of its folder that its calls lead to, as it is shown."""
        read: list[_Files] = []

        def load(named: list[str], siblings: list[str]) -> Library:
            read.append(_read(tuple(named), None, siblings))
            sources = [self._shown(source) for source in read[-1].sources]
            code = _compiled(control, sources, device=False)
            return Library(code, [name for name, *_ in sources])

        with_files_beside(path, load)
        return read[-1]

    def _belongs(self, path: str, key: _Key) -> bool:
        """Return whether an open document is of a memory, though no file of it is there yet."""
        if is_project(path):
            return False
        if path in key.paths:
            return True
        try:
            project = self._project(path)
            control = self._control(self.documents[path], project)
        except ValueError:
            return False
        return project.file == key.project and control == key.control and self._lies_in(path, key)

    def _lies_in(self, path: str, key: _Key) -> bool:
        return any(Path(path).is_relative_to(folder) for folder in key.paths)

    def _shown(self, source: Source) -> Source:
        """Return a file with the text that an editor shows in place of the one on the disk."""
        document = self.documents.get(source[0])
        if document is None:
            return source
        name, stem, _, outside = source
        return name, stem, engine_text(document.text), outside


def _compiled(control: Control, sources: Sequence[Source], *, device: bool) -> _core.Code:
    rows = [(name, stem, [text], outside) for name, stem, text, outside in sources]
    return _core.compile(control, rows, device)


def is_project(path: str) -> bool:
    """Return whether a document is the settings of a project, and no program."""
    return Path(path).name == "cncsub.toml"


def named_in(document: Document) -> str | None:
    """Return the control that a comment in the first lines names, as `(cncsub: control=0i-f)`. No
    control has read the text yet: the mark is sought as the mode line of an editor is.
    """
    for line in document.lines[:_HEAD_LINES]:
        _, mark, after = line.partition(MARK)
        if mark:
            name = after.split(")")[0].split(";")[0].strip(" \t\r\n\"'")
            return name or None
    return None


def _size(path: str) -> int:
    try:
        return os.stat(path).st_size  # noqa: PTH116  (many files)
    except OSError:
        return 0


def _read(paths: tuple[str, ...], external: StrPath | None, siblings: Sequence[str] = ()) -> _Files:
    """Read the files of a memory and of its external device, each line with one end."""
    there = [path for path in paths if os.path.exists(path)]  # noqa: PTH110
    try:
        reading = read_paths(there, siblings=siblings, without=external)
    except ValueError:
        reading = Reading()  # a folder without programs: an editor may be about to write one
    outside = Reading() if external is None else read_paths([external])
    sources = [*_sources(reading, outside=False), *_sources(outside, outside=True)]
    return _Files(sources, [*reading.skipped, *outside.skipped])


def _sources(reading: Reading, *, outside: bool) -> list[Source]:
    found: list[Source] = []
    for part in reading.files:
        if isinstance(part, Texts):
            rows = (part.file(index) for index in range(len(part.names)))
            found += [(name, stem, _one_end(text), outside) for name, stem, text in rows]
        else:
            text = b"".join(map(_bytes, part.pieces))
            found.append((part.name, part.stem, _one_end(text), outside))
    return found


def _bytes(piece: Piece) -> bytes:
    if isinstance(piece, Text):
        return piece.part(0, len(piece))
    return piece.encode() if isinstance(piece, str) else bytes(piece)


def _one_end(text: bytes) -> bytes:
    return text.replace(b"\r\n", b"\n").replace(b"\r", b"\n") if b"\r" in text else text
