"""Blocks that the printed lists of alarms refuse beyond the common conflicts, and similar blocks
that run.
"""

from conformance import case, inert

MDI, TDI = "gsk-980mdi", "gsk-980tdi"
T, TA = "gsk-988t", "gsk-988ta"
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, *FANUC_PS = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MM = {"whole_numbers": "millimetres"}
MILL = {"machine": "mill"}
RADIUS = MILL | {"radius_offsets": {1: 3}}
LATHE = {"machine": "lathe-a", "start": {"X": 40, "Z": 2}}


def on_fanuc(number):
    return {F16: number, **dict.fromkeys(FANUC_PS, f"PS0{number}")}


# F0 in an arc
case(
    "F0 in the block of an arc is an alarm of its own",
    control=[*FANUC, *MITSUBISHI], source="ALM 025; MZ, paired with P121", evidence="secondary",
    setup=MILL, pins="refuses:arc-feed-zero",
    program="O1\nN10 G1 X10. F100\nN20 G2 X20. R5. F0\nN30 M30",
    runs="N10", alarm="arc-feed-zero", at="O1 N20", word="F0",
    number=on_fanuc("025") | dict.fromkeys(MITSUBISHI, "P121"),
)
case(
    "F0 in the block of a line is a missing feed",
    control=[*FANUC, *MITSUBISHI], source="ALM 011; M7 p.52", evidence="secondary", setup=MILL,
    program="O1\nN10 G1 X10. F100\nN20 X20. F0\nN30 M30",
    runs="N10", alarm="no-feed", at="O1 N20", word="F0",
    number=on_fanuc("011") | dict.fromkeys(MITSUBISHI, "P62"),
)
case(
    "an arc before any F is a missing feed",
    control=[*FANUC, *MITSUBISHI], source="ALM 011; M7 p.52", evidence="secondary", setup=MILL,
    program="O1\nN10 G2 X10. R5.\nN20 M30",
    runs="", alarm="no-feed", at="O1 N10", word="G2",
    number=on_fanuc("011") | dict.fromkeys(MITSUBISHI, "P62"),
)

# The move after a corner
for _corner in (",C2.", ",R2."):  # the same claim for a chamfer and a round
    case(
        f"a move shorter than the {_corner} before it has a number of its own on a Mitsubishi",
        control=MITSUBISHI, source="MZ 914, paired with P384", evidence="secondary", setup=MILL,
        pins="refuses:corner-next-short",
        program=f"O1\nN10 G1 X10. {_corner} F100\nN20 Y1.\nN30 M30",
        runs="N10", alarm="corner-next-short", number="P384", at="O1 N20", word="Y1.",
    )
    case(
        f"a move shorter than its own {_corner} keeps its number on a Mitsubishi",
        control=MITSUBISHI, source="MZ 913, paired with P383", evidence="secondary", setup=MILL,
        program=f"O1\nN10 G1 X1. {_corner} F100\nN20 Y10.\nN30 M30",
        runs="N10", alarm="corner-too-short", number="P383", at="O1 N10", word=_corner,
    )
case(
    "G43 after a chamfer is refused on the 980MDi",
    control=MDI, source="MDib 0031", evidence="maker's manual", setup=MILL,
    pins="refuses:corner-with-codes",
    program="O1\nN10 G1 X10 L2 F100\nN20 G43 H1 Y10\nN30 M30",
    runs="N10", alarm="corner-with-codes", number="0031", at="O1 N20", word="G43",
)
case(
    "G55 after a chamfer is refused on the 980MDi",
    control=MDI, source="MDib 0031", evidence="maker's manual", setup=MILL,
    program="O1\nN10 G1 X10 L2 F100\nN20 G55 Y10\nN30 M30",
    runs="N10", alarm="corner-with-codes", number="0031", at="O1 N20", word="G55",
)
case(
    "G43 after the move that ends a chamfer is taken on the 980MDi",
    control=MDI, source="MDib 0031", evidence="maker's manual", setup=MILL,
    program="O1\nN10 G1 X10 L2 F100\nN20 Y10\nN30 G43 H1 Z0\nN40 M30",
    runs="N10 N20 N30 N40",
)

