"""SINUMERIK: parts of a program that are repeated or called: REPEAT, REPEATB, CALL BLOCK."""

from conformance import case

ONE = "siemens-one"
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}
ALARM = {"control": ONE, "source": "general knowledge of the SINUMERIK alarms", "evidence": "inferred"}

case(
    "REPEAT runs the blocks from its label on once more", **KNOWN, setup={"work_offsets": {"G54": {"X": 1.125}}},
    program="N10 G0 R1=1\nN20 LAB: X=R1\nN30 R1=R1+1\nN40 REPEAT LAB\nN50 M30",
    runs="N10 N20 N30 N40 N20 N30 N50", centre="X2.125 | X3.125",
)
case(
    "P says how often it repeats", **KNOWN,
    program="N10 LAB: R1=R1+1\nN20 R2=R2+R1\nN30 REPEAT LAB P=3\nN40 M30", runs="N10 N20 N30 (N10 N20)*3 N40", vars={1: 4, 2: 10},
)
case(
    "P stands without = too, and is computed", **KNOWN,
    program="N10 R2=2\nN20 LAB: R1=R1+1\nN30 REPEAT LAB P2\nN40 REPEATB LAB P=R2+1\nN50 M30", runs="N10 N20 N30 N20*2 N40 N20*3 N50",
)
case(
    "a repeated part is a call of the tree", **KNOWN,
    program="N10 LAB: R1=R1+1\nN20 REPEAT LAB P=2\nN30 M30", calls="REPEAT:MAIN",
)
case(
    "an alarm in a repeated part tells its pass", **KNOWN,
    program="N10 R1=3\nN20 LAB: R1=R1-1\nN30 IF R1<1 GOTOF NOWHERE\nN40 REPEAT LAB P=5\nN50 M30",
    runs="N10 N20 N30 N40 N20 N30 N20", alarm="jump-target-not-found", number="14080", at="MAIN N30", word="NOWHERE",
    frames="MAIN N40 REPEAT",
)
case(
    "REPEATB repeats the block of the label alone", **KNOWN,
    program="N10 LAB: R1=R1+1\nN20 R2=R2+1\nN30 REPEATB LAB P=2\nN40 M30", runs="N10 N20 N30 N10*2 N40", vars={1: 3, 2: 1},
)
case(
    "the label of REPEATB may stand after it", **KNOWN,
    program="N10 REPEATB LAB P=2\nN20 R2=R1\nN30 LAB: R1=R1+1\nN40 M30", runs="N10 N30*2 N20 N30 N40", vars={1: 3, 2: 2},
)
case(
    "the label before REPEAT counts, and the nearest of several", **KNOWN,
    program="N10 LAB: R1=1\nN20 LAB: R2=R2+1\nN30 REPEATB LAB\nN40 LAB: M30", runs="N10 N20 N30 N20 N40",
)
case(
    "REPEAT with two labels repeats from the first to the block of the second", **KNOWN,
    program="N10 ONE1: R1=R1+1\nN20 TWO2: R2=R2+1\nN30 R3=R3+1\nN40 REPEAT ONE1 TWO2 P=2\nN50 M30",
    runs="N10 N20 N30 N40 (N10 N20)*2 N50", vars={1: 3, 2: 3, 3: 1},
)
case(
    "two labels may stand after REPEAT", **KNOWN,
    program="N10 REPEAT ONE1 TWO2 P=2\nN20 GOTOF DONE\nN30 ONE1: R1=R1+1\nN40 TWO2: R2=R2+1\nN50 DONE: M30",
    runs="N10 (N30 N40)*2 N20 N50",
)
case(
    "a second label that stands after REPEAT leaves the end at REPEAT", **KNOWN,
    program="N10 ONE1: R1=R1+1\nN20 REPEAT ONE1 TWO2\nN30 TWO2: M30", runs="N10 N20 N10 N30",
)
case(
    "ENDLABEL ends the part", **KNOWN,
    program="N10 LAB: R1=R1+1\nN20 ENDLABEL: R2=R2+1\nN30 R3=R3+1\nN40 REPEAT LAB P=2\nN50 M30",
    runs="N10 N20 N30 N40 (N10 N20)*2 N50", vars={3: 1},
)
case(
    "ENDLABEL alone ends a part after REPEAT, and several may stand in a program", **KNOWN,
    program="N10 REPEAT LAB2 P=2\nN20 GOTOF DONE\nN30 LAB1: R1=9\nN40 ENDLABEL:\nN50 LAB2: R1=R1+1\nN60 ENDLABEL:\nN70 DONE: M30",
    runs="N10 (N50 N60)*2 N20 N70", vars={1: 2},
)
case(
    "repetitions stand inside each other", **KNOWN,
    program="N10 ONE1: R1=R1+1\nN20 TWO2: R2=R2+1\nN30 REPEATB TWO2\nN40 REPEAT ONE1\nN50 M30",
    runs="(N10 N20 N30 N20 N40) N10 N20 N30 N20 N50".replace("(", "").replace(")", ""), vars={1: 2, 2: 4},
)
case(
    "a repeated part calls subprograms, also in its last block", **KNOWN,
    program="%_N_MAIN_MPF\nN10 LAB: R1=R1+1\nN20 LAST: PART\nN30 R3=R3+1\nN40 REPEAT LAB LAST P=2\nN50 M30\n%_N_PART_SPF\nN60 R2=R2+1\nN70 M17",
    runs="N10 N20 N60 N70 N30 N40 (N10 N20 N60 N70)*2 N50", vars={1: 3, 2: 3, 3: 1},
)
case(
    "a part of a subprogram has its variables", **KNOWN,
    program="%_N_MAIN_MPF\nN10 PART(5)\nN20 M30\n%_N_PART_SPF\nN30 PROC PART(INT COUNT)\nN40 LAB: COUNT=COUNT+1\nN50 REPEAT LAB P=2\nN60 R1=COUNT\nN70 M17",
    vars={1: 8},
)
case(
    "a jump inside the part goes on to its end", **KNOWN,
    program="N10 LAB: R1=R1+1\nN20 IF R1==2 GOTOF OVER\nN30 R2=R2+1\nN40 OVER: R3=R3+1\nN50 REPEAT LAB P=2\nN60 M30",
    runs="N10 N20 N30 N40 N50 N10 N20 N40 N10 N20 N30 N40 N60",
)
case(
    "a structure stands in the part", **KNOWN,
    program="N10 LAB: R1=R1+1\nN20 FOR R2=1 TO 2\nN30 R3=R3+1\nN40 ENDFOR\nN50 REPEAT LAB\nN60 M30", vars={1: 2, 3: 4},
)
case(
    "M17 in a repeated part ends the repetition", **KNOWN,
    program="N10 GOTOF FIRST\nN20 LAB: R1=R1+1\nN30 M17\nN40 ENDLABEL:\nN50 FIRST: REPEAT LAB P=3\nN60 M30", runs="N10 N50 N20 N30 N60",
)
case(
    "M30 in a repeated part ends the main program", **KNOWN,
    program="N10 GOTOF FIRST\nN20 LAB: R1=R1+1\nN30 M30\nN40 ENDLABEL:\nN50 FIRST: REPEAT LAB P=3\nN60 M30", runs="N10 N50 N20 N30",
)
case(
    "each repetition takes a program level", number="14012", control=ONE, source="828D p.490, 16 program levels; CW-S, 14012",
    evidence="secondary",
    program="%_N_MAIN_MPF\nN10 REC\nN20 M30\n%_N_REC_SPF\nN30 R1=R1+1\nN40 IF R1<15 GOTOF DEEPER\nN50 LAB: R2=1\nN60 REPEAT LAB\nN70 DEEPER: REC\nN80 M17",
    vars={1: 15, 2: 1}, alarm="nesting-too-deep", at="REC N60",
)
case(
    "a skipped block at the end of a part ends it too", **KNOWN,
    program="N10 LAB: R1=R1+1\n/N20 LAST: R2=1\nN30 REPEAT LAB LAST P=2\nN40 M30", skip=[1], runs="N10 N30 N10*2 N40",
)
case(
    "the block after a part may be skipped", **KNOWN,
    program="N10 LAB: R1=R1+1\n/N20 R2=1\nN30 REPEATB LAB P=2\nN40 M30", skip=[1], runs="N10 N30 N10*2 N40",
)
for words in ("P=0", "P0", "P=-1"):
    case(
        f"REPEAT {words} is 14013", number="14013", **ALARM,
        program=f"N10 LAB: R1=R1+1\nN20 REPEAT LAB {words}\nN30 M30", runs="N10", alarm="illegal-repeat-count", at="MAIN N20", word=words,
    )
