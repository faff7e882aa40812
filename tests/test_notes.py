"""A note reports what is easily overlooked in a memory; of two programs of one number, none is
guessed.
"""

from __future__ import annotations

import json
import pickle
import re
from pathlib import Path

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app

CONTROL = "fanuc-0i-f"
MACRO = "O9001\n#3000=1(TOOL WORN OUT)\nM99\n"
OLD = "O9001\nM99\n"


@pytest.fixture
def job(tmp_path: Path) -> Path:
    """A main program, its macro, and an old copy of the macro that comes first in the alphabet."""
    for name, text in {
        "main.nc": "O1\nG65 P9001\nM30\n",
        "macros/o9001.nc": MACRO,
        "a/o9001.nc": OLD,
    }.items():
        file = tmp_path / name
        file.parent.mkdir(exist_ok=True)
        file.write_text(text)
    return tmp_path


def kinds(library: cncsub.Library) -> list[str]:
    return [note.kind for note in library.notes]


def run(*arguments: str | Path) -> tuple[int, str, str]:
    done = CliRunner().invoke(app, ["run", "-c", CONTROL, *map(str, arguments)])
    return done.exit_code, done.stdout, done.stderr


# ---- the notes of a memory ----


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("O1\nM30\nO2\nM99\n", []),
        ("O1\nM30\nO2\nM99\nO2\nG4 X1.\nM99\n", ["conflict"]),
        ("O1\nM30\nO2\nM99\nO2\n  M99  \n\n", ["copy"]),
        ("O1\nM30\nO2\nM99\nO0002\nM99\n", ["copy"]),
        ("O1\nM30\nO2\nM99\nO0002\nG4 X1.\nM99\n", ["conflict"]),
        ("PART 12\n%\nO1\nM30\n%\n", ["left-out"]),
        ("G0 X1.\nM30\n", []),  # many files are one text without a head
    ],
)
def test_notes_of_a_text(text: str, wanted: list[str]) -> None:
    assert kinds(cncsub.loads(text, control=CONTROL)) == wanted


def test_a_stray_text_that_would_run_is_told(job: Path) -> None:
    (job / "a_notes.txt").write_text("bring the tool back\n")
    library = cncsub.load(job, control=CONTROL)
    note = next(note for note in library.notes if note.kind == "no-head")
    assert library.main is not None
    assert (note.file, note.line) == (str(job / "a_notes.txt"), 1)
    assert "no program head" in str(note)
    assert library.main.name in note.message


def test_what_is_named_beside_a_stray_text_is_what_nobody_calls(tmp_path: Path) -> None:
    (tmp_path / "a.nc").write_text("G0 X1.\nM30\n")
    (tmp_path / "b.nc").write_text("O9001\nM99\n")
    (tmp_path / "c.nc").write_text("O1\nM98 P9001\nM30\n")
    (note,) = cncsub.load(tmp_path, control=CONTROL).notes
    assert f"; O1 of {tmp_path / 'c.nc'} has a head" in note.message


@pytest.mark.parametrize("control", ["siemens-one", "gsk-988ta", "linuxcnc"])
def test_where_files_name_programs_no_head_is_missing(control: str, tmp_path: Path) -> None:
    (tmp_path / "a.mpf").write_text("G0 X1\nM30\n")
    (tmp_path / "b.mpf").write_text("G0 X2\nM30\n")
    assert kinds(cncsub.load(tmp_path, control=control)) == []


# ---- the one of two that counts ----


@pytest.mark.parametrize("folder", ["a", "macros"])
def test_the_preferred_file_counts_and_the_main_program_stays(job: Path, folder: str) -> None:
    wanted = job / folder / "o9001.nc"
    library = cncsub.load(job / "main.nc", job, control=CONTROL, prefer=wanted)
    assert library["O9001"].file == str(wanted)
    assert library.main is not None
    assert library.main.name == "O1"
    assert [program.file for program in library.duplicates] != [str(wanted)]
    assert kinds(library) == ["conflict"]
    assert (library.run().alarm is None) == (folder == "a")
    for other in (pickle.loads(pickle.dumps(library)), library.read_for("fanuc-30i")):
        assert other.main is not None
        assert (other.main.name, other["O9001"].file) == ("O1", str(wanted))


def test_a_preferred_file_is_one_that_is_read(job: Path) -> None:
    with pytest.raises(ValueError, match=r"elsewhere\.nc, which is not one of the files"):
        cncsub.load(job, control=CONTROL, prefer=[job / "elsewhere.nc"])
    with pytest.raises(ValueError, match=r"; there is \S*a\Wo9001\.nc, \S*macros\Wo9001\.nc$"):
        cncsub.load(job, control=CONTROL, prefer="o9001.nc")


