"""Moves of LinuxCNC by drilling series, codes of group 00, polar words and computed values.

Each kind is a function that writes into a program of `linuxcnc_paths.py`.
"""

from __future__ import annotations

from collections.abc import Callable
from random import Random
from typing import Protocol

INCH = 25.4
ACROSS = {17: "XYZ", 18: "ZXY", 19: "YZX"}
# Values that are no whole number of thousandths.
ODD = (
    "1/3",
    "2/7",
    "sqrt[2]",
    "sin[33]",
    "atan[1]/[3]",
    "0.01234",
    "#1/7",
    "#2*0.333",
    "-1/3",
    "10/9",
)
SAYINGS = ("M8", "F150", "S700", "G4 P0.1", "(c)", "M9", "#4 = 3", "G64 P0.1")


class Writer(Protocol):
    """The members of the writer of a program that a kind needs."""

    random: Random
    careful: bool
    inch: bool
    plane: int
    lines: list[str]

    def put(self, *words: str) -> None: ...
    def chance(self, share: float) -> bool: ...
    def length(self, most: float = 20) -> float: ...
    def axes(self, letters: str = "XYZ", least: int = 1, most: float = 20) -> str: ...
    def straight(self) -> None: ...
    def show(self) -> None: ...


def unit(of: Writer) -> float:
    return INCH if of.inch else 1


def number(of: Writer, value: float) -> str:
    """Return a length in mm as the program writes it: as a number, or computed and not whole."""
    value /= unit(of)
    if of.chance(0.6):
        return f"{value:.3f}"
    return f"[{value:.3f} + {of.random.choice(ODD)} * {0.1 / unit(of):.4f}]"


# ---- drilling series ----


def first_hole(of: Writer, code: int, axes: str) -> list[str]:
    r = of.random
    depth = axes[2]
    words = [f"G{code}", f"R{number(of, r.choice((2, 2, 5, 0.5)))}"]
    words.append(f"{depth}{number(of, -r.randint(1, 9))}")
    if code in (73, 83):
        words.append(f"Q{number(of, r.choice((0.77, 3.31, 20)))}")
    if code in (82, 86, 89) or (code in (74, 84) and of.chance(0.3)):
        words.append(f"P{r.choice(('0.5', '0.25', '1'))}")
    return words


def place(of: Writer, axes: str) -> str:
    """Return the place of the next hole: by axes, by radius and angle, deeper, or by R alone."""
    r = of.random
    a, b, depth = axes
    form = r.random()
    if form < 0.55:
        return of.axes(a + b)
    if form < 0.7 and axes == "XYZ":
        radius = f"@{number(of, abs(of.length(9) * unit(of)) + 1)}"
        angle = f"^{r.choice(('30', '-45', '[90/7]', '200'))}"
        return r.choice((radius, angle, f"{radius} {angle}"))
    if form < 0.8:
        return f"{depth}{number(of, -r.randint(1, 9))}"
    if form < 0.9:
        return f"{of.axes(a + b)} R{number(of, r.choice((1, 3)))}"
    return f"{a}{number(of, r.randint(-9, 9))} {depth}{number(of, -r.randint(1, 9))}"


def between(of: Writer) -> None:
    """Write a block that may stand between two holes."""
    r = of.random
    modes = () if of.careful else ("G91", "G90")  # with these the bottom may come to lie above R
    said = r.choice((*SAYINGS, "G98", "G99", *modes, "G98", "G99"))
    of.put(said, of.axes("XY") if of.chance(0.3) and said[0] == "G" else "")


def series(of: Writer) -> None:
    r = of.random
    plane = r.choice((17, 17, 17, 18, 19))
    axes = ACROSS[plane]
    taps = (74, 84) if plane == 17 else ()  # in other planes a tap swaps its axes
    code = r.choice((73, 81, 82, 83, 85, 86, 89, 81, *taps))
    of.put("M4 S500" if code == 74 else "M3 S500", f"F{200 / unit(of):.1f}")
    of.put(f"G{plane} G90 G0", f"{axes[2]}{number(of, r.choice((1, 2, 5, 20)))}")
    words = first_hole(of, code, axes)
    if of.chance(0.25) and code != 74:
        words.append(f"L{r.randint(1, 3)}")
    words.append(of.axes(axes[:2]) if of.chance(0.8) else "")
    incremental = r.choice(("", "", "", "G91"))
    of.put(r.choice(("G98", "G99", "", "")), incremental, *words)
    for _ in range(r.randint(0, 5)):
        if of.chance(0.3):
            between(of)
        again = of.chance(0.1) and code not in (74, 84)
        repeat = f"L{r.randint(1, 2)}" if of.chance(0.1) and code != 74 else ""
        of.put(
            *(first_hole(of, r.choice((81, 83, 85)), axes) if again else ()),
            of.axes(axes[:2]) if again else place(of, axes),
            repeat,
        )
    end(of)


