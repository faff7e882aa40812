"""Changes one rule of a control at a time, and finds a row that notices.

`pins.json` names that row for every rule of every control. The test of it runs these rows alone;
`python tests/conformance/mutation.py` searches all rows and writes the file anew, which takes a
minute or two. A rule that no row can notice on a control stands in `unpinned.py`, with the reason.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import cncsub
from conformance import Case, rows
from outcome import differences

FILE = Path(__file__).parent / "pins.json"
HOW_TO_WRITE = "python tests/conformance/mutation.py writes pins.json anew"

# From this rule on the rules are about moves; no row notices them without looking at moves.
FIRST_MOTION_RULE = "machine"

# Control, rule, and the claim of the row that notices.
Pins = dict[str, dict[str, str]]


def read_pins() -> Pins:
    pins: Pins = json.loads(FILE.read_text(encoding="utf-8"))
    return pins


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


def find_pins() -> Pins:
    """Search all rows; a rule that no row notices is left out."""
    cases = {
        name: [row.case for row in rows() if row.control == name and passes(row.case, control)]
        for name, control in cncsub.controls.items()
    }
    places = {name: place for place, name in enumerate(_rule_names())}
    pins: Pins = {name: {} for name in cncsub.controls}
    for name in places:
        tried_first: list[str] = []
        for control in cncsub.controls.values():
            found = _find(name, control, cases[control.name], tried_first)
            if found is not None:
                pins[control.name][name] = found.claim
                tried_first[:0] = [found.claim, found.topic]
    return pins


def _rule_names() -> list[str]:
    return [rule.name for rule in next(iter(cncsub.controls.values())).rules]


def _find(
    name: str, control: cncsub.Control, cases: list[Case], tried_first: list[str]
) -> Case | None:
    """A rule means the same on every control: the row, then the topic, that noticed it elsewhere
    is likely to notice it here too.
    """
    rule = next(rule for rule in control.rules if rule.name == name)
    if is_about_moves(control, rule):
        cases = [case for case in cases if case.wants_moves or "motion" in case.topic]

    def rank(case: Case) -> tuple[int, int]:
        return _place(tried_first, case.claim), _place(tried_first, case.topic)

    changed = list(mutants(control, rule))
    for case in sorted(cases, key=rank):
        if any(not passes(case, mutant) for mutant in changed):
            return case
    return None


def _place(names: list[str], name: str) -> int:
    return names.index(name) if name in names else len(names)


def main() -> None:
    pins = find_pins()
    FILE.write_text(json.dumps(pins, indent=1, ensure_ascii=True) + "\n", encoding="utf-8")
    count = sum(map(len, pins.values()))
    print(f"{count} pins of {len(_rule_names()) * len(pins)} rules", file=sys.stderr)


if __name__ == "__main__":
    main()
