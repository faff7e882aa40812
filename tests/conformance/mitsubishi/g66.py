"""Mitsubishi: G66, G66.1, G67."""

from conformance import case

case(
    "G66 calls after each move, and neither in its own block nor after an M code (MIT-108)",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        G66 P2 A5
        G0 X1
        M8
        G0 X2
        G67
        G0 X3
        M30
        O2
        G0 X#1
        M99
    """,
    moves_x=[1, 5, 2, 5, 3],
)

MELDAS = "mitsubishi-meldas"
M700 = "mitsubishi-m700"
M800 = "mitsubishi-m800"
NEWER = [M700, M800]
EVERY = [MELDAS, M700, M800]

case(
    "the block of G66 itself calls nothing",
    control=EVERY, source="general knowledge, G66", evidence="inferred",
    program="""
        O1
        N10 G66 P200 A1.
        N20 G67
        N30 M30
        O200
        N210 M99
    """,
    runs="N10 N20 N30", calls="",
)
case(
    "under G66 every block that moves an axis is followed by the macro",
    control=EVERY, source="general knowledge, G66", evidence="inferred",
    program="""
        O1
        N10 G66 P200 A1.
        N20 G0 X5.
        N30 G0 Y5.
        N40 G67
        N50 M30
        O200
        N210 M99
    """,
    runs="N10 N20 N210 N30 N210 N40 N50", calls="G66:O200 G66:O200",
)
case(
    "under G66 blocks without a move call nothing",
    control=EVERY, source="general knowledge, G66", evidence="inferred",
    program="""
        O1
        N10 G66 P200
        N20 M8
        N30 S500
        N40 #100=1
        N50 G67
        N60 M30
        O200
        N210 M99
    """,
    runs="N10 N20 N30 N40 N50 N60", calls="",
)
case(
    "G66 L calls the macro L times after each move",
    control=EVERY, source="general knowledge, G66", evidence="inferred",
    program="""
        O1
        N10 G66 P200 L3
        N20 G0 X5.
        N30 G67
        N40 M30
        O200
        N210 M99
    """,
    runs="N10 N20 N210*3 N30 N40",
)
case(
    "the arguments of G66 arrive in its macro",
    control=EVERY, source="general knowledge, G66", evidence="inferred",
    program="""
        O1
        N10 G66 P200 B2.5
        N20 G0 X5.
        N30 G67
        N40 M30
        O200
        N210 #100=#2
        N220 M99
    """,
    runs="N10 N20 N210 N220 N30 N40", vars={100: 2.5},
)
case(
    "after G67 a move calls nothing",
    control=EVERY, source="general knowledge, G67", evidence="inferred",
    program="""
        O1
        N10 G66 P200
        N20 G67
        N30 G0 X5.
        N40 M30
        O200
        N210 M99
    """,
    runs="N10 N20 N30 N40", calls="",
)
case(
    "moves in a subprogram call the modal macro too",
    control=NEWER, source="general knowledge, G66", evidence="inferred",
    program="""
        O1
        N10 G66 P200
        N20 M98 P300
        N30 G67
        N40 M30
        O200
        N210 M99
        O300
        N310 G0 X5.
        N320 M99
    """,
    runs="N10 N20 N310 N210 N320 N30 N40",
)
case(
    "of two G66 the last is called after a move and its own moves call the first",
    control=NEWER, source="general knowledge, G66 nested", evidence="inferred",
    program="""
        O1
        N10 G66 P200
        N20 G66 P300
        N30 G0 X5.
        N40 G67
        N50 G67
        N60 M30
        O200
        N210 M99
        O300
        N310 G0 X7.
        N320 M99
    """,
    runs="N10 N20 N30 N310 N210 N320 N40 N50 N60",
)
case(
    "one G67 cancels the last G66 only",
    control=NEWER, source="general knowledge, G67", evidence="inferred",
    program="""
        O1
        N10 G66 P200
        N20 G66 P300
        N30 G67
        N40 G0 X5.
        N50 G67
        N60 M30
        O200
        N210 M99
        O300
        N310 M99
    """,
    runs="N10 N20 N30 N40 N210 N50 N60",
)
case(
    "G67 with no modal call is P276",
    control=EVERY, source="MZ 857, P276 paired", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 G67
        N30 M30
    """,
    runs="N10", alarm="modal-call-missing", number="P276", at="O1 N20",
)
case(
    "a second G67 for one G66 is P276",
    control=EVERY, source="MZ 857, P276 paired", evidence="inferred",
    program="""
        O1
        N10 G66 P200
        N20 G67
        N30 G67
        N40 M30
        O200
        N210 M99
    """,
    runs="N10 N20", alarm="modal-call-missing", number="P276", at="O1 N30",
)
case(
    "G66 without P is P296",
    control=EVERY, source="MZ 893, P296 paired", evidence="inferred",
    program="""
        O1
        N10 G66 A1.
        N20 G67
        N30 M30
    """,
    runs="", alarm="program-number-missing", number="P296", at="O1 N10",
)
case(
    "G66.1 without P is P296",
    control=EVERY, source="MZ 893, P296 paired", evidence="inferred",
    program="""
        O1
        N10 G66.1 A1.
        N20 G67
        N30 M30
    """,
    runs="", alarm="program-number-missing", number="P296", at="O1 N10",
)
case(
    "under G66.1 every block calls and its words are arguments",
    control=EVERY, source="general knowledge, G66.1", evidence="inferred",
    program="""
        O1
        N10 G66.1 P200
        N20 X5. F400
        N30 G67
        N40 M30
        O200
        N210 #100=#24
        N220 #101=#9
        N230 M99
    """,
    runs="N10 N20 N210 N220 N230 N30 N40", calls="G66.1:O200", vars={100: 5, 101: 400},
)
case(
    "under G66.1 an M code is an argument and not sent",
    control=EVERY, source="general knowledge, G66.1", evidence="inferred",
    program="""
        O1
        N10 G66.1 P200
        N20 M8
        N30 G67
        N40 M30
        O200
        N210 #100=#13
        N220 M99
    """,
    runs="N10 N20 N210 N220 N30 N40", m=[], vars={100: 8},
)
case(
    "only under G66.1 is G an argument: #10",
    control=EVERY, source="general knowledge, G66.1", evidence="inferred",
    program="""
        O1
        N10 G66.1 P200
        N20 G1 X5.
        N30 G67
        N40 M30
        O200
        N210 #100=#10
        N220 M99
    """,
    runs="N10 N20 N210 N220 N30 N40", vars={100: 1},
)
case(
    "a macro that is missing when a modal call is made is P232",
    control=EVERY, source="source 004, note 1", evidence="inferred",
    program="""
        O1
        N10 G66.1 P200
        N20 X5.
        N30 G67
        N40 M30
    """,
    runs=None, calls="", alarm="program-not-found", number="P232",
)
