"""Syntec: calls, returns, and codes that call programs, in ISO files."""

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
    "M99 Q goes on at a line of the caller's file", pins="return_to_line", **MAKER,
    program="O1\nN10 G0\nN20 M98 P2\nN30 X2.\nN40 X3.\nN50 M30\nO2\nN60 X9.\nN70 M99 Q5",
    runs="N10 N20 N60 N70 N40 N50", moves_x=[9, 3],
)
case(
    "a line without a block is that of the next one, and Q may be computed", pins="return_to_line", **MAKER | {"evidence": "inferred"},
    program="O1\nN10 M98 P2\nN20 M0\n\n(A NOTE)\nN30 M30\nO2\nN40 #1=4\nN50 M99 Q#1", runs="N10 N40 N50 N30",
)
case(
    "M99 Q of a line that the caller has not alarms, and nobody says by which number", pins="return_to_line", **MAKER | {"evidence": "inferred"},
    program="O1\nN10 M98 P2\nN20 M30\nO2\nN30 M99 Q4", runs="N10", alarm="return-target-not-found", number=None, at="O2 N30", word="Q4",
)
case(
    "M99 Q in the main program goes on at its own line", pins="return_to_line", **MAKER | {"evidence": "inferred"},
    program="O1\nN10 #1=#1+1\nN20 M99 Q4\nN30 M30", runs="N10 N20 N30",
)
case(
    "Q is no word of M99 elsewhere", pins="return_to_line",
    control=["fanuc-16i", "fanuc-30i", "mitsubishi-m700", "gsk-988ta", "gsk-980mdi", "haas-ngc", "hnc-21m"], source="general knowledge", evidence="inferred",
    program="O1\nN10 M98 P2\nN20 M30\nO2\nN30 M99 Q4", runs="N10 N30 N20",
)
case(
    "G66 calls after each block that moves an axis, and after no other", pins="modal_trigger roles:G66=modal-call", **MAKER,
    program="O1\nN10 G66 P2\nN20 G0 X1.\nN25 X1.\nN30 M8\nN40 #1=5\nN50 X2.\nN60 G67\nN70 X3.\nN80 M30\nO2\nN90 M99",
    runs="N10 N20 N90 N25 N30 N40 N50 N90 N60 N70 N80",
)
case(
    "G66.1 calls after each block, which itself is executed", pins="roles:G66.1=modal-call-every-block", **MAKER,
    program="O1\nN10 G66.1 P2\nN20 G0 X1.\nN30 M8\nN40 #1=5\nN50 X2.\nN60 G67\nN70 X3.\nN80 M30\nO2\nN90 G91 X0.1\nN95 G90 M99",
    runs="N10 N20 N90 N95 N30 N90 N95 N40 N90 N95 N50 N90 N95 N60 N70 N80", moves_x=[1, 1.1, 1.2, 1.3, 2, 2.1, 3],
)
case(
    "the locals of G66.1 are its own and kept until G67", pins="modal_locals", **MAKER,
    program="O1\nN10 #1=9\nN20 G66.1 P2 A1.\nN30 M8\nN40 M9\nN50 G67\nN60 #501=#1\nN70 M30\nO2\nN80 #1=#1+1\nN90 #500=#1\nN95 M99", vars={500: 3, 501: 9},
)
case(
    "M99 under G66.1 waits for its macro", pins="roles:G66.1=modal-call-every-block", **MAKER | {"evidence": "inferred"},
    program="O1\nN10 M98 P3\nN20 M30\nO2\nN90 M99\nO3\nN30 G66.1 P2\nN40 M99", runs="N10 N30 N40 N90 N20",
)
for code, name in (("G200", "G0200"), ("G999", "G0999"), ("G200.1", "G200001"), ("G200.10", "G200010"), ("G0200", "G0200")):
    case(
        f"{code} calls the program {name} as a macro", **MAKER,
        main="O1",
        files={"O1": f"N10 #1=5\nN20 {code} X7. P3 L2\nN30 #502=#1\nN40 M30\n", name: "N50 #500=#24\nN60 #501=#16\nN70 #1=8\nN80 M99\n"},
        runs="N10 N20 (N50 N60 N70 N80)*2 N30 N40", vars={500: 7, 501: 3, 502: 5},
    )
case(
    "G200 wants its program, and nobody says by which number", **MAKER | {"evidence": "inferred"},
    program="O1\nN10 G200\nN20 M30", runs="", alarm="named-program-not-found", number=None, at="O1 N10", word="G200",
)
case(
    "what G199 is nobody says", pins="unlisted_codes", **MAKER | {"evidence": "inferred"},
    program="O1\nN10 G199\nN20 M30", runs="", alarm="code-not-known", number=None, at="O1 N10", word="G199",
)
case(
    "a parameter registers an M code, which calls the macro of its name", **MAKER, params={"3601": 123, "3602": 50},
    main="O1",
    files={"O1": "N10 M50\nN20 M123 A2.\nN30 M8\nN40 M30\n", "M0050": "N50 M99\n", "M0123": "N60 #500=#1\nN70 M99\n"},
    runs="N10 N50 N20 N60 N70 N30 N40", vars={500: 2}, m=[8],
)
case(
    "in the macro of an M code no other M code calls", pins="code_cascade", **MAKER, params={"3601": 123, "3602": 50},
    main="O1",
    files={"O1": "N10 M123\nN40 M30\n", "M0123": "N60 M50\nN70 M99\n", "M0050": "N50 M99\n"}, runs="N10 N60 N70 N40", m=[50],
)
for code in (2, 30, 96, 97, 98, 99):
    case(
        f"M{code:02} cannot be registered", **MAKER, params={"3601": code},
        program=f"O1\nN10 M{code:02} P2\nN20 M30\nO2\nN30 M99", runs="", alarm="code-may-not-call", number="OP-020", at="O1 N10",
    )
