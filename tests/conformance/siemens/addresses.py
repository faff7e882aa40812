"""SINUMERIK: forms of values, addresses with numbers and names, arcs, corners, compensation."""

from conformance import case

ONE = "siemens-one"
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}
GRAMMAR = {"control": ONE, "source": "NCI grammar", "evidence": "secondary"}
POLICY = {"control": ONE, "source": "policy, nobody says", "evidence": "inferred"}
ZERO = {"work_offsets": {"G54": {"X": 100.125, "Y": 20.25, "Z": -40.5}}, "start": {"X": 0, "Y": 0, "Z": 0}}

# ---- AC IC DC ACP ACN ----

case(
    "IC and AC say for one word what G91 and G90 say for all", **GRAMMAR, setup=ZERO,
    program="N10 G0 X10 Y1\nN20 X=IC(5) Y4\nN30 G91 X=AC(3) Y2\nN40 X2\nN50 M30", moves="R X10 Y1\nR X15 Y4\nR X3 Y6\nR X5", final_machine="X105.125 Y26.25 Z-40.5",
)
case(
    "their value is an expression", **GRAMMAR, setup=ZERO, program="N10 R1=2\nN20 G0 X=AC(R1*3)\nN30 X=IC(-R1)\nN40 M30", moves_x=[6, 4],
)
case(
    "I=AC() is a coordinate of the centre", **GRAMMAR, setup=ZERO,
    program="N10 G0 X10 Y5\nN20 G2 X30 Y5 I=AC(20) J=AC(5) F100\nN30 G91 G2 X-20 I=AC(20) J0\nN40 M30",
    moves="R X10 Y5\nCW X30 Y5 C X20 Y5\nCW X10 Y5 C X20 Y5",
)
case(
    "I=AC() counts in the frame of the program", **GRAMMAR, setup=ZERO,
    program="N10 TRANS X5\nN20 AROT Z90\nN30 G0 X10 Y5\nN40 G2 X30 Y5 I=AC(20) J=AC(5) F100\nN50 M30", moves="R X-5 Y10\nCW X-5 Y30 C X-5 Y20",
)
case(
    "DC goes the shorter way, ACP and ACN in one direction", **GRAMMAR, setup=ZERO,
    program="N10 G0 C350\nN20 C=DC(10)\nN30 C=ACN(350)\nN40 C=ACP(0)\nN50 C=ACP(0)\nN60 C=ACN(0)\nN70 M30",
    moves="R C350\nR C370\nR C350\nR C360\nR C360\nR C360",
)
case("DC is of rotary axes", **KNOWN, program="N10 G0 X=DC(5)\nN20 M30", runs="", alarm="statement-format", at="MAIN N10")
case("IC needs a bracket", **GRAMMAR, program="N10 G0 X=IC 5\nN20 M30", runs="", alarm="bracket-not-opened", number="12080", at="MAIN N10")
case("and its end", **GRAMMAR, program="N10 G0 X=IC(5\nN20 M30", runs="", alarm="bracket-not-closed", number="12080", at="MAIN N10")
case("and a value", **GRAMMAR, program="N10 G0 X=AC()\nN20 M30", runs="", alarm="expression-format", number="12080", at="MAIN N10")
case(
    "a word by IC and the same word", **KNOWN, program="N10 G0 X=IC(5) X1\nN20 M30", runs="", alarm="axis-given-twice", number="16420", at="MAIN N10", word="X1",
)
case(
    "AX names an axis in brackets", **GRAMMAR, setup=ZERO, program="N10 G0 AX[X]=5 AX[Y]=IC(2)\nN20 M30", moves="R X5 Y2",
)
INDEXED = "DEF AXIS LENG=X, DEEP=Z, NONE\nDEF REAL AWAY=3\n"
case(
    "AX takes a variable of type AXIS, several in a block, and axes of computed names", **GRAMMAR, setup=ZERO,
    program=INDEXED + 'N10 G0 AX[LENG]=5 AX[DEEP]=AWAY+1\nN20 AX[LENG]=IC(2) AX[DEEP]=IC(-1)\nN30 AX[AXNAME("Y")]=AC(4)\nN40 M30',
    moves="R X5 Y0 Z4\nR X7 Y0 Z3\nR X7 Y4 Z3",
)
case(
    "AX follows its variable", **GRAMMAR, setup=ZERO,
    program=INDEXED + "N10 G0 AX[LENG]=5\nN20 LENG=Y\nN30 AX[LENG]=6\nN40 G91 AX[LENG]=1\nN50 M30", moves="R X5 Y0\nR X5 Y6\nR X5 Y7",
)
case(
    "AX names an axis in a frame too", **GRAMMAR, setup=ZERO,
    program=INDEXED + "N10 TRANS AX[LENG]=100\nN20 G0 X1\nN30 M30", final_machine="X201.125 Y20.25 Z-40.5",
)
for words, word in (
    ("AX[LENG]=5 X2", "LENG]=5"), ("AX[LENG]=IC(5) AX[DEEP]=2", "AX[DEEP]=2"), ("AX[LENG]=DC(5)", "]="), ("AX[NONE]=5", "NONE]=5"),
):
    case(
        f"{words} is not computed", **POLICY, setup=ZERO,
        program=INDEXED + f"N10 G0 {words}\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10", word=word,
    )
