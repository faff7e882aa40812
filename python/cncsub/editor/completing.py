"""What can be written at a place: codes, variables, targets of jumps, programs, arguments."""

from __future__ import annotations

import functools
from collections.abc import Iterator
from typing import Any

from lsprotocol.types import (
    CompletionItem,
    CompletionItemKind,
    ParameterInformation,
    SignatureHelp,
    SignatureInformation,
)

from cncsub import _core
from cncsub._core import Control
from cncsub.editor.arguments import arguments_of, macro_call_at
from cncsub.editor.names import label_of
from cncsub.editor.snapshot import Snapshot
from cncsub.files import clean
from cncsub.program import Program, Token, find_program, tokens_of

MOST_ITEMS = 500
LARGEST_M_CODE = 200
_PASSED_OVER = "passed-over"


def completions(snap: Snapshot, path: str, line: int, character: int) -> list[CompletionItem]:
    """Return what may be written at a place, by the words that stand before it on its line."""
    before = snap.document(path).line(line)[:character]
    tokens = [token for token in _tokens(snap, before) if token.kind != "blank"]
    if tokens and tokens[-1].kind == "comment" and tokens[-1].end > len(before):
        return []
    at_word = bool(before) and not before[-1].isspace() and bool(tokens)
    last = tokens[-1] if at_word else None
    program = snap.program_at(path, line)
    found = list(_items(snap, program, tokens, last, before))
    return found[:MOST_ITEMS]


def _tokens(snap: Snapshot, text: str) -> list[Token]:
    return tokens_of(_core.tokens(snap.control, clean(text)), 1)


def _items(
    snap: Snapshot, program: Program | None, tokens: list[Token], last: Token | None, before: str
) -> Iterator[CompletionItem]:
    typed = "" if last is None else last.text.upper()
    roles = _roles_of(snap.control, tokens[:-1] if last is not None else tokens)
    address = last.word.address if last is not None and last.word is not None else ""
    if address and address in roles:
        role = roles[address]
        if "program" in role:
            yield from _programs(snap, address)
            return
        if "block" in role and program is not None:
            yield from _targets(program, address)
            return
    if _jumps(snap.control, typed):
        if program is not None:
            yield from _targets(program, "")
        return
    if before.rstrip()[-1:] == "#" or typed.startswith("#"):
        yield from _variables(snap, program)
        return
    if program is not None:
        yield from _arguments(snap, tokens)
    yield from codes_of(snap.control)
    yield from _words(snap.control)
    yield from _called_by_name(snap)


def _roles_of(control: Control, tokens: list[Token]) -> dict[str, str]:
    """Return what the letters of a block mean to its codes: `{"P": "the program"}`."""
    roles: dict[str, str] = {}
    for token in tokens:
        facts = None if token.word is None else _facts(control, token.word.text.upper())
        for letters, says, _ in facts["words"] if facts is not None else ():
            roles.update((letter, says) for letter in letters.split() if len(letter) == 1)
    return roles


@functools.lru_cache(maxsize=512)
def _facts(control: Control, word: str) -> dict[str, Any] | None:
    return _core.code_facts(control, word)


def _jumps(control: Control, typed: str) -> bool:
    """Return whether a statement that was begun goes on with the block that it jumps to."""
    for name, _, does in _core.keywords(control):
        if does.startswith("goes to") and typed.rstrip("0123456789").endswith(name.upper()):
            return True
    return False


# ---- the items ----


@functools.lru_cache(maxsize=8)
def codes_of(control: Control) -> tuple[CompletionItem, ...]:
    """Return the G and M codes that a control has, each with what it does there."""
    names = [name for name, what in _core.g_codes(control) if what not in ("None", "Unknown")]
    found = []
    for name in [*names, *(f"M{number:02d}" for number in range(LARGEST_M_CODE))]:
        facts = _core.code_facts(control, name)
        if facts is None or (name[0] == "M" and facts["treatment"] == _PASSED_OVER):
            continue
        found.append(
            CompletionItem(
                name, kind=CompletionItemKind.Keyword, detail=facts["does"].replace("`", "")
            )
        )
    return tuple(found)


@functools.lru_cache(maxsize=8)
def _words(control: Control) -> tuple[CompletionItem, ...]:
    return tuple(
        CompletionItem(name, kind=CompletionItemKind.Keyword, detail=does)
        for name, treatment, does in _core.keywords(control)
        if treatment not in ("not-known", "refused")
    )