case(
    "T calls T0000 as a macro, with #1 to #400 of its own", **MAKER, params={"3215": 2},
    main="O1",
    files={"O1": "N10 #27=5\nN20 T3\nN30 #500=#27\nN40 M30\n", "T0000": "N50 #27=8\nN60 T4\nN70 M99\n"}, runs="N10 N20 N50 N60 N70 N30 N40", vars={500: 5}, t=[4],
)
case(
    "T calls T0000 as a subprogram, which shares #1 to #400", **MAKER, params={"3215": 1},
    main="O1",
    files={"O1": "N10 #27=5\nN20 T3\nN30 #500=#27\nN40 M30\n", "T0000": "N50 #27=8\nN70 M99\n"}, runs="N10 N20 N50 N70 N30 N40", vars={500: 8},
)
case(
    "T calls nothing as delivered", **MAKER,
    main="O1",
    files={"O1": "N20 T3\nN40 M30\n", "T0000": "N50 M99\n"}, runs="N20 N40", t=[3],
)
case(
    "M198 shares #1 to #400 and begins at its H", **MAKER,
    program="O1\nN10 #27=5\nN20 M198 P2 H60 L2\nN30 M30\nO2\nN50 M0\nN60 #27=#27+1\nN70 M99", runs="N10 N20 (N60 N70)*2 N30", vars={27: 7},
)
for name, text, word in (
    ("an assignment by :=", "#1 := 5", None), ("IF", "IF #1 = 5 THEN", "IF"), ("FOR", "FOR #1 := 1 TO 5 DO", None), ("REPEAT", "REPEAT", None),
    ("CASE", "CASE #1 OF", None), ("WHILE", "WHILE #1 < 5 DO", "WHILE"), ("END_IF", "END_IF", None), ("GOTO", "GOTO 20", None), ("@", "@1=5", "@1"),
    ("EXIT", "EXIT", None), ("MSG", "MSG(1)", None),
):
    case(
        f"{name} in an ISO file is a syntax error", **MAKER, **({"pins": "statements"} if word in ("IF", "WHILE") else {}),
        program=f"O1\nN10 M8\nN15 {text}\nN20 M30", runs="N10",
        alarm={":=": "missing-equals", "@1": "illegal-character"}.get(text.split()[1] if text.startswith("#") else text[:2], "statement-not-available"),
        number="COM-003", at="O1 N15", **({"word": word} if word else {}),
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
    "the locals of G66 are kept until G67", pins="modal_locals", **MAKER,
    program="O1\nN10 G66 P2 A1.\nN20 G0 X1.\nN30 X2.\nN40 G67\nN50 M30\nO2\nN60 #500=#1\nN70 #1=9\nN80 M99", vars={500: 9},
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
case(
    "in which pass M99 P leaves nobody says: the last one", pins="return_with_p",
    control=SYNTEC, source="policy, nobody says", evidence="inferred",
    program="O1\nN10 M98 P2 L2\nN20 M0\nN30 M30\nO2\nN40 #1=#1+1\nN50 M99 P30", runs="N10 (N40 N50)*2 N30", vars={1: 2},
)
case(
    "I, J and K are #4, #5 and #6, however often they are written", pins="argument_sets", **MAKER | {"evidence": "inferred"},
    program="O1\nN10 G65 P2 I1. J2. K3. I4.\nN20 M30\nO2\nN30 M99", runs="N10 N30 N20", arguments={4: 4, 5: 2, 6: 3},
)
case(
    "between numbers AND ranks like a product", pins="logic_order",
    control=SYNTEC, source="general knowledge", evidence="inferred",
    program="O1\nN10 #1=1+2AND2\nN20 M30", vars={1: 3},
)
inert("user_alarm_offset user_alarm_last modal_groups refuses:illegal-variable-value", control=SYNTEC, reason="nothing is known of its system variables")
inert(
    "if_form loop_form max_loop_number loops_count_across_calls max_condition_length prints_leading_blanks refuses:jump-in-mdi"
    " conditions:joined conditions:values conditions:symbols conditions:bare",
    control=SYNTEC, reason="an ISO file has no IF, no loops and no output: COM-003",
)
inert("refuses:jump-in-offset", control=SYNTEC, reason="no source says that a GOTO is refused in radius compensation")
inert("variable_options", control=SYNTEC, reason="no source tells of variables that are bought")
inert(
    "skip_own_feed max_skip_signals skip_signals measuring measured",
    control=SYNTEC, reason="nothing is known of its skip signals and of its measuring",
)
