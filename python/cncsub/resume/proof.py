"""The proof of a restart program: what it does after its head is what the whole run does from the
place on.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import cncsub.analysis.first_difference as tables
from cncsub._core import variable_name
from cncsub.resume.errors import place_text

if TYPE_CHECKING:
    from cncsub.analysis.first_difference import Column
    from cncsub.run import Run

_NOT_COMPARED = ("move", "step", "program", "n", "line", "time")
_NEAR_TIME = 1e-9  # s


class Part(NamedTuple):
    """A run from a step on; `messages`: how many it had given before."""

    run: Run
    step: int
    messages: int

    def moves_from(self) -> int:
        """Return the first move of the part."""
        return int((self.run.moves.step < self.step).sum()) if len(self.run.moves) else 0

    def codes(self) -> list[tuple[str, float]]:
        rows = self.run.codes
        return [(row.kind, row.value) for row in rows if row.step >= self.step and row.kind != "S"]

    def block_of_move(self, index: int) -> str:
        if index >= len(self.run.moves):
            return "makes no further move"
        move = self.run.moves[index]
        step = self.run.steps[int(self.run.moves.step[index])]
        return f"{place_text(step)}: {move.kind} to {_end(move)}"


def _end(move: Any) -> str:
    axes = ((axis, getattr(move, axis, None)) for axis in "xyzabcuvw")
    return " ".join(f"{axis.upper()}{value:.9g}" for axis, value in axes if value is not None)


def parting(whole: Part, rest: Part, *, variables: bool) -> str | None:
    """Return the first difference between two parts of runs, or `None`. `variables`: whether the
    values at the end are compared.
    """
    return (
        _of_moves(whole, rest)
        or _of_lists(whole, rest)
        or (_of_variables(whole.run, rest.run) if variables else None)
        or _of_stop(whole.run, rest.run)
    )


def _of_moves(whole: Part, rest: Part) -> str | None:
    first = whole.moves_from(), rest.moves_from()
    names = dict.fromkeys([*whole.run.moves.columns, *rest.run.moves.columns])
    apart: dict[str, int] = {}
    precision = whole.run.recorded.control.precision
    for name in (*(n for n in names if n not in _NOT_COMPARED), "length"):
        pair = _column(whole.run, name, first[0]), _column(rest.run, name, first[1])
        if (at := tables.first_difference([pair], precision)) is not None:
            apart[name] = at
    at_time = _time_apart(whole.run, rest.run, first)
    if at_time is not None:
        apart["time"] = at_time
    if not apart:
        return None
    name = min(apart, key=lambda each: apart[each])
    at = apart[name]
    told = whole.block_of_move(first[0] + at), rest.block_of_move(first[1] + at)
    return f"move {at} of the rest differs in {name}\nprogram: {told[0]}\nrestart: {told[1]}"


def _column(run: Run, name: str, first: int) -> Column:
    return tables.column_of(run.moves, name)[first:]


def _time_apart(whole: Run, rest: Run, first: tuple[int, int]) -> int | None:
    a, b = whole.moves.time[first[0] :], rest.moves.time[first[1] :]
    count = min(len(a), len(b))
    coarse = whole.recorded.control.precision * (1 + abs(a[:count]))
    apart = abs(a[:count] - b[:count]) > _NEAR_TIME + coarse
    return int(apart.argmax()) if apart.any() else None


def _of_lists(whole: Part, rest: Part) -> str | None:
    codes = whole.codes(), rest.codes()
    if whole.run.stop == "cycles" and rest.run.stop == "end":
        codes = (codes[0], codes[1][: len(codes[0])] if codes[1][:-1] == codes[0] else codes[1])
    pairs: tuple[tuple[list[Any], list[Any]], ...] = (
        codes,
        (
            list(whole.run.messages)[whole.messages :],
            list(rest.run.messages)[rest.messages :],
        ),
    )
    for what, (a, b) in zip(("code", "message"), pairs, strict=True):
        if a == b:
            continue
        at = next(
            (i for i, (x, y) in enumerate(zip(a, b, strict=False)) if x != y), min(len(a), len(b))
        )
        told = [_entry(each[at]) if at < len(each) else "none" for each in (a, b)]
        return f"{what} {at} of the rest is {told[0]} in the program and {told[1]} in the restart"
    return None


def _entry(value: Any) -> str:
    return f"{value[0]}{value[1]:g}" if isinstance(value, tuple) else repr(value)


def _of_variables(whole: Run, rest: Run) -> str | None:
    a, b = whole.variables, rest.variables
    for number in sorted({*a, *b}):
        if not tables.alike(a[number], b[number]):
            shown = ["vacant" if v is None else f"{v:.12g}" for v in (a[number], b[number])]
            name = variable_name(whole.recorded.control, number)
            return f"{name} is {shown[0]} at the end of the program, {shown[1]} of the restart"
    return None


def _of_stop(whole: Run, rest: Run) -> str | None:
    ended = ("end", "cycles")
    if str(whole.stop) == str(rest.stop) or (whole.stop in ended and rest.stop in ended):
        return None
    return f"the program stops with {whole.summary()}, the restart with {rest.summary()}"
