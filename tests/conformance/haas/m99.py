"""Haas NGC: M99 P and conditional M99."""

from conformance import case

HAAS = "haas-ngc"
M99 = {"control": HAAS, "source": "HDIY, M99 P", "evidence": "maker's manual"}
WORDS = {"control": HAAS, "source": "HNGC p.227, G00 X0 Y0 [#1EQ#2] M99 P5", "evidence": "maker's manual"}
KNOWN = {"control": HAAS, "source": "general knowledge of the Haas mill", "evidence": "inferred"}

case(
    "M99 P in a subprogram goes on there and the call stays open", **M99,
    program="O1\nN10 M98 P2\nN20 M30\nO2\nN30 M99 P50\nN40 M30\nN50 M99", runs="N10 N30 N50 N20",
)
case(
    "M99 P takes no pass of L away", **M99,
    program="O1\nN10 M98 P2 L2\nN20 M30\nO2\nN30 M99 P50\nN50 M99", runs="N10 (N30 N50)*2 N20",
)
case(
    "M99 P does not look into the caller", **M99,
    program="O1\nN10 M98 P2\nN20 M30\nO2\nN30 M99 P20\nN40 M99",
    runs="N10", alarm="return-target-not-found", number="315", at="O2 N30",
)
case(
    "M99 with a condition goes where it holds and on where it does not", pins="conditional_return", **M99,
    program="O1\nN10 #10000=8\nN20 #10000=#10000+1\nN30 [#10000 LT 10] M99 P20\nN40 M30",
    runs="N10 (N20 N30)*2 N40",
)
case(
    "M99 with a condition and no P returns where it holds", **M99,
    program="O1\nN10 M98 P2\nN20 M30\nO2\nN30 #1=#1+1\nN40 [#1 EQ 2] M99\nN50 M99 P30",
    runs="N10 N30 N40 N50 N30 N40 N20",
)
case(
    "the condition of M99 is that of M99 alone: the words beside it are executed in any case", **WORDS | {"evidence": "inferred"},
    program="O1\nN10 [#1 EQ 2] G0 X5. M99 P30\nN20 [1] G0 X6. M99 P40\nN30 G0 X7.\nN40 M30",
    runs="N10 N20 N40", moves_x=[5, 6],
)
case(
    "a conditional M99 whose block is missing alarms only where it holds", **M99,
    program="O1\nN10 [0] M99 P99\nN20 [1] M99 P99\nN30 M30",
    runs="N10", alarm="return-target-not-found", number="315", at="O1 N20",
)
case(
    "a condition stands before M99 and before nothing else", **KNOWN,
    program="O1\nN10 [1 EQ 1] G0 X5.\nN20 M30", runs="", alarm="statement-format", at="O1 N10",
)
