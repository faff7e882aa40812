"""What a machine holds at a pause, in groups with names: the values, as the control shows them."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any, NamedTuple

from cncsub import _core
from cncsub._core import Control
from cncsub.debugging.frames import StackFrame, level_opener
from cncsub.machine import Machine
from cncsub.number_text import length_text, number_text
from cncsub.reports.code_facts import code_explanations

# A value before it is shown, by the name of its group, the call whose it is, and its own name.
Facts = dict[tuple[str, int, str], Any]

_WORDS = {"F": "feed", "S": "spindle speed", "T": "tool", "H": "length offset number",
          "D": "radius offset number"}  # fmt: skip
MODAL_SCOPES = ("modes", "offsets in force", "tool, spindle and feed")  # scopes of modes
_SIGNALS = "system: signals"
SWITCHES = ("block_skip", "optional_stop")  # as a machine calls them
_IN_FORCE = ("work", "length", "radius", "rotation", "scaling", "mirror", "H", "D")
_MOST_BLOCKS = 20_000  # of the programs in which system variables are looked for


@dataclass(frozen=True, slots=True)
class Value:
    """A value that a machine holds. `name`: what stands before it; `expression`: what `evaluate`
    and `set` call it. `text`: the value as the control shows it. `changed`: whether it is another
    one than at the last pause. `parts`: the elements of an array.
    """

    name: str
    expression: str
    text: str
    changed: bool = False
    can_set: bool = False
    parts: tuple[Value, ...] = ()


@dataclass(frozen=True, slots=True)
class Scope:
    """Values of one kind: `name` is the heading above them."""

    name: str
    values: tuple[Value, ...]


def value_text(value: Any) -> str:
    """Return a value as it is shown: a number, a text in quotes, an array in brackets.

    >>> value_text(2.5), value_text(None), value_text("HOLE"), value_text([1, None])
    ('2.5', 'vacant', '"HOLE"', '[1, vacant]')
    """
    if value is None or isinstance(value, int | float):
        return number_text(value)
    if isinstance(value, str):
        return f'"{value}"'
    return f"[{', '.join(map(value_text, value))}]"


def switch_text(machine: Machine, name: str) -> str:
    """Return how a switch of the panel stands: the numbers of those that are on, or on and off."""
    if name == "block_skip":
        return " ".join(map(str, machine.block_skip)) or "off"
    return "on" if machine.optional_stop else "off"


class StateFacts:
    """The facts of a machine, which stands at its head when this is made, as they are now; what
    they were at the last pause is kept to compare.
    """

    def __init__(self, machine: Machine) -> None:
        self._machine = machine
        self._system: tuple[tuple[int, str], ...] | None = None
        self._before: Facts | None = None
        first = machine.next
        self._main = -1 if first is None else first.program.index
        self._named: dict[int, _Named] = {}  # what programs name, by their places

    def remember(self, frames: list[StackFrame]) -> None:
        """Compare with the present state from now on."""
        self._before = dict(self._facts(frames, frames))

    def scopes(self, frames: list[StackFrame], frame: StackFrame) -> list[Scope]:
        """Return what a program that runs sees, in groups; groups without values are left out."""
        groups: dict[str, list[Value]] = {}
        before = self._before
        for key, value in self._facts([frame], frames):
            group, call, name = key
            changed = before is not None and self._was_open(call, frames) and (
                key not in before or before[key] != value
            )  # fmt: skip
            shown = self._shown(group, name, value, changed)
            groups.setdefault(group, []).append(shown)
        return [Scope(name, tuple(values)) for name, values in groups.items()]

    def _was_open(self, call: int, frames: list[StackFrame]) -> bool:
        assert self._before is not None
        return call < 0 or any(each[1] == call for each in self._before)

    # ---- the facts ----

    def _facts(
        self, shown: list[StackFrame], frames: list[StackFrame]
    ) -> Iterator[tuple[tuple[str, int, str], Any]]:
        """Yield what some of the programs that run see."""
        for frame in shown:
            opener = level_opener(frame, frames)
            yield from self._numbered(frame, opener)
            for name, value in self._machine.core.named_variables(frame.level).items():
                yield ("named variables", opener, name), value
            if frame.index == 0:
                yield from self._by_name(frame, opener)
        yield from self._of_control()
        modal = self._machine.modal
        position = self._machine.position
        for axis, value in position.items():
            yield ("position", -1, axis), value
        for axis, value in self._machine.machine_position.items():
            yield ("position", -1, f"{axis} (machine)"), value
        yield from ((("modes", -1, n), code) for n, code in modal.items() if n not in _WORDS)
        yield from ((("offsets in force", -1, n), modal[n]) for n in _IN_FORCE if n in modal)
        yield from ((("tool, spindle and feed", -1, n), modal[n]) for n in _WORDS if n in modal)
        for name in SWITCHES:
            yield ("switches", -1, name), switch_text(self._machine, name)

    def _numbered(
        self, frame: StackFrame, opener: int
    ) -> Iterator[tuple[tuple[str, int, str], Any]]:
        """Yield the locals of the level of a program, those that it was given or names first, and
        the commons.
        """
        core = self._machine.core
        found: Mapping[int, float | None] = core.variables(frame.level)
        named = dict.fromkeys(self._named_by(frame).numbers)
        for number, value in sorted({**named, **found}.items()):
            group = _group(core.code, number)
            name = f"{core.code.variable_sign}{number}"
            if group == "locals":
                yield (f"locals of level {frame.level}", opener, name), value
            elif group == "commons" and number in found:
                yield ("commons", -1, name), value

    def _by_name(
        self, frame: StackFrame, opener: int
    ) -> Iterator[tuple[tuple[str, int, str], Any]]:
        """Yield the variables that the innermost program writes by a name and does not define."""
        known = self._machine.core.named_variables(frame.level)
        for name, text in self._named_by(frame).written.items():
            if name.upper() not in known:
                with contextlib.suppress(ValueError):  # it was not written yet
                    yield ("named variables", opener, text), self._machine.evaluate(text)

    def _named_by(self, frame: StackFrame) -> _Named:
        """Return the variables that a program names."""
        if frame.block is None:
            return _Named([], {})
        # A program inside the main one may stand where the main program passes by.
        place = self._main if frame.call < 0 <= self._main else frame.block.program.index
        if place not in self._named:
            self._named[place] = _named(self._machine.core.code, place)
        return self._named[place]

    def _of_control(self) -> Iterator[tuple[tuple[str, int, str], Any]]:
        """Yield the variables of the control itself that a program of the library names."""
        if self._system is None:
            self._system = tuple(_system_variables(self._machine.core))
        variables, sign = self._machine.variables, self._machine.core.code.variable_sign
        signals = dict(self._machine.signals)
        for number, group in self._system:
            if number in signals:
                yield (_SIGNALS, -1, f"{sign}{number}"), signals.pop(number)
                continue
            try:
                yield (f"system: {group}", -1, f"{sign}{number}"), variables[number]
            except KeyError:
                continue  # it has no value in this state
        for number, signal in signals.items():
            yield (_SIGNALS, -1, f"{sign}{number}"), signal

    # ---- how they are shown ----

    def _shown(self, group: str, name: str, value: Any, changed: bool) -> Value:
        """Return a value as it is shown."""
        core = self._machine.core
        if group == "position":
            return Value(name, name, length_text(value), changed, can_set=True)
        if group == "switches":
            return Value(name, name, value, changed, can_set=True)
        if group in MODAL_SCOPES:
            title = f"{name} ({_WORDS[name]})" if name in _WORDS else name
            return Value(title, name, str(value), changed, can_set=True)
        if group == "named variables":
            return _with_parts(name, value, changed, True)
        number = int(name.removeprefix(core.code.variable_sign))
        letter = argument_letters(core.code.control).get(number) if "locals" in group else None
        facts = core.code.variable_facts(number)
        can_set = group == _SIGNALS or (facts is not None and facts[2])
        title = f"{name} ({letter})" if letter else name
        return Value(title, name, value_text(value), changed, can_set)


def _with_parts(name: str, value: Any, changed: bool, can_set: bool) -> Value:
    """Return a variable with its elements; an array is set as a whole."""
    elements = enumerate(value) if isinstance(value, list) else ()
    parts = tuple(_with_parts(f"{name}[{i}]", part, changed, False) for i, part in elements)
    return Value(name, name, value_text(value), changed, can_set, parts)


@cache
def argument_letters(control: Control) -> dict[int, str]:
    """Return the letters under which a macro call gives the locals, by number."""
    for fact in code_explanations("G65", [control]):
        for on in fact["on"]:
            return {int(local[1:]): letter for letter, local in on["arguments"].items()}
    return {}


def _group(code: _core.Code, number: int) -> str:
    facts = code.variable_facts(number)
    return "" if facts is None else facts[0]


class _Named(NamedTuple):
    """The variables that a program names: their numbers, in order, and those that it writes by a
    name, as they are written.
    """

    numbers: list[int]
    written: dict[str, str]


def _named(code: _core.Code, program: int) -> _Named:
    data = code.program(program)
    numbers: set[int] = set()
    written: dict[str, str] = {}
    for block in range(min(data.blocks, _MOST_BLOCKS)):
        *_, reads, writes = _core.references(data, block)
        numbers.update(row[0] for row in (*reads, *writes) if row[0] is not None and not row[2])
        written.update((row[1], row[3]) for row in writes if row[1] is not None and not row[2])
    return _Named(sorted(numbers), written)


def _system_variables(core: _core.Machine) -> Iterator[tuple[int, str]]:
    """Yield the variables of the control that the programs name, with their groups; those that no
    program can name by a number are left out.
    """
    code = core.code
    found: set[int] = set()
    left = _MOST_BLOCKS
    for program in range(len(code)):
        if (left := left - code.program(program).blocks) < 0:
            break
        found.update(_named(code, program).numbers)
    numbers = sorted(found)
    _, faults = core.expressions([(f"{code.variable_sign}{number}", 0) for number in numbers])
    for number, fault in zip(numbers, faults, strict=True):
        facts = None if fault is not None else code.variable_facts(number)
        if facts is not None and facts[1] and facts[0] not in ("locals", "commons"):
            yield number, facts[0]
