"""Numbers with an end: how many digits an address takes, and what a computed value may be."""

from conformance import case

FANUC = ["fanuc-16i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-30i"]
GSK_988 = ["gsk-988ta", "gsk-988t"]
MITSUBISHI = ["mitsubishi-m700", "mitsubishi-m800"]
DIGITS = {c: "003" if c in ("fanuc-16i", *GSK_988) else "0003" if c == "gsk-980mdi" else "PS0003" for c in
          (*FANUC, *GSK_988, "gsk-980mdi")} | dict.fromkeys(MITSUBISHI, "P35")
RANGE = DIGITS | dict.fromkeys(FANUC[1:], "PS1305") | {"gsk-980mdi": "0012"}
EVERYWHERE = list(DIGITS)
SOURCE = "motion sheet 9, value out of range: 003, P35, 988T 003, 980MDi 012; ALM PS1305"
NINES = "9" * 100  # a GSK takes no longer block than 255 characters


def of(numbers, controls):
    """The alarm numbers of these controls alone."""
    return {c: numbers[c] for c in controls}


HERE = {"control": EVERYWHERE, "source": SOURCE, "evidence": "inferred"}

# Written numbers: P of an NC block is a number like another.

for claim, block, word in [
    ("the dwell P", "G4 P", "P"),
    ("the offset P of G10", "G10 L2 P1 X", "X"), ("an axis", "G0 X", "X"), ("a feed", "G1 F", "F"),
    ("the data P of G10", "G10 L2 X1. P", "P"), ("a speed", "M3 S", "S"), ("a tool", "T", "T"),
    ("the return point P", "G30 X0 P", "P"),
]:
    case(
        f"{claim} of a hundred nines has too many digits", **HERE,
        program=f"O1\nN10 M9\nN20 {block}{NINES}\nN30 M30", runs="N10", alarm="too-many-digits",
        number=DIGITS, at="O1 N20", word=f"{word}{NINES}",
    )
case(
    "the scale P of a hundred nines has too many digits",
    control=[*FANUC, *MITSUBISHI, "gsk-980mdi"], source=SOURCE, evidence="inferred",
    program=f"O1\nN10 M9\nN20 G51 X0 Y0 P{NINES}\nN30 M30", runs="N10", alarm="too-many-digits",
    number=of(DIGITS, [*FANUC, *MITSUBISHI, "gsk-980mdi"]), at="O1 N20", word=f"P{NINES}",
)
for letter in "ADXZ":
    case(
        f"an argument {letter} of sixteen digits is more than a number holds", **HERE,
        program=f"O1\nN10 M9\nN20 G65 P2 {letter}1234567890123456\nN30 M30\nO2\nN40 M99",
        runs="N10", alarm="too-many-digits", number=DIGITS, at="O1 N20",
        word=f"{letter}1234567890123456",
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

# Computed values: what no digits could say is out of range.

for block in ["G0 X#1", "G1 X1. F#1", "M3 S#1", "T#1", "G4 P#1", "G10 L2 P1 X#1", "G52 Z#1", "G2 I#1"]:
    case(
        f"{block} is out of range with 10 to the 16th", **HERE,
        program=f"O1\nN10 M9\nN20 #1=[10000000*10000000*100]\nN30 {block}\nN40 M30", runs="N10 N20",
        alarm="value-out-of-range", number=RANGE, at="O1 N30", word=f"{block[block.index('#') - 1]}#1",
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

for number in ("-99999999999", "99999999999", "2147483648", "-1", "0"):
    case(
        f"H{number} is no code of a statement",
        control="gsk-980tdi", source="gsk sheet 4.5, table of H codes", evidence="secondary",
        program=f"O1\nN10 M9\nN20 G65 H{number} P#100 Q1 R1\nN30 M30", runs="N10",
        alarm="illegal-h-code", number="0124", at="O1 N20", word=f"H{number}",
    )
case(
    "H2 adds", control="gsk-980tdi", source="gsk sheet 4.5, table of H codes", evidence="secondary",
    program="O1\nN10 G65 H2 P#100 Q1 R2\nN20 M30", runs="N10 N20", vars={100: 3},
)
