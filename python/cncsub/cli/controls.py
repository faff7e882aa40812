"""`cncsub controls`: the controls, what one of them does and why, and how two differ."""

from __future__ import annotations

import io
import os
import shutil
import sys
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Annotated, Any

import typer

import cncsub
from cncsub.cli.options import Format, Output, control_named, wrong_use
from cncsub.cli.output import write_json, write_text
from cncsub.cli.project import project_for
from cncsub.comparison.reasons import told_apart, value_text
from cncsub.controls import aliases_of, evidence_words, names_beginning
from cncsub.escapes import shown
from cncsub.interrupts import left_to_child
from cncsub.reports.control_text import print_control, print_summary
from cncsub.reports.facts import control_facts, listed_facts
from cncsub.reports.printing import Console, console_on, print_pairs, print_wrapped

_LISTS = {  # the lists, and the word for one entry
    "rules": "rule",
    "parameters": "parameter",
    "variable_options": "variables by option",
    "alarms": "alarm",
}


def controls(
    name: Annotated[
        str | None,
        typer.Argument(help="One control.", show_default=False, autocompletion=names_beginning),
    ] = None,
    words: Annotated[
        list[str] | None,
        typer.Argument(
            help="Only the facts with all of these words: 6005, repeat, PS0076.", show_default=False
        ),
    ] = None,
    diff: Annotated[
        str | None,
        typer.Option(
            "--diff",
            help="Show the differences from another control.",
            metavar="OTHER",
            autocompletion=names_beginning,
        ),
    ] = None,
    everything: Annotated[
        bool,
        typer.Option(
            "--all", help="Every rule, parameter and alarm, not only what differs from the family."
        ),
    ] = False,
    format: Annotated[Format, typer.Option()] = Format.TEXT,
    output: Output = None,
) -> None:
    """List the controls, or the rules, parameters and alarms of one with their sources."""
    if name is None:
        with wrong_use():
            if diff is not None:
                raise ValueError("--diff compares two controls: give the first one too")
            own = project_for(None).own_control
        listed = {known.name: known for known in cncsub.controls.values()}
        if own is not None:
            listed = {own.name: own} | listed
        if format is Format.JSON:
            write_json(output, list(map(listed_facts, listed.values())))
        else:
            pairs = {name: _listed(known) for name, known in listed.items()}
            write_text(output, lambda console: print_pairs(console, pairs))
        return
    control = control_named(name)
    if diff is None and not words and format is Format.TEXT:
        told = print_control if everything else print_summary
        _paged(output, lambda console: told(console, control))
        return
    facts = _chosen(control_facts(control), words or ())
    if diff is None:
        with wrong_use():
            if words and not any(facts[kind] for kind in _LISTS):
                raise ValueError(f"{control.name} has no fact with {' and '.join(words)}")
        _tell(facts, format, output, lambda: _lines(facts))
        return
    other = control_named(diff)
    differences = list(_differences(facts, _chosen(control_facts(other), words or ())))
    apart = {"controls": [control.name, other.name], "differences": differences}
    _tell(apart, format, output, lambda: _difference_lines(apart))


def _listed(control: cncsub.Control) -> str:
    """Return what the list says of a control: its title, evidence and other names."""
    names = aliases_of(control) if control.name == control.base else []
    also = f"; also {', '.join(names)}" if names else ""
    return f"{control.title}; inferred {evidence_words(control)}{also}"


class _Held(io.StringIO):
    """A text for a terminal, held back."""

    def isatty(self) -> bool:
        return True


def _paged(output: Path | None, write: Callable[[Console], None]) -> None:
    """Send text that is longer than the terminal through a pager: `PAGER`, or what there is."""
    if output is not None or not (sys.stdout.isatty() and sys.stdin.isatty()):
        write_text(output, write)
        return
    held = _Held()
    write(console_on(held))
    text = held.getvalue()
    if text.count("\n") < shutil.get_terminal_size().lines:
        sys.stdout.write(text)
        return
    from pydoc import pager  # not imported where nothing is paged

    os.environ.setdefault("LESS", "-R")  # colours as they are
    with left_to_child():
        pager(text)


def _tell(facts: dict[str, Any], format: Format, output: Any, lines: Any) -> None:
    if format is Format.JSON:
        write_json(output, facts)
        return

    def write(console: Console) -> None:
        for line in lines():
            print_wrapped(console, shown(line))

    _paged(output, write)


def _chosen(facts: dict[str, Any], words: Iterable[str]) -> dict[str, Any]:
    """Return the facts that hold all of the words, anywhere in them, in capitals or not."""
    wanted = [word.casefold() for word in words]

    def holds(fact: object) -> bool:
        text = str(fact).casefold()
        return all(word in text for word in wanted)

    return {
        name: [fact for fact in value if holds(fact)] if name in _LISTS else value
        for name, value in facts.items()
    }


def _lines(facts: dict[str, Any]) -> Iterator[str]:
    for kind in _LISTS:
        for fact in facts[kind]:
            yield _headline(kind, fact)
            yield f"    [{fact['source']}; {fact['evidence']}]"


def _headline(kind: str, fact: dict[str, Any]) -> str:
    word = _LISTS[kind]
    if kind == "alarms":
        return f"{word} {_number(fact)} {fact['cause']}: {fact['text'] or _meaning(fact)}"
    sets = f" (sets {', '.join(fact['rules'])})" if fact.get("rules") else ""
    value = f" = {value_text(fact['value'])}" if "value" in fact else ""
    return f"{word} {fact['name']}{value}: {fact['meaning']}{sets}"


def _meaning(fact: dict[str, Any]) -> str:
    meaning = fact["meaning"] if "meaning" in fact else cncsub.causes[fact["cause"]].meaning
    return str(meaning)


def _number(fact: dict[str, Any]) -> str:
    return str(fact["number"] or "(no number)")


# ---- two controls ----


def _differences(one: dict[str, Any], other: dict[str, Any]) -> Iterator[dict[str, Any]]:
    for kind in _LISTS:
        key = "cause" if kind == "alarms" else "name"
        pairs: dict[str, list[Any]] = {}
        for side, facts in enumerate((one, other)):
            for fact in facts[kind]:
                pairs.setdefault(fact[key], [None, None])[side] = fact
        for name, pair in pairs.items():
            values = [_compared(kind, fact) for fact in pair]
            if values[0] != values[1]:
                meaning = _meaning(next(fact for fact in pair if fact is not None))
                yield {
                    "kind": kind,
                    "name": name,
                    "meaning": meaning,
                    "values": values,
                    "sources": [None if fact is None else fact["source"] for fact in pair],
                }


def _compared(kind: str, fact: dict[str, Any] | None) -> Any:
    if fact is None:
        return None
    if kind == "alarms":
        return f"{_number(fact)} {fact['text'] or ''}".strip()
    return fact.get("value", fact.get("numbers"))


def _difference_lines(told: dict[str, Any]) -> Iterator[str]:
    names = told["controls"]
    width = max(map(len, names))
    for difference in told["differences"]:
        yield f"{_LISTS[difference['kind']]} {difference['name']}: {difference['meaning']}"
        apart = told_apart(*difference["values"])
        for name, there, source in zip(names, apart, difference["sources"], strict=True):
            yield f"    {name.ljust(width)}  {there}" + (f"  [{source}]" if source else "")
    count = len(told["differences"])
    yield f"{count:,} difference{'' if count == 1 else 's'} between {names[0]} and {names[1]}"
