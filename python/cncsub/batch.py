"""The command `cncsub batch`: every program of some folders, and how each stopped."""

from __future__ import annotations

import enum
import json
from pathlib import Path
from typing import Annotated, Any

import typer

from cncsub.controls import names_beginning
from cncsub.options import wrong_use
from cncsub.printing import shown

_SHOWN = 20  # of the runs that did not end well, as text
FINE = ("ran", "cycles")


class BatchFormat(enum.StrEnum):
    """How `cncsub batch` tells its rows."""

    TEXT = "text"
    JSON = "json"


def batch(
    paths: Annotated[list[str], typer.Argument(help="Files and folders.", show_default=False)],
    control: Annotated[
        str,
        typer.Option(
            "-c",
            "--control",
            help="The control; `cncsub controls` lists them.",
            autocompletion=names_beginning,
        ),
    ],
    jobs: Annotated[
        int | None, typer.Option("-j", "--jobs", help="How many processes work.", min=1)
    ] = None,
    out: Annotated[
        Path | None, typer.Option(help="A folder for Parquet files; the same call resumes.")
    ] = None,
    each: Annotated[str, typer.Option(help="file, beside or folder: what one run loads.")] = "file",
    external: Annotated[
        Path | None, typer.Option(help="The folder of the external device, which M198 reads.")
    ] = None,
    max_blocks: Annotated[int, typer.Option(help="Of one run.", min=0)] = 1_000_000,
    max_seconds: Annotated[float, typer.Option(help="Of one run.")] = 10.0,
    format: Annotated[
        BatchFormat, typer.Option(help="json writes an object a line.")
    ] = BatchFormat.TEXT,
) -> None:
    """Run every program file of some folders, each alone, and tell how each stopped.

    Exit status: 0 where all ran, 1 where some did not.
    """
    from cncsub.archives import run_many

    with wrong_use():
        try:
            rows = run_many(
                paths,
                control,
                each=each,
                external=external,
                jobs=jobs,
                out=out,
                progress=True,
                max_blocks=max_blocks,
                max_seconds=max_seconds,
            )
        except ImportError as error:
            raise ValueError(str(error)) from None
    counts = _tell(rows, format)
    if not counts:
        typer.echo("no file was found there", err=True)
        raise typer.Exit(2)
    raise typer.Exit(0 if set(counts) <= set(FINE) else 1)


def _tell(rows: Any, format: BatchFormat) -> dict[str, int]:
    """Print the rows, a part of them at a time, and count them by status."""
    counts: dict[str, int] = {}
    told = 0
    for part in rows.to_batches():
        for row in part.to_pylist():
            status = row["status"]
            counts[status] = counts.get(status, 0) + 1
            if format is BatchFormat.JSON:
                typer.echo(json.dumps(row))
            elif status not in FINE and (told := told + 1) <= _SHOWN:
                typer.echo(shown(_line(row)))
    if format is BatchFormat.TEXT:
        from cncsub.archive_store import SKIPPED

        _print_counts(counts, told, json.loads(rows.schema.metadata[SKIPPED.encode()]))
    return counts


def _line(row: dict[str, Any]) -> str:
    where = "" if row["line"] is None else f":{row['line']}"
    alarm = " ".join(row[name] for name in ("number", "cause") if row[name])
    why = ": ".join(text for text in (alarm, row["error"]) if text)
    return f"{row['path']}{where}: {row['status']}{' ' + why if why else ''}"


def _print_counts(counts: dict[str, int], told: int, skipped: dict[str, int]) -> None:
    if told > _SHOWN:
        typer.echo(f"... and {told - _SHOWN} more; --format json or --out tells all")
    for status, count in sorted(counts.items()):
        typer.echo(f"{count:8} {status}")
    for reason, count in sorted(skipped.items()):
        typer.echo(f"{count:8} left out: {reason}")
