"""Measuring of tools: G37 of a mill, G36 and G37 of a lathe, G37.1 of a Mitsubishi."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
T988 = ["gsk-988ta", "gsk-988t"]
MM = {"whole_numbers": "millimetres"}
MILL = {
    "machine": "mill", "start": {"X": 0, "Y": 0, "Z": 100}, "length_offsets": {1: 50, 2: 30},
    "work_offsets": {"G54": {"Z": -400}},
}
LATHE = {
    "machine": "lathe-a", "start": {"X": 300, "Z": 200},
    "tools": {1: {"X": 6, "Z": 20, "R": 0.4, "tip": 3}},
}

# The values: γ 10, ε 5, feed 100; of the Z of a lathe 20 and 8.
OF_6241 = {"6241": 100, "6251": 10, "6254": 5}
OF_6241_LATHE = OF_6241 | {"6252": 20, "6255": 8}
OF_141 = {"141": 100, "142": 10, "143": 20, "144": 5, "145": 8}
OF_5040 = {"5040": 100, "5043": 10, "5044": 5}
OF_8004 = {"8004": 100, "8005": 10, "8006": 5}
KNOWN = "general knowledge; TDi 17, the same rule"
MILLS = ((FANUC, OF_6241, KNOWN), (["gsk-980mdi"], OF_5040, "MDipar 5040 to 5044; TDi 17"))
LATHES = (
    (FANUC, OF_6241_LATHE, KNOWN), (T988, OF_6241_LATHE, "TApar 6241 to 6255; TDi 17"),
    (["gsk-980tdi"], OF_141, "TDi 17, p.95"),
)


def name(controls):
    return "FANUC" if controls == FANUC else controls[0]


case(
    "G37 adds to the length how far off the tool arrives, on a mill of FANUC",
    pins="measuring measured",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="general knowledge; TDi 17, the same rule", evidence="inferred",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5}, setup=MILL,
    inputs={"skips": {"ZAE": [{"Z": 12}, {"Z": 9.5}], 1: [{"Z": 11}]}},
    program="""
        O1
        N10 G90 G43 H1 G0 Z80.
        N20 G37 Z10.
        N30 G43 H1 G0 Z80.
        N40 #100=#5023
        N50 G37 Z10.
        N60 G43 H1 G0 Z80.
        N70 #101=#5023
        N80 M30
    """,
    moves="R Z80\nR Z20\nF Z12\nR Z80\nR Z20\nF Z9.5\nR Z80", vars={100: -268, 101: -268.5},
)
case(
    "G37 from within the near distance goes at the measuring feed alone: FANUC",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="general knowledge; TDi 17, the same rule", evidence="inferred",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5},
    setup=MILL | {"start": {"Z": 15}, "length_offsets": {1: 0, 2: 0}},
    inputs={"skips": [{"Z": 10}]},
    program="O1\nN10 G90 G43 H2 G0 Z15.\nN20 G37 Z10.\nN30 M30",
    moves="R Z15\nF Z10", time=3,
)
case(
    "a tool that arrives at None alarms as measuring-missed and keeps its length: FANUC",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="ALM 080; MDia 3050, 3051", evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5}, setup=MILL, inputs={"skips": [None]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 G37 Z10.\nN30 M30",
    moves="R Z80", alarm="measuring-missed", at="O1 N20", word="G37",
    number={"fanuc-16i": "080", "fanuc-0i-d": "PS0080", "fanuc-0i-f": "PS0080", "fanuc-30i": "PS0080"},
)
case(
    "a tool that arrives at {'Z': 17} alarms as measuring-early and keeps its length: FANUC",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="ALM 080; MDia 3050, 3051", evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5}, setup=MILL,
    inputs={"skips": [{"Z": 17}]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 G37 Z10.\nN30 M30",
    moves="R Z80", alarm="measuring-early", at="O1 N20", word="G37",
    number={"fanuc-16i": "080", "fanuc-0i-d": "PS0080", "fanuc-0i-f": "PS0080", "fanuc-30i": "PS0080"},
)
case(
    "a tool that arrives at {'Z': 4.9} alarms as measuring-missed and keeps its length: FANUC",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="ALM 080; MDia 3050, 3051", evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5}, setup=MILL,
    inputs={"skips": [{"Z": 4.9}]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 G37 Z10.\nN30 M30",
    moves="R Z80", alarm="measuring-missed", at="O1 N20", word="G37",
    number={"fanuc-16i": "080", "fanuc-0i-d": "PS0080", "fanuc-0i-f": "PS0080", "fanuc-30i": "PS0080"},
)
case(
    "G37 H1 Z10.  alarms as measuring-with-offset on a mill of FANUC",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="ALM 081 to 083; MDib 0297 to 0299; MDia 3052", evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5}, setup=MILL, inputs={"skips": [0.5]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 \nN30 G37 H1 Z10.\nN40 M30",
    runs="N10 N20", alarm="measuring-with-offset", at="O1 N30", word="H1",
    number={"fanuc-16i": "082", "fanuc-0i-d": "PS0082", "fanuc-0i-f": "PS0082", "fanuc-30i": "PS0082"},
)
case(
    "G37 Z10. H0 alarms as measuring-without-offset on a mill of FANUC",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="ALM 081 to 083; MDib 0297 to 0299; MDia 3052", evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5}, setup=MILL, inputs={"skips": [0.5]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 H0\nN30 G37 Z10.\nN40 M30",
    runs="N10 N20", alarm="measuring-without-offset", at="O1 N30", word="G37",
    number={"fanuc-16i": "081", "fanuc-0i-d": "PS0081", "fanuc-0i-f": "PS0081", "fanuc-30i": "PS0081"},
)
case(
    "G37  alarms as measuring-axis on a mill of FANUC",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="ALM 081 to 083; MDib 0297 to 0299; MDia 3052", evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5}, setup=MILL, inputs={"skips": [0.5]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 \nN30 G37\nN40 M30",
    runs="N10 N20", alarm="measuring-axis", at="O1 N30", word="G37",
    number={"fanuc-16i": "083", "fanuc-0i-d": "PS0083", "fanuc-0i-f": "PS0083", "fanuc-30i": "PS0083"},
)
case(
    "G37 X1. Z10.  alarms as measuring-axis on a mill of FANUC",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="ALM 081 to 083; MDib 0297 to 0299; MDia 3052", evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5}, setup=MILL, inputs={"skips": [0.5]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 \nN30 G37 X1. Z10.\nN40 M30",
    runs="N10 N20", alarm="measuring-axis", at="O1 N30", word="G37",
    number={"fanuc-16i": "083", "fanuc-0i-d": "PS0083", "fanuc-0i-f": "PS0083", "fanuc-30i": "PS0083"},
)
case(
    "G37 A10.  alarms as measuring-axis on a mill of FANUC",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="ALM 081 to 083; MDib 0297 to 0299; MDia 3052", evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5}, setup=MILL, inputs={"skips": [0.5]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 \nN30 G37 A10.\nN40 M30",
    runs="N10 N20", alarm="measuring-axis", at="O1 N30", word="G37",
    number={"fanuc-16i": "083", "fanuc-0i-d": "PS0083", "fanuc-0i-f": "PS0083", "fanuc-30i": "PS0083"},
)
case(
    "G91 G37 Z-10.  alarms as measuring-incremental on a mill of FANUC",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="ALM 081 to 083; MDib 0297 to 0299; MDia 3052", evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5}, setup=MILL, inputs={"skips": [0.5]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 \nN30 G91 G37 Z-10.\nN40 M30",
    runs="N10 N20", alarm="measuring-incremental", at="O1 N30", word="Z-10.",
    number={"fanuc-16i": "083", "fanuc-0i-d": "PS0083", "fanuc-0i-f": "PS0083", "fanuc-30i": "PS0083"},
)
case(
    "G37 adds to the length how far off the tool arrives, on a mill of gsk-980mdi",
    pins="measuring measured", control=["gsk-980mdi"],
    source="MDipar 5040 to 5044; TDi 17", evidence="secondary",
    params={"5040": 100, "5043": 10, "5044": 5}, setup=MILL,
    inputs={"skips": {"ZAE": [{"Z": 12}, {"Z": 9.5}], 1: [{"Z": 11}]}},
    program="""
        O1
        N10 G90 G43 H1 G0 Z80.
        N20 G37 Z10.
        N30 G43 H1 G0 Z80.
        N40 #100=#5023
        N50 G37 Z10.
        N60 G43 H1 G0 Z80.
        N70 #101=#5023
        N80 M30
    """,
    moves="R Z80\nR Z20\nF Z12\nR Z80\nR Z20\nF Z9.5\nR Z80", vars={100: -268, 101: -268.5},
)
case(
    "G37 from within the near distance goes at the measuring feed alone: gsk-980mdi",
    control=["gsk-980mdi"], source="MDipar 5040 to 5044; TDi 17", evidence="secondary",
    params={"5040": 100, "5043": 10, "5044": 5},
    setup=MILL | {"start": {"Z": 15}, "length_offsets": {1: 0, 2: 0}},
    inputs={"skips": [{"Z": 10}]},
    program="O1\nN10 G90 G43 H2 G0 Z15.\nN20 G37 Z10.\nN30 M30",
    moves="R Z15\nF Z10", time=3,
)
case(
    "a tool that arrives at None alarms as measuring-missed and keeps its length: gsk-980mdi",
    control=["gsk-980mdi"], source="ALM 080; MDia 3050, 3051", evidence="secondary",
    params={"5040": 100, "5043": 10, "5044": 5}, setup=MILL, inputs={"skips": [None]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 G37 Z10.\nN30 M30",
    moves="R Z80", alarm="measuring-missed", at="O1 N20", word="G37", number={"gsk-980mdi": "3050"},
)
case(
    "a tool that arrives at {'Z': 17} alarms as measuring-early and keeps its length: gsk-980mdi",
    control=["gsk-980mdi"], source="ALM 080; MDia 3050, 3051", evidence="secondary",
    params={"5040": 100, "5043": 10, "5044": 5}, setup=MILL, inputs={"skips": [{"Z": 17}]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 G37 Z10.\nN30 M30",
    moves="R Z80", alarm="measuring-early", at="O1 N20", word="G37", number={"gsk-980mdi": "3051"},
)
case(
    "a tool that arrives at {'Z': 4.9} alarms as measuring-missed and keeps its length: gsk-980mdi",
    control=["gsk-980mdi"], source="ALM 080; MDia 3050, 3051", evidence="secondary",
    params={"5040": 100, "5043": 10, "5044": 5}, setup=MILL, inputs={"skips": [{"Z": 4.9}]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 G37 Z10.\nN30 M30",
    moves="R Z80", alarm="measuring-missed", at="O1 N20", word="G37", number={"gsk-980mdi": "3050"},
)
case(
    "G37 H1 Z10.  alarms as measuring-with-offset on a mill of gsk-980mdi",
    control=["gsk-980mdi"], source="ALM 081 to 083; MDib 0297 to 0299; MDia 3052",
    evidence="secondary", params={"5040": 100, "5043": 10, "5044": 5}, setup=MILL,
    inputs={"skips": [0.5]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 \nN30 G37 H1 Z10.\nN40 M30",
    runs="N10 N20", alarm="measuring-with-offset", at="O1 N30", word="H1",
    number={"gsk-980mdi": "0297"},
)
case(
    "G37 Z10. H0 alarms as measuring-without-offset on a mill of gsk-980mdi",
    control=["gsk-980mdi"], source="ALM 081 to 083; MDib 0297 to 0299; MDia 3052",
    evidence="secondary", params={"5040": 100, "5043": 10, "5044": 5}, setup=MILL,
    inputs={"skips": [0.5]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 H0\nN30 G37 Z10.\nN40 M30",
    runs="N10 N20", alarm="measuring-without-offset", at="O1 N30", word="G37",
    number={"gsk-980mdi": "3052"},
)
case(
    "G37  alarms as measuring-axis on a mill of gsk-980mdi",
    control=["gsk-980mdi"], source="ALM 081 to 083; MDib 0297 to 0299; MDia 3052",
    evidence="secondary", params={"5040": 100, "5043": 10, "5044": 5}, setup=MILL,
    inputs={"skips": [0.5]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 \nN30 G37\nN40 M30",
    runs="N10 N20", alarm="measuring-axis", at="O1 N30", word="G37", number={"gsk-980mdi": "0299"},
)
case(
    "G37 X1. Z10.  alarms as measuring-axis on a mill of gsk-980mdi",
    control=["gsk-980mdi"], source="ALM 081 to 083; MDib 0297 to 0299; MDia 3052",
    evidence="secondary", params={"5040": 100, "5043": 10, "5044": 5}, setup=MILL,
    inputs={"skips": [0.5]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 \nN30 G37 X1. Z10.\nN40 M30",
    runs="N10 N20", alarm="measuring-axis", at="O1 N30", word="G37", number={"gsk-980mdi": "0299"},
)
case(
    "G37 A10.  alarms as measuring-axis on a mill of gsk-980mdi",
    control=["gsk-980mdi"], source="ALM 081 to 083; MDib 0297 to 0299; MDia 3052",
    evidence="secondary", params={"5040": 100, "5043": 10, "5044": 5}, setup=MILL,
    inputs={"skips": [0.5]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 \nN30 G37 A10.\nN40 M30",
    runs="N10 N20", alarm="measuring-axis", at="O1 N30", word="G37", number={"gsk-980mdi": "0299"},
)
case(
    "G91 G37 Z-10.  alarms as measuring-incremental on a mill of gsk-980mdi",
    control=["gsk-980mdi"], source="ALM 081 to 083; MDib 0297 to 0299; MDia 3052",
    evidence="secondary", params={"5040": 100, "5043": 10, "5044": 5}, setup=MILL,
    inputs={"skips": [0.5]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 \nN30 G91 G37 Z-10.\nN40 M30",
    runs="N10 N20", alarm="measuring-incremental", at="O1 N30", word="Z-10.",
    number={"gsk-980mdi": "0298"},
)
case(
    "G37 measures along X and Y of a FANUC mill too",
    control=FANUC, source=KNOWN, evidence="inferred", replace=MM, params=OF_6241, setup=MILL,
    inputs={"skips": {"XAE": [{"X": 41}], "YAE": [{"Y": -29}], "ZAE": [{"Z": 12}]}},
    program="""
        O1
        N10 G90 G43 H1 G0 Z80.
        N20 G37 X40.
        N30 G37 Y-30.
        N40 G43 H1 Z80.
        N50 #100=#5023
        N60 M30
    """,
    moves="R Z80\nR X30\nF X41\nR Y-20\nF Y-29\nR Z80", vars={100: 80 + 52 - 400},
)
case(
    "G37 of the 980MDi measures along Z in G17 alone",
    control="gsk-980mdi", source="MDib 0299", evidence="maker's manual", params=OF_5040, setup=MILL,
    inputs={"skips": [0.5]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 G18\nN30 G37 Z10.\nN40 M30\n",
    runs="N10 N20", alarm="measuring-axis", number="0299", at="O1 N30", word="G37",
)
case(
    "G37 X of the 980MDi is a wrong axis",
    control="gsk-980mdi", source="MDib 0299", evidence="maker's manual", params=OF_5040, setup=MILL,
    inputs={"skips": [0.5]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 G37 X10.\nN30 M30\n",
    runs="N10", alarm="measuring-axis", number="0299", at="O1 N20", word="G37",
)
case(
    "a measuring feed that begins at the zone is 0282 on the 980MDi",
    control="gsk-980mdi", source="MDib 0282: not above", evidence="maker's manual",
    params=OF_5040 | {"5044": 10}, setup=MILL, inputs={"skips": [0.5]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 G37 Z10.\nN30 M30\n",
    runs="N10", alarm="measuring-zone", number="0282", at="O1 N20", word="G37",
)
case(
    "a measuring feed that begins inside the zone is 054 on the 988",
    control=T988, source="Talm 054: below", evidence="secondary",
    replace=MM, params=OF_6241_LATHE | {"6252": 7.9}, setup=LATHE, inputs={"skips": [0.5]},
    program="O1\nN10 T0101 G0 X220. Z150.\nN20 G37 Z100.\nN30 M30\n",
    runs="N10", alarm="measuring-zone", number="054", at="O1 N20", word="G37",
)
case(
    "a measuring feed that begins at the zone or inside it measures elsewhere",
    control=[*FANUC, *T988], source="Talm 054: below alone; general knowledge", evidence="secondary",
    replace=MM, params=OF_6241_LATHE | {"6252": 8}, setup=LATHE, inputs={"skips": [{"Z": 101}]},
    program="O1\nN10 T0101 G0 X220. Z150.\nN20 G37 Z100.\nN30 M30\n",
    moves="R X220 Z150\nR Z108\nF Z101",
)
case(
    "no measuring feed is set as delivered",
    control=FANUC, source="policy, parameters as delivered", evidence="inferred",
    replace=MM, setup=MILL, inputs={"skips": [0.5]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 G37 Z10.\nN30 M30\n",
    runs="N10", alarm="no-measuring-feed", number=None, at="O1 N20", word="G37",
)

# Lathes
case(
    "G36 measures X and G37 Z of a tool, on a lathe of FANUC",
    pins="measuring measured",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="general knowledge; TDi 17, the same rule", evidence="inferred",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5, "6252": 20, "6255": 8}, setup=LATHE,
    inputs={"skips": {"XAE": [{"X": 201.5}], "ZAE": [{"Z": 94}]}},
    program="""
        O1
        N10 T0101
        N20 G0 X220. Z130.
        N30 G36 X200.
        N40 T0101
        N50 G0 X204.
        N60 #100=#5021
        N70 G37 Z100.
        N80 T0101
        N90 G0 Z110.
        N100 #101=#5022
        N110 M30
    """,
    moves="R X220 Z130\nR X210\nF X201.5\nR X204\nR Z120\nF Z94\nR Z110",
    vars={100: 211.5, 101: 124},
)
case(
    "G36 X200., told {'X': 208}, alarms as measuring-early on a lathe of FANUC",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="ALM 080 to 083; Talm 051 to 054; TDi 17", evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5, "6252": 20, "6255": 8}, setup=LATHE,
    inputs={"skips": [{"X": 208}]},
    program="O1\nN10 T0101\nN20 G0 X220. Z130.\nN30 G36 X200.\nN40 M30",
    runs="N10 N20", alarm="measuring-early", at="O1 N30", word="G36",
    number={"fanuc-16i": "080", "fanuc-0i-d": "PS0080", "fanuc-0i-f": "PS0080", "fanuc-30i": "PS0080"},
)
case(
    "G36 X200., told None, alarms as measuring-missed on a lathe of FANUC",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="ALM 080 to 083; Talm 051 to 054; TDi 17", evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5, "6252": 20, "6255": 8}, setup=LATHE,
    inputs={"skips": [None]},
    program="O1\nN10 T0101\nN20 G0 X220. Z130.\nN30 G36 X200.\nN40 M30",
    runs="N10 N20", alarm="measuring-missed", at="O1 N30", word="G36",
    number={"fanuc-16i": "080", "fanuc-0i-d": "PS0080", "fanuc-0i-f": "PS0080", "fanuc-30i": "PS0080"},
)
case(
    "G37 Z100. T0101, told 0.5, alarms as measuring-with-offset on a lathe of FANUC",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="ALM 080 to 083; Talm 051 to 054; TDi 17", evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5, "6252": 20, "6255": 8}, setup=LATHE,
    inputs={"skips": [0.5]},
    program="O1\nN10 T0101\nN20 G0 X220. Z130.\nN30 G37 Z100. T0101\nN40 M30",
    runs="N10 N20", alarm="measuring-with-offset", at="O1 N30", word="T0101",
    number={"fanuc-16i": "082", "fanuc-0i-d": "PS0082", "fanuc-0i-f": "PS0082", "fanuc-30i": "PS0082"},
)
case(
    "G36 Z100., told 0.5, alarms as measuring-axis on a lathe of FANUC",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="ALM 080 to 083; Talm 051 to 054; TDi 17", evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5, "6252": 20, "6255": 8}, setup=LATHE,
    inputs={"skips": [0.5]},
    program="O1\nN10 T0101\nN20 G0 X220. Z130.\nN30 G36 Z100.\nN40 M30",
    runs="N10 N20", alarm="measuring-axis", at="O1 N30", word="G36",
    number={"fanuc-16i": "083", "fanuc-0i-d": "PS0083", "fanuc-0i-f": "PS0083", "fanuc-30i": "PS0083"},
)
case(
    "G37 X100., told 0.5, alarms as measuring-axis on a lathe of FANUC",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="ALM 080 to 083; Talm 051 to 054; TDi 17", evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5, "6252": 20, "6255": 8}, setup=LATHE,
    inputs={"skips": [0.5]},
    program="O1\nN10 T0101\nN20 G0 X220. Z130.\nN30 G37 X100.\nN40 M30",
    runs="N10 N20", alarm="measuring-axis", at="O1 N30", word="G37",
    number={"fanuc-16i": "083", "fanuc-0i-d": "PS0083", "fanuc-0i-f": "PS0083", "fanuc-30i": "PS0083"},
)
case(
    "G37 W-10., told 0.5, alarms as measuring-incremental on a lathe of FANUC",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="ALM 080 to 083; Talm 051 to 054; TDi 17", evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5, "6252": 20, "6255": 8}, setup=LATHE,
    inputs={"skips": [0.5]},
    program="O1\nN10 T0101\nN20 G0 X220. Z130.\nN30 G37 W-10.\nN40 M30",
    runs="N10 N20", alarm="measuring-incremental", at="O1 N30", word="W-10.",
    number={"fanuc-16i": "083", "fanuc-0i-d": "PS0083", "fanuc-0i-f": "PS0083", "fanuc-30i": "PS0083"},
)
case(
    "G36 U-10., told 0.5, alarms as measuring-incremental on a lathe of FANUC",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="ALM 080 to 083; Talm 051 to 054; TDi 17", evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5, "6252": 20, "6255": 8}, setup=LATHE,
    inputs={"skips": [0.5]},
    program="O1\nN10 T0101\nN20 G0 X220. Z130.\nN30 G36 U-10.\nN40 M30",
    runs="N10 N20", alarm="measuring-incremental", at="O1 N30", word="U-10.",
    number={"fanuc-16i": "083", "fanuc-0i-d": "PS0083", "fanuc-0i-f": "PS0083", "fanuc-30i": "PS0083"},
)
case(
    "a tool is measured with its offset number in force alone, on a lathe of FANUC",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"],
    source="ALM 081; Talm 052; TDi 17", evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5, "6252": 20, "6255": 8}, setup=LATHE,
    inputs={"skips": [0.5]},
    program="O1\nN10 T0100\nN20 G0 X220. Z130.\nN30 G36 X200.\nN40 M30\n",
    runs="N10 N20", alarm="measuring-without-offset", at="O1 N30", word="G36",
    number={"fanuc-16i": "081", "fanuc-0i-d": "PS0081", "fanuc-0i-f": "PS0081", "fanuc-30i": "PS0081"},
)
case(
    "no tool is measured in radius compensation, on a lathe of FANUC",
    control=["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"], source="Talm 056; TDi 17",
    evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5, "6252": 20, "6255": 8}, setup=LATHE,
    inputs={"skips": [0.5]},
    program="O1\nN10 T0101\nN20 G98 G42 G1 X220. Z130. F100\nN30 G36 X200.\nN40 M30\n",
    runs="N10 N20", alarm="measuring-in-offset", at="O1 N30", word="G36",
    number={"fanuc-16i": None, "fanuc-0i-d": None, "fanuc-0i-f": None, "fanuc-30i": None},
)
case(
    "G36 measures X and G37 Z of a tool, on a lathe of gsk-988ta",
    pins="measuring measured", control=["gsk-988ta", "gsk-988t"],
    source="TApar 6241 to 6255; TDi 17", evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5, "6252": 20, "6255": 8}, setup=LATHE,
    inputs={"skips": {"XAE": [{"X": 201.5}], "ZAE": [{"Z": 94}]}},
    program="""
        O1
        N10 T0101
        N20 G0 X220. Z130.
        N30 G36 X200.
        N40 T0101
        N50 G0 X204.
        N60 #100=#5021
        N70 G37 Z100.
        N80 T0101
        N90 G0 Z110.
        N100 #101=#5022
        N110 M30
    """,
    moves="R X220 Z130\nR X210\nF X201.5\nR X204\nR Z120\nF Z94\nR Z110",
    vars={100: 211.5, 101: 124},
)
case(
    "G36 X200., told {'X': 208}, alarms as measuring-early on a lathe of gsk-988ta",
    control=["gsk-988ta", "gsk-988t"], source="ALM 080 to 083; Talm 051 to 054; TDi 17",
    evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5, "6252": 20, "6255": 8}, setup=LATHE,
    inputs={"skips": [{"X": 208}]},
    program="O1\nN10 T0101\nN20 G0 X220. Z130.\nN30 G36 X200.\nN40 M30",
    runs="N10 N20", alarm="measuring-early", at="O1 N30", word="G36",
    number={"gsk-988ta": "051", "gsk-988t": "051"},
)
case(
    "G36 X200., told None, alarms as measuring-missed on a lathe of gsk-988ta",
    control=["gsk-988ta", "gsk-988t"], source="ALM 080 to 083; Talm 051 to 054; TDi 17",
    evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5, "6252": 20, "6255": 8}, setup=LATHE,
    inputs={"skips": [None]},
    program="O1\nN10 T0101\nN20 G0 X220. Z130.\nN30 G36 X200.\nN40 M30",
    runs="N10 N20", alarm="measuring-missed", at="O1 N30", word="G36",
    number={"gsk-988ta": "051", "gsk-988t": "051"},
)
case(
    "G37 Z100. T0101, told 0.5, alarms as measuring-with-offset on a lathe of gsk-988ta",
    control=["gsk-988ta", "gsk-988t"], source="ALM 080 to 083; Talm 051 to 054; TDi 17",
    evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5, "6252": 20, "6255": 8}, setup=LATHE,
    inputs={"skips": [0.5]},
    program="O1\nN10 T0101\nN20 G0 X220. Z130.\nN30 G37 Z100. T0101\nN40 M30",
    runs="N10 N20", alarm="measuring-with-offset", at="O1 N30", word="T0101",
    number={"gsk-988ta": "053", "gsk-988t": "053"},
)
case(
    "G36 Z100., told 0.5, alarms as measuring-axis on a lathe of gsk-988ta",
    control=["gsk-988ta", "gsk-988t"], source="ALM 080 to 083; Talm 051 to 054; TDi 17",
    evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5, "6252": 20, "6255": 8}, setup=LATHE,
    inputs={"skips": [0.5]},
    program="O1\nN10 T0101\nN20 G0 X220. Z130.\nN30 G36 Z100.\nN40 M30",
    runs="N10 N20", alarm="measuring-axis", at="O1 N30", word="G36",
    number={"gsk-988ta": "054", "gsk-988t": "054"},
)
case(
    "G37 X100., told 0.5, alarms as measuring-axis on a lathe of gsk-988ta",
    control=["gsk-988ta", "gsk-988t"], source="ALM 080 to 083; Talm 051 to 054; TDi 17",
    evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5, "6252": 20, "6255": 8}, setup=LATHE,
    inputs={"skips": [0.5]},
    program="O1\nN10 T0101\nN20 G0 X220. Z130.\nN30 G37 X100.\nN40 M30",
    runs="N10 N20", alarm="measuring-axis", at="O1 N30", word="G37",
    number={"gsk-988ta": "054", "gsk-988t": "054"},
)
case(
    "G37 W-10., told 0.5, alarms as measuring-incremental on a lathe of gsk-988ta",
    control=["gsk-988ta", "gsk-988t"], source="ALM 080 to 083; Talm 051 to 054; TDi 17",
    evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5, "6252": 20, "6255": 8}, setup=LATHE,
    inputs={"skips": [0.5]},
    program="O1\nN10 T0101\nN20 G0 X220. Z130.\nN30 G37 W-10.\nN40 M30",
    runs="N10 N20", alarm="measuring-incremental", at="O1 N30", word="W-10.",
    number={"gsk-988ta": "054", "gsk-988t": "054"},
)
case(
    "G36 U-10., told 0.5, alarms as measuring-incremental on a lathe of gsk-988ta",
    control=["gsk-988ta", "gsk-988t"], source="ALM 080 to 083; Talm 051 to 054; TDi 17",
    evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5, "6252": 20, "6255": 8}, setup=LATHE,
    inputs={"skips": [0.5]},
    program="O1\nN10 T0101\nN20 G0 X220. Z130.\nN30 G36 U-10.\nN40 M30",
    runs="N10 N20", alarm="measuring-incremental", at="O1 N30", word="U-10.",
    number={"gsk-988ta": "054", "gsk-988t": "054"},
)
case(
    "a tool is measured with its offset number in force alone, on a lathe of gsk-988ta",
    control=["gsk-988ta", "gsk-988t"], source="ALM 081; Talm 052; TDi 17", evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5, "6252": 20, "6255": 8}, setup=LATHE,
    inputs={"skips": [0.5]},
    program="O1\nN10 T0100\nN20 G0 X220. Z130.\nN30 G36 X200.\nN40 M30\n",
    runs="N10 N20", alarm="measuring-without-offset", at="O1 N30", word="G36",
    number={"gsk-988ta": "052", "gsk-988t": "052"},
)
case(
    "no tool is measured in radius compensation, on a lathe of gsk-988ta",
    control=["gsk-988ta", "gsk-988t"], source="Talm 056; TDi 17", evidence="secondary",
    replace=MM, params={"6241": 100, "6251": 10, "6254": 5, "6252": 20, "6255": 8}, setup=LATHE,
    inputs={"skips": [0.5]},
    program="O1\nN10 T0101\nN20 G98 G42 G1 X220. Z130. F100\nN30 G36 X200.\nN40 M30\n",
    runs="N10 N20", alarm="measuring-in-offset", at="O1 N30", word="G36",
    number={"gsk-988ta": "056", "gsk-988t": "056"},
)
case(
    "G36 measures X and G37 Z of a tool, on a lathe of gsk-980tdi",
    pins="measuring measured", control=["gsk-980tdi"], source="TDi 17, p.95",
    evidence="maker's manual", params={"141": 100, "142": 10, "143": 20, "144": 5, "145": 8},
    setup=LATHE, inputs={"skips": {"XAE": [{"X": 201.5}], "ZAE": [{"Z": 94}]}},
    program="""
        O1
        N10 T0101
        N20 G0 X220. Z130.
        N30 G36 X200.
        N40 T0101
        N50 G0 X204.
        N60 #100=#5021
        N70 G37 Z100.
        N80 T0101
        N90 G0 Z110.
        N100 #101=#5022
        N110 M30
    """,
    moves="R X220 Z130\nR X210\nF X201.5\nR X204\nR Z120\nF Z94\nR Z110",
    vars={100: 211.5, 101: 124},
)
case(
    "G36 X200., told {'X': 208}, alarms as measuring-early on a lathe of gsk-980tdi",
    control=["gsk-980tdi"], source="ALM 080 to 083; Talm 051 to 054; TDi 17", evidence="secondary",
    params={"141": 100, "142": 10, "143": 20, "144": 5, "145": 8}, setup=LATHE,
    inputs={"skips": [{"X": 208}]},
    program="O1\nN10 T0101\nN20 G0 X220. Z130.\nN30 G36 X200.\nN40 M30",
    runs="N10 N20", alarm="measuring-early", at="O1 N30", word="G36", number={"gsk-980tdi": None},
)
case(
    "G36 X200., told None, alarms as measuring-missed on a lathe of gsk-980tdi",
    control=["gsk-980tdi"], source="ALM 080 to 083; Talm 051 to 054; TDi 17", evidence="secondary",
    params={"141": 100, "142": 10, "143": 20, "144": 5, "145": 8}, setup=LATHE,
    inputs={"skips": [None]},
    program="O1\nN10 T0101\nN20 G0 X220. Z130.\nN30 G36 X200.\nN40 M30",
    runs="N10 N20", alarm="measuring-missed", at="O1 N30", word="G36", number={"gsk-980tdi": None},
)
case(
    "G37 Z100. T0101, told 0.5, alarms as measuring-with-offset on a lathe of gsk-980tdi",
    control=["gsk-980tdi"], source="ALM 080 to 083; Talm 051 to 054; TDi 17", evidence="secondary",
    params={"141": 100, "142": 10, "143": 20, "144": 5, "145": 8}, setup=LATHE,
    inputs={"skips": [0.5]},
    program="O1\nN10 T0101\nN20 G0 X220. Z130.\nN30 G37 Z100. T0101\nN40 M30",
    runs="N10 N20", alarm="measuring-with-offset", at="O1 N30", word="T0101",
    number={"gsk-980tdi": None},
)
case(
    "G36 Z100., told 0.5, alarms as measuring-axis on a lathe of gsk-980tdi",
    control=["gsk-980tdi"], source="ALM 080 to 083; Talm 051 to 054; TDi 17", evidence="secondary",
    params={"141": 100, "142": 10, "143": 20, "144": 5, "145": 8}, setup=LATHE,
    inputs={"skips": [0.5]},
    program="O1\nN10 T0101\nN20 G0 X220. Z130.\nN30 G36 Z100.\nN40 M30",
    runs="N10 N20", alarm="measuring-axis", at="O1 N30", word="G36", number={"gsk-980tdi": None},
)
case(
    "G37 X100., told 0.5, alarms as measuring-axis on a lathe of gsk-980tdi",
    control=["gsk-980tdi"], source="ALM 080 to 083; Talm 051 to 054; TDi 17", evidence="secondary",
    params={"141": 100, "142": 10, "143": 20, "144": 5, "145": 8}, setup=LATHE,
    inputs={"skips": [0.5]},
    program="O1\nN10 T0101\nN20 G0 X220. Z130.\nN30 G37 X100.\nN40 M30",
    runs="N10 N20", alarm="measuring-axis", at="O1 N30", word="G37", number={"gsk-980tdi": None},
)
case(
    "G37 W-10., told 0.5, alarms as measuring-incremental on a lathe of gsk-980tdi",
    control=["gsk-980tdi"], source="ALM 080 to 083; Talm 051 to 054; TDi 17", evidence="secondary",
    params={"141": 100, "142": 10, "143": 20, "144": 5, "145": 8}, setup=LATHE,
    inputs={"skips": [0.5]},
    program="O1\nN10 T0101\nN20 G0 X220. Z130.\nN30 G37 W-10.\nN40 M30",
    runs="N10 N20", alarm="measuring-incremental", at="O1 N30", word="W-10.",
    number={"gsk-980tdi": None},
)
case(
    "G36 U-10., told 0.5, alarms as measuring-incremental on a lathe of gsk-980tdi",
    control=["gsk-980tdi"], source="ALM 080 to 083; Talm 051 to 054; TDi 17", evidence="secondary",
    params={"141": 100, "142": 10, "143": 20, "144": 5, "145": 8}, setup=LATHE,
    inputs={"skips": [0.5]},
    program="O1\nN10 T0101\nN20 G0 X220. Z130.\nN30 G36 U-10.\nN40 M30",
    runs="N10 N20", alarm="measuring-incremental", at="O1 N30", word="U-10.",
    number={"gsk-980tdi": None},
)
case(
    "a tool is measured with its offset number in force alone, on a lathe of gsk-980tdi",
    control=["gsk-980tdi"], source="ALM 081; Talm 052; TDi 17", evidence="secondary",
    params={"141": 100, "142": 10, "143": 20, "144": 5, "145": 8}, setup=LATHE,
    inputs={"skips": [0.5]},
    program="O1\nN10 T0100\nN20 G0 X220. Z130.\nN30 G36 X200.\nN40 M30\n",
    runs="N10 N20", alarm="measuring-without-offset", at="O1 N30", word="G36",
    number={"gsk-980tdi": None},
)
case(
    "no tool is measured in radius compensation, on a lathe of gsk-980tdi",
    control=["gsk-980tdi"], source="Talm 056; TDi 17", evidence="secondary",
    params={"141": 100, "142": 10, "143": 20, "144": 5, "145": 8}, setup=LATHE,
    inputs={"skips": [0.5]},
    program="O1\nN10 T0101\nN20 G98 G42 G1 X220. Z130. F100\nN30 G36 X200.\nN40 M30\n",
    runs="N10 N20", alarm="measuring-in-offset", at="O1 N30", word="G36",
    number={"gsk-980tdi": None},
)
case(
    "6210#6 subtracts what was measured",
    control=[*FANUC, *T988], source="TApar 6210#6", evidence="secondary",
    replace=MM, params=OF_6241_LATHE | {"6210#6": 1}, setup=LATHE, inputs={"skips": [{"X": 201.5}]},
    program="O1\nN10 T0101 G0 X220. Z130.\nN20 G36 X200.\nN30 T0101\nN40 G0 X204.\nN50 #100=#5021\nN60 M30\n",
    vars={100: 204 + 4.5},
)
case(
    "the 980TDi holds the measuring feed down to 200 mm a minute",
    control="gsk-980tdi", source="TDi 17, p.96", evidence="maker's manual",
    params=OF_141 | {"141": 800, "143": 40}, setup={"start": {"X": 0, "Z": 120}},
    inputs={"skips": [{"Z": 100}]},
    program="O1\nN10 T0101\nN20 G0 Z120.\nN30 G37 Z100.\nN40 M30\n",
    moves="R Z120\nF Z100", time=6,
)

# Mitsubishi
case(
    "G37.1 measures from R before the point, within D of it, at F; the length counts at once",
    pins="measuring measured",
    control=MITSUBISHI, source="M7 p.555", evidence="secondary", replace=MM, params=OF_8004,
    setup=MILL, inputs={"skips": {1: [{"Z": 12}, {"Z": 8}], "ZAE": [{"Z": 10}]}},
    program="""
        O1
        N10 G90 G43 H1 G0 Z80.
        N20 G37.1 Z10. R30. D3. F60
        N30 G0 Z80.
        N40 #100=#5023
        N50 G37.1 Z10.
        N60 G0 Z80.
        N70 #101=#5023
        N80 #102=#4107
        N90 M30
    """,
    moves="R Z80\nR Z40\nF Z12\nR Z80\nR Z20\nF Z8\nR Z80",
    vars={100: 80 + 52 - 400, 101: 80 + 50 - 400, 102: 0},
)
case(
    "G37.1 Z10. D1. F60, told {'Z': 12}, alarms as measuring-early",
    control=MITSUBISHI, source="general knowledge, P604 to P607", evidence="inferred",
    replace=MM, params=OF_8004, setup=MILL, inputs={"skips": [{"Z": 12}]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 G37.1 Z10. D1. F60\nN30 M30\n",
    alarm="measuring-early", number="P607", at="O1 N20", word="G37.1",
)
case(
    "G37.1 Z10. D1. F60, told {'Z': 8}, alarms as measuring-missed",
    control=MITSUBISHI, source="general knowledge, P604 to P607", evidence="inferred",
    replace=MM, params=OF_8004, setup=MILL, inputs={"skips": [{"Z": 8}]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 G37.1 Z10. D1. F60\nN30 M30\n",
    alarm="measuring-missed", number="P607", at="O1 N20", word="G37.1",
)
case(
    "G37.1 Z10. H1, told 0.5, alarms as measuring-with-offset",
    control=MITSUBISHI, source="general knowledge, P604 to P607", evidence="inferred",
    replace=MM, params=OF_8004, setup=MILL, inputs={"skips": [0.5]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 G37.1 Z10. H1\nN30 M30\n",
    alarm="measuring-with-offset", number="P605", at="O1 N20", word="H1",
)
case(
    "G37.1 X10. Z10., told 0.5, alarms as measuring-axis",
    control=MITSUBISHI, source="general knowledge, P604 to P607", evidence="inferred",
    replace=MM, params=OF_8004, setup=MILL, inputs={"skips": [0.5]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 G37.1 X10. Z10.\nN30 M30\n",
    alarm="measuring-axis", number="P604", at="O1 N20", word="G37.1",
)
case(
    "N25 G37.1 Z10., told 0.5, alarms as measuring-without-offset",
    control=MITSUBISHI, source="general knowledge, P604 to P607", evidence="inferred",
    replace=MM, params=OF_8004, setup=MILL, inputs={"skips": [0.5]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 G49 H0\nN25 G37.1 Z10.\nN30 M30\n",
    alarm="measuring-without-offset", number="P606", at="O1 N25", word="G37.1",
)
case(
    "the moves of G36 of a Mitsubishi are not computed",
    control=MITSUBISHI, source="general knowledge: patterns of a mill, measuring of a lathe",
    evidence="inferred", setup=MILL,
    program="O1\nN10 G0 Z80.\nN20 G36 Z10.\nN30 M30\n",
    runs="N10", alarm="code-not-computed", number=None, at="O1 N20",
)
case(
    "the moves of G37 of a Mitsubishi are not computed",
    control=MITSUBISHI, source="general knowledge: patterns of a mill, measuring of a lathe",
    evidence="inferred", setup=MILL,
    program="O1\nN10 G0 Z80.\nN20 G37 Z10.\nN30 M30\n",
    runs="N10", alarm="code-not-computed", number=None, at="O1 N20",
)
case(
    "G31 in feed per revolution is 058 on the 988",
    control=T988, source="Talm 058", evidence="secondary", setup=LATHE, inputs={"skips": [0.5]},
    program="O1\nN10 G98 G31 X200. F100\nN20 G99 G31 X100. F0.1\nN30 M30\n",
    runs="N10", alarm="skip-per-revolution", number="058", at="O1 N20", word="G31",
)
