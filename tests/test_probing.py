"""A probe and a workpiece: touches compared with sampling, the interface, and the examples."""

import math
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import cncsub
from cncsub import Box, Cylinder, Inputs, Plane, Sphere, Workpiece

EXAMPLES = Path(__file__).parent.parent / "examples" / "fanuc"
TOLERANCE = 1e-5  # mm

Point = tuple[float, float, float]


def touch(part: Workpiece, start: Point, end: Point) -> Point | None:
    """Return where a G31 between two points stops, `None` if it meets nothing."""
    library = cncsub.loads("O1\nN10 G90 G31 X#1 Y#2 Z#3 F500\nN20 M30\n", control="fanuc-0i-f")
    run = library.run(
        setup={"start": dict(zip("XYZ", start, strict=True)), "increment": 1e-7},
        variables=dict(zip((1, 2, 3), end, strict=True)),
        inputs=Inputs(workpiece=part),
    )
    assert run.alarm is None
    (move,) = run.moves
    assert move.x is not None
    assert move.y is not None
    assert move.z is not None
    assert bool(run.missed_skips) == (move.skip == "missed")
    return None if move.skip == "missed" else (move.x, move.y, move.z)


# The distance of a point from a body, written again from the definition.


def outside_box(p: Point, low: Point, high: Point) -> float:
    over = [max(a - x, x - b) for x, a, b in zip(p, low, high, strict=True)]
    return math.hypot(*(max(o, 0) for o in over)) if max(over) > 0 else max(over)


def outside_sphere(p: Point, centre: Point, radius: float) -> float:
    return math.dist(p, centre) - radius


def outside_cylinder(p: Point, centre: Point, radius: float, low: float, high: float) -> float:
    side = math.dist(p[:2], centre[:2]) - radius
    end = max(low - p[2], p[2] - high)
    return math.hypot(side, end) if min(side, end) > 0 else max(side, end)


lengths = st.floats(-50, 50).map(lambda x: round(x, 3))
points = st.tuples(lengths, lengths, lengths)
sizes = st.floats(0.5, 30).map(lambda x: round(x, 3))
radii = st.floats(0, 5).map(lambda x: round(x, 3))


def at(point: Point) -> dict[str, float]:
    return dict(zip("XYZ", point, strict=True))


@st.composite
def solids(draw: st.DrawFn) -> tuple[Any, Callable[[Point], float]]:
    centre, size = draw(points), draw(sizes)
    shape = draw(st.sampled_from(["box", "sphere", "cylinder"]))
    if shape == "sphere":
        return Sphere(at(centre), size), lambda p: outside_sphere(p, centre, size)
    if shape == "cylinder":
        half = draw(sizes)
        low, high = centre[2] - half, centre[2] + half
        solid = Cylinder(at(centre), size, ends=(-half, half))
        return solid, lambda p: outside_cylinder(p, centre, size, low, high)
    sides = draw(st.tuples(sizes, sizes, sizes))
    low3 = tuple(c - s for c, s in zip(centre, sides, strict=True))
    high3 = tuple(c + s for c, s in zip(centre, sides, strict=True))
    box = Box({a: (b, c) for a, b, c in zip("XYZ", low3, high3, strict=True)})
    return box, lambda p: outside_box(p, low3, high3)  # type: ignore[arg-type]


@given(st.lists(solids(), min_size=1, max_size=3), points, points, radii)
def test_a_ball_stops_where_it_first_presses_on_a_body(
    bodies: list[tuple[Any, Callable[[Point], float]]], start: Point, end: Point, radius: float
) -> None:
    def gap(p: Point) -> float:
        return min(outside(p) for _, outside in bodies) - radius

    length = math.dist(start, end)
    assume(length > 0.1)
    samples = [
        tuple(a + (b - a) * i / 400 for a, b in zip(start, end, strict=True)) for i in range(401)
    ]
    stopped = touch(Workpiece([solid for solid, _ in bodies], stylus=radius), start, end)
    if stopped is None:
        assert min(map(gap, samples)) > -0.01  # type: ignore[arg-type]
        return
    if gap(start) < -0.001:
        assert math.dist(stopped, start) < TOLERANCE
        return
    assert abs(gap(stopped)) < TOLERANCE
    done = math.dist(start, stopped)
    before = [p for p in samples if math.dist(start, p) < done - TOLERANCE]  # type: ignore[arg-type]
    assert all(gap(p) > -TOLERANCE for p in before)  # type: ignore[arg-type]


