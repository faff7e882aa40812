"""SINUMERIK: programs, how they are called and how they end."""

from conformance import case

ONE = "siemens-one"
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}
MANUAL = {"control": ONE, "source": "SONE p.45, the words that end a program", "evidence": "maker's manual"}

case(
    "a name alone calls its program, M17 returns", **MANUAL,
    program="%_N_MAIN_MPF\nN10 SUB_A\nN20 M30\n%_N_SUB_A_SPF\nN30 G0 X1\nN40 M17",
    runs="N10 N30 N40 N20", calls="call:SUB_A",
)
case(
    "small letters are capitals", control=ONE, source="SONE p.42, program names", evidence="maker's manual",
    program="%_n_main_mpf\nn10 sub_a\nn20 m30\n%_n_sub_a_spf\nn30 g0 x1\nn40 ret",
    runs="N10 N30 N40 N20",
)
case(
    "a program answers to its name with and without what the control puts around it",
    control=ONE, source="828D p.490, example", evidence="secondary",
    program="%_N_MAIN_MPF\nN10 SUB_PROG\nN20 _N_SUB_PROG\nN30 SUB_PROG_SPF\nN40 _N_SUB_PROG_SPF\nN50 M30\n"
    "%_N_SUB_PROG_SPF\nN60 M17",
    runs="N10 N60 N20 N60 N30 N60 N40 N60 N50",
)
case(
    "a head of punched tape may leave the prefix out", control=ONE, source="SONE p.43, %Flange3_MPF",
    evidence="maker's manual",
    program="%Flange3_MPF\nN10 HOLE\nN20 M30\n%HOLE_SPF\nN30 M17", runs="Flange3:N10 HOLE:N30 Flange3:N20",
)
case(
    "a file without a head is the program of its name", control=ONE, source="SONE p.43, names of programs",
    evidence="maker's manual",
    files={"MAIN.MPF": "N10 L100\nN20 M30\n", "L100.SPF": "N30 M17\n"},
    main="MAIN", runs="N10 N30 N20",
)
case(
    "a comment before the first block belongs to no program", control=ONE, source="SONE p.43, names of programs",
    evidence="maker's manual",
    files={"MAIN.MPF": "; first\n;$PATH=/_N_MPF_DIR\nN10 L100\nN20 M30\n", "L100.SPF": "; second\nN30 M17\n"},
    main="MAIN", runs="N10 N30 N20",
)
case(
    "P is how often", **KNOWN,
    program="%_N_MAIN_MPF\nN10 L100 P3\nN20 M30\n%_N_L100_SPF\nN30 G0 X1\nN40 M17",
    runs="N10 (N30 N40)*3 N20",
)
case(
    "P is computed too", **KNOWN,
    program="%_N_MAIN_MPF\nN5 R1=2\nN10 L100 P=R1\nN20 M30\n%_N_L100_SPF\nN40 M17", runs="N5 N10 N40*2 N20",
)
case(
    "P is at most 9999", pins="max_repeats too_many_repeats", **KNOWN,
    program="%_N_MAIN_MPF\nN10 L100 P10000\nN20 M30\n%_N_L100_SPF\nN40 M17",
    runs="", alarm="repeat-count-digits", at="MAIN N10", word="P10000",
)
case(
    "P0 is no count", pins="zero_repeats", **KNOWN,
    program="%_N_MAIN_MPF\nN10 L100 P0\nN20 M30\n%_N_L100_SPF\nN40 M17",
    runs="", alarm="illegal-repeat-count", at="MAIN N10", word="P0",
)
case(
    "L1 and L01 are two programs", **KNOWN,
    program="%_N_MAIN_MPF\nN10 L01\nN20 M30\n%_N_L1_SPF\nN40 M17",
    runs="", alarm="named-program-not-found", number="14011", at="MAIN N10", word="L01",
)
case(
    "a call has a block of its own", **KNOWN,
    program="%_N_MAIN_MPF\nN10 G0 X5 L100\nN20 M30\n%_N_L100_SPF\nN40 M17",
    runs="", alarm="illegal-word-with-call", at="MAIN N10", word="L100",
)
case(
    "a block has one call", **KNOWN,
    program="%_N_MAIN_MPF\nN10 L100 PART\nN20 M30\n%_N_L100_SPF\nN40 M17",
    runs="", alarm="call-given-twice", at="MAIN N10", word="PART",
)
case(
    "L without a number calls nothing", **KNOWN,
    program="%_N_MAIN_MPF\nN10 L\nN20 M30", runs="", alarm="address-without-value", number="12080", at="MAIN N10", word="L",
)
case(
    "fifteen programs are called below the main one, the next is 14012", pins="max_nesting max_total_nesting self_call",
    control=ONE, source="828D p.490, 16 program levels; CW-S, 14012", evidence="secondary",
    program="%_N_MAIN_MPF\nN10 REC\nN20 M30\n%_N_REC_SPF\nN30 G0 X1\nN40 REC\nN50 M17",
    runs="N10 (N30 N40)*14 N30", alarm="nesting-too-deep", number="14012", at="REC N40",
)
case(
    "M17 in the main program ends it", pins="main_return roles:M17=return", **MANUAL,
    program="%_N_MAIN_MPF\nN10 G0 X1\nN20 M17\nN30 G0 X2", runs="N10 N20",
)
case(
    "words beside M17 are executed before it returns", pins="power_on:G20", **KNOWN,
    program="%_N_MAIN_MPF\nN10 PART\nN20 M30\n%_N_PART_SPF\nN30 G0 X4 M17", moves_x=[4],
)
case(
    "M2 ends the program after the words of its block", pins="power_on:G91", **MANUAL,
    program="%_N_MAIN_MPF\nN10 G0 X1\nN20 X2 M2\nN30 X3", moves_x=[1, 2],
)
case(
    "M30 ends it too", pins="roles:M30=end", **MANUAL, program="%_N_MAIN_MPF\nN10 G0 X1\nN20 M30\nN30 X3", runs="N10 N20",
)
case(
    "a program that ends in nothing alarms", pins="missing_end", **KNOWN,
    program="%_N_MAIN_MPF\nN10 G0 X1", runs="N10", alarm="end-of-record", at="MAIN",
)
case(
    "R parameters are the same in all programs", **KNOWN,
    program="%_N_MAIN_MPF\nN10 R1=5\nN20 PART\nN30 M30\n%_N_PART_SPF\nN40 R1=R1+1\nN50 RET", vars={1: 6},
)
case(
    "M30 ends the run from a subprogram too", pins="end_in_subprogram", **KNOWN,
    program="%_N_MAIN_MPF\nN10 PART\nN20 M30\n%_N_PART_SPF\nN30 G0 X1\nN40 M30", runs="N10 N30 N40",
)
case(
    "a program may call the one that called it", pins="caller_call", **KNOWN,
    program="%_N_MAIN_MPF\nN10 ONE\nN20 M30\n%_N_ONE_SPF\nN30 R1=R1+1\nN40 IF R1>1 GOTOF OUT\nN50 TWO\nN60 OUT: M17\n%_N_TWO_SPF\nN70 ONE\nN80 M17",
    runs="N10 N30 N40 N50 N70 N30 N40 N60 N80 N60 N20",
)
