"""The command by itself, the control from the environment, and `cncsub controls`."""

from __future__ import annotations

import json
import os
import pty
import subprocess
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app


def command(*arguments: str | Path, control: str | None = None) -> tuple[int, str, str]:
    env = {"CNCSUB_CONTROL": control}
    done = CliRunner().invoke(app, [str(each) for each in arguments], env=env)
    return done.exit_code, done.stdout, done.stderr


def test_the_command_alone_shows_the_first_steps() -> None:
    status, out, err = command()
    assert (status, err) == (0, "")
    for wanted in ("Usage: ", "First steps:", "cncsub check part.nc", "CNCSUB_CONTROL"):
        assert wanted in out
    # The commands that it names exist.
    for line in out[out.index("First steps:") :].splitlines():
        if line.startswith("  cncsub "):
            assert command(line.split()[1], "--help")[0] == 0


def test_the_control_may_come_from_the_environment(tmp_path: Path) -> None:
    file = tmp_path / "part.nc"
    file.write_text("O1\nM30\n")
    assert command("run", file)[0] == 2
    assert "on FANUC Series 0i-F" in command("run", file, control="fanuc-0i-f")[1]
    status, out, _ = command("run", file, "-c", "haas-ngc", control="fanuc-0i-f")
    assert status == 0
    assert f"on {cncsub.controls['haas-ngc'].title}" in out
    assert "no control" in command("run", file, control="fanuc-99")[2]


@pytest.mark.parametrize(
    ("words", "wanted", "unwanted"),
    [
        (("6005",), "parameter 6005#0 = 0", "6004"),
        (("PS0076",), "alarm PS0076 program-not-found", "PS0077"),
        (("count", "zero"), "rule zero_repeats", "rule start_word"),
    ],
)
def test_facts_of_a_control_are_chosen(words: tuple[str, ...], wanted: str, unwanted: str) -> None:
    status, out, _ = command("controls", "fanuc-0i-f", *words)
    assert status == 0
    assert wanted in out
    assert unwanted not in out


def test_nothing_chosen_is_told() -> None:
    status, out, err = command("controls", "fanuc-0i-f", "frobnicate")
    assert (status, out) == (2, "")
    assert "fanuc-0i-f has no fact with frobnicate" in err


def test_a_control_does_not_differ_from_itself() -> None:
    for name in cncsub.controls:
        _, out, _ = command("controls", name, "--diff", name)
        assert out == f"0 differences between {name} and {name}\n"


def test_what_differs_is_what_the_rules_say() -> None:
    one, other = cncsub.controls["fanuc-0i-f"], cncsub.controls["fanuc-30i"]
    values = [{rule.name: rule.value for rule in control.rules} for control in (one, other)]
    wanted = {name for name in values[0] | values[1] if values[0].get(name) != values[1].get(name)}
    _, out, _ = command("controls", one.name, "--diff", other.name, "--format", "json")
    told = json.loads(out)
    assert told["controls"] == ["fanuc-0i-f", "fanuc-30i"]
    assert {d["name"] for d in told["differences"] if d["kind"] == "rules"} == wanted
    assert "idle_blocks" in wanted
    _, out, _ = command("controls", one.name, "idle", "--diff", other.name)
    assert out.splitlines()[1].split()[:2] == ["fanuc-0i-f", "1"]
    assert out.endswith("1 difference between fanuc-0i-f and fanuc-30i\n")


def test_a_difference_is_between_two() -> None:
    assert "give the first one too" in command("controls", "--diff", "fanuc-30i")[2]


def test_long_lists_differ_by_what_the_other_has_not() -> None:
    _, out, _ = command("controls", "fanuc-0i-f", "g_codes", "--diff", "fanuc-0i-d")
    (one,) = (line for line in out.splitlines() if line.startswith("    fanuc-0i-f"))
    listed = set(one.partition("besides: ")[2].partition("  [")[0].split())
    lists = [
        {rule.name: str(rule.value) for rule in cncsub.controls[name].rules}["g_codes"].split()
        for name in ("fanuc-0i-f", "fanuc-0i-d")
    ]
    assert listed == set(lists[0]) - set(lists[1])


