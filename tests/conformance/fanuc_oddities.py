"""FANUC: what real programs look like (joins, spaces, abbreviations, slips of the pen)."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
NEW = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
LATE = ["fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """The number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
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

# Messages, timers, waiting

case(
    "spaces around the number of #3000 do not count, the text is data",
    control=ALL, source="real programs; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 T1
        #3000= 91 (PROBE NOT FOUND)
        N30 M30
    """,
    runs="N10", alarm="user-alarm", number=numbers("3091", "MC3091"), at="O1",
)
case(
    "#3001 below 200 tells a graphic dry run",
    control=ALL, source="real programs; REG", evidence="secondary",
    program="""
        O1
        N10 #3001=0
        N20 IF[#3001LT200000]GOTO40
        N30 T1
        N40 M30
    """,
    runs="N10 N20 N40", t=[],
)
case(
    "a loop that waits for another computer stops waiting at the second look",
    control=ALL, source="real programs", evidence="inferred",
    program="""
        O1
        N10 #500=0
        N20 WHILE[#500EQ0]DO1
        N30 END1
        N40 M30
    """,
    runs="N10 (N20 N30)*2", stop="waiting",
)
case(
    "a loop without a condition waits for nobody and spins to the limit",
    control=ALL, source="policy; a loop that reads no variable", evidence="inferred",
    program="""
        O1
        N10 DO1
        N20 M8
        N30 END1
        N40 M30
    """,
    max_blocks=31, runs="(N10 N20 N30)*10 N10", stop="limit",
)
case(
    "a GOTO to its own block spins to the limit",
    control=ALL, source="policy; a jump that reads no variable", evidence="inferred",
    program="""
        O1
        N10 GOTO 10
        N20 M30
    """,
    max_blocks=12, runs="N10*12", stop="limit",
)
case(
    "a loop that counts is no waiting loop",
    control=ALL, source="policy; a loop that changes a variable", evidence="inferred",
    program="""
        O1
        N10 #500=0
        N20 WHILE[#500LT3]DO1
        N30 #500=#500+1
        N40 END1
        N50 M30
    """,
    runs="N10 (N20 N30 N40)*3 N20 N50", vars={500: 3},
)
case(
    "a vacant #500 does not keep IF[#500 EQ 0] waiting",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N10 IF[#500EQ0]GOTO10
        N20 M30
    """,
    runs="N10 N20",
)

# Files, frames, comments, labels

case(
    "a file without a program number runs",
    control=ALL, source="real programs; policy: a file without a head is named by its stem",
    evidence="inferred",
    files={"PART.NC": "%\nN10 T1\nN20 M30\n%\n"}, runs="N10 N20", t=[1],
)
case(
    "a file without a program number that ends in a percent sign alone alarms",
    control=ALL, source="real programs; ALM PS5010", evidence="secondary",
    files={"PART.NC": "%\nN10 T1\n%\n"}, runs="N10", alarm="end-of-record",
    number=numbers("5010", "PS5010"), t=[1],
)
case(
    "the head inside a file counts, not its name",
    control=ALL, source="GED; real programs", evidence="inferred",
    files={"1234.NC": "%\nO5(PLATE)\nN10 M98 P6\nN20 M30\n%\n", "8001.NC": "O6\nN30 M99\n"},
    main="O5", runs="N10 N30 N20", calls="M98:O6",
)
case(
    "a subprogram that ends in a percent sign alone alarms in the subprogram",
    control=ALL, source="real programs; ALM PS5010; K-M general knowledge", evidence="inferred",
    program="""
        %
        O1
        N10 M98 P2
        N20 M30
        %
        O2
        N30 T1
        %
    """,
    runs="N10 N30", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O2",
)
case(
    "G99 typed for M99 returns nowhere",
    control=ALL, source="real programs; ALM PS5010", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 T1
        N40 G99
    """,
    runs="N10 N30 N40", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O2",
)
case(
    "a comment ends at its first closing parenthesis",
    control=ALL, source="GED", evidence="secondary",
    program="""
        O1
        N10 M8 (HOLE (TOP) T5
        N20 M30
    """,
    runs="N10 N20", m=[8], t=[5],
)
case(
    "a comment may hold any letters",
    control=ALL, source="real programs", evidence="inferred",
    program="""
        O1 (ДЕТАЛЬ 5)
        N10 M98 P2 (子程序)
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a comment full of asterisks is no block",
    control=ALL, source="GED; real programs", evidence="secondary",
    program="""
        O1
        (***** TOOL 5 *****)
        N10 T5
        (-----)
        N20 M30
    """,
    runs="N10 N20", t=[5],
)
case(
    "a block with a sequence number alone is a jump target",
    control=ALL, source="real programs; PB155", evidence="inferred",
    program="""
        O1
        GOTO50
        T1
        N50
        T2
        M30
    """,
    t=[2],
)
case(
    "sequence numbers may stand in any order",
    control=ALL, source="PB155", evidence="maker's manual",
    program="""
        O1
        N300 GOTO20
        N10 T1
        N20 GOTO5
        N150 T2
        N5 M30
    """,
    runs="N300 N20 N5", t=[],
)
case(
    "/#100=1 is skipped like any block",
    control=ALL, source="ISO; real programs", evidence="secondary",
    program="""
        O1
        N10 #100=5
        /N20 #100=1
        N30 M30
    """,
    skip=(1,), runs="N10 N30", vars={100: 5},
)
case(
    "/GOTO is skipped like any block",
    control=ALL, source="ISO; real programs", evidence="secondary",
    program="""
        O1
        N10 T1
        /N20 GOTO40
        N30 T2
        N40 M30
    """,
    skip=(1,), runs="N10 N30 N40", t=[1, 2],
)

# Slips of the pen

case(
    "an IF with an assignment but no THEN alarms",
    control=ALL, source="ALM PS1137; K-M 114", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 IF[1EQ1] #122=5
        N30 M30
    """,
    runs="N10", alarm="if-format", number=numbers("114", "PS1137"), at="O1 N20", vars={122: None},
)
case(
    "DO1 without WHILE is an endless loop that a jump leaves",
    control=ALL, source="real programs; K-H general knowledge", evidence="inferred",
    program="""
        O1
        DO1
        N20 #1=#1+1
        N30 IF[#1GE2]GOTO50
        N40 END1
        N50 M30
    """,
    runs="N20 N30 N40 N20 N30 N50",
)
case(
    "two equals signs are no expression",
    control=ALL, source="ALM PS1125; K-H 125", evidence="secondary",
    program="""
        O1
        N10 #100==5
        N20 M30
    """,
    runs="", alarm="expression-format", number=numbers("125", "PS1125"), at="O1 N10",
)
case(
    "two variables without an operator are no expression",
    control=ALL, source="ALM PS1125; K-H 125", evidence="secondary",
    program="""
        O1
        N10 #100=#101#102
        N20 M30
    """,
    runs="", alarm="expression-format", number=numbers("125", "PS1125"), at="O1 N10",
)
case(
    "two operators side by side are no expression",
    control=ALL, source="ALM PS1125; K-H 125", evidence="secondary",
    program="""
        O1
        N10 #100=5*/2
        N20 M30
    """,
    runs="", alarm="expression-format", number=numbers("125", "PS1125"), at="O1 N10",
)
case(
    "a nested bracket that is not closed alarms",
    control=ALL, source="ALM PS1132; K-H 125", evidence="secondary",
    program="""
        O1
        N10 #101=1
        N20 #100=[#101+[#101*2]
        N30 M30
    """,
    runs="N10", alarm="bracket-not-closed", number=numbers("125", "PS1132"), at="O1 N20",
)
case(
    "an X without its number in a long block is found before its T goes out",
    control=ALL, source="ALM PS0005", evidence="secondary",
    program="""
        O1
        N10 T5 G0 X Y2.
        N20 M30
    """,
    runs="", alarm="address-without-value", number=numbers("005", "PS0005"), at="O1 N10", word="X",
    t=[],
)
case(
    "two points in one number are found before the block acts",
    control=ALL, source="ALM PS0007", evidence="secondary",
    program="""
        O1
        N10 T5 G0 X1..5
        N20 M30
    """,
    runs="", alarm="illegal-decimal-point", number=numbers("007", "PS0007"), at="O1 N10", t=[],
)
case(
    "a jump target with a typing slip alarms when it is reached",
    control=ALL, source="ALM PS0128; K-H 128", evidence="secondary",
    program="""
        O1
        N10 #1=#1+1
        N20 IF[#1LT3]GOTO10
        N30 GOTO500
        N50 M30
    """,
    runs="(N10 N20)*3", alarm="jump-target-not-found", number=numbers("128", "PS0128"), at="O1 N30",
)
case(
    "a percent sign in mid-program ends the program there",
    control=ALL, source="GED; ALM PS5010", evidence="secondary",
    program="""
        %
        O1
        N10 T1
        %
        N20 T2
        N30 M30
    """,
    main="O1", runs="N10", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O1", t=[1],
)
case(
    "a slash before a faulty word does not hide it while the switch is off",
    control=ALL, source="ALM PS0006; GED", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 T2 /M-3
        N30 M30
    """,
    runs="N10", alarm="illegal-minus-sign", number=numbers("006", "PS0006"), at="O1 N20", t=[1],
)

# Closed libraries

case(
    "a library five calls deep runs on the later controls",
    control=NEW, source="real programs; K-H depth", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N11 M30
        O2
        N20 M98 P3
        N21 M99
        O3
        N30 M98 P4
        N31 M99
        O4
        N40 M98 P5
        N41 M99
        O5
        N50 M98 P6
        N51 M99
        O6
        N60 M99
    """,
    runs="N10 N20 N30 N40 N50 N60 N51 N41 N31 N21 N11", calls="M98:O2 M98:O3 M98:O4 M98:O5 M98:O6",
)
case(
    "a library five calls deep is too deep for the 16i",
    control="fanuc-16i", source="MC52, GED; K-H 077", evidence="maker's manual",
    program="""
        O1
        N10 M98 P2
        N11 M30
        O2
        N20 M98 P3
        N21 M99
        O3
        N30 M98 P4
        N31 M99
        O4
        N40 M98 P5
        N41 M99
        O5
        N50 M98 P6
        N51 M99
        O6
        N60 M99
    """,
    alarm="nesting-too-deep", number="077", at="O5 N50", calls="M98:O2 M98:O3 M98:O4 M98:O5",
)
case(
    "a missing file of a library alarms in the program that calls it",
    control=ALL, source="ALM PS0076; K-H 078", evidence="secondary",
    files={"O1.NC": "O1\nN10 M98 P2\nN20 M30\n", "O2.NC": "O2\nN30 T1\nN40 M98 P3\nN50 M99\n"},
    main="O1", alarm="program-not-found", number=numbers("078", "PS0076"), at="O2 N40",
    calls="M98:O2", t=[1],
)
case(
    "a six-digit program is called with L on the later controls",
    control=LATE, source="real programs; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P900038 L1
        N20 M30
        O900038
        N30 M99
    """,
    runs="N10 N30 N20", calls="M98:O900038",
)