# The places where compensation begins and ends
case(
    "G41 without a move in its block is refused on the 980MDi",
    control=MDI, source="MDib 0033", evidence="maker's manual", setup=RADIUS,
    pins="refuses:offset-without-move",
    program="O1\nN10 G1 F100\nN20 G41 D1\nN30 X10\nN40 M30",
    runs="N10", alarm="offset-without-move", number="0033", at="O1 N20", word="G41",
)
case(
    "G42 after G41 without a move in its block is refused on the 980MDi",
    control=MDI, source="MDib 0033", evidence="maker's manual", setup=RADIUS,
    program="O1\nN10 G41 G1 X10 D1 F100\nN20 X30\nN30 G42\nN40 X50\nN50 M30",
    runs="N10 N20", alarm="offset-without-move", number="0033", at="O1 N30", word="G42",
)
case(
    "G41 once more without a move changes nothing on the 980MDi",
    control=MDI, source="MDib 0033: begins or changes", evidence="maker's manual", setup=RADIUS,
    program="O1\nN10 G41 G1 X10 D1 F100\nN20 X30\nN30 G41\nN40 X50\nN50 G40 Y20\nN60 M30",
    runs="N10 N20 N30 N40 N50 N60",
)
case(
    "G40 without a motion code while G02 is in force is refused on the 980MDi",
    control=MDI, source="MDib 0264", evidence="maker's manual", setup=RADIUS,
    pins="refuses:offset-end-in-arc-mode",
    program="O1\nN10 G41 G1 X10 D1 F100\nN20 X20\nN30 G3 X30 Y10 R10\nN40 G40\nN50 M30",
    runs="N10 N20 N30", alarm="offset-end-in-arc-mode", number="0264", at="O1 N40", word="G40",
)
case(
    "G40 in the block of G01 ends compensation after an arc on the 980MDi",
    control=MDI, source="MDib 0264", evidence="maker's manual", setup=RADIUS,
    program="O1\nN10 G41 G1 X10 D1 F100\nN20 X20\nN30 G3 X30 Y10 R10\nN40 G40 G1 Y30\nN50 M30",
    runs="N10 N20 N30 N40 N50",
)

# Rigid tapping
case(
    "M29 in the block of G84 is refused on the 980MDi",
    control=MDI, source="MDib 0235", evidence="maker's manual", setup=MILL,
    pins="refuses:rigid-tap-code-in-cycle",
    program="O1\nN10 G0 Z10\nN20 M29 S500 G84 X10 Z-5 R2 F500\nN30 M30",
    runs="N10", alarm="rigid-tap-code-in-cycle", number="0235", at="O1 N20", word="M29",
)
case(
    "M29 in the block of G84 is taken on a FANUC",
    control=FANUC, source="no alarm is known", evidence="inferred", setup=MILL,
    program="O1\nN10 G0 Z10.\nN20 M29 S500 G84 X10. Z-5. R2. F500\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "rigid tapping without S is refused on the 988T",
    control=[T, TA], source="Talm 180", evidence="secondary", setup=LATHE,
    pins="refuses:rigid-tap-without-speed",
    program="O1\nN10 G98 M29\nN20 G84 Z-10 R-1 F100\nN30 M30",
    runs="N10", alarm="rigid-tap-without-speed", number="180", at="O1 N20", word="G84",
)
case(
    "tapping at spindle speed 0 is refused on the 988T",
    control=[T, TA], source="Talm 107", evidence="secondary", setup=LATHE,
    pins="refuses:tap-without-speed",
    program="O1\nN10 G98 S0 M3\nN20 G84 Z-10 R-1 F100\nN30 M30",
    runs="N10", alarm="tap-without-speed", number="107", at="O1 N20", word="G84",
)
case(
    "a move between M29 and its tapping cycle is refused on the 988T",
    control=[T, TA], source="Talm 184", evidence="secondary", setup=LATHE,
    pins="refuses:move-before-rigid-tap",
    program="O1\nN10 G98 M29 S500\nN20 G0 Z5\nN30 G84 Z-10 R-1 F100\nN40 M30",
    runs="N10", alarm="move-before-rigid-tap", number="184", at="O1 N20", word="Z5",
)
for _again in ("S600", "M29"):  # the same claim for both words of rigid tapping
    case(
        f"{_again} between M29 and its tapping cycle is refused on the 988T",
        control=[T, TA], source="Talm 188", evidence="secondary", setup=LATHE,
        pins="refuses:rigid-tap-word-twice",
        program=f"O1\nN10 G98 M29 S500\nN20 {_again}\nN30 G84 Z-10 R-1 F100\nN40 M30",
        runs="N10", alarm="rigid-tap-word-twice", number="188", at="O1 N20", word=_again,
    )
