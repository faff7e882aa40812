"""The differences of a new version of programs, by block."""

from __future__ import annotations

import difflib
import functools
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

from cncsub import _core
from cncsub.analysis.first_difference import column_of, first_difference

if TYPE_CHECKING:
    from cncsub.analysis.first_difference import Column
    from cncsub.library import Library
    from cncsub.program import Block, Program
    from cncsub.run import Run

_CALLS = ("kind", "program", "start_n", "repeats")
_NOT_SHOWN = ("move", "step", "length", "time", "program", "n", "line")
_MOST_ALIGNED = 20_000  # blocks between the first and the last change that are looked at closely
_MOST_TOLD = 3  # values of a list
_Controls = tuple[_core.Control, _core.Control]


class Place(NamedTuple):
    """A block: `line` is that of its file."""

    program: str
    n: int | None
    line: int

    def __str__(self) -> str:
        n = "" if self.n is None else f" N{self.n}"
        return f"{self.program}{n}, line {self.line}"


@dataclass(frozen=True, slots=True)
class BlockChange:
    """The difference in what one block does.

    `what`: `"calls"`, `"moves"`, `"codes"`, `"variables"` or `"runs"` (how often it is executed).
    `before`, `after`: the block in each version, `None` where that has no such block. `old`, `new`:
    what it does in each, empty where it does nothing of that kind.
    """

    what: str
    before: Place | None
    after: Place | None
    old: str
    new: str

    def __str__(self) -> str:
        if self.before is None:
            return f"{self.after} is new: {self.new}"
        if self.after is None:
            return f"{self.before} is gone: {self.old}"
        moved = "" if self.before[::2] == self.after[::2] else f" (was {self.before})"
        return f"{self.after}{moved}: {self.what}: {self.old or 'none'} -> {self.new or 'none'}"


_Key = tuple[str, int]  # program, line
_Side = tuple[str, "Block"]  # name of the program, block


class _Rows:
    """The rows of a table by the blocks that made them."""

    def __init__(self, table: Any, steps: Column, of_step: Column, blocks: int, names: list[str]):
        import numpy as np

        known = steps < len(of_step)
        made_by = of_step[steps[known]]
        self._order = np.flatnonzero(known)[np.argsort(made_by, kind="stable")]
        self._ends = np.cumsum(np.bincount(made_by, minlength=blocks))
        self._columns = {name: column_of(table, name) for name in names if name in table.columns}

    def of(self, block: int | None) -> dict[str, Column]:
        """Return the columns of the rows of a block."""
        if block is None:
            return {name: column[:0] for name, column in self._columns.items()}
        first = self._ends[block - 1] if block else 0
        rows = self._order[first : self._ends[block]]
        return {name: column[rows] for name, column in self._columns.items()}


class _Did:
    """The effects of the blocks of a run."""

    def __init__(self, run: Run, watched: Run) -> None:
        import numpy as np

        steps = run.steps
        names, programs = steps.programs, steps.program.astype(np.int64)
        keys, of_step, counts = np.unique(
            (programs << 32) + steps.line, return_inverse=True, return_counts=True
        )
        self._blocks = {
            (names[key >> 32], key & 0xFFFFFFFF): i for i, key in enumerate(keys.tolist())
        }
        self._counts = counts.tolist()
        self.control = run.recorded.control

        def rows(table: Any, made_by: Column, columns: list[str]) -> _Rows:
            return _Rows(table, made_by, of_step, len(keys), columns)

        moved = [name for name in run.moves.columns if name not in _NOT_SHOWN]
        self.calls = rows(run.calls, run.calls.caller_step, [*_CALLS])
        self.moves = rows(run.moves, run.moves.step, moved)
        self.values = rows(watched.watch, watched.watch["step"], ["variable", "value"])

    def place(self, key: _Key | None) -> int | None:
        """Return the number of a block, `None` where it was not executed."""
        return None if key is None else self._blocks.get(key)

    def count(self, place: int | None) -> int:
        return 0 if place is None else int(self._counts[place])


