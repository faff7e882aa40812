"""Blocks that LinuxCNC reads, or refuses: codes that do not go together, words that no code uses,
missing feeds, written parameters, saved modes.

Each kind is a function that writes into a program of `linuxcnc_paths.py`. It writes what may stop
the program only if the writer is not careful.
"""

from __future__ import annotations

from collections.abc import Callable
from random import Random
from typing import Protocol


class Writer(Protocol):
    """The members of the writer of a program that a kind needs."""

    random: Random
    careful: bool
    inch: bool
    plane: int
    base: int
    lines: list[str]

    def put(self, *words: str) -> None: ...
    def chance(self, share: float) -> bool: ...
    def length(self, most: float = 20) -> float: ...
    def axes(self, letters: str = "XYZ", least: int = 1, most: float = 20) -> str: ...
    def straight(self) -> None: ...
    def show(self) -> None: ...
    def label(self) -> str: ...


# Each string has the codes of a group. Left out are splines, turning cycles, G88, probing, U V W
# and codes that wait.
GROUPS = (
    "G4 G10 G28 G30 G28.1 G30.1 G52 G53 G92", "G0 G1 G2 G3 G33 G33.1 G73 G74 G76 G80 G81 G82 G83 G84"
    " G85 G86 G89 G0 G1 G1 G80", "G17 G18 G19", "G90 G91", "G90.1 G91.1", "G93 G94 G95", "G20 G21",
    "G40 G41 G42 G41.1 G42.1", "G43 G43.1 G49", "G98 G99", "G54 G55 G59.3", "G61 G61.1 G64",
    "G96 G97", "G7 G8", "G92.1 G92.2 G92.3", "M62 M63 M64 M65 M67 M68", "M6 M61",
    "M3 M4 M5 M19 M70 M71 M72 M73", "M7 M8 M9", "M48 M49 M50 M51 M52 M53",
)  # fmt: skip
# Blocks that are forbidden while a radius is compensated, and blocks that are not.
UNDER_COMPENSATION = (
    "G55", "G54", "G61", "G61.1", "G64", "G64 P0.1", "G98", "G99", "T2", "T1 M6", "M6", "G28", "G30",
    "G28 X1", "G28.1", "G30.1", "G92 X1", "G52 X1", "G92.1", "G92.2", "G92.3", "G53 G0 X1", "G53 G1 X1",
    "G43", "G49", "G43.1 Z1", "G17", "G18", "G19", "G20", "G21", "M48", "M49", "M50 P1", "M53 P0",
    "M62 P1", "M65 P1", "M67 E1 Q2", "M68 E1 Q1", "G10 L2 P1 X1", "G10 L20 P1 X0", "G10 L1 P1 Z1",
    "G38.2 X90 F100", "G81 Z-5 R2", "G33 Z-1 K1", "G76 Z-5 P1 I1 J1 K1", "G4 P0.1", "M8", "S600", "F200",
    "G90.1", "G93", "G94", "G95", "G94 F100", "M3", "M5", "G7", "G8", "G41", "G42 D1", "G96 S5", "G97 S5",
    "M70", "M73", "M72", "@5 ^20", "G80",
)  # fmt: skip
WRITTEN = (5061, 5063, 5069, 5070, 5161, 5163, 5181, 5210, 5211, 5213, 5220, 5221, 5222, 5223, 5230,
           5241, 5242, 5250, 5261, 5321, 5399, 5400, 5401, 5403, 5420, 5421,
           31, 5000, 5428, 5413, 5414, 5429, 0, 5602)  # fmt: skip
LETTERS = "DEFHIJKLPQRST"


def value(of: Writer, letter: str) -> str:
    """Return a value for a word, mostly one that makes sense there."""
    r = of.random
    if letter in "DHT":
        return str(r.choice((1, 2, 3, 1, 2, 3, 0, -1, 1.5)))
    if letter in "LP":
        return str(r.choice((0, 1, 2, 3, 0.5, 10, 20, -1, 1, 2)))
    if letter in "FS":
        return str(r.choice((0, 1, 100, 250.5, 500, -1)))
    return str(r.choice((0, 1, 2, 0.5, -1, 3.25)))


def letters(of: Writer, among: str, most: int) -> list[str]:
    chosen = of.random.sample(among, of.random.randint(0, most))
    return [f"{letter}{value(of, letter)}" for letter in chosen]


