"""Run generated programs on every control and on LinuxCNC, and compare the moves.

    python tests/differential --programs 100000 --seed 1
    python tests/differential --show 17 --seed 1

The programs use only what the controls share, see `spelling.py`. Half of them are for lathes, in X
and Z, and run on all controls; half are for mills, in three axes. All have to make the moves that
the generator meant. LinuxCNC runs both kinds if its `rs274` is on the path (Debian:
`linuxcnc-uspace`); otherwise it is skipped, and that is reported.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from comparison import Comparison
from machines import LINUXCNC, LinuxCnc, rs274
from programs import moves_of

BATCH = 100  # programs in one file of LinuxCNC


def show(comparison: Comparison, place: int) -> None:
    """Print one program as every control gets it, and its moves."""
    program = comparison.program(place)
    for station in comparison.on(place):
        print(f"---- {station.name}\n{comparison.text(place, program, station)}")
    print("\n".join(map(str, moves_of(program))))


def report(comparison: Comparison, seconds: float) -> Iterator[str]:
    programs = sum(comparison.calls.values())
    depths = ", ".join(
        f"{count} of depth {depth}" for depth, count in sorted(comparison.calls.items())
    )
    yield f"{programs} programs, {comparison.moves} moves, seed {comparison.seed}"
    yield depths
    runs = sum(comparison.runs.values())
    yield f"{runs} runs on {len(comparison.runs)} machines, {seconds:.0f} s:"
    yield from (f"    {count:>8}  {name}" for name, count in comparison.runs.items())
    if LINUXCNC not in comparison.runs:
        yield f"{LINUXCNC}: skipped, rs274 is not installed (Debian package linuxcnc-uspace)"
    yield f"{comparison.differences} differences"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--programs", type=int, default=1000, help="how many are tried")
    parser.add_argument("--seed", type=int, default=1, help="which series of programs")
    parser.add_argument("--show", type=int, metavar="PLACE", help="print this one, run none")
    options = parser.parse_args()
    comparison = Comparison(options.seed)
    if options.show is not None:
        show(comparison, options.show)
        return 0
    start = time.monotonic()
    command = rs274()
    with tempfile.TemporaryDirectory() as folder:
        linuxcnc = LinuxCnc(command, Path(folder)) if command else None
        for first in range(0, options.programs, BATCH):
            places = tuple(range(first, min(first + BATCH, options.programs)))
            comparison.compare(places, linuxcnc)
    print("\n".join(report(comparison, time.monotonic() - start)))
    return 1 if comparison.differences else 0


if __name__ == "__main__":
    sys.exit(main())
