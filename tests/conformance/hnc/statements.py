"""Huazhong HNC-21M: IF, ELSE and WHILE."""

from conformance import case

case(
    "IF runs its blocks where the condition is true and only there (HNC-004)",
    control="hnc-21m",
    source="HD",
    evidence="secondary",
    program="""
        %1
        #3=9
        IF #3 GE 9
        G0 X1
        ENDIF
        IF #3 LT 5
        G0 X2
        ENDIF
        M30
    """,
    moves_x=[1],
)

case(
    "ELSE runs where the condition is false (HNC-005)",
    control="hnc-21m",
    source="general knowledge of the Century Star manuals",
    evidence="inferred",
    program="""
        %1
        #3=2
        IF #3 GE 9
        G0 X1
        ELSE
        G0 X2
        ENDIF
        M30
    """,
    moves_x=[2],
)

case(
    "WHILE takes an expression without brackets (HNC-006)",
    pins="loop_form",
    control="hnc-21m",
    source="HD",
    evidence="secondary",
    program="""
        %1
        #1=0
        WHILE #1 LT 2*2
        G0 X[#1]
        #1=#1+1
        ENDW
        M30
    """,
    moves_x=[0, 1, 2, 3],
)

HNC = "hnc-21m"

# IF

case(
    "HNC: a true IF runs its part and jumps over ELSE",
    control=HNC, source="HD, IF ELSE ENDIF", evidence="secondary",
    program="""
        %1
        N10 #1=10
        N20 IF #1 GE 10
        N30 S3
        ELSE
        N40 S4
        ENDIF
        N50 M30
    """,
    runs="N10 N20 N30 N50",
)
case(
    "HNC: a false IF without ELSE goes on after ENDIF",
    control=HNC, source="HD, IF ENDIF", evidence="secondary",
    program="""
        %1
        N10 #1=10
        N20 IF #1 GT 10
        N30 S3
        ENDIF
        N50 M30
    """,
    runs="N10 N20 N50",
)
case(
    "HNC: ELSE belongs to the innermost open IF",
    control=HNC, source="HD, IF ELSE ENDIF", evidence="inferred",
    program="""
        %1
        N10 #1=10
        N20 IF #1 EQ 10
        N30 IF #1 EQ 11
        N35 S3
        ELSE
        N40 S4
        ENDIF
        ENDIF
        N50 M30
    """,
    runs="N10 N20 N30 N40 N50",
)
case(
    "HNC: AND joins two conditions in brackets",
    control=HNC, source="general knowledge, AND OR NOT", evidence="inferred",
    program="""
        %1
        N10 IF [#50 GT 1] AND [#51 GT 1]
        N20 S2
        ENDIF
        N30 IF [#50 GT 1] OR [#51 GT 1]
        N40 S4
        ENDIF
        N50 M30
    """,
    variables={50: 2, 51: 0}, runs="N10 N30 N40 N50",
)
case(
    "HNC: TRUE and FALSE are conditions",
    control=HNC, source="H9, constants", evidence="secondary",
    program="""
        %1
        N10 IF TRUE
        N20 S2
        ENDIF
        N30 IF FALSE
        N40 S4
        ENDIF
        N50 M30
    """,
    runs="N10 N20 N30 N50",
)
case(
    "HNC: an IF without ENDIF is refused",
    control=HNC, source="general knowledge, IF without ENDIF", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 IF #50 GE 10
        N30 S3
        N40 M30
    """,
    variables={50: 0}, runs="N10", alarm="if-without-end", number=None, at="%1 N20",
)
case(
    "HNC: the ENDIF of another program does not end an IF",
    control=HNC, source="general knowledge, IF without ENDIF", evidence="inferred",
    program="""
        %1
        N10 IF #50 GE 10
        N20 M30
        %2
        N30 ENDIF
        N40 M99
    """,
    variables={50: 0}, runs="", alarm="if-without-end", number=None, at="%1 N10",
)
case(
    "HNC: an ENDIF without IF is refused",
    control=HNC, source="general knowledge, IF without ENDIF", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 ENDIF
        N30 M30
    """,
    runs="N10", alarm="if-without-end", number=None, at="%1 N20",
)
case(
    "HNC: nine IF inside each other are legal",
    pins="max_ifs",
    control=HNC, source="HS, MAX_NEST_NUM 9", evidence="inferred",
    program="%1\n" + "".join(f"N{k} IF #50 EQ 1\n" for k in range(1, 10)) + "N20 S1\n"
    + "ENDIF\n" * 9 + "N30 M30\n",
    variables={50: 1}, runs=" ".join(f"N{k}" for k in range(1, 10)) + " N20 N30",
)
case(
    "HNC: a tenth IF inside is refused",
    control=HNC, source="HS, MAX_NEST_NUM 9", evidence="inferred",
    program="%1\n" + "".join(f"N{k} IF #50 EQ 1\n" for k in range(1, 11)) + "N20 S1\n"
    + "ENDIF\n" * 10 + "N30 M30\n",
    variables={50: 1}, runs=" ".join(f"N{k}" for k in range(1, 10)), alarm="if-too-deep",
    number=None, at="%1 N10",
)
case(
    "HNC: a condition of more than 128 characters is refused",
    control=HNC, source="HS, MAX_CONDITION_LEN 128", evidence="inferred",
    program="%1\nN10 IF #50 EQ " + "+".join(["1"] * 70) + "\nN20 S2\nENDIF\nN30 M30\n",
    variables={50: 70}, runs="", alarm="if-format", number=None, at="%1 N10",
)

