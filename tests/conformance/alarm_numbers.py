"""Alarm numbers that the makers' lists give, one by one."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
FOUR = FANUC[:3]  # a count has at most four digits
MITSUBISHI = ["mitsubishi-meldas", "mitsubishi-m700", "mitsubishi-m800"]
T988 = ["gsk-988ta", "gsk-988t"]
MDI, TDI = "gsk-980mdi", "gsk-980tdi"
MM = {"3401#0": 1}
MILL = {"machine": "mill", "start": {"X": 0, "Y": 0, "Z": 50}}


def fanuc(number):
    return {c: number if c == "fanuc-16i" else f"PS0{number}" for c in FANUC}


# Repeat counts: more digits than the largest, and others that are not allowed

for _call, _controls in (
    ("M98 P2 L10000", FOUR), ("M98 P2 L123456", FOUR), ("G65 P2 L10000", FOUR),
    ("G66 P2 L10000", FOUR), ("M98 P2 L#100", FOUR), ("M98 P2 L123456789", ["fanuc-30i"]), ("M98 P2 L10000", MITSUBISHI),
    ("G65 P2 L#100", MITSUBISHI), ("M98 P100000002", [TDI, MDI]), ("G65 P2 L10000", [TDI, MDI]),
):
    case(
        f"{_call} has more digits than a count may have on {_controls[0]} and its kin",
        control=_controls, source="added facts: 003, PS0003; SK P35; MDib 0092", evidence="inferred",
        variables={100: 10000},
        program=f"O1\nN10 S1\nN20 {_call}\nN30 M30\nO2\nN40 M99\n",
        runs="N10", alarm="repeat-count-digits", at="O1 N20",
        number={
            c: fanuc("003")[c] if c in FANUC else "P35" if c in MITSUBISHI else "0092" for c in _controls
        },
    )
case(
    "a computed count below zero is not allowed, and no FANUC number is known for it",
    control=FANUC, source="general knowledge", evidence="inferred", variables={100: -2},
    program="O1\nN10 S1\nN20 M98 P2 L#100\nN30 M30\nO2\nN40 M99\n",
    runs="N10", alarm="illegal-repeat-count", number=None, at="O1 N20",
)

# Logic of 0 and 1

for _what, _line in (
    ("2 AND 3", "#1=2 AND 3"), ("1 OR 2", "#1=1 OR 2"), ("4 XOR 1", "#1=4 XOR 1"),
    ("a sum beside OR", "#1=1 OR [1+1]"), ("G65 H11", "G65 H11 P#1 Q1 R2"),
    ("G65 H12", "G65 H12 P#1 Q#100 R1"), ("G65 H13", "G65 H13 P#1 Q4 R4"),
    ("minus one", "#1=1 AND -1"),
):
    case(
        f"logic of another value than 0 and 1 is refused by the 980MDi: {_what}",
        pins="negative_logic logic_of_bits",
        control=MDI, source="MDib 0133", evidence="maker's manual", variables={100: 3},
        program=f"O1\nN10 S1\nN20 {_line}\nN30 M30\n",
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
    pins="logic_of_bits",
    control=[TDI, *T988, *FANUC, *MITSUBISHI, "haas-ngc"], source="TDi 29, 3.29.1: bit by bit; JIX",
    evidence="inferred",
    program="O1\nN10 #101=6 AND 3\nN20 #102=6 OR 3\nN30 #103=6 XOR 3\nN40 M30\n",
    vars={101: 2, 102: 7, 103: 5},
)

# M29 and its tapping cycle

for _move in "G0 X20.", "X20.", "G1 X20. F100", "G53 Z0", "G28 Z50.":
    case(
        f"{_move} between M29 and its tapping cycle is refused",
        control=[MDI, *FANUC], source="MDib 0232; added facts, PS0204", evidence="secondary",
        params=MM, setup=MILL | {"reference": {1: {"Z": 100}}},
        program=f"""
            O1
            N10 G90 G0 X10. S500 M3
            N20 M29 S500
            N30 {_move}
            N40 G84 X10. Z-5. R2. F500
            N50 M30
        """,
        runs="N10 N20", alarm="move-before-rigid-tap", at="O1 N30",
        number={**fanuc("204"), MDI: "0232"},
    )
for _what, _speed, _rest in (
    ("of M29 with S0", "M29 S0", "G84"), ("of S0 in the cycle", "M29", "S0 G84"),
    ("of S0 before M29 and a dwell", "S0 M29", "G4 P100\nN30 G84"),
):
    case(
        f"rigid tapping {_what} has no speed",
        control=FANUC, source="added facts, PS0200", evidence="secondary",
        params=MM, setup=MILL,
        program=f"O1\nN10 G90 G0 X10. F100\nN20 {_speed}\nN30 {_rest} X10. Z-5. R2. F500\nN50 M30\n"
        .replace("N30 G4", "N25 G4"),
        runs="N10 N20 N25" if "G4" in _rest else "N10 N20",
        alarm="rigid-tap-without-speed", at="O1 N30", number=fanuc("200"),
        word="S0" if _rest.startswith("S0") else "G84",
    )
case(
    "tapping without M29 needs no speed before, and a speed between M29 and its cycle counts",
    control=FANUC, source="added facts, PS0200", evidence="secondary", params=MM, setup=MILL,
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
    "M29 with a move in its block, a dwell behind it and its cycle then is no fault",
    control=[MDI, *FANUC], source="MDib 0232; added facts, PS0204", evidence="secondary",
    params=MM, setup=MILL,
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

# G11

case(
    "G11 before any G10 is refused by the 980MDi",
    control=MDI, source="MDib 0029", evidence="maker's manual", setup=MILL,
    program="O1\nN10 S1\nN20 G11\nN30 M30\n",
    runs="N10", alarm="g11-before-g10", number="0029", at="O1 N20",
)
case(
    "G11 behind a G10 is no fault on the 980MDi",
    control=MDI, source="MDib 0029", evidence="maker's manual", setup=MILL,
    program="O1\nN10 G10 L2 P1 X5.\nN20 G11\nN30 M30\n", runs="N10 N20 N30",
)

# Over-travel of the fourth and the fifth axis

for _axis, _sign, _number in (
    ("A", "", "3014"), ("B", "", "3015"), ("A", "-", "3019"), ("B", "-", "3020"),
):
    case(
        f"{_number} is the travel of {_axis} in {_sign or '+'} on the 980MDi",
        control=MDI, source="MDia 3011 to 3020; that A is the fourth, B the fifth is inferred",
        evidence="inferred",
        setup=MILL | {"start": {"A": 0, "B": 0}, "limits": {"A": (-90, 90), "B": (-90, 90)}},
        program=f"O1\nN10 G90 G0 {_axis}{_sign}80.\nN20 {_axis}{_sign}95.\nN30 M30\n",
        runs="N10", alarm="over-travel", number=_number, at="O1 N20",
    )
