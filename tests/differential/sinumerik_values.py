"""Generate the expressions of SINUMERIK programs."""

from __future__ import annotations

from dataclasses import dataclass, field
from random import Random

import sinumerik_language as l

# What a program may use. A name is taken out of the programs by `NOT_COMPUTED` of `sinumerik.py`.
FEATURES = (
    "while", "for", "loop", "repeat", "case", "jumps", "several jumps", "again", "calls", "var",
    "defaults", "arrays", "bits", "new functions", "increments", "frames", "booleans", "computed R",
    "AND in comparisons", "texts", "save", "frames in SAVE", "var elements", "modal calls",
    "RET to a block", "polar", "arcs", "zero points", "planes", "skipped blocks", "constants",
    "frame values", "axes", "characters",
)  # fmt: skip
OLD_FUNCTIONS = (
    "SIN",
    "COS",
    "TAN",
    "SQRT",
    "ABS",
    "POT",
    "TRUNC",
    "ROUND",
    "ATAN2",
    "ASIN",
    "LN",
    "EXP",
)
NEW_FUNCTIONS = ("ROUNDUP", "MINVAL", "MAXVAL", "BOUND")
R_NUMBERS = range(1, 8)  # the parameters that the programs use


def integer(value: int) -> l.Number:
    return l.Number(str(value))


def real(value: float) -> l.Number:
    return l.Number(f"{value:.3f}")


@dataclass
class Known:
    """The names that a program may use, by type."""

    numbers: dict[str, list[str]] = field(
        default_factory=lambda: {
            kind: [] for kind in ("INT", "REAL", "BOOL", "STRING", "CHAR", "AXIS", "FRAME")
        }
    )
    fixed: list[str] = field(default_factory=list)  # counters of loops: they are read only
    arrays: dict[str, tuple[str, tuple[int, ...]]] = field(default_factory=dict)