# WHILE

case(
    "HNC: a WHILE loop runs until its condition is false",
    control=HNC, source="HD, WHILE ENDW", evidence="secondary",
    program="""
        %1
        N10 #1=3
        N20 WHILE #1 GT 0
        N30 #1=#1-1
        N40 ENDW
        N50 M30
    """,
    runs="N10 (N20 N30 N40)*3 N20 N50",
)
case(
    "HNC: a WHILE that is false from the start goes on after ENDW",
    control=HNC, source="HD, WHILE ENDW", evidence="secondary",
    program="""
        %1
        N10 #1=3
        N20 WHILE #1 LT 3
        N30 S3
        N40 ENDW
        N50 M30
    """,
    runs="N10 N20 N50",
)
case(
    "HNC: WHILE TRUE never ends by itself",
    control=HNC, source="H9, constants; HD, WHILE ENDW", evidence="inferred",
    program="""
        %1
        N10 WHILE TRUE
        N20 S2
        N30 ENDW
        N40 M30
    """,
    max_blocks=6, runs="(N10 N20 N30)*2", stop="limit",
)
case(
    "HNC: ENDW belongs to the innermost open WHILE",
    control=HNC, source="HD, WHILE ENDW", evidence="inferred",
    program="""
        %1
        N10 WHILE #50 LT 2
        N20 #51=0
        N30 WHILE #51 LT 1
        N40 #51=#51+1
        N50 ENDW
        N60 #50=#50+1
        N70 ENDW
        N80 M30
    """,
    variables={50: 0}, runs="(N10 N20 N30 N40 N50 N30 N60 N70)*2 N10 N80",
)
case(
    "HNC: a subprogram called in a loop comes back into it",
    control=HNC, source="HD, WHILE ENDW", evidence="inferred",
    program="""
        %1
        N10 WHILE #50 LT 2
        N20 M98 P2
        N30 ENDW
        N40 M30
        %2
        N50 #50=#50+1
        N60 M99
    """,
    variables={50: 0}, runs="(N10 N20 N50 N60 N30)*2 N10 N40",
)
case(
    "HNC: a WHILE without ENDW is refused even when it would not run",
    control=HNC, source="general knowledge, WHILE without ENDW", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 WHILE #50 GT 5
        N30 S3
        N40 M30
    """,
    variables={50: 0}, runs="N10", alarm="missing-end", number=None, at="%1 N20",
)
case(
    "HNC: an ENDW without WHILE is refused",
    control=HNC, source="general knowledge, ENDW without WHILE", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 ENDW
        N30 M30
    """,
    runs="N10", alarm="missing-do", number=None, at="%1 N20",
)
case(
    "HNC: a tenth WHILE inside is refused",
    pins="max_loops",
    control=HNC, source="HS, MAX_NEST_NUM 9", evidence="inferred",
    program="%1\n" + "".join(f"N{k} WHILE #50 EQ 1\n" for k in range(1, 11)) + "N20 #50=2\n"
    + "ENDW\n" * 10 + "N30 M30\n",
    variables={50: 1}, runs=" ".join(f"N{k}" for k in range(1, 10)), alarm="loops-too-deep",
    number=None, at="%1 N10",
)
case(
    "HNC: an ELSE without IF is refused",
    control=HNC, source="general knowledge, IF without ENDIF", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 ELSE
        N30 M30
    """,
    runs="N10", alarm="if-without-end", number=None, at="%1 N20",
)
case(
    "HNC: an IF without ENDIF in a subprogram is told there",
    control=HNC, source="general knowledge, IF without ENDIF", evidence="inferred",
    program="""
        %1
        N10 M98 P2
        N20 M30
        %2
        N30 IF #0 GT 5
        N40 M99
    """,
    runs="N10", alarm="if-without-end", number=None, at="%2 N30",
)
case(
    "HNC: an ENDW does not end an IF",
    control=HNC, source="general knowledge, IF without ENDIF", evidence="inferred",
    program="""
        %1
        N10 IF #50 GT 5
        N20 S2
        N30 ENDW
        N40 M30
    """,
    variables={50: 0}, runs="", alarm="if-without-end", number=None, at="%1 N10",
)
case(
    "HNC: an ENDIF does not end a WHILE",
    control=HNC, source="general knowledge, WHILE without ENDW", evidence="inferred",
    program="""
        %1
        N10 WHILE #50 GT 5
        N20 S2
        N30 ENDIF
        N40 M30
    """,
    variables={50: 0}, runs="", alarm="missing-end", number=None, at="%1 N10",
)
case(
    "HNC: the ENDW of another program does not end a WHILE",
    control=HNC, source="general knowledge, WHILE without ENDW", evidence="inferred",
    program="""
        %1
        N10 WHILE #50 GT 5
        N20 M30
        %2
        N30 ENDW
        N40 M99
    """,
    variables={50: 0}, runs="", alarm="missing-end", number=None, at="%1 N10",
)
case(
    "HNC: a missing program is found on the pass that calls it",
    control=HNC, source="HD, IF ENDIF; general knowledge", evidence="inferred",
    program="""
        %1
        N10 WHILE #50 LT 5
        N20 #50=#50+1
        N30 M98 P[#50+1]
        N40 ENDW
        N50 M30
        %2
        N60 M99
    """,
    variables={50: 0}, runs="N10 N20 N30 N60 N40 N10 N20", alarm="program-not-found",
    number=None, at="%1 N30",
)
case(
    "HNC: a fault in an argument stops the call",
    control=HNC, source="general knowledge, expression error", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 M98 P2 A[5/#50]
        N30 M30
        %2
        N40 M99
    """,
    variables={50: 0}, runs="N10", calls="", alarm="division-by-zero", number=None, at="%1 N20",
)
case(
    "HNC: a bracket that was not opened stops the program",
    control=HNC, source="general knowledge, expression error", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 #51=1+2]
        N30 M30
    """,
    runs="N10", alarm="bracket-not-opened", number=None, at="%1 N20",
)
case(
    "HNC: there is no GOTO",
    pins="statements",
    control=HNC, source="general knowledge, no GOTO in HNC-21", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 GOTO 10
        N30 M30
    """,
    runs="N10", alarm="statement-not-available", number=None, at="%1 N20",
)
