"""Motion, rule by rule: one row for what each control does where another does otherwise."""

from conformance import case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI, TE = "gsk-980tdi", "gsk-980mdi", "gsk-928te"
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, F0D, F0F, F30 = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
FANUC_PS = FANUC[1:]
HNC = "hnc-21m"
HAAS = "haas-ngc"
GSK_LATHES = [*GSK_988, TDI, TE]

MILLS = [MDI, *MITSUBISHI, *FANUC, HNC]
LATHES = [*GSK_LATHES, *MITSUBISHI, *FANUC]
TURNING = [*GSK_988, TDI, *MITSUBISHI, *FANUC]  # the codes of the 928 are known in part only
MILL = {"machine": "mill"}
LATHE = {"machine": "lathe-a"}
HOMED = {"reference": {1: {"X": 0, "Y": 0, "Z": 0}}}
RADIUS = MILL | {"radius_offsets": {1: 2}}
NOSE = LATHE | {"tools": {1: {"R": 2, "tip": 0}}}
KNOWN = {"source": "general knowledge", "evidence": "inferred"}
POLICY = {"source": "policy", "evidence": "inferred"}


def numbers(controls, fanuc=None, mitsubishi=None, gsk_988=None, mdi=None):
    """The alarm numbers of the makers, each control with the one of its maker; `066/325` where the
    16i's number is not that of the later series."""
    old, later = (fanuc.split("/") * 2)[:2] if fanuc else (None, None)
    by_control = {
        **dict.fromkeys(GSK_988, gsk_988), **dict.fromkeys(MITSUBISHI, mitsubishi),
        F16: old, **dict.fromkeys(FANUC_PS, later and f"PS0{later}"), MDI: mdi,
    }
    return {control: by_control.get(control) for control in controls}


# Power-on

case(
    "U is an axis of its own on a control that is a mill by itself",
    pins="machine",
    control=[*MITSUBISHI, *FANUC, HNC], **KNOWN,
    program="""
        O1
        N10 G0 X10.
        N20 G1 U10. F100
        N30 M30
    """,
    moves_x=[10, 10],
)
case(
    "U is an increment of X on a control that is a lathe by itself",
    pins="machine",
    control=GSK_LATHES, source="TDi 2; source 001: U-4", evidence="maker's manual",
    program="""
        O1
        N10 G0 X10.
        N20 U10.
        N30 M30
    """,
    moves_x=[10, 20],
)
case(
    "G22 leaves lengths as they are",
    control=[*GSK_988, TDI, *MITSUBISHI, *FANUC], source="TDi: stroke check; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 G22
        N20 G0 X10.
        N30 M30
    """,
    moves_x=[10],
)
case(
    "#4014 is the work system",
    pins="modal_groups",
    control=[*GSK_988, TDI, MDI, *FANUC, "haas-ngc"], source="REG; general knowledge", evidence="inferred",
    program="""
        O1
        N10 G55
        N20 #100=#4014
        N30 M30
    """,
    vars={100: 55},
)
case(
    "#4012 is the work system on a Mitsubishi",
    pins="modal_groups",
    control=MITSUBISHI, **KNOWN,
    program="""
        O1
        N10 G55
        N20 #100=#4012
        N30 M30
    """,
    vars={100: 55},
)
for machine, controls in ("mill", [MDI, *FANUC, HNC]), ("lathe-a", GSK_LATHES):
    case(
        f"a control of a {machine} wakes up in G00",
        pins="power_on_line",
        control=controls, source="TApar 3402#0; TDi 2; general knowledge", evidence="inferred",
        setup={"machine": machine},
        program="""
            O1
            N10 X10. F100
            N20 M30
        """,
        moves="R X10",
    )
case(
    "the control wakes up in G01",
    pins="power_on_line",
    control=MITSUBISHI, source="M7 p.534 (11); general knowledge", evidence="inferred",
    setup=MILL,
    program="""
        O1
        N10 X10. F100
        N20 M30
    """,
    moves="F X10",
)
for machine, controls in ("mill", MILLS), ("lathe-b", [*MITSUBISHI, *FANUC]):
    case(
        f"a control of a {machine} wakes up in G90",
        control=controls, source="TApar 3402#3; general knowledge", evidence="inferred",
        setup={"machine": machine, "start": {"X": 5}},
        program="""
            O1
            N10 G0 X10.
            N20 M30
        """,
        moves_x=[10],
    )
case(
    "a lathe wakes up with feed per revolution",
    pins="power_on_per_minute",
    control=[*GSK_988, *FANUC], source="TApar 3402#4; general knowledge", evidence="inferred",
    setup=LATHE,
    program="""
        O1
        N10 G97 S500 M3
        N20 G1 Z-10. F0.2
        N30 M30
    """,
    moves="F Z-10", time=6,
)
case(
    "a lathe wakes up with feed per minute",
    pins="power_on_per_minute",
    control=[TDI, TE, *MITSUBISHI], source="TDi 26; source 001: F80, F500; general knowledge",
    evidence="inferred", setup=LATHE,
    program="""
        O1
        N10 G97 S500 M3
        N20 G1 Z-10. F100.
        N30 M30
    """,
    moves="F Z-10", time=6,
)
case(
    "the feed at power-on is that of 1411",
    pins="power_on_feed",
    control=TA, source="TApar 1411", evidence="maker's manual", setup=LATHE,
    program="""
        O1
        N10 G98 G1 Z-10.
        N20 M30
    """,
    moves="F Z-10", time=6,
)
_no_feed = [T, MDI, *MITSUBISHI, *FANUC]
case(
    "a cut before any F alarms",
    pins="power_on_feed",
    control=_no_feed, source="ALM 011; M7 p.52; Talm 021; MDib 0023", evidence="secondary",
    program="""
        O1
        N10 G0 Z1.
        N20 G1 Z-10.
        N30 M30
    """,
    runs="N10", alarm="no-feed", number=numbers(_no_feed, "011", "P62", "021", "0023"), at="O1 N20",
)
case(
    "a cut before any F alarms on the 988TA where 1411 is 0",
    control=TA, source="Talm 021; TApar 1411", evidence="secondary", params={"1411": 0},
    program="""
        O1
        N10 G0 Z1.
        N20 G1 Z-10.
        N30 M30
    """,
    runs="N10", alarm="no-feed", number="021", at="O1 N20",
)
for machine, controls in ("mill", [*MILLS, HAAS]), ("lathe-a", GSK_LATHES):
    case(
        f"an axis of a {machine} without a rate of its own goes 10000 mm in a minute",
        pins="max_digits rapid_rate",
        control=controls, **POLICY, setup={"machine": machine},
        program="""
            O1
            N10 G0 Z-10000.
            N20 M30
        """,
        moves="R Z-10000", time=60,
    )

# One-shot codes and feed

case(
    "G04 with a motion code is a dwell",
    control=[*GSK_LATHES, *MITSUBISHI, *FANUC, HNC], **KNOWN,
    program="""
        O1
        N10 G01 G04 X2. F100
        N20 M30
    """,
    moves="W 2",
)
case(
    "codes of groups 00 and 01 may not share a block on the 980MDi",
    control=MDI, source="MDib 0014", evidence="maker's manual",
    program="""
        O1
        N10 M8
        N20 G01 G04 X2. F100
        N30 M30
    """,
    runs="N10", alarm="one-shot-with-motion", number="0014", at="O1 N20",
)
case(
    "P of G04 counts milliseconds",
    pins="dwell_p_seconds",
    control=[*GSK_LATHES, MDI, *MITSUBISHI, *FANUC], source="TDi 14; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 G04 P1500
        N20 M30
    """,
    moves="W 1.5",
)
case(
    "a thread at spindle standstill alarms",
    control=GSK_988, source="Talm 102", evidence="secondary", setup=LATHE,
    program="""
        O1
        N10 G0 Z1.
        N20 G32 Z-10. F2.
        N30 M30
    """,
    runs="N10", alarm="spindle-stopped", number="102", at="O1 N20",
)
case(
    "a thread is cut though no block has started the spindle",
    pins="thread_needs_spindle",
    control=[*MITSUBISHI, *FANUC], **POLICY, setup=LATHE,
    program="""
        O1
        N10 G32 Z-10. F2.
        N20 M30
    """,
    moves="T Z-10",
)
case(
    "a thread of a mill is cut though no block has started the spindle",
    control="fanuc-16i", **POLICY, setup=MILL,
    program="""
        O1
        N10 G33 Z-10. F2.
        N20 M30
    """,
    moves="T Z-10",
)
_lead = [T, *MITSUBISHI, *FANUC]
case(
    "a thread without a lead alarms",
    control=_lead, source="Talm 038; ALM 313; general knowledge", evidence="inferred", setup=LATHE,
    program="""
        O1
        N10 G0 Z1. S100 M3
        N20 G32 Z-10.
        N30 M30
    """,
    runs="N10", alarm="thread-lead",
    number=numbers(_lead, None, "P93", "038") | dict.fromkeys(FANUC_PS, "PS0313"), at="O1 N20",
)
case(
    "a move beyond the travel of its axis alarms",
    control=[MDI, *MITSUBISHI, *FANUC, HNC], **KNOWN,
    setup=MILL | {"limits": {"X": (-100, 100)}},
    program="""
        O1
        N10 G0 X100.
        N20 G0 X100.01
        N30 M30
    """,
    runs="N10", alarm="over-travel", at="O1 N20",
    number={MDI: "3011", **dict.fromkeys(MITSUBISHI, "M01 0007"), F16: "500",
            **dict.fromkeys(FANUC_PS, "OT0500"), HNC: None},
)
case(
    "a move below the travel of its axis has the number of that direction",
    control=[MDI, *MITSUBISHI, *FANUC], source="MDia 3016 to 3018; SK M01-0007; general knowledge",
    evidence="inferred", setup=MILL | {"limits": {"X": (-100, 100), "Y": (-50, 50)}},
    program="""
        O1
        N10 G0 X-100. Y50.
        N20 G0 X-100.01
        N30 M30
    """,
    runs="N10", alarm="over-travel", at="O1 N20",
    number={MDI: "3016", **dict.fromkeys(MITSUBISHI, "M01 0007"), F16: "501",
            **dict.fromkeys(FANUC_PS, "OT0501")},
)
for _axis, _sign, _number in (("Y", "", "3012"), ("Z", "", "3013"), ("Y", "-", "3017"), ("Z", "-", "3018")):
    case(
        f"the 980MDi has {_number} for the travel of {_sign or '+'}{_axis}",
        control=MDI, source="MDia 3011 to 3020", evidence="maker's manual",
        setup=MILL | {"limits": {_axis: (-100, 100)}},
        program=f"O1\nN10 G0 {_axis}{_sign}100.\nN20 G0 {_axis}{_sign}100.01\nN30 M30",
        runs="N10", alarm="over-travel", at="O1 N20", number=_number,
    )
