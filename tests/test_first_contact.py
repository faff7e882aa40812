"""The command by itself, the control from the environment, and `cncsub controls`."""

from __future__ import annotations

import json
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
    # What it names is there.
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
    assert "nothing of fanuc-0i-f holds frobnicate" in err


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
    assert "name the first one too" in command("controls", "--diff", "fanuc-30i")[2]
