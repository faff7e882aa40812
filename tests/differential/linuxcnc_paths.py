"""Generate programs of LinuxCNC's motion and run them on cncsub and on its interpreter `rs274`.

    python tests/differential/linuxcnc_paths.py --programs 100000 --together 50
    python tests/differential/linuxcnc_paths.py --programs 1000 --kinds block,held,written
    python tests/differential/linuxcnc_paths.py --show 17

`--kinds` names the kinds that programs are made of, instead of all. A program moves in lines and
arcs of all planes, by words, centres and polar coordinates, compensates radii, drills and cuts
threads, sets and rotates work systems, measures and changes tools, saves modes, and calls
subprograms of such lines with computed words. It prints positions and modes. Some programs have a
mistake. Compared are the moves of the tool in work coordinates, the messages, and after which of
them the run stopped. If both stopped but in other words, that is counted.

Moves that rs274 makes in a block that it then refuses are not compared: cncsub refuses it whole.

Where rs274 asks its machine and gets an answer that no machine gives, only the part before is
compared, and the program is counted under that reason [canonical.py: _asks_machine]: a change of
units or of the tool under a tool length, M61, and M6 of T0.

The programs leave out what rs274 does not do as a machine would: the place of the tool after a
probing move (it stops a hundredth of an inch short of its end); the path of splines (it prints how
many points they have, and reads one beyond them); U, V and W, which it does not know; G43.2 by axis
words, where it looks for tool -1; G88, where the operator draws back; a work system that is rotated
under a shift of G92, where it loses the place of the tool; a peck that ends at the bottom but for
rounding; taps outside of G17 in series; G90 and G91 between the holes of careful programs; tools
that no table has, which a setup need not list; and words beside M72, which it loses where a mode is
restored. Careful programs, of which `--together` makes one, have nothing of the kinds held and
tools, and of the kind block only what never stops. Single programs have all of it.
"""

from __future__ import annotations

import math
import re
import sys
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from random import Random

import numpy as np

import canonical
import cncsub
import linuxcnc_blocks
import linuxcnc_moves
from canonical import Move, with_length

SHOWN = 5
SECONDS = 30
INCH = 25.4
# Lengths and diameters of the tools, in inches: rs274 alone is a machine in inches.
TOOLS = {1: (0.5, 0.25), 2: (1.0, 0.125), 3: (0.0, 0.5)}
TABLE = "".join(f"T{t} P{t} Z{z} D{d} ;\n" for t, (z, d) in TOOLS.items())
SETUP = cncsub.Setup(
    length_offsets={t: z * INCH for t, (z, _) in TOOLS.items()},
    radius_offsets={t: d * INCH / 2 for t, (_, d) in TOOLS.items()},
)
# Every program begins in the same state, whatever the program before it left.
HEAD = [
    "G21 G90 G17 G94 G40 G80 G54 G91.1 G8 G98 G97 F300 S500 M3",
    "G49",
    "G92.1",
    *(f"G10 L2 P{p} X0 Y0 Z0 A0 R0" for p in range(1, 10)),
    *(f"G10 L1 P{t} X0 Y0 Z{z * INCH} R{d * INCH / 2}" for t, (z, d) in TOOLS.items()),
    "T1 M6",
    "G0 X0 Y0 Z10 A0",
    "G28.1",
    "G30.1",
]
PLANES = {17: "XYZIJK", 18: "ZXYKIJ", 19: "YZXJKI"}
# Points of circles about 0 that words can give exactly.
CIRCLES = (
    ((1, 0), (0, 1), (-1, 0), (0, -1)),
    ((5, 0), (4, 3), (3, 4), (0, 5), (-3, 4), (-4, 3), (-5, 0), (-4, -3), (0, -5), (3, -4)),
)
# A state in the unit of the machine, which is inches there, begins with m.
STATE = (
    "#5420 #5421 #5422 #5423", "#<_x> #<_y> #<_z>", "#<_abs_x> #<_abs_y> #<_abs_z>", "#5220",
    "m #5211 #5212 #5213", "m #5221 #5222 #5223", "m #5401 #5402 #5403", "#<_motion_mode> #<_plane>",
    "#<_rpm>", "#<_metric> #<_absolute>", "m #5161 #5162 #5163", "#5400", "#<_incremental>",
    "#<_lathe_diameter_mode> #<_ijk_absolute_mode>", "#<_coord_system>", "#5210", "#5070",
    "#<_ccomp>", "#<_retract_old_z> #<_retract_r_plane>", "#5399", "#<_selected_tool>", "#5230",
    "#<_inverse_time> #<_units_per_minute> #<_units_per_rev>", "#<_spindle_css_mode>", "#<_call_level>",
)  # fmt: skip
MISTAKES = (
    "G38.2 F100", "G81", "G1 X1 R5", "M72", "G2 X5 Y5 I1 J0", "G10 L2 P12 X1",
    "G53 X1 G91", "G92", "G76 Z-5 P1", "G33 Z-1", "G5.1 X5 I1", "G10 L5 P1",
    "G0 @5 X1", "G18 G0 @5", "G2 X1 Y0 R0.1", "G2 R5", "G83 X1 Z-1 R1", "G41 D1 G41 D1",
    "G81 X1 Z-1", "G10 P1 X0", "G2 X1 P2.5 I0.5", "G2 X1 P0 I0.5", "M98 P7",
    "G90 G91", "G4", "G28 G0 X1", "G64 P-1", "G85 X1 Z5 R1", "G82 X1 Z-1 R1", "G33.1 Z-1",
)  # fmt: skip


