"""FANUC: ends of programs, M02, M30, the percent sign, and programs without an end."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


case(
    "M02 ends the run",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 M02
        N30 T2
    """,
    runs="N10 N20", t=[1],
)
case(
    "a faulty block after M30 alarms nothing",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        N25 M98 P
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "M30 after a skipped slash does not end the program",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        /N10 M30
        N20 T2
        N30 M30
    """,
    skip=(1,), runs="N20 N30", t=[2],
)
case(
    "M30 after a slash ends the program while the switch is off",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N5 T1
        /N10 M30
        N20 T2
        N30 M30
    """,
    runs="N5 N10", t=[1],
)
case(
    "a main program that runs into its end alarms",
    pins="missing_end",
    control=ALL, source="ALM PS5010", evidence="secondary",
    program="""
        %
        O1
        N10 T1
        N20 T2
        %
    """,
    runs="N10 N20", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O1", t=[1, 2],
)
case(
    "the end of a main program is not the head of the next one",
    control=ALL, source="ALM PS5010", evidence="secondary",
    program="""
        O1
        N10 T1
        O2
        N20 T2
        N30 M30
    """,
    runs="N10", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O1", t=[1],
)
case(
    "a subprogram that runs into its end alarms",
    control=ALL, source="ALM PS5010; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 T3
    """,
    runs="N10 N30", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O2",
)
case(
    "a macro that runs into its end alarms",
    control=ALL, source="ALM PS5010; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P2 A1.
        N20 M30
        O2
        N30 #100=#1
    """,
    runs="N10 N30", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O2", vars={100: 1},
)
case(
    "a subprogram without a block alarms",
    control=ALL, source="ALM PS5010; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        O3
        N30 M99
    """,
    runs="N10", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O2",
)
case(
    "with 3404#6=1 a subprogram that runs into its end resets the control and does not return",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 T3
    """,
    params={"3404#6": 1}, runs="N10 N30", stop="end", t=[3],
)
case(
    "with 3404#6=1 M30 and M99 work as before",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    params={"3404#6": 1}, runs="N10 N30 N20",
)
case(
    "a main program whose only M30 is skipped runs into its end",
    control=ALL, source="ALM PS5010; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 T1
        /N20 M30
    """,
    skip=(1,), runs="N10", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O1",
)
case(
    "M00 in a subprogram leaves the open call open",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M00
        N40 M99
    """,
    runs="N10 N30 N40 N20",
)
case(
    "M01 in a subprogram leaves the open call open",
    control=ALL, source="GED; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M01
        N40 M99
    """,
    optional_stop=True, runs="N10 N30 N40 N20",
)
case(
    "a subprogram of a subprogram without M99 runs into its end",
    control=ALL, source="ALM PS5010; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M98 P3
        N40 M99
        O3
        N50 T5
    """,
    runs="N10 N30 N50", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O3", t=[5],
)
case(
    "a GOTO past the M30 runs into the end of the program",
    control=ALL, source="ALM PS5010; X-GO", evidence="secondary",
    program="""
        O1
        N10 GOTO30
        N20 M30
        N30 T3
    """,
    runs="N10 N30", alarm="end-of-record", number=numbers("5010", "PS5010"), at="O1", t=[3],
)

case(
    "nothing after M30 runs (F002)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        N10 #100=1
        N20 M30
        N30 #100=2
    """,
    runs="N10 N20",
    vars={100: 1},
)

case(
    "the percent sign reached without M30 ends the run while 3404#6 is 1 (F020)",
    control=["fanuc-16i", "fanuc-30i"],
    source="3404#6 EOR: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        N10 #100=1
        %
    """,
    params={"3404#6": 1},
    runs="N10",
    vars={100: 1},
)

case(
    "M30 in a subprogram ends the whole run (F124)",
    pins="end_in_subprogram",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M30
        N40 M99
    """,
    runs="N10 N30",
)