case(
    "an arc that bulges out of the travel below has the number of below",
    control=[MDI, *FANUC], source="MDia 3017; general knowledge", evidence="inferred",
    setup=MILL | {"limits": {"Y": (-5, 50)}},
    program="O1\nN10 G17 G0 X0 Y0\nN20 G3 X20. Y0 R10. F100\nN30 M30",
    runs="N10", alarm="over-travel", at="O1 N20",
    number={MDI: "3017", F16: "501", **dict.fromkeys(FANUC_PS, "OT0501")},
)
case(
    "a move beyond the travel of its axis alarms on a lathe",
    control=GSK_LATHES, **KNOWN, setup=LATHE | {"limits": {"Z": (-100, 100)}},
    program="""
        O1
        N10 G0 Z-100.
        N20 G0 Z-100.01
        N30 M30
    """,
    runs="N10", alarm="over-travel", at="O1 N20",
)

# Arcs

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
    "radii that differ by more than a tenth of a millimetre alarm on a Mitsubishi",
    pins="cuts_fine_digits arc_tolerance",
    control=MITSUBISHI, source="MZ 817, paired; M7 p.194", evidence="secondary", setup=MILL,
    program="""
        O1
        N10 G0 Z1.
        N20 G3 X-10. Y10.1005 I-10. J0 F100
        N30 M30
    """,
    runs="N10", alarm="radius-tolerance", number="P70", at="O1 N20",
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
for machine, controls, words in (
    ("mill", [*MITSUBISHI, *FANUC, HNC, HAAS], "I0 J0"), ("lathe-a", GSK_LATHES, "I0 K0"),
):
    case(
        f"a circle around its own start moves nothing on a {machine}",
        pins="arc_centre_needed",
        control=controls, **POLICY, setup={"machine": machine},
        program=f"""
            O1
            N10 G2 {words} F100
            N20 G1 Z-5.
            N30 M30
        """,
        runs="N10 N20 N30", final_machine="X0 Z-5",
    )
