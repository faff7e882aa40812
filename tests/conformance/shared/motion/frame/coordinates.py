"""Coordinates: G52 to G59, G92, G50, G28 to G30, G53, G90 and G91."""

from conformance import case

MM = {"whole_numbers": "millimetres"}  # whole numbers are millimetres, on every control
MILL = {"machine": "mill"}
LATHE_A = {"machine": "lathe-a"}

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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
    setup=MILL,
    moves="""
        R X15 Y-40 Z0
        R X20 Y10
        R X60 Y30
    """,
    final_machine="X75 Y-10",
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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
    setup=MILL | {"start": {"X": 10, "Y": 10, "Z": 0}},
    moves="""
        R X0 Y0
        R X5 Y5
    """,
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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
    setup=MILL,
    alarm="g10-p",
    number={"fanuc-16i": "031", "fanuc-30i": "PS0031", "gsk-980mdi": "0238", "gsk-988t": "062"},
    at="O1", word="P7",
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
    replace=MM,
    setup=MILL,
    alarm="g10-l",
    number={"fanuc-16i": "031", "fanuc-30i": "PS0031", "gsk-980mdi": "0244", "gsk-988t": "061"},
    at="O1", word="L99",
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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
    setup=MILL,
    alarm="no-intermediate",
    number={"fanuc-30i": "PS0305", "gsk-980mdi": "0068"},
    at="O1", word="G29",
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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
    setup=MILL | {"work_offsets": {"G55": {"X": 100}}},
    moves="none",
    final_work="X-100",
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
    replace=MM,
    setup=MILL,
    alarm="machine-zero-not-known",
    number="0166",
    at="O1", word="G53",
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
    replace=MM,
    setup=MILL,
    alarm="reference-not-known",
    number={"gsk-980mdi": "0069", "gsk-988t": "047"},
    at="O1", word="G30",
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
    replace=MM,
    setup=MILL | {"start": {"X": 50, "Y": 0, "Z": 0}},
    moves="R X0",
    final_machine="X40",
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
    replace=MM,
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
    replace=MM,
    setup=LATHE_A | {"start": {"X": 42, "Z": 43}},
    moves="R X20 Z25",
)

case(
    "G50 sets the coordinate and leaves the tool where it is (M414)",
    pins="refuses:coordinate-setting-refused",
    control=["gsk-980tdi", "gsk-988ta", "fanuc-0i-d"],
    source="TDi 18, figure 3-54",
    evidence="maker's manual",
    program="""
        O1
        G50 X100 Z150
        G0 X80 Z140
        M30
    """,
    replace=MM,
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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
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
    replace=MM,
    setup=LATHE_A | {"start": {"X": 20, "Z": 20}, "tools": {1: {"X": 12, "Z": 23}}},
    final_work="X8 Z-3",
)
