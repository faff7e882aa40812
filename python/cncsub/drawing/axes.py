"""The axes of a drawing: where a point of the path lies on it, ticks at round numbers, the unit.

A millimetre is as long to the right as upwards.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from cncsub.drawing.path import View

    Numbers = np.ndarray[Any, np.dtype[Any]]

WIDTH = 480.0  # of a drawing, in its own units
_HIGHEST, _LOWEST = 380.0, 70.0  # heights of what is inside the axes
LEFT, RIGHT, TOP, BOTTOM = 54.0, 16.0, 24.0, 40.0  # the margins, which have room for words
_INSIDE = 14.0  # between the path and the axes
_TICKS_APART = 46.0  # at least
INCH = 25.4


def round_step(least: float) -> float:
    """Return the smallest of 1, 2, 5, 10, 20, ... (or 0.5, 0.2, ...) that is not below `least`."""
    power = 10.0 ** math.floor(math.log10(least))
    for factor in (1, 2, 5):
        if factor * power >= least * (1 - 1e-9):
            return factor * power
    return 10 * power


def tick_text(value: float, step: float) -> str:
    digits = max(0, -math.floor(math.log10(step) + 1e-9))
    return f"{value:.{digits}f}" if abs(value) > step / 2 else "0"


@dataclass(frozen=True)
class Tick:
    at: float  # in the units of the drawing
    text: str


class Frame:
    """Where the points of a view lie on the drawing."""

    def __init__(self, points: Numbers, view: View, *, diameters: bool, inch: bool) -> None:
        self.view = view
        self._columns = (view.right, view.up)
        flat = points[:, self._columns]
        self._low = flat.min(axis=0)
        self.extent = np.ptp(flat, axis=0)
        wide, high = (float(side) for side in self.extent)
        room = WIDTH - LEFT - RIGHT - 2 * _INSIDE
        tall = _HIGHEST - 2 * _INSIDE
        scales = [side / extent for side, extent in ((room, wide), (tall, high)) if extent > 1e-9]
        self.scale = min(scales, default=1.0)  # units of the drawing for a millimetre
        self.inner = max(_LOWEST, high * self.scale + 2 * _INSIDE)
        self.height = TOP + self.inner + BOTTOM
        # What is narrow lies in the middle.
        self._shift = np.array(
            [
                LEFT + _INSIDE + (room - wide * self.scale) / 2,
                TOP + (self.inner + high * self.scale) / 2,
            ]
        )
        self.unit = "inch" if inch else "mm"
        self._factors = [
            (2.0 if diameters and axis == 0 else 1.0) / (INCH if inch else 1.0)
            for axis in self._columns
        ]
        self.names = [
            f"{'XYZ'[axis]}{' diameter' if diameters and axis == 0 else ''}, {self.unit}"
            for axis in self._columns
        ]

    def placed(self, points: Numbers) -> Numbers:
        """Return points of the path, X Y Z, as places of the drawing."""
        flat = (np.asarray(points)[:, self._columns] - self._low) * self.scale
        flat[:, 1] = -flat[:, 1]
        placed: Numbers = flat + self._shift
        return placed

    def ticks(self, side: int) -> Iterator[Tick]:
        """Yield the ticks of the axis to the right (0) or upwards (1)."""
        per_unit = self.scale / self._factors[side]  # of the drawing for a unit of the axis
        step = round_step(_TICKS_APART / per_unit)
        zero = self._shift[side] + (1 if side else -1) * self._low[side] * self.scale
        begin, end = (TOP, TOP + self.inner) if side else (LEFT, WIDTH - RIGHT)
        direction = -1.0 if side else 1.0
        low, high = sorted(((begin - zero) * direction, (end - zero) * direction))
        first = math.ceil(low / per_unit / step - 1e-9)
        last = math.floor(high / per_unit / step + 1e-9)
        for number in range(first, last + 1):
            value = number * step
            yield Tick(zero + direction * value * per_unit, tick_text(value, step))

    def size_words(self) -> str:
        """Return how large the path is in the view."""
        factor = INCH if self.unit == "inch" else 1.0
        wide, high = (f"{float(side) / factor:.4g}" for side in self.extent)
        return f"{wide} x {high} {self.unit}"
