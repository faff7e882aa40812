"""A result of a run is a value: it does not change with the machine or by being looked at."""

from __future__ import annotations

import copy
import pickle
from pathlib import Path

import pytest

import cncsub

CONTROL = "fanuc-0i-f"
FAULTY = "O1\nN10 M98 P2\nN20 M30\nO2\nN30 G65 P9000 A1.\nN40 M99\n"
CALLS = "O1\nN10 M98 P2\nN20 M30\nO2\nN30 G0 X1.\nN40 G0 X2.\nN50 M99\n"


def test_the_run_of_a_machine_stays_what_it_was() -> None:
    machine = cncsub.loads("O1\nN10 #100=1/#500\nN20 M30\n", control=CONTROL).machine()
    run = machine.run()
    assert run is not None
    machine.reset()
    machine.variables[500] = 1
    second = machine.run()
    assert second is not None
    assert (run.stop, second.stop) == (cncsub.Stop.ALARM, cncsub.Stop.END)
    with pytest.raises(cncsub.AlarmError, match="division"):
        run.raise_for_alarm()


def test_an_alarm_is_a_value() -> None:
    library = cncsub.loads(FAULTY, control="fanuc-16i")
    alarm, again = library.run().alarm, library.run().alarm
    assert alarm is not None
    assert alarm == again
    assert alarm.frames == again.frames
    assert len({alarm, again}) == 1
    assert alarm != cncsub.loads("O1\nM98 P2\n", control="fanuc-16i").run().alarm
    for other in (pickle.loads(pickle.dumps(alarm)), copy.copy(alarm), copy.deepcopy(alarm)):
        assert other == alarm
        assert str(other) == str(alarm)


def test_an_alarm_comes_back_from_another_process() -> None:
    with pytest.raises(cncsub.AlarmError) as raised:
        cncsub.loads(FAULTY, control=CONTROL).run().raise_for_alarm()
    error = pickle.loads(pickle.dumps(raised.value))
    assert error.alarm == raised.value.alarm
    assert str(error) == str(raised.value)


def test_looking_at_a_run_does_not_change_it() -> None:
    run = cncsub.loads(CALLS, control=CONTROL).run()
    with pytest.raises(ValueError, match="read-only"):
        run.moves.x[0] = 9
    frame = run.steps.to_pandas()
    frame.loc[0, "line"] = 77
    assert run.steps.line[0] == run.steps[0].line == run.steps.to_pandas()["line"][0] == 2


def test_a_call_that_is_open_has_no_last_step() -> None:
    machine = cncsub.loads(CALLS, control=CONTROL).machine()
    for _ in range(2):
        machine.step()
    assert machine.calls[0].last_step is None
    machine.step()
    machine.reset()
    assert machine.calls[0].last_step == 2
    machine.run()
    assert [call.last_step for call in machine.calls] == [2, 6]


def test_a_call_that_is_open_at_the_end_ends_with_the_run() -> None:
    text = "O1\nN10 M98 P2\nO2\nN20 G0 X1.\nN30 M98 P3\nN40 M99\n"
    run = cncsub.loads(text, control=CONTROL).run()
    assert run.stop == cncsub.Stop.ALARM
    assert [call.last_step for call in run.calls] == [len(run.steps) - 1]


def test_all_variables_are_those_that_have_a_value() -> None:
    text = "O1\nN10 #1=1\nN20 #149=2\nN30 #501=3\nN40 #5221=4\nN50 M30\n"
    run = cncsub.loads(text, control=CONTROL).run(variables={100: None})
    assert dict(run.variables) == {1: 1, 149: 2, 501: 3}


def test_a_reset_leaves_the_loops() -> None:
    text = """
        O1
        N10 IF[#500 EQ 1]GOTO 40
        N20 #500=1
        N30 WHILE[1 EQ 1]DO1
        N40 M8
        N50 END1
    """
    machine = cncsub.loads(text, control=CONTROL).machine()
    machine.run(until=("O1", 50))
    machine.reset()
    machine.run()
    assert machine.alarm is not None
    assert machine.alarm.cause == "missing-do"


@pytest.mark.parametrize(
    ("machine", "word", "axes"),
    [
        ("mill", "X1.", "XYZ"), ("mill", "C1.", "XYZC"),
        ("lathe-a", "X1.", "XZ"), ("lathe-a", "Y1.", "XYZ"),
    ],
)  # fmt: skip
def test_a_position_has_the_axes_of_the_machine_and_those_that_moved(
    machine: str, word: str, axes: str
) -> None:
    library = cncsub.loads(f"O1\nN10 G0 {word}\nN20 M30\n", control=CONTROL)
    run = library.run(setup=cncsub.Setup(machine=machine))
    assert list(run.position) == list(axes)


