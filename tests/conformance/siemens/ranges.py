"""SINUMERIK: values out of range, words that do not go together, words that nothing takes."""

from conformance import case

ONE = "siemens-one"
POLAR = {"control": ONE, "source": "840De p.4-4: RP is positive, AP within 360 degrees; the numbers are general knowledge", "evidence": "inferred"}
NUMBERS = {"control": ONE, "source": "general knowledge of the SINUMERIK alarms", "evidence": "inferred"}
CIRCLE = {"control": ONE, "source": "HSA 14040: an arc by its radius", "evidence": "secondary"}
TURNS = {"control": ONE, "source": "S840S, TURN below zero: 14048", "evidence": "secondary"}
DEFS = {"control": ONE, "source": "S840S, DEF after another block: 14500", "evidence": "secondary"}
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}
POLICY = {"control": ONE, "source": "policy, nobody says", "evidence": "inferred"}
ZERO = {"work_offsets": {"G54": {"X": 100.125, "Y": 20.25, "Z": -40.5}}, "start": {"X": 0, "Y": 0, "Z": 0}}

# ---- polar words ----

for words, cause, number, word in (
    ("RP=-5 AP=0", "polar-radius", "14200", "RP=-5"), ("RP=R1-5 AP=0", "polar-radius", "14200", "RP=R1-5"), ("RP=IC(-11) AP=0", "polar-radius", "14200", "RP=IC(-11)"),
    ("RP=5 AP=400", "polar-angle", "14210", "AP=400"), ("RP=5 AP=-360.1", "polar-angle", "14210", "AP=-360.1"), ("RP=5 AP=IC(400)", "polar-angle", "14210", "AP=IC(400)"),
):
    case(
        f"{words} is {number}", **POLAR, setup=ZERO,
        program=f"N10 G0 X10 Y0\nN20 {words}\nN30 M30", runs="N10", alarm=cause, number=number, at="MAIN N20", word=word,
    )
case(
    "a full turn and a radius of zero are in the range", **POLAR, setup=ZERO,
    program="N10 G0 RP=5 AP=360\nN20 RP=5 AP=-360\nN30 RP=0 AP=90\nN40 RP=IC(4)\nN50 RP=IC(-4)\nN60 M30", moves="R X5 Y0\nR X5 Y0\nR X0 Y0\nR X4 Y0\nR X0 Y0",
)
for words, cause, number, word in (("RP=-5 AP=0", "pole-radius", "14250", "RP=-5"), ("RP=5 AP=361", "pole-angle", "14260", "AP=361")):
    for code in ("G110", "G111", "G112"):
        case(
            f"{code} {words} is {number}", **POLAR, program=f"N10 G0 X1\nN20 {code} {words}\nN30 M30",
            runs="N10", alarm=cause, number=number, at="MAIN N20", word=word,
        )
case(
    "an arc about the pole has the range too", **POLAR, setup=ZERO,
    program="N10 G0 X10 Y0\nN20 G3 AP=400 F100\nN30 M30", runs="N10", alarm="polar-angle", number="14210", at="MAIN N20", word="AP=400",
)

# ---- signs of lengths and times ----

for word in ("RND=-1", "CHF=-1", "CHR=-1", "RND=R1-1", "CHR=-0.001"):
    case(
        f"{word} is below zero", **KNOWN, setup=ZERO,
        program=f"N10 G1 X5 F100 {word}\nN20 Y5\nN30 M30", runs="", alarm="value-out-of-range", at="MAIN N10", word=word,
    )
case("RND=0 makes no corner", **KNOWN, setup=ZERO, program="N10 G1 X5 F100 RND=0\nN20 Y5 CHR=0\nN30 X0\nN40 M30", moves="F X5\nF X5 Y5\nF X0 Y5")
for word in ("F-1", "S-1", "F=R1-0.5", "S=-R2"):
    case(
        f"{word} of G4 is below zero", **KNOWN,
        program=f"N10 R2=1 S100 M3\nN20 G4 {word}\nN30 M30", runs="N10", alarm="value-out-of-range", at="MAIN N20", word=word,
    )
