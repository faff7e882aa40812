"""FANUC: how deep subprograms may call."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
NEW = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


case(
    "a program may call itself while levels are left",
    pins="self_call max_nesting",
    control=ALL, source="MC52, GED; K-H depth", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 #100=#100+1
        N40 IF[#100 GE 4]GOTO60
        N50 M98 P2
        N60 M99
    """,
    runs="N10 (N30 N40 N50)*3 N30 N40 N60*4 N20", vars={100: 4},
)
case(
    "the fifth level of M98 alarms on the 16i at the call",
    control="fanuc-16i", source="MC52, GED; K-H 077", evidence="maker's manual",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 #100=#100+1
        N40 M98 P2
        N50 M99
    """,
    alarm="nesting-too-deep", number="077", at="O2 N40", vars={100: 4},
)
case(
    "the eleventh level of M98 alarms at the call",
    pins="max_nesting",
    control=NEW, source="ALM PS0077; K-H depth", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 #100=#100+1
        N40 M98 P2
        N50 M99
    """,
    alarm="nesting-too-deep", number="PS0077", at="O2 N40", vars={100: 10},
)
case(
    "ten levels of M98 are legal",
    control=NEW, source="K-H depth", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        #100=#100+1
        IF[#100 GE 10]GOTO60
        M98 P2
        N60 M99
    """,
    runs="N10 N60*10 N20", vars={100: 10},
)
case(
    "a main program that calls itself runs out of levels on the 16i",
    control="fanuc-16i", source="MC52, GED; K-H 077", evidence="maker's manual",
    program="""
        O1
        N10 #100=#100+1
        N20 M98 P1
        N30 M30
    """,
    alarm="nesting-too-deep", number="077", at="O1 N20", vars={100: 5},
)
case(
    "a main program that calls itself runs out of levels",
    control=NEW, source="ALM PS0077; K-H depth", evidence="inferred",
    program="""
        O1
        N10 #100=#100+1
        N20 M98 P1
        N30 M30
    """,
    alarm="nesting-too-deep", number="PS0077", at="O1 N20", vars={100: 11},
)
case(
    "two programs that call each other run out of levels",
    control=ALL, source="ALM PS0077, MC52", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M98 P3
        N40 M99
        O3
        N50 M98 P2
        N60 M99
    """,
    alarm="nesting-too-deep", number=numbers("077", "PS0077"), at="O3 N50",
)
case(
    "a repeat is no new level",
    control=ALL, source="MC52; K-H depth", evidence="inferred",
    program="""
        O1
        N10 M98 P2 L20
        N20 M30
        O2
        N30 M98 P3
        N40 M99
        O3
        N50 M99
    """,
    runs="N10 (N30 N50 N40)*20 N20",
)
case(
    "a level is free again after its return",
    control=ALL, source="MC52; K-H depth", evidence="inferred",
    program="""
        O1
        N10 #100=#100+1
        N20 M98 P2
        N30 IF[#100 LT 12]GOTO10
        N40 M30
        O2
        N50 M99
    """,
    runs="(N10 N20 N50 N30)*12 N40",
)
case(
    "four M98 levels and four macro levels fit together on the 16i, a fifth M98 level does not",
    pins="nesting_counts_macros",
    control="fanuc-16i", source="PB304, RW; K-H 077", evidence="inferred",
    program="""
        O1
        N10 G65 P2
        N20 M30
        O2
        N30 G65 P3
        N40 M99
        O3
        N50 #100=#100+1
        N60 M98 P3
        N70 M99
    """,
    alarm="nesting-too-deep", number="077", at="O3 N60", vars={100: 5},
)
case(
    "macro calls do not use up M98 levels",
    pins="nesting_counts_macros",
    control=NEW, source="PB304; K-H depth", evidence="inferred",
    program="""
        O1
        N10 G65 P2
        N20 M30
        O2
        N30 G65 P3
        N40 M99
        O3
        N50 #100=#100+1
        N60 M98 P3
        N70 M99
    """,
    alarm="nesting-too-deep", number="PS0077", at="O3 N60", vars={100: 11},
)
case(
    "M98 inside a WHILE loop uses one level",
    control=ALL, source="policy; MC52", evidence="inferred",
    program="""
        O1
        N10 WHILE[#1 LT 12]DO1
        N20 M98 P2
        N30 END1
        N40 M30
        O2
        N50 #1=#1+1
        N60 M99
    """,
    runs="(N10 N20 N50 N60 N30)*12 N10 N40", vars={1: 12},
)

case(
    "four levels of M98 are legal (F112)",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-30i"],
    source="MC52; GED; CW-S",
    evidence="maker's manual",
    program="""
        O1
        M98 P2
        N9 M30
        O2
        M98 P3
        M99
        O3
        M98 P4
        M99
        O4
        M98 P5
        M99
        O5
        #100=4
        M99
    """,
    runs="N9",
    vars={100: 4},
)

case(
    "the fifth level of M98 alarms on the 16i (F113)",
    control="fanuc-16i",
    source="MC52; GED; 077: general knowledge of the FANUC manuals",
    evidence="maker's manual",
    program="""
        O1
        M98 P2
        N9 M30
        O2
        M98 P3
        M99
        O3
        M98 P4
        M99
        O4
        M98 P5
        M99
        O5
        M98 P6
        M99
        O6
        #100=5
        M99
    """,
    vars={100: None},
    alarm="nesting-too-deep",
    number="077",
    at="O5",
)

case(
    "the fifth level of M98 is legal on the 0i-D and the 30i (F113)",
    control=["fanuc-0i-d", "fanuc-30i"],
    source="ten levels: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        M98 P2
        N9 M30
        O2
        M98 P3
        M99
        O3
        M98 P4
        M99
        O4
        M98 P5
        M99
        O5
        M98 P6
        M99
        O6
        #100=5
        M99
    """,
    vars={100: 5},
)

case(
    "a subprogram that calls itself runs four times on the 16i (F114)",
    control="fanuc-16i",
    source="MC52; 077: general knowledge of the FANUC manuals",
    evidence="maker's manual",
    program="""
        O1
        M98 P2
        M30
        O2
        #100=#100+1
        M98 P2
        M99
    """,
    vars={100: 4},
    alarm="nesting-too-deep",
    number="077",
    at="O2",
)

case(
    "a subprogram that calls itself runs ten times on the 0i-D and the 30i (F114)",
    control=["fanuc-0i-d", "fanuc-30i"],
    source="ALM PS0077; ten levels: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        M98 P2
        M30
        O2
        #100=#100+1
        M98 P2
        M99
    """,
    vars={100: 10},
    alarm="nesting-too-deep",
    number="PS0077",
    at="O2",
)
