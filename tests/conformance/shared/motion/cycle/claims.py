"""Feeds and speeds, offsets, cycles, corners and modal codes: claims one by one."""

from conformance import case

F16, *FANUC_PS = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
TA, T, TDI, MDI, HNC = "gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi", "hnc-21m"
GSK_988 = [TA, T]
LATHES = [*FANUC, *GSK_988, TDI]
MILLS = [*FANUC, *MITSUBISHI, MDI, HNC]
KNOWN = {"source": "general knowledge", "evidence": "inferred"}
ALARMS = {"evidence": "secondary"}
LATHE = {"machine": "lathe-a"}
MILL = {"machine": "mill"}
D = MILL | {"radius_offsets": {1: 5, 2: 3}}
H = MILL | {"length_offsets": {1: 10, 2: -4}}


def on_fanuc(number):
    return {F16: number, **dict.fromkeys(FANUC_PS, f"PS0{number}")}


def lines(*blocks):
    """Return a program of these blocks, numbered from N10 on."""
    numbered = [f"N{10 * (i + 1)} {block}" for i, block in enumerate(blocks)]
    return "\n".join(["O1", *numbered, "N900 M30"])


# Feeds and speeds
_AT = {"start": {"X": 50, "Z": 0}}

case(
    "G50 S is the highest speed of G96",
    control=LATHES, source="TDi 25; FANUC: general knowledge", evidence="inferred",
    pins="g_meanings speed_limit", setup=LATHE | _AT,
    program=lines("M3", *("G50 S500", "G96 S150"), "G99 G1 Z-10. F0.1"),
    time=12,
)
case(
    "the highest speed of G50 S counts after a G97 too",
    control=LATHES, source="TDi 25; FANUC: general knowledge", evidence="inferred",
    pins="g_meanings", setup=LATHE | _AT,
    program=lines("M3", *("G50 S500", "G96 S150", "G97 S300", "G96 S150"), "G99 G1 Z-10. F0.1"),
    time=12,
)
case(
    "before a G50 S the speed of G96 has no limit",
    control=LATHES, source="TDi 25; FANUC: general knowledge", evidence="inferred",
    pins="g_meanings", setup=LATHE | _AT,
    program=lines("M3", *("G96 S150",), "G99 G1 Z-10. F0.1"),
    time=6.2832,
)
case(
    "the S of G96 comes back after a G97",
    control=LATHES, source="TDi 25; FANUC: general knowledge", evidence="inferred",
    pins="g_meanings", setup=LATHE | _AT,
    program=lines("M3", *("G96 S150", "G97 S300", "G96"), "G99 G1 Z-10. F0.1"),
    time=6.2832,
)
case(
    "G97 without S keeps the speed that G96 had", control=LATHES,
    source="TDi 25 note 4; FANUC: general knowledge", evidence="inferred", setup=LATHE | _AT,
    program=lines("M3", "G97 S500", "G96 S150", "G97", "G99 G1 Z-10. F0.1"), time=6.2832,
)
case(
    "X of a dwell counts milliseconds without a point, seconds with one", control=MITSUBISHI,
    pins="dwell_words dwell_unit",
    source="general knowledge; M7 p.203: G4 X1000", evidence="inferred",
    program=lines("G4 X1000", "G4 X2.", "G4 P500"), time=3.5,
)
case(
    "X of a dwell that is computed is brought to a thousandth of a second", control=FANUC,
    source="JIX, XIA: of all values at an address", evidence="secondary",
    program=lines("#1=1/3", "G4 X#1", "G4 X[2/3]"), moves="W 0.333\nW 0.667",
)
case(
    "X of a dwell counts seconds without a point too", control=[*GSK_988, TDI, MDI, "gsk-928te", HNC],
    pins="dwell_words dwell_unit",
    source="TDi 14; source 003, G04", evidence="maker's manual",
    program=lines("G4 X2", "G4 X1."), time=3,
)
case(
    "a drilling cycle is repeated 99 times at the most", control=GSK_988, source="TA 24; Talm 181",
    pins="cycle_repeats max_cycle_repeats cycle_words_not_computed",
    evidence="maker's manual", setup=LATHE | _AT,
    program=lines("G99 M3 S500 F0.1", "G83 Z-5. R-2. K100"), alarm="cycle-repeats", number="181", word="K100",
)
case(
    "a drilling cycle may be repeated 99 times", control=GSK_988, source="TA 24; Talm 181",
    evidence="maker's manual", setup=LATHE | _AT,
    program=lines("G99 M3 S500 F0.1", "G83 Z-5. R-2. K99"), runs="N10 N20 N900",
)
case(
    "G50 S sets no coordinate", control=LATHES, source="TDi 18", evidence="maker's manual",
    setup=LATHE | _AT, program=lines("G50 S500", "G0 X50. Z0"), moves="R X50 Z0",
    final_machine="X50 Z0",
)
case(
    "in G code system B G92 S is the highest speed of G96", control=FANUC, **KNOWN,
    setup={"machine": "lathe-b"} | _AT,
    program=lines("G92 S500", "M3", "G96 S150", "G95 G1 Z-10. F0.1"), time=12,
)
case(
    "a canned cycle needs a feed", control=[*FANUC, *MITSUBISHI, MDI],
    source="ALM 011; M7 p.52; MDib 0023", **ALARMS, setup=MILL,
    program=lines("G0 Z10.", "G81 X10. Z-5. R2."), alarm="no-feed", at="O1 N20", word="G81",
    number=on_fanuc("011") | dict.fromkeys(MITSUBISHI, "P62") | {MDI: "0023"},
)
case(
    "a negative dwell of the 980TDi is none", control=TDI, source="TDi 14",
    evidence="maker's manual", program=lines("G4 P-100", "G4 X-2"), moves="none",
)
case(
    "of P, X and U of a dwell P counts first, X next", control=TDI, source="TDi 14",
    evidence="maker's manual", program=lines("G4 U3 X2 P100", "G4 U3 X2", "G4 U3"),
    moves="W 0.1\nW 2\nW 3",
)
case(
    "X of a dwell without a point counts milliseconds on a FANUC", control=FANUC, **KNOWN,
    pins="dwell_words",
    setup=MILL, program=lines("G4 X2500", "G4 X2.5"), moves="W 2.5\nW 2.5",
)
case(
    "U of a dwell counts as X does on a FANUC lathe", control=FANUC, **KNOWN, setup=LATHE,
    program=lines("G4 U2500", "G4 U2.5"), moves="W 2.5\nW 2.5",
)
case(
    "a dwell counts seconds under G95 too", control=FANUC, **KNOWN, setup=MILL,
    program=lines("M3 S60", "G95", "G4 X2.5"), moves="W 2.5",
)
case(
    "the F of a helix is the speed in its plane on the HNC",
    control=HNC, source="source 003, F of a helix", evidence="source document", setup=MILL,
    program=lines("G17 G2 X0 Y0 I10. J0 Z-30. F100"),
    time=37.6991,
)
case(
    "the F of a helix is the speed in its plane",
    control=[*FANUC, *MITSUBISHI], **KNOWN, setup=MILL,
    program=lines("G17 G2 X0 Y0 I10. J0 Z-30. F100"),
    time=37.6991,
)

