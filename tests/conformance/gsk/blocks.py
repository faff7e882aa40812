"""GSK: reading a block."""

from conformance import case

TA, T, TDI, MDI, TE = "gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi", "gsk-928te"
FAMILY_988 = [TA, T]
FAMILIES = [TA, T, TDI, MDI]
MANUAL = "maker's manual"
SECONDARY = "secondary"
INFERRED = "inferred"

case(
    "GSK 980MDi: the N word must be the first of its block",
    control=MDI, source="MDia 006", evidence=MANUAL,
    program="O1\nN10 G0 X1\nG0 N20 X2\nN30 M30\n",
    runs="N10", alarm="sequence-number-not-first", number="0006", at="O1",
)
case(
    "GSK 980MDi: the same address twice in a block is refused",
    control=MDI, source="MDia 010", evidence=MANUAL,
    program="O1\nN10 G0 X1\nN20 G0 X2 X3\nN30 M30\n",
    runs="N10", alarm="address-given-twice", number="0010", at="O1 N20",
)
case(
    "GSK 988: with 3403#6=1 the same address twice in a block is refused",
    control=FAMILY_988, source="Talm 010; TApar 3403", evidence=SECONDARY, params={"3403#6": 1},
    program="O1\nN10 G0 X1\nN20 G0 X2 X3\nN30 M30\n",
    runs="N10", alarm="address-given-twice", number="010", at="O1 N20",
)
case(
    "GSK 988: with 3403#6=0 the same address twice in a block is taken",
    control=FAMILY_988, source="Talm 010; TApar 3403", evidence=SECONDARY, params={"3403#6": 0},
    program="O1\nN10 G0 X1\nN20 G0 X2 X3\nN30 M30\n",
    runs="N10 N20 N30",
)
case(
    "GSK 988: with 3403#6=0 the last P of M98 counts",
    control=FAMILY_988, source="TApar 3403", evidence=INFERRED, params={"3403#6": 0},
    program="O1\nN10 M98 P3 P2\nN20 M30\nO2\nN30 M99\nO3\nN40 M99\n",
    runs="N10 N30 N20", calls="M98:O2",
)
case(
    "GSK 988: with 3403#6=1 a second P of M98 is refused",
    control=FAMILY_988, source="Talm 010; TApar 3403", evidence=INFERRED, params={"3403#6": 1},
    program="O1\nN10 M98 P3 P2\nN20 M30\nO2\nN30 M99\nO3\nN40 M99\n",
    runs="", alarm="address-given-twice", number="010", at="O1 N10",
)
case(
    "GSK 980MDi: a comment that is not closed is refused",
    control=MDI, source="MDia 041", evidence=MANUAL,
    program="O1\nN10 G0 X1\nN20 G0 X2 (SLOT\nN30 M30\n",
    runs="N10", alarm="comment-not-closed", number="0041", at="O1 N20",
)
case(
    "GSK: a call inside a comment is not made",
    control=FAMILIES, source="K, comments", evidence=INFERRED,
    program="O1\nN10 G0 X1 (M98 P2)\nN20 M30\nO2\nN30 M99\n",
    runs="N10 N20", calls="",
)
case(
    "GSK 988: an address without a value is refused",
    control=FAMILY_988, source="Talm 005", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 G0 X\nN30 M30\n",
    runs="N10", alarm="address-without-value", number="005", at="O1 N20",
)
case(
    "GSK 988: P without a value is no call",
    control=FAMILY_988, source="Talm 005", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 M98 P\nN30 M30\n",
    runs="N10", alarm="address-without-value", number="005", at="O1 N20",
)
case(
    "GSK: a G code that the control does not have is refused",
    pins="unlisted_codes",
    control=FAMILIES, source="Talm 009; MDib 0002", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 G999\nN30 M30\n",
    runs="N10", alarm="g-code-not-available",
    number={TA: "009", T: "009", TDI: "0002", MDI: "0002"}, at="O1 N20",
)
case(
    "GSK: a block longer than the control takes is refused",
    control=[TA, T, MDI], source="Talm 002; MDia 037", evidence=SECONDARY,
    program="O1\nN10 G0 X1\nN20 G0 X2" + " " * 300 + "Z3\nN30 M30\n",
    runs="N10", alarm="block-too-long", number={TA: "002", T: "002", MDI: "0037"}, at="O1 N20",
)
