"""GSK: programs called by name."""

from conformance import case

case(
    "P[O0023] L3 runs the standard program O0023 three times (TA-011)",
    pins="bracket_names",
    control="gsk-988ta",
    source="source 000, P, form 2",
    evidence="source document",
    program="""
        O1
        M98 P[O0023] L3
        M30
        O0023
        G1 X5
        M99
    """,
    moves_x=[5, 5, 5],
)

case(
    "P[T0023] runs the program named T0023 (TA-012)",
    control="gsk-988ta",
    source="source 000, P, form 2",
    evidence="source document",
    files={
        "O1.CNC": """
            O1
            M98 P[T0023] L2
            M30
        """,
        "T0023.CNC": """
            G1 X6
            M99
        """,
    },
    main="O1",
    moves_x=[6, 6],
)

case(
    "a star in the name of a program alarms (TA-027)",
    control="gsk-988ta",
    source="source 000, P, form 2",
    evidence="inferred",
    program="""
        O1
        G0 X1
        M98 P[A*B]
        M30
    """,
    moves_x=[1],
    alarm="illegal-program-name",
    at="O1",
)

case(
    "a program may have a Chinese name (TD-005)",
    pins="bracket_names",
    control="gsk-980tdi",
    source="TDi15",
    evidence="maker's manual",
    files={
        "O1.CNC": """
            O1
            M98 P[螺纹切削]
            M30
        """,
        "螺纹切削.CNC": """
            G0 X8
            M99
        """,
    },
    main="O1",
    moves_x=[8],
)

TA, T, TDI, MDI, TE = "gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi", "gsk-928te"
SOURCE = "source document"
MANUAL = "maker's manual"
INFERRED = "inferred"


def one_call(call, sub="N30 M99", name="O2"):
    """Return a main program O1 of one call, and the program that it calls."""
    return f"O1\nN10 {call}\nN20 M30\n{name}\n{sub}\n"


def assigned_call(statement, call, sub="N30 M99", name="O2"):
    """Return the same programs, with an assignment before the call."""
    return f"O1\nN5 {statement}\nN10 {call}\nN20 M30\n{name}\n{sub}\n"