# Radius offset
case(
    "G41 without a D ever given offsets nothing", control=[*FANUC, MDI, HNC, "haas-ngc"], **KNOWN, setup=D,
    pins="power_on:G91 missing_radius_offset",
    program=lines("G41 G1 X10. Y10. F100", "Y50."), centre="X10 Y10 | X10 Y50",
)
case(
    "a start-up ends on its own D, whatever the D of the next block", control=[*MILLS, "haas-ngc"],
    pins="power_on:G91 round_words",
    source="15iM p.402", evidence="secondary", setup=D,
    program=lines("G41 G1 X10. Y10. D1 F100", "Y50. D2", "X60."), centre="X5 Y10 | X7 Y53 | X60 Y53",
)
case(
    "G41 without a D ever given alarms on a Mitsubishi", control=MITSUBISHI,
    pins="missing_radius_offset",
    source="MZ 839, paired with P170", **ALARMS, setup=D,
    program=lines("G41 G1 X10. Y10. F100", "Y50."),
    alarm="radius-offset-number", number="P170", at="O1 N10", word="G41",
)
case(
    "G41 without D takes the last D",
    control=MILLS, source="source 003, G41", evidence="source document", setup=D,
    program=lines(*("D1", "G41 G1 X10. Y10. F100"), "G1 Y50.", "X60.", "G40 X80. Y80."),
    centre="X5 Y10 | X5 Y55 | X60 Y55 | X80 Y80",
)
case(
    "the radius offset begins with the first move after G41",
    # The 980MDi wants the move in the block itself. [MDib 0033]
    control=[name for name in MILLS if name != MDI], source="source 003, G41", evidence="source document", setup=D,
    program=lines(*("G41 D1", "G1 X10. Y10. F100"), "G1 Y50.", "X60.", "G40 X80. Y80."),
    centre="X5 Y10 | X5 Y55 | X60 Y55 | X80 Y80",
)
case(
    "the radius offset begins in G00 too",
    control=MILLS, source="source 003, G41", evidence="source document", setup=D,
    program=lines(*("G41 G0 X10. Y10. D1 F100",), "G1 Y50.", "X60.", "G40 X80. Y80."),
    centre="X5 Y10 | X5 Y55 | X60 Y55 | X80 Y80",
)
case(
    "the start-up of type A ends on the normal of the move after an acute corner",
    control=[*FANUC, *MITSUBISHI], source="16MC p.293; M7 p.188", evidence="maker's manual",
    setup=D, program=lines("G41 G1 X20. Y0 D1 F100", "X0 Y-30.", "X-20."),
    centre="X24.160 Y-2.774 | X2.676 Y-35 | X-20 Y-35",
)
case(
    "the start-up of type B goes around an acute corner",
    pins="power_on:G91 acute_corner",
    control=[*FANUC, TA], source="16MC p.293; the way: general knowledge", evidence="inferred",
    setup=D, params={"5003#0": 1},
    program=lines("G17 G41 G1 X20. Y0 D1 F100", "X0 Y-30.", "X-20."),
    centre="X25 Y5 | X26.934 Y1.387 | X2.676 Y-35 | X-20 Y-35",
)
case(
    "the start-up of type B meets the parallel of the move after an obtuse corner",
    control=FANUC, source="16MC p.293; the way: general knowledge", evidence="inferred",
    setup=D, params={"5003#0": 1},
    program=lines("G41 G1 X20. Y0 D1 F100", "X30. Y-30.", "X50."),
    centre="X23.604 Y5 | X33.604 Y-25 | X50 Y-25",
)
case(
    "an axis beside the plane has no radius offset", control=MILLS, source="16MC p.293",
    evidence="maker's manual", setup=D,
    program=lines("G41 G1 X10. Y10. Z-3. D1 F100", "Y50. Z-5.", "X60."),
    centre="X5 Y10 Z-3 | X5 Y55 Z-5 | X60 Y55 Z-5",
)
case(
    "a G40 alone takes the radius offset away with the next move", control=MILLS, **KNOWN, setup=D,
    program=lines("G41 G1 X10. Y10. D1 F100", "Y50.", "X60.", "G40", "X80."),
    centre="X5 Y10 | X5 Y55 | X60 Y55 | X80 Y50",
)
case(
    "G41 under G41 changes nothing", control=MILLS, source="M7 p.191", evidence="maker's manual",
    setup=D, program=lines("G41 G1 X10. Y10. D1 F100", "G41 Y50.", "G41", "X60.", "G40 X80. Y80."),
    centre="X5 Y10 | X5 Y55 | X60 Y55 | X80 Y80",
)
case(
    "a new D counts at the end of its block, not at the start", control=MILLS,
    source="15iM p.402", evidence="maker's manual", setup=D,
    program=lines("G41 G1 X10. Y10. D1 F100", "Y30.", "X50. D2", "Y0", "G40 X80. Y80."),
    centre="X5 Y10 | X5 Y35 | X53 Y33 | X53 Y0 | X80 Y80",
)
case(
    "from G41 to G42 the tool goes from one normal of the corner to the other", control=MILLS,
    **KNOWN, setup=D,
    program=lines("G41 G1 X10. Y10. D1 F100", "Y50.", "G42 Y80.", "Y100.", "G40 X80. Y120."),
    centre="X5 Y10 | X5 Y50 | X15 Y50 | X15 Y80 | X15 Y100 | X80 Y120",
)
case(
    "M00 stops the reading ahead of a radius offset",
    control=MITSUBISHI, source="M7 p.203", evidence="maker's manual", setup=D, optional_stop=True,
    program=lines("G41 G1 X10. Y10. D1 F100", "Y50.", "M00", "X60."),
    centre="X5 Y10 | X5 Y50 | X10 Y55 | X60 Y55",
)
case(
    "M01 stops the reading ahead of a radius offset",
    control=MITSUBISHI, source="M7 p.203", evidence="maker's manual", setup=D, optional_stop=True,
    program=lines("G41 G1 X10. Y10. D1 F100", "Y50.", "M01", "X60."),
    centre="X5 Y10 | X5 Y50 | X10 Y55 | X60 Y55",
)

