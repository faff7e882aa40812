"""Measure flattening: `python tests/benchmarks/flattening.py [--blocks N]`.

Measures each way to come to a million blocks: how many blocks of the run are flattened in a second
of processor time (reading is not counted), the run alone without and with its moves, and the memory
of the text, which is written in pieces.
"""

from __future__ import annotations

import argparse
import json
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import report

import cncsub

CONTROL = "fanuc-0i-f"
_PASSES = 9999  # the repeats of one M98 L

# For each name, the program that executes about so many blocks.
KINDS: dict[str, Callable[[int], str]] = {
    "plain moves, once each": lambda n: (
        "O1\nG90 G1 F900\n"
        + "".join(f"X{i * 37 % 9000 / 10:.1f} Y{i * 53 % 700 / 10:.1f}\n" for i in range(n))
        + "M30\n"
    ),
    "modes and moves, once each": lambda n: (
        "O1\n"
        + "".join(f"G90 G1 X{i % 700}.5 Y-{i % 50}.25 F{i % 90 + 100} M8\n" for i in range(n))
        + "M30\n"
    ),
    "M98 L of plain moves": lambda n: (
        "O1\nG91 G1 F900\nM98 P2 L9999\nM30\nO2\n"
        + "".join(f"X{i % 7}.5 Y-{i % 5}.25\n" for i in range(max(1, n // _PASSES)))
        + "M99\n"
    ),
    "G65 with computed words": lambda n: (
        "O1\nG90 G1 F900\n#100=0\n"
        f"WHILE[#100 LT {n // 6}]DO1\nG65 P2 A[#100/7] B2.5\n#100=#100+1\nEND1\nM30\n"
        "O2\nG1 X#1 Y[#2*#1]\nM99\n"
    ),
    "WHILE, SIN and COS": lambda n: (
        "O1\nG90 G1 F900\n#1=0\n"
        f"WHILE[#1 LT {n // 4}]DO1\nG1 X[10*COS[#1]] Y[10*SIN[#1]]\n#1=#1+1\nEND1\nM30\n"
    ),
}


def measured(name: str, blocks: int) -> dict[str, float]:
    library = cncsub.loads(KINDS[name](blocks), control=CONTROL)
    most = 10 * blocks + 100_000
    seconds = []
    for trace in ("none", "moves"):
        start = time.process_time()
        run = library.run(trace=trace, max_blocks=most)
        seconds.append(time.process_time() - start)
        assert run.stop is cncsub.Stop.END, run.alarm
        executed = run.blocks
        del run
    with tempfile.TemporaryDirectory() as folder:
        start = time.process_time()
        flat = library.flatten(max_blocks=most)
        flattening = time.process_time() - start
        file = Path(folder) / "flat.nc"
        flat.write(file)
        size = file.stat().st_size
    return {
        "executed": executed,
        "none": executed / seconds[0],
        "moves": executed / seconds[1],
        "flat": executed / flattening,
        "bytes": size,
        "peak": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024,
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--blocks", type=int, default=1_000_000)
    parser.add_argument("--one", help="measure one kind in this process")
    options = parser.parse_args()
    if options.one:
        print(json.dumps(measured(options.one, options.blocks)))
        return
    rows = []
    for name in KINDS:
        command = [sys.executable, __file__, "--blocks", str(options.blocks), "--one", name]
        of = json.loads(subprocess.check_output(command, text=True))
        millions = [f"{of[key] / 1e6:.1f}" for key in ("flat", "moves", "none")]
        size = [f"{of[key] / 1e6:.0f} MB" for key in ("bytes", "peak")]
        rows.append([name, f"{of['executed']:,.0f}", *millions, *size])
    head = ["blocks", "executed", "flattened, M/s", "run with moves", "run", "text", "memory"]
    print("\n".join(report.markdown(head, rows)))


if __name__ == "__main__":
    main()
