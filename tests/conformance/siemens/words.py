"""SINUMERIK: blocks, words and moves."""

from conformance import case

ONE = "siemens-one"
GROUPS = {"control": ONE, "source": "NCI, ggroups.json: the G groups of the manual", "evidence": "secondary"}
DWELL = {"control": ONE, "source": "NCI, CHANGELOG.md: F and S of G4", "evidence": "secondary"}
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}
POLICY = {"control": ONE, "source": "policy, nobody says", "evidence": "inferred"}

case(
    "a semicolon begins a comment, and brackets begin none", **KNOWN,
    program="N10 G0 X1 ; X2\n; X3\nN20 X(1+1)\nN30 M30", runs="N10", alarm="address-without-value", number="12080", at="MAIN N20",
)
case(
    "an address takes a number, or = and an expression", **KNOWN,
    program="N10 R1=2\nN20 G0 X=R1*3 Y-1.5 Z=-(R1+1)\nN30 M30", moves="R X6 Y-1.5 Z-3",
)
case(
    "a length without a point is millimetres", **KNOWN, program="N10 G0 X10\nN20 M30", moves_x=[10],
)
case(
    "G1 is in force at power-on", pins="power_on:G01 max_feed refuses:no-motion-code", **KNOWN,
    program="N10 X10 F100\nN20 M30", moves="F X10",
)
case(
    "CR is the radius of an arc", pins="power_on:G18 power_on:G19", **KNOWN,
    program="N10 G0 X0 Y0\nN20 G2 X10 Y0 CR=5 F100\nN30 G3 X0 Y0 I-5 J0\nN40 M30", moves="R X0 Y0\nCW X10 Y0 C X5 Y0\nCCW X0 Y0 C X5 Y0",
)
case(
    "a negative CR goes the long way", pins="negative_radius", **KNOWN,
    program="N10 G0 X0 Y0\nN20 G2 X10 Y10 CR=-10 F100\nN30 M30", moves="R X0 Y0\nCW X10 Y10 C X0 Y10",
)
case(
    "a CR that is too small for its chord alarms", pins="small_radius", **KNOWN,
    program="N10 G0 X0 Y0\nN20 G2 X10 Y0 CR=4.999 F100\nN30 M30", runs="N10", alarm="radius-too-small", number="14095", at="MAIN N20", word="CR=4.999",
)
case(
    "an arc without centre and radius alarms", pins="no_radius", **KNOWN,
    program="N10 G0 X0 Y0\nN20 G2 X10 Y0 F100\nN30 M30", runs="N10", alarm="no-radius", at="MAIN N20", word="G2",
)
case(
    "the axis across its plane goes along an arc", pins="helix", **KNOWN,
    program="N10 G0 X0 Y0 Z0\nN20 G2 X10 Y0 Z-3 I5 J0 F100\nN30 M30", moves="R X0 Y0 Z0\nCW X10 Y0 Z-3 C X5 Y0",
)
case(
    "rapid traverse of a SINUMERIK is 10 m a minute where the setup names no other", pins="rapid_rate machine", **KNOWN,
    program="N10 G0 X90000 Y50\nN20 M30", time=540,
)
case(
    "a block number has at most eight digits", pins="max_sequence_number", **KNOWN,
    program="N99999999 G0 X1\nN100000000 X2\nN30 M30", runs="N99999999", alarm="illegal-sequence-number", at="MAIN",
)
case(
    "G63 taps in a line at the feed, and the code of motion stays in force", pins="g_meanings:63=tapping", **KNOWN,
    setup={"work_offsets": {"G54": {"X": 1.125, "Z": -40.25}}},
    program="N10 G54 G0 X1 Z5\nN20 G63 Z-10 F200 S100\nN30 G63 Z5 M4\nN40 X7\nN50 M30",
    moves="R X1 Z5\nF Z-10\nF Z5\nR X7",
)
case(
    "G63 without a feed alarms", **KNOWN,
    program="N10 G0 Z5\nN20 G63 Z-10\nN30 M30", runs="N10", alarm="no-feed", number="10860", at="MAIN N20", word="G63",
)
case(
    "an end that misses its circle by more than a hundredth is 14040",
    control=ONE, source="HSA 14040; MD 21000 is general knowledge", evidence="inferred", pins="arc_tolerance",
    program="N10 G0 X0 Y0\nN20 G2 X2.0105 Y0 I1 J0 F100\nN30 M30",
    runs="N10", alarm="radius-tolerance", number="14040", at="MAIN N20", word="X2.0105",
)
case(
    "of a large circle a thousandth of the radius may be missed",
    control=ONE, source="HSA 14040; MD 21010 is general knowledge", evidence="inferred", pins="arc_tolerance_share",
    program="N10 G0 X0 Y0\nN20 G2 X200.05 Y0 I100 J0 F100\nN30 G0 X0\nN40 G2 X200.15 Y0 I100 J0\nN50 M30",
    runs="N10 N20 N30", alarm="radius-tolerance", number="14040", at="MAIN N40", word="X200.15",
)
case(
    "G71 and G70 are the units", pins="unit_change", **GROUPS, program="N10 G70 G0 X1\nN20 G71 X1\nN30 M30", moves="R X25.4\nR X1",
)
case(
    "F of G4 is its seconds", pins="dwell_words", **DWELL, program="N10 G4 F2.5\nN20 M30", time=2.5,
)
case(
    "G1 ends rapid traverse", **GROUPS, program="N10 G0 X1\nN20 G1 X5 F100\nN30 M30", moves="R X1\nF X5",
)
case(
    "G60 is an exact stop of the move in force", **GROUPS, program="N10 G1 G60 X5 F100\nN20 M30", moves="F X5",
)
case(
    "G91 is added, G90 is not", **GROUPS, program="N10 G0 X5\nN20 G91 X1\nN30 X1\nN40 G90 X1\nN50 M30", moves_x=[5, 6, 7, 1],
)
case(
    "a G code that is in no group is 12470", control=ONE, source="NCI, sinumerik-execution-model.md: 12470", evidence="secondary",
    program="N10 G999\nN20 M30", runs="", alarm="g-code-not-available", number="12470", at="MAIN N10", word="G999",
)
case(
    "five M codes stand in a block", **KNOWN, program="N10 M3 M7 M8 M20 M21\nN20 M30", m=[3, 7, 8, 20, 21, 30],
)
case(
    "and no sixth", **KNOWN, program="N10 M3 M7 M8 M20 M21 M22\nN20 M30", runs="", alarm="too-many-words", number="12010", at="MAIN N10", word="M22",
)
case(
    "MSG shows a text", **KNOWN, program='N10 MSG("drill; then tap")\nN20 M30', messages=["drill; then tap"],
)
case(
    "a slash leaves its block out, with the number of its switch", **KNOWN,
    program="/ N10 R1=1\n/2 N20 R2=1\nN30 M30", skip=[1], runs="N20 N30",
)
case(
    "a colon is the number of a main block", control=ONE, source="802D p.133, main blocks", evidence="secondary",
    program=":10 R1=1\nN20 M30", runs="N10 N20",
)
case(
    "an H is told and does nothing", **POLICY, program="N10 T1 D1 H5\nN20 M30", t=[1], dropped=["H5"],
)
case(
    "so are words that say how an axis starts", **POLICY, program="N10 G0 X1 SOFT\nN20 M30", dropped=["SOFT"],
)
case(
    "the name of a tool is reported: which number the machine gives it is not known", **POLICY,
    program='N10 T="MILL_10" M6\nN20 T="A;B" D1 ; second\nN30 M30', runs="N10 N20 N30", dropped=['T="MILL_10"', 'T="A;B"'], m=[6, 30],
)
case("an axis twice", control=ONE, source="S840S, an axis twice", evidence="secondary", program="N10 G0 X1 X2\nN20 M30", runs="", alarm="axis-given-twice", number="16420", at="MAIN N10", word="X2")
case("E is no address", **KNOWN, program="N10 E5\nN20 M30", runs="", alarm="address-not-usable", at="MAIN N10", word="E5")
case("CR needs =", **KNOWN, program="N10 G2 X1 CR 5\nN20 M30", runs="", alarm="missing-equals", number="12080", at="MAIN N10")
case("a character that begins no word", **KNOWN, program="N10 G0 #1\nN20 M30", runs="", alarm="illegal-character", at="MAIN N10", word="#1")
case(
    "DEPTH = 5 is not computed, and says so", **POLICY,
    program="N10 DEPTH = 5\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10", word="DEPTH",
)