# Length offset, tools
case(
    "G43 without an axis moves Z by the offset at once, G49 back", control=[*MILLS, "haas-ngc"], **KNOWN, setup=H,
    pins="length_type",
    program=lines("G0 Z5.", "G43 H1", "G49"), centre="Z5 | Z15 | Z5",
)
case(
    "a new H takes the place of the last", control=MILLS, source="SZGH p.66", **ALARMS, setup=H,
    program=lines("G43 H1 G0 Z5.", "H2 Z5."), centre="Z15 | Z1",
)
case(
    "with 5001#1 the length offset lies on the axis across the plane", control=FANUC, **KNOWN,
    setup=H, params={"5001#1": 1}, program=lines("G18 G43 H1 G0 Y5."), centre="Y15",
)
case(
    "G53 takes the length offset away from its axis", control=FANUC, source="0iMB p.228",
    evidence="maker's manual", setup=H,
    program=lines("G43 H1 G0 Z5.", "G53 Z0", "Z5."), centre="Z15 | Z0 | Z5",
)
case(
    "a length offset in a block with G3 alarms on the 980MDi",
    control=MDI, source="MDib 0042", **ALARMS, setup=H,
    program=lines("G43 H1 G3 X10 R5 F100"),
    alarm="length-with-motion", number="0042", at="O1 N10", word="G43",
)
case(
    "a length offset in a block with G31 alarms on the 980MDi",
    control=MDI, source="MDib 0042", **ALARMS, setup=H,
    program=lines("G43 H1 G31 Z5 F100"),
    alarm="length-with-motion", number="0042", at="O1 N10", word="G43",
)
case(
    "a length offset in a block with G92 alarms on the 980MDi",
    control=MDI, source="MDib 0042", **ALARMS, setup=H,
    program=lines("G43 H1 G92 Z5"),
    alarm="length-with-motion", number="0042", at="O1 N10", word="G43",
)
case(
    "with 5002#0 = 0 the last digit of T names the offset", control=TA, source="TApar 5002#0",
    pins="machine",
    evidence="maker's manual", params={"5002#0": 0}, setup={"tools": {1: {"X": 1, "Z": 2}}},
    program=lines("G0 X0 Z0", "T11", "X10 Z10"), final_machine="X11 Z12",
)

