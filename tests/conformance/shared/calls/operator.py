"""The answers of the operator: stops, switches, waits."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-30i"]
M700 = "mitsubishi-m700"
TA = "gsk-988ta"
ALL = [*FANUC, M700, TA]
OPERATOR = "general knowledge, M00 and M01 stop until cycle start"
MESSAGE = "ZAP; general knowledge, #3006"


def per_control(fanuc_16i, fanuc_30i, m700, ta):
    return {"fanuc-16i": fanuc_16i, "fanuc-30i": fanuc_30i, M700: m700, TA: ta}


case(
    "where nobody asks the operator, cycle start follows M00",
    control=ALL, source=OPERATOR, evidence="inferred",
    program="O1\nN10 M8\nN20 M00\nN30 M00\nN40 M30",
    optional_stop=True, runs="N10 N20 N30 N40",
)
case(
    "cycle start goes on after M00",
    control=ALL, source=OPERATOR, evidence="inferred",
    program="O1\nN10 M8\nN20 M00\nN30 M00\nN40 M30",
    optional_stop=True, inputs={"operator": ["start", "start"]}, runs="N10 N20 N30 N40",
)
case(
    "a program that the operator does not start again waits at M00",
    control=ALL, source=OPERATOR, evidence="inferred",
    program="O1\nN10 M8\nN20 M00\nN30 M00\nN40 M30",
    optional_stop=True, inputs={"operator": ["stop"]}, runs="N10 N20", stop="waiting",
)
case(
    "M00: without a further answer the program waits",
    control=ALL, source="policy, answers used up", evidence="inferred",
    program="O1\nN10 M8\nN20 M00\nN30 M00\nN40 M30",
    optional_stop=True, inputs={"operator": ["start"]}, runs="N10 N20 N30", stop="waiting",
)
case(
    "where nobody asks the operator, cycle start follows M01 with its switch on",
    pins="roles:M01=start-over", control=ALL, source=OPERATOR, evidence="inferred",
    program="O1\nN10 M8\nN20 M01\nN30 M01\nN40 M30",
    optional_stop=True, runs="N10 N20 N30 N40",
)
case(
    "cycle start goes on after M01 with its switch on",
    control=ALL, source=OPERATOR, evidence="inferred",
    program="O1\nN10 M8\nN20 M01\nN30 M01\nN40 M30",
    optional_stop=True, inputs={"operator": ["start", "start"]}, runs="N10 N20 N30 N40",
)
case(
    "a program that the operator does not start again waits at M01 with its switch on",
    control=ALL, source=OPERATOR, evidence="inferred",
    program="O1\nN10 M8\nN20 M01\nN30 M01\nN40 M30",
    optional_stop=True, inputs={"operator": ["stop"]}, runs="N10 N20", stop="waiting",
)
case(
    "M01 with its switch on: without a further answer the program waits",
    control=ALL, source="policy, answers used up", evidence="inferred",
    program="O1\nN10 M8\nN20 M01\nN30 M01\nN40 M30",
    optional_stop=True, inputs={"operator": ["start"]}, runs="N10 N20 N30", stop="waiting",
)
case(
    "M01 asks nobody while its switch is off",
    control=ALL, source="GED, M01; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M01
        N20 M01
        N30 M30
    """,
    inputs={"operator": []}, runs="N10 N20 N30",
)
case(
    "M00 needs an answer whether or not the switch of M01 is on",
    control=ALL, source=OPERATOR, evidence="inferred",
    program="""
        O1
        N10 M01
        N20 M00
        N30 M30
    """,
    inputs={"operator": []}, runs="N10 N20", stop="waiting",
)
case(
    "the other words of an M00 block come before its stop",
    control=ALL, source=OPERATOR, evidence="inferred",
    program="""
        O1
        N10 T5 M00
        N20 T6
        N30 M30
    """,
    inputs={"operator": ["stop"]}, runs="N10", t=[5], stop="waiting",
)
case(
    "M00 in a subprogram waits inside the call",
    control=ALL, source=OPERATOR, evidence="inferred",
    program="""
        O1
        N10 M98 P2 L2
        N20 M30
        O2
        N30 M00
        N40 M99
    """,
    inputs={"operator": ["start"]}, runs="O1:N10 O2:N30 O2:N40 O2:N30", calls="M98:O2",
    stop="waiting",
)
case(
    "an alarm after M00 comes only when the operator has gone on",
    control=ALL, source="ALM PS0112; MZ 861; Talm 014; general knowledge, M00",
    evidence="inferred",
    program="""
        O1
        N10 M00
        N20 #100=1/0
        N30 M30
    """,
    inputs={"operator": ["start"]}, runs="N10", alarm="division-by-zero",
    number=per_control("112", "PS0112", "P283", "014"), at="O1 N20",
)
case(
    "after an M00 that is not answered nothing alarms",
    control=ALL, source=OPERATOR, evidence="inferred",
    program="""
        O1
        N10 M00
        N20 #100=1/0
        N30 M30
    """,
    inputs={"operator": ["stop"]}, runs="N10", stop="waiting",
)
case(
    "#3006 shows its text and waits for the operator",
    control=ALL, source=MESSAGE, evidence="inferred",
    program="""
        O1
        N10 M8
        N20 #3006=1(CHECK TOOL)
        N30 M9
        N40 M30
    """,
    inputs={"operator": ["stop"]}, runs="N10 N20", m=[8], messages=["CHECK TOOL"], stop="waiting",
)
case(
    "cycle start goes on after #3006",
    control=ALL, source=MESSAGE, evidence="inferred",
    program="""
        O1
        N10 #3006=1(CHECK TOOL)
        N20 M9
        N30 M30
    """,
    inputs={"operator": ["start"]}, runs="N10 N20 N30", m=[9], messages=["CHECK TOOL"],
)
case(
    "M00, #3006 and M01 take their answers in the order in which they come",
    control=ALL, source="general knowledge, M00, M01 and #3006", evidence="inferred",
    program="""
        O1
        N10 M01
        N20 #3006=1(NEXT)
        N30 M00
        N40 M30
    """,
    optional_stop=True, inputs={"operator": ["start", "start", "stop"]}, runs="N10 N20 N30",
    messages=["NEXT"], stop="waiting",
)
case(
    "an M00 after a block skip asks nobody",
    control=ALL, source="general knowledge, block skip", evidence="inferred",
    program="""
        O1
        N10 M8
        /N20 M00
        N30 M30
    """,
    skip=(1,), inputs={"operator": []}, runs="N10 N30",
)
