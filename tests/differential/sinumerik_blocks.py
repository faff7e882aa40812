"""Generate the blocks of SINUMERIK programs: moves, calls, frames and structures.

Every program ends: each loop has a counter of its own, and a jump back is guarded by one.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import pairwise

import sinumerik_language as l
from sinumerik_moves import MoveWriter
from sinumerik_values import integer


@dataclass
class BlockWriter(MoveWriter):
    """Writes the blocks of a program."""

    programs: dict[str, l.Program] = field(default_factory=dict)
    callable: list[str] = field(default_factory=list)
    modal: list[str] = field(default_factory=list)  # what MCALL may call
    plain: bool = False  # write no calls

    # ---- blocks ----

    def line(self) -> None:
        kind = self.random.random()
        if kind < 0.42:
            self.move()
        elif kind < 0.72:
            self.assignment()
        elif kind < 0.82 and self.has("calls") and not self.plain:
            self.call()
        elif kind < 0.90 and self.has("frames"):
            self.frame()
        elif kind < 0.96:
            self.special()
        else:
            self.move()

    def special(self) -> None:
        ways = [self.pass_]
        if self.has("polar"):
            ways.append(self.polar)
        if self.has("arcs"):
            ways.append(self.arc)
        if self.has("zero points"):
            ways += [self.zero_point, self.machine_move]
        if self.has("planes"):
            ways.append(self.plane)
        if self.known.numbers["FRAME"]:
            ways += [self.frame_values] * 2
        if self.known.numbers["AXIS"]:
            ways.append(self.axis_assignment)
        if self.has("frame values") and self.here.name == "MAIN" and self.has("zero points"):
            ways.append(self.stored_frame)
        if self.modal and not self.plain and self.has("modal calls"):
            ways += [self.modal_call] * 3
        self.random.choice(ways)()

    def modal_call(self) -> None:
        """Write blocks that move while MCALL is in force."""
        of = self.programs[self.random.choice(self.modal)]
        self.put(l.Modal(of.name, self.arguments(of)))
        for _ in range(self.random.randint(1, 3)):
            if self.chance(0.3):
                self.assignment()
            self.move()
        self.put(l.Modal())
        self.everywhere()

    def target(self) -> tuple[l.Target, str]:
        """Return what is assigned to, and its type."""
        r = self.random
        kind = r.choice(("R", "R", "INT", "REAL", "BOOL", "STRING", "CHAR", "array"))
        names = self.known.numbers.get(kind, [])
        if self.plain:  # what the next call of MCALL finds in a parameter is open
            names = [name for name in names if not name.startswith("GIVEN")]
        if names:
            return l.Variable(r.choice(names)), kind
        if kind == "array" and self.known.arrays:
            element = self.element()
            return element, self.known.arrays[element.name][0]
        return self.parameter(), "REAL"

    def assignment(self) -> None:
        to, kind = self.target()
        if kind == "STRING":
            self.put(l.Assign(((to, self.letters()),)))
            return
        value = self.truth() if kind == "BOOL" else self.value()
        if kind == "REAL" and self.has("booleans") and self.chance(0.1):
            value = self.truth()
        if kind != "BOOL" and (kind == "CHAR" or self.chance(0.5)):
            value = l.Binary("MOD", l.Function("ABS", (value,)), integer(97))
        self.put(l.Assign(((to, value),)))

    def axis_assignment(self) -> None:
        names = self.known.numbers["AXIS"]
        value: l.Expression = l.AxisName(self.random.choice("XYZ"))
        if self.chance(0.3):
            value = l.Variable(self.random.choice(names))
        self.put(l.Assign(((l.Variable(self.random.choice(names)), value),)))

    def call(self) -> None:
        if not self.callable:
            return
        of = self.programs[self.random.choice(self.callable)]
        # Whether SAVE gives the G codes back after each pass or after the last is open.
        times = 1 if of.save else self.random.choice((1, 1, 1, 2, 3))
        values = self.arguments(of)
        if values is None and of.formals is not None:
            return
        manners = ("P=", "P", "P=+", "CALL") if values is None else ("P=", "PCALL")
        self.put(l.Call(of.name, values, times, self.random.choice(manners)))
        if of.save:
            self.everywhere()

    def arguments(self, of: l.Program) -> tuple[l.Expression | None, ...] | None:
        """Return the values of a call, or nothing where a variable is missing."""
        values: list[l.Expression | None] = []
        for place, formal in enumerate(of.formals or ()):
            if formal.name.startswith("DEPTH"):
                values.append(integer(self.random.randint(0, 3)))
            elif formal.by_reference:
                # Two VAR parameters of one variable are left out.
                free = [v for v in self.variables(formal.type) if v not in values]
                if not free:
                    return None
                values.append(self.random.choice(free))
            elif place and self.chance(0.4):
                values.append(None)
            else:
                values.append(self.truth() if formal.type == "BOOL" else self.value(1))
        while values and values[-1] is None:
            values.pop()
        return tuple(values) if of.formals is not None else None

    def variables(self, kind: str) -> list[l.Expression]:
        """Return what a VAR parameter of a type may get."""
        found: list[l.Expression] = [l.Variable(n) for n in self.known.numbers[kind]]
        if self.has("var elements"):
            for name, (type_, size) in self.known.arrays.items():
                if type_ == kind:
                    found.append(l.Element(name, tuple(integer(n - 1) for n in size)))
        return found

    # ---- structures ----

    def body(self, budget: int) -> None:
        for _ in range(budget):
            if len(self.open) >= 3 or self.chance(0.68):
                self.line()
            else:
                self.structure()

    def structure(self) -> None:
        kinds = ["if", "if"] + ["return"] * (self.has("RET to a block") and not self.plain)
        kinds += [k for k in ("while", "for", "loop", "repeat", "case", "again") if self.has(k)]
        if self.has("jumps"):
            kinds += ["forward", "back", "missing"]
        getattr(self, f"write_{self.random.choice(kinds)}")()

    def counter(self) -> l.Variable:
        name = self.name("COUNT")
        self.here.definitions.append(l.Definition("INT", name))
        return l.Variable(name)

    def within(self, opener: int, low: int = 1, high: int = 3) -> None:
        self.open.append(opener)
        self.body(self.random.randint(low, high))
        self.open.pop()

    def write_if(self) -> None:
        opener = self.put(l.Open("IF", self.truth()))
        self.within(opener, 0)
        if self.chance(0.5):
            other = self.put(l.Else())
            self.here.blocks[opener].mate = other
            self.within(other, 0)
            end = self.put(l.Close("IF"))
            self.here.blocks[other].mate = end
        else:
            self.here.blocks[opener].mate = self.put(l.Close("IF"))

    def looped(self, opener: int, end: l.Close) -> None:
        self.here.blocks[opener].mate = place = self.put(end)
        self.here.blocks[place].mate = opener

    def write_while(self) -> None:
        counter = self.counter()
        self.put(l.Assign(((counter, integer(0)),)))
        few = l.Binary("<", counter, integer(self.random.randint(0, 4)))
        opener = self.put(l.Open("WHILE", few))
        self.open.append(opener)
        self.step(counter)
        self.body(self.random.randint(1, 3))
        self.open.pop()
        self.looped(opener, l.Close("WHILE"))

    def step(self, counter: l.Variable) -> None:
        self.put(l.Assign(((counter, l.Binary("+", counter, integer(1))),)))

    def write_for(self) -> None:
        r = self.random
        counter = self.counter()
        first = r.randint(-2, 3)
        low = self.signed(first)
        last: l.Expression = integer(max(first + r.randint(-1, 3), 0))
        opener = self.put(l.Open("FOR", low, counter, last))
        if first >= 0:
            self.known.fixed.append(counter.name)
        self.within(opener)
        if first >= 0:
            self.known.fixed.remove(counter.name)
        self.looped(opener, l.Close("FOR"))

    def write_loop(self) -> None:
        counter, out = self.counter(), self.name("OUT")
        self.put(l.Assign(((counter, integer(0)),)))
        opener = self.put(l.Open("LOOP"))
        self.open.append(opener)
        self.step(counter)
        self.body(self.random.randint(0, 2))
        enough = l.Binary(">=", counter, integer(self.random.randint(1, 4)))
        self.put(l.Jump(((enough, "GOTOF", out),)))
        self.body(self.random.randint(0, 2))
        self.open.pop()
        self.looped(opener, l.Close("LOOP"))
        self.landing(out)

    def landing(self, label: str) -> None:
        self.put(l.Move("G0", (l.Word("X", self.length()),)), label)

    def write_repeat(self) -> None:
        counter = self.counter()
        self.put(l.Assign(((counter, integer(0)),)))
        opener = self.put(l.Open("REPEAT"))
        self.open.append(opener)
        self.step(counter)
        self.body(self.random.randint(1, 3))
        self.open.pop()
        enough: l.Expression = l.Binary(">=", counter, integer(self.random.randint(0, 4)))
        if self.chance(0.3):
            enough = l.Binary("OR", enough, self.truth(1))
        self.looped(opener, l.Close("REPEAT", enough))

    def write_case(self) -> None:
        r = self.random
        out = self.name("OUT")
        labels = [self.name("WAY") for _ in range(r.randint(1, 3))]
        constants = r.sample(range(6), len(labels))
        value = l.Binary(
            "MOD", l.Function("TRUNC", (l.Function("ABS", (self.value(1),)),)), integer(6)
        )
        default = ("GOTOF", out) if self.chance(0.6) else None
        branches = tuple(
            (n, r.choice(("GOTOF", "GOTO")), to) for n, to in zip(constants, labels, strict=True)
        )
        self.put(l.Case(value, branches, default))
        for label in labels:
            self.landing(label)
            self.body(r.randint(0, 2))
            self.put(l.Jump(((None, "GOTOF", out),)))
        self.landing(out)

    def write_forward(self) -> None:
        r = self.random
        label = self.name("AHEAD")
        word = r.choice(("GOTOF", "GOTO", "GOTOC"))
        ways: list[tuple[l.Expression | None, str, str]] = [(self.truth(), word, label)]
        second = ""
        if self.has("several jumps") and self.chance(0.3):
            second = self.name("AHEAD")
            ways.append((self.truth(), "GOTOF", second))
        self.put(l.Jump(tuple(ways)))
        self.body(r.randint(1, 3))
        if second:
            self.landing(second)
        self.landing(label)

    def write_back(self) -> None:
        counter, label = self.counter(), self.name("AGAIN")
        self.put(l.Assign(((counter, integer(0)),)))
        self.landing(label)
        self.step(counter)
        self.body(self.random.randint(0, 3))
        few = l.Binary("<", counter, integer(self.random.randint(1, 4)))
        self.put(l.Jump(((few, self.random.choice(("GOTOB", "GOTO")), label),)))

    def write_missing(self) -> None:
        """Write a jump to a label that no block has: GOTOC goes on, others alarm."""
        word = (
            "GOTOC" if self.careful or self.chance(0.8) else self.random.choice(("GOTOF", "GOTOB"))
        )
        self.put(l.Jump(((self.truth(), word, self.name("NOWHERE")),)))

    def write_again(self) -> None:
        r = self.random
        first, last = self.name("PART"), self.name("END")
        self.landing(first)
        for _ in range(r.randint(0, 2)):
            self.line()
        kind = r.choice(("to here", "to a label", "one block", "ENDLABEL", "CALL BLOCK"))
        to = last if kind in ("to a label", "CALL BLOCK") else None
        if to or kind == "ENDLABEL":
            self.landing(to or "ENDLABEL")
            self.line()
        if kind == "CALL BLOCK":
            self.put(l.Again(first, to, 1, block=True))
            return
        self.put(l.Again(first, to, r.randint(1, 3), kind == "one block", kind == "ENDLABEL"))

    def write_return(self) -> None:
        """Write a call of a program of its own that returns to a label after the call."""
        label, names = self.name("BACK"), [self.name("RSUB") for _ in range(1 + self.chance(0.4))]
        self.programs[names[0]] = first = l.Program(names[0])
        for name, inner in pairwise(names):
            self.programs[name].blocks.append(l.Block(l.Call(inner, None)))
            self.programs[inner] = l.Program(inner)
        last = self.programs[names[-1]]
        last.blocks.append(l.Block(l.Assign(((self.parameter(), self.number()),))))
        if self.chance(0.3):
            ways = ((l.Binary(">", self.parameter(), self.number()), "GOTOF", "DONE"),)
            last.blocks.append(l.Block(l.Jump(ways)))
        last.blocks.append(l.Block(l.Back(label, self.chance(0.4), len(names))))
        last.blocks.append(l.Block(l.Assign(((self.parameter(), self.number()),)), label="DONE"))
        for each in {id(of): of for of in (first, last)}.values():
            each.blocks.append(l.Block(l.Return("M17")))
        self.put(l.Call(names[0], None))
        for _ in range(self.random.randint(1, 2)):
            self.assignment()
        self.landing(label)
        self.assignment()
