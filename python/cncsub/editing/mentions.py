"""The mentions of blocks, programs and variables: each piece of text that names one of them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from cncsub import _core
from cncsub.library import Library


class Mention(NamedTuple):
    """A piece of text that names a block, a program or a variable.

    `kind`: `"number"` (of a block), `"label"`, `"program"` or `"variable"`. `defines`: it gives the
    thing its name. `computed`: what it names is known only when its block runs. `in_caller`: it
    names a block of the program that called (M99 P). `fixed`: nothing else can be written in its
    place, as where a letter stands for a variable or a file's name for a program. `program`,
    `block`: where it stands, as places in the code and among the blocks of the program; `block` is
    `None` for the head of a program. `file`, `line`, `column`, `text`: the digits or the name
    alone, in the file. `number`: of a block, of a numbered variable or program, else `None`.
    `name`: of the others. `to_program`, `to_block`: the program and the block that it names; `None`
    where there is none, where it is computed, and for a variable that all programs share. `word`,
    `word_column`: of a block's own number, its word with the blanks after it; empty where the block
    has no other. `called`: of a numbered variable, as programs of the control write it: `R5`.
    """

    kind: str
    defines: bool
    computed: bool
    in_caller: bool
    fixed: bool
    program: int
    block: int | None
    file: str
    line: int
    column: int
    text: str
    number: int | None
    name: str
    to_program: int | None
    to_block: int | None
    word: str
    word_column: int
    called: str = ""

    @property
    def end(self) -> int:
        """The column after its last character."""
        return self.column + len(self.text)

    @property
    def shown(self) -> str:
        """The thing as it is called: `N10`, `O2`, `#100`, `R5`, `AGAIN`; of one that is computed,
        its text.
        """
        if self.computed or self.number is None:
            return self.text if self.computed else self.name
        return self.called or f"{_BEFORE[self.kind]}{self.number}"


_BEFORE = {"number": "N", "label": "", "program": "O", "variable": "#"}


def mentions(
    library: Library,
    kinds: str = "block program variable",
    *,
    machine: str = "",
) -> list[Mention]:
    """Return the mentions of all programs, by their files and places.

    `kinds`: which: `"block"` (numbers and labels), `"program"`, `"variable"`; and `"unnumbered"`,
    the beginning of each block without a number, as a mention that defines none. `machine`: the
    kind of machine, as in `Setup`, which tells what some codes mean.

    >>> import cncsub
    >>> from cncsub.editing import mentions
    >>> library = cncsub.loads("O1\\nN10 GOTO 20\\nN20 M30\\n", control="fanuc-0i-f")
    >>> [(m.kind, m.shown, m.defines, m.line, m.column) for m in mentions(library, "block")]
    [('number', 'N10', True, 2, 2), ('number', 'N20', False, 2, 10), ('number', 'N20', True, 3, 2)]
    """
    return _made(library.code, _core.mentions(library.code, machine, kinds))


def mentions_in_line(library: Library, file: str, line: int, *, machine: str = "") -> list[Mention]:
    """Return the mentions that stand in a line of a file, as `mentions` does of all."""
    rows = _core.mentions(library.code, machine, _ALL, (file, line, line))
    return [mention for mention in _made(library.code, rows) if mention.line == line]


def mentions_of(
    library: Library,
    kind: str,
    program: int | None,
    block: int | None = None,
    variable: int | str = "",
    *,
    lines: tuple[str, int, int] | None = None,
    machine: str = "",
) -> list[Mention]:
    """Return the mentions of one thing, as `mentions` does of all, but for those that are computed.

    `kind`: `"block"`, `"program"` or `"variable"`. `program`: the place of its program, `None` for
    a variable of all; `block`: its place there; `variable`: its number, or its name in capitals.
    `lines`: only those in a file from one line to another, both included.
    """
    number, name = (variable, "") if isinstance(variable, int) else (-1, variable)
    asked = (-1 if program is None else program, block, number, name)
    return _made(library.code, _core.mentions(library.code, machine, kind, lines, asked))


_ALL = "block program variable"


def _made(code: _core.Code, rows: Iterable[_core._MentionRow]) -> list[Mention]:
    files = [code.program(index).file for index in range(len(code))]
    called: dict[int, str] = {}

    def called_of(kind: str, number: int) -> str:
        if kind != "variable" or number < 0:
            return ""
        if number not in called:
            called[number] = _core.variable_name(code.control, number)
        return called[number]

    return [
        Mention(
            kind,
            defines,
            computed,
            in_caller,
            fixed,
            program,
            block,
            files[program],
            line,
            column,
            text,
            number if number >= 0 else None,
            name,
            to_program if to_program >= 0 else None,
            to_block,
            word,
            column - before,
            called_of(kind, number),
        )
        for (
            kind,
            defines,
            computed,
            in_caller,
            fixed,
            program,
            block,
            line,
            column,
            text,
            number,
            name,
            to_program,
            to_block,
            word,
            before,
        ) in rows
    ]


def mention_at(
    library: Library, file: str, line: int, column: int, *, machine: str = ""
) -> Mention | None:
    """Return the mention that stands at a place of a file, or ends there; `None` where none does.

    >>> import cncsub
    >>> from cncsub.editing import mention_at
    >>> library = cncsub.loads("O1\\nN10 GOTO 20\\nN20 M30\\n", control="fanuc-0i-f")
    >>> mention_at(library, "<text>", 2, 11).shown
    'N20'
    """
    return mention_among(mentions_in_line(library, file, line, machine=machine), line, column)


def mention_among(every: Iterable[Mention], line: int, column: int) -> Mention | None:
    """Return, of the mentions of a file, the one at a place as `mention_at` does."""
    found = [
        mention
        for mention in every
        if mention.line == line
        and min(mention.column, mention.word_column) <= column <= mention.end
    ]
    return min(found, key=lambda mention: (column == mention.end, mention.computed), default=None)


def thing(of: Mention) -> tuple[object, ...]:
    """Return what a mention names, as it is told apart from others."""
    if of.kind == "number":
        return (of.kind, of.to_program, of.to_block if of.to_block is not None else f"N{of.number}")
    if of.kind == "label":
        return (of.kind, of.to_program, of.name.upper())
    if of.kind == "program":
        missing = of.number if of.number is not None else of.name.upper()
        return (of.kind, of.to_program if of.to_program is not None else f"missing {missing}")
    called = of.number if of.number is not None else of.name.upper()
    return (of.kind, of.to_program, called)
