"""A control as text: a page of what sets it apart, and all its facts with their sources."""

from __future__ import annotations

import re
import shlex
import textwrap
from collections.abc import Iterable, Iterator
from itertools import groupby
from typing import Any

from cncsub._core import Control, Parameter, Rule, cited
from cncsub.controls import aliases_of, causes, controls, evidence_words, sources_of
from cncsub.reports.facts import effect_of
from cncsub.reports.printing import Console, Text, wrapped

WIDTH = 100  # columns of the page where no terminal says how many
MOST_EXPLAINED = 24  # alarm numbers that are printed with their texts
SHORT = 60  # letters of a list that stands before its meaning
LEAST = 30  # letters of a meaning that are always told

Fact = tuple[str, str]
"""The name of a fact, and what is said of it."""


# ---- the page ----


def print_summary(console: Console, control: Control) -> None:
    """Print what differs from the family, in groups, and the sources that say so."""
    different = [rule for rule in control.rules if rule.value != rule.family]
    console.print(Text(f"{control.title} ({control.name})", style="bold"))
    lead = f"cncsub controls {shlex.quote(control.name)}"
    _print_paragraph(
        console,
        f"{len(different)} of {len(control.rules)} rules differ from the family, whose value is"
        f" in ( ), the source in [ ]. Inferred (?) are {evidence_words(control)}: see `cncsub ask"
        f" {shlex.quote(control.base)}`. `{lead} WORD` prints facts with a word, and in full what"
        f" ends in ... here, --all everything.{_other_names(control)}",
    )
    for title, facts in _sections(control, different):
        console.print(Text(f"\n{title}", style="bold"))
        for head, text in facts:
            _print_paragraph(console, f"{head}{text}", head)
    _print_keys(console, control, different)


def _other_names(control: Control) -> str:
    names = aliases_of(control)
    return f" Also {', '.join(names)}." if names else ""


def _sections(control: Control, different: list[Rule]) -> Iterator[tuple[str, list[Fact]]]:
    printed: dict[str, str] = {}
    if control.base != control.name:
        base = controls[control.base]
        yield f"Changed from {base.title} ({base.name})", list(_own(control, base))
    for group, rules in groupby(different, key=lambda rule: rule.group):
        yield group.capitalize(), [_rule(rule, printed) for rule in rules]
    absent = [(group, f": no rules of it {_mark(*of)}") for group, of in control.absent.items()]
    parameters = list(control.parameters.values())
    alarms = list(control.alarms.values())
    more = {
        "What the control does not have": absent,
        f"Parameters ({len(parameters)})": list(_parameters(parameters)),
        "Variables by option": list(_options(control)),
        f"Alarms ({len(alarms)} causes)": list(_alarms(alarms)),
    }
    yield from ((title, facts) for title, facts in more.items() if facts)


def _own(control: Control, base: Control) -> Iterator[Fact]:
    """Yield what a control of your own says otherwise than its base, each with its note."""
    before = {rule.name: rule for rule in base.rules}
    for rule in control.rules:
        of = before[rule.name]
        notes = [source for entry, (source, _) in rule.sources.items() if entry not in of.sources]
        if rule.source != of.source:
            notes.append(rule.source)
        if notes:
            yield rule.name, f" = {rule.value} ({of.value}) [{'; '.join(notes)}]"
    for name, parameter in control.parameters.items():
        if parameter.source != (delivered := base.parameters[name]).source:
            values = f"{parameter.value:g} ({delivered.value:g})"
            yield f"parameter {name}", f" = {values} [{parameter.source}]"
    for slug, alarm in control.alarms.items():
        if slug not in base.alarms or alarm.source != base.alarms[slug].source:
            yield slug, f": {alarm.number} {alarm.text or ''} [{alarm.source}]"


_KEPT = "\N{NO-BREAK SPACE}"  # no line ends in a mark


