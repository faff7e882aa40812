"""The tables of docs/performance.md, from what was measured."""

from __future__ import annotations

import datetime
import os
import platform
import re
from collections.abc import Iterable, Iterator
from pathlib import Path

import texts
from peers import PEERS
from results import Results
from workloads import Workload

LUA = [peer.name for peer in PEERS if peer.job == "lua"]
COLUMNS = [peer.name for peer in PEERS if peer.name not in LUA]
Row = tuple[str, ...]


def report(results: Results) -> str:
    """Return all tables, with the machine and what could not be measured."""
    return "\n".join(
        [
            *markdown(
                ["workload", "cncsub", "", "first time", "memory", *COLUMNS, "Lua 5.4"],
                peer_rows(results),
            ),
            "",
            *notes(results),
            "",
            *markdown(["target", "measured", ""], target_rows(results)),
            "",
            *markdown(["cncsub alone", "", ""], own_rows(results)),
        ]
    )


def write(file: Path, mark: str, text: str) -> None:
    """Replace the text between two marks of a file, such as `<!-- benchmark -->` and
    `<!-- end of benchmark -->` of the page.
    """
    head, begin, rest = file.read_text(encoding="utf-8").partition(f"<!-- {mark} -->")
    _, end, tail = rest.partition(f"<!-- end of {mark} -->")
    if not (begin and end):
        raise SystemExit(f"there is no <!-- {mark} --> ... <!-- end of {mark} --> in {file}")
    file.write_text(f"{head}{begin}\n{text}\n{end}{tail}", encoding="utf-8")


def markdown(heads: list[str], rows: Iterable[Row]) -> list[str]:
    """Return a table; all columns but the first are aligned to the right."""
    lines = [heads, ["---", *["---:"] * (len(heads) - 1)], *rows]
    return [f"| {' | '.join(cells)} |" for cells in lines]


# ---- compared with the peers ----


def peer_rows(results: Results) -> Iterator[Row]:
    for workload in results.workloads:
        seconds = results.median(workload.name)
        yield (
            workload.title,
            seconds_text(seconds),
            per_unit(seconds, workload),
            seconds_text(results.median(workload.name, "cncsub", "first")),
            megabytes(results.median(workload.name, "cncsub", "peak")),
            *(peer_cell(results, workload.name, peer) for peer in COLUMNS),
            ", ".join(lua_cells(results, workload.name)) or "-",
        )
    one, two = (results.best("folder", "cncsub", key) for key in ("one", "two"))
    folder = results.workload("folder")
    empty = ["-"] * (len(COLUMNS) + 3)
    yield (
        f"the same with two threads, {one / two:.2f} times one",
        seconds_text(two),
        per_unit(two, folder),
        *empty,
    )


def peer_cell(results: Results, workload: str, peer: str) -> str:
    if not results.has(workload, peer):
        return "-"
    return f"{times(results, workload, peer)}, {megabytes(results.median(workload, peer, 'peak'))}"


def lua_cells(results: Results, workload: str) -> Iterator[str]:
    for peer in LUA:
        if results.has(workload, peer):
            yield f"{peer.removeprefix('Lua ')} {times(results, workload, peer)}"


def times(results: Results, workload: str, who: str) -> str:
    ratio = results.ratio(workload, who)
    return f"{ratio:,.0f}x" if ratio >= 100 else f"{ratio:.3g}x"


def notes(results: Results) -> Iterator[str]:
    """Yield the machine, the versions, and the reason for each dash."""
    version = results.last("import", "cncsub", "version")
    known = [f"{peer} {known}" for peer, known in results.versions.items() if known[0].isdigit()]
    yield f"{', '.join([f'cncsub {version}', *known])}; {machine()}; rounds: {results.size.rounds}."
    for peer in COLUMNS:
        if peer in results.missing:
            yield f"Not installed: `{peer}` ({results.missing[peer]})."
        else:
            whys = list(refusals(results, peer))
            yield f"`{peer}` does not run: {'; '.join(whys)}." if whys else ""
    if LUA[0] in results.missing:
        yield f"Not installed: Lua ({results.missing[LUA[0]]})."


def refusals(results: Results, peer: str) -> Iterator[str]:
    """Yield the workloads that a peer could not run, grouped by the reason."""
    by_reason: dict[str, list[str]] = {}
    for workload in results.workloads:
        if why := results.refused.get((workload.name, peer)):
            by_reason.setdefault(why, []).append(workload.name)
    for why, names in by_reason.items():
        yield f"{', '.join(names)} ({why})"


def machine() -> str:
    cpu = platform.processor() or platform.machine()
    info = Path("/proc/cpuinfo")
    if info.exists() and (model := re.search(r"model name\s*: (.*)", info.read_text())):
        cpu = model[1]
    day = datetime.datetime.now(tz=datetime.UTC).date()
    return f"{day}, {cpu}, {os.cpu_count()} cores, {platform.system()}, Python {platform.python_version()}"


# ---- targets ----


