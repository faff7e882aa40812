"""Mazak: where its motion is not that of a Mitsubishi M700, and the alarms of motion."""

from conformance import case

MAZAK = "mazak-smooth"


def listed(number, evidence="secondary"):
    return {"control": MAZAK, "source": f"MZL {number}", "evidence": evidence}


def coded(place, evidence="secondary"):
    return {"control": MAZAK, "source": f"MZG, {place}", "evidence": evidence}


case(
    "G01 is in force at power-on", **listed("816"),
    pins="power_on:G01",
    program="O1\nN10 G54 X1. F100\nN20 M30", moves="F X1",
)
case(
    "a cutting move before any F", **listed("816"),
    program="O1\nN10 G1 X1.\nN20 M30",
    runs="", alarm="no-feed", number="816", at="O1 N10", word="G1",
)
case(
    "an arc whose end is not on its circle", **listed("817"),
    program="O1\nN10 G0 X0 Y0\nN20 G2 X10. Y0 I3. J0 F100\nN30 M30",
    runs="N10", alarm="radius-tolerance", number="817", at="O1 N20", word="X10.",
)
case(
    "an arc whose radius is too small", **listed("818"),
    program="O1\nN10 G0 X0 Y0\nN20 G2 X10. Y0 R4. F100\nN30 M30",
    runs="N10", alarm="radius-too-small", number="818", at="O1 N20", word="R4.",
)
case(
    "F0 of an arc on a Mazak", **listed("827"),
    program="O1\nN10 G0 X0 Y0\nN20 G2 X10. R5. F0\nN30 M30",
    runs="N10", alarm="arc-feed-zero", number="827", at="O1 N20", word="F0",
)
case(
    "a block after a chamfer that is shorter on a Mazak", **listed("914"),
    program="O1\nN10 G0 X0 Y0\nN20 G1 X10. ,C5. F100\nN30 Y1.\nN40 M30",
    runs="N10 N20", alarm="corner-next-short", number="914", at="O1 N30", word="Y1.",
)
case(
    "a plane change in a rotation", **listed("824"),
    program="O1\nN10 G68 X0 Y0 R30.\nN20 G18\nN30 M30",
    runs="N10", alarm="rotation-plane", number="824", at="O1 N20", word="G18",
)
case(
    "a rotation of more than 360 degrees", **coded("G68: -360 to 360", "inferred"),
    pins="max_rotation",
    program="O1\nN10 G68 X0 Y0 R361.\nN20 M30",
    runs="", alarm="rotation-out-of-range", number="809", at="O1 N10", word="R361.",
)
case(
    "G54.1 P300 is a work system", **coded("G54.1 P1 to P300"),
    pins="max_extra_systems",
    program="O1\nN10 G10 L20 P300 X5. Y0 Z0\nN20 G54.1 P300\nN30 G0 X1.\nN40 M30", moves="R X1",
)
case(
    "G54.1 P301 is none", **coded("G54.1, note: 809"),
    pins="max_extra_systems",
    program="O1\nN10 G54.1 P301\nN20 M30",
    runs="", alarm="work-system", number="809", at="O1 N10", word="P301",
)
case(
    "a P of G10 L2 that is no system counts as P1", **coded("G10 L2"),
    pins="other_system",
    program="O1\nN10 G10 L2 P9 X7.\nN20 #500=#5221\nN30 M30", vars={500: 7},
)
case(
    "G52 while G54.1 is in force", **listed("949"),
    program="O1\nN10 G54.1 P1\nN20 G52 X5.\nN30 M30",
    runs="N10", alarm="local-in-extra-system", number="949", at="O1 N20", word="G52",
)
case(
    "G04 X counts thousandths of a second, P too", **coded("G04"),
    pins="dwell_words dwell_unit",
    program="O1\nN10 G4 X1500\nN20 G4 P500\nN30 M30", time=2,
)
case(
    "U is no time of G04", **coded("G04: X or P"),
    pins="dwell_words",
    program="O1\nN10 G4 U1500\nN20 M30", time=0,
)
case(
    "a point at P of G04 alarms", **coded("G04"),
    pins="dwell_point",
    program="O1\nN10 G4 P1.5\nN20 M30",
    runs="", alarm="illegal-decimal-point", number="807", at="O1 N10", word="P1.5",
)
for code in ("G84", "G74"):
    case(
        f"F of {code} is the pitch, in G94 too", **coded("G74, G84"),
        pins="tap_feed" if code == "G84" else "",
        program=f"O1\nN10 G94 G0 X0 Y0 Z20.\nN20 S600 M3\nN30 {code} X1. Z-10. R5. F1.25\nN40 G80\nN50 M30",
        moves="R X0 Y0 Z20\nR X1\nR Z5\nF Z-10\nF Z5\nR Z20", time=2.706,
    )