# The centre of a tip of radius 2 next to the line at X90: it stands at X94.
case(
    "a nose with tip 1 leads its imaginary point beside the contour",
    pins="tool_offset_digits", control=LATHES, source="TDi 8; FANUC: general knowledge",
    evidence="inferred",
    setup=LATHE | {"start": {"X": 100, "Z": 10}, "tools": {1: {"R": 2, "tip": 1}}},
    program=lines("M3 S100 T0101", "G42 G1 X90. Z0 F0.2", "Z-20.", "X100."),
    final_machine="X104 Z-16",
)
case(
    "a nose with tip 2 leads its imaginary point beside the contour",
    pins="tool_offset_digits", control=LATHES, source="TDi 8; FANUC: general knowledge",
    evidence="inferred",
    setup=LATHE | {"start": {"X": 100, "Z": 10}, "tools": {1: {"R": 2, "tip": 2}}},
    program=lines("M3 S100 T0101", "G42 G1 X90. Z0 F0.2", "Z-20.", "X100."),
    final_machine="X104 Z-20",
)
case(
    "a nose with tip 3 leads its imaginary point beside the contour",
    pins="tool_offset_digits", control=LATHES, source="TDi 8; FANUC: general knowledge",
    evidence="inferred",
    setup=LATHE | {"start": {"X": 100, "Z": 10}, "tools": {1: {"R": 2, "tip": 3}}},
    program=lines("M3 S100 T0101", "G42 G1 X90. Z0 F0.2", "Z-20.", "X100."),
    final_machine="X96 Z-20",
)
case(
    "a nose with tip 4 leads its imaginary point beside the contour",
    pins="tool_offset_digits", control=LATHES, source="TDi 8; FANUC: general knowledge",
    evidence="inferred",
    setup=LATHE | {"start": {"X": 100, "Z": 10}, "tools": {1: {"R": 2, "tip": 4}}},
    program=lines("M3 S100 T0101", "G42 G1 X90. Z0 F0.2", "Z-20.", "X100."),
    final_machine="X96 Z-16",
)
case(
    "a nose with tip 5 leads its imaginary point beside the contour",
    pins="tool_offset_digits", control=LATHES, source="TDi 8; FANUC: general knowledge",
    evidence="inferred",
    setup=LATHE | {"start": {"X": 100, "Z": 10}, "tools": {1: {"R": 2, "tip": 5}}},
    program=lines("M3 S100 T0101", "G42 G1 X90. Z0 F0.2", "Z-20.", "X100."),
    final_machine="X100 Z-16",
)
case(
    "a nose with tip 6 leads its imaginary point beside the contour",
    pins="tool_offset_digits", control=LATHES, source="TDi 8; FANUC: general knowledge",
    evidence="inferred",
    setup=LATHE | {"start": {"X": 100, "Z": 10}, "tools": {1: {"R": 2, "tip": 6}}},
    program=lines("M3 S100 T0101", "G42 G1 X90. Z0 F0.2", "Z-20.", "X100."),
    final_machine="X104 Z-18",
)
case(
    "a nose with tip 7 leads its imaginary point beside the contour",
    control=LATHES, source="TDi 8; FANUC: general knowledge",
    evidence="inferred",
    setup=LATHE | {"start": {"X": 100, "Z": 10}, "tools": {1: {"R": 2, "tip": 7}}},
    program=lines("M3 S100 T0101", "G42 G1 X90. Z0 F0.2", "Z-20.", "X100."),
    final_machine="X100 Z-20",
)
case(
    "a nose with tip 8 leads its imaginary point beside the contour",
    pins="tool_offset_digits", control=LATHES, source="TDi 8; FANUC: general knowledge",
    evidence="inferred",
    setup=LATHE | {"start": {"X": 100, "Z": 10}, "tools": {1: {"R": 2, "tip": 8}}},
    program=lines("M3 S100 T0101", "G42 G1 X90. Z0 F0.2", "Z-20.", "X100."),
    final_machine="X96 Z-18",
)
case(
    "a nose with tip 9 leads its imaginary point beside the contour",
    pins="tool_offset_digits", control=LATHES, source="TDi 8; FANUC: general knowledge",
    evidence="inferred",
    setup=LATHE | {"start": {"X": 100, "Z": 10}, "tools": {1: {"R": 2, "tip": 9}}},
    program=lines("M3 S100 T0101", "G42 G1 X90. Z0 F0.2", "Z-20.", "X100."),
    final_machine="X100 Z-18",
)
case(
    "a nose with tip 0 leads its imaginary point beside the contour",
    pins="tool_offset_digits", control=LATHES, source="TDi 8; FANUC: general knowledge",
    evidence="inferred",
    setup=LATHE | {"start": {"X": 100, "Z": 10}, "tools": {1: {"R": 2, "tip": 0}}},
    program=lines("M3 S100 T0101", "G42 G1 X90. Z0 F0.2", "Z-20.", "X100."),
    final_machine="X100 Z-18",
)
case(
    "in G17 the 980TDi offsets as if the tip were 0", control=TDI, source="TDi 8",
    evidence="maker's manual", setup={"tools": {1: {"R": 2, "tip": 3}}},
    program=lines("G17 T0101 G98 F100", "G42 G1 X20 Y0", "X40"), centre="X20 Y-2 | X40 Y-2",
)

