"""grblHAL: operators and functions."""

from conformance import case

RUN = {"control": "grblhal", "source": "gHx, ngc_eval_expression", "evidence": "source document"}
UNARY = {"control": "grblhal", "source": "gHx, execute_unary", "evidence": "source document"}

for value, result in {
    "1+2*3": 7, "2**3*2": 16, "2**3**2": 64, "7 MOD 3": 1, "-7 MOD 3": 2, "10-4-3": 3, "8/4/2": 1,
    "1 EQ 1.00001": 1, "1 EQ 1.001": 0, "1 NE 2": 1, "1 LT 2": 1, "2 LE 2": 1, "3 GT 2": 1, "2 GE 3": 0,
    "1 AND 2": 1, "1 AND 0": 0, "0 OR 3": 1, "1 XOR 1": 0, "1 OR 0 AND 0": 0, "1+1 EQ 2": 1, "--5": 5,
    "SQRT[16]": 4, "ABS[-3]": 3, "FIX[-1.5]": -2, "FUP[-1.5]": -1, "ROUND[-1.5]": -2, "ROUND[2.5]": 3,
    "ATAN[1]/[1]": 45, "ATAN[-1]/[-1]": -135, "ACOS[0]": 90, "ASIN[1]": 90, "LN[1]": 0, "EXP[0]": 1,
    "COS[60]*2": 1, "SIN[30]*2": 1, "TAN[45]": 1,
}.items():
    case(f"[{value}] is {result} on grblHAL", **RUN, program=f"N10 #100=[{value}]\nN20 M2", vars={100: result})
case("a power of a negative value has a whole exponent", **RUN,
     program="N10 #100=[-2**0.5]\nN20 M2", runs="", alarm="power-of-negative", number="error:74")
case("nothing is divided by zero", **RUN,
     program="N10 #100=[1/0]\nN20 M2", runs="", alarm="division-by-zero", number="error:72", at="MAIN N10")
case("a rest of zero is no number", **RUN,
     program="N10 #100=[1 MOD 0]\nN20 M2", runs="", alarm="argument-out-of-range", number="error:76")
case("a negative value has no root", **UNARY,
     program="N10 #100=SQRT[-1]\nN20 M2", runs="", alarm="square-root-of-negative", number="error:73")
case("zero has no logarithm", **UNARY,
     program="N10 #100=LN[0]\nN20 M2", runs="", alarm="logarithm-of-non-positive", number="error:73")
case("a sine is at most 1", **UNARY,
     program="N10 #100=ASIN[2]\nN20 M2", runs="", alarm="arc-sine-out-of-range", number="error:73")
case("an operator that it has not is unknown", **RUN,
     program="N10 #100=[1%2]\nN20 M2", runs="", alarm="expression-format", number="error:71", at="MAIN N10")
case("so is a bracket that is not closed", **RUN,
     program="N10 #100=[1+2\nN20 M2", runs="", alarm="expression-format", number="error:71", at="MAIN N10")
case("and a function that it has not", **RUN,
     program="N10 #100=FOO[1]\nN20 M2", runs="", alarm="expression-format", number="error:71", at="MAIN N10")
case("a function has a bracket", **RUN,
     program="N10 #100=SIN 30\nN20 M2", runs="", alarm="bracket-not-closed", number="error:75", at="MAIN N10")
case("ATAN has two", **RUN,
     program="N10 #100=ATAN[1]\nN20 M2", runs="", alarm="bracket-not-closed", number="error:75", at="MAIN N10")
case("words may be expressions", **RUN, program="N10 #1=2\nN20 G[#1-2] X[#1*3]\nN30 M2", moves_x=[6])
case("settings of the machine are told", **RUN,
     program="N10 #100=PRM[110]\nN20 M2", runs="", alarm="code-not-computed", at="MAIN N10")
