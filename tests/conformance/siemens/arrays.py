"""SINUMERIK: arrays that a program defines, SET and REP."""

from conformance import case

ONE = "siemens-one"
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}
PEER = {"control": ONE, "source": "NCI, arrays.mpf", "evidence": "secondary"}
ALARM = {"control": ONE, "source": "general knowledge of the SINUMERIK alarms", "evidence": "inferred"}
POLICY = {"control": ONE, "source": "policy, nobody says", "evidence": "inferred"}

case(
    "an element keeps what it is given, and the others are 0", **KNOWN,
    program="N10 DEF REAL GRID[4]\nN20 GRID[2]=7.5\nN30 R1=GRID[1] R2=GRID[2] R3=GRID[3]\nN40 M30", vars={1: 0, 2: 7.5, 3: 0},
)
case(
    "the first element has the index 0", **KNOWN,
    program="N10 DEF REAL GRID[3]\nN20 GRID[0]=1 GRID[1]=2\nN25 GRID[2]=3\nN30 R1=GRID[0]+10*GRID[1]+100*GRID[2]\nN40 M30", vars={1: 321},
)
case(
    "SET gives the elements their values one after the other", **PEER,
    program="N10 DEF REAL GRID[2,3]=SET(1,2,3,4,5,6)\nN20 R1=GRID[0,0] R2=GRID[0,2] R3=GRID[1,0] R4=GRID[1,2]\nN30 M30",
    vars={1: 1, 2: 3, 3: 4, 4: 6},
)
case(
    "SET leaves out the elements between two commas", **PEER,
    program="N10 DEF REAL GRID[6]=SET(1,,,4)\nN20 R1=GRID[0] R2=GRID[1] R3=GRID[3] R4=GRID[5]\nN30 M30", vars={1: 1, 2: 0, 3: 4, 4: 0},
)
case(
    "a gap of a later SET leaves the element as it is", **KNOWN,
    program="N10 DEF REAL GRID[3]=REP(9)\nN20 GRID[0]=SET(1,,3)\nN30 R1=GRID[0] R2=GRID[1] R3=GRID[2]\nN40 M30", vars={1: 1, 2: 9, 3: 3},
)
case(
    "the last index counts fastest, in three dimensions too", **PEER,
    program="N10 DEF INT CUBE[2,3,4]=REP(1)\nN20 CUBE[0,0,0]=SET(0,1,2,3,4,5,6,7,8,9,10,11,12,13)\n"
    "N30 R1=CUBE[0,0,3] R2=CUBE[0,2,1] R3=CUBE[1,0,1] R4=CUBE[1,2,3]\nN40 M30",
    vars={1: 3, 2: 9, 3: 13, 4: 1},
)
case(
    "SET begins at any element", **PEER,
    program="N10 DEF REAL GRID[10,3]\nN20 GRID[8,1]=SET(8.1,8.2,9.0,9.1,9.2)\n"
    "N30 R1=GRID[8,0] R2=GRID[8,1] R3=GRID[8,2] R4=GRID[9,0] R5=GRID[9,2]\nN40 M30",
    vars={1: 0, 2: 8.1, 3: 8.2, 4: 9, 5: 9.2},
)
case(
    "SET takes expressions and computed indices", **KNOWN,
    program="N10 DEF REAL GRID[5]\nN20 R1=2 R2=30\nN30 GRID[R1]=SET(R2,R2+1,SQRT(16))\nN40 R3=GRID[2] R4=GRID[3] R5=GRID[4] R6=GRID[1]\nN50 M30",
    vars={3: 30, 4: 31, 5: 4, 6: 0},
)
case(
    "the word SET may be left out in a definition", **KNOWN,
    program="N10 DEF INT GRID[3]=(7,8,9)\nN20 R1=GRID[0] R2=GRID[2]\nN30 M30", vars={1: 7, 2: 9},
)
case(
    "REP fills from an element on", **KNOWN,
    program="N10 DEF REAL GRID[5]=REP(2)\nN20 GRID[3]=REP(8)\nN30 R1=GRID[0] R2=GRID[2] R3=GRID[3] R4=GRID[4]\nN40 M30",
    vars={1: 2, 2: 2, 3: 8, 4: 8},
)
case(
    "REP with a number fills so many", **PEER,
    program="N10 DEF REAL GRID[5]=REP(2,2)\nN20 GRID[2]=REP(8,2)\nN30 R1=GRID[1] R2=GRID[2] R3=GRID[3] R4=GRID[4]\nN40 M30",
    vars={1: 2, 2: 8, 3: 8, 4: 0},
)
case(
    "an array without an index takes SET and REP from its first element", **KNOWN,
    program="N10 DEF REAL GRID[3]\nN20 GRID=REP(4)\nN30 GRID=SET(1)\nN40 R1=GRID[0] R2=GRID[1] R3=GRID[2]\nN50 M30", vars={1: 1, 2: 4, 3: 4},
)
case(
    "elements are converted as variables are", **KNOWN,
    program='N10 DEF INT SIDES[2]=SET(2.5,1.4)\nN20 DEF BOOL FLAGS[2]=SET(5,0)\nN30 DEF CHAR MARKS[2]=SET("A",66)\n'
    "N40 R1=SIDES[0] R2=SIDES[1] R3=FLAGS[0] R4=FLAGS[1] R5=MARKS[0] R6=MARKS[1]\nN50 SIDES[1]=7/2\nN60 R7=SIDES[1]\nN70 M30",
    vars={1: 3, 2: 1, 3: 1, 4: 0, 5: 65, 6: 66, 7: 4},
)
case(
    "an index is computed, and rounded", **KNOWN,
    program="N10 DEF REAL GRID[4]=SET(10,11,12,13)\nN20 R1=1\nN30 R2=GRID[R1] R3=GRID[R1+1.6] R4=GRID[GRID[1]-8]\nN40 M30",
    vars={2: 11, 3: 13, 4: 13},
)
case(
    "words and conditions read elements", **KNOWN,
    program="N10 DEF REAL GRID[3]=SET(1,2,3)\nN20 DEF INT AT=0\nN30 WHILE GRID[AT]<3\nN40 G0 X=GRID[AT] Y=10*GRID[AT+1]\nN50 AT=AT+1\nN60 ENDWHILE\nN70 M30",
    moves="R X1 Y20\nR X2 Y30",
)
case(
    "each call has arrays of its own", **KNOWN,
    program="%_N_MAIN_MPF\nN10 DEF REAL GRID[2]=SET(1,2)\nN20 PART\nN30 R1=GRID[0] R2=GRID[1]\nN40 M30\n"
    "%_N_PART_SPF\nN50 DEF REAL GRID[3]\nN60 R3=GRID[0]\nN70 GRID[0]=9 GRID[2]=8\nN80 R4=R4+1\nN90 IF R4<2\nN100 PART\nN110 ENDIF\nN120 R5=GRID[2]\nN130 M17",
    vars={1: 1, 2: 2, 3: 0, 5: 8},
)
case(
    "a definition that runs again begins anew", **KNOWN,
    program="N20 BACK: DEF REAL GRID[2]=SET(5)\nN30 R9=R9+1\nN40 R1=GRID[0] R2=GRID[1]\nN50 GRID[0]=7 GRID[1]=8\nN60 IF R9<2 GOTOB BACK\nN70 M30",
    vars={1: 5, 2: 0},
)
for write, word in (("GRID[3]=1", "3"), ("GRID[-1]=1", "-"), ("R1=GRID[3]", "3"), ("R1=GRID[R2-1]", "R2")):
    case(
        f"{write} is outside of three elements", **ALARM,
        program=f"N10 DEF REAL GRID[3]\nN20 {write}\nN30 M30",
        runs="N10", alarm="array-element", number="12400", at="MAIN N20", word=word,
    )
