"""GSK: subprogram calls and returns (988TA, 988T, 980TDi, 980MDi, 928TE).

Source tags: source 000 is the 988TA chapter on subprogram calls, source 001 the 928 section on
M98 and M99; TA28 and TA27 are the maker's 988TA sections with their figures; Talm is the 988T alarm
list (its numbers are taken for the 988TA too, no list of its own was found); TDi15, TDi17 and TDi28
are 980TDi sections; MDia and MDib are the two 980MDi alarm lists (taken for the 980TDi too);
K is general knowledge.
"""

from conformance import case

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
NO_RETURN_BLOCK = {TA: "083", T: "083", TDI: "0112", MDI: "0112"}


def one_call(call, sub="N30 M99", name="O2"):
    """A main program O1 of one call, and one called program."""
    return f"O1\nN10 {call}\nN20 M30\n{name}\n{sub}\n"


def assigned_call(statement, call, sub="N30 M99", name="O2"):
    """The same with an assignment in front of the call."""
    return f"O1\nN5 {statement}\nN10 {call}\nN20 M30\n{name}\n{sub}\n"


def chain(calls):
    """O1 calls O2, O2 calls O3 and so on: calls[k] is the text of the call in O<k+1>."""
    programs = [
        f"O{level}\nN{level}0 {call.format(level + 1)}\nN{level}1 {'M30' if level == 1 else 'M99'}\n"
        for level, call in enumerate(calls, 1)
    ]
    last = len(calls) + 1
    return "".join(programs) + f"O{last}\nN{last}0 M99\n"


def chain_down(levels):
    """The blocks of a chain on the way down: the calls of O1 to O<levels>."""
    return " ".join(f"N{level}0" for level in range(1, levels + 1))


