"""GSK: expressions and functions."""

from conformance import case

TA, T, TDI, MDI = "gsk-988ta", "gsk-988t", "gsk-980tdi", "gsk-980mdi"
FAMILY_988 = [TA, T]
FAMILY_980 = [TDI, MDI]
FAMILIES = [TA, T, TDI, MDI]
MANUAL = "maker's manual"
SECONDARY = "secondary"
INFERRED = "inferred"


def both(number_988, number_980):
    """Return one alarm number for the 988s, and one for the 980s."""
    return {TA: number_988, T: number_988, TDI: number_980, MDI: number_980}


def function(claim, expression, value, control=FAMILIES, **row):
    """Write a row of one assignment to #100."""
    row = {"source": "TDi29, arithmetic", "evidence": MANUAL, **row}
    case(
        f"GSK: {claim}",
        pins="angle_unit functions",
        control=control, program=f"O1\nN10 #100={expression}\nN20 M30\n",
        variables={101: -1.2}, runs="N10 N20", vars={100: value}, **row,
    )


function("multiplication comes before addition", "2+3*4", 14)
function("brackets come first", "[2+3]*4", 20)
function("a difference is computed from the left", "10-4-3", 3)
function("a quotient is computed from the left", "24/4/2", 3)
function("SQRT takes the square root", "SQRT[6.25]", 2.5)
function("ABS takes the sign away", "ABS[#101]", 1.2)
function("ROUND rounds at the first decimal, down", "ROUND[1.2345]", 1)
function("ROUND rounds at the first decimal, up", "ROUND[2.5]", 3)
function("FUP rounds away from zero", "FUP[1.2]", 2)
function("FUP of a negative value rounds away from zero", "FUP[#101]", -2)
function("FIX rounds towards zero", "FIX[1.9]", 1)
function("FIX of a negative value rounds towards zero", "FIX[#101]", -1)
function("FUP leaves a whole number alone", "FUP[3]", 3)
function("LN is the natural logarithm", "LN[10]", 2.3025851)
function("EXP is the exponential", "EXP[2]", 7.3890561)
function("SIN takes degrees", "SIN[30]", 0.5)
function("COS takes degrees", "COS[60]", 0.5)
function("TAN takes degrees", "TAN[45]", 1)
function("degrees have decimals, not minutes", "SIN[90.5]", 0.9999619)
function("ASIN gives degrees", "ASIN[0.5]", 30)
function("ACOS gives degrees from 0 to 180", "ACOS[-0.5]", 120)
function("ATAN takes two lengths", "ATAN[3]/[4]", 36.8698976)
function("OR works bit by bit", "12 OR 10", 14, control=TDI)
function("AND works bit by bit", "12 AND 10", 8, control=TDI)
function("XOR works bit by bit", "12 XOR 10", 6, control=TDI)
function("BIN reads four bits as a decimal digit", "BIN[24]", 18, evidence=INFERRED)
function("BCD writes a decimal digit in four bits", "BCD[18]", 24, evidence=INFERRED)
function("functions may stand inside each other", "SQRT[ABS[#101*30]]", 6)
function(
    "with 180#7=0 ATAN goes from 0 to 360", "ATAN[-1]/[-1]", 225, control=TDI, params={"180#7": 0}
)
function(
    "with 180#7=1 ATAN goes from -180 to 180",
    "ATAN[-1]/[-1]", -135, control=TDI, params={"180#7": 1},
)
case(
    "GSK 980TDi: RAND lies above zero and not above its argument",
    control=TDI, source="TDi29, random numbers", evidence=MANUAL,
    program="""
        O1
        N10 #100=RAND[10]
        N20 IF[#100 LE 0]THEN #3000=1
        N30 IF[#100 GT 10]THEN #3000=2
        N40 M30
    """,
    runs="N10 N20 N30 N40",
)
case(
    "GSK 980TDi: SRAND lies between its two arguments",
    control=TDI, source="TDi29, random numbers", evidence=MANUAL,
    program="""
        O1
        N10 #100=SRAND[5,6]
        N20 IF[#100 LT 5]THEN #3000=1
        N30 IF[#100 GT 6]THEN #3000=2
        N40 M30
    """,
    runs="N10 N20 N30 N40",
)


