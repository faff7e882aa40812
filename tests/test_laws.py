"""Laws that hold for every program, tried on generated ones."""

from __future__ import annotations

import math
import operator
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import cncsub
from ways import by_both_ways as ran

NAMES = sorted(cncsub.controls)
MACRO_CONTROLS = ["fanuc-16i", "fanuc-30i", "gsk-988ta", "mitsubishi-m700"]


# Every run is made by the short ways and by the general way alone, and both must agree.


def outcome(run: cncsub.Run) -> tuple[object, ...]:
    """Return what two runs must share to be the same run."""
    alarm = run.alarm and (run.alarm.cause, run.alarm.number, run.alarm.program, run.alarm.line)
    moves = [(m.step, m.kind, m.x, m.y, m.z) for m in run.moves]
    steps = [(s.program, s.line, s.depth, s.repeat) for s in run.steps]
    tree = [(c.parent, c.kind, c.program, c.level, c.caller_step) for c in run.calls]
    return (run.stop, alarm, steps, moves, run.m_codes, dict(run.variables), tree)


# ---- plain blocks are compiled by a short way; a comment sends the same block the long way ----

number = st.builds(
    lambda sign, whole, point, decimals: f"{sign}{whole}{point}{decimals}",
    st.sampled_from(["", "", "-"]),
    st.one_of(st.integers(0, 99999).map(str), st.just("")),
    st.sampled_from(["", "."]),
    st.one_of(st.integers(0, 999).map(str), st.just("")),
)
word = st.builds(str.__add__, st.sampled_from("XYZUVWABCIJKRFGNMST"), number)
block = st.lists(word, max_size=6).map(lambda words: " ".join(words))
code = st.sampled_from(["G0 ", "G1 ", "G90 ", "G91 ", "N10 ", "", ""])
variable = st.integers(0, 160).map(lambda n: f"#{n}") | st.sampled_from(["#9001", "#500", "#3000"])
value = variable | number
formula = st.one_of(
    value,
    st.builds(lambda a, sign, b: f"{a}{sign}{b}", value, st.sampled_from("+-*/"), value),
).flatmap(lambda inner: st.sampled_from([inner, f"[{inner}]", f"-{inner}", f"[[{inner}]]"]))
assignment = st.builds(
    lambda head, name, value: f"{head}{name}={value}",
    st.sampled_from(["", "N7", "N7 "]),
    variable,
    formula,
)
dwell = st.builds(
    lambda code, letter, value: f"{code} {letter}{value}",
    st.sampled_from(["G4", "G04", "N7 G4", "G4 G90", "G1 G4"]),
    st.sampled_from("PXUZFQ"),
    number,
)
text = st.lists(st.builds(str.__add__, code, block) | assignment | dwell, max_size=8)
# LinuxCNC reads a bare address otherwise if a comment follows it.
OTHERS = [name for name in NAMES if name != "linuxcnc"]


@given(control=st.sampled_from(OTHERS), blocks=text)
def test_a_comment_changes_nothing(control: str, blocks: list[str]) -> None:
    plain = "O1\n" + "".join(f"{b}\n" for b in blocks) + "M30\n"
    commented = "O1\n" + "".join(f"{b}()\n" if b.strip() else "\n" for b in blocks) + "M30\n"
    runs = [ran(t, control, max_blocks=100) for t in (plain, commented)]
    assert outcome(runs[0]) == outcome(runs[1])


# ---- plain lines and arcs move by a short way; limits of travel send them the long way ----

place = st.integers(-40_000, 40_000).map(lambda thousandths: f"{thousandths / 1000:.3f}")
line = st.builds(
    lambda words: " ".join(words),
    st.lists(st.builds(str.__add__, st.sampled_from("XYZ"), place), max_size=3),
)


@st.composite
def round_block(draw: st.DrawFn) -> str:
    """Draw an arc about a point, most of them with an end on the circle; some are full circles."""
    names = draw(st.sampled_from(["XYIJ", "XYIJ", "ZXKI", "YZJK"]))
    i, j, turn = (draw(st.integers(-20, 20)) for _ in range(3))
    end = (i - i * math.cos(turn) + j * math.sin(turn), j - i * math.sin(turn) - j * math.cos(turn))
    words = [f"{names[2]}{i}.", f"{names[3]}{j}."]
    if draw(st.booleans()):
        words += [f"{names[0]}{end[0]:.4f}", f"{names[1]}{end[1]:.4f}"]
    if draw(st.booleans()):
        words.append(f"{draw(st.sampled_from('XYZ'))}{draw(place)}")
    return " ".join({word[0]: word for word in words}.values())