@dataclass
class Writer:
    """Writes one program."""

    random: Random
    base: int = 0  # labels begin after it
    careful: bool = False  # write nothing that may stop the program
    lines: list[str] = field(default_factory=list)
    subs: list[list[str]] = field(default_factory=list)
    inch: bool = False
    plane: int = 17
    kinds: Sequence[str] = ()  # some of KINDS; empty: all of them

    def put(self, *words: str) -> None:
        self.lines.append(" ".join(word for word in words if word))

    def chance(self, share: float) -> bool:
        return self.random.random() < share

    def length(self, most: float = 20) -> float:
        most /= INCH if self.inch else 1
        return round(self.random.uniform(-most, most), self.random.choice((0, 1, 2, 3)))

    def word(self, axis: str, most: float = 20) -> str:
        value = self.length(most)
        form = self.random.random()
        if form < 0.85:
            return f"{axis}{value}"
        if form < 0.95:
            return f"{axis}[#1 + {value}]"
        return f"{axis}#{self.random.choice((1, 2))}"

    def axes(self, letters: str = "XYZ", least: int = 1, most: float = 20) -> str:
        count = self.random.randint(least, len(letters))
        return " ".join(self.word(axis, most) for axis in self.random.sample(letters, count))

    # ---- kinds ----

    def straight(self) -> None:
        code = self.random.choice(("G0", "G1", "G1", "G90 G1", "G91 G0", "G90 G0"))
        self.put(code, self.axes("XYZA" if self.chance(0.2) else "XYZ"))
        if self.chance(0.3):
            self.put(self.axes("XY"))

    def arc(self) -> None:
        r = self.random
        plane = self.plane if self.chance(0.7) else r.choice((17, 18, 19))
        a, b, across, i, j, _ = PLANES[plane]
        points = r.choice(CIRCLES)
        size = round(r.uniform(0.2, 4) / (INCH if self.inch else 1), 2)
        one, other = r.choice(points), r.choice(points)
        full = one == other
        middle = (self.length(), self.length())
        start = [m + size * p for m, p in zip(middle, one)]
        end = [m + size * p for m, p in zip(middle, other)]
        self.put("G8")  # in diameters it would be no arc
        self.put(f"G{plane} G90 G0 {a}{start[0]:.4f} {b}{start[1]:.4f}")
        code = r.choice(("G2", "G3"))
        if not full and self.chance(0.3):
            radius = math.hypot(*one) * size + r.choice((0, 0.5, 2))
            words = [f"{a}{end[0]:.4f} {b}{end[1]:.4f} R{r.choice(('', '-'))}{radius:.4f}"]
        elif self.chance(0.3):
            ways = [f"{axis}{to - at:.4f}" for axis, to, at in zip((a, b), end, start)]
            centre = [f"{word}{m - at:.4f}" for word, m, at in zip((i, j), middle, start)]
            words = ["G91", *([] if full else ways), *centre]
        else:
            absolute = self.chance(0.3)
            zero = (0, 0) if absolute else start
            centre = [f"{word}{m - at:.4f}" for word, m, at in zip((i, j), middle, zero)]
            words = ["G90.1" if absolute else "G91.1", *centre]
            words += [] if full and self.chance(0.5) else [f"{a}{end[0]:.4f} {b}{end[1]:.4f}"]
        if self.chance(0.3):
            words.append(self.word(across))
        if self.chance(0.15):
            words.append(f"P{r.randint(1, 4)}")
        self.put(code, *words)
        self.put("G91.1 G90", f"G{self.plane}")

    def contour(self) -> None:
        """Write a compensated contour: a square about which any tool fits, or random moves."""
        r = self.random
        plane, side = r.choice((17, 17, 18)), r.choice((41, 42))
        a, b, across, i, j, _ = PLANES[plane]
        unit = INCH if self.inch else 1
        begin = r.choice(
            (f"G{side} D{r.choice((1, 2, 3))}", f"G{side}.1 D{r.uniform(0.1, 9) / unit:.3f}")
        )
        if self.chance(0.2):
            begin = f"G{side}"
        self.put(f"G90 G{plane} G40 G0 {a}{-40 / unit:.3f} {b}{-40 / unit:.3f}")
        self.put(begin, r.choice(("G1", "G0")), f"{a}0 {b}{0 if side == 41 else -1 / unit:.3f}")
        if self.careful or self.chance(0.3):
            ways = ((0, 30), (30, 0), (0, -30)) if side == 41 else ((30, 0), (0, 30), (-30, 0))
            for way in ways:
                self.put("G91 G1", f"{a}{way[0] / unit:.3f} {b}{way[1] / unit:.3f}")
        else:
            self.free_contour(a, b, across, i, j)
        self.put("G90", "G40" if self.chance(0.5) else "")
        self.put("G40", r.choice(("G0", "G1")), f"{a}{-50 / unit:.3f} {b}{self.length(60)}")
        self.put(f"G{self.plane}")

    def free_contour(self, a: str, b: str, across: str, i: str, j: str) -> None:
        r = self.random
        for _ in range(r.randint(1, 5)):
            kind = r.random()
            way = [self.length(r.choice((3, 20, 40))) for _ in range(2)]
            if kind < 0.55:
                self.put("G91", r.choice(("G1", "G1", "G1", "G0")), f"{a}{way[0]} {b}{way[1]}")
            elif kind < 0.75 and math.hypot(*way) > 0.1:
                radius = math.hypot(*way) / 2 * r.choice((1.001, 1.2, 2, 4))
                turn, sign = r.choice(("G2", "G3")), r.choice(("", "", "-"))
                self.put("G91", turn, f"{a}{way[0]} {b}{way[1]} R{sign}{radius:.4f}")
            elif kind < 0.85 and math.hypot(*way) > 0.1:
                self.put("G91", r.choice(("G2", "G3")), f"{i}{way[0]} {j}{way[1]}")
            elif kind < 0.93:
                self.put("G91 G1", self.word(across, 3))
            else:
                self.put(r.choice(("G4 P0.1", "M8", "S600", "F200")))

    def frame(self) -> None:
        r = self.random
        turn = f"R{r.choice((0, 30, 45, 90, -20))}" if self.chance(0.4) else ""
        self.put("G92.1" if turn else "")
        self.put(
            r.choice((
                f"G{r.choice(('54', '55', '56', '59', '59.1', '59.3'))}",
                f"G10 L2 P{r.choice((0, 1, 2, 3, 6, 7, 9))} {self.axes('XYZ')} {turn}",
                f"G10 L20 P{r.choice((0, 1, 2, 7))} {self.axes('XYZ')}",
                f"G92 {self.axes('XYZ')}",
                f"G52 {self.axes('XYZ')}",
                r.choice(("G92.1", "G92.2", "G92.3")),
            ))
        )  # fmt: skip
        if self.chance(0.5):
            self.put("G0", self.axes("XYZ", 2))

    def tool(self) -> None:
        r = self.random
        form = r.choice(("L1", "L1", "L10", "L11"))
        if self.chance(0.15):
            self.put("G49")
            self.put(f"T{r.choice((1, 2, 3))} M6")
            self.put("G90 G0", self.axes("XYZ", 3))
        self.put(
            r.choice((
                "G43",
                f"G43 H{r.choice((1, 2, 3))}",
                f"G43.1 {self.axes('XZ')}",
                f"G43.2 {r.choice(('H1', 'H2'))}",
                "G49",
                f"G10 {form} P{r.choice((1, 2, 3))} {self.axes('XYZ' if self.chance(0.4) else 'Z')}",
                f"G10 L1 P2 R{abs(self.length(3)) + 0.1:.3f}",
            ))
        )  # fmt: skip

    def reference(self) -> None:
        axes = self.axes("XYZ") if self.chance(0.5) else ""
        code = self.random.choice(("G28", "G30", "G28.1", "G30.1", "G53 G0", "G53 G1"))
        if code.endswith(".1"):
            self.put(code)
        elif code.startswith("G53"):
            self.put("G90", code, self.axes("XYZ"))
        else:
            if not axes:  # it prints where the tool stands, in coordinates that may be new
                self.put("G90 G0", self.axes("XYZ", 3))
            self.put(code, axes)

    def probe(self) -> None:
        self.put("G90", f"G38.{self.random.randint(2, 5)}", f"X{90 + self.length(5)}", "F100")
        self.put("G0", " ".join(self.word(axis) for axis in "XYZ"))

    def drill(self) -> None:
        r = self.random
        code = r.choice((73, 81, 82, 83, 84, 74, 85, 86, 89, 81))
        unit = INCH if self.inch else 1
        words = [f"G{code}", f"R{2 / unit:.3f}", f"Z{-r.randint(1, 9) / unit:.3f}", self.axes("XY")]
        words += [f"Q{r.choice((0.77, 3.3)) / unit:.3f}"] if code in (73, 83) else []
        words += ["P0.5"] if code in (82, 86, 89) else []
        incremental = self.chance(0.2)
        if code in (84, 74, 86):
            self.put("M4" if code == 74 else "M3", "F50")
        self.put("G17 G90 G0", f"Z{r.choice((1, 2, 5, 20)) / unit:.3f}")
        if incremental:
            words = ["G91", *words, f"L{r.randint(1, 3)}"]
        self.put(r.choice(("G98", "G99", "")), *words)
        for _ in range(r.randint(0, 3)):
            self.put(self.axes("XY"))
        self.put("G80 G90", f"G{self.plane}")

    def thread(self) -> None:
        r = self.random
        unit = INCH if self.inch else 1
        self.put("M3 S500 G90 G0 X0 Z5")
        kind = r.random()
        if kind < 0.3:
            self.put("G33", self.axes("XZ"), f"K{1 / unit:.3f}")
        elif kind < 0.5:
            self.put("G33.1", f"Z{-5 / unit:.3f}", f"K{1 / unit:.3f}")
        else:
            words = [
                f"Z{r.choice((-9, 12)) / unit:.3f} P{1 / unit:.3f} I{r.choice((-2, 2)) / unit:.3f}"
            ]
            words.append(f"J{0.4 / unit:.3f} K{1.2 / unit:.3f}")
            words += [
                w
                for w in ("R2", "Q29", f"E{0.5 / unit:.3f} L{r.randint(0, 3)}", "H1")
                if self.chance(0.4)
            ]
            self.put("G76", *words)
        self.put("G0", self.axes("XYZ", 2))

    def polar(self) -> None:
        self.put(f"G17 G90 G0 X{self.length() + 50} Y1")
        for _ in range(self.random.randint(1, 3)):
            words = [
                f"@{abs(self.length()) + 1}" if self.chance(0.6) else "",
                f"^{self.length(90)}",
            ]
            self.put(self.random.choice(("G1", "G0", "G91 G1")), *words)
        self.put("G90", f"G{self.plane}")

    def mode(self) -> None:
        r = self.random
        said = r.choice(("G90", "G91", "G7", "G8", "G7", "G61", "G64", "G64 P0.1", "F123.45", "S77",
                         "plane", "G4 P0.25", "M8", "M5", "M3", "units"))  # fmt: skip
        if said == "plane":
            self.plane = r.choice((17, 18, 19))
            said = f"G{self.plane}"
        elif said == "units":
            self.inch = not self.inch
            self.put("G49")
            said = "G20" if self.inch else "G21"
        self.put(said)

    def show(self) -> None:
        self.lines.append(f"(debug,{self.random.choice(STATE)})")

    def variables(self) -> None:
        value = self.length(9)
        self.put(self.random.choice((f"#1 = {value}", f"#2 = [#1 + {value}]", "#1 = #5420")))

    def saved(self) -> None:
        """Write modes that are saved, changed, and restored."""
        self.put("M70")
        inch, plane = self.inch, self.plane
        for _ in range(self.random.randint(1, 3)):
            self.mode()
        self.straight()
        self.put("M72")
        self.inch, self.plane = inch, plane
        self.show()

    def label(self) -> str:
        """Return the number of the next subprogram."""
        return str(self.base + 100 + len(self.subs))

    def call(self) -> None:
        label = f"o{self.label()}"
        kept, self.lines = self.lines, []
        inch, plane = self.inch, self.plane
        keeps = self.chance(0.6)
        self.lines.append(f"{label} sub")
        if keeps:
            self.put("M73")
        for _ in range(self.random.randint(1, 3)):
            self.random.choice((self.straight, self.mode, self.show, self.arc) if keeps
                               else (self.straight, self.show, self.arc))()  # fmt: skip
        self.lines.append(f"{label} endsub")
        self.subs.append(self.lines)
        self.lines, self.inch, self.plane = kept, inch, plane
        self.put(f"{label} call [{self.length(5)}] [{self.length(5)}]")

    def repeat(self) -> None:
        label = f"o{self.base + 1 + len(self.lines)}"
        self.put(f"{label} repeat [{self.random.randint(0, 3)}]")
        self.straight()
        self.put(f"{label} endrepeat")

    def parts(self) -> tuple[list[str], list[list[str]]]:
        asked = self.kinds or tuple(KINDS)
        weights = [KINDS[kind][1] for kind in asked]
        self.lines += [*HEAD, "#1 = 1", "#2 = 2"]
        for _ in range(self.random.randint(3, 12)):
            KINDS[self.random.choices(asked, weights)[0]][0](self)
            if not self.careful and self.chance(0.02):
                self.put(self.random.choice(MISTAKES))
        self.put("G40 G80")
        return self.lines, self.subs


