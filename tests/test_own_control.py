"""A control of your own, made from a built-in one by a TOML file."""

from __future__ import annotations

import contextlib
import copy
import pickle
import textwrap
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app

pytest_plugins = ["pytester"]

SHEET = """
name = "our-mill"
base = "fanuc-0i-f"

[rules]
max_nesting = { value = 2, note = "the sheet of the builder, page 12" }

[parameters]
"6005#0" = { value = 1, note = "set when the machine came" }

[calls]
M60 = { value = "macro-call:9020", note = "the pallet changer" }
G200 = "macro-call:9021"

[alarms]
nesting-too-deep = { number = "PS9077", text = "TOO DEEP HERE", note = "seen on the screen" }
program-not-found = "PS9078"
"""


def of(text: str, tmp_path: Path, name: str = "our-mill.toml") -> cncsub.Control:
    file = tmp_path / name
    file.write_text(textwrap.dedent(text), encoding="utf-8")
    return cncsub.Control.from_toml(file)


@pytest.fixture
def control(tmp_path: Path) -> cncsub.Control:
    return of(SHEET, tmp_path)


def rule(control: cncsub.Control, name: str) -> Any:
    return next(each for each in control.rules if each.name == name)


def test_it_has_a_name_and_tells_its_base(control: cncsub.Control) -> None:
    assert (control.name, control.base) == ("our-mill", "fanuc-0i-f")
    assert control.title == "our-mill (FANUC Series 0i-F)"
    assert cncsub.controls["fanuc-0i-f"].base == "fanuc-0i-f"
    assert "our-mill" not in cncsub.controls


def test_a_rule_holds_in_a_run_and_keeps_its_note(control: cncsub.Control) -> None:
    text = "O1\nM98 P2\nM30\nO2\nM98 P3\nM99\nO3\nM98 P4\nM99\nO4\nM99\n"
    run = cncsub.loads(text, control=control).run()
    assert run.alarm is not None
    assert (run.alarm.cause, run.alarm.number) == ("nesting-too-deep", "PS9077")
    assert run.alarm.text == "TOO DEEP HERE"
    assert cncsub.loads(text, control="fanuc-0i-f").run().alarm is None
    nesting = rule(control, "max_nesting")
    assert (nesting.value, nesting.source) == (2, "the sheet of the builder, page 12")
    assert nesting.evidence == "secondary"


def test_a_number_alone_changes_no_text(control: cncsub.Control) -> None:
    alarm = cncsub.loads("O1\nM98 P7\nM30\n", control=control).run().alarm
    assert alarm is not None
    assert alarm.number == "PS9078"
    assert alarm.text == cncsub.controls["fanuc-0i-f"].alarms["program-not-found"].text
    entry = control.alarms["program-not-found"]
    assert entry.source == "as our-mill.toml says, without a note"


def test_codes_call(control: cncsub.Control) -> None:
    text = "O1\nM60\nG200 A5.\nM30\nO9020\n#500=7\nM99\nO9021\n#501=#1\nM99\n"
    run = cncsub.loads(text, control=control).run()
    assert run.variables[500] == 7
    assert run.variables[501] == 5
    assert cncsub.loads(text, control="fanuc-0i-f").run().variables[500] is None


def test_a_parameter_sets_its_rules(control: cncsub.Control) -> None:
    base = cncsub.controls["fanuc-0i-f"]
    changed = base.with_parameters({"6005#0": 1})
    assert base.parameters["6005#0"].value == 0
    assert control.parameters["6005#0"].value == 1
    assert control.parameters["6005#0"].source == "set when the machine came"
    for name in control.parameters["6005#0"].rules:
        name = name.partition(":")[0]
        assert rule(control, name).value == rule(changed, name).value != rule(base, name).value


