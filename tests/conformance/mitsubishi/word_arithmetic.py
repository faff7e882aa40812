"""Mitsubishi: arithmetic after an address without brackets."""

from conformance import case

MELDAS = "mitsubishi-meldas"
M700 = "mitsubishi-m700"
M800 = "mitsubishi-m800"
EVERY = [MELDAS, M700, M800]
PRINTED = {"control": EVERY, "source": "M7 p.326, G0 X#1 + 10 Y1000", "evidence": {M700: "maker's manual"} | dict.fromkeys((MELDAS, M800), "secondary")}
ALIKE = {"control": EVERY, "source": "M7 p.326, variable quotations; arithmetic expressions", "evidence": "inferred"}

case(
    "X#1 + 10 with a vacant #1 is X10", pins="word_arithmetic", **PRINTED,
    program="O1\nN10 G0 X#1 + 10 Y1000\nN20 M30", moves="R X10 Y1000",
)
case(
    "X#5+7. goes to the sum", pins="word_arithmetic", **ALIKE,
    program="O1\nN10 #5=3\nN20 G0 X#5+7. Y2.\nN30 M30", moves="R X10 Y2",
)
case(
    "a vacant variable alone is no word, with arithmetic it is 0", **ALIKE,
    program="O1\nN10 G0 X1. Y1.\nN20 X#1 Y#1+#2\nN30 X-#1 Y5.\nN40 X-#1+2.\nN50 M30",
    moves="R X1 Y1\nR Y0\nR Y5\nR X2",
)
case(
    "all operators stand in a word, as tightly bound as in brackets", **ALIKE,
    program="""
        O1
        N10 #1=7
        N20 G0 X#1-2*3 Y#1/2+1 Z#1MOD4
        N30 X-#1+10 Y#1 AND 3 Z#1XOR2
        N40 X#1+[2+1]*2 Y#1*-2 Z#1 OR 8
        N50 M30
    """,
    moves="R X1 Y4.5 Z3\nR X3 Y3 Z5\nR X13 Y-14 Z15",
)
case(
    "functions, brackets and variables by variables stand in it", **ALIKE,
    program="""
        O1
        N10 #1=2
        N20 #2=30
        N30 G0 X#[#1]+SIN[30]*2 Y[#1+1]*2 Z[#1]-5.
        N40 M30
    """,
    moves="R X31 Y6 Z-3",
)
case(
    "a word may begin with its number", **ALIKE,
    program="O1\nN10 #1=2\nN20 G0 X10.+#1 Y10.-#1 Z-3*#1\nN30 X+1.+#1Y20./#1\nN40 M30",
    moves="R X12 Y8 Z-6\nR X3 Y10",
)
case(
    "every address computes: codes, F, S, T, corners, I J K and R", **ALIKE, setup={"machine": "mill"},
    program="""
        O1
        N10 #1=1
        N20 G#1+16 G#1-1 S#1*1000 M#1+2 T#1+4
        N30 G#1 X#1*10 F#1+199.
        N40 G#1+1 X#1+19. I#1*5 J#1-1
        N50 X#1+29 R#1+4
        N60 M30
    """,
    moves="F X10\nCW X20 C X15 Y0\nCW X30 C X25 Y0", m=[3], t=[5],
)
case(
    "P, L and H of a call compute", **ALIKE,
    program="""
        O1
        N10 #1=1
        N20 M98 P#1+1 H#1+49 L#1*2
        N30 M30
        O2
        N40 #10=5
        N50 #11=#11+1
        N60 M99 P#1+29
    """,
    runs="N10 N20 N50 N60 N50 N60 N30",
)
case(
    "arguments of a macro compute", **ALIKE, pins="word_arithmetic",
    program="O1\nN10 #5=3\nN20 G65 P1+1 A#5+7. B#9-2 C5.*#5 I#5/2\nN30 M30\nO2\nN40 #100=#1\nN50 #101=#2\nN60 #102=#3\nN70 #103=#4\nN80 M99",
    vars={100: 10, 101: -2, 102: 15, 103: 1.5},
)
case(
    "words of every block after G66.1 compute", **ALIKE,
    program="O1\nN10 #5=3\nN20 G66.1 P2\nN30 X#5+7.\nN40 G67\nN50 M30\nO2\nN60 #100=#24\nN70 M99",
    vars={100: 10},
)
case(
    "GOTO computes its number, after IF too", **ALIKE,
    program="O1\nN10 #1=20\nN20 GOTO#1+20\nN30 M0\nN40 IF[#1EQ20]GOTO#1*3\nN50 M0\nN60 M30",
    runs="N10 N20 N40 N60",
)
case(
    "a comparison is no value of a word", **ALIKE,
    program="O1\nN10 #1=2\nN20 G0 X#1 EQ 2\nN30 M30", runs="N10", alarm="address-without-value", number="P33", at="O1 N20",
)
case(
    "an operator without a value after it alarms", **ALIKE,
    program="O1\nN10 G0 X#1+ Y2.\nN20 M30", runs="", alarm="expression-format", number="P282", at="O1 N10",
)
case(
    "a division by 0 in a word alarms", **ALIKE,
    program="O1\nN10 G0 X5/#1 Y2.\nN20 M30", runs="", alarm="division-by-zero", number="P283", at="O1 N10",
)
case(
    "a lathe's U and W compute", **ALIKE, setup={"machine": "lathe-a"},
    program="O1\nN10 #1=2\nN20 G0 X10. Z0\nN30 U#1+2. W#1*-3\nN40 M30", moves="R X10 Z0\nR X14 Z-6",
)

# It is an alarm on the other controls.
_NUMBERS = dict.fromkeys(("fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"), "PS0004") | dict.fromkeys(("fanuc-16i", "gsk-988ta", "gsk-988t"), "004")
case(
    "elsewhere arithmetic stands in brackets", pins="word_arithmetic",
    control=[*_NUMBERS, "gsk-980tdi", "gsk-980mdi", "haas-ngc", "hnc-21m"],
    source="general knowledge", evidence="inferred", number=_NUMBERS | dict.fromkeys(("gsk-980tdi", "gsk-980mdi", "haas-ngc", "hnc-21m")),
    program="O1\nN10 #5=3\nN20 G0 X#5+7. Z2.\nN30 M30", runs="N10", alarm="value-without-address", at="O1 N20", word="X#5+7.",
)
