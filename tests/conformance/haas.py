"""Haas NGC: local calls, M99 P and conditional M99, conditions of any value, names of variables, work systems."""

from conformance import case

HAAS = "haas-ngc"
M97 = {"control": HAAS, "source": "H96 p.217, M97", "evidence": "secondary"}
M99 = {"control": HAAS, "source": "HDIY, M99 P", "evidence": "maker's manual"}
VALUES = {"control": HAAS, "source": "HDIY, conditional expressions", "evidence": "maker's manual"}
KNOWN = {"control": HAAS, "source": "general knowledge of the Haas mill", "evidence": "inferred"}
FLOAT = {"162": 1}

# The worked cases

case(
    "five digits of P are one number, not a count and a number (HAAS-02)", pins="max_words max_block_length g_codes program_word max_program_digits",
    control=HAAS, source="H96 p.217: O00012, five digits", evidence="secondary", params=FLOAT,
    program="O00001\nM98 P51000\nM30\nO51000\nG0 X7\nM99\nO01000\nG0 X8\nM99", moves_x=[7],
)
case(
    "M99 P behind the call stands for FANUC's M99 P in the subprogram (HAAS-04)", pins="return_with_p power_on_incremental", **M99, params=FLOAT,
    program="O00001\nM98 P2\nN51 M99 P100\nG0 X1\nN100 G0 X2\nM30\nO00002\nG0 X5\nM99",
    runs="N51 N100", moves_x=[5, 2],
)
case(
    "IF takes any value that is not 0 (HAAS-06)", pins="statements if_form jumps max_condition_length conditions_are_values", **VALUES, params=FLOAT,
    program="O00001\n#1=0.5\nIF [#1] GOTO 30\nG0 X1\nN30 G0 X2\nM30", moves_x=[2],
)
case(
    "the arguments of G65 are set before its first pass alone (HAAS-07)", pins="macro_calls",
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
    "M97 in a called program takes that program's N (HAAS-13)", pins="local_call_m_code", **M97, params=FLOAT,
    program="O00001\nM98 P2\nN100 G0 X99\nM30\nO00002\nM97 P100\nG0 X2\nM99\nN100 G0 X3\nM99",
    moves_x=[3, 2, 99], tree="M98:O00002(M97:O00002)",
)

# M97

case(
    "M97 L runs the part from its N that often and comes back behind the call", pins="call_passes_words", **M97,
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

# M99

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
    "the words beside a conditional M99 wait for the condition", **M99,
    program="O1\nN10 [#1 EQ 2] G0 X5. M99 P30\nN20 [1] G0 X6. M99 P40\nN30 G0 X7.\nN40 M30",
    runs="N10 N20 N40", moves_x=[6],
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

# Conditions and values

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
    "conditions are joined by AND and OR", pins="joined_conditions", **VALUES,
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
    "a code by a variable that the control does not have is an invalid G code", pins="g_codes_complete",
    control=HAAS, source="HDIY, address substitution", evidence="maker's manual",
    program="O1\nN10 #1=145\nN20 G#1\nN30 M30", runs="N10", alarm="g-code-not-available", number="310", at="O1 N20",
)

# Variables

for old, new in ((100, 10100), (199, 10199), (500, 10500), (699, 10699), (800, 10800), (999, 10999)):
    case(
        f"#{old} is another name of #{new}",
        control=HAAS, source="ZAP, Haas system variables", evidence="secondary",
        program=f"O1\nN10 #{old}=5\nN20 #1=#{new}+1\nN30 #{new}=7\nN40 #2=#[{old}]\nN50 M30",
        vars={1: 6, 2: 7, new: 7, old: 7},
    )
for number in (99, 200, 499, 700, 799, 9999, 11000):
    case(
        f"#{number} is no variable of the programs", pins="indirect_9nnn", **KNOWN,
        program=f"O1\nN10 #{number}=5\nN20 M30", runs="", alarm="illegal-variable", number="503", at="O1 N10",
    )
