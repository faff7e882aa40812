"""Huazhong HNC-21M: expressions."""

from conformance import case

HNC = "hnc-21m"

case(
    "HNC expressions: PI is a constant, PI is 3.14159265",
    control=HNC, source="H9, constants; general knowledge, functions",
    evidence="inferred",
    program="%1\nN10 #50=PI\nN20 M30",
    runs="N10 N20", vars={50: 3.14159265},
)
case(
    "HNC expressions: SIN takes radians, SIN[PI/2] is 1",
    pins="angle_unit", control=HNC, source="H9, constants; general knowledge, functions",
    evidence="inferred",
    program="%1\nN10 #50=SIN[PI/2]\nN20 M30",
    runs="N10 N20", vars={50: 1},
)
case(
    "HNC expressions: degrees are turned into radians by the program, SIN[30*PI/180] is 0.5",
    pins="angle_unit", control=HNC, source="H9, constants; general knowledge, functions",
    evidence="inferred",
    program="%1\nN10 #50=SIN[30*PI/180]\nN20 M30",
    runs="N10 N20", vars={50: 0.5},
)
case(
    "HNC expressions: COS takes radians, COS[PI] is -1",
    pins="angle_unit", control=HNC, source="H9, constants; general knowledge, functions",
    evidence="inferred",
    program="%1\nN10 #50=COS[PI]\nN20 M30",
    runs="N10 N20", vars={50: -1},
)
case(
    "HNC expressions: TAN takes radians, TAN[PI/4] is 1",
    pins="angle_unit", control=HNC, source="H9, constants; general knowledge, functions",
    evidence="inferred",
    program="%1\nN10 #50=TAN[PI/4]\nN20 M30",
    runs="N10 N20", vars={50: 1},
)
case(
    "HNC expressions: ATAN gives radians, ATAN[1] is 0.78539816",
    pins="angle_unit", control=HNC, source="H9, constants; general knowledge, functions",
    evidence="inferred",
    program="%1\nN10 #50=ATAN[1]\nN20 M30",
    runs="N10 N20", vars={50: 0.78539816},
)
case(
    "HNC expressions: SQRT is the square root, SQRT[16] is 4",
    control=HNC, source="H9, constants; general knowledge, functions",
    evidence="inferred",
    program="%1\nN10 #50=SQRT[16]\nN20 M30",
    runs="N10 N20", vars={50: 4},
)
case(
    "HNC expressions: ABS takes the sign away, ABS[-3.5] is 3.5",
    control=HNC, source="H9, constants; general knowledge, functions",
    evidence="inferred",
    program="%1\nN10 #50=ABS[-3.5]\nN20 M30",
    runs="N10 N20", vars={50: 3.5},
)
case(
    "HNC expressions: INT cuts the fraction off, INT[3.7] is 3",
    control=HNC, source="H9, constants; general knowledge, functions",
    evidence="inferred",
    program="%1\nN10 #50=INT[3.7]\nN20 M30",
    runs="N10 N20", vars={50: 3},
)
case(
    "HNC expressions: SIGN tells the sign, SIGN[-5] is -1",
    control=HNC, source="H9, constants; general knowledge, functions",
    evidence="inferred",
    program="%1\nN10 #50=SIGN[-5]\nN20 M30",
    runs="N10 N20", vars={50: -1},
)
case(
    "HNC expressions: EXP is the power of e, EXP[0] is 1",
    control=HNC, source="H9, constants; general knowledge, functions",
    evidence="inferred",
    program="%1\nN10 #50=EXP[0]\nN20 M30",
    runs="N10 N20", vars={50: 1},
)
case(
    "HNC expressions: multiplication comes before addition, 2+3*4 is 14",
    control=HNC, source="H9, constants; general knowledge, functions",
    evidence="inferred",
    program="%1\nN10 #50=2+3*4\nN20 M30",
    runs="N10 N20", vars={50: 14},
)
case(
    "HNC expressions: brackets come first, [2+3]*4 is 20",
    control=HNC, source="H9, constants; general knowledge, functions",
    evidence="inferred",
    program="%1\nN10 #50=[2+3]*4\nN20 M30",
    runs="N10 N20", vars={50: 20},
)
case(
    "HNC: a division by zero stops the program",
    control=HNC, source="general knowledge, expression error", evidence="inferred",
    program="""
        %1
        N10 #50=0
        N20 #51=5/#50
        N30 M30
    """,
    runs="N10", alarm="division-by-zero", number=None, at="%1 N20",
)
case(
    "HNC: the square root of a negative value stops the program",
    control=HNC, source="general knowledge, expression error", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 #51=SQRT[1-5]
        N30 M30
    """,
    runs="N10", alarm="square-root-of-negative", number=None, at="%1 N20",
)
case(
    "HNC: a bracket that is not closed stops the program",
    control=HNC, source="general knowledge, expression error", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 #51=[1+2
        N30 M30
    """,
    runs="N10", alarm="bracket-not-closed", number=None, at="%1 N20",
)
case(
    "HNC: an expression that breaks off stops the program",
    control=HNC, source="general knowledge, expression error", evidence="inferred",
    program="""
        %1
        N10 S1
        N20 #51=1+
        N30 M30
    """,
    runs="N10", alarm="expression-format", number=None, at="%1 N20",
)
case(
    "HNC: an undefined variable counts as zero in an expression",
    control=HNC, source="general knowledge, undefined is 0", evidence="inferred",
    program="""
        %1
        N10 #50=#7+3
        N20 M30
    """,
    runs="N10 N20", vars={50: 3},
)
case(
    "HNC: a tool number may be an expression in brackets",
    control=HNC, source="HD, variables after M, D, H and others", evidence="secondary",
    program="""
        %1
        N10 T[#50+2]
        N20 M[#51]
        N30 M30
    """,
    variables={50: 3, 51: 8}, runs="N10 N20 N30", t=[5], m=[8],
)
