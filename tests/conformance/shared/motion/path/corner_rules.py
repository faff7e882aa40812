"""Motion, rule by rule: corners."""

from conformance import case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI, TE = "gsk-980tdi", "gsk-980mdi", "gsk-928te"
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, F0D, F0F, F30 = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
FANUC_PS = FANUC[1:]
HNC = "hnc-21m"
MILLS = [MDI, *MITSUBISHI, *FANUC, HNC]
MILL = {"machine": "mill"}
LATHE = {"machine": "lathe-a"}
KNOWN = {"source": "general knowledge", "evidence": "inferred"}


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
case(
    "a chamfer in a rapid alarms",
    control=[*MITSUBISHI, *FANUC], source="ALM; MZ 951, 919, paired; MDib", evidence="secondary",
    setup=MILL,
    program="O1\nN10 G1 X1. F100\nN20 G0 X10. ,C2.\nN30 G1 Y10.\nN40 M30",
    alarm="corner-in-rapid", number=numbers([*MITSUBISHI, *FANUC], "050", "P385", None, None), word=",C2.",
)
case(
    "a rapid after a chamfer alarms",
    control=[*FANUC, MDI], source="ALM; MZ 951, 919, paired; MDib", evidence="secondary",
    setup=MILL,
    program="O1\nN10 G1 X1. F100\nN20 G1 X10. ,C2.\nN30 G0 Y10.\nN40 M30",
    alarm="corner-next-move", number=numbers([*FANUC, MDI], "052", None, None, "0036"), word="G0",
)
case(
    "a plane change after a chamfer alarms",
    control=[*MITSUBISHI, *FANUC_PS, MDI], source="ALM; MZ 951, 919, paired; MDib",
    evidence="secondary", setup=MILL,
    program="O1\nN10 G1 X1. F100\nN20 G1 X10. ,C2.\nN30 G18 G1 Z10.\nN40 M30",
    alarm="corner-plane",
    number=numbers([*MITSUBISHI, *FANUC_PS, MDI], "306", "P396", None, "0031"), word="G18",
)
case(
    "a chamfer and a corner round in one block alarm",
    control=[*FANUC, MDI], source="ALM; MZ 951, 919, paired; MDib", evidence="secondary",
    setup=MILL,
    program="O1\nN10 G1 X1. F100\nN20 G1 X10. ,C2. ,R2.\nN30 G1 Y10.\nN40 M30",
    alarm="corner-format", number=numbers([*FANUC, MDI], "053", None, None, "0093"), word=",R2.",
)
case(
    "a chamfer and a corner round that are computed are brought to the least increment",
    control=FANUC, source="JIX, XIA: of all values at an address", evidence="secondary", setup=MILL,
    program="""
        O1
        N10 G1 X10. ,C[1/3] F100
        N20 Y10. ,R[2/3]
        N30 X0
        N40 M30
    """,
    moves="F X9.667\nF X10 Y0.333\nF Y9.333\nCCW X9.333 Y10 C X9.333 Y9.333\nF X0",
)
case(
    "C without a comma, too, and under inch to a tenth of it",
    control=FANUC, source="JIX, XIA: of all values at an address", evidence="secondary", setup=LATHE,
    program="O1\nN10 G20\nN20 G1 Z-1. C[1/30] F1.\nN30 X2.\nN40 M30",
    moves="F Z-24.55418\nF X1.69164 Z-25.4\nF X50.8",
)
