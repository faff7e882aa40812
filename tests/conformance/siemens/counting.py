"""SINUMERIK: FOR, which counts."""

from conformance import case

ONE = "siemens-one"
TESTS = {"control": ONE, "source": "NCI, examples/for_loop.mpf and its table", "evidence": "secondary"}
ONCE = {"control": ONE, "source": "NCI, src/vm.rs: the bound of FOR is evaluated as it begins", "evidence": "secondary"}
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}
OFFSET = {"work_offsets": {"G54": {"X": 1.125}}}

case(
    "FOR counts up by 1, both ends included", **TESTS, setup=OFFSET,
    program="N10 DEF INT COUNT\nN20 G0\nN30 FOR COUNT=1 TO 3\nN40 X=COUNT\nN50 ENDFOR\nN60 M30",
    runs="N10 N20 N30 (N40 N50)*3 N60", centre="X2.125 | X3.125 | X4.125",
)
case(
    "FOR counts with an R parameter too, which is one beyond the end after it", **KNOWN,
    program="N10 FOR R1=2 TO 3\nN20 R2=R2+R1\nN30 ENDFOR\nN40 M30", runs="N10 (N20 N30)*2 N40", vars={1: 4, 2: 5},
)
case(
    "FOR tests before its first pass", **KNOWN,
    program="N10 FOR R1=4 TO 3\nN20 R2=1\nN30 ENDFOR\nN40 M30", runs="N10 N40", vars={1: 4},
)
case(
    "the first and the last value are computed", **KNOWN,
    program="N10 R5=2\nN20 FOR R1=R5*2 TO 10-R5*2\nN30 R2=R2+R1\nN40 ENDFOR\nN50 M30", vars={2: 15},
)
case(
    "the last value is computed as FOR begins", **ONCE,
    program="N10 R5=2\nN20 FOR R1=1 TO R5\nN30 R5=9\nN40 ENDFOR\nN50 M30", runs="N10 N20 (N30 N40)*2 N50", vars={1: 3},
)
case(
    "a REAL that counts is rounded", **KNOWN,
    program="N10 FOR R1=0.6 TO 2\nN20 R2=R2*10+R1\nN30 ENDFOR\nN40 M30", runs="N10 (N20 N30)*2 N40", vars={1: 3, 2: 12},
)
case(
    "an assignment inside changes the count", **KNOWN,
    program="N10 FOR R1=1 TO 5\nN20 R1=R1+1\nN30 ENDFOR\nN40 M30", runs="N10 (N20 N30)*3 N40", vars={1: 7},
)
case(
    "loops stand inside each other", **KNOWN,
    program="N10 FOR R1=1 TO 2\nN20 FOR R2=1 TO R1\nN30 R3=R3+1\nN40 ENDFOR\nN50 ENDFOR\nN60 M30",
    runs="N10 N20 N30 N40 N50 N20 (N30 N40)*2 N50 N60", vars={3: 3},
)
case(
    "a jump leaves the loop, which begins anew when it is reached again", **KNOWN,
    program="N10 R3=R3+1\nN20 FOR R1=1 TO 9\nN30 IF R1==2 GOTOF OUT\nN40 ENDFOR\nN50 OUT: IF R3<2 GOTOB N10\nN60 M30",
    runs="(N10 N20 N30 N40 N30 N50)*2 N60", vars={1: 2},
)
case(
    "a jump back to FOR counts from the beginning", **KNOWN,
    program="N10 FOR R1=1 TO 3\nN20 R2=R2+1\nN30 IF R2==2 GOTOB N10\nN40 ENDFOR\nN50 M30",
    runs="N10 N20 N30 N40 N20 N30 N10 (N20 N30 N40)*3 N50", vars={1: 4, 2: 5},
)
case(
    "a loop inside a subprogram that is called in a loop", **KNOWN,
    program="%_N_MAIN_MPF\nN10 FOR R1=1 TO 2\nN20 PART\nN30 ENDFOR\nN40 M30\n"
    "%_N_PART_SPF\nN50 FOR R2=1 TO 9\nN60 IF R2==2 GOTOF OUT\nN70 ENDFOR\nN80 OUT: M17",
    runs="N10 (N20 N50 N60 N70 N60 N80 N30)*2 N40", vars={1: 3, 2: 2},
)
case(
    "a program that counts with a local variable calls itself", **KNOWN,
    program="%_N_MAIN_MPF\nN10 PART(1)\nN20 M30\n%_N_PART_SPF\nN30 PROC PART(INT DEPTH)\nN40 DEF INT II\n"
    "N50 FOR II=1 TO 2\nN60 R1=R1+1\nN70 IF DEPTH<2\nN80 PART(DEPTH+1)\nN90 ENDIF\nN95 ENDFOR\nN99 M17",
    vars={1: 6},
)
case(
    "a FOR without ENDFOR runs where it is entered", **KNOWN,
    program="N10 FOR R1=1 TO 3\nN20 M30", runs="N10 N20", vars={1: 1},
)
case(
    "and alarms where its end is searched for", number="12640", **KNOWN,
    program="N10 FOR R1=4 TO 3\nN20 M30", runs="", alarm="missing-end", at="MAIN N10", vars={1: None},
)
case(
    "an ENDFOR without FOR", number="12640", **KNOWN, program="N10 ENDFOR\nN20 M30", runs="", alarm="missing-do", at="MAIN N10",
)
case(
    "FOR needs TO", **KNOWN,
    program="N10 FOR R1=1\nN20 ENDFOR\nN30 M30", runs="", alarm="statement-format", at="MAIN N10",
)
case(
    "FOR needs a variable", **KNOWN,
    program="N10 FOR NONE=1 TO 3\nN20 ENDFOR\nN30 M30", runs="", alarm="statement-format", at="MAIN N10", word="NONE",
)
case(
    "FOR needs =", **KNOWN,
    program="N10 FOR R1 TO 3\nN20 ENDFOR\nN30 M30", runs="", alarm="missing-equals", number="12080", at="MAIN N10",
)
case(
    "nothing follows the last value", **KNOWN,
    program="N10 FOR R1=1 TO 3 X5\nN20 ENDFOR\nN30 M30", runs="", alarm="statement-format", at="MAIN N10", word="X5",
)
case(
    "a FOR with a parameter of a computed number is not computed", control=ONE, source="policy, nobody says", evidence="inferred",
    program="N10 FOR R[R2]=1 TO 3\nN20 ENDFOR\nN30 M30", runs="", alarm="code-not-computed", at="MAIN N10",
)
