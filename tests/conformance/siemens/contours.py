"""SINUMERIK: roundings of all corners, feeds of corners, allowances beside the contour, coarse and fine shifts."""

from conformance import case

ONE = "siemens-one"
ALL = ["siemens-one", "siemens-828d", "siemens-840d-sl"]
ROUND = {"control": ALL, "source": "840Df p.193: RNDM", "evidence": "secondary"}
FEED = {"control": ALL, "source": "840Df p.193: FRC and FRCM", "evidence": "secondary"}
NEXT = {"control": ALL, "source": "CNCF, the feed of the block that leads away; MD840, MD 20201", "evidence": "secondary"}
OFFSET = {"source": "SONE p.251: OFFN", "evidence": {"siemens-one": "maker's manual", "siemens-828d": "secondary", "siemens-840d-sl": "secondary"}, "control": ALL}
SHIFT = {"source": "SONE p.315: TRANS, ATRANS, G58 and G59", "evidence": {"siemens-one": "maker's manual", "siemens-828d": "secondary", "siemens-840d-sl": "secondary"}, "control": ALL}
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}
POLICY = {"control": ONE, "source": "policy, not computed is said", "evidence": "inferred"}
ZERO = {"work_offsets": {"G54": {"X": 100.125, "Y": 20.25, "Z": -40.5}}, "start": {"X": 0, "Y": 0, "Z": 0}}
TOOL = {"tools": {1: {"R": 5, "Z": 12.5}}, **ZERO}

# ---- RNDM ----

case(
    "RNDM rounds the corner after its block and those after it, up to the block with RNDM=0", pins="modal_round_words", **ROUND, setup=ZERO,
    program="N10 G1 X20 Y0 RNDM=2 F100\nN20 Y20\nN30 X0 RNDM=0\nN40 Y0\nN50 M30",
    moves="F X18 Y0\nCCW X20 Y2 C X18 Y2\nF X20 Y18\nCCW X18 Y20 C X18 Y18\nF X0 Y20\nF X0 Y0", final_machine="X100.125 Y20.25 Z-40.5",
)
case(
    "it may stand alone, and rounds corners of arcs too", **ROUND, setup=ZERO,
    program="N10 RNDM=2\nN20 G1 X20 Y0 F100\nN30 G3 X20 Y20 I0 J10 RNDM=0\nN40 M30",
    moves="F X20 Y0\nCCW X20 Y20 C X20 Y10",
)
case(
    "a chamfer or a rounding of its own comes before it", **KNOWN, setup=ZERO,
    program="N10 RNDM=2\nN20 G1 X20 Y0 CHR=1 F100\nN30 Y20 RND=3\nN40 X0 RND=0\nN50 Y5 RNDM=0\nN60 X-5\nN70 M30",
    moves="F X19 Y0\nF X20 Y1\nF X20 Y17\nCCW X17 Y20 C X17 Y17\nF X0 Y20\nF X0 Y5\nF X-5 Y5",
)
case(
    "it counts in inches, in increments, in another plane and in the frame", **KNOWN, setup=ZERO,
    program="N10 TRANS X1\nN20 ASCALE X2 Z2\nN30 G18 G91 G70\nN40 G1 Z1 RNDM=0.1 F10\nN50 X1 RNDM=0\nN60 M30",
    moves="F X-1 Z45.72\nCCW X4.08 Z50.8 C X4.08 Z45.72\nF X50.8 Z50.8", final_machine="X151.925 Y20.25 Z10.3",
)
case(
    "a radius is compensated on its corners", **KNOWN, setup=TOOL,
    program="N10 T1 M6\nN20 G41 G1 X0 Y0 F100\nN30 X30 RNDM=8\nN40 Y30 RNDM=0\nN50 X20\nN60 G40 G1 X0 Y40\nN70 M30", final_machine="X100.125 Y60.25 Z-40.5",
)
case(
    "the last side before the end of the program has no corner", **KNOWN, setup=ZERO,
    program="N10 RNDM=2\nN20 G1 X20 F100\nN30 M30", moves="F X20 Y0",
)
case(
    "nor has the one before RNDM=0 and a rapid move", **KNOWN, setup=ZERO,
    program="N10 G1 X20 RNDM=2 F100\nN20 Y20\nN30 RNDM=0\nN40 G0 Z50\nN50 X0\nN60 M30",
    moves="F X18 Y0\nCCW X20 Y2 C X18 Y2\nF X20 Y20\nR X20 Y20 Z50\nR X0 Y20 Z50",
)
case(
    "a move across the plane before the first side makes no corner", **KNOWN, setup=ZERO,
    program="N10 RNDM=2\nN20 G1 Z-5 F100\nN30 X20\nN40 Y20 RNDM=0\nN50 X0\nN60 M30", moves="F Z-5\nF X18 Y0\nCCW X20 Y2 C X18 Y2\nF X20 Y20\nF X0 Y20",
)
case(
    "blocks without a move may stand between the sides", **KNOWN, setup=ZERO,
    program="N10 G1 X20 RNDM=2 F100\nN20 S500\nN30 M8\nN40 Y20 RNDM=0\nN50 M30", moves="F X18 Y0\nCCW X20 Y2 C X18 Y2\nF X20 Y20",
)
case(
    "sides in one line have none", **KNOWN, setup=ZERO, program="N10 G1 X5 RNDM=1 F100\nN20 X9\nN30 Y5 RNDM=0\nN40 M30", moves="F X5 Y0\nF X8 Y0\nCCW X9 Y1 C X8 Y1\nF X9 Y5",
)
for blocks, at in (
    ("N20 G0 Y20", "N20"), ("N20 Z5", "N20"), ("N20 RNDM=0\nN30 Y20", "N30"), ("N20 T2\nN30 Y20", "N20"), ("N20 M0\nN30 Y20", "N20"), ("N20 G64\nN30 Y20", "N20"),
):
    case(
        f"{blocks[4:].replace(chr(10), ', ')} after a side is not computed", **POLICY, setup=ZERO,
        program=f"N10 G1 X20 RNDM=2 F100\n{blocks}\nN40 M30", alarm="code-not-computed", at=f"MAIN {at}", runs="N10" if at == "N20" else "N10 N20",
    )
