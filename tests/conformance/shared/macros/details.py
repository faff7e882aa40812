"""Small print of macro statements: short names, words under the caret."""

from conformance import case

MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]

case(
    "GO stands for GOTO where two letters of a name suffice",
    control=FANUC, source="ALI (text on macro functions)", evidence="secondary",
    program="""
        O1
        N10 GO 30
        N20 #100=1
        N30 #101=1
        N40 M30
    """,
    runs="N10 N30 N40", vars={100: None, 101: 1},
)
case(
    "SQR and RND stand for SQRT and ROUND",
    pins="statements functions",
    control=MITSUBISHI, source="general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=SQR[9]
        N20 #101=RND[2.5]
        N30 M30
    """,
    runs="N10 N20 N30", vars={100: 3, 101: 3},
)
case(
    "an H code that does not exist is told with its whole word",
    control=["gsk-980tdi", "gsk-980mdi"], source="MDib 0124; policy", evidence="inferred",
    program="""
        O1
        N10 G65 H77 P#200
        N20 M30
    """,
    runs="", alarm="illegal-h-code", number="0124", at="O1 N10", word="H77",
)
case(
    "H6 is no H code",
    control=["gsk-980tdi", "gsk-980mdi"], source="TDi29, table of H codes; MDib 0124",
    evidence="secondary",
    program="O1\nN10 G65 H6 P#200 Q1 R1\nN20 M30\n",
    runs="", alarm="illegal-h-code", number="0124", at="O1 N10", word="H6",
)
case(
    "H10 is no H code",
    control=["gsk-980tdi", "gsk-980mdi"], source="TDi29, table of H codes; MDib 0124",
    evidence="secondary",
    program="O1\nN10 G65 H10 P#200 Q1 R1\nN20 M30\n",
    runs="", alarm="illegal-h-code", number="0124", at="O1 N10", word="H10",
)
case(
    "H14 is no H code",
    control=["gsk-980tdi", "gsk-980mdi"], source="TDi29, table of H codes; MDib 0124",
    evidence="secondary",
    program="O1\nN10 G65 H14 P#200 Q1 R1\nN20 M30\n",
    runs="", alarm="illegal-h-code", number="0124", at="O1 N10", word="H14",
)
case(
    "H20 is no H code",
    control=["gsk-980tdi", "gsk-980mdi"], source="TDi29, table of H codes; MDib 0124",
    evidence="secondary",
    program="O1\nN10 G65 H20 P#200 Q1 R1\nN20 M30\n",
    runs="", alarm="illegal-h-code", number="0124", at="O1 N10", word="H20",
)
case(
    "H28 is no H code",
    control=["gsk-980tdi", "gsk-980mdi"], source="TDi29, table of H codes; MDib 0124",
    evidence="secondary",
    program="O1\nN10 G65 H28 P#200 Q1 R1\nN20 M30\n",
    runs="", alarm="illegal-h-code", number="0124", at="O1 N10", word="H28",
)
case(
    "H30 is no H code",
    control=["gsk-980tdi", "gsk-980mdi"], source="TDi29, table of H codes; MDib 0124",
    evidence="secondary",
    program="O1\nN10 G65 H30 P#200 Q1 R1\nN20 M30\n",
    runs="", alarm="illegal-h-code", number="0124", at="O1 N10", word="H30",
)
case(
    "H35 is no H code",
    control=["gsk-980tdi", "gsk-980mdi"], source="TDi29, table of H codes; MDib 0124",
    evidence="secondary",
    program="O1\nN10 G65 H35 P#200 Q1 R1\nN20 M30\n",
    runs="", alarm="illegal-h-code", number="0124", at="O1 N10", word="H35",
)
case(
    "H79 is no H code",
    control=["gsk-980tdi", "gsk-980mdi"], source="TDi29, table of H codes; MDib 0124",
    evidence="secondary",
    program="O1\nN10 G65 H79 P#200 Q1 R1\nN20 M30\n",
    runs="", alarm="illegal-h-code", number="0124", at="O1 N10", word="H79",
)
case(
    "H87 is no H code",
    control=["gsk-980tdi", "gsk-980mdi"], source="TDi29, table of H codes; MDib 0124",
    evidence="secondary",
    program="O1\nN10 G65 H87 P#200 Q1 R1\nN20 M30\n",
    runs="", alarm="illegal-h-code", number="0124", at="O1 N10", word="H87",
)
case(
    "of the names that SETVN gives each is its own variable",
    control=["fanuc-0i-f", "fanuc-30i"], source="ALM PS1139, PS1141; K-M syntax", evidence="inferred",
    program="""
        O1
        N10 SETVN 510[TOOLNO,WORKNO]
        N20 [#TOOLNO]=4
        N30 [#WORKNO]=5
        N40 #100=[#TOOLNO]-[#WORKNO]
        N50 M30
    """,
    runs="N10 N20 N30 N40 N50", vars={510: 4, 511: 5, 100: -1},
)
case(
    "SETVN is refused at the character that no name has",
    control=["fanuc-0i-f", "fanuc-30i"], source="ALM PS1141; policy", evidence="inferred",
    program="""
        O1
        N10 SETVN 510[TOOL*A]
        N20 M30
    """,
    runs="", alarm="illegal-variable-name", number="PS1141", at="O1 N10", word="*",
)
case(
    "#3002 counts the hours of motion on from what was written",
    control=FANUC, source="general knowledge, #3002", evidence="inferred",
    replace={"whole_numbers": "millimetres"},
    program="""
        O1
        N10 #3002=2
        N20 G94 G1 X6000 F100
        N30 #100=#3002
        N40 M30
    """,
    runs="N10 N20 N30 N40", vars={100: 3},
)
case(
    "zero is not negative to AND, OR and XOR",
    control=["gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi"], source="Talm 206; policy", evidence="inferred",
    program="""
        O1
        N10 #100=0 OR 1
        N20 #101=1 AND 0
        N30 M30
    """,
    runs="N10 N20 N30", vars={100: 1, 101: 0},
)
case(
    "while a modal macro call is active IF and GOTO jump",
    pins="if_form statements max_condition_length roles:G66=modal-call",
    control=[*FANUC, *MITSUBISHI, "gsk-988ta"], source="general knowledge, G66", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 IF[1 EQ 2]GOTO 50
        N30 IF[1 EQ 1]GOTO 50
        N40 #200=1
        N50 GOTO 70
        N60 #201=1
        N70 G67
        N80 M30
        O2
        N90 M99
    """,
    runs="N10 N20 N30 N50 N70 N80", vars={200: None, 201: None},
)
case(
    "while a modal macro call is active loops run",
    pins="loop_form",
    control=[*FANUC, *MITSUBISHI, "gsk-988ta"], source="general knowledge, G66", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 WHILE[#100 LT 2]DO1
        N30 #100=#100+1
        N40 END1
        N50 G67
        N60 M30
        O2
        N90 M99
    """,
    runs="N10 (N20 N30 N40)*2 N20 N50 N60", vars={100: 2},
)
case(
    "while a modal macro call is active THEN assigns",
    control=[*FANUC, *MITSUBISHI[1:], "gsk-988ta"], source="general knowledge, G66", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 IF[1 EQ 1]THEN #100=1
        N30 IF[1 EQ 2]THEN #101=1
        N40 G67
        N50 M30
        O2
        N60 M99
    """,
    runs="N10 N20 N30 N40 N50", vars={100: 1, 101: None},
)

EVERY_BLOCK = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]

case(
    "under G66.1 macro statements, calls and the end of the program are what they are",
    pins="calls_in_modal",
    control=EVERY_BLOCK, source="general knowledge, G66.1", evidence="inferred",
    program="""
        O1
        N10 G66.1 P2
        N20 #100=5
        N30 IF[#100 EQ 5]GOTO 50
        N40 #100=6
        N50 M98 P3
        N60 M30
        O2
        N70 #101=1
        N80 M99
        O3
        N90 #102=1
        N100 M99
    """,
    runs="N10 N20 N30 N50 N90 N100 N60", vars={100: 5, 101: None, 102: 1}, calls="M98:O3",
)
case(
    "under G66.1 every letter has its variable",
    pins="roles:G66.1=modal-call-every-block",
    control=EVERY_BLOCK, source="general knowledge, G66.1", evidence="inferred",
    replace={"whole_numbers": "millimetres"},
    program="""
        O1
        N10 G66.1 P2
        N20 A1 B2 C3 D7 E8 F9 H11 I4 J5 K6 M13 Q17 R18 S19 T20 U21 V22 W23 X24 Y25 Z26
        N30 G67
        N40 M30
        O2
        N50 M99
    """,
    runs="N10 N20 N50 N30 N40",
    arguments={n: n for n in (*range(1, 10), 11, 13, *range(17, 27))},
)
case(
    "a sum after EQ belongs to the comparison",
    control=[*FANUC, *MITSUBISHI, "gsk-988ta", "gsk-980tdi"],
    source="general knowledge, order of operators", evidence="inferred",
    program="O1\nN10 IF[3 EQ 1+2]GOTO 30\nN20 #100=1\nN30 M30",
    runs="N10 N30",
)
case(
    "a sum after NE belongs to the comparison",
    control=[*FANUC, *MITSUBISHI, "gsk-988ta", "gsk-980tdi"],
    source="general knowledge, order of operators", evidence="inferred",
    program="O1\nN10 IF[3 NE 1+2]GOTO 30\nN20 #100=1\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "a sum after GT belongs to the comparison",
    control=[*FANUC, *MITSUBISHI, "gsk-988ta", "gsk-980tdi"],
    source="general knowledge, order of operators", evidence="inferred",
    program="O1\nN10 IF[3 GT 1+2]GOTO 30\nN20 #100=1\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "a sum after LT belongs to the comparison",
    control=[*FANUC, *MITSUBISHI, "gsk-988ta", "gsk-980tdi"],
    source="general knowledge, order of operators", evidence="inferred",
    program="O1\nN10 IF[3 LT 1+2]GOTO 30\nN20 #100=1\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "a sum after GE belongs to the comparison",
    control=[*FANUC, *MITSUBISHI, "gsk-988ta", "gsk-980tdi"],
    source="general knowledge, order of operators", evidence="inferred",
    program="O1\nN10 IF[3 GE 1+2]GOTO 30\nN20 #100=1\nN30 M30",
    runs="N10 N30",
)
case(
    "a sum after LE belongs to the comparison",
    control=[*FANUC, *MITSUBISHI, "gsk-988ta", "gsk-980tdi"],
    source="general knowledge, order of operators", evidence="inferred",
    program="O1\nN10 IF[3 LE 1+2]GOTO 30\nN20 #100=1\nN30 M30",
    runs="N10 N30",
)
case(
    "no variable is read by a comparison as its number",
    control=[*FANUC, "gsk-988ta", "mitsubishi-m700"],
    source="general knowledge, form of expressions", evidence="inferred",
    program="O1\nN10 T1\nN20 #100=#[1 EQ 2]\nN30 M30\n",
    runs="N10", alarm="expression-format",
    number=dict.fromkeys(FANUC, "PS1125") | {"fanuc-16i": "125", "gsk-988ta": "202", "mitsubishi-m700": "P282"},
    at="O1 N20",
)
case(
    "no variable is written by a comparison as its number",
    control=[*FANUC, "gsk-988ta", "mitsubishi-m700"],
    source="general knowledge, form of expressions", evidence="inferred",
    program="O1\nN10 T1\nN20 #[1 EQ 2]=1\nN30 M30\n",
    runs="N10", alarm="expression-format",
    number=dict.fromkeys(FANUC, "PS1125") | {"fanuc-16i": "125", "gsk-988ta": "202", "mitsubishi-m700": "P282"},
    at="O1 N20",
)
case(
    "a bracket that closes alone was never opened: #100=]",
    control=[*FANUC, "gsk-988ta", "gsk-980tdi", "mitsubishi-m700"],
    source="form of expressions; policy", evidence="inferred",
    program="O1\nN10 T1\nN20 #100=]\nN30 M30\n",
    runs="N10", alarm="bracket-not-opened", at="O1 N20", word="]",
    number=dict.fromkeys(FANUC, "PS1131") | {"fanuc-16i": "114", "gsk-988ta": "202", "gsk-980tdi": "0104", "mitsubishi-m700": "P281"},
)
case(
    "a bracket that closes after an operator was never opened: #100=1+]",
    control=[*FANUC, "gsk-988ta", "gsk-980tdi", "mitsubishi-m700"],
    source="form of expressions; policy", evidence="inferred",
    program="O1\nN10 T1\nN20 #100=1+]\nN30 M30\n",
    runs="N10", alarm="bracket-not-opened", at="O1 N20", word="]",
    number=dict.fromkeys(FANUC, "PS1131") | {"fanuc-16i": "114", "gsk-988ta": "202", "gsk-980tdi": "0104", "mitsubishi-m700": "P281"},
)
case(
    "a bracket that closes before its value is a fault of form",
    control=FANUC, source="form of expressions; policy", evidence="inferred",
    program="O1\nN10 T1\nN20 #100=[1+]\nN30 M30\n",
    runs="N10", alarm="expression-format", at="O1 N20", word="]",
    number=dict.fromkeys(FANUC, "PS1125") | {"fanuc-16i": "125"},
)
case(
    "ADP of a number is the number",
    control=["fanuc-0i-f", "fanuc-30i"], source="general knowledge, ADP", evidence="inferred",
    program="O1\nN10 #100=ADP[5]\nN20 M30\n",
    runs="N10 N20", vars={100: 5},
)

# Faults of form, each at its place
LATER = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]

case(
    "a block is refused at the place of its fault: #100=--1",
    control=LATER, source="ALM, texts of the numbers; policy", evidence="inferred",
    program="O1\nN10 T1\nN20 #100=--1\nN30 M30\n",
    runs="N10", alarm="expression-format", number="PS1125", at="O1 N20", word="-",
)
case(
    "a block is refused at the place of its fault: #100=1.5.2",
    control=LATER, source="ALM, texts of the numbers; policy", evidence="inferred",
    program="O1\nN10 T1\nN20 #100=1.5.2\nN30 M30\n",
    runs="N10", alarm="illegal-decimal-point", number="PS0007", at="O1 N20", word="1.5.2",
)
case(
    "a block is refused at the place of its fault: #1.5=1",
    control=LATER, source="ALM, texts of the numbers; policy", evidence="inferred",
    program="O1\nN10 T1\nN20 #1.5=1\nN30 M30\n",
    runs="N10", alarm="illegal-variable", number="PS0115", at="O1 N20", word="#1.5",
)
case(
    "a block is refused at the place of its fault: #100=#1.5",
    control=LATER, source="ALM, texts of the numbers; policy", evidence="inferred",
    program="O1\nN10 T1\nN20 #100=#1.5\nN30 M30\n",
    runs="N10", alarm="illegal-variable", number="PS0115", at="O1 N20", word="#1.5",
)
case(
    "a block is refused at the place of its fault: #100=1]",
    control=LATER, source="ALM, texts of the numbers; policy", evidence="inferred",
    program="O1\nN10 T1\nN20 #100=1]\nN30 M30\n",
    runs="N10", alarm="bracket-not-opened", number="PS1131", at="O1 N20", word="]",
)
case(
    "a block is refused at the place of its fault: IF[1]GOTO 30",
    control=LATER, source="ALM, texts of the numbers; policy", evidence="inferred",
    program="O1\nN10 T1\nN20 IF[1]GOTO 30\nN30 M30\n",
    runs="N10", alarm="if-format", number="PS1137", at="O1 N20", word="[",
)
case(
    "a block is refused at the place of its fault: IF[1 EQ 2 EQ 3]GOTO 30",
    control=LATER, source="ALM, texts of the numbers; policy", evidence="inferred",
    program="O1\nN10 T1\nN20 IF[1 EQ 2 EQ 3]GOTO 30\nN30 M30\n",
    runs="N10", alarm="if-format", number="PS1137", at="O1 N20", word="EQ",
)
case(
    "a block is refused at the place of its fault: IF[[1 EQ 2] EQ 3]GOTO 30",
    control=LATER, source="ALM, texts of the numbers; policy", evidence="inferred",
    program="O1\nN10 T1\nN20 IF[[1 EQ 2] EQ 3]GOTO 30\nN30 M30\n",
    runs="N10", alarm="if-format", number="PS1137", at="O1 N20", word="EQ",
)
case(
    "a block is refused at the place of its fault: IF[1 EQ 1]THEN G0 X1.",
    control=LATER, source="ALM, texts of the numbers; policy", evidence="inferred",
    program="O1\nN10 T1\nN20 IF[1 EQ 1]THEN G0 X1.\nN30 M30\n",
    runs="N10", alarm="if-format", number="PS1137", at="O1 N20", word="G0",
)
case(
    "a block is refused at the place of its fault: G0 X1. ]",
    control=LATER, source="ALM, texts of the numbers; policy", evidence="inferred",
    program="O1\nN10 T1\nN20 G0 X1. ]\nN30 M30\n",
    runs="N10", alarm="bracket-not-opened", number="PS1131", at="O1 N20", word="]",
)
case(
    "a block is refused at the place of its fault: G0 O#1",
    control=LATER, source="ALM, texts of the numbers; policy", evidence="inferred",
    program="O1\nN10 T1\nN20 G0 O#1\nN30 M30\n",
    runs="N10", alarm="address-not-usable", number="PS0009", at="O1 N20", word="O#1",
)
case(
    "a block is refused at the place of its fault: G0 X1. O5",
    control=LATER, source="ALM, texts of the numbers; policy", evidence="inferred",
    program="O1\nN10 T1\nN20 G0 X1. O5\nN30 M30\n",
    runs="N10", alarm="address-not-usable", number="PS0009", at="O1 N20", word="O5",
)
case(
    "a block is refused at the place of its fault: M98 P2 M99",
    control=LATER, source="ALM, texts of the numbers; policy", evidence="inferred",
    program="O1\nN10 T1\nN20 M98 P2 M99\nN30 M30\n",
    runs="N10", alarm="call-given-twice", number="PS1091", at="O1 N20", word="M99",
)
case(
    "a loop may not open its own number again",
    control=LATER, source="ALM PS0124; policy", evidence="inferred",
    program="""
        O1
        N10 WHILE[1 EQ 1]DO1
        N20 WHILE[1 EQ 1]DO1
        N30 END1
        N40 END1
        N50 M30
    """,
    runs="N10", alarm="missing-end", number="PS0124", at="O1 N20",
)
case(
    "after THEN stands a jump too",
    control=[*LATER, "fanuc-16i", "mitsubishi-m800"], source="general knowledge, IF", evidence="inferred",
    program="""
        O1
        N10 IF[1 EQ 1]THEN GOTO 30
        N20 #100=1
        N30 IF[1 EQ 2]THEN GOTO 50
        N40 #101=1
        N50 M30
    """,
    runs="N10 N30 N40 N50", vars={100: None, 101: 1},
)
case(
    "a G code below zero is out of range",
    control=LATER, source="ALM PS1305; policy", evidence="inferred",
    program="""
        O1
        N10 #1=-1
        N20 G#1 X1.
        N30 M30
    """,
    runs="N10", alarm="value-out-of-range", number="PS1305", at="O1 N20", word="G#1",
)
case(
    "#[0] is vacant like #0",
    control=FANUC, source="general knowledge, #0", evidence="inferred",
    program="""
        O1
        N10 #100=1
        N20 #100=#[0]
        N30 M30
    """,
    runs="N10 N20 N30", vars={100: None},
)
case(
    "#4114 is the sequence number of the block before",
    control=["fanuc-30i", "fanuc-0i-f"], source="REG #4114", evidence="secondary",
    program="""
        O1
        N15 G0 X1.
        #100=#4114
        N25 G0 X2.
        #101=#4114
        M30
    """,
    vars={100: 15, 101: 25},
)
case(
    "#5041 is the work position, with #5101 the servo stands where it should",
    control=FANUC, source="general knowledge, #5041 and #5101", evidence="inferred",
    replace={"whole_numbers": "millimetres"}, setup={"machine": "mill", "work_offsets": {"G54": {"X": 100}}},
    program="""
        O1
        N10 G90 G54 G0 X5 Y7
        N20 #100=#5041
        N30 #101=#5042
        N40 #102=#5101
        N50 M30
    """,
    runs="N10 N20 N30 N40 N50", vars={100: 5, 101: 7, 102: 0},
)
case(
    "#7001 and those after it are read as they were written",
    control=["fanuc-16i", "fanuc-30i"], source="general knowledge, #7001", evidence="inferred",
    replace={"whole_numbers": "millimetres"}, setup={"machine": "mill"},
    program="""
        O1
        N10 #7002=3
        N20 #7021=7
        N30 #100=#7002
        N40 #101=#7021
        N50 #102=#7001
        N60 M30
    """,
    runs="N10 N20 N30 N40 N50 N60", vars={100: 3, 101: 7, 102: 0},
)
case(
    "the cosine of an angle beyond one turn, and of one below zero",
    pins="angle_unit functions",
    control=[*FANUC, *MITSUBISHI, "gsk-988ta", "haas-ngc"], source="general knowledge, COS", evidence="inferred",
    program="""
        O1
        N10 #100=COS[400.5]
        N20 #101=COS[-30.5]
        N30 #102=SIN[1000.5]
        N40 M30
    """,
    runs="N10 N20 N30 N40", vars={100: 0.760406, 101: 0.861629, 102: -0.983255},
)
case(
    "NOT turns a condition round",
    pins="if_form",
    control="hnc-21m", source="general knowledge, NOT", evidence="inferred",
    program="""
        %1
        N10 #50=1
        N20 IF NOT [#50 EQ 2]
        N30 #51=1
        N40 ENDIF
        N50 IF NOT [#50 EQ 1]
        N60 #52=1
        N70 ENDIF
        N80 M30
    """,
    runs="N10 N20 N30 N40 N50 N70 N80", vars={51: 1, 52: None},
)
case(
    "AR asks for a local variable: a common one is refused",
    pins="functions",
    control="hnc-21m", source="general knowledge, AR", evidence="inferred",
    program="%1\nN10 T1\nN20 #50=AR[#500]\nN30 M30\n",
    runs="N10", alarm="illegal-variable", at="%1 N20",
)
case(
    "AR asks for a variable: a number is refused",
    control="hnc-21m", source="general knowledge, AR", evidence="inferred",
    program="%1\nN10 T1\nN20 #50=AR[5]\nN30 M30\n",
    runs="N10", alarm="expression-format", at="%1 N20",
)
case(
    "AR asks for a variable by its number: a computed one is refused",
    control="hnc-21m", source="general knowledge, AR", evidence="inferred",
    program="%1\nN10 T1\nN20 #50=AR[#[1]]\nN30 M30\n",
    runs="N10", alarm="expression-format", at="%1 N20", word="AR",
)
case(
    "PRM of no parameter's number is out of range",
    control=["fanuc-0i-f", "fanuc-30i"], source="ALM PS0119; policy", evidence="inferred",
    program="O1\nN10 T1\nN20 #100=PRM[99999999999]\nN30 M30\n",
    runs="N10", alarm="argument-out-of-range", number="PS0119", at="O1 N20",
)
case(
    "BPRNT sends whole numbers of the digits asked for",
    control=FANUC, source="general knowledge, BPRNT", evidence="inferred",
    program="""
        O1
        N10 #100=12.345
        N20 POPEN
        N30 BPRNT[A#100[2]]
        N40 PCLOS
        N50 M30
    """,
    runs="N10 N20 N30 N40 N50", messages=["A1235"],
)
case(
    "H80 jumps in no program of MDI",
    pins="refuses:jump-in-mdi",
    control=["gsk-980tdi", "gsk-980mdi"], source="policy, jumps in MDI", evidence="inferred",
    program="O1\nN10 M30\n", mdi="G65 H80 P10",
    runs="", alarm="jump-in-mdi",
)
case(
    "ATAN of a direction along the first axis is 0, not a full turn",
    control=[*FANUC, *MITSUBISHI], source="general knowledge, ATAN", evidence="inferred",
    program="O1\nN10 #100=ATAN[0]/[5]\nN20 M30\n",
    runs="N10 N20", vars={100: 0},
)
case(
    "the first two of three joined conditions belong together",
    control=MITSUBISHI, source="general knowledge, order of operators", evidence="inferred",
    program="""
        O1
        N10 IF[[1 EQ 2] AND [1 EQ 2] OR [1 EQ 1]]GOTO 30
        N20 #100=1
        N30 IF[[1 EQ 1] XOR [2 EQ 2]]GOTO 70
        N60 #102=1
        N70 M30
    """,
    runs="N10 N30 N60 N70",
)
case(
    "a computed GOTO takes the largest sequence number",
    control=["fanuc-16i", "gsk-988ta", "mitsubishi-m700"], source="general knowledge, GOTO", evidence="inferred",
    program="""
        O1
        N10 #1=99999
        N20 GOTO #1
        N30 #100=1
        N99999 M30
    """,
    runs="N10 N20 N99999",
)
case(
    "no local variable of the main program was passed: AR is 0",
    control="hnc-21m", source="general knowledge, AR", evidence="inferred",
    program="%1\nN10 #50=AR[#1]\nN20 M30\n",
    runs="N10 N20", vars={50: 0},
)
case(
    "a joined condition in brackets is one of two that are joined",
    control=MITSUBISHI, source="general knowledge, order of operators", evidence="inferred",
    program="""
        O1
        N10 IF[[1 EQ 1] XOR [[2 EQ 2] AND [3 EQ 3]]]GOTO 30
        N20 #100=1
        N30 IF[[1 EQ 1] XOR [[2 EQ 3] OR [3 EQ 4]]]GOTO 50
        N40 #101=1
        N50 M30
    """,
    runs="N10 N20 N30 N50",
)
case(
    "the sine of whole degrees is exact where it is 0, a half or 1, and right elsewhere",
    control=[*FANUC, *MITSUBISHI, "gsk-988ta"], source="mathematics", evidence="inferred",
    program="""
        O1
        N10 #100=SIN[60]
        N20 #101=SIN[240]
        N30 #102=COS[300]
        N40 IF[#102 NE 0.5]GOTO 60
        N50 #103=1
        N60 M30
    """,
    runs="N10 N20 N30 N40 N50 N60", vars={100: 0.8660254, 101: -0.8660254},
)
case(
    "SRAND does not give its second argument every time",
    control=["gsk-980tdi", "gsk-980mdi"], source="TDi29, random numbers", evidence="maker's manual",
    program="""
        O1
        N10 #100=SRAND[1,500]
        N20 #101=SRAND[1,500]
        N30 IF[#100 NE #101]GOTO 50
        N40 #102=1
        N50 M30
    """,
    runs="N10 N20 N30 N50",
)
case(
    "BCD and BIN take eight decimal digits",
    control=FANUC, source="ALI; general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=BCD[1234]
        N20 #101=BIN[4660]
        N30 #102=BIN[BCD[99999999]]
        N40 #103=BCD[10000*10000]
        N50 M30
    """,
    runs="N10 N20 N30", vars={100: 4660, 101: 1234, 102: 99999999},
    alarm="argument-out-of-range", at="O1 N40",
    number={"fanuc-16i": "119", "fanuc-0i-d": "PS0119", "fanuc-0i-f": "PS0119", "fanuc-30i": "PS0119"},
)
case(
    "H24 takes eight decimal digits",
    control=["gsk-980tdi", "gsk-980mdi"], source="TDi28, table of G65 H; policy", evidence="inferred",
    program="""
        O1
        N10 G65 H24 P#100 Q2576980377
        N20 G65 H25 P#101 Q1234
        N30 M30
    """,
    runs="N10 N20 N30", vars={100: 99999999, 101: 4660},
)
case(
    "H34 of R0 is a right angle",
    control=["gsk-980tdi", "gsk-980mdi"], source="TDi28, table of G65 H; policy", evidence="inferred",
    program="O1\nN10 G65 H34 P#100 Q1 R0\nN20 G65 H34 P#101 Q0 R1\nN30 M30\n",
    runs="N10 N20 N30", vars={100: 90, 101: 0},
)
case(
    "only where the control knows short names GO is GOTO",
    pins="bare_g short_functions",
    control=["gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi"],
    source="policy: no source has it; Talm 005, MDia 003", evidence="inferred",
    program="O1\nN10 #100=1\nN20 GO 30\nN30 M30\n",
    runs="N10", alarm="address-without-value", at="O1 N20", word="GO",
    number={"gsk-988ta": "005", "gsk-988t": "005", "gsk-980tdi": "0003", "gsk-980mdi": "0003"},
)
case(
    "a field of DPRNT whose variable has no number is no field",
    control="fanuc-16i", source="ALI; general knowledge", evidence="secondary",
    program="O1\nN10 #100=1\nN20 DPRNT[#A[53]]\nN30 M30\n",
    runs="N10", alarm="expression-format", number="125", at="O1 N20", word="#",
)
case(
    "a name of a variable has letters, digits and lines",
    control=["fanuc-0i-f", "fanuc-30i"], source="ALM PS1139, PS1141; K-M syntax", evidence="inferred",
    program="""
        O1
        N10 SETVN 510[A_1]
        N20 [#A_1]=7
        N30 #100=[#A_1]
        N40 M30
    """,
    runs="N10 N20 N30 N40", vars={510: 7, 100: 7},
)
case(
    "an assignment that is refused is told with the whole variable",
    control=["fanuc-16i", "gsk-988ta", "mitsubishi-m700"],
    source="ALM 116; Talm 220; Mazak list P243", evidence="secondary",
    program="O1\nN10 #100=1\nN20 #5021=5\nN30 M30\n",
    runs="N10", alarm="variable-write-protected", at="O1 N20", word="#5021",
    number={"fanuc-16i": "116", "gsk-988ta": "220", "mitsubishi-m700": "P243"},
)
case(
    "an M code beside a straight move is sent and the move is made",
    pins="max_feed",
    control=[*FANUC, *MITSUBISHI, "gsk-988ta", "hnc-21m", "haas-ngc"], source="general knowledge", evidence="inferred",
    program="O1\nN10 G1 X10. F100 M8\nN20 M30\n",
    runs="N10 N20", m=[8], moves_x=[10],
)
case(
    "#3002 that is written after some motion counts from then on",
    control=FANUC, source="general knowledge, #3002", evidence="inferred",
    replace={"whole_numbers": "millimetres"},
    program="""
        O1
        N10 G94 G1 X6000 F100
        N20 #3002=2
        N30 #100=#3002
        N40 M30
    """,
    runs="N10 N20 N30 N40", vars={100: 2},
)
case(
    "a number that GOTO does not find is told without the comment after it",
    control=["fanuc-16i", "mitsubishi-m700"], source="ALM 128; Mazak list P231", evidence="secondary",
    program="O1\nN10 M8\nN20 GOTO 99 (AWAY)\nN30 M30\n",
    runs="N10", alarm="jump-target-not-found", at="O1 N20", word="99",
    number={"fanuc-16i": "128", "mitsubishi-m700": "P231"},
)
case(
    "there are two arguments of X with a number: X3= is none",
    pins="numbered_axis_arguments",
    control=["gsk-988ta", "gsk-988t"], source="TA27, argument I; general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P2 X1=7
        N30 G65 P2 X3=7
        N40 M30
        O2
        N50 M99
    """,
    runs="N10 N50", alarm="illegal-character", at="O1 N30", word="=",
)

# A decimal point after the number of a variable
_POINT = "real programs: #504. in a macro of the maker"
_POINTED = {
    "written": ("#504.=7", {504: 7}),
    "read": ("#100=#504.", {100: 2}),
    "read twice in an expression": ("#100=#504.+#504.*#504.", {100: 6}),
    "compared": ("IF[#504.EQ2]GOTO30", {504: 2}),
    "an address's value": ("G0 X#504.", {504: 2}),
    "an argument's value": ("G65 P2 A#504.", {100: 2}),
    "the number of a variable": ("#100=#[#504.+502]", {100: 2}),
    "printed": ("DPRNT[X#504.[53]]", {504: 2}),
}

case(
    "a Mitsubishi's variable with a point after its number is written",
    pins="variable_forms:point", control=["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"],
    source=_POINT, evidence="secondary",
    program="O1\nN10 #504=2\nN20 #504.=7\nN30 M30\nO2\nN40 #100=#1\nN50 M99",
    vars={504: 7},
)
case(
    "no other control has a variable with a point after its number written",
    pins="variable_forms:point", control=["gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi", *FANUC],
    source="policy, nobody says", evidence="inferred",
    program="O1\nN10 #504=2\nN20 #504.=7\nN30 M30\nO2\nN40 #100=#1\nN50 M99",
    runs="N10", alarm="illegal-variable", at="O1 N20", vars={504: 2},
    number={"gsk-988ta": "203", "gsk-988t": "203", "gsk-980tdi": "0111", "gsk-980mdi": "0111", "fanuc-16i": "115", "fanuc-0i-d": "PS0115", "fanuc-0i-f": "PS0115", "fanuc-30i": "PS0115"},
)
case(
    "a Mitsubishi's variable with a point after its number is read",
    pins="variable_forms:point", control=["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"],
    source=_POINT, evidence="secondary",
    program="O1\nN10 #504=2\nN20 #100=#504.\nN30 M30\nO2\nN40 #100=#1\nN50 M99",
    vars={100: 2},
)
case(
    "no other control has a variable with a point after its number read",
    pins="variable_forms:point", control=["gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi", *FANUC],
    source="policy, nobody says", evidence="inferred",
    program="O1\nN10 #504=2\nN20 #100=#504.\nN30 M30\nO2\nN40 #100=#1\nN50 M99",
    runs="N10", alarm="illegal-variable", at="O1 N20", vars={504: 2},
    number={"gsk-988ta": "203", "gsk-988t": "203", "gsk-980tdi": "0111", "gsk-980mdi": "0111", "fanuc-16i": "115", "fanuc-0i-d": "PS0115", "fanuc-0i-f": "PS0115", "fanuc-30i": "PS0115"},
)
case(
    "a Mitsubishi's variable with a point after its number is read twice in an expression",
    pins="variable_forms:point", control=["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"],
    source=_POINT, evidence="secondary",
    program="O1\nN10 #504=2\nN20 #100=#504.+#504.*#504.\nN30 M30\nO2\nN40 #100=#1\nN50 M99",
    vars={100: 6},
)
case(
    "no other control has a variable with a point after its number read twice in an expression",
    pins="variable_forms:point", control=["gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi", *FANUC],
    source="policy, nobody says", evidence="inferred",
    program="O1\nN10 #504=2\nN20 #100=#504.+#504.*#504.\nN30 M30\nO2\nN40 #100=#1\nN50 M99",
    runs="N10", alarm="illegal-variable", at="O1 N20", vars={504: 2},
    number={"gsk-988ta": "203", "gsk-988t": "203", "gsk-980tdi": "0111", "gsk-980mdi": "0111", "fanuc-16i": "115", "fanuc-0i-d": "PS0115", "fanuc-0i-f": "PS0115", "fanuc-30i": "PS0115"},
)
case(
    "a Mitsubishi's variable with a point after its number is compared",
    pins="variable_forms:point", control=["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"],
    source=_POINT, evidence="secondary",
    program="O1\nN10 #504=2\nN20 IF[#504.EQ2]GOTO30\nN30 M30\nO2\nN40 #100=#1\nN50 M99",
    vars={504: 2},
)
case(
    "no other control has a variable with a point after its number compared",
    pins="variable_forms:point", control=["gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi", *FANUC],
    source="policy, nobody says", evidence="inferred",
    program="O1\nN10 #504=2\nN20 IF[#504.EQ2]GOTO30\nN30 M30\nO2\nN40 #100=#1\nN50 M99",
    runs="N10", alarm="illegal-variable", at="O1 N20", vars={504: 2},
    number={"gsk-988ta": "203", "gsk-988t": "203", "gsk-980tdi": "0111", "gsk-980mdi": "0111", "fanuc-16i": "115", "fanuc-0i-d": "PS0115", "fanuc-0i-f": "PS0115", "fanuc-30i": "PS0115"},
)
case(
    "a Mitsubishi's variable with a point after its number is an address's value",
    pins="variable_forms:point", control=["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"],
    source=_POINT, evidence="secondary",
    program="O1\nN10 #504=2\nN20 G0 X#504.\nN30 M30\nO2\nN40 #100=#1\nN50 M99",
    vars={504: 2},
)
case(
    "no other control has a variable with a point after its number an address's value",
    pins="variable_forms:point", control=["gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi", *FANUC],
    source="policy, nobody says", evidence="inferred",
    program="O1\nN10 #504=2\nN20 G0 X#504.\nN30 M30\nO2\nN40 #100=#1\nN50 M99",
    runs="N10", alarm="illegal-variable", at="O1 N20", vars={504: 2},
    number={"gsk-988ta": "203", "gsk-988t": "203", "gsk-980tdi": "0111", "gsk-980mdi": "0111", "fanuc-16i": "115", "fanuc-0i-d": "PS0115", "fanuc-0i-f": "PS0115", "fanuc-30i": "PS0115"},
)
case(
    "a Mitsubishi's variable with a point after its number is an argument's value",
    pins="variable_forms:point", control=["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"],
    source=_POINT, evidence="secondary",
    program="O1\nN10 #504=2\nN20 G65 P2 A#504.\nN30 M30\nO2\nN40 #100=#1\nN50 M99",
    vars={100: 2},
)
case(
    "no other control has a variable with a point after its number an argument's value",
    pins="variable_forms:point", control=["gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi", *FANUC],
    source="policy, nobody says", evidence="inferred",
    program="O1\nN10 #504=2\nN20 G65 P2 A#504.\nN30 M30\nO2\nN40 #100=#1\nN50 M99",
    runs="N10", alarm="illegal-variable", at="O1 N20", vars={504: 2},
    number={"gsk-988ta": "203", "gsk-988t": "203", "gsk-980tdi": "0111", "gsk-980mdi": "0111", "fanuc-16i": "115", "fanuc-0i-d": "PS0115", "fanuc-0i-f": "PS0115", "fanuc-30i": "PS0115"},
)
case(
    "a Mitsubishi's variable with a point after its number is the number of a variable",
    pins="variable_forms:point", control=["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"],
    source=_POINT, evidence="secondary",
    program="O1\nN10 #504=2\nN20 #100=#[#504.+502]\nN30 M30\nO2\nN40 #100=#1\nN50 M99",
    vars={100: 2},
)
case(
    "no other control has a variable with a point after its number the number of a variable",
    pins="variable_forms:point", control=["gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi", *FANUC],
    source="policy, nobody says", evidence="inferred",
    program="O1\nN10 #504=2\nN20 #100=#[#504.+502]\nN30 M30\nO2\nN40 #100=#1\nN50 M99",
    runs="N10", alarm="illegal-variable", at="O1 N20", vars={504: 2},
    number={"gsk-988ta": "203", "gsk-988t": "203", "gsk-980tdi": "0111", "gsk-980mdi": "0111", "fanuc-16i": "115", "fanuc-0i-d": "PS0115", "fanuc-0i-f": "PS0115", "fanuc-30i": "PS0115"},
)
case(
    "a Mitsubishi's variable with a point after its number is printed",
    pins="variable_forms:point", control=["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"],
    source=_POINT, evidence="secondary",
    program="O1\nPOPEN\nN10 #504=2\nN20 DPRNT[X#504.[53]]\nN30 M30\nO2\nN40 #100=#1\nN50 M99",
    vars={504: 2},
)
case(
    "no other control has a variable with a point after its number printed",
    pins="variable_forms:point", control=[*FANUC], source="policy, nobody says", evidence="inferred",
    program="O1\nPOPEN\nN10 #504=2\nN20 DPRNT[X#504.[53]]\nN30 M30\nO2\nN40 #100=#1\nN50 M99",
    runs="N10", alarm="illegal-variable", at="O1 N20", vars={504: 2},
    number={"fanuc-16i": "115", "fanuc-0i-d": "PS0115", "fanuc-0i-f": "PS0115", "fanuc-30i": "PS0115"},
)
case(
    "HNC: a variable's number has no point after it",
    pins="variable_forms:point",
    control="hnc-21m", source="policy, nobody says", evidence="inferred",
    program="%1\nN10 #50=2\nN20 #50.=7\nN30 M30",
    runs="N10", alarm="illegal-variable", number=None, at="%1 N20", vars={50: 2},
)
case(
    "a Mitsubishi's variable number has no decimals: #504.0=7",
    control=["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"], source=_POINT,
    evidence="inferred",
    program="O1\nN10 #504=2\nN20 #504.0=7\nN30 M30",
    runs="N10", alarm="illegal-variable", number="P241", at="O1 N20", vars={504: 2},
)
case(
    "a Mitsubishi's variable number has no decimals: #504.5=7",
    control=["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"], source=_POINT,
    evidence="inferred",
    program="O1\nN10 #504=2\nN20 #504.5=7\nN30 M30",
    runs="N10", alarm="illegal-variable", number="P241", at="O1 N20", vars={504: 2},
)
case(
    "a Mitsubishi's variable number has no decimals: #100=#504.0",
    control=["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"], source=_POINT,
    evidence="inferred",
    program="O1\nN10 #504=2\nN20 #100=#504.0\nN30 M30",
    runs="N10", alarm="illegal-variable", number="P241", at="O1 N20", vars={504: 2},
)
case(
    "a Mitsubishi's variable number has no decimals: #100=#1.5",
    control=["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"], source=_POINT,
    evidence="inferred",
    program="O1\nN10 #504=2\nN20 #100=#1.5\nN30 M30",
    runs="N10", alarm="illegal-variable", number="P241", at="O1 N20", vars={504: 2},
)
case(
    "a Mitsubishi's variable number has no decimals: #504..=7",
    control=["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"], source=_POINT,
    evidence="inferred",
    program="O1\nN10 #504=2\nN20 #504..=7\nN30 M30",
    runs="N10", alarm="illegal-variable", number="P241", at="O1 N20", vars={504: 2},
)
case(
    "a variable that the control does not list alarms", pins="unlisted_variables",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i", "gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi", "mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800", "haas-ngc", "hnc-21m"],
    source="general knowledge", evidence="inferred",
    program="O1\nN10 #1=#2999\nN20 M30", runs="", alarm="illegal-variable", at="O1 N10",
    number={
        "fanuc-16i": "115", "fanuc-0i-d": "PS0115", "fanuc-0i-f": "PS0115", "fanuc-30i": "PS0115", "gsk-988ta": "203", "gsk-988t": "203",
        "gsk-980tdi": "0111", "gsk-980mdi": "0111", "mitsubishi-meldas": "P241", "mitsubishi-m700": "P241", "mitsubishi-m800": "P241",
        "haas-ngc": "503", "hnc-21m": None,
    },
)
