"""GSK: macro calls, type A statements (G65 H) and macro statements (988TA, 988T, 980TDi, 980MDi).

Source tags: TA27 is the 988TA section on G65, G66 and the codes that call macros; TApar the 988TA
parameter list; Talm the 988T alarm list (its numbers are taken for the 988TA too); TDi28, TDi29 and
TDi32 are the 980TDi sections on macro codes, statements and G codes that call; MDia and MDib the
980MDi alarm lists (taken for the 980TDi too); source 000 is the 988TA chapter on subprogram calls.
"""

from conformance import case

TA, T, TDI, MDI = "gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi"
FAMILY_988 = [TA, T]
FAMILY_980 = [TDI, MDI]
FAMILIES = [TA, T, TDI, MDI]

SOURCE = "source document"
MANUAL = "maker's manual"
SECONDARY = "secondary"
INFERRED = "inferred"


def both(number_988, number_980):
    """One alarm number for the 988s, and one for the 980s."""
    return {TA: number_988, T: number_988, TDI: number_980, MDI: number_980}


def macro_call(call, macro="N30 M99", name="O2"):
    """A main program O1 of one macro call, and the macro."""
    return f"O1\nN10 {call}\nN20 M30\n{name}\n{macro}\n"


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


# --- G65: arguments --------------------------------------------------------------------------------

LETTERS = "A1 B2 C3 D7 E8 F9 H11 I4 J5 K6 M13 Q17 R18 S19 T20 U21 V22 W23 X24 Y25 Z26"
TRIPLES = " ".join(f"{letter}{4 + 3 * k + i}" for k in range(10) for i, letter in enumerate("IJK"))

case(
    "GSK: each letter of argument I sets the variable of the manual's table",
    pins="whole_numbers macro_calls",
    control=FAMILIES, source="TA27, argument I; TDi28, argument I", evidence=MANUAL,
    program=macro_call(f"G65 P2 {LETTERS}"),
    runs="N10 N30 N20", calls="G65:O2",
    arguments={int(word[1:]): int(word[1:]) for word in LETTERS.split()},
)
case(
    "GSK: the letters of argument I may come in any order",
    control=FAMILIES, source="TA27, argument list; TDi28", evidence=MANUAL,
    program=macro_call("G65 P2 Z26 D7 A1"),
    runs="N10 N30 N20", arguments={1: 1, 7: 7, 26: 26},
)
case(
    "GSK: ten triples of I, J and K set #4 to #33",
    pins="argument_sets",
    control=FAMILIES, source="TA27, argument II; TDi28, argument II", evidence=MANUAL,
    program=macro_call(f"G65 P2 {TRIPLES}"),
    runs="N10 N30 N20", arguments={k: k for k in range(4, 34)},
)
case(
    "GSK: A, B and C stand in front of the triples",
    control=FAMILIES, source="TA27, argument II; TDi28, argument II", evidence=MANUAL,
    program=macro_call("G65 P2 A1 B2 C3 I4 J5 K6 I7"),
    runs="N10 N30 N20", arguments={1: 1, 2: 2, 3: 3, 4: 4, 5: 5, 6: 6, 7: 7},
)
case(
    "GSK 988: the manual's example: I, J and K are counted letter by letter",
    control=FAMILY_988, source="TA27, example of argument II", evidence=MANUAL,
    program=macro_call("G65 P0012 J12 K22 J25 I33 J32", name="O0012"),
    runs="N10 N30 N20", arguments={4: 33, 5: 12, 6: 22, 8: 25, 11: 32, 7: None},
)
case(
    "GSK: the second K is #9 even when no I or J stands with it",
    control=FAMILIES, source="TA27, argument II; TDi28, argument II", evidence=MANUAL,
    program=macro_call("G65 P2 K1 K2 K3"),
    runs="N10 N30 N20", arguments={6: 1, 9: 2, 12: 3, 4: None, 5: None},
)
case(
    "GSK: of a letter and a triple that mean one variable the triple behind it wins",
    control=FAMILIES, source="TA27, mixed arguments; TDi28, note 3", evidence=MANUAL,
    program=macro_call("G65 P2 D70 I40 I71"),
    runs="N10 N30 N20", arguments={4: 40, 7: 71},
)
case(
    "GSK: of a triple and a letter that mean one variable the letter behind it wins",
    control=FAMILIES, source="TA27, mixed arguments; TDi28, note 3", evidence=MANUAL,
    program=macro_call("G65 P2 I40 I71 D70"),
    runs="N10 N30 N20", arguments={4: 40, 7: 70},
)
case(
    "GSK: an argument that is left out is vacant",
    control=FAMILIES, source="TA27, argument list; TDi28, note", evidence=MANUAL,
    program=macro_call("G65 P2 B5"),
    runs="N10 N30 N20", arguments={1: None, 2: 5, 3: None, 33: None},
)
case(
    "GSK: an argument is taken with its sign and its decimals",
    control=FAMILIES, source="TA27; TDi28", evidence=MANUAL,
    program=macro_call("G65 P2 A-12.5 B0.25 U-0.01"),
    runs="N10 N30 N20", arguments={1: -12.5, 2: 0.25, 21: -0.01},
)
case(
    "GSK: an argument may be a variable",
    pins="statements",
    control=FAMILIES, source="TA27; TDi28", evidence=INFERRED,
    program=macro_call("G65 P2 A#100 B-#100"),
    variables={100: 7.5}, runs="N10 N30 N20", arguments={1: 7.5, 2: -7.5},
)
case(
    "GSK: an argument may be an expression",
    control=FAMILIES, source="TA27; TDi28", evidence=INFERRED,
    program=macro_call("G65 P2 A[#100*2+1]"),
    variables={100: 7.5}, runs="N10 N30 N20", arguments={1: 16},
)
case(
    "GSK: a local of the caller may be passed on",
    control=FAMILIES, source="TA27, note 4; TDi28", evidence=INFERRED,
    program="O1\nN5 #3=9\nN10 G65 P2 A#3\nN20 M30\nO2\nN30 M99\n",
    runs="N5 N10 N30 N20", arguments={1: 9, 3: None}, vars={3: 9, 1: None},
)
case(
    "GSK 988TA: X1, Y1, Z1, X2, Y2 and Z2 set #27 to #32",
    pins="numbered_axis_arguments",
    control=TA, source="TA27, argument I; the form X1= is general knowledge", evidence=INFERRED,
    program=macro_call("G65 P2 X1=27.5 Y1=28.5 Z1=29.5 X2=30.5 Y2=31.5 Z2=32.5"),
    runs="N10 N30 N20",
    arguments={24: None, 27: 27.5, 28: 28.5, 29: 29.5, 30: 30.5, 31: 31.5, 32: 32.5},
)
case(
    "GSK 980TDi: the manual's example of mixed arguments: the later K is #6",
    control=TDI, source="TDi28, example", evidence=MANUAL,
    program=macro_call("G65 P9010 I14 J15 I6 J7 K9 K11 K12 J30 A1 B2 C3", name="O9010"),
    runs="N10 N30 N20",
    arguments={1: 1, 2: 2, 3: 3, 4: 14, 5: 15, 7: 6, 8: 7, 6: 9, 9: 11, 12: 12, 11: 30, 10: None},
)
case(
    "GSK 980TDi: a letter given twice counts as it is given last",
    control=TDI, source="TDi28, argument I", evidence=MANUAL,
    program=macro_call("G65 P2 A1 A5"),
    runs="N10 N30 N20", arguments={1: 5},
)
case(
    "GSK 988: with 3403#6=0 a letter given twice counts as it is given last",
    control=FAMILY_988, source="TApar 3403; TA27, note 1", evidence=INFERRED, params={"3403#6": 0},
    program=macro_call("G65 P2 A1 A5"),
    runs="N10 N30 N20", arguments={1: 5},
)
case(
    "GSK 988: with 3403#6=1 a letter given twice is refused",
    control=FAMILY_988, source="TApar 3403; Talm 010", evidence=INFERRED, params={"3403#6": 1},
    program=macro_call("G65 P2 A1 A5"),
    runs="", alarm="address-given-twice", number="010", at="O1 N10",
)
case(
    "GSK 988: with 3403#6=1 a second I is still the I of the next triple",
    control=FAMILY_988, source="TApar 3403; TA27, argument II", evidence=INFERRED,
    params={"3403#6": 1},
    program=macro_call("G65 P2 I1 I2"),
    runs="N10 N30 N20", arguments={4: 1, 7: 2},
)
for letter in "IJK":
    case(
        f"GSK 980: eleven {letter} are too many",
        control=FAMILY_980, source="MDia 118", evidence=MANUAL,
        program=macro_call("G65 P2" + f" {letter}1" * 11),
        runs="", alarm="too-many-argument-sets", number="0118", at="O1 N10",
    )
case(
    "GSK 980: eleven I are too many for G66 too",
    control=FAMILY_980, source="MDib 118", evidence=MANUAL,
    program=macro_call("G66 P2" + " I1" * 11),
    runs="", alarm="too-many-argument-sets", number="0118", at="O1 N10",
)
case(
    "GSK 988: G is no argument",
    pins="codes_not_with_macro_call",
    control=FAMILY_988, source="TA27, argument I; Talm 212", evidence=SECONDARY,
    program=macro_call("G65 P2 A1 G1"),
    runs="", alarm="code-with-macro-call", number="212", at="O1 N10",
)

# --- G65: levels of local variables ----------------------------------------------------------------

