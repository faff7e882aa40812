"""What can be written at a place: codes, variables, targets of jumps, programs, arguments."""

from __future__ import annotations

import functools
from collections.abc import Iterator
from typing import Any

import attrs
from lsprotocol.types import (
    CompletionItem,
    CompletionItemKind,
    ParameterInformation,
    SignatureHelp,
    SignatureInformation,
    TextEdit,
)

from cncsub import _core
from cncsub._core import Control
from cncsub.editor.arguments import arguments_of, macro_call_at
from cncsub.editor.explaining import keywords_of
from cncsub.editor.names import label_of
from cncsub.editor.snapshot import Snapshot
from cncsub.files import clean
from cncsub.program import Program, Token, find_program, tokens_of

MOST_ITEMS = 500
MOST_DATA_LINES = 500  # between G10 and its G11
LARGEST_M_CODE = 200
_PASSED_OVER = "passed-over"


def completions(snap: Snapshot, path: str, line: int, character: int) -> list[CompletionItem]:
    """Return what may be written at a place, by the words that stand before it on its line. Each
    item says which characters it replaces.
    """
    before = snap.document(path).line(line)[:character]
    tokens = [token for token in _tokens(snap, before) if token.kind != "blank"]
    if tokens and tokens[-1].kind == "comment" and tokens[-1].end > len(before):
        return []
    at_word = bool(before) and not before[-1].isspace() and bool(tokens)
    last = tokens[-1] if at_word else None
    program = snap.program_at(path, line)
    begin = _begin_of(before, last)
    found = _items(snap, path, line, program, tokens, last, before[begin:])
    return _fitting(snap, path, line, found, before, begin)


def _tokens(snap: Snapshot, text: str) -> list[Token]:
    return tokens_of(_core.tokens(snap.control, clean(text)), 1)


def _begin_of(before: str, last: Token | None) -> int:
    """Return where the name begins that is being written: within a statement, which is one word,
    after its last sign.
    """
    at = len(before)
    while at > 0 and (before[at - 1].isalnum() or before[at - 1] in "_."):
        at -= 1
    if last is not None:
        at = max(at, last.column - 1)
    for sign in ("#<", "#", "$", ":"):
        if before[:at].endswith(sign):
            return at - len(sign)
    return at


def _fitting(
    snap: Snapshot, path: str, line: int, found: Iterator[CompletionItem], before: str, begin: int
) -> list[CompletionItem]:
    """Return the items that go on with what was begun, each with the edit that it is."""
    fitting = []
    for item in found:
        start = begin
        if item.label[:1].isdigit():  # after the letters of a word, as in GOTO10
            start = max(begin, len(before.rstrip("0123456789")))
        if not item.label.upper().startswith(before[start:].upper()):
            continue
        place = snap.range(path, line + 1, start + 1, len(before) - start)
        fitting.append(attrs.evolve(item, text_edit=TextEdit(place, item.label)))
        if len(fitting) == MOST_ITEMS:
            break
    return fitting


def _items(
    snap: Snapshot,
    path: str,
    line: int,
    program: Program | None,
    tokens: list[Token],
    last: Token | None,
    begun: str,
) -> Iterator[CompletionItem]:
    typed = tokens[-1].text.upper() if tokens and tokens[-1].kind == "word" else ""
    roles = _roles_of(snap, tokens[:-1] if last is not None else tokens)
    address = last.word.address if last is not None and last.word is not None else ""
    if address == "N" and data_code_before(snap, path, line):
        yield from _parameters(snap.control, address)
        return
    if address and address in roles:
        role = roles[address]
        if "program" in role:
            yield from _programs(snap, address)
            return
        if "block" in role and program is not None:
            yield from _targets(program, address)
            return
    if _jumps(snap.control, typed, begun=last is not None):
        if program is not None:
            yield from _targets(program, "")
        return
    sign = snap.code.variable_sign.upper()
    if begun.startswith(("#", "$")) or (sign.isalpha() and begun[:1].upper() == sign):
        yield from _variables(snap, program, begun)
        yield from _named_variables(program)
        if begun.startswith("#"):
            return
    elif program is not None:
        yield from _arguments(snap, tokens)
    yield from codes_of(snap.control, snap.kind)
    yield from _words(snap.control)
    yield from _called_by_name(snap)
    if not begun.startswith("$") and snap.code.variable_sign != "#":
        yield from _named_variables(program)