case("G4 F0 waits no time", **KNOWN, program="N10 G4 F0\nN20 G4\nN30 M30", time=0)

# ---- arcs ----

START = "N10 G0 X10 Y0\nN20 "
for words, word in (
    ("G2 X0 Y10 I-10 J0 TURN=1.5", "TURN=1.5"), ("G2 X0 Y10 I-10 J0 TURN=-1", "TURN=-1"), ("G3 X0 Y10 CR=10 TURN=0.5", "TURN=0.5"),
    ("G3 AP=90 TURN=-2", "TURN=-2"), ("CT X20 Y5 TURN=1.5", "TURN=1.5"),
):
    case(
        f"{words}: the turns are no whole number from zero on", **TURNS, setup=ZERO,
        program=f"{START}{words} F100\nN30 M30", runs="N10", alarm="arc-turns", number="14048", at="MAIN N20", word=word,
    )
case(
    "TURN=0 adds nothing", **KNOWN, setup=ZERO, program=START + "G3 X0 Y10 I-10 J0 TURN=0 F100\nN30 M30", moves="R X10 Y0\nCCW X0 Y10 C X0 Y0",
)
for words, word in (("G2 X10 Y0 CR=5", "CR=5"), ("G2 CR=5", "CR=5"), ("G3 X10 Y0 AR=90", "AR=90"), ("G3 AR=90", "AR=90")):
    case(
        f"{words} at X10 Y0 is no arc: start and end do not say where it lies", **CIRCLE, setup=ZERO,
        program=f"{START}{words} F100\nN30 M30", runs="N10", alarm="no-arc-travel", number="14040", at="MAIN N20", word=word,
    )
for words in ("G2 X0 Y10 CR=10 AR=90", "G3 X0 Y10 AR=90 CR=10", "G2 X0 Y10 CR=10 AR=90 I5"):
    case(
        f"{words} says twice how far it bends", **POLICY, setup=ZERO,
        program=f"{START}{words} F100\nN30 M30", runs="N10", alarm="radius-and-centre", at="MAIN N20", word="AR=90",
    )
case(
    "CR counts, and a centre beside it is told", **POLICY, setup=ZERO,
    program=START + "G2 X0 Y10 CR=10 I-10 J0 F100\nN30 M30", moves="R X10 Y0\nCW X0 Y10 C X10 Y10", dropped=["I-10", "J0"],
)
for value in ("2", "0.001", "7.07"):
    case(
        f"CR={value} is smaller than half the chord", **NUMBERS, setup=ZERO,
        program=f"{START}G2 X0 Y10 CR={value} F100\nN30 M30", runs="N10", alarm="radius-too-small", number="14095", at="MAIN N20", word=f"CR={value}",
    )
for angle in ("AR=0", "AR=360", "AR=-90", "AR=400"):
    case(
        f"{angle} is no angle of an arc", **KNOWN, setup=ZERO,
        program=f"{START}G2 X0 Y10 {angle} F100\nN30 M30", runs="N10", alarm="value-out-of-range", at="MAIN N20", word=angle,
    )
case(
    "CT straight back says where its end lies", **NUMBERS, setup=ZERO,
    program="N10 G1 X10 F100\nN20 CT X5\nN30 M30", runs="N10", alarm="no-tangent", number="14045", at="MAIN N20", word="CT",
)

# ---- words that nothing takes are told ----

for words, dropped in (
    ("G1 X5 CR=5", ["CR=5"]), ("G1 X5 I5", ["I5"]), ("G1 X5 AR=50", ["AR=50"]), ("G1 X5 TURN=1", ["TURN=1"]), ("X5 I1 J2", ["I1", "J2"]),
    ("G0 X5 RPL=30", ["RPL=30"]), ("CR=5", ["CR=5"]), ("TRANS X5 RPL=30", ["RPL=30"]), ("G1 X5 I1=3 K1=4", ["I3", "K4"]), ("G2 TURN=1", ["TURN=1"]),
):
    case(
        f"{words}: what no code takes is dropped", pins="unused_words_told" if words == "CR=5" else "", **POLICY, setup=ZERO,
        program=f"N10 F100\nN20 {words}\nN30 M30", runs="N10 N20 N30", dropped=dropped,
    )