case(
    "GSK: a macro has local variables of its own, and the caller finds its own again",
    control=FAMILIES, source="TA27, note 4; TDi28", evidence=MANUAL,
    program="""
        O1
        N10 #1=5
        N20 G65 P2 A7
        N30 M30
        O2
        N40 #1=#1+1
        N50 #2=99
        N60 #100=#1
        N70 M99
    """,
    runs="N10 N20 N40 N50 N60 N70 N30", vars={1: 5, 2: None, 100: 8},
)
case(
    "GSK: each level of macros keeps its local variables",
    control=FAMILIES, source="TA27, note 4; TDi28", evidence=MANUAL,
    program="""
        O1
        N10 #1=1
        N20 G65 P2 A2
        N30 #101=#1
        N40 M30
        O2
        N50 G65 P3 A3
        N60 #102=#1
        N70 M99
        O3
        N80 #103=#1
        N90 M99
    """,
    runs="N10 N20 N50 N80 N90 N60 N70 N30 N40", vars={101: 1, 102: 2, 103: 3},
)
case(
    "GSK 980: M98 does not change the level of the local variables",
    pins="call_passes_words",
    control=FAMILY_980, source="TDi28, difference of G65 and M98 (2)", evidence=MANUAL,
    program="O1\nN10 #1=5\nN20 M98 P2\nN30 M30\nO2\nN40 #1=#1+1\nN50 M99\n",
    runs="N10 N20 N40 N50 N30", vars={1: 6},
)
case(
    "GSK 988: M98 opens no level of local variables",
    pins="call_passes_words",
    control=FAMILY_988, source="TA27, note 4", evidence=INFERRED,
    program="O1\nN10 #1=5\nN20 M98 P2\nN30 M30\nO2\nN40 #1=#1+1\nN50 M99\n",
    runs="N10 N20 N40 N50 N30", vars={1: 6},
)
case(
    "GSK: common variables are the same in every macro",
    control=FAMILIES, source="TDi28, variables; K", evidence=MANUAL,
    program="O1\nN10 #100=5\nN20 G65 P2\nN30 M30\nO2\nN40 #100=#100*2\nN50 M99\n",
    runs="N10 N20 N40 N50 N30", vars={100: 10},
)

# --- G65: P and L ------------------------------------------------------------------------------------

case(
    "GSK: G65 repeats L times",
    pins="max_macro_digits",
    control=FAMILIES, source="TA27; TDi28, example G65 P1200 L2", evidence=MANUAL,
    program=macro_call("G65 P1200 L2", name="O1200"),
    runs="N10 N30*2 N20", calls="G65:O1200",
)
case(
    "GSK 988: P and L of G65 may stand among the arguments",
    control=FAMILY_988, source="TA27, note 1", evidence=MANUAL,
    program=macro_call("G65 A1 P2 B2 L3 C3"),
    runs="N10 N30*3 N20", arguments={1: 1, 2: 2, 3: 3},
)
case(
    "GSK 988: with 3403#6=0 the last P and the last L of G65 count",
    control=FAMILY_988, source="TA27, note 1", evidence=MANUAL, params={"3403#6": 0},
    program=macro_call("G65 P3 L4 P2 L2"),
    runs="N10 N30*2 N20", calls="G65:O2",
)
case(
    "GSK 988: with 3403#6=1 a second P of G65 is refused",
    control=FAMILY_988, source="TA27, note 1; Talm 010", evidence=MANUAL, params={"3403#6": 1},
    program=macro_call("G65 P3 P2"),
    runs="", alarm="address-given-twice", number="010", at="O1 N10",
)
case(
    "GSK 988: with 3403#6=1 a second L of G65 is refused",
    control=FAMILY_988, source="TA27, note 1; Talm 010", evidence=MANUAL, params={"3403#6": 1},
    program=macro_call("G65 P2 L2 L3"),
    runs="", alarm="address-given-twice", number="010", at="O1 N10",
)
case(
    "GSK 988: with 3403#6=1 a second P of G66 is refused",
    control=FAMILY_988, source="TA27, G66 note 2; Talm 010", evidence=MANUAL, params={"3403#6": 1},
    program=macro_call("G66 P3 P2"),
    runs="", alarm="address-given-twice", number="010", at="O1 N10",
)
case(
    "GSK 988TA: an L of G65 above 9999 is held at 9999",
    control=TA, source="TA27 p.1 (4)", evidence=MANUAL,
    program=macro_call("G65 P2 L10000"),
    runs="N10 N30*9999 N20",
)
case(
    "GSK 988TA: an L of G65 below zero is refused",
    control=TA, source="TA27 p.1 (4); number from Talm 003", evidence=MANUAL,
    program=macro_call("G65 P2 L-1"),
    runs="", alarm="illegal-repeat-count", number="003", at="O1 N10", word="L-1",
)
case(
    "GSK 988TA: an L variable of G65 drops its decimals",
    control=TA, source="TA27 p.1 (3)", evidence=MANUAL,
    program=macro_call("G65 P2 L#100"),
    variables={100: 3.8}, runs="N10 N30*3 N20",
)
case(
    "GSK 988TA: an L variable of G65 below zero is refused",
    control=TA, source="TA27 p.1 (4); number from Talm 003", evidence=MANUAL,
    program=macro_call("G65 P2 L#100"),
    variables={100: -2}, runs="", alarm="illegal-repeat-count", number="003", at="O1 N10",
)
case(
    "GSK 988TA: an L variable of G65 above 9999 is held at 9999",
    control=TA, source="TA27 p.1 (4)", evidence=MANUAL,
    program=macro_call("G65 P[O0002] L#100"),
    variables={100: 54321}, runs="N10 N30*9999 N20",
)
case(
    "GSK 988TA: G65 P#100 drops the decimals of its variable",
    control=TA, source="TA27 p.1 (1)", evidence=MANUAL,
    program=macro_call("G65 P#100 L2 A6"),
    variables={100: 2.9}, runs="N10 N30*2 N20", calls="G65:O2", arguments={1: 6},
)
case(
    "GSK 988TA: G65 P[#100] is the standard program of that number",
    control=TA, source="TA27 p.1, format 2", evidence=MANUAL,
    program=macro_call("G65 P[#100] L2", name="O1003"),
    variables={100: 1003.5}, runs="N10 N30*2 N20", calls="G65:O1003",
)
case(
    "GSK 988TA: G65 P[O1004] is the standard program O1004",
    control=TA, source="TA27 p.1, format 2", evidence=MANUAL,
    program=macro_call("G65 P[O1004] L3", name="O1004"),
    runs="N10 N30*3 N20", calls="G65:O1004",
)
case(
    "GSK 988TA: G65 P[SLOT_2] is a program with a name of its own",
    control=TA, source="TA27 p.1, format 2", evidence=MANUAL,
    files={"O1.CNC": "O1\nN10 G65 P[SLOT_2] A3\nN20 M30\n", "SLOT_2.CNC": "N30 M99\n"},
    main="O1", runs="N10 N30 N20", calls="G65:SLOT_2", arguments={1: 3},
)
case(
    "GSK 980TDi: with 878=1 G65 calls a program by its name",
    control=TDI, source="TDi28, format 2", evidence=MANUAL, params={"878": 1},
    files={"O1.CNC": "O1\nN10 G65 P[CUT] L2 A3\nN20 M30\n", "CUT.CNC": "N30 M99\n"},
    main="O1", runs="N10 N30*2 N20", calls="G65:CUT", arguments={1: 3},
)
case(
    "GSK 988TA: G65 P[#100] of five digits is refused",
    control=TA, source="TA27 p.1, format 2", evidence=MANUAL,
    program=macro_call("G65 P[#100]"),
    variables={100: 10002}, runs="", alarm="illegal-macro-number", number="291", at="O1 N10",
)
case(
    "GSK 988TA: G66 P[#100] of five digits is refused",
    control=TA, source="TA27 p.6, format 2", evidence=MANUAL,
    program="O1\nN10 G66 P[#100]\nN20 G0 X50\nN30 M30\nO2\nN40 M99\n",
    variables={100: 21234}, runs="", alarm="illegal-macro-number", number="291", at="O1 N10",
)
case(
    "GSK 988TA: G65 P#100 of five digits is refused, it holds no count",
    control=TA, source="TA27 p.1 (1)", evidence=INFERRED,
    program=macro_call("G65 P#100"),
    variables={100: 20002}, runs="", alarm="illegal-macro-number", number="291", at="O1 N10",
)
case(
    "GSK 988TA: there is no arithmetic in the brackets of G65's P",
    control=TA, source="TA27 p.1, format 2 (1)", evidence=MANUAL,
    program=macro_call("G65 P[#100*2]"),
    variables={100: 1}, runs="", alarm="illegal-program-name", at="O1 N10",
)
case(
    "GSK 980: G65 calls no program above 9999",
    control=FAMILY_980, source="MDia 119", evidence=MANUAL,
    program=macro_call("G65 P10002 A1"),
    runs="", alarm="illegal-macro-number", number="0119", at="O1 N10",
)
case(
    "GSK 980: G65 does not call program 0",
    control=FAMILY_980, source="MDib 119", evidence=MANUAL,
    program=macro_call("G65 P0 A1", name="O0000"),
    runs="", alarm="illegal-macro-number", number="0119", at="O1 N10",
)
case(
    "GSK 988: G65 without P is refused",
    pins="h_codes",
    control=FAMILY_988, source="Talm 081", evidence=SECONDARY,
    program=macro_call("G65 A1"),
    runs="", alarm="program-number-missing", number="081", at="O1 N10",
)
case(
    "GSK 988: G66 without P is refused",
    control=FAMILY_988, source="Talm 081", evidence=SECONDARY,
    program=macro_call("G66 L2 A1"),
    runs="", alarm="program-number-missing", number="081", at="O1 N10",
)
case(
    "GSK: the macro of G65 may be missing",
    control=FAMILIES, source="Talm 083; MDia 001", evidence=SECONDARY,
    program=macro_call("G65 P3 A1"),
    runs="", alarm="program-not-found", number=both("083", "0001"), at="O1 N10",
)
case(
    "GSK 988: a macro cannot call itself",
    control=FAMILY_988, source="Talm 084", evidence=SECONDARY,
    program=macro_call("G65 P2", "N30 G65 P2\nN40 M99"),
    runs="N10", alarm="program-calls-itself", number="084", at="O2 N30",
)
case(
    "GSK 988: a macro cannot call the main program",
    control=FAMILY_988, source="Talm 084", evidence=SECONDARY,
    program=macro_call("G65 P2", "N30 G65 P1\nN40 M99"),
    runs="N10", alarm="program-calls-caller", number="084", at="O2 N30",
)
case(
    "GSK: M99 P of a macro names a block of the caller",
    control=FAMILIES, source="source 000, M99; MDia 112", evidence=INFERRED,
    program="O1\nN10 G65 P2\nN20 G0 X2\nN30 M30\nO2\nN40 M99 P30\n",
    runs="N10 N40 N30",
)
case(
    "GSK: M99 P of a macro to a block that the caller does not have is an alarm",
    control=FAMILIES, source="source 000, note 1; Talm 083; MDia 112", evidence=SECONDARY,
    program=macro_call("G65 P2", "N40 M99 P90"),
    runs="N10", alarm="return-target-not-found", number=both("083", "0112"), at="O2 N40",
)

