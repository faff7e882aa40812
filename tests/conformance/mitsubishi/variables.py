"""Mitsubishi: variables, and vacant values."""

from conformance import case

case(
    "#3000=5 stops with P277 (MIT-123)",
    control="mitsubishi-m700",
    source="MZ 979, paired with P277",
    evidence="secondary",
    program="""
        O1
        G0 X1
        #3000=5(TEST)
        M30
    """,
    moves_x=[1],
    alarm="user-alarm",
    number="P277",
    at="O1",
)

case(
    "a vacant variable takes its word out of the block on the M700 (MIT-124)",
    control="mitsubishi-m700",
    source="general knowledge of the M700V manuals",
    evidence="inferred",
    program="""
        O1
        G0 X#1
        G0 X2
        M30
    """,
    moves_x=[2],
)

MELDAS = "mitsubishi-meldas"
M700 = "mitsubishi-m700"
M800 = "mitsubishi-m800"
EVERY = [MELDAS, M700, M800]

# Vacant

case(
    "a copy of a vacant variable is vacant",
    control=EVERY, source="general knowledge, vacant", evidence="inferred",
    program="""
        O1
        N10 #100=#5
        N20 M30
    """,
    variables={100: 4}, runs="N10 N20", vars={100: None},
)
case(
    "a vacant variable counts as zero in an expression",
    control=EVERY, source="general knowledge, vacant", evidence="inferred",
    program="""
        O1
        N10 #100=#5+2
        N20 #101=#5*2
        N30 M30
    """,
    runs="N10 N20 N30", vars={100: 2, 101: 0},
)
case(
    "with #5 vacant, #5 EQ #0 is true on a Mitsubishi",
    control=EVERY, source="general knowledge, vacant in comparisons", evidence="inferred",
    program="O1\nN10 IF[#5 EQ #0]GOTO30\nN20 S2\nN30 M30",
    runs="N10 N30",
)
case(
    "with #5 vacant, #5 EQ 0 is false on a Mitsubishi",
    control=EVERY, source="general knowledge, vacant in comparisons", evidence="inferred",
    program="O1\nN10 IF[#5 EQ 0]GOTO30\nN20 S2\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "with #5 vacant, #5 NE #0 is false on a Mitsubishi",
    control=EVERY, source="general knowledge, vacant in comparisons", evidence="inferred",
    program="O1\nN10 IF[#5 NE #0]GOTO30\nN20 S2\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "with #5 vacant, #5 NE 0 is true on a Mitsubishi",
    control=EVERY, source="general knowledge, vacant in comparisons", evidence="inferred",
    program="O1\nN10 IF[#5 NE 0]GOTO30\nN20 S2\nN30 M30",
    runs="N10 N30",
)
case(
    "with #5 vacant, #5 GE 0 is true on a Mitsubishi",
    control=EVERY, source="general knowledge, vacant in comparisons", evidence="inferred",
    program="O1\nN10 IF[#5 GE 0]GOTO30\nN20 S2\nN30 M30",
    runs="N10 N30",
)
case(
    "with #5 vacant, #5 GT 0 is false on a Mitsubishi",
    control=EVERY, source="general knowledge, vacant in comparisons", evidence="inferred",
    program="O1\nN10 IF[#5 GT 0]GOTO30\nN20 S2\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "with #5 vacant, #5 LE 0 is true on a Mitsubishi",
    control=EVERY, source="general knowledge, vacant in comparisons", evidence="inferred",
    program="O1\nN10 IF[#5 LE 0]GOTO30\nN20 S2\nN30 M30",
    runs="N10 N30",
)
case(
    "with #5 vacant, #5 LT 0 is false on a Mitsubishi",
    control=EVERY, source="general knowledge, vacant in comparisons", evidence="inferred",
    program="O1\nN10 IF[#5 LT 0]GOTO30\nN20 S2\nN30 M30",
    runs="N10 N20 N30",
)
case(
    "with #5 zero, #5 EQ #0 is false",
    control=EVERY, source="general knowledge, vacant in comparisons", evidence="inferred",
    program="""
        O1
        N10 #5=0
        N20 IF[#5 EQ #0]GOTO40
        N30 S3
        N40 M30
    """,
    runs="N10 N20 N30 N40",
)
case(
    "a word whose variable is vacant is not there: T#5 changes no tool",
    control=EVERY, source="general knowledge, vacant word ignored", evidence="inferred",
    program="""
        O1
        N10 T#5
        N20 T#6
        N30 M30
    """,
    variables={6: 3}, runs="N10 N20 N30", t=[3],
)
case(
    "a move whose only word is vacant makes no modal call",
    control=EVERY, source="general knowledge, vacant word ignored", evidence="inferred",
    program="""
        O1
        N10 G66 P200
        N20 G0 X#5
        N30 G67
        N40 M30
        O200
        N210 M99
    """,
    runs="N10 N20 N30 N40", calls="",
)

# Variables

