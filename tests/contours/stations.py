"""The controls with compensation, as mills and lathes, and the text of a contour for each."""

from __future__ import annotations

import math
from dataclasses import dataclass
from random import Random

import numpy as np

import cncsub
from cncsub.questions.asking import ISO_FAMILY
from curves import Curve, Vector, sweep
from drawing import Drawing

INCH = 25.4
PLANES = {17: "XYIJZ", 18: "ZXKIY", 19: "YZJKX"}
# The distance from the centre of the nose to the imaginary tip, as Z and X.
TIPS = [(0, 0), (1, 1), (-1, 1), (-1, -1), (1, -1), (1, 0), (0, 1), (-1, 0), (0, -1), (0, 0)]
NO_INCH = {"gsk-980tdi"}
# No source describes radius compensation for these controls, or the engine does not compute it.
# LinuxCNC begins beside its own line and goes around outside corners in arcs, so it is compared
# with its interpreter.
OTHERS = (name for name, of in cncsub.controls.items() if of.dialect not in ISO_FAMILY)
NONE = {"gsk-928te", *OTHERS}


@dataclass(frozen=True)
class Station:
    control: str
    machine: str
    parameters: tuple[tuple[str, float], ...] = ()

    def __str__(self) -> str:
        return " ".join([self.control, self.machine, *(f"{k}={v}" for k, v in self.parameters)])

    @property
    def lathe(self) -> bool:
        return self.machine != "mill"

    @property
    def cuts_fine_digits(self) -> bool:
        rules = cncsub.controls[self.control].rules
        return any(rule.name == "cuts_fine_digits" and rule.value is True for rule in rules)

    def made(self) -> cncsub.Control:
        return cncsub.controls[self.control].with_parameters(dict(self.parameters))


def stations() -> list[Station]:
    found = []
    for name in [name for name in cncsub.controls if name not in NONE]:
        if name not in ("gsk-980mdi", "hnc-21m") and not name.startswith("mitsubishi"):
            found.append(Station(name, "lathe-a"))
        if not name.startswith("gsk") or name == "gsk-980mdi":
            found.append(Station(name, "mill"))
    for name in ("fanuc-16i", "fanuc-0i-f"):
        found += [Station(name, kind, (("5003#0", 1),)) for kind in ("mill", "lathe-a")]
    found.append(Station("fanuc-30i", "mill", (("19607#2", 1),)))
    found.append(Station("gsk-980tdi", "lathe-a", (("002#5", 1),)))
    return found


@dataclass(frozen=True)
class Written:
    """A program, and the contour that its rounded words mean (mm, radii)."""

    text: str
    curves: tuple[Curve, ...]
    resolution: float  # of the words
    least: float  # the increment of the setup
    inch: bool
    plane: int
    tip: int
    meant: bool  # after rounding, every arc still has a radius and about the same angle

    @property
    def increment(self) -> float:
        """The distance that neither the words nor the control can tell from 0, in mm."""
        return max(self.resolution, self.least * (INCH / 10 if self.inch else 1))

    @property
    def blur(self) -> float:
        """The uncertainty of words that are coarser than the increment of the control, in mm."""
        taken = self.least * (INCH / 10 if self.inch else 1)
        return self.resolution if self.resolution > 1.5 * taken else 0.0

    def told(self) -> tuple[Curve, ...]:
        """Return the curves whose ends can be told apart, and full circles."""
        apart = 1.5 * self.increment
        return tuple(
            curve
            for curve in self.curves
            if np.hypot(*(curve.end - curve.start)) > apart or abs(curve.turn) > math.pi
        )


