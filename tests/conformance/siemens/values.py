"""SINUMERIK: R parameters and expressions."""

from conformance import case

ONE = "siemens-one"
ORDER = {"control": ONE, "source": "NCI, precedence.mpf: the manual's order of operations", "evidence": "secondary"}
ALIKE = {"control": ONE, "source": "NCI, test_real_comparisons.py: values that differ by 1E-12 of their size are alike",
         "evidence": "secondary"}
KNOWN = {"control": ONE, "source": "general knowledge of the SINUMERIK 840D", "evidence": "inferred"}

case(
    "* / DIV MOD come before + and -, and of those alike the first", **ORDER,
    program="N10 R1=2+3*4 R2=10-6/2 R3=2+6 DIV 4 R4=1+7 MOD 4 R5=(2+3)*4 R6=100-10*2+5 R7=2*-3 R8=-2+3\nN20 M30",
    vars={1: 14, 2: 7, 3: 3, 4: 4, 5: 20, 6: 85, 7: -6, 8: 1},
)
case(
    "AND comes before XOR, and that before OR; comparisons are last", control=ONE,
    source="NCI, interpreter.rs: the manual's priority table 4.1.3.3", evidence="secondary",
    program="N10 R1=1 OR 0 AND 0 R2=1 XOR 1 OR 1 R3=(2>1) AND (1>2) R4=NOT 0\nN20 M30", vars={1: 1, 2: 1, 3: 0, 4: 1},
)
case(
    "values that differ by a hair are equal", **ALIKE,
    program="N10 R9=0.1+0.2\nN20 R1=R9==0.3 R2=R9<>0.3 R3=R9<=0.3 R4=R9>=0.3 R5=R9>0.3 R6=R9<0.3\nN30 M30",
    vars={1: 1, 2: 0, 3: 1, 4: 1, 5: 0, 6: 0},
)
case(
    "those that differ by more are not", **ALIKE,
    program="N20 R1=0.31>0.3 R2=0.29<0.3 R3=0.31==0.3 R4=0.31<>0.3 R5=0.5>=0.5\nN30 M30",
    vars={1: 1, 2: 1, 3: 0, 4: 1, 5: 1},
)
case(
    "functions take degrees and brackets", **KNOWN,
    program="N10 R1=SIN(30) R2=ATAN2(1,1) R3=SQRT(POT(3)+POT(4)) R4=TRUNC(-2.7) R5=ROUND(2.5) R6=ABS(-4) R7=COS(60)\n"
    "N20 R8=ASIN(1) R9=ACOS(0) R10=TAN(45) R11=LN(1)\nN30 M30",
    vars={1: 0.5, 2: 45, 3: 5, 4: -2, 5: 3, 6: 4, 7: 0.5, 8: 90, 9: 90, 10: 1, 11: 0},
)
case(
    "an R parameter that was never set is 0", **KNOWN, program="N10 R1=R2+1\nN20 M30", vars={1: 1},
)
case(
    "R[...] computes the number of a parameter", **KNOWN,
    program="N10 R1=5 R2=1\nN20 R[R2+2]=R[R2]+1\nN30 R[0]=4\nN40 M30", vars={0: 4, 3: 6},
)
case(
    "EX is a power of ten", **KNOWN, program="N10 R1=1.5EX3 R2=-1EX-2\nN20 M30", vars={1: 1500, 2: -0.01},
)
case(
    "R99 is the last parameter", pins="commons", **KNOWN,
    program="N10 R99=1\nN20 R100=1\nN30 M30", runs="N10", alarm="illegal-variable", at="MAIN N20", word="R100=1",
)
for option, last in (("r-300", 299), ("r-1000", 999), ("r-10000", 9999)):
    case(
        f"a machine with {option} has R{last}, and none after it", **KNOWN, replace={"commons": option},
        program=f"N10 R{last}=1.5\nN20 R{last + 1}=1\nN30 M30", vars={last: 1.5}, runs="N10", alarm="illegal-variable", at="MAIN N20",
        word=f"R{last + 1}=1",
    )
