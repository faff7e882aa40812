"""Random contours as a drawing means them, and whether a tool fits into them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from random import Random

import numpy as np

from curves import Curve, Vector, distances

PARTS = np.linspace(0, 1, 41)
JOINTS = ("tangent", "tangent", "tangent", "nearly tangent", "outside", "inside", "any")


@dataclass(frozen=True)
class Drawing:
    """A contour, and the radius and side of the tool (1 = left, -1 = right)."""

    curves: tuple[Curve, ...]
    radius: float
    side: int
    tight: bool = False  # the contour is meant to have no room for the tool

    def beside(self, curve: Curve, parts: Vector) -> Vector:
        """Return the points from which the tool touches a curve."""
        ahead = curve.directions(parts)
        left = np.stack([-ahead[:, 1], ahead[:, 0]], axis=1)
        return np.asarray(curve.points(parts) + self.side * self.radius * left)

    def room(self, place: int, parts: Vector, near: int = 1) -> Vector:
        """Return how far the neighbours are when the tool touches a curve; less than its radius is
        too near.
        """
        points = self.beside(self.curves[place], parts)
        around = self.curves[max(0, place - near) : place + near + 1]
        return np.asarray(distances(points, around).min(axis=1))

    def fits(self, slack: float, blur: float = 0.0) -> bool | None:
        """Return whether the tool reaches a bit of every curve.

        None: within `slack` it may or may not, or it may not fit into an arc whose radius is larger
        by less than `blur`.
        """
        inner = [c.radius for c in self.curves if c.centre is not None and c.turn * self.side > 0]
        clear: bool | None = None if inner and min(inner) < self.radius + blur else True
        for place, curve in enumerate(self.curves):
            parts = PARTS
            missing = self.radius - self.room(place, parts)
            for _ in range(3):  # look closer at the part where it comes nearest to fitting
                if missing.min() < 1e-9:
                    break
                best = parts[missing.argmin()]
                step = parts[1] - parts[0]
                parts = np.clip(np.linspace(best - step, best + step, 41), 0, 1)
                missing = self.radius - self.room(place, parts)
            if missing.min() > slack:
                return False
            free = self.beside(curve, parts[missing < 1e-9])
            if len(free) < 2 or np.hypot(*np.diff(free, axis=0).T).sum() < slack:
                clear = None
        return clear

    def corners(self) -> Vector:
        """Return the turns between the curves; plus = to the side of the tool: inside corners."""
        u = np.array([curve.directions(np.ones(1))[0] for curve in self.curves[:-1]])
        v = np.array([curve.directions(np.zeros(1))[0] for curve in self.curves[1:]])
        cross = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
        return np.asarray(np.arctan2(cross, (u * v).sum(axis=1)) * self.side)

    def around(self, corner: int) -> Vector:
        """Return points of the path around the outside corner after a curve."""
        one, two, end, start = *self.curves[corner : corner + 2], np.ones(1), np.zeros(1)
        u, v = one.directions(end)[0], two.directions(start)[0]
        first, last = self.beside(one, end)[0], self.beside(two, start)[0]
        reach = self.radius * min(1.0, math.tan(abs(self.corners()[corner]) / 2))
        corners = np.stack([first, first + reach * u, last - reach * v, last])
        steps = [Curve(*corners[i : i + 2]).points(PARTS) for i in range(3)]
        return np.concatenate(steps)

    def crosses_itself(self) -> bool:
        """Return whether curves come into the path of the tool elsewhere than at their corner."""
        turns = [0.0, *self.corners(), 0.0]
        ways = [self.around(i) for i, turn in enumerate(turns[1:-1]) if turn < -1e-9]
        for place, curve in enumerate(self.curves):
            close = int(min(max(3 * curve.length / self.radius, 40), 2000))
            parts = np.linspace(0, 1, close + 1)
            free = self.room(place, parts) > self.radius - 1e-9
            if not free.any() or (np.diff([0, *free, 0]) != 0).sum() > 2:
                return True
            for reached, turn in ((free[0], turns[place]), (free[-1], turns[place + 1])):
                if reached if turn > 0.02 else turn < 1e-9 and not reached:
                    return True
            ways.append(self.beside(curve, parts)[free])
            far = [c for i, c in enumerate(self.curves) if abs(i - place) > 2]
            step = np.hypot(*np.diff(ways[-1], axis=0).T).max() if len(ways[-1]) > 1 else 0.0
            if far and distances(ways[-1], far).min() < self.radius + step / 2:
                return True
        if distances(np.concatenate(ways), self.curves).min() < self.radius - 1e-9:
            return True
        return any(self.loses_its_way(i) for i, turn in enumerate(turns[1:-1]) if turn > 1e-9)

    def loses_its_way(self, corner: int) -> bool:
        """Return whether the tool cannot come from one curve to the next at an inside corner."""
        leaves, comes = self.border(corner, -1), self.border(corner + 1, 0)
        return leaves is None or comes is None or np.hypot(*(leaves - comes)) > 1e-4 * self.radius

    def border(self, place: int, at: int) -> Vector | None:
        """Return the place of the tool at the begin of the first bit (0) that it reaches, or at the
        end of the last (-1).
        """
        parts = PARTS
        for _ in range(4):
            free = np.flatnonzero(self.room(place, parts) > self.radius - 1e-9)
            if not len(free):
                return None
            edge = free[at]
            behind = min(edge + 1, len(parts) - 1) if at else max(edge - 1, 0)
            parts = np.linspace(parts[min(edge, behind)], parts[max(edge, behind)], 41)
        return np.asarray(self.beside(self.curves[place], parts[-at or 0 : (-at or 0) + 1])[0])


def turn_of(random: Random, side: int, joint: str) -> float:
    """Return the turn of a corner, plus = to the left."""
    if joint == "tangent":
        return 0.0
    if joint == "nearly tangent":
        return random.choice([1, -1]) * 10 ** random.uniform(-6.5, -1.5)
    if joint == "outside":
        return -side * math.radians(random.uniform(1, 165))
    if joint == "inside":
        return side * math.radians(random.uniform(1, 140))
    return math.radians(random.uniform(-150, 150))


def arc_of(random: Random, radius: float, side: int) -> tuple[float, float]:
    """Return a radius and the angle that an arc runs through."""
    turn = math.radians(random.choice([random.uniform(2, 60), random.uniform(20, 350), 90, 180]))
    if random.random() < 0.03:
        return 9e3, random.choice([1, -1]) * random.uniform(1e-4, 1e-2)
    if random.random() < 0.5:
        size = random.choice([10 ** random.uniform(-3, 0), random.uniform(0.1, 60)])
        return size, -side * turn
    more = [0.0, 10 ** random.uniform(-4, 0), random.uniform(0, 20), random.uniform(0, 20)]
    return radius + random.choice(more), side * turn


class Pen:
    """Draws curves one after the other."""

    def __init__(self, random: Random) -> None:
        self.at = np.array([random.uniform(-100, 100), random.uniform(-100, 100)])
        self.ahead = random.uniform(0, 2 * math.pi)
        self.curves: list[Curve] = []

    def line(self, length: float) -> None:
        way = np.array([math.cos(self.ahead), math.sin(self.ahead)])
        self.add(Curve(self.at, self.at + length * way))

    def arc(self, size: float, turn: float) -> None:
        left = np.array([-math.sin(self.ahead), math.cos(self.ahead)])
        centre = self.at + math.copysign(size, turn) * left
        self.ahead += turn
        left = np.array([-math.sin(self.ahead), math.cos(self.ahead)])
        self.add(Curve(self.at, centre - math.copysign(size, turn) * left, centre, turn))

    def add(self, curve: Curve) -> None:
        self.curves.append(curve)
        self.at = curve.end


def draw(random: Random) -> Drawing:
    """Return a contour whose first and last curves are lines on which the tool comes and goes."""
    radius = random.choice([0.2, 0.4, 1.0, 5.0, 10 ** random.uniform(-1, 1.3)])
    radius, side = round(radius, 3), random.choice([1, -1])
    pen = Pen(random)
    pen.line(3 * radius + random.uniform(1, 30))
    tight = random.random() < 0.1
    if tight:
        draw_tight(pen, random, radius, side)
    else:
        fine = random.random() < 0.2  # short pieces
        for _ in range(random.randint(0, 5)):
            pen.ahead += turn_of(random, side, random.choice(JOINTS))
            if random.random() < 0.5:
                pen.line(10 ** random.uniform(-3, 0.5) if fine else random.uniform(0.5, 40))
            else:
                pen.arc(*arc_of(random, radius, side))
        pen.ahead += turn_of(random, side, random.choice(JOINTS))
    pen.line(3 * radius + random.uniform(1, 30))
    return Drawing(tuple(pen.curves), radius, side, tight)


def draw_tight(pen: Pen, random: Random, radius: float, side: int) -> None:
    """Draw an inner arc, a groove or a step that is too small for the tool."""
    share = random.choice([random.uniform(0.2, 0.95), random.uniform(0.9, 0.999)])
    if random.random() < 0.5:
        pen.arc(share * radius, side * math.radians(random.uniform(20, 175)))
        return
    turns = [math.radians(random.choice([90, random.uniform(20, 100)])) for _ in range(2)]
    pen.ahead += side * turns[0]
    pen.line(share * radius * sum(math.tan(turn / 2) for turn in turns))
    pen.ahead += side * turns[1]
