"""Feeds: the unit of F on rotary axes, a feed that was never given, a spindle that stands."""

from conformance import case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI = "gsk-980tdi", "gsk-980mdi"
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, *FANUC_PS = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
HNC, TE = "hnc-21m", "gsk-928te"
MILLS = [MDI, *MITSUBISHI, *FANUC, HNC]
ALL = [*GSK_988, TDI, TE, *MILLS]
UNITS = {
    "source": "source 003, G94; B-63174EN p.33; CSDN 112450340; general knowledge",
    "evidence": "secondary",
}

# ---- F of a rotary axis ----
case(
    "under inch F of a rotary axis alone is degrees a minute",
    control=MILLS, **UNITS,
    program="""
        O1
        G20
        N10 G91 G94 G1 A90. F60.
        N20 M30
    """,
    moves="F A90", time=90,
)
case(
    "under inch F of a straight axis is inches a minute",
    control=MILLS, **UNITS,
    program="""
        O1
        G20
        N10 G91 G94 G1 X3. F60.
        N20 M30
    """,
    moves="F X76.2", time=3,
)
case(
    "with a straight axis beside it a degree counts as a millimetre",
    control=MILLS, **UNITS,
    program="""
        O1
        G21
        N10 G91 G94 G1 X20. B40. F300.
        N20 M30
    """,
    moves="F X20 B40", time=8.944272,
)
case(
    "with a straight axis beside it a degree counts as an inch under inch",
    control=MILLS, **UNITS,
    program="""
        O1
        G20
        N10 G91 G94 G1 X20. B40. F300.
        N20 M30
    """,
    moves="F X508 B40", time=8.944272,
)
case(
    "the C axis of a lathe turns at F degrees a minute under inch, named by C and by H",
    control=TDI, source="B-63174EN p.33; general knowledge",
    evidence="inferred", setup={"machine": "lathe-a"},
    program="""
        O1
        G20
        N10 G98 G1 C30. F60.
        N20 G1 H60.
        N30 M30
    """,
    moves="F C30\nF C90", time=90,
)
case(
    "the B axis of a lathe turns at F degrees a minute under inch",
    control=[*GSK_988, TDI, *FANUC], source="B-63174EN p.33; general knowledge",
    evidence="inferred", setup={"machine": "lathe-a"},
    program="""
        O1
        G20
        N10 G98 G1 B30. F60.
        N20 X2. F60.
        N30 M30
    """,
    moves="F B30\nF X50.8 B30", time=31,
)
case(
    "under inch F of a rotary axis is degrees a revolution in feed per revolution",
    control=[*MITSUBISHI, *FANUC], **UNITS,
    program="""
        O1
        G20
        N10 S100 M3
        N20 G91 G95 G1 A10. F1.
        N30 M30
    """,
    time=6,
)
case(
    "HNC: under G22 a rotary axis counts pulses, and F pulses a minute",
    control=HNC, source="source 003, G20 G21 G22, G94",
    program="""
        %1
        G22
        N10 G91 G1 A1000 F2000
        N20 X1000
        N30 M30
    """,
    moves="F A1\nF X1 A1", time=60,
)
case(
    "HNC: under G22 G92 and G52 of a rotary axis count pulses",
    control=HNC, source="source 003, G20 G21 G22",
    program="""
        %1
        G22
        N10 G92 A2000
        N20 G52 A1000
        N30 G90 G0 A500
        N40 M30
    """,
    moves="R A0.5",
)
case(
    "HNC: under G21 a rotary axis counts degrees",
    control=HNC, source="source 003, G20 G21 G22",
    program="""
        %1
        G21
        N10 G91 G1 A1 F2
        N20 M30
    """,
    moves="F A1", time=30,
)
case(
    "offsets and positions of a rotary axis are degrees under inch",
    control=[*MITSUBISHI, *FANUC], source="B-63172EN p.51: no switching on rotation axes; general knowledge",
    evidence="inferred",
    program="""
        O1
        G20
        N10 G90 G10 L2 P1 A10.
        N20 G54 G0 A20.
        N30 #100=#5004
        N40 #101=#5024
        N50 #102=#5224
        N60 #5224=5.
        N70 G52 A1.
        N80 G0 A0
        N90 #103=#5024
        N99 M30
    """,
    vars={100: 20, 101: 30, 102: 10, 103: 6},
)

# ---- a feed that was never given ----
_NUMBERS = {
    **dict.fromkeys(GSK_988, "021"), TDI: None, TE: None, HNC: None, MDI: "0023",
    **dict.fromkeys(MITSUBISHI, "P62"), F16: "011", **dict.fromkeys(FANUC_PS, "PS0011"),
}
NO_F = {
    "source": "ALM 011; M7 p.52; Talm 021; MDib 0023; TDi 26: F0 stands still; general knowledge",
    "evidence": "secondary",
}


