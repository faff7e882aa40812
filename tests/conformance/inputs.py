"""What the world outside answers: signals, the clock, the operator, another computer, the probe."""

from datetime import datetime

from conformance import case

FANUC = ["fanuc-16i", "fanuc-30i"]
M700 = "mitsubishi-m700"
TA = "gsk-988ta"
ALL = [*FANUC, M700, TA]

SIGNALS = "A51; general knowledge, interface inputs"
CLOCK = "REG; general knowledge, clock variables"
OPERATOR = "general knowledge, M00 and M01 stop until cycle start"
MESSAGE = "ZAP; general knowledge, #3006"
WAITING = "real programs that wait for another computer; policy"


def per_control(fanuc_16i, fanuc_30i, m700, ta):
    return {"fanuc-16i": fanuc_16i, "fanuc-30i": fanuc_30i, M700: m700, TA: ta}


# Signals

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

# The clock

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

# The operator

for stops, text in [("M00", "M00"), ("M01 with its switch on", "M01")]:
    TWO_STOPS = f"""
        O1
        N10 M8
        N20 {text}
        N30 {text}
        N40 M30
    """
    case(
        f"where nobody asks the operator, cycle start follows {stops}",
        pins="restart_m_code",
        control=ALL, source=OPERATOR, evidence="inferred", program=TWO_STOPS, optional_stop=True,
        runs="N10 N20 N30 N40",
    )
    case(
        f"cycle start goes on behind {stops}",
        control=ALL, source=OPERATOR, evidence="inferred", program=TWO_STOPS, optional_stop=True,
        inputs={"operator": ["start", "start"]}, runs="N10 N20 N30 N40",
    )
    case(
        f"a program that the operator does not start again waits at {stops}",
        control=ALL, source=OPERATOR, evidence="inferred", program=TWO_STOPS, optional_stop=True,
        inputs={"operator": ["stop"]}, runs="N10 N20", stop="waiting",
    )
    case(
        f"{stops}: without a further answer the program waits",
        control=ALL, source="policy, answers used up", evidence="inferred", program=TWO_STOPS,
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
    "an alarm behind M00 comes only when the operator has gone on",
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
    "behind an M00 that is not answered nothing alarms",
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
    "cycle start goes on behind #3006",
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
    "an M00 behind a block skip asks nobody",
    control=ALL, source="general knowledge, block skip", evidence="inferred",
    program="""
        O1
        N10 M8
        /N20 M00
        N30 M30
    """,
    skip=(1,), inputs={"operator": []}, runs="N10 N30",
)

# Another computer writes

