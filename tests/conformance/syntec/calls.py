"""Syntec: a program that calls a part of itself, M98 P H L, M99 P."""

from conformance import case, inert

SYNTEC = "syntec-22ma"

case(
    "M98 H calls what its N heads in its own program, as the post of the Syil writes it",
    pins="start_word omitted_program",
    control=SYNTEC, source="SYP, M98 H9000", evidence="secondary",
    program="""
        O1
        N10 G91 M98 H9000
        N20 M98 H9000
        N30 M30
        N9000 G1 X10. F500
        N9010 M99
    """,
    runs="N10 N9000 N9010 N20 N9000 N9010 N30", moves="F X10\nF X20",
)
case(
    "M98 H L repeats the part (SYN-01)",
    control=SYNTEC, source="PWR p.149, M98 P H L", evidence="secondary",
    program="O1\nN10 G0 X1.\nN20 M98 H50 L2\nN30 G0 X2.\nN40 M30\nN50 G0 X8.\nN60 M99",
    runs="N10 N20 (N50 N60)*2 N30 N40",
)
case(
    "M98 P H starts the other program at its N",
    control=SYNTEC, source="PWR p.149, M98 P H L", evidence="secondary",
    program="O1\nN10 M98 P2 H70\nN20 M30\nO2\nN60 G0 X1.\nN70 G0 X2.\nN80 M99",
    runs="N10 N70 N80 N20",
)
case(
    "M99 P goes on at a block of the caller (SYN-02)",
    control=SYNTEC, source="PWR p.150, M99 P", evidence="secondary",
    program="O1\nN10 M98 P2\nN20 G0 X1.\nN90 G0 X2.\nN95 M30\nO2\nN200 M99 P90",
    runs="N10 N200 N90 N95",
)
case(
    "M98 H is called from MDI as well",
    pins="mdi_calls",
    control=SYNTEC, source="PWR p.149: in memory and MDI", evidence="secondary",
    program="O2\nN60 G0 X1.\nN70 G0 X2.\nN80 M99", mdi="M98 P2 H70",
    runs="N70 N80",
)
case(
    "G65 P Z passes Z to the macro",
    pins="roles:G65=macro-call",
    control=SYNTEC, source="SYP, G65 P9810 Z", evidence="secondary",
    program="O1\nN10 G65 P9810 Z5.\nN20 M30\nO9810\nN30 #500=#26\nN40 M99",
    runs="N10 N30 N40 N20", vars={500: 5},
)
case(
    "M and T are arguments, as the tool breakage macro of the Syil takes them",
    control=SYNTEC, source="SYP, G65 P9921 M23. C0. T1.", evidence="secondary",
    program="O1\nN10 G65 P9921 M23. C0. T3.\nN20 M30\nO9921\nN30 M99",
    runs="N10 N30 N20", arguments={13: 23, 3: 0, 20: 3}, t=[],
)
case(
    "a part that its program does not have alarms, without a number that anybody knows",
    control=SYNTEC, source="SYP, M98 H9000", evidence="secondary",
    program="O1\nN10 M98 H9000\nN20 M30",
    runs="", alarm="start-not-found", number=None, at="O1 N10", word="H9000",
)
case(
    "P of M98 is a number, and holds no count",
    pins="program_word",
    control=SYNTEC, source="general knowledge", evidence="inferred",
    program="O1\nN10 M98 P20002\nN20 M30\nO20002\nN30 M99",
    runs="N10 N30 N20",
)
MAKER = {"control": SYNTEC, "source": "SYM, digest of the maker's pages", "evidence": "secondary"}
case(
    "M30 in a subprogram returns to the caller", pins="end_in_subprogram", **MAKER,
    program="O1\nN10 G0\nN20 M98 P2\nN30 X2.\nN40 M30\nO2\nN50 X9.\nN60 M30\nN70 X8.",
    runs="N10 N20 N50 N60 N30 N40", moves_x=[9, 2],
)
case(
    "M02 in a subprogram ends one pass of it", **MAKER | {"evidence": "inferred"},
    program="O1\nN10 G91 G0\nN20 M98 P2 L3\nN30 X2.\nN40 M30\nO2\nN50 X9. M2",
    runs="N10 N20 N50*3 N30 N40", moves_x=[9, 18, 27, 29],
)
case(
    "M30 in the main program ends the run", **MAKER,
    program="O1\nN10 M98 P2\nN20 M30\nN30 M99\nO2\nN40 M30", runs="N10 N40 N20",
)
case(
    "G65 has its own #1 to #400, #100 too", pins="commons", **MAKER,
    program="O1\nN10 #100=5\nN20 #400=6\nN25 #401=2\nN30 G65 P2\nN40 #500=#100+#400*10\nN50 M30\nO2\nN60 #501=#100\nN70 #100=7\nN80 #400=8\nN90 #999=#401\nN95 M99",
    vars={500: 65, 501: None, 100: 5, 999: 2},
)
case(
    "M98 shares #1 to #400", **MAKER,
    program="O1\nN10 #27=5\nN20 M98 P2\nN30 M30\nO2\nN40 #500=#27\nN50 #27=7\nN60 M99", vars={500: 5, 27: 7},
)
case(
    "nobody says what a system variable of it holds", pins="unlisted_variables", **MAKER,
    program="O1\nN10 #1=#1000\nN20 M30", runs="", alarm="variable-not-known", number=None, at="O1 N10", word="#1000",
)
for name in ("#2000", "#3000", "#5041", "#4003", "#2001"):
    case(
        f"{name} of the Mitsubishi is none of the Syntec", **MAKER,
        program=f"O1\nN10 {name}=1\nN20 M30", runs="", alarm="variable-not-known", number=None, at="O1 N10",
    )