def test_it_goes_to_other_processes(control: cncsub.Control) -> None:
    for again in (pickle.loads(pickle.dumps(control)), copy.deepcopy(control)):
        assert (again.name, again.base, again.title) == (control.name, control.base, control.title)
        assert [(r.name, r.value, r.source, r.evidence) for r in again.rules] == [
            (r.name, r.value, r.source, r.evidence) for r in control.rules
        ]
        assert {s: (a.number, a.text, a.source) for s, a in again.alarms.items()} == {
            s: (a.number, a.text, a.source) for s, a in control.alarms.items()
        }
        assert {n: (p.value, p.source) for n, p in again.parameters.items()} == {
            n: (p.value, p.source) for n, p in control.parameters.items()
        }
    changed = pickle.loads(pickle.dumps(control.replace(max_nesting=3)))
    assert changed.name == "our-mill + max_nesting=3"
    assert rule(changed, "max_nesting").value == 3


def test_many_programs_run_on_it(control: cncsub.Control, tmp_path: Path) -> None:
    for number in (1, 2):
        (tmp_path / f"O{number}.nc").write_text(f"O{number}\nM98 P7\nM30\n")
    files = sorted(tmp_path.glob("*.nc"))
    table = cncsub.run_many(files, control, jobs=2)
    assert list(table.to_pandas()["number"]) == ["PS9078"] * 2


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("", "must be small letters"),
        ('base = "fanuc-0i-f"\ncalls.M60 = "call:1"', "calls needs a control with a name"),
        ('base = "fanuc-0i-f"\ntitle = "x"', "title needs a control with a name"),
        ('base = "fanuc-0i-f"\nrules = 1', "rules must be a table, not 1"),
        (
            'base = "fanuc-0i-f"\nrules.max_nesting = {value = 2, note = "x"}',
            "rules.max_nesting must be a value: notes are for a control with a name",
        ),
        ('base = "fanuc-0i-f"\nrules.max_nestng = 2', "did you mean max_nesting"),
        ('name = "Our Mill"\nbase = "fanuc-0i-f"', "this one is 'Our Mill'"),
        ('name = "fanuc-0i-f"\nbase = "fanuc-0i-f"', "is a built-in control"),
        ('name = "our-mill"', "base must be a built-in control, such as"),
        (
            'name = "our-mill"\nbase = "fanuc-0i-g"',
            "there is no control 'fanuc-0i-g'; did you mean",
        ),
        ('name = "our-mill"\nbase = "fanuc-0i-f"\nrule = 1', "has no 'rule'; did you mean rules"),
        ('name = "our-mill"\nbase = "fanuc-0i-f"\ntitle = 1', "title must be a text"),
        ('name = "our-mill"\nbase = "fanuc-0i-f"\nrules = 1', "rules must be a table, not 1"),
        ('name = "our-mill"\nbase = "fanuc-0i-f"\nrules.max_nestin = 1', "max_nestin"),
        ('name = "our-mill"\nbase = "fanuc-0i-f"\nrules.max_nesting = 1.5', "a whole number"),
        ('name = "our-mill"\nbase = "fanuc-0i-f"\nrules.max_nesting = "x"', "max_nesting"),
        (
            'name = "our-mill"\nbase = "fanuc-0i-f"\nrules.max_nesting = {note = "x"}',
            'rules.max_nesting must be a value, or {value = ..., note = "..."}',
        ),
        (
            'name = "our-mill"\nbase = "fanuc-0i-f"\nrules.max_nesting = {value = 1, note = 2}',
            "a note must be a text",
        ),
        ('name = "our-mill"\nbase = "gsk-928te"\nrules.max_loops = 1', "has no rules of macros"),
        ('name = "our-mill"\nbase = "linuxcnc"\ncalls.M60 = "call:1"', "does not use the rule"),
        ('name = "our-mill"\nbase = "fanuc-0i-f"\nparameters.1 = 2', "parameter"),
        ('name = "our-mill"\nbase = "fanuc-0i-f"\nparameters."6005#0" = true', "must be a number"),
        (
            'name = "our-mill"\nbase = "fanuc-0i-f"\ncalls.X1 = "call:1"',
            "a code that calls must be",
        ),
        ('name = "our-mill"\nbase = "fanuc-0i-f"\ncalls.M60 = 9001', "calls.M60 must be call:9001"),
        ('name = "our-mill"\nbase = "fanuc-0i-f"\nalarms.program-not = "1"', "there is no cause"),
        (
            'name = "our-mill"\nbase = "fanuc-0i-f"\nalarms.program-not-found = 76',
            "must be a number, or",
        ),
        (
            'name = "our-mill"\nbase = "fanuc-0i-f"\nalarms.program-not-found = {number = ""}',
            "a text that can be printed",
        ),
        ("control = 5", "must be a table with name and base, not 5"),
        ("[tool]\ncncsub = 5", "must be a table with name and base, not 5"),
        ("name = ", "our-mill.toml: "),
    ],
)
def test_what_no_control_can_be_is_told(text: str, told: str, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="our-mill.toml: ") as caught:
        of(text, tmp_path)
    assert told in str(caught.value)


