"""FANUC: functions."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
NEW = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
LATE = ["fanuc-0i-f", "fanuc-30i"]
NOT_D = ["fanuc-16i", "fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


case(
    "SIN takes degrees",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=SIN[30]
        N20 M30
    """,
    runs="N10 N20", vars={100: 0.5},
)
case(
    "COS takes degrees",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=COS[60]
        N20 M30
    """,
    runs="N10 N20", vars={100: 0.5},
)
case(
    "TAN takes degrees",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=TAN[45]
        N20 M30
    """,
    runs="N10 N20", vars={100: 1},
)
case(
    "ASIN of a negative value lies between 270 and 360",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=ASIN[-1]
        N20 M30
    """,
    runs="N10 N20", vars={100: 270},
)
case(
    "ASIN of a positive value lies between 0 and 90",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=ASIN[0.5]
        N20 M30
    """,
    runs="N10 N20", vars={100: 30},
)
case(
    "with 6004#0=1 ASIN of a negative value is negative",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=ASIN[-0.5]
        N20 M30
    """,
    params={"6004#0": 1}, runs="N10 N20", vars={100: -30},
)
case(
    "ACOS lies between 0 and 180",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=ACOS[-0.5]
        N20 M30
    """,
    runs="N10 N20", vars={100: 120},
)
case(
    "ATAN takes two operands and knows the second quadrant",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=ATAN[1]/[-1]
        N20 M30
    """,
    runs="N10 N20", vars={100: 135},
)
case(
    "ATAN in the third quadrant is above 180",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=ATAN[-1]/[-1]
        N20 M30
    """,
    runs="N10 N20", vars={100: 225},
)
case(
    "ATAN in the fourth quadrant is above 270",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=ATAN[-1]/[1]
        N20 M30
    """,
    runs="N10 N20", vars={100: 315},
)
case(
    "with 6004#0=1 ATAN in the fourth quadrant is negative",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=ATAN[-1]/[1]
        N20 M30
    """,
    params={"6004#0": 1}, runs="N10 N20", vars={100: -45},
)
case(
    "the second slash after ATAN divides",
    control=ALL, source="ALI; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=ATAN[1]/[1]/9
        N20 M30
    """,
    runs="N10 N20", vars={100: 5},
)
case(
    "ATAN takes a comma on later controls",
    control=NEW, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=ATAN[1,-1]
        N20 M30
    """,
    runs="N10 N20", vars={100: 135},
)
case(
    "ATAN with one operand is the arc tangent on later controls",
    control=LATE, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=ATAN[1]
        N20 M30
    """,
    runs="N10 N20", vars={100: 45},
)
case(
    "SQRT is the square root",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=SQRT[2.25]
        N20 M30
    """,
    runs="N10 N20", vars={100: 1.5},
)
case(
    "ABS drops the sign",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=ABS[3-10]
        N20 M30
    """,
    runs="N10 N20", vars={100: 7},
)
case(
    "LN is the natural logarithm",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=LN[EXP[2]]
        N20 M30
    """,
    runs="N10 N20", vars={100: 2},
)
case(
    "EXP is the power of e",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=EXP[1]
        N20 M30
    """,
    runs="N10 N20", vars={100: 2.7182818},
)
case(
    "ROUND rounds to a whole number in a macro statement",
    control=ALL, source="CSD, ALI", evidence="secondary",
    program="""
        O1
        N10 #100=ROUND[1.2345]
        N20 M30
    """,
    runs="N10 N20", vars={100: 1},
)
case(
    "ROUND rounds half up",
    control=ALL, source="SIN", evidence="secondary",
    program="""
        O1
        N10 #100=ROUND[2.5]
        N20 M30
    """,
    runs="N10 N20", vars={100: 3},
)
case(
    "ROUND rounds a negative half away from zero",
    control=ALL, source="policy", evidence="inferred",
    program="""
        O1
        N10 #100=ROUND[-2.5]
        N20 M30
    """,
    runs="N10 N20", vars={100: -3},
)
case(
    "FIX drops the fraction",
    control=ALL, source="CSD", evidence="secondary",
    program="""
        O1
        N10 #100=FIX[1.9]
        N20 M30
    """,
    runs="N10 N20", vars={100: 1},
)
case(
    "FIX of a negative value goes toward zero",
    control=ALL, source="CSD; K-H sign", evidence="inferred",
    program="""
        O1
        N10 #100=FIX[-1.9]
        N20 M30
    """,
    runs="N10 N20", vars={100: -1},
)
case(
    "FUP goes to the next whole number",
    control=ALL, source="CSD", evidence="secondary",
    program="""
        O1
        N10 #100=FUP[1.1]
        N20 M30
    """,
    runs="N10 N20", vars={100: 2},
)
case(
    "FUP of a negative value goes away from zero",
    control=ALL, source="CSD; K-H sign", evidence="inferred",
    program="""
        O1
        N10 #100=FUP[-1.1]
        N20 M30
    """,
    runs="N10 N20", vars={100: -2},
)
case(
    "FUP of a whole number leaves it",
    control=ALL, source="CSD", evidence="secondary",
    program="""
        O1
        N10 #100=FUP[3]
        N20 M30
    """,
    runs="N10 N20", vars={100: 3},
)
case(
    "BIN reads a value as binary-coded decimal",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=BIN[37]
        N20 M30
    """,
    runs="N10 N20", vars={100: 25},
)
case(
    "BCD writes a value as binary-coded decimal",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=BCD[25]
        N20 M30
    """,
    runs="N10 N20", vars={100: 37},
)
case(
    "AND works on bits",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=12 AND 10
        N20 M30
    """,
    runs="N10 N20", vars={100: 8},
)
case(
    "OR works on bits",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=12 OR 3
        N20 M30
    """,
    runs="N10 N20", vars={100: 15},
)
case(
    "XOR works on bits",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=12 XOR 10
        N20 M30
    """,
    runs="N10 N20", vars={100: 6},
)
case(
    "AND rounds its operands",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=5.6 AND 3
        N20 M30
    """,
    runs="N10 N20", vars={100: 2},
)
case(
    "MOD is the remainder",
    control=NEW, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=17 MOD 5
        N20 M30
    """,
    runs="N10 N20", vars={100: 2},
)
case(
    "MOD has the priority of multiplication",
    control=NEW, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=2+17 MOD 5*3
        N20 M30
    """,
    runs="N10 N20", vars={100: 8},
)
case(
    "POW raises to a power",
    control=LATE, source="ALM PS1120; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=POW[2,10]
        N20 M30
    """,
    runs="N10 N20", vars={100: 1024},
)
case(
    "PRM reads a parameter",
    control=LATE, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=PRM[6050]
        N20 M30
    """,
    params={"6050": 70}, runs="N10 N20", vars={100: 70},
)
case(
    "PRM reads a bit of a parameter",
    control=LATE, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=PRM[6001,5]
        N20 M30
    """,
    params={"6001#5": 1}, runs="N10 N20", vars={100: 1},
)
case(
    "the first two letters of a function suffice on the 16i",
    control="fanuc-16i", source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=RO[SQ[6.3]]
        N20 M30
    """,
    runs="N10 N20", vars={100: 3},
)
case(
    "the square root of a negative value alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=SQRT[-4]
        N20 M30
    """,
    runs="", alarm="square-root-of-negative", number=numbers("119", "PS0119"), at="O1 N10",
)
case(
    "the logarithm of zero alarms",
    control=NOT_D, source="ALI; K-M 30i number", evidence="secondary",
    program="""
        O1
        N10 #100=LN[0]
        N20 M30
    """,
    runs="", alarm="logarithm-of-non-positive",
    number={"fanuc-16i": "111", "fanuc-0i-f": "PS0119", "fanuc-30i": "PS0119"}, at="O1 N10",
)
case(
    "the logarithm of a negative value alarms",
    control=NOT_D, source="ALI; K-M 30i number", evidence="secondary",
    program="""
        O1
        N10 #100=LN[-1]
        N20 M30
    """,
    runs="", alarm="logarithm-of-non-positive",
    number={"fanuc-16i": "111", "fanuc-0i-f": "PS0119", "fanuc-30i": "PS0119"}, at="O1 N10",
)
case(
    "ASIN of 1.5 alarms",
    control=NOT_D, source="ALI; K-M 30i number", evidence="secondary",
    program="""
        O1
        N10 #100=ASIN[1.5]
        N20 M30
    """,
    runs="", alarm="arc-sine-out-of-range",
    number={"fanuc-16i": "111", "fanuc-0i-f": "PS0119", "fanuc-30i": "PS0119"}, at="O1 N10",
)
case(
    "ACOS of -2 alarms",
    control=NOT_D, source="ALI; K-M 30i number", evidence="secondary",
    program="""
        O1
        N10 #100=ACOS[-2]
        N20 M30
    """,
    runs="", alarm="arc-sine-out-of-range",
    number={"fanuc-16i": "111", "fanuc-0i-f": "PS0119", "fanuc-30i": "PS0119"}, at="O1 N10",
)
case(
    "TAN of 90 degrees alarms on the 16i",
    control="fanuc-16i", source="K-L general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=TAN[90]
        N20 M30
    """,
    runs="", alarm="tangent-infinite", number="112", at="O1 N10",
)
case(
    "TAN of 270 degrees alarms on the 16i",
    control="fanuc-16i", source="K-L general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=TAN[270]
        N20 M30
    """,
    runs="", alarm="tangent-infinite", number="112", at="O1 N10",
)
case(
    "EXP of 150 overflows on the 16i",
    control="fanuc-16i", source="ALI, JIX", evidence="secondary",
    program="""
        O1
        N10 #100=EXP[150]
        N20 M30
    """,
    runs="", alarm="overflow", number="111", at="O1 N10",
)
case(
    "BCD of a negative value alarms",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=BCD[-1]
        N20 M30
    """,
    runs="", alarm="argument-out-of-range", number=numbers("119", "PS0119"), at="O1 N10",
)
case(
    "BIN of a value that is no decimal code alarms",
    control=ALL, source="ALI; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #100=BIN[10]
        N20 M30
    """,
    runs="", alarm="argument-out-of-range", number=numbers("119", "PS0119"), at="O1 N10",
)
case(
    "a division by zero alarms",
    control=ALL, source="ALM PS0112; K-H 112", evidence="secondary",
    program="""
        O1
        N10 #100=3/[2-2]
        N20 M30
    """,
    runs="", alarm="division-by-zero", number=numbers("112", "PS0112"), at="O1 N10",
)
case(
    "a division by zero at an address alarms before the block acts",
    control=ALL, source="ALM PS0112; K-H 112", evidence="secondary",
    program="""
        O1
        N10 T5 M[1/0]
        N20 M30
    """,
    runs="", alarm="division-by-zero", number=numbers("112", "PS0112"), at="O1 N10", t=[],
)
case(
    "a division by zero in a condition alarms",
    control=ALL, source="ALM PS0112; K-H 112", evidence="secondary",
    program="""
        O1
        N10 IF[1/0 GT 1]GOTO20
        N20 M30
    """,
    runs="", alarm="division-by-zero", number=numbers("112", "PS0112"), at="O1 N10",
)
case(
    "ROUND in a condition rounds to a whole number",
    control=ALL, source="CSD, ALI", evidence="secondary",
    program="""
        O1
        N10 IF[ROUND[1.6] EQ 2]GOTO30
        N20 T1
        N30 M30
    """,
    runs="N10 N30", t=[],
)

case(
    "ROUND in a word rounds to the increment, so that the tool comes home (F507)",
    control=["fanuc-16i", "fanuc-30i"],
    source="CSD; the numbers: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        #1=1.2345
        #2=2.3456
        G91 G0 X-#1
        G1 X-#2 F300
        G0 X[#1+#2]
        G90 X0
        G91 X-#1
        X-#2
        X[ROUND[#1]+ROUND[#2]]
        M30
    """,
    moves="""
        R X-1.235
        F X-3.581
        R X-0.001
        R X0
        R X-1.235
        R X-3.581
        R X0
    """,
)

case(
    "with 6004#0 at 1 ATAN and ASIN give angles from -180 and from -90 (F509)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALI",
    evidence="secondary",
    program="""
        O1
        #104=ATAN[-1]/[-1]
        #106=ASIN[-1]
        M30
    """,
    params={"6004#0": 1},
    vars={104: -135, 106: -90},
)

case(
    "BCD[12] is 18, and BIN[18] is 12 (F515)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALI; general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        #101=BCD[12]
        #102=BIN[18]
        M30
    """,
    vars={101: 18, 102: 12},
)
