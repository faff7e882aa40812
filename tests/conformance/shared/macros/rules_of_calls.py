"""Macro calls: what a control has and does not have, rule by rule."""

from conformance import case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI = GSK_980 = ["gsk-980tdi", "gsk-980mdi"]
GSK = GSK_988 + GSK_980
MELDAS, M700, M800 = MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, F0D, F0F, F30 = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
FANUC_PS = FANUC[1:]

case(
    "M30 is an argument of a macro call",
    pins="m_codes_not_with_macro_call",
    control=[*GSK_988, *MITSUBISHI, *FANUC, "haas-ngc"],
    source="source 002, argument I; TA27; general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P2 M30
        N20 T1
        N25 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20 N25", arguments={13: 30},
)
case(
    "G66.1 does not exist",
    pins="roles:G66.1=modal-call-every-block",
    control=[*GSK, F16], source="general knowledge, G66.1", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G66.1 P2 A1
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="g-code-not-available",
    number={**dict.fromkeys(GSK_988, "009"), **dict.fromkeys(GSK_980, "0002"), F16: "010"},
    at="O1 N20",
)
case(
    "of an argument given twice the last counts",
    pins="repeated_argument",
    control=[*GSK, *MITSUBISHI, *FANUC, "haas-ngc"], source="TA27; PB304; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 G65 P2 A1. A2.
        N20 M30
        O2
        N30 #100=#1
        N40 M99
    """,
    runs="N10 N30 N40 N20", vars={100: 2},
)
case(
    "two modal calls stack: after a move the last runs, and its own move calls the first",
    pins="second_modal_call",
    control=[*MITSUBISHI, *FANUC], source="NCT; M7V; general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G66 P3
        N30 G0 X5
        N40 M30
        O2
        N50 M99
        O3
        N60 G0 X6
        N70 M99
    """,
    runs="N10 N20 N30 N60 N50 N70 N40",
)
case(
    "two modal calls stack on the 980: one G67 leaves the first",
    pins="second_modal_call",
    control=GSK_980, source="general knowledge, nested G66", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G66 P3
        N30 G67
        N40 G0 X5
        N50 M30
        O2
        N60 M99
        O3
        N70 M99
    """,
    runs="N10 N20 N30 N40 N60 N50",
)
case(
    "a macro call runs while a modal call is active",
    control=[*MITSUBISHI, *FANUC], source="general knowledge, G65 inside G66",
    evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G65 P3
        N30 G0 X5
        N40 M30
        O2
        N50 M99
        O3
        N60 M99
    """,
    runs="N10 N20 N60 N30 N50 N40",
)
case(
    "M98 runs while a modal call is active",
    control=[*MITSUBISHI, *FANUC], source="general knowledge, M98 inside G66",
    evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 M98 P3
        N30 G0 X5
        N40 M30
        O2
        N50 M99
        O3
        N60 M99
    """,
    runs="N10 N20 N60 N30 N50 N40",
)
case(
    "a modal macro gets its arguments again at each call",
    pins="modal_locals",
    control=[*GSK, *MITSUBISHI], source="TA27, G66; TDi28, G66; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 G66 P2 A1
        N20 G0 X5
        N30 G0 X6
        N40 G67
        N50 M30
        O2
        N60 #100=#100+#1
        N70 #1=50
        N80 M99
    """,
    variables={100: 0}, vars={100: 2},
)
case(
    "what a modal macro leaves in #1 is there at its next call",
    pins="modal_locals",
    control=FANUC, source="K-H, G66", evidence="inferred",
    program="""
        O1
        N10 G66 P2 A1.
        N20 G0 X5.
        N30 G0 X6.
        N40 G67
        N50 M30
        O2
        N60 #100=#100+#1
        N70 #1=50
        N80 M99
    """,
    variables={100: 0}, vars={100: 51},
)
case(
    "a block that writes an axis and does not move it calls on the 980",
    pins="modal_trigger",
    control=GSK_980, source="TDi28, G66 (3)", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G0 X0
        N40 M30
        O2
        N50 M99
    """,
    setup={"start": {"X": 0, "Y": 0, "Z": 0}}, runs="N10 N20 N50 N40",
)
case(
    "a block that writes an axis and does not move it calls nothing",
    pins="modal_trigger",
    control=[*GSK_988, *MITSUBISHI, *FANUC], source="TA27, G66; M7V; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G0 X0
        N40 M30
        O2
        N50 M99
    """,
    setup={"start": {"X": 0, "Y": 0, "Z": 0}}, runs="N10 N20 N40",
)
case(
    "G67 without a modal call to cancel is nothing",
    pins="cancel_alone",
    control=[*GSK_980, F16], source="general knowledge, G67", evidence="inferred",
    program="""
        O1
        N10 G67
        N20 M30
    """,
    runs="N10 N20",
)
case(
    "G67 without a modal call to cancel is refused",
    pins="cancel_alone",
    control=[*GSK_988, *MITSUBISHI, *FANUC_PS], source="Talm 218; MZ 857; ALM PS1100",
    evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G67
        N30 M30
    """,
    runs="N10", alarm="modal-call-missing",
    number={**dict.fromkeys(GSK_988, "218"), **dict.fromkeys(MITSUBISHI, "P276"), **dict.fromkeys(FANUC_PS, "PS1100")},
    at="O1 N20",
)
case(
    "X1 and X2 name no arguments of their own",
    control=[*GSK_980, *MITSUBISHI, *FANUC], source="source 002, argument I; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 G65 P2 X1.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={24: 1, 27: None},
)
case(
    "P of a macro call has four digits",
    control=GSK, source="TA27; TDi28", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G65 P10002
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="illegal-macro-number",
    number={**dict.fromkeys(GSK_988, "291"), **dict.fromkeys(GSK_980, "0119")}, at="O1 N20",
)
case(
    "P of a macro call has eight digits",
    pins="max_macro_digits",
    control=[*MITSUBISHI, F30, F0F], source="IMD, P; general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P12345678
        N30 M30
        O12345678
        N40 M99
    """,
    runs="N10 N40 N30",
)
case(
    "I, J and K count per letter on the 980",
    control=GSK_980, source="TDi28", evidence="inferred",
    program="""
        O1
        N10 G65 P2 I1 J2 I3 K4
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={4: 1, 5: 2, 7: 3, 6: 4},
)
case(
    "I, J and K count in sets as they are written on a Mitsubishi",
    control=MITSUBISHI, source="general knowledge, argument II", evidence="inferred",
    program="""
        O1
        N10 G65 P2 K1. J2. I3.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={6: 1, 8: 2, 10: 3},
)
case(
    "four macros may be open, and a fifth is too many",
    control=[*GSK_980, MELDAS], source="MDia 096; SM 6", evidence="inferred",
    program="""
        O1
        N10 G65 P2
        N15 M30
        O2
        N20 G65 P3
        M99
        O3
        N30 G65 P4
        M99
        O4
        N40 G65 P5
        M99
        O5
        N50 G65 P6
        M99
        O6
        N60 T1
        M99
    """,
    runs="N10 N20 N30 N40", alarm="macro-nesting-too-deep",
    number={**dict.fromkeys(GSK_980, "0096"), MELDAS: "P273"}, at="O5 N50",
)
case(
    "macros do not count as subprograms on the 980",
    pins="nesting_counts_macros",
    control=GSK_980, source="general knowledge, nesting", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N15 M30
        O2
        N20 M98 P3
        M99
        O3
        N30 M98 P4
        M99
        O4
        N40 M98 P5
        M99
        O5
        N50 G65 P6
        M99
        O6
        N60 M99
    """,
    runs="N10 N20 N30 N40 N50 N60 N15",
)
case(
    "H99 raises alarm 5900 and the number in P",
    pins="h99_offset",
    control=MDI, source="TDi28, H99", evidence="inferred",
    program="""
        O1
        N10 G65 H99 P5
        N20 M30
    """,
    runs="N10", alarm="user-alarm", number="5905", at="O1 N10",
)
case(
    "G17 may not share a block with G66",
    pins="codes_not_with_modal_call",
    control=GSK_988, source="TA27, note 6; Talm 212", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G66 P2 G17
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="code-with-modal-call", number="212", at="O1 N20",
)
case(
    "G97 is no argument of G66",
    pins="codes_not_with_modal_call",
    control=GSK_980, source="MDia 044: groups 00 and 01 only; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G66 P2 G97
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="illegal-argument", at="O1 N20",
)
case(
    "G04 is no argument of G66",
    pins="codes_not_with_modal_call",
    control=[*MITSUBISHI, *FANUC], source="ALM PS0129; general knowledge", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G66 P2 G4
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="illegal-argument",
    number={**dict.fromkeys(MITSUBISHI, "P33"), F16: "129", **dict.fromkeys(FANUC_PS, "PS0129")},
    at="O1 N20", word="G4",
)
case(
    "G43 is no argument of G65",
    pins="codes_not_with_macro_call",
    control=[*MITSUBISHI, *FANUC], source="ALM PS0129; general knowledge", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G65 P2 G43
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="illegal-argument",
    number={**dict.fromkeys(MITSUBISHI, "P33"), F16: "129", **dict.fromkeys(FANUC_PS, "PS0129")},
    at="O1 N20", word="G43",
)
case(
    "X1= gives the 988T an argument of its own",
    control=T, source="TA27, argument I; general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P2 X1=27.5 X2=30.5
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={27: 27.5, 30: 30.5, 24: None},
)
case(
    "X1= is no argument",
    pins="numbered_axis_arguments",
    control=[*GSK_980, *MITSUBISHI, *FANUC, "haas-ngc"], source="general knowledge, arguments",
    evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G65 P2 X1=27.5
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="illegal-character",
    number={**dict.fromkeys(GSK_980, None), **dict.fromkeys(MITSUBISHI, "P32"), F16: "009", **dict.fromkeys(FANUC_PS, "PS0009"), "haas-ngc": None},
    at="O1 N20",
)
case(
    "P of a macro call has no nine digits on a Mitsubishi",
    control=MITSUBISHI, source="SK P35; general knowledge, 8 digits", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G65 P123456789
        N30 M30
    """,
    runs="N10", alarm="illegal-macro-number", number="P35", at="O1 N20",
)
case(
    "P of a macro call has no nine digits",
    pins="max_macro_digits",
    control=FANUC, source="general knowledge, 8 digits", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G65 P123456789
        N30 M30
    """,
    runs="N10", alarm="illegal-macro-number", at="O1 N20",
)
case(
    "P of a macro call of eight digits names a number that these controls do not have",
    control=[F16, F0D], source="general knowledge, 4 digits", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G65 P12345678
        N30 M30
    """,
    runs="N10", alarm="program-not-found", number={F16: "078", F0D: "PS0076"}, at="O1 N20",
)
