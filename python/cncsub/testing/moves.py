"""The language of motion rows, compared with `run.moves`: one line per move, in order.

    R X1 Y2 Z3               rapid to
    F X1                     feed to; an axis that is not named stays where it was
    T Z-20                   thread to
    CW X4 Y0 C X2 Y0         arc clockwise to, and its centre (CCW: counter-clockwise)
    W 1.5                    dwell, in seconds

End points are those of `run.moves`: work coordinates, diameters on a diameter axis.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

KINDS = {"R": "rapid", "F": "feed", "T": "thread", "CW": "cw", "CCW": "ccw", "W": "dwell"}
LETTERS = {kind: letter for letter, kind in KINDS.items()}
TOLERANCE = 0.001  # mm, and seconds of a dwell

_WORD = re.compile(r"([A-Z])([-+]?\d+(?:\.\d*)?|[-+]?\.\d+)")

Point = Mapping[str, float]


@dataclass(frozen=True)
class Move:
    """One expected move, or one the engine made; a point holds the axes it names."""

    kind: str
    end: Point = field(default_factory=dict)
    centre: Point = field(default_factory=dict)
    seconds: float = 0.0

    def __str__(self) -> str:
        if self.kind == "dwell":
            return f"W {self.seconds:.4g}"
        centre = f" C {write_point(self.centre)}" if self.centre else ""
        return f"{LETTERS.get(self.kind, self.kind)} {write_point(self.end)}{centre}"


def read_point(text: str) -> dict[str, float]:
    """Return `X10 Y-5` as a mapping; anything else is a `ValueError`."""
    point: dict[str, float] = {}
    for word in text.split():
        match = _WORD.fullmatch(word)
        if match is None or match[1] in point:
            raise ValueError(f"not a point: {text!r}")
        point[match[1]] = float(match[2])
    return point


def write_point(point: Point) -> str:
    # The sum with 0.0 turns a negative zero into a plain one.
    return " ".join(f"{axis}{round(value, 4) + 0.0:.10g}" for axis, value in point.items())


def read_moves(text: str) -> tuple[Move, ...]:
    """Return the moves of a row; an empty text and `none` say that nothing moves."""
    if text.strip() == "none":
        return ()
    return tuple(_read_move(line.strip()) for line in text.splitlines() if line.strip())


def _read_move(line: str) -> Move:
    letter, _, rest = line.partition(" ")
    kind = KINDS.get(letter)
    if kind is None:
        raise ValueError(f"not a kind of move: {line!r}")
    if kind == "dwell":
        return Move(kind, seconds=float(rest))
    end, is_arc, centre = rest.partition("C ")
    if bool(is_arc) != (kind in ("cw", "ccw")):
        raise ValueError(f"a centre belongs to an arc, and an arc has one: {line!r}")
    if not end.strip():
        raise ValueError(f"a move without an end: {line!r}")
    return Move(kind, read_point(end), read_point(centre))


def made_moves(table: Any) -> list[Move]:
    """Return the rows of `run.moves`, with every axis and centre that is a number."""
    kinds = [table.kinds[code] for code in table.kind.tolist()]
    axes = {axis: getattr(table, axis.lower()).tolist() for axis in _axes(table)}
    centres = {axis: getattr(table, f"c{axis.lower()}").tolist() for axis in "XYZ"}
    seconds = table.time.tolist()
    return [
        Move(kind, _numbers(axes, row), _numbers(centres, row), seconds[row])
        for row, kind in enumerate(kinds)
    ]


def _axes(table: Any) -> list[str]:
    return [axis for axis in "XYZABCUVW" if hasattr(table, axis.lower())]


def _numbers(columns: Mapping[str, Sequence[float]], row: int) -> dict[str, float]:
    return {axis: column[row] for axis, column in columns.items() if not math.isnan(column[row])}


def resolve(expected: Sequence[Move], start: Point) -> list[Move]:
    """Give every expected move its whole end point: an axis that is not named stays."""
    place = dict(start)
    whole = []
    for move in expected:
        place.update(move.end)
        whole.append(Move(move.kind, dict(place), move.centre, move.seconds))
    return whole


def agrees(expected: Move, made: Move) -> bool:
    if expected.kind != made.kind:
        return False
    if expected.kind == "dwell":
        return abs(expected.seconds - made.seconds) <= TOLERANCE
    return near(expected.end, made.end) and near(expected.centre, made.centre)


def near(expected: Point, made: Point, tolerance: float = TOLERANCE) -> bool:
    """Return whether every axis that is named lies where it should."""
    return all(
        axis in made and abs(value - made[axis]) <= tolerance for axis, value in expected.items()
    )


def compare(expected: Sequence[Move], made: Sequence[Move], start: Point) -> Iterator[str]:
    """Yield where the moves part, both lists side by side; nothing if they agree."""
    whole = resolve(expected, start)
    if len(whole) == len(made) and all(map(agrees, whole, made)):
        return
    lines = ["moves (expected | got):"]
    for row in range(max(len(whole), len(made))):
        wanted = str(whole[row]) if row < len(whole) else "-"
        got = str(made[row]) if row < len(made) else "-"
        same = row < min(len(whole), len(made)) and agrees(whole[row], made[row])
        lines.append(f"  {' ' if same else '>'} {wanted:<40} | {got}")
    yield "\n".join(lines)