for words, word in (("REPEAT NONE", "NONE"), ("REPEATB NONE P=2", "NONE"), ("CALL BLOCK NONE TO LAST", "NONE"), ("CALL BLOCK LAST TO NONE", "NONE")):
    case(
        f"{words} without its label is 14082", number="14082", **ALARM,
        program=f"N10 R1=1\nN20 {words}\nN30 LAST: M30", runs="N10", alarm="part-incomplete", at="MAIN N20", word=word,
    )
case(
    "REPEAT of a label after it needs ENDLABEL", number="14082", **ALARM,
    program="N10 REPEAT LAB\nN20 LAB: R1=1\nN30 M30", runs="", alarm="part-incomplete", at="MAIN N10", word="LAB",
)
case(
    "and two labels need the second", number="14082", **ALARM,
    program="N10 REPEAT LAB LAST\nN20 LAB: R1=1\nN30 M30", runs="", alarm="part-incomplete", at="MAIN N10", word="LAST",
)
case(
    "a part that is not reached is not missed", **ALARM, program="N10 GOTOF DONE\nN20 REPEAT NONE\nN30 DONE: M30", runs="N10 N30",
)
case(
    "nothing follows REPEAT", **KNOWN,
    program="N10 LAB: R1=1\nN20 REPEAT LAB P=2 X5\nN30 M30", runs="N10", alarm="statement-format", at="MAIN N20", word="X5",
)
case(
    "REPEATB needs a label", **KNOWN, program="N10 REPEATB\nN20 M30", runs="", alarm="statement-format", at="MAIN N10",
)
case(
    "a label stands before REPEAT of a part", **KNOWN,
    program="N10 LAB: R1=R1+1\nN20 AGAIN: REPEATB LAB\nN30 IF R1<4 GOTOB AGAIN\nN40 M30", runs="N10 (N20 N10 N30)*3 N40".replace("N10 (N20 N10 N30)*3", "N10 (N20 N10 N30)*3"),
)

