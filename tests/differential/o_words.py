"""Generate programs of O-words and run them on cncsub and on LinuxCNC's interpreter `rs274`.

    python tests/differential/o_words.py --programs 100000 --seed 1
    python tests/differential/o_words.py --show 17

A program has subprograms of both kinds, branches and loops inside each other, expressions, numbered
and named parameters, messages, rapid and feed moves and arcs. Some have a mistake: a label that is
used twice, a subprogram that is not there, a division by 0. Compared are the moves, the messages,
and how the run stopped: at its end, or by which error in which words.

The programs leave out what rs274 computes without a check, and cncsub refuses: a MOD by 0 right in
the brackets of a condition, an argument or a returned value; and an M99 with words in the main
program.
"""

from __future__ import annotations

import sys
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from random import Random

import canonical
import cncsub
from canonical import TOLERANCE

SHOWN = 5  # how many differences are printed
MAX_BLOCKS = 20_000  # the limit of a run; a longer one is left out
SECONDS = 20


@dataclass
class Writer:
    """Writes one program."""

    random: Random
    base: int = 0  # labels begin after it, so that the programs of one file have different ones
    careful: bool = False  # write nothing that may stop the program
    lines: list[str] = field(default_factory=list)
    label: int = 0
    depth: int = 0
    loops: list[tuple[str, int]] = field(default_factory=list)
    names: list[str] = field(default_factory=list)
    inside: str = ""  # the subprogram that is being written
    subs: list[tuple[str, int]] = field(default_factory=list)  # for O calls: label, arguments
    programs: list[int] = field(default_factory=list)  # for M98

    def chance(self, share: float) -> bool:
        return self.random.random() < share

    def slip(self, share: float) -> bool:
        """Return whether to do what may stop the program."""
        return self.chance(share) and not self.careful

    def put(self, line: str) -> None:
        if self.chance(0.1):
            line = line.upper() if self.chance(0.5) else line.replace(" ", "")
        if self.chance(0.05):
            line += self.random.choice((" (c)", " ; c", "  "))
        self.lines.append(line)

    # ---- values ----

    def number(self) -> str:
        r = self.random
        return r.choice(
            (str(r.randint(0, 5)), str(r.randint(0, 40)), f"{r.uniform(0, 9):.3f}", "0.5")
        )

    def variable(self) -> str:
        r = self.random
        if self.names and self.chance(0.4):
            return f"#<{r.choice(self.names)}>"
        if self.chance(0.04):
            return r.choice(("#<_value>", "#<_value_returned>", "#<_x>", "#<_call_level>", "#5421"))
        if self.slip(0.03):
            return r.choice(("##1", "#[#2 + 100]", "#[1 + 1]", "#<nobody>", "#<_nobody>"))
        if self.chance(0.05):
            return f"#{r.randint(5, 29)}"
        return f"#{r.choice((1, 2, 3, 4, 30, 31, 100, 101, 102))}"

    def value(self, deep: int = 0) -> str:
        r = self.random
        kind = r.random()
        if deep > 2 or kind < 0.35:
            return self.number()
        if kind < 0.7:
            return ("-" if self.chance(0.1) else "") + self.variable()
        if kind < 0.9:
            return self.expression(deep + 1)
        name = r.choice(
            (
                "sin",
                "cos",
                "tan",
                "abs",
                "fix",
                "fup",
                "round",
                "sqrt",
                "exists",
                "atan",
                "asin",
                "acos",
                "ln",
                "exp",
            )
        )
        if name == "exists":
            return f"exists[{r.choice((self.variable(), '#<_g>', '#<q>', '#7'))}]".replace(
                "exists[-", "exists["
            )
        if name == "atan":
            return f"atan[{self.value(deep + 1)}]/[{self.value(deep + 1)}]"
        if name in ("sqrt", "ln") and not self.slip(0.1):
            return f"{name}[abs[{self.value(deep + 1)}]+1]"
        if name in ("asin", "acos") and not self.slip(0.1):
            return f"{name}[sin[{self.value(deep + 1)}]]"
        if name == "exp":
            return f"exp[sin[{self.value(deep + 1)}]]"
        if name == "tan":
            return f"tan[[{self.value(deep + 1)}] mod 80]"
        return f"{name}[{self.value(deep + 1)}]"

    def expression(self, deep: int = 0) -> str:
        r = self.random
        words = [self.value(deep + 1)]
        for _ in range(r.choice((0, 1, 1, 1, 2, 3))):
            op = r.choice(
                [
                    "+",
                    "-",
                    "*",
                    "+",
                    "-",
                    "*",
                    "/",
                    "mod",
                    "**",
                    "eq",
                    "ne",
                    "lt",
                    "gt",
                    "le",
                    "ge",
                    "and",
                    "or",
                    "xor",
                ]
            )
            right = self.value(deep + 1)
            if op == "mod" or (op == "/" and not self.slip(0.03)):
                right = f"[abs[{right}]+1]"
            if op == "**":
                right = str(r.randint(0, 3))
            words += [op, right]
        return f"[{' '.join(words)}]"

    def length(self) -> str:
        """Return a length that stays small, whatever the values are."""
        return self.number() if self.chance(0.5) else f"[[{self.value(1)}] mod 50]"

    def condition(self) -> str:
        if self.chance(0.6):
            op = self.random.choice(["eq", "ne", "lt", "gt", "le", "ge"])
            return f"[{self.variable()} {op} {self.value(2)}]"
        return self.expression(1)

    # ---- lines ----

    def new_label(self) -> str:
        self.label += 1
        if self.label > 2 and self.slip(0.006):
            return f"o{self.random.randint(1, self.label - 1)}"  # a label that is used twice
        return f"o{self.base + self.label}"

    def target(self) -> str:
        r = self.random
        if self.chance(0.3):
            name = r.choice(("a", "b", "_g", "_h", "q"))
            if name != "q" and name not in self.names and self.depth == 0:
                self.names.append(name)
            return f"#<{name}>"
        if self.chance(0.05):
            return "#[fix[#2 mod 3] + 101]"
        return f"#{r.choice((1, 2, 3, 4, 31, 100, 101, 102))}"

    def line(self) -> None:
        r = self.random
        kind = r.random()
        if kind < 0.34:
            axes = "".join(f" {axis}{self.length()}" for axis in "XYZ" if self.chance(0.5))
            word = r.choice(("G0", "G0", "G1", "g01"))
            feed = f" F{r.randint(1, 500)}" if self.chance(0.2) else ""
            front = r.choice(("", "", "", f"N{r.randint(1, 999)} ", "/ ", "G90 ", "G17 "))
            self.put(f"{front}{word}{axes or ' X1'}{feed}")
        elif kind < 0.4:
            self.arc()
        elif kind < 0.68:
            count = r.choice((1, 1, 1, 1, 2))
            parts = [f"{self.target()} = {self.value()}" for _ in range(count)]
            if self.chance(0.07):
                parts.append(f"G0 X{self.length()}")
            self.put(" ".join(parts))
        elif kind < 0.74:
            self.message()
        elif kind < 0.76:
            said = r.choice(
                ("(msg, said #1)", "(MSG,%d)", "(msg; a)", "(a)(msg, b)", "(msg, a)(b)")
            )
            self.lines.append(said)
        elif kind < 0.9:
            self.call()
        elif self.loops and kind < 0.94:
            label = r.choice(self.loops)[0]
            condition = self.new_label()
            self.put(f"{condition} if {self.condition()}")
            self.put(f"{label} {r.choice(('break', 'continue'))}")
            self.put(f"{condition} endif")
        elif self.inside and kind < 0.97:
            condition = self.new_label()
            self.put(f"{condition} if {self.condition()}")
            value = f" {self.expression(1)}" if self.chance(0.6) else ""
            self.put("M99" if self.inside == "M99" else f"{self.inside} return{value}")
            self.put(f"{condition} endif")
        elif self.slip(0.05):
            self.mistake()

    def message(self) -> None:
        r = self.random
        text = f"{r.choice(('debug', 'print', 'DEBUG', ' Print', 'debug'))},"
        for _ in range(r.choice((1, 1, 2, 3))):
            format = r.choice(
                ("", "", "", "%d", "%f", f"%.{r.randint(0, 9)}f", "%", "%g", "%.x", "#x")
            )
            text += f"{r.choice((' ', ' v ', ''))}{format}{self.variable()}"
        if "[" not in text:  # a message does not compute these
            self.lines.append(f"({text})" + r.choice(("", "", "", "; c")))

    def arc(self) -> None:
        r = self.random
        self.put("G0 X0 Y0")
        code = r.choice(("G2", "G3"))
        if self.chance(0.5):
            self.put(f"{code} X{r.choice((6, 8, 10))} Y0 R{r.choice((5, 6, -7))} F100")
        else:
            self.put(f"{code} X{r.choice((0, 10))} Y0 I5 J0 F100")

    def call(self) -> None:
        r = self.random
        if self.programs and self.chance(0.4):
            repeat = r.choice(("", "", " L1", " L2", " L3", " L0" if self.slip(0.2) else ""))
            number = r.choice(self.programs)
            if self.slip(0.05):
                repeat = f" L{self.variable()}"
            if self.chance(0.05):  # words that do nothing, and some that are refused
                beside = ("X1", "G0", "G90 M8", "F100 S5", "G0 Y1", "T0")
                wrong = ("H1", "D1", "E1", "I1", "J1", "K1", "Q1", "R1", "Q1 X1", "I1 X1", "G4")
                repeat += f" {r.choice(wrong if self.slip(0.5) else beside)}"
            if self.slip(0.05):
                self.put(f"M98 P{self.variable()}{repeat}")
            else:
                self.put(f"M98 P{number if self.chance(0.8) else f'[{number - 1} + 1]'}{repeat}")
        elif self.subs:
            label, most = r.choice(self.subs)
            count = r.choice((29, 30)) if self.chance(0.02) else r.randint(0, most)
            count = 31 if self.slip(0.003) else count
            arguments = [self.expression(1) if count < 5 else f"[{n}]" for n in range(count)]
            number = label[1:]
            if number.isdigit() and self.chance(0.1):
                label = r.choice((f"o[{number}]", f"o[{int(number) - 1} + 1]", f"o0{number}"))
            between = r.choice((" ", "", " (c) " if count < 5 else " "))
            self.put(f"{label} call {between.join(arguments)}")

    def mistake(self) -> None:
        self.put(
            self.random.choice(
                (
                    "o999 call",
                    "M98 P999",
                    "o998 endif",
                    "o997 else",
                    "o996 break",
                    "o995 foo",
                    "G0 X1 X2",
                    "M98 P1.5",
                    "o994 if 1",
                    "#31 = [1/0]",
                    "#31 = sqrt[-1]",
                    "#9999 = 1",
                    "o993 endsub",
                    "G0 X1 M98 P1",
                    "M55",
                    "o990 sub",
                    "o1 do",
                    "o989 endwhile",
                    "o988 endrepeat",
                    "o987 continue",
                    "o986 elseif [1]",
                    "o985 return [3]",
                    "o<nobody> call [1]",
                    "o984 while 1",
                    "o983 repeat [1] G0",
                    "M98",
                    "M98 P1 L-1",
                    *(("M99 P1",) if self.inside == "M99" else ()),
                    "(abort, %d#1 stop)",
                    "(a (b))",
                    "(a",
                    "G0 X",
                    "G0 X1 $",
                    "G0 G1 X1",
                    "G37",
                    "M250",
                    "#0 = 1",
                    "#1 5",
                    "#<_x> = 1",
                    "#5420 = 1",
                    "#31 = [1 foo 2]",
                    "#31 = foo[1]",
                    "#31 = [1",
                    "#31 = ln[0]",
                    "#31 = exp[1000]",
                    "#31 = asin[2]",
                    "#31 = sin 30",
                    "#31 = atan[1]",
                    "#31 = 1.2.3",
                    "#31 =",
                    "#<a = 1",
                    "#31 = [[5 mod 0] + 1]",
                    "G0 X1 N5",
                    "G2 X1 Y1 F10",
                    "G2 X9 Y0 R1 F10",
                    "o1.5 if [1]",
                    "#31 = 1 " + "(" + "c" * 260 + ")",
                    "G0 X1 ü",
                    "#31 = [[-8] ** 0.5]",
                    "G0 X#1.5",
                )
            )
        )

    def block(self, budget: int) -> None:
        """Write some lines, with branches and loops among them."""
        for _ in range(budget):
            kind = self.random.random()
            if self.depth >= 3 or kind < 0.72:
                self.line()
                continue
            self.depth += 1
            if kind < 0.84:
                self.branch()
            else:
                self.loop()
            self.depth -= 1

    def branch(self) -> None:
        label = self.new_label()
        self.put(f"{label} if {self.condition()}")
        self.block(self.random.randint(0, 3))
        for _ in range(self.random.choice((0, 0, 1, 2))):
            self.put(f"{label} elseif {self.condition()}")
            self.block(self.random.randint(0, 2))
        if self.chance(0.5):
            self.put(f"{label} else")
            self.block(self.random.randint(0, 2))
        if not self.slip(0.005):
            self.put(f"{label} endif")

    def loop(self) -> None:
        r = self.random
        label = self.new_label()
        count = f"#<c{label[1:]}>"
        self.lines.append(f"{count} = 0")
        kind = r.choice(("while", "do", "repeat"))
        if kind == "repeat":
            self.put(
                f"{label} repeat [{r.choice(('2', '3', '0', '1.5', '2.5', '#<c' + label[1:] + '> + 2'))}]"
            )
        elif kind == "while":
            self.put(f"{label} while [{count} lt {r.randint(0, 3)}]")
        else:
            self.put(f"{label} do")
        self.lines.append(f"{count} = [{count} + 1]")
        self.loops.append((label, self.depth))
        breaks = self.loops if kind != "repeat" or self.slip(0.03) else self.loops[:-1]
        kept, self.loops = self.loops, list(breaks)
        self.block(r.randint(1, 3))
        self.loops = kept
        self.loops.pop()
        if kind == "do":
            self.put(f"{label} while [{count} lt {r.randint(1, 3)}]")
        else:
            self.put(f"{label} end{kind}")

    # ---- programs ----

    def program(self) -> str:
        tape = self.chance(0.1)
        head, main, behind = self.parts()
        end = self.random.choice(("M2", "M30", "M2", "M99")) if not self.slip(0.03) else "G0 X0"
        lines = [*head, *main, end, *behind]
        return "\n".join(["%", *lines, "%"] if tape else lines) + "\n"

    def parts(self) -> tuple[list[str], list[str], list[str]]:
        """Return what stands before the main program, the main program, and what stands after its
        end.
        """
        r = self.random
        subs = range(self.base + 801, self.base + 801 + r.randint(0, 3))
        words = [(r.choice((f"o{n}", f"o<s{n}>", f"o<Sub {n}>")), r.randint(0, 3)) for n in subs]
        numbers = [self.base + 900 + n for n in range(r.randint(0, 2))]
        definitions: list[tuple[bool, list[str]]] = []
        for place, (label, _) in enumerate(words):
            self.lines = []
            # A subprogram calls later ones, and now and then itself.
            self.subs = words[place + 1 :] + ([words[place]] if self.slip(0.1) else [])
            self.programs = numbers
            self.inside, self.names, self.depth, self.loops = label, ["_g"], 0, []
            self.lines.append(f"{label} sub")
            self.block(r.randint(1, 5))
            self.lines.append(
                f"{label} endsub" + (f" {self.expression(1)}" if self.chance(0.3) else "")
            )
            definitions.append((self.chance(0.5), self.lines))
        for place, number in enumerate(numbers):
            self.lines = []
            self.subs = words if self.slip(0.2) else []
            self.programs = numbers[place + 1 :]
            self.inside, self.names, self.depth, self.loops = "M99", ["_g"], 0, []
            self.lines.append(f"O{number:04d}")
            self.block(r.randint(1, 4))
            self.lines.append("M99")
            definitions.append((False, self.lines))
        self.lines = []
        self.subs, self.programs, self.inside = words, numbers, ""
        self.names, self.depth, self.loops = ["_g"], 0, []
        self.block(r.randint(2, 9))
        head = ["F100 (head)", "#<_g> = 1", "#<_h> = 2", "G0 X0 Y0 Z0"]
        head += [line for first, lines in definitions if first for line in lines]
        behind = [line for first, lines in definitions if not first for line in lines]
        return head, self.lines, behind


