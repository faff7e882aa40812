"""Changes that an editor asks for: other names, another layout, new sequence numbers."""

from __future__ import annotations

from lsprotocol.types import (
    FormattingOptions,
    OptionalVersionedTextDocumentIdentifier,
    PrepareRenamePlaceholder,
    RenameFile,
    TextDocumentEdit,
    TextEdit,
    WorkspaceEdit,
)

from cncsub.editing import Edits, format, rename, renumber
from cncsub.editing.formatting import MOST_INDENT
from cncsub.editor.diagnostics import text_edits, workspace_edit
from cncsub.editor.names import location, mention_at
from cncsub.editor.snapshot import Snapshot, uri_of


def prepare_rename(
    snap: Snapshot, path: str, line: int, character: int
) -> PrepareRenamePlaceholder | None:
    """Return the name at a place that can be another one, `None` where there is none."""
    mention = mention_at(snap, path, line, character)
    if mention is None or mention.computed or mention.fixed:
        return None
    return PrepareRenamePlaceholder(location(snap, mention).range, mention.text)


def renamed(snap: Snapshot, path: str, line: int, character: int, new: str) -> WorkspaceEdit | None:
    """Return the edits that give what is named at a place another number or name.

    Raises `ValueError`, `KeyError` or `EditError` where it cannot be named so.
    """
    mention = mention_at(snap, path, line, character)
    if mention is None:
        return None
    return changed(snap, rename(snap.library, mention, new, machine=snap.machine))


def formatted(
    snap: Snapshot, path: str, options: FormattingOptions, first: int = 0, last: int | None = None
) -> list[TextEdit]:
    """Return the edits that lay out the blocks of a file, or those of some lines."""
    if path not in snap.library.files:
        return []
    made = format(snap.library, [path], indent=min(max(0, options.tab_size), MOST_INDENT))
    end = len(snap.document(path).lines) if last is None else last
    wanted = [edit for edit in made.edits if first <= edit.line - 1 <= end]
    return text_edits(snap, wanted).get(path, [])


def renumbered(snap: Snapshot, path: str) -> WorkspaceEdit:
    """Return the edits that number the blocks of the programs of a file anew. Raises `EditError`
    where a number cannot be followed.
    """
    if path not in snap.library.files:
        return changed(snap, Edits(snap.library, ()))
    return changed(snap, renumber(snap.library, files=[path], machine=snap.machine))


def changed(snap: Snapshot, edits: Edits) -> WorkspaceEdit:
    """Return edits of programs, and the new names of their files, as the client makes them."""
    if not edits.files:
        return workspace_edit(snap, edits.edits)
    moves = [RenameFile(uri_of(old), uri_of(new)) for old, new in edits.files.items()]
    texts = [
        TextDocumentEdit(OptionalVersionedTextDocumentIdentifier(uri_of(path)), rows)
        for path, rows in text_edits(snap, edits.edits).items()
    ]
    return WorkspaceEdit(document_changes=[*texts, *moves])
