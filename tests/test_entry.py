"""A library without a main program: `entry` names the programs that something outside calls."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app

CONTROL = "fanuc-0i-f"
MACROS = {
    "O9000.nc": "O9000\nM98 P9010\nM99\n",
    "O9010.nc": "O9010\nG0 X#24\nM99\n",
    "O8000.nc": "O8000\nG0 X#24\nM99\n",
}


def library(texts: dict[str, str] | None = None) -> cncsub.Library:
    return cncsub.loads(texts or {"O1.nc": "O1\nM30\n", **MACROS}, control=CONTROL)


def rules(found: list[cncsub.Finding]) -> list[tuple[str, str]]:
    return [(finding.rule, finding.program) for finding in found]


# ---- check ----


@pytest.mark.parametrize(
    ("entry", "never_called"),
    [
        ([], ["O9000", "O8000"]),
        (["O9000"], ["O8000"]),
        (["o90*"], ["O8000"]),
        (["9000"], ["O8000"]),
        (["O90*", "O8?00"], []),
        (["O7000", "P*"], ["O9000", "O8000"]),
    ],
)
def test_a_program_that_something_outside_calls_is_no_finding(
    entry: list[str], never_called: list[str]
) -> None:
    found = library().check(rules=["CS302"], entry=entry)
    assert [finding.program for finding in found] == never_called


def test_a_name_leads_to_a_program_however_it_is_written() -> None:
    text = {"a": "O1\nM30\n", "b": "O0007\nM99\n"}
    assert library(text).check(entry=["O7"]) == []
    assert rules(library(text).check(entry=["O7*"])) == [("CS302", "O0007")]


def test_the_arguments_of_an_entry_are_not_known() -> None:
    texts = {"O1.nc": "O1\nG65 P9000\nM30\n", "O9000.nc": "O9000\nG0 X#24\nM99\n"}
    assert ("CS603", "O9000") in rules(library(texts).check())
    assert rules(library(texts).check(entry=["O9000"])) == []


def test_an_entry_that_ends_is_no_main_program_whose_locals_are_vacant() -> None:
    texts = {"O1.nc": "O1\nM30\n", "O2.nc": "O2\nG0 X#24\nM30\n"}
    assert ("CS601", "O2") in rules(library(texts).check())
    assert rules(library(texts).check(entry=["O2"])) == []


def test_the_common_variables_of_an_entry_may_be_set_outside() -> None:
    texts = {"O1.nc": "O1\nM30\n", "O2.nc": "O2\nG0 X#100\n#100=1\nM30\n"}
    assert rules(library(texts).check()) == [("CS607", "O2")]
    assert rules(library(texts).check(entry=["O2"])) == []


def test_what_surprises_in_an_entry_is_still_a_finding() -> None:
    texts = {
        "O1.nc": "O1\nM30\n",
        "O2.nc": "O2\nM98 P3\nX1.\nM99\n",
        "O3.nc": "O3\nG91\nM99\n",
    }
    assert rules(library(texts).check(entry=["O2"])) == [("CS501", "O2")]


@pytest.mark.parametrize("entry", ["O90*", [9000], [None]])
def test_an_entry_that_is_no_name_is_a_type_error(entry: object) -> None:
    for ask in (library().check, library().call_graph):
        with pytest.raises(TypeError, match="entry"):
            ask(entry=entry)  # type: ignore[operator]


# ---- the call graph ----


def test_what_an_entry_calls_is_reached() -> None:
    assert library().call_graph().unreached == ("O9000", "O9010", "O8000")
    assert library().call_graph(entry=["O9000"]).unreached == ("O8000",)


def test_what_is_preferred_is_the_main_program_of_the_graph(tmp_path: Path) -> None:
    (tmp_path / "a.nc").write_text("O1\nM30\n")
    (tmp_path / "b.nc").write_text("O2\nM98 P3\nM30\nO3\nM99\n")
    both = cncsub.load(tmp_path, control=CONTROL, prefer=tmp_path / "b.nc")
    assert both.main is not None
    first = both.main.name
    assert first not in both.call_graph().unreached


# ---- the project ----


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    macros = tmp_path / "macros"
    macros.mkdir()
    for name, text in MACROS.items():
        (macros / name).write_text(text)
    write(tmp_path, 'entry = ["O90*", "O8000"]')
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("CNCSUB_CONTROL", raising=False)
    return tmp_path


def write(folder: Path, line: str) -> None:
    text = f'control = "{CONTROL}"\nfolders = ["macros"]\n{line}\n'
    (folder / "cncsub.toml").write_text(text)


def run(*arguments: str) -> tuple[int, str]:
    done = CliRunner().invoke(app, list(arguments))
    return done.exit_code, done.output


@pytest.mark.usefixtures("project")
def test_a_project_names_its_entries_for_all_commands() -> None:
    assert "CS302" not in run("check")[1]
    assert "CS302" not in run("check", "macros")[1]
    assert "CS302" not in run("batch", "macros", "--check", "--each", "folder")[1]
    status, told = run("list")
    assert status == 0
    assert told.count(", entry") == 3
    listed = json.loads(run("list", "--format", "json")[1].partition("note:")[0])
    assert {row["program"]: row["entry"] for row in listed["programs"]}["O9000"]


def test_an_entry_that_names_no_program_is_a_note(project: Path) -> None:
    write(project, 'entry = ["O90*", "O70*"]')
    told = run("check")[1]
    assert f"note: entry O70* of {project / 'cncsub.toml'}: no program has such a name" in told
    assert "entry O90*" not in told
    assert "entry" not in run("check", "macros/O9000.nc")[1], "one file is not the whole project"


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ('entry = "O90*"', "entry must be a list"),
        ("entry = [9000]", "entry must be a list of texts"),
    ],
)
def test_an_entry_of_a_project_is_a_list_of_names(project: Path, line: str, told: str) -> None:
    write(project, line)
    status, said = run("check")
    assert status == 2
    assert told in said
