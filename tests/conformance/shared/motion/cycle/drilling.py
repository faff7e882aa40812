"""Drilling cycles."""

from conformance import case

MM = {"whole_numbers": "millimetres"}  # whole numbers are millimetres, on every control
MILL = {"machine": "mill"}

case(
    "under G99 the next hole is reached at R, and G98 goes back to the initial level (M302)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700", "hnc-21m"],
    source="general knowledge",
    evidence="inferred",
    program="""
        O1
        G90 G99 G81 X10 Y20 Z-15 R3 F100
        X30
        G98 Y40
        G80
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 0, "Y": 0, "Z": 50}},
    moves="""
        R X10 Y20
        R Z3
        F Z-15
        R Z3
        R X30
        R Z3
        F Z-15
        R Z3
        R Y40
        R Z3
        F Z-15
        R Z50
    """,
)

case(
    "K3 under G91 drills three holes in a row (M304)",
    control=["fanuc-16i", "fanuc-30i"],
    source="30iM p.73; general knowledge",
    evidence="secondary",
    program="""
        O1
        G91 G98 G81 X10 Z-12 R-18 F100 K3
        G80
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 0, "Y": 0, "Z": 20}},
    moves="""
        R X10
        R Z2
        F Z-10
        R Z20
        R X20
        R Z2
        F Z-10
        R Z20
        R X30
        R Z2
        F Z-10
        R Z20
    """,
)

case(
    "K0 keeps the data and drills nothing (M305)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge",
    evidence="inferred",
    program="""
        O1
        G90 G99 G81 X10 Z-5 R2 F100 K0
        X20
        G80
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 0, "Y": 0, "Z": 20}},
    moves="""
        R X20
        R Z2
        F Z-5
        R Z2
    """,
)

case(
    "G82 dwells at the bottom (M307)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700"],
    source="general knowledge",
    evidence="inferred",
    program="""
        O1
        G90 G99 G82 X10 Z-5 R2 P800 F100
        G80
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 0, "Y": 0, "Z": 20}},
    moves="""
        R X10
        R Z2
        F Z-5
        W 0.8
        R Z2
    """,
)

case(
    "G73 goes back by 5114 between its pecks (M309)",
    control=["fanuc-16i", "fanuc-30i"],
    source="30iM p.73; general knowledge",
    evidence="secondary",
    program="""
        O1
        G90 G98 G73 X10 Z-25 R2 Q10 F100
        G80
        M30
    """,
    params={"5114": 0.5}, replace=MM,
    setup=MILL | {"start": {"X": 0, "Y": 0, "Z": 20}},
    moves="""
        R X10
        R Z2
        F Z-8
        R Z-7.5
        F Z-18
        R Z-17.5
        F Z-25
        R Z20
    """,
)

case(
    "G83 with a Q larger than the hole makes one peck (M310)",
    control=["fanuc-16i", "fanuc-30i"],
    source="30iM p.73",
    evidence="secondary",
    program="""
        O1
        G90 G99 G83 X10 Z-4 R2 Q10 F100
        G80
        M30
    """,
    params={"5115": 1}, replace=MM,
    setup=MILL | {"start": {"X": 0, "Y": 0, "Z": 20}},
    moves="""
        R X10
        R Z2
        F Z-4
        R Z2
    """,
)

case(
    "G85 feeds back to R (M312)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700", "hnc-21m"],
    source="general knowledge",
    evidence="inferred",
    program="""
        O1
        G90 G98 G85 X10 Z-5 R2 F100
        G80
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 0, "Y": 0, "Z": 20}},
    moves="""
        R X10
        R Z2
        F Z-5
        F Z2
        R Z20
    """,
)

case(
    "G89 dwells at the bottom and feeds back (M314)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700"],
    source="general knowledge",
    evidence="inferred",
    program="""
        O1
        G90 G99 G89 X10 Z-5 R2 P500 F100
        G80
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 0, "Y": 0, "Z": 20}},
    moves="""
        R X10
        R Z2
        F Z-5
        W 0.5
        F Z2
    """,
)

