"""Measures cncsub beside its peers: `python tests/benchmarks/run.py [--size small|full]`.

Every measurement is a process of its own on the same files; the rounds are interleaved, so that
what else the machine does falls on all of them. Prints a table of medians for the README, seconds
being those of the processor; `--write README.md` puts it there, between the marks.
"""

from __future__ import annotations

import argparse
import datetime
import json
import os
import platform
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
from collections import defaultdict
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from importlib import util
from pathlib import Path
from typing import Any

import workloads

HERE = Path(__file__).resolve().parent
BEGIN, END = "<!-- benchmark -->", "<!-- end of benchmark -->"
CONTROL = "fanuc-0i-f"
SLOW_PEERS = ("gcodeparser", "pygcode", "nc-gcode-interpreter")
PEERS = ("lua5.4", "rs274", *SLOW_PEERS)
TRACES = ("none", "blocks", "moves")
Figures = dict[str, Any]
Job = Callable[[Path], Figures]


@dataclass(frozen=True)
class Size:
    """How large the workloads are, and how often each is measured."""

    rounds: int
    blocks: int  # of the flat file
    calls: int  # M98 L9999 blocks
    passes: int  # of the loops
    macro_repeats: int  # of 1,000 G65 blocks
    around: int  # blocks before the jump loop, and behind it
    imports: int = 10
    subprograms: int = 2000
    peer_blocks: int = 20_000


SIZES = {
    "tiny": Size(1, 2_000, 1, 2_000, 1, 100, imports=1, subprograms=20, peer_blocks=100),
    "small": Size(3, 200_000, 2, 1_000_000, 100, 50_000),
    "full": Size(5, 1_000_000, 10, 10_000_000, 1000, 50_000),
}


@dataclass
class Bench:
    """The files, the jobs and what they measured, by the name of the job."""

    size: Size
    files: dict[str, Path] = field(default_factory=dict)
    jobs: dict[str, Job] = field(default_factory=dict)
    missing: dict[str, str] = field(default_factory=dict)
    results: dict[str, list[Figures]] = field(default_factory=lambda: defaultdict(list))

    def median(self, job: str, key: str = "run") -> float:
        return float(statistics.median(result[key] for result in self.results[job]))

    def last(self, job: str, key: str) -> Any:
        return self.results[job][-1][key]


# ---- one measurement ----


def output_of(command: list[str]) -> str:
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(command)[:200]}: {done.stderr.strip()[-500:]}")
    return done.stdout


def measured(**job: Any) -> Figures:
    figures: Figures = json.loads(
        output_of([sys.executable, str(HERE / "measure.py"), json.dumps(job)])
    )
    if figures.get("stop", "end") != "end":
        raise RuntimeError(f"{job} stopped: {figures['stop']}")
    return figures


def cncsub_job(control: str = CONTROL, trace: str = "none") -> Job:
    return lambda file: measured(kind="cncsub", file=str(file), control=control, trace=trace)


def peer_job(peer: str) -> Job:
    return lambda file: measured(kind="peer", peer=peer, file=str(file))


def lua_job(lua: str) -> Job:
    def run(file: Path) -> Figures:
        seconds, _, result = output_of([lua, str(file)]).split()
        return {"run": float(seconds), "result": float(result)}

    return run


def rs274_job(rs274: str) -> Job:
    """CPU seconds of the interpreter with its start; its output is thrown away."""

    def run(file: Path) -> Figures:
        tools, variables = file.parent / "tool.tbl", file.parent / "variables"
        tools.touch()
        variables.touch()
        command = [rs274, "-t", str(tools), "-v", str(variables), "-g", str(file)]
        before = os.times()
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        after = os.times()
        children = after.children_user - before.children_user
        return {"run": children + after.children_system - before.children_system}

    return run


# ---- what is measured ----


def write_files(size: Size, folder: Path) -> dict[str, Path]:
    texts = {
        "flat.nc": workloads.flat(size.blocks),
        "flat-short.nc": workloads.flat(size.peer_blocks),
        "calls.nc": workloads.call_loop(size.calls, 9999),
        "subprograms.nc": workloads.subprograms(size.subprograms),
        "nested.nc": workloads.nested(12, 9999),
        "macros.nc": workloads.macro_calls(1000, size.macro_repeats),
        "sine.nc": workloads.SINE_LOOP.format(passes=size.passes),
        "locals.lua": workloads.LUA_LOCALS.format(passes=size.passes),
        "fields.lua": workloads.LUA_FIELDS.format(passes=size.passes),
        "jump-short.nc": workloads.jump_loop(size.passes, 5),
        "jump-long.nc": workloads.jump_loop(size.passes, size.around),
    }
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="ascii")
    return {name: folder / name for name in texts}


