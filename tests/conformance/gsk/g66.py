"""GSK: G66 and G67."""

from conformance import case

case(
    "G67 without G66 alarms on the 988TA (TA-036)",
    pins="cancel_alone",
    control="gsk-988ta",
    source="Talm 218 of the 988T",
    evidence="secondary",
    program="""
        O1
        G0 X1
        G67
        M30
    """,
    moves_x=[1],
    alarm="modal-call-missing",
    number="218",
    at="O1",
)

case(
    "G66 with L2 calls twice after a move on the 980TDi (TD-011)",
    control="gsk-980tdi",
    source="TDi28",
    evidence="maker's manual",
    program="""
        O1
        G66 P100 L2 A2
        G98 G01 X80 F100
        G67
        G01 X20
        M30
        O100
        G0 X#1
        M99
    """,
    moves_x=[80, 2, 2, 20],
)

case(
    "M98 under G66 alarms (TD-021)",
    control="gsk-980tdi",
    source="MDia 113 of the 980MDi",
    evidence="secondary",
    program="""
        O1
        G66 P2
        M98 P2
        M30
        O2
        M99
    """,
    moves_x=[],
    alarm="call-in-modal-call",
    number="0113",
    at="O1",
)

case(
    "G65 ends the modal call on the 980TDi (TD-029)",
    control="gsk-980tdi",
    source="TDi28",
    evidence="maker's manual",
    program="""
        O1
        G66 P100
        G0 X1
        G65 P200
        G0 X2
        M30
        O100
        G0 X10
        M99
        O200
        G0 X20
        M99
    """,
    moves_x=[1, 10, 20, 2],
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


MACRO = "O2\nN90 M99\n"

case(
    "GSK: the block of G66 does not call",
    control=FAMILIES, source="TA27, G66 note 3; TDi28, G66 (1)", evidence=MANUAL,
    program="O1\nN10 G66 P2\nN20 G67\nN30 M30\n" + MACRO,
    runs="N10 N20 N30", calls="",
)
case(
    "GSK: the macro of G66 is called after each block that moves",
    control=FAMILIES, source="TA27, G66 example; TDi28, G66 (2)", evidence=MANUAL,
    program="O1\nN10 G66 P2\nN20 G0 X50\nN30 G0 Z20\nN40 G67\nN50 G0 X30\nN60 M30\n" + MACRO,
    runs="N10 N20 N90 N30 N90 N40 N50 N60", calls="G66:O2 G66:O2",
)
case(
    "GSK: the macro of G66 is called L times after each move",
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
case(
    "GSK 988: a block of M3 does not call the macro of G66",
    control=FAMILY_988, source="TA27, G66 example and note 3",
    evidence=MANUAL,
    program="O1\nN10 G66 P2\nN20 M3\nN30 G67\nN40 M30\n" + MACRO,
    runs="N10 N20 N30 N40", calls="",
)
case(
    "GSK 988: a block of S500 does not call the macro of G66",
    control=FAMILY_988, source="TA27, G66 example and note 3",
    evidence=MANUAL,
    program="O1\nN10 G66 P2\nN20 S500\nN30 G67\nN40 M30\n" + MACRO,
    runs="N10 N20 N30 N40", calls="",
)
case(
    "GSK 988: a block of M5 does not call the macro of G66",
    control=FAMILY_988, source="TA27, G66 example and note 3",
    evidence=MANUAL,
    program="O1\nN10 G66 P2\nN20 M5\nN30 G67\nN40 M30\n" + MACRO,
    runs="N10 N20 N30 N40", calls="",
)
case(
    "GSK 988: a block of G0 U0 W0 does not call the macro of G66",
    pins="modal_trigger", control=FAMILY_988, source="TA27, G66 example and note 3",
    evidence=MANUAL,
    program="O1\nN10 G66 P2\nN20 G0 U0 W0\nN30 G67\nN40 M30\n" + MACRO,
    runs="N10 N20 N30 N40", calls="",
)
case(
    "GSK 988: a block of #100=1 does not call the macro of G66",
    control=FAMILY_988, source="TA27, G66 example and note 3",
    evidence=MANUAL,
    program="O1\nN10 G66 P2\nN20 #100=1\nN30 G67\nN40 M30\n" + MACRO,
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
    "GSK: after G67 a move calls nothing",
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
case(
    "GSK 988: M98 is refused while G66 is active",
    pins="calls_in_modal", control=FAMILY_988, source="TA27, G66 note 1; Talm 204",
    evidence=SECONDARY,
    program="O1\nN10 G66 P2\nN20 M98 P2\nN30 G67\nN40 M30\n" + MACRO,
    runs="N10", alarm="call-in-modal-call", number="204", at="O1 N20",
)
case(
    "GSK 988: G65 is refused while G66 is active",
    pins="calls_in_modal", control=FAMILY_988, source="TA27, G66 note 1; Talm 204",
    evidence=SECONDARY,
    program="O1\nN10 G66 P2\nN20 G65 P2\nN30 G67\nN40 M30\n" + MACRO,
    runs="N10", alarm="call-in-modal-call", number="204", at="O1 N20",
)
case(
    "GSK 988: G66 is refused while G66 is active",
    pins="calls_in_modal", control=FAMILY_988, source="TA27, G66 note 1; Talm 204",
    evidence=SECONDARY,
    program="O1\nN10 G66 P2\nN20 G66 P2\nN30 G67\nN40 M30\n" + MACRO,
    runs="N10", alarm="call-in-modal-call", number="204", at="O1 N20",
)
case(
    "GSK 988: M98 is refused while G66 is active after its moves too",
    control=FAMILY_988, source="TA27, G66 note 1; Talm 204", evidence=SECONDARY,
    program="O1\nN10 G66 P2\nN20 G0 X50\nN30 M98 P2\nN40 M30\n" + MACRO,
    runs="N10 N20 N90", alarm="call-in-modal-call", number="204", at="O1 N30",
)
case(
    "GSK 988: M98 is legal again after G67",
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
    "GSK 980: M98 is legal again after G67",
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
case(
    "GSK 980: G00 may not share a block with G66",
    control=FAMILY_980, source="MDia 044", evidence=MANUAL,
    program=macro_call("G66 P2 A1 G00"),
    runs="", alarm="code-with-modal-call", number="0044", at="O1 N10",
)
case(
    "GSK 980: G01 may not share a block with G66",
    control=FAMILY_980, source="MDia 044", evidence=MANUAL,
    program=macro_call("G66 P2 A1 G01"),
    runs="", alarm="code-with-modal-call", number="0044", at="O1 N10",
)
case(
    "GSK 980: G04 may not share a block with G66",
    control=FAMILY_980, source="MDia 044", evidence=MANUAL,
    program=macro_call("G66 P2 A1 G04"),
    runs="", alarm="code-with-modal-call", number="0044", at="O1 N10",
)
case(
    "GSK 980: G28 may not share a block with G66",
    control=FAMILY_980, source="MDia 044", evidence=MANUAL,
    program=macro_call("G66 P2 A1 G28"),
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
