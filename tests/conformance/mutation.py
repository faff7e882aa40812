"""Changes one rule of a control at a time: a row that pins the rule has to fail.

A row says what it pins, `pins="zero_repeats"`; for a set it names the entry,
`pins="conditions:bare"`, which is then taken away or put in. Every rule of every control, and every
entry that a set may have, needs such a row: its own, or one of a control with the same answer if it
holds on this control too. So a relative needs rows only for what it answers otherwise. Of the set
`refuses` and of roles, only the entries that some row pins need one. For the others the command
`python tests/conformance/mutation.py` names the rows that could pin them. A rule that no row can
notice on a control has its reason in `unpinned.py` or with the rows (`inert`), which holds for
relatives that answer alike too.
"""

from __future__ import annotations

import dataclasses
import functools
import sys
from collections.abc import Iterator
from typing import Any

import cncsub
from cncsub.questions.values import answers, entries_of, mutants
from cncsub.testing.outcome import differences
from conformance import Case, Row, rows
from unpinned import UNPINNED

HOW_TO_FIND = "python tests/conformance/mutation.py names rows that could"

# No row notices the rules of these groups without looking at moves.
MOTION = ("motion", "turning")


def pinning(control: str, word: str) -> list[Case]:
    """Return the rows of a control that say that they pin a rule, or an entry of a set."""
    return [case for case, name in rows_that_pin().get(word, ()) if name == control]


@functools.cache
def rows_that_pin() -> dict[str, list[Row]]:
    """Return the rows by what they pin, in the order of the rows."""
    by_word: dict[str, list[Row]] = {}
    for row in rows():
        for word in row.case.pins:
            by_word.setdefault(word, []).append(row)
    return by_word


def words(control: cncsub.Control) -> Iterator[str]:
    """Yield what can be pinned: the rules, and the entries that may be in a set."""
    said = rows_that_pin()
    for rule in control.rules:
        entries = entries_of(rule)
        if not entries:
            yield rule.name
        for entry in entries:
            word = f"{rule.name}:{entry}"
            if rule.name not in ("refuses", "roles") or word in said:
                yield word


def unpinned() -> list[tuple[str, str]]:
    """Return the controls and words that no row which pins them notices."""
    return [
        (name, word)
        for name, control in cncsub.controls.items()
        for word in words(control)
        if not excused(control, word)
        and not any(notices(case, control, word) for case in pinning(name, word))
        and not any(
            passes(case, control) and notices(case, control, word) for case in lent(control, word)
        )
    ]


def excused(control: cncsub.Control, word: str) -> bool:
    """Return whether no row can notice it on the control, or on a relative that answers alike."""
    reasons = UNPINNED.get(word, {})
    own = answer(control.name, word)
    return control.name in reasons or any(
        name in reasons and answer(name, word) == own for name in kin(control.name)
    )


# The part of all rules in which a relative may answer otherwise.
APART = 0.15


@functools.cache
def kin(name: str) -> list[str]:
    """Return the controls that answer most rules as this one does."""
    own = answers(name)
    others = (other for other in cncsub.controls if other != name)
    return [o for o in others if sum(answers(o).get(r) != own[r] for r in own) <= APART * len(own)]


def answer(name: str, word: str) -> Any:
    """Return what a control answers: the value of a rule, or whether a set has an entry."""
    rule, _, entry = word.partition(":")
    value = answers(name).get(rule)
    return entry in str(value).split() if entry else value


def lent(control: cncsub.Control, word: str) -> Iterator[Case]:
    """Yield the rows that pin it on controls with the same answer."""
    claims = set()
    for case, other in rows_that_pin().get(word, ()):
        if other == control.name or case.claim in claims:
            continue
        if answer(other, word) == answer(control.name, word):
            claims.add(case.claim)
            yield on(case, control.name)


def on(case: Case, control: str) -> Case:
    """Return a row for another control, which has alarm numbers of its own."""
    return dataclasses.replace(case, controls=(control,), number={})


def notices(case: Case, control: cncsub.Control, word: str) -> bool:
    """Return whether some other value of the rule makes the row fail."""
    return any(not passes(case, mutant) for mutant in mutants(control, word))


def passes(case: Case, control: cncsub.Control) -> bool:
    try:
        return next(differences(case, control), None) is None
    except Exception:  # a changed rule may break anything; that counts as noticed
        return False


def is_about_moves(control: cncsub.Control, word: str) -> bool:
    return any(rule.name == word and rule.group in MOTION for rule in control.rules)


def could_pin(control: cncsub.Control, word: str) -> Iterator[Case]:
    """Yield the rows that notice the rule; those of its topic elsewhere come first."""
    cases = [row.case for row in rows() if row.control == control.name]
    if is_about_moves(control, word):
        cases = [case for case in cases if case.wants_moves or "motion" in case.topic]
    topics = {case.topic for case, _ in rows_that_pin().get(word, ())}
    for case in sorted(cases, key=lambda case: case.topic not in topics):
        if passes(case, control) and notices(case, control, word):
            yield case


def main() -> None:
    for name, word in unpinned():
        found = next(could_pin(cncsub.controls[name], word), None)
        place = "no row" if found is None else f"{found.topic}.py:{found.line}: {found.claim}"
        print(f"{name}: {word}: {place}", file=sys.stderr)


if __name__ == "__main__":
    main()
