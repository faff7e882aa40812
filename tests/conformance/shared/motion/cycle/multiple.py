"""The multiple cycles G70 to G75."""

from conformance import case

MM = {"whole_numbers": "millimetres"}  # whole numbers are millimetres, on every control
LATHE_A = {"machine": "lathe-a"}

case(
    "G70 follows the profile that G71 roughed, and goes back (M430)",
    control="gsk-980tdi",
    source="TDi 23.4; TA 11",
    evidence="maker's manual",
    program="""
        O1
        G71 U15 R1 F0.2
        G71 P10 Q20 U1 W0.5
        N10 G0 X20
        N12 G1 Z-20 F0.1
        N14 X40 Z-40
        N20 X50
        G70 P10 Q20
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 50, "Z": 2}},
    moves="""
        R X51 Z2.5
        R X21
        F Z-19.5
        F X41 Z-39.5
        F X51
        R X50 Z2
        R X20
        F Z-20
        F X40 Z-40
        F X50
        R X50 Z2
    """,
)

case(
    "G72 roughs in levels along Z (M431)",
    control="gsk-980tdi",
    source="TDi 23.2",
    evidence="secondary",
    program="""
        O1
        G72 W4 R1 F0.2
        G72 P10 Q20 U0 W0
        N10 G0 Z-10
        N12 G1 X40
        N14 X20 Z0
        N20 Z2
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 60, "Z": 2}},
    moves="""
        R X60 Z2
        R Z-2
        F X24
        F X26 Z-1
        R X60
        R Z-6
        F X32
        F X34 Z-5
        R X60
        R Z-10
        F X40
        F X20 Z0
        F Z2
        R X60 Z2
    """,
)

case(
    "G73 roughs in three passes side by side (M432)",
    control=["gsk-980tdi", "gsk-988ta", "fanuc-0i-d"],
    source="TDi 23.3; TA 10",
    evidence="maker's manual",
    program="""
        O1
        G73 U4 W2 R3
        G73 P10 Q20 U1 W0.5 F0.3
        N10 G0 X40 Z0
        N12 G1 Z-20
        N20 X60 Z-30
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 100, "Z": 10}},
    moves="""
        R X109 Z12.5
        R X49 Z2.5
        F Z-17.5
        F X69 Z-27.5
        R X105 Z11.5
        R X45 Z1.5
        F Z-18.5
        F X65 Z-28.5
        R X101 Z10.5
        R X41 Z0.5
        F Z-19.5
        F X61 Z-29.5
        R X100 Z10
    """,
)

case(
    "G73 with R1 makes two cuts on the 980TDi (M433)",
    control="gsk-980tdi",
    source="TDi 23.3",
    evidence="maker's manual",
    program="""
        O1
        G73 U4 W2 R1
        G73 P10 Q20 U1 W0.5 F0.3
        N10 G0 X40 Z0
        N20 G1 X60 Z-20
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 100, "Z": 10}},
    moves="""
        R X109 Z12.5
        R X49 Z2.5
        F X69 Z-17.5
        R X101 Z10.5
        R X41 Z0.5
        F X61 Z-19.5
        R X100 Z10
    """,
)

case(
    "G75 pecks along X, and the last peck and column take the rest (M435)",
    control="gsk-980tdi",
    source="TDi 23.6, O0008",
    evidence="maker's manual",
    program="""
        O0008
        G75 R0.5 F150
        G75 X105 Z-28 P80000 Q30000
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"increment": 0.0001, "start": {"X": 125, "Z": -24}},
    moves="""
        F X117
        R X118
        F X109
        R X110
        F X105
        R X125
        R Z-27
        F X117
        R X118
        F X109
        R X110
        F X105
        R X125
        R Z-28
        F X117
        R X118
        F X109
        R X110
        F X105
        R X125
        R Z-24
    """,
)

case(
    "G71 with a sequence number that does not exist alarms (M438)",
    pins="point_addresses",
    control=["gsk-988t", "fanuc-16i", "fanuc-30i"],
    source="Talm 134; ALM PS0063",
    evidence="maker's manual",
    program="""
        O1
        G71 U5 R1 F0.2
        G71 P10 Q99 U1 W0.5
        N10 G0 X20
        N20 G1 X50 Z-30
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 50, "Z": 2}},
    alarm="pq-not-found",
    number={"gsk-988t": "134", "fanuc-16i": "063", "fanuc-30i": "PS0063"}, word="Q99",
)

case(
    "a call inside the profile of G71 alarms on the 988T (M441)",
    control="gsk-988t",
    source="Talm 131",
    evidence="maker's manual",
    program="""
        O1
        G71 U5 R1 F0.2
        G71 P10 Q20 U1 W0.5
        N10 G0 X20
        N12 M98 P2
        N20 G1 X50 Z-30
        M30
        O2
        M99
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 50, "Z": 2}},
    alarm="call-in-profile",
    number="131", word="M98",
)

case(
    "a profile that turns back in Z alarms (M443)",
    control="fanuc-30i",
    source="ALM PS0064",
    evidence="secondary",
    program="""
        O1
        G71 U5 R1 F0.2
        G71 P10 Q20 U1 W0.5
        N10 G0 X20
        N12 G1 Z-20
        N14 X30 Z-15
        N20 X50 Z-40
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 50, "Z": 2}},
    alarm="profile-not-monotone",
    number="PS0064", word="Z-15",
)

case(
    "a profile that turns back in Z alarms on the 988T where 5102#1 says so (M443)",
    control="gsk-988t",
    source="Talm 138",
    evidence="maker's manual",
    program="""
        O1
        G71 U5 R1 F0.2
        G71 P10 Q20 U1 W0.5
        N10 G0 X20
        N12 G1 Z-20
        N14 X30 Z-15
        N20 X50 Z-40
        M30
    """,
    params={"5102#1": 1}, replace=MM,
    setup=LATHE_A | {"start": {"X": 50, "Z": 2}},
    alarm="profile-not-monotone",
    number="138", word="Z-15",
)

case(
    "G75 without an X alarms on the 988T (M445)",
    control="gsk-988t",
    source="Talm 154",
    evidence="maker's manual",
    program="""
        O1
        G75 R0.5
        G75 Z-10 P2 Q2 F50
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 50, "Z": 2}},
    alarm="groove-axis",
    number="154",
    at="O1", word="G75",
)