def target_rows(results: Results) -> Iterator[Row]:
    """Yield each target with its figure; a peer that is not installed leaves it open."""
    for workload, least, what in (
        ("flat", 25, "flat G1, load and run with moves"),
        ("calls", 150, "M98 loop, load and run with moves"),
        ("sine", 70, "WHILE with a sine"),
        ("mill", 15, "the milling program, load and run with moves"),
    ):
        claim = f"{what}: {least} times as fast as `rs274`, or more"
        yield compared(results, claim, workload, "rs274", least)
    for peer in LUA:
        form = texts.LUA_FORMS[peer.removeprefix("Lua ")]["title"]
        claim = f"WHILE with a sine: no slower than PUC Lua 5.4 with {form}"
        yield compared(results, claim, "sine", peer, 1)
    size = results.last("flat", "cncsub", "bytes")
    speed = size / results.median("flat", "cncsub", "read") / 1e6
    yield "reading 250 MB/s", f"{speed:.0f} MB/s", verdict(speed >= 250)
    for name in ("mill", "turn"):
        speed = results.workload(name).count / results.median(name, "cncsub") / 1e6
        what = f"the {name}ing program, load and run with moves: 4 million blocks a second"
        yield what, f"{speed:.1f} million", verdict(speed >= 4)
    first = results.median("subprograms", "cncsub", "run")
    count = results.size.subprograms
    yield f"{count:,} first calls under 5 ms", seconds_text(first), verdict(first < 5e-3)
    call = results.median("macros", "cncsub", "run") / results.workload("macros").count
    what = "a G65 call with six arguments, its return included, under 150 ns"
    yield what, seconds_text(call), verdict(call < 150e-9)
    one, two = (results.best("threads", "cncsub", key) for key in ("one", "two"))
    what = "two threads on two libraries, load and run: 1.8 times one"
    yield what, f"{one / two:.2f}", verdict(one / two >= 1.8)


def compared(results: Results, claim: str, workload: str, peer: str, least: float) -> Row:
    if not results.has(workload, peer):
        return claim, "-", "not measured"
    return claim, times(results, workload, peer), verdict(results.ratio(workload, peer) >= least)


def verdict(met: bool) -> str:
    return "met" if met else "not met"


# ---- cncsub alone ----


def own_rows(results: Results) -> Iterator[Row]:
    for name in ("flat", "calls"):
        yield from trace_rows(results, results.workload(name))
    short_run, long_run = (results.median(name, "cncsub", "run") for name in ("short jump", "jump"))
    yield (
        "IF/GOTO: `run` in a program of 14 blocks",
        seconds_text(short_run),
        f"the long program takes {long_run / short_run:.2f} times that",
    )
    seconds = results.median("import", "cncsub")
    heavy = ", ".join(results.last("import", "cncsub", "heavy")) or "none"
    yield "`import cncsub`", seconds_text(seconds), f"heavy modules it brings along: {heavy}"


def trace_rows(results: Results, workload: Workload) -> Iterator[Row]:
    """Yield what each trace costs in time and memory."""
    what, name = workload.title, workload.name
    yield (
        f"{what}: `load`",
        seconds_text(read := results.median(name, "cncsub", "read")),
        per_unit(read, workload) if workload.plain else "",
    )
    for who in ("trace none", "trace blocks", "cncsub"):
        run, kept = (results.median(name, who, key) for key in ("run", "kept"))
        yield (
            f"`run`, {who.replace('cncsub', 'trace moves')}",
            seconds_text(run),
            f"{per_unit(run, workload)}, keeps {kept / workload.blocks:.1f} bytes a block",
        )
    columns = results.median(name, "cncsub", "columns")
    yield (
        "all columns of the moves as NumPy arrays, when somebody looks",
        seconds_text(columns),
        f"{columns / workload.moves * 1e9:.0f} ns a move",
    )
    columns = results.median(name, "cncsub", "step columns")
    yield (
        "all columns of the steps",
        seconds_text(columns),
        f"{columns / workload.blocks * 1e9:.0f} ns a step",
    )
    stepped = results.median(name, "cncsub", "stepped")
    yield "`machine.step()`, block by block", f"{stepped * 1e6:.1f} µs", "a block"


def seconds_text(seconds: float) -> str:
    """Return the seconds in three figures and the unit that fits.

    >>> [seconds_text(seconds) for seconds in (25.31, 0.0425, 0.0000123, 41.25e-9)]
    ['25.3 s', '42.5 ms', '12.3 us', '41.2 ns']
    """
    for unit, scale in (("s", 1.0), ("ms", 1e-3), ("us", 1e-6)):
        if seconds >= scale:
            return f"{seconds / scale:.3g} {unit}"
    return f"{seconds * 1e9:.3g} ns"


def per_unit(seconds: float, workload: Workload) -> str:
    return f"{seconds_text(seconds / workload.count)} a {workload.unit}"


def megabytes(count: float) -> str:
    return f"{count / 1e6:.0f} MB"
