"""SINUMERIK: system variables, as far as a run knows them."""

from datetime import datetime

from conformance import case

ONE = "siemens-one"
PEER = {"control": ONE, "source": "NCI, actual_position.mpf", "evidence": "secondary"}
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}
POLICY = {"control": ONE, "source": "policy, a run does not know it", "evidence": "inferred"}
OFFSETS = {"setup": {"work_offsets": {"G54": {"X": 100.125, "Y": -20.25, "Z": 3.375}}}}

case(
    "$AA_IW is the position in the workpiece and $AA_IM that of the machine", **PEER, **OFFSETS,
    program="N10 G54 G0 X10 Y20 Z5\nN20 R1=$AA_IW[X] R2=$AA_IM[X] R3=$AA_IW[Y] R4=$AA_IM[Y] R5=$AA_IW[Z] R6=$AA_IM[Z]\nN30 M30",
    vars={1: 10, 2: 110.125, 3: 20, 4: -0.25, 5: 5, 6: 8.375},
)
case(
    "a loop ends by the height that is reached", **PEER,
    program="N10 DEF REAL LAYER=2\nN20 G1 F1000 X0 Y0 Z0\nN30 REPEAT\nN40 X=$AA_IW[X]+10\nN50 Z=$AA_IW[Z]+LAYER\nN60 UNTIL $AA_IW[Z]>(9-0.05)\nN70 M30",
    final_work="X50 Y0 Z10",
)
case(
    "the axis may be that of a variable", **KNOWN,
    program="N10 DEF AXIS WAY=Y\nN20 G0 X1 Y2 Z3\nN30 R1=$AA_IW[WAY]\nN40 WAY=Z\nN50 R2=$AA_IW[WAY]\nN60 M30", vars={1: 2, 2: 3},
)
case(
    "$P_EP is the end of the block before in the workpiece", **KNOWN, **OFFSETS,
    program="N10 G54 G0 X10\nN20 X=$P_EP[X]+5\nN30 R1=$P_EP[X]\nN40 M30", vars={1: 15}, moves="R X10\nR X15",
)
case(
    "$P_TOOLNO and $P_F are the tool and the feed that were programmed", **KNOWN,
    program="N10 T12 M6\nN20 G1 X1 F250\nN30 R1=$P_TOOLNO R2=$P_F\nN40 M30", vars={1: 12, 2: 250},
)
case(
    "$PI is the number", **KNOWN, program="N10 R1=ROUND($PI*1EX6)\nN20 M30", vars={1: 3141593},
)
case(
    "$A_IN reads an input of the machine", **KNOWN,
    program="N10 R1=$A_IN[3] R2=$A_IN[4]\nN20 IF $A_IN[3]\nN30 R3=1\nN40 ENDIF\nN50 M30",
    inputs={"signals": {2000001003: 1}}, vars={1: 1, 2: 0, 3: 1},
)
case(
    "an output that nothing writes is off", **KNOWN, program="N10 R1=$A_OUT[1]\nN20 M30", vars={1: 0},
)
case(
    "date and time are those of the run", **KNOWN,
    program="N10 R1=$A_MONTH R2=$A_DAY R3=$A_HOUR R4=$A_MINUTE R5=$A_SECOND\nN20 M30",
    inputs={"clock": datetime(2024, 2, 29, 13, 45, 7)}, vars={1: 2, 2: 29, 3: 13, 4: 45, 5: 7},
)
for wrong in ("$AA_IW[1]", "$A_IN[X]"):
    case(
        f"{wrong} has another index", **KNOWN,
        program=f"N10 R1={wrong}\nN20 M30", runs="", alarm="type-mismatch", number="12150", at="MAIN N10",
    )
case(
    "an index beyond the last is refused", **KNOWN,
    program="N10 R1=$A_IN[1025]\nN20 M30", runs="", alarm="array-element", number="12400", at="MAIN N10",
)
case(
    "$AA_IW has an index", **KNOWN,
    program="N10 R1=$AA_IW\nN20 M30", runs="", alarm="bracket-not-opened", number="12080", at="MAIN N10",
)
for name in ("$MN_SCALING_SYSTEM_IS_METRIC", "$MC_GMMC_INFO_UNIT_IS_STATUS", "$AC_TIME", "$P_CHBFR[0,X,TR]", "$AA_IB[X]"):
    case(
        f"a run does not know {name}", **POLICY,
        program=f"N10 R1={name}\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10",
    )
    case(
        f"nor what writing {name} does", **POLICY,
        program=f"N10 {name}=5\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10",
    )

# ---- markers, parameters and outputs that a program writes ----

