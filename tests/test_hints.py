"""Hints after an alarm, and options that had no effect."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app
from cncsub.reports.hints import changed_controls

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
    assert told.startswith("give --external FOLDER")


def test_a_program_on_the_other_side_is_named(tmp_path: Path) -> None:
    (tmp_path / "usb").mkdir()
    (tmp_path / "usb" / "O0009").write_text("O9\nM99\n")
    text = "O1\nM98 P9\nM30\n"
    told = hints(run(tmp_path, text, "--external", str(tmp_path / "usb"))[1])
    assert told == ["O9 is on the external device, where M198 calls it"]


def test_a_file_beside_the_program_is_named(tmp_path: Path) -> None:
    (tmp_path / "o0009.nc").write_text("O9\nM99\n")
    (told,) = hints(run(tmp_path, "O1\n#1=9\nM98 P#1\nM30\n")[1])
    assert told == f"{tmp_path / 'o0009.nc'} was not read: give it, or its folder, too"


def test_a_file_in_a_folder_beside_the_program_is_named(tmp_path: Path) -> None:
    (tmp_path / "macros").mkdir()
    (tmp_path / "macros" / "O9100.nc").write_text("O9100\nM99\n")
    (told,) = hints(run(tmp_path, "O1\nG65 P9100\nM30\n")[1])
    assert told.startswith(f"{tmp_path / 'macros' / 'O9100.nc'} was not read")


def test_the_parameter_that_allows_a_block_is_named_and_does(tmp_path: Path) -> None:
    text = "O1\nN10 IF[[#1 EQ #0]AND[#2 EQ #0]] GOTO 20\nN20 M30\n"
    told = hints(run(tmp_path, text)[1])
    assert any(hint.startswith("--param 6006#0=1 allows it") for hint in told)
    assert "the program ended" in run(tmp_path, text, "--param", "6006#0=1")[0]


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("0 BEGIN PGM A MM\n1 L X+10 R0 FMAX\n", "Heidenhain"),
        ("R1=5\nG0 X=R1\nM17\n", "-c siemens-one"),
        ("G0 X1\n#<depth>=5\nM2\n", "-c linuxcnc"),
        ("CALL O9 PX=1\nM02\nO9\nG0 X=PX\nRTS\n", "-c okuma-osp-p300"),
        ("O1\nIF[#100 EQ 1]THEN\n#1=1\nELSE\n#1=2\nENDIF\nM30\n", "-c mitsubishi-m800"),
        ("%1\n; PART\nIF #1 EQ 0\n#2=1\nELSE\n#2=2\nENDIF\nM30\n", "-c hnc-21m"),
        ("%\nN1O1(PART)\nN2 G0 X1.\nN3 #V1=5\nN4 #IF V1 > 3 THEN GOTO :END\nM30\n", "Fadal"),
        ("%PART,MX--,\n(P100=5)\n(IF P100 EQ 5 GOTO N10)\nG0 X10\nN10 M30\n", "Fagor"),
        ("@100=5\nG0 X1.\nM30\n", "LNC"),
        # Two parts have one name: nothing runs, but the hint names the language.
        ("o11 sub\no11 endsub\no11 call\nM2\n", "-c linuxcnc"),
        ("%_N_A_MPF\nM30\n%_N_B_SPF\nM17\n", "-c siemens-one"),
    ],
)
def test_the_language_a_program_seems_to_be_written_in(
    tmp_path: Path, text: str, told: str
) -> None:
    assert told in run(tmp_path, text)[1]


def test_a_code_of_other_controls_tells_which_have_it(tmp_path: Path) -> None:
    (told,) = hints(run(tmp_path, "O1\nG61.1\nM30\n")[1])
    assert told.startswith("G61.1 is a code of ")
    assert "mitsubishi-m800" in told
    assert "fanuc" not in told
    assert hints(run(tmp_path, "O1\nG999\nM30\n")[1]) == []


def test_the_tools_of_a_mill_whose_d_names_their_edges_are_of_use(tmp_path: Path) -> None:
    (tmp_path / "tools.toml").write_text("[tools.1]\nZ = 100\n[length_offsets]\n2 = 5\n")
    text = "T1 M6\nG0 Z50\nM30\n"
    options = ["--setup", str(tmp_path / "tools.toml"), "-c", "siemens-one"]
    assert "no effect" not in run(tmp_path, text, *options)[1]


def test_no_alarm_has_no_hints(tmp_path: Path) -> None:
    assert run(tmp_path, "O1\nM30\n")[1] == ""


@pytest.mark.parametrize(
    ("text", "options", "told"),
    [
        ("O1\n#101=#100\nM30\n", ["--set", "100=1", "--set", "105=1"], ["no block reads #105"]),
        ("O1\n#101=#[#1+1]\nM30\n", ["--set", "105=1", "--set", "1=1"], []),
        ("O1\nM30\n", ["--skip", "1", "--optional-stop"], ["has a slash", "has M01"]),
        ("O1\n/M01\nM30\n", ["--skip", "1", "--optional-stop"], []),
        ("O1\nM30\n", ["--inputs", "in.toml"], ["no block probes", "answer to M117"]),
        ("O1\nG31 X5. F100\nM117\nM30\n", ["--inputs", "in.toml"], []),
        ("O1\nM30\n", ["--external", "usb"], ["by M198"]),
        ("O1\nM30\n", ["--setup", "lathe.toml"], ["`tools` are offsets of a lathe"]),
        ("O1\nM30\n", ["--setup", "mill.toml"], ["`radius_offsets` are offsets of a mill"]),
    ],
)
def test_options_without_effect_are_told(
    tmp_path: Path, text: str, options: list[str], told: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "usb").mkdir()
    (tmp_path / "usb" / "O9").write_text("O9\nM99\n")
    (tmp_path / "in.toml").write_text("skips = [0.5]\nanswers = { M117 = { 1004 = 1 } }\n")
    (tmp_path / "lathe.toml").write_text("[tools.1]\nR = 0.4\n[length_offsets]\n1 = 5\n")
    (tmp_path / "mill.toml").write_text(
        'machine = "lathe-a"\n[tools.1]\nR = 0.4\n[radius_offsets]\n1 = 5\n'
    )
    out, error = run(tmp_path, text, *options, "--format", "json")
    notes = [note["message"] for note in json.loads(out)["notes"] if note["kind"] == "no-effect"]
    assert len(notes) == len(told)
    assert all(words in note for words, note in zip(told, notes, strict=True))
    assert error.count("no effect") == len(told)


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        (
            "O9120\nN10 G0 X#1 Y#2\nN20 M99\n",
            "O9120 reads the arguments A, B, and has none as the main program: call it with --mdi"
            ' "G65 P9120 A... B..."',
        ),
        ("O9120\nN10 IF[#11 NE #0]GOTO30\nN20 #3000=1\nN30 M99\n", 'G65 P9120 H..."'),
        ("O9120\nN10 #1=1.\nN20 G0 X#1\nN30 M99\n", None),  # it gives the value itself
        ("O9120\nN10 G0 X#1\nN20 M30\n", None),  # it ends as a main program does
        ("O9120\nN10 G0 X#101\nN20 M99\n", None),
    ],
)
def test_a_macro_that_runs_as_the_main_program_leads_to_its_call(
    tmp_path: Path, text: str, hint: str | None
) -> None:
    (tmp_path / "O9120.nc").write_text(text)
    told = CliRunner().invoke(app, ["run", str(tmp_path), "-c", "fanuc-0i-f"]).stderr
    assert hint in told if hint is not None else "arguments" not in told, told


def test_where_mdi_calls_nothing_no_macro_leads_there(tmp_path: Path) -> None:
    (tmp_path / "O9120.nc").write_text("O9120\nN10 G0 X#1\nN20 M99\n")
    told = CliRunner().invoke(app, ["run", str(tmp_path), "-c", "gsk-988t"]).stderr
    assert told == ""


def test_a_main_program_that_ends_in_m99_sounds_like_no_fault(tmp_path: Path) -> None:
    out, _ = run(tmp_path, "O1\nG4 X1.\nM99\n")
    assert "stopped: M99 starts the program over, and all passes asked for have run" in out


def explain(*words: str) -> str:
    return CliRunner().invoke(app, ["explain", *words]).output


def test_explain_knows_the_alarms_that_programs_raise_themselves() -> None:
    assert explain("MC3020").startswith("user-alarm")
    assert "fanuc-0i-f" in explain("MC3020", "-c", CONTROL)
    assert "no code, alarm, cause, rule or parameter" in explain("MC9020", "-c", CONTROL)


def test_explain_tells_all_that_four_figures_may_mean() -> None:
    told = explain("3020")
    assert "gsk-980mdi: 3011" in told
    assert "fanuc-0i-f: MC3020 the message that the program gives" in told


def test_explain_tells_the_number_that_is_taken_for_another() -> None:
    assert "similar: PS0310 named-program-not-found" in explain("PS0076", "-c", CONTROL)


def test_a_control_that_the_project_names_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("CNCSUB_CONTROL", raising=False)
    (tmp_path / "cncsub.toml").write_text('control = "fanuc-16i"\n')
    (tmp_path / "p.nc").write_text("O1\nM30\n")
    done = CliRunner().invoke(app, ["run", "p.nc", "--format", "json"])
    assert [note["kind"] for note in json.loads(done.stdout)["notes"]] == ["defaulted"]
    assert "the control is fanuc-16i, from the project file" in done.stderr
    assert CliRunner().invoke(app, ["run", "p.nc", "-c", CONTROL]).stderr == ""


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("O1\nN10 IF[#1000 EQ 0]GOTO10\nM30\n", "signals = { 1000 = 1 }"),
        ("O1\nN10 IF[#1000 EQ 1]GOTO10\nM30\n", ""),  # the signal is 0 until a user sets it
        ("O1\n#500=0\nN10 IF[#500 EQ 0]GOTO10\nM30\n", "writes = [{ 500 = 1 }]"),
    ],
)
def test_what_a_run_waits_for_leads_to_a_line_that_answers(
    tmp_path: Path, text: str, line: str
) -> None:
    told = hints(run(tmp_path, text)[1])
    assert told == (
        [f"give the answer with --inputs FILE, a file with a line such as {line}"] if line else []
    )
    if line:
        (tmp_path / "in.toml").write_text(line + "\n")
        assert "the program ended" in run(tmp_path, text, "--inputs", str(tmp_path / "in.toml"))[0]


@pytest.mark.parametrize("asked", ["", " "])
def test_explain_of_nothing_explains_nothing(asked: str) -> None:
    assert "no code, alarm, cause, rule or parameter is called" in explain(asked)


# ---- the parameters that a hint may recommend ----


def test_no_hint_makes_a_program_mean_something_else(tmp_path: Path) -> None:
    (tmp_path / "limits.toml").write_text("[limits]\nX = [-10, 500]\n")
    setup = ["--setup", str(tmp_path / "limits.toml")]
    # With G91 at power-on (3402#3) or another unit (3401#0) these would stop elsewhere, or not.
    for text in ("O1\nG0 X600.\nM30\n", "O1\nG0 X10000.\nM30\n", "O1\nX400.\nG0 X600.\nM30\n"):
        for control in ("fanuc-0i-f", "fanuc-30i", "gsk-988t"):
            file = tmp_path / "main.nc"
            file.write_text(text)
            done = CliRunner().invoke(app, ["run", str(file), "-c", control, *setup])
            assert "over-travel" in done.stdout
            assert hints(done.stderr) == []


PERMITTED = {  # bits that allow or refuse, and never change a meaning
    *("1202#2", "3404#6", "5006#1", "6000#0", "6005#0", "6006#0", "7712#4"),
}


def test_parameters_that_hints_may_name_allow_or_refuse_a_form_of_writing() -> None:
    named = {
        words.split()[1].partition("=")[0]
        for control in cncsub.controls.values()
        for words, _ in changed_controls(control)
        if words.startswith("--param")
    }
    assert named == PERMITTED


@pytest.mark.parametrize(
    "condition", ["[#1 EQ #0 AND #2 EQ #0]", "[#1 EQ #0] AND [#2 EQ #0]", "[#1EQ#0]OR[#2EQ#0]"]
)
def test_conditions_joined_in_the_way_of_another_language_lead_to_the_own_one(
    tmp_path: Path, condition: str
) -> None:
    (told,) = hints(run(tmp_path, f"O1\nIF {condition} GOTO 20\nG1 X1. F100\nN20 M30\n")[1])
    assert told.startswith("write joined conditions as IF[[#1EQ#2]AND[#3EQ#4]]")
    assert "--param 6006#0=1" in told
    assert "linuxcnc" not in told


def test_what_joins_no_conditions_is_not_taken_for_it(tmp_path: Path) -> None:
    out, error = run(tmp_path, "O1\nIF[#500 GT 1E9]GOTO20 (AND SO ON)\nN20 M30\n")
    assert "an operator or a closing bracket is missing" in out
    assert hints(error) == []


def test_what_was_typed_has_hints_and_idle_options_too(tmp_path: Path) -> None:
    def typed(text: str, *options: str) -> list[str]:
        done = CliRunner().invoke(app, ["run", *options, "--mdi", text, "-c", CONTROL])
        return [line for line in done.stderr.splitlines() if not line.startswith("stopped")]

    (told,) = typed("IF[[#1EQ1]AND[#2EQ2]]GOTO1")
    assert told.startswith("hint: --param 6006#0=1 allows it")
    (tmp_path / "O9.nc").write_text("O9\nM99\n")
    (tmp_path / "O1.nc").write_text("O1\nM30\n")
    assert typed("M98 P9", str(tmp_path / "O1.nc")) == [
        f"hint: {tmp_path / 'O9.nc'} was not read: give it, or its folder, too"
    ]
    (told,) = typed("G0 X#100", "--set", "100=5", "--set", "101=5")
    assert "no block reads #101" in told
    (told,) = typed("M198 P9")
    assert told.startswith("hint: give --external FOLDER")


def test_options_without_effect_are_told_by_every_command_that_runs(tmp_path: Path) -> None:
    file = tmp_path / "main.nc"
    file.write_text("O1\nM98 P2\nM30\nO2\nG1 X1. F100\nM99\n")
    out = str(tmp_path / "out")
    for words in (
        ["run", "--listing"],
        ["run", "--format", "csv"],
        ["tree"],
        ["coverage"],
        ["flatten"],
        ["report", "-o", out],
        ["plot", "-o", out],
        ["compare", "-c", "fanuc-30i"],
    ):
        words = [words[0], str(file), "-c", CONTROL, "--optional-stop", *words[1:]]
        assert "no block has M01" in CliRunner().invoke(app, words).stderr, words


def test_a_link_has_the_files_beside_what_it_leads_to(tmp_path: Path) -> None:
    (tmp_path / "job").mkdir()
    (tmp_path / "job" / "O1.nc").write_text("O1\nM98 P7\nM98 P8\nM30\n")
    (tmp_path / "job" / "O7.nc").write_text("O7\nM99\n")
    (tmp_path / "O8.nc").write_text("O8\nM99\n")
    link = tmp_path / "link.nc"
    try:
        link.symlink_to(tmp_path / "job" / "O1.nc")
    except OSError:
        pytest.skip("this system makes no links")
    done = CliRunner().invoke(app, ["run", str(link), "-c", CONTROL])
    assert done.exit_code == 0
    assert "O7.nc: also read" in done.stderr
    assert "O8.nc: also read" in done.stderr


FOREIGN = {
    "Heidenhain": "0 BEGIN PGM A MM\n1 L X+10 R0 FMAX\n",
    "Heidenhain (Klartext)": "TOOL CALL 5 Z S2000\nL X+10 Y-5 R0 FMAX M3\nCALL LBL 1\n",
    "Mazatrol": "UNo. MAT INITIAL-Z ATC MODE MULTI MODE\n 0 CST IRN 100. 0 OFF\n",
    "Fagor": "%PART,MX--,\n(P100=5)\nG0 X10\nM30\n",
    "Fadal": "N1O1(PART)\nN2 #V1=5\nM30\n",
    "LNC": "@100=5\nM30\n",
}


@pytest.mark.parametrize("language", FOREIGN)
def test_a_language_that_no_control_reads_is_told_by_check_too(
    tmp_path: Path, language: str
) -> None:
    file = tmp_path / "part.nc"
    file.write_text(FOREIGN[language])
    done = CliRunner().invoke(app, ["check", str(file), "-c", CONTROL])
    assert f"it seems to be written in the language of {language}" in done.stderr
    own = "O1\n(IF THE TOOL BREAKS CALL 5)\n(SUB 5)\nG0 X1.\nM30\n"
    file.write_text(own)
    assert CliRunner().invoke(app, ["check", str(file), "-c", CONTROL]).stderr == ""


def test_a_language_that_no_control_reads_is_told_in_a_batch(tmp_path: Path) -> None:
    for language, text in FOREIGN.items():
        (tmp_path / f"{language}.nc").write_text(text)
    (tmp_path / "own.nc").write_text("O1\nM30\n")
    from concurrent.futures import ThreadPoolExecutor

    with ThreadPoolExecutor(2) as pool:
        table = cncsub.run_many([tmp_path], control=CONTROL, executor=pool)
    told = {Path(row["path"]).stem: row["error"] for row in table.to_pylist()}
    assert told.pop("own") is None
    assert all(f"language of {language}" in (told[language] or "") for language in FOREIGN)


def test_a_language_that_no_control_reads_is_told_of_each_file_of_a_folder(tmp_path: Path) -> None:
    (tmp_path / "a.nc").write_text("O1\nG0 X1.\nM30\n")
    (tmp_path / "b.nc").write_text("%PART,MX--,\n(P100=5)\nG0 X10.\nM30\n")
    told = CliRunner().invoke(app, ["check", str(tmp_path), "-c", CONTROL]).stderr
    assert f"hint: {tmp_path / 'b.nc'} seems to be written in the language of Fagor" in told


def test_a_language_that_no_control_reads_is_told_where_a_batch_finds_nothing(
    tmp_path: Path,
) -> None:
    (tmp_path / "b.nc").write_text("%PART,MX--,\n(P100=5)\nG0 X10.\nM30\n")
    (tmp_path / "own.nc").write_text("O1\nM30\n")
    for words in (["--check"], []):
        done = CliRunner().invoke(app, ["batch", str(tmp_path), "-c", CONTROL, *words])
        assert done.exit_code == 0, done.output
        assert done.output.count("language of Fagor") == 1


SINUMERIK = (
    "DEF REAL DEPTH\nG0 X10\nM30\n",
    "G0 X=R1\nM30\n",
    "N10 G0 X10\nN20 IF R1>5 GOTOF END\nN30 X20\nEND: M30\n",
    "N10 T1 M6\nN20 MCALL CYCLE81(10,0,2,-5)\nN30 X10 Y10\nN40 MCALL\nN50 M30\n",
    "G90 G0 X0\nCYCLE83(10,0,2,-20)\nM30\n",
)


@pytest.mark.parametrize("text", SINUMERIK)
def test_a_program_of_sinumerik_is_told_by_run_and_by_check(tmp_path: Path, text: str) -> None:
    file = tmp_path / "part.nc"
    file.write_text(text)
    for command in ("run", "check"):
        told = CliRunner().invoke(app, [command, str(file), "-c", CONTROL]).stderr
        assert "it seems to be written for SINUMERIK: -c siemens-one" in told, command


def test_the_language_of_one_file_of_a_folder_is_told(tmp_path: Path) -> None:
    (tmp_path / "a.nc").write_text("O1\nG0 X1.\nM30\n")
    (tmp_path / "b.nc").write_text(SINUMERIK[1])
    told = CliRunner().invoke(app, ["check", str(tmp_path), "-c", CONTROL]).stderr
    assert f"{tmp_path / 'b.nc'}: it seems to be written for SINUMERIK" in told


@pytest.mark.parametrize("block", ["N10 M98 P2 Q100", "N10 M98 Q100"])
def test_a_finding_tells_the_parameter_behind_which_it_is_gone(tmp_path: Path, block: str) -> None:
    file = tmp_path / "part.nc"
    file.write_text(f"O1\n{block}\nM30\nN100 M99\nO2\nG4 P1\nN100 M99\n")
    words = ["check", str(file), "-c", CONTROL]
    assert "hint: --param 6005#0=1 allows it" in CliRunner().invoke(app, words).stdout
    done = CliRunner().invoke(app, [*words, "--param", "6005#0=1", "--ignore", "CS3"])
    assert done.exit_code == 0, done.stdout


def test_a_code_is_told_of_controls_that_compute_it(tmp_path: Path) -> None:
    for code in ("G61.1", "G5.1", "G12.1", "G43.4", "G107"):
        for hint in hints(run(tmp_path, f"O1\n{code}\nM30\n")[1]):
            for name in hint.rpartition(" of ")[2].split(", "):
                found = cncsub.loads(f"N1 {code}\n", control=name).check(rules=["CS102", "CS105"])
                assert found == [], (code, name)


def test_a_program_of_another_control_is_told_by_check(tmp_path: Path) -> None:
    file = tmp_path / "part.nc"
    file.write_text("o100 sub\ng0 x1\no100 endsub\n#<a>=1\no100 call\nm2\n")
    told = CliRunner().invoke(app, ["check", str(file), "-c", CONTROL]).stderr
    assert "it seems to be written for LinuxCNC: -c linuxcnc" in told
    assert CliRunner().invoke(app, ["check", str(file), "-c", "linuxcnc"]).stderr == ""


@pytest.mark.parametrize("code", ["G96 S200", "G71 U1. R1.", "G97 S500"])
def test_a_program_of_a_lathe_is_told_that_the_control_is_a_mill(tmp_path: Path, code: str) -> None:
    file = tmp_path / "main.nc"
    file.write_text(f"O1\nG0 X1.\n{code}\nM30\n")
    told = CliRunner().invoke(app, ["run", str(file), "-c", "haas-ngc"]).stderr
    assert "haas-ngc exists only as a mill" in told
