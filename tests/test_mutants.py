"""The places that `python tests/mutants` changes, and how it decides that a row noticed."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from places import mutants_of
from workshop import ROOT

COMMAND = ROOT / "tests" / "mutants"


def changes(source: str) -> set[str]:
    """Return every mutant of one line, as its text."""
    return {mutant.applied(source) for mutant in mutants_of("x.cpp", source)}


@pytest.mark.parametrize(
    ("source", "mutants"),
    [
        ("  if (a == b) go();", {"  if (a != b) go();", "  ;"}),
        (
            "  if (a && !b) go();",
            {"  if (a || !b) go();", "  if (a && b) go();", "  if (!(a && !b)) go();", "  ;"},
        ),
        ("  return i + 12;", {"  return i - 12;", "  return i + 13;"}),
        ("  return true;", {"  return false;"}),
        ("  done = false;", {"  ;", "  done = true;"}),
        ("  std::vector<int> list;", {"  ;"}),
        ("  say(\"a == b\" + name, '<');", {"  ;"}),
        ("#if 1 == 2", set()),
        ("// a == b", set()),
    ],
)
def test_a_source_is_changed_in_one_place_at_a_time(source: str, mutants: set[str]) -> None:
    assert changes(source) == mutants


def test_an_enumerator_becomes_another_of_its_type() -> None:
    source = "x = Stop::End;\ny = Stop::Alarm;\nz = Op::Call;\n"
    assert changes(source) == {
        "x = Stop::Alarm;\ny = Stop::Alarm;\nz = Op::Call;\n",
        "x = Stop::End;\ny = Stop::End;\nz = Op::Call;\n",
    }


def test_a_mutant_says_where_it_is() -> None:
    [mutant] = mutants_of("x.cpp", "int f() {\n  return a <\n      b;\n}\n")
    assert str(mutant) == "x.cpp:2:12: < -> <="


def test_every_source_of_the_engine_has_places() -> None:
    for file in sorted((ROOT / "cpp" / "cncsub").glob("machine*.cpp")):
        source = file.read_text(encoding="utf-8")
        mutants = mutants_of(file.name, source)
        assert len(mutants) > 50
        assert len({mutant.applied(source) for mutant in mutants} | {source}) == len(mutants) + 1


def test_the_build_tree_stays_out_of_the_repository(tmp_path: Path) -> None:
    command = [sys.executable, str(COMMAND), "--build", str(ROOT / "mutants-build")]
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=tmp_path)
    assert done.returncode == 1
    assert "outside the repository" in done.stderr
    assert not (ROOT / "mutants-build").exists()
