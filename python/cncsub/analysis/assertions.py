"""Assertions on a run, and what their failure shows."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Protocol

from cncsub import _core
from cncsub._core import Alarm, Machine
from cncsub.analysis.steps_text import calls_to, place_of
from cncsub.program import find_program
from cncsub.tables.of_runs import Calls, Steps

_LAST = 8  # steps that are shown, of those before the stop
_VARIABLES = 24
_WORD = re.compile(r"N(\d{1,9})", re.IGNORECASE)


class Stopped(Protocol):
    """The part of a run that is read here."""

    core: Machine

    @property
    def stop(self) -> str: ...
    @property
    def alarm(self) -> Alarm | None: ...
    @property
    def waiting_for(self) -> str: ...
    @property
    def blocks(self) -> int: ...
    @property
    def steps(self) -> Steps: ...
    @property
    def calls(self) -> Calls: ...
    @property
    def variables(self) -> Mapping[int, float | None]: ...
    def summary(self) -> str: ...


def assert_ends(run: Stopped) -> None:
    """Raise `AssertionError` where the run did not come to its end."""
    __tracebackhide__ = True  # of pytest: a failure stands in the test
    if run.stop != "end":
        raise AssertionError(f"the program does not end: {_why(run)}\n{_report(run)}")


def assert_alarm(run: Stopped, expected: str, at: str | None) -> None:
    """Raise `AssertionError` where the run did not stop with this alarm, or not at this place."""
    __tracebackhide__ = True  # of pytest: a failure stands in the test
    if not isinstance(expected, str):
        raise TypeError(
            f"alarm must be the number or the cause of an alarm, a text, not {expected!r}; "
            "write the cause if it has no number"
        )
    program, n = _place(run, at)
    alarm = run.alarm
    if alarm is None or expected not in (alarm.number, alarm.cause):
        raise AssertionError(f"expected alarm {expected}, but {_why(run)}\n{_report(run)}")
    elsewhere = (program is not None and find_program(run.core.code, alarm.program) != program) or (
        n is not None and alarm.n != n
    )
    if elsewhere:
        raise AssertionError(f"expected alarm {expected} at {at}, but {_why(run)}\n{_report(run)}")


def _place(run: Stopped, at: object) -> tuple[int | None, int | None]:
    """Return the place of the program among those of the library, and N."""
    words = at.split() if isinstance(at, str) else []
    n = _WORD.fullmatch(words[-1]) if words else None
    names = words[:-1] if n else words
    if at is not None and (not words or len(names) > 1):
        kind = ValueError if isinstance(at, str) else TypeError
        raise kind(f'at must be a program, a block or both, such as "O10 N30", not {at!r}')
    if not names:
        return None, int(n[1]) if n else None
    program = find_program(run.core.code, names[0])
    if program < 0:
        raise ValueError(f"at is {at!r}, but there is no program {names[0]}")
    return program, int(n[1]) if n else None


def _why(run: Stopped) -> str:
    if run.alarm is not None:
        return f"it stopped with {run.summary()}"
    waiting = f" for {run.waiting_for}" if run.waiting_for else ""
    return f"it stopped with {run.stop!r}{waiting}"


def _report(run: Stopped) -> str:
    return "\n".join(_lines(run))


def _lines(run: Stopped) -> Iterator[str]:
    if run.alarm is not None:
        yield from str(run.alarm).split("\n")
    count = len(run.steps)
    yield f"the last of {run.blocks} blocks:" if count else f"{run.blocks} blocks ran"
    for i in range(max(0, count - _LAST), count):
        step = run.steps[i]
        text = step.text.strip()
        yield f"  {place_of(step)}, depth {step.depth}" + (f": {text}" if text else "")
    if count and run.alarm is None:  # an alarm names its calls
        yield from (f"  {line}" for line in calls_to(run, run.steps[count - 1]))
    values = [(number, value) for number, value in run.variables.items() if value is not None]
    if values:
        yield "variables: " + ", ".join(
            f"{_core.variable_name(run.steps.core.control, number)} = {value:g}"
            for number, value in values[:_VARIABLES]
        )
    if len(values) > _VARIABLES:
        yield f"  and {len(values) - _VARIABLES} more with a value"
