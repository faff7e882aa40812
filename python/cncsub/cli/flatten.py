"""The command `cncsub flatten`."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from cncsub.cli.memory import memory_of
from cncsub.cli.options import (
    ControlName,
    Main,
    Output,
    Paths,
    control_named,
    run_options,
    runs_programs,
    wrong_use,
)
from cncsub.cli.output import told_idle, write_code
from cncsub.writing import opened


@runs_programs()
def flatten(
    paths: Paths = None,
    control: ControlName = None,
    main: Main = None,
    to: Annotated[
        str | None, typer.Option(help="The control that the flat program is for.")
    ] = None,
    comments: Annotated[bool, typer.Option(help="Write where each block comes from.")] = False,
    output: Output = None,
    **shared: Any,
) -> None:
    """Write what a program executes as one program without calls, jumps and loops.

    What cannot be written is refused with its block, before anything is written. With `--to` the
    flat program is run on the other control and compared first.
    """
    options = {**locals(), **shared, "mdi": None}
    with wrong_use():
        library = memory_of(options)
        target = None if to is None else control_named(to)
        asked = run_options(options, "moves")
        asked.pop("trace", None)
        told_idle(library, asked)
        flat = library.flatten(main, control=target, comments=comments, **asked)
    if output is None:
        write_code(flat.pieces())
    else:
        with opened(output, "wb") as file:
            for piece in flat.pieces():
                file.write(piece.encode(errors="surrogateescape"))