def data_code_before(snap: Snapshot, path: str, line: int) -> bool:
    """Return whether a line stands between the block that begins to set parameters, as G10 L52, and
    the one that ends it, as G11.
    """
    for above in range(line, max(-1, line - MOST_DATA_LINES), -1):
        words = [t.word for t in _tokens(snap, snap.document(path).line(above)) if t.word]
        codes = {word.text.upper() for word in words}
        if "G11" in codes:
            return False
        if "G10" in codes:
            return bool(codes & {"L50", "L52"})
    return False


def _roles_of(snap: Snapshot, tokens: list[Token]) -> dict[str, str]:
    """Return what the letters of a block mean to its codes: `{"P": "the program"}`."""
    roles: dict[str, str] = {}
    for token in tokens:
        facts = _facts_of(snap, token)
        for letters, says, _ in facts["words"] if facts is not None else ():
            roles.update((letter, says) for letter in letters.split() if len(letter) == 1)
    return roles


def _facts_of(snap: Snapshot, token: Token) -> dict[str, Any] | None:
    """Return what is known of the code that a token is, on the machine of the memory."""
    word = token.word
    return None if word is None else _facts(snap.control, word.text.upper(), snap.kind)


@functools.lru_cache(maxsize=512)
def _facts(control: Control, word: str, machine: str) -> dict[str, Any] | None:
    return _core.code_facts(control, word, machine)


def _jumps(control: Control, typed: str, *, begun: bool) -> bool:
    """Return whether a statement goes on with the block that it jumps to, whose name is `begun`."""
    ends = [typed.rstrip("0123456789" if begun else "").rstrip()]
    if begun:
        ends.append(typed.rpartition(" ")[0].rstrip())
    return any(
        does.startswith("goes to") and any(end.endswith(name.upper()) for end in ends)
        for name, _, does in keywords_of(control)
    )


# ---- the items ----


@functools.lru_cache(maxsize=8)
def codes_of(control: Control, machine: str) -> tuple[CompletionItem, ...]:
    """Return the G and M codes that a control has on a kind of machine, each with what it does."""
    listed = _core.g_codes(control, machine)
    names = [name for name, what in listed if what not in ("None", "Unknown")]
    found = []
    for name in [*names, *(f"M{number:02d}" for number in range(LARGEST_M_CODE))]:
        facts = _core.code_facts(control, name, machine)
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
        for name, treatment, does in keywords_of(control)
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


def _variables(snap: Snapshot, program: Program | None, begun: str) -> Iterator[CompletionItem]:
    """Yield the numbered variables that the program uses, then those of the control, then those of
    options that a shop may buy. Of a range of the control the first stands for all, until some
    digits tell which are meant.
    """
    digits = begun.lstrip("#RrFf")
    seen: set[int] = set()
    for number, name, _, detail in _used(program):
        if number is None or name is not None:
            continue
        seen.add(number)
        shown = _core.variable_name(snap.control, number)
        yield CompletionItem(shown, kind=CompletionItemKind.Variable, detail=detail)
    for first, last, holds in snap.code.system_variables:
        if first in seen:
            continue
        seen.add(first)
        shown = _core.variable_name(snap.control, first)
        more = "" if first == last else f" (to {_core.variable_name(snap.control, last)})"
        yield CompletionItem(shown, kind=CompletionItemKind.Constant, detail=holds + more)
        for number in _going_on(digits, first, last) if len(digits) > 1 else ():
            if number not in seen:
                seen.add(number)
                shown = _core.variable_name(snap.control, number)
                yield CompletionItem(shown, kind=CompletionItemKind.Constant, detail=holds)
    for option in snap.control.variable_options.values():
        numbers = option.numbers.replace("-", " ").split()[:1]
        if numbers and numbers[0].isdecimal() and int(numbers[0]) not in seen:
            seen.add(int(numbers[0]))
            yield CompletionItem(
                _core.variable_name(snap.control, int(numbers[0])),
                kind=CompletionItemKind.Constant,
                detail=f"{option.meaning} ({option.numbers})",
            )