# ---- the command ----


def test_two_different_programs_of_one_number_do_not_run(job: Path) -> None:
    status, out, err = run(job / "main.nc", job)
    assert status == 2
    assert out == ""
    assert "O9001 exists twice with different blocks" in err
    assert f"--prefer {job / 'a' / 'o9001.nc'}" in err


def test_the_chosen_one_runs_and_the_other_is_told(job: Path) -> None:
    status, out, err = run(job / "main.nc", job, "--prefer", job / "macros" / "o9001.nc")
    assert status == 1
    assert "TOOL WORN OUT" in out
    assert err.startswith("note: ")
    assert f"{job / 'a' / 'o9001.nc'}:1" in err


def test_copies_run_and_are_told(job: Path) -> None:
    (job / "a" / "o9001.nc").write_text(MACRO.replace("\n", "\r\n"))
    status, _, err = run(job / "main.nc", job)
    assert status == 1
    assert "which is the same" in err


def test_two_programs_of_one_file_are_no_choice(tmp_path: Path) -> None:
    (tmp_path / "part.nc").write_text("O1\nM98 P2\nM30\nO2\nM99\nO2\nG4 X1.\nM99\n")
    status, _, err = run(tmp_path / "part.nc")
    assert status == 2
    assert "remove one of them" in err


@pytest.mark.parametrize("arguments", [["-"], ["--mdi", "G0 X1"]])
def test_there_is_nothing_to_prefer_without_files(arguments: list[str]) -> None:
    status, _, err = run(*arguments, "--prefer", "a.nc")
    assert status == 2
    assert "--prefer chooses between files" in err


def test_json_has_the_notes(job: Path) -> None:
    status, out, _ = run(job / "main.nc", job, "--prefer", job / "a", "--format", "json")
    assert status == 2  # a folder is not a file that is read
    _, out, _ = run(job / "main.nc", job, "--prefer", job / "a" / "o9001.nc", "--format", "json")
    assert [note["kind"] for note in json.loads(out)["notes"]] == ["conflict"]


DROPPING = "O1\nN10 M8 M3 S500 M4\nG0 X1. X2.\nM30\n"


@pytest.mark.parametrize(
    "words",
    [
        ["run", "--listing"],
        ["run", "--format", "csv"],
        ["tree"],
        ["coverage"],
        ["plot", "-o", "path.html"],
    ],
)
def test_every_command_that_runs_tells_of_dropped_words(
    words: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("main.nc").write_text(DROPPING)
    done = CliRunner().invoke(app, [*words, "main.nc", "-c", "fanuc-0i-f"])
    assert "note: the control dropped 3 words; cncsub run and check show which" in done.stderr


def test_dropped_words_are_told_with_their_places(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("main.nc").write_text(DROPPING)

    def told(*words: str) -> str:
        return CliRunner().invoke(app, [*words, "main.nc", "-c", "fanuc-0i-f"]).stdout

    assert "dropped: M8 at O1 N10, main.nc:2\n" in told("run")
    for command in ("run", "tree"):
        dropped = json.loads(told(command, "--format", "json"))["dropped"]
        assert [word["text"] for word in dropped] == ["M8", "M3", "X1."]
    told("report", "-o", "page.html")
    assert "M8 at O1 N10, line 2; M3 at O1 N10, line 2" in Path("page.html").read_text()
    many = "".join(f"N{i} M8 M9\n" for i in range(1, 40))
    Path("main.nc").write_text(f"O1\n{many}M30\n")
    assert re.search(r"\.\.\. \d+ more words were dropped", told("run"))


@pytest.mark.parametrize("name", cncsub.controls)
def test_a_parameter_that_nothing_is_computed_from_is_told(name: str) -> None:
    control = cncsub.controls[name]
    for parameter in control.parameters.values():
        changed = control.with_parameters({parameter.name: 1 - parameter.value})
        told = [note.file for note in cncsub.loads("M30", control=changed).notes]
        assert told == ([] if parameter.used else [f"parameter {parameter.name}"])


def test_a_parameter_without_an_effect_is_told_on_the_terminal(tmp_path: Path) -> None:
    (tmp_path / "main.nc").write_text("O1\nM30\n")
    status, _, told = run(tmp_path / "main.nc", "--param", "3406=1")
    assert (status, told.count("no effect")) == (0, 1)
    assert "note: parameter 3406: no effect: cncsub computes nothing from it" in told
