"""FANUC: variables, their numbers, names and ends."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


case(
    "a variable that was never set is vacant",
    control=ALL, source="JIX, VAC", evidence="secondary",
    program="""
        O1
        N10 #100=5
        N20 M30
    """,
    runs="N10 N20", vars={100: 5, 101: None, 1: None, 500: None},
)
case(
    "an assignment does not scale its value by the least input increment",
    control=ALL, source="JIX, XIA", evidence="secondary",
    program="""
        O1
        N10 #100=123
        N20 M30
    """,
    runs="N10 N20", vars={100: 123},
)
case(
    "#100=#0 makes a variable vacant",
    control=ALL, source="JIX, X-NUL", evidence="secondary",
    program="""
        O1
        N10 #100=#0
        N20 M30
    """,
    variables={100: 5}, runs="N10 N20", vars={100: None},
)
case(
    "#33, #149, #500 and #531 exist",
    control=ALL, source="JIX, GED, XIA", evidence="secondary",
    program="""
        O1
        N10 #33=1
        N20 #149=2
        N30 #500=3
        N40 #531=4
        N50 M30
    """,
    runs="N10 N20 N30 N40 N50", vars={33: 1, 149: 2, 500: 3, 531: 4},
)
case(
    "#99 does not exist",
    control=ALL, source="ALM PS0115; K-H 115", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #99=1
        N30 M30
    """,
    runs="N10", alarm="illegal-variable", number=numbers("115", "PS0115"), at="O1 N20",
)
case(
    "a variable that does not exist cannot be read",
    control=ALL, source="ALM PS0115; K-H 115", evidence="secondary",
    program="""
        O1
        N10 #100=#50
        N20 M30
    """,
    runs="", alarm="illegal-variable", number=numbers("115", "PS0115"), at="O1 N10",
    vars={100: None},
)
case(
    "a negative variable number does not exist",
    control=ALL, source="ALM PS0115; K-H 115", evidence="secondary",
    program="""
        O1
        N10 #[2-5]=1
        N20 M30
    """,
    runs="", alarm="illegal-variable", number=numbers("115", "PS0115"), at="O1 N10",
)
case(
    "a variable that does not exist cannot stand at an address",
    control=ALL, source="ALM PS0115; K-H 115", evidence="secondary",
    program="""
        O1
        N10 T#60
        N20 M30
    """,
    runs="", alarm="illegal-variable", number=numbers("115", "PS0115"), at="O1 N10", t=[],
)
case(
    "#0 cannot be assigned by way of an expression",
    control=ALL, source="JIX; K-M 116", evidence="secondary",
    program="""
        O1
        N10 #[1-1]=5
        N20 M30
    """,
    runs="", alarm="vacant-assigned", number=numbers("116", "PS0116"), at="O1 N10",
)
case(
    "#0 cannot be assigned",
    control=ALL, source="JIX; K-M 116", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #0=#1
        N30 M30
    """,
    runs="N10", alarm="vacant-assigned", number=numbers("116", "PS0116"), at="O1 N20",
)
case(
    "a variable number may be an expression in brackets",
    control=ALL, source="JIX, NCT", evidence="secondary",
    program="""
        O1
        N10 #1=100
        N20 #2=13
        N30 #[#1+#2-12]=7
        N40 M30
    """,
    runs="N10 N20 N30 N40", vars={101: 7},
)
case(
    "variable numbers may be nested",
    control=ALL, source="JIX, NCT", evidence="secondary",
    program="""
        O1
        N10 #1=2
        N20 #2=3
        N30 #3=9
        N40 #100=#[#[#1]]
        N50 M30
    """,
    runs="N10 N20 N30 N40 N50", vars={100: 9},
)
case(
    "a variable number is rounded",
    control=ALL, source="SIN", evidence="secondary",
    program="""
        O1
        N10 #[100.6]=4
        N20 M30
    """,
    runs="N10 N20", vars={101: 4, 100: None},
)
case(
    "a variable at M is rounded, half up",
    control=ALL, source="SIN", evidence="secondary",
    program="""
        O1
        N10 #1=7.5
        N20 M#1
        N30 M30
    """,
    runs="N10 N20 N30", m=[8],
)
case(
    "an expression at M is rounded",
    control=ALL, source="SIN", evidence="secondary",
    program="""
        O1
        N10 M[3.4]
        N20 M30
    """,
    runs="N10 N20", m=[3],
)
case(
    "an expression at T is rounded, half up",
    control=ALL, source="SIN", evidence="secondary",
    program="""
        O1
        N10 T[10/4]
        N20 M30
    """,
    runs="N10 N20", t=[3],
)
case(
    "a literal at M with a point is illegal although a variable is not",
    control=ALL, source="SIN; ALM PS0007", evidence="secondary",
    program="""
        O1
        N10 M3.0
        N20 M30
    """,
    runs="", alarm="illegal-decimal-point", number=numbers("007", "PS0007"), at="O1 N10",
    word="M3.0", m=[],
)
case(
    "a literal at T with a point is illegal",
    control=ALL, source="SIN; ALM PS0007", evidence="secondary",
    program="""
        O1
        N10 T3.
        N20 M30
    """,
    runs="", alarm="illegal-decimal-point", number=numbers("007", "PS0007"), at="O1 N10", t=[],
)
case(
    "the sign at an address stands before #",
    control=ALL, source="JIX, 52S", evidence="secondary",
    program="""
        O1
        N10 #1=-8
        N20 M-#1
        N30 M30
    """,
    runs="N10 N20 N30", m=[8],
)
case(
    "a vacant variable at M makes the word vanish",
    control=ALL, source="XIA, JIX", evidence="secondary",
    program="""
        O1
        N10 M#5
        N20 M30
    """,
    runs="N10 N20", m=[],
)
case(
    "a vacant variable at T makes only its own word vanish",
    control=ALL, source="XIA, JIX", evidence="secondary",
    program="""
        O1
        N10 M8 T#5
        N20 M30
    """,
    runs="N10 N20", m=[8], t=[],
)
case(
    "a zero at T is sent, a vacant is not",
    control=ALL, source="XIA, JIX", evidence="secondary",
    program="""
        O1
        N10 #1=0
        N20 T#1
        N30 T#2
        N40 M30
    """,
    runs="N10 N20 N30 N40", t=[0],
)
case(
    "in an expression at an address a vacant variable counts zero",
    control=ALL, source="M7V; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 T[#5+4]
        N20 M30
    """,
    runs="N10 N20", t=[4],
)
case(
    "a vacant variable at X leaves the axis where it is",
    control=ALL, source="XIA, JIX", evidence="secondary",
    program="""
        O1
        N10 G0 X4.
        N20 X#5 Y2.
        N30 #100=#5001
        N40 M30
    """,
    runs="N10 N20 N30 N40", vars={100: 4},
)
case(
    "adding to a vacant variable counts it as zero",
    control=ALL, source="X-NUL; NCT, M7V", evidence="secondary",
    program="""
        O1
        N10 #100=#5+3
        N20 M30
    """,
    runs="N10 N20", vars={100: 3},
)
case(
    "multiplying a vacant variable gives zero",
    control=ALL, source="X-NUL; NCT, M7V", evidence="secondary",
    program="""
        O1
        N10 #100=#5*4
        N20 M30
    """,
    runs="N10 N20", vars={100: 0},
)
case(
    "the sum of two vacant variables is zero",
    control=ALL, source="X-NUL; NCT, M7V", evidence="secondary",
    program="""
        O1
        N10 #100=#5+#6
        N20 M30
    """,
    runs="N10 N20", vars={100: 0},
)
case(
    "zero minus a vacant variable is zero",
    control=ALL, source="X-NUL; NCT, M7V", evidence="secondary",
    program="""
        O1
        N10 #100=0-#5
        N20 M30
    """,
    runs="N10 N20", vars={100: 0},
)
case(
    "a function of a vacant variable counts it as zero",
    control=ALL, source="X-NUL; NCT, M7V", evidence="secondary",
    program="""
        O1
        N10 #100=COS[#5]
        N20 M30
    """,
    runs="N10 N20", vars={100: 1},
)
case(
    "copying a vacant variable copies the vacancy",
    control=ALL, source="X-NUL; NCT, M7V", evidence="secondary",
    program="""
        O1
        N10 #100=7
        N20 #100=#5
        N30 M30
    """,
    runs="N10 N20 N30", vars={100: None},
)
case(
    "dividing by a vacant variable divides by zero",
    control=ALL, source="X-NUL; ALM PS0112", evidence="secondary",
    program="""
        O1
        N10 #100=4/#5
        N20 M30
    """,
    runs="", alarm="division-by-zero", number=numbers("112", "PS0112"), at="O1 N10",
)
case(
    "a result beyond the range of numbers alarms",
    pins="max_constant_digits",
    control=ALL, source="JIX; ALM PS0111", evidence="secondary",
    program="""
        O1
        N10 #1=10000000
        N20 #1=#1*#1
        N30 GOTO20
    """,
    alarm="overflow", number=numbers("111", "PS0111"), at="O1 N20",
)
case(
    "1E49 is beyond the range of numbers on the 16i",
    control="fanuc-16i", source="JIX", evidence="secondary",
    program="""
        O1
        N10 #1=10000000
        N20 #2=#1*#1*#1*#1*#1*#1*#1
        N30 M30
    """,
    runs="N10", alarm="overflow", number="111", at="O1 N20",
)
case(
    "nine digits in a constant are too many on the 16i",
    control="fanuc-16i", source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=123456789
        N20 M30
    """,
    runs="", alarm="too-many-digits", number="003", at="O1 N10",
)
case(
    "nine digits in a constant are not too many",
    control="fanuc-30i", source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=123456789
        N20 M30
    """,
    runs="N10 N20", vars={100: 123456789},
)
case(
    "thirteen digits in a constant are too many",
    control="fanuc-30i", source="ALM PS0003; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=1234567890123
        N20 M30
    """,
    runs="", alarm="too-many-digits", number="PS0003", at="O1 N10",
)
case(
    "a user name for a variable is set by SETVN",
    control="fanuc-30i", source="ALM PS1139, PS1141; K-M syntax", evidence="inferred",
    program="""
        O1
        N10 SETVN 510[TOOLNO,WORKNO]
        N20 [#WORKNO]=5
        N30 M30
    """,
    runs="N10 N20 N30", vars={510: None, 511: 5},
)
case(
    "a name that nobody has registered alarms",
    control="fanuc-30i", source="ALM PS1098; K-M syntax", evidence="secondary",
    program="""
        O1
        N10 #100=[#NOSUCH]
        N20 M30
    """,
    runs="", alarm="variable-name-unknown", number="PS1098", at="O1 N10",
)
case(
    "a name with an asterisk is refused by SETVN",
    control="fanuc-30i", source="ALM PS1141; K-M syntax", evidence="secondary",
    program="""
        O1
        N10 SETVN 510[TOOL*]
        N20 M30
    """,
    runs="", alarm="illegal-variable-name", number="PS1141", at="O1 N10",
)
case(
    "SETVN without a variable is refused: SETVN [TOOLNO]",
    control="fanuc-30i", source="ALM PS1139; K-M syntax", evidence="secondary",
    program="O1\nN10 T1\nN20 SETVN [TOOLNO]\nN30 M30\n",
    runs="N10", alarm="setvn-format", number="PS1139", at="O1 N20", t=[1],
)
case(
    "SETVN of a variable that is not whole is refused: SETVN 510.5[TOOLNO]",
    control="fanuc-30i", source="ALM PS1139; K-M syntax", evidence="secondary",
    program="O1\nN10 T1\nN20 SETVN 510.5[TOOLNO]\nN30 M30\n",
    runs="N10", alarm="setvn-format", number="PS1139", at="O1 N20", t=[1],
)
case(
    "SETVN with an open list is refused: SETVN 510[TOOLNO",
    control="fanuc-30i", source="ALM PS1139; K-M syntax", evidence="secondary",
    program="O1\nN10 T1\nN20 SETVN 510[TOOLNO\nN30 M30\n",
    runs="N10", alarm="setvn-format", number="PS1139", at="O1 N20", t=[1],
)
case(
    "SETVN without brackets is refused: SETVN 510 TOOLNO",
    control="fanuc-30i", source="ALM PS1139; K-M syntax", evidence="secondary",
    program="O1\nN10 T1\nN20 SETVN 510 TOOLNO\nN30 M30\n",
    runs="N10", alarm="setvn-format", number="PS1139", at="O1 N20", t=[1],
)
case(
    "a variable whose number is a division by zero alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #[1/0]=5
        N30 M30
    """,
    runs="N10", alarm="division-by-zero", number=numbers("112", "PS0112"), at="O1 N20",
)
case(
    "six brackets deep in a variable number is too deep",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #100=#[[[[[[1]]]]]]
        N30 M30
    """,
    runs="N10", alarm="brackets-too-deep", number=numbers("118", "PS0118"), at="O1 N20",
)
case(
    "a name of nine letters is too long for SETVN",
    control="fanuc-30i", source="ALM PS1142; K-M syntax", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 SETVN 510[TOOLNUMBR]
        N30 M30
    """,
    runs="N10", alarm="variable-name-too-long", number="PS1142", at="O1 N20",
)
case(
    "a negative variable number cannot be read",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #100=#[2-5]
        N30 M30
    """,
    runs="N10", alarm="illegal-variable", number=numbers("115", "PS0115"), at="O1 N20",
)

case(
    "vacant stays vacant in a copy and counts as 0 in a sum (F502)",
    control=["fanuc-16i", "fanuc-30i"],
    source="X-NUL",
    evidence="secondary",
    program="""
        O1
        #101=#1
        #102=#1*5
        #103=#1+#1
        #104=15.7+#1
        #105=15.7-#1
        #2=0
        #106=#2
        M30
    """,
    vars={101: None, 102: 0, 103: 0, 104: 15.7, 105: 15.7, 106: 0},
)

case(
    "a vacant variable takes its word out of the block, and counts as 0 in an expression (F504)",
    control=["fanuc-16i", "fanuc-30i"],
    source="XIA; JIX; M7V",
    evidence="secondary",
    program="""
        O1
        G90 G0 X5. Y5.
        #1=0
        X#1 Y#2
        X[#2+7.]
        M30
    """,
    moves="""
        R X5 Y5
        R X0
        R X7
    """,
)

case(
    "a value assigned to #0 alarms (F536)",
    control=["fanuc-16i", "fanuc-30i"],
    source="JIX; the number: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        #0=1
        M30
    """,
    alarm="vacant-assigned",
    number={"fanuc-16i": "116", "fanuc-30i": "PS0116"},
    at="O1",
)

case(
    "a value assigned to a position variable alarms (F537)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0116; 16i: general knowledge of the FANUC manuals",
    evidence="maker's manual",
    program="""
        O1
        #5001=1
        M30
    """,
    alarm="variable-write-protected",
    number={"fanuc-16i": "116", "fanuc-30i": "PS0116"},
    at="O1",
)

case(
    "#34 does not exist (F538)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0115; 16i: general knowledge of the FANUC manuals",
    evidence="maker's manual",
    program="""
        O1
        #34=1
        M30
    """,
    alarm="illegal-variable",
    number={"fanuc-16i": "115", "fanuc-30i": "PS0115"},
    at="O1",
)

case(
    "a sign stands before the variable of a word, and an expression in brackets (F541)",
    control=["fanuc-16i", "fanuc-30i"],
    source="JIX; SIN; 52S",
    evidence="secondary",
    program="""
        O1
        #1=2.5
        #2=4
        G90 G0 X-#1 Y[#1+#2]
        #3=-#1
        X#3
        M30
    """,
    moves="""
        R X-2.5 Y6.5
        R X-2.5
    """,
)
