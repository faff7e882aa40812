"""Blocks typed in MDI in the middle of a run: they are executed in the present state, the run goes on
as it would have, and going back goes over them.
"""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from test_going_back import begun, programs, shown

import cncsub
from cncsub.debugging import PausePoint, Reason, Session
from cncsub.machine import type_in

CONTROL = "fanuc-0i-f"
PART = """O1
N10 G91 G0 X5.
N20 #1=3
N30 G65 P2 A7.
N40 X#1
N50 M30
O2
N110 X#1
N120 M98 P3
N130 #1=#1+1
N140 M99
O3
N210 Z-#1
N220 M99
"""


def part() -> cncsub.Machine:
    return cncsub.loads({"part.nc": PART}, control=CONTROL).machine()


def test_a_typed_block_is_executed_in_the_present_state_and_the_run_goes_on() -> None:
    machine = part()
    machine.run(until="O2:N130")
    machine.mdi("X1.")  # incremental, as the program is
    machine.mdi("#1=20")  # the local of the macro
    assert (machine.position["X"], machine.position["Z"]) == (13, -7)
    assert machine.variables.level(0)[1] == 3
    assert machine.next is not None
    assert (machine.next.n, len(machine.stack)) == (130, 1)
    machine.run(until="O2:N140")
    assert machine.variables[1] == 21
    run = machine.run()
    assert run is not None
    assert (run.stop, run.position["X"]) == (cncsub.Stop.END, 16)
    told = [(step.program, step.n) for step in run.steps]
    assert told[7:10] == [("MDI", None), ("MDI", None), ("O2", 130)]
    assert [(call.program, call.kind) for call in run.calls][2:] == [("MDI", "MDI"), ("MDI", "MDI")]


def test_a_typed_call_runs_what_it_calls_and_comes_back() -> None:
    machine = part()
    machine.run(until="O1:N30")
    machine.mdi("M98 P3\nG65 P2 A1.")
    assert (machine.position["X"], machine.position["Z"]) == (6, -4)
    assert machine.variables[1] == 3
    assert machine.stack == ()
    assert machine.next is not None
    assert machine.next.n == 30


def test_going_back_goes_over_typed_blocks_and_forward_again_executes_them() -> None:
    machine = part()
    machine.run(until="O1:N30")
    machine.mdi("#1=20\nX#1")
    machine.run(until="O1:N40")
    end = shown(machine)
    blocks = machine.blocks
    machine.back(3)  # after the first of the two
    assert machine.next is not None
    assert (machine.next.text, machine.variables[1]) == ("X#1", 20)
    assert [frame.kind for frame in machine.stack] == ["MDI"]
    machine.run(until="O1:N40")
    assert shown(machine) == end
    machine.back(4)  # after both
    assert (machine.next.text, machine.stack) == ("N30 G65 P2 A7.", ())
    machine.back("#1")
    assert (machine.blocks, machine.variables[1]) == (2, 3)  # before what was typed, which is gone
    machine.run(until="O1:N40")
    assert machine.blocks == blocks - 2


def test_what_is_set_after_a_step_back_comes_again_after_another_one() -> None:
    machine = cncsub.loads("O1\nN10 #1=#1+1\nN20 GOTO10\n", control=CONTROL).machine()
    machine.run(until=cncsub.Breakpoint("O1:N10", when="#1 EQ 100"))
    machine.variables[500] = 1
    machine.run(until=cncsub.Breakpoint("O1:N10", when="#1 EQ 5000"))
    machine.variables[501] = 2
    machine.run(until=cncsub.Breakpoint("O1:N10", when="#1 EQ 6000"))
    machine.back(8000)  # between the two: snapshots near it are kept
    machine.run(until=cncsub.Breakpoint("O1:N10", when="#1 EQ 4100"))
    machine.variables[502] = 3
    machine.run(until=cncsub.Breakpoint("O1:N10", when="#1 EQ 4500"))
    machine.back(machine.blocks - 1)
    held = machine.variables
    assert (held[500], held[501], held[502]) == (1, None, 3)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("", "no block was typed"),
        ("G1 XX", "mdi: "),
        ("#100=[1", "mdi: "),
        ("O5\nX1.\nM99", "a program with a head"),
    ],
)
def test_what_is_no_block_is_refused_and_nothing_is_executed(text: str, told: str) -> None:
    machine = part()
    machine.run(until="O1:N30")
    before = shown(machine)
    with pytest.raises(ValueError, match=told):
        machine.mdi(text)
    assert shown(machine) == before
    with pytest.raises(TypeError):
        machine.mdi(5)  # type: ignore[arg-type]