moving = st.builds(
    lambda codes, words, feed: f"{codes} {words} {feed}",
    st.sampled_from(["G0", "G1", "G2", "G3", "G2", "G3", "", "G90", "G91", "G17", "G18", "G20"]),
    st.one_of(line, round_block()),
    st.sampled_from(["", "", "", "F200.", "F0"]),
)
# They read ISO programs.
MILLS = [n for n in NAMES if n != "gsk-928te" and not n.startswith("siemens")]
WIDE = dict.fromkeys("XYZ", (-1e8, 1e8))


@given(control=st.sampled_from(MILLS), blocks=st.lists(moving, max_size=8))
def test_limits_that_nothing_reaches_change_nothing(control: str, blocks: list[str]) -> None:
    text = "O1\nG91 G17 G1 F100.\n" + "\n".join(blocks) + "\nM30\n"
    setup = {"machine": "mill"}
    short, long = (ran(text, control, setup={**setup, **wide}) for wide in ({}, {"limits": WIDE}))
    assert outcome(short)[:2] == outcome(long)[:2]
    assert short.moves.columns == long.moves.columns
    for name in short.moves.columns:
        columns = [getattr(run.moves, name) for run in (short, long)]
        np.testing.assert_allclose(*columns, rtol=1e-9, atol=1e-9, err_msg=name)


# ---- a run in one go, step by step, and from a copy ----

calls = st.lists(
    st.sampled_from(
        [
            "G0 X1.",
            "G1 Y2. F100.",
            "M98 P2",
            "M98 P2 L3",
            "M98 P3",
            "#100=#100+1",
            "G65 P3 A2.",
            "M8",
            "M98 P9",
        ]
    ),
    max_size=6,
)


def library_of(main: list[str], second: list[str], control: str) -> cncsub.Library:
    programs = [
        ("O1", main, "M30"),
        ("O2", second, "M99"),
        ("O3", ["#101=#1", "G91 G0 Z1."], "M99"),
        ("O4", ["#102=#102+1", "Z1."], "X1. M99"),
    ]
    text = "".join(
        f"{name}\n" + "".join(f"{b}\n" for b in body) + f"{end}\n" for name, body, end in programs
    )
    ran(text, control, max_blocks=200)
    return cncsub.loads(text, control=control)


@given(main=calls, second=calls, control=st.sampled_from(MACRO_CONTROLS))
def test_steps_and_copies_do_what_a_run_does(
    main: list[str], second: list[str], control: str
) -> None:
    library = library_of(main, second, control)
    run = library.run(max_blocks=200)
    machine = library.machine(max_blocks=200)
    half = len(run.steps) // 2
    for _ in range(half):
        assert machine.step() is not None
    copy = machine.copy()
    rest = list(machine)
    assert len(rest) == len(run.steps) - half
    finished = copy.run()
    assert finished is not None
    assert outcome(finished) == outcome(run)


modal = st.lists(
    st.sampled_from(
        [
            "G66 P3 A2.",
            "G66 P4",
            "G66 P4 L2",
            "G66.1 P3",
            "G67",
            "G91 G1 X1. F100. M98 P2",
            "Z1. M98 P3 L2",
            "M98 P2 X2.",
            "X1. M98 P9",
            "G4 P1 M98 P2",
            "X3.",
            "#100=#100+1",
        ]
    ),
    max_size=7,
)


@given(main=modal, second=modal, control=st.sampled_from(MACRO_CONTROLS))
def test_steps_and_copies_do_what_a_run_does_under_modal_calls(
    main: list[str], second: list[str], control: str
) -> None:
    test_steps_and_copies_do_what_a_run_does.hypothesis.inner_test(main, second, control)


