"""Claims of source 003 about moving that no other table holds, and contours of source 001."""

from conformance import case

MM = {"whole_numbers": "millimetres"}  # whole numbers are millimetres, on every control
MILL = {"machine": "mill"}
MILLS = ["fanuc-0i-f", "fanuc-16i", "hnc-21m"]
SOURCE = {"evidence": "source document", "replace": MM, "setup": MILL}

# Examples 1 to 10; 3 to 7 and 9 are among the given rows.
case(
    "example 1: G00 G90 goes to X120 Y60 wherever it starts",
    control=MILLS, source="source 003, example of G00", **SOURCE,
    program="""
        O1
        N10 G91 G00 X15 Y-5
        N20 G00 G90 X120. Y60.
        N30 M30
    """,
    moves="""
        R X15 Y-5
        R X120 Y60
    """,
)
case(
    "example 2: F80 is the speed along the line through X, Y and Z",
    control=MILLS, source="source 003, text on G01", **SOURCE,
    program="""
        O1
        N10 G01 X10. Y20. Z20. F80.
        N20 M30
    """,
    moves="F X10 Y20 Z20",
    time=22.5,
)
case(
    "example 4 is the same arc in increments",
    control=MILLS, source="source 003, example 4; text on G91", **SOURCE,
    program="""
        O1
        N10 G90 G00 X40 Y60
        N20 G91 G02 X80 R40 F100
        N30 M30
    """,
    moves="""
        R X40 Y60
        CW X120 Y60 C X80 Y60
    """,
)
case(
    "example 5: the two arcs of A to C are the two parts of one circle's way",
    control=MILLS, source="source 003, example 5", **SOURCE,
    program="""
        O1
        N10 G00 X40 Y60
        N20 G02 X80 Y20 R-40 F100
        N30 G03 X40 Y60 R-40
        N40 M30
    """,
    moves="""
        R X40 Y60
        CW X80 Y20 C X80 Y60
        CCW X40 Y60 C X80 Y60
    """,
)
case(
    "example 6: the full circle has its whole length",
    control=MILLS, source="source 003, example 6", **SOURCE,
    program="""
        O1
        N10 G02 I40 F100
        N20 M30
    """,
    moves="CW X0 Y0 C X40 Y0",
    time=150.796,
)
case(
    "example of G53: X5 Y10 are machine coordinates whatever G54 holds",
    control=MILLS, source="source 003, G53", evidence="source document", replace=MM,
    setup=MILL | {"work_offsets": {"G54": {"X": 100, "Y": 50}}},
    program="""
        O1
        N10 G54 G90 G00 X0 Y0
        N20 G90 G53 X5.0 Y10.0
        N30 M30
    """,
    moves="""
        R X0 Y0
        R X-95 Y-40
    """,
    final_machine="X5 Y10",
)
case(
    "G53 does nothing under G91",
    control=MILLS, source="source 003, G53", **SOURCE,
    program="""
        O1
        N10 G91 G53 X5.0 Y10.0
        N20 G00 X1
        N30 M30
    """,
    moves="R X1 Y0",
)
case(
    "example 8: G55 X40 Y40 is the point that G54 calls X120 Y80",
    control=MILLS, source="source 003, example 8", evidence="source document", replace=MM,
    setup=MILL | {"work_offsets": {"G55": {"X": 80, "Y": 40}}},
    program="""
        O1
        N10 G55 G01 X40 Y40 F100
        N20 M30
    """,
    moves="F X40 Y40",
    final_machine="X120 Y80",
)
case(
    "example 9: without G52 the point is X120 Y80",
    control=MILLS, source="source 003, example 9", **SOURCE,
    program="""
        O1
        N10 G54 G01 X120 Y80 F100
        N20 G52 X80 Y40
        N30 G01 X40 Y40
        N40 M30
    """,
    moves="""
        F X120 Y80
        F X40 Y40
    """,
    final_machine="X120 Y80",
)
case(
    "example 10: with the pole at the tool a radius of 100 at 60 degrees starts from the tool",
    control=MILLS, source="source 003, G16, radius under G91",
    evidence="source document", replace=MM, setup=MILL | {"start": {"X": 100, "Y": 0, "Z": 0}},
    program="""
        O1
        N10 G17 G90 G16
        N20 G91 X100 G90 Y60
        N30 G15 M30
    """,
    moves="R X50 Y86.6025",
)

