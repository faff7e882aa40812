"""SINUMERIK: frames of the program, settable zero points, machine coordinates, tools."""

from conformance import case

ONE = "siemens-one"
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}
GROUPS = {"control": ONE, "source": "NCI, ggroups.json: the G groups of the manual", "evidence": "secondary"}
TABLE = {"control": ONE, "source": "NCI, trans.mpf, trans2.mpf, trans_ic.mpf and trans_reset.mpf with their tables", "evidence": "secondary"}
POLICY = {"control": ONE, "source": "policy, not computed is said", "evidence": "inferred"}
ZERO = {"work_offsets": {"G54": {"X": 100.125, "Y": 20.25, "Z": -40.5}}, "start": {"X": 0, "Y": 0, "Z": 0}}
PLAIN = {"start": {"X": 0, "Y": 0, "Z": 0}}

# ---- TRANS and ATRANS ----

case(
    "TRANS shifts what is programmed, and ATRANS adds to the shift", pins="g_meanings:TRANS=frame-shift", **TABLE, setup=ZERO,
    program="N10 G0 X1 Y1\nN20 TRANS X100 Y2\nN30 X1 Y1\nN40 ATRANS X50 Y2\nN50 X1 Y1\nN60 M30",
    moves="R X1 Y1\nR X1 Y1\nR X1 Y1", final_machine="X251.125 Y25.25 Z-40.5",
)
case(
    "TRANS puts its shift in the place of the one before, on axes that it does not name too", **TABLE, setup=ZERO,
    program="N10 TRANS X100 Y20\nN20 TRANS X10\nN30 G0 X3 Y3\nN40 M30", final_machine="X113.125 Y23.25 Z-40.5",
)
for word in ("TRANS", "ROT", "SCALE", "MIRROR"):
    case(
        f"a bare {word} takes the whole frame of the program away", **TABLE, setup=ZERO,
        program=f"N10 TRANS X100 Y20\nN20 AROT Z90\nN30 {word}\nN40 G0 X4 Y5\nN50 M30", moves="R X4 Y5", final_machine="X104.125 Y25.25 Z-40.5",
    )
case(
    "ROT takes the shift away too", pins="g_meanings:ROT=frame-rotation", **KNOWN, setup=ZERO,
    program="N10 TRANS X10\nN20 ROT Z90\nN30 G0 X1 Y2\nN40 M30", final_machine="X98.125 Y21.25 Z-40.5",
)
case(
    "an increment after TRANS moves by the shift too", pins="shifts_move_increments", **TABLE, setup=ZERO,
    program="N10 G0 X1\nN20 TRANS X100\nN30 X=IC(1)\nN40 X=IC(2)\nN50 G91 X3\nN60 M30",
    moves_x=[1, 2, 4, 7], final_machine="X207.125 Y20.25 Z-40.5",
)
case(
    "an axis without a word stays where it is when the frame changes", **KNOWN, setup=ZERO,
    program="N10 G0 X1 Y1\nN20 TRANS X100 Y50\nN30 X1\nN40 M30", final_machine="X201.125 Y21.25 Z-40.5",
)
case(
    "TRANS counts in the unit in force, by expressions, and shifts rotary axes", **KNOWN, setup=PLAIN,
    program="N10 R1=1\nN20 G70\nN30 TRANS X=R1+1 A=15\nN40 G0 X0\nN50 G53 A30\nN60 M30", moves="R X0\nR A15", final_machine="X50.8 Y0 Z0",
)
case(
    "TRANS does not move", **KNOWN, program="N10 TRANS X5\nN20 M30", moves="none", runs="N10 N20",
)
case(
    "two frames in a block", **GROUPS, program="N10 TRANS X5 ROT Z5\nN20 M30", runs="", alarm="group-given-twice", number="12060", at="MAIN N10", word="ROT",
)
case(
    "a frame while a radius is compensated is not computed", **KNOWN, setup={"tools": {1: {"R": 5}}, **PLAIN},
    program="N10 T1 M6\nN20 G41 G1 X10 Y10 F100\nN30 X20\nN40 TRANS X5\nN50 M30", runs="N10 N20 N30", alarm="code-not-computed", at="MAIN N40", word="TRANS",
)

