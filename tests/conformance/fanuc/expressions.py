"""FANUC: expressions, their priority, brackets and form."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
NEW = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
LATE = ["fanuc-0i-f", "fanuc-30i"]
NOT_D = ["fanuc-16i", "fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


case(
    "multiplication comes before addition",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=2+3*4
        N20 M30
    """,
    runs="N10 N20", vars={100: 14},
)
case(
    "division comes before subtraction",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=10-6/2
        N20 M30
    """,
    runs="N10 N20", vars={100: 7},
)
case(
    "equal priorities go from left to right",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=20/2*5
        N20 M30
    """,
    runs="N10 N20", vars={100: 50},
)
case(
    "subtraction goes from left to right",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=10-4-3
        N20 M30
    """,
    runs="N10 N20", vars={100: 3},
)
case(
    "AND comes before addition",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=5+6 AND 3
        N20 M30
    """,
    runs="N10 N20", vars={100: 7},
)
case(
    "AND has the priority of multiplication and goes from left to right",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=10 AND 4*3
        N20 M30
    """,
    runs="N10 N20", vars={100: 0},
)
case(
    "OR has the priority of addition",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=1 OR 2*4
        N20 M30
    """,
    runs="N10 N20", vars={100: 9},
)
case(
    "XOR has the priority of addition and goes from left to right",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=9-4 XOR 2
        N20 M30
    """,
    runs="N10 N20", vars={100: 7},
)
case(
    "OR comes after AND",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=8 OR 6 AND 3
        N20 M30
    """,
    runs="N10 N20", vars={100: 10},
)
case(
    "a function comes before multiplication",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=2*SQRT[9]
        N20 M30
    """,
    runs="N10 N20", vars={100: 6},
)
case(
    "brackets come first",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=[2+3]*4
        N20 M30
    """,
    runs="N10 N20", vars={100: 20},
)
case(
    "a minus sign stands before a bracket",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=-[2+3]
        N20 M30
    """,
    runs="N10 N20", vars={100: -5},
)
case(
    "a minus sign stands before a variable",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N5 #4=7
        N10 #100=-#4+1
        N20 M30
    """,
    runs="N5 N10 N20", vars={100: -6},
)
case(
    "a number may begin with its point",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=.5+1
        N20 M30
    """,
    runs="N10 N20", vars={100: 1.5},
)
case(
    "a number may end with its point",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=5.*2.
        N20 M30
    """,
    runs="N10 N20", vars={100: 10},
)
case(
    "a slash in an expression divides",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #100=9/2
        N20 M30
    """,
    runs="N10 N20", vars={100: 4.5},
)
case(
    "a slash in an expression divides while block skip is on",
    control=ALL, source="GED; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=9/2
        N20 M30
    """,
    skip=(1,), runs="N10 N20", vars={100: 4.5},
)
case(
    "five brackets deep is legal, the function's own counted",
    control=ALL, source="X-NUL, ALM PS0118", evidence="secondary",
    program="""
        O1
        N10 #100=ABS[[[[[0-4]]]]]
        N20 M30
    """,
    runs="N10 N20", vars={100: 4},
)
case(
    "six brackets deep is too deep",
    control=ALL, source="X-NUL, ALM PS0118", evidence="secondary",
    program="""
        O1
        N10 #100=[[[[[[1]]]]]]
        N20 M30
    """,
    runs="", alarm="brackets-too-deep", number=numbers("118", "PS0118"), at="O1 N10",
)
case(
    "six brackets deep at an address is too deep",
    control=ALL, source="X-NUL, ALM PS0118", evidence="secondary",
    program="""
        O1
        N10 T[[[[[[1]]]]]]
        N20 M30
    """,
    runs="", alarm="brackets-too-deep", number=numbers("118", "PS0118"), at="O1 N10", t=[],
)
case(
    "brackets one after the other are not nested",
    control=ALL, source="X-NUL, ALM PS0118", evidence="secondary",
    program="""
        O1
        N10 #100=[1]+[1]+[1]+[1]+[1]+[1]+[1]
        N20 M30
    """,
    runs="N10 N20", vars={100: 7},
)
case(
    "a closing bracket too few alarms",
    control=ALL, source="ALM PS1132; K-H 125", evidence="secondary",
    program="""
        O1
        N10 #100=[1+2
        N20 M30
    """,
    runs="", alarm="bracket-not-closed", number=numbers("125", "PS1132"), at="O1 N10",
)
case(
    "a closing bracket too many alarms",
    control=ALL, source="ALM PS1131; K-H 114", evidence="secondary",
    program="""
        O1
        N10 #100=1+2]
        N20 M30
    """,
    runs="", alarm="bracket-not-opened", number=numbers("114", "PS1131"), at="O1 N10",
)
case(
    "brackets, functions, signs and variables of computed numbers stand inside each other",
    control=ALL, source="K-H priorities; NCT", evidence="inferred",
    program="""
        O1
        N10 #1=1
        N20 #2=100
        N30 #100=-8
        N40 #101=-[#[#[#1+1]]+2*[3-SIN[30]*4]]/-[#1-#2*ABS[-0.03]]
        N50 #102=ATAN[ABS[#100]]/[#[#1+#2-1]]
        N60 M30
    """,
    runs="N10 N20 N30 N40 N50 N60", vars={101: 3, 102: 135},
)
case(
    "a function without its closing bracket alarms",
    control=ALL, source="ALM PS1132; K-H 125", evidence="secondary",
    program="""
        O1
        N10 #100=SQRT[4
        N20 M30
    """,
    runs="", alarm="bracket-not-closed", number=numbers("125", "PS1132"), at="O1 N10",
)
case(
    "a variable alone in a block lacks its equals sign",
    control=NEW, source="ALM PS1133", evidence="secondary",
    program="""
        O1
        N10 #100
        N20 M30
    """,
    runs="", alarm="missing-equals", number="PS1133", at="O1 N10",
)
case(
    "an expression alone in a block lacks its equals sign",
    control=NEW, source="ALM PS1133", evidence="secondary",
    program="""
        O1
        N10 #100+5
        N20 M30
    """,
    runs="", alarm="missing-equals", number="PS1133", at="O1 N10",
)
case(
    "POW with one argument lacks its comma",
    control=LATE, source="ALM PS1134", evidence="secondary",
    program="""
        O1
        N10 #100=POW[2]
        N20 M30
    """,
    runs="", alarm="missing-comma", number="PS1134", at="O1 N10",
)
case(
    "an expression that ends in an operator alarms",
    control=ALL, source="ALM PS1125; K-H 125", evidence="secondary",
    program="""
        O1
        N10 #100=5+
        N20 M30
    """,
    runs="", alarm="expression-format", number=numbers("125", "PS1125"), at="O1 N10",
)
case(
    "an expression that begins with a multiplication alarms",
    control=ALL, source="ALM PS1125; K-H 125", evidence="secondary",
    program="""
        O1
        N10 #100=*5
        N20 M30
    """,
    runs="", alarm="expression-format", number=numbers("125", "PS1125"), at="O1 N10",
)
case(
    "an assignment without a value alarms",
    control=ALL, source="ALM PS1125; K-H 125", evidence="secondary",
    program="""
        O1
        N10 #100=
        N20 M30
    """,
    runs="", alarm="expression-format", number=numbers("125", "PS1125"), at="O1 N10",
)
case(
    "empty brackets alarm",
    control=ALL, source="ALM PS1125; K-H 125", evidence="secondary",
    program="""
        O1
        N10 #100=SQRT[]
        N20 M30
    """,
    runs="", alarm="expression-format", number=numbers("125", "PS1125"), at="O1 N10",
)
case(
    "two values without an operator alarm",
    control=ALL, source="ALM PS1125; K-H 125", evidence="secondary",
    program="""
        O1
        N10 #100=[5][6]
        N20 M30
    """,
    runs="", alarm="expression-format", number=numbers("125", "PS1125"), at="O1 N10",
)
case(
    "the result of a comparison is no number",
    control=ALL, source="MEX; ALM PS1125", evidence="secondary",
    program="""
        O1
        N10 #100=[3 GT 2]
        N20 M30
    """,
    runs="", alarm="expression-format", number=numbers("125", "PS1125"), at="O1 N10",
)
case(
    "a statement whose condition is false has to be right all the same",
    control=ALL, source="policy: a control reads a block when it reaches it", evidence="inferred",
    program="""
        O1
        N10 IF[1 EQ 2]THEN #100=5+
        N20 M30
    """,
    runs="", alarm="expression-format", number=numbers("125", "PS1125"), at="O1 N10",
)
case(
    "ASIN out of range at an address alarms",
    control=NOT_D, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 T[ASIN[2]]
        N30 M30
    """,
    runs="N10", alarm="arc-sine-out-of-range",
    number={"fanuc-16i": "111", "fanuc-0i-f": "PS0119", "fanuc-30i": "PS0119"}, at="O1 N20", t=[1],
)
case(
    "a bracket at an address that is not closed alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 T[3+4
        N30 M30
    """,
    runs="N10", alarm="bracket-not-closed", number=numbers("125", "PS1132"), at="O1 N20", t=[1],
)

