"""A machine that is stepped, copied, changed, reset and run on in any order keeps its state right.

Hypothesis makes the programs and the order of the actions; the model is what was seen before.
"""

from __future__ import annotations

import copy
from typing import Any

from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import (
    Bundle,
    RuleBasedStateMachine,
    initialize,
    invariant,
    precondition,
    rule,
)

import cncsub

MAX_BLOCKS = 120
CONTROLS = [
    "fanuc-0i-f", "fanuc-30i", "gsk-988ta", "gsk-980tdi", "mitsubishi-meldas", "mitsubishi-m800",
    "hnc-21m", "gsk-928te",
]  # fmt: skip
BLOCKS = [
    "G0 X1.", "G1 X#100 F100", "Z-2.", "G91", "G90", "M3 S500", "M98 P2", "M98 P2 L3", "M98 P3",
    "M99", "M99 P10", "M30", "G65 P2 A1. B#1", "G65 P3 C2.", "G66 P2 A2.", "G67", "M98 P2 Q20",
    "#1=#1+1", "#100=#100+1", "#101=#1*2", "#500=#500+#1", "IF[#100 GT 3]GOTO20", "GOTO20",
    "IF[#100 LT 4]GOTO10", "WHILE[#1 LT 2]DO1", "END1", "#5221=1", "DPRNT[X#1[42]]", "M0", "T1",
    "G54.1 P1", "G43 H1", "G41 D1", "G40", "G81 X2. Z-1. R1. F50", "G80", "/X9.", "G28 Z0", "X",
    "#3006=1(OPEN)", "#3000=1(BAD)", "#[#100]=1",
]  # fmt: skip
NUMBERS = st.sampled_from([1, 2, 3, 100, 101, 110, 500, 501])
VALUES = st.none() | st.sampled_from([0, 1, -1, 2.5, 7, 1e6])
block = st.tuples(st.sampled_from(["N10 ", "N20 ", "", ""]), st.sampled_from(BLOCKS)).map("".join)
bodies = st.lists(block, min_size=1, max_size=7).map("\n".join)
texts = st.tuples(bodies, bodies, bodies).map(
    lambda b: f"O1\n{b[0]}\nO2\n{b[1]}\nM99\nO3\n{b[2]}\nM99\n"
)
options = st.fixed_dictionaries(
    {"max_blocks": st.just(MAX_BLOCKS), "max_cycles": st.integers(1, 4)},
    optional={
        "variables": st.dictionaries(st.sampled_from([100, 101, 500]), VALUES, max_size=3),
        "block_skip": st.sampled_from([(), (1,)]),
        "inputs": st.just({"operator": ["start", "start", "stop"]}),
    },
)


def state(machine: cncsub.Machine) -> dict[str, Any]:
    """Return all that can be read of a machine but its tables."""
    return {
        "stop": machine.stop,
        "alarm": str(machine.alarm),
        "waiting": machine.waiting_for,
        "stack": [str(frame) for frame in machine.stack],
        "variables": dict(machine.variables),
        "main": dict(machine.variables.level(0)),
        "position": machine.position,
        "modal": machine.modal,
        "messages": machine.messages,
        "m": machine.m_codes,
        "t": machine.t_codes,
        "next": repr(machine),
    }


def tables(machine: cncsub.Machine | cncsub.Run) -> tuple[list[Any], list[Any], list[Any]]:
    return list(machine.steps), list(machine.calls), list(machine.moves)


