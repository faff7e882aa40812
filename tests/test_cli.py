"""The command line: what it prints, what it writes, and its exit status."""

from __future__ import annotations

import csv
import io
import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app

CONTROL = "fanuc-0i-f"
GOOD = """O1
N10 M98 P2 L5
N20 G65 P3 A1.
N30 M30
O2
N40 G91 G1 X10. F100.
N50 M99
O3
N60 #3006=1(CHECK)
N70 M98 P2
N80 M99
"""
BAD = "O1\nN10 M98 P2\nO2\nN20 M98 P9\n"


@pytest.fixture
def job(tmp_path: Path) -> Path:
    (tmp_path / "good.nc").write_text(GOOD)
    (tmp_path / "bad.nc").write_text(BAD)
    (tmp_path / "endless.nc").write_text("O1\nN10 G4 X1.\nN20 M99\n")
    return tmp_path


class Done:
    """The result of a call of the command line."""

    def __init__(self, *arguments: object) -> None:
        result = CliRunner().invoke(app, [str(argument) for argument in arguments])
        if result.exception is not None and not isinstance(result.exception, SystemExit):
            raise result.exception
        self.status: int = result.exit_code
        self.out: str = result.stdout
        self.error: str = result.stderr

    @property
    def json(self) -> Any:
        return json.loads(self.out)


def test_a_run_is_a_tree_of_calls_and_how_it_stopped(job: Path) -> None:
    done = Done("run", job / "good.nc", "-c", CONTROL)
    assert done.status == 0
    title = cncsub.controls[CONTROL].title
    assert done.out.splitlines() == [
        f"O1 on {title}",
        "|-- M98 O2, 5 passes (10 blocks)",
        "`-- G65 O3 (5 blocks)",
        "    `-- M98 O2 (2 blocks)",
        "stopped: the program ended, after 18 blocks",
        "6 moves, length 60.000 mm, time 36.0 s",
        "  X 10 to 60",
        "message: CHECK",
    ]


def test_an_alarm_is_printed_whole_and_is_status_1(job: Path) -> None:
    done = Done("run", job / "bad.nc", "-c", CONTROL)
    assert done.status == 1
    run = cncsub.load(job / "bad.nc", control=CONTROL).run()
    assert str(run.alarm) in done.out
    assert "called from O1 N10 (M98)" in done.out
    assert "stopped: alarm, after" in done.out


@pytest.mark.parametrize(
    ("options", "status", "words"),
    [
        (
            [],
            0,
            "M99 starts the program over, and all passes asked for have run (--max-cycles), after 2 blocks",
        ),
        (["--max-cycles", "3"], 0, "after 6 blocks"),
        (["--max-cycles", "9", "--max-blocks", "5"], 4, "the limit of blocks or memory is reached"),
    ],
)
def test_the_exit_status_says_whether_it_ran_to_its_end(
    job: Path, options: list[str], status: int, words: str
) -> None:
    done = Done("run", job / "endless.nc", "-c", CONTROL, *options)
    assert done.status == status
    assert words in done.out


def test_a_run_that_waits_is_status_3_and_says_for_what(tmp_path: Path) -> None:
    file = tmp_path / "O1.nc"
    file.write_text("N10 IF[#500 EQ #0]GOTO10\nN20 M30\n")
    done = Done("run", file, "-c", CONTROL)
    assert done.status == 3
    assert "stopped: waiting for" in done.out
    assert Done("run", file, "-c", CONTROL, "--set", "500=1").status == 0


def test_options_reach_the_run(tmp_path: Path) -> None:
    file = tmp_path / "part.nc"
    file.write_text("O1\nN10 M30\nO2\n/N20 #101=#100\nN25 M1\nN30 M6 T3\nN40 M30\n")
    done = Done(
        *("run", file, "-c", CONTROL, "--main", "O2", "--set", "100=23.34", "--set", "#102=5"),
        *("--set", "103=vacant", "--start", "20", "--format", "json"),
    )
    assert done.status == 0
    assert done.json["variables"] == {"100": 23.34, "101": 23.34, "102": 5.0}
    assert done.json["steps"] == 4
    skipped = Done("run", file, "-c", CONTROL, "--main", "O2", "--skip", "1", "--format", "json")
    assert skipped.json["steps"] == 3


