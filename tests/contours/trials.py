"""Runs contours on controls and checks the path of the tool by an independent offset."""

from __future__ import annotations

import math
from collections import Counter
from random import Random

import numpy as np

import cncsub
from cncsub.tables import Moves
from curves import Curve, Vector, distances, sweep
from drawing import PARTS, Drawing, draw
from stations import TIPS, Station, Writer, Written, stations

NO_ROOM = {"offset-interference", "offset-arc-too-small", "no-offset-intersection"}
ALARMED = {True: "refused, though it fits", False: "refused", None: "refused, nearly fits"}
PATH = np.linspace(0, 1, 17)


class Trials:
    """Contours by their place in the series of a seed."""

    def __init__(self, seed: int) -> None:
        self.seed = seed
        self.stations = stations()
        self.outcomes: Counter[str] = Counter()
        self.runs: Counter[str] = Counter()
        self.worst = 0.0  # the largest deviation, in increments
        self.failures: list[str] = []

    def contour(self, place: int) -> tuple[Station, Drawing, Written]:
        random = Random(f"{self.seed} {place}")
        station = self.stations[place % len(self.stations)]
        while True:
            drawing = draw(random)
            written = Writer(random, station).write(drawing)
            if written.meant and (drawing.tight or not drawing.crosses_itself()):
                return station, drawing, written

    def compare(self, place: int) -> None:
        station, drawing, written = self.contour(place)
        self.runs[str(station)] += 1
        slack = 2.5 * written.increment
        fits = drawing.fits(slack, written.blur)
        if fits and written.blur and not self.printed(drawing, written).fits(slack):
            fits = None
        run = self.run(station, drawing, written)
        fault = ""
        if run.alarm is not None:
            self.outcomes[ALARMED[fits]] += 1
            if fits or run.alarm.cause not in NO_ROOM:
                fault = str(run.alarm)
        elif fits is False:
            self.outcomes["taken, though it does not fit"] += 1
            fault = "the tool does not fit, and nothing alarms"
        else:
            self.outcomes["taken"] += 1
            path = tool_path(run.moves, written, drawing.radius)
            away = 0.0 if drawing.tight else deviation(path, drawing, written) / written.increment
            self.worst = max(self.worst, away)
            if away > 2:
                fault = f"the path deviates by {away:.2f} increments"
        if fault:
            self.failures.append(f"{place}: {station}: {fault}")

    def printed(self, drawing: Drawing, written: Written) -> Drawing:
        return Drawing(written.curves, drawing.radius, drawing.side)

    def setup(self, station: Station, drawing: Drawing, written: Written) -> dict[str, object]:
        setup: dict[str, object] = {"machine": station.machine, "increment": written.least}
        if station.lathe:
            setup["tools"] = {1: {"R": drawing.radius, "tip": written.tip}}
        else:
            setup["radius_offsets"] = {1: drawing.radius}
        return setup

    def run(self, station: Station, drawing: Drawing, written: Written) -> cncsub.Run:
        setup = self.setup(station, drawing, written)
        return cncsub.loads(written.text, control=station.made()).run(setup=setup)


def tool_path(moves: Moves, written: Written, radius: float) -> list[Curve]:
    """Return the path of the centre of the tool, from the end of the start-up to the last
    compensated point.
    """
    names = {17: "xy", 18: "zx", 19: "yz"}[written.plane]
    half = np.array([1.0, 0.5 if "T0101" in written.text else 1.0])
    tip = radius * np.array(TIPS[written.tip])
    ends = np.stack([getattr(moves, f"m{n}") for n in names], axis=1) * half - tip
    centres = np.stack([getattr(moves, f"c{n}") for n in names], axis=1) * half
    path = []
    for i, kind in list(enumerate(move.kind for move in moves))[2:-1]:
        if kind not in ("cw", "ccw"):
            path.append(Curve(ends[i - 1], ends[i]))
            continue
        turn = sweep(ends[i - 1] - centres[i], ends[i] - centres[i], kind == "ccw")
        path.append(Curve(ends[i - 1], ends[i], centres[i], turn))
    return path


def deviation(path: list[Curve], drawing: Drawing, written: Written) -> float:
    """Return how far the path is from the offset of the contour that the words mean."""
    radius = drawing.radius
    printed = Drawing(written.curves, radius, drawing.side)
    points = np.concatenate([curve.points(PATH) for curve in path])
    room = distances(points, printed.curves)
    # The path is never nearer than the radius, and is farther only around a corner.
    worst = float(radius - room.min())
    # A piece that the words cannot tell from a point has no side of its own.
    told = Drawing(written.told(), radius, drawing.side)
    beyond = np.minimum(beyond_corners(points, printed), beyond_corners(points, told))
    nearest = room.min(axis=1)
    worst = max(worst, float(np.where(beyond < 2 * written.increment, 0, nearest - radius).max()))
    # All of the offset that no other curve cuts off lies on the path.
    for curve in told.curves:
        beside = printed.beside(curve, PARTS)
        free = distances(beside, printed.curves).min(axis=1) > radius - 1e-9
        if free.any():
            worst = max(worst, float(distances(beside[free], path).min(axis=1).max()))
    return worst


def beyond_corners(points: Vector, drawing: Drawing) -> Vector:
    """Return how far points lie beyond the path around the nearest corner."""
    turns = drawing.corners()
    turns = np.where(turns > 2.9, -turns, turns)  # nearly straight back: the tool goes around
    outside = np.clip(-turns, 0, math.pi / 2)
    corners = np.array([curve.end for curve in drawing.curves[:-1]])
    away = np.hypot(*(points[:, None, :] - corners[None, :, :]).transpose(2, 0, 1))
    return np.asarray((away - drawing.radius / np.cos(outside / 2)).min(axis=1))
