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
    ("measuring of tools", FANUC, "G37"),
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
    ("measuring on lathes", [*FANUC, "gsk-988ta", "gsk-988t", "gsk-980tdi"], "G36"),
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
    "a cycle of G code system B is no code of system A", control=FANUC, **KNOWN, setup=LATHE,
    program=block("G77", "", "U"), alarm="g-code-not-available", at="O1 N20",
    number={F16: "010", F0D: "PS0010", F0F: "PS0010", F30: "PS0010"},
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
case(
    "G60 is no code of a lathe", control="gsk-928te", **KNOWN, setup=LATHE,
    program=block("G60", "", "U"), alarm="g-code-not-available", at="O1 N20",
)
