"""Worked examples of motion: where the tool goes, and the alarms of moving blocks.

`centre` begins with the move before the radius offset starts.
"""

from conformance import case

MM = {"3401#0": 1}  # whole numbers are millimetres, on every control
MILL = {"machine": "mill"}
LATHE_A = {"machine": "lathe-a"}
LATHE_B = {"machine": "lathe-b"}

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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM,
    setup=MILL,
    moves="CW X0 Y0 C X40 Y0",
)

case(
    "G92 puts the origin where the tool then stands at the given place (M009)",
    control=["fanuc-0i-f", "fanuc-16i", "hnc-21m"],
    source="source 003, example 7",
    evidence="source document",
    program="""
        O1
        G92 X50 Y50 Z10
        G90 G00 X0 Y0 Z0
        M30
    """,
    params=MM,
    setup=MILL,
    moves="R X0 Y0 Z0",
    final_machine="X-50 Y-50 Z-10",
)

case(
    "G54 counts from its own zero, whatever stands in G55 (M011)",
    control=["fanuc-0i-f", "fanuc-16i", "hnc-21m"],
    source="source 003, example 8",
    evidence="source document",
    program="""
        O1
        G54 G01 X120 Y80 F100
        M30
    """,
    params=MM,
    setup=MILL | {"work_offsets": {"G55": {"X": 80, "Y": 40}}},
    moves="F X120 Y80",
    final_machine="X120 Y80",
)

case(
    "G52 shifts the origin, and G52 X0 Y0 takes it back (M013)",
    control=["fanuc-0i-f", "fanuc-16i", "hnc-21m"],
    source="source 003, example 9",
    evidence="source document",
    program="""
        O1
        N10 G54
        N20 G52 X80 Y40
        N30 G01 X40 Y40 F100
        N40 G52 X0 Y0
        N50 G01 X0 Y0
        M30
    """,
    params=MM,
    setup=MILL,
    moves="""
        F X40 Y40
        F X0 Y0
    """,
    final_machine="X0 Y0",
)

case(
    "in polar mode the angle counts from the axis under G90 and from the last one under G91 (M014)",
    control=["fanuc-0i-f", "fanuc-16i", "fanuc-30i", "mitsubishi-m700"],
    source="source 003, example 10; M7 p.98 (3)",
    evidence="source document",
    program="""
        O1
        N10 G17 G90 G16
        N20 G01 X100 Y60 F80
        N30 G91 Y60
        N40 G15
        M30
    """,
    params=MM,
    setup=MILL | {"start": {"X": 100, "Y": 0, "Z": 0}},
    moves="""
        F X50 Y86.6025
        F X-50 Y86.6025
    """,
)

case(
    "two G92 and G91 moves lead to the places of the lesson's figure (M015)",
    pins="g_codes",
    control=["fanuc-0i-f", "hnc-21m"],
    source="source 003, example of figure 3",
    evidence="source document",
    program="""
        O1
        G92 X0 Y0 Z0
        G91 G00 X15 Y-40
        G92 X0 Y0
        G00 X20 Y10
        X40 Y20
        M30
    """,
    params=MM,
    setup=MILL,
    moves="""
        R X15 Y-40 Z0
        R X20 Y10
        R X60 Y30
    """,
    final_machine="X75 Y-10",
)

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
    params=MM | {"3410": 0.01},
    setup=MILL,
    moves="""
        R X100 Y100 Z10
        F X50 Y50 Z5
        R X100 Y100 Z10
    """,
    alarm="radius-tolerance",
    number={"fanuc-16i": "020", "fanuc-30i": "PS0020"},
    at="O1",
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
    params=MM,
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
    params=MM,
    setup=MILL | {"radius_offsets": {1: 6}},
    alarm="offset-arc-too-small",
    number={
        "fanuc-16i": "041",
        "fanuc-30i": "PS0041",
        "mitsubishi-m700": "P153",
        "gsk-980mdi": "0256",
    },
    at="O1",
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
    params=MM | {"3402#0": 0},
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
    params=MM,
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
    params=MM,
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
    params=MM,
    setup=LATHE_A | {"start": {"X": 120, "Z": 80}},
    moves="""
        R X100 Z50
        R X66 Z15
    """,
)

case(
    "G91 moves by the value, and an axis that is not named stays (M030)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700", "hnc-21m"],
    source="source 003, G90 and G91",
    evidence="source document",
    program="""
        O1
        G91 G00 X10 Y5
        X10
        Y-20 Z3
        M30
    """,
    params=MM,
    setup=MILL,
    moves="""
        R X10 Y5
        R X20
        R Y-15 Z3
    """,
)

case(
    "of G90 and G91 in one block the later one counts for the whole block (M031)",
    control=["fanuc-16i", "fanuc-30i"],
    source="3403#6 AD2 as in TApar; general knowledge",
    evidence="inferred",
    program="""
        O1
        G90 G00 X5 G91 Y5
        M30
    """,
    params=MM,
    setup=MILL | {"start": {"X": 10, "Y": 10, "Z": 0}},
    moves="R X15 Y15",
)

