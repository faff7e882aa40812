"""What a run hands out is a value: it does not change with the machine or by being looked at."""

from __future__ import annotations

import copy
import pickle

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
