"""Count instructions, which depend on no other work: `python tests/benchmarks/instructions.py`.

Every workload runs in three sizes under valgrind's callgrind, each four times the one before. The
cost of one more block is the slope between two sizes. Two things fail: a slope that grows with the
size, because the cost has to stay in proportion; and a slope above that of `instructions.json` by
more than the margin. `--store` writes the counts of this run into that file.

Counts depend on the compiler. If `instructions.json` has no counts of the compiler that built the
module, those of another are compared, with a margin so wide that only a blunder exceeds it.
"""

from __future__ import annotations

import argparse
import gc
import json
import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from importlib import util
from pathlib import Path

import kinds
import mixed
import report
import texts

STORED = Path(__file__).resolve().with_name("instructions.json")
STEPS = (1, 4, 16)
PROPORTION = 1.10  # how much the slope may grow: tables double, columns begin small
MARGIN = 1.10  # above the stored count of the same compiler: for its patch level and the C library
OTHER_MARGIN = 1.75  # above the count of another compiler


@dataclass(frozen=True)
class Counted:
    """A workload: its text for a size, and how many units of work a size has."""

    title: str  # the name of one unit
    text: Callable[[int], str]
    units: int  # the units of size 1
    control: str = "fanuc-0i-f"
    trace: str = "none"
    reads: bool = False  # reading is counted too
    kind: kinds.Kind | None = None  # the units are blocks of this kind, with its setup


COUNTED = {
    "flat": Counted("G1 block", lambda size: texts.flat(1000 * size), 1000, reads=True),
    "flat, kept": Counted(
        "G1 block, step and move kept", lambda size: texts.flat(1000 * size), 1000, trace="moves"
    ),
    "arcs": Counted(
        "G2 block, step and move kept",
        lambda size: texts.arcs(1000 * size),
        1000,
        trace="moves",
        reads=True,
    ),
    "calls": Counted(
        "pass of an M98 L: eight G1 blocks, kept, and M99",
        lambda size: texts.call_loop(1, 125 * size),
        125,
        trace="moves",
    ),
    "nested": Counted(
        "M98 with its M99", lambda size: texts.nested(12, 100 * size), 1200, control="gsk-988ta"
    ),
    "subprograms": Counted(
        "small subprogram of two blocks, called once",
        lambda size: texts.subprograms(100 * size),
        100,
        reads=True,
    ),
    "macros": Counted(
        "G65 with six arguments, with its M99",
        lambda size: texts.macro_calls(10, 100 * size),
        1000,
    ),
    "holes": Counted(
        "hole of a G66: five blocks, four moves, kept",
        lambda size: texts.hole_pattern(200 * size),
        200,
        trace="moves",
    ),
    "sine": Counted(
        "pass of a WHILE: two assignments, a sine, END",
        lambda size: texts.sine_loop(1000 * size),
        1000,
    ),
    "jump": Counted(
        "pass of IF/GOTO: an assignment, a jump",
        lambda size: texts.jump_loop(1000 * size, 50),
        1000,
    ),
    "mill": Counted(
        "block of a milling program: tools, drilling, contours, helices, five axes",
        lambda size: mixed.milling(mixed.MILL_ROUND * size),
        mixed.MILL_ROUND,
        trace="moves",
        reads=True,
    ),
    "turn": Counted(
        "block of a turning program: roughing, nose radius, threads",
        lambda size: mixed.turning(10 * mixed.TURNED_PART * size),
        10 * mixed.TURNED_PART,
        trace="moves",
        reads=True,
        control="gsk-988ta",
    ),
}


BLOCKS = 400  # the blocks of a kind in size 1


def of_kind(kind: kinds.Kind) -> Counted:
    """Return a workload of blocks of a kind whose steps and moves are kept."""

    def text(size: int) -> str:
        return kind.text(BLOCKS * size)[0]

    return Counted(kind.title, text, kind.text(BLOCKS)[1], trace="moves", reads=True, kind=kind)


COUNTED |= {f"kind {name}": of_kind(kind) for name, kind in kinds.KINDS.items()}


@dataclass(frozen=True)
class Slope:
    """Instructions for one more unit, between the smaller two sizes and between the larger two."""

    small: float
    large: float

    @property
    def in_proportion(self) -> bool:
        return self.large <= self.small * PROPORTION


# ---- counting ----


def mark() -> None:
    """Make callgrind write down its count and begin a new one."""
    os.getpriority(os.PRIO_PROCESS, 0)


def work(folder: Path) -> None:
    """Read and run every file in the order of `names`; this is the work that is counted."""
    import cncsub

    gc.disable()  # garbage collection would add counts that depend on unrelated allocations
    for size in (STEPS[0], *STEPS):  # the first pass makes what is made only once
        for name, counted in COUNTED.items():
            file = folder / f"{name} {size}.nc"
            mark()
            library = cncsub.load(file, control=counted.control)
            mark()
            setup = counted.kind.setup if counted.kind else None
            run = library.run(max_blocks=10**9, trace=counted.trace, setup=setup)
            mark()
            assert str(run.stop) == "end", (name, run.alarm)
            del run, library


