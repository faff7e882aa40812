"""The tables themselves: their size, their sources, and that nothing of the engine escapes them."""

from __future__ import annotations

from collections import Counter

import cncsub
from conformance import EVIDENCE, cases, rows, topic_files
from mutation import survivors

MINIMUM_CASES = 900

# Rules that may be changed without any row noticing, each with the reason why no row can.
# Written as the test prints them: `control: rule = value`, or `control: rule` where a rule has
# no other value.
UNPINNED: dict[str, str] = {}


def test_there_are_enough_rows() -> None:
    assert len(cases()) >= MINIMUM_CASES


def test_every_topic_has_rows() -> None:
    topics = {case.topic for case in cases()}
    assert {file.stem for file in topic_files()} == topics


def test_about_half_of_the_rows_alarm() -> None:
    alarming = sum(case.alarm is not None for case in cases())
    assert 0.35 <= alarming / len(cases()) <= 0.65, f"{alarming} of {len(cases())}"


def test_every_claim_is_made_once() -> None:
    counts = Counter(case.claim for case in cases())
    assert [claim for claim, count in counts.items() if count > 1] == []


def test_every_row_says_where_it_comes_from() -> None:
    without = [
        f"{case.topic}.py:{case.line}: {case.claim}"
        for case in cases()
        if not case.source.strip() or case.evidence not in EVIDENCE
    ]
    assert without == []


def test_rows_run_on_controls_that_exist() -> None:
    assert {row.control for row in rows()} - set(cncsub.controls) == set()


def test_every_control_has_rows() -> None:
    assert set(cncsub.controls) - {row.control for row in rows()} == set()


def test_every_cause_is_raised_by_some_row() -> None:
    raised = {case.alarm for case in cases()} - {None}
    causes = set(cncsub.causes)
    assert sorted(raised - causes) == [], "causes that do not exist"
    assert sorted(causes - raised) == [], "causes that no row raises"


def test_every_cause_has_a_meaning_and_a_cure() -> None:
    silent = [slug for slug, cause in cncsub.causes.items() if not cause.meaning or not cause.cure]
    assert silent == []


def test_every_rule_has_a_meaning_and_a_source() -> None:
    silent = [
        f"{name}: {rule.name}"
        for name, control in cncsub.controls.items()
        for rule in control.rules
        if not rule.meaning or not rule.source or rule.evidence not in EVIDENCE
    ]
    assert silent == []


def test_every_rule_is_pinned() -> None:
    """Change any rule of any control, and some row has to notice."""
    found = set(survivors(rows()))
    unexpected = sorted(found - set(UNPINNED))
    stale = sorted(set(UNPINNED) - found)
    assert unexpected == [], f"no row notices:\n{chr(10).join(unexpected)}"
    assert stale == [], f"these are noticed by now:\n{chr(10).join(stale)}"