# --- G65: what may not share its block -------------------------------------------------------------------

for words in ("G0 X1", "M3", "G1"):
    case(
        f"GSK 988: {words} and G65 may not share a block",
        pins="words_before_macro_call",
        control=FAMILY_988, source="TA27, note 3; Talm 212", evidence=SECONDARY,
        program=macro_call(f"{words} G65 P2"),
        runs="", alarm="macro-call-not-first", number="212", at="O1 N10",
    )
case(
    "GSK 988: NC words and G66 may not share a block",
    control=FAMILY_988, source="TA27, note 3; Talm 212", evidence=SECONDARY,
    program=macro_call("G0 X1 G66 P2"),
    runs="", alarm="macro-call-not-first", number="212", at="O1 N10",
)
case(
    "GSK 988TA: the N of a macro call must stand first",
    pins="sequence_number_first late_sequence_numbers",
    control=TA, source="TA27, note 6", evidence=MANUAL,
    program="O1\nN10 G0 X1\nG65 P2 N20\nN30 M30\nO2\nN40 M99\n",
    runs="N10", alarm="sequence-number-not-first", at="O1 N20",
)
for call in ("G65 P2", "G66 P2"):
    case(
        f"GSK 980: {call[:3]} must be the first word of its block",
        pins="words_before_macro_call",
        control=FAMILY_980, source="MDia 114", evidence=MANUAL,
        program=macro_call(f"X1 {call}"),
        runs="", alarm="macro-call-not-first", number="0114", at="O1 N10",
    )
for code in ("M00", "M01", "M02", "M30", "M98", "M99"):
    case(
        f"GSK 980MDi: {code} may not share a block with G65",
        pins="m_codes_not_with_macro_call",
        control=MDI, source="MDib 116", evidence=MANUAL,
        program=macro_call(f"G65 P2 A1 {code}"),
        runs="", alarm="m-code-with-macro-call", number="0116", at="O1 N10",
    )
for code in ("G43", "G44", "G49"):
    case(
        f"GSK 980MDi: {code} may not share a block with G65",
        pins="codes_not_with_macro_call",
        control=MDI, source="MDib 115", evidence=MANUAL,
        program=macro_call(f"G65 P2 A1 {code}"),
        runs="", alarm="code-with-macro-call", number="0115", at="O1 N10",
    )

# --- Nesting of macros -------------------------------------------------------------------------------

M98, G65 = "M98 P{}", "G65 P{}"

case(
    "GSK: four levels of macros are legal",
    pins="max_macro_nesting",
    control=FAMILIES, source="TA27, note 2; TDi28, nesting", evidence=MANUAL,
    program=chain([G65] * 4), runs=chain_through(4), calls="G65:O2 G65:O3 G65:O4 G65:O5",
)
case(
    "GSK 988: the fifth level of macros is an alarm",
    control=FAMILY_988, source="TA27, note 2; Talm 207", evidence=SECONDARY,
    program=chain([G65] * 5), runs=chain_down(4), alarm="macro-nesting-too-deep", number="207",
    at="O5 N50",
)
case(
    "GSK 988: subprograms between the macros do not count among the four",
    control=FAMILY_988, source="TA27, note 2", evidence=MANUAL,
    program=chain([G65, M98, G65, M98, G65, M98, G65]), runs=chain_through(7),
)
case(
    "GSK 988: the fifth macro is one too many with subprograms in between",
    control=FAMILY_988, source="TA27, note 2; Talm 207", evidence=SECONDARY,
    program=chain([G65, M98, G65, M98, G65, M98, G65, M98, G65]), runs=chain_down(8),
    alarm="macro-nesting-too-deep", number="207", at="O9 N90",
)
case(
    "GSK 988: macros one behind the other do not add up",
    control=FAMILY_988, source="TA27, note 2", evidence=MANUAL,
    program="O1\nN10 G65 P2\nN20 G65 P2\nN30 G65 P2\nN40 G65 P2\nN50 G65 P2\nN60 M30\nO2\nN70 M99\n",
    runs="N10 N70 N20 N70 N30 N70 N40 N70 N50 N70 N60",
)
case(
    "GSK 988: a modal call is a level among the four",
    control=FAMILY_988, source="TA27, note 2; Talm 207", evidence=SECONDARY,
    program="""
        O1
        N10 G66 P2
        N11 G0 X50
        N12 M30
        O2
        N20 G65 P3
        N21 M99
        O3
        N30 G65 P4
        N31 M99
        O4
        N40 G65 P5
        N41 M99
        O5
        N50 G65 P6
        N51 M99
        O6
        N60 M99
    """,
    runs="N10 N11 N20 N30 N40", alarm="macro-nesting-too-deep", number="207", at="O5 N50",
)
case(
    "GSK 988TA: an M code that calls is a level among the four",
    control=TA, source="TA27 p.10, note 4; Talm 207", evidence=MANUAL,
    params={"6008#6": 1, "6080": 31},
    program=chain([G65] * 4 + ["M31"]) + "O9020\nN90 M99\n", runs=chain_down(4),
    alarm="macro-nesting-too-deep", number="207", at="O5 N50",
)

# --- G66 and G67 ---------------------------------------------------------------------------------------

MACRO = "O2\nN90 M99\n"

case(
    "GSK: the block of G66 does not call",
    control=FAMILIES, source="TA27, G66 note 3; TDi28, G66 (1)", evidence=MANUAL,
    program="O1\nN10 G66 P2\nN20 G67\nN30 M30\n" + MACRO,
    runs="N10 N20 N30", calls="",
)
case(
    "GSK: the macro of G66 is called behind each block that moves",
    control=FAMILIES, source="TA27, G66 example; TDi28, G66 (2)", evidence=MANUAL,
    program="O1\nN10 G66 P2\nN20 G0 X50\nN30 G0 Z20\nN40 G67\nN50 G0 X30\nN60 M30\n" + MACRO,
    runs="N10 N20 N90 N30 N90 N40 N50 N60", calls="G66:O2 G66:O2",
)
case(
    "GSK: the macro of G66 is called L times behind each move",
    control=FAMILIES, source="TA27, G66 example; TDi28, G66", evidence=MANUAL,
    program="O1\nN10 G66 P2 L3\nN20 G0 X50\nN30 G0 Z20\nN40 G67\nN50 M30\n" + MACRO,
    runs="N10 N20 N90*3 N30 N90*3 N40 N50", calls="G66:O2 G66:O2",
)
case(
    "GSK: G66 passes its arguments at each call",
    pins="modal_locals",
    control=FAMILIES, source="TA27, G66 note 4; TDi28, G66 (3)", evidence=MANUAL,
    program="""
        O1
        N10 G66 P2 A5
        N20 G0 X50
        N30 G0 X60
        N40 G67
        N50 M30
        O2
        N60 #100=#100+#1
        N70 #1=1000
        N80 M99
    """,
    variables={100: 0}, runs="N10 N20 N60 N70 N80 N30 N60 N70 N80 N40 N50", vars={100: 10},
)
case(
    "GSK: G66 writes its arguments anew for each of the L passes",
    control=FAMILIES, source="TA27, G66 example; TDi28, G66 (3)", evidence=MANUAL,
    program="""
        O1
        N10 G66 P2 L3 A5
        N20 G0 X50
        N30 G67
        N40 M30
        O2
        N60 #100=#100+#1
        N70 #1=1000
        N80 M99
    """,
    variables={100: 0}, runs="N10 N20 (N60 N70 N80)*3 N30 N40", vars={100: 15},
)
case(
    "GSK: the arguments of G66 are not written to the caller's local variables",
    control=FAMILIES, source="TA27, G66 note 4; TDi28, G66 (1)", evidence=MANUAL,
    program="O1\nN10 #1=3\nN20 G66 P2 A5\nN30 G0 X50\nN40 G67\nN50 M30\n" + MACRO,
    runs="N10 N20 N30 N90 N40 N50", vars={1: 3},
)
for words in ("M3", "S500", "M5", "G0 U0 W0", "#100=1"):
    case(
        f"GSK 988: a block of {words} does not call the macro of G66",
        pins="modal_trigger",
        control=FAMILY_988, source="TA27, G66 example and note 3", evidence=MANUAL,
        program=f"O1\nN10 G66 P2\nN20 {words}\nN30 G67\nN40 M30\n" + MACRO,
        runs="N10 N20 N30 N40", calls="",
    )