def bad_function(claim, expression, cause, number, control=FAMILIES, **row):
    """Write a row of one assignment to #100 that alarms and does not change #100."""
    if not isinstance(number, str):
        row = {"source": f"Talm {number[TA]}; MDia {number[TDI]}", **row}
    row = {"source": f"MDia {number}", "evidence": SECONDARY, **row}
    case(
        f"GSK: {claim}",
        pins="max_brackets refuses:logic-of-negative",
        control=control, program=f"O1\nN10 #100=3\nN20 #100={expression}\nN30 M30\n",
        runs="N10", alarm=cause, number=number, at="O1 N20", vars={100: 3}, **row,
    )


bad_function("a division by zero is an alarm", "5/0", "division-by-zero", both("014", "0105"))
bad_function(
    "a division by a difference of zero is an alarm",
    "5/[#100-3]", "division-by-zero", both("014", "0105"),
)
bad_function(
    "the square root of a negative value is an alarm",
    "SQRT[0-4]", "square-root-of-negative", both("206", "0108"),
)
bad_function("TAN of 90 degrees is an alarm", "TAN[90]", "tangent-infinite", both("014", "0109"))
bad_function(
    "LN of zero is an alarm", "LN[0]", "logarithm-of-non-positive", "0107",
    control=FAMILY_980, evidence=MANUAL,
)
bad_function(
    "LN of a negative value is an alarm", "LN[0-1]", "logarithm-of-non-positive", "0107",
    control=FAMILY_980, evidence=MANUAL,
)
bad_function(
    "ASIN above 1 is an alarm", "ASIN[1.01]", "arc-sine-out-of-range", "0110",
    control=FAMILY_980, evidence=MANUAL,
)
bad_function(
    "ACOS below -1 is an alarm", "ACOS[0-1.01]", "arc-sine-out-of-range", "0110",
    control=FAMILY_980, evidence=MANUAL,
)
bad_function(
    "BIN of decimals is an alarm", "BIN[1.5]", "argument-out-of-range", "0127",
    control=FAMILY_980, evidence=MANUAL,
)
bad_function(
    "BIN of bits that are no decimal digit is an alarm", "BIN[10]", "argument-out-of-range", "206",
    control=FAMILY_988, source="Talm 206",
)
bad_function(
    "BCD of a negative value is an alarm", "BCD[0-1]", "argument-out-of-range", "206",
    control=FAMILY_988, source="Talm 206",
)
bad_function(
    "OR with a negative value is an alarm",
    "5 OR [0-3]", "logic-of-negative", "217", control=FAMILY_988, source="Talm 217",
)
bad_function(
    "XOR with a negative value is an alarm",
    "5 XOR [0-3]", "logic-of-negative", "217", control=FAMILY_988, source="Talm 217",
)
bad_function(
    "AND with a negative value is an alarm",
    "5 AND [0-3]", "logic-of-negative", "217", control=FAMILY_988, source="Talm 217",
)
bad_function("a result above 1e308 is an alarm", "EXP[1000]", "overflow", both("221", "0043"))
bad_function(
    "a result above 1e47 is no value of a variable", "EXP[110]", "overflow", "221",
    control=TA, source="Talm 221; TApar 6008#0, its value 1",
)
case(
    "GSK 988TA: inside an expression a result above 1e47 is legal",
    control=TA, source="Talm 221; TApar 6008#0, its value 0", evidence=MANUAL,
    program="O1\nN10 #100=LN[EXP[110]]\nN20 M30\n", runs="N10 N20", vars={100: 110},
)
bad_function(
    "six brackets inside each other are too many", "[[[[[[1]]]]]]", "brackets-too-deep", "205",
    control=FAMILY_988, source="Talm 205",
)
function(
    "five brackets inside each other are legal", "[[[[[1]]]]]", 1,
    control=FAMILY_988, source="Talm 205", evidence=SECONDARY,
)
bad_function(
    "a bracket that is not closed is an alarm", "[2+3", "bracket-not-closed", "0104",
    control=FAMILY_980, evidence=MANUAL,
)
bad_function(
    "a bracket that is not opened is an alarm", "2+3]", "bracket-not-opened", "0104",
    control=FAMILY_980, evidence=MANUAL,
)
bad_function(
    "an operator without its second value is an alarm", "2+", "expression-format",
    both("202", "0101"),
)
bad_function(
    "two operators in a row are an alarm", "2*/3", "expression-format", both("202", "0101"),
)
