"""The command `cncsub report`."""

from __future__ import annotations

import sys
from typing import Any

import typer

import cncsub
from cncsub.cli.memory import memory_of
from cncsub.cli.options import (
    ControlName,
    Main,
    Output,
    Paths,
    Watch,
    run_options,
    runs_programs,
    wrong_use,
)
from cncsub.cli.output import status_of, told_idle, whole_run
from cncsub.cli.project import project_for
from cncsub.escapes import shown
from cncsub.reports.printing import console_on, print_stop


@runs_programs(max_blocks=1_000_000)
def report(
    paths: Paths = None,
    control: ControlName = None,
    main: Main = None,
    watch: Watch = None,
    output: Output = None,
    **shared: Any,
) -> None:
    """Run a program and write how it went as one page of HTML, which needs no network."""
    options = {**locals(), **shared, "mdi": None}
    with wrong_use():
        if output is None:
            raise ValueError("which file? Give -o report.html")
        library = memory_of(options)
        program = library.main if main is None else library[main]
        asked = run_options(options, "moves")
        told_idle(library, asked)
        run = whole_run(library.run(main, **asked))
        title = None if program is None else program.name
        entry = project_for(paths).entry
        found = library.check(main, setup=asked.get("setup"), entry=entry)
        cncsub.report(library, run, output, title=title, findings=found)
    print_stop(console_on(sys.stderr), run)
    typer.echo(f"wrote {shown(str(output))}")
    raise typer.Exit(status_of(run))
