"""Codes of a control that change its path in a way that is not computed: they alarm rather than
move wrongly. Codes that no path depends on let the block go on.
"""

from conformance import case

F16, F0D, F0F, F30 = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
POLICY = {"source": "policy: no wrong move without a word", "evidence": "inferred"}
KNOWN = {"source": "general knowledge", "evidence": "inferred"}
MILL, LATHE = {"machine": "mill"}, {"machine": "lathe-a"}


def block(words, mode="G91 ", axis="X"):
    return f"O1\nN10 {mode}G1 F100.\nN20 {words} {axis}10.\nN30 M30"


for _what, _controls, _codes in (
    ("involutes", [F16, F0F, F30], "G2.2"),
    ("NURBS", [F16, F30, *MITSUBISHI], "G6.2"),
    ("cylindrical interpolation", [*FANUC, *MITSUBISHI], "G7.1"),
    ("cylindrical interpolation by its older code", FANUC, "G107"),
    ("the corner arc of compensation", FANUC, "G39"),
    ("normal direction control", [*FANUC, *MITSUBISHI], "G41.1"),
    ("a tilted plane", [F0F, F30, *MITSUBISHI], "G68.2"),
    ("tool centre point control", [F30, *MITSUBISHI], "G43.4"),
    ("the floating reference point", FANUC, "G30.1"),
    ("the cutting of circles", MITSUBISHI, "G12"),
):
    case(
        f"{_what}: {_codes} is a code whose moves are not computed", control=_controls, **POLICY,
        setup=MILL, program=block(_codes), alarm="code-not-computed", at="O1 N20",
    )
for _what, _controls, _codes in (
    ("polar interpolation", [*FANUC, "gsk-988ta", "gsk-988t", "gsk-980tdi"], "G12.1"),
    ("mirroring of double turrets", [*FANUC, "gsk-988ta", "gsk-988t"], "G68"),
    ("rigid threads", ["gsk-988ta", "gsk-988t", "gsk-980tdi"], "G32.1"),
    ("ellipses and parabolas", ["gsk-980tdi"], "G6.2"),
    ("hobbing", ["gsk-988ta", "gsk-988t"], "G51.3"),
):
    case(
        f"{_what}: {_codes} is a code whose moves are not computed", control=_controls, **POLICY,
        setup=LATHE, program=block(_codes, "", "U"), alarm="code-not-computed", at="O1 N20",
    )
case(
    "the thread cycle G92.1 is not computed, in both G code systems",
    control=["gsk-988ta", "gsk-988t"], source="TA 19", evidence="maker's manual",
    setup={"machine": "lathe-b"}, program=block("G92.1"), alarm="code-not-computed", at="O1 N20",
)
case(
    "milling of pockets, G110 to G117, is not computed", control="gsk-980mdi", **POLICY,
    program=block("G110"), alarm="code-not-computed", at="O1 N20",
)
case(
    "a cycle of G code system B is not computed in system A", control=FANUC, **POLICY, setup=LATHE,
    program=block("G77", "", "U"), alarm="code-not-computed", at="O1 N20",
)
for _what, _controls, _codes, _setup in (
    ("look-ahead", [*FANUC, *MITSUBISHI], "G8 P1", MILL),
    ("high-speed machining", [*FANUC, *MITSUBISHI], "G5 P10000", MILL),
    ("the end of data setting", [*FANUC, *MITSUBISHI], "G11", MILL),
    ("the end of normal direction control", [*FANUC, *MITSUBISHI], "G40.1", MILL),
    ("the end of polar interpolation", [*FANUC, *MITSUBISHI], "G113", MILL),
    ("the end of polar interpolation on lathes", [*FANUC, "gsk-988ta", "gsk-980tdi"], "G13.1",
     LATHE),
):
    case(
        f"{_what}: {_codes} lets the move of its block be made", control=_controls, **KNOWN,
        setup=_setup,
        program=block(_codes, "" if _setup is LATHE else "G91 ", "U" if _setup is LATHE else "X"),
        moves="F X10",
    )
case(
    "the axis words of G5.1 Q1 name axes, they move none", control=FANUC, **KNOWN, setup=MILL,
    program=block("G5.1 Q1"), moves="none",
)
TDI5 = {"source": "TDi 5", "evidence": "maker's manual"}
AT = {"machine": "lathe-a", "start": {"X": 10, "Z": 20}}
for _code, _words in (("G05", "I5 K-5"), ("G05.1", "I20 K15")):
    case(
        f"{_code} is an arc through a third point", control="gsk-980tdi", **TDI5, setup=AT,
        program=f"O1\nN10 {_code} X10 Z10 {_words} F150\nN20 X10 Z20 {_words}\nN30 M30"
        if _code == "G05.1" else f"O1\nN10 {_code} X10 Z10 {_words} F150\nN30 M30",
        moves="CCW X10 Z10 C X10 Z15" + ("\nCW X10 Z20 C X10 Z15" if _code == "G05.1" else ""),
    )
for _what, _words in (
    ("three points on one line", "X10 Z10 I0 K-5"), ("no point in between", "X10 Z10"),
    ("a full circle", "X10 Z20 I5 K-5"),
):
    case(
        f"{_what}: no arc of G05", control="gsk-980tdi", **TDI5, setup=AT,
        program=f"O1\nN10 G05 {_words} F150\nN20 M30", alarm="three-points", at="O1 N10",
    )

# What a control's own list has is never refused with its number: it is run, or not computed here.

