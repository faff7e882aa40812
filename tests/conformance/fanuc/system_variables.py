"""FANUC: system variables."""

from datetime import datetime

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
NEW = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


case(
    "#3001 starts counting from the value it is set to",
    control=ALL, source="REG", evidence="secondary",
    program="""
        O1
        N10 #3001=5000
        N20 IF[#3001 GE 5000]THEN #100=1
        N30 IF[#3001 GT 100000]THEN #101=1
        N90 M30
    """,
    vars={100: 1, 101: None},
)
case(
    "#3002 can be read",
    control=ALL, source="REG", evidence="secondary",
    program="""
        O1
        N10 IF[#3002 GE 0]THEN #100=1
        N90 M30
    """,
    vars={100: 1},
)
case(
    "#3003 keeps what is written",
    control=ALL, source="ZAP; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 #3003=1
        N20 #100=#3003
        N90 M30
    """,
    vars={100: 1},
)
case(
    "#3004 keeps what is written",
    control=ALL, source="ZAP", evidence="secondary",
    program="""
        O1
        N10 #3004=7
        N20 #100=#3004
        N90 M30
    """,
    vars={100: 7},
)
case(
    "#3011 is the date and #3012 the time, as digits",
    control=ALL, source="REG", evidence="secondary",
    program="""
        O1
        N10 #100=#3011
        N20 #101=#3012
        N90 M30
    """,
    inputs={"clock": datetime(2026, 3, 9, 7, 5, 4)}, vars={100: 20260309, 101: 70504},
)
case(
    "#3012 is the time as six digits",
    control=ALL, source="REG", evidence="secondary",
    program="""
        O1
        N10 IF[#3012 LE 235959]THEN #100=1
        N90 M30
    """,
    vars={100: 1},
)
case(
    "#3901 keeps what is written",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #3901=12
        N20 #100=#3901
        N90 M30
    """,
    vars={100: 12},
)
case(
    "#4001 is the G code of group 1",
    control=ALL, source="REG, ZAP", evidence="secondary",
    program="""
        O1
        N10 G1 X1. F100
        N20 #100=#4001
        N90 M30
    """,
    vars={100: 1},
)
case(
    "#4002 is the plane",
    control=ALL, source="REG, ZAP", evidence="secondary",
    program="""
        O1
        N10 G18
        N20 #100=#4002
        N90 M30
    """,
    vars={100: 18},
)
case(
    "#4003 is G90 or G91",
    control=ALL, source="REG, ZAP", evidence="secondary",
    program="""
        O1
        N10 G91
        N20 #100=#4003
        N30 G90
        N40 #101=#4003
        N90 M30
    """,
    vars={100: 91, 101: 90},
)
case(
    "#4006 is G20 or G21",
    control=ALL, source="REG, ZAP", evidence="secondary",
    program="""
        O1
        N10 G20
        N20 #100=#4006
        N90 M30
    """,
    vars={100: 20},
)
case(
    "#4014 is the work coordinate system",
    control=ALL, source="REG, ZAP", evidence="secondary",
    program="""
        O1
        N10 #100=#4014
        N20 G56
        N30 #101=#4014
        N90 M30
    """,
    vars={100: 54, 101: 56},
)
case(
    "#4109 is F",
    control=ALL, source="REG", evidence="secondary",
    program="""
        O1
        N10 G1 X1. F250
        N20 #100=#4109
        N90 M30
    """,
    vars={100: 250},
)
case(
    "#4113 is the last M code",
    control=ALL, source="REG", evidence="secondary",
    program="""
        O1
        N10 M8
        N20 #100=#4113
        N90 M30
    """,
    vars={100: 8},
)
case(
    "#4115 is the program number",
    control=ALL, source="REG", evidence="secondary",
    program="""
        O1
        N10 G90
        N20 #100=#4115
        N90 M30
    """,
    vars={100: 1},
)
case(
    "#4119 is S",
    control=ALL, source="REG", evidence="secondary",
    program="""
        O1
        N10 S1200
        N20 #100=#4119
        N90 M30
    """,
    vars={100: 1200},
)
case(
    "#4120 is the last T code",
    control=ALL, source="REG", evidence="secondary",
    program="""
        O1
        N10 T6
        N20 #100=#4120
        N90 M30
    """,
    vars={100: 6}, t=[6],
)
case(
    "#4115 in a subprogram is the subprogram's number",
    control=ALL, source="REG; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P20
        N20 M30
        O20
        N30 G90
        N40 #100=#4115
        N50 M99
    """,
    vars={100: 20},
)
case(
    "#5003 is the end point of the block before in Z",
    control=ALL, source="ZAP; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 G90 G0 Z-7.5
        N20 #100=#5003
        N90 M30
    """,
    vars={100: -7.5},
)
case(
    "#5221 is the X offset of G54 and can be written",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #5221=12.5
        N20 #100=#5221
        N90 M30
    """,
    vars={100: 12.5},
)
case(
    "#5241 is the X offset of G55, not of G54",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #5241=3
        N20 #100=#5221
        N30 #101=#5241
        N90 M30
    """,
    vars={100: 0, 101: 3},
)
case(
    "#1100 keeps what is written",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #1100=1
        N20 #100=#1100
        N90 M30
    """,
    vars={100: 1},
)
case(
    "#4001 cannot be written",
    control=ALL, source="ALM PS0116; K-H 116", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #4001=1
        N30 M30
    """,
    runs="N10", alarm="variable-write-protected", number=numbers("116", "PS0116"), at="O1 N20",
)
case(
    "#4120 cannot be written",
    control=ALL, source="ALM PS0116; K-H 116", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #4120=1
        N30 M30
    """,
    runs="N10", alarm="variable-write-protected", number=numbers("116", "PS0116"), at="O1 N20",
)
case(
    "#5041 cannot be written",
    control=ALL, source="ALM PS0116; K-H 116", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #5041=1
        N30 M30
    """,
    runs="N10", alarm="variable-write-protected", number=numbers("116", "PS0116"), at="O1 N20",
)
case(
    "#1000 cannot be written",
    control=ALL, source="A51; ALM PS0116; K-H 116", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #1000=1
        N30 M30
    """,
    runs="N10", alarm="variable-write-protected", number=numbers("116", "PS0116"), at="O1 N20",
)
case(
    "#3007 cannot be written",
    control=ALL, source="ALM PS0116; K-H 116", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #3007=1
        N30 M30
    """,
    runs="N10", alarm="variable-write-protected", number=numbers("116", "PS0116"), at="O1 N20",
)
case(
    "#3011 cannot be written on the 16i",
    control="fanuc-16i", source="REG; K-H 116", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 #3011=20200101
        N30 M30
    """,
    runs="N10", alarm="variable-write-protected", number="116", at="O1 N20",
)
case(
    "#3000 cannot be read",
    control=NEW, source="ALM PS1115", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #100=#3000
        N30 M30
    """,
    runs="N10", alarm="variable-read-protected", number="PS1115", at="O1 N20",
)
case(
    "#3006 cannot be read",
    control=NEW, source="ALM PS1115", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #100=#3006
        N30 M30
    """,
    runs="N10", alarm="variable-read-protected", number="PS1115", at="O1 N20",
)
case(
    "#3050 does not exist",
    control=ALL, source="ALM PS0115; K-H 115", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 #100=#3050
        N30 M30
    """,
    runs="N10", alarm="illegal-variable", number=numbers("115", "PS0115"), at="O1 N20",
)
case(
    "#5021 cannot be written",
    control=ALL, source="ALM PS0116; K-H 116", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #5021=1
        N30 M30
    """,
    runs="N10", alarm="variable-write-protected", number=numbers("116", "PS0116"), at="O1 N20",
)
case(
    "#5061 cannot be written",
    control=ALL, source="ALM PS0116; K-H 116", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #5061=1
        N30 M30
    """,
    runs="N10", alarm="variable-write-protected", number=numbers("116", "PS0116"), at="O1 N20",
)
case(
    "#4115 cannot be written",
    control=ALL, source="ALM PS0116; K-H 116", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 #4115=7
        N30 M30
    """,
    runs="N10", alarm="variable-write-protected", number=numbers("116", "PS0116"), at="O1 N20",
)
