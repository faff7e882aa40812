"""The outline of files: programs, numbered blocks, tools, headings; and what can be folded."""

from __future__ import annotations

import re
from collections.abc import Iterator

from lsprotocol.types import (
    DocumentSymbol,
    FoldingRange,
    FoldingRangeKind,
    Range,
    SymbolKind,
    WorkspaceSymbol,
)

from cncsub import _core
from cncsub.editor.names import label_of
from cncsub.editor.snapshot import Snapshot, comment_words
from cncsub.files import clean
from cncsub.program import Block, Program

# Numbered blocks of a program: of more only those that something names, and not more than these.
MOST_NUMBERS = 2_000
MOST_FOUND = 500  # symbols of a workspace that are listed
_TOOL = re.compile(r"(?<![A-Za-z])[Tt]")  # where a word T may begin


def document_symbols(snap: Snapshot, path: str) -> list[DocumentSymbol]:
    """Return the programs of a file, each with what stands in it."""
    return [_program(snap, path, each, end) for each, end in _with_ends(snap, path)]


def _with_ends(snap: Snapshot, path: str) -> Iterator[tuple[Program, int]]:
    """Yield the programs of a file, each with the line, from 0, at which the next one begins."""
    programs = snap.programs_of(path)
    ends = [program.line - 1 for program in programs[1:]] + [len(snap.document(path).lines)]
    return zip(programs, ends)


def _program(snap: Snapshot, path: str, program: Program, end: int) -> DocumentSymbol:
    document = snap.document(path)
    first = program.line - 1
    last = max(first, end - 1)
    head = document.whole_line(first)
    whole = Range(head.start, document.whole_line(last).end)
    inner = [
        *_headings(snap, path, program, last),
        *_words(snap, path, program, last),
        *_parts(snap, path, program, last),
    ]
    inner.sort(key=lambda symbol: (symbol.range.start.line, symbol.range.start.character))
    return DocumentSymbol(
        program.name or "program",
        SymbolKind.Module,
        whole,
        head,
        detail=program.comment or None,
        children=inner,
    )


def _parts(snap: Snapshot, path: str, program: Program, last: int) -> Iterator[DocumentSymbol]:
    """Yield the subprograms that are a part of a program, which ends at a line from 0."""
    document = snap.document(path)
    for part in _inside(snap, path, program, last):
        head = document.whole_line(part.line - 1)
        end = document.whole_line(part.blocks[-1].line - 1 if part.blocks else part.line - 1)
        whole = Range(head.start, end.end)
        yield DocumentSymbol(part.name, SymbolKind.Function, whole, head)


def _inside(snap: Snapshot, path: str, program: Program, last: int) -> list[Program]:
    every = snap.programs_of(path, inside=True)
    return [part for part in every if part.data.inside and program.line <= part.line <= last + 1]


def _words(snap: Snapshot, path: str, program: Program, last: int) -> Iterator[DocumentSymbol]:
    blocks = program.blocks
    numbered = range(len(blocks)) if len(blocks) <= MOST_NUMBERS else sorted(_named(snap, program))
    if len(numbered) > MOST_NUMBERS:
        yield _left_out(snap, path, blocks[numbered[MOST_NUMBERS]], len(numbered) - MOST_NUMBERS)
    for place in numbered[:MOST_NUMBERS]:
        if (label := label_of(blocks[place])) is not None:
            yield _symbol(snap, path, blocks[place], label.column, label.text, SymbolKind.Key)
    for block in _with_tools(snap, path, program, last):
        for token in block.tokens:
            if token.word is not None and token.word.address == "T":
                yield _symbol(snap, path, block, token.column, token.text, SymbolKind.Object)


def _left_out(snap: Snapshot, path: str, block: Block, count: int) -> DocumentSymbol:
    """Return what stands in the outline for so many blocks from one on."""
    at = snap.document(path).whole_line(block.line - 1)
    return DocumentSymbol(f"{count:,} more blocks that jumps lead to", SymbolKind.Key, at, at)


def _with_tools(snap: Snapshot, path: str, program: Program, last: int) -> Iterator[Block]:
    """Yield the blocks of a program that it is worth reading for a tool, to a line from 0."""
    lines = snap.document(path).lines
    for line in range(program.line - 1, min(last + 1, len(lines))):
        if ("T" in lines[line] or "t" in lines[line]) and _TOOL.search(lines[line]):
            yield from snap.blocks_on(program, line)