for letter in "BDEHIJK":
    case(
        f"{letter} of a canned cycle changes its moves, which is not computed", **coded("chapter 13-1"),
        pins="cycle_words_not_computed",
        program=f"O1\nN10 G0 X0 Y0 Z20.\nN20 G81 X1. Z-10. R5. F100 {letter}2\nN30 M30",
        runs="N10", alarm="code-not-computed", number=None, at="O1 N20", word=f"{letter}2",
    )
case(
    "L repeats a canned cycle, and the words of others drill", control=MAZAK, source="general knowledge: as on a Mitsubishi", evidence="inferred",
    program="O1\nN10 G0 X0 Y0 Z20.\nN20 G91 G99 G81 X1. Z-10. R-5. F100 L2\nN30 G80\nN40 M30",
    moves="R X0 Y0 Z20\nR X1\nR Z15\nF Z5\nR Z15\nR X2\nR Z15\nF Z5\nR Z15",
)
case(
    "a pecking cycle with Q0", **coded("G73, G83: 809"),
    pins="refuses:no-peck",
    program="O1\nN10 G0 X0 Y0 Z20.\nN20 G83 X1. Z-10. R5. Q0 F100\nN30 M30",
    runs="N10", alarm="no-peck", number="809", at="O1 N20", word="Q0",
)
case(
    "a tap without S", **listed("906"),
    pins="refuses:tap-without-speed",
    program="O1\nN10 G0 X0 Y0 Z20.\nN20 G84 X1. Z-10. R5. F1.25\nN30 M30",
    runs="N10", alarm="tap-without-speed", number="906", at="O1 N20", word="G84",
)
case(
    "a tap without a pitch", **listed("908"),
    program="O1\nN10 G0 X0 Y0 Z20.\nN20 S600 M3\nN30 G84 X1. Z-10. R5.\nN40 M30",
    runs="N10 N20", alarm="tap-without-lead", number="908", at="O1 N30", word="G84",
)
case(
    "a canned cycle in radius compensation", **listed("901"),
    program="O1\nN10 G0 X0 Y0 Z20.\nN20 G41 D1 X5. F100\nN30 G81 X9. Z-10. R5.\nN40 M30",
    setup={"radius_offsets": {1: 2}}, runs="N10 N20", alarm="cycle-in-offset", number="901", at="O1 N30", word="G81",
)
case(
    "G31 without F in its block", **listed("922"),
    pins="skip_own_feed",
    program="O1\nN10 F200\nN20 G31 X5.\nN30 M30",
    runs="N10", alarm="no-skip-feed", number="922", at="O1 N20", word="G31",
)
for codes in (
    "1.1 2.1 3.1 6.1 6.2 7 7.1 10.1 10.9 12.1 16 32 34 34.1 35 36 37 37.1 38 39 41.2 41.5 42.2 42.5 43.1 43.4 43.5 43.8 43.9",
    "53.1 54.2 54.4 61.2 68.2 68.3 68.4 71.1 72.1 75 77 78 79 82.2 84.2 84.3 92.5 109 110 111 112 113 114.3 130 136 137 140 148 149",
    "270 271 272 273 274 275 276 283 284 284.2 285 287 288 288.2 289 290 292 294",
):
    for code in codes.split():
        case(
            f"G{code} is a code of it, and not computed", **coded("pp. 3-11 to 3-14"),
            pins="g_codes" if code == "140" else "g_meanings" if code in ("16", "113") else "",
            program=f"O1\nN10 G{code}\nN20 M30",
            runs="", alarm="code-not-computed", number=None, at="O1 N10", word=f"G{code}",
        )