for _what, _controls, _codes, _setup in (
    ("the end of length offsets", FANUC, "G49", LATHE),
    ("the exact stop mode", FANUC, "G61", LATHE),
    ("the cutting mode", [*FANUC, "gsk-988ta", "gsk-988t"], "G64", LATHE),
    ("the end of polar coordinates", FANUC, "G15", LATHE),
    ("the check of the spindle's speed", FANUC, "G26", MILL),
    ("the end of that check", FANUC, "G25", MILL),
    ("the end of polar interpolation", MITSUBISHI, "G13.1", MILL),
):
    case(
        f"{_what}: {_codes} of the other kind of machine goes on", control=_controls,
        source="added.md: the modal groups of a 0i-TF Plus; general knowledge", evidence="inferred",
        setup=_setup,
        program=block(_codes, "" if _setup is LATHE else "G91 ", "U" if _setup is LATHE else "X"),
        moves="F X10",
    )
case(
    "G50.1 of a lathe ends no mirror, and moves nothing", control=FANUC,
    source="added.md: the modal groups of a 0i-TF Plus", evidence="inferred", setup=LATHE,
    program="O1\nN10 G98 G1 F100.\nN20 G50.1 X0\nN30 Z5.\nN40 M30", moves="F Z5",
)
for _what, _controls, _codes, _setup in (
    ("polar coordinates of a lathe", FANUC, "G16", LATHE),
    ("the mirror of a lathe", FANUC, "G51.1 X0", LATHE),
    ("polar interpolation of a mill", MITSUBISHI, "G12.1", MILL),
    ("the drilling cycle of the 980TDi", "gsk-980tdi", "G86", LATHE),
    ("the threads of the 980TDi", "gsk-980tdi", "G92.1", LATHE),
    ("G78 of a GSK lathe", ["gsk-980tdi", "gsk-988ta", "gsk-988t"], "G78", LATHE),
    ("the cycles of lathes on a mill", FANUC, "G71", MILL),
    ("polar coordinates of the 980MDi on a lathe", "gsk-980mdi", "G16", LATHE),
):
    case(
        f"{_what}: {_codes} is not computed, and alarms with no number", control=_controls,
        source="the control's list; policy: no wrong move without a word", evidence="inferred",
        setup=_setup, program=block(_codes, "" if _setup is LATHE else "G91 ", "Z"),
        alarm="code-not-computed", at="O1 N20",
    )
for _codes, _controls, _numbers in (
    ("G16", ["gsk-988ta", "gsk-980tdi"], {"gsk-988ta": "009", "gsk-980tdi": "0002"}),
    ("G86", ["gsk-988ta"], {"gsk-988ta": "009"}),
    ("G78.1", ["fanuc-16i", "fanuc-30i"], {"fanuc-16i": "010", "fanuc-30i": "PS0010"}),
    ("G77.3", MITSUBISHI, dict.fromkeys(MITSUBISHI, "P34")),
):
    case(
        f"{_codes}, which the control's list has not, is refused with its number", control=_controls,
        source="the control's list; Talm 009; ALM 010; SK P34", evidence="inferred", setup=LATHE,
        program=block(_codes, "", "Z"), alarm="g-code-not-available", number=_numbers, at="O1 N20",
    )

# The 928TE and the HNC-21M: of their codes a part is known.

for _codes in ("G22", "G26", "G27", "G29", "G33", "G80"):
    case(
        f"{_codes} of the 928TE is its own, and not computed", control="gsk-928te",
        pins="g_meanings",
        source="general knowledge: a loop, returns to points, a thread", evidence="inferred",
        setup=LATHE, program=block(_codes, "", "U"), alarm="code-not-computed", at="O1 N20",
    )
for _codes in ("G10", "G20", "G28", "G31", "G53", "G54", "G60", "G71", "G92", "G5.1", "G123"):
    case(
        f"nobody says whether the 928TE has {_codes}", control="gsk-928te", **POLICY, setup=LATHE,
        pins="g_codes_complete",
        program=block(_codes, "", "U"), alarm="code-not-known", at="O1 N20",
    )
for _codes in ("G65 P2 A1.", "G66 P2", "G67"):
    case(
        f"the 928TE has no macro calls: {_codes}", control="gsk-928te",
        source="general knowledge: no macro statements", evidence="inferred", setup=LATHE,
        program=f"N10 G0 X1\nN20 {_codes}\nN30 M30", runs="N10", alarm="g-code-not-available",
    )
for _codes in ("G0", "G1", "G2 R10", "G3 R10", "G4 D1", "G96 S100", "G97 S100", "G98", "G99"):
    case(
        f"the 928TE runs {_codes}", control="gsk-928te",
        pins="refuses",
        source="source 001; 928Ti; general knowledge", evidence="inferred", setup=LATHE,
        program=f"N10 G98 G1 F100\nN20 {_codes} X2 Z1\nN30 M30", runs="N10 N20 N30",
    )
for _codes in ("G7", "G11", "G12", "G34", "G65 P2"):
    case(
        f"{_codes} is a code of the HNC-21M that is not computed", control="hnc-21m", **KNOWN,
        pins="macro_calls",
        setup=MILL, program=block(_codes), alarm="code-not-computed", at="O1 N20",
    )
for _codes in ("G10", "G15", "G16", "G31", "G66", "G67", "G96"):
    case(
        f"the HNC-21M has no {_codes}", control="hnc-21m", **KNOWN, setup=MILL,
        program=block(_codes), alarm="g-code-not-available", at="O1 N20",
    )
for _codes in ("G8", "G30", "G33", "G36", "G51.1", "G54.1 P1", "G93", "G97", "G345"):
    case(
        f"nobody says whether the HNC-21M has {_codes}", control="hnc-21m", **POLICY, setup=MILL,
        pins="g_codes_complete",
        program=block(_codes), alarm="code-not-known", at="O1 N20",
    )
