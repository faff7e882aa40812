"""SINUMERIK: IF, WHILE, LOOP, REPEAT."""

from conformance import case

ONE = "siemens-one"
MANUAL = {"control": ONE, "source": "840Dsl p.107, control structures", "evidence": "secondary"}
SEARCHED = {"control": ONE, "source": "840Dsl p.107: an end is searched for where it is needed", "evidence": "secondary"}
TESTS = {"control": ONE, "source": "NCI, test_jumps.py: manual 4.1.7", "evidence": "secondary"}
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}

case(
    "IF runs its blocks where the condition holds", **MANUAL,
    program="N10 R1=1\nN20 IF R1==1\nN30 R2=1\nN40 ELSE\nN50 R2=2\nN60 ENDIF\nN70 M30", runs="N10 N20 N30 N40 N60 N70",
)
case(
    "and those after ELSE where it does not", **MANUAL,
    program="N20 IF R1==1\nN30 R2=1\nN40 ELSE\nN50 R2=2\nN60 ENDIF\nN70 M30", runs="N20 N50 N60 N70", vars={2: 2},
)
case(
    "IF stands inside IF", **MANUAL,
    program="N10 IF R1==0\nN20 IF R2==1\nN30 R3=1\nN40 ENDIF\nN50 ELSE\nN60 R3=2\nN70 ENDIF\nN80 M30",
    runs="N10 N20 N40 N50 N70 N80",
)
case(
    "WHILE asks before each pass", **KNOWN,
    program="N10 WHILE R1<2\nN20 R1=R1+1\nN30 ENDWHILE\nN40 M30", runs="(N10 N20 N30)*2 N10 N40", vars={1: 2},
)
case(
    "LOOP has no end but a jump out of it", **TESTS,
    program="N10 R1=0\nN20 LOOP\nN30 R1=R1+1\nN40 IF R1>=3 GOTOF DONE\nN50 ENDLOOP\nN60 DONE: M30",
    runs="N10 (N20 N30 N40 N50)*2 N20 N30 N40 N60",
)
case(
    "REPEAT asks after each pass", **KNOWN,
    program="N10 REPEAT\nN20 R1=R1+1\nN30 UNTIL R1>=2\nN40 M30", runs="(N10 N20 N30)*2 N40",
)
case(
    "a jump leaves a branch", **TESTS,
    program="N10 R1=1\nN20 IF R1==1\nN30 GOTOF DONE\nN40 ENDIF\nN50 R2=9\nN60 DONE: M30", runs="N10 N20 N30 N60",
)
case(
    "an ENDIF that is not searched for is not missed", **SEARCHED,
    program="N10 IF R1==0\nN20 G0 X1\nN30 M30", runs="N10 N20 N30",
)
case(
    "an ENDIF that is searched for is", **SEARCHED,
    program="N10 IF R1==1\nN20 M30", runs="", alarm="if-without-end", number="12640", at="MAIN N10",
)
case(
    "an IF without ENDIF whose condition does not hold goes on after its ELSE", **SEARCHED,
    program="N10 IF R1==1\nN20 R2=1\nN30 ELSE\nN40 R2=2\nN50 M30", runs="N10 N40 N50",
)
case(
    "and alarms at the ELSE where it holds", **SEARCHED,
    program="N10 IF R1==0\nN20 R2=1\nN30 ELSE\nN40 R2=2\nN50 M30", runs="N10 N20", alarm="if-without-end", number="12640", at="MAIN N30",
)
case(
    "an inner IF without ENDIF takes the one of the outer", **SEARCHED,
    program="N10 IF R1==0\nN20 IF R1==0\nN30 R2=1\nN40 ENDIF\nN50 M30", runs="N10 N20 N30 N40 N50",
)
case(
    "an ENDIF without IF", **KNOWN, program="N10 ENDIF\nN20 M30", runs="", alarm="if-without-end", number="12640", at="MAIN N10",
)
case(
    "an ELSE without IF", **KNOWN, program="N10 ELSE\nN20 M30", runs="", alarm="if-without-end", number="12640", at="MAIN N10",
)
case(
    "a WHILE without its end alarms where its condition does not hold", **SEARCHED,
    program="N10 WHILE R1==1\nN20 M30", runs="", alarm="missing-end", number="12640", at="MAIN N10",
)
case(
    "and not before", **SEARCHED,
    program="N10 R1=1\nN20 WHILE R1==1\nN30 R1=2\nN40 IF R1==1 GOTOB N20\nN50 M30", runs="N10 N20 N30 N40 N50",
)
for word in ("LOOP", "REPEAT"):
    case(
        f"a {word} whose end is not reached needs none", **SEARCHED,
        program=f"N10 {word}\nN20 G0 X1\nN30 M30", runs="N10 N20 N30",
    )