case(
    "a user's alarm is 1000 and its number", pins="user_alarm_offset", **KNOWN,
    program="O1\nN10 #3000=12 (NO TOOL)\nN20 M30", runs="N10", alarm="user-alarm", number="1012", at="O1 N10",
)
case(
    "a user's alarm goes to 999", pins="user_alarm_last", **KNOWN,
    program="O1\nN10 #3000=1000\nN20 M30", runs="", alarm="illegal-user-alarm", at="O1 N10",
)
case(
    "#2001 is the length of an offset and #2201 its wear", pins="power_on_line",
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
    "G154 P99 is the last work system", pins="max_extra_systems", **KNOWN,
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
    "setting 33 as FANUC: M30 ends G52", pins="clear_local_on_reset", **KNOWN, setup={"machine": "mill"},
    program="O1\nN10 G52 X10.\nN20 G0 X0\nN30 M30", work_after_reset="X10",
)
case(
    "setting 33 as HAAS: G52 stays", **KNOWN, setup={"machine": "mill"}, params={"33": 1},
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
    "G04 P. counts seconds and P without a point thousandths", pins="dwell_words dwell_p_seconds dwell_point",
    control=HAAS, source="H96 p.91, G04 P1.", evidence="secondary",
    program="O1\nN10 G04 P1.\nN20 G04 P500\nN30 M30", time=1.5,
)
_UNCOMPUTED = "71 72 88 100 101 102 107 136 141 143 153 155 161 162 163 164 165 166 169 174 184 188 234 253 254 255 268 269"
for code in (*(f"G{number}" for number in _UNCOMPUTED.split()), "G12 I5. D1", "G13 I5. D1", "G47 P0 X1. Y1. R1. Z-1.", "G150 P2 X1. Y1. Z-1. Q1. R1. D1",
             "G70 I5. J0 L4", "G35 D1", "G36 X5. F5.", "G37 Z-5. H1", "G77 Z-5. R1. F50.", "G87 Z-5. R1. F50."):
    case(
        f"{code.split()[0]} is a code of the Haas whose moves are not computed", pins="machine minus_addresses", **KNOWN,
        program=f"O1\nN10 {code}\nN20 M30", runs="", alarm="code-not-computed", at="O1 N10", word=code.split()[0],
    )
for code in ("G66 P2", "G66.1 P2", "G67", "G54.1 P1", "G16", "G33 Z-5. F1.", "G63"):
    case(
        f"the Haas has no {code.split()[0]}", pins="modal_calls modal_every_block", **KNOWN,
        program=f"O1\nN10 {code}\nN20 M30\nO2\nN30 M99", runs="", alarm="g-code-not-available", number="310", at="O1 N10",
    )
case(
    "a code of the alias list calls its program, M without and G with arguments", **KNOWN,
    params={"9000": 33, "9010": 45},
    program="O1\nN10 M33\nN20 G45 A5.\nN30 M30\nO9000\nN40 M99\nO9010\nN50 #100=#1\nN60 M99",
    runs="N10 N40 N20 N50 N60 N30", vars={10100: 5}, calls="M-code:O9000 G-code:O9010",
)
case(
    "an alias whose program is missing is 314", **KNOWN, params={"9001": 33},
    program="O1\nN10 M33\nN20 M30", runs="", alarm="program-not-found", number="314", at="O1 N10",
)
case(
    "two M codes in a block are one too many", pins="m_codes_per_block m_codes_alarm", **KNOWN,
    program="O1\nN10 M3 M8\nN20 M30", runs="", alarm="illegal-m-combination", at="O1 N10",
)
for block, alarm, number in (
    ("#1=1/0", "division-by-zero", "508"), ("END1", "missing-do", "524"),
    ("WHILE [1] DO1", "missing-end", "538"), ("G0 X1. G65 P2", "macro-call-not-first", "528"),
    ("G65 P2 G1.", "illegal-argument", "529"), ("G65", "program-number-missing", "313"),
    ("G65" + " I1. J1. K1." * 11 + " P2", "too-many-argument-sets", "530"),
    ("#1=1]", "bracket-not-opened", "504"),
):
    case(
        f"{block[:20]} shows {number} on the Haas", pins="codes_not_with_macro_call argument_sets words_before_macro_call h_codes", **KNOWN,
        program=f"O1\nN10 {block}\nN20 M30\nO2\nN30 M99", runs="", alarm=alarm, number=number, at="O1 N10",
    )
