"""GSK: M99, M99 P, and an N that stands twice."""

from conformance import case

case(
    "M99 P99 alarms where the caller has no N99 (TA-022)",
    pins="return_with_p",
    control="gsk-988ta",
    source="source 000, note 1; Talm 083 of the 988T",
    evidence="secondary",
    program="""
        O1
        M98 P2
        M30
        O2
        G0 X1
        M99 P99
    """,
    moves_x=[1],
    alarm="return-target-not-found",
    number="083",
    at="O2",
)

case(
    "of two N7 after the call M99 P7 takes the earlier one (TA-024)",
    control="gsk-988ta",
    source="source 000, note 2 (2)",
    evidence="source document",
    program="""
        O1
        N50 M98 P2
        G0 X3
        N7 G0 X1
        M30
        N7 G0 X2
        M30
        O2
        G0 X9
        M99 P7
    """,
    moves_x=[9, 1],
)

case(
    "of two N7 around the call M99 P7 takes the one after it (TA-025)",
    pins="return_search statements",
    control="gsk-988ta",
    source="source 000, note 2 (3)",
    evidence="source document",
    program="""
        O1
        GOTO 50
        N7 G0 X1
        M30
        N50 M98 P2
        G0 X3
        N7 G0 X2
        M30
        O2
        G0 X9
        M99 P7
    """,
    moves_x=[9, 2],
)

TA, T, TDI, MDI, TE = "gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi", "gsk-928te"
FAMILY_988 = [TA, T]
FAMILY_980 = [TDI, MDI]
FAMILIES = [TA, T, TDI, MDI]
SOURCE = "source document"
MANUAL = "maker's manual"
SECONDARY = "secondary"
INFERRED = "inferred"
NOT_FOUND = {TA: "083", T: "083", TDI: "0001", MDI: "0001"}
NO_RETURN_BLOCK = {TA: "083", T: "083", TDI: "0112", MDI: "0112"}


def one_call(call, sub="N30 M99", name="O2"):
    """Return a main program O1 of one call, and the program that it calls."""
    return f"O1\nN10 {call}\nN20 M30\n{name}\n{sub}\n"


# --- M99 -------------------------------------------------------------------------------------------

