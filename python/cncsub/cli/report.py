"""The command `cncsub report`."""

from __future__ import annotations

import sys

import typer

import cncsub
from cncsub.cli.options import (
    ControlName,
    Encoding,
    External,
    InputsFile,
    Main,
    MaxBlocks,
    MaxCycles,
    OptionalStop,
    Output,
    Param,
    Paths,
    Prefer,
    Set,
    SetupFile,
    Skip,
    Start,
    VariablesFile,
    Watch,
    memory_of,
    run_options,
    status_of,
    told_idle,
    whole_run,
    wrong_use,
)
from cncsub.escapes import shown
from cncsub.reports.printing import console_on, print_stop


def report(
    paths: Paths = None,
    control: ControlName = None,
    main: Main = None,
    set: Set = None,
    variables: VariablesFile = None,
    param: Param = None,
    skip: Skip = None,
    external: External = None,
    prefer: Prefer = None,
    encoding: Encoding = None,
    max_cycles: MaxCycles = 1,
    max_blocks: MaxBlocks = 1_000_000,
    setup: SetupFile = None,
    inputs: InputsFile = None,
    start: Start = None,
    optional_stop: OptionalStop = False,
    watch: Watch = None,
    output: Output = None,
) -> None:
    """Run a program and write how it went as one page of HTML, which needs no network."""
    options = {**locals(), "mdi": None}
    with wrong_use():
        if output is None:
            raise ValueError("which file? Give -o report.html")
        library = memory_of(options)
        program = library.main if main is None else library[main]
        asked = run_options(options, "moves")
        told_idle(library, asked)
        run = whole_run(library.run(main, **asked))
        title = None if program is None else program.name
        found = library.check(main, setup=asked.get("setup"))
        cncsub.report(library, run, output, title=title, findings=found)
    print_stop(console_on(sys.stderr), run)
    typer.echo(f"wrote {shown(str(output))}")
    raise typer.Exit(status_of(run))
