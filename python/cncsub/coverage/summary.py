"""Coverage: which blocks, branches, calls and arguments of the programs runs went through."""

from __future__ import annotations

import bisect
import functools
import itertools
import operator
import threading
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, Generic, TypeVar, overload

from cncsub import _core
from cncsub.collectors import told
from cncsub.coverage.block_counts import (
    LETTER_OF,
    Counted,
    Raw,
    has_no_file,
    origin_of,
    percent_text,
    programs_of,
    raw_of,
)
from cncsub.pickling import NotPicklable
from cncsub.writing import write_whole

Row = TypeVar("Row")


@dataclass(frozen=True, slots=True)
class BlockRow:
    """A block, and how often it was executed."""

    program: str
    n: int | None
    line: int
    text: str
    count: int
    covered: bool


@dataclass(frozen=True, slots=True)
class BranchRow:
    """One outcome of a block that decides. `kind`: `if-goto` (UNTIL too), `if-then`, `if`,
    `elseif`, `h-jump`, `input-jump`, `do-while`, `for` (ENDFOR: whether the loop goes on), `case`
    (CASE, several IF GOTO in a block: whether one of them jumps), `while`, `repeat`. `outcome`:
    `taken` and `not taken` (whether the condition held); of the loops `while` and `repeat` the
    number of passes of an entry: `none`, `once`, `many`. `block-skip`, of a block with a slash
    before it: `skipped` and `not skipped`; a slash inside a block is no branch.
    """

    program: str
    n: int | None
    line: int
    kind: str
    outcome: str
    count: int
    covered: bool


@dataclass(frozen=True, slots=True)
class CallRow:
    """A call that a block makes: of a program that ran, or as it is written where none did."""

    program: str
    n: int | None
    line: int
    kind: str
    called: str
    count: int
    covered: bool


@dataclass(frozen=True, slots=True)
class ArgumentRow:
    """An argument that a program reads as a local or was given; `letter` is `None` where the
    variable has none. `count`: calls that gave it.
    """

    program: str
    letter: str | None
    variable: int
    count: int
    covered: bool


class Blocks(Sequence[BlockRow]):
    """The blocks in the order of the programs. A row is made when it is asked for: a part program
    may have millions.
    """

    def __init__(self, programs: tuple[Counted, ...]) -> None:
        self._programs = programs
        self._ends = list(itertools.accumulate(len(program.blocks) for program in programs))

    def __len__(self) -> int:
        return self._ends[-1] if self._ends else 0

    @overload
    def __getitem__(self, index: int) -> BlockRow: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[BlockRow, ...]: ...
    def __getitem__(self, index: int | slice) -> BlockRow | tuple[BlockRow, ...]:
        if isinstance(index, slice):
            return tuple(self[place] for place in range(len(self))[index])
        place = range(len(self))[index]
        program = bisect.bisect_right(self._ends, place)
        first = self._ends[program - 1] if program else 0
        return _block_row(self._programs[program], place - first)

    def __iter__(self) -> Iterator[BlockRow]:
        for p in self._programs:
            counts = map(operator.add, p.held, p.failed)
            of = p.blocks
            for n, line, text, count in zip(of.n, of.line, of.text, counts, strict=True):
                yield BlockRow(p.name, n, line, text, count, count > 0)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Blocks | tuple):
            return NotImplemented
        return len(self) == len(other) and all(map(operator.eq, self, other))

    def __hash__(self) -> int:
        return hash(tuple(self))

    @property
    def covered(self) -> int:
        """How many blocks were executed."""
        return sum(program.blocks_covered() for program in self._programs)

    def to_pandas(self) -> Any:
        """Return the rows as a pandas `DataFrame`."""
        import pandas as pd

        return pd.DataFrame([asdict(row) for row in self])

    def _repr_html_(self) -> str:
        from cncsub.notebook_values import rows_html

        return rows_html(repr(self)[1:-1], self, len(self))

    def __repr__(self) -> str:
        return f"<Table: {self.covered} of {len(self)} covered>"


def _block_row(program: Counted, place: int) -> BlockRow:
    block, count = program.blocks[place], program.count(place)
    return BlockRow(program.name, block.n, block.line, block.text, count, count > 0)


