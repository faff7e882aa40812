"""Subprogram calls of the Mitsubishi controls: MELDAS (source 004), M700 and M800."""

from conformance import case

MELDAS = "mitsubishi-meldas"
M700 = "mitsubishi-m700"
M800 = "mitsubishi-m800"
NEWER = [M700, M800]
EVERY = [MELDAS, M700, M800]


def chain(levels, call="M98 P{}"):
    """A main program O1 from which `levels` calls are open at once.

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
    "a Mitsubishi M98 P runs the program from its head and M99 goes on behind the call",
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
    pins="zero_numbers",
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

# H: the block to start at

case(
    "H names the block of the called program where it starts",
    control=EVERY, source="source 004, H", evidence="source document",
    program="""
        O1
        N10 M98 P200 H230
        N20 M30
        O200
        N210 S1
        N220 S2
        N230 S3
        N240 M99
    """,
    runs="N10 N230 N240 N20", calls="M98:O200",
)
case(
    "an omitted H starts at the first block",
    control=EVERY, source="source 004, H omitted", evidence="source document",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N230 S1
        N210 S2
        N240 M99
    """,
    runs="N10 N230 N210 N240 N20",
)
case(
    "an H that the called program does not have is P231",
    control=EVERY, source="source 004, note 2", evidence="source document",
    program="""
        O1
        N10 S1
        N20 M98 P200 H300
        N30 M30
        O200
        N210 S2
        N220 M99
    """,
    runs="N10", alarm="start-not-found", number="P231", at="O1 N20", word="H300",
)
case(
    "H is searched in the called program and not in the caller",
    control=EVERY, source="source 004, H and note 2", evidence="source document",
    program="""
        O1
        N10 M98 P200 H20
        N20 M30
        O200
        N210 M99
    """,
    runs="", alarm="start-not-found", number="P231", at="O1 N10", word="H20",
)
case(
    "the words beside an H that is missing have run when P231 comes",
    control=EVERY, source="SM, differences of M98 and G65 (3)", evidence="inferred",
    program="""
        O1
        N10 T8 M98 P200 H300
        N20 M30
        O200
        N210 M99
    """,
    runs="N10", t=[8], alarm="start-not-found", number="P231", at="O1 N10", word="H300",
)
case(
    "every repeat starts at H again",
    control=[MELDAS, M800], source="source 004, H and L; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P200 H220 L3
        N20 M30
        O200
        N210 S1
        N220 S2
        N230 M99
    """,
    runs="N10 (N220 N230)*3 N20",
)
case(
    "H compares the number and not its digits",
    control=EVERY, source="general knowledge, N0100 is N100", evidence="inferred",
    program="""
        O1
        N10 M98 P200 H0220
        N20 M98 P300 H330
        N30 M30
        O200
        N210 S1
        N220 M99
        O300
        N310 S1
        N00330 M99
    """,
    runs="N10 N220 N20 N330 N30",
)
case(
    "of two blocks with the number of H the first one counts",
    control=EVERY, source="general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P200 H220
        N20 M30
        O200
        N210 S1
        N220 S2
        N230 S3
        N220 S4
        N240 M99
    """,
    runs="N10 N220 N230 N220 N240 N20",
)
case(
    "H99999 is a sequence number like any other",
    control=EVERY, source="IMD, H 1 to 99999", evidence="secondary",
    program="""
        O1
        N10 M98 P200 H99999
        N20 M30
        O200
        N210 S1
        N99999 M99
    """,
    runs="N10 N99999 N20",
)
case(
    "an H of six digits is over the range before the M800",
    control=[MELDAS, M700], source="IMD, H 1 to 99999; SK P35", evidence="inferred",
    program="""
        O1
        N10 M98 P200 H100000
        N20 M30
        O200
        N210 M99
    """,
    runs="", alarm="illegal-sequence-number", number="P35", at="O1 N10", word="H100000",
)
case(
    "Q starts nothing on a Mitsubishi, the call begins at the head",
    control=[MELDAS, M800], source="IMD, Q", evidence="secondary",
    program="""
        O1
        N10 M98 P200 Q220
        N20 M30
        O200
        N210 S1
        N220 M99
    """,
    runs="N10 N210 N220 N20",
)
case(
    "a Q that names no block raises nothing",
    control=EVERY, source="IMD, Q", evidence="secondary",
    program="""
        O1
        N10 M98 P200 Q777
        N20 M30
        O200
        N220 M99
    """,
    runs="N10 N220 N20",
)
case(
    "Q beside a missing program does not save the call",
    control=EVERY, source="IMD, Q; source 004, note 1", evidence="inferred",
    program="""
        O1
        N10 M98 P200 Q10
        N20 M30
    """,
    runs="", alarm="program-not-found", number="P232", at="O1 N10", word="P200",
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

# P omitted: MELDAS jumps

case(
    "MELDAS: M98 H without P jumps in its own program and calls nothing",
    control=MELDAS, source="source 004, P omitted", evidence="source document",
    program="""
        O1
        N10 M98 H40
        N20 S2
        N30 S3
        N40 S4
        N50 M30
    """,
    runs="N10 N40 N50", calls="",
)
case(
    "MELDAS: L has no effect on an M98 that jumps",
    control=MELDAS, source="source 004, P omitted", evidence="inferred",
    program="""
        O1
        N10 M98 H40 L3
        N20 S2
        N40 S4
        N50 M30
    """,
    runs="N10 N40 N50", calls="",
)
case(
    "MELDAS: no frame is open after an M98 that jumps, so M99 starts the main program over",
    pins="main_return",
    control=MELDAS, source="source 004, P omitted", evidence="inferred",
    program="""
        O1
        N10 M98 H40
        N20 M30
        N40 S4
        N50 M99
    """,
    max_cycles=1, runs="N10 N40 N50", stop="cycles", calls="",
)
case(
    "MELDAS: M98 H may jump back and spin for ever",
    control=MELDAS, source="source 004, P omitted", evidence="source document",
    program="""
        O1
        N10 S1
        N20 S2
        N30 M98 H20
        N40 M30
    """,
    max_cycles=100, max_blocks=7, runs="N10 (N20 N30)*3", stop="limit",
)
case(
    "MELDAS: an M98 H that finds no block is P231",
    control=MELDAS, source="source 004, note 2", evidence="source document",
    program="""
        O1
        N10 M98 H40
        N20 M30
    """,
    runs="", alarm="start-not-found", number="P231", at="O1 N10", word="H40",
)
case(
    "MELDAS: M98 H in a subprogram jumps in the subprogram",
    control=MELDAS, source="source 004, P omitted", evidence="source document",
    program="""
        O1
        N10 M98 P200
        N20 S1
        N40 M30
        O200
        N210 M98 H40
        N30 S2
        N40 M99
    """,
    runs="O1:N10 O200:N210 O200:N40 O1:N20 O1:N40", calls="M98:O200",
)
case(
    "MELDAS: M98 H in a subprogram does not find a block of the main program",
    control=MELDAS, source="source 004, P omitted and note 2", evidence="source document",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 M98 H20
        N220 M99
    """,
    runs="N10", alarm="start-not-found", number="P231", at="O200 N210", word="H20",
)
case(
    "MELDAS: an M98 that jumps needs no level",
    control=MELDAS, source="source 004, P omitted and note on levels", evidence="inferred",
    program=chain(4).replace("N5 S5", "N5 M98 H105\nN6 S6"),
    runs=way_in_and_out(4),
)
case(
    "MELDAS: M98 without P, H and L starts the program over",
    control=MELDAS, source="source 004, P, H and L omitted", evidence="source document",
    program="""
        O1
        N10 S1
        N20 M98
        N30 M30
    """,
    max_cycles=3, runs="(N10 N20)*3", stop="cycles", calls="",
)
case(
    "MELDAS: one pass of a program that ends in a bare M98 is one cycle",
    control=MELDAS, source="source 004, P, H and L omitted", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 M98
    """,
    max_cycles=1, runs="N10 N20", t=[1], stop="cycles",
)
case(
    "MELDAS: a bare M98 in a subprogram goes back to the subprogram's head",
    control=MELDAS, source="source 004, P, H and L omitted", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 S1
        N220 M98
        N230 M99
    """,
    max_cycles=100, max_blocks=7, runs="N10 (N210 N220)*3", stop="limit", calls="M98:O200",
)
case(
    "MELDAS: a bare M98 behind a block skip that is on does nothing",
    control=MELDAS, source="source 004, P, H and L omitted", evidence="inferred",
    program="""
        O1
        N10 S1
        /N20 M98
        N30 M30
    """,
    skip=(1,), runs="N10 N30",
)
case(
    "MELDAS: L0 also stops a jump of M98 H",
    control=MELDAS, source="source 004, note 3", evidence="source document",
    program="""
        O1
        N10 M98 H40 L0
        N20 S2
        N40 M30
    """,
    runs="N10 N20 N40",
)
case(
    "MELDAS: L0 also stops a bare M98 from starting over",
    control=MELDAS, source="source 004, note 3", evidence="source document",
    program="""
        O1
        N10 M98 L0
        N20 M30
    """,
    runs="N10 N20",
)
case(
    "MELDAS: words beside an M98 that jumps run first",
    control=MELDAS, source="source 004, P omitted; SM (3)", evidence="inferred",
    program="""
        O1
        N10 T3 M98 H40
        N20 T4
        N40 M30
    """,
    runs="N10 N40", t=[3],
)
case(
    "MELDAS: a vacant P is an omitted P and jumps",
    control=MELDAS, source="source 004, P omitted; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P#100 H40
        N20 S2
        N40 M30
    """,
    variables={100: None}, runs="N10 N40", calls="",
)

# P omitted: the newer ones call

case(
    "from the M700 on M98 H without P calls its own program and M99 comes back",
    pins="omitted_program",
    control=NEWER, source="IMD, P omitted", evidence="secondary",
    program="""
        O1
        N10 S1
        N20 M98 H50
        N30 S3
        N40 M30
        N50 S5
        N60 M99
    """,
    runs="N10 N20 N50 N60 N30 N40", calls="M98:O1",
)
case(
    "from the M700 on L repeats the part that M98 H calls",
    control=NEWER, source="IMD, P omitted", evidence="secondary",
    program="""
        O1
        N20 M98 H50 L4
        N40 M30
        N50 S5
        N60 M99
    """,
    runs="N20 (N50 N60)*4 N40", calls="M98:O1",
)
case(
    "from the M700 on an M98 H that finds no block is P231",
    control=NEWER, source="source 004, note 2; IMD", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 M98 H50
        N40 M30
    """,
    runs="N10", alarm="start-not-found", number="P231", at="O1 N20", word="H50",
)
case(
    "from the M700 on M98 H in a subprogram calls the subprogram",
    control=NEWER, source="IMD, P omitted", evidence="secondary",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 M98 H230
        N220 M99
        N230 S3
        N240 M99
    """,
    runs="N10 N210 N230 N240 N220 N20", calls="M98:O200 M98:O200",
)
case(
    "from the M700 on M98 H in a subprogram does not find a block of the main program",
    control=NEWER, source="IMD, P omitted; source 004, note 2", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 M98 H20
        N220 M99
    """,
    runs="N10", alarm="start-not-found", number="P231", at="O200 N210", word="H20",
)
case(
    "M700: a bare M98 calls itself until P230",
    control=M700, source="IMD, P omitted; SM (6)", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 M98
        N30 M30
    """,
    runs="(N10 N20)*8 N10", alarm="nesting-too-deep", number="P230", at="O1 N20",
)
case(
    "M800: a bare M98 calls itself until P230, two levels later",
    control=M800, source="IMD, P omitted; CW", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 M98
        N30 M30
    """,
    runs="(N10 N20)*10 N10", alarm="nesting-too-deep", number="P230", at="O1 N20",
)
case(
    "M700: a program that calls its own number without H ends in P230",
    control=M700, source="general knowledge; SM (6)", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 M98 P200
        N220 M99
    """,
    runs="N10 N210*7", alarm="nesting-too-deep", number="P230", at="O200 N210",
)
case(
    "a program that calls its own number with H runs its part and comes back",
    pins="self_call",
    control=EVERY, source="source 004, P and H", evidence="inferred",
    program="""
        O1
        N10 M98 P1 H50
        N20 M30
        N50 S5
        N60 M99
    """,
    runs="N10 N50 N60 N20", calls="M98:O1",
)
case(
    "from the M700 on a vacant P is an omitted P and calls",
    control=NEWER, source="IMD, P omitted; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P#100 H40
        N20 M30
        N40 M99
    """,
    variables={100: None}, runs="N10 N40 N20", calls="M98:O1",
)
case(
    "from the M700 on L0 also stops a call of the own program",
    control=NEWER, source="source 004, note 3; IMD", evidence="inferred",
    program="""
        O1
        N10 M98 L0
        N20 M98 H50 L0
        N30 M30
    """,
    runs="N10 N20 N30", calls="",
)

# M99

case(
    "M99 P returns to the named block of the caller, over the blocks between",
    control=[MELDAS, M800], source="source 004, M99 P", evidence="source document",
    program="""
        O1
        N10 M98 P200
        N20 S2
        N30 S3
        N40 M30
        O200
        N210 M99 P40
    """,
    runs="N10 N210 N40",
)
case(
    "M99 P may name a block in front of the call",
    control=EVERY, source="source 004, M99 P", evidence="source document",
    program="""
        O1
        N10 S1
        N20 M98 P200
        N30 M30
        O200
        N210 M99 P10
    """,
    max_blocks=7, runs="N10 (N20 N210 N10)*2", stop="limit",
)
case(
    "M99 P of a block the caller does not have is P231",
    control=[MELDAS, M800], source="source 004, M99 note 1", evidence="source document",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 S1
        N220 M99 P77
    """,
    runs="N10 N210", alarm="return-target-not-found", number="P231", at="O200 N220", word="P77",
)
case(
    "M99 P does not find a block of the subprogram itself",
    control=EVERY, source="source 004, M99 P", evidence="source document",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 S1
        N220 M99 P210
    """,
    runs="N10 N210", alarm="return-target-not-found", number="P231", at="O200 N220", word="P210",
)
case(
    "M99 P searches the immediate caller and not the program below it",
    control=EVERY, source="source 004, M99 P; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N50 M30
        O200
        N210 M98 P300
        N220 M99
        O300
        N310 M99 P50
    """,
    runs="N10 N210", alarm="return-target-not-found", number="P231", at="O300 N310", word="P50",
)
case(
    "the words beside an M99 P that finds nothing have run",
    control=EVERY, source="source 004, M99 note 1; SM (3)", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 T9 M99 P77
    """,
    runs="N10 N210", t=[9], alarm="return-target-not-found", number="P231", at="O200 N210",
    word="P77",
)
case(
    "the words beside M99 run before the return",
    control=EVERY, source="general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 T2
        N30 M30
        O200
        N210 T1 M99
    """,
    runs="N10 N210 N20 N30", t=[1, 2],
)
case(
    "of two blocks with the number of M99 P the first of the caller counts",
    control=EVERY, source="no source: engine decision", evidence="inferred",
    program="""
        O1
        N10 M98 H30 P1
        N20 M30
        N30 S3
        N40 M98 P200
        N50 S5
        N20 S6
        N60 M99
        O200
        N210 M99 P20
    """,
    runs="N10 N30 N40 N210 N20",
)
case(
    "M99 P takes effect on the last repeat only",
    control=EVERY, source="no source: engine decision", evidence="inferred",
    program="""
        O1
        N10 M98 P200 L3
        N20 S2
        N30 M30
        O200
        N210 M99 P30
    """,
    runs="N10 N210*3 N30", calls="M98:O200",
)
case(
    "an M99 P that finds nothing raises P231 on the last repeat",
    control=EVERY, source="source 004, M99 note 1; no source for repeats", evidence="inferred",
    program="""
        O1
        N10 M98 P200 L3
        N30 M30
        O200
        N210 S1
        N220 M99 P77
    """,
    runs="N10 N210 N220 N210 N220 N210", alarm="return-target-not-found", number="P231",
    at="O200 N220", word="P77",
)
case(
    "M99 P compares the number and not its digits",
    control=EVERY, source="general knowledge, N0100 is N100", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 S2
        N0040 M30
        O200
        N210 M99 P00040
    """,
    runs="N10 N210 N40",
)
case(
    "M99 P from a variable returns to the block of its value",
    control=EVERY, source="general knowledge, P#100", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 S2
        N40 M30
        O200
        N210 M99 P#100
    """,
    variables={100: 40}, runs="N10 N210 N40",
)
case(
    "M99 P from a vacant variable returns behind the call",
    control=EVERY, source="general knowledge, vacant means word absent", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 S2
        N40 M30
        O200
        N210 M99 P#100
    """,
    variables={100: None}, runs="N10 N210 N20 N40",
)
case(
    "M99 in a main program starts it over without end",
    pins="main_return",
    control=EVERY, source="source 004, M99 in the main program", evidence="source document",
    program="""
        O1
        N10 S1
        N20 M99
    """,
    max_cycles=100, max_blocks=5, runs="(N10 N20)*2 N10", stop="limit",
)
case(
    "one cycle of a Mitsubishi main program ends with its M99",
    control=EVERY, source="source 004, M99 in the main program", evidence="source document",
    program="""
        O1
        N10 T1
        N20 M99
        N30 M30
    """,
    max_cycles=2, runs="(N10 N20)*2", t=[1, 1], stop="cycles",
)
case(
    "M99 P in a main program jumps to the block of the main program",
    control=EVERY, source="source 004, M99 P in the main program", evidence="source document",
    program="""
        O1
        N10 S1
        N20 M99 P40
        N30 S3
        N40 M30
    """,
    max_cycles=9, runs="N10 N20 N40",
)
case(
    "M99 P back to a block of the main program spins there",
    control=EVERY, source="source 004, M99 P in the main program", evidence="source document",
    program="""
        O1
        N10 S1
        N20 S2
        N30 M99 P20
    """,
    max_cycles=100, max_blocks=7, runs="N10 (N20 N30)*3", stop="limit",
)
case(
    "M99 P of a missing block in a main program is P231",
    control=EVERY, source="source 004, M99 note 1", evidence="source document",
    program="""
        O1
        N10 S1
        N20 M99 P77
        N30 M30
    """,
    runs="N10", alarm="return-target-not-found", number="P231", at="O1 N20", word="P77",
)
case(
    "a skipped M99 lets the main program reach its M30",
    control=EVERY, source="source 004, M99 in the main program; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 S1
        /N20 M99
        N30 M30
    """,
    skip=(1,), runs="N10 N30",
)
case(
    "a subprogram that is run as the main program loops at its M99",
    control=EVERY, source="source 004, M99 in the main program", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 S1
        N220 M99
    """,
    main="O200", max_cycles=2, runs="(N210 N220)*2", stop="cycles", calls="",
)
case(
    "a Mitsubishi M99 L0 returns at once whatever repeats are left",
    pins="return_with_l",
    control=EVERY, source="OB, M99 L; engine decision", evidence="inferred",
    program="""
        O1
        N10 M98 P200 L5
        N20 M30
        O200
        N210 M99 L0
    """,
    runs="N10 N210 N20",
)
case(
    "M99 L2 leaves two repeats to run",
    control=EVERY, source="OB, M99 L; engine decision", evidence="inferred",
    program="""
        O1
        N10 M98 P200 L9
        N20 M30
        O200
        N210 IF[#100 EQ 1]GOTO240
        N220 #100=1
        N230 M99 L2
        N240 M99
    """,
    variables={100: 0}, runs="N10 N210 N220 N230 (N210 N240)*2 N20",
)
case(
    "M99 L1 on every pass never lets the call end",
    control=EVERY, source="OB, M99 L; engine decision", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 M99 L1
    """,
    max_blocks=6, runs="N10 N210*5", stop="limit",
)

# Ends

case(
    "M30 inside a Mitsubishi subprogram ends the whole run",
    control=[MELDAS, M800], source="general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P200 L3
        N20 M30
        O200
        N210 S1
        N220 M30
    """,
    runs="N10 N210 N220",
)
case(
    "M02 inside a Mitsubishi subprogram ends the whole run",
    control=EVERY, source="general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 M02
    """,
    runs="N10 N210",
)
case(
    "a Mitsubishi main program without M02, M30 or M99 is P36",
    pins="missing_end",
    control=EVERY, source="SK P36", evidence="secondary",
    program="""
        O1
        N10 S1
        N20 S2
    """,
    runs="N10 N20", alarm="end-of-record", number="P36",
)
case(
    "a Mitsubishi subprogram without M99 is P36 and does not run on into the next program",
    control=[MELDAS, M800], source="SK P36; MZ 810", evidence="secondary",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 S1
        O300
        N310 M99
    """,
    runs="N10 N210", alarm="end-of-record", number="P36",
)
case(
    "a program that ends in a call and nothing else is P36 after the return",
    control=EVERY, source="SK P36", evidence="secondary",
    program="""
        O1
        N10 M98 P200
        O200
        N210 M99
    """,
    runs="N10 N210", alarm="end-of-record", number="P36",
)

# Nesting

case(
    "MELDAS: four levels of subprograms are legal",
    control=MELDAS, source="source 004, note on levels", evidence="source document",
    program=chain(4), runs=way_in_and_out(4), calls="M98:O2 M98:O3 M98:O4 M98:O5",
)
case(
    "MELDAS: the fifth level is P230 and nothing of it runs",
    control=MELDAS, source="source 004, note on levels", evidence="source document",
    program=chain(5), runs=way_in(4), alarm="nesting-too-deep", number="P230", at="O5 N5",
)
case(
    "MELDAS: a level that was left may be used again",
    control=MELDAS, source="source 004, note on levels", evidence="source document",
    program=chain(4).replace("N101 M30", "N101 M98 P2\nN201 M30"),
    runs=f"{way_in_and_out(4)} N2 N3 N4 N5 N105 N104 N103 N102 N201",
)
case(
    "MELDAS: repeats are not levels",
    control=MELDAS, source="source 004, note on levels", evidence="inferred",
    program=chain(4, "M98 P{} L2").replace("N1 M98 P2 L2", "N1 M98 P2"),
    runs="N1 N2 N3 N4 N5 N105 N5 N105 N104 N4 N5 N105 N5 N105 N104 N103"
    " N3 N4 N5 N105 N5 N105 N104 N4 N5 N105 N5 N105 N104 N103 N102 N101",
)
case(
    "MELDAS: the words beside the call that is one level too deep have run",
    control=MELDAS, source="source 004, note on levels; SM (3)", evidence="inferred",
    program=chain(5).replace("N5 M98", "N5 T5 M98"),
    runs=way_in(5), t=[5], alarm="nesting-too-deep", number="P230", at="O5 N5",
)
case(
    "MELDAS: three subprograms and a macro are four levels",
    control=MELDAS, source="SM (6); source 004, note on levels", evidence="inferred",
    program=chain(4).replace("N4 M98 P5", "N4 G65 P5"), runs=way_in_and_out(4),
)
case(
    "MELDAS: a macro over four subprograms is P230",
    pins="nesting_counts_macros",
    control=MELDAS, source="SM (6); source 004, note on levels", evidence="inferred",
    program=chain(5).replace("N5 M98 P6", "N5 G65 P6"),
    runs=way_in(4), alarm="nesting-too-deep", number="P230", at="O5 N5",
)
case(
    "M700: eight levels of M98 are legal, all the way in and out",
    control=M700, source="SM (6); MZ 842", evidence="maker's manual",
    program=chain(8), runs=way_in_and_out(8),
)
case(
    "M700: the ninth M98 is P230",
    control=M700, source="SM (6); MZ 842", evidence="maker's manual",
    program=chain(9), runs=way_in(8), alarm="nesting-too-deep", number="P230", at="O9 N9",
)
case(
    "M800: ten levels of M98 are legal, all the way in and out",
    control=M800, source="CW", evidence="secondary",
    program=chain(10), runs=way_in_and_out(10),
)
case(
    "M800: the eleventh M98 is P230",
    control=M800, source="CW", evidence="secondary",
    program=chain(11), runs=way_in(10), alarm="nesting-too-deep", number="P230", at="O11 N11",
)
case(
    "M700: a self-call with H counts a level each time",
    control=M700, source="SM (6); IMD", evidence="inferred",
    program="""
        O1
        N10 M98 H30
        N20 M30
        N30 S3
        N40 M98 H30
        N50 M99
    """,
    runs="N10 (N30 N40)*7 N30", alarm="nesting-too-deep", number="P230", at="O1 N40",
)

# M198 and ,D

case(
    "M198 runs the program of the external device",
    pins="external_calls",
    control=NEWER, source="CW, M198", evidence="secondary",
    program="""
        O1
        N10 M198 P200
        N20 M30
    """,
    external={"O200.NC": "O200\nN210 S1\nN220 M99\n"},
    runs="N10 N210 N220 N20", calls="M198:O200",
)
case(
    "M198 repeats with L like M98",
    control=NEWER, source="CW, M198", evidence="inferred",
    program="""
        O1
        N10 M198 P200 L3
        N20 M30
    """,
    external={"O200.NC": "O200\nN210 M99\n"},
    runs="N10 N210*3 N20", calls="M198:O200",
)
case(
    "M198 starts at H like M98",
    control=NEWER, source="CW, M198", evidence="inferred",
    program="""
        O1
        N10 M198 P200 H220
        N20 M30
    """,
    external={"O200.NC": "O200\nN210 S1\nN220 M99\n"},
    runs="N10 N220 N20",
)
case(
    "an H that the external program does not have is P231",
    control=NEWER, source="CW, M198; source 004, note 2", evidence="inferred",
    program="""
        O1
        N10 M198 P200 H300
        N20 M30
    """,
    external={"O200.NC": "O200\nN210 S1\nN220 M99\n"},
    runs="", alarm="start-not-found", number="P231", at="O1 N10", word="H300",
)
case(
    "M198 takes the program of the device and M98 the one of the memory",
    control=NEWER, source="CW, M198", evidence="inferred",
    program="""
        O1
        N10 M198 P200
        N20 M98 P200
        N30 M30
        O200
        N210 M99
    """,
    external={"O200.NC": "O200\nN310 M99\n"},
    runs="N10 N310 N20 N210 N30", calls="M198:O200 M98:O200",
)
case(
    "a program that is not on the device is P232 even when the memory holds it",
    control=NEWER, source="source 004, note 1; CW", evidence="inferred",
    program="""
        O1
        N10 M198 P200
        N20 M30
        O200
        N210 M99
    """,
    external={"O300.NC": "O300\nN310 M99\n"},
    runs="", alarm="external-program-not-found", number="P232", at="O1 N10", word="P200",
)
case(
    "M98 does not look on the external device",
    control=NEWER, source="source 004, note 1; CW", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 M30
    """,
    external={"O200.NC": "O200\nN210 M99\n"},
    runs="", alarm="program-not-found", number="P232", at="O1 N10", word="P200",
)
case(
    "an external program cannot call an external program",
    control=NEWER, source="CW, nested M198; MZ 842", evidence="secondary",
    program="""
        O1
        N10 M198 P200
        N20 M30
    """,
    external={"O200.NC": "O200\nN210 M198 P300\nN220 M99\n", "O300.NC": "O300\nN310 M99\n"},
    runs="N10", alarm="external-call-nested", number="P230", at="O200 N210",
)
case(
    "an external program may call a program of the memory",
    control=NEWER, source="CW, nested M198", evidence="inferred",
    program="""
        O1
        N10 M198 P200
        N20 M30
        O300
        N310 M99
    """,
    external={"O200.NC": "O200\nN210 M98 P300\nN220 M99\n"},
    runs="N10 N210 N310 N220 N20", calls="M198:O200 M98:O300",
)
case(
    "a program of the memory cannot call the device while an external program is open",
    control=NEWER, source="CW, nested M198; MZ 842", evidence="inferred",
    program="""
        O1
        N10 M198 P200
        N20 M30
        O300
        N310 M198 P400
        N320 M99
    """,
    external={"O200.NC": "O200\nN210 M98 P300\nN220 M99\n", "O400.NC": "O400\nN410 M99\n"},
    runs="N10 N210", alarm="external-call-nested", number="P230", at="O300 N310",
)
case(
    "one external program after the other is no nesting",
    control=NEWER, source="CW, M198", evidence="inferred",
    program="""
        O1
        N10 M198 P200
        N20 M198 P300
        N30 M30
    """,
    external={"O200.NC": "O200\nN210 M99\n", "O300.NC": "O300\nN310 M99\n"},
    runs="N10 N210 N20 N310 N30", calls="M198:O200 M198:O300",
)
case(
    "M99 P of an external program returns to a block of the caller in memory",
    control=NEWER, source="source 004, M99 P; CW", evidence="inferred",
    program="""
        O1
        N10 M198 P200
        N20 S2
        N30 M30
    """,
    external={"O200.NC": "O200\nN210 M99 P30\n"},
    runs="N10 N210 N30",
)
case(
    "an external program without M99 is P36",
    control=NEWER, source="SK P36", evidence="inferred",
    program="""
        O1
        N10 M198 P200
        N20 M30
    """,
    external={"O200.NC": "O200\nN210 S1\n"},
    runs="N10 N210", alarm="end-of-record", number="P36",
)
case(
    "M700: an external program is one of the eight levels",
    control=M700, source="MZ 842; SM (6)", evidence="inferred",
    program=chain(9).replace("N1 M98 P2", "N1 M198 P2").replace("O2\nN2", "O20\nN20"),
    external={"O2.NC": "O2\nN2 M98 P3\nN102 M99\n"},
    runs=way_in(8), alarm="nesting-too-deep", number="P230", at="O9 N9",
)
case(
    "M198 of a file name looks for the file on the device",
    pins="name_marks",
    control=NEWER, source="CW, M198; IMD", evidence="inferred",
    program="""
        O1
        N10 M198 <POCKET.NC> L2
        N20 M30
    """,
    external={"POCKET.NC": "N210 M99\n"},
    runs="N10 N210*2 N20",
)
case(
    "a file name that the device does not hold is P232",
    control=NEWER, source="CW, M198; IMD", evidence="inferred",
    program="""
        O1
        N10 M198 <POCKET.NC>
        N20 M30
    """,
    external={"O200.NC": "O200\nN210 M99\n"},
    runs="", alarm="external-program-not-found", number="P232", at="O1 N10",
)
case(
    "M198 calls nothing on MELDAS, it is an M code for the machine",
    control=MELDAS, source="general knowledge, no M198", evidence="inferred",
    program="""
        O1
        N10 M198
        N20 M30
    """,
    external={"O200.NC": "O200\nN210 M99\n"},
    runs="N10 N20", m=[198], calls="",
)
case(
    "M98 with ,D1 takes the program from the device",
    pins="device_word",
    control=NEWER, source="IMD, ,D", evidence="inferred",
    program="""
        O1
        N10 M98 P200 ,D1
        N20 M30
        O200
        N210 M99
    """,
    external={"O200.NC": "O200\nN310 M99\n"},
    runs="N10 N310 N20",
)
case(
    "M98 with ,D1 and a program that is not on the device is P232",
    control=NEWER, source="IMD, ,D; source 004, note 1", evidence="inferred",
    program="""
        O1
        N10 M98 P200 ,D1
        N20 M30
        O200
        N210 M99
    """,
    external={"O300.NC": "O300\nN310 M99\n"},
    runs="", alarm="external-program-not-found", number="P232", at="O1 N10",
)
case(
    "a device number above 4 is over the range",
    control=NEWER, source="IMD, ,D 0 to 4; SK P35", evidence="inferred",
    program="""
        O1
        N10 M98 P200 ,D5
        N20 M30
        O200
        N210 M99
    """,
    runs="", alarm="value-out-of-range", number="P35", at="O1 N10",
)
case(
    "MELDAS has no ,D",
    control=MELDAS, source="IMD, ,D; SK P32", evidence="inferred",
    program="""
        O1
        N10 M98 P200 ,D1
        N20 M30
        O200
        N210 M99
    """,
    runs="", alarm="address-not-usable", number="P32", at="O1 N10",
)

# MDI

case(
    "a Mitsubishi calls a program of the memory from MDI",
    control=EVERY, source="general knowledge", evidence="inferred",
    program="""
        O200
        N210 S1
        N220 M99
    """,
    mdi="N10 M98 P200 L2\nN20 M30", runs="N10 (N210 N220)*2 N20", calls="M98:O200",
)
case(
    "a call in MDI of a program that is missing is P232",
    control=EVERY, source="source 004, note 1", evidence="inferred",
    program="""
        O200
        N210 M99
    """,
    mdi="N10 M98 P300", runs="", alarm="program-not-found", number="P232", word="P300",
)
case(
    "from the M700 on an M98 H in MDI calls the MDI text itself",
    control=NEWER, source="IMD, P omitted: memory and MDI", evidence="secondary",
    program="""
        O200
        N210 M99
    """,
    mdi="N10 M98 H30\nN20 M30\nN30 S3\nN40 M99", runs="N10 N30 N40 N20",
)
case(
    "M99 in MDI goes back to the head of the MDI text",
    control=EVERY, source="general knowledge", evidence="inferred",
    program="""
        O200
        N210 M99
    """,
    mdi="N10 S1\nN20 M99", max_cycles=2, runs="(N10 N20)*2", stop="cycles",
)
case(
    "MELDAS: calls from MDI nest to four levels too",
    control=MELDAS, source="source 004, note on levels", evidence="inferred",
    program=chain(5), mdi="N10 M98 P2", runs="N10 N2 N3 N4",
    alarm="nesting-too-deep", number="P230", at="O5 N5",
)

# Names of files

case(
    "M98 with a file name calls the file",
    control=NEWER, source="IMD, <file name>", evidence="secondary",
    files={"O1.NC": "O1\nN10 M98 <POCKET.NC>\nN20 M30\n", "POCKET.NC": "N210 S1\nN220 M99\n"},
    main="O1", runs="N10 N210 N220 N20",
)
case(
    "M98 with a file name takes H and L",
    control=NEWER, source="IMD, <file name>", evidence="secondary",
    files={"O1.NC": "O1\nN10 M98 <POCKET.NC> H220 L2\nN20 M30\n",
           "POCKET.NC": "N210 S1\nN220 M99\n"},
    main="O1", runs="N10 N220*2 N20",
)
case(
    "a file name that is not in the memory is P232",
    control=NEWER, source="IMD2; source 004, note 1", evidence="inferred",
    files={"O1.NC": "O1\nN10 M98 <SLOT.NC>\nN20 M30\n", "POCKET.NC": "N210 M99\n"},
    main="O1", runs="", alarm="named-program-not-found", number="P232", at="O1 N10",
)
case(
    "an H that the named file does not have is P231",
    control=NEWER, source="IMD, <file name>; source 004, note 2", evidence="inferred",
    files={"O1.NC": "O1\nN10 M98 <POCKET.NC> H300\nN20 M30\n", "POCKET.NC": "N210 M99\n"},
    main="O1", runs="", alarm="start-not-found", number="P231", at="O1 N10", word="H300",
)
case(
    "a file name of 32 characters is callable",
    pins="max_name_length",
    control=NEWER, source="IMD, 32 characters with the extension", evidence="secondary",
    files={"O1.NC": "O1\nN10 M98 <ABCDEFGHIJKLMNOPQRSTUVWXYZ012.NC>\nN20 M30\n",
           "ABCDEFGHIJKLMNOPQRSTUVWXYZ012.NC": "N210 M99\n"},
    main="O1", runs="N10 N210 N20",
)
case(
    "a file name of 33 characters is P232 although the file is there",
    control=NEWER, source="IMD, 32 characters with the extension; general knowledge",
    evidence="inferred",
    files={"O1.NC": "O1\nN10 M98 <ABCDEFGHIJKLMNOPQRSTUVWXYZ0123.NC>\nN20 M30\n",
           "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123.NC": "N210 M99\n"},
    main="O1", runs="", alarm="illegal-program-name", number="P232", at="O1 N10",
)
case(
    "MELDAS knows no file names in angle brackets",
    control=MELDAS, source="IMD, <file name>; SK P32", evidence="inferred",
    program="""
        O1
        N10 M98 <POCKET.NC>
        N20 M30
    """,
    runs="", alarm="illegal-character", number="P32", at="O1 N10",
)
case(
    "a file without O is called by the number that is its name",
    control=EVERY, source="general knowledge", evidence="inferred",
    files={"O1.NC": "O1\nN10 M98 P300\nN20 M30\n", "300.NC": "N310 S1\nN320 M99\n"},
    main="O1", runs="N10 N310 N320 N20",
)
case(
    "a file name with O and leading zeros answers to its number",
    control=NEWER, source="general knowledge; IMD2", evidence="inferred",
    files={"O1.NC": "O1\nN10 M98 P300\nN20 M30\n", "O0300.NC": "N310 M99\n"},
    main="O1", runs="N10 N310 N20",
)
case(
    "from the M700 on the file's name is called and not the O inside",
    pins="file_name_wins",
    control=NEWER, source="IMD2", evidence="secondary",
    files={"O1.NC": "O1\nN10 M98 P200\nN20 M30\n", "200.NC": "O300\nN310 M99\n"},
    main="O1", runs="N10 N310 N20",
)
case(
    "from the M700 on the O inside a file does not answer a call",
    control=NEWER, source="IMD2; source 004, note 1", evidence="secondary",
    files={"O1.NC": "O1\nN10 M98 P300\nN20 M30\n", "200.NC": "O300\nN310 M99\n"},
    main="O1", runs="", alarm="program-not-found", number="P232", at="O1 N10", word="P300",
)
case(
    "from the M700 on files with the same O inside are two programs",
    control=NEWER, source="IMD2", evidence="secondary",
    files={"O1.NC": "O1\nN10 M98 P200\nN20 M98 P201\nN30 M30\n", "200.NC": "O7\nN210 M99\n",
           "201.NC": "O7\nN310 M99\n"},
    main="O1", runs="N10 N210 N20 N310 N30",
)
case(
    "MELDAS calls by the O inside the file",
    pins="file_name_wins",
    control=MELDAS, source="general knowledge", evidence="inferred",
    files={"O1.NC": "O1\nN10 M98 P300\nN20 M30\n", "200.NC": "O300\nN310 M99\n"},
    main="O1", runs="N10 N310 N20", calls="M98:O300",
)
case(
    "MELDAS does not call by the file's name where the file has an O",
    control=MELDAS, source="general knowledge; source 004, note 1", evidence="inferred",
    files={"O1.NC": "O1\nN10 M98 P200\nN20 M30\n", "200.NC": "O300\nN310 M99\n"},
    main="O1", runs="", alarm="program-not-found", number="P232", at="O1 N10", word="P200",
)

# Block skip and start

case(
    "a skipped M98 calls nothing, whatever it names",
    control=EVERY, source="general knowledge", evidence="inferred",
    program="""
        O1
        N10 S1
        /2 N20 M98 P999
        N30 M30
    """,
    skip=(2,), runs="N10 N30", calls="",
)
case(
    "a call behind a block skip whose switch is off is made",
    control=EVERY, source="general knowledge; source 004, note 1", evidence="inferred",
    program="""
        O1
        N10 S1
        /2 N20 M98 P999
        N30 M30
    """,
    skip=(1,), runs="N10", alarm="program-not-found", number="P232", at="O1 N20", word="P999",
)
case(
    "a run that starts at a sequence number makes only the calls behind it",
    control=EVERY, source="general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P999
        N20 M98 P200
        N30 M30
        O200
        N210 M99
    """,
    start=20, runs="N20 N210 N30", calls="M98:O200",
)