case(
    "G91 at the end of a block counts for the whole block (M032)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700"],
    source="general knowledge",
    evidence="inferred",
    program="""
        O1
        G90 G00 X0 Y0
        X5 Y5 G91
        M30
    """,
    params=MM,
    setup=MILL | {"start": {"X": 10, "Y": 10, "Z": 0}},
    moves="""
        R X0 Y0
        R X5 Y5
    """,
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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM | {"3403#5": 0},
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
    params=MM | {"3403#5": 1},
    setup=MILL,
    alarm="no-radius",
    number={"fanuc-16i": "022", "fanuc-30i": "PS0022"},
    at="O1",
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
    params=MM | {"3410": 0.01},
    setup=MILL,
    moves="F X10 Y0",
    alarm="radius-tolerance",
    number={"fanuc-16i": "020", "fanuc-30i": "PS0020"},
    at="O1",
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
    params=MM | {"3410": 0.1},
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
    params=MM,
    setup=MILL,
    alarm="radius-too-small",
    number={"fanuc-16i": "020", "fanuc-30i": "PS0020", "mitsubishi-m700": "P71"},
    at="O1",
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
    params=MM,
    setup=MILL | {"start": {"X": 10, "Y": 10, "Z": 0}},
    moves="CCW X10 Y-10 C X10 Y0",
)

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
    params=MM,
    setup=MILL,
    moves="""
        F X10
        R X0
        F X5
    """,
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
    params=MM | {"3410": 0.1},
    setup=MILL,
    moves="F X10",
    alarm="radius-tolerance",
    number="P70",
    at="O1",
)

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
    params=MM,
    setup=MILL,
    alarm="g-code-not-available",
    number={
        "fanuc-16i": "010",
        "fanuc-30i": "PS0010",
        "mitsubishi-m700": "P34",
        "gsk-988t": "009",
        "gsk-980mdi": "0002",
    },
    at="O1",
)

case(
    "G33 cuts a thread along Z (M057)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge",
    evidence="inferred",
    program="""
        O1
        S500 M03
        G33 Z-20 F1.5
        G00 Z5
        M30
    """,
    params=MM,
    setup=MILL | {"start": {"X": 0, "Y": 0, "Z": 5}},
    moves="""
        T Z-20
        R Z5
    """,
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
    params=MM,
    setup=MILL,
    alarm="no-radius",
    number="0021",
    at="O1",
)

case(
    "G92 moves every work coordinate system (M101)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700"],
    source="M7 p.534 (7); TDi 21 note 7; FANUC: general knowledge",
    evidence="maker's manual",
    program="""
        O1
        G54 G92 X100 Y100
        G55 G90 G00 X0 Y0
        M30
    """,
    params=MM,
    setup=MILL
    | {"work_offsets": {"G55": {"X": 300, "Y": 0}}, "start": {"X": 200, "Y": 160, "Z": 0}},
    moves="R X0 Y0",
    final_machine="X400 Y60",
)

case(
    "G92 leaves an axis alone that it does not name (M102)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 003, example 7; general knowledge",
    evidence="inferred",
    program="""
        O1
        G92 X10
        G90 G00 X0 Y0
        M30
    """,
    params=MM,
    setup=MILL | {"start": {"X": 35, "Y": 25, "Z": 0}},
    moves="R X0 Y0",
    final_machine="X25 Y0",
)

case(
    "selecting G54 again does not take a G92 back (M103)",
    control=["fanuc-16i", "fanuc-30i"],
    source="TDi 21 note 7; M7 p.534 (7)",
    evidence="secondary",
    program="""
        O1
        G92 X0
        G54 G90 G00 X0
        M30
    """,
    params=MM,
    setup=MILL | {"start": {"X": 50, "Y": 0, "Z": 0}},
    moves="R X0",
    final_machine="X50",
)

case(
    "G52 counts in every work coordinate system (M104)",
    control=["fanuc-16i", "fanuc-30i", "gsk-980mdi"],
    source="TDi 19; FANUC: general knowledge",
    evidence="maker's manual",
    program="""
        O1
        G54 G52 X10 Y10
        G90 G00 X0 Y0
        G55 X0 Y0
        M30
    """,
    params=MM,
    setup=MILL | {"work_offsets": {"G54": {"X": 0}, "G55": {"X": 200}}},
    moves="""
        R X0 Y0
        R X0 Y0
    """,
    final_machine="X210 Y10",
)

case(
    "a second G52 replaces the first (M105)",
    control=["fanuc-16i", "fanuc-30i"],
    source="TDi 19",
    evidence="secondary",
    program="""
        O1
        G52 X10
        G52 X30
        G90 G00 X0
        M30
    """,
    params=MM,
    setup=MILL,
    moves="R X0",
    final_machine="X30",
)

