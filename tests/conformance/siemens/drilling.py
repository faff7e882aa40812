"""SINUMERIK: the drilling cycles, move by move."""

from conformance import case

ONE = "siemens-one"
CYCLE81 = {"control": ONE, "source": "HC81, format and depth", "evidence": "secondary"}
LIST = {"control": ONE, "source": "NXP, its parameters; the moves are general knowledge of the cycles", "evidence": "inferred"}
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK cycles", "evidence": "inferred"}
MODES = {"control": ONE, "source": "NCX, chapter 7: the parameters of the mode", "evidence": "secondary"}
SETUP = {"work_offsets": {"G54": {"X": 12.25, "Y": -3.5, "Z": 101.125}}}


def _hole(cycle: str, before: str = "", after: str = "") -> str:
    return f"N10 G0 X5 Y7 Z60\n{before}N20 {cycle}\n{after}N90 M30"


def _drill(claim: str, cycle: str, moves: str, before: str = "N15 G94 F100\n", **said: object) -> None:
    """Add a row of a cycle that is called at X5 Y7 Z60."""
    case(claim, program=_hole(cycle, before), setup=SETUP, moves=f"R X5 Y7 Z60\n{moves}", **said)


_drill(
    "CYCLE81 goes to before the reference plane, drills and comes back to the retraction plane", "CYCLE81(50,30,2,-10)",
    "R Z32\nF Z-10\nR Z50", **CYCLE81,
)
_drill(
    "a relative depth counts from the reference plane, its sign says nothing", "CYCLE81(50,30,2,,-25)",
    "R Z32\nF Z5\nR Z50", **CYCLE81,
)
_drill(
    "a relative depth wins over an absolute one, and the control says so", "CYCLE81(50,30,2,3,25)",
    "R Z32\nF Z5\nR Z50", messages=["depth: as the relative depth says"], **KNOWN,
)
_drill(
    "a depth given twice and alike says nothing", "CYCLE81(50,30,2,5,25)",
    "R Z32\nF Z5\nR Z50", messages=[], **KNOWN,
)
_drill("a safety distance has no sign", "CYCLE81(50,30,-2,-10)", "R Z32\nF Z-10\nR Z50", **CYCLE81)
_drill("values of a call are computed", "CYCLE81(R1,R1-20,R2/2,-R2)", "R Z32\nF Z-4\nR Z50", "N15 F100\nN16 R1=50\nN17 R2=4\n", **KNOWN)
_drill(
    "in G18 CYCLE81 drills along Y", "CYCLE81(50,30,2,-10)",
    "R Y32\nF Y-10\nR Y50", "N15 G18 F100\n", **KNOWN,
)
_drill(
    "in G19 CYCLE81 drills along X", "CYCLE81(50,30,2,-10)",
    "R X32\nF X-10\nR X50", "N15 G19 F100\n", **KNOWN,
)
_drill(
    "the units of DMODE name the plane", "CYCLE81(50,30,2,-10,0,0,0,3)",
    "R X32\nF X-10\nR X50", **MODES,
)
_drill(
    "CYCLE81 has a dwell on newer controls", "CYCLE81(50,30,2,-10,0,1.5)",
    "R Z32\nF Z-10\nW 1.5\nR Z50", **MODES,
)
_drill(
    "a mode of the geometry is not computed", "CYCLE81(50,30,2,-10,0,0,10)", "",
    alarm="code-not-computed", word="_GMODE_OF_CYCLE", **MODES,
)
_drill(
    "CYCLE82 dwells at the final depth", "CYCLE82(50,30,2,-10,0,0.75)",
    "R Z32\nF Z-10\nW 0.75\nR Z50", **LIST,
)
_drill(
    "where the tens of AMODE are 2 the dwell counts revolutions", "CYCLE82(50,30,2,-10,0,10,0,0,20)",
    "R Z32\nF Z-10\nW 1\nR Z50", "N15 F100 S600 M3\n", **MODES,
)
_drill(
    "a negative dwell counts revolutions", "CYCLE82(50,30,2,-10,0,-20)",
    "R Z32\nF Z-10\nW 2\nR Z50", "N15 F100 S600 M3\n", **KNOWN,
)
_drill(
    "drilling through of newer controls is not computed", "CYCLE82(50,30,2,-10,0,0.5,0,1,11,1)", "",
    alarm="code-not-computed", word="_VARI_OF_CYCLE82", **MODES,
)

# ---- the planes ----

