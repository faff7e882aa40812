"""Why a session stands where it stands, and what the program wrote on the way there."""

from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import NamedTuple

from cncsub.debugging.points import PlacedPoint


class Reason(enum.StrEnum):
    """Why a session pauses."""

    ENTRY = "entry"  # at the head of the program
    STEP = "step"  # after a step, forwards or back
    BREAKPOINT = "breakpoint"
    ALARM = "alarm"  # the control stopped the program
    GOTO = "goto"  # another block was made the next one
    PAUSE = "pause"  # somebody asked for it
    END = "end"  # the program has ended
    WAITING = "waiting"  # for an input that is not given
    LIMIT = "limit"  # of blocks, time or memory


class Output(NamedTuple):
    """A line that was written. `kind`: `"message"` of the program, as by DPRNT or #3006, or `"log"`
    of a breakpoint. `file` and `line` say where, empty and 0 where it is not known.
    """

    text: str
    kind: str
    file: str = ""
    line: int = 0


@dataclass(frozen=True, slots=True)
class Pause:
    """Why a session pauses. `text`: the reason in a few words. `breakpoints`: those that were
    reached. `output`: what was written since the last pause.
    """

    reason: Reason
    text: str
    breakpoints: tuple[PlacedPoint, ...] = ()
    output: tuple[Output, ...] = ()