class Table(tuple[Row, ...], Generic[Row]):
    """Rows in the order of the programs: a tuple of them with `to_pandas`."""

    def to_pandas(self) -> Any:
        """Return the rows as a pandas `DataFrame`."""
        import pandas as pd

        return pd.DataFrame([asdict(row) for row in self])  # type: ignore[call-overload]

    @property
    def covered(self) -> int:
        """How many rows are covered."""
        return sum(row.covered for row in self)  # type: ignore[attr-defined]

    def _repr_html_(self) -> str:
        from cncsub.notebook_values import rows_html

        return rows_html(repr(self)[1:-1], self, len(self))

    def __repr__(self) -> str:
        return f"<Table: {self.covered} of {len(self)} covered>"


class Coverage(NotPicklable):
    """The blocks, branches, calls and arguments that runs went through; `run.coverage()` makes it,
    and `+` and `sum` add several up.

    Blocks are those that can be executed: no comments, empty lines and heads of programs. A block
    is covered where it was executed, once at least. A block that raised an alarm is covered only
    where the control did some of it before (words before a call, #3000, which is meant to alarm); a
    block that a switch skipped, and one that cannot be read, is not. Branches: every condition and
    every block-skip slash both ways, every WHILE and repeat entered with no pass, one, and many.
    What a slash skipped is inferred from the blocks around it, and is not seen where only a
    computed jump led there.

    Runs of different libraries are added by the file and the name of their programs. Programs that
    have the same of both and another text are a `ValueError`; but of texts without a file (of
    `loads`, and typed in MDI) each other one counts for itself: `<text>`, `<text> 2` and so on.

    >>> import cncsub
    >>> text = "O1\\nN10 IF[#100EQ1]GOTO30\\nN20 M98 P2\\nN30 M30\\nO2\\nN40 M99\\n"
    >>> library = cncsub.loads(text, control="fanuc-0i-f")
    >>> once = library.run().coverage()
    >>> once
    <Coverage: 83.3 %, 4 of 4 blocks, 1 of 2 branches, 1 of 1 calls>
    >>> both = once + library.run(variables={100: 1}).coverage()
    >>> both.percent, [row.count for row in both.branches]
    (100.0, [1, 1])
    """

    _instead = "send its rows, blocks.to_arrow(), or to_lcov()"

    def __init__(self, parts: Iterable[Raw] = (), counted: Iterable[Counted] = ()) -> None:
        self._parts = tuple(parts)
        self._counted = tuple(counted)
        self._made: tuple[Counted, ...] | None = None

    def __add__(self, other: object) -> Coverage:
        if not isinstance(other, Coverage):
            return NotImplemented
        parts = {id(part.code): part for part in self._parts}
        new = [part for part in other._parts if id(part.code) not in parts]
        for part in other._parts:
            if id(part.code) in parts:
                parts[id(part.code)] = parts[id(part.code)].plus(part)
        added = Coverage([*parts.values(), *new], [*self._counted, *other._counted])
        if (new and self._parts) or added._counted:
            _ = added.programs  # other texts under the same names are refused here
        return added

    def __radd__(self, other: object) -> Coverage:
        return self if other == 0 else NotImplemented

    @property
    def programs(self) -> tuple[Counted, ...]:
        """The programs with their counts, for writers of reports."""
        if self._made is None:
            merged = Merged()
            for part in self._parts:
                merged.add(programs_of(part))
            for program in self._counted:
                merged.add([program])
            self._made = tuple(merged.programs)
        return self._made

    @functools.cached_property
    def blocks(self) -> Blocks:
        """A row for each block that can be executed."""
        return Blocks(self.programs)

    @functools.cached_property
    def branches(self) -> Table[BranchRow]:
        """A row for each outcome of a block that decides."""
        return Table(
            BranchRow(p.name, p.blocks.n[i], p.blocks.line[i], kind, outcome, count, count > 0)
            for p in self.programs
            for i in p.blocks.deciding()
            for kind, outcome, count in p.decisions(i)
        )

    @functools.cached_property
    def calls(self) -> Table[CallRow]:
        """A row for each block that calls and program that it called."""
        return Table(
            CallRow(p.name, p.blocks[i].n, p.blocks[i].line, kind, called, count, count > 0)
            for p in self.programs
            for i, kind, called, count in p.calls_of()
        )

    @functools.cached_property
    def arguments(self) -> Table[ArgumentRow]:
        """A row for each argument that a call gave, and for each local that a called program reads
        and no call gave it. Programs that no macro call entered with an argument have no rows.
        """
        return Table(
            ArgumentRow(p.name, LETTER_OF.get(v), v, p.given[v], p.given[v] > 0)
            for p in self.programs
            if p.given
            for v in sorted(p.reads | set(p.given))
        )

    @functools.cached_property
    def percent(self) -> float:
        """The percentage of blocks and of outcomes of branches together that are covered; 0 where
        there are none. Calls and arguments do not count.
        """
        covered, known = self._parts_covered
        return 100.0 * covered / known if known else 0.0

    @functools.cached_property
    def _parts_covered(self) -> tuple[int, int]:
        if self._made is None and len(self._parts) == 1 and not self._counted:
            return self._parts[0].outcomes()  # no program is looked at for it
        each = [program.parts() for program in self.programs]  # no rows are made for it
        return sum(covered for covered, _ in each), sum(known for _, known in each)

    @property
    def measured(self) -> bool:
        """Whether there is a block that could be executed at all."""
        return self._parts_covered[1] > 0

    def to_html(self, path: str | Path | None = None, *, root: str | Path | None = None) -> str:
        """Return the programs with what was executed, as one page that needs nothing else, and
        write it to `path` where one is given. Files below `root`, the current folder without it,
        are named from there: in the page, in `to_lcov` and in `to_cobertura`.
        """
        from cncsub.coverage.formats import html

        page = html(self, root)
        if path is not None:
            write_whole(path, page)
        return page

    def to_lcov(self, *, root: str | Path | None = None) -> str:
        """Return the counts as an lcov tracefile."""
        from cncsub.coverage.formats import lcov

        return lcov(self, root)

    def to_cobertura(self, *, root: str | Path | None = None) -> str:
        """Return the counts as XML of Cobertura (coverage-04.dtd)."""
        from cncsub.coverage.formats import cobertura

        return cobertura(self, root)

    def _repr_html_(self) -> str:
        from cncsub.notebook_values import coverage_html

        return coverage_html(self)

    def __repr__(self) -> str:
        def told(rows: Table[Any] | Blocks, what: str) -> str:
            return f"{rows.covered} of {len(rows)} {what}"

        percent = percent_text(self.percent) if self.measured else "nothing was measured"
        return (
            f"<Coverage: {percent}, {told(self.blocks, 'blocks')},"
            f" {told(self.branches, 'branches')}, {told(self.calls, 'calls')}>"
        )


