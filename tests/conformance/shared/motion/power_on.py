"""Motion, rule by rule: power-on."""

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
    "without G98 and G99 a drilling cycle goes back to where it began",
    pins="power_on:G99",
    control=[*MILLS, HAAS, "syntec-22ma"], **KNOWN,
    program="""
        O1
        N10 G17 G90 G0 Z5.
        N20 G81 X1. Z-1. R2. F100.
        N30 G80
        N40 M30
    """,
    moves="R Z5\nR X1\nR Z2\nF Z-1\nR Z5",
)
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
case(
    "a control of a mill wakes up in G00",
    pins="power_on:G01", control=[MDI, *FANUC, HNC],
    source="TApar 3402#0; TDi 2; general knowledge", evidence="inferred", setup={"machine": "mill"},
    program="O1\nN10 X10. F100\nN20 M30",
    moves="R X10",
)
case(
    "a control of a lathe-a wakes up in G00",
    pins="power_on:G01", control=GSK_LATHES, source="TApar 3402#0; TDi 2; general knowledge",
    evidence="inferred", setup={"machine": "lathe-a"},
    program="O1\nN10 X10. F100\nN20 M30",
    moves="R X10",
)
case(
    "the control wakes up in G01",
    pins="power_on:G01",
    control=MITSUBISHI, source="M7 p.534 (11); general knowledge", evidence="inferred",
    setup=MILL,
    program="""
        O1
        N10 X10. F100
        N20 M30
    """,
    moves="F X10",
)
case(
    "a control of a mill wakes up in G17",
    pins="power_on:G18 power_on:G19", control=[*MILLS, HAAS, "syntec-22ma"],
    source="source 003; general knowledge", evidence="inferred", setup={"machine": "mill"},
    program="O1\nN10 G2 X10. Y0 I5. J0 F100\nN20 M30",
    moves="CW X10 Y0 C X5 Y0",
)
case(
    "with 3402#1 it wakes up in G18",
    control=FANUC, **KNOWN, setup={"machine": "mill"}, params={"3402#1": 1},
    program="O1\nN10 G2 X10. Z0 I5. K0 F100\nN20 #100=#4002\nN30 M30",
    moves="CW X10 Z0 C X5 Z0", vars={100: 18},
)
case(
    "with 3402#2 it wakes up in G19, whatever 3402#1 says",
    control=FANUC, **KNOWN, setup={"machine": "mill"}, params={"3402#1": 1, "3402#2": 1},
    program="O1\nN10 #100=#4002\nN20 M30", vars={100: 19},
)
case(
    "3402#1 and 3402#2 are of mills: a lathe wakes up in G18",
    control=FANUC, **KNOWN, setup=LATHE, params={"3402#2": 1},
    program="O1\nN10 G98 G2 X10. Z-5. R5. F100\nN20 #100=#4002\nN30 M30", moves="CW X10 Z-5 C X10 Z0",
)
case(
    "a control of a mill wakes up in G90",
    control=MILLS, source="TApar 3402#3; general knowledge", evidence="inferred",
    setup={"machine": "mill", "start": {"X": 5}},
    program="O1\nN10 G0 X10.\nN20 M30",
    moves_x=[10],
)
case(
    "a control of a lathe-b wakes up in G90",
    control=[*MITSUBISHI, *FANUC], source="TApar 3402#3; general knowledge", evidence="inferred",
    setup={"machine": "lathe-b", "start": {"X": 5}},
    program="O1\nN10 G0 X10.\nN20 M30",
    moves_x=[10],
)
case(
    "a lathe wakes up with feed per revolution",
    pins="power_on:G95",
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
    pins="power_on:G95",
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
    word="G1",
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
    runs="N10", alarm="no-feed", number="021", at="O1 N20", word="G1",
)
case(
    "an axis of a mill without a rate of its own goes 10000 mm in a minute",
    pins="max_digits rapid_rate", control=[*MILLS, HAAS], **POLICY, setup={"machine": "mill"},
    program="O1\nN10 G0 Z-10000.\nN20 M30",
    moves="R Z-10000", time=60,
)
case(
    "an axis of a lathe-a without a rate of its own goes 10000 mm in a minute",
    pins="max_digits rapid_rate", control=GSK_LATHES, **POLICY, setup={"machine": "lathe-a"},
    program="O1\nN10 G0 Z-10000.\nN20 M30",
    moves="R Z-10000", time=60,
)
case(
    "the first axis of a program moves without a motion code",
    pins="refuses:no-motion-code",
    control=["gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi", "gsk-928te", "mitsubishi-meldas", "mitsubishi-m700",
             "mitsubishi-m800", "fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i", "haas-ngc", "syntec-22ma"],
    source="general knowledge", evidence="inferred",
    program="""
        O1
        N10 G4 X1.
        N20 X5. F100
        N30 M30
    """,
    final_work="X5",
)
