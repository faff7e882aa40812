"""Syntec: programs that begin with %@MACRO, in the language of the maker."""

from conformance import case

SYNTEC = "syntec-22ma"
MAKER = {"control": SYNTEC, "source": "SYM, the language of %@MACRO", "evidence": "secondary"}
OURS = MAKER | {"evidence": "inferred"}


def macro(text: str) -> str:
    """Return a program O1 of the language."""
    return "O1\n%@MACRO\n" + text


# ---- the file ----

case(
    "the first line says that the program is in the language (SYN3-11)", **MAKER,
    files={"O0001": "%@MACRO\nN10 #1 := 5;\nN20 IF #1 = 5 THEN\nN30 G0 X1.;\nN40 ELSE\nN50 G0 X2.;\nN60 END_IF;\nN70 M30;\n"},
    runs="N10 N20 N30 N40 N60 N70", moves_x=[1],
)
case(
    "without it the same statements are a syntax error", **MAKER,
    files={"O0001": "N10 #1 := 5;\nN70 M30;\n"}, runs="", alarm="missing-equals", number="COM-003", at="O0001 N10",
)
case(
    "a program of the language calls one of ISO, and an ISO program one of the language", **MAKER,
    program="O1\nN10 M98 P2\nN20 M30\nO2\n%@MACRO\nN30 @1 := 3; N40 G65 P3 A(@1*2);\nN50 M99;\nO3\nN60 #500=#1 (A NOTE)\nN70 M99",
    runs="N10 N30 N40 N60 N70 N50 N20", vars={500: 6, 1000001: 3},
)
case(
    "comments stand after // and in (* *), over several lines too", **MAKER,
    program=macro("// IF\n(* END_IF; M30;\n M30; *) N10 G0 X1.; // M30;\nN20 X2. (* a *) Y3.;\nN30 M30;"), runs="N10 N20 N30", moves_x=[1, 2],
)
case(
    "a line without its semicolon goes on in the next one", **MAKER,
    program=macro("N10 G0 X1.\n Y2.;\nN20 #1 :=\n 5 +\n 6; N30 M30;"), runs="N10 N20 N30", vars={1: 11}, moves_x=[1],
)
case(
    "a character that is no ASCII is refused outside of comments and texts", **MAKER,
    program=macro("N10 M8; // \u949b\u5b50\nN20 \u94bb X1.;\nN30 M30;"), runs="N10", alarm="illegal-character", number="COM-027", at="O1 N20",
)
case(
    "the end of the text ends nothing: M30 or M99 must stand there", **OURS,
    program=macro("N10 M8;"), runs="N10", alarm="end-of-record", number=None,
)
case(
    "M30 in a subprogram of the language returns", **MAKER,
    program=macro("N10 M98 P2;\nN20 M30;\nO2\n%@MACRO\nN30 M8;\nN40 M30;"), runs="N10 N30 N40 N20",
)

# ---- variables ----

case(
    "#1 to #400 are of the level, @1 of all programs", **MAKER,
    program=macro("N10 #27 := 5;\nN20 @1 := 6;\nN30 G65 P2;\nN40 @2 := #27;\nN50 M30;\nO2\n%@MACRO\nN60 #27 := 7;\nN70 @1 := @1 + 1;\nN80 M99;"),
    vars={1000001: 7, 1000002: 5},
)
case(
    "M98 shares the locals (CALL_RUN_02)", **MAKER,
    program=macro("N10 #27 := 100;\nN20 M98 P2001;\nN30 @1 := #27;\nN40 M30;\nO2001\n%@MACRO\nN50 #27 := 200;\nN60 M99;"), vars={1000001: 200},
)
case(
    "a variable by a computed number", **MAKER,
    program=macro("N10 #1 := 123;\nN20 @[#1] := 567;\nN30 @[#1+7] := 890;\nN40 #[10+3] := @[#1] + 1;\nN50 M30;"), vars={1000123: 567, 1000130: 890, 13: 568},
)
case(
    "#0 and @0 are vacant, and no number is", pins="vacant_comparison", **MAKER,
    program=macro("N10 IF #1 = #0 THEN #10 := 1; END_IF;\nN20 IF @1 = @0 THEN #11 := 1; END_IF;\nN30 #1 := 0;\nN40 IF #1 <> #0 THEN #12 := 1; END_IF;\nN50 M30;"),
    vars={10: 1, 11: 1, 12: 1},
)
case(
    "@656 to @999 and @1001 to @1999 hold numbers", pins="commons", **MAKER,
    program=macro("@656 := 1;\n@999 := @656 + 1;\n@1001 := @999 + 1;\n@1999 := @1001 + 1;\nM30;"), vars={1000656: 1, 1000999: 2, 1001001: 3, 1001999: 4},
)
for name in ("@401", "@10000", "@100050", "@60000"):
    case(
        f"{name} is a register of the PLC or an option, of which nobody knows what it holds", pins="unlisted_variables", **MAKER,
        program=macro(f"N10 #1 := {name};\nN20 M30;"), runs="", alarm="variable-not-known", number=None, at="O1 N10", word=name,
    )
