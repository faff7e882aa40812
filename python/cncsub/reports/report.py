"""One HTML page about a run: `cncsub.report` and `cncsub report`."""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Iterable, Iterator
from importlib.resources import files
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any

from cncsub import _core
from cncsub.analysis.static_tree import letters
from cncsub.analysis.steps_text import place_of
from cncsub.controls import evidence_words
from cncsub.escapes import escape
from cncsub.pages import html_page
from cncsub.reports.code import Anchors, code_section
from cncsub.reports.facts import explanations
from cncsub.reports.path import Drawn
from cncsub.reports.tables import calls_rows, table
from cncsub.writing import write_whole

if TYPE_CHECKING:
    from cncsub.checking import Finding
    from cncsub.library import Library
    from cncsub.run import Run
    from cncsub.tables.call_tree import CallTree

MOST_CALLS = 100_000  # of the tree
MOST_DRAWN = 2_000  # calls that are drawn, where equal calls are one
MOST_ROWS = 1_000  # of a table
MOST_FINDINGS = 500
MOST_MISSED = 20


def report(
    library: Library,
    run: Run,
    path: str | FilePath | None = None,
    *,
    title: str | None = None,
    findings: Iterable[Finding] | None = None,
) -> str:
    """Return a page of HTML about `run`, a run of `library`: the stop, the alarm with its cure, the
    calls, the path in mm, the programs with what ran and what `check` finds, and tables that sort.
    The page is self-contained, needs no network, and its texts are escaped.

    `path`: a file that the page is written to as well. `title`: the head of the page, without it
    the name of the first program that ran. `findings`: without it those of `library.check()`. Long
    parts are cut, and the page says what was left out. Raises `ValueError` for a run of another
    library.

    >>> import cncsub
    >>> library = cncsub.loads("O1\\nN10 M98 P9\\nN20 M30\\n", control="fanuc-0i-f")
    >>> page = cncsub.report(library, library.run())
    >>> "PS0076 program-not-found" in page
    True
    """
    if run.core.code is not library.code:
        raise ValueError("the run belongs to another library: use report(library, library.run())")
    main = run.steps[0].program if len(run.steps) else None
    found = library.check(main) if findings is None else list(findings)
    text = _page(library, run, title or main or "a run", found)
    if path is not None:
        write_whole(path, text)
    return text


def _page(library: Library, run: Run, head: str, findings: list[Finding]) -> str:
    coverage = run.coverage()
    anchors = Anchors(run, coverage)
    drawn = Drawn(run, anchors)
    parts = {
        "Stop": _stop(library, run, anchors),
        "Calls": _calls(run, anchors),
        "Findings": _findings(findings, anchors),
        "Path": drawn.section(),
        "Code": code_section(coverage, findings, run.alarm, anchors, drawn.places()),
        "Tables": _tables(library, run, anchors),
    }
    page = files("cncsub.reports").joinpath("page")
    style, script = (page.joinpath(f"report.{n}").read_text("utf-8") for n in ("css", "js"))
    body = []
    for name, inner in parts.items():
        section = f'<section id="{name.lower()}"><h2>{name}</h2>{"".join(inner)}</section>\n'
        beside = {"Path": ('<div class="beside">', ""), "Code": ("", "</div>")}
        before, after = beside.get(name, ("", ""))
        body.append(f"{before}{section}{after}")
    title = f"{head} on {library.control.title}"
    links = [(name.lower(), name) for name in parts]
    return html_page(title, "report", body, parts=links, style=style, script=script)


# ---- how it stopped ----


def _stop(library: Library, run: Run, anchors: Anchors) -> Iterator[str]:
    from cncsub.reports.printing import stop_text

    yield f'<p class="stop {escape(run.stop.value)}">stopped: {escape(stop_text(run))}</p>'
    if run.alarm is not None:
        yield f'<pre class="alarm">{escape(str(run.alarm))}</pre>'
        link = anchors.link(run.alarm.file, run.alarm.line, "to the block")
        yield f"<p>{link}</p><dl>"
        for fact in explanations(run.alarm.cause, [library.control]):
            yield f"<dt>raised by</dt><dd>{escape(fact['meaning'])}</dd>"
            yield f"<dt>cure</dt><dd>{escape(fact['cure'])}</dd>"
        yield "</dl>"
    elif run.endless is not None:
        yield f"<p>{escape(str(run.endless))}</p>"
    yield "<dl>"
    yield f"<dt>evidence</dt><dd>{escape(_evidence(library))}</dd>"
    for name, told in _facts(run):
        yield f"<dt>{name}</dt><dd>{escape(told)}</dd>"
    yield "</dl>"
    told_notes = library.notes[:MOST_ROWS]
    yield from (f"<p>note: {escape(str(note))}</p>" for note in told_notes)


def _evidence(library: Library) -> str:
    """Return how far the control is to be trusted."""
    control = library.control
    return f"of the rules of {control.base} {evidence_words(control)} are inferred"


