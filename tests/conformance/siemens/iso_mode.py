"""SINUMERIK: the ISO mode, between G291 and G290 and in programs that ISOCALL calls."""

from conformance import case

ONE = "siemens-one"
MODE = {"18800": 1}
KNOWN = {
    "control": ONE, "source": "general knowledge of the SINUMERIK ISO dialects", "evidence": "inferred", "params": MODE,
}
SWITCH = {
    "control": ONE, "source": "CNCC: G290 and G291 with machine datum 18800", "evidence": "secondary", "params": MODE,
}
CROSSED = {
    "machine": "mill", "start": {"X": 0, "Y": 0, "Z": 100},
    "work_offsets": {"G54": {"X": 10.125, "Y": -20.5, "Z": 3.25}, "G505": {"X": 1.5, "Y": 2.5, "Z": 3.5}},
}

# ---- G291 and G290 ----

case(
    "between G291 and G290 blocks are written as on another control", **SWITCH,
    program="N10 R1=5\nN20 G291\nN30 G0 X1. (X1)\nN40 G290\nN50 G0 X=R1\nN60 M30",
    runs="N10 N20 N30 N40 N50 N60", vars={1: 5}, setup=CROSSED,
    moves="R X1\nR X5",
)
case(
    "a main program may end in ISO mode", **KNOWN,
    program="N10 G291\nN20 G0 X1.\nN30 M30", runs="N10 N20 N30", setup=CROSSED, moves="R X1",
)
case(
    "G290 outside of the ISO mode and G291 inside of it change nothing", **KNOWN,
    program="N10 G290\nN20 R1=2\nN30 G291\nN40 G291\nN50 G21\nN60 M30", runs="N10 N20 N30 N40 N50 N60", vars={1: 2},
)
case(
    "without machine datum 18800 there is no ISO mode", control=ONE, source="MD840, MD 18800", evidence="secondary",
    program="N10 G291\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10", word="G291",
)
case(
    "the ISO mode of a lathe is not computed", control=ONE, source="policy, nobody says", evidence="inferred",
    params={"18800": 1, "10880": 2},
    program="N10 G291\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10", word="G291",
)
for words, word in (("G291 X1", "G291"), ("G0 G291", "G291"), ("/G291", "G291")):
    case(
        f"{words} is not computed: the mode changes in a block of its own", control=ONE, source="policy, nobody says", evidence="inferred",
        params=MODE, program=f"N10 {words}\nN20 M30" if words[0] != "/" else f"/N10 {words[1:]}\nN20 M30",
        runs="", alarm="code-not-computed", at="MAIN N10", word=word,
    )
for words, _at in (("X=5", "X=5"), ("R1=5", "R1"), ("IF R1==1", "IF"), ("#1=5", "#")):
    case(
        f"{words} is no block in ISO mode", **{**KNOWN, "source": "policy, nobody says"},
        program=f"N10 G291\nN20 {words}\nN30 M30", runs="N10", at="MAIN N20",
        alarm="code-not-computed",
    )
case(
    "a jump between the modes is not computed", **{**KNOWN, "source": "policy, nobody says"},
    program="N10 GOTOF N30\nN20 G291\nN30 G0 X1.\nN40 G290\nN50 M30", runs="", alarm="code-not-computed", at="MAIN N10", word="N30",
)
case(
    "a jump over a part in ISO mode stays in its mode", **KNOWN,
    program="N10 GOTOF N50\nN20 G291\nN30 G0 X1.\nN40 G290\nN50 R1=3\nN60 M30", runs="N10 N50 N60", vars={1: 3},
)
case(
    "a return in another mode than the program began in is not computed", **{**KNOWN, "source": "policy, nobody says"},
    program="%_N_MAIN_MPF\nN10 SUB\nN20 M30\n%_N_SUB_SPF\nN30 G291\nN40 G0 X1.\nN50 M17",
    runs="N10 N30 N40", alarm="code-not-computed", at="SUB N50", setup=CROSSED,
)
case(
    "nor is that by M30 of a program that another one calls", **{**KNOWN, "source": "policy, nobody says"},
    program="%_N_MAIN_MPF\nN10 SUB\nN20 M30\n%_N_SUB_SPF\nN30 G291\nN40 G0 X1.\nN50 M30",
    runs="N10 N30 N40", alarm="code-not-computed", at="SUB N50", setup=CROSSED,
)
case(
    "M30 of a program called so returns where it is in the mode that it began in", **KNOWN,
    program="%_N_MAIN_MPF\nN10 SUB\nN20 M30\n%_N_SUB_SPF\nN30 G291\nN40 G0 X1.\nN45 G290\nN50 M30", runs="N10 N30 N40 N45 N50 N20", setup=CROSSED,
)