def test_a_parameter_changes_the_control(tmp_path: Path) -> None:
    file = tmp_path / "part.nc"
    file.write_text("O1\nN10 G70\nN20 M30\nO9010\nN30 M99\n")
    done = Done("run", file, "-c", CONTROL, "--param", "6050=70", "--format", "json")
    assert [call["program"] for call in done.json["calls"]] == ["O9010"]
    assert done.status == 0


def test_mdi_needs_no_program_and_takes_a_memory(job: Path) -> None:
    assert Done("run", "-c", CONTROL, "--mdi", "G4 X1.").status in (0, 1)
    done = Done("run", job / "good.nc", "-c", CONTROL, "--mdi", "M98 P2", "--format", "json")
    assert [call["program"] for call in done.json["calls"]] == ["O2"]


def test_the_external_device_is_read(tmp_path: Path) -> None:
    (tmp_path / "usb").mkdir()
    (tmp_path / "usb" / "O9.nc").write_text("N10 M99\n")
    (tmp_path / "O1.nc").write_text("N10 M198 P9\nN20 M30\n")
    done = Done("run", tmp_path / "O1.nc", "-c", CONTROL, "--external", tmp_path / "usb")
    assert done.status == 0
    assert "M198 O9" in done.out


def test_an_inputs_file_is_read_and_missed_skips_are_told(job: Path) -> None:
    program = (
        "O1\nN10 G31 X50. F100\nN20 G31 X90.\nN30 M98 P2 L3\nN40 M30\nO2\nN50 G31 Y1.\nN60 M99\n"
    )
    (job / "probe.nc").write_text(program)
    inputs = job / "inputs.toml"
    inputs.write_text("""
        skips = [{ X = 12.5 }, "never"]
        signals = { 1004 = 1 }
        writes = [{ 500 = 1 }, [2, { 501 = 1 }]]
        answers = { M117 = { 1005 = 1 } }
        [workpiece]
        stylus = 2
        solids = [{ box = { Y = [5, inf] } }, { plane = { Z = -900 }, faces = { Z = 1, X = 0.5 } }]
    """)
    done = Done("run", job / "probe.nc", "-c", CONTROL, "--inputs", inputs)
    assert done.status == 0
    assert done.out.splitlines()[-2:] == [
        "skip: O1 N20 got no skip signal",
        "skip: O2 N50 got no skip signal, 3 times",
    ]
    facts = Done(
        "run", job / "probe.nc", "-c", CONTROL, "--inputs", inputs, "--format", "json"
    ).json
    assert facts["missed_skips"][0] == {"step": 1, "program": "O1", "n": 20, "line": 3}
    assert [move["skip"] for move in facts["moves"]] == ["touched"] + ["missed"] * 4
    inputs.write_text("[workpiece]\nsolids = [{ sphere = { X = 1 } }]\n")
    done = Done("run", job / "probe.nc", "-c", CONTROL, "--inputs", inputs)
    assert done.status == 2
    assert done.error == f"cncsub: {inputs}: workpiece: solids[0], a sphere has no radius\n"


def test_a_setup_file_is_read(job: Path) -> None:
    setup = job / "setup.toml"
    setup.write_text("[limits]\nX = [-1, 5]\n")
    done = Done("run", job / "good.nc", "-c", CONTROL, "--setup", setup)
    assert done.status == 1
    assert "over-travel" in done.out


