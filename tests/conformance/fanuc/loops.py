"""FANUC: WHILE, DO, END."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
NEW = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


case(
    "WHILE repeats while its condition is true",
    control=ALL, source="X-GO", evidence="secondary",
    program="""
        O1
        N10 WHILE[#1 LT 3]DO1
        N20 #1=#1+1
        N30 END1
        N40 M30
    """,
    runs="(N10 N20 N30)*3 N10 N40", vars={1: 3},
)
case(
    "WHILE with a false condition goes on after its END",
    control=ALL, source="X-GO", evidence="secondary",
    program="""
        O1
        N10 WHILE[1 EQ 2]DO2
        N20 T1
        N30 END2
        N40 M30
    """,
    runs="N10 N40", t=[],
)
case(
    "DO without WHILE repeats for ever",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 DO1
        N20 #1=#1+1
        N30 END1
        N40 M30
    """,
    max_blocks=60, stop="limit", runs="(N10 N20 N30)*20", vars={1: 20},
)
case(
    "loops may be nested three deep",
    pins="max_loop_number max_loops",
    control=[*ALL, "haas-ngc"], source="ISO; X-GO", evidence="secondary",
    program="""
        O1
        N10 WHILE[#1 LT 2]DO1
        N20 #2=0
        N30 WHILE[#2 LT 2]DO2
        N40 #3=0
        N50 WHILE[#3 LT 2]DO3
        N60 #3=#3+1
        N65 #100=#100+1
        N70 END3
        N80 #2=#2+1
        N90 END2
        N100 #1=#1+1
        N110 END1
        N120 M30
    """,
    vars={100: 8},
)
case(
    "a loop number may be used again after its END",
    control=ALL, source="ISO; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 WHILE[#1 LT 1]DO1
        N20 #1=#1+1
        N30 END1
        N40 WHILE[#2 LT 1]DO1
        N50 #2=#2+1
        N60 END1
        N70 M30
    """,
    runs="N10 N20 N30 N10 N40 N50 N60 N40 N70",
)
case(
    "the numbers of nested loops may stand in any order",
    control=ALL, source="ISO; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 WHILE[#1 LT 1]DO3
        N20 WHILE[#2 LT 1]DO1
        N30 #2=1
        N40 END1
        N50 #1=1
        N60 END3
        N70 M30
    """,
    runs="N10 N20 N30 N40 N20 N50 N60 N10 N70",
)
case(
    "DO 4 is no loop number",
    control=ALL, source="ISO, ALM PS0126", evidence="secondary",
    program="""
        O1
        N10 WHILE[#1 LT 3]DO4
        N20 #1=9
        N30 END4
        N40 M30
    """,
    runs="", alarm="illegal-loop-number", number=numbers("126", "PS0126"), at="O1 N10",
)
case(
    "DO 0 is no loop number",
    control=ALL, source="ISO, ALM PS0126", evidence="secondary",
    program="""
        O1
        N10 DO0
        N20 END0
        N30 M30
    """,
    runs="", alarm="illegal-loop-number", number=numbers("126", "PS0126"), at="O1 N10",
)
case(
    "a DO without its END alarms",
    control=ALL, source="ALM PS0124", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 DO1
        N30 #1=1
        N40 M30
    """,
    alarm="missing-end", number=numbers("124", "PS0124"), t=[1],
)
case(
    "an END with another number does not end a DO",
    control=ALL, source="ALM PS0124", evidence="secondary",
    program="""
        O1
        N10 WHILE[#1 LT 3]DO1
        N20 #1=#1+1
        N30 END2
        N40 M30
    """,
    alarm="missing-end", number=numbers("124", "PS0124"),
)
case(
    "an END of another program does not end a DO",
    control=ALL, source="ALM PS0124; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 DO1
        N20 M30
        O2
        N30 END1
        N40 M99
    """,
    alarm="missing-end", number=numbers("124", "PS0124"),
)
case(
    "an END without its DO alarms",
    control=ALL, source="ALM PS1124; K-H 124", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 END1
        N30 M30
    """,
    runs="N10", alarm="missing-do", number=numbers("124", "PS1124"), at="O1 N20",
)
case(
    "a jump into a loop alarms at its END",
    control=ALL, source="K-H general knowledge; ALM PS1124", evidence="inferred",
    program="""
        O1
        N10 GOTO30
        N20 WHILE[#1 LT 3]DO1
        N30 #1=#1+1
        N40 END1
        N50 M30
    """,
    runs="N10 N30", alarm="missing-do", number=numbers("124", "PS1124"), at="O1 N40",
)
case(
    "a jump out of a loop leaves it, and it can be entered again at its DO",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 #2=0
        DO1
        N20 #1=#1+1
        N30 IF[#1 EQ 1]GOTO50
        N35 IF[#1 EQ 3]GOTO60
        N40 END1
        N50 GOTO10
        N60 M30
    """,
    runs="N10 N20 N30 N50 N10 N20 N30 N35 N40 N20 N30 N35 N60", vars={1: 3},
)
case(
    "a jump inside a loop stays in it",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 WHILE[#1 LT 2]DO1
        N20 #1=#1+1
        N30 GOTO50
        N40 T1
        N50 END1
        N60 M30
    """,
    runs="(N10 N20 N30 N50)*2 N10 N60", t=[],
)
case(
    "M99 inside a loop leaves the loop of the subprogram",
    control=ALL, source="policy", evidence="inferred",
    program="""
        O1
        N10 M98 P2 L2
        N20 M30
        O2
        N30 DO1
        N40 M99
        N50 END1
    """,
    runs="N10 (N30 N40)*2 N20",
)
case(
    "an END in a subprogram does not end the DO of its caller",
    control=ALL, source="policy; ALM PS1124", evidence="inferred",
    program="""
        O1
        N10 DO1
        N20 M98 P2
        N30 END1
        N40 M30
        O2
        N50 END1
        N60 M99
    """,
    runs="N10 N20", alarm="missing-do", number=numbers("124", "PS1124"), at="O2 N50",
)
case(
    "WHILE without DO alarms",
    control=NEW, source="ALM PS1138", evidence="secondary",
    program="""
        O1
        N10 WHILE[1 EQ 2]
        N20 M30
    """,
    runs="", alarm="while-format", number="PS1138", at="O1 N10",
)
case(
    "WHILE without brackets alarms",
    control=NEW, source="ALM PS1138", evidence="secondary",
    program="""
        O1
        N10 WHILE #1 LT 2 DO1
        N20 END1
        N30 M30
    """,
    runs="", alarm="while-format", number="PS1138", at="O1 N10",
)
case(
    "a GOTO in a subprogram's loop does not disturb the caller's loop",
    control=ALL, source="policy", evidence="inferred",
    program="""
        O1
        N10 WHILE[#100 LT 2]DO1
        N20 M98 P2
        N30 END1
        N40 M30
        O2
        N50 DO1
        N60 #100=#100+1
        N70 GOTO90
        N80 END1
        N90 M99
    """,
    runs="(N10 N20 N50 N60 N70 N90 N30)*2 N10 N40", vars={100: 2},
)
case(
    "END 4 is no loop number",
    control=ALL, source="ALM PS0126, ISO", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 END4
        N30 M30
    """,
    runs="N10", alarm="illegal-loop-number", number=numbers("126", "PS0126"), at="O1 N20",
)
case(
    "a jump into the inner of two loops alarms at its END",
    control=ALL, source="K-H general knowledge; ALM PS1124", evidence="inferred",
    program="""
        O1
        N10 GOTO40
        N20 WHILE[#1 LT 2]DO1
        N30 WHILE[#2 LT 2]DO2
        N40 #2=2
        N50 END2
        N60 #1=2
        N70 END1
        N80 M30
    """,
    runs="N10 N40", alarm="missing-do", number=numbers("124", "PS1124"), at="O1 N50",
)
case(
    "a jump out of a loop to before it and past its DO alarms at its END",
    control=ALL, source="K-H general knowledge; ALM PS1124", evidence="inferred",
    program="""
        O1
        N10 IF[#1 EQ 1]GOTO40
        N20 WHILE[#1 LT 2]DO1
        N30 #1=#1+1
        N35 GOTO10
        N40 T4
        N50 END1
        N60 M30
    """,
    runs="N10 N20 N30 N35 N10 N40", alarm="missing-do", number=numbers("124", "PS1124"),
    at="O1 N50", t=[4],
)

case(
    "a WHILE that is false at once runs nothing of its loop (F524)",
    control=["fanuc-16i", "fanuc-30i"],
    source="X-GO",
    evidence="secondary",
    program="""
        O1
        WHILE[1 GT 2]DO1
        N10 #100=1
        END1
        N20 M30
    """,
    runs="N20",
    vars={100: None},
)

case(
    "a DO without an END alarms (F528)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0124; 16i: general knowledge of the FANUC manuals",
    evidence="maker's manual",
    program="""
        O1
        WHILE[1 EQ 1]DO1
        #100=1
        M30
    """,
    alarm="missing-end",
    number={"fanuc-16i": "124", "fanuc-30i": "PS0124"},
    at="O1",
)

case(
    "an END without a DO alarms (F529)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS1124; 16i: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        #100=1
        END1
        M30
    """,
    alarm="missing-do",
    number={"fanuc-16i": "124", "fanuc-30i": "PS1124"},
    at="O1",
)

case(
    "a GOTO may leave a loop (F530)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        DO1
        #100=#100+1
        IF[#100 EQ 5] GOTO 90
        END1
        N90 M30
    """,
    runs="N90",
    vars={100: 5},
)

case(
    "loops that cross alarm (F532)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ISO; general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        DO1
        DO2
        END1
        END2
        M30
    """,
    alarm="missing-end",
    number={"fanuc-16i": "124", "fanuc-30i": "PS0124"},
    at="O1",
)

case(
    "a loop of the caller goes on after a macro with a loop of the same number (F548)",
    control=["fanuc-16i", "fanuc-30i"],
    source="general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        #1=0
        WHILE[#1 LT 3]DO1
        G65 P2 A#1
        #1=#1+1
        END1
        M30
        O2
        #1=#1*2
        WHILE[#2 LT 2]DO1
        #100=#100+#1
        #2=#2+1
        END1
        M99
    """,
    vars={100: 12, 1: 3},
)
