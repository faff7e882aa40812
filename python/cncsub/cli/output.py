"""The answers of the commands: text, JSON, what is reported beside them, the exit status."""

from __future__ import annotations

import contextlib
import itertools
import json
import re
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import typer

import cncsub
from cncsub import system
from cncsub.analysis.notes import Note
from cncsub.escapes import shown
from cncsub.reports.printing import Console, console_on, stop_text
from cncsub.writing import opened

NOT_DONE = 5  # exit status: no room on the disk, in memory, for files, for processes
STATUS = {
    cncsub.Stop.END: 0,
    cncsub.Stop.CYCLES: 0,
    cncsub.Stop.ALARM: 1,
    cncsub.Stop.WAITING: 3,
    cncsub.Stop.LIMIT: 4,
    cncsub.Stop.INTERRUPTED: 130,
}


def whole_run(run: cncsub.Run) -> cncsub.Run:
    """Return the run. Where Ctrl-C broke it off, report where it stood and raise
    `KeyboardInterrupt`.
    """
    if run.stop is cncsub.Stop.INTERRUPTED:
        at = ""
        if len(run.steps):
            last = run.steps[-1]
            block = f"line {last.line}" if last.n is None else f"N{last.n}"
            at = f", at {shown(f'{last.program} {block}')}"
        typer.echo(f"stopped: {stop_text(run)}{at}", err=True)
        raise KeyboardInterrupt
    return run


def status_of(run: cncsub.Run | cncsub.Stream) -> int:
    """Return the exit status of a run; 1 for a stream that was left before its end."""
    return 1 if run.stop is None else STATUS[cncsub.Stop(run.stop)]


def told_idle(
    library: cncsub.Library, asked: Mapping[str, Any], typed: cncsub.Program | None = None
) -> list[Note]:
    """Report and return the options that no block asks for; `typed` is what was typed in MDI."""
    from cncsub.reports.hints import without_effect

    idle = list(without_effect(library, asked, typed))
    tell_all(idle)
    return idle


def told_lengths(run: cncsub.Run, asked: Mapping[str, Any]) -> list[Note]:
    """Report and return what is told of lengths without a decimal point."""
    from cncsub.reports.hints import lengths_without_point

    notes = list(lengths_without_point(run, asked))
    tell_all(notes)
    return notes


MOST_NOTES = 20


def tell_all(notes: Sequence[Note]) -> None:
    """Report the first of many notes on the error stream."""
    for note in notes[:MOST_NOTES]:
        typer.echo(f"note: {shown(str(note))}", err=True)
    if (left := len(notes) - MOST_NOTES) > 0:
        typer.echo(f"note: ... and {left:,} more", err=True)


def tell_dropped(dropped: int, warnings: Iterable[str | None] = ()) -> None:
    """Report on the error stream that words were dropped, for commands that show none of them, and
    once what does not start because of that.
    """
    if dropped:
        words = f"{dropped:,} word{'' if dropped == 1 else 's'}"
        typer.echo(f"note: the control dropped {words}; cncsub run and check show which", err=True)
    for warning in sorted({each for each in warnings if each is not None}):
        typer.echo(f"warning: a word was dropped: {warning}", err=True)


def tell_hints(hints: Iterable[str]) -> None:
    """Report on the error stream what leads on from an alarm."""
    for hint in hints:
        first, *more = hint.split("\n")
        typer.echo(f"hint: {shown(first)}", err=True)
        for line in more:  # of a file that is suggested
            typer.echo(f"      {shown(line)}", err=True)


def _escaped(found: re.Match[str]) -> str:
    """Return a character as JSON writes it in plain ASCII, where it cannot be seen."""
    return found[0] if found[0].isprintable() else json.dumps(found[0]).strip('"')


def write_text(output: Path | None, write: Callable[[Console], None]) -> None:
    if output is None:
        write(console_on(sys.stdout))
        return
    with opened(output, "w") as file:
        write(console_on(file))


def write_code(pieces: Iterable[str]) -> None:
    """Write programs, or their changes, as they are; on a terminal without what would move it."""
    if not sys.stdout.isatty():
        for piece in pieces:
            typer.echo(piece.encode(errors="surrogateescape"), nl=False)
        return
    for line in "".join(pieces).splitlines():
        typer.echo(shown(line))


def write_json(output: Path | None, facts: object) -> None:
    plain = output is None and not system.takes_any_text(sys.stdout)
    pieces = json.JSONEncoder(ensure_ascii=plain, indent=2, allow_nan=False).iterencode(facts)
    with contextlib.nullcontext(sys.stdout) if output is None else opened(output, "w") as file:
        while piece := "".join(itertools.islice(pieces, 10_000)):
            # Characters that a terminal would obey are escaped; all beyond ASCII is in a string.
            file.write(_BEYOND_ASCII.sub(_escaped, piece))
        file.write("\n")


_BEYOND_ASCII = re.compile(r"[^\x20-\x7e\n]")
