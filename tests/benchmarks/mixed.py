"""Programs as CAM systems write them: all that real programs mix, generated to any length."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator

LAST_N = 99_990  # after it the numbers begin again, as posts let them
MILL_ROUND = 5_010  # the blocks after which the operations of a mill repeat
TURNED_PART = 92


class Mill:
    """Operations in turn on a machining centre, in the words of a control or of LinuxCNC."""

    def __init__(self, linuxcnc: bool) -> None:
        self.chance = random.Random(3)
        self.linuxcnc = linuxcnc

    def operations(self) -> Iterator[str]:
        """Yield the blocks without their numbers; comments begin with a bracket."""
        kinds = (self.rough, self.contours, self.drill, self.helices, self.surface)
        for number in range(1_000_000):
            tool = number % len(kinds) + 1
            yield f"(OPERATION {number + 1}, TOOL {tool})"
            yield from self.tool(tool)
            yield from kinds[number % len(kinds)]()
            yield "M9"
            yield "G91 G28 Z0"
            yield "G90"
            yield "M5"

    def tool(self, number: int) -> Iterator[str]:
        if not self.linuxcnc:
            yield f"T{number} M6"
        yield "G17 G40 G80 G90 G94"
        yield f"G54 G0 X{self.place()} Y{self.place()} S{1000 + 500 * number} M3"
        yield "G43.1 Z0" if self.linuxcnc else f"G43 H{number}"
        yield "Z50. M8"
        yield "Z5."

    def place(self) -> str:
        return f"{self.chance.uniform(-150, 150):.3f}"

    def rough(self) -> Iterator[str]:
        """Yield lanes with rounded ends, each level below the one before."""
        for level in range(1, 6):
            yield f"G1 Z-{level * 1.5:.3f} F200."
            yield "F1200."
            for lane in range(40):
                y, side = lane * 3.0, 1 if lane % 2 == 0 else -1
                for i in range(8):
                    x = side * (i * 12.5 - 43.75) + self.chance.uniform(-1, 1)
                    yield (
                        f"X{x:.3f}" if i % 3 else f"X{x:.3f} Y{y + self.chance.uniform(0, 0.2):.3f}"
                    )
                yield f"X{side * 50.0:.3f} Y{y:.3f}"
                turn = "G3" if side > 0 else "G2"
                yield f"{turn} X{side * 50.0:.3f} Y{y + 3:.3f} I0. J1.5"
                yield f"G1 X{side * 45.0:.3f}"
            yield "G0 Z5."
            yield "X-43.75 Y0."

    def contours(self) -> Iterator[str]:
        """Yield pockets with radius compensation."""
        for number in range(60):
            x, y = number % 10 * 60.0, number // 10 * 60.0
            yield f"G0 X{x + 20:.3f} Y{y + 20:.3f}"
            yield "G1 Z-4. F150."
            yield f"{'G41.1 D8.' if self.linuxcnc else 'G41 D1'} X{x + 20:.3f} Y{y + 10:.3f} F600."
            yield f"X{x + 30:.3f}"
            yield f"G3 X{x + 40:.3f} Y{y + 20:.3f} I0. J10."
            yield f"G1 Y{y + 30:.3f}"
            yield f"G3 X{x + 30:.3f} Y{y + 40:.3f} I-10. J0."
            yield f"G1 X{x + 10:.3f}"
            yield f"G3 X{x:.3f} Y{y + 30:.3f} R10."
            yield f"G1 Y{y + 20:.3f}"
            yield f"G3 X{x + 10:.3f} Y{y + 10:.3f} R10."
            yield f"G1 X{x + 22:.3f}"
            yield f"G40 X{x + 20:.3f} Y{y + 20:.3f}"
            yield "G0 Z5."

    def drill(self) -> Iterator[str]:
        for cycle in ("G81 Z-3. R2. F120.", "G83 Z-12. R2. Q3. F100.", "G82 Z-2. R2. P1 F80."):
            for i in range(60):
                hole = f"X{i % 10 * 15.0:.3f} Y{i // 10 * 15.0:.3f}"
                yield f"G98 {cycle} {hole}" if i == 0 else hole
            yield "G80"

    def helices(self) -> Iterator[str]:
        for number in range(40):
            x, y = number % 8 * 30.0, number // 8 * 30.0
            yield f"(BORE {number + 1})"
            yield f"G0 X{x + 8:.3f} Y{y:.3f}"
            yield "G1 Z0. F300."
            for turn in range(1, 9):
                yield f"G3 X{x + 8:.3f} Y{y:.3f} Z-{turn * 0.75:.3f} I-8. J0. F{400 + turn}."
            yield f"G1 X{x:.3f}"
            yield "G0 Z5."

    def surface(self) -> Iterator[str]:
        """Yield a blade, milled with five axes."""
        yield "G1 F2500."
        for lane in range(12):
            for i in range(100):
                angle = math.radians(i * 1.8)
                x, z = 80 * math.cos(angle), 25 * math.sin(angle)
                tilt = 15 * math.cos(angle) + self.chance.uniform(-0.05, 0.05)
                yield f"X{x:.3f} Y{lane * 2.5:.3f} Z{z - 30:.3f} A{tilt:.3f} B{lane * 1.25:.3f}"
            yield "G0 Z50."
            yield f"X80. Y{lane * 2.5 + 2.5:.3f} A0. B0."
            yield "G1 Z-30. F2500."


def milling(blocks: int, linuxcnc: bool = False) -> str:
    """Return so many blocks of a mill; every block but a comment has an N."""
    lines, count = [], 0
    for line in Mill(linuxcnc).operations():
        if line[0] == "(":
            lines.append(line)
            continue
        lines.append(f"N{count * 10 % LAST_N + 10} {line}")
        count += 1
        if count == blocks:
            break
    offsets = "".join(f"G10 L10 P{n} R{40 + n}.\nG10 L12 P{n} R4.\n" for n in range(1, 6))
    head = "G21\n" if linuxcnc else f"O1 (HOUSING)\nG21\n{offsets}"
    return f"%\n{head}" + "\n".join(lines) + "\nG40 G80 G0 Z50.\nM30\n%\n"


def turning(blocks: int) -> str:
    """Return so many blocks of a lathe: roughing cycles with a profile, nose radius, threads."""
    chance, lines = random.Random(4), []
    for part in range(-(-blocks // TURNED_PART)):
        first, last = part % 400 * 20 + 1000, part % 400 * 20 + 1010
        size = chance.uniform(18, 22)
        lines += [
            "G0 X100. Z50.",
            "T0101",
            "G50 S3000",
            "G96 S180 M3",
            "G0 X52. Z2. M8",
            "G71 U2. R0.5",
            f"G71 P{first} Q{last} U0.4 W0.1 F0.25",
            f"N{first} G0 X{size:.3f}",
            "G1 Z0 F0.12",
            f"G1 X{size + 4:.3f} Z-2.",
            "Z-15.",
            f"G2 X{size + 10:.3f} Z-18. R3.",
            f"G1 X{size + 16:.3f}",
            f"G3 X{size + 20:.3f} Z-20. R2.",
            "G1 Z-35.",
            f"N{last} X52.",
            "G0 X100. Z50.",
            "T0202",
            "G42 G0 X16. Z2.",
            *(f"G1 X{size + i * 0.02:.3f} Z-{i * 0.35:.3f} F0.1" for i in range(1, 60)),
            "G40 G0 X100. Z50.",
            "T0303",
            "G97 S800 M3",
            "G0 X26. Z5.",
            *(f"{'G92 ' if i == 0 else ''}X{23.6 - i * 0.2:.3f} {'Z-14. F1.5' if i == 0 else ''}".strip()
              for i in range(8)),
            "G0 X100. Z50. M9",
            "M5",
        ]  # fmt: skip
    return "O1\nG10 P2 X0 Z0 R0.4 Q3\nG0 X100. Z50.\n" + "\n".join(lines) + "\nM30\n"
