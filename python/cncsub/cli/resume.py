"""The command `cncsub resume`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from cncsub.cli.memory import memory_of
from cncsub.cli.options import (
    ControlName,
    Format,
    Main,
    Paths,
    run_options,
    runs_programs,
    wrong_use,
)
from cncsub.cli.output import status_of, told_idle, write_code, write_json
from cncsub.escapes import shown
from cncsub.resume import Resume, ResumeError, WholeRunError

_PLACES = (
    "The block that comes next: O2:N30, job.nc:12 (a line), 120 (a move), T3 (the block that calls"
    " the tool), X10,Y5,Z-2 (the nearest block)."
)


@runs_programs()
def resume(
    paths: Paths = None,
    control: ControlName = None,
    main: Main = None,
    at: Annotated[str | None, typer.Option(help=_PLACES, metavar="PLACE")] = None,
    times: Annotated[
        int, typer.Option("--pass", help="The so manieth time that the run comes there.", min=1)
    ] = 1,
    safe_height: Annotated[
        float | None,
        typer.Option(help="The Z (work coordinates, mm) to which the head goes first."),
    ] = None,
    order: Annotated[
        str | None,
        typer.Option(help="The axes in the order in which the head goes to the place: XY,Z."),
    ] = None,
    format: Annotated[Format, typer.Option()] = Format.TEXT,
    output: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--out",
            "--output",
            help="Write the restart program to this file; into a folder, a file each program.",
        ),
    ] = None,
    force: Annotated[
        bool, typer.Option("--force", help="Write over other programs of the folder.")
    ] = False,
    **shared: Any,
) -> None:
    """Start a run again in the middle: print the state there, and write a restart program.

    The program is run on the control, and what it does is compared with the whole run, before
    anything is written. Where no program does the same, the block and the reason are told.
    """
    options = {**locals(), **shared, "mdi": None}
    with wrong_use():
        if at is None:
            raise ValueError("--at names the block to start at, such as --at O2:N30")
        library = memory_of(options)
        asked = run_options(options, "moves")
        asked.pop("trace", None)
        told_idle(library, asked)
        try:
            resumed = library.resume(
                main,
                at=int(at) if at.isdecimal() else at,
                times=times,
                safe_height=safe_height,
                order=None if order is None else order.upper().split(","),
                **asked,
            )
        except ResumeError as error:
            typer.echo(f"cncsub: {shown(str(error))}", err=True)
            raise typer.Exit(_status_of(error)) from None
        if output is not None:
            _write(resumed, output, force)
    if format is Format.JSON:
        write_json(None, _facts(resumed))
        return
    for line in str(resumed.state).splitlines():
        typer.echo(shown(line))
    for note in resumed.notes:
        typer.echo(shown(f"note      {note}"))
    if output is None:
        typer.echo()
        write_code([resumed.text])


def _status_of(error: ResumeError) -> int:
    return status_of(error.run) if isinstance(error, WholeRunError) else 1


def _write(resumed: Resume, output: Path, force: bool) -> None:
    try:
        resumed.write(output, force=force)
    except FileExistsError as error:
        raise ValueError(
            f"{error.filename} holds another program; --force writes over it"
        ) from None


def _facts(resumed: Resume) -> dict[str, Any]:
    state = resumed.state
    return {
        "program": state.block.program.name,
        "n": state.block.n,
        "line": state.block.line,
        "step": state.step,
        "stack": [
            {
                "called": f.called,
                "program": f.program,
                "n": f.n,
                "line": f.line,
                "kind": f.kind,
                "pass": f.repeat,
                "passes": f.repeats,
            }
            for f in state.stack
        ],
        "modal": dict(state.modal),
        "position": dict(state.position),
        "tool": state.tool,
        "spindle": state.spindle,
        "coolant": list(state.coolant),
        "variables": {str(name): value for name, value in state.variables.items()},
        "form": resumed.form,
        "notes": list(resumed.notes),
        "files": resumed.files,
    }