# The kinds that a program is made of, and how often each is used.
KINDS: dict[str, tuple[Callable[[Writer], None], int]] = {
    "straight": (Writer.straight, 5), "arc": (Writer.arc, 4), "contour": (Writer.contour, 3),
    "frame": (Writer.frame, 4), "tool": (Writer.tool, 3), "reference": (Writer.reference, 2),
    "probe": (Writer.probe, 1), "drill": (Writer.drill, 3), "thread": (Writer.thread, 1),
    "polar": (Writer.polar, 1), "mode": (Writer.mode, 3), "show": (Writer.show, 4),
    "variables": (Writer.variables, 1), "saved": (Writer.saved, 1), "call": (Writer.call, 2),
    "repeat": (Writer.repeat, 1), **linuxcnc_moves.KINDS, **linuxcnc_blocks.KINDS,
}  # fmt: skip


def written(parts: Sequence[tuple[list[str], list[list[str]]]]) -> str:
    main = [line for lines, _ in parts for line in lines]
    subs = [sub for _, many in parts for sub in many]
    before = [line for sub in subs if sub[0].endswith(" sub") for line in sub]
    behind = [line for sub in subs if not sub[0].endswith(" sub") for line in sub]
    return "\n".join([*before, *main, "M2", *behind]) + "\n"


