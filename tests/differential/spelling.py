"""Writes a generated program as a control, or LinuxCNC, wants it.

The differences of the controls are left out of the programs, or are handled here:

- P of M98 is count and number, a number, or the N of a block of the same program; the 980TDi and
  980MDi take no L beside a number in P. [the rules program_word and count_and_l]
- X of a lathe is a diameter; I, J, K and R are lengths. In G code system A there is no G90 and
  G91: U and W are the increments. [the rule machine]
- R takes half a circle and more on all but the lathes of the 16i; there the centre is written.
  [the rule negative_radius_on_lathes]
- No number is written without a decimal point: `X10` is 0.010 mm on some, 10 mm on others. [the
  rule whole_numbers]
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from random import Random

from programs import ARCS, CCW, CW, FEED, RAPID, Block, Call, Program

MOTIONS = {RAPID: 0, FEED: 1, CW: 2, CCW: 3}
INCREMENTS = {"X": "U", "Y": "V", "Z": "W"}
CENTRES = {"X": "I", "Y": "J", "Z": "K"}


@dataclass(frozen=True)
class Style:
    """The words that a machine wants its programs in."""

    head: str = "O"  # the letter of a program; empty if a subprogram is a part of the main program
    diameter: bool = False
    increments_by_letter: bool = False  # U and W, no G90 and G91
    count_in_p: bool = False
    count_in_l: bool = True
    reflex_radius: bool = True
    plane_codes: bool = True
    plus_number: int = 0  # keeps the subprograms of many programs in one file apart


class Speller:
    """Writes programs in one style; random is only what means nothing, such as spaces."""

    def __init__(self, style: Style, random: Random) -> None:
        self.style = style
        self.random = random
        self.spaces = random.choice(("", " "))
        self.numbered = bool(style.head) and random.random() < 0.5

    def write(self, program: Program) -> str:
        """Return the whole memory: the main program, and after it the called ones, in any order."""
        called = list(program.called())
        self.random.shuffle(called)
        head = f"{self.style.head or '%'}{program.number}"
        main = [head, *self.body(program), "M30"]
        return "\n".join([*main, *(line for below in called for line in self.below(below))]) + "\n"

    def below(self, program: Program) -> Iterator[str]:
        """Yield a subprogram with its head."""
        number = program.number + self.style.plus_number
        lines = [*self.body(program), "M99"]
        if self.style.head:
            yield f"{self.style.head}{number}"
        else:
            lines[0] = f"N{number}{self.spaces}{lines[0]}"
        yield from lines

    def body(self, program: Program) -> list[str]:
        feed = self.word("F", self.random.randint(1, 500) * 100)
        blocks = [feed, *filter(None, map(self.block, program.blocks))]
        if self.numbered:
            return [f"N{10 * place}{self.spaces}{line}" for place, line in enumerate(blocks, 1)]
        return blocks

    def block(self, block: Block | Call) -> str:
        words = self.call(block) if isinstance(block, Call) else self.words(block)
        return self.spaces.join(words)

    def call(self, call: Call) -> list[str]:
        number = call.program.number + self.style.plus_number
        forms = [["M98", f"P{number}", f"L{call.repeats}"]] if self.style.count_in_l else []
        if self.style.count_in_p:
            forms.append(["M98", f"P{call.repeats}{number:04}"])
        if call.repeats == 1:
            forms.append(["M98", f"P{number}"])
        return self.random.choice(forms)

    def words(self, block: Block) -> list[str]:
        words = []
        if "motion" in block.written:
            code = MOTIONS[block.modes.motion]
            words.append(self.random.choice((f"G{code}", f"G0{code}")))
        if "absolute" in block.written and not self.style.increments_by_letter:
            words.append("G90" if block.modes.absolute else "G91")
        if "plane" in block.written and self.style.plane_codes:
            words.append(f"G{block.modes.plane}")
        for axis, value in block.axes.items():
            incremental = self.style.increments_by_letter and not block.modes.absolute
            letter = INCREMENTS[axis] if incremental else axis
            words.append(self.word(letter, value * (2 if self.doubles(axis) else 1)))
        if block.modes.motion in ARCS:
            words += self.arc_words(block)
        self.random.shuffle(words)
        return words

    def doubles(self, axis: str) -> bool:
        return self.style.diameter and axis == "X"

    def arc_words(self, block: Block) -> Iterator[str]:
        if block.radius and (block.radius > 0 or self.style.reflex_radius):
            yield self.word("R", block.radius)
            return
        for axis in block.centre if block.radius else block.centre_words:
            yield self.word(CENTRES[axis], block.centre[axis])

    def word(self, letter: str, micrometres: int) -> str:
        """Return a word such as `X.5`, `X0.5`, `X0.500`, always with a point."""
        sign = "-" if micrometres < 0 else ""
        whole, decimals = divmod(abs(micrometres), 1000)
        digits = f"{decimals:03}"
        if self.random.random() < 0.7:
            digits = digits.rstrip("0")
        start = "" if whole == 0 and digits and self.random.random() < 0.5 else str(whole)
        return f"{letter}{sign}{start}.{digits}"


class SiemensSpeller(Speller):
    """A speller for SINUMERIK: calls by name, `CR=` for a radius, M17 to return."""

    def write(self, program: Program) -> str:
        called = list(program.called())
        self.random.shuffle(called)
        main = [f"%_N_MAIN{program.number}_MPF", *self.body(program), "M30"]
        return "\n".join([*main, *(line for below in called for line in self.below(below))]) + "\n"

    def below(self, program: Program) -> Iterator[str]:
        yield f"%_N_SUB{program.number}_SPF"
        yield from self.body(program)
        yield self.random.choice(("M17", "RET"))

    def call(self, call: Call) -> list[str]:
        name = f"SUB{call.program.number}"
        return [f"{name} P{call.repeats}" if call.repeats > 1 else name]

    def arc_words(self, block: Block) -> Iterator[str]:
        for text in super().arc_words(block):
            yield f"CR={text[1:]}" if text[0] == "R" else text