for words, alarm, number, word in (
    ("AX[LENG=5", "bracket-not-closed", "12080", "="), ("AX[LENG]5", "missing-equals", "12080", "]"), ("AX[X=5", "bracket-not-closed", "12080", "="),
    ("AX[AWAY]=5", "type-mismatch", "12150", "AWAY"), ("AX[LENG]=DEEP", "type-mismatch", "12150", "DEEP"),
    ("AX[LENG]=IC(5", "bracket-not-closed", "12080", "]=IC(5"),
):
    case(
        f"{words} is no word", **KNOWN, setup=ZERO,
        program=INDEXED + f"N10 G0 {words}\nN20 M30", runs="", alarm=alarm, number=number, at="MAIN N10", word=word,
    )
case("AX of a name that is no axis here", **POLICY, program="N10 G0 AX[Q1]=5\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10")

# ---- numbered addresses ----

case(
    "a spindle other than the first is reported, and M and S of the first are its own", **KNOWN, setup=ZERO,
    program="N10 S2=500 M2=3\nN20 M1=3 S1=600 G95 G1 X10 F1\nN30 M30", dropped=["S2=500", "M2=3"], m=[3, 30], time=1,
)
case("T1= is the tool of the first spindle", **KNOWN, program="N10 T1=5 M6\nN20 M30", t=[5])
case(
    "an axis of the machine that no column holds is reported", **POLICY, setup=ZERO,
    program="N10 G0 X1=10 Y2\nN20 M30", moves="R Y2", dropped=["X1=10"],
)
case(
    "so are the axes E and Q", **POLICY, setup=ZERO,
    program="N10 G1 X1 E=IC(2) Q=5 F100\nN20 M30", moves="F X1", dropped=["E=IC(2)", "Q=5"],
)
for text in ("LIMS[2]=3000", "SPOS=90", "SPOS[2]=DC(90)", "SPOSA=180", "ADIS=0.1", "ADISPOS=0.2", "OVR=80", "ACC[X]=50", "FZ=0.1", "FINEA[X]", "COARSEA[X]", "IPOENDA=X"):
    case(
        f"{text} is reported and changes no path", **POLICY, setup=ZERO,
        program=f"N10 G0 X5 {text}\nN20 M30", moves="R X5", dropped=[text],
    )
for text in (
    "BRISK", "DRIVE", "FFWON", "FFWOF", "WALIMON", "WALIMOF", "CFC", "CFTCP", "CFIN", "CDON", "CDOF", "FNORM", "COMPON", "COMPOF", "COMPCAD",
    "COMPCURV", "CUT2D", "NORM", "TRAFOOF", "DYNNORM", "DYNFINISH", "UPATH", "ORIWKS", "ORIMKS", "ORIAXES", "STARTFIFO", "SPCOF",
):
    case(
        f"{text} is reported and changes no path", **POLICY, setup=ZERO, program=f"N10 G0 X5 {text}\nN20 M30", moves="R X5", dropped=[text],
    )
for text in (
    "TRAORI", "TRANSMIT", "TRACYL(40)", "CYCLE800()", "BSPLINE", "ASPLINE", "CSPLINE", "POLY", "KONT", "KONTC", "KONTT",
    "POSA[X]=5", "DIAM90", "ROTS X5", "TOFFL=1", "DISC=5", "CUT3DC", "CUT2DF",
):
    case(
        f"{text} is not computed, and says so", **POLICY, program=f"N10 {text}\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10",
    )