case(
    "GSK 988: a move to the place where the axis stands does not call the macro of G66",
    control=FAMILY_988, source="TA27, G66 note 3", evidence=INFERRED,
    program="O1\nN10 G0 X50\nN20 G66 P2\nN30 G0 X50\nN40 G0 X51\nN50 G67\nN60 M30\n" + MACRO,
    runs="N10 N20 N30 N40 N90 N50 N60", calls="G66:O2",
)
case(
    "GSK 988: an incremental move calls the macro of G66",
    control=FAMILY_988, source="TA27, G66 example", evidence=MANUAL,
    program="O1\nN10 G66 P2 L2\nN20 G0 U1\nN30 G67\nN40 M30\n" + MACRO,
    runs="N10 N20 N90*2 N30 N40", calls="G66:O2",
)
case(
    "GSK 980: a block without a move does not call the macro of G66",
    control=FAMILY_980, source="TDi28, G66 (2)", evidence=MANUAL,
    program="O1\nN10 G66 P2\nN20 M3\nN30 #100=1\nN40 G67\nN50 M30\n" + MACRO,
    runs="N10 N20 N30 N40 N50", calls="",
)
case(
    "GSK: a move inside the macro of G66 does not call it again",
    control=FAMILIES, source="TA27, G66; TDi28, G66", evidence=INFERRED,
    program="O1\nN10 G66 P2\nN20 G0 X50\nN30 G67\nN40 M30\nO2\nN60 G0 X60\nN70 M99\n",
    runs="N10 N20 N60 N70 N30 N40", calls="G66:O2",
)
case(
    "GSK: behind G67 a move calls nothing",
    control=FAMILIES, source="TA27, G66 example; TDi28, G67", evidence=MANUAL,
    program="O1\nN10 G66 P2\nN20 G67\nN30 G0 X50\nN40 M30\n" + MACRO,
    runs="N10 N20 N30 N40", calls="",
)
case(
    "GSK 988: the macro of G66 is looked for at the first move",
    control=FAMILY_988, source="TA27, G66 note 3; Talm 083", evidence=INFERRED,
    program="O1\nN10 G66 P3\nN20 M3\nN30 G0 X50\nN40 M30\n" + MACRO,
    runs="N10 N20 N30", m=[3], alarm="program-not-found", number="083",
)
for call in ("M98 P2", "G65 P2", "G66 P2"):
    case(
        f"GSK 988: {call[:3]} is refused while G66 is active",
        pins="calls_in_modal",
        control=FAMILY_988, source="TA27, G66 note 1; Talm 204", evidence=SECONDARY,
        program=f"O1\nN10 G66 P2\nN20 {call}\nN30 G67\nN40 M30\n" + MACRO,
        runs="N10", alarm="call-in-modal-call", number="204", at="O1 N20",
    )
case(
    "GSK 988: M98 is refused while G66 is active behind its moves too",
    control=FAMILY_988, source="TA27, G66 note 1; Talm 204", evidence=SECONDARY,
    program="O1\nN10 G66 P2\nN20 G0 X50\nN30 M98 P2\nN40 M30\n" + MACRO,
    runs="N10 N20 N90", alarm="call-in-modal-call", number="204", at="O1 N30",
)
case(
    "GSK 988: M98 is legal again behind G67",
    control=FAMILY_988, source="TA27, G66 note 1", evidence=MANUAL,
    program="O1\nN10 G66 P2\nN20 G67\nN30 M98 P2\nN40 M30\n" + MACRO,
    runs="N10 N20 N30 N90 N40", calls="M98:O2",
)
case(
    "GSK 988: the macro of G66 may call a subprogram, it is another file",
    control=FAMILY_988, source="TA27, G66 note 1", evidence=INFERRED,
    program="O1\nN10 G66 P2\nN20 G0 X50\nN30 G67\nN40 M30\nO2\nN60 M98 P3\nN70 M99\nO3\nN80 M99\n",
    runs="N10 N20 N60 N80 N70 N30 N40", calls="G66:O2 M98:O3",
)
case(
    "GSK 988: G67 without G66 is an alarm",
    control=FAMILY_988, source="Talm 218", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 G67\nN30 M30\n", params={"6000#0": 0},
    runs="N10", alarm="modal-call-missing", number="218", at="O1 N20",
)
case(
    "GSK 988: a second G67 is an alarm",
    control=FAMILY_988, source="Talm 218", evidence=SECONDARY,
    program="O1\nN10 G66 P2\nN20 G67\nN30 G67\nN40 M30\n" + MACRO, params={"6000#0": 0},
    runs="N10 N20", alarm="modal-call-missing", number="218", at="O1 N30",
)
case(
    "GSK 988: with 6000#0=1 a G67 without G66 is ignored",
    control=FAMILY_988, source="TApar 6000", evidence=MANUAL, params={"6000#0": 1},
    program="O1\nN10 G67\nN20 G0 X1\nN30 M30\n",
    runs="N10 N20 N30",
)
case(
    "GSK 980: M98 is refused while G66 is active",
    pins="calls_in_modal",
    control=FAMILY_980, source="MDia 113", evidence=MANUAL,
    program="O1\nN10 G66 P2\nN20 G0 X50\nN30 M98 P2\nN40 M30\n" + MACRO,
    runs="N10 N20 N90", alarm="call-in-modal-call", number="0113", at="O1 N30",
)
case(
    "GSK 980: M99 P is refused while G66 is active",
    control=FAMILY_980, source="MDia 113", evidence=MANUAL,
    program="O1\nN10 G66 P2\nN20 M99 P10\nN30 M30\n" + MACRO,
    runs="N10", alarm="call-in-modal-call", number="0113", at="O1 N20",
)
case(
    "GSK 980: M98 is legal again behind G67",
    control=FAMILY_980, source="MDia 113; TDi28, G67", evidence=MANUAL,
    program="O1\nN10 G66 P2\nN20 G67\nN30 M98 P2\nN40 M30\n" + MACRO,
    runs="N10 N20 N30 N90 N40", calls="M98:O2",
)
case(
    "GSK 980: a G65 ends the modal call",
    control=FAMILY_980, source="TDi28, G66 (4)", evidence=MANUAL,
    program="O1\nN10 G66 P2\nN20 G0 X50\nN30 G65 P3\nN40 G0 X60\nN50 M30\n" + MACRO + "O3\nN80 M99\n",
    runs="N10 N20 N90 N30 N80 N40 N50", calls="G66:O2 G65:O3",
)
for code in ("G00", "G01", "G04", "G28"):
    case(
        f"GSK 980: {code} may not share a block with G66",
        control=FAMILY_980, source="MDia 044", evidence=MANUAL,
        program=macro_call(f"G66 P2 A1 {code}"),
        runs="", alarm="code-with-modal-call", number="0044", at="O1 N10",
    )
case(
    "GSK 980TDi: the macro of G66 may have a name",
    control=TDI, source="TDi28, G66 format 2", evidence=MANUAL, params={"878": 1},
    files={
        "O1.CNC": "O1\nN10 G66 P[CUT] L2 A3\nN20 G0 X50\nN30 G67\nN40 M30\n",
        "CUT.CNC": "N90 M99\n",
    },
    main="O1", runs="N10 N20 N90*2 N30 N40", calls="G66:CUT",
)
case(
    "GSK 988TA: the macro of G66 may have a name",
    control=TA, source="TA27, G66 format 2", evidence=MANUAL,
    files={
        "O1.CNC": "O1\nN10 G66 P[T123] L2 A3\nN20 G0 X50\nN30 G67\nN40 M30\n",
        "T123.CNC": "N90 M99\n",
    },
    main="O1", runs="N10 N20 N90*2 N30 N40", calls="G66:T123",
)

# --- 988: M, T and G codes that call a macro -----------------------------------------------------------------

ON = {"6008#5": 1, "6008#6": 1, "6008#7": 1}
OFF = {"6008#5": 0, "6008#6": 0, "6008#7": 0}
CODES = {"6060": 1, "6069": 909, "6080": 31, "6089": 45, "6090": 500, "6099": 599}