@given(points, sizes, st.floats(0.01, 0.95), points, st.floats(0, 0.9))
def test_a_ball_in_a_bore_stops_at_its_wall(
    centre: Point, radius: float, share: float, way: Point, inside: float
) -> None:
    ball = radius * share
    free = radius - ball
    length = math.hypot(way[0], way[1])
    assume(length > 0.1)
    start = (centre[0] + free * inside, centre[1], centre[2])
    end = (start[0] + way[0] * 100, start[1] + way[1] * 100, start[2])
    bore = Cylinder(at(centre), radius, inside=True)
    stopped = touch(Workpiece([bore], stylus=ball), start, end)
    assume(math.hypot(end[0] - centre[0], end[1] - centre[1]) > free + 0.01)
    assert stopped is not None
    assert math.isclose(
        math.hypot(stopped[0] - centre[0], stopped[1] - centre[1]), free, abs_tol=TOLERANCE
    )


BLOCK = Box({"X": (0, 80), "Y": (0, 50), "Z": (-20, 0)})
BORE = Cylinder({"X": 40, "Y": 25, "Z": 0}, 10, ends=(-15, 0), inside=True)


@pytest.mark.parametrize(
    ("start", "end", "stop"),
    [
        ((-10, 25, -5), (10, 25, -5), (-3, 25, -5)),  # the side
        ((-10, 25, 2), (10, 25, 2), (math.nan,) * 3),  # over the edge: its round meets the ball
        ((10, 10, 20), (10, 10, -20), (10, 10, 3)),  # the top
        ((40, 25, 20), (40, 25, -30), (40, 25, -12)),  # through the bore to its floor
        ((40, 25, -5), (60, 25, -5), (47, 25, -5)),  # the wall of the bore
        ((47, 25, -5), (40, 25, -5), None),  # away from it
        ((47, 25, -5), (47, 25, -8), None),  # along it
        ((47, 25, -5), (48, 25, -5), (47, 25, -5)),  # on into it
        ((-3, 25, -5), (-9, 25, -5), None),  # away from the side
        ((-3, 0, -5), (-3, 50, -5), None),  # along the side
        ((10, 10, -5), (10, 10, 30), (10, 10, -5)),  # begins inside
        ((0, 0, 30), (80, 50, 30), None),  # above all
        ((40, 25, 20), (60, 25, 20), None),
    ],
)
def test_a_block_with_a_bore(start: Point, end: Point, stop: Point | None) -> None:
    stopped = touch(Workpiece([BLOCK, BORE], stylus=3), start, end)
    if stop is not None and math.isnan(stop[0]):
        stop = (-math.sqrt(3**2 - 2**2), 25, 2)
    assert (stopped is None) == (stop is None)
    if stopped is not None and stop is not None:
        assert stopped == pytest.approx(stop, abs=TOLERANCE)


def test_a_pocket_of_a_box_and_a_hole_in_a_hole() -> None:
    pocket = Box({"X": (10, 70), "Y": (10, 40), "Z": (-8, 0)}, inside=True)
    bore = Cylinder({"X": 40, "Y": 25, "Z": 0}, 5, ends=(-20, -8), inside=True)
    part = Workpiece([BLOCK, pocket, bore], stylus=2)
    assert touch(part, (20, 20, 10), (20, 20, -30)) == pytest.approx((20, 20, -6))
    assert touch(part, (20, 20, -5), (0, 20, -5)) == pytest.approx((12, 20, -5))
    assert touch(part, (40, 25, 10), (40, 25, -30)) is None
    assert touch(part, (40, 25, -15), (40, 0, -15)) == pytest.approx((40, 22, -15))


def test_an_empty_workpiece_is_met_by_nothing() -> None:
    assert touch(Workpiece([], stylus=3), (0, 0, 0), (10, 0, 0)) is None


def test_the_end_of_the_ball_may_be_the_point_that_moves() -> None:
    part = Workpiece([BLOCK], stylus=3, ball="end")
    assert touch(part, (10, 10, 20), (10, 10, -20)) == pytest.approx((10, 10, 0))
    assert touch(part, (-10, 25, -5), (10, 25, -5)) == pytest.approx((-3, 25, -5))


PROGRAM = """O1
N10 G90 G54 G43 H1 G0 Z50.
N20 G31 Z-20. F100
N30 #100=#5063
N40 #101=#5003
N50 G10 L2 P1 Z#5003
N60 G90 G0 Z50.
N70 G31 Z-20. F100
N80 #102=#5003
N90 M30
"""
SETUP = {"length_offsets": {1: 100}, "work_offsets": {"G54": {"Z": -300}}, "start": {"Z": 100}}