case(
    "G92 ends a G52 on the axes it names (M106)",
    control=["fanuc-16i", "fanuc-30i"],
    source="TDi 19 note 5, for G50",
    evidence="secondary",
    program="""
        O1
        G52 X10 Y10
        G90 G00 X0 Y0
        G92 X0
        G52 Y0
        G00 X0 Y0
        M30
    """,
    params=MM,
    setup=MILL,
    moves="""
        R X0 Y0
        R X0 Y0
    """,
    final_machine="X10 Y0",
)

case(
    "the external offset counts in every work coordinate system (M107)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 003; TDi 21",
    evidence="source document",
    program="""
        O1
        G54 G90 G00 X0
        G55 X0
        M30
    """,
    params=MM,
    setup=MILL | {"work_offsets": {"EXT": {"X": 5}, "G54": {"X": 10}, "G55": {"X": 20}}},
    moves="""
        R X0
        R X0
    """,
    final_machine="X25",
)

case(
    "G10 L2 P2 sets G55 and moves nothing (M108)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700"],
    source="general knowledge",
    evidence="inferred",
    program="""
        O1
        G90 G10 L2 P2 X50 Y20
        G55 G00 X0 Y0
        M30
    """,
    params=MM,
    setup=MILL,
    moves="R X0 Y0",
    final_machine="X50 Y20",
)

case(
    "G10 L2 under G91 adds to the offset (M109)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700"],
    source="general knowledge",
    evidence="inferred",
    program="""
        O1
        G91 G10 L2 P2 X3
        G90 G55 G00 X0
        M30
    """,
    params=MM,
    setup=MILL | {"work_offsets": {"G55": {"X": 50}}},
    moves="R X0",
    final_machine="X53",
)

case(
    "G10 L2 P0 sets the external offset (M110)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge",
    evidence="inferred",
    program="""
        O1
        G90 G10 L2 P0 X7
        G00 X0
        M30
    """,
    params=MM,
    setup=MILL,
    moves="R X0",
    final_machine="X7",
)

case(
    "G10 L2 with P7 alarms (M111)",
    control=["fanuc-16i", "fanuc-30i", "gsk-980mdi", "gsk-988t"],
    source="ALM PS0031; MDib 0238; Talm 062",
    evidence="secondary",
    program="""
        O1
        G10 L2 P7 X1
        M30
    """,
    params=MM,
    setup=MILL,
    alarm="g10-p",
    number={"fanuc-16i": "031", "fanuc-30i": "PS0031", "gsk-980mdi": "0238", "gsk-988t": "062"},
    at="O1",
)

case(
    "G10 with an L that does not exist alarms (M112)",
    control=["fanuc-16i", "fanuc-30i", "gsk-980mdi", "gsk-988t"],
    source="ALM PS0031; MDib 0244; Talm 061",
    evidence="maker's manual",
    program="""
        O1
        G10 L99 P1 R1
        M30
    """,
    params=MM,
    setup=MILL,
    alarm="g10-l",
    number={"fanuc-16i": "031", "fanuc-30i": "PS0031", "gsk-980mdi": "0244", "gsk-988t": "061"},
    at="O1",
)

case(
    "G53 under G91 is passed over (M114)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 003",
    evidence="source document",
    program="""
        O1
        G91 G53 X5
        G90 G00 X20
        M30
    """,
    params=MM,
    setup=MILL | {"start": {"X": 10, "Y": 0, "Z": 0}},
    moves="R X20",
)

case(
    "G53 under G91 moves by its value on the M700 (M115)",
    control="mitsubishi-m700",
    source="M7 p.520 (4)",
    evidence="maker's manual",
    program="""
        O1
        G91 G00 G53 X5
        M30
    """,
    params=MM,
    setup=MILL | {"start": {"X": 10, "Y": 0, "Z": 0}},
    moves="R X15",
)

case(
    "G53 under G01 goes at the feed on the M700 (M116)",
    control="mitsubishi-m700",
    source="M7 p.520 (7)",
    evidence="maker's manual",
    program="""
        O1
        G90 G01 F500
        G53 X30
        M30
    """,
    params=MM,
    setup=MILL | {"work_offsets": {"G54": {"X": 100}}},
    moves="F X-70",
    final_machine="X30",
)

case(
    "G29 comes back over the intermediate point of G28 (M120)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700", "hnc-21m"],
    source="M7 p.523",
    evidence="maker's manual",
    program="""
        O1
        G90 G28 X100 Y80
        M06
        G29 X20 Y10
        M30
    """,
    params=MM,
    setup=MILL
    | {
        "work_offsets": {"G54": {"X": -300, "Y": -200}},
        "start": {"X": 50, "Y": 50, "Z": 0},
        "reference": {1: {"X": 0, "Y": 0, "Z": 0}},
    },
    moves="""
        R X100 Y80
        R X300 Y200
        R X100 Y80
        R X20 Y10
    """,
)

