"""The rules that apply to the language of a control: the control shows and takes no others."""

from __future__ import annotations

import pytest

import cncsub

NAMES = list(cncsub.controls)
ALL = {rule.name: rule for control in cncsub.controls.values() for rule in control.rules}


@pytest.mark.parametrize("name", NAMES)
def test_a_rule_that_it_does_not_show_is_refused_with_the_reason(name: str) -> None:
    control = cncsub.controls[name]
    for other in ALL.keys() - {rule.name for rule in control.rules}:
        with pytest.raises(
            ValueError, match=rf"{name} (does not use the rule {other}|has no rules of)"
        ):
            control.replace(**{other: ALL[other].value})


def test_the_parameters_of_a_control_set_rules_that_it_shows() -> None:
    for control in cncsub.controls.values():
        shown = {rule.name for rule in control.rules}
        set_by = {rule.partition(":")[0] for p in control.parameters.values() for rule in p.rules}
        assert set_by <= shown, control.name


@pytest.mark.parametrize("name", ["linuxcnc", "siemens-one"])
def test_a_language_of_its_own_asks_few_of_the_rules_of_reading_and_macros(name: str) -> None:
    shown = {rule.name for rule in cncsub.controls[name].rules}
    assert {"semicolon", "max_loops", "if_form", "omitted_program"} & shown == set()
    assert {"max_nesting", "main_return", "roles", "dwell_words"} <= shown
    with pytest.raises(ValueError, match="there is no rule max_lops"):
        cncsub.controls[name].replace(max_lops=2)