def end(of: Writer) -> None:
    """End a series by G80, alone or with a motion code, or by that code alone."""
    r = of.random
    motion = r.choice(("G0", "G1"))
    of.put(
        r.choice((
            "G80", "G80", "G80 G90", f"G80 {motion} {of.axes('XYZ')}", f"{motion} G80 {of.axes('XYZ')}",
            f"{motion} {of.axes('XYZ')}", f"G80 {motion}", motion,
        ))
    )  # fmt: skip
    of.put(f"G90 G{of.plane}", "G98" if of.chance(0.3) else "")
    of.put("G0", of.axes("XYZ", 2))


# ---- codes that leave their axis words to a motion ----


def beside(of: Writer) -> None:
    """Write axis words with codes that take none: they move by the mode or a code of the block."""
    r = of.random
    of.put("G0", of.axes("XYZ"))
    codes = ("G4 P0.25", "G28.1", "G30.1", "G92.1", "G92.2", "G92.3", "G4 P[1/3]")
    for _ in range(r.randint(1, 3)):
        words = [r.choice(codes), r.choice(("", "", "G0", "G1", "G90", "G91 G1"))]
        if of.chance(0.2):
            of.put(words[0])
            continue
        if of.chance(0.3):
            r.shuffle(words)
        of.put(*words, of.axes("XYZA" if of.chance(0.1) else "XYZ"))
        if of.chance(0.2):
            of.show()
    of.put("G90 G0", of.axes("XYZ", 3))
    of.put(r.choice(("G28", "G30", "G0 X1")) if of.chance(0.5) else "")


def in_mode(of: Writer) -> None:
    """Write the same in the modes of arcs, threads and drilling."""
    r = of.random
    code = r.choice(("G4 P0.1", "G28.1", "G92.2"))
    of.put("G90 G17 G8 G91.1 G0 X0 Y0 Z5")
    kind = r.randint(0, 2)
    if kind == 0:
        of.put(f"G2 X{2 / unit(of):.3f} I{1 / unit(of):.3f}")
        of.put(
            code, f"X{4 / unit(of):.3f} I{1 / unit(of):.3f}" if not code.startswith("G4") else ""
        )
    elif kind == 1:
        of.put(f"M3 S500 G33 Z{number(of, -2)} K{1 / unit(of):.3f}")
        of.put(code, f"Z{number(of, -4)} K{1 / unit(of):.3f}" if of.chance(0.7) else "")
    else:
        of.put(f"G81 X{number(of, 1)} Z{number(of, -2)} R{number(of, 2)}")
        of.put(code, of.axes("XY") if of.chance(0.7) else "")
        of.put("G80")
    of.put("G0", of.axes("XYZ", 2))
    of.put(f"G{of.plane}")


# ---- values ----


def fine(of: Writer) -> None:
    """Write words whose values are no whole number of increments, added up."""
    r = of.random
    of.put("G91")
    motion = r.choice(("G0", "G1"))
    for _ in range(r.randint(2, 5)):
        words = [f"{axis}[{r.choice(ODD)}]" for axis in r.sample("XYZ", r.randint(1, 3))]
        of.put(motion, *words)
    of.lines.append("(debug,#5420 #5421 #5422)")
    if of.chance(0.4):
        size = f"[{r.choice(('10/3', 'sqrt[7]', '#2*1.111'))} / {unit(of):.1f}]"
        of.put(
            "G8 G17 G91 G2", r.choice((f"I{size}", f"X[2*{size}] R{size}", f"X[2*{size}] I{size}"))
        )
    if of.chance(0.3):
        of.put(
            r.choice(("G92", "G10 L2 P1", "G52", "G10 L20 P0")),
            f"X[{r.choice(ODD)}] Y[{r.choice(ODD)}]",
        )
        of.put("G91 G0 X[1/3] Y[1/7]")
    of.put("G90", f"G{of.plane}", "G92.1" if of.chance(0.5) else "")


