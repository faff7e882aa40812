"""GSK: M, T and G codes that call a macro."""

from conformance import case

case(
    "G500, T2 and M31 call O9039, O9012 and O9020 (TA-037)",
    control="gsk-988ta",
    source="TA27",
    evidence="maker's manual",
    program="""
        O1
        G500
        T2
        M31
        M30
        O9039
        G0 X39
        M99
        O9012
        G0 X12
        M99
        O9020
        G0 X20
        M99
    """,
    params={"6062": 2, "6080": 31, "6099": 500, "6008#5": 1, "6008#6": 1, "6008#7": 1},
    moves_x=[39, 12, 20],
)

case(
    "G100 calls O2000 with arguments by the parameters 86 to 88 (TD-013)",
    control="gsk-980tdi",
    source="TDi32",
    evidence="maker's manual",
    program="""
        O1
        G100 A1 B2
        M30
        O2000
        G0 X#1
        G0 X#2
        M99
    """,
    params={"86": 1, "87": 100, "88": 2000},
    arguments={1: 1, 2: 2},
    moves_x=[1, 2],
)

TA, T, TDI, MDI = "gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi"
MANUAL = "maker's manual"
SECONDARY = "secondary"
INFERRED = "inferred"


def macro_call(call, macro="N30 M99", name="O2"):
    """Return a main program O1 of one macro call, and the macro."""
    return f"O1\nN10 {call}\nN20 M30\n{name}\n{macro}\n"


ON = {"6008#5": 1, "6008#6": 1, "6008#7": 1}
OFF = {"6008#5": 0, "6008#6": 0, "6008#7": 0}
CODES = {"6060": 1, "6069": 909, "6080": 31, "6089": 45, "6090": 500, "6099": 599}

