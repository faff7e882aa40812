"""FANUC: vacant and zero in comparisons (9.2.8)."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]

case(
    "#1 EQ #0 is true while #1 is vacant",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N10 IF[#1 EQ #0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N10 N30",
)
case(
    "#1 EQ #0 is false while #1 is 0",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N5 #1=0
        N10 IF[#1 EQ #0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N5 N10 N20 N30",
)
case(
    "#1 NE 0 is true while #1 is vacant",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N10 IF[#1 NE 0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N10 N30",
)
case(
    "#1 NE 0 is false while #1 is 0",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N5 #1=0
        N10 IF[#1 NE 0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N5 N10 N20 N30",
)
case(
    "#1 GE #0 is true while #1 is vacant",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N10 IF[#1 GE #0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N10 N30",
)
case(
    "#1 GE #0 is true while #1 is 0",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N5 #1=0
        N10 IF[#1 GE #0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N5 N10 N30",
)
case(
    "#1 GT 0 is false while #1 is vacant",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N10 IF[#1 GT 0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "#1 GT 0 is false while #1 is 0",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N5 #1=0
        N10 IF[#1 GT 0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N5 N10 N20 N30",
)
case(
    "#1 LE #0 is true while #1 is vacant",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N10 IF[#1 LE #0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N10 N30",
)
case(
    "#1 LE #0 is true while #1 is 0",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N5 #1=0
        N10 IF[#1 LE #0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N5 N10 N30",
)
case(
    "#1 LT 0 is false while #1 is vacant",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N10 IF[#1 LT 0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "#1 LT 0 is false while #1 is 0",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N5 #1=0
        N10 IF[#1 LT 0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N5 N10 N20 N30",
)
case(
    "#1 NE #0 is false while #1 is vacant",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N10 IF[#1 NE #0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "#1 NE #0 is true while #1 is 0",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N5 #1=0
        N10 IF[#1 NE #0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N5 N10 N30",
)
case(
    "#1 EQ 0 is false while #1 is vacant",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N10 IF[#1 EQ 0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "#1 EQ 0 is true while #1 is 0",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N5 #1=0
        N10 IF[#1 EQ 0]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N5 N10 N30",
)
case(
    "two vacant variables are equal",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N10 IF[#1 EQ #2]GOTO30
        N20 T9
        N30 M30
    """,
    runs="N10 N30",
)
case(
    "a vacant variable in WHILE counts as zero for LT",
    control=ALL, source="M7V, TSN; K-H table", evidence="inferred",
    program="""
        O1
        N10 WHILE[#1 LT 2]DO1
        N20 #1=#1+1
        N30 END1
        N40 M30
    """,
    runs="(N10 N20 N30)*2 N10 N40",
)
