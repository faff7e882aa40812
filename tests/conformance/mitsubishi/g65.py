"""Mitsubishi: G65 and the levels of macros."""

from conformance import case

case(
    "G65 puts A, B, X and Z into #1, #2, #24 and #26 (MIT-101)",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        G65 P2 A1.5 B2 X7 Z8
        M30
        O2
        G0 X#1
        G0 X#2
        G0 X#24
        G0 X#26
        M99
    """,
    arguments={1: 1.5, 2: 2, 24: 7, 26: 8},
    moves_x=[1.5, 2, 7, 8],
)

case(
    "M99 of a macro gives the caller's locals back (MIT-102)",
    control="mitsubishi-m700",
    source="SM 13.9 (5)",
    evidence="maker's manual",
    program="""
        O1
        #1=5
        G65 P2 A1
        G0 X#1
        M30
        O2
        G0 X#1
        #1=9
        M99
    """,
    moves_x=[1, 5],
)

case(
    "four macro levels are legal (MIT-104)",
    control="mitsubishi-m700",
    source="SM 13.9 (6)",
    evidence="maker's manual",
    program="""
        O1
        G65 P2
        M30
        O2
        G0 X2
        G65 P3
        M99
        O3
        G0 X3
        G65 P4
        M99
        O4
        G0 X4
        G65 P5
        M99
        O5
        G0 X5
        M99
    """,
    moves_x=[2, 3, 4, 5],
)

case(
    "the fifth macro level alarms (MIT-105)",
    control="mitsubishi-m700",
    source="SM 13.9 (6); MZ 855, paired with P273",
    evidence="secondary",
    program="""
        O1
        G65 P2
        M30
        O2
        G0 X2
        G65 P3
        M99
        O3
        G0 X3
        G65 P4
        M99
        O4
        G0 X4
        G65 P5
        M99
        O5
        G0 X5
        G65 P6
        M99
        O6
        G0 X6
        M99
    """,
    moves_x=[2, 3, 4, 5],
    alarm="macro-nesting-too-deep",
    number="P273",
    at="O5",
)

case(
    "four macro levels on five of M98 are one level too many (MIT-106)",
    pins="nesting_counts_macros",
    control="mitsubishi-m700",
    source="SM 13.9 (6); MZ 842",
    evidence="maker's manual",
    program="""
        O1
        M98 P2
        M30
        O2
        G0 X2
        M98 P3
        M99
        O3
        G0 X3
        M98 P4
        M99
        O4
        G0 X4
        M98 P5
        M99
        O5
        G0 X5
        M98 P6
        M99
        O6
        G0 X6
        G65 P7
        M99
        O7
        G0 X7
        G65 P8
        M99
        O8
        G0 X8
        G65 P9
        M99
        O9
        G0 X9
        G65 P10
        M99
        O10
        G0 X10
        M99
    """,
    moves_x=[2, 3, 4, 5, 6, 7, 8, 9],
    alarm="nesting-too-deep",
    number="P230",
    at="O9",
)

case(
    "G65 without a P alarms on the M700 (MIT-107)",
    control="mitsubishi-m700",
    source="MZ 893, paired with P296",
    evidence="secondary",
    program="""
        O1
        G0 X1
        G65 A1
        M30
    """,
    moves_x=[1],
    alarm="program-number-missing",
    number="P296",
    at="O1",
)

case(
    "an eleventh set of I alarms on the M700 (MIT-111)",
    control="mitsubishi-m700",
    source="MZ 856, paired with P275",
    evidence="secondary",
    program="""
        O1
        G65 P2 I1 I2 I3 I4 I5 I6 I7 I8 I9 I10 I11
        M30
        O2
        M99
    """,
    moves_x=[],
    alarm="too-many-argument-sets",
    number="P275",
    at="O1",
)

case(
    "the second pass of G65 L2 finds the locals as the first left them (MIT-112)",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        G65 P2 L2 A1
        M30
        O2
        G0 X#1
        #1=#1+1
        M99
    """,
    moves_x=[1, 2],
)