# Canned cycles
_MILL = MILL | {"start": {"X": 0, "Y": 0, "Z": 20}}
_FIRST = "G90 G99 G81 X10. Z-5. R2. F100"
_HOLE = "R X10 Z20\nR Z2\nF Z-5\nR Z2\n"

case(
    "a Z alone drills once more, to its depth",
    control=MILLS, source="general knowledge; M7 p.45", evidence="inferred", setup=_MILL,
    program=lines("G0 Z20.", _FIRST, *("Z-6.",)),
    moves="R Z20\nR X10 Z20\nR Z2\nF Z-5\nR Z2\nR Z2\nF Z-6\nR Z2",
)
case(
    "an R alone drills once more, from its plane",
    control=MILLS, source="general knowledge; M7 p.45", evidence="inferred", setup=_MILL,
    program=lines("G0 Z20.", _FIRST, *("R3.",)),
    moves="R Z20\nR X10 Z20\nR Z2\nF Z-5\nR Z2\nR Z3\nF Z-5\nR Z3",
)
case(
    "G80 goes on in G00 where the cycle began there",
    control=MILLS, source="general knowledge; M7 p.45", evidence="inferred", setup=_MILL,
    program=lines("G0 Z20.", _FIRST, *("G80 X20.",)),
    moves="R Z20\nR X10 Z20\nR Z2\nF Z-5\nR Z2\nR X20",
)
case(
    "G02 ends a cycle",
    control=MILLS, source="general knowledge; M7 p.45", evidence="inferred", setup=_MILL,
    program=lines("G0 Z20.", _FIRST, *("G2 X20. R5.",)),
    moves="R Z20\nR X10 Z20\nR Z2\nF Z-5\nR Z2\nCW X20 C X15",
)
case(
    "G03 ends a cycle",
    control=MILLS, source="general knowledge; M7 p.45", evidence="inferred", setup=_MILL,
    program=lines("G0 Z20.", _FIRST, *("G3 X20. R5.",)),
    moves="R Z20\nR X10 Z20\nR Z2\nF Z-5\nR Z2\nCCW X20 C X15",
)
case(
    "G33 ends a cycle", control=[*FANUC, *MITSUBISHI], **KNOWN, setup=_MILL,
    pins="g_meanings",
    program=lines("G0 Z20.", "M3 S100", _FIRST, "G33 Z-20. F1."),
    moves=f"R Z20\n{_HOLE}T Z-20",
)
case(
    "G80 goes on in G01 where the cycle began there", control=MILLS, **KNOWN, setup=_MILL,
    program=lines("G1 X1. F100", _FIRST, "G80 X20."), moves=f"F X1\n{_HOLE}F X20",
)
case(
    "under G91 R counts from the initial level and Z from R", control=MILLS, source="30iM p.73",
    evidence="maker's manual", setup=_MILL,
    program=lines("G91 G98 G81 X10. Z-7. R-18. F100"), moves="R X10\nR Z2\nF Z-5\nR Z20",
)
case(
    "K of a cycle counts for its block only",
    pins="cycle_words_not_computed", control=FANUC, **KNOWN, setup=_MILL,
    program=lines("G91 G98 G81 X10. Z-7. R-18. F100 K2", "X10."),
    moves="".join(f"R X{x}\nR Z2\nF Z-5\nR Z20\n" for x in (10, 20, 30)),
)
case(
    "F of G84 is a feed in the mode that is in force, a minute here", control=[*FANUC, *MITSUBISHI, MDI, HNC], **KNOWN,
    pins="tap_feed", setup=MILL | {"work_offsets": {"G54": {"X": 10, "Y": 20, "Z": 30}}, "start": {"X": 0, "Y": 0, "Z": 2}},
    program=lines("M3 S500", "G94 G98 G84 X0 Y0 Z-5. R2. F100."), time=8.4,
)
case(
    "the sign of Q does not count in G83", control=FANUC, source="30iM p.73",
    evidence="maker's manual", setup=_MILL, params={"5115": 1},
    program=lines("G98 G83 X10. Z-5. R2. Q-4. F100"),
    moves="R X10\nR Z2\nF Z-2\nR Z2\nR Z-1\nF Z-5\nR Z20",
)
case(
    "G74 comes out of its hole as it should",
    control=[*FANUC, *MITSUBISHI, MDI], **KNOWN, pins="dwell_unit", setup=_MILL,
    program=lines("M3 S500", "G98 G74 X10. Z-5. R2. P500 F100"),
    moves="R X10\nR Z2\nF Z-5\nW 0.5\nF Z2\nR Z20",
)
case(
    "G84 comes out of its hole as it should",
    control=[*FANUC, *MITSUBISHI, MDI], **KNOWN, pins="dwell_unit", setup=_MILL,
    program=lines("M3 S500", "G98 G84 X10. Z-5. R2. P500 F100"),
    moves="R X10\nR Z2\nF Z-5\nW 0.5\nF Z2\nR Z20",
)
case(
    "G86 comes out of its hole as it should",
    control=[*FANUC, *MITSUBISHI, MDI], **KNOWN, setup=_MILL,
    program=lines("M3 S500", "G98 G86 X10. Z-5. R2. P500 F100"),
    moves="R X10\nR Z2\nF Z-5\nR Z20",
)
case(
    "an M code of a repeated cycle goes out once", control=FANUC, source="30iM p.73",
    evidence="maker's manual", setup=_MILL,
    program=lines("G91 G98 G81 X10. Z-5. R-2. F100 M8 K3", "X10."), m=[8],
)

