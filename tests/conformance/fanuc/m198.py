"""FANUC: M198, programs of the external device."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
NEW = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


case(
    "M198 calls a program of the external device",
    pins="roles:M198=external-call",
    control=ALL, source="CL198", evidence="secondary",
    program="""
        O1
        N10 M198 P2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="N10 N30 N20", calls="M198:O2",
)
case(
    "L repeats an external call",
    control=ALL, source="CL198", evidence="secondary",
    program="""
        O1
        N10 M198 P2 L3
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="N10 N30*3 N20", calls="M198:O2",
)
case(
    "M198 reads the device although memory has a program of that number",
    control=ALL, source="CL198", evidence="secondary",
    program="""
        O1
        N10 M198 P2
        N20 M30
        O2
        N40 M99
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="N10 N30 N20",
)
case(
    "M98 reads memory although the device has a program of that number",
    control=ALL, source="CL198", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N40 M99
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="N10 N40 N20", calls="M98:O2",
)
case(
    "M98 does not find a program of the device",
    control=ALL, source="ALM PS0076; K-H 078", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, alarm="program-not-found", number=numbers("078", "PS0076"),
    at="O1 N10",
)
case(
    "M198 does not find a program of memory",
    control=NEW, source="ALM PS1079", evidence="secondary",
    program="""
        O1
        N10 M198 P2
        N20 M30
        O2
        N40 M99
    """,
    external={"O3.NC": "O3\nM99\n"}, alarm="external-program-not-found", number="PS1079",
    at="O1 N10",
)
case(
    "a file that the device lacks alarms",
    control=NEW, source="ALM PS1079", evidence="secondary",
    program="""
        O1
        N10 T5 M198 P7
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="N10", alarm="external-program-not-found",
    number="PS1079", at="O1 N10", t=[5],
)
case(
    "an external program calls no external program, not even another one",
    control=NEW, source="ALM PS1080", evidence="secondary",
    program="""
        O1
        N10 M198 P2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M198 P3\nN40 M99\n", "O3.NC": "O3\nN50 M99\n"},
    alarm="external-call-nested", number="PS1080", at="O2 N30", calls="M198:O2",
)
case(
    "a memory program called from an external one calls no external program",
    control=NEW, source="ALM PS1080, PS0077; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M198 P2
        N20 M30
        O4
        N60 M198 P3
        N70 M99
    """,
    external={"O2.NC": "O2\nN30 M98 P4\nN40 M99\n", "O3.NC": "O3\nN50 M99\n"},
    alarm="external-call-nested", number="PS1080", at="O4 N60",
)
case(
    "a second external call after the first has returned is legal",
    control=ALL, source="ALM PS1080; CL198", evidence="secondary",
    program="""
        O1
        N10 M198 P2
        N20 M198 P2
        N40 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="N10 N30 N20 N30 N40",
)
case(
    "an external program calls a program of memory",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M198 P2
        N20 M30
        O3
        N50 M99
    """,
    external={"O2.NC": "O2\nN30 M98 P3\nN40 M99\n"}, runs="N10 N30 N50 N40 N20",
    calls="M198:O2 M98:O3",
)
case(
    "an external program calls a macro of memory",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M198 P2
        N20 M30
        O3
        N50 #100=#1
        N60 M99
    """,
    external={"O2.NC": "O2\nN30 G65 P3 A2.\nN40 M99\n"}, runs="N10 N30 N50 N60 N40 N20",
    vars={100: 2},
)
case(
    "words in the M198 block run before the call",
    control=ALL, source="CL198, PMI39; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 T5 M198 P2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 T6\nN40 M99\n"}, runs="N10 N30 N40 N20", t=[5, 6],
)
case(
    "an external program shares the local variables",
    control=ALL, source="PB304; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 #1=3
        N15 M198 P2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 #1=#1+1\nN40 M99\n"}, runs="N10 N15 N30 N40 N20", vars={1: 4},
)
case(
    "M99 P of an external program returns to a block of the caller",
    control=ALL, source="source 003; CL198", evidence="inferred",
    program="""
        O1
        N10 M198 P2
        N20 T1
        N25 M30
    """,
    external={"O2.NC": "O2\nN30 M99 P25\n"}, runs="N10 N30 N25", t=[],
)
case(
    "M99 P of an external program to a missing block alarms",
    control=ALL, source="ALM PS0078; K-H 078", evidence="secondary",
    program="""
        O1
        N10 M198 P2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99 P77\n"}, alarm="return-target-not-found",
    number=numbers("078", "PS0078"), at="O2 N30",
)
case(
    "M30 in an external program ends the run",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M198 P2
        N20 T1
        N25 M30
    """,
    external={"O2.NC": "O2\nN30 M30\n"}, runs="N10 N30", t=[],
)
case(
    "an external program without M99 runs into its end",
    control=ALL, source="ALM PS5010; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M198 P2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 T3\n"}, runs="N10 N30", alarm="end-of-record",
    number=numbers("5010", "PS5010"), at="O2",
)
case(
    "M198 without P names no program",
    control=ALL, source="K-H 076; ALM PS0076", evidence="inferred",
    program="""
        O1
        N10 M198
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="", alarm="program-number-missing",
    number=numbers("076", "PS0076"), at="O1 N10",
)
case(
    "a minus sign at the P of M198 is illegal",
    control=ALL, source="ALM PS0006", evidence="secondary",
    program="""
        O1
        N10 M198 P-2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="", alarm="illegal-minus-sign",
    number=numbers("006", "PS0006"), at="O1 N10",
)
case(
    "a point at the P of M198 is illegal",
    control=ALL, source="ALM PS0007", evidence="secondary",
    program="""
        O1
        N10 M198 P2.
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="", alarm="illegal-decimal-point",
    number=numbers("007", "PS0007"), at="O1 N10",
)
case(
    "M198 is not sent to the machine",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M3
        N15 M198 P2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="N10 N15 N30 N20", m=[3],
)
case(
    "parameter 6030 gives the external call another M code",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M150 P2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, params={"6030": 150}, runs="N10 N30 N20", calls="M198:O2",
    m=[],
)
case(
    "an external call counts as a level of M98 on the 16i",
    control="fanuc-16i", source="MC52, GED; K-H 077", evidence="inferred",
    program="""
        O1
        N10 M198 P2
        N20 M30
        O3
        N40 #100=#100+1
        N50 M98 P3
        N60 M99
    """,
    external={"O2.NC": "O2\nN30 M98 P3\nN35 M99\n"}, alarm="nesting-too-deep", number="077",
    at="O3 N50", vars={100: 3},
)
case(
    "an external call counts as a level of M98",
    control=NEW, source="ALM PS0077; K-H depth", evidence="inferred",
    program="""
        O1
        N10 M198 P2
        N20 M30
        O3
        N40 #100=#100+1
        N50 M98 P3
        N60 M99
    """,
    external={"O2.NC": "O2\nN30 M98 P3\nN35 M99\n"}, alarm="nesting-too-deep", number="PS0077",
    at="O3 N50", vars={100: 9},
)
case(
    "a minus sign at the L of M198 is illegal",
    control=ALL, source="ALM PS0006", evidence="secondary",
    program="""
        O1
        N10 M198 P2 L-3
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="", alarm="illegal-minus-sign",
    number=numbers("006", "PS0006"), at="O1 N10",
)
case(
    "the P of M198 without a number has no data",
    control=ALL, source="ALM PS0005", evidence="secondary",
    program="""
        O1
        N10 M198 P
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="", alarm="address-without-value",
    number=numbers("005", "PS0005"), at="O1 N10",
)
case(
    "with 3403#6=1 two P in an M198 block alarm",
    control=ALL, source="ALM PS5074; K-H parameter", evidence="inferred",
    program="""
        O1
        N10 M198 P2 P3
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, params={"3403#6": 1}, runs="", alarm="address-given-twice",
    number=numbers("5074", "PS5074"), at="O1 N10",
)
case(
    "a program of memory that an external program misses alarms in the external program",
    control=ALL, source="ALM PS0076; K-H 078", evidence="secondary",
    program="""
        O1
        N10 M198 P2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M98 P3\nN40 M99\n", "O3.NC": "O3\nN50 M99\n"},
    alarm="program-not-found", number=numbers("078", "PS0076"), at="O2 N30",
)
case(
    "a faulty block of an external program alarms in the external program",
    control=ALL, source="ALM PS0005", evidence="secondary",
    program="""
        O1
        N10 M198 P2
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 T3\nN40 X\nN50 M99\n"}, runs="N10 N30",
    alarm="address-without-value", number=numbers("005", "PS0005"), at="O2 N40",
)

case(
    "an external subprogram that calls another external one alarms (F133)",
    control="fanuc-30i",
    source="ALM PS1080; CW-S",
    evidence="secondary",
    program="""
        O1
        M198 P2
        M30
    """,
    external={
        "O2.CNC": """
            O2
            M198 P3
            M99
        """,
        "O3.CNC": """
            O3
            M99
        """,
    },
    alarm="external-call-nested",
    number="PS1080",
    at="O2",
)

case(
    "an external subprogram may call one of the memory (F134)",
    control="fanuc-30i",
    source="general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        M198 P2
        N9 M30
        O3
        #100=1
        M99
    """,
    external={
        "O2.CNC": """
            O2
            M98 P3
            M99
        """,
    },
    runs="N9",
    vars={100: 1},
)
