"""Measure cncsub and its peers: `python tests/benchmarks/run.py [--size small|full]`.

Every measurement is a process of its own on the same files. The rounds are interleaved, so that
other work on the machine falls on all of them. Prints tables of medians for the page;
`--write docs/performance.md` puts them there, between the marks.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import report
import workloads
from peers import PEERS
from results import Figures, Key, Results
from workloads import SIZES, Size, Workload

HERE = Path(__file__).resolve().parent
TRACED = ("flat", "calls")  # the workloads that show what a smaller trace saves
Jobs = Iterator[tuple[Key, Figures]]  # each is a job of measure.py for a workload and who runs it


def measured(job: Figures) -> Figures:
    """Return the figures of one process."""
    command = [sys.executable, str(HERE / "measure.py")]
    done = subprocess.run(
        command, input=json.dumps(job), capture_output=True, text=True, check=False
    )
    if done.returncode != 0:
        raise RuntimeError(f"{str(job)[:200]}: {done.stderr.strip()[-1000:]}")
    figures: Figures = json.loads(done.stdout.splitlines()[-1])
    return figures


def own_jobs(size: Size, loads: list[Workload], folder: Path) -> Jobs:
    def job(workload: Workload, trace: str) -> Figures:
        files = [str(path) for path in workload.paths(folder)]
        given = {"control": workload.control, "trace": trace, "blocks": workload.blocks}
        return {"job": "cncsub", "files": files, **given}

    for workload in loads:
        if len(workload.files) == 1:
            yield (workload.name, "cncsub"), job(workload, workload.trace)
        if workload.name in TRACED:
            for trace in ("none", "blocks"):
                yield (workload.name, f"trace {trace}"), job(workload, trace)
    yield ("short jump", "cncsub"), job(workloads.short_jump(size), "none")
    halves = [folder / "folder" / half for half in workloads.HALVES]
    yield ("folder", "cncsub"), threads(halves, loads[-1].moves)
    libraries = [folder / "threads" / f"{half}.nc" for half in workloads.HALVES]
    yield ("threads", "cncsub"), threads(libraries, size.blocks // 2 * 2)
    yield ("import", "cncsub"), {"job": "import"}


def threads(paths: list[Path], moves: int) -> Figures:
    """Return the job of libraries one after the other, and each in a thread of its own."""
    files = [str(path) for path in paths]
    return {"job": "threads", "files": files, "control": "fanuc-0i-f", "moves": moves}


def peer_jobs(results: Results, folder: Path) -> Jobs:
    """Yield the jobs of the peers that are installed; note the others as missing."""
    for peer in PEERS:
        version = peer.found()
        if version is None:
            results.missing[peer.name] = peer.source
            continue
        results.versions[peer.name] = version
        for workload in results.workloads:
            key = workload.name, peer.name
            if why := peer.refuses(workload):
                results.refused[key] = why
            else:
                files = [str(path) for path in workload.paths(folder, peer.name)]
                yield key, peer.measurement(workload, files)


def measure_all(size: Size, folder: Path) -> Results:
    results = Results(size, workloads.workloads(size))
    jobs = [*own_jobs(size, results.workloads, folder), *peer_jobs(results, folder)]
    for round_ in range(size.rounds):
        for key, job in jobs:
            spent = sum(figures["seconds"] for figures in results.figures[key])
            if key in results.refused or spent > size.patience:
                continue
            progress(f"round {round_ + 1}: {', '.join(key)}")
            if figures := tried(key, job, results):
                results.figures[key].append(figures)
    progress("")
    return results


def tried(key: Key, job: Figures, results: Results) -> Figures | None:
    """Return the figures, or None and note the reason; cncsub has to run everything."""
    try:
        figures = measured(job)
    except RuntimeError as error:
        if key[1] not in results.versions:
            raise
        print(f"{key}: {error}", file=sys.stderr)
        figures = {"refused": "breaks down"}
    if "refused" not in figures:
        return figures
    results.refused[key] = figures["refused"]
    return None


def progress(text: str) -> None:
    if sys.stderr.isatty():
        print(f"\r{text:60}\r", end="", file=sys.stderr, flush=True)


def check(results: Results) -> None:
    """Check that all peers computed the same sum."""
    sums = {
        who: figures[-1]["result"]
        for (workload, who), figures in results.figures.items()
        if workload == "sine" and figures and "result" in figures[-1]
    }
    if max(sums.values()) - min(sums.values()) > 1e-3:
        raise RuntimeError(f"the sine loops differ: {sums}")


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--size", choices=SIZES, default="small")
    parser.add_argument("--rounds", type=int, help="how often, if not as the size says")
    parser.add_argument("--write", type=Path, help="a file whose marked tables are replaced")
    arguments = parser.parse_args()
    size = SIZES[arguments.size]
    if arguments.rounds:
        size = replace(size, rounds=arguments.rounds)
    with tempfile.TemporaryDirectory() as folder:
        # This runs in a process of its own: the memory of this one would show in the others.
        writer = [sys.executable, str(HERE / "workloads.py"), arguments.size, folder]
        subprocess.run(writer, check=True)
        results = measure_all(size, Path(folder))
        check(results)
        text = report.report(results)
    print(text)
    if arguments.write:
        report.write(arguments.write, "benchmark", text)


if __name__ == "__main__":
    main()