case(
    "variables of applications are not known", **OURS,
    program=macro("N10 AR1 := 5;\nN20 M30;"), runs="", alarm="code-not-computed", number=None, at="O1 N10", word="AR1",
)

# ---- expressions ----

for text, value in (
    ("1/2", 0), ("1./2", 0.5), ("1/2.0", 0.5), ("(1/2)*1.0", 0), ("7/2*2", 6), ("10 MOD 3", 1), ("2+3*4", 14), ("(2+3)*4", 20), ("-2+5", 3),
    ("10-3-2", 5), ("NOT 5", -6), ("6 AND 3", 2), ("6 & 3", 2), ("6 OR 3", 7), ("6 XOR 3", 5), ("1 OR 1 XOR 1", 1), ("1 = 1", 1), ("2 < 1", 0),
    ("1 <> 2 = 0", 1), ("(3 > 2) & (2 >= 2)", 1), ("1 <= 0", 0), ("ABS(-2.3)", 2.3), ("SQRT(4)", 2), ("SIGN(-4)", -1), ("ROUND(2.6)", 3),
    ("CEIL(1.4)", 2), ("FLOOR(1.4)", 1), ("FLOOR(-1.4)", -2), ("MAX(10,20)", 20), ("MIN(10,20)", 10), ("SIN(90)", 1), ("COS(180)", -1), ("TAN(45)", 1),
    ("ASIN(1)", 90), ("ASIN(-1)", -90), ("ACOS(-1)", 180), ("ATAN(-1)", -45), ("ATAN2(1,-1)", 135), ("ATAN2(-1,-1)", -135), ("POW(16,0.5)", 4),
    ("EXP(0)", 1), ("LN(1)", 0), ("MAX(1,2)/4", 0), ("MAX(1,2.)/4", 0.5), ("ROUND(2.6)/2", 1), ("ABS(3)/2", 1.5),
):
    pins = {"pins": "functions"} if text == "SIN(90)" else {"pins": "asin_range"} if text == "ASIN(-1)" else {"pins": "atan_range"} if text == "ATAN2(-1,-1)" else {}
    case(f"{text} is {value:g}", **MAKER | pins, program=macro(f"N10 #1 := {text};\nN20 M30;"), runs="N10 N20", vars={1: value})
case(
    "a variable has the type of the number that it was given", **MAKER,
    program=macro("#1 := 7;\n#2 := #1/2;\n#3 := 7.;\n#4 := #3/2;\n#5 := #1 MOD 4;\nN30 M30;"), vars={2: 3, 4: 3.5, 5: 3},
)
case(
    "a block with a number may be reached from elsewhere: no type is known there", **OURS,
    program=macro("N10 #1 := 7;\nN20 #2 := #1/2;\nN30 M30;"), runs="N10", alarm="code-not-computed", number=None, at="O1 N20",
)
for skip in ((), (1,)):
    case(
        f"an assignment that a slash may skip tells no type, whether it does or not: {'on' if skip else 'off'}", **OURS,
        program=macro("N10 #1 := 7;\n/#1 := 6.;\n#2 := #1/4;\nN30 M30;"), skip=skip, alarm="code-not-computed", number=None, at="O1",
        variables={2: 5}, vars={2: 5},
    )
