"""The machine that runs a program one step at a time, to breakpoints, and back."""

from __future__ import annotations

import operator
import re
from collections.abc import Iterable, Iterator

from cncsub import _core
from cncsub._core import Frame
from cncsub.breakpoints import At, Breakpoint, Compiled, addresses_of, as_breakpoints
from cncsub.breakpoints import compiled as compiled_expressions
from cncsub.files import clean
from cncsub.inputs import is_whole
from cncsub.program import Block, Program
from cncsub.run import Outcome, Run, Stop
from cncsub.run_options import switches
from cncsub.tables.rows import Step
from cncsub.variables import MachineVariables, Modes, Position, Signals

Until = At | Breakpoint | int | Iterable[At | Breakpoint]


class Machine(Outcome):
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

    def __init__(self, core: _core.Machine) -> None:
        super().__init__(core)
        core.remember()
        self._reached: tuple[Breakpoint, ...] = ()

    def __setattr__(self, name: str, value: object) -> None:
        own = name in _OWN and name not in self.__dict__
        if not name.startswith("_") and not own and name not in _SETTABLE:
            cure = f" ({_INSTEAD[name]})" if name in _INSTEAD else ""
            raise AttributeError(
                f"{name!r} of a machine cannot be set{cure}; what can be set:"
                f" {', '.join(_SETTABLE)}, and the values of {', '.join(_MAPPINGS)}"
            )
        object.__setattr__(self, name, value)

    def step(self) -> Step | None:
        """Execute one block. `None` where the run has stopped and nothing was executed."""
        return self.core.step(Step)

    @property
    def next(self) -> Block | None:
        """The block about to be executed, with its words and its program; blocks that are skipped
        by the block-skip switches are passed over. After an alarm it is the block that alarmed.
        `None` where the program has ended, or where its text ends without M02, M30 or M99.

        >>> import cncsub
        >>> machine = cncsub.loads("O1\\nN10 G0 X5.\\nN20 M30\\n", control="fanuc-0i-f").machine()
        >>> block = machine.next
        >>> block.n, block.text, block.words[-1].value, block.program.name
        (10, 'N10 G0 X5.', 5.0, 'O1')
        """
        address = self.core.next_block
        if address is None:
            return None
        program, index = self.core.code.place_of(address)
        blocks = Program(self.core.code.program(program), program).blocks
        return blocks[index] if index < len(blocks) else None

    def run(self, until: Until | None = None) -> Run | None:
        """Run on until the program stops; then return what `Library.run` would have returned.

        `until` is one breakpoint or several: a `Block` or program and sequence number such as
        `("O2", 30)` stop before that block; a text or a `Breakpoint` is as described there. A whole
        number stops where no more than that many calls are open:
        `machine.run(until=len(machine.stack) - 1)` steps out, of the main program to its end (-1).
        Returns `None` where it stopped there, and where `pause` stopped it; `reached` tells which
        breakpoints it was. What the machine
        stands at does not stop it again. A machine that Ctrl-C stopped goes on.

        Raises `KeyError` for a program, a block or a line that is not there, `ValueError` for a
        block of another library, for a text that is no breakpoint or no expression, for a number
        below -1, and where a condition has no value when it is asked (the machine stands before
        that block then).

        >>> import cncsub
        >>> text = "O1\\nN10 M98 P2\\nN20 T5\\nN30 M30\\nO2\\nN40 #100=7\\nN50 M99\\n"
        >>> machine = cncsub.loads(text, control="fanuc-0i-f").machine()
        >>> seen = []
        >>> while machine.run(until=["call", "changes #100", "O1:N20", "T"]) is None:
        ...     seen.append((machine.reached[0].at, machine.next.n))
        >>> seen
        [('call', 40), ('changes #100', 50), ('O1:N20', 20), ('T', 30)]
        """
        if until is None:
            self._reached = ()
            paused = self.core.run()
        elif is_whole(until):
            paused = self._run_to([], _depth(until))  # type: ignore[arg-type]
        else:
            paused = self._run_to(as_breakpoints(until), None)
        # The machine may go on; the run is a copy and does not change.
        return None if paused or self.core.stop is None else Run(self.core.copy())

    def pause(self) -> None:
        """Stop the `run` that another thread is at, or the next one where none is under way. It
        returns `None` within some hundredths of a second, with nothing in `reached`, and `stop` is
        `Stop.INTERRUPTED` until the machine runs on.

        >>> import cncsub, threading
        >>> machine = cncsub.loads("O1\\nN10 GOTO10\\n", control="fanuc-0i-f").machine(
        ...     max_blocks=10**12, trace="none")
        >>> threading.Timer(0.01, machine.pause).start()
        >>> machine.run() is None, machine.stop == "interrupted", machine.next.n
        (True, True, 10)
        """
        self.core.pause()

    def _run_to(self, breakpoints: list[Breakpoint], depth: int | None) -> bool:
        """Run to one of the breakpoints, or until so few calls are open. Return whether `pause`
        stopped it.
        """
        compiled = Compiled(self.core, breakpoints)
        self._reached = ()
        reached, faulty, paused = compiled.run([] if depth is None else [depth])
        self._reached = tuple(breakpoints[i] for i in reached if i < len(breakpoints))
        if faulty is not None:
            place, detail = faulty
            raise ValueError(f"{breakpoints[place]!r} has no value at {self!r}: {detail}")
        return paused

    @property
    def reached(self) -> tuple[Breakpoint, ...]:
        """The breakpoints at which the last `run` stopped, in the order in which they were given.
        Empty where it stopped for another reason.
        """
        return self._reached

    def back(self, to: int | At | Breakpoint | None = None) -> None:
        """Go back: the machine stands as it stood then, with all tables, variables and modes.

        `to`: without it, before the block that was executed last. A whole number is the step: that
        many blocks were executed (0 is the head of the program, `blocks` the present place, without
        an alarm that came there). `"call"` is the block that called the program that runs,
        `"alarm"` the block that alarmed, before it did. Anything
        else is a breakpoint: where it was met last, `next` being the block of the place, or the
        block that did it: `"changes #100"`, or `"#100"` for short, goes to where the variable was
        last written with another value. `hits` does not count here.

        What was set from outside after that place is forgotten; what was set before it is set
        again. From wherever the run is, going back runs again what lies between a snapshot and the
        place, milliseconds even after ten million blocks; the search for a breakpoint that was not
        met for long runs the program again.

        Blocks that were typed by `mdi` at the step are gone there. Ctrl-C stops going back, and
        `pause` does so with an `InterruptedError`; the machine stays where it is then.

        Raises `ValueError` where there is nothing to go back to (the machine stays where it is) and
        what `run` raises for a wrong place.

        >>> import cncsub
        >>> text = "O1\\nN10 #100=7\\nN20 G0 X5.\\nN30 G65 P2\\nN40 M30\\nO2\\nN50 M99\\n"
        >>> machine = cncsub.loads(text, control="fanuc-0i-f").machine()
        >>> machine.run(until="O2:N50")
        >>> places = []
        >>> for to in (None, "#100", 0):
        ...     machine.back(to)
        ...     places.append((machine.next.n, machine.variables[100], machine.blocks))
        >>> places
        [(30, 7.0, 2), (10, None, 0), (10, None, 0)]
        """
        if self.core.back(self._step_of(to)):
            raise _interrupted()
        self._reached = ()

    def _step_of(self, to: int | At | Breakpoint | None) -> int:
        blocks = self.core.blocks
        if to is None:
            if blocks == 0:
                raise ValueError("the machine is at the head of the program: no block was executed")
            return blocks - 1
        if is_whole(to):
            step = operator.index(to)  # type: ignore[arg-type]
            if not 0 <= step <= blocks:
                raise ValueError(f"to: the steps behind are 0 to {blocks}, not {step}")
            return step
        if to == "call":
            if (step := self.core.step_of_call) < 0:
                raise ValueError("to: no call is open; the main program runs")
            return step
        if isinstance(to, str) and _VARIABLE.match(to) and not _EVENT.match(to):
            to = f"changes {to}"
        if not (breakpoints := as_breakpoints(to, "to")):
            raise ValueError("to names no place: give a step, 'call', a variable or a breakpoint")
        last = Compiled(self.core, breakpoints).last_met()
        if last is None:
            raise _interrupted()
        if last < 0:
            what = " or ".join(repr(each.at) for each in breakpoints)
            raise ValueError(f"to: {what} was not met in the {blocks} blocks before")
        return last

    def goto(self, at: At) -> None:
        """Make another block of the program that runs the next one. Nothing is executed; variables,
        modes and position stay as they are, an alarm is gone. `back` replays it on the way to a
        later step, and forgets it on the way to an earlier one.

        `at` is a place as `run` takes it: a `Block`, `("O2", 30)`, `"O2:N30"` or `"job.nc:12"`.
        Loops that do not hold the block are left, and those that do stay open, as at a GOTO of the
        program: a loop that is entered in its middle alarms at its END, as it would there.

        Raises `KeyError` for a program, a block or a line that is not there, and `ValueError` with
        the reason for a block of another program, outside a part that is repeated, inside a branch
        or a loop that cannot be entered so, and where the program has ended; the machine stays as
        it is then.

        >>> import cncsub
        >>> text = "O1\\nN10 #100=1\\nN20 #100=2\\nN30 #101=#100\\nN40 M30\\n"
        >>> machine = cncsub.loads(text, control="fanuc-0i-f").machine()
        >>> machine.run(until="O1:N20")
        >>> machine.goto("O1:N30")
        >>> machine.next.n, machine.blocks
        (30, 1)
        >>> machine.run(until="O1:N40")
        >>> machine.variables[101]
        1.0
        """
        found = addresses_of(self.core, at)
        place_of = self.core.code.place_of
        running = (place_of(self.core.address)[0], self.core.open_frames[-1]["program"])
        own = [address for address in found if place_of(address)[0] in running]
        lines = {self.core.code.program(program).block(index)[1] for program, index in
                 map(place_of, own)}  # fmt: skip
        if len(lines) > 1:
            told = ", ".join(map(str, sorted(lines)))
            raise ValueError(f"{at!r} stands on the lines {told}: give one, such as 'job.nc:12'")
        self.core.set_next_block((own or found)[0])
        self._reached = ()

    def mdi(self, text: str) -> None:
        """Execute blocks typed in MDI, in the present state: modes, offsets, the locals of the
        present level. After them the machine stands where it stood. What they call is executed too.
        Their blocks are steps of a program `MDI`, and `back` goes over them like over others; it
        executes them again on the way to a later step.

        The machine stops in them where a program would: at an alarm, at an input that is not given,
        by `pause`. Text typed after an alarm in a typed block takes the place of that block.

        Raises `TypeError` for what is no text, and `ValueError` for what is no block of the control
        (nothing is executed then), for a program with a head, for the definition of a variable, and
        where the program has ended.

        >>> import cncsub
        >>> text = "O1\\nN10 G91 G0 X5.\\nN20 X5.\\nN30 M30\\nO2\\nG90 X#100 Z1.\\nM99\\n"
        >>> machine = cncsub.loads(text, control="fanuc-0i-f").machine()
        >>> machine.run(until="O1:N20")
        >>> machine.mdi("#100=20")
        >>> machine.mdi("M98 P2")
        >>> machine.position["X"], machine.next.n, machine.blocks
        (20.0, 20, 5)
        >>> machine.back(1)
        >>> machine.position["X"], machine.variables[100], machine.next.n
        (5.0, None, 20)
        """
        type_in(self.core, text)
        self._run_to([], len(self.stack) - 1)

    def evaluate(self, expression: str) -> float | str | None:
        """Return the value of an expression in the language of the control, in the present state,
        which stays as it is: `None` is the vacant value, a condition is 1 or 0, a text, an axis and
        a frame are texts.

        Raises `TypeError` for what is no text, and `ValueError` for what is no expression of the
        control or has no value.

        >>> import cncsub
        >>> machine = cncsub.loads("O1\\n#100=7\\nM30\\n", control="fanuc-0i-f").machine()
        >>> _ = machine.step()
        >>> machine.evaluate("#100*2+1"), machine.evaluate("#100 GT 8"), machine.evaluate("#101")
        (15.0, 0.0, None)
        """
        if not isinstance(expression, str):
            raise TypeError(f"an expression is a text, not {expression!r}")
        program = self.core.code.place_of(self.core.address)[0]
        expressions = compiled_expressions(self.core, [(expression, program)], ["evaluate"])
        return self.core.evaluate(expressions, 0)

    def __iter__(self) -> Iterator[Step]:
        while (step := self.step()) is not None:
            yield step

    def reset(self) -> None:
        """Press the reset key: calls and modal calls are gone, the variables that the control
        clears are vacant, and the main program is at its head. What was recorded stays.
        """
        self.core.reset()

    def copy(self) -> Machine:
        """Return a machine in the same state that runs on its own: a snapshot to come back to."""
        return Machine(self.core.copy())

    __copy__ = copy

    def __deepcopy__(self, memo: object) -> Machine:
        return self.copy()

    @property
    def stop(self) -> Stop | None:
        """Why the program stopped, `None` while it runs."""
        return None if self.core.stop is None else Stop(self.core.stop)

    @property
    def stack(self) -> tuple[Frame, ...]:
        """The open calls, innermost first."""
        return self.core.stack

    @property
    def variables(self) -> MachineVariables:
        """The variables now, to read and to set; `#1` and so on are those of the present level."""
        return MachineVariables(self.core, -1)

    @property
    def modal(self) -> Modes:
        """The modal codes in force, by group, to read and to set:
        `machine.modal["distance"] = "G91"`, `machine.modal["F"] = 100`. A code is read as the
        control reads it, and set without a move.

        Raises `KeyError` for a mode that is not there, and `ValueError` for a code that sets
        another one.

        >>> import cncsub
        >>> machine = cncsub.loads("O1\\nN10 X5. F100\\nM30\\n", control="fanuc-0i-f").machine()
        >>> machine.modal["motion"] = "G1"
        >>> _ = machine.step()
        >>> machine.modal["motion"], machine.moves[0].kind
        ('G01', 'feed')
        """
        return Modes(self.core)

    @property
    def position(self) -> Position:
        """The position of the tool: work coordinates by axis, mm, to read and to set:
        `machine.position["X"] = 5` lets the tool stand there, as if it was brought there by hand.
        That is no move: the next one begins there.

        Raises `KeyError` for an axis that is not there, and `ValueError` for a place beyond the
        travel, and while a move waits for the one after it.

        >>> import cncsub
        >>> text = "O1\\nN10 G0 X5.\\nN20 G91 X1.\\nM30\\n"
        >>> machine = cncsub.loads(text, control="fanuc-0i-f").machine()
        >>> machine.run(until="O1:N20")
        >>> machine.position["X"] = 20
        >>> _ = machine.step()
        >>> machine.position["X"], machine.moves[1].length
        (21.0, 1.0)
        """
        return Position(self.core, in_machine=False)

    @property
    def machine_position(self) -> Position:
        """The position of the tool in machine coordinates by axis, mm, to read and to set like
        `position`.
        """
        return Position(self.core, in_machine=True)

    @property
    def block_skip(self) -> tuple[int, ...]:
        """The block-skip switches that are on, to read and to set: `machine.block_skip = (1,)`."""
        return self.core.switches[0]

    @block_skip.setter
    def block_skip(self, on: Iterable[int] | int | bool) -> None:
        self.core.set_switches(list(switches(on)), self.core.switches[1])

    @property
    def optional_stop(self) -> bool:
        """Whether M01 stops, to read and to set."""
        return self.core.switches[1]

    @optional_stop.setter
    def optional_stop(self, stops: bool) -> None:
        if not isinstance(stops, bool):
            raise TypeError(f"optional_stop must be True or False, not {stops!r}")
        self.core.set_switches(list(self.core.switches[0]), stops)

    @property
    def signals(self) -> Signals:
        """The interface inputs now, to read and to set: `machine.signals[1004] = 1`."""
        return Signals(self.core)

    def __repr__(self) -> str:
        try:
            program, n, line = self.core.position_in_program
        except RuntimeError:
            return "<Machine: at work in another thread>"
        where = program if n is None else f"{program} N{n}"
        return f"<Machine: {self.summary()}, next block {where}, line {line}>"


