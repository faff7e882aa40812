"""The values of a machine by what people type: read, and set."""

from __future__ import annotations

import re
from typing import Any

from cncsub import _core
from cncsub.debugging.frames import StackFrame
from cncsub.debugging.scopes import SWITCHES, switch_text, value_text
from cncsub.machine import Machine
from cncsub.number_text import length_text
from cncsub.variables import MachineVariables, Position

_ON, _OFF = ("on", "yes", "true"), ("off", "no", "false")
_VACANT = ("vacant", "#0", "")
_ELEMENT = re.compile(r"([A-Za-z_]\w*)\[([^\[\]]+)\]")  # of an array


def number_of(machine: Machine, name: str) -> int | None:
    """Return the number of a variable that is written by it, such as `#100`; `None` for others."""
    sign = machine.core.code.variable_sign
    rest = name.strip().upper().removeprefix(sign)
    if rest == name.strip().upper() or not (rest.isascii() and rest.isdecimal()) or len(rest) > 9:
        return None
    return int(rest)


def evaluate(machine: Machine, text: str, frame: StackFrame) -> str:
    """Return the value of what is typed, as it is shown: a variable as the program of `frame` sees
    it, a named variable, a mode by its name, an axis, or an expression in the language of the
    control, which is read in the innermost program.

    Raises `KeyError` for a variable that is not there, and `ValueError` for what is no expression,
    has no value, or reads locals of another level than the present one.
    """
    asked = text.strip()
    if (number := number_of(machine, asked)) is not None:
        return value_text(machine.variables.level(frame.level)[number])
    named = machine.variables.level(frame.level).named
    if asked.upper() in named:
        return value_text(named[asked.upper()])
    if asked in machine.modal:
        return str(machine.modal[asked])
    if asked in SWITCHES:
        return switch_text(machine, asked)
    if (place := _place(machine, asked)) is not None:
        position, axis = place
        return length_text(position[axis])
    if frame.index:
        raise ValueError(
            f"{asked!r} is read in the innermost program alone; in {frame.program} ask for a"
            " variable by its number or name"
        )
    return value_text(machine.evaluate(asked))


def is_state_name(core: _core.Machine, name: str) -> bool:
    """Return whether a name is that of a mode, an axis or a switch: it is no expression."""
    return name.strip() in (*core.modal, *SWITCHES) or _axis(core, name) is not None


def _axis(core: _core.Machine, name: str) -> tuple[str, bool] | None:
    """Return the axis that `X` or `X (machine)` means, and whether in machine coordinates."""
    axis, _, of = name.strip().upper().partition(" ")
    known = axis in core.position and of.strip() in ("", "(MACHINE)")
    return (axis, bool(of)) if known else None


def _place(machine: Machine, name: str) -> tuple[Position, str] | None:
    """Return the coordinates that a name means, and the axis."""
    if (meant := _axis(machine.core, name)) is None:
        return None
    axis, in_machine = meant
    return (machine.machine_position if in_machine else machine.position), axis


def put(machine: Machine, name: str, text: str, frame: StackFrame) -> str:
    """Give a variable, a named variable, a mode, an axis or a switch a value, and return it as it
    is shown. The text of a variable is an expression of the control or `vacant`; of an axis an
    expression, mm; of a mode it is a code; of a switch `on`, `off`, or the numbers of those that
    are on.

    Raises `KeyError` for a name that is not there, and `ValueError` for what cannot be its value.
    """
    if (place := _place(machine, name)) is not None:
        position, axis = place
        value = _number(machine, text)
        if value is None:
            raise ValueError(f"{axis} always stands somewhere: give a value, mm")
        position[axis] = value
        return length_text(position[axis])
    asked = name.partition(" (")[0].strip()
    if asked in SWITCHES:
        _switch(machine, asked, text)
        return switch_text(machine, asked)
    variables = machine.variables.level(frame.level)
    signal = _core.variable_number(machine.core.code.control, asked)
    if signal is not None and _is_signal(machine, signal):
        machine.signals[signal] = _number(machine, text) or 0.0
        return value_text(machine.signals[signal])
    if (number := number_of(machine, asked)) is not None:
        variables[number] = _number(machine, text)
        return value_text(variables[number])
    named = variables.named
    if asked.upper() in named:
        named[asked.upper()] = _typed(machine, text, named[asked.upper()])
        return value_text(variables.named[asked.upper()])
    if (element := _ELEMENT.fullmatch(asked)) and element[1].upper() in named:
        return _put_element(machine, variables, element, text)
    if asked in machine.modal:
        machine.modal[asked] = text.strip()
        return str(machine.modal[asked])
    return _assign(machine, asked, text, frame)


