"""Why a program had not ended: reported at a limit, and proven if possible."""

from __future__ import annotations

import json

import pytest

import cncsub
from cncsub.analysis.endless import Why

F, L = "fanuc-0i-f", "linuxcnc"


def why(text: str, control: str = F, blocks: int = 500, **how: object) -> cncsub.Endless:
    library = cncsub.loads(text, control=control)
    found = library.run(max_blocks=blocks, **how).endless  # type: ignore[arg-type]
    assert found is not None
    return found


@pytest.mark.parametrize(
    ("control", "text", "period", "lines"),
    [
        (F, "O1\nN10 GOTO10\n", 1, [2]),
        (F, "O1\nN10 #1=2\nN20 IF[#1EQ2]GOTO10\nM30\n", 2, [2, 3]),
        (F, "O1\n#1=0\nWHILE[1EQ1]DO1\n#1=#1+1\nIF[#1LT7]GOTO5\n#1=0\nN5 END1\nM30\n", 29, None),
        (F, "O1\nN10 M98 P2 L3\nGOTO10\nO2\nG0 X1.\nX2.\nM99\n", 11, [2, 5, 6, 7, 3]),
        (F, "O1\nN10 G65 P2 A1.\nGOTO10\nO2\n#2=#1\nM99\n", 4, [2, 5, 6, 3]),
        (F, "O1\nN10 M0\nGOTO10\n", 2, [2, 3]),
        (F, "O1\nG90 G1 F100\nN10 X1. Y2.\nX0 Y0\nG4 X1.\nGOTO10\n", 4, [3, 4, 5, 6]),
        (F, "O1\nG91 G1 F100\nN10 X1.\nX-1.\nGOTO10\n", 3, [3, 4, 5]),
        (F, "O1\nG41 D1 G1 X1. F9\nN10 X5.\nY5.\nX0\nY0\nGOTO10\n", 5, [3, 4, 5, 6, 7]),
        (F, "O1\n#3002=0\nN10 #1=0\nGOTO10\n", 2, [3, 4]),
        (F, "O1\n#1=#3012\nN10 #1=#1*1\nGOTO10\n", 2, [3, 4]),  # it read the clock before the loop
        (F, "O1\nM98 P2\nM30\nO2\nG0 X1.\nM99 L3\n", 2, [5, 6]),
        (F, "O1\nM98 P2 L2\nM30\nO2\nM98 P3 L2\nM99 L2\nO3\nM99\n", 4, [5, 8, 6]),
        (L, "o100 while [1]\n#1=2\no100 endwhile\nM2\n", 3, [1, 2, 3]),
    ],
)  # fmt: skip
def test_a_state_that_came_back_is_a_proven_loop(
    control: str, text: str, period: int, lines: list[int] | None
) -> None:
    found = why(text, control)
    assert (found.why, found.proven, found.period) == (Why.LOOP, True, period), found
    if lines is not None:
        assert [block.line for block in found.blocks] == lines


def test_a_loop_is_told_with_its_places() -> None:
    found = why("O1\nN10 M98 P2\nN20 GOTO10\nO2\nN30 #500=7\nM99\n")
    assert str(found) == (
        "an endless loop, proven: after 4 blocks the state is the same again; O1 N10, O2 N30, O2 line 6, O1 N20"
    )
    assert [block.text for block in found.blocks] == [
        "N10 M98 P2", "N30 #500=7", "M99", "N20 GOTO10",
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("control", "text", "changing"),
    [
        (F, "O1\nN10 #1=#1+1\nGOTO10\n", ("#1",)),
        (F, "O1\nG91\nN10 G0 X1.\nGOTO10\n", ("X",)),
        (F, "O1\nWHILE[1EQ1]DO1\n#500=#500+1\nEND1\nM30\n", ("#500",)),
        (F, "O1\nN10 #1=#3001\nGOTO10\n", ("#1", "what it reads from outside")),
        (F, "O1\nN10 #1=#3002\nG4 X1.\nGOTO10\n", ("#1",)),
        (L, "o100 while [1]\n#1=[#1+1]\no100 endwhile\nM2\n", ("#1",)),
    ],
)
def test_what_moves_away_is_only_long(control: str, text: str, changing: tuple[str, ...]) -> None:
    found = why(text, control)
    assert (found.why, found.proven, found.then) == (Why.LONG, False, None)
    assert found.changing == changing
    assert found.looked == 100_000


@pytest.mark.parametrize(
    ("text", "outside"),
    [
        ("O1\nN10 #1=#3012\nGOTO10\n", "#3012"),
        ("O1\nN10 #1=#3011\nGOTO10\n", "#3011"),
        ("O1\nN10 G0 X1.\nX0\nIF[#1000EQ0]GOTO10\nM30\n", "#1000"),
        ("O1\nN10 #1=#1032\nG0 X1.\nX0\nGOTO10\n", "#1032"),
        ("O1\nN10 G90 G31 X1. F9\nG0 X0\nGOTO10\n", "the skip signal"),
        ("O1\nN10 M98 P2 L2\nGOTO10\nO2\n#1=#3012\n#1=0\nM99\n", "#3012"),
    ],
)
def test_what_looks_outside_is_not_proven(text: str, outside: str) -> None:
    found = why(text)
    assert (found.why, found.proven, found.outside) == (Why.LONG, False, outside)
    assert found.period > 0
    assert f"except for {outside}, which it reads from outside; O1 N10" in str(found)


