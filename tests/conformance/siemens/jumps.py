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
case(
    "a second condition in a block is not computed", control=ONE, source="policy, nobody says", evidence="inferred",
    program="N10 IF R1==1 GOTOF A1 IF R1==2 GOTOF A2\nN20 A1: M30\nN30 A2: M30",
    runs="", alarm="code-not-computed", at="MAIN N10", word="IF",
)
