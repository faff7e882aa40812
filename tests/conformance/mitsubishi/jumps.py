"""Mitsubishi: IF and GOTO."""

from conformance import case

case(
    "IF GOTO jumps where the condition is true and only there (MIT-113)",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        #1=3
        IF[#1 EQ 3]GOTO 20
        G0 X9
        N20 G0 X1
        IF[#1 EQ 4]GOTO 30
        G0 X2
        N30 M30
    """,
    moves_x=[1, 2],
)

case(
    "of two blocks with one number GOTO takes the next one after it (MIT-115)",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        N10 G0 X1
        GOTO 10
        G0 X9
        N10 G0 X2
        M30
    """,
    moves_x=[1, 2],
)

case(
    "GOTO finds a block before it (MIT-116)",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        #1=0
        N10 G0 X1
        #1=#1+1
        IF[#1 LT 3]GOTO 10
        G0 X2
        M30
    """,
    moves_x=[1, 1, 1, 2],
)

MELDAS = "mitsubishi-meldas"
M700 = "mitsubishi-m700"
M800 = "mitsubishi-m800"
NEWER = [M700, M800]
EVERY = [MELDAS, M700, M800]

case(
    "GOTO goes on at the named block",
    control=EVERY, source="general knowledge, GOTO", evidence="inferred",
    program="""
        O1
        N10 GOTO30
        N20 S2
        N30 M30
    """,
    runs="N10 N30",
)
case(
    "a GOTO to a block that does not exist is P231",
    control=EVERY, source="MZ 843; source 004, P231", evidence="secondary",
    program="""
        O1
        N10 S1
        N20 GOTO99
        N30 M30
    """,
    runs="N10", alarm="jump-target-not-found", number="P231", at="O1 N20",
)
case(
    "GOTO does not look into another program",
    control=EVERY, source="MZ 843; source 004, P231", evidence="secondary",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 GOTO20
        N220 M99
    """,
    runs="N10", alarm="jump-target-not-found", number="P231", at="O200 N210",
)
case(
    "GOTO takes the next block with the number, not the first of the program",
    control=[MELDAS, M800], source="general knowledge, forward to the end, then from the head",
    evidence="inferred",
    program="""
        O1
        N10 GOTO40
        N20 S1
        N30 M30
        N40 GOTO20
        N50 S5
        N20 M30
    """,
    runs="N10 N40 N20",
)
case(
    "GOTO searches from the head when nothing stands after it",
    control=EVERY, source="general knowledge, forward to the end, then from the head",
    evidence="inferred",
    program="""
        O1
        N10 #1=#1+1
        N20 S2
        N30 IF[#1 LT 3]GOTO10
        N40 M30
    """,
    runs="(N10 N20 N30)*3 N40", vars={1: 3},
)
case(
    "of two blocks in front of a GOTO the first of the program counts",
    control=EVERY, source="general knowledge, forward to the end, then from the head",
    evidence="inferred",
    program="""
        O1
        N5 GOTO40
        N10 M30
        N10 S2
        N40 GOTO10
    """,
    runs="N5 N40 N10",
)
case(
    "the target of GOTO may be a variable",
    control=EVERY, source="general knowledge, GOTO n", evidence="inferred",
    program="""
        O1
        N10 #1=40
        N20 GOTO#1
        N30 S3
        N40 M30
    """,
    runs="N10 N20 N40",
)
case(
    "the target of GOTO may be an expression",
    control=EVERY, source="general knowledge, GOTO n", evidence="inferred",
    program="""
        O1
        N10 #1=3
        N20 GOTO[#1*10+10]
        N30 S3
        N40 M30
    """,
    runs="N10 N20 N40",
)
case(
    "a computed GOTO to a block that does not exist is P231",
    control=EVERY, source="MZ 843; source 004, P231", evidence="inferred",
    program="""
        O1
        N10 #1=3
        N20 GOTO[#1*10+1]
        N30 M30
    """,
    runs="N10", alarm="jump-target-not-found", number="P231", at="O1 N20",
)
case(
    "a false IF asks for no target",
    control=EVERY, source="general knowledge, IF", evidence="inferred",
    program="""
        O1
        N10 IF[1 EQ 2]GOTO99
        N20 M30
    """,
    runs="N10 N20",
)
case(
    "a true IF whose target is missing is P231",
    control=EVERY, source="MZ 843; source 004, P231", evidence="secondary",
    program="""
        O1
        N10 IF[2 EQ 2]GOTO99
        N20 M30
    """,
    runs="", alarm="jump-target-not-found", number="P231", at="O1 N10",
)
case(
    "a true IF without the number after GOTO is P290",
    control=EVERY, source="general knowledge, IF; MZ 864, P290 paired", evidence="inferred",
    program="""
        O1
        N10 IF[2 EQ 2]GOTO
        N20 M30
    """,
    runs="", alarm="if-format", number="P290", at="O1 N10",
)
case(
    "an IF without brackets is P290",
    control=EVERY, source="MZ 864, P290 paired", evidence="inferred",
    program="""
        O1
        N10 IF 2 EQ 2 GOTO20
        N20 M30
    """,
    runs="", alarm="if-format", number="P290", at="O1 N10",
)
case(
    "an IF with a condition and nothing after it is P290",
    control=EVERY, source="MZ 864, P290 paired", evidence="inferred",
    program="""
        O1
        N10 IF[2 EQ 2]
        N20 M30
    """,
    runs="", alarm="if-format", number="P290", at="O1 N10",
)
case(
    "the N of a jump target must stand at the head of its block",
    control=EVERY, source="general knowledge, N at the head; source 004, P231",
    evidence="inferred",
    program="""
        O1
        N10 GOTO40
        N20 S2
        S4 N40
        N50 M30
    """,
    runs="", alarm="jump-target-not-found", number="P231", at="O1 N10",
)
case(
    "a jump finds the block after a block skip that is on and goes on with the next",
    control=EVERY, source="general knowledge", evidence="inferred",
    program="""
        O1
        N10 GOTO30
        N20 S2
        /N30 S3
        N40 M30
    """,
    skip=(1,), runs="N10 N40",
)
case(
    "EQ jumps when 5 EQ 5 and not when 5 EQ 4",
    control=EVERY, source="general knowledge, condition operators", evidence="inferred",
    program="O1\nN10 #1=5\nN20 IF[#1 EQ 4]GOTO50\nN30 IF[#1 EQ 5]GOTO50\nN40 S4\nN50 M30",
    runs="N10 N20 N30 N50",
)
case(
    "NE jumps when 5 NE 4 and not when 5 NE 5",
    control=EVERY, source="general knowledge, condition operators", evidence="inferred",
    program="O1\nN10 #1=5\nN20 IF[#1 NE 5]GOTO50\nN30 IF[#1 NE 4]GOTO50\nN40 S4\nN50 M30",
    runs="N10 N20 N30 N50",
)
case(
    "GT jumps when 5 GT 4 and not when 5 GT 5",
    control=EVERY, source="general knowledge, condition operators", evidence="inferred",
    program="O1\nN10 #1=5\nN20 IF[#1 GT 5]GOTO50\nN30 IF[#1 GT 4]GOTO50\nN40 S4\nN50 M30",
    runs="N10 N20 N30 N50",
)
case(
    "LT jumps when 5 LT 6 and not when 5 LT 5",
    control=EVERY, source="general knowledge, condition operators", evidence="inferred",
    program="O1\nN10 #1=5\nN20 IF[#1 LT 5]GOTO50\nN30 IF[#1 LT 6]GOTO50\nN40 S4\nN50 M30",
    runs="N10 N20 N30 N50",
)
case(
    "GE jumps when 5 GE 5 and not when 5 GE 6",
    control=EVERY, source="general knowledge, condition operators", evidence="inferred",
    program="O1\nN10 #1=5\nN20 IF[#1 GE 6]GOTO50\nN30 IF[#1 GE 5]GOTO50\nN40 S4\nN50 M30",
    runs="N10 N20 N30 N50",
)
case(
    "LE jumps when 5 LE 5 and not when 5 LE 4",
    control=EVERY, source="general knowledge, condition operators", evidence="inferred",
    program="O1\nN10 #1=5\nN20 IF[#1 LE 4]GOTO50\nN30 IF[#1 LE 5]GOTO50\nN40 S4\nN50 M30",
    runs="N10 N20 N30 N50",
)
case(
    "an operator that does not exist is P290",
    control=EVERY, source="MZ 864, P290 paired", evidence="inferred",
    program="""
        O1
        N10 IF[#1 ET 5]GOTO20
        N20 M30
    """,
    runs="", alarm="if-format", number="P290", at="O1 N10",
)
case(
    "M700: IF THEN takes one statement in the block",
    control=NEWER, source="general knowledge, IF THEN", evidence="inferred",
    program="""
        O1
        N10 IF[1 EQ 1]THEN #100=7
        N20 IF[1 EQ 2]THEN #101=8
        N30 M30
    """,
    variables={101: 1}, runs="N10 N20 N30", vars={100: 7, 101: 1},
)
case(
    "MELDAS has no IF THEN",
    control=MELDAS, source="general knowledge, IF THEN; MZ 864, P290 paired", evidence="inferred",
    program="""
        O1
        N10 IF[1 EQ 1]THEN #100=7
        N20 M30
    """,
    runs="", alarm="if-format", number="P290", at="O1 N10",
)
case(
    "M700: an IF THEN with nothing after it is P290",
    control=M700, source="general knowledge, IF THEN; MZ 864, P290 paired", evidence="inferred",
    program="""
        O1
        N10 IF[1 EQ 1]THEN
        N20 #100=7
        N30 ENDIF
        N40 M30
    """,
    runs="", alarm="if-format", number="P290", at="O1 N10",
)