case(
    "example 10: its first blocks reach a radius of 100 at 60 degrees",
    control=MILLS, source="source 003, example 10, G15 G16", **SOURCE,
    program="""
        O1
        N10 G17 G90 G16
        N20 G01 X100 Y60 F80
        N30 G91 Y60
        N40 G15
        N50 G90 G01 X10 Y20
        N60 M30
    """,
    moves="""
        F X50 Y86.6025
        F X-50 Y86.6025
        F X10 Y20
    """,
)

PARALLEL = {"control": "hnc-21m", "source": "source 003, G02 and G03 end in X Y Z U V W", "replace": MM, "setup": MILL}
case(
    "HNC: an arc may end in U and V, along X and Y", pins="parallel_axes", evidence="source document", **PARALLEL,
    program="""
        %1
        N10 G00 U0 V0
        N20 G02 U10 V0 I5 J0 F100
        N30 G03 U0 V0 R5
        N40 M30
    """,
    moves="R U0 V0\nCW U10 V0 C X5 Y0\nCCW U0 V0 C X5 Y0", final_work="X0 Y0 U0 V0", time=18.849556,
)
case(
    "HNC: an arc may end in U and Y", evidence="inferred", **PARALLEL,
    program="%1\nN10 G02 U10 Y0 I5 J0 F100\nN20 M30", moves="CW U10 Y0 C X5 Y0", time=9.424778,
)
case(
    "HNC: in increments, and in G18 and G19, an arc ends in W and U, V and W", evidence="inferred", **PARALLEL,
    program="""
        %1
        N10 G91 G18 G02 W10 U0 I0 K5 F100
        N20 G19 G03 V4 W4 R4
        N30 M30
    """,
    final_work="U0 V4 W14",
)
case(
    "HNC: a whole circle of I is one of X and Y", evidence="inferred", **PARALLEL,
    program="%1\nN10 G02 I5 F100\nN20 M30", moves="CW X0 Y0 C X5 Y0", time=18.849556,
)
case(
    "HNC: an arc does not end in X and U", evidence="inferred", **PARALLEL,
    program="%1\nN10 G02 X10 U10 I5 F100\nN20 M30", runs="", alarm="arc-axis-not-in-plane", number=None, at="%1 N10", word="U10",
)
case(
    "HNC: an arc of U and V stays within the travel of V", evidence="inferred", **PARALLEL | {"setup": MILL | {"limits": {"V": (-4, 100)}}},
    program="%1\nN10 G03 U10 V0 I5 J0 F100\nN20 M30", runs="", alarm="over-travel", number=None, at="%1 N10", word="V0",
)
case(
    "HNC: an arc of U and V with a radius offset is not computed", evidence="inferred", **PARALLEL | {"setup": MILL | {"radius_offsets": {1: 1}}},
    program="%1\nN10 G01 G41 D1 X5 F100\nN20 G02 U10 V0 I5 J0\nN30 M30", alarm="code-not-computed", number=None, at="%1 N20",
)
case(
    "elsewhere no arc ends in U and V", pins="parallel_axes",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i", "mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800", "haas-ngc"],
    source="general knowledge", evidence="inferred", replace=MM, setup=MILL,
    program="O1\nN10 G90 G00 X0 Y0\nN20 G02 U10 V0 I5 J0 F100\nN30 M30", runs="N10", alarm="arc-axis-not-in-plane", at="O1 N20", word="U10",
    number={
        "fanuc-16i": "021", "fanuc-0i-d": "PS0021", "fanuc-0i-f": "PS0021", "fanuc-30i": "PS0021", "haas-ngc": None,
        "mitsubishi-meldas": "P113", "mitsubishi-m700": "P113", "mitsubishi-m800": "P113",
    },
)

