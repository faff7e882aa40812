"""Measure every common kind of block by itself: `python tests/benchmarks/kinds.py [KIND...]`.

A kind is a few lines, repeated with other numbers. Reading them and running them with moves are
timed apart, in processor time, the fastest of some rounds in one process, because the noise of
other work only adds to it. Everything runs on one core, as LinuxCNC's `rs274` does, which runs the
same file where it is installed and knows the kind. On several cores each would take a part of a
large file, which spends more processor time in all.
"""

from __future__ import annotations

import argparse
import os
import resource
import shutil
import subprocess
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import report

import cncsub

CONTROL = "fanuc-0i-f"


@dataclass(frozen=True)
class Kind:
    """Lines for a number that changes, with what stands before and after them."""

    title: str
    lines: Callable[[int], str]
    before: str = ""
    behind: str = ""  # after the M30: programs that are called
    lathe: bool = False
    peer: bool = True  # rs274 runs the same text

    def text(self, blocks: int) -> tuple[str, int]:
        """Return the program and how many blocks it has."""
        count = len(self.lines(0).splitlines())
        body = "\n".join(self.lines(i) for i in range(max(1, blocks // count)))
        text = f"{self.head}{self.before}{body}\nM30\n{self.behind}"
        return text, count * max(1, blocks // count)

    @property
    def setup(self) -> cncsub.Setup:
        """Return the setup of the machine: a tool, its offsets, a reference point."""
        if self.lathe:
            return cncsub.Setup(
                machine="lathe-a", tools={n: {"R": 0.4 if n == 2 else 1.0} for n in (1, 2, 3)}
            )
        return cncsub.Setup(
            machine="mill",
            radius_offsets={1: 1.0},
            length_offsets={1: 10.0},
            reference={1: {"Z": 100.0}, 2: {"Z": 90.0}},
        )

    @property
    def head(self) -> str:
        return (
            "G21 G90 G17 G40 G94 F500\nG0 X0 Y0 Z5\n" if not self.lathe else "G0 X100. Z5. F0.2\n"
        )


# The same tools for rs274, whose unit is inches: Z is a length, D a diameter.
TOOLS = "".join(f"T{n} P{n} Z0.3937 D0.0787\n" for n in range(1, 10))


def at(i: int, step: int = 0) -> str:
    """Return a place near the origin with three decimals."""
    return f"X{(i * 37 + step * 11) % 1000 / 10:.3f} Y{(i * 53 + step * 7) % 1000 / 10:.3f}"


KINDS = {
    # Moves.
    "line": Kind("plain G1", lambda i: f"G1 {at(i)}"),
    "short": Kind("G1 of one axis", lambda i: f"X{i % 900 / 10:.3f}\nY{i % 700 / 10:.3f}"),
    "numbered": Kind("N number, G1, F", lambda i: f"N{i % 9999 + 1} G1 {at(i)} F{i % 50 + 500}"),
    "arc": Kind(
        "arc with I J", lambda _: "G2 X2. Y0 I1. J0\nG2 X0 Y0 I-1. J0", before="G1 X0 Y0\n"
    ),
    "radius": Kind("arc with R", lambda i: "G2 X10. Y10. R10.\nG1 X0 Y0"),
    "helix": Kind(
        "helix", lambda i: f"G3 X0 Y0 I{i % 5 + 1}. J0 Z-{i % 9 + 1}.", before="G1 X0 Y0\n"
    ),
    "plane": Kind(
        "arc in another plane",
        lambda i: "G18 G2 X10. Z5. I5. K0\nG2 X0 Z5. I-5. K0",
        before="G1 X0 Y0 Z5.\n",
    ),
    "absolute": Kind("G90 G1", lambda i: f"G90 G1 {at(i)}"),
    "incremental": Kind("G91 G1, G90", lambda i: f"G91 G1 X{i % 9 - 4}.5 Y0.5\nG90 G1 {at(i)}"),
    "four": Kind("four axes", lambda i: f"G1 {at(i)} Z{i % 10}.5 A{i % 360}.25"),
    "five": Kind("five axes", lambda i: f"G1 {at(i)} Z{i % 10}.5 A{i % 90}.25 B{i % 360}.5"),
    "inverse": Kind(
        "inverse time", lambda i: f"G1 {at(i)} F{i % 50 + 10}.5", before="G93 G1 X0 F10\n"
    ),
    "exact": Kind("G9 G1", lambda i: f"G9 G1 {at(i)}", peer=False),
    "corner": Kind(
        "G1 with ,R", lambda i: f"G1 X{i % 2 * 20}. ,R1.\nY{i % 4 // 2 * 20}.", peer=False
    ),
    # Modes, and codes that are sent to the machine.
    "modes": Kind("modes only", lambda i: "G90 G17 G40\nG94 G21"),
    "safety": Kind("safety line", lambda i: "G17 G21 G40 G49 G80 G90 G94"),
    "units": Kind("G20, G21", lambda i: "G20\nG21"),
    "coolant": Kind("M8, M9", lambda i: "M8\nM9"),
    "spindle": Kind("S M3", lambda i: f"S{i % 5000 + 100} M3\nM5"),
    "feed": Kind("F alone", lambda i: f"F{i % 900 + 100}"),
    "tool": Kind("T M6", lambda i: f"T{i % 9 + 1}\nM6"),
    "dwell": Kind("G4", lambda i: "G4 P1"),
    "comment": Kind("comment", lambda i: f"(CUT {i})\nG1 {at(i)} (SIDE {i % 9})"),
    "slash": Kind("block skip", lambda i: f"/G1 {at(i)}"),
    # Offsets, zero points and rotated coordinates.
    "machine": Kind("G53 G0", lambda i: f"G53 G0 {at(i)}"),
    "systems": Kind("G54, G55", lambda i: "G54 G0 X1.\nG55 G0 X2."),
    "extra": Kind("G54.1 P", lambda i: f"G54.1 P{i % 40 + 1}\nG0 X1.", peer=False),
    "length": Kind("G43 H, G49", lambda i: "G43 H1 G0 Z5.\nG49 G0 Z6."),
    "long": Kind("G1 under G43", lambda i: f"G1 {at(i)}", before="G43 H1 Z5.\n"),
    "local": Kind("G52", lambda i: f"G52 X{i % 10}. Y1.", peer=False),
    "g92": Kind("G92", lambda i: f"G92 X{i % 10}. Y1."),
    "g10": Kind("G10 L2", lambda i: f"G10 L2 P1 X{i % 10}. Y1."),
    "g28": Kind("G91 G28, G90", lambda i: "G91 G28 Z0\nG90 G0 Z5."),
    "g30": Kind("G30", lambda i: "G30 Z10.\nG0 Z5.", peer=False),
    "skip": Kind("G31", lambda i: f"G31 X{i % 100}. F100", peer=False),
    "rotated": Kind("G1 under G68", lambda i: f"G1 {at(i)}", before="G68 X0 Y0 R30.\n", peer=False),
    "rotation": Kind("G68, G69", lambda i: f"G68 X0 Y0 R{i % 90}.\nG69", peer=False),
    "scaled": Kind(
        "G1 under G51", lambda i: f"G1 {at(i)}", before="G51 X0 Y0 Z0 P2000\n", peer=False
    ),
    "polar": Kind("G16", lambda i: f"G1 X{i % 50 + 1}. Y{i % 360}.", before="G16\n", peer=False),
    "radius-on": Kind(
        "radius compensation, lines",
        lambda i: f"X{i * 5 % 100000}. Y{i % 2 * 5}.",
        before="G41 D1 G1 X0 Y0\n",
        peer=False,
    ),
    "pocket": Kind(
        "radius compensation, a contour",
        lambda i: (
            "G41 D1 G1 X10. Y0\nX30.\nG3 X40. Y10. I0 J10.\nG1 Y30.\n"
            "G3 X30. Y40. I-10. J0\nG1 X10.\nG40 G1 X0 Y0"
        ),
        before="G1 X0 Y0\n",
    ),
    # Cycles.
    "drill": Kind("G81, a hole", lambda i: at(i), before="G98 G81 X0 Y0 Z-5. R2. F100\n"),
    "drill-all": Kind(
        "G81 in every block, G80",
        lambda i: f"G98 G81 {at(i)} Z-5. R2. F100\nG80",
    ),
    "counterbore": Kind(
        "G82, a hole", lambda i: at(i), before="G99 G82 X0 Y0 Z-5. R2. P100 F100\n"
    ),
    "peck": Kind("G83, a hole", lambda i: at(i), before="G98 G83 X0 Y0 Z-5. R2. Q2. F100\n"),
    "chip": Kind("G73, a hole", lambda i: at(i), before="G98 G73 X0 Y0 Z-5. R2. Q2. F100\n"),
    "tap": Kind(
        "G84, a hole",
        lambda i: at(i),
        before="S100 M3\nG98 G84 X0 Y0 Z-5. R2. F100\n",
        peer=False,
    ),
    "bore": Kind("G85, a hole", lambda i: at(i), before="G98 G85 X0 Y0 Z-5. R2. F100\n"),
    "fine": Kind(
        "G76, a hole",
        lambda i: at(i),
        before="S100 M3\nG98 G76 X0 Y0 Z-5. R2. Q1. F100\n",
        peer=False,
    ),
    "reamed": Kind("G89, a hole", lambda i: at(i), before="G98 G89 X0 Y0 Z-5. R2. P1 F100\n"),
    # Macros.
    "offset": Kind("computed words", lambda i: "G1 X[#101+1.] Y#102", before="#101=10\n#102=20\n"),
    "indirect": Kind(
        "indirect words",
        lambda i: "G1 X#[#101+2] Y#102",
        before="#101=101\n#102=20\n#103=5\n",
    ),
    "function": Kind(
        "words with functions",
        lambda i: f"G1 X[#101*COS[{i % 360}.]] Y[#101*SIN[{i % 360}.]]",
        before="#101=10\n",
    ),
    "assign": Kind("#101=#102+1", lambda i: f"#{i % 50 + 100}=[#102+{i % 9}.5]", before="#102=1\n"),
    "constant": Kind("#101=1.5", lambda i: f"#{i % 50 + 100}={i % 9}.5"),
    "compute": Kind(
        "assignment of functions",
        lambda i: "#103=[#101*COS[#102]-#101*SIN[#102]]",
        before="#101=1\n#102=2\n",
    ),
    "place": Kind("#[#101+2]=", lambda i: "#[#101+2]=#102", before="#101=110\n#102=5\n"),
    "branch": Kind(
        "IF GOTO, not taken",
        lambda i: f"IF[#101EQ{i % 9 + 1}]GOTO10",
        before="#101=0\n",
        peer=False,
    ),
    "then": Kind(
        "IF THEN", lambda i: f"IF[#101NE{i % 9 + 1}]THEN#102=5", before="#101=0\n", peer=False
    ),
    "jump": Kind("GOTO", lambda i: f"GOTO{i % 99999 + 1}\nN{i % 99999 + 1}", peer=False),
    "loop": Kind(
        "WHILE, one pass",
        lambda i: "#101=0\nWHILE[#101LT1]DO1\n#101=#101+1\nEND1",
        peer=False,
    ),
    "sub": Kind("M98, M99", lambda i: "M98 P2", behind="O2\nM99\n", peer=False),
    "macro": Kind(
        "G65 with words, M99",
        lambda i: f"G65 P2 X{i % 90}.5 Y1. Z-3. A#101",
        before="#101=1\n",
        behind="O2\nM99\n",
        peer=False,
    ),
    # Lathes.
    "turn": Kind("lathe, G1", lambda i: f"G1 X{i % 80}.5 Z-{i % 90}.25", lathe=True, peer=False),
    "turn-by": Kind(
        "lathe, G1 U W", lambda i: f"G1 U{i % 2 * 2 - 1}.5 W-0.01", lathe=True, peer=False
    ),
    "turn-arc": Kind(
        "lathe, G3 with R",
        lambda i: "G3 X20. Z-10. R10.\nG1 X0 Z0",
        before="G1 X0 Z0\n",
        lathe=True,
        peer=False,
    ),
    "speed": Kind(
        "lathe, G96 G1",
        lambda i: f"G1 X{i % 80}.5 Z-{i % 90}.25",
        before="G50 S3000\nG96 S200 M3\n",
        lathe=True,
        peer=False,
    ),
    "constant-speed": Kind(
        "lathe, G96, G97", lambda i: "G96 S200 M3\nG97 S500", lathe=True, peer=False
    ),
    "turret": Kind("lathe, T0101", lambda i: f"T0{i % 3 + 1}01\nT0100", lathe=True, peer=False),
    "thread": Kind(
        "lathe, G92 pass",
        lambda i: f"X{40 - i % 10 / 10:.1f}",
        before="G97 S500 M3\nG0 X50. Z5.\nG92 X40. Z-30. F2.\n",
        lathe=True,
        peer=False,
    ),
    "rough-turn": Kind(
        "lathe, G90 pass",
        lambda i: f"X{40 - i % 10 / 10:.1f}",
        before="G0 X50. Z5.\nG90 X40. Z-30. F0.2\n",
        lathe=True,
        peer=False,
    ),
    "thread-cut": Kind(
        "lathe, G32",
        lambda i: "G32 Z-30. F2.\nG0 Z5.",
        before="G97 S500 M3\nG0 X50. Z5.\n",
        lathe=True,
        peer=False,
    ),
    "nose": Kind(
        "lathe, nose radius",
        lambda i: f"G1 X{i % 2 * 20}. Z-{i % 90_000}0.",
        before="G42 G1 X0 Z0 T0101\n",
        lathe=True,
        peer=False,
    ),
}


def measured(kind: Kind, blocks: int, rounds: int) -> tuple[float, float]:
    """Return the seconds a block of reading, and of running with moves."""
    text, count = kind.text(blocks)
    reads, runs = [], []
    for _ in range(rounds):
        start = time.process_time()
        library = cncsub.loads(text, control=CONTROL)
        read = time.process_time()
        run = library.run(trace="moves", setup=kind.setup, max_blocks=10**9)
        done = time.process_time()
        if run.alarm is not None:
            raise SystemExit(f"{kind.title}: {run.alarm}")
        reads.append(read - start)
        runs.append(done - read)
        del run, library
    return min(reads) / count, min(runs) / count


def peer(kind: Kind, blocks: int, program: str) -> float | None:
    """Return the seconds a block of rs274, its start subtracted; None where it refuses the text."""
    with tempfile.TemporaryDirectory() as folder:
        file, tools = Path(folder) / "kind.ngc", Path(folder) / "tools.tbl"
        tools.write_text(TOOLS)

        def once(size: int) -> float | None:
            text, _ = kind.text(size)
            file.write_text(text)
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            done = subprocess.run(
                [program, "-g", "-t", str(tools), str(file)], capture_output=True, cwd=folder
            )
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            if done.returncode != 0:
                return None
            return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime

        small, large = once(blocks // 20), once(blocks)
        if small is None or large is None:
            return None
        return (large - small) / (blocks - blocks // 20)


def one_core() -> None:
    """Keep this process to one of its cores, where the system lets it."""
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("kinds", nargs="*", metavar="KIND", help=", ".join(KINDS))
    parser.add_argument("--blocks", type=int, default=50_000)
    parser.add_argument("--rounds", type=int, default=9)
    options = parser.parse_args()
    one_core()
    program = shutil.which("rs274")
    rows = []
    plain = None
    for name in options.kinds or KINDS:
        kind = KINDS[name]
        read, ran = measured(kind, options.blocks, options.rounds)
        plain = read + ran if plain is None else plain
        other = peer(kind, options.blocks, program) if program and kind.peer else None
        rows.append(
            [
                kind.title,
                f"{read * 1e9:.0f}",
                f"{ran * 1e9:.0f}",
                f"{(read + ran) / plain:.1f}",
                "" if other is None else f"{other * 1e9:,.0f}",
                "" if other is None else f"{other / (read + ran):.1f}",
            ]
        )
    heads = ["kind of block", "load, ns", "run, ns", "times plain", "rs274, ns", "times rs274"]
    print("\n".join(report.markdown(heads, rows)))


if __name__ == "__main__":
    main()