case(
    "common variables are shared by all levels",
    control=EVERY, source="general knowledge, variables", evidence="inferred",
    program="""
        O1
        N10 #100=1
        N20 G65 P200
        N30 M30
        O200
        N210 #100=#100+1
        N220 #500=#100
        N230 M99
    """,
    runs="N10 N20 N210 N220 N230 N30", vars={100: 2, 500: 2},
)
case(
    "the number of a variable may be an expression in brackets",
    control=EVERY, source="general knowledge, variables", evidence="inferred",
    program="""
        O1
        N10 #1=100
        N20 #[#1+1]=7
        N30 #102=#[#1+1]
        N40 M30
    """,
    runs="N10 N20 N30 N40", vars={101: 7, 102: 7},
)
case(
    "leading zeros do not change a variable",
    control=EVERY, source="general knowledge, variables", evidence="inferred",
    program="""
        O1
        N10 #0100=7
        N20 M30
    """,
    runs="N10 N20", vars={100: 7},
)
case(
    "there is no variable #34 to write",
    control=EVERY, source="MZ 846, P241 paired", evidence="inferred",
    program="""
        O1
        N10 #33=1
        N20 #34=1
        N30 M30
    """,
    runs="N10", alarm="illegal-variable", number="P241", at="O1 N20",
)
case(
    "there is no variable #99 to read",
    control=EVERY, source="MZ 846, P241 paired", evidence="inferred",
    program="""
        O1
        N10 #100=#99
        N20 M30
    """,
    runs="", alarm="illegal-variable", number="P241", at="O1 N10",
)
case(
    "an indirect variable whose number does not exist is P241",
    control=EVERY, source="MZ 846, P241 paired", evidence="inferred",
    program="""
        O1
        N10 #1=40
        N20 #100=#[#1+1]
        N30 M30
    """,
    runs="N10", alarm="illegal-variable", number="P241", at="O1 N20",
)
case(
    "#0 takes no value",
    control=EVERY, source="general knowledge P243", evidence="inferred",
    program="""
        O1
        N10 #0=1
        N20 M30
    """,
    runs="", alarm="vacant-assigned", number="P243", at="O1 N10",
)
case(
    "#3000 stops the program with P277 and the text",
    control=[MELDAS, M800], source="MZ 979; general knowledge P277", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 #3000=12(TOOL WORN)
        N30 M30
    """,
    runs="N10 N20", alarm="user-alarm", number="P277", at="O1 N20",
)
case(
    "#3000 in a macro stops the program there",
    control=EVERY, source="MZ 979; general knowledge P277", evidence="inferred",
    program="""
        O1
        N10 G65 P200
        N20 M30
        O200
        N210 IF[#1 NE #0]GOTO230
        N220 #3000=1(A MISSING)
        N230 M99
    """,
    runs="N10 N210 N220", alarm="user-alarm", number="P277", at="O200 N220",
)
case(
    "#3006 shows its text and the run goes on",
    control=EVERY, source="general knowledge #3006", evidence="inferred",
    program="""
        O1
        N10 #3006=1(CHECK TOOL)
        N20 M30
    """,
    runs="N10 N20", messages=["CHECK TOOL"],
)
case(
    "a comment after another assignment is no message",
    control=EVERY, source="general knowledge, comments", evidence="inferred",
    program="""
        O1
        N10 #100=1(CHECK TOOL)
        N20 M30
    """,
    runs="N10 N20", messages=[], vars={100: 1},
)
case(
    "SETVN gives two variables their names",
    pins="variable_forms:names",
    control=EVERY, source="MZ 866; general knowledge, SETVN", evidence="inferred",
    program="""
        O1
        N10 SETVN 510[TOOLNO,WORKNO]
        N20 #510=4
        N30 M30
    """,
    runs="N10 N20 N30", vars={510: 4, 511: None},
)
case(
    "SETVN of a wrong form is P292: SETVN [TOOLNO]",
    control=EVERY, source="MZ 866, paired with P292", evidence="secondary",
    program="O1\nN10 S1\nN20 SETVN [TOOLNO]\nN30 M30\n",
    runs="N10", alarm="setvn-format", number="P292", at="O1 N20",
)
case(
    "SETVN of a wrong form is P292: SETVN 510[TOOLNO",
    control=EVERY, source="MZ 866, paired with P292", evidence="secondary",
    program="O1\nN10 S1\nN20 SETVN 510[TOOLNO\nN30 M30\n",
    runs="N10", alarm="setvn-format", number="P292", at="O1 N20",
)
case(
    "SETVN of a wrong form is P292: SETVN 510 TOOLNO",
    control=EVERY, source="MZ 866, paired with P292", evidence="secondary",
    program="O1\nN10 S1\nN20 SETVN 510 TOOLNO\nN30 M30\n",
    runs="N10", alarm="setvn-format", number="P292", at="O1 N20",
)
case(
    "SETVN of an illegal name is P300: SETVN 510[TOOL*]",
    control=EVERY, source="MZ 870, paired with P300", evidence="secondary",
    program="O1\nN10 S1\nN20 SETVN 510[TOOL*]\nN30 M30\n",
    runs="N10", alarm="illegal-variable-name", number="P300", at="O1 N20",
)
case(
    "SETVN of an illegal name is P300: SETVN 510[TOOLNO,2B]",
    control=EVERY, source="MZ 870, paired with P300", evidence="secondary",
    program="O1\nN10 S1\nN20 SETVN 510[TOOLNO,2B]\nN30 M30\n",
    runs="N10", alarm="illegal-variable-name", number="P300", at="O1 N20",
)