@dataclass
class ValueWriter:
    """Writes expressions of the names that are known."""

    random: Random
    features: frozenset[str]
    careful: bool = False  # write nothing that may alarm
    known: Known = field(default_factory=Known)

    def chance(self, share: float) -> bool:
        return self.random.random() < share

    def has(self, feature: str) -> bool:
        return feature in self.features

    def number(self) -> l.Expression:
        r = self.random
        if self.has("constants") and self.chance(0.05):
            return l.Number(r.choice(("'H1F'", "'B1011'", "1.5EX1", "2.5EX-1", "'HA'", ".5", "7.")))
        return r.choice(
            (integer(r.randint(0, 9)), integer(r.randint(0, 40)), real(r.uniform(0, 9)))
        )

    def readable(self) -> l.Expression:
        r = self.random
        numbers = self.known.numbers
        names = [*numbers["INT"], *numbers["REAL"], *numbers["CHAR"], *self.known.fixed]
        if numbers["FRAME"] and self.chance(0.15):
            return self.part(r.choice(("TR", "FI", "RT", "SC", "MI")))
        if names and self.chance(0.5):
            return l.Variable(r.choice(names))
        if self.known.arrays and self.chance(0.3):
            return self.element()
        return self.parameter()

    def axis(self) -> str:
        """Return an axis, or a variable of one."""
        names = self.known.numbers["AXIS"]
        return (
            self.random.choice(names) if names and self.chance(0.3) else self.random.choice("XYZ")
        )

    def frame_name(self) -> l.FrameName:
        names = self.known.numbers["FRAME"]
        return l.FrameName(self.random.choice((*names, *names, "$P_PFRAME")))

    def part(self, name: str) -> l.Part:
        return l.Part(self.frame_name(), self.axis(), name)

    def parameter(self) -> l.Parameter:
        number = self.random.choice(R_NUMBERS)
        if self.has("computed R") and self.chance(0.1):
            return l.Parameter(l.Binary("+", integer(number - 1), integer(1)))
        return l.Parameter(number)

    def element(self) -> l.Element:
        r = self.random
        name = r.choice(list(self.known.arrays))
        size = self.known.arrays[name][1]
        return l.Element(name, tuple(self.index(count) for count in size))

    def index(self, count: int) -> l.Expression:
        r = self.random
        if self.known.fixed and self.chance(0.5):
            return l.Binary("MOD", l.Variable(r.choice(self.known.fixed)), integer(count))
        return integer(r.randrange(count))

    def value(self, deep: int = 0) -> l.Expression:
        """Return a number."""
        kind = self.random.random()
        if deep > 2 or kind < 0.3:
            return self.number()
        if kind < 0.55:
            return self.readable()
        if kind < 0.62:
            return l.Unary(
                "NEGATIVE", self.readable() if self.chance(0.6) else self.value(deep + 1)
            )
        if kind < 0.85:
            return self.operation(deep)
        if kind < 0.88 and self.has("bits"):
            return self.bits()
        if self.has("texts") and self.chance(0.1):
            return self.about_letters()
        if kind < 0.9 and self.has("booleans"):
            return l.Binary("*", self.value(deep + 1), self.truth(deep + 1))
        return self.function(deep)

    def operation(self, deep: int) -> l.Expression:
        op = self.random.choice(("+", "-", "*", "+", "-", "*", "/", "DIV", "MOD"))
        left, right = self.value(deep + 1), self.value(deep + 1)
        if op in ("DIV", "MOD"):
            left = l.Function("ABS", (left,))
        if op in ("/", "DIV", "MOD") and (self.careful or self.chance(0.97)):
            right = l.Binary("+", l.Function("ABS", (right,)), integer(1))
        return l.Binary(op, left, right)

    def bits(self) -> l.Expression:
        r = self.random
        one, other = (integer(r.randrange(64)) for _ in range(2))
        whole = self.known.fixed or []
        left: l.Expression = l.Variable(r.choice(whole)) if whole and self.chance(0.5) else one
        if self.chance(0.15):
            left = l.Unary("B_NOT", left)
        inner = l.Binary(r.choice(("B_AND", "B_OR", "B_XOR")), left, other)
        return l.Binary("B_OR", inner, integer(r.randrange(8))) if self.chance(0.3) else inner

    def function(self, deep: int) -> l.Expression:
        r = self.random
        names = OLD_FUNCTIONS + (NEW_FUNCTIONS if self.has("new functions") else ())
        name, value = r.choice(names), self.value(deep + 1)
        if name == "SQRT" and (self.careful or self.chance(0.95)):
            value = l.Function("ABS", (value,))
        if name == "LN":
            value = l.Binary("+", l.Function("ABS", (value,)), integer(1))
        if name == "EXP":
            value = l.Binary("MOD", l.Function("ABS", (value,)), integer(9))
        if name == "ASIN":
            value = l.Function("SIN", (value,))
        if name in ("ATAN2", "MINVAL", "MAXVAL"):
            return l.Function(name, (value, self.value(deep + 1)))
        if name == "BOUND":
            return l.Function(name, (integer(r.randint(-5, 0) + 5), integer(20), value))
        return l.Function(name, (value,))

    def letters(self, deep: int = 0) -> l.Expression:
        """Return a text."""
        r = self.random
        kind = r.random()
        names = self.known.numbers["STRING"]
        if deep < 2 and kind < 0.3:
            return l.Binary("<<", self.letters(deep + 1), self.letters(deep + 1))
        if deep < 2 and kind < 0.4:
            whole = integer(r.randint(0, 999))
            return l.Binary("<<", self.letters(deep + 1), whole)
        if deep < 2 and kind < 0.5:
            return l.Function(r.choice(("TOUPPER", "TOLOWER")), (self.letters(deep + 1),))
        if deep < 2 and kind < 0.6:
            count = integer(r.randint(1, 3))
            return l.Function("SUBSTR", (self.letters(deep + 1), integer(r.randint(0, 2)), count))
        if names and kind < 0.85:
            return l.Variable(r.choice(names))
        return l.Text(r.choice(("abc", "Part 7", "ABC", "x; y", "", "a-b.c")))

    def about_letters(self) -> l.Expression:
        """Return a number that tells of a text."""
        r = self.random
        name = r.choice(("STRLEN", "INDEX", "RINDEX", "NUMBER", "ISNUMBER", "MINDEX"))
        if name == "ISNUMBER":
            return l.Function(name, (l.Text(r.choice(("12.5", "-3", "A1", "", "x"))),))
        if name == "MINDEX":
            return l.Function(name, (self.letters(), l.Text(r.choice(("ab", "7P", "z")))))
        if name == "NUMBER":
            return l.Function(name, (l.Text(r.choice(("12.5", "-3", "0.25"))),))
        if name == "STRLEN":
            return l.Function(name, (self.letters(),))
        return l.Function(name, (self.letters(), l.Text(r.choice("abc7A "))))

    def truth(self, deep: int = 0) -> l.Expression:
        """Return a condition."""
        r = self.random
        kind = r.random()
        names = self.known.numbers["BOOL"]
        if deep < 2 and kind < 0.25:
            left, right = self.truth(deep + 1), self.truth(deep + 1)
            return l.Binary(r.choice(("AND", "OR", "XOR")), left, right)
        if deep < 2 and kind < 0.32:
            return l.Unary("NOT", self.truth(deep + 1))
        if names and kind < 0.5:
            return l.Variable(r.choice(names))
        if kind < 0.55:
            return l.Truth(self.chance(0.5))
        if self.has("texts") and self.chance(0.1):
            return l.Binary(r.choice(("==", "<>")), self.letters(1), self.letters(1))
        op = r.choice(("==", "<>", "<", ">", "<=", ">="))
        if self.has("AND in comparisons") and self.chance(0.08):
            # A comparison is weaker than AND: this is 1==((..) AND (..)).
            return l.Binary(op, integer(1), l.Binary("AND", self.truth(deep + 2), l.Truth(True)))
        return l.Binary(op, self.readable(), self.value(deep + 1))

    def length(self) -> l.Expression:
        """Return a length that stays small, whatever the values are."""
        r = self.random
        if self.chance(0.5):
            number = l.Number(r.choice((str(r.randint(0, 60)), f"{r.uniform(0, 60):.3f}")))
            return l.Unary("NEGATIVE", number) if self.chance(0.2) else number
        return l.Binary("MOD", l.Function("ABS", (self.value(1),)), integer(50))
