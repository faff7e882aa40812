"""Going back is having gone less far: the state of every step can be seen again, and what runs on
from there runs as it did.
"""

from __future__ import annotations

from typing import Any

from hypothesis import given
from hypothesis import strategies as st
from test_state_machine import CONTROLS, options, state, tables, texts

import cncsub

SINUMERIK = [
    "R1=R1+1", "R2=R1*2", "X=R1", "G0 X5 Y=R2", "G1 Z-2 F100", "SUB", "SUB P2", "SUB(3)", "M3 S500",
    "IF R1>3 GOTOF LAST", "WHILE R1<3", "ENDWHILE", "FOR R3=1 TO 3", "ENDFOR", "G91", "G90", "T2",
    "MCALL SUB", "MCALL", "N10 R1=R1+1", "REPEAT FIRST P2", "FIRST: R4=R4+1", "M30", "TRANS X10",
    "IF R1==2", "ELSE", "ENDIF", "GOTOB FIRST", "X=1/0", "R[R1]=5", "DEF INT COUNT=2",
]  # fmt: skip
LINUXCNC = [
    "#1=[#1+1]", "#100=[#100+#1]", "G0 X[#100]", "G1 Z-2 F100", "o100 call", "o100 call [2]",
    "o1 while [#100 lt 3]", "o1 endwhile", "o2 if [#100 gt 2]", "o2 endif", "M3 S500", "G91", "G90",
    "#<_count>=[#100]", "o3 repeat [2]", "o3 endrepeat", "M2", "G0 X[1/0]", "T2 M6",
]  # fmt: skip


def bodies(blocks: list[str]) -> st.SearchStrategy[str]:
    return st.lists(st.sampled_from(blocks), min_size=1, max_size=9).map("\n".join)


of_sinumerik = st.tuples(bodies(SINUMERIK), bodies(SINUMERIK)).map(
    lambda b: {"MAIN.MPF": f"{b[0]}\nLAST: M30\n", "SUB.SPF": f"PROC SUB(REAL A)\n{b[1]}\nM17\n"}
)
of_linuxcnc = st.tuples(bodies(LINUXCNC), bodies(LINUXCNC)).map(
    lambda b: f"o100 sub\n{b[1]}\no100 endsub\n{b[0]}\nM2\n"
)
programs = st.one_of(
    st.tuples(texts, st.sampled_from(CONTROLS)),
    st.tuples(of_sinumerik, st.sampled_from(["siemens-one", "siemens-840d-sl"])),
    st.tuples(of_linuxcnc, st.just("linuxcnc")),
)


def shown(machine: cncsub.Machine) -> tuple[Any, ...]:
    following = machine.next
    return (
        state(machine),
        tables(machine),
        None if following is None else (following.program.name, following.line),
        machine.variables.named,
        machine.blocks,
        list(machine.codes),
        list(machine.watch),
    )


def begun(program: tuple[Any, str], how: dict[str, Any]) -> cncsub.Machine:
    text, control = program
    how = dict(how)
    if control not in CONTROLS or control == "gsk-928te":
        how.pop("variables", None)
    if control in CONTROLS and control != "gsk-928te":
        how["watch"] = [1, 100]
    return cncsub.loads(text, control=control).machine(**how)


@given(program=programs, how=options, data=st.data())
def test_forward_and_back_is_less_far_forward(
    program: tuple[Any, str], how: dict[str, Any], data: st.DataObject
) -> None:
    machine = begun(program, how)
    seen = [shown(machine)]
    while machine.step() is not None:
        seen.append(shown(machine))
    end = machine.copy()
    for _ in range(4):
        to = data.draw(st.integers(0, machine.blocks))
        if to == machine.blocks and to > 0 and data.draw(st.booleans()):
            to -= 1
            machine.back()
        else:
            machine.back(to)
        if to < end.blocks:
            assert shown(machine) == seen[to]
        for _ in range(data.draw(st.integers(0, 5))):
            machine.step()
            if machine.blocks < end.blocks:
                assert shown(machine) == seen[machine.blocks]
    for _ in machine:
        pass
    assert shown(machine) == shown(end)
    assert shown(machine.copy()) == shown(end)


@given(program=programs, how=options, data=st.data())
def test_runs_and_steps_go_back_alike(
    program: tuple[Any, str], how: dict[str, Any], data: st.DataObject
) -> None:
    machine = begun(program, how)
    seen = [shown(machine)]
    for _ in machine:
        seen.append(shown(machine))
    run = begun(program, how)
    run.run()
    to = data.draw(st.integers(0, max(0, run.blocks - 1)))
    run.back(to)
    if to < len(seen) - 1:
        assert shown(run) == seen[to]


@given(
    program=st.tuples(texts, st.sampled_from(CONTROLS)),
    edits=st.lists(
        st.tuples(st.integers(0, 6), st.sampled_from([1, 2, 100, 101, 500]), st.integers(-3, 9)),
        min_size=1,
        max_size=6,
    ),
    data=st.data(),
)
def test_what_was_set_on_the_way_is_set_again(
    program: tuple[Any, str], edits: list[tuple[int, int, int]], data: st.DataObject
) -> None:
    machine = begun(program, {"max_blocks": 60})
    seen = [shown(machine)]
    for steps, number, value in edits:
        for _ in range(steps):
            if machine.step() is not None:
                seen.append(shown(machine))
        try:
            machine.variables[number] = value
        except KeyError:
            continue
        seen[-1] = shown(machine)
    if machine.stop is not None:
        return  # what was set after the end counts at the end alone
    to = data.draw(st.integers(0, machine.blocks))
    machine.back(to)
    assert shown(machine) == seen[to]


# Jumps over blocks, into and out of loops, branches, repeats and parts, after alarms and ends.
@given(
    program=programs,
    jumps=st.lists(st.tuples(st.integers(0, 6), st.integers(0, 12)), min_size=1, max_size=4),
    data=st.data(),
)
def test_a_next_block_that_was_set_is_set_again(
    program: tuple[Any, str], jumps: list[tuple[int, int]], data: st.DataObject
) -> None:
    machine = begun(program, {"max_blocks": 60})
    seen = [shown(machine)]
    for steps, line in jumps:
        for _ in range(steps):
            if machine.step() is not None:
                seen.append(shown(machine))
        before = shown(machine)
        running = machine.core.code.place_of(machine.core.address)[0]
        addresses = [a for a in machine.core.blocks_at(running) if a >= 0]
        if not addresses:
            continue
        to = addresses[line % len(addresses)]
        try:
            machine.core.set_next_block(to)
        except ValueError:
            assert shown(machine) == before
            continue
        assert machine.core.address == to
        assert machine.alarm is None
        seen[machine.blocks :] = [shown(machine)]
    while machine.step() is not None:
        seen.append(shown(machine))
    to_step = data.draw(st.integers(0, max(0, min(machine.blocks, len(seen)) - 1)))
    machine.back(to_step)
    assert shown(machine) == seen[to_step]