_drill(
    "a relative depth needs a retraction plane away from the reference plane", "CYCLE81(30,30,2,0,10)", "",
    alarm="user-alarm", number="61101", **CYCLE81,
)
_drill(
    "an absolute depth does not", "CYCLE81(30,30,2,10)",
    "R Z32\nF Z10\nR Z30", **KNOWN,
)
for _call in ("CYCLE81(100,0,2,10)", "CYCLE82(100,0,2,10,,0.6)", "CYCLE81(-100,0,2,-10)"):
    _drill(
        f"a depth on the side of the retraction plane is 61101: {_call}", _call, "", alarm="user-alarm", number="61101", **KNOWN,
    )
_drill(
    "a retraction plane that is nearer to the depth than the reference plane is 61101", "CYCLE81(20,30,2,-10)", "",
    alarm="user-alarm", number="61101", **KNOWN,
)
_drill(
    "below the reference plane all directions turn", "CYCLE81(-50,-30,2,,25)",
    "R Z-32\nF Z-5\nR Z-50", **KNOWN,
)
_drill(
    "so they do for an absolute depth", "CYCLE81(-50,-30,2,10)",
    "R Z-32\nF Z10\nR Z-50", **KNOWN,
)

# ---- deep holes ----

_drill(
    "CYCLE83 breaks the chips: it comes back by 1 mm after each stroke", "CYCLE83(50,30,2,-10,,20,,4)",
    "R Z32\nF Z20\nF Z21\nF Z14\nF Z15\nF Z10\nF Z11\nF Z6\nF Z7\nF Z2\nF Z3\nF Z-2\nF Z-1\nF Z-6\nF Z-5\nF Z-10\nR Z50", **LIST,
)
_drill(
    "the last two strokes share what is left", "CYCLE83(50,30,2,-9,,20,,4)",
    "R Z32\nF Z20\nF Z21\nF Z14\nF Z15\nF Z10\nF Z11\nF Z6\nF Z7\nF Z2\nF Z3\nF Z-2\nF Z-1\nF Z-5.5\nF Z-4.5\nF Z-9\nR Z50", **KNOWN,
)
_drill(
    "VRT is how far it comes back", "CYCLE83(50,30,2,10,,20,,0,0,0,1,0,0,0,2.5)",
    "R Z32\nF Z20\nF Z22.5\nF Z10\nR Z50", **LIST,
)
_drill(
    "with VARI 1 it leaves the hole after each stroke, and dwells below and above", "CYCLE83(50,30,2,10,,22,,0,0.5,0.25,1,1)",
    "R Z32\nF Z22\nW 0.5\nR Z32\nW 0.25\nR Z22.6\nF Z14\nW 0.5\nR Z32\nW 0.25\nR Z14.6\nF Z10\nW 0.5\nR Z50", **LIST,
)
_drill(
    "above the place reached it stops a fiftieth of a hole that is deeper than 30 mm", "CYCLE83(50,30,2,-15,,,30,0,0,0,1,1)",
    "R Z32\nF Z0\nR Z32\nR Z0.9\nF Z-15\nR Z50", **KNOWN,
)
_drill(
    "at most 7 mm", "CYCLE83(50,30,2,-370,,,300,0,0,0,1,1)",
    "R Z32\nF Z-270\nR Z32\nR Z-263\nF Z-370\nR Z50", **KNOWN,
)
_drill(
    "or the value of DIS1", "CYCLE83(50,30,2,-15,,,30,0,0,0,1,1,0,0,0,0,2)",
    "R Z32\nF Z0\nR Z32\nR Z2\nF Z-15\nR Z50", **LIST,
)
_drill(
    "a negative DAM is a factor, and MDEP the least stroke", "CYCLE83(50,30,2,10,,,8,-0.5,0,0,1,0,0,2)",
    "R Z32\nF Z22\nF Z23\nF Z18\nF Z19\nF Z16\nF Z17\nF Z14\nF Z15\nF Z12\nF Z13\nF Z10\nR Z50", **LIST,
)
_drill(
    "a factor without a least stroke is not computed", "CYCLE83(50,30,2,10,,,8,-0.5)", "",
    alarm="code-not-computed", word="_DAM_WITHOUT_MDEP", **KNOWN,
)
for _what, _call in (
    ("digits of AMODE that say what other parameters count", "CYCLE83(50,30,2,10,,20,,4,0,0,1,0,0,1.2,1.4,0,1.6,0,1,1110)"),
    ("a feed factor above 1", "CYCLE83(50,30,2,10,,20,,4,0,0,90)"),
    ("one below a thousandth", "CYCLE83(50,30,2,10,,20,,4,0,0,0.0001)"),
    ("a negative one", "CYCLE83(50,30,2,10,,20,,4,0,0,-1)"),
):
    _drill(
        f"{_what}: not computed", _call, "",
        alarm="code-not-computed", word="_AMODE_OF_CYCLE83" if "AMODE" in _what else "_FRF_OF_CYCLE83", **KNOWN,
    )
