"""Probing: what the variables of positions include, on every control that has them, and where a
skip signal ends a move.
"""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
T988 = ["gsk-988ta", "gsk-988t"]
MM = {"whole_numbers": "millimetres"}
MILL = {"machine": "mill"}
LATHE = {"machine": "lathe-a"}
INCLUDED = "NCT 99M p.183 and Yasnac LX3 p.84, clones: the tool is included; general knowledge"

# Positions and the tool length
LENGTH = MILL | {
    "start": {"X": 0, "Y": 0, "Z": 100}, "length_offsets": {1: 100, 2: 5},
    "work_offsets": {"G54": {"Z": -300}, "EXT": {"Z": 7}, "G55": {"Z": -200}},
}

case(
    "#5063 has the tool length of G43 in it, as #5043 has, and #5003 has not",
    control=[*FANUC, *MITSUBISHI], source=INCLUDED, evidence="secondary", replace=MM, setup=LENGTH,
    program="""
        O1
        N10 G90 G43 H1 Z100. F100
        N20 G31 Z-10. F100
        N30 #100=#5003
        N40 #101=#5043
        N50 #102=#5063
        N60 #103=#5023
        N70 #104=#5063-[#5043-#5003]
        N80 M30
    """,
    vars={100: -10, 101: 90, 102: 90, 103: -203, 104: -10},
)
case(
    "#5063 has the tool length of G44 in it, as #5043 has, and #5003 has not",
    control=[*FANUC, *MITSUBISHI], source=INCLUDED, evidence="secondary", replace=MM, setup=LENGTH,
    program="""
        O1
        N10 G90 G44 H1 Z100. F100
        N20 G31 Z-10. F100
        N30 #100=#5003
        N40 #101=#5043
        N50 #102=#5063
        N60 #103=#5023
        N70 #104=#5063-[#5043-#5003]
        N80 M30
    """,
    vars={100: -10, 101: -110, 102: -110, 103: -403, 104: -10},
)
case(
    "#5063 without a tool length is the point itself",
    control=[*FANUC, *MITSUBISHI], source=INCLUDED, evidence="secondary",
    replace=MM, setup=LENGTH, inputs={"skips": [0.5]},
    program="""
        O1
        N10 G90 G43 H1 G0 Z100.
        N20 G49 Z100.
        N30 G31 Z0 F100
        N40 #100=#5003
        N50 #101=#5063
        N60 M30
    """,
    vars={100: 50, 101: 50},
)
case(
    "#5063 keeps the tool length that was in force at the signal",
    control=[*FANUC, *MITSUBISHI], source=INCLUDED, evidence="secondary",
    replace=MM, setup=LENGTH, inputs={"skips": [0.5]},
    program="""
        O1
        N10 G90 G43 H1 G0 Z100.
        N20 G31 Z0 F100
        N30 G0 G43 H2 Z80.
        N40 #100=#5063
        N50 #101=#5043
        N60 M30
    """,
    vars={100: 150, 101: 85},
)
case(
    "work zero points, G52 and EXT are not in #5003, #5043 and #5063, and all of them are in #5023",
    control=[*FANUC, *MITSUBISHI], source=INCLUDED, evidence="secondary",
    replace=MM, setup=LENGTH, inputs={"skips": [0.5]},
    program="""
        O1
        N10 G90 G55 G43 H2 G0 Z20.
        N20 G52 Z1.
        N30 G31 Z0 F100
        N40 #100=#5003
        N50 #101=#5043
        N60 #102=#5063
        N70 #103=#5023
        N80 M30
    """,
    vars={100: 9.5, 101: 14.5, 102: 14.5, 103: 14.5 + 1 - 200 + 7},
)
case(
    "positions are read in the unit of the program, the tool length too",
    control=[*FANUC, *MITSUBISHI], source="general knowledge", evidence="inferred",
    replace=MM, setup=MILL | {"start": {"Z": 25.4}, "length_offsets": {1: 12.7}},
    inputs={"skips": [0.5]},
    program="""
        O1
        N10 G20 G90 G43 H1 G0 Z1.
        N20 G31 Z0 F10.
        N30 #100=#5003
        N40 #101=#5063
        N50 #102=#5023
        N60 M30
    """,
    vars={100: 0.5, 101: 1, 102: 1},
)
case(
    "#5083 is the tool length in force",
    control=FANUC, source="ZAP, #5081", evidence="secondary",
    replace=MM, setup=LENGTH,
    program="""
        O1
        N10 G90 G43 H1 G0 Z100.
        N20 #100=#5083
        N30 #101=#5081
        N40 G49
        N50 #102=#5083
        N60 M30
    """,
    vars={100: 100, 101: 0, 102: 0},
)
case(
    "a Mitsubishi has no #5083",
    control=MITSUBISHI, source="general knowledge, the table of positions", evidence="inferred",
    setup=LENGTH,
    program="""
        O1
        N10 G90 G43 H1 G0 Z100.
        N20 #100=#5083
        N30 M30
    """,
    runs="N10", alarm="illegal-variable", number="P241", at="O1 N20",
)
case(
    "the 30i has the positions of 20 axes, and once more from #100001 on",
    control="fanuc-30i", source="15iM p.564: #5061 to #5080, #100151 and on", evidence="secondary",
    replace=MM, setup=LENGTH, inputs={"skips": [0.5]},
    program="""
        O1
        N10 G90 G43 H1 G0 Z100.
        N20 G31 Z0 F100
        N30 #100=#100003
        N40 #101=#100053
        N50 #102=#100103
        N60 #103=#100153
        N70 #104=#100203
        N80 #105=#5069+#5020+#5040+#5060+#5080+#5100+#5120
        N90 M30
    """,
    vars={100: 50, 101: -143, 102: 150, 103: 150, 104: 100, 105: 0},
)
case(
    "#5009 exists on the 30i only",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f"], source="ZAP, #5001 to #5068",
    evidence="secondary",
    program="O1\nN10 G0 X1.\nN20 #100=#5009\nN30 M30\n",
    runs="N10", alarm="illegal-variable", at="O1 N20",
    number={"fanuc-16i": "115", "fanuc-0i-d": "PS0115", "fanuc-0i-f": "PS0115"},
)
case(
    "#5069 exists on the 30i only",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f"], source="ZAP, #5001 to #5068",
    evidence="secondary",
    program="O1\nN10 G0 X1.\nN20 #100=#5069\nN30 M30\n",
    runs="N10", alarm="illegal-variable", at="O1 N20",
    number={"fanuc-16i": "115", "fanuc-0i-d": "PS0115", "fanuc-0i-f": "PS0115"},
)
case(
    "#5070 exists on the 30i only",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f"], source="ZAP, #5001 to #5068",
    evidence="secondary",
    program="O1\nN10 G0 X1.\nN20 #100=#5070\nN30 M30\n",
    runs="N10", alarm="illegal-variable", at="O1 N20",
    number={"fanuc-16i": "115", "fanuc-0i-d": "PS0115", "fanuc-0i-f": "PS0115"},
)
case(
    "#100151 exists on the 30i only",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f"], source="ZAP, #5001 to #5068",
    evidence="secondary",
    program="O1\nN10 G0 X1.\nN20 #100=#100151\nN30 M30\n",
    runs="N10", alarm="illegal-variable", at="O1 N20",
    number={"fanuc-16i": "115", "fanuc-0i-d": "PS0115", "fanuc-0i-f": "PS0115"},
)

