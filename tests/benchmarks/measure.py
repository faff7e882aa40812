"""Make one measurement in its own process: `python measure.py <JOB` prints the figures as JSON.

A job names who does the work, the files, and how much work it is. A module does it twice: `first`
is the seconds in a new process, whose memory is touched for the first time, `seconds` those of the
second time. Both are seconds of the processor, so that other work on the machine does not count.
Threads that work side by side are measured by the clock, less the time in which a thread was ready
but had no core. Importing a module is not counted. A peer that cannot run the work prints
`{"refused": why}`.
"""

from __future__ import annotations

import contextlib
import importlib
import json
import os
import subprocess
import sys
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

Figures = dict[str, Any]
STEPPED = 50_000  # the blocks that are executed one by one
PATIENCE = 20  # seconds after which no work is repeated


class RefusedError(Exception):
    """A peer that cannot run a workload; the text says why."""


def memory(field: str) -> int:
    """Return the bytes of this process in `/proc/self/status`: VmRSS is now, VmHWM the most."""
    for line in Path("/proc/self/status").read_text().splitlines():
        if line.startswith(field + ":"):
            return int(line.split()[1]) * 1024
    return 0


def forget_peak() -> None:
    """Reset VmHWM to the memory of now, where the system allows that."""
    with contextlib.suppress(OSError):
        Path("/proc/self/clear_refs").write_text("5")


def expect(what: str, found: int, expected: int) -> None:
    """Check a count; some peers write a little more than expected for the start and the end."""
    if not expected <= found <= expected + 4:
        raise RefusedError(f"makes {found:,} {what}, not {expected:,}")


# ---- cncsub ----


def run_cncsub(files: list[str], control: str, trace: str, blocks: int) -> Figures:
    """Load and run one file twice; the memory is that of the first time."""
    first = load_and_run(files[0], control, trace, blocks)[0]  # the moves of this run are freed
    again, run = load_and_run(files[0], control, trace, blocks)
    times = {key: again[key] for key in ("seconds", "read", "run")}
    stepped = step_through(files[0], control, trace)
    # NumPy comes last: its threads spin for a while, and their seconds would count.
    opened = {"columns": open_columns(run.moves), "step columns": open_columns(run.steps)}
    return first | times | {"first": first["seconds"], "stepped": stepped} | opened


def load_and_run(file: str, control: str, trace: str, blocks: int) -> tuple[Figures, Any]:
    """Return the figures, and the run."""
    import cncsub

    began = time.process_time()
    library = cncsub.load(file, control=control)
    read = time.process_time()
    before = memory("VmRSS")
    forget_peak()
    started = time.process_time()
    run = library.run(max_blocks=10**12, trace=trace)
    done = time.process_time()
    kept, peak = memory("VmRSS") - before, memory("VmHWM")  # before the tables are opened
    assert str(run.stop) == "end", run.stop
    assert trace == "none" or not blocks or len(run.steps) == blocks, (len(run.steps), blocks)
    figures = {
        "seconds": read - began + done - started,
        "read": read - began,
        "bytes": Path(file).stat().st_size,
        "run": done - started,
        "kept": kept,
        "peak": peak,
        "above": peak - before,
        "result": run.variables[2],
    }
    return figures, run


def step_through(file: str, control: str, trace: str) -> float:
    """Return the seconds of one `machine.step()`, over the first blocks of a file."""
    import cncsub

    machine = cncsub.load(file, control=control).machine(trace=trace)
    began = time.process_time()
    steps = sum(machine.step() is not None for _ in range(STEPPED))
    return (time.process_time() - began) / max(steps, 1)


def open_columns(table: Any) -> float:
    """Return the seconds of all threads for all columns of a table as NumPy arrays.

    The import of NumPy is not counted.
    """
    importlib.import_module("numpy")
    began = time.process_time()
    for name in table.columns:
        getattr(table, name)
    return time.process_time() - began


def waited() -> float:
    """Return the seconds in which this thread was ready but had no core, if the system says so."""
    with contextlib.suppress(OSError):
        return int(Path("/proc/thread-self/schedstat").read_text().split()[1]) / 1e9
    return 0


def read_and_run(path: str, control: str, moves: int) -> float:
    """Run every program of a file or folder; return the seconds less those without a core."""
    import cncsub

    began = time.perf_counter() - waited()
    library = cncsub.load(path, control=control)
    made = sum(len(library.run(name, max_blocks=10**12).moves) for name in library)
    done = time.perf_counter() - waited()
    assert made == moves, (made, moves)
    return done - began