case(
    "tapping at constant surface speed is refused on the 988T",
    control=[T, TA], source="Talm 192", evidence="secondary", setup=LATHE,
    pins="refuses:tap-in-surface-speed",
    program="O1\nN10 G98 G96 S100 M3\nN20 G84 Z-10 R-1 F100\nN30 M30",
    runs="N10", alarm="tap-in-surface-speed", number="192", at="O1 N20", word="G84",
)
case(
    "drilling at constant surface speed is taken on the 988T",
    control=[T, TA], source="Talm 192: G84 and G88", evidence="secondary", setup=LATHE,
    program="O1\nN10 G98 G96 S100 M3\nN20 G83 Z-10 R-1 F100\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "tapping after M29 with S runs on the 988T",
    control=[T, TA], source="TA 25", evidence="secondary", setup=LATHE,
    program="O1\nN10 G98 M29 S500\nN20 G84 Z-10 R-1 F100\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "another drilling axis while a cycle is active is refused on the 988T",
    control=[T, TA], source="Talm 186", evidence="secondary", setup=LATHE,
    pins="refuses:cycle-axis-changed",
    program="O1\nN10 G98 G83 Z-10 R-1 F100\nN20 G87 X20\nN30 M30",
    runs="N10", alarm="cycle-axis-changed", number="186", at="O1 N20", word="G87",
)
case(
    "another drilling axis after G80 is taken on the 988T",
    control=[T, TA], source="Talm 186", evidence="secondary", setup=LATHE,
    program="O1\nN10 G98 G83 Z-10 R-1 F100\nN20 G80\nN30 G87 X20 R-1\nN40 M30",
    runs="N10 N20 N30 N40",
)

# The run-out of threads, and G11
for _code in ("G32 X40 Z-20 F2 K-1", "G92 X38 Z-20 F2 K-1", "G92 X38 Z-20 F2 J-1 K1"):
    case(  # the same claim for each word that may be negative
        f"a run-out below 0 is refused on the 988T: {_code}",
        control=[T, TA], source="Talm 037", evidence="secondary", setup=LATHE,
        pins="refuses:thread-run-out-sign",
        program=f"O1\nN10 M3 S100\nN20 {_code}\nN30 M30",
        runs="N10", alarm="thread-run-out-sign", number="037", at="O1 N20", word=_code.split(" F2 ")[1].split()[0],
    )
case(
    "J of G32 may be negative on the 988T: the other way out",
    control=[T, TA], source="Talm 037 names K alone; TA 14", evidence="secondary", setup=LATHE,
    program="O1\nN10 M3 S100\nN20 G32 X40 Z-20 F2 J-1 K1\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "a run-out of G92 that goes further than its start is refused on the 988T",
    control=T, source="Talm 040", evidence="maker's manual", setup=LATHE,
    pins="refuses:thread-run-out-across",
    program="O1\nN10 M3 S100\nN20 G92 X38 Z-20 F2 J2 K1\nN30 M30",
    runs="N10", alarm="thread-run-out-across", number="040", at="O1 N20", word="J2",
)
case(
    "a run-out of G92 up to its start is taken on the 988T",
    control=[T, TA], source="Talm 040", evidence="secondary", setup=LATHE,
    program="O1\nN10 M3 S100\nN20 G92 X38 Z-20 F2 J1 K1\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "G11 before any G10 is refused on the 988T",
    control=[T, TA], source="Talm 063", evidence="secondary", setup=LATHE,
    pins="refuses:g11-before-g10",
    program="O1\nN10 G0 X40\nN20 G11\nN30 M30",
    runs="N10", alarm="g11-before-g10", number="063", at="O1 N20", word="G11",
)