MELDAS = "mitsubishi-meldas"
M700 = "mitsubishi-m700"
M800 = "mitsubishi-m800"
NEWER = [M700, M800]
EVERY = [MELDAS, M700, M800]


def macro_chain(levels, first=2):
    """Return macros that call one another with G65: Ok calls in Nk, returns in N(100+k)."""
    text = ""
    for k in range(first, first + levels - 1):
        text += f"O{k}\nN{k} G65 P{k + 1}\nN{100 + k} M99\n"
    last = first + levels - 1
    return text + f"O{last}\nN{last} S{last}\nN{100 + last} M99\n"


# G65

case(
    "G65 calls the macro and its M99 goes on after the G65",
    control=EVERY, source="SM, G65", evidence="maker's manual",
    program="""
        O1
        N10 G65 P200
        N20 M30
        O200
        N210 S1
        N220 M99
    """,
    runs="N10 N210 N220 N20", calls="G65:O200",
)
case(
    "G65 L repeats the macro",
    control=EVERY, source="SM, G65 P_ L_", evidence="maker's manual",
    program="""
        O1
        N10 G65 P200 L3
        N20 M30
        O200
        N210 M99
    """,
    runs="N10 N210*3 N20", calls="G65:O200",
)
case(
    "A, B, C, D, E and F are the arguments #1, #2, #3, #7, #8 and #9",
    control=EVERY, source="general knowledge, argument I", evidence="inferred",
    program="""
        O1
        N10 G65 P200 A1.5 B2.5 C3.5 D7.5 E8.5 F9.5
        N20 M30
        O200
        N210 M99
    """,
    runs="N10 N210 N20", arguments={1: 1.5, 2: 2.5, 3: 3.5, 7: 7.5, 8: 8.5, 9: 9.5},
)
case(
    "H, M, Q, R, S and T are the arguments #11, #13, #17, #18, #19 and #20",
    control=EVERY, source="general knowledge, argument I", evidence="inferred",
    program="""
        O1
        N10 G65 P200 H11.5 M13.5 Q17.5 R18.5 S19.5 T20.5
        N20 M30
        O200
        N210 M99
    """,
    runs="N10 N210 N20", m=[], t=[],
    arguments={11: 11.5, 13: 13.5, 17: 17.5, 18: 18.5, 19: 19.5, 20: 20.5},
)
case(
    "U, V, W, X, Y and Z are the arguments #21 to #26",
    control=EVERY, source="general knowledge, argument I", evidence="inferred",
    program="""
        O1
        N10 G65 P200 Z26.5 Y25.5 X24.5 W23.5 V22.5 U21.5
        N20 M30
        O200
        N210 M99
    """,
    runs="N10 N210 N20",
    arguments={21: 21.5, 22: 22.5, 23: 23.5, 24: 24.5, 25: 25.5, 26: 26.5},
)
case(
    "a second I, J, K group goes on with #7, #8 and #9",
    pins="argument_sets",
    control=EVERY, source="general knowledge, argument II", evidence="inferred",
    program="""
        O1
        N10 G65 P200 I4.5 J5.5 K6.5 I7.5 J8.5 K9.5
        N20 M30
        O200
        N210 M99
    """,
    runs="N10 N210 N20", arguments={4: 4.5, 5: 5.5, 6: 6.5, 7: 7.5, 8: 8.5, 9: 9.5},
)
case(
    "three I in a row are #4, #7 and #10",
    control=EVERY, source="general knowledge, argument II", evidence="inferred",
    program="""
        O1
        N10 G65 P200 I4.5 I7.5 I10.5
        N20 M30
        O200
        N210 M99
    """,
    runs="N10 N210 N20", arguments={4: 4.5, 7: 7.5, 10: 10.5},
)
case(
    "the tenth K is #33",
    control=EVERY, source="general knowledge, argument II", evidence="inferred",
    program="O1\nN10 G65 P200 " + " ".join(f"K{k}.5" for k in range(1, 11)) + "\nN20 M30\n"
    "O200\nN210 M99\n",
    runs="N10 N210 N20", arguments={3 * k + 3: k + 0.5 for k in range(1, 11)},
)
case(
    "an eleventh J is one group too many",
    control=EVERY, source="MZ 856, P275 paired", evidence="inferred",
    program="O1\nN10 G65 P200 " + " ".join(f"J{k}." for k in range(1, 12)) + "\nN20 M30\n"
    "O200\nN210 M99\n",
    runs="", alarm="too-many-argument-sets", number="P275", at="O1 N10",
)
case(
    "where arguments I and II meet in one variable the later word counts",
    control=EVERY, source="general knowledge, I and II mixed", evidence="inferred",
    program="""
        O1
        N10 G65 P200 I4. I7. D17.
        N20 G65 P200 D17. I4. I7.
        N30 M30
        O200
        N210 #101=#100
        N220 #100=#7
        N230 M99
    """,
    variables={100: None}, runs="N10 N210 N220 N230 N20 N210 N220 N230 N30",
    vars={101: 17, 100: 7},
)
case(
    "the manual's mixed example gives #1, #2, #4 and #7",
    control=EVERY, source="general knowledge, I and II mixed", evidence="inferred",
    program="""
        O1
        N10 G65 P200 A1.1 B-2.2 D3.3 I4.4 I7.7
        N20 M30
        O200
        N210 M99
    """,
    runs="N10 N210 N20", arguments={1: 1.1, 2: -2.2, 4: 4.4, 7: 7.7},
)
case(
    "an argument that was not written is vacant in the macro",
    control=EVERY, source="general knowledge, locals per level", evidence="inferred",
    program="""
        O1
        N10 #2=8
        N20 G65 P200 A1.
        N30 M30
        O200
        N210 #100=#2
        N220 M99
    """,
    variables={100: 5}, runs="N10 N20 N210 N220 N30", vars={100: None, 2: 8},
)
case(
    "an argument from a vacant variable stays vacant",
    control=EVERY, source="general knowledge, vacant", evidence="inferred",
    program="""
        O1
        N10 G65 P200 A#5 B2.
        N20 M30
        O200
        N210 #100=#1
        N220 M99
    """,
    variables={100: 5}, runs="N10 N210 N220 N20", vars={100: None},
)
case(
    "an argument may be an expression of the caller's variables",
    control=EVERY, source="general knowledge, locals per level", evidence="inferred",
    program="""
        O1
        N10 #1=10
        N20 G65 P200 A[#1*2] B#1
        N30 M30
        O200
        N210 M99
    """,
    runs="N10 N20 N210 N30", arguments={1: 20, 2: 10},
)
case(
    "what a macro writes into its locals is gone after M99",
    control=EVERY, source="SM, differences of M98 and G65 (5)", evidence="maker's manual",
    program="""
        O1
        N10 #3=5
        N20 G65 P200 C1.
        N30 M30
        O200
        N210 #3=99
        N220 #4=99
        N230 M99
    """,
    runs="N10 N20 N210 N220 N230 N30", vars={3: 5, 4: None},
)
case(
    "a macro's locals are fresh on a second call",
    control=EVERY, source="general knowledge, locals per level", evidence="inferred",
    program="""
        O1
        N10 G65 P200
        N20 G65 P200
        N30 M30
        O200
        N210 #100=#5
        N220 #5=7
        N230 M99
    """,
    variables={100: 3}, runs="N10 N210 N220 N230 N20 N210 N220 N230 N30", vars={100: None},
)
case(
    "a subprogram called by a macro works on the macro's locals",
    control=EVERY, source="SM, differences of M98 and G65 (5)", evidence="maker's manual",
    program="""
        O1
        N10 G65 P200 A4.
        N20 M30
        O200
        N210 M98 P300
        N220 #100=#1
        N230 M99
        O300
        N310 #1=#1+1
        N320 M99
    """,
    runs="N10 N210 N310 N320 N220 N230 N20", vars={100: 5, 1: None},
)
case(
    "the locals of a macro keep their values from repeat to repeat",
    control=[MELDAS, M800], source="general knowledge, arguments written once",
    evidence="inferred",
    program="""
        O1
        N10 G65 P200 L3 A1.
        N20 M30
        O200
        N210 #1=#1*2
        N220 #100=#1
        N230 M99
    """,
    runs="N10 (N210 N220 N230)*3 N20", vars={100: 8},
)
case(
    "H of a G65 block is an argument and no start block",
    pins="h_codes",
    control=EVERY, source="SM, differences of M98 and G65 (2)", evidence="maker's manual",
    program="""
        O1
        N10 G65 P200 H220
        N20 M30
        O200
        N210 S1
        N220 M99
    """,
    runs="N10 N210 N220 N20", arguments={11: 220},
)
case(
    "a G65 block executes nothing but the call",
    control=EVERY, source="SM, differences of M98 and G65 (3)", evidence="maker's manual",
    program="""
        O1
        N10 G65 P200 T7 M8
        N20 M30
        O200
        N210 M99
    """,
    runs="N10 N210 N20", t=[], m=[],
)
case(
    "words in front of G65 are ordinary words",
    pins="words_before_macro_call",
    control=EVERY, source="general knowledge, arguments follow G65", evidence="inferred",
    program="""
        O1
        N10 T7 G65 P200 A1.
        N20 M30
        O200
        N210 M99
    """,
    runs="N10 N210 N20", t=[7], arguments={1: 1},
)
case(
    "P may stand after the arguments",
    control=EVERY, source="general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 A1. B2. P200
        N20 M30
        O200
        N210 M99
    """,
    runs="N10 N210 N20", arguments={1: 1, 2: 2},
)
case(
    "G65 without P is P296 although arguments stand there",
    control=EVERY, source="MZ 893, P296 paired", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 G65 L2 B3.
        N30 M30
    """,
    runs="N10", alarm="program-number-missing", number="P296", at="O1 N20",
)
case(
    "G65 of a program that does not exist is P232",
    control=EVERY, source="source 004, note 1", evidence="inferred",
    program="""
        O1
        N10 G65 P200 A1.
        N20 M30
    """,
    runs="", calls="", alarm="program-not-found", number="P232", at="O1 N10", word="P200",
)
case(
    "a decimal point in the P of G65 is a format error",
    control=EVERY, source="SK P33; general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P200. A1.
        N20 M30
        O200
        N210 M99
    """,
    runs="", alarm="illegal-decimal-point", number="P33", at="O1 N10", word="P200.",
)
case(
    "10000 repeats of a macro are refused",
    control=EVERY, source="SK P35; general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P200 L10000
        N20 M30
        O200
        N210 M99
    """,
    runs="", alarm="repeat-count-digits", number="P35", at="O1 N10", word="L10000",
)
case(
    "G65 takes a file name with its arguments",
    control=NEWER, source="IMD, <file name>", evidence="inferred",
    files={"O1.NC": "O1\nN10 G65 <BORE.NC> L2 A1.\nN20 M30\n", "BORE.NC": "N210 M99\n"},
    main="O1", runs="N10 N210*2 N20", arguments={1: 1},
)
case(
    "G65 of a file that does not exist is P232",
    control=NEWER, source="IMD, <file name>; source 004, note 1", evidence="inferred",
    files={"O1.NC": "O1\nN10 G65 <BORE.NC> A1.\nN20 M30\n", "SLOT.NC": "N210 M99\n"},
    main="O1", runs="", alarm="named-program-not-found", number="P232", at="O1 N10",
)
case(
    "M99 P of a macro returns to the block of its caller",
    control=EVERY, source="source 004, M99 P", evidence="inferred",
    program="""
        O1
        N10 G65 P200
        N20 S2
        N30 M30
        O200
        N210 M99 P30
    """,
    runs="N10 N210 N30",
)
case(
    "M99 P of a macro that names no block of the caller is P231",
    control=EVERY, source="source 004, M99 note 1", evidence="inferred",
    program="""
        O1
        N10 G65 P200
        N20 M30
        O200
        N210 M99 P30
    """,
    runs="N10", alarm="return-target-not-found", number="P231", at="O200 N210", word="P30",
)

