"""What a word of a block does on this control: the text that an editor shows at the pointer."""

from __future__ import annotations

import functools
import re
from collections.abc import Iterator
from typing import Any

from lsprotocol.types import Hover, MarkupContent, MarkupKind

from cncsub import _core
from cncsub._core import Control
from cncsub.editor.arguments import arguments_of
from cncsub.editor.last_run import LastRun, computed_words
from cncsub.editor.names import At, Name, name_at
from cncsub.editor.snapshot import Snapshot, place_of, token_at
from cncsub.number_text import number_text
from cncsub.program import Block, Program, Token
from cncsub.reports.code_facts import code_explanations, code_named
from cncsub.reports.explained import cut

MOST_RULES = 8  # of a code
MOST_ALARMS = 8


def hover(snap: Snapshot, path: str, line: int, character: int) -> Hover | None:
    """Return what is known of the word at a place: what it does on this control, by which rules and
    how sure that is, the alarms it can raise, the values it took in the last run.
    """
    block = snap.block_at(path, line, character)
    token = None if block is None else token_at(block, character)
    found = name_at(snap, path, line, character)
    if block is None or token is None or token.word is None:
        if found is None or found[0].kind != "program":
            return None
        at = snap.range(path, found[1].line, found[1].column, found[1].width)
        text = "\n\n".join(program_lines(snap, snap.program(int(found[0].key))))
        return Hover(MarkupContent(MarkupKind.Markdown, text), at)
    parts = [part for part in _parts(snap, path, block, token, character, found) if part]
    if not parts:
        return None
    at = snap.range(path, block.line, token.column, len(token.text.rstrip()))
    return Hover(MarkupContent(MarkupKind.Markdown, "\n\n".join(parts)), at)


def _parts(
    snap: Snapshot,
    path: str,
    block: Block,
    token: Token,
    character: int,
    found: tuple[Name, At] | None,
) -> Iterator[str]:
    run = snap.last_run(path)
    if found is not None and found[0].kind == "variable":
        yield from _variable_lines(snap, run, *found)
    yield from _values(snap, run, block, token)
    if found is not None and found[0].kind == "program":
        yield from _call_lines(snap, block)
        yield from program_lines(snap, snap.program(int(found[0].key)))
    yield from _word_lines(snap, token, character)


# ---- what the word is ----


def _word_lines(snap: Snapshot, token: Token, character: int) -> Iterator[str]:
    for asked in _asked(snap.control, token, character + 1 - token.column):
        lines = explained(snap.control, snap.kind, asked)
        if lines:
            yield "\n\n".join(lines)
            return


def _asked(control: Control, token: Token, at: int) -> Iterator[str]:
    """Yield the names by which a word may be known: a code, a word of the language, an address.
    `at`: the character of the word at which the pointer stands.
    """
    word = token.word
    if word is None:
        return
    if (code := code_named(word.text)) is not None:
        yield code
    if not word.address.isalpha() or at >= len(word.address):
        yield from keywords_at(control, token.text, at)
    if word.address:
        yield word.address


def keywords_at(control: Control, text: str, at: int) -> list[str]:
    """Return the words of the control's language that stand at a character of a statement, then
    those with which the statement begins; the longest first.
    """
    found = []
    for name, _, _ in keywords_of(control):
        for match in _written(name).finditer(text):
            here = match.start() <= at < match.end()
            if here or match.start() == 0:
                found.append((not here, -len(name), name))
    return [name for *_, name in sorted(found)]


@functools.lru_cache(maxsize=1024)
def _written(name: str) -> re.Pattern[str]:
    """Return how a word is found where it is no part of a longer name."""
    before = r"(?<![A-Z_$])" if name[:1].isalpha() else ""
    after = r"(?![A-Z_])" if name[-1:].isalpha() else ""
    return re.compile(f"{before}{re.escape(name)}{after}", re.IGNORECASE)


@functools.lru_cache(maxsize=8)
def keywords_of(control: Control) -> list[tuple[str, str, str]]:
    """Return the words of a control's language: name, how it is treated, what it does."""
    return _core.keywords(control)