@given(
    modals=st.lists(st.sampled_from(["G66 P3 A2.", "G66 P4", "G66 P4 L2"]), max_size=2),
    move=st.sampled_from(["X1.", "G1 Z2. F10.", "X0", "G0 Y1. S8"]),
    call=st.sampled_from(["M98 P2", "M98 P2 L2", "M98 P9"]),
    second=st.lists(st.sampled_from(["X1.", "#100=#100+1", "X1. M98 P3", "M98 P4"]), max_size=3),
    control=st.sampled_from(["fanuc-16i", "fanuc-0i-d", "fanuc-30i", "mitsubishi-m700"]),
)
def test_a_move_and_a_call_in_one_block_are_the_move_and_then_the_call(
    modals: list[str], move: str, call: str, second: list[str], control: str
) -> None:
    runs = [
        library_of(["G91 G1 F100.", *modals, *blocks], second, control).run()
        for blocks in ([f"{move} {call}"], [move, call])
    ]

    def seen(run: cncsub.Run) -> tuple[object, ...]:
        alarm = run.alarm and (run.alarm.cause, [(f.program, f.kind) for f in run.alarm.frames])
        tree = [(c.parent, c.kind, c.program, c.level, c.repeats) for c in run.calls]
        steps = [(s.program, s.depth, s.repeat) for s in run.steps if s.program != "O1"]
        moves = [(m.kind, m.x, m.y, m.z) for m in run.moves]
        return (run.stop, alarm, tree, steps, moves, run.m_codes, dict(run.variables))

    assert seen(runs[0]) == seen(runs[1])


@given(repeats=st.integers(1, 20), control=st.sampled_from(MACRO_CONTROLS))
def test_a_repeated_call_is_that_many_calls(repeats: int, control: str) -> None:
    body = "O2\n#100=#100+1\nN20 G0 X#100\nM99\n"
    once = cncsub.loads("O1\n" + "M98 P2\n" * repeats + f"M30\n{body}", control=control).run()
    many = cncsub.loads(f"O1\nM98 P2 L{repeats}\nM30\n{body}", control=control).run()
    assert [m.x for m in once.moves] == [m.x for m in many.moves]
    assert once.variables[100] == many.variables[100] == repeats


# ---- expressions, compared with Python's arithmetic ----

Value = tuple[str, Callable[[], float]]


def constant(value: float) -> Value:
    text = f"{abs(value):.4f}".rstrip("0").rstrip(".")
    number = float(text)
    return (f"[-{text}]", lambda: -number) if value < 0 else (text, lambda: number)


constants = st.floats(-1000, 1000, allow_nan=False).map(lambda v: constant(round(v, 4)))


def binary(
    symbol: str, compute: Callable[[float, float], float]
) -> Callable[[Value, Value], Value]:
    def build(left: Value, right: Value) -> Value:
        return f"[{left[0]}{symbol}{right[0]}]", lambda: compute(left[1](), right[1]())

    return build


def unary(name: str, compute: Callable[[float], float]) -> Callable[[Value], Value]:
    return lambda inner: (f"{name}[{inner[0]}]", lambda: compute(inner[1]()))


def half_away(value: float) -> float:
    return math.copysign(math.floor(abs(value) + 0.5), value)


class EdgeError(Exception):
    """A step function that is so near its step that rounding decides."""


def stepped(compute: Callable[[float], float], step: float) -> Callable[[float], float]:
    def careful(value: float) -> float:
        if abs((value - step) - round(value - step)) < 1e-6:
            raise EdgeError
        return compute(value)

    return careful


UNARY = [
    unary("SIN", lambda a: math.sin(math.radians(math.fmod(a, 360)))),
    unary("COS", lambda a: math.cos(math.radians(math.fmod(a, 360)))),
    unary("ABS", abs),
    unary("FIX", stepped(math.trunc, 0)),
    unary("FUP", stepped(lambda a: math.copysign(math.ceil(abs(a)), a), 0)),
    unary("ROUND", stepped(half_away, 0.5)),
    unary("SQRT", math.sqrt),
    unary("LN", math.log),
]
BINARY = [
    binary("+", operator.add),
    binary("-", operator.sub),
    binary("*", operator.mul),
    binary("/", operator.truediv),
]
expressions = st.recursive(
    constants,
    lambda inner: st.one_of(
        st.builds(lambda f, a: f(a), st.sampled_from(UNARY), inner),
        st.builds(lambda f, a, b: f(a, b), st.sampled_from(BINARY), inner, inner),
    ),
    max_leaves=8,
)


