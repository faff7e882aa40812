"""Sources follow values, and no fact is stronger than its sources are on its control."""

from __future__ import annotations

import pickle
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

import cncsub
from cncsub import _core
from cncsub.controls import EVIDENCE

EVERY = list(cncsub.controls)


def facts(control: cncsub.Control) -> Iterator[tuple[str, str, str]]:
    """Yield each fact, its source and its evidence."""
    for rule in control.rules:
        yield rule.name, rule.source, rule.evidence
        for entry, (source, evidence) in rule.sources.items():
            yield f"{rule.name}: {entry}", source, evidence
    for parameter in control.parameters.values():
        yield parameter.name, parameter.source, parameter.evidence
    for alarm in control.alarms.values():
        yield alarm.cause, alarm.source, alarm.evidence


def answers(control: cncsub.Control) -> dict[str, object]:
    return {rule.name: rule.value for rule in control.rules}


CODES = [*(f"M{code:02}" for code in range(1000)), "G65", "G66", "G66.1", "G67"]


def places(rule: _core.Rule) -> list[tuple[str, object]]:
    """Return a rule with its value, of a set each entry, of roles each code."""
    held = str(rule.value).split()
    if rule.name == "roles":
        roles = dict(entry.split("=") for entry in held)
        return [(f"roles:{code}", roles.get(code)) for code in CODES]
    return [(f"{rule.name}:{entry}", entry in held) for entry in rule.entries] or [
        (rule.name, rule.value)
    ]


def answers_by_entry(control: cncsub.Control) -> dict[str, object]:
    """Return the answers, those of sets entry by entry."""
    return dict(place for rule in control.rules for place in places(rule))


def origins(control: cncsub.Control) -> dict[str, tuple[str, str]]:
    """Return the sources of the answers, those of sets entry by entry."""
    return {
        place: rule.sources.get(place.partition(":")[2], (rule.source, rule.evidence))
        for rule in control.rules
        for place, _ in places(rule)
    }


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
    others = []
    for rule in cncsub.controls[name].rules:
        value, family = rule.value, rule.family
        if rule.entries or rule.name == "roles":  # the entries that have no source of their own
            value, family = (
                {e for e in str(those).split() if e.partition("=")[0] not in rule.sources}
                for those in (value, family)
            )
        if rule.source == "family default" and value != family:
            others.append(rule.name)
    assert others == []


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
    before, after = answers_by_entry(control), answers_by_entry(changed)
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


# The words in place of a source if there is none.
NO_SOURCE = re.compile(r"general knowledge|policy|inferred|^family default$")


@pytest.mark.parametrize("name", EVERY)
def test_every_fact_cites_a_known_source_or_says_that_it_has_none(name: str) -> None:
    control = cncsub.controls[name]
    texts = [(what, text) for what, text, _ in facts(control)]
    texts += [(option.name, option.source) for option in control.variable_options.values()]
    assert [t for t in texts if not _core.cited(t[1]) and not NO_SOURCE.search(t[1])] == []


def test_every_comment_of_the_engine_cites_a_known_source() -> None:
    """A source stands in square brackets at the end of a comment, or of a sentence in it."""
    root = Path(__file__).parents[1]
    unknown = []
    for file in sorted((root / "cpp").rglob("*")):
        text = file.read_text(encoding="utf-8") if file.suffix in (".cpp", ".hpp", ".def") else ""
        for comment in re.findall(r"(?:^[ \t]*//[^\n]*\n)+|//[^\n]*", text, re.M):
            words = re.sub(r"\s*\n\s*/*\s*", " ", comment)
            for cite in re.findall(r"(?<=[.,:;/a-z0-9] )\[([^#\[\]]{1,200})\](?=[.,;\s]|$)", words):
                code = re.match(r"--|\.\.\.|[a-z]+$|\d \+", cite) or file.parent.name == "fuzz"
                if not code and not _core.cited(cite) and not NO_SOURCE.search(cite):
                    unknown.append(f"{file.relative_to(root)}: [{cite}]")
    assert unknown == []


def set_by(control: cncsub.Control, name: str) -> set[str]:
    """Return the rules, of sets the entries, that some value of a parameter changes."""
    before, changed = answers_by_entry(control), set()
    for value in (0, 1) if "#" in name else (0, 1, 2, 30):
        after = answers_by_entry(control.with_parameters({name: value}))
        changed |= {place for place in after if after[place] != before[place]}
    return changed


# Two bits that decide one thing together: the second counts if the first is 0.
TOGETHER = {("5001#0", "5001#1")}


@pytest.mark.parametrize("name", EVERY)
def test_no_two_parameters_set_one_rule(name: str) -> None:
    owner: dict[str, str] = {}
    for parameter in cncsub.controls[name].parameters.values():
        for place in parameter.rules:
            other = owner.setdefault(place, parameter.name)
            together = other == parameter.name or (other, parameter.name) in TOGETHER
            assert together, (place, other, parameter.name)


@pytest.mark.parametrize("name", EVERY)
def test_a_parameter_sets_the_rules_that_it_names_and_no_other(name: str) -> None:
    control = cncsub.controls[name]
    for parameter in control.parameters.values():
        assert parameter.rule == (parameter.rules[0] if parameter.rules else None)
        places = {
            place.partition(":")[0] if place.startswith("roles:") else place
            for place in set_by(control, parameter.name)
        }
        assert places == set(parameter.rules), parameter.name


def test_of_two_bits_that_say_one_thing_the_first_counts_in_whatever_order_they_are_set() -> None:
    control = cncsub.controls["fanuc-0i-f"]
    both = {answers(control.with_parameters(order))["length_type"] for order in (
        {"5001#0": 1, "5001#1": 1}, {"5001#1": 1, "5001#0": 1},
    )}  # fmt: skip
    assert both == {"named"}


def test_an_entry_that_the_caller_sets_is_the_callers_and_the_others_are_not() -> None:
    control = cncsub.controls["gsk-988ta"]
    changed = control.replace(refuses="illegal-repeat-count -spindle-stopped")
    now, then = origins(changed), origins(control)
    theirs = {place for place in now if now[place] != then[place]}
    assert theirs == {"refuses:illegal-repeat-count", "refuses:spindle-stopped"}
    assert {now[place] for place in theirs} == {("set by the caller", "inferred")}
    again = pickle.loads(pickle.dumps(changed))
    assert (origins(again), answers(again)) == (now, answers(changed))


def test_every_source_is_cited_by_its_key_alone() -> None:
    for key, source in cncsub.sources.items():
        assert _core.cited(f"{key}, note") == [key]
        assert source.title
