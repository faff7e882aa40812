"""What a control has and what it has not: rules that no other topic pins down, one row for each."""

from conformance import case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI = GSK_980 = ["gsk-980tdi", "gsk-980mdi"]
GSK = GSK_988 + GSK_980
MELDAS, M700, M800 = MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
F16, F0D, F0F, F30 = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
FANUC_PS = FANUC[1:]
HNC, TE = "hnc-21m", "gsk-928te"

# Reading

case(
    "a name in angle brackets heads no program",
    pins="named_programs max_block_length bracket_names",
    control=[MDI, MELDAS, F16, F0D, "haas-ngc"], source="general knowledge, program names",
    evidence="inferred",
    program="""
        O1
        N10 M8
        <PART>
        N30 M30
    """,
    runs="N10", alarm="illegal-character",
    number={MDI: None, MELDAS: "P32", F16: "009", F0D: "PS0009", "haas-ngc": None}, at="O1",
)
case(
    "the highest program number is 9999",
    pins="max_program_number",
    control=[T, *GSK_980, F16, F0D], source="general knowledge, four digits", evidence="inferred",
    program="""
        O1
        N10 M98 P9999
        N20 M30
        O9999
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a sequence number has five digits and not six",
    pins="max_sequence_number max_block_length m_codes_per_block",
    control=[*GSK, *MITSUBISHI, F16, F0D],
    source="PB155; Talm 003; MDia 006; SK P35; general knowledge", evidence="inferred",
    program="""
        O1
        N99999 M8
        N100000 M9
        N30 M30
    """,
    runs="N99999", alarm="illegal-sequence-number",
    number={**dict.fromkeys(GSK_988, "003"), **dict.fromkeys(GSK_980, "0006"), **dict.fromkeys(MITSUBISHI, "P35"), F16: None, F0D: "PS1014"},
    m=[8],
)
case(
    "N0 names a block as any number does",
    pins="max_block_length",
    control=[*GSK_988, *FANUC], source="policy", evidence="inferred",
    program="""
        O1
        N10 GOTO 30
        N0 M8
        N30 M30
    """,
    runs="N10 N30",
)
case(
    "N0 is read and its block runs",
    pins="zero_numbers m_codes_per_block",
    control=[*GSK_988, *FANUC, "haas-ngc"], source="policy", evidence="inferred",
    program="""
        O1
        N0 M8
        N30 M30
    """,
    runs="N0 N30", m=[8],
)
case(
    "an N behind other words is read",
    pins="sequence_number_first late_sequence_numbers",
    control=[T, *FANUC, "haas-ngc"], source="policy", evidence="inferred",
    program="""
        O1
        N10 M8
        M9 N20
        N30 M30
    """,
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "GOTO finds no N that stands behind other words",
    pins="late_sequence_numbers",
    control=MITSUBISHI, source="general knowledge, N at the head; MZ 843", evidence="inferred",
    program="""
        O1
        N10 T1
        N12 GOTO 20
        N15 M8
        M9 N20
        N30 M30
    """,
    runs="N10", alarm="jump-target-not-found", number="P231", at="O1 N12",
)
case(
    "a spindle speed of 8 digits is read",
    pins="max_digits",
    control=[*GSK_988, F16, F0D], source="general knowledge, 8 digits", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 S12345678
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "a spindle speed of 9 digits is refused",
    control=[*GSK_988, F16, F0D], source="general knowledge, 8 digits", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 S123456789
        N30 M30
    """,
    runs="N10", alarm="too-many-digits",
    number={**dict.fromkeys([*GSK_988, F16], "003"), F0D: "PS0003"}, at="O1 N20",
)
case(
    "a spindle speed of 9 digits is read",
    pins="max_digits",
    control=[F0F, F30], source="general knowledge, 9 digits", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 S123456789
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "a spindle speed of 10 digits is refused",
    control=[F0F, F30], source="general knowledge, 9 digits", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 S1234567890
        N30 M30
    """,
    runs="N10", alarm="too-many-digits", number="PS0003", at="O1 N20",
)
case(
    "a spindle speed of 10 digits is read",
    pins="max_digits",
    control=GSK_980, source="general knowledge, 10 digits", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 S1234567890
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "a spindle speed of 11 digits is refused",
    control=GSK_980, source="general knowledge, 10 digits", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 S12345678901
        N30 M30
    """,
    runs="N10", alarm="too-many-digits", number="0003", at="O1 N20",
)
case(
    "a spindle speed of 15 digits is read",
    pins="max_digits",
    control=MITSUBISHI, source="general knowledge, 15 digits", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 S123456789012345
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "a spindle speed of 16 digits is refused",
    control=MITSUBISHI, source="general knowledge, 15 digits", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 S1234567890123456
        N30 M30
    """,
    runs="N10", alarm="too-many-digits", number="P35", at="O1 N20",
)
case(
    "a slash inside a block drops the rest of it",
    pins="block_skip",
    control=[*GSK_988, *FANUC, "haas-ngc"], source="general knowledge, block skip", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 T1 /M9
        N30 M30
    """,
    skip=(1,), runs="N10 N20 N30", m=[8], t=[1],
)
case(
    "a slash inside a block is refused",
    pins="block_skip",
    control=[*GSK_980, *MITSUBISHI], source="general knowledge, block skip at the head only",
    evidence="inferred",
    program="""
        O1
        N10 M8
        N20 T1 /M9
        N30 M30
    """,
    skip=(1,), runs="N10", alarm="illegal-character",
    number={**dict.fromkeys(GSK_980, None), **dict.fromkeys(MITSUBISHI, "P32")}, at="O1 N20",
)
case(
    "a comment that is not closed reaches to the end of its block",
    pins="open_comment",
    control=[*GSK_988, *MITSUBISHI, *FANUC, "haas-ngc"], source="policy; GED", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 T1 (OPEN M9
        N30 M30
    """,
    runs="N10 N20 N30", m=[8], t=[1],
)
case(
    "D and H take a decimal point",
    control=GSK_988, source="general knowledge, decimal points", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 D1.
        N25 H1.
        N30 M30
    """,
    runs="N10 N20 N25 N30",
)
case(
    "L takes a decimal point on the 980",
    control=GSK_980, source="general knowledge, decimal points", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 G65 P2 L1.
        N30 M30
        O2
        N40 M99
    """,
    runs="N10 N20 N40 N30",
)
case(
    "D and H take a decimal point on the 980",
    control=GSK_980, source="general knowledge, decimal points", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 D1.
        N25 H1.
        N30 M30
    """,
    runs="N10 N20 N25 N30",
)
case(
    "L takes no decimal point",
    control=[*GSK_988, *MITSUBISHI, *FANUC], source="general knowledge, decimal points",
    evidence="inferred",
    program="""
        O1
        N10 M8
        N20 G65 P2 L1.
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="illegal-decimal-point",
    number={**dict.fromkeys([*GSK_988, F16], "007"), **dict.fromkeys(MITSUBISHI, "P33"), **dict.fromkeys(FANUC_PS, "PS0007")},
    at="O1 N20",
)
case(
    "D takes no decimal point",
    control=[*MITSUBISHI, *FANUC], source="general knowledge, decimal points",
    evidence="inferred",
    program="""
        O1
        N10 M8
        N20 D1.
        N30 M30
    """,
    runs="N10", alarm="illegal-decimal-point",
    number={**dict.fromkeys(MITSUBISHI, "P33"), F16: "007", **dict.fromkeys(FANUC_PS, "PS0007")},
    at="O1 N20", word="D1.",
)
case(
    "H takes no decimal point",
    control=[*MITSUBISHI, *FANUC], source="general knowledge, decimal points",
    evidence="inferred",
    program="""
        O1
        N10 M8
        N20 H1.
        N30 M30
    """,
    runs="N10", alarm="illegal-decimal-point",
    number={**dict.fromkeys(MITSUBISHI, "P33"), F16: "007", **dict.fromkeys(FANUC_PS, "PS0007")},
    at="O1 N20", word="H1.",
)
case(
    "S takes no decimal point",
    control=[*GSK, *MITSUBISHI, *FANUC], source="general knowledge, decimal points",
    evidence="inferred",
    program="""
        O1
        N10 M8
        N20 S1.
        N30 M30
    """,
    runs="N10", alarm="illegal-decimal-point",
    number={**dict.fromkeys([*GSK_988, F16], "007"), **dict.fromkeys(GSK_980, "0012"), **dict.fromkeys(MITSUBISHI, "P33"), **dict.fromkeys(FANUC_PS, "PS0007")},
    at="O1 N20", word="S1.",
)
case(
    "P of M98 takes no decimal point",
    control=[*GSK, *MITSUBISHI, *FANUC], source="general knowledge, decimal points",
    evidence="inferred",
    program="""
        O1
        N10 M8
        N20 M98 P2.
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="illegal-decimal-point",
    number={**dict.fromkeys([*GSK_988, F16], "007"), **dict.fromkeys(GSK_980, "0012"), **dict.fromkeys(MITSUBISHI, "P33"), **dict.fromkeys(FANUC_PS, "PS0007")},
    at="O1 N20", word="P2.",
)
case(
    "D takes a minus sign",
    control=[*GSK_988, TDI], source="general knowledge, minus signs", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 D-1
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "D takes no minus sign on FANUC",
    control=FANUC, source="general knowledge, minus signs; ALM PS0006", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 D-1
        N30 M30
    """,
    runs="N10", alarm="illegal-minus-sign",
    number={F16: "006", **dict.fromkeys(FANUC_PS, "PS0006")}, at="O1 N20", word="D-1",
)
case(
    "a negative L is a count out of its range, not a wrong sign",
    control=[*GSK, *MITSUBISHI], source="TA27; MDia 092; general knowledge", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 G65 P2 L-1
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="illegal-repeat-count",
    number={**dict.fromkeys(GSK_988, "003"), **dict.fromkeys(GSK_980, "0092"), **dict.fromkeys(MITSUBISHI, "P35")},
    at="O1 N20",
)
case(
    "of two M codes the last counts",
    pins="m_codes_alarm",
    control=[*GSK_980, *FANUC], source="general knowledge, 3404#7", evidence="inferred",
    program="""
        O1
        N10 M8 M9
        N30 M30
    """,
    runs="N10 N30", m=[9], dropped=["M8"],
)
case(
    "of five M codes the last four count on a Mitsubishi",
    pins="m_codes_per_block m_codes_alarm",
    control=MITSUBISHI, source="general knowledge, M codes", evidence="inferred",
    program="""
        O1
        N10 M10 M11 M12 M13 M14
        N30 M30
    """,
    runs="N10 N30", m=[11, 12, 13, 14], dropped=["M10"],
)
case(
    "G without a number is refused",
    control=GSK, source="Talm 005; MDia 003", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 G X1
        N30 M30
    """,
    runs="N10", alarm="address-without-value",
    number={**dict.fromkeys(GSK_988, "005"), **dict.fromkeys(GSK_980, "0003")}, at="O1 N20",
)
case(
    "G without a number is G00",
    pins="bare_g",
    control=MITSUBISHI, source="general knowledge, G alone", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 G M9
        N30 M30
    """,
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "a program without its end alarms",
    pins="missing_end",
    control=GSK_980, source="MDia; policy", evidence="inferred",
    program="""
        O1
        N10 M8
        N20 M9
    """,
    runs="N10 N20", alarm="end-of-record",
)
case(
    "% with a number heads no program on the 980",
    pins="percent_programs",
    control=GSK_980, source="general knowledge, O heads a program", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        %2
        N30 M99
    """,
    runs="", alarm="program-not-found", number="0001",
)
case(
    "a block of 256 characters is read",
    pins="max_block_length",
    control=GSK, source="Talm 002; MDia 037", evidence="inferred",
    program="""
        O1
        N10 M9
        N20 M8 (AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA)
        N30 M30
    """,
    runs="N10 N20 N30", m=[9, 8],
)
case(
    "a block of 257 characters is too long",
    control=GSK, source="Talm 002; MDia 037", evidence="inferred",
    program="""
        O1
        N10 M9
        N20 M8 (AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA)
        N30 M30
    """,
    runs="N10", alarm="block-too-long",
    number={**dict.fromkeys(GSK_988, "002"), **dict.fromkeys(GSK_980, "0037")}, at="O1 N20", m=[9],
)
case(
    "an N behind other words is read and names nothing",
    pins="sequence_number_first",
    control=MITSUBISHI, source="general knowledge, N at the head", evidence="inferred",
    program="""
        O1
        N10 M8
        M9 N20
        N30 M30
    """,
    runs="N10 N30", m=[8, 9],
)
case(
    "26 words besides the N are not too many",
    control=FANUC, source="ALM PS5006", evidence="secondary",
    program="""
        O1
        N10 M8
        N20 A1 B1 C1 E1 F1 I1 J1 K1 Q1 R1 S1 T1 U1 V1 W1 X1 Y1 Z1 P1 L1 D1 H1 G90 G94 G40 G17
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "sequence numbers have eight digits and not nine",
    pins="max_sequence_number",
    control=[F0F, F30], source="ALM PS1128; general knowledge", evidence="inferred",
    program="""
        O1
        N99999999 M8
        N100000000 M9
        N30 M30
    """,
    runs="N99999999", alarm="illegal-sequence-number", number="PS1014", m=[8],
)

# Calls and returns

case(
    "M1 without its switch does not start the program over",
    pins="restart_m_code",
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
    pins="jump_m97",
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
    at="O1 N20",
)
case(
    "eight digits of P with four zeros in front are one call",
    pins="zero_count_alarms",
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
    pins="zero_count_alarms",
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
    pins="return_alone_in_modal",
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
    pins="return_alone_in_modal",
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
    pins="external_calls",
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
    pins="external_calls",
    control=T, source="source 000, M198", evidence="inferred",
    program="""
        O1
        N10 M198 P2
        N20 M30
    """,
    external={"O0002.CNC": "O0002\nN30 M99\n"}, runs="N10 N30 N20", calls="M198:O0002",
)
case(
    "M99 P takes the nearest block behind the call",
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
    pins="m_codes_alone",
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
    pins="words_with_call_in_cycle",
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
# Macro statements

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
    "ASIN of a negative value lies behind 180",
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
    pins="joined_conditions",
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
    pins="joined_conditions",
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
    pins="comparison_symbols",
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
    pins="comparison_symbols",
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
    pins="conditions_without_brackets",
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
    pins="modulo",
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
    pins="modulo",
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
    pins="indirect_9nnn",
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
    pins="indirect_9nnn",
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
    pins="variable_names",
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
    pins="negative_logic",
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
    pins="logic_binds_last",
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
    pins="logic_binds_last",
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
    pins="jumps_in_mdi",
    control=MITSUBISHI, source="MZ 869: tape only; general knowledge", evidence="inferred",
    program="""
        O2
        N20 M99
    """,
    mdi="N5 GOTO 8\nN7 T1\nN8 T2", runs="N5 N8", t=[2],
)
case(
    "GOTO may not stand in MDI",
    pins="jumps_in_mdi",
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
    pins="user_alarm_offset",
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
    pins="user_alarm_offset user_alarm_last",
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
    pins="variable_names",
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

# Macro calls

case(
    "M30 is an argument of a macro call",
    pins="m_codes_not_with_macro_call",
    control=[*GSK_988, *MITSUBISHI, *FANUC, "haas-ngc"],
    source="source 002, argument I; TA27; general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P2 M30
        N20 T1
        N25 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20 N25", arguments={13: 30},
)
case(
    "G66.1 does not exist",
    pins="modal_every_block",
    control=[*GSK, F16], source="general knowledge, G66.1", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G66.1 P2 A1
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="g-code-not-available",
    number={**dict.fromkeys(GSK_988, "009"), **dict.fromkeys(GSK_980, "0002"), F16: "010"},
    at="O1 N20",
)
case(
    "of an argument given twice the last counts",
    pins="repeated_argument",
    control=[*GSK, *MITSUBISHI, *FANUC, "haas-ngc"], source="TA27; PB304; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 G65 P2 A1. A2.
        N20 M30
        O2
        N30 #100=#1
        N40 M99
    """,
    runs="N10 N30 N40 N20", vars={100: 2},
)
case(
    "two modal calls stack: behind a move the last runs, and its own move calls the first",
    pins="modal_calls_stack",
    control=[*MITSUBISHI, *FANUC], source="NCT; M7V; general knowledge", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G66 P3
        N30 G0 X5
        N40 M30
        O2
        N50 M99
        O3
        N60 G0 X6
        N70 M99
    """,
    runs="N10 N20 N30 N60 N50 N70 N40",
)
case(
    "two modal calls stack on the 980: one G67 leaves the first",
    pins="modal_calls_stack",
    control=GSK_980, source="general knowledge, nested G66", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G66 P3
        N30 G67
        N40 G0 X5
        N50 M30
        O2
        N60 M99
        O3
        N70 M99
    """,
    runs="N10 N20 N30 N40 N60 N50",
)
case(
    "a macro call runs while a modal call is active",
    control=[*MITSUBISHI, *FANUC], source="general knowledge, G65 inside G66",
    evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G65 P3
        N30 G0 X5
        N40 M30
        O2
        N50 M99
        O3
        N60 M99
    """,
    runs="N10 N20 N60 N30 N50 N40",
)
case(
    "M98 runs while a modal call is active",
    control=[*MITSUBISHI, *FANUC], source="general knowledge, M98 inside G66",
    evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 M98 P3
        N30 G0 X5
        N40 M30
        O2
        N50 M99
        O3
        N60 M99
    """,
    runs="N10 N20 N60 N30 N50 N40",
)
case(
    "a modal macro gets its arguments again at each call",
    pins="modal_locals",
    control=[*GSK, *MITSUBISHI], source="TA27, G66; TDi28, G66; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 G66 P2 A1
        N20 G0 X5
        N30 G0 X6
        N40 G67
        N50 M30
        O2
        N60 #100=#100+#1
        N70 #1=50
        N80 M99
    """,
    variables={100: 0}, vars={100: 2},
)
case(
    "what a modal macro leaves in #1 is there at its next call",
    pins="modal_locals",
    control=FANUC, source="K-H, G66", evidence="inferred",
    program="""
        O1
        N10 G66 P2 A1.
        N20 G0 X5.
        N30 G0 X6.
        N40 G67
        N50 M30
        O2
        N60 #100=#100+#1
        N70 #1=50
        N80 M99
    """,
    variables={100: 0}, vars={100: 51},
)
case(
    "a block that writes an axis and does not move it calls on the 980",
    pins="modal_trigger",
    control=GSK_980, source="TDi28, G66 (3)", evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G0 X0
        N40 M30
        O2
        N50 M99
    """,
    setup={"start": {"X": 0, "Y": 0, "Z": 0}}, runs="N10 N20 N50 N40",
)
case(
    "a block that writes an axis and does not move it calls nothing",
    pins="modal_trigger",
    control=[*GSK_988, *MITSUBISHI, *FANUC], source="TA27, G66; M7V; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 G66 P2
        N20 G0 X0
        N40 M30
        O2
        N50 M99
    """,
    setup={"start": {"X": 0, "Y": 0, "Z": 0}}, runs="N10 N20 N40",
)
case(
    "G67 without a modal call to cancel is nothing",
    pins="cancel_alone",
    control=[*GSK_980, F16], source="general knowledge, G67", evidence="inferred",
    program="""
        O1
        N10 G67
        N20 M30
    """,
    runs="N10 N20",
)
case(
    "G67 without a modal call to cancel is refused",
    pins="cancel_alone",
    control=[*GSK_988, *MITSUBISHI, *FANUC_PS], source="Talm 218; MZ 857; ALM PS1100",
    evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G67
        N30 M30
    """,
    runs="N10", alarm="modal-call-missing",
    number={**dict.fromkeys(GSK_988, "218"), **dict.fromkeys(MITSUBISHI, "P276"), **dict.fromkeys(FANUC_PS, "PS1100")},
    at="O1 N20",
)
case(
    "X1 and X2 name no arguments of their own",
    control=[*GSK_980, *MITSUBISHI, *FANUC], source="source 002, argument I; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 G65 P2 X1.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={24: 1, 27: None},
)
case(
    "P of a macro call has four digits",
    control=GSK, source="TA27; TDi28", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G65 P10002
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="illegal-macro-number",
    number={**dict.fromkeys(GSK_988, "291"), **dict.fromkeys(GSK_980, "0119")}, at="O1 N20",
)
case(
    "P of a macro call has eight digits",
    pins="max_macro_digits",
    control=[*MITSUBISHI, F30, F0F], source="IMD, P; general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P12345678
        N30 M30
        O12345678
        N40 M99
    """,
    runs="N10 N40 N30",
)
case(
    "I, J and K count per letter on the 980",
    control=GSK_980, source="TDi28", evidence="inferred",
    program="""
        O1
        N10 G65 P2 I1 J2 I3 K4
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={4: 1, 5: 2, 7: 3, 6: 4},
)
case(
    "I, J and K count in sets as they are written on a Mitsubishi",
    control=MITSUBISHI, source="general knowledge, argument II", evidence="inferred",
    program="""
        O1
        N10 G65 P2 K1. J2. I3.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={6: 1, 8: 2, 10: 3},
)
case(
    "four macros may be open, and a fifth is too many",
    control=[*GSK_980, MELDAS], source="MDia 096; SM 6", evidence="inferred",
    program="""
        O1
        N10 G65 P2
        N15 M30
        O2
        N20 G65 P3
        M99
        O3
        N30 G65 P4
        M99
        O4
        N40 G65 P5
        M99
        O5
        N50 G65 P6
        M99
        O6
        N60 T1
        M99
    """,
    runs="N10 N20 N30 N40", alarm="macro-nesting-too-deep",
    number={**dict.fromkeys(GSK_980, "0096"), MELDAS: "P273"}, at="O5 N50",
)
case(
    "macros do not count as subprograms on the 980",
    pins="nesting_counts_macros",
    control=GSK_980, source="general knowledge, nesting", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N15 M30
        O2
        N20 M98 P3
        M99
        O3
        N30 M98 P4
        M99
        O4
        N40 M98 P5
        M99
        O5
        N50 G65 P6
        M99
        O6
        N60 M99
    """,
    runs="N10 N20 N30 N40 N50 N60 N15",
)
case(
    "H99 raises alarm 5900 and the number in P",
    pins="h99_offset",
    control=MDI, source="TDi28, H99", evidence="inferred",
    program="""
        O1
        N10 G65 H99 P5
        N20 M30
    """,
    runs="N10", alarm="user-alarm", number="5905", at="O1 N10",
)
case(
    "G17 may not share a block with G66",
    pins="codes_not_with_modal_call",
    control=GSK_988, source="TA27, note 6; Talm 212", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G66 P2 G17
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="code-with-modal-call", number="212", at="O1 N20",
)
case(
    "G97 is no argument of G66",
    pins="codes_not_with_modal_call",
    control=GSK_980, source="MDia 044: groups 00 and 01 only; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G66 P2 G97
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="illegal-argument", at="O1 N20",
)
case(
    "G04 is no argument of G66",
    pins="codes_not_with_modal_call",
    control=[*MITSUBISHI, *FANUC], source="ALM PS0129; general knowledge", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G66 P2 G4
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="illegal-argument",
    number={**dict.fromkeys(MITSUBISHI, "P33"), F16: "129", **dict.fromkeys(FANUC_PS, "PS0129")},
    at="O1 N20", word="G4",
)
case(
    "G43 is no argument of G65",
    pins="codes_not_with_macro_call",
    control=[*MITSUBISHI, *FANUC], source="ALM PS0129; general knowledge", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G65 P2 G43
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="illegal-argument",
    number={**dict.fromkeys(MITSUBISHI, "P33"), F16: "129", **dict.fromkeys(FANUC_PS, "PS0129")},
    at="O1 N20", word="G43",
)
case(
    "X1= gives the 988T an argument of its own",
    control=T, source="TA27, argument I; general knowledge", evidence="inferred",
    program="""
        O1
        N10 G65 P2 X1=27.5 X2=30.5
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20", arguments={27: 27.5, 30: 30.5, 24: None},
)
case(
    "X1= is no argument",
    pins="numbered_axis_arguments",
    control=[*GSK_980, *MITSUBISHI, *FANUC, "haas-ngc"], source="general knowledge, arguments",
    evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G65 P2 X1=27.5
        N30 M30
        O2
        N40 M99
    """,
    runs="N10", alarm="illegal-character",
    number={**dict.fromkeys(GSK_980, None), **dict.fromkeys(MITSUBISHI, "P32"), F16: "009", **dict.fromkeys(FANUC_PS, "PS0009"), "haas-ngc": None},
    at="O1 N20",
)
case(
    "P of a macro call has no nine digits on a Mitsubishi",
    control=MITSUBISHI, source="SK P35; general knowledge, 8 digits", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G65 P123456789
        N30 M30
    """,
    runs="N10", alarm="illegal-macro-number", number="P35", at="O1 N20",
)
case(
    "P of a macro call has no nine digits",
    pins="max_macro_digits",
    control=FANUC, source="general knowledge, 8 digits", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G65 P123456789
        N30 M30
    """,
    runs="N10", alarm="illegal-macro-number", at="O1 N20",
)
case(
    "P of a macro call of eight digits names a number that these controls do not have",
    control=[F16, F0D], source="general knowledge, 4 digits", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 G65 P12345678
        N30 M30
    """,
    runs="N10", alarm="program-not-found", number={F16: "078", F0D: "PS0076"}, at="O1 N20",
)

# Reading: HNC and GSK 928

case(
    "N0 is read on the HNC and the GSK 928",
    pins="zero_numbers max_block_length",
    control=[HNC, TE], source="general knowledge", evidence="inferred",
    program="""
        %1
        N0 M8
        N30 M30
    """,
    runs="N0 N30", m=[8],
)
case(
    "an N behind other words is read on the HNC and the GSK 928",
    pins="sequence_number_first",
    control=[HNC, TE], source="general knowledge", evidence="inferred",
    program="""
        %1
        N10 M8
        M9 N20
        N30 M30
    """,
    m=[8, 9],
)
case(
    "eight digits are read on the HNC and the GSK 928",
    pins="max_digits",
    control=[HNC, TE], source="general knowledge, 8 digits", evidence="inferred",
    program="""
        %1
        N10 M8
        N20 S12345678
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "nine digits are refused on the HNC and the GSK 928",
    pins="percent_programs",
    control=[HNC, TE], source="general knowledge, 8 digits", evidence="inferred",
    program="""
        %1
        N10 M8
        N20 S123456789
        N30 M30
    """,
    runs="N10", alarm="too-many-digits", at="%1 N20",
)
case(
    "a slash inside a block is refused on the HNC and the GSK 928",
    pins="block_skip",
    control=[HNC, TE], source="general knowledge, block skip", evidence="inferred",
    program="""
        %1
        N10 M8
        N20 T1 /M9
        N30 M30
    """,
    skip=(1,), runs="N10", alarm="illegal-character", at="%1 N20",
)
case(
    "of an address given twice the last counts on the HNC and the GSK 928",
    control=[HNC, TE], source="general knowledge", evidence="inferred",
    program="""
        %1
        N10 T1 T2
        N30 M30
    """,
    runs="N10 N30", t=[2],
)
case(
    "a comment that is not closed reaches to the end of its block on the HNC and the GSK 928",
    pins="open_comment",
    control=[HNC, TE], source="policy", evidence="inferred",
    program="""
        %1
        N10 M8
        N20 T1 (OPEN M9
        N30 M30
    """,
    runs="N10 N20 N30", m=[8], t=[1],
)
case(
    "L takes no decimal point on the HNC and the GSK 928",
    control=[HNC, TE], source="general knowledge", evidence="inferred",
    program="""
        %1
        N10 M8
        N20 M98 P40 L1.
        N30 M30
        N40 M99
    """,
    runs="N10", alarm="illegal-decimal-point", at="%1 N20", word="L1.",
)
case(
    "S takes a decimal point on the HNC",
    control=HNC, source="general knowledge of the Century Star manuals", evidence="inferred",
    program="""
        %1
        N10 M8
        N20 S1.5
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "S takes no decimal point on the GSK 928",
    control=TE, source="general knowledge", evidence="inferred",
    program="""
        %1
        N10 M8
        N20 S1.5
        N30 M30
    """,
    runs="N10", alarm="illegal-decimal-point", at="%1 N20", word="S1.5",
)
case(
    "D takes a decimal point on the HNC and the GSK 928",
    control=[HNC, TE], source="general knowledge", evidence="inferred",
    program="""
        %1
        N10 M8
        N20 D1.
        N30 M30
    """,
    runs="N10 N20 N30",
)
case(
    "L takes no minus sign on the HNC",
    control=HNC, source="general knowledge of the Century Star manuals", evidence="inferred",
    program="""
        %1
        N10 M8
        N20 M98 P2 L-1
        N30 M30
        %2
        N40 M99
    """,
    runs="N10", alarm="illegal-minus-sign", at="%1 N20", word="L-1",
)
case(
    "a negative L is a count out of its range on the GSK 928",
    control=TE, source="general knowledge", evidence="inferred",
    program="""
        %1
        N10 M8
        N20 M98 P40 L-1
        N30 M30
        N40 M99
    """,
    runs="N10", alarm="illegal-repeat-count", at="%1 N20",
)
case(
    "of two M codes the last counts on the GSK 928",
    pins="m_codes_alarm",
    control=TE, source="general knowledge", evidence="inferred",
    program="""
        %1
        N10 M8 M9
        N30 M30
    """,
    runs="N10 N30", m=[9], dropped=["M8"],
)
case(
    "G without a number is refused on the HNC and the GSK 928",
    pins="bare_g",
    control=[HNC, TE], source="general knowledge", evidence="inferred",
    program="""
        %1
        N10 M8
        N20 G M9
        N30 M30
    """,
    runs="N10", alarm="address-without-value", at="%1 N20",
)
case(
    "a sequence number has four digits on the GSK 928",
    pins="max_sequence_number",
    control=TE, source="source 001, N of four digits", evidence="inferred",
    program="""
        %1
        N9999 M8
        N10000 M9
        N30 M30
    """,
    runs="N9999", alarm="illegal-sequence-number", m=[8],
)

# Calls and returns: HNC and GSK 928

case(
    "an M code may stand beside M98 on the HNC",
    pins="m_codes_alone",
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
    pins="m_codes_alone",
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
    pins="caller_call conditions_without_brackets",
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
    pins="external_calls",
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
    runs="N10", alarm="address-not-usable", at="%1 N20",
)
case(
    "M97 is no jump but a code for the machine on the HNC",
    pins="jump_m97",
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
    "a called program may call in MDI on the HNC",
    pins="mdi_calls",
    control=HNC, source="general knowledge of the Century Star manuals", evidence="inferred",
    program="""
        %2
        N20 M98 P3
        N30 M99
        %3
        N40 M99
    """,
    mdi="N5 M98 P2", runs="N5 N20 N40 N30",
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

# Reset

case(
    "reset makes locals and commons vacant",
    pins="reset_clears_locals reset_clears_commons",
    control=[*GSK_988, *FANUC], source="TA27, parameters 6001#6 and 6001#7; CW-G",
    evidence="secondary",
    program="""
        O1
        N10 #1=5
        N20 #100=6
        N30 M30
    """,
    vars={1: 5, 100: 6}, vars_after_reset={1: None, 100: None},
)
case(
    "reset makes locals vacant and leaves commons",
    pins="reset_clears_locals reset_clears_commons",
    control=[*GSK_980, *MITSUBISHI, "haas-ngc"], source="policy", evidence="inferred",
    program="""
        O1
        N10 #1=5
        N20 #100=6
        N30 M30
    """,
    vars={1: 5, 100: 6}, vars_after_reset={1: None, 100: 6},
)
case(
    "reset makes locals vacant and leaves commons on the HNC",
    pins="reset_clears_locals reset_clears_commons",
    control=HNC, source="policy", evidence="inferred",
    program="""
        %1
        N10 #1=5
        N20 #50=6
        N30 M30
    """,
    vars={1: 5, 50: 6}, vars_after_reset={1: None, 50: 6},
)

# What is left of reading and calls

case(
    "a run may start at an N that stands behind other words",
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
    pins="restart_m_code",
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
    pins="words_with_call_in_cycle",
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
    pins="words_with_call_in_cycle",
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
    pins="jump_m97",
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
    pins="vacant_system_writes",
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
    pins="vacant_system_writes",
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
    pins="named_programs wide_names",
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
    pins="named_programs bracket_names",
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
    pins="file_name_wins",
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

# Macro statements of the HNC

case(
    "GOTO is no statement of the HNC",
    control=HNC, source="general knowledge of the Century Star manuals", evidence="inferred",
    program="""
        %1
        N10 M8
        N20 GOTO 30
        N30 M30
    """,
    runs="N10", alarm="statement-not-available",
)
for text, value in {"123456789012": 123456789012, "ATAN[-1]": -0.785398, "[" * 64 + "1" + "]" * 64: 1, "ATAN2[-1,-1]": -2.356194, "-5 AND 3": 3}.items():
    case(
        f"{text[:12]}{'...' * (len(text) > 12)} is an expression of the HNC",
        pins="max_constant_digits max_brackets negative_logic logic_of_bits",
        control=HNC, source="general knowledge of the Century Star manuals", evidence="inferred",
        program=f"%1\nN10 #50={text}\nN30 M30",
        vars={50: value},
    )
for claim, text, cause in (
    ("thirteen digits are too many in a statement of the HNC", "1234567890123", "too-many-digits"),
    ("65 brackets are too many in a statement of the HNC", "[" * 65 + "1" + "]" * 65, "brackets-too-deep"),
    ("MOD is no operator of the HNC", "7 MOD 4", "nc-and-macro-in-block"),
    ("two letters are no function of the HNC", "EX[1]", "expression-format"),
):
    case(
        claim, control=HNC, source="general knowledge of the Century Star manuals",
        pins="short_functions modulo",
        evidence="inferred", program=f"%1\nN10 M8\nN20 #50={text}\nN30 M30",
        runs="N10", alarm=cause, at="%1 N20",
    )
for claim, condition, cause in (
    ("== is no operator of the HNC", "1 == 1", "statement-format"),
    ("a condition of the HNC has at most 128 characters", "[1 EQ 1]" + " AND [1 EQ 1]" * 8 + " AND [1 EQ 1.000]", "if-format"),
):
    case(
        claim, control=HNC, source="general knowledge of the Century Star manuals",
        pins="max_condition_length comparison_symbols",
        evidence="inferred", program=f"%1\nN10 M8\nN20 IF {condition}\nN25 ENDIF\nN30 M30",
        runs="N10", alarm=cause, at="%1 N20",
    )
case(
    "a vacant variable is 0 in a condition of the HNC",
    pins="vacant_comparison",
    control=HNC, source="general knowledge of the Century Star manuals", evidence="inferred",
    program="""
        %1
        N10 IF #60 EQ 0
        N20 M8
        N25 ENDIF
        N30 M30
    """,
    m=[8],
)
case(
    "a word with a vacant variable is 0 on the HNC",
    pins="vacant_address",
    control=HNC, source="general knowledge of the Century Star manuals", evidence="inferred",
    program="""
        %1
        N10 T#60
        N30 M30
    """,
    runs="N10 N30", t=[0],
)
case(
    "AND binds weaker than a comparison on the HNC",
    pins="joined_conditions logic_binds_last",
    control=HNC, source="general knowledge of the Century Star manuals", evidence="inferred",
    program="""
        %1
        N10 IF 1 EQ 1 AND 2 EQ 2
        N20 M8
        N25 ENDIF
        N30 M30
    """,
    m=[8],
)

# A corner beside a call

for _line, _word in [("G1 X10. ,C1. F100 M98 P2", ",C1."), ("M98 P2 G1 X10. ,R1. F100", ",R1."),
                     ("G1 X10. L1. F100 M98 P2", "L1."), ("M98 P2 U1.", "U1."),
                     ("G1 G91 Y10. U1. F100 M98 P2", "U1."), ("M98 P2 ,C1.", ",C1.")]:
    case(f"M98 beside a chamfer is 0093 on the 980MDi: {_line}", control=MDI, source="MDib 0093",
         evidence="maker's manual", program=f"O1\nN10 M8\nN20 {_line}\nN30 M30\nO2\nN40 M99\n",
         runs="N10", alarm="corner-with-call", number="0093", at="O1 N20", word=_word)
for _line in ("G1 X10. F100 M98 P2", "M98 P2 L1", "M98 P2"):
    case(f"a call without a chamfer is none to 0093: {_line}", control=MDI, source="MDib 0093",
         evidence="maker's manual", program=f"O1\nN10 M8\nN20 {_line}\nN30 M30\nO2\nN40 M99\n",
         runs="N10 N20 N40 N30", m=[8])
