"""Motion, rule by rule: units, machine coordinates, reference points."""

from conformance import case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI, TE = "gsk-980tdi", "gsk-980mdi", "gsk-928te"
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, F0D, F0F, F30 = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
FANUC_PS = FANUC[1:]
HNC = "hnc-21m"
MILL = {"machine": "mill"}
LATHE = {"machine": "lathe-a"}
HOMED = {"reference": {1: {"X": 0, "Y": 0, "Z": 0}}}
POLICY = {"source": "policy", "evidence": "inferred"}


def numbers(controls, fanuc=None, mitsubishi=None, gsk_988=None, mdi=None):
    """Return the alarm number of each control, which is that of its maker; `066/325` where the
    number of the 16i is not that of the later series."""
    old, later = (fanuc.split("/") * 2)[:2] if fanuc else (None, None)
    by_control = {
        **dict.fromkeys(GSK_988, gsk_988), **dict.fromkeys(MITSUBISHI, mitsubishi),
        F16: old, **dict.fromkeys(FANUC_PS, later and f"PS0{later}"), MDI: mdi,
    }
    return {control: by_control.get(control) for control in controls}


case(
    "G20 after a move changes the unit from there on",
    pins="unit_change",
    control=[*MITSUBISHI, *FANUC, "haas-ngc"], source="30i p.226; general knowledge", evidence="inferred",
    setup=MILL,
    program="""
        O1
        N10 G0 X10.
        N20 G20
        N30 G0 X1.
        N40 M30
    """,
    moves_x=[10, 25.4],
)
case(
    "G20 after a move changes the unit of a lathe from there on",
    pins="unit_change",
    control=TDI, **POLICY, setup=LATHE,
    program="""
        O1
        N10 G0 X10.
        N20 G20
        N30 G0 X1.
        N40 M30
    """,
    moves_x=[10, 25.4],
)
case(
    "G20 after a move alarms on the HNC",
    pins="unit_change",
    control=HNC, source="source 003, G20 G21 G22", evidence="source document",
    program="""
        O1
        N10 G0 X10.
        N20 G20
        N30 M30
    """,
    runs="N10", alarm="unit-change-misplaced", at="O1 N20", word="G20",
)

_late = [*GSK_988, MDI]

case(
    "G20 after a move alarms",
    pins="unit_change",
    control=_late, source="Talm 042; MDib 0038", evidence="secondary",
    program="""
        O1
        N10 G0 X10.
        N20 G20
        N30 M30
    """,
    runs="N10", alarm="unit-change-misplaced", number=numbers(_late, gsk_988="042", mdi="0038"),
    at="O1 N20", word="G20",
)
case(
    "G53 is rapid whatever the mode",
    pins="machine_move",
    control=[*GSK_988, TDI, MDI, *FANUC, HNC, "haas-ngc"], source="source 003, G53; TDi 20", evidence="inferred",
    setup=HOMED,
    program="""
        O1
        N10 G1 Z-5. F100
        N20 G53 Z-10.
        N30 M30
    """,
    moves="F Z-5\nR Z-10",
)
case(
    "G53 follows the mode on a Mitsubishi",
    pins="machine_move",
    control=MITSUBISHI, source="M7 p.520 (4)-(8)", evidence="maker's manual", setup=HOMED,
    program="""
        O1
        N10 G1 Z-5. F100
        N20 G53 Z-10.
        N30 M30
    """,
    moves="F Z-5\nF Z-10",
)
case(
    "G53 goes to machine coordinates though the setup names no reference point",
    pins="refuses:machine-zero-not-known",
    control=[TDI, *MITSUBISHI, *FANUC, HNC, "haas-ngc"], **POLICY,
    program="""
        O1
        N10 G0 G53 Z-10.
        N20 M30
    """,
    moves="R Z-10",
)

_home = [*GSK_988, MDI]

