"""Numbers with a limit: how many digits an address takes, and how large a computed value may be."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
GSK_988 = ["gsk-988ta", "gsk-988t"]
MITSUBISHI = ["mitsubishi-m700", "mitsubishi-m800"]
DIGITS = {c: "003" if c in ("fanuc-16i", *GSK_988) else "0003" if c == "gsk-980mdi" else "PS0003" for c in
          (*FANUC, *GSK_988, "gsk-980mdi")} | dict.fromkeys(MITSUBISHI, "P35")
RANGE = DIGITS | dict.fromkeys(FANUC[1:], "PS1305") | {"gsk-980mdi": "0012"}
EVERYWHERE = list(DIGITS)
SOURCE = "motion sheet 9, value out of range: 003, P35, 988T 003, 980MDi 012; ALM PS1305"
NINES = "9" * 100  # a GSK takes no block longer than 255 characters


def of(numbers, controls):
    """Return the alarm numbers of these controls alone."""
    return {c: numbers[c] for c in controls}


HERE = {"control": EVERYWHERE, "source": SOURCE, "evidence": "inferred"}

# Written numbers: P of an NC block is a number like another.
case(
    "the dwell P of a hundred nines has too many digits",
    **HERE,
    program="""
        O1
        N10 M9
        N20 G4 P9999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999
        N30 M30
    """,
    runs="N10", alarm="too-many-digits", number=DIGITS, at="O1 N20",
    word="P9999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999",
)
case(
    "the offset P of G10 of a hundred nines has too many digits",
    **HERE,
    program="""
        O1
        N10 M9
        N20 G10 L2 P1 X9999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999
        N30 M30
    """,
    runs="N10", alarm="too-many-digits", number=DIGITS, at="O1 N20",
    word="X9999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999",
)
case(
    "an axis of a hundred nines has too many digits",
    **HERE,
    program="""
        O1
        N10 M9
        N20 G0 X9999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999
        N30 M30
    """,
    runs="N10", alarm="too-many-digits", number=DIGITS, at="O1 N20",
    word="X9999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999",
)
case(
    "a feed of a hundred nines has too many digits",
    **HERE,
    program="""
        O1
        N10 M9
        N20 G1 F9999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999
        N30 M30
    """,
    runs="N10", alarm="too-many-digits", number=DIGITS, at="O1 N20",
    word="F9999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999",
)
case(
    "the data P of G10 of a hundred nines has too many digits",
    **HERE,
    program="""
        O1
        N10 M9
        N20 G10 L2 X1. P9999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999
        N30 M30
    """,
    runs="N10", alarm="too-many-digits", number=DIGITS, at="O1 N20",
    word="P9999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999",
)
case(
    "a speed of a hundred nines has too many digits",
    **HERE,
    program="""
        O1
        N10 M9
        N20 M3 S9999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999
        N30 M30
    """,
    runs="N10", alarm="too-many-digits", number=DIGITS, at="O1 N20",
    word="S9999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999",
)
case(
    "a tool of a hundred nines has too many digits",
    **HERE,
    program="""
        O1
        N10 M9
        N20 T9999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999
        N30 M30
    """,
    runs="N10", alarm="too-many-digits", number=DIGITS, at="O1 N20",
    word="T9999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999",
)
case(
    "the return point P of a hundred nines has too many digits",
    **HERE,
    program="""
        O1
        N10 M9
        N20 G30 X0 P9999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999
        N30 M30
    """,
    runs="N10", alarm="too-many-digits", number=DIGITS, at="O1 N20",
    word="P9999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999",
)
case(
    "the scale P of a hundred nines has too many digits",
    control=[*FANUC, *MITSUBISHI, "gsk-980mdi"], source=SOURCE, evidence="inferred",
    program=f"O1\nN10 M9\nN20 G51 X0 Y0 P{NINES}\nN30 M30", runs="N10", alarm="too-many-digits",
    number=of(DIGITS, [*FANUC, *MITSUBISHI, "gsk-980mdi"]), at="O1 N20", word=f"P{NINES}",
)
case(
    "an argument A of sixteen digits is more than a number holds",
    **HERE,
    program="O1\nN10 M9\nN20 G65 P2 A1234567890123456\nN30 M30\nO2\nN40 M99",
    runs="N10", alarm="too-many-digits", number=DIGITS, at="O1 N20", word="A1234567890123456",
)
case(
    "an argument D of sixteen digits is more than a number holds",
    **HERE,
    program="O1\nN10 M9\nN20 G65 P2 D1234567890123456\nN30 M30\nO2\nN40 M99",
    runs="N10", alarm="too-many-digits", number=DIGITS, at="O1 N20", word="D1234567890123456",
)
case(
    "an argument X of sixteen digits is more than a number holds",
    **HERE,
    program="O1\nN10 M9\nN20 G65 P2 X1234567890123456\nN30 M30\nO2\nN40 M99",
    runs="N10", alarm="too-many-digits", number=DIGITS, at="O1 N20", word="X1234567890123456",
)
case(
    "an argument Z of sixteen digits is more than a number holds",
    **HERE,
    program="O1\nN10 M9\nN20 G65 P2 Z1234567890123456\nN30 M30\nO2\nN40 M99",
    runs="N10", alarm="too-many-digits", number=DIGITS, at="O1 N20", word="Z1234567890123456",
)
case(
    "a dwell P of eight digits is one", control=FANUC, source=SOURCE, evidence="inferred",
    program="O1\nN10 G4 P99999999\nN20 M30", runs="N10 N20", time=99999.999,
)
case(
    "a dwell P of nine digits has one too many", control=FANUC[:2] + GSK_988, source=SOURCE,
    evidence="inferred", program="O1\nN10 M9\nN20 G4 P100000000\nN30 M30", runs="N10",
    alarm="too-many-digits", number=of(DIGITS, FANUC[:2] + GSK_988), at="O1 N20",
    word="P100000000",
)
case(
    "zeros in front of a P are no digits", **HERE,
    program=f"O1\nN10 G4 P{'0' * 100}1500\nN20 M30", runs="N10 N20", time=1.5,
)
case(
    "P of a call has the digits of programs and counts, not those of lengths",
    control=FANUC, source=SOURCE, evidence="inferred",
    program="O1\nN10 M98 P999999999999\nN20 M30", runs="", alarm="too-many-digits",
    number=of(DIGITS, FANUC), at="O1 N10", word="P999999999999",
)

# Computed values: a value that no digits could express is out of range.
case(
    "G0 X#1 is out of range with 10 to the 16th",
    **HERE,
    program="O1\nN10 M9\nN20 #1=[10000000*10000000*100]\nN30 G0 X#1\nN40 M30",
    runs="N10 N20", alarm="value-out-of-range", number=RANGE, at="O1 N30", word="X#1",
)
case(
    "G1 X1. F#1 is out of range with 10 to the 16th",
    **HERE,
    program="O1\nN10 M9\nN20 #1=[10000000*10000000*100]\nN30 G1 X1. F#1\nN40 M30",
    runs="N10 N20", alarm="value-out-of-range", number=RANGE, at="O1 N30", word="F#1",
)
case(
    "M3 S#1 is out of range with 10 to the 16th",
    **HERE,
    program="O1\nN10 M9\nN20 #1=[10000000*10000000*100]\nN30 M3 S#1\nN40 M30",
    runs="N10 N20", alarm="value-out-of-range", number=RANGE, at="O1 N30", word="S#1",
)
case(
    "T#1 is out of range with 10 to the 16th",
    **HERE,
    program="O1\nN10 M9\nN20 #1=[10000000*10000000*100]\nN30 T#1\nN40 M30",
    runs="N10 N20", alarm="value-out-of-range", number=RANGE, at="O1 N30", word="T#1",
)
case(
    "G4 P#1 is out of range with 10 to the 16th",
    **HERE,
    program="O1\nN10 M9\nN20 #1=[10000000*10000000*100]\nN30 G4 P#1\nN40 M30",
    runs="N10 N20", alarm="value-out-of-range", number=RANGE, at="O1 N30", word="P#1",
)
case(
    "G10 L2 P1 X#1 is out of range with 10 to the 16th",
    **HERE,
    program="O1\nN10 M9\nN20 #1=[10000000*10000000*100]\nN30 G10 L2 P1 X#1\nN40 M30",
    runs="N10 N20", alarm="value-out-of-range", number=RANGE, at="O1 N30", word="X#1",
)
case(
    "G52 Z#1 is out of range with 10 to the 16th",
    **HERE,
    program="O1\nN10 M9\nN20 #1=[10000000*10000000*100]\nN30 G52 Z#1\nN40 M30",
    runs="N10 N20", alarm="value-out-of-range", number=RANGE, at="O1 N30", word="Z#1",
)
case(
    "G2 I#1 is out of range with 10 to the 16th",
    **HERE,
    program="O1\nN10 M9\nN20 #1=[10000000*10000000*100]\nN30 G2 I#1\nN40 M30",
    runs="N10 N20", alarm="value-out-of-range", number=RANGE, at="O1 N30", word="I#1",
)
case(
    "a computed word takes what its digits could say", **HERE,
    program="O1\nN10 #1=99999.\nN20 G0 X#1\nN30 G0 X-#1\nN40 M30", runs="N10 N20 N30 N40",
    moves="R X99999\nR X-99999",
)
case(
    "increments add up to more than a word can say, and stay a number",
    control=FANUC, source="policy: no position is none", evidence="inferred", setup={"machine": "mill"},
    program="O1\nN10 G91\nN20 M98 P2 L200\nN30 M30\nO2\nN40 G0 X99999.999\nN50 M99",
    runs="N10 N20 (N40 N50)*200 N30", final_work="X19999999.8",
)
case(
    "a scale written over a scale replaces it, however often, and the moves end well",
    control=["fanuc-0i-f", "fanuc-30i"], source=SOURCE, evidence="inferred",
    setup={"machine": "mill"},
    program="""
        O1
        N10 G50
        N20 G51 X0 Y0 P99999999
        N30 G0 X99999.
        N40 G51 P99999999
        N50 G0 X-99999.
        N60 M99
    """,
    max_cycles=30, runs="(N10 N20 N30 N40 N50 N60)*30", stop="cycles",
)

# H of a GSK G65 is a code, not just any number.
case(
    "H-99999999999 is no code of a statement",
    control="gsk-980tdi", source="gsk sheet 4.5, table of H codes", evidence="secondary",
    program="O1\nN10 M9\nN20 G65 H-99999999999 P#100 Q1 R1\nN30 M30",
    runs="N10", alarm="illegal-h-code", number="0124", at="O1 N20", word="H-99999999999",
)
case(
    "H99999999999 is no code of a statement",
    control="gsk-980tdi", source="gsk sheet 4.5, table of H codes", evidence="secondary",
    program="O1\nN10 M9\nN20 G65 H99999999999 P#100 Q1 R1\nN30 M30",
    runs="N10", alarm="illegal-h-code", number="0124", at="O1 N20", word="H99999999999",
)
case(
    "H2147483648 is no code of a statement",
    control="gsk-980tdi", source="gsk sheet 4.5, table of H codes", evidence="secondary",
    program="O1\nN10 M9\nN20 G65 H2147483648 P#100 Q1 R1\nN30 M30",
    runs="N10", alarm="illegal-h-code", number="0124", at="O1 N20", word="H2147483648",
)
case(
    "H-1 is no code of a statement",
    control="gsk-980tdi", source="gsk sheet 4.5, table of H codes", evidence="secondary",
    program="O1\nN10 M9\nN20 G65 H-1 P#100 Q1 R1\nN30 M30",
    runs="N10", alarm="illegal-h-code", number="0124", at="O1 N20", word="H-1",
)
case(
    "H0 is no code of a statement",
    control="gsk-980tdi", source="gsk sheet 4.5, table of H codes", evidence="secondary",
    program="O1\nN10 M9\nN20 G65 H0 P#100 Q1 R1\nN30 M30",
    runs="N10", alarm="illegal-h-code", number="0124", at="O1 N20", word="H0",
)
case(
    "H2 adds", control="gsk-980tdi", source="gsk sheet 4.5, table of H codes", evidence="secondary",
    program="O1\nN10 G65 H2 P#100 Q1 R2\nN20 M30", runs="N10 N20", vars={100: 3},
)

case(
    "a word that leads beyond every position is refused in a plain move as in any other",
    control="linuxcnc", source="policy: no position is none", evidence="inferred",
    program=f"N10 G1 X1 F100\nN20 X{'9' * 100}\nN30 M2", runs="N10", alarm="value-out-of-range",
)
