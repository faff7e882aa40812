"""A block that alarms leaves everything that can be read as it was before the block."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import cncsub

LATHES = [
    "gsk-988ta",
    "gsk-988t",
    "gsk-980tdi",
    "gsk-928te",
    "fanuc-16i",
    "fanuc-30i",
    "mitsubishi-m700",
]
CASES = [(name, "mill") for name in sorted(cncsub.controls) if name not in LATHES[:4]]
CASES += [(name, "lathe-a") for name in LATHES]

NUMBERS = [
    *range(1, 34), *range(100, 106), 149, 199, *range(500, 504), *range(2001, 2005), *range(2201, 2204),
    *range(2401, 2403), *range(2501, 2504), *range(2601, 2604), 3001, 3002, 3003, 3004, 3011,
    *range(4001, 4023), *range(4101, 4121), *range(4301, 4321), *range(5001, 5007), *range(5021, 5027),
    *range(5041, 5047), *range(5061, 5067), *range(5081, 5087), *range(5201, 5207), *range(5221, 5227),
    *range(5241, 5244), *range(7001, 7007), *range(10001, 10003), *range(11001, 11003),
    *range(12001, 12003), *range(13001, 13003), *range(14001, 14004), 1500, 1501, 8512, 8513,
]  # fmt: skip


def seen(machine: cncsub.Machine) -> dict[str, object]:
    """Return all that can be read of a machine, except what says that it stopped."""
    return {
        "variables": {number: machine.variables.get(number) for number in NUMBERS},
        "position": dict(machine.position),
        "modal": dict(machine.modal),
        "messages": list(machine.messages),
        "m_codes": list(machine.m_codes),
        "t_codes": list(machine.t_codes),
        "moves": [(m.step, m.kind, m.x, m.y, m.z, m.mx, m.mz, m.time) for m in machine.moves],
        "steps": len(machine.steps),
        "stack": machine.stack,
    }


def to_the_alarm(
    library: cncsub.Library, **options: object
) -> tuple[dict[str, object], ...] | None:
    """Return what can be read before and after the block that alarms, and after a reset and a
    second run.

    The second run shows the offsets and inputs that no variable has. Returns None without an alarm.
    """
    machine = library.machine(max_blocks=60, **options)  # type: ignore[arg-type]
    before = machine.copy()
    while machine.step() is not None:
        if machine.alarm is not None:  # the alarm came in a step whose words came first
            return None
        before = machine.copy()
    if machine.alarm is None:
        return None
    shown = [seen(before), seen(machine)]
    for each in (before, machine):
        each.reset()
        each.run()
        shown.append(seen(each))
    return tuple(shown)


OFFSETS = st.sampled_from(
    [
        "G10 L2 P1 X5.", "G10 L2 P0 Z3.", "G10 L20 P1 X7.", "G10 P1 R4.", "G10 L10 P1 R4.", "G10 L11 P2 R1.",
        "G10 L12 P1 R3.", "G10 L13 P1 R.1", "G10 P1 X3. Z4. R.4 Q3", "G10 P10001 X1.", "G10 P0 X2. Z2.",
        "G91 G10 L2 P1 X1.", "G10 L2 P1 U2.", "G22 X50. Z50. I-50. K-50.", "G10 P500 R1.", "G10 L2 P9 X1.",
    ]
)  # fmt: skip
WAITING = st.sampled_from(
    [
        "G1 X10. F100. ,C1.", "G1 X10. ,R2. F100.", "G1 X10. F100. C1.", "G1 X10. A30. F100.", "G1 X10. ,A30.",
        "G41 D1 G1 X5. F100.", "G42 D1 X5. Y3.", "G41 X5. Z-1. T0101", "G42 G1 X9. Z-3. F1.", "G1 Z-9. R1.",
    ]
)  # fmt: skip
PLAIN = st.sampled_from(
    [
        "G0 X1.", "G1 Y2. F100.", "G1 X9. Z-2. F.2", "G91 X1.", "G90", "G2 X5. I2.", "G3 X9. Z-9. K1.", "G2 X1. R.1",
        "X5. Y5.", "Y7.", "Z-3.", "G40", "G40 X0", "G28 X0", "G30 Z0", "G31 X5. F10.", "G53 X0", "G54", "G54.1 P2",
        "G92 X0", "G50 X3.", "G52 X1.", "G68 X1. Y1. R30.", "G51 X0 Y0 P2.", "G51.1 X1.", "G15", "G16", "G18", "G19",
        "G20", "G21", "G43 H1", "G43 H2 Z1.", "G49", "G81 Z-1. R1. F9.", "G83 Z-1. R1. F9.", "X3.", "G80", "G4 P10",
        "T0101", "T1 M6", "M3 S100", "M0", "M1", "M8 T2", "G96 S100", "G99 F.1", "G71 U1. R1.", "G71 P10 Q20 U1.",
        "G76 P10000 Q100 R.1", "G90 X5. Z-5. F.2", "G33 Z-5. F1.", "G45 D1 X5.", "G60 X3.", "G65 P9", "X[#1]",
        "X#500 M8", "G10.6", "M30", "G1 X#501", "G5.1 Q1", "G7.1 C5.", "X1. ,C1. Y2.", "G1 X1. F0", "G1 X1. F-1.",
    ]
)  # fmt: skip
VARIABLES = st.sampled_from(
    [
        "#1=5", "#100=#100+1", "#500=RND[3]", "#501=RND[2]/#103", "#501=#3001/#103", "#3001=7", "#3002=1",
        "#5221=5", "#5201=2", "#2001=4.", "#2201=3", "#10001=4", "#13001=1", "#7001=2", "#3003=1", "#3004=7",
        "#5221=#0", "#3006=1(STOP)", "#3000=1(STOP)", "#9999=1", "#100=1/#103", "#[5220+#102]=#3001/#102",
        "DPRNT[X#100[33]]", "SETVN 101[DEPTH]", "IF[#3001GT1/#102]GOTO7", "WHILE[#102LT1/#102]DO1", "END1",
        "X[#3001/#102]", "G31 X[#3001] Y[1/#102] F1.", "X[RND[5]] Z[SQRT[-1]]", "M[#3001/#102]", "T[1/#102]",
    ]
)  # fmt: skip
CALLS = st.sampled_from(
    [
        "M98 P2", "M98 P2 L2", "M98 P9", "G65 P2 A#3001", "G65 P9", "G66 P2", "G66 P9", "G66.1 P2", "G67", "M99",
        "M99 P5", "G65 P2 B[1/#102]", "M98 P2 X1.", "X1. M99", "M98 P[RND[5]/#102]", "G66 P2 A[1/#102]", "M97 P5",
    ]
)  # fmt: skip
BLOCK = st.one_of(OFFSETS, WAITING, PLAIN, VARIABLES, CALLS)
HEAD = "O1\nG90 G54 F100. S500\nT0101 G0 X20. Z2.\nG43 H1 Z3.\n#599=RND[1]\n"
INPUTS = {"skips": [0.5, 0.25, 0.1], "clock": 12.5}


@settings(max_examples=400)
@given(
    place=st.sampled_from(CASES),
    start=st.lists(BLOCK, max_size=6),
    last=BLOCK,
    sub=st.lists(BLOCK, max_size=2),
)
def test_a_block_that_alarms_changes_nothing(
    place: tuple[str, str], start: list[str], last: str, sub: list[str]
) -> None:
    control, machine = place
    text = HEAD + "\n".join([*start, last]) + "\nM30\nO2\n" + "\n".join([*sub, "M99"]) + "\n"
    library = cncsub.loads(text, control=control)
    setup = cncsub.Setup(machine=machine, length_offsets={1: 5.0}, radius_offsets={1: 0.5})
    shown = to_the_alarm(library, setup=setup)
    if shown is not None:
        before, after, again, second = shown
        assert after == before
        assert second == again


# Blocks of other languages that assign, print messages and do something else too.
TOGETHER = {
    "linuxcnc": [
        "#31=12 A-12.392 G84", "#1=2 D-0.001", "#501=0 G73", "#5221=3 #5222=4 G1 X1 F0 G93", "#<_a>=3 G2 X1",
        "#<_a>=3 (MSG, said) G2 X1", "#1=7 #2=8 #5420=1", "#[30+1]=5 G2 X9", "#[5000+221]=5 G2 X9",
        "#1=5 #5221=9 M199 G2 X5", "#31=[1/0] #1=3", "#4=6 (ABORT, here)", "G10 L2 P1 X5 #5=6 G2 X1",
    ],
    "siemens-one": ["R1=R1+1 G5", "R2=7 R3=8 G2 X5", "R4=R1 N5 G1 X=R1/R9", "R1=5 M6 G3 Y9", "MSG(\"A\") G2 X5"],
}  # fmt: skip


@pytest.mark.parametrize(
    ("control", "block"), [(control, block) for control in TOGETHER for block in TOGETHER[control]]
)
def test_what_a_block_assigns_and_says_is_taken_back_where_it_alarms(
    control: str, block: str
) -> None:
    head = {"linuxcnc": "#1=9\n#<_a>=1\n(MSG, before)\nG0 X3\n", "siemens-one": "R1=9\nG0 X3\n"}
    library = cncsub.loads(f"{head[control]}{block}\nM30\n", control=control)
    shown = to_the_alarm(library)
    assert shown is not None, "the block alarms"
    before, after, again, second = shown
    assert after == before
    assert second == again


BOTH = [
    ("fanuc-0i-f", "mill"),
    ("fanuc-16i", "lathe-a"),
    ("mitsubishi-m700", "mill"),
    ("gsk-988ta", "lathe-a"),
]


@pytest.mark.parametrize("place", BOTH, ids=str)
@given(waiting=WAITING, between=st.lists(st.one_of(OFFSETS, VARIABLES), max_size=2), last=OFFSETS)
def test_an_offset_set_behind_a_move_that_waits_in_vain_is_not_set(
    place: tuple[str, str], waiting: str, between: list[str], last: str
) -> None:
    test_a_block_that_alarms_changes_nothing.hypothesis.inner_test(
        place, [waiting, *between], last, []
    )
