"""SINUMERIK: arcs about a pole, tangential arcs, threads of variable lead, cutting speeds, axes beside the path."""

from conformance import case

ONE = "siemens-one"
POLE = {"control": ONE, "source": "802Dsl p.8-156: the pole is the centre of the circle", "evidence": "secondary"}
TANGENT = {"control": ONE, "source": "SONE p.201-203: CT", "evidence": "secondary"}
SPEED = {"control": ONE, "source": "SONE p.99: G96, G961, G97, G971", "evidence": "secondary"}
LEAD = {"control": ONE, "source": "SINUMERIK 840D sl, turning, 06/2019, p.420: the change of the lead by its square", "evidence": "secondary"}
AXES = {"control": ONE, "source": "MD840, MD 32060; 828D fundamentals 07/2010 p.440: POS", "evidence": "secondary"}
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}
POLICY = {"control": ONE, "source": "policy, not computed is said", "evidence": "inferred"}
ZERO = {"work_offsets": {"G54": {"X": 100.125, "Y": 20.25, "Z": -40.5}}, "start": {"X": 0, "Y": 0, "Z": 0}}
TOOL = {"tools": {1: {"R": 5, "Z": 12.5}}, **ZERO}

# ---- arcs about a pole ----

case(
    "G2 with a polar end goes about the pole", **POLE, setup=ZERO,
    program="N10 G0 X30 Y40\nN20 G111 X40 Y33\nN30 G2 RP=12.207 AP=21 F500\nN40 M30",
    moves="R X30 Y40\nCW X51.396216267 Y37.374597560 C X40 Y33", final_machine="X151.521216267 Y57.62459756 Z-40.5",
)
case(
    "an angle alone keeps the radius, and a height makes a helix", **KNOWN, setup=ZERO,
    program="N10 G0 X15 Y5\nN20 G111 X5 Y5\nN30 G3 AP=90 Z-5 F100\nN40 AP=IC(90)\nN50 M30",
    moves="R X15 Y5\nCCW X5 Y15 Z-5 C X5 Y5\nCCW X-5 Y5 Z-5 C X5 Y5", final_machine="X95.125 Y25.25 Z-45.5",
)
case(
    "it goes about the zero point where no pole was set, all around where the angle is the one that there is", **KNOWN, setup=ZERO,
    program="N10 G0 X10 Y0\nN20 G2 AP=0 F100\nN30 G3 AP=0 TURN=1\nN40 M30", moves="R X10 Y0\nCW X10 Y0 C X0 Y0\nCCW X10 Y0 C X0 Y0", time=113.157,
)
case(
    "the pole lies in the frame, and in the plane", **KNOWN, setup=ZERO,
    program="N10 TRANS X5\nN20 AROT Z90\nN30 G111 X10 Y1\nN40 G0 RP=4 AP=0\nN50 G3 AP=90 F100\nN60 TRANS\nN70 G18 G111 Z3 X2\nN80 G0 RP=6 AP=0\nN90 G2 AP=-90\nN100 M30",
    moves="R X-1 Y14\nCCW X-5 Y10 C X-1 Y10\nR X2 Z9\nCW X-4 Z3 C X2 Z3",
)
case(
    "a mirror changes its direction", **KNOWN, setup=ZERO,
    program="N10 MIRROR X0\nN20 G111 X10 Y0\nN30 G0 RP=4 AP=0\nN40 G3 AP=90 F100\nN50 M30", moves="R X-14 Y0\nCW X-10 Y4 C X-10 Y0",
)
case(
    "a radius is compensated on an arc about a pole", **KNOWN, setup=TOOL,
    program="N10 T1 M6\nN20 G111 X0 Y0\nN30 G0 X30 Y-20\nN40 G41 G1 X30 Y0 F100\nN50 G3 AP=90\nN60 G40 G1 X0 Y50\nN70 M30", time=51.111,
)
case(
    "one that ends off its circle is refused", **KNOWN,
    program="N10 G0 X10 Y0\nN20 G3 RP=12 AP=90 F100\nN30 M30", runs="N10", alarm="radius-tolerance", number="14040", at="MAIN N20", word="G3",
)
case(
    "one about the point where the tool stands has no radius", **KNOWN, setup=ZERO,
    program="N10 G0 X10 Y0\nN20 G110\nN30 G3 RP=5 AP=90 F100\nN40 M30", runs="N10 N20", alarm="radius-tolerance", number="14040", at="MAIN N30", word="G3",
)

