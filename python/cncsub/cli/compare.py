"""The commands `cncsub compare` and `cncsub diff`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

import cncsub
from cncsub.cli.memory import memory_of
from cncsub.cli.options import (
    ControlName,
    Format,
    Main,
    Output,
    Paths,
    control_named,
    run_options,
    runs_programs,
    wrong_use,
)
from cncsub.cli.output import told_idle, write_json, write_text
from cncsub.cli.translate import Translate, tell_translation
from cncsub.comparison.changes import changed_lines
from cncsub.controls import names_beginning
from cncsub.escapes import shown
from cncsub.reports.facts import comparison_facts


@runs_programs("param")
def compare(
    paths: Paths = None,
    control: Annotated[
        list[str] | None,
        typer.Option(
            "-c",
            "--control",
            help="A control; give this option twice.",
            show_default=False,
            autocompletion=names_beginning,
        ),
    ] = None,
    main: Main = None,
    all_differences: Annotated[
        bool, typer.Option("--all", help="Go on after the first difference.")
    ] = False,
    translate: Translate = False,
    format: Annotated[Format, typer.Option()] = Format.TEXT,
    output: Output = None,
    **shared: Any,
) -> None:
    """Run a program on two controls, and show where they differ and which rules cause it.

    With --translate, calls are rewritten so that the second control does what the first one does,
    which is proved by running both: the changes are printed, or the programs written to folder -o.
    """
    options = {**locals(), **shared, "mdi": None, "param": None}
    with wrong_use():
        if control is None or len(control) != 2:
            raise ValueError("compare needs two controls: -c ONE -c ANOTHER")
        pair = [control_named(name) for name in control]
        library = memory_of({**options, "control": control[0]})
        asked = run_options(options, "moves")
        told_idle(library, asked)
        if translate:
            made = cncsub.translate(library.read_for(pair[0]), pair[1], main=main, **asked)
            tell_translation(made, output, as_json=format is Format.JSON)
            return
        compared = cncsub.compare(
            library, controls=pair, main=main, all_differences=all_differences, **asked
        )
    more = not all_differences and bool(compared.rules or compared.parameters)
    _tell(compared, format, output, "--all goes on after this difference" if more else "")


@runs_programs()
def diff(
    before: Annotated[str, typer.Argument(help="A file or a folder.", show_default=False)],
    after: Annotated[str, typer.Argument(help="Its new version.", show_default=False)],
    control: ControlName = None,
    main: Main = None,
    format: Annotated[Format, typer.Option()] = Format.TEXT,
    output: Output = None,
    **shared: Any,
) -> None:
    """Run two versions of a program, and show what the new one does differently."""
    options = {**locals(), **shared, "mdi": None}
    with wrong_use():
        old, new = (memory_of({**options, "paths": [path]}) for path in (before, after))
        compared = cncsub.compare(old, new, main=main, **run_options(options, "moves"))
    _tell(compared, format, output)


MOST_CHANGES = 100


def _tell(compared: cncsub.Comparison, format: Format, output: Path | None, more: str = "") -> None:
    if format is Format.JSON:
        write_json(output, comparison_facts(compared))
    else:
        told = str(compared).split("\n")
        if compared.changes:
            told += ["what the blocks do differently:"]
            told += [f"  {line}" for line in changed_lines(compared.changes, MOST_CHANGES)]
        told += [more] if more else []
        lines = "\n".join(map(shown, told))
        write_text(output, lambda console: console.print(lines))
    raise typer.Exit(0 if compared.same else 1)
