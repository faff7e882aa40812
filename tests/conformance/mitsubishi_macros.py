"""User macros of the Mitsubishi controls: macro calls, statements, expressions and variables.

The numbers of the P alarms from P240 on were paired with causes that the sources name,
so rows that show one are marked inferred.
"""

from conformance import case

MELDAS = "mitsubishi-meldas"
M700 = "mitsubishi-m700"
M800 = "mitsubishi-m800"
NEWER = [M700, M800]
EVERY = [MELDAS, M700, M800]

# The registration of codes that call: these parameters stand for the control's own screen.
G300_CALLS_O9010 = {"6050": 300}
M100_CALLS_O9001 = {"6071": 100}  # as a subprogram
M100_CALLS_O9020 = {"6080": 100}  # as a macro


def macro_chain(levels, first=2):
    """Macros that call one another with G65: Ok calls in Nk, returns in N(100+k)."""
    text = ""
    for k in range(first, first + levels - 1):
        text += f"O{k}\nN{k} G65 P{k + 1}\nN{100 + k} M99\n"
    last = first + levels - 1
    return text + f"O{last}\nN{last} S{last}\nN{100 + last} M99\n"


def loops(depth, body):
    """`depth` DO loops inside each other, each left after one pass."""
    text = ""
    for k in range(1, depth + 1):
        text += f"#{100 + k}=0\nN{k} WHILE[#{100 + k} LT 1]DO{k}\n#{100 + k}=1\n"
    text += body
    return text + "".join(f"END{k}\n" for k in range(depth, 0, -1))


# G65