def program(seed: int, places: range, together: bool, kinds: Sequence[str] = ()) -> str:
    """Return one program, or many as one: then none of them has a mistake."""
    writers = (
        Writer(Random(f"{seed} {place} paths {together}"), 1000 * (n + 1), together, kinds=kinds)
        for n, place in enumerate(places)
    )
    return written([writer.parts() for writer in writers])


# ---- results ----


@dataclass
class Outcome:
    moves: list[Move]
    messages: list[str]
    error: str
    tolerance: float = 0.0  # of the printed numbers, in mm
    lost: str = ""  # why the rest is not that of a machine


def tool_moves(run: cncsub.Run) -> list[Move]:
    """Return the moves of the middle of the tool, in work coordinates."""
    moves = run.moves
    path = run.polyline(10.0, coordinates="tool") if len(moves) else None
    last = np.zeros(len(moves), dtype=int)
    if path is not None:
        last[path.move] = np.arange(len(path.move))
    made = []
    for row, move in enumerate(moves):
        if move.kind == "dwell":
            made.append(Move("dwell", seconds=float(move.time)))
            continue
        assert path is not None
        end = dict(zip("XYZ", map(float, path.points[last[row]])))
        end |= {"A": float(getattr(move, "a", 0.0) or 0.0), "B": 0.0, "C": 0.0}
        arc = move.kind in ("cw", "ccw")
        told = {a: getattr(move, f"c{a.lower()}") for a in "XYZ"} if arc else {}
        centre = {axis: float(value) for axis, value in told.items() if value is not None}
        made.append(Move("feed" if move.kind == "thread" else move.kind, end, centre))
    return made