# Positions of a lathe: X is a diameter, and the order of the axes is X Z Y.
TOOL = {"tools": {1: {"X": 6, "Z": 20, "R": 0.4, "tip": 3}}}

case(
    "positions of a lathe are diameters in the order X Z Y",
    control=[*FANUC, *MITSUBISHI, *T988], source="cases/motion.md M530; TA p.55: the n-th axis",
    evidence="secondary",
    setup=LATHE | {"start": {"X": 100, "Z": 50}}, inputs={"skips": [0.5]},
    program="""
        O1
        N10 G0 X80. Z40.
        N20 G98 G31 X20. Z10. F100
        N30 #100=#5001
        N40 #101=#5002
        N50 #102=#5061
        N60 #103=#5062
        N70 M30
    """,
    vars={100: 50, 101: 25, 102: 50, 103: 25},
)
case(
    "a tool offset that shifts the coordinates is in the machine position and in no other",
    control=[*FANUC, *MITSUBISHI, *T988], source="TA 27; general knowledge", evidence="inferred",
    setup=LATHE | TOOL | {"start": {"X": 100, "Z": 50}}, inputs={"skips": [0.5]},
    program="""
        O1
        N10 G98 T0101 G0 X80. Z40.
        N20 G31 X20. Z10. F100
        N30 #100=#5001
        N40 #101=#5062
        N50 #102=#5041
        N60 #103=#5021
        N70 #104=#5022
        N80 M30
    """,
    vars={100: 50, 101: 25, 102: 50, 103: 56, 104: 45},
)
case(
    "a tool offset that moves the tool is in the skip position too",
    control=T988, source="TApar 5002#4; the position with the tool: " + INCLUDED,
    evidence="secondary", params={"5002#4": 1},
    setup=LATHE | TOOL | {"start": {"X": 100, "Z": 50}}, inputs={"skips": [0.5]},
    program="""
        O1
        N10 G98 T0101 G0 X80. Z40.
        N20 G31 X20. Z10. F100
        N30 #100=#5001
        N40 #101=#5041
        N50 #102=#5061
        N60 #103=#5062
        N70 M30
    """,
    vars={100: 50, 101: 56, 102: 56, 103: 45},
)
case(
    "the 980TDi keeps the position of a skip signal in #995 to #999",
    pins="skip_variables",
    control="gsk-980tdi", source="TDi p.94, 3.16.2: X, Z, Y, the 4th and the 5th axis",
    evidence="maker's manual",
    setup={"start": {"X": 100, "Y": 8, "Z": 50}}, inputs={"skips": [0.5]},
    variables={995: 1, 996: 2, 997: 3, 998: 4, 999: 5},
    program="""
        O1
        N10 G98 G31 X20. Z10. F100
        N20 M30
    """,
    vars={995: 60, 996: 30, 997: 8, 998: 0, 999: 0},
)
case(
    "without a signal the 980TDi leaves #995 to #999 as they were",
    control="gsk-980tdi", source="TDi p.94, 3.16.2: the signal stores it", evidence="maker's manual",
    setup={"start": {"X": 100, "Z": 50}}, inputs={"skips": []},
    variables={995: 1, 996: 2, 999: 3},
    program="""
        O1
        N10 G98 G31 X20. Z10. F100
        N20 M30
    """,
    vars={995: 1, 996: 2, 999: 3},
)
case(
    "G31 leaves #1 and #995 alone where #5061 holds the position",
    pins="skip_variables",
    control=["gsk-988ta", "gsk-988t", "gsk-980mdi", *FANUC, *MITSUBISHI, "haas-ngc"], source="TA p.55",
    evidence="secondary",
    setup={"start": {"X": 100, "Z": 50}}, inputs={"skips": [0.5]}, variables={1: 7, 995: 1},
    program="""
        O1
        N10 G98 G31 X20. Z10. F100
        N20 M30
    """,
    vars={1: 7, 995: 1},
)
case(
    "no #5061 is known of the 980tdi",
    control="gsk-980tdi", source="TDi 28, variables", evidence="maker's manual",
    program="O1\nN10 G0 X1.\nN20 #100=#5061\nN30 M30\n",
    runs="N10", alarm="illegal-variable", number="0111", at="O1 N20",
)
case(
    "no #5061 is known of the 980mdi",
    control="gsk-980mdi", source="TDi 28, variables", evidence="maker's manual",
    program="O1\nN10 G0 X1.\nN20 #100=#5061\nN30 M30\n",
    runs="N10", alarm="illegal-variable", number="0111", at="O1 N20",
)
case(
    "nobody writes a position",
    control=[*FANUC, *MITSUBISHI, *T988], source="ZAP, #5001 to #5068; general knowledge",
    evidence="inferred",
    program="O1\nN10 G0 X1.\nN20 #5063=1.\nN30 M30\n",
    runs="N10", alarm="variable-write-protected", at="O1 N20",
    number={
        "fanuc-16i": "116", "fanuc-0i-d": "PS0116", "fanuc-0i-f": "PS0116", "fanuc-30i": "PS0116",
        "mitsubishi-meldas": "P243", "mitsubishi-m700": "P243", "mitsubishi-m800": "P243",
        "gsk-988ta": "220", "gsk-988t": "220",
    },
)

