"""Variables and signals as programs of a control write them, wherever a number is taken."""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub import _core
from cncsub.cli import app

TEXT = "N10 R6=R5+1\nN20 IF $A_IN[3]==TRUE GOTOF ENDE\nN30 R7=1\nN40 ENDE: M30\n"


@pytest.mark.parametrize("control", list(cncsub.controls))
def test_the_number_of_a_name_is_the_one_that_has_the_name(control: str) -> None:
    of = cncsub.controls[control]
    for number in (
        1,
        5,
        33,
        100,
        500,
        1004,
        2001,
        5021,
        2_000_001_001,
        2_000_005_001,
        1_950_003_005,
    ):
        name = _core.variable_name(of, number)
        assert _core.variable_number(of, name) == number
        assert _core.variable_number(of, f" {name.lower()} ") == number


@pytest.mark.parametrize(
    ("control", "name", "number"),
    [
        ("siemens-one", "R5", 5),
        ("siemens-one", "R[5]", 5),
        ("siemens-one", "$A_IN[1]", 2_000_001_001),
        ("siemens-one", "$A_OUT[2]", 1_950_003_002),
        ("siemens-one", "$AC_MARKER[0]", 1_950_007_001),
        ("siemens-one", "$TC_DP3[5,1]", 1_900_000_000 + (3 * 40_000 + 5) * 20 + 1),
        ("fanuc-0i-f", "#500", 500),
        ("fanuc-0i-f", "#[500]", 500),
        ("linuxcnc", "#5221", 5221),
        ("syntec-22ma", "@5", 1_000_005),
        ("syntec-22ma", "@1999", 1_001_999),
    ],
)
def test_names_lead_to_numbers(control: str, name: str, number: int) -> None:
    assert _core.variable_number(cncsub.controls[control], name) == number


@pytest.mark.parametrize(
    "name", ["R", "R5+1", "#5", "$A_IN[0]", "$A_IN[2000]", "$NONE[1]", "", "5R"]
)
def test_what_is_no_variable_has_no_number(name: str) -> None:
    assert _core.variable_number(cncsub.controls["siemens-one"], name) is None


def test_a_run_takes_them() -> None:
    library = cncsub.loads(TEXT, control="siemens-one")
    run = library.run(variables={"R5": 3}, watch=["R6"], inputs={"signals": {"$A_IN[3]": 1}})
    assert (run.variables["R6"], run.variables["r7"], run.watch[0].variable) == (4, None, 6)
    again = library.run(variables={5: 3}, inputs={"signals": {2_000_001_003: 1}})
    assert dict(again.variables) == dict(run.variables)


def test_a_machine_takes_them() -> None:
    machine = cncsub.loads(TEXT, control="siemens-one").machine()
    machine.variables["R5"] = 7
    machine.signals["$A_IN[3]"] = 1
    machine.run()
    assert (machine.variables["R6"], machine.signals["$A_IN[3]"]) == (8, 1)
    del machine.variables["R6"]
    assert "R6" not in machine.variables
    assert machine.variables.pop("R5") == 7
    with pytest.raises(KeyError, match="siemens-one has no variable 'Q5'"):
        machine.variables["Q5"]
    with pytest.raises(KeyError, match=r"siemens-one has no variable '\$B_IN\[3\]'"):
        machine.signals["$B_IN[3]"] = 1


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"variables": {"#5": 1}}, "variables: siemens-one has no variable '#5'"),
        ({"variables": {5: 1, "R5": 2}}, "variables: 'R5' is given twice"),
        ({"watch": ["R5", "X1"]}, "watch: siemens-one has no variable 'X1'"),
        ({"inputs": {"signals": {"$A_IN[0]": 1}}}, "signals: siemens-one has no variable"),
        ({"inputs": {"writes": [{"#500": 1}]}}, "writes: siemens-one has no variable '#500'"),
    ],
)
def test_names_that_are_none_are_refused(options: dict[str, object], words: str) -> None:
    with pytest.raises(ValueError, match=words.replace("$", r"\$").replace("[", r"\[")):
        cncsub.loads(TEXT, control="siemens-one").run(**options)  # type: ignore[arg-type]


def test_what_the_world_writes_is_named_too() -> None:
    text = "N10 M117\nN20 WAIT: IF $A_IN[4]==FALSE GOTOB WAIT\nN30 IF R50==0 GOTOB WAIT\nN40 M30\n"
    library = cncsub.loads(text, control="siemens-one")
    inputs = {"answers": {"M117": {"$A_IN[4]": 1}}, "writes": [{"R50": 2}]}
    run = library.run(inputs=inputs)
    assert (run.stop, run.variables["R50"]) == (cncsub.Stop.END, 2)


def test_the_command_line_takes_them(tmp_path: Path) -> None:
    (tmp_path / "MAIN.MPF").write_text(TEXT)
    (tmp_path / "in.toml").write_text('[signals]\n"$A_IN[3]" = 1\n')
    (tmp_path / "v.toml").write_text('R5 = 1\n"$AC_PARAM[2]" = 4\n')
    run = ["run", str(tmp_path / "MAIN.MPF"), "-c", "siemens-one", "--watch", "R6,R7"]
    more = [
        "--variables",
        str(tmp_path / "v.toml"),
        "--set",
        "R5=3",
        "--inputs",
        str(tmp_path / "in.toml"),
    ]
    result = CliRunner().invoke(app, [*run, *more])
    assert result.exit_code == 0, result.output
    assert "R6" in result.output
    assert "4" in result.output
    wrong = CliRunner().invoke(app, [*run, "--set", "Q5=3"])
    assert wrong.exit_code == 2
    assert "siemens-one has no variable 'Q5'" in wrong.output
