"""Radius compensation: worked examples. `centre` begins with the move before the offset starts."""

from conformance import case

MM = {"whole_numbers": "millimetres"}  # whole numbers are millimetres, on every control
MILL = {"machine": "mill"}

case(
    "a negative radius offset puts the tool on the other side (M212)",
    control=["fanuc-16i", "fanuc-0i-f", "mitsubishi-m700"],
    source="source 003, G41 and G42; M7 p.191",
    evidence="secondary",
    program="""
        O1
        G90 G00 X40 Y0
        G41 G01 X20 Y20 D1 F100
        Y60
        X60
        Y20
        X20
        G40 X40 Y40
        M30
    """,
    replace=MM,
    setup=MILL | {"radius_offsets": {1: -5}},
    centre="X40 Y0 | X25 Y20 | X25 Y55 | X55 Y55 | X55 Y25 | X20 Y25 | X40 Y40",
)

case(
    "an acute outer corner is cut by a line one radius beyond it (M214)",
    control=["fanuc-16i", "fanuc-0i-f"],
    source="general knowledge",
    evidence="inferred",
    program="""
        O1
        G90 G00 X-20 Y0
        G41 G01 X0 Y0 D1 F100
        X50
        X0 Y-50
        G40 X-20
        M30
    """,
    replace=MM,
    setup=MILL | {"radius_offsets": {1: 5}},
    centre="X-20 Y0 | X0 Y5 | X55 Y5 | X57.0711 Y0 | X3.5355 Y-53.5355 | X-20 Y-50",
)

case(
    "an outer corner of 135 degrees is cut where the two parallels meet (M215)",
    control=["fanuc-16i", "fanuc-0i-f", "mitsubishi-m700"],
    source="M7 p.191",
    evidence="secondary",
    program="""
        O1
        G90 G00 X-20 Y0
        G41 G01 X0 Y0 D1 F100
        X50
        X100 Y-50
        G40 X120
        M30
    """,
    replace=MM,
    setup=MILL | {"radius_offsets": {1: 5}},
    centre="X-20 Y0 | X0 Y5 | X52.0711 Y5 | X103.5355 Y-46.4645 | X120 Y-50",
)

case(
    "an arc in the block of G40 alarms (M217)",
    pins="max_feed",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700", "gsk-980mdi", "gsk-988t"],
    source="15iM p.402; M7 p.194; MDib 0259; Talm 252",
    evidence="maker's manual",
    program="""
        O1
        G90 G00 X0 Y0
        G41 G01 X20 Y0 D1 F100
        X40
        G40 G02 X60 Y20 R20
        M30
    """,
    replace=MM,
    setup=MILL | {"radius_offsets": {1: 5}},
    alarm="arc-at-offset-end",
    number={
        "fanuc-16i": "034",
        "fanuc-30i": "PS0034",
        "mitsubishi-m700": "P151",
        "gsk-980mdi": "0259",
        "gsk-988t": "252",
    },
    at="O1", word="G02",
)

case(
    "a plane change while the radius offset is on alarms (M218)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700", "gsk-980mdi", "gsk-988t"],
    source="ALM PS0037; MZ 825, paired with P112; MDib 0030; Talm 253",
    evidence="maker's manual",
    program="""
        O1
        G17 G90 G00 X0 Y0
        G41 G01 X20 Y0 D1 F100
        G18 X40 Z5
        M30
    """,
    replace=MM,
    setup=MILL | {"radius_offsets": {1: 5}},
    alarm="plane-change-in-offset",
    number={
        "fanuc-16i": "037",
        "fanuc-30i": "PS0037",
        "mitsubishi-m700": "P112",
        "gsk-980mdi": "0030",
        "gsk-988t": "253",
    },
    at="O1", word="G18",
)

case(
    "two blocks without a move leave the offset on the normal of the last one on the 16i (M220)",
    control="fanuc-16i",
    source="source 003, note a",
    evidence="source document",
    program="""
        O1
        G90 G00 X0 Y0
        G41 G01 X20 Y0 D1 F100
        Y40
        G04 P100
        M08
        X60
        G40 Y60
        M30
    """,
    replace=MM,
    setup=MILL | {"radius_offsets": {1: 5}},
    centre="X0 Y0 | X15 Y0 | X15 Y40 | X20 Y45 | X60 Y45 | X60 Y60",
)

case(
    "a slot narrower than the tool alarms (M222)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700", "gsk-980mdi", "gsk-988t"],
    source="16iLB p.208; 30iM p.238; MZ 837, paired with P153; MDib 0260; Talm 256",
    evidence="secondary",
    program="""
        O1
        G90 G00 X0 Y0
        G42 G01 X20 Y0 D1 F100
        Y30
        X30
        Y0
        G40 X50
        M30
    """,
    replace=MM,
    setup=MILL | {"radius_offsets": {1: 6}},
    alarm="offset-interference",
    number={
        "fanuc-16i": "041",
        "fanuc-30i": "PS0041",
        "mitsubishi-m700": "P153",
        "gsk-980mdi": "0260",
        "gsk-988t": "256",
    },
    at="O1", word="X30",
)

case(
    "a mirror image while the radius offset is on alarms on the 980MDi (M225)",
    control="gsk-980mdi",
    source="MDib 0155",
    evidence="maker's manual",
    program="""
        O1
        G90 G00 X0 Y0
        G41 G01 X20 Y0 D1 F100
        G51.1 X0
        M30
    """,
    replace=MM,
    setup=MILL | {"radius_offsets": {1: 5}},
    alarm="mirror-in-offset",
    number="0155",
    at="O1", word="G51.1",
)

case(
    "a GOTO while the radius offset is on alarms on the 980MDi (M226)",
    pins="refuses:jump-in-offset",
    control="gsk-980mdi",
    source="MDib 0100",
    evidence="maker's manual",
    program="""
        O1
        G90 G00 X0 Y0
        G41 G01 X20 Y0 D1 F100
        GOTO 100
        N100 X40
        M30
    """,
    replace=MM,
    setup=MILL | {"radius_offsets": {1: 5}},
    alarm="jump-in-offset",
    number="0100", word="GOTO",
)

case(
    "a fixed cycle while the radius offset is on alarms on the M700 (M227)",
    control="mitsubishi-m700",
    source="MZ 901, paired with P155",
    evidence="secondary",
    program="""
        O1
        G90 G00 X0 Y0
        G41 G01 X20 Y0 D1 F100
        G81 X40 Z-5 R2
        M30
    """,
    replace=MM,
    setup=MILL | {"radius_offsets": {1: 5}},
    alarm="cycle-in-offset",
    number="P155",
    at="O1", word="G81",
)

case(
    "a radius offset number that does not exist alarms (M228)",
    control=["mitsubishi-m700", "fanuc-16i"],
    source="MZ 839, paired with P170; ALM PS0030",
    evidence="secondary",
    program="""
        O1
        G90 G00 X0 Y0
        G41 G01 X20 Y0 D999 F100
        M30
    """,
    replace=MM,
    setup=MILL,
    alarm="radius-offset-number",
    number={"mitsubishi-m700": "P170", "fanuc-16i": "030"},
    at="O1", word="D999",
)
