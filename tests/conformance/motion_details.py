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
case(
    "G10 L10 to L13 set the four tables of tool offsets",
    control="fanuc-30i", source="general knowledge, G10", evidence="inferred",
    params=MM, setup=MILL,
    program="""
        O1
        N10 G90 G10 L10 P1 R5
        N20 G10 L11 P1 R0.5
        N30 G10 L12 P1 R3
        N40 G10 L13 P1 R0.25
        N50 #100=#2001
        N60 #101=#2201
        N70 #102=#13001
        N80 #103=#12001
        N90 G43 H1 G0 Z0
        N100 #104=#5083
        N110 M30
    """,
    vars={100: 0.5, 101: 5, 102: 3, 103: 0.25, 104: 5.5},
)
case(
    "in G91 G10 adds to the offset",
    control="fanuc-30i", source="general knowledge, G10", evidence="inferred",
    params=MM, setup=MILL,
    program="""
        O1
        N10 G90 G10 L10 P1 R5
        N20 G91 G10 L10 P1 R2
        N30 #100=#2201
        N40 M30
    """,
    vars={100: 7},
)
case(
    "G10 of a tool offset without R lacks its value",
    control="fanuc-30i", source="general knowledge, G10", evidence="inferred",
    params=MM, setup=MILL,
    program="O1\nN10 T1\nN20 G10 L10 P1\nN30 M30\n",
    runs="N10", alarm="g10-value-missing", at="O1 N20", number="PS0031",
)
case(
    "G10 L20 sets the systems of G54.1",
    control="fanuc-30i", source="general knowledge, G10", evidence="inferred",
    params=MM, setup=MILL,
    program="""
        O1
        N10 G90 G10 L20 P2 X4
        N20 G54.1 P1 G0 X0
        N30 G54.1 P2 X0
        N40 M30
    """,
    centre="X0 | X4",
)
case(
    "G92.1 takes the shift of G92 back, of the axes it names",
    control="fanuc-30i", source="general knowledge, G92.1", evidence="inferred",
    params=MM, setup=MILL,
    program="""
        O1
        N10 G90 G92 X5 Y7
        N20 G0 X5 Y7
        N30 G92.1 X0
        N40 G0 X1 Y8
        N50 M30
    """,
    centre="X0 Y0 | X1 Y1",
)
case(
    "a bored hole is left beside its wall: G76 shifts by Q and shifts back",
    control=["fanuc-30i", "fanuc-0i-f"], source="15iM p.315; general knowledge", evidence="inferred",
    params=MM, setup=MILL,
    program="""
        O1
        N10 G90 G0 Z50
        N20 G76 X10 Y20 Z-10 R5 Q2 F100
        N30 G80
        N40 M30
    """,
    moves="""
        R Z50
        R X10 Y20
        R Z5
        F Z-10
        R X12
        R Z50
        R X10
    """,
)
case(
    "on the 980TDi G33 taps: in and out again",
    control="gsk-980tdi", source="TDi 24.5", evidence="maker's manual",
    program="""
        O1
        N10 M3 S100
        N20 G0 X0 Z5
        N30 G33 Z-10 F1
        N40 M30
    """,
    moves="""
        R Z5
        T Z-10
        T Z5
    """,
)
case(
    "a reset to the codes of power-on keeps unit and work system",
    control=["fanuc-30i", "fanuc-16i"], source="general knowledge, 3402#6", evidence="inferred",
    params=MM | {"3402#6": 1}, setup=MILL,
    program="""
        O1
        N10 G55 G20 G91 G18
        N20 M30
    """,
    modal_after_reset={"units": "G20", "work": "G55", "distance": "G90", "plane": "G17"},
)
case(
    "a block without a position drills no hole",
    control=["gsk-988ta", "gsk-988t"], source="TA 24; policy", evidence="inferred",
    program="""
        O1
        N10 G98 G0 X20 Z5
        N20 G83 X0 Z-10 R-2 F100
        N30 F50
        N40 G80
        N50 M30
    """,
    moves="""
        R X20 Z5
        R X0
        R Z3
        F Z-10
        R Z5
    """,
)
case(
    "the centre of G68 is absolute under G91 as well",
    control=["fanuc-16i", "fanuc-0i-f", "fanuc-30i"],
    source="B-64113EN p.789: absolute command", evidence="maker's manual",
    params=MM, setup=MILL,
    program="""
        O1
        N10 G90 G0 X10 Y10
        N20 G91 G68 X0 Y0 R90
        N30 G90 G0 X20 Y0
        N40 M30
    """,
    centre="X10 Y10 | X0 Y20",
)
case(
    "the centre of G51 is absolute under G91 as well",
    control=["fanuc-16i", "fanuc-0i-f", "fanuc-30i"],
    source="B-63682EN p.117: absolute command of the centre", evidence="maker's manual",
    params=MM, setup=MILL,
    program="""
        O1
        N10 G90 G0 X10 Y10
        N20 G91 G51 X0 Y0 P2000
        N30 G90 G0 X20 Y0
        N40 M30
    """,
    centre="X10 Y10 | X40 Y0",
)
case(
    "a thread under G96 turns with the surface speed",
    control="gsk-988ta", source="Talm 102 is for a spindle that stands", evidence="inferred",
    program="""
        O1
        N10 G96 S100 M3
        N20 G0 X20
        N30 G32 Z-10 F1
        N40 M30
    """,
    runs="N10 N20 N30 N40",
)
case(
    "a feed per revolution without a speed alarms",
    control=["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800", "gsk-980mdi"],
    source="general knowledge, P132; MDib 0013", evidence="inferred",
    program="""
        O1
        N10 G90 G95
        N20 G1 X10. F0.1
        N30 M30
    """,
    runs="N10", alarm="no-spindle-speed", at="O1 N20",
    number={
        "mitsubishi-meldas": "P132", "mitsubishi-m700": "P132", "mitsubishi-m800": "P132",
        "gsk-980mdi": "0013",
    },
)
case(
    "a feed per revolution with a speed cuts",
    control=["mitsubishi-m700", "gsk-980mdi"],
    source="general knowledge, P132; MDib 0013", evidence="inferred",
    program="""
        O1
        N10 G90 G95 S500 M3
        N20 G1 X10. F0.1
        N30 M30
    """,
    runs="N10 N20 N30",
)