def _mark(source: str, evidence: str) -> str:
    """Return the sources of a fact by their keys: `[ALM]`, `[ALM?]` where it is inferred from it,
    `[?]` where there is none.
    """
    keys = ", ".join(map(_short, cited(source)))
    mark = f"[{keys}{'?' if evidence == 'inferred' or not keys else ''}]"
    return mark.replace(" ", _KEPT)


def _short(key: str) -> str:
    return key.removesuffix(" p")  # the p of the page that follows


def _print_keys(console: Console, control: Control, different: list[Rule]) -> None:
    """Print the sources that the page cites, each once."""
    told = [rule.source for rule in different]
    told += [source for rule in different for source, _ in rule.sources.values()]
    told += [source for source, _ in control.absent.values()]
    told += [p.source for p in control.parameters.values() if p.value != 0]
    told += [option.source for option in control.variable_options.values()]
    told += [alarm.source for alarm in control.alarms.values()]
    keys = {key for source in told for key in cited(source)}
    console.print(Text("\nSources, and their evidence for this control", style="bold"))
    for source in sources_of(control):
        if source.key in keys:
            key, evidence = _short(source.key), source.on(control.base)
            worth = "" if evidence == "secondary" else f"; {evidence}"
            _print_paragraph(console, f"{key} = {source.title}{worth}", key)
    console.print("  Secondary where nothing is said.")
    _print_paragraph(console, "? = inferred: general knowledge, or no source says", "?")


def _print_paragraph(console: Console, text: str, head: str = "") -> None:
    """Print a text in lines of the page, its head in colour."""
    lines = textwrap.wrap(
        text,
        max(40, min(console.width or WIDTH, WIDTH)),
        initial_indent="  " if head else "",
        subsequent_indent="    " if head else "",
        break_long_words=False,
        break_on_hyphens=False,
    )
    first, *rest = (line.replace(_KEPT, " ") for line in lines)
    named = f"  {head}"
    if head and first.startswith(named):
        console.print(Text.assemble((named, "cyan"), first[len(named) :]))
    else:
        console.print(first)
    for line in rest:
        console.print(line)


# ---- the page: rules ----


def _rule(rule: Rule, printed: dict[str, str]) -> Fact:
    """Return a rule as a fact; `printed` holds the long lists above it, which are not printed
    twice.
    """
    if not rule.choices and isinstance(rule.value, str) and isinstance(rule.family, str):
        texts = (rule.value, rule.family)
        if rule.entries or any(len(text.split()) > 1 for text in texts):
            told = _list_words(rule, rule.value.split(), rule.family.split())
            if len(told) <= SHORT:
                return rule.name, f" {told}: {_in_one_line(rule, f' {told}: ')}"
            before = printed.setdefault(told, rule.name)
            if before != rule.name:
                return rule.name, f" as {before}: {rule.meaning}"
            return rule.name, f", {rule.meaning}: {told.removeprefix('= ')}"
    family = "" if isinstance(rule.value, bool) else f" ({_value(rule.family)})"
    mark = _mark(rule.source, rule.evidence)
    head = f" = {_value(rule.value)}{family}: "
    return rule.name, f"{head}{_in_one_line(rule, f'{head} {mark}')} {mark}"


def _in_one_line(rule: Rule, beside: str) -> str:
    """Return as much of the meaning of a rule as has room in its line, in whole words."""
    room = WIDTH - len(f"  {rule.name}{beside}")
    return textwrap.shorten(rule.meaning, max(room, LEAST), placeholder=" ...")


def _list_words(rule: Rule, mine: list[str], family: list[str]) -> str:
    """Return what the list of a rule has and the family's has not, and the other way round."""
    more = _marked(rule, [entry for entry in mine if entry not in family])
    codes = {entry.partition("=")[0] for entry in mine}
    gone = [entry.partition("=")[0] for entry in family if entry not in mine]
    less = _marked(rule, [entry for entry in gone if entry not in codes])
    sides = [side for side in (more and f"with {more}", less and f"without {less}") if side]
    return ", ".join(sides) if family else f"= {more}"


