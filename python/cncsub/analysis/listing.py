"""The executed blocks of a run, each with its text and what it did."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol

from cncsub import _core
from cncsub.program import find_program
from cncsub.tables.rows import Change, Move, SentCode

if TYPE_CHECKING:
    from collections.abc import Mapping

    from cncsub.tables.of_runs import Calls, Codes, Moves, Steps, Watch

_CHUNK = 4096  # steps that are looked at together


@dataclass(frozen=True, slots=True)
class Listed:
    """One executed block.

    `step` is its row in `run.steps`; `text` the block as it is written; `depth` how many calls are
    open, 0 in the main program; `repeat` the pass of its call, from 1. `calls`: the programs that
    it entered. `moves`: its motions, those that were recorded. `changes`: its changes of the
    watched variables. `codes`: the M, T and S codes it sent to the machine.
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

    def __str__(self) -> str:
        done = "; ".join(self._done())
        place = f"{'| ' * self.depth}{self.program}:{self.line}"
        place += f"  pass {self.repeat}" if self.repeat > 1 else ""
        block = f"{self.step:>6}  {place}  {self.text.strip()}"
        return f"{block}  ->  {done}" if done else block

    def _done(self) -> Iterator[str]:
        if self.codes:
            yield " ".join(f"{code.kind}{code.value:.10g}" for code in self.codes)
        for move in self.moves[:_MOST_MOVES]:
            yield _move(move)
        if (left := len(self.moves) - _MOST_MOVES) > 0:
            yield f"and {left:,} more moves"
        for program in self.calls:  # the other words of a block come before its call
            yield f"calls {program}"
        for change in self.changes:
            value = "vacant" if change.value is None else f"{change.value:.10g}"
            yield f"#{change.variable} = {value}"


_MOST_MOVES = 4
_AXES = "xyzabcuvw"


def _move(move: Move) -> str:
    if move.kind == "dwell":
        return f"dwell {move.time:.6g} s"
    ends = ((axis, getattr(move, axis)) for axis in _AXES)
    return " ".join([move.kind, *(f"{a.upper()}{v:.6g}" for a, v in ends if v is not None)])


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
        raise ValueError(f"#{variable} was not watched: run(watch=[{variable}]) keeps its changes")
    if len(run.steps) == 0 and len(run.calls) > 0:
        raise ValueError('the run kept no blocks: trace="blocks" or "moves" keeps them')
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
    moves, changes = run.moves, run.watch
    of_moves, of_changes = _Joined(moves, moves.step), _Joined(changes, changes.step)
    of_codes = _Joined(run.codes, run.codes.step)
    calls = run.calls
    callers = calls.caller_step
    order = callers.argsort(kind="stable")
    entered = _Joined([calls.programs[calls.program[row]] for row in order], callers[order])
    names = run.steps.programs
    for first in range(0, len(run.steps), _CHUNK):
        last = min(first + _CHUNK, len(run.steps))
        texts = run.recorded.step_texts(first, last)
        rows = _chosen(run.steps, first, last, asked)
        columns = [run.steps.column(name)[rows].tolist() for name in _COLUMNS]
        at = run.steps.step[rows]
        joined = [table.of(at) for table in (entered, of_moves, of_changes, of_codes)]
        for row, (step, program, n, line, depth, repeat), calls_of, moves_of, changed, sent in zip(
            rows, zip(*columns, strict=True), *joined, strict=True
        ):
            if variable is not None and all(change.variable != variable for change in changed):
                continue
            yield Listed(
                step,
                names[program],
                None if n < 0 else n,
                line,
                depth,
                repeat,
                texts[row - first],
                calls_of,
                moves_of,
                changed,
                sent,
            )


_COLUMNS = ("step", "program", "n", "line", "depth", "repeat")


def _chosen(steps: Steps, first: int, last: int, asked: Mapping[str, int | None]) -> list[int]:
    """Return the rows of a stretch that are asked for."""
    chosen = steps.step[first:last] >= 0
    for name, value in asked.items():
        if value is not None:
            chosen &= steps.column(name)[first:last] == value
    rows: list[int] = (chosen.nonzero()[0] + first).tolist()
    return rows
