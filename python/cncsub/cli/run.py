"""The commands `cncsub run` and `cncsub tree`."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import IO, Annotated, Any

import typer

import cncsub
from cncsub.cli.listing import Listing, Where, filters, write_listing
from cncsub.cli.memory import memory_of, notes_on, typed_in
from cncsub.cli.options import (
    ControlName,
    Format,
    Main,
    Mdi,
    Output,
    Paths,
    RunFormat,
    Watch,
    WrongUseError,
    run_options,
    runs_programs,
    wrong_use,
)
from cncsub.cli.output import (
    status_of,
    tell_dropped,
    tell_hints,
    told_idle,
    told_lengths,
    whole_run,
    write_json,
    write_text,
)
from cncsub.cli.static_tree import draw_static_tree
from cncsub.escapes import cell
from cncsub.reports.facts import run_facts, tree_facts
from cncsub.reports.hints import hints_of
from cncsub.reports.printing import console_on, print_run, print_stop, print_tree
from cncsub.tables.table import records
from cncsub.writing import opened


@runs_programs()
def run(
    paths: Paths = None,
    control: ControlName = None,
    main: Main = None,
    mdi: Mdi = None,
    watch: Watch = None,
    listing: Listing = False,
    where: Where = None,
    format: Annotated[
        RunFormat, typer.Option(help="csv and parquet write the moves.")
    ] = RunFormat.TEXT,
    output: Output = None,
    **shared: Any,
) -> None:
    """Run a program and print its calls and how it stopped."""
    if format in (RunFormat.CSV, RunFormat.PARQUET):
        with wrong_use():
            if listing:
                raise ValueError("csv and parquet write the moves; --listing takes text or json")
        stream = _stream({**locals(), **shared})
        dropped = _write_moves(stream, format, output)
        print_stop(console_on(sys.stderr), stream)
        tell_dropped(*dropped)
        raise typer.Exit(status_of(stream))
    with wrong_use():
        asked = filters(where or ())
        if asked and not listing:
            raise ValueError("--where selects blocks of the listing: give --listing too")
    options = {**_watching({**locals(), **shared}, asked), "conditions": listing or bool(watch)}
    made, title, notes, hints = _run(options, trace="moves")
    if listing:
        with wrong_use():
            blocks = made.listing(**asked)
        write_listing(blocks, output, as_json=format is RunFormat.JSON)
        print_stop(console_on(sys.stderr), made)
        tell_dropped(len(made.dropped), (word.warning for word in made.dropped))
        tell_hints(hints)
        raise typer.Exit(status_of(made))
    if format is RunFormat.TEXT:
        write_text(output, lambda console: print_run(console, made, title))
        tell_hints(hints)
    else:
        write_json(output, {**run_facts(made, title), "notes": notes, "hints": hints})
    raise typer.Exit(status_of(made))


@runs_programs()
def tree(
    paths: Paths = None,
    control: ControlName = None,
    main: Main = None,
    mdi: Mdi = None,
    static: Annotated[
        bool, typer.Option("--static", help="Draw the calls as they are written, without running.")
    ] = False,
    format: Annotated[Format, typer.Option()] = Format.TEXT,
    output: Output = None,
    **shared: Any,
) -> None:
    """Draw the calls a program makes, their arguments and callers: as it ran, or as written."""
    if static:
        draw_static_tree({**locals(), **shared}, main, format, output)
        return
    made, title, notes, hints = _run({**locals(), **shared}, trace="blocks")
    if format is Format.JSON:
        write_json(output, {**tree_facts(made, title), "notes": notes, "hints": hints})
    else:
        write_text(output, lambda console: print_tree(console, made, title, callers=True))
        tell_dropped(len(made.dropped), (word.warning for word in made.dropped))
        if made.stop not in (cncsub.Stop.END, cncsub.Stop.CYCLES):
            print_stop(console_on(sys.stderr), made)
            tell_hints(hints)
    raise typer.Exit(status_of(made))


def _watching(options: Mapping[str, Any], asked: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return the options, with the variable watched that the listing asks for."""
    if "variable" not in asked:
        return options
    return {**options, "watch": [*(options["watch"] or ()), str(asked["variable"])]}


def _run(
    options: Mapping[str, Any], *, trace: str
) -> tuple[cncsub.Run, str, list[dict[str, Any]], list[str]]:
    """Run what the options say. Return the run, the words for what ran, the notes on the memory and
    the options, and what leads on from an alarm.
    """
    with wrong_use():
        library = memory_of(options)
        asked = run_options(options, trace)
        where = f"on {library.control.title}"
        notes = [asdict(note) for note in notes_on(options, library)]
        if (mdi := options["mdi"]) is not None:
            made = whole_run(library.mdi(mdi, **asked))
            notes += map(asdict, told_idle(library, asked, typed_in(made)))
            notes += map(asdict, told_lengths(made, asked))
            return made, f"MDI {where}", notes, hints_of(library, made, asked, mdi=mdi)
        program = library.main if options["main"] is None else library[options["main"]]
        name = "nothing" if program is None else program.name
        made = whole_run(library.run(options["main"], **asked))
        notes += map(asdict, told_idle(library, asked))
        notes += map(asdict, told_lengths(made, asked))
        return made, f"{name} {where}", notes, hints_of(library, made, asked, options["main"])


def _stream(options: Mapping[str, Any]) -> cncsub.Stream:
    """Return a stream of what the options say, to be run while its moves are written."""
    with wrong_use():
        if options["watch"]:
            raise ValueError("csv and parquet write the moves; --watch takes text or json")
        if options["mdi"] is not None:
            raise ValueError("csv and parquet write what a program moves; --mdi takes text or json")
        library, asked = memory_of(options), run_options(options, "moves")
        told_idle(library, asked)
        return library.stream(options["main"], **asked)


def _write_moves(
    stream: cncsub.Stream, format: RunFormat, output: Path | None
) -> tuple[int, set[str | None]]:
    """Write the moves as they are made. Return how many words were dropped meanwhile, and their
    warnings.
    """
    if format is RunFormat.CSV:
        if output is None:
            return _write_csv(stream, sys.stdout)
        with opened(output, "w") as file:
            return _write_csv(stream, file)
    if output is None:
        raise WrongUseError("parquet needs a file: --output moves.parquet")
    try:
        from pyarrow import parquet
    except ImportError:
        raise WrongUseError("parquet needs pyarrow: pip install 'cncsub[arrow]'") from None
    with contextlib.ExitStack() as files:
        file = files.enter_context(opened(output, "wb"))
        writer, dropped, warnings = None, 0, set[str | None]()
        for part in stream:
            dropped += len(part.dropped)
            warnings |= {word.warning for word in part.dropped}
            rows = part.moves.to_arrow()
            if writer is None:
                writer = files.enter_context(parquet.ParquetWriter(file, rows.schema))
            writer.write_table(rows)
    return dropped, warnings


def _write_csv(stream: cncsub.Stream, file: IO[str]) -> tuple[int, set[str | None]]:
    import csv

    dropped, warnings = 0, set[str | None]()
    writer = csv.writer(file, lineterminator="\n")
    for number, part in enumerate(stream):
        if number == 0:
            writer.writerow(part.moves.columns)
        writer.writerows(record.values() for record in records(part.moves, cell))
        dropped += len(part.dropped)
        warnings |= {word.warning for word in part.dropped}
    return dropped, warnings
