"""SINUMERIK: MCALL, and the patterns that it drills."""

from conformance import case

ONE = "siemens-one"
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}
NCX = {"control": ONE, "source": "NCX, chapter 7: calling", "evidence": "secondary"}
LIST = {"control": ONE, "source": "NCX, chapter 7: patterns; the order is general knowledge", "evidence": "inferred"}
SETUP = {"work_offsets": {"G54": {"X": 12.25, "Y": -3.5, "Z": 101.125}}}
PART = "%_N_PART_SPF\nN80 R1=R1+1\nN90 M17"
HOLE = "N10 MCALL CYCLE81(50,30,2,-10)\n"


def _program(body: str, part: str = PART) -> str:
    return f"%_N_MAIN_MPF\n{body}\nN70 M30\n{part}"


case(
    "MCALL calls after each block that moves, until MCALL stands alone", **NCX,
    program=_program("N10 MCALL PART\nN20 G0 X1\nN30 G1 Y2 F100\nN40 MCALL\nN50 X3"),
    runs="N10 N20 N80 N90 N30 N80 N90 N40 N50 N70", calls="call:PART call:PART",
)
case(
    "the block with MCALL does not call yet", **NCX,
    program=_program("N10 MCALL PART\nN20 R5=1\nN30 MCALL"), runs="N10 N20 N30 N70", vars={1: None},
)
case(
    "a block without an axis does not call", **NCX,
    program=_program("N10 G0 X1\nN15 MCALL PART\nN20 M8\nN30 G0\nN40 R7=2\nN50 G4 F1"), runs="N10 N15 N20 N30 N40 N50 N70",
)
case(
    "a block with an axis calls, even where the tool is there already", pins="modal_trigger",
    control=ONE, source="general knowledge: posts write the first position again after MCALL", evidence="inferred",
    program=_program("N10 G0 X1\nN20 MCALL PART\nN30 X1\nN40 MCALL"), runs="N10 N20 N30 N80 N90 N40 N70", vars={1: 1},
)
case(
    "an arc calls too", **KNOWN,
    program=_program("N10 MCALL PART\nN20 G2 X10 CR=5 F100"), runs="N10 N20 N80 N90 N70",
)
case(
    "the values are those that MCALL had, at each call", pins="modal_locals", **KNOWN,
    program=_program(
        "N10 R2=5\nN15 MCALL PART(R2)\nN20 R2=9\nN30 G0 X1\nN40 X2\nN50 MCALL",
        "%_N_PART_SPF\nN75 PROC PART(REAL WIDE)\nN80 R1=R1+WIDE\nN85 WIDE=100\nN90 M17",
    ),
    vars={1: 10},
)
case(
    "a second MCALL takes the place of the first", pins="second_modal_call", **KNOWN,
    program=_program("N10 MCALL PART\nN20 MCALL OTHER\nN30 G0 X1\nN40 MCALL\nN50 X2", PART + "\n%_N_OTHER_SPF\nN95 M17"),
    runs="N10 N20 N30 N95 N40 N50 N70",
)
case(
    "MCALL alone without a modal call does nothing", pins="cancel_alone", **KNOWN,
    program=_program("N10 MCALL\nN20 G0 X1"), runs="N10 N20 N70",
)
case(
    "what moves in a subprogram is followed by the call too", pins="calls_in_modal", **KNOWN,
    program=_program("N10 MCALL PART\nN20 ROW\nN30 MCALL", PART + "\n%_N_ROW_SPF\nN95 G0 X1\nN96 X2\nN97 M17"),
    runs="N10 N20 N95 N80 N90 N96 N80 N90 N97 N30 N70",
)
case(
    "what moves in the program that MCALL calls is not", **KNOWN,
    program=_program("N10 MCALL PART\nN20 G0 X1\nN30 MCALL", "%_N_PART_SPF\nN80 G0 Z5\nN90 M17"),
    runs="N10 N20 N80 N90 N30 N70",
)
case(
    "MCALL with a name that no program has alarms at the first call", **KNOWN,
    program=_program("N10 MCALL NOBODY\nN15 R1=1\nN20 G0 X1"),
    runs="N10 N15 N20", alarm="named-program-not-found", number="14011", at="MAIN N20", word="G0",
)
case(
    "MCALL has a block of its own", **KNOWN,
    program=_program("N10 G0 X5 MCALL PART"), runs="", alarm="illegal-word-with-call", at="MAIN N10", word="MCALL PART",
)
case(
    "MCALL is followed by a name", **KNOWN,
    program=_program("N10 MCALL 5"), runs="", alarm="statement-format", at="MAIN N10", word="MCALL",
)
case(
    "MCALL with a cycle that is not computed is told", **KNOWN,
    program=_program("N10 MCALL POCKET4(50,0,1,-5)\nN20 G0 X1"), runs="", alarm="code-not-computed", at="MAIN N10", word="POCKET4",
)