# Unit codes of the HNC stand at the head, beside G codes only, and are not switched later.
case(
    "HNC: G90G21G17G94G40, the codes of the typical example, may head a program",
    control="hnc-21m", source="source 003, typical example", **SOURCE,
    program="%1\nN100 G90G21G17G94G40\nN110 G00 X0\nN190 M30",
    runs="N100 N110 N190",
)
case(
    "HNC: G21, a block of its own, may head a program",
    control="hnc-21m", source="source 003, typical example", **SOURCE,
    program="%1\nN100 G21\nN110 G00 X0\nN190 M30",
    runs="N100 N110 N190",
)
case(
    "HNC: G17 G20 G90, inch between two others, may head a program",
    control="hnc-21m", source="source 003, typical example", **SOURCE,
    program="%1\nN100 G17 G20 G90\nN110 G00 X0\nN190 M30",
    runs="N100 N110 N190",
)
case(
    "HNC: G22 G91, pulses with increments, may head a program",
    control="hnc-21m", source="source 003, typical example", **SOURCE,
    program="%1\nN100 G22 G91\nN110 G00 X0\nN190 M30",
    runs="N100 N110 N190",
)
case(
    "what the source prints in one block the controls that want it alone still refuse",
    control=["gsk-988ta", "gsk-988t"], source="Talm 042", evidence="secondary", replace=MM,
    program="O1\nN10 G21 G98 G40\nN20 M30", alarm="unit-change-misplaced",
    number="042", at="O1 N10", word="G21",
)
case(
    "HNC: G68 turns by P around X and Y",
    pins="max_rotation rotation_words",
    control="hnc-21m", source="added.md: HNC-21M", evidence="inferred", replace=MM, setup=MILL,
    program="""
        %1
        N10 G90 G00 X0 Y0
        N20 G68 X10 Y0 P90
        N30 G00 X20 Y0
        N40 G69
        N50 G00 X20 Y0
        N60 M30
    """,
    moves="R X0 Y0\nR X10 Y10\nR X20 Y0",
)
case(
    "HNC: R is no angle of G68, which turns by nothing then and says that it dropped R",
    control="hnc-21m", source="added.md: HNC-21M", evidence="inferred", replace=MM, setup=MILL,
    program="""
        %1
        N10 G68 X10 Y0 R90
        N20 G00 X20 Y0
        N30 M30
    """,
    moves="R X20 Y0", dropped=["R90"],
)
case(
    "P is no angle of G68 elsewhere, which says that it dropped P",
    control=["fanuc-0i-f", "mitsubishi-m700"], source="B-64113EN p.789; general knowledge",
    evidence="inferred", replace=MM, setup=MILL,
    program="""
        O1
        N10 G68 X10 Y0 P90
        N20 G00 X20 Y0
        N30 M30
    """,
    moves="R X20 Y0", dropped=["P90"],
)
case(
    "HNC: an angle of 450 alarms in no rotation",
    control="hnc-21m", source="policy", evidence="inferred", replace=MM, setup=MILL,
    program="""
        %1
        N10 G68 X0 Y0 P450
        N20 G0 X10 Y0
        N30 M30
    """,
    final_machine="X0 Y10",
)
case(
    "HNC: G20 after a move alarms",
    control="hnc-21m", source="source 003, G20 G21 G22", **SOURCE,
    program="%1\nN10 G00 X10\nN20 G20\nN30 M30",
    runs="N10", alarm="unit-change-misplaced", number=None, at="%1 N20", word="G20",
)
case(
    "HNC: G20 that shares its block with a move alarms",
    control="hnc-21m", source="source 003, G20 G21 G22", **SOURCE,
    program="%1\nN10 G20 G00 X10\nN20 M30",
    runs="", alarm="unit-change-misplaced", number=None, at="%1 N10", word="G20",
)
case(
    "HNC: G20 after the coordinate system alarms",
    control="hnc-21m", source="source 003, G20 G21 G22", **SOURCE,
    program="%1\nN10 G92 X0 Y0 Z0\nN20 G20\nN30 M30",
    runs="N10", alarm="unit-change-misplaced", number=None, at="%1 N20", word="G20",
)
case(
    "HNC: G21 after a move alarms",
    control="hnc-21m", source="source 003, G20 G21 G22", **SOURCE,
    program="%1\nN10 G00 X10\nN20 G21\nN30 M30",
    runs="N10", alarm="unit-change-misplaced", number=None, at="%1 N20", word="G21",
)
case(
    "HNC: G21 that shares its block with a move alarms",
    control="hnc-21m", source="source 003, G20 G21 G22", **SOURCE,
    program="%1\nN10 G21 G00 X10\nN20 M30",
    runs="", alarm="unit-change-misplaced", number=None, at="%1 N10", word="G21",
)
case(
    "HNC: G21 after the coordinate system alarms",
    control="hnc-21m", source="source 003, G20 G21 G22", **SOURCE,
    program="%1\nN10 G92 X0 Y0 Z0\nN20 G21\nN30 M30",
    runs="N10", alarm="unit-change-misplaced", number=None, at="%1 N20", word="G21",
)
case(
    "HNC: G22 after a move alarms",
    control="hnc-21m", source="source 003, G20 G21 G22", **SOURCE,
    program="%1\nN10 G00 X10\nN20 G22\nN30 M30",
    runs="N10", alarm="unit-change-misplaced", number=None, at="%1 N20", word="G22",
)
case(
    "HNC: G22 that shares its block with a move alarms",
    control="hnc-21m", source="source 003, G20 G21 G22", **SOURCE,
    program="%1\nN10 G22 G00 X10\nN20 M30",
    runs="", alarm="unit-change-misplaced", number=None, at="%1 N10", word="G22",
)
case(
    "HNC: G22 after the coordinate system alarms",
    control="hnc-21m", source="source 003, G20 G21 G22", **SOURCE,
    program="%1\nN10 G92 X0 Y0 Z0\nN20 G22\nN30 M30",
    runs="N10", alarm="unit-change-misplaced", number=None, at="%1 N20", word="G22",
)
case(
    "HNC: F of G22 counts pulses per minute",
    control="hnc-21m", source="source 003, G22 and G94; a pulse of 0.001 mm: general knowledge",
    evidence="inferred", replace=MM, setup=MILL,
    program="""
        %1
        N10 G22
        N20 G01 X10000 F20000
        N30 M30
    """,
    moves="F X10",
    time=30,
)
case(
    "HNC: G20 at the head makes X1 an inch",
    control="hnc-21m", source="source 003, G20", **SOURCE,
    program="""
        %1
        N10 G20
        N20 G00 X1
        N30 M30
    """,
    moves="R X25.4",
)
case(
    "G22 of a FANUC is the stroke check and no unit, also after a move",
    control=["fanuc-0i-f", "fanuc-16i", "fanuc-30i"], source="general knowledge",
    evidence="inferred", replace=MM, setup=MILL,
    program="""
        O1
        N10 G00 X10
        N20 G22 X100 Y100 Z50 I0 J0 K0
        N30 G00 X20
        N40 M30
    """,
    moves="""
        R X10
        R X20
    """,
)

