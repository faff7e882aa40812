"""GSK: M98, its P as digits and from a variable, its L, words in its block."""

from conformance import case

case(
    "P21006 runs O1006 twice on the 988TA (TA-001)",
    pins="whole_numbers refuses",
    control="gsk-988ta",
    source="TA28 p.7; source 000, P",
    evidence="maker's manual",
    program="""
        O1
        M98 P21006
        G0 X2
        M30
        O1006
        G1 X50
        M99
    """,
    moves_x=[50, 50, 2],
)

case(
    "P1006 runs O1006 once on the 988TA (TA-002)",
    control="gsk-988ta",
    source="source 000, P (1)",
    evidence="source document",
    program="""
        O1
        M98 P1006
        G0 X2
        M30
        O1006
        G1 X50
        M99
    """,
    moves_x=[50, 2],
)

case(
    "a count in P and an L in one block alarm (TA-004)",
    control="gsk-988ta",
    source="source 000, words L and Q (3)",
    evidence="source document",
    program="""
        O1
        G0 X1
        M98 P21006 L2
        M30
        O1006
        G1 X50
        M99
    """,
    moves_x=[1],
    alarm="repeat-given-twice",
    number="293",
    at="O1",
)

case(
    "P1006 L3 runs O1006 three times (TA-005)",
    control="gsk-988ta",
    source="source 000, words L and Q (2)",
    evidence="source document",
    program="""
        O1
        M98 P1006 L3
        M30
        O1006
        G1 X50
        M99
    """,
    moves_x=[50, 50, 50],
)

case(
    "P[#100] with 23.34 runs O0023 (TA-013)",
    control="gsk-988ta",
    source="source 000, P, form 2",
    evidence="source document",
    program="""
        O1
        #100=23.34
        M98 P[#100] L3
        M30
        O0023
        G1 X5
        M99
    """,
    moves_x=[5, 5, 5],
)

case(
    "P#100 with 21006.7 runs O1006 twice (TA-015)",
    pins="call_values",
    control="gsk-988ta",
    source="source 000, P (2)",
    evidence="source document",
    program="""
        O1
        #100=21006.7
        M98 P#100
        M30
        O1006
        G1 X50
        M99
    """,
    moves_x=[50, 50],
)

case(
    "P#100 with a value of nine digits alarms (TA-016)",
    pins="max_program_digits",
    control="gsk-988ta",
    source="source 000, P (2); the number 003: Talm 003 of the 988T",
    evidence="inferred",
    program="""
        O1
        #100=123456789
        G0 X1
        M98 P#100
        M30
    """,
    moves_x=[1],
    alarm="too-many-digits",
    number="003",
    at="O1",
)

case(
    "M98 to a program that is not there alarms on the 988TA (TA-017)",
    control="gsk-988ta",
    source="source 000, note 3; Talm 083 of the 988T",
    evidence="secondary",
    program="""
        O1
        G0 X1
        M98 P1006
        M30
    """,
    moves_x=[1],
    alarm="program-not-found",
    number="083",
    at="O1",
)

case(
    "M98 with neither P nor Q alarms (TA-018)",
    control="gsk-988ta",
    source="source 000, note 5; Talm 081 of the 988T",
    evidence="secondary",
    program="""
        O1
        G0 X1
        M98
        M30
    """,
    moves_x=[1],
    alarm="program-number-missing",
    number="081",
    at="O1",
)

case(
    "P12002 runs O2002 once (TD-001)",
    pins="whole_numbers program_word",
    control="gsk-980tdi",
    source="TDi15",
    evidence="maker's manual",
    program="""
        O1
        M98 P12002
        G0 X2
        M30
        O2002
        G0 X20
        M99
    """,
    moves_x=[20, 2],
)

case(
    "P20 runs O0020 (TD-003)",
    control="gsk-980tdi",
    source="TDi15",
    evidence="maker's manual",
    program="""
        O1
        M98 P20
        M30
        O0020
        G0 X20
        M99
    """,
    moves_x=[20],
)