# ---- what the words mean ----

case(
    "G20 and G21 are the inch and the millimetre of lengths and feeds", **KNOWN, setup=CROSSED,
    program="N10 G291\nN20 G20\nN30 G1 X1. F10.\nN40 G21\nN50 X1.\nN60 M30",
    runs="N10 N20 N30 N40 N50 N60", moves="F X25.4\nF X1",
)
case(
    "a length without a point is one of millimetres", **KNOWN, setup=CROSSED,
    program="N10 G291\nN20 G0 X1000\nN30 M30", runs="N10 N20 N30", moves="R X1000",
)
case(
    "R is the radius of an arc", **KNOWN, setup=CROSSED,
    program="N10 G291\nN20 G0 X0. Y0.\nN30 G2 X10. Y0. R5. F100.\nN40 M30",
    runs="N10 N20 N30 N40", moves="R X0 Y0\nCW X10 Y0 C X5 Y0",
)
case(
    "G58 is the system G505", **KNOWN, setup=CROSSED,
    program="N10 G291\nN20 G58\nN30 G0 X1.\nN40 M30", runs="N10 N20 N30 N40", moves="R X1 Y-23 Z99.75", final_machine="X2.5",
)
for words, seconds in (("X2.5", 2.5), ("P2500", 2.5)):
    case(
        f"G4 {words} waits for {seconds} seconds", **KNOWN, setup=CROSSED,
        program=f"N10 G291\nN20 G4 {words}\nN30 M30", runs="N10 N20 N30", moves=f"W {seconds}",
    )
for code in ["10", "28", "30", "31", "43", "44", "49", "50", "51", "52", "65", "66", "67", "68", "73", "74", "76", "81", "82", "83", "84", "85", "86", "87", "89", "92"]:
    case(
        f"G{code} in ISO mode is not computed", **{**KNOWN, "source": "policy, nobody says"},
        program=f"N10 G291\nN20 G{code}\nN30 M30", runs="N10", alarm="code-not-computed", at="MAIN N20", word=f"G{code}",
    )
for code in ["69", "80", "98", "99"]:
    case(
        f"G{code} in ISO mode changes no path", **KNOWN,
        program=f"N10 G291\nN20 G{code}\nN30 M30", runs="N10 N20 N30",
    )
case(
    "a comment in ISO mode has its )", **KNOWN,
    program="N10 G291\nN20 G0 (OPEN\nN30 M30", runs="N10", alarm="comment-not-closed", at="MAIN N20",
)
for words, alarm, word in (
    ("Q5", "address-not-usable", "Q5"), ("G0 L5", "address-not-usable", "L5"),
    ("G0 P5", "address-not-usable", "P5"), ("T1.5", "whole-number-expected", "T1.5"),
    ("!", "illegal-character", "!"), ("G0 ,R5.", "code-not-computed", ","), ("D1", "code-not-computed", "D1"), ("H1", "code-not-computed", "H1"),
    ("M96 P1", "code-not-computed", "M96"), ("G290 X1.", "code-not-computed", "G290"),
):
    case(
        f"{words} in ISO mode stops the run", **{**KNOWN, "source": "policy, nobody says"},
        program=f"N10 G291\nN20 {words}\nN30 M30", runs="N10", alarm=alarm, at="MAIN N20", word=word,
    )

for words, alarm, word, number in (("X", "address-without-value", "X", "12080"), ("G0 X1. X2.", "axis-given-twice", "X2.", "16420")):
    case(
        f"{words} in ISO mode alarms as in the own language", number=number, **KNOWN,
        program=f"N10 G291\nN20 {words}\nN30 M30", runs="N10", alarm=alarm, at="MAIN N20", word=word,
    )

