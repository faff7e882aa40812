"""Mitsubishi: WHILE, DO, END."""

from conformance import case

case(
    "WHILE runs its loop as long as the condition is true (MIT-117)",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        #1=1
        WHILE[#1 LE 3]DO1
        G0 X#1
        #1=#1+1
        END1
        G0 X9
        M30
    """,
    moves_x=[1, 2, 3, 9],
)

case(
    "a DO without its END alarms on the M700 (MIT-118)",
    control="mitsubishi-m700",
    source="MZ 868, paired with P294",
    evidence="secondary",
    program="""
        O1
        #1=1
        WHILE[#1 LE 3]DO1
        G0 X#1
        M30
    """,
    moves_x=[],
    alarm="missing-end",
    number="P294",
    at="O1",
)

case(
    "M98 works inside a WHILE (MIT-119)",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        #1=1
        WHILE[#1 LE 2]DO1
        M98 P2
        #1=#1+1
        END1
        M30
        O2
        G0 X#1
        M99
    """,
    moves_x=[1, 2],
)

MELDAS = "mitsubishi-meldas"
M700 = "mitsubishi-m700"
M800 = "mitsubishi-m800"
EVERY = [MELDAS, M700, M800]


def loops(depth, body):
    """Return `depth` DO loops inside each other, each left after one pass."""
    text = ""
    for k in range(1, depth + 1):
        text += f"#{100 + k}=0\nN{k} WHILE[#{100 + k} LT 1]DO{k}\n#{100 + k}=1\n"
    text += body
    return text + "".join(f"END{k}\n" for k in range(depth, 0, -1))


case(
    "a WHILE loop runs until its condition is false",
    control=EVERY, source="general knowledge, WHILE", evidence="inferred",
    program="""
        O1
        N10 #1=3
        N20 WHILE[#1 GT 0]DO1
        N30 #1=#1-1
        N40 END1
        N50 M30
    """,
    runs="N10 (N20 N30 N40)*3 N20 N50", vars={1: 0},
)
case(
    "a WHILE that is false from the start goes on after its END",
    control=EVERY, source="general knowledge, WHILE", evidence="inferred",
    program="""
        O1
        N10 WHILE[1 GT 2]DO5
        N20 S2
        N30 END5
        N40 M30
    """,
    runs="N10 N40",
)
case(
    "DO127 is a loop like any other",
    pins="max_loop_number",
    control=EVERY, source="general knowledge, m 1 to 127", evidence="inferred",
    program="""
        O1
        N10 WHILE[#1 LT 2]DO127
        N20 #1=#1+1
        N30 END127
        N40 M30
    """,
    runs="(N10 N20 N30)*2 N10 N40",
)
case(
    "DO without WHILE never ends by itself",
    control=EVERY, source="general knowledge, DO", evidence="inferred",
    program="""
        O1
        N10 DO1
        N20 S2
        N30 END1
        N40 M30
    """,
    max_blocks=6, runs="(N10 N20 N30)*2", stop="limit",
)
case(
    "a jump out of a DO loop is allowed",
    control=EVERY, source="general knowledge, DO", evidence="inferred",
    program="""
        O1
        N10 DO1
        N20 #1=#1+1
        N30 IF[#1 EQ 2]GOTO50
        N40 END1
        N50 M30
    """,
    runs="N10 N20 N30 N40 N10 N20 N30 N50",
)
case(
    "a jump into a DO loop is P294",
    control=EVERY, source="general knowledge, DO; MZ 868, P294 paired", evidence="inferred",
    program="""
        O1
        N10 GOTO30
        N20 WHILE[1 EQ 1]DO1
        N30 S3
        N40 END1
        N50 M30
    """,
    runs=None, alarm="missing-do", number="P294",
)
case(
    "a WHILE loop without its END is P294 even when it would not run",
    control=EVERY, source="MZ 868, P294 paired", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 WHILE[1 EQ 2]DO1
        N30 S3
        N40 M30
    """,
    runs="N10", alarm="missing-end", number="P294", at="O1 N20",
)
case(
    "END without DO is P294",
    control=EVERY, source="MZ 868, P294 paired", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 END1
        N30 M30
    """,
    runs="N10", alarm="missing-do", number="P294", at="O1 N20",
)
case(
    "an END of another number does not end a loop",
    control=EVERY, source="MZ 868, P294 paired", evidence="inferred",
    program="""
        O1
        N10 WHILE[1 EQ 2]DO1
        N20 S2
        N30 END2
        N40 M30
    """,
    runs="", alarm="missing-end", number="P294", at="O1 N10",
)
case(
    "the END of a loop must stand in the same program",
    control=EVERY, source="general knowledge, END; MZ 868, P294 paired", evidence="inferred",
    program="""
        O1
        N10 WHILE[1 EQ 1]DO1
        N20 M98 P200
        N30 M30
        O200
        N210 END1
        N220 M99
    """,
    runs="", alarm="missing-end", number="P294", at="O1 N10",
)
case(
    "loops that cross are P294",
    control=EVERY, source="MZ 868, P294 paired", evidence="inferred",
    program="""
        O1
        N10 WHILE[#1 LT 1]DO1
        N20 WHILE[#1 LT 1]DO2
        N30 #1=1
        N40 END1
        N50 END2
        N60 M30
    """,
    runs=None, alarm="missing-end", number="P294",
)
case(
    "a WHILE without DO is P291",
    control=EVERY, source="MZ 865, P291 paired", evidence="inferred",
    program="""
        O1
        N10 WHILE[#1 LT 3]
        N20 END1
        N30 M30
    """,
    runs="", alarm="while-format", number="P291", at="O1 N10",
)
case(
    "a WHILE without its condition is P291",
    control=EVERY, source="MZ 865, P291 paired", evidence="inferred",
    program="""
        O1
        N10 WHILE DO1
        N20 END1
        N30 M30
    """,
    runs="", alarm="while-format", number="P291", at="O1 N10",
)
case(
    "27 loops inside each other are legal",
    pins="max_loops",
    control=EVERY, source="MZ 867", evidence="secondary",
    program="O1\n" + loops(27, "N90 S1\n") + "N99 M30\n",
    runs=" ".join(f"N{k}" for k in range(1, 28)) + " N90 "
    + " ".join(f"N{k}" for k in range(27, 0, -1)) + " N99",
)
case(
    "a 28th loop inside is P293",
    control=EVERY, source="MZ 867, P293 paired", evidence="inferred",
    program="O1\n" + loops(28, "N90 S1\n") + "N99 M30\n",
    runs=" ".join(f"N{k}" for k in range(1, 28)), alarm="loops-too-deep", number="P293",
    at="O1 N28",
)
case(
    "loops that are open in the caller count with those of the subprogram",
    pins="loops_count_across_calls",
    control=EVERY, source="general knowledge, 27 over the calling chain", evidence="inferred",
    program="O1\n" + loops(27, "N90 M98 P200\n") + "N99 M30\n"
    "O200\nN210 WHILE[#150 LT 1]DO1\n#150=1\nN220 END1\nN230 M99\n",
    runs=" ".join(f"N{k}" for k in range(1, 28)) + " N90", alarm="loops-too-deep",
    number="P293", at="O200 N210",
)
case(
    "the same DO number may be used again after its END",
    control=EVERY, source="general knowledge, DO", evidence="inferred",
    program="""
        O1
        N10 WHILE[#1 LT 1]DO1
        N20 #1=1
        N30 END1
        N40 WHILE[#2 LT 1]DO1
        N50 #2=1
        N60 END1
        N70 M30
    """,
    runs="N10 N20 N30 N10 N40 N50 N60 N40 N70",
)
case(
    "a subprogram inside a loop may use the loop's number",
    control=EVERY, source="general knowledge, DO", evidence="inferred",
    program="""
        O1
        N10 WHILE[#1 LT 2]DO1
        N20 M98 P200
        N30 #1=#1+1
        N40 END1
        N50 M30
        O200
        N205 #2=0
        N210 WHILE[#2 LT 1]DO1
        N220 #2=1
        N230 END1
        N240 M99
    """,
    runs="(N10 N20 N205 N210 N220 N230 N210 N240 N30 N40)*2 N10 N50",
)
