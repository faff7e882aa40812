"""Haas NGC: names of variables, work systems, the words that G10 takes."""

from conformance import case

HAAS = "haas-ngc"
KNOWN = {"control": HAAS, "source": "general knowledge of the Haas mill", "evidence": "inferred"}
FLOAT = {"162": 1}

case(
    "#100 is another name of #10100",
    control=HAAS, source="ZAP, Haas system variables", evidence="secondary",
    program="O1\nN10 #100=5\nN20 #1=#10100+1\nN30 #10100=7\nN40 #2=#[100]\nN50 M30",
    vars={1: 6, 2: 7, 10100: 7, 100: 7},
)
case(
    "#199 is another name of #10199",
    control=HAAS, source="ZAP, Haas system variables", evidence="secondary",
    program="O1\nN10 #199=5\nN20 #1=#10199+1\nN30 #10199=7\nN40 #2=#[199]\nN50 M30",
    vars={1: 6, 2: 7, 10199: 7, 199: 7},
)
case(
    "#500 is another name of #10500",
    control=HAAS, source="ZAP, Haas system variables", evidence="secondary",
    program="O1\nN10 #500=5\nN20 #1=#10500+1\nN30 #10500=7\nN40 #2=#[500]\nN50 M30",
    vars={1: 6, 2: 7, 10500: 7, 500: 7},
)
case(
    "#699 is another name of #10699",
    control=HAAS, source="ZAP, Haas system variables", evidence="secondary",
    program="O1\nN10 #699=5\nN20 #1=#10699+1\nN30 #10699=7\nN40 #2=#[699]\nN50 M30",
    vars={1: 6, 2: 7, 10699: 7, 699: 7},
)
case(
    "#800 is another name of #10800",
    control=HAAS, source="ZAP, Haas system variables", evidence="secondary",
    program="O1\nN10 #800=5\nN20 #1=#10800+1\nN30 #10800=7\nN40 #2=#[800]\nN50 M30",
    vars={1: 6, 2: 7, 10800: 7, 800: 7},
)
case(
    "#999 is another name of #10999",
    control=HAAS, source="ZAP, Haas system variables", evidence="secondary",
    program="O1\nN10 #999=5\nN20 #1=#10999+1\nN30 #10999=7\nN40 #2=#[999]\nN50 M30",
    vars={1: 6, 2: 7, 10999: 7, 999: 7},
)
case(
    "#99 is no variable of the programs",
    **KNOWN,
    program="O1\nN10 #99=5\nN20 M30",
    runs="", alarm="illegal-variable", number="503", at="O1 N10",
)
case(
    "#200 is no variable of the programs",
    **KNOWN,
    program="O1\nN10 #200=5\nN20 M30",
    runs="", alarm="illegal-variable", number="503", at="O1 N10",
)
case(
    "#499 is no variable of the programs",
    **KNOWN,
    program="O1\nN10 #499=5\nN20 M30",
    runs="", alarm="illegal-variable", number="503", at="O1 N10",
)
case(
    "#750 is no variable of the programs",
    **KNOWN,
    program="O1\nN10 #750=5\nN20 M30",
    runs="", alarm="illegal-variable", number="503", at="O1 N10",
)
case(
    "#799 is no variable of the programs",
    **KNOWN,
    program="O1\nN10 #799=5\nN20 M30",
    runs="", alarm="illegal-variable", number="503", at="O1 N10",
)
case(
    "#9999 is no variable of the programs",
    pins="variable_forms:9nnn", **KNOWN,
    program="O1\nN10 #9999=5\nN20 M30",
    runs="", alarm="illegal-variable", number="503", at="O1 N10",
)
case(
    "a user's alarm is 1000 and its number", pins="user_alarm_offset", control=HAAS, source="HNGC p.210, #3000", evidence="maker's manual",
    program="O1\nN10 #3000=12 (NO TOOL)\nN20 M30", runs="N10", alarm="user-alarm", number="1012", at="O1 N10",
)
case(
    "a user's alarm goes to 999", pins="user_alarm_last", control=HAAS, source="HNGC p.210, #3000", evidence="maker's manual",
    program="O1\nN10 #3000=1000\nN20 M30", runs="", alarm="illegal-user-alarm", at="O1 N10",
)
case(
    "#2001 is the length of an offset and #2201 its wear", pins="power_on:G01",
    control=HAAS, source="ZAP, Haas system variables", evidence="secondary",
    setup={"machine": "mill", "length_offsets": {1: 50}},
    program="O1\nN10 #1=#2001\nN20 #2201=1.\nN30 G43 H1 Z10.\nN40 #2=#5023\nN50 M30", vars={1: 50, 2: 61},
)

