"""GSK 980: G65 H, macro statements of type A."""

from conformance import case

case(
    "H01, H02 and H84 make a loop (TD-006)",
    pins="roles:G65=macro-call",
    control="gsk-980tdi",
    source="TDi28, H table",
    evidence="maker's manual",
    program="""
        O1
        G65 H01 P#100 Q0
        N10 G65 H02 P#100 Q#100 R1
        G0 X#100
        G65 H84 P10 Q#100 R3
        M30
    """,
    moves_x=[1, 2, 3],
)

case(
    "H80 jumps (TD-007)",
    control="gsk-980tdi",
    source="TDi28, H table",
    evidence="maker's manual",
    program="""
        O1
        G0 X1
        G65 H80 P120
        G0 X9
        N120 G0 X2
        M30
    """,
    moves_x=[1, 2],
)

case(
    "H99 P15 stops with the alarm 5915 (TD-008)",
    pins="h99_offset",
    control="gsk-980tdi",
    source="TDi28, H table",
    evidence="maker's manual",
    program="""
        O1
        G0 X1
        G65 H99 P15(/TEXT)
        M30
    """,
    moves_x=[1],
    alarm="user-alarm",
    number="5915",
    at="O1",
)

case(
    "H05 by zero alarms (TD-022)",
    control="gsk-980tdi",
    source="MDia 105 of the 980MDi",
    evidence="secondary",
    program="""
        O1
        G65 H05 P#100 Q5 R0
        M30
    """,
    moves_x=[],
    alarm="division-by-zero",
    number="0105",
    at="O1",
)

case(
    "H99 P100 is no user alarm (TD-023)",
    control="gsk-980tdi",
    source="MDia 126 of the 980MDi",
    evidence="secondary",
    program="""
        O1
        G65 H99 P100
        M30
    """,
    moves_x=[],
    alarm="illegal-user-alarm",
    number="0126",
    at="O1",
)

case(
    "H27 is the root of two squares, and H26 multiplies and divides (TD-027)",
    control="gsk-980tdi",
    source="TDi28, H table",
    evidence="maker's manual",
    program="""
        O1
        #101=3
        #102=4
        G65 H27 P#103 Q#101 R#102
        G0 X#103
        #104=10
        G65 H26 P#104 Q#101 R#102
        G0 X#104
        M30
    """,
    moves_x=[5, 7.5],
)

case(
    "H31 takes its angle in degrees (TD-028)",
    control="gsk-980tdi",
    source="TDi28, H table",
    evidence="maker's manual",
    program="""
        O1
        G65 H31 P#101 Q100 R30
        G0 X#101
        M30
    """,
    moves_x=[50],
)

TA, T, TDI, MDI = "gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi"
FAMILY_980 = [TDI, MDI]
MANUAL = "maker's manual"
INFERRED = "inferred"


def macro_call(call, macro="N30 M99", name="O2"):
    """Return a main program O1 of one macro call, and the macro."""
    return f"O1\nN10 {call}\nN20 M30\n{name}\n{macro}\n"


def result(claim, words, value, **row):
    """Write a row of one G65 H block and its result in #100; #101=12 and #102=-4.5 before it."""
    row = {"source": "TDi28, table of G65 H", "evidence": MANUAL, **row}
    case(
        f"GSK 980TDi: {claim}",
        pins="h_codes",
        control=TDI, program=f"O1\nN10 G65 {words}\nN20 M30\n",
        variables={100: 3, 101: 12, 102: -4.5}, runs="N10 N20", vars={100: value}, **row,
    )