case(
    "G29 under G91 counts from the intermediate point (M121)",
    control=["fanuc-16i", "fanuc-30i", "hnc-21m"],
    source="M7 p.523; general knowledge",
    evidence="secondary",
    program="""
        O1
        G91 G28 X20 Y40
        G29 X40 Y-40
        M30
    """,
    params=MM,
    setup=MILL
    | {"start": {"X": 0, "Y": 0, "Z": 0}, "reference": {1: {"X": 100, "Y": 100, "Z": 0}}},
    moves="""
        R X20 Y40
        R X100 Y100
        R X20 Y40
        R X60 Y0
    """,
)

case(
    "G29 without a G28 before it alarms (M122)",
    control=["fanuc-30i", "gsk-980mdi"],
    source="ALM PS0305; MDib 0068",
    evidence="maker's manual",
    program="""
        O1
        G29 X20 Y10
        M30
    """,
    params=MM,
    setup=MILL,
    alarm="no-intermediate",
    number={"fanuc-30i": "PS0305", "gsk-980mdi": "0068"},
    at="O1",
)

case(
    "G30 without a P goes to the second reference point (M124)",
    control=["fanuc-16i", "fanuc-30i", "gsk-980mdi"],
    source="TDi 15",
    evidence="maker's manual",
    program="""
        O1
        G91 G30 Z0
        M30
    """,
    params=MM,
    setup=MILL | {"start": {"X": 0, "Y": 0, "Z": 50}, "reference": {2: {"Z": -20}}},
    moves="""
        R Z50
        R Z-20
    """,
)

case(
    "G28 without an axis does nothing (M128)",
    control="gsk-980tdi",
    source="TDi 15, table",
    evidence="maker's manual",
    program="""
        O1
        G28
        G0 X40 Z40
        M30
    """,
    params=MM,
    setup=LATHE_A | {"start": {"X": 50, "Z": 50}},
    moves="R X40 Z40",
)

case(
    "a work system counts for the move of its own block (M129)",
    control=["fanuc-16i", "fanuc-30i"],
    source="TDi 21; general knowledge",
    evidence="inferred",
    program="""
        O1
        G90 G00 X10
        X10 G55
        M30
    """,
    params=MM,
    setup=MILL | {"work_offsets": {"G55": {"X": 100}}},
    moves="""
        R X10
        R X10
    """,
    final_machine="X110",
)

case(
    "G55 alone moves nothing (M130)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 003; TDi 21",
    evidence="secondary",
    program="""
        O1
        G55
        M30
    """,
    params=MM,
    setup=MILL | {"work_offsets": {"G55": {"X": 100}}},
    moves="none",
    final_work="X-100",
)

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
    params=MM,
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
    params=MM,
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
    params=MM,
    setup=MILL,
    alarm="plane-change-in-polar",
    number="0186",
    at="O1",
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
    params=MM,
    setup=MILL,
    alarm="work-system-change-in-polar",
    number="0187",
    at="O1",
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
    params=MM,
    setup=MILL,
    moves="""
        W 1.5
        W 2.5
    """,
    time=4,
)

case(
    "a dwell of the HNC-21 counts P in seconds (M140)",
    pins="dwell_p_seconds",
    control="hnc-21m",
    source="source 003, G04; general knowledge",
    evidence="source document",
    program="""
        O1
        G04 P2
        M30
    """,
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM,
    setup=LATHE_A | {"start": {"X": 160, "Z": 80}, "rapid": {"X": 3800, "Z": 7600}},
    moves="R X50 Z0",
    time=0.868,
)

case(
    "G20 that is not alone in its block alarms on the 988T (M149)",
    control="gsk-988t",
    source="Talm 042",
    evidence="maker's manual",
    program="""
        O1
        G0 X10
        G20 G0 X20
        M30
    """,
    params=MM,
    setup=LATHE_A,
    moves="R X10",
    alarm="unit-change-misplaced",
    number="042",
    at="O1",
)

case(
    "G20 in the middle of a program alarms on the 980MDi (M150)",
    control="gsk-980mdi",
    source="MDib 0038",
    evidence="maker's manual",
    program="""
        O1
        G00 X10
        G20
        M30
    """,
    params=MM,
    setup=MILL,
    moves="R X10",
    alarm="unit-change-misplaced",
    number="0038",
    at="O1",
)

case(
    "G22 makes X1000 one millimetre on the HNC-21 (M151)",
    control="hnc-21m",
    source="source 003, G20 G21 G22; the size of the pulse: general knowledge",
    evidence="source document",
    program="""
        O1
        G22
        G90 G00 X1000
        M30
    """,
    params=MM,
    setup=MILL,
    moves="R X1",
)

case(
    "G22 is no unit on the 16i (M151)",
    control="fanuc-16i",
    source="source 003 for the HNC; FANUC: general knowledge",
    evidence="inferred",
    program="""
        O1
        G22
        G90 G00 X1000
        M30
    """,
    params=MM,
    setup=MILL,
    moves="R X1000",
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
    params=MM | {"027": 3000},
    setup=MILL,
    alarm="feed-out-of-range",
    number="0023",
    at="O1",
)