def _pairs(before: Library, after: Library) -> Iterator[tuple[Program | None, Program | None]]:
    """Yield the programs of one name, then the others, paired where they have the same blocks."""
    old, new = dict(before), dict(after)
    yield from ((old[name], new[name]) for name in old if name in new)
    gone = [program for name, program in old.items() if name not in new]
    come = [program for name, program in new.items() if name not in old]
    for program in gone:
        texts = [block.text for block in program.blocks]
        same = next((p for p in come if [block.text for block in p.blocks] == texts), None)
        if same is not None:
            come.remove(same)
        yield program, same
    yield from ((None, program) for program in come)


def _aligned(a: Sequence[str], b: Sequence[str]) -> Iterator[tuple[int | None, int | None]]:
    """Yield the places of blocks that are each other's versions; `None` where there is no
    version.
    """
    head = 0
    while head < min(len(a), len(b)) and a[head] == b[head]:
        head += 1
    tail = 0
    while tail < min(len(a), len(b)) - head and a[-1 - tail] == b[-1 - tail]:
        tail += 1
    yield from ((i, i) for i in range(head))
    ends = len(a) - tail, len(b) - tail
    if max(ends[0] - head, ends[1] - head) > _MOST_ALIGNED:
        yield from _in_order(range(head, ends[0]), range(head, ends[1]))
    else:
        matcher = difflib.SequenceMatcher(None, a[head : ends[0]], b[head : ends[1]], False)
        for _, a1, a2, b1, b2 in matcher.get_opcodes():
            yield from _in_order(range(head + a1, head + a2), range(head + b1, head + b2))
    yield from ((ends[0] + i, ends[1] + i) for i in range(tail))


def _in_order(a: range, b: range) -> Iterator[tuple[int | None, int | None]]:
    both = min(len(a), len(b))
    yield from zip(a[:both], b[:both], strict=True)
    yield from ((i, None) for i in a[both:])
    yield from ((None, i) for i in b[both:])


def block_changes(
    libraries: tuple[Library, Library], runs: tuple[Run, Run], watched: tuple[Run, Run]
) -> tuple[BlockChange, ...]:
    """Return the changes by the blocks of the programs; blocks that are gone stand where they
    stood.
    """
    did = _Did(runs[0], watched[0]), _Did(runs[1], watched[1])
    found: list[BlockChange] = []
    for one, other in _pairs(*libraries):
        old = [] if one is None else [(one.name, block) for block in one.blocks]
        new = [] if other is None else [(other.name, block) for block in other.blocks]
        texts = [[block.text for _, block in each] for each in (old, new)]
        for i, k in _aligned(*texts):
            sides = None if i is None else old[i], None if k is None else new[k]
            found += _changes(sides, did)
    return tuple(found)


def _changes(
    sides: tuple[_Side | None, _Side | None], did: tuple[_Did, _Did]
) -> Iterator[BlockChange]:
    """Yield the changes of a block and its new version, or of a block that has none."""
    before, after = (
        None if side is None else Place(side[0], side[1].n, side[1].line) for side in sides
    )
    places = [
        of.place(None if side is None else (side[0], side[1].line))
        for side, of in zip(sides, did, strict=True)
    ]
    counts = [of.count(place) for of, place in zip(did, places, strict=True)]
    if not any(counts):
        return
    if before is None or after is None:
        told = ["" if side is None else side[1].text.strip() for side in sides]
        at = 0 if after is None else 1
        yield BlockChange(_kind_of(did[at], places[at], sides[at]), before, after, told[0], told[1])
        return
    if counts[0] != counts[1]:
        yield BlockChange("runs", before, after, _times(counts[0]), _times(counts[1]))
    for what, tell in (("calls", _calls), ("moves", _moves), ("variables", _values)):
        table = "values" if what == "variables" else what
        old, new = (getattr(of, table).of(place) for of, place in zip(did, places, strict=True))
        if (texts := tell(old, new, (did[0].control, did[1].control))) is not None:
            yield BlockChange(what, before, after, *texts)
    codes = [_codes(side) for side in sides]
    if codes[0] != codes[1] and all(counts):
        yield BlockChange("codes", before, after, codes[0], codes[1])