# Lathe cycles
case(
    "the F of a profile does not count in G71", control=LATHES, source="TDi 23.1",
    evidence="maker's manual", setup=LATHE | {"start": {"X": 44, "Z": 2},
                                              "rapid": {"X": 9e6, "Z": 9e6}},
    program="O1\nN10 G98 F100\nN20 G71 U40. R1.\nN30 G71 P50 Q60 U0 W0\n"
    "N50 G1 X20. F50\nN60 Z-10.\nN90 M30", time=14.4,
)
case(
    "where G01 begins the profile G71 goes in at the feed", control=[*GSK_988, TDI],
    source="TDi 23.1; TA 8", evidence="maker's manual", setup=LATHE | {"start": {"X": 24, "Z": 2}},
    program="O1\nN10 G98 F100\nN20 G71 U2. R1.\nN30 G71 P50 Q60 U0 W0\n"
    "N50 G1 X20.\nN60 Z-10.\nN90 M30",
    moves="R X24 Z2\nF X20\nF Z-10\nR X24 Z2",
)
case(
    "after G71 the 988 runs what stands before its profile, and the profile", control=GSK_988,
    pins="after_contour",
    source="TA 8", evidence="maker's manual", setup=LATHE | {"start": {"X": 24, "Z": 2}},
    program="O1\nN10 G98 F100\nN20 G71 U2. R1.\nN30 G71 P50 Q60 U0 W0\nN40 M8\n"
    "N50 G1 X20.\nN60 Z-10.\nN90 M30",
    runs="N10 N20 N30 N40 N50 N60 N90",
)
case(
    "after G71 the run goes on after the profile, wherever it stands", control=[*FANUC, TDI],
    pins="after_contour",
    source="TDi 23.1; FANUC: general knowledge", evidence="inferred", setup=LATHE | {"start": {"X": 24, "Z": 2}},
    program="O1\nN10 G98 F100\nN20 G71 U2. R1.\nN30 G71 P50 Q60 U0 W0\nN40 M8\n"
    "N50 G1 X20.\nN60 Z-10.\nN90 M30",
    runs="N10 N20 N30 N90",
)