case(
    "brackets come first, then times and divide, then plus and minus (F501)",
    control=["fanuc-16i", "fanuc-30i"],
    source="NCT; a public interpreter's examples; general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        #101=100*[5/25]
        #102=10/2+3
        #103=10/[2+3]
        #104=1+2+3+4+5
        #105=[20-5]*2
        #106=20-[5*2]
        #107=2*3+5*2
        #108=2*[3+5]*2
        #109=[1+[2*[3]]]+[[6*2]+2]
        #110=5+2*3+5*[2+2]*2+4
        M30
    """,
    vars={101: 20, 102: 8, 103: 2, 104: 15, 105: 30, 106: 10, 107: 16, 108: 32, 109: 21, 110: 55},
)

case(
    "functions come before times and AND, and these before plus, OR and XOR (F510)",
    control=["fanuc-16i", "fanuc-30i"],
    source="NCT; ALI; general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        #4=90
        #101=1+2*SIN[#4]
        #102=6 AND 3
        #103=4 OR 3
        #104=6 XOR 3
        #105=1+2 OR 4
        #106=1+6 AND 3
        M30
    """,
    vars={101: 3, 102: 2, 103: 7, 104: 5, 105: 7, 106: 3},
)

case(
    "five brackets inside each other are legal (F511)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0118; X-NUL",
    evidence="maker's manual",
    program="""
        O1
        #101=[[[[[1]]]]]
        #102=SIN[[[[90]]]]
        M30
    """,
    vars={101: 1, 102: 1},
)

case(
    "six brackets inside each other alarm (F512)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0118; X-NUL",
    evidence="maker's manual",
    program="""
        O1
        #101=SIN[[[[[[90]]]]]]
        M30
    """,
    alarm="brackets-too-deep",
    number={"fanuc-16i": "118", "fanuc-30i": "PS0118"},
    at="O1",
)

case(
    "a division by zero alarms (F513)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0112; 16i: general knowledge of the FANUC manuals",
    evidence="maker's manual",
    program="""
        O1
        #1=0
        #101=5/#1
        M30
    """,
    alarm="division-by-zero",
    number={"fanuc-16i": "112", "fanuc-30i": "PS0112"},
    at="O1",
)
