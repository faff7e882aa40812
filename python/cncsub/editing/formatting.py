"""The layout of programs: blanks, indentation, capitals and decimal points."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Literal

from cncsub import _core
from cncsub.checking import Edit
from cncsub.controls import rule_value
from cncsub.editing.edits import Edits, known_files, listed
from cncsub.library import Library
from cncsub.option_errors import carrying

Spacing = Literal["one", "none", "keep"]
SPACINGS = ("one", "none", "keep")
MOST_INDENT = 16


def format(
    library: Library,
    files: Iterable[str] | None = None,
    *,
    spacing: Spacing = "one",
    indent: int | None = 2,
    capitals: bool = True,
    points: bool = False,
) -> Edits:
    """Return the edits that lay out the blocks of programs alike. The order of words, the comments,
    the texts between quotes and the lines stay as they are, and so do blocks that the control
    refuses.

    What a block prints as it is written, as `DPRNT[...]`, stays too.

    `files`: names as in `library.files`; all without it. `spacing`: `"one"` blank between two
    words, `"none"`, or `"keep"`. `indent`: so many blanks before a block for each loop, branch and
    subprogram around it; `None` leaves them. `capitals`: small letters become capitals. `points`:
    `X10` of a block that only moves becomes `X10.` on a control where both mean 10 mm; where `X10`
    means ten increments, it stays, and `Edits.notes` says so.

    Each block is read again: one that would be read otherwise stays as it is, and is told in
    `Edits.notes`. Formatting a second time changes nothing.

    >>> import cncsub
    >>> from cncsub.editing import format
    >>> text = "O1\\n#1=0\\nWHILE[#1LT3]DO1\\ng91g1x10f100(cut)\\n#1=#1+1\\nEND1\\nM30\\n"
    >>> print(format(cncsub.loads(text, control="fanuc-0i-f")).texts["<text>"], end="")
    O1
    #1=0
    WHILE[#1LT3]DO1
      G91 G1 X10 F100 (cut)
      #1=#1+1
    END1
    M30
    """
    _check(spacing, indent)
    known = None if files is None else known_files(library, files)
    edits: list[Edit] = []
    notes: list[str] = []
    blanks = -1 if indent is None else indent
    for name, _, _, outside in library.code.sources:
        if outside or (known is not None and name not in known):
            continue
        rows, left = _core.formatted(library.code, name, spacing, blanks, capitals, points)
        edits += [Edit(name, *row) for row in rows]
        if left:
            what = "line" if len(left) == 1 else "lines"
            notes.append(
                f"{name}: {what} {listed(left)} would be read otherwise, and stay as they are"
            )
    if points and rule_value(library.control, "whole_numbers") != "millimetres":
        notes.append(
            "a length without a point counts increments on this control: no point is added"
        )
    return Edits(library, tuple(edits), tuple(notes))


def _check(spacing: str, indent: int | None) -> None:
    if spacing not in SPACINGS:
        raise carrying(
            "spacing", ValueError(f"spacing must be {', '.join(SPACINGS)}, not {spacing!r}")
        )
    if indent is None:
        return
    if isinstance(indent, bool) or not isinstance(indent, int):
        raise carrying("indent", TypeError(f"indent must be a whole number, not {indent!r}"))
    if not 0 <= indent <= MOST_INDENT:
        raise carrying("indent", ValueError(f"indent must be 0 to {MOST_INDENT}, not {indent}"))
