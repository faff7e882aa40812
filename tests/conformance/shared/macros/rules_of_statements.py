"""Macro statements: what a control has and does not have, rule by rule."""

from conformance import case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI = GSK_980 = ["gsk-980tdi", "gsk-980mdi"]
GSK = GSK_988 + GSK_980
MELDAS, M700, M800 = MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, F0D, F0F, F30 = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
FANUC_PS = FANUC[1:]

case(
    "THEN without a statement is refused",
    control=[*GSK, MELDAS, M700, *FANUC], source="general knowledge, IF blocks; ALM PS1137",
    evidence="inferred",
    program="""
        O1
        N10 T1
        N20 IF[1 EQ 1]THEN
        N30 M30
    """,
    runs="N10", alarm="if-format",
    number={**dict.fromkeys(GSK_988, "201"), **dict.fromkeys(GSK_980, "0101"), **dict.fromkeys([MELDAS, M700], "P290"), F16: "114", **dict.fromkeys(FANUC_PS, "PS1137")},
    at="O1 N20",
)
case(
    "GOTO takes the next block of that number",
    pins="jump_search",
    control=[*GSK, *MITSUBISHI, *FANUC, "haas-ngc"], source="general knowledge, search order",
    evidence="inferred",
    program="""
        O1
        N20 T1
        N10 IF[#100 EQ 1]GOTO 40
        N15 #100=1
        N18 GOTO 20
        N20 T2
        N40 M30
    """,
    runs="N20 N10 N15 N18 N20 N40", t=[1, 2],
)
case(
    "three open loops do not count in a called program",
    pins="loops_count_across_calls",
    control=[*GSK, *FANUC], source="general knowledge, loops belong to their program",
    evidence="inferred",
    program="""
        O1
        N10 DO1
        N20 DO2
        N30 DO3
        N40 M98 P2
        N50 GOTO 90
        END3
        END2
        END1
        N90 M30
        O2
        N60 DO1
        N70 GOTO 80
        END1
        N80 M99
    """,
    runs="N10 N20 N30 N40 N60 N70 N80 N50 N90",
)
case(
    "twelve digits are read in a statement",
    pins="max_constant_digits",
    control=[*GSK, *MITSUBISHI, *FANUC_PS, "haas-ngc"], source="policy", evidence="inferred",
    program="""
        O1
        N10 #100=123456789012
        N20 M30
    """,
    runs="N10 N20", vars={100: 123456789012},
)
case(
    "thirteen digits are too many in a statement",
    control=[*GSK, *MITSUBISHI, *FANUC_PS], source="policy", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 #100=1234567890123
        N30 M30
    """,
    runs="N10", alarm="too-many-digits",
    number={name: "0003" if "980" in name else "003" for name in GSK}
    | dict.fromkeys(MITSUBISHI, "P35") | dict.fromkeys(FANUC_PS, "PS0003"),
    at="O1 N20",
)
case(
    "ATAN counts a full turn",
    pins="atan_range",
    control=[*GSK, *MITSUBISHI, *FANUC, "haas-ngc"], source="TApar 6004#0; TDi29; ALI; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 #100=ATAN[0-1]/[0-1]
        N20 M30
    """,
    runs="N10 N20", vars={100: 225},
)
case(
    "ASIN of a negative value lies after 180",
    pins="asin_range",
    control=[*GSK_988, MDI, *FANUC, "haas-ngc"], source="TApar 6004#0; ALI; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 #100=ASIN[0-1]
        N20 M30
    """,
    runs="N10 N20", vars={100: 270},
)
case(
    "ASIN of a negative value is negative",
    pins="asin_range",
    control=[TDI, *MITSUBISHI], source="TDi29; general knowledge", evidence="inferred",
    program="""
        O1
        N10 #100=ASIN[0-1]
        N20 M30
    """,
    runs="N10 N20", vars={100: -90},
)
case(
    "two conditions cannot be joined",
    pins="conditions:joined",
    control=[*GSK, *FANUC], source="policy; general knowledge 6006#0", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 IF[[1 EQ 1]AND[2 EQ 2]]GOTO 40
        N30 T2
        N40 M30
    """,
    runs="N10", alarm="if-format",
    number={**dict.fromkeys(GSK_988, "201"), **dict.fromkeys(GSK_980, "0101"), F16: "114", **dict.fromkeys(FANUC_PS, "PS1137")},
    at="O1 N20",
)
case(
    "two conditions can be joined",
    pins="conditions:joined",
    control=MITSUBISHI, source="general knowledge, AND in conditions", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 IF[[1 EQ 1]AND[2 EQ 2]]GOTO 40
        N30 T2
        N40 M30
    """,
    runs="N10 N20 N40",
)
case(
    "== is no operator",
    pins="conditions:symbols",
    control=[*GSK_988, *MITSUBISHI, *FANUC, "haas-ngc"], source="general knowledge, condition operators",
    evidence="inferred",
    program="""
        O1
        N10 T1
        N20 IF[1 == 1]GOTO 40
        N30 T2
        N40 M30
    """,
    runs="N10", alarm="if-format",
    number={**dict.fromkeys(GSK_988, "201"), **dict.fromkeys(MITSUBISHI, "P290"), F16: "114", **dict.fromkeys(FANUC_PS, "PS1137"), "haas-ngc": "516"},
    at="O1 N20",
)
case(
    "== stands for EQ on the 980",
    pins="conditions:symbols",
    control=GSK_980, source="TDi29", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 IF[1 == 1]GOTO 40
        N30 T2
        N40 M30
    """,
    runs="N10 N20 N40",
)
case(
    "a condition stands in brackets",
    pins="conditions:bare",
    control=[*GSK, *MITSUBISHI, *FANUC, "haas-ngc"], source="TA27; X-GO; MZ 864", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 IF 1 EQ 1 GOTO 40
        N30 T2
        N40 M30
    """,
    runs="N10", alarm="if-format",
    number={**dict.fromkeys(GSK_988, "201"), **dict.fromkeys(GSK_980, "0101"), **dict.fromkeys(MITSUBISHI, "P290"), F16: "114", **dict.fromkeys(FANUC_PS, "PS1137"), "haas-ngc": "516"},
    at="O1 N20",
)
case(
    "two letters are no function",
    pins="short_functions",
    control=[*GSK, *MITSUBISHI, "haas-ngc"], source="general knowledge, function names", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 #100=RO[1.7]
        N30 M30
    """,
    runs="N10", alarm="expression-format",
    number={**dict.fromkeys(GSK_988, "202"), **dict.fromkeys(GSK_980, "0101"), **dict.fromkeys(MITSUBISHI, "P282"), "haas-ngc": None},
    at="O1 N20",
)
case(
    "RND[1.7] is a function",
    control=MITSUBISHI, source="general knowledge, functions", evidence="inferred",
    program="""
        O1
        N10 #100=RND[1.7]
        N20 M30
    """,
    runs="N10 N20", vars={100: 2},
)
case(
    "RND[1.7] is no function",
    control=[*GSK, *FANUC], source="general knowledge, functions", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 #100=RND[1.7]
        N30 M30
    """,
    runs="N10", alarm="expression-format",
    number={**dict.fromkeys(GSK_988, "202"), **dict.fromkeys(GSK_980, "0101"), F16: "125", **dict.fromkeys(FANUC_PS, "PS1125")},
    at="O1 N20",
)
case(
    "POW[2,3] is a function",
    control=[F0F, F30], source="general knowledge, functions", evidence="inferred",
    program="""
        O1
        N10 #100=POW[2,3]
        N20 M30
    """,
    runs="N10 N20", vars={100: 8},
)
case(
    "POW[2,3] is no function",
    control=[*GSK, *MITSUBISHI, F16], source="general knowledge, functions", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 #100=POW[2,3]
        N30 M30
    """,
    runs="N10", alarm="expression-format",
    number={**dict.fromkeys(GSK_988, "202"), **dict.fromkeys(GSK_980, "0101"), **dict.fromkeys(MITSUBISHI, "P282"), F16: "125"},
    at="O1 N20",
)
case(
    "SIGN[5] is no function",
    control=[*GSK, *MITSUBISHI, *FANUC], source="general knowledge, functions",
    evidence="inferred",
    program="""
        O1
        N10 T1
        N20 #100=SIGN[5]
        N30 M30
    """,
    runs="N10", alarm="expression-format",
    number={**dict.fromkeys(GSK_988, "202"), **dict.fromkeys(GSK_980, "0101"), **dict.fromkeys(MITSUBISHI, "P282"), F16: "125", **dict.fromkeys(FANUC_PS, "PS1125")},
    at="O1 N20",
)
case(
    "RAND[5] is no function",
    control=[*GSK_988, *MITSUBISHI, *FANUC], source="general knowledge, functions",
    evidence="inferred",
    program="""
        O1
        N10 T1
        N20 #100=RAND[5]
        N30 M30
    """,
    runs="N10", alarm="expression-format",
    number={**dict.fromkeys(GSK_988, "202"), **dict.fromkeys(MITSUBISHI, "P282"), F16: "125", **dict.fromkeys(FANUC_PS, "PS1125")},
    at="O1 N20",
)
case(
    "MOD is no operator",
    pins="functions",
    control=[*GSK, F16], source="general knowledge, MOD", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 #100=7 MOD 4
        N30 M30
    """,
    runs="N10", alarm="nc-and-macro-in-block",
    number={**dict.fromkeys(GSK_988, "212"), **dict.fromkeys(GSK_980, "0114"), F16: "127"},
    at="O1 N20",
)
case(
    "MOD is the rest of a division",
    pins="functions",
    control=[*MITSUBISHI, *FANUC_PS, "haas-ngc"], source="general knowledge, MOD", evidence="inferred",
    program="""
        O1
        N10 #100=7 MOD 4
        N30 M30
    """,
    runs="N10 N30", vars={100: 3},
)
case(
    "a word with a vacant variable is left out",
    pins="vacant_address",
    control=[*GSK_988, *MITSUBISHI, *FANUC, "haas-ngc"], source="XIA, JIX; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 T#1
        N20 M30
    """,
    runs="N10 N20", t=[],
)
case(
    "a word with a vacant variable is 0",
    pins="vacant_address",
    control=GSK_980, source="TDi28", evidence="inferred",
    program="""
        O1
        N10 T#1
        N20 M30
    """,
    runs="N10 N20", t=[0],
)
case(
    "a vacant variable does not equal 0",
    pins="vacant_comparison",
    control=[*GSK_988, *MITSUBISHI, *FANUC, "haas-ngc"], source="M7V; general knowledge", evidence="inferred",
    program="""
        O1
        N10 IF[#1 EQ 0]GOTO 30
        N20 T1
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "a vacant variable equals 0 on the 980",
    pins="vacant_comparison",
    control=GSK_980, source="TDi28", evidence="inferred",
    program="""
        O1
        N10 IF[#1 EQ 0]GOTO 30
        N20 T1
        N30 M30
    """,
    runs="N10 N30",
)
case(
    "#9100 is no variable",
    pins="variable_forms:9nnn",
    control=[*GSK_988, *MITSUBISHI, *FANUC], source="general knowledge, variables",
    evidence="inferred",
    program="""
        O1
        N10 T1
        N20 #101=#9100
        N30 M30
    """,
    variables={100: 102}, runs="N10", alarm="illegal-variable",
    number={**dict.fromkeys(GSK_988, "203"), **dict.fromkeys(MITSUBISHI, "P241"), F16: "115", **dict.fromkeys(FANUC_PS, "PS0115")},
    at="O1 N20",
)
case(
    "#9100 reads the variable that #100 names",
    pins="variable_forms:9nnn",
    control=GSK_980, source="TDi28", evidence="inferred",
    program="""
        O1
        N10 #101=#9100
        N30 M30
    """,
    variables={100: 102, 102: 5}, runs="N10 N30", vars={101: 5},
)
case(
    "SETVN does not exist",
    pins="variable_forms:names",
    control=[*GSK, F16, "haas-ngc"], source="general knowledge, no variable names", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 SETVN 510[NAME]
        N30 M30
    """,
    runs="N10", alarm="statement-not-available",
    number={**dict.fromkeys(GSK_988, "201"), **dict.fromkeys(GSK_980, "0101"), F16: "004", "haas-ngc": None},
    at="O1 N20",
)
case(
    "five brackets inside each other are read",
    pins="max_brackets",
    control=[*GSK, *MITSUBISHI, *FANUC, "haas-ngc"], source="Talm 205; MDia 104; MZ 858; X-NUL",
    evidence="inferred",
    program="""
        O1
        N10 #100=[[[[[1]]]]]
        N20 M30
    """,
    runs="N10 N20", vars={100: 1},
)
case(
    "six brackets inside each other are too many",
    control=[*GSK, *MITSUBISHI, *FANUC], source="Talm 205; MDia 104; MZ 858; X-NUL",
    evidence="inferred",
    program="""
        O1
        N10 T1
        N20 #100=[[[[[[1]]]]]]
        N30 M30
    """,
    runs="N10", alarm="brackets-too-deep",
    number={**dict.fromkeys(GSK_988, "205"), **dict.fromkeys(GSK_980, "0104"), **dict.fromkeys(MITSUBISHI, "P280"), F16: "118", **dict.fromkeys(FANUC_PS, "PS0118")},
    at="O1 N20",
)
case(
    "AND takes a negative value",
    pins="refuses:logic-of-negative",
    control=["gsk-980tdi", *MITSUBISHI, *FANUC, "haas-ngc"], source="policy; ALI", evidence="inferred",
    program="""
        O1
        N10 #100=[0-1]AND 3
        N20 M30
    """,
    runs="N10 N20", vars={100: 3},
)
case(
    "OR binds like plus",
    pins="logic_order",
    control=[*GSK, *FANUC, "haas-ngc"], source="general knowledge, priorities", evidence="inferred",
    program="""
        O1
        N10 IF[0 EQ 1 OR 1]GOTO 30
        N20 T1
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "OR binds weaker than a comparison",
    pins="logic_order",
    control=MITSUBISHI, source="general knowledge, priorities", evidence="inferred",
    program="""
        O1
        N10 IF[2 EQ 2 OR 1 EQ 2]GOTO 30
        N20 T1
        N30 M30
    """,
    runs="N10 N30",
)
case(
    "DO4 is no loop",
    control=[*GSK, *FANUC], source="Talm 211; MDia 102; ALM PS0126", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 DO4
        N25 GOTO 30
        END4
        N30 M30
    """,
    runs="N10", alarm="illegal-loop-number",
    number={**dict.fromkeys(GSK_988, "211"), **dict.fromkeys(GSK_980, "0102"), F16: "126", **dict.fromkeys(FANUC_PS, "PS0126")},
    at="O1 N20",
)
case(
    "DO3 is a loop",
    control=[*GSK, *FANUC], source="Talm 211; MDia 102; ALM PS0126", evidence="inferred",
    program="""
        O1
        N20 DO3
        N25 GOTO 30
        END3
        N30 M30
    """,
    runs="N20 N25 N30",
)
case(
    "DO127 is a loop and DO128 is none",
    control=MITSUBISHI, source="general knowledge, m = 1 to 127", evidence="inferred",
    program="""
        O1
        N10 DO127
        N20 GOTO 30
        END127
        N30 DO128
        N40 M30
        END128
    """,
    runs="N10 N20", alarm="illegal-loop-number", number="P291", at="O1 N30",
)
case(
    "GOTO takes five digits and not six",
    pins="max_jump_number",
    control=[*GSK, *MITSUBISHI, F16, F0D], source="Talm 213; MDia 112; X-GO; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 GOTO 99999
        N99999 GOTO 100000
        N30 M30
    """,
    runs="N10", alarm="illegal-jump-number",
    number={**dict.fromkeys(GSK_988, "213"), **dict.fromkeys(GSK_980, "0112"), **dict.fromkeys(MITSUBISHI, "P231"), F16: "128", F0D: "PS1128"},
    at="O1 N99999",
)
case(
    "GOTO may stand in MDI",
    pins="refuses:jump-in-mdi",
    control=MITSUBISHI, source="MZ 869: tape only; general knowledge", evidence="inferred",
    program="""
        O2
        N20 M99
    """,
    mdi="N5 GOTO 8\nN7 T1\nN8 T2", runs="N5 N8", t=[2],
)
case(
    "GOTO may not stand in MDI",
    pins="refuses:jump-in-mdi",
    control=[*GSK, *FANUC, "haas-ngc"], source="Talm 208; ALM PS0123; policy", evidence="inferred",
    program="""
        O2
        N20 M99
    """,
    mdi="N5 T1\nN6 GOTO 8\nN7 T1\nN8 T2", runs="N5", alarm="jump-in-mdi",
    number={**dict.fromkeys(GSK_988, "208"), **dict.fromkeys(GSK_980, None), F16: "123", **dict.fromkeys(FANUC_PS, "PS0123"), "haas-ngc": None},
    t=[1],
)
case(
    "a program may raise alarm 200 and not 201",
    pins="user_alarm_last",
    control=[*GSK_988, *FANUC], source="general knowledge, #3000", evidence="inferred",
    program="""
        O1
        N10 IF[#100 EQ 1]GOTO 30
        N20 #3000=201
        N30 M30
    """,
    runs="N10", alarm="illegal-user-alarm", at="O1 N20",
)
case(
    "a program may raise alarm 200",
    pins="user_alarm_offset user_alarm_numbers",
    control=[*GSK_988, *FANUC], source="general knowledge, #3000", evidence="inferred",
    program="""
        O1
        N20 #3000=200
        N30 M30
    """,
    runs="N20", alarm="user-alarm",
    number={**dict.fromkeys([*GSK_988, F16], "3200"), **dict.fromkeys(FANUC_PS, "MC3200")},
    at="O1 N20",
)
case(
    "a program may raise alarm 99 on the 980",
    pins="user_alarm_offset user_alarm_last user_alarm_numbers",
    control=GSK_980, source="TDi28, #3000", evidence="inferred",
    program="""
        O1
        N20 #3000=99
        N30 M30
    """,
    runs="N20", alarm="user-alarm", number="5999", at="O1 N20",
)
case(
    "a program may raise alarm 9999 on a Mitsubishi",
    pins="user_alarm_last",
    control=MITSUBISHI, source="general knowledge, #3000", evidence="inferred",
    program="""
        O1
        N20 #3000=9999
        N30 M30
    """,
    runs="N20", alarm="user-alarm", number="P277", at="O1 N20",
)
case(
    "a program may not raise alarm 10000 on a Mitsubishi",
    control=MITSUBISHI, source="general knowledge, #3000", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 #3000=10000
        N30 M30
    """,
    runs="N10", alarm="illegal-user-alarm", at="O1 N20",
)
case(
    "GOTO takes eight digits",
    pins="max_jump_number",
    control=[F0F, F30], source="ALM PS1128", evidence="secondary",
    program="""
        O1
        N10 GOTO 99999999
        N20 T1
        N99999999 M30
    """,
    runs="N10 N99999999",
)
case(
    "GOTO takes no nine digits",
    control=[F0F, F30], source="ALM PS1128", evidence="secondary",
    program="""
        O1
        N10 T1
        N20 GOTO 100000000
        N30 M30
    """,
    runs="N10", alarm="illegal-jump-number", number="PS1128", at="O1 N20",
)
case(
    "two letters of a function suffice",
    pins="short_functions",
    control=FANUC, source="K-H, two letters", evidence="inferred",
    program="""
        O1
        N10 #100=RO[1.7]
        N30 M30
    """,
    runs="N10 N30", vars={100: 2},
)
case(
    "SETVN gives names",
    pins="variable_forms:names",
    control=FANUC_PS, source="ALM PS1139; K-M syntax", evidence="inferred",
    program="""
        O1
        N10 SETVN 510[TOOLNO]
        N20 [#TOOLNO]=5
        N30 M30
    """,
    runs="N10 N20 N30", vars={510: 5},
)
case(
    "RAND and SRAND are functions of the 980",
    control=GSK_980, source="TDi29", evidence="inferred",
    program="""
        O1
        N10 #100=RAND[5]
        N20 #101=SRAND[1,5]
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "PRM is no function",
    control=[*GSK, *MITSUBISHI, F16, F0D], source="general knowledge, functions",
    evidence="inferred",
    program="""
        O1
        N10 T1
        N20 #100=PRM[1]
        N30 M30
    """,
    runs="N10", alarm="expression-format",
    number={**dict.fromkeys(GSK_988, "202"), **dict.fromkeys(GSK_980, "0101"), **dict.fromkeys(MITSUBISHI, "P282"), F16: "125", F0D: "PS1125"},
    at="O1 N20",
)
case(
    "POW[2,3] is a function of the 0i-D",
    control=F0D, source="general knowledge, functions", evidence="inferred",
    program="""
        O1
        N10 #100=POW[2,3]
        N30 M30
    """,
    runs="N10 N30", vars={100: 8},
)
