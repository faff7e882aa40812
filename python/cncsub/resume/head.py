"""The head of a restart program: the blocks that bring a machine into the state of a run."""

from __future__ import annotations

from typing import NamedTuple

from cncsub.resume.approach import Approach
from cncsub.resume.data import write_offsets, write_variables
from cncsub.resume.draft import Draft
from cncsub.resume.frames import bend, shift, shift_first
from cncsub.resume.modes import write_modes_first, write_modes_last
from cncsub.resume.tool import change_tool, choose_edge, clamp_speed, turn_spindle


class Manner(NamedTuple):
    """How a head is made. `repeats`: with the block before the place, where it makes no move.
    `bends_first`: rotation and the like come before the head moves across. `units_late`: the head
    moves in the units of power-on: the run may have come to the place in them. `mixes_units`: each
    axis moves in the units that lead to its place exactly. `is_empty`: at the first block of a run
    nothing need come before, and a control may want that block first. `says_motion`: the first
    block of the rest that moves says the code of its motion, which a control may take with axes
    only.
    """

    repeats: bool = False
    bends_first: bool = True
    units_late: bool = False
    mixes_units: bool = False
    is_empty: bool = False
    says_motion: bool = False


def write_head(
    draft: Draft,
    manner: Manner,
    height: float | None,
    order: tuple[str, ...] | None,
    *,
    commons: bool,
) -> None:
    """Write the head into an empty draft. `height`: to which it goes first, a machine coordinate;
    `order`: of the axes; `commons`: whether it sets the variables that programs may use as they
    like. Raises `ResumeError` where no head can be written.
    """
    if manner.is_empty:
        return
    write_modes_first(draft, units_late=manner.units_late)
    write_variables(draft, commons=commons)
    write_offsets(draft)
    change_tool(draft)
    clamp_speed(draft)  # before the surface speed turns the spindle
    turn_spindle(draft)
    choose_edge(draft)
    approach = Approach(draft, shift_first(draft), mixes_units=manner.mixes_units)
    approach.go(height, order, bends_first=manner.bends_first)
    shift(draft)
    if not manner.bends_first:
        bend(draft)
        approach.stay_in_frame()
    write_modes_last(draft, but_motion=manner.says_motion)
