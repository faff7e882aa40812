"""The benchmark runs and prints its tables; no test looks at seconds, but at memory and counts."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent / "benchmarks"

sanitized = pytest.mark.skipif(
    "asan" in os.environ.get("LD_PRELOAD", ""),
    reason="the sanitizer keeps memory that was given back",
)


def printed(script: str, *arguments: str, given: str = "") -> str:
    command = [sys.executable, str(HERE / script), *arguments]
    done = subprocess.run(command, input=given, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_every_kind_of_block_runs_to_its_end() -> None:
    table = printed("kinds.py", "--blocks", "200", "--rounds", "1")
    assert len(table.splitlines()) > 30
    assert "| G90 G1 |" in table


def test_typing_in_an_editor_is_measured() -> None:
    pytest.importorskip("pygls", reason="pygls is not installed")
    table = printed("typing_in_editor.py", "--blocks", "400", "--keys", "1", "--only", "flat")
    assert "| key to diagnostics | " in table
    assert "| key to completion | " in table
    assert len(table.splitlines()) == 22


def test_every_way_to_a_flat_program_is_measured() -> None:
    table = printed("flattening.py", "--blocks", "30000")
    assert len(table.splitlines()) == 7
    assert "| M98 L of plain moves" in table


def test_the_benchmark_prints_its_tables(tmp_path: Path) -> None:
    readme = tmp_path / "README.md"
    readme.write_text("before\n<!-- benchmark -->\nold\n<!-- end of benchmark -->\nbehind\n")
    table = printed("run.py", "--size", "tiny", "--write", str(readme))
    for what in (
        "| flat G1, ",
        "| flat G2 and G3",
        "| M98 L9999",
        "| 12 nested",
        "each called once",
    ):
        assert what in table
    for what in (
        "| G65 with six",
        "| G66 over",
        "| WHILE with",
        "| IF/GOTO",
        "two threads",
        "import",
    ):
        assert what in table
    assert table.count("met |") + table.count("not measured |") == 13
    head, _, tail = readme.read_text().partition(table.strip())
    assert head == "before\n<!-- benchmark -->\n"
    assert tail == "\n<!-- end of benchmark -->\nbehind\n"


# ---- memory ----


def memory(blocks: int, trace: str) -> int:
    """Return the most bytes that a run of so many blocks takes, above those before it."""
    point = printed("proportion.py", "--point", f"M98 loop, trace {trace}", str(blocks))
    _, _, peak = json.loads(point)
    return int(peak)


@sanitized
def test_a_run_that_keeps_nothing_takes_as_much_memory_for_every_length() -> None:
    assert memory(3_000_000, "none") < memory(3_000, "none") + 300_000


@sanitized
@pytest.mark.parametrize(("trace", "most"), [("blocks", 14), ("moves", 48)])
def test_memory_is_in_proportion_to_the_blocks_that_are_kept(trace: str, most: int) -> None:
    small, middle, large = (memory(blocks, trace) for blocks in (300_000, 1_200_000, 4_800_000))
    each = (large - middle) / 3_600_000
    assert each == pytest.approx((middle - small) / 900_000, rel=0.15)
    assert each < most


# ---- counted instructions ----


@pytest.fixture
def instructions(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.syspath_prepend(str(HERE))
    import instructions

    return instructions


def test_a_cost_that_grows_with_the_size_is_a_fault(instructions) -> None:
    even, steep = (instructions.Slope(100, large) for large in (104, 150))
    assert instructions.faults({"flat": even}, {}) == []
    (fault,) = instructions.faults({"flat": steep}, {})
    assert fault.endswith("out of proportion")


def test_a_cost_above_the_stored_one_is_a_fault(instructions) -> None:
    stored = {"GCC 12": {"flat": 100.0}, "GCC 13": {"flat": 90.0}}
    same, other = (instructions.allowed(stored, built) for built in ("GCC 12", "clang 19"))
    dear, dearer = (instructions.Slope(count, count) for count in (120, 190))
    assert instructions.faults({"flat": dear}, same)
    assert not instructions.faults({"flat": dear}, other)  # counts of another compiler say less
    assert instructions.faults({"flat": dearer}, other)


def test_counts_are_stored_for_every_workload(instructions) -> None:
    stored = json.loads(instructions.STORED.read_text())
    names = {name for name in instructions.names() if name}
    assert {built: set(counts) for built, counts in stored.items()} == dict.fromkeys(stored, names)
    assert stored