# ---- CT ----

case(
    "CT goes on in the direction of the line before it, and of the arc before it", pins="g_meanings:CT=tangent-arc", **TANGENT, setup=ZERO,
    program="N10 G1 X10 Y0 F100\nN20 CT X20 Y10\nN30 X30 Y20\nN40 M30", moves="F X10 Y0\nCCW X20 Y10 C X10 Y10\nCW X30 Y20 C X30 Y10",
)
case(
    "of a rapid move and of G2 too, with a height and full turns", **TANGENT, setup=ZERO,
    program="N10 G0 X10 Y0\nN20 G2 X20 Y-10 CR=10 F100\nN30 CT X10 Y-20 Z-3\nN40 G0 X0 Y-20\nN50 CT X0 Y-30 TURN=1\nN60 M30",
    moves="R X10 Y0\nCW X20 Y-10 C X10 Y-10\nCW X10 Y-20 Z-3 C X10 Y-10\nR X0 Y-20\nCCW X0 Y-30 C X0 Y-25",
)
case(
    "in another plane", **TANGENT, setup=ZERO,
    program="N10 G18 G1 X0 Z10 F100\nN20 CT Z20 X10\nN30 M30", moves="F X0 Z10\nCCW X10 Z20 C X10 Z10",
)
case(
    "a polar end", **KNOWN, setup=ZERO, program="N10 G1 X10 Y0 F100\nN20 CT RP=20 AP=90\nN30 M30", moves="F X10 Y0\nCCW X0 Y20 C X10 Y12.5",
)
case(
    "a frame that changes between turns the direction", **TANGENT, setup=ZERO,
    program="N10 G1 X10 Y0 F100\nN20 ROT Z90\nN30 CT X10 Y0\nN40 M30", moves="F X10 Y0\nCCW X0 Y10 C X0 Y0", final_machine="X100.125 Y30.25 Z-40.5",
)
case(
    "a mirror turns it too", **TANGENT, setup=ZERO,
    program="N10 MIRROR X0\nN20 G1 X10 Y0 F100\nN30 CT X20 Y10\nN40 M30", moves="F X-10 Y0\nCW X-20 Y10 C X-10 Y10",
)
case(
    "a dwell and a tool between change nothing", **KNOWN, setup=ZERO,
    program="N10 G1 X10 Y0 F100\nN20 G4 F1\nN30 T3 M6\nN40 CT X20 Y10\nN50 M30", final_machine="X120.125 Y30.25 Z-40.5", time=16.425,
)
case(
    "straight on it is a line", **TANGENT, setup=ZERO, program="N10 G1 X10 Y0 F100\nN20 CT X20\nN30 CT X30 Y10\nN40 M30", moves="F X10 Y0\nF X20 Y0\nCCW X30 Y10 C X20 Y10",
)
case(
    "which has no turns", **TANGENT, setup=ZERO, program="N10 G1 X10 Y0 F100\nN20 CT X20 TURN=1\nN30 M30", runs="N10", alarm="value-out-of-range", at="MAIN N20", word="TURN=1",
)
case(
    "a radius is compensated beside it", **KNOWN, setup=TOOL,
    program="N10 T1 M6\nN20 G0 X-20 Y-20\nN30 G41 G1 X0 Y0 F100\nN40 X10\nN50 CT X20 Y10\nN60 X30 Y20\nN70 G40 G1 X50 Y20\nN80 M30", time=56.548,
)
case(
    "straight back there is no arc", **KNOWN, setup=ZERO,
    program="N10 G1 X10 Y0 F100\nN20 CT X5\nN30 M30", runs="N10", alarm="no-tangent", number="14045", at="MAIN N20", word="CT",
)
case(
    "nor where no move came before", **KNOWN, program="N10 CT X5 F100\nN20 M30", runs="", alarm="no-tangent", number="14045", at="MAIN N10", word="CT",
)
case(
    "nor where the move before went across the plane", **KNOWN,
    program="N10 G0 Z5\nN20 CT X5 F100\nN30 M30", runs="N10", alarm="no-tangent", number="14045", at="MAIN N20", word="CT",
)
case("CT needs a feed", **KNOWN, program="N10 G0 X5\nN20 CT X8 Y5\nN30 M30", runs="N10", alarm="no-feed", number="10860", at="MAIN N20", word="CT")

# ---- CIP outside of the plane ----

