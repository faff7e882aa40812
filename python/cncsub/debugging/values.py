"""The values of a machine by what people type: read, and set."""

from __future__ import annotations

from cncsub.debugging.frames import StackFrame
from cncsub.debugging.scopes import value_text
from cncsub.machine import Machine
from cncsub.number_text import length_text

_VACANT = ("vacant", "#0", "")


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
    if asked.upper() in machine.position:
        return length_text(machine.position[asked.upper()])
    if frame.index:
        raise ValueError(
            f"{asked!r} is read in the innermost program alone; in {frame.program} ask for a"
            " variable by its number or name"
        )
    return value_text(machine.evaluate(asked))


def put(machine: Machine, name: str, text: str, frame: StackFrame) -> str:
    """Give a variable, a named variable or a mode a value, and return it as it is shown. The text
    of a variable is an expression of the control or `vacant`; of a mode it is a code.

    Raises `KeyError` for a name that is not there, and `ValueError` for what cannot be its value.
    """
    asked = name.partition(" (")[0].strip()
    variables = machine.variables.level(frame.level)
    if (number := number_of(machine, asked)) is not None:
        variables[number] = _number(machine, text)
        return value_text(variables[number])
    named = variables.named
    if asked.upper() in named:
        named[asked.upper()] = _typed(machine, text, named[asked.upper()])
        return value_text(variables.named[asked.upper()])
    if asked in machine.modal:
        machine.modal[asked] = text.strip()
        return str(machine.modal[asked])
    raise KeyError(f"{asked!r} cannot be set: it is no variable and no mode")


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
