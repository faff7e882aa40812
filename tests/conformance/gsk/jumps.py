"""GSK: jumps and loops."""

from conformance import case

case(
    "the manual's sum of 1 to 10 is 55 (TD-014)",
    control="gsk-980tdi",
    source="TDi29, example",
    evidence="maker's manual",
    program="""
        O9500
        #1=0
        #2=1
        N1 IF[#2 GT 10]GOTO2
        #1=#1+#2
        #2=#2+1
        GOTO1
        N2 G0 X#1
        M30
    """,
    moves_x=[55],
)

TA, T, TDI, MDI = "gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi"
FAMILY_988 = [TA, T]
FAMILY_980 = [TDI, MDI]
FAMILIES = [TA, T, TDI, MDI]
MANUAL = "maker's manual"
SECONDARY = "secondary"
INFERRED = "inferred"


def both(number_988, number_980):
    """Return one alarm number for the 988s, and one for the 980s."""
    return {TA: number_988, T: number_988, TDI: number_980, MDI: number_980}


case(
    "GSK: EQ compares less, equal and greater as its table says",
    pins="if_form max_condition_length", control=FAMILIES, source="TDi29, conditions",
    evidence=MANUAL,
    program="""
        O1
        N10 IF[1 EQ 2]THEN #101=1
        N20 IF[2 EQ 2]THEN #102=1
        N30 IF[3 EQ 2]THEN #103=1
        N40 M30
    """,
    variables={101: 0, 102: 0, 103: 0}, runs="N10 N20 N30 N40", vars={101: 0, 102: 1, 103: 0},
)
case(
    "GSK: == compares less, equal and greater as its table says",
    pins="if_form max_condition_length", control=[TDI], source="TDi29, conditions", evidence=MANUAL,
    program="""
        O1
        N10 IF[1 == 2]THEN #101=1
        N20 IF[2 == 2]THEN #102=1
        N30 IF[3 == 2]THEN #103=1
        N40 M30
    """,
    variables={101: 0, 102: 0, 103: 0}, runs="N10 N20 N30 N40", vars={101: 0, 102: 1, 103: 0},
)
case(
    "GSK: NE compares less, equal and greater as its table says",
    pins="if_form max_condition_length", control=FAMILIES, source="TDi29, conditions",
    evidence=MANUAL,
    program="""
        O1
        N10 IF[1 NE 2]THEN #101=1
        N20 IF[2 NE 2]THEN #102=1
        N30 IF[3 NE 2]THEN #103=1
        N40 M30
    """,
    variables={101: 0, 102: 0, 103: 0}, runs="N10 N20 N30 N40", vars={101: 1, 102: 0, 103: 1},
)
case(
    "GSK: <> compares less, equal and greater as its table says",
    pins="if_form max_condition_length", control=[TDI], source="TDi29, conditions", evidence=MANUAL,
    program="""
        O1
        N10 IF[1 <> 2]THEN #101=1
        N20 IF[2 <> 2]THEN #102=1
        N30 IF[3 <> 2]THEN #103=1
        N40 M30
    """,
    variables={101: 0, 102: 0, 103: 0}, runs="N10 N20 N30 N40", vars={101: 1, 102: 0, 103: 1},
)
case(
    "GSK: GT compares less, equal and greater as its table says",
    pins="if_form max_condition_length", control=FAMILIES, source="TDi29, conditions",
    evidence=MANUAL,
    program="""
        O1
        N10 IF[1 GT 2]THEN #101=1
        N20 IF[2 GT 2]THEN #102=1
        N30 IF[3 GT 2]THEN #103=1
        N40 M30
    """,
    variables={101: 0, 102: 0, 103: 0}, runs="N10 N20 N30 N40", vars={101: 0, 102: 0, 103: 1},
)
case(
    "GSK: > compares less, equal and greater as its table says",
    pins="if_form max_condition_length", control=[TDI], source="TDi29, conditions", evidence=MANUAL,
    program="""
        O1
        N10 IF[1 > 2]THEN #101=1
        N20 IF[2 > 2]THEN #102=1
        N30 IF[3 > 2]THEN #103=1
        N40 M30
    """,
    variables={101: 0, 102: 0, 103: 0}, runs="N10 N20 N30 N40", vars={101: 0, 102: 0, 103: 1},
)
case(
    "GSK: GE compares less, equal and greater as its table says",
    pins="if_form max_condition_length", control=FAMILIES, source="TDi29, conditions",
    evidence=MANUAL,
    program="""
        O1
        N10 IF[1 GE 2]THEN #101=1
        N20 IF[2 GE 2]THEN #102=1
        N30 IF[3 GE 2]THEN #103=1
        N40 M30
    """,
    variables={101: 0, 102: 0, 103: 0}, runs="N10 N20 N30 N40", vars={101: 0, 102: 1, 103: 1},
)
case(
    "GSK: >= compares less, equal and greater as its table says",
    pins="if_form max_condition_length", control=[TDI], source="TDi29, conditions", evidence=MANUAL,
    program="""
        O1
        N10 IF[1 >= 2]THEN #101=1
        N20 IF[2 >= 2]THEN #102=1
        N30 IF[3 >= 2]THEN #103=1
        N40 M30
    """,
    variables={101: 0, 102: 0, 103: 0}, runs="N10 N20 N30 N40", vars={101: 0, 102: 1, 103: 1},
)
case(
    "GSK: LT compares less, equal and greater as its table says",
    pins="if_form max_condition_length", control=FAMILIES, source="TDi29, conditions",
    evidence=MANUAL,
    program="""
        O1
        N10 IF[1 LT 2]THEN #101=1
        N20 IF[2 LT 2]THEN #102=1
        N30 IF[3 LT 2]THEN #103=1
        N40 M30
    """,
    variables={101: 0, 102: 0, 103: 0}, runs="N10 N20 N30 N40", vars={101: 1, 102: 0, 103: 0},
)
case(
    "GSK: < compares less, equal and greater as its table says",
    pins="if_form max_condition_length", control=[TDI], source="TDi29, conditions", evidence=MANUAL,
    program="""
        O1
        N10 IF[1 < 2]THEN #101=1
        N20 IF[2 < 2]THEN #102=1
        N30 IF[3 < 2]THEN #103=1
        N40 M30
    """,
    variables={101: 0, 102: 0, 103: 0}, runs="N10 N20 N30 N40", vars={101: 1, 102: 0, 103: 0},
)
case(
    "GSK: LE compares less, equal and greater as its table says",
    pins="if_form max_condition_length", control=FAMILIES, source="TDi29, conditions",
    evidence=MANUAL,
    program="""
        O1
        N10 IF[1 LE 2]THEN #101=1
        N20 IF[2 LE 2]THEN #102=1
        N30 IF[3 LE 2]THEN #103=1
        N40 M30
    """,
    variables={101: 0, 102: 0, 103: 0}, runs="N10 N20 N30 N40", vars={101: 1, 102: 1, 103: 0},
)
case(
    "GSK: <= compares less, equal and greater as its table says",
    pins="if_form max_condition_length", control=[TDI], source="TDi29, conditions", evidence=MANUAL,
    program="""
        O1
        N10 IF[1 <= 2]THEN #101=1
        N20 IF[2 <= 2]THEN #102=1
        N30 IF[3 <= 2]THEN #103=1
        N40 M30
    """,
    variables={101: 0, 102: 0, 103: 0}, runs="N10 N20 N30 N40", vars={101: 1, 102: 1, 103: 0},
)
case(
    "GSK: GOTO goes forward",
    control=FAMILIES, source="TDi29, GOTO", evidence=MANUAL,
    program="O1\nN10 GOTO 30\nN20 G0 X1\nN30 M30\n", runs="N10 N30",
)
case(
    "GSK: GOTO goes back",
    control=FAMILIES, source="TDi29, GOTO", evidence=MANUAL,
    program="O1\nN10 #100=#100+1\nN20 IF[#100 GE 3]GOTO 40\nN30 GOTO 10\nN40 M30\n",
    variables={100: 0}, runs="(N10 N20 N30)*2 N10 N20 N40", vars={100: 3},
)
case(
    "GSK: GOTO finds a number written with leading zeros",
    control=FAMILIES, source="TDi29, GOTO", evidence=INFERRED,
    program="O1\nN10 GOTO30\nN20 G0 X1\nN0030 M30\n", runs="N10 N30",
)
case(
    "GSK: GOTO takes its number from a variable",
    control=FAMILIES, source="TDi29, GOTO#101", evidence=MANUAL,
    program="O1\nN10 GOTO#101\nN20 G0 X1\nN30 M30\n", variables={101: 30}, runs="N10 N30",
)
case(
    "GSK: GOTO takes its number from an expression",
    control=FAMILIES, source="TDi29, GOTO", evidence=MANUAL,
    program="O1\nN10 GOTO[#101*10]\nN20 G0 X1\nN30 M30\n", variables={101: 3}, runs="N10 N30",
)
case(
    "GSK: GOTO reaches N99999",
    pins="max_sequence_number max_jump_number",
    control=[*FAMILIES, "haas-ngc"], source="Talm 213; TDi29, GOTO", evidence=MANUAL,
    program="O1\nN10 GOTO 99999\nN20 G0 X1\nN99999 M30\n", runs="N10 N99999",
)
case(
    "GSK: IF GOTO with a false condition goes on",
    control=FAMILIES, source="TDi29, IF", evidence=MANUAL,
    program="O1\nN10 IF[#101 GT 10]GOTO 30\nN20 G0 X1\nN30 M30\n", variables={101: 10},
    runs="N10 N20 N30",
)
case(
    "GSK 980TDi: the manual's sum of 1 to 10 is 55",
    control=TDI, source="TDi29, example O9500", evidence=MANUAL,
    program="""
        O9500
        N100 #101=0
        N110 #2=1
        N1 IF[#2 GT 10]GOTO2
        N120 #101=#101+#2
        N130 #2=#2+1
        N140 GOTO1
        N2 M30
    """,
    runs="N100 N110 (N1 N120 N130 N140)*10 N1 N2", vars={101: 55, 2: 11},
)
case(
    "GSK: GOTO to a number that is missing is an alarm",
    control=FAMILIES, source="Talm 213; MDia 112", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 GOTO 90\nN30 M30\n",
    runs="N10", alarm="jump-target-not-found", number=both("213", "0112"), at="O1 N20",
)
case(
    "GSK: GOTO does not look in other programs",
    control=FAMILIES, source="Talm 213; MDia 112", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 GOTO 50\nN30 M30\nO2\nN50 M99\n",
    runs="N10", alarm="jump-target-not-found", number=both("213", "0112"), at="O1 N20",
)
case(
    "GSK: GOTO of a subprogram does not look in its caller",
    control=FAMILIES, source="Talm 213; MDia 112", evidence=SECONDARY,
    program="O1\nN10 M98 P2\nN20 M30\nO2\nN30 GOTO 20\nN40 M99\n",
    runs="N10", alarm="jump-target-not-found", number=both("213", "0112"), at="O2 N30",
)
case(
    "GSK: GOTO 0 is an alarm",
    control=FAMILIES, source="Talm 213; TDi29, GOTO; MDia 112", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 GOTO 0\nN30 M30\n",
    runs="N10", alarm="illegal-jump-number", number=both("213", "0112"), at="O1 N20",
)
case(
    "GSK: GOTO 100000 is an alarm",
    control=FAMILIES, source="Talm 213; TDi29, GOTO; MDia 112", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 GOTO 100000\nN30 M30\n",
    runs="N10", alarm="illegal-jump-number", number=both("213", "0112"), at="O1 N20",
)
case(
    "GSK: a variable below 1 is no target of GOTO",
    control=FAMILIES, source="Talm 213; TDi29, GOTO; MDia 112", evidence=SECONDARY,
    program="O1\nN10 #101=-5\nN20 GOTO #101\nN30 M30\n",
    runs="N10", alarm="illegal-jump-number", number=both("213", "0112"), at="O1 N20",
)
case(
    "GSK: IF GOTO to a number that is missing alarms only when it jumps",
    control=FAMILIES, source="Talm 213; MDia 112", evidence=SECONDARY,
    program="O1\nN10 IF[1 EQ 2]GOTO 90\nN20 IF[1 EQ 1]GOTO 90\nN30 M30\n",
    runs="N10", alarm="jump-target-not-found", number=both("213", "0112"), at="O1 N20",
)
case(
    "GSK: WHILE runs its loop while the condition is true",
    pins="loop_form",
    control=FAMILIES, source="TDi29, WHILE", evidence=MANUAL,
    program="O1\nN10 WHILE[#100 LT 3]DO1\nN20 #100=#100+1\nN30 END1\nN40 M30\n",
    variables={100: 0}, runs="(N10 N20 N30)*3 N10 N40", vars={100: 3},
)
case(
    "GSK: WHILE with a false condition goes after its END",
    control=FAMILIES, source="TDi29, WHILE", evidence=MANUAL,
    program="O1\nN10 WHILE[#100 LT 3]DO1\nN20 #100=#100+1\nN30 END1\nN40 M30\n",
    variables={100: 7}, runs="N10 N40", vars={100: 7},
)
case(
    "GSK: a loop number may be used again",
    control=FAMILIES, source="TDi29, WHILE", evidence=MANUAL,
    program="""
        O1
        N10 WHILE[#100 LT 1]DO1
        N20 #100=#100+1
        N30 END1
        N40 WHILE[#100 LT 2]DO1
        N50 #100=#100+1
        N60 END1
        N70 M30
    """,
    variables={100: 0}, runs="N10 N20 N30 N10 N40 N50 N60 N40 N70", vars={100: 2},
)
case(
    "GSK: three loops inside each other are legal",
    pins="max_loop_number max_loops",
    control=FAMILIES, source="TDi29, WHILE", evidence=MANUAL,
    program="""
        O1
        N10 WHILE[#101 LT 1]DO1
        N20 WHILE[#102 LT 1]DO2
        N30 WHILE[#103 LT 2]DO3
        N40 #103=#103+1
        N50 END3
        N60 #102=#102+1
        N70 END2
        N80 #101=#101+1
        N90 END1
        N100 M30
    """,
    variables={101: 0, 102: 0, 103: 0},
    runs="N10 N20 (N30 N40 N50)*2 N30 N60 N70 N20 N80 N90 N10 N100",
)
case(
    "GSK: GOTO may leave a loop",
    control=FAMILIES, source="TDi29, loops", evidence=INFERRED,
    program="O1\nN10 WHILE[1 EQ 1]DO1\nN20 GOTO 40\nN30 END1\nN40 M30\n",
    runs="N10 N20 N40",
)
case(
    "GSK: a loop may call a subprogram",
    control=FAMILIES, source="source 000; TDi29, loops", evidence=INFERRED,
    program="""
        O1
        N10 WHILE[#100 LT 2]DO1
        N20 M98 P2
        N30 END1
        N40 M30
        O2
        N50 #100=#100+1
        N60 M99
    """,
    variables={100: 0}, runs="(N10 N20 N50 N60 N30)*2 N10 N40",
)
case(
    "GSK: a macro may use the loop number of its caller",
    control=FAMILIES, source="TA27; TDi29, loops", evidence=INFERRED,
    program="""
        O1
        N10 WHILE[#100 LT 1]DO1
        N20 G65 P2 A0
        N30 #100=#100+1
        N40 END1
        N50 M30
        O2
        N60 WHILE[#1 LT 2]DO1
        N70 #1=#1+1
        N80 END1
        N90 M99
    """,
    variables={100: 0},
    runs="N10 N20 (N60 N70 N80)*2 N60 N90 N30 N40 N10 N50",
)
case(
    "GSK 988: DO4 is an alarm",
    control=FAMILY_988, source="Talm 211", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 WHILE[1 EQ 2]DO4\nN30 END4\nN40 M30\n",
    runs="N10", alarm="illegal-loop-number", number="211", at="O1 N20",
)
case(
    "GSK 980TDi: DO4 is an alarm",
    control=TDI, source="TDi29, WHILE; number from MDia 102", evidence=INFERRED,
    program="O1\nN10 G0 X1\nN20 WHILE[1 EQ 2]DO4\nN30 END4\nN40 M30\n",
    runs="N10", alarm="illegal-loop-number", number="0102", at="O1 N20",
)
case(
    "GSK: DO0 is an alarm",
    control=FAMILIES, source="Talm 211; MDia 102", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 WHILE[1 EQ 2]DO0\nN30 END0\nN40 M30\n",
    runs="N10", alarm="illegal-loop-number", number=both("211", "0102"), at="O1 N20",
)
case(
    "GSK: a DO without its END is an alarm",
    control=FAMILIES, source="Talm 209; MDia 103", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 WHILE[#100 LT 3]DO1\nN30 #100=#100+1\nN40 M30\n",
    variables={100: 0}, runs="N10", alarm="missing-end", number=both("209", "0103"), at="O1 N20",
)
case(
    "GSK: an END without its DO is an alarm",
    control=FAMILIES, source="Talm 209; MDia 103", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 END1\nN30 M30\n",
    runs="N10", alarm="missing-do", number=both("209", "0103"), at="O1 N20",
)
case(
    "GSK: an END of another number does not close a loop",
    control=FAMILIES, source="Talm 209; MDia 103", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 WHILE[#100 LT 3]DO1\nN30 #100=#100+1\nN40 END2\nN50 M30\n",
    variables={100: 0}, runs="N10", alarm="missing-end", number=both("209", "0103"), at="O1 N20",
)
case(
    "GSK: loops that cross are an alarm",
    control=FAMILIES, source="Talm 209; MDia 103; TDi29, nesting", evidence=SECONDARY,
    program="""
        O1
        N10 WHILE[#100 LT 3]DO1
        N20 WHILE[#100 LT 3]DO2
        N30 #100=#100+1
        N40 END1
        N50 END2
        N60 M30
    """,
    variables={100: 0}, alarm="missing-end", number=both("209", "0103"),
)
case(
    "GSK: a jump into a loop is an alarm",
    control=FAMILIES, source="Talm 209; MDia 103", evidence=SECONDARY,
    program="""
        O1
        N10 GOTO 30
        N20 WHILE[#100 LT 3]DO1
        N30 #100=#100+1
        N40 END1
        N50 M30
    """,
    variables={100: 0}, alarm="missing-do", number=both("209", "0103"),
)
case(
    "GSK 988: GOTO 10 is refused in MDI",
    pins="refuses:jump-in-mdi", control=FAMILY_988, source="Talm 208", evidence=SECONDARY,
    program="O1\nN10 M30\n",
    mdi="N5 G0 X1\nN6 GOTO 10", runs="N5", alarm="jump-in-mdi", number="208",
)
case(
    "GSK 988: IF[1 EQ is refused in MDI",
    pins="refuses:jump-in-mdi", control=FAMILY_988, source="Talm 208", evidence=SECONDARY,
    program="O1\nN10 M30\n",
    mdi="N5 G0 X1\nN6 IF[1 EQ 1]GOTO 10", runs="N5", alarm="jump-in-mdi", number="208",
)
case(
    "GSK 988: WHILE[1 is refused in MDI",
    pins="refuses:jump-in-mdi", control=FAMILY_988, source="Talm 208", evidence=SECONDARY,
    program="O1\nN10 M30\n",
    mdi="N5 G0 X1\nN6 WHILE[1 EQ 2]DO1\nN7 END1", runs="N5", alarm="jump-in-mdi", number="208",
)
case(
    "GSK: an assignment is legal in MDI",
    control=FAMILIES, source="Talm 208 names jumps only", evidence=INFERRED,
    program="O1\nN10 M30\n", mdi="N5 #100=2*3\nN6 #101=#100+1", runs="N5 N6", vars={100: 6, 101: 7},
)
case(
    "GSK 980: IF without GOTO and THEN is an alarm",
    control=FAMILY_980, source="MDia 101", evidence=MANUAL,
    program="O1\nN10 G0 X1\nN20 IF[1 EQ 1]\nN30 M30\n",
    runs="N10", alarm="if-format", number="0101", at="O1 N20",
)
case(
    "GSK 980: WHILE without DO is an alarm",
    control=FAMILY_980, source="MDia 101", evidence=MANUAL,
    program="O1\nN10 G0 X1\nN20 WHILE[1 EQ 1]\nN30 END1\nN40 M30\n",
    runs="N10", alarm="while-format", number="0101", at="O1 N20",
)
case(
    "GSK: IF THEN with a false condition assigns nothing",
    control=FAMILIES, source="TDi29, IF THEN", evidence=MANUAL,
    program="O1\nN10 IF[#101 EQ #102]THEN #103=0\nN20 M30\n", variables={101: 1, 102: 2, 103: 9},
    runs="N10 N20", vars={103: 9},
)
case(
    "GSK: IF THEN with a false condition does not compute its right side",
    control=FAMILIES, source="TDi29, IF THEN", evidence=INFERRED,
    program="O1\nN10 IF[#101 NE 0]THEN #103=1/#101\nN20 M30\n", variables={101: 0, 103: 9},
    runs="N10 N20", vars={103: 9},
)
case(
    "GSK: a jump number may be computed in IF GOTO",
    control=FAMILIES, source="TDi29, GOTO", evidence=INFERRED,
    program="O1\nN10 IF[#101 EQ 3]GOTO[#101*10]\nN20 G0 X1\nN30 M30\n", variables={101: 3},
    runs="N10 N30",
)
