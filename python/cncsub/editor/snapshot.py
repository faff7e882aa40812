"""One version of a memory, with its texts: what every request of an editor is answered from."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from threading import Lock

from lsprotocol.types import Location, Range
from pygls.uris import from_fs_path

from cncsub import _core
from cncsub._core import Control
from cncsub.checking import Finding, check, chosen_rules
from cncsub.cli.project import Project
from cncsub.editor.documents import Document
from cncsub.editor.last_run import LastRun
from cncsub.library import Library
from cncsub.program import Block, Program, Token, named_like
from cncsub.reports.code_facts import own_machine
from cncsub.reports.findings import with_severity
from cncsub.setup import Setup, machine_of

MANY_LINES = 20_000  # of a document that is answered for in parts


@dataclass(frozen=True)
class Snapshot:
    """A memory that does not change. `documents`: what an editor shows of it, by path; `closed`:
    the texts of the other files. `max_blocks`, `max_seconds`: of a run in the background.
    """

    library: Library
    documents: Mapping[str, Document]
    closed: Mapping[str, bytes]
    project: Project
    units: str
    max_blocks: int
    max_seconds: float
    _checking: Lock = field(default_factory=Lock, repr=False, compare=False)
    _running: Lock = field(default_factory=Lock, repr=False, compare=False)

    @property
    def control(self) -> Control:
        """The control of the memory."""
        return self.library.control

    @property
    def code(self) -> _core.Code:
        """The compiled programs."""
        return self.library.code

    @cached_property
    def _texts(self) -> dict[str, Document]:
        return dict(self.documents)

    def document(self, path: str) -> Document:
        """Return the text of any file of the memory."""
        found = self._texts.get(path)
        if found is None:
            text = self.closed.get(path, b"").decode(errors="replace")
            found = self._texts[path] = Document.of(text, self.units)
        return found

    # ---- programs and blocks ----

    @cached_property
    def _of_files(self) -> dict[str, list[tuple[int, bool, int]]]:
        """The programs of each file: line, whether it is a part of another one, place."""
        found: dict[str, list[tuple[int, bool, int]]] = {}
        for place in range(len(self.code)):
            data = self.code.program(place)
            if not data.system:
                found.setdefault(data.file, []).append((data.line, data.inside, place))
        for rows in found.values():
            rows.sort()
        return found

    def program(self, place: int) -> Program:
        """Return a program by its place in the memory."""
        return Program(self.code.program(place), place)

    def programs_of(self, path: str, *, inside: bool = False) -> list[Program]:
        """Return the programs of a file in the order of their lines; with `inside` also those that
        are a part of another one.
        """
        rows = self._of_files.get(path, [])
        return [self.program(place) for _, within, place in rows if inside or not within]

    def program_at(self, path: str, line: int) -> Program | None:
        """Return the program in which a line, from 0, stands."""
        rows = [row for row in self._of_files.get(path, []) if not row[1]]
        at = bisect_right(rows, line + 1, key=lambda row: row[0]) - 1
        return self.program(rows[max(at, 0)][2]) if rows else None

    def blocks_between(self, path: str, first: int, last: int) -> Iterator[Block]:
        """Yield the blocks of some lines, from 0, both included."""
        for program in self.programs_of(path):
            yield from _blocks_of(program, first, last)

    def blocks_on(self, program: Program, line: int) -> Iterator[Block]:
        """Yield the blocks of a program on a line, from 0."""
        return _blocks_of(program, line, line)

    def block_at(self, path: str, line: int, character: int) -> Block | None:
        """Return the block of a place, both from 0: of several on a line the last that begins
        before it.
        """
        found = None
        for block in self.blocks_between(path, line, line):
            if found is None or column_of(block) <= character + 1:
                found = block
        return found

    # ---- places ----

    def range(self, path: str, line: int, column: int, width: int) -> Range:
        """Return the range of some characters; line and column are those of the engine, from 1."""
        return self.document(path).range(max(0, line - 1), max(0, column - 1), width)

    def location(self, path: str, line: int, column: int, width: int) -> Location:
        """Return where some characters stand, for the client."""
        return Location(uri_of(path), self.range(path, line, column, width))

    def head_of(self, program: Program) -> Location:
        """Return where a program begins."""
        line = self.document(program.file).line(program.line - 1)
        return self.location(program.file, program.line, 1, len(line))

    # ---- what the engine finds ----

    @cached_property
    def setup(self) -> Setup | None:
        """The setup that the project names."""
        return None if self.project.setup is None else Setup.from_toml(self.project.setup)

    @property
    def machine(self) -> str:
        """The kind of machine that the setup gives; empty for the control's own."""
        return machine_of(self.setup)

    @cached_property
    def kind(self) -> str:
        """The kind of machine: that of the setup, else the control's own."""
        return self.machine or own_machine(self.control)

    @cached_property
    def _found(self) -> dict[str, list[Finding]]:
        return {}

    def findings(self, path: str) -> list[Finding]:
        """Return what `check` finds in a file; the first program of the file is one that is run."""
        with self._checking:  # the second who asks waits for what the first one finds
            found = self._found.get(path)
            if found is None:
                found = self._found[path] = self._checked(path)
            return found

    def _checked(self, path: str) -> list[Finding]:
        programs = self.programs_of(path)
        main = programs[0].index if programs else -1
        rules = chosen_rules(None) - self.project.ignore
        entries = named_like(self.code, self.project.entry)
        found = check(self.code, main, rules, self.machine, entries)
        own = [finding for finding in found if finding.file == path]
        return with_severity(own, dict(self.project.severity))

    @cached_property
    def calls(self) -> list[tuple[int, int, _core._CallRow]]:
        """Every call of the memory: the place of the program, of the block in it, the call."""
        return _core.all_calls(self.code)

    @cached_property
    def flows(self) -> _core.Flows:
        """The flow graphs of all programs."""
        return _core.flows(self.code)

    @cached_property
    def _runs(self) -> dict[int, LastRun]:
        return {}

    def last_run(self, path: str, *, waits: bool = False) -> LastRun | None:
        """Return the run of the program that leads to a file. It is made when it is first asked
        for; that of a large document only for whoever `waits` for it.
        """
        programs = self.programs_of(path)
        if not programs or not self.max_blocks:
            return None
        main = self._root(programs[0].index)
        if main not in self._runs and not waits and self.is_long(path):
            return None
        with self._running:
            if main not in self._runs:
                limits = self.max_blocks, self.max_seconds
                self._runs[main] = LastRun.of(self.library, self.project, main, *limits)
            return self._runs[main]

    def awaits_run(self, path: str) -> bool:
        """Return whether whoever asks for the run of a document has to wait for it."""
        programs = self.programs_of(path)
        if not programs or not self.max_blocks or self.is_long(path):
            return False
        return self._root(programs[0].index) not in self._runs

    def is_long(self, path: str) -> bool:
        """Return whether a document is answered for in parts."""
        return len(self.document(path).lines) > MANY_LINES

    def _root(self, program: int) -> int:
        """Return the first program that calls the one that calls ... a program."""
        callers: dict[int, int] = {}
        for caller, _, row in self.calls:
            if row[2] is not None and row[2] != caller:
                callers.setdefault(row[2], caller)
        seen = {program}
        while (above := callers.get(program)) is not None and above not in seen:
            seen.add(above)
            program = above
        return program


