"""SINUMERIK: what the codes of the feed do to F, cutting speeds without S, limits of the spindle speed."""

from conformance import case

ONE = "siemens-one"
FEEDS = {"control": ONE, "source": "840Dv p.2-4: a change between G93, G94 and G95 deletes F", "evidence": "secondary"}
ALARMS = {"control": ONE, "source": "840Dv p.2-9, alarms", "evidence": "secondary"}
SPEED = {"control": ONE, "source": "SONE p.99: G96, G961, G97, G971, LIMS", "evidence": "secondary"}
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}
ZERO = {"work_offsets": {"G54": {"X": 100.125, "Y": 20.25, "Z": -40.5}}, "start": {"X": 0, "Y": 0, "Z": 0}}
LIMITS = {"limits": {"X": (-1000, 1000)}}

# ---- F is deleted ----

for before, after in (("G94", "G95"), ("G94", "G93"), ("G95", "G94"), ("G95", "G93"), ("G93", "G94"), ("G93", "G95")):
    for told, setup in (("", ZERO), (", with limits too", LIMITS)):
        case(
            f"{after} after {before} deletes F{told}", pins="feed_mode_change" if after == "G95" and not told else "", **FEEDS, setup=setup,
            program=f"N10 {before} S500 M3\nN20 G1 X5 F2\nN30 {after}\nN40 X10\nN50 M30",
            runs="N10 N20 N30", alarm="no-feed", number="10860", at="MAIN N40", word="X10",
        )
case(
    "the code that is in force deletes nothing", **FEEDS, setup=ZERO,
    program="N10 G94 G1 X5 F100\nN20 G94 X10\nN30 G95 S500 M3 F0.1 X20\nN40 G95 X25\nN50 M30", moves="F X5\nF X10\nF X20\nF X25",
)
case(
    "F in the block of the code counts in its unit", **FEEDS, setup=ZERO,
    program="N10 G1 X5 F100\nN20 G95 S500 M3 X10 F0.1\nN30 F50 G94 X15\nN40 M30", time=3 + 6 + 6,
)
case(
    "a rapid move needs none", **FEEDS, setup=ZERO, program="N10 G1 X5 F100\nN20 G95 G0 X10\nN30 X15\nN40 M30", moves="F X5\nR X10\nR X15",
)
case(
    "an arc needs one again", **FEEDS, setup=ZERO,
    program="N10 G1 X5 F100\nN20 G95 S500 M3\nN30 G2 X10 CR=5\nN40 M30", runs="N10 N20", alarm="no-feed", number="10860", at="MAIN N30", word="G2",
)
case(
    "under G93 F stays from block to block", **KNOWN, setup=ZERO, program="N10 G93 G1 X100 F2\nN20 X50\nN30 M30", time=60,
)
case(
    "G96 is G95 besides: it deletes the feed of G94", control=ONE, source="SONE p.99: a new F where G95 was not active", evidence="secondary", setup=ZERO,
    program="N10 G1 X5 F100\nN20 G96 S100 M3\nN30 X10\nN40 M30", runs="N10 N20", alarm="no-feed", number="10860", at="MAIN N30", word="X10",
)
case(
    "and keeps that of G95", control=ONE, source="SONE p.99: a new F where G95 was not active", evidence="secondary", setup=ZERO,
    program="N10 G95 S500 M3 G1 X50 F0.2\nN20 G96 S100\nN30 Z10\nN40 M30", moves="F X50\nF X50 Z10",
)
case(
    "G961 keeps the feed of G94", **SPEED, setup=ZERO, program="N10 G1 X5 F100\nN20 G961 S100 M3\nN30 X10\nN40 M30", time=6,
)
for code in ("G97", "G973"):
    case(
        f"{code} deletes the feed of G94 too", control=ONE, source="840De p.7-40: G97 without G96 before it is G95", evidence="secondary", setup=ZERO,
        program=f"N10 G1 X5 F100\nN20 {code} S100 M3\nN30 X10\nN40 M30", runs="N10 N20", alarm="no-feed", number="10860", at="MAIN N30", word="X10",
    )

