"""GSK: Q of a call, and the call of the current program."""

from conformance import case

case(
    "Q5 starts the subprogram at N5 (TA-006)",
    pins="point_addresses minus_addresses",
    control="gsk-988ta",
    source="TA28 p.3, figure; source 000, words L and Q (1)",
    evidence="maker's manual",
    program="""
        O1
        G1 X12.22
        M98 P2121 Q5
        G1 X-10
        M30
        O2121
        G1 X40
        N5 G1 X50
        M99
    """,
    moves_x=[12.22, 50, -10],
)

case(
    "every repetition starts at Q (TA-007)",
    control="gsk-988ta",
    source="TA28 p.3, figure",
    evidence="maker's manual",
    program="""
        O1
        M98 P2121 Q5 L3
        M30
        O2121
        G1 X40
        N5 G1 X50
        M99
    """,
    moves_x=[50, 50, 50],
)

case(
    "Q without a P is looked for in the program that runs, not in the main program (TA-010)",
    pins="omitted_program self_call max_total_nesting",
    control="gsk-988ta",
    source="TA28 p.4, figure",
    evidence="maker's manual",
    program="""
        O1
        G1 X12.22
        M98 P2121 Q2 L2
        G1 X-10
        M30
        O2121
        G1 X77
        N2 G1 X50
        M98 Q5 L2
        G1 X31
        M99
        N5 G1 X51
        M99
    """,
    moves_x=[12.22, 50, 51, 51, 31, 50, 51, 51, 31, -10],
)

case(
    "a program that calls itself without Q alarms on the 988T (TA-030)",
    pins="self_call",
    control="gsk-988t",
    source="Talm 084",
    evidence="maker's manual",
    program="""
        O1
        G0 X1
        M98 P1
        M30
    """,
    moves_x=[1],
    alarm="program-calls-itself",
    number="084",
    at="O1",
)

TA, T, TDI, MDI, TE = "gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi", "gsk-928te"
FAMILY_988 = [TA, T]
SOURCE = "source document"
MANUAL = "maker's manual"
SECONDARY = "secondary"
INFERRED = "inferred"


def one_call(call, sub="N30 M99", name="O2"):
    """Return a main program O1 of one call, and the program that it calls."""
    return f"O1\nN10 {call}\nN20 M30\n{name}\n{sub}\n"


def assigned_call(statement, call, sub="N30 M99", name="O2"):
    """Return the same programs, with an assignment before the call."""
    return f"O1\nN5 {statement}\nN10 {call}\nN20 M30\n{name}\n{sub}\n"


SUB_WITH_N50 = "N40 G0 X40\nN50 G0 X50\nN60 M99"

