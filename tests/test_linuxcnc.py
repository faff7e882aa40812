"""Generated programs of LinuxCNC's motion do the same on cncsub and on its interpreter, where that
is installed.

`python tests/differential/linuxcnc_paths.py --programs 100000 --together 50` does the same with more.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

import cncsub
import linuxcnc_blocks
import linuxcnc_flat
import linuxcnc_moves
from linuxcnc_paths import KINDS, compare, on_cncsub, program

SEED = 1
RS274 = shutil.which("rs274")
MOVES = tuple(kind for kind in KINDS if kind not in linuxcnc_blocks.KINDS)


@pytest.mark.skipif(
    shutil.which("rs274") is None, reason="rs274 is not installed: Debian package linuxcnc-uspace"
)
@pytest.mark.parametrize(("programs", "together"), [(120, 1), (400, 50)])
def test_programs_move_as_they_do_on_linuxcnc(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], programs: int, together: int
) -> None:
    report = compare(SEED, range(programs), "rs274", tmp_path, together, MOVES)
    assert report.different == [], capsys.readouterr().out
    assert report.programs > 0.95 * programs
    assert report.moves > 8 * programs
    assert report.stopped >= (together == 1) * programs // 20


def test_the_programs_go_over_the_ground() -> None:
    text = program(SEED, range(300), False, MOVES)
    codes = (
        "G2 G3 G7 G8 G10 G18 G19 G20 G28 G28.1 G30 G30.1 G33 G33.1 G38.2 G38.5 G41 G42 G41.1 G42.1 G43 G43.1"
        " G43.2 G49 G52 G53 G54 G59.3 G73 G74 G76 G81 G82 G83 G84 G85 G86 G89 G90.1 G91.1 G92 G92.3 G98 G99"
        " M70 M72 M73 L20 L10 L11 R45 @ ^ repeat call"
    )
    words = text.replace("@", " @ ").replace("^", " ^ ").split()
    assert [code for code in codes.split() if code not in words] == []


def test_a_program_of_many_moves() -> None:
    outcome = on_cncsub(program(SEED, range(20), True, MOVES))
    assert len(outcome.moves) > 100


@pytest.mark.skipif(RS274 is None, reason="rs274 is not installed: Debian package linuxcnc-uspace")
@pytest.mark.parametrize(("programs", "together"), [(60, 1), (300, 30)])
def test_series_values_and_codes_of_group_00(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], programs: int, together: int
) -> None:
    report = compare(
        SEED, range(programs), "rs274", tmp_path, together, tuple(linuxcnc_moves.KINDS)
    )
    assert report.different == [], capsys.readouterr().out
    assert report.moves > 15 * programs


@pytest.mark.skipif(RS274 is None, reason="rs274 is not installed: Debian package linuxcnc-uspace")
@pytest.mark.parametrize(
    "kind", ["feed", "units", "modes", "calls", "tools", "held", "block", "written"]
)
def test_blocks_that_are_read_or_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], kind: str
) -> None:
    report = compare(SEED, range(60), "rs274", tmp_path, 1, (kind,))
    assert report.different == [], capsys.readouterr().out
    assert report.stopped > 0


@pytest.mark.parametrize("kinds", [MOVES, tuple(linuxcnc_moves.KINDS)], ids=["all", "series"])
def test_flat_programs_move_as_their_originals(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], kinds: tuple[str, ...]
) -> None:
    report = linuxcnc_flat.compare(SEED, range(150), RS274, tmp_path, 10, kinds)
    assert report.different == [], capsys.readouterr().out
    assert sum(report.refused.values()) < 0.3 * report.programs
    assert report.moves > 8 * report.programs


@pytest.mark.parametrize("end", ["%\n", "M2\n%\n"])
@pytest.mark.parametrize("begin", ["", "%\n"])
def test_a_percent_sign_behind_the_end_of_a_sub_is_no_finding(
    tmp_path: Path, begin: str, end: str
) -> None:
    (tmp_path / "main.ngc").write_text(f"{begin}o<s> call\nM2\n{begin}")
    (tmp_path / "s.ngc").write_text(f"o<s> sub\nG0 X5\no<s> endsub\n{end}")
    library = cncsub.load(tmp_path / "main.ngc", tmp_path / "s.ngc", control="linuxcnc")
    assert not library.check()


def test_a_percent_sign_that_a_program_comes_to_is_one_finding() -> None:
    found = cncsub.loads("G0 X1\n%\nG0 X2\nM2\n", control="linuxcnc").check()
    assert [(finding.rule, finding.line) for finding in found] == [("CS101", 2)]
