"""SINUMERIK: parameters by reference stand for the caller's variable, and arrays as parameters."""

from conformance import case

ONE = "siemens-one"
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D: call by reference", "evidence": "inferred"}
NUMBERS = {"control": ONE, "source": "general knowledge of the SINUMERIK alarms", "evidence": "inferred"}
POLICY = {"control": ONE, "source": "policy, nobody says", "evidence": "inferred"}


def _call(call: str, head: str, body: str = "", before: str = "", after: str = "") -> str:
    return (
        f"%_N_MAIN_MPF\n{before}N20 {call}\n{after}N30 M30\n%_N_PART_SPF\nN40 PROC PART{head}\n{body}N60 M17"
    )


# ---- variables ----

case(
    "a parameter by reference follows an R parameter that is changed by its own name", **KNOWN,
    program=_call("PART(R1)", "(VAR REAL FIRST)", "N50 R1=7\nN55 R2=FIRST\n", "N10 R1=5\n"),
    vars={1: 7, 2: 7}, runs="N10 N20 N40 N50 N55 N60 N30",
)
case(
    "and changes it at once, not at the return", **KNOWN,
    program=_call("PART(R1)", "(VAR REAL FIRST)", "N50 FIRST=8\nN55 R2=R1\nN57 R1=9\n", "N10 R1=5\n"), vars={1: 9, 2: 8},
)
case(
    "it stands for a variable of all programs in the same way", **KNOWN,
    files={"MAIN.MPF": "N10 PART(DEPTH)\nN20 R1=DEPTH\nN30 M30\n", "UGUD.DEF": "DEF NCK REAL DEPTH=3\nM17\n",
           "PART.SPF": "N40 PROC PART(VAR REAL OWN)\nN50 DEPTH=4\nN55 R2=OWN OWN=OWN+1\nN60 M17\n"},
    vars={1: 5, 2: 4},
)
case(
    "the index that names it counts at the call", **KNOWN,
    program=_call("PART(R[R1])", "(VAR REAL FIRST)", "N50 R1=3\nN55 FIRST=9\n", "N10 R1=2\n"), vars={1: 3, 2: 9, 3: None},
)
case(
    "and so does that of an element", **KNOWN,
    program=_call("PART(GRID[AT],AT)", "(VAR REAL FIRST, VAR INT PLACE)", "N50 PLACE=2\nN55 FIRST=9\n",
                  "N5 DEF REAL GRID[3]=SET(1,2,3)\nN7 DEF INT AT=1\n", "N25 R1=GRID[1] R2=GRID[2] R3=AT\n"),
    vars={1: 9, 2: 3, 3: 2},
)
case(
    "two parameters may stand for one variable", **KNOWN,
    program=_call("PART(R1,R1)", "(VAR REAL FIRST, VAR REAL NEXT)", "N50 FIRST=4\nN55 NEXT=NEXT+1\nN57 R2=FIRST\n"), vars={1: 5, 2: 5},
)
case(
    "it is handed on through several calls", **KNOWN,
    program="N10 DEF REAL DEPTH=1\nN20 OUTER(DEPTH)\nN30 R1=DEPTH\nN40 M30\n%_N_OUTER_SPF\nN50 PROC OUTER(VAR REAL OWN)\nN60 INNER(OWN)\n"
    "N70 R2=OWN OWN=OWN+10\nN80 M17\n%_N_INNER_SPF\nN90 PROC INNER(VAR REAL OWN)\nN100 OWN=OWN+5\nN110 M17",
    vars={1: 16, 2: 6},
)
case(
    "a program that calls itself hands on the variable of the first call", **KNOWN,
    program=_call("PART(R1,3)", "(VAR REAL SUM, INT LEFT)", "N50 SUM=SUM+LEFT\nN52 IF LEFT>1\nN54 PART(SUM,LEFT-1)\nN56 ENDIF\n"), vars={1: 6},
)
case(
    "and each call may stand for a variable of its own level", **KNOWN,
    program=_call("PART(R1,2)", "(VAR REAL SUM, INT LEFT)",
                  "N45 DEF REAL OWN=10\nN50 SUM=SUM+LEFT\nN52 IF LEFT>1\nN54 PART(OWN,LEFT-1)\nN55 R2=OWN\nN56 ENDIF\n"),
    vars={1: 2, 2: 11},
)
case(
    "a text by reference is changed, and its characters", **KNOWN,
    program=_call("PART(NOTE)", "(VAR STRING[20] OWN)", 'N50 OWN=OWN<<"C"\nN55 OWN[0]="Z"\n', 'N10 DEF STRING[20] NOTE="AB"\n', "N25 MSG(NOTE)\n"),
    messages=["ZBC"],
)
case(
    "a FOR counts with it", **KNOWN,
    program=_call("PART(AT)", "(VAR INT COUNT)", "N50 FOR COUNT=1 TO 3\nN52 R1=R1+COUNT\nN54 ENDFOR\n", "N10 DEF INT AT\n", "N25 R2=AT\n"),
    vars={1: 6, 2: 4},
)
case(
    "an alarm in its block leaves the caller's variable as it was", **KNOWN,
    program=_call("PART(R1)", "(VAR REAL FIRST)", "N50 FIRST=9 R2=1/R3\n", "N10 R1=5\n"),
    runs="N10 N20 N40", alarm="division-by-zero", number="14051", at="PART N50", vars={1: 5},
)
case(
    "a call before the axes move may change what a move takes", **KNOWN,
    setup={"work_offsets": {"G54": {"X": 1.125}}},
    program="%_N_MAIN_MPF\nN10 DEF REAL WIDE=2\nN15 G54 G0\nN20 PART(WIDE)\nN25 X=WIDE\nN30 M30\n%_N_PART_SPF\nN40 PROC PART(VAR REAL OWN)\nN50 OWN=OWN*3\nN55 X=OWN\nN60 M17",
    centre="X7.125 | X7.125",
)
for kind, value in (("INT", "WIDE"), ("REAL", "COUNT"), ("BOOL", "COUNT"), ("STRING[10]", "WIDE"), ("REAL", "NOTE")):
    case(
        f"a variable by reference has the type of the parameter, VAR {kind} and no {value}", **NUMBERS,
        program=_call(f"PART({value})", f"(VAR {kind} OWN)", "", "N10 DEF REAL WIDE\nN12 DEF INT COUNT\nN14 DEF STRING[10] NOTE\n"),
        runs="N10 N12 N14", alarm="parameter-type", number="12330", at="MAIN N20", word=value,
    )