def any_block(of: Writer) -> None:
    """Write a block of codes of some groups, with words that they may not want."""
    r = of.random
    groups = r.sample(GROUPS, r.choice((0, 1, 1, 1, 2, 2, 3)))
    words = [r.choice(group.split()) for group in groups]
    words += r.choice(([], [], [], [r.choice(r.choice(GROUPS).split())]))
    words += letters(of, LETTERS, 2)
    axes = of.axes("XYZA" if of.chance(0.1) else "XYZ", 1, 5) if of.chance(0.6) else ""
    if "G10" in words:  # rs274 accepts P0.5 but not P0.4, and L0 reads a tool table again
        words = [word for word in words if word not in ("P0.5", "L0")]
    if "M6" in words:  # with a length rs274 would ask the machine for its place
        words = [word for word in words if not word.startswith("G43")]
    if not axes and ("G28" in words or "G30" in words):  # see `reference` in linuxcnc_paths.py
        axes = of.axes("XYZ")
    if of.chance(0.3):
        r.shuffle(words)
    # Where M72 restores a mode, the blocks that rs274 runs for it replace the words beside it:
    # these are lost, M2 too. [interp_convert.cc: restore_settings]
    of.put(*(["M72"] if "M72" in words else [*words, axes]))
    after(of)


def after(of: Writer) -> None:
    """Show the state that the block left in force."""
    if of.chance(0.6):
        of.put("G0 X1 Y2 Z3" if of.chance(0.3) else of.axes("XY"))
    for _ in range(of.random.randint(0, 2)):
        of.show()


def block(of: Writer) -> None:
    if of.careful:
        of.put(
            of.random.choice(
                ("M8", "M9", "M48", "M49", "G64 P0.01", "G61", "G98", "G4 P0.5", "S20 M4")
            )
        )
        return
    for _ in range(of.random.randint(1, 3)):
        any_block(of)


def feed(of: Writer) -> None:
    """Write G93, G94 and G95, with a feed, without one, and with a second one."""
    r = of.random
    for _ in range(r.randint(1, 3)):
        mode = r.choice((93, 94, 95, 94))
        missing = of.chance(0.25) and not of.careful
        given = "" if missing else f"F{r.choice((5, 100, 0.2, 250))}"
        if of.chance(0.3) and not missing:
            of.put(f"G{mode}", given if mode != 93 else "")
            given = f"F{r.choice((3, 50))}" if mode == 93 else ""
        else:
            of.put(f"G{mode}", given if of.chance(0.5) and mode != 93 else "")
        moved(of, mode, given)
    of.put("G94 F300")


def moved(of: Writer, mode: int, given: str) -> None:
    """Write moves in a feed mode: in inverse time each cut needs its feed."""
    r = of.random
    for n in range(r.randint(1, 3)):
        beside = given if mode == 93 or n == 0 else ""
        if of.chance(0.08) and not of.careful:
            beside = r.choice(("", "F-1", "" if mode == 93 else "F0"))
        code = r.choice(("G1", "G1", "G0", "G2 I1", ""))
        of.put(code, of.axes("XYZ") if code != "G2 I1" else "", beside)
    if of.chance(0.3):
        of.lines.append("(debug,#<_inverse_time> #<_units_per_minute> #<_units_per_rev>)")


def units(of: Writer) -> None:
    """Write G20 and G21 with a feed and a move, and then a move with the feed that is left."""
    of.put("G49")
    of.inch = not of.inch
    of.put(f"F{of.random.choice((10, 200))}" if of.chance(0.7) else "",
           "G20" if of.inch else "G21", "G1", of.axes("XYZ"))  # fmt: skip
    of.put("G1", of.axes("XY"))
    if of.chance(0.5):
        of.inch = not of.inch
        of.put("G20" if of.inch else "G21", of.axes("XYZ"))


def held(of: Writer) -> None:
    """Write blocks under radius compensation."""
    r = of.random
    if of.careful:
        return
    radius = r.choice(("D1", "D2", "", "D3"))
    unit = 25.4 if of.inch else 1
    of.put("G80 G40")
    of.put("G90 G17 G8 G91.1 G94", f"F{300 / unit:.0f} G0 X{-40 / unit:.1f}")
    of.put(f"G{r.choice((41, 42))} {radius}")
    if of.chance(0.7):
        of.put("G1 X0 Y0")
        of.put(f"G1 X0 Y{30 / unit:.2f}")
    for _ in range(r.randint(1, 2)):
        of.put(r.choice(UNDER_COMPENSATION))
        if of.chance(0.5):
            of.put(f"X{of.length():.2f} Y{60 / unit:.2f}")
    of.put(f"G1 X{80 / unit:.2f} Y{90 / unit:.2f}")
    of.put("G40 G0 X0 Y0")
    of.put(f"G{of.plane}")


