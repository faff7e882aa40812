"""The values of the clock."""

from datetime import datetime

from conformance import case

FANUC = ["fanuc-16i", "fanuc-30i"]
M700 = "mitsubishi-m700"
TA = "gsk-988ta"
ALL = [*FANUC, M700, TA]
CLOCK = "REG; general knowledge, clock variables"

case(
    "#3011 is the date that the clock shows",
    control=[M700, TA], source=CLOCK, evidence="inferred",
    program="""
        O1
        N10 #100=#3011
        N20 M30
    """,
    inputs={"clock": datetime(2031, 12, 5, 8, 0)}, runs="N10 N20", vars={100: 20311205},
)
case(
    "#3012 has no leading zeros: nine seconds past 0:05 is 509",
    control=ALL, source=CLOCK, evidence="inferred",
    program="""
        O1
        N10 #100=#3012
        N20 #101=FIX[#3012/100]
        N30 M30
    """,
    inputs={"clock": datetime(2026, 1, 2, 0, 5, 9)}, runs="N10 N20 N30", vars={100: 509, 101: 5},
)
case(
    "a program sends its tool by the hour of #3012",
    control=ALL, source=CLOCK, evidence="inferred",
    program="""
        O1
        N10 IF[#3012 GE 120000]GOTO 40
        N20 T1
        N30 M30
        N40 T2
        N50 M30
    """,
    inputs={"clock": datetime(2026, 1, 2, 13, 0)}, runs="N10 N40 N50", t=[2],
)
case(
    "the date is only read on the 16i",
    control="fanuc-16i", source="REG, #3011 R", evidence="secondary",
    program="""
        O1
        N10 M8
        N20 #3011=20200101
        N30 M30
    """,
    inputs={"clock": datetime(2026, 1, 2)}, runs="N10", alarm="variable-write-protected",
    number="116", at="O1 N20",
)
case(
    "the date may be written on the 30i",
    control="fanuc-30i", source="REG, #3011 W on the 30i", evidence="inferred",
    program="""
        O1
        N10 #3011=20200101
        N20 #100=#3011
        N30 M30
    """,
    inputs={"clock": datetime(2026, 1, 2)}, runs="N10 N20 N30", vars={100: 20200101},
)
case(
    "#3001 counts from the milliseconds that are given",
    control=ALL, source=CLOCK, evidence="inferred",
    program="""
        O1
        N10 IF[#3001 GE 60000]GOTO 30
        N20 M8
        N30 M30
    """,
    inputs={"clock": 60000}, runs="N10 N30", m=[],
)
case(
    "#3001 counts from 0 where no clock is given",
    control=ALL, source=CLOCK, evidence="inferred",
    program="""
        O1
        N10 IF[#3001 GE 60000]GOTO 30
        N20 M8
        N30 M30
    """,
    runs="N10 N20 N30", m=[8],
)
case(
    "a program sets #3001 back to 0",
    control=ALL, source="oddities of real programs; REG", evidence="inferred",
    program="""
        O1
        N10 #3001=0
        N20 IF[#3001 LT 1000]GOTO 40
        N30 M8
        N40 M30
    """,
    inputs={"clock": 500000}, runs="N10 N20 N40", m=[],
)
case(
    "a loop that waits for #3001 comes to its end, for time goes on",
    control=ALL, source="oddities of real programs; policy", evidence="inferred",
    program="""
        O1
        N10 #3001=0
        N20 IF[#3001 LT 50]GOTO 20
        N30 M8
        N40 M30
    """,
    m=[8], stop="end",
)
case(
    "#3002 goes on from the hours a program has written",
    control=ALL, source="REG; general knowledge, #3002", evidence="inferred",
    program="""
        O1
        N10 #3002=12.5
        N20 #100=#3002
        N30 M30
    """,
    runs="N10 N20 N30", vars={100: 12.5},
)