def test_a_workpiece_stays_where_it_is_when_the_program_moves_its_zero_point() -> None:
    library = cncsub.loads(PROGRAM, control="fanuc-0i-f")
    inputs = Inputs(workpiece=Workpiece([Plane({"Z": 4})], stylus=2))
    run = library.run(setup=SETUP, inputs=inputs)
    # G54 Z becomes 6, so the face at Z-296 of the machine lies out of reach from then on.
    assert run.variables[100] == 106
    assert run.variables[101] == 6
    assert [move.skip for move in run.moves if move.skip != "no"] == ["touched", "missed"]
    assert [(missed.n, missed.step) for missed in run.missed_skips] == [(70, 6)]


def test_machine_coordinates_and_a_stylus_of_another_length() -> None:
    library = cncsub.loads(PROGRAM, control="fanuc-0i-f")
    face = [Plane({"Z": -297})]
    run = library.run(
        setup=SETUP, inputs={"workpiece": Workpiece(face, coordinates="machine", stylus=1)}
    )
    assert run.variables[101] == 4
    # The offset says 100, but the stylus is 90 long: it meets the face ten lower.
    run = library.run(
        setup=SETUP, inputs={"workpiece": Workpiece(face, coordinates="machine", length=90)}
    )
    assert run.variables[101] == -7


def test_a_workpiece_of_a_lathe_has_diameters() -> None:
    text = "O1\nN10 G98 G31 X0 F100\nN20 #100=#5061\nN30 M30\n"
    part = Workpiece([Cylinder({"X": 0}, radius=20)], stylus=1)
    run = cncsub.loads(text, control="gsk-988ta").run(
        setup={"start": {"X": 100, "Z": -5}}, inputs={"workpiece": part}
    )
    assert run.variables[100] == 42


def test_skips_of_a_toml_file_are_told_by_signal(tmp_path: Path) -> None:
    file = tmp_path / "in.toml"
    file.write_text('[skips]\n1 = [{ X = 10 }, "never"]\n2 = [0.5]\n')
    inputs = Inputs.from_toml(file)
    assert inputs.skips == {1: [{"X": 10}, None], 2: [0.5]}
    with pytest.raises(
        ValueError, match="solids\\[0\\], a plane: signal: a skip signal must be 1 to 8"
    ):
        Inputs(workpiece=Workpiece([Plane({"X": 1}, signal=0)]))


def test_an_alarm_gives_its_skip_signals_back() -> None:
    text = "O1\nN10 G90 G31 X10. P2 F100\nN20 G31 X20. P2 F100\nN30 M30\n"
    library = cncsub.loads(text, control="fanuc-0i-f")
    setup = {"start": {"X": 0}, "limits": {"X": (-1, 12)}}
    machine = library.machine(setup=setup, inputs={"skips": {2: [{"X": 4}, {"X": 15}]}})
    machine.run()
    assert machine.alarm is not None
    assert machine.alarm.cause == "over-travel"
    assert machine.variables[5061] == 4


def test_told_skips_come_first_and_the_workpiece_behind_them() -> None:
    text = "O1\nN10 G90 G31 X50. F100\nN20 G31 X60.\nN30 G31 X100.\nN40 G0 X0\nN50 G31 X100.\nN60 M30\n"
    inputs = Inputs(
        skips=[{"X": 12.5}, None, {"Y": 3}], workpiece=Workpiece([Plane({"X": 77}, faces="-X")])
    )
    run = cncsub.loads(text, control="fanuc-0i-f").run(
        setup={"start": {"X": 0, "Y": 0}}, inputs=inputs
    )
    assert [move.x for move in run.moves if move.skip != "no"] == [12.5, 60, 100, 77]
    assert [missed.n for missed in run.missed_skips] == [20, 30]


def test_a_machine_a_copy_and_a_run_touch_the_same() -> None:
    library = cncsub.loads(PROGRAM, control="fanuc-30i")
    options: dict[str, Any] = {
        "setup": SETUP,
        "inputs": Inputs(skips=[{"Z": 9}], workpiece=Workpiece([Plane({"Z": -297})])),
    }
    run = library.run(**options)
    machine = library.machine(**options)
    list(machine)
    snapshot = library.machine(**options)
    snapshot.step()
    copy = snapshot.copy()
    list(snapshot)
    list(copy)
    for other in machine, snapshot, copy:
        assert list(other.moves) == list(run.moves)
        assert other.missed_skips == run.missed_skips


