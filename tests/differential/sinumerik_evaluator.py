"""Compute what a SINUMERIK program does, from the rules of the manual and not from the engine.

Where the manual leaves a value open the program is `UnclearError` and not compared: `hair` makes the
result of each division and function larger by this share, `digits` rounds it, and a program that
then does something else depends on the last digits of a REAL.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import sinumerik_language as l
from sinumerik_arithmetic import (
    FUNCTIONS,
    IDENTITY,
    AlarmError,
    Cell,
    Matrix,
    UnclearError,
    Value,
    alike,
    converted,
    diagonal,
    product,
    turned,
)

AXES = "XYZ"
LARGEST = 1e6
MAX_BLOCKS = 3000


@dataclass
class Scope:
    """The variables of one program that runs."""

    cells: dict[str, Cell] = field(default_factory=dict)
    arrays: dict[str, tuple[tuple[int, ...], list[Cell]]] = field(default_factory=dict)


@dataclass
class Evaluator:
    """Runs programs. `offset` is the work offset that is in force."""

    programs: dict[str, l.Program]
    offset: tuple[float, float, float] = (0.0, 0.0, 0.0)
    r: dict[int, float] = field(default_factory=dict)
    moves: list[tuple[str, float, float, float]] = field(default_factory=list)
    local: list[float] = field(default_factory=lambda: [0.0, 0.0, 0.0])
    turn: Matrix = IDENTITY
    shift: tuple[float, float, float] = (0.0, 0.0, 0.0)
    rapid: bool = False
    absolute: bool = True
    hair: float = 0.0
    digits: int = 0
    blocks: int = 0

    def run(self, main: str) -> str:
        """Run the main program; return the cause of its alarm, or nothing."""
        try:
            self.program(self.programs[main], {})
        except AlarmError as alarm:
            return str(alarm)
        except _EndError:
            pass
        return ""

    # ---- programs ----

    def program(self, of: l.Program, parameters: dict[str, Cell]) -> None:
        scope = Scope(parameters)
        for definition in of.definitions:
            self.define(definition, scope)
        at = 0
        while at < len(of.blocks):
            self.blocks += 1
            if self.blocks > MAX_BLOCKS:
                raise UnclearError
            to = self.block(of, at, scope)
            if to is None:
                return
            at = to

    def define(self, of: l.Definition, scope: Scope) -> None:
        if not of.size:
            value = self.value(of.initial, scope) if of.initial is not None else 0
            scope.cells[of.name] = Cell(of.type, converted(value, of.type))
            return
        count = math.prod(of.size)
        cells = [Cell(of.type, converted(0, of.type)) for _ in range(count)]
        if of.all is not None:
            for cell in cells:
                cell.value = converted(self.value(of.all, scope), of.type)
        for cell, each in zip(cells, of.fill, strict=False):
            if each is not None:
                cell.value = converted(self.value(each, scope), of.type)
        scope.arrays[of.name] = (of.size, cells)

    def block(self, program: l.Program, at: int, scope: Scope) -> int | None:
        """Run a block; return the next one, or None at the end of the program."""
        block = program.blocks[at]
        match block.action:
            case l.Assign(targets):
                for target, value in [(t, self.value(v, scope)) for t, v in targets]:
                    self.assign(target, value, scope)
            case l.Move():
                self.move(block.action, scope)
            case l.Open() | l.Else() | l.Close():
                return self.structure(program, at, scope)
            case l.Jump(ways):
                for condition, word, to in ways:
                    if condition is None or self.truth(condition, scope):
                        return self.target(program, at, word, to)
            case l.Case(value, branches, default):
                chosen = self.value(value, scope)
                for constant, word, to in branches:
                    if alike(chosen, constant):
                        return self.target(program, at, word, to)
                if default:
                    return self.target(program, at, *default)
            case l.Call():
                self.call(block.action, scope)
            case l.Again():
                self.again(program, at, block.action, scope)
            case l.Frame():
                self.frame(block.action, scope)
            case l.Return(word):
                if word == "M30":
                    raise _EndError
                return None
        return at + 1

    def structure(self, program: l.Program, at: int, scope: Scope) -> int:
        block = program.blocks[at]
        match block.action:
            case l.Open("IF" | "WHILE", condition):
                assert condition is not None
                return at + 1 if self.truth(condition, scope) else block.mate + 1
            case l.Open("FOR", first, counter):
                assert first is not None
                assert counter is not None
                scope.cells[counter.name].value = converted(self.value(first, scope), "INT")
                return self.count(program, at, scope)
            case l.Else():
                return block.mate + 1
            case l.Close("FOR"):
                opened = program.blocks[block.mate].action
                assert isinstance(opened, l.Open)
                assert opened.counter is not None
                scope.cells[opened.counter.name].value += 1
                return self.count(program, block.mate, scope)
            case l.Close("WHILE"):
                return self.structure(program, block.mate, scope)
            case l.Close("LOOP"):
                return block.mate + 1
            case l.Close("REPEAT", until):
                assert until is not None
                return at + 1 if self.truth(until, scope) else block.mate + 1
        return at + 1

    def count(self, program: l.Program, at: int, scope: Scope) -> int:
        block = program.blocks[at]
        opened = block.action
        assert isinstance(opened, l.Open)
        assert opened.counter is not None
        assert opened.last is not None
        done = scope.cells[opened.counter.name].value > self.value(opened.last, scope)
        return block.mate + 1 if done else at + 1

    def target(self, program: l.Program, at: int, word: str, to: str) -> int:
        """Return the block of a jump: the nearest one in the direction of the search."""
        count = len(program.blocks)
        after, before = range(at + 1, count), range(at, -1, -1)
        search = {"GOTOF": [after], "GOTOB": [before]}.get(word, [after, before])
        for blocks in search:
            for place in blocks:
                block = program.blocks[place]
                if to == block.label or to == f"N{block.number}":
                    if not set(block.inside) <= set(program.blocks[at].inside):
                        raise UnclearError
                    return place
        if word == "GOTOC":
            return at + 1
        raise AlarmError("jump-target-not-found")

    def call(self, of: l.Call, scope: Scope) -> None:
        """Call a program. Its values are handed over at the first pass only: a later one finds the
        parameters as the one before left them.
        """
        callee = self.programs[of.name]
        cells: dict[str, Cell] = {}
        given = [*(of.values or ()), *[None] * len(callee.formals or ())]
        for formal, value in zip(callee.formals or (), given, strict=False):
            if formal.by_reference and isinstance(value, l.Variable):
                cells[formal.name] = scope.cells[value.name]
                continue
            if formal.by_reference and isinstance(value, l.Element):
                cells[formal.name] = self.element(value, scope)
                continue
            value = formal.initial if value is None else value
            number = 0 if value is None else self.value(value, scope)
            cells[formal.name] = Cell(formal.type, converted(number, formal.type))
        for _ in range(of.times):
            before = self.rapid, self.absolute, self.turn, self.shift
            self.program(callee, dict(cells))
            if callee.save:
                self.rapid, self.absolute, self.turn, self.shift = before

    def again(self, program: l.Program, at: int, of: l.Again, scope: Scope) -> None:
        """Repeat a part: from its label to the other one, to this block, or one block alone."""
        places = [n for n in range(at, -1, -1) if program.blocks[n].label == of.first]
        if not places:
            raise AlarmError("jump-target-not-found")
        first = places[0]
        ends = [n for n in range(first, at) if program.blocks[n].label == of.last]
        last = first if of.only else ends[0] if of.last else at - 1
        for _ in range(of.times):
            place = first
            while first <= place <= last:
                self.blocks += 1
                if self.blocks > MAX_BLOCKS:
                    raise UnclearError
                to = self.block(program, place, scope)
                if to is None:
                    raise UnclearError
                place = to
            if place != last + 1:
                raise UnclearError  # a jump left the part

    # ---- moves ----

    def move(self, of: l.Move, scope: Scope) -> None:
        codes = of.code.split()
        self.absolute = "G90" in codes or (self.absolute and "G91" not in codes)
        self.rapid = "G0" in codes or (self.rapid and "G1" not in codes)
        to = list(self.local)
        for word in of.words:
            value = float(self.value(word.value, scope))
            axis = AXES.index(word.axis)
            add = word.manner == "IC" or (word.manner == "" and not self.absolute)
            to[axis] = self.local[axis] + value if add else value
            if abs(to[axis]) > LARGEST:
                raise UnclearError
        self.local = to
        if of.words:
            place = self.machine()
            if max(map(abs, place)) > LARGEST:
                raise UnclearError
            self.moves.append(("rapid" if self.rapid else "feed", *place))

    def machine(self) -> tuple[float, float, float]:
        """Return the position in machine coordinates."""
        return tuple(  # type: ignore[return-value]
            sum(self.turn[i][j] * self.local[j] for j in range(3)) + self.shift[i] + self.offset[i]
            for i in range(3)
        )

    def frame(self, of: l.Frame, scope: Scope) -> None:
        """Change the programmable frame: words beginning with A are added to it, others replace."""
        given = {a: self.value(v, scope) if v is not None else 0 for a, v in of.words}
        if not of.op.startswith("A"):
            self.turn, self.shift = IDENTITY, (0.0, 0.0, 0.0)
        by: Matrix = IDENTITY
        match of.op.removeprefix("A"):
            case "TRANS":
                move = [float(given.get(axis, 0)) for axis in AXES]
                self.shift = tuple(  # type: ignore[assignment]
                    self.shift[i] + sum(self.turn[i][j] * move[j] for j in range(3))
                    for i in range(3)
                )
            case "ROT":
                # Angles of one block turn about Z, then about the new Y, then about the new X.
                turns = {**given, "Z": given["RPL"]} if "RPL" in given else given
                for axis in "ZYX":
                    by = product(by, turned(axis, float(turns.get(axis, 0))))
            case "SCALE":
                factors = [float(given.get(axis, 1)) for axis in AXES]
                by = diagonal(factors)
            case "MIRROR":
                by = diagonal([-1.0 if axis in given else 1.0 for axis in AXES])
        self.turn = product(self.turn, by)

    # ---- values ----

    def assign(self, to: l.Target, value: Value, scope: Scope) -> None:
        match to:
            case l.Parameter(number):
                self.r[self.number(number, scope)] = float(value)
            case l.Variable(name):
                cell = scope.cells[name]
                cell.value = converted(value, cell.type)
            case l.Element():
                cell = self.element(to, scope)
                cell.value = converted(value, cell.type)

    def number(self, of: int | l.Expression, scope: Scope) -> int:
        return of if isinstance(of, int) else int(converted(self.value(of, scope), "INT"))

    def element(self, of: l.Element, scope: Scope) -> Cell:
        size, cells = scope.arrays[of.name]
        at = 0
        for index, count in zip(of.indices, size, strict=True):
            place = self.number(index, scope)
            if not 0 <= place < count:
                raise UnclearError
            at = at * count + place
        return cells[at]

    def truth(self, of: l.Expression, scope: Scope) -> bool:
        return bool(self.value(of, scope))

    def value(self, of: l.Expression, scope: Scope) -> Value:
        match of:
            case l.Number(text):
                return float(text) if "." in text else int(text)
            case l.Text(inside):
                return inside
            case l.Truth(value):
                return value
            case l.Variable(name):
                return scope.cells[name].value
            case l.Parameter(number):
                return self.r.get(self.number(number, scope), 0.0)
            case l.Element():
                return self.element(of, scope).value
            case l.Unary(op, value):
                inner = self.value(value, scope)
                if op == "NOT":
                    return not inner
                return ~int(inner) if op == "B_NOT" else -inner
            case l.Binary(op, left, right):
                return self.combined(op, self.value(left, scope), self.value(right, scope))
            case l.Function(name, values):
                result = FUNCTIONS[name](*(self.value(v, scope) for v in values))
                return self.other(result) if isinstance(result, float) else result

    def combined(self, op: str, a: Value, b: Value) -> Value:
        if op == "<<":
            if len(joined := f"{a}{b}") > l.LENGTH:
                raise UnclearError
            return joined
        if op in ("AND", "OR", "XOR"):
            one, other = bool(a), bool(b)
            return (
                (one and other) if op == "AND" else (one or other) if op == "OR" else one != other
            )
        if op in ("B_AND", "B_OR", "B_XOR"):
            one, other = int(a), int(b)
            return one & other if op == "B_AND" else one | other if op == "B_OR" else one ^ other
        if op in ("==", "<>", "<", ">", "<=", ">="):
            same = alike(a, b)
            return {"==": same, "<>": not same, "<": a < b and not same, ">": a > b and not same,
                    "<=": a < b or same, ">=": a > b or same}[op]  # fmt: skip
        result = self.computed(op, a, b)
        if abs(result) > LARGEST:
            raise UnclearError
        return result

    def other(self, value: float) -> float:
        """Return the result of a division or a function with other last digits, if these are asked."""
        if self.digits:
            value = float(f"{value:.{self.digits}g}")
        return value * (1 + self.hair)

    def computed(self, op: str, a: Value, b: Value) -> Value:
        if op in ("/", "DIV", "MOD") and b == 0:
            raise AlarmError("division-by-zero")
        match op:
            case "+":
                return a + b
            case "-":
                return a - b
            case "*":
                return a * b
            case "/":
                return self.other(a / b)
        whole = isinstance(a, int) and isinstance(b, int)
        times = math.trunc(a / b if whole else self.other(a / b))
        if op == "MOD":
            return a - b * times
        return times if whole else float(times)


class _EndError(Exception):
    """M30 ended the run."""
