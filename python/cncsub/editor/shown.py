"""What an editor shows beside and over the text: colours by meaning, hints, lenses."""

from __future__ import annotations

from collections.abc import Iterator

from lsprotocol.types import (
    CodeLens,
    Command,
    InlayHint,
    InlayHintKind,
    SemanticTokens,
    SemanticTokensLegend,
)

from cncsub import _core
from cncsub.editor.explaining import listed, told_call
from cncsub.editor.last_run import LastRun
from cncsub.editor.snapshot import Snapshot, place_of
from cncsub.number_text import length_text
from cncsub.program import Block, Program, Token

TYPES = ["keyword", "function", "variable", "number", "comment", "label", "macro"]
MODIFIERS = ["modification"]
LEGEND = SemanticTokensLegend(TYPES, MODIFIERS)
MOST_HINTS = 400  # of one request

Coloured = tuple[int, int, int, str, int]  # line, character (both from 0), width, type, modifiers


# ---- colours ----


def semantic_tokens(
    snap: Snapshot, path: str, first: int = 0, last: int | None = None
) -> SemanticTokens | None:
    """Return the words of some lines by what they are; `None` for all of a document that is too
    long to be told at once: its client asks for the lines that it shows.
    """
    document = snap.document(path)
    if last is None:
        if snap.is_long(path):
            return None
        last = len(document.lines)
    data: list[int] = []
    line = begin = 0
    for at, column, width, kind, modifiers in coloured(snap, path, first, last):
        place = document.range(at, column, width)
        start = place.start.character
        data += [
            at - line,
            start - (begin if at == line else 0),
            place.end.character - start,
            TYPES.index(kind),
            modifiers,
        ]
        line, begin = at, start
    return SemanticTokens(data)


def coloured(snap: Snapshot, path: str, first: int, last: int) -> Iterator[Coloured]:
    """Yield the words and comments of the blocks of some lines, in their order."""
    for block in snap.blocks_between(path, first, last):
        calls, _, _, writes = _core.references(block.program.data, place_of(block))
        called, written = {row[10] for row in calls}, {row[4] for row in writes}
        for token in block.tokens:
            kind = _kind(token, called)
            if kind is not None and "\n" not in token.text:
                modifiers = int(token.column in written)
                width = len(token.text.rstrip())
                yield block.line - 1, token.column - 1, width, kind, modifiers


def _kind(token: Token, calls: set[int]) -> str | None:
    if token.kind == "comment":
        return "comment"
    word = token.word
    if word is None:
        return None
    if token.column in calls:
        return "function"
    if word.address == "N" or (not word.address and token.text.rstrip().endswith(":")):
        return "label"
    if word.address in ("G", "M"):
        return "keyword"
    if word.address in ("#", "") and word.value is None:
        return "variable" if word.address == "#" else "macro"
    return "number"


# ---- hints ----


def inlay_hints(snap: Snapshot, path: str, first: int, last: int) -> list[InlayHint]:
    """Return, for some lines, calls that are packed into a number, the values that computed words
    took in the last run, and where the tool was after a block.
    """
    run = snap.last_run(path)
    found: list[InlayHint] = []
    for block in snap.blocks_between(path, first, last):
        found += _of_block(snap, path, block, run)
        if len(found) > MOST_HINTS:
            break
    if run is not None:
        found += _positions(snap, path, run, first, last)
    return found


def _of_block(snap: Snapshot, path: str, block: Block, run: LastRun | None) -> Iterator[InlayHint]:
    calls = block.calls
    if len(calls) == 1 and (told := told_call(calls[0].program, calls[0].repeats)):
        yield _hint(snap, path, block.line, _end_of_call(block, calls[0].column), f" = {told}")
    if run is None:
        return
    values = run.words.get((block.program.index, place_of(block)), {})
    for token in block.tokens if values else ():
        if (took := values.get(token.column)) is not None:
            end = token.column + len(token.text.rstrip())
            yield _hint(snap, path, block.line, end, f" = {listed(took)}")


def _end_of_call(block: Block, column: int) -> int:
    """Return the column after the word that names the program: the next after the code."""
    words = [token for token in block.tokens if token.word is not None and token.column >= column]
    last = words[min(1, len(words) - 1)] if words else None
    return column if last is None else last.column + len(last.text.rstrip())


def _hint(snap: Snapshot, path: str, line: int, column: int, text: str) -> InlayHint:
    at = snap.range(path, line, column, 0).start
    return InlayHint(at, text, kind=InlayHintKind.Type)


def _positions(
    snap: Snapshot, path: str, run: LastRun, first: int, last: int
) -> Iterator[InlayHint]:
    document = snap.document(path)
    lines = range(first + 1, min(last, first + MOST_HINTS) + 2)
    for program in snap.programs_of(path):
        for line, at in run.position_after(program.name, lines).items():
            told = " ".join(f"{axis.upper()}{length_text(value)}" for axis, value in at.items())
            end = document.whole_line(line - 1).end
            yield InlayHint(end, f"-> {told}", padding_left=True)


# ---- lenses ----


def code_lenses(snap: Snapshot, path: str, *, debugs: bool) -> list[CodeLens]:
    """Return what can be done with each program of a file that nothing calls, and its time."""
    called = {row[2] for _, _, row in snap.calls}
    found = []
    for place, program in enumerate(snap.programs_of(path)):
        if place and program.index in called:
            continue
        found += list(_lenses(snap, path, program, place, debugs))
    return found


def _lenses(
    snap: Snapshot, path: str, program: Program, place: int, debugs: bool
) -> Iterator[CodeLens]:
    at = snap.document(path).whole_line(program.line - 1)
    arguments = [path, program.name]
    yield CodeLens(at, Command("Run", "cncsub.run", arguments=arguments))
    if debugs:
        yield CodeLens(at, Command("Debug", "cncsub.debugProgram", arguments=arguments))
    yield CodeLens(at, Command("Plot", "cncsub.plot", arguments=arguments))
    run = snap.last_run(path) if place == 0 else None
    if run is not None and len(run.run.moves):
        yield CodeLens(at, Command(run.took, "cncsub.run", arguments=arguments))