def test_nothing_is_typed_after_the_end() -> None:
    machine = part()
    machine.run()
    with pytest.raises(ValueError, match="the program has ended"):
        machine.mdi("X1.")


def test_an_alarm_in_a_typed_block_stops_there_and_the_next_text_takes_its_place() -> None:
    machine = part()
    machine.run(until="O1:N30")
    machine.mdi("X[1/0]")
    assert machine.alarm is not None
    assert (machine.alarm.program, machine.alarm.cause) == ("MDI", "division-by-zero")
    machine.mdi("X1.")
    assert machine.alarm is None
    assert (machine.position["X"], machine.stack) == (6, ())
    machine.back(machine.blocks)
    machine.mdi("X[1/0]")
    machine.back(machine.blocks)  # takes the alarm away, and what was typed with it
    assert (machine.alarm, machine.stack) == (None, ())
    assert machine.next is not None
    assert machine.next.n == 30


def test_the_rules_of_mdi_hold_for_what_is_typed() -> None:
    text = "O1\nN10 G0 X5.\nN20 M30\nO2\nN30 M98 P3\nN40 M99\nO3\nN50 M99\n"
    refusing = cncsub.loads(text, control="gsk-988t").machine()
    refusing.step()
    refusing.mdi("M98 P3")
    assert refusing.alarm is not None
    assert refusing.alarm.cause == "call-in-mdi"
    one_level = cncsub.loads(text, control="gsk-988ta").machine()
    one_level.step()
    one_level.mdi("M98 P3")
    assert one_level.alarm is None
    one_level.mdi("M98 P2")
    assert one_level.alarm is not None
    assert (one_level.alarm.cause, one_level.alarm.program) == ("call-in-mdi", "O2")


def test_a_nesting_that_the_control_just_allows_holds_for_a_typed_call() -> None:
    deepest = cncsub.controls[CONTROL].replace(max_nesting=2)
    text = "O1\nN10 M98 P2\nN20 M30\nO2\nN30 #1=1\nN40 M99\nO3\nN50 M99\n"
    machine = cncsub.loads(text, control=deepest).machine()
    machine.run(until="O2:N30")
    machine.mdi("M98 P3")
    assert machine.alarm is None


def test_names_that_no_program_has_are_made_by_typed_blocks() -> None:
    text = "o100 sub\n#1=5\n#<a>=[#1+1]\no100 endsub\n#<_g>=3\no100 call [7]\n#<b>=2\nM2\n"
    machine = cncsub.loads(text, control="linuxcnc").machine()
    machine.step()
    with pytest.raises(ValueError, match="passes over a subprogram"):
        machine.mdi("#1=1")
    with pytest.raises(ValueError, match="#<a> has no value"):
        machine.evaluate("#<a>")
    while not (machine.stack and machine.next is not None and machine.next.text == "o100 endsub"):
        machine.step()
    assert machine.evaluate("exists[#<new>]") == 0
    machine.mdi("#<new>=4\n#<_more>=9")
    assert [machine.evaluate(name) for name in ("#<new>", "#<a>", "#<_g>", "#<_more>")] == [
        4, 6, 3, 9,
    ]  # fmt: skip
    machine.step()
    assert machine.evaluate("exists[#<new>]") == 0  # it was a local of the subprogram
    assert machine.evaluate("#<_more>") == 9
    machine.back(2)
    assert machine.evaluate("exists[#<_more>]") == 0
    assert machine.run() is not None
    assert machine.alarm is None


