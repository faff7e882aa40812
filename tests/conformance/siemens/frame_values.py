"""SINUMERIK: frames as values: variables, functions, chains and parts, and the frames of the control."""

from conformance import case

ONE = "siemens-one"
FRAMES = {"control": ONE, "source": "SONE p.631-640: frames", "evidence": "secondary"}
STORED = {"control": ONE, "source": "840Dk p.2-58: $P_UIFR and $P_IFRAME; MD840, framevar.svar: the numbers", "evidence": "secondary"}
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}
POLICY = {"control": ONE, "source": "policy, not computed is said", "evidence": "inferred"}
OFFSETS = {"G54": {"X": 100.125, "Y": 20.25, "Z": -40.5}}
ZERO = {"work_offsets": OFFSETS, "start": {"X": 0, "Y": 0, "Z": 0}}
MORE = {"work_offsets": {"EXT": {"X": 1000, "Y": 7}, "G505": {"X": 5.5, "Y": 0.25}, **OFFSETS}, "start": {"X": 0, "Y": 0, "Z": 0}}
TOOL = {"tools": {1: {"R": 5, "Z": 12.5}}, **ZERO}

# ---- $P_UIFR ----

case(
    "$P_UIFR[1] takes effect when a block with G54 comes", pins="written_offset", **STORED, setup=ZERO,
    program="N10 G0 X1 Y1\nN20 $P_UIFR[1]=CTRANS(X,10.5,Y,-2.25,Z,3)\nN30 X2\nN40 R1=$AA_IM[X]\nN50 G54 X3 Y1 Z0\nN60 M30",
    moves_x=[1, 2, 3], vars={1: 102.125}, final_machine="X13.5 Y-1.25 Z3",
)
case(
    "a part of it too, and the other parts stay", **STORED, setup=ZERO,
    program="N10 $P_UIFR[1,X,TR]=7\nN20 G0 X1 Y1\nN30 R1=$AA_IM[X]\nN40 G54 X1 Y1\nN50 M30", vars={1: 101.125}, final_machine="X8 Y21.25 Z-40.5",
)
case(
    "its parts are those of the setup until a program writes them", **STORED, setup=ZERO,
    program="N10 R1=$P_UIFR[1,X,TR] R2=$P_UIFR[1,Z,TR] R3=$P_UIFR[2,X,TR] R4=$P_UIFR[1,X,SC] R5=$P_UIFR[1,Z,RT] R6=$P_UIFR[1,Y,MI] R7=$P_UIFR[1,Y,FI]\nN20 M30",
    vars={1: 100.125, 2: -40.5, 3: 0, 4: 1, 5: 0, 6: 0, 7: 0},
)
case(
    "two parts in a block", **KNOWN, setup=ZERO,
    program="N10 $P_UIFR[2,X,TR]=7 $P_UIFR[2,Y,TR]=8\nN20 G55 G0 X1 Y1 Z0\nN30 M30", final_machine="X8 Y9 Z0",
)
for number, code in ((0, "G500"), (1, "G54"), (2, "G55"), (4, "G57"), (5, "G505"), (99, "G599")):
    case(
        f"$P_UIFR[{number}] is {code}, and $P_UIFRNUM says so", **STORED, setup=ZERO,
        program=f"N10 $P_UIFR[{number}]=CTRANS(X,{number}+0.5,Z,2)\nN20 {code} G0 X1 Y0 Z0\nN30 R1=$P_UIFRNUM\nN40 M30",
        vars={1: number}, final_machine=f"X{number + 1.5} Y0 Z2",
    )
