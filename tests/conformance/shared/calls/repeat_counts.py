"""Repeat counts that have too many digits, and others that are not allowed."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
FOUR = FANUC[:3]  # a count has at most four digits
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
MDI, TDI = "gsk-980mdi", "gsk-980tdi"

case(
    "M98 P2 L10000 has more digits than a count may have on fanuc-16i and its kin",
    control=FOUR, source="added facts: 003, PS0003; SK P35; MDib 0092", evidence="inferred",
    variables={100: 10000},
    program="O1\nN10 S1\nN20 M98 P2 L10000\nN30 M30\nO2\nN40 M99\n",
    runs="N10", alarm="repeat-count-digits", at="O1 N20",
    number={"fanuc-16i": "003", "fanuc-0i-d": "PS0003", "fanuc-0i-f": "PS0003"},
)
case(
    "M98 P2 L123456 has more digits than a count may have on fanuc-16i and its kin",
    control=FOUR, source="added facts: 003, PS0003; SK P35; MDib 0092", evidence="inferred",
    variables={100: 10000},
    program="O1\nN10 S1\nN20 M98 P2 L123456\nN30 M30\nO2\nN40 M99\n",
    runs="N10", alarm="repeat-count-digits", at="O1 N20",
    number={"fanuc-16i": "003", "fanuc-0i-d": "PS0003", "fanuc-0i-f": "PS0003"},
)
case(
    "G65 P2 L10000 has more digits than a count may have on fanuc-16i and its kin",
    control=FOUR, source="added facts: 003, PS0003; SK P35; MDib 0092", evidence="inferred",
    variables={100: 10000},
    program="O1\nN10 S1\nN20 G65 P2 L10000\nN30 M30\nO2\nN40 M99\n",
    runs="N10", alarm="repeat-count-digits", at="O1 N20",
    number={"fanuc-16i": "003", "fanuc-0i-d": "PS0003", "fanuc-0i-f": "PS0003"},
)
case(
    "G66 P2 L10000 has more digits than a count may have on fanuc-16i and its kin",
    control=FOUR, source="added facts: 003, PS0003; SK P35; MDib 0092", evidence="inferred",
    variables={100: 10000},
    program="O1\nN10 S1\nN20 G66 P2 L10000\nN30 M30\nO2\nN40 M99\n",
    runs="N10", alarm="repeat-count-digits", at="O1 N20",
    number={"fanuc-16i": "003", "fanuc-0i-d": "PS0003", "fanuc-0i-f": "PS0003"},
)
case(
    "M98 P2 L#100 has more digits than a count may have on fanuc-16i and its kin",
    control=FOUR, source="added facts: 003, PS0003; SK P35; MDib 0092", evidence="inferred",
    variables={100: 10000},
    program="O1\nN10 S1\nN20 M98 P2 L#100\nN30 M30\nO2\nN40 M99\n",
    runs="N10", alarm="repeat-count-digits", at="O1 N20",
    number={"fanuc-16i": "003", "fanuc-0i-d": "PS0003", "fanuc-0i-f": "PS0003"},
)
case(
    "M98 P2 L123456789 has more digits than a count may have on fanuc-30i and its kin",
    control=["fanuc-30i"], source="added facts: 003, PS0003; SK P35; MDib 0092",
    evidence="inferred", variables={100: 10000},
    program="O1\nN10 S1\nN20 M98 P2 L123456789\nN30 M30\nO2\nN40 M99\n",
    runs="N10", alarm="repeat-count-digits", at="O1 N20", number={"fanuc-30i": "PS0003"},
)
case(
    "M98 P2 L10000 has more digits than a count may have on mitsubishi-meldas and its kin",
    control=MITSUBISHI, source="added facts: 003, PS0003; SK P35; MDib 0092", evidence="inferred",
    variables={100: 10000},
    program="O1\nN10 S1\nN20 M98 P2 L10000\nN30 M30\nO2\nN40 M99\n",
    runs="N10", alarm="repeat-count-digits", at="O1 N20",
    number={"mitsubishi-meldas": "P35", "mitsubishi-m700": "P35", "mitsubishi-m800": "P35"},
)
case(
    "G65 P2 L#100 has more digits than a count may have on mitsubishi-meldas and its kin",
    control=MITSUBISHI, source="added facts: 003, PS0003; SK P35; MDib 0092", evidence="inferred",
    variables={100: 10000},
    program="O1\nN10 S1\nN20 G65 P2 L#100\nN30 M30\nO2\nN40 M99\n",
    runs="N10", alarm="repeat-count-digits", at="O1 N20",
    number={"mitsubishi-meldas": "P35", "mitsubishi-m700": "P35", "mitsubishi-m800": "P35"},
)
case(
    "M98 P100000002 has more digits than a count may have on gsk-980tdi and its kin",
    control=[TDI, MDI], source="added facts: 003, PS0003; SK P35; MDib 0092", evidence="inferred",
    variables={100: 10000},
    program="O1\nN10 S1\nN20 M98 P100000002\nN30 M30\nO2\nN40 M99\n",
    runs="N10", alarm="repeat-count-digits", at="O1 N20",
    number={"gsk-980tdi": "0092", "gsk-980mdi": "0092"},
)
case(
    "G65 P2 L10000 has more digits than a count may have on gsk-980tdi and its kin",
    control=[TDI, MDI], source="added facts: 003, PS0003; SK P35; MDib 0092", evidence="inferred",
    variables={100: 10000},
    program="O1\nN10 S1\nN20 G65 P2 L10000\nN30 M30\nO2\nN40 M99\n",
    runs="N10", alarm="repeat-count-digits", at="O1 N20",
    number={"gsk-980tdi": "0092", "gsk-980mdi": "0092"},
)
case(
    "a computed count below zero is not allowed, and no FANUC number is known for it",
    control=FANUC, source="general knowledge", evidence="inferred", variables={100: -2},
    program="O1\nN10 S1\nN20 M98 P2 L#100\nN30 M30\nO2\nN40 M99\n",
    runs="N10", alarm="illegal-repeat-count", number=None, at="O1 N20",
)