def _going_on(digits: str, first: int, last: int) -> Iterator[int]:
    """Yield the numbers of a range that begin with some digits."""
    power = 1
    while digits.isdecimal() and int(digits) * power <= last:
        low, high = int(digits) * power, (int(digits) + 1) * power - 1
        yield from range(max(low, first), min(high, last) + 1)
        power *= 10


def _used(program: Program | None) -> Iterator[tuple[int | None, str | None, str, str]]:
    """Yield the variables of a program, each once: number, name, how the block writes it, the
    block.
    """
    for number, name, text, place in _core.variables_used(program.data) if program else ():
        assert program is not None
        yield number, name, text, program.data.block(place)[2].strip()[:80]


def _named_variables(program: Program | None) -> Iterator[CompletionItem]:
    """Yield the variables of a program that have names, as it writes them."""
    for _, name, text, detail in _used(program):
        if name is not None:
            forms = (f"#<{name}>", f"#{name}")
            shown = next((form for form in forms if form.upper() in text.upper()), name)
            yield CompletionItem(shown, kind=CompletionItemKind.Variable, detail=detail)


def _parameters(control: Control, address: str) -> Iterator[CompletionItem]:
    """Yield the numbers of the parameters of a control, each with what it means; bits together."""
    of_number: dict[str, list[str]] = {}
    for parameter in control.parameters.values():
        number, _, bit = parameter.name.partition("#")
        if number.isdecimal():
            meaning = f"bit {bit}: {parameter.meaning}" if bit else parameter.meaning
            of_number.setdefault(number.lstrip("0") or "0", []).append(meaning)
    for number, meanings in of_number.items():
        yield CompletionItem(
            f"{address}{number}",
            kind=CompletionItemKind.Constant,
            detail=meanings[0][:80],
            documentation="\n".join(meanings),
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
    role = {letter for letter, says in _roles_of(snap, tokens).items() if "program" in says}
    for token in tokens:
        word = token.word
        if word is not None and word.address in role and word.value is not None:
            place = find_program(snap.code, int(word.value))
            if place >= 0:
                return snap.program(place), code
    return None


# ---- signatures ----


def signature(snap: Snapshot, path: str, line: int, character: int) -> SignatureHelp | None:
    """Return the arguments of the macro that a line calls, else the words of its last code before a
    place; the one that is being written is active.
    """
    tokens = _tokens(snap, snap.document(path).line(line))
    begun = [t.word.address for t in tokens if t.word is not None and t.column <= character]
    called = _called(snap, tokens)
    if called is None:
        before = [token for token in tokens if token.end <= character + 1]
        return _of_code(snap, before, begun)
    program, code = called
    arguments = arguments_of(snap, program, code)
    labels = [f"{each.letter}={each.told}" for each in arguments]
    title = f" ({program.comment})" if program.comment else ""
    letters = [each.letter for each in arguments]
    return _help(f"{code} {program.name}{title}", letters, labels, begun)


def _of_code(snap: Snapshot, tokens: list[Token], begun: list[str]) -> SignatureHelp | None:
    """Return the words that the last code of some words is given."""
    for token in reversed(tokens):
        facts = _facts_of(snap, token)
        if facts is not None and facts["words"] and token.word is not None:
            letters = [letters for letters, *_ in facts["words"]]
            labels = [f"{letters}: {says}" for letters, says, _ in facts["words"]]
            title = f"{token.word.text.upper()} {facts['does'].replace('`', '')}"
            return _help(title, letters, labels, begun)
    return None


def _help(
    title: str, letters: list[str], labels: list[str], begun: list[str]
) -> SignatureHelp | None:
    if not labels:
        return None
    active = [i for i, of in enumerate(letters) if begun and begun[-1] in of.split()]
    parameters = [ParameterInformation(label) for label in labels]
    information = SignatureInformation(f"{title}: {', '.join(labels)}", parameters=parameters)
    return SignatureHelp(
        [information], active_signature=0, active_parameter=next(iter(active), None)
    )
