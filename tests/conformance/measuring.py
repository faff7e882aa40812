"""Measuring of tools: G37 of a mill, G36 and G37 of a lathe, G37.1 of a Mitsubishi."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
T988 = ["gsk-988ta", "gsk-988t"]
MM = {"3401#0": 1}
MILL = {
    "machine": "mill", "start": {"X": 0, "Y": 0, "Z": 100}, "length_offsets": {1: 50, 2: 30},
    "work_offsets": {"G54": {"Z": -400}},
}
LATHE = {
    "machine": "lathe-a", "start": {"X": 300, "Z": 200},
    "tools": {1: {"X": 6, "Z": 20, "R": 0.4, "tip": 3}},
}
# γ 10, ε 5, feed 100; of a lathe's Z 20 and 8.
OF_6241 = MM | {"6241": 100, "6251": 10, "6254": 5}
OF_6241_LATHE = OF_6241 | {"6252": 20, "6255": 8}
OF_141 = {"141": 100, "142": 10, "143": 20, "144": 5, "145": 8}
OF_5040 = {"5040": 100, "5043": 10, "5044": 5}
OF_8004 = MM | {"8004": 100, "8005": 10, "8006": 5}

KNOWN = "general knowledge; TDi 17, the same rule"
MILLS = ((FANUC, OF_6241, KNOWN), (["gsk-980mdi"], OF_5040, "MDipar 5040 to 5044; TDi 17"))
LATHES = (
    (FANUC, OF_6241_LATHE, KNOWN), (T988, OF_6241_LATHE, "TApar 6241 to 6255; TDi 17"),
    (["gsk-980tdi"], OF_141, "TDi 17, p.95"),
)


def name(controls):
    return "FANUC" if controls == FANUC else controls[0]


for _controls, _params, _source in MILLS:
    _evidence = "inferred" if _controls == FANUC else "secondary"
    case(
        f"G37 adds to the length how far off the tool arrives, on a mill of {name(_controls)}",
        pins="measuring measuring_subtracts",
        control=_controls, source=_source, evidence=_evidence, params=_params, setup=MILL,
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
        moves="R Z80\nR Z20\nF Z12\nR Z80\nR Z20\nF Z9.5\nR Z80",
        vars={100: 80 + 52 - 400, 101: 80 + 51.5 - 400},
    )
    case(
        f"G37 from within the near distance goes at the measuring feed alone: {name(_controls)}",
        control=_controls, source=_source, evidence=_evidence, params=_params,
        setup=MILL | {"start": {"Z": 15}, "length_offsets": {1: 0, 2: 0}},
        inputs={"skips": [{"Z": 10}]},
        program="""
            O1
            N10 G90 G43 H2 G0 Z15.
            N20 G37 Z10.
            N30 M30
        """,
        moves="R Z15\nF Z10", time=3,
    )
    for _told, _what, _number in (
        (None, "measuring-missed", ("080", "PS0080", "3050")),
        ({"Z": 17}, "measuring-early", ("080", "PS0080", "3051")),
        ({"Z": 4.9}, "measuring-missed", ("080", "PS0080", "3050")),
    ):
        case(
            f"a tool that arrives at {_told} alarms as {_what} and keeps its length: {name(_controls)}",
            control=_controls, source="ALM 080; MDia 3050, 3051",
            evidence="secondary", params=_params, setup=MILL, inputs={"skips": [_told]},
            program="""
                O1
                N10 G90 G43 H1 G0 Z80.
                N20 G37 Z10.
                N30 M30
            """,
            moves="R Z80", alarm=_what, at="O1 N20", word="G37",
            number={c: _number[0 if c == "fanuc-16i" else 2 if c == "gsk-980mdi" else 1] for c in _controls},
        )
    for _block, _before, _what, _number, _word in (
        ("G37 H1 Z10.", "", "measuring-with-offset", ("082", "PS0082", "0297"), "H1"),
        ("G37 Z10.", "H0", "measuring-without-offset", ("081", "PS0081", "3052"), "G37"),
        ("G37", "", "measuring-axis", ("083", "PS0083", "0299"), "G37"),
        ("G37 X1. Z10.", "", "measuring-axis", ("083", "PS0083", "0299"), "G37"),
        ("G37 A10.", "", "measuring-axis", ("083", "PS0083", "0299"), "G37"),
        ("G91 G37 Z-10.", "", "measuring-incremental", ("083", "PS0083", "0298"), "Z-10."),
    ):
        case(
            f"{_block} {_before} alarms as {_what} on a mill of {name(_controls)}",
            control=_controls, source="ALM 081 to 083; MDib 0297 to 0299; MDia 3052",
            evidence="secondary", params=_params, setup=MILL, inputs={"skips": [0.5]},
            program=f"""
                O1
                N10 G90 G43 H1 G0 Z80.
                N20 {_before}
                N30 {_block}
                N40 M30
            """,
            runs="N10 N20", alarm=_what, at="O1 N30", word=_word,
            number={c: _number[0 if c == "fanuc-16i" else 2 if c == "gsk-980mdi" else 1] for c in _controls},
        )
case(
    "G37 measures along X and Y of a FANUC mill too",
    control=FANUC, source=KNOWN, evidence="inferred", params=OF_6241, setup=MILL,
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
    params=OF_6241_LATHE | {"6252": 7.9}, setup=LATHE, inputs={"skips": [0.5]},
    program="O1\nN10 T0101 G0 X220. Z150.\nN20 G37 Z100.\nN30 M30\n",
    runs="N10", alarm="measuring-zone", number="054", at="O1 N20", word="G37",
)
case(
    "a measuring feed that begins at the zone or inside it measures elsewhere",
    control=[*FANUC, *T988], source="Talm 054: below alone; general knowledge", evidence="secondary",
    params=OF_6241_LATHE | {"6252": 8}, setup=LATHE, inputs={"skips": [{"Z": 101}]},
    program="O1\nN10 T0101 G0 X220. Z150.\nN20 G37 Z100.\nN30 M30\n",
    moves="R X220 Z150\nR Z108\nF Z101",
)
case(
    "no measuring feed is set as delivered",
    control=FANUC, source="policy, parameters as delivered", evidence="inferred",
    params=MM, setup=MILL, inputs={"skips": [0.5]},
    program="O1\nN10 G90 G43 H1 G0 Z80.\nN20 G37 Z10.\nN30 M30\n",
    runs="N10", alarm="no-measuring-feed", number=None, at="O1 N20", word="G37",
)

# Lathes

for _controls, _params, _source in LATHES:
    _evidence = {"gsk-980tdi": "maker's manual", "gsk-988ta": "secondary"}.get(_controls[0], "inferred")
    case(
        f"G36 measures X and G37 Z of a tool, on a lathe of {name(_controls)}",
        pins="measuring measuring_subtracts",
        control=_controls, source=_source, evidence=_evidence, params=_params, setup=LATHE,
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
        vars={100: 204 + 7.5, 101: 110 + 14},
    )
    for _block, _told, _what, _number, _word in (
        ("G36 X200.", {"X": 208}, "measuring-early", ("080", "PS0080", "051"), "G36"),
        ("G36 X200.", None, "measuring-missed", ("080", "PS0080", "051"), "G36"),
        ("G37 Z100. T0101", 0.5, "measuring-with-offset", ("082", "PS0082", "053"), "T0101"),
        ("G36 Z100.", 0.5, "measuring-axis", ("083", "PS0083", "054"), "G36"),
        ("G37 X100.", 0.5, "measuring-axis", ("083", "PS0083", "054"), "G37"),
        ("G37 W-10.", 0.5, "measuring-incremental", ("083", "PS0083", "054"), "W-10."),
        ("G36 U-10.", 0.5, "measuring-incremental", ("083", "PS0083", "054"), "U-10."),
    ):
        case(
            f"{_block}, told {_told}, alarms as {_what} on a lathe of {name(_controls)}",
            control=_controls, source="ALM 080 to 083; Talm 051 to 054; TDi 17",
            evidence="secondary", params=_params, setup=LATHE, inputs={"skips": [_told]},
            program=f"""
                O1
                N10 T0101
                N20 G0 X220. Z130.
                N30 {_block}
                N40 M30
            """,
            runs="N10 N20", alarm=_what, at="O1 N30", word=_word,
            number={
                c: None if c == "gsk-980tdi" else _number[0 if c == "fanuc-16i" else 2 if c in T988 else 1]
                for c in _controls
            },
        )
    case(
        f"a tool is measured with its offset number in force alone, on a lathe of {name(_controls)}",
        control=_controls, source="ALM 081; Talm 052; TDi 17", evidence="secondary",
        params=_params, setup=LATHE, inputs={"skips": [0.5]},
        program="O1\nN10 T0100\nN20 G0 X220. Z130.\nN30 G36 X200.\nN40 M30\n",
        runs="N10 N20", alarm="measuring-without-offset", at="O1 N30", word="G36",
        number={
            c: {"fanuc-16i": "081", "gsk-988ta": "052", "gsk-988t": "052", "gsk-980tdi": None}.get(c, "PS0081")
            for c in _controls
        },
    )
    case(
        f"no tool is measured in radius compensation, on a lathe of {name(_controls)}",
        control=_controls, source="Talm 056; TDi 17", evidence="secondary",
        params=_params, setup=LATHE, inputs={"skips": [0.5]},
        program="O1\nN10 T0101\nN20 G98 G42 G1 X220. Z130. F100\nN30 G36 X200.\nN40 M30\n",
        runs="N10 N20", alarm="measuring-in-offset", at="O1 N30", word="G36",
        number={c: "056" if c in T988 else None for c in _controls},
    )
case(
    "6210#6 subtracts what was measured",
    control=[*FANUC, *T988], source="TApar 6210#6", evidence="secondary",
    params=OF_6241_LATHE | {"6210#6": 1}, setup=LATHE, inputs={"skips": [{"X": 201.5}]},
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
    pins="measuring measuring_subtracts",
    control=MITSUBISHI, source="M7 p.555", evidence="secondary", params=OF_8004,
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
for _block, _told, _what, _number, _word in (
    ("G37.1 Z10. D1. F60", {"Z": 12}, "measuring-early", "P607", "G37.1"),
    ("G37.1 Z10. D1. F60", {"Z": 8}, "measuring-missed", "P607", "G37.1"),
    ("G37.1 Z10. H1", 0.5, "measuring-with-offset", "P605", "H1"),
    ("G37.1 X10. Z10.", 0.5, "measuring-axis", "P604", "G37.1"),
    ("G49 H0\nN25 G37.1 Z10.", 0.5, "measuring-without-offset", "P606", "G37.1"),
):
    case(
        f"{_block.splitlines()[-1]}, told {_told}, alarms as {_what}",
        control=MITSUBISHI, source="general knowledge, P604 to P607", evidence="inferred",
        params=OF_8004, setup=MILL, inputs={"skips": [_told]},
        program=f"O1\nN10 G90 G43 H1 G0 Z80.\nN20 {_block}\nN30 M30\n",
        alarm=_what, number=_number, at="O1 N25" if "N25" in _block else "O1 N20",
        word=_word,
    )
for _codes in "G36", "G37":
    case(
        f"the moves of {_codes} of a Mitsubishi are not computed",
        control=MITSUBISHI, source="general knowledge: patterns of a mill, measuring of a lathe",
        evidence="inferred", setup=MILL,
        program=f"O1\nN10 G0 Z80.\nN20 {_codes} Z10.\nN30 M30\n",
        runs="N10", alarm="code-not-computed", number=None, at="O1 N20",
    )
case(
    "G31 in feed per revolution is 058 on the 988",
    control=T988, source="Talm 058", evidence="secondary", setup=LATHE, inputs={"skips": [0.5]},
    program="O1\nN10 G98 G31 X200. F100\nN20 G99 G31 X100. F0.1\nN30 M30\n",
    runs="N10", alarm="skip-per-revolution", number="058", at="O1 N20", word="G31",
)
