"""Motion, rule by rule: radius compensation."""

from conformance import case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI, TE = "gsk-980tdi", "gsk-980mdi", "gsk-928te"
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, F0D, F0F, F30 = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
FANUC_PS = FANUC[1:]
HNC = "hnc-21m"
HAAS = "haas-ngc"
MILLS = [MDI, *MITSUBISHI, *FANUC, HNC]
MILL = {"machine": "mill"}
LATHE = {"machine": "lathe-a"}
RADIUS = MILL | {"radius_offsets": {1: 2}}
NOSE = LATHE | {"tools": {1: {"R": 2, "tip": 0}}}
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
case(
    "2 blocks without a move let one move end and the next begin on its own normal",
    pins="idle_blocks refuses:idle-blocks-in-offset", control=[F16, F0D, F0F, HNC, HAAS],
    source="source 003, note a; M7 p.191, 202, 203; 30iM p.166", evidence="inferred", setup=RADIUS,
    program="""
        O1
        N10 G41 G1 Y10. D1 F100
        N20 X20.
        N30 M10
        N31 M11
        N50 Y30.
        N60 G40 X0
        N70 M30
    """,
    centre="X0 Y12 | X20 Y12 | X18 Y10 | X18 Y30 | X0 Y30",
)
case(
    "4 blocks without a move let one move end and the next begin on its own normal",
    pins="idle_blocks refuses:idle-blocks-in-offset", control=[*MITSUBISHI, F30],
    source="source 003, note a; M7 p.191, 202, 203; 30iM p.166", evidence="inferred", setup=RADIUS,
    program="""
        O1
        N10 G41 G1 Y10. D1 F100
        N20 X20.
        N30 M10
        N31 M11
        N32 M12
        N33 M13
        N50 Y30.
        N60 G40 X0
        N70 M30
    """,
    centre="X0 Y12 | X20 Y12 | X18 Y10 | X18 Y30 | X0 Y30",
)
case(
    "two blocks without a move let one move of a lathe end and the next begin on its own normal",
    pins="idle_blocks refuses:idle-blocks-in-offset",
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
    pins="idle_blocks refuses:idle-blocks-in-offset",
    control=MDI, source="MDib 0263; the count: general knowledge", evidence="inferred", setup=RADIUS,
    program=f"""
        O1
        N10 G41 G1 Y10. D1 F100
        N20 X20.{_many}
        N50 Y30.
        N60 G40 X0
        N70 M30
        """,
    alarm="idle-blocks-in-offset", number="0263", at="O1 N40", word="M20",
)
case(
    "GOTO may stand in radius compensation",
    pins="refuses:jump-in-offset",
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
    pins="refuses:jump-in-offset",
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
    runs="N10", alarm="radius-offset-number", number="P170", at="O1 N20", word="G41",
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
    runs="N10 N20", alarm="cycle-in-offset", number="P155", at="O1 N30", word="G81",
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
    at="O1 N20", word="G2",
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
    alarm="arc-at-offset-end", number=numbers(_radius, "034", "P151", None, "0259"), word="G2",
)
case(
    "an offset line that does not reach the offset arc after it alarms",
    control=_radius, source="ALM 033; M7 p.194; MDib 0261", evidence="secondary",
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
    alarm="no-offset-intersection", number=numbers(_radius, "033", "P152", None, "0261"), word="X4.",
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
    at="O1 N30", word="G31",
)