case(
    "an end without its loop", **KNOWN, program="N10 ENDLOOP\nN20 M30", runs="", alarm="missing-do", number="12640", at="MAIN N10",
)
case(
    "a loop does not cross a branch", **KNOWN,
    program="N10 LOOP\nN20 IF R1==0\nN30 ENDLOOP\nN40 ENDIF\nN50 M30", runs="N10 N20", alarm="missing-do", number="12640", at="MAIN N30",
)
case(
    "nothing stands after a statement", **KNOWN,
    program="N10 LOOP X5\nN20 ENDLOOP\nN30 M30", runs="", alarm="statement-format", at="MAIN N10", word="X5",
)
# ---- blocks of a structure take no label and no slash ----

for words, rest in (
    ("IF R1==1", "N20 ENDIF\n"), ("WHILE R1==1", "N20 ENDWHILE\n"), ("LOOP", "N20 ENDLOOP\n"),
    ("REPEAT", "N20 UNTIL R1==0\n"), ("FOR R1=1 TO 2", "N20 ENDFOR\n"), ("ENDFOR", ""), ("ENDIF", ""), ("ELSE", ""), ("ENDWHILE", ""), ("ENDLOOP", ""), ("UNTIL R1==0", ""),
):
    case(
        f"no label stands before {words.split()[0]}", **MANUAL, number="12630",
        program=f"N10 LAB1: {words}\n{rest}N30 M30", runs="", alarm="structure-marked", at="MAIN N10",
    )
    for skip in ((), (1,)):
        case(
            f"a slash before {words.split()[0]} is refused, switch {'on' if skip else 'off'}", **MANUAL, number="12630",
            program=f"/N10 {words}\n{rest}N30 M30", skip=list(skip), runs="", alarm="structure-marked", at="MAIN N10",
        )
case(
    "a label stands before a jump with a condition", **MANUAL,
    program="N10 LAB1: IF R1==0 GOTOF DONE\nN20 G0 X9\nN30 DONE: M30", runs="N10 N30",
)
case(
    "a structure with a label counts where it is needed", **MANUAL, number="12630",
    program="N10 R1=1\nN20 IF R1==0\nN30 R2=1\nN40 LAB: ENDIF\nN50 M30", runs="N10 N20", alarm="structure-marked", at="MAIN N40",
)
for mark in ("LAB: ", "/"):
    case(
        f"an ELSE after {mark.strip()} alarms when its IF does not hold", **MANUAL, number="12630",
        program=f"N10 R1=1\nN20 IF R1==0\nN30 R2=1\n{mark}ELSE\nN50 R2=2\nN60 ENDIF\nN70 M30",
        runs="N10 N20", alarm="structure-marked", at="MAIN", word=mark.strip(),
    )

# ---- no jump leads into a structure ----

for kind, first, last in (
    ("IF", "IF R1==0", "ENDIF"), ("WHILE", "WHILE R1==0", "ENDWHILE"), ("LOOP", "LOOP", "ENDLOOP"), ("REPEAT", "REPEAT", "UNTIL R1==0"),
    ("FOR", "FOR R1=1 TO 2", "ENDFOR"),
):
    case(
        f"no jump leads into {kind}", **TESTS, number="14080",
        program=f"N10 GOTOF INSIDE\nN20 {first}\nN30 INSIDE: G0 X1\nN40 {last}\nN50 M30",
        runs="", alarm="jump-target-not-found", at="MAIN N10", word="INSIDE",
    )
