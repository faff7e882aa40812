"""Measure the debugger's engine: `python tests/benchmarks/stepping.py [--blocks N] [--back N]`.

Measures in processor time a run of a million blocks without a breakpoint, with one that is never
met and with one that counts (the limit is 1.3 times the run without), and in a run of ten million
blocks going back to steps all over it (the limit is 50 ms), with the memory of what is kept for
that (the limit is 64 MB). A run that records nothing is measured as well: the one with moves is
what `library.machine()` makes.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from random import Random

import cncsub

CONTROL = "fanuc-0i-f"
ROUNDS = 5
LOOP = (
    "O1\nN10 G90 G1 F900\nN20 #1=0\nN30 WHILE[#1 LT {passes}]DO1\nN40 X#1\nN50 #1=#1+1\nN60 END1\n"
    "N70 M30\nN80 M99\n"
)


def fastest(measured: Callable[[], object]) -> float:
    """Return the processor time of the fastest of some rounds, s."""
    best = float("inf")
    for _ in range(ROUNDS):
        start = time.process_time()
        measured()
        best = min(best, time.process_time() - start)
    return best


def forwards(blocks: int, trace: str) -> None:
    library = cncsub.loads(LOOP.format(passes=blocks // 4), control=CONTROL)
    points = {
        "no breakpoint": None,
        "one that is not met": "O1:N80",
        "one that counts hits": cncsub.Breakpoint("O1:N50", hits=2**31 - 1),
        "one with a condition": cncsub.Breakpoint("O1:N50", when="#1 LT 0"),
    }
    bare = 0.0
    for name, until in points.items():
        seconds = fastest(
            lambda until=until: library.machine(max_blocks=2 * blocks, trace=trace).run(until=until)  # type: ignore[misc]
        )
        bare = bare or seconds
        print(f"  {name:<22}{seconds * 1e9 / blocks:7.1f} ns a block  {seconds / bare:5.2f} times")


def backwards(blocks: int, trace: str) -> None:
    library = cncsub.loads(LOOP.format(passes=blocks // 4), control=CONTROL)
    machine = library.machine(max_blocks=2 * blocks, trace=trace)
    machine.run()
    random = Random(1)
    end, slowest, total = machine.blocks, 0.0, 0.0
    steps = sorted((random.randrange(end) for _ in range(20)), reverse=True)
    for step in steps:
        start = time.process_time()
        machine.back(step)
        seconds = time.process_time() - start
        slowest, total = max(slowest, seconds), total + seconds
    count, size = machine.core.snapshots
    print(
        f"  back in {end:,} blocks: {total / len(steps) * 1e3:.1f} ms, {slowest * 1e3:.1f} ms at"
        f" most; {count} snapshots, {size / 2**20:.1f} MB"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--blocks", type=int, default=1_000_000, help="of the runs forwards")
    parser.add_argument("--back", type=int, default=10_000_000, help="of the run that goes back")
    asked = parser.parse_args()
    for trace in ("moves", "none"):
        print(f"trace={trace!r}")
        forwards(asked.blocks, trace)
        backwards(asked.back, trace)


if __name__ == "__main__":
    main()
