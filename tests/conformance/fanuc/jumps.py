"""FANUC: GOTO, IF GOTO and IF THEN."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
NEW = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
OLD = ["fanuc-16i", "fanuc-0i-d"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


# GOTO and IF

case(
    "GOTO jumps forward",
    control=ALL, source="X-GO", evidence="secondary",
    program="""
        O1
        N10 GOTO30
        N20 T1
        N30 M30
    """,
    runs="N10 N30", t=[],
)
case(
    "GOTO jumps backward",
    control=ALL, source="X-GO", evidence="secondary",
    program="""
        O1
        N10 #1=#1+1
        N20 IF[#1 EQ 3]GOTO40
        N30 GOTO10
        N40 M30
    """,
    runs="(N10 N20 N30)*2 N10 N20 N40",
)
case(
    "GOTO takes a variable",
    control=ALL, source="X-GO", evidence="secondary",
    program="""
        O1
        N10 #1=40
        N20 GOTO#1
        N30 T1
        N40 M30
    """,
    runs="N10 N20 N40", t=[],
)
case(
    "GOTO takes an expression",
    control=ALL, source="X-GO", evidence="secondary",
    program="""
        O1
        N10 #1=2
        N20 GOTO[#1*10+20]
        N30 T1
        N40 M30
    """,
    runs="N10 N20 N40", t=[],
)
case(
    "GOTO to a missing block alarms at the GOTO",
    control=ALL, source="ALM PS0128; K-H 128", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 GOTO77
        N30 M30
    """,
    runs="N10", alarm="jump-target-not-found", number=numbers("128", "PS0128"), at="O1 N20",
)
case(
    "GOTO does not look into other programs",
    control=ALL, source="NCT p.188; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 GOTO50
        N20 M30
        O2
        N50 M99
    """,
    runs="", alarm="jump-target-not-found", number=numbers("128", "PS0128"), at="O1 N10",
)
case(
    "IF GOTO to a missing block alarms only if the condition is true",
    control=ALL, source="ALM PS0128; policy: reading never fails", evidence="inferred",
    program="""
        O1
        N10 IF[1 EQ 2]GOTO77
        N20 M30
    """,
    runs="N10 N20",
)
case(
    "GOTO 0 is out of range",
    control=ALL, source="X-GO, ALM PS1128", evidence="secondary",
    program="""
        O1
        N10 GOTO0
        N20 M30
    """,
    runs="", alarm="illegal-jump-number", number=numbers("128", "PS1128"), at="O1 N10",
)
case(
    "GOTO 100000 is out of range where N has five digits",
    control=OLD, source="X-GO, PB155", evidence="secondary",
    program="""
        O1
        N10 #1=100000
        N20 GOTO#1
        N30 M30
    """,
    runs="N10", alarm="illegal-jump-number", number={"fanuc-16i": "128", "fanuc-0i-d": "PS1128"},
    at="O1 N20",
)
case(
    "GOTO 99999 is in range",
    control=ALL, source="X-GO, PB155", evidence="secondary",
    program="""
        O1
        N10 GOTO99999
        N20 T1
        N99999 M30
    """,
    runs="N10 N99999", t=[],
)
case(
    "GOTO 123456789 is out of range",
    control="fanuc-30i", source="ALM PS1128", evidence="secondary",
    program="""
        O1
        N10 #1=123456789
        N20 GOTO#1
        N30 M30
    """,
    runs="N10", alarm="illegal-jump-number", number="PS1128", at="O1 N20",
)
case(
    "GOTO takes an eight-digit number",
    control="fanuc-30i", source="ALM PS1128", evidence="secondary",
    program="""
        O1
        N10 GOTO12345678
        N20 T1
        N12345678 M30
    """,
    runs="N10 N12345678", t=[],
)
case(
    "of two equal N after it GOTO takes the nearer",
    control=ALL, source="policy; FIN", evidence="inferred",
    program="""
        O1
        N10 GOTO40
        N20 T1
        N40 #100=1
        N50 M30
        N40 #100=2
        N60 M30
    """,
    runs="N10 N40 N50", vars={100: 1},
)
case(
    "of two equal N before it GOTO takes the first of the program",
    control=ALL, source="policy; FIN", evidence="inferred",
    program="""
        O1
        N5 #1=#1+1
        N10 #100=#100+1
        N10 #101=#101+1
        N20 IF[#1 GE 2]GOTO50
        N30 #1=2
        N40 GOTO10
        N50 M30
    """,
    runs="N5 N10*2 N20 N30 N40 N10*2 N20 N50", vars={100: 2, 101: 2},
)
case(
    "GOTO without a number is no statement",
    control=ALL, source="ALM PS0125; K-H 114", evidence="inferred",
    program="""
        O1
        N10 GOTO
        N20 M30
    """,
    runs="", alarm="statement-format", number=numbers("114", "PS0125"), at="O1 N10",
)
case(
    "an IF whose condition is true jumps",
    control=ALL, source="X-GO", evidence="secondary",
    program="""
        O1
        N10 IF[2 GT 1]GOTO30
        N20 T1
        N30 M30
    """,
    runs="N10 N30",
)
case(
    "an IF whose condition is false goes on with the next block",
    control=ALL, source="X-GO", evidence="secondary",
    program="""
        O1
        N10 IF[1 GT 2]GOTO30
        N20 T1
        N30 M30
    """,
    runs="N10 N20 N30", t=[1],
)
case(
    "EQ compares numbers",
    control=ALL, source="X-GO, MEX", evidence="secondary",
    program="""
        O1
        N10 IF[2 EQ 2]THEN #100=1
        N20 IF[2 EQ 3]THEN #101=1
        N30 M30
    """,
    runs="N10 N20 N30", vars={100: 1, 101: None},
)
case(
    "NE compares numbers",
    control=ALL, source="X-GO, MEX", evidence="secondary",
    program="""
        O1
        N10 IF[2 NE 3]THEN #100=1
        N20 IF[2 NE 2]THEN #101=1
        N30 M30
    """,
    runs="N10 N20 N30", vars={100: 1, 101: None},
)
case(
    "GT compares numbers",
    control=ALL, source="X-GO, MEX", evidence="secondary",
    program="""
        O1
        N10 IF[3 GT 2]THEN #100=1
        N20 IF[2 GT 2]THEN #101=1
        N30 M30
    """,
    runs="N10 N20 N30", vars={100: 1, 101: None},
)
case(
    "GE compares numbers",
    control=ALL, source="X-GO, MEX", evidence="secondary",
    program="""
        O1
        N10 IF[2 GE 2]THEN #100=1
        N20 IF[2 GE 3]THEN #101=1
        N30 M30
    """,
    runs="N10 N20 N30", vars={100: 1, 101: None},
)
case(
    "LT compares numbers",
    control=ALL, source="X-GO, MEX", evidence="secondary",
    program="""
        O1
        N10 IF[2 LT 3]THEN #100=1
        N20 IF[2 LT 2]THEN #101=1
        N30 M30
    """,
    runs="N10 N20 N30", vars={100: 1, 101: None},
)
case(
    "LE compares numbers",
    control=ALL, source="X-GO, MEX", evidence="secondary",
    program="""
        O1
        N10 IF[2 LE 2]THEN #100=1
        N20 IF[3 LE 2]THEN #101=1
        N30 M30
    """,
    runs="N10 N20 N30", vars={100: 1, 101: None},
)
case(
    "both sides of a comparison may be expressions",
    control=ALL, source="X-GO", evidence="secondary",
    program="""
        O1
        N10 #1=3
        N20 IF[#1*2 EQ [#1+3]]GOTO40
        N30 T1
        N40 M30
    """,
    runs="N10 N20 N40", t=[],
)
case(
    "IF THEN takes an assignment",
    control=ALL, source="X-GO, FIN", evidence="secondary",
    program="""
        O1
        N10 IF[1 EQ 1]THEN #100=2*3
        N20 M30
    """,
    runs="N10 N20", vars={100: 6},
)
case(
    "IF THEN with a false condition assigns nothing",
    control=ALL, source="X-GO, FIN", evidence="secondary",
    program="""
        O1
        N10 IF[1 EQ 2]THEN #100=1
        N20 M30
    """,
    runs="N10 N20", vars={100: None},
)
case(
    "IF THEN with an NC word alarms",
    control=ALL, source="FIN; ALM PS1137; K-M 114", evidence="secondary",
    program="""
        O1
        N10 IF[1 EQ 1]THEN M8
        N20 M30
    """,
    runs="", alarm="if-format", number=numbers("114", "PS1137"), at="O1 N10", m=[],
)
case(
    "IF THEN takes one statement, not two",
    control=ALL, source="FIN; ALM PS1137; K-M 114", evidence="secondary",
    program="""
        O1
        N10 IF[1 EQ 1]THEN #100=1 #101=2
        N20 M30
    """,
    runs="", alarm="if-format", number=numbers("114", "PS1137"), at="O1 N10", vars={100: None},
)
case(
    "IF without GOTO or THEN alarms",
    control=ALL, source="ALM PS1137; K-M 114", evidence="secondary",
    program="""
        O1
        N10 IF[1 EQ 1]
        N20 M30
    """,
    runs="", alarm="if-format", number=numbers("114", "PS1137"), at="O1 N10",
)
case(
    "IF without brackets alarms",
    control=ALL, source="ALM PS1137; K-M 114", evidence="secondary",
    program="""
        O1
        N10 IF 1 EQ 1 GOTO20
        N20 M30
    """,
    runs="", alarm="if-format", number=numbers("114", "PS1137"), at="O1 N10",
)
case(
    "with 6006#0=1 AND joins two conditions",
    control=NEW, source="K-M parameter", evidence="inferred",
    program="""
        O1
        N10 IF[[1 EQ 1] AND [2 EQ 3]]GOTO30
        N20 T1
        N30 M30
    """,
    params={"6006#0": 1}, runs="N10 N20 N30", t=[1],
)
case(
    "with 6006#0=1 OR joins two conditions",
    control=NEW, source="K-M parameter", evidence="inferred",
    program="""
        O1
        N10 IF[[1 EQ 1] OR [2 EQ 3]]GOTO30
        N20 T1
        N30 M30
    """,
    params={"6006#0": 1}, runs="N10 N30", t=[],
)
case(
    "without 6006#0 AND between conditions alarms",
    control=NEW, source="K-M parameter; ALM PS1137", evidence="inferred",
    program="""
        O1
        N10 IF[[1 EQ 1] AND [2 EQ 2]]GOTO30
        N20 T1
        N30 M30
    """,
    runs="", alarm="if-format", number="PS1137", at="O1 N10",
)

# More that alarms: in statements

case(
    "a condition with a variable that does not exist alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 IF[#40 EQ 1]GOTO30
        N30 M30
    """,
    runs="N10", alarm="illegal-variable", number=numbers("115", "PS0115"), at="O1 N20",
)
case(
    "a jump to the number in a variable that does not exist alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 GOTO#40
        N30 M30
    """,
    runs="N10", alarm="illegal-variable", number=numbers("115", "PS0115"), at="O1 N20",
)
case(
    "a jump to a division by zero alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 GOTO[30/0]
        N30 M30
    """,
    runs="N10", alarm="division-by-zero", number=numbers("112", "PS0112"), at="O1 N20",
)
case(
    "a division by zero after a true condition alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 IF[1 EQ 1]THEN #1=1/0
        N30 M30
    """,
    runs="N10", alarm="division-by-zero", number=numbers("112", "PS0112"), at="O1 N20",
)
case(
    "the square root of a negative value in a condition alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 IF[SQRT[-1] GT 1]GOTO30
        N30 M30
    """,
    runs="N10", alarm="square-root-of-negative", number=numbers("119", "PS0119"), at="O1 N20",
)
case(
    "a GOTO to a minus number is out of range",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 GOTO[0-30]
        N30 M30
    """,
    runs="N10", alarm="illegal-jump-number", number=numbers("128", "PS1128"), at="O1 N20",
)
case(
    "IF THEN without a statement alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 IF[1 EQ 1]THEN
        N30 M30
    """,
    runs="N10", alarm="if-format", number=numbers("114", "PS1137"), at="O1 N20",
)
case(
    "IF THEN with an axis word alarms",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 IF[1 EQ 1]THEN X5.
        N30 M30
    """,
    runs="N10", alarm="if-format", number=numbers("114", "PS1137"), at="O1 N20",
)
case(
    "IF THEN with M30 alarms and does not end the program",
    control=ALL, source="ALM; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 IF[1 EQ 1]THEN M30
        N30 M30
    """,
    runs="N10", alarm="if-format", number=numbers("114", "PS1137"), at="O1 N20",
)
case(
    "IF THEN with an NC word alarms even if its condition is false",
    control=ALL, source="ALM PS1137; policy: a control reads a block when it reaches it",
    evidence="inferred",
    program="""
        O1
        N10 T1
        N20 IF[1 EQ 2]THEN M8
        N30 M30
    """,
    runs="N10", alarm="if-format", number=numbers("114", "PS1137"), at="O1 N20",
)

case(
    "a GOTO does not find a sequence number of the caller (F125)",
    control=["fanuc-16i", "fanuc-30i"],
    source="NCT p.188; the number for a GOTO is policy",
    evidence="inferred",
    program="""
        O1
        M98 P2
        N50 M30
        O2
        GOTO 50
        M99
    """,
    alarm="jump-target-not-found",
    number={"fanuc-16i": "128", "fanuc-30i": "PS0128"},
    at="O2",
)

case(
    "GOTO finds blocks before and after it (F516)",
    control=["fanuc-16i", "fanuc-30i"],
    source="X-GO",
    evidence="secondary",
    program="""
        O1
        N10 #100=#100+1
        N20 IF[#100 GE 3] GOTO 40
        N30 GOTO 10
        N40 M30
    """,
    runs="N10 N20 N30 N10 N20 N30 N10 N20 N40",
    vars={100: 3},
)

case(
    "a GOTO to a sequence number that is not there alarms (F518)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0128; PS0128 or PS0078 is policy",
    evidence="inferred",
    program="""
        O1
        GOTO 500
        M30
    """,
    alarm="jump-target-not-found",
    number={"fanuc-16i": "128", "fanuc-30i": "PS0128"},
    at="O1",
)

case(
    "GOTO 123456 is out of the range of the 16i (F520)",
    control="fanuc-16i",
    source="X-GO; PB155",
    evidence="secondary",
    program="""
        O1
        GOTO 123456
        M30
        N123456 #100=1
        M30
    """,
    alarm="illegal-jump-number",
    number="128",
    at="O1",
)

case(
    "GOTO 123456 is inside the range of the 30i (F520)",
    control="fanuc-30i",
    source="ALM PS1128",
    evidence="secondary",
    program="""
        O1
        GOTO 123456
        M30
        N123456 #100=1
        M30
    """,
    runs="N123456",
    vars={100: 1},
)

case(
    "IF THEN runs its statement where the condition is true and only there (F521)",
    control=["fanuc-16i", "fanuc-30i"],
    source="X-GO; FIN",
    evidence="secondary",
    program="""
        O1
        #1=2
        IF[#1 EQ 2] THEN #100=1
        IF[#1 LT 2] THEN #101=1
        M30
    """,
    vars={100: 1, 101: None},
)

case(
    "both sides of a condition may be expressions (F522)",
    control=["fanuc-16i", "fanuc-30i"],
    source="X-GO; NCT",
    evidence="secondary",
    program="""
        O1
        #1=4
        #7=1
        #100=2
        #101=60
        IF[[#1/[#7+3]] LT [#100*SIN[#101+30]]] GOTO 75
        #102=9
        N75 M30
    """,
    runs="N75",
    vars={102: None},
)

case(
    "of two blocks with one sequence number GOTO takes the one after it first (F549)",
    control=["fanuc-16i", "fanuc-30i"],
    source="policy; FIN",
    evidence="inferred",
    program="""
        O1
        N10 #100=#100+1
        N20 GOTO 10
        N10 #101=1
        N30 M30
    """,
    runs="N10 N20 N10 N30",
    vars={100: 1, 101: 1},
)