def names() -> Iterator[str]:
    """Yield the name of the work between two marks, empty where its count is not used."""
    for _ in (STEPS[0], *STEPS):
        for name, counted in COUNTED.items():
            yield ""
            yield f"read {name}" if counted.reads else ""
            yield name


def count(folder: Path) -> list[int]:
    """Return the counts between the marks of `work`, in a Python under callgrind."""
    for name, counted in COUNTED.items():
        for size in STEPS:
            (folder / f"{name} {size}.nc").write_text(counted.text(size), encoding="ascii")
    out = folder / "callgrind.out"
    valgrind = ["valgrind", "--tool=callgrind", "--dump-before=getpriority"]
    command = [*valgrind, f"--callgrind-out-file={out}", sys.executable, __file__]
    environment = os.environ | {"PYTHONHASHSEED": "0"}
    done = subprocess.run(
        [*command, "--work", str(folder)],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode != 0:
        raise SystemExit(done.stderr[-2000:])
    parts = len(list(names()))
    return [total(out.with_name(f"{out.name}.{part}")) for part in range(1, parts + 1)]


def total(file: Path) -> int:
    """Return the count of one file of callgrind: the n-th has what was before the n-th mark."""
    found = re.search(r"^(?:totals|summary): (\d+)", file.read_text(), re.MULTILINE)
    if found is None:
        raise SystemExit(f"{file.name} of callgrind has no total")
    return int(found[1])


def slopes(counts: list[int]) -> dict[str, Slope]:
    """Return the slopes by the name of the workload."""
    by_name: dict[str, list[int]] = {}
    for name, instructions in zip(names(), counts):
        if name:
            by_name.setdefault(name, []).append(instructions)
    found = {}
    for name, (_, *of_sizes) in by_name.items():
        counted = COUNTED[name.removeprefix("read ")]
        small, large = (
            (of_sizes[k + 1] - of_sizes[k]) / (STEPS[k + 1] - STEPS[k]) / counted.units
            for k in (0, 1)
        )
        found[name] = Slope(small, large)
    return found


# ---- comparing ----


def compiler() -> str:
    """Return the compiler that built the module, by the mark it leaves there, and the processor."""
    module = util.find_spec("cncsub._core")
    assert module is not None
    assert module.origin is not None
    data = Path(module.origin).read_bytes()
    for name, pattern in (("clang", rb"clang version (\d+)"), ("GCC", rb"GCC: \([^)]*\) (\d+)")):
        if found := re.search(pattern, data):
            return f"{name} {int(found[1])} {platform.machine()}"
    return f"unknown {platform.machine()}"


def allowed(stored: Mapping[str, Mapping[str, float]], built: str) -> dict[str, float]:
    """Return the most instructions of each workload: the stored ones with the margin that fits."""
    if built in stored:
        return {name: count * MARGIN for name, count in stored[built].items()}
    most: dict[str, float] = {}
    for counts in stored.values():
        for name, count in counts.items():
            most[name] = max(most.get(name, 0), count * OTHER_MARGIN)
    return most


def faults(found: Mapping[str, Slope], most: Mapping[str, float]) -> list[str]:
    """Return what is wrong: costs out of proportion, and costs that rose."""
    wrong = []
    for name, slope in found.items():
        if not slope.in_proportion:
            wrong.append(
                f"{name}: one more costs {slope.small:.0f} instructions, in a larger size"
                f" {slope.large:.0f}: out of proportion"
            )
        if slope.large > most.get(name, float("inf")):
            wrong.append(
                f"{name}: one more costs {slope.large:.0f} instructions, more than the"
                f" {most[name]:.0f} that are allowed"
            )
    return wrong


def table(found: Mapping[str, Slope]) -> str:
    """Return a table of what one more unit of each workload costs."""

    def cell(name: str) -> str:
        return f"{found[name].large:,.0f}" if name in found else ""

    rows = [(c.title, cell(f"read {name}"), cell(name)) for name, c in COUNTED.items()]
    return "\n".join(report.markdown(["one more", "instructions to read it", "to run it"], rows))


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--store", action="store_true", help="what was counted is the new measure")
    parser.add_argument("--write", type=Path, help="a file whose marked table is replaced")
    parser.add_argument("--work", type=Path, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.work:
        work(arguments.work)
        return 0
    if shutil.which("valgrind") is None:
        print("There is no valgrind here. On Debian: apt-get install valgrind", file=sys.stderr)
        return 2
    stored = json.loads(STORED.read_text()) if STORED.exists() else {}
    built = compiler()
    with tempfile.TemporaryDirectory() as folder:
        found = slopes(count(Path(folder)))
    most = allowed(stored, built)
    print(f"built by {built}; stored are the counts of {', '.join(stored) or 'nobody'}")
    print(table(found))
    if arguments.write:
        report.write(arguments.write, "instructions", table(found))
    if arguments.store:
        stored[built] = {name: round(slope.large, 1) for name, slope in found.items()}
        STORED.write_text(json.dumps(stored, indent=2) + "\n")
        return 0
    wrong = faults(found, most)
    print("\n".join(wrong) or "in proportion, and no dearer than stored")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
