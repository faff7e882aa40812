"""Huazhong HNC-21M: calls with arguments, and locals by level."""

from conformance import case

case(
    "M98 puts A, B and X of its block into #0, #1 and #23 (HNC-002)",
    pins="whole_numbers call_passes_words",
    control="hnc-21m",
    source="general knowledge of the Century Star manuals",
    evidence="inferred",
    program="""
        %1
        G00
        M98 P2 A11 B12 X50
        M30
        %2
        G01 X[#0] F100
        G01 X[#1]
        G01 X[#23]
        M99
    """,
    arguments={0: 11, 1: 12, 23: 50},
    moves_x=[50, 11, 12, 50],
)

case(
    "a subprogram of the HNC-21 has locals of its own (HNC-010)",
    control="hnc-21m",
    source="H9",
    evidence="secondary",
    program="""
        %1
        #10=5
        M98 P2
        G0 X[#10]
        M30
        %2
        #10=9
        M99
    """,
    moves_x=[5],
)

case(
    "#210 is #10 of the main program (HNC-011)",
    control="hnc-21m",
    source="H9",
    evidence="secondary",
    program="""
        %1
        #10=98
        M98 P2
        M30
        %2
        G0 X[#210]
        M99
    """,
    moves_x=[98],
)

HNC = "hnc-21m"

# Arguments

case(
    "HNC: A B C D of the M98 block are #0 to #3 of the subprogram",
    control=HNC, source="general knowledge, A to Z become #0 to #25", evidence="inferred",
    program="""
        %1
        N10 G0 M98 P2 A11 B12 C13 D14
        N20 M30
        %2
        N200 #100=#0
        N201 #101=#1
        N202 #102=#2
        N203 #103=#3
        N299 M99
    """,
    runs="N10 N200 N201 N202 N203 N299 N20", vars={100: 11, 101: 12, 102: 13, 103: 14},
)
case(
    "HNC: I J K of the M98 block are #8 to #10 of the subprogram",
    pins="call_words_not_computed",
    control=HNC, source="general knowledge, A to Z become #0 to #25", evidence="inferred",
    program="""
        %1
        N10 G0 M98 P2 I11 J12 K13
        N20 M30
        %2
        N208 #108=#8
        N209 #109=#9
        N210 #110=#10
        N299 M99
    """,
    runs="N10 N208 N209 N210 N299 N20", vars={108: 11, 109: 12, 110: 13},
)
case(
    "HNC: Q R U V W of the M98 block are #16 to #22 of the subprogram",
    control=HNC, source="general knowledge, A to Z become #0 to #25", evidence="inferred",
    program="""
        %1
        N10 G0 M98 P2 Q11 R12 U13 V14 W15
        N20 M30
        %2
        N216 #116=#16
        N217 #117=#17
        N220 #120=#20
        N221 #121=#21
        N222 #122=#22
        N299 M99
    """,
    runs="N10 N216 N217 N220 N221 N222 N299 N20",
    vars={116: 11, 117: 12, 120: 13, 121: 14, 122: 15},
)
case(
    "HNC: X Y Z of the M98 block are #23 to #25 of the subprogram",
    control=HNC, source="general knowledge, A to Z become #0 to #25", evidence="inferred",
    program="""
        %1
        N10 G0 M98 P2 X11 Y12 Z13
        N20 M30
        %2
        N223 #123=#23
        N224 #124=#24
        N225 #125=#25
        N299 M99
    """,
    runs="N10 N223 N224 N225 N299 N20", vars={123: 11, 124: 12, 125: 13},
)
case(
    "HNC: an argument may be an expression of the caller's variables",
    control=HNC, source="general knowledge, A to Z become #0 to #25; HD", evidence="inferred",
    program="""
        %1
        N10 #5=4
        N20 M98 P2 D[#5*2]
        N30 M30
        %2
        N40 #50=#3
        N50 M99
    """,
    runs="N10 N20 N40 N50 N30", vars={50: 8, 5: 4},
)
case(
    "HNC: a word that was not written counts as zero in the subprogram",
    control=HNC, source="general knowledge, absent words", evidence="inferred",
    program="""
        %1
        N10 #2=9
        N20 M98 P2 D1
        N30 M30
        %2
        N40 #50=#2+1
        N50 M99
    """,
    runs="N10 N20 N40 N50 N30", vars={50: 1},
)
case(
    "HNC: AR of a word that was not written is 0",
    control=HNC, source="general knowledge, AR[#n]", evidence="inferred",
    program="""
        %1
        N10 G0 G90
        N20 M98 P2 X5
        N30 M30
        %2
        N40 #50=AR[#24]
        N50 M99
    """,
    runs="N10 N20 N40 N50 N30", vars={50: 0},
)
case(
    "HNC: AR of a word written under G90 is 90",
    control=HNC, source="general knowledge, AR[#n]", evidence="inferred",
    program="""
        %1
        N10 G0 G90
        N20 M98 P2 X5
        N30 M30
        %2
        N40 #50=AR[#23]
        N50 M99
    """,
    runs="N10 N20 N40 N50 N30", vars={50: 90},
)
case(
    "HNC: AR of a word written under G91 is 91",
    control=HNC, source="general knowledge, AR[#n]", evidence="inferred",
    program="""
        %1
        N10 G0 G91
        N20 M98 P2 X5
        N30 M30
        %2
        N40 #50=AR[#23]
        N50 M99
    """,
    runs="N10 N20 N40 N50 N30", vars={50: 91},
)

