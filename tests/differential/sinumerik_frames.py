"""Frames as values: chains of them and their parts, by the manual. [SONE p.631-640]"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from sinumerik_arithmetic import IDENTITY, Matrix, UnclearError, diagonal, product, turned

AXES = "XYZ"
Point = tuple[float, float, float]
NONE: Point = (0.0, 0.0, 0.0)
SMALLEST = 1e-60  # the least scale of a frame
EDGE = 0.5  # degrees before a range of angles ends: what is read beyond it is another angle


@dataclass(frozen=True)
class FrameValue:
    """Points are turned, scaled and mirrored by `turn`, then shifted, twice."""

    turn: Matrix = IDENTITY
    shift: Point = NONE
    fine: Point = NONE
    mirrored: frozenset[int] = frozenset()

    @property
    def whole(self) -> Point:
        return added(self.shift, self.fine)


UNCHANGED = FrameValue()


def added(one: Point, other: Point) -> Point:
    return one[0] + other[0], one[1] + other[1], one[2] + other[2]


def applied(turn: Matrix, point: Point) -> Point:
    x, y, z = (sum(row[j] * point[j] for j in range(3)) for row in turn)
    return x, y, z


def chained(outer: FrameValue, inner: FrameValue) -> FrameValue:
    """Return a frame that lies in another one."""
    turn = product(outer.turn, inner.turn)
    if max(abs(cell) for row in turn for cell in row) < SMALLEST:
        raise UnclearError  # hardly anything is left of a length
    return FrameValue(
        turn,
        added(outer.shift, applied(outer.turn, inner.shift)),
        added(outer.fine, applied(outer.turn, inner.fine)),
        outer.mirrored ^ inner.mirrored,
    )


def made(name: str, values: dict[int, float]) -> FrameValue:
    """Return the frame of a function, by the values of the axes that it names."""
    given: Point = (values.get(0, 0.0), values.get(1, 0.0), values.get(2, 0.0))
    match name:
        case "CTRANS":
            return FrameValue(shift=given)
        case "CFINE":
            return FrameValue(fine=given)
        case "CROT":
            return FrameValue(_of_angles(list(given)))
        case "CSCALE":
            return FrameValue(diagonal([values.get(n, 1.0) for n in range(3)]))
    mirrored = frozenset(values)
    return FrameValue(diagonal(_signs(mirrored)), mirrored=mirrored)


def _signs(mirrored: frozenset[int]) -> list[float]:
    return [-1.0 if n in mirrored else 1.0 for n in range(3)]


def _of_angles(angles: list[float]) -> Matrix:
    turn = IDENTITY
    for axis in "ZYX":
        turn = product(turn, turned(axis, angles[AXES.index(axis)]))
    return turn


def parts(of: FrameValue) -> tuple[list[float], list[float]]:
    """Return the angles about X, Y and Z and the factors of a frame."""
    columns = [[of.turn[i][j] for i in range(3)] for j in range(3)]
    factors = [math.hypot(*column) for column in columns]
    signs = _signs(of.mirrored)
    turn = [[columns[j][i] / factors[j] * signs[j] for j in range(3)] for i in range(3)]
    if any(
        abs(sum(turn[i][a] * turn[i][b] for i in range(3))) > 1e-9
        for a, b in ((0, 1), (0, 2), (1, 2))
    ):
        raise UnclearError  # it shears
    y = math.degrees(math.asin(max(-1.0, min(1.0, -turn[2][0]))))
    x = math.degrees(math.atan2(turn[2][1], turn[2][2]))
    z = math.degrees(math.atan2(turn[1][0], turn[0][0]))
    if abs(y) > 90 - EDGE or max(abs(x), abs(z)) > 180 - EDGE:
        raise UnclearError
    return [x, y, z], factors


def part(of: FrameValue, axis: int, name: str) -> float:
    match name:
        case "TR":
            return of.shift[axis]
        case "FI":
            return of.fine[axis]
        case "MI":
            return float(axis in of.mirrored)
    angles, factors = parts(of)
    return angles[axis] if name == "RT" else factors[axis]


def with_part(of: FrameValue, axis: int, name: str, value: float) -> FrameValue:
    """Return the frame with another value of a part."""

    def put(point: Point) -> Point:
        x, y, z = (value if n == axis else point[n] for n in range(3))
        return x, y, z

    match name:
        case "TR":
            return replace(of, shift=put(of.shift))
        case "FI":
            return replace(of, fine=put(of.fine))
    angles, factors = parts(of)
    mirrored = of.mirrored
    if name == "RT":
        angles[axis] = value
    else:
        mirrored = mirrored | {axis} if value else mirrored - {axis}
    signs = _signs(mirrored)
    scale = diagonal([factor * sign for factor, sign in zip(factors, signs, strict=True)])
    return replace(of, turn=product(_of_angles(angles), scale), mirrored=mirrored)
