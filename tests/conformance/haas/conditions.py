"""Haas NGC: conditions of any value."""

from conformance import case

HAAS = "haas-ngc"
VALUES = {"control": HAAS, "source": "HDIY, conditional expressions", "evidence": "maker's manual"}
KNOWN = {"control": HAAS, "source": "general knowledge of the Haas mill", "evidence": "inferred"}

case(
    "a comparison is 1 or 0 wherever a value stands", **VALUES,
    program="O1\nN10 #1=[2 EQ 2]+3\nN20 #2=[2 LT 2]\nN30 G0 X[1 EQ 1]\nN40 M30", vars={1: 4, 2: 0}, moves_x=[1],
)
case(
    "WHILE takes any value", pins="loop_form", **VALUES,
    program="O1\nN10 #1=2\nN20 WHILE [#1] DO1\nN30 #1=#1-1\nN40 END1\nN50 M30",
    runs="N10 (N20 N30 N40)*2 N20 N50", vars={1: 0},
)
case(
    "a vacant condition does not hold", **VALUES,
    program="O1\nN10 IF [#1] GOTO 30\nN20 #2=1\nN30 M30", runs="N10 N20 N30",
)
case(
    "conditions are joined by AND and OR", pins="conditions:joined", **VALUES,
    program="O1\nN10 IF [[1 EQ 1] AND [2 EQ 3]] GOTO 30\nN20 IF [[1 EQ 1] OR [2 EQ 3]] GOTO 40\nN30 M0\nN40 M30",
    runs="N10 N20 N40",
)
VERSABUILT = {"control": HAAS, "source": "VBH, 9000.nc", "evidence": "secondary"}

case(
    "after the condition of IF a call may stand without THEN", pins="if_form", **VERSABUILT,
    program="""
        O9000
        N10 #10001=0
        N20 IF[#10001 EQ 0] M98 P9004
        N30 #10001=1
        N40 IF[#10001 EQ 0] M98 P9004
        N50 M30
        O9004
        N60 M99
    """,
    runs="N10 N20 N60 N30 N40 N50",
)
case(
    "after the condition of IF a macro call takes its arguments", **VERSABUILT,
    program="""
        O1
        N10 #1=5
        N20 IF [#1 GT 4] G65 P2 A#1 B7.
        N30 IF [#1 GT 5] THEN G65 P2 A9.
        N40 M30
        O2
        N50 #10100=#1+#2
        N60 M99
    """,
    runs="N10 N20 N50 N60 N30 N40", vars={10100: 12},
)
case(
    "words after the condition of IF are executed where it holds, and nothing of them where it does not",
    **VERSABUILT | {"evidence": "inferred"},
    program="""
        O1
        N10 IF [1] G0 X5. M8
        N20 IF [0] THEN G0 X6. M9
        N30 IF [1] M97 P60
        N40 IF [1] M30
        N50 G0 X7.
        N60 G0 Y1.
        N70 M99
    """,
    runs="N10 N20 N30 N60 N70 N40", moves="R X5\nR Y1", m=[8],
)
case(
    "a fault in the words after the condition of IF stands in its block, whether it holds or not",
    **VERSABUILT | {"evidence": "inferred"},
    program="O1\nN10 IF [0] M98 P2 M98 P3\nN20 M30", runs="", alarm="call-given-twice", at="O1 N10",
)
case(
    "after the condition of IF stands no second IF", **VERSABUILT | {"evidence": "inferred"},
    program="O1\nN10 IF [1] THEN IF [1] M98 P2\nN20 M30", runs="", alarm="if-format", number="516", at="O1 N10",
)
FONT = {"control": HAAS, "source": "H96 p.159, O9876: IF [ #9 EQ #0 ] #9= #4109", "evidence": "secondary"}
case(
    "after the condition of IF a statement may stand without THEN", pins="if_form", **FONT,
    program="O1\nN10 F250.\nN20 IF [ #9 EQ #0 ] #9= #4109\nN30 IF [ #9 EQ #0 ] #8= 1.\nN40 IF [#9 GT 100] #[3+4]=#9*2\nN50 M30",
    runs="N10 N20 N30 N40 N50", vars={9: 250, 8: None, 7: 500},
)
case(
    "after the condition of IF without THEN words may follow the statement too",
    **FONT | {"evidence": "inferred"},
    program="O1\nN10 IF [1] #1=2 G0 X5.\nN20 M30", runs="N10 N20", vars={1: 2}, moves_x=[5],
)
case(
    "after the condition of IF without THEN stands no loop", **FONT | {"evidence": "inferred"},
    program="O1\nN10 IF [1] WHILE[1]DO1\nN20 END1\nN30 M30", runs="", alarm="if-format", number="516", at="O1 N10",
)
case(
    "after the condition of IF something has to stand", **KNOWN,
    program="O1\nN10 IF [1]\nN20 M30", runs="", alarm="if-format", number="516", at="O1 N10",
)
case(
    "a vacant variable moves nothing",
    control=HAAS, source="HDIY, address substitution", evidence="maker's manual",
    program="O1\nN10 G0 X1. Y#1\nN20 M30", moves="R X1",
)
case(
    "a code by a variable that the control does not have is an invalid G code", pins="unlisted_codes",
    control=HAAS, source="HDIY, address substitution", evidence="maker's manual",
    program="O1\nN10 #1=145\nN20 G#1\nN30 M30", runs="N10", alarm="g-code-not-available", number="310", at="O1 N20",
)