case(
    "nine macros may be open, the tenth is 531", pins="max_macro_nesting", **KNOWN,
    program="O1\nN10 G65 P2\nN20 M30\nO2\nN30 G65 P2\nN40 M99",
    runs="N10 N30*8", alarm="macro-nesting-too-deep", number="531", at="O2 N30",
)

# What the family does and nobody denies

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
    "an arc with R that ends where it starts is no move on the Haas", **KNOWN, pins="radius_needs_travel",
    program="O1\nN10 G2 X0 Y0 R5. F100.\nN20 M30", runs="N10 N20",
)
case(
    "R turns a rotation by any angle on the Haas", **KNOWN, pins="max_rotation rotation_words",
    program="O1\nN10 G68 X0 Y0 R90.\nN20 G0 X5.\nN30 #1=#5022\nN40 M30", vars={1: 5},
)
case(
    "a variable's number takes no point on the Haas", **KNOWN, pins="variable_point",
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
    "G10 L2 takes no P7 on the Haas", **KNOWN, pins="other_system_is_first", setup={"machine": "mill"},
    program="O1\nN10 G10 L2 P7 X5.\nN20 M30", runs="", alarm="g10-p", at="O1 N10", word="P7",
)
case(
    "G10 takes no L52 on the Haas", **KNOWN, pins="parameters_by_l52", setup={"machine": "mill"},
    program="O1\nN10 G10 L52\nN20 M30", runs="", alarm="g10-l", at="O1 N10", word="L52",
)
case(
    "G10 P R needs L on the Haas", **KNOWN, pins="offsets_without_l", setup={"machine": "mill"},
    program="O1\nN10 G10 P1 R5.\nN20 M30", runs="", alarm="g10-word-missing", word="G10", at="O1 N10",
)

# The entries of its lists, one by one

_RUNS = "9 17 18 21 31 42 44 50 56 57 58 59 61 64 69 74 76 82 84 85 86 89 93 94 95 99 187"
for number in _RUNS.split():
    case(
        f"G{number} is a code of the Haas that runs", **KNOWN,
        program=f"O1\nN10 G{number}\nN20 M30", runs="N10 N20",
    )
case(
    "G29 without G28 before alarms on the Haas", **KNOWN,
    program="O1\nN10 G29 X5.\nN20 M30", runs="", alarm="no-intermediate", at="O1 N10", word="G29",
)
_WORDS = "A1. B1. D1. E1. H1. J1. K1. U1. V1. W1. A-1 B-1 C-1 E-1 J-1 K-1 Q-1 S-1 U-1 V-1 W-1"
for word in _WORDS.split():
    case(f"{word} is a word of the Haas", **KNOWN, program=f"O1\nN10 {word}\nN20 M30", runs="N10 N20")
for word, alarm in ("D-1", "radius-offset-number"), ("F-1", "feed-out-of-range"), ("H-1", "offset-number"):
    case(
        f"{word} is read on the Haas, and out of range", **KNOWN,
        program=f"O1\nN10 {word}\nN20 M30", runs="", alarm=alarm, at="O1 N10", word=word,
    )