SPACE = {"control": ONE, "source": "840De p.4-30: CIP, also inclined in space", "evidence": "secondary"}
case(
    "CIP is an arc in the plane that its points lie in, whichever is in force", **SPACE, setup=ZERO,
    program="N10 G0 X10 Y0 Z0\nN20 CIP X-10 Y0 Z0 I1=0 J1=0 K1=10 F100\nN30 G19 CIP X-10 Y20 Z0 I1=-10 J1=10 K1=-10\nN40 G17 X-10 Y40 Z20 I1=IC(0) J1=IC(0) K1=IC(20)\nN50 M30",
    moves="R X10 Y0 Z0\nCW X-10 Y0 Z0 C X0 Z0\nCCW X-10 Y20 Z0 C Y10 Z0\nCW X-10 Y40 Z20 C Y30 Z10", final_machine="X90.125 Y60.25 Z-20.5",
)
case(
    "inclined in space it is made in lines within an increment of it, and CT goes on from its own direction", **SPACE, setup=ZERO,
    program="N10 G0 X10 Y0 Z0\nN20 CIP X-10 Y0 Z0 I1=0 J1=7.0710678 K1=7.0710678 F100\nN30 CT X-20 Y-10\nN40 M30",
    time=28.334, final_machine="X80.125 Y10.25 Z-40.5",
)
case(
    "its points count in the frame, as increments too", **SPACE, setup=ZERO,
    program="N10 TRANS X5\nN20 AROT Z90\nN30 G0 X0 Y0 Z0\nN40 G91 CIP X20 Y0 Z5 I1=10 J1=10 K1=5 F100\nN50 M30", final_machine="X105.125 Y40.25 Z-35.5",
)
case(
    "other axes go along", **KNOWN, setup=ZERO, program="N10 G0 X10 Y0 Z0 A0\nN20 CIP X-10 Y0 Z0 I1=0 J1=7 K1=7 A90 F100\nN30 R1=$AA_IM[A]\nN40 M30", vars={1: 90}, final_machine="X90.125 Y20.25 Z-40.5",
)
case(
    "points in a line make no arc in space", **SPACE, setup=ZERO,
    program="N10 G0 X0 Y0 Z0\nN20 CIP X10 Y10 Z10 I1=5 J1=5 K1=5 F100\nN30 M30", runs="N10", alarm="three-points", at="MAIN N20", word="I1=5",
)
for before, words in (
    ("G41 G1 X0 Y0 F100", "CIP X10 Y0 Z5 I1=5 J1=5 K1=3"), ("G1 X0 Y0 F100", "CIP X10 Y0 Z5 I1=5 J1=5 K1=3 RND=1"), ("G93 G1 X0 Y0 F1", "CIP X10 Y0 Z5 I1=5 J1=5 K1=3 F1"),
    ("G1 X0 Y0 F100", "CIP X10 Y0 Z5 I1=5 J1=5"), ("G1 X0 Y0 RND=1 F100", "CIP X10 Y0 Z5 I1=5 J1=5 K1=3"),
):
    case(
        f"{words} after {before} is not computed", **POLICY, setup=TOOL,
        program=f"N10 T1 M6\nN20 G0 X-20 Y-20\nN30 {before}\nN40 {words}\nN50 M30", runs="N10 N20 N30", alarm="code-not-computed", at="MAIN N40", word="I1=5",
    )

# ---- G34 and G35 ----

case(
    "G34 cuts a thread whose lead grows by F", pins="g_meanings:34=thread-growing", **LEAD, setup=ZERO,
    program="N10 G0 X0 Z0\nN20 S500 M3\nN30 G34 Z-20 K2 F0.1\nN40 M30", moves="R X0 Y0 Z0\nT Z-20", final_machine="X100.125 Y20.25 Z-60.5", time=0.994,
)
case(
    "G35 one whose lead shrinks", pins="g_meanings:35=thread-shrinking", **LEAD, setup=ZERO,
    program="N10 G0 X0 Z0\nN20 S500 M3\nN30 G35 Z-20 K2 F0.05\nN40 M30", moves="R X0 Y0 Z0\nT Z-20", time=1.406,
)
case(
    "F of G34 is no feed", **KNOWN, setup=ZERO,
    program="N10 S500 M3\nN20 G34 Z-20 K2 F0.1\nN30 G1 X5\nN40 M30", runs="N10 N20", alarm="no-feed", number="10860", at="MAIN N30", word="G1",
)
case(
    "a lead that falls to 0 is refused", **KNOWN, setup=ZERO,
    program="N10 S500 M3\nN20 G35 Z-20 K2 F0.1\nN30 M30", runs="N10", alarm="thread-lead", at="MAIN N20", word="F0.1",
)
case("G34 needs a lead", **KNOWN, program="N10 S500 M3\nN20 G34 Z-20 F0.1\nN30 M30", runs="N10", alarm="thread-lead", at="MAIN N20", word="G34")

