"""The Python face: the library, runs, tables, the machine, inputs and setup."""

from __future__ import annotations

import dataclasses
import inspect
import math
import re
import subprocess
import sys
import threading
from collections.abc import Mapping
from datetime import datetime
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cncsub
from cncsub.run_options import stated
from cncsub.tables import Bounds
from cncsub.tables.table import records

CONTROL = "fanuc-0i-f"
CALLS = """O1
N10 M98 P2 L2
N20 G65 P3 A1. B2.5
N30 M30
O2
N40 G91 G1 X10. F100.
N50 M99
O3
N60 #100=#1+#2
N70 M98 P2
N80 M99
"""


@pytest.fixture
def library() -> cncsub.Library:
    return cncsub.loads(CALLS, control=CONTROL)


@pytest.fixture
def run(library: cncsub.Library) -> cncsub.Run:
    return library.run()


# ---- controls and causes ----


def test_the_controls_are_listed_by_maker_and_name() -> None:
    names = list(cncsub.controls)
    assert names == sorted(names)
    assert set(names) >= {
        "fanuc-0i-d",
        "fanuc-0i-f",
        "fanuc-16i",
        "fanuc-30i",
        "gsk-928te",
        "gsk-980mdi",
        "gsk-980tdi",
        "gsk-988t",
        "gsk-988ta",
        "haas-ngc",
        "hnc-21m",
        "mitsubishi-m700",
        "mitsubishi-m800",
        "mitsubishi-meldas",
    }


def test_a_control_is_a_file_that_names_it() -> None:
    makers = Path(__file__).parent.parent / "cpp/controls"
    files = [f for f in makers.glob("*/*.cpp") if not f.stem.startswith("family")]
    names = {f.stem if f.stem == f.parent.name else f"{f.parent.name}-{f.stem}" for f in files}
    assert {name.replace("_", "-") for name in names} == set(cncsub.controls)


def test_an_unknown_control_is_told_with_what_is_near() -> None:
    with pytest.raises(KeyError, match="fanuc-0i-f"):
        cncsub.controls["fanuc-0if"]
    with pytest.raises(ValueError, match="did you mean.*fanuc-0i-f"):
        cncsub.loads("O1", control="Fanuc-0IG")
    with pytest.raises(ValueError, match="there are fanuc-0i-d"):
        cncsub.loads("O1", control="???")
    with pytest.raises(TypeError, match="control must be a name"):
        cncsub.loads("O1", control=30)  # type: ignore[arg-type]
    assert "xyz" not in cncsub.controls
    assert cncsub.controls.get("xyz") is None


def test_a_control_is_taken_where_its_name_is() -> None:
    control = cncsub.controls[CONTROL].replace(max_nesting=1)
    run = cncsub.loads("O1\nN1 M98 P2\nO2\nN2 M98 P3\nN3 M99\nO3\nN4 M99\n", control=control).run()
    assert run.alarm is not None
    assert run.alarm.cause == "nesting-too-deep"
    assert {rule.name: rule.value for rule in control.rules}["max_nesting"] == 1
    assert {rule.name: rule.value for rule in cncsub.controls[CONTROL].rules}["max_nesting"] != 1


@pytest.mark.parametrize("name", list(cncsub.controls))
def test_a_changed_parameter_is_kept_in_a_copy(name: str) -> None:
    control = cncsub.controls[name]
    for parameter, known in control.parameters.items():
        other = 1 - known.value if "#" in parameter else known.value + 1
        changed = control.with_parameters({parameter: other})
        assert changed.parameters[parameter].value == other
        assert changed.name == f"{control.name} + {parameter}={other:g}"


def test_every_rule_takes_its_own_value_again() -> None:
    for control in cncsub.controls.values():
        same = control.replace(**{rule.name: rule.value for rule in control.rules})
        assert [rule.value for rule in same.rules] == [rule.value for rule in control.rules]


def test_a_wrong_rule_is_told() -> None:
    with pytest.raises((ValueError, TypeError, KeyError), match="max_nestling"):
        cncsub.controls[CONTROL].replace(max_nestling=3)
    with pytest.raises((ValueError, TypeError)):
        cncsub.controls[CONTROL].replace(max_nesting="many")


@pytest.mark.parametrize("value", [float("nan"), float("inf"), 1e300, -1e10])
def test_a_parameter_takes_numbers_that_a_control_could_hold(value: float) -> None:
    with pytest.raises(ValueError, match="parameter 6050 must be a number up to"):
        cncsub.controls[CONTROL].with_parameters({"6050": value})
    with pytest.raises(ValueError, match="parameter 6001#5 is a bit: its value must be 0 or 1"):
        cncsub.controls[CONTROL].with_parameters({"6001#5": value})