# Moves of a compensated contour that do not meet
case(
    "an offset arc that does not reach the offset line after it has a number of its own on the 980MDi",
    control=MDI, source="MDib 0262", evidence="maker's manual", replace=MM,
    setup=MILL | {"radius_offsets": {1: 5}},
    program="""
        O1
        N10 G42 G1 X-10. Y6. D1 F100
        N20 X4.
        N30 G2 X10. Y0. I0 J-6.
        N40 G1 X-20.
        N50 G40 Y-20.
        N60 M30
    """,
    alarm="no-offset-intersection", number="0262", at="O1 N40", word="X-20.",
)

# Blocks that the lists of the other controls do not refuse: there they run, or alarm for another
# fault.
T_TA, HAAS, HNC, TE, SYNTEC = [T, TA], "haas-ngc", "hnc-21m", "gsk-928te", "syntec-22ma"
LIKE_FANUC = [*FANUC, *MITSUBISHI, SYNTEC]


def taken(claim, control, first, second, cause, setup=MILL, source="no alarm is known", **stops):
    """Write a row: a block that other lists refuse runs, or `stops` says why else it alarms."""
    case(
        claim, control=control, source=source, evidence="inferred", setup=setup,
        pins=f"refuses:{cause}",
        program=f"O1\nN10 {first}\nN20 {second}\nN30 M30",
        **(numbered(control, stops) if stops else {"runs": "N10 N20 N30"}),
    )


def numbered(control, stops):
    """Return `stops` with a number for each control, None where it is not known."""
    names = [control] if isinstance(control, str) else control
    number = stops.get("number")
    known = number if isinstance(number, dict) else dict.fromkeys(names, number)
    return stops | {"number": {name: known.get(name) for name in names}}


taken(
    "F0 in an arc is a missing feed where no list tells it apart", [TE, MDI, TDI, *T_TA, HAAS, HNC, SYNTEC],
    "G1 X10. F100", "G2 X20. R5. F0", "arc-feed-zero",
    runs="N10", alarm="no-feed", number={T: "021", TA: "021", MDI: "0023"}, at="O1 N20", word="F0",
)
taken(
    "a move shorter than the corner before it is a corner that is too long where no list tells it apart",
    [*FANUC, TE, MDI, *T_TA, HAAS, HNC, SYNTEC], "G1 X10. ,C2. F100", "Y1.", "corner-next-short",
    runs="N10", alarm="corner-too-short",
    number=on_fanuc("055") | {T: "275", TA: "275", MDI: "0271"}, at="O1 N10", word=",C2.",
)
taken(
    "a move shorter than the chamfer before it is a chamfer that is too long on the 980TDi", TDI,
    "G98 G1 X20. L2. F100", "Z1.", "corner-next-short", LATHE,
    runs="N10", alarm="corner-too-short", at="O1 N10", word="L2.",
)
taken(
    "G55 after a chamfer is taken", [*LIKE_FANUC, HAAS, HNC], "G1 X10. ,C2. F100", "G55 Y10.",
    "corner-with-codes",
)
taken(
    "G55 after a chamfer is taken on the 980TDi", TDI, "G98 G1 X20. L2. F100", "G55 Z-10.",
    "corner-with-codes", LATHE,
)
taken(
    "G55 after a chamfer is taken on the 988s", T_TA, "G98 G1 X20. ,C2. F100", "G55 Z-10.",
    "corner-with-codes", LATHE,
)
case(
    "G40 ends compensation with the next line, whatever motion is in force",
    control=[*LIKE_FANUC, HAAS, HNC], source="no alarm is known", evidence="inferred", setup=RADIUS,
    pins="refuses:offset-end-in-arc-mode",
    program="O1\nN10 G41 G1 X10. D1 F100\nN20 X20.\nN30 G3 X30. Y10. R10.\nN40 G40\nN50 G1 Y30.\nN60 M30",
    runs="N10 N20 N30 N40 N50 N60",
)
case(
    "G40 ends compensation with the next line on a lathe, whatever motion is in force",
    control=[TDI, *T_TA], source="no alarm is known", evidence="inferred", setup=LATHE,
    pins="refuses:offset-end-in-arc-mode",
    program="O1\nN10 G98 G42 G1 X30. Z0. F100\nN20 Z-10.\nN30 G2 X40. Z-15. R5.\nN40 G40\nN50 G1 X60.\nN60 M30",
    runs="N10 N20 N30 N40 N50 N60",
)
taken(
    "G41 may stand without a move", [*LIKE_FANUC, HAAS, HNC, TDI, *T_TA], "G1 F100", "G41 D1",
    "offset-without-move", RADIUS,
)
taken(
    "M29 may stand in the block of its tapping cycle", [*LIKE_FANUC, HNC, TDI, *T_TA],
    "G0 Z10.", "M29 S500 G84 X10. Z-5. R2. F500", "rigid-tap-code-in-cycle",
)
taken(
    "S may stand between M29 and its tapping cycle", [*FANUC, MDI], "M29 S500", "S600",
    "rigid-tap-word-twice",
)
taken(
    "a move may stand after M29", [TE, TDI, HNC, *MITSUBISHI, SYNTEC], "M29 S500", "G0 X20.",
    "move-before-rigid-tap",
)
taken(
    "tapping may begin without a spindle speed", [*FANUC, TDI, HAAS, HNC], "G0 Z10.",
    "G84 X10. Z-5. R2. F500", "tap-without-speed",
)
taken(
    "rigid tapping without S is tapping without S on the 980MDi", MDI, "M29", "G84 X10 Z-5 R2 F500",
    "rigid-tap-without-speed",
    runs="N10", alarm="tap-without-speed", number="0230", at="O1 N20", word="G84",
)
taken(
    "tapping at constant surface speed is taken", [*FANUC, TDI], "G96 S100 M3", "G84 X10. Z-5. R2. F500",
    "tap-in-surface-speed",
)
taken(
    "tapping at constant surface speed lacks the speed where that is refused", [MDI, *MITSUBISHI, SYNTEC],
    "G96 S100 M3", "G84 X10. Z-5. R2. F500", "tap-in-surface-speed",
    runs="N10", alarm="tap-without-speed", number={MDI: "0230"} | dict.fromkeys(MITSUBISHI, "P181"),
    at="O1 N20", word="G84",
)
taken(
    "a plane may be selected while a cycle is active", [*LIKE_FANUC, MDI, HAAS, HNC],
    "G81 X10. Z-5. R2. F500", "G18", "cycle-axis-changed",
)
taken(
    "the drilling axis may change while a cycle is active on the 980TDi", TDI,
    "G98 G83 Z-10. R-1. F100", "G87 X20. R-1. F100", "cycle-axis-changed", LATHE,
)
taken(
    "G11 without G10 is taken", [*LIKE_FANUC, TDI], "G0 X0", "G11", "g11-before-g10",
)
taken(
    "a run-out of G92 that goes further than its start goes to the start", TDI, "M3 S100",
    "G92 X38. Z-20. F2. J2. K1.", "thread-run-out-across", LATHE, source="TDi 24.9",
)
taken(
    "the sign of a run-out does not count on the 980TDi", TDI, "M3 S100", "G32 X40. Z-20. F2. K-1.",
    "thread-run-out-sign", LATHE, source="TDi 24.9",
)

