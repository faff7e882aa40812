"""FANUC: calls and jumps from MDI."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
NEW = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


case(
    "M98 in MDI calls a stored program",
    control=ALL, source="K-M general knowledge (source 003 refuses it on older controls)",
    evidence="inferred",
    program="""
        O2
        N30 T3
        N40 M99
    """,
    mdi="M98 P2", runs="N30 N40", t=[3],
)
case(
    "M98 in MDI may repeat",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O2
        N30 M99
    """,
    mdi="N10 M98 P30002", runs="N10 N30*3",
)
case(
    "blocks after an M98 in MDI run after the return",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O2
        N30 T3
        N40 M99
    """,
    mdi="N10 M98 P2\nN20 T4", runs="N10 N30 N40 N20", t=[3, 4],
)
case(
    "a program called from MDI may call on",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O2
        N30 M98 P3
        N40 M99
        O3
        N50 M99
    """,
    mdi="N10 M98 P2", runs="N10 N30 N50 N40", calls="M98:O2 M98:O3",
)
case(
    "a missing program alarms in MDI as in memory mode",
    control=ALL, source="ALM PS0076; K-H 078", evidence="inferred",
    program="""
        O2
        N30 M99
    """,
    mdi="M98 P5", alarm="program-not-found", number=numbers("078", "PS0076"),
)
case(
    "G65 in MDI calls a macro with arguments",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O2
        N30 #100=#1
        N40 M99
    """,
    mdi="N10 G65 P2 A4.", runs="N10 N30 N40", vars={100: 4},
)
case(
    "an assignment in MDI is legal",
    control=ALL, source="ALM PS0123; K-H general knowledge", evidence="inferred",
    program="""
        O2
        N30 M99
    """,
    mdi="N10 #100=5", runs="N10", vars={100: 5},
)
case(
    "M99 at the end of an MDI program starts it over",
    pins="main_return",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O2
        N30 M99
    """,
    mdi="N10 #100=#100+1\nN20 M99", max_cycles=3, runs="(N10 N20)*3", stop="cycles", vars={100: 3},
)
case(
    "GOTO in an MDI program is refused",
    control=ALL, source="ALM PS0123; K-H 123", evidence="secondary",
    program="""
        O2
        N30 M99
    """,
    mdi="N10 GOTO20\nN20 M98 P2", runs="", alarm="jump-in-mdi", number=numbers("123", "PS0123"),
)
case(
    "IF GOTO in an MDI program is refused",
    control=ALL, source="ALM PS0123; K-H 123", evidence="secondary",
    program="""
        O2
        N30 M99
    """,
    mdi="N10 T1\nN15 IF[1 EQ 1]GOTO20\nN20 M98 P2", runs="N10", alarm="jump-in-mdi",
    number=numbers("123", "PS0123"), t=[1],
)
case(
    "WHILE in an MDI program is refused",
    control=ALL, source="ALM PS0123; K-H 123", evidence="secondary",
    program="""
        O2
        N30 M99
    """,
    mdi="N10 WHILE[#1 LT 2]DO1\nN20 #1=#1+1\nN30 END1", runs="", alarm="jump-in-mdi",
    number=numbers("123", "PS0123"),
)
case(
    "DO without WHILE in an MDI program is refused",
    control=ALL, source="ALM PS0123; K-H 123", evidence="secondary",
    program="""
        O2
        N30 M99
    """,
    mdi="N10 DO1\nN20 END1", runs="", alarm="jump-in-mdi", number=numbers("123", "PS0123"),
)
case(
    "a program called from MDI may loop",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O2
        N30 WHILE[#1 LT 2]DO1
        N40 #1=#1+1
        N50 END1
        N60 M99
    """,
    mdi="N10 M98 P2", runs="N10 (N30 N40 N50)*2 N30 N60",
)
case(
    "a subprogram called from MDI without M99 runs into its end",
    control=ALL, source="ALM PS5010; K-M general knowledge", evidence="inferred",
    program="""
        O2
        N30 T3
    """,
    mdi="N10 M98 P2", runs="N10 N30", alarm="end-of-record", number=numbers("5010", "PS5010"),
    at="O2",
)
case(
    "a minus sign at the P of M98 is illegal in MDI",
    control=ALL, source="ALM PS0006", evidence="secondary",
    program="""
        O2
        N30 M99
    """,
    mdi="N10 M98 P-2", runs="", alarm="illegal-minus-sign", number=numbers("006", "PS0006"),
)
case(
    "M98 without P names no program in MDI",
    control=ALL, source="K-H 076; ALM PS0076", evidence="secondary",
    program="""
        O2
        N30 M99
    """,
    mdi="N10 T1\nN20 M98", runs="N10", alarm="program-number-missing",
    number=numbers("076", "PS0076"), t=[1],
)
case(
    "calls from MDI run out of levels as calls from memory do",
    control=NEW, source="ALM PS0077; K-H depth", evidence="inferred",
    program="""
        O2
        N30 #100=#100+1
        N40 M98 P2
        N50 M99
    """,
    mdi="M98 P2", alarm="nesting-too-deep", number="PS0077", at="O2 N40", vars={100: 10},
)

case(
    "a GOTO in MDI alarms (F135)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0123; 16i: general knowledge of the FANUC manuals",
    evidence="secondary",
    mdi="""
        GOTO 10
        N10 M30
    """,
    alarm="jump-in-mdi",
    number={"fanuc-16i": "123", "fanuc-30i": "PS0123"},
)

case(
    "a program called from MDI may use GOTO (F136)",
    control=["fanuc-16i", "fanuc-30i"],
    source="calls from MDI: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O2
        GOTO 10
        #100=1
        N10 M99
    """,
    mdi="""
        M98 P2
        N9 M30
    """,
    runs="N10 N9",
    vars={100: None},
)
