"""`machine.goto`: another block becomes the next one, and nothing is executed."""

from __future__ import annotations

from typing import Any

import pytest

import cncsub

FANUC = "fanuc-0i-f"
LOOPS = """O1
N10 #1=0
N20 WHILE[#1 LT 2]DO1
N30 #2=0
N40 WHILE[#2 LT 2]DO2
N50 #2=#2+1
N60 #100=#100+1
N70 END2
N80 #1=#1+1
N90 END1
N95 M98 P2
N99 M30
O2
N10 #101=1
N20 M99
"""
BRANCHES = """#100=0
o1 if [#100 eq 0]
  #101=1
o1 else
  #101=2
o1 endif
o2 repeat [3]
  #102=[#102+1]
o2 endrepeat
#103=1
o3 do
  #104=[#104+1]
o3 while [#104 lt 3]
#105=1
M2
"""


def at(machine: cncsub.Machine) -> Any:
    return None if machine.next is None else machine.next.n or machine.next.line


def refused(machine: cncsub.Machine, to: Any) -> str:
    before = (machine.next, machine.blocks, machine.stop, dict(machine.variables))
    with pytest.raises((KeyError, TypeError, ValueError)) as raised:
        machine.goto(to)
    assert (machine.next, machine.blocks, machine.stop, dict(machine.variables)) == before
    return str(raised.value.args[0])


def test_nothing_is_executed_and_the_state_stays() -> None:
    machine = cncsub.loads(LOOPS, control=FANUC).machine()
    machine.run(until="O1:N30")
    before = dict(machine.variables), dict(machine.modal), machine.blocks, len(machine.steps)
    machine.goto(("O1", 80))
    assert at(machine) == 80
    after = dict(machine.variables), dict(machine.modal), machine.blocks, len(machine.steps)
    assert after == before
    assert machine.step() is not None
    assert machine.variables[1] == 1
    assert [step.n for step in machine.steps] == [10, 20, 80]


@pytest.mark.parametrize("name", ["text", "pair", "line", "block"])
def test_a_block_is_given_as_breakpoints_are(name: str) -> None:
    library = cncsub.loads({"a.nc": LOOPS}, control=FANUC)
    block = next(block for block in library["O1"].blocks if block.n == 80)
    machine = library.machine()
    machine.goto({"text": "O1:N80", "pair": ("O1", 80), "line": "a.nc:9", "block": block}[name])
    assert at(machine) == 80


def test_loops_that_hold_the_block_stay_open_and_others_are_left() -> None:
    machine = cncsub.loads(LOOPS, control=FANUC).machine()
    machine.run(until="O1:N60")
    machine.goto("O1:N80")  # out of DO2, inside DO1
    run = machine.run()
    assert run is not None
    assert run.alarm is None
    assert machine.variables[100] == 2  # one pass of the outer loop is left, with two inside


def test_a_loop_that_is_entered_in_its_middle_alarms_as_after_a_jump() -> None:
    jumped = cncsub.loads(LOOPS.replace("N20 WHILE", "N15 GOTO50\nN20 WHILE"), control=FANUC)
    machine = cncsub.loads(LOOPS, control=FANUC).machine()
    machine.goto("O1:N50")
    run = machine.run()
    assert run is not None
    assert run.alarm is not None
    expected = jumped.run().alarm
    assert expected is not None
    assert (run.alarm.cause, run.alarm.n) == (expected.cause, expected.n) == ("missing-do", 70)


def test_what_is_no_block_of_the_program_is_refused_by_name() -> None:
    library = cncsub.loads({"a.nc": LOOPS.replace("N99", "N10 G4 P1\nN99")}, control=FANUC)
    machine = library.machine()
    assert refused(machine, "O2:N20") == ("line 16 is a block of O2; the program that runs is O1")
    assert refused(machine, "O1:N11").startswith("no block N11 in O1; near it are")
    assert refused(machine, "O9:N10").startswith("no program O9 in the memory")
    assert refused(machine, "a.nc:99").startswith("no block on line 99 of a.nc")
    assert refused(machine, "O1:N10") == (
        "'O1:N10' stands on the lines 2, 12: give one, such as 'job.nc:12'"
    )
    assert refused(machine, "alarm").startswith("'alarm' is an event; a block is given as")
    assert refused(machine, 5).startswith("a block is given as a Block, a program and a")
    other = cncsub.loads(LOOPS, control=FANUC)["O1"].blocks[0]
    assert refused(machine, other).endswith("is a block of another library")
    machine.run(until="O2:N10")
    assert refused(machine, "O1:N20") == "line 3 is a block of O1; the program that runs is O2"
    machine.goto("O2:N20")
    machine.run(until="O1:N99")
    assert machine.variables[101] is None


def test_a_program_that_has_ended_goes_nowhere() -> None:
    machine = cncsub.loads(LOOPS, control=FANUC).machine()
    machine.run()
    assert refused(machine, "O1:N10").startswith("the program has ended: go back, or reset")
    machine.reset()
    machine.goto("O1:N95")
    assert at(machine) == 95
    short = cncsub.loads(LOOPS, control=FANUC).machine(max_blocks=3)
    short.run()
    assert refused(short, "O1:N95").startswith("the run has reached a limit of blocks")
    short.back(3)
    assert at(short) == 40  # what was refused is not done on the way back


