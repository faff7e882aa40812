"""Compute what a SINUMERIK program does, from the rules of the manual and not from the engine.

Where the manual leaves a value open the program is `UnclearError` and not compared: `hair` makes the
result of each division and function larger by this share, `digits` rounds it, and a program that
then does something else depends on the last digits of a REAL.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace

import sinumerik_language as l
from sinumerik_arithmetic import (
    FUNCTIONS,
    AlarmError,
    Cell,
    Scope,
    UnclearError,
    Value,
    alike,
    constant,
    converted,
)
from sinumerik_frames import FrameValue, chained, made, part, with_part
from sinumerik_paths import LARGEST, Paths

MAX_BLOCKS = 3000
SMALLEST = 1e-9  # a result below it is a rounding error, or nothing


@dataclass
class Evaluator(Paths):
    """Runs programs."""

    programs: dict[str, l.Program] = field(default_factory=dict)
    skipped: frozenset[int] = frozenset()  # the levels of blocks that are skipped
    stored: dict[str, FrameValue] = field(default_factory=dict)  # of work systems, as written
    r: dict[int, float] = field(default_factory=dict)
    modal: tuple[l.Program, dict[str, Cell]] | None = None  # of MCALL
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
            to = self.block(of, at, scope)
            if to is None:
                return
            at = to

    def define(self, of: l.Definition, scope: Scope) -> None:
        if of.type == "FRAME":
            scope.frames[of.name] = FrameValue()
            return
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
        self.blocks += 1
        if self.blocks > MAX_BLOCKS:
            raise UnclearError
        block = program.blocks[at]
        if block.level in self.skipped:
            return at + 1
        match block.action:
            case l.Assign(targets):
                for target, value in [(t, self.value(v, scope)) for t, v in targets]:
                    self.assign(target, value, scope)
            case l.FrameAssign(to, value):
                self.put_frame(to, self.frame_value(value, scope), scope)
            case l.Move() | l.MachineMove() | l.Polar() | l.Arc():
                self.path(block.action, scope)
                if self.modal:
                    self.called(*self.modal)
            case l.Pole():
                self.set_pole(block.action, scope)
            case l.Code(code):
                self.code(code)
            case l.Frame():
                self.frame(block.action, scope)
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
                return self.call(program, at, block.action, scope)
            case l.Modal(name, values):
                self.modal = self.handed_over(name, values, scope) if name else None
            case l.Again():
                self.again(program, at, block.action, scope)
            case l.Back():
                raise _BackError(block.action)
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

    def handed_over(
        self, name: str, given: tuple[l.Expression | None, ...] | None, scope: Scope
    ) -> tuple[l.Program, dict[str, Cell]]:
        """Return a program and its parameters with the values of a call."""
        callee = self.programs[name]
        cells: dict[str, Cell] = {}
        values = [*(given or ()), *[None] * len(callee.formals or ())]
        for formal, value in zip(callee.formals or (), values, strict=False):
            if formal.by_reference and isinstance(value, l.Variable):
                cells[formal.name] = scope.cells[value.name]
                continue
            if formal.by_reference and isinstance(value, l.Element):
                cells[formal.name] = self.element(value, scope)
                continue
            value = formal.initial if value is None else value
            number = 0 if value is None else self.value(value, scope)
            cells[formal.name] = Cell(formal.type, converted(number, formal.type))
        return callee, cells

    def called(self, callee: l.Program, cells: dict[str, Cell]) -> None:
        """Run a program once. MCALL does not count in it where MCALL calls it."""
        before, modal = self.state, self.modal
        if modal and modal[0] is callee:
            self.modal = None
        try:
            self.program(callee, dict(cells))
        finally:
            self.modal = modal
            if callee.save:
                self.state = before

    def call(self, program: l.Program, at: int, of: l.Call, scope: Scope) -> int:
        """Call a program; return the block where the caller goes on.

        The values are handed over at the first pass only: a later one finds the parameters as the
        one before left them.
        """
        callee, cells = self.handed_over(of.name, of.values, scope)
        for _ in range(of.times):
            try:
                self.called(callee, cells)
            except _BackError as back:
                if back.of.levels > 1:
                    raise _BackError(replace(back.of, levels=back.of.levels - 1)) from None
                return self.target(program, at, "GOTO", back.of.target) + back.of.after
        return at + 1

    def again(self, program: l.Program, at: int, of: l.Again, scope: Scope) -> None:
        """Repeat a part: from its label to the other one, to this block, or one block alone."""
        places = [n for n in range(at, -1, -1) if program.blocks[n].label == of.first]
        if not places:
            raise AlarmError("jump-target-not-found")
        first = places[0]
        end = "ENDLABEL" if of.ended else of.last
        ends = [n for n in range(first, at) if program.blocks[n].label == end]
        last = first if of.only else ends[0] if end else at - 1
        for _ in range(of.times):
            place = first
            while first <= place <= last:
                to = self.block(program, place, scope)
                if to is None:
                    raise UnclearError
                place = to
            if place != last + 1:
                raise UnclearError  # a jump left the part

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
            case l.Part(frame, axis, name):
                place = self.axis(axis, scope)
                old = self.frame_value(frame, scope)
                self.put_frame(frame, with_part(old, place, name, float(value)), scope)

    def frame_value(self, of: l.FrameValue, scope: Scope) -> FrameValue:
        match of:
            case l.FrameName("$P_PFRAME"):
                return self.state.frame
            case l.FrameName(text) if text.startswith("$P_UIFR"):
                code = l.SYSTEMS[text]
                return self.stored.get(code, FrameValue(shift=self.zeros[code]))
            case l.FrameName(text):
                frame = scope.frames[text]
                assert isinstance(frame, FrameValue)
                return frame
            case l.FrameCall(name, words):
                values = {
                    self.axis(a, scope): 1.0 if v is None else self.length(v, scope)
                    for a, v in words
                }
                return made(name, values)
            case l.Chain(left, right):
                return chained(self.frame_value(left, scope), self.frame_value(right, scope))

    def put_frame(self, to: l.FrameName, frame: FrameValue, scope: Scope) -> None:
        if to.text == "$P_PFRAME":
            self.state = replace(self.state, frame=frame)
        elif to.text.startswith("$P_UIFR"):
            # It takes effect with the next code of its work system.
            code, held = l.SYSTEMS[to.text], self.state.held
            if held is None:
                self.state = replace(self.state, held=self.zeros[self.state.zero])
            self.stored[code] = frame
            self.zeros[code] = frame.whole
        else:
            scope.frames[to.text] = frame

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
                return constant(text)
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
            case l.AxisName(axis):
                return axis
            case l.Part(frame, axis, name):
                return self.other(
                    part(self.frame_value(frame, scope), self.axis(axis, scope), name)
                )
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
        if abs(value) < SMALLEST and self.hair < 0:
            return -value  # its sign depends on the last digits
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


class _BackError(Exception):
    """RET with values returns over some levels."""

    def __init__(self, of: l.Back) -> None:
        self.of = of
