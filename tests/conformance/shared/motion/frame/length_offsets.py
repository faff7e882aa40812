"""Length offsets."""

from conformance import case

MM = {"whole_numbers": "millimetres"}  # whole numbers are millimetres, on every control
MILL = {"machine": "mill"}

case(
    "G44 takes the length offset off (M202)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700"],
    source="SZGH p.66; general knowledge",
    evidence="secondary",
    program="""
        O1
        G90 G44 G00 Z100 H1
        M30
    """,
    replace=MM,
    setup=MILL | {"length_offsets": {1: 20}},
    moves="R Z100",
    final_machine="Z80",
)

case(
    "H0 ends the length offset (M203)",
    control=["fanuc-16i", "fanuc-30i"],
    source="SZGH p.66",
    evidence="secondary",
    program="""
        O1
        G90 G43 G00 Z100 H1
        Z50 H0
        M30
    """,
    replace=MM,
    setup=MILL | {"length_offsets": {1: 20}},
    moves="""
        R Z100
        R Z50
    """,
    final_machine="Z50",
)

case(
    "G49 ends the length offset (M204)",
    control=["fanuc-16i", "fanuc-30i", "hnc-21m"],
    source="SZGH p.66",
    evidence="secondary",
    program="""
        O1
        G90 G43 G00 Z100 H1
        G49 Z100
        M30
    """,
    replace=MM,
    setup=MILL | {"length_offsets": {1: 20}},
    moves="""
        R Z100
        R Z100
    """,
    final_machine="Z100",
)

case(
    "a length offset number that does not exist alarms (M206)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700", "gsk-980mdi"],
    source="ALM PS0030; MZ 839, paired with P170; MDib 0016",
    evidence="secondary",
    program="""
        O1
        G43 G00 Z10 H999
        M30
    """,
    replace=MM,
    setup=MILL | {"length_offsets": {1: 20}},
    alarm="offset-number",
    number={
        "fanuc-16i": "030",
        "fanuc-30i": "PS0030",
        "mitsubishi-m700": "P170",
        "gsk-980mdi": "0016",
    },
    at="O1", word="H999",
)

case(
    "a length offset in an arc block alarms on the 980MDi (M207)",
    control="gsk-980mdi",
    source="MDib 0042",
    evidence="maker's manual",
    program="""
        O1
        G02 X10 R5 F100
        G43 H1 X0 R5
        M30
    """,
    replace=MM,
    setup=MILL | {"length_offsets": {1: 20}},
    moves="CW X10 Y0 C X5 Y0",
    alarm="length-with-motion",
    number="0042",
    at="O1", word="G43",
)