result("H01 assigns a constant", "H01 P#100 Q1005", 1005)
result("H01 assigns a variable", "H01 P#100 Q#101", 12)
result("H01 assigns a variable with its sign changed", "H01 P#100 Q-#102", 4.5)
result("H1 is H01", "H1 P#100 Q7", 7)
result("H02 adds", "H02 P#100 Q#101 R15", 27)
result("H03 subtracts", "H03 P#100 Q#101 R#102", 16.5)
result("H03 subtracts R from Q", "H03 P#100 Q1 R3", -2)
result("H04 multiplies", "H04 P#100 Q#101 R#102", -54)
result("H05 divides and keeps the decimals", "H05 P#100 Q#101 R5", 2.4)
result("H11 is a bitwise OR", "H11 P#100 Q#101 R10", 14)
result("H12 is a bitwise AND", "H12 P#100 Q#101 R10", 8)
result("H13 is a bitwise exclusive OR", "H13 P#100 Q#101 R10", 6)
result("H21 takes the square root", "H21 P#100 Q2", 1.4142136)
result("H22 takes the absolute value", "H22 P#100 Q#102", 4.5)
result("H23 takes the remainder", "H23 P#100 Q#101 R5", 2)
result("H23 of a negative value is negative", "H23 P#100 Q-7 R3", -1)
result("H23 keeps decimals", "H23 P#100 Q7.5 R2", 1.5)
result("H24 reads decimal digits that stand in four bits each", "H24 P#100 Q24", 18, evidence=INFERRED)
result("H25 writes decimal digits in four bits each", "H25 P#100 Q18", 24, evidence=INFERRED)
result("H26 multiplies its own variable by Q and divides by R", "H26 P#100 Q#101 R8", 4.5)
result("H27 takes the root of the sum of the squares", "H27 P#100 Q5 R#101", 13)
result("H31 is Q times the sine of R in degrees", "H31 P#100 Q#101 R150", 6)
result("H32 is Q times the cosine of R in degrees", "H32 P#100 Q#101 R60", 6)
result("H33 is Q times the tangent of R in degrees", "H33 P#100 Q#101 R45", 12)
result("H34 is the angle in degrees whose tangent is Q over R", "H34 P#100 Q#101 R#101", 45)
result("H34 keeps its decimals", "H34 P#100 Q1 R2", 26.5650512)
case(
    "GSK 980TDi: G65 H calls no program and opens no level",
    control=TDI, source="TDi28, G65 H", evidence=MANUAL,
    program="O1\nN10 #1=5\nN20 G65 H02 P#2 Q#1 R1\nN30 M30\n",
    runs="N10 N20 N30", calls="", vars={1: 5, 2: 6},
)
case(
    "GSK 980TDi: H26 of three variables leaves the other two alone",
    control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
    program="O1\nN10 G65 H26 P#101 Q#102 R#103\nN20 M30\n",
    variables={101: 6, 102: 10, 103: 4}, runs="N10 N20", vars={101: 15, 102: 10, 103: 4},
)
case(
    "GSK 988TA: with 6000#7=1 G65 is type A",
    control=TA, source="TApar 6000", evidence=INFERRED, params={"6000#7": 1},
    program="O1\nN10 G65 H02 P#100 Q#101 R1\nN20 M30\n",
    variables={101: 4}, runs="N10 N20", vars={100: 5},
)
case(
    "GSK 988TA: with 6000#7=0 the H of G65 is an argument",
    control=TA, source="TApar 6000; TA27, argument I", evidence=MANUAL, params={"6000#7": 0},
    program=macro_call("G65 H02 P2 Q5"),
    runs="N10 N30 N20", calls="G65:O2", arguments={11: 2, 17: 5},
)

JUMP = "O1\nN10 G65 {} P40 Q#100 R#101\nN20 #102=1\nN30 M30\nN40 #102=2\nN50 M30\n"

