"""Mitsubishi: M98 and its return, missing programs, faults of form, L0, variables in its words."""

from conformance import case

case(
    "with L0 the call is left out and the run goes on (MIT-007)",
    control="mitsubishi-m700",
    source="source 004, L0",
    evidence="source document",
    program="""
        O1
        G0 X1
        M98 P2 L0
        G0 X2
        M30
        O2
        G0 X10
        M99
    """,
    moves_x=[1, 2],
)

case(
    "the move of an M98 block comes before the call (MIT-020)",
    control="mitsubishi-m700",
    source="SM 13.9 (3)",
    evidence="maker's manual",
    program="""
        O1
        G0 X1 M98 P2
        G0 X2
        M30
        O2
        G0 X10
        M99
    """,
    moves_x=[1, 10, 2],
)

MELDAS = "mitsubishi-meldas"
M700 = "mitsubishi-m700"
M800 = "mitsubishi-m800"
EVERY = [MELDAS, M700, M800]


def chain(levels, call="M98 P{}"):
    """Return a main program O1 from which `levels` calls are open at once.

    Program Ok calls in block Nk and returns in block N(100+k).
    """
    text = f"O1\nN1 {call.format(2)}\nN101 M30\n"
    for k in range(2, levels + 1):
        text += f"O{k}\nN{k} {call.format(k + 1)}\nN{100 + k} M99\n"
    last = levels + 1
    return text + f"O{last}\nN{last} S{last}\nN{100 + last} M99\n"


def way_in(levels):
    return " ".join(f"N{k}" for k in range(1, levels + 1))


def way_in_and_out(levels):
    out = " ".join(f"N{100 + k}" for k in range(levels + 1, 0, -1))
    return f"{way_in(levels + 1)} {out}"


# The call and its return

