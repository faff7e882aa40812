"""How a session runs its machine to a point."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from cncsub.breakpoints import Compiled, blocks_of
from cncsub.debugging.frames import StackFrame
from cncsub.debugging.points import ArmedPoint, PausePoints, PlacedPoint
from cncsub.machine import Machine
from cncsub.program import Block


class Met(NamedTuple):
    """How a run came to an end: the points that were met, whether one of the depths was, what is
    wrong with a condition that has no value there, and whether another thread had it pause.
    """

    points: list[ArmedPoint]
    stepped: bool
    fault: str
    tick: bool


def run_to(
    machine: Machine, points: PausePoints, frames: Sequence[StackFrame], depth: int | None
) -> Met:
    """Run to one of the points, or until no more than `depth` calls are open; `frames` are those
    of the machine now.
    """
    armed, levels = points.armed_in(frames)
    breakpoints = [each.breakpoint for each in armed]
    depths = [*levels, *([] if depth is None else [depth])]
    reached, faulty, paused = Compiled(machine.core, breakpoints).run(depths)
    fault = ""
    if faulty is not None:
        place, detail = faulty
        at = breakpoints[place]
        what = f"the condition {at.when!r}" if at.when is not None else repr(at.at)
        fault = f"{what} has no value here: {detail}"
    met = [armed[i] for i in reached if i < len(armed)]
    return Met(met, any(i >= len(armed) for i in reached), fault, paused)


def standing_at(machine: Machine, points: PausePoints) -> list[ArmedPoint]:
    """Return the points at the block that runs next, whose conditions hold."""
    core, found = machine.core, []
    for armed in points.armed():
        blocks = blocks_of(core, armed.breakpoint)
        when = armed.placed.point.when
        if core.next_block in blocks and (when is None or machine.evaluate(when)):
            found.append(armed)
    return found


def step_over_back(machine: Machine) -> int:
    """Return the last step before this at which no more calls were open than now."""
    open_calls = machine.steps.depth[: machine.blocks]
    found = (open_calls <= len(machine.stack)).nonzero()[0]
    return int(found[-1]) if len(found) else 0


def name_of(placed: PlacedPoint) -> str:
    """Return where a point stands, as a text."""
    at = placed.point.at
    if isinstance(at, str):
        return at
    if isinstance(at, Block):
        return f"{at.program.file}:{at.line}"
    return f"{at[0]}:N{at[1]}"
