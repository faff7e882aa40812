"""`cncsub check`: what the control would refuse or what will surprise, without running."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any, NamedTuple

import typer

import cncsub
from cncsub.checking import Finding, chosen_rules, counts
from cncsub.cli.memory import files_beside, idle_entries, library_of, outside
from cncsub.cli.options import (
    ControlName,
    Encoding,
    External,
    FindingFormat,
    Main,
    Output,
    Param,
    Paths,
    Prefer,
    SearchPath,
    SetupFile,
    setup_for,
    wrong_use,
)
from cncsub.cli.output import tell_all, write_code, write_json, write_text
from cncsub.cli.project import Project, project_for
from cncsub.escapes import shown
from cncsub.reports.printing import Console, Text

Rules = Annotated[
    list[str] | None,
    typer.Option("--rule", help="Check only this rule: CS201, its name, or a group such as CS2."),
]
Ignore = Annotated[list[str] | None, typer.Option("--ignore", help="Leave this rule out.")]
Apart = Annotated[
    bool,
    typer.Option(
        "--apart", help="Check each file by itself, with the files of its folder that it calls."
    ),
]
Fix = Annotated[
    bool, typer.Option("--fix", help="Correct the files where the correction is certain.")
]
Diff = Annotated[bool, typer.Option("--diff", help="Print what --fix would change.")]


def check(
    paths: Paths = None,
    control: ControlName = None,
    main: Main = None,
    param: Param = None,
    external: External = None,
    search: SearchPath = None,
    prefer: Prefer = None,
    encoding: Encoding = None,
    setup: SetupFile = None,
    rule: Rules = None,
    ignore: Ignore = None,
    apart: Apart = False,
    fix: Fix = False,
    diff: Diff = False,
    format: Annotated[FindingFormat, typer.Option()] = FindingFormat.TEXT,
    output: Output = None,
) -> None:
    """Find what the control would refuse and what may surprise, without running.

    The exit status is 1 for an error or a warning. `cncsub explain CS201` explains a rule; a
    comment (cncsub: ignore CS201) switches it off for its line.
    """
    options = {**locals(), "mdi": None}
    with wrong_use():
        project = project_for(paths)
        asked = chosen_rules(rule) - chosen_rules(ignore or ()) - project.ignore
        tell_all(list(outside(options, project)))
        each = [[path] for path in dict.fromkeys(paths)] if apart and paths else [paths]
        parts = [_check_part({**options, "paths": part}, project, asked) for part in each]
        found = [finding for part in parts for finding in part.findings]
        tell_all(list(idle_entries(options, project, [part.library for part in parts])))
        if fix or diff:
            _mend(found, any("<text>" in part.library.files for part in parts), diff)
        if fix and not diff:  # the findings in the files as they are now
            parts = [_check_part({**options, "paths": part}, project, asked) for part in each]
            found = [finding for part in parts for finding in part.findings]
    _write(found, parts, format, output)
    raise typer.Exit(1 if any(finding.severity != "note" for finding in found) else 0)


class _Part(NamedTuple):
    """A memory that was checked, and what was found in the files that are asked for."""

    library: cncsub.Library
    findings: list[Finding]


def _check_part(options: Mapping[str, Any], project: Project, asked: frozenset[str]) -> _Part:
    from cncsub.reports import findings, hints

    library = library_of(options)
    siblings = files_beside(options, library)

    def look(at: cncsub.Library) -> list[Finding]:
        setup = setup_for(options, project)
        found = at.check(options["main"], sorted(asked), setup=setup, entry=project.entry)
        return [finding for finding in found if finding.file not in siblings]

    found = look(library)
    own = [file for file in library.files if file not in siblings]
    language = hints.language_beside_findings(library, found, look, own)
    if language is not None:
        print(f"hint: {shown(language)}", file=sys.stderr)
    if language is None or len(own) > 1:
        found = hints.with_ways_past(library, found, look)
    return _Part(library, findings.with_severity(found, dict(project.severity)))


def _mend(found: list[Finding], typed: bool, diff: bool) -> None:
    """Write or show the edits."""
    from cncsub.reports import findings

    if typed:
        raise ValueError("a program from standard input cannot be corrected: give its file")
    mended = findings.Mended(found)
    if diff:
        write_code([mended.diff()])
        return
    for file in mended.write():
        print(f"mended: {shown(file)}", file=sys.stderr)
    if mended.left:
        print(
            f"{mended.left} corrections no longer fit the file and were left out", file=sys.stderr
        )


def _write(
    found: Sequence[Finding], parts: Sequence[_Part], format: FindingFormat, output: Path | None
) -> None:
    from cncsub.reports import findings

    files = dict.fromkeys(file for part in parts for file in part.library.files)

    def text(of: str) -> Callable[[Console], None]:
        return lambda console: console.print(of)

    if format is FindingFormat.JSON:
        write_json(output, findings.finding_facts(found))
    elif format is FindingFormat.SARIF:
        write_json(output, findings.sarif(found))
    elif format is FindingFormat.JUNIT:
        write_text(output, text(findings.junit(found, files)))
    elif format is FindingFormat.GITHUB:
        if found:
            write_text(output, text(findings.github_annotations(found)))
    else:
        write_text(output, lambda console: _print(console, found, [part.library for part in parts]))


_COLOURS = {"error": "bold red", "warning": "yellow", "note": "cyan"}


def _print(console: Console, found: Sequence[Finding], libraries: Sequence[cncsub.Library]) -> None:
    for finding in found:
        severity, rest = str(finding).split(" ", 1)
        lines = "\n".join(shown(line) for line in rest.split("\n"))
        console.print(Text.assemble((severity, _COLOURS[severity]), f" {lines}\n"))
    count = sum(map(len, libraries))
    programs = f"{count:,} program{'' if count == 1 else 's'} on"
    told = ", ".join(f"{n:,} {name}{'' if n == 1 else 's'}" for name, n in counts(found))
    title = libraries[0].control.title
    console.print(f"checked: {programs} {title}: {told or 'nothing found'}")
    for library in libraries:
        for file, why in library.skipped:
            console.print(f"left out: {shown(f'{file}: {why}')}")
