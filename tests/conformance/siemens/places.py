"""SINUMERIK: where the fault of an expression points, and names that are no variable's."""

from conformance import case

ONE = "siemens-one"
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}
POLICY = {"control": ONE, "source": "policy, nobody says", "evidence": "inferred"}

for block, cause, number, word in [
    ("R1=1+2/0+3", "division-by-zero", "14051", "/"),
    ("R1=7 MOD 0", "division-by-zero", "14051", "MOD"),
    ("R1=7 DIV (R2)", "division-by-zero", "14051", "DIV"),
    ("X=1+2/R2 F100", "division-by-zero", "14051", "/"),
    ("R1=2+SQRT(-1)+3", "square-root-of-negative", "14051", "SQRT"),
    ("R1=1+LN(0)*2", "logarithm-of-non-positive", "14051", "LN"),
    ("R1=1+ASIN(2)", "arc-sine-out-of-range", "14051", "ASIN"),
    ("R1=1+R[1000]+2", "illegal-variable", None, "R"),
    ("R1=1+R1000+2", "illegal-variable", None, "R1000"),
    ("R1=1+GRID[R2+5]+1", "array-element", "12400", "R2"),
    ("R1=2*TXT+1", "type-mismatch", "12150", "*TXT"),
    ("R1=1+SIN(TXT)+2", "type-mismatch", "12150", "TXT"),
    ("R1=2+SIN[30]+1", "bracket-not-opened", "12080", "SIN"),
    ("R1=1+FOO+2", "code-not-computed", None, "FOO"),
    ("CNT=1+3000000000*2", "value-out-of-range", None, "1+3000000000*2"),
    ("WHILE 1/R2", "division-by-zero", "14051", "/"),
    ('MSG("A"<<1/R2)', "division-by-zero", "14051", "/"),
]:
    case(
        f"the fault of {block} points at {word}", **KNOWN,
        program=f"N1 DEF INT CNT\nN2 DEF REAL GRID[3]\nN3 DEF STRING[10] TXT\nN10 G0 X1\nN20 {block}\nN30 M30",
        runs="N1 N2 N3 N10", alarm=cause, number=number, at="MAIN N20", word=word,
    )

for word in ["TRANS", "GOTOF", "BRISK", "LIMS", "TRAORI", "SAVE"]:
    case(
        f"{word} is a word of the language, and no name of a variable", **KNOWN,
        program=f"N10 DEF REAL {word}\nN20 M30", runs="", alarm="illegal-variable-name", at="MAIN N10", word=word,
    )
case(
    "a variable may have the name of a function", **POLICY,
    program="N10 DEF REAL NUMBER=5\nN20 G0 X=NUMBER\nN30 M30", moves="R X5",
)