_drill(
    "DTD is the dwell at the final depth", "CYCLE83(50,30,2,10,,20,,0,0.5,0,1,0,0,0,0,1.5)",
    "R Z32\nF Z20\nW 0.5\nF Z21\nF Z10\nW 1.5\nR Z50", **LIST,
)
_drill(
    "a first depth beyond the final one is the final one", "CYCLE83(50,30,2,10,,5)",
    "R Z32\nF Z10\nR Z50", **KNOWN,
)
_drill(
    "a first depth above the reference plane is 61107", "CYCLE83(50,30,2,10,,31)", "",
    alarm="user-alarm", number="61107", **KNOWN,
)
_drill(
    "AXN 1 drills along the first axis of the plane", "CYCLE83(50,30,2,10,,20,,0,0,0,1,0,1)",
    "R X32\nF X20\nF X21\nF X10\nR X50", **LIST,
)
_drill(
    "AXN 1 in G18 is Z", "CYCLE83(50,30,2,10,,20,,0,0,0,1,0,1)",
    "R Z32\nF Z20\nF Z21\nF Z10\nR Z50", "N15 G18 F100\n", **LIST,
)
_drill(
    "AXN 2 is the second axis", "CYCLE83(50,30,2,10,,20,,0,0,0,1,0,2)",
    "R Y32\nF Y20\nF Y21\nF Y10\nR Y50", **LIST,
)

# ---- tapping ----

_drill(
    "CYCLE84 taps down and back with its own speeds", "CYCLE84(50,30,2,-10,0,0.5,3,0,1.5,45,300,600)",
    "R Z32\nT Z-10\nW 0.5\nT Z32\nR Z50", m=[3, 30], **LIST,
)
_drill(
    "in G18 it taps along Y", "CYCLE84(50,30,2,-10,0,0,5,10,0,0,300)",
    "R Y32\nT Y-10\nT Y32\nR Y50", "N15 G18 F100\n", m=[5, 30], **LIST,
)
_drill(
    "a thread without a lead is 61001", "CYCLE84(50,30,2,-10,0,0,3)", "",
    alarm="user-alarm", number="61001", **KNOWN,
)
_drill(
    "and so is one with two", "CYCLE84(50,30,2,-10,0,0,3,10,1.25)", "",
    alarm="user-alarm", number="61001", **KNOWN,
)
_drill(
    "a size and its own lead go together", "CYCLE84(50,30,2,-10,0,0,3,10,1.5,0,300)",
    "R Z32\nT Z-10\nT Z32\nR Z50", **KNOWN,
)
_drill(
    "tapping in several strokes is not computed", "CYCLE84(50,30,2,-10,0,0,3,10,0,0,300,0,3,0,0,1,5)", "",
    alarm="code-not-computed", word="_VARI_OF_CYCLE84", **LIST,
)
_drill(
    "a lead in threads an inch is not computed", "CYCLE84(50,30,2,-10,0,0,3,0,20,0,300,0,3,2)", "",
    alarm="code-not-computed", word="_PITA_OF_CYCLE", **LIST,
)
_drill(
    "CYCLE840 follows the encoder of the spindle", "CYCLE840(50,30,2,-10,0,0.5,4,3,0,0,1.5)",
    "R Z32\nT Z-10\nT Z32\nR Z50", "N15 F100 S300 M3\n", m=[3, 4, 3, 30], **LIST,
)
_drill(
    "with ENC 20 it dwells", "CYCLE840(50,30,2,-10,0,0.5,0,0,20,10)",
    "R Z32\nT Z-10\nW 0.5\nT Z32\nR Z50", "N15 F100 S300 M3\n", m=[3, 30], **LIST,
)
_drill(
    "without the encoder it taps with the feed in force", "CYCLE840(50,30,2,-10,0,0.5,4,3,1)",
    "R Z32\nF Z-10\nW 0.5\nF Z32\nR Z50", "N15 F450 S300 M3\n", m=[3, 4, 3, 30], **LIST,
)