# The place of the signal
START = {"start": {"X": 0, "Y": 0, "Z": 0}}
SKIP = "15iM p.564; M7 p.547"

case(
    "a skip told as a coordinate stops the move there",
    control=[*FANUC, *MITSUBISHI], source=SKIP, evidence="secondary",
    replace=MM, setup=MILL | START, inputs={"skips": [{"X": 40}, {"Y": 7.5}, {"x": 41}]},
    program="""
        O1
        N10 G90 G31 X100. F100
        N20 G31 X60. Y15. F100
        N30 G31 X70. F100
        N40 M30
    """,
    moves="F X40\nF X50 Y7.5\nF X70",
)
case(
    "a coordinate that the way does not reach is met by nothing",
    control=[*FANUC, *MITSUBISHI], source="policy, what is not met", evidence="inferred",
    replace=MM, setup=MILL | START,
    inputs={"skips": [{"X": 100.5}, {"X": 99}, {"Y": 1}, {"X": 110}, {"X": 111}]},
    program="""
        O1
        N10 G90 G31 X100. F100
        N20 G31 X101. F100
        N30 G31 X102. F100
        N40 G31 X110. F100
        N50 G31 X115. F100
        N60 M30
    """,
    moves_x=[100, 101, 102, 110, 111],
)
case(
    "a signal that is on when the move begins ends it at once",
    control=[*FANUC, *MITSUBISHI, *T988], source="M7 p.547 (5); TA p.55: the state counts",
    evidence="secondary", replace=MM, setup=START, inputs={"skips": [{"X": 0}]},
    program="""
        O1
        N10 G98 G31 X100. F100
        N20 G4 P1
        N30 M30
    """,
    moves="F X0\nW 0.001",
)
case(
    "the way that a skip signal cut off is dropped, and increments count from where the move stopped",
    control=[*FANUC, *MITSUBISHI], source=SKIP, evidence="secondary",
    replace=MM, setup=MILL | START, inputs={"skips": [{"X": 40}, {"X": 30}]},
    program="""
        O1
        N10 G91 G31 X100. Y10. F100
        N20 G1 X-5. F100
        N30 G31 X-50. F100
        N40 G90 G1 Y20. F100
        N50 M30
    """,
    moves="F X40 Y4\nF X35\nF X30\nF Y20",
)
case(
    "a lathe's increments count from where the signal came",
    control=T988, source="TA p.54: the next block in increments", evidence="secondary",
    setup={"start": {"X": 100, "Z": 50}}, inputs={"skips": [{"Z": 20}]},
    program="""
        O1
        N10 G98 G31 W-50. F100
        N20 G1 U-10. W-5.
        N30 M30
    """,
    moves="F Z20\nF X90 Z15",
)