# ---- a terminal ----


def on_a_terminal(*arguments: str, columns: int, **settings: str) -> str:
    """Return what the command prints on a terminal of so many columns and 24 lines."""
    main, side = pty.openpty()
    env = {**os.environ, "TERM": "xterm", "COLUMNS": str(columns), "LINES": "24", **settings}
    env = {name: value for name, value in env.items() if name != "NO_COLOR"}
    child = subprocess.Popen(
        [sys.executable, "-m", "cncsub", *arguments], stdin=side, stdout=side, stderr=side, env=env
    )
    os.close(side)
    told = b""
    while True:
        try:
            part = os.read(main, 65536)
        except OSError:  # the other side is closed
            break
        if not part:
            break
        told += part
    os.close(main)
    assert child.wait() == 0
    return told.decode().replace("\r\n", "\n")


def test_a_control_is_paged_and_fits_the_terminal(tmp_path: Path) -> None:
    held = tmp_path / "paged"
    pager = tmp_path / "pager"
    pager.write_text(f"#!/bin/sh\ncat > {held}\n")
    pager.chmod(0o755)
    told = on_a_terminal("controls", "haas-ngc", columns=80, PAGER=str(pager), NO_COLOR="1")
    assert "Rules" not in told
    lines = held.read_text().splitlines()
    assert any(line.lstrip("\x1b[0123456789;m").startswith("  max_nesting") for line in lines)
    plain = [part for line in lines for part in [line.replace("\x1b[0m", "")]]
    words = [line for line in plain if len(line.split()) > 1]
    assert all(len(line) <= 80 or "\x1b" in line for line in words)


def test_what_is_short_is_not_paged() -> None:
    told = on_a_terminal("controls", "fanuc-0i-f", "6005#0", columns=80, PAGER="false")
    assert "6005#0" in told


def test_the_first_page_fits_eighty_columns() -> None:
    told = on_a_terminal(columns=80)
    assert "First steps:" in told
    assert max(map(len, told.splitlines())) <= 80
    assert "..." not in told.replace("[ARGS]...", "")


# ---- completion ----


@pytest.mark.parametrize(
    ("typed", "wanted"),
    [
        ("cncsub ch", {"check"}),
        ("cncsub run -c fanuc-0", {"fanuc-0i-d", "fanuc-0i-f"}),
        ("cncsub controls haas", {"haas-ngc"}),
        (
            "cncsub controls fanuc-0i-f --diff siem",
            {"siemens-828d", "siemens-840d-sl", "siemens-one"},
        ),
        ("cncsub run --opt", {"--optional-stop"}),
    ],
)
def test_a_shell_completes(typed: str, wanted: set[str]) -> None:
    env = {
        **os.environ,
        "_CNCSUB_COMPLETE": "complete_bash",
        "COMP_WORDS": typed,
        "COMP_CWORD": str(len(typed.split()) - 1),
    }
    command = [sys.executable, "-c", "from cncsub.cli import main; main()"]
    done = subprocess.run(command, capture_output=True, text=True, env=env, check=False)
    assert set(done.stdout.split()) == wanted


# ---- files next to the one that is named ----


@pytest.fixture
def job(tmp_path: Path) -> Path:
    """A main program that calls a file next to it, which calls another; and an unrelated one."""
    (tmp_path / "main.nc").write_text("O1\nN10 M98 P2\nN20 M30\n")
    (tmp_path / "O0002.nc").write_text("O2\nN30 G65 P9010 A1.5\nN40 G0 X1.5 Y20\nN50 M99\n")
    (tmp_path / "o9010.NC").write_text("O9010\nN60 M99\n")
    (tmp_path / "O0003.nc").write_text("O3\nN70 M99\n")
    return tmp_path


