"""Motion, rule by rule: drilling cycles."""

from conformance import case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI, TE = "gsk-980tdi", "gsk-980mdi", "gsk-928te"
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, F0D, F0F, F30 = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
FANUC_PS = FANUC[1:]
HNC = "hnc-21m"
HAAS = "haas-ngc"
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
    "K repeats a canned cycle",
    pins="cycle_repeats max_cycle_repeats", control=[MDI, *FANUC],
    source="MDib 0204; general knowledge", evidence="inferred", setup=MILL,
    program="O1\nN10 G91 G81 X5. Z-5. R0 F100. K2\nN20 M30",
    moves="R X5\nR Z0\nF Z-5\nR Z0\nR X10\nR Z0\nF Z-5\nR Z0",
)
case(
    "L repeats a canned cycle",
    pins="cycle_repeats max_cycle_repeats", control=[MDI, *MITSUBISHI, HNC, HAAS],
    source="MDib 0204; general knowledge", evidence="inferred", setup=MILL,
    program="O1\nN10 G91 G81 X5. Z-5. R0 F100. L2\nN20 M30",
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
case(
    "a canned cycle that begins below R goes over the hole before it goes to R",
    pins="cycle_approach", control=[MDI, *MITSUBISHI, *FANUC, HNC, HAAS], **KNOWN, setup=MILL,
    program="O1\nN10 G90 G98 G81 X5. Z-5. R2. F100.\nN20 M30",
    moves="R X5\nR Z2\nF Z-5\nR Z0",
)
case(
    "a tap is fed out to R, and goes on in rapid to where the cycle began",
    pins="tap_return", control=[MDI, *MITSUBISHI, *FANUC, HNC, HAAS], **KNOWN, setup=MILL,
    program="O1\nN10 G90 G0 Z5. S100 M3\nN20 G98 G84 Z-5. R2. F100.\nN30 M30",
    moves="R Z5\nR Z2\nF Z-5\nF Z2\nR Z5",
)
case(
    "K0 stores the data of a canned cycle and drills nothing",
    pins="zero_cycle_repeats", control=FANUC, **KNOWN, setup=MILL,
    program="O1\nN10 G90 G81 X5. Z-5. R1. F100. K0\nN20 X10.\nN30 M30",
    moves="R X10\nR Z1\nF Z-5\nR Z0",
)
case(
    "L0 stores the data of a canned cycle and drills nothing",
    pins="zero_cycle_repeats", control=[*MITSUBISHI, HNC, HAAS], **KNOWN, setup=MILL,
    program="O1\nN10 G90 G81 X5. Z-5. R1. F100. L0\nN20 X10.\nN30 M30",
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
    runs="N10", alarm="cycle-repeats", number="181", at="O1 N20", word="K0",
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
    runs="N10", alarm="cycle-repeats", number="0203", at="O1 N20", word="L0",
)
case(
    "G73 draws back by half a millimetre where no parameter says otherwise, whatever K is",
    pins="peck_words peck_retract drill_retract cycle_words_not_computed",
    control=[MDI, *MITSUBISHI, *FANUC, HAAS], **POLICY, setup=MILL,
    program="O1\nN10 G90 G73 Z-10. R0 Q4. K1 F10.\nN20 M30",
    time=66.066,
)
case(
    "G73 of the HNC without K draws back by half a millimetre",
    pins="peck_retract", control=HNC, **POLICY, setup=MILL,
    program="O1\nN10 G90 G73 Z-10. R0 Q-4. F10.\nN20 M30",
    time=66.066,
)
case(
    "G83 draws back by half a millimetre where no parameter says otherwise, whatever K is",
    pins="peck_words peck_clearance drill_retract",
    control=[MDI, *MITSUBISHI, *FANUC, HAAS], **POLICY, setup=MILL,
    program="O1\nN10 G90 G83 Z-10. R0 Q4. K1 F10.\nN20 M30",
    time=66.198,
)
case(
    "G83 of the HNC without K draws back by half a millimetre",
    pins="peck_clearance", control=HNC, **POLICY, setup=MILL,
    program="O1\nN10 G90 G83 Z-10. R0 Q-4. F10.\nN20 M30",
    time=66.198,
)
case(
    "a pecking cycle of a lathe with Q4 draws back by half a millimetre, whatever K is",
    pins="peck_words peck_retract drill_full_retract drill_retract", control=GSK_988,
    source="TA 24, 5101#2; TDi 23.9; the half millimetre: policy", evidence="inferred", setup=LATHE,
    program="O1\nN10 G98 G83 Z-10. Q4 K1 F10.\nN20 M30",
    moves="F Z-4\nR Z-3.5\nF Z-8\nR Z-7.5\nF Z-10\nR Z0", time=66.066,
)
case(
    "a pecking cycle of a lathe with Q4000 draws back by half a millimetre, whatever K is",
    pins="peck_words peck_retract drill_full_retract drill_retract", control=[*MITSUBISHI, *FANUC],
    source="TA 24, 5101#2; TDi 23.9; the half millimetre: policy", evidence="inferred", setup=LATHE,
    program="O1\nN10 G98 G83 Z-10. Q4000 K1 F10.\nN20 M30",
    moves="F Z-4\nR Z-3.5\nF Z-8\nR Z-7.5\nF Z-10\nR Z0", time=66.066,
)

_peck = [MDI, *MITSUBISHI, *FANUC, HNC]

case(
    "a pecking cycle with Q below zero pecks as without the sign",
    pins="refuses:peck-negative",
    control=[*_peck, "haas-ngc", "syntec-22ma"], source="general knowledge", evidence="inferred",
    setup={**MILL, "work_offsets": {"G54": {"Z": -40.25}}},
    program="O1\nN10 G0 Z1.\nN20 G90 G83 X5. Z-10. R0 Q-4. F100.\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "a pecking cycle without Q alarms",
    pins="refuses:no-peck",
    control=[*_peck, "haas-ngc"], source="ALM 045; general knowledge", evidence="inferred", setup=MILL,
    program="""
        O1
        N10 G0 Z1.
        N20 G90 G83 X5. Z-10. R0 F100.
        N30 M30
    """,
    runs="N10", alarm="no-peck", number={**numbers(_peck, "045"), "haas-ngc": None}, at="O1 N20", word="G83",
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
case(
    "a rotary axis goes to its place with the others of a canned cycle",
    pins="refuses:rotary-axis-in-cycle", control=[*MITSUBISHI, *FANUC], **KNOWN, setup=MILL,
    program="O1\nN10 G90 G81 X5. A90. Z-5. R2. F100.\nN20 G80\nN30 M30",
    runs="N10 N20 N30", final_work="X5 Z0 A90",
)
for _words, _moves, _but in (
    ("G28 Z5.", "R Z5\nR Z0\n", ""), ("G53 Z5.", "R Z5\n", MDI), ("G4 X1.", "W 1\n", HAAS), ("G52 X0", "", ""), ("G92 Z2.", "", ""),
):
    case(
        f"G80 beside {_words.split()[0]} ends a drilling cycle, and the next block drills nothing",
        control=[of for of in (MDI, *MITSUBISHI, *FANUC, HNC, HAAS, "syntec-22ma") if of != _but], **KNOWN, setup=MILL,
        program=f"O1\nN10 G90 G0 X1. Z2.\nN20 G81 X2. Z-5. R1. F100.\nN30 G80 {_words}\nN40 X5.\nN50 M30",
        moves=f"R X1 Z2\nR X2\nR Z1\nF Z-5\nR Z2\n{_moves}R X5",
    )
