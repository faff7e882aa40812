"""`cncsub list`: programs, their heads, and who calls whom."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from cncsub.cli import app

MAIN = "O1 (PART)\nN10 M98 P2 L3\nN20 M98 P2\nN30 G65 P9 A1.\nN40 M98 P#100\nM30\n"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "main.nc").write_text(MAIN)
    (tmp_path / "sub.nc").write_text("O2\nM99\nO3\nM98 P2\nM99\n")
    (tmp_path / "sub.png").write_bytes(b"\x89PNG\0\0")
    return tmp_path


def listed(*arguments: str | Path) -> tuple[int, str, str]:
    done = CliRunner().invoke(app, ["list", "-c", "fanuc-0i-f", *map(str, arguments)])
    return done.exit_code, done.stdout, done.stderr


def test_programs_and_who_calls_whom(folder: Path) -> None:
    status, out, err = listed(folder)
    assert status == 0
    assert out.splitlines() == [
        f"O1  {folder / 'main.nc'}:1 (PART), 5 blocks, main",
        "    calls M98 O2 (2 times); G65 O9, which does not exist; M98 [#100]",
        f"O2  {folder / 'sub.nc'}:1, 1 block",
        "    called by O1; O3",
        f"O3  {folder / 'sub.nc'}:3, 2 blocks",
        "    calls M98 O2",
    ]
    assert "sub.png: left out" in err


def test_json(folder: Path) -> None:
    _, out, _ = listed(folder, "--format", "json")
    facts = json.loads(out)
    assert [row["program"] for row in facts["programs"]] == ["O1", "O2", "O3"]
    assert facts["programs"][0]["main"]
    assert [call["exists"] for call in facts["programs"][0]["calls"]] == [True, True, False, None]
    assert facts["programs"][1]["callers"] == ["O1", "O3"]
    assert [note["kind"] for note in facts["notes"]] == ["left-out"]


def test_the_external_device_is_listed(folder: Path, tmp_path: Path) -> None:
    outside = tmp_path / "card"
    outside.mkdir()
    (outside / "O7.nc").write_text("O7 (CARD)\nM99\n")
    _, out, _ = listed(folder / "main.nc", "--external", outside)
    assert f"O7  {outside / 'O7.nc'}:1 (CARD), 1 block, external" in out.splitlines()


def test_two_programs_of_one_number_are_listed_and_told(folder: Path) -> None:
    (folder / "copy.nc").write_text("O2\nG4 X1.\nM99\n")
    status, _, err = listed(folder)
    assert status == 0
    assert "this O2 is never called" in err
    status, out, _ = listed(folder, "--prefer", folder / "sub.nc")
    assert f"O2  {folder / 'sub.nc'}:1, 1 block" in out
    assert "O1  " in out