def test_a_main_file_alone_finds_its_folder(job: Path) -> None:
    status, out, err = command("run", job / "main.nc", "-c", "fanuc-0i-f")
    assert status == 0
    assert "G65 O9010" in out
    assert [line.split(": ")[1] for line in err.splitlines()] == [
        str(job / "O0002.nc"),
        str(job / "o9010.NC"),
        "O2",  # lengths without a point
    ]
    _, out, _ = command("run", job / "main.nc", "-c", "fanuc-0i-f", "--format", "json")
    notes = json.loads(out)["notes"]
    assert [(note["kind"], Path(note["file"]).name) for note in notes] == [
        ("beside", "O0002.nc"),
        ("beside", "o9010.NC"),
        ("increments", "O2"),
    ]


def test_of_files_beside_nothing_is_found_by_check(job: Path) -> None:
    status, out, _ = command("check", job / "main.nc", "-c", "fanuc-0i-f")
    assert (status, "CS" in out) == (0, False)
    assert "CS701" in command("check", job, "-c", "fanuc-0i-f")[1]


def test_two_files_of_one_name_are_not_chosen_from(job: Path) -> None:
    (job / "2.txt").write_text("O2\nN80 M99\n")
    status, out, err = command("run", job / "main.nc", "-c", "fanuc-0i-f")
    assert status == 1
    assert "O2 is not in the memory" in out
    assert err.count("was not read: give it") == 2


def test_two_named_files_are_all_there_is(job: Path) -> None:
    status, out, _ = command("run", job / "main.nc", job / "O0003.nc", "-c", "fanuc-0i-f")
    assert status == 1
    assert "O2 is not in the memory" in out


def test_the_project_beside_the_programs_counts(job: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (job / "cncsub.toml").write_text('control = "haas-ngc"\n')
    elsewhere = job / "elsewhere"
    elsewhere.mkdir()
    monkeypatch.chdir(elsewhere)
    assert cncsub.controls["haas-ngc"].title in command("run", job / "main.nc")[1]
    (elsewhere / "cncsub.toml").write_text('control = "fanuc-16i"\n')
    assert cncsub.controls["fanuc-16i"].title in command("run", job / "main.nc")[1]


def test_what_is_typed_in_mdi_finds_the_programs_of_the_project(
    job: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (job / "cncsub.toml").write_text('control = "haas-ngc"\nfolders = ["."]\n')
    monkeypatch.chdir(job)
    status, printed, said = command("run", "--mdi", "M98 P2")
    assert (status, "M98 O2" in printed) == (0, True), printed + said


def test_a_file_that_an_option_names_is_not_told_as_left_out(job: Path) -> None:
    (job / "setup.toml").write_text('machine = "mill"\n')
    (job / "other.toml").write_text("")
    told = command("run", job, "-c", "fanuc-0i-f", "--setup", job / "setup.toml")[2]
    assert "other.toml" in told
    assert "setup.toml" not in told


# ---- common mistakes ----


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["expl", "part.nc"], "there is no command 'expl'; did you mean explain"),
        (["part.nc"], "to run it: cncsub run part.nc"),
        (["zzz"], "there are run, tree, list"),
        (
            ["-c", "fanuc-0i-f", "run", "part.nc"],
            "options follow the command: cncsub run part.nc",
        ),
        (
            ["run", "part.nc", "-c", "fanuc-0i-f", "--mdi", "G65", "P9100", "X5."],
            'put quotes around a text with blanks: --mdi "G65 P9100"',
        ),
    ],
)
def test_a_stumble_leads_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, words: list[str], told: str
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "part.nc").write_text("O1\nM30\n")
    done = CliRunner().invoke(app, words)
    assert done.exit_code == 2
    assert told in done.stderr
    assert done.stderr.count("\n") == 1
