"""Other values of a rule: a control with one shows whether a program depends on the rule."""

from __future__ import annotations

import functools
from collections.abc import Iterator, Mapping
from typing import Any

from cncsub.controls import Control, controls


def rule_named(control: Control, name: str) -> Any:
    """Return a rule of a control; `None` of a group that the control does not have."""
    return _rules(control).get(name)


@functools.lru_cache(maxsize=4)
def _rules(control: Control) -> Mapping[str, Any]:
    return {rule.name: rule for rule in control.rules}


def entries_of(rule: Any) -> list[str]:
    """Return the entries of a set; of roles, which any code may have, those of the control."""
    return str(rule.value).split() if rule.name == "roles" else list(rule.entries)


@functools.cache
def answers(name: str) -> Mapping[str, Any]:
    """Return what a control answers, by the names of its rules."""
    return {rule.name: rule.value for rule in controls[name].rules}


def mutants(control: Control, word: str) -> Iterator[Control]:
    """Yield the control with another value of the rule, for each value worth trying. `word` is the
    name of a rule, or of an entry of a set: `refuses:jump-in-mdi`.
    """
    yield from (mutant for _, mutant in changed(control, word))


def changed(control: Control, word: str) -> Iterator[tuple[Any, Control]]:
    """Yield the other values of a rule, each with the control that has it; of an entry, whether it
    is in the set.
    """
    name, _, entry = word.partition(":")
    rule = rule_named(control, name)
    if rule is None:
        return
    if entry:
        there = entry in str(rule.value).split()
        yield not there, control.replace(**{name: f"-{entry}" if there else entry})
        return
    whole = "=" if isinstance(rule.value, str) and not rule.choices else ""  # a whole list
    options = [o.name for o in control.variable_options.values() if o.rule == rule.name]
    for value in [*other_values(rule), *options]:
        try:
            yield value, control.replace(**{rule.name: whole + value if whole else value})
        except ValueError:
            continue  # the rule cannot take the value


def other_values(rule: Any) -> list[Any]:
    """Return the values to try: near numbers, other choices, a list with an entry less or more."""
    if isinstance(rule.value, bool):
        return [not rule.value]
    if isinstance(rule.value, int):
        return [rule.value + step for step in (1, -1) if rule.value + step >= 0]
    if rule.choices:
        return [value for value in rule.choices if value != rule.value]
    return [value for value in _other_lists(rule) if value != rule.value]


def _other_lists(rule: Any) -> Iterator[str]:
    """Yield a list of letters or codes without one of its entries, and lists of other controls."""
    separator = " " if " " in rule.value or len(rule.value) > 30 or rule.entries else ""
    entries = rule.value.split() if separator else list(rule.value)
    for entry in dict.fromkeys(entries):
        yield separator.join(other for other in entries if other != entry)
    yield from sorted({str(answers(control).get(rule.name, "")) for control in controls})