def _kind_of(did: _Did, place: int | None, side: _Side | None) -> str:
    for what, rows in (("calls", did.calls), ("moves", did.moves)):
        if any(map(len, rows.of(place).values())):
            return what
    if _codes(side):
        return "codes"
    return "variables" if len(did.values.of(place)["variable"]) else "runs"


def _codes(side: _Side | None) -> str:
    words = () if side is None else side[1].words
    return " ".join(word.text for word in words if word.address in ("M", "T"))


def _times(count: int) -> str:
    return "never" if count == 0 else "once" if count == 1 else f"{count:,} times"


def _parting(old: Mapping[str, Column], new: Mapping[str, Column]) -> int | None:
    shared = [name for name in old if name in new]
    return first_difference([(old[name], new[name]) for name in shared]) if shared else None


def _calls(
    old: Mapping[str, Column], new: Mapping[str, Column], of: _Controls
) -> tuple[str, str] | None:
    at = _parting(old, new)
    return None if at is None else (_some(old, at, _call), _some(new, at, _call))


def _call(row: Mapping[str, Any]) -> str:
    start = f" N{row['start_n']}" if row["start_n"] >= 0 else ""
    passes = f" {row['repeats']} times" if row["repeats"] != 1 else ""
    return f"{row['kind']} {row['program']}{start}{passes}"


def _values(
    old: Mapping[str, Column], new: Mapping[str, Column], of: _Controls
) -> tuple[str, str] | None:
    at = _parting(old, new)
    if at is None:
        return None
    texts = [functools.partial(_value, control) for control in of]
    return _some(old, at, texts[0]), _some(new, at, texts[1])


def _value(control: _core.Control, row: Mapping[str, Any]) -> str:
    value, name = row["value"], _core.variable_name(control, int(row["variable"]))
    return f"{name} = {'vacant' if value != value else f'{value:g}'}"


def _some(
    columns: Mapping[str, Column], first: int, text: Callable[[Mapping[str, Any]], str]
) -> str:
    """Return the rows from the first that differs on, as text."""
    count = len(next(iter(columns.values())))
    told = [
        text({name: column[i] for name, column in columns.items()})
        for i in range(first, min(count, first + _MOST_TOLD))
    ]
    left = count - first - len(told)
    return ", ".join(told) + (f" and {left:,} more" if left > 0 else "")


def _moves(
    old: Mapping[str, Column], new: Mapping[str, Column], of: _Controls
) -> tuple[str, str] | None:
    """Return the first move that differs, by the values that differ; or the numbers of moves where
    these differ.
    """
    at = _parting(old, new)
    if at is None:
        return None
    counts = [len(next(iter(columns.values()))) for columns in (old, new)]
    if at >= min(counts):
        return _count(counts[0]), _count(counts[1])
    other = [
        name
        for name in old
        if name in new
        and first_difference([(old[name][at : at + 1], new[name][at : at + 1])]) is not None
    ]
    told = ([name for name in other if not name.startswith("m")] or other)[:_MOST_TOLD]
    return (
        ", ".join(f"{name} = {_shown(old[name][at])}" for name in told),
        ", ".join(f"{name} = {_shown(new[name][at])}" for name in told),
    )


def _count(moves: int) -> str:
    return f"{moves:,} move{'' if moves == 1 else 's'}"


def _shown(value: Any) -> str:
    return str(value) if isinstance(value, str) else f"{float(value):g}"


def changed_lines(changes: Iterable[BlockChange], most: int) -> Iterator[str]:
    """Yield a line for each of the first `most` changes."""
    every = list(changes)
    yield from map(str, every[:most])
    if len(every) > most:
        yield f"... and {len(every) - most:,} more"
