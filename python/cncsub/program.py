"""Programs as they were read: their blocks and words, made when they are looked at."""

from __future__ import annotations

import fnmatch
import operator
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple, overload

from cncsub import _core
from cncsub.controls import did_you_mean
from cncsub.files import clean
from cncsub.pickling import NotPicklable

if TYPE_CHECKING:
    from cncsub._core import Control
    from cncsub.references import CallTo, JumpTo, References, VariableUse


_NEAR = 5000  # names that are compared with an unknown one


def find_program(code: _core.Code, name: object) -> int:
    """Return the place of a program among those of the code, by its number or by any way to write
    its name; -1 where there is none. Raises `TypeError` for anything else.
    """
    if isinstance(name, str):
        found = code.find(clean(name))
        return -1 if found >= 0 and code.program(found).system else found
    if isinstance(name, bool) or not hasattr(name, "__index__"):
        raise TypeError(f"a program must be given by its name or number, not by {name!r}")
    number = operator.index(name)
    return code.find(number) if 0 <= number < 2**63 else -1  # the engine counts to 64 bits


def place_of_program(code: _core.Code, name: object, *, of_control: bool = False) -> int:
    """Return the place of a program as `find_program` does. `of_control`: a cycle that the control
    has as a program of its own, such as CYCLE81, is found too. Raises `KeyError` with the names
    that are near where there is none.
    """
    place = find_program(code, name)
    if place < 0 and of_control and isinstance(name, str):
        place = code.find(clean(name))
    if place >= 0:
        return place
    names = code.names()
    there = f"; there are {', '.join(names[:8])}{', ...' if len(names) > 8 else ''}"
    known = did_you_mean(name, names[:_NEAR], there if names else ", which is empty")
    raise KeyError(f"no program {name} in the memory{known}")


def named_like(code: _core.Code, patterns: Iterable[str]) -> list[int]:
    """Return the places of the programs whose names are among these, or match them (`O90*`).

    A pattern that no program matches gives none: a project names programs of all its folders.
    """
    if isinstance(patterns, str):
        raise TypeError(
            f"entry must be a list of names such as ['O90*'], not the text {patterns!r}"
        )
    found: dict[int, None] = {}
    for pattern in patterns:
        if not isinstance(pattern, str):
            raise TypeError(f"entry must have names such as 'O90*', not {pattern!r}")
        place = find_program(code, pattern)
        if place >= 0:
            found[place] = None
        if not frozenset("*?[").isdisjoint(pattern):
            like = re.compile(fnmatch.translate(pattern.upper()))
            names = zip(code.places(), code.names(), strict=True)
            found.update((place, None) for place, name in names if like.match(name.upper()))
    return list(found)


class Word(NamedTuple):
    """`X10.` is a word: its address, its value (`None` where it is computed or missing) and its
    text.
    """

    address: str
    value: float | None
    text: str


class Token(NamedTuple):
    """A piece of a block: a word, or what stands between two words.

    `kind`: `"word"`, `"comment"`, `"blank"` or `"ignored"`, as what a control skips. `text`:
    as it is written; the texts of all tokens joined are the text of the block. `column`: of its
    first character in its line, from 1. `word`: what the control reads, `None` between the words.
    """

    kind: str
    text: str
    column: int
    word: Word | None

    @property
    def end(self) -> int:
        """The column after its last character."""
        return self.column + len(self.text)


def tokens_of(rows: Iterable[tuple[str, str, str, float | None, str]], column: int) -> list[Token]:
    """The tokens that the engine told of a text that begins in this column."""
    tokens = []
    for kind, text, address, value, read in rows:
        word = Word(address, value, read) if kind == "word" else None
        tokens.append(Token(kind, text, column, word))
        column += len(text)
    return tokens


def words_of(control: Control, text: str) -> list[Word]:
    """The words of a text that is no block of a library, as a control reads them."""
    rows = _core.tokens(control, text)
    return [Word(address, value, read) for kind, _, address, value, read in rows if kind == "word"]