def test_json_has_the_whole_run(job: Path) -> None:
    facts = Done("run", job / "good.nc", "-c", CONTROL, "--format", "json").json
    assert (facts["stop"], facts["alarm"], facts["steps"]) == ("end", None, 18)
    assert [call["kind"] for call in facts["calls"]] == ["M98", "G65", "M98"]
    assert [move["x"] for move in facts["moves"]] == [10, 20, 30, 40, 50, 60]
    assert facts["length"] == pytest.approx(60)
    assert facts["bounds"]["X"] == [10, 60]
    assert facts["messages"] == ["CHECK"]
    alarm = Done("run", job / "bad.nc", "-c", CONTROL, "--format", "json").json["alarm"]
    assert (alarm["cause"], alarm["program"], alarm["n"]) == ("program-not-found", "O2", 20)
    assert alarm["frames"][0]["program"] == "O1"


def test_moves_are_written_as_csv_and_parquet(job: Path) -> None:
    done = Done("run", job / "good.nc", "-c", CONTROL, "--format", "csv")
    rows = list(csv.DictReader(io.StringIO(done.out)))
    assert [row["x"] for row in rows] == ["10.0", "20.0", "30.0", "40.0", "50.0", "60.0"]
    assert rows[0]["kind"] == "feed"
    assert rows[0]["cx"] == ""
    assert "stopped" in done.error
    from pyarrow import parquet

    file = job / "moves.parquet"
    Done("run", job / "good.nc", "-c", CONTROL, "--format", "parquet", "--output", file)
    assert parquet.read_table(file)["kind"].to_pylist() == ["feed"] * 6


def test_output_goes_to_a_file(job: Path) -> None:
    for format in ("text", "json", "csv"):
        file = job / f"out.{format}"
        done = Done("run", job / "good.nc", "-c", CONTROL, "--format", format, "-o", file)
        assert done.status == 0
        assert done.out == ""
        assert file.read_text()


def test_a_tree_is_drawn(job: Path) -> None:
    done = Done("tree", job / "good.nc", "-c", CONTROL)
    assert done.status == 0
    assert done.out.splitlines()[1:] == [
        "|-- M98 O2, 5 passes (10 blocks), from O1 N10",
        "`-- G65 O3 (5 blocks) A=1, from O1 N20",
        "    `-- M98 O2 (2 blocks), from O3 N70",
    ]
    facts = Done("tree", job / "good.nc", "-c", CONTROL, "--format", "json").json
    assert facts["calls"][1]["calls"][0]["program"] == "O2"
    broken = Done("tree", job / "bad.nc", "-c", CONTROL)
    assert broken.status == 1
    assert "M98 O2" in broken.out
    assert "program-not-found" in broken.error


def test_the_controls_are_listed() -> None:
    done = Done("controls")
    assert [line.split()[0] for line in done.out.splitlines()] == list(cncsub.controls)
    assert [c["name"] for c in Done("controls", "--format", "json").json] == list(cncsub.controls)


@pytest.mark.parametrize("name", list(cncsub.controls))
def test_a_control_is_shown_with_rules_parameters_and_alarms(name: str) -> None:
    control = cncsub.controls[name]
    out = Done("controls", name, "--all").out
    for rule in control.rules:
        assert all(f"{entry} [{source};" in out for entry, (source, _) in rule.sources.items())
    assert all(f"  {rule.name} = " in out for rule in control.rules)
    assert all(parameter in out for parameter in control.parameters)
    assert all(alarm.cause in out for alarm in control.alarms.values())
    assert out.count("; ") >= len(control.rules) + len(control.parameters) + len(control.alarms)
    facts = Done("controls", name, "--format", "json").json
    assert len(facts["rules"]) == len(control.rules)
    assert all(rule["source"] for rule in facts["rules"])
    assert all("evidence" in alarm for alarm in facts["alarms"])


