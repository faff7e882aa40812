"""Haas NGC: the macros of its manual: arguments, expressions, branches, loops."""

from conformance import case

HAAS = "haas-ngc"


def manual(page: str, **said: str) -> dict[str, str]:
    return {"control": HAAS, "source": f"HNGC p.{page}", "evidence": "maker's manual", **said}


# GOTO
case(
    "GOTO#1 rounds 4.49 to N4", **manual("226, computed branch"),
    program="O1\nN10 #1=4.49\nN20 GOTO#1\nN30 M0\nN4 M30\nN5 M30", runs="N10 N20 N4",
)
case(
    "GOTO#1 rounds 4.5 to N5", **manual("226, computed branch"),
    program="O1\nN10 #1=4.5\nN20 GOTO#1\nN30 M0\nN4 M30\nN5 M30", runs="N10 N20 N5",
)
case(
    "a branch by the digit of an argument, as the manual's O50002", **manual("226, O50002"),
    program="""
        O1
        N10 G65 P50002 D2.
        N20 M30
        O50002
        N30 IF [[#7 NE #0] AND [#7 GE 0] AND [#7 LE 9]] GOTO 99
        N40 #3000=1 (INVALID DIGIT)
        N99 #7=FIX[#7]
        N100 GOTO#7
        N1 M99
        N2 M99
    """,
    runs="N10 N30 N99 N100 N2 N20",
)
case(
    "without its argument that program raises 1001", **manual("226, O50002"),
    program="""
        O1
        N10 G65 P50002
        N20 M30
        O50002
        N30 IF [[#7 NE #0] AND [#7 GE 0] AND [#7 LE 9]] GOTO 99
        N40 #3000=1 (INVALID DIGIT)
        N99 M99
    """,
    runs="N10 N30 N40", alarm="user-alarm", number="1001", at="O50002 N40",
)
case(
    "GOTO reads inputs in an expression", **manual("227, GOTO [[#1030*2]+#1031]", evidence="secondary"),
    inputs={"signals": {1030: 1, 1031: 1}},
    program="O1\nN10 GOTO [[#1030*2]+#1031]\nN1 M0\nN2 M0\nN3 M30", runs="N10 N3",
)

# Conditional M99
case(
    "the words before the condition of M99 are executed whether it holds or not", pins="conditional_return",
    **manual("227, G00 X0 Y0 [#1EQ#2] M99 P5"),
    program="O1\nN10 #1=1\nN20 G00 X3. Y4. [#1EQ#2] M99 P5\nN30 G0 X6.\nN40 M30\nN5 M30",
    runs="N10 N20 N30 N40", moves_x=[3, 6],
)
case(
    "and M99 goes to its block where the condition holds", **manual("227, G00 X0 Y0 [#1EQ#2] M99 P5"),
    program="O1\nN20 G00 X3. Y4. [#1EQ#2] M99 P5\nN30 G0 X6.\nN40 M30\nN5 M30", runs="N20 N5", moves_x=[3],
)
case(
    "M99 P is an unconditional branch, as GOTO is", **manual("226, M99 P15"),
    program="O1\nN10 M99 P15\nN12 M0\nN15 M30", runs="N10 N15",
)
case(
    "a condition after words needs M99", **manual("227", evidence="inferred"),
    program="O1\nN10 G0 X5. [1 EQ 1] M8\nN20 M30", runs="", alarm="statement-format", at="O1 N10",
)
case(
    "the M code before the condition of M99 is sent in any case", **manual("227", evidence="inferred"),
    program="O1\nN10 G0 X1. [0] M99 P30\nN20 G0 X2. [1] M99 P40\nN30 M30\nN40 M30", runs="N10 N20 N40", moves_x=[1, 2],
)