# ---- arcs ----

case(
    "AR is the angle of an arc, beside its end", pins="arc_angle_words", **GRAMMAR, setup=ZERO,
    program="N10 G0 X0 Y0\nN20 G2 X10 Y0 AR=180 F100\nN30 G3 X0 Y10 AR=270\nN40 M30",
    moves="R X0 Y0\nCW X10 Y0 C X5 Y0\nCCW X0 Y10 C X10 Y10",
)
case(
    "AR is the angle of an arc, beside its centre", **GRAMMAR, setup=ZERO,
    program="N10 G0 X10 Y0\nN20 G3 I-10 J0 AR=90 F100\nN30 M30", moves="R X10 Y0\nCCW X0 Y10 C X0 Y0",
)
case(
    "an angle of 0 makes no arc", **KNOWN, setup=ZERO,
    program="N10 G0 X10 Y0\nN20 G3 I-10 J0 AR=0 F100\nN30 M30", runs="N10", alarm="value-out-of-range", at="MAIN N20", word="AR=0",
)
case(
    "an arc takes rotary axes along", pins="helix", control=ONE, source="840Dbf p.673, synchronized axes", evidence="secondary", setup=ZERO,
    program="N10 G0 X10 Y0 Z0\nN20 G3 X0 Y10 I-10 J0 A30 F100\nN30 G2 X10 Y0 I0 J-10 C=IC(20) Z-1 TURN=1\nN40 M30",
    final_work="X10 Y0 Z-1 A30 C20",
)
case(
    "TURN adds full turns", pins="added_turns", **GRAMMAR, setup=ZERO,
    program="N10 G0 X10 Y0\nN20 G3 X0 Y10 I-10 J0 TURN=2 F100\nN30 M30", time=84.883,
)
case(
    "CIP is an arc through a point between", pins="g_meanings:CIP=three-points-by-mode", **GRAMMAR, setup=ZERO,
    program="N10 G0 X0 Y0\nN20 CIP X10 Y0 I1=5 J1=5 F100\nN30 X20 Y0 I1=IC(5) J1=IC(-5)\nN40 G91 X-10 Y0 I1=-5 J1=5\nN50 M30",
    moves="R X0 Y0\nCW X10 Y0 C X5 Y0\nCCW X20 Y0 C X15 Y0\nCCW X10 Y0 C X15 Y0",
)
case(
    "the point between lies in the frame of the program", **GRAMMAR, setup=ZERO,
    program="N10 TRANS X5\nN20 AROT Z90\nN30 G0 X0 Y0\nN40 CIP X10 Y0 I1=5 J1=5 F100\nN50 M30", moves="R X0 Y0\nCW X0 Y10 C X0 Y5",
)
case(
    "three points on a line make no arc", **GRAMMAR, setup=ZERO,
    program="N10 G0 X0 Y0\nN20 CIP X10 Y0 I1=5 J1=0 F100\nN30 M30", runs="N10", alarm="three-points", at="MAIN N20", word="I1=5",
)

# ---- polar coordinates ----

case(
    "RP and AP count from the zero point, or from the pole of G111", pins="poles g_meanings:111=pole", **GRAMMAR, setup=ZERO,
    program="N10 G0 RP=10 AP=90\nN20 G111 X10 Y20\nN30 RP=10 AP=0 Z3\nN40 AP=90\nN50 AP=IC(90)\nN60 RP=IC(5)\nN70 M30",
    moves="R X0 Y10\nR X20 Y20 Z3\nR X10 Y30\nR X0 Y20\nR X-5 Y20",
)
case(
    "a polar radius is absolute under G91 too, an angle is not", control=ONE, source="840Df p.118; the angle is general knowledge", evidence="inferred",
    setup=ZERO, program="N10 G0 RP=10 AP=0\nN20 G91 RP=5 AP=90\nN30 M30", moves="R X10 Y0\nR X0 Y5",
)
case(
    "G110 sets the pole from where the tool is, G112 from the pole", pins="g_meanings:110=pole-from-tool g_meanings:112=pole-from-pole", **GRAMMAR,
    setup=ZERO,
    program="N10 G0 X5 Y6\nN20 G110 X1\nN30 RP=2 AP=0\nN40 G112 Y4\nN50 RP=2 AP=0\nN60 G112 RP=10 AP=90\nN70 RP=0 AP=0\nN80 M30",
    moves="R X5 Y6\nR X8 Y6\nR X8 Y10\nR X6 Y20",
)
case(
    "polar words lie in the plane and in the frame", **GRAMMAR, setup=ZERO,
    program="N10 G18\nN20 G0 RP=10 AP=90\nN30 G17\nN40 TRANS X5\nN50 AROT Z90\nN60 G1 RP=10 AP=0 F100\nN70 M30", moves="R X10 Z0\nF X0 Y10",
)
case(
    "an arc ends at a polar point", **GRAMMAR, setup=ZERO,
    program="N10 G0 RP=10 AP=0\nN20 G3 RP=10 AP=90 CR=10 F100\nN30 M30", moves="R X10 Y0\nCCW X0 Y10 C X0 Y0",
)
case(
    "a coordinate of the plane beside polar words", **KNOWN, program="N10 G0 X5 AP=90\nN20 M30", runs="", alarm="polar-word", at="MAIN N10", word="X5",
)

