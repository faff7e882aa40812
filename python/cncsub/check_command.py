"""`cncsub check`: what the control would refuse or what will surprise, without running."""

from __future__ import annotations

import enum
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

import cncsub
from cncsub.checking import Finding, chosen_rules, counts
from cncsub.options import (
    ControlName,
    Encoding,
    External,
    Main,
    Output,
    Param,
    Paths,
    Prefer,
    SetupFile,
    files_beside,
    library_of,
    write_json,
    write_text,
    wrong_use,
)
from cncsub.printing import Console, Text, shown
from cncsub.project import project_for

if TYPE_CHECKING:
    from cncsub import findings


class FindingFormat(enum.StrEnum):
    TEXT = "text"
    JSON = "json"
    SARIF = "sarif"
    JUNIT = "junit"
    GITHUB = "github"


Rules = Annotated[
    list[str] | None,
    typer.Option("--rule", help="Ask this rule: CS201, its name, or a group such as CS2."),
]
Ignore = Annotated[list[str] | None, typer.Option("--ignore", help="Leave this rule out.")]
Fix = Annotated[bool, typer.Option("--fix", help="Mend what is certain, in the files.")]
Diff = Annotated[bool, typer.Option("--diff", help="Print what --fix would change.")]


def check(
    paths: Paths = None,
    control: ControlName = None,
    main: Main = None,
    param: Param = None,
    external: External = None,
    prefer: Prefer = None,
    encoding: Encoding = None,
    setup: SetupFile = None,
    rule: Rules = None,
    ignore: Ignore = None,
    fix: Fix = False,
    diff: Diff = False,
    format: Annotated[FindingFormat, typer.Option()] = FindingFormat.TEXT,
    output: Output = None,
) -> None:
    """Tell what the control would refuse and what will surprise, without running.

    Exit status 1 where there is an error or a warning. `cncsub explain CS201` explains a rule; a
    comment (cncsub: ignore CS201) switches it off for its line.
    """
    options = {**locals(), "mdi": None}
    from cncsub import findings

    with wrong_use():
        project = project_for(paths)
        library = library_of(options)
        beside = files_beside(options, library)
        asked = chosen_rules(rule) - chosen_rules(ignore or ()) - project.ignore
        machine = setup or project.setup
        known = cncsub.Setup.from_toml(machine) if machine is not None else None
        found = library.check(main, sorted(asked), setup=known)
        found = [finding for finding in found if finding.file not in beside]
        found = findings.with_severity(found, dict(project.severity))
        if fix or diff:
            found = _mend(findings.Mended(found), found, library, diff)
    _write(found, library, format, output)
    raise typer.Exit(1 if any(finding.severity != "note" for finding in found) else 0)


def _mend(
    mended: findings.Mended, found: list[Finding], library: cncsub.Library, diff: bool
) -> list[Finding]:
    """Writes or shows the edits; the findings that are left."""
    if "<text>" in library.files:
        raise ValueError("what comes from standard input cannot be mended: name its file")
    if diff:
        sys.stdout.write(mended.diff())
        return found
    for file in mended.write():
        print(f"mended: {shown(file)}", file=sys.stderr)
    if mended.left:
        print(f"{mended.left} edits fit no longer and were left out", file=sys.stderr)
    return [finding for finding in found if finding.fix is None]


def _write(
    found: Sequence[Finding], library: cncsub.Library, format: FindingFormat, output: Path | None
) -> None:
    from cncsub import findings

    def text(of: str) -> Callable[[Console], None]:
        return lambda console: console.print(of)

    if format is FindingFormat.JSON:
        write_json(output, findings.finding_facts(found))
    elif format is FindingFormat.SARIF:
        write_json(output, findings.sarif(found))
    elif format is FindingFormat.JUNIT:
        write_text(output, text(findings.junit(found, library.files)))
    elif format is FindingFormat.GITHUB:
        if found:
            write_text(output, text(findings.github_annotations(found)))
    else:
        write_text(output, lambda console: _print(console, found, library))


_COLOURS = {"error": "bold red", "warning": "yellow", "note": "cyan"}


def _print(console: Console, found: Sequence[Finding], library: cncsub.Library) -> None:
    for finding in found:
        severity, rest = str(finding).split(" ", 1)
        lines = "\n".join(shown(line) for line in rest.split("\n"))
        console.print(Text.assemble((severity, _COLOURS[severity]), f" {lines}\n"))
    programs = f"{len(library):,} program{'' if len(library) == 1 else 's'} on"
    told = ", ".join(f"{n:,} {name}{'' if n == 1 else 's'}" for name, n in counts(found))
    console.print(f"checked: {programs} {library.control.title}: {told or 'nothing found'}")
    for file, why in library.skipped:
        console.print(f"left out: {shown(f'{file}: {why}')}")
