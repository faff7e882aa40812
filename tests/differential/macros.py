"""Generate programs with macros: variables, loops, branches, macro calls, computed words.

The meaning of the programs is not known: users compare two ways to execute them.
"""

from __future__ import annotations

from random import Random

AXES = "XYZ"
_LARGEST = 40  # the largest coordinate


def program(random: Random) -> str:
    """Return a main program and three others that it calls, in the words of the FANUC family."""
    lines = ["O1", "G21 G90 G17 G94", "G0 X0 Y0 Z5.", "F300 S1000 M3"]
    lines += _variables(random)
    for _ in range(random.randint(3, 9)):
        lines += _statement(random, level=0)
    lines += ["M5", random.choice(("M30", "M30", "M99"))]
    for number in (2, 3, 4):
        lines += [f"O{number}"]
        for _ in range(random.randint(1, 4)):
            lines += _statement(random, level=number)
        lines.append("M99")
    return "\n".join(lines) + "\n"


def _variables(random: Random) -> list[str]:
    return [
        f"#{100 + i}={random.choice(('-', ''))}{random.randint(0, 900) / 7:.4f}" for i in range(6)
    ]


def _value(random: Random) -> str:
    """Return the value of a word: a number, a variable, an expression."""
    written = f"{random.choice(('', '-'))}{random.uniform(0, _LARGEST):.{random.randint(1, 3)}f}"
    variable = f"#{random.choice((1, 2, 3, 100, 101, 102, 103, 104, 105, 110))}"
    expression = random.choice(
        (
            f"[{variable}/3]",
            f"[{variable}*SIN[{random.randint(1, 89)}]]",
            f"[ROUND[{variable}]+{random.randint(1, 9)}]",
            f"[{variable}-#{random.randint(100, 105)}/7]",
            f"[#5001+{random.randint(1, 5)}/3]",
            f"[FIX[{variable}]]",
        )
    )
    return random.choice((written, written, variable, expression, f"-{expression}"))


def _move(random: Random) -> str:
    axes = random.sample(AXES, random.randint(1, 3))
    words = [f"{axis}{_value(random)}" for axis in sorted(axes)]
    code = random.choice(("G0", "G1", "G1", "G91 G1", "G90 G0", ""))
    feed = random.choice(("", "", f"F{random.randint(50, 900)}", "F[100+ABS[#101]]", "F[1000/7]"))
    return " ".join(part for part in (code, *words, feed) if part)


def _arc(random: Random) -> str:
    radius = random.randint(1, 9)
    turn = random.choice(("G2", "G3"))
    return f"G91 {turn} X[{radius}/3*2] I[{radius}/3] F{random.randint(100, 400)}"


def _other(random: Random) -> list[str]:
    return random.choice(
        (
            ["M8"],
            [f"T{random.randint(1, 9)} M6"],
            [f"#110={random.randint(3, 9)}", "M#110"],
            [f"G4 P{random.randint(1, 900)}"],
            ["G4 X[#100/9000+0.1]"],
            [f"G52 X{_value(random)}", "G0 X1.", "G52 X0"],
            [f"#5221={_value(random)}", "G54 G0 X1."],
            ["G20", "G0 X[#103/30]", "G21"],
            [f"G81 X{_value(random)} R2. Z[-#104/9-1] F200", "X[#105/7]", "G80"],
            ["G68 X0 Y0 R[#100/3]", "G0 X5.", "G69"],
            ["#3006=1(LOOK)"],
            ["POPEN", "DPRNT[X#101[43]Y#102[20]]", "PCLOS"],
            [f"G0 X#[100+{random.randint(0, 5)}]"],
        )
    )


def _statement(random: Random, level: int) -> list[str]:
    kind = random.random()
    if kind < 0.35:
        return [_move(random)]
    if kind < 0.45:
        return [_arc(random), "G90"]
    if kind < 0.6:
        return _other(random)
    if kind < 0.7:
        return [f"#{random.randint(100, 105)}={_value(random)}"]
    if kind < 0.8 and level < 4:
        called = random.randint(level + 1 if level else 2, 4)
        call = random.choice(
            (
                f"M98 P{called}" if random.random() < 0.5 else f"G0 X1. M98 P{called}",
                f"G65 P{called} A{_value(random)} B2.5 C{random.randint(1, 9)}. L{random.randint(1, 3)}",
            )
        )
        return [call]
    if kind < 0.85 and level == 0:
        return ["G66 P4 A1.5", _move(random), _move(random), "G67"]
    return _loop(random, level)


def _loop(random: Random, level: int) -> list[str]:
    counter = f"#{120 + level}"
    inner = [line for _ in range(random.randint(1, 3)) for line in (_move(random),)]
    loop = [f"WHILE[{counter} LT {random.randint(1, 4)}]DO1", *inner]
    branch = [f"IF[{counter} EQ 1]THEN #101=#101/2"]
    return [f"{counter}=0", *loop, *branch, f"{counter}={counter}+1", "END1"]