# ---- ROT, SCALE, MIRROR ----

case(
    "AROT turns about the shifted zero point", pins="g_meanings:AROT=frame-rotation-added", **KNOWN, setup=ZERO,
    program="N10 TRANS X10 Y5\nN20 AROT Z90\nN30 G0 X3 Y1\nN40 X=IC(2)\nN50 M30",
    final_machine="X109.125 Y30.25 Z-40.5",
)
case(
    "RPL turns in the plane", pins="rotation_words", control=ONE, source="NCI grammar: RPL", evidence="secondary", setup=PLAIN,
    program="N10 G18\nN20 ROT RPL=90\nN30 G0 Z10 X2\nN40 M30", final_machine="X10 Y0 Z-2",
)
case(
    "ATRANS after AROT shifts in the turned coordinates", pins="g_meanings:ATRANS=frame-shift-added", **KNOWN, setup=ZERO,
    program="N10 ROT Z90\nN20 ATRANS X10\nN30 G0 X1 Y2\nN40 M30", final_machine="X98.125 Y31.25 Z-40.5",
)
case(
    "three angles turn about Z, then the new Y, then the new X", **KNOWN, setup=PLAIN,
    program="N10 ROT X90 Y90 Z90\nN20 G0 X1 Y2 Z3\nN30 M30", final_machine="X3 Y2 Z-1",
)
case(
    "a line goes in a tilted frame", **KNOWN, setup=PLAIN,
    program="N10 ROT X90\nN20 G1 X1 Y2 Z3 F100\nN30 M30", moves="F X1 Y-3 Z2",
)
case(
    "an arc in a tilted frame is not computed", **KNOWN, setup=PLAIN,
    program="N10 ROT X90\nN20 G2 X10 Y0 I5 J0 F100\nN30 M30", runs="N10", alarm="code-not-computed", at="MAIN N20", word="G2",
)
case(
    "arcs turn with the frame", **KNOWN, setup=ZERO,
    program="N10 TRANS X10\nN20 AROT Z90\nN30 G0 X0 Y0\nN40 G2 X10 Y0 I5 J0 F100\nN50 G3 X0 Y0 CR=5\nN60 M30",
    moves="R X0 Y0\nCW X0 Y10 C X0 Y5\nCCW X0 Y0 C X0 Y5", final_machine="X110.125 Y20.25 Z-40.5",
)
case(
    "SCALE makes lengths and radii longer", pins="g_meanings:ASCALE=frame-scale-added", **KNOWN, setup=ZERO,
    program="N10 TRANS X10\nN20 ASCALE X2 Y2\nN30 G0 X1 Y0\nN40 G2 X11 Y0 CR=5 F100\nN50 G2 X1 Y0 I-5 J0\nN60 M30",
    moves="R X2 Y0\nCW X22 Y0 C X12 Y0\nCW X2 Y0 C X12 Y0", final_machine="X112.125 Y20.25 Z-40.5",
)
case(
    "an arc is not computed where the axes of its plane have scales of their own", pins="g_meanings:SCALE=frame-scale", **KNOWN, setup=PLAIN,
    program="N10 SCALE X2\nN20 G1 X3 Y1 F100\nN30 G2 X10 Y0 CR=50\nN40 M30", moves="F X6 Y1", alarm="code-not-computed", at="MAIN N30", word="G2",
)
case(
    "a factor of 0 is refused", **KNOWN, program="N10 SCALE X0\nN20 M30", runs="", alarm="scale-zero", at="MAIN N10", word="X0",
)
case(
    "MIRROR changes the direction of arcs", pins="g_meanings:MIRROR=frame-mirror", **KNOWN, setup=ZERO,
    program="N10 MIRROR X0\nN20 G0 X0 Y0\nN30 G2 X10 Y0 I5 J0 F100\nN40 M30",
    moves="R X0 Y0\nCCW X-10 Y0 C X-5 Y0", final_machine="X90.125 Y20.25 Z-40.5",
)
case(
    "AMIRROR mirrors at the shifted zero point", pins="g_meanings:AMIRROR=frame-mirror-added", **KNOWN, setup=ZERO,
    program="N10 TRANS X10\nN20 AMIRROR X0 Y0\nN30 G0 X1 Y2\nN40 M30", final_machine="X109.125 Y18.25 Z-40.5",
)

