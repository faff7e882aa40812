"""Lines and arcs: R, centres, full circles, helices, tolerances."""

from conformance import case

MM = {"whole_numbers": "millimetres"}  # whole numbers are millimetres, on every control
MILL = {"machine": "mill"}
LATHE_A = {"machine": "lathe-a"}

case(
    "G01 takes three axes along one line (M002)",
    control=["fanuc-0i-f", "fanuc-16i", "hnc-21m"],
    source="source 003, text on G01",
    evidence="source document",
    program="""
        O1
        G01 X10. Y20. Z20. F80.
        M30
    """,
    replace=MM,
    setup=MILL,
    moves="F X10 Y20 Z20",
)

case(
    "the two lines of the lesson run from the start point to the end (M003)",
    control="fanuc-0i-f",
    source="source 003, example 3; coordinates restored from memory",
    evidence="inferred",
    program="""
        O1
        N1 G01 X150. Y25. F100.
        N2 X50. Y75.
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": -50, "Y": -75, "Z": 0}},
    moves="""
        F X150 Y25
        F X50 Y75
    """,
)

case(
    "G02 with R40 makes the half circle of the lesson (M004)",
    control=["fanuc-0i-f", "fanuc-16i", "hnc-21m"],
    source="source 003, example 4",
    evidence="source document",
    program="""
        O1
        N10 G90 G00 X40 Y60
        N20 G02 X120 R40 F100
        M30
    """,
    replace=MM,
    setup=MILL,
    moves="""
        R X40 Y60
        CW X120 Y60 C X80 Y60
    """,
)

case(
    "G02 with I and J makes the same half circle (M005)",
    control=["fanuc-0i-f", "fanuc-16i", "hnc-21m"],
    source="source 003, example 4",
    evidence="source document",
    program="""
        O1
        N10 G90 G00 X40 Y60
        N20 G02 X120 I40 J0 F100
        M30
    """,
    replace=MM,
    setup=MILL,
    moves="""
        R X40 Y60
        CW X120 Y60 C X80 Y60
    """,
)

case(
    "a negative R takes the long way round (M006)",
    pins="minus_addresses",
    control=["fanuc-0i-f", "fanuc-16i", "hnc-21m"],
    source="source 003, example 5",
    evidence="source document",
    program="""
        O1
        G02 X80 Y20 R-40 F100
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 40, "Y": 60, "Z": 0}},
    moves="CW X80 Y20 C X80 Y60",
)

case(
    "a positive R takes the short way round (M007)",
    control=["fanuc-0i-f", "fanuc-16i", "hnc-21m"],
    source="source 003, example 5",
    evidence="source document",
    program="""
        O1
        G02 X80 Y20 R40 F100
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 40, "Y": 60, "Z": 0}},
    moves="CW X80 Y20 C X40 Y20",
)

case(
    "G02 with I and no end is a full circle (M008)",
    control=["fanuc-0i-f", "fanuc-16i", "hnc-21m"],
    source="source 003, example 6",
    evidence="source document",
    program="""
        O1
        G02 I40 F100
        M30
    """,
    replace=MM,
    setup=MILL,
    moves="CW X0 Y0 C X40 Y0",
)

case(
    "a third axis in an arc block goes along with the angle (M037)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700", "hnc-21m"],
    source="source 003, G02 and G03; TApar 1403#5; general knowledge",
    evidence="inferred",
    program="""
        O1
        G17 G03 X0 Y20 I-20 Z-5 F200
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 20, "Y": 0, "Z": 0}},
    moves="CCW X0 Y20 Z-5 C X0 Y0",
)