class Merged:
    """The programs of several memories: those of one file, name and text are one."""

    def __init__(self) -> None:
        self.programs: list[Counted] = []
        self._known: dict[tuple[str, str, int], list[int]] = {}  # by key, places in `programs`

    def add(self, programs: Iterable[Counted]) -> None:
        """Add programs. Raises `ValueError`, before anything is added, for another text of a file's
        program.
        """
        placed = [(program, self._same(program)) for program in programs]
        for program, old in placed:
            if old is not None:
                self.programs[old] = self.programs[old].plus(program)
                continue
            others = self._known.setdefault(program.key, [])
            file = program.file
            if program.has_no_file:  # another text gets a number
                file = f"{program.origin} {len(others) + 1}" if others else program.origin
            others.append(len(self.programs))
            self.programs.append(replace(program, file=file))

    def _same(self, program: Counted) -> int | None:
        """Return the place of what is known of the same program."""
        known = self._known.get(program.key, [])
        for place in known:
            old = self.programs[place]
            if old.text == program.text and old.blocks == program.blocks:
                return place
        if known and not program.has_no_file:
            raise ValueError(
                f"{program.name} of {program.origin} has another text, or is read by another"
                " control, in the runs that are added: add runs of one version, or name their"
                " files differently"
            )
        return None