case(
    "G53 alarms on the 980MDi before the machine zero is known (M153)",
    control="gsk-980mdi",
    source="MDib 0166",
    evidence="maker's manual",
    program="""
        O1
        G90 G53 X10
        M30
    """,
    params=MM,
    setup=MILL,
    alarm="machine-zero-not-known",
    number="0166",
    at="O1",
)

case(
    "G30 alarms before the reference point is known (M154)",
    control=["gsk-980mdi", "gsk-988t"],
    source="MDib 0069; Talm 047",
    evidence="maker's manual",
    program="""
        O1
        G91 G30 P2 Z0
        M30
    """,
    params=MM,
    setup=MILL,
    alarm="reference-not-known",
    number={"gsk-980mdi": "0069", "gsk-988t": "047"},
    at="O1",
)

case(
    "G92 under G91 sets the coordinate (M155)",
    control=["fanuc-16i", "fanuc-30i"],
    source="policy",
    evidence="inferred",
    program="""
        O1
        G91 G92 X10
        G90 G00 X0
        M30
    """,
    params=MM,
    setup=MILL | {"start": {"X": 50, "Y": 0, "Z": 0}},
    moves="R X0",
    final_machine="X40",
)

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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM,
    setup=MILL | {"length_offsets": {1: 20}},
    alarm="offset-number",
    number={
        "fanuc-16i": "030",
        "fanuc-30i": "PS0030",
        "mitsubishi-m700": "P170",
        "gsk-980mdi": "0016",
    },
    at="O1",
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
    params=MM,
    setup=MILL | {"length_offsets": {1: 20}},
    moves="CW X10 Y0 C X5 Y0",
    alarm="length-with-motion",
    number="0042",
    at="O1",
)

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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM,
    setup=MILL | {"radius_offsets": {1: 5}},
    alarm="arc-at-offset-end",
    number={
        "fanuc-16i": "034",
        "fanuc-30i": "PS0034",
        "mitsubishi-m700": "P151",
        "gsk-980mdi": "0259",
        "gsk-988t": "252",
    },
    at="O1",
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
    params=MM,
    setup=MILL | {"radius_offsets": {1: 5}},
    alarm="plane-change-in-offset",
    number={
        "fanuc-16i": "037",
        "fanuc-30i": "PS0037",
        "mitsubishi-m700": "P112",
        "gsk-980mdi": "0030",
        "gsk-988t": "253",
    },
    at="O1",
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
    params=MM,
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
    params=MM,
    setup=MILL | {"radius_offsets": {1: 6}},
    alarm="offset-interference",
    number={
        "fanuc-16i": "041",
        "fanuc-30i": "PS0041",
        "mitsubishi-m700": "P153",
        "gsk-980mdi": "0260",
        "gsk-988t": "256",
    },
    at="O1",
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
    params=MM,
    setup=MILL | {"radius_offsets": {1: 5}},
    alarm="mirror-in-offset",
    number="0155",
    at="O1",
)

case(
    "a GOTO while the radius offset is on alarms on the 980MDi (M226)",
    pins="jumps_in_compensation",
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
    params=MM,
    setup=MILL | {"radius_offsets": {1: 5}},
    alarm="jump-in-offset",
    number="0100",
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
    params=MM,
    setup=MILL | {"radius_offsets": {1: 5}},
    alarm="cycle-in-offset",
    number="P155",
    at="O1",
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
    params=MM,
    setup=MILL,
    alarm="radius-offset-number",
    number={"mitsubishi-m700": "P170", "fanuc-16i": "030"},
    at="O1",
)

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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM | {"5114": 0.5},
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
    params=MM | {"5115": 1},
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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    pins="peck_words",
    control="hnc-21m",
    source="general knowledge",
    evidence="inferred",
    program="""
        %1
        G90 G99 G83 X10 Z-25 R2 Q-10 K1 F100
        G80
        M30
    """,
    params=MM,
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
    params=MM,
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
    params=MM,
    setup=MILL,
    alarm="cycle-repeats",
    number="0203",
    at="O1",
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
    params=MM,
    setup=MILL | {"start": {"X": 0, "Y": 0, "Z": 20}},
    moves="""
        R X10
        R Z2
        F Z-5
        R Z2
    """,
    alarm="machine-move-in-cycle",
    number="0165",
    at="O1",
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
    params=MM,
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

case(
    "X and Z absolute, U and W incremental, and mixed, lead to the same place (M402)",
    pins="minus_addresses",
    control=["gsk-980tdi", "fanuc-0i-d"],
    source="TDi 2, example",
    evidence="maker's manual",
    program="""
        O1
        G0 U-22 W-18
        G0 X42 Z43
        G0 X20 W-18
        G0 X42 Z43
        G0 U-22 Z25
        M30
    """,
    params=MM,
    setup=LATHE_A | {"start": {"X": 42, "Z": 43}},
    moves="""
        R X20 Z25
        R X42 Z43
        R X20 Z25
        R X42 Z43
        R X20 Z25
    """,
)