case(
    "another work system in force stays as it is", **STORED, setup=MORE,
    program="N10 G505 G0 X1 Y1\nN20 $P_UIFR[1]=CTRANS(X,3)\nN30 X2\nN40 G505 X3\nN50 M30", final_machine="X1008.5 Y8.25 Z-40.5",
)
case(
    "the basic frame adds to it", **STORED, setup=MORE,
    program="N10 $P_UIFR[1]=CTRANS(X,3,Y,4)\nN20 G54 G0 X1 Y1 Z1\nN30 M30", final_machine="X1004 Y12 Z1",
)
case(
    "the index may be computed", **STORED, setup=ZERO,
    program="N10 DEF INT GX=1\nN20 $P_UIFR[(GX)+1,Y,TR]=R1+7.5\nN30 R2=$P_UIFR[GX+1,Y,TR]\nN40 $P_UIFR[$P_UIFRNUM,X,TR]=$P_UIFR[$P_UIFRNUM,X,TR]+1\nN50 R3=$P_UIFR[1,X,TR]\nN60 M30",
    vars={2: 7.5, 3: 101.125},
)
case(
    "the axis of a part may be that of a variable", **STORED, setup=ZERO,
    program="N10 DEF AXIS WAY=Y\nN20 $P_UIFR[1,WAY,TR]=4\nN30 R1=$P_UIFR[1,Y,TR] R2=$P_UIFR[1,WAY,TR]\nN40 $P_UIFR[1]=CTRANS(WAY,6)\nN50 R3=$P_UIFR[1,Y,TR]\nN60 M30",
    vars={1: 4, 2: 4, 3: 6},
)
case(
    "CTRANS() takes all of it away, rotary axes and the fine shift too", **STORED, setup=ZERO,
    program="N10 $P_UIFR[1]=CTRANS(X,10,A,15):CROT(Z,90):CFINE(Y,1)\nN20 $P_UIFR[1]=CTRANS()\nN30 G54 G0 X1 Y2 Z0 A0\nN40 R1=$P_UIFR[1,Y,FI] R2=$P_UIFR[1,A,TR]\nN50 M30",
    vars={1: 0, 2: 0}, final_machine="X1 Y2 Z0",
)
case(
    "the fine shift adds to the coarse one, which stays", **FRAMES, setup=ZERO,
    program="N10 $P_UIFR[1,X,FI]=0.5 $P_UIFR[1,Z,FI]=-0.125\nN20 R1=$P_UIFR[1,X,TR] R2=$P_UIFR[1,X,FI]\nN30 G54 G0 X1 Y0 Z0\nN40 M30",
    vars={1: 100.125, 2: 0.5}, final_machine="X101.625 Y20.25 Z-40.625",
)
case(
    "CTRANS takes the fine shift away, CFINE the coarse one", control=ONE, source="SONE p.315: the effects of CTRANS and CFINE", evidence="secondary", setup=ZERO,
    program="N10 $P_UIFR[1]=CFINE(X,0.5)\nN20 R1=$P_UIFR[1,X,TR] R2=$P_UIFR[1,X,FI]\nN30 $P_UIFR[1]=CTRANS(X,3)\nN40 R3=$P_UIFR[1,X,TR] R4=$P_UIFR[1,X,FI]\nN50 M30",
    vars={1: 0, 2: 0.5, 3: 3, 4: 0},
)
case(
    "a rotary axis has its shift", **STORED, setup=ZERO,
    program="N10 $P_UIFR[1,B,TR]=30\nN20 G54 G0 B10\nN30 R1=$AA_IM[B]\nN40 M30", vars={1: 40},
)
case(
    "a turned zero point turns what is programmed, and TRANS lies in it", **FRAMES, setup=ZERO,
    program="N10 $P_UIFR[2]=CTRANS(X,10,Y,5):CROT(Z,90)\nN20 G55 G0 X3 Y1 Z0\nN30 R1=$AA_IM[X] R2=$AA_IM[Y] R3=$AA_IW[X]\nN40 TRANS X2\nN50 X3 Y1\nN60 M30",
    vars={1: 9, 2: 8, 3: 3}, final_machine="X9 Y10 Z0",
)
case(
    "and G54 leaves it again", **FRAMES, setup=ZERO,
    program="N10 $P_UIFR[2]=CTRANS(X,10,Y,5):CROT(Z,90)\nN20 G55 G0 X3 Y1\nN30 G54 X3 Y1\nN40 M30", final_machine="X103.125 Y21.25 Z-40.5",
)
case(
    "an arc turns with it, in another plane too", **FRAMES, setup=ZERO,
    program="N10 $P_UIFR[2]=CTRANS(X,10,Z,5):CROT(Y,90)\nN20 G18 G55 G0 X0 Y0 Z0\nN30 G2 X0 Z10 I0 K5 F100\nN40 M30",
    moves="R X0 Y0 Z0\nCW X10 Y0 Z0 C X5 Z0", final_machine="X20 Y0 Z5",
)
case(
    "a mirrored one changes the direction of arcs, a scaled one their radius", **FRAMES, setup=ZERO,
    program="N10 $P_UIFR[2]=CTRANS(X,10):CSCALE(X,2,Y,2):CMIRROR(X)\nN20 G55 G0 X0 Y0 Z0\nN30 G2 X10 Y0 I5 J0 F100\nN40 R1=$P_UIFR[2,X,SC] R2=$P_UIFR[2,X,MI] R3=$P_UIFR[2,Y,MI] R4=$P_UIFR[2,Z,RT]\nN50 M30",
    moves="R X0 Y0\nCCW X-20 Y0 C X-10 Y0", vars={1: 2, 2: 1, 3: 0, 4: 0}, final_machine="X-10 Y0 Z0",
)
case(
    "a radius is compensated in it", **FRAMES, setup=TOOL,
    program="N10 T1 M6\nN20 $P_UIFR[2]=CTRANS(X,10,Y,5):CROT(Z,90)\nN30 G55 G0 X0 Y0 Z0\nN40 G41 G1 X10 Y10 F100\nN50 X30\nN60 Y-20\nN70 R1=$AA_IM[X] R2=$AA_IM[Y] R3=$AA_IM[Z]\nN80 M30",
    moves="R X0 Y0\nF X-10 Y10\nF X-10 Y30\nCW X-10 Y30 C X-10 Y30\nF X20 Y30", vars={1: 0, 2: 40, 3: 12.5},
)
case(
    "$P_IFRAME is the one in force, and a write to it counts at once", **STORED, setup=ZERO,
    program="N10 G0 X1 Y1\nN20 R1=$P_IFRAME[X,TR]\nN30 $P_UIFR[1,X,TR]=50\nN40 R2=$P_IFRAME[X,TR]\nN50 $P_IFRAME=CTRANS(X,30):CROT(Z,90)\nN60 X2 Y3\nN70 R3=$P_IFRAME[Z,RT] R4=$P_UIFR[1,X,TR]\nN80 M30",
    vars={1: 100.125, 2: 100.125, 3: 90, 4: 50}, final_machine="X27 Y2 Z-40.5",
)
case(
    "a part of it too, until a block with G54 reads the stored one again", **STORED, setup=ZERO,
    program="N10 $P_IFRAME[X,TR]=30\nN20 G0 X1 Y1\nN30 R1=$AA_IM[X]\nN40 G54 X1\nN50 M30", vars={1: 31}, final_machine="X101.125 Y21.25 Z-40.5",
)
case(
    "an increment after it moves by the change too", **KNOWN, setup=ZERO,
    program="N10 G0 X1 Y1\nN20 $P_UIFR[1,X,TR]=10\nN30 G54 G91 X2\nN40 M30", moves_x=[1, 3], final_machine="X13 Y21.25 Z-40.5",
)
case(
    "G53 leaves a turned zero point out", **KNOWN, setup=MORE,
    program="N10 $P_UIFR[1]=CTRANS(X,10):CROT(Z,90)\nN20 G54 G0 X1 Y1\nN30 G53 X4 Y5\nN40 M30", final_machine="X1004 Y12 Z-40.5",
)
# ---- $P_PFRAME, $P_BFRAME, $P_ACTFRAME ----

