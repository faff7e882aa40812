"""Corners in blocks that call."""

from conformance import case

TDI, MDI = GSK_980 = ["gsk-980tdi", "gsk-980mdi"]

case(
    "M98 beside a chamfer is 0093 on the 980MDi: G1 X10. ,C1. F100 M98 P2",
    control=MDI, source="MDib 0093", evidence="maker's manual",
    program="O1\nN10 M8\nN20 G1 X10. ,C1. F100 M98 P2\nN30 M30\nO2\nN40 M99\n",
    runs="N10", alarm="corner-with-call", number="0093", at="O1 N20", word=",C1.",
)
case(
    "M98 beside a chamfer is 0093 on the 980MDi: M98 P2 G1 X10. ,R1. F100",
    control=MDI, source="MDib 0093", evidence="maker's manual",
    program="O1\nN10 M8\nN20 M98 P2 G1 X10. ,R1. F100\nN30 M30\nO2\nN40 M99\n",
    runs="N10", alarm="corner-with-call", number="0093", at="O1 N20", word=",R1.",
)
case(
    "M98 beside a chamfer is 0093 on the 980MDi: G1 X10. L1. F100 M98 P2",
    control=MDI, source="MDib 0093", evidence="maker's manual",
    program="O1\nN10 M8\nN20 G1 X10. L1. F100 M98 P2\nN30 M30\nO2\nN40 M99\n",
    runs="N10", alarm="corner-with-call", number="0093", at="O1 N20", word="L1.",
)
case(
    "M98 beside a chamfer is 0093 on the 980MDi: M98 P2 U1.",
    control=MDI, source="MDib 0093", evidence="maker's manual",
    program="O1\nN10 M8\nN20 M98 P2 U1.\nN30 M30\nO2\nN40 M99\n",
    runs="N10", alarm="corner-with-call", number="0093", at="O1 N20", word="U1.",
)
case(
    "M98 beside a chamfer is 0093 on the 980MDi: G1 G91 Y10. U1. F100 M98 P2",
    control=MDI, source="MDib 0093", evidence="maker's manual",
    program="O1\nN10 M8\nN20 G1 G91 Y10. U1. F100 M98 P2\nN30 M30\nO2\nN40 M99\n",
    runs="N10", alarm="corner-with-call", number="0093", at="O1 N20", word="U1.",
)
case(
    "M98 beside a chamfer is 0093 on the 980MDi: M98 P2 ,C1.",
    control=MDI, source="MDib 0093", evidence="maker's manual",
    program="O1\nN10 M8\nN20 M98 P2 ,C1.\nN30 M30\nO2\nN40 M99\n",
    runs="N10", alarm="corner-with-call", number="0093", at="O1 N20", word=",C1.",
)
case(
    "a call without a chamfer is none to 0093: G1 X10. F100 M98 P2",
    control=MDI, source="MDib 0093", evidence="maker's manual",
    program="O1\nN10 M8\nN20 G1 X10. F100 M98 P2\nN30 M30\nO2\nN40 M99\n",
    runs="N10 N20 N40 N30", m=[8],
)
case(
    "a call without a chamfer is none to 0093: M98 P2 L1",
    control=MDI, source="MDib 0093", evidence="maker's manual",
    program="O1\nN10 M8\nN20 M98 P2 L1\nN30 M30\nO2\nN40 M99\n",
    runs="N10 N20 N40 N30", m=[8],
)
case(
    "a call without a chamfer is none to 0093: M98 P2",
    control=MDI, source="MDib 0093", evidence="maker's manual",
    program="O1\nN10 M8\nN20 M98 P2\nN30 M30\nO2\nN40 M99\n",
    runs="N10 N20 N40 N30", m=[8],
)
