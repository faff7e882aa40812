"""The texts of the programs that are measured, in the words of a control or of a peer."""

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

# The same loop as SINE_LOOP in the words of LinuxCNC.
SINE_LOOP_LINUXCNC = """\
#1=0
#2=0
o100 while [#1 LT {passes}]
#1=[#1+1]
#2=[#2+SIN[#1]*2]
o100 endwhile
M30
"""

# The same in Lua: {a} and {b} are the two variables. It prints seconds, sum and peak memory in kB.
LUA_LOOP = """\
local sin, degree = math.sin, math.pi / 180
local began = os.clock()
{declared}
while {a} < {passes} do
  {a} = {a} + 1
  {b} = {b} + sin({a} * degree) * 2
end
local seconds, peak = os.clock() - began, 0
local status = io.open("/proc/self/status")
if status then peak = status:read("a"):match("VmHWM:%s*(%d+)") end
print(seconds, {b}, peak)
"""
LUA_FORMS = {
    "locals": {"title": "local variables", "declared": "local a, b = 0.0, 0.0", "a": "a", "b": "b"},
    "table": {"title": "a table", "declared": "local v = {0.0, 0.0}", "a": "v[1]", "b": "v[2]"},
    "globals": {"title": "global variables", "declared": "a, b = 0.0, 0.0", "a": "a", "b": "b"},
}


def sine_loop(passes: int) -> str:
    """Return a WHILE with two assignments and a sine."""
    return SINE_LOOP.format(passes=passes)


def sine_loop_linuxcnc(passes: int) -> str:
    return SINE_LOOP_LINUXCNC.format(passes=passes)


def sine_loop_lua(passes: int, form: str) -> str:
    return LUA_LOOP.format(passes=passes, **LUA_FORMS[form])


def flat(blocks: int, seed: int = 1) -> str:
    """Return G1 blocks with three coordinates, as a CAM system writes them."""
    chance = random.Random(seed)
    lines = (
        f"X{chance.uniform(-200, 200):.3f} Y{chance.uniform(-200, 200):.3f}"
        f" Z{chance.uniform(-20, 0):.3f}\n"
        for _ in range(blocks)
    )
    return "O1\nG90 G1 F500\n" + "".join(f"G1 {line}" for line in lines) + "M30\n"


def arcs(blocks: int) -> str:
    """Return quarter circles all over the table, each clockwise and then back counter-clockwise."""
    chance = random.Random(2)
    lines, x, y = [], 0.0, 0.0
    for _ in range(blocks // 2):
        radius = round(chance.uniform(0.5, 50), 3)
        side = -radius if x > 0 else radius  # the arc leads toward the middle
        turn, back = ("G2", "G3") if side > 0 else ("G3", "G2")
        lines.append(f"{turn} X{x + side:.3f} Y{y + radius:.3f} I{side:.3f} J0.000\n")
        lines.append(f"{back} X{x:.3f} Y{y:.3f} I0.000 J{-radius:.3f}\n")
    return "O1\nG90 G17 G1 F500\nX0.000 Y0.000\n" + "".join(lines) + "M30\n"


def call_loop(calls: int, repeats: int) -> str:
    """Return M98 L with a body of eight G1 blocks."""
    body = "".join(f"N{n} G1 X{n}. Y{n % 3}.5\n" for n in range(1, 9))
    return "O1\nG90 G1 F500.\n" + f"M98 P2 L{repeats}\n" * calls + "M30\n" + "O2\n" + body + "M99\n"


def nested(depth: int, repeats: int) -> str:
    """Return a call inside a call, `depth` deep; the whole is repeated `repeats` times."""
    inner = "".join(f"O{n}\nM98 P{n + 1}\nM99\n" for n in range(2, depth + 1))
    return f"O1\nM98 P2 L{repeats}\nM30\n{inner}O{depth + 1}\nM99\n"


def subprograms(count: int) -> str:
    """Return many small subprograms, each called once."""
    calls = "".join(f"M98 P{n}\n" for n in range(2, count + 2))
    bodies = "".join(f"O{n}\nG1 X{n % 100}.\nM99\n" for n in range(2, count + 2))
    return "O1\nG90 G1 F500.\n" + calls + "M30\n" + bodies


def macro_calls(blocks: int, repeats: int) -> str:
    """Return G65 with six arguments in `blocks` blocks, run `repeats` times; the macro returns at
    once.
    """
    call = "G65 P3 A1. B2. C3. I4. J5. K6.\n"
    return f"O1\nM98 P2 L{repeats}\nM30\nO2\n{call * blocks}M99\nO3\nM99\n"


def macro_calls_linuxcnc(blocks: int, repeats: int) -> str:
    call = "o3 call [1][2][3][4][5][6]\n"
    return f"o3 sub\no3 endsub\no1 repeat [{repeats}]\n{call * blocks}o1 endrepeat\nM30\n"


def hole_pattern(holes: int) -> str:
    """Return G66 over a grid; the macro moves the drill down and up again."""
    points = "".join(f"X{n % 100 * 4}. Y{n // 100 % 100 * 4}.\n" for n in range(1, holes + 1))
    macro = "O2\nG0 Z#18\nG1 Z#26 F#9\nG0 Z#18\nM99\n"
    return f"O1\nG90 G0 X0. Y0.\nG66 P2 R2. Z-10. F100.\n{points}G67\nM30\n{macro}"


def jump_loop(passes: int, around: int) -> str:
    """Return an IF..GOTO loop of two blocks, with `around` other blocks before it and after it."""
    before = "".join(f"N{n} G0 X1.\n" for n in range(1, around + 1))
    loop = f"N{around + 1} #1=#1+1\nIF[#1 LT {passes}]GOTO{around + 1}\n"
    behind = "".join(f"N{n} G0 X1.\n" for n in range(around + 2, 2 * around + 2))
    return "O1\n" + before + "#1=0\n" + loop + behind + "M30\n"


def small_program(number: int, blocks: int = 18) -> str:
    """Return one of the many files of a folder."""
    lines = "".join(f"G1 X{n}.{number % 1000:03} Y{2 * n}.5\n" for n in range(blocks))
    return f"O{number:04}\nG90 G1 F500\n{lines}M30\n"