case(
    "M98 to a program that is not there alarms on the 980TDi (TD-015)",
    control="gsk-980tdi",
    source="MDia 001 of the 980MDi",
    evidence="secondary",
    program="""
        O1
        G0 X1
        M98 P2002
        M30
    """,
    moves_x=[1],
    alarm="program-not-found",
    number="0001",
    at="O1",
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
NO_NUMBER = {TA: "081", T: "081", TDI: "0095", MDI: "0095"}


def one_call(call, sub="N30 M99", name="O2"):
    """Return a main program O1 of one call, and the program that it calls."""
    return f"O1\nN10 {call}\nN20 M30\n{name}\n{sub}\n"


def assigned_call(statement, call, sub="N30 M99", name="O2"):
    """Return the same programs, with an assignment before the call."""
    return f"O1\nN5 {statement}\nN10 {call}\nN20 M30\n{name}\n{sub}\n"


# --- P as digits: the last four are the program, those before them the count ---------------------

case(
    "GSK: M98 with a number of four digits calls that program once",
    control=FAMILIES, source="source 000, word P, format 1 (1); TDi15", evidence=SOURCE,
    program=one_call("M98 P1234", name="O1234"),
    runs="N10 N30 N20", calls="M98:O1234",
)
case(
    "GSK: leading zeros of the program number may be left out in the call",
    control=FAMILIES, source="source 000, word P; TDi15", evidence=SOURCE,
    program=one_call("M98 P2", name="O0002"),
    runs="N10 N30 N20", calls="M98:O0002",
)
case(
    "GSK: leading zeros of the program number may be left out in the program",
    control=FAMILIES, source="source 000, word P; TDi15", evidence=SOURCE,
    program=one_call("M98 P0002"),
    runs="N10 N30 N20", calls="M98:O2",
)
case(
    "GSK: with five digits the first is the count",
    control=FAMILIES, source="source 000, word P, format 1 (1); TDi15", evidence=SOURCE,
    program=one_call("M98 P30002"),
    runs="N10 N30*3 N20", calls="M98:O2",
)
case(
    "GSK: a count of one may be written",
    control=FAMILIES, source="source 000, word P, format 1 (1); TDi15", evidence=SOURCE,
    program=one_call("M98 P11002", name="O1002"),
    runs="N10 N30 N20", calls="M98:O1002",
)
case(
    "GSK: with six digits the first two are the count",
    control=FAMILIES, source="source 000, word P, format 1 (1); TDi15", evidence=SOURCE,
    program=one_call("M98 P100002"),
    runs="N10 N30*10 N20",
)
case(
    "GSK: with eight digits the first four are the count, leading zeros included",
    control=FAMILIES, source="source 000, word P, format 1 (1); TDi15", evidence=SOURCE,
    program=one_call("M98 P00120002"),
    runs="N10 N30*12 N20",
)
case(
    "GSK: the largest count in P is 9999",
    pins="max_program_digits max_repeats",
    control=FAMILIES, source="source 000, word P, format 1 (1); TDi15", evidence=SOURCE,
    program=one_call("M98 P99990002"),
    runs="N10 N30*9999 N20",
)
case(
    "GSK: the zeros between count and number belong to the number",
    control=FAMILIES, source="source 000, word P, format 1 (1); TDi15", evidence=SOURCE,
    program="""
        O1
        N10 M98 P20006
        N20 M30
        O2000
        N30 M99
        O6
        N40 M99
    """,
    runs="N10 N40*2 N20", calls="M98:O6",
)
case(
    "GSK: a number of four digits is never split into count and program",
    control=FAMILIES, source="source 000, word P, format 1 (1); TDi15", evidence=SOURCE,
    program="""
        O1
        N10 M98 P2006
        N20 M30
        O6
        N30 M99
        O2006
        N40 M99
    """,
    runs="N10 N40 N20",
)
case(
    "GSK 988: nine digits in P are refused",
    control=FAMILY_988, source="source 000, word P, format 1 (1); Talm 003", evidence=SOURCE,
    program=one_call("M98 P100000002"),
    runs="", alarm="too-many-digits", number="003", at="O1 N10",
)
case(
    "GSK 980: a count of 10000 in P is refused",
    pins="too_many_repeats",
    control=FAMILY_980, source="MDib 092", evidence=MANUAL,
    program=one_call("M98 P100002002", name="O2002"),
    runs="", alarm="repeat-count-digits", number="0092", at="O1 N10",
)
case(
    "GSK 980: program number 0 cannot be called",
    pins="refuses:program-number-zero",
    control=FAMILY_980, source="MDia 095", evidence=MANUAL,
    program=one_call("M98 P0000", name="O0000"),
    runs="", alarm="program-number-zero", number="0095", at="O1 N10",
)
case(
    "GSK 980: program number 0 cannot be called with a count either",
    control=FAMILY_980, source="MDia 095", evidence=MANUAL,
    program=one_call("M98 P20000", name="O0000"),
    runs="", alarm="program-number-zero", number="0095", at="O1 N10",
)
case(
    "GSK 988: a minus sign at P is refused",
    control=FAMILY_988, source="Talm 006", evidence=SECONDARY,
    program=one_call("M98 P-2"),
    runs="", alarm="illegal-minus-sign", number="006", at="O1 N10", word="P-2",
)
case(
    "GSK 988: a decimal point at P is refused",
    control=FAMILY_988, source="Talm 007", evidence=SECONDARY,
    program=one_call("M98 P2.5"),
    runs="", alarm="illegal-decimal-point", number="007", at="O1 N10", word="P2.5",
)
case(
    "GSK: M98 without P is refused",
    pins="omitted_program",
    control=FAMILIES, source="source 000, note 5; Talm 081; MDia 095", evidence=SOURCE,
    program=one_call("M98"),
    runs="", alarm="program-number-missing", number=NO_NUMBER, at="O1 N10",
)
case(
    "GSK: M98 without P is refused before the other words of its block",
    control=FAMILIES, source="source 000, note 5; Talm 081; MDia 095", evidence=INFERRED,
    program=one_call("G0 X5 M98"),
    runs="", alarm="program-number-missing", number=NO_NUMBER, at="O1 N10",
)
case(
    "GSK 988TA: L alone does not say which program",
    control=TA, source="source 000, note 5; Talm 081", evidence=SOURCE,
    program=one_call("M98 L3"),
    runs="", alarm="program-number-missing", number="081", at="O1 N10",
)
case(
    "GSK: a program that is not in the memory cannot be called",
    control=FAMILIES, source="source 000, note 3; Talm 083; MDia 001", evidence=SOURCE,
    program=one_call("M98 P3"),
    runs="", alarm="program-not-found", number=NOT_FOUND, at="O1 N10",
)
case(
    "GSK: the program that is missing is named by the last four digits",
    control=FAMILIES, source="source 000, note 3; Talm 083; MDia 001", evidence=SOURCE,
    program=one_call("M98 P20003", name="O2003"),
    runs="", alarm="program-not-found", number=NOT_FOUND, at="O1 N10", word="P20003",
)
case(
    "GSK: a missing program is found missing at the second call only",
    control=FAMILIES, source="source 000, note 3; Talm 083; MDia 001", evidence=SOURCE,
    program="""
        O1
        N10 M98 P2
        N20 M98 P3
        N30 M30
        O2
        N40 M99
    """,
    runs="N10 N40", alarm="program-not-found", number=NOT_FOUND, at="O1 N20", calls="M98:O2",
)
case(
    "GSK: a missing program inside a subprogram alarms there",
    control=FAMILIES, source="source 000, note 3; Talm 083; MDia 001", evidence=SOURCE,
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M98 P3
        N40 M99
    """,
    runs="N10", alarm="program-not-found", number=NOT_FOUND, at="O2 N30",
)
case(
    "GSK: a faulty call that is never reached raises nothing",
    pins="statements",
    control=FAMILIES, source="policy: a control reads a block when it reaches it", evidence=INFERRED,
    program="""
        O1
        N10 GOTO 30
        N20 M98
        N30 M30
    """,
    runs="N10 N30",
)

# --- Words in the block of the call ---------------------------------------------------------------

case(
    "GSK: the words of an M98 block are executed before the program is looked for",
    control=FAMILIES, source="source 000, M98, function", evidence=SOURCE,
    program=one_call("G0 X5 M98 P3"),
    runs="N10", alarm="program-not-found", number=NOT_FOUND, at="O1 N10",
)
case(
    "GSK: the M code of an M98 block is sent before the call",
    pins="m_codes_per_block extra_m_codes",
    control=FAMILIES, source="source 000, M98, function", evidence=SOURCE,
    program="""
        O1
        N10 M3 M98 P2
        N20 M30
        O2
        N30 M8
        N40 M98 P3
        N50 M99
    """,
    runs="N10 N30", m=[3, 8], alarm="program-not-found", number=NOT_FOUND, at="O2 N40",
)
case(
    "GSK: the words of a repeated M98 block are executed once",
    control=FAMILIES, source="source 000, M98, function", evidence=SOURCE,
    program="""
        O1
        N10 M3 M98 P30002
        N20 M98 P3
        N25 M30
        O2
        N30 M99
    """,
    runs="N10 N30*3", m=[3], alarm="program-not-found", number=NOT_FOUND, at="O1 N20",
)
case(
    "GSK: after the call the next block follows",
    control=FAMILIES, source="source 000, M98, function", evidence=SOURCE,
    program="""
        O1
        N10 G0 X1
        N20 G0 X2 M98 P2
        N30 G0 X3
        N40 M30
        O2
        N50 G0 X4
        N60 M99
    """,
    runs="N10 N20 N50 N60 N30 N40",
)
case(
    "GSK: a call in a block that is skipped is not made",
    control=FAMILIES, source="K, block skip", evidence=INFERRED,
    program="O1\n/N10 M98 P2\nN20 M30\nO2\nN30 M99\n",
    skip=(1,), runs="N20", calls="",
)
case(
    "GSK: a call with a slash is made while block skip is off",
    control=FAMILIES, source="K, block skip", evidence=INFERRED,
    program="O1\n/N10 M98 P2\nN20 M30\nO2\nN30 M99\n",
    runs="N10 N30 N20",
)
case(
    "GSK 980MDi: G04 may not stand in the block of M98",
    pins="codes_not_with_call", control=MDI, source="MDib 051", evidence=MANUAL,
    program=one_call("G04 X1 M98 P2"),
    runs="", alarm="illegal-word-with-call", number="0051", at="O1 N10",
)
case(
    "GSK 980MDi: G54 may not stand in the block of M98",
    pins="codes_not_with_call", control=MDI, source="MDib 051", evidence=MANUAL,
    program=one_call("G54 M98 P2"),
    runs="", alarm="illegal-word-with-call", number="0051", at="O1 N10",
)

# --- P from a variable ----------------------------------------------------------------------------

case(
    "GSK 988TA: P#100 drops the decimals of its variable",
    control=TA, source="source 000, word P, format 1 (2)", evidence=SOURCE,
    program=assigned_call("#100=2.99", "M98 P#100"),
    runs="N5 N10 N30 N20", calls="M98:O2",
)
case(
    "GSK 988TA: P#100 with more than four digits holds a count too",
    control=TA, source="source 000, word P, format 1 (2)", evidence=SOURCE,
    program=assigned_call("#100=40002.5", "M98 P#100"),
    runs="N5 N10 N30*4 N20",
)
case(
    "GSK 988TA: P#100 takes eight digits",
    pins="max_program_number",
    control=TA, source="source 000, word P, format 1 (2)", evidence=SOURCE,
    program=assigned_call("#100=99999999", "M98 P#100", name="O9999"),
    runs="N5 N10 N30*9999 N20",
)
case(
    "GSK 988TA: P#100 of nine digits is refused",
    control=TA, source="source 000, word P, format 1 (2); number from Talm 003", evidence=SOURCE,
    program=assigned_call("#100=100000000", "M98 P#100"),
    runs="N5", alarm="too-many-digits", number="003", at="O1 N10", vars={100: 100000000},
)
case(
    "GSK 988TA: P#100 of four digits goes with L",
    control=TA, source="source 000, words L and Q (2)", evidence=SOURCE,
    program=assigned_call("#100=2", "M98 P#100 L3"),
    runs="N5 N10 N30*3 N20",
)
case(
    "GSK 988TA: a count that comes from the variable of P excludes L as well",
    control=TA, source="source 000, words L and Q (3)", evidence=SOURCE,
    program=assigned_call("#100=20002", "M98 P#100 L3"),
    runs="N5", alarm="repeat-given-twice", number="293", at="O1 N10",
)
case(
    "GSK 988TA: P#100 that names a missing program alarms at the call",
    control=TA, source="source 000, note 3; Talm 083", evidence=SOURCE,
    program=assigned_call("#100=3", "M98 P#100"),
    runs="N5", alarm="program-not-found", number="083", at="O1 N10",
)
case(
    "GSK 988TA: P[#100] drops the decimals of its variable",
    control=TA, source="source 000, word P, format 2 (1)", evidence=SOURCE,
    program=assigned_call("#100=45.67", "M98 P[#100] L2", name="O0045"),
    runs="N5 N10 N30*2 N20", calls="M98:O0045",
)
case(
    "GSK 988TA: P[#100] takes 9999.9",
    control=TA, source="source 000, word P, format 2 (1)", evidence=SOURCE,
    program=assigned_call("#100=9999.9", "M98 P[#100]", name="O9999"),
    runs="N5 N10 N30 N20",
)
case(
    "GSK 988TA: P[#100] refuses 10000",
    control=TA, source="source 000, word P, format 2 (1)", evidence=SOURCE,
    program=assigned_call("#100=10000", "M98 P[#100]"),
    runs="N5", alarm="illegal-program-number", number="291", at="O1 N10",
)
case(
    "GSK 988TA: P[#100] never holds a count",
    control=TA, source="source 000, word P, format 2 (1)", evidence=SOURCE,
    program=assigned_call("#100=30002", "M98 P[#100]"),
    runs="N5", alarm="illegal-program-number", number="291", at="O1 N10", word="P[#100]",
)
case(
    "GSK 988TA: P[#100] too long is refused with L as well",
    control=TA, source="source 000, word P, format 2 (1)", evidence=SOURCE,
    program=assigned_call("#100=23456", "M98 P[#100] L3"),
    runs="N5", alarm="illegal-program-number", number="291", at="O1 N10",
)
case(
    "GSK 988TA: P[#100] names a standard program, which may be missing",
    control=TA, source="source 000, note 3; Talm 083", evidence=SOURCE,
    program=assigned_call("#100=7.5", "M98 P[#100]"),
    runs="N5", alarm="program-not-found", number="083", at="O1 N10",
)
case(
    "GSK 988TA: the variable of P[#100] is read anew at each call",
    pins="if_form max_condition_length",
    control=TA, source="source 000, word P, format 2 (1)", evidence=SOURCE,
    program="""
        O1
        N10 #100=2
        N20 M98 P[#100]
        N30 #100=#100+1
        N40 IF[#100 LE 3]GOTO 20
        N50 M30
        O2
        N60 M99
        O3
        N70 M99
    """,
    runs="N10 N20 N60 N30 N40 N20 N70 N30 N40 N50", calls="M98:O2 M98:O3",
)

# --- L ---------------------------------------------------------------------------------------------

case(
    "GSK 988: L says how often",
    control=FAMILY_988, source="source 000, words L and Q (2)", evidence=SOURCE,
    program=one_call("M98 P2 L4"),
    runs="N10 N30*4 N20", calls="M98:O2",
)
case(
    "GSK 988: L may stand in front of P",
    control=FAMILY_988, source="source 000, words L and Q (2)", evidence=INFERRED,
    program=one_call("M98 L2 P2"),
    runs="N10 N30*2 N20",
)
case(
    "GSK 988: L1 is one call",
    control=FAMILY_988, source="source 000, words L and Q (2)", evidence=SOURCE,
    program=one_call("M98 P2 L1"),
    runs="N10 N30 N20",
)
case(
    "GSK 988: a number of four digits with leading zeros goes with L",
    control=FAMILY_988, source="source 000, words L and Q (3)", evidence=SOURCE,
    program=one_call("M98 P0002 L3"),
    runs="N10 N30*3 N20",
)
case(
    "GSK 988TA: L of a variable drops the decimals",
    control=TA, source="source 000, word P, format 2 (2)", evidence=SOURCE,
    program=assigned_call("#101=2.9", "M98 P[O0002] L#101"),
    runs="N5 N10 N30*2 N20",
)
case(
    "GSK 988TA: L9999 is the most",
    control=TA, source="source 000, words L and Q (2)", evidence=INFERRED,
    program=one_call("M98 P2 L9999"),
    runs="N10 N30*9999 N20",
)
case(
    "GSK 988TA: an L above 9999 is held at 9999",
    pins="too_many_repeats",
    control=TA, source="source 000, M198 (3), taken for M98", evidence=INFERRED,
    program=one_call("M98 P2 L10000"),
    runs="N10 N30*9999 N20",
)
case(
    "GSK 988TA: an L far above 9999 is held at 9999",
    control=TA, source="source 000, M198 (3), taken for M98", evidence=INFERRED,
    program=one_call("M98 P[O0002] L123456"),
    runs="N10 N30*9999 N20",
)
case(
    "GSK 988TA: L0 is refused",
    pins="zero_repeats",
    control=TA, source="source 000, words L and Q (2); number from Talm 003", evidence=INFERRED,
    program=one_call("M98 P2 L0"),
    runs="", alarm="illegal-repeat-count", number="003", at="O1 N10", word="L0",
)
case(
    "GSK 988TA: L-1 is refused",
    control=TA, source="source 000, words L and Q (2); number from Talm 003", evidence=INFERRED,
    program=one_call("M98 P2 L-1"),
    runs="", alarm="illegal-repeat-count", number="003", at="O1 N10", word="L-1",
)
case(
    "GSK 988TA: an L variable below zero is refused",
    control=TA, source="source 000, words L and Q (2); number from Talm 003", evidence=INFERRED,
    program=assigned_call("#101=-3", "M98 P2 L#101"),
    runs="N5", alarm="illegal-repeat-count", number="003", at="O1 N10",
)
case(
    "GSK 988TA: an L variable of 0.9 is zero calls and refused",
    control=TA, source="source 000, words L and Q (2); number from Talm 003", evidence=INFERRED,
    program=assigned_call("#101=0.9", "M98 P2 L#101"),
    runs="N5", alarm="illegal-repeat-count", number="003", at="O1 N10",
)
case(
    "GSK 988TA: a count in P excludes L",
    control=TA, source="source 000, words L and Q (3)", evidence=SOURCE,
    program=one_call("M98 P50002 L2"),
    runs="", alarm="repeat-given-twice", number="293", at="O1 N10",
)
case(
    "GSK 988TA: a count of one in P excludes L",
    control=TA, source="source 000, words L and Q (3)", evidence=SOURCE,
    program=one_call("M98 P10002 L1"),
    runs="", alarm="repeat-given-twice", number="293", at="O1 N10",
)
case(
    "GSK 988TA: a count of one written with eight digits excludes L",
    control=TA, source="source 000, words L and Q (3)", evidence=INFERRED,
    program=one_call("M98 P00010023 L3", name="O23"),
    runs="", alarm="repeat-given-twice", number="293", at="O1 N10",
)
case(
    "GSK 988TA: a count in P excludes L in front of it",
    control=TA, source="source 000, words L and Q (3)", evidence=SOURCE,
    program=one_call("M98 L2 P30002"),
    runs="", alarm="repeat-given-twice", number="293", at="O1 N10",
)
case(
    "GSK 988TA: a count in P excludes L beside Q",
    control=TA, source="source 000, words L and Q (3)", evidence=SOURCE,
    program=one_call("M98 P30002 Q30 L2"),
    runs="", alarm="repeat-given-twice", number="293", at="O1 N10",
)
case(
    "GSK 988TA: the doubled count is refused before the words of its block",
    control=TA, source="source 000, words L and Q (3)", evidence=INFERRED,
    program=one_call("G0 X5 M98 P30002 L2"),
    runs="", alarm="repeat-given-twice", number="293", at="O1 N10",
)
case(
    "GSK 988TA: the doubled count is refused before the program is looked for",
    control=TA, source="source 000, words L and Q (3)", evidence=INFERRED,
    program=one_call("M98 P30009 L2"),
    runs="", alarm="repeat-given-twice", number="293", at="O1 N10",
)
case(
    "GSK 988: G70 may not stand in the block of M98",
    pins="codes_not_with_call", control=FAMILY_988, source="Talm 132", evidence=SECONDARY,
    program=one_call("G70 P20 Q30 M98 P2"),
    runs="", alarm="illegal-word-with-call", number="132", at="O1 N10",
)
case(
    "GSK 988: G71 may not stand in the block of M98",
    pins="codes_not_with_call", control=FAMILY_988, source="Talm 132", evidence=SECONDARY,
    program=one_call("G71 U1. R1. M98 P2"),
    runs="", alarm="illegal-word-with-call", number="132", at="O1 N10",
)
case(
    "GSK 988: G72 may not stand in the block of M98",
    pins="codes_not_with_call", control=FAMILY_988, source="Talm 132", evidence=SECONDARY,
    program=one_call("M98 P2 G72 W1. R1."),
    runs="", alarm="illegal-word-with-call", number="132", at="O1 N10",
)
case(
    "GSK 988: G73 may not stand in the block of M98",
    pins="codes_not_with_call", control=FAMILY_988, source="Talm 132", evidence=SECONDARY,
    program=one_call("M98 P2 G73 U1. R2"),
    runs="", alarm="illegal-word-with-call", number="132", at="O1 N10",
)
case(
    "GSK 988: G74 may stand in the block of M98",
    control=FAMILY_988, source="Talm 132", evidence=INFERRED,
    program=one_call("M98 P2 G74 R1."), runs="N10 N30 N20",
)