def own_jobs() -> Iterator[tuple[str, str, Job]]:
    """Name, file and job of what cncsub runs."""
    for workload in ("flat", "calls"):
        for trace in ("none", "blocks", "moves"):
            yield f"{workload} {trace}", f"{workload}.nc", cncsub_job(trace=trace)
    yield "nested", "nested.nc", cncsub_job(control="gsk-988ta")
    for workload in ("subprograms", "macros", "sine", "jump-short", "jump-long"):
        yield workload, f"{workload}.nc", cncsub_job()


def peer_jobs(bench: Bench) -> Iterator[tuple[str, str, Job]]:
    """The same of the peers that are installed; the others are noted as missing."""
    lua = shutil.which("lua5.4")
    if lua:
        yield "lua5.4 locals", "locals.lua", lua_job(lua)
        yield "lua5.4 fields", "fields.lua", lua_job(lua)
    else:
        bench.missing["lua5.4"] = "not installed: Debian package lua5.4"
    rs274 = shutil.which("rs274")
    if rs274:
        yield "rs274 flat", "flat.nc", rs274_job(rs274)
        yield "rs274 calls", "calls.nc", rs274_job(rs274)
    else:
        bench.missing["rs274"] = "not installed: Debian package linuxcnc-uspace"
    for peer in SLOW_PEERS:
        if util.find_spec(peer.replace("-", "_")):
            yield peer, "flat-short.nc", peer_job(peer)
        else:
            bench.missing[peer] = "not installed: package index"


def measure(bench: Bench, name: str, job: Job, file: Path) -> None:
    """A peer that cannot run the file is noted; cncsub has to."""
    peer = name.partition(" ")[0]
    if peer in bench.missing:
        return
    try:
        bench.results[name].append(job(file))
    except (RuntimeError, subprocess.SubprocessError) as error:
        if peer not in PEERS:
            raise
        print(f"\n{name}: {error}", file=sys.stderr)
        bench.missing[peer] = "cannot run the workload"


def measure_all(bench: Bench, folder: Path) -> None:
    bench.files = write_files(bench.size, folder)
    jobs = [*own_jobs(), *peer_jobs(bench)]
    for round_ in range(bench.size.rounds):
        for name, file, job in jobs:
            print(f"\rround {round_ + 1}: {name:30}", end="", file=sys.stderr, flush=True)
            measure(bench, name, job, bench.files[file])
    for _ in range(bench.size.imports):
        bench.results["import"].append(measured(kind="import"))
    print("\r" + " " * 50 + "\r", end="", file=sys.stderr)


# ---- the table ----


def rows(bench: Bench) -> Iterator[tuple[str, str, str]]:
    """What, figure, and how it compares."""
    yield from flat_rows(bench)
    yield from call_rows(bench)
    yield from loop_rows(bench)
    heavy = ", ".join(bench.last("import", "heavy")) or "none"
    seconds = bench.median("import")
    count = len(bench.results["import"])
    yield f"`import cncsub`, median of {count}", f"{seconds * 1e3:.0f} ms", f"brings along: {heavy}"


def flat_rows(bench: Bench) -> Iterator[tuple[str, str, str]]:
    blocks, size = bench.size.blocks, bench.files["flat.nc"].stat().st_size
    read = statistics.median(
        result["read"] for trace in TRACES for result in bench.results[f"flat {trace}"]
    )
    what = f"flat G1, {blocks:,} blocks, {size / 1e6:.1f} MB"
    yield f"{what}: `load`", seconds_text(read), f"{size / read / 1e6:.0f} MB/s"
    for trace in TRACES:
        run = bench.median(f"flat {trace}")
        yield f"the same: `run`, trace {trace}", seconds_text(run), millions(blocks / run, "blocks")
    opened = bench.median("flat moves", "columns")
    yield (
        "the same: all columns of the moves as NumPy arrays",
        seconds_text(opened),
        ("positions, lengths and times are worked out here"),
    )
    both = statistics.median(r["read"] + r["run"] for r in bench.results["flat moves"])
    rate = blocks / both
    yield "the same: `load` and `run` with moves", seconds_text(both), millions(rate, "blocks")
    if "rs274" not in bench.missing:
        other = bench.median("rs274 flat")
        yield "the same: LinuxCNC `rs274 -g`", seconds_text(other), ratio(other / both)
    for peer in SLOW_PEERS:
        if peer not in bench.missing:
            other = bench.size.peer_blocks / bench.median(peer)
            name = f"its first {bench.size.peer_blocks:,} blocks: `{peer}`"
            yield name, seconds_text(bench.median(peer)), ratio(rate / other, "per block")