def test_texts_of_typed_blocks_are_the_same_texts_as_those_of_the_run() -> None:
    text = 'DEF STRING[20] NAME="AB"\nDEF STRING[20] OTHER\nN10 NAME="C"<<5\nN20 OTHER=NAME<<"X"\nN30 R1=OTHER=="C5X"\nM30\n'
    machine = cncsub.loads(text, control="siemens-one").machine()
    machine.run(until="MAIN:N20")
    assert machine.evaluate('NAME=="C5"') == 1  # a text that stands in no program
    assert machine.evaluate('NAME=="C6"') == 0
    assert machine.evaluate('NAME<<"!"') == "C5!"
    machine.mdi('MSG("C5")\nR2=STRLEN("NEW TEXT")')
    assert machine.messages == ["C5"]
    assert machine.evaluate("R2") == 8
    assert machine.evaluate('NAME=="C5"') == 1
    machine.back(2)
    machine.run(until="MAIN:N30")
    assert machine.variables.named == {"NAME": "C5", "OTHER": "C5X"}
    machine.run()
    assert machine.variables[1] == 1


def test_a_variable_is_not_defined_by_a_typed_block() -> None:
    machine = cncsub.loads("N10 R1=1\nN20 M30\n", control="siemens-one").machine()
    machine.step()
    with pytest.raises(ValueError, match="cannot be defined here"):
        machine.mdi("DEF INT COUNT=1")


def test_blocks_and_breakpoints_of_the_library_hold_after_a_typed_block() -> None:
    library = cncsub.loads({"part.nc": PART}, control=CONTROL)
    machine = library.machine()
    machine.run(until="O1:N30")
    seen = machine.next
    machine.mdi("#2=1")
    machine.run(until=library["O2"].blocks[2])
    assert machine.next is not None
    assert machine.next.n == 130
    assert seen is not None
    machine.back(seen)
    assert machine.next.n == 30
    other = cncsub.loads({"part.nc": PART}, control=CONTROL)
    with pytest.raises(ValueError, match="a block of another library"):
        machine.run(until=other["O2"].blocks[2])


def test_a_session_pauses_in_what_a_typed_block_calls() -> None:
    session = Session(cncsub.loads({"part.nc": PART}, control=CONTROL))
    session.set_points("lines", [PausePoint("O3:N210")])
    session.into()
    session.into()
    pause = session.mdi("#1=4\nM98 P3")
    assert (pause.reason, pause.text) == (Reason.BREAKPOINT, "breakpoint O3:N210")
    frames = session.frames()
    assert [(frame.program, frame.kind) for frame in frames] == [
        ("O3", "M98"), ("MDI", "MDI"), ("O1", ""),
    ]  # fmt: skip
    assert [frame.block.text for frame in frames if frame.block is not None] == [
        "N210 Z-#1", "M98 P3", "N30 G65 P2 A7.",
    ]  # fmt: skip
    assert session.out().reason is Reason.STEP
    assert [frame.program for frame in session.frames()] == ["O1"]
    assert session.machine.position["Z"] == -4
    for _ in range(9):
        session.back()
    assert session.machine.blocks == 0
    assert [frame.program for frame in session.frames()] == ["O1"]


TYPED = [
    "#1=9", "#100=#1+1", "G0 X7.", "G91", "M98 P2", "G65 P2 A3.", "X[1/0]", "R1=R1+2", "#<_q>=1",
    "o100 call", "SUB", "M3 S100\nG0 Y1", "S=5", "", "M99", "M30", "G66 P2 A1.", "#<new>=[#1+1]",
]  # fmt: skip


@given(
    program=programs,
    typed=st.lists(st.tuples(st.integers(0, 6), st.sampled_from(TYPED)), min_size=1, max_size=4),
    data=st.data(),
)
def test_what_was_typed_is_typed_again(
    program: tuple[Any, str], typed: list[tuple[int, str]], data: st.DataObject
) -> None:
    machine = begun(program, {"max_blocks": 60})
    seen = [shown(machine)]

    def go(steps: int) -> None:
        while steps > 0 and machine.step() is not None:
            seen.append(shown(machine))
            steps -= 1

    for steps, text in typed:
        go(steps)
        before = shown(machine)
        try:
            type_in(machine.core, text)
        except ValueError:
            assert shown(machine) == before
    go(200)
    if machine.stop is None:
        return
    end = shown(machine)
    to = data.draw(st.integers(0, max(0, min(machine.blocks, len(seen)) - 1)))
    copy = machine.copy()
    machine.back(to)
    if to < len(seen) - 1:
        assert shown(machine)[1:] == seen[to][1:]
    assert shown(copy) == end