for words in ("I-10 J0", "CR=10", "AR=90"):
    case(
        f"CT takes no {words}", **POLICY, setup=ZERO,
        program=f"N10 G1 X10 Y0 F100\nN20 CT X20 Y10 {words}\nN30 M30", moves="F X10 Y0\nCCW X20 Y10 C X10 Y10", dropped=words.split(),
    )
case(
    "what a code takes is not dropped", **POLICY, setup=ZERO,
    program="N10 G0 X10 Y0\nN20 G3 X0 Y10 I-10 J0 TURN=1 F100\nN30 G2 X10 Y0 AR=90\nN40 ROT RPL=30\nN50 S100 M3\nN60 ROT\nN70 G33 Z-5 K1\nN80 POS[X]=3 FA[X]=500\nN90 M30",
    runs="N10 N20 N30 N40 N50 N60 N70 N80 N90", dropped=[],
)

# ---- frames ----

for words in ("ROT X30 RPL=30", "ROT Z30 RPL=30", "AROT Y10 RPL=5", "ROT X=R1 RPL=30"):
    case(
        f"{words}: an angle in the plane beside one about an axis", **POLICY,
        program=f"N10 {words}\nN20 M30", runs="", alarm="address-not-usable", at="MAIN N10", word=words.split()[-1],
    )
case("ROT X RPL=30: X has no value", **KNOWN, program="N10 ROT X RPL=30\nN20 M30", runs="", alarm="address-without-value", number="12080", at="MAIN N10", word="X")
case("TRANS X: nor has it here", **KNOWN, program="N10 TRANS Y5 X\nN20 M30", runs="", alarm="address-without-value", number="12080", at="MAIN N10", word="X")

# ---- threads ----

for words, word in (("G33 Z-10 K0", "K0"), ("G33 Z-10 I2", "I2"), ("G331 Z-10 K0", "K0"), ("G34 Z-10 K0 F0.1", "K0"), ("G33 X10 K2", "K2")):
    case(
        f"{words} has no lead", **KNOWN, setup=ZERO,
        program=f"N10 S100 M3\nN20 {words}\nN30 M30", runs="N10", alarm="thread-lead", at="MAIN N20", word=word,
    )
case("G33 X20 Z-10 takes the lead along either axis", **KNOWN, setup=ZERO, program="N10 S60 M3\nN20 G33 X20 Z-10 I2\nN30 G33 X10 Z0 K1\nN40 M30", moves="T X20 Z-10\nT X10 Z0")

# ---- functions of the machine ----

for word, cause in (
    ("T-1", "value-out-of-range"), ("T=R1-1", "value-out-of-range"), ("T1.5", "whole-number-expected"), ("D1.5", "whole-number-expected"), ("D-1", "offset-number"),
    ("M1.5", "whole-number-expected"), ("M-1", "value-out-of-range"), ("M99999999999", "value-out-of-range"),
):
    case(f"{word} is none", **KNOWN, program=f"N10 G0 X1\nN20 {word}\nN30 M30", runs="N10", alarm=cause, at="MAIN N20", word=word)
for words, word in (("F1 F2", "F2"), ("S1 S2", "S2"), ("T1 T2", "T2"), ("D1 D2", "D2")):
    case(
        f"{words} in a block", control=ONE, source="S840S, F twice: 12010", evidence="secondary",
        program=f"N10 {words}\nN20 M30", runs="", alarm="too-many-words", number="12010", at="MAIN N10", word=word,
    )
for words, word in (("X1 X=2", "X=2"), ("X1 AX[X]=2", "AX[X]=2"), ("A1 A2", "A2"), ("G2 X1 I1 I2", "I2"), ("POS[X]=5 X3", "POS[X]=5 X3")):
    case(
        f"{words}: an axis twice in a block", control=ONE, source="S840S, an axis twice: 16420", evidence="secondary",
        program=f"N10 {words}\nN20 M30", runs="", alarm="axis-given-twice", number="16420", at="MAIN N10", word=word,
    )

