"""The folders of a search path, wherever programs are read, shown and run."""

from __future__ import annotations

import os
import pickle
import re
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.archive.gate import gate
from cncsub.cli import app

ONE = "siemens-one"
MAIN = "N10 PART\nN20 M30\n"
FILES = {
    "WKS.DIR/SHAFT.WPD/MAIN.MPF": MAIN,
    "cus.dir/PART.SPF": "N30 R1=1\nN31 M17\n",
    "_N_CST_DIR/PART.SPF": "N40 R1=2\nN41 M17\n",
}


def written(folder: Path, files: dict[str, str]) -> Path:
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return folder


def blocks(run: cncsub.Run) -> list[tuple[str, int | None]]:
    return [(step.program, step.n) for step in run.steps]


def test_programs_of_one_name_in_two_folders_are_two(tmp_path: Path) -> None:
    library = cncsub.load(written(tmp_path, FILES), control=ONE)
    assert sorted(library) == ["CST.DIR/PART", "MAIN", "PART"]  # as a search finds them
    assert library.duplicates == ()
    assert library["CUS.DIR/PART"].file.endswith("cus.dir/PART.SPF")
    assert library["CST.DIR/PART"].file.endswith("_N_CST_DIR/PART.SPF")
    assert library.run("MAIN").variables["R1"] == 1
    assert library.run("CST.DIR/PART").variables["R1"] == 2


def test_the_call_graph_and_the_check_know_the_folders(tmp_path: Path) -> None:
    library = cncsub.load(written(tmp_path, FILES), control=ONE)
    (edge,) = library.call_graph().edges
    assert library[edge.called].file.endswith("cus.dir/PART.SPF")
    assert [f.rule for f in library.check("MAIN") if f.severity == "error"] == []
    alone = {"A.WPD/MAIN.MPF": MAIN, "B.WPD/PART.SPF": "N30 M17\n"}
    (finding,) = [
        f for f in cncsub.loads(alone, control=ONE).check("MAIN") if f.severity == "error"
    ]
    assert "B.WPD, which is not searched here" in finding.message
    more = {**alone, "A.WPD/MAIN.MPF": 'N5 CALLPATH("/_N_WKS_DIR/_N_B_WPD")\n' + MAIN}
    added = cncsub.loads(more, control=ONE)
    assert [f for f in added.check("MAIN") if f.severity == "error"] == []
    assert added.run("MAIN").stop == cncsub.Stop.END


def test_an_alarm_says_where_the_program_lies() -> None:
    files = {"A.WPD/MAIN.MPF": MAIN, "CUS.DIR/MORE/PART.SPF": "N30 M17\n"}
    alarm = cncsub.loads(files, control=ONE).run("MAIN").alarm
    assert alarm is not None
    assert alarm.detail == (
        "PART is not in the memory; it is in CUS.DIR/MORE, which is not searched here"
    )


def test_folders_are_named_by_load(tmp_path: Path) -> None:
    files = {"SHAFT.WPD/MAIN.MPF": MAIN, "cycles/PART.SPF": "N30 R1=1\nN31 M17\n"}
    written(tmp_path, {**files, "CST.DIR/PART.SPF": "N40 R1=2\nN41 M17\n"})
    paths = [tmp_path / "SHAFT.WPD", tmp_path / "CST.DIR"]
    library = cncsub.load(*paths, control=ONE, search={"CUS.DIR": tmp_path / "cycles"})
    assert library.run("MAIN").variables["R1"] == 1
    maker = cncsub.load(*paths, control=ONE, search={"cst.dir": tmp_path / "cycles"})
    assert {program.file for program in maker.duplicates} == {str(tmp_path / "cycles/PART.SPF")}
    again = pickle.loads(pickle.dumps(library))
    assert again.run("MAIN").variables["R1"] == 1


@pytest.mark.parametrize(
    ("control", "search", "words"),
    [
        ("fanuc-0i-f", {"CUS.DIR": "."}, "search: fanuc-0i-f has no search path"),
        (ONE, {"CUS": "."}, "search: CUS is not a folder of the path; did you mean CUS.DIR?"),
    ],
)
def test_folders_that_are_none_are_refused(
    tmp_path: Path, control: str, search: dict[str, str], words: str
) -> None:
    with pytest.raises(ValueError, match=words.split("?")[0]):
        cncsub.load(written(tmp_path, FILES), control=control, search=search)


def test_a_file_brings_what_it_calls_from_the_folders_near_it(tmp_path: Path) -> None:
    written(tmp_path, FILES)
    main = tmp_path / "WKS.DIR/SHAFT.WPD/MAIN.MPF"
    result = CliRunner().invoke(app, ["run", str(main), "-c", ONE])
    assert result.exit_code == 0, result.output
    assert "cus.dir" in result.output
    assert "CST" not in result.output