# ---- ISOCALL, M98 and M99 ----

case(
    "ISOCALL calls a program in ISO mode, and its end brings the own language back", **KNOWN, setup=CROSSED,
    program='%_N_MAIN_MPF\nN10 ISOCALL "0122"\nN20 G0 X=2*3\nN30 M30\n%_N_0122_SPF\nN40 G0 X1. (X1)\nN50 M99',
    runs="N10 N40 N50 N20 N30", calls="call:0122", moves="R X1\nR X6",
)
case(
    "the program may stand in a file before the main program, as a tape of another control", **KNOWN,
    files={"0122.SPF": "%\nO0122 (PART)\nN40 G0 X1.\nN50 M99\n%\n", "MAIN.MPF": 'N10 ISOCALL "0122"\nN20 M30\n'},
    main="MAIN", runs="N10 N40 N50 N20", calls="call:0122",
)
case(
    "ISOCALL takes a path", **KNOWN,
    program='%_N_MAIN_MPF\nN10 ISOCALL "/_N_CUS_DIR/_N_PART_SPF"\nN20 M30\n%_N_PART_SPF\nN40 G0 X1. (X1)\nN50 M99',
    runs="N10 N40 N50 N20",
)
case(
    "M17 ends a program in ISO mode too", **KNOWN,
    program='%_N_MAIN_MPF\nN10 ISOCALL "PART"\nN20 M30\n%_N_PART_SPF\nN40 G0 X1. (X1)\nN50 M17',
    runs="N10 N40 N50 N20",
)
case(
    "M99 P returns to a block of the caller", **KNOWN,
    program='%_N_MAIN_MPF\nN10 ISOCALL "PART"\nN20 R1=1\nN30 M30\n%_N_PART_SPF\nN40 G0 X1. (X1)\nN50 M99 P30',
    runs="N10 N40 N50 N30",
)
case(
    "M98 P calls a program of this number in ISO mode", **KNOWN,
    program="%_N_MAIN_MPF\nN10 G291\nN20 M98 P21\nN30 G290\nN40 M30\n%_N_21_SPF\nN50 G0 X1. (X1)\nN60 M99",
    runs="N10 N20 N50 N60 N30 N40", calls="M98:21",
)
case(
    "the digits before the last four are how often", **KNOWN,
    program="%_N_MAIN_MPF\nN10 G291\nN20 M98 P30021\nN30 M30\n%_N_0021_SPF\nN50 G0 X1. (X1)\nN60 M99",
    runs="N10 N20 (N50 N60)*3 N30",
)
case(
    "or L is", **KNOWN,
    program="%_N_MAIN_MPF\nN10 G291\nN20 M98 P21 L2\nN30 M30\n%_N_21_SPF\nN50 G0 X1. (X1)\nN60 M99",
    runs="N10 N20 (N50 N60)*2 N30",
)
case(
    "the words beside M98 come first", **KNOWN, setup=CROSSED,
    program="%_N_MAIN_MPF\nN10 G291\nN20 G0 X5. M98 P21\nN30 M30\n%_N_21_SPF\nN50 X1. (X1)\nN60 M99",
    runs="N10 N20 N50 N60 N30", moves="R X5\nR X1",
)
case(
    "a program that one in ISO mode calls is in ISO mode, down to the last", **KNOWN,
    program='%_N_MAIN_MPF\nN10 ISOCALL "1"\nN20 M30\n%_N_1_SPF\nN30 M98 P2\nN40 M99\n%_N_2_SPF\nN50 M98 P3 (X1)\nN60 M99\n'
    "%_N_3_SPF\nN70 G0 X1. (X1)\nN80 M99",
    runs="N10 N30 N50 N70 N80 N60 N40 N20", tree="call:1(M98:2(M98:3))",
)
case(
    "G290 in a program in ISO mode lets it write its own language", **KNOWN,
    program='%_N_MAIN_MPF\nN10 ISOCALL "1"\nN20 M30\n%_N_1_SPF\nN30 G290\nN40 R1=2*3\nN50 G291\nN60 M99',
    runs="N10 N30 N40 N50 N60 N20", vars={1: 6},
)
case(
    "the modal codes and the position stay over a call in ISO mode", **KNOWN, setup=CROSSED,
    program='%_N_MAIN_MPF\nN10 G91 G1 X1 F100\nN20 ISOCALL "1"\nN30 X1\nN40 M30\n%_N_1_SPF\nN50 X2. (X1)\nN60 G90 X9.\nN70 M99',
    runs="N10 N20 N50 N60 N70 N30 N40", moves="F X1\nF X3\nF X9\nF X1",
)
case(
    "without machine datum 18800 ISOCALL calls in the own language", control=ONE,
    source="general knowledge of the SINUMERIK ISO dialects", evidence="inferred",
    program='%_N_MAIN_MPF\nN10 ISOCALL "PART"\nN20 M30\n%_N_PART_SPF\nN40 R1=2*3\nN50 M17', runs="N10 N40 N50 N20", vars={1: 6},
)
case(
    "a program that ISOCALL does not find", number="14011", **KNOWN,
    program='N10 ISOCALL "NONE"\nN20 M30', runs="", alarm="named-program-not-found", at="MAIN N10",
)
case(
    "a program that M98 does not find", number="14011", **KNOWN,
    program="N10 G291\nN20 M98 P7\nN30 M30", runs="N10", alarm="named-program-not-found", at="MAIN N20",
)
case(
    "M98 calls at most 15 levels deep", number="14012", **{**KNOWN, "source": "828D p.490: 16 program levels", "evidence": "secondary"},
    program="%_N_MAIN_MPF\nN10 G291\nN20 M98 P1\nN30 M30\n%_N_1_SPF\nN40 M98 P1\nN50 M99",
    runs="N10 N20 N40*14", alarm="nesting-too-deep", at="1 N40",
)
for words, alarm, word in (
    ("M98", "program-number-missing", "M98"), ("M98 P1.5", "illegal-program-number", "P1.5"), ("M98 P-1", "illegal-program-number", "P-1"),
    ("M98 P123456789", "too-many-digits", "P123456789"), ("M98 P20001 L2", "code-not-computed", "L2"), ("M98 M98 P1", "call-given-twice", "M98"),
    ("M98 P1 M30", "code-not-computed", "M98"), ("M99 M30", "code-not-computed", "M99"),
):
    case(
        f"{words} in ISO mode is refused", **{**KNOWN, "source": "policy, nobody says"},
        program=f"%_N_MAIN_MPF\nN10 G291\nN20 {words}\nN30 M30\n%_N_1_SPF\nN40 M99", runs="N10", alarm=alarm, at="MAIN N20", word=word,
    )
