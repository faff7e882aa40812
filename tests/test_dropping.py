"""A dropped M code that would start the spindle or the coolant warns, in data and on the screen."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app

BLOCK = "O1\nN10 M03 S500 M08\nN20 M30\n"
ALLOWS = "--param 3404#7=1 lets the control execute more M codes of a block, or write it in a block of its own"


@pytest.mark.parametrize("control", ["fanuc-0i-f", "fanuc-16i"])
def test_a_dropped_start_of_the_spindle_names_the_parameter_that_allows_it(control: str) -> None:
    run = cncsub.loads(BLOCK, control=control).run()
    ((text, warning),) = [(word.text, word.warning) for word in run.dropped]
    assert (text, run.m_codes) == ("M03", [8])
    assert warning == f"it would start the spindle: {ALLOWS}"
    given = cncsub.controls[control].with_parameters({"3404#7": 1})
    allowed = cncsub.loads(BLOCK, control=given).run()
    assert (allowed.dropped, allowed.m_codes) == ((), [3, 8])


def test_a_dropped_stop_does_not_warn_and_coolant_does() -> None:
    text = "O1\nN10 M09 M05\nN20 M8 M4 S5\nN30 X1. X2.\nN40 M30\n"
    run = cncsub.loads(text, control="fanuc-0i-f").run()
    assert [(word.text, word.warning is None) for word in run.dropped] == [
        ("M09", True),
        ("M8", False),
        ("X1.", True),
    ]
    assert run.dropped[1].warning == f"it would start the coolant: {ALLOWS}"


def test_a_control_without_such_a_parameter_says_how_many_it_takes() -> None:
    run = cncsub.loads("%1\nN10 M8 M6 M3\nN20 M30\n", control="hnc-21m").run()
    assert run.dropped[0].warning == (
        "it would start the coolant: the control executes 2 M codes of a block, write it in a block of its"
        " own"
    )


def test_four_m_codes_where_three_count_name_no_parameter() -> None:
    control = cncsub.controls["fanuc-0i-f"].with_parameters({"3404#7": 1})
    run = cncsub.loads("O1\nN10 M8 M7 M3 M41\nN20 M30\n", control=control).run()
    assert [word.warning for word in run.dropped] == [
        "it would start the coolant: the control executes 3 M codes of a block, write it in a block of its"
        " own"
    ]


@pytest.mark.parametrize("command", ["run", "tree", "coverage"])
def test_commands_warn(command: str, tmp_path: Path) -> None:
    file = tmp_path / "part.nc"
    file.write_text(BLOCK)
    result = CliRunner().invoke(app, [command, str(file), "-c", "fanuc-0i-f"])
    told = " ".join((result.stdout + result.stderr).split())
    assert "warning: " in told
    assert "it would start the spindle: --param 3404#7=1" in told


def test_the_warning_is_in_the_facts_and_the_report(tmp_path: Path) -> None:
    file = tmp_path / "part.nc"
    file.write_text(BLOCK)
    arguments = ["run", str(file), "-c", "fanuc-0i-f", "--format", "json"]
    facts = json.loads(CliRunner().invoke(app, arguments).stdout)
    assert facts["dropped"][0]["warning"].startswith("it would start the spindle")
    library = cncsub.load(file, control="fanuc-0i-f")
    assert "it would start the spindle" in library.run()._repr_html_()


@pytest.mark.parametrize("word", ["M#1", "M[1+2]", "M+#1"])
def test_a_code_that_is_computed_may_be_one_that_starts_something(word: str) -> None:
    run = cncsub.loads(f"O1\n#1=3\nN10 {word} M9\nM30\n", control="fanuc-0i-f").run()
    assert run.dropped[0].warning == f"it may start the spindle or the coolant: {ALLOWS}"


def test_a_blank_in_a_code_hides_no_warning() -> None:
    run = cncsub.loads("O1\nN10 M 03 M08\nM30\n", control="fanuc-0i-f").run()
    assert run.dropped[0].warning == f"it would start the spindle: {ALLOWS}"


@pytest.mark.parametrize(
    ("control", "text", "dropped"),
    [
        ("haas-ngc", "O1\nG4 X1.5\nM30\n", ["X1.5"]),
        ("haas-ngc", "O1\nG4 A1.\nM30\n", ["A1"]),
        ("fanuc-0i-f", "O1\nG4 P100 Z3.\nM30\n", ["Z3"]),
        ("siemens-one", "G4 F1 X20\nM30\n", ["X20"]),
        ("fanuc-0i-f", "O1\nG4 X1.\nM30\n", []),
        ("linuxcnc", "G0\nG4 P1 X5\nM2\n", []),  # X moves after the dwell
    ],
)
def test_an_axis_word_that_a_dwell_does_not_take_is_told(
    control: str, text: str, dropped: list[str]
) -> None:
    run = cncsub.loads(text, control=control).run()
    assert [word.text for word in run.dropped] == dropped


def test_a_tool_called_by_a_name_that_the_setup_does_not_give_warns() -> None:
    job = cncsub.loads('T="MILL_10"\nT="M"<<"ILL"\nG0 Z1\nM30\n', control="siemens-one")
    run = job.run()
    assert [word.text for word in run.dropped] == ['T="MILL_10"', 'T="M"<<"ILL"']
    assert all("no tool of the setup has this name" in str(word.warning) for word in run.dropped)
    known = job.run(setup={"tools": {5: {"name": "MILL_10"}, 6: {"name": "MILL"}}})
    assert known.dropped == ()
