"""GSK: P and L of G65, words that may not share its block, nesting."""

from conformance import case

case(
    "G65 P[T123] L2 runs the program named T123 twice with its argument (TA-032)",
    pins="roles:G65=macro-call",
    control="gsk-988ta",
    source="TA27",
    evidence="maker's manual",
    files={
        "O1.CNC": """
            O1
            G65 P[T123] L2 A4
            M30
        """,
        "T123.CNC": """
            G0 X#1
            M99
        """,
    },
    main="O1",
    arguments={1: 4},
    moves_x=[4, 4],
)

case(
    "G65 P[#100] with a value of five digits alarms (TA-033)",
    control="gsk-988ta",
    source="TA27",
    evidence="maker's manual",
    program="""
        O1
        #100=21234
        G65 P[#100] L2
        M30
    """,
    moves_x=[],
    alarm="illegal-macro-number",
    number="291",
    at="O1",
)

case(
    "macro calls count among the twelve levels of the 988TA (TA-042)",
    pins="nesting_counts_macros max_macro_nesting",
    control="gsk-988ta",
    source="source 000, M98",
    evidence="source document",
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
        M98 P7
        M99
        O7
        G0 X7
        M98 P8
        M99
        O8
        G0 X8
        M98 P9
        M99
        O9
        G0 X9
        M98 P10
        M99
        O10
        G0 X10
        G65 P11
        M99
        O11
        G0 X11
        G65 P12
        M99
        O12
        G0 X12
        G65 P13
        M99
        O13
        G0 X13
        G65 P14
        M99
        O14
        G0 X14
        M99
    """,
    moves_x=[2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13],
    alarm="nesting-too-deep",
    number="082",
    at="O13",
)

TA, T, TDI, MDI = "gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi"
FAMILY_988 = [TA, T]
FAMILY_980 = [TDI, MDI]
FAMILIES = [TA, T, TDI, MDI]
MANUAL = "maker's manual"
SECONDARY = "secondary"
INFERRED = "inferred"


def both(number_988, number_980):
    """Return one alarm number for the 988s, and one for the 980s."""
    return {TA: number_988, T: number_988, TDI: number_980, MDI: number_980}


def macro_call(call, macro="N30 M99", name="O2"):
    """Return a main program O1 of one macro call, and the macro."""
    return f"O1\nN10 {call}\nN20 M30\n{name}\n{macro}\n"


def chain(calls):
    """Return programs: O1 calls O2, O2 calls O3 and so on; calls[k] is the call in O<k+1>."""
    programs = [
        f"O{level}\nN{level}0 {call.format(level + 1)}\nN{level}1 {'M30' if level == 1 else 'M99'}\n"
        for level, call in enumerate(calls, 1)
    ]
    last = len(calls) + 1
    return "".join(programs) + f"O{last}\nN{last}0 M99\n"


def chain_down(levels):
    """Return the blocks of a chain on the way down: the calls of O1 to O<levels>."""
    return " ".join(f"N{level}0" for level in range(1, levels + 1))


def chain_through(levels):
    """Return all the blocks of a chain of `levels` calls."""
    up = " ".join(f"N{level}1" for level in range(levels, 0, -1))
    return f"{chain_down(levels + 1)} {up}"


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

# --- G65: words that may not share its block
# -------------------------------------------------------------

case(
    "GSK 988: G0 X1 and G65 may not share a block",
    pins="words_before_macro_call", control=FAMILY_988, source="TA27, note 3; Talm 212",
    evidence=SECONDARY,
    program=macro_call("G0 X1 G65 P2"),
    runs="", alarm="macro-call-not-first", number="212", at="O1 N10",
)
case(
    "GSK 988: M3 and G65 may not share a block",
    pins="words_before_macro_call", control=FAMILY_988, source="TA27, note 3; Talm 212",
    evidence=SECONDARY,
    program=macro_call("M3 G65 P2"),
    runs="", alarm="macro-call-not-first", number="212", at="O1 N10",
)
case(
    "GSK 988: G1 and G65 may not share a block",
    pins="words_before_macro_call", control=FAMILY_988, source="TA27, note 3; Talm 212",
    evidence=SECONDARY,
    program=macro_call("G1 G65 P2"),
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
    pins="refuses:sequence-number-not-first late_sequence_numbers",
    control=TA, source="TA27, note 6", evidence=MANUAL,
    program="O1\nN10 G0 X1\nG65 P2 N20\nN30 M30\nO2\nN40 M99\n",
    runs="N10", alarm="sequence-number-not-first", at="O1 N20",
)
case(
    "GSK 980: G65 must be the first word of its block",
    pins="words_before_macro_call", control=FAMILY_980, source="MDia 114", evidence=MANUAL,
    program=macro_call("X1 G65 P2"),
    runs="", alarm="macro-call-not-first", number="0114", at="O1 N10",
)
case(
    "GSK 980: G66 must be the first word of its block",
    pins="words_before_macro_call", control=FAMILY_980, source="MDia 114", evidence=MANUAL,
    program=macro_call("X1 G66 P2"),
    runs="", alarm="macro-call-not-first", number="0114", at="O1 N10",
)
case(
    "GSK 980MDi: M00 may not share a block with G65",
    pins="m_codes_not_with_macro_call", control=MDI, source="MDib 116", evidence=MANUAL,
    program=macro_call("G65 P2 A1 M00"),
    runs="", alarm="m-code-with-macro-call", number="0116", at="O1 N10",
)
case(
    "GSK 980MDi: M01 may not share a block with G65",
    pins="m_codes_not_with_macro_call", control=MDI, source="MDib 116", evidence=MANUAL,
    program=macro_call("G65 P2 A1 M01"),
    runs="", alarm="m-code-with-macro-call", number="0116", at="O1 N10",
)
case(
    "GSK 980MDi: M02 may not share a block with G65",
    pins="m_codes_not_with_macro_call", control=MDI, source="MDib 116", evidence=MANUAL,
    program=macro_call("G65 P2 A1 M02"),
    runs="", alarm="m-code-with-macro-call", number="0116", at="O1 N10",
)
case(
    "GSK 980MDi: M30 may not share a block with G65",
    pins="m_codes_not_with_macro_call", control=MDI, source="MDib 116", evidence=MANUAL,
    program=macro_call("G65 P2 A1 M30"),
    runs="", alarm="m-code-with-macro-call", number="0116", at="O1 N10",
)
case(
    "GSK 980MDi: M98 may not share a block with G65",
    pins="m_codes_not_with_macro_call", control=MDI, source="MDib 116", evidence=MANUAL,
    program=macro_call("G65 P2 A1 M98"),
    runs="", alarm="m-code-with-macro-call", number="0116", at="O1 N10",
)
case(
    "GSK 980MDi: M99 may not share a block with G65",
    pins="m_codes_not_with_macro_call", control=MDI, source="MDib 116", evidence=MANUAL,
    program=macro_call("G65 P2 A1 M99"),
    runs="", alarm="m-code-with-macro-call", number="0116", at="O1 N10",
)
case(
    "GSK 980MDi: G43 may not share a block with G65",
    pins="codes_not_with_macro_call", control=MDI, source="MDib 115", evidence=MANUAL,
    program=macro_call("G65 P2 A1 G43"),
    runs="", alarm="code-with-macro-call", number="0115", at="O1 N10",
)
case(
    "GSK 980MDi: G44 may not share a block with G65",
    pins="codes_not_with_macro_call", control=MDI, source="MDib 115", evidence=MANUAL,
    program=macro_call("G65 P2 A1 G44"),
    runs="", alarm="code-with-macro-call", number="0115", at="O1 N10",
)
case(
    "GSK 980MDi: G49 may not share a block with G65",
    pins="codes_not_with_macro_call", control=MDI, source="MDib 115", evidence=MANUAL,
    program=macro_call("G65 P2 A1 G49"),
    runs="", alarm="code-with-macro-call", number="0115", at="O1 N10",
)

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
    "GSK 988: macros one after the other do not add up",
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
