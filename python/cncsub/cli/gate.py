"""`cncsub gate`: whether the output of a post processor may go to the machine."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

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
    FindingFormat,
    Output,
    Param,
    SearchPath,
    SetupFile,
    setup_for,
    wrong_use,
)
from cncsub.cli.output import tell_all, write_json, write_text
from cncsub.cli.project import Project, project_for
from cncsub.escapes import shown

if TYPE_CHECKING:
    from cncsub.archive.gate import Gate, GatedFile
    from cncsub.checking import Finding
    from cncsub.reports.printing import Console


def gate(
    paths: Folders = None,
    control: ControlName = None,
    allow: Annotated[
        Path | None,
        typer.Option("--allow", help="A file of what may be found: WHAT, or WHAT FILES, a line."),
    ] = None,
    strict: Annotated[bool, typer.Option("--strict", help="Warnings do not pass either.")] = False,
    param: Param = None,
    jobs: Jobs = None,
    each: Each = "file",
    external: External = None,
    search: SearchPath = None,
    encoding: Encoding = None,
    setup: SetupFile = None,
    max_blocks: MaxBlocks = 1_000_000,
    max_seconds: MaxSeconds = 10.0,
    format: Annotated[FindingFormat, typer.Option()] = FindingFormat.TEXT,
    output: Output = None,
) -> None:
    """Let programs pass that the control reads, that come to their end and stay within its limits.

    The exit status is 1 where a file does not pass. Refused and not computed codes, missing heads
    and ends and the alarms of a dry run are errors; the limits of travel are those of the setup.
    """
    options = locals()
    with wrong_use():
        project = project_for(paths)
        tell_all(list(outside(options, project)))
        with in_processes():
            found = _gated(options, project)
        if not found.files:
            raise ValueError("no program was found")
    fails = ("error", "warning") if strict else ("error",)
    _write(found, fails, format, output)
    for entry in found.unused:
        where = "" if entry.files == "*" else f" {entry.files}"
        told = f"{allow}:{entry.line}: {entry.what}{where} lets nothing pass: remove it"
        typer.echo(f"note: {shown(told)}", err=True)
    raise typer.Exit(0 if all(file.passes(fails) for file in found.files) else 1)


def _gated(options: Mapping[str, Any], project: Project) -> Gate:
    from cncsub.archive.gate import gate as gate_of

    more = {} if options["allow"] is None else {"allow": options["allow"]}
    return gate_of(
        **work_of(options, project),
        setup=setup_for(options, project),
        rules=sorted(chosen_rules(None) - project.ignore),
        entry=project.entry,
        max_blocks=options["max_blocks"],
        max_seconds=options["max_seconds"],
        **more,
    )


def _write(found: Gate, fails: tuple[str, ...], format: FindingFormat, output: Path | None) -> None:
    from cncsub.gate_rules import RULES
    from cncsub.reports import findings

    every = [finding for file in found.files for finding in file.findings]
    if format is FindingFormat.JSON:
        write_json(output, _facts(found, fails))
    elif format is FindingFormat.SARIF:
        write_json(output, findings.sarif(every, RULES))
    elif format is FindingFormat.JUNIT:
        paths = [file.path for file in found.files]
        text = findings.junit(every, paths, "gate", fails)
        write_text(output, lambda console: console.print(text))
    elif format is FindingFormat.GITHUB:
        if every:
            text = findings.github_annotations(every)
            write_text(output, lambda console: console.print(text))
    else:
        write_text(output, lambda console: _print(console, found, fails))


def _facts(found: Gate, fails: tuple[str, ...]) -> dict[str, Any]:
    """Return what the gate found as JSON can hold it."""
    from cncsub.reports.findings import finding_facts

    return {
        "version": 1,
        "files": [
            {
                "path": file.path,
                "passes": file.passes(fails),
                "fault": file.fault,
                "findings": finding_facts(file.findings)["findings"],
                "allowed": finding_facts(file.allowed)["findings"],
            }
            for file in found.files
        ],
        "unused": [entry._asdict() for entry in found.unused],
        "skipped": dict(found.skipped),
    }


def _print(console: Console, found: Gate, fails: tuple[str, ...]) -> None:
    for file in found.files:
        console.print(shown(_line(file, fails)))
    passed = sum(file.passes(fails) for file in found.files)
    count = len(found.files)
    allowed = sum(len(file.allowed) for file in found.files)
    more = f"; {allowed:,} findings allowed" if allowed else ""
    files = f"{count:,} file{'' if count == 1 else 's'}"
    console.print(f"{files}: {passed:,} passed, {count - passed:,} did not{more}")
    for reason, number in sorted(found.skipped.items()):
        console.print(f"{number:,} left out: {shown(reason)}")


def _line(file: GatedFile, fails: tuple[str, ...]) -> str:
    """Return the line of a file: whether it passes, and the first thing that lets it fail."""
    if file.fault is not None:
        return f"FAILED {file.path}: {file.fault}"
    severe = [finding for finding in file.findings if finding.severity in fails]
    others = len(file.findings) - len(severe)
    if not severe:
        more = (
            f" ({others} other findings)" if others > 1 else " (1 other finding)" if others else ""
        )
        return f"passed {file.path}{more}"
    more = f" (and {len(severe) - 1} more)" if len(severe) > 1 else ""
    return f"FAILED {file.path}: {_told(severe[0])}{more}"


def _told(finding: Finding) -> str:
    number = (
        f" [{finding.alarm.number}]" if finding.alarm is not None and finding.alarm.number else ""
    )
    word = f" {finding.word.strip()}" if finding.word.strip() else ""
    return f"line {finding.line}: {finding.rule} {finding.name}{number}:{word} {finding.message}"
