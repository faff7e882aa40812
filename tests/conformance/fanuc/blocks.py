"""FANUC: ends of block, comments, spaces, block skip."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


case(
    "a semicolon ends a block",
    control=ALL, source="PB155; policy", evidence="maker's manual",
    program="""
        O1
        N10 M98 P2; N20 M98 P2;
        N30 M30;
        O2
        N40 M99;
    """,
    runs="N10 N40 N20 N40 N30",
)
case(
    "carriage return and line feed end one block, not two",
    control=ALL, source="PB155; policy", evidence="maker's manual",
    program="O1\r\nN10 M98 P2\r\nN20 M30\r\nO2\r\nN30 M99\r\n",
    runs="N10 N30 N20",
)
case(
    "a comment between M98 and its P changes nothing",
    control=ALL, source="GED", evidence="secondary",
    program="""
        O1
        N10 M98 (CALL O3) P2
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "an L inside a comment does not repeat the call",
    control=ALL, source="GED", evidence="secondary",
    program="""
        O1
        N10 M98 P2 (L3)
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a comment that is not closed hides the rest of its block",
    control=ALL, source="policy", evidence="inferred",
    program="""
        O1
        N10 M98 P2 (L3
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "lower case letters are read as upper case",
    control=ALL, source="policy", evidence="inferred",
    program="""
        o1
        n10 m98 p2
        n20 m30
        o2
        n30 m99
    """,
    runs="N10 N30 N20",
)
case(
    "an unknown character is an illegal address",
    control=ALL, source="policy; ALM PS0009", evidence="inferred",
    program="""
        O1
        N10 M98 P2 $
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-character", number=numbers("009", "PS0009"), at="O1 N10",
)
case(
    "an unknown character inside a comment alarms nothing",
    control=ALL, source="GED", evidence="secondary",
    program="""
        O1
        N10 M98 P2 ($ 5)
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a call needs no space between its words",
    control=ALL, source="GED", evidence="secondary",
    program="""
        O1
        N10M98P2L2
        N20M30
        O2
        N30M99
    """,
    runs="N10 N30*2 N20",
)
case(
    "spaces inside words do not count",
    control=ALL, source="GED", evidence="secondary",
    program="""
        O1
        N 10 M 9 8 P 2
        N 20 M 30
        O 2
        N 30 M 99
    """,
    runs="N10 N30 N20",
)
case(
    "block skip leaves out a call",
    control=ALL, source="GED, ISO", evidence="secondary",
    program="""
        O1
        /N10 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    skip=(1,), runs="N20",
)
case(
    "with the skip switch off a slash changes nothing",
    control=ALL, source="GED, ISO", evidence="secondary",
    program="""
        O1
        /N10 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a slash without a digit is skip 1, not skip 2",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        /N10 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    skip=(2,), runs="N10 N30 N20",
)
case(
    "/1 is the same as a slash alone",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        /1 N10 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    skip=(1,), runs="N20",
)
case(
    "/9 is skipped by switch 9",
    control=ALL, source="ISO", evidence="secondary",
    program="""
        O1
        /9 N10 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    skip=(9,), runs="N20",
)
case(
    "/1/3 is skipped by either switch",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        /1/3 N10 M98 P2
        /1/3 N20 M98 P2
        N30 M30
        O2
        N40 M99
    """,
    skip=(3,), runs="N30",
)
case(
    "a slash in mid-block hides the call after it and keeps the words before it",
    control=ALL, source="GED; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 T5 /M98 P2
        N20 M30
        O2
        N30 M99
    """,
    skip=(1,), runs="N10 N20", t=[5],
)
case(
    "a skipped faulty block alarms nothing",
    control=ALL, source="ISO; K-H general knowledge", evidence="inferred",
    program="""
        O1
        /N10 M98 P-2
        N20 M30
    """,
    skip=(1,), runs="N20",
)
case(
    "a faulty block after a slash alarms while the switch is off",
    control=ALL, source="ALM PS0006", evidence="secondary",
    program="""
        O1
        /N10 M98 P-2
        N20 M30
    """,
    runs="", alarm="illegal-minus-sign", number=numbers("006", "PS0006"), at="O1 N10",
)
case(
    "M99 P finds the N of a skipped block",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M3
        /N30 M4
        N40 M30
        O2
        N50 M99 P30
    """,
    skip=(1,), runs="N10 N50 N40", m=[],
)
case(
    "GOTO finds the N of a skipped block",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 GOTO30
        N20 M3
        /N30 M4
        N40 M30
    """,
    skip=(1,), runs="N10 N40", m=[],
)
case(
    "block skip works inside a subprogram",
    control=ALL, source="GED, ISO", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        /N30 M3
        N40 M99
    """,
    skip=(1,), runs="N10 N40 N20", m=[],
)

case(
    "a colon stands for O, comments are not read and spaces do not count (F001)",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="GED; PB155; the colon: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        %
        :1 (MAIN)
        N10 #100 = 1 (#100=9 IN A COMMENT)
        N20 G0 X 1 0. Y2.0
        N30 M30
        %
    """,
    runs="N10 N20 N30",
    vars={100: 1},
    moves="R X10 Y2",
)

case(
    "a block after a slash is left out while the switch is on (F004)",
    control=["fanuc-16i", "fanuc-30i"],
    source="GED; ISO",
    evidence="secondary",
    program="""
        O1
        #100=1
        /#100=2
        N20 M30
    """,
    skip=(1,),
    vars={100: 1},
)

case(
    "with the switch on, a slash inside a block takes the rest of the block away (F007)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        G91 G0
        N10 X1. /Y2.
        M30
    """,
    skip=(1,),
    moves="R X1",
)

case(
    "with the switch off, a slash inside a block does nothing (F008)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        G91 G0
        N10 X1. /Y2.
        M30
    """,
    moves="R X1 Y2",
)
