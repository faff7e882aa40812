"""The output of `cncsub tree --static`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

from cncsub.analysis.static_tree import MOST, StaticCall, static_tree
from cncsub.cli.memory import memory_of, notes_on
from cncsub.cli.options import Format, wrong_use
from cncsub.cli.output import write_json, write_text
from cncsub.escapes import shown
from cncsub.reports.printing import Console

# Options that only a run uses: they are refused where nothing runs.
_OF_RUNS = ("set", "variables", "skip", "setup", "inputs", "start", "optional_stop")


def draw_static_tree(
    options: Mapping[str, Any], main: str | None, format: Format, output: Path | None
) -> None:
    """Draw the calls as the blocks are written, without running them."""
    with wrong_use():
        if options["mdi"] is not None:
            raise ValueError(
                "--static does not run programs, and --mdi must run: leave out one of them"
            )
        given = [f"--{name.replace('_', '-')}" for name in _OF_RUNS if options[name]]
        if given:
            raise ValueError(f"--static does not run: {', '.join(given)} would have no effect")
        library = memory_of(options)
        calls, whole = static_tree(library, main)
        program = library.main if main is None else library[main]
    name = "nothing" if program is None else program.name
    title = f"{name} on {library.control.title}, as it is written"
    if format is Format.JSON:
        notes = [asdict(note) for note in notes_on(options, library)]
        facts = {"title": title, "whole": whole, "calls": _facts(calls), "notes": notes}
        write_json(output, facts)
        return
    write_text(output, lambda console: _print(console, title, calls, whole))


def _facts(calls: list[StaticCall]) -> list[dict[str, Any]]:
    """Return one row for each call, with its depth: programs nest deeper than JSON is read."""
    return [{**call.facts(), "depth": depth} for call, depth, _ in _walk(calls)]


def _print(console: Console, title: str, calls: list[StaticCall], whole: bool) -> None:
    console.print(shown(title))
    for call, _, stem in _walk(calls):
        console.print(f"{stem}{shown(str(call))}")
    if not calls:
        console.print("it calls nothing")
    if not whole:
        console.print(f"... only the first {MOST:,} calls are drawn")


def _walk(calls: list[StaticCall]) -> Iterator[tuple[StaticCall, int, str]]:
    """Yield each call with its depth and the branches before it."""
    waiting = [(call, 0, "", call is calls[-1]) for call in reversed(calls)]
    while waiting:
        call, depth, stem, last = waiting.pop()
        yield call, depth, stem + ("`-- " if last else "|-- ")
        below = stem + ("    " if last else "|   ")
        waiting += [(c, depth + 1, below, c is call.calls[-1]) for c in reversed(call.calls)]
