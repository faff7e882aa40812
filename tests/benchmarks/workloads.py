"""The programs that are measured, as texts of the control's memory."""

from __future__ import annotations

import random

SINE_LOOP = """\
O1
N10 #1=0
N20 #2=0
N30 WHILE[#1 LT {passes}]DO1
N40 #1=#1+1
N50 #2=#2+SIN[#1]*2
N60 END1
N70 M30
"""

# The loop of SINE_LOOP: each prints its seconds and the two variables.
LUA_LOCALS = """\
local sin, degree = math.sin, math.pi / 180
local began = os.clock()
local a, b = 0.0, 0.0
while a < {passes} do
  a = a + 1
  b = b + sin(a * degree) * 2
end
print(os.clock() - began, a, b)
"""
LUA_FIELDS = """\
local sin, degree = math.sin, math.pi / 180
local began = os.clock()
local v = {{0.0, 0.0}}
while v[1] < {passes} do
  v[1] = v[1] + 1
  v[2] = v[2] + sin(v[1] * degree) * 2
end
print(os.clock() - began, v[1], v[2])
"""


def flat(blocks: int) -> str:
    """G1 blocks with three coordinates, as a CAM system writes them."""
    chance = random.Random(1)
    lines = (
        f"X{chance.uniform(-200, 200):.3f} Y{chance.uniform(-200, 200):.3f}"
        f" Z{chance.uniform(-20, 0):.3f}\n"
        for _ in range(blocks)
    )
    return "O1\nG90 G1 F500\n" + "".join(f"G1 {line}" for line in lines) + "M30\n"


def call_loop(calls: int, repeats: int) -> str:
    """M98 L with a body of eight G1 blocks."""
    body = "".join(f"N{n} G1 X{n}. Y{n % 3}.5\n" for n in range(1, 9))
    return "O1\nG90 G1 F500.\n" + f"M98 P2 L{repeats}\n" * calls + "M30\n" + "O2\n" + body + "M99\n"


def subprograms(count: int) -> str:
    """Many small subprograms, each called once."""
    calls = "".join(f"M98 P{n}\n" for n in range(2, count + 2))
    bodies = "".join(f"O{n}\nG1 X{n % 100}.\nM99\n" for n in range(2, count + 2))
    return "O1\nG90 G1 F500.\n" + calls + "M30\n" + bodies


def nested(depth: int, repeats: int) -> str:
    """A call inside a call, `depth` deep, the whole again `repeats` times."""
    inner = "".join(f"O{n}\nM98 P{n + 1}\nM99\n" for n in range(2, depth + 1))
    return f"O1\nM98 P2 L{repeats}\nM30\n{inner}O{depth + 1}\nM99\n"


def macro_calls(blocks: int, repeats: int) -> str:
    """G65 with six arguments in `blocks` blocks, run `repeats` times; the macro returns at once."""
    call = "G65 P3 A1. B2. C3. I4. J5. K6.\n"
    return f"O1\nM98 P2 L{repeats}\nM30\nO2\n{call * blocks}M99\nO3\nM99\n"


def jump_loop(passes: int, around: int) -> str:
    """An IF..GOTO loop of two blocks, with `around` other blocks before it and behind it."""
    before = "".join(f"N{n} G0 X1.\n" for n in range(1, around + 1))
    loop = f"N{around + 1} #1=#1+1\nIF[#1 LT {passes}]GOTO{around + 1}\n"
    behind = "".join(f"N{n} G0 X1.\n" for n in range(around + 2, 2 * around + 2))
    return "O1\n" + before + "#1=0\n" + loop + behind + "M30\n"
