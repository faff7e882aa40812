"""Generated programs make the same moves on every control, and on LinuxCNC where it is installed.

`python tests/differential --programs 100000` does the same with more of them.
"""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

import cncsub
import grblhal
from comparison import Comparison
from machines import LINUXCNC, OTHER_LANGUAGES, LinuxCnc, Station, rs274
from programs import Call

FOLDER = Path(__file__).resolve().parent / "differential"
SEED = 1
PLACES = tuple(range(200))


def test_every_control_makes_the_moves_that_were_meant(capsys: pytest.CaptureFixture[str]) -> None:
    comparison = Comparison(SEED)
    comparison.compare(PLACES, None)
    assert comparison.differences == 0, capsys.readouterr().out
    assert {s.control for s in comparison.stations} == set(cncsub.controls) - OTHER_LANGUAGES
    assert set(comparison.runs) == {station.name for station in comparison.stations}


@pytest.mark.skipif(
    rs274() is None, reason="rs274 is not installed: Debian package linuxcnc-uspace"
)
def test_linuxcnc_makes_the_moves_that_were_meant(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    comparison = Comparison(SEED)
    comparison.stations = []
    comparison.compare(PLACES, LinuxCnc(rs274() or "", tmp_path))
    assert comparison.differences == 0, capsys.readouterr().out
    assert comparison.runs[LINUXCNC] == len(PLACES)


@pytest.mark.skipif(
    grblhal.grblhal() is None, reason="GRBLHAL names no program that runs grblHAL's parser"
)
def test_grblhal_does_what_its_own_parser_does(tmp_path: Path) -> None:
    _, differences = grblhal.compare(grblhal.grblhal() or "", SEED, range(1000), tmp_path)
    assert differences == []


def test_the_programs_of_grblhal_run_and_some_stop(tmp_path: Path) -> None:
    stops = set()
    for place in range(200):
        own = tmp_path / str(place)
        own.mkdir()
        for name, text in grblhal.write(SEED, place).items():
            (own / name).write_text(text)
        stops.add(grblhal.ours(own).stop)
    assert "end" in stops
    assert len(stops) > 10


def test_the_programs_go_over_the_whole_ground() -> None:
    comparison = Comparison(SEED)
    programs = [comparison.program(place) for place in PLACES]
    assert {program.depth for program in programs} == {0, 1, 2, 3, 4}
    everything = [block for main in programs for p in (main, *main.called()) for block in p.blocks]
    assert {b.repeats for b in everything if isinstance(b, Call)} == {1, 2, 3, 4}
    moves = [block for block in everything if not isinstance(block, Call)]
    assert {(block.modes.motion, block.modes.absolute, block.modes.plane) for block in moves} == {
        (m, a, p)
        for m in ("rapid", "feed", "cw", "ccw")
        for a in (True, False)
        for p in (17, 18, 19)
    }
    arcs = [block for block in moves if block.centre]
    assert {(block.radius > 0) - (block.radius < 0) for block in arcs} == {-1, 0, 1}
    assert {len(block.centre_words) for block in arcs} == {0, 1, 2}


@pytest.mark.parametrize(
    "change",
    [
        {"count_in_p": False, "count_in_l": True},
        {"diameter": False},
        {"increments_by_letter": False},
        {"head": "%"},
    ],
    ids=str,
)
def test_a_program_in_the_wrong_words_is_noticed(
    change: dict[str, object], capsys: pytest.CaptureFixture[str]
) -> None:
    comparison = Comparison(SEED)
    right = next(station for station in comparison.stations if station.name == "gsk-980tdi")
    wrong: Station = replace(right, style=replace(right.style, **change))  # type: ignore[arg-type]
    comparison.stations = [wrong]
    comparison.compare(PLACES[:50], None)
    assert comparison.differences > 0
    assert " on gsk-980tdi: " in capsys.readouterr().out


def test_a_program_can_be_shown() -> None:
    command = [sys.executable, str(FOLDER), "--show", "7"]
    shown = [subprocess.check_output(command, text=True) for _ in range(2)]
    assert shown[0] == shown[1]
    assert all(f"---- {name}\n" in shown[0] for name in set(cncsub.controls) - OTHER_LANGUAGES)
    assert "Move(kind='" in shown[0]