case(
    "$P_PFRAME is the frame of TRANS and ROT", **FRAMES, setup=ZERO,
    program="N10 TRANS X10 Y5\nN20 AROT Z90\nN30 ATRANS X1\nN40 R1=$P_PFRAME[X,TR] R2=$P_PFRAME[Y,TR] R3=$P_PFRAME[Z,RT] R4=$P_PFRAME[X,FI]\nN50 M30",
    vars={1: 10, 2: 6, 3: 90, 4: 0},
)
case(
    "a write to it acts as they do", **FRAMES, setup=ZERO,
    program="N10 $P_PFRAME=CTRANS(X,10,Y,5):CROT(Z,90)\nN20 G0 X3 Y1\nN30 X=IC(2)\nN40 M30", final_machine="X109.125 Y30.25 Z-40.5",
)
case(
    "and a write to a part of it", **FRAMES, setup=ZERO,
    program="N10 TRANS X10 Y5\nN20 $P_PFRAME[X,TR]=20 $P_PFRAME[Z,RT]=90\nN30 G0 X3 Y1\nN40 M30", final_machine="X119.125 Y28.25 Z-40.5",
)
case(
    "and TRANS replaces it", **FRAMES, setup=ZERO,
    program="N10 $P_PFRAME=CTRANS(X,10):CROT(Z,90)\nN20 TRANS X1\nN30 G0 X3 Y1\nN40 M30", final_machine="X104.125 Y21.25 Z-40.5",
)
case(
    "it is chained to itself", **FRAMES, setup=ZERO,
    program="N10 TRANS X10\nN20 $P_PFRAME=$P_PFRAME:CTRANS(Y,3):CROT(Z,90):CTRANS(X,2)\nN30 G0 X3 Y1\nN40 M30", final_machine="X109.125 Y28.25 Z-40.5",
)
case(
    "its fine shift adds to it", control=ONE, source="SONE p.315: $P_PFRAME[X,FI]", evidence="secondary", setup=ZERO,
    program="N10 TRANS X10\nN20 $P_PFRAME[X,FI]=0.25\nN30 G0 X3 Y1\nN40 R1=$P_PFRAME[X,TR]\nN50 M30", vars={1: 10}, final_machine="X113.375 Y21.25 Z-40.5",
)
case(
    "a write of a frame stands before the move of its block", **KNOWN, setup=ZERO,
    program="N10 G0 X3 Y1 $P_PFRAME=CTRANS(X,10)\nN20 M30", final_machine="X113.125 Y21.25 Z-40.5",
)
case(
    "a frame goes through a subprogram that saves its own", **KNOWN, setup=ZERO,
    program="%_N_MAIN_MPF\nN10 $P_PFRAME=CTRANS(X,10):CROT(Z,90)\nN20 SUB1\nN30 G0 X1 Y2\nN40 M30\n"
    "%_N_SUB1_SPF\nPROC SUB1 SAVE\nN10 $P_PFRAME=CTRANS(X,50)\nN20 G0 X3 Y4\nN30 RET",
    final_machine="X108.125 Y21.25 Z-40.5",
)
case(
    "$P_BFRAME is the basic frame, and a write to it counts at once", **STORED, setup=MORE,
    program="N10 R1=$P_BFRAME[X,TR] R2=$P_ACTBFRAME[Y,TR]\nN20 $P_BFRAME=CTRANS(X,500,Y,1)\nN30 G0 X1 Y1\nN40 M30", vars={1: 1000, 2: 7}, final_machine="X601.125 Y22.25 Z-40.5",
)
case(
    "one that turns is not computed", **POLICY, setup=MORE,
    program="N10 G0 X1\nN20 $P_BFRAME=CROT(Z,30)\nN30 M30", runs="N10", alarm="code-not-computed", at="MAIN N20",
)
case(
    "$P_ACTFRAME is the basic frame, the work system and the frame of the program in a chain", **FRAMES, setup=MORE,
    program="N10 $P_UIFR[1]=CTRANS(X,10,Y,5):CROT(Z,90)\nN20 G54\nN30 TRANS X3 Y1\nN40 R1=$P_ACTFRAME[X,TR] R2=$P_ACTFRAME[Y,TR] R3=$P_ACTFRAME[Z,RT]\nN50 M30",
    vars={1: 1009, 2: 15, 3: 90},
)
case(
    "$P_ACTFRAME is only read", **FRAMES, program="N10 $P_ACTFRAME=CTRANS()\nN20 M30", runs="", alarm="variable-write-protected", at="MAIN N10",
)
for name in ("$P_SETFR", "$P_WPFR", "$P_WPFRAME", "$P_CYCFR", "$P_CYCFRAME", "$P_TOOLFRAME", "$P_PARTFRAME", "$P_TRAFRAME", "$P_EXTFRAME"):
    case(
        f"{name} is a zero frame where the machine has none of it", control=ONE, source="840Dk p.2-67", evidence="secondary", setup=ZERO,
        program=f"N10 {name}=CTRANS()\nN20 R1={name}[X,RT] R2={name}[X,SC]\nN30 G0 X1\nN40 M30", vars={1: 0, 2: 1}, final_machine="X101.125 Y20.25 Z-40.5",
    )
    case(
        f"{name} takes no other", **POLICY, program=f"N10 {name}=CTRANS(X,5)\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10",
    )

