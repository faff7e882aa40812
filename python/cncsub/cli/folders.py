"""The common parts of the commands that work through folders of programs in processes."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Mapping
from typing import Annotated, Any

import typer

from cncsub import system
from cncsub.archive.work import WorkersError
from cncsub.cli.options import control_for
from cncsub.cli.output import NOT_DONE
from cncsub.cli.project import Project

Folders = Annotated[list[str] | None, typer.Argument(help="Files and folders.", show_default=False)]
Jobs = Annotated[int | None, typer.Option("-j", "--jobs", help="The number of processes.", min=1)]
Each = Annotated[
    str,
    typer.Option(help="What one run loads: file, beside (all files of its folder) or folder."),
]
MaxBlocks = Annotated[int, typer.Option(help="The limit of each run.", min=0)]
MaxSeconds = Annotated[float, typer.Option(help="The limit of each run.")]


@contextlib.contextmanager
def in_processes() -> Iterator[None]:
    """Let processes start, and end the command where there is no room for them."""
    try:
        with system.started_without_main():
            yield
    except WorkersError as error:
        typer.echo(f"cncsub: {error}", err=True)
        raise typer.Exit(NOT_DONE) from None


def work_of(options: Mapping[str, Any], project: Project) -> dict[str, Any]:
    """Return which programs are read, as which control's, and by how many processes."""
    paths = options["paths"] or list(project.folders)
    if not paths:
        raise ValueError("which programs? Give files or folders")
    return {
        "paths": paths,
        "control": control_for(options, project),
        "each": options["each"],
        "external": options["external"] or project.external,
        "encoding": options["encoding"],
        "jobs": options["jobs"],
    }
