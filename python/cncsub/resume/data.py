"""What a restart's head sets of the control's data: offsets, and variables of no single call."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import TYPE_CHECKING, Any

from cncsub import _core
from cncsub._core import Control
from cncsub.resume.draft import Draft
from cncsub.resume.errors import refused
from cncsub.setup import AXES

if TYPE_CHECKING:
    from cncsub.machine import Machine

# The variables of the work offsets: 9 systems, 20 numbers apart. [gHn; LinuxCNC, System Parameters]
_FIRST_OFFSET, _APART, _SYSTEMS = 5221, 20, 9
_DATA = (10, 10.1, 10.9, 52, 92)  # the G codes that set data


def write_variables(draft: Draft, *, commons: bool) -> None:
    """Write the values of the variables that no call has of its own: those of the control that
    differ and, where they are asked for, those that programs may use as they like.
    """
    machine, fresh = draft.machine, draft.now
    of_main = machine.variables.level(0)
    lines = []
    for number in _numbers(draft):
        value = of_main[number]
        free = machine.core.can_be_vacant(number)
        if (free and not commons) or (
            value == fresh.variables[number] and (value is None or not free)
        ):
            continue
        if not machine.core.follows_time(number) and _settable(fresh, number, value):
            lines.append(machine.core.assignment(number, value))
    if lines and not draft.add(*lines):
        wrong = next(line for line in lines if not draft.add(line))
        raise refused(f"the control takes no block {wrong!r}", draft.state.block)


def write_offsets(draft: Draft) -> None:
    """Set by G10 the work offsets that the program has set, where no assignment does: grblHAL
    writes none of its variables from 5061 on.
    """
    core = draft.machine.core
    if not any(_sets_data(core, block) for block in draft.blocks()):
        return
    for system in range(_SYSTEMS):
        numbers = {
            axis: _FIRST_OFFSET + _APART * system + place
            for place, axis in enumerate(AXES)
            if axis in draft.state.position
        }
        values = {axis: _reads(draft.machine, number) for axis, number in numbers.items()}
        apart = [
            f"{axis}{draft.text(axis, value)}"
            for axis, value in values.items()
            if value is not None and value != _reads(draft.now, numbers[axis])
        ]
        if apart:
            draft.add(f"G10 L2 P{system + 1} {' '.join(apart)}")


def _numbers(draft: Draft) -> Iterator[int]:
    known = sorted(draft.machine.variables.level(0))
    yield from known
    core = draft.machine.core
    if not any(_sets_data(core, block) for block in draft.blocks()):
        return
    seen = set(known)
    for number in _readable(core.code.control):
        if number not in seen and _reads(draft.machine, number) != _reads(draft.now, number):
            yield number


def _reads(machine: Machine, number: int) -> float | None:
    try:
        return machine.core.get_variable(number)
    except (KeyError, ValueError):
        return None


@cache
def _readable(control: Control) -> tuple[int, ...]:
    """Return the numbers of the control's own variables."""
    code = _core.compile(control, [], False)
    return tuple(number for number in range(1000, 20000) if can_be_read(code, number))


def can_be_read(code: _core.Code, number: int) -> bool:
    """Return whether the control has a variable that can be read: asking is ten times as fast as
    reading in vain, and most numbers are none.
    """
    facts = code.variable_facts(number)
    return facts is not None and facts[1]


def _settable(machine: Machine, number: int, value: float | None) -> bool:
    try:
        machine.core.copy().set_variable(number, value, 0)
    except (KeyError, ValueError):
        return False
    return True


def _sets_data(core: Any, block: Any) -> bool:
    """Return whether a block may set what the control keeps: offsets, and variables of its own."""
    if any(word.address == "G" and word.value in _DATA for word in block.words):
        return True
    return any(
        not isinstance(use.variable, int) or not core.can_be_vacant(use.variable)
        for use in block.writes
    )
