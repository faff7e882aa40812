"""Haas NGC: settings that change what a program does, and the jump that reads an input."""

from conformance import case

HAAS = "haas-ngc"
M96 = {"control": HAAS, "source": "HNGC p.357, M96", "evidence": "maker's manual"}
KNOWN = {"control": HAAS, "source": "general knowledge of the Haas mill", "evidence": "inferred"}

case(
    "setting 9 is the unit before G20 or G21", control=HAAS, source="HNGC p.375, setting 9", evidence="maker's manual",
    params={"9": 1}, program="O1\nN10 G0 X1.\nN20 M30", moves_x=[25.4],
)
case(
    "as delivered it is millimetres", pins="power_on:G20", **KNOWN, program="O1\nN10 G0 X1.\nN20 M30", moves_x=[1],
)
case(
    "setting 40 makes the offset of D a diameter",
    control=HAAS, source="HNGC p.380, setting 40", evidence="maker's manual",
    params={"40": 1}, setup={"radius_offsets": {1: 10}},
    program="O1\nN10 G41 D1 G1 X10. F100.\nN20 Y10.\nN30 Y20.\nN40 M30", final_machine="X5 Y20",
)
case(
    "as delivered it is a radius", **KNOWN, pins="radius_offset_diameter", setup={"radius_offsets": {1: 10}},
    program="O1\nN10 G41 D1 G1 X10. F100.\nN20 Y10.\nN30 Y20.\nN40 M30", final_machine="X0 Y20",
)
case(
    "setting 52 is how far above R a peck of G83 draws back",
    control=HAAS, source="HNGC p.382, setting 52", evidence="maker's manual",
    params={"52": 2},
    program="O1\nN10 G0 Z10.\nN20 G83 G99 Z-4. R1. Q3. F100.\nN30 G80\nN40 M30",
    moves="R Z10\nR Z1\nF Z-2\nR Z3\nR Z-1.5\nF Z-4\nR Z1",
)
case(
    "without it the peck draws back to R: 99 seconds with a slow rapid", pins="peck_above", **KNOWN,
    setup={"machine": "mill", "rapid": {"Z": 60}},
    program="O1\nN10 G90 G83 Z-10. R0 Q4. F10.\nN20 M30", time=99,
)
case(
    "M96 goes to N of P while the input of Q is 0", pins="roles:M96=jump-unless-input", **M96,
    program="O1\nN10 M96 P40 Q8\nN20 #100=1\nN30 M30\nN40 #100=2\nN50 M30", runs="N10 N40 N50",
)
case(
    "and on to the next block while it is 1", **M96, inputs={"signals": {11008: 1}},
    program="O1\nN10 M96 P40 Q8\nN20 #100=1\nN30 M30\nN40 #100=2\nN50 M30", runs="N10 N20 N30",
)
case(
    "a program that only loops for an input waits for it", **M96, stop="waiting",
    program="O1\nN10 M96 P10 Q27\nN20 M30", runs="N10*2",
)
case(
    "a part that is done again before each look goes on", **M96, max_blocks=6, stop="limit",
    program="O1\nN10 #100=#100+1\nN20 M96 P10 Q27\nN30 M30", runs="(N10 N20)*3",
)
case(
    "M96 to a number that its program does not have", **KNOWN,
    program="O1\nN10 M96 P40 Q8\nN20 M30", runs="", alarm="jump-target-not-found", number="539", at="O1 N10", word="P40",
)
case(
    "M96 without P is 313, as M97 is", **KNOWN,
    program="O1\nN10 M96 Q8\nN20 M30", runs="", alarm="program-number-missing", number="313", at="O1 N10", word="M96",
)
case(
    "M96 without Q does not say which input", **KNOWN,
    program="O1\nN10 M96 P40\nN40 M30", runs="", alarm="statement-format", at="O1 N10", word="M96",
)
case(
    "there are 256 inputs", **KNOWN,
    program="O1\nN10 M96 P40 Q256\nN40 M30", runs="", alarm="illegal-variable", number="503", at="O1 N10", word="Q256",
)
case(
    "an input of a computed number is not read", control=HAAS, source="policy, nobody says", evidence="inferred",
    program="O1\nN10 M96 P40 Q#1\nN40 M30", runs="", alarm="code-not-computed", at="O1 N10", word="Q#1",
)
