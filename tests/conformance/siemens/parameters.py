"""SINUMERIK: PROC, its parameters, and calls with values."""

from conformance import case

ONE = "siemens-one"
PASSED = {"control": ONE, "source": "SONE p.494, parameter transfer", "evidence": "maker's manual"}
TYPES = {"control": ONE, "source": "840Da p.45, conversions of types", "evidence": "secondary"}
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}
NUMBERS = {"control": ONE, "source": "general knowledge of the SINUMERIK alarms", "evidence": "inferred"}
POLICY = {"control": ONE, "source": "policy, nobody says", "evidence": "inferred"}


def _call(call: str, head: str, body: str = "", before: str = "") -> str:
    return (
        f"%_N_MAIN_MPF\n{before}N20 {call}\nN30 M30\n%_N_PART_SPF\nN40 PROC PART{head}\n{body}N60 M17"
    )


case(
    "a program may begin with its name", **PASSED,
    program="%_N_MAIN_MPF\nN5 PROC MAIN\nN20 PART\nN30 M30\n%_N_PART_SPF\nN40 PROC PART\nN50 G0 X1\nN60 RET",
    runs="N5 N20 N40 N50 N60 N30",
)
for words in ("SAVE", "DISPLOF", "SBLOF", "ACTBLOCNO", "SAVE DISPLOF", "SBLOF DISPLOF ACTBLOCNO"):
    case(
        f"PROC takes {words}", **KNOWN,
        program=_call("PART", f" {words}", "N50 G0 X1\n"), runs="N20 N40 N50 N60 N30",
    )