case(
    "GSK: M99 returns to the block after the call",
    control=FAMILIES, source="source 000, M99", evidence=SOURCE,
    program=one_call("M98 P2", "N30 G0 X3\nN40 M99\nN50 G0 X5"),
    runs="N10 N30 N40 N20",
)
case(
    "GSK: M99 P skips the blocks between the call and its target",
    pins="return_with_p",
    control=FAMILIES, source="source 000, M99", evidence=SOURCE,
    program="""
        O1009
        N40 M98 P1010
        N50 G0 X5
        N60 G0 X6
        N70 M30
        O1010
        N1000 G0 X1
        N1100 M99 P0070
    """,
    runs="N40 N1000 N1100 N70",
)
case(
    "GSK: M99 P may go back in the caller",
    control=FAMILIES, source="source 000, M99", evidence=SOURCE,
    program="""
        O1
        N5 GOTO 30
        N10 G0 X1
        N20 M30
        N30 M98 P2
        N40 M30
        O2
        N50 M99 P10
    """,
    runs="N5 N30 N50 N10 N20",
)
case(
    "GSK: M99 P of five digits finds its block",
    control=FAMILIES, source="TA28 p.5", evidence=MANUAL,
    program="""
        O1
        N10 M98 P2
        N20 G0 X2
        N12345 M30
        O2
        N30 M99 P12345
    """,
    runs="N10 N30 N12345",
)
case(
    "GSK: M99 P names a block of the caller, not of the main program",
    pins="max_total_nesting",
    control=FAMILIES, source="source 000, M99", evidence=SOURCE,
    program="""
        O1
        N10 M98 P2
        N20 M30
        N70 M30
        O2
        N30 M98 P3
        N40 G0 X4
        N70 M99
        O3
        N50 M99 P70
    """,
    runs="O1:N10 O2:N30 O3:N50 O2:N70 O1:N20",
)
case(
    "GSK 988TA: M99 P may be a variable",
    control=TA, source="source 000, M99", evidence=INFERRED,
    program="""
        O1
        N10 M98 P2
        N20 G0 X2
        N30 M30
        O2
        N40 #100=30
        N50 M99 P#100
    """,
    runs="N10 N40 N50 N30",
)
case(
    "GSK 988TA: M99 P may return to the call itself",
    control=TA, source="source 000, M99", evidence=INFERRED,
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 #100=#100+1
        N40 IF[#100 EQ 1]GOTO 60
        N50 M99
        N60 M99 P10
    """,
    variables={100: 0}, runs="N10 N30 N40 N60 N10 N30 N40 N50 N20", calls="M98:O2 M98:O2",
)
case(
    "GSK: the words of an M99 block are executed before the return",
    control=FAMILIES, source="source 000, M99, function", evidence=SOURCE,
    program="""
        O1
        N10 M98 P2
        N20 M98 P9
        N30 M30
        O2
        N40 M9 M99
    """,
    runs="N10 N40", m=[9], alarm="program-not-found", number=NOT_FOUND, at="O1 N20",
)
case(
    "GSK: a return block that the caller does not have is an alarm",
    control=FAMILIES, source="source 000, note 1; Talm 083; MDia 112", evidence=SOURCE,
    program=one_call("M98 P2", "N30 G0 X3\nN40 M99 P90"),
    runs="N10 N30", alarm="return-target-not-found", number=NO_RETURN_BLOCK, at="O2 N40",
)
case(
    "GSK: a return block of the subprogram itself does not count",
    control=FAMILIES, source="source 000, note 1; Talm 083; MDia 112", evidence=SOURCE,
    program=one_call("M98 P2", "N30 G0 X3\nN40 M99 P30"),
    runs="N10 N30", alarm="return-target-not-found", number=NO_RETURN_BLOCK, at="O2 N40",
)
case(
    "GSK: a return block that only the main program has does not serve a deeper return",
    control=FAMILIES, source="source 000, note 1; Talm 083; MDia 112", evidence=SOURCE,
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M98 P3
        N40 M99
        O3
        N50 M99 P20
    """,
    runs="N10 N30", alarm="return-target-not-found", number=NO_RETURN_BLOCK, at="O3 N50",
)
case(
    "GSK: the words of an M99 block are executed before its target is looked for",
    control=FAMILIES, source="source 000, M99, function; note 1", evidence=SOURCE,
    program=one_call("M98 P2", "N30 M9 M99 P90"),
    runs="N10 N30", m=[9], alarm="return-target-not-found", number=NO_RETURN_BLOCK, at="O2 N30",
)
case(
    "GSK 980: a return to a number above 99999 is refused",
    control=FAMILY_980, source="MDia 112, MDib 112", evidence=MANUAL,
    program=one_call("M98 P2", "N30 M99 P100000"),
    runs="N10", alarm="return-target-not-found", number="0112", at="O2 N30",
)
case(
    "GSK 988: G28 may not stand in the block of M99",
    pins="codes_not_with_return", control=FAMILY_988, source="Talm 030", evidence=SECONDARY,
    program=one_call("M98 P2", "N30 G28 U0 M99"),
    runs="N10", alarm="illegal-word-with-return", number="030", at="O2 N30",
)
case(
    "GSK 988: G30 may not stand in the block of M99",
    pins="codes_not_with_return", control=FAMILY_988, source="Talm 030", evidence=SECONDARY,
    program=one_call("M98 P2", "N30 G30 U0 M99"),
    runs="N10", alarm="illegal-word-with-return", number="030", at="O2 N30",
)
case(
    "GSK 988: G53 may not stand in the block of M99",
    pins="codes_not_with_return", control=FAMILY_988, source="Talm 030", evidence=SECONDARY,
    program=one_call("M98 P2", "N30 G53 X0 M99"),
    runs="N10", alarm="illegal-word-with-return", number="030", at="O2 N30",
)
case(
    "GSK 988: G36 may not stand in the block of M99",
    pins="codes_not_with_return", control=FAMILY_988, source="Talm 030", evidence=SECONDARY,
    program=one_call("M98 P2", "N30 G36 X50 M99"),
    runs="N10", alarm="illegal-word-with-return", number="030", at="O2 N30",
)
case(
    "GSK 988: G37 may not stand in the block of M99",
    pins="codes_not_with_return", control=FAMILY_988, source="Talm 030", evidence=SECONDARY,
    program=one_call("M98 P2", "N30 G37 Z50 M99"),
    runs="N10", alarm="illegal-word-with-return", number="030", at="O2 N30",
)
case(
    "GSK: M99 of a main program starts it anew",
    pins="main_return",
    control=FAMILIES, source="source 000, M99; K", evidence=SOURCE,
    program="O1\nN10 G0 X1\nN20 M99\n",
    max_cycles=3, runs="(N10 N20)*3", stop="cycles",
)
case(
    "GSK: a main program that ends in M99 never ends by itself",
    control=FAMILIES, source="source 000, M99; K", evidence=SOURCE,
    program="O1\nN10 G0 X1\nN20 M98 P2\nN30 M99\nO2\nN40 M99\n",
    max_cycles=100, max_blocks=9, runs="(N10 N20 N40 N30)*2 N10", stop="limit",
)
case(
    "GSK: the last pass of a main program ends with its M99",
    control=FAMILIES, source="source 000, M99; K", evidence=SOURCE,
    program="O1\nN10 G0 X1\nN20 M99\nN30 M30\n",
    max_cycles=1, runs="N10 N20", stop="cycles",
)
case(
    "GSK: M99 P of a main program goes on at its block",
    control=FAMILIES, source="K, M99 P in the main program", evidence=INFERRED,
    program="O1\nN10 G0 X1\nN20 G0 X2\nN30 M99 P20\n",
    max_blocks=5, runs="N10 (N20 N30)*2", stop="limit",
)
case(
    "GSK: M99 P of a main program may go forward to its end",
    control=FAMILIES, source="K, M99 P in the main program", evidence=INFERRED,
    program="O1\nN10 G0 X1\nN20 M99 P40\nN30 G0 X3\nN40 M30\n",
    max_cycles=5, runs="N10 N20 N40",
)
case(
    "GSK: M30 in a subprogram ends the run",
    pins="end_in_subprogram",
    control=FAMILIES, source="K, M30", evidence=INFERRED,
    program=one_call("M98 P2", "N30 M30\nN40 M99"),
    runs="N10 N30",
)
case(
    "GSK: M02 in a subprogram ends the run",
    control=FAMILIES, source="K, M02", evidence=INFERRED,
    program=one_call("M98 P2", "N30 M02\nN40 M99"),
    runs="N10 N30",
)
case(
    "GSK 988: a main program without an end is an alarm",
    pins="missing_end",
    control=FAMILY_988, source="Talm 019", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 G0 X2\n",
    runs="N10 N20", alarm="end-of-record", number="019",
)
case(
    "GSK 988: a program does not run on into the one after it",
    control=FAMILY_988, source="Talm 019", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nO2\nN20 M30\n",
    runs="N10", alarm="end-of-record", number="019",
)
case(
    "GSK 988: a percent sign reached is an alarm",
    control=FAMILY_988, source="Talm 019", evidence=SECONDARY,
    program="%\nO1\nN10 G0 X1\n%\n", main="O1",
    runs="N10", alarm="end-of-record", number="019",
)
case(
    "GSK 988: a subprogram without M99 is an alarm",
    control=FAMILY_988, source="Talm 019", evidence=SECONDARY,
    program=one_call("M98 P2", "N30 G0 X3"),
    runs="N10 N30", alarm="end-of-record", number="019",
)
case(
    "GSK 988TA: with 3404#6=1 a main program without an end simply ends",
    control=TA, source="TApar 3404; Talm 019", evidence=MANUAL, params={"3404#6": 1},
    program="O1\nN10 G0 X1\nN20 G0 X2\n",
    runs="N10 N20",
)

# --- M99 P where the number stands twice in the caller ------------------------------------------------

case(
    "GSK 988TA: of two return blocks before the call the later is taken",
    control=TA, source="source 000, note 2, 1)", evidence=SOURCE,
    program="""
        O1
        N7 #101=#101+1
        N7 #102=#102+1
        N8 IF[#102 GE 2]GOTO 20
        N10 M98 P2
        N20 M30
        O2
        N30 M99 P7
    """,
    variables={101: 0, 102: 0}, runs="N7 N7 N8 N10 N30 N7 N8 N20", vars={101: 1, 102: 2},
)
case(
    "GSK 988TA: of three return blocks before the call the last is taken",
    control=TA, source="source 000, note 2, 1)", evidence=INFERRED,
    program="""
        O1
        N7 #101=#101+1
        N7 #102=#102+1
        N7 #103=#103+1
        N8 IF[#103 GE 2]GOTO 20
        N10 M98 P2
        N20 M30
        O2
        N30 M99 P7
    """,
    variables={101: 0, 102: 0, 103: 0}, runs="N7 N7 N7 N8 N10 N30 N7 N8 N20",
    vars={101: 1, 102: 1, 103: 2},
)
case(
    "GSK 988TA: of two return blocks after the call the earlier is taken",
    control=TA, source="source 000, note 2, 2)", evidence=SOURCE,
    program="""
        O1
        N10 M98 P2
        N20 G0 X2
        N7 #101=1
        N7 #102=1
        N30 M30
        O2
        N40 M99 P7
    """,
    runs="N10 N40 N7 N7 N30", vars={101: 1, 102: 1},
)
case(
    "GSK 988TA: of three return blocks after the call the first is taken",
    control=TA, source="source 000, note 2, 2)", evidence=INFERRED,
    program="""
        O1
        N10 M98 P2
        N7 G0 X2
        N7 G0 X3
        N7 G0 X4
        N30 M30
        O2
        N40 M99 P7
    """,
    runs="N10 N40 N7 N7 N7 N30",
)
case(
    "GSK 988TA: of a return block before and one after the call the one after is taken",
    control=TA, source="source 000, note 2, 3)", evidence=SOURCE,
    program="""
        O1
        N7 #101=#101+1
        N10 M98 P2
        N20 G0 X2
        N7 #102=1
        N30 M30
        O2
        N40 M99 P7
    """,
    variables={101: 0}, runs="N7 N10 N40 N7 N30", vars={101: 1, 102: 1},
)
case(
    "GSK 988TA: of two return blocks before and one after the call the one after is taken",
    control=TA, source="source 000, note 2, 3)", evidence=INFERRED,
    program="""
        O1
        N7 G0 X1
        N7 G0 X2
        N10 M98 P2
        N7 #101=1
        N30 M30
        O2
        N40 M99 P7
    """,
    runs="N7 N7 N10 N40 N7 N30", vars={101: 1},
)
case(
    "GSK 988TA: of one return block before and two after the call the first after is taken",
    control=TA, source="source 000, note 2, 3)", evidence=INFERRED,
    program="""
        O1
        N7 G0 X1
        N10 M98 P2
        N20 G0 X2
        N7 #101=1
        N7 #102=1
        N30 M30
        O2
        N40 M99 P7
    """,
    runs="N7 N10 N40 N7 N7 N30", vars={101: 1, 102: 1},
)
case(
    "GSK 988TA: before and after is seen from the call that is being returned from",
    control=TA, source="source 000, note 2", evidence=SOURCE,
    program="""
        O1
        N10 M98 P2
        N7 #101=#101+1
        N20 IF[#101 GE 2]GOTO 50
        N30 M98 P2
        N7 #102=1
        N50 M30
        O2
        N60 M99 P7
    """,
    variables={101: 0}, runs="N10 N60 N7 N20 N30 N60 N7 N50", vars={101: 1, 102: 1},
)
case(
    "GSK 988TA: the rule for numbers that stand twice holds in a calling subprogram",
    control=TA, source="source 000, note 2, 3)", evidence=SOURCE,
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N7 G0 X1
        N30 M98 P3
        N40 G0 X2
        N7 M99
        O3
        N50 M99 P7
    """,
    runs="N10 N7 N30 N50 N7 N20",
)
