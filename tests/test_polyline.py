"""The path as points, the places where moves begin, and the codes with their steps."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import cncsub

CONTROL = "fanuc-0i-f"
PLANES = {17: (0, 1, 2), 18: (2, 0, 1), 19: (1, 2, 0)}
COMPENSATED = """O1
G0 X0 Y0 Z5.
G1 Z-1. F100
G41 D1 X10. Y0
G3 X20. Y10. I0 J10.
G1 Y30.
G2 X30. Y40. R10.
G1 X50.
G40 X60. Y60.
M30
"""


def ran(text: str, control: str = CONTROL, **options: Any) -> cncsub.Run:
    run = cncsub.loads(text, control=control).run(**options)
    assert run.alarm is None, run.alarm
    return run


def distances(points: Any, line: Any) -> Any:
    """Return the distance of each point from the nearest chord of a line."""
    a, way = line[:-1], np.diff(line, axis=0)
    length = np.maximum((way**2).sum(axis=1), 1e-300)
    part = np.clip(((points[:, None] - a) * way).sum(axis=2) / length, 0, 1)
    return np.sqrt(((points[:, None] - a - part[..., None] * way) ** 2).sum(axis=2)).min(axis=1)


def true_arc(start: Any, end: Any, centre: Any, plane: int, clockwise: bool, count: int) -> Any:
    """Return points of the arc that the words mean; a full circle if its end is its start."""
    a, b, _ = PLANES[plane]
    first = math.atan2(start[b] - centre[b], start[a] - centre[a])
    last = math.atan2(end[b] - centre[b], end[a] - centre[a])
    turn = (first - last if clockwise else last - first) % (2 * math.pi)
    if turn < 1e-7 or turn > 2 * math.pi - 1e-7:
        turn = 2 * math.pi
    part = np.linspace(0, 1, count)[:, None]
    points = start + part * (end - start)
    radius = math.dist((start[a], start[b]), (centre[a], centre[b]))
    radius = radius + part[:, 0] * (math.dist((end[a], end[b]), (centre[a], centre[b])) - radius)
    angle = first + part[:, 0] * (-turn if clockwise else turn)
    points[:, a] = centre[a] + radius * np.cos(angle)
    points[:, b] = centre[b] + radius * np.sin(angle)
    return points


angles = st.integers(0, 71).map(lambda fives: math.radians(5 * fives))


@settings(max_examples=50, deadline=None)
@given(
    plane=st.sampled_from(sorted(PLANES)),
    clockwise=st.booleans(),
    radius=st.floats(0.05, 300),
    first=angles,
    last=angles,
    rise=st.sampled_from([0.0, -3.0, 40.0]),
    part=st.floats(1e-4, 2),
)
def test_every_chord_is_within_the_tolerance_of_the_true_arc_and_ends_are_exact(
    plane: int,
    clockwise: bool,
    radius: float,
    first: float,
    last: float,
    rise: float,
    part: float,
) -> None:
    a, b, across = PLANES[plane]
    radius = round(radius, 3)
    tolerance = radius * part
    start, end, centre = [0.0] * 3, [0.0] * 3, [0.0] * 3
    centre[a], centre[b], centre[across] = 10.0, -20.0, 5.0
    for point, angle in ((start, first), (end, last)):
        point[a] = round(centre[a] + radius * math.cos(angle), 6)
        point[b] = round(centre[b] + radius * math.sin(angle), 6)
    start[across], end[across] = 5.0, 5.0 + rise
    words = [f"{letter}{value:.6f}" for letter, value in zip("XYZ", end)]
    to_centre = [f"{'IJK'[axis]}{centre[axis] - start[axis]:.6f}" for axis in (a, b)]
    run = ran(
        f"O1\nG{plane}\nG0 X{start[0]:.6f} Y{start[1]:.6f} Z{start[2]:.6f}\n"
        f"G{2 if clockwise else 3} {' '.join(words + to_centre)} F100\nM30\n"
    )
    path = run.polyline(tolerance)
    move = run.moves[1]
    arc = path.points[path.move == 1]
    assert arc[-1].tolist() == [move.x, move.y, move.z]
    line = np.vstack((path.points[path.move == 0][-1], arc))
    found = [5.0 if value is None else value for value in (move.cx, move.cy, move.cz)]
    assert found == pytest.approx(centre, abs=2e-3)  # a control rounds the words
    truth = true_arc(line[0], line[-1], found, plane, clockwise, 1 + 40 * len(arc))
    assert distances(truth, line).max() <= tolerance + 1e-6
    # The points lie on the arc, so a chord leaves it by no more if it is that near.
    assert distances(arc, truth).max() <= 1e-6 + radius * (math.pi / 40 / len(arc)) ** 2


@pytest.mark.parametrize("coordinates", ["tool", "machine"])
@pytest.mark.parametrize(
    ("text", "control", "options"),
    [
        (COMPENSATED, CONTROL, {"setup": cncsub.Setup(radius_offsets={1: 3.0})}),
        ("O1\nG0 X0 Y0 Z0\nG3 X0 Y0 Z9. I10. F100\nG2 X5. Y0 R-2.6\nM30\n", CONTROL, {}),
        ("O1\nG51.1 X0\nG0 X10. Y0\nG3 X0 Y10. R10. F100\nG50.1 X0\nM30\n", CONTROL, {}),
        ("O1\nG0 X20. Z0\nG3 X40. Z-10. R10. F100\nG1 Z-30.\nM30\n", "gsk-988ta", {}),
    ],
)
def test_the_points_lie_as_far_apart_as_the_moves_are_long(
    text: str, control: str, options: dict[str, Any], coordinates: str
) -> None:
    run = ran(text, control, **options)
    path = run.polyline(1e-5, coordinates=coordinates)
    way = np.linalg.norm(np.diff(path.points, axis=0), axis=1)
    way[path.begins[1:]] = 0
    lengths = np.bincount(path.move[1:], weights=way, minlength=len(run.moves))
    assert lengths == pytest.approx(run.moves.length, rel=1e-4, abs=1e-9)


def test_a_move_has_its_points_in_order_and_its_end_exactly() -> None:
    run = ran(COMPENSATED, setup=cncsub.Setup(radius_offsets={1: 3.0}))
    for coordinates, names in (("work", "xyz"), ("machine", ("mx", "my", "mz"))):
        path = run.polyline(0.01, coordinates=coordinates)
        last = np.flatnonzero(np.append(np.diff(path.move) != 0, True))
        assert path.move[last].tolist() == list(range(len(run.moves)))
        for axis, name in enumerate(names):
            assert path.points[last, axis].tolist() == run.moves[name].tolist()


def test_x_of_a_lathe_is_a_radius() -> None:
    path = ran("O1\nG0 X20. Z0\nG3 X40. Z-10. R10. F100\nM30\n", "gsk-988ta").polyline(0.001)
    assert path.diameters
    arc = path.points[path.move == 1]
    assert np.allclose(np.hypot(arc[:, 0] - 10, arc[:, 2] + 10), 10, atol=1e-9)
    assert arc[-1].tolist() == [20, 0, -10]


def test_a_path_begins_anew_where_other_coordinates_come_into_force() -> None:
    text = "O1\nG54 G0 X0 Y0\nX10.\nG55 X0\nX5.\nM30\n"
    run = ran(text, setup=cncsub.Setup(work_offsets={"G54": {"X": 0}, "G55": {"X": 100}}))
    path = run.polyline(0.1)
    begun = np.flatnonzero(path.begins)
    assert path.move[begun].tolist() == [0, 2]
    assert path.points[begun[1]].tolist() == [-90, 0, 0]
    assert run.moves.sx.tolist() == [0, 0, -90, 0]
    machine = run.polyline(0.1, coordinates="machine")
    assert machine.begins.nonzero()[0].tolist() == [0]
    assert machine.x.tolist() == [0, 0, 10, 100, 105]


def test_some_of_the_moves_are_sampled_alone() -> None:
    run = ran("O1\nG0 X1.\nX2.\nG2 X4. R1. F9\nX9. R8.\nM30\n")
    whole, some = run.polyline(0.01), run.polyline(0.01, moves=range(2, 3))
    assert set(some.move.tolist()) == {2}
    assert some.begins.tolist() == [True] + [False] * (len(some) - 1)
    assert some.x[1:].tolist() == whole.x[whole.move == 2].tolist()
    assert len(run.polyline(0.01, moves=slice(4, 2))) == 0
    assert len(ran("O1\nM30\n").polyline()) == 0


@pytest.mark.parametrize("tolerance", [0, -1, math.nan, math.inf, -math.inf])
def test_a_tolerance_is_a_length_above_zero(tolerance: float) -> None:
    with pytest.raises(ValueError, match="above 0"):
        ran("O1\nG0 X1.\nM30\n").polyline(tolerance)


def test_wrong_use_is_told() -> None:
    run = ran("O1\nG0 X10.\nG2 X10. I-5. F9\nM30\n")
    with pytest.raises(ValueError, match=r"more than 50,000,002 points.*wider"):
        run.polyline(1e-300)
    with pytest.raises(TypeError, match="length in mm"):
        run.polyline("fine")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="work, tool, machine"):
        run.polyline(coordinates="G54")
    with pytest.raises(TypeError, match="slice or a range"):
        run.polyline(moves=5)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="without a step"):
        run.polyline(moves=range(0, 2, 2))


def test_threads_share_a_path_and_pieces_join() -> None:
    text = (
        "O1\nG91\n#1=0\nWHILE[#1LT700]DO1\n"
        + "G3 X1. I.5 F900\nG1 Y.1\n" * 60
        + "#1=#1+1\nEND1\nM30\n"
    )
    run = ran(text)
    path = run.polyline(0.01)
    assert len(run.moves) == 84_000
    assert path.begins.sum() == 1
    assert np.all(np.diff(path.move) >= 0)
    assert np.linalg.norm(np.diff(path.points, axis=0), axis=1).max() < 0.5


# ---- where moves begin ----


def test_a_move_begins_where_the_one_before_ended() -> None:
    run = ran(COMPENSATED, setup=cncsub.Setup(radius_offsets={1: 3.0}))
    moves = run.moves
    for axis in "xyz":
        assert moves[f"ms{axis}"][1:].tolist() == moves[f"m{axis}"][:-1].tolist()
        assert moves[f"s{axis}"][1:].tolist() == moves[axis][:-1].tolist()
    for index, row in enumerate(moves):
        for name in moves.more_columns:
            value = moves[name][index]
            assert getattr(row, name) == (None if np.isnan(value) else value)
    assert moves.compensated.tolist() == [False, False, *[True] * 6]
    assert moves.sx.flags.writeable is False
    assert set(moves.more_columns).isdisjoint(moves.columns)


@pytest.mark.parametrize(
    ("text", "control", "setup"),
    [
        (COMPENSATED, CONTROL, cncsub.Setup(radius_offsets={1: 3.0}, length_offsets={1: 50.0})),
        (
            "O1\nT0101\nG0 X60. Z5.\nG42 G1 X20. Z2. F100\nZ-10.\nG2 X40. Z-20. R10.\nG1 X50.\n"
            "G40 G0 X80.\nM30\n",
            "gsk-988ta",
            cncsub.Setup(tools={1: {"X": 2.0, "Z": 3.0, "R": 1.5, "tip": 3}}),
        ),
    ],
)
def test_the_centre_of_the_tools_arc_is_as_far_from_its_start_as_from_its_end(
    text: str, control: str, setup: cncsub.Setup
) -> None:
    run = ran(text, control, setup=setup)
    arcs = [move for move in run.moves if move.kind in ("cw", "ccw")]
    assert arcs
    for move in arcs:
        a, b, across = (f"{'xyz'[axis]}" for axis in PLANES[move.plane])
        share = {axis: 0.5 if axis == "x" and control == "gsk-988ta" else 1.0 for axis in "xyz"}
        radii = [
            math.hypot(
                *(share[n] * (getattr(move, f"{w}{n}") - getattr(move, f"mc{n}")) for n in (a, b))
            )
            for w in ("ms", "m")
        ]
        assert radii[0] == pytest.approx(radii[1], abs=1e-6)
        assert getattr(move, f"mc{across}") is None
        assert move.compensated


def test_moves_of_cycles_are_told_from_others() -> None:
    run = ran("O1\nG0 X0 Y0 Z9.\nG81 X5. Z-3. R1. F50\nX10.\nG80\nG1 X0\nM30\n")
    cycle = run.moves.cycle
    assert cycle.dtype == bool
    assert cycle.tolist() == [False, *[True] * (len(run.moves) - 2), False]
    turned = ran(
        "O1\nG0 X50. Z2.\nG71 U2. R1. F100\nG71 P10 Q20 U.5 W.1\nN10 G0 X20.\nG1 Z-10.\nN20 X50.\n"
        "G70 P10 Q20\nG0 X60.\nM30\n",
        "gsk-988ta",
    )
    assert turned.moves.cycle.tolist() == [False, *[True] * (len(turned.moves) - 2), False]


def test_columns_that_are_worked_out_reach_pandas_and_arrow_by_name() -> None:
    moves = ran(COMPENSATED).moves
    frame = moves.to_pandas(columns=["move", "msx", "cycle"])
    assert list(frame.columns) == ["move", "msx", "cycle"]
    assert frame.cycle.dtype == bool
    assert moves.to_arrow(columns=["sx"]).column_names == ["sx"]
    with pytest.raises(KeyError, match="no column 'start'"):
        moves.to_arrow(columns=["start"])
    assert "msx" in dir(moves)
    assert "msx" not in moves.to_pandas().columns


# ---- the codes ----

CODES = """O1
N10 T3 M6
N20 S1500 M3
M98 P2 L2
N30 G92 S3000
N40 M30
O2
N50 G1 X1. F100 M8
S801
M99
"""


def test_codes_join_the_steps_that_sent_them() -> None:
    run = ran(CODES)
    told = [(code.kind, code.value, code.program, code.n, code.line) for code in run.codes]
    again = [("M", 8, "O2", 50, 8), ("S", 801, "O2", None, 9)]
    assert told == [
        ("T", 3, "O1", 10, 2),
        ("M", 6, "O1", 10, 2),
        ("S", 1500, "O1", 20, 3),
        ("M", 3, "O1", 20, 3),
        *again,
        *again,
    ]
    for row, code in enumerate(run.codes):
        step = run.steps[code.step]
        assert (step.program, step.n, step.line) == (code.program, code.n, code.line)
        assert run.codes.step[row] == code.step
    of_kind = {k: run.codes.value[run.codes.kind == k].tolist() for k in run.codes.kinds}
    assert of_kind["M"] == run.m_codes
    assert of_kind["T"] == run.t_codes
    assert of_kind["S"] == [1500, 801, 801]
    assert run.codes.to_arrow()["n"].to_pylist()[-2:] == [50, None]
    assert len(ran(CODES, trace="none").codes) == 0


def test_the_codes_of_a_stream_are_those_of_the_run() -> None:
    text = "O1\nM98 P2 L999\nM30\nO2\nM8\nS100\nG91 X1.\nM99\n"
    library = cncsub.loads(text, control=CONTROL)
    whole = [dataclasses.astuple(code) for code in library.run().codes]
    parts = [dataclasses.astuple(c) for part in library.stream(rows=700) for c in part.codes]
    assert parts == whole
    assert len(whole) == 2 * 999