def _marked(rule: Rule, entries: list[str]) -> str:
    """Return entries with their sources, those of one source together."""
    by_mark: dict[str, list[str]] = {}
    for entry in entries:
        told = rule.sources.get(entry) or rule.sources.get(entry.partition("=")[0])
        mark = _mark(*told) if told else _mark(rule.source, rule.evidence)
        by_mark.setdefault(mark, []).append(entry)
    return ", ".join(f"{_compact(alike)} {mark}" for mark, alike in by_mark.items())


def _compact(entries: list[str]) -> str:
    """Return a list in few words: `0-4 7.1`, and codes grouped by their meaning."""
    if all(re.fullmatch(r"[0-9.]+|[A-Z]+", entry) for entry in entries):
        return _runs(entries)
    if not all(re.fullmatch(r"([0-9.]+|[A-Z]+)=[^=]+", entry) for entry in entries):
        return " ".join(entries)
    by_meaning: dict[str, list[str]] = {}
    for entry in entries:
        code, _, meaning = entry.partition("=")
        by_meaning.setdefault(meaning, []).append(code)
    return ", ".join(f"{_runs(codes)} = {meaning}" for meaning, codes in by_meaning.items())


def _runs(numbers: Iterable[str]) -> str:
    """Return numbers in few words: three or more that count up in their last figure stand as `9-11`
    and `30.1-30.6`.
    """
    told: list[list[str]] = []
    for number in numbers:
        if told and _next(told[-1][-1]) == number:
            told[-1].append(number)
        else:
            told.append([number])
    return " ".join(" ".join(run) if len(run) < 3 else f"{run[0]}-{run[-1]}" for run in told)


def _next(number: str) -> str:
    """Return the number after this one: `PS0077` after `PS0076`, `30.2` after `30.1`."""
    figures = re.search(r"[0-9]+$", number)
    if figures is None:
        return ""
    return number[: figures.start()] + str(int(figures[0]) + 1).zfill(len(figures[0]))


# ---- the page: parameters, options and alarms ----


def _parameters(parameters: list[Parameter]) -> Iterator[Fact]:
    for p in parameters:
        if p.value != 0:
            told = "; ".join(filter(None, [p.meaning, effect_of(p)]))
            yield f"{p.name} = {p.value:g}", f": {told} {_mark(p.source, p.evidence)}"
    zero = [p for p in parameters if p.value == 0]
    lists = {
        "0 as delivered": [p.name for p in zero if p.used],
        "0, and cncsub computes nothing from": [p.name for p in zero if not p.used],
    }
    yield from ((lead, f": {_parameter_names(names)}") for lead, names in lists.items() if names)


def _parameter_names(names: list[str]) -> str:
    """Return parameters in few words: `6050-6059 6001#5,6,7`."""
    bits: dict[str, list[str]] = {}
    for name in names:
        number, _, bit = name.partition("#")
        bits.setdefault(number, []).append(bit)
    told: list[str] = []
    for in_bits, numbers in groupby(bits, key=lambda number: bits[number] != [""]):
        if in_bits:
            told += [f"{number}#{','.join(bits[number])}" for number in numbers]
        else:
            told.append(_runs(numbers))
    return " ".join(told)


def _options(control: Control) -> Iterator[Fact]:
    by_rule: dict[str, list[str]] = {}
    for o in control.variable_options.values():
        fitted = " (fitted)" if o.fitted else ""
        told = f"{o.name}{fitted} {o.numbers} {_mark(o.source, o.evidence)}"
        by_rule.setdefault(o.rule, []).append(told)
    yield from ((rule, f": {', '.join(told)}") for rule, told in by_rule.items())


