"""LinuxCNC: values, operators and functions."""

from conformance import case

RUN = {"control": "linuxcnc", "source": "rs274 2.9", "evidence": "source document"}


def _values(claim: str, program: str, values: dict[int, float]) -> None:
    case(claim, **RUN, program=f"{program}\nM2", vars=values)


_values("powers bind closer than products, products closer than sums", "#31=[1 + 2 * 3 ** 2]", {31: 19})
_values("operators of one strength go from left to right, powers too",
        "#31=[2 ** 3 ** 2]\n#32=[10 - 4 - 3]\n#33=[5 MOD 3 * 2]", {31: 64, 32: 3, 33: 4})
_values("a sign belongs to its number before a power", "#31=[-2 ** 2]", {31: 4})
_values("comparisons bind closer than AND, OR and XOR", "#31=[1 LT 2 AND 3 GT 2]\n#32=[0 OR 1 EQ 2]", {31: 1, 32: 0})
_values("AND, OR and XOR ask whether a value is 0", "#31=[5 AND 2]\n#32=[5 XOR 3]\n#33=[0 OR 7]", {31: 1, 32: 0, 33: 1})
_values("EQ and NE take less than a ten-thousandth for nothing, LE and GE do not",
        "#31=[1 EQ 1.00009]\n#32=[1 NE 1.00009]\n#33=[1 LE 0.99999]\n#34=[1 EQ 1.00011]",
        {31: 1, 32: 0, 33: 0, 34: 0})
_values("the rest of MOD is never negative", "#31=[-7 MOD 3]\n#32=[7 MOD -3]", {31: 2, 32: 1})
_values("FIX goes down and FUP goes up, below 0 too", "#31=FIX[-2.5]\n#32=FUP[-2.5]\n#33=ROUND[-2.5]", {31: -3, 32: -2, 33: -3})
_values("ATAN has two values and its angle a sign", "#31=ATAN[1]/[-1]\n#32=ATAN[-1]/[-1]", {31: 135, 32: -135})
_values("ASIN and ACOS are in degrees", "#31=ASIN[-1]\n#32=ACOS[0]", {31: -90, 32: 90})
_values("the cosine of 90 is not quite 0, and so it holds",
        "o1 if [COS[90]]\n#31=1\no1 endif\n#32=SIN[30]", {31: 1, 32: 0.5})
_values("angles are those of rs274 to the last bit", "#31=[ACOS[SIN[4]] GT 86]\n#32=[ASIN[SIN[5]] EQ 5]", {31: 1, 32: 1})
_values("ABS, SQRT, LN and EXP", "#31=ABS[-3]\n#32=SQRT[16]\n#33=LN[1]\n#34=EXP[0]", {31: 3, 32: 4, 33: 0, 34: 1})
_values("signs may stand before signs", "#31=--3\n#32=-[3]\n#33=+-4", {31: 3, 32: -3, 33: -4})
_values("a function needs no brackets around it", "#31=SIN[90]", {31: 1})

for _program, _cause, _what in (
    ("[1/0]", "division-by-zero", "a division by 0"),
    ("[7 MOD 0]", "argument-out-of-range", "the rest of a division by 0"),
    ("[[-8] ** 0.5]", "power-of-negative", "a root of a negative value by a power"),
    ("SQRT[-1]", "square-root-of-negative", "a root of a negative value"),
    ("LN[0]", "logarithm-of-non-positive", "a logarithm of 0"),
    ("ASIN[2]", "arc-sine-out-of-range", "an angle whose sine would be 2"),
    ("EXP[1000]", "overflow", "a value that is too large"),
    ("[1 + 2", "bracket-not-closed", "a bracket that is not closed"),
    ("[1 FOO 2]", "expression-format", "an operator that is none"),
    ("FOO[2]", "expression-format", "a function that is none"),
    ("ATAN[1]", "expression-format", "an ATAN of one value"),
    ("SIN 30", "expression-format", "a function without brackets"),
    ("1.2.3", "illegal-decimal-point", "a number with two points"),
    ("", "address-without-value", "an assignment of nothing"),
    ("EXISTS[1]", "expression-format", "EXISTS of a number"),
):
    case(
        f"{_what} is refused by LinuxCNC", **RUN,
        program=f"N10 G0 X1\nN20 #31={_program}\nN30 M2", runs="N10", alarm=_cause, at="MAIN N20",
    )