# Corners
_TURN = LATHE | {"start": {"X": 20, "Z": 0}}

case(
    "with 181#0 L is the distance from the corner", control=TDI, source="TDipar 181",
    evidence="maker's manual", params={"181#0": 1}, setup=_TURN,
    program=lines("G98 G1 Z-10. L2. F100", "X40."), moves="F Z-8\nF X24 Z-10\nF X40",
)
case(
    "L and D between lines of one direction have no effect", control=TDI, source="TDi 11",
    evidence="maker's manual", setup=_TURN,
    program=lines("G98 G1 Z-10. L2. F100", "Z-20. D3.", "Z-30."), moves="F Z-10\nF Z-20\nF Z-30",
)
case(
    "D between a line and a tangent arc has no effect", control=TDI, source="TDi 11",
    evidence="maker's manual", setup=_TURN,
    program=lines("G98 G1 Z-10. D2. F100", "G2 X30. Z-15. R5."),
    moves="F Z-10\nCW X30 Z-15 C X30 Z-10",
)
case(
    "with 3405#4 = 0 R without a comma is no corner", control=[*FANUC, TA],
    source="TApar 3405#4; FANUC: general knowledge", evidence="inferred", params={"3405#4": 0},
    setup=_TURN, program=lines("G98 G1 Z-10. R2. F100", "X40."), moves="F Z-10\nF X40",
)
case(
    ",C2. cuts the corner of a line and an arc",
    control=[*FANUC, *MITSUBISHI], **KNOWN, setup=MILL,
    program=lines("G17 G1 X10. ,C2. F100", "G2 X20. Y10. R10."),
    moves="F X8\nF X10.2 Y1.990\nCW X20 Y10 C X20 Y0",
)
case(
    ",R2. cuts the corner of a line and an arc",
    control=[*FANUC, *MITSUBISHI], **KNOWN, setup=MILL,
    program=lines("G17 G1 X10. ,R2. F100", "G2 X20. Y10. R10."),
    moves="F X8.168\nCCW X10.140 Y1.667 C X8.168 Y2\nCW X20 Y10 C X20 Y0",
)