# Travel, threads
case(
    "an arc whose ends are inside the travel alarms where its way is not",
    control=["fanuc-0i-f", "mitsubishi-m700", "hnc-21m"], source="general knowledge",
    evidence="inferred", replace=MM, setup=MILL | {"limits": {"X": (-100, 45)}},
    program="""
        O1
        N10 G00 X40 Y-30
        N20 G03 Y30 I-40 J30 F100
        N30 M30
    """,
    runs="N10", alarm="over-travel", at="O1 N20", word="G03",
    number={"fanuc-0i-f": "OT0500", "mitsubishi-m700": "M01 0007", "hnc-21m": None},
)
case(
    "the travel is that of the machine, with the zero point in it",
    control=["fanuc-0i-f", "mitsubishi-m700", "hnc-21m"], source="general knowledge",
    evidence="inferred", replace=MM,
    setup=MILL | {"limits": {"X": (-100, 100)}, "work_offsets": {"G54": {"X": 60}}},
    program="""
        O1
        N10 G00 X40
        N20 G00 X40.5
        N30 M30
    """,
    runs="N10", alarm="over-travel", at="O1 N20", word="X40.5",
    number={"fanuc-0i-f": "OT0500", "mitsubishi-m700": "M01 0007", "hnc-21m": None},
)

# The contours of source 001 stand in the given rows with every X and Z.
case(
    "method 2 with M98 to its own lines cuts the contour down to X46",
    control="gsk-928te", source="source 001, method 2, P0080 for the misprint P0060",
    evidence="inferred", replace=MM, setup={"machine": "lathe-a"},
    program="""
        O1
        N0030 G0 X66 Z15 F500
        N0040 M98 P0080 L5
        N0050 G0 X100 Z50
        N0070 M02
        N0080 G0 U-4
        N0090 G01 Z-10 F80
        N0100 U20 Z-25
        N0110 Z-35
        N0120 G0 U2 Z1
        N0130 U-22
        N0140 M99
    """,
    moves="R X66 Z15"
    + "".join(
        f"""
        R X{x} Z{15 if x == 62 else 1}
        F X{x} Z-10
        F X{x + 20} Z-25
        F X{x + 20} Z-35
        R X{x + 22} Z1
        R X{x} Z1"""
        for x in (62, 58, 54, 50, 46)
    )
    + """
        R X100 Z50
    """,
)