case(
    "an axis is no number for a parameter", **NUMBERS,
    program=_call("PART(X)", "(REAL WIDE)"), runs="", alarm="parameter-type", number="12330", at="MAIN N20", word="X",
)
case(
    "and a number no axis", **NUMBERS,
    program=_call("PART(5)", "(AXIS OWN)"), runs="", alarm="parameter-type", number="12330", at="MAIN N20", word="5",
)
case(
    "an axis is passed to an AXIS", **KNOWN,
    program=_call("PART(Y)", "(AXIS OWN)", 'N50 MSG(AXSTRING(OWN))\n'), messages=["Y"],
)
for call in ("PART", "PART()", "PART(,5)"):
    case(
        f"a call gives a variable for a parameter by reference, {call} gives none", **NUMBERS,
        program=_call(call, "(VAR REAL FIRST, REAL NEXT)"), runs="", alarm="parameter-missing", number="12300", at="MAIN N20", word="PART",
    )
case(
    "MCALL hands over the variable, not its value", **KNOWN,
    program=_call("MCALL PART(R1)", "(VAR REAL FIRST)", "N50 FIRST=FIRST+1\n", "N10 G0 R1=5\n", "N22 X1\nN24 R1=10\nN26 X2\nN28 MCALL\n"),
    vars={1: 11},
)
# ---- arrays ----