# ---- the words of G4 belong to it ----

LIMITS = {"limits": {"X": (-1000, 1000)}}
for told, setup in (("", {}), (", with limits too", LIMITS)):
    case(
        f"F of G4 is no feed{told}", setup=setup, **DWELL,
        program="N10 G1 X10 F100\nN20 G4 F6\nN30 X20\nN40 M30", time=18,
    )
    case(
        f"nor is it beside an M code{told}", setup=setup, **KNOWN,
        program="N10 G1 X10 F100\nN20 G4 F6 M8\nN30 X20\nN40 M30", time=18,
    )
    case(
        f"S of G4 counts turns and sets no speed{told}", pins="dwell_turn_words", setup=setup, **DWELL,
        program="N10 G95 G1 X10 F1 S600 M3\nN20 G4 S30\nN30 X20\nN40 M30", time=5,
    )
    case(
        f"S of G4 is no speed beside an M code{told}", setup=setup, **KNOWN,
        program="N10 G95 G1 X10 F1 S600 M3\nN20 G4 S30 M8\nN30 X20\nN40 M30", time=5,
    )

# ---- a block has one code of a group ----

for codes, word in (
    ("G0 G1 X5", "G1"), ("G1 G2 X5 CR=5", "G2"), ("G17 G18", "G18"), ("G90 G91 X5", "G91"), ("G54 G55", "G55"),
    ("G94 G95", "G95"), ("G60 G64 X5", "G64"), ("G601 G602", "G602"), ("G450 G451", "G451"), ("G70 G71", "G71"),
    ("G0 G0 X5", "G0"), ("G71 G71", "G71"), ("SOFT BRISK X5", "BRISK"), ("FFWON FFWOF", "FFWOF"), ("G62 G621", "G621"),
):
    case(
        f"two codes of one group do not stand in a block: {codes}", **GROUPS,
        program=f"N10 {codes}\nN20 M30", runs="", alarm="group-given-twice", number="12060", at="MAIN N10", word=word,
    )