SPIN = """
    O1
    N10 IF[#500 EQ 0]GOTO 10
    N20 #501=#500*2
    N30 M30
"""
case(
    "a program that asks a variable again and again waits in that block",
    control=ALL, source=WAITING, evidence="inferred",
    program=SPIN, variables={500: 0}, runs="N10 N10", vars={501: None}, stop="waiting",
)
case(
    "a value that another computer writes lets a waiting program go on",
    control=ALL, source=WAITING, evidence="inferred",
    program=SPIN, variables={500: 0}, inputs={"writes": [{500: 21}]}, runs="N10*3 N20 N30",
    vars={500: 21, 501: 42},
)
case(
    "before another computer writes again the program looks at what was written, and waits anew",
    control=ALL, source=WAITING, evidence="inferred",
    program="""
        O1
        N10 IF[#500 NE 2]GOTO 10
        N20 M30
    """,
    variables={500: 0}, inputs={"writes": [{500: 1}, {500: 2}]}, runs="N10*5 N20",
)
case(
    "a value that another computer writes into another variable leaves a program waiting",
    control=ALL, source=WAITING, evidence="inferred",
    program=SPIN, variables={500: 0}, inputs={"writes": [{502: 21}]}, vars={501: None, 502: 21},
    stop="waiting",
)
case(
    "another computer may write at a later look only",
    control=ALL, source=WAITING, evidence="inferred",
    program=SPIN, variables={500: 0}, inputs={"writes": [(3, {500: 4})]}, vars={500: 4, 501: 8},
)
case(
    "another computer may make a variable vacant",
    control=[*FANUC, M700], source=WAITING, evidence="inferred",
    program="""
        O1
        N10 IF[#500 NE #0]GOTO 10
        N20 M8
        N30 M30
    """,
    variables={500: 1}, inputs={"writes": [{500: None}]}, m=[8], vars={500: None},
)
case(
    "what another computer writes may raise the alarm behind the loop",
    control=ALL, source=WAITING, evidence="inferred",
    program="""
        O1
        N10 IF[#500 EQ 0]GOTO 10
        N20 #100=SQRT[#500]
        N30 M30
    """,
    variables={500: 0}, inputs={"writes": [{500: -4}]}, runs="N10*3",
    alarm="square-root-of-negative", number=per_control("119", "PS0119", "P282", "206"),
    at="O1 N20",
)
case(
    "a signal that never comes leaves a WHILE waiting at its END",
    control=ALL, source=WAITING, evidence="inferred",
    program="""
        O1
        N10 WHILE[#1000 EQ 0]DO1
        N20 END1
        N30 M30
    """,
    runs="(N10 N20)*2", stop="waiting",
)
case(
    "a signal that comes later ends a WHILE",
    control=ALL, source=WAITING, evidence="inferred",
    program="""
        O1
        N10 WHILE[#1000 EQ 0]DO1
        N20 END1
        N30 M30
    """,
    inputs={"writes": [{1000: 1}]}, runs="(N10 N20)*2 N10 N30",
)
case(
    "a signal that is on from the beginning lets a loop pass at once",
    control=ALL, source=WAITING, evidence="inferred",
    program="""
        O1
        N10 WHILE[#1000 EQ 0]DO1
        N20 END1
        N30 M30
    """,
    inputs={"signals": {1000: 1}}, runs="N10 N30",
)
case(
    "a program that waits in a subprogram waits inside the call",
    control=ALL, source=WAITING, evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 IF[#1000 EQ 0]GOTO 30
        N40 M99
    """,
    runs="O1:N10 O2:N30*2", calls="M98:O2", stop="waiting",
)
case(
    "a dispatcher takes one order after another until it is told to end",
    control=ALL, source=WAITING, evidence="inferred",
    program="""
        O1
        N10 #500=0
        N20 IF[#500 EQ 0]GOTO 20
        N30 IF[#500 EQ 9]GOTO 60
        N40 T#500
        N50 GOTO 10
        N60 M30
    """,
    inputs={"writes": [{500: 1}, {500: 2}, {500: 9}]}, t=[1, 2], vars={500: 9},
)
case(
    "a dispatcher that gets no further order waits for it",
    control=ALL, source=WAITING, evidence="inferred",
    program="""
        O1
        N10 #500=0
        N20 IF[#500 EQ 0]GOTO 20
        N30 IF[#500 EQ 9]GOTO 60
        N40 T#500
        N50 GOTO 10
        N60 M30
    """,
    inputs={"writes": [{500: 1}, {500: 2}]}, t=[1, 2], vars={500: 0}, stop="waiting",
)
case(
    "a loop that sends an M code is no waiting loop",
    control=ALL, source="policy, a loop that does something", evidence="inferred",
    program="""
        O1
        N10 IF[#1000 EQ 1]GOTO 40
        N20 M8
        N30 GOTO 10
        N40 M30
    """,
    max_blocks=9, runs="(N10 N20 N30)*3", stop="limit",
)

# The probe

PROBE = """
    O1
    N10 G90 G31 X100. F500
    N20 #100=#5061
    N30 #101=#5001
    N40 M30
"""
case(
    "G31 ends where its skip signal comes, and #5061 keeps the place",
    control=FANUC, source="ZAP, #5061; general knowledge, G31", evidence="inferred",
    program=PROBE, setup={"start": {"X": 0, "Y": 0, "Z": 0}}, inputs={"skips": [0.25]},
    vars={100: 25, 101: 25},
)
case(
    "G31 without its signal goes to its end point",
    control=FANUC, source="ZAP, #5061; general knowledge, G31", evidence="inferred",
    program=PROBE, setup={"start": {"X": 0, "Y": 0, "Z": 0}}, inputs={"skips": []},
    vars={100: 100, 101: 100},
)
case(
    "each G31 takes the next skip",
    control=FANUC, source="ZAP, #5061; general knowledge, G31", evidence="inferred",
    program="""
        O1
        N10 G90 G31 X100. F500
        N20 #100=#5061
        N30 G31 X0
        N40 #101=#5061
        N50 M30
    """,
    setup={"start": {"X": 0, "Y": 0, "Z": 0}}, inputs={"skips": [0.5, 0.2]},
    vars={100: 50, 101: 40},
)
case(
    "a program alarms where its probe met nothing",
    control=FANUC, source="GED, #3000; ZAP, #5061; general knowledge, G31", evidence="inferred",
    program="""
        O1
        N10 G90 G31 X100. F500
        N20 IF[#5061 LT 99.]GOTO 40
        N30 #3000=3(NO CONTACT)
        N40 M30
    """,
    setup={"start": {"X": 0, "Y": 0, "Z": 0}}, inputs={"skips": []}, runs="N10 N20 N30",
    alarm="user-alarm", number={"fanuc-16i": "3003", "fanuc-30i": "MC3003"}, at="O1 N30",
)
