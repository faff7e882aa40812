"""Turning cycles."""

from conformance import case

MM = {"whole_numbers": "millimetres"}  # whole numbers are millimetres, on every control
LATHE_A = {"machine": "lathe-a"}
LATHE_B = {"machine": "lathe-b"}

case(
    "G90 of a lathe goes in, cuts, comes out and goes back (M421)",
    pins="max_feed",
    control=["gsk-980tdi", "gsk-988ta", "fanuc-0i-d"],
    source="TDi 22.1; TA 6",
    evidence="maker's manual",
    program="""
        O0002
        G90 X120 Z-110 F200
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 130, "Z": 3}},
    moves="""
        R X120
        F X120 Z-110
        F X130
        R Z3
    """,
)

case(
    "an X alone repeats the turning cycle with the old Z (M422)",
    control=["gsk-980tdi", "gsk-988ta", "fanuc-0i-d"],
    source="TDi 22.1, O0002; TA 6 note 2",
    evidence="maker's manual",
    program="""
        O0002
        G90 X120 Z-110 F200
        X110 Z-30
        X100
        G0 X140 Z10
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 130, "Z": 3}},
    moves="""
        R X120
        F Z-110
        F X130
        R Z3
        R X110
        F Z-30
        F X130
        R Z3
        R X100
        F Z-30
        F X130
        R Z3
        R X140 Z10
    """,
)

case(
    "R of G90 shifts the start of the cut by twice its value (M423)",
    control=["gsk-980tdi", "gsk-988ta", "fanuc-0i-d"],
    source="TDi 22.1, O0002",
    evidence="maker's manual",
    program="""
        O1
        G90 X120 Z-44 R-7.5 F150
        Z-56 R-15
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 120, "Z": -30}},
    moves="""
        R X105
        F X120 Z-44
        F X120
        R Z-30
        R X90
        F X120 Z-56
        F X120
        R Z-30
    """,
)

case(
    "G94 of a lathe goes along Z, faces, comes out and goes back (M424)",
    control=["gsk-980tdi", "gsk-988ta", "fanuc-0i-d"],
    source="TDi 22.2, O0003",
    evidence="maker's manual",
    program="""
        O0003
        G94 X0 Z0 F200
        X120 Z-110 F300
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 130, "Z": 5}},
    moves="""
        R Z0
        F X0 Z0
        F Z5
        R X130
        R Z-110
        F X120 Z-110
        F Z5
        R X130
    """,
)

case(
    "R of G94 shifts the start of the cut along Z (M425)",
    control=["gsk-980tdi", "gsk-988ta", "fanuc-0i-d"],
    source="TDi 22.2, O0003",
    evidence="maker's manual",
    program="""
        O1
        G94 X108 Z-30 R-10 F300
        X96 R-20
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 120, "Z": 0}},
    moves="""
        R Z-40
        F X108 Z-30
        F Z0
        R X120
        R Z-50
        F X96 Z-30
        F Z0
        R X120
    """,
)

case(
    "an R of G90 against U and larger than its half alarms on the 988T (M427)",
    control="gsk-988t",
    source="Talm 123",
    evidence="maker's manual",
    program="""
        O1
        G90 X40 Z-20 R6 F100
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 50, "Z": 0}},
    alarm="taper",
    number="123",
    at="O1", word="R6",
)

case(
    "an R of G94 against W and larger than it alarms on the 988T (M428)",
    control="gsk-988t",
    source="Talm 124",
    evidence="maker's manual",
    program="""
        O1
        G94 X20 Z-5 R6 F100
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 50, "Z": 0}},
    alarm="face-taper",
    number="124",
    at="O1", word="R6",
)

case(
    "in system B G77 is the turning cycle, and G90 and G91 are modes (M450)",
    control="fanuc-0i-d",
    source="CNCS; general knowledge",
    evidence="secondary",
    program="""
        O1
        G90 G77 X40 Z-20 F0.2
        G00 G91 X10 Z5
        G90 X0 Z100
        M30
    """,
    replace=MM,
    setup=LATHE_B | {"start": {"X": 50, "Z": 2}},
    moves="""
        R X40
        F Z-20
        F X50
        R Z2
        R X60 Z7
        R X0 Z100
    """,
)