@pytest.mark.parametrize("name", list(cncsub.controls))
def test_the_page_of_a_control_is_short_and_names_each_source_once(name: str) -> None:
    control = cncsub.controls[name]
    lines = Done("controls", name).out.splitlines()
    assert len(lines) <= 130
    assert max(map(len, lines)) <= 100
    title = "Variables by option"  # this part of the page names rules too
    above = lines[: lines.index(title)] if title in lines else lines
    heads = [re.split("[ ,:]", line[2:])[0] for line in above if line[:2] == "  " != line[1:3]]
    assert {rule.name for rule in control.rules if rule.value != rule.family} == (
        {rule.name for rule in control.rules} & set(heads)
    )
    changed = {parameter.name for parameter in control.parameters.values() if parameter.value}
    assert changed <= set(heads)
    below = lines[lines.index("Sources, and their evidence for this control") :]
    page = " ".join(lines[: -len(below)])
    keys = [line.split(" = ")[0].strip() for line in below if line[2:3].strip() and " = " in line]
    assert len(set(keys)) == len(keys)
    cited = set(re.findall(r"[^,]+", ",".join(re.findall(r"\s\[([^\[\]]+)\]", page))))
    assert keys[-1] == "?"
    assert {key.strip().rstrip("?") for key in cited} - {""} <= set(keys)


def test_what_a_page_leaves_out_is_printed_by_a_word_and_by_all() -> None:
    page = Done("controls", CONTROL).out
    assert "max_repeats" not in page
    assert "max_nesting = 10 (4): how many" in page
    assert "6038-6059" in page
    assert "max_repeats = " in Done("controls", CONTROL, "--all").out
    assert "max_repeats = " in Done("controls", CONTROL, "max_repeats").out
    rules = Done("controls", CONTROL, "--format", "json").json["rules"]
    assert {"name": "max_nesting", "group": "calls", "value": 10, "family": 4} in [
        {key: rule[key] for key in ("name", "group", "value", "family")} for rule in rules
    ]


def test_an_alarm_number_is_explained() -> None:
    out = Done("explain", "P232", "-c", "mitsubishi-m700").out
    cause = cncsub.causes["program-not-found"]
    assert "program-not-found" in out
    assert cause.meaning in out
    assert cause.cure in out
    assert "mitsubishi-m700: P232" in out
    assert "source" in out or "[" in out


def test_a_cause_is_explained_for_every_control() -> None:
    facts = Done("explain", "program-not-found", "--format", "json").json
    assert [fact["cause"] for fact in facts] == ["program-not-found"]
    told = {alarm["control"] for alarm in facts[0]["alarms"]}
    assert told == {c.name for c in cncsub.controls.values() if "program-not-found" in c.alarms}


def test_a_number_is_found_however_it_is_written() -> None:
    whole = Done("explain", "PS0076", "-c", CONTROL).out
    assert "PS0076" in whole
    for short in ("76", "076", "ps76", "ps0076"):
        assert "PS0076" in Done("explain", short, "-c", CONTROL).out


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["run", "{job}/good.nc"], "which control? Give -c and one of fanuc-0i-d"),
        (["run", "{job}/good.nc", "-c", "fanuc-0ig"], "did you mean fanuc-"),
        (["run", "{job}/god.nc", "-c", CONTROL], "good.nc"),
        (["run", "-c", CONTROL], "which program?"),
        (["run", "{job}/good.nc", "-c", CONTROL, "--main", "O20"], "did you mean O2"),
        (["run", "{job}/good.nc", "-c", CONTROL, "--set", "x=1"], "--set must be NUMBER=VALUE"),
        (["run", "{job}/good.nc", "-c", CONTROL, "--set", "100"], "--set must be NUMBER=VALUE"),
        (["run", "{job}/good.nc", "-c", CONTROL, "--param", "6050"], "--param must be NAME=VALUE"),
        (["run", "{job}/good.nc", "-c", CONTROL, "--param", "6051#9=1"], "the bits of a parameter"),
        (
            ["run", "{job}/good.nc", "-c", CONTROL, "--param", "6001#5=2"],
            "6001#5 is a bit: its value must be 0 or 1",
        ),
        (
            ["run", "{job}/good.nc", "-c", CONTROL, "--param", "6151=2"],
            "no parameter 6151; the nearest",
        ),
        (["run", "{job}/good.nc", "-c", CONTROL, "--set", "3000=1"], "#3000 can be set only by a"),
        (["run", "{job}/good.nc", "-c", CONTROL, "--skip", "12"], "1 to 10"),
        (["run", "{job}/good.nc", "-c", CONTROL, "--max-blocks", "many"], "--max-blocks"),
        (["run", "{job}/good.nc", "-c", CONTROL, "--max-cycles", "0"], "--max-cycles"),
        (["run", "{job}/good.nc", "-c", CONTROL, "--format", "xml"], "--format"),
        (["run", "{job}/good.nc", "-c", CONTROL, "--format", "parquet"], "--output"),
        (["run", "{job}/good.nc", "-c", CONTROL, "-o", "{job}/no/such"], "no/such"),
        (["run", "{job}/good.nc", "-c", CONTROL, "--external", "{job}/usb"], "usb"),
        (["run", "{job}/good.nc", "-c", CONTROL, "--setup", "{job}/none.toml"], "none.toml"),
        (["run", "{job}/good.nc", "-c", CONTROL, "--setup", "{job}/good.nc"], "good.nc"),
        (["run", "{job}/good.nc", "-c", CONTROL, "--mdi", "M30", "--main", "O1"], "--mdi"),
        (["run", "", "-c", CONTROL], "an empty path"),
        (["run", "/dev/zero", "-c", CONTROL], "not a regular file"),
        (["run", "{job}/good.nc", "-c", CONTROL, "--nonsense"], "--nonsense"),
        (["controls", "fanuc"], "'fanuc' may be fanuc-0i-d, fanuc-0i-f,"),
        (
            ["explain", "PS9999", "-c", "mitsubishi-m700"],
            "no code, alarm, cause, rule or parameter is called 'PS9999'",
        ),
        (["explain", "program-not-fond"], "did you mean program-not-found"),
        (["rum"], "rum"),
    ],
)
def test_wrong_use_is_one_line_and_status_2(job: Path, arguments: list[str], words: str) -> None:
    done = Done(*(argument.replace("{job}", str(job)) for argument in arguments))
    assert done.status == 2
    assert done.out == ""
    assert words in done.error
    assert done.error.startswith("cncsub: ")
    assert done.error.count("\n") == 1


