"""The time that moves and dwells take."""

from conformance import case

MM = {"whole_numbers": "millimetres"}  # whole numbers are millimetres, on every control
MILL = {"machine": "mill"}
LATHE_A = {"machine": "lathe-a"}

case(
    "F holds over a G00 (M050)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700", "hnc-21m"],
    source="0iTC p.66; TDi 26; general knowledge",
    evidence="maker's manual",
    program="""
        O1
        G01 X10 F100
        G00 X0
        G01 X5
        M30
    """,
    replace=MM,
    setup=MILL,
    moves="""
        F X10
        R X0
        F X5
    """,
)

case(
    "a dwell counts P in milliseconds and X in seconds (M139)",
    control=["fanuc-16i", "fanuc-30i"],
    source="TDi 14; FANUC: general knowledge",
    evidence="secondary",
    program="""
        O1
        G04 P1500
        G04 X2.5
        M30
    """,
    replace=MM,
    setup=MILL,
    moves="""
        W 1.5
        W 2.5
    """,
    time=4,
)

case(
    "a dwell of the HNC-21 counts P in seconds (M140)",
    pins="dwell_unit",
    control="hnc-21m",
    source="source 003, G04; general knowledge",
    evidence="source document",
    program="""
        O1
        G04 P2
        M30
    """,
    replace=MM,
    setup=MILL,
    moves="W 2",
)

case(
    "a dwell leaves G01 in force (M143)",
    control=["fanuc-16i", "fanuc-30i", "gsk-980tdi"],
    source="TDi 14",
    evidence="maker's manual",
    program="""
        O1
        G01 X10 F100
        G04 P100
        X20
        M30
    """,
    replace=MM,
    setup=MILL,
    moves="""
        F X10
        W 0.1
        F X20
    """,
)

case(
    "the time of an arc is its length by the feed (M145)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700"],
    source="general knowledge",
    evidence="inferred",
    program="""
        O1
        G02 I10 F120
        M30
    """,
    replace=MM,
    setup=MILL,
    moves="CW X0 Y0 C X10 Y0",
    time=31.416,
)

case(
    "the slowest axis gives the time of a rapid move (M146)",
    control=["fanuc-16i", "fanuc-30i", "gsk-980tdi"],
    source="30i p.82; TDi 26",
    evidence="secondary",
    program="""
        O1
        G90 G00 X100 Y50 Z30
        M30
    """,
    replace=MM,
    setup=MILL | {"rapid": {"X": 6000, "Y": 6000, "Z": 3000}},
    moves="R X100 Y50 Z30",
    time=1,
)

case(
    "feed per revolution takes the time from the spindle (M147)",
    control=["fanuc-16i", "fanuc-30i"],
    source="TDi 26; source 003",
    evidence="secondary",
    program="""
        O1
        G95 S500 M03
        G01 X50 F0.2
        M30
    """,
    replace=MM,
    setup=MILL,
    moves="F X50",
    time=30,
)

case(
    "a rapid X in diameters takes half of its value along the rate (M148)",
    control="gsk-980tdi",
    source="TDi 26, example, by its own numbers",
    evidence="inferred",
    program="""
        O1
        G0 G98 X50 Z0
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 160, "Z": 80}, "rapid": {"X": 3800, "Z": 7600}},
    moves="R X50 Z0",
    time=0.868,
)

case(
    "a feed above parameter 027 alarms on the 980MDi (M152)",
    control="gsk-980mdi",
    source="MDib 0023",
    evidence="secondary",
    program="""
        O1
        G01 X10 F5000
        M30
    """,
    params={"027": 3000}, replace=MM,
    setup=MILL,
    alarm="feed-out-of-range",
    number="0023",
    at="O1", word="F5000",
)

case(
    "the program of constant surface speed moves as the manual says (M448)",
    control="gsk-980tdi",
    source="TDi 25, O0001",
    evidence="maker's manual",
    program="""
        O0001
        N0010 M3 G96 S300
        N0020 G0 X100 Z50
        N0030 G0 X50 Z0
        N0040 G1 W-30 F200
        N0050 X80 W-20 F150
        N0060 G0 X100 Z50
        N0110 M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 200, "Z": 60}},
    moves="""
        R X100 Z50
        R X50 Z0
        F Z-30
        F X80 Z-50
        R X100 Z50
    """,
)