def on_cncsub(text: str) -> Outcome:
    run = cncsub.loads(text, control="linuxcnc", name="main.ngc").run(setup=SETUP)
    stopped = "" if run.stop is cncsub.Stop.END else str(run.stop)
    error = (run.alarm.text or run.alarm.cause) if run.alarm else stopped
    return Outcome(tool_moves(run), [m.rstrip() for m in run.messages], error.rstrip())


class Rs274:
    """Runs programs in files of a folder."""

    def __init__(self, command: str, folder: Path) -> None:
        self.folder = folder
        self.interpreter = canonical.Rs274(command, folder, SECONDS)

    def run(self, text: str) -> Outcome | None:
        # Parameters of lengths are in inches there, but the text writes them in mm.
        inches = re.sub(r"= (\S+) \(mm\)", r"= [\1 / 25.4]", text)
        (self.folder / "main.ngc").write_text(inches)
        (self.folder / "tool.tbl").write_text(TABLE)
        (self.folder / "variables").write_text("")  # rs274 keeps them from run to run
        made = self.interpreter.run()
        if made is None:
            return None
        error, lost = (made.errors or [""])[0].rstrip(), made.lost
        if lost is not None:
            made.moves, made.messages = made.moves[: lost.moves], made.messages[: lost.messages]
            error = ""
        messages = [m.rstrip() for m in made.messages if not canonical.is_call(m)]
        return Outcome(made.moves, messages, error, made.tolerance, lost.why if lost else "")