# ---- F and the codes of units ----

UNITS = {"control": [ONE, "siemens-828d", "siemens-840d-sl"], "source": "808Dm p.54: G70, G71, G700, G710", "evidence": "secondary", "setup": ZERO}
case(
    "G70 is about lengths: F stays millimetres", pins="g_meanings:70=inch-lengths", **UNITS,
    program="N10 G1 X25.4 F254\nN20 G70 X2\nN30 X3 F127\nN40 M30", time=6 + 6 + 12, moves="F X25.4\nF X50.8\nF X76.2",
)
case(
    "of a revolution too", **UNITS,
    program="N10 G95 S100 M3 G70\nN20 G1 X1 F0.254\nN30 M30", time=60, moves="F X25.4",
)
case(
    "G700 is about F too", pins="g_meanings:700=inch", **UNITS, program="N10 G700\nN20 G1 X1 F10\nN30 M30", time=6, moves="F X25.4",
)
case(
    "what F said keeps its speed where the units change", **UNITS,
    program="N10 G700 G1 X1 F10\nN20 G71 X50.8\nN30 X76.2 F127\nN40 M30", time=6 + 6 + 12, moves="F X25.4\nF X50.8\nF X76.2",
)
case(
    "G71 after G700 counts F in millimetres again", pins="g_meanings:71=metric-lengths g_meanings:710=metric", **UNITS,
    program="N10 G700 G1 X1 F10\nN20 G71 X50.8 F127\nN30 G710 X76.2 F254\nN40 M30", time=6 + 12 + 6, moves="F X25.4\nF X50.8\nF X76.2",
)
case(
    "a feed of corners and one of an axis are feeds", **UNITS,
    program="N10 G70 G1 X1 F254 FRCM=127\nN20 X2 RND=0.1\nN30 Y1\nN40 POS[Z]=1 FA[Z]=254\nN50 M30", moves="F X25.4\nF X48.26\nCCW X50.8 Y2.54 C X48.26 Y2.54\nF Y25.4\nF Z25.4",
)
case(
    "degrees of a round axis are not inches", **UNITS, program="N10 G70 G1 A90 F90\nN20 G700 A0 F90\nN30 M30", time=120,
)

# ---- F out of range ----

for value in ("F-5", "F0", "F=-5", "F=R1", "F=R1-0.5"):
    case(
        f"{value} is 14800", control=ONE, source="840Dv p.2-9: 14800; S840S, F", evidence="secondary",
        setup=ZERO, program=f"N10 G1 X5 {value}\nN20 M30", runs="", alarm="feed-out-of-range", number="14800", at="MAIN N10", word=value,
    )
case(
    "so it is in a block that does not move, and in a rapid one", control=ONE, source="840Dv p.2-9: 14800; S840S, F", evidence="secondary",
    program="N10 G0 X5 F100\nN20 F-5\nN30 M30", runs="N10", alarm="feed-out-of-range", number="14800", at="MAIN N20", word="F-5",
)
case(
    "F0 of G4 is no feed", **KNOWN, setup=ZERO, program="N10 G1 X5 F100\nN20 G4 F0\nN30 X10\nN40 M30", time=6,
)
case(
    "nor is F-0.1 of G35, which shrinks the lead less than nothing", **KNOWN, setup=ZERO,
    program="N10 G0 X0 Z0\nN20 S500 M3\nN30 G35 Z-20 K2 F-0.1\nN40 M30", moves="R X0 Y0 Z0\nT Z-20", time=0.994,
)
for value in ("FA[X]=-5", "FA[X]=-0.1", "FA[Q1]=-5"):
    case(
        f"{value} is 14810, with POS and without", control=ONE, source="general knowledge of the SINUMERIK alarms", evidence="inferred",
        program=f"N10 G0 X5\nN20 {value}\nN30 M30", runs="N10", alarm="axis-feed-negative", number="14810", at="MAIN N20", word=value,
    )