case(
    "GSK 988TA: a name of O and four digits in brackets is the standard program",
    control=TA, source="source 000, word P, format 2", evidence=SOURCE,
    program=one_call("M98 P[O0045] L3", name="O45"),
    runs="N10 N30*3 N20", calls="M98:O45",
)
case(
    "GSK 988TA: T0045 is a program name",
    control=TA, source="source 000, word P, format 2 (1); TA27", evidence=SOURCE,
    files={"O1.CNC": "O1\nN10 M98 P[T0045] L2\nN20 M30\n", "T0045.CNC": "N30 M99\n"}, main="O1",
    runs="N10 N30*2 N20", calls="M98:T0045",
)
case(
    "GSK 988TA: A+B is a program name",
    pins="name_marks", control=TA, source="source 000, word P, format 2 (1); TA27", evidence=SOURCE,
    files={"O1.CNC": "O1\nN10 M98 P[A+B] L2\nN20 M30\n", "A+B.CNC": "N30 M99\n"}, main="O1",
    runs="N10 N30*2 N20", calls="M98:A+B",
)
case(
    "GSK 988TA: A-B is a program name",
    pins="name_marks", control=TA, source="source 000, word P, format 2 (1); TA27", evidence=SOURCE,
    files={"O1.CNC": "O1\nN10 M98 P[A-B] L2\nN20 M30\n", "A-B.CNC": "N30 M99\n"}, main="O1",
    runs="N10 N30*2 N20", calls="M98:A-B",
)
case(
    "GSK 988TA: A_B is a program name",
    pins="name_marks", control=TA, source="source 000, word P, format 2 (1); TA27", evidence=SOURCE,
    files={"O1.CNC": "O1\nN10 M98 P[A_B] L2\nN20 M30\n", "A_B.CNC": "N30 M99\n"}, main="O1",
    runs="N10 N30*2 N20", calls="M98:A_B",
)
case(
    "GSK 988TA: A.B is a program name",
    pins="name_marks", control=TA, source="source 000, word P, format 2 (1); TA27", evidence=SOURCE,
    files={"O1.CNC": "O1\nN10 M98 P[A.B] L2\nN20 M30\n", "A.B.CNC": "N30 M99\n"}, main="O1",
    runs="N10 N30*2 N20", calls="M98:A.B",
)
case(
    "GSK 988TA: SIDE-2.V1 is a program name",
    pins="name_marks", control=TA, source="source 000, word P, format 2 (1); TA27", evidence=SOURCE,
    files={"O1.CNC": "O1\nN10 M98 P[SIDE-2.V1] L2\nN20 M30\n", "SIDE-2.V1.CNC": "N30 M99\n"},
    main="O1", runs="N10 N30*2 N20", calls="M98:SIDE-2.V1",
)
case(
    "GSK 988TA: A=B is no program name",
    control=TA, source="source 000, word P, format 2 (1)", evidence=SOURCE,
    program=one_call("M98 P[A=B]"),
    runs="", alarm="illegal-program-name", at="O1 N10",
)
case(
    "GSK 988TA: A/B is no program name",
    control=TA, source="source 000, word P, format 2 (1)", evidence=SOURCE,
    program=one_call("M98 P[A/B]"),
    runs="", alarm="illegal-program-name", at="O1 N10",
)
case(
    "GSK 988TA: A,B is no program name",
    control=TA, source="source 000, word P, format 2 (1)", evidence=SOURCE,
    program=one_call("M98 P[A,B]"),
    runs="", alarm="illegal-program-name", at="O1 N10",
)
case(
    "GSK 988TA: A:B is no program name",
    control=TA, source="source 000, word P, format 2 (1)", evidence=SOURCE,
    program=one_call("M98 P[A:B]"),
    runs="", alarm="illegal-program-name", at="O1 N10",
)
case(
    "GSK 988TA: there is no arithmetic in the brackets of P",
    control=TA, source="TA27 p.1", evidence=MANUAL,
    program=assigned_call("#100=1", "M98 P[#100+1]"),
    runs="N5", alarm="illegal-program-name", at="O1 N10",
)
case(
    "GSK 988TA: a name that no program has is not found",
    control=TA, source="source 000, note 3; Talm 083", evidence=SOURCE,
    program=one_call("M98 P[T0002]", name="O0002"),
    runs="", alarm="named-program-not-found", number="083", at="O1 N10",
)
case(
    "GSK 988TA: T0002 and O0002 are two programs",
    control=TA, source="source 000, word P, format 2", evidence=SOURCE,
    files={
        "O0001.CNC": "O0001\nN10 M98 P[T0002]\nN20 M98 P[O0002]\nN30 M30\n",
        "O0002.CNC": "O0002\nN40 M99\n",
        "T0002.CNC": "N50 M99\n",
    },
    main="O0001", runs="N10 N50 N20 N40 N30", calls="M98:T0002 M98:O0002",
)
case(
    "GSK 988TA: a program with a name of its own may be started at Q",
    control=TA, source="TA28 p.1, format 2", evidence=MANUAL,
    files={
        "O1.CNC": "O1\nN10 M98 P[T2] Q50\nN20 M30\n",
        "T2.CNC": "N40 G0 X1\nN50 G0 X2\nN60 M99\n",
    },
    main="O1", runs="N10 N50 N60 N20",
)
case(
    "GSK 988TA: a program with a name of its own calls itself by Q",
    control=TA, source="source 000, format 3", evidence=SOURCE,
    files={
        "O1.CNC": "O1\nN10 M98 P[T2]\nN20 M30\n",
        "T2.CNC": "N40 M98 Q60\nN50 M99\nN60 G0 X2\nN70 M99\n",
    },
    main="O1", runs="N10 N40 N60 N70 N50 N20", calls="M98:T2 M98:T2",
)
case(
    "GSK 988TA: a program with a name of its own cannot call itself without Q",
    control=TA, source="source 000, format 3; Talm 084", evidence=SOURCE,
    files={
        "O1.CNC": "O1\nN10 M98 P[T2]\nN20 M30\n",
        "T2.CNC": "N40 M98 P[T2]\nN50 M99\n",
    },
    main="O1", runs="N10", alarm="program-calls-itself", number="084", at="T2 N40",
)

TWENTY = "ABCDEFGHIJKLMNOPQRST"