case(
    "of X and U in one block X counts on the 980TDi (M403)",
    control="gsk-980tdi",
    source="TDi 2",
    evidence="maker's manual",
    program="""
        O1
        G0 X20 U7 Z25 W9
        M30
    """,
    params=MM,
    setup=LATHE_A | {"start": {"X": 42, "Z": 43}},
    moves="R X20 Z25",
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
    params=MM,
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
    params=MM,
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
    params=MM,
    setup=LATHE_A | {"start": {"X": 40, "Z": 0}},
    moves="CCW X40 Z-20 C X55 Z-10",
)

case(
    "a negative R alarms on a FANUC lathe (M409)",
    pins="negative_radius_on_lathes",
    control="fanuc-16i",
    source="16TC p.67; the number: general knowledge",
    evidence="inferred",
    program="""
        O1
        G03 X40 Z-20 R-12.5 F100
        M30
    """,
    params=MM,
    setup=LATHE_A | {"start": {"X": 40, "Z": 0}},
    alarm="negative-radius",
    number="023",
    at="O1",
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
    params=MM | {"3403#4": 1},
    setup=LATHE_A | {"start": {"X": 40, "Z": 0}},
    alarm="radius-too-small",
    number={"gsk-980tdi": None, "gsk-988t": "035"},
    at="O1",
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
    params=MM | {"3410": 0.01},
    setup=LATHE_A | {"start": {"X": 0, "Z": 0}},
    alarm="radius-tolerance",
    number="036",
    at="O1",
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
    params=MM,
    setup=LATHE_A,
    alarm="arc-axis-not-in-plane",
    number="033",
    at="O1",
)

case(
    "G50 sets the coordinate and leaves the tool where it is (M414)",
    pins="set_coordinate_alarms",
    control=["gsk-980tdi", "gsk-988ta", "fanuc-0i-d"],
    source="TDi 18, figure 3-54",
    evidence="maker's manual",
    program="""
        O1
        G50 X100 Z150
        G0 X80 Z140
        M30
    """,
    params=MM,
    setup=LATHE_A | {"start": {"X": 250, "Z": 50}},
    moves="R X80 Z140",
    final_machine="X230 Z40",
)

case(
    "G50 U W shifts the coordinate by the difference (M415)",
    control=["gsk-980tdi", "fanuc-0i-d"],
    source="TDi 18",
    evidence="maker's manual",
    program="""
        O1
        G50 U20 W-5
        G0 X0 Z0
        M30
    """,
    params=MM,
    setup=LATHE_A | {"start": {"X": 100, "Z": 50}},
    moves="R X0 Z0",
    final_machine="X-20 Z5",
)

case(
    "G50 counts in G55 too (M416)",
    control="gsk-980tdi",
    source="TDi 21 note 7",
    evidence="maker's manual",
    program="""
        O1
        G54
        G50 X100 Z100
        G55 G0 X0 Z0
        M30
    """,
    params=MM,
    setup=LATHE_A | {"work_offsets": {"G55": {"X": 0, "Z": 100}}, "start": {"X": 160, "Z": 200}},
    moves="R X0 Z0",
    final_machine="X60 Z200",
)

case(
    "the manual's G52 example goes through both work systems (M417)",
    control="gsk-980tdi",
    source="TDi 19, example; its offsets are chosen",
    evidence="secondary",
    program="""
        O1
        N1 G54 G28 X0 Z0
        N2 G55 G00 X50 Z50
        N3 G52 X100 Z100
        N4 G00 X50 Z50
        N5 G01 Z100 F100
        N6 X100
        N7 G52 X0 Z0
        N8 G00 X0 Z0
        N9 M30
    """,
    params=MM,
    setup=LATHE_A
    | {
        "work_offsets": {"G54": {"X": 0, "Z": 100}, "G55": {"X": 100, "Z": 300}},
        "reference": {1: {"X": 0, "Z": 0}},
        "start": {"X": 10, "Z": 10},
    },
    moves="""
        R X0 Z0
        R X0 Z-100
        R X50 Z50
        R X50 Z50
        F Z100
        F X100
        R X0 Z0
    """,
    final_machine="X100 Z300",
)

case(
    "G28 U0 W0 goes straight to the reference point (M419)",
    control=["gsk-980tdi", "gsk-988ta", "fanuc-0i-d"],
    source="TDi 15",
    evidence="maker's manual",
    program="""
        O1
        G28 U0 W0
        M30
    """,
    params=MM,
    setup=LATHE_A
    | {
        "work_offsets": {"G54": {"X": -100, "Z": -300}},
        "start": {"X": 50, "Z": 20},
        "reference": {1: {"X": 0, "Z": 0}},
    },
    moves="""
        R X50 Z20
        R X100 Z300
    """,
    final_machine="X0 Z0",
)

