"""FANUC, as real programs are written: joins, spaces, abbreviations, variables everywhere."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


# Joins and spaces

case(
    "IF needs no spaces at all",
    control=ALL, source="real programs; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 IF[#1EQ#0]GOTO30
        N20 T1
        N30 M30
    """,
    runs="N10 N30", t=[],
)
case(
    "a jump target may have leading zeros",
    control=ALL, source="GED; real programs", evidence="secondary",
    program="""
        O1
        N10 IF[1EQ1]GOTO0030
        N20 T1
        N30 M30
    """,
    runs="N10 N30", t=[],
)
case(
    "GOTO99 needs no space",
    control=ALL, source="real programs; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 GOTO99
        N20 T1
        N99 M30
    """,
    runs="N10 N99", t=[],
)
case(
    "a function joined to LE is read as LE and ABS",
    control=ALL, source="real programs; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #2=-2
        N20 WHILE[#1LEABS[#2]]DO1
        N30 #1=#1+1
        N40 END1
        N50 M30
    """,
    runs="N10 (N20 N30 N40)*3 N20 N50", vars={1: 3},
)
case(
    "GT joined to SQRT is read as two words",
    control=ALL, source="real programs; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 IF[3GTSQRT[4]]GOTO30
        N20 T1
        N30 M30
    """,
    runs="N10 N30",
)
case(
    "THEN may be joined to its statement",
    control=ALL, source="real programs; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 IF[1EQ1]THEN#100=2
        N20 M30
    """,
    runs="N10 N20", vars={100: 2},
)
case(
    "WHILE and DO need no spaces",
    control=ALL, source="real programs; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10WHILE[#1LT2]DO1
        N20#1=#1+1
        N30END1
        N40M30
    """,
    runs="(N10 N20 N30)*2 N10 N40", vars={1: 2},
)
case(
    "DO and END may be parted from their number",
    control=ALL, source="GED; real programs", evidence="secondary",
    program="""
        O1
        N10 WHILE [#1 LT 2] DO 1
        N20 #1 = #1 + 1
        N30 END 1
        N40 M30
    """,
    runs="(N10 N20 N30)*2 N10 N40",
)
case(
    "GO TO may be written in two words",
    control=ALL, source="GED (spaces do not count)", evidence="inferred",
    program="""
        O1
        N10 GO TO 30
        N20 T1
        N30 M30
    """,
    runs="N10 N30", t=[],
)
case(
    "a block needs no spaces between its words",
    control=ALL, source="GED; real programs", evidence="secondary",
    program="""
        O1
        N10G0X1.T5M8
        N20M30
    """,
    runs="N10 N20", m=[8], t=[5],
)
case(
    "spaces inside G, X and the number do not count",
    control=ALL, source="GED; real programs", evidence="secondary",
    program="""
        O1
        N10 G 9 0 G 0 X 1 0 . 5
        N20 #100 = #5001
        N30 M 3 0
    """,
    runs="N10 N20 N30", vars={100: 10.5},
)
case(
    "spaces around # and its brackets do not count",
    control=ALL, source="GED; real programs", evidence="secondary",
    program="""
        O1
        N10 #1 = 101
        N20 # [ #1 ] = 4
        N30 # 1 0 2 = # [ # 1 ]
        N40 M30
    """,
    runs="N10 N20 N30 N40", vars={101: 4, 102: 4},
)
case(
    "AND joined to its operands is read",
    control=ALL, source="real programs; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #1=6
        N20 #100=#1AND3
        N30 M30
    """,
    runs="N10 N20 N30", vars={100: 2},
)
case(
    "G65 needs no spaces",
    control=ALL, source="real programs; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #5=3
        N20 G65P2A#5B-.5L2
        N30 M30
        O2
        N40 M99
    """,
    runs="N10 N20 N40*2 N30", arguments={1: 3, 2: -0.5},
)
case(
    "two variables at joined addresses are two words",
    control=ALL, source="real programs; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #1=8
        N20 #2=5
        N30 M#1T#2
        N40 M30
    """,
    runs="N10 N20 N30 N40", m=[8], t=[5],
)
case(
    "blank lines are no blocks",
    control=ALL, source="real programs; K-H general knowledge", evidence="inferred",
    program="""

        O1

        N10 M98 P2


        N20 M30

        O2

        N30 M99

    """,
    runs="N10 N30 N20",
)
case(
    "lower case macro statements are read as upper case",
    control=ALL, source="policy; real programs", evidence="inferred",
    program="""
        O1
        n10 if[#1 eq #0]goto30
        n20 t1
        n30 m30
    """,
    runs="N10 N30", t=[],
)

# Abbreviations

case(
    "WH is WHILE",
    control="fanuc-16i", source="real programs; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 WH[#1LT2]DO1
        N20 #1=#1+1
        N30 END1
        N40 M30
    """,
    runs="(N10 N20 N30)*2 N10 N40",
)
case(
    "WH is WHILE in the shop code of a 0i-MD",
    control="fanuc-0i-d", source="real programs", evidence="inferred",
    program="""
        O1
        N10 WH[#1LT2]DO1
        N20 #1=#1+1
        N30 END1
        N40 M30
    """,
    runs="(N10 N20 N30)*2 N10 N40",
)
case(
    "SI is SIN",
    control="fanuc-16i", source="real programs; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=SI[30]
        N20 M30
    """,
    runs="N10 N20", vars={100: 0.5},
)
case(
    "RO is ROUND",
    control="fanuc-16i", source="real programs; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=RO[1.6]
        N20 M30
    """,
    runs="N10 N20", vars={100: 2},
)
case(
    "FI is FIX",
    control="fanuc-16i", source="real programs; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=FI[1.6]
        N20 M30
    """,
    runs="N10 N20", vars={100: 1},
)
case(
    "FU is FUP",
    control="fanuc-16i", source="real programs; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=FU[1.2]
        N20 M30
    """,
    runs="N10 N20", vars={100: 2},
)
case(
    "AB is ABS",
    control="fanuc-16i", source="real programs; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=AB[1-4]
        N20 M30
    """,
    runs="N10 N20", vars={100: 3},
)

# Variables everywhere

case(
    "#06 is #6",
    control=ALL, source="GED; real programs", evidence="inferred",
    program="""
        O1
        N10 #06=4
        N20 #100=#6
        N30 #0101=#006
        N40 M30
    """,
    runs="N10 N20 N30 N40", vars={6: 4, 100: 4, 101: 4},
)
case(
    "GOTO#140 makes a home-made subroutine",
    control=ALL, source="real programs; X-GO", evidence="secondary",
    program="""
        O1
        N10 #140=30
        N20 GOTO100
        N30 #140=50
        N40 GOTO100
        N50 M30
        N100 #100=#100+1
        N110 GOTO#140
    """,
    runs="N10 N20 N100 N110 N30 N40 N100 N110 N50", vars={100: 2},
)
case(
    "a home-made subroutine whose return was never set jumps out of range",
    control=ALL, source="X-GO, ALM PS1128", evidence="inferred",
    program="""
        O1
        N10 GOTO100
        N20 M30
        N100 T1
        N110 GOTO[#140+0]
    """,
    runs="N10 N100", alarm="illegal-jump-number", number=numbers("128", "PS1128"), at="O1 N110",
    t=[1],
)
case(
    "a home-made subroutine whose return is no block alarms",
    control=ALL, source="ALM PS0128; K-H 128", evidence="secondary",
    program="""
        O1
        N10 #140=35
        N20 GOTO100
        N30 M30
        N100 T1
        N110 GOTO#140
    """,
    runs="N10 N20 N100", alarm="jump-target-not-found", number=numbers("128", "PS0128"),
    at="O1 N110",
)
case(
    "G may be a variable",
    control=ALL, source="real programs; JIX", evidence="inferred",
    program="""
        O1
        N10 #8=91
        N20 G#8
        N30 #100=#4003
        N40 M30
    """,
    runs="N10 N20 N30 N40", vars={100: 91},
)
case(
    "a variable at G that is no G code alarms",
    control=ALL, source="ALM PS0010", evidence="inferred",
    program="""
        O1
        N10 #8=777
        N20 G#8
        N30 M30
    """,
    runs="N10", alarm="g-code-not-available", number=numbers("010", "PS0010"), at="O1 N20",
)
case(
    "M may be a variable",
    control=ALL, source="real programs; SIN", evidence="secondary",
    program="""
        O1
        N10 #1=7
        N20 M#1
        N30 M30
    """,
    runs="N10 N20 N30", m=[7],
)
case(
    "M#1 that comes to 30 ends the program",
    control=ALL, source="real programs; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #1=30
        N20 M#1
        N30 T1
        N40 M30
    """,
    runs="N10 N20", t=[],
)
case(
    "T may be a common variable",
    control=ALL, source="real programs; SIN", evidence="secondary",
    program="""
        O1
        N10 #113=12
        N20 T#113 M6
        N30 M30
    """,
    runs="N10 N20 N30", m=[6], t=[12],
)
case(
    "P and L of M98 may both be variables",
    control=ALL, source="real programs; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #501=20
        N20 #502=2
        N30 M98P[#501]L#502
        N40 M30
        O20
        N50 M99
    """,
    runs="N10 N20 N30 N50*2 N40",
)
case(
    "M98 P[#501] of a missing program alarms",
    control=ALL, source="ALM PS0076; K-H 078", evidence="secondary",
    program="""
        O1
        N10 #501=21
        N20 M98 P[#501]
        N30 M30
        O20
        N40 M99
    """,
    alarm="program-not-found", number=numbers("078", "PS0076"), at="O1 N20",
)
case(
    "M98 P[#501] of a program given as zero alarms",
    control=ALL, source="policy; ALM PS0076", evidence="inferred",
    program="""
        O1
        N10 #501=0
        N20 M98 P[#501]
        N30 M30
        O20
        N40 M99
    """,
    alarm="program-not-found", number=numbers("078", "PS0076"), at="O1 N20",
)
case(
    "a table is filled through indirect variables on both sides",
    control=ALL, source="real programs; JIX", evidence="secondary",
    program="""
        O1
        N10 #1=1
        N20 #[100+#1]=#1*10
        N30 #1=#1+1
        N40 IF[#1LE3]GOTO20
        N50 #[104]=#[#1+99]
        N60 M30
    """,
    vars={101: 10, 102: 20, 103: 30, 104: 30},
)
case(
    "the number of an offset variable may be computed",
    control=ALL, source="real programs; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #8=3
        N20 #[2000+#8]=1.25
        N30 #100=#2003
        N40 M30
    """,
    runs="N10 N20 N30 N40", vars={100: 1.25},
)
