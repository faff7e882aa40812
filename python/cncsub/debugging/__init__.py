"""What the faces of the debugger share: a session, its breakpoints and its values, under the words
that all of them use.
"""

from cncsub.debugging.frames import StackFrame
from cncsub.debugging.help import Completion, Written
from cncsub.debugging.pauses import Output, Pause, Reason
from cncsub.debugging.points import PausePoint, PlacedPoint
from cncsub.debugging.scopes import Scope, Value
from cncsub.debugging.session import Session

__all__ = [
    "Completion",
    "Output",
    "Pause",
    "PausePoint",
    "PlacedPoint",
    "Reason",
    "Scope",
    "Session",
    "StackFrame",
    "Value",
    "Written",
]