def _blocks_of(program: Program, first: int, last: int) -> Iterator[Block]:
    blocks = program.blocks
    at = _first_at(program.data, first + 1)
    while at < len(blocks) and blocks[at].line <= last + 1:
        yield blocks[at]
        at += 1


def uri_of(path: str) -> str:
    """Return how the client names a file."""
    return from_fs_path(path) or path


def column_of(block: Block) -> int:
    """Return the column in which a block begins, from 1."""
    return block.program.data.column(place_of(block))


def place_of(block: Block) -> int:
    """Return the place of a block in its program."""
    return block._index  # noqa: SLF001


def token_at(block: Block, character: int) -> Token | None:
    """Return the token of a block in which a character of its line, from 0, stands. The end of a
    word counts to it, where no other word begins there.
    """
    found = None
    for token in block.tokens:
        if token.column <= character + 1 < token.end and token.kind != "blank":
            return token
        if token.end == character + 1 and token.kind == "word":
            found = token
    return found


def comment_words(text: str) -> str:
    """Return what a comment says, without the signs around it."""
    return text.strip().strip("();").strip()


def _first_at(data: _core.ProgramData, line: int) -> int:
    """Return the place of the first block on a line, from 1, or after it."""
    low, high = 0, data.blocks
    while low < high:
        middle = (low + high) // 2
        if data.block(middle)[1] < line:
            low = middle + 1
        else:
            high = middle
    return low