def _programs(snap: Snapshot, address: str) -> Iterator[CompletionItem]:
    for name, place in zip(snap.code.names(), snap.code.places(), strict=True):
        digits = name.lstrip("Oo").lstrip("0")
        if digits.isdecimal():
            program = snap.program(place)
            written = f"{address}{digits}"
            detail = f"{name} {program.comment}".strip()
            yield CompletionItem(written, kind=CompletionItemKind.Function, detail=detail)


def _called_by_name(snap: Snapshot) -> Iterator[CompletionItem]:
    """Yield the programs whose names are words of the language: they are called by them."""
    for name, place in zip(snap.code.names(), snap.code.places(), strict=True):
        if not name.lstrip("Oo:%").isdecimal() and not snap.code.program(place).system:
            kind = CompletionItemKind.Function
            yield CompletionItem(name, kind=kind, detail=snap.program(place).comment or None)


def _targets(program: Program, address: str) -> Iterator[CompletionItem]:
    for place in range(min(len(program.blocks), MOST_ITEMS * 20)):
        if program.data.block(place)[0] is None and not _may_be_label(program, place):
            continue
        block = program.blocks[place]
        label = label_of(block)
        if label is None:
            continue
        name = f"{block.n}" if block.n is not None else label.text.rstrip(": ")
        detail = block.text.strip()[:80]
        yield CompletionItem(f"{address}{name}", kind=CompletionItemKind.Reference, detail=detail)


def _may_be_label(program: Program, place: int) -> bool:
    return ":" in program.data.block(place)[2]


def _variables(snap: Snapshot, program: Program | None) -> Iterator[CompletionItem]:
    """Yield the variables that the program uses, then the system variables and options that the
    control lists.
    """
    seen: set[int | str] = set()
    for place in range(0 if program is None else program.data.blocks):
        assert program is not None
        _, _, reads, writes = _core.references(program.data, place)
        for number, name, computed, _, _ in (*writes, *reads):
            key = name if name is not None else number
            if computed or key is None or key in seen:
                continue
            seen.add(key)
            detail = program.blocks[place].text.strip()[:80]
            shown = _core.variable_name(snap.control, key) if isinstance(key, int) else key
            yield CompletionItem(shown, kind=CompletionItemKind.Variable, detail=detail)
    for option in snap.control.variable_options.values():
        first = option.numbers.replace("-", " ").split()[:1]
        if first and first[0].isdecimal() and int(first[0]) not in seen:
            seen.add(int(first[0]))
            yield CompletionItem(
                _core.variable_name(snap.control, int(first[0])),
                kind=CompletionItemKind.Constant,
                detail=f"{option.meaning} ({option.numbers})",
            )


def _arguments(snap: Snapshot, tokens: list[Token]) -> Iterator[CompletionItem]:
    """Yield the arguments of the macro that the block calls, those that it does not give yet."""
    called = _called(snap, tokens)
    if called is None:
        return
    program, code = called
    given = {token.word.address for token in tokens if token.word is not None}
    for argument in arguments_of(snap, program, code):
        if argument.letter not in given:
            kind = CompletionItemKind.Field
            yield CompletionItem(
                argument.letter, kind=kind, detail=argument.told, sort_text=f" {argument.letter}"
            )


def _called(snap: Snapshot, tokens: list[Token]) -> tuple[Program, str] | None:
    """Return the macro that a block calls, and the code that does."""
    code = macro_call_at(snap, tokens)
    if code is None:
        return None
    role = {letter for letter, says in _roles_of(snap.control, tokens).items() if "program" in says}
    for token in tokens:
        word = token.word
        if word is not None and word.address in role and word.value is not None:
            place = find_program(snap.code, int(word.value))
            if place >= 0:
                return snap.program(place), code
    return None


# ---- signatures ----


def signature(snap: Snapshot, path: str, line: int, character: int) -> SignatureHelp | None:
    """Return the arguments of the macro that a line calls, the one that is being written active."""
    text = snap.document(path).line(line)
    tokens = _tokens(snap, text)
    called = _called(snap, tokens)
    if called is None:
        return None
    program, code = called
    arguments = arguments_of(snap, program, code) or None
    if arguments is None:
        return None
    labels = [f"{each.letter}={each.told}" for each in arguments]
    title = f" ({program.comment})" if program.comment else ""
    begun = [t.word.address for t in tokens if t.word is not None and t.column <= character]
    letters = [each.letter for each in arguments]
    active = letters.index(begun[-1]) if begun and begun[-1] in letters else None
    return SignatureHelp(
        [
            SignatureInformation(
                f"{code} {program.name}{title}: {', '.join(labels)}",
                parameters=[ParameterInformation(label) for label in labels],
            )
        ],
        active_signature=0,
        active_parameter=active,
    )
