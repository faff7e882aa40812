"""Small print of calls: names, and corners in blocks that call."""

from conformance import case

case(
    "a program is found by its name in small letters",
    control=["fanuc-0i-f", "fanuc-30i"], source="policy", evidence="inferred",
    program="""
        O1
        N10 M98 <sub>
        N20 M30
        <SUB>
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "a chamfer beside a call is no device",
    control=["mitsubishi-m700", "mitsubishi-m800"], source="policy", evidence="inferred",
    external={"O9.NC": "O9\nN90 M99\n"},
    program="""
        O1
        N10 G1 X10. F100. ,C1. M98 P2
        N20 M30
        O2
        N30 Y10.
        N40 M99
    """,
    runs="N10 N30 N40 N20", calls="M98:O2",
    moves="""
        F X9
        F X10 Y1
        F Y10
    """,
)
case(
    "zeros in front do not make a program's number longer",
    pins="max_words program_word",
    control=["fanuc-0i-f", "gsk-988ta"], source="general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O0000000000000000000002
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "P[...] of a dwell is an expression, no name",
    pins="max_words g_codes statements dwell_words dwell_unit",
    control=["gsk-988ta", "gsk-988t", "gsk-980tdi"], source="TDi29; policy", evidence="inferred",
    program="""
        O1
        N10 G04 P[500+1000]
        N20 M30
    """,
    runs="N10 N20", moves="W 1.5",
)
case(
    "zeros in front of P count as a repeat count beside L",
    pins="program_word count_and_l",
    control=["gsk-988ta", "gsk-988t"], source="source 000, words L and Q (3); policy", evidence="inferred",
    program="""
        O1
        N10 M98 P00001006 L2
        N20 M30
        O1006
        N30 M99
    """,
    runs="", alarm="repeat-given-twice", number={"gsk-988ta": "293", "gsk-988t": None}, at="O1 N10", word="L2",
)
case(
    "beside L all of P is the number, its zeros too",
    pins="program_word",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"], source="general knowledge, P beside L", evidence="inferred",
    program="""
        O1
        N10 M98 P00001006 L2
        N20 M30
        O1006
        N30 M99
    """,
    runs="N10 N30*2 N20",
)
case(
    "a sequence number has no point",
    control=["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"], source="ALM PS0007; policy", evidence="inferred",
    program="O1\nN10 T1\nN20.5 G0 X1.\nN30 M30\n",
    runs="N10", alarm="illegal-decimal-point", number="PS0007", at="O1", word="N20.5",
)
case(
    "M97 without P says not where to jump",
    control="gsk-928te", source="source 001; policy", evidence="inferred",
    program="""
        %1
        N10 T1
        N20 M97
        N30 M30
    """,
    runs="N10", alarm="program-number-missing", at="%1 N20", word="M97",
)
case(
    "P is no argument where a code calls the macro",
    control=["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"], source="ALM PS0129; policy", evidence="inferred",
    params={"6050": 70},
    program="""
        O1
        N10 T1
        N20 G70 P5
        N30 M30
        O9010
        N40 M99
    """,
    runs="N10", alarm="illegal-argument", number="PS0129", at="O1 N20", word="P5",
)
case(
    "of O and % lines that stand together only the % line heads a program",
    control="hnc-21m", source="general knowledge, names of files", evidence="inferred",
    program="""
        O7
        %1
        N10 M98 P7
        N20 M30
    """,
    runs="", alarm="program-not-found", at="%1 N10",
)
case(
    "a program that is not there is told with its name",
    control=["fanuc-0i-f", "fanuc-30i"], source="policy", evidence="inferred",
    program="O1\nN10 T1\nN20 M98 <SUB>\nN30 M30\n",
    runs="N10", alarm="named-program-not-found", number="PS0310", at="O1 N20", word="<SUB>",
)
case(
    "G0.1 is not G01",
    control=["fanuc-30i", "mitsubishi-m700"], source="ALM; SK; general knowledge",
    evidence="inferred", setup={"machine": "mill"},
    program="O1\nN10 T1\nN20 G0.1 X5. F100.\nN30 M30\n",
    runs="N10", alarm="g-code-not-available", at="O1 N20",
    number={"fanuc-30i": "PS0010", "mitsubishi-m700": "P34"},
)
case(
    "G-1 is not G01",
    control=["fanuc-30i", "mitsubishi-m700"], source="ALM; SK; general knowledge",
    evidence="inferred", setup={"machine": "mill"},
    program="O1\nN10 T1\nN20 G-1 X5. F100.\nN30 M30\n",
    runs="N10", alarm="illegal-minus-sign", at="O1 N20", word="G-1",
    number={"fanuc-30i": "PS0006", "mitsubishi-m700": "P35"},
)
case(
    "a call may start at N0",
    pins="refuses:program-number-zero start_word",
    control="gsk-988ta", source="source 000, words L and Q; policy", evidence="inferred",
    program="""
        O1
        N10 M98 P2 Q0
        N20 M30
        O2
        N30 T1
        N0 T2
        N40 M99
    """,
    runs="N10 N0 N40 N20", t=[2],
)
case(
    "an end that is missing is missed after the last block",
    pins="missing_end",
    control=["fanuc-30i", "gsk-988ta"], source="policy", evidence="inferred",
    program="O1\nN10 T1\nN20 T2\n",
    runs="N10 N20", alarm="end-of-record", at="O1", word="",
    number={"fanuc-30i": "PS5010", "gsk-988ta": "019"},
)