# Modal codes and calls
case(
    "G and F codes of a macro hold in the program that called it", control=[*FANUC, *MITSUBISHI],
    **KNOWN, setup=MILL,
    program="O1\nN10 G90 G1 X1. F100\nN20 G65 P2\nN30 X5.\nN40 G1 X10.\nN50 M30\n"
    "O2\nN60 G91 G0 F200\nN70 M99", moves="F X1\nR X6\nF X16",
)
case(
    "G30 and M99 in one block alarm on the 988",
    control=GSK_988, source="Talm 030", **ALARMS,
    program="O1\nN10 M98 P2\nN20 M30\nO2\nN30 G30 U0 M99",
    alarm="illegal-word-with-return", number="030", at="O2 N30", word="G30",
)
case(
    "G53 and M99 in one block alarm on the 988",
    control=GSK_988, source="Talm 030", **ALARMS,
    program="O1\nN10 M98 P2\nN20 M30\nO2\nN30 G53 X0 M99",
    alarm="illegal-word-with-return", number="030", at="O2 N30", word="G53",
)
case(
    "G36 and M99 in one block alarm on the 988",
    control=GSK_988, source="Talm 030", **ALARMS,
    program="O1\nN10 M98 P2\nN20 M30\nO2\nN30 G36 X0 M99",
    alarm="illegal-word-with-return", number="030", at="O2 N30", word="G36",
)
case(
    "G37 and M99 in one block alarm on the 988",
    control=GSK_988, source="Talm 030", **ALARMS,
    program="O1\nN10 M98 P2\nN20 M30\nO2\nN30 G37 Z0 M99",
    alarm="illegal-word-with-return", number="030", at="O2 N30", word="G37",
)
case(
    "G27 with M01 alarms on a Mitsubishi",
    control=MITSUBISHI, source="MZ 920, paired with P435", **ALARMS,
    setup=MILL | {"reference": {1: {"X": 0}}},
    program=lines("G28 X0", "G27 X0 M01"),
    alarm="reference-with-end", number="P435", at="O1 N20", word="M01",
)
case(
    "G27 with M02 alarms on a Mitsubishi",
    control=MITSUBISHI, source="MZ 920, paired with P435", **ALARMS,
    setup=MILL | {"reference": {1: {"X": 0}}},
    program=lines("G28 X0", "G27 X0 M02"),
    alarm="reference-with-end", number="P435", at="O1 N20", word="M02",
)
case(
    "G29 with M00 alarms on a Mitsubishi",
    control=MITSUBISHI, source="MZ 921, paired with P436", **ALARMS,
    setup=MILL | {"reference": {1: {"X": 0}}},
    program=lines("G28 X0", "G29 X0 M00"),
    alarm="reference-with-m", number="P436", at="O1 N20", word="M00",
)
case(
    "G29 with M30 alarms on a Mitsubishi",
    control=MITSUBISHI, source="MZ 921, paired with P436", **ALARMS,
    setup=MILL | {"reference": {1: {"X": 0}}},
    program=lines("G28 X0", "G29 X0 M30"),
    alarm="reference-with-m", number="P436", at="O1 N20", word="M30",
)
case(
    "in G code system B #4003 is G90 or G91 and #4005 the feed", control=FANUC, **KNOWN,
    setup={"machine": "lathe-b"},
    program=lines("G91 G94", "#100=#4003", "#101=#4005", "#102=#4016", "#103=#4010"),
    vars={100: 91, 101: 94, 102: 18, 103: 80},
)
case(
    "the positions of a lathe's variables are diameters", control=FANUC, **KNOWN, setup=LATHE,
    program=lines("G0 X30. Z5.", "#100=#5001", "#101=#5021", "#102=#5041"),
    vars={100: 30, 101: 30, 102: 30},
)
case(
    "3402#6 = 0 says what M30 leaves of the modal codes of the 988TA",
    control=TA, source="TApar 3402#6",
    evidence="maker's manual", params={"3402#6": 0},
    program=lines("G98 G1 X1 F77"),
    modal_after_reset={"motion": "G01", "feed_mode": "G98"},
)
case(
    "3402#6 = 1 says what M30 leaves of the modal codes of the 988TA",
    control=TA, pins="power_on:G01 power_on:G95", source="TApar 3402#6",
    evidence="maker's manual", params={"3402#6": 1},
    program=lines("G98 G1 X1 F77"),
    modal_after_reset={"motion": "G00", "feed_mode": "G99"},
)
case(
    "F outlives the M30 of the 980TDi", control=TDI, source="TDi 26", evidence="maker's manual",
    program=lines("G98 G1 X1 F77"), modal_after_reset={"F": "77"},
)
case(
    "the H of a subprogram holds in the main program", control=[*FANUC, *MITSUBISHI],
    source="source 003, note 5 (1)", evidence="source document", setup=H,
    program="O1\nN10 G43 H1 G0 Z5.\nN20 M98 P2\nN30 Z6.\nN40 M30\nO2\nN50 H2 Z5.\nN60 M99",
    centre="Z15 | Z1 | Z2",
)
