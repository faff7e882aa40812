"""Motion, rule by rule: arcs, and the travel they may not leave."""

from conformance import UNKNOWN, case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI, TE = "gsk-980tdi", "gsk-980mdi", "gsk-928te"
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, F0D, F0F, F30 = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
FANUC_PS = FANUC[1:]
HNC = "hnc-21m"
HAAS, SYNTEC = "haas-ngc", "syntec-22ma"
GSK_LATHES = [*GSK_988, TDI, TE]
MILLS = [MDI, *MITSUBISHI, *FANUC, HNC]
MILL = {"machine": "mill"}
LATHE = {"machine": "lathe-a"}
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
    "radii that differ are not checked while the tolerance is 0",
    pins="arc_tolerance",
    control=[MDI, *FANUC, HNC, "haas-ngc"], source="TApar 3410; 16TC p.67", evidence="maker's manual",
    setup=MILL,
    program="""
        O1
        N10 G3 X-10. Y10.05 I-10. J0 F100
        N20 M30
    """,
    moves="CCW X-10 Y10.05 C X-10 Y0",
)
case(
    "radii that differ are not checked on a lathe while the tolerance is 0",
    pins="arc_tolerance",
    control=GSK_LATHES, source="TApar 3410; TDi 4 note 5", evidence="maker's manual", setup=LATHE,
    program="""
        O1
        N10 G3 X20.1 Z-10. I0 K-10. F100
        N20 M30
    """,
    moves="CCW X20.1 Z-10 C X0 Z-10",
)
case(
    "the tolerance counts as it is, whatever its words are rounded to",
    pins="arc_rounding",
    control=[MDI, *MITSUBISHI, *FANUC, HNC, HAAS, SYNTEC], **POLICY, setup=MILL, replace={"arc_tolerance": 10},
    program="""
        O1
        N10 G3 X-1. Y1.009 I-1. J0 F100
        N20 M30
    """,
    moves="CCW X-1 Y1.009 C X-1 Y0",
)
case(
    "the tolerance counts as it is on a lathe, whatever its words are rounded to",
    pins="arc_rounding",
    control=GSK_LATHES, **POLICY, setup=LATHE, replace={"arc_tolerance": 10},
    program="""
        O1
        N10 G3 X2.018 Z-1. I0 K-1. F100
        N20 M30
    """,
    moves="CCW X2.018 Z-1 C X0 Z-1",
)
case(
    "what a large arc misses counts as what a small one does",
    pins="arc_tolerance_share",
    control=[MDI, *MITSUBISHI, *FANUC, HNC, HAAS, SYNTEC], **POLICY, setup=MILL, replace={"arc_tolerance": 10},
    program="""
        O1
        N10 G0 Z1.
        N20 G3 X-100. Y100.05 I-100. J0 F100
        N30 M30
    """,
    runs="N10", alarm="radius-tolerance", number=UNKNOWN, at="O1 N20", word="X-100.",
)
case(
    "what a large arc misses counts as what a small one does, on a lathe too",
    pins="arc_tolerance_share",
    control=GSK_LATHES, **POLICY, setup=LATHE, replace={"arc_tolerance": 10},
    program="""
        O1
        N10 G0 Z0.
        N20 G3 X200.1 Z-100. I0 K-100. F100
        N30 M30
    """,
    runs="N10", alarm="radius-tolerance", number=UNKNOWN, at="O1 N20", word="X200.1",
)
case(
    "radii that differ by more than a tenth of a millimetre alarm on a Mitsubishi",
    pins="cuts_fine_digits arc_tolerance",
    control=MITSUBISHI, source="MZ 817, paired; M7 p.194", evidence="secondary", setup=MILL,
    program="""
        O1
        N10 G0 Z1.
        N20 G3 X-10. Y10.1005 I-10. J0 F100
        N30 M30
    """,
    runs="N10", alarm="radius-tolerance", number="P70", at="O1 N20", word="X-10.",
)
case(
    "radii that differ by less than a tenth of a millimetre are taken on a Mitsubishi",
    control=MITSUBISHI, source="M7 p.194, spiral within RadErr", evidence="maker's manual",
    setup=MILL,
    program="""
        O1
        N10 G3 X-10. Y10.099 I-10. J0 F100
        N20 M30
    """,
    moves="CCW X-10 Y10.099 C X-10 Y0",
)
case(
    "a circle around its own start moves nothing on a mill",
    pins="refuses:no-radius", control=[*MITSUBISHI, *FANUC, HNC, HAAS], **POLICY,
    setup={"machine": "mill"},
    program="O1\nN10 G2 I0 J0 F100\nN20 G1 Z-5.\nN30 M30",
    runs="N10 N20 N30", final_machine="X0 Z-5",
)
case(
    "a circle around its own start moves nothing on a lathe-a",
    pins="refuses:no-radius", control=GSK_LATHES, **POLICY, setup={"machine": "lathe-a"},
    program="O1\nN10 G2 I0 K0 F100\nN20 G1 Z-5.\nN30 M30",
    runs="N10 N20 N30", final_machine="X0 Z-5",
)
case(
    "a centre on the start point alarms on the 980MDi",
    pins="refuses:no-radius",
    control=MDI, source="MDib 0021", evidence="maker's manual",
    program="""
        O1
        N10 G0 Z1.
        N20 G2 X10. I0 J0 F100
        N30 M30
    """,
    runs="N10", alarm="no-radius", number="0021", at="O1 N20", word="I0",
)
case(
    "an arc of a mill without R and centre is a line",
    pins="no_radius", control=FANUC, source="TApar 3403#5; general knowledge", evidence="inferred",
    setup={"machine": "mill"},
    program="O1\nN10 G2 X10. Y10. F100\nN20 M30",
    moves="F X10 Y10",
)
case(
    "an arc of a lathe-a without R and centre is a line",
    pins="no_radius", control=GSK_988, source="TApar 3403#5; general knowledge",
    evidence="inferred", setup={"machine": "lathe-a"},
    program="O1\nN10 G2 X10. Z10. F100\nN20 M30",
    moves="F X10 Z10",
)

