"""`cncsub renumber` and `cncsub format`: programs with other numbers or another layout that do the
same.
"""

from __future__ import annotations

import enum
import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any

import typer

import cncsub
from cncsub.cli.memory import files_beside, library_of, outside
from cncsub.cli.options import (
    ControlName,
    Encoding,
    External,
    Format,
    Param,
    Paths,
    Prefer,
    SearchPath,
    SetupFile,
    setup_for,
    wrong_use,
)
from cncsub.cli.output import tell_all, write_code, write_json
from cncsub.cli.project import project_for
from cncsub.editing import EditError, Edits
from cncsub.editing import format as formatted
from cncsub.editing import renumber as renumbered
from cncsub.editing.edits import listed
from cncsub.editing.proof import Proof
from cncsub.escapes import shown
from cncsub.setup import machine_of
from cncsub.writing import opened


class WhichBlocks(enum.StrEnum):
    NUMBERED = "numbered"
    ALL = "all"
    TARGETS = "targets"


class Blanks(enum.StrEnum):
    ONE = "one"
    NONE = "none"
    KEEP = "keep"


Check = Annotated[bool, typer.Option("--check", help="Only name the files that would change.")]
Diff = Annotated[bool, typer.Option("--diff", help="Print what would change.")]
Write = Annotated[bool, typer.Option("--write", help="Write the files that change.")]
NewFile = Annotated[
    Path | None, typer.Option("-o", "--output", help="Write the one file that is given here.")
]


def renumber(
    paths: Paths = None,
    control: ControlName = None,
    start: Annotated[int, typer.Option(help="The number of each program's first block.")] = 10,
    step: Annotated[int, typer.Option(help="What is added for each next block.")] = 10,
    which: Annotated[
        WhichBlocks,
        typer.Option(help="The blocks that have numbers afterwards: targets of jumps, or all."),
    ] = WhichBlocks.NUMBERED,
    check: Check = False,
    diff: Diff = False,
    write: Write = False,
    output: NewFile = None,
    param: Param = None,
    external: External = None,
    search: SearchPath = None,
    prefer: Prefer = None,
    encoding: Encoding = None,
    setup: SetupFile = None,
    format: Annotated[Format, typer.Option()] = Format.TEXT,
) -> None:
    """Give blocks new sequence numbers, and follow all that names them.

    The programs are run before and after, and nothing is written where they do not do the same. The
    exit status is 1 where --check or --diff finds a change, and where a program is refused.
    """
    options = {**locals(), "mdi": None}

    def made(library: cncsub.Library, files: list[str], machine: str) -> Edits:
        return renumbered(library, None, start, step, which.value, files=files, machine=machine)

    _edit(options, made)


def format_files(
    paths: Paths = None,
    control: ControlName = None,
    spacing: Annotated[Blanks, typer.Option(help="Blanks between two words.")] = Blanks.ONE,
    indent: Annotated[
        int, typer.Option(help="Blanks for each loop around a block; -1 leaves them.", min=-1)
    ] = 2,
    capitals: Annotated[
        bool, typer.Option("--capitals/--no-capitals", help="Write small letters as capitals.")
    ] = True,
    points: Annotated[
        bool, typer.Option("--points", help="Write X10 as X10. where both mean the same.")
    ] = False,
    check: Check = False,
    diff: Diff = False,
    write: Write = False,
    output: NewFile = None,
    param: Param = None,
    external: External = None,
    search: SearchPath = None,
    prefer: Prefer = None,
    encoding: Encoding = None,
    setup: SetupFile = None,
    format: Annotated[Format, typer.Option()] = Format.TEXT,
) -> None:
    """Lay out blocks alike: blanks, indentation, capitals; words and comments stay.

    The programs are run before and after, and nothing is written where they do not do the same. The
    exit status is 1 where --check or --diff finds a change.
    """
    options = {**locals(), "mdi": None}

    def made(library: cncsub.Library, files: list[str], machine: str) -> Edits:
        return formatted(
            library,
            files,
            spacing=spacing.value,
            indent=None if indent < 0 else indent,
            capitals=capitals,
            points=points,
        )

    _edit(options, made)


def _edit(
    options: Mapping[str, Any], edits_of: Callable[[cncsub.Library, list[str], str], Edits]
) -> None:
    with wrong_use():
        _one_of(options)
        project = project_for(options["paths"])
        tell_all(list(outside(options, project)))
        library = library_of(options)
        siblings = files_beside(options, library)
        own = [file for file in library.files if file not in siblings]
        if options["write"] and "<text>" in own:
            raise ValueError("a program from standard input cannot be written: give its file")
        _one_file(options, own)
        setup = setup_for(options, project)
        asked = {} if setup is None else {"setup": setup}
        try:
            made = edits_of(library, own, machine_of(setup))
            proof = made.prove(**asked)  # type: ignore[arg-type]
        except EditError as error:
            _refused(error, library, options)
            raise typer.Exit(1) from None
        _finish(made, proof, own, options)
        if options["format"] is Format.TEXT:
            _tell(made, proof)
    shows = options["check"] or options["diff"]
    raise typer.Exit(1 if shows and not made.empty else 0)


def _one_of(options: Mapping[str, Any]) -> None:
    given = [name for name in ("check", "diff", "write", "output") if options[name]]
    if len(given) > 1:
        raise ValueError(f"--{given[0]} and --{given[1]} exclude each other: give one of them")


def _one_file(options: Mapping[str, Any], own: list[str]) -> None:
    alone = options["output"] is not None or not any(
        options[name] for name in ("check", "diff", "write")
    )
    if alone and len(own) != 1 and options["format"] is Format.TEXT:
        raise ValueError(f"{len(own)} files are given: add --check, --diff or --write")


def _refused(error: EditError, library: cncsub.Library, options: Mapping[str, Any]) -> None:
    if options["format"] is Format.JSON:
        write_json(None, _facts(Edits(library, ()), Proof((), ()), error.reasons))
        return
    for reason in error.reasons:
        print(f"refused: {shown(reason)}", file=sys.stderr)


def _facts(made: Edits, proof: Proof, refused: Sequence[str] = ()) -> dict[str, Any]:
    """Return what changes as JSON can hold it."""
    return {
        "version": 1,
        "control": made.library.control.name,
        "edits": [edit._asdict() for edit in made.edits],
        "notes": list(made.notes),
        "ran": list(proof.ran),
        "partly": list(proof.partly),
        "refused": list(refused),
    }


def _tell(made: Edits, proof: Proof) -> None:
    """Report what the edits tell, and how far the runs prove them."""
    for note in made.notes:
        print(f"note: {shown(note)}", file=sys.stderr)
    for place in proof.partly:
        print(f"compared as far as it runs: {shown(place)}", file=sys.stderr)
    if proof.ran:
        print(f"ran before and after, the same: {shown(listed(proof.ran))}", file=sys.stderr)


def _finish(made: Edits, proof: Proof, own: Sequence[str], options: Mapping[str, Any]) -> None:
    """Write or show what changes."""
    if options["format"] is Format.JSON:
        write_json(None, _facts(made, proof))
    elif options["check"]:
        for file in made.texts:
            typer.echo(f"would change: {shown(file)}")
    elif options["diff"]:
        write_code([made.diff()])
    elif options["output"] is not None:
        with opened(options["output"], "wb") as to:
            to.write(made.data_of(own[0]))
    elif not options["write"]:
        write_code([made.data_of(own[0]).decode("utf-8", "surrogateescape")])
    if options["write"]:
        for file in made.write():
            print(f"written: {shown(file)}", file=sys.stderr)