# ---- reaming and boring ----

_drill(
    "CYCLE85 comes back with a feed to before the reference plane", "CYCLE85(50,30,2,-10,0,0.5,80,200)",
    "R Z32\nF Z-10\nW 0.5\nF Z32\nR Z50", **LIST,
)
_drill(
    "CYCLE86 lifts off in all axes, and comes back where it began", "CYCLE86(50,30,2,-10,0,0.5,3,-1,-2,0.5,45)",
    "R Z32\nF Z-10\nW 0.5\nR X4 Y5 Z-9.5\nR Z32\nR X5 Y7 Z50", m=[3, 5, 30], **LIST,
)
_drill(
    "without a lift it comes straight back", "CYCLE86(50,30,2,-10,0,0,4)",
    "R Z32\nF Z-10\nR Z32\nR Z50", m=[4, 5, 30], **LIST,
)
_drill(
    "in G18 it lifts off along Z and X", "CYCLE86(50,30,2,-10,0,0,3,-1,-2,0.5)",
    "R Y32\nF Y-10\nR X3 Y-9.5 Z59\nR Y32\nR X5 Y50 Z60", "N15 G18 F100\n", **LIST,
)
for number, values in ((86, "0,0,5"), (87, "0,0"), (88, "0,0.5,1")):
    _drill(
        f"CYCLE{number} needs the direction of the spindle", f"CYCLE{number}(50,30,2,-10,{values})", "",
        alarm="user-alarm", number="61102", **KNOWN,
    )
_drill(
    "CYCLE87 stops the spindle and the program at the depth", "CYCLE87(50,30,2,-10,0,4)",
    "R Z32\nF Z-10\nR Z50", m=[4, 5, 0, 30], **LIST,
)
_drill(
    "CYCLE88 dwells before it stops", "CYCLE88(50,30,2,-10,0,0.5,3)",
    "R Z32\nF Z-10\nW 0.5\nR Z50", m=[3, 5, 0, 30], **LIST,
)
_drill(
    "CYCLE89 comes back with its feed to before the reference plane", "CYCLE89(50,30,2,-10,0,0.5)",
    "R Z32\nF Z-10\nW 0.5\nF Z32\nR Z50", **LIST,
)

# ---- around the cycles ----

case(
    "after a cycle the modes are those of the caller", **KNOWN, setup=SETUP,
    program="N10 G0 X5 Y7 Z60\nN15 G91 G1 F100 X1\nN20 CYCLE81(50,30,2,-10)\nN30 X2\nN40 M30",
    moves="R X5 Y7 Z60\nF X6\nR Z32\nF Z-10\nR Z50\nF X8",
)
case(
    "a program of the user with the name of a cycle comes first", **KNOWN,
    program="%_N_MAIN_MPF\nN10 CYCLE81(5)\nN20 M30\n%_N_CYCLE81_SPF\nN30 PROC CYCLE81(REAL HIGH)\nN40 G0 X=HIGH\nN50 M17",
    runs="N10 N30 N40 N50 N20", moves="R X5",
)
case(
    "a cycle is a level of the call tree", **KNOWN, program=_hole("CYCLE81(50,30,2,-10)", "N15 F100\n"),
    calls="call:CYCLE81",
)
for name in ("CYCLE952", "CYCLE800", "POCKET3", "CYCLE97", "Cycle70", "LONGHOLE"):
    case(
        f"{name} is told as not computed", **KNOWN,
        program=f"N10 G0 X1\nN20 {name}(1,2)\nN30 M30", runs="N10", alarm="code-not-computed", at="MAIN N20", word=name,
    )
case(
    "a name that is no cycle is a program that is missing", **KNOWN,
    program="N10 CYCLE12(1,2)\nN20 M30", runs="", alarm="named-program-not-found", number="14011", at="MAIN N10", word="CYCLE12",
)
case(
    "a cycle has no more values than its list", **KNOWN,
    program="N10 CYCLE81(50,30,2,-10,0,0,0,0,0,7)\nN20 M30", runs="", alarm="too-many-arguments", number="14020", at="MAIN N10", word="7",
)
case(
    "a cycle works in MDI", **KNOWN, program="N10 M30", mdi="G0 Z60 F100 CYCLE81(50,30,2,-10)".replace(" CYCLE", "\nCYCLE"),
    moves="R Z60\nR Z32\nF Z-10\nR Z50",
)