case(
    "nor a rapid side", **POLICY, setup=ZERO, program="N10 RNDM=2\nN20 G0 X20\nN30 G1 Y20 F100\nN40 M30", alarm="code-not-computed", at="MAIN N30", runs="N10 N20",
)
for word in ("RNDM", "RND", "CHR", "CHF"):
    case(
        f"{word} that its sides have no room for is made smaller, and by how much is not computed", pins="corner_reduced" if word == "RND" else "", control=ONE,
        source="CNCF, a value that a block has no room for", evidence="secondary", setup=ZERO,
        program=f"N10 G1 X5 {word}=20 F100\nN20 Y5 RNDM=0\nN30 M30", alarm="code-not-computed", at="MAIN N10", runs="N10", word=f"{word}=20" if word != "RNDM" else None,
    )
case(
    "RNDM is not below 0", **KNOWN, program="N10 RNDM=-1\nN20 M30", runs="", alarm="value-out-of-range", at="MAIN N10", word="RNDM=-1",
)
case("RNDM needs =", **KNOWN, program="N10 RNDM 2\nN20 M30", runs="", alarm="missing-equals", number="12080", at="MAIN N10")
case(
    "of a chamfer and a rounding in one block the rounding is made", pins="round_before_chamfer", control=ALL, source="808Dm p.89: radius and chamfer in one block",
    evidence="secondary", setup=ZERO, program="N10 G1 X20 CHR=5 RND=2 F100\nN20 Y20\nN30 M30", moves="F X18 Y0\nCCW X20 Y2 C X18 Y2\nF X20 Y20", dropped=["CHR=5"],
)

