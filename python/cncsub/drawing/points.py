"""The points of a path that a picture draws: as many as it may, and notes on the rest."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np

from cncsub import _core
from cncsub.tables.polyline import STRETCH, points_about, rough_size, sampling, stretches

Numbers = np.ndarray[Any, np.dtype[Any]]

_FINEST, _WIDEST = 1 / 20_000, 1 / 250  # of the size of the picture: first and last tolerance
_MOST_LOOKS = 4_000_000  # places looked at to find lines that run over each other


@dataclass(frozen=True)
class Points:
    """Points of a path, in order."""

    x: Numbers
    y: Numbers
    z: Numbers
    move: Numbers
    key: Numbers  # the line that leads to the point; -1: no line does
    time: Numbers  # s until the point is reached

    def __len__(self) -> int:
        return len(self.x)

    def at(self, places: Any) -> Points:
        return Points(*(getattr(self, one.name)[places] for one in fields(self)))

    @property
    def columns(self) -> tuple[Numbers, Numbers, Numbers]:
        return self.x, self.y, self.z


@dataclass(frozen=True)
class Drawn:
    """The points that are drawn, and notes on the rest."""

    points: Points
    told: list[str]
    breaks: int  # how often other coordinates came into force
    behind: int | None = None  # the last move that is drawn, where the path is cut

    @property
    def keys(self) -> Numbers:
        return self.points.key

    @property
    def xyz(self) -> Numbers:
        """X, Y and Z side by side."""
        return np.column_stack(self.points.columns)


def drawn_path(
    core: _core.Trace, coordinates: str, rows: tuple[int, int], keys: Numbers, most: int
) -> Drawn:
    """Return the points to draw of the moves `rows` (the first, and the one after the last), at
    most `most` points. `keys`: for each move the key of its line, a number from 0 below 4,096, or
    -1 where it is not drawn.
    """
    first, last = rows
    size = rough_size(core, coordinates, first, last)
    fine, coarse = sampling(core, coordinates, first, last, max(4 * most, 3 * (last - first)), size)
    told = [f"Arcs are drawn within {_length(fine)}."] if coarse else []
    path = _Path(core, coordinates, fine, first, keys)
    tolerance, looked = 0.0, last
    if points_about(core, coordinates, first, last, fine) > most:
        tolerance, looked = path.tolerance(last, size, most)
    points, whole, begins = path.points(first, looked, tolerance)
    points, off = _thinned(core, points, tolerance, size, most)
    if len(points) < whole:
        told.append(
            f"Thinned: {len(points):,} of {whole:,} points; what is left out lies within"
            f" {_length(off)} of what is drawn."
        )
    end = int(points.move[-1]) if looked == last else None
    points = _uncovered(points, size, most, told).at(slice(most))
    behind = int(points.move[-1])
    return Drawn(points, told, begins - 1, None if behind == end else behind)


class _Path:
    """A path from which points are taken."""

    def __init__(
        self, core: _core.Trace, coordinates: str, fine: float, first: int, keys: Numbers
    ) -> None:
        self._core = core
        self._of = (coordinates, fine)
        self._first = first
        self._keys = keys

    def points(self, first: int, last: int, tolerance: float) -> tuple[Points, int, int]:
        """Return enough points of some moves for the tolerance, how many points there are in all,
        and at how many of them the path begins anew.
        """
        keys = self._keys[first - self._first : last - self._first]
        *columns, whole, begins = self._core.outline(*self._of, tolerance, first, last, keys)
        return Points(*columns), whole, begins

    def _twice(self, first: int, last: int, tolerance: float) -> Points:
        """Return the points as `points` does, thinned a second time."""
        points, _, _ = self.points(first, last, tolerance)
        return points.at(self._core.thinned(*points.columns, points.key, tolerance))

    def tolerance(self, last: int, size: float, most: int) -> tuple[float, int]:
        """Return the tolerance to begin with, and the move up to which there is time to look. In a
        long path both are estimated from stretches.
        """
        widest, tolerance = size * _WIDEST, size * _FINEST
        begins = stretches(self._first, last)
        if not begins:
            return tolerance, last
        share = len(begins) * STRETCH / (last - self._first)
        while True:
            some = [self._twice(begin, begin + STRETCH, tolerance) for begin in begins]
            if sum(map(len, some)) <= most * share:
                return tolerance, last
            if tolerance == widest:
                break
            tolerance = min(2 * tolerance, widest)
        looks = sum(int(_looks(points.columns, widest).sum()) for points in some) / share
        part = min(1.0, 1.5 * _MOST_LOOKS / looks)  # more would not be looked at
        return widest, self._first + max(STRETCH, int((last - self._first) * part))


def _thinned(
    core: _core.Trace, points: Points, tolerance: float, size: float, most: int
) -> tuple[Points, float]:
    """Thin the points with wider and wider tolerances until there are few enough. Return them, and
    how far the points left out may lie from them. The points were already thinned with `tolerance`.
    """
    off, begun, looks, widest = tolerance, len(points), 1, size * _WIDEST
    while len(points) > most:
        if looks == 2 or tolerance == 0:  # a second look finds what windows hid from the first
            if tolerance >= widest:
                break
            many = len(points) > max(50 * most, 0.9 * begun)  # most of the path goes back and forth
            wider = tolerance * (1.5 if len(points) < 4 * most else 3)
            tolerance = widest if many else min(wider or size * _FINEST, widest)
            looks = 0
        before = len(points)
        points = points.at(core.thinned(*points.columns, points.key, tolerance))
        off += tolerance
        looks = 2 if len(points) > 0.8 * before else looks + 1
    return points, off


def _uncovered(points: Points, size: float, most: int, told: list[str]) -> Points:
    """Drop lines that run where others of their colour do already, as far as a picture shows. Lines
    that there is no time to look at are cut.
    """
    if len(points) <= most:
        return points
    cell = size * _WIDEST
    points = points.at(slice(_looked_at(points.columns, cell)))
    new = _new_lines(points.columns, points.key, cell)
    told.append(f"Lines within {_length(cell * 2)} of a line of the same colour are left out.")
    ends = np.append(new[1:], False) | new  # the points that lines need
    ends[-1] = True
    drawn = replace(points, key=np.where(new, points.key, -1).astype(np.int32))
    return drawn.at(ends)


def _length(mm: float) -> str:
    digit = 10.0 ** (math.floor(math.log10(mm)) - 1)
    return f"{math.ceil(mm / digit - 1e-9) * digit:.2g} mm"  # rounded up


def _looks(at: tuple[Numbers, Numbers, Numbers], cell: float) -> Numbers:
    """Return how many places to look at along the line to each point but the first."""
    way = np.sqrt(sum(np.diff(column) ** 2 for column in at))
    looks: Numbers = np.ceil(way / (cell / 2)).astype(np.int64) + 1
    return looks


def _looked_at(at: tuple[Numbers, Numbers, Numbers], cell: float) -> int:
    """Return how many points there is time to look at."""
    x, y, z = (column[: _MOST_LOOKS + 1] for column in at)  # each takes one look at least
    looks = np.cumsum(_looks((x, y, z), cell))
    return int(np.searchsorted(looks, _MOST_LOOKS, side="right")) + 1


def _new_lines(at: tuple[Numbers, Numbers, Numbers], key: Numbers, cell: float) -> Numbers:
    """Return which points have a line that goes where no earlier line of its key went, by cells of
    a grid.
    """
    x, y, z = at
    count_of = len(x)
    looks = _looks(at, cell)
    line = np.repeat(np.arange(1, count_of), looks)
    begun = np.cumsum(looks) - looks
    part = (np.arange(len(line)) - np.repeat(begun, looks)) / np.repeat(looks, looks)
    codes = np.zeros(len(line), dtype=np.int64)
    for column in (x, y, z):
        low = float(column.min())
        here = column[line - 1] + (column[line] - column[line - 1]) * part
        codes = codes * 1_024 + np.floor((here - low) / cell).astype(np.int64)
    codes = codes * 4_096 + key[line]
    _, first = np.unique(codes, return_index=True)
    new = np.zeros(count_of, dtype=bool)
    new[line[first]] = True
    return new & (key >= 0)


def line_runs(mask: Numbers, keys: Numbers) -> tuple[Numbers, Numbers]:
    """Return the points of the marked lines as places in the path, and which of them are starts.
    Each run begins with its start, and -1 stands between two runs. A run ends where the key
    changes.
    """
    marked = np.flatnonzero(mask)
    marked = marked[marked > 0]
    if not len(marked):
        return np.zeros(0, dtype=np.int64), np.zeros(0, dtype=bool)
    fresh = np.ones(len(marked), dtype=bool)
    fresh[1:] = (np.diff(marked) != 1) | (keys[marked[1:]] != keys[marked[:-1]])
    at = np.flatnonzero(fresh)
    # Before each start stand a gap and the point that the line comes from.
    doubled = np.repeat(at, 2)
    added = np.column_stack((np.full(len(at), -1), marked[at] - 1)).ravel()
    places = np.insert(marked, doubled, added)
    starts = np.insert(np.zeros(len(marked), dtype=bool), doubled, np.tile([False, True], len(at)))
    return places[1:], starts[1:]