def test_a_program_that_starts_over_and_looks_outside_repeats_by_design() -> None:
    found = why("O1\nN10 #1=#3012\nN20 M99\n", max_cycles=10**9)
    assert (found.why, found.proven, found.outside) == (Why.REPEATS, False, "#3012")
    assert str(found) == (
        "it repeats by design at O1 N20; after 2 blocks the state is the same again, except for #3012,"
        " which it reads from outside; O1 N20"
    )


def test_a_time_that_is_read_is_a_part_of_the_state() -> None:
    # The dwell is the same in every pass, but #3002 goes on.
    assert not why("O1\nN10 #1=#3002*0\nG4 X1.\nGOTO10\n").proven
    assert why("O1\nN10 #1=#500*0\nG4 X1.\nGOTO10\n").proven


@pytest.mark.parametrize("ends", ["M30", "#3000=1(STOP)"])
def test_what_stops_soon_is_only_long(ends: str) -> None:
    found = why(f"O1\nN10 #1=#1+1\nIF[#1LT900]GOTO10\n{ends}\n")
    assert (found.why, found.then) == (Why.LONG, "end" if ends == "M30" else "alarm")
    assert 1000 < found.looked < 2000


def test_m99_of_the_main_program_repeats_by_design() -> None:
    found = why("O1\nN10 G90 G0 X1.\nN20 M99\n", max_cycles=10**9)
    assert (found.why, found.proven, found.period) == (Why.REPEATS, True, 2)
    assert str(found.blocks[0]) == "O1 N20"
    growing = why("O1\nN10 #500=#500+1\nN20 M99\n", max_cycles=10**9)
    assert (growing.why, growing.proven, growing.changing) == (Why.REPEATS, False, ("#500",))
    used_up = why("O1\nN10 X1.\nN20 M99\n", max_cycles=2)
    assert str(used_up) == "it repeats by design at O1 N20"
    assert used_up.looked == 0


def test_a_loop_in_a_main_program_that_started_over_is_a_loop() -> None:
    text = "O1\n#500=#500+1\nIF[#500GT3]GOTO10\nM99\nN10 #1=1\nN20 GOTO10\n"
    found = why(text, max_cycles=10**9)
    assert (found.why, found.proven, found.period) == (Why.LOOP, True, 2)


def test_what_waits_says_for_what() -> None:
    found = why("O1\nN10 IF[#1000EQ0]GOTO10\nM30\n")
    assert (found.why, found.waiting_for) == (Why.WAITING, "#1000")
    assert str(found) == "it waits for #1000 at O1 N10"
    operator = why("O1\nN10 M0\nM30\n", inputs={"operator": []})
    assert str(operator) == "it waits for cycle start after M00"


@pytest.mark.parametrize(
    "text", ["O1\nM30\n", "O1\nM98 P1\nM30\n", "O1\nM98 P2\nM30\nO2\nM98 P2\nM99\n"]
)
def test_what_ends_or_alarms_is_not_endless(text: str) -> None:
    # A program that calls itself is stopped by the nesting limit of the control.
    run = cncsub.loads(text, control=F).run(max_blocks=500)
    assert run.endless is None
    assert str(run) == repr(run)


def test_the_run_stays_what_it_is() -> None:
    run = cncsub.loads("O1\nN10 #1=#1+1\nN20 G91 G0 X1.\nGOTO10\n", control=F).run(max_blocks=500)
    before = (run.blocks, dict(run.variables), len(run.steps), len(run.moves), run.position)
    assert run.endless is run.endless
    assert before == (run.blocks, dict(run.variables), len(run.steps), len(run.moves), run.position)
    assert str(run).startswith("<Run: limit")
    assert "not proven to be endless" in str(run)


def test_inputs_that_are_left_are_a_part_of_the_state() -> None:
    text = "O1\nN10 G31 G91 X0 F9\nGOTO10\n"
    inputs = {"skips": [0.5] * 4}
    assert cncsub.loads(text, control=F).run(max_blocks=3, inputs=inputs).endless is not None


def test_streams_and_machines_tell_it_too() -> None:
    library = cncsub.loads("O1\nN5 M98 P2\nM30\nO2\nN10 #1=1\nN20 GOTO10\n", control=F)
    stream = library.stream(rows=100, max_blocks=1000)
    assert stream.endless is None  # the stream still runs
    for _ in stream:
        pass
    machine = library.machine(max_blocks=1000)
    machine.run()
    for found in (stream.endless, machine.endless, library.run(max_blocks=1000).endless):
        assert found is not None
        assert (found.why, found.period) == (Why.LOOP, 2)


def test_a_limit_of_time_is_looked_at_as_one_of_blocks() -> None:
    run = cncsub.loads("O1\nN10 GOTO10\n", control=F).run(
        max_seconds=0.05, max_blocks=10**12, trace="none"
    )
    assert run.stop is cncsub.Stop.LIMIT
    assert run.endless is not None
    assert run.endless.proven


def test_the_command_says_why(tmp_path, capsys) -> None:  # type: ignore[no-untyped-def]
    from cncsub.cli import app

    file = tmp_path / "a.nc"
    file.write_text("O1\nN10 GOTO10\n")
    for format in ("text", "json"):
        with pytest.raises(SystemExit) as left:
            app(["run", str(file), "-c", F, "--max-blocks", "50", "--format", format])
        assert left.value.code == 4
        out = capsys.readouterr().out
        if format == "text":
            assert "why: an endless loop, proven: after 1 block " in out
        else:
            facts = json.loads(out)["endless"]
            assert (facts["why"], facts["proven"], facts["blocks"][0]["n"]) == ("loop", True, 10)
