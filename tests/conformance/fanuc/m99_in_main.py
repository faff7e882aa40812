"""FANUC: M99 in the main program."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


case(
    "M99 in the main program starts it over",
    control=ALL, source="GED, source 003, WEI", evidence="source document",
    program="""
        O1
        N10 T1
        N20 M99
    """,
    max_cycles=3, runs="(N10 N20)*3", stop="cycles", t=[1, 1, 1],
)
case(
    "one pass of an endless main program is one cycle",
    control=ALL, source="GED; policy: max_cycles", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 M99
        N30 T2
    """,
    runs="N10 N20", stop="cycles", t=[1],
)
case(
    "words in the M99 block of a main program run before it starts over",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 T2 M99
    """,
    max_cycles=2, runs="(N10 N20)*2", stop="cycles", t=[1, 2, 1, 2],
)
case(
    "calls work in every pass of an endless main program",
    control=ALL, source="GED", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M99
        O2
        N30 M99
    """,
    max_cycles=2, runs="(N10 N30 N20)*2", stop="cycles",
)
case(
    "local variables keep their values when M99 starts the main program over",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #1=#1+1
        N20 M99
    """,
    max_cycles=4, runs="(N10 N20)*4", stop="cycles", vars={1: 4},
)
case(
    "M99 P in the main program jumps and never ends",
    control=ALL, source="source 003; GED, WEI", evidence="source document",
    program="""
        O1
        N10 T1
        N20 #100=#100+1
        N30 M99 P20
    """,
    max_cycles=100, max_blocks=5, runs="N10 (N20 N30)*2", stop="limit", vars={100: 2},
)
case(
    "M99 P in the main program may jump forward",
    control=ALL, source="source 003; GED", evidence="source document",
    program="""
        O1
        N10 T1
        N20 M99 P40
        N30 T3
        N40 M30
    """,
    max_cycles=100, runs="N10 N20 N40", t=[1],
)
case(
    "M99 P in the main program to a missing block alarms",
    control=ALL, source="ALM PS0078; K-H 078", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 M99 P70
        N30 M30
    """,
    max_cycles=100, alarm="return-target-not-found", number=numbers("078", "PS0078"), at="O1 N20",
    t=[1],
)
case(
    "/M99 loops the main program while the switch is off",
    control=ALL, source="K-H general knowledge; GED", evidence="inferred",
    program="""
        O1
        N10 T1
        /N20 M99
        N30 M30
    """,
    max_cycles=2, runs="(N10 N20)*2", stop="cycles",
)
case(
    "/2 M99 loops the main program although switch 1 is on",
    control=ALL, source="K-H general knowledge; ISO", evidence="inferred",
    program="""
        O1
        N10 T1
        /2 N20 M99
        N30 M30
    """,
    skip=(1,), runs="N10 N20", stop="cycles",
)
case(
    "/M99 P in the main program jumps while the switch is off",
    control=ALL, source="GED; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        /N20 M99 P40
        N30 T3
        N40 M30
    """,
    max_cycles=100, runs="N10 N20 N40", t=[1],
)
case(
    "/M99 P in the main program is passed while the switch is on",
    control=ALL, source="GED; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        /N20 M99 P10
        N30 T3
        N40 M30
    """,
    skip=(1,), runs="N10 N30 N40", t=[1, 3],
)
case(
    "/M30 and M99 end the main program while the switch is off and loop it while it is on",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 T1
        /N20 M30
        N30 M99
    """,
    skip=(1,), max_cycles=2, runs="(N10 N30)*2", stop="cycles",
)
case(
    "a subprogram started as the main program loops at its M99",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 T3
        N40 M99
    """,
    main="O2", max_cycles=2, runs="(N30 N40)*2", stop="cycles",
)
case(
    "a subprogram started as the main program jumps inside itself by M99 P",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N50 T1
        N20 M30
        O2
        N30 T3
        N40 M99 P50
        N45 T4
        N50 M30
    """,
    main="O2", max_cycles=100, runs="N30 N40 N50", t=[3],
)
case(
    "with 7712#4=1 M99 in the main program alarms",
    control="fanuc-30i", source="ALM PS1018", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 M99
    """,
    params={"7712#4": 1}, alarm="return-in-main-program", number="PS1018", at="O1 N20", t=[1],
)
case(
    "with 7712#4=1 M99 P in the main program alarms",
    control="fanuc-30i", source="ALM PS1018", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 M99 P10
    """,
    params={"7712#4": 1}, alarm="return-in-main-program", number="PS1018", at="O1 N20", t=[1],
)
case(
    "with 7712#4=1 M99 in a subprogram returns as before",
    control="fanuc-30i", source="ALM PS1018", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    params={"7712#4": 1}, runs="N10 N30 N20",
)
case(
    "with 7712#4=1 a skipped M99 in the main program alarms nothing",
    control="fanuc-30i", source="ALM PS1018; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 T1
        /N20 M99
        N30 M30
    """,
    params={"7712#4": 1}, skip=(1,), runs="N10 N30",
)

case(
    "M99 in a main program starts it over (F120)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 003, M99; GED; WEI",
    evidence="source document",
    program="""
        O1
        N10 #100=#100+1
        N20 M99
    """,
    max_cycles=100,
    max_blocks=6,
    runs="N10 N20 N10 N20 N10 N20",
    vars={100: 3},
    stop="limit",
)

case(
    "a /M99 that is skipped lets the main program come to its M30 (F121)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 003, M99; GED shows /M99 P",
    evidence="secondary",
    program="""
        O1
        N10 #100=#100+1
        /M99
        N30 M30
    """,
    skip=(1,),
    runs="N10 N30",
    vars={100: 1},
)

case(
    "M99 P20 in a main program jumps to N20 (F122)",
    control=["fanuc-16i", "fanuc-30i"],
    source="source 003, M99; GED; WEI",
    evidence="source document",
    program="""
        O1
        N10 #100=#100+1
        N20 #101=#101+1
        N30 IF[#101 GE 3] GOTO 50
        N40 M99 P20
        N50 M30
    """,
    runs="N10 N20 N30 N40 N20 N30 N40 N20 N30 N50",
    vars={100: 1, 101: 3},
)
