"""Motion, rule by rule: coordinates and offsets."""

from conformance import case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI, TE = "gsk-980tdi", "gsk-980mdi", "gsk-928te"
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, F0D, F0F, F30 = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
FANUC_PS = FANUC[1:]
HNC = "hnc-21m"
GSK_LATHES = [*GSK_988, TDI, TE]
MILLS = [MDI, *MITSUBISHI, *FANUC, HNC]
LATHES = [*GSK_LATHES, *MITSUBISHI, *FANUC]
TURNING = [*GSK_988, TDI, *MITSUBISHI, *FANUC]  # the codes of the 928 are known in part only
MILL = {"machine": "mill"}
LATHE = {"machine": "lathe-a"}
KNOWN = {"source": "general knowledge", "evidence": "inferred"}
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
    "G50 with coordinates alarms on the 988TA while 1202#2 is 1",
    control=TA, source="TApar 1202#2", evidence="maker's manual", params={"1202#2": 1},
    program="""
        O1
        N10 G50 S2000
        N20 G50 X10.
        N30 M30
    """,
    runs="N10", alarm="coordinate-setting-refused", at="O1 N20", word="G50",
)
case(
    "G50 gives a lathe the coordinates that are written",
    pins="refuses:coordinate-setting-refused",
    control=LATHES, source="TDi 18; TApar 1202#2; general knowledge", evidence="inferred",
    setup=LATHE,
    program="""
        O1
        N10 G50 X10. Z5.
        N20 M30
    """,
    final_work="X10 Z5",
)
case(
    "there is no G54.1 P49",
    pins="max_extra_systems",
    control=[*MITSUBISHI, *FANUC], source="general knowledge, P1 to P48", evidence="inferred",
    program="""
        O1
        N10 G54.1 P48
        N20 G54.1 P49
        N30 M30
    """,
    runs="N10", alarm="work-system", at="O1 N20", word="P49",
)

_length = [*MITSUBISHI, *FANUC, HNC]

case(
    "there is no H401",
    pins="max_offset_number",
    control=_length, source="ALM 030; MZ 839, paired; general knowledge", evidence="inferred",
    setup=MILL,
    program="""
        O1
        N10 G0 G43 H400 Z0
        N20 G43 H401 Z0
        N30 M30
    """,
    runs="N10", alarm="offset-number", number=numbers(_length, "030", "P170"), at="O1 N20", word="H401",
)
case(
    "there is no H33 on the 980MDi",
    pins="max_offset_number",
    control=MDI, source="MDib 0016", evidence="maker's manual",
    program="""
        O1
        N10 G43 H32 Z0
        N20 G43 H33 Z0
        N30 M30
    """,
    runs="N10", alarm="offset-number", number="0016", at="O1 N20", word="H33",
)
case(
    "there is no D401",
    control=_length, source="ALM 030; MZ 839, paired; general knowledge", evidence="inferred",
    setup=MILL,
    program="""
        O1
        N10 D400
        N20 D401
        N30 M30
    """,
    runs="N10", alarm="radius-offset-number", number=numbers(_length, "030", "P170"), at="O1 N20",
    word="D401",
)
case(
    "G10 knows no tool offset 401 on a lathe",
    pins="max_offset_number",
    control=TURNING, source="Talm 062; ALM 031; general knowledge",
    evidence="inferred", setup=LATHE,
    program="""
        O1
        N10 G10 P400 X1.
        N20 G10 P401 X1.
        N30 M30
    """,
    runs="N10", alarm="g10-offset-number", number=numbers(TURNING, "031", None, "062"),
    at="O1 N20", word="P401",
)
case(
    "G43 may share a block with a dwell",
    control=_length, **POLICY, setup=MILL | {"length_offsets": {1: 5}},
    program="""
        O1
        N10 G43 H1 G4 X1.
        N20 M30
    """,
    runs="N10 N20",
)
case(
    "G43 may not share a block with a dwell on the 980MDi",
    control=MDI, source="MDib 0042", evidence="maker's manual",
    program="""
        O1
        N10 M8
        N20 G43 H1 G4 X1.
        N30 M30
    """,
    runs="N10", alarm="length-with-motion", number="0042", at="O1 N20", word="G43",
)
case(
    "the length offset lies on Z in G18 too",
    control=MILLS, **KNOWN, setup=MILL | {"length_offsets": {1: 5}},
    program="""
        O1
        N10 G18
        N20 G43 G0 Z10. H1
        N30 M30
    """,
    moves="R Z10", final_machine="Z15",
)
case(
    "G43 without an axis alarms while 5001#0 is 1",
    control=FANUC, source="ALM 027", evidence="secondary", setup=MILL, params={"5001#0": 1},
    program="""
        O1
        N10 G43 Z0 H1
        N20 G43 H1
        N30 M30
    """,
    runs="N10", alarm="length-axis", number=numbers(FANUC, "027"), at="O1 N20", word="G43",
)
