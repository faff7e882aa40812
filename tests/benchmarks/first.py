"""Measure what is paid once and what each time: `python tests/benchmarks/first.py [--rounds N]`.

A process pays the system for each page that it touches first. So the first run of a command is
measured as a process of its own: processor seconds, page faults, the most memory. Next to it stands
the cost of the same work repeated in one process. The figures are processor time, the fastest of
some rounds, because other work only adds to them. Reading by two threads is reported twice: the
time of the thread that waits for both, and the time of both together.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import report
import texts

import cncsub
from cncsub import _core

CONTROL = "fanuc-0i-f"
BLOCKS = 1_000_000
PROGRAMS = 10_000
WATCHED = [*range(100, 150)]


def first_times(folder: Path, rounds: int) -> Iterator[tuple[str, str, str, str]]:
    """Yield titles with processor time (ms), page faults and megabytes of a new process."""
    run = [sys.executable, "-m", "cncsub", "run", "--control", CONTROL]
    commands = {
        "`python -c pass`": [sys.executable, "-c", "pass"],
        "`import cncsub`": [sys.executable, "-c", "import cncsub"],
        "`cncsub run`, three blocks": [*run, str(folder / "small.nc")],
        "`cncsub run`, a million G1": [*run, str(folder / "large.nc")],
    }
    for title, command in commands.items():
        best: tuple[float, int, int] | None = None
        for _ in range(rounds):
            process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
            _, status, used = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            if process.returncode != 0:
                raise SystemExit(f"{title}: exit status {process.returncode}")
            figures = used.ru_utime + used.ru_stime, used.ru_minflt, used.ru_maxrss >> 10
            best = figures if best is None else min(best, figures)
        assert best is not None
        yield title, f"{best[0] * 1e3:.0f}", f"{best[1]:,}", f"{best[2]}"


def fastest(work: Callable[[], object], rounds: int) -> tuple[float, float]:
    """Return the processor seconds of all threads, and those of this thread."""
    best = (float("inf"), float("inf"))
    for _ in range(rounds):
        all_before, own_before = time.process_time(), time.thread_time()
        made = work()
        best = min(best, (time.process_time() - all_before, time.thread_time() - own_before))
        del made
    return best


def reading(path: Path, threads: int) -> Callable[[], object]:
    control = cncsub.controls[CONTROL]
    data = path.read_bytes()
    return lambda: _core.compile(control, [(path.name, path.stem, [data], False)], threads=threads)


def again(folder: Path, rounds: int) -> Iterator[tuple[str, str, str]]:
    """Yield titles with the times of all threads and of the thread that asked, in one process."""

    def row(
        title: str, unit: str, times: float, work: Callable[[], object]
    ) -> tuple[str, str, str]:
        both, own = fastest(work, rounds)
        return title, f"{both * times:.4g} {unit}", f"{own * times:.4g} {unit}"

    large = cncsub.load(folder / "large.nc", control=CONTROL)
    run = large.run()
    small = folder / "programs"
    yield row(
        "a folder, a program", "us", 1e6 / PROGRAMS, lambda: cncsub.load(small, control=CONTROL)
    )
    for threads in (1, 2):
        yield row(
            f"a million G1, read by {threads}", "ms", 1e3, reading(folder / "large.nc", threads)
        )
    yield row("a million G1, run", "ms", 1e3, large.run)
    yield row("the same, 50 variables watched", "ms", 1e3, lambda: large.run(watch=WATCHED))
    yield row("all columns of a million moves", "ms", 1e3, lambda: columns(large.run))
    yield row(
        "length and bounds of a million moves",
        "ms",
        1e3,
        lambda: (run.moves.total_length, run.moves.bounds),
    )
    machine = large.machine()
    steps = 100_000
    yield row("`machine.step()`", "us", 1e6 / steps, lambda: [machine.step() for _ in range(steps)])


def columns(run: Callable[[], cncsub.Run]) -> list[object]:
    moves = run().moves
    return [getattr(moves, name) for name in moves.columns]


def write_programs(folder: Path) -> None:
    (folder / "programs").mkdir()
    for number in range(1, PROGRAMS + 1):
        text = texts.small_program(number)
        (folder / "programs" / f"{number:05}.nc").write_text(text, encoding="ascii")
    (folder / "small.nc").write_text("O1\nG1 X1. F100\nM30\n", encoding="ascii")
    (folder / "large.nc").write_text(texts.flat(BLOCKS), encoding="ascii")


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--write", type=Path, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.write:
        write_programs(arguments.write)
        return
    with tempfile.TemporaryDirectory() as made:
        folder = Path(made)
        # This runs in a process of its own: the memory of this one would show in the others.
        subprocess.run([sys.executable, __file__, "--write", made], check=True)
        heads = ["a process of its own", "ms", "page faults", "MB"]
        print("\n".join(report.markdown(heads, list(first_times(folder, arguments.rounds)))))
        heads = ["done again", "all threads", "the one that asked"]
        print("\n".join(["", *report.markdown(heads, list(again(folder, arguments.rounds)))]))


if __name__ == "__main__":
    main()
