"""The programs of another interpreter of SINUMERIK's language, in our own words.

nc-gcode-interpreter (CEAD) has 31 examples, each with a table of the positions block by block. Each
has a program here that uses the same forms with other names and values; its table was computed by
hand by the rules that the other one's documents cite. What the other one passes over and a control
refuses (a missing feed, a missing end) is given here, and refused in `REFUSED`.
"""

from __future__ import annotations

from dataclasses import dataclass

import pytest

import cncsub

CONTROL = "siemens-one"
OFFSETS = ({}, {"X": 11.125, "Y": -40.25, "Z": 7.5})


@dataclass(frozen=True)
class Example:
    """A program, and the position after each block that moves: N and X Y Z."""

    name: str
    program: str
    table: str
    not_computed: str = ""  # the word at which cncsub stops, because it does not compute it yet
    alarm: str = ""  # the cause of the alarm at its end
    zero_offsets: bool = False  # it reads the machine's coordinates


EXAMPLES = [
    Example(
        "actual_position",
        """
        DEF REAL STEP_UP = 3, TOP = 8
        N10 G0 X0 Y0 Z0
        REPEAT
        N20 X=IC(5)
        N30 Z=IC(STEP_UP)
        UNTIL $AA_IW[Z] > (TOP-0.5)
        TRANS Z50
        R1=$AA_IW[Z]
        R2=$AA_IM[Z]
        N40 Y=R2-R1
        M30
        """,
        """
        10 0 0 0
        20 5 0 0
        30 5 0 3
        20 10 0 3
        30 10 0 6
        20 15 0 6
        30 15 0 9
        40 15 50 9
        """,
        zero_offsets=True,
    ),
    Example(
        "arc",
        """
        N10 G1 X0 Y0 Z0 F600
        N20 G2 X80 Y0 I40 J0
        N30 G1 X80 Y30
        N40 G3 X0 Y30 I-40 J0
        N50 G2 X0 Y10 Z6 I0 J-10
        N60 G1 X20 Y20
        N70 G2 X40 Y20 CR=15
        M30
        """,
        """
        10 0 0 0
        20 80 0 0
        30 80 30 0
        40 0 30 0
        50 0 10 6
        60 20 20 6
        70 40 20 6
        """,
    ),
    Example(
        "arrays",
        """
        DEF INT GRID[2,3]=REP(7)
        DEF REAL FIRST[2,2]=SET(4,,-6)
        DEF INT II, JJ
        N10 G0 X=GRID[1,2] Y=FIRST[1,0] Z=FIRST[0,1]
        FOR II=0 TO 1
          FOR JJ=0 TO 2
            GRID[II,JJ]=II*10+JJ
            N20 X=GRID[II,JJ]
          ENDFOR
        ENDFOR
        M30
        """,
        """
        10 7 -6 0
        20 0 -6 0
        20 1 -6 0
        20 2 -6 0
        20 10 -6 0
        20 11 -6 0
        20 12 -6 0
        """,
    ),
    Example(
        "axis_index_assignment",
        """
        N10 G0 X5
        ACC[X]=50 ; half of the acceleration
        N20 X10
        M30
        """,
        """
        10 5 0 0
        20 10 0 0
        """,
    ),
    Example(
        "basic_math",
        """
        N10 G0 X = 1+1-1+-1
        N20 X1 Y=-2/3
        N30 X=9 DIV 4
        N40 X=9 / 4
        N50 X=5 MOD 8
        N60 X=9 MOD 4.2
        N70 X=9 DIV 4.2
        N80 X=9 DIV 0.4
        M30
        """,
        """
        10 0 0 0
        20 1 -0.667 0
        30 2 -0.667 0
        40 2.25 -0.667 0
        50 5 -0.667 0
        60 0.6 -0.667 0
        70 2 -0.667 0
        80 22 -0.667 0
        """,
    ),
    Example(
        "case",
        """
        DEF INT ONE = 5, OTHER = 6, THIRD = 2
        N10 CASE(ONE+OTHER-THIRD) OF 7 GOTOF WAY_1 9 GOTOF WAY_2 DEFAULT GOTOF WAY_3
        N20 WAY_1: G0 X1
        GOTOF DONE
        N30 WAY_2: G0 X2
        GOTOF DONE
        N40 WAY_3: G0 X3
        DONE: M30
        """,
        "30 2 0 0",
    ),
    Example(
        "case_insensitive_variables",
        """
        DEF REAL hEIGHT
        HEIGHT = 1.5
        N10 G0 X0 Y0 Z0
        N20 Z=IC(height)
        N30 Z=IC(Height)
        R1 = HEIGHT * 6
        N40 X = r1
        M30
        """,
        """
        10 0 0 0
        20 0 0 1.5
        30 0 0 3
        40 9 0 3
        """,
    ),
    Example("custom_vars", "DEF INT LEFT=21, RIGHT=8\nN10 G0 X=LEFT Y=RIGHT\nM30", "10 21 8 0"),
    Example(
        "def_string",
        """
        DEF STRING[20] PART = "bracket"
        DEF STRING[60] LOG
        DEF STRING[8] MARK = "B-2", NOTE = ""
        LOG = "PART_LOG.MPF"
        N10 G1 X0 Y0 Z0 F500
        N20 X4 Y2
        MARK = "C-1"
        N30 X8 Y4
        M30
        """,
        """
        10 0 0 0
        20 4 2 0
        30 8 4 0
        """,
    ),
    Example(
        "defaults",
        """
        DEF INT RIGHT,LEFT=14
        DEF REAL LEAD=10, SPEED=0.5, FACTOR=1
        LEFT = LEFT+3
        RIGHT = 8
        N10 G0 X=LEFT Y=RIGHT Z=LEAD*SPEED
        M30
        """,
        "10 17 8 5",
    ),
    Example(
        "edge_cases",
        """
        DEF REAL DEEP = 1.5
        N10 G1 X2.5 Y-3. Z0.002 F1200 S500 D1

        N20
        N30 X4 ; a comment
        N40 G1 X0 Y0 F900
        N50 G2 X60 Y0 I30 J0
        N60 G3 X0 Y40 CR=40
        N70 G1 X0 Y0
        N80 X1 A=0.0 B=-2.5 C=30.
        R1=8
        N90 X=5 DIV R1
        N100 Y=5 MOD R1
        R2=1+3*3
        N110 Z=SIN(30)
        N120 X=R2
        N130 Z=DEEP
        N140 x30
        N150 X31
        R3=20 R4=2
        N160 BACK: X=R3
        R3=R3+5 R4=R4-1
        IF R4>0 GOTOB BACK
        GOTOC NOWHERE
        GOTOF N200
        N180 X99
        N200 X5
        M30
        """,
        """
        10 2.5 -3 0.002
        30 4 -3 0.002
        40 0 0 0.002
        50 60 0 0.002
        60 0 40 0.002
        70 0 0 0.002
        80 1 0 0.002
        90 0 0 0.002
        100 0 5 0.002
        110 0 5 0.5
        120 10 5 0.5
        130 10 5 1.5
        140 30 5 1.5
        150 31 5 1.5
        160 20 5 1.5
        160 25 5 1.5
        200 5 5 1.5
        """,
    ),
    Example(
        "for_loop",
        """
        DEF INT COUNT, LAST=3
        FOR COUNT=0 TO LAST
        N10 G0 X=90*COUNT/LAST
        ENDFOR
        M30
        """,
        """
        10 0 0 0
        10 30 0 0
        10 60 0 0
        10 90 0 0
        """,
    ),
    Example(
        "function_calls",
        "N10 G0 X1\nSETAL(65300)\nN20 G0 X2\nM30",
        "10 1 0 0",
        alarm="user-alarm",  # the other interpreter goes on after it
    ),
    Example(
        "goto",
        """
        R1=20 R2=5 R3=2
        GOTOF MIDDLE ; over the next block
        N10 G0 X999
        N20 BACK: G0 X=R1
        R1=R1+R2 R3=R3-1
        IF R3>0 GOTOB BACK
        GOTOF 50
        N40 X999
        N50 GOTOC NOWHERE
        GOTO FINISH
        N60 X999
        FINISH: M30
        N70 MIDDLE: G0 Y2
        GOTOB BACK
        """,
        """
        70 0 2 0
        20 20 2 0
        20 25 2 0
        """,
    ),
    Example(
        "if_statement",
        """
        DEF INT FLAG=2
        IF TRUE
            N10 G0 X4
        ELSE
            IF FLAG
                N20 X5
            ELSE
                N30 X6
                N40 Y7
            ENDIF
        ENDIF
        IF FLAG
            N50 X8
        ENDIF
        M30
        """,
        """
        10 4 0 0
        50 8 0 0
        """,
    ),
    Example(
        "increment",
        """
        DEF INT COUNT=6
        N10 G0 X2
        N20 X=IC(3)
        N30 Y=IC(0.5*COUNT) X=IC(1/3)
        M30
        """,
        """
        10 2 0 0
        20 5 0 0
        30 5.333 3 0
        """,
    ),
    Example(
        "logic_operators",
        """
        DEF INT LEFT = 1, RIGHT = 0
        DEF REAL SPEED = 120
        N10 G0 X0 Y0 Z0
        IF (LEFT == 1) AND (RIGHT == 1)
            N20 X1 Y1
        ENDIF
        IF ((LEFT == 1) OR (RIGHT == 1))
            N30 X6
        ENDIF
        IF NOT RIGHT
            N40 X12
        ENDIF
        IF ((LEFT == 1) XOR (RIGHT == 1))
            N50 Z4
        ENDIF
        R11 = SPEED >= 100
        N60 Y = 25*R11
        R12 = 12 B_AND 10
        N70 X = 20 + R12
        M30
        """,
        """
        10 0 0 0
        30 6 0 0
        40 12 0 0
        50 12 0 4
        60 12 25 4
        70 28 25 4
        """,
    ),
    Example(
        "loop",
        """
        DEF REAL LEFT, RIGHT, LOW, HIGH, NOW_X, NOW_Y, APART
        G90 ; absolute
        G17
        LEFT = 10
        RIGHT = 50
        LOW = 5
        HIGH = 7
        APART = 1
        M0
        N10 G1 X=LEFT Y=LOW F=800
        NOW_Y = LOW
        NOW_X = LEFT
        IF (LOW <= HIGH)
            WHILE (NOW_Y <= HIGH)
                IF (NOW_X == RIGHT)
                    N20 G1 X=LEFT
                    NOW_X = LEFT
                ELSE
                    N30 G1 X=RIGHT
                    NOW_X = RIGHT
                ENDIF
                NOW_Y = NOW_Y + APART
                N40 G1 Y = NOW_Y
            ENDWHILE
        ELSE
            M30
        ENDIF
        M2
        """,
        """
        10 10 5 0
        30 50 5 0
        40 50 6 0
        20 10 6 0
        40 10 7 0
        30 50 7 0
        40 50 8 0
        """,
    ),
    Example(
        "multiple_m_codes",
        "G1 F500\nN10 X1 M11 ; one\nN20 X2 M12\nN30 X3 M13 M7 M8 M9 M5 ; five\nM30",
        """
        10 1 0 0
        20 2 0 0
        30 3 0 0
        """,
    ),
    Example(
        "precedence",
        """
        G0
        N10 X=3+4*5
        N20 X=12-2*4
        N30 X=12-8/2
        N40 X=2+9 DIV 4
        N50 X=1+9 MOD 4
        N60 X=(3+4)*5
        N70 X=-3+5
        N80 X=3*-4
        N90 X=90-5*3+4
        M30
        """,
        """
        10 23 0 0
        20 4 0 0
        30 8 0 0
        40 4 0 0
        50 2 0 0
        60 35 0 0
        70 2 0 0
        80 -12 0 0
        90 79 0 0
        """,
    ),
    Example("r_param", "N10 G0 X=R0\nR0 = 12\nN20 X=R0\nM30", "10 0 0 0\n20 12 0 0"),
    Example(
        "repeat",
        """
        DEF INT COUNT, LAST=2
        REPEAT
        N10 G0 X=COUNT
        COUNT=COUNT+1
        UNTIL COUNT>LAST
        M30
        """,
        """
        10 0 0 0
        10 1 0 0
        10 2 0 0
        """,
    ),
    Example(
        "simple",
        "G1 F400 ; a comment\nN10 G0 X3 Z10\n; nothing\n\nN20 G1 X=5 Y4.25\nM30",
        "10 3 0 10\n20 5 4.25 10",
    ),
    Example(
        "spline",
        "N10 G1 X0 Y0 F700\nBSPLINE SD=2\nN20 X5 Y10 PW=2\nN30 X15 Y20\nN40 G1 X40 Y0\nM30",
        "10 0 0 0\n20 5 10 0\n30 15 20 0\n40 40 0 0",
        not_computed="BSPLINE",
    ),
    Example("tool", 'T="END_MILL_6" M6\nN10 G0 X1\nM30', "10 1 0 0"),
    Example(
        "trans",
        """
        N10 G0 X1 Y2
        TRANS X80 Y3
        N20 X1 Y2
        ATRANS X20 Y4
        N30 X1 Y2
        M30
        """,
        """
        10 1 2 0
        20 81 5 0
        30 101 9 0
        """,
    ),
    Example(
        "trans2",
        "N10 G0 X2\nTRANS X50\nN20 X=IC(1)\nN30 X=IC(2)\nN40 X=IC(3)\nM30",
        "10 2 0 0\n20 53 0 0\n30 55 0 0\n40 58 0 0",
    ),
    Example(
        "trans_ic",
        """
        DEF REAL AWAY
        AWAY = 60
        N10 G0 X=0 Y=0
        TRANS X=AWAY Y=0
        N20 X=12 Y=0
        N30 X=IC(30) Y=0
        M30
        """,
        """
        10 0 0 0
        20 72 0 0
        30 102 0 0
        """,
    ),
    Example(
        "trans_reset",
        """
        N10 G0 X2 Y1
        TRANS X60 Y30
        N20 X3 Y4
        TRANS X20
        N30 X4 Y5
        TRANS
        N40 X5 Y6
        ATRANS X40
        N50 X6 Y7
        ROT
        N60 X7 Y8
        M30
        """,
        """
        10 2 1 0
        20 63 34 0
        30 24 5 0
        40 5 6 0
        50 46 7 0
        60 7 8 0
        """,
    ),
    Example(
        "trig",
        """
        G0
        N10 X=COS(60)
        N20 X=SIN(90)
        N30 X=TAN(135)
        N40 X=ASIN(1)
        N50 X=ACOS(0.5)
        N60 X=ATAN2(20.2, 40.6)
        N70 X=SQRT(POT(6)+POT(8))
        M30
        """,
        """
        10 0.5 0 0
        20 1 0 0
        30 -1 0 0
        40 90 0 0
        50 60 0 0
        60 26.452 0 0
        70 10 0 0
        """,
    ),
    Example(
        "variables",
        """
        DEF INT PART=1, WHOLE=4, BOTH=1
        N10 G0 X=PART/WHOLE
        PART=3
        N20 X=PART/WHOLE
        BOTH=PART+WHOLE
        N30 X=BOTH
        M30
        """,
        """
        10 0.25 0 0
        20 0.75 0 0
        30 7 0 0
        """,
    ),
]