def test_no_rule_makes_a_table_that_fills_the_memory() -> None:
    many = 999_999_999
    control = cncsub.controls[CONTROL].replace(max_extra_systems=many, max_offset_number=many)
    run = cncsub.loads("O1\nN1 G10 L20 P9999 X1\nN2 G54.1 P10000\n", control=control).run()
    assert run.alarm is not None
    assert run.alarm.n == 2


def test_causes_have_a_meaning_and_a_cure() -> None:
    cause = cncsub.causes["program-not-found"]
    assert cause.slug == "program-not-found"
    assert cause.meaning
    assert cause.cure
    with pytest.raises(KeyError, match="program-not-found"):
        cncsub.causes["program-not-fund"]


# ---- the library ----


def test_a_program_is_found_by_any_way_to_write_its_name() -> None:
    library = cncsub.loads("O1\nM30\nO0002\nM99\n", control=CONTROL)
    assert library["O0002"] is library["O2"] is library[2] is library["o02"]
    assert list(library) == ["O1", "O0002"]
    assert len(library) == 2
    assert "O2" in library
    assert 2 in library
    assert 3 not in library
    assert None not in library
    assert [name for name, program in library.items()] == [p.name for p in library.values()]


def test_an_unknown_program_is_told_with_what_is_near(library: cncsub.Library) -> None:
    with pytest.raises(KeyError, match="no program O20 in the memory; did you mean O2"):
        library["O20"]
    with pytest.raises(KeyError, match="O1, O2, O3"):
        library.run("X")
    with pytest.raises(KeyError):
        library.machine(10**30)
    with pytest.raises(KeyError):
        library.run(-1)


def test_a_library_knows_its_parts(tmp_path: Path) -> None:
    (tmp_path / "O1.nc").write_text("N10 M30\n")
    (tmp_path / "O2.nc").write_text("O2\nM99\nO1\nM99\n")
    library = cncsub.load(tmp_path, control=CONTROL)
    assert library.control.name == CONTROL
    assert library.main is library["O1"]
    assert library.files == (str(tmp_path / "O1.nc"), str(tmp_path / "O2.nc"))
    assert [(p.name, p.line) for p in library.duplicates] == [("O1", 3)]
    assert list(library.external) == []
    assert library.skipped == ()
    assert repr(library) == "<Library of fanuc-0i-f, 2 programs: O1, O2>"


def test_the_external_device_has_programs_of_its_own(tmp_path: Path) -> None:
    (tmp_path / "O9.nc").write_text("N10 M99\n")
    library = cncsub.loads("O1\nN1 M198 P9\nN2 M30\n", control=CONTROL, external=tmp_path)
    assert list(library.external) == ["O9"]
    assert library.external["O9"].external
    assert "O9" not in library
    assert library.run().steps.n.tolist() == [1, 10, 2]


def test_a_program_shows_its_blocks_and_words() -> None:
    program = cncsub.loads("%\nO7 (TITLE)\nN10 G1X-1.5 Y#1 (COMMENT)\n\nM30\n%\n", control=CONTROL)[
        7
    ]
    assert (program.name, program.comment, program.line) == ("O7", "TITLE", 2)
    assert len(program.blocks) == 2
    first, last = program.blocks[0], program.blocks[-1]
    assert (first.n, first.line, last.n, last.line) == (10, 3, None, 5)
    assert first.words == (
        ("N", 10.0, "N10"),
        ("G", 1.0, "G1"),
        ("X", -1.5, "X-1.5"),
        ("Y", None, "Y#1"),
    )
    assert first.program is program
    assert program.blocks[0:2] == [first, last]
    assert "G1X-1.5" in program.text
    with pytest.raises(IndexError):
        program.blocks[2]


def test_the_radius_of_sinumerik_is_a_word() -> None:
    text = "N20 G2 X10 Y0 CR=5 F100\nCR = -2.5 X1\nCR=R1+5 X1\nCR=2*3\nVAR=5\nM30\n"
    main = cncsub.loads(text, control="siemens-one").main
    assert main is not None
    radii = [w for block in main.blocks for w in block.words if w.address in ("CR", "")]
    assert radii == [
        ("CR", 5.0, "CR=5"),
        ("CR", -2.5, "CR=-2.5"),
        ("CR", None, "CR=R1+5"),
        ("CR", None, "CR=2*3"),
        ("", None, "VAR=5"),
    ]


def test_the_number_of_an_axis_belongs_to_its_address() -> None:
    text = "O1\nG65 P2 X1=27.5 Y 2 = -3 X3=1 Z1=#5 X1\nM30\n"
    words = cncsub.loads(text, control="gsk-988t")[1].blocks[0].words
    assert words[2:] == (
        ("X1", 27.5, "X1=27.5"),
        ("Y2", -3.0, "Y2=-3"),
        ("X", 3.0, "X3"),
        ("=", 1.0, "=1"),
        ("Z1", None, "Z1=#5"),
        ("X", 1.0, "X1"),
    )


