"""What the owner of a machine sees of a short program: how it stops, which blocks run, variables,
codes, and where the tool goes.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

from cncsub.controls import Control
from cncsub.loading import loads
from cncsub.run import Run, Stop
from cncsub.setup import Setup
from cncsub.tables.table import Table

MOST_BLOCKS = 3000
_FIRST_SYSTEM = 1000  # variables from this number on are the control's own
_TOLD = 8  # blocks, moves or variables that are told one by one

Seen = Mapping[str, str]
"""What is seen, by what is looked at: `stop`, `blocks`, `variables`, `codes`, `moves`, `time`."""


class Short(NamedTuple):
    """A short program, and the kind of machine that it is for: empty for the control's own."""

    text: str
    machine: str = ""

    @property
    def lines(self) -> int:
        return len(self.text.splitlines())


def seen(program: Short, control: Control) -> Seen | None:
    """Return what is seen of a program on a control; `None` where it cannot be run on it."""
    setup = Setup(machine=program.machine) if program.machine else None
    try:
        library = loads(program.text, control=control)
        run = library.run(max_blocks=MOST_BLOCKS, max_seconds=1, setup=setup)
    except (ValueError, KeyError):  # no main program, or no such machine
        return None
    return {
        "stop": _stop(run),
        "blocks": _few(run.steps, lambda step: _block(step.program, step.n, step.line)),
        "variables": _few(
            [
                f"#{number} = {value:.6g}"
                for number, value in run.variables.items()
                if value is not None and number < _FIRST_SYSTEM
            ]
        ),
        "codes": _few((*run.m_codes, *run.t_codes, *run.messages)),
        "moves": _few(run.moves, _move),
        "time": f"{run.moves.total_time:.3g} s",
    }


def _stop(run: Run) -> str:
    if run.alarm is not None:
        place = _block(run.alarm.program or "", run.alarm.n, run.alarm.line)
        number = f"alarm {run.alarm.number}" if run.alarm.number else "an alarm"
        return f"{number} ({run.alarm.cause}) at {place}"
    told = {
        Stop.END: "ends",
        Stop.CYCLES: "starts over",
        Stop.LIMIT: "does not end",
        Stop.WAITING: "waits",
    }
    return told.get(run.stop, run.stop.value)


def _block(program: str, n: int | None, line: int | None) -> str:
    return f"{program} line {line}" if n is None else f"{program} N{n}"


def _move(move: object) -> str:
    ends = {axis: getattr(move, axis, None) for axis in "xyz"}
    places = " ".join(f"{axis.upper()}{end:.4g}" for axis, end in ends.items() if end is not None)
    return f"{getattr(move, 'kind', '')} {places}".strip()


def _few(seen: Sequence[Any] | Table[Any], tell: Callable[[Any], str] = str) -> str:
    """Return what is told one by one; of many the first ones, the last one and the count."""
    if len(seen) <= _TOLD:
        return ", ".join(map(tell, seen)) or "none"
    first = ", ".join(tell(seen[place]) for place in range(_TOLD - 1))
    return f"{first}, ... {tell(seen[-1])} ({len(seen)})"
