"""The path of a run as points: `run.polyline(tolerance)`."""

from __future__ import annotations

import functools
import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from cncsub import _core
from cncsub.option_errors import carrying

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

    The last point of a move is its end. Rotary axes are left out.
    """

    x: Numbers
    y: Numbers
    z: Numbers
    move: np.ndarray[Any, np.dtype[np.int64]]
    begins: np.ndarray[Any, np.dtype[np.bool_]]
    coordinates: str
    tolerance: float
    diameters: bool

    @functools.cached_property
    def points(self) -> Numbers:
        """X, Y and Z side by side: an array of `len(polyline)` rows and three columns."""
        import numpy as np

        made = np.column_stack((self.x, self.y, self.z))
        made.flags.writeable = False  # the record of a run cannot be changed
        return made

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
            " use a wider one, or fewer moves: moves=slice(0, 1000)"
        )
    return found


def sampled(
    core: _core.Trace, coordinates: str, tolerance: float, first: int, last: int, most: int
) -> Polyline | int:
    """Return the points, or how many they would be where that is more than `most`."""
    import numpy  # noqa: F401  # here, not below the engine's functions

    if coordinates not in COORDINATES:
        raise carrying(
            "coordinates",
            ValueError(f"coordinates must be one of {', '.join(COORDINATES)}, not {coordinates!r}"),
        )
    found = core.polyline(coordinates, tolerance, first, last, most)
    if isinstance(found, int):
        return found
    for column in found:
        column.flags.writeable = False  # the record of a run cannot be changed
    x, y, z, move, begins = found
    return Polyline(x, y, z, move, begins, coordinates, tolerance, bool(core.diameters & 1))


_LONG = 200_000  # moves from which arcs are sampled no finer than a picture shows
_FINE, _COARSE = 1 / 20_000, 1 / 2_000  # of the size of a picture
_STRETCHES, STRETCH = 16, 4_096  # sampled stretches of a long path, and the moves of each


def sampling(
    core: _core.Trace, coordinates: str, first: int, last: int, most: int, size: float
) -> tuple[float, bool]:
    """Return the tolerance (mm) at which arcs are as fine as a picture of a size shows them, or a
    coarser one where there were more than `most` points; and whether the coarser one can be seen.
    """
    tolerance = size * (_COARSE if last - first > _LONG else _FINE)
    while tolerance <= size and points_about(core, coordinates, first, last, tolerance) > most:
        tolerance *= 4  # four points in a turn are as few as there are
    return tolerance, tolerance > size * _COARSE


def points_about(
    core: _core.Trace, coordinates: str, first: int, last: int, tolerance: float
) -> int:
    """Return how many points a path has; of a long path, an estimate from stretches of it."""

    def count(begin: int, end: int) -> int:
        found = core.polyline(coordinates, tolerance, begin, end, 0)
        return found if isinstance(found, int) else 0

    begins = stretches(first, last)
    if not begins:
        return count(first, last)
    counted = sum(count(begin, begin + STRETCH) for begin in begins)
    return counted * (last - first) // (len(begins) * STRETCH)


def stretches(first: int, last: int) -> list[int]:
    """Return the first moves of the stretches that stand for a long path; none for a short one."""
    if last - first <= _LONG:
        return []
    room = last - first - STRETCH
    return [first + room * i // (_STRETCHES - 1) for i in range(_STRETCHES)]


def rough_size(core: _core.Trace, coordinates: str, first: int, last: int) -> float:
    """Return the longest side of the box around a path, mm; 1 where the path is one point. A whole
    long path is measured by its programmed path.
    """
    if last - first <= _LONG:
        line = sampled(core, coordinates, math.inf, first, last, 1 << 40)
        assert not isinstance(line, int)
        return size_of(line)
    if (first, last) == (0, core.moves) and coordinates != "machine":
        sides = (high - low for axis, (low, high) in core.bounds.items() if axis in "xyz")
        return max(sides, default=0.0) or 1.0
    import numpy as np

    before = "m" if coordinates == "machine" else ""
    columns = core.move_columns([before + name for name in "xyz"])
    return max(float(np.ptp(column[first:last])) for column in columns.values()) or 1.0


def size_of(line: Polyline) -> float:
    """Return the longest side of the box around a path, mm; 1 where the path is one point."""
    return (
        max((float(c.max() - c.min()) for c in (line.x, line.y, line.z) if len(c)), default=0)
        or 1.0
    )


def checked_tolerance(tolerance: Any) -> float:
    if isinstance(tolerance, bool) or not hasattr(tolerance, "__float__"):
        raise TypeError(f"tolerance must be a length in mm such as 0.01, not {tolerance!r}")
    try:
        value = float(tolerance)
    except OverflowError:
        value = math.inf
    if not 0 < value < math.inf:
        raise ValueError(f"tolerance must be a length in mm above 0, not {tolerance!r}")
    return value


def rows_of(moves: Any, count: int) -> tuple[int, int]:
    """Return the first of some rows and the one after the last."""
    if moves is None:
        return 0, count
    if isinstance(moves, range):
        moves = slice(moves.start, moves.stop, moves.step)
    if not isinstance(moves, slice):
        raise TypeError(f"moves must be a slice or a range such as range(0, 1000), not {moves!r}")
    first, last, step = moves.indices(count)
    if step != 1:
        raise ValueError(f"moves must be a range without a step, not {moves!r}")
    return first, max(first, last)
