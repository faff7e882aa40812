"""The counts of the programs of a memory while they run, by their blocks."""

from __future__ import annotations

import itertools
import operator
import os
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, NamedTuple, overload

from cncsub import _core
from cncsub.references import references_of

LETTERS = dict(zip("ABCIJKDEFHMQRSTUVWXYZ", (*range(1, 10), 11, 13, *range(17, 27)), strict=True))
LETTER_OF = {number: letter for letter, number in LETTERS.items()}
_OUTCOMES = ("none", "once", "many")
MDI = "MDI"  # the file of what is typed
_LOOPS = ("while", "repeat")


class _Block(NamedTuple):
    n: int | None
    line: int
    text: str
    branch: str
    skip: bool


@dataclass
class _Blocks(Sequence[_Block]):
    """The blocks of a program as columns: a row is made when it is asked for."""

    n: list[int | None]
    line: list[int]
    text: list[str]
    branch: list[str]
    skip: list[bool]

    def __len__(self) -> int:
        return len(self.line)

    @overload
    def __getitem__(self, index: int) -> _Block: ...
    @overload
    def __getitem__(self, index: slice) -> list[_Block]: ...
    def __getitem__(self, index: int | slice) -> _Block | list[_Block]:
        if isinstance(index, slice):
            return [self[place] for place in range(len(self))[index]]
        return _Block(
            self.n[index], self.line[index], self.text[index], self.branch[index], self.skip[index]
        )

    def __iter__(self) -> Iterator[_Block]:
        return map(_Block, self.n, self.line, self.text, self.branch, self.skip)

    def deciding(self) -> Iterator[int]:
        """Yield the places of blocks that decide where the program goes on."""
        decides = map(operator.or_, map(bool, self.branch), self.skip)
        return itertools.compress(range(len(self)), decides)


@dataclass
class Counted:
    """One program and its counts; blocks are numbered from 0. `origin` is the file that it was read
    from and `nth` its place among the programs of this name there. `file` is the name in reports,
    which tells texts without a file apart.
    """

    name: str
    origin: str
    nth: int
    file: str
    text: str
    blocks: _Blocks
    held: list[int]
    failed: list[int]
    skipped: list[int]
    loops: dict[int, list[int]]
    sites: dict[tuple[int, str], str]  # calls as they are written
    calls: Counter[tuple[int, str, str]]
    reads: set[int]
    given: Counter[int]

    def plus(self, other: Counted) -> Counted:
        """Return the sum of two counts of one program."""
        loops = dict(self.loops)
        for block, entries in other.loops.items():
            loops[block] = _sums(loops.get(block, [0, 0, 0]), entries)
        return replace(
            self,
            held=_sums(self.held, other.held),
            failed=_sums(self.failed, other.failed),
            skipped=_sums(self.skipped, other.skipped),
            loops=loops,
            calls=self.calls + other.calls,
            given=self.given + other.given,
        )

    @property
    def key(self) -> tuple[str, str, int]:
        """What programs of several memories have in common that are one."""
        return self.origin, self.name, self.nth

    @property
    def has_no_file(self) -> bool:
        """Whether it is a text, or what was typed."""
        return has_no_file(self.origin)

    def blocks_covered(self) -> int:
        return sum(map(bool, map(operator.add, self.held, self.failed)))

    def parts(self) -> tuple[int, int]:
        """Return how many blocks and outcomes of branches are covered, and how many there are."""
        counts = [count for index in self.blocks.deciding() for _, count in self.outcomes(index)]
        covered = self.blocks_covered() + sum(count > 0 for count in counts)
        return covered, len(self.blocks) + len(counts)

    def count(self, block: int) -> int:
        return self.held[block] + self.failed[block]

    def outcomes(self, block: int) -> Iterator[tuple[str, int]]:
        return ((outcome, count) for _, outcome, count in self.decisions(block))

    def decisions(self, block: int) -> Iterator[tuple[str, str, int]]:
        """Yield kind, outcome and count of each decision of a block."""
        kind = self.blocks.branch[block]
        if self.blocks.skip[block]:
            yield "block-skip", "skipped", self.skipped[block]
            yield "block-skip", "not skipped", self.count(block)
        if kind in _LOOPS:
            entries = self.loops.get(block, [0, 0, 0])
            yield from ((kind, *of) for of in zip(_OUTCOMES, entries, strict=True))
        elif kind:
            yield kind, "taken", self.held[block]
            yield kind, "not taken", self.failed[block]

    def never_given(self) -> list[str]:
        """Return the arguments that the program reads and no call gave, where calls gave it some:
        `B (#2)`.
        """
        numbers = sorted(v for v in self.reads if not self.given[v]) if self.given else []
        return [f"{LETTER_OF[v]} (#{v})" if v in LETTER_OF else f"#{v}" for v in numbers]

    def calls_of(self) -> Iterator[tuple[int, str, str, int]]:
        """Yield block, kind, called and count: calls that were made, and calls as written that made
        none.
        """
        made = {block for block, _, _ in self.calls}
        left = [(*site, called, 0) for site, called in self.sites.items() if site[0] not in made]
        yield from sorted([*left, *((*key, count) for key, count in self.calls.items())])


def origin_of(name: str) -> str:
    """Return what the file of a name is known by: `/a/../b.nc` and `/b.nc` are one file."""
    return os.path.realpath(name) if Path(name).is_absolute() else name