# ---- variables and functions ----

case(
    "a frame is kept in a variable, given on and put in force", **FRAMES, setup=ZERO,
    program="N10 DEF FRAME ONE=CTRANS(X,10,Y,5), TWO\nN20 TWO=ONE:CROT(Z,90)\nN30 $P_PFRAME=TWO\nN40 G0 X3 Y1\nN50 ONE=$P_PFRAME\nN60 R1=ONE[X,TR] R2=ONE[Z,RT]\nN70 M30",
    vars={1: 10, 2: 90}, final_machine="X109.125 Y28.25 Z-40.5",
)
case(
    "one that nothing is given changes nothing", **FRAMES, setup=ZERO,
    program="N10 DEF FRAME ONE\nN20 TRANS X10\nN30 $P_PFRAME=ONE\nN40 G0 X3 Y1\nN50 R1=ONE[X,SC]\nN60 M30", vars={1: 1}, final_machine="X103.125 Y21.25 Z-40.5",
)
case(
    "its parts are read and written", **FRAMES, setup=ZERO,
    program="N10 DEF FRAME ONE\nN20 ONE[X,TR]=10\nN30 ONE[Y,TR]=ONE[X,TR]/2\nN40 ONE[Z,RT]=90\nN50 ONE[X,SC]=2\nN60 ONE[Y,MI]=1\nN70 ONE[Z,FI]=0.5\n"
    "N80 R1=ONE[X,TR] R2=ONE[Y,TR] R3=ONE[Z,RT] R4=ONE[X,SC] R5=ONE[Y,MI] R6=ONE[Z,FI] R7=ONE[X,MI]\nN90 $P_PFRAME=ONE\nN100 G0 X3 Y1 Z0\nN110 M30",
    vars={1: 10, 2: 5, 3: 90, 4: 2, 5: 1, 6: 0.5, 7: 0}, final_machine="X111.125 Y31.25 Z-40",
)
case(
    "an array of frames", **KNOWN, setup=ZERO,
    program="N10 DEF FRAME ALL[3]\nN20 ALL[1]=CTRANS(X,10)\nN30 ALL[2]=ALL[1]:CTRANS(X,5)\nN40 $P_PFRAME=ALL[2]\nN50 G0 X3 Y1\nN60 M30", final_machine="X118.125 Y21.25 Z-40.5",
)
case(
    "a frame is handed over to a subprogram", **KNOWN, setup=ZERO,
    program="%_N_MAIN_MPF\nN10 DEF FRAME MINE=CTRANS(X,4)\nN20 SUB1(MINE,2)\nN30 M30\n"
    "%_N_SUB1_SPF\nPROC SUB1(FRAME GIVEN, REAL MORE)\nN10 $P_PFRAME=GIVEN:CTRANS(X,MORE)\nN20 G0 X3 Y4\nN30 RET",
    final_machine="X109.125 Y24.25 Z-40.5",
)
case(
    "CROT turns about Z, then the new Y, then the new X, in whatever order they are written", **KNOWN, setup={"start": {"X": 0, "Y": 0, "Z": 0}},
    program="N10 $P_PFRAME=CROT(X,90,Z,90,Y,90)\nN20 G0 X1 Y2 Z3\nN30 M30", final_machine="X3 Y2 Z-1",
)
case(
    "three angles are read as they were given", **FRAMES,
    program="N10 DEF FRAME ONE=CROT(X,-100.5,Y,30.25,Z,170)\nN20 R1=ONE[X,RT] R2=ONE[Y,RT] R3=ONE[Z,RT]\nN30 M30", vars={1: -100.5, 2: 30.25, 3: 170},
)
case(
    "an angle beyond its range is read within it", **FRAMES,
    program="N10 DEF FRAME ONE=CROT(Z,270)\nN20 R1=ONE[Z,RT]\nN30 ONE=CROT(Y,120)\nN40 R2=ONE[X,RT] R3=ONE[Y,RT] R4=ONE[Z,RT]\nN50 M30",
    vars={1: -90, 2: 180, 3: 60, 4: 180},
)
case(
    "upright frames give all of the turn to Z", **KNOWN,
    program="N10 DEF FRAME ONE=CROT(Z,20):CROT(Y,90)\nN20 R1=ONE[X,RT] R2=ONE[Y,RT] R3=ONE[Z,RT]\nN30 M30", vars={1: 0, 2: 90, 3: 20},
)
case(
    "CMIRROR of two axes is a mirror, not half a turn", **KNOWN,
    program="N10 DEF FRAME ONE=CMIRROR(X,Y)\nN20 R1=ONE[X,MI] R2=ONE[Y,MI] R3=ONE[Z,RT]\nN30 ONE=ONE:CMIRROR(Y)\nN40 R4=ONE[X,MI] R5=ONE[Y,MI]\nN50 M30",
    vars={1: 1, 2: 1, 3: 0, 4: 1, 5: 0},
)
case(
    "the first frame of a chain is the outer one", **FRAMES, setup=ZERO,
    program="N10 DEF FRAME ONE, TWO\nN20 ONE=CROT(Z,90):CTRANS(X,10)\nN30 TWO=CTRANS(X,10):CROT(Z,90)\nN40 R1=ONE[X,TR] R2=ONE[Y,TR] R3=TWO[X,TR] R4=TWO[Y,TR]\nN50 M30",
    vars={1: 0, 2: 10, 3: 10, 4: 0},
)
case(
    "a scale before a turn shears, and what its angle is nobody can say", **POLICY, setup=ZERO,
    program="N10 $P_PFRAME=CSCALE(X,2):CROT(Z,30)\nN20 G0 X1 Y0\nN30 R1=$P_PFRAME[Z,RT]\nN40 M30", runs="N10 N20", alarm="code-not-computed", at="MAIN N30",
    final_machine="X101.857050808 Y20.75 Z-40.5",
)
case(
    "a loop makes frames anew", **KNOWN, setup=ZERO,
    program="N10 DEF FRAME ONE\nN20 FOR R1=1 TO 1000\nN30 ONE=ONE:CTRANS(X,0.5)\nN40 ENDFOR\nN50 R2=ONE[X,TR]\nN60 M30", vars={2: 500},
)
case(
    "a block that alarms leaves the frames as they were", **POLICY, setup=ZERO,
    program="N10 G0 X1 Y1\nN20 $P_PFRAME=CTRANS(X,10) R1=1/R2\nN30 M30", runs="N10", alarm="division-by-zero", number="14051", at="MAIN N20", final_machine="X101.125 Y21.25 Z-40.5",
)
case(
    "nor does one whose move alarms leave them changed", **POLICY, setup=ZERO,
    program="N10 G0 X1 Y1\nN20 $P_PFRAME=CTRANS(X,10) G1 X5\nN30 M30", runs="N10", alarm="no-feed", number="10860", at="MAIN N20", word="G1", final_machine="X101.125 Y21.25 Z-40.5",
)