# ---- copies, and other processes ----


def test_a_changed_control_comes_back_from_another_process() -> None:
    known = cncsub.controls[CONTROL]
    changed = known.with_parameters({"6050": 70, "6001#6": 1, "3410": 0.5}).replace(max_nesting=3)
    for control in (known, changed, changed.with_parameters({"6001#6": 0})):
        for other in (
            pickle.loads(pickle.dumps(control)), copy.copy(control), copy.deepcopy(control)
        ):  # fmt: skip
            assert other.name == control.name
            assert [(r.name, r.value, r.source) for r in other.rules] == [
                (r.name, r.value, r.source) for r in control.rules
            ]
            for name, parameter in control.parameters.items():
                assert other.parameters[name].value == parameter.value


def test_setup_and_inputs_are_values() -> None:
    setup = cncsub.Setup(start={"X": 1}, work_offsets={"G54": {"Z": 5}}, machine="lathe-a")
    inputs = cncsub.Inputs(signals={1000: 1}, operator=["start"], writes=[(2, {500: 1})])
    for value in (setup, inputs):
        assert pickle.loads(pickle.dumps(value)) == value
        assert copy.deepcopy(value) == copy.copy(value) == value


def test_a_library_comes_back_from_another_process(tmp_path: Path) -> None:
    (tmp_path / "O5.nc").write_bytes(b"N50 M99 (\xb9\xa4)\r\n")
    control = cncsub.controls[CONTROL].replace(max_nesting=3)
    library = cncsub.loads(
        CALLS.replace("G0 X1.", "M198 P5"), control=control, external=tmp_path, name="job/A.NC"
    )
    other = pickle.loads(pickle.dumps(library))
    assert repr(other) == repr(library)
    assert [p.text for p in other.values()] == [p.text for p in library.values()]
    assert (other.files, other.skipped) == (library.files, library.skipped)
    assert list(other.external) == ["O5"]
    assert {r.name: r.value for r in other.control.rules}["max_nesting"] == 3
    assert (
        other.run().steps.n.tolist() == library.run().steps.n.tolist() == [10, 30, 50, 40, 50, 20]
    )
    assert copy.copy(library) is copy.deepcopy(library) is library


def test_what_stays_in_its_process_says_so() -> None:
    library = cncsub.loads(CALLS, control=CONTROL)
    run = library.run()
    stream = library.stream(rows=1)
    staying = [
        run, library.machine(), stream, next(stream), run.steps, run.calls, run.moves,
        run.variables, library.main, library["O1"].blocks, library["O1"].blocks[0],
        library.flatten(), run.coverage(),
    ]  # fmt: skip
    for value in staying:
        with pytest.raises(TypeError, match="cannot be sent to another process; send"):
            pickle.dumps(value)


def test_a_run_is_its_own_copy_and_a_machine_goes_its_own_way() -> None:
    library = cncsub.loads(CALLS, control=CONTROL)
    run = library.run()
    assert copy.copy(run) is copy.deepcopy(run) is run
    machine = library.machine()
    machine.step()
    for twin in (copy.copy(machine), copy.deepcopy(machine), machine.copy()):
        twin.run()
        assert (machine.stop, twin.stop) == (None, "end")
        assert (machine.blocks, twin.blocks) == (1, 5)
    stream = library.stream(rows=2)
    next(stream)
    for other in (copy.copy(stream), copy.deepcopy(stream)):
        assert [step.n for part in other for step in part.steps] == [40, 50, 20]
        assert (stream.blocks, other.blocks) == (2, 5)


def test_what_a_control_is_made_of_prints_itself() -> None:
    control = cncsub.controls[CONTROL]
    assert repr(control.parameters["3410"]).startswith("<Parameter 3410 = 0: how much the radius")
    assert repr(control.alarms["program-not-found"]) == "<AlarmEntry PS0076 program-not-found>"
    semicolon = next(rule for rule in control.rules if rule.name == "semicolon")
    assert repr(semicolon) == "<Rule semicolon = 'end-of-block'>"


# ---- mappings ----