# The feed of G31, and its signals
case(
    "F of G31 on a Mitsubishi is of its block alone",
    pins="skip_own_feed",
    control=MITSUBISHI, source="M7 p.547 (1): the F modal is not updated", evidence="secondary",
    replace=MM, setup=MILL | START,
    program="""
        O1
        N10 G90 G1 X10. F600
        N20 G31 X20. F60
        N30 G1 X30.
        N40 #100=#4109
        N50 M30
    """,
    moves="F X10\nF X20\nF X30", time=1 + 10 + 1, vars={100: 600},
)
case(
    "F of G31 holds for the blocks after it",
    pins="skip_own_feed",
    control=[*FANUC, "gsk-980mdi"], source="15iM p.564: F in or before the block; general knowledge",
    evidence="inferred", replace=MM, setup=START,
    program="""
        O1
        N10 G90 G1 X10. F600
        N20 G31 X20. F60
        N30 G1 X30.
        N40 G31 X40.
        N50 M30
    """,
    moves="F X10\nF X20\nF X30\nF X40", time=1 + 10 + 10 + 10,
)
case(
    "F of G31 holds for the blocks after it on a lathe",
    pins="skip_own_feed",
    control=[*T988, "gsk-980tdi", "haas-ngc"], source="TA p.54 and TDi p.93: as G01", evidence="secondary",
    setup={"start": {"X": 0, "Z": 0}},
    program="""
        O1
        N10 G98 G1 Z10. F600
        N20 G31 Z20. F60
        N30 G1 Z30.
        N40 M30
    """,
    moves="F Z10\nF Z20\nF Z30", time=1 + 10 + 10,
)
case(
    "G31 of a Mitsubishi without F alarms, whatever feed is in force",
    control=MITSUBISHI, source="M7 p.547 (7), p.552 (3)", evidence="secondary", replace=MM,
    setup=MILL | START,
    program="O1\nN10 G90 G1 X10. F600\nN20 G31 X20. F60\nN30 G31 X30.\nN40 M30",
    runs="N10 N20", alarm="no-skip-feed", number="P603", at="O1 N30", word="G31",
)
case(
    "1174 is the feed of G31 without F",
    control=MITSUBISHI, source="M7 p.547 (1), p.552 (1)", evidence="secondary",
    params={"1174": 120}, replace=MM, setup=MILL | START, inputs={"skips": [{"X": 20}]},
    program="O1\nN10 G90 G1 X10. F600\nN20 G31 X30.\nN30 G1 X30.\nN40 M30",
    moves="F X10\nF X20\nF X30", time=7,
)
case(
    "G31 of a Mitsubishi may not stand in radius compensation",
    control=MITSUBISHI, source="M7 p.547 (6), p.552 (3)", evidence="secondary", replace=MM,
    setup=MILL | START | {"radius_offsets": {1: 1}},
    program="O1\nN10 G90 G41 D1 G1 Y10. F100\nN20 X20.\nN30 G31 X30. F50\nN40 M30",
    runs="N10 N20", alarm="skip-in-offset", number="P608", at="O1 N30", word="G31",
)
case(
    "G31.1 of a Mitsubishi without F alarms, whatever feed is in force",
    control=MITSUBISHI, source="M7 p.547 (7), p.552 (3)", evidence="secondary", replace=MM,
    setup=MILL | START,
    program="O1\nN10 G90 G1 X10. F600\nN20 G31.1 X20. F60\nN30 G31.1 X30.\nN40 M30",
    runs="N10 N20", alarm="no-skip-feed", number="P603", at="O1 N30", word="G31.1",
)
case(
    "1176 is the feed of G31.1 without F",
    control=MITSUBISHI, source="M7 p.547 (1), p.552 (1)", evidence="secondary",
    params={"1176": 120}, replace=MM, setup=MILL | START, inputs={"skips": [{"X": 20}]},
    program="O1\nN10 G90 G1 X10. F600\nN20 G31.1 X30.\nN30 G1 X30.\nN40 M30",
    moves="F X10\nF X20\nF X30", time=7,
)
case(
    "G31.1 of a Mitsubishi may not stand in radius compensation",
    control=MITSUBISHI, source="M7 p.547 (6), p.552 (3)", evidence="secondary", replace=MM,
    setup=MILL | START | {"radius_offsets": {1: 1}},
    program="O1\nN10 G90 G41 D1 G1 Y10. F100\nN20 X20.\nN30 G31.1 X30. F50\nN40 M30",
    runs="N10 N20", alarm="skip-in-offset", number="P608", at="O1 N30", word="G31.1",
)
case(
    "G31.2 of a Mitsubishi without F alarms, whatever feed is in force",
    control=MITSUBISHI, source="M7 p.547 (7), p.552 (3)", evidence="secondary", replace=MM,
    setup=MILL | START,
    program="O1\nN10 G90 G1 X10. F600\nN20 G31.2 X20. F60\nN30 G31.2 X30.\nN40 M30",
    runs="N10 N20", alarm="no-skip-feed", number="P603", at="O1 N30", word="G31.2",
)
case(
    "1178 is the feed of G31.2 without F",
    control=MITSUBISHI, source="M7 p.547 (1), p.552 (1)", evidence="secondary",
    params={"1178": 120}, replace=MM, setup=MILL | START, inputs={"skips": [{"X": 20}]},
    program="O1\nN10 G90 G1 X10. F600\nN20 G31.2 X30.\nN30 G1 X30.\nN40 M30",
    moves="F X10\nF X20\nF X30", time=7,
)
case(
    "G31.2 of a Mitsubishi may not stand in radius compensation",
    control=MITSUBISHI, source="M7 p.547 (6), p.552 (3)", evidence="secondary", replace=MM,
    setup=MILL | START | {"radius_offsets": {1: 1}},
    program="O1\nN10 G90 G41 D1 G1 Y10. F100\nN20 X20.\nN30 G31.2 X30. F50\nN40 M30",
    runs="N10 N20", alarm="skip-in-offset", number="P608", at="O1 N30", word="G31.2",
)
case(
    "G31.3 of a Mitsubishi without F alarms, whatever feed is in force",
    control=MITSUBISHI, source="M7 p.547 (7), p.552 (3)", evidence="secondary", replace=MM,
    setup=MILL | START,
    program="O1\nN10 G90 G1 X10. F600\nN20 G31.3 X20. F60\nN30 G31.3 X30.\nN40 M30",
    runs="N10 N20", alarm="no-skip-feed", number="P603", at="O1 N30", word="G31.3",
)
case(
    "1180 is the feed of G31.3 without F",
    control=MITSUBISHI, source="M7 p.547 (1), p.552 (1)", evidence="secondary",
    params={"1180": 120}, replace=MM, setup=MILL | START, inputs={"skips": [{"X": 20}]},
    program="O1\nN10 G90 G1 X10. F600\nN20 G31.3 X30.\nN30 G1 X30.\nN40 M30",
    moves="F X10\nF X20\nF X30", time=7,
)
case(
    "G31.3 of a Mitsubishi may not stand in radius compensation",
    control=MITSUBISHI, source="M7 p.547 (6), p.552 (3)", evidence="secondary", replace=MM,
    setup=MILL | START | {"radius_offsets": {1: 1}},
    program="O1\nN10 G90 G41 D1 G1 Y10. F100\nN20 X20.\nN30 G31.3 X30. F50\nN40 M30",
    runs="N10 N20", alarm="skip-in-offset", number="P608", at="O1 N30", word="G31.3",
)
case(
    "P0 of G31 is out of range on a Mitsubishi",
    pins="max_skip_signals", control=MITSUBISHI, source="M7 p.555 (2), (5)", evidence="secondary",
    replace=MM, setup=MILL | START,
    program="O1\nN10 G90 G31 X10. P255 F100\nN20 G31 X20. P0 F100\nN30 M30",
    runs="N10", alarm="value-out-of-range", word="P0", number="P35", at="O1 N20",
)
case(
    "P256 of G31 is out of range on a Mitsubishi",
    pins="max_skip_signals", control=MITSUBISHI, source="M7 p.555 (2), (5)", evidence="secondary",
    replace=MM, setup=MILL | START,
    program="O1\nN10 G90 G31 X10. P255 F100\nN20 G31 X20. P256 F100\nN30 M30",
    runs="N10", alarm="value-out-of-range", word="P256", number="P35", at="O1 N20",
)
case(
    "P500 of G31 is out of range on a Mitsubishi",
    pins="max_skip_signals", control=MITSUBISHI, source="M7 p.555 (2), (5)", evidence="secondary",
    replace=MM, setup=MILL | START,
    program="O1\nN10 G90 G31 X10. P255 F100\nN20 G31 X20. P500 F100\nN30 M30",
    runs="N10", alarm="value-out-of-range", word="P500", number="P35", at="O1 N20",
)
case(
    "what is told of every signal stops a G31 whatever its P",
    pins="max_skip_signals",
    control=[*FANUC, *T988, "gsk-980tdi", "gsk-980mdi"], source="general knowledge, multi-step skip",
    evidence="inferred", replace=MM, setup=START, inputs={"skips": [{"Z": -5}, {"Z": -7}]},
    program="""
        O1
        N10 G98 G31 Z-10. P4 F100
        N20 G31 Z-12. P1 F100
        N30 M30
    """,
    moves="F Z-5\nF Z-7",
)