case(
    "a Mitsubishi M98 P runs the program from its head and M99 goes on after the call",
    control=EVERY, source="source 004, M98 P and M99", evidence="source document",
    program="""
        O1
        N10 S1
        N20 M98 P200
        N30 M30
        O200
        N210 S2
        N220 M99
    """,
    runs="N10 N20 N210 N220 N30", calls="M98:O200",
)
case(
    "L is how often the Mitsubishi subprogram runs",
    control=EVERY, source="source 004, L", evidence="source document",
    program="""
        O1
        N10 M98 P200 L4
        N20 M30
        O200
        N210 S2
        N220 M99
    """,
    runs="N10 (N210 N220)*4 N20", calls="M98:O200",
)
case(
    "L may stand in front of P",
    pins="start_word",
    control=EVERY, source="source 004, M98 P_ H_ L_", evidence="inferred",
    program="""
        O1
        N10 L2 M98 H220 P200
        N20 M30
        O200
        N210 S2
        N220 M99
    """,
    runs="N10 N220*2 N20",
)
case(
    "L1 is the same as no L",
    control=EVERY, source="source 004, L omitted", evidence="source document",
    program="""
        O1
        N10 M98 P200 L1
        N20 M98 P200
        N30 M30
        O200
        N220 M99
    """,
    runs="N10 N220 N20 N220 N30", calls="M98:O200 M98:O200",
)
case(
    "9999 repeats are allowed on a Mitsubishi",
    pins="max_repeats",
    control=EVERY, source="source 004, at most 9999 times", evidence="source document",
    program="""
        O1
        N10 M98 P200 L9999
        N20 M30
        O200
        N220 M99
    """,
    runs="N10 N220*9999 N20",
)
case(
    "10000 repeats are refused on a Mitsubishi",
    pins="too_many_repeats",
    control=[*EVERY, "haas-ngc"], source="source 004, at most 9999 times; SK P35", evidence="inferred",
    program="""
        O1
        N10 M98 P200 L10000
        N20 M30
        O200
        N220 M99
    """,
    runs="", alarm="repeat-count-digits", number=dict.fromkeys(EVERY, "P35") | {"haas-ngc": None}, at="O1 N10", word="L10000",
)
case(
    "a negative repeat count is refused on a Mitsubishi",
    pins="minus_addresses",
    control=EVERY, source="SK P35; general knowledge", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 M98 P200 L-2
        N30 M30
        O200
        N220 M99
    """,
    runs="N10", alarm="illegal-repeat-count", number="P35", at="O1 N20", word="L-2",
)
case(
    "words beside a refused repeat count are not executed",
    control=EVERY, source="SK P35; general knowledge", evidence="inferred",
    program="""
        O1
        N10 T5 M98 P200 L10000
        N20 M30
        O200
        N220 M99
    """,
    runs="", t=[], alarm="repeat-count-digits", number="P35", at="O1 N10",
)
case(
    "the other words of an M98 block come before the subprogram",
    control=EVERY, source="SM, differences of M98 and G65 (3)", evidence="maker's manual",
    program="""
        O1
        N10 M98 P200 T5
        N20 T7
        N30 M30
        O200
        N210 T6
        N220 M99
    """,
    runs="N10 N210 N220 N20 N30", t=[5, 6, 7],
)
case(
    "the other words of an M98 block run once, not once a repeat",
    control=EVERY, source="SM, differences of M98 and G65 (3)", evidence="inferred",
    program="""
        O1
        N10 T5 M98 P200 L3
        N20 M30
        O200
        N220 M99
    """,
    runs="N10 N220*3 N20", t=[5],
)
case(
    "M98 and M99 are not sent to the machine as M codes",
    control=EVERY, source="general knowledge", evidence="inferred",
    program="""
        O1
        N10 M3
        N20 M98 P200
        N30 M5
        N40 M30
        O200
        N210 M8
        N220 M99
    """,
    runs="N10 N20 N210 N220 N30 N40", m=[3, 8, 5],
)
case(
    "a subprogram shares the local variables of its Mitsubishi caller",
    pins="call_passes_words",
    control=EVERY, source="SM, differences of M98 and G65 (5)", evidence="maker's manual",
    program="""
        O1
        N10 #1=5
        N20 M98 P200
        N30 M30
        O200
        N210 #2=#1+1
        N220 M99
    """,
    runs="N10 N20 N210 N220 N30", vars={1: 5, 2: 6},
)
case(
    "letters in an M98 block are no arguments",
    control=EVERY, source="SM, differences of M98 and G65 (1)", evidence="maker's manual",
    program="""
        O1
        N10 M98 P200 T9
        N20 M30
        O200
        N210 #100=#20
        N220 M99
    """,
    runs="N10 N210 N220 N20", vars={100: None},
)
case(
    "a subprogram may call another and both returns find their way",
    control=EVERY, source="source 004, note on levels", evidence="source document",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 M98 P300
        N220 M99
        O300
        N310 M99
    """,
    runs="N10 N210 N310 N220 N20", calls="M98:O200 M98:O300",
)

# Missing programs

