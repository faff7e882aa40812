"""Small print of moves: tables by G10, what a reset keeps, arcs under mirror."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MILL = {"machine": "mill"}
LATHE = {"machine": "lathe-a"}
MM = {"3401#0": 1}

case(
    "U and W of G10 add to the tool's offset",
    control=FANUC, source="general knowledge", evidence="inferred",
    params=MM, setup=LATHE | {"tools": {1: {"X": 1, "Z": 2}}},
    program="""
        O1
        N10 G10 P1 U10 W20
        N20 T0101
        N30 G0 X0 Z0
        N40 M30
    """,
    final_machine="X11 Z22",
)
case(
    "P0 of G10 on a lathe sets the shift of the work system, no tool",
    control=FANUC, source="general knowledge", evidence="inferred",
    params=MM, setup=LATHE,
    program="""
        O1
        N10 G10 P0 X10 Z20
        N20 G0 X0 Z0
        N30 M30
    """,
    final_machine="X10 Z20",
)
case(
    "mirrored in one axis an arc turns the other way round its mirrored centre",
    control=["fanuc-30i", "mitsubishi-m700"], source="general knowledge", evidence="inferred",
    params=MM, setup=MILL,
    program="""
        O1
        N10 G17 G90 G51.1 X0
        N20 G2 X10 Y10 I10 J0 F100
        N30 M30
    """,
    moves="CCW X-10 Y10 C X-10 Y0",
)
case(
    "mirrored in the second axis of the plane an arc turns the other way",
    control=["fanuc-30i", "mitsubishi-m700"], source="general knowledge", evidence="inferred",
    params=MM, setup=MILL,
    program="""
        O1
        N10 G18 G90 G51.1 X0
        N20 G2 X10 Z10 I10 K0 F100
        N30 M30
    """,
    moves="CCW X-10 Z10 C X-10 Z0",
)
case(
    "#7001 and those behind it are the offsets of G54.1",
    control=["fanuc-16i", "fanuc-30i"], source="general knowledge, #7001", evidence="inferred",
    params=MM, setup=MILL,
    program="""
        O1
        N10 #7002=3
        N20 #7021=7
        N30 G54.1 P1 G0 X0 Y0
        N40 G54.1 P2 X0 Y0
        N50 M30
    """,
    centre="X0 Y3 | X7 Y0",
)
