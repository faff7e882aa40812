"""Mitsubishi: M99."""

from conformance import case

case(
    "M99 P300 goes on at N300 of the caller (MIT-013)",
    control="mitsubishi-m700",
    source="source 004, M99 P",
    evidence="source document",
    program="""
        O1
        M98 P2
        G0 X2
        N300 G0 X3
        M30
        O2
        G0 X10
        M99 P300
    """,
    moves_x=[10, 3],
)

case(
    "M99 P300 alarms where the caller has no N300 (MIT-014)",
    control="mitsubishi-m700",
    source="source 004, P231",
    evidence="source document",
    program="""
        O1
        M98 P2
        G0 X2
        M30
        O2
        G0 X10
        M99 P300
    """,
    moves_x=[10],
    alarm="return-target-not-found",
    number="P231",
    at="O2",
)

MELDAS = "mitsubishi-meldas"
M700 = "mitsubishi-m700"
M800 = "mitsubishi-m800"
EVERY = [MELDAS, M700, M800]

case(
    "M99 P returns to the named block of the caller, over the blocks between",
    control=[MELDAS, M800], source="source 004, M99 P", evidence="source document",
    program="""
        O1
        N10 M98 P200
        N20 S2
        N30 S3
        N40 M30
        O200
        N210 M99 P40
    """,
    runs="N10 N210 N40",
)
case(
    "M99 P may name a block in front of the call",
    control=EVERY, source="source 004, M99 P", evidence="source document",
    program="""
        O1
        N10 S1
        N20 M98 P200
        N30 M30
        O200
        N210 M99 P10
    """,
    max_blocks=7, runs="N10 (N20 N210 N10)*2", stop="limit",
)
case(
    "M99 P of a block the caller does not have is P231",
    control=[MELDAS, M800], source="source 004, M99 note 1", evidence="source document",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 S1
        N220 M99 P77
    """,
    runs="N10 N210", alarm="return-target-not-found", number="P231", at="O200 N220", word="P77",
)
case(
    "M99 P does not find a block of the subprogram itself",
    control=EVERY, source="source 004, M99 P", evidence="source document",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 S1
        N220 M99 P210
    """,
    runs="N10 N210", alarm="return-target-not-found", number="P231", at="O200 N220", word="P210",
)
case(
    "M99 P searches the immediate caller and not the program below it",
    control=EVERY, source="source 004, M99 P; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N50 M30
        O200
        N210 M98 P300
        N220 M99
        O300
        N310 M99 P50
    """,
    runs="N10 N210", alarm="return-target-not-found", number="P231", at="O300 N310", word="P50",
)
case(
    "the words beside an M99 P that finds nothing have run",
    control=EVERY, source="source 004, M99 note 1; SM (3)", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 T9 M99 P77
    """,
    runs="N10 N210", t=[9], alarm="return-target-not-found", number="P231", at="O200 N210",
    word="P77",
)
case(
    "the words beside M99 run before the return",
    control=EVERY, source="general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 T2
        N30 M30
        O200
        N210 T1 M99
    """,
    runs="N10 N210 N20 N30", t=[1, 2],
)
case(
    "of two blocks with the number of M99 P the first of the caller counts",
    control=EVERY, source="no source: engine decision", evidence="inferred",
    program="""
        O1
        N10 M98 H30 P1
        N20 M30
        N30 S3
        N40 M98 P200
        N50 S5
        N20 S6
        N60 M99
        O200
        N210 M99 P20
    """,
    runs="N10 N30 N40 N210 N20",
)
case(
    "M99 P takes effect on the last repeat only",
    control=EVERY, source="no source: engine decision", evidence="inferred",
    program="""
        O1
        N10 M98 P200 L3
        N20 S2
        N30 M30
        O200
        N210 M99 P30
    """,
    runs="N10 N210*3 N30", calls="M98:O200",
)
case(
    "an M99 P that finds nothing raises P231 on the last repeat",
    control=EVERY, source="source 004, M99 note 1; no source for repeats", evidence="inferred",
    program="""
        O1
        N10 M98 P200 L3
        N30 M30
        O200
        N210 S1
        N220 M99 P77
    """,
    runs="N10 N210 N220 N210 N220 N210", alarm="return-target-not-found", number="P231",
    at="O200 N220", word="P77",
)
case(
    "M99 P compares the number and not its digits",
    control=EVERY, source="general knowledge, N0100 is N100", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 S2
        N0040 M30
        O200
        N210 M99 P00040
    """,
    runs="N10 N210 N40",
)
case(
    "M99 P from a variable returns to the block of its value",
    control=EVERY, source="general knowledge, P#100", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 S2
        N40 M30
        O200
        N210 M99 P#100
    """,
    variables={100: 40}, runs="N10 N210 N40",
)
case(
    "M99 P from a vacant variable returns after the call",
    control=EVERY, source="general knowledge, vacant means word absent", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 S2
        N40 M30
        O200
        N210 M99 P#100
    """,
    variables={100: None}, runs="N10 N210 N20 N40",
)
case(
    "M99 in a main program starts it over without end",
    pins="main_return",
    control=EVERY, source="source 004, M99 in the main program", evidence="source document",
    program="""
        O1
        N10 S1
        N20 M99
    """,
    max_cycles=100, max_blocks=5, runs="(N10 N20)*2 N10", stop="limit",
)
case(
    "one cycle of a Mitsubishi main program ends with its M99",
    control=EVERY, source="source 004, M99 in the main program", evidence="source document",
    program="""
        O1
        N10 T1
        N20 M99
        N30 M30
    """,
    max_cycles=2, runs="(N10 N20)*2", t=[1, 1], stop="cycles",
)
case(
    "M99 P in a main program jumps to the block of the main program",
    control=EVERY, source="source 004, M99 P in the main program", evidence="source document",
    program="""
        O1
        N10 S1
        N20 M99 P40
        N30 S3
        N40 M30
    """,
    max_cycles=9, runs="N10 N20 N40",
)
case(
    "M99 P back to a block of the main program spins there",
    control=EVERY, source="source 004, M99 P in the main program", evidence="source document",
    program="""
        O1
        N10 S1
        N20 S2
        N30 M99 P20
    """,
    max_cycles=100, max_blocks=7, runs="N10 (N20 N30)*3", stop="limit",
)
case(
    "M99 P of a missing block in a main program is P231",
    control=EVERY, source="source 004, M99 note 1", evidence="source document",
    program="""
        O1
        N10 S1
        N20 M99 P77
        N30 M30
    """,
    runs="N10", alarm="return-target-not-found", number="P231", at="O1 N20", word="P77",
)
case(
    "a skipped M99 lets the main program reach its M30",
    control=EVERY, source="source 004, M99 in the main program; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 S1
        /N20 M99
        N30 M30
    """,
    skip=(1,), runs="N10 N30",
)
case(
    "a subprogram that is run as the main program loops at its M99",
    control=EVERY, source="source 004, M99 in the main program", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 S1
        N220 M99
    """,
    main="O200", max_cycles=2, runs="(N210 N220)*2", stop="cycles", calls="",
)
case(
    "a Mitsubishi M99 L0 returns at once whatever repeats are left",
    pins="return_with_l",
    control=EVERY, source="OB, M99 L; engine decision", evidence="inferred",
    program="""
        O1
        N10 M98 P200 L5
        N20 M30
        O200
        N210 M99 L0
    """,
    runs="N10 N210 N20",
)
case(
    "M99 L2 leaves two repeats to run",
    control=EVERY, source="OB, M99 L; engine decision", evidence="inferred",
    program="""
        O1
        N10 M98 P200 L9
        N20 M30
        O200
        N210 IF[#100 EQ 1]GOTO240
        N220 #100=1
        N230 M99 L2
        N240 M99
    """,
    variables={100: 0}, runs="N10 N210 N220 N230 (N210 N240)*2 N20",
)
case(
    "M99 L1 on every pass never lets the call end",
    control=EVERY, source="OB, M99 L; engine decision", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 M99 L1
    """,
    max_blocks=6, runs="N10 N210*5", stop="limit",
)