# ---- what is refused ----

NUMBERS = {
    "array-element": "12400", "type-mismatch": "12150", "expression-format": "12080", "missing-comma": "12080", "missing-equals": "12080",
    "bracket-not-closed": "12080", "bracket-not-opened": "12080",
}

for text, cause in (
    ("$P_UIFR[100]=CTRANS()", "array-element"),
    ("$P_UIFR[-1,X,TR]=1", "array-element"),
    ("R1=$P_UIFR[100,X,TR]", "array-element"),
    ("$P_UIFR[X,TR]=1", "type-mismatch"),
    ("$P_UIFR[1,1,TR]=1", "type-mismatch"),
    ("$P_UIFR[1,X,TZ]=1", "expression-format"),
    ("$P_UIFR[1,X]=1", "missing-comma"),
    ("$P_UIFR[1,X,TR=1", "bracket-not-closed"),
    ("$P_UIFR=CTRANS()", "bracket-not-opened"),
    ("$P_UIFR[1]=5", "type-mismatch"),
    ("$P_UIFR[1] CTRANS()", "missing-equals"),
    ("$P_PFRAME[X,TR]=CTRANS()", "type-mismatch"),
    ("$P_PFRAME=R1", "type-mismatch"),
    ("R1=$P_PFRAME", "type-mismatch"),
    ("R1=CTRANS(X,5)", "type-mismatch"),
    ("R1=-CTRANS(X,5)", "type-mismatch"),
    ("R1=5:5", "type-mismatch"),
    ("$P_PFRAME=CTRANS(X,5)+CTRANS(Y,5)", "type-mismatch"),
    ("$P_PFRAME=CTRANS(5,X)", "type-mismatch"),
    ("$P_PFRAME=CTRANS(X)", "missing-comma"),
    ("$P_PFRAME=CTRANS(X,5", "bracket-not-closed"),
    ("$P_PFRAME=CTRANS", "bracket-not-opened"),
    ("$P_PFRAME=CROT(A,30)", "array-element"),
    ("R1=$P_PFRAME[NO_AXIS,TR]", "array-element"),
    ('MSG("A"<<CTRANS())', "type-mismatch"),
    ("X=CTRANS()", "type-mismatch"),
    ("R[CTRANS()]=5", "type-mismatch"),
    ("IF CTRANS() GOTOF NEXT", "type-mismatch"),
    ("$P_UIFRNUM=2", "variable-write-protected"),
    ("$P_PFRAME=CTRANS(X,1EX30):CSCALE(X,1EX30):CSCALE(X,1EX30)", "value-out-of-range"),
    ("R1=$P_PFRAME[X,TR] $P_PFRAME=CTRANS() R2=$P_PFRAME[X,TR]", "code-not-computed"),
):
    case(f"{text} is refused", **KNOWN, program=f"N10 {text}\nN20 NEXT: M30", runs="", alarm=cause, number=NUMBERS.get(cause), at="MAIN N10")