case(
    "a return to a line of the file is not computed", pins="return_to_line", **MAKER,
    program="O1\nN10 M98 P2\nN20 M30\nO2\nN30 M99 Q4", runs="N10", alarm="code-not-computed", number=None, at="O2 N30", word="Q4",
)
case(
    "Q is no word of M99 elsewhere", pins="return_to_line",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700", "gsk-988ta", "gsk-980mdi", "haas-ngc", "hnc-21m"], source="general knowledge", evidence="inferred",
    program="O1\nN10 M98 P2\nN20 M30\nO2\nN30 M99 Q4", runs="N10 N30 N20",
)
case(
    "G66.1 is executed before its macro, which is not computed", pins="g_meanings roles:G66.1=modal-call-every-block", **MAKER,
    program="O1\nN10 G66.1 P2\nN20 M30\nO2\nN50 M99", runs="", alarm="code-not-computed", number=None, at="O1 N10", word="G66.1",
)
case(
    "what G200 calls is not known here", pins="unlisted_codes", **MAKER,
    program="O1\nN10 G200\nN20 M30", runs="", alarm="code-not-known", number=None, at="O1 N10", word="G200",
)
case(
    "M198 wants its P", **MAKER,
    program="O1\nN10 M198\nN20 M30", runs="", alarm="program-number-missing", number="COR-052", at="O1 N10",
)
case(
    "G65 wants its P, and nobody says by which number", **MAKER | {"evidence": "inferred"},
    program="O1\nN10 G65 A1.\nN20 M30", runs="", alarm="program-number-missing", number=None, at="O1 N10",
)
case(
    "#9005 is a variable of which nobody says anything", pins="variable_forms:9nnn", **MAKER | {"evidence": "inferred"},
    program="O1\nN10 #5=6\nN20 #1=#9005\nN30 M30", runs="N10", alarm="variable-not-known", number=None, at="O1 N20",
)
case(
    "of two P of G65 the last counts", pins="repeated_argument",
    control=SYNTEC, source="general knowledge", evidence="inferred",
    program="O1\nN10 G65 P3 P2\nN20 M30\nO2\nN30 M99\nO3\nN40 M99", runs="N10 N30 N20",
)
case(
    "the arguments of G66 are there again at each call", pins="modal_locals",
    control=SYNTEC, source="policy, nobody says", evidence="inferred",
    program="O1\nN10 G66 P2 A1.\nN20 G0 X1.\nN30 X2.\nN40 G67\nN50 M30\nO2\nN60 #500=#1\nN70 #1=9\nN80 M99", vars={500: 1},
)
case(
    "a P of G10 L2 that is no system is the first", pins="other_system",
    control=SYNTEC, source="general knowledge", evidence="inferred", setup={"machine": "mill"},
    program="O1\nN10 G10 L2 P9 X5.\nN20 G54 G0 X0\nN30 M30", final_machine="X5",
)
case(
    "reset makes the locals vacant and leaves what is kept", pins="reset_clears:locals reset_clears:commons", **MAKER,
    program="O1\nN10 #1=5\nN20 #401=6\nN30 M30", vars={1: 5, 401: 6}, vars_after_reset={1: None, 401: 6},
)
case(
    "M99 P goes on at N200 of the main program (SYN3-07)", **MAKER,
    program="O1\nN10 G0\nN20 M98 P7002\nN30 X9.\nN40 M30\nN200 X1.\nN210 M30\nO7002\nN50 M99 P200", runs="N10 N20 N50 N200 N210", moves_x=[1],
)
case(
    "L0 calls nothing (SYN3-09)", **MAKER,
    program="O1\nN10 G0\nN20 M98 P2 L0\nN30 X1.\nN40 M30\nO2\nN50 X9.\nN60 M99", runs="N10 N20 N30 N40", moves_x=[1],
)
inert("user_alarm_offset user_alarm_last modal_groups refuses:illegal-variable-value", control=SYNTEC, reason="nothing is known of its system variables")
inert("variable_options", control=SYNTEC, reason="no source tells of variables that are bought")
inert("code_cascade", control=SYNTEC, reason="nothing is known of codes that call a program there")
inert(
    "skip_own_feed max_skip_signals skip_signals measuring measured",
    control=SYNTEC, reason="nothing is known of its skip signals and of its measuring",
)