case(
    "a mirror changes the side of a compensated radius", **KNOWN, setup={"tools": {1: {"R": 5}}, **ZERO},
    program="N10 T1 M6\nN20 MIRROR X0\nN30 G41 G1 X10 Y10 F100\nN40 Y30\nN50 X40\nN60 G40 X50 Y50\nN70 M30", time=52.237,
)
case(
    "a scale makes corners larger", **KNOWN, setup=ZERO,
    program="N10 SCALE X2 Y2\nN20 G1 X10 Y0 RND=1 F100\nN30 Y10\nN40 M30", moves="F X18 Y0\nCCW X20 Y2 C X18 Y2\nF X20 Y20",
)
case(
    "a value that is too large is out of range, not beyond all numbers", **KNOWN, setup=ZERO,
    program="N10 SCALE X1EX30 Y1EX30\nN20 ASCALE X1EX30 Y1EX30\nN30 G0 X1\nN40 M30", runs="N10", alarm="value-out-of-range", at="MAIN N20",
)

# ---- G54, G500, G505, G53, G153, SUPA ----

SYSTEMS = {
    "work_offsets": {
        "G54": {"X": 100.125}, "G505": {"X": 5.5}, "G599": {"X": 599.5}, "EXT": {"X": 1000, "Y": 7},
    },
    "tools": {1: {"Z": 50.25}},
    **PLAIN,
}
case(
    "G505 to G599 are zero points too, and G500 is none", pins="max_extra_systems g_meanings:500=extra-system-100", **GROUPS,
    setup=SYSTEMS,
    program="N10 G505 G0 X1\nN20 G599 X1\nN30 G500 X1\nN40 M30", moves_x=[1, 1, 1], final_machine="X1001 Y7 Z0",
)
case(
    "G599 is the last of them", pins="extra_system_codes", **GROUPS, setup=SYSTEMS, program="N10 G599 G0 X1\nN20 M30", final_machine="X1600.5 Y7 Z0",
)
case(
    "a zero point leaves the frame of the program in force", **KNOWN, setup=SYSTEMS,
    program="N10 TRANS X10\nN20 G505 G0 X1\nN30 M30", final_machine="X1016.5 Y7 Z0",
)
case(
    "G53 leaves out the zero point and the frame of its block, and no basic frame", pins="machine_move", **KNOWN, setup=SYSTEMS,
    program="N10 TRANS X10\nN20 G53 G0 X1\nN30 M30", final_machine="X1001 Y7 Z0",
)
for word, pin in (("G153", "153=machine-all"), ("SUPA", "SUPA=machine-all")):
    case(
        f"{word} leaves out the basic frame too, and the length of the tool stays on", pins=f"g_meanings:{pin}", **KNOWN, setup=SYSTEMS,
        program=f"N10 TRANS X10\nN20 T1 M6\nN30 G0 {word} X1 Z2\nN40 X1\nN50 M30", final_machine="X1111.125 Y7 Z52.25",
    )
for word in ("G53", "G153", "SUPA"):
    for motion in ("G2 X5 CR=5", "G3 I3", "CIP X5 Y5 I1=3 J1=4", "CT X5 Y6", "G33 Z-5 K1", "G1 RP=5 AP=30"):
        case(
            f"{word} {motion} is not computed: the move is no line between points of axes", **POLICY, setup=ZERO,
            program=f"N10 G1 X0 Y0 F100 S100 M3\nN20 {word} {motion}\nN30 M30", runs="N10", alarm="code-not-computed", at="MAIN N20", word=word,
        )
    case(
        f"{word} while an arc is in force is not computed", **POLICY, setup=ZERO,
        program=f"N10 G1 X0 Y0 F100\nN20 G2 X10 CR=5\nN30 {word} X5\nN40 M30", runs="N10 N20", alarm="code-not-computed", at="MAIN N30", word=word,
    )
    case(
        f"{word} without an axis moves nothing, whatever code is in force", **KNOWN, setup=ZERO,
        program=f"N10 G1 X0 Y0 F100\nN20 G2 X10 CR=5\nN30 {word}\nN40 M30", runs="N10 N20 N30 N40", final_work="X10 Y0 Z0",
    )
