"""One measurement in a process of its own: `python measure.py JOB` prints what it took, as JSON.

A job names a file, a control and the options of `Library.run`; or a peer and a file. Seconds are
those of the processor, as the peers count them, so that other work on the machine does not count.
"""

from __future__ import annotations

import contextlib
import importlib
import json
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any


def memory(field: str) -> int:
    """Bytes of this process by `/proc/self/status`: VmRSS now, VmHWM at most."""
    for line in Path("/proc/self/status").read_text().splitlines():
        if line.startswith(field + ":"):
            return int(line.split()[1]) * 1024
    return 0


def forget_peak() -> None:
    """VmHWM begins again at the memory of now, where the system allows that."""
    with contextlib.suppress(OSError):
        Path("/proc/self/clear_refs").write_text("5")


def run_cncsub(file: str, control: str, **options: Any) -> dict[str, Any]:
    import cncsub

    began = time.process_time()
    library = cncsub.load(file, control=control)
    read = time.process_time()
    before = memory("VmRSS")
    forget_peak()
    started = time.process_time()
    run = library.run(max_blocks=10**12, **options)
    done = time.process_time()
    kept, peak = memory("VmRSS") - before, memory("VmHWM") - before  # before the tables are opened
    return {
        "stop": str(run.stop),
        "read": read - began,
        "run": done - started,
        "kept": kept,
        "peak": peak,
        "steps": len(run.steps),
        "result": run.variables[2],
        "columns": open_columns(run.moves),
    }


def open_columns(moves: Any) -> float:
    """Seconds for all columns of a table as NumPy arrays; the import of NumPy is not counted."""
    importlib.import_module("numpy")
    began = time.process_time()
    for name in moves.columns:
        getattr(moves, name)
    return time.process_time() - began


def parse_gcodeparser(text: str) -> None:
    module = importlib.import_module("gcodeparser")
    assert module.GcodeParser(text).lines


def parse_pygcode(text: str) -> None:
    module = importlib.import_module("pygcode")
    assert [module.Line(line) for line in text.splitlines() if line != "O1"]


def run_nc_gcode_interpreter(text: str) -> None:
    module = importlib.import_module("nc_gcode_interpreter")
    assert module.nc_to_dataframe(text.removeprefix("O1\n"))


PEERS: dict[str, Callable[[str], None]] = {
    "gcodeparser": parse_gcodeparser,
    "pygcode": parse_pygcode,
    "nc-gcode-interpreter": run_nc_gcode_interpreter,
}


def run_peer(peer: str, file: str) -> dict[str, Any]:
    """Seconds for a text that is in memory; the import of the peer is not counted."""
    text = Path(file).read_text(encoding="ascii")
    importlib.import_module(peer.replace("-", "_"))
    began = time.process_time()
    PEERS[peer](text)
    return {"run": time.process_time() - began}


def import_cncsub() -> dict[str, Any]:
    """Seconds of `import cncsub`, and which heavy modules it brought along."""
    began = time.process_time()
    cncsub = importlib.import_module("cncsub")
    seconds = time.process_time() - began
    heavy = ("numpy", "pandas", "polars", "pyarrow", "duckdb", "rich", "typer")
    brought = [name for name in heavy if name in sys.modules]
    return {"run": seconds, "heavy": brought, "version": cncsub.__version__}


def main() -> None:
    job = json.loads(sys.argv[1])
    kinds = {"cncsub": run_cncsub, "peer": run_peer, "import": import_cncsub}
    print(json.dumps(kinds[job.pop("kind")](**job)))


if __name__ == "__main__":
    main()