case(
    "an arc block without an end in the plane makes a helix of a full turn (M038)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700"],
    source="general knowledge",
    evidence="inferred",
    program="""
        O1
        G17 G02 I-20 Z-5 F200
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 20, "Y": 0, "Z": 0}},
    moves="CW X20 Y0 Z-5 C X0 Y0",
)

case(
    "R counts where I and J stand beside it (M039)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 003, note 3; 16TC p.67; TDi 4 note 2",
    evidence="source document",
    program="""
        O1
        G02 X80 Y20 R40 I99 J99 F100
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 40, "Y": 60, "Z": 0}},
    moves="CW X80 Y20 C X40 Y20",
)

case(
    "an arc with R and no end does not move (M040)",
    control=["fanuc-16i", "fanuc-30i"],
    source="16TC p.67; TDi 4 note 4",
    evidence="maker's manual",
    program="""
        O1
        G02 R20 F100
        G01 X20
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 10, "Y": 0, "Z": 0}},
    moves="F X20",
)

case(
    "an arc without R, I, J and K is a line while 3403#5 is 0 (M041)",
    control=["fanuc-16i", "fanuc-30i"],
    source="TApar 3403#5; for FANUC: general knowledge",
    evidence="secondary",
    program="""
        O1
        G02 X10 Y10 F100
        M30
    """,
    params={"3403#5": 0}, replace=MM,
    setup=MILL,
    moves="F X10 Y10",
)

case(
    "an arc without R, I, J and K alarms while 3403#5 is 1 (M042)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0022; TApar 3403#5",
    evidence="secondary",
    program="""
        O1
        G02 X10 Y10 F100
        M30
    """,
    params={"3403#5": 1}, replace=MM,
    setup=MILL,
    alarm="no-radius",
    number={"fanuc-16i": "022", "fanuc-30i": "PS0022"},
    at="O1", word="G02",
)

case(
    "an arc whose radii differ by more than 3410 alarms (M043)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0020; 16TC p.67",
    evidence="maker's manual",
    program="""
        O1
        G01 X10 Y0 F100
        G03 X0 Y10.05 I-10 J0
        M30
    """,
    params={"3410": 0.01}, replace=MM,
    setup=MILL,
    moves="F X10 Y0",
    alarm="radius-tolerance",
    number={"fanuc-16i": "020", "fanuc-30i": "PS0020"},
    at="O1", word="X0",
)

case(
    "an arc whose radii differ by less than 3410 goes to its programmed end (M044)",
    control=["fanuc-16i", "fanuc-30i"],
    source="16TC p.67; ALM PS0020",
    evidence="secondary",
    program="""
        O1
        G01 X10 Y0 F100
        G03 X0 Y10.05 I-10 J0
        M30
    """,
    params={"3410": 0.1}, replace=MM,
    setup=MILL,
    moves="""
        F X10 Y0
        CCW X0 Y10.05 C X0 Y0
    """,
)

case(
    "an arc whose R is smaller than half of the chord alarms (M045)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700"],
    source="MZ 818, paired with P71; FANUC 020: general knowledge",
    evidence="inferred",
    program="""
        O1
        G02 X100 Y0 R40 F100
        M30
    """,
    replace=MM,
    setup=MILL,
    alarm="radius-too-small",
    number={"fanuc-16i": "020", "fanuc-30i": "PS0020", "mitsubishi-m700": "P71"},
    at="O1", word="R40",
)

case(
    "an arc without an X ends at the X of its start (M047)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700", "hnc-21m"],
    source="TDi 4 note 4; source 003, note 4",
    evidence="maker's manual",
    program="""
        O1
        G03 Y-10 J-10 F100
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 10, "Y": 10, "Z": 0}},
    moves="CCW X10 Y-10 C X10 Y0",
)

case(
    "an arc whose end lies off the circle by more than RadErr alarms on the M700 (M051)",
    control="mitsubishi-m700",
    source="MZ 817, paired with P70; M7 p.194",
    evidence="secondary",
    program="""
        O1
        G01 X10 F100
        G03 X0 Y11 I-10
        M30
    """,
    params={"1084": 0.1}, replace=MM,
    setup=MILL,
    moves="F X10",
    alarm="radius-tolerance",
    number="P70",
    at="O1", word="X0",
)