# What the other interpreter passes over, and the cause of the alarm here.
REFUSED = {
    "a feed that nobody gave": ("X1\nM30", "no-feed"),
    "a program without its end": ("G0 X1", "end-of-record"),
    "an arc without a centre": ("G2 X3 Z10 F100\nM30", "no-radius"),
    "an axis that is in its block twice": ("G0 X1 X=3\nM30", "axis-given-twice"),
    "a DEF of an R parameter": ("DEF REAL R0=0\nM30", "illegal-variable-name"),
}


def run_of(program: str, offset: dict[str, float]) -> cncsub.Run:
    # The offset is approached after the definitions, which come first in a program.
    lines = program.split("\n")
    first = next(
        n for n, line in enumerate(lines) if not line.strip().startswith("DEF") and line.strip()
    )
    text = "\n".join([*lines[:first], "G54 G0 X0 Y0 Z0", *lines[first:]])
    setup = cncsub.Setup(increment=1e-9, work_offsets={"G54": offset})
    return cncsub.loads(text, control=CONTROL, name="MAIN.MPF").run(max_blocks=1000, setup=setup)


def positions(run: cncsub.Run) -> list[tuple[int, float, float, float]]:
    """Return the position after each block with a number that moves."""
    rows: dict[int, tuple[int, float, float, float]] = {}
    for move in run.moves:
        if move.n is not None:
            rows[move.step] = (move.n, move.mx, move.my, move.mz)
    return list(rows.values())