def test_the_variables_are_a_mapping_of_those_that_hold_a_value() -> None:
    machine = cncsub.loads("O1\n#1=1\n#5221=7\nM30\n", control=CONTROL).machine()
    machine.run()
    variables = machine.variables
    assert variables.setdefault(100, 5) == variables.setdefault(100, 6) == 5
    variables.update({101: 1, 102: None})
    assert dict(variables) == variables == {1: 1, 100: 5, 101: 1}
    assert (102 in variables, variables[102], variables.get(102), variables.get(102, 9)) == (
        False, None, None, 9,
    )  # fmt: skip
    assert variables.pop(100) == 5
    assert variables.pop(100, 8) == variables.pop(9_999_999, 8) == 8
    for number in (100, 9_999_999, "100", 10**30):
        for take in (variables.pop, variables.__delitem__):
            with pytest.raises(KeyError):
                take(number)  # type: ignore[operator]
    assert variables.popitem() == (1, 1.0)
    del variables[101]
    assert dict(variables) == {}
    with pytest.raises(KeyError, match="no variable has a value"):
        variables.popitem()


def test_the_control_keeps_its_own_variables() -> None:
    library = cncsub.loads("O1\nM30\n", control=CONTROL)
    machine = library.machine()
    variables = machine.variables
    variables.update({3901: 4, 100: 1, 5221: 7})
    assert dict(variables) == {3901: 4, 100: 1}
    variables.clear()
    assert dict(variables) == {3901: 4}
    assert variables[5221] == 7
    for number in (3901, 5221):
        with pytest.raises(KeyError, match="always has a value"):
            del variables[number]
    with pytest.raises(KeyError, match="no variable has a value that can be removed"):
        variables.popitem()


def test_bounds_are_found_by_either_letter() -> None:
    bounds = cncsub.loads(CALLS, control=CONTROL).run().moves.bounds
    assert list(bounds) == ["X"]
    assert "x" in bounds
    assert "X" in bounds
    assert "y" not in bounds
    assert 1 not in bounds  # type: ignore[comparison-overlap]
    assert bounds.get("x") == bounds["x"] == bounds["X"] == (1, 2)
    assert bounds.get("y") is None
    assert bounds.get("y", 0) == 0
    with pytest.raises(KeyError, match="no move has the axis 'y'; there are X"):
        bounds["y"]


@pytest.mark.parametrize(
    ("control", "text"),
    [
        ("fanuc-30i", "#100=#[#1*100]"),
        ("fanuc-16i", "#100=1+#[#1*100]"),
        ("gsk-988ta", "G1 X#[#1*100] F100"),
        ("gsk-980mdi", "IF[#[#1*100] GT 1]GOTO 5"),
        ("mitsubishi-m700", "#100=#5000"),
    ],
)
def test_a_variable_that_is_not_there_is_named(control: str, text: str) -> None:
    program = f"O1\n#1=50\n{text}\nN5 M30\n"
    alarm = cncsub.loads(program, control=control).run().alarm
    assert alarm is not None
    assert alarm.cause == "illegal-variable"
    assert "there is no #5000" in alarm.detail


def test_a_tool_and_its_change_in_one_block() -> None:
    """T1 M06 changes to tool 1, as the printed example of a mill has it [source 003]."""
    for block in ("T1 M06", "M06 T1", "T1 M06 S500", "G90 T1 M06", "G54 G80 T1 M06"):
        run = cncsub.loads(f"O1\n{block}\nG0 X1.\nM30", control="fanuc-0i-f").run()
        assert run.moves.tool.tolist() == [1], block


def test_the_end_of_a_line_on_windows_is_neither_shown_nor_marked() -> None:
    text = "O1\r\nN10 #3000=1(WORN)\r\nM30\r\n"
    alarm = cncsub.loads(text.encode(), control="fanuc-0i-f").run().alarm
    assert alarm is not None
    shown, mark = str(alarm).splitlines()[2:4]
    assert shown == "   | N10 #3000=1(WORN)"
    assert mark == "   |     ^^^^^^^^^^^^^"


@pytest.mark.parametrize("control", cncsub.controls)
def test_an_alarm_in_an_empty_file_is_in_its_first_line(control: str) -> None:
    library = cncsub.loads("", control=control, name="empty.nc")
    alarm = library.run().alarm
    assert alarm is None or (alarm.line, alarm.column) == (1, 1)
    assert library.main is None or library.main.line == 1
    assert [f.line for f in library.check()] in ([], [1])