case(
    "a parameter of a computed number is looked for when the block runs", **KNOWN,
    program="N10 R1=100\nN20 R2=R[R1]\nN30 M30", runs="N10", alarm="illegal-variable", at="MAIN N20",
)
case(
    "what a parameter is in the block that assigns to it is not computed",
    control=ONE, source="policy, nobody says", evidence="inferred",
    program="N10 G0 R1=5 X=R1\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10",
)
case(
    "nothing is divided by 0", **KNOWN, program="N10 R1=1/R2\nN20 M30", runs="", alarm="division-by-zero", number="14051", at="MAIN N10",
)
case(
    "a bracket that is not closed", **KNOWN,
    program="N10 R1=(1+2\nN20 M30", runs="", alarm="bracket-not-closed", number="12080", at="MAIN N10",
)
case(
    "a function needs its bracket", **KNOWN, program="N10 R1=SIN 30\nN20 M30", runs="", alarm="bracket-not-opened", number="12080", at="MAIN N10",
)
case(
    "ATAN2 takes two values", **KNOWN, program="N10 R1=ATAN2(1)\nN20 M30", runs="", alarm="missing-comma", number="12080", at="MAIN N10",
)
case(
    "a value is missing", **KNOWN, program="N10 R1=5+\nN20 M30", runs="", alarm="expression-format", number="12080", at="MAIN N10",
)
case(
    "R1 needs =", **KNOWN, program="N10 R1\nN20 M30", runs="", alarm="missing-equals", number="12080", at="MAIN N10", word="R1",
)
case(
    "other names are not computed", control=ONE, source="policy, nobody says", evidence="inferred",
    program="N10 R1=DEPTH+1\nN20 M30", runs="", alarm="code-not-computed", at="MAIN N10",
)
SONE = {"control": ONE, "source": "SONE p.444, priority of the operations", "evidence": "maker's manual"}
case(
    "B_AND comes before B_XOR, that before B_OR, and those before AND", **SONE,
    program="N10 R1=6 B_AND 3 R2=6 B_OR 3 B_AND 1 R3=6 B_XOR 3 R4=1 B_OR 6 B_XOR 2 R5=1+2 B_AND 2 R6=4 AND 4 B_AND 3\nN20 M30",
    vars={1: 2, 2: 7, 3: 5, 4: 5, 5: 2, 6: 0},
)
case(
    "B_NOT inverts every bit and binds as NOT", **SONE,
    program="N10 R1=B_NOT 5 R2=B_NOT 0 B_AND 12 R3=B_NOT -1\nN20 M30", vars={1: -6, 2: 12, 3: 0},
)
case(
    "<< binds less than OR and more than ==", **SONE,
    program='N10 R1="10"==1 OR 0<<0\nN20 M30', vars={1: 1},
)
BASES = {"control": ONE, "source": "840Dg p.94, DEF INT INT_VAR='HA5B8'", "evidence": "secondary"}
case(
    "'H...' counts to the base 16, 'B...' to the base 2", **BASES,
    program="N10 R1='HA5B8' R2='B101' R3='hff' R4='HFFFFFFFF'\nN20 M30", vars={1: 42424, 2: 5, 3: 255, 4: -1},
)
for wrong in ("'H5", "'HG'", "'B12'", "'X1'", "''"):
    case(
        f"{wrong} is no number", **BASES,
        program=f"N10 R1={wrong}\nN20 M30", runs="", alarm="expression-format", number="12080", at="MAIN N10",
    )
LIMITS = {"control": ONE, "source": "828Dj p.70, MINVAL, MAXVAL and BOUND", "evidence": "secondary"}
case(
    "MINVAL and MAXVAL are the smaller and the larger value", **LIMITS,
    program="N10 R1=MINVAL(3,-2) R2=MAXVAL(3,-2)\nN15 R3=MINVAL(R1,R2)+1\nN20 M30", vars={1: -2, 2: 3, 3: -1},
)
case(
    "BOUND keeps a value between two others", **LIMITS,
    program="N10 R1=BOUND(-1,4,2) R2=BOUND(-1,4,9) R3=BOUND(-1,4,-9) R4=BOUND(0,1,0.5)*10\nN20 M30", vars={1: 2, 2: 4, 3: -1, 4: 5},
)
case(
    "ROUNDUP goes to the next whole number above", control=ONE, source="840slj p.84, ROUNDUP", evidence="secondary",
    program="N10 R1=ROUNDUP(3.1) R2=ROUNDUP(3.6) R3=ROUNDUP(-3.1) R4=ROUNDUP(-3.6) R5=ROUNDUP(3)\nN20 M30",
    vars={1: 4, 2: 4, 3: -3, 4: -3, 5: 3},
)
case(
    "EXP is the power of the number e", **KNOWN, program="N10 R1=EXP(0) R2=ROUND(EXP(1)*1000) R3=LN(EXP(2))\nN20 M30", vars={1: 1, 2: 2718, 3: 2},
)
case(
    "two whole numbers have a quotient with a fraction, and DIV has none", control=ONE, source="NCI, basic_math.mpf", evidence="secondary",
    program="N10 DEF INT AA=1, BB=3\nN20 R1=3*(AA/BB) R2=7 DIV 3 R3=3*(7/3) R4=3 MOD 4 R5=7 MOD 4.1 R6=7 DIV 4.1 R7=7 DIV 0.4 R8=1+1-1+-1\nN30 M30",
    vars={1: 1, 2: 2, 3: 7, 4: 3, 5: 2.9000000000000004, 6: 1, 7: 17, 8: 0},
)
case(
    "an axis is no number", **KNOWN, program="N10 R1=Y\nN20 M30", runs="", alarm="type-mismatch", number="12150", at="MAIN N10", word="R1=Y",
)
for function in ("MINVAL(1)", "BOUND(1,2)", "SUBSTR(\"A\")"):
    case(
        f"{function} lacks a value", **KNOWN,
        program=f"N10 R1={function}\nN20 M30", runs="", alarm="missing-comma", number="12080", at="MAIN N10",
    )
