"""Haas NGC: M97, calls of a part of the same program."""

from conformance import case

HAAS = "haas-ngc"
M97 = {"control": HAAS, "source": "H96 p.217, M97", "evidence": "secondary"}
KNOWN = {"control": HAAS, "source": "general knowledge of the Haas mill", "evidence": "inferred"}

case(
    "M97 L runs the part from its N that often and comes back after the call", pins="call_passes_words", **M97,
    program="O11\nN10 M97 P1000 L5\nN20 M30\nN1000 #1=#1+1\nN1010 M99",
    runs="N10 (N1000 N1010)*5 N20", vars={1: 5}, calls="M97:O11",
)
case(
    "the words beside M97 come before the call", pins="point_addresses", **M97,
    program="O1\nN10 G0 X5. M97 P100\nN20 M30\nN100 G0 X7.\nN110 M99", moves_x=[5, 7],
)
case(
    "M97 takes a number that is computed, and the first block that has it", **M97,
    program="O1\nN5 #1=100\nN10 M97 P#1\nN20 M30\nN100 #2=1\nN110 M99\nN100 #2=2\nN120 M99",
    runs="N5 N10 N100 N110 N20", vars={2: 1},
)
case(
    "M97 keeps the locals of its program, G65 has its own", pins="commons",
    control=HAAS, source="HAA", evidence="secondary",
    program="O1\nN10 #1=5\nN20 M97 P100\nN30 G65 P2 B1.\nN40 M30\nN100 #100=#1\nN110 M99\nO2\nN200 #101=#1\nN210 M99",
    runs="N10 N20 N100 N110 N30 N200 N210 N40", vars={10100: 5, 10101: None},
)
case(
    "M97 and M98 count together, to nine", **KNOWN,
    program="O1\nN10 M97 P100\nN20 M30\nN100 M98 P2\nN110 M99\nO2\nN200 M97 P200\nN210 M99",
    runs="N10 N100 N200*7", alarm="nesting-too-deep", number="307", at="O2 N200",
)
case(
    "M97 to a number that its program does not have is 315", **KNOWN,
    program="O1\nN10 M97 P100\nN20 M30\nO2\nN100 M99",
    runs="", alarm="start-not-found", number="315", at="O1 N10", word="P100",
)
case(
    "M97 without P is 313", **KNOWN, program="O1\nN10 M97\nN20 M30",
    runs="", alarm="program-number-missing", number="313", at="O1 N10", word="M97",
)
case(
    "M97 to a number below zero calls nothing", **KNOWN, program="O1\nN5 #1=0-5\nN10 M97 P#1\nN20 M30",
    runs="N5", alarm="illegal-sequence-number", at="O1 N10",
)
case(
    "a part that M97 called and that ends in nothing is 312", pins="missing_end", **KNOWN,
    program="O1\nN10 M97 P100\nN20 M30\nN100 #1=1", runs="N10 N100", alarm="end-of-record", number="312",
)
case(
    "M97 and M98 do not stand in one block", **KNOWN,
    program="O1\nN10 M97 P100 M98\nN20 M30\nN100 M99", runs="", alarm="call-given-twice", at="O1 N10",
)
