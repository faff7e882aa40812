"""Generate programs and run them on cncsub and on grblHAL itself.

    python tests/differential/grblhal.py --grblhal PATH --programs 20000 --seed 1
    python tests/differential/grblhal.py --show 17

PATH, or the environment variable GRBLHAL, is a program that runs grblHAL's parser without a
machine. It reads lines from its standard input, each a folder and the name of a file in it, runs
the file as one of an SD card, macros of the folder included, and prints what happens: `rapid X Y Z
0`, `feed X Y Z F`, `cw` and `ccw X Y Z F`, and more words after these, `dwell S`, in machine
coordinates; `stop` with `error N`, `flow N` or `eof 0`; and `end` after each file. grblHAL is built
with NGC_EXPRESSIONS_ENABLE and nothing else that is not delivered. The repository has no such
program.

A program has moves, arcs, dwells, modes, work systems, canned cycles, expressions, numbered and
named parameters, branches, loops, subprograms and macros. Some have a mistake. Compared are the
moves, and how the run stopped: at its end, or by which error.

grblHAL computes in numbers of 32 bits: points are compared within that. Programs that cncsub does
not compute are compared up to there.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from random import Random

import cncsub

SHOWN = 5  # how many differences are printed
MAX_BLOCKS = 3000  # the limit of a run; a longer one is left out
TOLERANCE = 2e-3  # mm, and a hundred-thousandth of a coordinate
MISTAKES = (
    "G0 X", "G0 X1 X2", "G0 G1 X1", "G6", "M20", "G1.5", "G0 X1 P2", "G4", "G92", "G10 L2", "G2 X9 R1 F9", "G2 X5 F9",
    "G2 X5 I9 F9", "G0 X[1/0]", "G0 X[SQRT[-1]]", "G0 X#<nobody>", "#5061=1", "#0=1", "#1 5", "G17 G18", "M3 M4", "T-1", "F-1",
    "G80 X1", "[1]", "X[1+", "X[1%2]", "X[FOO[1]]", "G43 H1", "G10 L2 P12 X1", "G43.1", "G0 A5", "G81 X1 Z-1 F9",
    "G81 X1 Z5 R1 F9", "M98", "M98 P70000", "M98 P999", "o9 endif", "o9 foo", "o9 call", "O7", "G53 G2 X1 I1 F9", "G2 R5 F9",
    "G0 X1 R1", "G0 X[-2**0.5]", "G0 X[1 MOD 0]", "G4 P-1", "T1.5", "G38.2 F100", "M99 P5", "o9 break",
)  # fmt: skip


@dataclass
class Writer:
    """Writes one program and its macros."""

    random: Random
    lines: list[str] = field(default_factory=list)
    macros: dict[str, str] = field(default_factory=dict)
    label: int = 0
    depth: int = 0
    loops: list[int] = field(default_factory=list)
    subs: list[int] = field(default_factory=list)
    names: list[str] = field(default_factory=list)
    absolute: bool = True

    def chance(self, share: float) -> bool:
        return self.random.random() < share

    def put(self, line: str) -> None:
        if self.chance(0.1):
            line = line.lower() if self.chance(0.5) else line.replace(" ", "")
        if self.chance(0.05):
            line += self.random.choice((" (c)", " ; c", "  "))
        self.lines.append(line)

    def number(self) -> str:
        r = self.random
        return r.choice(
            (
                str(r.randint(0, 9)),
                str(r.randint(-40, 40)),
                f"{r.uniform(-9, 9):.3f}",
                "0.5",
                "-.25",
            )
        )

    def value(self, deep: int = 0) -> str:
        r = self.random
        kind = r.random()
        if deep > 2 or kind < 0.4:
            return self.number()
        if kind < 0.6:
            if self.names and self.chance(0.4):
                return f"#<{r.choice(self.names)}>"
            return f"#{r.choice((1, 2, 3, 4, 30, 31, 100, 101, 102))}"
        if kind < 0.85:
            operator = r.choice(
                ["+", "-", "*", "EQ", "NE", "LT", "LE", "GT", "GE", "AND", "OR", "XOR"]
            )
            return f"[{self.value(deep + 1)} {operator} {self.value(deep + 1)}]"
        name = r.choice(["ABS", "FIX", "FUP", "ROUND", "SIN", "COS", "SQRT"])
        inner = self.value(deep + 1)
        return f"{name}[ABS[{inner}]]" if name == "SQRT" else f"{name}[{inner}]"

    def small(self) -> str:
        """Return a value that a coordinate may have."""
        return self.number() if self.chance(0.6) else f"[[{self.value()}] MOD 50]"

    def move(self) -> None:
        r = self.random
        words = [f"{axis}{self.small()}" for axis in "XYZ" if self.chance(0.5)]
        head = r.choice(("G0", "G1 F200", "G1 F[100+50]", ""))
        if self.chance(0.08):
            head = f"G53 {r.choice(('G0', 'G1 F100'))}"
            words = words or ["X1"]
        self.put(f"{head} {' '.join(words)}".strip() or "G0 X0")

    def arc(self) -> None:
        r = self.random
        code, feed = r.choice(("G2", "G3")), f"F{r.randint(50, 500)}"
        radius = r.randint(1, 9)
        kind = r.random()
        if kind < 0.4:  # a full circle, perhaps with turns
            turns = f" P{r.randint(1, 3)} Z{self.number()}" if self.chance(0.3) else ""
            self.put(f"G17 {code} I{radius}{turns} {feed}")
        elif kind < 0.8:  # half of one
            self.put(f"G91 G17 {code} X{2 * radius} Y0 I{radius} J0 {feed}")
            self.put("G90" if self.absolute else "G91")
        else:
            end = r.randint(1, 2 * radius)
            self.put(f"G91 G17 {code} X{end} R{r.choice((1, -1)) * (radius + 0.5)} {feed}")
            self.put("G90" if self.absolute else "G91")

    def mode(self) -> None:
        r = self.random
        line = r.choice(
            (
                "G90", "G91", "G54", "G55", "G59.1", "G17", "G18", "G20", "G21", "G94", "G49", "G40", "G61",
                "G92 X1 Y2", "G92.1", "G92.2", "G92.3", "G43.1 Z3.5", "G10 L2 P1 X5 Y-2", "G10 L20 P0 Z4",
                "G10 L2 P2 X[#1]", "G28.1", "G28 Z9", "G28", "G30", "G30.1", "M3 S1000", "M5", "M8", "M9", "G4 P0.5",
                "M70", "M72", "T1", "S500", "F300", "M48", "M49", "G94 F200", "G98", "G99",
            )
        )  # fmt: skip
        self.absolute = self.absolute if line not in ("G90", "G91") else line == "G90"
        self.put(line)

    def assign(self) -> None:
        r = self.random
        if self.chance(0.3):
            name = r.choice(("a", "b", "_g", "_h"))
            self.put(f"#<{name}>={self.value()}")
            if name not in self.names and self.depth == 0:
                self.names.append(name)
            return
        self.put(
            " ".join(
                f"#{r.choice((1, 2, 3, 4, 30, 31, 100, 101, 102))}={self.value()}"
                for _ in range(r.randint(1, 2))
            )
        )

    def cycle(self) -> None:
        r = self.random
        code = r.choice(("G81", "G82 P0.5"))
        self.put("G90 G21 G17 G94 G0 Z5")
        self.absolute = True
        self.put(
            f"{r.choice(('G98', 'G99'))} {code} X{self.number()} Y{self.number()} Z-3 R{r.choice((1, 2, 6))} F100"
        )
        for _ in range(r.randint(0, 2)):
            self.put(f"X{self.number()} {r.choice(('', 'Y2', 'Z-4', 'L2'))}")
        self.put("G80")
        self.put("G0 X0")

    def block(self, budget: int) -> None:
        for _ in range(budget):
            kind = self.random.random()
            if kind < 0.4:
                self.move()
            elif kind < 0.48:
                self.arc()
            elif kind < 0.6:
                self.mode()
            elif kind < 0.75:
                self.assign()
            elif kind < 0.79:
                self.cycle()
            elif kind < 0.9 and self.depth < 3:
                self.structure()
            elif kind < 0.97:
                self.call()
            elif self.chance(0.3):
                self.put(self.random.choice(MISTAKES))

    def structure(self) -> None:
        r = self.random
        self.label += 1
        own = self.label
        self.depth += 1
        kind = r.choice(("if", "if", "while", "do", "repeat"))
        if kind == "if":
            self.put(f"o{own} if [{self.value()}]")
            self.block(r.randint(1, 3))
            for _ in range(r.randint(0, 2)):
                self.put(f"o{own} elseif [{self.value()}]")
                self.block(r.randint(0, 2))
            if self.chance(0.5):
                self.put(f"o{own} else")
                self.block(r.randint(1, 2))
            if self.loops and self.chance(0.3):
                self.put(f"o{r.choice(self.loops)} {r.choice(('break', 'break', 'continue'))}")
            self.put(f"o{own} endif")
        else:
            counter = 110 + own
            self.loops.append(own)
            if kind == "repeat":
                self.put(f"o{own} repeat [{r.randint(0, 3)}]")
            else:
                self.put(f"#{counter}=0")
                self.put(
                    f"o{own} while [#{counter} LT {r.randint(0, 3)}]"
                    if kind == "while"
                    else f"o{own} do"
                )
            self.put(f"#{counter}=[#{counter}+1]")
            self.block(r.randint(1, 3))
            self.loops.pop()
            self.put(
                f"o{own} endrepeat"
                if kind == "repeat"
                else f"o{own} endwhile"
                if kind == "while"
                else f"o{own} while [#{counter} LT {r.randint(0, 3)}]"
            )
        self.depth -= 1

    def sub(self) -> None:
        own = 100 + len(self.subs)
        names, self.names, self.depth = self.names, [], self.depth + 1
        self.put(f"o{own} sub")
        self.block(self.random.randint(1, 4))
        if self.chance(0.2):
            self.put(f"o{own} return [#1+1]")
        self.put(
            f"o{own} endsub"
            + (
                f" [{self.random.choice(('#1*2', '#100', '3', '#31+#2'))}]"
                if self.chance(0.5)
                else ""
            )
        )
        self.names, self.depth = names, self.depth - 1
        self.subs.append(own)

    def macro(self, number: int) -> None:
        lines, self.lines = self.lines, []
        names, self.names, self.depth = self.names, [], self.depth + 1
        subs, self.subs = self.subs, []
        loops, self.loops = self.loops, []
        self.block(self.random.randint(1, 4))
        if self.chance(0.5):
            self.put("M99")
        self.macros[f"P{number}.macro"] = "\n".join(self.lines) + "\n"
        self.lines, self.names, self.depth, self.subs, self.loops = (
            lines,
            names,
            self.depth - 1,
            subs,
            loops,
        )

    def call(self) -> None:
        r = self.random
        if self.depth > 3:
            return
        if self.subs and self.chance(0.6):
            arguments = " ".join(f"[{self.value()}]" for _ in range(r.randint(0, 3)))
            self.put(f"o{r.choice(self.subs)} call {arguments}")
            if self.chance(0.3):
                self.put("#102=#<_value> #101=#<_value_returned>")
            return
        number = r.randint(200, 203)
        if f"P{number}.macro" not in self.macros:
            self.macros[f"P{number}.macro"] = "G0 X1\n"  # no macro calls itself
            self.macro(number)
        passes = r.choice(("", "", " L2"))
        if self.chance(0.5):
            self.put(f"M98 P{number}{passes}")
        else:
            self.put(f"G65 P{number}{passes} A{self.number()} X{self.value()} Z{self.number()}")

    def write(self) -> None:
        for _ in range(self.random.randint(0, 2)):
            self.sub()
        self.put(f"G0 X{self.number()}")
        self.block(self.random.randint(3, 12))
        if self.chance(0.9):
            self.put(self.random.choice(("M2", "M30")))


Row = tuple[str, float, float, float]


@dataclass
class Outcome:
    moves: list[Row]
    stop: str  # "end", an error, or why the run is not compared to its end


def write(seed: int, place: int) -> dict[str, str]:
    """Return the files of a program."""
    writer = Writer(Random(f"{seed} grblhal {place}"))
    writer.write()
    return {"main.nc": "\n".join(writer.lines) + "\n", **writer.macros}


def ours(folder: Path) -> Outcome:
    files = [folder / "main.nc", *sorted(folder.glob("*.macro"))]
    run = cncsub.load(*files, control="grblhal").run(max_blocks=MAX_BLOCKS)
    moves = [(move.kind, move.mx, move.my, move.mz) for move in run.moves]
    rows = [row if row[0] != "dwell" else ("dwell", 0.0, 0.0, 0.0) for row in moves]
    if run.alarm is not None:
        told = run.alarm.number or run.alarm.cause
        return Outcome(rows, told if run.alarm.cause != "code-not-computed" else "not computed")
    return Outcome(rows, "end" if str(run.stop).lower().endswith(("end", "cycles")) else "too long")


def theirs(text: str) -> Outcome:
    moves: list[Row] = []
    stop = "no answer"
    for line in text.splitlines():
        kind, *words = line.split()
        if kind in ("rapid", "feed", "cw", "ccw"):
            moves.append((kind, *(float(word) for word in words[:3])))  # type: ignore[arg-type]
        elif kind == "dwell" and float(words[0]) > 0:
            moves.append(("dwell", 0.0, 0.0, 0.0))
        elif kind == "stop":
            stop = (
                f"error:{words[1]}"
                if words[0] == "error"
                else "end"
                if words[0] in ("flow", "eof")
                else words[0]
            )
    return Outcome(moves, stop)


def going(rows: list[Row]) -> list[Row]:
    """Leave out the moves that go nowhere."""
    kept: list[Row] = []
    at = (0.0, 0.0, 0.0)
    for row in rows:
        nowhere = row[0] in ("rapid", "feed") and all(
            abs(a - b) < 1e-3 for a, b in zip(row[1:], at, strict=True)
        )
        if not nowhere:
            kept.append(row)
        if row[0] != "dwell":
            at = row[1:]
    return kept


def same(one: Row, other: Row) -> bool:
    return one[0] == other[0] and all(
        abs(a - b) <= TOLERANCE + 1e-5 * abs(b) for a, b in zip(one[1:], other[1:], strict=True)
    )


def difference(one: Outcome, other: Outcome) -> str | None:
    """Return the first difference of what we computed and what grblHAL did."""
    mine, its = going(one.moves), going(other.moves)
    for place, (a, b) in enumerate(zip(mine, its, strict=False)):
        if not same(a, b):
            return f"move {place}: {a} here, {b} there"
    if one.stop in ("not computed", "too long") or other.stop in ("no answer", "signal"):
        return None
    if one.stop != other.stop:
        return f"stop: {one.stop} here, {other.stop} there"
    if len(mine) != len(its):
        return f"{len(mine)} moves here, {len(its)} there"
    return None


def compare(command: str, seed: int, places: range, folder: Path) -> tuple[Counter[str], list[str]]:
    """Run programs on both; return how they stopped, and the differences."""
    stops: Counter[str] = Counter()
    differences: list[str] = []
    wanted = []
    for place in places:
        own = folder / str(place)
        own.mkdir()
        for name, text in write(seed, place).items():
            (own / name).write_text(text)
        wanted.append(f"{own} main.nc\n")
    done = subprocess.run(
        [command], input="".join(wanted), capture_output=True, text=True, check=False
    )
    answers = done.stdout.split("end\n")
    for place, answer in zip(places, answers, strict=False):
        one, other = ours(folder / str(place)), theirs(answer)
        stops[one.stop] += 1
        found = difference(one, other)
        if found is not None:
            differences.append(f"program {place}: {found}")
    return stops, differences


def grblhal() -> str | None:
    """Return the program that runs grblHAL, if one is given."""
    return os.environ.get("GRBLHAL")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--grblhal", default=grblhal(), help="a program that runs grblHAL")
    parser.add_argument("--programs", type=int, default=1000, help="how many are tried")
    parser.add_argument("--first", type=int, default=0, help="the place of the first one")
    parser.add_argument("--seed", type=int, default=1, help="which series of programs")
    parser.add_argument("--show", type=int, metavar="PLACE", help="print this one, run none")
    options = parser.parse_args()
    if options.show is not None:
        for name, text in write(options.seed, options.show).items():
            print(f"---- {name}\n{text}", end="")
        return 0
    if options.grblhal is None:
        print("grblHAL: skipped, neither --grblhal nor GRBLHAL gives a program that runs it")
        return 0
    with tempfile.TemporaryDirectory() as folder:
        places = range(options.first, options.first + options.programs)
        stops, differences = compare(options.grblhal, options.seed, places, Path(folder))
    print(f"{options.programs} programs, seed {options.seed}:")
    print("\n".join(f"    {count:>8}  {stop}" for stop, count in stops.most_common()))
    print("\n".join(differences[:SHOWN]))
    print(f"{len(differences)} differences")
    return 1 if differences else 0


if __name__ == "__main__":
    sys.exit(main())
