"""G20, G21 and G22."""

from conformance import case

MM = {"whole_numbers": "millimetres"}  # whole numbers are millimetres, on every control
MILL = {"machine": "mill"}
LATHE_A = {"machine": "lathe-a"}

case(
    "G20 that is not alone in its block alarms on the 988T (M149)",
    control="gsk-988t",
    source="Talm 042",
    evidence="maker's manual",
    program="""
        O1
        G0 X10
        G20 G0 X20
        M30
    """,
    replace=MM,
    setup=LATHE_A,
    moves="R X10",
    alarm="unit-change-misplaced",
    number="042",
    at="O1", word="G20",
)

case(
    "G20 in the middle of a program alarms on the 980MDi (M150)",
    control="gsk-980mdi",
    source="MDib 0038",
    evidence="maker's manual",
    program="""
        O1
        G00 X10
        G20
        M30
    """,
    replace=MM,
    setup=MILL,
    moves="R X10",
    alarm="unit-change-misplaced",
    number="0038",
    at="O1", word="G20",
)

case(
    "G22 makes X1000 one millimetre on the HNC-21 (M151)",
    control="hnc-21m",
    source="source 003, G20 G21 G22; the size of the pulse: general knowledge",
    evidence="source document",
    program="""
        O1
        G22
        G90 G00 X1000
        M30
    """,
    replace=MM,
    setup=MILL,
    moves="R X1",
)

case(
    "G22 is no unit on the 16i (M151)",
    control="fanuc-16i",
    source="source 003 for the HNC; FANUC: general knowledge",
    evidence="inferred",
    program="""
        O1
        G22
        G90 G00 X1000
        M30
    """,
    replace=MM,
    setup=MILL,
    moves="R X1000",
)