# IF THEN
case(
    "THEN takes a move", **manual("228, THEN G01 X#24 Y#26 F#9"),
    program="O1\nN10 G65 P2 X5. Z6. F100.\nN20 M30\nO2\nN30 IF [#24 NE #0] THEN G01 X#24 Y#26 F#9\nN40 M99",
    runs="N10 N30 N40 N20", moves="F X5 Y6",
)
case(
    "and nothing moves where the condition does not hold", **manual("228, the remainder of the IF block is ignored"),
    program="O1\nN10 G65 P2 Z6. F100.\nN20 M30\nO2\nN30 IF [#24 NE #0] THEN G01 X#24 Y#26 F#9\nN40 M99",
    runs="N10 N30 N40 N20", moves="",
)
case(
    "THEN takes an assignment and M99 after it", pins="if_form", **manual("228, THEN #101=0.0 M99"),
    program="""
        O1
        N10 #101=5
        N20 M98 P2
        N30 M30
        O2
        N40 #1=180
        N50 IF [#1 GE 180] THEN #101=0.0 M99
        N60 #101=7
        N70 M99
    """,
    runs="N10 N20 N40 N50 N30", vars={10101: 0},
)
case(
    "and neither where the condition does not hold", **manual("228, THEN #101=0.0 M99"),
    program="""
        O1
        N10 #101=5
        N20 M98 P2
        N30 M30
        O2
        N40 #1=179
        N50 IF [#1 GE 180] THEN #101=0.0 M99
        N60 #101=7
        N70 M99
    """,
    runs="N10 N20 N40 N50 N60 N70 N30", vars={10101: 7},
)
case(
    "THEN takes an assignment and a move after it", **manual("228", evidence="inferred"),
    program="O1\nN10 IF [1] THEN #1=5. G0 X6.\nN20 M30", runs="N10 N20", vars={1: 5}, moves_x=[6],
)
case(
    "THEN #590=0.0 sets a variable where it is too large", **manual("228, IF [#590 GT 100] THEN #590=0.0"),
    program="O1\nN10 #590=101\nN20 IF [#590 GT 100] THEN #590=0.0\nN30 #591=99\nN40 IF [#591 GT 100] THEN #591=0.0\nN50 M30",
    vars={10590: 0, 10591: 99},
)
case(
    "IF [#9NE#0] GOTO3 passes over the alarm where F is given", **manual("228, N1 IF [#9NE#0] GOTO3"),
    program="O1\nN10 G65 P2 F5.\nN20 M30\nO2\nN1 IF [#9NE#0] GOTO3\nN2 #3000=11(NO FEED RATE)\nN3 M99",
    runs="N10 N1 N3 N20",
)
case(
    "and raises 1011 where it is not", **manual("228, N2 #3000=11"),
    program="O1\nN10 G65 P2\nN20 M30\nO2\nN1 IF [#9NE#0] GOTO3\nN2 #3000=11(NO FEED RATE)\nN3 M99",
    runs="N10 N1 N2", alarm="user-alarm", number="1011", at="O2 N2",
)
case(
    "a value that is not 0 holds, and the undefined one does not", **manual("227, IF [#1] GOTO5"),
    program="O1\nN10 IF [#1] GOTO 50\nN20 #1=0.1\nN30 IF [#1] GOTO 60\nN40 M0\nN50 M0\nN60 M30", runs="N10 N20 N30 N60",
)

# Loops
case(
    "DO without WHILE repeats for ever on the Haas", **manual("229, an infinite loop"), max_blocks=6, stop="limit",
    program="O1\nN10 DO1\nN20 #1=#1+1\nN30 END1\nN40 M30", runs="(N10 N20 N30)*2",
)
case(
    "three loops stand in each other", pins="max_loop_number max_loops", **manual("229, no more than three nested loops"),
    program="""
        O1
        N10 WHILE [#1 LT 1] DO1
        N20 WHILE [#2 LT 1] DO2
        N30 WHILE [#3 LT 1] DO3
        N40 #3=1
        N50 END3
        N60 #2=1
        N70 END2
        N80 #1=1
        N90 END1
        N100 M30
    """,
    vars={1: 1, 2: 1, 3: 1}, stop="end",
)
case(
    "DO4 is no loop of the Haas", **manual("229, the value of n is 1-3"),
    program="O1\nN10 DO4\nN20 END4\nN30 M30", runs="", alarm="illegal-loop-number", at="O1 N10",
)
case(
    "each subprogram has three loops of its own", pins="loops_count_across_calls",
    **manual("229, each subprogram can have up to three levels"),
    program="""
        O1
        N10 WHILE [#1 LT 1] DO1
        N20 M98 P2
        N30 END1
        N40 M30
        O2
        N50 DO1
        N60 DO2
        N70 DO3
        N80 #1=1
        N90 GOTO 120
        N100 END3
        N110 END2
        N115 END1
        N120 M99
    """,
    runs="N10 N20 N50 N60 N70 N80 N90 N120 N30 N10 N40",
)
case(
    "two loops one after the other share a number", **manual("229, they can use the same nesting index"),
    program="O1\nN10 WHILE [#1 LT 1] DO1\nN20 #1=1\nN30 END1\nN40 WHILE [#2 LT 1] DO1\nN50 #2=1\nN60 END1\nN70 M30",
    runs="N10 N20 N30 N10 N40 N50 N60 N40 N70",
)
case(
    "GOTO leaves a loop", **manual("229, jump out of a region"),
    program="O1\nN10 DO1\nN20 IF [1] GOTO 40\nN30 END1\nN40 M30", runs="N10 N20 N40",
)

