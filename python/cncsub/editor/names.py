"""What a word of a block names: a program, a block or a variable; and every mention of it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from lsprotocol.types import Location

from cncsub import _core
from cncsub.editor.snapshot import Snapshot, place_of, token_at
from cncsub.program import Block, Token
from cncsub.references import Computed, References, VariableUse, references_of


class Name(NamedTuple):
    """A program (`key`: its place in the memory), a block of a program (`key`: its place there), or
    a variable (`key`: its number or its name). `program`: of a block, and of a variable that only
    one program has.
    """

    kind: str
    key: int | str
    program: int | None = None


class Mention(NamedTuple):
    """A piece of text that names something: line and column of the engine, from 1."""

    file: str
    line: int
    column: int
    width: int
    defines: bool  # or writes


def name_at(snap: Snapshot, path: str, line: int, character: int) -> tuple[Name, Mention] | None:
    """Return what stands at a place, and the piece of text that names it."""
    block = snap.block_at(path, line, character)
    program = snap.program_at(path, line)
    token = None if block is None else token_at(block, character)
    if block is None or token is None:
        if program is not None and program.line == line + 1 and program.data.has_head:
            width = len(snap.document(path).line(line))
            return Name("program", program.index), Mention(path, line + 1, 1, width, True)
        return None
    if token.kind != "word":
        return None
    data, place = block.program.data, place_of(block)
    of = references_of(data, place)
    return (
        _variable_at(snap, block, of, character)
        or _jump_at(block, of, token)
        or _label_at(block, of, token)
        or _call_at(snap, block, token)
    )


def _mention(block: Block, column: int, width: int, *, defines: bool = False) -> Mention:
    return Mention(block.program.file, block.line, column, width, defines)


# ---- variables ----


def _variable_at(
    snap: Snapshot, block: Block, of: References, character: int
) -> tuple[Name, Mention] | None:
    for use, writes in (*((u, True) for u in of.writes), *((u, False) for u in of.reads)):
        for column, width in spans_of(use):
            if column <= character + 1 < column + width and not isinstance(use.variable, Computed):
                return variable(snap, block, use.variable), _mention(
                    block, column, width, defines=writes
                )
    return None


def variable(snap: Snapshot, block: Block, key: int | str) -> Name:
    """Return the name of a variable: of all programs, or of the one of a block."""
    own = isinstance(key, str) or snap.code.is_local(key)
    return Name("variable", key, block.program.index if own else None)


def spans_of(use: VariableUse) -> Iterator[tuple[int, int]]:
    """Yield column and width of each place of a variable in the value that it is a part of; the
    whole value, where the variable is not written there by its number or name.
    """
    spans = [] if isinstance(use.variable, Computed) else list(_written(use.text, use.variable))
    for at, width in spans or [(0, len(use.text))]:
        yield use.column + at, width


def _written(text: str, variable: int | str) -> Iterator[tuple[int, int]]:
    numbered = isinstance(variable, int)
    wanted = str(variable)
    if text.isascii():  # the capitals of other letters may be longer
        text, wanted = text.upper(), wanted.upper()
    at = text.find(wanted)
    while at >= 0:
        end = at + len(wanted)
        begin, after = _begin(text, at, numbered), text[end : end + 1]
        goes_on = after.isdecimal() or after == "." if numbered else after.isalnum() or after == "_"
        if begin is not None and not goes_on:
            yield begin, end - begin
        at = text.find(wanted, at + 1)


def _begin(text: str, at: int, numbered: bool) -> int | None:
    """Return where a variable begins whose number or name stands at a place: at its sign."""
    before = text[at - 1 : at] if at else ""
    if not numbered:
        return None if before.isalnum() or before == "_" else at
    if "#" in text:
        return at - 1 if before == "#" else None
    return at - 1 if before.isalpha() and not text[max(0, at - 2) : at - 1].isalnum() else None


# ---- blocks ----


def _jump_at(block: Block, of: References, token: Token) -> tuple[Name, Mention] | None:
    for jump in of.jumps:
        if token.column <= jump.column < token.end and jump.block is not None:
            name = Name("block", jump.block, block.program.index)
            return name, _mention(block, jump.column, len(jump.text))
    return None


def _label_at(block: Block, of: References, token: Token) -> tuple[Name, Mention] | None:
    """Return the block itself, where the word is its sequence number or its label."""
    label = label_of(block)
    if label is None or label.column != token.column:
        return None
    name = Name("block", place_of(block), block.program.index)
    return name, _mention(block, token.column, len(token.text), defines=True)


def label_of(block: Block) -> Token | None:
    """Return the word that names a block: N and its number, or a label before all other words."""
    words = [token for token in block.tokens if token.word is not None]
    numbered = next((t for t in words if t.word is not None and t.word.address == "N"), None)
    if block.n is not None and numbered is not None:
        return numbered
    first = next((t for t in words if t.word is not None and t.word.address != "/"), None)
    return first if first is not None and first.text.rstrip().endswith(":") else None


def block_of(snap: Snapshot, name: Name) -> Block:
    """Return the block that a name leads to."""
    assert isinstance(name.key, int)
    assert name.program is not None
    return snap.program(name.program).blocks[name.key]


# ---- programs ----


def _call_at(snap: Snapshot, block: Block, token: Token) -> tuple[Name, Mention] | None:
    """Return the called program; any word of a call leads to it but those that name more."""
    row = None
    for found in _core.references(block.program.data, place_of(block))[0]:
        if row is None or found[10] <= token.column:
            row = found
    if row is None or row[2] is None:
        return None
    return Name("program", row[2]), _mention(block, token.column, len(token.text))


# ---- mentions ----


def mentions(snap: Snapshot, name: Name) -> Iterator[Mention]:
    """Yield every piece of text that names the same."""
    if name.kind == "program":
        yield from _of_program(snap, name)
    elif name.kind == "block":
        yield from _of_block(snap, name)
    else:
        yield from _of_variable(snap, name)


def _of_program(snap: Snapshot, name: Name) -> Iterator[Mention]:
    program = snap.program(int(name.key))
    width = len(snap.document(program.file).line(program.line - 1))
    yield Mention(program.file, program.line, 1, width, True)
    for caller, at, row in snap.calls:
        if row[2] == name.key:
            block = snap.program(caller).blocks[at]
            yield _mention(block, row[10], len(row[9]))


def _of_block(snap: Snapshot, name: Name) -> Iterator[Mention]:
    target = block_of(snap, name)
    label = label_of(target)
    if label is not None:
        yield _mention(target, label.column, len(label.text), defines=True)
    assert name.program is not None
    program = snap.program(name.program)
    for place in range(program.data.blocks):
        for _, _, in_caller, _, to, _, text, column in _core.references(program.data, place)[1]:
            if to == name.key and not in_caller:
                yield _mention(program.blocks[place], column, len(text))
    for caller, at, row in snap.calls:
        if row[2] == name.program and row[4] is not None and row[4] == target.n:
            yield _mention(snap.program(caller).blocks[at], row[10], len(row[9]))


def _of_variable(snap: Snapshot, name: Name) -> Iterator[Mention]:
    places = range(len(snap.code)) if name.program is None else [name.program]
    for index in places:
        program = snap.program(index)
        if program.data.system or (program.data.inside and name.program is None):
            continue
        for place in range(program.data.blocks):
            _, _, reads, writes = _core.references(program.data, place)
            if any(name.key in row[:2] for row in (*writes, *reads)):
                yield from _uses_in(program.blocks[place], name)


def _uses_in(block: Block, name: Name) -> Iterator[Mention]:
    of = references_of(block.program.data, place_of(block))
    seen = set()
    for use, writes in (*((u, True) for u in of.writes), *((u, False) for u in of.reads)):
        if use.variable == name.key:
            for span in spans_of(use):
                if span not in seen:
                    seen.add(span)
                    yield _mention(block, *span, defines=writes)


def location(snap: Snapshot, mention: Mention) -> Location:
    """Return a mention as a place of the client."""
    return snap.location(mention.file, mention.line, mention.column, mention.width)