for system in range(2, 20):
    case(
        f"G{109 + system} is G154 P{system}",
        control=HAAS, source="H96 p.113; general knowledge of the Haas mill", evidence="inferred",
        program=f"O1\nN10 #{6981 + 20 * system}=5.\nN20 G0 G{109 + system} X1.\nN30 #1=#5021\nN40 M30", vars={1: 6},
    )
for block in ("BPRNT[#1[53]]",):
    case(
        f"no source says whether the Haas has {block[:2]}", **KNOWN,
        program=f"O1\nN10 {block}\nN20 M30", runs="", alarm="statement-not-known", at="O1 N10",
    )
case(
    "the Haas prints with DPRNT between POPEN and PCLOS", **KNOWN,
    program="O1\nN10 #1=5\nN20 POPEN\nN30 DPRNT[X#1[53]]\nN40 PCLOS\nN50 M30", messages=["X     5.000"],
)
case(
    "the functions of the Haas", **KNOWN,
    program="O1\nN10 #1=TAN[0]\nN20 #2=ACOS[1]\nN30 #3=SQRT[9]\nN40 #4=ABS[-2]\nN50 #5=ROUND[1.6]\nN60 #6=FIX[1.6]\nN70 M30",
    vars={1: 0, 2: 0, 3: 3, 4: 2, 5: 2, 6: 1},
)
case(
    "FUP is no function of the Haas", **KNOWN,
    program="O1\nN10 #1=FUP[1.2]\nN20 M30", runs="", alarm="expression-format", at="O1 N10",
)
case(
    ",R rounds a corner on the Haas", **KNOWN, setup={"machine": "mill"},
    program="O1\nN10 G1 X5. ,R1. F100.\nN20 Y5.\nN30 M30", moves="F X4\nCCW X5 Y1 C X4 Y1\nF Y5",
)

# Where others answer otherwise

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
GSK = ["gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi"]
WITH_MACROS = [*GSK, *MITSUBISHI, *FANUC]
OTHERS = [*WITH_MACROS, "hnc-21m", "gsk-928te"]


def on(controls, fanuc, mitsubishi, gsk_988, gsk_980):
    table = {
        **dict.fromkeys(FANUC, f"PS{fanuc}"), "fanuc-16i": fanuc[-3:], **dict.fromkeys(MITSUBISHI, mitsubishi),
        **dict.fromkeys(GSK[:2], gsk_988), **dict.fromkeys(GSK[2:], gsk_980),
    }
    return {name: table.get(name) for name in controls}


case(
    "only on the Haas a condition stands before M99", pins="conditional_return",
    control=[*WITH_MACROS, "hnc-21m"], source="HDIY: it is unique to the Haas", evidence="inferred",
    program="O1\nN10 [1 EQ 1] M99 P30\nN20 M30\nN30 M30", runs="", alarm="value-without-address", at="O1 N10", word="[",
    number=on([*WITH_MACROS, "hnc-21m"], "0004", "P33", "004", None),
)
case(
    "a condition compares two values on other controls than the Haas", pins="conditions_are_values",
    control=WITH_MACROS, source="X-GO; general knowledge", evidence="inferred",
    program="O1\nN10 #1=1\nN20 IF[#1]GOTO 40\nN30 M30\nN40 M30", runs="N10", alarm="if-format", at="O1 N20",
    number=on(WITH_MACROS, "1137", "P290", "201", "0101") | {"fanuc-16i": "114"},
)
case(
    "M01 calls nothing", pins="local_call_m_code",
    control=OTHERS, source="general knowledge", evidence="inferred", program="O1\nN10 M1\nN20 M30", runs="N10 N20",
)
case(
    "G66 and G67 stand beside G65 on other controls than the Haas", pins="modal_calls",
    control=WITH_MACROS, source="source 002; M7V; TDi28; TA", evidence="inferred",
    program="O1\nN10 G66 P2\nN20 G0 Z5.\nN30 G67\nN40 M30\nO2\nN50 M99", runs="N10 N20 N50 N30 N40",
)
