"""FANUC: numbers, signs, points, repeated addresses, M codes in one block."""

from conformance import case

ALL = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
NEW = ["fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
LATE = ["fanuc-0i-f", "fanuc-30i"]


def numbers(old, new):
    """Return the number of the 16i, and the one that the 0i-D, the 0i-F and the 30i share."""
    return {"fanuc-16i": old, **dict.fromkeys(ALL[1:], new)}


case(
    "P without a number has no data",
    control=ALL, source="ALM PS0005", evidence="secondary",
    program="""
        O1
        N10 M98 P
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="address-without-value", number=numbers("005", "PS0005"), at="O1 N10", word="P",
)
case(
    "L without a number has no data",
    control=ALL, source="ALM PS0005", evidence="secondary",
    program="""
        O1
        N10 M98 P2 L
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="address-without-value", number=numbers("005", "PS0005"), at="O1 N10", word="L",
)
case(
    "the P of M99 without a number has no data",
    control=ALL, source="ALM PS0005", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M99 P
    """,
    runs="N10", alarm="address-without-value", number=numbers("005", "PS0005"), at="O2 N30",
)
case(
    "a point at the P of M98 is illegal",
    control=ALL, source="ALM PS0007", evidence="secondary",
    program="""
        O1
        N10 M98 P2.
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-decimal-point", number=numbers("007", "PS0007"), at="O1 N10",
    word="P2.",
)
case(
    "a point at L is illegal",
    control=ALL, source="ALM PS0007", evidence="secondary",
    program="""
        O1
        N10 M98 P2 L2.
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-decimal-point", number=numbers("007", "PS0007"), at="O1 N10",
    word="L2.",
)
case(
    "a point at the P of M99 is illegal",
    control=ALL, source="ALM PS0007", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M99 P20.
    """,
    runs="N10", alarm="illegal-decimal-point", number=numbers("007", "PS0007"), at="O2 N30",
    word="P20.",
)
case(
    "a point at M is illegal",
    control=ALL, source="ALM PS0007, SIN", evidence="secondary",
    program="""
        O1
        N10 M98. P2
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-decimal-point", number=numbers("007", "PS0007"), at="O1 N10",
    word="M98.",
)
case(
    "two points in one number are illegal",
    control=ALL, source="ALM PS0007, SIN", evidence="secondary",
    program="""
        O1
        N10 X1.5. M98 P2
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-decimal-point", number=numbers("007", "PS0007"), at="O1 N10",
)
case(
    "a minus sign at L is illegal",
    control=ALL, source="ALM PS0006", evidence="secondary",
    program="""
        O1
        N10 M98 P2 L-1
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-minus-sign", number=numbers("006", "PS0006"), at="O1 N10", word="L-1",
)
case(
    "a minus sign at the P of M99 is illegal",
    control=ALL, source="ALM PS0006", evidence="secondary",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M99 P-20
    """,
    runs="N10", alarm="illegal-minus-sign", number=numbers("006", "PS0006"), at="O2 N30",
    word="P-20",
)
case(
    "a minus sign at M is illegal",
    control=ALL, source="ALM PS0006", evidence="secondary",
    program="""
        O1
        N10 M-98 P2
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-minus-sign", number=numbers("006", "PS0006"), at="O1 N10",
)
case(
    "a number without an address cannot start a block",
    control=ALL, source="ALM PS0004; K-H general knowledge", evidence="secondary",
    program="""
        O1
        N10 T1
        5 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    runs="N10", alarm="value-without-address", number=numbers("004", "PS0004"), at="O1",
)
case(
    "nine digits at P are too many on the 16i",
    pins="max_program_digits",
    control="fanuc-16i", source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P123450002
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="too-many-digits", number="003", at="O1 N10",
)
case(
    "ten digits at P are too many",
    control=LATE, source="ALM PS0003; K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P1234500002
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="too-many-digits", number="PS0003", at="O1 N10",
)
case(
    "N needs a number: a variable is refused",
    control=NEW, source="ALM PS1014; TSN, NCT", evidence="secondary",
    program="""
        O1
        N10 #3=20
        N#3 M3
        N30 M30
    """,
    runs="N10", alarm="illegal-sequence-number", number="PS1014", at="O1",
)
case(
    "of two P in a block the later counts",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2 P3
        N20 M30
        O2
        N30 M99
        O3
        N40 M99
    """,
    runs="N10 N40 N20", calls="M98:O3",
)
case(
    "of two L in a block the later counts",
    control=ALL, source="K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 M98 P2 L4 L2
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30*2 N20",
)
case(
    "with 3403#6=1 two P in a block alarm",
    control=ALL, source="ALM PS5074; K-H parameter", evidence="inferred",
    program="""
        O1
        N10 M98 P2 P3
        N20 M30
        O2
        N30 M99
        O3
        N40 M99
    """,
    params={"3403#6": 1}, runs="", alarm="address-given-twice", number=numbers("5074", "PS5074"),
    at="O1 N10", word="P3",
)
case(
    "with 3403#6=1 two L in a block alarm",
    control=ALL, source="ALM PS5074; K-H parameter", evidence="inferred",
    program="""
        O1
        N10 M98 P2 L2 L2
        N20 M30
        O2
        N30 M99
    """,
    params={"3403#6": 1}, runs="", alarm="address-given-twice", number=numbers("5074", "PS5074"),
    at="O1 N10",
)
case(
    "with 3403#6=1 two G codes of one group alarm",
    control=ALL, source="ALM PS5074", evidence="secondary",
    program="""
        O1
        N10 G90 G91 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    params={"3403#6": 1}, runs="", alarm="address-given-twice", number=numbers("5074", "PS5074"),
    at="O1 N10",
)
case(
    "with 3403#6=1 two G codes of different groups alarm nothing",
    control=ALL, source="ALM PS5074; K-H general knowledge", evidence="inferred",
    program="""
        O1
        N10 G90 G0 M98 P2
        N20 M30
        O2
        N30 M99
    """,
    params={"3403#6": 1}, runs="N10 N30 N20",
)
case(
    "27 words make a block with too many words",
    pins="max_words",
    control=ALL, source="ALM PS5006", evidence="secondary",
    program="""
        O1
        N10 X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.
        N20 M30
    """,
    runs="", alarm="too-many-words", number=numbers("5006", "PS5006"), at="O1 N10",
)
case(
    "20 words in a block are not too many",
    control=ALL, source="ALM PS5006", evidence="secondary",
    program="""
        O1
        N10 M98 P2 X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.X1.
        N20 M30
        O2
        N30 M99
    """,
    runs="N10 N30 N20",
)
case(
    "with 3404#7=1 three M codes of a block go out in the order written",
    control=ALL, source="CEX487; K-H parameter", evidence="maker's manual",
    program="""
        O1
        N10 M8 M3 M7
        N20 M30
    """,
    params={"3404#7": 1}, runs="N10 N20", m=[8, 3, 7],
)
case(
    "with 3404#7=0 the last M code of a block goes out",
    control=ALL, source="K-M general knowledge", evidence="inferred",
    program="""
        O1
        N10 M8 M3
        N20 M30
    """,
    runs="N10 N20", m=[3],
)
case(
    "M98 and a machine M code cannot share a block",
    pins="extra_m_codes",
    control=ALL, source="ALM PS5016; K-H list", evidence="inferred",
    program="""
        O1
        N10 M98 P2 M8
        N20 M30
        O2
        N30 M99
    """,
    runs="", alarm="illegal-m-combination", number=numbers("5016", "PS5016"), at="O1 N10", m=[],
)
case(
    "M99 and a machine M code cannot share a block",
    control=ALL, source="ALM PS5016; K-H list", evidence="inferred",
    program="""
        O1
        N10 M98 P2
        N20 M30
        O2
        N30 M9 M99
    """,
    runs="N10", alarm="illegal-m-combination", number=numbers("5016", "PS5016"), at="O2 N30", m=[],
)
case(
    "M30 and a machine M code cannot share a block, not even with three M codes allowed",
    control=ALL, source="ALM PS5016; K-H list", evidence="inferred",
    program="""
        O1
        N10 T1
        N20 M5 M30
    """,
    params={"3404#7": 1}, runs="N10", alarm="illegal-m-combination",
    number=numbers("5016", "PS5016"), at="O1 N20", m=[],
)
case(
    "M198 and a machine M code cannot share a block",
    control=ALL, source="ALM PS5016; K-H list", evidence="inferred",
    program="""
        O1
        N10 M198 P2 M8
        N20 M30
    """,
    external={"O2.NC": "O2\nN30 M99\n"}, runs="", alarm="illegal-m-combination",
    number=numbers("5016", "PS5016"), at="O1 N10",
)
case(
    "an M code that calls a subprogram and a machine M code cannot share a block",
    control=ALL, source="ALM PS5016; K-H list", evidence="inferred",
    program="""
        O1
        N10 M60 M8
        N20 M30
        O9001
        N30 M99
    """,
    params={"6071": 60, "3404#7": 1}, runs="", alarm="illegal-m-combination",
    number=numbers("5016", "PS5016"), at="O1 N10", m=[],
)

case(
    "leading zeros of G, M and P mean nothing (F012)",
    control=["fanuc-16i", "fanuc-30i"],
    source="GED",
    evidence="secondary",
    program="""
        O1
        G00 X1.
        G0 X2.
        M003
        M3
        M98 P0010
        M30
        O10
        N5 M99
    """,
    runs="N5",
    m=[3, 3],
)

case(
    "two decimal points in one number alarm (F014)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0007; SIN; 16i: general knowledge of the FANUC manuals",
    evidence="maker's manual",
    program="""
        O1
        G0 X1.2.3
        M30
    """,
    alarm="illegal-decimal-point",
    number={"fanuc-16i": "007", "fanuc-30i": "PS0007"},
    at="O1",
    word="X1.2.3",
)

case(
    "an address without a value alarms (F015)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0005; 16i: general knowledge of the FANUC manuals",
    evidence="maker's manual",
    program="""
        O1
        G0 X Y1.
        M30
    """,
    alarm="address-without-value",
    number={"fanuc-16i": "005", "fanuc-30i": "PS0005"},
    at="O1",
)

case(
    "a number of ten digits alarms (F016)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0003; 16i and the number of digits: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        G0 X1234567890
        M30
    """,
    alarm="too-many-digits",
    number={"fanuc-16i": "003", "fanuc-30i": "PS0003"},
    at="O1",
)

case(
    "a minus sign at the P of M98 alarms (F017)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0006; 16i: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        M98 P-10
        M30
        O10
        M99
    """,
    alarm="illegal-minus-sign",
    number={"fanuc-16i": "006", "fanuc-30i": "PS0006"},
    at="O1",
)

case(
    "a G code that the control does not have alarms (F018)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS0010; 16i: general knowledge of the FANUC manuals",
    evidence="maker's manual",
    program="""
        O1
        G777
        M30
    """,
    alarm="g-code-not-available",
    number={"fanuc-16i": "010", "fanuc-30i": "PS0010"},
    at="O1",
)

case(
    "the same address twice alarms while 3403#6 is 1 (F021)",
    control=["fanuc-16i", "fanuc-30i"],
    source="ALM PS5074; 3403#6 AD2: general knowledge of the FANUC manuals",
    evidence="secondary",
    program="""
        O1
        G0 X1. X2.
        M30
    """,
    params={"3403#6": 1},
    alarm="address-given-twice",
    number={"fanuc-16i": "5074", "fanuc-30i": "PS5074"},
    at="O1",
)

case(
    "of the same address twice the later word counts while 3403#6 is 0 (F022)",
    control=["fanuc-16i", "fanuc-30i"],
    source="3403#6 AD2: general knowledge of the FANUC manuals",
    evidence="inferred",
    program="""
        O1
        G0 X1. X2.
        M30
    """,
    moves="R X2",
)

# Two signs

SIGNS = "PS-ZH 006: two or more minus signs"
for _word, _said in [("X--5.", "X--5."), ("X-+5.", "X-+5."), ("F--100", "F--100"), ("M--8", "M--8"),
                     ("G--1", "G--1"), ("S--5", "S--5"), ("X--#100", "X--#100"), ("X- -5.", "X- -5.")]:
    case(
        f"{_word} has two signs",
        control=ALL, source=SIGNS, evidence="secondary" if "+" not in _word else "inferred",
        program=f"O1\nN10 M8\nN20 {_word}\nN30 M30", variables={100: 1},
        runs="N10", m=[8], alarm="two-signs", number=numbers("006", "PS0006"), at="O1 N20", word=_said,
    )
case(
    "a sequence number with two signs",
    control=ALL, source=SIGNS, evidence="secondary",
    program="O1\nN10 M8\nN--20 M9\nN30 M30",
    runs="N10", m=[8], alarm="two-signs", number=numbers("006", "PS0006"),
)
case(
    "an argument with two signs",
    control=ALL, source=SIGNS, evidence="secondary",
    program="O1\nN10 M8\nN20 G65 P2 A--1.\nN30 M30\nO2\nM99",
    runs="N10", m=[8], alarm="two-signs", number=numbers("006", "PS0006"), word="A--1.",
)
case(
    "a sign without a number has no data",
    control=ALL, source="ALM PS0005", evidence="inferred",
    program="O1\nN10 M8\nN20 X-\nN30 M30",
    runs="N10", m=[8], alarm="address-without-value", number=numbers("005", "PS0005"), word="X-",
)

# Addresses of whole numbers round the value of an expression

WHOLE = "SIN: an expression at an address of whole numbers is rounded, S#1 with #1 = 1000.5 is S1001"
for _value, _is in [("1000.4999", 1000), ("1000.5", 1001), ("999.6", 1000)]:
    case(
        f"S#1 with #1={_value} is S{_is}",
        control=ALL, source=WHOLE, evidence="secondary",
        program=f"O1\nN10 #1={_value}\nN20 G97 S#1 M3\nN30 #100=#4119\nN40 S[#1]\nN50 #101=#4119\nN60 M30",
        runs="N10 N20 N30 N40 N50 N60", vars={100: _is, 101: _is},
    )
case(
    "P of a dwell from an expression is rounded to whole milliseconds",
    pins="computed_whole", control=ALL, source=WHOLE, evidence="secondary", setup={"machine": "mill"},
    program="O1\nN10 #1=1500.6\nN20 G4 P#1\nN30 G4 P[#1-1500.2]\nN40 M30",
    runs="N10 N20 N30 N40", moves="W 1.501",
)
case(
    "a feed per revolution counts the speed that S of an expression is rounded to",
    pins="computed_whole", control=ALL, source=WHOLE, evidence="secondary", setup={"machine": "mill"},
    program="O1\nN10 #1=99.6\nN20 G97 S#1 M3\nN30 G95 G1 X100. F1.\nN40 M30",
    runs="N10 N20 N30 N40", time=60,
)

# Numbers of offsets, systems and tools, and counts

for _what, _setup, _program, _said in [
    ("the length offset of H", {"machine": "mill", "length_offsets": {1: 10.0, 2: 20.0}},
     "G43 Z0 H#1", {"final_machine": "Z20"}),
    ("the radius offset of D", {"machine": "mill", "radius_offsets": {1: 1.0, 2: 2.0}},
     "G41 G1 X10. F100 D#1\nG1 Y10.", {"final_machine": "X8 Y10"}),
    ("the extra system of P", {"machine": "mill"},
     "G10 L20 P1 X1.\nG10 L20 P2 X2.\nG54.1 P#1 G0 X0", {"final_machine": "X2"}),
    ("the offset of T", {"machine": "lathe-a", "tools": {1: {"X": 1}, 2: {"X": 2}}},
     "T[100+#1]\nG0 X0", {"final_machine": "X2"}),
    ("L of G10", {"machine": "mill"}, "G10 L#1 P1 X3.\nG0 X0", {"final_machine": "X3"}),
]:
    case(
        f"{_what} from an expression is rounded",
        control=NEW, source=WHOLE, evidence="inferred", setup=_setup,
        program=f"O1\nN10 #1=1.6\n{_program}\nN20 M30", runs="N10 N20", **_said,
    )
case(
    "a repeat count of a canned cycle from an expression is rounded",
    control=ALL, source=WHOLE, evidence="inferred", setup={"machine": "mill"},
    program="O1\nN10 #1=2.6\nN20 G91 G81 X1. Z-1. R-1. F100 K#1\nN30 M30",
    runs="N10 N20 N30", final_work="X3",
)
case(
    "sequence numbers of a profile from expressions are rounded",
    control=ALL, source=WHOLE, evidence="inferred", setup={"machine": "lathe-a", "start": {"X": 20, "Z": 2}},
    program="""
        O1
        N5 #1=2.9999999
        N10 G70 P[#1*10] Q[#1*10+10] F10.
        N15 M30
        N30 G0 X10.
        N40 G1 Z-10.
    """,
    runs="N5 N10 N15", moves="R X10\nF Z-10\nR X20 Z2",
)