case(
    "GSK 980TDi: with 878=1 a program may be named CUT",
    control=TDI, source="TDi15", evidence=MANUAL,
    params={"878": 1}, files={"O1.CNC": "O1\nN10 M98 P[CUT]\nN20 M30\n", "CUT.CNC": "N30 M99\n"},
    main="O1", runs="N10 N30 N20", calls="M98:CUT",
)
case(
    "GSK 980TDi: with 878=1 a program may be named CUT-1",
    pins="name_marks", control=TDI, source="TDi15", evidence=MANUAL,
    params={"878": 1},
    files={"O1.CNC": "O1\nN10 M98 P[CUT-1]\nN20 M30\n", "CUT-1.CNC": "N30 M99\n"}, main="O1",
    runs="N10 N30 N20", calls="M98:CUT-1",
)
case(
    "GSK 980TDi: with 878=1 a program may be named A+B",
    pins="name_marks", control=TDI, source="TDi15", evidence=MANUAL,
    params={"878": 1}, files={"O1.CNC": "O1\nN10 M98 P[A+B]\nN20 M30\n", "A+B.CNC": "N30 M99\n"},
    main="O1", runs="N10 N30 N20", calls="M98:A+B",
)
case(
    "GSK 980TDi: with 878=1 a program may be named O.012",
    pins="name_marks", control=TDI, source="TDi15", evidence=MANUAL,
    params={"878": 1},
    files={"O1.CNC": "O1\nN10 M98 P[O.012]\nN20 M30\n", "O.012.CNC": "N30 M99\n"}, main="O1",
    runs="N10 N30 N20", calls="M98:O.012",
)
case(
    "GSK 980TDi: with 878=1 a program may be named ABCDEFGHIJKLMNOPQRST",
    pins="max_name_length", control=TDI, source="TDi15", evidence=MANUAL,
    params={"878": 1},
    files={"O1.CNC": "O1\nN10 M98 P[ABCDEFGHIJKLMNOPQRST]\nN20 M30\n", "ABCDEFGHIJKLMNOPQRST.CNC": "N30 M99\n"},
    main="O1", runs="N10 N30 N20", calls="M98:ABCDEFGHIJKLMNOPQRST",
)
case(
    "GSK 980TDi: with 878=1 a program may have a Chinese name",
    control=TDI, source="TDi15", evidence=MANUAL, params={"878": 1}, encoding="utf-8",
    files={
        "O1.CNC": "O1\nN10 M98 P[\u5207\u524a] L2\nN20 M30\n",
        "\u5207\u524a.CNC": "N30 M99\n",
    },
    main="O1", runs="N10 N30*2 N20",
)
case(
    "GSK 980TDi: L goes with a name",
    control=TDI, source="TDi15", evidence=MANUAL, params={"878": 1},
    files={"O1.CNC": "O1\nN10 M98 P[CUT] L4\nN20 M30\n", "CUT.CNC": "N30 M99\n"},
    main="O1", runs="N10 N30*4 N20", calls="M98:CUT",
)
case(
    "GSK 980TDi: L9999 is the most",
    control=TDI, source="TDi15", evidence=MANUAL, params={"878": 1},
    files={"O1.CNC": "O1\nN10 M98 P[CUT] L9999\nN20 M30\n", "CUT.CNC": "N30 M99\n"},
    main="O1", runs="N10 N30*9999 N20",
)
case(
    "GSK 980TDi: L0 is refused",
    control=TDI, source="TDi15; number from MDib 092", evidence=MANUAL, params={"878": 1},
    files={"O1.CNC": "O1\nN10 M98 P[CUT] L0\nN20 M30\n", "CUT.CNC": "N30 M99\n"}, main="O1",
    runs="", alarm="illegal-repeat-count", number="0092", at="O1 N10",
)
case(
    "GSK 980TDi: L10000 is refused",
    control=TDI, source="TDi15; number from MDib 092", evidence=MANUAL, params={"878": 1},
    files={"O1.CNC": "O1\nN10 M98 P[CUT] L10000\nN20 M30\n", "CUT.CNC": "N30 M99\n"}, main="O1",
    runs="", alarm="repeat-count-digits", number="0092", at="O1 N10",
)
case(
    "GSK 980TDi: a name of 21 characters is refused",
    control=TDI, source="TDi15; number from MDia 095", evidence=INFERRED, params={"878": 1},
    program=one_call(f"M98 P[{TWENTY}U]"),
    runs="", alarm="illegal-program-name", number="0095", at="O1 N10",
)
case(
    "GSK 980TDi: a name does not begin with a point",
    control=TDI, source="TDi15; number from MDia 095", evidence=INFERRED, params={"878": 1},
    program=one_call("M98 P[.CUT]"),
    runs="", alarm="illegal-program-name", number="0095", at="O1 N10",
)
case(
    "GSK 980TDi: an underscore is no character of a name",
    control=TDI, source="TDi15; number from MDia 095", evidence=INFERRED, params={"878": 1},
    program=one_call("M98 P[A_B]"),
    runs="", alarm="illegal-program-name", number="0095", at="O1 N10",
)
case(
    "GSK 980TDi: a name that no program has is not found",
    control=TDI, source="TDi15; number from MDia 001", evidence=INFERRED, params={"878": 1},
    program=one_call("M98 P[CUT]"),
    runs="", alarm="named-program-not-found", number="0001", at="O1 N10",
)