# Arguments
case(
    "the letters of G65 and their variables", **manual("196, alphabetic addressing"),
    program="O1\nN10 G65 P2 A1. B2. C3. D4. E5. F6. H7. I8. J9. K10. M11. Q12. R13. S14. T15. U16. V17. W18. X19. Y20. Z21.\nN20 M30\nO2\nN30 M99",
    arguments={1: 1, 2: 2, 3: 3, 7: 4, 8: 5, 9: 6, 11: 7, 4: 8, 5: 9, 6: 10, 13: 11, 17: 12, 18: 13, 19: 14, 20: 15, 21: 16, 22: 17, 23: 18, 24: 19, 25: 20, 26: 21},
    runs="N10 N30 N20",
)
case(
    "sets of I J K go to #4 and on", pins="argument_sets", **manual("198, G65 P2000 I1 J2 K3 I4 J5 K6"),
    program="O1\nN10 G65 P2 I1 J2 K3 I4 J5 K6\nN20 M30\nO2\nN30 M99",
    arguments={4: 0.001, 5: 0.002, 6: 0.003, 7: 0.004, 8: 0.005, 9: 0.006}, runs="N10 N30 N20",
)
case(
    "arguments without a point: lengths count thousandths in metric, D E F H M S T whole numbers",
    **manual("197, integer argument passing"),
    program="O1\nN10 G65 P2 A1 B2 C3 D1 E1 F1 H1 I1 J1 K1 M1 Q1 R1 S1 T1 U1 V1 W1 X1 Y1 Z1\nN20 M30\nO2\nN30 M99",
    arguments={1: 0.001, 2: 0.002, 3: 0.003, 7: 1, 8: 1, 9: 1, 11: 1, 4: 0.001, 5: 0.001, 6: 0.001, 13: 1, 17: 0.001, 18: 0.001, 19: 1, 20: 1, 21: 0.001, 22: 0.001, 23: 0.001, 24: 0.001, 25: 0.001, 26: 0.001},
    runs="N10 N30 N20",
)
for letter in ("G1.", "N1"):
    case(
        f"{letter[0]} is no argument of G65", **manual("198: G, L, N, O or P"),
        program=f"O1\nN10 G65 P2 {letter}\nN20 M30\nO2\nN30 M99", runs="", alarm="illegal-argument", number="529", at="O1 N10",
    )
case(
    "the arguments are set on the first repetition alone", **manual("199, L"),
    program="O1\nN10 G65 P2 L3 A1.\nN20 M30\nO2\nN30 #100=#100+#1\nN40 #1=#1+1\nN50 M99", vars={10100: 6},
)
case(
    "M98 keeps the locals of its caller", **manual("199, M97 or M98 does not nest the local variables"),
    program="O1\nN10 #1=5\nN20 M98 P2\nN30 #2=#1\nN40 M30\nO2\nN50 #1=#1+1\nN60 M99", vars={1: 6, 2: 6},
)
case(
    "G65 has locals of its own, and the caller's come back", **manual("198, nesting of local variables"),
    program="O1\nN10 #1=5\nN20 G65 P2 B1.\nN30 M30\nO2\nN40 #100=#1\nN50 #1=7\nN60 M99", vars={1: 5, 10100: None},
)
case(
    "an array is filled by the manual's O0300", **manual("225, G65 P300 B501. S5 V1."),
    program="""
        O1
        N10 G65 P300 B501. S5 V1.
        N20 M30
        O300
        N1 IF [#2 NE #0] GOTO2
        N30 #3000=1 (BASE VARIABLE NOT GIVEN)
        N2 IF [#19 NE #0] GOTO3
        N40 #3000=2 (SIZE OF ARRAY NOT GIVEN)
        N3 WHILE [#19 GT 0] DO1
        N50 #19=#19-1
        N60 #[#2+#19]=#22
        N70 END1
        N80 M99
    """,
    vars={10501: 1, 10502: 1, 10503: 1, 10504: 1, 10505: 1, 10506: None},
)
case(
    "and says what is missing", **manual("225, #3000=2"),
    program="O1\nN10 G65 P300 B501.\nN20 M30\nO300\nN2 IF [#19 NE #0] GOTO3\nN40 #3000=2 (SIZE OF ARRAY NOT GIVEN)\nN3 M99",
    runs="N10 N2 N40", alarm="user-alarm", number="1002", at="O300 N40",
)
case(
    "a line of holes is drilled by a loop in a macro, as the manual's O9010",
    **manual("233, O09010"), params={"162": 1},
    program="""
        O1
        N10 G00 G90 X1.0 Y1.0 Z.05 S1000 M03
        N20 G65 P9010 X.5 Y.25 Z.05 F10. T2
        N30 M30
        O9010
        N40 F#9
        N50 WHILE [#20 GT 0] DO1
        N60 G91 G81 Z#26
        N70 #20=#20-1
        N80 IF [#20 EQ 0] GOTO5
        N90 G00 X#24 Y#25
        N5 END1
        N100 M99
    """,
    runs="N10 N20 N40 (N50 N60 N70 N80 N90 N5) N50 N60 N70 N80 N5 N50 N100 N30",
)