GRID = "N10 DEF INT GRID[2,3]=SET(1,2,3,4,5,6)\n"
case(
    "an array of any size is a parameter by reference", **KNOWN,
    program=_call("PART(GRID)", "(VAR INT OTHER[,])", "N50 R1=OTHER[1,0] OTHER[0,2]=9\n", GRID, "N25 R2=GRID[0,2] R3=GRID[1,0]\n"),
    vars={1: 4, 2: 9, 3: 4}, runs="N10 N20 N40 N50 N60 N25 N30",
)
case(
    "one without VAR is a copy", **KNOWN,
    program=_call("PART(GRID)", "(INT OTHER[,])", "N50 OTHER[0,2]=9\nN55 R1=OTHER[0,2] R2=OTHER[1,2]\n", GRID, "N25 R3=GRID[0,2]\n"),
    vars={1: 9, 2: 6, 3: 3},
)
case(
    "which keeps what the caller's array held at the call", **KNOWN,
    files={"MAIN.MPF": "N10 RING[1]=3\nN20 PART(RING)\nN30 M30\n", "UGUD.DEF": "DEF NCK REAL RING[4]\nM17\n",
           "PART.SPF": "N40 PROC PART(REAL OWN[])\nN50 RING[1]=7\nN55 R1=OWN[1] R2=RING[1]\nN60 M17\n"},
    vars={1: 3, 2: 7},
)
case(
    "each call that is open has copies of its own", **KNOWN,
    program=_call("PART(GRID,2)", "(REAL OWN[], INT LEFT)",
                  "N50 OWN[0]=OWN[0]+1\nN52 IF LEFT>0\nN54 PART(OWN,LEFT-1)\nN56 ENDIF\nN58 R[LEFT]=OWN[0]\n", "N10 DEF REAL GRID[2]\n", "N25 R5=GRID[0]\n"),
    vars={0: 3, 1: 2, 2: 1, 5: 0},
)
case(
    "the size that the head says is that of the array", **KNOWN,
    program=_call("PART(GRID)", "(VAR REAL OWN[3])", "N50 OWN[2]=8\n", "N10 DEF REAL GRID[3]\n", "N25 R1=GRID[2]\n"), vars={1: 8},
)
case(
    "SET and REP fill an array by reference, to its end", **KNOWN,
    program=_call("PART(GRID)", "(VAR REAL OWN[])", "N50 OWN[1]=SET(5,,6)\nN55 OWN[4]=REP(7)\n", "N10 DEF REAL GRID[6]\n",
                  "N25 R1=GRID[1] R2=GRID[2] R3=GRID[3] R4=GRID[4] R5=GRID[5]\n"),
    vars={1: 5, 2: 0, 3: 6, 4: 7, 5: 7},
)
case(
    "and not beyond it", **NUMBERS,
    program=_call("PART(GRID)", "(VAR REAL OWN[])", "N50 OWN[1]=SET(5,6)\n", "N10 DEF REAL GRID[2]\n", ""),
    runs="N10 N20 N40", alarm="array-element", number="12400", at="PART N50",
)
for index in ("2,0", "0,3", "-1,0"):
    case(
        f"an index is inside the array that was passed, not {index}", **NUMBERS,
        program=_call("PART(GRID)", "(VAR INT OTHER[,])", f"N50 R1=OTHER[{index}]\n", GRID),
        runs="N10 N20 N40", alarm="array-element", number="12400", at="PART N50",
    )
case(
    "an array by reference is handed on, and so are its elements", **KNOWN,
    program="N10 DEF REAL GRID[2,2]\nN20 OUTER(GRID)\nN30 R1=GRID[1,1] R2=GRID[1,0]\nN40 M30\n%_N_OUTER_SPF\nN50 PROC OUTER(VAR REAL OWN[,])\nN60 INNER(OWN,OWN[1,0])\n"
    "N70 M17\n%_N_INNER_SPF\nN80 PROC INNER(VAR REAL OWN[,], VAR REAL ONE)\nN90 OWN[1,1]=5 ONE=6\nN100 M17",
    vars={1: 5, 2: 6},
)
case(
    "an alarm leaves the elements as they were", **KNOWN,
    program=_call("PART(GRID)", "(VAR REAL OWN[])", "N50 OWN[0]=SET(5,6) R9=1/R8\n", "N10 DEF REAL GRID[2]=SET(1,2)\n"),
    runs="N10 N20 N40", alarm="division-by-zero", number="14051", at="PART N50",
)
for actual in ("FLAT", "WIDE", "R1", "GRID[0,0]", "5"):
    case(
        f"an array of other dimensions, or none, is refused: {actual}", **NUMBERS,
        program=_call(f"PART({actual})", "(VAR INT OTHER[,])", "", GRID + "N12 DEF INT FLAT[6]\nN14 DEF INT WIDE\n"),
        runs="N10 N12 N14", alarm="parameter-dimension", number="12360", at="MAIN N20", word=actual,
    )
case(
    "and an array for a parameter that is none", **NUMBERS,
    program=_call("PART(GRID)", "(VAR INT OTHER)", "", GRID), runs="N10", alarm="parameter-dimension", number="12360", at="MAIN N20", word="GRID",
)
case(
    "and one of another size than the head says", **NUMBERS,
    program=_call("PART(GRID)", "(VAR INT OTHER[2,2])", "", GRID), runs="N10", alarm="parameter-dimension", number="12360", at="MAIN N20", word="GRID",
)
case(
    "and one of another type", **NUMBERS,
    program=_call("PART(GRID)", "(VAR REAL OTHER[,])", "", GRID), runs="N10", alarm="parameter-type", number="12330", at="MAIN N20", word="GRID",
)
case(
    "an array is given for its parameter", **NUMBERS,
    program=_call("PART", "(REAL OWN[])"), runs="", alarm="parameter-missing", number="12300", at="MAIN N20", word="PART",
)
case(
    "a parameter by reference has no value of its own", **POLICY,
    program=_call("PART(R1)", "(VAR REAL OWN=5)"), runs="N20", alarm="statement-format", at="PART N40",
)
case(
    "a definition has the size of its array", **KNOWN,
    program="N10 DEF REAL GRID[]\nN20 M30", runs="", alarm="statement-format", at="MAIN N10",
)