_arc = [MDI, *MITSUBISHI, HNC]

case(
    "an arc without R and centre alarms",
    pins="no_radius",
    control=[*_arc, "haas-ngc"], source="MDib 0021; general knowledge", evidence="inferred", setup=MILL,
    program="""
        O1
        N10 G0 Z1.
        N20 G2 X10. Y10. F100
        N30 M30
    """,
    runs="N10", alarm="no-radius", number={**numbers(_arc, None, "P33", None, "0021"), "haas-ngc": None}, at="O1 N20",
    word="G2",
)
case(
    "an arc of a lathe without R and centre alarms",
    pins="no_radius",
    control=[TDI, TE], source="TDi 4 note 1; general knowledge", evidence="inferred", setup=LATHE,
    program="""
        O1
        N10 G0 Z1.
        N20 G2 X10. Z-10. F100
        N30 M30
    """,
    runs="N10", alarm="no-radius", at="O1 N20", word="G2",
)
case(
    "a radius that is too small by less than the tolerance makes a half circle",
    pins="small_radius",
    control=FANUC, source="TApar 3403#4; general knowledge", evidence="inferred", setup=MILL,
    params={"3410": 1},
    program="""
        O1
        N10 G2 X10. R4.9 F100
        N20 M30
    """,
    moves="CW X10 C X5 Y0",
)
case(
    "a radius that is too small by less than the tolerance makes a half circle on the 988",
    pins="small_radius",
    control=GSK_988, source="TApar 3403#4", evidence="maker's manual", setup=LATHE,
    params={"3410": 1},
    program="""
        O1
        N10 G2 Z10. R4.9 F100
        N20 M30
    """,
    moves="CW Z10 C X0 Z5",
)
case(
    "a radius that is too small alarms also inside the tolerance",
    pins="small_radius",
    control=[MDI, HNC], source="MDib 0018; general knowledge", evidence="inferred",
    setup=MILL,
    program="""
        O1
        N10 G0 Z1.
        N20 G2 X10. R4.96 F100
        N30 M30
    """,
    replace={"arc_tolerance": 90},
    runs="N10", alarm="radius-too-small", number=numbers([MDI, HNC], None, None, None, "0018"), at="O1 N20",
    word="R4.96",
)
case(
    "a radius that is too small alarms also inside the tolerance of a Mitsubishi",
    pins="small_radius",
    control=MITSUBISHI, source="MZ 818, paired; general knowledge", evidence="inferred",
    setup=MILL,
    program="""
        O1
        N10 G0 Z1.
        N20 G2 X10. R4.96 F100
        N30 M30
    """,
    params={"1084": 0.09},
    runs="N10", alarm="radius-too-small", number="P71", at="O1 N20",
    word="R4.96",
)
case(
    "a radius that is too small alarms also inside the tolerance of the 980TDi",
    pins="small_radius",
    control=TDI, source="TDi 4 note 3", evidence="inferred", setup=LATHE,
    program="""
        O1
        N10 G0 Z1.
        N20 G2 Z11. R4.96 F100
        N30 M30
    """,
    params={"154": 0.09},
    runs="N10", alarm="radius-too-small", at="O1 N20", word="R4.96",
)
case(
    "a radius that is too small alarms also inside the tolerance of the 928",
    pins="small_radius",
    control=TE, source="general knowledge", evidence="inferred", setup=LATHE,
    program="""
        O1
        N10 G0 Z1.
        N20 G2 Z11. R4.96 F100
        N30 M30
    """,
    replace={"arc_tolerance": 90},
    runs="N10", alarm="radius-too-small", at="O1 N20", word="R4.96",
)
case(
    "a negative R takes the long way round on every mill",
    pins="negative_radius",
    control=MILLS, source="source 003, R; general knowledge", evidence="inferred", setup=MILL,
    program="""
        O1
        N10 G2 X10. Y10. R-10. F100
        N20 M30
    """,
    moves="CW X10 Y10 C X0 Y10",
)
case(
    "a negative R takes the long way round on a lathe",
    pins="negative_radius",
    control=[*GSK_LATHES, *MITSUBISHI, *FANUC_PS, "haas-ngc"], source="TDi 4 note 7; general knowledge",
    evidence="inferred", setup=LATHE,
    program="""
        O1
        N10 G2 X20. Z10. R-10. F100
        N20 M30
    """,
    moves="CW X20 Z10 C X20 Z0",
)
case(
    "a third axis goes along with the angle of an arc",
    pins="helix",
    control=[*MILLS, "haas-ngc"], source="source 003, G02 and G03; general knowledge", evidence="inferred",
    setup=MILL,
    program="""
        O1
        N10 G3 X-20. Y20. I-20. Z-5. F200
        N20 M30
    """,
    moves="CCW X-20 Y20 Z-5 C X-20 Y0",
)
case(
    "an axis across the plane of an arc alarms on a lathe without helices",
    pins="helix",
    control=[*GSK_988, TDI], source="Talm 033; general knowledge", evidence="inferred", setup=LATHE,
    program="""
        O1
        N10 G0 Z1.
        N20 G2 X10. Z-10. R20. Y5. F200
        N30 M30
    """,
    runs="N10", alarm="arc-axis-not-in-plane", number={**dict.fromkeys(GSK_988, "033"), TDI: None},
    at="O1 N20", word="Y5.",
)
case(
    "an arc of a mill with R that ends where it starts does not move",
    control=[MDI, *FANUC, HNC], source="16TC p.67; TDi 4 note 4; general knowledge",
    evidence="inferred", setup={"machine": "mill"},
    program="O1\nN10 G2 R20. F100\nN20 G1 Z-5.\nN30 M30",
    moves="F Z-5",
)
case(
    "an arc of a lathe-a with R that ends where it starts does not move",
    control=GSK_LATHES, source="16TC p.67; TDi 4 note 4; general knowledge", evidence="inferred",
    setup={"machine": "lathe-a"},
    program="O1\nN10 G2 R20. F100\nN20 G1 Z-5.\nN30 M30",
    moves="F Z-5",
)
case(
    "an arc with R that ends where it starts alarms on a Mitsubishi",
    pins="refuses:no-arc-travel",
    control=MITSUBISHI, source="general knowledge; error 108 of the motion controller Q172",
    evidence="inferred", setup=MILL,
    program="""
        O1
        N10 G0 Z1.
        N20 G2 R20. F100
        N30 M30
    """,
    runs="N10", alarm="no-arc-travel", at="O1 N20", word="R20.",
)