def test_behind_a_bare_g_the_next_word_stands() -> None:
    program = cncsub.loads("O1\nGX20.Y3\nM30\n", control="mitsubishi-m700")[1]
    assert program.blocks[0].words == (("G", None, "G"), ("X", 20.0, "X20."), ("Y", 3.0, "Y3"))


@pytest.mark.parametrize(
    ("options", "error"),
    [
        ({"mode": "auto1"}, ValueError),
        ({"trace": "all"}, ValueError),
        ({"start": "N10"}, TypeError),
        ({"start": -1}, ValueError),
        ({"variables": {"a": 1}}, TypeError),
        ({"variables": {100: "x"}}, TypeError),
        ({"variables": {0: 1}}, ValueError),
        ({"variables": {100: math.inf}}, ValueError),
        ({"variables": [100]}, TypeError),
        ({"block_skip": (11,)}, ValueError),
        ({"block_skip": "1"}, TypeError),
        ({"max_cycles": 0}, ValueError),
        ({"max_blocks": -1}, ValueError),
        ({"max_blocks": 1.5}, TypeError),
        ({"max_blocks": 2**70}, ValueError),
        ({"max_seconds": 0}, ValueError),
        ({"max_seconds": "1"}, TypeError),
        ({"inputs": {"signal": {}}}, ValueError),
        ({"inputs": [1]}, TypeError),
        ({"setup": {"machine": "router"}}, ValueError),
        ({"setup": {"starts": {}}}, ValueError),
        ({"setup": "mill"}, TypeError),
    ],
)
def test_a_wrong_argument_is_told(
    library: cncsub.Library, options: dict[str, Any], error: type[Exception]
) -> None:
    for call in (library.run, library.machine):
        with pytest.raises(error, match=re.escape(next(iter(options))) + "|switches|machine"):
            call(**options)


def test_wrong_texts_and_names_are_told(library: cncsub.Library) -> None:
    with pytest.raises(TypeError, match="loads needs the text"):
        cncsub.loads(Path("O1.nc"), control=CONTROL)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="load needs a file"):
        cncsub.load(control=CONTROL)
    with pytest.raises(TypeError, match="mdi must be the text"):
        library.mdi(b"M98 P2")  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="mdi runs the text"):
        library.mdi("M98 P2", main="O2")  # type: ignore[call-arg]


def test_run_mdi_and_machine_take_the_same_options() -> None:
    taken = set(inspect.signature(cncsub.Library.run).parameters) - {"self", "main"}
    assert set(stated()) == set(cncsub.RunOptions.__annotations__) == taken
    for method, without in (
        (cncsub.Library.machine, set()),
        (cncsub.Library.stream, {"rows"}),
        (cncsub.Library.mdi, {"text", "mode"}),
        (cncsub.Library.flatten, {"control", "comments", "mode", "trace", "watch", "conditions"}),
        (
            cncsub.flatten,
            {"library", "control", "comments", "mode", "trace", "watch", "conditions"},
        ),
        (cncsub.compare, {"first", "second", "controls", "control", "all_differences", "mode"}),
    ):
        own = set(inspect.signature(method).parameters) - {"self", "main"}
        assert own ^ taken == without


def test_what_is_said_of_an_option_stands_in_the_help_of_run() -> None:
    told = inspect.getdoc(cncsub.Library.run) or ""
    for name, option in stated().items():
        assert f"`{name}`: " in told
        assert option.meaning.endswith(".")
        assert inspect.signature(cncsub.Library.run).parameters[name].default == option.default


@pytest.mark.parametrize(
    ("options", "named"),
    [
        ({"start": -1}, "start"),
        ({"start": 7}, "start"),
        ({"max_blocks": "many"}, "max_blocks"),
        ({"variables": {3000: 1}}, "variables"),
        ({"watch": [100, 10**12]}, "watch"),
        ({"watch": [0]}, "watch"),
        ({"inputs": {"signals": {100: 1}}}, "inputs"),
        ({"setup": {"work_offsets": {"G54.1 P99": {"X": 1}}}}, "setup"),
        ({"setup": {"machine": "crane"}}, "setup"),
        ({"trace": "all"}, "trace"),
    ],
)
def test_an_error_of_an_option_carries_its_name(
    library: cncsub.Library, options: dict[str, Any], named: str
) -> None:
    with pytest.raises((ValueError, TypeError)) as raised:
        library.run(**options)
    assert raised.value.option == named  # type: ignore[attr-defined, union-attr]


def test_a_name_of_the_text_names_a_program_without_one() -> None:
    library = cncsub.loads("N10 M30\n", control="gsk-988ta", name="dir/T0023.CNC")
    assert list(library) == ["T0023"]
    assert library.files == ("dir/T0023.CNC",)