def test_any_value_anywhere_is_a_value_error(tmp_path: Path) -> None:
    values = ["0", "-1", "1e400", "nan", "true", '""', '"x"', "[]", "{}", "[[1]]", "1979-05-27"]
    values += ["9223372036854775808", '"\\u0000"', "{value = {}}", "{note = []}"]
    keys = ["name", "base", "title", "rules", "parameters", "calls", "alarms", "rules.max_nesting"]
    keys += ['parameters."6005#0"', "calls.M60", "alarms.program-not-found", 'rules.""', "calls.T"]
    for key in keys:
        for value in values:
            lines = {"name": '"our-mill"', "base": '"fanuc-0i-f"'} | {key: value}
            text = "".join(f"{name} = {of}\n" for name, of in lines.items())
            with contextlib.suppress(ValueError):  # nothing else is raised
                made = of(text, tmp_path)
                assert pickle.loads(pickle.dumps(made)).name == made.name


# ---- places that name the control ----

PROJECT = "[control]\n" + SHEET.replace("[", "[control.")


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "cncsub.toml").write_text(PROJECT)
    (tmp_path / "O1.nc").write_text("O1\nM98 P7\nM30\n")
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("CNCSUB_CONTROL", raising=False)
    return tmp_path


def told_by(*arguments: str) -> tuple[int, str]:
    done = CliRunner().invoke(app, list(arguments))
    return done.exit_code, done.output


@pytest.mark.usefixtures("project")
def test_the_commands_take_that_of_the_project() -> None:
    for more in ((), ("-c", "our-mill")):
        status, told = told_by("run", "O1.nc", *more)
        assert status == 1
        assert "PS9078" in told
    assert "PS0078" not in told_by("check", "O1.nc")[1]
    assert "PS9078" not in told_by("run", "O1.nc", "-c", "fanuc-0i-f")[1]
    status, told = told_by("run", "O1.nc", "-c", "our-mil")
    assert (status, "did you mean our-mill" in told) == (2, True)


@pytest.mark.usefixtures("project")
def test_it_is_printed_with_its_notes() -> None:
    assert "our-mill" in told_by("controls")[1]
    status, told = told_by("controls", "our-mill", "--all")
    assert status == 0
    for note in ("the sheet of the builder, page 12", "the pallet changer", "seen on the screen"):
        assert note in " ".join(told.split())
    status, told = told_by("controls", "our-mill", "--diff", "fanuc-0i-f")
    assert (status, "max_nesting" in told) == (0, True)


def test_a_table_of_cases_and_the_fixture_take_it(
    project: Path, pytester: pytest.Pytester, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(pytester.path)
    (pytester.path / "cncsub.toml").write_text(PROJECT)
    (pytester.path / "shop.nctest.toml").write_text(
        '[[case]]\nclaim = "M60 calls the pallet changer"\ncontrol = "our-mill"\n'
        'program = "O1\\nN10 M60\\nN20 M30\\nO9020\\nN30 #500=7\\nN40 M99"\n'
        'runs = "N10 N30 N40 N20"\n'
    )
    pytester.makepyfile(
        'def test_it(cnc):\n    assert cnc.control == "our-mill"\n'
        '    cnc.run("O1\\nM98 P7\\nM30\\n").assert_alarm("program-not-found")\n'
    )
    pytester.runpytest("--control", "our-mill").assert_outcomes(passed=2)


def test_a_project_says_what_is_wrong_with_it(project: Path) -> None:
    (project / "cncsub.toml").write_text('[control]\nname = "our-mill"\nbase = "fanuc"\n')
    status, told = told_by("run", "O1.nc")
    assert (status, "'fanuc' may be fanuc-0i-d, " in told) == (2, True)
