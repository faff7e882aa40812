"""Mitsubishi: M98 without P, a jump of the MELDAS, a call of the newer ones."""

from conformance import case

case(
    "M98 H100 without a P calls its own program on the M700, and M99 returns after it (MIT-009)",
    pins="omitted_program",
    control="mitsubishi-m700",
    source="IMD, P omitted; general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        G0 X1
        M98 H100
        G0 X2
        M30
        N100 G0 X20
        M99
    """,
    moves_x=[1, 20, 2],
)

case(
    "M98 H100 L3 calls the part of its own program three times (MIT-010)",
    control="mitsubishi-m700",
    source="IMD, P omitted; general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        G0 X1
        M98 H100 L3
        G0 X2
        M30
        N100 G0 X20
        M99
    """,
    moves_x=[1, 20, 20, 20, 2],
)

case(
    "a bare M98 jumps to the head of its program on the MELDAS of source 004 (MIT-012)",
    pins="whole_numbers omitted_program",
    control="mitsubishi-meldas",
    source="source 004, P, H and L omitted",
    evidence="source document",
    program="""
        O1
        G0 X1
        M98
        M30
    """,
    max_cycles=6,
    moves_x=[1, 1, 1, 1, 1, 1],
    stop="cycles",
)

MELDAS = "mitsubishi-meldas"
M700 = "mitsubishi-m700"
M800 = "mitsubishi-m800"
NEWER = [M700, M800]
EVERY = [MELDAS, M700, M800]


def chain(levels, call="M98 P{}"):
    """Return a main program O1 from which `levels` calls are open at once.

    Program Ok calls in block Nk and returns in block N(100+k).
    """
    text = f"O1\nN1 {call.format(2)}\nN101 M30\n"
    for k in range(2, levels + 1):
        text += f"O{k}\nN{k} {call.format(k + 1)}\nN{100 + k} M99\n"
    last = levels + 1
    return text + f"O{last}\nN{last} S{last}\nN{100 + last} M99\n"


def way_in(levels):
    return " ".join(f"N{k}" for k in range(1, levels + 1))


def way_in_and_out(levels):
    out = " ".join(f"N{100 + k}" for k in range(levels + 1, 0, -1))
    return f"{way_in(levels + 1)} {out}"


# P omitted: MELDAS jumps

case(
    "MELDAS: M98 H without P jumps in its own program and calls nothing",
    control=MELDAS, source="source 004, P omitted", evidence="source document",
    program="""
        O1
        N10 M98 H40
        N20 S2
        N30 S3
        N40 S4
        N50 M30
    """,
    runs="N10 N40 N50", calls="",
)
case(
    "MELDAS: L has no effect on an M98 that jumps",
    control=MELDAS, source="source 004, P omitted", evidence="inferred",
    program="""
        O1
        N10 M98 H40 L3
        N20 S2
        N40 S4
        N50 M30
    """,
    runs="N10 N40 N50", calls="",
)
case(
    "MELDAS: no frame is open after an M98 that jumps, so M99 starts the main program over",
    pins="main_return",
    control=MELDAS, source="source 004, P omitted", evidence="inferred",
    program="""
        O1
        N10 M98 H40
        N20 M30
        N40 S4
        N50 M99
    """,
    max_cycles=1, runs="N10 N40 N50", stop="cycles", calls="",
)
case(
    "MELDAS: M98 H may jump back and spin for ever",
    control=MELDAS, source="source 004, P omitted", evidence="source document",
    program="""
        O1
        N10 S1
        N20 S2
        N30 M98 H20
        N40 M30
    """,
    max_cycles=100, max_blocks=7, runs="N10 (N20 N30)*3", stop="limit",
)
case(
    "MELDAS: an M98 H that finds no block is P231",
    control=MELDAS, source="source 004, note 2", evidence="source document",
    program="""
        O1
        N10 M98 H40
        N20 M30
    """,
    runs="", alarm="start-not-found", number="P231", at="O1 N10", word="H40",
)
case(
    "MELDAS: M98 H in a subprogram jumps in the subprogram",
    control=MELDAS, source="source 004, P omitted", evidence="source document",
    program="""
        O1
        N10 M98 P200
        N20 S1
        N40 M30
        O200
        N210 M98 H40
        N30 S2
        N40 M99
    """,
    runs="O1:N10 O200:N210 O200:N40 O1:N20 O1:N40", calls="M98:O200",
)
case(
    "MELDAS: M98 H in a subprogram does not find a block of the main program",
    control=MELDAS, source="source 004, P omitted and note 2", evidence="source document",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 M98 H20
        N220 M99
    """,
    runs="N10", alarm="start-not-found", number="P231", at="O200 N210", word="H20",
)
case(
    "MELDAS: an M98 that jumps needs no level",
    control=MELDAS, source="source 004, P omitted and note on levels", evidence="inferred",
    program=chain(4).replace("N5 S5", "N5 M98 H105\nN6 S6"),
    runs=way_in_and_out(4),
)
case(
    "MELDAS: M98 without P, H and L starts the program over",
    control=MELDAS, source="source 004, P, H and L omitted", evidence="source document",
    program="""
        O1
        N10 S1
        N20 M98
        N30 M30
    """,
    max_cycles=3, runs="(N10 N20)*3", stop="cycles", calls="",
)
case(
    "MELDAS: one pass of a program that ends in a bare M98 is one cycle",
    control=MELDAS, source="source 004, P, H and L omitted", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 M98
    """,
    max_cycles=1, runs="N10 N20", t=[1], stop="cycles",
)
case(
    "MELDAS: a bare M98 in a subprogram goes back to the subprogram's head",
    control=MELDAS, source="source 004, P, H and L omitted", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 S1
        N220 M98
        N230 M99
    """,
    max_cycles=100, max_blocks=7, runs="N10 (N210 N220)*3", stop="limit", calls="M98:O200",
)
case(
    "MELDAS: a bare M98 after a block skip that is on does nothing",
    control=MELDAS, source="source 004, P, H and L omitted", evidence="inferred",
    program="""
        O1
        N10 S1
        /N20 M98
        N30 M30
    """,
    skip=(1,), runs="N10 N30",
)
case(
    "MELDAS: L0 also stops a jump of M98 H",
    control=MELDAS, source="source 004, note 3", evidence="source document",
    program="""
        O1
        N10 M98 H40 L0
        N20 S2
        N40 M30
    """,
    runs="N10 N20 N40",
)
case(
    "MELDAS: L0 also stops a bare M98 from starting over",
    control=MELDAS, source="source 004, note 3", evidence="source document",
    program="""
        O1
        N10 M98 L0
        N20 M30
    """,
    runs="N10 N20",
)
case(
    "MELDAS: words beside an M98 that jumps run first",
    control=MELDAS, source="source 004, P omitted; SM (3)", evidence="inferred",
    program="""
        O1
        N10 T3 M98 H40
        N20 T4
        N40 M30
    """,
    runs="N10 N40", t=[3],
)
case(
    "MELDAS: a vacant P is an omitted P and jumps",
    control=MELDAS, source="source 004, P omitted; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P#100 H40
        N20 S2
        N40 M30
    """,
    variables={100: None}, runs="N10 N40", calls="",
)

