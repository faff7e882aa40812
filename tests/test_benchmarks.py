"""The benchmark runs and prints its table; its figures are nobody's test."""

import subprocess
import sys
from pathlib import Path

BENCHMARK = Path(__file__).resolve().parent / "benchmarks" / "run.py"


def test_the_benchmark_prints_its_table(tmp_path: Path) -> None:
    readme = tmp_path / "README.md"
    readme.write_text("before\n<!-- benchmark -->\nold\n<!-- end of benchmark -->\nbehind\n")
    command = [sys.executable, str(BENCHMARK), "--size", "tiny", "--write", str(readme)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("| what | median | |\n|---|---:|---|\n| flat G1, ")
    for what in ("M98 L9999", "each called once", "nested", "G65", "WHILE", "IF..GOTO", "import"):
        assert what in done.stdout
    head, _, tail = readme.read_text().partition(done.stdout.strip())
    assert head == "before\n<!-- benchmark -->\n"
    assert tail == "\n<!-- end of benchmark -->\nbehind\n"
