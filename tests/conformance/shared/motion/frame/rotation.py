"""Motion, rule by rule: polar coordinates, rotation, scaling, mirror."""

from conformance import case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI, TE = "gsk-980tdi", "gsk-980mdi", "gsk-928te"
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, F0D, F0F, F30 = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
FANUC_PS = FANUC[1:]
HNC = "hnc-21m"
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
    runs="N10", alarm="polar-centre", number="0176", at="O1 N20", word="I-10.",
)
case(
    "G28 may stand in a rotation",
    pins="max_rotation", control=[*MITSUBISHI, *FANUC, HNC], **POLICY, setup=MILL,
    program="O1\nN10 G68 X0 Y0 R90.\nN20 G28 X0\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "a plane change may stand in a rotation",
    control=[*FANUC, HNC], **POLICY, setup=MILL,
    program="O1\nN10 G68 X0 Y0 R90.\nN20 G17 G18\nN30 M30",
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
    runs="N10", alarm="rotation-plane", number="0154", at="O1 N20", word="G18",
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
    runs="N10", alarm="rotation-plane", number="P111", at="O1 N20", word="G18",
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
    runs="N10", alarm="rotation-out-of-range", number=numbers(_turn, mdi="0156"), at="O1 N20", word="R360.5",
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
    runs="N10", alarm="scale-zero", number={MDI: "0158", F30: "PS0142"}, at="O1 N20", word="P0",
)
case(
    "P of G51 counts thousandths",
    pins="scale_unit",
    control=[MDI, *MITSUBISHI, *FANUC], **KNOWN, setup=MILL,
    program="""
        O1
        N10 G51 X0 Y0 Z0 P2000
        N20 G0 X10.
        N30 M30
    """,
    moves="R X20",
)
HAAS_SCALES = {
    "control": "haas-ngc", "source": "HML p.136, G51 P2. and G51 P2", "evidence": "secondary",
    "setup": MILL,
}
case(
    "P of G51 is a factor with a point on the Haas", **HAAS_SCALES,
    program="O1\nN10 G51 X0 Y0 P2.\nN20 G0 X10.\nN30 G51 X0 Y0 P0.5\nN40 G0 X10.\nN50 G50\nN60 M30",
    moves="R X20\nR X5",
)
case(
    "a computed P of G51 counts thousandths on the Haas", pins="scale_unit",
    **HAAS_SCALES | {"source": "H96 p.159, G51 P [ #5 * 1000 ]"},
    program="O1\nN10 #5=2.0\nN20 G51 X0 Y0 P [ #5 * 1000 ]\nN30 G0 X10.\nN40 M30",
    moves="R X20",
)
case(
    "P of G51 is the factor itself on the HNC-21 and on the Haas",
    pins="scale_unit",
    control=[HNC, "haas-ngc"], **KNOWN, setup=MILL,
    program="""
        O1
        N10 G51 X0 Y0 Z0 P2
        N20 G0 X10.
        N30 M30
    """,
    moves="R X20",
)
