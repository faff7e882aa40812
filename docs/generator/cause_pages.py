"""A page for each cause of an alarm: what happened, the cure, a program that raises it, and the
number that each control shows for it."""

from __future__ import annotations

import functools
import sys
from pathlib import Path
from typing import Any

import cncsub
from cncsub.testing import outcome
from generator.markdown import cited, code, fenced, table, words

_ROWS = Path(__file__).resolve().parents[2] / "tests" / "conformance"

_HEAD = """\
# Alarms

What stops a program, by our own names: a **cause** says what happened on any control, and
each control shows a number and a text of its own for it. `cncsub explain PS0076` finds the cause of
a number.

"""


def names() -> list[str]:
    return ["causes/index.md", *(f"causes/{slug}.md" for slug in cncsub.causes)]


def pages() -> dict[str, str]:
    made = {f"causes/{slug}.md": _page(slug) for slug in cncsub.causes}
    return {"causes/index.md": _index(), **made}


def _index() -> str:
    rows = (
        [f"[{slug}]({slug}.md)", words(cause.meaning), _numbers(slug)]
        for slug, cause in cncsub.causes.items()
    )
    return _HEAD + table(("cause", "what happened", "numbers"), rows)


def _numbers(slug: str) -> str:
    entries = [c.alarms[slug] for c in cncsub.controls.values() if slug in c.alarms]
    return ", ".join(dict.fromkeys(words(entry.number) for entry in entries if entry.number))


def _page(slug: str) -> str:
    cause = cncsub.causes[slug]
    text = f"# {slug}\n\nRaised by: {words(cause.meaning)}.\n\nCure: {words(cause.cure)}.\n\n"
    case = _shortest().get(slug)
    if case is not None:
        text += _example(*case)
    rows = [_row(control, slug) for control in cncsub.controls.values() if slug in control.alarms]
    text += "## On the controls\n\n"
    if rows:
        text += table(("control", "number", "text", "source", "evidence"), rows)
        if any(row[2].endswith("\\*") for row in rows):
            text += "\n\\* This wording is not that of a printed list of the control.\n"
        if len(rows) < len(cncsub.controls):
            text += (
                "\nOn the other controls no source gives it a number:"
                " the alarm has only the cause.\n"
            )
    else:
        text += "No source gives it a number on any control: the alarm has only the cause.\n"
    return text


def _row(control: cncsub.Control, slug: str) -> list[str]:
    entry = control.alarms[slug]
    number = code(entry.number) or "-"
    for way, (other, _) in entry.directed.items():
        number += f", {way} {code(other)}"
    printed = "" if entry.printed or not entry.text else " \\*"
    return [
        f"[{control.name}](../controls/{control.name}.md#alarms)",
        number,
        words(entry.text or "-") + printed,
        cited(entry.source, "../"),
        entry.evidence,
    ]


# ---- a program that raises it ----


@functools.cache
def _shortest() -> dict[str, tuple[Any, str]]:
    """The shortest row of the conformance tables for each cause, with its control: one that shows a
    number, where some do.
    """
    sys.path.insert(0, str(_ROWS))
    try:
        from conformance import cases
    finally:
        sys.path.remove(str(_ROWS))
    found: dict[str, tuple[Any, str]] = {}
    for case in sorted(filter(_is_plain, cases()), key=_size):
        if case.alarm is None:
            continue
        numbered = [name for name in case.controls if case.number_on(name) is not None]
        name = (numbered or case.controls)[0]
        known = found.get(case.alarm)
        if known is None or (numbered and known[0].number_on(known[1]) is None):
            found[case.alarm] = (case, name)
    return found


def _is_plain(case: Any) -> bool:
    """Whether the program alone raises it: no folder, no device, readable."""
    return (
        isinstance(case.program, str)
        and case.program.isprintable() is not None
        and not case.external
    )


def _size(case: Any) -> tuple[bool, int]:
    """Rows that need something else said stand after the others."""
    needs = case.params or case.replace or case.setup or case.options or case.mdi is not None
    return bool(needs), len(case.program)


def _example(case: Any, name: str) -> str:
    control = cncsub.controls[name].with_parameters(dict(case.params)).replace(**case.replace)
    run = outcome.execute(case, outcome.load(case, control))
    if run.alarm is None or run.alarm.cause != case.alarm:
        raise ValueError(f"{case.claim!r} does not raise {case.alarm}")
    said = [f"parameter {n} = {v:g}" for n, v in case.params.items()]
    said += [f"rule {n} = {v}" for n, v in case.replace.items()]
    if case.setup:
        said.append(f"setup {code(dict(case.setup))}")
    said += [f"{n} = {v!r}" for n, v in case.options.items()]
    told = f"{words(case.claim[:1].upper() + case.claim[1:])}. On [{name}](../controls/{name}.md)"
    told += f", with {'; '.join(said)}" if said else ""
    if case.mdi is not None:
        told += f", with {code(case.mdi)} typed in MDI"
    program = case.program
    return (
        f"## A program that raises it\n\n{told}:\n\n"
        + fenced("nc", program)
        + "\n"
        + fenced("text", str(run.alarm))
        + f"\nSource: {cited(case.source_on(name), '../')} ({case.evidence[name]}).\n\n"
    )