def _alarms(alarms: list[Any]) -> Iterator[Fact]:
    by_number: dict[str, list[Any]] = {}
    for alarm in alarms:
        directed = [number for number, _ in alarm.directed.values()]
        for number in [alarm.number] if alarm.number else directed:
            by_number.setdefault(number, []).append(alarm)
    if len(by_number) > MOST_EXPLAINED:
        told = _runs(sorted(by_number, key=_in_order))
        yield "numbers, whose texts `cncsub explain NUMBER` prints", f": {told}"
    else:
        by_text: dict[str, list[str]] = {}
        for number, alike in by_number.items():
            text = alike[0].text or causes[alike[0].cause].meaning
            whole = f" {text}: {', '.join(alarm.cause for alarm in alike)}"
            by_text.setdefault(whole, []).append(number)
        yield from ((_runs(numbers), whole) for whole, numbers in by_text.items())
    nameless = [alarm.cause for alarm in alarms if not alarm.number and not alarm.directed]
    if nameless:
        yield "no number", f": {' '.join(nameless)}"


def _in_order(number: str) -> tuple[str, int, str]:
    """Return the sort key of a number: by its letters, then by its figures."""
    letters = re.sub(r"[0-9].*", "", number)
    return letters, int(re.sub(r"\D", "", number) or 0), number


# ---- all of a control ----


def print_control(console: Console, control: Control) -> None:
    console.print(Text(f"{control.title} ({control.name})", style="bold"))
    rules = ((f"{r.name} = {_value(r.value)}", r.meaning, r) for r in control.rules)
    _print_facts(console, "Rules", rules)
    for group, (source, evidence) in control.absent.items():
        console.print(Text.assemble(("  no rules of ", ""), (group, "cyan")))
        _print_source(console, f"[{source}; {evidence}]")
    parameters = (
        (
            f"{p.name} = {p.value:g}",
            "; ".join(filter(None, [p.meaning, effect_of(p)])),
            p,
        )
        for p in control.parameters.values()
    )
    _print_facts(console, "Parameters", parameters)
    options = (
        (f"{o.rule}={o.name}{', fitted' if o.fitted else ''}", f"{o.meaning}: {o.numbers}", o)
        for o in control.variable_options.values()
    )
    if control.variable_options:
        _print_facts(console, "Variables by option", options)
    alarms = (
        (f"{_numbers(a)} {a.cause}", a.text or causes[a.cause].meaning, a)
        for a in control.alarms.values()
    )
    _print_facts(console, "Alarms", alarms)
    _print_sources(console, control)


def _numbers(alarm: Any) -> str:
    """Return the number of an alarm, or those of its directions: OT0500 +, OT0501 -."""
    directed = [f"{number} {way}" for way, (number, _) in alarm.directed.items()]
    return alarm.number or ", ".join(directed) or "(no number)"


def _print_sources(console: Console, control: Control) -> None:
    console.print(Text("\nSources, and their evidence for this control", style="bold"))
    for source in sources_of(control):
        _print_fact(console, source.key, source.title)
        address = f"; {source.address}" if source.address else ""
        _print_source(console, f"[{source.on(control.base)}{address}]")


def _print_facts(console: Console, title: str, facts: Iterable[tuple[str, str, Any]]) -> None:
    console.print(Text(f"\n{title}", style="bold"))
    for head, text, fact in facts:
        _print_fact(console, head, text)
        _print_source(console, f"[{fact.source}; {fact.evidence}]")
        for entry, (source, evidence) in getattr(fact, "sources", {}).items():
            there = "" if entry in str(fact.value).split() else "not "
            _print_source(console, f"{there}{entry} [{source}; {evidence}]")


def _print_fact(console: Console, head: str, text: str) -> None:
    """Print a fact with its head in colour; lines that are wrapped on a terminal are indented."""
    first, *rest = wrapped(console, f"  {head}: {text}", "    ")
    named = f"  {head}"
    if first.startswith(named):
        console.print(Text.assemble((named, "cyan"), first[len(named) :]))
    else:  # a head that is longer than a line
        console.print(Text(first, style="cyan"))
    for line in rest:
        console.print(line)


def _print_source(console: Console, text: str) -> None:
    for line in wrapped(console, f"      {text}", "      "):
        console.print(Text(line, style="dim"))


def _value(value: bool | int | str) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return str(value) or "none"
