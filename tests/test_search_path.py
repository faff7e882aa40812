"""The folders of a search path, wherever programs are read, shown and run."""

from __future__ import annotations

import pickle
from pathlib import Path

import pytest
from typer.testing import CliRunner

import cncsub
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