def generate(seed: int, place: int) -> str:
    return Writer(Random(f"{seed} {place} o-words")).program()


def generate_many(seed: int, places: range) -> str:
    """Return many programs as one, for a process is slow to start; none of them has a mistake."""
    main: list[str] = []
    behind: list[str] = []
    for n, place in enumerate(places):
        writer = Writer(Random(f"{seed} {place} o-words together"), 10_000 * (n + 1), careful=True)
        head, own, rest = writer.parts()
        main += [*head, *own]
        behind += rest
    return "\n".join([*main, "M2", *behind]) + "\n"


# ---- results ----


@dataclass
class Outcome:
    moves: list[tuple[str, float, float, float]]
    messages: list[str]
    error: str  # the text of the error; empty at the end
    cause: str = ""  # the name of the cause in cncsub


def on_cncsub(text: str) -> Outcome | None:
    run = cncsub.loads(text, control="linuxcnc", name="main.ngc").run(
        max_blocks=MAX_BLOCKS * (1 + len(text) // 5000), setup=cncsub.Setup(increment=1e-7)
    )
    if run.stop not in (cncsub.Stop.END, cncsub.Stop.ALARM):
        return None
    moves = [(m.kind, m.x, m.y, m.z) for m in run.moves]
    messages = list(run.messages)
    if run.alarm is None:
        return Outcome(_with_length(moves), messages, "")
    return Outcome(_with_length(moves), messages, run.alarm.text or "", run.alarm.cause)


class Rs274:
    """Runs programs in files of a folder."""

    def __init__(self, command: str, folder: Path) -> None:
        self.folder = folder
        self.interpreter = canonical.Rs274(command, folder, SECONDS)

    def run(self, text: str) -> Outcome | None:
        (self.folder / "main.ngc").write_text(text)
        made = self.interpreter.run()
        if made is None:
            return None
        moves = [(m.kind, m.end["X"], m.end["Y"], m.end["Z"]) for m in made.travel]
        return Outcome(_with_length(moves), made.messages, made.errors[0] if made.errors else "")


def _with_length(
    moves: list[tuple[str, float, float, float]],
) -> list[tuple[str, float, float, float]]:
    """Return the moves without the straight ones that end where they start."""
    kept, at = [], (0.0, 0.0, 0.0)
    for kind, *end in moves:
        if kind in ("cw", "ccw") or any(
            abs(a - b) > TOLERANCE / 2 for a, b in zip(at, end, strict=True)
        ):
            kept.append((kind, *end))
            at = tuple(end)  # type: ignore[assignment]
    return kept  # type: ignore[return-value]


def same(ours: Outcome, theirs: Outcome) -> bool:
    return (
        ours.error.rstrip() == theirs.error.rstrip()
        and [m.rstrip() for m in ours.messages] == [m.rstrip() for m in theirs.messages]
        and len(ours.moves) == len(theirs.moves)
        and all(
            a[0] == b[0] and all(abs(x - y) <= TOLERANCE for x, y in zip(a[1:], b[1:], strict=True))
            for a, b in zip(ours.moves, theirs.moves, strict=True)
        )
    )


@dataclass
class Report:
    programs: int = 0
    longer: int = 0  # how many ran longer than the limit of blocks or time
    moves: int = 0
    errors: Counter[str] = field(default_factory=Counter)
    different: list[int] = field(default_factory=list)

    def __str__(self) -> str:
        errors = ", ".join(f"{count} {cause}" for cause, count in self.errors.most_common())
        return (
            f"{self.programs} programs, {self.moves} moves, {self.longer} left out as too long, "
            f"{len(self.different)} different\nstopped by: {errors}"
        )


def compare(seed: int, places: range, command: str, folder: Path, together: int = 1) -> Report:
    """Compare programs; `together` careful ones make one."""
    rs274 = Rs274(command, folder)
    report = Report()
    for place in places[::together]:
        many = range(place, min(place + together, places.stop))
        text = generate(seed, place) if together == 1 else generate_many(seed, many)
        ours = on_cncsub(text)
        theirs = rs274.run(text) if ours is not None else None
        if ours is None or theirs is None:
            report.longer += len(many)
            continue
        report.programs += len(many)
        report.moves += len(theirs.moves)
        if ours.cause:
            report.errors[ours.cause] += 1
        if same(ours, theirs):
            continue
        report.different.append(place)
        if len(report.different) <= SHOWN:
            print(f"---- program {place} of seed {seed}\n{text}\ncncsub: {ours}\nrs274: {theirs}")
    return report


def main() -> int:
    def text(seed: int, numbers: range) -> str:
        alone = len(numbers) == 1
        return generate(seed, numbers.start) if alone else generate_many(seed, numbers)

    return canonical.command(__doc__ or "", text, compare)


if __name__ == "__main__":
    sys.exit(main())