case(
    "a centre on the start point alarms on the 980MDi",
    pins="arc_centre_needed",
    control=MDI, source="MDib 0021", evidence="maker's manual",
    program="""
        O1
        N10 G0 Z1.
        N20 G2 X10. I0 J0 F100
        N30 M30
    """,
    runs="N10", alarm="no-radius", number="0021", at="O1 N20",
)
for machine, controls, word in ("mill", FANUC, "Y"), ("lathe-a", GSK_988, "Z"):
    case(
        f"an arc of a {machine} without R and centre is a line",
        pins="no_radius",
        control=controls, source="TApar 3403#5; general knowledge",
        evidence="inferred", setup={"machine": machine},
        program=f"""
            O1
            N10 G2 X10. {word}10. F100
            N20 M30
        """,
        moves=f"F X10 {word}10",
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
    runs="N10", alarm="no-radius", at="O1 N20",
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
    control=_arc, source="MZ 818, paired; MDib 0018; general knowledge", evidence="inferred",
    setup=MILL,
    program="""
        O1
        N10 G0 Z1.
        N20 G2 X10. R4.96 F100
        N30 M30
    """,
    params={"3410": 0.09},
    runs="N10", alarm="radius-too-small", number=numbers(_arc, None, "P71", None, "0018"), at="O1 N20",
)
case(
    "a radius that is too small alarms also inside the tolerance of the 980TDi and the 928",
    pins="small_radius",
    control=[TDI, TE], source="TDi 4 note 3; general knowledge", evidence="inferred", setup=LATHE,
    program="""
        O1
        N10 G0 Z1.
        N20 G2 Z11. R4.96 F100
        N30 M30
    """,
    params={"3410": 0.09},
    runs="N10", alarm="radius-too-small", at="O1 N20",
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
    pins="negative_radius negative_radius_on_lathes",
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
    at="O1 N20",
)
for machine, controls in ("mill", [MDI, *FANUC, HNC]), ("lathe-a", GSK_LATHES):
    case(
        f"an arc of a {machine} with R that ends where it starts does not move",
        control=controls, source="16TC p.67; TDi 4 note 4; general knowledge", evidence="inferred",
        setup={"machine": machine},
        program="""
            O1
            N10 G2 R20. F100
            N20 G1 Z-5.
            N30 M30
        """,
        moves="F Z-5",
    )

case(
    "an arc with R that ends where it starts alarms on a Mitsubishi",
    pins="radius_needs_travel",
    control=MITSUBISHI, source="general knowledge; error 108 of the motion controller Q172",
    evidence="inferred", setup=MILL,
    program="""
        O1
        N10 G0 Z1.
        N20 G2 R20. F100
        N30 M30
    """,
    runs="N10", alarm="no-arc-travel", at="O1 N20",
)

# Units, machine coordinates, reference points

case(
    "G20 behind a move changes the unit from there on",
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
    "G20 behind a move changes the unit of a lathe from there on",
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
    "G20 behind a move alarms on the HNC",
    pins="unit_change",
    control=HNC, source="source 003, G20 G21 G22", evidence="source document",
    program="""
        O1
        N10 G0 X10.
        N20 G20
        N30 M30
    """,
    runs="N10", alarm="unit-change-misplaced", at="O1 N20",
)
_late = [*GSK_988, MDI]
case(
    "G20 behind a move alarms",
    pins="unit_change",
    control=_late, source="Talm 042; MDib 0038", evidence="secondary",
    program="""
        O1
        N10 G0 X10.
        N20 G20
        N30 M30
    """,
    runs="N10", alarm="unit-change-misplaced", number=numbers(_late, gsk_988="042", mdi="0038"),
    at="O1 N20",
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
    pins="home_needed",
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
    "G30 alarms where the setup names no reference point",
    pins="home_needed",
    control=_home, source="Talm 047; MDib 0069", evidence="secondary",
    program="""
        O1
        N10 G0 Z1.
        N20 G30 Z0
        N30 M30
    """,
    runs="N10", alarm="reference-not-known", number=numbers(_home, gsk_988="047", mdi="0069"),
    at="O1 N20",
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
    runs="N10", alarm="reference-with-end", number="P435", at="O1 N20",
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
    runs="N10", alarm="reference-in-cycle", number=numbers(FANUC, "044"), at="O1 N20",
)
_reference = [*MITSUBISHI, *FANUC]
case(
    "G27 alarms where it does not reach the reference point",
    control=_reference, source="ALM 092; MZ 884, paired", evidence="secondary",
    setup=HOMED,
    program="""
        O1
        N10 G27 Z0
        N20 G27 Z10.
        N30 M30
    """,
    runs="N10", alarm="not-at-reference", number=numbers(_reference, "092", "P434"),
    at="O1 N20",
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
    at="O1 N20",
)

# Coordinates and offsets

case(
    "G50 with coordinates alarms on the 988TA while 1202#2 is 1",
    control=TA, source="TApar 1202#2", evidence="maker's manual", params={"1202#2": 1},
    program="""
        O1
        N10 G50 S2000
        N20 G50 X10.
        N30 M30
    """,
    runs="N10", alarm="coordinate-setting-refused", at="O1 N20",
)
case(
    "G50 gives a lathe the coordinates that are written",
    pins="set_coordinate_alarms",
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
    runs="N10", alarm="work-system", at="O1 N20",
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
    runs="N10", alarm="offset-number", number=numbers(_length, "030", "P170"), at="O1 N20",
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
    runs="N10", alarm="offset-number", number="0016", at="O1 N20",
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
    at="O1 N20",
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
    runs="N10", alarm="length-with-motion", number="0042", at="O1 N20",
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
    runs="N10", alarm="length-axis", number=numbers(FANUC, "027"), at="O1 N20",
)

# Polar coordinates, rotation, scaling, mirror

