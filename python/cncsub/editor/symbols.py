"""The outline of files: programs, numbered blocks, tools, headings; and what can be folded."""

from __future__ import annotations

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
from cncsub.editor.snapshot import Snapshot, place_of
from cncsub.program import Block, Program
from cncsub.references import references_of

MOST_NUMBERS = 2_000  # numbered blocks of a program; of more only those that something names
MOST_FOUND = 500  # symbols of a workspace that are listed


def document_symbols(snap: Snapshot, path: str) -> list[DocumentSymbol]:
    """Return the programs of a file, each with what stands in it."""
    programs = snap.programs_of(path)
    ends = [program.line - 1 for program in programs[1:]] + [len(snap.document(path).lines)]
    return [_program(snap, path, each, end) for each, end in zip(programs, ends)]


def _program(snap: Snapshot, path: str, program: Program, end: int) -> DocumentSymbol:
    document = snap.document(path)
    first = program.line - 1
    last = max(first, end - 1)
    head = document.whole_line(first)
    whole = Range(head.start, document.whole_line(last).end)
    inner = [*_headings(snap, path, program, last), *_words(snap, path, program)]
    inner.sort(key=lambda symbol: (symbol.range.start.line, symbol.range.start.character))
    return DocumentSymbol(
        program.name or "program",
        SymbolKind.Module,
        whole,
        head,
        detail=program.comment or None,
        children=inner,
    )


def _words(snap: Snapshot, path: str, program: Program) -> Iterator[DocumentSymbol]:
    few = _named(program) if len(program.blocks) > MOST_NUMBERS else None
    for block in program.blocks:
        place = place_of(block)
        numbered = block.n is not None or few is None or place in few
        if numbered and (few is None or place in few) and (label := label_of(block)) is not None:
            yield _symbol(snap, path, block, label.column, label.text, SymbolKind.Key)
        if "T" in block.text.upper():
            for token in block.tokens:
                if token.word is not None and token.word.address == "T":
                    yield _symbol(snap, path, block, token.column, token.text, SymbolKind.Object)


def _named(program: Program) -> set[int]:
    """Return the places of the blocks that jumps lead to."""
    found = set()
    for place in range(len(program.blocks)):
        found |= {jump.block for jump in references_of(program.data, place).jumps}
    return {place for place in found if place is not None}


def _symbol(
    snap: Snapshot, path: str, block: Block, column: int, text: str, kind: SymbolKind
) -> DocumentSymbol:
    at = snap.range(path, block.line, column, len(text))
    detail = block.text.strip()
    return DocumentSymbol(text.rstrip(": "), kind, at, at, detail=detail[:80])


def _headings(snap: Snapshot, path: str, program: Program, last: int) -> Iterator[DocumentSymbol]:
    """Yield the comments that stand alone on a line, each the head of what follows."""
    document = snap.document(path)
    with_blocks = {block.line for block in program.blocks}
    for line in range(program.line, last + 1):
        text = document.line(line)
        if line + 1 in with_blocks or not text.strip():
            continue
        if not (comment := comment_alone(snap, text)):
            continue
        at = document.whole_line(line)
        yield DocumentSymbol(comment, SymbolKind.String, at, at)


def comment_alone(snap: Snapshot, text: str) -> str:
    """Return the words of a comment that is all of a line; nothing where it is not."""
    kinds = [(row[0], row[1]) for row in _core.tokens(snap.control, text)]
    comments = [part for kind, part in kinds if kind == "comment"]
    if len(comments) != 1 or any(kind == "word" for kind, _ in kinds):
        return ""
    return comments[0].strip().strip("();").strip()


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
    programs = snap.programs_of(path)
    ends = [program.line - 1 for program in programs[1:]] + [len(document.lines)]
    found: dict[tuple[int, int], FoldingRange] = {}
    for program, end in zip(programs, ends):
        last = end - 1
        while last >= program.line and not document.line(last).strip():
            last -= 1
        regions = [(program.line - 1, last), *_loops(snap, program), *_tools(program, last)]
        for first, to in regions:
            if to > first:
                found[first, to] = FoldingRange(first, to, kind=FoldingRangeKind.Region)
    return [found[key] for key in sorted(found)]


def _loops(snap: Snapshot, program: Program) -> Iterator[tuple[int, int]]:
    """Yield the lines, from 0, of what jumps back: a loop ends with the block that does."""
    edges, *_ = _core.flow(snap.flows, program.data)
    size = len(program.blocks)
    for block, to, kind in edges:
        if kind == "jump" and block is not None and to is not None and to < block < size:
            yield program.blocks[to].line - 1, program.blocks[block].line - 1


def _tools(program: Program, last: int) -> Iterator[tuple[int, int]]:
    begin = None
    for block in program.blocks:
        if "T" in block.text.upper() and any(word.address == "T" for word in block.words):
            if begin is not None:
                yield begin, block.line - 2
            begin = block.line - 1
    if begin is not None:
        yield begin, last