case(
    "nor back into one", **TESTS, number="14080",
    program="N10 IF R1==0\nN20 INSIDE: R1=1\nN30 ENDIF\nN40 GOTOB INSIDE\nN50 M30",
    runs="N10 N20 N30", alarm="jump-target-not-found", at="MAIN N40", word="INSIDE",
)
case(
    "nor from one structure into another, by a block number", **TESTS, number="14080",
    program="N10 LOOP\nN20 GOTOF N40\nN30 ENDLOOP\nN35 IF R1==0\nN40 R2=1\nN50 ENDIF\nN60 M30",
    runs="N10", alarm="jump-target-not-found", at="MAIN N20", word="N40",
)
case(
    "nor into an inner one from the one around it", **TESTS, number="14080",
    program="N10 IF R1==0\nN20 GOTOF DEEP\nN30 LOOP\nN40 DEEP: R1=1\nN50 ENDLOOP\nN60 ENDIF\nN70 M30",
    runs="N10", alarm="jump-target-not-found", at="MAIN N20", word="DEEP",
)
case(
    "a jump inside a structure is free, and so is one out of an inner one", **TESTS,
    program="N10 IF R1==0\nN20 LOOP\nN30 GOTOF OUTER\nN40 ENDLOOP\nN50 OUTER: R1=1\nN60 GOTOF LAST\nN70 R1=9\nN80 LAST: R2=1\n"
    "N90 ENDIF\nN99 M30",
    runs="N10 N20 N30 N50 N60 N80 N90 N99",
)
case(
    "GOTOC does not lead into one either", **TESTS,
    program="N10 GOTOC INSIDE\nN20 IF R1==1\nN30 INSIDE: G0 X1\nN40 ENDIF\nN50 M30", runs="N10 N20 N40 N50",
)
case(
    "the beginning of a structure is outside of it", **TESTS,
    program="N10 GOTOF N20\nN15 R1=9\nN20 IF R1==0\nN30 R2=1\nN40 ENDIF\nN50 M30", runs="N10 N20 N30 N40 N50",
)
case(
    "a jump with a condition leads into none, where it is made", **TESTS, number="14080",
    program="N10 IF R1==1 GOTOF INSIDE\nN20 IF R1==0 GOTOF INSIDE\nN30 LOOP\nN40 INSIDE: G0 X1\nN50 ENDLOOP\nN60 M30",
    runs="N10", alarm="jump-target-not-found", at="MAIN N20", word="INSIDE",
)

# ---- how many structures inside each other ----

case(
    "sixteen control structures stand inside each other", **KNOWN,
    program="".join("IF R1==0\n" for _ in range(16)) + "N10 R1=1\n" + "".join("ENDIF\n" for _ in range(16)) + "N20 M30",
    vars={1: 1},
)
for words, end, cause in (("IF R1==0", "ENDIF", "if-too-deep"), ("LOOP", "ENDLOOP", "loops-too-deep")):
    case(
        f"the seventeenth, {words.split()[0]}, is 12641", number="12641", **KNOWN,
        program="".join("IF R1==0\n" for _ in range(16)) + f"N10 {words}\n{end}\n" + "".join("ENDIF\n" for _ in range(16)) + "N20 M30",
        alarm=cause, at="MAIN N10",
    )

# ---- the word that an alarm points at ----

for words, word, cause in (
    ("N10 IF R1==1\nN20 M30", "IF", "if-without-end"),
    ("N10 WHILE R1==1\nN20 M30", "WHILE", "missing-end"),
    ("N10 ENDIF\nN20 M30", "ENDIF", "if-without-end"),
    ("N10 ELSE\nN20 M30", "ELSE", "if-without-end"),
    ("N10 ENDLOOP\nN20 M30", "ENDLOOP", "missing-do"),
    ("N10 ENDWHILE\nN20 M30", "ENDWHILE", "missing-do"),
    ("N10 ENDFOR\nN20 M30", "ENDFOR", "missing-do"),
    ("N10 UNTIL R1==1\nN20 M30", "UNTIL", "missing-do"),
):
    case(
        f"the alarm points at {word}, not at the head of its block", number="12640", **KNOWN,
        program=words, runs="", alarm=cause, at="MAIN N10", word=word,
    )
case(
    "and at an ELSE whose ENDIF is missing", number="12640", **SEARCHED,
    program="N10 IF R1==0\nN20 R2=1\nN30 ELSE\nN40 M30", runs="N10 N20", alarm="if-without-end", at="MAIN N30", word="ELSE",
)
for first, word, cause in (("IF R1==0", "IF", "if-too-deep"), ("FOR R1=1 TO 2", "FOR", "loops-too-deep")):
    case(
        f"and at the seventeenth {word}", number="12641", **KNOWN,
        program="".join("IF R1==0\n" for _ in range(16)) + f"N10 {first}\nN20 M30", alarm=cause, at="MAIN N10", word=word,
    )