case(
    "markers and parameters of the channel are variables of all programs, 0 at first", **KNOWN,
    program="N10 R1=$AC_MARKER[0] R2=$AC_PARAM[49]\nN20 $AC_MARKER[0]=7\nN30 $AC_PARAM[49]=2.5\nN40 SUB\nN50 R4=$AC_PARAM[R5+49]\nN60 M30\n%_N_SUB_SPF\nR3=$AC_MARKER[0]+1\n$AC_PARAM[49]=$AC_PARAM[49]*2\nM17",
    vars={1: 0, 2: 0, 3: 8, 4: 5},
)
case(
    "a marker is a whole number", **KNOWN,
    program="N10 $AC_MARKER[1]=2.6\nN20 R1=$AC_MARKER[1]\nN30 M30", vars={1: 3},
)
for wrong in ("$AC_MARKER[8]=1", "$AC_PARAM[50]=1", "$AC_MARKER[-1]=1", "$A_OUT[1025]=1"):
    case(
        f"there is none by this index: {wrong}", **KNOWN,
        program=f"N10 {wrong}\nN20 M30", runs="", alarm="array-element", number="12400", at="MAIN N10",
    )
case(
    "an output that a program writes is read again", **KNOWN,
    program="N10 $A_OUT[3]=1\nN20 R1=$A_OUT[3] R2=$A_OUT[2]\nN30 $A_OUT[3]=FALSE\nN40 R3=$A_OUT[3]\nN50 M30", vars={1: 1, 2: 0, 3: 0},
)
case(
    "a marker beside its own assignment is not computed", **POLICY,
    program="N10 $AC_MARKER[1]=1 R1=$AC_MARKER[1]\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10",
)
case(
    "$P_TOOLP is the tool that T names, $P_TOOLNO the one that M6 has changed", **KNOWN,
    program="N10 T3 M6\nN20 T4\nN30 R1=$P_TOOLP R2=$P_TOOLNO\nN40 M6\nN50 R3=$P_TOOLNO\nN60 M30", vars={1: 4, 2: 3, 3: 4},
)

# ---- $P_GG: places in the G groups ----

GROUPS = {"control": ONE, "source": "NCI, ggroups.json", "evidence": "secondary"}
for codes, group, place in (
    ("G0", 1, 1), ("G1", 1, 2), ("G2", 1, 3), ("G3", 1, 4), ("CIP", 1, 5), ("G33", 1, 10), ("G17", 6, 1), ("G19", 6, 3), ("G40", 7, 1),
    ("G500", 8, 1), ("G54", 8, 2), ("G57", 8, 5), ("G505", 8, 6), ("G70", 13, 1), ("G71", 13, 2), ("G700", 13, 3),
    ("G90", 14, 1), ("G91", 14, 2), ("G93", 15, 1), ("G94", 15, 2), ("G95", 15, 3), ("G96 S100", 15, 4), ("G450", 18, 1), ("G451", 18, 2),
    ("DIAMOF", 29, 1), ("DIAMON", 29, 2),
):
    case(
        f"$P_GG[{group}] is {place} after {codes}", **GROUPS,
        program=f"N10 {codes}\nN20 R1=$P_GG[{group}]\nN30 M30", vars={1: place},
    )
case(
    "$P_GG of a group on which no path depends is not known", **POLICY,
    program="N10 R1=$P_GG[10]\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10",
)

# ---- positions in a frame: what is programmed, moved to again, moves nothing ----

TURNED = {"control": ONE, "source": "840Dk p.128: $AA_IW, the setpoint in the workpiece", "evidence": "inferred"}
for frame in ("ROT Z90", "SCALE X2 Y3", "MIRROR X0", "TRANS X7 Y8 Z9", "ROT Z30"):
    case(
        f"$P_EP and $AA_IW count in the frame of {frame}", **TURNED, setup={"work_offsets": {"G54": {"X": 31.5, "Y": 5.25, "Z": -40.5}}},
        program=f"N10 {frame}\nN20 G0 X20 Y5 Z2\nN30 R1=$P_EP[X] R2=$P_EP[Y] R3=$P_EP[Z]\nN40 R4=$AA_IW[X] R5=$AA_IW[Y] R6=$AA_IW[Z]\nN50 M30",
        vars={1: 20, 2: 5, 3: 2, 4: 20, 5: 5, 6: 2},
    )
case(
    "an increment to where the tool stands in a turned frame moves nothing", **TURNED, setup={"work_offsets": {"G54": {"X": 31.5, "Y": 5.25}}},
    program="N10 ROT Z90\nN20 G0 X20 Y5\nN30 X=$P_EP[X] Y=$AA_IW[Y]\nN40 M30", final_machine="X26.5 Y25.25 Z0",
)
