"""The columns of the tables of a run: what each holds, and its unit. The documentation, Arrow and
Parquet take it from here.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import NamedTuple


class ColumnFacts(NamedTuple):
    """What a column holds, and its unit; empty where it has none.

    >>> import cncsub
    >>> run = cncsub.loads("O1\\nG0 X1.\\nM30\\n", control="fanuc-0i-f").run()
    >>> run.moves.column_facts["time"].unit, run.moves.column_facts["tool"].meaning
    ('s', 'number of the tool')
    """

    meaning: str
    unit: str = ""


_Facts = Mapping[str, ColumnFacts]

_BLOCK = {
    "program": ColumnFacts("program of the block"),
    "n": ColumnFacts("sequence number of the block; none where it has none"),
    "line": ColumnFacts("line of the block in its file, from 1"),
}
_STEP = {"step": ColumnFacts("number of the executed block, from 0: its row in the steps")}


def _axes(before: str, letters: str, meaning: str) -> dict[str, ColumnFacts]:
    return {
        f"{before}{axis}": ColumnFacts(meaning, "deg" if axis in "abc" else "mm")
        for axis in letters
    }


_AXES = "xyzabcuvw"
_END = "programmed end of the move, in the work coordinates in force; a diameter on a diameter axis"

_MOVES = {
    "move": ColumnFacts("number of the move, from 0"),
    **_STEP,
    "kind": ColumnFacts("rapid, feed, cw, ccw, thread or dwell"),
    **_axes("", _AXES, _END),
    **_axes("m", _AXES, "machine position of the tool at the end of the move, offsets included"),
    **{f"c{axis}": ColumnFacts("centre of the arc, in work coordinates", "mm") for axis in "xyz"},
    "plane": ColumnFacts("plane of arcs and cycles: 17, 18 or 19"),
    "feed": ColumnFacts("feed, in the unit that feed_mode names", "mm/min, mm/rev or 1/min"),
    "feed_mode": ColumnFacts("per-minute, per-revolution or inverse-time"),
    "spindle": ColumnFacts("speed of the spindle at the end of the move", "rev/min"),
    "tool": ColumnFacts("number of the tool"),
    "h": ColumnFacts("number of the length offset"),
    "d": ColumnFacts("number of the radius offset"),
    "length": ColumnFacts("length of the path", "mm"),
    "time": ColumnFacts(
        "duration; a spindle without a speed counts as one revolution per minute", "s"
    ),
    "skip": ColumnFacts("touched or missed for a move of G31, else no"),
    **_BLOCK,
    **_axes("s", "xyz", "start of the programmed path, in the work coordinates of its end"),
    **_axes("ms", "xyz", "machine position of the tool at the start of the move"),
    **{f"mc{axis}": ColumnFacts("centre of the arc of the tool, machine", "mm") for axis in "xyz"},
    "cycle": ColumnFacts("whether a canned cycle makes the move"),
    "compensated": ColumnFacts("whether a radius offset holds at the start or the end"),
}

# By the name that a table gives its rows.
_TABLES: Mapping[str, _Facts] = {
    "steps": {
        **_STEP,
        **_BLOCK,
        "depth": ColumnFacts("how many calls are open; 0 in the main program"),
        "frame": ColumnFacts("number of the call that the block runs in; -1 in the main program"),
        "repeat": ColumnFacts("pass of that call, from 1"),
        "text": ColumnFacts("the block as it is written"),
    },
    "calls": {
        "call": ColumnFacts("number of the call, from 0"),
        "parent": ColumnFacts("number of the call that it was made in; none in the main program"),
        "kind": ColumnFacts("what called, such as M98 or G65"),
        "program": ColumnFacts("called program"),
        "start_n": ColumnFacts("sequence number where the call begins; none for the first block"),
        "repeats": ColumnFacts("how many passes were asked for"),
        "level": ColumnFacts("level of the local variables in the call"),
        "first_step": ColumnFacts("number of its first executed block"),
        "last_step": ColumnFacts("number of its last executed block; none where it did not end"),
        "caller_step": ColumnFacts("number of the executed block that called"),
    },
    "moves": _MOVES,
    "changes": {
        "step": ColumnFacts("number of the step; none for a change from outside the program"),
        "variable": ColumnFacts("number of the variable"),
        "value": ColumnFacts("value after the step; none where the variable is vacant"),
        **_BLOCK,
    },
    "codes": {
        "kind": ColumnFacts("M, T or S"),
        "value": ColumnFacts("number of the code"),
        **_STEP,
        **_BLOCK,
    },
    "comparisons": {
        **_STEP,
        "left": ColumnFacts("value on the left, or the only one; none where it is vacant"),
        "operator": ColumnFacts("how the two are compared; empty for a condition of one value"),
        "right": ColumnFacts("value on the right; none where it is vacant or there is none"),
        "holds": ColumnFacts("whether the comparison is true"),
        **_BLOCK,
    },
    "blocks": {
        **_BLOCK,
        "call": ColumnFacts("number of the call that the block ran in; -1 in the main program"),
        "pass": ColumnFacts("pass of that call, from 1"),
    },
}


def facts_of(table: str, columns: Iterable[str]) -> dict[str, ColumnFacts]:
    """Return what the columns of a table hold."""
    facts = _TABLES[table]
    return {name: facts[name] for name in columns}


def all_facts(table: str) -> Mapping[str, ColumnFacts]:
    """Return what each column of a table holds, those too that only some runs have."""
    return _TABLES[table]