class Writer:
    def __init__(self, random: Random, station: Station) -> None:
        self.random, self.station = random, station
        self.inch = random.random() < 0.3 and station.control not in NO_INCH
        self.decimals = random.choice([3, 4])
        self.unit = INCH if self.inch else 1.0
        self.plane = 18 if station.lathe else random.choice([17, 17, 18, 19])
        self.tip = random.randrange(10) if station.lathe else 0
        self.share = np.array([1.0, 2.0 if station.lathe else 1.0])
        self.names = PLANES[self.plane]

    def rounded(self, values: Vector, share: Vector | float = 1.0) -> Vector:
        """Return the lengths that the rounded words say, in mm."""
        scale = 10.0**self.decimals
        return np.asarray(np.round(values * share / self.unit * scale) / scale * self.unit / share)

    def words(self, names: str, values: Vector) -> str:
        numbers = values / self.unit
        return " ".join(f"{n}{v:.{self.decimals}f}" for n, v in zip(names, numbers, strict=True))

    def point(self, at: Vector) -> str:
        return self.words(self.names[:2], at * self.share)

    def write(self, drawing: Drawing) -> Written:
        random = self.random
        curves, blocks, meant = [], [], True
        at = self.rounded(drawing.curves[0].start, self.share)
        first = at
        for curve in drawing.curves:
            block, read = self.block(curve, at)
            if np.array_equal(read.start, read.end) and abs(curve.turn) < math.pi:
                continue  # the curve is rounded away
            meant = meant and abs(read.turn - curve.turn) < 1 and read.radius > 0
            blocks.append(block)
            curves.append(read)
            at = read.end
            if random.random() < 0.08:
                blocks.append(f"G1 {self.point(at)}")  # repeat the same point
            elif random.random() < 0.08 and not self.station.lathe:
                blocks.append(f"G1 {self.names[4]}{random.randint(-9, 9)}.")
        code = 41 if drawing.side > 0 else 42
        come, go = self.beside(drawing, 0), self.beside(drawing, -1)
        head = ["G20" if self.inch else "G21"] if self.station.control not in NO_INCH else []
        if self.station.lathe:
            head += ["T0101", f"G0 {self.point(come)}", f"G98 G{code} G1 {self.point(first)} F100."]
        else:
            head += [f"G90 G{self.plane} G0 {self.point(come)}"]
            head += [f"G{code} D1 G1 {self.point(first)} F100."]
        text = "\n".join(["O1", *head, *blocks, f"G40 G1 {self.point(go)}", "M30", ""])
        resolution = self.unit * 10.0**-self.decimals
        cuts = self.station.cuts_fine_digits
        fine = self.decimals == 4 and not self.inch and (cuts or random.random() < 0.5)
        least = 1e-4 if fine else 1e-3
        return Written(
            text, tuple(curves), resolution, least, self.inch, self.plane, self.tip, meant
        )

    def beside(self, drawing: Drawing, place: int) -> Vector:
        """Return a point on the side of the tool, from which it comes to an end of the contour."""
        curve = drawing.curves[place]
        at, way = (curve.start if place == 0 else curve.end), curve.end - curve.start
        angle = math.atan2(way[1], way[0]) + drawing.side * math.radians(
            self.random.uniform(40, 140)
        )
        far = drawing.radius * self.random.uniform(1.5, 3) + 1
        return np.asarray(at + far * np.array([math.cos(angle), math.sin(angle)]))

    def block(self, curve: Curve, at: Vector) -> tuple[str, Curve]:
        end = self.rounded(curve.end, self.share)
        if curve.centre is None:
            return f"G1 {self.point(end)}", Curve(at, end)
        left = curve.turn > 0
        arc = f"{'G3' if left else 'G2'} {self.point(end)}"
        from_start = curve.centre - curve.start
        size = float(np.hypot(*from_start))
        full = np.array_equal(at, end)
        if (
            abs(curve.turn) < math.radians(80)
            and self.random.random() < 0.2
            and not full
            and size < 999
        ):
            radius = float(self.rounded(np.array([size]))[0])
            chord = end - at
            half = float(np.hypot(*chord)) / 2
            if radius > half:
                height = math.sqrt(radius * radius - half * half) * (1 if left else -1)
                centre = (at + end) / 2 + height * np.array([-chord[1], chord[0]]) / (2 * half)
                return f"{arc} {self.words('R', np.array([radius]))}", self.arc(
                    at, end, centre, left
                )
        to_centre = self.rounded(from_start)
        text = f"{arc} {self.words(self.names[2:4], to_centre)}"
        return text, self.arc(at, end, at + to_centre, left)

    def arc(self, at: Vector, end: Vector, centre: Vector, left: bool) -> Curve:
        return Curve(at, end, centre, sweep(at - centre, end - centre, left))