# ---- corners ----

case(
    "CHR is how far a chamfer is from the corner, CHF how long it is", pins="chamfer_words", **GRAMMAR, setup=ZERO,
    program="N10 G1 X20 Y0 CHR=2 F100\nN20 Y20 CHF=2.828427\nN30 X0\nN40 M30",
    moves="F X18 Y0\nF X20 Y2\nF X20 Y18\nF X18 Y20\nF X0 Y20",
)
case(
    "RND rounds a corner", pins="round_words", **GRAMMAR, setup=ZERO,
    program="N10 G1 X20 Y0 RND=2 F100\nN20 Y20\nN30 M30", moves="F X18 Y0\nCCW X20 Y2 C X18 Y2\nF X20 Y20",
)
case(
    "ANG is the angle of a line", pins="angle_words angles_on_mills", **GRAMMAR, setup=ZERO,
    program="N10 G1 X10 ANG=45 F100\nN20 M30", moves="F X10 Y10",
)
case(
    "a corner before the end of the program", **KNOWN, setup=ZERO,
    program="N10 G1 X20 RND=2 F100\nN20 M30", runs="N10", alarm="corner-no-move", at="MAIN N20", word="M30",
)
case(
    "DIAMON makes X a diameter", pins="g_meanings:DIAMON=diameter g_meanings:DIAMOF=diameter-off", **GRAMMAR, setup=ZERO,
    program="N10 DIAMON\nN20 G0 X10\nN30 DIAMOF X10\nN40 M30", moves_x=[5, 10],
)

# ---- radius compensation ----

MILL = {"tools": {1: {"R": 5}}, **ZERO}
case(
    "G41 goes to the normal of the next move, and around an outside corner in an arc", pins="start_up acute_corner", **KNOWN, setup=MILL,
    program="N10 T1 M6\nN20 G41 G1 X10 Y10 F100\nN30 Y30\nN40 X40\nN50 G40 X50 Y50\nN60 M30", time=52.237,
)
case(
    "G451 lets the moved paths meet there", pins="g_meanings:451=corner-meet", **KNOWN, setup=MILL,
    program="N10 T1 M6\nN20 G41 G451 G1 X10 Y10 F100\nN30 Y30\nN40 X40\nN50 G40 X50 Y50\nN60 M30", time=53.525,
)

case(
    "G450 brings the arc back", pins="g_meanings:450=corner-arc", **KNOWN, setup=MILL,
    program="N10 T1 M6\nN20 G451\nN30 G41 G450 G1 X10 Y10 F100\nN40 Y30\nN50 X40\nN60 G40 X50 Y50\nN70 M30", time=52.237,
)
case(
    "three blocks without a move may stand between two moves", pins="idle_blocks", **KNOWN, setup=MILL,
    program="N10 T1 M6\nN20 G41 G1 X10 Y10 F100\nN30 Y30\nN31 M8\nN32 M9\nN33 M8\nN40 X40\nN50 G40 X50 Y50\nN60 M30", time=52.237,
)
case(
    "before a fourth one the move ends on its normal", pins="idle_blocks", **KNOWN, setup=MILL,
    program="N10 T1 M6\nN20 G41 G1 X10 Y10 F100\nN30 Y30\nN31 M8\nN32 M9\nN33 M8\nN34 M9\nN40 X40\nN50 G40 X50 Y50\nN60 M30", time=51.768,
)