for code, kind, program in (
    ("T1", "T-code", "O9010"),
    ("T909", "T-code", "O9019"),
    ("M31", "M-code", "O9020"),
    ("M45", "M-code", "O9029"),
    ("G500", "G-code", "O9030"),
    ("G599", "G-code", "O9039"),
):
    case(
        f"GSK 988TA: {code} registered in its first or last place calls {program}",
        control=TA, source="TA27 p.9, table", evidence=MANUAL, params=ON | CODES,
        program=macro_call(code, name=program),
        runs="N10 N30 N20", calls=f"{kind}:{program}",
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
for code in ("T1", "M31", "G500"):
    case(
        f"GSK 988TA: the macro of {code} may be missing",
        control=TA, source="TA27 p.9; Talm 083", evidence=SECONDARY, params=ON | CODES,
        program=macro_call(code),
        runs="", alarm="program-not-found", number="083", at="O1 N10",
    )
for code, words in ((30, "M30"), (98, "M98 P2")):
    case(
        f"GSK 988TA: M{code} may not be registered to call a macro",
        control=TA, source="TA27 p.9, note 3; Talm 222", evidence=SECONDARY,
        params=ON | {"6080": code},
        program=f"O1\nN10 G0 X1\nN20 {words}\nN30 M99\nO2\nN40 M99\nO9020\nN50 M99\n",
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

# --- 980TDi: G codes that call a macro -----------------------------------------------------------------------

G_CODES = {"86": 3, "87": 100, "88": 2000}

for k in range(3):
    case(
        f"GSK 980TDi: G10{k} is number {k + 1} of the G codes that call",
        control=TDI, source="TDi32", evidence=MANUAL, params=G_CODES,
        program=macro_call(f"G10{k}", name=f"O200{k}"),
        runs="N10 N30 N20", calls=f"G-code:O200{k}",
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
    "GSK 980TDi: the G code behind those that call is no G code",
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

# --- 980TDi: G65 H, results ------------------------------------------------------------------------------


def result(claim, words, value, **row):
    """One G65 H block and what stands in #100 behind it; #101=12 and #102=-4.5 before it."""
    row = {"source": "TDi28, table of G65 H", "evidence": MANUAL, **row}
    case(
        f"GSK 980TDi: {claim}",
        pins="h_codes",
        control=TDI, program=f"O1\nN10 G65 {words}\nN20 M30\n",
        variables={100: 3, 101: 12, 102: -4.5}, runs="N10 N20", vars={100: value}, **row,
    )


result("H01 assigns a constant", "H01 P#100 Q1005", 1005)
result("H01 assigns a variable", "H01 P#100 Q#101", 12)
result("H01 assigns a variable with its sign changed", "H01 P#100 Q-#102", 4.5)
result("H1 is H01", "H1 P#100 Q7", 7)
result("H02 adds", "H02 P#100 Q#101 R15", 27)
result("H03 subtracts", "H03 P#100 Q#101 R#102", 16.5)
result("H03 subtracts R from Q", "H03 P#100 Q1 R3", -2)
result("H04 multiplies", "H04 P#100 Q#101 R#102", -54)
result("H05 divides and keeps the decimals", "H05 P#100 Q#101 R5", 2.4)
result("H11 is a bitwise OR", "H11 P#100 Q#101 R10", 14)
result("H12 is a bitwise AND", "H12 P#100 Q#101 R10", 8)
result("H13 is a bitwise exclusive OR", "H13 P#100 Q#101 R10", 6)
result("H21 takes the square root", "H21 P#100 Q2", 1.4142136)
result("H22 takes the absolute value", "H22 P#100 Q#102", 4.5)
result("H23 takes the remainder", "H23 P#100 Q#101 R5", 2)
result("H23 of a negative value is negative", "H23 P#100 Q-7 R3", -1)
result("H23 keeps decimals", "H23 P#100 Q7.5 R2", 1.5)
result("H24 reads decimal digits that stand in four bits each", "H24 P#100 Q24", 18, evidence=INFERRED)
result("H25 writes decimal digits in four bits each", "H25 P#100 Q18", 24, evidence=INFERRED)
result("H26 multiplies its own variable by Q and divides by R", "H26 P#100 Q#101 R8", 4.5)
result("H27 takes the root of the sum of the squares", "H27 P#100 Q5 R#101", 13)
result("H31 is Q times the sine of R in degrees", "H31 P#100 Q#101 R150", 6)
result("H32 is Q times the cosine of R in degrees", "H32 P#100 Q#101 R60", 6)
result("H33 is Q times the tangent of R in degrees", "H33 P#100 Q#101 R45", 12)
result("H34 is the angle in degrees whose tangent is Q over R", "H34 P#100 Q#101 R#101", 45)
result("H34 keeps its decimals", "H34 P#100 Q1 R2", 26.5650512)

case(
    "GSK 980TDi: G65 H calls no program and opens no level",
    control=TDI, source="TDi28, G65 H", evidence=MANUAL,
    program="O1\nN10 #1=5\nN20 G65 H02 P#2 Q#1 R1\nN30 M30\n",
    runs="N10 N20 N30", calls="", vars={1: 5, 2: 6},
)
case(
    "GSK 980TDi: H26 of three variables leaves the other two alone",
    control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
    program="O1\nN10 G65 H26 P#101 Q#102 R#103\nN20 M30\n",
    variables={101: 6, 102: 10, 103: 4}, runs="N10 N20", vars={101: 15, 102: 10, 103: 4},
)
case(
    "GSK 988TA: with 6000#7=1 G65 is type A",
    control=TA, source="TApar 6000", evidence=INFERRED, params={"6000#7": 1},
    program="O1\nN10 G65 H02 P#100 Q#101 R1\nN20 M30\n",
    variables={101: 4}, runs="N10 N20", vars={100: 5},
)
case(
    "GSK 988TA: with 6000#7=0 the H of G65 is an argument",
    control=TA, source="TApar 6000; TA27, argument I", evidence=MANUAL, params={"6000#7": 0},
    program=macro_call("G65 H02 P2 Q5"),
    runs="N10 N30 N20", calls="G65:O2", arguments={11: 2, 17: 5},
)

# --- 980TDi: G65 H, jumps --------------------------------------------------------------------------------------

JUMP = "O1\nN10 G65 {} P40 Q#100 R#101\nN20 #102=1\nN30 M30\nN40 #102=2\nN50 M30\n"

case(
    "GSK 980TDi: H80 jumps",
    control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
    program="O1\nN10 G65 H80 P30\nN20 G0 X1\nN30 M30\n", runs="N10 N30",
)
case(
    "GSK 980TDi: H80 jumps back",
    control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
    program="O1\nN10 G0 X1\nN20 G65 H80 P10\nN30 M30\n", max_blocks=5,
    runs="N10 N20 N10 N20 N10", stop="limit",
)
for code, sign, yes, no in (
    ("H81", "=", (2, 2), (2, 3)),
    ("H82", "<>", (2, 3), (2, 2)),
    ("H83", ">", (3, 2), (2, 2)),
    ("H84", "<", (2, 3), (2, 2)),
    ("H85", ">=", (2, 2), (2, 3)),
    ("H86", "<=", (2, 2), (3, 2)),
):
    for (q, r), runs, what in ((yes, "N10 N40 N50", "jumps"), (no, "N10 N20 N30", "does not jump")):
        case(
            f"GSK 980TDi: {code} (Q {sign} R) {what} with Q{q} R{r}",
            control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
            program=JUMP.format(code), variables={100: q, 101: r}, runs=runs,
        )
case(
    "GSK 980TDi: H85 jumps where Q is greater",
    control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
    program=JUMP.format("H85"), variables={100: 3, 101: 2}, runs="N10 N40 N50",
)
case(
    "GSK 980TDi: H86 jumps where Q is less",
    control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
    program=JUMP.format("H86"), variables={100: 2, 101: 3}, runs="N10 N40 N50",
)
case(
    "GSK 980TDi: the target of a jump may be a variable",
    control=TDI, source="TDi28, G65 H, note 2", evidence=MANUAL,
    program="O1\nN10 G65 H81 P#100 Q5 R5\nN20 G0 X1\nN30 M30\n", variables={100: 30},
    runs="N10 N30",
)
case(
    "GSK 980TDi: a jump to a block that is missing is an alarm",
    control=TDI, source="TDi28; number from MDia 112", evidence=INFERRED,
    program="O1\nN10 G0 X1\nN20 G65 H80 P90\nN30 M30\n",
    runs="N10", alarm="jump-target-not-found", number="0112", at="O1 N20",
)
case(
    "GSK 980TDi: a conditional jump to a block that is missing is an alarm when it is made",
    control=TDI, source="TDi28; number from MDia 112", evidence=INFERRED,
    program="O1\nN10 G65 H84 P90 Q2 R1\nN20 G65 H84 P90 Q1 R2\nN30 M30\n",
    runs="N10", alarm="jump-target-not-found", number="0112", at="O1 N20",
)
case(
    "GSK 980TDi: a jump does not look in other programs",
    control=TDI, source="TDi28; number from MDia 112", evidence=INFERRED,
    program="O1\nN10 G65 H80 P40\nN20 M30\nO2\nN40 M99\n",
    runs="", alarm="jump-target-not-found", number="0112", at="O1 N10",
)

# --- 980TDi: G65 H99 and #3000, alarms of the program itself ----------------------------------------------------

for n in (0, 7, 99):
    case(
        f"GSK 980TDi: H99 P{n} raises alarm {5900 + n}",
        control=TDI, source="TDi28, H99", evidence=MANUAL,
        program=f"O1\nN10 G0 X1\nN20 G65 H99 P{n}(/NO BAR)\nN30 M30\n",
        runs="N10 N20", alarm="user-alarm", number=str(5900 + n), at="O1 N20",
    )
    case(
        f"GSK 980TDi: #3000={n} raises alarm {5900 + n}",
        control=TDI, source="TDi28, system variables", evidence=MANUAL,
        program=f"O1\nN10 G0 X1\nN20 #3000={n}(NO BAR)\nN30 M30\n",
        runs="N10 N20", alarm="user-alarm", number=str(5900 + n), at="O1 N20",
    )
case(
    "GSK 980TDi: H99 needs no text",
    control=TDI, source="TDi28, H99 note 1", evidence=MANUAL,
    program="O1\nN10 G65 H99 P15\nN20 M30\n",
    runs="N10", alarm="user-alarm", number="5915", at="O1 N10",
)
case(
    "GSK 980TDi: #3000 needs no text",
    control=TDI, source="TDi28, system variables", evidence=MANUAL,
    program="O1\nN10 #3000=15\nN20 M30\n",
    runs="N10", alarm="user-alarm", number="5915", at="O1 N10",
)
case(
    "GSK 980TDi: H99 raises the alarm inside a subprogram",
    control=TDI, source="TDi28, H99", evidence=MANUAL,
    program="O1\nN10 M98 P2\nN20 M30\nO2\nN30 G65 H99 P3\nN40 M99\n",
    runs="N10 N30", alarm="user-alarm", number="5903", at="O2 N30",
)
case(
    "GSK 980: H99 P101 is outside the range",
    pins="h_codes",
    control=FAMILY_980, source="MDia 126", evidence=MANUAL,
    program="O1\nN10 G65 H99 P101\nN20 M30\n",
    runs="", alarm="illegal-user-alarm", number="0126", at="O1 N10",
)
case(
    "GSK 980: #3000=100 is outside the range",
    control=FAMILY_980, source="MDib 126", evidence=MANUAL,
    program="O1\nN10 #3000=100\nN20 M30\n",
    runs="", alarm="illegal-user-alarm", number="0126", at="O1 N10",
)
case(
    "GSK 980: #3000=-1 is outside the range",
    control=FAMILY_980, source="MDib 126", evidence=MANUAL,
    program="O1\nN10 #3000=-1\nN20 M30\n",
    runs="", alarm="illegal-user-alarm", number="0126", at="O1 N10",
)
case(
    "GSK 980TDi: #3000 behind a condition that is false raises nothing",
    control=TDI, source="TDi29, IF THEN", evidence=MANUAL,
    program="O1\nN10 IF[#100 GT 5]THEN #3000=1\nN20 M30\n", variables={100: 5},
    runs="N10 N20",
)
case(
    "GSK 980TDi: #3000 behind a condition that is true raises its alarm",
    control=TDI, source="TDi29, IF THEN", evidence=MANUAL,
    program="O1\nN10 IF[#100 GT 5]THEN #3000=1\nN20 M30\n", variables={100: 6},
    runs="N10", alarm="user-alarm", number="5901", at="O1 N10",
)

# --- 980: G65 H, faults ---------------------------------------------------------------------------------------


def fault(claim, words, cause, number, control=TDI, source=None, evidence=INFERRED):
    """One G65 H block that alarms and writes nothing."""
    case(
        f"{'GSK 980TDi' if control == TDI else 'GSK 980'}: {claim}",
        control=control, source=source or f"MDia {number}", evidence=evidence,
        program=f"O1\nN10 #100=3\nN20 G65 {words}\nN30 M30\n",
        runs="N10", alarm=cause, number=number, at="O1 N20", vars={100: 3},
    )


fault(
    "G65 needs a P or an H", "A1", "h-code-missing", "0122", control=FAMILY_980, evidence=MANUAL,
)
fault(
    "G65 alone says nothing", "", "h-code-missing", "0122", control=FAMILY_980, evidence=MANUAL,
)
for code in ("H06", "H07", "H14", "H28", "H35", "H87", "H98"):
    fault(f"{code} does not exist", f"{code} P#100 Q1 R1", "illegal-h-code", "0124")
fault("H01 needs Q", "H01 P#100", "h-code-operand", "0125")
fault("H02 needs R", "H02 P#100 Q1", "h-code-operand", "0125")
fault("H02 needs Q", "H02 P#100 R1", "h-code-operand", "0125")
fault("H27 needs R", "H27 P#100 Q3", "h-code-operand", "0125")
fault("H81 needs Q and R", "H81 P10", "h-code-operand", "0125")
fault("H84 needs R", "H84 P10 Q1", "h-code-operand", "0125")
fault("H02 needs P", "H02 Q1 R2", "h-code-format", "0123")
fault("H80 needs P", "H80", "h-code-format", "0123")
fault("the result of H01 goes into a variable", "H01 P100 Q1", "h-code-format", "0123")
fault("H05 by zero is refused", "H05 P#100 Q#100 R0", "division-by-zero", "0105",
      control=FAMILY_980, evidence=MANUAL)
fault("H05 by a variable of zero is refused", "H05 P#100 Q1 R#150", "division-by-zero", "0105")
fault("H26 by zero is refused", "H26 P#100 Q2 R0", "division-by-zero", "0105")
fault("H23 by zero is refused", "H23 P#100 Q2 R0", "division-by-zero", "0105")
fault("H21 of a negative value is refused", "H21 P#100 Q-4", "square-root-of-negative", "0108",
      control=FAMILY_980, evidence=MANUAL)
fault("H33 of 90 degrees is refused", "H33 P#100 Q1 R90", "tangent-infinite", "0109")
fault("H24 of decimals is refused", "H24 P#100 Q1.5", "argument-out-of-range", "0127")
fault("the result of H01 does not go into #0", "H01 P#0 Q1", "vacant-assigned", "0117",
      control=FAMILY_980, evidence=MANUAL)
fault("the result of H01 does not go into #50", "H01 P#50 Q1", "illegal-variable", "0111",
      control=FAMILY_980, evidence=MANUAL)
fault("the result of H01 does not go into the read-only #4001", "H01 P#4001 Q1",
      "variable-write-protected", "0120", source="MDia 120; TDi28, system variables")
fault("the result of H01 does not go into the read-only #5001", "H01 P#5001 Q1",
      "variable-write-protected", "0120", source="MDia 120; TDi28, system variables")

# --- Variables -------------------------------------------------------------------------------------------------


def values_980(claim, statement, expected, **row):
    """One statement on the 980TDi, with #1 and #150 vacant, #100=205, #110=500 and #120=2.5."""
    row = {"source": "TDi28, variables", "evidence": MANUAL, **row}
    case(
        f"GSK 980TDi: {claim}",
        control=TDI, program=f"O1\nN10 {statement}\nN20 M30\n",
        variables={1: None, 100: 205, 110: 500, 120: 2.5, 150: None, 101: 110},
        runs="N10 N20", vars=expected, **row,
    )


values_980("#9101 is the variable whose number stands in #101", "#130=#9101", {130: 500})
values_980("#9101 can be written", "#9101=7", {110: 7, 101: 110})
values_980("#9101 may stand on both sides", "#9101=#9101+1", {110: 501})
values_980("#[#101] is the variable whose number stands in #101", "#130=#[#101]", {130: 500})
values_980("#[#101+10] computes the number", "#130=#[#101+10]", {130: 2.5})
values_980("#[expression] can be written", "#[#101+20]=8", {130: 8})
values_980("a vacant variable assigned stays vacant", "#2=#1", {2: None})
values_980("#0 assigned makes a variable vacant", "#100=#0", {100: None})
values_980("a vacant variable times five is zero", "#2=#1*5", {2: 0})
values_980("a vacant variable plus itself is zero", "#2=#1+#1", {2: 0})
values_980("in a comparison vacant equals zero", "IF[#1 EQ 0]THEN #130=1", {130: 1})
values_980("in a comparison zero equals vacant", "IF[0 EQ #0]THEN #130=1", {130: 1})
values_980("vacant is not unequal to vacant", "IF[#1 NE #0]THEN #130=1", {130: None})
values_980("vacant is greater or equal to vacant", "IF[#1 GE #0]THEN #130=1", {130: 1})
values_980("vacant is not greater than vacant", "IF[#1 GT #0]THEN #130=1", {130: None})
values_980("G65 H sees vacant as zero", "G65 H02 P#130 Q#1 R3", {130: 3})
values_980("#500 is a common variable", "#500=#120", {500: 2.5})
values_980("#999 is a common variable", "#999=#120", {999: 2.5})
values_980("#33 is a local variable", "#33=#120", {33: 2.5})
values_980("#199 is a common variable", "#199=#120", {199: 2.5})

case(
    "GSK 980TDi: a vacant variable as a value of an axis is zero",
    control=TDI, source="TDi28, vacant variables (1)", evidence=MANUAL,
    program="O1\nN10 G0 X100 Z50\nN20 G0 X90 Z#1\nN30 M30\n",
    runs="N10 N20 N30", moves_x=[100, 90], final_work="X90 Z0",
)
case(
    "GSK 980TDi: an axis takes the negative of a variable",
    control=TDI, source="TDi28, reference to variables (1)", evidence=MANUAL,
    program="O1\nN10 G0 X100 Z-#110\nN20 M30\n", variables={110: 250},
    runs="N10 N20", final_work="X100 Z-250",
)
case(
    "GSK 980TDi: an axis takes a variable by way of #9100",
    control=TDI, source="TDi28, reference to variables (2)", evidence=MANUAL,
    program="O1\nN10 G0 X#9100 Z-#9100\nN20 M30\n", variables={100: 120, 120: 30},
    runs="N10 N20", final_work="X30 Z-30",
)
case(
    "GSK 980: #0 cannot be written",
    control=FAMILY_980, source="MDia 117; TDi28", evidence=MANUAL,
    program="O1\nN10 #100=1\nN20 #0=#100\nN30 M30\n",
    runs="N10", alarm="vacant-assigned", number="0117", at="O1 N20",
)
for n in (34, 99):
    case(
        f"GSK 980: there is no #{n}",
        control=FAMILY_980, source="MDia 111; TDi28, variables", evidence=MANUAL,
        program=f"O1\nN10 #100=1\nN20 #{n}=1\nN30 M30\n",
        runs="N10", alarm="illegal-variable", number="0111", at="O1 N20",
    )
    case(
        f"GSK 980: #{n} cannot be read either",
        control=FAMILY_980, source="MDia 111; TDi28, variables", evidence=MANUAL,
        program=f"O1\nN10 #100=1\nN20 #100=#{n}\nN30 M30\n",
        runs="N10", alarm="illegal-variable", number="0111", at="O1 N20", vars={100: 1},
    )
case(
    "GSK 980TDi: #9101 is refused where #101 names no variable",
    control=TDI, source="MDia 111; TDi28", evidence=INFERRED,
    program="O1\nN10 #101=50\nN20 #9101=1\nN30 M30\n",
    runs="N10", alarm="illegal-variable", number="0111", at="O1 N20",
)
case(
    "GSK 988: there is no #50",
    control=FAMILY_988, source="Talm 203", evidence=SECONDARY,
    program="O1\nN10 #100=1\nN20 #50=1\nN30 M30\n",
    runs="N10", alarm="illegal-variable", number="203", at="O1 N20",
)
case(
    "GSK 988: #50 cannot be read either",
    control=FAMILY_988, source="Talm 203", evidence=SECONDARY,
    program="O1\nN10 #100=1\nN20 #100=#50\nN30 M30\n",
    runs="N10", alarm="illegal-variable", number="203", at="O1 N20", vars={100: 1},
)
for n in (4001, 5041):
    case(
        f"GSK 980TDi: #{n} is only to be read",
        control=TDI, source="TDi28, system variables; number from MDia 120", evidence=INFERRED,
        program=f"O1\nN10 #100=1\nN20 #{n}=1\nN30 M30\n",
        runs="N10", alarm="variable-write-protected", number="0120", at="O1 N20",
    )

# --- Functions ---------------------------------------------------------------------------------------------------


def function(claim, expression, value, control=FAMILIES, **row):
    """One assignment to #100."""
    row = {"source": "TDi29, arithmetic", "evidence": MANUAL, **row}
    case(
        f"GSK: {claim}",
        pins="angle_unit functions",
        control=control, program=f"O1\nN10 #100={expression}\nN20 M30\n",
        variables={101: -1.2}, runs="N10 N20", vars={100: value}, **row,
    )


function("multiplication comes before addition", "2+3*4", 14)
function("brackets come first", "[2+3]*4", 20)
function("a difference is computed from the left", "10-4-3", 3)
function("a quotient is computed from the left", "24/4/2", 3)
function("SQRT takes the square root", "SQRT[6.25]", 2.5)
function("ABS takes the sign away", "ABS[#101]", 1.2)
function("ROUND rounds at the first decimal, down", "ROUND[1.2345]", 1)
function("ROUND rounds at the first decimal, up", "ROUND[2.5]", 3)
function("FUP rounds away from zero", "FUP[1.2]", 2)
function("FUP of a negative value rounds away from zero", "FUP[#101]", -2)
function("FIX rounds towards zero", "FIX[1.9]", 1)
function("FIX of a negative value rounds towards zero", "FIX[#101]", -1)
function("FUP leaves a whole number alone", "FUP[3]", 3)
function("LN is the natural logarithm", "LN[10]", 2.3025851)
function("EXP is the exponential", "EXP[2]", 7.3890561)
function("SIN takes degrees", "SIN[30]", 0.5)
function("COS takes degrees", "COS[60]", 0.5)
function("TAN takes degrees", "TAN[45]", 1)
function("degrees have decimals, not minutes", "SIN[90.5]", 0.9999619)
function("ASIN gives degrees", "ASIN[0.5]", 30)
function("ACOS gives degrees from 0 to 180", "ACOS[-0.5]", 120)
function("ATAN takes two lengths", "ATAN[3]/[4]", 36.8698976)
function("OR works bit by bit", "12 OR 10", 14, control=TDI)
function("AND works bit by bit", "12 AND 10", 8, control=TDI)
function("XOR works bit by bit", "12 XOR 10", 6, control=TDI)
function("BIN reads four bits as a decimal digit", "BIN[24]", 18, evidence=INFERRED)
function("BCD writes a decimal digit in four bits", "BCD[18]", 24, evidence=INFERRED)
function("functions may stand inside each other", "SQRT[ABS[#101*30]]", 6)
function(
    "with 180#7=0 ATAN goes from 0 to 360", "ATAN[-1]/[-1]", 225, control=TDI, params={"180#7": 0}
)
function(
    "with 180#7=1 ATAN goes from -180 to 180",
    "ATAN[-1]/[-1]", -135, control=TDI, params={"180#7": 1},
)
case(
    "GSK 980TDi: RAND lies above zero and not above its argument",
    control=TDI, source="TDi29, random numbers", evidence=MANUAL,
    program="""
        O1
        N10 #100=RAND[10]
        N20 IF[#100 LE 0]THEN #3000=1
        N30 IF[#100 GT 10]THEN #3000=2
        N40 M30
    """,
    runs="N10 N20 N30 N40",
)
case(
    "GSK 980TDi: SRAND lies between its two arguments",
    control=TDI, source="TDi29, random numbers", evidence=MANUAL,
    program="""
        O1
        N10 #100=SRAND[5,6]
        N20 IF[#100 LT 5]THEN #3000=1
        N30 IF[#100 GT 6]THEN #3000=2
        N40 M30
    """,
    runs="N10 N20 N30 N40",
)


def bad_function(claim, expression, cause, number, control=FAMILIES, **row):
    """One assignment to #100 that alarms and leaves #100 alone."""
    if not isinstance(number, str):
        row = {"source": f"Talm {number[TA]}; MDia {number[TDI]}", **row}
    row = {"source": f"MDia {number}", "evidence": SECONDARY, **row}
    case(
        f"GSK: {claim}",
        pins="max_brackets negative_logic",
        control=control, program=f"O1\nN10 #100=3\nN20 #100={expression}\nN30 M30\n",
        runs="N10", alarm=cause, number=number, at="O1 N20", vars={100: 3}, **row,
    )


bad_function("a division by zero is an alarm", "5/0", "division-by-zero", both("014", "0105"))
bad_function(
    "a division by a difference of zero is an alarm",
    "5/[#100-3]", "division-by-zero", both("014", "0105"),
)
bad_function(
    "the square root of a negative value is an alarm",
    "SQRT[0-4]", "square-root-of-negative", both("206", "0108"),
)
bad_function("TAN of 90 degrees is an alarm", "TAN[90]", "tangent-infinite", both("014", "0109"))
bad_function(
    "LN of zero is an alarm", "LN[0]", "logarithm-of-non-positive", "0107",
    control=FAMILY_980, evidence=MANUAL,
)
bad_function(
    "LN of a negative value is an alarm", "LN[0-1]", "logarithm-of-non-positive", "0107",
    control=FAMILY_980, evidence=MANUAL,
)
bad_function(
    "ASIN above 1 is an alarm", "ASIN[1.01]", "arc-sine-out-of-range", "0110",
    control=FAMILY_980, evidence=MANUAL,
)
bad_function(
    "ACOS below -1 is an alarm", "ACOS[0-1.01]", "arc-sine-out-of-range", "0110",
    control=FAMILY_980, evidence=MANUAL,
)
bad_function(
    "BIN of decimals is an alarm", "BIN[1.5]", "argument-out-of-range", "0127",
    control=FAMILY_980, evidence=MANUAL,
)
bad_function(
    "BIN of bits that are no decimal digit is an alarm", "BIN[10]", "argument-out-of-range", "206",
    control=FAMILY_988, source="Talm 206",
)
bad_function(
    "BCD of a negative value is an alarm", "BCD[0-1]", "argument-out-of-range", "206",
    control=FAMILY_988, source="Talm 206",
)
for operator in ("OR", "XOR", "AND"):
    bad_function(
        f"{operator} with a negative value is an alarm",
        f"5 {operator} [0-3]", "logic-of-negative", "217", control=FAMILY_988, source="Talm 217",
    )
bad_function("a result above 1e308 is an alarm", "EXP[1000]", "overflow", both("221", "0043"))
bad_function(
    "a result above 1e47 is no value of a variable", "EXP[110]", "overflow", "221",
    control=TA, source="Talm 221; TApar 6008#0, its value 1",
)
case(
    "GSK 988TA: inside an expression a result above 1e47 is legal",
    control=TA, source="Talm 221; TApar 6008#0, its value 0", evidence=MANUAL,
    program="O1\nN10 #100=LN[EXP[110]]\nN20 M30\n", runs="N10 N20", vars={100: 110},
)
bad_function(
    "six brackets inside each other are too many", "[[[[[[1]]]]]]", "brackets-too-deep", "205",
    control=FAMILY_988, source="Talm 205",
)
function(
    "five brackets inside each other are legal", "[[[[[1]]]]]", 1,
    control=FAMILY_988, source="Talm 205", evidence=SECONDARY,
)
bad_function(
    "a bracket that is not closed is an alarm", "[2+3", "bracket-not-closed", "0104",
    control=FAMILY_980, evidence=MANUAL,
)
bad_function(
    "a bracket that is not opened is an alarm", "2+3]", "bracket-not-opened", "0104",
    control=FAMILY_980, evidence=MANUAL,
)
bad_function(
    "an operator without its second value is an alarm", "2+", "expression-format",
    both("202", "0101"),
)
bad_function(
    "two operators in a row are an alarm", "2*/3", "expression-format", both("202", "0101"),
)

# --- Jumps and loops ---------------------------------------------------------------------------------------------

for word, sign, less, equal, greater in (
    ("EQ", "==", 0, 1, 0),
    ("NE", "<>", 1, 0, 1),
    ("GT", ">", 0, 0, 1),
    ("GE", ">=", 0, 1, 1),
    ("LT", "<", 1, 0, 0),
    ("LE", "<=", 1, 1, 0),
):
    for operator, control in ((word, FAMILIES), (sign, [TDI])):
        case(
            f"GSK: {operator} compares less, equal and greater as its table says",
            pins="if_form max_condition_length",
            control=control, source="TDi29, conditions", evidence=MANUAL,
            program=f"""
                O1
                N10 IF[1 {operator} 2]THEN #101=1
                N20 IF[2 {operator} 2]THEN #102=1
                N30 IF[3 {operator} 2]THEN #103=1
                N40 M30
            """,
            variables={101: 0, 102: 0, 103: 0}, runs="N10 N20 N30 N40",
            vars={101: less, 102: equal, 103: greater},
        )

case(
    "GSK: GOTO goes forward",
    control=FAMILIES, source="TDi29, GOTO", evidence=MANUAL,
    program="O1\nN10 GOTO 30\nN20 G0 X1\nN30 M30\n", runs="N10 N30",
)
case(
    "GSK: GOTO goes back",
    control=FAMILIES, source="TDi29, GOTO", evidence=MANUAL,
    program="O1\nN10 #100=#100+1\nN20 IF[#100 GE 3]GOTO 40\nN30 GOTO 10\nN40 M30\n",
    variables={100: 0}, runs="(N10 N20 N30)*2 N10 N20 N40", vars={100: 3},
)
case(
    "GSK: GOTO finds a number written with leading zeros",
    control=FAMILIES, source="TDi29, GOTO", evidence=INFERRED,
    program="O1\nN10 GOTO30\nN20 G0 X1\nN0030 M30\n", runs="N10 N30",
)
case(
    "GSK: GOTO takes its number from a variable",
    control=FAMILIES, source="TDi29, GOTO#101", evidence=MANUAL,
    program="O1\nN10 GOTO#101\nN20 G0 X1\nN30 M30\n", variables={101: 30}, runs="N10 N30",
)
case(
    "GSK: GOTO takes its number from an expression",
    control=FAMILIES, source="TDi29, GOTO", evidence=MANUAL,
    program="O1\nN10 GOTO[#101*10]\nN20 G0 X1\nN30 M30\n", variables={101: 3}, runs="N10 N30",
)
case(
    "GSK: GOTO reaches N99999",
    pins="max_sequence_number max_jump_number",
    control=[*FAMILIES, "haas-ngc"], source="Talm 213; TDi29, GOTO", evidence=MANUAL,
    program="O1\nN10 GOTO 99999\nN20 G0 X1\nN99999 M30\n", runs="N10 N99999",
)
case(
    "GSK: IF GOTO with a false condition goes on",
    control=FAMILIES, source="TDi29, IF", evidence=MANUAL,
    program="O1\nN10 IF[#101 GT 10]GOTO 30\nN20 G0 X1\nN30 M30\n", variables={101: 10},
    runs="N10 N20 N30",
)
case(
    "GSK 980TDi: the manual's sum of 1 to 10 is 55",
    control=TDI, source="TDi29, example O9500", evidence=MANUAL,
    program="""
        O9500
        N100 #101=0
        N110 #2=1
        N1 IF[#2 GT 10]GOTO2
        N120 #101=#101+#2
        N130 #2=#2+1
        N140 GOTO1
        N2 M30
    """,
    runs="N100 N110 (N1 N120 N130 N140)*10 N1 N2", vars={101: 55, 2: 11},
)
case(
    "GSK: GOTO to a number that is missing is an alarm",
    control=FAMILIES, source="Talm 213; MDia 112", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 GOTO 90\nN30 M30\n",
    runs="N10", alarm="jump-target-not-found", number=both("213", "0112"), at="O1 N20",
)
case(
    "GSK: GOTO does not look in other programs",
    control=FAMILIES, source="Talm 213; MDia 112", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 GOTO 50\nN30 M30\nO2\nN50 M99\n",
    runs="N10", alarm="jump-target-not-found", number=both("213", "0112"), at="O1 N20",
)
case(
    "GSK: GOTO of a subprogram does not look in its caller",
    control=FAMILIES, source="Talm 213; MDia 112", evidence=SECONDARY,
    program="O1\nN10 M98 P2\nN20 M30\nO2\nN30 GOTO 20\nN40 M99\n",
    runs="N10", alarm="jump-target-not-found", number=both("213", "0112"), at="O2 N30",
)
case(
    "GSK: GOTO 0 is an alarm",
    control=FAMILIES, source="Talm 213; TDi29, GOTO; MDia 112", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 GOTO 0\nN30 M30\n",
    runs="N10", alarm="illegal-jump-number", number=both("213", "0112"), at="O1 N20",
)
case(
    "GSK: GOTO 100000 is an alarm",
    control=FAMILIES, source="Talm 213; TDi29, GOTO; MDia 112", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 GOTO 100000\nN30 M30\n",
    runs="N10", alarm="illegal-jump-number", number=both("213", "0112"), at="O1 N20",
)
case(
    "GSK: a variable below 1 is no target of GOTO",
    control=FAMILIES, source="Talm 213; TDi29, GOTO; MDia 112", evidence=SECONDARY,
    program="O1\nN10 #101=-5\nN20 GOTO #101\nN30 M30\n",
    runs="N10", alarm="illegal-jump-number", number=both("213", "0112"), at="O1 N20",
)
case(
    "GSK: IF GOTO to a number that is missing alarms only when it jumps",
    control=FAMILIES, source="Talm 213; MDia 112", evidence=SECONDARY,
    program="O1\nN10 IF[1 EQ 2]GOTO 90\nN20 IF[1 EQ 1]GOTO 90\nN30 M30\n",
    runs="N10", alarm="jump-target-not-found", number=both("213", "0112"), at="O1 N20",
)
case(
    "GSK: WHILE runs its loop while the condition is true",
    pins="loop_form",
    control=FAMILIES, source="TDi29, WHILE", evidence=MANUAL,
    program="O1\nN10 WHILE[#100 LT 3]DO1\nN20 #100=#100+1\nN30 END1\nN40 M30\n",
    variables={100: 0}, runs="(N10 N20 N30)*3 N10 N40", vars={100: 3},
)
case(
    "GSK: WHILE with a false condition goes behind its END",
    control=FAMILIES, source="TDi29, WHILE", evidence=MANUAL,
    program="O1\nN10 WHILE[#100 LT 3]DO1\nN20 #100=#100+1\nN30 END1\nN40 M30\n",
    variables={100: 7}, runs="N10 N40", vars={100: 7},
)
case(
    "GSK: a loop number may be used again",
    control=FAMILIES, source="TDi29, WHILE", evidence=MANUAL,
    program="""
        O1
        N10 WHILE[#100 LT 1]DO1
        N20 #100=#100+1
        N30 END1
        N40 WHILE[#100 LT 2]DO1
        N50 #100=#100+1
        N60 END1
        N70 M30
    """,
    variables={100: 0}, runs="N10 N20 N30 N10 N40 N50 N60 N40 N70", vars={100: 2},
)
case(
    "GSK: three loops inside each other are legal",
    pins="max_loop_number max_loops",
    control=FAMILIES, source="TDi29, WHILE", evidence=MANUAL,
    program="""
        O1
        N10 WHILE[#101 LT 1]DO1
        N20 WHILE[#102 LT 1]DO2
        N30 WHILE[#103 LT 2]DO3
        N40 #103=#103+1
        N50 END3
        N60 #102=#102+1
        N70 END2
        N80 #101=#101+1
        N90 END1
        N100 M30
    """,
    variables={101: 0, 102: 0, 103: 0},
    runs="N10 N20 (N30 N40 N50)*2 N30 N60 N70 N20 N80 N90 N10 N100",
)
case(
    "GSK: GOTO may leave a loop",
    control=FAMILIES, source="TDi29, loops", evidence=INFERRED,
    program="O1\nN10 WHILE[1 EQ 1]DO1\nN20 GOTO 40\nN30 END1\nN40 M30\n",
    runs="N10 N20 N40",
)
case(
    "GSK: a loop may call a subprogram",
    control=FAMILIES, source="source 000; TDi29, loops", evidence=INFERRED,
    program="""
        O1
        N10 WHILE[#100 LT 2]DO1
        N20 M98 P2
        N30 END1
        N40 M30
        O2
        N50 #100=#100+1
        N60 M99
    """,
    variables={100: 0}, runs="(N10 N20 N50 N60 N30)*2 N10 N40",
)
case(
    "GSK: a macro may use the loop number of its caller",
    control=FAMILIES, source="TA27; TDi29, loops", evidence=INFERRED,
    program="""
        O1
        N10 WHILE[#100 LT 1]DO1
        N20 G65 P2 A0
        N30 #100=#100+1
        N40 END1
        N50 M30
        O2
        N60 WHILE[#1 LT 2]DO1
        N70 #1=#1+1
        N80 END1
        N90 M99
    """,
    variables={100: 0},
    runs="N10 N20 (N60 N70 N80)*2 N60 N90 N30 N40 N10 N50",
)
case(
    "GSK 988: DO4 is an alarm",
    control=FAMILY_988, source="Talm 211", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 WHILE[1 EQ 2]DO4\nN30 END4\nN40 M30\n",
    runs="N10", alarm="illegal-loop-number", number="211", at="O1 N20",
)
case(
    "GSK 980TDi: DO4 is an alarm",
    control=TDI, source="TDi29, WHILE; number from MDia 102", evidence=INFERRED,
    program="O1\nN10 G0 X1\nN20 WHILE[1 EQ 2]DO4\nN30 END4\nN40 M30\n",
    runs="N10", alarm="illegal-loop-number", number="0102", at="O1 N20",
)
case(
    "GSK: DO0 is an alarm",
    control=FAMILIES, source="Talm 211; MDia 102", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 WHILE[1 EQ 2]DO0\nN30 END0\nN40 M30\n",
    runs="N10", alarm="illegal-loop-number", number=both("211", "0102"), at="O1 N20",
)
case(
    "GSK: a DO without its END is an alarm",
    control=FAMILIES, source="Talm 209; MDia 103", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 WHILE[#100 LT 3]DO1\nN30 #100=#100+1\nN40 M30\n",
    variables={100: 0}, runs="N10", alarm="missing-end", number=both("209", "0103"), at="O1 N20",
)
case(
    "GSK: an END without its DO is an alarm",
    control=FAMILIES, source="Talm 209; MDia 103", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 END1\nN30 M30\n",
    runs="N10", alarm="missing-do", number=both("209", "0103"), at="O1 N20",
)
case(
    "GSK: an END of another number does not close a loop",
    control=FAMILIES, source="Talm 209; MDia 103", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 WHILE[#100 LT 3]DO1\nN30 #100=#100+1\nN40 END2\nN50 M30\n",
    variables={100: 0}, runs="N10", alarm="missing-end", number=both("209", "0103"), at="O1 N20",
)
case(
    "GSK: loops that cross are an alarm",
    control=FAMILIES, source="Talm 209; MDia 103; TDi29, nesting", evidence=SECONDARY,
    program="""
        O1
        N10 WHILE[#100 LT 3]DO1
        N20 WHILE[#100 LT 3]DO2
        N30 #100=#100+1
        N40 END1
        N50 END2
        N60 M30
    """,
    variables={100: 0}, alarm="missing-end", number=both("209", "0103"),
)
case(
    "GSK: a jump into a loop is an alarm",
    control=FAMILIES, source="Talm 209; MDia 103", evidence=SECONDARY,
    program="""
        O1
        N10 GOTO 30
        N20 WHILE[#100 LT 3]DO1
        N30 #100=#100+1
        N40 END1
        N50 M30
    """,
    variables={100: 0}, alarm="missing-do", number=both("209", "0103"),
)
for statement in ("GOTO 10", "IF[1 EQ 1]GOTO 10", "WHILE[1 EQ 2]DO1\nN7 END1"):
    case(
        f"GSK 988: {statement[:8].rstrip()} is refused in MDI",
        pins="jumps_in_mdi",
        control=FAMILY_988, source="Talm 208", evidence=SECONDARY,
        program="O1\nN10 M30\n", mdi=f"N5 G0 X1\nN6 {statement}",
        runs="N5", alarm="jump-in-mdi", number="208",
    )
case(
    "GSK: an assignment is legal in MDI",
    control=FAMILIES, source="Talm 208 names jumps only", evidence=INFERRED,
    program="O1\nN10 M30\n", mdi="N5 #100=2*3\nN6 #101=#100+1", runs="N5 N6", vars={100: 6, 101: 7},
)
case(
    "GSK 980: IF without GOTO and THEN is an alarm",
    control=FAMILY_980, source="MDia 101", evidence=MANUAL,
    program="O1\nN10 G0 X1\nN20 IF[1 EQ 1]\nN30 M30\n",
    runs="N10", alarm="if-format", number="0101", at="O1 N20",
)
case(
    "GSK 980: WHILE without DO is an alarm",
    control=FAMILY_980, source="MDia 101", evidence=MANUAL,
    program="O1\nN10 G0 X1\nN20 WHILE[1 EQ 1]\nN30 END1\nN40 M30\n",
    runs="N10", alarm="while-format", number="0101", at="O1 N20",
)
case(
    "GSK: IF THEN with a false condition assigns nothing",
    control=FAMILIES, source="TDi29, IF THEN", evidence=MANUAL,
    program="O1\nN10 IF[#101 EQ #102]THEN #103=0\nN20 M30\n", variables={101: 1, 102: 2, 103: 9},
    runs="N10 N20", vars={103: 9},
)
case(
    "GSK: IF THEN with a false condition does not compute its right side",
    control=FAMILIES, source="TDi29, IF THEN", evidence=INFERRED,
    program="O1\nN10 IF[#101 NE 0]THEN #103=1/#101\nN20 M30\n", variables={101: 0, 103: 9},
    runs="N10 N20", vars={103: 9},
)
case(
    "GSK: a jump number may be computed in IF GOTO",
    control=FAMILIES, source="TDi29, GOTO", evidence=INFERRED,
    program="O1\nN10 IF[#101 EQ 3]GOTO[#101*10]\nN20 G0 X1\nN30 M30\n", variables={101: 3},
    runs="N10 N30",
)
