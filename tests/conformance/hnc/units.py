"""Huazhong HNC-21M: units and comments."""

from conformance import case

case(
    "G22 counts X in pulses of a thousandth of a millimetre (HNC-012)",
    pins="g_meanings",
    control="hnc-21m",
    source="source 003, G20 G21 G22; the size of the pulse: general knowledge of the Century Star manuals",
    evidence="source document",
    program="""
        %1
        G22
        G01 X100 F100
        M30
    """,
    moves_x=[0.1],
)

HNC = "hnc-21m"

case(
    "HNC: G20 is the word for inch units and stops nothing",
    control=HNC, source="source 003, G20, G21, G22", evidence="source document",
    program="%1\nN10 G20\nN20 M98 P2\nN30 M30\n%2\nN40 M99",
    runs="N10 N20 N40 N30",
)
case(
    "HNC: G21 is the word for metric units and stops nothing",
    control=HNC, source="source 003, G20, G21, G22", evidence="source document",
    program="%1\nN10 G21\nN20 M98 P2\nN30 M30\n%2\nN40 M99",
    runs="N10 N20 N40 N30",
)
case(
    "HNC: G22 is the word for pulse units and stops nothing",
    control=HNC, source="source 003, G20, G21, G22", evidence="source document",
    program="%1\nN10 G22\nN20 M98 P2\nN30 M30\n%2\nN40 M99",
    runs="N10 N20 N40 N30",
)
case(
    "HNC: G94 and G95 choose the feed and stop nothing",
    control=HNC, source="source 003, G94, G95", evidence="source document",
    program="""
        %1
        N10 G94 F100
        N20 G95 F0.2
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "HNC: what stands after a semicolon is a comment",
    control=HNC, source="HD, comments", evidence="secondary",
    program="""
        %1 ; the main program
        N10 T1 ; T9 M98 P7
        ; N15 T2
        N20 M98 P2 ; L3
        N30 M30
        %2
        N40 M99
    """,
    runs="N10 N20 N40 N30", t=[1],
)
case(
    "HNC: what stands in parentheses is a comment",
    control=HNC, source="general knowledge, comments", evidence="inferred",
    program="""
        %1
        N10 T1 (T9) M8
        N20 M30
    """,
    runs="N10 N20", t=[1], m=[8],
)
case(
    "HNC: a block skip that is on leaves the call out",
    control=HNC, source="general knowledge, block skip", evidence="inferred",
    program="""
        %1
        N10 S1
        /N20 M98 P7
        N30 M30
    """,
    skip=(1,), runs="N10 N30", calls="",
)
case(
    "HNC: a block skip that is off leaves the call in",
    control=HNC, source="general knowledge, block skip", evidence="inferred",
    program="""
        %1
        N10 S1
        /N20 M98 P7
        N30 M30
    """,
    runs="N10", alarm="program-not-found", number=None, at="%1 N20", word="P7",
)