def test_the_version_is_told() -> None:
    done = Done("--version")
    assert (done.status, done.out) == (0, f"cncsub {cncsub.__version__}\n")


@pytest.mark.parametrize("command", [[], ["run"], ["tree"], ["controls"], ["explain"]])
def test_help_is_status_0(command: list[str]) -> None:
    done = Done(*command, "--help")
    assert done.status == 0
    assert "Usage" in done.out


def test_the_installed_command_prints_without_colour_into_a_pipe(job: Path) -> None:
    command = [sys.executable, "-c", "from cncsub.cli import main; main()"]
    done = subprocess.run(
        [*command, "run", str(job / "bad.nc"), "-c", CONTROL],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 1
    assert done.stderr == ""
    assert "\x1b" not in done.stdout
    assert "program-not-found" in done.stdout
    wrong = subprocess.run([*command, "run", "x"], capture_output=True, text=True, check=False)
    assert wrong.returncode == 2
    assert "Traceback" not in wrong.stderr


def test_a_reader_that_goes_away_makes_no_traceback(job: Path) -> None:
    many = job / "many.nc"
    many.write_text(
        "O1\n" + "".join(f"N{n} M98 P2 L{n % 7 + 1}\n" for n in range(1, 9000)) + "M30\nO2\nM99\n"
    )
    code = "from cncsub.cli import main; main()"
    done = subprocess.run(
        f'"{sys.executable}" -c "{code}" run {many} -c {CONTROL} --format json | head -c 10',
        shell=True,
        capture_output=True,
        text=True,
        check=False,
    )
    assert "Traceback" not in done.stderr


def test_no_message_of_a_program_moves_the_terminal(tmp_path: Path) -> None:
    file = tmp_path / "O1.nc"
    file.write_bytes(b"N10 #3006=1(\x1b[2J\x07HI)\nN20 M98 P9(\x1b[2J)\n")
    done = Done("run", file, "-c", CONTROL)
    assert "\x1b" not in done.out
    assert "\x07" not in done.out


def test_a_long_tree_is_cut_and_says_how_much_is_left(tmp_path: Path) -> None:
    file = tmp_path / "O1.nc"
    calls = "".join(f"M98 P2 L{n % 2 + 1}\n" for n in range(250))
    file.write_text(f"O1\n{calls}M30\nO2\nM99\n")
    lines = Done("tree", file, "-c", CONTROL).out.splitlines()
    assert len(lines) == 202
    assert lines[-1] == "... 50 more lines"


def test_moves_are_written_while_the_program_runs(job: Path) -> None:
    (job / "long.nc").write_text("O1\nN1 G91 G1 X1. F100\nN2 GOTO 1\n", encoding="ascii")
    file = job / "long.parquet"
    done = Done(
        "run", job / "long.nc", "-c", CONTROL, "--format", "parquet", "--output", file,
        "--max-blocks", "200001",
    )  # fmt: skip
    assert done.status == 4
    assert "200,001 blocks" in done.error

    from pyarrow import parquet

    moves = parquet.ParquetFile(file)
    assert moves.metadata.num_rows == 100_001
    assert moves.num_row_groups > 1, "it was not written in parts"
    assert moves.read()["x"].to_pylist()[-1] == 100_001.0


def test_a_program_is_not_written_over(job: Path) -> None:
    text = (job / "good.nc").read_bytes()
    for command in ("run", "tree"):
        done = Done(command, job / "good.nc", "-c", CONTROL, "-o", job / "." / "good.nc")
        assert done.status == 2
        assert "give another file" in done.error
    assert (job / "good.nc").read_bytes() == text


def test_typed_text_has_no_table_of_moves(job: Path) -> None:
    done = Done("run", "--mdi", "G0 X1.", "-c", CONTROL, "--format", "csv")
    assert done.status == 2
    assert "--mdi takes text or json" in done.error


@pytest.mark.parametrize(
    "arguments",
    [
        ("run", "good.nc", "-c", CONTROL),
        ("tree", "bad.nc", "-c", CONTROL),
        ("controls",),
        ("controls", CONTROL),
        ("explain", "program-not-found"),
    ],
)
def test_colours_are_all_that_a_terminal_sees_more(
    job: Path, arguments: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(job)
    plain = Done(*arguments).out
    monkeypatch.setenv("FORCE_COLOR", "1")
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.delenv("NO_COLOR", raising=False)
    coloured = Done(*arguments).out
    assert "\x1b[" in coloured
    assert "\x1b[" not in plain
    assert re.sub("\x1b\\[[0-9;]*m", "", coloured) == plain


def test_two_controls_are_compared(tmp_path: Path) -> None:
    program = tmp_path / "O1.nc"
    program.write_text("O1\nN10 M98 P2 L0\nN20 M30\nO2\nN30 M99\n")
    done = Done("compare", str(program), "-c", "fanuc-0i-f", "-c", "mitsubishi-m700")
    assert (done.status, done.error) == (1, "")
    assert done.out.splitlines() == [
        "fanuc-0i-f: O1 N10, line 2: M98 O2, 1 pass",
        "mitsubishi-m700: no further call until the end",
        "because of the rule zero_repeats, a repeat count of 0:",
        "  fanuc-0i-f       once: `L0` is L1",
        "  mitsubishi-m700  skip: `L0` does not call",
        "--all goes on after this difference",
    ]
    same = Done("compare", str(program), "-c", "fanuc-0i-f", "-c", "fanuc-0i-d")
    assert (same.status, same.out) == (0, "the same\n")
    told = json.loads(
        Done("compare", str(program), "-c", CONTROL, "-c", CONTROL, "--format", "json").out
    )
    assert told == {
        "version": 1, "same": True, "where": [], "what": "the same", "rules": [], "untried": [],
        "parameters": [], "differences": [], "rest": None, "changes": [],
    }  # fmt: skip


SUB = "o100 sub\ng0 x{0}\no100 endsub\no100 call\nm2\n"


def test_each_file_of_linuxcnc_has_its_own_subprograms(tmp_path: Path) -> None:
    """A file may have the name of its subprogram, and two files may have the same label."""
    for name, text in (("o100.ngc", SUB.format(1)), ("part.ngc", SUB.format(2))):
        (tmp_path / name).write_text(text)
    for paths, x in ((("o100.ngc",), "1"), (("part.ngc", "o100.ngc"), "2")):
        done = Done("run", *(str(tmp_path / path) for path in paths), "-c", "linuxcnc")
        assert (done.status, done.error) == (0, ""), done.error
        assert f"X {x} to {x}" in done.out
    both = Done("check", str(tmp_path), "-c", "linuxcnc")
    assert (both.status, both.out.splitlines()[-1]) == (
        0, "checked: 2 programs on LinuxCNC mill: nothing found",
    )  # fmt: skip


@pytest.mark.parametrize("controls", [(), ("-c", CONTROL), ("-c", CONTROL) * 3])
def test_a_comparison_takes_two_controls(job: Path, controls: tuple[str, ...]) -> None:
    done = Done("compare", str(job / "good.nc"), *controls)
    assert (done.status, done.out) == (2, "")
    assert "-c ONE -c ANOTHER" in done.error


def test_two_versions_are_compared(tmp_path: Path) -> None:
    old, new = tmp_path / "old.nc", tmp_path / "new.nc"
    old.write_text("O1\nN10 G0 X1.\nM30\n")
    new.write_text("O1\n(NEW)\nN10 G0 X2.\nM30\n")
    done = Done("diff", str(old), str(new), "-c", "fanuc-0i-f", "--format", "json")
    told = json.loads(done.out)
    assert (done.status, told["same"], [step["line"] for step in told["where"]]) == (
        1, False, [2, 3],
    )  # fmt: skip
    assert Done("diff", str(old), str(old), "-c", "fanuc-0i-f").status == 0
    missing = Done("diff", str(old), str(tmp_path / "none.nc"), "-c", "fanuc-0i-f")
    assert (missing.status, missing.out) == (2, "")
    assert "none.nc" in missing.error


def test_a_command_that_prints_into_a_file_does_without_rich(job: Path) -> None:
    code = (
        "import sys; from cncsub.cli import main\n"
        "try: main()\n"
        "except SystemExit: print([m for m in ('rich.console', 'numpy') if m in sys.modules])\n"
    )
    command = [sys.executable, "-c", code, "run", str(job / "good.nc"), "-c", CONTROL]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1] == "[]"


# ---- no file that was read is written over ----


@pytest.fixture
def shop(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    for folder, name, text in (
        ("job", "O0001.nc", "O1\nM98 P2\nM30\n"),
        ("job", "O0002.nc", "O2\nM99\n"),
        ("usb", "O0003.nc", "O3\nM99\n"),
    ):
        (tmp_path / folder).mkdir(exist_ok=True)
        (tmp_path / folder / name).write_text(text)
    (tmp_path / "setup.toml").write_text('machine = "mill"\n')
    (tmp_path / "link.nc").hardlink_to(tmp_path / "job" / "O0001.nc")
    return tmp_path


OVERWRITING = [
    "coverage job --html job/O0001.nc",
    "coverage job --lcov job/O0002.nc",
    "coverage job --html x.html --cobertura ./x.html",
    "flatten job -o job/O0001.nc",
    "resume job --at O0002:2 --out job/O0001.nc",
    "check job --output job/O0002.nc",
    "report job/O0001.nc -o job/O0002.nc",
    "run job/O0001.nc --format csv -o job/O0002.nc",
    "run job -o link.nc",
    "run job --setup setup.toml -o setup.toml",
    "run job --external usb -o usb/O0003.nc",
    "run job -o -",
]


@pytest.mark.parametrize("line", OVERWRITING)
def test_nothing_that_was_read_is_written_over(shop: Path, line: str) -> None:
    def files() -> dict[Path, bytes]:
        return {path: path.read_bytes() for path in sorted(shop.rglob("*")) if path.is_file()}

    before = files()
    done = CliRunner().invoke(app, [*line.split(), "-c", "fanuc-0i-f"])
    assert done.exit_code == 2, done.output
    assert re.search("give another file|a different file for each|standard output", done.stderr)
    assert files() == before


@pytest.mark.parametrize(
    "name", ["setup.toml", "cncsub.toml", "inputs.toml", "kept.json", "usb/O0003.nc"]
)
def test_what_the_project_names_is_not_written_over(
    shop: Path, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(shop)
    (shop / "inputs.toml").write_text("clock_ms = 5\n")
    (shop / "kept.json").write_text("{}")
    (shop / "cncsub.toml").write_text(
        'control = "fanuc-0i-f"\nsetup = "setup.toml"\ninputs = "inputs.toml"\n'
        'variables = "kept.json"\nexternal = "usb"\nfolders = ["job"]\n'
    )
    before = (shop / name).read_bytes()
    for command in ("report", "flatten"):
        done = CliRunner().invoke(app, [command, "-o", name])
        assert done.exit_code == 2, done.output
        assert "give another file" in done.stderr
        assert (shop / name).read_bytes() == before


@pytest.mark.parametrize(
    ("line", "option"),
    [
        ("run job -c fanuc-0i-f -c haas-ngc", "--control"),
        ("run job -c fanuc-0i-f --main O1 --main=O2", "--main"),
        ("check job -c fanuc-0i-f --format json --format text", "--format"),
        ("flatten job -c fanuc-0i-f -o a.nc -o b.nc", "--output"),
    ],
)
def test_an_option_that_takes_one_value_is_not_given_twice(
    shop: Path, line: str, option: str
) -> None:
    done = CliRunner().invoke(app, line.split())
    assert done.exit_code == 2, done.output
    assert f"{option} is given 2 times; give it once" in done.stderr


def test_an_option_that_takes_several_is(shop: Path) -> None:
    line = "run job -c fanuc-0i-f --set 100=1 --set 101=2 --main O0001"
    done = CliRunner().invoke(app, line.split())
    assert done.exit_code == 0, done.output


def test_a_file_that_was_not_read_may_be_written_anew(shop: Path) -> None:
    for _ in range(2):
        done = CliRunner().invoke(app, ["report", "job", "-o", "job/r.html", "-c", "fanuc-0i-f"])
        assert done.exit_code == 0, done.output


def test_a_link_in_a_circle_is_left_out(shop: Path) -> None:
    (shop / "job" / "loop").symlink_to("loop")
    for command in ("run", "list", "tree", "coverage"):
        done = CliRunner().invoke(app, [command, "job", "-c", "fanuc-0i-f"])
        assert done.exit_code == 0, done.output


def test_a_batch_of_nothing_is_wrong_use(shop: Path) -> None:
    (shop / "none").mkdir()
    done = CliRunner().invoke(app, ["batch", "none", "-c", "fanuc-0i-f"])
    assert done.exit_code == 2
    assert "no file was found" in done.stderr


@pytest.mark.parametrize(
    ("cut", "told"),
    [("G1 Z-10. F0.2", True), ("S500 M3 G1 Z-10. F0.2", False), ("G4 X1.", False), ("", False)],
)
def test_a_time_that_counts_on_a_spindle_which_stands_still_is_told(
    tmp_path: Path, cut: str, told: bool
) -> None:
    file = tmp_path / "turn.nc"
    file.write_text(f"O1\nG99 G0 X50. Z2.\n{cut}\nM30\n")
    out = CliRunner().invoke(app, ["run", str(file), "-c", "gsk-988ta"]).stdout
    assert ("(at one revolution per minute where the program gives no S)" in out) is told


def test_variables_with_names_stand_beside_the_numbers(tmp_path: Path) -> None:
    file = tmp_path / "part.mpf"
    file.write_text('DEF INT SIDES[2]=SET(3,4)\nDEF STRING[8] WHO="A"\nR5=2\nM30\n')
    done = Done("run", file, "-c", "siemens-one", "--format", "json")
    assert done.json["variables"] == {"5": 2.0}
    assert done.json["named_variables"] == {"SIDES": [3, 4], "WHO": "A"}