def run_threads(files: list[str], control: str, moves: int) -> Figures:
    """Run files or folders one after the other, then each in a thread of its own.

    Waiting for another thread counts; waiting for a core that another process has does not.
    """
    importlib.import_module("cncsub")

    def work(path: str) -> float:
        return read_and_run(path, control, moves // len(files))

    def in_turn() -> float:
        return sum(map(work, files))

    def side_by_side() -> float:
        with ThreadPoolExecutor(len(files)) as threads:
            return max(threads.map(work, files))

    first, peak = processor(in_turn), memory("VmHWM")
    seconds = processor(in_turn)
    # Threads that run short programs pass Python's lock to each other ten thousand times, so other
    # work on the machine costs them more than its own time. Therefore the best of some rounds is
    # taken.
    one = min(in_turn() for _ in range(5))
    two = min(side_by_side() for _ in range(10))
    return {"seconds": seconds, "first": first, "peak": peak, "one": one, "two": two}


def processor(work: Callable[[], object]) -> float:
    """Return the seconds of the processor that the work takes."""
    began = time.process_time()
    work()
    return time.process_time() - began


def import_cncsub() -> Figures:
    """Return the seconds of `import cncsub`, and the heavy modules that it imported."""
    began = time.process_time()
    cncsub = importlib.import_module("cncsub")
    seconds = time.process_time() - began
    heavy = ("numpy", "pandas", "polars", "pyarrow", "duckdb", "rich", "typer")
    brought = [name for name in heavy if name in sys.modules]
    return {"seconds": seconds, "heavy": brought, "version": cncsub.__version__}


# ---- peers that are Python modules ----


class Canon:
    """The callbacks of LinuxCNC's interpreter for all that a program does; it counts the moves."""

    def __init__(self) -> None:
        self.parameter_file = ""
        self.moves = 0

    def straight_feed(self, *_: float) -> None:
        self.moves += 1

    straight_traverse = arc_feed = straight_feed

    def get_external_length_units(self) -> float:
        return 1.0

    get_external_angular_units = get_external_length_units

    def get_axis_mask(self) -> int:
        return 7

    def check_abort(self) -> bool:
        return False

    get_block_delete = check_abort

    def get_tool(self, _: int) -> tuple[float, ...]:
        return (-1, *[0.0] * 12, 0)

    def __getattr__(self, name: str) -> Callable[..., None]:
        return lambda *_: None


def run_gcode(gcode: Any, file: str, moves: int, blocks: int) -> None:
    canon = Canon()
    canon.parameter_file = str(Path(file).with_suffix(".var"))
    Path(canon.parameter_file).touch()
    status, line = gcode.parse(file, canon, "G21", "")
    if status > gcode.MIN_ERROR:
        raise RefusedError(f"{gcode.strerror(status)}, line {line}")
    expect("moves", canon.moves, moves)


def run_nc_gcode_interpreter(module: Any, file: str, moves: int, blocks: int) -> None:
    table, _ = module.nc_to_dataframe(Path(file).read_text(encoding="ascii"))
    expect("rows", len(table), blocks)
    if blocks > moves + 4 and "M98" in table["M"].explode().to_list():
        raise RefusedError("reads on over M98")


def parse_pygcode(module: Any, file: str, moves: int, blocks: int) -> None:
    """Parse line by line and keep no line: a kept line takes 1.8 kB."""
    text = Path(file).read_text(encoding="ascii")
    lines = [line for line in text.splitlines() if not line.startswith("O")]
    expect("lines", sum(len(module.Line(line).block.gcodes) > 0 for line in lines), moves)


def parse_gcodeparser(module: Any, file: str, moves: int, blocks: int) -> None:
    expect("lines", len(module.GcodeParser(Path(file).read_text(encoding="ascii")).lines), moves)


MODULES: dict[str, Callable[[Any, str, int, int], None]] = {
    "gcode": run_gcode,
    "nc-gcode-interpreter": run_nc_gcode_interpreter,
    "pygcode": parse_pygcode,
    "gcodeparser": parse_gcodeparser,
}


def run_module(peer: str, files: list[str], moves: int, blocks: int) -> Figures:
    """Let the module read the files, or hand it their texts; repeat this if it is fast."""
    module = importlib.import_module(peer.replace("-", "_"))

    def work() -> float:
        began = time.process_time()
        for file in files:
            try:
                MODULES[peer](module, file, moves // len(files), blocks // len(files))
            except ValueError as error:  # what peers in Python raise at words that they do not know
                raise RefusedError(str(error).partition("{")[0].strip()) from error
        return time.process_time() - began

    first, peak = work(), memory("VmHWM")
    return {"seconds": work() if first < PATIENCE else first, "first": first, "peak": peak}


# ---- peers that are programs ----


def run_rs274(files: list[str], program: str) -> Figures:
    """Run the program; its start is counted, and the moves it prints are thrown away."""
    folder = Path(files[0]).parent
    tools, variables = folder / "tool.tbl", folder / "rs274.var"
    for file in (tools, variables):
        file.touch()
    home = os.environ | {"HOME": str(folder)}  # for a file that two at once would spoil
    command = [program, "-t", str(tools), "-v", str(variables), "-g", files[0]]
    with subprocess.Popen(
        command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, env=home
    ) as process:
        assert process.stderr is not None
        printed = process.stderr.read().split("\n")
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        said = (line for line in printed if line and line != "executing")
        raise RefusedError(next(said, f"exit status {process.returncode}"))
    return {"seconds": usage.ru_utime + usage.ru_stime, "peak": usage.ru_maxrss * 1024}


def run_lua(files: list[str], program: str) -> Figures:
    done = subprocess.run([program, files[0]], capture_output=True, text=True, check=True)
    seconds, result, peak = done.stdout.split()
    return {"seconds": float(seconds), "result": float(result), "peak": int(peak) * 1024}


JOBS: dict[str, Callable[..., Figures]] = {
    "cncsub": run_cncsub,
    "threads": run_threads,
    "import": import_cncsub,
    "module": run_module,
    "rs274": run_rs274,
    "lua": run_lua,
}


def main() -> None:
    job = json.load(sys.stdin)
    try:
        figures = JOBS[job.pop("job")](**job)
    except RefusedError as why:
        figures = {"refused": str(why)}
    print(json.dumps(figures))


if __name__ == "__main__":
    main()