def test_an_alarm_is_left_and_its_calls_go_on() -> None:
    text = "O1\nN10 M98 P2\nN20 #101=1\nN30 M30\nO2\nN40 #100=1/0\nN50 #102=1\nN60 M99\n"
    machine = cncsub.loads(text, control=FANUC).machine()
    machine.run()
    assert machine.stop == "alarm"
    at_alarm = machine.blocks
    machine.goto("O2:N50")
    assert (machine.alarm, machine.stop, at(machine)) == (None, None, 50)
    run = machine.run()
    assert run is not None
    assert run.stop == "end"
    assert (machine.variables[101], machine.variables[102]) == (1, 1)
    assert machine.calls[0].last_step == 2
    machine.back(at_alarm + 1)
    assert (at(machine), machine.variables[102]) == (60, 1)
    machine.back(at_alarm)
    assert (machine.alarm, at(machine)) == (None, 50)
    machine.back()
    assert at(machine) == 10
    machine.run()
    assert machine.stop == "alarm"  # what was set after that place is forgotten


def test_a_program_that_waits_goes_on_elsewhere() -> None:
    text = "O1\nN10 IF[#500 EQ #0]GOTO10\nN20 #100=1\nN30 M30\n"
    machine = cncsub.loads(text, control=FANUC).machine()
    machine.run()
    assert machine.stop == "waiting"
    blocks = machine.blocks
    machine.goto("O1:N20")
    assert (machine.stop, machine.waiting_for, machine.blocks) == (None, "", blocks)
    machine.run()
    assert (machine.stop, machine.variables[100]) == ("end", 1)
    machine.back(blocks)
    assert (machine.stop, at(machine)) == (None, 20)


def test_what_breakpoints_met_is_found_again_behind_it() -> None:
    machine = cncsub.loads(LOOPS, control=FANUC).machine()
    machine.run(until="O1:N60")
    machine.goto("O1:N95")
    machine.run()
    machine.back("O2:N10")
    assert (at(machine), [frame.n for frame in machine.stack]) == (10, [95])
    machine.back("O1:N60")
    assert (at(machine), machine.variables[2]) == (95, 1)


# ---- O words, parts that are repeated, control structures ----


def o_words(until: int) -> cncsub.Machine:
    machine = cncsub.loads({"a.ngc": BRANCHES}, control="linuxcnc").machine()
    if until > 1:
        machine.run(until=f"a.ngc:{until}")
    assert machine.next is not None
    assert machine.next.line == until
    return machine


@pytest.mark.parametrize(
    ("from_line", "to", "head"), [(1, 3, 2), (3, 5, 2), (1, 8, 7), (10, 12, 11), (7, 8, 7)]
)
def test_a_branch_of_o_words_is_not_entered(from_line: int, to: int, head: int) -> None:
    assert refused(o_words(from_line), f"a.ngc:{to}") == (
        f"line {to} is inside the branch or the loop that begins on line {head}, and the program"
        " does not stand in it"
    )


def test_o_words_are_left_and_moved_in() -> None:
    machine = o_words(3)
    machine.goto("a.ngc:4")  # the else ends the branch that was entered
    machine.run(until="a.ngc:7")
    assert machine.variables[101] not in (1, 2)
    machine = o_words(12)
    machine.goto("a.ngc:13")
    machine.run(until="a.ngc:14")
    assert machine.variables[104] == 3


def test_the_count_of_a_repeat_that_is_left_is_forgotten() -> None:
    machine = o_words(8)
    machine.goto("a.ngc:1")
    machine.run(until="a.ngc:10")
    assert machine.variables[102] == 3  # not the two passes that were left
    machine.goto("a.ngc:7")
    machine.run(until="a.ngc:8")
    machine.goto("a.ngc:7")  # its own head: the next pass
    machine.run(until="a.ngc:10")
    assert machine.variables[102] == 5


def test_the_body_of_a_sub_is_its_own_program() -> None:
    text = "o100 sub\n#1=1\no1 if [#1 eq 1]\n#101=1\no1 endif\n#102=1\no100 endsub\no100 call\nM2\n"
    machine = cncsub.loads({"a.ngc": text}, control="linuxcnc").machine()
    assert "is a block of" in refused(machine, "a.ngc:2")
    machine.run(until="a.ngc:2")
    assert "is inside the branch or the loop that begins on line 3" in refused(machine, "a.ngc:4")
    machine.goto("a.ngc:6")
    machine.run()
    assert (machine.stop, machine.variables[102]) == ("end", 1)
    assert machine.variables[101] != 1


def test_a_part_that_is_repeated_is_not_left() -> None:
    text = "R1=0\nFIRST: R1=R1+1\nR2=R2+1\nLAST: R3=R3+1\nREPEAT FIRST LAST P2\nR4=1\nM30\n"
    machine = cncsub.loads({"a.mpf": text}, control="siemens-840d-sl").machine()
    machine.run(until="call")
    assert machine.next is not None
    assert machine.next.line == 2
    for line in (1, 5, 6):
        assert refused(machine, f"a.mpf:{line}") == (
            f"line {line} is outside the part that is repeated, which begins on line 2"
        )
    machine.goto("a.mpf:4")
    machine.run()
    assert [machine.variables[n] for n in (1, 2, 3, 4)] == [2, 2, 3, 1]


def test_a_control_that_refuses_jumps_in_compensation_refuses_this() -> None:
    text = "O1\nN10 G17 G90\nN15 G41 G1 X5. Y5. D1 F100\nN20 GOTO 30\nN30 X20.\nN40 M30\n"
    library = cncsub.loads(text, control="gsk-980mdi")
    alarm = library.run().alarm
    assert alarm is not None
    assert alarm.cause == "jump-in-offset"
    machine = library.machine()
    machine.goto("O1:N20")
    machine.goto("O1:N10")
    machine.run(until="O1:N20")
    assert refused(machine, "O1:N30") == "the control refuses a jump while the radius offset is on"
