"""Changes one rule of a control at a time, and looks for a row that notices."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from typing import Any

import cncsub
from conformance import Case, Row
from outcome import differences


def survivors(rows: list[Row]) -> Iterator[str]:
    """Every changed rule that no row notices, written as `control: rule = value`.

    A rule that has no other value to try counts as one that nobody notices: `control: rule`.
    """
    killers = Killers()
    seen: defaultdict[str, set[Any]] = defaultdict(set)
    for control in cncsub.controls.values():
        for rule in control.rules:
            seen[rule.name].add(rule.value)
    for name, control in cncsub.controls.items():
        cases = [row.case for row in rows if row.control == name]
        cases = [case for case in cases if passes(case, control)]
        for rule in control.rules:
            values = list(mutants(control, rule, seen[rule.name]))
            if not values:
                yield f"{name}: {rule.name}"
            for value, mutant in values:
                if not killers.kill(rule.name, mutant, cases):
                    yield f"{name}: {rule.name} = {value}"


def mutants(
    control: cncsub.Control, rule: Any, seen: set[Any]
) -> Iterator[tuple[Any, cncsub.Control]]:
    """The control with every other admissible value of the rule."""
    for value in other_values(rule, seen):
        try:
            yield value, control.replace(**{rule.name: value})
        except ValueError:
            continue  # A neighbouring number the rule cannot take.


def other_values(rule: Any, seen: set[Any]) -> list[Any]:
    """The values to try; `seen` are those that any control has for the rule."""
    if isinstance(rule.value, bool):
        return [not rule.value]
    if isinstance(rule.value, int):
        return [rule.value + step for step in (-1, 1) if rule.value + step >= 0]
    if rule.choices:
        return [value for value in rule.choices if value != rule.value]
    # A list of letters or codes: what the other controls have, or else all but one.
    return sorted(seen - {rule.value}) or [rule.value[:-1].rstrip()] * bool(rule.value)


def passes(case: Case, control: cncsub.Control) -> bool:
    try:
        return next(differences(case, control), None) is None
    except Exception:  # A changed rule may break anything, and that is noticed too.
        return False


class Killers:
    """Runs the rows in the order in which they are likely to notice a changed rule.

    A rule means the same on every control: the row, and then the topic, that noticed it on one
    control is tried first on the next.
    """

    def __init__(self) -> None:
        self._cases: defaultdict[str, list[str]] = defaultdict(list)
        self._topics: defaultdict[str, list[str]] = defaultdict(list)

    def kill(self, rule: str, mutant: cncsub.Control, cases: list[Case]) -> bool:
        for case in sorted(cases, key=lambda case: self._rank(rule, case)):
            if not passes(case, mutant):
                _to_front(self._cases[rule], case.claim)
                _to_front(self._topics[rule], case.topic)
                return True
        return False

    def _rank(self, rule: str, case: Case) -> tuple[int, int]:
        return _place(self._cases[rule], case.claim), _place(self._topics[rule], case.topic)


def _to_front(names: list[str], name: str) -> None:
    if name in names:
        names.remove(name)
    names.insert(0, name)


def _place(names: list[str], name: str) -> int:
    return names.index(name) if name in names else len(names)