case(
    "codes of several groups do", **GROUPS,
    program="N10 G0 G17 G90 G54 G94 G60 G601 G71 G40 X5\nN20 M30", moves="R X5",
)
case("CR twice", **KNOWN, program="N10 G2 X1 CR=5 CR=6\nN20 M30", runs="", alarm="address-given-twice", number="12000", at="MAIN N10", word="CR=6")
case(
    "a computed length is brought to a thousandth of a millimetre",
    pins="computed_lengths", control=ONE, source="840Di p.281: MD 10200", evidence="secondary",
    program="N10 G91 G0 X1\n" + "N20 X=0.0001*4\n" * 8 + "N30 M30", final_work="X1",
)

for text in ("CYCLE977(1)", "LEADON(Y,X,1)", "REPOSA", "CTABDEF(Y,X,1,0)", "CONTPRON(TAB,\"L\",R1)", "CORROF(X,\"DRF\")", "POLFMASK(X)", "EXECUTE(R1)"):
    case(
        f"{text} is of the control, and not computed", control="siemens-one", source="policy, nobody says", evidence="inferred",
        program=f"N10 {text}\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10",
    )
for text in ("DRFOF", "CYCLE832(0.01,1,1)", "NEWCONF", "CTABDEL(1)", "MMC(\"A\",\"N\")"):
    case(
        f"{text} changes no path, and is reported", control="siemens-one", source="general knowledge of the SINUMERIK 840D",
        evidence="inferred", program=f"N10 {text}\nN20 G0 X1\nN30 M30", runs="N10 N20 N30", dropped=[text],
    )

# ---- words of the language that no run computes are no names of programs ----

for words, word in (
    ("LIFTFAST", "LIFTFAST"), ("LFTXT", "LFTXT"), ("SETINT(3) PRIO=1 LIFT_Z", "SETINT"), ("ID=1 WHEN $AA_IM[X]>5 DO M8", "ID"),
    ("WHENEVER R1>0 DO M8", "WHENEVER"), ("OSCTRL[X]=(1,0)", "OSCTRL"), ("MASLON(X)", "MASLON"), ("TANG(C,X,Y)", "TANG"),
    ('EXECSTRING("X5")', "EXECSTRING"), ("CTABLOCK(1)", "CTABLOCK"), ("PRIO=1", "PRIO"),
):
    case(
        f"{words} is not computed, and no call of a program", control=ONE, source="policy, nobody says", evidence="inferred",
        program=f"N10 {words}\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10", word=word,
    )
case(
    "a program may define a variable of such a name", control=ONE, source="NCI, defaults.mpf", evidence="secondary",
    program="N10 DEF REAL LEAD=2\nN20 G0 X=LEAD\nN30 M30", runs="N10 N20 N30", moves_x=[2],
)
case(
    "a word of the language is no value", number="12080", control=ONE, source="general knowledge of the SINUMERIK alarms", evidence="inferred",
    program="N10 IF GOTOF DONE\nN20 DONE: M30", runs="", alarm="expression-format", at="MAIN N10", word="GOTOF",
)