def test_an_empty_text_runs() -> None:
    library = cncsub.loads("", control=CONTROL)
    assert isinstance(library.run().stop, cncsub.Stop)


# ---- runs ----


def test_a_run_says_how_it_stopped(run: cncsub.Run) -> None:
    assert run.stop is cncsub.Stop.END
    assert run.stop == "end"
    assert str(run.stop) == "end"
    assert run.alarm is None
    assert run.waiting_for == ""
    run.raise_for_alarm()
    assert repr(run) == "<Run: end, 12 steps, 3 calls>"


def test_an_alarm_is_a_value_and_can_be_raised() -> None:
    run = cncsub.loads("O1\nN10 M98 P2 L3\nO2\nN20 M98 P9\n", control=CONTROL).run()
    alarm = run.alarm
    assert alarm is not None
    assert (alarm.cause, alarm.number) == ("program-not-found", "PS0076")
    assert (alarm.program, alarm.n, alarm.line, alarm.word) == ("O2", 20, 4, "P9")
    (frame,) = alarm.frames
    assert (frame.program, frame.n, frame.line, frame.kind) == ("O1", 10, 2, "M98")
    assert (frame.repeat, frame.repeats) == (1, 3)
    with pytest.raises(cncsub.AlarmError, match="program-not-found") as raised:
        run.raise_for_alarm()
    assert raised.value.alarm.number == "PS0076"
    assert repr(run).startswith("<Run: alarm PS0076 program-not-found at O2 N20")


def test_variables_at_the_stop_are_those_of_the_main_program(library: cncsub.Library) -> None:
    run = library.run(variables={1: 7.5, 101: None, 102: np.int64(3)})
    assert run.variables[100] == 3.5
    assert run.variables[1] == 7.5
    assert run.variables[2] is None
    assert run.variables.get(101) is None
    assert dict(run.variables) == {1: 7.5, 100: 3.5, 102: 3.0}
    assert 100 in run.variables
    assert 101 not in run.variables
    assert len(run.variables) == 3
    with pytest.raises(KeyError, match="#99999"):
        run.variables[99999]
    with pytest.raises(KeyError):
        run.variables["x"]  # type: ignore[index]
    assert repr(run.variables) == "{1: 7.5, 100: 3.5, 102: 3}"


def test_codes_and_messages_are_kept_in_order() -> None:
    text = "O1\nN10 T5 M6\nN20 M3 S100\nN30 #3006=1(CHECK)\nN40 M30\n"
    run = cncsub.loads(text, control=CONTROL).run()
    assert run.m_codes[:2] == [6, 3]
    assert run.t_codes == [5]
    assert run.messages == ["CHECK"]


def test_limits_stop_a_run() -> None:
    endless = cncsub.loads("O1\nN10 G4 X1.\nN20 M99\n", control=CONTROL)
    assert endless.run().stop is cncsub.Stop.CYCLES
    assert endless.run(max_cycles=3).steps.n.tolist() == [10, 20] * 3
    assert endless.run(max_cycles=10**9, max_blocks=5).stop is cncsub.Stop.LIMIT
    assert len(endless.run(max_cycles=10**9, max_blocks=5).steps) == 5
    spinning = cncsub.loads("O1\nN10 #1=#1+1\nN20 GOTO10\n", control=CONTROL)
    quick = spinning.run(max_blocks=10**12, max_seconds=0.05, trace="none")
    assert quick.stop is cncsub.Stop.LIMIT


@pytest.mark.parametrize(
    ("trace", "counts"),
    [("none", (0, 0, 0)), ("calls", (0, 3, 0)), ("blocks", (12, 3, 0)), ("moves", (12, 3, 3))],
)
def test_the_trace_keeps_what_is_asked_for(
    library: cncsub.Library, trace: str, counts: tuple[int, int, int]
) -> None:
    run = library.run(trace=trace)
    assert (len(run.steps), len(run.calls), len(run.moves)) == counts
    assert run.variables[100] == 3.5


def test_block_skip_takes_numbers_one_number_or_yes() -> None:
    library = cncsub.loads("O1\n/N10 G4\n/2N20 G4\nN30 M30\n", control=CONTROL)
    expected = {(): [10, 20, 30], (1,): [20, 30], (1, 2): [30]}
    for switches, numbers in expected.items():
        assert library.run(block_skip=switches).steps.n.tolist() == numbers
    assert library.run(block_skip=1).steps.n.tolist() == [20, 30]
    assert library.run(block_skip=True).steps.n.tolist() == [20, 30]


def test_a_run_starts_at_a_sequence_number(library: cncsub.Library) -> None:
    assert library.run("O3", start=80).steps.n.tolist()[:1] == [80]