def test_an_alarm_in_a_block_of_g31_leaves_its_skip_to_the_next() -> None:
    text = "O1\nN10 G90 G31 X50. F100\nN20 G31 X60.\nN30 M30\n"
    library = cncsub.loads(text, control="fanuc-0i-f")
    setup = {"start": {"X": 0}, "limits": {"X": (-1, 20)}}
    machine = library.machine(setup=setup, inputs={"skips": [0.5, {"X": 3}]})
    assert machine.step() is None
    assert machine.alarm is not None
    machine.reset()
    assert machine.step() is None
    assert machine.alarm is not None
    assert machine.position["X"] == 0
    assert not machine.missed_skips


def test_codes_answer_with_signals() -> None:
    text = """O1
N10 M117
N20 #100=#1004
N30 M118 T5
N40 #101=#1004
N50 #102=#500
N60 M30
"""
    inputs = Inputs(answers={"M117": {1004: 1}, "M0118": {1004: 0}, "T05": {500: 7}})
    run = cncsub.loads(text, control="fanuc-0i-f").run(inputs=inputs)
    assert (run.variables[100], run.variables[101], run.variables[102]) == (1, 0, 7)


def test_signals_of_a_machine_are_set_while_it_runs() -> None:
    text = "O1\nN10 IF[#1004 EQ 0]GOTO 10\nN20 #100=#1004\nN30 #101=#1032\nN40 M30\n"
    machine = cncsub.loads(text, control="fanuc-0i-f").machine(max_blocks=100)
    machine.signals[1004] = 1
    machine.signals[1032] = 5
    machine.run()
    assert (machine.variables[100], machine.variables[101]) == (1, 5)
    assert dict(machine.signals) == {1004: 1, 1032: 5}
    with pytest.raises(KeyError, match="#500 is not a signal on fanuc-0i-f"):
        machine.signals[500] = 1
    with pytest.raises(KeyError, match="not a signal"):
        machine.signals[2**40]
    with pytest.raises(TypeError, match="signals: #1004 must be a number"):
        machine.signals[1004] = "on"  # type: ignore[assignment]


def test_inputs_and_workpieces_are_pickled_and_compared() -> None:
    part = Workpiece([BLOCK, BORE, Sphere({"X": 1}, 2)], stylus=1, coordinates="G54.1 P2")
    inputs = Inputs(skips=[{"X": 1}, None], workpiece=part, answers={"M117": {1004: 1}})
    assert pickle.loads(pickle.dumps(inputs)) == inputs