case(
    "a computed one is too, where its axis moves", control=ONE, source="general knowledge of the SINUMERIK alarms", evidence="inferred",
    program="N10 R1=-5\nN20 POS[X]=5 FA[X]=R1\nN30 M30", runs="N10", alarm="axis-feed-negative", number="14810", at="MAIN N20", word="FA[X]=R1",
)
for value, cause, number in (("FA=500", "bracket-not-opened", "12080"), ("FA[]=500", "expression-format", "12080"), ("ACC[]=50", "expression-format", "12080")):
    case(f"{value} names no axis", **KNOWN, program=f"N10 {value}\nN20 M30", runs="", alarm=cause, number=number, at="MAIN N10")

# ---- cutting speeds ----

for code in ("G96", "G961"):
    case(
        f"the first {code} needs S", **ALARMS, setup=ZERO,
        program=f"N10 S500 M3\nN20 {code}\nN30 M30", runs="N10", alarm="no-surface-speed", number="10900", at="MAIN N20", word=code,
    )
case(
    "the next one keeps the S of the first", **SPEED, setup=ZERO,
    program="N10 G96 S100 M3\nN20 G97 S500\nN30 G96\nN40 G0 X50\nN50 G1 Z10 F0.2\nN60 M30", moves="R X50\nF X50 Z10",
)
for value in ("S0", "S-10", "S=-10"):
    case(
        f"{value} is no cutting speed", control=ONE, source="SONE p.99: 0.1 m/min at least", evidence="secondary",
        program=f"N10 G96 {value} M3\nN20 M30", runs="", alarm="value-out-of-range", at="MAIN N10", word=value,
    )
case(
    "a speed below zero is none: M3 and M4 say the direction", **KNOWN,
    program="N10 S500 M3\nN20 S-100\nN30 M30", runs="N10", alarm="value-out-of-range", at="MAIN N20", word="S-100",
)
case("S0 is one", **KNOWN, program="N10 S0 M3\nN20 M30", runs="N10 N20")

# ---- LIMS ----

TURNING = "N20 G0 X10\nN30 G1 Z-100 F0.1\nN40 M30"
case(
    "LIMS limits the speed of G96", pins="speed_limit", **SPEED, setup=ZERO, program="N10 G96 S200 LIMS=2000 M3\n" + TURNING, time=30.06 + 0,
)
case(
    "before the block of G96 too, and it may change", **SPEED, setup=ZERO,
    program="N5 LIMS=9000\nN10 G96 S200 M3\nN15 LIMS=2000\n" + TURNING, time=30.06,
)
case(
    "LIMS[1] is that of the first spindle, others are told", **SPEED, setup=ZERO,
    program="N10 G96 S200 LIMS[1]=R1+2000 LIMS[2]=100 M3\n" + TURNING, time=30.06, dropped=["LIMS[2]=100"],
)
case(
    "a speed below the limit stays", **SPEED, setup=ZERO, program="N10 G96 S100 LIMS=6000 M3\nN20 G0 X50\nN30 G1 Z10 F0.2\nN40 M30", time=9.725,
)
for value in ("LIMS=-1", "LIMS=R1-5", "LIMS[1]=-5"):
    case(
        f"{value} is 14820", **ALARMS, program=f"N10 G96 S100 {value} M3\nN20 M30", runs="", alarm="speed-limit-negative", number="14820", at="MAIN N10", word=value,
    )
case("LIMS needs =", **KNOWN, program="N10 LIMS 500\nN20 M30", runs="", alarm="missing-equals", number="12080", at="MAIN N10")
case("LIMS twice", **KNOWN, program="N10 LIMS=5 LIMS=6\nN20 M30", runs="", alarm="address-given-twice", number="12000", at="MAIN N10", word="LIMS=6")