def has_no_file(name: str) -> bool:
    """Return whether a name is that of a text, or of what was typed."""
    return name == MDI or name.startswith("<")


def _sums(some: list[int], others: list[int]) -> list[int]:
    return [a + b for a, b in zip(some, others, strict=True)]


@dataclass
class Raw:
    """The counts of the programs of one memory, by the addresses of their blocks."""

    code: _core.Code
    held: Any
    failed: Any
    skipped: Any
    loops: Counter[tuple[int, int]]  # address, place in _OUTCOMES
    calls: Counter[tuple[int, str, int]]
    given: Counter[tuple[int, int]]

    def plus(self, other: Raw) -> Raw:
        return Raw(
            self.code,
            self.held + other.held,
            self.failed + other.failed,
            self.skipped + other.skipped,
            self.loops + other.loops,
            self.calls + other.calls,
            self.given + other.given,
        )

    def outcomes(self) -> tuple[int, int]:
        """Return how many blocks and outcomes of branches are covered, and how many there are."""
        blocks, deciding = _core.coverage_deciding(self.code)
        executed = (self.held + self.failed) > 0
        counts: list[int] = []
        for address, kind, skip in deciding:
            if skip:
                counts += (int(self.skipped[address]), int(executed[address]))
            if kind in _LOOPS:
                counts += (self.loops[address, place] for place in range(len(_OUTCOMES)))
            elif kind:
                counts += (int(self.held[address]), int(self.failed[address]))
        covered = int((executed & (blocks > 0)).sum()) + sum(count > 0 for count in counts)
        return covered, int(blocks.sum()) + len(counts)


def percent_text(percent: float) -> str:
    """Return a percentage with one decimal; 100.0 % is all of it.

    >>> from cncsub.coverage.block_counts import percent_text
    >>> percent_text(99.96), percent_text(100.0)
    ('99.9 %', '100.0 %')
    """
    return f"{percent if percent >= 100 else min(percent, 99.9):.1f} %"


def programs_of(raw: Raw) -> Iterator[Counted]:
    """Yield each program of the memory with its counts."""
    import numpy as np

    code = raw.code
    # By address: the program, and the place among its blocks.
    owner = np.full(len(raw.held), -1)
    own = np.zeros(len(raw.held), dtype=int)
    made: list[Counted] = []
    seen: Counter[tuple[str, str]] = Counter()
    sites: dict[int, dict[tuple[int, str], str]] = {}
    for caller, index, call in _core.all_calls(code):
        called = call[6] if call[6] is not None else call[2] or ""
        if call[2] is not None and call[6] is None:
            called = code.program(call[2]).name
        sites.setdefault(caller, {})[index, call[0]] = str(called or call[1] or "")
    for index, (addresses, *columns) in enumerate(_core.coverage_blocks(code)):
        data = code.program(index)
        at = np.array(addresses, dtype=np.intp)
        owner[at] = index
        own[at] = np.arange(len(at))
        first = addresses[0] if addresses else 0
        offsets = (
            {}
            if not sites.get(index) and "#" not in data.text
            else {address - first: place for place, address in enumerate(addresses)}
        )
        made.append(
            Counted(
                data.name,
                origin_of(data.file),
                seen[data.file, data.name],
                data.file,
                data.text,
                _Blocks(*columns),  # type: ignore[arg-type]
                raw.held[at].tolist(),
                raw.failed[at].tolist(),
                raw.skipped[at].tolist(),
                {},
                {
                    (offsets[b], k): to
                    for (b, k), to in sites.get(index, {}).items()
                    if b in offsets
                },
                Counter(),
                _locals_read(data, offsets),
                Counter(),
            )
        )
        seen[data.file, data.name] += 1
    for (address, outcome), count in raw.loops.items():
        index, block_at = owner[address], int(own[address])
        made[index].loops.setdefault(block_at, [0, 0, 0])[outcome] += count
    for (address, kind, called_index), count in raw.calls.items():
        if owner[address] >= 0:
            index, block_at = owner[address], int(own[address])
            made[index].calls[block_at, kind, made[called_index].name] += count
    for (index, variable), count in raw.given.items():
        made[index].given[variable] += count
    yield from (each for index, each in enumerate(made) if not code.program(index).system)


def _locals_read(data: _core.ProgramData, blocks: Iterable[int]) -> set[int]:
    """Return the locals 1 to 26 that stand for arguments and are read."""
    if "#" not in data.text:
        return set()
    found = {use.variable for block in blocks for use in references_of(data, block).reads}
    return {number for number in found if isinstance(number, int) and number in LETTER_OF}


def not_executed(code: _core.Code) -> Raw:
    """Return the counts of programs that nothing ran."""
    import numpy as np

    blocks, _ = _core.coverage_deciding(code)
    held, failed, skipped = np.zeros((3, len(blocks)), dtype=np.int64)
    return Raw(code, held, failed, skipped, Counter(), Counter(), Counter())


def raw_of(trace: _core.Trace, code: _core.Code) -> Raw:
    """Return the counts of a run."""
    held, failed, skipped, loops, calls, given = _core.coverage(trace)
    return Raw(
        code,
        held,
        failed,
        skipped,
        Counter({(at, i): of[i] for at, *of in loops for i in range(3)}),
        Counter({call[:3]: call[3] for call in calls}),
        Counter({row[:2]: row[2] for row in given}),
    )