case(
    "each index has its own extent", **ALARM,
    program="N10 DEF REAL GRID[2,3]\nN20 R1=GRID[1,2]\nN30 R1=GRID[0,3]\nN40 M30",
    runs="N10 N20", alarm="array-element", number="12400", at="MAIN N30",
)
case(
    "SET with more values than elements are left is refused, and no element has changed", **ALARM,
    program="N10 DEF REAL GRID[3]=REP(1)\nN20 R2=1\nN30 GRID[R2]=SET(5,6,7) R3=8\nN40 M30",
    runs="N10 N20", alarm="array-element", number="12400", at="MAIN N30", vars={3: None},
)
case(
    "so is it in a definition", **ALARM,
    program="N10 DEF REAL GRID[2]=SET(5,6,7)\nN20 M30", runs="", alarm="array-element", number="12400", at="MAIN N10",
)
case(
    "REP of more elements than there are is refused", **ALARM,
    program="N10 DEF REAL GRID[3]\nN20 GRID[2]=REP(5,2)\nN30 M30",
    runs="N10", alarm="array-element", number="12400", at="MAIN N20",
)
case(
    "an array has at most three dimensions", **KNOWN,
    program="N10 DEF REAL GRID[2,2,2,2]\nN20 M30", runs="", alarm="statement-format", at="MAIN N10",
)
case(
    "an array has elements", **KNOWN,
    program="N10 DEF REAL GRID[0]\nN20 M30", runs="", alarm="value-out-of-range", at="MAIN N10",
)
case(
    "every index is written", **KNOWN,
    program="N10 DEF REAL GRID[2,2]\nN20 R1=GRID[1]\nN30 M30", runs="N10", alarm="missing-comma", number="12080", at="MAIN N20",
)
case(
    "the array alone has no value", **KNOWN,
    program="N10 DEF REAL GRID[2]\nN20 R1=GRID\nN30 M30", runs="N10", alarm="bracket-not-opened", number="12080", at="MAIN N20",
)
case(
    "an array takes no single value", **KNOWN,
    program="N10 DEF REAL GRID[2]\nN20 GRID=5\nN30 M30", runs="N10", alarm="statement-format", at="MAIN N20",
)
case(
    "an array of a computed size is not computed", **POLICY,
    program="N10 DEF INT MANY=3\nN20 DEF REAL GRID[R1]\nN30 M30", runs="N10", alarm="code-not-computed", at="MAIN N20",
)
case(
    "more than 100,000 elements are not computed", **POLICY,
    program="N10 DEF REAL GRID[400,251]\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10",
)
case(
    "an element in the block that assigns to its array is not computed", **POLICY,
    program="N10 DEF REAL GRID[2]\nN20 GRID[0]=3 R1=GRID[0]\nN30 M30", runs="N10", alarm="code-not-computed", at="MAIN N20",
)