# P omitted: the newer ones call

case(
    "from the M700 on M98 H without P calls its own program and M99 comes back",
    pins="omitted_program",
    control=NEWER, source="IMD, P omitted", evidence="secondary",
    program="""
        O1
        N10 S1
        N20 M98 H50
        N30 S3
        N40 M30
        N50 S5
        N60 M99
    """,
    runs="N10 N20 N50 N60 N30 N40", calls="M98:O1",
)
case(
    "from the M700 on L repeats the part that M98 H calls",
    control=NEWER, source="IMD, P omitted", evidence="secondary",
    program="""
        O1
        N20 M98 H50 L4
        N40 M30
        N50 S5
        N60 M99
    """,
    runs="N20 (N50 N60)*4 N40", calls="M98:O1",
)
case(
    "from the M700 on an M98 H that finds no block is P231",
    control=NEWER, source="source 004, note 2; IMD", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 M98 H50
        N40 M30
    """,
    runs="N10", alarm="start-not-found", number="P231", at="O1 N20", word="H50",
)
case(
    "from the M700 on M98 H in a subprogram calls the subprogram",
    control=NEWER, source="IMD, P omitted", evidence="secondary",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 M98 H230
        N220 M99
        N230 S3
        N240 M99
    """,
    runs="N10 N210 N230 N240 N220 N20", calls="M98:O200 M98:O200",
)
case(
    "from the M700 on M98 H in a subprogram does not find a block of the main program",
    control=NEWER, source="IMD, P omitted; source 004, note 2", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 M98 H20
        N220 M99
    """,
    runs="N10", alarm="start-not-found", number="P231", at="O200 N210", word="H20",
)
case(
    "M700: a bare M98 calls itself until P230",
    control=M700, source="IMD, P omitted; SM (6)", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 M98
        N30 M30
    """,
    runs="(N10 N20)*8 N10", alarm="nesting-too-deep", number="P230", at="O1 N20",
)
case(
    "M800: a bare M98 calls itself until P230, two levels later",
    control=M800, source="IMD, P omitted; CW", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 M98
        N30 M30
    """,
    runs="(N10 N20)*10 N10", alarm="nesting-too-deep", number="P230", at="O1 N20",
)
case(
    "M700: a program that calls its own number without H ends in P230",
    control=M700, source="general knowledge; SM (6)", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 M98 P200
        N220 M99
    """,
    runs="N10 N210*7", alarm="nesting-too-deep", number="P230", at="O200 N210",
)
case(
    "a program that calls its own number with H runs its part and comes back",
    pins="self_call",
    control=EVERY, source="source 004, P and H", evidence="inferred",
    program="""
        O1
        N10 M98 P1 H50
        N20 M30
        N50 S5
        N60 M99
    """,
    runs="N10 N50 N60 N20", calls="M98:O1",
)
case(
    "from the M700 on a vacant P is an omitted P and calls",
    control=NEWER, source="IMD, P omitted; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P#100 H40
        N20 M30
        N40 M99
    """,
    variables={100: None}, runs="N10 N40 N20", calls="M98:O1",
)
case(
    "from the M700 on L0 also stops a call of the own program",
    control=NEWER, source="source 004, note 3; IMD", evidence="inferred",
    program="""
        O1
        N10 M98 L0
        N20 M98 H50 L0
        N30 M30
    """,
    runs="N10 N20 N30", calls="",
)
