"""`cncsub gate` and `gate`: what passes, what does not, and what an allow list lets pass."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import textwrap
import time
from pathlib import Path
from xml.etree import ElementTree

import pytest
from commands import path_with_cncsub
from typer.testing import CliRunner, Result

import cncsub
from cncsub.archive.gate import Allowed, gate, read_allow_list
from cncsub.archive.gating import gated
from cncsub.cli.commands import app
from cncsub.gate_rules import RULES

GOOD = "%\nO1 (PART)\nG21 G90 G17\nT1 M6\nG0 X10. Y10. S1000 M3\nG1 Z-1. F100\nG0 Z10.\nM30\n%\n"
MILL = "fanuc-0i-f"


@pytest.fixture
def output(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    folder = tmp_path / "out"
    folder.mkdir()
    for name, text in {
        "good.nc": GOOD,
        "code.nc": GOOD.replace("G0 Z10.", "G987"),
        "cut.nc": GOOD[: GOOD.index("G0 Z10.")],
        "head.nc": GOOD.replace("O1 (PART)", ""),
        "arc.nc": GOOD.replace("G1 Z-1.", "G2 X1. R0.1"),
        "far.nc": GOOD.replace("Z-1.", "Z-900."),
    }.items():
        (folder / name).write_text(text)
    return folder


def call(*args: str, control: str = MILL) -> Result:
    return CliRunner().invoke(app, ["gate", *args, "-c", control])


def found(folder: Path, **options: object) -> dict[str, list[str]]:
    done = gate([folder], MILL, **options)  # type: ignore[arg-type]
    return {Path(file.path).stem: [f.name for f in file.findings] for file in done.files}


def test_a_file_passes_or_tells_why_it_does_not(output: Path) -> None:
    told = found(output)
    assert told["good"] == told["far"] == []
    assert told["code"] == ["code-not-available"]
    assert told["head"] == ["head-missing"]
    assert told["arc"] == ["dry-run-alarm"]
    assert "half-a-file" in told["cut"]


def test_travel_ends_at_the_limits_of_a_setup(output: Path) -> None:
    (output.parent / "limits.toml").write_text("[limits]\nZ = [-500, 100]\n")
    done = call("out/far.nc", "out/good.nc", "--setup", "limits.toml")
    assert done.exit_code == 1
    first, second, _ = done.stdout.splitlines()
    assert first.startswith("FAILED out/far.nc: line 6: GT101 dry-run-alarm")
    assert second == "passed out/good.nc"


def test_what_cncsub_cannot_compute_does_not_pass(output: Path) -> None:
    code = next(
        code
        for code in ("G05.1", "G12.1", "G107", "G5.1", "G8", "G10.6", "G43.4", "G53.1", "G72.1")
        if any(
            finding.name == "not-computed"
            for finding in cncsub.loads(f"O1\n{code} Q1 X1.\nM30\n", control=MILL).check()
        )
    )
    (output / "good.nc").write_text(GOOD.replace("G0 Z10.", f"{code} Q1 X1."))
    assert "not-computed" in found(output)["good"]
    assert call("out/good.nc").exit_code == 1


def test_a_program_that_goes_on_without_an_end_does_not_pass(output: Path) -> None:
    (output / "good.nc").write_text("%\nO1\nN10 G4 X1.\nGOTO 10\nM30\n%\n")
    assert "dry-run-unfinished" in found(output, max_blocks=1000)["good"]


def test_an_allow_list_lets_pass_what_it_names_and_tells_what_is_unused(output: Path) -> None:
    (output.parent / "allow.txt").write_text(
        "# what this machine has\n\nG987  code*  # smoothness\nhead-missing\nPS0020 arc.nc\nG123\n"
    )
    done = call("out", "--allow", "allow.txt")
    assert done.exit_code == 1  # cut.nc
    assert "passed out/code.nc" in done.stdout
    assert "passed out/head.nc" in done.stdout
    assert "passed out/arc.nc" in done.stdout
    assert "6 files: 5 passed, 1 did not; 3 findings allowed" in done.stdout
    assert "allow.txt:6: G123 lets nothing pass: remove it" in done.stderr
    assert done.stderr.count("lets nothing pass") == 1


def test_a_dry_run_goes_on_after_a_block_that_is_allowed(output: Path) -> None:
    text = GOOD.replace("G0 Z10.", "G987 P2\nG2 X30. R0.1")
    (output / "code.nc").write_text(text)
    done = gate([output / "code.nc"], MILL, allow=[Allowed("G987", "*", 1)])
    assert [(f.name, f.line) for f in done.files[0].findings] == [("dry-run-alarm", 8)]
    assert [f.word for f in done.files[0].allowed] == ["G987"]


def test_an_entry_for_other_files_lets_nothing_pass(output: Path) -> None:
    done = gate([output / "code.nc"], MILL, allow=[Allowed("G987", "other*", 1)])
    assert not done.files[0].passes()
    assert done.unused == (Allowed("G987", "other*", 1),)


def test_a_wrong_allow_list_is_told(output: Path) -> None:
    (output.parent / "allow.txt").write_text("G987 a b\n")
    done = call("out", "--allow", "allow.txt")
    assert done.exit_code == 2
    assert "allow.txt:1: an entry is WHAT or WHAT FILES" in done.stderr
    assert call("out", "--allow", "nosuch.txt").exit_code == 2


def test_warnings_pass_unless_it_is_strict(output: Path) -> None:
    (output / "good.nc").write_text(GOOD.replace("%\n", ""))
    assert call("out/good.nc").exit_code == 0
    done = call("out/good.nc", "--strict")
    assert done.exit_code == 1
    assert "GT203 no-percent-signs" in done.stdout


def test_findings_are_told_to_other_tools(output: Path) -> None:
    told = json.loads(call("out", "--format", "json").stdout)
    assert [file["passes"] for file in told["files"]].count(True) == 2
    log = json.loads(call("out", "--format", "sarif").stdout)["runs"][0]
    rules = [rule["id"] for rule in log["tool"]["driver"]["rules"]]
    assert len(rules) == len(set(rules))
    for result in log["results"]:
        assert rules[result["ruleIndex"]] == result["ruleId"]
    suite = ElementTree.fromstring(call("out", "--format", "junit").stdout)
    assert (suite.get("tests"), suite.get("failures")) == ("6", "4")
    assert "::error file=" in call("out", "--format", "github").stdout


def test_a_file_that_cannot_be_read_does_not_pass(output: Path) -> None:
    (output / "gone.nc").symlink_to(output / "nosuch.nc")
    done = call("out/gone.nc")
    assert done.exit_code == 1
    assert done.stdout.startswith("FAILED out/gone.nc: unreadable: a broken link")


def test_a_path_that_leads_nowhere_is_wrong_use(output: Path) -> None:
    done = call("out/good.nc", "out/nosuch.nc")
    assert done.exit_code == 2
    assert "nosuch.nc" in done.stderr
    assert call().exit_code == 2
    with pytest.raises(FileNotFoundError, match="nosuch"):
        gate(["out/nosuch.nc"], MILL)


def test_an_entry_for_a_file_means_the_file_in_a_folder_that_is_one_memory(output: Path) -> None:
    for pattern, left in (("code.nc", 0), ("*/out/code.nc", 0), ("arc.nc", 1), ("out", 1)):
        allow = [Allowed("G987", pattern, 1)]
        [done] = gate([output], MILL, each="folder", allow=allow).files
        assert sum(f.name == "code-not-available" for f in done.findings) == left, pattern


@pytest.mark.parametrize("rule", [rule for rule in RULES if rule.example], ids=lambda r: r.name)
def test_the_example_of_a_rule_shows_it(rule: cncsub.CheckRule) -> None:
    library = cncsub.loads(rule.example, control=rule.control)
    names = [finding.name for finding in gated(library, library.files, {"max_blocks": 1000})]
    assert rule.name in names


def test_an_allow_list_is_read_line_by_line(tmp_path: Path) -> None:
    (tmp_path / "allow.txt").write_text("\ufeff# a\nG1\n G2  *.nc # b\n")
    assert read_allow_list(tmp_path / "allow.txt") == (
        Allowed("G1", "*", 2),
        Allowed("G2", "*.nc", 3),
    )


def test_a_thousand_files_are_quick(output: Path) -> None:
    many = output.parent / "many"
    many.mkdir()
    for number in range(1000):
        (many / f"O{number + 1:04d}.nc").write_text(GOOD.replace("O1 ", f"O{number + 1:04d} "))
    began = time.perf_counter()
    done = gate([many], MILL)
    assert len(done.files) == 1000
    assert all(file.passes() for file in done.files)
    assert time.perf_counter() - began < 60  # two seconds where nothing else runs


# ---- the action ----

ACTION = Path(__file__).parent.parent / ".github" / "actions" / "gate" / "action.yml"


def script_of_the_action() -> tuple[str, dict[str, str]]:
    """Return the script of the last step, and its variables: each names the input it is given."""
    text = ACTION.read_text(encoding="utf-8")
    step = text[text.rindex("- shell: bash") :]
    env, script = step.split("run: |\n")
    names = dict(re.findall(r"^ +([A-Z_]+): \$\{\{ inputs\.([a-z-]+) \}\}$", env, re.MULTILINE))
    return textwrap.dedent(script), names


def test_the_inputs_of_the_action_are_those_of_its_page() -> None:
    text = ACTION.read_text(encoding="utf-8")
    inputs = re.findall(r"^  ([a-z-]+):$", text[: text.index("runs:")], re.MULTILINE)
    used = set(re.findall(r"inputs\.([a-z-]+)", text))
    assert set(inputs) == used
    page = ACTION.with_name("README.md").read_text(encoding="utf-8")
    assert all(f"`{name}`" in page for name in inputs)


@pytest.mark.skipif(sys.platform == "win32", reason="the action runs bash")
def test_the_action_marks_lines_and_fails(output: Path) -> None:
    (output / "with blank.nc").write_text(GOOD)
    files = ("out/with blank.nc", "out/head.nc", "out/code.nc")
    done, lines = acted(output, *files, allow="head-missing\n")
    assert done.returncode == 1, done.stderr
    assert "::error file=out/code.nc,line=7" in done.stdout
    assert lines[0] == "passed out/with blank.nc"
    assert lines[1] == "passed out/head.nc"
    assert lines[2].startswith("FAILED out/code.nc")


@pytest.mark.skipif(sys.platform == "win32", reason="the action runs bash")
@pytest.mark.parametrize(
    ("file", "more", "status"),
    [
        ("good.nc", {}, 0),
        ("warns.nc", {}, 0),
        ("warns.nc", {"strict": "true"}, 1),
        ("far.nc", {}, 0),
        ("far.nc", {"setup": "[limits]\nZ = [-600, 100]\n"}, 1),
        ("head.nc", {}, 1),
        ("head.nc", {"allow": "head-missing\n"}, 0),
        ("nosuch.nc", {}, 2),
    ],
)
def test_each_input_of_the_action_counts(
    output: Path, file: str, more: dict[str, str], status: int
) -> None:
    (output / "warns.nc").write_text(GOOD.strip("%\n") + "\n")  # no %, which is a warning
    done, _ = acted(output, f"out/{file}", **more)
    assert done.returncode == status, (done.stdout, done.stderr)


def acted(
    output: Path, *files: str, strict: str = "false", allow: str = "", setup: str = ""
) -> tuple[subprocess.CompletedProcess[str], list[str]]:
    """Run the script of the action, and return what it says and the lines of its summary."""
    script, names = script_of_the_action()
    assert set(names.values()) == {"paths", "control", "allow", "setup", "strict"}
    for name, text in (("allow.txt", allow), ("machine.toml", setup)):
        (output.parent / name).write_text(text)
    summary = output.parent / "summary"
    given = {
        "PATHS": "".join(f"{file}\n" for file in files),
        "CNCSUB_CONTROL": MILL,
        "ALLOW": "allow.txt" if allow else "",
        "SETUP": "machine.toml" if setup else "",
        "STRICT": strict,
        "GITHUB_STEP_SUMMARY": str(summary),
        "PATH": path_with_cncsub(output.parent / "bin"),
    }
    done = subprocess.run(
        ["bash", "-e", "-c", script],
        env={**os.environ, **given},
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    return done, summary.read_text().splitlines()
