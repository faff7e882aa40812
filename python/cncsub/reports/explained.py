"""Codes, rules and parameters explained, as text."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from cncsub._core import Control
from cncsub.checking import CheckRule, rule_named, rule_names
from cncsub.escapes import shown
from cncsub.gate_rules import RULES as GATE_RULES
from cncsub.reports.code_facts import code_explanations, code_named, example_of
from cncsub.reports.facts import effect_of, explanations
from cncsub.reports.nearest import Entry
from cncsub.reports.printing import Console, Text, wrapped

Facts = dict[str, Any]

SHORT = 60  # letters of a value, where the values of several controls are listed


# ---- facts ----


def known_facts(
    asked: str, among: list[Control]
) -> tuple[list[Facts], list[Facts], CheckRule | None]:
    """Return what is called so: alarms, then codes, rules and parameters, and the rule of check or
    of gate.

    Raises `KeyError` for a number that no rule of check has.
    """
    of_gate = {name: rule for rule in GATE_RULES for name in (rule.number.lower(), rule.name)}
    check = of_gate.get(asked.lower())
    of_check = check is not None or re.fullmatch(r"CS\d*", asked, re.IGNORECASE) is not None
    if check is None and (of_check or asked.lower() in rule_names()):
        check = rule_named(asked)
    alarms = [] if of_check else explanations(asked, among)
    others = [*rule_explanations(asked, among), *parameter_explanations(asked, among)]
    if code_named(asked) is not None or not (check or alarms or others):
        others = [*code_explanations(asked, among), *others]
    return alarms, others, check


def rule_explanations(asked: str, among: list[Control]) -> list[Facts]:
    """Return what a rule says on controls."""
    found = [(c, rule) for c in among for rule in c.rules if rule.name == asked.casefold()]
    if not found:
        return []
    rule = found[0][1]
    names, examples = rule.choices or rule.entries, rule.examples
    return [
        {
            "kind": "rule",
            "name": rule.name,
            "group": rule.group,
            "meaning": rule.meaning,
            "choices": dict(zip(names, examples, strict=True)),
            "on": [
                {
                    "control": control.name,
                    "value": own.value,
                    "example": example_of(own),
                    "parameters": [p.name for p in control.parameters.values() if _sets(p, own)],
                    "source": own.source,
                    "evidence": own.evidence,
                }
                for control, own in found
            ],
        }
    ]


def _sets(parameter: Any, rule: Any) -> bool:
    return any(name.partition(":")[0] == rule.name for name in parameter.rules)


def parameter_explanations(asked: str, among: list[Control]) -> list[Facts]:
    """Return what a parameter does, an entry for each meaning that it has."""
    wanted = asked.strip().removeprefix("#").upper()
    entries: dict[tuple[str, str], Facts] = {}
    for control in among:
        parameter = control.parameters.get(wanted) or control.parameters.get(asked.strip())
        if parameter is None:
            continue
        effect = effect_of(parameter)
        entry = entries.setdefault(
            (parameter.meaning, effect),
            {
                "kind": "parameter",
                "name": parameter.name,
                "meaning": parameter.meaning,
                "effect": effect,
                "on": [],
            },
        )
        entry["on"].append(
            {
                "control": control.name,
                "value": parameter.value,
                "source": parameter.source,
                "evidence": parameter.evidence,
            }
        )
    return list(entries.values())


def near_facts(found: list[Entry]) -> list[Facts]:
    return [
        {"kind": "near", "name": one.name, "of": one.kind, "meaning": one.meaning} for one in found
    ]


# ---- text ----


def print_facts(console: Console, facts: list[Facts]) -> None:
    """Print codes, rules and parameters, one after the other: of one control in full."""
    whole = len({on["control"] for fact in facts for on in fact["on"]}) == 1
    for place, fact in enumerate(facts):
        if place:
            console.print()
        _PRINT[fact["kind"]](console, fact, whole)


def _print_code(console: Console, fact: Facts, whole: bool) -> None:
    on = fact["on"]
    alone = on[0] if whole else None
    place = f" on {_with_machines(alone)}" if alone else ""
    console.print(Text(f"{fact['code']}{place}", style="bold"))
    _line(console, fact["does"])
    if alone is None:
        _line(console, f"on {', '.join(map(_with_machines, on))}")
    arguments = alone["arguments"] if alone else {}
    width = max((len(word["letters"]) for word in fact["words"]), default=0)
    if fact["words"]:
        console.print(Text("  words", style="cyan"))
    for word in fact["words"]:
        given = ", ".join(f"{letter} {local}" for letter, local in arguments.items())
        says = f"{word['says']}: {given}" if given and "arguments" in word["says"] else word["says"]
        _line(console, f"{word['letters'].ljust(width)}  {says}", 4, hang=width + 2)
    if alone is not None:
        _print_on(console, alone)


def _with_machines(on: Facts) -> str:
    machines = ", ".join(on["machines"])
    return f"{on['control']} ({machines})" if machines else str(on["control"])


def _print_on(console: Console, on: Facts) -> None:
    for call in on["calls"]:
        _line(console, f"registered: {call['kind']} of O{call['program']}")
        _source(console, call)
    if on["rules"]:
        console.print(Text("  rules", style="cyan"))
    for rule in on["rules"]:
        example = f" ({rule['example']})" if rule["example"] else ""
        value = cut(_value(rule["value"]))
        _line(console, f"{rule['name']} = {value}{example}: {rule['meaning']}", 4)
        _source(console, rule)
    if on["alarms"]:
        console.print(Text("  alarms", style="cyan"))
    width = max((len(alarm["number"] or "-") for alarm in on["alarms"]), default=0)
    for alarm in on["alarms"]:
        number = (alarm["number"] or "-").ljust(width)
        _line(console, f"{number}  {alarm['cause']}: {alarm['meaning']}", 4, hang=width + 2)
    if on["sources"]:
        console.print(Text("  where it is known from", style="cyan"))
    for source in on["sources"]:
        if source["rule"]:
            _line(console, f"rule {source['rule']}", 4)
        _source(console, source)


def _print_rule(console: Console, fact: Facts, whole: bool) -> None:
    console.print(Text(f"{fact['name']}, a rule of {fact['group']}", style="bold"))
    _line(console, fact["meaning"])
    for on in fact["on"]:
        value = _value(on["value"])
        example = f": {on['example']}" if on["example"] else ""
        told = f"{on['control']}: {value if whole else cut(value)}{example}"
        if on["parameters"]:
            told += f" (set by parameter {', '.join(on['parameters'])})"
        _line(console, told)
        _source(console, on)
    if fact["choices"] and whole:
        console.print(Text("  what it may be", style="cyan"))
        for name, example in fact["choices"].items():
            _line(console, f"{name}: {example}", 4)


def _print_parameter(console: Console, fact: Facts, _whole: bool) -> None:
    console.print(Text(f"{fact['name']}, a parameter", style="bold"))
    _line(console, fact["meaning"])
    if fact["effect"]:
        _line(console, fact["effect"])
    for on in fact["on"]:
        _line(console, f"{on['control']}: {on['value']:g}")
        _source(console, on)


def print_check_rule(console: Console, rule: CheckRule) -> None:
    console.print(Text(f"{rule.number} {rule.name}, {rule.severity}", style="bold"))
    _line(console, f"finds: {rule.meaning}")
    _line(console, f"cure: {rule.hint}")
    console.print(f"  such as, on {rule.control}:")
    for line in rule.example.splitlines():
        console.print(f"      {line}")


def print_near(console: Console, asked: str, found: list[Entry]) -> None:
    console.print(f"nothing is called {shown(repr(asked))}; nearest by meaning:")
    width = max(len(entry.name) for entry in found)
    for entry in found:
        line = f"{entry.name.ljust(width)}  {entry.kind}: {entry.meaning}"
        _line(console, line, hang=width + 2)
    console.print("`cncsub explain NAME` tells more of one")


_PRINT: dict[str, Callable[[Console, Facts, bool], None]] = {
    "code": _print_code,
    "rule": _print_rule,
    "parameter": _print_parameter,
}


def _value(value: object) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return str(value) or "none"


def cut(text: str) -> str:
    return text if len(text) <= SHORT else f"{text[: SHORT - 4]} ..."


def _source(console: Console, of: Facts) -> None:
    for part in wrapped(console, f"      [{of['source']}; {of['evidence']}]", "       "):
        console.print(Text(part, style="dim"))


def _line(console: Console, text: str, indent: int = 2, *, hang: int = 2) -> None:
    blank = " " * indent
    for part in wrapped(console, blank + shown(text), " " * (indent + hang)):
        console.print(part)
