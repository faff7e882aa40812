"""Probing: what the variables of positions include, on every control that has them, and where a skip
signal ends a move.
"""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
T988 = ["gsk-988ta", "gsk-988t"]
MM = {"3401#0": 1}
MILL = {"machine": "mill"}
LATHE = {"machine": "lathe-a"}
INCLUDED = "NCT 99M p.183 and Yasnac LX3 p.84, clones: the tool is included; general knowledge"

# Positions and the tool length

LENGTH = MILL | {
    "start": {"X": 0, "Y": 0, "Z": 100}, "length_offsets": {1: 100, 2: 5},
    "work_offsets": {"G54": {"Z": -300}, "EXT": {"Z": 7}, "G55": {"Z": -200}},
}
for sign, length in ("G43", 100), ("G44", -100):
    case(
        f"#5063 has the tool length of {sign} in it, as #5043 has, and #5003 has not",
        control=[*FANUC, *MITSUBISHI], source=INCLUDED, evidence="secondary",
        params=MM, setup=LENGTH,
        program=f"""
            O1
            N10 G90 {sign} H1 Z100. F100
            N20 G31 Z-10. F100
            N30 #100=#5003
            N40 #101=#5043
            N50 #102=#5063
            N60 #103=#5023
            N70 #104=#5063-[#5043-#5003]
            N80 M30
        """,
        vars={100: -10, 101: length - 10, 102: length - 10, 103: length - 303, 104: -10},
    )
case(
    "#5063 without a tool length is the point itself",
    control=[*FANUC, *MITSUBISHI], source=INCLUDED, evidence="secondary",
    params=MM, setup=LENGTH, inputs={"skips": [0.5]},
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
    params=MM, setup=LENGTH, inputs={"skips": [0.5]},
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
    params=MM, setup=LENGTH, inputs={"skips": [0.5]},
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
    params=MM, setup=MILL | {"start": {"Z": 25.4}, "length_offsets": {1: 12.7}},
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
    params=MM, setup=LENGTH,
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
    params=MM, setup=LENGTH, inputs={"skips": [0.5]},
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
for _number in 5009, 5069, 5070, 100151:
    case(
        f"#{_number} exists on the 30i only",
        control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f"], source="ZAP, #5001 to #5068",
        evidence="secondary",
        program=f"O1\nN10 G0 X1.\nN20 #100=#{_number}\nN30 M30\n",
        runs="N10", alarm="illegal-variable", at="O1 N20",
        number={"fanuc-16i": "115", "fanuc-0i-d": "PS0115", "fanuc-0i-f": "PS0115"},
    )

# Positions of a lathe: X is a diameter, and the axes count X Z Y.

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
    "the 980TDi keeps the position of a skip signal in #997, #998 and #999",
    control="gsk-980tdi", source="TDi p.94, 3.16.2", evidence="maker's manual",
    setup={"start": {"X": 100, "Y": 8, "Z": 50}}, inputs={"skips": [0.5]},
    variables={997: 1, 998: 2, 999: 3},
    program="""
        O1
        N10 G98 G31 X20. Z10. F100
        N20 M30
    """,
    vars={997: 60, 998: 30, 999: 8},
)
case(
    "without a signal the 980TDi leaves #997 to #999 as they were",
    control="gsk-980tdi", source="TDi p.94, 3.16.2: the signal stores it", evidence="maker's manual",
    setup={"start": {"X": 100, "Z": 50}}, inputs={"skips": []},
    variables={997: 1, 998: 2, 999: 3},
    program="""
        O1
        N10 G98 G31 X20. Z10. F100
        N20 M30
    """,
    vars={997: 1, 998: 2, 999: 3},
)
case(
    "G31 leaves #1 and #997 alone where #5061 holds the position",
    control=["gsk-988ta", "gsk-988t", "gsk-980mdi", *FANUC, *MITSUBISHI], source="TA p.55",
    evidence="secondary",
    setup={"start": {"X": 100, "Z": 50}}, inputs={"skips": [0.5]}, variables={1: 7, 997: 1},
    program="""
        O1
        N10 G31 X20. Z10. F100
        N20 M30
    """,
    vars={1: 7, 997: 1},
)
for _control, _number in ("gsk-980tdi", "111"), ("gsk-980mdi", "111"):
    case(
        f"no #5061 is known of the {_control[4:]}",
        control=_control, source="TDi 28, variables", evidence="maker's manual",
        program="O1\nN10 G0 X1.\nN20 #100=#5061\nN30 M30\n",
        runs="N10", alarm="illegal-variable", number=_number, at="O1 N20",
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