def _put_element(
    machine: Machine, variables: MachineVariables, element: re.Match[str], text: str
) -> str:
    """Give an element of an array a value, such as `SIDES[1]` or `GRID[0,R1]`."""
    name = element[1].upper()
    array = elements = _lists(variables.named[name])
    *rows, last = (int(_number(machine, index) or 0) for index in element[2].split(","))
    try:
        for row in rows:
            elements = elements[_counted(row)]
        if isinstance(held := elements[_counted(last)], list):
            raise IndexError(last)
        elements[last] = _typed(machine, text, held)
    except (IndexError, TypeError):
        raise KeyError(f"{name} has no element {element[0]!r}") from None
    variables.named[name] = array
    return value_text(elements[last])


def _lists(values: Any) -> Any:
    """Return an array as lists that may be changed."""
    return [*map(_lists, values)] if isinstance(values, list) else values


def _counted(index: int) -> int:
    """Return an index; a negative one is none of the control."""
    if index < 0:
        raise IndexError(index)
    return index


def _assign(machine: Machine, name: str, text: str, frame: StackFrame) -> str:
    """Give what the control calls by a name, such as `#<depth>` or `$P_UIFR[1,X,TR]`, a value by a
    block that is typed; it changes nothing where it raises an alarm.
    """
    try:
        evaluate(machine, name, frame)
        is_constant = name[:1] in "+-.0123456789"
    except ValueError:
        is_constant = True
    if is_constant:
        raise KeyError(f"{name!r} cannot be set: it is no variable, mode, axis or switch")
    value = machine.evaluate(text) if text.strip()[:1] != '"' else None
    is_number = isinstance(value, float)
    written = f"{value:.10f}".rstrip("0").rstrip(".") if is_number else text
    tried = machine.copy()
    for each in (tried, machine):
        each.mdi(f"{name}={written}")
        if each.alarm is not None:
            raise ValueError(f"{name}={text}: {each.alarm.detail or each.alarm.cause}")
    return evaluate(machine, name, frame)


def _switch(machine: Machine, name: str, text: str) -> None:
    words = text.replace(",", " ").lower().split()
    if name == "block_skip" and all(word.isascii() and word.isdecimal() for word in words):
        machine.block_skip = [int(word) for word in words]
    elif len(words) == 1 and words[0] in (*_ON, *_OFF):
        setattr(machine, name, words[0] in _ON)
    else:
        numbers = ", or the numbers of the switches that are on" if name == "block_skip" else ""
        raise ValueError(f"{name} is on or off{numbers}, not {text!r}")


def _is_signal(machine: Machine, number: int) -> bool:
    try:
        machine.core.get_signal(number)
    except KeyError:
        return False
    return True


def _number(machine: Machine, text: str) -> float | None:
    if text.strip().lower() in _VACANT:
        return None
    value = machine.evaluate(text)
    if isinstance(value, str):
        raise ValueError(f"{text!r} is no number")
    return value


def _typed(machine: Machine, text: str, held: object) -> object:
    """Return what a named variable takes for a text, by the type of what it holds."""
    if isinstance(held, list):
        inner = text.strip().removeprefix("[").removesuffix("]")
        first = next(iter(held), 0.0)
        return [_typed(machine, each, first) for each in inner.split(",")]
    if isinstance(held, str):
        return text.strip().removeprefix('"').removesuffix('"')
    number = _number(machine, text)
    if number is None:
        raise ValueError("a variable with a name is never vacant: give a value")
    return number
