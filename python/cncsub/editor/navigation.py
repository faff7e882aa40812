"""Where names lead to: definition, references, call hierarchy, links."""

from __future__ import annotations

from collections.abc import Iterator

from lsprotocol.types import (
    CallHierarchyIncomingCall,
    CallHierarchyItem,
    CallHierarchyOutgoingCall,
    DocumentHighlight,
    DocumentHighlightKind,
    DocumentLink,
    Location,
    Range,
    SymbolKind,
)

from cncsub import _core
from cncsub.editing import Mention
from cncsub.editor.names import (
    At,
    Name,
    block_of,
    label_of,
    location,
    mentions,
    name_at,
    writes,
)
from cncsub.editor.snapshot import MANY_LINES, Snapshot, uri_of
from cncsub.program import Block, Program

MOST_LINES_LIT = 2_000  # before and after a place of a long document
_NEAR = 1_000  # lines in which a writer is sought first


def definition(snap: Snapshot, path: str, line: int, character: int) -> list[Location]:
    """Return where the program, the block or the variable at a place is defined. That of a variable
    is the last block before that writes it, else every block that does.
    """
    found = name_at(snap, path, line, character)
    if found is None:
        return []
    name, here = found
    if name.kind == "program":
        return [snap.head_of(snap.program(int(name.key)))]
    if name.kind == "block":
        return [_block_place(snap, block_of(snap, name))]
    if (writer := _last_writer(snap, name, here)) is not None:
        return [location(snap, writer)]
    every = mentions(snap, name)
    others = [m for m in every if m.fixed or m.defines]  # as the letter of a call
    writers = [mention for mention in every if writes(snap, mention)]
    both = dict.fromkeys([*others, *writers])
    return [location(snap, mention) for mention in both] or list(_arguments(snap, name))


def _last_writer(snap: Snapshot, name: Name, here: At) -> Mention | None:
    """Return the last mention of a variable that writes it, in the lines of its file before a
    place: a block reads before it writes.
    """
    last, count = here.line - 1, _NEAR
    while last > 0:
        first = max(1, last - count)
        for mention in reversed(mentions(snap, name, (here.file, first, last))):
            if writes(snap, mention):
                return mention
        last, count = first - 1, count * 8
    return None


def _block_place(snap: Snapshot, block: Block) -> Location:
    label = label_of(block)
    column, width = (label.column, len(label.text)) if label else (1, len(block.text))
    return snap.location(block.program.file, block.line, column, width)


def _arguments(snap: Snapshot, name: Name) -> Iterator[Location]:
    """Yield the calls that may give a variable of a program its value."""
    if name.program is None:
        return
    for caller, at, row in snap.calls:
        if row[2] == name.program:
            block = snap.program(caller).blocks[at]
            yield snap.location(block.program.file, block.line, row[10], len(row[9]))


def references(
    snap: Snapshot, path: str, line: int, character: int, *, definitions: bool
) -> list[Location]:
    """Return every place that names the same as the word at a place."""
    found = name_at(snap, path, line, character)
    if found is None:
        return []
    name = found[0]
    own = name.kind == "variable"  # whatever writes a variable is a use of it
    return [
        location(snap, each)
        for each in mentions(snap, name)
        if definitions or own or not each.defines
    ]


def highlights(snap: Snapshot, path: str, line: int, character: int) -> list[DocumentHighlight]:
    """Return every place of a file that names the same as the word at a place; of a long file
    those in the lines near the place.
    """
    found = name_at(snap, path, line, character)
    if found is None:
        return []
    near = MOST_LINES_LIT if snap.is_long(path) else MANY_LINES
    lines = (path, max(1, line + 1 - near), line + 1 + near)
    kinds = {True: DocumentHighlightKind.Write, False: DocumentHighlightKind.Read}
    return [
        DocumentHighlight(location(snap, each).range, kinds[each.defines or writes(snap, each)])
        for each in mentions(snap, found[0], lines)
    ]


# ---- calls ----

_CALLER, _CALLED = 0, 1  # the ends of a call


def call_item(snap: Snapshot, program: Program) -> CallHierarchyItem:
    """Return a program as an item of the call hierarchy."""
    head = snap.head_of(program)
    return CallHierarchyItem(
        program.name,
        SymbolKind.Function,
        head.uri,
        head.range,
        head.range,
        detail=program.comment or None,
        data={"program": program.name, "file": program.file, "line": program.line},
    )


def prepare_calls(snap: Snapshot, path: str, line: int, character: int) -> list[CallHierarchyItem]:
    """Return the program that is called at a place, else the one in which the place is."""
    found = name_at(snap, path, line, character)
    if found is not None and found[0].kind == "program":
        return [call_item(snap, snap.program(int(found[0].key)))]
    program = snap.program_at(path, line)
    return [] if program is None else [call_item(snap, program)]


def _program_of(snap: Snapshot, item: CallHierarchyItem) -> Program | None:
    told = item.data if isinstance(item.data, dict) else {}
    for program in snap.programs_of(str(told.get("file", "")), inside=True):
        if program.name == told.get("program"):
            return program
    return None


def incoming(snap: Snapshot, item: CallHierarchyItem) -> list[CallHierarchyIncomingCall]:
    """Return the programs that call a program, each with the words that do."""
    return [CallHierarchyIncomingCall(*each) for each in _calls(snap, item, _CALLED, _CALLER)]


def outgoing(snap: Snapshot, item: CallHierarchyItem) -> list[CallHierarchyOutgoingCall]:
    """Return the programs that a program calls, each with the words that do."""
    return [CallHierarchyOutgoingCall(*each) for each in _calls(snap, item, _CALLER, _CALLED)]


def _calls(
    snap: Snapshot, item: CallHierarchyItem, own: int, other: int
) -> Iterator[tuple[CallHierarchyItem, list[Range]]]:
    """Yield what stands at the other end of the calls of a program, each with the words."""
    program = _program_of(snap, item)
    if program is None:
        return
    found: dict[int, list[Range]] = {}
    for caller, at, row in snap.calls:
        ends = (caller, row[2])
        if ends[own] == program.index and (there := ends[other]) is not None:
            found.setdefault(there, []).append(_call_range(snap, caller, at, row))
    for place, words in found.items():
        yield call_item(snap, snap.program(place)), words


def _call_range(snap: Snapshot, caller: int, at: int, row: _core._CallRow) -> Range:
    block = snap.program(caller).blocks[at]
    return snap.range(block.program.file, block.line, row[10], len(row[9]))


def links(snap: Snapshot, path: str) -> list[DocumentLink]:
    """Return the calls of a file that lead to another file."""
    found = []
    for caller, at, row in snap.calls:
        data = snap.code.program(caller)
        if data.file != path or data.inside or row[2] is None:
            continue
        called = snap.program(row[2])
        if called.file == path or called.data.system:
            continue
        place = _call_range(snap, caller, at, row)
        target = f"{uri_of(called.file)}#L{called.line}"
        found.append(DocumentLink(place, target, tooltip=f"{called.name} {called.comment}".strip()))
    return found
