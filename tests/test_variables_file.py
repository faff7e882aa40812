"""Variables come from files, and trees are drawn without running."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app

CONTROL = "fanuc-0i-f"


def read(tmp_path: Path, name: str, text: str) -> dict[int, float | None]:
    file = tmp_path / name
    file.write_text(text)
    return cncsub.read_variables(file)


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("v.toml", '500 = 1.5\n501 = "vacant"\n502 = -3\n'),
        ("v.toml", '[variables]\n500 = 1.5\n501 = "#0"\n502 = -3\n'),
        ("v.csv", "number,value\n500,1.5\n#501,\n502,-3\n"),
        ("v.csv", "500;1,5\n501;vacant\n502;-3\n"),
        ("v.txt", "%\nO9999\n#500=1.5 (COUNT)\n#501=#0\n\n#502 = -3.;\nM99\n%\n"),
        ("MACRO", "%\nG10L85P500(3FF8000000000000)\nG10 L85 P501(FFFFFFFFFFFFFFFF)\n"
                  "G10L85P502(C008000000000000)\n%\n"),
    ],
)  # fmt: skip
def test_variables_of_each_kind_of_file(tmp_path: Path, name: str, text: str) -> None:
    assert read(tmp_path, name, text) == {500: 1.5, 501: None, 502: -3.0}


@pytest.mark.parametrize(
    ("name", "text", "told"),
    [
        ("v.txt", "%\n#500=1.\nG1 X5.\n", r"v\.txt:3: not a variable: 'G1 X5\.'"),
        ("v.txt", "#500=#501+1\n", r"v\.txt:1: not a variable"),
        ("v.txt", "#500=1.\n#500=2.\n", r"v\.txt:2: #500 is there twice"),
        ("v.txt", "G10L85P500(12AB)\n", r"v\.txt:1: not a variable"),
        ("v.csv", "500,1\nabc,2\n", r"v\.csv:2: not a variable: 'abc,2'"),
        ("v.csv", "500,one\n", r"v\.csv:1: could not convert"),
        ("v.csv", "500,1,2\n", r"v\.csv:1: not a variable"),
        ("v.toml", "abc = 1\n", r"v\.toml: variables: a variable number must be"),
        ("v.toml", "x = 1\n[variables]\n500 = 1\n", r"the one table variables"),
    ],
)
def test_nothing_is_passed_over(tmp_path: Path, name: str, text: str, told: str) -> None:
    with pytest.raises(ValueError, match=told):
        read(tmp_path, name, text)


def test_set_counts_before_the_file_and_the_project_names_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "p.nc").write_text("O1\n#100=#500+#501\nM30\n")
    (tmp_path / "v.txt").write_text("#500=1.\n#501=2.\n")
    call = ["run", str(tmp_path / "p.nc"), "-c", CONTROL, "--format", "json"]
    told = ["--variables", str(tmp_path / "v.txt"), "--set", "501=5"]
    done = CliRunner().invoke(app, [*call, *told])
    assert json.loads(done.stdout)["variables"]["100"] == 6
    (tmp_path / "cncsub.toml").write_text('variables = "v.txt"\n')
    monkeypatch.chdir(tmp_path)
    done = CliRunner().invoke(app, call)
    assert json.loads(done.stdout)["variables"]["100"] == 3


TREE = """O1
N10 G65 P2 A1. B[#100+1] L3
N20 M98 P#5
N30 M98 P2
N40 M98 P9
N50 M30
O2
N60 M98 P3
N70 M99
O3
N80 M98 P2
N90 M99
"""


def tree(tmp_path: Path, *options: str) -> str:
    (tmp_path / "p.nc").write_text(TREE)
    call = ["tree", str(tmp_path / "p.nc"), "-c", CONTROL, *options]
    return CliRunner().invoke(app, call).output


def test_a_static_tree_tells_callers_arguments_passes_and_what_is_missing(tmp_path: Path) -> None:
    assert tree(tmp_path, "--static").splitlines() == [
        f"O1 on {cncsub.controls[CONTROL].title}, as it is written",
        "|-- G65 O2 A1. B[#100+1], 3 passes, from O1 N10",
        "|   `-- M98 O3, from O2 N60",
        "|       `-- M98 O2, which is already open, from O3 N80",
        "|-- M98 [#5], from O1 N20",
        "|-- M98 O2, see above, from O1 N30",
        "`-- M98 O9, which does not exist, from O1 N40",
    ]
    rows = json.loads(tree(tmp_path, "--static", "--format", "json"))["calls"]
    assert [(row["program"], row["depth"]) for row in rows][:3] == [("O2", 0), ("O3", 1), ("O2", 2)]
    assert rows[3]["expression"] == "#5"
    assert rows[0]["arguments"] == ["A1.", "B[#100+1]"]


def test_what_only_runs_take_is_refused_by_a_static_tree(tmp_path: Path) -> None:
    assert "--start would have no effect" in tree(tmp_path, "--static", "--start", "10")


def test_a_tree_that_ran_tells_arguments_and_callers(tmp_path: Path) -> None:
    text = "O1\nN10 G65 P2 A1.\nN20 G65 P2 A2.\nN30 G65 P3 A1.\nN40 M30\nO2\nM99\nO3\nM99\n"
    (tmp_path / "p.nc").write_text(text)
    call = ["tree", str(tmp_path / "p.nc"), "-c", CONTROL]
    assert CliRunner().invoke(app, call).output.splitlines()[1:] == [
        "|-- G65 O2 (1 block) x 2 A=1 (the first; they differ), from O1 N10",
        "`-- G65 O3 (1 block) A=1, from O1 N30",
    ]
    facts = json.loads(CliRunner().invoke(app, [*call, "--format", "json"]).stdout)["calls"]
    assert facts[0]["caller_n"] == 10
    assert facts[0]["arguments"] == {"1": 1.0}
    assert facts[0]["arguments_vary"] is True
