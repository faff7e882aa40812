"""The blocks that ran, one by one: `run.listing()` and `cncsub run --listing`."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app

CONTROL = "fanuc-0i-f"
TEXT = """O1
N10 M98 P2 L2
N20 G4 X1.5
N30 M30
O2
N10 #100=#100+1
N20 G91 G1 X#100 F600
N30 M99
"""


@pytest.fixture
def run() -> cncsub.Run:
    return cncsub.loads(TEXT, control=CONTROL).run(watch=[100, 101], variables={100: 4})


def test_each_block_with_what_it_did(run: cncsub.Run) -> None:
    assert [str(block) for block in run.listing()] == [
        "     0  O1:2  N10 M98 P2 L2  ->  calls O2",
        "     1  | O2:6  N10 #100=#100+1  ->  #100 = 5",
        "     2  | O2:7  N20 G91 G1 X#100 F600  ->  feed X5 Y0 Z0",
        "     3  | O2:8  N30 M99",
        "     4  | O2:6  pass 2  N10 #100=#100+1  ->  #100 = 6",
        "     5  | O2:7  pass 2  N20 G91 G1 X#100 F600  ->  feed X11 Y0 Z0",
        "     6  | O2:8  pass 2  N30 M99  ->  back to O1 N20",
        "     7  O1:3  N20 G4 X1.5  ->  dwell 1.5 s",
        "     8  O1:4  N30 M30",
    ]
    assert [block.repeat for block in run.listing(program="O2", n=10)] == [1, 2]


def test_codes_and_moves_come_before_the_call() -> None:
    text = "O1\nN10 T2 M6\nN20 S900 M3\nN30 G1 X5. F100 M98 P2\nN40 M30\nO2\nM8\nM99\n"
    listed = list(cncsub.loads(text, control=CONTROL).run().listing())
    assert [str(block).partition("  ->  ")[2] for block in listed] == [
        "T2 M6",
        "S900 M3",
        "feed X5 Y0 Z0; calls O2",
        "M8",
        "back to O1 N40",
        "",
    ]
    assert [(code.kind, code.value) for code in listed[0].codes] == [("T", 2), ("M", 6)]


@pytest.mark.parametrize(
    ("asked", "steps"),
    [
        ({"program": "O2"}, [1, 2, 3, 4, 5, 6]),
        ({"program": 1}, [0, 7, 8]),
        ({"depth": 0}, [0, 7, 8]),
        ({"n": 20}, [2, 5, 7]),
        ({"variable": 100}, [1, 4]),
        ({"variable": 101}, []),
        ({"program": "O2", "n": 20, "depth": 1}, [2, 5]),
        ({"depth": 7}, []),
    ],
)
def test_filters(run: cncsub.Run, asked: dict[str, Any], steps: list[int]) -> None:
    assert [block.step for block in run.listing(**asked)] == steps


def test_a_listing_agrees_with_the_tables() -> None:
    body = "".join(f"N{i} G91 G1 X{i % 7}. F100\n" for i in range(1, 9999))
    run = cncsub.loads(f"O1\n{body}M30\n", control=CONTROL).run()
    listed = list(run.listing())
    assert [block.step for block in listed] == run.steps.step.tolist()
    assert [move.move for block in listed for move in block.moves] == run.moves.move.tolist()
    assert all(f"N{block.n} " in block.text for block in listed[:-1])


def test_what_cannot_be_listed_is_told(run: cncsub.Run) -> None:
    with pytest.raises(KeyError, match="no program O9"):
        run.listing(program="O9")
    with pytest.raises(ValueError, match=r"#500 was not watched: run\(watch=\[500\]\)"):
        run.listing(variable=500)
    short = cncsub.loads(TEXT, control=CONTROL).run(trace="calls")
    with pytest.raises(ValueError, match="recorded no blocks"):
        short.listing()


def test_a_machine_lists_what_it_did_until_now() -> None:
    machine = cncsub.loads(TEXT, control=CONTROL).machine()
    machine.step()
    machine.step()
    assert [block.text for block in machine.listing()] == ["N10 M98 P2 L2", "N10 #100=#100+1"]


# ---- the command ----


def command(*arguments: str | Path) -> tuple[int, str, str]:
    done = CliRunner().invoke(app, ["run", "-c", CONTROL, *map(str, arguments)])
    return done.exit_code, done.stdout, done.stderr


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "part.nc"
    path.write_text(TEXT)
    return path


def test_the_command_lists(file: Path) -> None:
    status, out, err = command(file, "--listing", "--where", "program=O2", "--where", "n=N20")
    assert status == 0
    assert out.splitlines() == [
        "     2  | O2:7  N20 G91 G1 X#100 F600  ->  feed X1 Y0 Z0",
        "     5  | O2:7  pass 2  N20 G91 G1 X#100 F600  ->  feed X3 Y0 Z0",
    ]
    assert "the program ended" in err


def test_a_variable_that_is_asked_for_is_watched(file: Path) -> None:
    _, out, _ = command(file, "--listing", "--where", "variable=#100", "--format", "json")
    rows = [json.loads(line) for line in out.splitlines()]
    assert [(row["step"], row["changes"][0]["value"]) for row in rows] == [(1, 1.0), (4, 2.0)]
    assert rows[0]["program"] == "O2"


def test_a_listing_is_written_to_a_file(file: Path, tmp_path: Path) -> None:
    status, out, _ = command(file, "--listing", "-o", tmp_path / "listing.txt")
    assert (status, out) == (0, "")
    assert len((tmp_path / "listing.txt").read_text().splitlines()) == 9


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--where", "n=1"], "give --listing too"),
        (["--listing", "--where", "block=1"], "--where must be program=, depth=, n= or variable="),
        (["--listing", "--where", "n=-1"], "must be a whole number"),
        (["--listing", "--where", "n=1", "--where", "n=2"], "given twice"),
        (["--listing", "--where", "program=O9"], "no program O9"),
        (["--listing", "--format", "csv"], "--listing takes text or json"),
    ],
)
def test_wrong_use_of_the_listing(file: Path, arguments: list[str], message: str) -> None:
    status, out, err = command(file, *arguments)
    assert (status, out) == (2, "")
    assert message in err
