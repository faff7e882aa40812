"""SINUMERIK: labels and jumps."""

from conformance import case

ONE = "siemens-one"
JUMP = {"control": ONE, "source": "NCI, test_jumps.py: manual 4.1.5.2", "evidence": "secondary"}
MODEL = {"control": ONE, "source": "NCI, sinumerik-execution-model.md", "evidence": "secondary"}

case(
    "GOTOF goes forward to a label", **JUMP,
    program="N10 GOTOF SKIP\nN20 G0 X9\nN30 SKIP: G0 X2\nN40 M30", runs="N10 N30 N40", moves_x=[2],
)
case(
    "GOTOB goes back while the condition holds: the manual's example", **JUMP,
    program="N35 G0\nN40 R1=30 R2=10 R4=3\nN41 LA1: X=R1\nN42 R1=R1+R2 R4=R4-1\nN43 IF R4>0 GOTOB LA1\nN44 M30",
    moves_x=[30, 40, 50], runs="N35 N40 (N41 N42 N43)*3 N44",
)
case(
    "GOTO searches forward, then back", **JUMP,
    program="N10 R1=0\nN20 BACK: R1=R1+1\nN30 IF R1<3 GOTO BACK\nN40 M30", runs="N10 (N20 N30)*3 N40",
)
case(
    "of several labels the nearest in the direction counts", **MODEL,
    program="N10 LAB: G0 X1\nN20 GOTOF LAB\nN30 X2\nN40 LAB: X3\nN50 LAB: X5\nN60 M30", runs="N10 N20 N40 N50 N60",
)
case(
    "and backwards the last one before", **MODEL,
    program="N5 LAB: R1=9\nN10 LAB: R1=R1+1\nN20 IF R1<12 GOTOB LAB\nN30 M30", runs="N5 N10 N20 N10 N20 N10 N20 N30",
)
case(
    "a jump goes to a block number, with N and without", **JUMP,
    program="N10 GOTOF 40\nN20 G0 X9\nN40 G0 X4\nN50 GOTO N70\nN60 X9\nN70 M30", runs="N10 N40 N50 N70",
)
case(
    "small letters name the same label", **JUMP,
    program="N10 GOTOF done\nN20 G0 X9\nN30 Done: M30", runs="N10 N30",
)
case(
    "a label may begin like a jump", **JUMP, program="N10 GOTOF GOTO_END\nN20 G0 X9\nN30 GOTO_END: M30", runs="N10 N30",
)
case(
    "GOTOF does not look back", **JUMP,
    program="N10 BEHIND: G0 X1\nN20 GOTOF BEHIND\nN30 M30",
    runs="N10", alarm="jump-target-not-found", number="14080", at="MAIN N20", word="BEHIND",
)
case(
    "GOTOB does not look forward", **JUMP,
    program="N10 GOTOB AHEAD\nN20 AHEAD: M30",
    runs="", alarm="jump-target-not-found", number="14080", at="MAIN N10", word="AHEAD",
)
case(
    "a jump that is not made is not missed", **MODEL,
    program="N10 IF R1>0 GOTOF NOWHERE\nN20 M30", runs="N10 N20",
)
case(
    "and one that is made is", **MODEL,
    program="N10 R1=1\nN20 IF R1>0 GOTOF NOWHERE\nN30 M30",
    runs="N10", alarm="jump-target-not-found", number="14080", at="MAIN N20", word="NOWHERE",
)
case(
    "a block number that is not there is 14080 too", **MODEL,
    program="N10 GOTO N70\nN30 M30", runs="", alarm="jump-target-not-found", number="14080", at="MAIN N10", word="N70",
)
case(
    "GOTOC goes on where there is no label", **JUMP,
    program="N10 GOTOC NOWHERE\nN15 IF R1==0 GOTOC NOWHERE\nN20 M30", runs="N10 N15 N20",
)
case(
    "labels are those of the own program", control=ONE, source="general knowledge of the SINUMERIK 840D",
    evidence="inferred",
    program="%_N_MAIN_MPF\nN10 GOTOF THERE\nN20 M30\n%_N_PART_SPF\nN30 THERE: M17",
    runs="", alarm="jump-target-not-found", number="14080", at="MAIN N10",
)
case(
    "a jump needs a target", control=ONE, source="general knowledge of the SINUMERIK 840D", evidence="inferred",
    program="N10 GOTOF\nN20 M30", runs="", alarm="statement-format", at="MAIN N10",
)