_polar = [*MITSUBISHI, *FANUC]
case(
    "the plane may change in polar coordinates",
    control=_polar, **POLICY, setup=MILL,
    program="""
        O1
        N10 G16
        N20 G18
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "the work system may change in polar coordinates",
    control=_polar, **POLICY, setup=MILL,
    program="""
        O1
        N10 G16
        N20 G55
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "an arc in polar coordinates may have I and J",
    control=_polar, **POLICY, setup=MILL | {"start": {"X": 10, "Y": 0}},
    program="""
        O1
        N10 G16
        N20 G3 X10. Y90. I-10. J0 F100
        N30 M30
    """,
    moves="CCW X0 Y10 C X0 Y0",
)
case(
    "an arc in polar coordinates may have no I on the 980MDi",
    control=MDI, source="MDib 0176", evidence="maker's manual", setup=MILL | {"start": {"X": 10, "Y": 0}},
    program="""
        O1
        N10 G16
        N20 G3 X10. Y90. I-10. J0 F100
        N30 M30
    """,
    runs="N10", alarm="polar-centre", number="0176", at="O1 N20",
)
for name, code in {"G28": "G28 X0", "a plane change": "G17 G18"}.items():
    case(
        f"{name} may stand in a rotation",
        pins="max_rotation",
        control=[*FANUC, HNC] if code == "G17 G18" else [*MITSUBISHI, *FANUC, HNC], **POLICY, setup=MILL,
        program=f"""
            O1
            N10 G68 X0 Y0 R90.
            N20 {code}
            N30 M30
        """,
        runs="N10 N20 N30",
    )
case(
    "a plane change alarms in a rotation of the 980MDi",
    control=MDI, source="MDib 0154", evidence="maker's manual",
    program="""
        O1
        N10 G68 X0 Y0 R90.
        N20 G18
        N30 M30
    """,
    runs="N10", alarm="rotation-plane", number="0154", at="O1 N20",
)
case(
    "a plane change alarms in a rotation of a Mitsubishi",
    control=MITSUBISHI, source="MZ 824, paired with P111", evidence="secondary", setup=MILL,
    program="""
        O1
        N10 G68 X0 Y0 R90.
        N20 G18
        N30 M30
    """,
    runs="N10", alarm="rotation-plane", number="P111", at="O1 N20",
)
_turn = [MDI, *FANUC]
case(
    "an angle of rotation over 360 degrees alarms",
    pins="max_rotation",
    control=_turn, source="MDib 0156; general knowledge", evidence="inferred", setup=MILL,
    program="""
        O1
        N10 G68 X0 Y0 R360.
        N20 G68 X0 Y0 R360.5
        N30 M30
    """,
    runs="N10", alarm="rotation-out-of-range", number=numbers(_turn, mdi="0156"), at="O1 N20",
)
case(
    "an angle of rotation may be over 360 degrees",
    control=MITSUBISHI, **POLICY, setup=MILL,
    program="""
        O1
        N10 G68 X0 Y0 R450.
        N20 G0 X10. Y0
        N30 M30
    """,
    final_machine="X0 Y10",
)
case(
    "an angle of rotation may be over 360 degrees on the 988",
    control=GSK_988, source="TA 5, table; policy", evidence="inferred", setup=LATHE,
    program="""
        O1
        N10 G68.1 X0 Z0 R450.
        N20 G0 X0 Z10.
        N30 M30
    """,
    final_machine="X10 Z0",
)
_scale = [MDI, F30]
case(
    "a scale of zero alarms",
    control=_scale, source="MDib 0158; ALM 300", evidence="secondary", setup=MILL,
    program="""
        O1
        N10 G51 X0 Y0 Z0 P2000
        N20 G51 X0 Y0 Z0 P0
        N30 M30
    """,
    runs="N10", alarm="scale-zero", number={MDI: "0158", F30: "PS0142"}, at="O1 N20",
)

case(
    "P of G51 counts thousandths",
    pins="scale_thousandths",
    control=[MDI, *MITSUBISHI, *FANUC], **KNOWN, setup=MILL,
    program="""
        O1
        N10 G51 X0 Y0 Z0 P2000
        N20 G0 X10.
        N30 M30
    """,
    moves="R X20",
)
case(
    "P of G51 is the factor itself on the HNC-21",
    pins="scale_thousandths",
    control=[HNC, "haas-ngc"], **KNOWN, setup=MILL,
    program="""
        O1
        N10 G51 X0 Y0 Z0 P2
        N20 G0 X10.
        N30 M30
    """,
    moves="R X20",
)

# Radius compensation. r = 2; lathes draw the same picture in Z and X/2.

case(
    "a start-up of type A ends on the normal of the next move, also at an outside corner",
    pins="start_up",
    control=[*MILLS, "haas-ngc"], source="M7 p.188; 5003#0; general knowledge", evidence="inferred", setup=RADIUS,
    program="""
        O1
        N10 G41 G1 X10. D1 F100
        N20 Y-20.
        N30 G40 X0
        N40 M30
    """,
    centre="X12 Y0 | X12 Y-20 | X0 Y-20",
)
case(
    "a start-up of type A ends on the normal of the next move on a lathe",
    pins="start_up",
    control=[*GSK_988, TDI], **KNOWN, setup=NOSE,
    program="""
        O1
        N5 T0101
        N10 G41 G1 Z10. F100
        N20 X-40.
        N30 G40 Z0
        N40 M30
    """,
    centre="X0 Z12 | X-40 Z12 | X-40 Z0",
)
case(
    "around an acute corner the tool goes by lines",
    pins="acute_corner",
    control=[*MILLS, "haas-ngc"], source="general knowledge", evidence="inferred", setup=RADIUS,
    program="""
        O1
        N10 G41 G1 Y10. D1 F100
        N20 X20.
        N30 X10. Y0
        N40 G40 X0
        N50 M30
    """,
    centre="X0 Y12 | X22 Y12 | X22.8284 Y10 | X11.4142 Y-1.4142 | X0 Y0",
)
case(
    "around an acute corner the tool of a lathe goes by lines",
    pins="acute_corner",
    control=[*GSK_988, TDI], source="TDipar 002#5; general knowledge", evidence="inferred", setup=NOSE,
    program="""
        O1
        N5 T0101
        N10 G41 G1 X20. F100
        N20 Z20.
        N30 X0 Z10.
        N40 G40 Z0
        N50 M30
    """,
    centre="X24 Z0 | X24 Z22 | X20 Z22.8284 | X-2.8284 Z11.4142 | X0 Z0",
)
for count, controls in (2, [F16, F0D, F0F, HNC, HAAS]), (4, [*MITSUBISHI, F30]):
    idle = "".join(f"\n        N{30 + i} M{10 + i}" for i in range(count))
    case(
        f"{count} blocks without a move let one move end and the next begin on its own normal",
        pins="idle_blocks idle_blocks_alarm",
        control=controls, source="source 003, note a; M7 p.191, 202, 203; 30iM p.166",
        evidence="inferred", setup=RADIUS,
        program=f"""
        O1
        N10 G41 G1 Y10. D1 F100
        N20 X20.{idle}
        N50 Y30.
        N60 G40 X0
        N70 M30
        """,
        centre="X0 Y12 | X20 Y12 | X18 Y10 | X18 Y30 | X0 Y30",
    )