case(
    "a called program that does not exist is P232",
    control=EVERY, source="source 004, note 1", evidence="source document",
    program="""
        O1
        N10 S1
        N20 M98 P200
        N30 M30
    """,
    runs="N10", calls="", alarm="program-not-found", number="P232", at="O1 N20", word="P200",
)
case(
    "the words beside a call of a missing program have run when P232 comes",
    control=EVERY, source="SM, differences of M98 and G65 (3)", evidence="inferred",
    program="""
        O1
        N10 T4 M98 P200
        N20 M30
    """,
    runs="N10", t=[4], alarm="program-not-found", number="P232", at="O1 N10", word="P200",
)
case(
    "P232 in a subprogram is told at the subprogram's block",
    control=EVERY, source="source 004, note 1", evidence="source document",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 S2
        N220 M98 P300
        N230 M99
    """,
    runs="N10 N210", calls="M98:O200", alarm="program-not-found", number="P232", at="O200 N220",
)
case(
    "a missing program that is never called raises nothing",
    control=EVERY, source="source 004, note 1", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 M30
        N30 M98 P200
    """,
    runs="N10 N20",
)
case(
    "P232 is not P231: with a start word the missing program is told first",
    control=EVERY, source="source 004, notes 1 and 2", evidence="inferred",
    program="""
        O1
        N10 M98 P200 H210
        N20 M30
    """,
    runs="", alarm="program-not-found", number="P232", at="O1 N10", word="P200",
)
case(
    "a Mitsubishi P has no repeat count in it: P30200 is program 30200",
    control=EVERY, source="source 004, P; IMD", evidence="secondary",
    program="""
        O1
        N10 M98 P30200
        N20 M30
        O200
        N210 M99
    """,
    runs="", alarm="program-not-found", number="P232", at="O1 N10", word="P30200",
)
case(
    "a program number of eight nines is callable",
    pins="max_program_number max_program_digits",
    control=EVERY, source="IMD, P", evidence="secondary",
    program="""
        O1
        N10 M98 P99999999
        N20 M30
        O99999999
        N30 M99
    """,
    runs="N10 N30 N20", calls="M98:O99999999",
)
case(
    "a program number of nine digits is refused",
    control=EVERY, source="IMD, P; SK P35", evidence="inferred",
    program="""
        O1
        N10 M98 P123456789
        N20 M30
        O123456789
        N30 M99
    """,
    runs="", alarm="too-many-digits", number="P35", at="O1 N10", word="P123456789",
)
case(
    "leading zeros on either side do not hide a Mitsubishi program",
    control=EVERY, source="general knowledge, O0002 is O2", evidence="inferred",
    program="""
        O1
        N10 M98 P00020
        N20 M98 P3
        N30 M30
        O20
        N40 M99
        O0003
        N50 M99
    """,
    runs="N10 N40 N20 N50 N30",
)

# Faults of form

case(
    "a decimal point in P is a format error",
    control=EVERY, source="SK P33; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P200.
        N20 M30
        O200
        N210 M99
    """,
    runs="", alarm="illegal-decimal-point", number="P33", at="O1 N10", word="P200.",
)
case(
    "a decimal point in L is a format error",
    control=EVERY, source="SK P33; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P200 L2.5
        N20 M30
        O200
        N210 M99
    """,
    runs="", alarm="illegal-decimal-point", number="P33", at="O1 N10", word="L2.5",
)
case(
    "a decimal point in H is a format error",
    control=EVERY, source="SK P33; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P200 H210.
        N20 M30
        O200
        N210 M99
    """,
    runs="", alarm="illegal-decimal-point", number="P33", at="O1 N10", word="H210.",
)
case(
    "a decimal point in the P of M99 is a format error",
    control=EVERY, source="SK P33; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 M99 P20.
    """,
    runs="N10", alarm="illegal-decimal-point", number="P33", at="O200 N210", word="P20.",
)
case(
    "a negative program number is refused on a Mitsubishi",
    control=EVERY, source="SK P35; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P-200
        N20 M30
        O200
        N210 M99
    """,
    runs="", alarm="illegal-minus-sign", number="P35", at="O1 N10", word="P-200",
)
case(
    "N0 is refused as a sequence number",
    pins="refuses:program-number-zero",
    control=EVERY, source="MZ 811; general knowledge P37", evidence="inferred",
    program="""
        O1
        N10 S1
        N0 S2
        N20 M30
    """,
    runs="N10", alarm="program-number-zero", number="P37",
)
case(
    "O0 is refused as a program number",
    control=MELDAS, source="MZ 811; general knowledge P37", evidence="inferred",
    program="""
        O0
        N10 S1
        N20 M30
    """,
    main="O0", runs="", alarm="program-number-zero", number="P37",
)

# L0

case(
    "L0 leaves the call out and the next block follows",
    pins="zero_repeats",
    control=EVERY, source="source 004, note 3", evidence="source document",
    program="""
        O1
        N10 M98 P200 H220 L0
        N20 M30
        O200
        N210 S1
        N220 M99
    """,
    runs="N10 N20", calls="",
)
case(
    "L0 asks for no program",
    control=EVERY, source="source 004, note 3", evidence="inferred",
    program="""
        O1
        N10 M98 P200 L0
        N20 M30
    """,
    runs="N10 N20", calls="",
)
case(
    "L0 asks for no start block",
    control=EVERY, source="source 004, note 3", evidence="inferred",
    program="""
        O1
        N10 M98 P200 H300 L0
        N20 M30
        O200
        N220 M99
    """,
    runs="N10 N20", calls="",
)
case(
    "a variable that is zero in L leaves the call out too",
    control=EVERY, source="source 004, note 3; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P200 L#101
        N20 M30
        O200
        N220 M99
    """,
    variables={101: 0}, runs="N10 N20", calls="",
)
case(
    "L0 does not open a level",
    control=MELDAS, source="source 004, note 3 and note on levels", evidence="inferred",
    program=chain(4).replace("S5", "M98 P9 L0"),
    runs=way_in_and_out(4),
)