@functools.lru_cache(maxsize=512)
def explained(control: Control, machine: str, asked: str) -> tuple[str, ...]:
    """Return what is known of a code, a word or an address on a kind of machine, as paragraphs of
    Markdown.
    """
    found = code_explanations(asked, [control], machine)
    return tuple(line for fact in found for line in _code_lines(fact))


def _code_lines(fact: dict[str, Any]) -> Iterator[str]:
    on = fact["on"][0]
    machines = f" ({', '.join(on['machines'])})" if on["machines"] else ""
    yield f"**{fact['code']}** on {on['control']}{machines}: {fact['does']}"
    if fact["words"]:
        yield "\n".join(f"- `{word['letters']}` {word['says']}" for word in fact["words"])
    sources = [f"({source['source']}; {source['evidence']})" for source in on["sources"]]
    if sources:
        yield " ".join(sources)
    if on["rules"]:
        yield "\n".join(["rules", *map(_rule_line, on["rules"][:MOST_RULES]), *_more(on["rules"])])
    if on["alarms"]:
        told = [f"- {a['number'] or a['cause']}: {a['meaning']}" for a in on["alarms"]]
        yield "\n".join(["alarms", *told[:MOST_ALARMS], *_more(told)])


def _rule_line(rule: dict[str, Any]) -> str:
    value = rule["value"]
    said = ("yes" if value else "no") if isinstance(value, bool) else cut(str(value) or "none")
    example = f" ({rule['example']})" if rule["example"] else ""
    source = f"({cut(rule['source'])}; {rule['evidence']})"
    return f"- `{rule['name']}` = {said}{example} {source}"


def _more(told: list[Any]) -> list[str]:
    left = len(told) - MOST_RULES
    return [f"- and {left} more: `cncsub explain` tells them"] if left > 0 else []


# ---- programs and values ----


def program_lines(snap: Snapshot, program: Program) -> Iterator[str]:
    """Yield what is known of a program: its title, where it is, the arguments that it reads."""
    title = f" ({program.comment})" if program.comment else ""
    yield f"**{program.name}**{title}, {len(program.blocks):,} blocks"
    arguments = arguments_of(snap, program)
    if arguments:
        yield "\n".join(f"- `{each.letter}` {each.told}" for each in arguments)
    callers = {caller for caller, _, row in snap.calls if row[2] == program.index}
    if callers:
        names = sorted(snap.program(caller).name for caller in callers)
        yield f"called by {', '.join(names[:8])}{', ...' if len(names) > 8 else ''}"


def _call_lines(snap: Snapshot, block: Block) -> Iterator[str]:
    for call in block.calls:
        told = told_call(call.program, call.repeats)
        if told:
            yield told


def told_call(program: object, repeats: object) -> str:
    """Return a call in words, where it is no plain call: `5 times O1002`."""
    if not isinstance(program, str) or not isinstance(repeats, int) or repeats == 1:
        return ""
    return f"never {program}" if repeats == 0 else f"{repeats} times {program}"


def _variable_lines(snap: Snapshot, run: LastRun | None, name: Name, at: At) -> Iterator[str]:
    if isinstance(name.key, int):
        shown = _core.variable_name(snap.control, name.key)
        scope = "a variable of all programs" if name.program is None else "a local variable"
        yield f"**{shown}**, {scope}"
        values = [] if run is None else run.values_of(name.key)
        if values:
            yield f"in the last run: {listed(values)}"
    else:
        written = snap.document(at.file).line(at.line - 1)[at.column - 1 :][: at.width]
        yield f"**{written}**, a variable"


def _values(snap: Snapshot, run: LastRun | None, block: Block, token: Token) -> Iterator[str]:
    if run is None:
        return
    values = run.words.get((block.program.index, place_of(block)), {}).get(token.column)
    if values and dict(computed_words(block)).get(token.column):
        yield f"in the last run: {listed(values)}"


def listed(values: list[float | None]) -> str:
    """Return values as a control shows them, one after the other."""
    return ", ".join("vacant" if value is None else number_text(value) for value in values)
