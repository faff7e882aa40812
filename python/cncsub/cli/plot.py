"""The command `cncsub plot`."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated, Any

import typer

import cncsub
from cncsub.analysis.notes import Note
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
from cncsub.cli.output import status_of, tell_all, tell_dropped, told_idle, whole_run
from cncsub.escapes import shown
from cncsub.plot.page import page_of
from cncsub.plot.still import still_svg
from cncsub.reports.printing import console_on, print_stop
from cncsub.writing import write_whole

_OF = ("path", "calls", "programs", "watch")

Of = Annotated[
    str, typer.Option("--of", help="What to draw: path, calls, programs or watch.", metavar="WHAT")
]
Color = Annotated[
    str | None,
    typer.Option(
        "--color",
        help="Colour the path by kind, program, call, tool, depth, feed, time or z.",
        metavar="BY",
    ),
]
MachineCoordinates = Annotated[
    bool, typer.Option("--machine", help="Draw the path of the tool in machine coordinates.")
]
View = Annotated[
    str | None,
    typer.Option(
        "--view", help="Draw the path in 2d or 3d; without it, as suits the path.", metavar="VIEW"
    ),
]
Over = Annotated[
    str | None,
    typer.Option("--over", help="Draw calls and watch over time or steps.", metavar="AXIS"),
]
Points = Annotated[
    int | None,
    typer.Option(
        "--points", help="Draw at most this many points of the path, such as 60000.", metavar="N"
    ),
]
# Options of some drawings only.
_ONLY = {
    "color": ("path",),
    "machine": ("path",),
    "points": ("path",),
    "view": ("path",),
    "over": ("calls", "watch"),
}
_ONLY_PAGE = ("color", "points", "view")


@runs_programs(max_blocks=1_000_000)
def plot(
    paths: Paths = None,
    control: ControlName = None,
    of: Of = "path",
    color: Color = None,
    machine: MachineCoordinates = False,
    view: View = None,
    over: Over = None,
    points: Points = None,
    main: Main = None,
    watch: Watch = None,
    output: Output = None,
    **shared: Any,
) -> None:
    """Run a program and draw its path as one page of HTML, which needs no network; or its calls,
    the programs that call each other, or watched variables. A file whose name ends in .svg
    becomes a drawing.
    """
    options = {**locals(), **shared, "mdi": None}
    with wrong_use():
        if output is None:
            raise ValueError("which file? Give -o path.html or -o path.svg")
        if of not in _OF:
            raise ValueError(f"--of must be one of {', '.join(_OF)}, not {of!r}")
        for name, drawings in _ONLY.items():
            if options[name] not in (None, False) and of not in drawings:
                raise ValueError(f"--{name} is only for --of {' or '.join(drawings)}, not {of}")
        if of == "watch" and not watch:
            raise ValueError("which variables? Give --watch 100-149,500")
        library = memory_of(options)
        asked = run_options(options, "moves")
        told_idle(library, asked)
        if watch and of != "watch":
            tell_all(
                [
                    Note(
                        "no-effect",
                        "no effect: only --of watch draws the watched variables",
                        "--watch",
                    )
                ]
            )
        run = whole_run(library.run(main, **asked))
        try:
            text = _drawn(library, run, output, options)
        except ImportError as error:
            raise ValueError(str(error)) from None
        write_whole(output, text)
    print_stop(console_on(sys.stderr), run)
    tell_dropped(len(run.dropped), (word.warning for word in run.dropped))
    typer.echo(f"wrote {shown(str(output))}")
    raise typer.Exit(status_of(run))


def _drawn(library: cncsub.Library, run: cncsub.Run, output: Path, options: dict[str, Any]) -> str:
    """Return the page, or the drawing where the name of the file ends in .svg."""
    if output.suffix.lower() != ".svg":
        return page_of(_figure(library, run, options), library)
    if options["of"] != "path":
        return still_svg(_figure(library, run, options))
    for name in _ONLY_PAGE:
        if options[name] is not None:
            raise ValueError(
                f"--{name} is only for -o path.html: an SVG has one colouring and view"
            )
    drawing = run.svg(coordinates="machine" if options["machine"] else "work")
    if not drawing:
        raise ValueError("the program moved nothing, so there is nothing to draw")
    return drawing


def _figure(library: cncsub.Library, run: cncsub.Run, options: dict[str, Any]) -> Any:
    if options["of"] == "programs":
        return library.plot()
    over = {} if options["over"] is None else {"over": options["over"]}
    if options["of"] == "calls":
        return run.calls.plot(**over)
    if options["of"] == "watch":
        return run.watch.plot(**over)
    where = "machine" if options["machine"] else "work"
    asked = {"color": options["color"], "most": options["points"], "view": options["view"]}
    asked = {name: value for name, value in asked.items() if value is not None}
    return run.plot(coordinates=where, **asked)