# ---- threads, feed ----

case(
    "G33 cuts a thread by the lead of its axis", pins="g_meanings:33=thread-by-axis", **KNOWN, setup=ZERO,
    program="N10 G0 Z0\nN20 M3 S60\nN30 G33 Z-10 K2\nN40 X6 I3\nN50 M30", moves="R Z0\nT Z-10\nT X6", time=7,
)
case(
    "G33 without a lead", **KNOWN, setup=ZERO,
    program="N10 S60 M3\nN20 G33 Z-10\nN30 M30", runs="N10", alarm="thread-lead", at="MAIN N20", word="G33",
)
case(
    "G331 taps by the speed of the spindle, G332 goes back", pins="g_meanings:331=thread-by-axis g_meanings:332=thread-by-axis", **KNOWN, setup=ZERO,
    program="N10 G0 Z5\nN20 SPOS=0\nN30 G331 Z-10 K1.5 S60\nN40 G332 Z5 K1.5\nN50 G0 X1\nN60 M30", moves="R Z5\nT Z-10\nT Z5\nR X1",
)
case(
    "G93 is a feed by the time of each block", pins="g_codes:93", **KNOWN, setup=ZERO,
    program="N10 G93 G1 X100 F2\nN20 M30", time=30,
)
case(
    "G710 and G700 are units, for the feed too", pins="g_meanings:700=inch g_meanings:710=metric", **KNOWN, setup=ZERO,
    program="N10 G700 G1 X1 F1\nN20 G710 G0 X1\nN30 M30", moves="F X25.4\nR X1",
)
case(
    "a feed is missing", control=ONE, source="general knowledge of the SINUMERIK alarms: 10860", evidence="inferred",
    program="N10 G0 X1\nN20 G1 X5\nN30 M30", runs="N10", alarm="no-feed", number="10860", at="MAIN N20", word="G1",
)

case(
    "the centre across the plane does not count", pins="drops_centre_across", control=ONE, source="NCI, arc.mpf with its table", evidence="secondary", setup=ZERO,
    program="N10 G0 X0 Y50\nN20 G2 X0 Y0 Z10 I0 J-25 K5 F100\nN30 M30", moves="R X0 Y50\nCW X0 Y0 Z10 C X0 Y25", dropped=["K5"],
)
for text in ("FGROUP(X,Y,Z)", "SETMS(1)", "WAITP(X)", 'GROUP_BEGIN(0,"a)b",0,0)', "GROUP_END(0,0)", "SPCON(1)", "SETMS", "TOFFL=0", "DL=0", "DISC=0", "BRISKA(X)", "SOFTA(X,Y)", "JERKA(X)", "ADISPOSA(X)", "IPOBRKA(X,80)", "FPRAON(X)", "TRAFOOF()", "AFISON", "WALCS1", "COMPSURF", "ORISON"):
    case(
        f"{text} changes no path", **POLICY, setup=ZERO, program=f"N10 G0 X1\nN20 {text}\nN30 X2\nN40 M30", moves_x=[1, 2], dropped=[text],
    )
case("a bracket that stays open", **KNOWN, program="N10 WAITP(X\nN20 M30", runs="", alarm="bracket-not-closed", number="12080", at="MAIN N10")
case("FA needs =", **KNOWN, program="N10 FA[X] 500\nN20 M30", runs="", alarm="missing-equals", number="12080", at="MAIN N10")
case("and closes its bracket", **KNOWN, program="N10 FA[X=500\nN20 M30", runs="", alarm="bracket-not-closed", number="12080", at="MAIN N10")
case("RP needs =", **GRAMMAR, program="N10 G0 RP 10\nN20 M30", runs="", alarm="missing-equals", number="12080", at="MAIN N10")
case("AP twice", **KNOWN, program="N10 G0 AP=10 AP=20\nN20 M30", runs="", alarm="address-given-twice", number="12000", at="MAIN N10", word="AP=20")
for codes in ("G5G26", "G5 G26", "G4 G53", "G74 G153"):
    case(
        f"two codes that hold for this block alone are not computed: {codes}", **KNOWN, setup=ZERO,
        program=f"N10 G0 X2\nN20 {codes} X1\nN30 M30", runs="N10", alarm="code-not-computed", at="MAIN N20", word="G" + codes.split("G")[-1],
    )