def written(of: Writer) -> None:
    """Write and read parameters that hold or set a state."""
    r = of.random
    number = r.choice([n for n in WRITTEN if 5061 <= n <= 5399] if of.careful else WRITTEN)
    if of.careful and number in (5210, 5220, 5230, 5250):
        return
    turn = number in (5230, 5250)
    length = 5160 < number < 5400 and (number % 20 in (1, 2, 3) or 5211 <= number <= 5213)
    given = r.randint(1, 9) if number in (5220, 5210) else of.length(5)
    beside = of.axes("XY") if of.chance(0.15) else ""
    if length and of.inch:
        return
    of.put("G92.1" if turn else "")
    of.put("G0" if beside else "", beside, f"#{number} = {given}", "(mm)" if length else "")
    if r.random() < 0.7:
        of.lines.append(f"(debug,{'m ' if length else ''}#{number})")
    for _ in range(r.randint(0, 3)):
        if turn:
            of.put(r.choice(("G54", "G55", "G54 G0 X1", "G0 X1 Y2", "G56")))
            continue
        of.put(r.choice(("G54", "G55", "G54 G0 X1", "G0 X1 Y2 Z3", "G92.3", "G92.2", "G10 L2 P1 Y0",
                         "G92 X5", "G52 Y1", "G0 X1", "G43", "G49", "G10 L20 P1 X0")))  # fmt: skip
        of.show()
    if turn:  # rs274 loses its place if a rotated system is shifted
        of.put("G10 L2 P1 R0")
        of.put("G10 L2 P2 R0")


def modes(of: Writer) -> None:
    """Write all modes, saved and restored: in the program and in a subprogram."""
    r = of.random
    of.put(r.choice(("M70", "M70", "M73")))
    kept = of.inch, of.plane
    for _ in range(r.randint(1, 4)):
        said = r.choice(("G91", "G90", "G7", "G8", "G20", "G21", "G18", "G17", "G55", "G54", "G90.1", "G91.1",
                         "G98", "G99", "G93", "G94", "G94 F100", "G95 F0.5", "F77", "F12.34", "S99.6", "S44",
                         "M4", "M5", "M7", "M8", "M9", "M49", "M48", "G61", "G64 P0.1 Q0.2", "G64", "G96 S10",
                         "G97 S20", "G43 H1", "G49", "G92 X1", "G92.1", "G92.2", "M53 P0", "T2"))  # fmt: skip
        if of.careful and said in ("G93", "G94", "G95 F0.5"):
            continue
        of.put(said)
        of.inch = {"G20": True, "G21": False}.get(said, of.inch)
        of.plane = {"G18": 18, "G17": 17}.get(said, of.plane)
    if r.random() < 0.6:
        of.put("G0", of.axes("XYZ"))
    if not of.careful and of.chance(0.1):
        of.put("M71")
    of.put("M72")
    of.inch, of.plane = kept
    of.show()
    of.put(r.choice(("G1", "G0", "")), of.axes("XYZ"))
    of.show()


def tools(of: Writer) -> None:
    """Write choices and changes of tools, and lengths by number, in one block or several."""
    r = of.random
    if of.careful:
        return
    for _ in range(r.randint(1, 3)):
        words = r.sample(("T1", "T2", "T3", "M6", "G43", "G49", "H1", "H2", "H0", "G43.1 Z1",
                          "G0 X1", "G40"), r.randint(1, 3))  # fmt: skip
        if "M6" in words:  # a length in force then would be that of a machine
            of.put("G49 G90 G0 X0 Y0 Z9")
            words = [word for word in words if not word.startswith("G43")]
        of.put(*words)
        if of.chance(0.5):
            of.lines.append("(debug,#5400 #<_selected_tool>)")
    of.put("G49 G90 G0 X0 Y0 Z9")


def calls(of: Writer) -> None:
    """Write M98 with other words than its own."""
    r = of.random
    number = of.label()
    kept, of.lines = of.lines, []
    of.lines.append(f"o{number}")
    of.straight()
    of.put(
        "M99"
        if of.careful or of.chance(0.9)
        else f"M99 {r.choice(('X1', 'P1', 'L2', 'G0', '(c)'))}"
    )
    of.subs.append(of.lines)  # type: ignore[attr-defined]
    of.lines = kept
    beside = [] if of.careful or of.chance(0.3) else letters(of, "DEFHIJKQRST", 2)
    if not of.careful and of.chance(0.3):
        beside.append(r.choice(("X1", "G0", "G1 X1", "G90", "M8", "G43", "G4", "(c)", "#3=1", "M3", "G2 I1", "G81", "A1",
                                "G64", "G96", "M66", "M98")))  # fmt: skip
    repeat = r.choice(("", "L1", "L2", "L0"))
    of.put("M98", f"P{number}", repeat, *beside)
    of.show()


KINDS: dict[str, tuple[Callable[..., None], int]] = {
    "block": (block, 4),
    "feed": (feed, 2),
    "units": (units, 1),
    "held": (held, 2),
    "written": (written, 2),
    "modes": (modes, 2),
    "tools": (tools, 1),
    "calls": (calls, 1),
}