case(
    "GSK 988TA: T1 registered in its first or last place calls O9010",
    control=TA, source="TA27 p.9, table", evidence=MANUAL, params=ON | CODES,
    program=macro_call("T1", name="O9010"),
    runs="N10 N30 N20", calls="T-code:O9010",
)
case(
    "GSK 988TA: T909 registered in its first or last place calls O9019",
    control=TA, source="TA27 p.9, table", evidence=MANUAL, params=ON | CODES,
    program=macro_call("T909", name="O9019"),
    runs="N10 N30 N20", calls="T-code:O9019",
)
case(
    "GSK 988TA: M31 registered in its first or last place calls O9020",
    control=TA, source="TA27 p.9, table", evidence=MANUAL, params=ON | CODES,
    program=macro_call("M31", name="O9020"),
    runs="N10 N30 N20", calls="M-code:O9020",
)
case(
    "GSK 988TA: M45 registered in its first or last place calls O9029",
    control=TA, source="TA27 p.9, table", evidence=MANUAL, params=ON | CODES,
    program=macro_call("M45", name="O9029"),
    runs="N10 N30 N20", calls="M-code:O9029",
)
case(
    "GSK 988TA: G500 registered in its first or last place calls O9030",
    control=TA, source="TA27 p.9, table", evidence=MANUAL, params=ON | CODES,
    program=macro_call("G500", name="O9030"),
    runs="N10 N30 N20", calls="G-code:O9030",
)
case(
    "GSK 988TA: G599 registered in its first or last place calls O9039",
    control=TA, source="TA27 p.9, table", evidence=MANUAL, params=ON | CODES,
    program=macro_call("G599", name="O9039"),
    runs="N10 N30 N20", calls="G-code:O9039",
)
case(
    "GSK 988TA: a G code that calls passes arguments and repeats like G65",
    control=TA, source="TA27 p.9, note 1", evidence=MANUAL, params=ON | CODES,
    program=macro_call("G500 L2 A7 I4 I8", name="O9030"),
    runs="N10 N30*2 N20", arguments={1: 7, 4: 4, 7: 8},
)
case(
    "GSK 988TA: an M code that calls passes arguments and repeats like G65",
    control=TA, source="TA27 p.9, note 1", evidence=MANUAL, params=ON | CODES,
    program=macro_call("M31 L3 A7 B2", name="O9020"),
    runs="N10 N30*3 N20", arguments={1: 7, 2: 2},
)
case(
    "GSK 988TA: a macro called by a code has local variables of its own",
    control=TA, source="TA27 p.9, like G65", evidence=MANUAL, params=ON | CODES,
    program="O1\nN10 #1=5\nN20 M31\nN30 M30\nO9020\nN40 #1=8\nN50 M99\n",
    runs="N10 N20 N40 N50 N30", vars={1: 5},
)
case(
    "GSK 988TA: an M code that calls a macro is not sent to the machine",
    control=TA, source="TA27 p.9, its own meaning is lost", evidence=MANUAL, params=ON | CODES,
    program="O1\nN10 M31\nN20 M98 P9\nO9020\nN40 M8\nN50 M99\n",
    runs="N10 N40 N50", m=[8], alarm="program-not-found", number="083", at="O1 N20",
)
case(
    "GSK 988TA: a T code that calls a macro is not sent to the machine",
    control=TA, source="TA27 p.9, its own meaning is lost", evidence=MANUAL, params=ON | CODES,
    program=macro_call("T909", name="O9019"),
    runs="N10 N30 N20", t=[],
)
case(
    "GSK 988TA: with 6008#5=0 a registered T code changes the tool and calls nothing",
    control=TA, source="TA27 p.9; TApar 6008", evidence=MANUAL, params=ON | CODES | {"6008#5": 0},
    program=macro_call("T909", name="O9019"),
    runs="N10 N20", calls="", t=[909],
)
case(
    "GSK 988TA: with 6008#6=0 a registered M code is sent and calls nothing",
    control=TA, source="TA27 p.9; TApar 6008", evidence=MANUAL, params=ON | CODES | {"6008#6": 0},
    program="O1\nN10 M31\nN20 M98 P9\nO9020\nN40 M99\n",
    runs="N10", calls="", m=[31], alarm="program-not-found", number="083", at="O1 N20",
)
case(
    "GSK 988TA: with 6008#7=0 a registered G code is no G code",
    control=TA, source="TA27 p.9; TApar 6008; Talm 009", evidence=MANUAL,
    params=ON | CODES | {"6008#7": 0},
    program=macro_call("G500 A1", name="O9030"),
    runs="", alarm="g-code-not-available", number="009", at="O1 N10",
)
case(
    "GSK 988TA: a G code that is not registered is no G code",
    control=TA, source="TA27 p.9; Talm 009", evidence=SECONDARY, params=ON | CODES,
    program=macro_call("G550", name="O9030"),
    runs="", alarm="g-code-not-available", number="009", at="O1 N10",
)
case(
    "GSK 988TA: an M code that is not registered is sent and calls nothing",
    control=TA, source="TA27 p.9", evidence=MANUAL, params=ON | CODES,
    program="O1\nN10 M32\nN20 M98 P9\nO9021\nN40 M99\n",
    runs="N10", calls="", m=[32], alarm="program-not-found", number="083", at="O1 N20",
)
case(
    "GSK 988TA: the macro of T1 may be missing",
    control=TA, source="TA27 p.9; Talm 083", evidence=SECONDARY, params=ON | CODES,
    program=macro_call("T1"),
    runs="", alarm="program-not-found", number="083", at="O1 N10",
)
case(
    "GSK 988TA: the macro of M31 may be missing",
    control=TA, source="TA27 p.9; Talm 083", evidence=SECONDARY, params=ON | CODES,
    program=macro_call("M31"),
    runs="", alarm="program-not-found", number="083", at="O1 N10",
)
case(
    "GSK 988TA: the macro of G500 may be missing",
    control=TA, source="TA27 p.9; Talm 083", evidence=SECONDARY, params=ON | CODES,
    program=macro_call("G500"),
    runs="", alarm="program-not-found", number="083", at="O1 N10",
)
case(
    "GSK 988TA: M30 may not be registered to call a macro",
    control=TA, source="TA27 p.9, note 3; Talm 222", evidence=SECONDARY, params=ON | {"6080": 30},
    program="O1\nN10 G0 X1\nN20 M30\nN30 M99\nO2\nN40 M99\nO9020\nN50 M99\n",
    runs="N10", alarm="code-may-not-call", number="222", at="O1 N20",
)
case(
    "GSK 988TA: M98 may not be registered to call a macro",
    control=TA, source="TA27 p.9, note 3; Talm 222", evidence=SECONDARY, params=ON | {"6080": 98},
    program="O1\nN10 G0 X1\nN20 M98 P2\nN30 M99\nO2\nN40 M99\nO9020\nN50 M99\n",
    runs="N10", alarm="code-may-not-call", number="222", at="O1 N20",
)
case(
    "GSK 988TA: with 6008#6=0 a forbidden M code that is registered keeps its meaning",
    control=TA, source="TA27 p.9; TApar 6008", evidence=MANUAL, params=OFF | {"6080": 98},
    program="O1\nN10 M98 P2\nN20 M30\nO2\nN40 M99\nO9020\nN50 M99\n",
    runs="N10 N40 N20", calls="M98:O2",
)
case(
    "GSK 988TA: a G code that calls is refused beside NC words as G65 is",
    control=TA, source="TA27 p.9, like G65; Talm 212", evidence=INFERRED, params=ON | CODES,
    program=macro_call("G0 G500 A1", name="O9030"),
    runs="", alarm="macro-call-not-first", number="212", at="O1 N10",
)