def test_the_command_and_the_project_name_folders(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    files = {"SHAFT.WPD/MAIN.MPF": MAIN, "cycles/PART.SPF": "N30 M17\n"}
    written(tmp_path, {**files, "CMA.DIR/PART.SPF": "N40 R1=1/0\n"})
    monkeypatch.chdir(tmp_path)
    command = ["run", "SHAFT.WPD", "CMA.DIR", "-c", ONE, "--main", "MAIN", "--format", "json"]
    found = CliRunner().invoke(app, [*command, "--search", "CUS.DIR=cycles"])
    assert found.exit_code == 0, found.output

    (tmp_path / "cncsub.toml").write_text(
        f'control = "{ONE}"\nfolders = ["SHAFT.WPD", "CMA.DIR"]\nsearch = {{ "CUS.DIR" = "cycles" }}\n'
    )
    listed = CliRunner().invoke(app, ["list"])
    assert listed.exit_code == 0, listed.output
    assert "CMA.DIR/PART" in listed.output
    tree = CliRunner().invoke(app, ["tree", "--main", "MAIN"])
    assert "PART" in tree.output
    assert "CMA.DIR" not in tree.output.split("note")[0]


@pytest.mark.parametrize("inside", [".", "SHAFT.WPD", "cycles"])
def test_the_spelling_of_a_path_changes_no_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, inside: str
) -> None:
    main = {"SHAFT.WPD/MAIN.MPF": MAIN, "SPF.DIR/OTHER.SPF": "N50 M17\n"}
    written(tmp_path, {**main, "cycles/PART.SPF": "N30 R1=1\nN31 M17\n"})
    written(tmp_path, {"CST.DIR/PART.SPF": "N40 R1=2\nN41 M17\n"})
    places = ["SHAFT.WPD", "CST.DIR", "SPF.DIR"]
    whole = cncsub.load(
        *(tmp_path / place for place in places),
        control=ONE,
        search={"CUS.DIR": tmp_path / "cycles"},
    )
    monkeypatch.chdir(tmp_path / inside)
    near = [os.path.relpath(tmp_path / place) for place in places]
    cycles = os.path.relpath(tmp_path / "cycles")
    library = cncsub.load(*near, control=ONE, search={"CUS.DIR": cycles})
    assert blocks(library.run("MAIN")) == blocks(whole.run("MAIN"))
    assert library.run("MAIN").variables["R1"] == 1
    assert all(Path(file).is_file() for file in library.files)


def test_a_file_without_its_folder_lies_in_the_present_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    files = {"A.WPD/MAIN.MPF": MAIN, "A.WPD/PART.SPF": "N30 R1=1\nN31 M17\n"}
    written(tmp_path, {**files, "B.WPD/PART.SPF": "N40 R1=2\nN41 M17\n"})
    monkeypatch.chdir(tmp_path / "A.WPD")
    for paths in (["../B.WPD", "MAIN.MPF", "PART.SPF"], ["../B.WPD", "."]):
        library = cncsub.load(*paths, control=ONE)
        assert library.run("MAIN").variables["R1"] == 1, paths
    assert [str(Path(f)) for f in cncsub.load("MAIN.MPF", control="fanuc-0i-f").files] == [
        "MAIN.MPF"
    ]


@pytest.mark.parametrize(
    ("search", "words"),
    [
        ({"CUS.DIR": "my cycles"}, "search: CUS.DIR cannot be my cycles: the folder has blanks"),
        ({"CUS.DIR": "c" * 48}, "the folder has a name of more than 47 bytes; rename it"),
        ({"CUS.DIR": "/"}, "search: CUS.DIR cannot be /: the folder has no name"),
        ({"CUS.DIR": "a", "cus.dir": "b"}, "search: cus.dir is given twice"),
        ({"CUS.DIR": "A.MPF"}, "search: CUS.DIR must be a folder, and A.MPF is a file"),
    ],
)
def test_a_folder_that_cannot_stand_for_one_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, search: dict[str, str], words: str
) -> None:
    monkeypatch.chdir(written(tmp_path, {"A.MPF": MAIN}))
    with pytest.raises(ValueError, match=re.escape(words)):
        cncsub.load("A.MPF", control=ONE, search=search)


@pytest.mark.parametrize(
    ("search", "words"),
    [
        ({5: "."}, "search: the folder 5 must be a text; give the folders as"),
        ({"CUS.DIR": 5}, "search: CUS.DIR must be a path, not int; give the folders as"),
        ("CUS.DIR", "search must be a mapping, not str; give the folders as"),
    ],
)
def test_what_is_no_mapping_of_folders_is_no_search(
    tmp_path: Path, search: Any, words: str
) -> None:
    with pytest.raises(TypeError, match=re.escape(words)):
        cncsub.load(written(tmp_path, FILES), control=ONE, search=search)


def test_the_command_takes_a_folder_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(written(tmp_path, {"A.MPF": MAIN}))
    command = ["run", "A.MPF", "-c", ONE, "--search", "CUS.DIR=a"]
    for second in ("CUS.DIR=b", "cus.dir=b"):
        refused = CliRunner().invoke(app, [*command, "--search", second])
        assert refused.exit_code == 2
        assert "is given twice" in refused.output


def test_a_folder_near_a_file_is_found_among_many(tmp_path: Path) -> None:
    written(tmp_path, {"A.WPD/MAIN.MPF": MAIN, "CUS.DIR/PART.SPF": "N30 M17\n"})
    for number in range(30):
        (tmp_path / f"B{number}.WPD").mkdir()
    result = CliRunner().invoke(app, ["run", str(tmp_path / "A.WPD/MAIN.MPF"), "-c", ONE])
    assert result.exit_code == 0, result.output


@pytest.mark.parametrize("each", ["file", "beside"])
def test_the_files_of_a_batch_find_what_each_finds_alone(tmp_path: Path, each: str) -> None:
    folder = written(tmp_path, FILES) / "WKS.DIR" / "SHAFT.WPD"
    found = each == "beside"
    (run,) = cncsub.run_many([folder], ONE, each=each, jobs=1).to_pylist()
    assert run["stop"] == ("end" if found else "alarm")
    (gated,) = gate([folder], ONE, each=each, jobs=1).files
    assert gated.passes() is found
