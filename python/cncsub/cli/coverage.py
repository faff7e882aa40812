"""The command `cncsub coverage`."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any

import typer

import cncsub
from cncsub.cli.memory import memory_of
from cncsub.cli.options import ControlName, Paths, run_options, runs_programs, wrong_use
from cncsub.cli.output import tell_dropped, told_idle, whole_run
from cncsub.coverage.formats import below_limit, coverage_lines
from cncsub.coverage.summary import Coverage
from cncsub.escapes import shown
from cncsub.reports.printing import console_on
from cncsub.writing import write_whole

_Report = Annotated[Path | None, typer.Option(help="Write this file.", metavar="FILE")]


@runs_programs()
def coverage(
    paths: Paths = None,
    control: ControlName = None,
    main: Annotated[
        list[str] | None, typer.Option(help="A program to run; can be given several times.")
    ] = None,
    html: _Report = None,
    lcov: _Report = None,
    cobertura: _Report = None,
    fail_under: Annotated[
        float | None, typer.Option(help="Exit with status 1 below this percentage.", min=0, max=100)
    ] = None,
    skip_covered: Annotated[
        bool, typer.Option(help="Do not list programs that are fully covered.")
    ] = False,
    **shared: Any,
) -> None:
    """Run programs and report which blocks and branches ran."""
    options = {**locals(), **shared, "mdi": None, "output": None, "main": None}
    total = Coverage()
    with wrong_use():
        library = memory_of(options)
        names: list[str | None] = [*main] if main else [None]
        asked = run_options(options, "blocks")
        told_idle(library, asked)
        for name in names:
            run = whole_run(library.run(name, **asked))
            total += run.coverage()
            _tell_stop(run, name)
            tell_dropped(len(run.dropped), (word.warning for word in run.dropped))
        for path, text in ((html, total.to_html), (lcov, total.to_lcov)):
            _write(path, text)
        _write(cobertura, total.to_cobertura)
    console = console_on(sys.stdout)
    for line in coverage_lines(total, skip_covered=skip_covered):
        console.print(shown(line))
    if fault := below_limit(total, fail_under):
        typer.echo(f"cncsub: {fault}", err=True)
        raise typer.Exit(1)


def _tell_stop(run: cncsub.Run, name: str | None) -> None:
    """Report a run that stopped early, whatever the limit is: it covers less than it seems."""
    if run.stop not in (cncsub.Stop.END, cncsub.Stop.CYCLES):
        reason = str(run.alarm) if run.alarm is not None else str(run.stop)
        typer.echo(shown(f"{name or 'the main program'} stopped early: {reason}"), err=True)


def _write(path: Path | None, text: Callable[[], str]) -> None:
    if path is not None:
        write_whole(path, text())