# Macro levels

case(
    "four macros inside each other are legal",
    pins="max_macro_nesting",
    control=EVERY, source="SM (6)", evidence="maker's manual",
    program="O1\nN1 G65 P2\nN101 M30\n" + macro_chain(4),
    runs="N1 N2 N3 N4 N5 N105 N104 N103 N102 N101",
    calls="G65:O2 G65:O3 G65:O4 G65:O5",
)
case(
    "a fifth macro level is P273 on the newer controls",
    control=NEWER, source="SM (6); MZ 855, P273 paired", evidence="inferred",
    program="O1\nN1 G65 P2\nN101 M30\n" + macro_chain(5),
    runs="N1 N2 N3 N4", alarm="macro-nesting-too-deep", number="P273", at="O5 N5",
)
case(
    "a macro that calls itself ends in P273",
    control=NEWER, source="SM (6); MZ 855, P273 paired", evidence="inferred",
    program="""
        O1
        N10 G65 P200
        N20 M30
        O200
        N210 G65 P200
        N220 M99
    """,
    runs="N10 N210*3", alarm="macro-nesting-too-deep", number="P273", at="O200 N210",
)
case(
    "a macro level that was left may be used again",
    control=NEWER, source="SM (6)", evidence="maker's manual",
    program="O1\nN1 G65 P2\nN101 G65 P2\nN201 M30\n" + macro_chain(4),
    runs="N1 N2 N3 N4 N5 N105 N104 N103 N102 N101 N2 N3 N4 N5 N105 N104 N103 N102 N201",
)
case(
    "subprograms between the macros are no macro levels",
    control=NEWER, source="SM (6)", evidence="maker's manual",
    program="""
        O1
        N1 M98 P2
        N101 M30
        O2
        N2 M98 P3
        N102 M99
        O3
        N3 M98 P4
        N103 M99
        O4
        N4 M98 P5
        N104 M99
    """ + "\n".join("        " + line for line in macro_chain(5, first=5).splitlines()) + "\n",
    runs="N1 N2 N3 N4 N5 N6 N7 N8 N9 N109 N108 N107 N106 N105 N104 N103 N102 N101",
)
case(
    "M800: six subprograms and four macros are ten levels",
    control=M800, source="SM (6); general knowledge, total 10", evidence="inferred",
    program="O1\nN1 M98 P2\nN101 M30\n"
    + "".join(f"O{k}\nN{k} M98 P{k + 1}\nN{100 + k} M99\n" for k in range(2, 7))
    + macro_chain(5, first=7),
    runs=" ".join(f"N{k}" for k in range(1, 12)) + " "
    + " ".join(f"N{100 + k}" for k in range(11, 0, -1)),
)
case(
    "M800: a fourth macro over seven subprograms is P230",
    pins="nesting_counts_macros",
    control=M800, source="SM (6); general knowledge, total 10", evidence="inferred",
    program="O1\nN1 M98 P2\nN101 M30\n"
    + "".join(f"O{k}\nN{k} M98 P{k + 1}\nN{100 + k} M99\n" for k in range(2, 8))
    + macro_chain(5, first=8),
    runs=" ".join(f"N{k}" for k in range(1, 11)),
    alarm="nesting-too-deep", number="P230", at="O11 N11",
)
case(
    "M700: a subprogram over four subprograms and four macros is P230",
    control=M700, source="SM (6); MZ 842", evidence="maker's manual",
    program="O1\nN1 G65 P2\nN101 M30\n"
    + "".join(f"O{k}\nN{k} G65 P{k + 1}\nN{100 + k} M99\n" for k in range(2, 5))
    + "".join(f"O{k}\nN{k} M98 P{k + 1}\nN{100 + k} M99\n" for k in range(5, 10))
    + "O10\nN10 S1\nN110 M99\n",
    runs="N1 N2 N3 N4 N5 N6 N7 N8", alarm="nesting-too-deep", number="P230", at="O9 N9",
)
