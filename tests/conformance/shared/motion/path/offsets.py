"""Offsets and feeds that meet something else: noses, limits of arcs, G53, spindles, profiles."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MM = {"whole_numbers": "millimetres"}
MILL = {"machine": "mill"}
LATHE = {"machine": "lathe-a"}

case(
    "tip 0 of a nose of 2 mm lies where the program says, the nose beside the part",
    control=FANUC, source="general knowledge, the imaginary tip", evidence="inferred", replace=MM,
    setup=LATHE | {"tools": {1: {"R": 2, "tip": 0}}},
    program="O1\nN10 T0101 G0 G42 X10 Z5\nN20 G98 G1 Z-10 F600\nN30 X20\nN40 G40 X30\nN50 M30",
    centre="X14 Z5 | X14 Z-8 | X20 Z-8 | X30 Z-10",
)
case(
    "tip 2 of a nose of 2 mm lies where the program says, the nose beside the part",
    control=FANUC, source="general knowledge, the imaginary tip", evidence="inferred", replace=MM,
    setup=LATHE | {"tools": {1: {"R": 2, "tip": 2}}},
    program="O1\nN10 T0101 G0 G42 X10 Z5\nN20 G98 G1 Z-10 F600\nN30 X20\nN40 G40 X30\nN50 M30",
    centre="X18 Z3 | X18 Z-10 | X24 Z-10 | X30 Z-10",
)
case(
    "tip 3 of a nose of 2 mm lies where the program says, the nose beside the part",
    control=FANUC, source="general knowledge, the imaginary tip", evidence="inferred", replace=MM,
    setup=LATHE | {"tools": {1: {"R": 2, "tip": 3}}},
    program="O1\nN10 T0101 G0 G42 X10 Z5\nN20 G98 G1 Z-10 F600\nN30 X20\nN40 G40 X30\nN50 M30",
    centre="X10 Z3 | X10 Z-10 | X16 Z-10 | X30 Z-10",
)
case(
    "an arc reaches as far as the length offset carries it",
    control="fanuc-30i", source="general knowledge", evidence="inferred",
    # The arc bulges by 10 in Z, and the tool is 20 long.
    replace=MM, setup=MILL | {"length_offsets": {1: 20}, "limits": {"Z": (-100, 25)}},
    program="""
        O1
        N10 G90 G18 G43 H1 G1 X0 Z0 F600
        N20 G2 X20 Z0 R10
        N30 G3 X40 Z0 R10
        N40 M30
    """,
    runs="N10 N20", alarm="over-travel", number="OT0500", at="O1 N30", word="Z0",
)
case(
    "G53 goes without the radius offset, and the moves after it have it again",
    control="fanuc-30i", source="general knowledge, G53", evidence="inferred",
    replace=MM, setup=MILL | {"radius_offsets": {1: 2}},
    program="""
        O1
        N10 G90 G41 D1 G1 X0 Y10 F600
        N20 Y20
        N30 G53 X0 Y50
        N40 G1 Y60
        N50 Y70
        N60 G40 X10
        N70 M30
    """,
    centre="X-2 Y10 | X-2 Y20 | X0 Y50 | X-2 Y60 | X-2 Y70 | X10 Y70",
)
case(
    "a zero point that a program writes counts at once",
    control=FANUC, source="general knowledge, #5221", evidence="inferred",
    replace=MM, setup=MILL,
    program="""
        O1
        N10 #5221=10
        N20 G90 G0 X0
        N30 M30
    """,
    final_machine="X10",
)
case(
    "#4011 is G51 while a scaling is on",
    control=["fanuc-16i", "fanuc-0i-f", "fanuc-30i"],
    source="general knowledge, #4001 to #4022", evidence="inferred",
    setup=MILL,
    program="""
        O1
        N10 #100=#4011
        N20 G51 X0 Y0 P2000
        N30 #101=#4011
        N40 M30
    """,
    vars={100: 50, 101: 51},
)
case(
    "a thread alarms when M3 has no speed",
    pins="refuses:spindle-stopped",
    control=["gsk-988ta", "gsk-988t"], source="Talm 102", evidence="secondary",
    program="O1\nN10 G0 X20 Z5\nN20 M3\nN30 G32 Z-10 F1\nN40 M30\n",
    runs="N10 N20", alarm="spindle-stopped", number="102", at="O1 N30", word="G32",
)
case(
    "every F per revolution takes its own time",
    control=["gsk-988ta", "fanuc-0i-f"], source="general knowledge", evidence="inferred",
    replace=MM, setup=LATHE,
    program="""
        O1
        N10 G99 G97 S1000 M3
        N20 G0 X100 Z0
        N30 G1 Z-10 F0.1
        N40 Z-20 F0.2
        N50 Z-30
        N60 M30
    """,
    moves="R X100 Z0\nF Z-10\nF Z-20\nF Z-30", time=0.3 + 6 + 3 + 3,
)
case(
    "#3001 goes on with the time of a feed per revolution",
    control=FANUC, source="general knowledge, #3001", evidence="inferred",
    replace=MM, setup=LATHE,
    # 10 mm at 200 mm/min are three seconds; each reading of the clock is one more thousandth.
    program="""
        O1
        N10 G99 G97 S1000 M3
        N20 G1 X100 Z0 F0.1
        N30 #3001=0
        N40 Z-10 F0.2
        N50 #100=#3001
        N60 M30
    """,
    vars={100: 3001},
)
case(
    "the last block of a profile has no corner to cut",
    control="fanuc-0i-f", source="ALM 051", evidence="secondary",
    replace=MM, setup=LATHE,
    program="""
        O1
        N10 G98 G0 X40 Z2
        N20 G71 U5 R1
        N30 G71 P40 Q60 F100
        N40 G0 X10
        N50 G1 Z-10
        N60 X30 ,C1
        N70 Z-20
        N80 M30
    """,
    runs="N10 N20", alarm="corner-no-move", number="PS0051", at="O1 N60", word=",C1",
)