# ---- several jumps in a block ----

for value, runs in ((1, "N10 N20 N30"), (2, "N10 N20 N40"), (3, "N10 N20 N25 N30")):
    case(
        f"several conditions in a block are tested in order: R1={value}", **JUMP,
        program=f"N10 R1={value}\nN20 IF R1==1 GOTOF AA1 IF R1==2 GOTOF AA2 IF R1==1 GOTOF AA2\nN25 G0\nN30 AA1: M30\nN40 AA2: M30", runs=runs,
    )
case(
    "the jump of a second condition that finds nothing alarms when it is made", number="14080", **MODEL,
    program="N10 IF R1==1 GOTOF NONE IF R1==0 GOTOF NOWHERE\nN20 M30",
    runs="", alarm="jump-target-not-found", at="MAIN N10", word="NOWHERE",
)
case(
    "and is not missed where it is not", **MODEL,
    program="N10 IF R1==0 GOTOF DONE IF R1==1 GOTOF NOWHERE\nN15 G0\nN20 DONE: M30", runs="N10 N20",
)
case(
    "a second condition needs a jump", **JUMP,
    program="N10 IF R1==1 GOTOF AA1 IF R1==2\nN20 AA1: M30", runs="", alarm="if-format", at="MAIN N10",
)
case(
    "GOTOC as one of several goes on", **JUMP,
    program="N10 IF R1==0 GOTOC NOWHERE IF R1==1 GOTOF AA1\nN15 G0\nN20 AA1: M30", runs="N10 N15 N20",
)

CASES = {"control": ONE, "source": "NCI, test_jumps.py: manual 4.1.5.3", "evidence": "secondary"}
for value, runs in ((7, "N10 N20 N40"), (9, "N10 N20 N50"), (8, "N10 N20 N60")):
    case(
        f"CASE jumps by its value, or to DEFAULT: {value}", **CASES,
        program=f"N10 R1={value}\nN20 CASE(R1) OF 7 GOTOF AA1 9 GOTOF AA2 DEFAULT GOTOF AA3\nN30 M30\nN40 AA1: M30\nN50 AA2: M30\nN60 AA3: M30", runs=runs,
    )