case(
    "two blocks without a move let one move of a lathe end and the next begin on its own normal",
    pins="idle_blocks idle_blocks_alarm",
    control=[*GSK_988, TDI], **POLICY, setup=NOSE,
    program="""
        O1
        N5 T0101
        N10 G41 G1 X20. F100
        N20 Z20.
        N30 M10
        N31 M11
        N50 X60.
        N60 G40 Z0
        N70 M30
    """,
    centre="X24 Z0 | X24 Z20 | X20 Z18 | X60 Z18 | X60 Z0",
)
_many = "".join(f"\n        N{30 + i} M{10 + i}" for i in range(11))
case(
    "eleven blocks without a move alarm on the 980MDi",
    pins="idle_blocks idle_blocks_alarm",
    control=MDI, source="MDib 0263; the count: general knowledge", evidence="inferred", setup=RADIUS,
    program=f"""
        O1
        N10 G41 G1 Y10. D1 F100
        N20 X20.{_many}
        N50 Y30.
        N60 G40 X0
        N70 M30
        """,
    alarm="idle-blocks-in-offset", number="0263", at="O1 N40",
)
case(
    "GOTO may stand in radius compensation",
    pins="jumps_in_compensation",
    control=[*MITSUBISHI, *FANUC, "haas-ngc"], **POLICY, setup=RADIUS,
    program="""
        O1
        N10 G41 G1 Y10. D1 F100
        N20 GOTO 30
        N25 Y50.
        N30 X20.
        N40 G40 Y0
        N50 M30
    """,
    runs="N10 N20 N30 N40 N50",
)
case(
    "GOTO may stand in radius compensation of a lathe",
    pins="jumps_in_compensation",
    control=[*GSK_988, TDI], **POLICY, setup=NOSE,
    program="""
        O1
        N5 T0101
        N10 G41 G1 X20. F100
        N20 GOTO 30
        N25 X50.
        N30 Z20.
        N40 G40 X0
        N50 M30
    """,
    runs="N5 N10 N20 N30 N40 N50",
)
case(
    "G41 before any D has no radius",
    control=[MDI, *FANUC, HNC], **KNOWN, setup=RADIUS,
    program="""
        O1
        N10 G41 G1 Y10. F100
        N20 X20.
        N30 M30
    """,
    centre="X0 Y10 | X20 Y10",
)
case(
    "G41 before any D alarms on a Mitsubishi",
    control=MITSUBISHI, source="MZ 839, paired with P170", evidence="secondary", setup=RADIUS,
    program="""
        O1
        N10 G0 X1.
        N20 G41 G1 Y10. F100
        N30 M30
    """,
    runs="N10", alarm="radius-offset-number", number="P170", at="O1 N20",
)
case(
    "a canned cycle may stand in radius compensation",
    control=[MDI, *FANUC, HNC], **POLICY, setup=RADIUS,
    program="""
        O1
        N10 G41 G1 Y10. D1 F100
        N20 X20.
        N30 G81 X30. Z-5. R1.
        N40 M30
    """,
    runs="N10 N20 N30 N40",
)
case(
    "a drilling cycle may stand in radius compensation of a lathe",
    control=[*GSK_988, TDI], source="TA 24; general knowledge", evidence="inferred", setup=NOSE,
    program="""
        O1
        N5 T0101
        N10 G41 G1 X20. F100
        N20 Z20.
        N30 G83 Z5.
        N40 M30
    """,
    runs="N5 N10 N20 N30 N40",
)
case(
    "a canned cycle may not stand in radius compensation of a Mitsubishi",
    control=MITSUBISHI, source="MZ 901, paired with P155", evidence="secondary", setup=RADIUS,
    program="""
        O1
        N10 G41 G1 Y10. D1 F100
        N20 X20.
        N30 G81 X30. Z-5. R1.
        N40 M30
    """,
    runs="N10 N20", alarm="cycle-in-offset", number="P155", at="O1 N30",
)
case(
    "a rotation may begin in radius compensation",
    control=[*MITSUBISHI, *FANUC, HNC], **POLICY, setup=RADIUS,
    program="""
        O1
        N10 G41 G1 Y10. D1 F100
        N20 G68 X0 Y0 R90.
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "a rotation may begin in radius compensation of the 988",
    control=GSK_988, **POLICY, setup=NOSE,
    program="""
        O1
        N5 T0101
        N10 G41 G1 X20. F100
        N20 G68.1 X0 Z0 R90.
        N30 M30
    """,
    runs="N5 N10 N20 N30",
)
_radius = [MDI, *MITSUBISHI, *FANUC]
case(
    "radius compensation may not begin in an arc",
    control=_radius, source="ALM 034; M7 p.194; MDib 0258", evidence="secondary", setup=RADIUS,
    program="""
        O1
        N10 G0 X1.
        N20 G41 G2 X21. I10. D1 F100
        N25 G1 Y-10.
        N30 M30
    """,
    runs="N10", alarm="arc-at-offset-start", number=numbers(_radius, "034", "P151", None, "0258"),
    at="O1 N20",
)
case(
    "radius compensation may not end in an arc",
    control=_radius, source="ALM 034; M7 p.194; MDib 0259", evidence="secondary", setup=RADIUS,
    program="""
        O1
        N10 G41 G1 Y10. D1 F100
        N20 X20.
        N30 G40 G2 X40. I10.
        N40 G1 Y0
        N50 M30
    """,
    alarm="arc-at-offset-end", number=numbers(_radius, "034", "P151", None, "0259"),
)
case(
    "an offset line that does not reach the offset arc behind it alarms",
    control=_radius, source="ALM 033; M7 p.194; MDib 0257", evidence="secondary",
    setup=MILL | {"radius_offsets": {1: 5}},
    program="""
        O1
        N10 G41 G1 X-20. Y0 D1 F100
        N20 X10.
        N30 G3 X4. Y6. I-6. J0
        N40 G1 X-10.
        N50 G40 Y0
        N60 M30
    """,
    alarm="no-offset-intersection", number=numbers(_radius, "033", "P152", None, "0257"),
)
case(
    "G31 may not stand in radius compensation",
    control=_radius, source="ALM 0035; MDib 0035; general knowledge", evidence="inferred", setup=RADIUS,
    program="""
        O1
        N10 G41 G1 Y10. D1 F100
        N20 X20.
        N30 G31 X40.
        N40 M30
    """,
    runs="N10 N20", alarm="skip-in-offset", number=numbers(_radius, "036/035", "P608", None, "0035"),
    at="O1 N30",
)

# Canned cycles

for letter, controls in ("K", [MDI, *FANUC]), ("L", [MDI, *MITSUBISHI, HNC, HAAS]):
    case(
        f"{letter} repeats a canned cycle",
        pins="cycle_repeats max_cycle_repeats",
        control=controls, source="MDib 0204; general knowledge", evidence="inferred", setup=MILL,
        program=f"""
            O1
            N10 G91 G81 X5. Z-5. R0 F100. {letter}2
            N20 M30
        """,
        moves="R X5\nR Z0\nF Z-5\nR Z0\nR X10\nR Z0\nF Z-5\nR Z0",
    )
case(
    "K repeats a drilling cycle of a lathe",
    control=GSK_988, source="TA 24", evidence="maker's manual", setup=LATHE,
    program="""
        O1
        N10 G98 G83 Z-5. F100. K2
        N20 M30
    """,
    moves="F Z-5\nR Z0\nF Z-5\nR Z0",
)
for letter, controls in ("K", FANUC), ("L", [*MITSUBISHI, HNC, HAAS]):
    case(
        f"{letter}0 stores the data of a canned cycle and drills nothing",
        pins="zero_cycle_repeats",
        control=controls, **KNOWN, setup=MILL,
        program=f"""
            O1
            N10 G90 G81 X5. Z-5. R1. F100. {letter}0
            N20 X10.
            N30 M30
        """,
        moves="R X10\nR Z1\nF Z-5\nR Z0",
    )
case(
    "K0 alarms in a drilling cycle of the 988",
    pins="zero_cycle_repeats",
    control=GSK_988, source="Talm 181", evidence="secondary", setup=LATHE,
    program="""
        O1
        N10 G98 G0 Z1.
        N20 G83 Z-5. F100. K0
        N30 M30
    """,
    runs="N10", alarm="cycle-repeats", number="181", at="O1 N20",
)
case(
    "L0 alarms in a canned cycle of the 980MDi",
    pins="zero_cycle_repeats",
    control=MDI, source="MDib 0203", evidence="maker's manual",
    program="""
        O1
        N10 G0 Z1.
        N20 G90 G81 X5. Z-5. R1. F100. L0
        N30 M30
    """,
    runs="N10", alarm="cycle-repeats", number="0203", at="O1 N20",
)
for code, seconds in ("G73", 66.066), ("G83", 66.198):
    case(
        f"{code} draws back by half a millimetre where no parameter says otherwise, whatever K is",
        pins="peck_words peck_retract peck_clearance drill_retract",
        control=[MDI, *MITSUBISHI, *FANUC, HAAS], **POLICY, setup=MILL,
        program=f"""
            O1
            N10 G90 {code} Z-10. R0 Q4. K1 F10.
            N20 M30
        """,
        time=seconds,
    )
    case(
        f"{code} of the HNC without K draws back by half a millimetre",
        pins="peck_retract peck_clearance drill_retract",
        control=HNC, **POLICY, setup=MILL,
        program=f"""
            O1
            N10 G90 {code} Z-10. R0 Q-4. F10.
            N20 M30
        """,
        time=seconds,
    )
for q, controls in ("Q4", GSK_988), ("Q4000", [*MITSUBISHI, *FANUC]):
    case(
        f"a pecking cycle of a lathe with {q} draws back by half a millimetre, whatever K is",
        pins="peck_words peck_retract drill_full_retract drill_retract",
        control=controls, source="TA 24, 5101#2; TDi 23.9; the half millimetre: policy",
        evidence="inferred", setup=LATHE,
        program=f"""
            O1
            N10 G98 G83 Z-10. {q} K1 F10.
            N20 M30
        """,
        moves="F Z-4\nR Z-3.5\nF Z-8\nR Z-7.5\nF Z-10\nR Z0", time=66.066,
    )
_peck = [MDI, *MITSUBISHI, *FANUC, HNC]
case(
    "a pecking cycle without Q alarms",
    pins="peck_needed",
    control=[*_peck, "haas-ngc"], source="ALM 045; general knowledge", evidence="inferred", setup=MILL,
    program="""
        O1
        N10 G0 Z1.
        N20 G90 G83 X5. Z-10. R0 F100.
        N30 M30
    """,
    runs="N10", alarm="no-peck", number={**numbers(_peck, "045"), "haas-ngc": None}, at="O1 N20",
)
case(
    "R of a drilling cycle is a plane that counts from the start",
    control=[*GSK_988, *MITSUBISHI, *FANUC], source="TA 24; general knowledge", evidence="inferred", setup=LATHE,
    program="""
        O1
        N10 G98 G83 Z-10. R-2. F100.
        N20 M30
    """,
    moves="R Z-2\nF Z-10\nR Z0",
)
case(
    "R of a drilling cycle is no plane on the 980TDi",
    control=TDI, source="TDi 23.9", evidence="maker's manual", setup=LATHE,
    program="""
        O1
        N10 G98 G83 Z-10. R2. F100.
        N20 M30
    """,
    moves="F Z-10\nR Z0",
)

# Lathes

TOOL = LATHE | {"tools": {1: {"X": 1, "Z": 0}}}
case(
    "a tool offset is a shift of the coordinates and moves nothing",
    pins="tool_offset tool_offset_digits",
    control=[*GSK_LATHES, *MITSUBISHI, *FANUC],
    source="TApar 5002#4; TDipar 003#4; general knowledge", evidence="inferred", setup=TOOL,
    program="""
        O1
        N10 T0201
        N20 M30
    """,
    moves="none", final_work="X-1",
)
case(
    "G50 sets the coordinates of the point with the tool offset in it",
    pins="set_coordinate_without_tool",
    control=[*GSK_988, TE, *MITSUBISHI, *FANUC], **KNOWN, setup=TOOL,
    program="""
        O1
        N10 T0201
        N20 G50 X10.
        N30 M30
    """,
    final_work="X10",
)
case(
    "of X and U in one block X counts",
    control=[*GSK_LATHES, *MITSUBISHI, *FANUC], source="TDi 2; for others: policy", evidence="inferred",
    setup=LATHE | {"start": {"X": 20, "Z": 0}},
    program="""
        O1
        N10 G0 X10. U5.
        N20 M30
    """,
    moves="R X10",
)

# Corners

case(
    ",C is the distance of a chamfer from its corner",
    pins="chamfer_words chamfer_length",
    control=MILLS, **KNOWN, setup=MILL,
    program="""
        O1
        N10 G1 X10. ,C2. F100
        N20 Y10.
        N30 M30
    """,
    moves="F X8\nF X10 Y2\nF Y10",
)
case(
    ",R is the radius of a corner round",
    control=MILLS, **KNOWN, setup=MILL,
    program="""
        O1
        N10 G1 X10. ,R2. F100
        N20 Y10.
        N30 M30
    """,
    moves="F X8\nCCW X10 Y2 C X8 Y2\nF Y10",
)
case(
    ",C is the distance of a lathe's chamfer from its corner",
    pins="chamfer_words chamfer_length",
    control=[*GSK_988, TE, *MITSUBISHI, *FANUC, "haas-ngc"], source="TApar 3405#4; general knowledge", evidence="inferred",
    setup=LATHE,
    program="""
        O1
        N10 G1 Z-10. ,C2. F100
        N20 X20.
        N30 M30
    """,
    moves="F Z-8\nF X4 Z-10\nF X20",
)
case(
    ",R is the radius of a lathe's corner round",
    control=[*GSK_988, TE, *MITSUBISHI, *FANUC], source="TApar 3405#4; general knowledge", evidence="inferred",
    setup=LATHE,
    program="""
        O1
        N10 G1 Z-10. ,R2. F100
        N20 X20.
        N30 M30
    """,
    moves="F Z-8\nCW X4 Z-10 C X4 Z-8\nF X20",
)
_corner = [*MITSUBISHI, *FANUC, MDI]
for claim, program, cause, number in (
    ("a chamfer in a rapid alarms", "N20 G0 X10. ,C2.\nN30 G1 Y10.", "corner-in-rapid",
     ([*MITSUBISHI, *FANUC], "050", "P385", None)),
    ("a rapid behind a chamfer alarms", "N20 G1 X10. ,C2.\nN30 G0 Y10.", "corner-next-move",
     ([*FANUC, MDI], "052", None, "0036")),
    ("a plane change behind a chamfer alarms", "N20 G1 X10. ,C2.\nN30 G18 G1 Z10.", "corner-plane",
     ([*MITSUBISHI, *FANUC_PS, MDI], "306", "P396", "0031")),
    ("a chamfer and a corner round in one block alarm", "N20 G1 X10. ,C2. ,R2.\nN30 G1 Y10.",
     "corner-format", ([*FANUC, MDI], "053", None, "0093")),
):
    controls, fanuc, mitsubishi, mdi = number
    case(
        claim, control=controls, source="ALM; MZ 951, 919, paired; MDib", evidence="secondary",
        setup=MILL, program=f"O1\nN10 G1 X1. F100\n{program}\nN40 M30",
        alarm=cause, number=numbers(controls, fanuc, mitsubishi, None, mdi),
    )

# Multiple cycles

_feed = {**dict.fromkeys(GSK_988, "F"), TDI: "F", TE: "F"}
for kind, controls in ("F", [*GSK_988, TDI]), ("R", [*MITSUBISHI, *FANUC]):
    name = "at feed" if kind == "F" else "rapid"
    case(
        f"G71 cuts a millimetre deep and leaves the cut by half a millimetre, {name}",
        pins="rough_depth rough_escape",
        control=controls, source="TDi 23.1 step 4; TA 8; ROB p.48; the amounts: policy",
        evidence="inferred", setup=LATHE | {"start": {"X": 20, "Z": 2}},
        program="""
            O1
            N10 G71 P20 Q30 U0 W0 F10.
            N20 G0 X16.
            N30 G1 Z-10.
            N40 M30
        """,
        moves=f"""
            R X20 Z2
            R X18
            F Z-10
            {kind} X19 Z-9.5
            R Z2
            R X16
            F Z-10
            R X20 Z2
        """,
    )
_lathe = [*GSK_988, *MITSUBISHI, *FANUC]
case(
    "G73 R1 is one pass",
    pins="single_pass_pattern",
    control=[*GSK_988, *MITSUBISHI, *FANUC], **KNOWN,
    setup=LATHE | {"start": {"X": 20, "Z": 2}},
    program="""
        O1
        N10 G73 U2. W0 R1
        N15 G73 P20 Q30 U0 W0 F10.
        N20 G0 X16.
        N30 G1 Z-10.
        N40 M30
    """,
    moves="R X20 Z2\nR X16\nF Z-10\nR X20 Z2",
)
case(
    "G73 R1 is two passes on the 980TDi",
    pins="single_pass_pattern",
    control=TDI, source="TDi 23.3", evidence="maker's manual",
    setup=LATHE | {"start": {"X": 20, "Z": 2}},
    program="""
        O1
        N10 G73 U2. W0 R1
        N15 G73 P20 Q30 U0 W0 F10.
        N20 G0 X16.
        N30 G1 Z-10.
        N40 M30
    """,
    moves="R X24 Z2\nR X20\nF Z-10\nR X20 Z2\nR X16\nF Z-10\nR X20 Z2",
)
case(
    "Q of G74 counts least increments",
    control=[*MITSUBISHI, *FANUC], **KNOWN, setup=LATHE,
    program="""
        O1
        N10 G74 R1.
        N20 G74 Z-10. Q6000 F10.
        N30 M30
    """,
    moves="F Z-6\nR Z-5\nF Z-10\nR Z0",
)
case(
    "Q of G74 counts millimetres on the 988",
    control=GSK_988, source="TA 12, 3401#1", evidence="maker's manual", setup=LATHE,
    program="""
        O1
        N10 G74 R1.
        N20 G74 Z-10. Q6 F10.
        N30 M30
    """,
    moves="F Z-6\nR Z-5\nF Z-10\nR Z0",
)
for letter, controls in ("P3000", [*MITSUBISHI, *FANUC]), ("P3", GSK_988):
    case(
        f"P of G75 is a radius: {letter} is 6 mm of diameter",
        pins="groove_p_diameter",
        control=controls, source="TA 12, 13; general knowledge", evidence="inferred",
        setup=LATHE | {"start": {"X": 20, "Z": 0}},
        program=f"""
            O1
            N10 G75 R1.
            N20 G75 X10. {letter} F10.
            N30 M30
        """,
        moves="F X14\nR X16\nF X10\nR X20",
    )

PROFILE = LATHE | {"start": {"X": 20, "Z": 2}}
for claim, head, body, cause, fanuc, mitsubishi, gsk_988 in (
    ("a call inside the profile of G71 alarms", "G71 P20 Q40", "N20 G0 X10.\nN30 M98 P2\nN40 G1 Z-10.", "call-in-profile", "066/325", None, "131"),
    ("a profile that begins with an arc alarms", "G71 P20 Q40", "N20 G2 X10. Z0 R20.\nN30 G1 Z-10.\nN40 X20.", "profile-first-block", "065", None, "144"),
    ("G71 with P and no Q alarms", "G71 P20", "N20 G0 X10.\nN30 G1 Z-10.\nN40 X20.", "pq-missing", "061", None, "133"),
    ("G28 inside a profile alarms", "G71 P20 Q40", "N20 G0 X10.\nN30 G1 Z-10.\nN40 G28 X20.", "profile-code", "066/325", None, "128"),
    ("a macro statement inside a profile alarms", "G71 P20 Q40", "N20 G0 X10.\nN30 #100=1\nN40 G1 Z-10.", "profile-macro", None, None, "130"),
    ("a depth of cut of 0 alarms", "G71 U0 R1.\nN15 G71 P20 Q40", "N20 G0 X10.\nN30 G1 Z-10.\nN40 X20.", "cycle-depth", "062", None, "148"),
):
    case(
        claim, control=_lathe, source="ALM; MZ 897, paired; Talm", evidence="secondary", setup=PROFILE,
        program=f"O1\nN5 G0 X20.\nN10 {head} U0 W0 F10.\n{body}\nN50 M30\nO2\nN60 M99"
        if "U0 R1" not in head
        else f"O1\nN5 G0 X20.\nN10 {head} U0 W0 F10.\n{body}\nN50 M30",
        alarm=cause, number=numbers(_lathe, fanuc, mitsubishi, gsk_988),
    )
for claim, of, params in (
    ("a profile that turns back alarms", [c for c in _lathe if c not in GSK_988], None),
    ("a profile that turns back alarms where 5102#1 says so", GSK_988, {"5102#1": 1}),
):
    case(
        claim, control=of, source="ALM; MZ 897, paired; Talm", evidence="secondary", setup=PROFILE, params=params,
        program="O1\nN5 G0 X20.\nN10 G71 P20 Q40 U0 W0 F10.\nN20 G0 X10.\nN30 G1 Z-10.\nN40 X12. Z-5.\nN50 M30",
        alarm="profile-not-monotone", number=numbers(of, "064", "P203", "138"),
    )
case(
    "a call inside the profile of G71 alarms on the 980TDi", control=TDI, source="TDi 23.1",
    evidence="maker's manual", setup=PROFILE,
    program="O1\nN10 G71 P20 Q40 U0 W0 F10.\nN20 G0 X10.\nN30 M98 P2\nN40 G1 Z-10.\nN50 M30\nO2\nN60 M99",
    alarm="call-in-profile",
)
case(
    "a profile that turns back alarms on the 980TDi with K1", control=TDI,
    source="TDi 23.1; general knowledge",
    evidence="inferred", setup=PROFILE,
    program="O1\nN10 G71 P20 Q40 U0 W0 K1 F10.\nN20 G0 X10.\nN30 G1 Z-10.\nN40 X12. Z-5.\nN50 M30",
    alarm="profile-not-monotone",
)
for claim, end, behind in (
    ("behind G71 the program goes on behind the profile", [TDI, *MITSUBISHI, *FANUC], "N10 N50"),
    ("behind G71 the 988 goes on with the next block where the profile stands elsewhere", GSK_988,
     "N10 N15 N20 N30 N50"),
):
    case(
        claim, control=end, source="TDi 23.1; TA 8; general knowledge", evidence="inferred", setup=PROFILE,
        pins="contour_behind",
        program="O1\nN10 G71 P20 Q30 U0 W0 F10.\nN15 M8\nN20 G0 X10.\nN30 G1 Z-10.\nN50 M30",
        runs=behind,
    )
for claim, block, cause, number in (
    ("G75 without X alarms", "G75 Z-10. Q1000 F10.", "groove-axis", (None, None, "154")),
    ("G76 without P alarms", "G76 X18. Z-10. Q100 F1.", "thread-height", ("062/317", None, "167")),
):
    case(
        claim, control=_lathe if cause != "groove-axis" else T, source="ALM; Talm",
        evidence="secondary", setup=PROFILE,
        program=f"O1\nN10 G97 S100 M3\nN20 {block}\nN30 M30",
        runs="N10", alarm=cause,
        number=numbers(_lathe if cause != "groove-axis" else [T], *number), at="O1 N20",
    )

for height, controls in ("P1 Q1", GSK_988), ("P1000 Q200", [*MITSUBISHI, *FANUC]):
    case(
        f"G76 with a finishing allowance above its height of {height} alarms",
        control=controls, source="Talm 165; ALM 0317", evidence="secondary", setup=PROFILE,
        program=f"""
            O1
            N10 G97 S100 M3
            N20 G76 P010060 R2.
            N30 G76 X18. Z-10. {height} F1.
            N40 M30
        """,
        runs="N10 N20", alarm="thread-allowance", number=numbers(controls, "062/317", None, "165"),
        at="O1 N30",
    )

# Reset

for machine, controls in ("mill", [MDI, HNC, HAAS]), ("lathe-a", TURNING):
    case(
        f"the reset of a {machine} leaves the modal codes as they are",
        pins="clear_on_reset",
        control=controls, source="TApar 3402#6; general knowledge", evidence="inferred",
        setup={"machine": machine},
        program="""
            O1
            N10 G19
            N20 M30
        """,
        modal_after_reset={"plane": "G19"},
    )
case(
    "reset ends G52",
    pins="clear_local_on_reset",
    control=[TDI, MDI, *MITSUBISHI, HNC], source="TDipar 181; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 G52 X10.
        N20 M30
    """,
    work_after_reset="X0",
)
case(
    "reset leaves G52 as it is while 1202#3 is 0",
    pins="clear_local_on_reset",
    control=[*GSK_988, *FANUC], source="TApar 1202#3; general knowledge", evidence="inferred",
    program="""
        O1
        N10 G52 X10.
        N20 M30
    """,
    work_after_reset="X-10",
)