NUMBERED = [*T988, "gsk-980tdi", "gsk-980mdi"]
APART = {"skips": {1: [{"Z": -5}, {"Z": -20}], 2: [{"Z": -7}], 4: [None]}}
APART_PROGRAM = """
    O1
    N10 G98 G31 Z-10. P2 F100
    N20 G31 Z-12. P4 F100
    N30 G31 Z-18. F100
    N40 G31 Z-25. P1 F100
    N50 G31 Z-28. P2 F100
    N60 G31 Z-30. P3 F100
    N70 M30
"""

case(
    "P of G31 names the signal that ends it, and each signal is told by itself",
    pins="skip_signals",
    control=NUMBERED, source="TDi p.93, 3.16; MDipar 5431 to 5434; TApar 6200",
    evidence="secondary", setup=START, inputs=APART, program=APART_PROGRAM,
    moves="F Z-7\nF Z-12\nF Z-18\nF Z-20\nF Z-28\nF Z-30",
)
case(
    "6202 to 6205 say which signals end G31 P1 to P4",
    pins="skip_signals",
    control=FANUC, source="general knowledge, multi-step skip", evidence="inferred",
    replace=MM, setup=START, inputs=APART, program=APART_PROGRAM,
    moves="F Z-7\nF Z-12\nF Z-18\nF Z-20\nF Z-28\nF Z-30",
)
case(
    "a bit of 6203 more lets two signals end G31 P2, and the first of them does",
    control=FANUC, source="general knowledge, multi-step skip", evidence="inferred",
    params={"6203": 130}, replace=MM, setup=START,
    inputs={"skips": {2: [{"Z": -7}, {"Z": -9}, None], 8: [{"Z": -4}, None, {"Z": -11}]}},
    program="""
        O1
        N10 G31 Z-10. P2 F100
        N20 G31 Z-10. P2 F100
        N30 G31 Z-12. P2 F100
        N40 G31 Z-15. P1 F100
        N50 M30
    """,
    moves="F Z-4\nF Z-9\nF Z-11\nF Z-15",
)
case(
    "a G31 P2 whose 6203 has no bit is ended by nothing",
    control=FANUC, source="general knowledge, multi-step skip", evidence="inferred",
    params={"6203": 0}, replace=MM, setup=START, inputs={"skips": [{"Z": -5}, {"Z": -7}]},
    program="""
        O1
        N10 G31 Z-10. P2 F100
        N20 G0 Z0
        N30 G31 Z-10. P1 F100
        N40 M30
    """,
    moves="F Z-10\nR Z0\nF Z-5",
)
case(
    "P of G31 on a Mitsubishi is a sum: 5 is the signals 1 and 3",
    pins="skip_signals",
    control=MITSUBISHI, source="M7 p.555 (3)", evidence="secondary",
    replace=MM, setup=MILL | START,
    inputs={"skips": {1: [{"X": 9}, {"X": 15}], 2: [{"X": 1}, {"X": 19}], 3: [{"X": 5}, None]}},
    program="""
        O1
        N10 G90 G31 X10. P5 F100
        N20 G31 X18. P5 F100
        N30 G31 X17. P2 F100
        N40 G31 X20. P2 F100
        N50 G31 X25. F100
        N60 M30
    """,
    moves="F X5\nF X15\nF X17\nF X19\nF X25",
)
case(
    "G31.1, G31.2 and G31.3 watch the signals of 1175, 1177 and 1179",
    control=MITSUBISHI, source="M7 p.552 (5)", evidence="inferred",
    params={"1179": 5}, replace=MM, setup=MILL | START,
    inputs={"skips": {1: [{"X": 4}, {"X": 25}], 2: [{"X": 15}], 3: [None]}},
    program="""
        O1
        N10 G90 G31.1 X10. F100
        N20 G31.2 X20. F100
        N30 G31.3 X30. F100
        N40 M30
    """,
    moves="F X4\nF X15\nF X25",
)
case(
    "a skip signal ends G04 Q on a GSK, and G04 without Q waits its time",
    control=NUMBERED, source="TDi 14, Q; TApar 6200", evidence="secondary",
    setup=START, inputs={"skips": {2: [0.25, None, {"X": 1}], 1: [0.5]}},
    program="""
        O1
        N10 G4 P4000 Q2
        N20 G4 P1000
        N30 G4 P1000 Q2
        N40 G4 P2000 Q1
        N50 G4 P3000 Q2
        N60 M30
    """,
    moves="W 1\nW 1\nW 1\nW 1\nW 3", time=7,
)
case(
    "a skip signal ends G04 Q on a FANUC, and G04 alone where 6206 has its bit",
    control=FANUC, source="general knowledge, multi-step skip", evidence="inferred",
    params={"6206": 4}, replace=MM, setup=START, inputs={"skips": {2: [0.25], 3: [0.5, 0.1]}},
    program="""
        O1
        N10 G4 P4000 Q2
        N20 G4 P2000
        N30 G4 P1000 Q2
        N40 G4 P1000 Q3
        N50 M30
    """,
    moves="W 1\nW 1\nW 1\nW 0.1",
)
case(
    "a skip signal ends G04 of a Mitsubishi where 1173 has its bit",
    control=MITSUBISHI, source="M7 p.554", evidence="secondary",
    params={"1173": 3}, replace=MM, setup=MILL | START,
    inputs={"skips": {1: [0.5, None], 2: [None, 0.25], 3: [0, 0]}},
    program="""
        O1
        N10 G4 P2000
        N20 G4 P4000
        N30 G4 P1000
        N40 M30
    """,
    moves="W 1\nW 1\nW 1",
)
case(
    "a dwell that no signal may end takes nothing of what is told",
    control=[*FANUC, *MITSUBISHI, *NUMBERED], source="policy, scripted inputs",
    evidence="inferred", replace=MM, setup=START, inputs={"skips": [{"Z": -5}]},
    program="""
        O1
        N10 G4 P1000
        N20 G98 G31 Z-10. F100
        N30 M30
    """,
    moves="W 1\nF Z-5",
)
case(
    "the 980TDi holds the feed of G31 down to 200 mm a minute",
    pins="max_skip_feed",
    control="gsk-980tdi", source="TDi p.94, 3.16.2", evidence="maker's manual",
    setup=START, inputs={"skips": [0.5]},
    program="""
        O1
        N10 G98 G31 Z-40. F600
        N20 G1 Z-30.
        N30 G31 Z-31. F60
        N40 M30
    """,
    moves="F Z-20\nF Z-30\nF Z-31", time=6 + 1 + 1,
)
case(
    "no other control holds the feed of G31 down",
    pins="max_skip_feed",
    control=[*FANUC, *MITSUBISHI, *T988, "gsk-980mdi"],
    source="15iM p.564; M7 p.547; TA p.54", evidence="inferred",
    replace=MM, setup=MILL | START,
    program="""
        O1
        N10 G31 Z-40. F2400
        N20 M30
    """,
    moves="F Z-40", time=1,
)
case(
    "G31 P7 is out of range on the 980tdi",
    pins="max_skip_signals", control=["gsk-980tdi"],
    source="TDi p.93: P is 1 to 6; MDipar 5431 to 5434", evidence="secondary", setup=START,
    program="O1\nN10 G31 Z-10. P1 F100\nN20 G31 Z-20. P7 F100\nN30 M30",
    runs="N10", alarm="value-out-of-range", word="P7", number="0012", at="O1 N20",
)
case(
    "G31 P5 is out of range on the 980mdi",
    pins="max_skip_signals", control=["gsk-980mdi"],
    source="TDi p.93: P is 1 to 6; MDipar 5431 to 5434", evidence="secondary", setup=START,
    program="O1\nN10 G31 Z-10. P1 F100\nN20 G31 Z-20. P5 F100\nN30 M30",
    runs="N10", alarm="value-out-of-range", word="P5", number="0012", at="O1 N20",
)
case(
    "a solid with a signal stops those G31 alone that watch it",
    control=[*FANUC, *MITSUBISHI, "gsk-980mdi"], source="policy, scripted inputs",
    evidence="inferred", replace=MM, setup=MILL | START,
    inputs={"workpiece": {"solids": [
        {"box": {"X": (40, 60)}}, {"box": {"X": (20, 30)}, "signal": 2},
        {"box": {"X": (-30, -20)}, "signal": 1},
    ]}},
    program="""
        O1
        N10 G31 X100. P2 F100
        N20 G0 X35.
        N30 G31 X100. P1 F100
        N40 G0 X0
        N50 G31 X-100. P2 F100
        N60 G0 X0
        N70 G31 X-100. F100
        N80 M30
    """,
    moves="F X20\nR X35\nF X40\nR X0\nF X-100\nR X0\nF X-20",
)
case(
    "holes in a part of one signal are no walls for another",
    control=[*FANUC, *MITSUBISHI, "gsk-980mdi"], source="policy, scripted inputs",
    evidence="inferred", replace=MM, setup=MILL | START,
    inputs={"workpiece": {"solids": [
        {"box": {"X": (-60, 60)}, "signal": 2}, {"sphere": {"X": 0}, "radius": 10, "inside": True},
    ]}},
    program="""
        O1
        N10 G31 X100. P1 F100
        N20 G0 X0
        N30 G31 X100. P2 F100
        N40 M30
    """,
    moves="F X100\nR X0\nF X10",
)

