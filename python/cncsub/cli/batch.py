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

from cncsub import system
from cncsub.archive.work import WorkersError
from cncsub.checking import chosen_rules
from cncsub.cli.options import (
    ControlName,
    Encoding,
    External,
    Param,
    SetupFile,
    control_for,
    outside,
    setup_for,
    tell_all,
    wrong_use,
)
from cncsub.cli.project import Project, project_for
from cncsub.escapes import shown

_SHOWN = 20  # of the runs that did not end well, and of the findings, as text
NOT_DONE = 5  # exit status: no room for processes
FINE = ("ran", "cycles", "note", "foreign")


class BatchFormat(enum.StrEnum):
    """The formats in which `cncsub batch` writes its rows."""

    TEXT = "text"
    JSON = "json"


def batch(
    paths: Annotated[
        list[str] | None, typer.Argument(help="Files and folders.", show_default=False)
    ] = None,
    control: ControlName = None,
    param: Param = None,
    jobs: Annotated[
        int | None, typer.Option("-j", "--jobs", help="The number of processes.", min=1)
    ] = None,
    out: Annotated[
        Path | None, typer.Option(help="A folder for Parquet files; the same command resumes.")
    ] = None,
    each: Annotated[
        str,
        typer.Option(help="What one run loads: file, beside (all files of its folder) or folder."),
    ] = "file",
    external: External = None,
    encoding: Encoding = None,
    setup: SetupFile = None,
    check: Annotated[
        bool,
        typer.Option(
            "--check", help="Check the programs as `cncsub check` does, without running them."
        ),
    ] = False,
    max_blocks: Annotated[int, typer.Option(help="The limit of each run.", min=0)] = 1_000_000,
    max_seconds: Annotated[float, typer.Option(help="The limit of each run.")] = 10.0,
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
            with system.started_without_main():
                rows = _rows(options, project)
        except ImportError as error:
            raise ValueError(str(error)) from None
        except WorkersError as error:
            typer.echo(f"cncsub: {error}", err=True)
            raise typer.Exit(NOT_DONE) from None
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

    paths = options["paths"] or list(project.folders)
    if not paths:
        raise ValueError("which programs? Give files or folders")
    shared: dict[str, Any] = {
        "control": control_for(options, project),
        "each": options["each"],
        "external": options["external"] or project.external,
        "encoding": options["encoding"],
        "jobs": options["jobs"],
        "out": options["out"],
        "progress": True,
    }
    if (setup := setup_for(options, project)) is not None:
        shared["setup"] = setup
    if not options["check"]:
        limits = {name: options[name] for name in ("max_blocks", "max_seconds")}
        return run_many(paths, **shared, **limits)
    asked = chosen_rules(None) - project.ignore
    return check_many(paths, **shared, rules=sorted(asked), entry=project.entry)


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
