"""Words that a control reads in a block and does not obey: they are always reported."""

from conformance import case

TA, T = GSK_988 = ["gsk-988ta", "gsk-988t"]
TDI, MDI = GSK_980 = ["gsk-980tdi", "gsk-980mdi"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
HNC, TE = "hnc-21m", "gsk-928te"
KNOWN = {"source": "general knowledge", "evidence": "inferred"}

# ---- M codes ----
case(
    "HNC: T1 M06 M03 S500 changes the tool and turns the spindle",
    control=HNC, source="source 003, T1M06 M03 S500",
    program="%1\nN10 T1M06 M03 S500\nN20 M30",
    runs="N10 N20", m=[6, 3], t=[1], dropped=[],
)
case(
    "HNC: of three M codes the last two count",
    pins="m_codes_per_block extra_m_codes",
    control=HNC, source="source 003 shows two; general knowledge", evidence="inferred",
    program="%1\nN10 M8 M6 M3\nN20 M30",
    runs="N10 N20", m=[6, 3], dropped=["M8"],
)
case(
    "two M codes in a block alarm on the 988 while 3404#7 is 0",
    pins="extra_m_codes",
    control=GSK_988, source="Talm 012: see 3404#7", evidence="secondary",
    program="O1\nN10 M8\nN20 M3 M9\nN30 M30",
    runs="N10", m=[8], alarm="illegal-m-combination", number="012", at="O1 N20", word="M9",
)
case(
    "with 3404#7 the 988 takes three M codes",
    control=GSK_988, source="Talm 012; TApar 3404#7", evidence="secondary", params={"3404#7": 1},
    program="O1\nN10 M8 M3 M9\nN30 M30",
    runs="N10 N30", m=[8, 3, 9], dropped=[],
)
case(
    "with 3404#7 four M codes alarm on the 988",
    control=GSK_988, source="Talm 012; TApar 3404#7", evidence="secondary", params={"3404#7": 1},
    program="O1\nN10 M8 M3 M9 M7\nN30 M30",
    runs="", m=[], alarm="illegal-m-combination", number="012", at="O1 N10", word="M7",
)
case(
    "with 3404#7 of four M codes a FANUC drops the first",
    control=FANUC, source="general knowledge, 3404#7", evidence="inferred", params={"3404#7": 1},
    program="O1\nN10 M8 M3 M9 M7\nN30 M30",
    runs="N10 N30", m=[3, 9, 7], dropped=["M8"],
)
case(
    "what is dropped is told each time the block runs",
    control=[*FANUC, *GSK_980], **KNOWN,
    program="O1\nN10 M98 P30002\nN20 M30\nO2\nN30 M6 M3\nN40 M99",
    m=[3, 3, 3], dropped=["M6", "M6", "M6"],
)
case(
    "a block that alarms has dropped nothing",
    control=[*FANUC], **KNOWN,
    program="O1\nN10 M6 M3 G1 X1.\nN30 M30",
    runs="", m=[], dropped=[], alarm="no-feed",
    number={"fanuc-16i": "011", **dict.fromkeys(FANUC[1:], "PS0011")}, at="O1 N10", word="G1",
)
case(
    "one M code is not dropped, nor is a call beside one",
    control=[*GSK_980, TE, *MITSUBISHI, HNC], **KNOWN,
    program="O1\nN10 M8 S500\nN20 M9\nN30 M30",
    m=[8, 9], dropped=[],
)
case(
    "an M code with a space or zeros in front is dropped as it is written",
    control=FANUC, **KNOWN,
    program="O1\nN10 M006 M3\nN20 M30",
    m=[3], dropped=["M006"],
)

# ---- addresses and G codes ----
_LAST = [*GSK_988, TE, *MITSUBISHI, *FANUC, HNC]

case(
    "of an address written twice the first is dropped",
    control=_LAST, source="TApar 3403#6; general knowledge", evidence="inferred",
    program="O1\nN10 G0 Z1. Z2.\nN20 T1 T2 S5 S6\nN30 M30",
    t=[2], dropped=["Z1.", "T1", "S5"], moves="R Z2",
)
case(
    "an address written twice alarms on the 980 and drops nothing",
    control=GSK_980, source="MDia 010", evidence="secondary",
    program="O1\nN10 G0 Z1. Z2.\nN30 M30",
    runs="", dropped=[], alarm="address-given-twice", number="0010", at="O1 N10", word="Z2.",
)
case(
    "of two G codes of a group the first is dropped",
    control=_LAST, source="TApar 3403#6; general knowledge", evidence="inferred",
    program="O1\nN10 G1 G0 Z1.\nN20 G0 S5\nN30 M30",
    moves="R Z1", dropped=["G01"],
)
case(
    "the same G code twice drops nothing",
    control=_LAST, **KNOWN,
    program="O1\nN10 G0 G00 Z1.\nN30 M30",
    moves="R Z1", dropped=[],
)
case(
    "of two codes that hold for their block alone the first is dropped",
    control=FANUC, **KNOWN,
    program="O1\nN10 G4 G10 L2 P1 X5.\nN30 M30",
    dropped=["G04"],
)
case(
    "beside R of an arc I and J are dropped",
    control=[*MITSUBISHI, *FANUC, HNC], source="source 003, note 3", evidence="secondary",
    program="O1\nN10 G17 G2 X10. Y10. R10. I5. J0. F100\nN30 M30",
    dropped=["I5", "J0"],
)
case(
    "beside X of a lathe U is dropped",
    control=[TDI, *GSK_988], source="TDi 2", evidence="maker's manual",
    program="O1\nN10 G0 X10. U5.\nN30 M30",
    moves="R X10", dropped=["U5"],
)
case(
    "beside P of a dwell X is dropped",
    control=TDI, source="TDi 14: P before X before U", evidence="maker's manual",
    program="O1\nN10 G4 X5. P1000\nN30 M30",
    time=1, dropped=["X5"],
)
case(
    "in MDI what is dropped is told as well",
    control=FANUC, **KNOWN,
    mdi="M8 M3\nM5", m=[3, 5], dropped=["M8"],
)