def difference(ours: Outcome, theirs: Outcome) -> str:
    """Return the first difference, or nothing."""
    blur = theirs.tolerance

    def near(one: float, other: float) -> bool:
        return abs(one - other) <= blur

    one, other = (with_length(outcome.moves, blur) for outcome in (ours, theirs))
    for n, (a, b) in enumerate(zip(one, other)):
        alike = a.kind == b.kind and near(a.seconds, b.seconds)
        alike = alike and all(near(a.end[axis], b.end[axis]) for axis in a.end)
        if not (alike and all(near(v, b.centre.get(axis, v)) for axis, v in a.centre.items())):
            return f"move {n}: {a} instead of {b}"
    for said, wanted in zip(ours.messages, theirs.messages):
        if not same_message(said, wanted, blur):
            return f"says {said!r} instead of {wanted!r}"
    if theirs.lost:
        less = len(one) < len(other) or len(ours.messages) < len(theirs.messages)
        return f"stops by {ours.error!r} before {theirs.lost}" if less else ""
    if bool(ours.error) != bool(theirs.error):
        return f"stops by {ours.error!r} instead of {theirs.error!r}"
    refused = ours.error and theirs.error and len(one) < len(other)
    if len(one) != len(other) and not refused:
        return f"{len(one)} moves instead of {len(other)}, {ours.error!r}"
    if len(ours.messages) != len(theirs.messages):
        return f"{len(ours.messages)} messages instead of {len(theirs.messages)}"
    return ""


