"""Reading of NC text: joins, numbers, characters and words that a control does not know."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
GSK_988 = ["gsk-988ta", "gsk-988t"]
GSK_980 = ["gsk-980tdi", "gsk-980mdi"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
WITH_O = FANUC + GSK_988 + GSK_980 + MITSUBISHI  # programs are named O1
WITH_PERCENT = ["hnc-21m", "gsk-928te"]  # programs are named %1
HNC = "hnc-21m"


def on_fanuc(number):
    """Return the alarm as each FANUC shows it: 005 on the 16i, PS0005 on the others."""
    return {c: f"{number:03d}" if c == "fanuc-16i" else f"PS{number:04d}" for c in FANUC}


def everywhere(claim, text, **expected):
    """Write one row for the controls whose programs have an O, one for those with a %.

    `text` is the only file of the memory, in bytes, with HEAD for the head of the program.
    """
    for head, controls in ((b"O1", WITH_O), (b"%1", WITH_PERCENT)):
        case(
            f"{claim}, programs headed {head.decode()}",
            control=controls, files={"O1.NC": text.replace(b"HEAD", head)}, **expected,
        )


POLICY = "general knowledge"
PLAIN = {"source": POLICY, "evidence": "inferred", "runs": "N10 N20 N30", "m": [8, 9]}

# Joins, spaces, zeros, case

everywhere("words need no spaces between them", b"HEAD\nN10M8\nN20M9\nN30M30\n", **PLAIN)
everywhere("spaces and tabs between words are no difference",
           b"HEAD\n  N10\t M8\t\n N20   M9\nN30 M30\n", **PLAIN)
everywhere("spaces inside words are no difference", b"HEAD\nN 1 0 M 8\nN2 0M 0 9\nN30 M3 0\n",
           **PLAIN)
everywhere("leading zeros of an M code are no difference",
           b"HEAD\nN10 M08\nN20 M009\nN30 M0030\n", **PLAIN)
everywhere("small letters are read as capitals", b"HEAD\nn10 m8\nn20 M9\nN30 m30\n", **PLAIN)
case(
    "a call joined to a move is a call",
    control=WITH_O, source=POLICY, evidence="inferred",
    program="""
        O1
        N10G0X1.M98P22
        N20M30
        O22
        N30M99
    """,
    runs="N10 N30 N20", calls="M98:O22",
)
case(
    "a joined call of a missing program is told at its P on FANUC",
    control=FANUC, source="ALM PS0076; general knowledge 078", evidence="inferred",
    program="""
        O1
        N10G0X1.M98P22
        N20M30
    """,
    runs="N10", alarm="program-not-found",
    number={c: "078" if c == "fanuc-16i" else "PS0076" for c in FANUC}, at="O1 N10", word="P22",
)
case(
    "a joined call of a missing program is told at its P on a Mitsubishi",
    control=MITSUBISHI, source="source 004, note 1", evidence="source document",
    program="""
        O1
        N10G0X1.M98P22
        N20M30
    """,
    runs="N10", alarm="program-not-found", number="P232", at="O1 N10", word="P22",
)
case(
    "a joined call of a missing program is told at its P on the GSK 988",
    control=GSK_988, source="source 000, note 3; Talm 83", evidence="inferred",
    program="""
        O1
        N10G0X1.M98P0022
        N20M30
    """,
    runs="N10", alarm="program-not-found", number="083", at="O1 N10", word="P0022",
)
case(
    "macro statements need no spaces",
    control=FANUC + MITSUBISHI, source="programs seen in shops", evidence="inferred",
    program="""
        O1
        N10#100=5
        N20IF[#100EQ5]GOTO40
        N30M8
        N40WHILE[#100LT7]DO1
        N50#100=#100+1
        N60END1
        N70M30
    """,
    runs="N10 N20 N40 N50 N60 N40 N50 N60 N40 N70", vars={100: 7}, m=[],
)
case(
    "macro statements may have spaces inside",
    control=FANUC + MITSUBISHI, source="programs seen in shops", evidence="inferred",
    program="""
        O1
        N10 # 100 = 1 0 1
        N20 # [ #100 ] = 2 . 5
        N30 GO TO 50
        N40 M 8
        N50 M 3 0
    """,
    runs="N10 N20 N30 N50", vars={100: 101, 101: 2.5}, m=[],
)
case(
    "leading zeros in a jump and in a variable are no difference",
    control=FANUC + MITSUBISHI, source="programs seen in shops", evidence="inferred",
    program="""
        O1
        N10 #0100=#06+1
        N20 GOTO0040
        N30 M8
        N40 M30
    """,
    runs="N10 N20 N40", vars={100: 1}, m=[],
)
case(
    "macro statements in small letters are read",
    control=FANUC + MITSUBISHI, source="policy for small letters", evidence="inferred",
    program="""
        o1
        n10 #100=sin[30]
        n20 if[#100 lt 1]goto40
        n30 m8
        n40 m30
    """,
    runs="N10 N20 N40", vars={100: 0.5}, m=[],
)
case(
    "a joined jump to a block that does not exist is P231",
    control=MITSUBISHI, source="MZ 843; source 004, P231", evidence="secondary",
    program="""
        O1
        N10IF[#100EQ#0]GOTO0099
        N20M30
    """,
    runs="", alarm="jump-target-not-found", number="P231", at="O1 N10",
)
case(
    "on the 16i two letters of a function suffice",
    control="fanuc-16i", source="general knowledge, first two letters", evidence="inferred",
    program="""
        O1
        N10 #100=RO[1.6]+FI[2.9]+SI[30]
        N20 M30
    """,
    runs="N10 N20", vars={100: 4.5},
)

# Numbers

case(
    "X1 is read as thousandths of a millimetre on FANUC",
    control=FANUC,
    source="general knowledge, decimal point and least increment", evidence="inferred",
    program="O1\nN10 G90 G0 X1\nN20 #100=#5001\nN30 M30",
    runs="N10 N20 N30", vars={100: 0.001},
)
case(
    "X1. is read as millimetres on FANUC",
    control=FANUC,
    source="general knowledge, decimal point and least increment", evidence="inferred",
    program="O1\nN10 G90 G0 X1.\nN20 #100=#5001\nN30 M30",
    runs="N10 N20 N30", vars={100: 1},
)
case(
    "X.5 is read as half a millimetre on FANUC",
    control=FANUC,
    source="general knowledge, decimal point and least increment", evidence="inferred",
    program="O1\nN10 G90 G0 X.5\nN20 #100=#5001\nN30 M30",
    runs="N10 N20 N30", vars={100: 0.5},
)
case(
    "X-.5 is read as minus half a millimetre on FANUC",
    control=FANUC,
    source="general knowledge, decimal point and least increment", evidence="inferred",
    program="O1\nN10 G90 G0 X-.5\nN20 #100=#5001\nN30 M30",
    runs="N10 N20 N30", vars={100: -0.5},
)
case(
    "X+1. is read as one millimetre with a plus sign on FANUC",
    control=FANUC,
    source="general knowledge, decimal point and least increment", evidence="inferred",
    program="O1\nN10 G90 G0 X+1.\nN20 #100=#5001\nN30 M30",
    runs="N10 N20 N30", vars={100: 1},
)
case(
    "X01.50 is read as one and a half millimetres on FANUC",
    control=FANUC,
    source="general knowledge, decimal point and least increment", evidence="inferred",
    program="O1\nN10 G90 G0 X01.50\nN20 #100=#5001\nN30 M30",
    runs="N10 N20 N30", vars={100: 1.5},
)
case(
    "X1.23456 is read as millimetres cut to the least increment on FANUC",
    pins="cuts_fine_digits", control=FANUC,
    source="general knowledge, decimal point and least increment", evidence="inferred",
    program="O1\nN10 G90 G0 X1.23456\nN20 #100=#5001\nN30 M30",
    runs="N10 N20 N30", vars={100: 1.234},
)
case(
    "with pocket calculator notation X1 is one millimetre",
    control=FANUC, source="general knowledge, 3401#0 DPI", evidence="inferred",
    program="""
        O1
        N10 G90 G0 X1
        N20 #100=#5001
        N30 M30
    """,
    params={"3401#0": 1}, runs="N10 N20 N30", vars={100: 1},
)
case(
    "a value from a variable is rounded to the least increment and not cut",
    pins="computed_lengths", control=FANUC, source="JIX, XIA", evidence="secondary",
    program="""
        O1
        N10 #1=1.23456
        N20 G90 G0 X#1
        N30 #100=#5001
        N40 M30
    """,
    runs="N10 N20 N30 N40", vars={100: 1.235},
)
case(
    "nobody says it of other makers' controls, and they are taken to do the same",
    pins="computed_lengths", control=[*GSK_988, *GSK_980, *MITSUBISHI], source="policy", evidence="inferred",
    program="O1\nN10 #1=1.23456\nN20 G0 X#1\nN30 #100=#5001\nN40 M30",
    runs="N10 N20 N30 N40", vars={100: 1.235},
)
case(
    "so is the 22MA",
    pins="computed_lengths", control="syntec-22ma", source="policy", evidence="inferred",
    program="O1\nN10 #1=0.0004\nN20 G91 G0 X1.\n" + "N30 X[#1]\n" * 8 + "N40 M30", final_work="X1",
)
case(
    "so is the HNC-21M",
    pins="computed_lengths", control=HNC, source="policy", evidence="inferred",
    program="%1\nN10 #1=0.0004\nN20 G91 G0 X1\n" + "N30 X[#1]\n" * 8 + "N40 M30", final_work="X1",
)
case(
    "an M code from a variable is rounded half up",
    control=FANUC, source="SIN", evidence="secondary",
    program="""
        O1
        N10 #1=7.5
        N20 M#1
        N30 M[#1+0.7]
        N40 M30
    """,
    runs="N10 N20 N30 N40", m=[8, 8],
)

FORM = "general knowledge, faults of form"

case(
    "an address without a value is alarm 005 on FANUC: N20 M8 T",
    control=FANUC, source="ALM PS0005", number=on_fanuc(5),
    program="O1\nN10 M9\nN20 M8 T\nN30 M30",
    evidence="inferred", runs="N10", m=[9], alarm="address-without-value", at="O1 N20", word="T",
)
case(
    "an address without a value is 005 on the GSK 988: N20 M8 T",
    control=GSK_988, source="Talm 005", number="005",
    program="O1\nN10 M9\nN20 M8 T\nN30 M30",
    evidence="inferred", runs="N10", m=[9], alarm="address-without-value", at="O1 N20", word="T",
)
case(
    "an address without a value is P33 on a Mitsubishi: N20 M8 T",
    control=MITSUBISHI, source="SK P33", number="P33",
    program="O1\nN10 M9\nN20 M8 T\nN30 M30",
    evidence="inferred", runs="N10", m=[9], alarm="address-without-value", at="O1 N20", word="T",
)
case(
    "an address whose value is only a sign is alarm 005 on FANUC: N20 M8 X-",
    control=FANUC, source="ALM PS0005", number=on_fanuc(5),
    program="O1\nN10 M9\nN20 M8 X-\nN30 M30",
    evidence="inferred", runs="N10", m=[9], alarm="address-without-value", at="O1 N20", word="X-",
)
case(
    "an address whose value is only a sign is 005 on the GSK 988: N20 M8 X-",
    control=GSK_988, source="Talm 005", number="005",
    program="O1\nN10 M9\nN20 M8 X-\nN30 M30",
    evidence="inferred", runs="N10", m=[9], alarm="address-without-value", at="O1 N20", word="X-",
)
case(
    "an address whose value is only a sign is P33 on a Mitsubishi: N20 M8 X-",
    control=MITSUBISHI, source="SK P33", number="P33",
    program="O1\nN10 M9\nN20 M8 X-\nN30 M30",
    evidence="inferred", runs="N10", m=[9], alarm="address-without-value", at="O1 N20", word="X-",
)
case(
    "an address right before another one is alarm 005 on FANUC: N20 G0 X Y1.",
    control=FANUC, source="ALM PS0005", number=on_fanuc(5),
    program="O1\nN10 M9\nN20 G0 X Y1.\nN30 M30",
    evidence="inferred", runs="N10", m=[9], alarm="address-without-value", at="O1 N20", word="X",
)
case(
    "an address right before another one is 005 on the GSK 988: N20 G0 X Y1.",
    control=GSK_988, source="Talm 005", number="005",
    program="O1\nN10 M9\nN20 G0 X Y1.\nN30 M30",
    evidence="inferred", runs="N10", m=[9], alarm="address-without-value", at="O1 N20", word="X",
)
case(
    "an address right before another one is P33 on a Mitsubishi: N20 G0 X Y1.",
    control=MITSUBISHI, source="SK P33", number="P33",
    program="O1\nN10 M9\nN20 G0 X Y1.\nN30 M30",
    evidence="inferred", runs="N10", m=[9], alarm="address-without-value", at="O1 N20", word="X",
)
case(
    "a number with two points is alarm 007 on FANUC: N20 G0 Y1.2.3",
    control=FANUC, source="ALM PS0007", number=on_fanuc(7),
    program="O1\nN10 M9\nN20 G0 Y1.2.3\nN30 M30",
    evidence="inferred", runs="N10", m=[9], alarm="illegal-decimal-point", at="O1 N20",
    word="Y1.2.3",
)
case(
    "a number with two points is 007 on the GSK 988: N20 G0 Y1.2.3",
    control=GSK_988, source="Talm 007", number="007",
    program="O1\nN10 M9\nN20 G0 Y1.2.3\nN30 M30",
    evidence="inferred", runs="N10", m=[9], alarm="illegal-decimal-point", at="O1 N20",
    word="Y1.2.3",
)
case(
    "a number with two points is P33 on a Mitsubishi: N20 G0 Y1.2.3",
    control=MITSUBISHI, source="SK P33", number="P33",
    program="O1\nN10 M9\nN20 G0 Y1.2.3\nN30 M30",
    evidence="inferred", runs="N10", m=[9], alarm="illegal-decimal-point", at="O1 N20",
    word="Y1.2.3",
)
case(
    "a point in an M code is alarm 007 on FANUC: N20 M8.",
    control=FANUC, source="ALM PS0007", number=on_fanuc(7),
    program="O1\nN10 M9\nN20 M8.\nN30 M30",
    evidence="inferred", runs="N10", m=[9], alarm="illegal-decimal-point", at="O1 N20", word="M8.",
)
case(
    "a point in an M code is 007 on the GSK 988: N20 M8.",
    control=GSK_988, source="Talm 007", number="007",
    program="O1\nN10 M9\nN20 M8.\nN30 M30",
    evidence="inferred", runs="N10", m=[9], alarm="illegal-decimal-point", at="O1 N20", word="M8.",
)
case(
    "a point in an M code is P33 on a Mitsubishi: N20 M8.",
    control=MITSUBISHI, source="SK P33", number="P33",
    program="O1\nN10 M9\nN20 M8.\nN30 M30",
    evidence="inferred", runs="N10", m=[9], alarm="illegal-decimal-point", at="O1 N20", word="M8.",
)
case(
    "a point in a tool number is alarm 007 on FANUC: N20 T1.",
    control=FANUC, source="ALM PS0007", number=on_fanuc(7),
    program="O1\nN10 M9\nN20 T1.\nN30 M30",
    evidence="inferred", runs="N10", m=[9], alarm="illegal-decimal-point", at="O1 N20", word="T1.",
)
case(
    "a point in a tool number is 007 on the GSK 988: N20 T1.",
    control=GSK_988, source="Talm 007", number="007",
    program="O1\nN10 M9\nN20 T1.\nN30 M30",
    evidence="inferred", runs="N10", m=[9], alarm="illegal-decimal-point", at="O1 N20", word="T1.",
)
case(
    "a point in a tool number is P33 on a Mitsubishi: N20 T1.",
    control=MITSUBISHI, source="SK P33", number="P33",
    program="O1\nN10 M9\nN20 T1.\nN30 M30",
    evidence="inferred", runs="N10", m=[9], alarm="illegal-decimal-point", at="O1 N20", word="T1.",
)
case(
    "a block that begins with a value alarms, ALM PS0004: 5 M8",
    control=FANUC, source="ALM PS0004", evidence="inferred",
    program="O1\nN10 M9\n5 M8\nN30 M30\n",
    runs="N10", m=[9], alarm="value-without-address", number=on_fanuc(4), at="O1",
)
case(
    "a block that begins with a value alarms, Talm 004: 5 M8",
    control=GSK_988, source="Talm 004", evidence="inferred",
    program="O1\nN10 M9\n5 M8\nN30 M30\n",
    runs="N10", m=[9], alarm="value-without-address", number="004", at="O1",
)
case(
    "a block that begins with a value alarms, SK P33: 5 M8",
    control=MITSUBISHI, source="SK P33", evidence="inferred",
    program="O1\nN10 M9\n5 M8\nN30 M30\n",
    runs="N10", m=[9], alarm="value-without-address", number="P33", at="O1",
)
case(
    "a block that begins with a value alarms, ALM PS0004: 12.5",
    control=FANUC, source="ALM PS0004", evidence="inferred",
    program="O1\nN10 M9\n12.5\nN30 M30\n",
    runs="N10", m=[9], alarm="value-without-address", number=on_fanuc(4), at="O1",
)
case(
    "a block that begins with a value alarms, Talm 004: 12.5",
    control=GSK_988, source="Talm 004", evidence="inferred",
    program="O1\nN10 M9\n12.5\nN30 M30\n",
    runs="N10", m=[9], alarm="value-without-address", number="004", at="O1",
)
case(
    "a block that begins with a value alarms, SK P33: 12.5",
    control=MITSUBISHI, source="SK P33", evidence="inferred",
    program="O1\nN10 M9\n12.5\nN30 M30\n",
    runs="N10", m=[9], alarm="value-without-address", number="P33", at="O1",
)
case(
    "a blank inside a sequence number is passed over on FANUC: N20 5 is N205",
    control=FANUC, source="GED, blanks", evidence="secondary",
    program="""
        O1
        N10 GOTO 205
        N20 5 M8
        N30 M30
    """,
    runs="N10 N205 N30", m=[8],
)
case(
    "a minus sign in M-8 is refused, ALM PS0006",
    control=FANUC, source="ALM PS0006", evidence="inferred",
    program="O1\nN10 M9\nN20 M-8\nN30 M30",
    runs="N10", m=[9], alarm="illegal-minus-sign", number=on_fanuc(6), at="O1 N20", word="M-8",
)
case(
    "a minus sign in T-1 is refused, ALM PS0006",
    control=FANUC, source="ALM PS0006", evidence="inferred",
    program="O1\nN10 M9\nN20 T-1\nN30 M30",
    runs="N10", m=[9], alarm="illegal-minus-sign", number=on_fanuc(6), at="O1 N20", word="T-1",
)
case(
    "a minus sign in M-8 is refused, Talm 006",
    control=GSK_988, source="Talm 006", evidence="inferred",
    program="O1\nN10 M9\nN20 M-8\nN30 M30",
    runs="N10", m=[9], alarm="illegal-minus-sign", number="006", at="O1 N20", word="M-8",
)
case(
    "a minus sign in T-1 is refused, Talm 006",
    control=GSK_988, source="Talm 006", evidence="inferred",
    program="O1\nN10 M9\nN20 T-1\nN30 M30",
    runs="N10", m=[9], alarm="illegal-minus-sign", number="006", at="O1 N20", word="T-1",
)
case(
    "HNC refuses an address without a value",
    control=HNC, source=FORM, evidence="inferred",
    program="""
        %1
        N10 M9
        N20 M8 T
        N30 M30
    """,
    runs="N10", m=[9], alarm="address-without-value", number=None, at="%1 N20",
)
case(
    "HNC refuses a number with two points",
    control=HNC, source=FORM, evidence="inferred",
    program="""
        %1
        N10 M9
        N20 G0 X1.2.3
        N30 M30
    """,
    runs="N10", m=[9], alarm="illegal-decimal-point", number=None, at="%1 N20", word="X1.2.3",
)
case(
    "nine digits are too many for the 16i",
    control="fanuc-16i", source="ALM PS0003; general knowledge, 8 digits", evidence="inferred",
    program="""
        O1
        N10 M9
        N20 G0 X123456789
        N30 M30
    """,
    runs="N10", alarm="too-many-digits", number="003", at="O1 N20", word="X123456789",
)
case(
    "the digits of a value with a point count in least increments",
    control=FANUC, source="ALM PS0003; general knowledge, digits after conversion",
    evidence="inferred",
    program="""
        O1
        N10 M9
        N20 G0 Y1234567.
        N30 M30
    """,
    runs="N10", alarm="too-many-digits", number=on_fanuc(3), at="O1 N20", word="Y1234567.",
)
case(
    "a value of more than eight digits is 003 on the GSK 988",
    control=GSK_988, source="Talm 003", evidence="maker's manual",
    program="""
        O1
        N10 M9
        N20 G0 X123456789
        N30 M30
    """,
    runs="N10", alarm="too-many-digits", number="003", at="O1 N20", word="X123456789",
)

# Characters, words and codes that the control does not know

case(
    "an exclamation mark is a character that FANUC does not know",
    control=FANUC, source="ALM PS0009; policy for characters", evidence="inferred",
    files={"O1.NC": b'O1\nN10 M9\nN20 M8 !\nN30 M30\n'}, runs="N10", m=[9],
    alarm="illegal-character", number=on_fanuc(9), at="O1 N20",
)
case(
    "a dollar sign is a character that FANUC does not know",
    control=FANUC, source="ALM PS0009; policy for characters", evidence="inferred",
    files={"O1.NC": b'O1\nN10 M9\nN20 M8 $\nN30 M30\n'}, runs="N10", m=[9],
    alarm="illegal-character", number=on_fanuc(9), at="O1 N20",
)
case(
    "a control character is a character that FANUC does not know",
    control=FANUC, source="ALM PS0009; policy for characters", evidence="inferred",
    files={"O1.NC": b'O1\nN10 M9\nN20 M8 \x07\nN30 M30\n'}, runs="N10", m=[9],
    alarm="illegal-character", number=on_fanuc(9), at="O1 N20",
)
case(
    "Chinese text outside a comment stops FANUC at its block",
    control=FANUC, source="ALM PS0009; policy for characters", evidence="inferred",
    files={"O1.NC": "O1\nN10 M9\nN20 M8 \u52a0\u5de5\nN30 M30\n".encode()},
    runs="N10", m=[9], alarm="illegal-character", number=on_fanuc(9), at="O1 N20",
)
case(
    "a byte of no encoding outside a comment stops FANUC at its block",
    control=FANUC, source="ALM PS0009; policy for characters", evidence="inferred",
    files={"O1.NC": b"O1\nN10 M9\nN20 M8 \xff\nN30 M30\n"},
    runs="N10", m=[9], alarm="illegal-character", number=on_fanuc(9), at="O1 N20",
)
case(
    "zeros in the middle of a program are skipped",
    control=WITH_O, source=POLICY, evidence="inferred",
    files={"O1.NC": b"O1\nN10 M8\n\0\0\0N20 M9\nN30 M30\n"},
    runs="N10 N20 N30", m=[8, 9],
)
case(
    "a character that the GSK 988 does not know alarms without a number",
    control=GSK_988, source="general knowledge; no list names a character", evidence="inferred",
    files={"O1.CNC": b"O1\nN10 M9\nN20 M8 !\nN30 M30\n"},
    runs="N10", m=[9], alarm="illegal-character", number=None, at="O1 N20",
)
case(
    "a character that a Mitsubishi does not know is P32",
    control=MITSUBISHI, source="SK P32", evidence="inferred",
    files={"O1.NC": b"O1\nN10 M9\nN20 M8 !\nN30 M30\n"},
    runs="N10", m=[9], alarm="illegal-character", number="P32", at="O1 N20",
)
case(
    "a character that HNC does not know stops at its block",
    pins="program_heads:file",
    control=HNC, source=FORM, evidence="inferred",
    files={"O1": b"%1\nN10 M9\nN20 M8 !\nN30 M30\n"},
    runs="N10", m=[9], alarm="illegal-character", number=None, at="%1 N20",
)
case(
    "an unknown character after M30 is never reached",
    control=WITH_O, source="reading never fails", evidence="inferred",
    program="""
        O1
        N10 M9
        N20 M30
        N30 M8 !!
    """,
    runs="N10 N20", m=[9],
)
case(
    "a faulty block that a jump passes raises nothing",
    control=FANUC + MITSUBISHI, source="reading never fails", evidence="inferred",
    program="""
        O1
        N10 GOTO30
        N20 M-8 X1.2.3 T !
        N30 M30
    """,
    runs="N10 N30",
)
case(
    "a faulty program that nobody calls raises nothing",
    control=WITH_O, source="reading never fails", evidence="inferred",
    program="""
        O1
        N10 M9
        N20 M30
        O22
        N30 M8 ! X1.2.3 (
    """,
    runs="N10 N20", m=[9],
)
case(
    "the words in front of a fault in the same block are not executed",
    control=FANUC, source="ALM PS0006; nothing changes before a block has been checked",
    evidence="inferred",
    program="""
        O1
        N10 T5 M-8
        N20 M30
    """,
    runs="", t=[], alarm="illegal-minus-sign", number=on_fanuc(6), at="O1 N10", word="M-8",
)
case(
    "a G code that FANUC does not have is alarm 010",
    control=FANUC, source="ALM PS0010", evidence="secondary",
    program="""
        O1
        N10 M9
        N20 G999 X1.
        N30 M30
    """,
    runs="N10", m=[9], alarm="g-code-not-available", number=on_fanuc(10), at="O1 N20",
    word="G999",
)
case(
    "so is one that is computed, at its own word",
    control=FANUC, source="ALM PS0010", evidence="secondary",
    program="O1\nN10 #1=999\nN20 X3. G0 G#1\nN30 M30", runs="N10",
    alarm="g-code-not-available", number=on_fanuc(10), at="O1 N20", word="G#1",
)
case(
    "a G code that the GSK 988 does not have is 009",
    control=GSK_988, source="Talm 009", evidence="inferred",
    program="""
        O1
        N10 M9
        N20 G999 X1.
        N30 M30
    """,
    runs="N10", m=[9], alarm="g-code-not-available", number="009", at="O1 N20", word="G999",
)
case(
    "a G code that the GSK 980 does not have is 0002",
    control=GSK_980, source="MDib 0002", evidence="inferred",
    program="""
        O1
        N10 M9
        N20 G999
        N30 M30
    """,
    runs="N10", m=[9], alarm="g-code-not-available", number="0002", at="O1 N20", word="G999",
)
case(
    "27 words in a block are too many for FANUC",
    control=FANUC, source="ALM PS5006", evidence="secondary",
    program="O1\nN10 M9\nN20 " + "T1 " * 27 + "\nN30 M30\n",
    runs="N10", t=[], alarm="too-many-words",
    number={c: "5006" if c == "fanuc-16i" else "PS5006" for c in FANUC}, at="O1 N20",
)
case(
    "a block of more than 256 characters is 002 on the GSK 988",
    control=GSK_988, source="Talm 002", evidence="inferred",
    program="O1\nN10 M9\nN20 " + "T00000001" * 40 + "\nN30 M30\n",
    runs="N10", t=[], alarm="block-too-long", number="002", at="O1 N20",
)
case(
    "an address written twice is 010 on the GSK 980",
    pins="repeated_address",
    control=GSK_980, source="MDia 010", evidence="maker's manual",
    program="""
        O1
        N10 M9
        N20 T1 T2
        N30 M30
    """,
    runs="N10", t=[], alarm="address-given-twice", number="0010", at="O1 N20",
)
case(
    "an address written twice is 010 on the GSK 988 when AD2 is set",
    control=GSK_988, source="Talm 010; TApar 3403#6", evidence="inferred",
    program="""
        O1
        N10 M9
        N20 T1 T2
        N30 M30
    """,
    params={"3403#6": 1}, runs="N10", t=[], alarm="address-given-twice", number="010",
    at="O1 N20",
)
case(
    "of an address written twice the last one counts on the others",
    control=FANUC + GSK_988 + MITSUBISHI, source="TApar 3403#6; general knowledge",
    evidence="inferred",
    program="""
        O1
        N10 T1 T2
        N30 M30
    """,
    runs="N10 N30", t=[2],
)
case(
    "two G codes of one group are PS5074 on FANUC when AD2 is set",
    control=FANUC, source="ALM PS5074; general knowledge, 3403#6", evidence="inferred",
    program="""
        O1
        N10 M9
        N20 G90 G91
        N30 M30
    """,
    params={"3403#6": 1}, runs="N10", alarm="address-given-twice",
    number={c: "5074" if c == "fanuc-16i" else "PS5074" for c in FANUC}, at="O1 N20",
)