def coverage_of(trace: _core.Trace, code: _core.Code) -> Coverage:
    """Count what a run recorded. Raises `ValueError` where it did not keep its blocks."""
    if not _core.keeps_blocks(trace):
        raise ValueError(
            'a run with trace="none" or "calls" records no blocks to count: run it with'
            ' trace="blocks" or "moves"'
        )
    return Coverage([raw_of(trace, code)])


_Read = tuple[object, object]  # which control, which texts


class Collected:
    """The sum of the runs of a `collecting()`.

    `total`: their coverage. `runs`: how many were counted. `left_out`: those that kept no blocks,
    or had other texts in files of the same names.
    """

    def __init__(self) -> None:
        self.runs = 0
        self.left_out = 0
        self._lock = threading.Lock()
        self._parts: dict[_Read, Raw] = {}
        self._reads: dict[int, _Read] = {}  # of the codes that are parts, by their ids
        self.texts_of: dict[tuple[str, str, int], tuple[str, object]] = {}  # and the control
        self._total: Coverage | None = Coverage()

    @property
    def total(self) -> Coverage:
        with self._lock:
            if self._total is None:
                self._total = Coverage(self._parts.values())
            return self._total

    @property
    def parts(self) -> tuple[Raw, ...]:
        """The counts of each memory that ran."""
        with self._lock:
            return tuple(self._parts.values())

    def take(self, trace: _core.Trace, code: _core.Code) -> None:
        found = raw_of(trace, code) if _core.keeps_blocks(trace) else None
        with self._lock:
            if found is None or not self._add(found):
                self.left_out += 1
            else:
                self.runs += 1
                self._total = None

    def _add(self, found: Raw) -> bool:
        """Add a run to the part that has read the same, so that no program is looked at twice.
        Return whether the run was counted.
        """
        read = self._reads.get(id(found.code))
        if read is None:
            read = _what_is_read(found.code)
        if read in self._parts:
            self._parts[read] = self._parts[read].plus(found)
            return True
        if not self._fits(found, read[0]):
            return False  # a run that ended well is not to fail for what is counted of it
        self._parts[read] = found
        self._reads[id(found.code)] = read  # the part keeps its code, and with it the id
        return True

    def _fits(self, found: Raw, control: object) -> bool:
        """Return whether no file's program has another text. Its blocks are looked at only where
        the control differs.
        """
        new: dict[tuple[str, str, int], tuple[str, object]] = {}
        seen: Counter[tuple[str, str]] = Counter()
        for index in range(len(found.code)):
            data = found.code.program(index)
            name = data.file, data.name
            if not has_no_file(data.file):
                new[origin_of(data.file), data.name, seen[name]] = data.text, control
            seen[name] += 1
        other = [key for key, value in new.items() if self.texts_of.setdefault(key, value) != value]
        if any(self.texts_of[key][0] != new[key][0] for key in other):
            return False
        if other:
            try:
                merged = Merged()
                for part in (*self._parts.values(), found):
                    merged.add(programs_of(part))
            except ValueError:
                return False
        return True

    def __repr__(self) -> str:
        return f"<Collected: {self.runs} runs, {self.left_out} left out>"


def _what_is_read(code: _core.Code) -> _Read:
    """Return a key: codes with the same key have the same blocks at the same addresses."""
    control = code.control
    rules = tuple((rule.name, rule.value) for rule in control.rules)
    parameters = tuple((name, each.value) for name, each in control.parameters.items())
    return (control.name, rules, parameters), tuple(map(tuple, code.sources))


@contextmanager
def collecting() -> Iterator[Collected]:
    """Add up every `run` and `mdi` of this process that finishes meanwhile, in any thread. Runs
    that keep no blocks, by their `trace`, and those whose programs have another text than those of
    the same file and name before, are left out and counted in `left_out`; machines and streams are
    not collected.

    >>> import cncsub.coverage.summary
    >>> with cncsub.coverage.collecting() as collected:
    ...     run = cncsub.loads("O1\\nN10 M30\\n", control="fanuc-0i-f").run()
    >>> collected.runs, collected.total.percent
    (1, 100.0)
    """
    own = Collected()
    with told(own.take):
        yield own