# Work systems
case(
    "G110 to G129 are G154 P1 to P20", pins="g_meanings",
    control=HAAS, source="H96 p.113; general knowledge of the Haas mill", evidence="inferred",
    program="O1\nN10 #7001=5.\nN20 #7381=6.\nN30 G0 G110 X1.\nN40 #1=#5021\nN50 G129 X1.\nN60 #2=#5021\nN70 G154 P20 X2.\nN80 #3=#5021\nN90 M30",
    vars={1: 6, 2: 7, 3: 8},
)
case(
    "#7001 and #14001 are the same offset of G154 P1", **KNOWN,
    program="O1\nN10 #7001=5.\nN20 #1=#14001\nN30 #14021=3.\nN40 #2=#7021\nN50 M30", vars={1: 5, 2: 3},
)
case(
    "G154 P99 is the last work system", pins="max_extra_systems", control=HAAS, source="HNGC p.323, G154", evidence="maker's manual",
    program="O1\nN10 #15961=5.\nN20 G0 G154 P99 X1.\nN30 #1=#5021\nN40 M30", vars={1: 6},
)
case(
    "G154 takes P to 99", **KNOWN,
    program="O1\nN10 G154 P100\nN20 M30", runs="", alarm="work-system", at="O1 N10", word="P100",
)
case(
    "#5221 is the X of G54",
    control=HAAS, source="H96 p.113", evidence="secondary", setup={"machine": "mill", "work_offsets": {"G54": {"X": 3}}},
    program="O1\nN10 #1=#5221\nN20 #5241=4.\nN30 G0 G55 X1.\nN40 #2=#5021\nN50 M30", vars={1: 3, 2: 5},
)
case(
    "#5201 is not held here", **KNOWN,
    program="O1\nN10 G52 X1.\nN20 #1=#5201\nN30 M30", runs="N10", alarm="illegal-variable", number="503",
)

# Settings, codes
case(
    "setting 33 as FANUC: M30 ends G52", pins="reset_clears:local-system", control=HAAS, source="HNGC p.379, setting 33", evidence="maker's manual", setup={"machine": "mill"},
    program="O1\nN10 G52 X10.\nN20 G0 X0\nN30 M30", work_after_reset="X10",
)
case(
    "setting 33 as HAAS: G52 stays", control=HAAS, source="HNGC p.379, setting 33", evidence="maker's manual", setup={"machine": "mill"}, params={"33": 1},
    program="O1\nN10 G52 X10.\nN20 G0 X0\nN30 M30", work_after_reset="X0",
)
case(
    "setting 162 gives numbers their point", **KNOWN, params=FLOAT, program="O1\nN10 G0 X5\nN20 M30", moves_x=[5],
)
case(
    "without a point the last digit counts thousandths", pins="whole_numbers",
    control=HAAS, source="HEL", evidence="secondary", program="O1\nN10 G0 X5\nN20 M30", moves_x=[0.005],
)
case(
    "G103 limits the look-ahead and moves nothing",
    control=HAAS, source="H96 p.91, look-ahead", evidence="secondary",
    program="O1\nN10 G103 P1\nN20 G0 X1.\nN30 G103\nN40 M30", runs="N10 N20 N30 N40", moves_x=[1],
)
case(
    "G04 P. counts seconds and P without a point thousandths", pins="dwell_words dwell_unit dwell_point",
    control=HAAS, source="H96 p.91, G04 P1.", evidence="secondary",
    program="O1\nN10 G04 P1.\nN20 G04 P500\nN30 M30", time=1.5,
)
DWELL = {"control": HAAS, "source": "H96 p.91, G04 P1.; post processors of the Haas", "evidence": "secondary"}
case(
    "P with a point waits seconds in a drilling cycle", pins="dwell_point", **DWELL,
    program="O1\nN10 G0 Z5.\nN20 G82 X1. R1. Z-2. P0.5 F100.\nN30 G80 M30", time=2.402,
)
case(
    "P without a point waits thousandths in a drilling cycle", **DWELL,
    program="O1\nN10 G0 Z5.\nN20 G82 X1. R1. Z-2. P500 F100.\nN30 G80 M30", time=2.402,
)
case(
    "P of a later hole has its point too, and stays", **DWELL,
    program="O1\nN10 G0 Z5.\nN20 G99 G89 X1. R1. Z-1. P250 F600.\nN30 X2. P0.5\nN40 G98 X3.\nN50 G80 M30",
    moves="R Z5\nR X1\nR Z1\nF Z-1\nW 0.25\nF Z1\nR X2\nR Z1\nF Z-1\nW 0.5\nF Z1\nR X3\nR Z1\nF Z-1\nW 0.5\nF Z1\nR Z5",
)
for code in ("73", "74", "76", "83", "84", "85", "86"):
    case(
        f"G{code} takes a point at P", **DWELL | {"evidence": "inferred"},
        program=f"O1\nN10 G0 Z5. S100 M3\nN20 G{code} X1. R1. Z-2. Q0.5 P0.2 F100.\nN30 G80 M30", runs="N10 N20 N30",
    )
