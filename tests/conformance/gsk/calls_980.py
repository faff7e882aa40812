"""GSK 980: calls that a program may not make, and M codes that call a subprogram."""

from conformance import case

case(
    "M17 calls O5 by the parameters 89 to 91 (TD-012)",
    control="gsk-980tdi",
    source="TDi17",
    evidence="maker's manual",
    program="""
        O1
        G0 X1
        M17
        M30
        O5
        G0 X5
        M99
    """,
    params={"89": 17, "90": 5, "91": 1},
    moves_x=[1, 5],
)

case(
    "a program that calls itself alarms on the 980TDi (TD-016)",
    pins="self_call",
    control="gsk-980tdi",
    source="MDia 097 of the 980MDi",
    evidence="secondary",
    program="""
        O1
        G0 X1
        M98 P1
        M30
    """,
    moves_x=[1],
    alarm="program-calls-itself",
    number="0097",
    at="O1",
)

case(
    "a subprogram that calls the main program alarms (TD-017)",
    control="gsk-980tdi",
    source="MDia 094 of the 980MDi",
    evidence="secondary",
    program="""
        O1
        M98 P2
        M30
        O2
        G0 X2
        M98 P1
        M99
    """,
    moves_x=[2],
    alarm="program-calls-caller",
    number="0094",
    at="O2",
)

case(
    "the fifth level alarms on the 980TDi (TD-019)",
    control="gsk-980tdi",
    source="MDia 096 of the 980MDi",
    evidence="secondary",
    program="""
        O1
        M98 P2
        M30
        O2
        G0 X2
        M98 P3
        M99
        O3
        G0 X3
        M98 P4
        M99
        O4
        G0 X4
        M98 P5
        M99
        O5
        G0 X5
        M98 P6
        M99
        O6
        G0 X6
        M99
    """,
    moves_x=[2, 3, 4, 5],
    alarm="nesting-too-deep",
    number="0096",
    at="O5",
)

TA, T, TDI, MDI, TE = "gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi", "gsk-928te"
FAMILY_980 = [TDI, MDI]
MANUAL = "maker's manual"
INFERRED = "inferred"


def one_call(call, sub="N30 M99", name="O2"):
    """Return a main program O1 of one call, and the program that it calls."""
    return f"O1\nN10 {call}\nN20 M30\n{name}\n{sub}\n"


case(
    "GSK 980: the main program cannot call itself",
    pins="self_call",
    control=FAMILY_980, source="MDia 097", evidence=MANUAL,
    program="O1\nN10 M98 P20001\nN20 M30\n",
    runs="", alarm="program-calls-itself", number="0097", at="O1 N10",
)
case(
    "GSK 980: a subprogram cannot call itself",
    control=FAMILY_980, source="MDib 097", evidence=MANUAL,
    program=one_call("M98 P2", "N30 M98 P2\nN40 M99"),
    runs="N10", alarm="program-calls-itself", number="0097", at="O2 N30",
)
case(
    "GSK 980: a subprogram of the second level cannot call the main program",
    pins="caller_call",
    control=FAMILY_980, source="MDia 094", evidence=MANUAL,
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M98 P3
        N40 M99
        O3
        N50 M98 P1
        N60 M99
    """,
    runs="N10 N30", alarm="program-calls-caller", number="0094", at="O3 N50",
)
case(
    "GSK 980TDi: a program with a name cannot call itself",
    control=TDI, source="TDi15; number from MDib 097", evidence=INFERRED, params={"878": 1},
    files={"O1.CNC": "O1\nN10 M98 P[CUT]\nN20 M30\n", "CUT.CNC": "N30 M98 P[CUT]\nN40 M99\n"},
    main="O1", runs="N10", alarm="program-calls-itself", number="0097", at="CUT N30",
)

M_CODES = {"89": 17, "90": 1, "91": 3}

case(
    "GSK 980TDi: M17 is number 1 of the M codes that call",
    control=TDI, source="TDi17", evidence=MANUAL, params=M_CODES,
    program="O100\nN10 M17\nN20 M30\nO1\nN30 M99\n",
    runs="N10 N30 N20", calls="M-code:O1",
)
case(
    "GSK 980TDi: M18 is number 2 of the M codes that call",
    control=TDI, source="TDi17", evidence=MANUAL, params=M_CODES,
    program="O100\nN10 M18\nN20 M30\nO2\nN30 M99\n",
    runs="N10 N30 N20", calls="M-code:O2",
)
case(
    "GSK 980TDi: M19 is number 3 of the M codes that call",
    control=TDI, source="TDi17", evidence=MANUAL, params=M_CODES,
    program="O100\nN10 M19\nN20 M30\nO3\nN30 M99\n",
    runs="N10 N30 N20", calls="M-code:O3",
)
case(
    "GSK 980TDi: an M code after those that call is sent to the machine",
    control=TDI, source="TDi17", evidence=MANUAL, params=M_CODES,
    program="O100\nN10 M20\nN20 M98 P9\nN25 M30\nO4\nN30 M99\n",
    runs="N10", m=[20], calls="", alarm="program-not-found", number="0001", at="O100 N20",
)
case(
    "GSK 980TDi: an M code in front of those that call is sent to the machine",
    control=TDI, source="TDi17", evidence=MANUAL, params=M_CODES,
    program="O100\nN10 M16\nN20 M98 P9\nN25 M30\nO1\nN30 M99\n",
    runs="N10", m=[16], calls="", alarm="program-not-found", number="0001", at="O100 N20",
)
case(
    "GSK 980TDi: an M code that calls is not sent to the machine",
    control=TDI, source="TDi17, note", evidence=MANUAL, params=M_CODES,
    program="O100\nN10 M17\nN20 M98 P9\nN25 M30\nO1\nN30 M99\n",
    runs="N10 N30", m=[], alarm="program-not-found", number="0001", at="O100 N20",
)
case(
    "GSK 980TDi: with 91=0 no M code calls",
    control=TDI, source="TDi17", evidence=MANUAL, params={"89": 17, "90": 1, "91": 0},
    program="O100\nN10 M17\nN20 M30\nO1\nN30 M99\n",
    runs="N10 N20", calls="",
)
case(
    "GSK 980TDi: the program of an M code may be missing",
    control=TDI, source="TDi17; number from MDia 001", evidence=INFERRED, params=M_CODES,
    program="O100\nN10 M19\nN20 M30\nO1\nN30 M99\n",
    runs="", alarm="program-not-found", number="0001", at="O100 N10",
)
case(
    "GSK 980MDi: 6044 to 6046 register the M codes that call",
    control=MDI, source="MDia, appendix, tool change by M06", evidence=MANUAL,
    params={"6044": 6, "6045": 9001, "6046": 1},
    program="O100\nN10 M6\nN20 M30\nO9001\nN30 M99\n",
    runs="N10 N30 N20", calls="M-code:O9001",
)
case(
    "GSK 980MDi: with 6046=0 no M code calls",
    control=MDI, source="MDia, appendix, tool change by M06", evidence=MANUAL,
    params={"6044": 6, "6045": 9001, "6046": 0},
    program="O100\nN10 M6\nN20 M30\nO9001\nN30 M99\n",
    runs="N10 N20", calls="",
)