case(
    "a T code that calls a subprogram may change a type", **OURS, params={"3215": 1},
    files={"O1": "%@MACRO\n#1 := 6;\nT5;\n#2 := #1/4;\nM30;\n", "T0000": "%@MACRO\n#1 := 6.;\nM99;\n"}, main="O1",
    alarm="code-not-computed", number=None, at="O1", vars={1: 6},
)
case(
    "a quotient of values whose types nobody knows is not computed", **OURS,
    program=macro("N10 #1 := #24/#25;\nN20 M30;"), runs="", alarm="code-not-computed", number=None, at="O1 N10",
)
case(
    "a quotient is known where one value has a point", **MAKER,
    program=macro("N10 #24 := 3;\nN15 M8;\nN20 #1 := #24/2.;\nN30 M30;"), vars={1: 1.5},
)
for text in ("10. MOD 3", "10 MOD 3.0", "SQRT(9) MOD 2"):
    case(f"{text}: MOD takes whole numbers", **MAKER, program=macro(f"N10 #1 := {text};\nN20 M30;"), runs="", alarm="type-mismatch", number="COR-054", at="O1 N10")
case("POW takes no negative base", **MAKER, program=macro("N10 #1 := POW(-2., 0.5);\nN20 M30;"), runs="", alarm="power-of-negative", number="COR-122", at="O1 N10")
case(
    "a value in round brackets, arithmetic without, and a code by a variable", **MAKER,
    program=macro("N10 #1 := 3.0;\nN20 G00 X(1.0 + 3.0);\nN30 X30.0 / 2.0;\nN40 X(4.0 * #1) Y-#1;\nN50 #2 := 0;\nN60 G#2 X-#1 Y(-#1);\nN70 M30;"),
    moves_x=[4, 15, 12, -3],
)
for name in ("PARAM(3204)", "GETARG(X1)", "STD(#1,#1600)", "READDI(31)", "SYSVAR(1,1000)"):
    case(
        f"{name} is not computed", **OURS,
        program=macro(f"N10 #1 := {name};\nN20 M30;"), runs="", alarm="code-not-computed", number=None, at="O1 N10", word=name[: name.index("(")],
    )
case(
    "a name that is no function is a syntax error", **OURS,
    program=macro("N10 #1 := DIV(3,2);\nN20 M30;"), runs="", alarm="expression-format", number="COM-003", at="O1 N10", word="DIV",
)

# ---- IF and CASE ----

for value, branch in ((1, 10), (2, 20), (3, 30), (4, 40)):
    case(
        f"IF ELSEIF ELSE takes one branch: of {value}", **MAKER,
        program=macro(f"#1 := {value};\nIF #1 = 1 THEN\n #2 := 10;\nELSEIF #1 = 2 THEN\n #2 := 20;\nELSEIF (#1 > 2) & (#1 < 4) THEN\n #2 := 30;\nELSE\n #2 := 40;\nEND_IF;\nM30;"),
        vars={2: branch},
    )
for value, branch in ((0, 9), (1, 1), (2, 2), (3, 2), (7, 9)):
    case(
        f"CASE takes the branch of its value, ELSE where it has none: of {value}", **MAKER,
        program=macro(f"#1 := {value};\nCASE #1 OF\n1:\n #2 := 1;\n2, 3:\n #2 := 2;\nELSE\n #2 := 9;\nEND_CASE;\nM30;"), vars={2: branch},
    )
case(
    "CASE without ELSE takes no branch where it has none", **OURS,
    program=macro("#1 := 5;\n#2 := 4;\nCASE #1 OF\n1: #2 := 1;\nEND_CASE;\nM30;"), vars={2: 4},
)

# ---- loops and jumps ----

case(
    "WHILE asks first", **MAKER,
    program=macro("N10 #1 := 3;\nN20 WHILE #1 < 3 DO\nN30 #1 := #1 + 1;\nN40 END_WHILE;\nN50 WHILE #1 < 5 DO\nN60 #1 := #1 + 1;\nN70 END_WHILE;\nN80 M30;"),
    runs="N10 N20 (N50 N60 N70)*2 N50 N80", vars={1: 5},
)
case(
    "REPEAT asks last", **MAKER,
    program=macro("N10 REPEAT\nN20 #1 := #1 + 1;\nN30 UNTIL #1 >= 2 END_REPEAT;\nN40 M30;"), runs="(N10 N20 N30)*2 N40",
)
for head, last in (("1 TO 5", 15), ("1 TO 5 BY 2", 9), ("5 TO 1 BY -2", 9), ("5 TO 1", 0), ("1 TO 2 BY 0.5", 4.5), ("3 TO 1 BY #9", 6)):
    case(
        f"FOR #1 := {head} counts", **MAKER,
        program=macro(f"#9 := -1;\n#2 := 0;\nFOR #1 := {head} DO\n #2 := #2 + #1;\nEND_FOR;\nM30;"), vars={2: last},
    )
