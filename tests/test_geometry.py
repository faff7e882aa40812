"""Moves against geometry computed another way: rotation matrices, integrals, NumPy and shapely."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from shapely.geometry import LineString, Point, Polygon

import cncsub

Vector = NDArray[np.float64]
FINE = 1e-7  # the input increment of these tests: the points are not bound to thousandths


def moves_of(
    *blocks: str,
    control: str = "fanuc-0i-f",
    parameters: dict[str, float] | None = None,
    **setup: Any,
) -> list[cncsub.Move]:
    """Return the moves of a program of these blocks, which must run to its end."""
    changed = cncsub.controls[control].with_parameters(parameters or {})
    text = "O1\n" + "\n".join(blocks) + "\nM30\n"
    run = cncsub.loads(text, control=changed).run(
        setup=cncsub.Setup(**{"increment": FINE, **setup})
    )
    assert run.alarm is None, f"{run.alarm}\n{text}"
    return list(run.moves)


def word(address: str, value: float) -> str:
    return f"{address}{value:.7f}"


def words(addresses: str, values: Sequence[float]) -> str:
    return " ".join(map(word, addresses, values))


def point(move: cncsub.Move, axes: Sequence[str] = "xyz") -> Vector:
    return np.array([getattr(move, axis) for axis in axes], dtype=float)


def coordinate(limit: float) -> st.SearchStrategy[float]:
    return st.integers(int(-limit * 1000), int(limit * 1000)).map(lambda n: n / 1000)


# ---- arcs ----

PLANES = {  # the two axes of the plane in their order, and the axis across
    17: ("XY", "Z"),
    18: ("ZX", "Y"),
    19: ("YZ", "X"),
}
CENTRE_WORDS = {"X": "I", "Y": "J", "Z": "K"}
# Whole points on one circle: no radius is rounded.
ON_CIRCLE = [
    (a * sign_a, b * sign_b)
    for a, b in [
        (65, 0),
        (63, 16),
        (60, 25),
        (56, 33),
        (52, 39),
        (39, 52),
        (25, 60),
        (16, 63),
        (0, 65),
    ]
    for sign_a in (1, -1)
    for sign_b in (1, -1)
]
planes = st.sampled_from(sorted(PLANES))
ways = st.sampled_from(["G02", "G03"])


def space(plane: int, first: float, second: float, across: float = 0.0) -> Vector:
    """Return a point of a plane as X Y Z."""
    (a, b), c = PLANES[plane]
    value = {a: first, b: second, c: across}
    return np.array([value["X"], value["Y"], value["Z"]])


def sweep(start: Vector, end: Vector, way: str) -> float:
    """Return the angle from one vector of the plane to another: plus is counter-clockwise."""
    angle = math.atan2(end[1], end[0]) - math.atan2(start[1], start[0])
    angle = math.remainder(angle, 2 * math.pi)
    if abs(angle) < 1e-9:
        return 2 * math.pi if way == "G03" else -2 * math.pi
    if way == "G03":
        return angle if angle > 0 else angle + 2 * math.pi
    return angle if angle < 0 else angle - 2 * math.pi


def along(start: Vector, centre: Vector, axis: Vector, angle: float, climb: float) -> Vector:
    """Return many points of a helix: the radius rotated about the axis of its plane (Rodrigues)."""
    part = np.linspace(0.0, 1.0, 2001)[:, None]
    radius = start - centre
    turned = radius * np.cos(angle * part) + np.cross(axis, radius) * np.sin(angle * part)
    return np.asarray(centre + turned + axis * climb * part)


def integral(points: Vector) -> float:
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())


@given(
    plane=planes,
    way=ways,
    first=st.sampled_from(ON_CIRCLE),
    last=st.sampled_from(ON_CIRCLE),
    centre=st.tuples(coordinate(100), coordinate(100)),
    climb=st.one_of(st.just(0.0), coordinate(50)),
    incremental=st.booleans(),
)
def test_an_arc_by_its_centre_is_the_turned_radius(
    plane: int,
    way: str,
    first: tuple[int, int],
    last: tuple[int, int],
    centre: tuple[float, float],
    climb: float,
    incremental: bool,
) -> None:
    (a, b), c = PLANES[plane]
    start = space(plane, centre[0] + first[0], centre[1] + first[1])
    end = space(plane, centre[0] + last[0], centre[1] + last[1], climb)
    written = end - start if incremental else end
    arc = f"G{plane} {way} {words('XYZ', written)} F500."
    if climb == 0.0:
        arc = arc.replace(word(c, written["XYZ".index(c)]), "")
    arc += f" {word(CENTRE_WORDS[a], -first[0])} {word(CENTRE_WORDS[b], -first[1])}"
    made = moves_of(f"G90 G0 {words('XYZ', start)}", ("G91 " if incremental else "") + arc)[-1]

    assert made.kind == {"G02": "cw", "G03": "ccw"}[way]
    assert made.plane == plane
    np.testing.assert_allclose(point(made), end, atol=1e-9)
    middle = space(plane, *centre)
    in_plane = [i for i, axis in enumerate("XYZ") if axis != c]
    np.testing.assert_allclose(
        point(made, ("cx", "cy", "cz"))[in_plane], middle[in_plane], atol=1e-9
    )
    assert getattr(made, f"c{c.lower()}") is None

    axis = space(plane, 0, 0, 1)
    angle = sweep(np.array(first, dtype=float), np.array(last, dtype=float), way)
    path = along(start, middle, axis, angle, climb)
    np.testing.assert_allclose(path[-1], end, atol=1e-6)
    assert made.length == pytest.approx(integral(path), rel=1e-6)
    # F is the speed in the plane; the axis across follows.
    flat = along(start, middle, axis, angle, 0)
    assert made.time == pytest.approx(integral(flat) / 500 * 60, rel=1e-6)


@given(
    plane=planes,
    way=ways,
    start=st.tuples(coordinate(100), coordinate(100)),
    chord=st.tuples(coordinate(50), coordinate(50)),
    larger=st.floats(1.001, 5),
    long_way=st.booleans(),
    incremental=st.booleans(),
)
def test_an_arc_by_its_radius_takes_the_way_its_sign_says(
    plane: int,
    way: str,
    start: tuple[float, float],
    chord: tuple[float, float],
    larger: float,
    long_way: bool,
    incremental: bool,
) -> None:
    assume(math.hypot(*chord) > 0.01)
    (a, b), _ = PLANES[plane]
    radius = round(math.hypot(*chord) / 2 * larger, 3) + 0.001
    end = chord if incremental else np.add(start, chord)
    mode = "G91 " if incremental else ""
    made = moves_of(
        f"G90 G0 {words('XYZ', space(plane, *start))}",
        f"G{plane} {mode}{way} {words(a + b, list(end))} {word('R', -radius if long_way else radius)} F300.",
    )[-1]

    axes = a.lower() + b.lower()
    centre = point(made, [f"c{axis}" for axis in axes])
    first, last = np.array(start) - centre, point(made, axes) - centre
    np.testing.assert_allclose(point(made, axes), np.add(start, chord), atol=1e-9)
    assert np.linalg.norm(first) == pytest.approx(radius, abs=1e-7)
    assert np.linalg.norm(last) == pytest.approx(radius, abs=1e-7)
    angle = abs(sweep(first, last, way))
    assert (angle > math.pi) == long_way
    assert made.length == pytest.approx(radius * angle, rel=1e-7)
    assert made.time == pytest.approx(radius * angle / 300 * 60, rel=1e-7)


@given(
    control=st.sampled_from(["gsk-980tdi", "gsk-988ta", "gsk-988t", "gsk-928te", "fanuc-0i-f"]),
    way=ways,
    first=st.sampled_from(ON_CIRCLE),
    last=st.sampled_from(ON_CIRCLE),
    centre=st.tuples(coordinate(100), coordinate(100)),
    by=st.sampled_from(["I K", "R"]),
    increments=st.booleans(),
)
def test_an_arc_of_a_lathe_is_round_in_radii_though_x_is_a_diameter(
    control: str,
    way: str,
    first: tuple[int, int],
    last: tuple[int, int],
    centre: tuple[float, float],
    by: str,
    increments: bool,
) -> None:
    angle = sweep(np.array(first, dtype=float), np.array(last, dtype=float), way)
    assume(by == "I K" or (first != last and abs(angle) < math.pi - 0.01))
    start, end = np.add(centre, first), np.add(centre, last)  # Z and the radius
    go = words("WU", [end[0] - start[0], 2 * (end[1] - start[1])]) if increments else ""
    go = go or words("ZX", [end[0], 2 * end[1]])
    size = word("R", 65) if by == "R" else words("KI", [-first[0], -first[1]])
    made = moves_of(
        f"G0 {words('ZX', [start[0], 2 * start[1]])}",
        f"G98 {way} {go} {size} F120.",
        control=control,
        machine="lathe-a",
    )[-1]
    assert made.kind == {"G02": "cw", "G03": "ccw"}[way]
    np.testing.assert_allclose([made.z, made.x], [end[0], 2 * end[1]], atol=1e-6)
    np.testing.assert_allclose([made.cz, made.cx], [centre[0], 2 * centre[1]], atol=1e-6)
    assert made.length == pytest.approx(65 * abs(angle), rel=1e-6)
    assert made.time == pytest.approx(65 * abs(angle) / 2, rel=1e-6)


@given(way=ways, first=st.sampled_from(ON_CIRCLE), last=st.sampled_from(ON_CIRCLE))
def test_the_bounds_hold_the_whole_arc(
    way: str, first: tuple[int, int], last: tuple[int, int]
) -> None:
    text = f"O1\nG0 {words('XY', first)}\n{way} {words('XY', last)} {words('IJ', [-first[0], -first[1]])} F1.\nM30\n"
    bounds = cncsub.loads(text, control="fanuc-0i-f").run().moves.bounds
    start = space(17, *first)
    angle = sweep(np.array(first, dtype=float), np.array(last, dtype=float), way)
    path = along(start, np.zeros(3), np.array([0.0, 0.0, 1.0]), angle, 0)
    for i, axis in enumerate("XY"):
        assert bounds[axis][0] == pytest.approx(path[:, i].min(), abs=1e-3)
        assert bounds[axis][1] == pytest.approx(path[:, i].max(), abs=1e-3)


def test_the_bounds_of_an_arc_that_comes_first_begin_at_the_zero_point() -> None:
    text = "O1\nN10 G90 G2 X0 Y10. I10. J0 F100\nN20 M30\n"
    setup = cncsub.Setup(work_offsets={"G54": {"Y": -10}})
    bounds = cncsub.loads(text, control="fanuc-0i-f").run(setup=setup).moves.bounds
    assert bounds["Y"] == pytest.approx((0, 20))
    assert bounds["X"] == pytest.approx((0, 20))


# ---- radius compensation ----


class Edge:
    """One side of a part: a line, or an arc with a radius, plus = to the left of the chord."""

    def __init__(self, start: Vector, end: Vector, radius: float = 0.0) -> None:
        self.start, self.end, self.radius = start, end, radius
        self.chord = end - start
        self.size = float(np.linalg.norm(self.chord))
        if radius:
            height = math.sqrt(radius**2 - self.size**2 / 4)
            left = np.array([-self.chord[1], self.chord[0]]) / self.size
            self.centre = (start + end) / 2 + math.copysign(height, radius) * left

    def direction(self, at: Vector) -> Vector:
        if not self.radius:
            return self.chord / self.size
        r = at - self.centre
        tangent = np.array([-r[1], r[0]]) / np.linalg.norm(r)
        return np.asarray(tangent if self.radius > 0 else -tangent)

    def points(self, count: int = 400) -> Vector:
        """Return points along the edge, without its last point."""
        if not self.radius:
            return self.start[None, :]
        first = math.atan2(*(self.start - self.centre)[::-1])
        last = math.atan2(*(self.end - self.centre)[::-1])
        angles = first + math.remainder(last - first, 2 * math.pi) * np.arange(count) / count
        return np.asarray(
            self.centre + abs(self.radius) * np.stack([np.cos(angles), np.sin(angles)], axis=1)
        )

    def middle(self) -> Vector:
        if not self.radius:
            return np.asarray((self.start + self.end) / 2)
        out = (self.start + self.end) / 2 - self.centre
        return np.asarray(self.centre + out / np.linalg.norm(out) * abs(self.radius))

    def block(self) -> str:
        if not self.radius:
            return f"G1 {words('XY', self.end)}"
        return f"{'G3' if self.radius > 0 else 'G2'} {words('XY', self.end)} {word('R', abs(self.radius))}"


@st.composite
def contours(draw: st.DrawFn, arcs: bool) -> list[Edge]:
    """Draw a polygon around the origin, counter-clockwise, convex or not, some sides arcs."""
    count = draw(st.integers(3, 7))
    turns = [2 * math.pi * (i + draw(st.floats(-0.2, 0.2))) / count for i in range(count)]
    far = [draw(st.floats(40, 100)) for _ in range(count)]
    corners = [
        np.round([f * math.cos(t), f * math.sin(t)], 4) for f, t in zip(far, turns, strict=True)
    ]
    edges = []
    for start, end in zip(corners, corners[1:] + corners[:1], strict=True):
        size = float(np.linalg.norm(end - start))
        bent = draw(st.sampled_from([0, 1, -1])) if arcs else 0
        edges.append(Edge(start, end, bent * round(size * draw(st.floats(1.2, 4)), 4)))
    return edges


def turn_at(edge: Edge, behind: Edge) -> float:
    """Return the turn at a corner, plus = to the left."""
    u, v = edge.direction(edge.end), behind.direction(behind.start)
    return math.atan2(u[0] * v[1] - u[1] * v[0], u.dot(v))


def fits(edges: list[Edge], part: Polygon, radius: float, side: int) -> bool:
    """Return whether a tool of this radius reaches a bit of every side; `side` 1 = to the left."""
    if not part.is_valid:
        return False
    room = 4 * radius
    for edge, behind in zip(edges, edges[1:] + edges[:1], strict=True):
        turn = turn_at(edge, behind) * side  # plus: an inside corner
        if turn > math.radians(120) or abs(turn) > math.radians(170):
            return False
        if 0 < abs(turn) < 1e-3 or edge.size < 2 * room:
            return False
        if edge.radius and abs(edge.radius) < room:
            return False
    lines = [LineString([*e.points(100), e.end]) for e in edges]
    return all(
        lines[i].distance(lines[j]) > room
        for i in range(len(lines))
        for j in range(i + 2, len(lines))
        if (i, j) != (0, len(lines) - 1)
    )


def tool_path(moves: Sequence[cncsub.Move], start: Vector) -> Vector:
    """Return the path of the tool centre over the ground, arcs in many points."""
    path, here = [start], start
    for move in moves:
        there = np.array([move.mx, move.my], dtype=float)
        if move.kind in ("cw", "ccw"):
            assert move.cx is not None
            assert move.cy is not None
            centre = np.array([move.cx, move.cy])
            way = {"cw": "G02", "ccw": "G03"}[move.kind]
            if np.linalg.norm(there - here) > 1e-9:
                first = math.atan2(*(here - centre)[::-1])
                angle = sweep(here - centre, there - centre, way)
                radii = np.linalg.norm(here - centre), np.linalg.norm(there - centre)
                assert radii[0] == pytest.approx(radii[1], abs=1e-6)
                ts = first + angle * np.arange(1, 401) / 400
                path += list(centre + radii[0] * np.stack([np.cos(ts), np.sin(ts)], axis=1))
        path.append(there)
        here = there
    return np.array(path)


def outline(edges: list[Edge]) -> Polygon:
    return Polygon(np.concatenate([edge.points() for edge in edges]))


def backwards(edges: list[Edge]) -> list[Edge]:
    return [Edge(edge.end, edge.start, -edge.radius) for edge in reversed(edges)]


@pytest.mark.parametrize("arcs", [False, True], ids=["lines", "lines and arcs"])
@pytest.mark.parametrize(
    ("control", "parameters"),
    [
        ("fanuc-0i-f", {}),
        ("fanuc-16i", {"5003#0": 1}),
        ("fanuc-30i", {"19607#2": 1}),
        ("mitsubishi-m700", {"1084": 0.1}),
        ("hnc-21m", {}),
    ],
    ids=["type A", "type B", "arcs around corners", "Mitsubishi", "HNC"],
)
@settings(suppress_health_check=[HealthCheck.filter_too_much, HealthCheck.too_slow])
@given(data=st.data())
def test_the_tool_keeps_its_radius_from_the_part_and_touches_every_side(
    arcs: bool, control: str, parameters: dict[str, float], data: st.DataObject
) -> None:
    edges = data.draw(contours(arcs))
    part = outline(edges)
    if data.draw(st.booleans(), label="clockwise"):
        edges = backwards(edges)
    side = data.draw(st.sampled_from([1, -1]), label="left or right")
    negative = data.draw(st.booleans(), label="the radius is negative")
    radius = data.draw(st.floats(0.5, 6).map(lambda r: round(r, 3)), label="radius")
    assume(fits(edges, part, radius, side))
    begin = data.draw(st.integers(0, len(edges) - 1), label="first side")
    edges = edges[begin:] + edges[:begin]
    assume(not edges[0].radius)  # the tool comes and goes at the middle of a line

    middle = np.round(edges[0].middle(), 7)
    normal = side * np.array([-edges[0].chord[1], edges[0].chord[0]]) / edges[0].size
    far = np.round(middle + 1.5 * radius * normal, 6)
    code = "G41" if (side > 0) != negative else "G42"
    made = moves_of(
        f"G17 G90 G0 {words('XY', far)}",
        f"{code} G1 {words('XY', middle)} D1 F100.",
        *[edge.block() for edge in edges],
        f"G1 {words('XY', middle)}",
        f"G40 G1 {words('XY', far)}",
        control=control,
        parameters=parameters,
        radius_offsets={1: -radius if negative else radius},
    )
    np.testing.assert_allclose([made[-1].mx, made[-1].my], far, atol=1e-6)
    path = tool_path(made[1:-1], far)[1:]
    way = LineString(path)
    near = 2e-4 if arcs or "19607#2" in parameters else 1e-6  # arcs are chords here
    assert way.distance(part.exterior) >= radius - near
    assert part.contains(Point(path[0])) == part.contains(Point(far))  # the path never crosses
    for edge in edges:
        touching = path[np.linalg.norm(path - edge.middle(), axis=1).argmin()]
        if edge.radius:
            from_centre = np.linalg.norm(touching - edge.centre)
            assert abs(from_centre - abs(edge.radius)) == pytest.approx(radius, abs=1e-6)
        else:
            assert way.distance(Point(edge.middle())) == pytest.approx(radius, abs=1e-6)


@given(data=st.data())
def test_the_nose_of_a_lathe_tool_keeps_its_radius_from_the_part(data: st.DataObject) -> None:
    """The part is a rising profile, cut from the face to the left with G42; the centre is tip 0."""
    count = data.draw(st.integers(2, 6))
    rise = [data.draw(st.floats(3, 12)) for _ in range(count)]
    run_ = [data.draw(st.floats(3, 12)) for _ in range(count)]
    nose = data.draw(st.floats(0.2, 0.8).map(lambda r: round(r, 2)))
    zs = -np.round(np.cumsum(run_), 3)
    radii = np.round(10 + np.cumsum(rise), 3)
    made = moves_of(
        f"T0101 G0 {words('ZX', [5, 20])}",
        f"G42 G1 {words('ZX', [2, 20])} F100.",
        f"G1 {words('ZX', [0, 20])}",
        *[f"G1 {words('ZX', [z, 2 * x])}" for z, x in zip(zs, radii, strict=True)],
        f"G1 {words('ZX', [zs[-1] - 5, 2 * radii[-1] + 4])}",
        f"G40 G0 {words('ZX', [zs[-1], 2 * radii[-1] + 40])}",
        control="gsk-980tdi",
        parameters={"030": 100},
        tools={1: {"R": nose, "tip": 0}},
    )
    path = np.array([(m.mz, (m.mx or 0) / 2) for m in made[1:-1]], dtype=float)
    profile = [(2, 10), (0, 10), *zip(zs, radii, strict=True), (zs[-1] - 5, radii[-1] + 2)]
    part = Polygon([*profile, (zs[-1] - 5, 0), (2, 0)])
    assert LineString(path).distance(part) >= nose - 1e-6
    for start, end in itertools.pairwise(profile[1:-1]):
        half = Point((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
        assert LineString(path).distance(half) == pytest.approx(nose, abs=1e-6)


# ---- corners ----

angles = st.floats(-math.pi, math.pi)


@given(first=angles, turn=st.floats(0.3, 2.6), left=st.booleans(), size=st.floats(0.5, 5))
def test_a_corner_round_is_the_part_opened_by_its_radius(
    first: float, turn: float, left: bool, size: float
) -> None:
    radius = round(size, 3)
    turn = turn if left else -turn
    corner = np.round(100 * np.array([math.cos(first), math.sin(first)]), 4)
    end = np.round(corner + 100 * np.array([math.cos(first + turn), math.sin(first + turn)]), 4)
    made = moves_of(
        "G0 X0. Y0.", f"G1 {words('XY', corner)} {word(',R', radius)} F10.", f"{words('XY', end)}"
    )
    assert [m.kind for m in made] == ["rapid", "feed", "ccw" if left else "cw", "feed"]
    path = tool_path(made[1:], np.zeros(2))
    wedge = Polygon([(0, 0), corner, end])
    opened = wedge.buffer(-radius, quad_segs=256).buffer(radius, quad_segs=256)
    near_corner = path[np.linalg.norm(path - corner, axis=1) < 60]
    assert max(opened.exterior.distance(Point(p)) for p in near_corner[::20]) < 1e-3
    np.testing.assert_allclose(point(made[-1], "xy"), end, atol=1e-6)
    tangent = radius * math.tan(abs(turn) / 2)  # from the corner to the begin of the round
    assert np.linalg.norm(point(made[1], "xy") - corner) == pytest.approx(tangent, abs=1e-4)
    assert np.linalg.norm(point(made[2], "xy") - corner) == pytest.approx(tangent, abs=1e-4)


@given(first=angles, turn=st.floats(0.1, 3.0), left=st.booleans(), size=st.floats(0.5, 5))
def test_a_chamfer_begins_and_ends_at_its_distance_from_the_corner(
    first: float, turn: float, left: bool, size: float
) -> None:
    turn = turn if left else -turn
    corner = np.round(100 * np.array([math.cos(first), math.sin(first)]), 4)
    end = np.round(corner + 50 * np.array([math.cos(first + turn), math.sin(first + turn)]), 4)
    made = moves_of(
        "G0 X0. Y0.", f"G1 {words('XY', corner)} {word(',C', size)} F10.", f"{words('XY', end)}"
    )
    assert [m.kind for m in made] == ["rapid", "feed", "feed", "feed"]
    rest = LineString([(0, 0), corner, end]).difference(Point(corner).buffer(size, quad_segs=1))
    assert rest.length < 150
    for made_end, along_line in [(made[1], -corner), (made[2], end - corner)]:
        expected = corner + size * along_line / np.linalg.norm(along_line)
        np.testing.assert_allclose(point(made_end, "xy"), expected, atol=1e-6)


# ---- coordinates ----


@given(
    plane=planes,
    centre=st.tuples(coordinate(100), coordinate(100)),
    radius=st.floats(1, 100).map(lambda r: round(r, 3)),
    holes=st.integers(1, 12),
    incremental=st.booleans(),
)
def test_holes_in_polar_coordinates_lie_on_their_circle(
    plane: int, centre: tuple[float, float], radius: float, holes: int, incremental: bool
) -> None:
    (a, b), c = PLANES[plane]
    step = 360 / holes
    first = f"G81 {words(a + b, [radius, 10])} {words(c + 'R', [-5, 2])} F100."
    more = [
        f"G91 {word(b, step)}" if incremental else word(b, 10 + step * i) for i in range(1, holes)
    ]
    made = moves_of(
        f"G{plane} G90 G0 {words(a + b + c, [0, 0, 10])}",
        f"G52 {words(a + b, centre)}",
        "G16",
        first,
        *more,
        "G80 G15",
    )
    bottoms = [m for m in made if m.kind == "feed"]
    assert len(bottoms) == holes
    turns = np.radians(10 + step * np.arange(holes))
    expected = radius * np.stack([np.cos(turns), np.sin(turns)], axis=1)
    got = np.array([point(m, a.lower() + b.lower()) for m in bottoms])
    np.testing.assert_allclose(got, expected, atol=1e-5)
    machine = np.array([[getattr(m, f"m{axis.lower()}") for axis in a + b] for m in bottoms])
    np.testing.assert_allclose(machine, expected + centre, atol=1e-5)


@given(
    plane=planes,
    centre=st.tuples(coordinate(100), coordinate(100)),
    angle=st.integers(-360000, 360000).map(lambda n: n / 1000),
    points=st.lists(st.tuples(coordinate(100), coordinate(100)), min_size=1, max_size=5),
    incremental=st.booleans(),
)
def test_a_rotation_turns_points_by_its_matrix(
    plane: int,
    centre: tuple[float, float],
    angle: float,
    points: list[tuple[float, float]],
    incremental: bool,
) -> None:
    (a, b), _ = PLANES[plane]
    t = math.radians(angle)
    matrix = np.array([[math.cos(t), -math.sin(t)], [math.sin(t), math.cos(t)]])
    steps = np.diff(np.array([(0.0, 0.0), *points]), axis=0)
    made = moves_of(
        f"G{plane} G90 G0 X0. Y0. Z0.",
        f"G68 {words(a + b, centre)} {word('R', angle)}",
        *[
            f"{'G91 ' if incremental and i else ''}G1 {words(a + b, steps[i] if incremental and i else p)} F10."
            for i, p in enumerate(points)
        ],
        "G69",
    )
    expected = (np.array(points) - centre) @ matrix.T + centre
    got = np.array([point(m, a.lower() + b.lower()) for m in made[1:]])
    np.testing.assert_allclose(got, expected, atol=1e-5)


@pytest.mark.parametrize(
    ("block", "x", "z"),
    [("X10. Z10.", 54.142, 20.0), ("X28.284 Z10.", 67.071, 7.071), ("X20. Z10.", 61.213, 12.929)],
)
def test_the_table_of_g68_1(block: str, x: float, z: float) -> None:
    """The table is `G68.1 X40 Z20 R45` of the 988TA. [TA 5]"""
    made = moves_of("G68.1 X40. Z20. R45.", f"G1 {block} F100.", control="gsk-988ta")[-1]
    assert made.x == pytest.approx(x, abs=1.1e-3)
    assert made.z == pytest.approx(z, abs=1.1e-3)


@given(
    centre=st.tuples(*[coordinate(100)] * 3),
    scale=st.one_of(
        st.floats(0.1, 10).map(lambda s: [round(s, 3)] * 3),
        st.lists(st.floats(0.1, 10).map(lambda s: round(s, 3)), min_size=3, max_size=3),
    ),
    end=st.tuples(*[coordinate(100)] * 3),
)
def test_scaling_stretches_from_its_centre(
    centre: tuple[float, ...], scale: list[float], end: tuple[float, ...]
) -> None:
    by = f"P{scale[0] * 1000:.0f}" if len(set(scale)) == 1 else words("IJK", scale)
    made = moves_of(f"G51 {words('XYZ', centre)} {by}", f"G1 {words('XYZ', end)} F10.", "G50")[-1]
    expected = np.array(centre) + (np.array(end) - centre) * scale
    np.testing.assert_allclose(point(made), expected, atol=1e-5)


@given(
    radius=st.floats(1, 50).map(lambda r: round(r, 3)),
    scale=st.floats(0.2, 5).map(lambda s: round(s, 3)),
    by=st.sampled_from(["I", "R"]),
)
def test_a_scaled_circle_has_the_scaled_radius(radius: float, scale: float, by: str) -> None:
    size = word("I", -radius) if by == "I" else word("R", radius)
    made = moves_of(
        f"G0 {words('XY', [radius, 0])}",
        f"G51 X0. Y0. Z0. P{scale * 1000:.0f}",
        f"G1 {words('XY', [radius, 0])} F10.",
        f"G3 {words('XY', [0, radius])} {size}",
    )[-1]
    assert made.length == pytest.approx(math.pi / 2 * radius * scale, rel=1e-6)
    np.testing.assert_allclose([made.cx, made.cy], [0, 0], atol=1e-5)


SYSTEMS = {f"G{53 + n}": (10.0 * n, -7.0 * n, 3.0 * n) for n in range(1, 7)}
orders = st.lists(
    st.one_of(
        st.sampled_from(sorted(SYSTEMS)).map(lambda code: (code, (0.0, 0.0, 0.0))),
        st.tuples(
            st.sampled_from(["G52", "G92", "G0", "G91 G0", "G53"]),
            st.tuples(*[coordinate(100)] * 3),
        ),
    ),
    max_size=12,
)


@given(orders=orders)
def test_the_machine_stands_at_the_sum_of_its_offsets(
    orders: list[tuple[str, tuple[float, float, float]]],
) -> None:
    """machine = work + EXT + G54... + G92 + G52; a block that sets an offset moves nothing."""
    external = np.array([1.0, 2.0, 3.0])
    machine = np.zeros(3)
    zero, shift, local = np.array(SYSTEMS["G54"]), np.zeros(3), np.zeros(3)
    blocks, expected = ["G54 G90"], []
    for code, values in orders:
        given_values = np.array(values)
        blocks.append(code if code in SYSTEMS else f"G90 {code} {words('XYZ', values)}")
        if code in SYSTEMS:
            zero = np.array(SYSTEMS[code])
            continue
        if code == "G52":
            local = given_values
        elif code == "G92":
            local = np.zeros(3)
            shift = machine - external - zero - given_values
        else:
            if code == "G53":
                machine = given_values
            elif code == "G0":
                machine = given_values + external + zero + shift + local
            else:
                blocks[-1] = blocks[-1].removeprefix("G90 ")
                machine = machine + given_values
            expected.append((machine, machine - external - zero - shift - local))
    offsets = {name: dict(zip("XYZ", v, strict=True)) for name, v in SYSTEMS.items()}
    offsets["EXT"] = dict(zip("XYZ", external.tolist(), strict=True))
    made = moves_of(*blocks, work_offsets=offsets)
    assert len(made) == len(expected)
    for move, (at_machine, at_work) in zip(made, expected, strict=True):
        np.testing.assert_allclose(point(move, ("mx", "my", "mz")), at_machine, atol=1e-6)
        np.testing.assert_allclose(point(move), at_work, atol=1e-6)


# ---- cycles ----


def parts(
    moves: Sequence[cncsub.Move], start: Vector, axes: str
) -> Iterator[tuple[cncsub.Move, Vector, Vector]]:
    """Yield every move with its start and its end."""
    here = start
    for move in moves:
        there = point(move, axes)
        yield move, here, there
        here = there


@given(
    code=st.sampled_from(["G73", "G81", "G82", "G83", "G85", "G86", "G89", "G84", "G74"]),
    level=st.floats(5, 50).map(lambda v: round(v, 3)),
    gap=st.floats(0, 4).map(lambda v: round(v, 3)),
    depth=st.floats(1, 60).map(lambda v: round(v, 3)),
    peck=st.floats(0.6, 20).map(lambda v: round(v, 3)),
    back=st.sampled_from(["G98", "G99"]),
    incremental=st.booleans(),
    count=st.integers(1, 4),
)
def test_every_hole_is_as_deep_as_it_is_written(
    code: str,
    level: float,
    gap: float,
    depth: float,
    peck: float,
    back: str,
    incremental: bool,
    count: int,
) -> None:
    r = gap
    bottom = round(r - depth, 3)
    pecks = code in ("G73", "G83")
    extra = (word("Q", peck) if pecks else "") + (" P500" if code in ("G82", "G89") else "")
    if incremental:
        data = (
            f"G91 {back} {code} {words('XYZR', [10, 5, -depth, r - level])} {extra} F60. K{count}"
        )
    else:
        data = f"{back} {code} {words('XYZR', [10, 5, bottom, r])} {extra} F60. K{count}"
    made = moves_of(f"G90 G0 {words('XYZ', [0, 0, level])}", data, "G80", increment=0.001)[1:]
    assume(level > r)
    holes = 0
    feed_down = 0.0
    for move, here, there in parts(made, np.array([0, 0, level]), "xyz"):
        way = there - here
        if move.kind == "dwell":
            assert move.time == pytest.approx(0.5)
            continue
        assert not (abs(way[2]) > 0 and np.hypot(way[0], way[1]) > 0)
        assert there[2] >= bottom - 1e-6
        if move.kind == "rapid" and way[2] < 0:
            assert there[2] > bottom  # no rapid ends on the bottom
        if move.kind == "feed" and way[2] < 0:
            feed_down -= way[2]
        if move.kind == "feed" and abs(there[2] - bottom) < 1e-6 and way[2] < 0:
            holes += 1
            expected = [10 * holes, 5 * holes] if incremental else [10, 5]
            np.testing.assert_allclose(there[:2], expected, atol=1e-6)
    assert holes == count
    # After the first hole G99 begins at R; the depth from there is the same.
    steps = math.ceil((r - bottom) / peck - 1e-6) if pecks else 1
    assert feed_down == pytest.approx(count * (r - bottom + (steps - 1) * 0.5), abs=1e-4)
    end = r if back == "G99" else level
    if not (incremental and back == "G99" and count > 1):
        assert made[-1].z == pytest.approx(end, abs=1e-6)


@st.composite
def profiles(draw: st.DrawFn) -> list[tuple[float, float]]:
    """Draw points (z, radius) of a shaft that only grows, from its face at Z0."""
    count = draw(st.integers(1, 5))
    z, radius = 0.0, draw(st.integers(2, 15))
    found = [(z, float(radius))]
    for _ in range(count):
        z -= draw(st.integers(1, 15))
        radius += draw(st.integers(0, 8))
        found.append((z, float(radius)))
    return found


def shaft(
    profile: Sequence[tuple[float, float]], by_z: float = 0.0, by_radius: float = 0.0
) -> Polygon:
    moved = [(z + by_z, radius + by_radius) for z, radius in profile]
    return Polygon([*moved, (moved[-1][0], -1000), (moved[0][0], -1000)])


@pytest.mark.parametrize("cycle", ["G71", "G72", "G73"])
@given(
    profile=profiles(),
    depth=st.floats(0.5, 4).map(lambda v: round(v, 2)),
    allowance=st.floats(0, 1).map(lambda v: round(v, 2)),
    across=st.floats(0, 1).map(lambda v: round(v, 2)),
    arc=st.booleans(),
    control=st.sampled_from(["gsk-980tdi", "gsk-988ta", "fanuc-0i-f"]),
)
def test_roughing_never_cuts_into_the_allowance_and_g70_finishes(
    cycle: str,
    profile: list[tuple[float, float]],
    depth: float,
    allowance: float,
    across: float,
    arc: bool,
    control: str,
) -> None:
    stock = profile[-1][1] + 2
    start = np.array([2.0, stock])
    if arc:  # a quarter circle into the last shoulder
        z, radius = profile[-1]
        profile = [*profile, (z - 3.0, radius + 3.0)]
        start = np.array([2.0, stock + 3])
    sides = [f"G1 {words('ZX', [z, 2 * radius])}" for z, radius in profile[1:]]
    if arc:
        sides[-1] = f"G2 {words('ZX', [profile[-1][0], 2 * profile[-1][1]])} R3."
    if cycle == "G72":  # from the shoulder to the face
        sides = [f"G1 {words('ZX', [z, 2 * radius])}" for z, radius in profile[-2::-1]]
        if arc:
            sides[0] = f"G3 {words('ZX', [profile[-2][0], 2 * profile[-2][1]])} R3."
        inward = f"N10 G0 {word('Z', profile[-1][0])}"
        sides.insert(0, f"G1 {word('X', 2 * profile[-1][1])}")
        first, last = f"G72 {word('W', depth)} R0.5", "G72"
    else:
        inward = f"N10 G0 {word('X', 2 * profile[0][1])}"
        sides.insert(0, f"G1 {word('Z', 0)}")
        first, last = f"G71 {word('U', depth)} R0.5", "G71"
    if cycle == "G73":
        inward = f"N10 G0 {words('XZ', [2 * profile[0][1], 2])}"
        first, last = "G73 U6. W2. R4", "G73"
    shift = words("UW", [2 * allowance, across])
    made = moves_of(
        f"G98 G0 {words('ZX', [start[0], 2 * start[1]])}",
        first,
        f"{last} P10 Q20 {shift} F100.",
        inward,
        *sides[:-1],
        f"N20 {sides[-1]}",
        "M8",
        "G70 P10 Q20",
        control=control,
        machine="lathe-a",
        increment=0.001,
    )
    step = [m.step for m in made]
    rough = [m for m in made if m.step == 2]
    finish = [m for m in made if m.step == max(step)]
    assert rough
    assert finish
    drawn = profile
    if arc:  # the last side is a quarter circle around a point beside the corner
        z, radius = profile[-2]
        turns = np.linspace(0, math.pi / 2, 400)
        rounding = zip(z - 3 * np.sin(turns), radius + 3 - 3 * np.cos(turns), strict=True)
        drawn = [*profile[:-1], *rounding]
    part = shaft(drawn, across, allowance).buffer(-1e-4)
    radii = lambda m: np.array([m.z, m.x / 2])  # noqa: E731
    here = start
    for move in rough:
        there = radii(move)
        if move.kind in ("rapid", "feed"):
            line = LineString([here, there])
            assert line.intersection(part).length < 1e-6, (move, part.wkt)
        here = there
    np.testing.assert_allclose(here, start, atol=1e-6)
    ends = {(round(m.z or 0, 4), round((m.x or 0) / 2, 4)) for m in finish if m.kind != "rapid"}
    wanted = {(z, radius) for z, radius in profile}
    assert wanted - {profile[0]} <= ends or wanted - {profile[-1]} <= ends
    np.testing.assert_allclose(radii(finish[-1]), start, atol=1e-6)
