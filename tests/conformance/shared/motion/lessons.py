"""The programs of the lessons, whole; they go where their explanations say."""

from conformance import case

MM = {"whole_numbers": "millimetres"}  # whole numbers are millimetres, on every control
MILL = {"machine": "mill"}
LATHE_A = {"machine": "lathe-a"}

case(
    "the beginner's program of the lesson alarms at an arc that is no circle (M017)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 003, beginner's program; 16TC p.67; ALM PS0020",
    evidence="maker's manual",
    program="""
        O1
        G92 X0 Y0 Z0
        G00 X100 Y100 Z10
        G01 X50 Y50 Z5 F100
        G00 X100 Y100 Z10
        G02 X50 Y50 Z5 I25 J0 F100
        M30
    """,
    params={"3410": 0.01}, replace=MM,
    setup=MILL,
    moves="""
        R X100 Y100 Z10
        F X50 Y50 Z5
        R X100 Y100 Z10
    """,
    alarm="radius-tolerance",
    number={"fanuc-16i": "020", "fanuc-30i": "PS0020"},
    at="O1", word="X50",
)

case(
    "the radius offset of the contour O10 runs 3 mm beside it (M019)",
    control=["fanuc-0i-f", "fanuc-16i"],
    source="source 003, O10; M7 p.188, start-up type A",
    evidence="source document",
    program="""
        O1
        G90 G0 X0 Y0
        G41 G91 G01 X30 Y-5 D01 F50
        Y5
        G02 X20 I10
        X-10 I-5
        G03 X-10 I-5
        G0 Y-5
        G40 X-30 Y5
        M30
    """,
    replace=MM,
    setup=MILL | {"radius_offsets": {1: 3}},
    centre="X0 Y0 | X27 Y-5 | X27 Y0 | X53 Y0 | X37 Y0 | X33 Y0 | X33 Y-5 | X0 Y0",
)

case(
    "an inner arc of radius 5 is too small for a tool of radius 6 (M020)",
    pins="minus_addresses g_codes round_words",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700", "gsk-980mdi"],
    source="source 003, O10; MDib 0256; 041 and P153: general knowledge",
    evidence="secondary",
    program="""
        O1
        G90 G0 X0 Y0
        G41 G91 G01 X30 Y-5 D01 F50
        Y5
        G02 X20 I10
        X-10 I-5
        G03 X-10 I-5
        G0 Y-5
        G40 X-30 Y5
        M30
    """,
    replace=MM,
    setup=MILL | {"radius_offsets": {1: 6}},
    alarm="offset-arc-too-small",
    number={
        "fanuc-16i": "041",
        "fanuc-30i": "PS0041",
        "mitsubishi-m700": "P153",
        "gsk-980mdi": "0256",
    },
    at="O1", word="I-5",
)

case(
    "the typical program of the lesson moves where its explanation says (M021)",
    control=["fanuc-0i-f", "fanuc-16i"],
    source="source 003, typical program",
    evidence="source document",
    program="""
        O1
        N100 G90 G21 G17 G94 G40
        N110 T1 M06 M03 S500
        N120 G43 H01 Z5.
        N130 X10. Y10.
        N140 G01 Z-5. F200
        N150 G01 X20. Y20. F500
        N160 G01 Z-15. F300
        N180 G00 X0. Y0. Z50.
        N190 M30
    """,
    params={"3402#0": 0}, replace=MM,
    setup=MILL | {"length_offsets": {1: 0}},
    moves="""
        R Z5
        R X10 Y10
        F Z-5
        F X20 Y20
        F Z-15
        R X0 Y0 Z50
    """,
)

case(
    "the five passes of method 1 lower the tool by 4 mm of diameter each (M023)",
    pins="minus_addresses g_codes program_word max_feed round_words",
    control="gsk-928te",
    source="source 001, method 1",
    evidence="source document",
    program="""
        O1
        N0010 G00 X100 Z50
        N0020 M03 S01
        N0030 G0 X50 Z15 F500
        N0040 M98 P0060 L5
        N0050 M97 P0130
        N0060 G0 U-4
        N0070 G01 Z-10 F80
        N0080 U20 Z-25
        N0090 Z-35
        N0100 G0 U2 Z1
        N0110 U-22
        N0120 M99
        N0130 G0 X100 Z50
        N0140 M05
        N0140 M02
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 120, "Z": 80}},
    moves="""
        R X100 Z50
        R X50 Z15
        R X46 Z15
        F X46 Z-10
        F X66 Z-25
        F X66 Z-35
        R X68 Z1
        R X46 Z1
        R X42 Z1
        F X42 Z-10
        F X62 Z-25
        F X62 Z-35
        R X64 Z1
        R X42 Z1
        R X38 Z1
        F X38 Z-10
        F X58 Z-25
        F X58 Z-35
        R X60 Z1
        R X38 Z1
        R X34 Z1
        F X34 Z-10
        F X54 Z-25
        F X54 Z-35
        R X56 Z1
        R X34 Z1
        R X30 Z1
        F X30 Z-10
        F X50 Z-25
        F X50 Z-35
        R X52 Z1
        R X30 Z1
        R X100 Z50
    """,
)

case(
    "the five passes of method 2 lower the tool by 4 mm of diameter each (M024)",
    control="gsk-928te",
    source="source 001, method 2, P0060 corrected",
    evidence="source document",
    program="""
        O1
        N0010 G00 X100 Z50
        N0020 M03 S01
        N0030 G0 X66 Z15 F500
        N0040 M98 P0080 L5
        N0050 G0 X100 Z50
        N0060 M05
        N0070 M02
        N0080 G0 U-4
        N0090 G01 Z-10 F80
        N0100 U20 Z-25
        N0110 Z-35
        N0120 G0 U2 Z1
        N0130 U-22
        N0140 M99
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 120, "Z": 80}},
    moves="""
        R X100 Z50
        R X66 Z15
        R X62 Z15
        F X62 Z-10
        F X82 Z-25
        F X82 Z-35
        R X84 Z1
        R X62 Z1
        R X58 Z1
        F X58 Z-10
        F X78 Z-25
        F X78 Z-35
        R X80 Z1
        R X58 Z1
        R X54 Z1
        F X54 Z-10
        F X74 Z-25
        F X74 Z-35
        R X76 Z1
        R X54 Z1
        R X50 Z1
        F X50 Z-10
        F X70 Z-25
        F X70 Z-35
        R X72 Z1
        R X50 Z1
        R X46 Z1
        F X46 Z-10
        F X66 Z-25
        F X66 Z-35
        R X68 Z1
        R X46 Z1
        R X100 Z50
    """,
)

case(
    "method 2 as printed comes to M02 at once (M025)",
    control="gsk-928te",
    source="source 001, method 2 as printed",
    evidence="source document",
    program="""
        O1
        N0010 G00 X100 Z50
        N0020 M03 S01
        N0030 G0 X66 Z15 F500
        N0040 M98 P0060 L5
        N0050 G0 X100 Z50
        N0060 M05
        N0070 M02
        N0080 G0 U-4
        N0140 M99
    """,
    replace=MM,
    setup=LATHE_A | {"start": {"X": 120, "Z": 80}},
    moves="""
        R X100 Z50
        R X66 Z15
    """,
)
