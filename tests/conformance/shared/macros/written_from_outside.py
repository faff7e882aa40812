"""Variables that another computer writes."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-30i"]
M700 = "mitsubishi-m700"
TA = "gsk-988ta"
ALL = [*FANUC, M700, TA]
WAITING = "real programs that wait for another computer; policy"


def per_control(fanuc_16i, fanuc_30i, m700, ta):
    return {"fanuc-16i": fanuc_16i, "fanuc-30i": fanuc_30i, M700: m700, TA: ta}


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
    "what another computer writes may raise the alarm after the loop",
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

case(
    "a loop that only says its motion code again waits for its input all the same",
    control=["fanuc-16i", "gsk-988ta", "mitsubishi-m700"],
    source="policy: what changes nothing can only wait for the world outside", evidence="inferred",
    program="O1\nN10 WHILE[#1000 EQ 0]DO1\nN20 G1 F478.\nN30 END1\nN40 M30",
    runs="(N10 N20 N30)*2", stop="waiting",
)
