"""The state of a run before a block."""

from __future__ import annotations

import functools
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from cncsub import _core
from cncsub._core import Control, Frame, variable_name
from cncsub.controls import rule_value
from cncsub.program import Block

if TYPE_CHECKING:
    from cncsub.machine import Machine

_COOLANTS = {7, 8}  # and off by 9; 19 stops the spindle at an angle [ISO 6983-1, the M functions]
_COOLANT_OFF = 9
COOLANT_CODES = frozenset({*_COOLANTS, _COOLANT_OFF})
_ORIENTED = 19


@dataclass(frozen=True)
class RestartState:
    """The state of a run before the block that it starts again with.

    `block`: that block. `step`: how many blocks were executed before it. `moves`: how many moves
    they made. `stack`: the open calls with their passes, innermost first. `modal`: the modal codes
    by group, and F, S, T, H and D. `position`: work coordinates by axis, mm. `work`: the work
    offset. `tool`: the tool in the spindle, by its T code, `None` before the first. `spindle`,
    `coolant`: the M codes in force, such as `"M3"` and `("M8",)`; `None` and `()` where none was
    sent. `variables`: those with a value, by number, and by name where they have one; `#1` and so
    on are those of the innermost level.
    """

    block: Block
    step: int
    moves: int
    stack: tuple[Frame, ...]
    modal: Mapping[str, str]
    position: Mapping[str, float]
    work: str | None
    tool: int | None
    spindle: str | None
    coolant: tuple[str, ...]
    variables: Mapping[int | str, Any]

    def __str__(self) -> str:
        n = "" if self.block.n is None else f" N{self.block.n}"
        modes = (f"{code}" for name, code in self.modal.items() if len(name) > 1)
        words = (f"{name}{self.modal[name]}" for name in "FSTHD" if name in self.modal)
        lines = [
            ("block", f"{self.block.program.name}{n}, line {self.block.line}: {self.block.text}"),
            *(("called", _call(frame)) for frame in self.stack),
            ("modes", " ".join(modes)),
            ("words", " ".join(words)),
            ("tool", "none" if self.tool is None else f"T{self.tool}"),
            ("spindle", f"{self.spindle or 'off'} S{self.modal.get('S', '0')}"),
            ("coolant", " ".join(self.coolant) or "off"),
            ("position", " ".join(f"{axis}{value:g}" for axis, value in self.position.items())),
            ("variables", _variables(self.variables, self.block.program.data.code.control)),
        ]
        return "\n".join(f"{name:<10}{text}" for name, text in lines if text)


def _call(frame: Frame) -> str:
    n = "" if frame.n is None else f" N{frame.n}"
    passes = f", pass {frame.repeat} of {frame.repeats}" if frame.repeats != 1 else ""
    return f"{frame.called} from {frame.program}{n} ({frame.kind}{passes})"


def _variables(values: Mapping[int | str, Any], control: Control) -> str:
    shown = [
        f"{variable_name(control, of) if isinstance(of, int) else of}={_shown(value)}"
        for of, value in values.items()
    ]
    return " ".join(shown[:40]) + (f" ... {len(shown)} in all" if len(shown) > 40 else "")


def _shown(value: Any) -> str:
    return f"{value:g}" if isinstance(value, int | float) else str(value)


def state_of(machine: Machine, block: Block) -> RestartState:
    """Return the state of a machine that stands before a block."""
    tool, spindle, coolant = _switched(machine)
    named: dict[int | str, Any] = {**machine.variables}
    named.update(machine.variables.named)
    modal = dict(machine.modal)
    return RestartState(
        block,
        machine.blocks,
        len(machine.moves),
        machine.stack,
        modal,
        dict(machine.position),
        modal.get("work"),
        tool,
        spindle,
        coolant,
        named,
    )


def _switched(machine: Machine) -> tuple[int | None, str | None, tuple[str, ...]]:
    """Return the tool, the code of the spindle and those of the coolant, as codes were sent."""
    roles = roles_of(machine)
    turns = {
        code for role in ("spindle-forward", "spindle-backward") for code in roles.get(role, ())
    }
    stops = set(roles.get("spindle-stop", ()))
    changes = set(roles.get("tool-change", ()))
    chosen = tool = spindle = None
    coolant: list[str] = []
    for code in machine.codes:
        value = int(code.value)
        if code.kind == "T":
            chosen = value
            tool = tool if _changes_later(machine, changes) else value
        elif code.kind == "M" and value in changes:
            tool = chosen
        elif code.kind == "M" and value in turns:
            spindle = f"M{value}"
        elif code.kind == "M" and (value in stops or value == _ORIENTED):
            spindle = None
        elif code.kind == "M" and value in _COOLANTS:
            coolant = [*(each for each in coolant if each != f"M{value}"), f"M{value}"]
        elif code.kind == "M" and value == _COOLANT_OFF:
            coolant = []
    return tool, spindle, tuple(coolant)


def _changes_later(machine: Machine, changes: set[int]) -> bool:
    """Return whether the program changes tools by a code beside T."""
    return any(code in changes for code in machine.m_codes)


def roles_of(machine: Machine) -> dict[str, tuple[int, ...]]:
    """Return the M codes of the control by what they do."""
    return _roles(machine.core.code.control)


@functools.cache
def _roles(control: Control) -> dict[str, tuple[int, ...]]:
    text = str(rule_value(control, "roles") or "")
    found: dict[str, tuple[int, ...]] = {}
    for entry in text.split():
        code, _, role = entry.partition("=")
        if code[:1] == "M" and code[1:].isdigit():
            found[role] = (*found.get(role, ()), int(code[1:]))
    return found


@functools.cache
def group_of(control: Any, code: str, machine: str) -> str:
    """Return the group of a G code on a kind of machine; empty where it has none."""
    facts = _core.code_facts(control, code, machine)
    return str(facts["group"]) if facts is not None else ""
