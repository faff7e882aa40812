"""Input and output signals."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-30i"]
M700 = "mitsubishi-m700"
TA = "gsk-988ta"
ALL = [*FANUC, M700, TA]
SIGNALS = "A51; general knowledge, interface inputs"


def per_control(fanuc_16i, fanuc_30i, m700, ta):
    return {"fanuc-16i": fanuc_16i, "fanuc-30i": fanuc_30i, M700: m700, TA: ta}


case(
    "a signal that is on reads as 1, and a program branches by it",
    control=ALL, source=SIGNALS, evidence="inferred",
    program="""
        O1
        N10 #100=#1000
        N20 IF[#1003 EQ 1]GOTO 40
        N30 M8
        N40 M30
    """,
    inputs={"signals": {1000: 1, 1003: 1}}, runs="N10 N20 N40", vars={100: 1}, m=[],
)
case(
    "a signal that nobody gives is off",
    control=ALL, source=SIGNALS, evidence="inferred",
    program="""
        O1
        N10 #100=#1001
        N20 IF[#1003 EQ 1]GOTO 40
        N30 M8
        N40 M30
    """,
    inputs={"signals": {1000: 1}}, runs="N10 N20 N30 N40", vars={100: 0}, m=[8],
)
case(
    "a signal that is off is 0 and not vacant",
    control=[*FANUC, M700], source=SIGNALS, evidence="inferred",
    program="""
        O1
        N10 IF[#1000 EQ #0]GOTO 30
        N20 M8
        N30 M30
    """,
    runs="N10 N20 N30", m=[8],
)
case(
    "#1032 reads a word of signals as one number",
    control=ALL, source=SIGNALS, evidence="inferred",
    program="""
        O1
        N10 #100=#1032
        N20 #101=#100 AND 4
        N30 M30
    """,
    inputs={"signals": {1032: 37}}, runs="N10 N20 N30", vars={100: 37, 101: 4},
)
case(
    "a word of signals may be the tool number",
    control=ALL, source=SIGNALS, evidence="inferred",
    program="""
        O1
        N10 T#1032
        N20 M30
    """,
    inputs={"signals": {1032: 7}}, runs="N10 N20", t=[7],
)
case(
    "the number of a signal may be computed",
    control=ALL, source="real programs; A51", evidence="inferred",
    program="""
        O1
        N10 #1=2
        N20 #100=#[1000+#1]
        N30 #101=#[1001+#1]
        N40 M30
    """,
    inputs={"signals": {1003: 1}}, runs="N10 N20 N30 N40", vars={100: 0, 101: 1},
)
case(
    "a program cannot write an input signal",
    control=ALL, source="A51; general knowledge P243; Talm 220", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 #1000=0
        N30 M30
    """,
    inputs={"signals": {1000: 1}}, runs="N10", alarm="variable-write-protected",
    number=per_control("116", "PS0116", "P243", "220"), at="O1 N20",
)
case(
    "a program that guards a signal raises its own alarm where the signal is off",
    pins="user_alarm_offset",
    control=ALL, source="GED, #3000; MZ 979; general knowledge, interface inputs",
    evidence="inferred",
    program="""
        O1
        N10 IF[#1004 EQ 1]GOTO 30
        N20 #3000=5(DOOR IS OPEN)
        N30 M8
        N40 M30
    """,
    inputs={"signals": {1005: 1}}, runs="N10 N20", alarm="user-alarm",
    number=per_control("3005", "MC3005", "P277", "3005"), at="O1 N20", m=[],
)
case(
    "a program that guards a signal goes on where the signal is on",
    control=ALL, source="GED, #3000; MZ 979; general knowledge, interface inputs",
    evidence="inferred",
    program="""
        O1
        N10 IF[#1004 EQ 1]GOTO 30
        N20 #3000=5(DOOR IS OPEN)
        N30 M8
        N40 M30
    """,
    inputs={"signals": {1004: 1}}, runs="N10 N30 N40", m=[8],
)
case(
    "a macro divides by a word of signals that is 0 and alarms",
    control=ALL, source="ALM PS0112; MZ 861; Talm 014", evidence="inferred",
    program="""
        O1
        N10 G65 P2
        N20 M30
        O2
        N30 #100=8/#1032
        N40 M99
    """,
    inputs={"signals": {1032: 0}}, runs="N10", alarm="division-by-zero",
    number=per_control("112", "PS0112", "P283", "014"), at="O2 N30", calls="G65:O2",
)