def table_of(text: str, offset: dict[str, float]) -> list[tuple[int, float, float, float]]:
    away = [offset.get(axis, 0.0) for axis in "XYZ"]
    rows = [line.split() for line in text.strip().splitlines()]
    return [
        (int(n), *(float(at) + by for at, by in zip(place, away, strict=True)))  # type: ignore[misc]
        for n, *place in rows
    ]


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.name)
def test_examples_make_the_positions_of_their_tables(example: Example) -> None:
    program = "\n".join(line.strip() for line in example.program.strip().splitlines())
    for offset in OFFSETS[: 1 if example.zero_offsets else 2]:
        run = run_of(program, offset)
        if example.not_computed:
            assert run.alarm is not None, f"{example.name} runs: take out `not_computed`"
            assert run.alarm.cause == "code-not-computed"
            assert run.alarm.word == example.not_computed
            continue
        assert (run.alarm.cause if run.alarm else "") == example.alarm, run.alarm
        made, wanted = positions(run), table_of(example.table, offset)
        assert [n for n, *_ in made] == [n for n, *_ in wanted]
        for one, other in zip(made, wanted, strict=True):
            assert one[1:] == pytest.approx(other[1:], abs=6e-4)


def test_there_is_an_example_of_each_of_the_other_ones() -> None:
    assert len({example.name for example in EXAMPLES}) == 31


@pytest.mark.parametrize("what", REFUSED)
def test_a_control_refuses_what_the_other_interpreter_passes_over(what: str) -> None:
    program, cause = REFUSED[what]
    run = cncsub.loads(program, control=CONTROL).run()
    assert run.alarm is not None
    assert run.alarm.cause == cause
