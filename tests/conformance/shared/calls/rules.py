"""Calls and returns: what a control has and does not have, rule by rule."""

from conformance import case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI = GSK_980 = ["gsk-980tdi", "gsk-980mdi"]
GSK = GSK_988 + GSK_980
MELDAS, M700, M800 = MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, F0D, F0F, F30 = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
FANUC_PS = FANUC[1:]
HNC, TE = "hnc-21m", "gsk-928te"

# Calls and returns

case(
    "M1 without its switch does not start the program over",
    pins="roles:M01=start-over",
    control=[*GSK, *MITSUBISHI, *FANUC, "haas-ngc"], source="general knowledge, M01", evidence="inferred",
    program="""
        O1
        N10 M1
        N20 M30
    """,
    runs="N10 N20",
)
case(
    "M97 is no jump but a code for the machine",
    pins="roles:M97=jump",
    control=[*GSK, *MITSUBISHI, *FANUC], source="TApar 6003#4; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 M97 P30
        N20 T1
        N30 M30
    """,
    runs="N10 N20 N30", m=[97], t=[1],
)
case(
    ",D names no device",
    pins="device_word",
    control=[*GSK, MELDAS, *FANUC, "haas-ngc"], source="general knowledge, device words", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 M98 P2 ,D1
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="address-not-usable",
    number={**dict.fromkeys(GSK_988, "008"), **dict.fromkeys(GSK_980, None), MELDAS: "P32", F16: "009", **dict.fromkeys(FANUC_PS, "PS0009"), "haas-ngc": None},
    at="O1 N20", word=",D1",
)
case(
    "eight digits of P with four zeros in front are one call",
    pins="refuses:illegal-repeat-count",
    control=[*GSK_988, *FANUC], source="policy; PB304", evidence="inferred",
    program="""
        O1
        N10 M98 P00000002
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "zeros in front of P's number are nothing on a Mitsubishi",
    control=MITSUBISHI, source="IMD, P; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P00000002
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a count of zeros in P is refused on the 980",
    pins="refuses:illegal-repeat-count",
    control=GSK_980, source="MDia 092", evidence="inferred",
    program="""
        O1
        N10 M98 P00000002
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-repeat-count", number="0092", at="O1 N10",
)
case(
    "M99 P leaves at once, whatever passes remain",
    control=[*GSK_988, *FANUC], source="source 000, M99; policy", evidence="inferred",
    program="""
        O1
        N10 M98 P2 L3
        N20 T1
        N30 M30
        O2
        N40 M99 P30
    """,
    runs="N10 N40 N30",
)
case(
    "M99 L0 is M99",
    pins="count_and_l return_with_l",
    control=[*GSK_988, F16, "haas-ngc"], source="policy", evidence="inferred",
    program="""
        O1
        N10 M98 P2 L3
        N30 M30
        O2
        N40 M99 L0
    """,
    runs="N10 N40*3 N30",
)
case(
    "M99 L0 is M99 on the 980",
    pins="return_with_l",
    control=GSK_980, source="policy", evidence="inferred",
    program="""
        O1
        N10 M98 P30002
        N30 M30
        O2
        N40 M99 L0
    """,
    runs="N10 N40*3 N30",
)
case(
    "other words may stand beside M99 while a modal call is active",
    pins="refuses:illegal-word-with-return",
    control=[*GSK, *MITSUBISHI, F16], source="policy", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G0 X5
        N30 G67
        N40 M30
        O2
        N50 T1 M99
    """,
    runs="N10 N20 N50 N30 N40", t=[1],
)
case(
    "other words beside M99 alarm while a modal call is active",
    pins="refuses:illegal-word-with-return",
    control=FANUC_PS, source="ALM PS1093", evidence="secondary",
    program="""
        O1
        N10 G66 P2
        N20 G0 X5
        N30 G67
        N40 M30
        O2
        N50 T1 M99
    """,
    runs="N10 N20", alarm="illegal-word-with-return", number="PS1093", at="O2 N50",
)
case(
    "G54 may share a block with M98",
    pins="codes_not_with_call",
    control=[*GSK_988, *MITSUBISHI, *FANUC, "haas-ngc"], source="PMI39; SM 3; source 000, words L and Q (5)",
    evidence="inferred",
    program="""
        O1
        N10 G54 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "G4 may share a block with M98",
    control=[*GSK_988, *MITSUBISHI, *FANUC], source="PMI39; SM 3; source 000, words L and Q (5)",
    evidence="inferred",
    program="""
        O1
        N10 G4 X1. M98 P2
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "G28 may share a block with M99",
    pins="codes_not_with_return",
    control=[MDI, *MITSUBISHI, *FANUC, "haas-ngc"], source="K-H, words before M99", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 G28 Z0 M99
    """,
    runs="N10 N30 N20",
)
case(
    "G53 may share a block with M99 on the 980TDi",
    pins="codes_not_with_return",
    control=TDI, source="policy", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 G53 Z0 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a P in M98 that is not whole is cut",
    pins="call_values",
    control=GSK, source="source 000, word P; policy", evidence="inferred",
    program="""
        O1
        N10 M98 P#100
        N20 M30
        O2
        N30 M99
        O3
        N40 M99
    """,
    variables={100: 2.7}, runs="N10 N30 N20",
)
case(
    "M98 without P is refused though it names a start",
    control=T, source="Talm 081", evidence="secondary",
    program="""
        O1
        N10 M8
        N20 M98 Q40
        N30 M30
        N40 M99
    """,
    runs="N10", alarm="program-number-missing", number="081", at="O1 N20",
)
case(
    "M98 with Q alone is refused on the 980",
    control=GSK_980, source="MDia 095", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 M98 Q40
        N30 M30
        N40 M99
    """,
    runs="N10", alarm="program-number-missing", number="0095", at="O1 N20",
)
case(
    "M98 with Q alone is refused on the 16i",
    control=F16, source="K-H 076", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 M98 Q40
        N30 M30
        N40 M99
    """,
    runs="N10", alarm="program-number-missing", number="076", at="O1 N20",
)
case(
    "Q of M98 starts at its block",
    pins="start_word",
    control=T, source="source 000, words L and Q (1)", evidence="inferred",
    program="""
        O1
        N10 M98 P2 Q40
        N20 M30
        O2
        N30 T1
        N40 M99
    """,
    runs="N10 N40 N20",
)
case(
    "Q of M98 starts nothing: the call begins at the head",
    pins="start_word",
    control=[*GSK_980, F16], source="general knowledge, M98 without a start word",
    evidence="inferred",
    program="""
        O1
        N10 M98 P2 Q40
        N20 M30
        O2
        N30 T1
        N40 M99
    """,
    runs="N10 N30 N40 N20",
)
case(
    "H of M98 starts nothing: the call begins at the head",
    pins="start_word",
    control=[*GSK, *FANUC, "haas-ngc"], source="general knowledge, M98 without H", evidence="inferred",
    program="""
        O1
        N10 M98 P2 H20
        N50 M30
        O2
        N15 T1
        N20 M99
    """,
    runs="N10 N15 N20 N50",
)
case(
    "a program cannot call itself, with Q neither",
    control=T, source="Talm 084", evidence="secondary",
    program="""
        O1
        N10 M8
        N20 M98 P1 Q40
        N30 M30
        N40 M99
    """,
    runs="N10", alarm="program-calls-itself", number="084", at="O1 N20",
)
case(
    "a subprogram cannot call its caller, with Q neither",
    control=T, source="Talm 084", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N30 M30
        N40 M99
        O2
        N50 M98 P1 Q40
        N60 M99
    """,
    runs="N10", alarm="program-calls-caller", number="084", at="O2 N50",
)
case(
    "a program may call itself with a start block",
    control=[M700, M800], source="IMD; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P1 H40
        N30 M30
        N40 M99
    """,
    runs="N10 N40 N30",
)
case(
    "a program may call itself without a start block",
    control=[*MITSUBISHI, *FANUC], source="ALM PS0077; SM", evidence="inferred",
    program="""
        O1
        N10 #100=#100+1
        N20 IF[#100 GE 3]GOTO 40
        N30 M98 P1
        N40 IF[#100 LT 9]GOTO 60
        N50 M30
        N60 #100=9
        N70 M99
    """,
    runs="N10 N20 N30 N10 N20 N30 N10 N20 N40 N60 N70 N40 N50", vars={100: 9},
)
case(
    "a subprogram may call the program that called it",
    pins="caller_call",
    control=[*MITSUBISHI, *FANUC, "haas-ngc"], source="ALM PS0077; SM", evidence="inferred",
    program="""
        O1
        N10 #100=#100+1
        N20 IF[#100 GE 2]GOTO 50
        N30 M98 P2
        N40 M30
        N50 M99
        O2
        N60 M98 P1
        N70 M99
    """,
    runs="N10 N20 N30 N60 N10 N20 N50 N70 N40",
)
case(
    "a subprogram may call a subprogram that is open, but not the main program",
    control=GSK_980, source="MDia 094", evidence="inferred",
    program="""
        O1
        N10 #100=0
        N20 M98 P2
        N30 M30
        O2
        N40 #100=#100+1
        N50 IF[#100 GE 2]GOTO 70
        N60 M98 P3
        N70 M99
        O3
        N80 M98 P2
        N90 M99
    """,
    runs="N10 N20 N40 N50 N60 N80 N40 N50 N70 N90 N70 N30",
)
case(
    "L0 is no count",
    pins="zero_repeats",
    control=GSK_988, source="source 000, words L and Q (2)", evidence="source document",
    program="""
        O1
        N10 M8
        N20 M98 P2 L0
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="illegal-repeat-count", number="003", at="O1 N20",
)
case(
    "L0 of a macro call is no count on the 980",
    pins="zero_repeats",
    control=GSK_980, source="TDi28, L 1 to 9999; MDia 092", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 G65 P2 L0
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="illegal-repeat-count", number="0092", at="O1 N20",
)
case(
    "L above 9999 makes 9999 passes",
    pins="too_many_repeats",
    control=GSK_988, source="source 000, M198 (3); TA28", evidence="inferred",
    program="""
        O1
        N10 M98 P2 L10000
        N20 M30
        O2
        #100=#100+1
        M99
    """,
    runs="N10 N20", vars={100: 9999},
)
case(
    "a count in P and an L are refused together on the 988T",
    control=T, source="source 000, words L and Q (3)", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 M98 P30002 L2
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="repeat-given-twice", at="O1 N20",
)
case(
    "an L beside a plain P of the 980 counts nothing",
    pins="count_and_l",
    control=GSK_980, source="TDi15, M98: L only with P[name]", evidence="inferred",
    program="""
        O1
        N10 M98 P30002 L2
        N20 M30
        O2
        N40 M99
    """,
    runs="N10 N40*3 N20",
)
case(
    "M198 is a code for the machine",
    pins="roles:M198=external-call",
    control=[*GSK_980, MELDAS, "haas-ngc"], source="general knowledge, no external calls",
    evidence="inferred",
    program="""
        O1
        N10 M198 P2
        N20 M30
    """,
    external={"O2.CNC": "N30 M99\n"}, runs="N10 N20", m=[198],
)
case(
    "M198 calls from the external device on the 988T",
    pins="roles:M198=external-call",
    control=T, source="source 000, M198", evidence="inferred",
    program="""
        O1
        N10 M198 P2
        N20 M30
    """,
    external={"O0002.CNC": "O0002\nN30 M99\n"}, runs="N10 N30 N20", calls="M198:O0002",
)
case(
    "M99 P takes the nearest block after the call",
    pins="return_search",
    control=T, source="source 000, note 2", evidence="inferred",
    program="""
        O1
        N20 T1
        N10 M98 P2
        N20 T2
        N20 T3
        N40 M30
        O2
        N50 M99 P20
    """,
    runs="N20 N10 N50 N20 N20 N40", t=[1, 2, 3],
)
case(
    "M99 P takes the first block from the head",
    pins="return_search return_with_p",
    control=[*GSK_980, *MITSUBISHI, *FANUC], source="policy, GED", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 IF[#100 EQ 1]GOTO 50
        N30 #100=1
        N40 M98 P2
        N20 T2
        N50 M30
        O2
        N60 M99 P20
    """,
    variables={100: 0}, runs="N10 N20 N30 N40 N60 N20 N50", t=[1],
)
case(
    "P[NAME] calls a program by its name on the 988T",
    pins="bracket_names name_marks",
    control=T, source="source 000, word P, format 2", evidence="inferred",
    files={"O0001.CNC": "O0001\nN10 M98 P[T+1-A_B.C]\nN20 M30\n", "T+1-A_B.C.CNC": "N30 M99\n"},
    main="O0001", runs="N10 N30 N20",
)
case(
    "P[NAME] is no call on this control",
    pins="bracket_names",
    control=[MDI, *MITSUBISHI, *FANUC, "haas-ngc"], source="general knowledge, no names in brackets",
    evidence="inferred",
    program="""
        O1
        N10 M8
        N20 M98 P[CUT]
        N30 M30
    """,
    runs="N10", alarm="expression-format",
    number={MDI: "0101", **dict.fromkeys(MITSUBISHI, "P282"), F16: "125", **dict.fromkeys(FANUC_PS, "PS1125"), "haas-ngc": None},
    at="O1 N20",
)
case(
    "a name of 32 characters can be called in brackets",
    pins="max_name_length",
    control=GSK_988, source="policy", evidence="inferred",
    files={"O0001.CNC": "O0001\nN10 M98 P[AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA]\nN20 M30\n", "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA.CNC": "N30 M99\n"},
    main="O0001", runs="N10 N30 N20",
)
case(
    "a name of 33 characters cannot be called in brackets",
    control=GSK_988, source="policy", evidence="inferred",
    files={"O0001.CNC": "O0001\nN10 M98 P[AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA]\nN20 M30\n", "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA.CNC": "N30 M99\n"},
    main="O0001", runs="", alarm="illegal-program-name", at="O0001 N10",
)
case(
    "a Chinese name cannot be called on the 988",
    pins="wide_names",
    control=GSK_988, source="source 000, word P, format 2 (1)", evidence="source document",
    files={"O0001.CNC": "O0001\nN10 M98 P[\u5916\u5706]\nN20 M30\n"}, main="O0001", runs="",
    alarm="illegal-program-name", at="O0001 N10",
)
case(
    "a called program may call in MDI",
    pins="mdi_calls",
    control=[*MITSUBISHI, *FANUC, "haas-ngc"], source="IMD; general knowledge", evidence="inferred",
    program="""
        O2
        N20 M98 P3
        N30 M99
        O3
        N40 M99
    """,
    mdi="N5 M98 P2", runs="N5 N20 N40 N30",
)
case(
    "an M code may stand beside M98",
    pins="extra_m_codes",
    control=[*GSK_988, *MITSUBISHI, "haas-ngc"], source="policy; SM 3", evidence="inferred",
    program="""
        O1
        N10 M8 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "in a canned cycle M98 may share its block with words",
    pins="refuses:call-with-words-in-cycle",
    control=[MDI, *MITSUBISHI, F16, "haas-ngc"], source="general knowledge; no alarm known",
    evidence="inferred",
    program="""
        O1
        N10 G90 G81 X0 Z-5. R1. F100
        N20 X10. M98 P2
        N30 G80
        N40 M30
        O2
        N50 M99
    """,
    runs="N10 N20 N50 N30 N40",
)
case(
    "the highest program number is 99999999",
    pins="max_program_number count_and_l",
    control=[F0F, F30], source="general knowledge, 8 digits", evidence="inferred",
    program="""
        O1
        N10 M98 P99999999 L1
        N20 M30
        O99999999
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a P of more than four digits with an L is all program number",
    control=[*MITSUBISHI, F0F, F30], source="general knowledge, L with P", evidence="inferred",
    program="""
        O1
        N10 M98 P20002 L2
        N20 M30
        O20002
        N30 M99
        O2
        N40 M99
    """,
    runs="N10 N30*2 N20",
)
case(
    "a P of five digits with an L names a number that these controls do not have",
    pins="count_and_l",
    control=[F16, F0D], source="general knowledge, L with P", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 M98 P20002 L2
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="program-not-found", number={F16: "078", F0D: "PS0076"}, at="O1 N20",
)
case(
    "without 6005#0 Q of M98 starts nothing",
    control=FANUC_PS, source="general knowledge, 6005#0", evidence="inferred",
    program="""
        O1
        N10 M98 P2 Q40
        N20 M30
        O2
        N30 T1
        N40 M99
    """,
    params={"6005#0": 0}, runs="N10 N30 N40 N20",
)
case(
    "a count of 10000 is refused",
    pins="max_repeats too_many_repeats",
    control=[F16, F0D, F0F], source="ROB; general knowledge", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 M98 P2 L10000
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="repeat-count-digits", number={F16: "003", F0D: "PS0003", F0F: "PS0003"}, at="O1 N20",
)
case(
    "a count of eight digits is taken on the 30i",
    pins="max_repeats",
    control=F30, source="general knowledge, 8 digits", evidence="inferred",
    program="""
        O1
        N20 M98 P2 L99999999
        N30 M30
        O2
        N40 M99
    """,
    max_blocks=4, runs="N20 N40*3", stop="limit",
)
case(
    "a count of nine digits is refused on the 30i",
    pins="too_many_repeats",
    control=F30, source="general knowledge, 8 digits", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 M98 P2 L100000000
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="repeat-count-digits", number="PS0003", at="O1 N20",
)

# Calls and returns: HNC and GSK 928

case(
    "an M code may stand beside M98 on the HNC",
    pins="extra_m_codes",
    control=HNC, source="policy", evidence="inferred",
    program="""
        %1
        N10 M8 M98 P2
        N20 M30
        %2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "an M code may stand beside M98 on the GSK 928",
    pins="extra_m_codes",
    control=TE, source="policy", evidence="inferred",
    program="""
        %1
        N10 M8 M98 P30
        N20 M30
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "H starts nothing on the HNC: the call begins at the head",
    pins="start_word",
    control=HNC, source="general knowledge of the Century Star manuals", evidence="inferred",
    program="""
        %1
        N10 M98 P2 H20
        N50 M30
        %2
        N15 T1
        N20 M99
    """,
    runs="N10 N15 N20 N50",
)
case(
    "a subprogram may call its caller on the HNC",
    pins="caller_call conditions:bare",
    control=HNC, source="general knowledge of the Century Star manuals", evidence="inferred",
    program="""
        %1
        N10 #50=#50+1
        N20 IF #50 EQ 1
        N30 M98 P2
        N40 ENDIF
        N50 IF #51 EQ 1
        N60 #51=0
        N70 M99
        N75 ENDIF
        N80 M30
        %2
        N90 #51=1
        N95 M98 P1
        N99 M99
    """,
    variables={50: 0, 51: 0}, vars={50: 2, 51: 0},
)
case(
    "a count of 10000 is refused on the HNC",
    pins="max_repeats too_many_repeats",
    control=HNC, source="general knowledge of the Century Star manuals", evidence="inferred",
    program="""
        %1
        N10 M8
        N20 M98 P2 L10000
        N30 M30
        %2
        N40 M99
    """,
    runs="N10", alarm="repeat-count-digits", at="%1 N20",
)
case(
    "a count of 9999 is taken on the HNC",
    control=HNC, source="general knowledge of the Century Star manuals", evidence="inferred",
    program="""
        %1
        N20 M98 P2 L9999
        N30 M30
        %2
        N40 M99
    """,
    max_blocks=3, runs="N20 N40*2", stop="limit",
)
case(
    "a count of 10000 is refused on the GSK 928",
    pins="max_repeats too_many_repeats",
    control=TE, source="general knowledge", evidence="inferred",
    program="""
        %1
        N10 M8
        N20 M98 P40 L10000
        N30 M30
        N40 M99
    """,
    runs="N10", alarm="repeat-count-digits", at="%1 N20",
)
case(
    "a count of 9999 is taken on the GSK 928",
    control=TE, source="general knowledge", evidence="inferred",
    program="""
        %1
        N20 M98 P40 L9999
        N30 M30
        N40 M99
    """,
    max_blocks=3, runs="N20 N40*2", stop="limit",
)
case(
    "L0 calls once on the HNC",
    pins="zero_repeats",
    control=HNC, source="policy", evidence="inferred",
    program="""
        %1
        N20 M98 P2 L0
        N30 M30
        %2
        N40 M99
    """,
    runs="N20 N40 N30",
)
case(
    "L0 calls once on the GSK 928",
    pins="zero_repeats",
    control=TE, source="policy", evidence="inferred",
    program="""
        %1
        N20 M98 P40 L0
        N30 M30
        N40 M99
    """,
    runs="N20 N40 N30",
)
case(
    "M198 is a code for the machine on the HNC and the GSK 928",
    pins="roles:M198=external-call",
    control=[HNC, TE], source="general knowledge", evidence="inferred",
    program="""
        %1
        N10 M198 P2
        N20 M30
    """,
    external={"O2.NC": "N30 M99\n"}, runs="N10 N20", m=[198],
)
case(
    ",D names no device on the HNC and the GSK 928",
    pins="device_word",
    control=[HNC, TE], source="general knowledge", evidence="inferred",
    program="""
        %1
        N10 M8
        N20 M98 P40 ,D1
        N30 M30
        N40 M99
    """,
    runs="N10", alarm="address-not-usable", at="%1 N20", word=",D1",
)
case(
    "M97 is no jump but a code for the machine on the HNC",
    pins="roles:M97=jump",
    control=HNC, source="general knowledge of the Century Star manuals", evidence="inferred",
    program="""
        %1
        N10 M97 P30
        N20 T1
        N30 M30
    """,
    runs="N10 N20 N30", m=[97], t=[1],
)
case(
    "M99 L0 is M99 on the HNC",
    pins="return_with_l",
    control=HNC, source="policy", evidence="inferred",
    program="""
        %1
        N10 M98 P2 L3
        N30 M30
        %2
        N40 M99 L0
    """,
    runs="N10 N40*3 N30",
)
case(
    "M99 L0 is M99 on the GSK 928",
    pins="return_with_l",
    control=TE, source="policy", evidence="inferred",
    program="""
        %1
        N10 M98 P40 L3
        N30 M30
        N40 M99 L0
    """,
    runs="N10 N40*3 N30",
)
case(
    "a P in M98 is rounded on the HNC",
    pins="call_values",
    control=HNC, source="general knowledge of the Century Star manuals", evidence="inferred",
    program="""
        %1
        N10 #50=2.6
        N15 M98 P[#50]
        N20 M30
        %2
        N30 M99
        %3
        N40 M99
    """,
    runs="N10 N15 N40 N20",
)

# Other rules of reading and calls

case(
    "a run may start at an N that stands after other words",
    pins="late_sequence_numbers",
    control=[HNC, TE], source="policy", evidence="inferred",
    program="""
        O1
        N10 M8
        M9 N20
        N30 M30
    """,
    start=20, runs="N20 N30", m=[9],
)
case(
    "digits finer than the least increment are kept",
    pins="cuts_fine_digits",
    control=[*GSK_988, TDI, TE], source="policy", evidence="inferred",
    program="""
        O1
        N10 G0 U1.0009
        N20 U1.0009
        N30 U1.0009
        N40 U1.0009
        N50 M30
    """,
    moves_x=[1.0009, 2.0018, 3.0027, 4.0036],
)
case(
    "digits finer than the least increment are kept on a mill",
    pins="cuts_fine_digits",
    control=[MDI, HNC, "haas-ngc"], source="policy", evidence="inferred",
    program="""
        O1
        N10 G91 G0 X1.0009
        N20 X1.0009
        N30 X1.0009
        N40 X1.0009
        N50 M30
    """,
    moves_x=[1.0009, 2.0018, 3.0027, 4.0036],
)
case(
    "a program of the GSK 928 without its end alarms",
    pins="missing_end",
    control=TE, source="policy", evidence="inferred",
    program="""
        N10 M8
        N20 M9
    """,
    runs="N10 N20", alarm="end-of-record",
)
case(
    "a semicolon ends a block on the GSK 928",
    pins="semicolon",
    control=TE, source="policy", evidence="inferred",
    program="""
        N10 M8;N20 M9
        N30 M30
    """,
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "P of M98 has no eleven digits on the 980",
    pins="max_program_digits",
    control=GSK_980, source="general knowledge, count and number", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 M98 P12345678901
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="too-many-digits", number="0003", at="O1 N20",
)
case(
    "P of M98 has eight digits on the HNC",
    pins="max_program_digits",
    control=HNC, source="general knowledge", evidence="inferred",
    program="""
        %1
        N10 M8
        N30 M98 P123456789
        N40 M30
    """,
    runs="N10", alarm="too-many-digits",
)
case(
    "a sequence number of nine digits is refused on the HNC",
    pins="max_sequence_number",
    control=HNC, source="general knowledge", evidence="inferred",
    program="""
        %1
        N99999999 M8
        N100000000 M9
        N30 M30
    """,
    runs="N99999999", alarm="illegal-sequence-number",
)
case(
    "M98 has no start word on the GSK 928: Q is left alone",
    control=TE, source="source 001, M98 P L", evidence="inferred",
    program="""
        N10 M98 P40 Q50
        N20 M30
        N40 M8
        N50 M99
    """,
    runs="N10 N40 N50 N20", m=[8],
)
case(
    "there are no calls in MDI on the GSK 928",
    pins="mdi_calls",
    control=TE, source="policy", evidence="inferred",
    program="""
        N40 M8
        N50 M99
    """,
    mdi="N10 M98 P40", runs="", alarm="call-in-mdi",
)
case(
    "M99 takes no P on the GSK 928",
    pins="return_with_p",
    control=TE, source="source 001, M99", evidence="inferred",
    program="""
        N10 M98 P40
        N20 M30
        N40 M99 P20
    """,
    runs="N10", alarm="illegal-word-with-return",
)
case(
    "M1 without its switch starts nothing over on the HNC",
    pins="roles:M01=start-over",
    control=HNC, source="general knowledge", evidence="inferred",
    program="""
        %1
        N10 M1
        N20 M30
    """,
    runs="N10 N20",
)
case(
    "G28 may share a block with M99 on the HNC",
    pins="codes_not_with_return",
    control=HNC, source="policy", evidence="inferred",
    program="""
        %1
        N10 M98 P2
        N20 M30
        %2
        N30 G28 Z0 M99
    """,
    runs="N10 N30 N20",
)
case(
    "G54 may share a block with M98 on the HNC",
    pins="codes_not_with_call",
    control=HNC, source="policy", evidence="inferred",
    program="""
        %1
        N10 G54 M98 P2
        N20 M30
        %2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "G54 may not share a block with M98 on the 980TDi",
    pins="codes_not_with_call",
    control=TDI, source="MDib 0051; of the 980MDi", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 G54 M98 P2
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="illegal-word-with-call", number="0051", at="O1 N20",
)
case(
    "M30 may not share a block with G65 on the 980TDi",
    pins="m_codes_not_with_macro_call",
    control=TDI, source="MDib 0116; of the 980MDi", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 G65 P2 M30
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="m-code-with-macro-call", number="0116", at="O1 N20",
)
case(
    "in a drilling cycle of a lathe M98 may share its block with words",
    pins="refuses:call-with-words-in-cycle",
    control=[*GSK_988, TDI], source="policy", evidence="inferred",
    program="""
        O1
        N10 G98 G83 Z-5. F100.
        N20 Z-6. M98 P2
        N30 M30
        O2
        N40 M99
    """,
    runs="N10 N20 N40 N30",
)
case(
    "in a canned cycle M98 may share its block with words on the HNC",
    pins="refuses:call-with-words-in-cycle",
    control=HNC, source="policy", evidence="inferred",
    program="""
        %1
        N10 G81 X1. Z-5. R1. F100
        N20 X5. M98 P2
        N30 M30
        %2
        N40 M99
    """,
    runs="N10 N20 N40 N30",
)
case(
    "M97 takes the first block of its number from the head",
    pins="roles:M97=jump",
    control=TE, source="policy", evidence="inferred",
    program="""
        N20 M8
        N10 M97 P20
        N20 M9
        N30 M30
    """,
    max_blocks=4, runs="N20 N10 N20 N10", stop="limit",
)
case(
    "a vacant value written to a system variable counts as 0",
    pins="refuses:illegal-variable-value",
    control=[*GSK_988, *MITSUBISHI, *FANUC, "haas-ngc"], source="general knowledge", evidence="inferred",
    program="""
        O1
        N10 #5221=5
        N20 #5221=#0
        N30 #100=#5221
        N40 M30
    """,
    runs="N10 N20 N30 N40", vars={100: 0},
)
case(
    "a vacant value cannot be written to a system variable of the 980",
    pins="refuses:illegal-variable-value",
    control=GSK_980, source="MDia 121", evidence="secondary",
    program="""
        O1
        N10 #1100=1
        N20 #1100=#0
        N30 M30
    """,
    runs="N10", alarm="illegal-variable-value", number="0121", at="O1 N20",
)
case(
    "a name beyond ASCII cannot be called",
    pins="program_heads:name wide_names",
    control=[M700, M800, F0F, F30], source="general knowledge, letters of names",
    evidence="inferred",
    program="""
        O1
        N10 M8
        N20 M98 <\u5916\u5706>
        N30 M30
    """,
    runs="N10", alarm="illegal-program-name",
    number={M700: "P232", M800: "P232", F0F: "PS0311", F30: "PS0311"}, at="O1 N20",
)
case(
    "a name in angle brackets is no block of the HNC and the GSK 928",
    pins="program_heads:name bracket_names",
    control=[HNC, TE], source="general knowledge", evidence="inferred",
    program="""
        %1
        N10 M8
        <PART>
        N30 M30
    """,
    runs="N10", alarm="illegal-character",
)
case(
    "the head names a program of the GSK 928, whatever its file is called",
    pins="program_heads:file",
    control=TE, source="policy", evidence="inferred",
    files={"PART.CNC": "%1\nN10 M30\n"}, main="%1", runs="N10",
)
case(
    "a code inside a program that an M code called may call again on the 988",
    pins="code_cascade",
    control=GSK_988, source="policy", evidence="inferred", params={"6008#6": 1, "6080": 50, "6081": 51},
    program="""
        O1
        N10 M50
        N20 M30
        O9020
        N30 M51
        N40 M99
        O9021
        N50 M99
    """,
    runs="N10 N30 N50 N40 N20",
)
case(
    "fifteen calls of both kinds may be open",
    pins="max_total_nesting",
    control=FANUC_PS, source="general knowledge, 10 subprograms and 5 macros", evidence="inferred",
    program="O1\nN10 M98 P2\nN20 M30\n"
    + "".join(f"O{i}\nM98 P{i + 1}\nM99\n" for i in range(2, 11))
    + "".join(f"O{i}\nG65 P{i + 1}\nM99\n" for i in range(11, 16))
    + "O16\nN30 M99\n",
    runs="N10 N30 N20",
)
