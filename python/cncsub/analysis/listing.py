"""The executed blocks of a run, each with its text and what it did."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol

from cncsub import _core
from cncsub.number_text import length_text, number_text
from cncsub.program import find_program
from cncsub.tables.rows import Change, Compared, Move, SentCode

if TYPE_CHECKING:
    from collections.abc import Mapping

    from cncsub.tables.of_runs import Calls, Codes, Conditions, Moves, Steps, Watch

_CHUNK = 4096  # steps that are looked at together


@dataclass(frozen=True, slots=True)
class Listed:
    """One executed block.

    `step` is its row in `run.steps`; `text` the block as it is written; `depth` how many calls are
    open, 0 in the main program; `repeat` the pass of its call, from 1. `calls`: the programs that
    it entered. `moves`: its motions, those that were recorded. `changes`: its changes of the
    watched variables. `codes`: the M, T and S codes it sent to the machine. `conditions`: the
    comparisons of its condition, in a run with `conditions=True`. `on_to`: the block that ran next,
    where that is not the one after it: `on to N80` after a jump, `back to O1 line 7` after a
    return. `skipped`: the blocks after it that block skip left out. `variables`: the variables of
    `changes` as programs write them: `#100`, `R5`.
    """

    step: int
    program: str
    n: int | None
    line: int
    depth: int
    repeat: int
    text: str
    calls: tuple[str, ...]
    moves: tuple[Move, ...]
    changes: tuple[Change, ...]
    codes: tuple[SentCode, ...] = ()
    conditions: tuple[Compared, ...] = ()
    on_to: str = ""
    skipped: tuple[str, ...] = ()
    variables: tuple[str, ...] = ()

    def __str__(self) -> str:
        done = ", ".join(filter(None, ("; ".join(self._done()), self.on_to)))
        place = f"{'| ' * self.depth}{self.program}:{self.line}"
        place += f"  pass {self.repeat}" if self.repeat > 1 else ""
        block = f"{self.step:>6}  {place}  {self.text.strip()}"
        first = f"{block}  ->  {done}" if done else block
        return "\n".join([first, *(f"{_INDENT}{line}" for line in self._more())])

    def _done(self) -> Iterator[str]:
        if self.codes:
            yield " ".join(f"{code.kind}{number_text(code.value)}" for code in self.codes)
        if len(self.moves) == 1:
            yield _move(self.moves[0])
        elif self.moves:
            yield f"{len(self.moves):,} moves"
        for program in self.calls:  # the other words of a block come before its call
            yield f"calls {program}"
        yield from map(str, self.conditions)
        for name, change in zip(self.variables, self.changes, strict=True):
            yield f"{name} = {number_text(change.value)}"

    def _more(self) -> Iterator[str]:
        """Yield a line for each move where there are several, and for each skipped block."""
        if len(self.moves) > 1:
            yield from _columns(self.moves[:_MOST_MOVES])
        if (left := len(self.moves) - _MOST_MOVES) > 0:
            yield f"and {left:,} more moves"
        yield from (f"skipped: {text.strip()}" for text in self.skipped[:_MOST_SKIPPED])
        if (left := len(self.skipped) - _MOST_SKIPPED) > 0:
            yield f"and {left:,} more blocks skipped"


_INDENT = " " * 10
_MOST_MOVES = 40
_MOST_SKIPPED = 10
_AXES = "xyzabcuvw"


def _ends(move: Move) -> dict[str, str]:
    """Return the words of the end of a move."""
    ends = ((axis, getattr(move, axis)) for axis in _AXES)
    return {axis: f"{axis.upper()}{length_text(v)}" for axis, v in ends if v is not None}


def _move(move: Move) -> str:
    if move.kind == "dwell":
        return f"dwell {number_text(move.time)} s"
    return " ".join([move.kind, *_ends(move).values()])


def _columns(moves: tuple[Move, ...]) -> Iterator[str]:
    """Yield a line for each of some moves, axis below axis."""
    ends = [_ends(move) for move in moves]
    axes = [axis for axis in _AXES if any(axis in end for end in ends)]
    widths = {axis: max(len(end.get(axis, "")) for end in ends) for axis in axes}
    kind = max(len(move.kind) for move in moves)
    for move, end in zip(moves, ends, strict=True):
        if move.kind == "dwell":
            yield _move(move)
            continue
        words = (end.get(axis, "").ljust(widths[axis]) for axis in axes)
        yield " ".join([move.kind.ljust(kind), *words]).rstrip()


class Tables(Protocol):
    """The tables that a listing is made of."""

    recorded: _core.Trace
    core: _core.Machine

    @property
    def steps(self) -> Steps: ...
    @property
    def calls(self) -> Calls: ...
    @property
    def moves(self) -> Moves: ...
    @property
    def watch(self) -> Watch: ...
    @property
    def codes(self) -> Codes: ...
    @property
    def conditions(self) -> Conditions: ...


class _Joined:
    """The rows of a table by their step, which only grows."""

    def __init__(self, table: Any, steps: Any) -> None:
        self._table = table
        self._steps = steps

    def of(self, steps: Any) -> Iterator[tuple[Any, ...]]:
        """Yield the rows of each of some steps."""
        firsts = self._steps.searchsorted(steps, side="left").tolist()
        lasts = self._steps.searchsorted(steps, side="right").tolist()
        for first, last in zip(firsts, lasts, strict=True):
            yield tuple(self._table[row] for row in range(first, last)) if first < last else ()


def listing_of(
    run: Tables,
    *,
    program: str | int | None = None,
    depth: int | None = None,
    n: int | None = None,
    variable: int | None = None,
) -> Iterator[Listed]:
    """See `Run.listing`."""
    wanted = _wanted(run, program)
    watched: Mapping[int, float | None] = run.watch.beginning
    if variable is not None and variable not in watched:
        raise ValueError(
            f"{_core.variable_name(run.recorded.control, variable)} was not watched:"
            f" run(watch=[{variable}]) records its changes"
        )
    if len(run.steps) == 0 and len(run.calls) > 0:
        raise ValueError('the run recorded no blocks: trace="blocks" or "moves" records them')
    return _rows(run, {"program": wanted, "depth": depth, "n": n}, variable)


def _wanted(run: Tables, program: str | int | None) -> int | None:
    """Return the code of a program in the column of steps."""
    if program is None:
        return None
    found = find_program(run.core.code, program)
    if found < 0:
        raise KeyError(f"no program {program} in the memory")
    return found


def _rows(run: Tables, asked: Mapping[str, int | None], variable: int | None) -> Iterator[Listed]:
    tables = (run.moves, run.watch, run.codes, run.conditions)
    of_calls, of_tables = _entered(run.calls), [_Joined(table, table.step) for table in tables]
    steps, names = run.steps, run.steps.programs
    for first in range(0, len(steps), _CHUNK):
        last = min(first + _CHUNK, len(steps))
        texts = run.recorded.step_texts(first, last)
        ways = run.recorded.step_ways(first, last)
        rows = _chosen(steps, first, last, asked)
        columns = [steps.column(name)[rows].tolist() for name in _COLUMNS]
        at = steps.step[rows]
        joined = [table.of(at) for table in (of_calls, *of_tables)]
        for row, (
            step,
            program,
            n,
            line,
            depth,
            repeat,
        ), calls, moves, changes, codes, compared in zip(
            rows, zip(*columns, strict=True), *joined, strict=True
        ):
            if variable is not None and all(change.variable != variable for change in changes):
                continue
            way = ways[row - first]
            yield Listed(
                step,
                names[program],
                None if n < 0 else n,
                line,
                depth,
                repeat,
                texts[row - first],
                calls,
                moves,
                changes,
                codes,
                compared,
                _on_to(steps, row) if way in (_JUMPS, _RETURNS) else "",
                tuple(run.recorded.texts_after(row)) if way == _SKIPS else (),
                tuple(
                    _core.variable_name(run.recorded.control, change.variable) for change in changes
                ),
            )


_SKIPS, _JUMPS, _RETURNS = 1, 2, 3  # of `step_ways`


def _entered(calls: Calls) -> _Joined:
    """Return the names of the called programs by the step that called."""
    callers = calls.caller_step
    order = callers.argsort(kind="stable")
    return _Joined([calls.programs[calls.program[row]] for row in order], callers[order])


def _on_to(steps: Steps, row: int) -> str:
    """Return where a jump or a return led: to the block of the next row."""
    here, there = steps[row], steps[row + 1]
    place = f"line {there.line}" if there.n is None else f"N{there.n}"
    if here.depth == there.depth:
        return f"on to {place}"
    return f"back to {there.program} {place}"


_COLUMNS = ("step", "program", "n", "line", "depth", "repeat")


def _chosen(steps: Steps, first: int, last: int, asked: Mapping[str, int | None]) -> list[int]:
    """Return the rows of a stretch that are asked for."""
    chosen = steps.step[first:last] >= 0
    for name, value in asked.items():
        if value is not None:
            chosen &= steps.column(name)[first:last] == value
    rows: list[int] = (chosen.nonzero()[0] + first).tolist()
    return rows
