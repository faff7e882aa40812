"""What a word of a block names: a program, a block or a variable; and every mention of it."""

from __future__ import annotations

from typing import NamedTuple

from lsprotocol.types import Location

from cncsub import _core
from cncsub.editing import Mention
from cncsub.editing.mentions import mention_among, mentions_in_line, mentions_of
from cncsub.editor.snapshot import Snapshot, place_of, token_at
from cncsub.program import Block, Token


class Name(NamedTuple):
    """A program (`key`: its place in the memory), a block of a program (`key`: its place there), or
    a variable (`key`: its number or its name in capitals). `program`: of a block, and of a variable
    that only one program has.
    """

    kind: str
    key: int | str
    program: int | None = None


class At(NamedTuple):
    """A piece of text that names something: line and column of the engine, from 1."""

    file: str
    line: int
    column: int
    width: int


def name_of(mention: Mention) -> Name | None:
    """Return what a mention names; `None` where that is computed, or is not there."""
    if mention.computed:
        return None
    if mention.kind == "variable":
        key = mention.name.upper() if mention.number is None else mention.number
        return Name("variable", key, mention.to_program)
    if mention.to_program is None:
        return None
    if mention.kind == "program":
        return Name("program", mention.to_program)
    if mention.to_block is None:
        return None
    return Name("block", mention.to_block, mention.to_program)


def at_of(mention: Mention) -> At:
    """Return where a mention stands."""
    return At(mention.file, mention.line, mention.column, len(mention.text))


def mention_at(snap: Snapshot, path: str, line: int, character: int) -> Mention | None:
    """Return the mention at a place, both from 0, or the one that ends there; else the one after
    the letter or the sign at the place. A program that its file names is where no word stands.
    """
    every = mentions_in_line(snap.library, path, line + 1, machine=snap.machine)
    block = snap.block_at(path, line, character)
    token = None if block is None else token_at(block, character)
    if token is None or token.kind != "word":
        return mention_among(every, line + 1, character + 1)
    every = [mention for mention in every if mention.text and not _is_of_control(snap, mention)]
    column = character + 1
    found = mention_among(every, line + 1, column)
    while found is None and column + 1 < token.end:
        column += 1
        found = mention_among(every, line + 1, column)
        if token.text[column - token.column] not in _SIGNS:
            break
    return found


_SIGNS = "#<$"  # before the name of a variable


def _is_of_control(snap: Snapshot, mention: Mention) -> bool:
    """Return whether a mention names a variable of a program of the control itself."""
    if mention.kind != "variable" or mention.to_program is None:
        return False
    return snap.code.program(mention.to_program).system


def name_at(snap: Snapshot, path: str, line: int, character: int) -> tuple[Name, At] | None:
    """Return what stands at a place, and the piece of text that names it: a mention, else the block
    to which the word jumps, or the program that the block calls.
    """
    block = snap.block_at(path, line, character)
    token = None if block is None else token_at(block, character)
    if block is None or token is None:
        return _mentioned(snap, path, line, character) or _head_at(snap, path, line)
    if token.kind != "word":
        return None
    if (label := label_of(block)) is not None and label.column == token.column:
        name = Name("block", place_of(block), block.program.index)
        return name, At(path, block.line, token.column, len(token.text.rstrip()))
    if not any(_core.references(block.program.data, place_of(block))):
        return None
    return _mentioned(snap, path, line, character) or _led_to(block, token)


def _mentioned(snap: Snapshot, path: str, line: int, character: int) -> tuple[Name, At] | None:
    mention = mention_at(snap, path, line, character)
    name = None if mention is None else name_of(mention)
    return None if mention is None or name is None else (name, at_of(mention))


def _head_at(snap: Snapshot, path: str, line: int) -> tuple[Name, At] | None:
    program = snap.program_at(path, line)
    if program is None or program.line != line + 1 or not program.data.has_head:
        return None
    width = len(snap.document(path).line(line))
    return Name("program", program.index), At(path, line + 1, 1, width)


def _led_to(block: Block, token: Token) -> tuple[Name, At] | None:
    calls, jumps, _, _ = _core.references(block.program.data, place_of(block))
    here = At(block.program.file, block.line, token.column, len(token.text.rstrip()))
    for jump in jumps:
        if token.column <= jump[7] < token.end and jump[4] is not None:
            return Name("block", jump[4], block.program.index), here
    before = [call for call in calls if call[10] <= token.column] or list(calls[:1])
    if not before or before[-1][2] is None:
        return None
    return Name("program", before[-1][2]), here


def mentions(
    snap: Snapshot, name: Name, lines: tuple[str, int, int] | None = None
) -> list[Mention]:
    """Return every piece of text that names the same, or those in some lines of a file, from 1."""
    variable: int | str = ""
    block = None
    program = name.program
    if name.kind == "variable":
        variable = name.key
    elif name.kind == "program":
        program = int(name.key)
    else:
        block = int(name.key)
    return mentions_of(
        snap.library, name.kind, program, block, variable, lines=lines, machine=snap.machine
    )


def writes(snap: Snapshot, mention: Mention) -> bool:
    """Return whether a mention of a variable is where a block writes it."""
    if mention.block is None:
        return False
    data = snap.code.program(mention.program)
    return any(
        column <= mention.column < column + len(text)
        for _, _, _, text, column in _core.references(data, mention.block)[3]
    )


def label_of(block: Block) -> Token | None:
    """Return the word that names a block: N and its number, or a label before all other words."""
    words = [token for token in block.tokens if token.word is not None]
    numbered = next((t for t in words if t.word is not None and t.word.address in _NUMBERED), None)
    if block.n is not None and numbered is not None:
        return numbered
    first = next((t for t in words if t.word is not None and t.word.address != "/"), None)
    return first if first is not None and first.text.rstrip().endswith(":") else None


_NUMBERED = ("N", ":")  # :10 is a main block of the SINUMERIK


def block_of(snap: Snapshot, name: Name) -> Block:
    """Return the block that a name leads to."""
    assert isinstance(name.key, int)
    assert name.program is not None
    return snap.program(name.program).blocks[name.key]


def location(snap: Snapshot, mention: Mention) -> Location:
    """Return a mention as a place of the client."""
    return snap.location(mention.file, mention.line, mention.column, len(mention.text))
