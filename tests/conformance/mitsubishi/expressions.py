"""Mitsubishi: expressions."""

from conformance import case

case(
    "a bracket that is not closed alarms (MIT-121)",
    control="mitsubishi-m700",
    source="MZ 859, paired with P281",
    evidence="secondary",
    program="""
        O1
        G0 X1
        #1=[2+3
        M30
    """,
    moves_x=[1],
    alarm="bracket-not-closed",
    number="P281",
    at="O1",
)

MELDAS = "mitsubishi-meldas"
M700 = "mitsubishi-m700"
M800 = "mitsubishi-m800"
EVERY = [MELDAS, M700, M800]

case(
    "Mitsubishi expressions: multiplication comes before addition, 2+3*4 is 14",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=2+3*4\nN20 M30",
    runs="N10 N20", vars={100: 14},
)
case(
    "Mitsubishi expressions: brackets come first, [2+3]*4 is 20",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=[2+3]*4\nN20 M30",
    runs="N10 N20", vars={100: 20},
)
case(
    "Mitsubishi expressions: equal operators work from left to right, 20/5/2 is 2",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=20/5/2\nN20 M30",
    runs="N10 N20", vars={100: 2},
)
case(
    "Mitsubishi expressions: MOD is worked like multiplication, 1+7 MOD 4 is 4",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=1+7 MOD 4\nN20 M30",
    runs="N10 N20", vars={100: 4},
)
case(
    "Mitsubishi expressions: a minus sign may stand before a bracket, -[2+3] is -5",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=-[2+3]\nN20 M30",
    runs="N10 N20", vars={100: -5},
)
case(
    "Mitsubishi expressions: SIN takes degrees, SIN[30] is 0.5",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=SIN[30]\nN20 M30",
    runs="N10 N20", vars={100: 0.5},
)
case(
    "Mitsubishi expressions: COS takes degrees, COS[60] is 0.5",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=COS[60]\nN20 M30",
    runs="N10 N20", vars={100: 0.5},
)
case(
    "Mitsubishi expressions: TAN takes degrees, TAN[45] is 1",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=TAN[45]\nN20 M30",
    runs="N10 N20", vars={100: 1},
)
case(
    "Mitsubishi expressions: ATAN of a quotient gives degrees, ATAN[1]/[1] is 45",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=ATAN[1]/[1]\nN20 M30",
    runs="N10 N20", vars={100: 45},
)
case(
    "Mitsubishi expressions: ASIN gives degrees, ASIN[0.5] is 30",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=ASIN[0.5]\nN20 M30",
    runs="N10 N20", vars={100: 30},
)
case(
    "Mitsubishi expressions: ACOS gives degrees, ACOS[0.5] is 60",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=ACOS[0.5]\nN20 M30",
    runs="N10 N20", vars={100: 60},
)
case(
    "Mitsubishi expressions: SQRT is the square root, SQRT[16] is 4",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=SQRT[16]\nN20 M30",
    runs="N10 N20", vars={100: 4},
)
case(
    "Mitsubishi expressions: ABS takes the sign away, ABS[-3.5] is 3.5",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=ABS[-3.5]\nN20 M30",
    runs="N10 N20", vars={100: 3.5},
)
case(
    "Mitsubishi expressions: ROUND goes to the nearest whole number, ROUND[3.7] is 4",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=ROUND[3.7]\nN20 M30",
    runs="N10 N20", vars={100: 4},
)
case(
    "Mitsubishi expressions: RND is ROUND, RND[2.2] is 2",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=RND[2.2]\nN20 M30",
    runs="N10 N20", vars={100: 2},
)
case(
    "Mitsubishi expressions: FIX cuts the fraction off, FIX[3.7] is 3",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=FIX[3.7]\nN20 M30",
    runs="N10 N20", vars={100: 3},
)
case(
    "Mitsubishi expressions: FUP makes a whole one of the fraction, FUP[3.2] is 4",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=FUP[3.2]\nN20 M30",
    runs="N10 N20", vars={100: 4},
)
case(
    "Mitsubishi expressions: LN is the natural logarithm, LN[1] is 0",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=LN[1]\nN20 M30",
    runs="N10 N20", vars={100: 0},
)
case(
    "Mitsubishi expressions: EXP is the power of e, EXP[0] is 1",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=EXP[0]\nN20 M30",
    runs="N10 N20", vars={100: 1},
)
case(
    "Mitsubishi expressions: BIN reads decimal digits of a BCD value, BIN[18] is 12",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=BIN[18]\nN20 M30",
    runs="N10 N20", vars={100: 12},
)
case(
    "Mitsubishi expressions: BCD writes a value in decimal digits, BCD[12] is 18",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=BCD[12]\nN20 M30",
    runs="N10 N20", vars={100: 18},
)
case(
    "Mitsubishi expressions: AND works on the bits, 12 AND 10 is 8",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=12 AND 10\nN20 M30",
    runs="N10 N20", vars={100: 8},
)
case(
    "Mitsubishi expressions: OR works on the bits, 12 OR 10 is 14",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=12 OR 10\nN20 M30",
    runs="N10 N20", vars={100: 14},
)
case(
    "Mitsubishi expressions: XOR works on the bits, 12 XOR 10 is 6",
    control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
    program="O1\nN10 #100=12 XOR 10\nN20 M30",
    runs="N10 N20", vars={100: 6},
)
case(
    "five brackets inside each other are legal",
    control=EVERY, source="MZ 858", evidence="secondary",
    program="""
        O1
        N10 #100=[[[[[1+1]*2]*2]*2]*2]
        N20 M30
    """,
    runs="N10 N20", vars={100: 32},
)
case(
    "a sixth bracket inside is P280",
    control=EVERY, source="MZ 858, P280 paired", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 #100=[[[[[[1+1]*2]*2]*2]*2]*2]
        N30 M30
    """,
    runs="N10", alarm="brackets-too-deep", number="P280", at="O1 N20",
)
case(
    "six brackets side by side are not six inside each other",
    control=EVERY, source="MZ 858", evidence="inferred",
    program="""
        O1
        N10 #100=[1]+[1]+[1]+[1]+[1]+[1]
        N20 M30
    """,
    runs="N10 N20", vars={100: 6},
)
case(
    "a bracket that is not closed is P281 and nothing is assigned",
    control=EVERY, source="MZ 859, P281 paired", evidence="inferred",
    program="""
        O1
        N10 #100=[1+2
        N20 M30
    """,
    variables={100: 9}, runs="", vars={100: 9}, alarm="bracket-not-closed", number="P281",
    at="O1 N10",
)
case(
    "a bracket that was not opened is P281",
    control=EVERY, source="MZ 859, P281 paired", evidence="inferred",
    program="""
        O1
        N10 #100=1+2]
        N20 M30
    """,
    runs="", alarm="bracket-not-opened", number="P281", at="O1 N10",
)
case(
    "a division by zero is P283",
    control=EVERY, source="MZ 861, P283 paired", evidence="inferred",
    program="""
        O1
        N10 #100=0
        N20 #101=5/#100
        N30 M30
    """,
    runs="N10", vars={101: None}, alarm="division-by-zero", number="P283", at="O1 N20",
)
case(
    "a division by a vacant variable is P283",
    control=EVERY, source="MZ 861, P283 paired; general knowledge", evidence="inferred",
    program="""
        O1
        N10 #101=5/#5
        N20 M30
    """,
    runs="", alarm="division-by-zero", number="P283", at="O1 N10",
)
case(
    "the square root of a negative value is P282",
    control=EVERY, source="MZ 860, P282 paired", evidence="inferred",
    program="""
        O1
        N10 #100=SQRT[1-5]
        N20 M30
    """,
    runs="", alarm="square-root-of-negative", number="P282", at="O1 N10",
)
case(
    "an expression that breaks off is P282",
    control=EVERY, source="MZ 860, P282 paired", evidence="inferred",
    program="""
        O1
        N10 #100=1+
        N20 M30
    """,
    runs="", alarm="expression-format", number="P282", at="O1 N10",
)
case(
    "a result that is too large for a number is P285",
    control=EVERY, source="MZ 863; general knowledge P285", evidence="inferred",
    program="""
        O1
        N10 #100=EXP[5000]
        N20 M30
    """,
    runs="", alarm="overflow", number="P285", at="O1 N10",
)
case(
    "an assignment without its equals sign is P242",
    control=EVERY, source="MZ 847, P242 paired", evidence="inferred",
    program="""
        O1
        N10 #100 5
        N20 M30
    """,
    runs="", alarm="missing-equals", number="P242", at="O1 N10",
)
case(
    "NC words after a macro statement are P272",
    control=EVERY, source="MZ 854, P272 paired", evidence="inferred",
    program="""
        O1
        N10 #100=5 M8
        N20 M30
    """,
    runs="", m=[], vars={100: None}, alarm="nc-and-macro-in-block", number="P272", at="O1 N10",
)
case(
    "NC words in front of a macro statement are P272",
    control=EVERY, source="MZ 854, P272 paired", evidence="inferred",
    program="""
        O1
        N10 M8 #100=5
        N20 M30
    """,
    runs="", m=[], vars={100: None}, alarm="nc-and-macro-in-block", number="P272", at="O1 N10",
)
case(
    "a sequence number in front of a macro statement is no NC word",
    control=EVERY, source="MZ 854", evidence="inferred",
    program="""
        O1
        N10 #100=5
        /2 N20 #101=6
        N30 M30
    """,
    skip=(2,), runs="N10 N30", vars={100: 5, 101: None},
)
