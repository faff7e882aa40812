"""Motion, rule by rule: one-shot codes and feed."""

from conformance import case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI, TE = "gsk-980tdi", "gsk-980mdi", "gsk-928te"
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, F0D, F0F, F30 = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
FANUC_PS = FANUC[1:]
HNC = "hnc-21m"
GSK_LATHES = [*GSK_988, TDI, TE]
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
    runs="N10", alarm="one-shot-with-motion", number="0014", at="O1 N20", word="G04",
)
case(
    "P of G04 counts milliseconds",
    pins="dwell_unit",
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
    runs="N10", alarm="spindle-stopped", number="102", at="O1 N20", word="G32",
)
case(
    "a thread is cut though no block has started the spindle",
    pins="refuses:spindle-stopped",
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
    number=numbers(_lead, None, "P93", "038") | dict.fromkeys(FANUC_PS, "PS0313"), at="O1 N20", word="G32",
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
    runs="N10", alarm="over-travel", at="O1 N20", word="X100.01",
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
    runs="N10", alarm="over-travel", at="O1 N20", word="X-100.01",
    number={MDI: "3016", **dict.fromkeys(MITSUBISHI, "M01 0007"), F16: "501",
            **dict.fromkeys(FANUC_PS, "OT0501")},
)
case(
    "the 980MDi has 3012 for the travel of +Y",
    control=MDI, source="MDia 3011 to 3020", evidence="maker's manual",
    setup=MILL | {"limits": {"Y": (-100, 100)}},
    program="O1\nN10 G0 Y100.\nN20 G0 Y100.01\nN30 M30",
    runs="N10", alarm="over-travel", at="O1 N20", word="Y100.01", number="3012",
)
case(
    "the 980MDi has 3013 for the travel of +Z",
    control=MDI, source="MDia 3011 to 3020", evidence="maker's manual",
    setup=MILL | {"limits": {"Z": (-100, 100)}},
    program="O1\nN10 G0 Z100.\nN20 G0 Z100.01\nN30 M30",
    runs="N10", alarm="over-travel", at="O1 N20", word="Z100.01", number="3013",
)
case(
    "the 980MDi has 3017 for the travel of -Y",
    control=MDI, source="MDia 3011 to 3020", evidence="maker's manual",
    setup=MILL | {"limits": {"Y": (-100, 100)}},
    program="O1\nN10 G0 Y-100.\nN20 G0 Y-100.01\nN30 M30",
    runs="N10", alarm="over-travel", at="O1 N20", word="Y-100.01", number="3017",
)
case(
    "the 980MDi has 3018 for the travel of -Z",
    control=MDI, source="MDia 3011 to 3020", evidence="maker's manual",
    setup=MILL | {"limits": {"Z": (-100, 100)}},
    program="O1\nN10 G0 Z-100.\nN20 G0 Z-100.01\nN30 M30",
    runs="N10", alarm="over-travel", at="O1 N20", word="Z-100.01", number="3018",
)
case(
    "an arc that bulges out of the travel below has the number of below",
    control=[MDI, *FANUC], source="MDia 3017; general knowledge", evidence="inferred",
    setup=MILL | {"limits": {"Y": (-5, 50)}},
    program="O1\nN10 G17 G0 X0 Y0\nN20 G3 X20. Y0 R10. F100\nN30 M30",
    runs="N10", alarm="over-travel", at="O1 N20", word="Y0",
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
    runs="N10", alarm="over-travel", at="O1 N20", word="Z-100.01",
)