case(
    "a chamfer between rapid moves is one too", pins="corners_in_rapid", control=ALL, source="CNCF, a chamfer that is traversed with G0", evidence="secondary", setup=ZERO,
    program="N10 G0 X20 CHR=2\nN20 Y20\nN30 M30", moves="R X18 Y0\nR X20 Y2\nR X20 Y20",
)
for first, second, word in (("G0 X20 RND=2", "G0 Y20", "RND=2"), ("G0 X20 CHR=2", "G1 Y20 F100", "CHR=2"), ("G1 X20 CHF=2 F100", "G0 Y20", "CHF=2")):
    case(
        f"{word} between {first[:2]} and {second[:2]} is not computed", **POLICY, setup=ZERO, program=f"N10 {first}\nN20 {second}\nN30 M30", runs="N10", alarm="code-not-computed", at="MAIN N10", word=word,
    )
case("a second chamfer in a block is dropped", **POLICY, setup=ZERO, program="N10 G1 X20 CHR=1 CHF=2 F100\nN20 Y20\nN30 M30", moves="F X19 Y0\nF X20 Y1\nF X20 Y20", dropped=["CHF=2"])

# ---- FRC, FRCM ----

case(
    "FRC is the feed of the corner after its block, FRCM that of all", pins="corner_feed_words modal_corner_feed_words", **FEED, setup=ZERO,
    program="N10 G1 X20 Y0 CHF=2 FRC=30 F60\nN20 Y20 CHF=2 FRCM=40\nN30 X0 CHF=2\nN40 Y0 CHF=2 FRCM=0\nN50 X-10\nN60 M30",
    time=90.686,
)
case(
    "without them it is that of the block that leads away", pins="corner_feed_of_next", **NEXT, setup=ZERO,
    program="N10 G1 X20 Y0 CHF=2 F60\nN20 Y20 F120\nN30 M30", time=28.879,
)
case(
    "by machine datum 20201 that of the block before", **NEXT, setup=ZERO, params={"20201#0": 1},
    program="N10 G1 X20 Y0 CHF=2 F60\nN20 Y20 F120\nN30 M30", time=29.879,
)
case("FRC without a corner is dropped", **POLICY, setup=ZERO, program="N10 G1 X20 FRC=30 F60\nN20 M30", moves="F X20 Y0", dropped=["FRC=30"])
for word in ("FRC=0", "FRC=-5", "FRCM=-1"):
    case(
        f"{word} is out of range", **KNOWN, program=f"N10 G1 X5 F100 RND=1 {word}\nN20 Y5\nN30 M30", runs="", alarm="value-out-of-range", at="MAIN N10", word=word,
    )

# ---- OFFN ----

case(
    "OFFN is added to the compensated radius", pins="contour_offset_words", **OFFSET, setup=TOOL,
    program="N10 T1 M6\nN20 G41 G1 X10 Y10 OFFN=1 F100\nN30 X30\nN40 X31\nN50 M30", final_machine="X131.125 Y36.25 Z-40.5",
)
case(
    "to the right too, in another plane, in inches, and from a block of its own", **KNOWN, setup=TOOL,
    program="N10 T1 M6\nN20 G70 OFFN=0.1\nN30 G18 G42 G1 Z1 X1 F10\nN40 Z2\nN50 Z3\nN60 M30", final_machine="X117.985 Y20.25 Z35.7",
)
case(
    "below 0 it lessens it, without compensation it changes nothing, and OFFN=0 takes it away", **KNOWN, setup=TOOL,
    program="N10 T1 M6\nN20 OFFN=-1\nN30 G0 X5 Y1\nN40 G41 G1 X10 Y10 F100\nN50 X30\nN60 G40 Y30\nN70 G41 OFFN=0 X40\nN80 X60\nN90 X61\nN100 M30",
    final_machine="X161.125 Y55.25 Z-40.5",
)
case("it comes to its place over the block that changes it", **KNOWN, setup=TOOL,
    program="N10 T1 M6\nN20 G41 G1 X10 Y10 OFFN=1 F100\nN30 X30\nN40 X50 OFFN=2\nN50 X51\nN60 M30", final_machine="X151.125 Y37.25 Z-40.5",
)
case("OFFN needs =", **KNOWN, program="N10 OFFN 2\nN20 M30", runs="", alarm="missing-equals", number="12080", at="MAIN N10")

# ---- G58, G59 ----

