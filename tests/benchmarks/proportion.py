"""Measure time and memory over five decades of blocks: `python tests/benchmarks/proportion.py`.

Prints a table; `--write FILE.svg` draws it too, which needs matplotlib. Every point is a process of
its own: the median of several runs in it, in seconds of the processor. The exponent is that of the
size from ten thousand blocks on, where the start of a run, some microseconds, no longer shows. It
is 1 where the cost is in proportion, 0 where it stays the same.
"""

from __future__ import annotations

import argparse
import io
import json
import math
import re
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import measure
import report
import texts

DECADES = range(6)
SPEND = 0.2  # seconds after which a point is not repeated
PAGE = 4096  # bytes; a smaller change cannot be seen from outside


@dataclass(frozen=True)
class Line:
    """One line of the drawing: a text of about so many blocks, and what of it is measured."""

    label: str
    text: Callable[[int], str]
    smallest: int  # blocks
    trace: str  # the trace of the run, or "read" to measure the reading
    memory: bool = False  # the memory of the run is drawn too


def call_loop(blocks: int) -> str:
    """Return a program of passes of nine blocks."""
    passes = max(1, blocks // 9)
    return texts.call_loop(max(1, passes // 9999), min(passes, 9999))


def macro_calls(blocks: int) -> str:
    calls = blocks // 2
    each = min(1000, calls // 10)
    return texts.macro_calls(each, calls // each)


def sine_loop(blocks: int) -> str:
    return texts.sine_loop(max(1, blocks // 4))


LINES = [
    Line("reading flat G1", texts.flat, 10, "read"),
    Line("flat G1, trace moves", texts.flat, 10, "moves"),
    Line("M98 loop, trace moves", call_loop, 100, "moves", memory=True),
    Line("M98 loop, trace blocks", call_loop, 100, "blocks", memory=True),
    Line("M98 loop, trace none", call_loop, 100, "none", memory=True),
    Line("G65, trace none", macro_calls, 100, "none"),
    Line("WHILE with a sine, trace none", sine_loop, 100, "none"),
]
Point = tuple[int, float, int]  # blocks, seconds, bytes


def point(line: Line, blocks: int) -> Point:
    """Return the blocks, the seconds, and the bytes of a run above those before it."""
    import cncsub

    with tempfile.NamedTemporaryFile("w", suffix=".nc") as file:
        file.write(line.text(blocks))
        file.flush()
        library = cncsub.load(file.name, control="fanuc-0i-f")
        library.run(max_blocks=1)  # the first run makes what is made only once

        def once() -> object:
            if line.trace == "read":
                return cncsub.load(file.name, control="fanuc-0i-f")
            run = library.run(max_blocks=10**12, trace=line.trace)
            assert run.alarm is None, run.alarm
            return run

        before = measure.memory("VmRSS")
        measure.forget_peak()
        seconds = [seconds_of(once)]
        peak = measure.memory("VmHWM") - before
        while sum(seconds) < SPEND:
            seconds.append(seconds_of(once))
    return blocks, statistics.median(seconds), peak


def seconds_of(act: Callable[[], object]) -> float:
    began = time.process_time()
    made = act()
    done = time.process_time()
    del made  # freeing it is not counted
    return done - began


def points(line: Line) -> list[Point]:
    """Measure all sizes, each in a process of its own."""
    found = []
    for decade in DECADES:
        command = [sys.executable, __file__, "--point", line.label, str(line.smallest * 10**decade)]
        done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
        found.append(tuple(json.loads(done.stdout)))
    return found


def exponent(values: list[tuple[int, float]]) -> float:
    """Return the power of the size with which the values grow, by least squares of the logarithms.

    >>> round(exponent([(10_000, 5.0), (100_000, 50.0), (1_000_000, 500.0)]), 3)
    1.0
    """
    logs = [(math.log(x), math.log(max(y, 1e-9))) for x, y in values if x >= 10_000]
    return statistics.linear_regression(*zip(*logs)).slope


def time_exponent(found: list[Point]) -> float:
    return exponent([(blocks, seconds) for blocks, seconds, _ in found])


def table(measured: dict[str, list[Point]]) -> str:
    rows = []
    for line in LINES:
        found = measured[line.label]
        each = ", ".join(f"{seconds / blocks * 1e9:.3g}" for blocks, seconds, _ in found)
        room = ["", ""]
        if line.memory:
            power = exponent([(blocks, max(peak, PAGE)) for blocks, _, peak in found])
            room = [f"{found[-1][2] / 1e6:.1f} MB", f"{power:.2f}"]
        rows.append((line.label, each, f"{time_exponent(found):.2f}", *room))
    heads = ["", "ns a block by size", "exponent", "memory of the largest", "exponent"]
    return "\n".join(report.markdown(heads, rows))


def draw(measured: dict[str, list[Point]], file: Path) -> None:
    import matplotlib as mpl

    mpl.use("svg")
    mpl.rcParams.update(
        {"svg.fonttype": "none", "svg.hashsalt": "cncsub", "font.size": 9, "lines.markersize": 3}
    )
    from matplotlib import pyplot as plt

    figure, (times, room) = plt.subplots(1, 2, figsize=(10, 4.2), layout="constrained")
    for number, line in enumerate(LINES):
        found = measured[line.label]
        blocks = [point[0] for point in found]
        label = f"{line.label} ({time_exponent(found):.2f})"
        style = {"color": f"C{number}", "marker": "o", "label": label}
        times.plot(blocks, [point[1] for point in found], **style)
        if line.memory:
            style["label"] = line.label
            room.plot(blocks, [max(point[2], PAGE) for point in found], **style)
    for axes, title, start in (
        (times, "seconds of the processor", 1e-5),
        (room, "bytes of memory above those before the run", 1e4),
    ):
        axes.plot(
            [1e2, 1e7], [start, start * 1e5], color="0.7", linestyle=":", label="in proportion"
        )
        axes.set(xscale="log", yscale="log", xlabel="blocks", title=title)
        axes.minorticks_off()
        axes.grid(visible=True, color="0.92")
        axes.legend(frameon=False, fontsize=8)
    drawn = io.StringIO()
    figure.savefig(drawn, format="svg", metadata={"Date": None, "Creator": None})
    file.write_text(re.sub(r" +$", "", drawn.getvalue(), flags=re.MULTILINE), encoding="utf-8")


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--write", type=Path, metavar="FILE.svg", help="draw it")
    parser.add_argument("--point", nargs=2, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.point:
        label, blocks = arguments.point
        line = next(line for line in LINES if line.label == label)
        print(json.dumps(point(line, int(blocks))))
        return
    measured = {line.label: points(line) for line in LINES}
    print(table(measured))
    if arguments.write:
        draw(measured, arguments.write)


if __name__ == "__main__":
    main()