case(
    "G53 alarms where the setup names no reference point",
    pins="refuses:machine-zero-not-known",
    control=_home, source="Talm 043; MDib 0166", evidence="secondary",
    program="""
        O1
        N10 G0 Z1.
        N20 G53 Z0
        N30 M30
    """,
    runs="N10", alarm="machine-zero-not-known", number=numbers(_home, gsk_988="043", mdi="0166"),
    at="O1 N20", word="G53",
)
case(
    "G30 alarms where the setup names no reference point",
    control=_home, source="Talm 047; MDib 0069", evidence="secondary",
    program="""
        O1
        N10 G0 Z1.
        N20 G30 Z0
        N30 M30
    """,
    runs="N10", alarm="reference-not-known", number=numbers(_home, gsk_988="047", mdi="0069"),
    at="O1 N20", word="G30",
)
case(
    "G53 may stand in a canned cycle",
    control=[*MITSUBISHI, *FANUC, HNC], **POLICY, setup=MILL,
    program="""
        O1
        N10 G90 G81 X5. Z-5. R1. F100
        N20 G53 X20.
        N30 M30
    """,
    runs="N10 N20 N30", final_machine="X20",
)
case(
    "G53 may stand in a drilling cycle of a lathe",
    control=[*GSK_988, TDI], **POLICY, setup=LATHE | HOMED,
    program="""
        O1
        N10 G98 G83 Z-5. F100
        N20 G53 X20.
        N30 M30
    """,
    final_machine="X20 Z0",
)
case(
    "G27 may share a block with M30",
    control=FANUC, **POLICY, setup=HOMED,
    program="""
        O1
        N10 G27 Z0 M30
    """,
    runs="N10",
)
case(
    "G27 may not share a block with M00 on a Mitsubishi",
    control=MITSUBISHI, source="MZ 920, paired with P435", evidence="secondary",
    program="""
        O1
        N10 M8
        N20 G27 Z0 M0
        N30 M30
    """,
    runs="N10", alarm="reference-with-end", number="P435", at="O1 N20", word="M0",
)
case(
    "G28 may stand in a canned cycle",
    control=[MDI, *MITSUBISHI, HNC], **POLICY, setup=MILL | HOMED,
    program="""
        O1
        N10 G90 G81 X5. Z-5. R1. F100
        N20 G28 X0
        N30 M30
    """,
    runs="N10 N20 N30", final_machine="X0",
)
case(
    "G28 may stand in a drilling cycle of a lathe",
    control=[*GSK_988, TDI], **POLICY, setup=LATHE | HOMED,
    program="""
        O1
        N10 G98 G83 Z-5. F100
        N20 G28 X10.
        N30 M30
    """,
    runs="N10 N20 N30", final_machine="X0",
)
case(
    "G28 may not stand in a canned cycle",
    control=FANUC, source="ALM 044", evidence="secondary", setup=MILL,
    program="""
        O1
        N10 G90 G81 X5. Z-5. R1. F100
        N20 G28 X0
        N30 M30
    """,
    runs="N10", alarm="reference-in-cycle", number=numbers(FANUC, "044"), at="O1 N20", word="G28",
)

for _lead, _what in [("G0", "a motion code"), ("G80", "G80"), ("G1", "G01")]:
    case(
        f"{_what} beside G28 cancels the canned cycle first",
        control=FANUC, source="general knowledge: a code of group 01, or G80, cancels the cycle; production lathes write G0 G28 U0 W0 after each drill",
        evidence="inferred", setup=MILL,
        program=f"""
            O1
            N10 G90 G81 X5. Z-5. R1. F100
            N20 {_lead} G28 X0
            N30 G28 Y0 {_lead}
            N40 X7.
            N50 M30
        """,
        runs="N10 N20 N30 N40 N50",
    )
case(
    "a motion code beside G28 cancels the drilling cycle of a lathe first",
    control=FANUC, source="general knowledge: a code of group 01 cancels the cycle; production lathes write G0 G28 U0 W0 after each drill",
    evidence="inferred", setup={"machine": "lathe-a", "start": {"X": 0, "Z": 5}},
    program="""
        O1
        N10 G83 Z-5. R-2. F100
        N20 G0 G28 U0 W0
        N30 G83 Z-5. R-2. F100
        N40 G28 U0 W0
        N50 M30
    """,
    runs="N10 N20 N30", alarm="reference-in-cycle", number=numbers(FANUC, "044"), at="O1 N40",
    word="G28",
)

_reference = [*MITSUBISHI, *FANUC]

case(
    "G27 alarms where it does not reach the reference point",
    control=_reference, source="ALM 092; MZ 884, paired", evidence="secondary",
    setup=HOMED,
    program="""
        O1
        N10 G27 Z0
        N20 G27 Z10. M8
        N30 M30
    """,
    runs="N10 N20", alarm="not-at-reference", number=numbers(_reference, "092", "P434"),
    at="O1 N20", word="Z10.", final_work="Z10.", m=[8],
)
case(
    "G30 knows no fifth reference point",
    control=[*GSK_988, *_reference], source="ALM 046; Talm 048; general knowledge", evidence="inferred",
    setup=HOMED,
    program="""
        O1
        N10 G30 P2 Z0
        N20 G30 P5 Z0
        N30 M30
    """,
    runs="N10", alarm="reference-number", number=numbers([*GSK_988, *_reference], "046", "P35", "048"),
    at="O1 N20", word="P5",
)
