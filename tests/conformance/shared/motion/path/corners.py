"""Corners: chamfers and roundings."""

from conformance import case

MM = {"whole_numbers": "millimetres"}  # whole numbers are millimetres, on every control
MILL = {"machine": "mill"}
LATHE_A = {"machine": "lathe-a"}

case(
    ",C cuts the corner of two lines (M501)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700"],
    source="general knowledge",
    evidence="inferred",
    program="""
        O1
        G90 G01 X50 ,C5 F100
        Y50
        M30
    """,
    replace=MM,
    setup=MILL,
    moves="""
        F X45 Y0
        F X50 Y5
        F Y50
    """,
)

case(
    ",R rounds a corner of 60 degrees (M503)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700"],
    source="general knowledge",
    evidence="inferred",
    program="""
        O1
        G90 G01 X50 ,R5 F100
        X25 Y43.3013
        M30
    """,
    replace=MM,
    setup=MILL,
    moves="""
        F X41.3397 Y0
        CCW X45.6699 Y7.5 C X41.3397 Y5
        F X25 Y43.3013
    """,
)

case(
    "a corner longer than its line alarms (M504)",
    pins="chamfer_words",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700", "gsk-980mdi", "gsk-988t"],
    source="ALM PS0055; MZ 913, paired with P383; MDib 0271; Talm 275",
    evidence="secondary",
    program="""
        O1
        G90 G01 X3 ,C5 F100
        Y50
        M30
    """,
    replace=MM,
    setup=MILL,
    alarm="corner-too-short",
    number={
        "fanuc-16i": "055",
        "fanuc-30i": "PS0055",
        "mitsubishi-m700": "P383",
        "gsk-980mdi": "0271",
        "gsk-988t": "275",
    },
    at="O1", word=",C5",
)

case(
    "a corner with no move after it alarms (M505)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700"],
    source="ALM PS0051; MZ 912, paired with P382",
    evidence="secondary",
    program="""
        O1
        G90 G01 X50 ,C5 F100
        M08
        M30
    """,
    replace=MM,
    setup=MILL,
    alarm="corner-no-move",
    number={"fanuc-16i": "051", "fanuc-30i": "PS0051", "mitsubishi-m700": "P382"},
    at="O1", word="M08",
)

case(
    "C and R without a comma are corners on a FANUC lathe (M507)",
    control="fanuc-0i-d",
    source="3405#4 CCR: general knowledge",
    evidence="inferred",
    program="""
        O1
        G01 Z-20 R3 F0.2
        X50 C2
        Z-40
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 20, "Z": 0}},
    moves="""
        F Z-17
        CW X26 Z-20 C X26 Z-17
        F X46 Z-20
        F X50 Z-22
        F Z-40
    """,
)

case(
    "L is the line of a corner and D its radius on the 980TDi (M508)",
    pins="chamfer_words chamfer_length",
    control="gsk-980tdi",
    source="TDi 11; TDipar 181",
    evidence="maker's manual",
    program="""
        O1
        G01 Z-20 D3 F0.2
        X50 L2.8284
        Z-40
        M30
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 20, "Z": 0}},
    moves="""
        F Z-17
        CW X26 Z-20 C X26 Z-17
        F X46 Z-20
        F X50 Z-22
        F Z-40
    """,
)
