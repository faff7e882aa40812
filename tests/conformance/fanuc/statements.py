"""FANUC: macro statements beside NC words."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


case(
    "an axis word and an assignment in one block alarm",
    control=ALL, source="ALM PS0127; K-H 127", evidence="secondary",
    program="""
        O1
        N10 X5. #1=3
        N20 M30
    """,
    runs="", alarm="nc-and-macro-in-block", number=numbers("127", "PS0127"), at="O1 N10",
    vars={1: None},
)
case(
    "a G code and an assignment in one block alarm",
    control=ALL, source="ALM PS0127; K-H 127", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 G0 #1=3
        N30 M30
    """,
    runs="N10", alarm="nc-and-macro-in-block", number=numbers("127", "PS0127"), at="O1 N20",
)
case(
    "an M code before GOTO alarms",
    pins="bare_g",
    control=[*ALL, "haas-ngc"], source="ALM PS0127; K-H 127", evidence="secondary",
    program="""
        O1
        N10 M3 GOTO30
        N20 M4
        N30 M30
    """,
    runs="", alarm="nc-and-macro-in-block", number={**numbers("127", "PS0127"), "haas-ngc": None}, at="O1 N10", m=[],
)
case(
    "an axis word before IF alarms",
    control=ALL, source="ALM PS0127; K-H 127", evidence="secondary",
    program="""
        O1
        N10 X1. IF[1 EQ 1]GOTO30
        N20 M4
        N30 M30
    """,
    runs="", alarm="nc-and-macro-in-block", number=numbers("127", "PS0127"), at="O1 N10",
)
case(
    "an axis word before WHILE alarms",
    control=ALL, source="ALM PS0127; K-H 127", evidence="secondary",
    program="""
        O1
        N10 X1. WHILE[#1 LT 1]DO1
        N20 #1=1
        N30 END1
        N40 M30
    """,
    runs="", alarm="nc-and-macro-in-block", number=numbers("127", "PS0127"), at="O1 N10",
)
case(
    "N and block skip may stand before an assignment",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        /N10 #100=1
        N20 M30
    """,
    runs="N10 N20", vars={100: 1},
)
case(
    "a spindle speed before GOTO alarms",
    control=ALL, source="ALM PS0127; K-H 127", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 S500 GOTO30
        N30 M30
    """,
    runs="N10", alarm="nc-and-macro-in-block", number=numbers("127", "PS0127"), at="O1 N20",
)
case(
    "a T code before an assignment alarms and does not go out",
    control=ALL, source="ALM PS0127; K-H 127", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 T5 #100=1
        N30 M30
    """,
    runs="N10", alarm="nc-and-macro-in-block", number=numbers("127", "PS0127"), at="O1 N20",
    vars={100: None}, t=[1],
)

case(
    "the result of a comparison cannot be stored (F543)",
    control="fanuc-30i",
    source="MEX; ALM PS1125",
    evidence="secondary",
    program="""
        O1
        #2=[1 LT 2]
        M30
    """,
    alarm="expression-format",
    number="PS1125",
    at="O1",
)

case(
    "THEN takes no NC words (F546)",
    control="fanuc-30i",
    source="ALM PS1137; general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        IF[1 EQ 1] THEN G0 X5.
        M30
    """,
    alarm="if-format",
    number="PS1137",
    at="O1",
)