def _named(snap: Snapshot, program: Program) -> set[int]:
    """Return the places of the blocks that jumps lead to."""
    return {to for _, to in _core.jumps(snap.flows, program.data)}


def _symbol(
    snap: Snapshot, path: str, block: Block, column: int, text: str, kind: SymbolKind
) -> DocumentSymbol:
    at = snap.range(path, block.line, column, len(text))
    detail = block.text.strip()
    return DocumentSymbol(text.rstrip(": ") or text, kind, at, at, detail=detail[:80])


def _headings(snap: Snapshot, path: str, program: Program, last: int) -> Iterator[DocumentSymbol]:
    """Yield the comments that stand alone on a line, each the head of what follows."""
    document = snap.document(path)
    for line in range(program.line, min(last + 1, len(document.lines))):
        begin = document.lines[line].lstrip()[:1]
        if not begin or begin.isalnum() or any(snap.blocks_on(program, line)):
            continue
        if not (comment := comment_alone(snap, document.line(line))):
            continue
        at = document.whole_line(line)
        yield DocumentSymbol(comment, SymbolKind.String, at, at)


def comment_alone(snap: Snapshot, text: str) -> str:
    """Return the words of a comment that is all of a line; nothing where it is not."""
    kinds = [(row[0], row[1]) for row in _core.tokens(snap.control, clean(text))]
    comments = [part for kind, part in kinds if kind == "comment"]
    if len(comments) != 1 or any(kind == "word" for kind, _ in kinds):
        return ""
    return comment_words(comments[0])


def workspace_symbols(snap: Snapshot, query: str) -> list[WorkspaceSymbol]:
    """Return the programs whose names or titles hold the words of a query."""
    wanted = query.casefold()
    found = []
    for name, place in zip(snap.code.names(), snap.code.places(), strict=True):
        program = snap.program(place)
        if program.data.system:
            continue
        if wanted in name.casefold() or wanted in program.comment.casefold():
            shown = f"{name} {program.comment}".strip()
            head = snap.head_of(program)
            found.append(WorkspaceSymbol(head, shown, SymbolKind.Module))
            if len(found) == MOST_FOUND:
                break
    return found


# ---- folding ----


def folding(snap: Snapshot, path: str) -> list[FoldingRange]:
    """Return the programs, the loops and the stretches of one tool."""
    document = snap.document(path)
    found: dict[tuple[int, int], FoldingRange] = {}
    for program, end in _with_ends(snap, path):
        last = end - 1
        while last >= program.line and not document.line(last).strip():
            last -= 1
        regions = [
            (program.line - 1, last),
            *_loops(snap, program),
            *_branches(snap, path, program, last),
            *_tools(snap, path, program, last),
        ]
        for first, to in regions:
            if to > first:
                found[first, to] = FoldingRange(first, to, kind=FoldingRangeKind.Region)
    return [found[key] for key in sorted(found)]


def _loops(snap: Snapshot, program: Program) -> Iterator[tuple[int, int]]:
    """Yield the lines, from 0, of what jumps back: a loop ends with the block that does."""
    data = program.data
    for block, to in _core.jumps(snap.flows, data):
        if to < block:
            yield data.block(to)[1] - 1, data.block(block)[1] - 1


def _branches(snap: Snapshot, path: str, program: Program, last: int) -> Iterator[tuple[int, int]]:
    """Yield the lines, from 0, of the subprograms inside a program, and of branches and loops whose
    statements begin with the same name: o1 while, o1 endwhile.
    """
    heads = set()
    for part in _inside(snap, path, program, last):
        heads.add(part.line)
        if part.blocks:
            yield part.line - 1, part.blocks[-1].line - 1
    data = program.data
    for block, to in _core.jumps(snap.flows, data):
        if to > block and to < data.blocks:
            (_, first, text), (_, end, other) = data.block(block), data.block(to)
            name = text.split(None, 1)[:1]
            if (
                first not in heads
                and name
                and name == other.split(None, 1)[:1]
                and not name[0].isalpha()
            ):
                yield first - 1, end - 1


def _tools(snap: Snapshot, path: str, program: Program, last: int) -> Iterator[tuple[int, int]]:
    begin = None
    for block in _with_tools(snap, path, program, last):
        if any(word.address == "T" for word in block.words):
            if begin is not None:
                yield begin, block.line - 2
            begin = block.line - 1
    if begin is not None:
        yield begin, last
