"""Lines and arcs in a plane as arrays: points, directions, distances, independent of the engine."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]


@dataclass(frozen=True)
class Curve:
    """A line, or an arc that runs through `turn` (plus = counter-clockwise) about its centre.

    The radius of an arc changes evenly if its ends do not lie equally far from the centre.
    """

    start: Vector
    end: Vector
    centre: Vector | None = None
    turn: float = 0.0

    @property
    def length(self) -> float:
        if self.centre is None:
            return float(np.hypot(*(self.end - self.start)))
        return abs(self.turn) * float(np.hypot(*(self.start - self.centre)))

    @property
    def radius(self) -> float:
        """The radius, infinite for a line."""
        if self.centre is None:
            return math.inf
        ends = np.stack([self.start, self.end]) - self.centre
        return float(np.hypot(ends[:, 0], ends[:, 1]).min())

    def points(self, parts: Vector) -> Vector:
        """Return the points at parts 0 to 1 of the length."""
        if self.centre is None:
            return np.asarray(self.start + parts[:, None] * (self.end - self.start))
        first, last = self.start - self.centre, self.end - self.centre
        angles = math.atan2(first[1], first[0]) + self.turn * parts
        radii = np.hypot(*first) + parts * (np.hypot(*last) - np.hypot(*first))
        return np.asarray(self.centre + (radii * np.array([np.cos(angles), np.sin(angles)])).T)

    def directions(self, parts: Vector) -> Vector:
        if self.centre is None:
            way = self.end - self.start
            return np.broadcast_to(way / np.hypot(*way), (len(parts), 2))
        radius = self.points(parts) - self.centre
        radius = radius / np.hypot(radius[:, 0], radius[:, 1])[:, None]
        return np.asarray(math.copysign(1, self.turn) * np.stack([-radius[:, 1], radius[:, 0]], 1))

    def turned(self, angle: float, by: Vector) -> Curve:
        matrix = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
        centre = None if self.centre is None else matrix @ self.centre + by
        return Curve(matrix @ self.start + by, matrix @ self.end + by, centre, self.turn)

    def distances(self, points: Vector) -> Vector:
        """Return how far points are from the curve."""
        if self.centre is None:
            way = self.end - self.start
            size = float(way @ way)
            part = (
                np.clip((points - self.start) @ way / size, 0, 1) if size > 0 else 0 * points[:, 0]
            )
            return np.asarray(np.hypot(*(points - self.start - part[:, None] * way).T))
        radius, first, last = points - self.centre, self.start - self.centre, self.end - self.centre
        ends = np.minimum(np.hypot(*(points - self.start).T), np.hypot(*(points - self.end).T))
        angle = np.arctan2(radius[:, 1], radius[:, 0]) - math.atan2(first[1], first[0])
        part = np.mod(angle * math.copysign(1, self.turn), 2 * math.pi) / abs(self.turn)
        on = np.hypot(*first) + part * (np.hypot(*last) - np.hypot(*first))
        on_arc = np.abs(np.hypot(*radius.T) - on)
        return np.asarray(np.where(part <= 1, np.minimum(on_arc, ends), ends))


def distances(points: Vector, curves: Sequence[Curve]) -> Vector:
    """Return how far points (rows) are from curves (columns)."""
    return np.stack([curve.distances(points) for curve in curves], axis=1)


def sweep(first: Any, last: Any, left: bool) -> float:
    """Return the angle from one radius to another, run through in the given direction."""
    angle = math.atan2(last[1], last[0]) - math.atan2(first[1], first[0])
    angle = math.remainder(angle, 2 * math.pi)
    if np.hypot(*(np.asarray(first) - np.asarray(last))) < 1e-9:
        angle = 0.0
    if left:
        return angle if angle > 0 else angle + 2 * math.pi
    return angle if angle < 0 else angle - 2 * math.pi