# Workpieces that a stylus touches
PART = {
    "stylus": 3,
    "solids": [
        {"box": {"X": (20, 80), "Y": (-30, 30), "Z": (-20, 0)}},
        {"cylinder": {"X": 50, "Y": 0}, "radius": 10, "ends": (-20, 0), "inside": True},
    ],
}
LONG = MILL | {
    "start": {"X": 0, "Y": 0, "Z": 100}, "length_offsets": {1: 100},
    "work_offsets": {"G54": {"X": -400, "Y": -200, "Z": -300}},
}

case(
    "a stylus stops a radius before a face, whatever the zero point and the tool length are",
    control=[*FANUC, *MITSUBISHI], source=SKIP, evidence="secondary",
    replace=MM, setup=LONG, inputs={"workpiece": PART},
    program="""
        O1
        N10 G90 G43 H1 G0 Z20. F100
        N20 G0 Z-10.
        N30 G31 X100. F100
        N40 #100=#5061
        N50 #101=#5041
        N60 G0 X0
        N70 Z20.
        N80 X30.
        N90 G31 Z-50. F100
        N100 #102=#5063
        N110 #103=#5063-[#5043-#5003]
        N120 M30
    """,
    vars={100: 17, 101: 17, 102: 103, 103: 3},
)
case(
    "a stylus finds both sides of a bore",
    control=[*FANUC, *MITSUBISHI], source=SKIP, evidence="secondary",
    replace=MM, setup=LONG, inputs={"workpiece": PART},
    program="""
        O1
        N10 G90 G43 H1 G0 X51. Z20.
        N20 Z-10.
        N30 G31 X80. F100
        N40 #100=#5061
        N50 G0 X51.
        N60 G31 X20. F100
        N70 #101=#5061
        N80 #102=[#100+#101]/2
        N90 G0 X#102
        N100 G31 Y50. F100
        N110 #103=#5062
        N120 M30
    """,
    vars={100: 57, 101: 43, 102: 50, 103: 7},
)
case(
    "a G28 between does not move the workpiece",
    control=[*FANUC, *MITSUBISHI], source="policy, the workpiece stays", evidence="inferred",
    replace=MM, setup=LONG, inputs={"workpiece": PART},
    program="""
        O1
        N10 G90 G43 H1 G0 X0 Z-10.
        N20 G52 X5.
        N30 G31 X100. F100
        N40 #100=#5061
        N50 G52 X0
        N60 #5221=-390.
        N70 G0 X-20.
        N80 G31 X100. F100
        N90 #101=#5061
        N100 M30
    """,
    vars={100: 12, 101: 7},
)
case(
    "a program finds out that its probe met nothing",
    control=[*FANUC, *MITSUBISHI], source="general knowledge", evidence="inferred",
    replace=MM, setup=LONG, inputs={"workpiece": PART},
    program="""
        O1
        N10 G90 G43 H1 G0 Z20.
        N20 G31 X100. F100
        N30 IF[#5061 LT 99.9]GOTO 50
        N40 #3000=3(NO CONTACT)
        N50 M30
    """,
    runs="N10 N20 N30 N40", alarm="user-alarm", at="O1 N40",
    number={
        "fanuc-16i": "3003", "fanuc-0i-d": "MC3003", "fanuc-0i-f": "MC3003", "fanuc-30i": "MC3003",
        "mitsubishi-meldas": "P277", "mitsubishi-m700": "P277", "mitsubishi-m800": "P277",
    },
)
case(
    "a code that is answered changes a signal, and another one changes it back",
    control=[*FANUC, *MITSUBISHI, "gsk-980tdi", *T988], source="policy, scripted inputs",
    evidence="inferred",
    inputs={"answers": {"M117": {1004: 1, 500: 3}, "M118": {1004: 0}}},
    program="""
        O1
        N10 #100=#1004
        N20 M117
        N30 #101=#1004
        N40 M118
        N50 #102=#1004
        N60 #103=#500
        N70 M30
    """,
    vars={100: 0, 101: 1, 102: 0, 103: 3},
)
case(
    "a loop that waits for a signal waits where no code answers with it",
    control=[*FANUC, *MITSUBISHI], source="policy, scripted inputs", evidence="inferred",
    inputs={"answers": {"M117": {1005: 1}}},
    program="""
        O1
        N10 M117
        N20 IF[#1004 EQ 0]GOTO 20
        N30 M30
    """,
    runs="N10 (N20)*2", stop="waiting",
)
