"""M29 and its tapping cycle."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
MDI, TDI = "gsk-980mdi", "gsk-980tdi"
MM = {"whole_numbers": "millimetres"}
MILL = {"machine": "mill", "start": {"X": 0, "Y": 0, "Z": 50}}


def fanuc(number):
    return {c: number if c == "fanuc-16i" else f"PS0{number}" for c in FANUC}


case(
    "G0 X20. between M29 and its tapping cycle is refused",
    control=[MDI, *FANUC], source="MDib 0232; added facts, PS0204", evidence="secondary", replace=MM,
    setup=MILL | {"reference": {1: {"Z": 100}}},
    program="""
        O1
        N10 G90 G0 X10. S500 M3
        N20 M29 S500
        N30 G0 X20.
        N40 G84 X10. Z-5. R2. F500
        N50 M30
    """,
    runs="N10 N20", alarm="move-before-rigid-tap", at="O1 N30", word="X20.",
    number={**fanuc("204"), MDI: "0232"},
)
case(
    "X20. between M29 and its tapping cycle is refused",
    control=[MDI, *FANUC], source="MDib 0232; added facts, PS0204", evidence="secondary", replace=MM,
    setup=MILL | {"reference": {1: {"Z": 100}}},
    program="""
        O1
        N10 G90 G0 X10. S500 M3
        N20 M29 S500
        N30 X20.
        N40 G84 X10. Z-5. R2. F500
        N50 M30
    """,
    runs="N10 N20", alarm="move-before-rigid-tap", at="O1 N30", word="X20.",
    number={**fanuc("204"), MDI: "0232"},
)
case(
    "G1 X20. F100 between M29 and its tapping cycle is refused",
    control=[MDI, *FANUC], source="MDib 0232; added facts, PS0204", evidence="secondary", replace=MM,
    setup=MILL | {"reference": {1: {"Z": 100}}},
    program="""
        O1
        N10 G90 G0 X10. S500 M3
        N20 M29 S500
        N30 G1 X20. F100
        N40 G84 X10. Z-5. R2. F500
        N50 M30
    """,
    runs="N10 N20", alarm="move-before-rigid-tap", at="O1 N30", word="X20.",
    number={**fanuc("204"), MDI: "0232"},
)
case(
    "G53 Z0 between M29 and its tapping cycle is refused",
    control=[MDI, *FANUC], source="MDib 0232; added facts, PS0204", evidence="secondary", replace=MM,
    setup=MILL | {"reference": {1: {"Z": 100}}},
    program="""
        O1
        N10 G90 G0 X10. S500 M3
        N20 M29 S500
        N30 G53 Z0
        N40 G84 X10. Z-5. R2. F500
        N50 M30
    """,
    runs="N10 N20", alarm="move-before-rigid-tap", at="O1 N30", word="Z0",
    number={**fanuc("204"), MDI: "0232"},
)
case(
    "G28 Z50. between M29 and its tapping cycle is refused",
    control=[MDI, *FANUC], source="MDib 0232; added facts, PS0204", evidence="secondary", replace=MM,
    setup=MILL | {"reference": {1: {"Z": 100}}},
    program="""
        O1
        N10 G90 G0 X10. S500 M3
        N20 M29 S500
        N30 G28 Z50.
        N40 G84 X10. Z-5. R2. F500
        N50 M30
    """,
    runs="N10 N20", alarm="move-before-rigid-tap", at="O1 N30", word="Z50.",
    number={**fanuc("204"), MDI: "0232"},
)
case(
    "rigid tapping of M29 with S0 has no speed",
    control=FANUC, source="added facts, PS0200", evidence="secondary", replace=MM, setup=MILL,
    program="O1\nN10 G90 G0 X10. F100\nN20 M29 S0\nN30 G84 X10. Z-5. R2. F500\nN50 M30\n",
    runs="N10 N20", alarm="rigid-tap-without-speed", at="O1 N30", number=fanuc("200"), word="G84",
)
case(
    "rigid tapping of S0 in the cycle has no speed",
    control=FANUC, source="added facts, PS0200", evidence="secondary", replace=MM, setup=MILL,
    program="O1\nN10 G90 G0 X10. F100\nN20 M29\nN30 S0 G84 X10. Z-5. R2. F500\nN50 M30\n",
    runs="N10 N20", alarm="rigid-tap-without-speed", at="O1 N30", number=fanuc("200"), word="S0",
)
case(
    "rigid tapping of S0 before M29 and a dwell has no speed",
    control=FANUC, source="added facts, PS0200", evidence="secondary", replace=MM, setup=MILL,
    program="""
        O1
        N10 G90 G0 X10. F100
        N20 S0 M29
        N25 G4 P100
        N30 G84 X10. Z-5. R2. F500
        N50 M30
    """,
    runs="N10 N20 N25", alarm="rigid-tap-without-speed", at="O1 N30", number=fanuc("200"),
    word="G84",
)
case(
    "tapping without M29 needs no speed before, and a speed between M29 and its cycle counts",
    control=FANUC, source="added facts, PS0200", evidence="secondary", replace=MM, setup=MILL,
    program="""
        O1
        N10 G90 G0 X10. S0 F100
        N20 G84 Z-5. R2. F500
        N30 G80
        N40 M29
        N50 G84 X10. Z-5. R2. F500 S300
        N60 G80
        N70 M30
    """,
    runs="N10 N20 N30 N40 N50 N60 N70",
)
case(
    "M29 with a move in its block, a dwell after it and its cycle then is no fault",
    control=[MDI, *FANUC], source="MDib 0232; added facts, PS0204", evidence="secondary",
    replace=MM, setup=MILL,
    program="""
        O1
        N10 G90 G0 X10. M29 S500
        N20 G4 P100
        N30 G84 Z-5. R2. F500
        N40 X20.
        N50 G80
        N60 G0 X30.
        N70 M30
    """,
    runs="N10 N20 N30 N40 N50 N60 N70",
)
case(
    "M29 says nothing where no source tells of it",
    control=[TDI, *MITSUBISHI], source="general knowledge", evidence="inferred",
    program="O1\nN10 M29 S500\nN20 G0 X20.\nN30 M30\n", moves="R X20",
)