@dataclass(frozen=True, slots=True)
class Block:
    """One block of a program: sequence number, line of the file, text."""

    n: int | None
    line: int
    text: str
    _program: Program = field(repr=False, compare=False)
    _index: int = field(repr=False, compare=False)

    @property
    def program(self) -> Program:
        """The program this block belongs to."""
        return self._program

    @property
    def tokens(self) -> tuple[Token, ...]:
        """The words of the block and what stands between them, in order; a macro statement is one
        word without an address.

        >>> import cncsub
        >>> library = cncsub.loads("O1\\nG1 X10. (to the wall) F100\\nM30\\n", control="fanuc-0i-f")
        >>> block = library["O1"].blocks[0]
        >>> [(token.text, token.column) for token in block.tokens if token.kind == "comment"]
        [('(to the wall)', 9)]
        >>> "".join(token.text for token in block.tokens) == block.text
        True
        """
        data = self._program.data
        return tuple(tokens_of(data.tokens(self._index), data.column(self._index)))

    @property
    def words(self) -> tuple[Word, ...]:
        """The words of the block, as the control reads them: `tokens` without what stands between
        them.
        """
        # Without the columns, for each of which the line is counted through.
        rows = self._program.data.tokens(self._index)
        return tuple(
            Word(address, value, read) for kind, _, address, value, read in rows if kind == "word"
        )

    @property
    def calls(self) -> tuple[CallTo, ...]:
        """The programs that the block calls, as the control reads it. A block that the control
        refuses refers to nothing: this, `jumps`, `reads` and `writes` are empty.

        >>> import cncsub
        >>> library = cncsub.loads("O1\\nN10 M98 P#100 L2\\nM30\\n", control="fanuc-0i-f")
        >>> call = library["O1"].blocks[0].calls[0]
        >>> call.kind, call.program, call.repeats
        ('M98', Computed(expression='#100'), 2)
        """
        return self._references.calls

    @property
    def jumps(self) -> tuple[JumpTo, ...]:
        """The blocks that the block jumps to: GOTO, M99 P, M97. Loops and branches are none."""
        return self._references.jumps

    @property
    def reads(self) -> tuple[VariableUse, ...]:
        """The variables that the block reads, in the order of its values.

        >>> import cncsub
        >>> library = cncsub.loads("O1\\n#100=#1+#[#2]\\nM30\\n", control="fanuc-0i-f")
        >>> [use.variable for use in library["O1"].blocks[0].reads]
        [1, 2, Computed(expression='#1+#[#2]')]
        """
        return self._references.reads

    @property
    def writes(self) -> tuple[VariableUse, ...]:
        """The variables that the block writes."""
        return self._references.writes

    @property
    def _references(self) -> References:
        from cncsub.references import references_of

        return references_of(self._program.data, self._index)


class Blocks(NotPicklable, Sequence[Block]):
    """The blocks of a program, from 0."""

    _instead = "send the library"

    def __init__(self, program: Program) -> None:
        self._program = program

    def __len__(self) -> int:
        return self._program.data.blocks

    @overload
    def __getitem__(self, key: int) -> Block: ...
    @overload
    def __getitem__(self, key: slice) -> list[Block]: ...
    def __getitem__(self, key: int | slice) -> Block | list[Block]:
        if isinstance(key, slice):
            return [self._block(index) for index in range(*key.indices(len(self)))]
        index = operator.index(key)
        if not -len(self) <= index < len(self):
            raise IndexError(f"block {index} of {len(self)} in {self._program.name}")
        return self._block(index % len(self))

    def _block(self, index: int) -> Block:
        return Block(*self._program.data.block(index), self._program, index)

    def __repr__(self) -> str:
        return f"<{len(self)} blocks of {self._program.name}>"


def block_at(code: _core.Code, address: int) -> Block:
    """Return the block at an address of the code."""
    program, index = code.place_of(address)
    return Program(code.program(program), program).blocks[index]


class Program(NotPicklable):
    """One program of a library.

    >>> import cncsub
    >>> program = cncsub.loads("O1 (PART)\\nN10 G1X10.\\nN20 M30\\n", control="fanuc-0i-f").main
    >>> program.name, program.comment, len(program.blocks)
    ('O1', 'PART', 2)
    >>> program.blocks[0].words[-1]
    Word(address='X', value=10.0, text='X10.')
    """

    _instead = "send its library, or its text"

    def __init__(self, data: _core.ProgramData, index: int) -> None:
        self.data = data
        self.index = index

    @property
    def name(self) -> str:
        """The name as it is written, or the name of the file where the program has none of
        its own.
        """
        return self.data.name

    @property
    def file(self) -> str:
        """The file in which the program stands, as it was named."""
        return self.data.file

    @property
    def line(self) -> int:
        """The line of the file on which the program begins, from 1."""
        return self.data.line

    @property
    def text(self) -> str:
        """The text as it is written, with its head and its comments."""
        return self.data.text

    def beginning(self, size: int) -> str:
        """Return the first bytes of the text."""
        return self.data.start(size).decode(errors="replace")

    @property
    def comment(self) -> str:
        """The title: the first comment after the name."""
        return self.data.comment

    @property
    def external(self) -> bool:
        """Whether the program is on the external device."""
        return self.data.external

    @property
    def blocks(self) -> Blocks:
        """The blocks, a sequence from 0; each is made when it is looked at."""
        return Blocks(self)

    def __repr__(self) -> str:
        return f"<Program {self.name}: {len(self.blocks)} blocks, {self.file}:{self.line}>"

    def _repr_html_(self) -> str:
        from cncsub.notebook import program_html

        return program_html(self)