case(
    "M98 P1 L0 is no count", number="14013", **KNOWN,
    program="%_N_MAIN_MPF\nN10 G291\nN20 M98 P1 L0\nN30 M30\n%_N_1_SPF\nN40 M99",
    runs="N10", alarm="illegal-repeat-count", at="MAIN N20", word="L0",
)
for words in ("ISOCALL PROGNAME", 'ISOCALL "P" << 1'):
    case(
        f"{words}: a name that is computed is not", **{**KNOWN, "source": "policy, nobody says"},
        program=f'N5 DEF STRING[9] PROGNAME="P1"\nN10 {words}\nN20 M30', runs="N5", alarm="code-not-computed", at="MAIN N10",
    )
case(
    "a program that is called in both modes is not computed in its own language", **{**KNOWN, "source": "policy, nobody says"},
    program='%_N_MAIN_MPF\nN10 ISOCALL "PART"\nN20 PART\nN30 M30\n%_N_PART_SPF\nN40 G0 X1.\nN50 M99',
    runs="N10 N40 N50", alarm="code-not-computed", at="MAIN N20", word="PART",
)
for words in ('ISOCALL ""', "ISOCALL"):
    case(
        f"{words} names no program", number=None if '"' in words else "12080", **KNOWN, program=f"N10 {words}\nN20 M30", runs="", at="MAIN N10",
        alarm="illegal-program-name" if '"' in words else "expression-format",
    )
case(
    "nothing follows ISOCALL", **KNOWN, program='N10 ISOCALL "1" X5\nN20 M30\n%_N_1_SPF\nN30 M99', runs="", alarm="statement-format",
    at="MAIN N10", word="X5",
)