# ---- G96 and G97 ----

case(
    "under G96 S is a cutting speed and F a feed per revolution", pins="g_meanings:96=surface-speed-per-revolution", **SPEED, setup=ZERO,
    program="N10 G0 X50\nN20 G96 S100 M3\nN30 G1 Z10 F0.2\nN40 M30", moves="R X50\nF X50 Z10", final_machine="X150.125 Y20.25 Z-30.5", time=9.725,
)
case(
    "G97 takes it away, and S is a speed again", **SPEED, setup=ZERO,
    program="N10 G96 S100 M3\nN20 G97 S500\nN30 G1 Z10 F0.1\nN40 M30", time=12,
)
case(
    "G97 alone is G95", pins="g_meanings:97=spindle-speed-per-revolution", control=ONE, source="840De p.7-40: G97 without G96 before it", evidence="secondary", setup=ZERO,
    program="N10 S500 M3\nN20 G97 G1 Z10 F0.1\nN30 M30", time=12,
)
case(
    "G961 keeps the feed per minute", pins="g_meanings:961=surface-speed-per-minute", **SPEED, setup=ZERO,
    program="N10 G95 S500 M3\nN20 G961 S100\nN30 G1 Z10 F100\nN40 M30", time=6,
)
case(
    "G971 too", pins="g_meanings:971=spindle-speed-per-minute", **SPEED, setup=ZERO,
    program="N10 G96 S100 M3\nN20 G971 S500\nN30 G1 Z10 F100\nN40 M30", time=6,
)
case(
    "G973 is G97 without the limit of the speed", pins="g_meanings:973=spindle-speed-per-revolution", **SPEED, setup=ZERO,
    program="N10 G96 S100 M3\nN20 G973 S500\nN30 G1 Z10 F0.1\nN40 M30", time=12,
)
case(
    "G94 ends the cutting speed", control=ONE, source="840De p.7-40: G94 and G95 deactivate it", evidence="secondary", setup=ZERO,
    program="N10 G96 S100 M3\nN20 G94 S500\nN30 G1 Z10 F100\nN40 G95 Z20 F0.1\nN50 M30", time=18,
)
case(
    "they move nothing", **SPEED, setup=ZERO, program="N10 G0 X50\nN20 G96 S100 M3\nN30 G97\nN40 G961\nN50 G971\nN60 M30", moves="R X50", final_machine="X150.125 Y20.25 Z-40.5",
)
for codes, word in (("G94 G96 S100", "G96"), ("G96 G97", "G97"), ("G961 G95", "G95")):
    case(
        f"{codes} are of one group", **KNOWN, program=f"N10 {codes}\nN20 M30", runs="", alarm="group-given-twice", number="12060", at="MAIN N10", word=word,
    )

# ---- POS ----

