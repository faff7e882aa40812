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
case(
    "IF with neither GOTO nor THEN is 516", **KNOWN, program="O1\nN10 IF [1] #1=2\nN20 M30",
    runs="", alarm="if-format", number="516", at="O1 N10",
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