case(
    "G65 calls the macro and its M99 goes on behind the G65",
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
    "P may stand behind the arguments",
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

# G66, G66.1, G67

case(
    "the block of G66 itself calls nothing",
    control=EVERY, source="general knowledge, G66", evidence="inferred",
    program="""
        O1
        N10 G66 P200 A1.
        N20 G67
        N30 M30
        O200
        N210 M99
    """,
    runs="N10 N20 N30", calls="",
)
case(
    "under G66 every block that moves an axis is followed by the macro",
    control=EVERY, source="general knowledge, G66", evidence="inferred",
    program="""
        O1
        N10 G66 P200 A1.
        N20 G0 X5.
        N30 G0 Y5.
        N40 G67
        N50 M30
        O200
        N210 M99
    """,
    runs="N10 N20 N210 N30 N210 N40 N50", calls="G66:O200 G66:O200",
)
case(
    "under G66 blocks without a move call nothing",
    control=EVERY, source="general knowledge, G66", evidence="inferred",
    program="""
        O1
        N10 G66 P200
        N20 M8
        N30 S500
        N40 #100=1
        N50 G67
        N60 M30
        O200
        N210 M99
    """,
    runs="N10 N20 N30 N40 N50 N60", calls="",
)
case(
    "G66 L calls the macro L times after each move",
    control=EVERY, source="general knowledge, G66", evidence="inferred",
    program="""
        O1
        N10 G66 P200 L3
        N20 G0 X5.
        N30 G67
        N40 M30
        O200
        N210 M99
    """,
    runs="N10 N20 N210*3 N30 N40",
)
case(
    "the arguments of G66 arrive in its macro",
    control=EVERY, source="general knowledge, G66", evidence="inferred",
    program="""
        O1
        N10 G66 P200 B2.5
        N20 G0 X5.
        N30 G67
        N40 M30
        O200
        N210 #100=#2
        N220 M99
    """,
    runs="N10 N20 N210 N220 N30 N40", vars={100: 2.5},
)
case(
    "after G67 a move calls nothing",
    control=EVERY, source="general knowledge, G67", evidence="inferred",
    program="""
        O1
        N10 G66 P200
        N20 G67
        N30 G0 X5.
        N40 M30
        O200
        N210 M99
    """,
    runs="N10 N20 N30 N40", calls="",
)
case(
    "moves in a subprogram call the modal macro too",
    control=NEWER, source="general knowledge, G66", evidence="inferred",
    program="""
        O1
        N10 G66 P200
        N20 M98 P300
        N30 G67
        N40 M30
        O200
        N210 M99
        O300
        N310 G0 X5.
        N320 M99
    """,
    runs="N10 N20 N310 N210 N320 N30 N40",
)
case(
    "of two G66 the last is called after a move and its own moves call the first",
    control=NEWER, source="general knowledge, G66 nested", evidence="inferred",
    program="""
        O1
        N10 G66 P200
        N20 G66 P300
        N30 G0 X5.
        N40 G67
        N50 G67
        N60 M30
        O200
        N210 M99
        O300
        N310 G0 X7.
        N320 M99
    """,
    runs="N10 N20 N30 N310 N210 N320 N40 N50 N60",
)
case(
    "one G67 cancels the last G66 only",
    control=NEWER, source="general knowledge, G67", evidence="inferred",
    program="""
        O1
        N10 G66 P200
        N20 G66 P300
        N30 G67
        N40 G0 X5.
        N50 G67
        N60 M30
        O200
        N210 M99
        O300
        N310 M99
    """,
    runs="N10 N20 N30 N40 N210 N50 N60",
)
case(
    "G67 with no modal call is P276",
    control=EVERY, source="MZ 857, P276 paired", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 G67
        N30 M30
    """,
    runs="N10", alarm="modal-call-missing", number="P276", at="O1 N20",
)
case(
    "a second G67 for one G66 is P276",
    control=EVERY, source="MZ 857, P276 paired", evidence="inferred",
    program="""
        O1
        N10 G66 P200
        N20 G67
        N30 G67
        N40 M30
        O200
        N210 M99
    """,
    runs="N10 N20", alarm="modal-call-missing", number="P276", at="O1 N30",
)
case(
    "G66 without P is P296",
    control=EVERY, source="MZ 893, P296 paired", evidence="inferred",
    program="""
        O1
        N10 G66 A1.
        N20 G67
        N30 M30
    """,
    runs="", alarm="program-number-missing", number="P296", at="O1 N10",
)
case(
    "G66.1 without P is P296",
    control=EVERY, source="MZ 893, P296 paired", evidence="inferred",
    program="""
        O1
        N10 G66.1 A1.
        N20 G67
        N30 M30
    """,
    runs="", alarm="program-number-missing", number="P296", at="O1 N10",
)
case(
    "under G66.1 every block calls and its words are arguments",
    control=EVERY, source="general knowledge, G66.1", evidence="inferred",
    program="""
        O1
        N10 G66.1 P200
        N20 X5. F400
        N30 G67
        N40 M30
        O200
        N210 #100=#24
        N220 #101=#9
        N230 M99
    """,
    runs="N10 N20 N210 N220 N230 N30 N40", calls="G66.1:O200", vars={100: 5, 101: 400},
)
case(
    "under G66.1 an M code is an argument and not sent",
    control=EVERY, source="general knowledge, G66.1", evidence="inferred",
    program="""
        O1
        N10 G66.1 P200
        N20 M8
        N30 G67
        N40 M30
        O200
        N210 #100=#13
        N220 M99
    """,
    runs="N10 N20 N210 N220 N30 N40", m=[], vars={100: 8},
)
case(
    "only under G66.1 is G an argument: #10",
    control=EVERY, source="general knowledge, G66.1", evidence="inferred",
    program="""
        O1
        N10 G66.1 P200
        N20 G1 X5.
        N30 G67
        N40 M30
        O200
        N210 #100=#10
        N220 M99
    """,
    runs="N10 N20 N210 N220 N30 N40", vars={100: 1},
)
case(
    "a macro that is missing when a modal call is made is P232",
    control=EVERY, source="source 004, note 1", evidence="inferred",
    program="""
        O1
        N10 G66.1 P200
        N20 X5.
        N30 G67
        N40 M30
    """,
    runs=None, calls="", alarm="program-not-found", number="P232",
)

# Codes that call

case(
    "a registered G code calls its macro with arguments",
    control=EVERY, source="general knowledge, G-code call", evidence="inferred",
    program="""
        O1
        N10 G300 A1.5
        N20 M30
        O9010
        N210 #100=#1
        N220 M99
    """,
    params=G300_CALLS_O9010, runs="N10 N210 N220 N20", calls="G-code:O9010",
    vars={100: 1.5},
)
case(
    "an M code that calls a subprogram shares the caller's locals",
    control=EVERY, source="general knowledge, M-code call", evidence="inferred",
    program="""
        O1
        N10 #1=5
        N20 M100
        N30 M30
        O9001
        N210 #1=#1+1
        N220 M99
    """,
    params=M100_CALLS_O9001, runs="N10 N20 N210 N220 N30", m=[], vars={1: 6},
)
case(
    "the subprogram of a calling M code must exist: P232",
    control=EVERY, source="source 004, note 1; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 M100
        N30 M30
    """,
    params=M100_CALLS_O9001, runs="N10", m=[8], alarm="program-not-found", number="P232",
    at="O1 N20",
)
case(
    "inside a macro that a G code called, a calling G code is the plain code",
    pins="g_codes_complete code_cascade",
    control=EVERY, source="general knowledge, G-code call", evidence="inferred",
    program="""
        O1
        N10 G300
        N20 M30
        O9010
        N210 G300 X5.
        N220 M99
    """,
    params=G300_CALLS_O9010, runs="N10", calls="G-code:O9010",
    alarm="g-code-not-available", number="P34", at="O9010 N210",
)
case(
    "the program of a calling G code must exist: P232",
    control=EVERY, source="source 004, note 1; general knowledge", evidence="inferred",
    program="""
        O1
        N10 G300 A1.
        N20 M30
    """,
    params=G300_CALLS_O9010, runs="", alarm="program-not-found", number="P232", at="O1 N10",
)
case(
    "a G code that no parameter names is P34",
    control=EVERY, source="SK P34", evidence="secondary",
    program="""
        O1
        N10 G999
        N20 M30
    """,
    runs="", alarm="g-code-not-available", number="P34", at="O1 N10", word="G999",
)
case(
    "a calling M code is not sent to the machine",
    control=EVERY, source="general knowledge, M-code call", evidence="inferred",
    program="""
        O1
        N10 M100
        N20 M8
        N30 M30
        O9020
        N210 M99
    """,
    params=M100_CALLS_O9020, runs="N10 N210 N20 N30", m=[8], calls="M-code:O9020",
)
case(
    "an M code that calls a macro passes the words of its block",
    control=EVERY, source="general knowledge, M-code call", evidence="inferred",
    program="""
        O1
        N10 M100 A3.5
        N20 M30
        O9020
        N210 #100=#1
        N220 M99
    """,
    params=M100_CALLS_O9020, runs="N10 N210 N220 N20", vars={100: 3.5, 1: None},
)
case(
    "inside the macro of an M code the same M code goes to the machine",
    control=EVERY, source="general knowledge, M-code call", evidence="inferred",
    program="""
        O1
        N10 M100
        N20 M30
        O9020
        N210 M100
        N220 M99
    """,
    params=M100_CALLS_O9020, runs="N10 N210 N220 N20", m=[100], calls="M-code:O9020",
)
case(
    "the program of a calling M code must exist: P232",
    control=EVERY, source="source 004, note 1; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 M100
        N30 M30
    """,
    params=M100_CALLS_O9020, runs="N10", alarm="program-not-found", number="P232",
    at="O1 N20",
)
case(
    "a call by code counts as a macro level",
    control=NEWER, source="SM (6); general knowledge", evidence="inferred",
    program="""
        O1
        N1 M100
        N101 M30
        O9020
        N9 G65 P2
        N109 M99
    """ + "\n".join("        " + line for line in macro_chain(4).splitlines()) + "\n",
    params=M100_CALLS_O9020, runs="N1 N9 N2 N3", alarm="macro-nesting-too-deep",
    number="P273", at="O4 N4",
)

# IF and GOTO

case(
    "GOTO goes on at the named block",
    control=EVERY, source="general knowledge, GOTO", evidence="inferred",
    program="""
        O1
        N10 GOTO30
        N20 S2
        N30 M30
    """,
    runs="N10 N30",
)
case(
    "a GOTO to a block that does not exist is P231",
    control=EVERY, source="MZ 843; source 004, P231", evidence="secondary",
    program="""
        O1
        N10 S1
        N20 GOTO99
        N30 M30
    """,
    runs="N10", alarm="jump-target-not-found", number="P231", at="O1 N20",
)
case(
    "GOTO does not look into another program",
    control=EVERY, source="MZ 843; source 004, P231", evidence="secondary",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 GOTO20
        N220 M99
    """,
    runs="N10", alarm="jump-target-not-found", number="P231", at="O200 N210",
)
case(
    "GOTO takes the next block with the number, not the first of the program",
    control=[MELDAS, M800], source="general knowledge, forward to the end, then from the head",
    evidence="inferred",
    program="""
        O1
        N10 GOTO40
        N20 S1
        N30 M30
        N40 GOTO20
        N50 S5
        N20 M30
    """,
    runs="N10 N40 N20",
)
case(
    "GOTO searches from the head when nothing stands behind it",
    control=EVERY, source="general knowledge, forward to the end, then from the head",
    evidence="inferred",
    program="""
        O1
        N10 #1=#1+1
        N20 S2
        N30 IF[#1 LT 3]GOTO10
        N40 M30
    """,
    runs="(N10 N20 N30)*3 N40", vars={1: 3},
)
case(
    "of two blocks in front of a GOTO the first of the program counts",
    control=EVERY, source="general knowledge, forward to the end, then from the head",
    evidence="inferred",
    program="""
        O1
        N5 GOTO40
        N10 M30
        N10 S2
        N40 GOTO10
    """,
    runs="N5 N40 N10",
)
case(
    "the target of GOTO may be a variable",
    control=EVERY, source="general knowledge, GOTO n", evidence="inferred",
    program="""
        O1
        N10 #1=40
        N20 GOTO#1
        N30 S3
        N40 M30
    """,
    runs="N10 N20 N40",
)
case(
    "the target of GOTO may be an expression",
    control=EVERY, source="general knowledge, GOTO n", evidence="inferred",
    program="""
        O1
        N10 #1=3
        N20 GOTO[#1*10+10]
        N30 S3
        N40 M30
    """,
    runs="N10 N20 N40",
)
case(
    "a computed GOTO to a block that does not exist is P231",
    control=EVERY, source="MZ 843; source 004, P231", evidence="inferred",
    program="""
        O1
        N10 #1=3
        N20 GOTO[#1*10+1]
        N30 M30
    """,
    runs="N10", alarm="jump-target-not-found", number="P231", at="O1 N20",
)
case(
    "a false IF asks for no target",
    control=EVERY, source="general knowledge, IF", evidence="inferred",
    program="""
        O1
        N10 IF[1 EQ 2]GOTO99
        N20 M30
    """,
    runs="N10 N20",
)
case(
    "a true IF whose target is missing is P231",
    control=EVERY, source="MZ 843; source 004, P231", evidence="secondary",
    program="""
        O1
        N10 IF[2 EQ 2]GOTO99
        N20 M30
    """,
    runs="", alarm="jump-target-not-found", number="P231", at="O1 N10",
)
case(
    "a true IF without the number behind GOTO is P290",
    control=EVERY, source="general knowledge, IF; MZ 864, P290 paired", evidence="inferred",
    program="""
        O1
        N10 IF[2 EQ 2]GOTO
        N20 M30
    """,
    runs="", alarm="if-format", number="P290", at="O1 N10",
)
case(
    "an IF without brackets is P290",
    control=EVERY, source="MZ 864, P290 paired", evidence="inferred",
    program="""
        O1
        N10 IF 2 EQ 2 GOTO20
        N20 M30
    """,
    runs="", alarm="if-format", number="P290", at="O1 N10",
)
case(
    "an IF with a condition and nothing behind it is P290",
    control=EVERY, source="MZ 864, P290 paired", evidence="inferred",
    program="""
        O1
        N10 IF[2 EQ 2]
        N20 M30
    """,
    runs="", alarm="if-format", number="P290", at="O1 N10",
)
case(
    "the N of a jump target must stand at the head of its block",
    control=EVERY, source="general knowledge, N at the head; source 004, P231",
    evidence="inferred",
    program="""
        O1
        N10 GOTO40
        N20 S2
        S4 N40
        N50 M30
    """,
    runs="", alarm="jump-target-not-found", number="P231", at="O1 N10",
)
case(
    "a jump finds the block behind a block skip that is on and goes on with the next",
    control=EVERY, source="general knowledge", evidence="inferred",
    program="""
        O1
        N10 GOTO30
        N20 S2
        /N30 S3
        N40 M30
    """,
    skip=(1,), runs="N10 N40",
)
for operator, yes, no in [
    ("EQ", "5", "4"), ("NE", "4", "5"), ("GT", "4", "5"), ("LT", "6", "5"), ("GE", "5", "6"),
    ("LE", "5", "4"),
]:
    case(
        f"{operator} jumps when 5 {operator} {yes} and not when 5 {operator} {no}",
        control=EVERY, source="general knowledge, condition operators", evidence="inferred",
        program=f"""
            O1
            N10 #1=5
            N20 IF[#1 {operator} {no}]GOTO50
            N30 IF[#1 {operator} {yes}]GOTO50
            N40 S4
            N50 M30
        """,
        runs="N10 N20 N30 N50",
    )
case(
    "an operator that does not exist is P290",
    control=EVERY, source="MZ 864, P290 paired", evidence="inferred",
    program="""
        O1
        N10 IF[#1 ET 5]GOTO20
        N20 M30
    """,
    runs="", alarm="if-format", number="P290", at="O1 N10",
)
case(
    "M700: IF THEN takes one statement in the block",
    control=NEWER, source="general knowledge, IF THEN", evidence="inferred",
    program="""
        O1
        N10 IF[1 EQ 1]THEN #100=7
        N20 IF[1 EQ 2]THEN #101=8
        N30 M30
    """,
    variables={101: 1}, runs="N10 N20 N30", vars={100: 7, 101: 1},
)
case(
    "MELDAS has no IF THEN",
    control=MELDAS, source="general knowledge, IF THEN; MZ 864, P290 paired", evidence="inferred",
    program="""
        O1
        N10 IF[1 EQ 1]THEN #100=7
        N20 M30
    """,
    runs="", alarm="if-format", number="P290", at="O1 N10",
)
case(
    "M700: an IF THEN with nothing behind it is P290",
    control=M700, source="general knowledge, IF THEN; MZ 864, P290 paired", evidence="inferred",
    program="""
        O1
        N10 IF[1 EQ 1]THEN
        N20 #100=7
        N30 ENDIF
        N40 M30
    """,
    runs="", alarm="if-format", number="P290", at="O1 N10",
)

# IF THEN ELSE ENDIF blocks of the M800

case(
    "M800: a true IF block runs its first part and not the ELSE part",
    control=M800, source="general knowledge, IF blocks", evidence="inferred",
    program="""
        O1
        N10 IF[#100 EQ 1]THEN
        N20 S2
        N30 S3
        ELSE
        N40 S4
        ENDIF
        N50 M30
    """,
    variables={100: 1}, runs="N10 N20 N30 N50",
)
case(
    "M800: a false IF block runs the ELSE part",
    control=M800, source="general knowledge, IF blocks", evidence="inferred",
    program="""
        O1
        N10 IF[#100 EQ 1]THEN
        N20 S2
        ELSE
        N40 S4
        N45 S5
        ENDIF
        N50 M30
    """,
    variables={100: 2}, runs="N10 N40 N45 N50",
)
case(
    "M800: a false IF block without ELSE goes on behind its ENDIF",
    control=M800, source="general knowledge, IF blocks", evidence="inferred",
    program="""
        O1
        N10 IF[#100 EQ 1]THEN
        N20 S2
        ENDIF
        N50 M30
    """,
    variables={100: 2}, runs="N10 N50",
)
case(
    "M800: an ELSE belongs to the innermost open IF",
    control=M800, source="general knowledge, IF blocks", evidence="inferred",
    program="""
        O1
        N10 IF[#100 EQ 1]THEN
        N20 IF[#101 EQ 1]THEN
        N30 S3
        ELSE
        N40 S4
        ENDIF
        ENDIF
        N50 M30
    """,
    variables={100: 1, 101: 0}, runs="N10 N20 N40 N50",
)
case(
    "M800: a false outer IF jumps over an inner IF with its ELSE",
    control=M800, source="general knowledge, IF blocks", evidence="inferred",
    program="""
        O1
        N10 IF[#100 EQ 1]THEN
        N20 IF[#101 EQ 1]THEN
        N30 S3
        ELSE
        N40 S4
        ENDIF
        ELSE
        N45 S5
        ENDIF
        N50 M30
    """,
    variables={100: 0, 101: 0}, runs="N10 N45 N50",
)
case(
    "M800: a single IF THEN inside an IF block needs no ENDIF",
    control=M800, source="general knowledge, IF blocks", evidence="inferred",
    program="""
        O1
        N10 IF[#100 EQ 1]THEN
        N20 IF[#100 EQ 1]THEN #101=4
        N30 S3
        ENDIF
        N50 M30
    """,
    variables={100: 1}, runs="N10 N20 N30 N50", vars={101: 4},
)
case(
    "M800: a call inside an IF block comes back into it",
    control=M800, source="general knowledge, IF blocks", evidence="inferred",
    program="""
        O1
        N10 IF[#100 EQ 1]THEN
        N20 M98 P200
        N30 S3
        ENDIF
        N50 M30
        O200
        N210 M99
    """,
    variables={100: 1}, runs="N10 N20 N210 N30 N50",
)
case(
    "M800: an IF block without ENDIF is P289",
    control=M800, source="general knowledge, P289", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 IF[#100 EQ 1]THEN
        N30 S3
        N50 M30
    """,
    variables={100: 0}, runs="N10", alarm="if-without-end", number="P289", at="O1 N20",
)
case(
    "M800: an ENDIF without IF is P289",
    control=M800, source="general knowledge, P289", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 ENDIF
        N50 M30
    """,
    runs="N10", alarm="if-without-end", number="P289", at="O1 N20",
)
case(
    "M800: an ELSE without IF is P289",
    control=M800, source="general knowledge, P289", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 ELSE
        N30 S3
        N50 M30
    """,
    runs="N10", alarm="if-without-end", number="P289", at="O1 N20",
)
case(
    "M800: an ENDIF of another program does not end an IF",
    control=M800, source="general knowledge, P289", evidence="inferred",
    program="""
        O1
        N10 IF[#100 EQ 1]THEN
        N20 M30
        O200
        N210 ENDIF
        N220 M99
    """,
    variables={100: 0}, runs="", alarm="if-without-end", number="P289", at="O1 N10",
)
case(
    "M800: ten IF blocks inside each other are legal",
    pins="max_ifs",
    control=M800, source="general knowledge, IF nesting 10", evidence="inferred",
    program="O1\n" + "".join(f"N{k} IF[1 EQ 1]THEN\n" for k in range(1, 11)) + "N20 S1\n"
    + "ENDIF\n" * 10 + "N30 M30\n",
    runs=" ".join(f"N{k}" for k in range(1, 11)) + " N20 N30",
)
case(
    "M800: an eleventh IF block inside is P288",
    control=M800, source="general knowledge, IF nesting 10", evidence="inferred",
    program="O1\n" + "".join(f"N{k} IF[1 EQ 1]THEN\n" for k in range(1, 12)) + "N20 S1\n"
    + "ENDIF\n" * 11 + "N30 M30\n",
    runs=" ".join(f"N{k}" for k in range(1, 11)), alarm="if-too-deep", number="P288",
    at="O1 N11",
)

# WHILE, DO, END

case(
    "a WHILE loop runs until its condition is false",
    control=EVERY, source="general knowledge, WHILE", evidence="inferred",
    program="""
        O1
        N10 #1=3
        N20 WHILE[#1 GT 0]DO1
        N30 #1=#1-1
        N40 END1
        N50 M30
    """,
    runs="N10 (N20 N30 N40)*3 N20 N50", vars={1: 0},
)
case(
    "a WHILE that is false from the start goes on behind its END",
    control=EVERY, source="general knowledge, WHILE", evidence="inferred",
    program="""
        O1
        N10 WHILE[1 GT 2]DO5
        N20 S2
        N30 END5
        N40 M30
    """,
    runs="N10 N40",
)
case(
    "DO127 is a loop like any other",
    pins="max_loop_number",
    control=EVERY, source="general knowledge, m 1 to 127", evidence="inferred",
    program="""
        O1
        N10 WHILE[#1 LT 2]DO127
        N20 #1=#1+1
        N30 END127
        N40 M30
    """,
    runs="(N10 N20 N30)*2 N10 N40",
)
case(
    "DO without WHILE never ends by itself",
    control=EVERY, source="general knowledge, DO", evidence="inferred",
    program="""
        O1
        N10 DO1
        N20 S2
        N30 END1
        N40 M30
    """,
    max_blocks=6, runs="(N10 N20 N30)*2", stop="limit",
)
case(
    "a jump out of a DO loop is allowed",
    control=EVERY, source="general knowledge, DO", evidence="inferred",
    program="""
        O1
        N10 DO1
        N20 #1=#1+1
        N30 IF[#1 EQ 2]GOTO50
        N40 END1
        N50 M30
    """,
    runs="N10 N20 N30 N40 N10 N20 N30 N50",
)
case(
    "a jump into a DO loop is P294",
    control=EVERY, source="general knowledge, DO; MZ 868, P294 paired", evidence="inferred",
    program="""
        O1
        N10 GOTO30
        N20 WHILE[1 EQ 1]DO1
        N30 S3
        N40 END1
        N50 M30
    """,
    runs=None, alarm="missing-do", number="P294",
)
case(
    "a WHILE loop without its END is P294 even when it would not run",
    control=EVERY, source="MZ 868, P294 paired", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 WHILE[1 EQ 2]DO1
        N30 S3
        N40 M30
    """,
    runs="N10", alarm="missing-end", number="P294", at="O1 N20",
)
case(
    "END without DO is P294",
    control=EVERY, source="MZ 868, P294 paired", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 END1
        N30 M30
    """,
    runs="N10", alarm="missing-do", number="P294", at="O1 N20",
)
case(
    "an END of another number does not end a loop",
    control=EVERY, source="MZ 868, P294 paired", evidence="inferred",
    program="""
        O1
        N10 WHILE[1 EQ 2]DO1
        N20 S2
        N30 END2
        N40 M30
    """,
    runs="", alarm="missing-end", number="P294", at="O1 N10",
)
case(
    "the END of a loop must stand in the same program",
    control=EVERY, source="general knowledge, END; MZ 868, P294 paired", evidence="inferred",
    program="""
        O1
        N10 WHILE[1 EQ 1]DO1
        N20 M98 P200
        N30 M30
        O200
        N210 END1
        N220 M99
    """,
    runs="", alarm="missing-end", number="P294", at="O1 N10",
)
case(
    "loops that cross are P294",
    control=EVERY, source="MZ 868, P294 paired", evidence="inferred",
    program="""
        O1
        N10 WHILE[#1 LT 1]DO1
        N20 WHILE[#1 LT 1]DO2
        N30 #1=1
        N40 END1
        N50 END2
        N60 M30
    """,
    runs=None, alarm="missing-end", number="P294",
)
case(
    "a WHILE without DO is P291",
    control=EVERY, source="MZ 865, P291 paired", evidence="inferred",
    program="""
        O1
        N10 WHILE[#1 LT 3]
        N20 END1
        N30 M30
    """,
    runs="", alarm="while-format", number="P291", at="O1 N10",
)
case(
    "a WHILE without its condition is P291",
    control=EVERY, source="MZ 865, P291 paired", evidence="inferred",
    program="""
        O1
        N10 WHILE DO1
        N20 END1
        N30 M30
    """,
    runs="", alarm="while-format", number="P291", at="O1 N10",
)
case(
    "27 loops inside each other are legal",
    pins="max_loops",
    control=EVERY, source="MZ 867", evidence="secondary",
    program="O1\n" + loops(27, "N90 S1\n") + "N99 M30\n",
    runs=" ".join(f"N{k}" for k in range(1, 28)) + " N90 "
    + " ".join(f"N{k}" for k in range(27, 0, -1)) + " N99",
)
case(
    "a 28th loop inside is P293",
    control=EVERY, source="MZ 867, P293 paired", evidence="inferred",
    program="O1\n" + loops(28, "N90 S1\n") + "N99 M30\n",
    runs=" ".join(f"N{k}" for k in range(1, 28)), alarm="loops-too-deep", number="P293",
    at="O1 N28",
)
case(
    "loops that are open in the caller count with those of the subprogram",
    pins="loops_count_across_calls",
    control=EVERY, source="general knowledge, 27 over the calling chain", evidence="inferred",
    program="O1\n" + loops(27, "N90 M98 P200\n") + "N99 M30\n"
    "O200\nN210 WHILE[#150 LT 1]DO1\n#150=1\nN220 END1\nN230 M99\n",
    runs=" ".join(f"N{k}" for k in range(1, 28)) + " N90", alarm="loops-too-deep",
    number="P293", at="O200 N210",
)
case(
    "the same DO number may be used again after its END",
    control=EVERY, source="general knowledge, DO", evidence="inferred",
    program="""
        O1
        N10 WHILE[#1 LT 1]DO1
        N20 #1=1
        N30 END1
        N40 WHILE[#2 LT 1]DO1
        N50 #2=1
        N60 END1
        N70 M30
    """,
    runs="N10 N20 N30 N10 N40 N50 N60 N40 N70",
)
case(
    "a subprogram inside a loop may use the loop's number",
    control=EVERY, source="general knowledge, DO", evidence="inferred",
    program="""
        O1
        N10 WHILE[#1 LT 2]DO1
        N20 M98 P200
        N30 #1=#1+1
        N40 END1
        N50 M30
        O200
        N205 #2=0
        N210 WHILE[#2 LT 1]DO1
        N220 #2=1
        N230 END1
        N240 M99
    """,
    runs="(N10 N20 N205 N210 N220 N230 N210 N240 N30 N40)*2 N10 N50",
)

# Expressions

for claim, text, value in [
    ("multiplication comes before addition", "2+3*4", 14),
    ("brackets come first", "[2+3]*4", 20),
    ("equal operators work from left to right", "20/5/2", 2),
    ("MOD is worked like multiplication", "1+7 MOD 4", 4),
    ("a minus sign may stand before a bracket", "-[2+3]", -5),
    ("SIN takes degrees", "SIN[30]", 0.5),
    ("COS takes degrees", "COS[60]", 0.5),
    ("TAN takes degrees", "TAN[45]", 1),
    ("ATAN of a quotient gives degrees", "ATAN[1]/[1]", 45),
    ("ASIN gives degrees", "ASIN[0.5]", 30),
    ("ACOS gives degrees", "ACOS[0.5]", 60),
    ("SQRT is the square root", "SQRT[16]", 4),
    ("ABS takes the sign away", "ABS[-3.5]", 3.5),
    ("ROUND goes to the nearest whole number", "ROUND[3.7]", 4),
    ("RND is ROUND", "RND[2.2]", 2),
    ("FIX cuts the fraction off", "FIX[3.7]", 3),
    ("FUP makes a whole one of the fraction", "FUP[3.2]", 4),
    ("LN is the natural logarithm", "LN[1]", 0),
    ("EXP is the power of e", "EXP[0]", 1),
    ("BIN reads decimal digits of a BCD value", "BIN[18]", 12),
    ("BCD writes a value in decimal digits", "BCD[12]", 18),
    ("AND works on the bits", "12 AND 10", 8),
    ("OR works on the bits", "12 OR 10", 14),
    ("XOR works on the bits", "12 XOR 10", 6),
]:
    case(
        f"Mitsubishi expressions: {claim}, {text} is {value}",
        control=EVERY, source="general knowledge, functions and priority", evidence="inferred",
        program=f"""
            O1
            N10 #100={text}
            N20 M30
        """,
        runs="N10 N20", vars={100: value},
    )
case(
    "five brackets inside each other are legal",
    control=EVERY, source="MZ 858", evidence="secondary",
    program="""
        O1
        N10 #100=[[[[[1+1]*2]*2]*2]*2]
        N20 M30
    """,
    runs="N10 N20", vars={100: 32},
)
case(
    "a sixth bracket inside is P280",
    control=EVERY, source="MZ 858, P280 paired", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 #100=[[[[[[1+1]*2]*2]*2]*2]*2]
        N30 M30
    """,
    runs="N10", alarm="brackets-too-deep", number="P280", at="O1 N20",
)
case(
    "six brackets side by side are not six inside each other",
    control=EVERY, source="MZ 858", evidence="inferred",
    program="""
        O1
        N10 #100=[1]+[1]+[1]+[1]+[1]+[1]
        N20 M30
    """,
    runs="N10 N20", vars={100: 6},
)
case(
    "a bracket that is not closed is P281 and nothing is assigned",
    control=EVERY, source="MZ 859, P281 paired", evidence="inferred",
    program="""
        O1
        N10 #100=[1+2
        N20 M30
    """,
    variables={100: 9}, runs="", vars={100: 9}, alarm="bracket-not-closed", number="P281",
    at="O1 N10",
)
case(
    "a bracket that was not opened is P281",
    control=EVERY, source="MZ 859, P281 paired", evidence="inferred",
    program="""
        O1
        N10 #100=1+2]
        N20 M30
    """,
    runs="", alarm="bracket-not-opened", number="P281", at="O1 N10",
)
case(
    "a division by zero is P283",
    control=EVERY, source="MZ 861, P283 paired", evidence="inferred",
    program="""
        O1
        N10 #100=0
        N20 #101=5/#100
        N30 M30
    """,
    runs="N10", vars={101: None}, alarm="division-by-zero", number="P283", at="O1 N20",
)
case(
    "a division by a vacant variable is P283",
    control=EVERY, source="MZ 861, P283 paired; general knowledge", evidence="inferred",
    program="""
        O1
        N10 #101=5/#5
        N20 M30
    """,
    runs="", alarm="division-by-zero", number="P283", at="O1 N10",
)
case(
    "the square root of a negative value is P282",
    control=EVERY, source="MZ 860, P282 paired", evidence="inferred",
    program="""
        O1
        N10 #100=SQRT[1-5]
        N20 M30
    """,
    runs="", alarm="square-root-of-negative", number="P282", at="O1 N10",
)
case(
    "an expression that breaks off is P282",
    control=EVERY, source="MZ 860, P282 paired", evidence="inferred",
    program="""
        O1
        N10 #100=1+
        N20 M30
    """,
    runs="", alarm="expression-format", number="P282", at="O1 N10",
)
case(
    "a result that is too large for a number is P285",
    control=EVERY, source="MZ 863; general knowledge P285", evidence="inferred",
    program="""
        O1
        N10 #100=EXP[5000]
        N20 M30
    """,
    runs="", alarm="overflow", number="P285", at="O1 N10",
)
case(
    "an assignment without its equals sign is P242",
    control=EVERY, source="MZ 847, P242 paired", evidence="inferred",
    program="""
        O1
        N10 #100 5
        N20 M30
    """,
    runs="", alarm="missing-equals", number="P242", at="O1 N10",
)
case(
    "NC words behind a macro statement are P272",
    control=EVERY, source="MZ 854, P272 paired", evidence="inferred",
    program="""
        O1
        N10 #100=5 M8
        N20 M30
    """,
    runs="", m=[], vars={100: None}, alarm="nc-and-macro-in-block", number="P272", at="O1 N10",
)
case(
    "NC words in front of a macro statement are P272",
    control=EVERY, source="MZ 854, P272 paired", evidence="inferred",
    program="""
        O1
        N10 M8 #100=5
        N20 M30
    """,
    runs="", m=[], vars={100: None}, alarm="nc-and-macro-in-block", number="P272", at="O1 N10",
)
case(
    "a sequence number in front of a macro statement is no NC word",
    control=EVERY, source="MZ 854", evidence="inferred",
    program="""
        O1
        N10 #100=5
        /2 N20 #101=6
        N30 M30
    """,
    skip=(2,), runs="N10 N30", vars={100: 5, 101: None},
)

# Vacant

case(
    "a copy of a vacant variable is vacant",
    control=EVERY, source="general knowledge, vacant", evidence="inferred",
    program="""
        O1
        N10 #100=#5
        N20 M30
    """,
    variables={100: 4}, runs="N10 N20", vars={100: None},
)
case(
    "a vacant variable counts as zero in an expression",
    control=EVERY, source="general knowledge, vacant", evidence="inferred",
    program="""
        O1
        N10 #100=#5+2
        N20 #101=#5*2
        N30 M30
    """,
    runs="N10 N20 N30", vars={100: 2, 101: 0},
)
for text, jumps in [
    ("#5 EQ #0", True), ("#5 EQ 0", False), ("#5 NE #0", False), ("#5 NE 0", True),
    ("#5 GE 0", True), ("#5 GT 0", False), ("#5 LE 0", True), ("#5 LT 0", False),
]:
    case(
        f"with #5 vacant, {text} is {'true' if jumps else 'false'} on a Mitsubishi",
        control=EVERY, source="general knowledge, vacant in comparisons", evidence="inferred",
        program=f"""
            O1
            N10 IF[{text}]GOTO30
            N20 S2
            N30 M30
        """,
        runs="N10 N30" if jumps else "N10 N20 N30",
    )
case(
    "with #5 zero, #5 EQ #0 is false",
    control=EVERY, source="general knowledge, vacant in comparisons", evidence="inferred",
    program="""
        O1
        N10 #5=0
        N20 IF[#5 EQ #0]GOTO40
        N30 S3
        N40 M30
    """,
    runs="N10 N20 N30 N40",
)
case(
    "a word whose variable is vacant is not there: T#5 changes no tool",
    control=EVERY, source="general knowledge, vacant word ignored", evidence="inferred",
    program="""
        O1
        N10 T#5
        N20 T#6
        N30 M30
    """,
    variables={6: 3}, runs="N10 N20 N30", t=[3],
)
case(
    "a move whose only word is vacant makes no modal call",
    control=EVERY, source="general knowledge, vacant word ignored", evidence="inferred",
    program="""
        O1
        N10 G66 P200
        N20 G0 X#5
        N30 G67
        N40 M30
        O200
        N210 M99
    """,
    runs="N10 N20 N30 N40", calls="",
)

# Variables

case(
    "common variables are shared by all levels",
    control=EVERY, source="general knowledge, variables", evidence="inferred",
    program="""
        O1
        N10 #100=1
        N20 G65 P200
        N30 M30
        O200
        N210 #100=#100+1
        N220 #500=#100
        N230 M99
    """,
    runs="N10 N20 N210 N220 N230 N30", vars={100: 2, 500: 2},
)
case(
    "the number of a variable may be an expression in brackets",
    control=EVERY, source="general knowledge, variables", evidence="inferred",
    program="""
        O1
        N10 #1=100
        N20 #[#1+1]=7
        N30 #102=#[#1+1]
        N40 M30
    """,
    runs="N10 N20 N30 N40", vars={101: 7, 102: 7},
)
case(
    "leading zeros do not change a variable",
    control=EVERY, source="general knowledge, variables", evidence="inferred",
    program="""
        O1
        N10 #0100=7
        N20 M30
    """,
    runs="N10 N20", vars={100: 7},
)
case(
    "there is no variable #34 to write",
    control=EVERY, source="MZ 846, P241 paired", evidence="inferred",
    program="""
        O1
        N10 #33=1
        N20 #34=1
        N30 M30
    """,
    runs="N10", alarm="illegal-variable", number="P241", at="O1 N20",
)
case(
    "there is no variable #99 to read",
    control=EVERY, source="MZ 846, P241 paired", evidence="inferred",
    program="""
        O1
        N10 #100=#99
        N20 M30
    """,
    runs="", alarm="illegal-variable", number="P241", at="O1 N10",
)
case(
    "an indirect variable whose number does not exist is P241",
    control=EVERY, source="MZ 846, P241 paired", evidence="inferred",
    program="""
        O1
        N10 #1=40
        N20 #100=#[#1+1]
        N30 M30
    """,
    runs="N10", alarm="illegal-variable", number="P241", at="O1 N20",
)
case(
    "#0 takes no value",
    control=EVERY, source="general knowledge P243", evidence="inferred",
    program="""
        O1
        N10 #0=1
        N20 M30
    """,
    runs="", alarm="vacant-assigned", number="P243", at="O1 N10",
)
case(
    "#3000 stops the program with P277 and the text",
    control=[MELDAS, M800], source="MZ 979; general knowledge P277", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 #3000=12(TOOL WORN)
        N30 M30
    """,
    runs="N10 N20", alarm="user-alarm", number="P277", at="O1 N20",
)
case(
    "#3000 in a macro stops the program there",
    control=EVERY, source="MZ 979; general knowledge P277", evidence="inferred",
    program="""
        O1
        N10 G65 P200
        N20 M30
        O200
        N210 IF[#1 NE #0]GOTO230
        N220 #3000=1(A MISSING)
        N230 M99
    """,
    runs="N10 N210 N220", alarm="user-alarm", number="P277", at="O200 N220",
)
case(
    "#3006 shows its text and the run goes on",
    control=EVERY, source="general knowledge #3006", evidence="inferred",
    program="""
        O1
        N10 #3006=1(CHECK TOOL)
        N20 M30
    """,
    runs="N10 N20", messages=["CHECK TOOL"],
)
case(
    "a comment behind another assignment is no message",
    control=EVERY, source="general knowledge, comments", evidence="inferred",
    program="""
        O1
        N10 #100=1(CHECK TOOL)
        N20 M30
    """,
    runs="N10 N20", messages=[], vars={100: 1},
)
case(
    "SETVN gives two variables their names",
    pins="variable_names",
    control=EVERY, source="MZ 866; general knowledge, SETVN", evidence="inferred",
    program="""
        O1
        N10 SETVN 510[TOOLNO,WORKNO]
        N20 #510=4
        N30 M30
    """,
    runs="N10 N20 N30", vars={510: 4, 511: None},
)
for text in ("[TOOLNO]", "510[TOOLNO", "510 TOOLNO"):
    case(
        f"SETVN of a wrong form is P292: SETVN {text}",
        control=EVERY, source="MZ 866, paired with P292", evidence="secondary",
        program=f"O1\nN10 S1\nN20 SETVN {text}\nN30 M30\n",
        runs="N10", alarm="setvn-format", number="P292", at="O1 N20",
    )
for text in ("510[TOOL*]", "510[TOOLNO,2B]"):
    case(
        f"SETVN of an illegal name is P300: SETVN {text}",
        control=EVERY, source="MZ 870, paired with P300", evidence="secondary",
        program=f"O1\nN10 S1\nN20 SETVN {text}\nN30 M30\n",
        runs="N10", alarm="illegal-variable-name", number="P300", at="O1 N20",
    )