case(
    "other words do not follow PROC", **KNOWN,
    program=_call("PART", " G0 X1"), runs="N20", alarm="statement-format", at="PART N40", word="G0",
)
case(
    "PROC is the first block", **KNOWN,
    program="%_N_MAIN_MPF\nN10 G0 X1\nN20 PROC MAIN\nN30 M30", runs="N10", alarm="statement-format", at="MAIN N20", word="PROC",
)
case(
    "values come in the order of the parameters", **PASSED,
    program=_call("PART(5.5, R1, R1+1)", "(REAL WIDE, REAL HIGH, REAL DEEP)", "N50 R2=WIDE R3=HIGH R4=DEEP\n", "N10 R1=20\n"),
    vars={2: 5.5, 3: 20, 4: 21}, calls="call:PART", runs="N10 N20 N40 N50 N60 N30",
)
case(
    "a value that is left out is 0", **PASSED,
    program=_call("PART(5,,7)", "(REAL WIDE, REAL HIGH, REAL DEEP)", "N50 R2=WIDE R3=HIGH+1 R4=DEEP\n"), vars={2: 5, 3: 1, 4: 7},
)
case(
    "and so are those after the last", **PASSED,
    program=_call("PART(5)", "(REAL WIDE, REAL HIGH, REAL DEEP)", "N50 R2=WIDE R3=HIGH+1 R4=DEEP+1\n"), vars={2: 5, 3: 1, 4: 1},
)
case(
    "a comma after the last value may stand", **PASSED,
    program=_call("PART(5,)", "(REAL WIDE, REAL HIGH)", "N50 R2=WIDE R3=HIGH+1\n"), vars={2: 5, 3: 1},
)
case(
    "a call without values leaves all out", **PASSED,
    program=_call("PART", "(REAL WIDE, REAL HIGH)", "N50 R2=WIDE+1 R3=HIGH+1\n"), vars={2: 1, 3: 1},
)
case(
    "a parameter may have a value of its own for a call that leaves it out", **KNOWN,
    program=_call("PART(,4)", "(REAL WIDE=2.5, REAL HIGH=-3, BOOL FLAG=TRUE)", "N50 R2=WIDE R3=HIGH R4=FLAG\n"),
    vars={2: 2.5, 3: 4, 4: 1},
)
case(
    "a parameter is local to the call", **PASSED,
    program=_call("PART(WIDE)", "(REAL WIDE)", "N50 WIDE=WIDE+1\nN55 R2=WIDE\n", "N10 DEF REAL WIDE=20\n") .replace("N30 M30", "N25 R1=WIDE\nN30 M30"),
    vars={1: 20, 2: 21},
)
case(
    "VAR gives the caller's variable the value that the parameter has at the return", **KNOWN,
    program=_call("PART(R1, WIDE)", "(VAR REAL FIRST, VAR REAL NEXT)", "N50 FIRST=FIRST+1 NEXT=7\n", "N5 DEF REAL WIDE=3\nN10 R1=20\n")
    .replace("N30 M30", "N25 R2=WIDE\nN30 M30"),
    vars={1: 21, 2: 7},
)
case(
    "a parameter without VAR leaves it as it is", **KNOWN,
    program=_call("PART(R1)", "(REAL FIRST)", "N50 FIRST=9\n", "N10 R1=20\n"), vars={1: 20},
)
case(
    "VAR takes a variable and no value", **NUMBERS, number="12320",
    program=_call("PART(R1+1)", "(VAR REAL FIRST)"), runs="", alarm="parameter-no-variable", at="MAIN N20", word="R1+1",
)
case(
    "each open call has parameters of its own", **KNOWN,
    program=_call("PART(3)", "(INT COUNT)", "N50 IF COUNT>1\nN52 PART(COUNT-1)\nN54 ENDIF\nN56 R[COUNT]=COUNT*10\n"),
    vars={1: 10, 2: 20, 3: 30},
)
case(
    "an INT parameter rounds, a BOOL one is 0 or 1", **TYPES,
    program=_call("PART(2.5, 7)", "(INT COUNT, BOOL FLAG)", "N50 R1=COUNT R2=FLAG\n"), vars={1: 3, 2: 1},
)
case(
    "a parameter may have the name of an axis: the manual's example", control=ONE,
    source="SONE p.493, PROC CONTOUR (REAL X, REAL Y)", evidence="maker's manual",
    program=_call("PART(5.5, WIDE)", " (REAL X, REAL Y)", "N50 R1=X R2=Y\n", "N10 DEF REAL WIDE=20.0\n"), vars={1: 5.5, 2: 20},
)
case(
    "but whether X= is the axis then is not computed", **POLICY,
    program=_call("PART(5.5)", "(REAL X)", "N50 G0 X=5\n"), runs="N20 N40", alarm="code-not-computed", at="PART N50",
)
case(
    "a text is passed to a STRING, cut at its length", **KNOWN,
    program=_call('PART("A, BC", 4)', "(STRING[4] NOTE, REAL WIDE)", "N50 R1=WIDE\nN55 MSG(NOTE)\n"),
    vars={1: 4}, runs="N20 N40 N50 N55 N60 N30", messages=["A, B"],
)
case(
    "a number is no text", **NUMBERS, number="12330",
    program=_call("PART(4)", "(STRING[20] NOTE)"), runs="", alarm="parameter-type", at="MAIN N20", word="4",
)
case(
    "a text is no number", **NUMBERS, number="12330",
    program=_call('PART("A")', "(REAL WIDE)"), runs="", alarm="parameter-type", at="MAIN N20", word='"A"',
)
case(
    "more values than parameters alarm", control=ONE, source="general knowledge of the SINUMERIK alarms", evidence="inferred",
    program=_call("PART(1,2)", "(REAL WIDE)"), runs="", alarm="too-many-arguments", number="14020", at="MAIN N20",
)
case(
    "a program without PROC takes none", control=ONE, source="general knowledge of the SINUMERIK alarms", evidence="inferred",
    program="%_N_MAIN_MPF\nN10 CUT(2,5)\nN20 M30\n%_N_CUT_SPF\nN40 M17",
    runs="", alarm="too-many-arguments", number="14020", at="MAIN N10",
)
case(
    "empty brackets are no values", **KNOWN,
    program="%_N_MAIN_MPF\nN10 CUT()\nN20 M30\n%_N_CUT_SPF\nN40 M17", runs="N10 N40 N20",
)
case(
    "a program that is not there alarms, with values or without", **KNOWN,
    program="N10 CUT(R1,5)\nN20 M30", runs="", alarm="named-program-not-found", number="14011", at="MAIN N10",
)
case(
    "values stand in brackets that close", **KNOWN,
    program=_call("PART(1", "(REAL WIDE)"), runs="", alarm="bracket-not-closed", number="12080", at="MAIN N20",
)
case(
    "a value follows the bracket of a call, or the one that closes it", **KNOWN,
    program=_call("PART(", "(REAL WIDE)"), runs="", alarm="expression-format", number="12080", at="MAIN N20",
)
case(
    "the list of PROC closes too", **KNOWN,
    program=_call("PART(1)", "(REAL WIDE"), runs="N20", alarm="bracket-not-closed", number="12080", at="PART N40",
)
case(
    "a parameter has a type", **KNOWN,
    program=_call("PART", "(WIDE)"), runs="N20", alarm="statement-format", at="PART N40",
)
case(
    "and is named once", control=ONE, source="general knowledge of the SINUMERIK alarms", evidence="inferred",
    program=_call("PART", "(REAL WIDE, INT WIDE)"), runs="N20", alarm="variable-given-twice", number="12170", at="PART N40",
)
case(
    "values and a count", **KNOWN,
    program=_call("PART(4) P2", "(REAL WIDE)", "N50 R1=R1+WIDE\n"), vars={1: 8}, runs="N20 (N40 N50 N60)*2 N30",
)
case(
    "a main program that declares parameters runs with their own values", **KNOWN,
    program="%_N_MAIN_MPF\nN10 PROC MAIN(REAL WIDE, REAL HIGH=4)\nN20 R1=WIDE+1 R2=HIGH\nN30 M30", vars={1: 1, 2: 4},
)

# ---- SAVE ----