@given(expression=expressions, control=st.sampled_from(MACRO_CONTROLS))
def test_expressions_have_pythons_value(expression: Value, control: str) -> None:
    written, compute = expression
    roomy = cncsub.controls[control].replace(max_brackets=100)
    run = ran(f"O1\n#100={written}\nM30\n", roomy)
    try:
        expected = float(compute())
    except EdgeError:
        return
    except (ValueError, ZeroDivisionError):
        # Python refuses: so does the control, unless the rounding of an angle made the value just
        # possible.
        assert run.alarm is not None or run.variables[100] is not None
        return
    if run.alarm is not None:
        assert run.alarm.cause in {
            "division-by-zero",
            "square-root-of-negative",
            "logarithm-of-non-positive",
        }
        return
    value = run.variables[100]
    assert value is not None
    assert value == pytest.approx(expected, rel=1e-7, abs=1e-7)


@given(a=st.integers(-50, 50), b=st.integers(-50, 50), c=st.integers(1, 50))
def test_precedence_without_brackets(a: int, b: int, c: int) -> None:
    run = ran(f"O1\n#1={a}\n#2={b}\n#100=#1+#2*{c}-#1/{c}\nM30\n", "fanuc-30i")
    assert run.variables[100] == pytest.approx(a + b * c - a / c, abs=1e-9)


@given(
    left=st.one_of(st.none(), st.integers(-3, 3)), right=st.one_of(st.none(), st.integers(-3, 3))
)
def test_comparisons_tell_vacant_from_zero_in_eq_and_ne_only(
    left: int | None, right: int | None
) -> None:
    signs = {
        "EQ": operator.eq,
        "NE": operator.ne,
        "GT": operator.gt,
        "LT": operator.lt,
        "GE": operator.ge,
        "LE": operator.le,
    }
    for word, compare in signs.items():
        program = f"O1\nIF[#1 {word} #2]THEN #100=1\nM30\n"
        run = ran(program, "fanuc-30i", variables={1: left, 2: right})
        tells = word in {"EQ", "NE"}
        expected = compare(left, right) if tells else compare(left or 0, right or 0)
        assert (run.variables.get(100) == 1) is expected, word


# ---- every cut takes time ----

cut_word = st.builds(
    str.__add__,
    st.sampled_from("XYZUVWABCIJKRQPHFS"),
    st.sampled_from(["0", "1.", "-2.", "3.5", "10", "0.001", "-0.05", "2000"]),
)
CUT_CODES = """
    G0 G1 G2 G3 G32 G33 G34 G17 G18 G19 G20 G21 G22 G41D1 G40 G43H1 G51P2 G53 G31 G54 G68R30. G70
    G71 G73 G74 G75 G76 G77 G78 G79 G80 G81 G82 G83 G84 G85 G87 G88 G90 G91 G92 G93 G94 G95 G96 G97
    G98 G99 G16 G50S1000 M3 M4 M5 T0101
"""
cut_code = st.sampled_from(CUT_CODES.split())
cut_block = st.builds(
    lambda codes, words: " ".join([*codes, *words]),
    st.lists(cut_code, max_size=2),
    st.lists(cut_word, max_size=4),
)


@given(
    control=st.sampled_from(NAMES),
    machine=st.sampled_from(["mill", "lathe-a", "lathe-b"]),
    blocks=st.lists(cut_block, min_size=1, max_size=8),
)
def test_no_cut_takes_no_time(control: str, machine: str, blocks: list[str]) -> None:
    text = "O1\n" + "\n".join(blocks) + "\nM30\n"
    setup = {"machine": machine, "radius_offsets": {1: 0.5}, "length_offsets": {1: 10}}
    run = ran(text, control, setup=setup, max_blocks=100)
    for move in run.moves:
        if move.kind not in ("rapid", "dwell") and move.length > 0:
            assert move.time > 0, (move, blocks)