# Expressions
for text, value in (("2 EQ 2", 1), ("2 NE 2", 0), ("3 GT 2", 1), ("3 LT 2", 0), ("2 GE 2", 1), ("3 LE 2", 0)):
    case(
        f"[{text}] is {value}", **manual("222, Boolean operators"),
        program=f"O1\nN10 #1=[{text}]\nN20 M30", vars={1: value},
    )
for text, value in (
    ("27 MOD 20", 7), ("-[COS[60]]", -0.5), ("+1.23", 1.23), ("#2*3", 6), ("#2/4", 0.5), ("1.0 OR 2.0", 3), ("5 AND 3", 1), ("5 XOR 3", 6),
    ("SIN[30]", 0.5), ("TAN[45]", 1), ("ATAN[1]", 45), ("SQRT[16]", 4), ("ABS[-2]", 2), ("ROUND[1.714]", 2), ("ROUND[3.1416]", 3),
    ("FIX[3.54]", 3), ("ROUND[3.54]", 4), ("ACOS[0.5]", 60), ("ASIN[0.5]", 30), ("#[1+1]", 2),
):
    case(
        f"{text} is {value}", **manual("220 to 223, functions and operators"),
        program=f"O1\nN10 #2=2\nN20 #1={text}\nN30 M30", vars={1: value},
    )
case(
    "#[#1] is the variable of the number in #1", **manual("218, #[#1]=3.5 + #1"),
    program="O1\nN10 #1=3\nN20 #[#1]=3.5 + #1\nN30 M30", vars={1: 3, 3: 6.5},
)
case(
    "a code, an axis and a feed are replaced by variables", **manual("219, G#1 X[#1+#2] Y#3 F#4"),
    program="O1\nN10 #1=1\nN20 #2=1.5\nN30 #3=3.7\nN40 #4=20\nN50 G#1 X[#1+#2] Y#3 F#4\nN60 M30", moves="F X2.5 Y3.7",
)
case(
    "a value and an expression take a minus before them", **manual("219, A-#101, Z-[SIN[#1]]"),
    program="O1\nN10 #101=2\nN20 #1=30\nN30 G0 X-#101 Z-[SIN[#1]]\nN40 M30", moves="R X-2 Z-0.5",
)
case(
    "D by a variable beyond the offsets alarms", **manual("220: the tool diameter numbers range from 0 to 200"),
    program="O1\nN10 #1=250\nN20 D#1\nN30 M30", runs="N10", alarm="radius-offset-number", at="O1 N20", word="D#1",
)
case(
    "X of a variable is rounded to thousandths in metric", pins="computed_lengths", **manual("220, .123 on the X axis"),
    program="O1\nN10 #1=.123456\nN20 G01 X#1 F100.\nN30 #2=#5021\nN40 M30", vars={2: 0.123},
)
case(
    "and to ten-thousandths in inches", **manual("220, .1235"), params={"9": 1},
    program="O1\nN10 #1=.123456\nN20 G01 X#1 F100.\nN30 #2=#5021\nN40 M30", vars={2: 0.1235},
)
case(
    "A of a variable is rounded to thousandths in inches too", **manual("221, 2.007"), params={"9": 1},
    program="O1\nN10 #1=1.00333\nN20 G00 A[#1+#1]\nN30 #2=#5024\nN40 M30", vars={2: 2.007},
)
case(
    "D[1.67] is D2", **manual("221, D[1.67]"), setup={"radius_offsets": {1: 1, 2: 5}},
    program="O1\nN10 D[1.67]\nN20 #1=#4107\nN30 M30", vars={1: 2},
)
case(
    "an empty variable moves nothing", **manual("220, G00 X1.0 Y#1"),
    program="O1\nN10 G00 X1.0 Y#1\nN20 M30", moves="R X1",
)
case(
    "AND and EQ stand together in a condition", **manual("222, IF [#10001 AND #10002 EQ #10003] GOTO1", evidence="inferred"),
    program="O1\nN10 #10001=1\nN20 #10002=1\nN30 #10003=1\nN40 IF [#10001 AND #10002 EQ #10003] GOTO 60\nN50 M0\nN60 M30",
    runs="N10 N20 N30 N40 N60",
)
case(
    "WHILE compares until it does not hold", **manual("222, WHILE [#10101 LT 10] DO1"),
    program="O1\nN10 #10101=8\nN20 WHILE [#10101 LT 10] DO1\nN30 #10101=#10101+1\nN40 END1\nN50 M30",
    runs="N10 (N20 N30 N40)*2 N20 N50",
)