def test_runs_in_threads_do_not_disturb_each_other(library: cncsub.Library) -> None:
    found: list[list[int]] = []
    threads = [
        threading.Thread(target=lambda: found.append(library.run().steps.n.tolist()))
        for _ in range(4)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [library.run().steps.n.tolist()] * 4


def test_ctrl_c_stops_a_run_as_interrupted() -> None:
    code = (
        "import cncsub, signal, threading, os\n"
        "library = cncsub.loads('O1\\nN10 #1=#1+1\\nN20 GOTO10\\n', control='fanuc-0i-f')\n"
        "threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()\n"
        "run = library.run(max_blocks=10**15, max_seconds=30, trace='none')\n"
        "print(run.stop)\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert done.stdout == "interrupted\n", done.stderr


# ---- tables ----


def test_columns_are_arrays(run: cncsub.Run) -> None:
    steps = run.steps
    assert steps.n.tolist() == [10, 40, 50, 40, 50, 20, 60, 70, 40, 50, 80, 30]
    assert steps.n is steps["n"]
    assert isinstance(steps.n, np.ndarray)
    assert steps.program.dtype == np.int32
    assert [steps.programs[code] for code in steps.program[:3]] == ["O1", "O2", "O2"]
    assert steps.depth.tolist() == [0, 1, 1, 1, 1, 0, 1, 1, 2, 2, 1, 0]
    assert steps.repeat.tolist()[1:5] == [1, 1, 2, 2]
    assert steps.columns == ["step", "program", "n", "line", "depth", "frame", "repeat"]
    assert all(len(steps[name]) == len(steps) for name in steps.columns)
    assert "line" in dir(steps)
    with pytest.raises(KeyError, match="there are step, program"):
        steps["x"]
    with pytest.raises(AttributeError, match="no column 'x'"):
        _ = steps.x
    assert not hasattr(steps, "__array_interface__")


def test_rows_are_small_objects() -> None:
    run = cncsub.loads("O1\nG4 X1.\nN10 M30\n", control=CONTROL).run()
    assert run.steps[0].n is None
    assert run.steps[0] == cncsub.Step(0, "O1", None, 2, 0, -1, 1)
    assert run.steps[-1].n == 10
    assert run.steps[:1] == [run.steps[0]]
    assert run.steps[::-1] == [run.steps[1], run.steps[0]]
    assert list(run.steps) == run.steps[:]
    assert run.steps[np.int64(1)] == run.steps[1]
    with pytest.raises(IndexError, match="row 2 of 2 steps"):
        run.steps[2]
    with pytest.raises(dataclasses.FrozenInstanceError):
        run.steps[0].n = 5  # type: ignore[misc]


def test_calls_are_rows_with_their_arguments(run: cncsub.Run) -> None:
    first, macro, inner = run.calls
    assert (first.kind, first.program, first.repeats, first.parent) == ("M98", "O2", 2, None)
    assert (first.caller_step, first.first_step, first.last_step) == (0, 1, 4)
    assert (macro.kind, macro.program, macro.level) == ("G65", "O3", 1)
    assert macro.arguments == {1: 1.0, 2: 2.5}
    assert (inner.parent, inner.program, inner.arguments) == (1, "O2", {})
    assert [run.calls.kinds[kind] for kind in run.calls.kind] == ["M98", "G65", "M98"]
    assert repr(run.calls).splitlines() == [
        "M98 O2, 2 passes (4 blocks)",
        "G65 O3 (5 blocks)",
        "  M98 O2 (2 blocks)",
        "3 calls",
    ]


def test_equal_calls_are_drawn_once_with_their_count() -> None:
    text = "O1\nN10 #1=#1+1\nN20 M98 P2\nN30 IF[#1 LT 500]GOTO10\nM30\nO2\nM98 P3\nM99\nO3\nM99\n"
    calls = cncsub.loads(text, control=CONTROL).run().calls
    assert repr(calls) == "M98 O2 (3 blocks) x 500\n  M98 O3 (1 block)\n1,000 calls"


def test_a_deep_tree_of_calls_is_drawn_without_recursion() -> None:
    control = cncsub.controls[CONTROL].replace(
        max_nesting=100_000, max_total_nesting=0, self_call="allowed", caller_call="allowed"
    )
    run = cncsub.loads("O1\nN10 M98 P1\n", control=control).run(max_blocks=5000)
    assert len(run.calls) >= 4999
    assert repr(run.calls).splitlines()[-3] == "..."


def test_moves_are_rows_with_their_totals(run: cncsub.Run) -> None:
    moves = run.moves
    assert moves.x.tolist() == [10.0, 20.0, 30.0]
    assert {moves.kinds[kind] for kind in moves.kind} == {"feed"}
    assert moves[0].kind == "feed"
    assert moves[0].cx is None
    assert math.isnan(moves.cx[0])
    assert moves[-1].mx == moves.mx[-1]
    assert moves.length.tolist() == pytest.approx([10.0] * 3)
    assert moves.time.tolist() == pytest.approx([6.0] * 3)
    assert moves.total_length == pytest.approx(30.0)
    assert moves.total_time == pytest.approx(18.0)
    assert moves.bounds["X"] == moves.bounds["x"] == (10.0, 30.0)
    assert {"a", "ma", "w"}.isdisjoint(moves.columns)
    assert {"x", "y", "z", "mx", "cx", "plane", "feed", "spindle", "tool"} <= set(moves.columns)


def test_bounds_are_found_by_axis_in_either_case() -> None:
    bounds = Bounds({"X": (0.0, 1.0)})
    assert bounds["x"] == bounds["X"]
    with pytest.raises(KeyError):
        bounds["y"]


def test_the_row_of_a_move_is_the_row_of_its_columns(run: cncsub.Run) -> None:
    for index, record in enumerate(records(run.moves)):
        row = dataclasses.asdict(run.moves[index])
        for name, value in record.items():
            if name != "feed_mode":
                assert row[name] == pytest.approx(value), name


@pytest.mark.parametrize("table", ["steps", "calls", "moves"])
def test_a_table_reaches_pandas_and_arrow_with_its_texts(run: cncsub.Run, table: str) -> None:
    import pandas as pd
    import polars as pl
    import pyarrow as pa

    rows = getattr(run, table)
    frame = rows.to_pandas()
    arrow = rows.to_arrow()
    assert list(frame.columns) == arrow.column_names == rows.columns
    assert len(frame) == arrow.num_rows == len(rows)
    for name in rows.columns:
        texts = rows.texts_of(name)
        column = rows[name].tolist()
        expected = column if texts is None else [texts[code] for code in column]
        if name in rows._nulls:
            expected = [None if value == -1 or value != value else value for value in column]
        assert arrow[name].to_pylist() == expected
        assert [None if pd.isna(value) else value for value in frame[name]] == expected
    assert pa.table(rows).equals(arrow)
    assert pl.DataFrame(rows).columns == rows.columns
    assert isinstance(frame, pd.DataFrame)


def test_an_empty_table_reaches_pandas_and_arrow() -> None:
    run = cncsub.loads("O1\nN10 M98 P9\n", control=CONTROL).run()
    assert len(run.calls) == 0
    assert run.calls.to_arrow().num_rows == 0
    assert run.calls.to_pandas().empty
    assert repr(run.calls) == "0 calls"
    assert repr(run.moves) == "0 moves"


def test_a_missing_optional_package_is_told(
    run: cncsub.Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    with pytest.raises(ImportError, match=r"pip install 'cncsub\[arrow\]'"):
        run.steps.to_arrow()


def test_a_long_table_is_printed_short(library: cncsub.Library) -> None:
    run = cncsub.loads("O1\n" + "G91 G1 X1. F9.\n" * 2000 + "M30\n", control=CONTROL).run()
    lines = repr(run.steps).splitlines()
    assert lines[0].split() == run.steps.columns
    assert lines[-1] == "2,001 steps"
    assert len(lines) == 13
    assert run.moves._repr_html_().count("<tr>") == 12


def test_html_is_escaped() -> None:
    name = "<b>&"
    run = cncsub.loads("N10 M30\n", control="gsk-988ta", name=f"{name}.CNC").run()
    html = run.steps._repr_html_()
    assert "<b>" not in html
    assert "&lt;b&gt;&amp;" in html


# ---- the machine ----


def test_a_machine_steps_block_by_block(library: cncsub.Library) -> None:
    machine = library.machine()
    assert machine.stop is None
    assert machine.stack == ()
    first = machine.step()
    assert first is not None
    assert (first.step, first.n) == (0, 10)
    machine.step()
    (frame,) = machine.stack
    assert (frame.program, frame.called, frame.repeats) == ("O1", "O2", 2)
    assert machine.position["X"] == 10.0
    assert repr(machine) == "<Machine: running, next block O2 N50, line 7>"
    rest = list(machine)
    assert [step.n for step in rest] == [50, 40, 50, 20, 60, 70, 40, 50, 80, 30]
    assert machine.stop is cncsub.Stop.END
    assert machine.step() is None
    assert len(machine.steps) == 12


def test_a_machine_steps_with_any_trace(library: cncsub.Library) -> None:
    machine = library.machine(trace="none")
    step = machine.step()
    assert step is not None
    assert step.n == 10


def test_a_machine_runs_until_a_block_or_out_of_a_call(library: cncsub.Library) -> None:
    machine = library.machine()
    assert machine.run(until=("O3", 70)) is None
    assert machine.steps[-1].n == 60
    machine.step()
    assert len(machine.stack) == 2
    assert machine.run(until=len(machine.stack) - 1) is None
    assert machine.steps[-1].n == 50
    assert machine.run(until=library["O1"].blocks[2]) is None
    assert machine.steps[-1].n == 80
    finished = machine.run()
    assert finished is not None
    assert finished.stop is cncsub.Stop.END
    with pytest.raises(KeyError, match="no program O8"):
        machine.run(until=("O8", 1))
    with pytest.raises(KeyError, match="no block N1 in O2"):
        machine.run(until=("O2", 1))
    with pytest.raises(TypeError, match="until must be a Block"):
        machine.run(until=2.5)  # type: ignore[arg-type]


def test_until_in_a_loop_stops_at_each_pass() -> None:
    library = cncsub.loads("O1\nN10 #1=#1+1\nN20 IF[#1 LT 3]GOTO10\nN30 M30\n", control=CONTROL)
    machine = library.machine()
    seen = []
    while machine.run(until=("O1", 20)) is None:
        seen.append(machine.variables[1])
    assert seen == [1.0, 2.0, 3.0]


def test_variables_of_a_machine_are_read_and_set_at_every_level(library: cncsub.Library) -> None:
    machine = library.machine(variables={1: 9})
    machine.run(until=("O3", 60))
    assert machine.variables[1] == 1.0
    assert machine.variables.level(0)[1] == 9.0
    machine.variables[1] = 5
    machine.variables.level(0)[2] = 6
    machine.variables[500] = None
    del machine.variables[2]
    assert machine.variables[2] is None
    assert machine.variables.level(0)[2] == 6.0
    machine.variables[2] = 0.25
    with pytest.raises(ValueError, match="open levels are 0 to 1"):
        machine.variables.level(2)
    with pytest.raises(KeyError):
        machine.variables[99999] = 1
    with pytest.raises(TypeError):
        machine.variables[1] = "x"  # type: ignore[assignment]
    run = machine.run()
    assert run is not None
    assert run.variables[100] == 5.25
    assert isinstance(machine.variables, Mapping)


def test_a_copy_of_a_machine_goes_its_own_way(library: cncsub.Library) -> None:
    machine = library.machine()
    machine.step()
    copy = machine.copy()
    copy.variables[500] = 1
    copy.run()
    assert machine.stop is None
    assert machine.variables[500] is None
    assert len(machine.steps) == 1
    assert len(copy.steps) == 12


# ---- inputs and setup ----


def test_a_run_waits_for_what_nobody_gives_and_says_for_what() -> None:
    library = cncsub.loads(
        "O1\nN10 #500=0\nN20 IF[#500 EQ 0]GOTO20\nN30 #501=#500\nN40 M30\n", control=CONTROL
    )
    run = library.run()
    assert run.stop is cncsub.Stop.WAITING
    assert "N20" in run.waiting_for or "#500" in run.waiting_for
    given = library.run(inputs=cncsub.Inputs(writes=[(3, {500: 7})]))
    assert given.stop is cncsub.Stop.END
    assert given.variables[501] == 7.0
    assert library.run(inputs={"writes": [{500: 8}]}).variables[501] == 8.0


def test_signals_and_clock_are_read() -> None:
    text = "O1\nN10 #100=#1000\nN20 #101=#3011\nN30 #102=#3012\nN40 M30\n"
    inputs = cncsub.Inputs(signals={1000: 1}, clock=datetime(2024, 5, 6, 7, 8, 9))
    run = cncsub.loads(text, control=CONTROL).run(inputs=inputs)
    assert [run.variables[n] for n in (100, 101, 102)] == [1.0, 20240506.0, 70809.0]


def test_the_operator_starts_or_stops() -> None:
    library = cncsub.loads("O1\nN10 M0\nN20 M0\nN30 M30\n", control=CONTROL)
    assert library.run().stop is cncsub.Stop.END
    stopped = library.run(inputs=cncsub.Inputs(operator=["start", "stop"]))
    assert stopped.stop is cncsub.Stop.WAITING
    assert 30 not in stopped.steps.n


@pytest.mark.parametrize(
    ("inputs", "error"),
    [
        ({"signals": {"x": 1}}, TypeError),
        ({"signals": [1]}, TypeError),
        ({"clock": "now"}, TypeError),
        ({"clock": -1}, ValueError),
        ({"operator": ["go"]}, ValueError),
        ({"operator": "start"}, TypeError),
        ({"writes": [5]}, TypeError),
        ({"writes": [(0, {500: 1})]}, ValueError),
        ({"skips": [1.5]}, ValueError),
        ({"skips": ["a"]}, TypeError),
    ],
)
def test_wrong_inputs_are_told(inputs: dict[str, Any], error: type[Exception]) -> None:
    with pytest.raises(error):
        cncsub.Inputs(**inputs)


def test_a_setup_is_read_from_a_file(tmp_path: Path) -> None:
    file = tmp_path / "setup.toml"
    file.write_text(
        'machine = "lathe-a"\nstart = { X = 100, z = 50 }\n'
        "[work_offsets]\nG54 = { X = 1 }\n'g54.1p3' = { Z = 2 }\n"
        "[length_offsets]\n1 = 50.0\n"
        "[tools.1]\nX = 0.1\nR = 0.4\ntip = 3\n"
        "[limits]\nX = [-10, 500]\n"
    )
    setup = cncsub.Setup.from_toml(file)
    assert setup.to_core() == {
        "machine": "lathe-a",
        "start": {"X": 100.0, "Z": 50.0},
        "work_offsets": {"G54": {"X": 1.0}, "G54.1 P3": {"Z": 2.0}},
        "length_offsets": {1: 50.0},
        "tools": {1: {"X": 0.1, "R": 0.4, "tip": 3}},
        "limits": {"X": (-10.0, 500.0)},
        "increment": 0.001,
    }
    file.write_text("machine = ")
    with pytest.raises(ValueError, match=re.escape(str(file))):
        cncsub.Setup.from_toml(file)
    with pytest.raises(FileNotFoundError):
        cncsub.Setup.from_toml(tmp_path / "none.toml")


@pytest.mark.parametrize(
    ("setup", "words"),
    [
        ({"machine": "router"}, "machine must be one of mill"),
        ({"start": {"Q": 1}}, "start: 'Q' is not an axis"),
        ({"start": {"X": "1"}}, r"start\['X'\] must be a number"),
        ({"start": 5}, "start must be a mapping"),
        ({"work_offsets": {"G60": {}}}, "'G60' is not a work coordinate system"),
        ({"length_offsets": {"a": 1}}, "length_offsets: 'a' is not the number"),
        ({"tools": {1: {"Q": 1}}}, r"tools\[1\] has no 'Q'"),
        ({"tools": {1: {"tip": 10}}}, "the tip must be a direction"),
        ({"rapid": {"X": 0}}, "must be more than 0"),
        ({"limits": {"X": (5, 1)}}, "5 is above 1"),
        ({"limits": {"X": 5}}, "lowest and the highest"),
        ({"increment": 0}, "increment must be more than 0"),
        ({"start": {"X": math.nan}}, "out of range"),
    ],
)
def test_a_wrong_setup_is_told(setup: dict[str, Any], words: str) -> None:
    with pytest.raises((ValueError, TypeError), match=words):
        cncsub.Setup(**setup)


def test_travel_limits_alarm() -> None:
    library = cncsub.loads("O1\nN10 G90 G0 X100.\nN20 M30\n", control=CONTROL)
    assert library.run().stop is cncsub.Stop.END
    run = library.run(setup=cncsub.Setup(limits={"X": (-10, 50)}))
    assert run.alarm is not None
    assert run.alarm.cause == "over-travel"


# ---- the package ----


def test_the_package_exports_what_it_says() -> None:
    assert all(hasattr(cncsub, name) for name in cncsub.__all__)
    assert sorted(cncsub.__all__) == cncsub.__all__


@pytest.mark.parametrize(
    ("name", "group", "rule"),
    [("gsk-928te", "macros", "max_loops"), ("gsk-980mdi", "turning", "rough_depth")],
)
def test_a_group_of_rules_that_a_control_lacks_is_absent(name: str, group: str, rule: str) -> None:
    control = cncsub.controls[name]
    source, evidence = control.absent[group]
    assert source
    assert evidence
    assert group not in {row.group for row in control.rules}
    with pytest.raises(ValueError, match=f"{name} has no rules of {group}, such as {rule}: "):
        control.replace(**{rule: 2})
    assert not cncsub.controls["fanuc-0i-f"].absent


def test_help_shows_signatures_that_somebody_can_type() -> None:
    classes = [made for name in dir(cncsub) if inspect.isclass(made := getattr(cncsub, name))]
    methods = [
        (made.__name__, name, inspect.getdoc(getattr(made, name)) or "")
        for made in classes
        for name in dir(made)
        if not name.startswith("_") and callable(getattr(made, name))
    ]
    assert [m[:2] for m in methods if "*args" in m[2] and m[0] in ("Control", "Alarm")] == []
    assert cncsub.Control.with_parameters.__doc__ is not None
    assert cncsub.Control.with_parameters.__doc__.startswith("with_parameters(parameters)\n")


@pytest.mark.parametrize(
    "name",
    [
        *("load", "loads", "compare", "flatten", "translate", "report", "run_many", "check_many"),
        *("read_variables", "Alarm", "AlarmError", "Control", "Library", "Program", "Run", "Stop"),
        *("Setup", "Inputs", "Workpiece", "Box", "Cylinder", "Plane", "Sphere", "Machine", "Flat"),
    ],
)
def test_what_is_called_or_made_has_an_example(name: str) -> None:
    assert ">>> " in (inspect.getdoc(getattr(cncsub, name)) or "")
