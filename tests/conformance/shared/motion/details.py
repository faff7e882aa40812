"""Small print of moves: tables by G10, what a reset keeps, arcs under mirror."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MILL = {"machine": "mill"}
LATHE = {"machine": "lathe-a"}
MM = {"whole_numbers": "millimetres"}

case(
    "U and W of G10 add to the tool's offset",
    control=FANUC, source="general knowledge", evidence="inferred",
    replace=MM, setup=LATHE | {"tools": {1: {"X": 1, "Z": 2}}},
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
    replace=MM, setup=LATHE,
    program="""
        O1
        N10 G10 P0 X10 Z20
        N20 G0 X0 Z0
        N30 M30
    """,
    final_machine="X10 Z20",
)
case(
    "mirrored in one axis the tool stays on the same side of the mirrored contour: G41 compensates as G42",
    control=["fanuc-30i", "mitsubishi-m700"], source="general knowledge", evidence="inferred",
    setup={**MILL, "radius_offsets": {1: 1}, "work_offsets": {"G54": {"X": 1.125, "Y": -40.25}}},
    program="""
        O1
        N10 G17 G90 G51.1 X0
        N20 G1 X10. Y0 F100
        N30 G41 D1 X20. Y0
        N40 X20. Y20.
        N50 M30
    """,
    final_machine="X-17.875 Y-20.25",
)
case(
    "mirrored in one axis an arc turns the other way round its mirrored centre",
    control=["fanuc-30i", "mitsubishi-m700"], source="general knowledge", evidence="inferred",
    replace=MM, setup=MILL,
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
    replace=MM, setup=MILL,
    program="""
        O1
        N10 G18 G90 G51.1 X0
        N20 G2 X10 Z10 I10 K0 F100
        N30 M30
    """,
    moves="CCW X-10 Z10 C X-10 Z0",
)
case(
    "#7001 and those after it are the offsets of G54.1",
    control=["fanuc-16i", "fanuc-30i"], source="general knowledge, #7001", evidence="inferred",
    replace=MM, setup=MILL,
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
    replace=MM, setup=MILL,
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
    replace=MM, setup=MILL,
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
    replace=MM, setup=MILL,
    program="O1\nN10 T1\nN20 G10 L10 P1\nN30 M30\n",
    runs="N10", alarm="g10-value-missing", at="O1 N20", word="G10", number="PS0031",
)
case(
    "G10 L20 sets the systems of G54.1",
    control="fanuc-30i", source="general knowledge, G10", evidence="inferred",
    replace=MM, setup=MILL,
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
    replace=MM, setup=MILL,
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
    replace=MM, setup=MILL,
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
    pins="g_meanings",
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
    "G54 to G59 beside G50 of a lathe select nothing",
    pins="machine",
    control="gsk-980tdi", source="TDi 21 note 6", evidence="maker's manual",
    setup={"work_offsets": {"G55": {"X": 10, "Z": 20}}},
    program="""
        O1
        N10 G55 G50 X0 Z0
        N20 G54
        N30 G0 X5 Z5
        N40 M30
    """,
    final_machine="X5 Z5",
)
case(
    "G87 of a lathe drills along X",
    pins="drill_retract",
    control="gsk-988ta", source="TA 24", evidence="maker's manual",
    program="""
        O1
        N10 G98 G0 X20 Z5
        N20 G87 Z0 X10 R-2 F100
        N30 G80
        N40 M30
    """,
    moves="""
        R X20 Z5
        R Z0
        R X16
        F X10
        R X20
    """,
)
case(
    "G87 of a mill waits at the depth",
    control=["fanuc-0i-f", "fanuc-30i"], source="general knowledge, G87", evidence="inferred",
    replace=MM, setup=MILL,
    program="""
        O1
        N10 G90 G0 Z50
        N20 G87 X0 Y0 Z-10 R-20 Q2 P1000 F100
        N30 M30
    """,
    moves="""
        R Z50
        R X0 Y0
        R X2
        R Z-20
        R X0
        F Z-10
        W 1
        R X2
        R Z50
        R X0
    """,
)
case(
    "around an acute corner the tool goes in straight lines",
    control=FANUC, source="30iM p.186; general knowledge", evidence="inferred",
    replace=MM, setup=MILL | {"radius_offsets": {1: 2}},
    program="""
        O1
        N10 G90 G41 D1 G1 X0 Y10 F600
        N20 Y20
        N30 X10 Y0
        N40 G40 X20 Y-20
        N50 M30
    """,
    moves="""
        F X0 Y10
        F Y20
        F Y20
        F X10 Y0
        F X20 Y-20
    """,
    centre="X-2 Y10 | X-2 Y22 | X0.89443 Y22.68328 | X11.78885 Y0.89443 | X20 Y-20",
)
case(
    "with 19607#2 the tool goes around an acute corner in an arc",
    control="fanuc-30i", source="general knowledge, 19607#2", evidence="inferred",
    params={"19607#2": 1}, replace=MM, setup=MILL | {"radius_offsets": {1: 2}},
    program="""
        O1
        N10 G90 G41 D1 G1 X0 Y10 F600
        N20 Y20
        N30 X10 Y0
        N40 G40 X20 Y-20
        N50 M30
    """,
    moves="""
        F X0 Y10
        F Y20
        CW X0 Y20 C X0 Y20
        F X10 Y0
        F X20 Y-20
    """,
    centre="X-2 Y10 | X-2 Y20 | X1.78885 Y20.89443 | X11.78885 Y0.89443 | X20 Y-20",
)
case(
    "a long arc that is cut by a chamfer keeps the rest of its way",
    control="fanuc-30i", source="general knowledge, ,C", evidence="inferred",
    replace=MM, setup=MILL,
    # The arc: 320 degrees of radius 10, less 2 asin(1/20); 0.731 across the corner; 12.573 down.
    program="""
        O1
        N10 G90 G2 X2.339556 Y-6.427876 I10 J0 F600 ,C1
        N20 G1 Y-20
        N30 M30
    """,
    time=(54.85077 + 0.73072 + 12.573) / 10,
)
case(
    "an arc runs the short way its code says: a twelfth of a circle to the left and to the right",
    control=["fanuc-30i", "mitsubishi-m700", "gsk-988ta"], source="geometry", evidence="inferred",
    replace=MM, setup=MILL,
    # Two arcs of 30 degrees with radius 10.
    program="""
        O1
        N10 G90 G3 X-1.34 Y5. I-10. J0 F600
        N20 G2 X0 Y0 I-8.66 J-5.
        N30 M30
    """,
    moves="CCW X-1.34 Y5 C X-10 Y0\nCW X0 Y0 C X-10 Y0", time=2 * 0.5235988,
)
case(
    "an arc whose end lies a hair beside its start, and as far round, is a whole circle",
    pins="arc_tolerance",
    control=["gsk-988ta", "mitsubishi-m700"], source="general knowledge: the radii differ within the tolerance",
    evidence="inferred", setup=MILL,
    program="""
        O1
        N10 G90 G2 X0.005 Y0 I10. J0 F600
        N20 M30
    """,
    moves="CW X0.005 Y0 C X10 Y0", time=6.2816,
)
case(
    "an axis that no block has moved stands where the zero point puts it",
    control=FANUC, source="general knowledge", evidence="inferred",
    replace=MM, setup=MILL | {"work_offsets": {"G54": {"Y": 10}}},
    program="""
        O1
        N10 #1=5
        N20 G90 G0 X#1
        N30 M30
    """,
    moves="R X5 Y-10 Z0",
)
case(
    "what is not written stays where it is, seen through a scaling",
    control=["fanuc-16i", "fanuc-0i-f", "fanuc-30i"], source="general knowledge, G51", evidence="inferred",
    replace=MM, setup=MILL,
    program="""
        O1
        N10 G90 G51 X10 Y20 P2000
        N20 G0 X15
        N30 M30
    """,
    moves="R X20 Y0",
)
case(
    "G10 without R keeps the radius of the tool, and T00 has none",
    control=FANUC, source="general knowledge, G10", evidence="inferred",
    replace=MM, setup=LATHE | {"tools": {1: {"R": 2}}},
    program="""
        O1
        N10 G10 P1 X0
        N20 G10 P0 R7
        N30 T0101 G0 G42 X10 Z5
        N40 G98 G1 Z-10 F100
        N50 G40 T0100 X20
        N60 G42 Z-20
        N70 Z-30
        N80 M30
    """,
    centre="X14 Z5 | X14 Z-10 | X20 Z-10 | X20 Z-20 | X20 Z-30",
)
case(
    "P1 is the first of the systems of G54.1",
    control=["fanuc-16i", "fanuc-30i"], source="general knowledge, G54.1", evidence="inferred",
    setup=MILL | {"work_offsets": {"G54.1 P1": {"X": 5}}},
    program="O1\nN10 G54.1 P1 G0 X0\nN20 M30\n",
    final_machine="X5",
)
case(
    "a machine that was set up with more offsets than usual has them",
    control=FANUC, source="policy: the setup is the machine's own", evidence="inferred",
    setup=MILL | {"length_offsets": {9000: 5}},
    program="O1\nN10 G43 H9000 G0 Z0\nN20 M30\n",
    final_machine="Z5",
)
case(
    "G71, a code of lathes, is not computed where the setup tells a mill",
    control="gsk-988ta", source="policy: a code of the control's list", evidence="inferred", setup=MILL,
    program="O1\nN10 G0 X1\nN20 G71 U1 R1\nN30 M30\n",
    runs="N10", alarm="code-not-computed", at="O1 N20", word="G71",
)
case(
    "G70 belongs to the plane of X and Z as the cycles that cut do",
    control="gsk-988ta", source="Talm 126", evidence="maker's manual",
    program="O1\nN10 G17\nN20 G70 P30 Q30\nN30 G0 X5\nN40 M30\n",
    runs="N10", alarm="cycle-plane", number="126", at="O1 N20", word="G70",
)
case(
    "a block without a position repeats no turning cycle, one with a new taper does",
    control=["gsk-988ta", "gsk-980tdi"], source="TA 6; policy", evidence="inferred",
    program="""
        O1
        N10 G98 G0 X20 Z0
        N20 G90 X18 Z-10 F600
        N30 M8
        N40 R1
        N50 M30
    """,
    moves="""
        R X20 Z0
        R X18
        F Z-10
        F X20
        R Z0
        R X20
        F X18 Z-10
        F X20
        R Z0
    """,
)
case(
    "an arc of the profile stops only the cuts that cross it",
    pins="escape",
    control=["gsk-988ta", "gsk-980tdi"], source="TDi 23.1; TA 8; geometry", evidence="inferred",
    # At X18 the arc lies sqrt(25 - 1) behind its centre at X20 Z-10.
    program="""
        O1
        N10 G98 G0 X30 Z2
        N20 G71 U3 R1
        N30 G71 P40 Q70 U0 W0 F100
        N40 G0 X10
        N50 G1 Z-10
        N60 G2 X20 Z-15 R5
        N70 G1 X30
        N80 M30
    """,
    moves="""
        R X30 Z2
        R X30
        R X24
        F Z-15
        F X26 Z-14
        R Z2
        R X18
        F Z-14.89898
        F X20 Z-13.89898
        R Z2
        R X12
        F Z-13
        F X14 Z-12
        R Z2
        R X10
        F Z-10
        CW X20 Z-15 C X20 Z-10
        F X30
        R Z2
    """,
)
case(
    "under G96 the spindle turns with the diameter, under G97 with S",
    control="gsk-988ta", source="general knowledge, G96", evidence="inferred",
    # 100 m/min on a diameter of 100 is 318.31 revolutions a minute.
    program="""
        O1
        N10 G99 G96 S100 M3
        N20 G0 X100 Z0
        N30 G1 Z-10 F0.1
        N40 G97 S1000
        N50 G1 Z-20
        N60 M30
    """,
    moves="R X100 Z0\nF Z-10\nF Z-20", time=0.3 + 18.84956 + 6,
)
case(
    "#4002 is G96 or G97 of a lathe, and #4008 its watch of the spindle's speed",
    control=FANUC, source="general knowledge, #4001 to #4021 of lathes", evidence="inferred",
    setup=LATHE,
    program="""
        O1
        N10 G26
        N20 G96 S100
        N30 #100=#4008
        N40 #101=#4002
        N50 M30
    """,
    vars={100: 26, 101: 96},
)
case(
    "polar coordinates are off at power-on",
    control=["fanuc-16i", "fanuc-0i-f", "fanuc-30i"], source="general knowledge, #4017", evidence="inferred",
    setup=MILL,
    program="O1\nN10 #100=#4017\nN20 M30\n",
    vars={100: 15},
)
case(
    "the codes that a reset leaves are told with their groups",
    control="fanuc-30i", source="general knowledge", evidence="inferred",
    replace=MM, setup=MILL,
    program="""
        O1
        N10 G54.1 P2 G99 G81 X1 Z-1 R1 F100
        N20 M30
    """,
    modal_after_reset={"cycle": "G80", "return": "G99", "work": "G54.1 P2"},
)
case(
    "a reset to the codes of power-on keeps unit and work system",
    control=["fanuc-30i", "fanuc-16i"], source="general knowledge, 3402#6", evidence="inferred",
    params={"3402#6": 1}, replace=MM, setup=MILL,
    program="""
        O1
        N10 G55 G20 G91 G18
        N20 M30
    """,
    modal_after_reset={"units": "G20", "work": "G55", "distance": "G90", "plane": "G17"},
)
case(
    "a block without a position drills no hole",
    pins="machine drill_retract",
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
    replace=MM, setup=MILL,
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
    replace=MM, setup=MILL,
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
    pins="machine",
    control=["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800", "gsk-980mdi"],
    source="general knowledge, P132; MDib 0013", evidence="inferred",
    program="""
        O1
        N10 G90 G95
        N20 G1 X10. F0.1
        N30 M30
    """,
    runs="N10", alarm="no-spindle-speed", at="O1 N20", word="G1",
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
case(
    "G31 feeds, and alarms without a feed",
    control="fanuc-16i", source="ALM 011", evidence="secondary",
    setup=MILL, program="O1\nN10 G0 X1.\nN20 G31 X10.\nN30 M30\n",
    runs="N10", alarm="no-feed", at="O1 N20", word="G31", number="011",
)
case(
    "a computed T below zero alarms, as a written one does",
    control=["fanuc-0i-f", "mitsubishi-m800", "haas-ngc", "gsk-988ta"], source="general knowledge", evidence="inferred",
    program="O1\nN10 #1=-5\nN20 T#1\nN30 M30", runs="N10", alarm="value-out-of-range",
    number={"fanuc-0i-f": "PS1305", "mitsubishi-m800": "P35", "haas-ngc": None, "gsk-988ta": "003"}, at="O1 N20",
)
case(
    "digits finer than the least increment are cut in the unit of their own block",
    control="fanuc-0i-f", source="general knowledge", evidence="inferred", setup=MILL,
    program="O1\nN10 G20 G0 X1.23456\nN20 G21 X31.2345\nN30 M30",
    moves="R X31.3563\nR X31.234",
)
