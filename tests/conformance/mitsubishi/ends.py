"""Mitsubishi: ends of programs."""

from conformance import case

case(
    "M30 in a subprogram ends the run on the M700 (MIT-022)",
    pins="end_in_subprogram",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        M98 P2
        G0 X2
        M30
        O2
        G0 X10
        M30
    """,
    moves_x=[10],
)

MELDAS = "mitsubishi-meldas"
M700 = "mitsubishi-m700"
M800 = "mitsubishi-m800"
EVERY = [MELDAS, M700, M800]

case(
    "M30 inside a Mitsubishi subprogram ends the whole run",
    control=[MELDAS, M800], source="general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P200 L3
        N20 M30
        O200
        N210 S1
        N220 M30
    """,
    runs="N10 N210 N220",
)
case(
    "M02 inside a Mitsubishi subprogram ends the whole run",
    control=EVERY, source="general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 M02
    """,
    runs="N10 N210",
)
case(
    "a Mitsubishi main program without M02, M30 or M99 is P36",
    pins="missing_end",
    control=EVERY, source="SK P36", evidence="secondary",
    program="""
        O1
        N10 S1
        N20 S2
    """,
    runs="N10 N20", alarm="end-of-record", number="P36",
)
case(
    "a Mitsubishi subprogram without M99 is P36 and does not run on into the next program",
    control=[MELDAS, M800], source="SK P36; MZ 810", evidence="secondary",
    program="""
        O1
        N10 M98 P200
        N20 M30
        O200
        N210 S1
        O300
        N310 M99
    """,
    runs="N10 N210", alarm="end-of-record", number="P36",
)
case(
    "a program that ends in a call and nothing else is P36 after the return",
    control=EVERY, source="SK P36", evidence="secondary",
    program="""
        O1
        N10 M98 P200
        O200
        N210 M99
    """,
    runs="N10 N210", alarm="end-of-record", number="P36",
)
