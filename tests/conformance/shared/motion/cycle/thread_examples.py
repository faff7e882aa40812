"""Threads: worked examples."""

from conformance import case

MM = {"whole_numbers": "millimetres"}  # whole numbers are millimetres, on every control
MILL = {"machine": "mill"}
LATHE_A = {"machine": "lathe-a"}

case(
    "G33 cuts a thread along Z (M057)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge",
    evidence="inferred",
    program="""
        O1
        S500 M03
        G33 Z-20 F1.5
        G00 Z5
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 0, "Y": 0, "Z": 5}},
    moves="""
        T Z-20
        R Z5
    """,
)

case(
    "the manual's taper thread runs in two cuts (M420)",
    pins="refuses:spindle-stopped",
    control="gsk-980tdi",
    source="TDi 24.1, O0009",
    evidence="maker's manual",
    program="""
        O0009
        G00 X27.4286 Z3
        G32 X48.8571 W-75 F2.0
        G00 X55
        W75
        X26.4286
        G32 X47.4286 W-75 F2.0
        G00 X55
        W75
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 55, "Z": 3}},
    moves="""
        R X27.4286 Z3
        T X48.8571 Z-72
        R X55
        R Z3
        R X26.4286
        T X47.4286 Z-72
        R X55
        R Z3
    """,
)

case(
    "G76 without the height of the thread alarms on the 988T (M446)",
    control="gsk-988t",
    source="Talm 167",
    evidence="maker's manual",
    program="""
        O1
        G76 P020560 Q150 R0.1
        G76 X60.64 Z-62 Q1800 F6
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 80, "Z": 10}},
    alarm="thread-height",
    number="167",
    at="O1", word="G76",
)

case(
    "a thread with the spindle at rest alarms on the 988T (M447)",
    control="gsk-988t",
    source="Talm 102",
    evidence="maker's manual",
    program="""
        O1
        S0 M05
        G32 Z-20 F2
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 20, "Z": 3}},
    alarm="spindle-stopped",
    number="102",
    at="O1", word="G32",
)
