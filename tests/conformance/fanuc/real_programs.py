"""FANUC: what real programs hold: messages, timers, waiting, comments, labels, closed libraries."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
NEW = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
LATE = ["fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


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
