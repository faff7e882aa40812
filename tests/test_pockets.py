"""G71 and G72 of type II, cut in a stock that is a depth over a fine grid: the tool never goes into
the finished part, no rapid goes through stock, no cut is deeper than it may be, and nothing is
left.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

import cncsub

Points = NDArray[np.float64]

# A point of a profile: how far along the cut, how deep below the start; and the code of the arc
# that leads to it, or 0.
Profile = list[tuple[float, float, int]]


@st.composite
def profiles(draw: st.DrawFn) -> Profile:
    place, deep = 0.0, 0.0
    profile: Profile = []
    for _ in range(draw(st.integers(2, 9))):
        step = draw(st.integers(0, 8))
        place, deep = place + step, float(draw(st.integers(3, 18)))
        before = profile[-1][1] if profile else 0.0
        flat = step > 0 and abs(deep - before) <= 3 * step and bool(profile)
        profile.append((place, deep, draw(st.sampled_from([0, 0, 2, 3])) if flat else 0))
    profile.append((place + draw(st.integers(1, 5)), 2.0, 0))
    return profile


class Side:
    """The place of depths and lengths on the machine."""

    def __init__(self, cycle: str, inside: bool) -> None:
        self.cycle, self.inside = cycle, inside

    def point(self, place: float, deep: float) -> tuple[float, float]:
        """Return X (a diameter) and Z."""
        if self.cycle == "G72":
            return 2 * (60 - place), -deep
        return 2 * (20 + deep if self.inside else 60 - deep), -place

    def back(self, x: Points, z: Points) -> Points:
        """Return the place and the depth of a point."""
        radius = x / 2
        if self.cycle == "G72":
            return np.array([60 - radius, -z])
        return np.array([-z, radius - 20 if self.inside else 60 - radius])

    def allowance(self, value: float) -> str:
        if self.cycle == "G72":
            return f"U0. W{value:.4f}"
        return f"U{-2 * value if self.inside else 2 * value:.4f} W0."

    def turn(self, code: int) -> int:
        """Return the code of an arc that turns as `code` does outside."""
        mirrored = self.inside if self.cycle == "G71" else True
        return 5 - code if mirrored else code


def program(side: Side, profile: Profile, depth: float, escape: float, allowance: float) -> str:
    def words(place: float, deep: float) -> str:
        x, z = side.point(place, deep)
        return f"X{x:.4f} Z{z:.4f}"

    lines = []
    before = (0.0, 0.0)
    for place, deep, arc in profile:
        radius = 2 * math.hypot(place - before[0], deep - before[1])
        code = f"G{side.turn(arc)} R{radius:.4f}" if arc else "G1"
        lines.append(f"{code} {words(place, deep)}")
        before = (place, deep)
    lines[0] = f"N10 {lines[0]}"
    lines[-1] = f"N20 {lines[-1]}"
    first = "U" if side.cycle == "G71" else "W"
    return "\n".join([
        "O1", f"G98 G0 {words(0, 0)} S100 M3", f"{side.cycle} {first}{depth:.4f} R{escape:.4f}",
        f"{side.cycle} P10 Q20 {side.allowance(allowance)} F100.", *lines, "M30", "",
    ])  # fmt: skip


def tool_path(side: Side, moves: Sequence[cncsub.Move]) -> list[tuple[str, Points]]:
    """Return every move as points (place, depth), arcs in small steps."""
    made = []
    here = np.array(side.point(0, 0)) / [2, 1]
    for move in moves:
        there = np.array([(move.x or 0) / 2, move.z or 0])
        way = np.linspace(0, 1, 2)[:, None] * (there - here) + here
        if move.kind in ("cw", "ccw"):
            centre = np.array([(move.cx or 0) / 2, move.cz or 0])
            one, other = here - centre, there - centre
            first, last = math.atan2(one[0], one[1]), math.atan2(other[0], other[1])
            turn = math.remainder(last - first, 2 * math.pi)
            assert (turn > 0) == (move.kind == "ccw") or abs(turn) < 1e-6
            angles = first + np.linspace(0, 1, 200) * turn
            way = centre + math.hypot(*one) * np.column_stack([np.sin(angles), np.cos(angles)])
        made.append((move.kind, side.back(2 * way[:, 0], way[:, 1]).T))
        here = there
    return made


def depths(points: Points, grid: Points) -> Points:
    """Return how deep a path is over the grid, minus infinity beside it."""
    place, deep = points.T
    order = np.argsort(place, kind="stable")
    if place.max() - place.min() < 1e-6:
        return np.full_like(grid, -np.inf)
    found = np.interp(grid, place[order], deep[order])
    found[(grid < place.min() - 1e-9) | (grid > place.max() + 1e-9)] = -np.inf
    return found


@pytest.mark.parametrize("inside", [False, True])
@pytest.mark.parametrize("cycle", ["G71", "G72"])
@settings(max_examples=60)
@given(
    profile=profiles(),
    depth=st.floats(0.5, 6).map(lambda v: round(v, 2)),
    escape=st.floats(0, 2).map(lambda v: round(v, 2)),
    allowance=st.floats(0, 1).map(lambda v: round(v, 2)),
    control=st.sampled_from(["gsk-980tdi", "gsk-988ta", "fanuc-0i-f"]),
)
def test_pockets_are_cut_level_by_level_and_nothing_is_left(
    cycle: str,
    inside: bool,
    profile: Profile,
    depth: float,
    escape: float,
    allowance: float,
    control: str,
) -> None:
    side = Side(cycle, inside)
    changed = cncsub.controls[control].with_parameters(
        {"051": depth} if control == "gsk-980tdi" else {"5102#2": 1} if "988" in control else {}
    )
    text = program(side, profile, depth, escape, allowance)
    run = cncsub.loads(text, control=changed).run(
        setup=cncsub.Setup(machine="lathe-a", start=dict(zip("XZ", side.point(0, 0), strict=True)))
    )
    assert run.alarm is None, f"{run.alarm}\n{text}"
    made = [m for m in run.moves if m.step == 2]
    path = tool_path(side, made)

    # The part, computed from the profile alone.
    grid = np.linspace(0.013, profile[-1][0] - 0.013, 1500)
    part = np.full_like(grid, -np.inf)
    before = np.array([0.0, 0.0])
    for place, deep, arc in profile:
        there = np.array([place, deep])
        way = np.array([before, there])
        if arc:
            chord = there - before
            length = math.hypot(*chord)
            # Depths grow downward: G02 outside bulges away from the part.
            across = np.array([chord[1], -chord[0]]) / length * (1 if arc == 2 else -1)
            rise = 2 * length * math.cos(math.asin(0.25))
            centre = (before + there) / 2 - across * rise * -1
            one, other = before - centre, there - centre
            first = math.atan2(one[1], one[0])
            turn = math.remainder(math.atan2(other[1], other[0]) - first, 2 * math.pi)
            angles = first + np.linspace(0, 1, 400) * turn
            way = centre + 2 * length * np.column_stack([np.cos(angles), np.sin(angles)])
        part = np.maximum(part, depths(way, grid))
        before = there
    part -= allowance

    stock = np.full_like(grid, -allowance)
    for kind, points in path[:-1]:  # the last move leads home
        tool = depths(points, grid)
        assert np.all(tool <= part + 2e-3), (kind, points, text)
        cut = tool - stock
        assert cut.max() <= (1e-3 if kind == "rapid" else depth + 1e-3), (kind, points, text)
        stock = np.maximum(stock, tool)
    assert np.all(stock >= np.maximum(part, -allowance) - 2e-2), text
    np.testing.assert_allclose(path[-1][1][-1], [0, 0], atol=1e-6)
