"""The comparison of two runs that have to do the same: of one program by its short ways and by the
general way alone, or at another place of the machine.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterable, Iterator
from typing import Any

import numpy as np

import cncsub
from cncsub.testing.cases import Case, Text
from cncsub.testing.outcome import execute, load

ROUNDING = 1e-9  # mm, degrees and seconds, and relative to the value
LONG = 200  # rows


def parting(one: cncsub.Run, other: cncsub.Run) -> str | None:
    """Return the first thing in which two runs differ, None if they are the same run."""
    for name, told in TOLD.items():
        a, b = told(one), told(other)
        if a != b and not same(a, b):
            return f"{name}: {a}\n{' ' * len(name)}  {b}"
    return None


def _alarm(run: cncsub.Run) -> object:
    if run.alarm is None:
        return None
    alarm = run.alarm
    frames = [(f.program, f.n, f.line, f.kind, f.repeat, f.repeats) for f in alarm.frames]
    said = (alarm.cause, alarm.number, alarm.text, alarm.word, alarm.detail)
    return (*said, alarm.program, alarm.n, alarm.line, alarm.column, frames)


def _rows(table: Any) -> object:
    """Return the rows of a table; of a long table its columns, which cost less."""
    if len(table) < LONG:
        return list(table)
    return {name: np.asarray(getattr(table, name)).tolist() for name in table.columns}


# What a run reports besides its moves.
TOLD: dict[str, Callable[[cncsub.Run], object]] = {
    "stop": lambda run: (run.stop, run.waiting_for, run.blocks),
    "alarm": _alarm,
    "steps": lambda run: _rows(run.steps),
    "calls": lambda run: (_rows(run.calls), [dict(call.arguments) for call in run.calls]),
    "moves": lambda run: _rows(run.moves),
    "variables": lambda run: dict(run.variables),
    "codes": lambda run: (run.m_codes, run.t_codes, list(map(str, run.messages))),
    "dropped": lambda run: [(word.text, word.step) for word in run.dropped],
    "skips": lambda run: [skip.step for skip in run.missed_skips],
    "modal": lambda run: run.modal,
    "position": lambda run: run.position,
}


def same(a: Any, b: Any, rounding: float = ROUNDING) -> bool:
    """Return whether two values are the same but for rounding, in all their parts."""

    def each(values: Iterable[tuple[Any, Any]]) -> bool:
        return all(same(x, y, rounding) for x, y in values)

    if isinstance(a, float) and isinstance(b, float):
        return a == b or (a != a and b != b) or abs(a - b) <= rounding * (1 + abs(a))
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and each((a[key], b[key]) for key in a)
    if dataclasses.is_dataclass(a) and type(a) is type(b):
        return each((getattr(a, f.name), getattr(b, f.name)) for f in dataclasses.fields(a))
    if isinstance(a, list | tuple) and isinstance(b, list | tuple):
        return len(a) == len(b) and each(zip(a, b, strict=True))
    return bool(a == b)


def by_both_ways(text: Text, control: str | cncsub.Control, **options: Any) -> cncsub.Run:
    """Run a text by the short ways and by the general way alone; both have to do the same."""
    ways = [
        cncsub.loads(text, control=control, general_only=general).run(**options)
        for general in (False, True)
    ]
    difference = parting(*ways)
    assert difference is None, f"{difference}\n{text!r} on {control}"
    return ways[0]


def runs_of(case: Case, control: cncsub.Control) -> Iterator[cncsub.Run]:
    """Yield the runs of a row: by the short ways, and by the general way alone."""
    for general in (False, True):
        yield execute(case, load(case, control, general_only=general), trace="moves")
