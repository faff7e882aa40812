"""What `check` finds, as diagnostics of an editor, and the edits that correct it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from lsprotocol.types import (
    CodeAction,
    CodeActionKind,
    Command,
    Diagnostic,
    DiagnosticRelatedInformation,
    DiagnosticSeverity,
    DiagnosticTag,
    Range,
    TextEdit,
    WorkspaceEdit,
)

from cncsub.checking import Edit, Finding
from cncsub.editor.snapshot import Snapshot, uri_of

SOURCE = "cncsub"
RENUMBER = "source.renumber"  # the kind of an action
MOST_PLACES = 200  # of one finding
_SEVERITIES = {
    "error": DiagnosticSeverity.Error,
    "warning": DiagnosticSeverity.Warning,
    "note": DiagnosticSeverity.Information,
}
_UNUSED = ("unreachable", "argument-never-read")


def diagnostics(snap: Snapshot, path: str) -> list[Diagnostic]:
    """Return what is found in a file; each place of a finding is a diagnostic of its own."""
    return [each for finding in snap.findings(path) for each in _of(snap, path, finding)]


def _of(snap: Snapshot, path: str, finding: Finding) -> Iterator[Diagnostic]:
    number = finding.alarm.number if finding.alarm is not None else None
    message = f"{finding.message}{f' [alarm {number}]' if number else ''}\n{finding.hint}"
    related = list(_related(snap, finding))
    places = [
        (finding.line, finding.column, finding.word),
        *((p.line, p.column, p.word) for p in finding.places[:MOST_PLACES] if p.file == path),
    ]
    for line, column, word in places:
        yield Diagnostic(
            snap.range(path, line, column, len(word)),
            message,
            _SEVERITIES[finding.severity],
            code=finding.rule,
            source=SOURCE,
            tags=[DiagnosticTag.Unnecessary] if finding.name in _UNUSED else None,
            related_information=related or None,
        )


def _related(snap: Snapshot, finding: Finding) -> Iterator[DiagnosticRelatedInformation]:
    """Yield the calls that lead to a finding, the outermost first."""
    for frame in finding.path:
        line = snap.document(frame.file).line(frame.line - 1)
        at = snap.location(frame.file, frame.line, 1, len(line))
        told = f"{frame.program} calls {frame.called} ({frame.kind})"
        yield DiagnosticRelatedInformation(at, told)


# ---- edits ----


def actions(snap: Snapshot, path: str, asked: Range) -> list[CodeAction]:
    """Return the corrections of what is found in a range, and one of all in the file."""
    fixed = [finding for finding in snap.findings(path) if finding.fix]
    found = []
    for finding in fixed:
        at = snap.range(path, finding.line, finding.column, len(finding.word))
        if at.start.line <= asked.end.line and asked.start.line <= at.end.line:
            found.append(_action(snap, path, finding))
    if len(fixed) > 1:
        edits = [edit for finding in fixed for edit in finding.fix or ()]
        kind = CodeActionKind.SourceFixAll
        found.append(
            CodeAction(f"Correct {len(fixed)} findings", kind, edit=workspace_edit(snap, edits))
        )
    found.append(
        CodeAction(
            "Number the blocks anew",
            RENUMBER,
            command=Command("Number the blocks anew", "cncsub.renumber", arguments=[path]),
        )
    )
    return found


def _action(snap: Snapshot, path: str, finding: Finding) -> CodeAction:
    edits = finding.fix or ()
    changes = ", ".join(f"{edit.old or 'nothing'} to {edit.new.strip()}" for edit in edits)
    return CodeAction(
        f"Change {changes}",
        CodeActionKind.QuickFix,
        diagnostics=[next(_of(snap, path, finding))],
        is_preferred=True,
        edit=workspace_edit(snap, edits),
    )


def text_edits(snap: Snapshot, edits: Iterable[Edit]) -> dict[str, list[TextEdit]]:
    """Return edits as the client makes them, by file; those that no longer fit are left out."""
    changes: dict[str, list[TextEdit]] = {}
    for edit in dict.fromkeys(edits):
        document = snap.document(edit.file)
        line = document.line(edit.line - 1)
        at = edit.column - 1 if edit.old else len(line)
        if line[at : at + len(edit.old)] != edit.old:
            continue
        place = document.range(edit.line - 1, at, len(edit.old))
        changes.setdefault(edit.file, []).append(TextEdit(place, edit.new))
    return changes


def workspace_edit(snap: Snapshot, edits: Iterable[Edit]) -> WorkspaceEdit:
    """Return edits of several files as one change of the client."""
    changes = text_edits(snap, edits)
    return WorkspaceEdit(changes={uri_of(path): rows for path, rows in changes.items()})