case(
    "D0 takes the length away in a block of SUPA", **KNOWN, setup=SYSTEMS,
    program="N10 T1 M6\nN20 G0 SUPA Z2 D0\nN30 M30", final_machine="X1100.125 Y7 Z2",
)
case(
    "G74 and G75 go to the points by the axes that they name", pins="g_meanings:74=reference-direct", **KNOWN,
    setup={"reference": {1: {"X": 500, "Y": 400, "Z": 300}, 2: {"X": 50, "Y": 40, "Z": 30}}, **ZERO},
    program="N10 G74 X1=0 Z1=0\nN20 M30", final_machine="X500 Y20.25 Z300",
)
case(
    "G75 goes to the fixed point", pins="g_meanings:75=second-reference-direct", **KNOWN,
    setup={"reference": {1: {"X": 500, "Y": 400, "Z": 300}, 2: {"X": 50, "Y": 40, "Z": 30}}, **ZERO},
    program="N10 TRANS X5\nN20 G75 X0 Y0\nN30 M30", final_machine="X50 Y40 Z-40.5",
)

# ---- tools ----

TOOLS = {"tools": {1: {"Z": 50.25, "R": 5}, 2: {"Z": 70.5}}, **ZERO}
case(
    "a tool comes with its first edge, whose length counts from the next move along its axis", **KNOWN, setup=TOOLS,
    program="N10 G0 X1 Z1\nN20 T1\nN30 M6\nN40 X2\nN50 M30", final_machine="X102.125 Y20.25 Z-39.5",
)
case(
    "the length is in the machine position", pins="tool_edges", **KNOWN, setup=TOOLS,
    program="N10 T1 M6\nN20 G0 Z1\nN30 T2 M6\nN40 Z1\nN50 M30", moves="R Z1\nR Z1", final_machine="X100.125 Y20.25 Z31",
)
case(
    "D0 takes the length away, and D1 brings it back", **KNOWN, setup=TOOLS,
    program="N10 T1 M6\nN20 D0 G0 Z1\nN30 D1 Z1\nN40 M30", final_machine="X100.125 Y20.25 Z10.75",
)
case(
    "an increment after a change of the tool moves by its length too", **KNOWN, setup=TOOLS,
    program="N10 G0 Z1\nN20 T1 M6\nN30 G91 Z1\nN40 M30", moves="R Z1\nR Z2", final_machine="X100.125 Y20.25 Z11.75",
)
case(
    "lengths and radii by the number of the tool count where the table has none", **KNOWN,
    setup={"length_offsets": {1: 12.5}, "radius_offsets": {1: 2.5}, **ZERO},
    program="N10 T1 D1 M6\nN20 G18 G0 Y1\nN30 M30", final_machine="X100.125 Y33.75 Z-40.5",
)
case(
    "a second edge of a tool is not computed", **KNOWN, setup=TOOLS,
    program="N10 T1 M6\nN20 D2\nN30 M30", runs="N10", alarm="code-not-computed", at="MAIN N20", word="D2",
)
case(
    "an edge has a number from 0", pins="max_offset_number", **KNOWN,
    program="N10 T1 M6\nN20 D10000\nN30 M30", runs="N10", alarm="offset-number", at="MAIN N20", word="D10000",
)

# ---- ends ----

case(
    "SAVE of a PROC brings the frame of the caller back", **KNOWN, setup=ZERO,
    program="%_N_MAIN_MPF\nN10 TRANS X10\nN20 SUB1\nN30 G0 X1\nN40 M30\n"
    "%_N_SUB1_SPF\nPROC SUB1 SAVE\nN10 TRANS X50 Y5\nN20 AROT Z90\nN30 G0 X3 Y4\nN40 RET",
    final_machine="X111.125 Y28.25 Z-40.5",
)
case(
    "without SAVE the frame of the subprogram stays", **KNOWN, setup=ZERO,
    program="%_N_MAIN_MPF\nN10 TRANS X10\nN20 SUB1\nN30 G0 X1\nN40 M30\n%_N_SUB1_SPF\nPROC SUB1\nN10 TRANS X50 Y5\nN20 RET",
    final_machine="X151.125 Y20.25 Z-40.5",
)
