"""The place of a step of a run: its block as it is written, and the calls that led there."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Protocol

from cncsub._core import Machine
from cncsub.tables.of_runs import Calls, Steps
from cncsub.tables.rows import Dropped, Step


class Ran(Protocol):
    """The part of a run that is read here."""

    core: Machine

    @property
    def steps(self) -> Steps: ...
    @property
    def calls(self) -> Calls: ...


def place_of(step: Step | Dropped) -> str:
    """Return the place of a step, such as `O2 N30, line 6`."""
    n = "" if step.n is None else f" N{step.n}"
    return f"{step.program}{n}, line {step.line}"


def calls_to(run: Ran, step: Step) -> Iterator[str]:
    """Yield the open calls at a step, the innermost first, a line for each."""
    frame: int | None = step.frame
    while frame is not None and 0 <= frame < len(run.calls):
        call = run.calls[frame]
        passes = f", {call.repeats} passes" if call.repeats > 1 else ""
        caller = (
            place_of(run.steps[call.caller_step])
            if 0 <= call.caller_step < len(run.steps)
            else "a block that was not kept"
        )
        yield f"called from {caller} ({call.kind} {call.program}{passes})"
        frame = call.parent


def step_lines(run: Ran, index: int) -> Iterator[str]:
    """Yield the lines of a step: its block and its calls."""
    step = run.steps[index]
    text = step.text.strip()
    yield place_of(step) + (f": {text}" if text else "")
    yield from (f"  {line}" for line in calls_to(run, step))