def _facts(run: Run) -> Iterator[tuple[str, str]]:
    yield "blocks", f"{run.blocks:,}"
    yield "calls", f"{len(run.calls):,}"
    if len(run.moves):
        yield "moves", f"{len(run.moves):,}, {run.moves.total_length:,.3f} mm"
        yield "time", f"{run.moves.time_words}, without acceleration"
        for axis, (low, high) in run.moves.bounds.items():
            yield axis, f"{low:.10g} to {high:.10g}"
    if missed := Counter(map(str, run.missed_skips)):
        told = [f"{place}{f', {n:,} times' if n > 1 else ''}" for place, n in missed.items()]
        more = f" and {len(told) - MOST_MISSED:,} more" if len(told) > MOST_MISSED else ""
        yield "skips", "; ".join(told[:MOST_MISSED]) + more
    if words := Counter((f"{word.text} at {place_of(word)}") for word in run.dropped):
        told = [f"{word}{f', {n:,} times' if n > 1 else ''}" for word, n in words.items()]
        more = f" and {len(told) - MOST_MISSED:,} more" if len(told) > MOST_MISSED else ""
        yield "dropped", "; ".join(told[:MOST_MISSED]) + more
    for word in {w.warning: w for w in run.dropped if w.warning is not None}.values():
        yield "warning", f"{word.text} does nothing: {word.warning}"


# ---- the calls ----


def _calls(run: Run, anchors: Anchors) -> Iterator[str]:
    if not len(run.calls):
        yield "<p>The program called nothing.</p>"
        return
    yield f'<ul class="tree">{"".join(_branches(run.calls.tree(most=MOST_CALLS), anchors))}</ul>'
    if (left := len(run.calls) - MOST_CALLS) > 0:
        yield f'<p class="pale">... and {left:,} more calls</p>'


def _branches(trees: list[CallTree], anchors: Anchors) -> Iterator[str]:
    """Yield the calls as nested lists; equal neighbours are one."""
    levels = [iter(trees)]  # programs nest deeper than Python does
    drawn = 0
    while levels:
        call = next(levels[-1], None)
        if call is None:
            levels.pop()
            yield "</ul></li>" if levels else ""
            continue
        if drawn == MOST_DRAWN:
            yield '<li class="pale">...</li>' + "</ul></li>" * (len(levels) - 1)
            return
        drawn += 1
        yield f"<li>{_call(call, anchors)}"
        yield "<ul>" if call.calls else "</li>"
        if call.calls:
            levels.append(iter(call.calls))


def _call(call: CallTree, anchors: Anchors) -> str:
    given = f" {escape(letters(call.arguments))}" if call.arguments else ""
    if call.varied:
        given += " (the first; they differ)"
    passes = f", {call.repeats} passes" if call.repeats != 1 else ""
    count = f" x {call.count:,}" if call.count != 1 else ""
    ended = "" if call.blocks is not None else ", not ended"
    words = f"{escape(call.kind)} {anchors.program(call.program)}{given}{passes}{count}{ended}"
    return f'{words} <span class="pale">from {anchors.of_step(call.caller_step)}</span>'


# ---- findings and tables ----


def _findings(findings: list[Finding], anchors: Anchors) -> Iterator[str]:
    if not findings:
        yield "<p>Nothing was found without running.</p>"
        return
    rows = [
        (
            anchors.link(f.file, f.line, f"{f.program} line {f.line}"),
            escape(f.severity),
            escape(f"{f.rule} {f.name}"),
            escape(f.told),
            escape(f.hint),
        )
        for f in findings[:MOST_FINDINGS]
    ]
    yield table(
        "found without running", ("place", "severity", "rule", "what", "cure"), rows, len(findings)
    )


def _tables(library: Library, run: Run, anchors: Anchors) -> Iterator[str]:
    variables = [
        (_core.variable_name(library.control, number), f"{value:.10g}")
        for number, value in run.variables.items()
        if value is not None
    ]
    yield table("calls", *calls_rows(run, anchors, MOST_ROWS), len(run.calls))
    yield table(
        "variables at the stop", ("variable", "value"), variables[:MOST_ROWS], len(variables)
    )
    yield table("modal codes", ("group", "code"), _escaped(run.modal.items()), len(run.modal))
    changes = (
        (
            _core.variable_name(library.control, c.variable),
            _value(c.value),
            anchors.of_step(c.step),
            str(c.step),
        )
        for c in itertools.islice(run.watch, MOST_ROWS)
    )
    yield table("watched", ("variable", "value", "block", "step"), list(changes), len(run.watch))
    dropped = [
        (anchors.link(w.file, w.line, f"{w.program} line {w.line}"), escape(w.text))
        for w in run.dropped[:MOST_ROWS]
    ]
    yield table("dropped by the control", ("block", "word"), dropped, len(run.dropped))
    told = [(str(i), escape(text)) for i, text in enumerate(run.messages[:MOST_ROWS], 1)]
    yield table("messages", ("no.", "text"), told, len(run.messages))


def _value(value: float | None) -> str:
    return "vacant" if value is None else f"{value:.10g}"


def _escaped(rows: Iterable[tuple[Any, Any]]) -> list[tuple[str, ...]]:
    return [tuple(escape(str(cell)) for cell in row) for row in rows]