case(
    "CASE computes its value, and needs no DEFAULT", **CASES,
    program="N10 R1=2\nN20 CASE(R1*2-1) OF 4 GOTOF AA1\nN30 G0\nN40 AA1: M30", runs="N10 N20 N30 N40",
)
case(
    "CASE jumps back, and without brackets around its value", **CASES,
    program="N10 BACK: R1=R1+1\nN20 CASE R1 OF 1 GOTOB BACK 2 GOTO DONE\nN30 G0\nN40 DONE: M30", runs="(N10 N20)*2 N40",
)
case(
    "the first of two equal values counts", control=ONE, source="general knowledge of the SINUMERIK 840D", evidence="inferred",
    program="N10 CASE(1) OF 1 GOTOF AA1 1 GOTOF AA2\nN20 AA1: M30\nN30 AA2: M30", runs="N10 N20",
)
case(
    "CASE takes negative values", control=ONE, source="general knowledge of the SINUMERIK 840D", evidence="inferred",
    program="N10 R1=-1\nN20 CASE(R1) OF 1 GOTOF AA1 -1 GOTOF AA2\nN25 G0\nN30 AA1: M30\nN40 AA2: M30", runs="N10 N20 N40",
)
case(
    "a target of CASE that is not there alarms when it is jumped to", number="14080", **CASES,
    program="N10 CASE(1) OF 2 GOTOF NONE 1 GOTOF NOWHERE DEFAULT GOTOF NONE\nN20 M30",
    runs="", alarm="jump-target-not-found", at="MAIN N10", word="NOWHERE",
)
case(
    "CASE leads into no structure", number="14080", **CASES,
    program="N10 CASE(1) OF 1 GOTOF INSIDE\nN20 IF R1==0\nN30 INSIDE: G0\nN40 ENDIF\nN50 M30",
    runs="", alarm="jump-target-not-found", at="MAIN N10", word="INSIDE",
)
for words, where in (("CASE(1) 1 GOTOF AA1", None), ("CASE(1) OF 1 AA1", "AA1"), ("CASE(1) OF 1 GOTOF", None), ("CASE(1) OF 1 GOTOF AA1 DEFAULT GOTOF AA1 2 GOTOF AA1", "2")):
    case(
        f"{words} is no CASE", control=ONE, source="general knowledge of the SINUMERIK 840D", evidence="inferred",
        program=f"N10 {words}\nN20 AA1: M30", runs="", alarm="statement-format", at="MAIN N10", **({"word": where} if where else {}),
    )
case(
    "a label stands before CASE", control=ONE, source="general knowledge of the SINUMERIK 840D", evidence="inferred",
    program="N10 GOTOF HERE\nN20 M30\nN30 HERE: CASE(1) OF 1 GOTOB N20", runs="N10 N30 N20",
)

# ---- GOTOS, and targets that are texts ----

START = {"control": ONE, "source": "NCI, test_jumps.py: manual 4.1.5.1", "evidence": "secondary"}
case(
    "GOTOS goes on where the PLC does not ask for the beginning", **START,
    program="N10 GOTOS\nN20 IF R1==0 GOTOS\nN30 M30", runs="N10 N20 N30",
)
case(
    "nothing follows GOTOS", control=ONE, source="general knowledge of the SINUMERIK 840D", evidence="inferred",
    program="N10 GOTOS DONE\nN20 DONE: M30", runs="", alarm="statement-format", at="MAIN N10",
)
case(
    "a target may be a text", control=ONE, source="general knowledge of the SINUMERIK 840D", evidence="inferred",
    program='N10 GOTOF "DONE"\nN20 G0\nN30 DONE: M30', runs="N10 N30",
)

# ---- a condition that is not computed ----

UNKNOWN = {"control": "siemens-one", "source": "policy, nobody says", "evidence": "inferred"}
case(
    "a conditional jump whose condition is not computed opens no structure", **UNKNOWN,
    program="N10 GOTOF EE\nN20 IF $A_DBB[1]==1 GOTOF EE\nN30 EE: G0 X2\nN40 M30", runs="N10 N30 N40",
)
case(
    "and it may have a label", **UNKNOWN,
    program="N10 G0 X1\nN20 LAB: IF NO_NAME>1 GOTOF EE\nN30 EE: M30", runs="N10", alarm="code-not-computed", at="MAIN N20",
)
case(
    "an IF of an unknown name opens a structure that can be left", **UNKNOWN,
    program="N10 GOTOF OUT\nN20 IF $A_DBB[1]==1\nN30 G0 X1\nN40 ENDIF\nN50 OUT: M30", runs="N10 N50",
)
for jump in ("GOTO LA", "GOTOF LA", "GOTOB LA", "GOTOS"):
    case(
        f"a jump beside other words is refused: {jump}", control=ONE, source="general knowledge of the SINUMERIK 840D: a block of its own", evidence="inferred",
        program=f"N10 G0 X2\nN20 LA: G0 X1 {jump}\nN30 M30", runs="N10", alarm="statement-format", at="MAIN N20", word=jump.split()[0],
    )
