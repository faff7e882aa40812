"""Generate SINUMERIK programs with their subprograms: heads, definitions, parameters."""

from __future__ import annotations

import math

import sinumerik_language as l
from sinumerik_blocks import BlockWriter
from sinumerik_values import Known, integer


class Writer(BlockWriter):
    """Writes the programs of one run."""

    def define(self) -> None:
        """Write the DEFs of a program."""
        r = self.random
        types = ["INT", "REAL"] + ["BOOL"] * self.has("booleans") + ["STRING"] * self.has("texts")
        types += ["CHAR"] * self.has("characters") + ["AXIS"] * self.has("axes")
        types += ["FRAME"] * (self.has("frame values") and self.has("frames"))
        for _ in range(r.randint(1, 4)):
            kind = r.choice(types)
            name = self.name(r.choice(("LEN", "_deep", "Wide", "HIGH")))
            initial = None
            if self.chance(0.7):
                initial = l.Truth(self.chance(0.5)) if kind == "BOOL" else self.number()
            if kind == "STRING":
                initial = l.Text("first") if self.chance(0.7) else None
            if kind == "CHAR" and initial is not None:
                initial = integer(r.randint(0, 255))
            if kind == "AXIS":
                initial = l.AxisName(r.choice("XYZ"))
            if kind == "FRAME":
                initial = None
            self.here.definitions.append(l.Definition(kind, name, initial))
            self.known.numbers[kind].append(name)
        if self.has("arrays") and self.chance(0.6):
            self.array(r.choice(("INT", "REAL")))

    def array(self, kind: str) -> None:
        r = self.random
        name = self.name("FIELD")
        size = tuple(r.randint(1, 4) for _ in range(r.choice((1, 1, 2, 3))))
        fill: tuple[l.Expression | None, ...] = ()
        all_: l.Expression | None = None
        if self.chance(0.4):
            fill = tuple(
                self.number() if self.chance(0.8) else None for _ in range(r.randint(1, 3))
            )
            fill = (self.number(), *fill[: max(0, math.prod(size) - 1)])
        elif self.chance(0.4):
            all_ = self.number()
        self.here.definitions.append(l.Definition(kind, name, None, size, fill, all_))
        self.known.arrays[name] = (kind, size)

    def formals(self) -> tuple[l.Formal, ...]:
        r = self.random
        made = []
        for _ in range(r.randint(1, 4)):
            kind = r.choice(["INT", "REAL", "REAL"] + ["BOOL"] * self.has("booleans"))
            by_reference = (
                self.has("var") and not self.plain and kind != "BOOL" and self.chance(0.3)
            )
            initial = None
            if self.has("defaults") and not by_reference and self.chance(0.5):
                initial = l.Truth(True) if kind == "BOOL" else self.number()
            name = self.name("GIVEN")
            made.append(l.Formal(kind, name, by_reference, initial))
            self.known.numbers[kind].append(name)
        return tuple(made)

    def subprogram(self, name: str, callable_: list[str]) -> None:
        self.here, self.known = l.Program(name), Known()
        self.open, self.callable = [], callable_
        deep = ""
        if self.chance(0.75):
            self.here.formals = self.formals()
            self.here.save = self.has("save") and not self.plain and self.chance(0.3)
            if self.chance(0.2) and not self.plain:
                deep = self.name("DEPTH")
                self.here.formals = (l.Formal("INT", deep), *self.here.formals)
        self.define()
        if self.plain:
            for _ in range(self.random.randint(1, 3)):
                self.line()
        else:
            self.body(self.random.randint(1, 5))
        if deep:
            self.recursion(deep)
        self.put(l.Return(self.random.choice(("M17", "RET"))))
        self.programs[name] = self.here

    def recursion(self, deep: str) -> None:
        """Write a call of the program by itself, with a counter that falls."""
        formals = self.here.formals or ()
        values: list[l.Expression | None] = [l.Binary("-", l.Variable(deep), integer(1))]
        for formal in formals[1:]:
            constant = l.Truth(False) if formal.type == "BOOL" else self.number()
            values.append(l.Variable(formal.name) if formal.by_reference else constant)
        opener = self.put(l.Open("IF", l.Binary(">", l.Variable(deep), integer(0))))
        self.open.append(opener)
        self.put(l.Call(self.here.name, tuple(values)))
        self.open.pop()
        self.here.blocks[opener].mate = self.put(l.Close("IF"))

    def write(self) -> dict[str, l.Program]:
        r = self.random
        count = r.randint(0, 3)
        names = [r.choice((f"SUB_{a}", f"L{n}")) for a, n in zip("ABC"[:count], (7, 12, 903))]
        if self.has("modal calls") and self.chance(0.4):
            self.plain = True
            self.subprogram("MODAL_A", [])
            self.plain = False
            self.modal = ["MODAL_A"]
        for place in reversed(range(len(names))):
            self.subprogram(names[place], names[place + 1 :])
        self.here, self.known = l.Program("MAIN"), Known()
        self.open, self.callable = [], names
        self.define()
        start = tuple(l.Word(axis, integer(0)) for axis in "XYZ")
        self.put(l.Move("G90 G0", start))
        self.body(self.random.randint(3, 9))
        self.put(l.Return("M30"))
        self.programs["MAIN"] = self.here
        return self.programs
