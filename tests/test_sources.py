"""Sources follow values, and no fact is stronger than its sources are on its control."""

from __future__ import annotations

import pickle
from collections.abc import Iterator

import pytest
from hypothesis import given
from hypothesis import strategies as st

import cncsub
from cncsub import _core
from cncsub.controls import EVIDENCE

EVERY = list(cncsub.controls)


def facts(control: cncsub.Control) -> Iterator[tuple[str, str, str]]:
    """What it is, its source and its evidence."""
    for rule in control.rules:
        yield rule.name, rule.source, rule.evidence
    for parameter in control.parameters.values():
        yield parameter.name, parameter.source, parameter.evidence
    for alarm in control.alarms.values():
        yield alarm.cause, alarm.source, alarm.evidence


def answers(control: cncsub.Control) -> dict[str, object]:
    return {rule.name: rule.value for rule in control.rules}


def origins(control: cncsub.Control) -> dict[str, tuple[str, str]]:
    return {rule.name: (rule.source, rule.evidence) for rule in control.rules}


@pytest.mark.parametrize("name", EVERY)
def test_no_fact_is_stronger_than_its_sources_are_there(name: str) -> None:
    stronger = []
    for what, text, evidence in facts(cncsub.controls[name]):
        at_best = [cncsub.sources[key].on(name) for key in _core.cited(text)] or ["inferred"]
        if EVIDENCE.index(evidence) < min(map(EVIDENCE.index, at_best)):
            stronger.append((what, text, evidence))
    assert stronger == []


def test_a_manual_of_another_control_is_secondary() -> None:
    for source in cncsub.sources.values():
        assert set(source.controls) <= set(EVERY)
        for name in set(EVERY) - set(source.controls):
            assert EVIDENCE.index(source.on(name)) >= EVIDENCE.index("secondary"), source.key


def test_a_source_is_cited_by_the_longest_key_that_stands_as_a_word() -> None:
    assert _core.cited("TA27, note 3; TApar 3403#6, TA28; Talm 212") == ["TA", "TApar", "Talm"]
    assert _core.cited("CW-A; CW, levels; IMD2, IMD") == ["CW-A", "CW", "IMD2", "IMD"]
    assert _core.cited("M7 p.52 and M70; M72; TAB; the 30i; 30i p.82") == ["M7 p", "30i p"]
    assert _core.cited("") == []


@pytest.mark.parametrize("name", EVERY)
def test_a_family_default_is_the_default_of_the_family(name: str) -> None:
    rules = cncsub.controls[name].rules
    assert [r.name for r in rules if r.source == "family default" and r.value != r.family] == []


@pytest.mark.parametrize("name", EVERY)
def test_a_parameter_and_its_rule_agree_as_delivered(name: str) -> None:
    control = cncsub.controls[name]
    for parameter in control.parameters.values():
        again = control.with_parameters({parameter.name: parameter.value})
        assert answers(again) == answers(control), parameter.name


@given(data=st.data())
def test_a_rule_that_a_parameter_changes_names_the_parameter(data: st.DataObject) -> None:
    control = cncsub.controls[data.draw(st.sampled_from(EVERY))]
    name = data.draw(st.sampled_from(list(control.parameters) or [""]))
    if not name:
        return
    value = data.draw(st.integers(0, 1) if "#" in name else st.integers(0, 9999))
    changed = control.with_parameters({name: value})
    before, after = answers(control), answers(changed)
    now, then = origins(changed), origins(control)
    for rule in after:
        same = after[rule] == before[rule]
        assert now[rule] == (
            then[rule] if same else (f"set by parameter {name} = {value}", "inferred")
        )
    assert origins(pickle.loads(pickle.dumps(changed))) == now


def test_a_rule_that_the_caller_sets_says_so() -> None:
    for control in cncsub.controls.values():
        changed = control.replace(max_nesting=7)
        assert origins(changed)["max_nesting"] == ("set by the caller", "inferred")
        others = origins(changed).items() - origins(control).items()
        assert {name for name, _ in others} == {"max_nesting"}


def test_every_source_is_cited_by_its_key_alone() -> None:
    for key, source in cncsub.sources.items():
        assert _core.cited(f"{key}, note") == [key]
        assert source.title