# ---- POS as it is written ----

for words, cause, word in (
    ("POS[X", "bracket-not-closed", "POS[X"), ("POS[]=5", "expression-format", "POS[]=5"), ("POS[", "bracket-not-closed", "POS["), ("POS[X]", "missing-equals", "POS[X]"),
    ("POS X", "bracket-not-opened", "POS"),
):
    case(f"{words} is a syntax error", **KNOWN, program=f"N10 {words}\nN20 M30", runs="", alarm=cause, number="12080", at="MAIN N10", word=word)
case("POS[X]=5 Y3 points at POS", **POLICY, program="N10 G1 POS[X]=5 Y3 F100\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10", word="POS[X]=5 Y3 F100")

# ---- DEF comes first ----

for before in ("N10 G0 X1", "N10 R1=1", 'N10 MSG("A")', "N10 G54 G17", "LABEL1:\nN10 M8", "N10 IF R1==0\nN15 ENDIF"):
    case(
        f"DEF after {before.splitlines()[-1][4:]} is 14500", **DEFS,
        program=f"{before}\nN20 DEF REAL WIDE\nN30 M30", alarm="definition-late", number="14500", at="MAIN N20", word="DEF",
    )
case(
    "DEF after PROC, EXTERN, other definitions and comments is not", **DEFS,
    program="%_N_MAIN_MPF\n; A\nN10 PROC MAIN\nN20 EXTERN OTHER(REAL)\nN30\nN40 DEF REAL WIDE=5\n\nN50 DEF INT MANY\nN60 R1=WIDE\nN70 M30", vars={1: 5},
)
case(
    "each program has definitions of its own", **DEFS,
    program="%_N_MAIN_MPF\nN10 DEF REAL WIDE=5\nN20 PART\nN30 M30\n%_N_PART_SPF\nN40 DEF REAL DEEP=3\nN50 R1=DEEP\nN60 M17", vars={1: 3},
)

# ---- blocks between the sides of a corner ----

BETWEEN = {"control": ONE, "source": "CNCF, chamfers and roundings: no more than three blocks", "evidence": "secondary"}
CUT = "F X4 Y0\nF X5 Y1\nF X5 Y5"
for blocks in ("N20 M8", "N20 F50\nN21 M8", "N20 M8\nN21 S500\nN22 M3", "N20 R1=5", 'N20 MSG("A")\nN21 M8'):
    case(
        f"{blocks.replace(chr(10), ', ')} may stand between the sides of a corner", pins="corner_idle_blocks" if "S500" in blocks else "", **BETWEEN, setup=ZERO,
        program=f"N10 G1 X5 CHR=1 F100\n{blocks}\nN30 Y5\nN40 M30", moves=CUT,
    )
for blocks, at, word in (
    ("N20 M8\nN21 M9\nN22 M8\nN23 M9", "N23", "M9"), ("N20 M30", "N20", "M30"), ("N20 G4 F1", "N20", "G4"), ("N20 T1 M6", "N20", "T1"), ("N20 D0", "N20", "D0"), ("N20 G64", "N20", "G64"),
):
    case(
        f"no {word} after {blocks.count(chr(10))} others", pins="corner_idle_blocks" if word == "M9" else "", **POLICY, setup=ZERO,
        program=f"N10 G1 X5 CHR=1 F100\n{blocks}\nN30 Y5\nN40 M30", alarm="corner-no-move", at=f"MAIN {at}", word=word,
    )
case(
    "a move across the plane between them is not computed", **POLICY, setup=ZERO,
    program="N10 G1 X5 RND=1 F100\nN20 Z5\nN30 Y5\nN40 M30", runs="N10", alarm="code-not-computed", at="MAIN N20", word="Z5",
)
case(
    "straight on there is no corner", **KNOWN, setup=ZERO, program="N10 G1 X5 RND=1 F100\nN20 X9\nN30 Y5\nN40 M30", moves="F X5 Y0\nF X9 Y0\nF X9 Y5",
)
