"""The tables themselves: their size, their sources, and that nothing of the engine escapes them."""

from __future__ import annotations

from collections import Counter

import cncsub
from conformance import EVIDENCE, cases, rows, topic_files
from mutation import HOW_TO_WRITE, notices, read_pins
from unpinned import UNPINNED

MINIMUM_CASES = 900


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
    """Change any rule of any control, and the row that pins it has to notice."""
    pins = read_pins()
    by_place = {(row.control, row.case.claim): row.case for row in rows()}
    missing, idle = [], []
    for name, control in cncsub.controls.items():
        for rule in control.rules:
            claim = pins.get(name, {}).get(rule.name)
            if claim is None:
                if name not in UNPINNED.get(rule.name, {}):
                    missing.append(f"{name}: {rule.name}")
                continue
            case = by_place.get((name, claim))
            if case is None or not notices(case, control, rule):
                idle.append(f"{name}: {rule.name}: {claim}")
    assert idle == [], f"{HOW_TO_WRITE}; these rows pin nothing:\n{chr(10).join(idle)}"
    assert missing == [], f"{HOW_TO_WRITE}; no row is known for:\n{chr(10).join(missing)}"


def test_what_is_unpinned_is_pinned_nowhere_else() -> None:
    pins = read_pins()
    both = [
        f"{control}: {rule}"
        for rule, reasons in UNPINNED.items()
        for control in reasons
        if rule in pins.get(control, {})
    ]
    known = {rule.name for control in cncsub.controls.values() for rule in control.rules}
    assert both == []
    assert set(UNPINNED) <= known