case(
    "a factor of 0 is no scale", **KNOWN, program="N10 $P_PFRAME=CSCALE(X,0)\nN20 M30", runs="", alarm="scale-zero", at="MAIN N10", word="X",
)
case(
    "frames as values in inches are not computed", **POLICY,
    program="N10 G70\nN20 $P_UIFR[1]=CTRANS(X,1)\nN30 M30", runs="N10", alarm="code-not-computed", at="MAIN N20",
)
case(
    "nor a frame while a radius is compensated", **POLICY, setup=TOOL,
    program="N10 T1 M6\nN20 G41 G1 X10 Y10 F100\nN30 X20\nN40 $P_PFRAME=CTRANS(X,5)\nN50 M30", runs="N10 N20 N30", alarm="code-not-computed", at="MAIN N40",
)
case(
    "nor a turned zero point that is selected then", **POLICY, setup=TOOL,
    program="N10 $P_UIFR[2]=CROT(Z,90)\nN20 T1 M6\nN30 G41 G1 X10 Y10 F100\nN40 X20\nN50 G55 X30\nN60 M30", runs="N10 N20 N30 N40", alarm="code-not-computed", at="MAIN N50", word="G55",
)
case(
    "a part of an element of an array of frames is not computed", **POLICY,
    program="N10 DEF FRAME ALL[3]\nN20 ALL[1,X,TR]=5\nN30 M30", runs="N10", alarm="code-not-computed", at="MAIN N20",
)
case(
    "a part of a parameter by reference is written beside the others", **KNOWN, setup=ZERO,
    program="N10 DEF FRAME MOVED\nN20 PART(MOVED)\nN30 $P_PFRAME=MOVED\nN40 G0 X0 Y0\nN50 M30\n"
    "%_N_PART_SPF\nN60 PROC PART(VAR FRAME FIELD)\nN70 FIELD[X,TR]=10\nN80 FIELD[Y,TR]=20\nN90 FIELD[X,TR]=FIELD[X,TR]+1\nN100 M17",
    final_machine="X111.125 Y40.25 Z-40.5",
)