def same_message(one: str, other: str, blur: float) -> bool:
    unit = INCH if one.startswith("m ") and other.startswith("m ") else 1
    shown = 1e-4 * unit  # rs274 shows less as 0 [interp_convert.cc: convert_param_comment]
    try:
        ours, theirs = (list(map(float, text.removeprefix("m ").split())) for text in (one, other))
    except ValueError:
        return one == other
    pairs = list(zip(ours, [unit * value for value in theirs], strict=True))
    return all(abs(a - b) <= (max(blur, 2e-5) if b else max(blur, shown)) for a, b in pairs)


@dataclass
class Report:
    programs: int = 0
    longer: int = 0  # how many ran longer than the limit of time
    moves: int = 0
    stopped: int = 0
    lost: Counter[str] = field(default_factory=Counter)  # compared only up to there
    worded: Counter[str] = field(default_factory=Counter)  # stops in other words than rs274
    different: list[int] = field(default_factory=list)

    def __str__(self) -> str:
        lines = [
            f"{self.programs} programs, {self.moves} moves, {self.stopped} stopped by a mistake,"
            f" {self.longer} left out as too long, {len(self.different)} different",
            *(f"    {count:>6}  compared up to {why}" for why, count in self.lost.most_common()),
            *(f"    {count:>6}  {words}" for words, count in self.worded.most_common(20)),
        ]
        return "\n".join(lines)


def compare(
    seed: int,
    places: range,
    command: str,
    folder: Path,
    together: int = 1,
    kinds: Sequence[str] = (),
) -> Report:
    """Compare programs; `together` careful ones make one, and each is run by itself if that
    differs.
    """
    rs274 = Rs274(command, folder)
    report = Report()
    for place in places[::together]:
        many = range(place, min(place + together, places.stop))
        judge(report, seed, many, rs274, together > 1, kinds)
    return report


def judge(
    report: Report, seed: int, many: range, rs274: Rs274, together: bool, kinds: Sequence[str] = ()
) -> None:
    text = program(seed, many, together, kinds)
    theirs = rs274.run(text)
    if theirs is None:
        report.longer += len(many)
        return
    ours = on_cncsub(text)
    found = difference(ours, theirs)
    if (found or theirs.lost) and len(many) > 1:
        for place in many:
            judge(report, seed, range(place, place + 1), rs274, together, kinds)
        return
    report.programs += len(many)
    report.moves += len(theirs.moves)
    report.stopped += bool(theirs.error)
    if theirs.lost:
        report.lost[theirs.lost] += 1
    if not found and not theirs.lost and ours.error != theirs.error:
        report.worded[f"{ours.error!r} instead of {theirs.error!r}"] += 1
    if found:
        report.different.append(many.start)
        if len(report.different) <= SHOWN:
            print(f"---- program {many.start} of seed {seed}: {found}\n{text}")


def main() -> int:
    def text(seed: int, numbers: range, kinds: Sequence[str]) -> str:
        return program(seed, numbers, len(numbers) > 1, kinds)

    return canonical.command(__doc__ or "", text, compare, tuple(KINDS))


if __name__ == "__main__":
    sys.exit(main())
