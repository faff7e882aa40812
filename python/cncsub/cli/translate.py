"""The output of `cncsub compare --translate`."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from cncsub.cli.output import write_code, write_json
from cncsub.escapes import shown

if TYPE_CHECKING:
    from cncsub.comparison.translate import Translation

Translate = Annotated[
    bool,
    typer.Option(
        "--translate", help="Rewrite calls so that the second control does what the first one does."
    ),
]


def tell_translation(made: Translation, output: Path | None, *, as_json: bool) -> None:
    """Print what changed, or write all files to a folder; report what no run proves."""
    written = made.write(output) if output is not None else []
    if as_json:
        write_json(None, translation_facts(made))
    elif output is None:
        write_code([made.diff()])
    for path in written:
        print(f"written: {shown(path)}", file=sys.stderr)
    count = sum(map(len, made.edits.values()))
    blocks = f"{count} block{'' if count == 1 else 's'} rewritten"
    print(f"{blocks}, {len(made.added)} programs added: the same, as both ran", file=sys.stderr)
    for place in made.unproved:
        print(f"computed, and the same in this run only: {shown(place)}", file=sys.stderr)


def translation_facts(made: Translation) -> dict[str, Any]:
    """Return what changed as JSON can hold it."""
    return {
        "version": 1,
        "control": made.library.control.name,
        "edits": {
            program: [edit._asdict() for edit in edits] for program, edits in made.edits.items()
        },
        "added": dict(made.added),
        "unproved": list(made.unproved),
    }