def never_given(claim, program, control, alarm="no-feed", numbers=_NUMBERS, **more):
    case(claim, pins="power_on_feed", control=control, alarm=alarm, number={c: numbers[c] for c in control},
         program=program, **{**NO_F, **more})


_WITHOUT = [c for c in ALL if c != TA]

never_given(
    "a line without any F alarms",
    """
        O1
        N10 G0 X1.
        N20 G1 X50.
        N30 M30
    """,
    _WITHOUT, runs="N10", at="O1 N20", word="G1",
)
never_given(
    "an arc without any F alarms",
    """
        O1
        N10 G0 X0
        N20 G3 X10. Y10. R10.
        N30 M30
    """,
    MILLS, runs="N10", at="O1 N20", word="G3",
)
never_given(
    "F0 is no feed",
    """
        O1
        N10 G0 X1.
        N15 F100.
        N16 F0
        N20 G1 X50.
        N30 M30
    """,
    ALL, runs="N10 N15 N16", at="O1 N20", word="G1",
)
never_given(
    "a drilling cycle without any F alarms",
    """
        O1
        N10 G0 X1.
        N20 G81 Z-5. R1.
        N30 M30
    """,
    MILLS, runs="N10", at="O1 N20", word="G81",
)
never_given(
    "a turning cycle without any F alarms",
    """
        O1
        N10 G0 X20. Z1.
        N20 G90 X10. Z-5.
        N30 M30
    """,
    [T, TDI], runs="N10", at="O1 N20", word="G90",
)
never_given(
    "roughing without any F alarms",
    """
        O1
        N10 G0 X40. Z5.
        N20 G71 U2. R1.
        N30 G71 P40 Q50 U0 W0
        N40 G0 X20.
        N50 G1 Z-10.
        N60 M30
    """,
    [T, TDI], runs="N10 N20", at="O1 N30", word="G71",
)
never_given(
    "in MDI a line without any F alarms as well",
    None, _WITHOUT, mdi="G0 X1.\nG1 X50.", word="G1",
)
case(
    "a thread without any lead alarms as one without a lead",
    control=[*GSK_988, TDI], source="Talm 038; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M3 S500
        N20 G0 X20. Z1.
        N30 G32 Z-5.
        N40 M30
    """,
    runs="N10 N20", alarm="thread-lead", number={**dict.fromkeys(GSK_988, "038"), TDI: None}, at="O1 N30",
    word="G32",
)
case(
    "F in the block of the cut itself is a feed",
    control=[*GSK_988, TDI, TE, *MILLS], source="general knowledge", evidence="inferred",
    program="""
        O1
        N10 G0 Z0
        N20 G1 Z5. F300.
        N30 M30
    """,
    runs="N10 N20 N30", setup={"machine": "mill"}, moves="R Z0\nF Z5", time=1,
)
case(
    "the feed of power-on is a feed, on the 980TDi parameter 030, on the 988TA 1411",
    control=TDI, source="TDi 26, TDipar 030", evidence="maker's manual", params={"030": 100},
    program="O1\nN10 G98 G1 Z-10.\nN20 M30",
    moves="F Z-10", time=6,
)
case(
    "a rapid needs no feed",
    control=ALL, source="general knowledge", evidence="inferred",
    program="O1\nN10 G0 Z-10.\nN20 M30",
    moves="R Z-10", runs="N10 N20",
)

# ---- a spindle that stands ----
case(
    "a cut whose feed counts on a spindle without a speed takes a minute a revolution",
    control=FANUC, source="policy: every time is a number", evidence="inferred",
    program="""
        O1
        N10 G0 X0
        N20 G95 G1 X10. F0.2
        N30 M30
    """,
    moves="R X0\nF X10", time=3000,
)
case(
    "a thread of a spindle without a speed takes a minute a revolution",
    control=[TDI, *FANUC], source="policy: every time is a number", evidence="inferred",
    setup={"machine": "lathe-a"},
    program="""
        O1
        N10 G0 X10. Z0
        N20 G32 Z-10. F1.
        N30 M30
    """,
    time=600.03,
)
case(
    "with a speed it ends",
    control=FANUC, source="general knowledge", evidence="inferred",
    program="""
        O1
        N10 G0 X0
        N20 G95 G1 X10. F0.2 S1000 M3
        N30 M30
    """,
    time=3,
)
case(
    "a cut with a feed per revolution and no speed alarms where the control has an alarm for it",
    control=[MDI, *MITSUBISHI], source="MDib 0013; general knowledge", evidence="inferred",
    program="""
        O1
        N10 G0 X0
        N20 G95 G1 X10. F0.2
        N30 M30
    """,
    runs="N10", alarm="no-spindle-speed", number={MDI: "0013", **dict.fromkeys(MITSUBISHI, "P132")}, at="O1 N20",
    word="G1",
)
case(
    "at the middle of a lathe constant surface speed without a limit still takes time",
    control=FANUC, source="general knowledge", evidence="inferred", setup={"machine": "lathe-a"},
    program="""
        O1
        N10 G0 X0 Z0
        N20 G96 S100 M3
        N30 G50 S2000
        N40 G99 G1 Z-10. F0.1
        N50 M30
    """,
    time=3,
)
case(
    "tapping with S0 alarms on the 980MDi",
    control=MDI, source="MDib 0230", evidence="maker's manual",
    program="""
        O1
        N10 G0 Z5. S0
        N20 M29
        N30 G84 Z-5. R1. F100
        N40 M30
    """,
    runs="N10 N20", alarm="tap-without-speed", number="0230", at="O1 N30", word="G84",
)
case(
    "tapping with a speed runs on the 980MDi",
    control=MDI, source="MDib 0230", evidence="maker's manual",
    program="""
        O1
        N10 G0 Z5. S100
        N20 M29
        N30 G84 Z-5. R1. F100
        N40 M30
    """,
    runs="N10 N20 N30 N40", moves="R Z5\nR Z1\nF Z-5\nF Z1\nR Z5",
)

INVERSE = ["fanuc-16i", "fanuc-0i-f", "fanuc-30i", "mitsubishi-m700", "mitsubishi-m800"]

case(
    "F of G93 counts moves a minute in G20 too: X1.",
    control=INVERSE, source="general knowledge: G93 F is 1/min", evidence="inferred",
    program="O1\nN10 G20\nN20 G93 G1 X1. F2.\nN30 #100=#4109\nN40 M30",
    time=30, vars={100: 2},
)
case(
    "F of G93 counts moves a minute in G20 too: A90.",
    control=INVERSE, source="general knowledge: G93 F is 1/min", evidence="inferred",
    program="O1\nN10 G20\nN20 G93 G1 A90. F2.\nN30 #100=#4109\nN40 M30",
    time=30, vars={100: 2},
)
case(
    "F of G93 counts moves a minute in G20 too: X1. A90.",
    control=INVERSE, source="general knowledge: G93 F is 1/min", evidence="inferred",
    program="O1\nN10 G20\nN20 G93 G1 X1. A90. F2.\nN30 #100=#4109\nN40 M30",
    time=30, vars={100: 2},
)
case(
    "F of G93 counts moves a minute in G21 too: X1.",
    control=INVERSE, source="general knowledge: G93 F is 1/min", evidence="inferred",
    program="O1\nN10 G21\nN20 G93 G1 X1. F2.\nN30 #100=#4109\nN40 M30",
    time=30, vars={100: 2},
)
case(
    "F of G93 counts moves a minute in G21 too: A90.",
    control=INVERSE, source="general knowledge: G93 F is 1/min", evidence="inferred",
    program="O1\nN10 G21\nN20 G93 G1 A90. F2.\nN30 #100=#4109\nN40 M30",
    time=30, vars={100: 2},
)
case(
    "F of G93 counts moves a minute in G20 too: X1. Y1. Z3.",
    control=INVERSE, source="general knowledge: G93 F is 1/min", evidence="inferred",
    program="O1\nN10 G20\nN20 G93 G1 X1. Y1. Z3. F2.\nN30 #100=#4109\nN40 M30",
    time=30, vars={100: 2},
)
case(
    "an inverse time that was never given alarms in inches too", control=INVERSE,
    source="ALM 011; M7 p.52", evidence="inferred",
    program="O1\nN10 G20\nN20 G93 G1 X1.\nN30 M30", runs="N10", alarm="no-feed", at="O1 N20",
    number={c: "P62" if c[0] == "m" else "011" if c == "fanuc-16i" else "PS0011" for c in INVERSE},
    word="G1",
)
case(
    "F of G94 counts inches a minute", control=INVERSE,
    source="general knowledge: G94", evidence="inferred",
    program="O1\nN10 G20\nN20 G94 G1 X1. F2.\nN30 #100=#4109\nN40 M30", time=30, vars={100: 2},
)

case(
    "S beside G92 of a mill is the highest speed, and leaves the speed as it is",
    control=[*MILLS, "haas-ngc", "syntec-22ma"], source="the family's", evidence="inferred", pins="speed_limit",
    program="""
        O1
        N10 M3 S500
        N20 G92 X0. S1000
        N30 G95 G1 X10. F1.
        N40 M30
    """,
    moves="F X10", time=1.2,
)
case(
    "S beside G04 is the speed, as in any block",
    control=[*ALL, "haas-ngc", "syntec-22ma"], source="the family's", evidence="inferred", pins="dwell_turn_words",
    program="""
        O1
        N10 M3 S500
        N20 G04 S1000
        N30 M30
    """,
    runs="N10 N20 N30", time=0,
)
