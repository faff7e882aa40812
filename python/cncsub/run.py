"""What a run leaves behind, and the machine that makes it one step at a time."""

from __future__ import annotations

import enum
import functools
import operator
from collections.abc import Iterator, Mapping, MutableMapping

from cncsub import _core
from cncsub._core import Alarm, Frame
from cncsub.controls import did_you_mean
from cncsub.inputs import checked_variables
from cncsub.program import Block
from cncsub.rows import Step
from cncsub.tables import Calls, Moves, Steps

Until = Block | tuple[str | int, int] | int


class Stop(enum.StrEnum):
    """Why a run stopped."""

    END = "end"  # M02, M30 or what else ends a program
    ALARM = "alarm"
    CYCLES = "cycles"  # the main program started over `max_cycles` times
    LIMIT = "limit"  # `max_blocks` or `max_seconds`
    WAITING = "waiting"  # for an input nobody gave
    INTERRUPTED = "interrupted"  # Ctrl-C


class AlarmError(Exception):
    """Raised by `raise_for_alarm`; the alarm is in `.alarm`, its message is the text."""

    def __init__(self, alarm: Alarm) -> None:
        super().__init__(str(alarm))
        self.alarm = alarm

    def __reduce__(self) -> tuple[type[AlarmError], tuple[Alarm]]:
        return AlarmError, (self.alarm,)


class Variables(Mapping[int, float | None]):
    """Variables by number: what was ever set, and every other number the control has, which is
    vacant (`None`).

    Iteration and `len` go over those that hold a value, each under one number (the HNC shows the
    locals of the open levels under `#200` and so on besides). Reading a number the control does not
    have, or that cannot be read, is a `KeyError`.
    """

    def __init__(self, core: _core.Machine, level: int) -> None:
        self._core = core
        self._level = level

    def __getitem__(self, number: int) -> float | None:
        try:
            return self._core.get_variable(operator.index(number), self._level)
        except (TypeError, ValueError, LookupError, OverflowError) as error:
            detail = str(error.args[0]) if error.args else "there is no such variable"
            raise KeyError(f"#{number}: {detail}") from None

    def __iter__(self) -> Iterator[int]:
        return (number for number, value in self._set().items() if value is not None)

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def __contains__(self, number: object) -> bool:
        try:
            return self[number] is not None  # type: ignore[index]
        except KeyError:
            return False

    def _set(self) -> dict[int, float | None]:
        return self._core.variables(self._level)

    def __repr__(self) -> str:
        return "{" + ", ".join(f"{number}: {self[number]:g}" for number in self) + "}"


class MachineVariables(Variables, MutableMapping[int, float | None]):
    """The variables of a machine, to read and to set; `None` makes one vacant. `#1` and so on are
    those of one level.
    """

    def __setitem__(self, number: int, value: float | None) -> None:
        ((checked, number_or_none),) = checked_variables("variables", {number: value}).items()
        try:
            self._core.set_variable(checked, number_or_none, self._level)
        except LookupError as error:
            raise KeyError(
                f"#{number}: {error.args[0] if error.args else 'no such variable'}"
            ) from None

    def __delitem__(self, number: int) -> None:
        self[number] = None

    def level(self, level: int) -> MachineVariables:
        """The same variables with the locals of another level, 0 for those of the main program."""
        if not 0 <= level <= self._core.level:
            raise ValueError(f"the open levels are 0 to {self._core.level}, not {level}")
        return MachineVariables(self._core, level)


class Recorded:
    """What was recorded, in a run, by a machine so far, or in one part of a stream."""

    def __init__(self, core: _core.Trace, axes: list[str] | None = None) -> None:
        self._trace = core
        self._axes = axes

    @functools.cached_property
    def steps(self) -> Steps:
        """One row per executed block (with `trace="blocks"` or `"moves"`)."""
        return Steps(self._trace)

    @functools.cached_property
    def calls(self) -> Calls:
        """One row per entered call (with any `trace` but `"none"`)."""
        return Calls(self._trace)

    @functools.cached_property
    def moves(self) -> Moves:
        """One row per motion (with `trace="moves"`)."""
        return Moves(self._trace, self._axes)

    @property
    def messages(self) -> list[str]:
        """What `#3006` and `DPRNT` wrote, in order."""
        return self._trace.messages

    @property
    def m_codes(self) -> list[int]:
        """The M codes sent to the machine, in order (with any `trace` but `"none"`)."""
        return self._trace.m_codes

    @property
    def t_codes(self) -> list[int]:
        """The T codes sent to the machine, in order (with any `trace` but `"none"`)."""
        return self._trace.t_codes


class State:
    """Where a machine stands."""

    def __init__(self, core: _core.Machine) -> None:
        self._core = core

    @property
    def alarm(self) -> Alarm | None:
        """The alarm that stopped the program."""
        return self._core.alarm

    @property
    def waiting_for(self) -> str:
        """What the run waits for, where it stopped with `Stop.WAITING`; else empty."""
        return self._core.waiting_for

    @property
    def blocks(self) -> int:
        """How many blocks were executed."""
        return self._core.blocks

    @property
    def position(self) -> dict[str, float]:
        """Where the tool stands: axis to work coordinate, mm."""
        return self._core.position

    @property
    def modal(self) -> dict[str, str]:
        """The modal codes in force, by group."""
        return self._core.modal

    def raise_for_alarm(self) -> None:
        """Raise `AlarmError` where an alarm stopped the program."""
        if self.alarm is not None:
            raise AlarmError(self.alarm)

    def _summary(self) -> str:
        alarm = self.alarm
        if alarm is not None:
            where = alarm.program if alarm.n is None else f"{alarm.program} N{alarm.n}"
            number = f"{alarm.number} " if alarm.number else ""
            return f"alarm {number}{alarm.cause} at {where}"
        return str(self._core.stop or "running")