case(
    "an arc whose centre is its start alarms on the 980MDi (M058)",
    control="gsk-980mdi",
    source="MDib 0021",
    evidence="secondary",
    program="""
        O1
        G02 X10 Y0 I0 J0 F100
        M30
    """,
    replace=MM,
    setup=MILL,
    alarm="no-radius",
    number="0021",
    at="O1", word="I0",
)

case(
    "the manual's arc with R has its centre where the figure shows it (M405)",
    pins="point_addresses",
    control="gsk-980tdi",
    source="TDi 4, example, figure 3-9",
    evidence="maker's manual",
    program="""
        O1
        G02 X63.060 Z-24.071 R19.16 F300
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 45.359, "Z": 0}},
    moves="CW X63.06 Z-24.071 C X80.9328 Z-7.1227",
)

case(
    "the manual's program of arcs runs along its figure (M407)",
    control=["gsk-980tdi", "fanuc-0i-d"],
    source="TDi 4, figure 3-10",
    evidence="maker's manual",
    program="""
        O0001
        N001 G0 X40 Z5
        N002 M03 S200
        N003 G01 X0 Z0 F900
        N005 G03 U24 W-24 R15
        N006 G02 X26 Z-31 R5
        N007 G01 Z-40
        N008 X40 Z5
        N009 M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 60, "Z": 20}},
    moves="""
        R X40 Z5
        F X0 Z0
        CCW X24 Z-24 C X0 Z-15
        CW X26 Z-31 C X32 Z-27
        F X26 Z-40
        F X40 Z5
    """,
)

case(
    "a negative R is the long way round on the 980TDi (M408)",
    control="gsk-980tdi",
    source="TDi 4 note 7",
    evidence="maker's manual",
    program="""
        O1
        G03 X40 Z-20 R-12.5 F100
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 40, "Z": 0}},
    moves="CCW X40 Z-20 C X55 Z-10",
)

case(
    "a negative R alarms on a FANUC lathe (M409)",
    pins="negative_radius",
    control="fanuc-16i",
    source="16TC p.67; the number: general knowledge",
    evidence="inferred",
    program="""
        O1
        G03 X40 Z-20 R-12.5 F100
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 40, "Z": 0}},
    alarm="negative-radius",
    number="023",
    at="O1", word="R-12.5",
)

case(
    "a lathe arc whose R is smaller than half of the chord alarms (M411)",
    pins="minus_addresses refuses",
    control=["gsk-980tdi", "gsk-988t"],
    source="TDi 4 note 3; Talm 035 with TApar 3403#4",
    evidence="maker's manual",
    program="""
        O1
        G03 X40 Z-50 R20 F100
        M30
    """,
    replace=MM | {"small_radius": "alarm"},
    setup=LATHE_A | {"start": {"X": 40, "Z": 0}},
    alarm="radius-too-small",
    number={"gsk-980tdi": None, "gsk-988t": "035"},
    at="O1", word="R20",
)

case(
    "an arc whose radii differ by more than 3410 alarms on the 988T (M412)",
    control="gsk-988t",
    source="Talm 036",
    evidence="maker's manual",
    program="""
        O1
        G03 X20 Z-11 I0 K-10 F100
        M30
    """,
    params={"3410": 0.01}, replace=MM,
    setup=LATHE_A | {"start": {"X": 0, "Z": 0}},
    alarm="radius-tolerance",
    number="036",
    at="O1", word="X20",
)

case(
    "an arc with an axis outside its plane alarms on the 988T (M413)",
    control="gsk-988t",
    source="Talm 033",
    evidence="maker's manual",
    program="""
        O1
        G18 G02 X10 Y10 R20 F100
        M30
    """,
    replace=MM,
    setup=LATHE_A,
    alarm="arc-axis-not-in-plane",
    number="033",
    at="O1", word="Y10",
)
