"""The arguments of a macro: the letters that a call may give, what the macro does with each."""

from __future__ import annotations

import functools
from typing import NamedTuple

from cncsub import _core
from cncsub._core import Control
from cncsub.editor.snapshot import Snapshot, comment_words
from cncsub.program import Program, Token
from cncsub.reports.code_facts import code_explanations


class Argument(NamedTuple):
    """An argument that a macro reads: the letter of a call, its variable, the words about it."""

    letter: str
    variable: int
    told: str


@functools.lru_cache(maxsize=64)
def letters_of(control: Control, code: str) -> dict[str, int]:
    """Return the local variable of each letter that a code hands to a macro."""
    for fact in code_explanations(code, [control]):
        arguments = fact["on"][0]["arguments"]
        if arguments:
            return {letter: int(local.lstrip("#")) for letter, local in arguments.items()}
    return {}


def macro_code(snap: Snapshot, program: Program) -> str | None:
    """Return the code by which a program is called as a macro, where it is."""
    for _, _, row in snap.calls:
        if row[2] == program.index and letters_of(snap.control, row[0]):
            return row[0]
    return None


def arguments_of(snap: Snapshot, program: Program, code: str | None = None) -> list[Argument]:
    """Return the arguments that a macro reads before it writes them, in the order of its blocks,
    each with the comment that stands beside the first use.
    """
    code = code or macro_code(snap, program)
    letters = {} if code is None else letters_of(snap.control, code)
    of_variable = {local: letter for letter, local in letters.items()}
    found: dict[int, Argument] = {}
    written: set[int | None] = set()
    for place in range(program.data.blocks if letters else 0):
        _, _, reads, writes = _core.references(program.data, place)
        for number, _, computed, _, _ in reads:
            if number in of_variable and not computed and number not in written:
                shown = _core.variable_name(snap.control, number)
                told = f"{shown} {_comment(program.data, place)}".rstrip()
                found.setdefault(number, Argument(of_variable[number], number, told))
        written |= {row[0] for row in writes if not row[2]}
    return list(found.values())


def _comment(data: _core.ProgramData, place: int) -> str:
    comments = [row[1] for row in data.tokens(place) if row[0] == "comment"]
    return comment_words(comments[0]) if comments else ""


def macro_call_at(snap: Snapshot, tokens: list[Token]) -> str | None:
    """Return the code of a block that hands arguments to a macro, from its words."""
    for token in tokens:
        if token.word is not None and letters_of(snap.control, token.word.text.upper()):
            return token.word.text.upper()
    return None
