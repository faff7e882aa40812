"""G11 without a G10 before."""

from conformance import case

MDI, TDI = "gsk-980mdi", "gsk-980tdi"
MILL = {"machine": "mill", "start": {"X": 0, "Y": 0, "Z": 50}}

case(
    "G11 before any G10 is refused by the 980MDi",
    control=MDI, source="MDib 0029", evidence="maker's manual", setup=MILL,
    program="O1\nN10 S1\nN20 G11\nN30 M30\n",
    runs="N10", alarm="g11-before-g10", number="0029", at="O1 N20", word="G11",
)
case(
    "G11 after a G10 is no fault on the 980MDi",
    control=MDI, source="MDib 0029", evidence="maker's manual", setup=MILL,
    program="O1\nN10 G10 L2 P1 X5.\nN20 G11\nN30 M30\n", runs="N10 N20 N30",
)