case(
    "the manual's taper thread runs in two cuts (M420)",
    pins="thread_needs_spindle",
    control="gsk-980tdi",
    source="TDi 24.1, O0009",
    evidence="maker's manual",
    program="""
        O0009
        G00 X27.4286 Z3
        G32 X48.8571 W-75 F2.0
        G00 X55
        W75
        X26.4286
        G32 X47.4286 W-75 F2.0
        G00 X55
        W75
        M30
    """,
    params=MM,
    setup=LATHE_A | {"start": {"X": 55, "Z": 3}},
    moves="""
        R X27.4286 Z3
        T X48.8571 Z-72
        R X55
        R Z3
        R X26.4286
        T X47.4286 Z-72
        R X55
        R Z3
    """,
)

case(
    "G90 of a lathe goes in, cuts, comes out and goes back (M421)",
    pins="max_feed",
    control=["gsk-980tdi", "gsk-988ta", "fanuc-0i-d"],
    source="TDi 22.1; TA 6",
    evidence="maker's manual",
    program="""
        O0002
        G90 X120 Z-110 F200
        M30
    """,
    params=MM,
    setup=LATHE_A | {"start": {"X": 130, "Z": 3}},
    moves="""
        R X120
        F X120 Z-110
        F X130
        R Z3
    """,
)

case(
    "an X alone repeats the turning cycle with the old Z (M422)",
    control=["gsk-980tdi", "gsk-988ta", "fanuc-0i-d"],
    source="TDi 22.1, O0002; TA 6 note 2",
    evidence="maker's manual",
    program="""
        O0002
        G90 X120 Z-110 F200
        X110 Z-30
        X100
        G0 X140 Z10
        M30
    """,
    params=MM,
    setup=LATHE_A | {"start": {"X": 130, "Z": 3}},
    moves="""
        R X120
        F Z-110
        F X130
        R Z3
        R X110
        F Z-30
        F X130
        R Z3
        R X100
        F Z-30
        F X130
        R Z3
        R X140 Z10
    """,
)

case(
    "R of G90 shifts the start of the cut by twice its value (M423)",
    control=["gsk-980tdi", "gsk-988ta", "fanuc-0i-d"],
    source="TDi 22.1, O0002",
    evidence="maker's manual",
    program="""
        O1
        G90 X120 Z-44 R-7.5 F150
        Z-56 R-15
        M30
    """,
    params=MM,
    setup=LATHE_A | {"start": {"X": 120, "Z": -30}},
    moves="""
        R X105
        F X120 Z-44
        F X120
        R Z-30
        R X90
        F X120 Z-56
        F X120
        R Z-30
    """,
)

case(
    "G94 of a lathe goes along Z, faces, comes out and goes back (M424)",
    control=["gsk-980tdi", "gsk-988ta", "fanuc-0i-d"],
    source="TDi 22.2, O0003",
    evidence="maker's manual",
    program="""
        O0003
        G94 X0 Z0 F200
        X120 Z-110 F300
        M30
    """,
    params=MM,
    setup=LATHE_A | {"start": {"X": 130, "Z": 5}},
    moves="""
        R Z0
        F X0 Z0
        F Z5
        R X130
        R Z-110
        F X120 Z-110
        F Z5
        R X130
    """,
)

case(
    "R of G94 shifts the start of the cut along Z (M425)",
    control=["gsk-980tdi", "gsk-988ta", "fanuc-0i-d"],
    source="TDi 22.2, O0003",
    evidence="maker's manual",
    program="""
        O1
        G94 X108 Z-30 R-10 F300
        X96 R-20
        M30
    """,
    params=MM,
    setup=LATHE_A | {"start": {"X": 120, "Z": 0}},
    moves="""
        R Z-40
        F X108 Z-30
        F Z0
        R X120
        R Z-50
        F X96 Z-30
        F Z0
        R X120
    """,
)

case(
    "an R of G90 against U and larger than its half alarms on the 988T (M427)",
    control="gsk-988t",
    source="Talm 123",
    evidence="maker's manual",
    program="""
        O1
        G90 X40 Z-20 R6 F100
        M30
    """,
    params=MM,
    setup=LATHE_A | {"start": {"X": 50, "Z": 0}},
    alarm="taper",
    number="123",
    at="O1",
)

case(
    "an R of G94 against W and larger than it alarms on the 988T (M428)",
    control="gsk-988t",
    source="Talm 124",
    evidence="maker's manual",
    program="""
        O1
        G94 X20 Z-5 R6 F100
        M30
    """,
    params=MM,
    setup=LATHE_A | {"start": {"X": 50, "Z": 0}},
    alarm="face-taper",
    number="124",
    at="O1",
)

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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM,
    setup=LATHE_A | {"start": {"X": 50, "Z": 2}},
    alarm="pq-not-found",
    number={"gsk-988t": "134", "fanuc-16i": "063", "fanuc-30i": "PS0063"},
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
    params=MM,
    setup=LATHE_A | {"start": {"X": 50, "Z": 2}},
    alarm="call-in-profile",
    number="131",
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
    params=MM,
    setup=LATHE_A | {"start": {"X": 50, "Z": 2}},
    alarm="profile-not-monotone",
    number="PS0064",
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
    params=MM | {"5102#1": 1},
    setup=LATHE_A | {"start": {"X": 50, "Z": 2}},
    alarm="profile-not-monotone",
    number="138",
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
    params=MM,
    setup=LATHE_A | {"start": {"X": 50, "Z": 2}},
    alarm="groove-axis",
    number="154",
    at="O1",
)

