"""The path of a run as points: `run.polyline(tolerance)`."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from cncsub import _core

if TYPE_CHECKING:
    import numpy as np

    Numbers = np.ndarray[Any, np.dtype[np.float64]]

COORDINATES = ("work", "tool", "machine")
MOST_POINTS = 50_000_000  # that arcs add to the ends of the moves


@dataclass(frozen=True, eq=False)
class Polyline:
    """The path of the moves as points, a row of each array for one point.

    `x`, `y`, `z`: mm; on a diameter axis the radius, so that lengths and angles are true. `move`:
    the move that a point belongs to, its row in `run.moves`. `begins`: whether the path begins anew
    at the point, so that no line leads to it: at the first one, and where other work coordinates
    came into force. `coordinates`, `tolerance`: as asked for. `diameters`: whether X of the program
    is a diameter.

    The last point of a move is its end. Axes that turn are not looked at.
    """

    x: Numbers
    y: Numbers
    z: Numbers
    move: np.ndarray[Any, np.dtype[np.int64]]
    begins: np.ndarray[Any, np.dtype[np.bool_]]
    coordinates: str
    tolerance: float
    diameters: bool

    @property
    def points(self) -> Numbers:
        """X, Y and Z side by side: an array of `len(polyline)` rows and three columns."""
        import numpy as np

        return np.column_stack((self.x, self.y, self.z))

    def __len__(self) -> int:
        return len(self.x)

    def __repr__(self) -> str:
        return (
            f"<Polyline: {len(self):,} points, {self.coordinates} coordinates,"
            f" within {self.tolerance:g} mm>"
        )


def polyline_of(
    core: _core.Trace, tolerance: float, coordinates: str, moves: slice | range | None
) -> Polyline:
    checked = checked_tolerance(tolerance)
    first, last = rows_of(moves, core.moves)
    most = last - first + MOST_POINTS
    found = sampled(core, coordinates, checked, first, last, most)
    if isinstance(found, int):
        raise ValueError(
            f"tolerance={tolerance!r} makes more than {most:,} points of {last - first:,} moves;"
            " take a wider one, or fewer moves: moves=slice(0, 1000)"
        )
    return found


def sampled(
    core: _core.Trace, coordinates: str, tolerance: float, first: int, last: int, most: int
) -> Polyline | int:
    """The points, or how many they would be where that is more than `most`."""
    import numpy  # noqa: F401  # here, not below the engine's functions

    if coordinates not in COORDINATES:
        raise ValueError(f"coordinates is one of {', '.join(COORDINATES)}, not {coordinates!r}")
    found = core.polyline(coordinates, tolerance, first, last, most)
    if isinstance(found, int):
        return found
    for column in found:
        column.flags.writeable = False  # what ran cannot be changed
    x, y, z, move, begins = found
    return Polyline(x, y, z, move, begins, coordinates, tolerance, bool(core.diameters & 1))


_LONG = 200_000  # moves from which arcs are sampled no finer than a picture shows
_FINE, _COARSE = 1 / 20_000, 1 / 2_000  # of the size of a picture


def sampled_for_picture(
    core: _core.Trace, coordinates: str, first: int, last: int, most: int
) -> tuple[Polyline, bool]:
    """The points as finely as a picture shows them, more coarsely where they were more than `most`;
    and whether that can be seen.
    """
    long = last - first > _LONG
    size = _rough_size(core, coordinates, first, last, long)
    tolerance = size * (_COARSE if long else _FINE)
    while True:
        line = sampled(core, coordinates, tolerance, first, last, most)
        if not isinstance(line, int):
            return line, tolerance > size * _COARSE
        if tolerance > size:  # four points in a turn are as few as there are
            most = line
        tolerance *= 4


def _rough_size(core: _core.Trace, coordinates: str, first: int, last: int, long: bool) -> float:
    import numpy as np

    if not long:
        line = sampled(core, coordinates, math.inf, first, last, 1 << 40)
        assert not isinstance(line, int)
        return size_of(line)
    before = "m" if coordinates == "machine" else ""
    columns = core.move_columns([before + name for name in "xyz"])
    return max(float(np.ptp(column[first:last])) for column in columns.values()) or 1.0


def size_of(line: Polyline) -> float:
    """The longest side of the box around a path, mm; 1 where it does not leave its point."""
    return (
        max((float(c.max() - c.min()) for c in (line.x, line.y, line.z) if len(c)), default=0)
        or 1.0
    )


def checked_tolerance(tolerance: Any) -> float:
    if isinstance(tolerance, bool) or not hasattr(tolerance, "__float__"):
        raise TypeError(f"tolerance is a length in mm such as 0.01, not {tolerance!r}")
    try:
        value = float(tolerance)
    except OverflowError:
        value = math.inf
    if not 0 < value < math.inf:
        raise ValueError(f"tolerance is a length in mm above 0, not {tolerance!r}")
    return value


def rows_of(moves: Any, count: int) -> tuple[int, int]:
    """The first of some rows and the one behind the last."""
    if moves is None:
        return 0, count
    if isinstance(moves, range):
        moves = slice(moves.start, moves.stop, moves.step)
    if not isinstance(moves, slice):
        raise TypeError(f"moves is a slice or a range such as range(0, 1000), not {moves!r}")
    first, last, step = moves.indices(count)
    if step != 1:
        raise ValueError(f"moves lie one behind the other, without a step: not {moves!r}")
    return first, max(first, last)