def many(of: Writer) -> None:
    """Write many small increments in a loop."""
    label = f"o{len(of.lines) + 1 + getattr(of, 'base', 0)}"
    of.put("G91")
    of.put(f"{label} repeat [{of.random.choice((7, 30, 90))}]")
    of.put(
        f"G1 X[{of.random.choice(('0.00125', '1/300', '0.0049'))}]",
        "Y[1/7]" if of.chance(0.3) else "",
    )
    of.put(f"{label} endrepeat")
    of.put("G90")
    of.lines.append("(debug,#5420 #5421)")


# ---- after compensation ----


def let_go(of: Writer) -> None:
    """Write blocks between G40 and the move that leads back to the path."""
    r = of.random
    one = unit(of)
    side = r.choice((41, 42))
    plane = r.choice((17, 17, 18))
    a, b, _ = ACROSS[plane]
    of.put(f"G80 G49 G90 G{plane} G8 G40 G0 {a}{-40 / one:.3f} {b}0")
    of.put(f"G{side}", r.choice(("D1", "D2", "D3", f".1 D{3 / one:.3f}")).replace("D", " D"))
    of.lines[-1] = of.lines[-1].replace(" .1", ".1")
    of.put(f"G1 {a}0 {b}0")
    of.put(
        r.choice(
            (f"{b}{30 / one:.3f}", f"{a}{30 / one:.3f}", f"{b}{30 / one:.3f} {a}{9 / one:.3f}")
        )
    )
    of.put("G40")
    said = (
        "M6",
        "T2 M6",
        "T1 M6",
        "M8",
        "G4 P0.1",
        "G91",
        "S100",
        "G90",
        "M5",
        "M3",
        "#3 = 1",
    )
    for _ in range(r.randint(0, 2)):
        of.put(r.choice(said))
    if of.chance(0.5):
        of.lines.append("(debug,#5420 #5421 #5422 #<_x> #<_abs_y>)")
    of.put(r.choice(("G0", "G1", "G91 G0", "G91 G1")), of.axes("XYZ"))
    of.put(of.axes("XYZ", 2))
    of.put(f"G90 M3 G{of.plane}")


# ---- polar words ----


def turns(of: Writer) -> None:
    r = of.random
    of.put(f"G17 G90 G0 X{number(of, 30)} Y{number(of, 1)}")
    for _ in range(r.randint(1, 4)):
        radius = r.choice(("", f"@{number(of, abs(of.length(9) * unit(of)) + 1)}"))
        angle = f"^{r.choice(('30', '[100/7]', '-200', '[#1*10]', '0'))}"
        of.put(
            r.choice(("G1", "G0", "G91 G1", "", "G90")),
            radius,
            angle,
            f"Z{number(of, 3)}" if of.chance(0.3) else "",
        )
    if of.chance(0.3):
        of.put(f"G90 G3 @{number(of, 5)} ^0 R{number(of, 40)}")
    of.put("G90", f"G{of.plane}")


# ---- codes beside each other ----


def pairs(of: Writer) -> None:
    """Write G53, G28 and lengths with other codes of a block."""
    r = of.random
    of.put("G90 G49 G80")
    of.put(
        r.choice((
            f"G53 G0 G91.1 {of.axes('XYZ')}", f"G53 G1 {of.axes('XYZ')}", f"G55 G0 {of.axes('XYZ')}",
            f"G43 H1 G0 {of.axes('XYZ')}", "G43.1 Z[1/3]", f"G49 G1 {of.axes('XYZ')}", "G92.1 G54 G0 X1",
            f"G54 G91 G0 {of.axes('XYZ')}", f"G28 {of.axes('XYZ')}", f"G91 G28 {of.axes('XYZ')}",
            f"G91 G30 {of.axes('XYZ')}", f"T1 M6 G43 G0 {of.axes('XYZ')}", "G7 G0 X[10/3]", "G7 G91 G1 X[1/7]",
            "G8 G17 G2 I[1/3]", f"G7 G17 G3 X{number(of, 3)} Y1 R{number(of, 40)}",
        ))
    )  # fmt: skip
    of.put("G90 G8 G0", of.axes("XYZ"))
    of.put(f"G{of.plane} G54")


KINDS: dict[str, tuple[Callable[..., None], int]] = {
    "series": (series, 4), "beside": (beside, 2), "in_mode": (in_mode, 1), "fine": (fine, 2),
    "many": (many, 1), "let_go": (let_go, 2), "turns": (turns, 1), "pairs": (pairs, 2),
}  # fmt: skip
