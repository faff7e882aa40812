"""Mitsubishi M800: IF, ELSE and ENDIF blocks."""

from conformance import case

M800 = "mitsubishi-m800"

case(
    "M800: a true IF block runs its first part and not the ELSE part",
    control=M800, source="general knowledge, IF blocks", evidence="inferred",
    program="""
        O1
        N10 IF[#100 EQ 1]THEN
        N20 S2
        N30 S3
        ELSE
        N40 S4
        ENDIF
        N50 M30
    """,
    variables={100: 1}, runs="N10 N20 N30 N50",
)
case(
    "M800: a false IF block runs the ELSE part",
    control=M800, source="general knowledge, IF blocks", evidence="inferred",
    program="""
        O1
        N10 IF[#100 EQ 1]THEN
        N20 S2
        ELSE
        N40 S4
        N45 S5
        ENDIF
        N50 M30
    """,
    variables={100: 2}, runs="N10 N40 N45 N50",
)
case(
    "M800: a false IF block without ELSE goes on after its ENDIF",
    control=M800, source="general knowledge, IF blocks", evidence="inferred",
    program="""
        O1
        N10 IF[#100 EQ 1]THEN
        N20 S2
        ENDIF
        N50 M30
    """,
    variables={100: 2}, runs="N10 N50",
)
case(
    "M800: an ELSE belongs to the innermost open IF",
    control=M800, source="general knowledge, IF blocks", evidence="inferred",
    program="""
        O1
        N10 IF[#100 EQ 1]THEN
        N20 IF[#101 EQ 1]THEN
        N30 S3
        ELSE
        N40 S4
        ENDIF
        ENDIF
        N50 M30
    """,
    variables={100: 1, 101: 0}, runs="N10 N20 N40 N50",
)
case(
    "M800: a false outer IF jumps over an inner IF with its ELSE",
    control=M800, source="general knowledge, IF blocks", evidence="inferred",
    program="""
        O1
        N10 IF[#100 EQ 1]THEN
        N20 IF[#101 EQ 1]THEN
        N30 S3
        ELSE
        N40 S4
        ENDIF
        ELSE
        N45 S5
        ENDIF
        N50 M30
    """,
    variables={100: 0, 101: 0}, runs="N10 N45 N50",
)
case(
    "M800: a single IF THEN inside an IF block needs no ENDIF",
    control=M800, source="general knowledge, IF blocks", evidence="inferred",
    program="""
        O1
        N10 IF[#100 EQ 1]THEN
        N20 IF[#100 EQ 1]THEN #101=4
        N30 S3
        ENDIF
        N50 M30
    """,
    variables={100: 1}, runs="N10 N20 N30 N50", vars={101: 4},
)
case(
    "M800: a call inside an IF block comes back into it",
    control=M800, source="general knowledge, IF blocks", evidence="inferred",
    program="""
        O1
        N10 IF[#100 EQ 1]THEN
        N20 M98 P200
        N30 S3
        ENDIF
        N50 M30
        O200
        N210 M99
    """,
    variables={100: 1}, runs="N10 N20 N210 N30 N50",
)
case(
    "M800: an IF block without ENDIF is P289",
    control=M800, source="general knowledge, P289", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 IF[#100 EQ 1]THEN
        N30 S3
        N50 M30
    """,
    variables={100: 0}, runs="N10", alarm="if-without-end", number="P289", at="O1 N20",
)
case(
    "M800: an ENDIF without IF is P289",
    control=M800, source="general knowledge, P289", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 ENDIF
        N50 M30
    """,
    runs="N10", alarm="if-without-end", number="P289", at="O1 N20",
)
case(
    "M800: an ELSE without IF is P289",
    control=M800, source="general knowledge, P289", evidence="inferred",
    program="""
        O1
        N10 S1
        N20 ELSE
        N30 S3
        N50 M30
    """,
    runs="N10", alarm="if-without-end", number="P289", at="O1 N20",
)
case(
    "M800: an ENDIF of another program does not end an IF",
    control=M800, source="general knowledge, P289", evidence="inferred",
    program="""
        O1
        N10 IF[#100 EQ 1]THEN
        N20 M30
        O200
        N210 ENDIF
        N220 M99
    """,
    variables={100: 0}, runs="", alarm="if-without-end", number="P289", at="O1 N10",
)
case(
    "M800: ten IF blocks inside each other are legal",
    pins="max_ifs",
    control=M800, source="general knowledge, IF nesting 10", evidence="inferred",
    program="O1\n" + "".join(f"N{k} IF[1 EQ 1]THEN\n" for k in range(1, 11)) + "N20 S1\n"
    + "ENDIF\n" * 10 + "N30 M30\n",
    runs=" ".join(f"N{k}" for k in range(1, 11)) + " N20 N30",
)
case(
    "M800: an eleventh IF block inside is P288",
    control=M800, source="general knowledge, IF nesting 10", evidence="inferred",
    program="O1\n" + "".join(f"N{k} IF[1 EQ 1]THEN\n" for k in range(1, 12)) + "N20 S1\n"
    + "ENDIF\n" * 11 + "N30 M30\n",
    runs=" ".join(f"N{k}" for k in range(1, 11)), alarm="if-too-deep", number="P288",
    at="O1 N11",
)