case(
    "G87 bores from below, with the tool shifted past the hole (M316)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge",
    evidence="inferred",
    program="""
        O1
        G90 G98 G87 X10 Z-20 R-35 Q3 F80
        G80
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 0, "Y": 0, "Z": 20}},
    moves="""
        R X10
        R X13
        R Z-35
        R X10
        F Z-20
        R X13
        R Z20
        R X10
    """,
)

case(
    "G84 goes in and out at the feed (M317)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700"],
    source="general knowledge",
    evidence="inferred",
    program="""
        O1
        M03 S500
        G90 G99 G84 X10 Z-10 R5 F500
        G80
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 0, "Y": 0, "Z": 20}},
    moves="""
        R X10
        R Z5
        F Z-10
        F Z5
    """,
)

case(
    "a block without a position drills nothing (M318)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700"],
    source="general knowledge",
    evidence="inferred",
    program="""
        O1
        G90 G99 G81 X10 Z-5 R2 F100
        M08
        F150
        X20
        G80
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 0, "Y": 0, "Z": 20}},
    moves="""
        R X10
        R Z2
        F Z-5
        R Z2
        R X20
        R Z2
        F Z-5
        R Z2
    """,
)

case(
    "G01 ends a cycle (M319)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700"],
    source="M7 p.45 and p.52",
    evidence="maker's manual",
    program="""
        O1
        G90 G99 G81 X10 Z-5 R2 F100
        G01 X20
        X30
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 0, "Y": 0, "Z": 20}},
    moves="""
        R X10
        R Z2
        F Z-5
        R Z2
        F X20
        F X30
    """,
)

case(
    "G83 of the HNC-21 takes a negative Q and the clearance from K (M324)",
    pins="peck_words cycle_words_not_computed",
    control="hnc-21m",
    source="general knowledge",
    evidence="inferred",
    program="""
        %1
        G90 G99 G83 X10 Z-25 R2 Q-10 K1 F100
        G80
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 0, "Y": 0, "Z": 20}},
    moves="""
        R X10
        R Z2
        F Z-8
        R Z2
        R Z-7
        F Z-18
        R Z2
        R Z-17
        F Z-25
        R Z2
    """,
)

case(
    "G73 of the HNC-21 goes back by K (M325)",
    control="hnc-21m",
    source="general knowledge",
    evidence="inferred",
    program="""
        %1
        G90 G98 G73 X10 Z-15 R2 Q-10 K2 F100
        G80
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 0, "Y": 0, "Z": 20}},
    moves="""
        R X10
        R Z2
        F Z-8
        R Z-6
        F Z-15
        R Z20
    """,
)

case(
    "a cycle with L0 alarms on the 980MDi (M326)",
    pins="cycle_repeats",
    control="gsk-980mdi",
    source="MDib 0203",
    evidence="maker's manual",
    program="""
        O1
        G90 G99 G81 X10 Z-5 R2 F100 L0
        M30
    """,
    replace=MM,
    setup=MILL,
    alarm="cycle-repeats",
    number="0203",
    at="O1", word="L0",
)

case(
    "G53 in a cycle alarms on the 980MDi (M329)",
    control="gsk-980mdi",
    source="MDib 0165",
    evidence="maker's manual",
    program="""
        O1
        G90 G99 G81 X10 Z-5 R2 F100
        G53 Z0
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 0, "Y": 0, "Z": 20}},
    moves="""
        R X10
        R Z2
        F Z-5
        R Z2
    """,
    alarm="machine-move-in-cycle",
    number="0165",
    at="O1", word="G53",
)

case(
    "the positions of a subprogram called in cycle mode are drilled (M330)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700"],
    source="general knowledge",
    evidence="inferred",
    program="""
        O1
        G90 G99 G81 X10 Z-5 R2 F100
        M98 P2
        G80
        M30
        O2
        X20
        Y10
        M99
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 0, "Y": 0, "Z": 20}},
    moves="""
        R X10
        R Z2
        F Z-5
        R Z2
        R X20
        R Z2
        F Z-5
        R Z2
        R Y10
        R Z2
        F Z-5
        R Z2
    """,
)