@given(
    control=st.sampled_from(
        [
            name
            for name in MILLS
            if not name.startswith(("gsk-988", "gsk-980tdi", "grblhal", "okuma"))
        ]
    ),  # mills that have rotary axes, G20 and G21
    words=st.lists(
        st.builds(str.__add__, st.sampled_from("ABC"), st.sampled_from(["90.", "-3.", "0.5"])),
        min_size=1,
        max_size=3,
        unique_by=lambda word: word[0],
    ),
    feed=st.integers(1, 5000),
)
def test_a_rotary_axis_does_not_know_inches(control: str, words: list[str], feed: int) -> None:
    def seconds(unit: str) -> list[float]:
        text = f"O1\n{unit}\nG91 G94 G1 {' '.join(words)} F{feed}.\nM30\n"
        run = ran(text, control, setup={"machine": "mill"})
        assert run.stop is cncsub.Stop.END
        return [value for move in run.moves for value in (move.time, move.feed)]

    inch, metric = seconds("G20"), seconds("G21")
    np.testing.assert_allclose(inch, metric)
    assert metric[1] == feed


# ---- values of the moves: finite, in order, and one sum of times ----

measured = st.one_of(
    place, place, st.sampled_from(["0", "99999.999", "-99999.999", "99999999", "-0."])
)
said = st.builds(
    lambda code, words: f"{code} {words}",
    st.sampled_from(
        [
            "G0",
            "G1",
            "G1",
            "G2 R30.",
            "G3 R30.",
            "G96 S100",
            "G97 S500",
            "G95 F0.2",
            "G94 F200.",
            "G98 F150.",
            "G99 F0.1",
            "T0101",
            "T0202",
            "T0",
            "G41 D1",
            "G42 D1",
            "G40",
            "G43 H1",
            "G49",
            "G92",
            "G52",
            "G54",
            "G55",
            "G91",
            "G90",
            "G4 P500",
            "G32 F2.",
            "G20",
            "G21",
            "G51 P2000",
            "G68 R30.",
            "G10 L2 P1",
            "G28",
            "G16",
            "G15",
            "M98 P2 L3",
        ]
    ),
    st.lists(st.builds(str.__add__, st.sampled_from("XYZXYZB"), measured), max_size=3).map(
        " ".join
    ),
)
SHOP = {
    "length_offsets": {1: 12.5},
    "radius_offsets": {1: 2.5},
    "tools": {1: {"X": 4.0, "Z": -3.0, "R": 0.8, "tip": 3}, 2: {"X": -2.5, "R": 0.4, "tip": 2}},
    "work_offsets": {"G55": {"X": 30.0, "Z": 7.0}, "EXT": {"Y": 2.0}},
}


@given(
    control=st.sampled_from(NAMES),
    machine=st.sampled_from(["mill", "lathe-a", "lathe-b"]),
    blocks=st.lists(said, max_size=10),
)
def test_moves_are_finite_in_order_and_add_up(
    control: str, machine: str, blocks: list[str]
) -> None:
    head = "%" if cncsub.controls[control].name in ("hnc-21m", "gsk-928te") else "O"
    text = f"{head}1\nG1 F100. S300\n" + "\n".join(blocks) + f"\nM30\n{head}2\nG91 X3.\nM99\n"
    run = ran(text, control, setup={"machine": machine, **SHOP})
    moves = run.moves
    assert np.all(np.diff(moves.step) >= 0)
    for name in moves.columns:
        values = np.asarray(getattr(moves, name), dtype=float)
        assert np.all(np.isfinite(values) | (name in ("cx", "cy", "cz"))), name
        assert not np.any(np.isinf(values)), name
    assert math.isclose(moves.time.sum(), moves.total_time, rel_tol=1e-9, abs_tol=1e-9)
    assert all(math.isfinite(value) for value in run.position.values())
    share = 1 if machine == "mill" else 0.5
    chords = np.sqrt(
        (np.diff(moves.mx) * share) ** 2 + np.diff(moves.my) ** 2 + np.diff(moves.mz) ** 2
    )
    assert np.all(moves.length[1:] >= chords * (1 - 1e-9) - 1e-9)
    for axis, (low, high) in moves.bounds.items():
        column = getattr(moves, axis.lower())
        assert low <= column.min()
        assert high >= column.max()
