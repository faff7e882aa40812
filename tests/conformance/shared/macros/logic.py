"""Logic of 0 and 1, and logic bit by bit."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
T988 = ["gsk-988ta", "gsk-988t"]
MDI, TDI = "gsk-980mdi", "gsk-980tdi"

case(
    "logic of another value than 0 and 1 is refused by the 980MDi: 2 AND 3",
    pins="refuses:logic-of-other-than-0-and-1", control=MDI, source="MDib 0133", evidence="maker's manual",
    variables={100: 3},
    program="O1\nN10 S1\nN20 #1=2 AND 3\nN30 M30\n",
    runs="N10", alarm="logic-of-other-than-0-and-1", number="0133", at="O1 N20",
)
case(
    "logic of another value than 0 and 1 is refused by the 980MDi: 1 OR 2",
    pins="refuses:logic-of-other-than-0-and-1", control=MDI, source="MDib 0133", evidence="maker's manual",
    variables={100: 3},
    program="O1\nN10 S1\nN20 #1=1 OR 2\nN30 M30\n",
    runs="N10", alarm="logic-of-other-than-0-and-1", number="0133", at="O1 N20",
)
case(
    "logic of another value than 0 and 1 is refused by the 980MDi: 4 XOR 1",
    pins="refuses:logic-of-other-than-0-and-1", control=MDI, source="MDib 0133", evidence="maker's manual",
    variables={100: 3},
    program="O1\nN10 S1\nN20 #1=4 XOR 1\nN30 M30\n",
    runs="N10", alarm="logic-of-other-than-0-and-1", number="0133", at="O1 N20",
)
case(
    "logic of another value than 0 and 1 is refused by the 980MDi: a sum beside OR",
    pins="refuses:logic-of-other-than-0-and-1", control=MDI, source="MDib 0133", evidence="maker's manual",
    variables={100: 3},
    program="O1\nN10 S1\nN20 #1=1 OR [1+1]\nN30 M30\n",
    runs="N10", alarm="logic-of-other-than-0-and-1", number="0133", at="O1 N20",
)
case(
    "logic of another value than 0 and 1 is refused by the 980MDi: G65 H11",
    pins="refuses:logic-of-other-than-0-and-1", control=MDI, source="MDib 0133", evidence="maker's manual",
    variables={100: 3},
    program="O1\nN10 S1\nN20 G65 H11 P#1 Q1 R2\nN30 M30\n",
    runs="N10", alarm="logic-of-other-than-0-and-1", number="0133", at="O1 N20",
)
case(
    "logic of another value than 0 and 1 is refused by the 980MDi: G65 H12",
    pins="refuses:logic-of-other-than-0-and-1", control=MDI, source="MDib 0133", evidence="maker's manual",
    variables={100: 3},
    program="O1\nN10 S1\nN20 G65 H12 P#1 Q#100 R1\nN30 M30\n",
    runs="N10", alarm="logic-of-other-than-0-and-1", number="0133", at="O1 N20",
)
case(
    "logic of another value than 0 and 1 is refused by the 980MDi: G65 H13",
    pins="refuses:logic-of-other-than-0-and-1", control=MDI, source="MDib 0133", evidence="maker's manual",
    variables={100: 3},
    program="O1\nN10 S1\nN20 G65 H13 P#1 Q4 R4\nN30 M30\n",
    runs="N10", alarm="logic-of-other-than-0-and-1", number="0133", at="O1 N20",
)
case(
    "logic of another value than 0 and 1 is refused by the 980MDi: minus one",
    pins="refuses:logic-of-negative refuses:logic-of-other-than-0-and-1", control=MDI, source="MDib 0133", evidence="maker's manual",
    variables={100: 3},
    program="O1\nN10 S1\nN20 #1=1 AND -1\nN30 M30\n",
    runs="N10", alarm="logic-of-other-than-0-and-1", number="0133", at="O1 N20",
)
case(
    "logic of 0 and 1 is computed by the 980MDi",
    control=MDI, source="MDib 0133", evidence="maker's manual", variables={100: 1},
    program="""
        O1
        N10 #101=1 AND 1
        N20 #102=1 OR 0
        N30 #103=1 XOR 1
        N40 G65 H12 P#104 Q#100 R1
        N50 M30
    """,
    vars={101: 1, 102: 1, 103: 0, 104: 1},
)
case(
    "logic goes bit by bit elsewhere",
    pins="refuses:logic-of-other-than-0-and-1",
    control=[TDI, *T988, *FANUC, *MITSUBISHI, "haas-ngc"], source="TDi 29, 3.29.1: bit by bit; JIX",
    evidence="inferred",
    program="O1\nN10 #101=6 AND 3\nN20 #102=6 OR 3\nN30 #103=6 XOR 3\nN40 M30\n",
    vars={101: 2, 102: 7, 103: 5},
)