case(
    "G58 changes the absolute part of the shift and G59 the added part, on the axes that they name", **SHIFT, pins="g_meanings:58=frame-shift-by-axis g_meanings:59=frame-fine-shift-by-axis",
    setup=ZERO, params={"24000": 1},
    program="N10 TRANS X10 Y10 Z10\nN20 ATRANS X5 Y5\nN30 G0 X0 Y0 Z0\nN40 G58 X20\nN50 X0 Y0 Z0\nN60 G59 X10 Y10\nN70 X0 Y0 Z0\nN80 R1=$P_PFRAME[X,TR] R2=$P_PFRAME[X,FI] R3=$P_PFRAME[Y,FI]\nN90 M30",
    final_machine="X130.125 Y40.25 Z-30.5", vars={1: 20, 2: 10, 3: 10},
)
case(
    "TRANS leaves the added part alone, and alone in its block takes all away", **KNOWN, setup=ZERO, params={"24000": 1},
    program="N10 TRANS X10\nN20 ATRANS X5\nN30 TRANS X20\nN40 R1=$P_PFRAME[X,TR] R2=$P_PFRAME[X,FI]\nN50 TRANS\nN60 G0 X1\nN70 M30", vars={1: 20, 2: 5}, final_machine="X101.125 Y20.25 Z-40.5",
)
case(
    "they stand in the turned frame, count in inches, and G91 counts on", **KNOWN, setup=ZERO, params={"24000": 1},
    program="N10 ROT Z90\nN20 ATRANS X2 Y1\nN30 G59 X4\nN40 G70\nN50 G58 Y1\nN60 G0 X0 Y0\nN70 G91 X1\nN80 M30", final_machine="X104.125 Y73.05 Z-40.5",
)
case(
    "the added shift is a part of the absolute one as delivered", pins="fine_shift", control=ONE, source="MD840, MD 24000", evidence="secondary", setup=ZERO,
    program="N10 TRANS X10\nN20 ATRANS X5\nN30 R1=$P_PFRAME[X,TR] R2=$P_PFRAME[X,FI]\nN40 M30", vars={1: 15, 2: 0},
)
for code in ("G58", "G59"):
    case(
        f"{code} is refused then", control=ALL, source="MD840, MD 24000: G58 and G59 are not possible", evidence="secondary",
        program=f"N10 {code} X5\nN20 M30", runs="", alarm="fine-shift-off", at="MAIN N10", word=code,
    )
    case(
        f"{code} while a radius is compensated is not computed", **POLICY, setup=TOOL, params={"24000": 1},
        program=f"N10 T1 M6\nN20 G41 G1 X10 Y10 F100\nN30 X20\nN40 {code} X5\nN50 M30", runs="N10 N20 N30", alarm="code-not-computed", at="MAIN N40", word=code,
    )
    case(f"{code} beside TRANS", **KNOWN, program=f"N10 {code} X5 TRANS Y5\nN20 M30", runs="", alarm="group-given-twice", number="12060", at="MAIN N10", word="TRANS")

# ---- CIP ----

CIP = {"source": "SONE p.198: a parameter of value 0 may be left out", "evidence": "maker's manual", "control": ONE}
case(
    "of the point between one axis of the plane may be left out where it is 0", **CIP, setup=ZERO,
    program="N10 G0 X-5 Y3 Z2\nN20 CIP X5 Y3 J1=8 F100\nN30 G91 CIP X10 Y10 I1=10\nN40 M30",
    moves="R X-5 Y3 Z2\nCW X5 Y3 C X0 Y3\nCCW X15 Y13 C X10 Y8",
)
case(
    "in another plane too", **CIP, setup=ZERO, program="N10 G18 G0 X0 Z-5\nN20 CIP X0 Z5 I1=5 F100\nN30 M30", moves="R X0 Z-5\nCW X0 Z5 C X0 Z0",
)
case(
    "where it is left out beside the axis across the plane and the tool does not stand at 0, the arc is not computed", **POLICY, setup=ZERO,
    program="N10 G0 X-5 Y3\nN20 CIP X5 Y3 I1=0 K1=5 F100\nN30 M30", runs="N10", alarm="code-not-computed", at="MAIN N20",
)