case(
    "GSK 980TDi: H80 jumps",
    control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
    program="O1\nN10 G65 H80 P30\nN20 G0 X1\nN30 M30\n", runs="N10 N30",
)
case(
    "GSK 980TDi: H80 jumps back",
    control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
    program="O1\nN10 G0 X1\nN20 G65 H80 P10\nN30 M30\n", max_blocks=5,
    runs="N10 N20 N10 N20 N10", stop="limit",
)
case(
    "GSK 980TDi: H81 (Q = R) jumps with Q2 R2",
    control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
    program=JUMP.format("H81"),
    variables={100: 2, 101: 2}, runs="N10 N40 N50",
)
case(
    "GSK 980TDi: H81 (Q = R) does not jump with Q2 R3",
    control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
    program=JUMP.format("H81"),
    variables={100: 2, 101: 3}, runs="N10 N20 N30",
)
case(
    "GSK 980TDi: H82 (Q <> R) jumps with Q2 R3",
    control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
    program=JUMP.format("H82"),
    variables={100: 2, 101: 3}, runs="N10 N40 N50",
)
case(
    "GSK 980TDi: H82 (Q <> R) does not jump with Q2 R2",
    control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
    program=JUMP.format("H82"),
    variables={100: 2, 101: 2}, runs="N10 N20 N30",
)
case(
    "GSK 980TDi: H83 (Q > R) jumps with Q3 R2",
    control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
    program=JUMP.format("H83"),
    variables={100: 3, 101: 2}, runs="N10 N40 N50",
)
case(
    "GSK 980TDi: H83 (Q > R) does not jump with Q2 R2",
    control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
    program=JUMP.format("H83"),
    variables={100: 2, 101: 2}, runs="N10 N20 N30",
)
case(
    "GSK 980TDi: H84 (Q < R) jumps with Q2 R3",
    control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
    program=JUMP.format("H84"),
    variables={100: 2, 101: 3}, runs="N10 N40 N50",
)
case(
    "GSK 980TDi: H84 (Q < R) does not jump with Q2 R2",
    control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
    program=JUMP.format("H84"),
    variables={100: 2, 101: 2}, runs="N10 N20 N30",
)
case(
    "GSK 980TDi: H85 (Q >= R) jumps with Q2 R2",
    control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
    program=JUMP.format("H85"),
    variables={100: 2, 101: 2}, runs="N10 N40 N50",
)
case(
    "GSK 980TDi: H85 (Q >= R) does not jump with Q2 R3",
    control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
    program=JUMP.format("H85"),
    variables={100: 2, 101: 3}, runs="N10 N20 N30",
)
case(
    "GSK 980TDi: H86 (Q <= R) jumps with Q2 R2",
    control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
    program=JUMP.format("H86"),
    variables={100: 2, 101: 2}, runs="N10 N40 N50",
)
case(
    "GSK 980TDi: H86 (Q <= R) does not jump with Q3 R2",
    control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
    program=JUMP.format("H86"),
    variables={100: 3, 101: 2}, runs="N10 N20 N30",
)
case(
    "GSK 980TDi: H85 jumps where Q is greater",
    control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
    program=JUMP.format("H85"), variables={100: 3, 101: 2}, runs="N10 N40 N50",
)
case(
    "GSK 980TDi: H86 jumps where Q is less",
    control=TDI, source="TDi28, table of G65 H", evidence=MANUAL,
    program=JUMP.format("H86"), variables={100: 2, 101: 3}, runs="N10 N40 N50",
)
case(
    "GSK 980TDi: the target of a jump may be a variable",
    control=TDI, source="TDi28, G65 H, note 2", evidence=MANUAL,
    program="O1\nN10 G65 H81 P#100 Q5 R5\nN20 G0 X1\nN30 M30\n", variables={100: 30},
    runs="N10 N30",
)
case(
    "GSK 980TDi: a jump to a block that is missing is an alarm",
    control=TDI, source="TDi28; number from MDia 112", evidence=INFERRED,
    program="O1\nN10 G0 X1\nN20 G65 H80 P90\nN30 M30\n",
    runs="N10", alarm="jump-target-not-found", number="0112", at="O1 N20",
)
case(
    "GSK 980TDi: a conditional jump to a block that is missing is an alarm when it is made",
    control=TDI, source="TDi28; number from MDia 112", evidence=INFERRED,
    program="O1\nN10 G65 H84 P90 Q2 R1\nN20 G65 H84 P90 Q1 R2\nN30 M30\n",
    runs="N10", alarm="jump-target-not-found", number="0112", at="O1 N20",
)
case(
    "GSK 980TDi: a jump does not look in other programs",
    control=TDI, source="TDi28; number from MDia 112", evidence=INFERRED,
    program="O1\nN10 G65 H80 P40\nN20 M30\nO2\nN40 M99\n",
    runs="", alarm="jump-target-not-found", number="0112", at="O1 N10",
)
case(
    "GSK 980TDi: H99 P0 raises alarm 5900",
    control=TDI, source="TDi28, H99", evidence=MANUAL,
    program="O1\nN10 G0 X1\nN20 G65 H99 P0(/NO BAR)\nN30 M30\n",
    runs="N10 N20", alarm="user-alarm", number="5900", at="O1 N20",
)
case(
    "GSK 980TDi: #3000=0 raises alarm 5900",
    control=TDI, source="TDi28, system variables", evidence=MANUAL,
    program="O1\nN10 G0 X1\nN20 #3000=0(NO BAR)\nN30 M30\n",
    runs="N10 N20", alarm="user-alarm", number="5900", at="O1 N20",
)
case(
    "GSK 980TDi: H99 P7 raises alarm 5907",
    control=TDI, source="TDi28, H99", evidence=MANUAL,
    program="O1\nN10 G0 X1\nN20 G65 H99 P7(/NO BAR)\nN30 M30\n",
    runs="N10 N20", alarm="user-alarm", number="5907", at="O1 N20",
)
case(
    "GSK 980TDi: #3000=7 raises alarm 5907",
    pins="user_alarm_numbers",
    control=TDI, source="TDi28, system variables", evidence=MANUAL,
    program="O1\nN10 G0 X1\nN20 #3000=7(NO BAR)\nN30 M30\n",
    runs="N10 N20", alarm="user-alarm", number="5907", at="O1 N20",
)
case(
    "GSK 980TDi: H99 P99 raises alarm 5999",
    control=TDI, source="TDi28, H99", evidence=MANUAL,
    program="O1\nN10 G0 X1\nN20 G65 H99 P99(/NO BAR)\nN30 M30\n",
    runs="N10 N20", alarm="user-alarm", number="5999", at="O1 N20",
)
case(
    "GSK 980TDi: #3000=99 raises alarm 5999",
    control=TDI, source="TDi28, system variables", evidence=MANUAL,
    program="O1\nN10 G0 X1\nN20 #3000=99(NO BAR)\nN30 M30\n",
    runs="N10 N20", alarm="user-alarm", number="5999", at="O1 N20",
)
case(
    "GSK 980TDi: H99 needs no text",
    control=TDI, source="TDi28, H99 note 1", evidence=MANUAL,
    program="O1\nN10 G65 H99 P15\nN20 M30\n",
    runs="N10", alarm="user-alarm", number="5915", at="O1 N10",
)
case(
    "GSK 980TDi: #3000 needs no text",
    control=TDI, source="TDi28, system variables", evidence=MANUAL,
    program="O1\nN10 #3000=15\nN20 M30\n",
    runs="N10", alarm="user-alarm", number="5915", at="O1 N10",
)
case(
    "GSK 980TDi: H99 raises the alarm inside a subprogram",
    control=TDI, source="TDi28, H99", evidence=MANUAL,
    program="O1\nN10 M98 P2\nN20 M30\nO2\nN30 G65 H99 P3\nN40 M99\n",
    runs="N10 N30", alarm="user-alarm", number="5903", at="O2 N30",
)
case(
    "GSK 980: H99 P101 is outside the range",
    pins="h_codes",
    control=FAMILY_980, source="MDia 126", evidence=MANUAL,
    program="O1\nN10 G65 H99 P101\nN20 M30\n",
    runs="", alarm="illegal-user-alarm", number="0126", at="O1 N10",
)
case(
    "GSK 980: #3000=100 is outside the range",
    control=FAMILY_980, source="MDib 126", evidence=MANUAL,
    program="O1\nN10 #3000=100\nN20 M30\n",
    runs="", alarm="illegal-user-alarm", number="0126", at="O1 N10",
)
case(
    "GSK 980: #3000=-1 is outside the range",
    control=FAMILY_980, source="MDib 126", evidence=MANUAL,
    program="O1\nN10 #3000=-1\nN20 M30\n",
    runs="", alarm="illegal-user-alarm", number="0126", at="O1 N10",
)
case(
    "GSK 980TDi: #3000 after a condition that is false raises nothing",
    control=TDI, source="TDi29, IF THEN", evidence=MANUAL,
    program="O1\nN10 IF[#100 GT 5]THEN #3000=1\nN20 M30\n", variables={100: 5},
    runs="N10 N20",
)
case(
    "GSK 980TDi: #3000 after a condition that is true raises its alarm",
    control=TDI, source="TDi29, IF THEN", evidence=MANUAL,
    program="O1\nN10 IF[#100 GT 5]THEN #3000=1\nN20 M30\n", variables={100: 6},
    runs="N10", alarm="user-alarm", number="5901", at="O1 N10",
)


