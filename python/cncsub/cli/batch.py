"""The command `cncsub batch`: every program of some folders, with how each stopped or what is wrong
with it.
"""

from __future__ import annotations

import enum
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any

import typer

from cncsub.checking import chosen_rules
from cncsub.cli.folders import (
    Each,
    Folders,
    Jobs,
    MaxBlocks,
    MaxSeconds,
    in_processes,
    work_of,
)
from cncsub.cli.memory import outside
from cncsub.cli.options import (
    ControlName,
    Encoding,
    External,
    Param,
    SearchPath,
    SetupFile,
    setup_for,
    wrong_use,
)
from cncsub.cli.output import tell_all
from cncsub.cli.project import Project, project_for
from cncsub.escapes import shown

_SHOWN = 20  # of the runs that did not end well, and of the findings, as text
FINE = ("ran", "cycles", "note", "foreign")


class BatchFormat(enum.StrEnum):
    """The formats in which `cncsub batch` writes its rows."""

    TEXT = "text"
    JSON = "json"


def batch(
    paths: Folders = None,
    control: ControlName = None,
    param: Param = None,
    jobs: Jobs = None,
    out: Annotated[
        Path | None, typer.Option(help="A folder for Parquet files; the same command resumes.")
    ] = None,
    each: Each = "file",
    external: External = None,
    search: SearchPath = None,
    encoding: Encoding = None,
    setup: SetupFile = None,
    check: Annotated[
        bool,
        typer.Option(
            "--check", help="Check the programs as `cncsub check` does, without running them."
        ),
    ] = False,
    max_blocks: MaxBlocks = 1_000_000,
    max_seconds: MaxSeconds = 10.0,
    format: Annotated[
        BatchFormat, typer.Option(help="json writes one object per line.")
    ] = BatchFormat.TEXT,
) -> None:
    """Run or check every program file of some folders, each alone, and report how each stopped.

    The exit status is 0 if all ran, or nothing was found but notes; otherwise 1.
    """
    options = locals()
    with wrong_use():
        project = project_for(paths)
        tell_all(list(outside(options, project)))
        try:
            with in_processes():
                rows = _rows(options, project)
        except ImportError as error:
            raise ValueError(str(error)) from None
    counts = _tell(rows, format, project.severity)
    if not counts and check and format is BatchFormat.TEXT:
        typer.echo("nothing found")
    if not counts and not check:
        typer.echo("no file was found", err=True)
        raise typer.Exit(2)
    raise typer.Exit(0 if set(counts) <= set(FINE) else 1)


def _rows(options: Mapping[str, Any], project: Project) -> Any:
    """Return the rows of the runs or the findings."""
    from cncsub.archive.many import check_many, run_many

    shared = {**work_of(options, project), "out": options["out"], "progress": True}
    if (setup := setup_for(options, project)) is not None:
        shared["setup"] = setup
    if not options["check"]:
        limits = {name: options[name] for name in ("max_blocks", "max_seconds")}
        return run_many(**shared, **limits)
    asked = chosen_rules(None) - project.ignore
    return check_many(**shared, rules=sorted(asked), entry=project.entry)


def _tell(rows: Any, format: BatchFormat, severities: Mapping[str, str]) -> dict[str, int]:
    """Print the rows, a part of them at a time, and count them by status, findings by severity."""
    counts: dict[str, int] = {}
    told = 0
    for part in rows.to_batches():
        for row in part.to_pylist():
            if row.get("rule"):
                row["severity"] = severities.get(row["rule"], row["severity"])
            status = row.get("severity") or row["status"]
            counts[status] = counts.get(status, 0) + 1
            if format is BatchFormat.JSON:
                typer.echo(json.dumps(row))
            elif (status not in FINE or row["error"]) and (told := told + 1) <= _SHOWN:
                typer.echo(shown(_line(row)))
    if format is BatchFormat.TEXT:
        from cncsub.archive.store import SKIPPED

        _print_counts(counts, told, json.loads(rows.schema.metadata[SKIPPED.encode()]))
    return counts


def _line(row: dict[str, Any]) -> str:
    where = "" if row["line"] is None else f":{row['line']}"
    if row.get("rule"):
        named = f"{row['severity']} {row['rule']} {row['name']}"
        more = f"; {row['error']}" if row["error"] else ""
        return f"{row['file']}{where}: {named}: {row['message']}{more}"
    alarm = " ".join(row[name] for name in ("number", "cause") if row.get(name))
    why = ": ".join(text for text in (alarm, row["error"]) if text)
    return f"{row['path']}{where}: {row['status']}{' ' + why if why else ''}"


def _print_counts(counts: dict[str, int], told: int, skipped: dict[str, int]) -> None:
    if told > _SHOWN:
        typer.echo(f"... and {told - _SHOWN} more; --format json or --out has all")
    for status, count in sorted(counts.items()):
        typer.echo(f"{count:8} {status}")
    for reason, count in sorted(skipped.items()):
        typer.echo(f"{count:8} left out: {reason}")