case(
    "EXIT leaves the loop around it, out of IF and CASE", **MAKER,
    program=macro("#2 := 0;\nFOR #1 := 1 TO 3 DO\nREPEAT\n #2 := #2 + 1;\n CASE #1 OF\n 1, 2, 3: IF #2 > 0 THEN EXIT; END_IF;\n END_CASE;\n #2 := #2 + 100;\nUNTIL 1 = 2 END_REPEAT;\nEND_FOR;\nM30;"),
    vars={2: 3},
)
case(
    "of two blocks with one number GOTO goes to the first", pins="jump_search", **MAKER,
    program=macro("N10 GOTO 20;\nN20 #1 := #1 + 1;\nN30 IF #1 > 2 THEN GOTO 40; END_IF;\nGOTO 20;\nN20 M0;\nN40 M30;"), vars={1: 3}, m=[],
)
case(
    "GOTO goes by a variable", **MAKER,
    program=macro("N10 #2 := 30;\nN20 GOTO #2;\nN25 M0;\nN30 M30;"), runs="N10 N20 N30",
)
case(
    "GOTO to a block that is not there alarms, and nobody says by which number", **OURS,
    program=macro("N10 GOTO 50;\nN30 M30;"), runs="", alarm="jump-target-not-found", number=None, at="O1 N10", word="50",
)
case(
    "a jump out of a loop leaves it", **MAKER,
    program=macro("FOR #1 := 1 TO 9 DO\n IF #1 = 4 THEN GOTO 50; END_IF;\nEND_FOR;\nN50 #2 := #1;\nM30;"), vars={2: 4},
)

case(
    "an N that is not the first word names no block", pins="late_sequence_numbers", **OURS,
    program=macro("N10 GOTO 30;\nN20 M0;\nM8 N30;\nN40 M30;"), runs="", alarm="jump-target-not-found", number=None, at="O1 N10", word="30",
)
case(
    "the largest number of GOTO", pins="max_jump_number", **OURS,
    program=macro("N10 GOTO 100000;\nN20 M30;"), runs="", alarm="illegal-jump-number", number=None, at="O1 N10", word="100000",
)
case(
    "a program may call one of its callers", pins="caller_call", **OURS,
    program=macro("#1 := #1 + 1;\nIF #1 < 3 THEN M98 P2; END_IF;\nM30;\nO2\n%@MACRO\nM98 P1;\nM99;\n"), vars={1: 3},
)
case(
    "of two blocks with one number M99 P goes to the first", pins="return_search", **OURS,
    program=macro("N10 #1 := #1 + 1;\nIF #1 = 2 THEN GOTO 40; END_IF;\nM98 P2;\nN10 #2 := 9;\nN40 M30;\nO2\n%@MACRO\nM99 P10;"), vars={1: 2, 2: None},
)

# ---- what is missing ----

