"""FANUC: M98 with Q, which calls a part of the same program (6005#0)."""

from conformance import case

LATE = ["fanuc-0i-f", "fanuc-30i"]

case(
    "M98 P Q starts the subprogram at the block of Q",
    control=LATE, source="GED, WEI; K-M parameter", evidence="secondary",
    program="""
        O1
        N10 M98 P2 Q40
        N20 M30
        O2
        N30 M3
        N40 M4
        N50 M99
    """,
    params={"6005#0": 1}, runs="N10 N40 N50 N20", m=[4],
)
case(
    "every repeat starts at the block of Q",
    control=LATE, source="GED, WEI; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2 Q40 L2
        N20 M30
        O2
        N30 M3
        N40 M4
        N50 M99
    """,
    params={"6005#0": 1}, runs="N10 (N40 N50)*2 N20",
)
case(
    "Q may be a variable",
    control=LATE, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=40
        N15 M98 P2 Q#100
        N20 M30
        O2
        N30 M3
        N40 M99
    """,
    params={"6005#0": 1}, runs="N10 N15 N40 N20",
)
case(
    "M98 Q in a subprogram starts in that subprogram",
    control=LATE, source="GED; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        N60 M99
        O2
        N40 M98 Q60
        N50 M99
        N60 M99
    """,
    params={"6005#0": 1}, runs="O1:N10 O2:N40 O2:N60 O2:N50 O1:N20", calls="M98:O2 M98:O2",
)
case(
    "a local subprogram may return by M99 P to a block of its own program",
    control=LATE, source="GED, S003; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 Q100
        N20 M3
        N30 M30
        N100 M99 P30
    """,
    params={"6005#0": 1}, runs="N10 N100 N30", m=[],
)
case(
    "a local subprogram shares the local variables",
    control=LATE, source="PB304; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #1=4
        N20 M98 Q100
        N30 M30
        N100 #100=#1
        N110 M99
    """,
    params={"6005#0": 1}, runs="N10 N20 N100 N110 N30", vars={100: 4},
)
case(
    "a Q that the subprogram does not have alarms",
    control=LATE, source="ALM PS0078; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2 Q70
        N20 M30
        N70 M3
        O2
        N30 M99
    """,
    params={"6005#0": 1}, alarm="start-not-found", number="PS0078", at="O1 N10",
)
case(
    "a Q that the present program does not have alarms",
    control=LATE, source="ALM PS0078; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 Q70
        N20 M30
        O2
        N70 M99
    """,
    params={"6005#0": 1}, alarm="start-not-found", number="PS0078", at="O1 N10",
)
case(
    "M98 P Q of a missing program is a missing program",
    control=LATE, source="ALM PS0076", evidence="secondary",
    program="""
        O1
        N10 M98 P2 Q10
        N20 M30
    """,
    params={"6005#0": 1}, alarm="program-not-found", number="PS0076", at="O1 N10",
)
case(
    "Q without a number has no data",
    control=LATE, source="ALM PS0005", evidence="secondary",
    program="""
        O1
        N10 M98 P2 Q
        N20 M30
        O2
        N30 M99
    """,
    params={"6005#0": 1}, runs="", alarm="address-without-value", number="PS0005", at="O1 N10",
)
case(
    "without 6005#0 an M98 with Q alone names no program",
    control=LATE, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 Q100
        N20 M30
        N100 M99
    """,
    runs="", alarm="program-number-missing", number="PS0076", at="O1 N10",
)
case(
    "the 16i has no M98 Q: the program is missing",
    control="fanuc-16i", source="GED marks it as a later function; K-M general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 M98 Q100
        N20 M30
        N100 M99
    """,
    runs="", alarm="program-number-missing", number="076", at="O1 N10",
)
case(
    "a local subprogram that calls itself runs out of levels",
    control=LATE, source="ALM PS0077; K-H depth", evidence="inferred",
    program="""
        O1
        N10 M98 Q100
        N20 M30
        N100 #100=#100+1
        N110 M98 Q100
        N120 M99
    """,
    params={"6005#0": 1}, alarm="nesting-too-deep", number="PS0077", at="O1 N110", vars={100: 10},
)
case(
    "a Q that only the main program has is not found from a subprogram",
    control=LATE, source="ALM PS0078; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        N70 M99
        O2
        N30 M98 Q70
        N40 M99
    """,
    params={"6005#0": 1}, alarm="start-not-found", number="PS0078", at="O2 N30",
)
case(
    "a local subprogram without M99 runs into the end of its program",
    control=LATE, source="ALM PS5010; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 Q100
        N20 M30
        N100 T5
    """,
    params={"6005#0": 1}, runs="N10 N100", alarm="end-of-record", number="PS5010", at="O1", t=[5],
)
case(
    "M99 P of a local subprogram to a missing block alarms",
    control=LATE, source="ALM PS0078; source 003", evidence="secondary",
    program="""
        O1
        N10 M98 Q100
        N20 M30
        N100 M99 P77
    """,
    params={"6005#0": 1}, alarm="return-target-not-found", number="PS0078", at="O1 N100",
)

case(
    "M98 Q100 L2 runs the part from N100 of its own program twice (F129)",
    control=["fanuc-30i", "fanuc-0i-f"],
    source="GED; WEI; 6005#0 SQC: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        N10 M98 Q100 L2
        N20 M30
        N100 #100=#100+1
        N110 M99
    """,
    params={"6005#0": 1},
    runs="N10 N100 N110 N100 N110 N20",
    vars={100: 2},
)

case(
    "M98 P2 Q20 starts O2 at N20 (F130)",
    control=["fanuc-30i", "fanuc-0i-f"],
    source="GED; WEI; 6005#0 SQC: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        M98 P2 Q20
        N90 M30
        O2
        N10 #100=1
        N20 #101=2
        N30 M99
    """,
    params={"6005#0": 1},
    runs="N20 N30 N90",
    vars={100: None, 101: 2},
)
