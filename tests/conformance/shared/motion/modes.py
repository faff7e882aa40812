"""Modes that calls leave in force, and codes that do not go together."""

from conformance import case

MM = {"whole_numbers": "millimetres"}  # whole numbers are millimetres, on every control
MILL = {"machine": "mill"}
LATHE_A = {"machine": "lathe-a"}

case(
    "an unknown G code alarms (M056)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700", "gsk-988t", "gsk-980mdi"],
    source="ALM PS0010; SK P34; Talm 009; MDib 0002",
    evidence="maker's manual",
    program="""
        O1
        G111 X1
        M30
    """,
    replace=MM,
    setup=MILL,
    alarm="g-code-not-available",
    number={
        "fanuc-16i": "010",
        "fanuc-30i": "PS0010",
        "mitsubishi-m700": "P34",
        "gsk-988t": "009",
        "gsk-980mdi": "0002",
    },
    at="O1", word="G111",
)

case(
    "G91 of a subprogram holds in the main program (M521)",
    pins="program_word",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700", "gsk-980mdi", "hnc-21m"],
    source="source 003, note 5 (1)",
    evidence="source document",
    program="""
        O1
        G90 G00 X10
        M98 P2
        X10
        M30
        O2
        G91 X5
        M99
    """,
    replace=MM,
    setup=MILL,
    moves="""
        R X10
        R X15
        R X25
    """,
)

case(
    "G01 of a subprogram holds in the main program (M522)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700", "gsk-980mdi"],
    source="source 003, note 5 (1)",
    evidence="source document",
    program="""
        O1
        G90 G00 X10 F200
        M98 P2
        Y10
        M30
        O2
        G01 X20
        M99
    """,
    replace=MM,
    setup=MILL,
    moves="""
        R X10
        F X20
        F Y10
    """,
)

case(
    "the moving words of an M98 block come before those of the subprogram (M524)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700", "gsk-988ta"],
    source="source 000, M98; PMI39 (b)",
    evidence="source document",
    program="""
        O1
        G90 G00 X10
        X20 M98 P2
        X30
        M30
        O2
        Y5
        M99
    """,
    replace=MM,
    setup=MILL,
    moves="""
        R X10
        R X20
        R Y5
        R X30
    """,
)

case(
    "G52 of a subprogram holds in the main program (M526)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 003, note 5 (1)",
    evidence="source document",
    program="""
        O1
        G90 G00 X0 Y0
        M98 P2
        X0 Y0
        G52 X0 Y0
        M30
        O2
        G52 X50 Y20
        M99
    """,
    replace=MM,
    setup=MILL,
    moves="""
        R X0 Y0
        R X0 Y0
    """,
    final_machine="X50 Y20",
)

case(
    "M30 of a subprogram leaves the rest of the main program undone (M527)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700", "gsk-988ta"],
    source="reset at M30: TApar 3402#6; general knowledge",
    evidence="inferred",
    program="""
        O1
        G90 G00 X10
        M98 P2
        X99
        M30
        O2
        X20
        M30
    """,
    replace=MM,
    setup=MILL,
    moves="""
        R X10
        R X20
    """,
)

case(
    "two G codes of one group alarm on the 988T while 3403#6 is 1 (M532)",
    control="gsk-988t",
    source="Talm 010; TApar 3403#6",
    evidence="maker's manual",
    program="""
        O1
        G0 G1 X10 F100
        M30
    """,
    params={"3403#6": 1}, replace=MM,
    setup=LATHE_A,
    alarm="address-given-twice",
    number="010",
    at="O1", word="G1",
)

case(
    "of two G codes of one group the later one counts while 3403#6 is 0 (M533)",
    control=["gsk-988ta", "fanuc-0i-f"],
    source="TApar 3403#6",
    evidence="maker's manual",
    program="""
        O1
        G0 G1 X10 F100
        M30
    """,
    params={"3403#6": 0}, replace=MM,
    setup=LATHE_A | {"start": {"X": 20, "Z": 0}},
    moves="F X10",
)

case(
    "G28 and M99 in one block alarm on the 988T (M534)",
    control="gsk-988t",
    source="Talm 030",
    evidence="maker's manual",
    program="""
        O1
        M98 P2
        M30
        O2
        G28 U0 M99
    """,
    replace=MM,
    setup=LATHE_A,
    alarm="illegal-word-with-return",
    number="030", word="G28",
)

case(
    "M99 P while the radius offset is on alarms on the 980MDi (M537)",
    control="gsk-980mdi",
    source="MDib 0099",
    evidence="maker's manual",
    program="""
        O1
        G41 G01 X10 D1 F100
        M98 P2
        N50 X20
        M30
        O2
        X15
        M99 P50
    """,
    replace=MM,
    setup=MILL | {"radius_offsets": {1: 3}},
    alarm="return-in-offset",
    number="0099", word="P50",
)

case(
    "G27 and M30 in one block alarm on the M700 (M538)",
    control="mitsubishi-m700",
    source="MZ 920, paired with P435",
    evidence="secondary",
    program="""
        O1
        G27 X0 M30
    """,
    replace=MM,
    setup=MILL,
    alarm="reference-with-end",
    number="P435",
    at="O1", word="M30",
)
case(
    "a kind of feed that is said again leaves the feed in force",
    pins="feed_mode_change",
    control=["fanuc-0i-f", "mitsubishi-m800", "gsk-980mdi", "haas-ngc"],
    source="general knowledge",
    evidence="inferred",
    program="O1\nN10 G94 G1 X1. F100.\nN20 G94 X2.\nN30 M30",
    setup=MILL,
    moves="F X1\nF X2",
)
case(
    "on a lathe too",
    pins="feed_mode_change",
    control=["gsk-988ta", "gsk-988t", "gsk-980tdi"],
    source="general knowledge",
    evidence="inferred",
    program="O1\nN10 G98 G1 Z1. F100\nN20 G98 Z2.\nN30 M30",
    moves="F Z1\nF Z2",
)
case(
    "F beside G20 counts in inches",
    pins="feed_unit",
    control=["fanuc-0i-f", "mitsubishi-m800", "haas-ngc"],
    source="general knowledge",
    evidence="inferred",
    program="O1\nN10 G20\nN20 G21\nN30 G20 G1 X1. F10.\nN40 M30",
    setup=MILL,
    time=6,
)
case(
    "a work offset that is written moves the work system in force",
    pins="written_offset",
    control="fanuc-0i-f",
    source="general knowledge",
    evidence="inferred",
    program="O1\nN10 #5221=7.\nN20 G0 X1.\nN30 M30",
    setup=MILL,
    final_machine="X8",
)
