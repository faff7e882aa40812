"""What a notebook shows of runs, memories and programs: small pages of HTML without scripts, which
take the colours of the page around them, dark or light.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from html import escape
from itertools import islice
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from cncsub.library import Library
    from cncsub.program import Program
    from cncsub.run import Run
    from cncsub.tables import Calls

_MOST_PROGRAMS = 20
_HEAD, _TAIL = 30, 10  # lines of a program
_MOST_LINES = 8  # of messages and the like
_MOST_LETTERS = 200  # of a line
_COMMENT = re.compile(r"\([^()]*\)?|;.*")


def run_html(run: Run) -> str:
    """How a run ended, what it called, and how far it moved."""
    parts = [_line(_title(run), strong=True)]
    alarm = run.alarm
    if alarm is not None:
        parts.append(_marked(str(alarm)))
    elif run.endless is not None:
        parts.append(_marked(_cut(str(run.endless))))
    if len(run.calls):
        parts.append(calls_html(run.calls))
    if len(run.moves):
        parts.append(_table(("", "from", "to"), _bounds(run)))
    parts += _few("message", run.messages)
    parts += _few("dropped", (f"{word.text} at line {word.line}" for word in run.dropped))
    return _page(parts)


def _title(run: Run) -> str:
    count = len(run.steps)
    facts = [f"stopped: {run.stop.value}"]
    if run.waiting_for:
        facts.append(f"for {run.waiting_for}")
    facts.append(f"{count:,} block{'' if count == 1 else 's'}")
    if len(run.moves):
        facts.append(f"{len(run.moves):,} moves, {run.moves.total_length:,.3f} mm")
        facts.append(f"{run.moves.total_time:,.1f} s")
    return ", ".join(facts)


def _bounds(run: Run) -> Iterator[tuple[str, str, str]]:
    for axis, (low, high) in run.moves.bounds.items():
        yield axis, f"{low:.10g}", f"{high:.10g}"


def calls_html(calls: Calls) -> str:
    """The calls as a tree."""
    return _text(repr(calls))


def library_html(library: Library) -> str:
    """The programs of a memory, and what is to be known of it."""
    main = library.main
    count = len(library)
    title = f"{library.control.title}: {count:,} program{'' if count == 1 else 's'}"
    rows = (
        (
            program.name + (" (main)" if program is main else ""),
            program.comment,
            f"{len(program.blocks):,}",
            f"{program.file}:{program.line}",
        )
        for program in map(library.__getitem__, islice(library, _MOST_PROGRAMS))
    )
    parts = [_line(title, strong=True), _table(("program", "title", "blocks", "place"), rows)]
    if count > _MOST_PROGRAMS:
        parts.append(_line(f"... and {count - _MOST_PROGRAMS:,} more"))
    parts += _few("note", map(str, library.notes))
    return _page(parts)


def program_html(program: Program) -> str:
    """The lines of a program with their numbers, its comments paler than its blocks."""
    lines = program.text.rstrip().splitlines() or [""]
    numbered = [(program.line + i, line) for i, line in enumerate(lines)]
    left = len(numbered) - _HEAD - _TAIL
    shown = [_numbered(*row) for row in (numbered if left <= 1 else numbered[:_HEAD])]
    if left > 1:
        shown.append(_pale(f"      ... {left:,} lines"))
        shown += [_numbered(*row) for row in numbered[-_TAIL:]]
    place = f"{program.name}, {program.file}:{program.line}, {len(program.blocks):,} blocks"
    return _page([_line(place, strong=True), _pre("\n".join(shown))])


def _numbered(number: int, line: str) -> str:
    line = _cut(line)
    parts, end = [], 0
    for comment in _COMMENT.finditer(line):
        parts += [escape(line[end : comment.start()]), _pale(comment[0])]
        end = comment.end()
    return "".join([_pale(f"{number:>6}  "), *parts, escape(line[end:])])


# ---- pieces of a page ----


def _page(parts: Iterable[str]) -> str:
    return f"<div>{''.join(parts)}</div>"


def _cut(text: str) -> str:
    return text if len(text) <= _MOST_LETTERS else text[:_MOST_LETTERS] + " ..."


def _pale(text: str) -> str:
    return f'<span style="opacity:.55">{escape(text)}</span>'


def _line(text: str, *, strong: bool = False) -> str:
    weight = ' style="font-weight:bold"' if strong else ""
    return f"<p{weight}>{escape(text)}</p>"


def _pre(inner: str, style: str = "") -> str:
    return f'<pre style="background:none;color:inherit;{style}">{inner}</pre>'


def _text(text: str) -> str:
    return _pre(escape(text))


def _marked(text: str) -> str:
    """With a red bar that is seen on dark and on light pages."""
    return _pre(escape(text), "border-left:4px solid #d33;padding-left:.6em")


def _few(word: str, texts: Iterable[str]) -> list[str]:
    told = list(texts)
    lines = [_line(f"{word}: {_cut(text)}") for text in told[:_MOST_LINES]]
    if (left := len(told) - _MOST_LINES) > 0:
        lines.append(_line(f"... and {left:,} more"))
    return lines


def _table(heads: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    head = "".join(f"<th>{escape(name)}</th>" for name in heads)
    body = "".join(
        f"<tr>{''.join(f'<td>{escape(_cut(cell))}</td>' for cell in row)}</tr>" for row in rows
    )
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"
