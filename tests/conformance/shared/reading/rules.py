"""Reading: what a control has and does not have, rule by rule."""

from conformance import case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI = GSK_980 = ["gsk-980tdi", "gsk-980mdi"]
GSK = GSK_988 + GSK_980
MELDAS, M700, M800 = MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
UP_TO_99999 = [MELDAS, M800]
F16, F0D, F0F, F30 = FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
FANUC_PS = FANUC[1:]
HNC, TE = "hnc-21m", "gsk-928te"

# Reading

case(
    "a name in angle brackets heads no program",
    pins="program_heads:name max_block_length bracket_names",
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
    control=[*GSK, *UP_TO_99999, F16, F0D],
    source="PB155; Talm 003; MDia 006; SK P35; general knowledge", evidence="inferred",
    program="""
        O1
        N99999 M8
        N100000 M9
        N30 M30
    """,
    runs="N99999", alarm="illegal-sequence-number",
    number={**dict.fromkeys(GSK_988, "003"), **dict.fromkeys(GSK_980, "0006"), **dict.fromkeys(UP_TO_99999, "P35"), F16: None, F0D: "PS1014"},
    m=[8],
)
case(
    "a sequence number has six digits and not seven on an M700",
    pins="max_sequence_number",
    control="mitsubishi-m700", source="M7 p.23: N6", evidence="maker's manual",
    program="""
        O1
        N999999 M8
        N1000000 M9
        N30 M30
    """,
    runs="N999999", alarm="illegal-sequence-number", number="P35", m=[8],
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
    pins="refuses:program-number-zero m_codes_per_block",
    control=[*GSK_988, *FANUC, "haas-ngc"], source="policy", evidence="inferred",
    program="""
        O1
        N0 M8
        N30 M30
    """,
    runs="N0 N30", m=[8],
)
case(
    "an N after other words is read",
    pins="refuses:sequence-number-not-first late_sequence_numbers",
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
    "GOTO finds no N that stands after other words",
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
    pins="extra_m_codes",
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
    pins="m_codes_per_block extra_m_codes",
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
    pins="program_heads:percent",
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
    "an N after other words is read and names nothing",
    pins="refuses:sequence-number-not-first",
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

# Reading: HNC and GSK 928

case(
    "N0 is read on the HNC and the GSK 928",
    pins="refuses:program-number-zero max_block_length",
    control=[HNC, TE], source="general knowledge", evidence="inferred",
    program="""
        %1
        N0 M8
        N30 M30
    """,
    runs="N0 N30", m=[8],
)
case(
    "an N after other words is read on the HNC and the GSK 928",
    pins="refuses:sequence-number-not-first",
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
    pins="program_heads:percent",
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
    pins="extra_m_codes",
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