def fault(claim, words, cause, number, control=TDI, source=None, evidence=INFERRED):
    """Write a row of one G65 H block that alarms and writes nothing."""
    case(
        f"{'GSK 980TDi' if control == TDI else 'GSK 980'}: {claim}",
        control=control, source=source or f"MDia {number}", evidence=evidence,
        program=f"O1\nN10 #100=3\nN20 G65 {words}\nN30 M30\n",
        runs="N10", alarm=cause, number=number, at="O1 N20", vars={100: 3},
    )


fault(
    "G65 needs a P or an H", "A1", "h-code-missing", "0122", control=FAMILY_980, evidence=MANUAL,
)
fault(
    "G65 alone says nothing", "", "h-code-missing", "0122", control=FAMILY_980, evidence=MANUAL,
)
fault("H06 does not exist", "H06 P#100 Q1 R1", "illegal-h-code", "0124")
fault("H07 does not exist", "H07 P#100 Q1 R1", "illegal-h-code", "0124")
fault("H14 does not exist", "H14 P#100 Q1 R1", "illegal-h-code", "0124")
fault("H28 does not exist", "H28 P#100 Q1 R1", "illegal-h-code", "0124")
fault("H35 does not exist", "H35 P#100 Q1 R1", "illegal-h-code", "0124")
fault("H87 does not exist", "H87 P#100 Q1 R1", "illegal-h-code", "0124")
fault("H98 does not exist", "H98 P#100 Q1 R1", "illegal-h-code", "0124")
fault("H01 needs Q", "H01 P#100", "h-code-operand", "0125")
fault("H02 needs R", "H02 P#100 Q1", "h-code-operand", "0125")
fault("H02 needs Q", "H02 P#100 R1", "h-code-operand", "0125")
fault("H27 needs R", "H27 P#100 Q3", "h-code-operand", "0125")
fault("H81 needs Q and R", "H81 P10", "h-code-operand", "0125")
fault("H84 needs R", "H84 P10 Q1", "h-code-operand", "0125")
fault("H02 needs P", "H02 Q1 R2", "h-code-format", "0123")
fault("H80 needs P", "H80", "h-code-format", "0123")
fault("the result of H01 goes into a variable", "H01 P100 Q1", "h-code-format", "0123")
fault("H05 by zero is refused", "H05 P#100 Q#100 R0", "division-by-zero", "0105",
      control=FAMILY_980, evidence=MANUAL)
