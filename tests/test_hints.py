"""What leads on from an alarm, and options that had no effect."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from cncsub.cli import app

CONTROL = "fanuc-0i-f"


def run(tmp_path: Path, text: str, *options: str) -> tuple[str, str]:
    file = tmp_path / "main.nc"
    file.write_text(text)
    done = CliRunner().invoke(app, ["run", str(file), "-c", CONTROL, *options])
    return done.stdout, done.stderr


def hints(told: str) -> list[str]:
    return [line.removeprefix("hint: ") for line in told.splitlines() if line.startswith("hint: ")]


def test_m198_without_a_device_leads_to_external(tmp_path: Path) -> None:
    (told, *_) = hints(run(tmp_path, "O1\nM198 P9\nM30\n")[1])
    assert told.startswith("--external FOLDER")


def test_a_program_on_the_other_side_is_named(tmp_path: Path) -> None:
    (tmp_path / "usb").mkdir()
    (tmp_path / "usb" / "O0009").write_text("O9\nM99\n")
    text = "O1\nM98 P9\nM30\n"
    told = hints(run(tmp_path, text, "--external", str(tmp_path / "usb"))[1])
    assert told == ["O9 is on the external device, where M198 calls it"]


def test_a_file_beside_the_program_is_named(tmp_path: Path) -> None:
    (tmp_path / "o0009.nc").write_text("O9\nM99\n")
    (told,) = hints(run(tmp_path, "O1\n#1=9\nM98 P#1\nM30\n")[1])
    assert told == f"{tmp_path / 'o0009.nc'} was not read: name it, or its folder, too"


def test_the_parameter_that_allows_a_block_is_named_and_does(tmp_path: Path) -> None:
    text = "O1\nN10 IF[[#1 EQ #0]AND[#2 EQ #0]] GOTO 20\nN20 M30\n"
    told = hints(run(tmp_path, text)[1])
    assert any(hint.startswith("--param 6006#0=1 lets it pass") for hint in told)
    assert "the program ended" in run(tmp_path, text, "--param", "6006#0=1")[0]


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("0 BEGIN PGM A MM\n1 L X+10 R0 FMAX\n", "Heidenhain"),
        ("R1=5\nG0 X=R1\nM17\n", "-c siemens-one"),
        ("G0 X1\n#<depth>=5\nM2\n", "-c linuxcnc"),
        ("CALL O9000 PX=1\nM02\n", "Okuma"),
    ],
)
def test_the_language_a_program_seems_to_be_written_in(
    tmp_path: Path, text: str, told: str
) -> None:
    assert told in run(tmp_path, text)[1]


def test_no_alarm_has_no_hints(tmp_path: Path) -> None:
    assert run(tmp_path, "O1\nM30\n")[1] == ""


@pytest.mark.parametrize(
    ("text", "options", "told"),
    [
        ("O1\n#101=#100\nM30\n", ["--set", "100=1", "--set", "105=1"], ["no block reads #105"]),
        ("O1\n#101=#[#1+1]\nM30\n", ["--set", "105=1", "--set", "1=1"], []),
        ("O1\nM30\n", ["--skip", "1", "--optional-stop"], ["has a slash", "has M01"]),
        ("O1\n/M01\nM30\n", ["--skip", "1", "--optional-stop"], []),
        ("O1\nM30\n", ["--inputs", "in.toml"], ["waits for a skip signal", "answer to M117"]),
        ("O1\nG31 X5. F100\nM117\nM30\n", ["--inputs", "in.toml"], []),
        ("O1\nM30\n", ["--external", "usb"], ["by M198"]),
    ],
)
def test_options_without_effect_are_told(
    tmp_path: Path, text: str, options: list[str], told: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "usb").mkdir()
    (tmp_path / "usb" / "O9").write_text("O9\nM99\n")
    (tmp_path / "in.toml").write_text("skips = [0.5]\nanswers = { M117 = { 1004 = 1 } }\n")
    out, error = run(tmp_path, text, *options, "--format", "json")
    notes = [note["message"] for note in json.loads(out)["notes"] if note["kind"] == "no-effect"]
    assert len(notes) == len(told)
    assert all(words in note for words, note in zip(told, notes, strict=True))
    assert error.count("no effect") == len(told)


def test_a_main_program_that_ends_in_m99_sounds_like_no_fault(tmp_path: Path) -> None:
    out, _ = run(tmp_path, "O1\nG4 X1.\nM99\n")
    assert "stopped: M99 starts the program over, all cycles asked for ran" in out


def explain(*words: str) -> str:
    return CliRunner().invoke(app, ["explain", *words]).output


def test_explain_knows_the_alarms_that_programs_raise_themselves() -> None:
    assert explain("MC3020").startswith("user-alarm")
    assert "fanuc-0i-f" in explain("MC3020", "-c", CONTROL)
    assert "no alarm or cause" in explain("MC9020", "-c", CONTROL)


def test_explain_tells_the_number_that_is_taken_for_another() -> None:
    assert "beside it: PS0310 named-program-not-found" in explain("PS0076", "-c", CONTROL)


def test_a_control_that_the_project_names_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("CNCSUB_CONTROL", raising=False)
    (tmp_path / "cncsub.toml").write_text('control = "fanuc-16i"\n')
    (tmp_path / "p.nc").write_text("O1\nM30\n")
    done = CliRunner().invoke(app, ["run", "p.nc", "--format", "json"])
    assert [note["kind"] for note in json.loads(done.stdout)["notes"]] == ["defaulted"]
    assert "the control is fanuc-16i, which the project names" in done.stderr
    assert CliRunner().invoke(app, ["run", "p.nc", "-c", CONTROL]).stderr == ""