@pytest.mark.parametrize(
    ("inputs", "error", "words"),
    [
        ({"skips": [2]}, ValueError, r"skips\[0\] must be a fraction .* 0 to 1, not 2"),
        ({"skips": [0.5, {"Q": 1}]}, ValueError, r"skips\[1\]: 'Q' is not an axis"),
        (
            {"skips": [{"X": 1, "Y": 2}]},
            ValueError,
            r"skips\[0\] must be the coordinate of one axis",
        ),
        ({"skips": [{"X": None}]}, ValueError, "X has no coordinate"),
        ({"skips": {9: [1]}}, ValueError, "skips: a skip signal must be 1 to 8, not 9"),
        (
            {"skips": {"1": [1]}},
            TypeError,
            "skips: a skip signal must be a number 1 to 8, or one of XAE, YAE, ZAE, not '1'",
        ),
        ({"skips": {2: 1}}, TypeError, r"skips\[2\] must be a list, not int"),
        (
            {"skips": {2: [0.5, 7]}},
            ValueError,
            r"skips\[2\]\[1\] must be a fraction .* 0 to 1, not 7",
        ),
        ({"answers": {"G31": {1004: 1}}}, ValueError, "'G31' is not an M or T code"),
        ({"answers": {"M8": {1004: 1}, "M08": {}}}, ValueError, "M8 twice"),
        (
            {"answers": {"M8": 1}},
            TypeError,
            r"answers\['M8'\] must be a mapping from variable numbers",
        ),
        ({"answers": {"M8": {3000: 1}}}, ValueError, "answers: #3000"),
        ({"workpiece": 3}, TypeError, "a cncsub.Workpiece or a mapping"),
        ({"workpiece": {}}, ValueError, "workpiece has no solids"),
        (
            {"workpiece": {"solids": [], "styllus": 1}},
            ValueError,
            "has no 'styllus'; did you mean stylus",
        ),
        ({"workpiece": {"solids": [{"ball": 1}]}}, ValueError, r"solids\[0\] must have a shape"),
        ({"workpiece": {"solids": [{"sphere": {}}]}}, ValueError, "a sphere has no radius"),
        (
            {"workpiece": {"solids": [{"plane": {"X": 1}, "face": "+X"}]}},
            ValueError,
            "a plane has no 'face'",
        ),
        (
            {"workpiece": {"solids": [{"plane": {"X": 1}, "faces": "X+Y"}]}},
            ValueError,
            "a sign and an axis",
        ),
        ({"workpiece": {"solids": [{"box": {"X": (3, 1)}}]}}, ValueError, "lower to the higher"),
        ({"workpiece": {"solids": [{"box": {"A": (1, 2)}}]}}, ValueError, "X, Y and Z"),
        (
            {"workpiece": {"solids": [{"sphere": {}, "radius": 0}]}},
            ValueError,
            r"solids\[0\], a sphere: radius must be more than 0",
        ),
        ({"workpiece": {"solids": [], "stylus": -1}}, ValueError, "must not be negative"),
        ({"workpiece": {"solids": [], "ball": "tip"}}, ValueError, "'centre' or 'end'"),
        ({"workpiece": {"solids": [], "coordinates": "G60"}}, ValueError, "coordinates must be"),
        (
            {"workpiece": {"solids": [], "coordinates": "G54.1 P99"}},
            ValueError,
            "fanuc-0i-f has no G54.1 P99",
        ),
    ],
)
def test_wrong_inputs_are_told_with_their_place(
    inputs: dict[str, Any], error: type[Exception], words: str
) -> None:
    library = cncsub.loads("O1\nN10 M30\n", control="fanuc-0i-f")
    with pytest.raises(error, match=words):
        library.run(inputs=inputs)


# The results of the macros of examples/fanuc/probing, as part.toml says.
FOUND = {
    510: 0.04,  # the top
    511: 0.12,  # the left side
    512: 24.99,  # the middle along Y
    513: 50.12,  # the width
    514: 60.1,  # the bore: X, Y, diameter
    515: 24.95,
    516: 20.016,
    517: 30.03,  # the boss
    518: 25.02,
    519: 11.98,
    520: 0.12,  # the corner
    521: -0.07,
}
PROBING = EXAMPLES / "probing"


@pytest.mark.parametrize(
    "control",
    [name for name in cncsub.controls if name.startswith(("fanuc", "mitsubishi"))],
)
def test_probing_cycles_find_the_workpiece(control: str) -> None:
    setup = cncsub.Setup.from_toml(PROBING / "setup.toml")
    inputs = Inputs.from_toml(PROBING / "part.toml")
    run = cncsub.load(PROBING, control=control).run(setup=setup, inputs=inputs)
    run.raise_for_alarm()
    for number, value in FOUND.items():
        assert run.variables[number] == pytest.approx(value, abs=2e-6), f"#{number}"
    # Moves on the way to a place are also G31, and meet nothing.
    assert {(missed.program, missed.n) for missed in run.missed_skips} == {("O9810", 120)}


def test_a_probing_cycle_alarms_where_the_part_is_not() -> None:
    setup = cncsub.Setup.from_toml(PROBING / "setup.toml")
    library = cncsub.load(PROBING, control="fanuc-0i-f")
    answers = {"M117": {1004: 1}}
    run = library.run(setup=setup, inputs={"workpiece": {"solids": []}, "answers": answers})
    assert run.alarm is not None
    assert (run.alarm.number, run.alarm.program) == ("MC3093", "O9811")
    run = library.run(setup=setup)
    assert run.alarm is not None
    assert (run.alarm.number, run.alarm.n) == ("MC3090", 900)


def test_the_way_to_a_place_is_protected() -> None:
    setup = cncsub.Setup.from_toml(PROBING / "setup.toml")
    block = Box({"X": (-40, -20), "Y": (-40, 90), "Z": (-30, 30)})
    run = cncsub.load(PROBING, control="fanuc-0i-f").run(
        "O9810",
        setup={"start": {"X": 0, "Y": 0, "Z": 0}},
        variables={24: -60, 9: 500},
        inputs={"workpiece": Workpiece([block], stylus=2)},
    )
    assert setup.machine == "mill"
    assert run.alarm is not None
    assert run.alarm.number == "MC3091"
    assert run.position["X"] == -18