# ---- CALL BLOCK ----

case(
    "CALL BLOCK runs the blocks from one label to the other", **KNOWN,
    program="N10 CALL BLOCK ONE1 TO TWO2\nN20 GOTOF DONE\nN30 ONE1: R1=R1+1\nN40 TWO2: R2=R2+1\nN50 R3=1\nN60 DONE: M30",
    runs="N10 N30 N40 N20 N60", calls="BLOCK:MAIN",
)
case(
    "CALL BLOCK needs TO", **KNOWN,
    program="N10 CALL BLOCK ONE1 TWO2\nN30 ONE1: R1=R1+1\nN60 M30", runs="", alarm="statement-format", at="MAIN N10",
)
case(
    "the labels of CALL BLOCK may be texts", **KNOWN,
    program='N1 DEF STRING[20] FROM1="ONE1", TO1\nN10 TO1="TWO"<<2\nN15 CALL BLOCK FROM1 TO TO1\nN20 GOTOF DONE\nN30 ONE1: R1=R1+1\nN40 TWO2: R2=R2+1\nN50 R3=1\nN60 DONE: M30',
    runs="N1 N10 N15 N30 N40 N20 N60", calls="BLOCK:MAIN",
)
case(
    "one of them may be a text, and the text a block number", **KNOWN,
    program='N1 DEF STRING[20] TO1="n40"\nN15 CALL BLOCK ONE1 TO TO1\nN20 GOTOF DONE\nN30 ONE1: R1=R1+1\nN40 R2=R2+1\nN50 R3=1\nN60 DONE: M30',
    runs="N1 N15 N30 N40 N20 N60",
)
case(
    "of several labels that a text names the nearest before the call counts", **KNOWN,
    program='N1 DEF STRING[20] FROM1="LAB"\nN10 LAB: R1=R1+1\nN20 LAB: R2=R2+1\nN25 R3=R3+1\nN30 CALL BLOCK FROM1 TO N25\nN40 LAB: R4=1\nN50 M30',
    vars={1: 1, 2: 2, 3: 2, 4: 1},
)
case(
    "a text that names no label is 14082", number="14082", **ALARM,
    program='N1 DEF STRING[20] FROM1="NONE"\nN10 CALL BLOCK FROM1 TO LAST\nN30 LAST: M30', runs="N1", alarm="part-incomplete", at="MAIN N10", word="FROM1",
)
case(
    "nor is the end one that stands before the beginning", number="14082", **ALARM,
    program='N1 DEF STRING[20] TO1="ONE1"\nN10 GOTOF TWO2\nN20 ONE1: R1=1\nN30 TWO2: CALL BLOCK THREE TO TO1\nN40 THREE: M30', runs="N1 N10",
    alarm="part-incomplete", at="MAIN N30", word="TO1",
)
OTHER = "\n%_N_PART_SPF\nN70 R4=9\nN75 ONE1: R1=R1+1\nN80 TWO2: R2=R2+1\nN85 R3=9\nN90 M17"
case(
    "CALL with a name and BLOCK runs a part of another program", **KNOWN,
    program='%_N_MAIN_MPF\nN10 CALL "PART" BLOCK ONE1 TO TWO2\nN20 M30' + OTHER, runs="N10 N75 N80 N20", calls="BLOCK:PART", vars={1: 1, 2: 1, 3: None, 4: None},
)
case(
    "its name and its labels may be texts", **KNOWN,
    program='%_N_MAIN_MPF\nN5 DEF STRING[30] NAME="/_N_SPF_DIR/_N_PART_SPF", FIRST="ONE1", LAST="TWO2"\nN10 CALL NAME BLOCK FIRST TO LAST\nN20 M30' + OTHER,
    runs="N5 N10 N75 N80 N20",
)
case(
    "M17 in such a part returns", **KNOWN,
    program='%_N_MAIN_MPF\nN10 CALL "PART" BLOCK TWO2 TO N90\nN20 M30' + OTHER, runs="N10 N80 N85 N90 N20",
)
case(
    "a program that is not there is 14011", number="14011", control=ONE, source="828Dj p.198, the program is cancelled", evidence="secondary",
    program='N10 CALL "NONE" BLOCK ONE1 TO TWO2\nN60 M30', runs="", alarm="named-program-not-found", at="MAIN N10", word='"NONE"',
)
case(
    "nor is a label of another program one of this", number="14082", **ALARM,
    program='%_N_MAIN_MPF\nN10 CALL "PART" BLOCK MINE TO TWO2\nN20 MINE: M30' + OTHER, runs="", alarm="part-incomplete", at="MAIN N10", word="MINE",
)
case(
    "each such call takes a program level", number="14012", control=ONE, source="828D p.490, 16 program levels; CW-S, 14012", evidence="secondary",
    program='%_N_MAIN_MPF\nN10 REC\nN20 M30\n%_N_REC_SPF\nN40 DEEPER: R1=R1+1\nN50 CALL "REC" BLOCK DEEPER TO LAST\nN60 LAST: R2=1\nN80 M17',
    vars={1: 15, 2: None}, alarm="nesting-too-deep", at="REC N50",
)
case(
    "nothing follows it", **KNOWN,
    program='N10 CALL "PART" BLOCK ONE1 TO TWO2 X5\nN60 M30', runs="", alarm="statement-format", at="MAIN N10", word="X5",
)
case(
    "CALL needs TO there too", **KNOWN,
    program='N10 CALL "PART" BLOCK ONE1\nN60 M30', runs="", alarm="statement-format", at="MAIN N10",
)