NO_WAIT = "M29 is nothing to the blocks after it where a move there is not refused"
NO_RUN_OUT = "J and K are no run-out of its threads"
for _control in (TE, TDI, HNC, *MITSUBISHI, SYNTEC):
    inert("refuses:rigid-tap-word-twice refuses:rigid-tap-without-speed", control=_control, reason=NO_WAIT)
for _control in (*FANUC, *MITSUBISHI, SYNTEC, MDI, HAAS, HNC, TE):
    inert("refuses:thread-run-out-across refuses:thread-run-out-sign", control=_control, reason=NO_RUN_OUT)
for _control in (TE,):
    inert(
        "refuses:corner-with-codes refuses:cycle-axis-changed refuses:g11-before-g10 "
        "refuses:offset-end-in-arc-mode refuses:offset-without-move refuses:rigid-tap-code-in-cycle "
        "refuses:tap-in-surface-speed refuses:tap-without-speed",
        control=_control, reason="no source says which codes of the control this is about",
    )
inert(
    "refuses:rigid-tap-word-twice refuses:rigid-tap-without-speed refuses:move-before-rigid-tap "
    "refuses:rigid-tap-code-in-cycle",
    control=HAAS, reason="its M29 turns on a relay",
)
for _control in (HAAS, HNC):
    inert("refuses:tap-in-surface-speed", control=_control, reason="the control has no G96")
    inert("refuses:g11-before-g10", control=_control, reason="its G10 is none that G11 ends")