case(
    "P of a call takes no point", **KNOWN,
    program="O1\nN10 M98 P2.\nN20 M30\nO2\nN30 M99", runs="", alarm="illegal-decimal-point", at="O1 N10", word="P2.",
)
case(
    "P of G10 takes no point", **KNOWN,
    program="O1\nN10 G10 L2 P1. X5.\nN20 M30", runs="", alarm="illegal-decimal-point", at="O1 N10", word="P1.",
)
case(
    "P of a move takes no point", **KNOWN,
    program="O1\nN10 G0 X1. P0.5\nN20 M30", runs="", alarm="illegal-decimal-point", at="O1 N10", word="P0.5",
)
case(
    "a computed P of a cycle counts thousandths, as that of G04 does", **KNOWN,
    program="O1\nN10 #1=500\nN20 G0 Z5.\nN30 G82 X1. R1. Z-2. P#1 F100.\nN40 G80 M30", time=2.402,
)

# Values of the machine
TOLD = {"control": HAAS, "source": "ZAP, Haas system variables", "evidence": "secondary"}
case(
    "#11000 to #11063 are inputs", **TOLD, inputs={"signals": {11000: 1, 11063: 1}},
    program="O1\nN10 #1=#11000+#11001+#11063\nN20 M30", vars={1: 2},
)
case(
    "an input is read only", **TOLD,
    program="O1\nN10 #11000=1\nN20 M30", runs="", alarm="variable-write-protected", at="O1 N10",
)
case(
    "flutes, vibrations and timers are numbers that the machine tells", **TOLD, inputs={"signals": {1601: 4, 1800: 3, 1801: 5, 2000: 2, 3020: 7, 3028: 9}},
    program="O1\nN10 #1=#1601+#1800*10+#1801*100+#2000*1000\nN20 #2=#3020+#3028*10\nN30 M30", vars={1: 2534, 2: 97},
)
for number in (1064, 1080, 1090, 1264, 1601, 1801, 3020, 3028):
    case(
        f"#{number} is read only", **TOLD,
        program=f"O1\nN10 #{number}=1\nN20 M30", runs="", alarm="variable-write-protected", at="O1 N10",
    )
for number in (1069, 1079, 1088, 1099, 1263, 1269, 1600, 3019, 3029, 11256):
    case(
        f"#{number} is no variable", **KNOWN,
        program=f"O1\nN10 #1=#{number}\nN20 M30", runs="", alarm="illegal-variable", number="503", at="O1 N10",
    )
case(
    "#700 to #749 are kept for programs of the control's own", **TOLD,
    program="O1\nN10 #700=5\nN20 #749=#700+#10700\nN30 M30", vars={700: 5, 749: 5},
)

_UNCOMPUTED = "71 72 88 100 101 102 107 136 141 143 153 155 161 162 163 164 165 166 169 174 184 188 234 253 254 255 268 269"