# ---- the angles that are read ----

for written, read in (
    ("X,10,Y,90,Z,40", (0, 90, 30)), ("X,190,Y,0,Z,-200", (-170, 0, 160)), ("Z,30", (0, 0, 30)), ("Z,400", (0, 0, 40)), ("X,-20,Y,45,Z,0.1", (-20, 45, 0.1)),
    ("Y,-90,X,5", (0, -90, 5)),
):
    case(
        f"CROT({written}) is read in the range of the angles", control=ONE, source="840Dk p.2-44: what is read of CROT", evidence="secondary", setup=ZERO,
        program=f"N10 $P_UIFR[1]=CROT({written})\nN20 R1=$P_UIFR[1,X,RT] R2=$P_UIFR[1,Y,RT] R3=$P_UIFR[1,Z,RT]\nN30 M30",
        vars=dict(zip((1, 2, 3), read, strict=True)),
    )
case(
    "the fine shift of the basic frame is read too", **KNOWN, setup=ZERO,
    program="N10 $P_BFRAME=CTRANS(X,0.2):CFINE(X,0.1)\nN20 R1=$P_BFRAME[X,TR] R2=$P_BFRAME[X,FI]\nN30 G0 X1\nN40 M30", vars={1: 0.2, 2: 0.1}, final_machine="X101.425 Y20.25 Z-40.5",
)
case(
    "AROT adds to the angle about its axis", **KNOWN, setup=ZERO,
    program="N10 ROT Z20\nN20 AROT Z10\nN30 R1=$P_PFRAME[Z,RT]\nN40 M30", vars={1: 30},
)

