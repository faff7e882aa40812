"""GSK: arguments of G65, and the levels of local variables."""

from conformance import case

case(
    "G65 P9010 fills #1 to #12 as the manual's example says (TD-010)",
    control="gsk-980tdi",
    source="TDi28",
    evidence="maker's manual",
    program="""
        O1
        G65 P9010 A1 B2 C3 I14 J15 I6 J7 K9 K11 K12 J30
        M30
        O9010
        G0 X#1
        G0 X#4
        G0 X#5
        G0 X#6
        G0 X#7
        G0 X#8
        G0 X#9
        G0 X#11
        G0 X#12
        M99
    """,
    arguments={1: 1, 2: 2, 3: 3, 4: 14, 5: 15, 6: 9, 7: 6, 8: 7, 9: 11, 11: 30, 12: 12},
    moves_x=[1, 14, 15, 9, 6, 7, 11, 30, 12],
)

TA, T, TDI, MDI = "gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi"
FAMILY_988 = [TA, T]
FAMILY_980 = [TDI, MDI]
FAMILIES = [TA, T, TDI, MDI]
MANUAL = "maker's manual"
SECONDARY = "secondary"
INFERRED = "inferred"


def macro_call(call, macro="N30 M99", name="O2"):
    """Return a main program O1 of one macro call, and the macro."""
    return f"O1\nN10 {call}\nN20 M30\n{name}\n{macro}\n"


LETTERS = "A1 B2 C3 D7 E8 F9 H11 I4 J5 K6 M13 Q17 R18 S19 T20 U21 V22 W23 X24 Y25 Z26"
TRIPLES = " ".join(f"{letter}{4 + 3 * k + i}" for k in range(10) for i, letter in enumerate("IJK"))

case(
    "GSK: each letter of argument I sets the variable of the manual's table",
    pins="whole_numbers roles:G65=macro-call",
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
    "GSK: of a letter and a triple that mean one variable the triple after it wins",
    control=FAMILIES, source="TA27, mixed arguments; TDi28, note 3", evidence=MANUAL,
    program=macro_call("G65 P2 D70 I40 I71"),
    runs="N10 N30 N20", arguments={4: 40, 7: 71},
)
case(
    "GSK: of a triple and a letter that mean one variable the letter after it wins",
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
case(
    "GSK 980: eleven I are too many",
    control=FAMILY_980, source="MDia 118", evidence=MANUAL,
    program=macro_call("G65 P2 I1 I1 I1 I1 I1 I1 I1 I1 I1 I1 I1"),
    runs="", alarm="too-many-argument-sets", number="0118", at="O1 N10",
)
case(
    "GSK 980: eleven J are too many",
    control=FAMILY_980, source="MDia 118", evidence=MANUAL,
    program=macro_call("G65 P2 J1 J1 J1 J1 J1 J1 J1 J1 J1 J1 J1"),
    runs="", alarm="too-many-argument-sets", number="0118", at="O1 N10",
)
case(
    "GSK 980: eleven K are too many",
    control=FAMILY_980, source="MDia 118", evidence=MANUAL,
    program=macro_call("G65 P2 K1 K1 K1 K1 K1 K1 K1 K1 K1 K1 K1"),
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