class _Outcome(State, Recorded):
    """What a run and a machine both show."""

    def __init__(self, core: _core.Machine) -> None:
        State.__init__(self, core)
        Recorded.__init__(self, core.trace)


class Run(_Outcome):
    """A run that has stopped.

    >>> import cncsub
    >>> run = cncsub.loads("O1\\nN10 M98 P2\\nN20 M30\\n", control="fanuc-0i-f").run()
    >>> run.stop
    <Stop.ALARM: 'alarm'>
    >>> run.alarm.cause, run.alarm.number, run.alarm.n
    ('program-not-found', 'PS0076', 10)
    """

    @property
    def stop(self) -> Stop:
        """Why the run stopped."""
        return Stop(self._core.stop or "interrupted")

    @functools.cached_property
    def variables(self) -> Variables:
        """Variable number to value at the stop, `None` where it is vacant: commons and the main
        program's locals.
        """
        return Variables(self._core, 0)

    @property
    def variables_after_reset(self) -> dict[int, float]:
        """What is left of `variables` when M02, M30 or the reset key has cleared what the control
        clears (on FANUC by 6001#6 and 6001#7).

        >>> import cncsub
        >>> run = cncsub.loads("O1\\n#1=1\\n#500=5\\nM30\\n", control="fanuc-0i-f").run()
        >>> run.variables[1], run.variables_after_reset
        (1.0, {500: 5.0})
        """
        return {
            number: value
            for number, value in self.variables.items()
            if value is not None and not self._core.cleared_by_reset(number)
        }

    def __repr__(self) -> str:
        return f"<Run: {self._summary()}, {len(self.steps):,} steps, {len(self.calls):,} calls>"


class Machine(_Outcome):
    """One program on its control, executed block by block.

    >>> import cncsub
    >>> text = "O1\\nN10 #1=5\\nN20 G65 P2 A7.\\nN30 M30\\nO2\\nN40 #100=#1\\nN50 M99\\n"
    >>> machine = cncsub.loads(text, control="fanuc-0i-f").machine()
    >>> [machine.step().n for _ in range(3)]
    [10, 20, 40]
    >>> machine.variables[1], machine.variables.level(0)[1], machine.variables[100]
    (7.0, 5.0, 7.0)
    >>> [(frame.program, frame.n, frame.kind) for frame in machine.stack]
    [('O1', 20, 'G65')]
    >>> [step.n for step in machine]
    [50, 30]
    """

    def step(self) -> Step | None:
        """Execute one block. `None` where the run has stopped and nothing was executed."""
        return self.steps[-1] if self._core.step() else None

    def run(self, until: Until | None = None) -> Run | None:
        """Run on until the program stops; then return what `Library.run` would have returned.

        `until` stops before a block: a `Block`, or program and sequence number such as `("O2",
        30)`. A whole number stops where no more than that many calls are open:
        `machine.run(until=len(machine.stack) - 1)` steps out. Returns `None` where it stopped
        there. An unknown program or block is a `KeyError`. A machine that Ctrl-C stopped goes on.
        """
        self._core.run(None if until is None else self._place(until))
        # The machine may go on; the run stays what it is.
        return None if self._core.stop is None else Run(self._core.copy())

    def _place(self, until: Until) -> tuple[int, int]:
        if isinstance(until, Block):
            return until.program._index, until.line
        if isinstance(until, tuple) and len(until) == 2:
            return self._block_place(*until)
        try:
            return -1, operator.index(until)
        except TypeError:
            raise TypeError(
                f"until is a Block, such as ('O2', 30), or a number of open calls, not {until!r}"
            ) from None

    def _block_place(self, name: str | int, n: int) -> tuple[int, int]:
        code = self._core.code
        index = code.find(name)
        if index < 0:
            known = did_you_mean(name, (program.name for program in code.programs))
            raise KeyError(f"no program {name} in the memory{known}")
        program = code.programs[index]
        for block in range(program.blocks):
            number, line, _ = program.block(block)
            if number == n:
                return index, line
        raise KeyError(f"no block N{n} in {program.name}")

    def __iter__(self) -> Iterator[Step]:
        while (step := self.step()) is not None:
            yield step

    def reset(self) -> None:
        """Presses the reset key: calls and modal calls are gone, the variables that the control
        clears are vacant, and the main program is at its head. What was recorded stays.
        """
        self._core.reset()

    def copy(self) -> Machine:
        """A machine in the same state that goes its own way: a snapshot to come back to."""
        return Machine(self._core.copy())

    __copy__ = copy

    @property
    def stop(self) -> Stop | None:
        """Why the program stopped, `None` while it runs."""
        return None if self._core.stop is None else Stop(self._core.stop)

    @property
    def stack(self) -> tuple[Frame, ...]:
        """The open calls, innermost first."""
        return self._core.stack

    @property
    def variables(self) -> MachineVariables:
        """The variables now, to read and to set; `#1` and so on are those of the present level."""
        return MachineVariables(self._core, -1)

    def __repr__(self) -> str:
        try:
            program, n, line = self._core.position_in_program
        except RuntimeError:
            return "<Machine: at work in another thread>"
        where = program if n is None else f"{program} N{n}"
        return f"<Machine: {self._summary()}, next block {where}, line {line}>"