fault("H05 by a variable of zero is refused", "H05 P#100 Q1 R#150", "division-by-zero", "0105")
fault("H26 by zero is refused", "H26 P#100 Q2 R0", "division-by-zero", "0105")
fault("H23 by zero is refused", "H23 P#100 Q2 R0", "division-by-zero", "0105")
fault("H21 of a negative value is refused", "H21 P#100 Q-4", "square-root-of-negative", "0108",
      control=FAMILY_980, evidence=MANUAL)
fault("H33 of 90 degrees is refused", "H33 P#100 Q1 R90", "tangent-infinite", "0109")
fault("H24 of decimals is refused", "H24 P#100 Q1.5", "argument-out-of-range", "0127")
fault("the result of H01 does not go into #0", "H01 P#0 Q1", "vacant-assigned", "0117",
      control=FAMILY_980, evidence=MANUAL)
fault("the result of H01 does not go into #50", "H01 P#50 Q1", "illegal-variable", "0111",
      control=FAMILY_980, evidence=MANUAL)
fault("the result of H01 does not go into the read-only #4001", "H01 P#4001 Q1",
      "variable-write-protected", "0120", source="MDia 120; TDi28, system variables")
fault("the result of H01 does not go into the read-only #5001", "H01 P#5001 Q1",
      "variable-write-protected", "0120", source="MDia 120; TDi28, system variables")