class Hands(RuleBasedStateMachine):
    """Several machines on one library, each with the state that it showed at its last action."""

    machines = Bundle("machines")

    def __init__(self) -> None:
        super().__init__()
        self.seen: list[tuple[cncsub.Machine, dict[str, Any], list[Any]]] = []

    @initialize(target=machines, text=texts, control=st.sampled_from(CONTROLS), how=options)
    def begin(self, text: str, control: str, how: dict[str, Any]) -> cncsub.Machine:
        if control == "gsk-928te":
            how.pop("variables", None)
        self.control = control
        self.library = cncsub.loads(text, control=control)
        self.how = how
        return self.touched(self.library.machine(**how))

    def touched(self, machine: cncsub.Machine) -> cncsub.Machine:
        self.seen = [entry for entry in self.seen if entry[0] is not machine]
        self.seen.append((machine, state(machine), list(machine.steps)))
        return machine

    def steps_of(self, machine: cncsub.Machine) -> list[Any]:
        return next(steps for known, _, steps in self.seen if known is machine)

    @rule(target=machines)
    def another(self) -> cncsub.Machine:
        return self.touched(self.library.machine(**self.how))

    @rule(machine=machines, count=st.integers(1, 12))
    def step(self, machine: cncsub.Machine, count: int) -> None:
        for _ in range(count):
            before, stopped = len(machine.steps), machine.stop
            step = machine.step()
            assert (step is None) == (len(machine.steps) == before)
            if step is None:
                assert machine.stop is not None
            else:
                assert stopped is None
                assert step == machine.steps[before]
                assert step.step == before
        self.touched(machine)

    @rule(target=machines, machine=machines, by=st.sampled_from(["copy", "__copy__"]))
    def duplicate(self, machine: cncsub.Machine, by: str) -> cncsub.Machine:
        twin = machine.copy() if by == "copy" else copy.copy(machine)
        assert state(twin) == state(machine)
        assert tables(twin) == tables(machine)
        return self.touched(twin)

    @rule(machine=machines)
    def a_copy_runs_on_as_the_machine_does(self, machine: cncsub.Machine) -> None:
        stepped, run, other = machine.copy(), machine.copy(), machine.copy()
        while stepped.step() is not None:
            pass
        run.run()
        while other.stop is None:
            other.run(until=len(other.stack) - 1)
            other.step()
        assert state(stepped) == state(run) == state(other)
        assert tables(stepped) == tables(run) == tables(other)

    @rule(machine=machines, number=NUMBERS, value=VALUES)
    def set_variable(self, machine: cncsub.Machine, number: int, value: float | None) -> None:
        try:
            machine.variables[number] = value
        except KeyError:
            return  # the control has no such variable
        if machine.variables[number] is None and self.control == "hnc-21m" and number >= 200:
            return  # a local variable of a level that is not open
        assert machine.variables[number] == value
        assert (number in machine.variables) == (value is not None)
        self.touched(machine)

    @rule(machine=machines)
    def reset(self, machine: cncsub.Machine) -> None:
        steps = list(machine.steps)
        machine.reset()
        assert machine.stop is None
        assert machine.alarm is None
        assert machine.stack == ()
        assert list(machine.steps) == steps
        self.touched(machine)

    @rule(machine=machines, number=st.sampled_from([10, 20]), name=st.sampled_from(["O1", "O2"]))
    def run_until(self, machine: cncsub.Machine, number: int, name: str) -> None:
        try:
            run = machine.run(until=(name, number))
        except KeyError:
            return  # no such block
        if run is None:
            assert machine.stop is None
            assert f"next block {name} N{number}" in repr(machine)
        else:
            assert run.stop is machine.stop
        self.touched(machine)

    @rule(machine=machines)
    def run_on(self, machine: cncsub.Machine) -> None:
        run = machine.run()
        assert run is not None
        assert run.stop is machine.stop
        assert tables(run) == tables(machine)
        assert machine.step() is None
        self.touched(machine)

    @precondition(lambda self: bool(self.seen))
    @rule(count=st.integers(0, MAX_BLOCKS))
    def n_steps_are_a_run_of_n_blocks(self, count: int) -> None:
        machine = self.library.machine(**self.how)
        for _ in range(count):
            machine.step()
        run = self.library.run(**{**self.how, "max_blocks": min(count, MAX_BLOCKS)})
        assert list(run.steps) == list(machine.steps)
        if machine.stop is None:
            assert run.stop is cncsub.Stop.LIMIT
            assert run.position == machine.position
            assert run.modal == machine.modal
            assert list(run.moves) == list(machine.moves)
            assert dict(run.variables) == dict(machine.variables.level(0))

    @rule(first=machines, second=machines)
    def two_machines_share_nothing(self, first: cncsub.Machine, second: cncsub.Machine) -> None:
        if first is not second:
            before = state(second), tables(second)
            first.step()
            self.touched(first)
            assert (state(second), tables(second)) == before

    @invariant()
    def what_nobody_touched_is_as_it_was(self) -> None:
        for machine, shown, steps in self.seen:
            assert state(machine) == shown
            assert machine.steps[: len(steps)] == steps

    @invariant()
    def tables_agree_with_the_machine(self) -> None:
        for machine, _, _ in self.seen:
            steps, calls, moves = tables(machine)
            assert len(steps) <= MAX_BLOCKS
            assert machine.steps.n.tolist() == [-1 if s.n is None else s.n for s in steps]
            assert [s.step for s in steps] == list(range(len(steps)))
            assert all(-1 <= s.frame < len(calls) for s in steps)
            for step in steps:
                if step.frame >= 0:
                    assert calls[step.frame].program == step.program
                    assert step.repeat <= calls[step.frame].repeats or step.repeat == 1
            for call in calls:
                assert call.first_step == call.caller_step + 1
                assert call.parent is None or call.parent < call.call
            assert [m.move for m in moves] == list(range(len(moves)))
            assert all(0 <= m.step < len(steps) for m in moves)
            assert len(machine.stack) <= len(calls)
            for frame in machine.stack:
                assert 1 <= frame.repeat <= frame.repeats


TestHands = Hands.TestCase
TestHands.settings = settings(
    stateful_step_count=15, max_examples=settings.default.max_examples // 4, deadline=None
)
