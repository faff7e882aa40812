"""Huazhong HNC-21M: how long, how deep and how large its statements may be."""

from conformance import case

HNC, TE = "hnc-21m", "gsk-928te"

case(
    "GOTO is no statement of the HNC",
    control=HNC, source="general knowledge of the Century Star manuals", evidence="inferred",
    program="""
        %1
        N10 M8
        N20 GOTO 30
        N30 M30
    """,
    runs="N10", alarm="statement-not-available",
)
case(
    "123456789012 is an expression of the HNC",
    pins="max_constant_digits", control=HNC,
    source="general knowledge of the Century Star manuals", evidence="inferred",
    program="%1\nN10 #50=123456789012\nN30 M30",
    vars={50: 123456789012},
)
case(
    "ATAN[-1] is an expression of the HNC",
    control=HNC,
    source="general knowledge of the Century Star manuals", evidence="inferred",
    program="%1\nN10 #50=ATAN[-1]\nN30 M30",
    vars={50: -0.785398},
)
case(
    "[[[[[[[[[[[[... is an expression of the HNC",
    pins="max_brackets", control=HNC,
    source="general knowledge of the Century Star manuals", evidence="inferred",
    program="""
        %1
        N10 #50=[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]
        N30 M30
    """,
    vars={50: 1},
)
case(
    "ATAN2[-1,-1] is an expression of the HNC",
    control=HNC,
    source="general knowledge of the Century Star manuals", evidence="inferred",
    program="%1\nN10 #50=ATAN2[-1,-1]\nN30 M30",
    vars={50: -2.356194},
)
case(
    "-5 AND 3 is an expression of the HNC",
    pins="refuses:logic-of-negative refuses:logic-of-other-than-0-and-1", control=HNC,
    source="general knowledge of the Century Star manuals", evidence="inferred",
    program="%1\nN10 #50=-5 AND 3\nN30 M30",
    vars={50: 3},
)
case(
    "thirteen digits are too many in a statement of the HNC",
    control=HNC, source="general knowledge of the Century Star manuals",
    evidence="inferred",
    program="%1\nN10 M8\nN20 #50=1234567890123\nN30 M30",
    runs="N10", alarm="too-many-digits", at="%1 N20",
)
case(
    "65 brackets are too many in a statement of the HNC",
    control=HNC, source="general knowledge of the Century Star manuals",
    evidence="inferred",
    program="""
        %1
        N10 M8
        N20 #50=[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]
        N30 M30
    """,
    runs="N10", alarm="brackets-too-deep", at="%1 N20",
)
case(
    "MOD is no operator of the HNC",
    control=HNC, source="general knowledge of the Century Star manuals",
    pins="functions", evidence="inferred",
    program="%1\nN10 M8\nN20 #50=7 MOD 4\nN30 M30",
    runs="N10", alarm="nc-and-macro-in-block", at="%1 N20",
)
case(
    "two letters are no function of the HNC",
    control=HNC, source="general knowledge of the Century Star manuals",
    pins="short_functions", evidence="inferred",
    program="%1\nN10 M8\nN20 #50=EX[1]\nN30 M30",
    runs="N10", alarm="expression-format", at="%1 N20",
)
case(
    "== is no operator of the HNC",
    control=HNC, source="general knowledge of the Century Star manuals",
    pins="conditions:symbols", evidence="inferred",
    program="%1\nN10 M8\nN20 IF 1 == 1\nN25 ENDIF\nN30 M30",
    runs="N10", alarm="statement-format", at="%1 N20",
)
case(
    "blanks and a comment after a condition are none of its 128 characters",
    control=HNC, source="general knowledge of the Century Star manuals", evidence="inferred",
    program="%1\nN10 IF [1 EQ 1]" + " " * 130 + "\nN20 WHILE #1 LT 1" + " " * 60 + "(" + "X" * 80 + ") ;END\nN30 #1=#1+1\nN40 ENDW\nN50 ENDIF\nN60 M30",
    runs="N10 N20 N30 N40 N20 N50 N60",
)
case(
    "a condition of the HNC has at most 128 characters",
    control=HNC, source="general knowledge of the Century Star manuals",
    pins="max_condition_length", evidence="inferred",
    program="""
        %1
        N10 M8
        N20 IF [1 EQ 1] AND [1 EQ 1] AND [1 EQ 1] AND [1 EQ 1] AND [1 EQ 1] AND [1 EQ 1] AND [1 EQ 1] AND [1 EQ 1] AND [1 EQ 1] AND [1 EQ 1.000]
        N25 ENDIF
        N30 M30
    """,
    runs="N10", alarm="if-format", at="%1 N20",
)
case(
    "a vacant variable is 0 in a condition of the HNC",
    pins="vacant_comparison",
    control=HNC, source="general knowledge of the Century Star manuals", evidence="inferred",
    program="""
        %1
        N10 IF #60 EQ 0
        N20 M8
        N25 ENDIF
        N30 M30
    """,
    m=[8],
)
case(
    "a word with a vacant variable is 0 on the HNC",
    pins="vacant_address",
    control=HNC, source="general knowledge of the Century Star manuals", evidence="inferred",
    program="""
        %1
        N10 T#60
        N30 M30
    """,
    runs="N10 N30", t=[0],
)
case(
    "AND binds weaker than a comparison on the HNC",
    pins="conditions:joined logic_order",
    control=HNC, source="general knowledge of the Century Star manuals", evidence="inferred",
    program="""
        %1
        N10 IF 1 EQ 1 AND 2 EQ 2
        N20 M8
        N25 ENDIF
        N30 M30
    """,
    m=[8],
)