case(
    "G76 without the height of the thread alarms on the 988T (M446)",
    control="gsk-988t",
    source="Talm 167",
    evidence="maker's manual",
    program="""
        O1
        G76 P020560 Q150 R0.1
        G76 X60.64 Z-62 Q1800 F6
        M30
    """,
    params=MM,
    setup=LATHE_A | {"start": {"X": 80, "Z": 10}},
    alarm="thread-height",
    number="167",
    at="O1",
)

case(
    "a thread with the spindle at rest alarms on the 988T (M447)",
    control="gsk-988t",
    source="Talm 102",
    evidence="maker's manual",
    program="""
        O1
        S0 M05
        G32 Z-20 F2
        M30
    """,
    params=MM,
    setup=LATHE_A | {"start": {"X": 20, "Z": 3}},
    alarm="spindle-stopped",
    number="102",
    at="O1",
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
    params=MM,
    setup=LATHE_A | {"start": {"X": 200, "Z": 60}},
    moves="""
        R X100 Z50
        R X50 Z0
        F Z-30
        F X80 Z-50
        R X100 Z50
    """,
)

case(
    "in system B G77 is the turning cycle, and G90 and G91 are modes (M450)",
    control="fanuc-0i-d",
    source="CNCS; general knowledge",
    evidence="secondary",
    program="""
        O1
        G90 G77 X40 Z-20 F0.2
        G00 G91 X10 Z5
        G90 X0 Z100
        M30
    """,
    params=MM,
    setup=LATHE_B | {"start": {"X": 50, "Z": 2}},
    moves="""
        R X40
        F Z-20
        F X50
        R Z2
        R X60 Z7
        R X0 Z100
    """,
)

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
    params=MM,
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
    params=MM,
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
    params=MM,
    setup=MILL,
    alarm="corner-too-short",
    number={
        "fanuc-16i": "055",
        "fanuc-30i": "PS0055",
        "mitsubishi-m700": "P383",
        "gsk-980mdi": "0271",
        "gsk-988t": "275",
    },
    at="O1",
)

case(
    "a corner with no move behind it alarms (M505)",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700"],
    source="ALM PS0051; MZ 912, paired with P382",
    evidence="secondary",
    program="""
        O1
        G90 G01 X50 ,C5 F100
        M08
        M30
    """,
    params=MM,
    setup=MILL,
    alarm="corner-no-move",
    number={"fanuc-16i": "051", "fanuc-30i": "PS0051", "mitsubishi-m700": "P382"},
    at="O1",
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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM,
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
    params=MM,
    setup=MILL,
    moves="""
        R X10
        R X20
    """,
)

case(
    "#5001 is the end point without the tool, and #5021 the machine's (M530)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge",
    evidence="inferred",
    program="""
        O1
        G90 G54 G00 X10
        G43 Z5 H1
        #100=#5001
        #101=#5003
        #102=#5021
        #103=#5023
        M30
    """,
    params=MM,
    setup=MILL | {"work_offsets": {"G54": {"X": 100, "Z": -50}}, "length_offsets": {1: 20}},
    vars={100: 10, 101: 5, 102: 110, 103: -25},
)

case(
    "the tool word of the 980TDi shifts the coordinate by its offset (M531)",
    pins="set_coordinate_without_tool",
    control="gsk-980tdi",
    source="TDi 18, table",
    evidence="maker's manual",
    program="""
        O1
        G0 X20 Z20
        T0101
        G50 X20 Z20
        M30
    """,
    params=MM,
    setup=LATHE_A | {"start": {"X": 20, "Z": 20}, "tools": {1: {"X": 12, "Z": 23}}},
    final_work="X8 Z-3",
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
    params=MM | {"3403#6": 1},
    setup=LATHE_A,
    alarm="address-given-twice",
    number="010",
    at="O1",
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
    params=MM | {"3403#6": 0},
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
    params=MM,
    setup=LATHE_A,
    alarm="illegal-word-with-return",
    number="030",
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
    params=MM,
    setup=MILL | {"radius_offsets": {1: 3}},
    alarm="return-in-offset",
    number="0099",
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
    params=MM,
    setup=MILL,
    alarm="reference-with-end",
    number="P435",
    at="O1",
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
    params=MM,
    setup=MILL,
    alarm="reference-return-in-mirror",
    number="0152",
    at="O1",
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
    params=MM,
    setup=MILL,
    alarm="rotation-out-of-range",
    number="0156",
    at="O1",
)