# ---- CRPL ----

PLANES = {"control": ONE, "source": "840Dk p.2-45: CRPL; 828Db p.728", "evidence": "secondary"}
for plane, code, read in ((1, "G18", "Z"), (2, "G17", "Y"), (3, "G17", "X"), (0, "G17", "Z"), (0, "G18", "Y"), (0, "G19", "X")):
    case(
        f"CRPL({plane},30) after {code} turns about {read}", **PLANES, setup=ZERO,
        program=f"N10 DEF FRAME FRAME1\nN20 {code}\nN30 FRAME1=CTRANS(X,10):CRPL({plane},30)\nN40 R1=FRAME1[{read},RT] R2=FRAME1[X,TR]\nN50 M30", vars={1: 30, 2: 10},
    )
case(
    "CRPL turns the program", **PLANES, setup=ZERO,
    program="N10 $P_PFRAME=CRPL(0,90)\nN20 G0 X5 Y1\nN30 M30", final_machine="X99.125 Y25.25 Z-40.5",
)
for text, cause, number in (
    ("CRPL(4,30)", "value-out-of-range", None), ("CRPL(1)", "missing-comma", "12080"), ("CRPL(R1,30)", "code-not-computed", None), ("CRPL(1,30", "bracket-not-closed", "12080"),
    ("CRPL(1,X)", "type-mismatch", "12150"),
):
    case(f"{text} is refused", **KNOWN, program=f"N10 $P_PFRAME={text}\nN20 M30", runs="", alarm=cause, number=number, at="MAIN N10")