case(
    "GSK 988TA: without Q the called program starts at its first block",
    control=TA, source="TA28 p.3, figure", evidence=MANUAL,
    program=one_call("M98 P2", SUB_WITH_N50),
    runs="N10 N40 N50 N60 N20",
)
case(
    "GSK 988TA: Q names the block at which the called program starts",
    control=TA, source="source 000, words L and Q (1)", evidence=SOURCE,
    program=one_call("M98 P2 Q50", SUB_WITH_N50),
    runs="N10 N50 N60 N20",
)
case(
    "GSK 988TA: Q finds an N number written with leading zeros",
    control=TA, source="source 000, words L and Q (1)", evidence=SOURCE,
    program=one_call("M98 P2 Q50", "N0040 G0 X40\nN0050 G0 X50\nN0060 M99"),
    runs="N10 N50 N60 N20",
)
case(
    "GSK 988TA: Q may be written with leading zeros",
    control=TA, source="source 000, words L and Q (1)", evidence=SOURCE,
    program=one_call("M98 P2 Q0050", SUB_WITH_N50),
    runs="N10 N50 N60 N20",
)
case(
    "GSK 988TA: every repetition starts at Q",
    control=TA, source="TA28 p.3, figure", evidence=MANUAL,
    program=one_call("M98 P2 Q50 L2", SUB_WITH_N50),
    runs="N10 (N50 N60)*2 N20",
)
case(
    "GSK 988TA: a count in P goes with Q",
    control=TA, source="TA28 p.1, format 1", evidence=MANUAL,
    program=one_call("M98 P30002 Q60", SUB_WITH_N50),
    runs="N10 N60*3 N20",
)
case(
    "GSK 988TA: Q goes with a program named by a variable",
    control=TA, source="TA28 p.1, format 2", evidence=MANUAL,
    program=assigned_call("#100=2.5", "M98 P[#100] Q50", SUB_WITH_N50),
    runs="N5 N10 N50 N60 N20",
)
case(
    "GSK 988TA: Q may be a variable",
    control=TA, source="source 000, words L and Q (1)", evidence=INFERRED,
    program=assigned_call("#100=50", "M98 P2 Q#100", SUB_WITH_N50),
    runs="N5 N10 N50 N60 N20",
)
case(
    "GSK 988TA: Q names a block that the called program must have",
    control=TA, source="source 000, words L and Q (1); number from Talm 083", evidence=INFERRED,
    program=one_call("M98 P2 Q70", SUB_WITH_N50),
    runs="", alarm="start-not-found", number="083", at="O1 N10",
)
case(
    "GSK 988TA: Q does not look in the caller",
    control=TA, source="source 000, words L and Q (1); number from Talm 083", evidence=INFERRED,
    program=one_call("M98 P2 Q20", SUB_WITH_N50),
    runs="", alarm="start-not-found", number="083", at="O1 N10",
)
case(
    "GSK 988TA: the words of the block come before the search for Q",
    control=TA, source="source 000, M98, function", evidence=INFERRED,
    program=one_call("G0 X1 M98 P2 Q70", SUB_WITH_N50),
    runs="N10", alarm="start-not-found", number="083", at="O1 N10",
)
case(
    "GSK 988TA: without P, Q calls the current program",
    control=TA, source="source 000, format 3", evidence=SOURCE,
    program="""
        O1
        N10 M98 Q50
        N20 M30
        N50 G0 X50
        N60 M99
    """,
    runs="N10 N50 N60 N20", calls="M98:O1",
)
case(
    "GSK 988TA: P of the current program with Q calls it",
    control=TA, source="source 000, format 3", evidence=SOURCE,
    program="""
        O1
        N10 M98 P1 Q50
        N20 M30
        N50 G0 X50
        N60 M99
    """,
    runs="N10 N50 N60 N20", calls="M98:O1",
)
case(
    "GSK 988TA: the current program may be named in brackets",
    control=TA, source="TA28 p.1, format 3", evidence=MANUAL,
    program="""
        O0001
        N10 M98 P[O0001] Q50 L2
        N20 M30
        N50 G0 X50
        N60 M99
    """,
    runs="N10 (N50 N60)*2 N20", calls="M98:O0001",
)
case(
    "GSK 988TA: the part that a program calls of itself stands after its M30",
    control=TA, source="TA28 p.3, figure of O1234", evidence=MANUAL,
    program="""
        O1234
        N10 G0 X10 Z10
        N20 M98 Q3 L2
        N30 G0 X-10 Z-10
        N40 M30
        N3 G0 X100 Z100
        N50 M99
    """,
    runs="N10 N20 (N3 N50)*2 N30 N40", calls="M98:O1234",
)
case(
    "GSK 988TA: in a subprogram Q without P means that subprogram",
    control=TA, source="TA28 p.4, figure", evidence=MANUAL,
    program="""
        O1
        N10 M98 P121 Q2 L2
        N20 M30
        N5 G0 X1
        O121
        N100 G0 X2
        N2 G0 X3
        N110 M98 Q5 L2
        N120 G0 X31 Z45
        N130 M99
        N5 G0 X4
        N140 M99
    """,
    runs="O1:N10 (O121:N2 O121:N110 (O121:N5 O121:N140)*2 O121:N120 O121:N130)*2 O1:N20",
    calls="M98:O121 M98:O121 M98:O121",
)
case(
    "GSK 988TA: Q without P must find its block in the current program",
    control=TA, source="source 000, format 3; number from Talm 083", evidence=INFERRED,
    program="""
        O1
        N10 M98 Q70
        N20 M30
        O2
        N70 M99
    """,
    runs="", alarm="start-not-found", number="083", at="O1 N10",
)
case(
    "GSK 988TA: M99 P of a program that called itself names a block of that program",
    control=TA, source="source 000, M99; format 3", evidence=INFERRED,
    program="""
        O1
        N10 M98 Q50
        N20 G0 X20
        N30 M30
        N50 G0 X50
        N60 M99 P30
    """,
    runs="N10 N50 N60 N30",
)
case(
    "GSK 988: the current program cannot be called without Q",
    control=FAMILY_988, source="source 000, format 3; Talm 084", evidence=SOURCE,
    program="""
        O1
        N10 G0 X1
        N20 M98 P1
        N30 M30
    """,
    runs="N10", alarm="program-calls-itself", number="084", at="O1 N20",
)
case(
    "GSK 988: the current program cannot be called with a count and without Q",
    control=FAMILY_988, source="source 000, format 3; Talm 084", evidence=SOURCE,
    program="O1\nN10 M98 P20001\nN20 M30\n",
    runs="", alarm="program-calls-itself", number="084", at="O1 N10",
)
case(
    "GSK 988TA: a variable that names the current program needs Q too",
    control=TA, source="source 000, format 3; Talm 084", evidence=SOURCE,
    program="O1\nN10 #100=1.5\nN20 M98 P[#100]\nN30 M30\n",
    runs="N10", alarm="program-calls-itself", number="084", at="O1 N20",
)
case(
    "GSK 988TA: the current program named in brackets needs Q too",
    control=TA, source="source 000, format 3; Talm 084", evidence=SOURCE,
    program="O0001\nN10 M98 P[O0001] L2\nN20 M30\n",
    runs="", alarm="program-calls-itself", number="084", at="O0001 N10",
)
case(
    "GSK 988: a subprogram cannot call itself without Q",
    control=FAMILY_988, source="source 000, format 3; Talm 084", evidence=SOURCE,
    program=one_call("M98 P2", "N30 M98 P2\nN40 M99"),
    runs="N10", alarm="program-calls-itself", number="084", at="O2 N30",
)
case(
    "GSK 988: a subprogram cannot call the main program without Q",
    pins="caller_call",
    control=FAMILY_988, source="Talm 084", evidence=SECONDARY,
    program=one_call("M98 P2", "N30 M98 P1\nN40 M99"),
    runs="N10", alarm="program-calls-caller", number="084", at="O2 N30",
)
case(
    "GSK 988: a subprogram cannot call its caller's caller without Q",
    pins="max_total_nesting",
    control=FAMILY_988, source="Talm 084", evidence=SECONDARY,
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M98 P3
        N40 M99
        O3
        N50 M98 P2
        N60 M99
    """,
    runs="N10 N30", alarm="program-calls-caller", number="084", at="O3 N50",
)
case(
    "GSK 988TA: a subprogram may call the main program with Q",
    control=TA, source="Talm 084 with source 000, format 3", evidence=INFERRED,
    program="""
        O1
        N10 M98 P2
        N20 M30
        N70 G0 X7
        N80 M99
        O2
        N30 M98 P1 Q70
        N40 M99
    """,
    runs="N10 N30 N70 N80 N40 N20", calls="M98:O2 M98:O1",
)
case(
    "GSK 988TA: a program that calls itself by Q without end is stopped at the thirteenth level",
    control=TA, source="source 000, nesting; Talm 082", evidence=SOURCE,
    program="O1\nN10 M98 Q10\nN20 M30\n",
    runs="N10*12", alarm="nesting-too-deep", number="082", at="O1 N10",
)
