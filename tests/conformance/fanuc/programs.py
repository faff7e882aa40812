"""FANUC: programs and their heads, and the programs that a call can find."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
LATE = ["fanuc-0i-f", "fanuc-30i"]

case(
    "a subprogram headed by a colon is found by its number",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 M30
        :200
        N30 M99
    """,
    runs="N10 N30 N20", calls="M98:O200",
)
case(
    "leading zeros of the O number and of P do not count",
    control=ALL, source="GED", evidence="secondary",
    program="""
        O0001
        N10 M98 P0007
        N20 M98 P7
        N30 M30
        O007
        N40 M99
    """,
    runs="N10 N40 N20 N40 N30",
)
case(
    "leading zeros of N and of the P of M99 do not count",
    control=ALL, source="GED", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M3
        N0030 M30
        O2
        N40 M99 P00030
    """,
    runs="N10 N40 N30", m=[],
)
case(
    "several programs between one pair of percent signs are programs of their own",
    control=ALL, source="GED", evidence="secondary",
    program="""
        %
        O1
        N10 M98 P3
        N20 M30
        O2
        N30 M99
        O3
        N40 M99
        %
    """,
    runs="N10 N40 N20", calls="M98:O3",
)
case(
    "a percent sign between programs does not hide the program after it",
    control=ALL, source="GED", evidence="secondary",
    program="""
        %
        O1
        N10 M98 P2
        N20 M30
        %
        O2
        N30 M99
        %
    """,
    runs="N10 N30 N20",
)
case(
    "the title after the O word is no block",
    control=ALL, source="GED", evidence="secondary",
    program="""
        O1 (MAIN PART)
        N10 M98 P2
        N20 M30
        O2 (HOLE)
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a word after the O word on the same line belongs to the first block",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1 N10 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a file without a head is called by the number in its file name",
    control=ALL, source="policy: a file without a head is named by its stem", evidence="inferred",
    files={"O1.NC": "O1\nN10 M98 P7\nN20 M30\n", "O7.NC": "N30 M99\n"}, main="O1",
    runs="N10 N30 N20",
)
case(
    "the main program may stand after its subprogram",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O2
        N30 M99
        O1
        N10 M98 P2
        N20 M30
    """,
    main="O1", runs="N10 N30 N20",
)
case(
    "a run may start at a sequence number",
    pins="statements",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=1
        N20 #101=1
        N30 M30
    """,
    start=20, runs="N20 N30", vars={100: None, 101: 1},
)
case(
    "a program is called by its name",
    control=LATE, source="K-H general knowledge; ALM PS0310", evidence="inferred",
    program="""
        O1
        N10 M98 <DRILL>
        N20 M30
        <DRILL>
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a name may hold digits, minus, plus, underscore and point",
    pins="name_marks",
    control=LATE, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 <A-1+B_2.X>
        N20 M30
        <A-1+B_2.X>
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "the name <O123> is program number 123",
    control=LATE, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 <O123>
        N20 M30
        O123
        N30 M99
    """,
    runs="N10 N30 N20", calls="M98:O123",
)
case(
    "L repeats a call by name",
    control=LATE, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 <DRILL> L3
        N20 M30
        <DRILL>
        N30 M99
    """,
    runs="N10 N30*3 N20",
)
case(
    "a named program that is not in memory is a file not found",
    control=LATE, source="ALM PS0310", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M98 <SLOT>
        N30 M30
        O2
        N40 M99
    """,
    alarm="named-program-not-found", number="PS0310", at="O1 N20",
)
case(
    "a name that is not closed is a format error",
    control=LATE, source="ALM PS0311", evidence="secondary",
    program="""
        O1
        N10 M98 <DRILL
        N20 M30
        <DRILL>
        N30 M99
    """,
    runs="", alarm="illegal-program-name", number="PS0311", at="O1 N10",
)
case(
    "an empty name is a format error",
    control=LATE, source="ALM PS0311", evidence="secondary",
    program="""
        O1
        N10 M98 <>
        N20 M30
    """,
    runs="", alarm="illegal-program-name", number="PS0311", at="O1 N10",
)
case(
    "a name with an asterisk is a format error",
    control=LATE, source="ALM PS0311; K-H list of characters", evidence="secondary",
    program="""
        O1
        N10 M98 <A*B>
        N20 M30
    """,
    runs="", alarm="illegal-program-name", number="PS0311", at="O1 N10",
)
case(
    "a name of 33 characters is a format error",
    pins="max_name_length",
    control=LATE, source="ALM PS0311; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 <A23456789012345678901234567890123>
        N20 M30
    """,
    runs="", alarm="illegal-program-name", number="PS0311", at="O1 N10",
)
case(
    "a name of 32 characters is looked up",
    control=LATE, source="ALM PS0310; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 <A2345678901234567890123456789012>
        N20 M30
    """,
    alarm="named-program-not-found", number="PS0310", at="O1 N10",
)