FAULTS = (
    ("IF without THEN", "IF #1 = 1 #2 := 1; END_IF;", "if-format", "COM-019"),
    ("IF without END_IF", "IF #1 = 1 THEN #2 := 1;", "if-without-end", "COM-020"),
    ("IF with ELSE and without END_IF", "IF #1 = 1 THEN #2 := 1; ELSE #2 := 2;", "if-without-end", "COM-021"),
    ("END_IF without IF", "END_IF;", "if-without-end", "COM-019"),
    ("CASE without OF", "CASE #1 1: #2 := 1; END_CASE;", "statement-format", "COM-022"),
    ("CASE without END_CASE", "CASE #1 OF 1: #2 := 1;", "if-without-end", "COM-023"),
    ("CASE with ELSE and without END_CASE", "CASE #1 OF 1: #2 := 1; ELSE #2 := 2;", "if-without-end", "COM-024"),
    ("END_CASE without CASE", "END_CASE;", "if-without-end", "COM-022"),
    ("FOR without DO", "FOR #1 := 1 TO 5 #2 := 1; END_FOR;", "statement-format", "COM-013"),
    ("FOR without END_FOR", "FOR #1 := 1 TO 5 DO #2 := 1;", "missing-end", "COM-014"),
    ("END_FOR without FOR", "END_FOR;", "missing-do", "COM-013"),
    ("REPEAT without UNTIL", "REPEAT #1 := 1;", "missing-end", "COM-015"),
    ("UNTIL without END_REPEAT", "REPEAT #1 := 1; N15 UNTIL #1 = 1;", "statement-format", "COM-016"),
    ("UNTIL without REPEAT", "UNTIL #1 = 1 END_REPEAT;", "missing-do", "COM-034"),
    ("WHILE without DO", "WHILE #1 = 1 #2 := 1; END_WHILE;", "while-format", "COM-017"),
    ("WHILE without END_WHILE", "WHILE #1 = 1 DO #2 := 1;", "missing-end", "COM-018"),
    ("END_WHILE without WHILE", "END_WHILE;", "missing-do", "COM-017"),
    ("a value of CASE without its colon", "CASE #1 OF 0 #2 := 1; END_CASE;", "statement-format", "COM-025"),
    ("EXIT outside of a loop", "EXIT;", "statement-format", "COM-003"),
    ("a word that is no statement", "ELSIF #1 = 1 THEN;", "statement-format", "COM-003"),
)
for claim, text, cause, number in FAULTS:
    case(claim, **MAKER, program=macro(f"#1 := 1;\n#2 := 0;\nN10 {text}\nN20 M30;"), alarm=cause, number=number, stop="alarm", vars={})
DEEP = (("IF #1 = 0 THEN", "END_IF;", "if-too-deep", "max_ifs"), ("WHILE #1 = 0 DO", "#1 := 1; END_WHILE;", "loops-too-deep", "max_loops"))
for head, end, cause, rule in DEEP:
    case(
        f"eleven {head.split()[0]} inside each other are too many", pins=rule, **MAKER,
        program=macro("#1 := 0;\n" + f"{head}\n" * 10 + f"N20 {head}\n" + f"{end}\n" * 11 + "N30 M30;"), alarm=cause, number="COM-007", at="O1 N20", vars={1: 0},
    )
    case(
        f"ten {head.split()[0]} inside each other are not", pins=rule, **MAKER,
        program=macro("#1 := 0;\n" + f"{head}\n" * 10 + f"{end}\n" * 10 + "N30 M30;"), m=[],
    )

# ---- messages, and what only the machine obeys ----

case(
    "MSG shows its number and its text", **MAKER,
    program=macro('N10 MSG("DRILL; LOST");\nN20 MSG(100, "AGAIN");\nN30 M30;'), runs="N10 N20 N30", messages=["DRILL; LOST", "100 AGAIN"],
)
case(
    "ALARM stops the program with COR-027", **MAKER,
    program=macro('N10 M8;\nN20 ALARM(300, "NO TOOL");\nN30 M30;'), runs="N10", alarm="user-alarm", number="COR-027", at="O1 N20",
)
case(
    "WAIT and SLEEP change nothing in a run", **OURS,
    program=macro("N10 G0 X1.;\nN20 WAIT();\nN30 SLEEP();\nN40 M30;"), runs="N10 N20 N30 N40",
)
case(
    "what goes to a file, to the PLC or to the screen is dropped, and told", **OURS,
    program=macro('N10 OPEN("LOG.TXT");\nN20 PRINT("X#3");\nN30 SETDO(3, 1);\nN40 M30;'), runs="N10 N20 N30 N40", dropped=["OPEN", "PRINT", "SETDO"],
)
case(
    "G200 calls a program of the language, whose G codes stay in force", **MAKER,
    main="MAIN",
    files={
        "MAIN": "%@MACRO\nN10 G90 G0 X10.;\nN20 G200 X30.;\nN30 X-20.;\nN40 M30;\n",
        "G0200": "%@MACRO\nN50 G91 X#24;\nN60 G90;\nN70 M99;\n",
    },
    runs="N10 N20 N50 N60 N70 N30 N40", moves_x=[10, 40, -20],
)