def call_rows(bench: Bench) -> Iterator[tuple[str, str, str]]:
    size = bench.size
    steps = bench.last("calls blocks", "steps")
    what = f"M98 L9999, body of eight G1, called {size.calls} times"
    for trace in TRACES:
        run = bench.median(f"calls {trace}")
        yield f"{what}: trace {trace}", seconds_text(run), millions(steps / run, "blocks")
        what = "the same"
    if "rs274" not in bench.missing:
        other = bench.median("rs274 calls")
        yield (
            "the same: LinuxCNC `rs274 -g`",
            seconds_text(other),
            ratio(other / bench.median("calls moves"), "of trace moves"),
        )
    for trace in ("blocks", "moves"):
        kept, peak = (
            (bench.median(f"calls {trace}", key) - bench.median("calls none", key)) / steps
            for key in ("kept", "peak")
        )
        yield (
            f"the same: memory a step, trace {trace}",
            f"{kept:.1f} bytes",
            (f"above trace none; at most {peak:.1f} bytes while running"),
        )
    fixed = bench.median("calls none", "peak")
    yield "the same: memory of the run, trace none", f"{fixed / 1e6:.1f} MB", "above the library"
    first = bench.median("subprograms")
    count = size.subprograms
    yield (
        f"{count:,} small subprograms, each called once",
        seconds_text(first),
        nanoseconds(first / count, "a call"),
    )
    deep, count = bench.median("nested"), 12 * 9999
    yield (
        f"twelve nested calls, {count:,} calls in all",
        seconds_text(deep),
        nanoseconds(deep / count, "a call with its return"),
    )
    macro, count = bench.median("macros"), 1000 * size.macro_repeats
    yield (
        f"G65 with six arguments, {count:,} calls",
        seconds_text(macro),
        nanoseconds(macro / count, "a call with its return"),
    )


def loop_rows(bench: Bench) -> Iterator[tuple[str, str, str]]:
    passes = bench.size.passes
    own = bench.median("sine")
    what = f"WHILE with two assignments and a sine, {passes:,} passes"
    yield what, seconds_text(own), nanoseconds(own / passes, "a pass")
    for kind in () if "lua5.4" in bench.missing else ("fields", "locals"):
        other = bench.median(f"lua5.4 {kind}")
        yield (
            f"the same: Lua 5.4, table {kind}"
            if kind == "fields"
            else ("the same: Lua 5.4, local variables"),
            seconds_text(other),
            ratio(other / own),
        )
    short, long = bench.median("jump-short"), bench.median("jump-long")
    yield (
        f"IF..GOTO loop, {passes:,} passes, in a program of 14 blocks",
        seconds_text(short),
        nanoseconds(short / passes, "a pass"),
    )
    blocks = 2 * bench.size.around
    yield (
        f"the same in a program of {blocks:,} blocks",
        seconds_text(long),
        (f"{long / short:.2f} times the short one"),
    )


def seconds_text(seconds: float) -> str:
    return f"{seconds:.2f} s" if seconds >= 1 else f"{seconds * 1e3:.3g} ms"


def millions(rate: float, what: str) -> str:
    return f"{rate / 1e6:.3g} million {what} a second"


def nanoseconds(seconds: float, what: str) -> str:
    return f"{seconds * 1e9:.3g} ns {what}"


def ratio(value: float, note: str = "") -> str:
    return f"{value:.3g} times the time of cncsub" + (f", {note}" if note else "")


def machine() -> str:
    cpu = platform.processor() or platform.machine()
    info = Path("/proc/cpuinfo")
    if info.exists() and (model := re.search(r"model name\s*: (.*)", info.read_text())):
        cpu = model[1]
    day = datetime.datetime.now(tz=datetime.UTC).date()
    return f"{day}, {cpu}, {os.cpu_count()} cores, {platform.system()}, Python {platform.python_version()}"


def table(bench: Bench) -> str:
    lines = ["| what | median | |", "|---|---:|---|"]
    lines += [f"| {what} | {figure} | {compared} |" for what, figure, compared in rows(bench)]
    lines += [
        "",
        f"cncsub {bench.last('import', 'version')}; {machine()}; {bench.size.rounds} rounds.",
    ]
    if bench.missing:
        missing = ", ".join(f"{peer} ({why})" for peer, why in bench.missing.items())
        lines.append(f"Not measured: {missing}.")
    return "\n".join(lines)


def check(bench: Bench) -> None:
    """The peers did the same work."""
    if "lua5.4" in bench.missing:
        return
    own, other = bench.last("sine", "result"), bench.last("lua5.4 locals", "result")
    if abs(own - other) > 1e-3:
        raise RuntimeError(f"the sine loops differ: {own} and {other}")


def written(readme: str, text: str) -> str:
    head, begin, rest = readme.partition(BEGIN)
    _, end, tail = rest.partition(END)
    if not (begin and end):
        raise SystemExit(f"there is no {BEGIN} ... {END} in the file")
    return f"{head}{begin}\n{text}\n{end}{tail}"


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--size", choices=SIZES, default="small")
    parser.add_argument("--write", type=Path, help="a file whose marked table is replaced")
    arguments = parser.parse_args()
    bench = Bench(SIZES[arguments.size])
    with tempfile.TemporaryDirectory() as folder:
        measure_all(bench, Path(folder))
        check(bench)
        text = table(bench)
    print(text)
    if arguments.write:
        readme = arguments.write.read_text(encoding="utf-8")
        arguments.write.write_text(written(readme, text), encoding="utf-8")


if __name__ == "__main__":
    main()
