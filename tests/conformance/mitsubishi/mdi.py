"""Mitsubishi: calls in MDI."""

from conformance import case

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


case(
    "a Mitsubishi calls a program of the memory from MDI",
    control=EVERY, source="general knowledge", evidence="inferred",
    program="""
        O200
        N210 S1
        N220 M99
    """,
    mdi="N10 M98 P200 L2\nN20 M30", runs="N10 (N210 N220)*2 N20", calls="M98:O200",
)
case(
    "a call in MDI of a program that is missing is P232",
    control=EVERY, source="source 004, note 1", evidence="inferred",
    program="""
        O200
        N210 M99
    """,
    mdi="N10 M98 P300", runs="", alarm="program-not-found", number="P232", word="P300",
)
case(
    "from the M700 on an M98 H in MDI calls the MDI text itself",
    control=NEWER, source="IMD, P omitted: memory and MDI", evidence="secondary",
    program="""
        O200
        N210 M99
    """,
    mdi="N10 M98 H30\nN20 M30\nN30 S3\nN40 M99", runs="N10 N30 N40 N20",
)
case(
    "M99 in MDI goes back to the head of the MDI text",
    control=EVERY, source="general knowledge", evidence="inferred",
    program="""
        O200
        N210 M99
    """,
    mdi="N10 S1\nN20 M99", max_cycles=2, runs="(N10 N20)*2", stop="cycles",
)
case(
    "MELDAS: calls from MDI nest to four levels too",
    control=MELDAS, source="source 004, note on levels", evidence="inferred",
    program=chain(5), mdi="N10 M98 P2", runs="N10 N2 N3 N4",
    alarm="nesting-too-deep", number="P230", at="O5 N5",
)