def type_in(core: _core.Machine, text: str) -> None:
    """Make blocks typed in MDI those that run next. Raises what `Machine.mdi` raises."""
    if not isinstance(text, str):
        raise TypeError(f"mdi must be the text that was typed, not {type(text).__name__}")
    typed = clean(text)
    fault = core.type_in(typed)
    if fault is None:
        return
    detail, line, column, width = fault
    told = (typed.splitlines() or [""])[line - 1 : line]
    caret = " " * max(0, column - 1) + "^" * max(1, width)
    shown = "".join(f"\n  {each}\n  {caret}" for each in told)
    raise ValueError(f"mdi: {detail}, on {core.code.control.name}{shown}")


def _interrupted() -> InterruptedError:
    return InterruptedError("going back was paused; the machine stands where it stood")


# What a machine holds itself, what can be set of it by name, and what holds values to be set.
_OWN = frozenset({"core", "recorded"})
_SETTABLE = ("block_skip", "optional_stop")
_INSTEAD = {
    "next": "goto makes another block the next one",
    "stop": "back takes it away",
    "alarm": "back takes it away",
    "stack": "mdi calls a program, back leaves it",
    "waiting_for": "set the input that it waits for",
}
_MAPPINGS = (
    "variables",
    "variables.named",
    "signals",
    "modal",
    "position",
    "machine_position",
)
_VARIABLE = re.compile(r"\s*(#|R\d|\$|[A-Za-z_]\w*\s*$)")
_EVENT = re.compile(r"\s*(alarm|return|mode|[MTS]\d*)\s*$")


def _depth(until: int) -> int:
    depth = operator.index(until)
    if depth < -1:
        raise ValueError(
            "until: the number of open calls must be 0 or more, or -1 to run to the end;"
            f" not {depth}"
        )
    return min(depth, 1 << 30)
