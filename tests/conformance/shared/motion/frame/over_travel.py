"""Over-travel of the fourth and the fifth axis."""

from conformance import case

MDI, TDI = "gsk-980mdi", "gsk-980tdi"
MILL = {"machine": "mill", "start": {"X": 0, "Y": 0, "Z": 50}}

case(
    "3014 is the travel of A in + on the 980MDi",
    control=MDI, source="MDia 3011 to 3020; that A is the fourth, B the fifth is inferred",
    evidence="inferred",
    setup=MILL | {"start": {"A": 0, "B": 0}, "limits": {"A": (-90, 90), "B": (-90, 90)}},
    program="O1\nN10 G90 G0 A80.\nN20 A95.\nN30 M30\n",
    runs="N10", alarm="over-travel", number="3014", at="O1 N20", word="A95.",
)
case(
    "3015 is the travel of B in + on the 980MDi",
    control=MDI, source="MDia 3011 to 3020; that A is the fourth, B the fifth is inferred",
    evidence="inferred",
    setup=MILL | {"start": {"A": 0, "B": 0}, "limits": {"A": (-90, 90), "B": (-90, 90)}},
    program="O1\nN10 G90 G0 B80.\nN20 B95.\nN30 M30\n",
    runs="N10", alarm="over-travel", number="3015", at="O1 N20", word="B95.",
)
case(
    "3019 is the travel of A in - on the 980MDi",
    control=MDI, source="MDia 3011 to 3020; that A is the fourth, B the fifth is inferred",
    evidence="inferred",
    setup=MILL | {"start": {"A": 0, "B": 0}, "limits": {"A": (-90, 90), "B": (-90, 90)}},
    program="O1\nN10 G90 G0 A-80.\nN20 A-95.\nN30 M30\n",
    runs="N10", alarm="over-travel", number="3019", at="O1 N20", word="A-95.",
)
case(
    "3020 is the travel of B in - on the 980MDi",
    control=MDI, source="MDia 3011 to 3020; that A is the fourth, B the fifth is inferred",
    evidence="inferred",
    setup=MILL | {"start": {"A": 0, "B": 0}, "limits": {"A": (-90, 90), "B": (-90, 90)}},
    program="O1\nN10 G90 G0 B-80.\nN20 B-95.\nN30 M30\n",
    runs="N10", alarm="over-travel", number="3020", at="O1 N20", word="B-95.",
)
