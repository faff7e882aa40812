"""Polar coordinates, rotation and mirror."""

from conformance import case

MM = {"whole_numbers": "millimetres"}  # whole numbers are millimetres, on every control
MILL = {"machine": "mill"}

case(
    "the third axis stays linear in polar mode (M133)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700"],
    source="16MC p.147; M7 p.96; source 003",
    evidence="secondary",
    program="""
        O1
        G17 G90 G16
        G00 X50 Y180 Z7
        G15 X1 Y2
        M30
    """,
    replace=MM,
    setup=MILL,
    moves="""
        R X-50 Y0 Z7
        R X1 Y2
    """,
)

case(
    "a cycle in polar mode drills on the bolt circle (M134)",
    control=["fanuc-16i", "fanuc-30i"],
    source="16MC p.147; M7 p.96; cycles: general knowledge",
    evidence="secondary",
    program="""
        O1
        G17 G90 G16
        G99 G81 X100 Y30 Z-20 R2 F200
        Y150
        Y270
        G15 G80
        M30
    """,
    replace=MM,
    setup=MILL | {"start": {"X": 0, "Y": 0, "Z": 10}},
    moves="""
        R X86.6025 Y50
        R Z2
        F Z-20
        R Z2
        R X-86.6025 Y50
        R Z2
        F Z-20
        R Z2
        R X0 Y-100
        R Z2
        F Z-20
        R Z2
    """,
)

case(
    "a plane change in polar mode alarms on the 980MDi (M136)",
    pins="refuses",
    control="gsk-980mdi",
    source="MDib 0186",
    evidence="maker's manual",
    program="""
        O1
        G17 G90 G16
        G18
        M30
    """,
    replace=MM,
    setup=MILL,
    alarm="plane-change-in-polar",
    number="0186",
    at="O1", word="G18",
)

case(
    "a change of the work system in polar mode alarms on the 980MDi (M137)",
    control="gsk-980mdi",
    source="MDib 0187",
    evidence="maker's manual",
    program="""
        O1
        G17 G90 G16
        G55
        M30
    """,
    replace=MM,
    setup=MILL,
    alarm="work-system-change-in-polar",
    number="0187",
    at="O1", word="G55",
)

case(
    "G28 in a mirror image alarms on the 980MDi (M539)",
    control="gsk-980mdi",
    source="MDib 0152",
    evidence="maker's manual",
    program="""
        O1
        G51.1 X0
        G28 Z0
        M30
    """,
    replace=MM,
    setup=MILL,
    alarm="reference-return-in-mirror",
    number="0152",
    at="O1", word="G28",
)

case(
    "a rotation of 400 degrees alarms on the 980MDi (M542)",
    pins="rotation_words",
    control="gsk-980mdi",
    source="MDib 0156",
    evidence="maker's manual",
    program="""
        O1
        G68 X0 Y0 R400
        M30
    """,
    replace=MM,
    setup=MILL,
    alarm="rotation-out-of-range",
    number="0156",
    at="O1", word="R400",
)
