"""Changes one rule of a control at a time: a row that pins the rule has to fail.

A row says what it pins, `pins="zero_repeats"`. For every rule of every control there is one;
`python tests/conformance/mutation.py` says for the rules that have none which rows could. A rule
that no row can notice on a control stands in `unpinned.py`, with the reason.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from typing import Any

import cncsub
from conformance import Case, rows
from outcome import differences
from unpinned import UNPINNED

HOW_TO_FIND = "python tests/conformance/mutation.py names rows that could"

# From this rule on the rules are about moves; no row notices them without looking at moves.
FIRST_MOTION_RULE = "machine"


def pinning(control: str, rule: str) -> list[Case]:
    """The rows of a control that say that they pin a rule."""
    return [row.case for row in rows() if row.control == control and rule in row.case.pins]


def unpinned() -> list[tuple[str, Any]]:
    """The rules, by control, that no row which says so notices."""
    return [
        (name, rule)
        for name, control in cncsub.controls.items()
        for rule in control.rules
        if name not in UNPINNED.get(rule.name, {})
        and not any(notices(case, control, rule) for case in pinning(name, rule.name))
    ]


def notices(case: Case, control: cncsub.Control, rule: Any) -> bool:
    """Whether some other value of the rule makes the row fail."""
    return any(not passes(case, mutant) for mutant in mutants(control, rule))


def mutants(control: cncsub.Control, rule: Any) -> Iterator[cncsub.Control]:
    """The control with another value of the rule, for each value worth trying."""
    whole = "=" if isinstance(rule.value, str) and not rule.choices else ""  # a list as a whole
    options = [o.name for o in control.variable_options.values() if o.rule == rule.name]
    for value in [*other_values(rule), *options]:
        try:
            yield control.replace(**{rule.name: whole + value if whole else value})
        except ValueError:
            continue  # A value the rule cannot take.


def other_values(rule: Any) -> list[Any]:
    """The other values to try: near numbers, other choices, a list with an entry less or more."""
    if isinstance(rule.value, bool):
        return [not rule.value]
    if isinstance(rule.value, int):
        return [rule.value + step for step in (1, -1) if rule.value + step >= 0]
    if rule.choices:
        return [value for value in rule.choices if value != rule.value]
    return [value for value in _other_lists(rule) if value != rule.value]


def _other_lists(rule: Any) -> Iterator[str]:
    """A list of letters or codes without one of its entries, and as other controls have it."""
    separator = " " if " " in rule.value or len(rule.value) > 30 else ""
    entries = rule.value.split() if separator else list(rule.value)
    for entry in dict.fromkeys(entries):
        yield separator.join(other for other in entries if other != entry)
    yield from sorted({_value_on(control, rule.name) for control in cncsub.controls.values()})


def _value_on(control: cncsub.Control, rule: str) -> str:
    return next(str(other.value) for other in control.rules if other.name == rule)


def passes(case: Case, control: cncsub.Control) -> bool:
    try:
        return next(differences(case, control), None) is None
    except Exception:  # A changed rule may break anything, and that is noticed too.
        return False


def is_about_moves(control: cncsub.Control, rule: Any) -> bool:
    names = [other.name for other in control.rules]
    return names.index(rule.name) >= names.index(FIRST_MOTION_RULE)


def could_pin(control: cncsub.Control, rule: Any) -> Iterator[Case]:
    """The rows that notice the rule; those of its topic elsewhere first."""
    cases = [row.case for row in rows() if row.control == control.name]
    if is_about_moves(control, rule):
        cases = [case for case in cases if case.wants_moves or "motion" in case.topic]
    topics = {row.case.topic for row in rows() if rule.name in row.case.pins}
    for case in sorted(cases, key=lambda case: case.topic not in topics):
        if passes(case, control) and notices(case, control, rule):
            yield case


def main() -> None:
    for name, rule in unpinned():
        found = next(could_pin(cncsub.controls[name], rule), None)
        place = "no row" if found is None else f"{found.topic}.py:{found.line}: {found.claim}"
        print(f"{name}: {rule.name}: {place}", file=sys.stderr)


if __name__ == "__main__":
    main()