# Locals by level

case(
    "HNC: each level has its own locals and the caller's come back",
    control=HNC, source="H9, nested locals", evidence="secondary",
    program="""
        %1
        N10 #30=5
        N20 #49=6
        N30 M98 P2
        N40 M30
        %2
        N50 #49=99
        N60 M99
    """,
    runs="N10 N20 N30 N50 N60 N40", vars={49: 6},
)
case(
    "HNC: #50 is the first variable that all levels share",
    control=HNC, source="H9, #50 to #199 global", evidence="secondary",
    program="""
        %1
        N10 #49=1
        N20 #50=1
        N30 M98 P2
        N40 M30
        %2
        N50 #49=7
        N60 #50=7
        N70 #199=8
        N80 M99
    """,
    runs="N10 N20 N30 N50 N60 N70 N80 N40", vars={49: 1, 50: 7, 199: 8},
)
case(
    "HNC: #2nn is the image of #nn of the main program",
    control=HNC, source="H9, level 0 is #200 to #249", evidence="secondary",
    program="""
        %1
        N10 #45=7
        N20 M98 P2
        N30 M30
        %2
        N40 #45=1
        N50 #50=#245
        N60 M99
    """,
    runs="N10 N20 N40 N50 N60 N30", vars={50: 7},
)
case(
    "HNC: the image of level 1 starts at #250",
    control=HNC, source="H9, level 1 is #250 to #299", evidence="secondary",
    program="""
        %1
        N10 M98 P2
        N20 M30
        %2
        N30 #40=8
        N40 M98 P3
        N50 M99
        %3
        N60 #50=#290
        N70 M99
    """,
    runs="N10 N30 N40 N60 N70 N50 N20", vars={50: 8},
)
case(
    "HNC: a level reads itself through its own image",
    control=HNC, source="H9, the images of the levels", evidence="inferred",
    program="""
        %1
        N10 #40=6
        N20 #50=#240
        N30 M30
    """,
    runs="N10 N20 N30", vars={50: 6},
)
case(
    "HNC: two levels down the main program is still #200 to #249",
    control=HNC, source="H9, level 0 is #200 to #249", evidence="secondary",
    program="""
        %1
        N10 #40=6
        N20 M98 P2
        N30 M30
        %2
        N40 M98 P3
        N50 M99
        %3
        N60 #50=#240
        N70 M99
    """,
    runs="N10 N20 N40 N60 N70 N50 N30", vars={50: 6},
)
case(
    "HNC: there is no variable #900",
    control=HNC, source="H9, user range #0 to #899", evidence="inferred",
    program="""
        %1
        N10 #899=1
        N20 #900=1
        N30 M30
    """,
    runs="N10", alarm="illegal-variable", number=None, at="%1 N20",
)
