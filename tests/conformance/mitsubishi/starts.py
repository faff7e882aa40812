"""Mitsubishi: where a call or a run starts, H of M98, N, block skip."""

from conformance import case

case(
    "H200 starts the subprogram at N200 (MIT-003)",
    pins="whole_numbers",
    control="mitsubishi-m700",
    source="source 004, H",
    evidence="source document",
    program="""
        O1
        M98 P2 H200
        G0 X2
        M30
        O2
        G0 X10
        N100 G0 X11
        N200 G0 X12
        M99
    """,
    moves_x=[12, 2],
)

case(
    "with H and L every repetition starts at N200 (MIT-004)",
    control="mitsubishi-m700",
    source="source 004, H and L; restart at H: general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        M98 P2 H200 L2
        G0 X2
        M30
        O2
        G0 X10
        N200 G0 X12
        M99
    """,
    moves_x=[12, 12, 2],
)

MELDAS = "mitsubishi-meldas"
M700 = "mitsubishi-m700"
M800 = "mitsubishi-m800"
EVERY = [MELDAS, M700, M800]

# H: the block to start at

case(
    "H names the block of the called program where it starts",
    control=EVERY, source="source 004, H", evidence="source document",
    program="""
        O1
        N10 M98 P200 H230
        N20 M30
        O200
        N210 S1
        N220 S2
        N230 S3
        N240 M99
    """,
    runs="N10 N230 N240 N20", calls="M98:O200",
)
case(
    "an omitted H starts at the first block",
    control=EVERY, source="source 004, H omitted", evidence="source document",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N230 S1
        N210 S2
        N240 M99
    """,
    runs="N10 N230 N210 N240 N20",
)
case(
    "an H that the called program does not have is P231",
    control=EVERY, source="source 004, note 2", evidence="source document",
    program="""
        O1
        N10 S1
        N20 M98 P200 H300
        N30 M30
        O200
        N210 S2
        N220 M99
    """,
    runs="N10", alarm="start-not-found", number="P231", at="O1 N20", word="H300",
)
case(
    "H is searched in the called program and not in the caller",
    control=EVERY, source="source 004, H and note 2", evidence="source document",
    program="""
        O1
        N10 M98 P200 H20
        N20 M30
        O200
        N210 M99
    """,
    runs="", alarm="start-not-found", number="P231", at="O1 N10", word="H20",
)
case(
    "the words beside an H that is missing have run when P231 comes",
    control=EVERY, source="SM, differences of M98 and G65 (3)", evidence="inferred",
    program="""
        O1
        N10 T8 M98 P200 H300
        N20 M30
        O200
        N210 M99
    """,
    runs="N10", t=[8], alarm="start-not-found", number="P231", at="O1 N10", word="H300",
)
case(
    "every repeat starts at H again",
    control=[MELDAS, M800], source="source 004, H and L; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P200 H220 L3
        N20 M30
        O200
        N210 S1
        N220 S2
        N230 M99
    """,
    runs="N10 (N220 N230)*3 N20",
)
case(
    "H compares the number and not its digits",
    control=EVERY, source="general knowledge, N0100 is N100", evidence="inferred",
    program="""
        O1
        N10 M98 P200 H0220
        N20 M98 P300 H330
        N30 M30
        O200
        N210 S1
        N220 M99
        O300
        N310 S1
        N00330 M99
    """,
    runs="N10 N220 N20 N330 N30",
)
case(
    "of two blocks with the number of H the first one counts",
    control=EVERY, source="general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P200 H220
        N20 M30
        O200
        N210 S1
        N220 S2
        N230 S3
        N220 S4
        N240 M99
    """,
    runs="N10 N220 N230 N220 N240 N20",
)
case(
    "H99999 is a sequence number like any other",
    control=EVERY, source="IMD, H 1 to 99999", evidence="secondary",
    program="""
        O1
        N10 M98 P200 H99999
        N20 M30
        O200
        N210 S1
        N99999 M99
    """,
    runs="N10 N99999 N20",
)
case(
    "an H of six digits is over the range of the MELDAS",
    control=MELDAS, source="IMD, H 1 to 99999; SK P35", evidence="inferred",
    program="""
        O1
        N10 M98 P200 H100000
        N20 M30
        O200
        N210 M99
    """,
    runs="", alarm="illegal-sequence-number", number="P35", at="O1 N10", word="H100000",
)
case(
    "Q starts nothing on a Mitsubishi, the call begins at the head",
    control=[MELDAS, M800], source="IMD, Q", evidence="secondary",
    program="""
        O1
        N10 M98 P200 Q220
        N20 M30
        O200
        N210 S1
        N220 M99
    """,
    runs="N10 N210 N220 N20",
)
case(
    "a Q that names no block raises nothing",
    control=EVERY, source="IMD, Q", evidence="secondary",
    program="""
        O1
        N10 M98 P200 Q777
        N20 M30
        O200
        N220 M99
    """,
    runs="N10 N220 N20",
)
case(
    "Q beside a missing program does not save the call",
    control=EVERY, source="IMD, Q; source 004, note 1", evidence="inferred",
    program="""
        O1
        N10 M98 P200 Q10
        N20 M30
    """,
    runs="", alarm="program-not-found", number="P232", at="O1 N10", word="P200",
)

# Block skip and start

case(
    "a skipped M98 calls nothing, whatever it names",
    control=EVERY, source="general knowledge", evidence="inferred",
    program="""
        O1
        N10 S1
        /2 N20 M98 P999
        N30 M30
    """,
    skip=(2,), runs="N10 N30", calls="",
)
case(
    "a call after a block skip whose switch is off is made",
    control=EVERY, source="general knowledge; source 004, note 1", evidence="inferred",
    program="""
        O1
        N10 S1
        /2 N20 M98 P999
        N30 M30
    """,
    skip=(1,), runs="N10", alarm="program-not-found", number="P232", at="O1 N20", word="P999",
)
case(
    "a run that starts at a sequence number makes only the calls after it",
    control=EVERY, source="general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P999
        N20 M98 P200
        N30 M30
        O200
        N210 M99
    """,
    start=20, runs="N20 N210 N30", calls="M98:O200",
)