# Variables in the words

case(
    "P from a variable calls the program of its value",
    control=EVERY, source="general knowledge, P#100", evidence="inferred",
    program="""
        O1
        N10 M98 P#100
        N20 M30
        O200
        N210 M99
    """,
    variables={100: 200}, runs="N10 N210 N20", calls="M98:O200",
)
case(
    "P from a variable is rounded to the nearest number",
    pins="call_values",
    control=EVERY, source="general knowledge, P#100", evidence="inferred",
    program="""
        O1
        N10 M98 P#100
        N20 M30
        O201
        N210 M99
    """,
    variables={100: 200.7}, runs="N10 N210 N20", calls="M98:O201",
)
case(
    "P from a variable whose program is missing is P232",
    control=EVERY, source="source 004, note 1", evidence="inferred",
    program="""
        O1
        N10 M98 P#100
        N20 M30
    """,
    variables={100: 200}, runs="", alarm="program-not-found", number="P232", at="O1 N10",
    word="P#100",
)
case(
    "L from a variable is rounded up from six tenths",
    control=EVERY, source="general knowledge, L#101", evidence="inferred",
    program="""
        O1
        N10 M98 P200 L#101
        N20 M30
        O200
        N210 M99
    """,
    variables={101: 2.6}, runs="N10 N210*3 N20",
)
case(
    "L from a vacant variable is an L that was not written",
    control=EVERY, source="general knowledge, vacant means word absent", evidence="inferred",
    program="""
        O1
        N10 M98 P200 L#101
        N20 M30
        O200
        N210 M99
    """,
    variables={101: None}, runs="N10 N210 N20",
)
case(
    "L from a variable above 9999 is refused",
    control=EVERY, source="source 004, at most 9999 times; SK P35", evidence="inferred",
    program="""
        O1
        N10 M98 P200 L#101
        N20 M30
        O200
        N210 M99
    """,
    variables={101: 10000}, runs="", alarm="repeat-count-digits", number="P35", at="O1 N10",
    word="L#101",
)
case(
    "H from a variable starts at the block of its value",
    control=EVERY, source="general knowledge, H#102", evidence="inferred",
    program="""
        O1
        N10 M98 P200 H#102
        N20 M30
        O200
        N210 S1
        N220 M99
    """,
    variables={102: 220}, runs="N10 N220 N20",
)
case(
    "H from a variable that names no block is P231",
    control=EVERY, source="source 004, note 2", evidence="inferred",
    program="""
        O1
        N10 M98 P200 H#102
        N20 M30
        O200
        N220 M99
    """,
    variables={102: 230}, runs="", alarm="start-not-found", number="P231", at="O1 N10",
    word="H#102",
)
case(
    "L may be an expression in brackets",
    control=EVERY, source="general knowledge, L[#1+1]", evidence="inferred",
    program="""
        O1
        N10 M98 P200 L[#101+1]
        N20 M30
        O200
        N210 M99
    """,
    variables={101: 2}, runs="N10 N210*3 N20",
)