G_CODES = {"86": 3, "87": 100, "88": 2000}

case(
    "GSK 980TDi: G100 is number 1 of the G codes that call",
    control=TDI, source="TDi32", evidence=MANUAL, params=G_CODES,
    program=macro_call("G100", name="O2000"),
    runs="N10 N30 N20", calls="G-code:O2000",
)
case(
    "GSK 980TDi: G101 is number 2 of the G codes that call",
    control=TDI, source="TDi32", evidence=MANUAL, params=G_CODES,
    program=macro_call("G101", name="O2001"),
    runs="N10 N30 N20", calls="G-code:O2001",
)
case(
    "GSK 980TDi: G102 is number 3 of the G codes that call",
    control=TDI, source="TDi32", evidence=MANUAL, params=G_CODES,
    program=macro_call("G102", name="O2002"),
    runs="N10 N30 N20", calls="G-code:O2002",
)
case(
    "GSK 980TDi: a G code that calls passes arguments and repeats like G65",
    control=TDI, source="TDi32", evidence=MANUAL, params=G_CODES,
    program=macro_call("G100 L2 A1 I14 I6 K9 K11", name="O2000"),
    runs="N10 N30*2 N20", arguments={1: 1, 4: 14, 7: 6, 6: 9, 9: 11},
)
case(
    "GSK 980TDi: a macro called by a G code has local variables of its own",
    control=TDI, source="TDi32, like G65", evidence=MANUAL, params=G_CODES,
    program="O1\nN10 #1=5\nN20 G100 A8\nN30 M30\nO2000\nN40 #1=9\nN50 M99\n",
    runs="N10 N20 N40 N50 N30", vars={1: 5},
)
case(
    "GSK 980TDi: the G code after those that call is no G code",
    control=TDI, source="TDi32; number from MDib 0002", evidence=INFERRED, params=G_CODES,
    program=macro_call("G103", name="O2003"),
    runs="", alarm="g-code-not-available", number="0002", at="O1 N10",
)
case(
    "GSK 980TDi: with 86=0 no G code calls",
    control=TDI, source="TDi32; number from MDib 0002", evidence=INFERRED,
    params={"86": 0, "87": 100, "88": 2000},
    program=macro_call("G100", name="O2000"),
    runs="", alarm="g-code-not-available", number="0002", at="O1 N10",
)
case(
    "GSK 980TDi: a standard G code does not call",
    control=TDI, source="TDi32, note", evidence=MANUAL, params={"86": 1, "87": 99, "88": 2000},
    program=macro_call("G99", name="O2000"),
    runs="N10 N20", calls="",
)
case(
    "GSK 980TDi: the macro of a G code may be missing",
    control=TDI, source="TDi32; number from MDia 001", evidence=INFERRED, params=G_CODES,
    program=macro_call("G101", name="O2000"),
    runs="", alarm="program-not-found", number="0001", at="O1 N10",
)
