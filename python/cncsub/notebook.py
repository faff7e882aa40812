"""The pages of runs, memories and programs in a notebook: small pieces of HTML without scripts, in
the colours of the page around them, dark or light.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from cncsub import _core
from cncsub.checking import check
from cncsub.escapes import escape
from cncsub.notebook_pieces import cut, few, line, marked, page, pale, plain, pre, table

if TYPE_CHECKING:
    from cncsub.library import Library
    from cncsub.program import Program
    from cncsub.run import Run
    from cncsub.tables.of_runs import Calls
    from cncsub.tables.rows import Dropped

_MOST_PROGRAMS = 20
_HEAD, _TAIL = 30, 10  # lines of a program
_MOST_CHECKED = 20_000  # blocks of a memory


def run_html(run: Run, drawing: str) -> str:
    """Return how a run ended, its path, what it called, and how far it moved."""
    parts = [line(_title(run), strong=True)]
    alarm = run.alarm
    if alarm is not None:
        parts.append(marked(str(alarm)))
    elif run.endless is not None:
        parts.append(marked(cut(str(run.endless))))
    if drawing:
        parts.append(drawing)
    if len(run.calls):
        parts.append(calls_html(run.calls))
    if len(run.moves):
        parts.append(table(("", "from", "to"), _bounds(run)))
    parts += few("message", run.messages)
    parts += few("dropped", map(_dropped, run.dropped))
    return page(parts)


def _dropped(word: Dropped) -> str:
    warning = "" if word.warning is None else f" (warning: {word.warning})"
    return f"{word.text} at line {word.line}{warning}"


def _title(run: Run) -> str:
    count = len(run.steps)
    facts = [f"stopped: {run.stop.value}"]
    if run.waiting_for:
        facts.append(f"for {run.waiting_for}")
    facts.append(f"{count:,} block{'' if count == 1 else 's'}")
    if len(run.moves):
        facts.append(f"{run.moves.size_words()}, {run.moves.total_length:,.3f} mm")
        facts.append(run.moves.time_words)
    return ", ".join(facts)


def _bounds(run: Run) -> Iterator[tuple[str, str, str]]:
    for axis, (low, high) in run.moves.bounds.items():
        yield axis, f"{low:.10g}", f"{high:.10g}"


def calls_html(calls: Calls) -> str:
    """Return the calls as a tree."""
    return plain(repr(calls))


def library_html(library: Library) -> str:
    """Return the programs of a memory, and what is to be known of it."""
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
    parts = [line(title, strong=True), table(("program", "title", "blocks", "place"), rows)]
    if count > _MOST_PROGRAMS:
        parts.append(line(f"... and {count - _MOST_PROGRAMS:,} more"))
    parts += few("note", map(str, library.notes))
    return page(parts)


def program_html(program: Program) -> str:
    """Return the lines of a program with their numbers, its comments paler than its blocks."""
    lines = program.text.rstrip().split("\n")
    numbered = [(program.line + i, line) for i, line in enumerate(lines)]
    left = len(numbered) - _HEAD - _TAIL
    marks = _marks(program)
    head = numbered if left <= 1 else numbered[:_HEAD]
    shown = [_numbered(*row, marks, program) for row in head]
    if left > 1:
        shown.append(pale(f"      ... {left:,} lines"))
        shown += [_numbered(*row, marks, program) for row in numbered[-_TAIL:]]
    place = f"{program.name}, {program.file}:{program.line}, {len(program.blocks):,} blocks"
    return page([line(place, strong=True), pre("\n".join(shown))])


def _marks(program: Program) -> dict[int, str]:
    """Return by line what the control would refuse there or what will surprise. Large memories have
    no marks, because all their blocks would have to be checked.
    """
    code = program.data.code
    if sum(code.program(index).blocks for index in range(len(code))) > _MOST_CHECKED:
        return {}
    marks: dict[int, str] = {}
    for found in check(code, -1 if code.main is None else code.main, None, None):
        if found.file == program.file and found.severity != "note":
            marks.setdefault(found.line, f"{found.rule} {found.message}")
    return marks


def _numbered(number: int, text: str, marks: dict[int, str], program: Program) -> str:
    tokens = _core.tokens(program.data.code.control, cut(text))
    parts = [pale(text) if kind == "comment" else escape(text) for kind, text, *_ in tokens]
    mark = ""
    if number in marks:
        mark = f'  <span style="color:#d33">&larr; {escape(cut(marks[number]))}</span>'
    return "".join([pale(f"{number:>6}  "), *parts, mark])