case(
    "POS moves an axis beside the path at its own feed, whatever code of motion is in force, and that stays", pins="g_meanings:POS=position-axes", **AXES, setup=ZERO,
    program="N10 G0 X5 Y0\nN20 POS[X]=15 FA[X]=600\nN30 X20\nN40 M30", moves="R X5 Y0\nF X15 Y0\nR X20 Y0", final_machine="X120.125 Y20.25 Z-40.5",
)
case(
    "the block waits for the slowest axis", **AXES, setup=ZERO,
    program="N10 POS[X]=10 POS[Y]=20 POS[Z]=0 FA[X]=600 FA[Y]=600 FA[Z]=600\nN20 M30", moves="F X10 Y10 Z0\nF X10 Y20 Z0", time=2,
)
case(
    "each axis goes at its own feed, which stays in force", **AXES, setup=ZERO,
    program="N10 POS[X]=10 POS[Y]=10 FA[X]=600 FA[Y]=1200\nN20 POS[X]=0\nN30 M30", moves="F X5 Y10\nF X10 Y10\nF X0 Y10", time=2,
)
case(
    "FA 0 is the feed of the axis", **KNOWN, setup={"rapid": {"X": 6000}, **ZERO},
    program="N10 POS[X]=100 FA[X]=600\nN20 FA[X]=0 POS[X]=0\nN30 M30", time=11,
)
case(
    "the words count in the forms of others, in the frame and with the length of the tool", **KNOWN, setup=TOOL,
    program="N10 T1 M6\nN20 TRANS X5 Z1\nN30 POS[Z]=3 FA[Z]=600\nN40 POS[X]=IC(2)\nN50 G91 POS[X]=3\nN60 POS[X]=AC(7) POS[Y]=R1+1\nN70 M30",
    final_machine="X112.125 Y21.25 Z-24",
)
case(
    "an axis that is there already does not move", **KNOWN, setup=ZERO, program="N10 G0 X5\nN20 POS[X]=5 FA[X]=600\nN30 M30", moves="R X5",
)
case(
    "a code of motion in the block stays in force after it", **KNOWN, setup=ZERO,
    program="N10 G1 POS[X]=5 FA[X]=600 F100\nN20 X8\nN30 M30", moves="F X5\nF X8", time=2.3,
)
case(
    "FA in a block of its own is kept for the blocks of POS, and moves nothing", **KNOWN, setup=ZERO,
    program="N10 FA[X]=600 FA[Y]=1200\nN20 POS[X]=10 POS[Y]=10\nN30 M30", moves="F X5 Y10\nF X10 Y10", dropped=[], time=1,
)
case(
    "so it is while a frame turns and the radius is compensated", **KNOWN, setup=TOOL,
    program="N10 T1 M6\nN20 ROT Z90\nN30 G41 G1 X10 Y10 F100\nN40 FA[X]=600\nN50 X20\nN60 G40 X30 Y20\nN70 ROT\nN80 POS[X]=0\nN90 M30",
    runs="N10 N20 N30 N40 N50 N60 N70 N80 N90",
)
case(
    "FA in a block that moves along the path is not computed", **POLICY, setup=ZERO,
    program="N10 G0 X5 FA[X]=500\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10", word="FA[X]=500",
)
for words, word in (
    ("SUPA POS[X]=5", "POS[X]=5"), ("POS[X]=5 G53", "POS[X]=5 G53"), ("G4 F1 SUPA X5", "SUPA"), ("POS[X]=5 G4 F1", "POS[X]=5 G4 F1"), ("G153 G74 X1=0", "G74"),
    ("SUPA TRANS X5", "TRANS"), ("G4 F1 FA[X]=500", "FA[X]=500"), ("SUPA G1 X5 MEAS=1", "MEAS=1"),
):
    case(
        f"{words}: two codes that hold for one block are not computed together", **POLICY, setup=ZERO,
        program=f"N10 G0 X1 F100\nN20 {words}\nN30 M30", runs="N10", alarm="code-not-computed", at="MAIN N20", word=word,
    )
case(
    "FA of an axis that a function names is reported", **KNOWN, program='N10 FA[AXNAME("X")]=500\nN20 G0 X1\nN30 M30', runs="N10 N20 N30", dropped=['FA[AXNAME("X")]=500'],
)
for text, cause, number in (
    ("POS[X]=5 Y3", "code-not-computed", None), ("POS[A]=5", "code-not-computed", None), ("POS[X1]=5", "code-not-computed", None),
    ("POS[X]=5 POS[X]=6", "axis-given-twice", "16420"), ("POS[X]=5 X3", "axis-given-twice", "16420"), ("POS[X] 5", "missing-equals", "12080"), ("POS=5", "bracket-not-opened", "12080"),
    ("POS[X]=5 G2 I3", "code-not-computed", None),
):
    case(f"{text} is refused", **KNOWN, program=f"N10 {text}\nN20 M30", runs="", alarm=cause, number=number, at="MAIN N10")
case(
    "a feed below 0 is refused", **KNOWN, program="N10 POS[X]=5 FA[X]=-5\nN20 M30", runs="", alarm="axis-feed-negative", number="14810", at="MAIN N10", word="FA[X]=-5",
)
for before, runs in (("N20 ROT Z30", "N10 N20"), ("N20 G41 G1 X10 Y10 F100", "N10 N20")):
    case(
        f"POS after {before[4:]} is not computed", **POLICY, setup=TOOL,
        program=f"N10 T1 M6\n{before}\nN30 POS[X]=5\nN40 M30", runs=runs, alarm="code-not-computed", at="MAIN N30",
    )