def chain_through(levels):
    """All the blocks of a chain of so many calls."""
    up = " ".join(f"N{level}1" for level in range(levels, 0, -1))
    return f"{chain_down(levels + 1)} {up}"


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
    pins="zero_numbers",
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
    pins="jumps",
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
    pins="m_codes_per_block m_codes_alone",
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
    "GSK: behind the call the next block follows",
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
for code in ("G04 X1", "G54"):
    case(
        f"GSK 980MDi: {code[:3]} may not stand in the block of M98",
        pins="codes_not_with_call",
        control=MDI, source="MDib 051", evidence=MANUAL,
        program=one_call(f"{code} M98 P2"),
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

# --- Q and the call of the current program ---------------------------------------------------------

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
    "GSK 988TA: the part that a program calls of itself stands behind its M30",
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

# --- Names -----------------------------------------------------------------------------------------

case(
    "GSK 988TA: a name of O and four digits in brackets is the standard program",
    control=TA, source="source 000, word P, format 2", evidence=SOURCE,
    program=one_call("M98 P[O0045] L3", name="O45"),
    runs="N10 N30*3 N20", calls="M98:O45",
)
for name in ("T0045", "A+B", "A-B", "A_B", "A.B", "SIDE-2.V1"):
    case(
        f"GSK 988TA: {name} is a program name",
        pins="name_marks",
        control=TA, source="source 000, word P, format 2 (1); TA27", evidence=SOURCE,
        files={"O1.CNC": f"O1\nN10 M98 P[{name}] L2\nN20 M30\n", f"{name}.CNC": "N30 M99\n"},
        main="O1", runs="N10 N30*2 N20", calls=f"M98:{name}",
    )
for name in ("A=B", "A/B", "A,B", "A:B"):
    case(
        f"GSK 988TA: {name} is no program name",
        control=TA, source="source 000, word P, format 2 (1)", evidence=SOURCE,
        program=one_call(f"M98 P[{name}]"),
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
for name in ("CUT", "CUT-1", "A+B", "O.012", TWENTY):
    case(
        f"GSK 980TDi: with 878=1 a program may be named {name}",
        pins="name_marks max_name_length",
        control=TDI, source="TDi15", evidence=MANUAL, params={"878": 1},
        files={"O1.CNC": f"O1\nN10 M98 P[{name}]\nN20 M30\n", f"{name}.CNC": "N30 M99\n"},
        main="O1", runs="N10 N30 N20", calls=f"M98:{name}",
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
for count in (0, 10000):
    case(
        f"GSK 980TDi: L{count} is refused",
        control=TDI, source="TDi15; number from MDib 092", evidence=MANUAL, params={"878": 1},
        files={"O1.CNC": f"O1\nN10 M98 P[CUT] L{count}\nN20 M30\n", "CUT.CNC": "N30 M99\n"},
        main="O1", runs="", alarm="repeat-count-digits" if count > 9999 else "illegal-repeat-count", number="0092", at="O1 N10",
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

# --- M198: programs of the external device ----------------------------------------------------------


def device_call(claim, call, **row):
    """O1 calls O2 of the device; row says what becomes of it."""
    memory = f"O1\nN10 {call}\nN20 M30\n"
    device = {"O2.CNC": "O2\nN40 G0 X4\nN50 G0 X5\nN60 M99\n", "T2.CNC": "N70 M99\n"}
    row = {"source": "source 000, M198", "evidence": SOURCE, **row}
    case(claim, pins="external_calls", control=TA, program=memory, external=device, **row)


device_call(
    "GSK 988TA: M198 calls a program of the external device",
    "M198 P2", runs="N10 N40 N50 N60 N20", calls="M198:O2",
)
device_call(
    "GSK 988TA: M198 reads a count in P as M98 does",
    "M198 P20002", runs="N10 (N40 N50 N60)*2 N20", calls="M198:O2",
)
device_call(
    "GSK 988TA: M198 repeats L times",
    "M198 P2 L3", runs="N10 (N40 N50 N60)*3 N20",
)
device_call(
    "GSK 988TA: M198 starts at Q, every time",
    "M198 P2 Q60 L2", runs="N10 N60*2 N20",
)
device_call(
    "GSK 988TA: M198 calls a program by its name",
    "M198 P[T2] L2", runs="N10 N70*2 N20", calls="M198:T2",
)
device_call(
    "GSK 988TA: an L of M198 above 9999 is held at 9999",
    "M198 P[T2] L20000", runs="N10 N70*9999 N20",
)
device_call(
    "GSK 988TA: an L of M198 below zero is refused",
    "M198 P2 L-2", runs="", alarm="illegal-repeat-count", number="003", at="O1 N10",
    source="source 000, M198 (3); number from Talm 003",
)
device_call(
    "GSK 988TA: a count in the P of M198 excludes L",
    "M198 P20002 L2", runs="", alarm="repeat-given-twice", number="293", at="O1 N10",
)
device_call(
    "GSK 988TA: a character that no name has is refused in M198",
    "M198 P[T=2]", runs="", alarm="illegal-program-name", at="O1 N10",
)
device_call(
    "GSK 988TA: M198 without P and Q is refused",
    "M198", runs="", alarm="program-number-missing", number="081", at="O1 N10", evidence=INFERRED,
    source="source 000, note 5; Talm 081",
)
device_call(
    "GSK 988TA: M198 does not find what the device does not have",
    "M198 P3", runs="", alarm="external-program-not-found", number="083", at="O1 N10",
    source="source 000, note 3; Talm 083",
)
device_call(
    "GSK 988TA: the words of an M198 block are executed before the device is read",
    "G0 X1 M198 P3", runs="N10", alarm="external-program-not-found", number="083", at="O1 N10",
    source="source 000, M198, function",
)
device_call(
    "GSK 988TA: M98 does not read the device",
    "M98 P2", runs="", alarm="program-not-found", number="083", at="O1 N10",
    source="source 000, M98 and M198",
)
device_call(
    "GSK 988TA: the Q of M198 must be a block of the device's program",
    "M198 P2 Q20", runs="", alarm="start-not-found", number="083", at="O1 N10", evidence=INFERRED,
)
case(
    "GSK 988TA: M198 takes the number from a variable",
    control=TA, source="source 000, M198 (2)", evidence=SOURCE,
    program="O1\nN10 #100=2.7\nN20 M198 P[#100] L2\nN30 M30\n", external={"O2.CNC": "N40 M99\n"},
    runs="N10 N20 N40*2 N30",
)
case(
    "GSK 988TA: M198 P[#100] of five digits is refused like M98's",
    control=TA, source="source 000, M198 as M98; word P, format 2", evidence=SOURCE,
    program="O1\nN10 #100=10002\nN20 M198 P[#100]\nN30 M30\n", external={"O2.CNC": "N40 M99\n"},
    runs="N10", alarm="illegal-program-number", number="291", at="O1 N20",
)
case(
    "GSK 988TA: M198 does not read the memory",
    control=TA, source="source 000, M198", evidence=SOURCE,
    program=one_call("M198 P2"), external={"O3.CNC": "N40 M99\n"},
    runs="", alarm="external-program-not-found", number="083", at="O1 N10",
)
case(
    "GSK 988TA: of two programs of one name M98 takes the memory's and M198 the device's",
    control=TA, source="source 000, M98 and M198", evidence=SOURCE,
    program="O1\nN10 M198 P2\nN20 M98 P2\nN30 M30\nO2\nN40 M99\n", external={"O2.CNC": "N50 M99\n"},
    runs="N10 N50 N20 N40 N30", calls="M198:O2 M98:O2",
)
case(
    "GSK 988TA: M99 P of a program of the device names a block of the caller",
    control=TA, source="source 000, M99", evidence=SOURCE,
    program="O1\nN10 M198 P2\nN20 G0 X2\nN30 M30\n", external={"O2.CNC": "N40 M99 P30\n"},
    runs="N10 N40 N30",
)
case(
    "GSK 988TA: a program of the device may call one of the memory",
    control=TA, source="source 000, M98 and M198", evidence=INFERRED,
    program="O1\nN10 M198 P2\nN20 M30\nO3\nN30 M99\n",
    external={"O2.CNC": "N40 M98 P3\nN50 M99\n"},
    runs="N10 N40 N30 N50 N20", calls="M198:O2 M98:O3",
)

# --- M99 -------------------------------------------------------------------------------------------

case(
    "GSK: M99 returns to the block behind the call",
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
for code in ("G28 U0", "G30 U0", "G53 X0", "G36 X50", "G37 Z50"):
    case(
        f"GSK 988: {code[:3]} may not stand in the block of M99",
        pins="codes_not_with_return",
        control=FAMILY_988, source="Talm 030", evidence=SECONDARY,
        program=one_call("M98 P2", f"N30 {code} M99"),
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
    "GSK 988: a program does not run on into the one behind it",
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
    "GSK 988TA: of two return blocks behind the call the earlier is taken",
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
    "GSK 988TA: of three return blocks behind the call the first is taken",
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
    "GSK 988TA: of a return block before and one behind the call the one behind is taken",
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
    "GSK 988TA: of two return blocks before and one behind the call the one behind is taken",
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
    "GSK 988TA: of one return block before and two behind the call the first behind is taken",
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
    "GSK 988TA: before and behind is seen from the call that is being returned from",
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

# --- Nesting ---------------------------------------------------------------------------------------

M98, G65 = "M98 P{}", "G65 P{}"

case(
    "GSK 988: twelve levels of subprograms are legal",
    pins="max_nesting",
    control=FAMILY_988, source="source 000, nesting; Talm 082", evidence=SOURCE,
    program=chain([M98] * 12), runs=chain_through(12), calls=" ".join(f"M98:O{k}" for k in range(2, 14)),
)
case(
    "GSK 988: the thirteenth level of subprograms is an alarm",
    control=FAMILY_988, source="source 000, nesting; Talm 082", evidence=SOURCE,
    program=chain([M98] * 13), runs=chain_down(12), alarm="nesting-too-deep", number="082",
    at="O13 N130",
)
case(
    "GSK 988: eight subprograms and four macros are twelve levels",
    pins="max_macro_nesting macro_calls",
    control=FAMILY_988, source="source 000, nesting, macros included", evidence=SOURCE,
    program=chain([M98] * 8 + [G65] * 4), runs=chain_through(12),
)
case(
    "GSK 988: a subprogram as thirteenth level above macros is an alarm",
    pins="nesting_counts_macros",
    control=FAMILY_988, source="source 000, nesting, macros included; Talm 082", evidence=SOURCE,
    program=chain([G65] * 4 + [M98] * 9), runs=chain_down(12), alarm="nesting-too-deep",
    number="082", at="O13 N130",
)
case(
    "GSK 988: a macro as thirteenth level above subprograms is an alarm",
    control=FAMILY_988, source="source 000, nesting, macros included; Talm 082", evidence=SOURCE,
    program=chain([M98] * 12 + [G65]), runs=chain_down(12), alarm="nesting-too-deep",
    number="082", at="O13 N130",
)
case(
    "GSK 988TA: a program of the device counts as a level",
    control=TA, source="source 000, nesting and M198", evidence=INFERRED,
    program=chain([M98] * 12 + ["M198 P{}"]), external={"O14.CNC": "N140 M99\n"},
    runs=chain_down(12), alarm="nesting-too-deep", number="082", at="O13 N130",
)
case(
    "GSK 988: the words of a call one level too deep are executed before its alarm",
    control=FAMILY_988, source="source 000, nesting; Talm 082", evidence=SOURCE,
    program=chain([M98] * 12 + ["G0 X1 M98 P{}"]),
    runs=chain_down(13), alarm="nesting-too-deep", number="082", at="O13 N130",
)
case(
    "GSK 980: four levels of subprograms are legal",
    pins="max_nesting",
    control=FAMILY_980, source="MDia 096", evidence=MANUAL,
    program=chain([M98] * 4), runs=chain_through(4), calls="M98:O2 M98:O3 M98:O4 M98:O5",
)
case(
    "GSK 980: the fifth level of subprograms is an alarm",
    control=FAMILY_980, source="MDia 096", evidence=MANUAL,
    program=chain([M98] * 5), runs=chain_down(4), alarm="nesting-too-deep", number="0096",
    at="O5 N50",
)
case(
    "GSK: calls one behind the other do not add up",
    control=FAMILIES, source="source 000, nesting; MDia 096", evidence=SOURCE,
    program="O1\n" + "N10 M98 P2\n" * 14 + "N20 M30\nO2\nN30 M99\n",
    runs="(N10 N30)*14 N20",
)
case(
    "GSK: repetitions do not add up",
    control=FAMILIES, source="source 000, nesting; MDia 096", evidence=SOURCE,
    program=one_call("M98 P200002"),
    runs="N10 N30*20 N20",
)
case(
    "GSK: a return frees its level",
    control=FAMILIES, source="source 000, nesting; MDia 096", evidence=SOURCE,
    program="""
        O1
        N10 M98 P2
        N11 M30
        O2
        N20 M98 P3
        N21 M98 P3
        N22 M99
        O3
        N30 M98 P4
        N31 M98 P4
        N32 M99
        O4
        N40 M98 P5
        N41 M99
        O5
        N50 M99
    """,
    runs="N10 N20 N30 N40 N50 N41 N31 N40 N50 N41 N32 N21 N30 N40 N50 N41 N31 N40 N50 N41 N32 N22 N11",
)
case(
    "GSK: each pass of a repeated program makes its own calls",
    control=FAMILIES, source="source 000, M98", evidence=SOURCE,
    program="""
        O1
        N10 M98 P20002
        N20 M30
        O2
        N30 M98 P30003
        N40 M99
        O3
        N50 M99
    """,
    runs="N10 (N30 N50*3 N40)*2 N20", calls="M98:O2 M98:O3 M98:O3",
)

# --- Calls in MDI ------------------------------------------------------------------------------------

case(
    "GSK 988TA: MDI may call one level",
    control=TA, source="source 000, note 4", evidence=INFERRED,
    program="O2\nN20 G0 X1\nN30 M99\n", mdi="N5 M98 P2", runs="N5 N20 N30", calls="M98:O2",
)
case(
    "GSK 988TA: MDI may repeat its call",
    control=TA, source="source 000, note 4", evidence=INFERRED,
    program="O2\nN20 M99\n", mdi="N5 M98 P30002", runs="N5 N20*3",
)
case(
    "GSK 988TA: MDI may call one macro",
    control=TA, source="TA27, note 5", evidence=INFERRED,
    program="O2\nN20 #100=#1\nN30 M99\n", mdi="N5 G65 P2 A4", runs="N5 N20 N30", vars={100: 4},
)
case(
    "GSK 988TA: a program called in MDI may not call another",
    control=TA, source="source 000, note 4; number from Talm 085", evidence=SOURCE,
    program="O2\nN20 M98 P3\nN30 M99\nO3\nN40 M99\n", mdi="N5 M98 P2",
    runs="N5", alarm="call-in-mdi", number="085", at="O2 N20",
)
case(
    "GSK 988TA: a program called in MDI may not call a macro",
    control=TA, source="source 000, note 4; TA27, note 5; number from Talm 085", evidence=SOURCE,
    program="O2\nN20 G65 P3\nN30 M99\nO3\nN40 M99\n", mdi="N5 M98 P2",
    runs="N5", alarm="call-in-mdi", number="085", at="O2 N20",
)
case(
    "GSK 988TA: a macro called in MDI may not call another",
    control=TA, source="TA27, note 5; number from Talm 085", evidence=MANUAL,
    program="O2\nN20 G65 P3\nN30 M99\nO3\nN40 M99\n", mdi="N5 G65 P2",
    runs="N5", alarm="call-in-mdi", number="085", at="O2 N20",
)
case(
    "GSK 988TA: a program called in MDI may not call itself by Q",
    control=TA, source="source 000, note 4; number from Talm 085", evidence=INFERRED,
    program="O2\nN20 M98 Q40\nN30 M99\nN40 M99\n", mdi="N5 M98 P2",
    runs="N5", alarm="call-in-mdi", number="085", at="O2 N20",
)
case(
    "GSK 988TA: a program missing in MDI is an alarm",
    control=TA, source="source 000, note 3; Talm 083", evidence=SOURCE,
    program="O2\nN20 M99\n", mdi="N5 M98 P3",
    runs="", alarm="program-not-found", number="083",
)
for code in ("M98", "G65"):
    case(
        f"GSK 988T: MDI refuses {code}",
        control=T, source="Talm 085", evidence=SECONDARY,
        program="O2\nN20 M99\n", mdi=f"N5 {code} P2",
        runs="", alarm="call-in-mdi", number="085", calls="",
    )
case(
    "GSK 988T: MDI refuses a call behind other blocks, and keeps what they did",
    control=T, source="Talm 085", evidence=SECONDARY,
    program="O2\nN20 M99\n", mdi="N5 M3\nN6 M98 P2",
    runs="N5", m=[3], alarm="call-in-mdi", number="085",
)
case(
    "GSK 980: MDI refuses M98",
    pins="mdi_calls",
    control=FAMILY_980, source="K, M98 is not valid in MDI", evidence=INFERRED,
    program="O2\nN20 M99\n", mdi="N5 M98 P2",
    runs="", alarm="call-in-mdi", calls="",
)

# --- 980: what a program may not call -----------------------------------------------------------------

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

# --- 980: M codes that call a subprogram ----------------------------------------------------------------

M_CODES = {"89": 17, "90": 1, "91": 3}

for k, code in enumerate((17, 18, 19), 1):
    case(
        f"GSK 980TDi: M{code} is number {k} of the M codes that call",
        control=TDI, source="TDi17", evidence=MANUAL, params=M_CODES,
        program=f"O100\nN10 M{code}\nN20 M30\nO{k}\nN30 M99\n",
        runs="N10 N30 N20", calls=f"M-code:O{k}",
    )
case(
    "GSK 980TDi: an M code behind those that call is sent to the machine",
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

# --- Reading a block --------------------------------------------------------------------------------

case(
    "GSK 980MDi: the N word must be the first of its block",
    control=MDI, source="MDia 006", evidence=MANUAL,
    program="O1\nN10 G0 X1\nG0 N20 X2\nN30 M30\n",
    runs="N10", alarm="sequence-number-not-first", number="0006", at="O1",
)
case(
    "GSK 980MDi: the same address twice in a block is refused",
    control=MDI, source="MDia 010", evidence=MANUAL,
    program="O1\nN10 G0 X1\nN20 G0 X2 X3\nN30 M30\n",
    runs="N10", alarm="address-given-twice", number="0010", at="O1 N20",
)
case(
    "GSK 988: with 3403#6=1 the same address twice in a block is refused",
    control=FAMILY_988, source="Talm 010; TApar 3403", evidence=SECONDARY, params={"3403#6": 1},
    program="O1\nN10 G0 X1\nN20 G0 X2 X3\nN30 M30\n",
    runs="N10", alarm="address-given-twice", number="010", at="O1 N20",
)
case(
    "GSK 988: with 3403#6=0 the same address twice in a block is taken",
    control=FAMILY_988, source="Talm 010; TApar 3403", evidence=SECONDARY, params={"3403#6": 0},
    program="O1\nN10 G0 X1\nN20 G0 X2 X3\nN30 M30\n",
    runs="N10 N20 N30",
)
case(
    "GSK 988: with 3403#6=0 the last P of M98 counts",
    control=FAMILY_988, source="TApar 3403", evidence=INFERRED, params={"3403#6": 0},
    program="O1\nN10 M98 P3 P2\nN20 M30\nO2\nN30 M99\nO3\nN40 M99\n",
    runs="N10 N30 N20", calls="M98:O2",
)
case(
    "GSK 988: with 3403#6=1 a second P of M98 is refused",
    control=FAMILY_988, source="Talm 010; TApar 3403", evidence=INFERRED, params={"3403#6": 1},
    program="O1\nN10 M98 P3 P2\nN20 M30\nO2\nN30 M99\nO3\nN40 M99\n",
    runs="", alarm="address-given-twice", number="010", at="O1 N10",
)
case(
    "GSK 980MDi: a comment that is not closed is refused",
    control=MDI, source="MDia 041", evidence=MANUAL,
    program="O1\nN10 G0 X1\nN20 G0 X2 (SLOT\nN30 M30\n",
    runs="N10", alarm="comment-not-closed", number="0041", at="O1 N20",
)
case(
    "GSK: a call inside a comment is not made",
    control=FAMILIES, source="K, comments", evidence=INFERRED,
    program="O1\nN10 G0 X1 (M98 P2)\nN20 M30\nO2\nN30 M99\n",
    runs="N10 N20", calls="",
)
case(
    "GSK 988: an address without a value is refused",
    control=FAMILY_988, source="Talm 005", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 G0 X\nN30 M30\n",
    runs="N10", alarm="address-without-value", number="005", at="O1 N20",
)
case(
    "GSK 988: P without a value is no call",
    control=FAMILY_988, source="Talm 005", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 M98 P\nN30 M30\n",
    runs="N10", alarm="address-without-value", number="005", at="O1 N20",
)
case(
    "GSK: a G code that the control does not have is refused",
    pins="g_codes_complete",
    control=FAMILIES, source="Talm 009; MDib 0002", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 G999\nN30 M30\n",
    runs="N10", alarm="g-code-not-available",
    number={TA: "009", T: "009", TDI: "0002", MDI: "0002"}, at="O1 N20",
)
case(
    "GSK: a block longer than the control takes is refused",
    control=[TA, T, MDI], source="Talm 002; MDia 037", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 G0 X2" + " " * 300 + "Z3\nN30 M30\n",
    runs="N10", alarm="block-too-long", number={TA: "002", T: "002", MDI: "0037"}, at="O1 N20",
)

# --- 928: calls of a part of the same program ----------------------------------------------------------


def part_chain(levels):
    """A 928 program in which N1001 is called, calls N1002 and so on, so many levels deep."""
    blocks = ["%1", "N0001 M98 P1001", "N0002 M02"]
    for level in range(1, levels):
        blocks += [f"N{1000 + level} M98 P{1001 + level}", f"N{2000 + level} M99"]
    return "\n".join([*blocks, f"N{1000 + levels} M99", ""])


case(
    "GSK 928: the first method of the manual: M97 leads round the part inside the main program",
    pins="self_call",
    control=TE, source="source 001, example, first listing", evidence=SOURCE,
    program="""
        %1
        N0010 G00 X100 Z50
        N0020 M03 S01
        N0030 G0 X50 Z15 F500
        N0040 M98 P0060 L5
        N0050 M97 P0130
        N0060 G0 U-4
        N0070 G01 Z-10 F80
        N0080 U20 Z-25
        N0090 Z-35
        N0100 G0 U2 Z1
        N0110 U-22
        N0120 M99
        N0130 G0 X100 Z50
        N0140 M05
        N0140 M02
    """,
    runs="N10 N20 N30 N40 (N60 N70 N80 N90 N100 N110 N120)*5 N50 N130 N140 N140", calls="M98:%1",
)
SECOND_METHOD = """
        %2
        N0010 G00 X100 Z50
        N0020 M03 S01
        N0030 G0 X66 Z15 F500
        N0040 M98 P{} L5
        N0050 G0 X100 Z50
        N0060 M05
        N0070 M02
        N0080 G0 U-4
        N0090 G01 Z-10 F80
        N0100 U20 Z-25
        N0110 Z-35
        N0120 G0 U2 Z1
        N0130 U-22
        N0140 M99
    """
case(
    "GSK 928: the second method of the manual: the part stands behind M02",
    control=TE, source="source 001, example, second listing; its text calls N0080", evidence=SOURCE,
    program=SECOND_METHOD.format("0080"),
    runs="N10 N20 N30 N40 (N80 N90 N100 N110 N120 N130 N140)*5 N50 N60 N70", calls="M98:%2",
)
case(
    "GSK 928: the second listing as it is printed calls P0060 and ends at M02 without a cut",
    control=TE, source="source 001, example, second listing, literally", evidence=SOURCE,
    program=SECOND_METHOD.format("0060"),
    runs="N10 N20 N30 N40 N60 N70", calls="M98:%2",
)
case(
    "GSK 928: the first method without its M97 runs the part once more and ends at its M99",
    pins="main_return",
    control=TE, source="source 001, example, note on M97", evidence=SOURCE,
    program="""
        %1
        N0040 M98 P0060 L2
        N0060 G0 U-4
        N0120 M99
        N0130 G0 X100
        N0140 M02
    """,
    runs="N40 (N60 N120)*2 N60 N120", stop="end",
)
case(
    "GSK 928: M98 calls from a block of the same program",
    control=TE, source="source 001, example", evidence=SOURCE,
    program="""
        %1
        N0010 M98 P0040
        N0020 G0 X2
        N0030 M02
        N0040 G0 X4
        N0050 M99
    """,
    runs="N10 N40 N50 N20 N30", calls="M98:%1",
)
case(
    "GSK 928: L is one where it is not written",
    control=TE, source="K, L of M98", evidence=INFERRED,
    program="%1\nN0010 M98 P0030\nN0020 M02\nN0030 M99\n",
    runs="N10 N30 N20",
)
case(
    "GSK 928: leading zeros of P and N do not matter",
    control=TE, source="source 001, example", evidence=INFERRED,
    program="%1\nN10 M98 P0030 L2\nN20 M02\nN0030 M99\n",
    runs="N10 N30*2 N20",
)
case(
    "GSK 928: P is a block of the program itself, never another program",
    control=TE, source="source 001, example", evidence=SOURCE,
    files={"%1.CNC": "%1\nN0010 M98 P0002\nN0020 M02\nN0002 M99\n", "%2.CNC": "%2\nN0090 M99\n"},
    main="%1", runs="N10 N2 N20", calls="M98:%1",
)
case(
    "GSK 928: the part may stand in front of its call",
    control=TE, source="source 001, M97 and M98", evidence=INFERRED,
    program="""
        %1
        N0010 M97 P0040
        N0020 G0 X2
        N0030 M99
        N0040 M98 P0020 L2
        N0050 M02
    """,
    runs="N10 N40 (N20 N30)*2 N50",
)
case(
    "GSK 928: one part may be called from two places",
    control=TE, source="source 001, M98", evidence=SOURCE,
    program="""
        %1
        N0010 M98 P0050 L2
        N0020 G0 X2
        N0030 M98 P0050
        N0040 M02
        N0050 M99
    """,
    runs="N10 N50*2 N20 N30 N50 N40", calls="M98:%1 M98:%1",
)
case(
    "GSK 928: a part may be entered in its middle",
    control=TE, source="source 001, M98", evidence=SOURCE,
    program="""
        %1
        N0010 M98 P0040
        N0020 M98 P0050
        N0030 M02
        N0040 G0 X4
        N0050 G0 X5
        N0060 M99
    """,
    runs="N10 N40 N50 N60 N20 N50 N60 N30",
)
case(
    "GSK 928: calls may be nested",
    pins="max_total_nesting",
    control=TE, source="source 001, nesting", evidence=SOURCE,
    program="""
        %1
        N0010 M98 P0100 L3
        N0020 M02
        N0100 M98 P0200 L2
        N0110 M99
        N0200 G0 U1
        N0210 M99
    """,
    runs="N10 (N100 (N200 N210)*2 N110)*3 N20",
)
case(
    "GSK 928: a call without M99 runs the part once, whatever L says",
    control=TE, source="source 001, first rule", evidence=SOURCE,
    program="%1\nN0010 M98 P0030 L3\nN0020 M02\nN0030 G0 X3\nN0040 M02\n",
    runs="N10 N30 N40",
)
case(
    "GSK 928: a call without M99 does not come back",
    control=TE, source="source 001, first rule", evidence=SOURCE,
    program="%1\nN0010 M98 P0030\nN0020 G0 X2\nN0030 G0 X3\nN0040 M30\n",
    runs="N10 N30 N40",
)
case(
    "GSK 928: M99 without M98 ends the program and does not start it anew",
    control=TE, source="source 001, second rule", evidence=SOURCE,
    program="%1\nN0010 G0 X1\nN0020 M99\n",
    max_cycles=3, runs="N10 N20", stop="end",
)
case(
    "GSK 928: an M99 that is jumped to without a call ends the program",
    control=TE, source="source 001, second rule", evidence=SOURCE,
    program="%1\nN0010 M97 P0030\nN0020 M02\nN0030 M99\nN0040 G0 X4\n",
    runs="N10 N30", stop="end",
)
case(
    "GSK 928: M99 behind a finished call ends the program",
    control=TE, source="source 001, second rule", evidence=SOURCE,
    program="%1\nN0010 M98 P0030 L2\nN0020 G0 X2\nN0030 G0 X3\nN0040 M99\nN0050 M02\n",
    runs="N10 (N30 N40)*2 N20 N30 N40", stop="end",
)
case(
    "GSK 928: M97 goes forward",
    control=TE, source="source 001, example", evidence=SOURCE,
    program="%1\nN0010 M97 P0030\nN0020 G0 X2\nN0030 M02\n",
    runs="N10 N30", calls="",
)
case(
    "GSK 928: M97 goes backward",
    control=TE, source="source 001, example", evidence=INFERRED,
    program="%1\nN0010 G0 U1\nN0020 M97 P0010\nN0030 M02\n",
    max_blocks=5, runs="N10 N20 N10 N20 N10", stop="limit",
)
case(
    "GSK 928: M97 does not end a call",
    control=TE, source="source 001, M97 has no return", evidence=INFERRED,
    program="""
        %1
        N0010 M98 P0040 L2
        N0020 M02
        N0040 M97 P0060
        N0050 M02
        N0060 M99
    """,
    runs="N10 (N40 N60)*2 N20",
)
case(
    "GSK 928: M02 ends the program in a called part",
    control=TE, source="K, M02", evidence=INFERRED,
    program="%1\nN0010 M98 P0030 L5\nN0020 M30\nN0030 M02\nN0040 M99\n",
    runs="N10 N30",
)
case(
    "GSK 928: M30 ends the program",
    control=TE, source="K, M30", evidence=INFERRED,
    program="%1\nN0010 G0 X1\nN0020 M30\nN0030 G0 X3\n",
    runs="N10 N20",
)
case(
    "GSK 928: M20 starts the program anew",
    pins="m_codes_per_block restart_m_code",
    control=TE, source="K, M20", evidence=INFERRED,
    program="%1\nN0010 G0 X1\nN0020 M20\nN0030 G0 X3\n",
    max_cycles=2, runs="(N10 N20)*2", stop="cycles",
)
case(
    "GSK 928: of two blocks of one number M97 takes the first of the program",
    control=TE, source="source 001, its N0140 stands twice; choice of the engine", evidence=INFERRED,
    program="""
        %1
        N0010 M97 P0140
        N0140 M05
        N0150 M02
        N0140 M30
    """,
    runs="N10 N140 N150",
)
case(
    "GSK 928: of two blocks of one number M98 takes the first of the program",
    control=TE, source="source 001, its N0140 stands twice; choice of the engine", evidence=INFERRED,
    program="""
        %1
        N0010 M97 P0040
        N0020 G0 X2
        N0030 M99
        N0040 M98 P0020
        N0050 M02
        N0020 G0 X3
        N0060 M99
    """,
    runs="N10 N40 N20 N30 N50",
)
case(
    "GSK 928: two blocks of one number may follow each other",
    control=TE, source="source 001, example, N0140", evidence=SOURCE,
    program="%1\nN0130 G0 X100\nN0140 M05\nN0140 M02\n",
    runs="N130 N140 N140",
)
case(
    "GSK 928: eighteen levels are legal",
    pins="max_nesting",
    control=TE, source="source 001, nesting", evidence=SOURCE,
    program=part_chain(18),
    runs=" ".join(
        ["N1"]
        + [f"N{1000 + k}" for k in range(1, 19)]
        + [f"N{2000 + k}" for k in range(17, 0, -1)]
        + ["N2"]
    ),
)
case(
    "GSK 928: the nineteenth level is an alarm",
    control=TE, source="source 001, nesting", evidence=SOURCE,
    program=part_chain(19),
    runs=" ".join(["N1"] + [f"N{1000 + k}" for k in range(1, 18)]),
    alarm="nesting-too-deep", at="%1 N1018",
)
case(
    "GSK 928: a part that calls itself is stopped at the nineteenth level",
    control=TE, source="source 001, nesting", evidence=SOURCE,
    program="%1\nN0010 M98 P0010\nN0020 M02\n",
    runs="N10*18", alarm="nesting-too-deep", at="%1 N10",
)
case(
    "GSK 928: calls without M99 stay open and use up the levels",
    control=TE, source="source 001, first rule and nesting", evidence=INFERRED,
    program="%1\nN0010 G0 U1\nN0020 M98 P0010 L2\nN0030 M02\n",
    runs="N10 (N20 N10)*18", alarm="nesting-too-deep", at="%1 N20",
)
case(
    "GSK 928: repetitions are no levels",
    control=TE, source="source 001, nesting", evidence=SOURCE,
    program="%1\nN0010 M98 P0030 L25\nN0020 M02\nN0030 M99\n",
    runs="N10 N30*25 N20",
)
case(
    "GSK 928: M98 to a block that is missing is an alarm",
    control=TE, source="source 001; no number is known", evidence=INFERRED,
    program="%1\nN0010 G0 X1\nN0020 M98 P0090 L2\nN0030 M02\n",
    runs="N10", alarm="start-not-found", at="%1 N20",
)
case(
    "GSK 928: M97 to a block that is missing is an alarm",
    control=TE, source="source 001; no number is known", evidence=INFERRED,
    program="%1\nN0010 G0 X1\nN0020 M97 P0090\nN0030 M02\n",
    runs="N10", alarm="jump-target-not-found", at="%1 N20",
)
case(
    "GSK 928: M98 without P is an alarm",
    pins="omitted_program",
    control=TE, source="source 001; no number is known", evidence=INFERRED,
    program="%1\nN0010 G0 X1\nN0020 M98 L2\nN0030 M02\n",
    runs="N10", alarm="program-number-missing", at="%1 N20",
)
case(
    "GSK 928: a missing block is missed inside a called part",
    control=TE, source="source 001; no number is known", evidence=INFERRED,
    program="%1\nN0010 M98 P0030\nN0020 M02\nN0030 M98 P0090\nN0040 M99\n",
    runs="N10", alarm="start-not-found", at="%1 N30",
)
case(
    "GSK 928: a call to a missing block that is never reached raises nothing",
    control=TE, source="policy: a control reads a block when it reaches it", evidence=INFERRED,
    program="%1\nN0010 M97 P0030\nN0020 M98 P0090\nN0030 M02\n",
    runs="N10 N30",
)
