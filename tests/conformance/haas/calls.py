"""Haas NGC: M96 to M99, G65 and aliases as its manual has them."""

from conformance import case

HAAS = "haas-ngc"


def manual(page: str, **said: str) -> dict[str, str]:
    return {"control": HAAS, "source": f"HNGC p.{page}", "evidence": "maker's manual", **said}


case(
    "M97 P100 L4 runs N100 four times, as the manual's O00001", pins="roles:M97=local-call",
    **manual("359, O00001"),
    program="O00001\nN10 M97 P100 L4\nN20 M30\nN100 M00\nN110 M99", runs="N10 (N100 N110)*4 N20", m=[0, 0, 0, 0],
)
case(
    "M98 P100 L4 runs O00100 four times, as the manual's O00002", pins="program_word",
    **manual("359, O00002"),
    program="O00002\nN10 M98 P100 L4\nN20 M30\nO00100\nN100 M00\nN110 M99", runs="N10 (N100 N110)*4 N20",
)
case(
    "the holes of a cycle stand in a subprogram by M97, and each call drills them",
    **manual("152, O40009"), params={"9": 1},
    program="""
        O40009
        N10 G00 G90 X1.5 Y-0.5
        N20 G81 G99 Z-0.26 R0.1 F7. L0
        N30 M97 P1000
        N40 G00 Z0.1
        N50 M30
        N1000 X0.5 Y-0.75
        N1010 X4.5 Y-2.25
        N1020 M99
    """,
    runs="N10 N20 N30 N1000 N1010 N1020 N40 N50",
)
case(
    "L of M97 goes to 99", pins="max_repeats", **manual("358: 1-99"),
    program="O1\nN10 M97 P100 L100\nN20 M30\nN100 M99", runs="", alarm="repeat-count-digits", at="O1 N10",
)
case(
    "the place after the call jumps on: M99 P100 in the caller", pins="return_with_p", **manual("360, O0001"),
    program="O0001\nN10 M98 P2\nN51 M99 P100\nN60 M0\nN100 M30\nO0002\nN20 M99", runs="N10 N20 N51 N100",
)
case(
    "M99 starts the main program of the Haas over", pins="main_return", **manual("360, M99 in the main program"),
    program="O1\nN10 G0 X1.\nN20 M99", max_cycles=3, stop="cycles", runs="(N10 N20)*3",
)
case(
    "/M99 before M30 makes a subprogram of a main program", **manual("193, block delete"),
    program="O1\nN10 M98 P2\nN20 M30\nO2\nN30 G0 X1.\nN40 /M99\nN50 M30", runs="N10 N30 N40 N20",
)
case(
    "and with block delete it ends the program", **manual("193, block delete"), skip=[1],
    program="O1\nN10 M98 P2\nN20 M30\nO2\nN30 G0 X1.\nN40 /M99\nN50 M30", runs="N10 N30 N50",
)
case(
    "a subprogram without M99 is 312", pins="missing_end", **manual("134, alarm 312"),
    program="O1\nN10 M98 P2\nN20 M30\nO2\nN30 G0 X1.", alarm="end-of-record", number="312", moves_x=[1],
)
case(
    "a subprogram that is not there is 314", **manual("359; 314, alarm 314"),
    program="O1\nN10 M98 P77\nN20 M30", runs="", alarm="program-not-found", number="314", at="O1 N10", word="P77",
)
case(
    "a macro that is not there is 314", **manual("232, an alarm occurs; 314, alarm 314"),
    program="O1\nN10 G65 P77\nN20 M30", runs="", alarm="program-not-found", number="314", at="O1 N10",
)
case(
    "M96 goes on where the input is 1",
    pins="user_alarm_numbers", **manual("357, O00096"),
    inputs={"signals": {11018: 1}},
    program="O1\nN5 M96 P10 Q18\nN7 M99 P100\nN10 G04 P1.\nN20 M99 P5\nN100 #3000=10(M-FIN INPUT=1)\nN110 M30",
    runs="N5 N7 N100", alarm="user-alarm", number="1010", at="O1 N100",
)
case(
    "and jumps while it is 0", **manual("357, O00096"), max_blocks=6, stop="limit",
    program="O1\nN5 M96 P10 Q18\nN7 M99 P100\nN10 G04 P1.\nN20 M99 P5\nN100 M30", runs="(N5 N10 N20)*2",
)
case(
    "M96 takes Q to 255", **manual("357, Q: 0 to 255"), inputs={"signals": {11255: 1}},
    program="O1\nN10 M96 P30 Q255\nN20 M30\nN30 M0", runs="N10 N20",
)
case(
    "M96 takes no Q256", **manual("357, Q: 0 to 255"),
    program="O1\nN10 M96 P30 Q256\nN20 M30\nN30 M0", runs="", alarm="illegal-variable", number="503", at="O1 N10", word="Q256",
)
case(
    "nine macros nest", pins="max_macro_nesting", **manual("232, nested up to 9 times"),
    program="O1\nN10 G65 P2\nN20 M30\nO2\nN30 #100=#100+1\nN40 IF [#100 EQ 9] GOTO 60\nN50 G65 P2\nN60 M99",
    runs="N10 (N30 N40 N50)*8 N30 N40 N60*9 N20", vars={10100: 9},
)
case(
    "G06 is an alias of O9010 and passes its words", **manual("233, G06 X.5 Y.25"), params={"9010": 6},
    program="O1\nN10 G06 X.5 Y.25 Z.05 F10. T10\nN20 M30\nO9010\nN30 M99",
    runs="N10 N30 N20", arguments={24: 0.5, 25: 0.25, 26: 0.05, 9: 10, 20: 10}, calls="G-code:O9010",
)
case(
    "an alias of 0 calls nothing", **manual("234: 0 disables"), params={"9000": 0},
    program="O1\nN10 M0\nN20 M30\nO9000\nN30 M99", runs="N10 N20",
)
for code in (65, 66, 67):
    case(
        f"G{code} cannot be an alias", **manual("234: G00, G65, G66, and G67 cannot be aliased"), params={"9010": code},
        program=f"O1\nN10 G{code} P2\nN20 M30\nO2\nN25 M99\nO9010\nN30 M99", runs="", alarm="code-may-not-call", at="O1 N10", word=f"G{code}",
    )
case(
    "an alias goes to G255", **manual("234: between 1 and 255"), params={"9019": 255},
    program="O1\nN10 G255 A1.\nN20 M30\nO9019\nN30 M99", runs="N10 N30 N20", arguments={1: 1},
)
case(
    "an alias that is missing is 314", **manual("234, an alarm; 314, alarm 314"), params={"9010": 6},
    program="O1\nN10 G06 X1.\nN20 M30", runs="", alarm="program-not-found", number="314", at="O1 N10",
)
case(
    "#3006 stops as M00 does, and goes on", **manual("212, #3006"),
    program="O1\nN10 #3006=1 (LOOK)\nN20 G0 X1.\nN30 M30", runs="N10 N20 N30", messages=["LOOK"],
)
case(
    "one M code stands in a block", pins="m_codes_per_block extra_m_codes", **manual("345: only one M-code is allowed per line"),
    program="O1\nN10 M3 M8\nN20 M30", runs="", alarm="illegal-m-combination", at="O1 N10",
)