# These rows are written by a loop: a row each would say nothing but the number of the code.
for code in (*(f"G{number}" for number in _UNCOMPUTED.split()), "G12 I5. D1", "G13 I5. D1", "G47 P0 X1. Y1. R1. Z-1.", "G150 P2 X1. Y1. Z-1. Q1. R1. D1",
             "G70 I5. J0 L4", "G35 D1", "G36 X5. F5.", "G37 Z-5. H1", "G77 Z-5. R1. F50.", "G87 Z-5. R1. F50."):
    case(
        f"{code.split()[0]} is a code of the Haas whose moves are not computed", pins="machine minus_addresses", **KNOWN,
        program=f"O1\nN10 {code}\nN20 M30", runs="", alarm="code-not-computed", at="O1 N10", word=code.split()[0],
    )
case(
    "the Haas has no G66",
    pins="roles:G66=modal-call", **KNOWN,
    program="O1\nN10 G66 P2\nN20 M30\nO2\nN30 M99",
    runs="", alarm="g-code-not-available", number="310", at="O1 N10",
)
case(
    "the Haas has no G66.1",
    pins="roles:G66.1=modal-call-every-block", **KNOWN,
    program="O1\nN10 G66.1 P2\nN20 M30\nO2\nN30 M99",
    runs="", alarm="g-code-not-available", number="310", at="O1 N10",
)
case(
    "the Haas has no G67",
    **KNOWN,
    program="O1\nN10 G67\nN20 M30\nO2\nN30 M99",
    runs="", alarm="g-code-not-available", number="310", at="O1 N10",
)
case(
    "the Haas has no G54.1",
    **KNOWN,
    program="O1\nN10 G54.1 P1\nN20 M30\nO2\nN30 M99",
    runs="", alarm="g-code-not-available", number="310", at="O1 N10",
)
case(
    "the Haas has no G16",
    **KNOWN,
    program="O1\nN10 G16\nN20 M30\nO2\nN30 M99",
    runs="", alarm="g-code-not-available", number="310", at="O1 N10",
)
case(
    "the Haas has no G33",
    **KNOWN,
    program="O1\nN10 G33 Z-5. F1.\nN20 M30\nO2\nN30 M99",
    runs="", alarm="g-code-not-available", number="310", at="O1 N10",
)
case(
    "the Haas has no G63",
    **KNOWN,
    program="O1\nN10 G63\nN20 M30\nO2\nN30 M99",
    runs="", alarm="g-code-not-available", number="310", at="O1 N10",
)
case(
    "a code of the alias list calls its program, M without and G with arguments", **KNOWN,
    params={"9000": 33, "9010": 45},
    program="O1\nN10 M33\nN20 G45 A5.\nN30 M30\nO9000\nN40 M99\nO9010\nN50 #100=#1\nN60 M99",
    runs="N10 N40 N20 N50 N60 N30", vars={10100: 5}, calls="M-code:O9000 G-code:O9010",
)
case(
    "an alias whose program is missing is 314", control=HAAS, source="HNGC p.233, aliasing; p.314, alarm 314", evidence="maker's manual", params={"9001": 33},
    program="O1\nN10 M33\nN20 M30", runs="", alarm="program-not-found", number="314", at="O1 N10",
)
case(
    "two M codes in a block are one too many", pins="m_codes_per_block extra_m_codes", **KNOWN,
    program="O1\nN10 M3 M8\nN20 M30", runs="", alarm="illegal-m-combination", at="O1 N10",
)
case(
    "#1=1/0 shows 508 on the Haas",
    **KNOWN,
    program="O1\nN10 #1=1/0\nN20 M30\nO2\nN30 M99",
    runs="", alarm="division-by-zero", number="508", at="O1 N10",
)
case(
    "END1 shows 524 on the Haas",
    **KNOWN,
    program="O1\nN10 END1\nN20 M30\nO2\nN30 M99",
    runs="", alarm="missing-do", number="524", at="O1 N10",
)
case(
    "WHILE [1] DO1 shows 538 on the Haas",
    **KNOWN,
    program="O1\nN10 WHILE [1] DO1\nN20 M30\nO2\nN30 M99",
    runs="", alarm="missing-end", number="538", at="O1 N10",
)
case(
    "G0 X1. G65 P2 shows 528 on the Haas",
    pins="words_before_macro_call", **KNOWN,
    program="O1\nN10 G0 X1. G65 P2\nN20 M30\nO2\nN30 M99",
    runs="", alarm="macro-call-not-first", number="528", at="O1 N10",
)
case(
    "G65 P2 G1. shows 529 on the Haas",
    pins="codes_not_with_macro_call", **KNOWN,
    program="O1\nN10 G65 P2 G1.\nN20 M30\nO2\nN30 M99",
    runs="", alarm="illegal-argument", number="529", at="O1 N10",
)
case(
    "G65 shows 313 on the Haas",
    pins="h_codes", **KNOWN,
    program="O1\nN10 G65\nN20 M30\nO2\nN30 M99",
    runs="", alarm="program-number-missing", number="313", at="O1 N10",
)
case(
    "G65 I1. J1. K1. I1.  shows 530 on the Haas",
    pins="argument_sets", **KNOWN,
    program="""
        O1
        N10 G65 I1. J1. K1. I1. J1. K1. I1. J1. K1. I1. J1. K1. I1. J1. K1. I1. J1. K1. I1. J1. K1. I1. J1. K1. I1. J1. K1. I1. J1. K1. I1. J1. K1. P2
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="too-many-argument-sets", number="530", at="O1 N10",
)
case(
    "#1=1] shows 504 on the Haas",
    **KNOWN,
    program="O1\nN10 #1=1]\nN20 M30\nO2\nN30 M99",
    runs="", alarm="bracket-not-opened", number="504", at="O1 N10",
)
case(
    "nine macros may be open, the tenth is 531", pins="max_macro_nesting", **KNOWN,
    program="O1\nN10 G65 P2\nN20 M30\nO2\nN30 G65 P2\nN40 M99",
    runs="N10 N30*8", alarm="macro-nesting-too-deep", number="531", at="O2 N30",
)

# Behaviour of the family that no source denies
case(
    "a program's number has five digits on the Haas", **KNOWN, pins="max_program_number",
    program="O100000\nN10 M30", runs="", alarm="illegal-program-number",
)
case(
    "L goes to 99 on the Haas", **KNOWN, pins="max_repeats",
    program="O1\nN10 M98 P2 L99\nN20 M98 P2 L100\nN30 M30\nO2\nN40 M99",
    runs="N10 N40*99", alarm="repeat-count-digits", at="O1 N20",
)
case(
    "subprograms and macros count apart on the Haas", **KNOWN, pins="nesting_counts_macros",
    program="O1\nN10 G65 P2\nN20 M30\nO2\nN30 M98 P3\nN40 M99\nO3\nN50 #100=#100+1\nN60 IF [#100 LT 9] GOTO 80\nN70 M30\nN80 M98 P3\nN90 M99",
    runs="N10 N30 (N50 N60 N80)*8 N50 N60 N70",
)
case(
    "a macro's number has five digits on the Haas", **KNOWN, pins="max_macro_digits",
    program="O1\nN10 G65 P20001\nN15 G65 P200001\nN20 M30\nO20001\nN30 M99",
    runs="N10 N30", alarm="illegal-macro-number", at="O1 N15",
)
case(
    "the loops of a caller do not count on the Haas", **KNOWN, pins="loops_count_across_calls",
    program="O1\nN10 WHILE [#100 LT 1] DO1\nN20 M98 P2\nN30 END1\nN40 M30\nO2\nN50 WHILE [#100 LT 1] DO1\nN60 WHILE [#100 LT 1] DO2\nN70 WHILE [#100 LT 1] DO3\nN80 #100=1\nN90 END3\nN91 END2\nN92 END1\nN93 M99",
    vars={10100: 1}, stop="end",
)
case(
    "an alias inside a program that an alias called is a code of the machine", **KNOWN, pins="code_cascade",
    params={"9000": 33, "9001": 34},
    program="O1\nN10 M33\nN20 M30\nO9000\nN30 M34\nN40 M99\nO9001\nN50 M99", runs="N10 N30 N40 N20",
)
case(
    "a radius shorter than half the chord alarms on the Haas", **KNOWN, pins="small_radius", replace={"arc_tolerance": 200},
    program="O1\nN10 G2 X10. R4.9 F100.\nN20 M30", runs="", alarm="radius-too-small", at="O1 N10", word="R4.9",
)
case(
    "H goes to 200 on the Haas", pins="max_offset_number",
    control=HAAS, source="HEL, D: 0 to 200", evidence="secondary",
    program="O1\nN10 G43 H200 Z5.\nN20 H201\nN30 M30", runs="N10", alarm="offset-number", at="O1 N20", word="H201",
)
case(
    "G31 takes any P and any feed on the Haas", **KNOWN, pins="max_skip_signals max_skip_feed",
    program="O1\nN10 G31 X5. P9 F900.\nN20 M30", time=1 / 3,
)
case(
    "of two motion codes in a block the later counts on the Haas", **KNOWN, pins="repeated_address",
    program="O1\nN10 G0 G1 X5. F100.\nN20 M30", moves="F X5",
)
case(
    "an arc with R that ends where it starts is no move on the Haas", **KNOWN, pins="refuses:no-arc-travel",
    program="O1\nN10 G2 X0 Y0 R5. F100.\nN20 M30", runs="N10 N20",
)
case(
    "R turns a rotation by up to 360 degrees on the Haas", control=HAAS, source="HNGC p.282, G68", evidence="maker's manual",
    pins="max_rotation rotation_words",
    program="O1\nN5 G68 X0 Y0 R360.\nN10 G68 X0 Y0 R90.\nN20 G0 X5.\nN30 #1=#5022\nN40 M30", vars={1: 5},
)
case(
    "a variable's number takes no point on the Haas", **KNOWN, pins="variable_forms:point",
    program="O1\nN10 #504.=2\nN20 M30", runs="", alarm="illegal-variable", number="503",
)
case(
    "no conflict of codes is known of the Haas", **KNOWN, pins="refuses", setup={"machine": "mill"},
    program="O1\nN10 G68 X0 Y0 R30.\nN20 G92 X5.\nN30 M30", runs="N10 N20 N30",
)
case(
    "no feed is in force at power-on of the Haas", **KNOWN, pins="power_on_feed",
    program="O1\nN10 G1 X5.\nN20 M30", runs="", alarm="no-feed", at="O1 N10", word="G1",
)
case(
    "G10 L2 takes no P7 on the Haas", **KNOWN, pins="other_system", setup={"machine": "mill"},
    program="O1\nN10 G10 L2 P7 X5.\nN20 M30", runs="", alarm="g10-p", at="O1 N10", word="P7",
)
case(
    "G10 takes no L52 on the Haas", **KNOWN, pins="data_forms:L52", setup={"machine": "mill"},
    program="O1\nN10 G10 L52\nN20 M30", runs="", alarm="g10-l", at="O1 N10", word="L52",
)
case(
    "G10 P R needs L on the Haas", **KNOWN, pins="data_forms:without-L", setup={"machine": "mill"},
    program="O1\nN10 G10 P1 R5.\nN20 M30", runs="", alarm="g10-word-missing", word="G10", at="O1 N10",
)
case(
    "G154 P names an extra system that G10 L20 sets on the Haas", **KNOWN, pins="data_forms:here",
    setup={"machine": "mill"},
    program="O1\nN10 G10 L20 P2 X5.\nN20 G154 P2 G0 X0\nN30 M30",
    final_machine="X5",
)
case(
    "R of G10 L10 is the length of an H on the Haas", **KNOWN, pins="data_forms:tools", setup={"machine": "mill"},
    program="O1\nN10 G10 L10 P1 R5.\nN20 G43 H1 G0 Z0\nN30 M30", final_machine="Z5",
)
case(
    "#1100 to #1139 are the outputs of the Haas, #3026 its tool", **KNOWN,
    program="O1\nN10 T3 M6\nN20 #1100=1\nN30 #1=#1100+#3026\nN40 #1139=0\nN50 M30", vars={1: 4},
)
case(
    "GOTO to a number that is not there is 539 on the Haas", **KNOWN,
    program="O1\nN10 GOTO 99\nN20 M30", runs="", alarm="jump-target-not-found", number="539", at="O1 N10", word="99",
)
case(
    "a computed length is rounded to four decimals of an inch",
    pins="computed_lengths", control=HAAS, source="HVF p.374", evidence="secondary",
    program="O1\nN10 #1=1.00333\nN20 G20 G90 G0 X[#1+#1]\nN30 #2=#5021\nN40 M30",
    runs="N10 N20 N30 N40", vars={2: 2.0067},
)