for save, moves in (("", "F X1\nR X4\nR X7"), (" SAVE", "F X1\nR X4\nF X3")):
    case(
        f"the codes of the caller come back after PROC PART{save}" if save else "without SAVE the codes of the program stay",
        control=ONE, source="general knowledge of the SINUMERIK 840D", evidence="inferred",
        program=f"%_N_MAIN_MPF\nN10 G90 G1 X1 F100\nN20 PART\nN30 X3\nN40 M30\n%_N_PART_SPF\nN50 PROC PART{save}\nN60 G91 G0 X3\nN70 M17",
        moves=moves,
    )
case(
    "SAVE brings the work offset back", control=ONE, source="828Db p.793, SAVE and settable frames", evidence="secondary",
    setup={"work_offsets": {"G54": {"X": 1.125}, "G55": {"X": 100}}},
    program="%_N_MAIN_MPF\nN10 G54 G0 X1\nN20 PART\nN30 X2\nN40 M30\n%_N_PART_SPF\nN50 PROC PART SAVE\nN60 G55 X3\nN70 M17",
    centre="X2.125 | X103 | X3.125",
)
case(
    "F and S stay as SAVE's program leaves them", **KNOWN,
    program="%_N_MAIN_MPF\nN10 G1 X60 F60\nN20 PART\nN30 X240\nN40 M30\n%_N_PART_SPF\nN50 PROC PART SAVE\nN60 G1 X120 F120\nN70 M17",
    time=60 + 30 + 60,
)
case(
    "a CHAR takes a character between quotes", **TYPES,
    program=_call('PART("A", 66)', "(CHAR FIRST, CHAR LAST)", "N50 R1=FIRST R2=LAST\n"), vars={1: 65, 2: 66},
)
case(
    "and no text of two", **NUMBERS, number="12330",
    program=_call('PART("AB")', "(CHAR FIRST)"), runs="", alarm="parameter-type", at="MAIN N20", word='"AB"',
)
case(
    "an element of an array may stand for a VAR parameter, and R[...]", **KNOWN,
    program=_call("PART(GRID[AT],R[AT+1],GRID[AT,0])".replace("GRID[AT,0]", "R4"), "(VAR REAL FIRST, VAR REAL NEXT, VAR REAL LAST)",
                  "N50 FIRST=FIRST+1 NEXT=NEXT+2 LAST=9\n", "N5 DEF REAL GRID[3]=SET(10,20,30)\nN7 DEF INT AT=1\nN10 R2=5\n")
    .replace("N30 M30", "N25 R5=GRID[0] R6=GRID[1] R7=GRID[2]\nN30 M30"),
    vars={2: 7, 4: 9, 5: 10, 6: 21, 7: 30},
)
case(
    "an element with an operator beside it is no variable", **KNOWN,
    program=_call("PART(GRID[1]+1)", "(VAR REAL FIRST)", "", "N5 DEF REAL GRID[3]\n"), runs="N5",
    alarm="parameter-no-variable", number="12320", at="MAIN N20", word="GRID[1]+1",
)

# ---- which parameters a call gives ----

GIVEN = {"control": ONE, "source": "MD840, variables.svar: $P_SUBPAR", "evidence": "secondary"}
HEAD, ASKS = "(INT AA, REAL BB=5, STRING[8] CC)", "N50 R1=$P_SUBPAR[1] R2=$P_SUBPAR[2] R3=$P_SUBPAR[3]\n"
for call, given in [
    ("PART(1,2,\"A\")", (1, 1, 1)), ("PART(1)", (1, 0, 0)), ("PART(,2)", (0, 1, 0)), ("PART(,,\"A\")", (0, 0, 1)),
    ("PART", (0, 0, 0)), ("PART()", (0, 0, 0)), ('CALL "PART"', (0, 0, 0)), ('CALL "PA"<<"RT"', (0, 0, 0)),
]:
    case(
        f"$P_SUBPAR says which parameters {call} gives", **GIVEN,
        program=_call(call, HEAD, ASKS), vars=dict(zip((1, 2, 3), given)), runs="N20 N40 N50 N60 N30",
    )
case(
    "$P_SUBPAR decides a condition", **GIVEN,
    program=_call("PART(1)", HEAD, "N50 IF $P_SUBPAR[2]==FALSE\nN52 R9=BB\nN54 ENDIF\n"), vars={9: 5}, runs="N20 N40 N50 N52 N54 N60 N30",
)
for number in ("0", "4"):
    case(
        f"the program has no parameter {number} to ask for", **POLICY,
        program=_call("PART(1)", HEAD, f"N50 R1=$P_SUBPAR[{number}]\n"), runs="N20 N40", alarm="code-not-computed", at="PART N50",
    )
case(
    "a computed parameter to ask for is not computed", **POLICY,
    program=_call("PART(1)", HEAD, "N50 R1=$P_SUBPAR[R5]\n"), runs="N20 N40", alarm="code-not-computed", at="PART N50",
    word="$P_SUBPAR[",
)
case(
    "$P_SUBPAR has an index", **KNOWN,
    program=_call("PART(1)", HEAD, "N50 R1=$P_SUBPAR\n"), runs="N20 N40", alarm="bracket-not-opened", number="12080", at="PART N50",
)