# ---- patterns ----


def _pattern(claim: str, pattern: str, moves: str, start: str = "X0 Y0", **said: object) -> None:
    """Add a row of a pattern without a cycle, called at a place."""
    case(
        claim, program=f"N10 G0 {start} Z60\nN20 {pattern}\nN30 M30", setup=SETUP,
        moves=f"R {start} Z60\n{moves}", **{**LIST, **said},
    )


case(
    "a cycle is drilled at each position", **NCX, setup=SETUP,
    program=f"N5 G0 X0 Y0 Z60 F100\n{HOLE}N20 G0 X1 Y2\nN30 X3\nN40 MCALL\nN50 X5\nN60 M30",
    moves="R X0 Y0 Z60\nR X1 Y2\nR Z32\nF Z-10\nR Z50\nR X3\nR Z32\nF Z-10\nR Z50\nR X5",
)
case(
    "MCALL drills a row of holes", **LIST, setup=SETUP,
    program=f"N5 G0 X0 Y0 Z60 F100\n{HOLE}N20 HOLES1(10,20,0,5,15,2)\nN30 MCALL\nN60 M30",
    moves="R X0 Y0 Z60\nR X15 Y20\nR Z32\nF Z-10\nR Z50\nR X30\nR Z32\nF Z-10\nR Z50",
    calls="call:HOLES1 call:CYCLE81 call:CYCLE81",
)
_pattern(
    "a row turns about its reference point", "HOLES1(10,20,90,5,15,3)", "R X10 Y25\nR Y40\nR Y55",
)
_pattern(
    "a row begins at the end that is nearer", "HOLES1(10,20,0,5,15,3)", "R X45 Y20\nR X30\nR X15", "X100 Y0",
)
case(
    "in G18 a row lies in Z and X", **LIST, setup=SETUP,
    program="N10 G18 G0 X0 Y0 Z60\nN20 HOLES1(10,20,0,5,15,2)\nN30 M30", moves="R X0 Y0 Z60\nR X20 Z30\nR Z15",
)
_pattern("a row without holes is 61103", "HOLES1(10,20,0,5,15,0)", "", alarm="user-alarm", number="61103")
_pattern(
    "holes on a circle begin at the angle named", "HOLES2(10,20,5,90,60,3)",
    "R X10 Y25\nR X5.66987 Y22.5\nR X5.66987 Y17.5",
)
_pattern(
    "without an angle between them they share the circle", "HOLES2(10,20,5,0,0,4)", "R X15 Y20\nR X10 Y25\nR X5 Y20\nR X10 Y15",
)
_pattern(
    "a negative angle goes clockwise", "HOLES2(10,20,5,0,-90,2)", "R X15 Y20\nR X10 Y15",
)
_pattern("a circle without holes is 61103", "HOLES2(10,20,5,0,0,0)", "", alarm="user-alarm", number="61103")
_pattern(
    "a grid is drilled line by line, each the other way than the one before", "CYCLE801(10,20,0,15,10,3,2)",
    "R X10 Y20\nR X25\nR X40\nR Y30\nR X25\nR X10",
)
_pattern(
    "a grid begins at the corner that is nearest", "CYCLE801(10,20,0,15,10,3,2)",
    "R X40 Y30\nR X25\nR X10\nR Y20\nR X25\nR X40", "X100 Y100",
)
_pattern("a grid turns about its corner", "CYCLE801(10,20,90,15,10,2,2)", "R X10 Y20\nR Y35\nR X0\nR Y20", "X12 Y18")
for _call in ('HOLES1(10,20,0,5,15,3,0,0,"2")', 'HOLES2(10,20,5,0,90,3,0,0,"2")', 'CYCLE801(10,20,0,15,10,3,2,0,0,0,0,"2")'):
    _pattern(f"positions that are left out are not computed: {_call[:6]}", _call, "", alarm="code-not-computed", word="_HIDE_OF_PATTERN")
_pattern(
    "another way along a circle is not computed", "HOLES2(10,20,5,0,90,3,1000)", "", alarm="code-not-computed", word="_VARI_OF_HOLES2",
)
_pattern(
    "a frame is not computed", "CYCLE801(10,20,0,15,10,3,2,1)", "", alarm="code-not-computed", word="_VARI_OF_CYCLE801",
)
_pattern("a grid without lines is 61103", "CYCLE801(10,20,0,15,10,3,0)", "", alarm="user-alarm", number="61103")
