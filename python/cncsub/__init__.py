"""Runs NC programs block by block exactly as a named CNC control would, down to the alarm on its
screen.

>>> import cncsub
>>> library = cncsub.loads("O1\\nN10 M98 P2\\nN20 M30\\nO2\\nN30 M99\\n", control="fanuc-0i-f")
>>> run = library.run()
>>> run.stop
<Stop.END: 'end'>
>>> run.steps.n.tolist()
[10, 30, 20]
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from cncsub._core import Alarm, Control, Frame, __version__
from cncsub.breakpoints import Breakpoint
from cncsub.controls import Alias, Cause, Source, aliases, causes, control, controls, sources
from cncsub.engine_types import tell_engine_types
from cncsub.inputs import Inputs
from cncsub.library import Library
from cncsub.loading import load, loads
from cncsub.machine import Machine
from cncsub.program import Block, Program, Token, Word
from cncsub.run import AlarmError, Run, Stop
from cncsub.run_options import RunOptions
from cncsub.setup import Setup
from cncsub.stream import Part, Stream
from cncsub.tables.rows import (
    Call,
    Change,
    Compared,
    Dropped,
    MissedSkip,
    Move,
    Origin,
    SentCode,
    Step,
)
from cncsub.workpiece import Box, Cylinder, Plane, Sphere, Workpiece

if TYPE_CHECKING:
    from cncsub.analysis.endless import Endless, LoopBlock, Why
    from cncsub.analysis.flattening import Flat, FlattenError, flatten
    from cncsub.analysis.listing import Listed
    from cncsub.analysis.notes import Note
    from cncsub.archive.many import check_many, run_many
    from cncsub.checking import CheckRule, Edit, Finding, Flow, FlowEdge
    from cncsub.comparison.changes import BlockChange
    from cncsub.comparison.compare import Comparison, Difference, compare
    from cncsub.comparison.rewriting import TranslateError
    from cncsub.comparison.translate import Translation, translate
    from cncsub.references import CallGraph, CallTo, Computed, Edge, JumpTo, VariableUse
    from cncsub.reports.report import report
    from cncsub.resume import RestartState, Resume, ResumeError
    from cncsub.tables.polyline import Polyline
    from cncsub.variables_file import read_variables

# What most programs do not use is imported when it is asked for.
_LATER = {
    name: module
    for module, names in {
        "archive.many": "check_many run_many",
        "comparison.changes": "BlockChange",
        "checking": "CheckRule Edit Finding Flow FlowEdge",
        "comparison.compare": "Comparison Difference compare",
        "analysis.endless": "Endless LoopBlock Why",
        "analysis.flattening": "Flat FlattenError flatten",
        "analysis.listing": "Listed",
        "analysis.notes": "Note",
        "tables.polyline": "Polyline",
        "references": "CallGraph CallTo Computed Edge JumpTo VariableUse",
        "reports.report": "report",
        "resume": "RestartState Resume ResumeError",
        "comparison.rewriting": "TranslateError",
        "comparison.translate": "Translation translate",
        "variables_file": "read_variables",
    }.items()
    for name in names.split()
}


tell_engine_types()


def __getattr__(name: str) -> Any:
    if name not in _LATER:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"cncsub.{_LATER[name]}"), name)


def __dir__() -> list[str]:
    return list(__all__)


__all__ = [
    "Alarm",
    "AlarmError",
    "Alias",
    "Block",
    "BlockChange",
    "Box",
    "Breakpoint",
    "Call",
    "CallGraph",
    "CallTo",
    "Cause",
    "Change",
    "CheckRule",
    "Compared",
    "Comparison",
    "Computed",
    "Control",
    "Cylinder",
    "Difference",
    "Dropped",
    "Edge",
    "Edit",
    "Endless",
    "Finding",
    "Flat",
    "FlattenError",
    "Flow",
    "FlowEdge",
    "Frame",
    "Inputs",
    "JumpTo",
    "Library",
    "Listed",
    "LoopBlock",
    "Machine",
    "MissedSkip",
    "Move",
    "Note",
    "Origin",
    "Part",
    "Plane",
    "Polyline",
    "Program",
    "RestartState",
    "Resume",
    "ResumeError",
    "Run",
    "RunOptions",
    "SentCode",
    "Setup",
    "Source",
    "Sphere",
    "Step",
    "Stop",
    "Stream",
    "Token",
    "TranslateError",
    "Translation",
    "VariableUse",
    "Why",
    "Word",
    "Workpiece",
    "__version__",
    "aliases",
    "causes",
    "check_many",
    "compare",
    "control",
    "controls",
    "flatten",
    "load",
    "loads",
    "read_variables",
    "report",
    "run_many",
    "sources",
    "translate",
]
