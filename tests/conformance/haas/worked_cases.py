"""Haas NGC: its worked cases."""

from conformance import case

HAAS = "haas-ngc"
M97 = {"control": HAAS, "source": "H96 p.217, M97", "evidence": "secondary"}
M99 = {"control": HAAS, "source": "HDIY, M99 P", "evidence": "maker's manual"}
VALUES = {"control": HAAS, "source": "HDIY, conditional expressions", "evidence": "maker's manual"}
KNOWN = {"control": HAAS, "source": "general knowledge of the Haas mill", "evidence": "inferred"}
FLOAT = {"162": 1}

case(
    "five digits of P are one number, not a count and a number (HAAS-02)", pins="max_words max_block_length g_codes program_word max_program_digits",
    control=HAAS, source="H96 p.217: O00012, five digits", evidence="secondary", params=FLOAT,
    program="O00001\nM98 P51000\nM30\nO51000\nG0 X7\nM99\nO01000\nG0 X8\nM99", moves_x=[7],
)
case(
    "M99 P after the call stands for FANUC's M99 P in the subprogram (HAAS-04)", pins="return_with_p power_on:G91", **M99, params=FLOAT,
    program="O00001\nM98 P2\nN51 M99 P100\nG0 X1\nN100 G0 X2\nM30\nO00002\nG0 X5\nM99",
    runs="N51 N100", moves_x=[5, 2],
)
case(
    "IF takes any value that is not 0 (HAAS-06)", pins="statements if_form max_condition_length conditions:values", **VALUES, params=FLOAT,
    program="O00001\n#1=0.5\nIF [#1] GOTO 30\nG0 X1\nN30 G0 X2\nM30", moves_x=[2],
)
case(
    "the arguments of G65 are set before its first pass alone (HAAS-07)", pins="roles:G65=macro-call",
    control=HAAS, source="HAA; H96 p.118", evidence="secondary",
    program="O00001\nG65 P9000 L3 A1.\nM30\nO09000\nG0 X#1\n#1=#1+1\nM99", moves_x=[1, 2, 3],
)
case(
    "M99 starts the main program over (HAAS-09)", pins="main_return", **KNOWN, params=FLOAT,
    program="O00001\nG0 X1\nG0 X2\nM99", max_cycles=2, stop="cycles", moves_x=[1, 2, 1, 2],
)
case(
    "a program that is not in the memory is 314 (HAAS-10)", **KNOWN,
    program="O00001\nN10 M98 P77\nM30", runs="", alarm="program-not-found", number="314", at="O00001 N10",
)
case(
    "nine subprograms may be open, the tenth is 307 (HAAS-12)", pins="self_call max_nesting max_total_nesting", **KNOWN, params=FLOAT,
    program="O00001\nM98 P2\nM30\nO00002\nG0 X1\nN20 M98 P2\nM99",
    alarm="nesting-too-deep", number="307", at="O00002 N20", moves_x=[1] * 9,
)
case(
    "M97 in a called program takes that program's N (HAAS-13)", pins="roles:M97=local-call", **M97, params=FLOAT,
    program="O00001\nM98 P2\nN100 G0 X99\nM30\nO00002\nM97 P100\nG0 X2\nM99\nN100 G0 X3\nM99",
    moves_x=[3, 2, 99], tree="M98:O00002(M97:O00002)",
)


# Edges: the programs as they were handed over, with the point that their numbers have.
def edge(page: str) -> dict[str, str]:
    return {"control": HAAS, "source": f"HNGC p.{page}", "evidence": "maker's manual"}


case(
    "G51 P2. doubles the lengths (HAAS3-01)", control=HAAS, source="HML p.136: G51 P2.", evidence="secondary",
    program="O1\nN10 G51 X0 Y0 P2.\nN20 G0 X10.\nN30 G50\nN40 M30", runs="N10 N20 N30 N40", moves_x=[20],
)
case(
    "P0.5 of G82 waits half a second (HAAS3-02)", **edge("295, G82"),
    program="O1\nN10 G0 X1. Z5.\nN20 G82 X2. R1. Z-2. P0.5 F100.\nN30 G80\nN40 M30",
    moves="R X1 Z5\nR X2\nR Z1\nF Z-2\nW 0.5\nR Z5",
)
case(
    "#11000 is an input that is 0 where nothing says otherwise (HAAS3-04)", **edge("208, discrete inputs"),
    program="O1\nN10 #1=#11000\nN20 G0 X1.\nN30 M30", vars={1: 0}, moves_x=[1],
)
case(
    "an array is filled through #[#2+#19] (HAAS3-06)", **edge("225, O0300"),
    program="O1\nG65 P300 B501. S5 V1.\nG0 X#505\nM30\nO300\nN3 WHILE [#19 GT 0] DO1\n#19=#19-1\n#[#2+#19]=#22\nEND1\nM99", moves_x=[1],
)
case(
    "an empty variable leaves its word out (HAAS3-08)", **edge("220, undefined variables"),
    program="O1\nN10 G0 X1. Z#1\nN20 M30", moves="R X1",
)
case(
    "M97 L runs its part that often (HAAS3-09)", **edge("358, M97"),
    program="O1\nG0\nM97 P1000 L5\nX9.\nM30\nN1000 G91 X1.\nG90\nM99", moves_x=[1, 2, 3, 4, 5, 9],
)
case(
    "a conditional M99 P goes on in the running program (HAAS3-11)", **edge("227, conditional branching"),
    program="O1\nM98 P2\nG0 X9.\nM30\nO2\n#101=0\nN10 #101=#101+1\nG0 X#101\n[#101 LT 3] M99 P10\nM99", moves_x=[1, 2, 3, 9],
)
