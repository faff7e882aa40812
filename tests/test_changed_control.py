"""A changed control: its name, when it equals another one, and its TOML."""

from __future__ import annotations

import copy
import pickle
from pathlib import Path
from typing import Any

import pytest

import cncsub

FANUC = cncsub.controls["fanuc-0i-f"]
SHEET = """
name = "our-mill"
base = "fanuc-0i-f"
title = "The mill \\"in\\" hall 3"

[rules]
max_nesting = { value = 2, note = "the sheet, page 12" }
refuses = [
    { value = "program-number-zero", note = "the \\"sheet\\", page 13" },
    { value = "-jump-in-mdi", note = "seen" },
]

[parameters]
"6005#0" = { value = 1, note = "set when the machine came" }
6050 = 70

[calls]
M60 = { value = "macro-call:9020", note = "the pallet changer" }
G200 = "macro-call:9021"

[alarms]
nesting-too-deep = { number = "PS9077", text = "TOO DEEP HERE", note = "seen on the screen" }
program-not-found = "PS9078"
"""


def again(control: cncsub.Control, tmp_path: Path) -> cncsub.Control:
    file = tmp_path / "our-mill.toml"
    file.write_text(control.to_toml(), encoding="utf-8")
    return cncsub.Control.from_toml(file)


def own(tmp_path: Path) -> cncsub.Control:
    file = tmp_path / "our-mill.toml"
    file.write_text(SHEET, encoding="utf-8")
    return cncsub.Control.from_toml(file)


def facts(control: cncsub.Control) -> list[Any]:
    """Return all that a control says, with where it comes from."""
    return [
        [(r.name, r.value, r.source, r.evidence, r.sources) for r in control.rules],
        [(p.name, p.value, p.source, p.evidence) for p in control.parameters.values()],
        [(a.cause, a.number, a.text, a.source, a.evidence) for a in control.alarms.values()],
    ]


# ---- the name ----


@pytest.mark.parametrize(
    ("control", "name"),
    [
        (FANUC, "fanuc-0i-f"),
        (FANUC.replace(max_nesting=3), "fanuc-0i-f + max_nesting=3"),
        (FANUC.with_parameters({"6005#0": 1}), "fanuc-0i-f + 6005#0=1"),
        (
            FANUC.replace(max_nesting=3).with_parameters({"6050": 70, "6005#0": 1}),
            "fanuc-0i-f + 6005#0=1, 6050=70, max_nesting=3",
        ),
        (FANUC.replace(g_meanings="68.2=neutral"), "fanuc-0i-f + g_meanings=68.2=neutral"),
        (FANUC.replace(max_nesting=3).replace(max_nesting=10), "fanuc-0i-f"),
        (FANUC.with_parameters({"6005#0": 1}).with_parameters({"6005#0": 0}), "fanuc-0i-f"),
    ],
)
def test_the_name_tells_what_was_changed(control: cncsub.Control, name: str) -> None:
    assert control.name == name
    assert repr(control) == f"<Control {name}: FANUC Series 0i-F>"
    assert control.base == "fanuc-0i-f"


def test_of_many_changes_the_name_tells_the_first_and_counts_the_others() -> None:
    changed = FANUC.with_parameters({f"6001#{bit}": 1 for bit in (4, 5)} | {"6050": 1, "6051": 2})
    changed = changed.replace(max_nesting=3, max_loops=2)
    assert changed.name.count("=") == 4
    assert changed.name.endswith(", and 2 more")


def test_a_long_value_is_cut_in_the_name() -> None:
    name = FANUC.replace(commons="100-149 500-531 540 541 542 543 544 545 546 547").name
    assert name == "fanuc-0i-f + commons=100-149 500-531 540 541 542 543 544 545 ..."


def test_a_library_is_shown_with_the_name() -> None:
    library = cncsub.loads("O1\nM30\n", control=FANUC.replace(max_nesting=3))
    assert repr(library) == "<Library of fanuc-0i-f + max_nesting=3, 1 program: O1>"


def test_what_a_caller_changes_of_an_own_control_stands_after_its_name(tmp_path: Path) -> None:
    control = own(tmp_path)
    assert control.name == "our-mill"
    changed = control.replace(max_nesting=3, refuses="jump-in-mdi").with_parameters({"6005#0": 0})
    assert changed.name == "our-mill + 6005#0=0, refuses=jump-in-mdi, max_nesting=3"


# ---- equality ----


def test_controls_that_answer_alike_are_equal() -> None:
    changed = FANUC.replace(max_nesting=3)
    assert changed == FANUC.replace(max_nesting=3) != FANUC
    assert len({FANUC, changed, FANUC.replace(max_nesting=3), FANUC.replace(max_nesting=10)}) == 2
    assert cncsub.controls["fanuc-30i"] != FANUC
    assert FANUC.with_parameters({"6050": 70}) != FANUC.with_parameters({"6050": 71})
    assert FANUC.__eq__("fanuc-0i-f") is NotImplemented
    assert FANUC != "fanuc-0i-f"


def test_a_control_equals_its_copies(tmp_path: Path) -> None:
    for control in (FANUC, FANUC.replace(max_nesting=3), own(tmp_path)):
        for same in (
            copy.copy(control),
            copy.deepcopy(control),
            pickle.loads(pickle.dumps(control)),
        ):
            assert same == control
            assert hash(same) == hash(control)


def test_own_controls_differ_by_name_and_alarm(tmp_path: Path) -> None:
    control = own(tmp_path)
    for old, new in (("our-mill", "your-mill"), ("PS9077", "PS9079"), ("TOO DEEP", "DEEP")):
        file = tmp_path / "other.toml"
        file.write_text(SHEET.replace(old, new), encoding="utf-8")
        assert cncsub.Control.from_toml(file) != control


# ---- TOML ----


@pytest.mark.parametrize("name", list(cncsub.controls))
def test_a_changed_control_is_written_and_read_again(name: str, tmp_path: Path) -> None:
    control = cncsub.controls[name]
    parameters = {p: v.value + 1 for p, v in control.parameters.items() if "#" not in p}
    rules: dict[str, Any] = {}
    for rule in control.rules:
        if isinstance(rule.value, bool | int):
            rules[rule.name] = not rule.value if isinstance(rule.value, bool) else rule.value + 1
        elif rule.choices:
            rules[rule.name] = next(choice for choice in rule.choices if choice != rule.value)
        elif rule.value and rule.name not in ("commons", "variable_options"):
            rules[rule.name] = f"-{rule.value.split()[0].partition('=')[0]}"
    for rule_name, value in rules.items():
        try:
            changed = control.replace(**{rule_name: value})
        except ValueError:
            continue  # some values fit no rule beside them
        assert again(changed, tmp_path) == changed != control
    changed = control.with_parameters(parameters)
    assert again(changed, tmp_path) == changed


def test_the_toml_of_a_changed_control_holds_what_was_changed() -> None:
    changed = FANUC.with_parameters({"6005#0": 1, "6050": 0.5})
    changed = changed.replace(refuses="program-number-zero -jump-in-mdi", max_nesting=3)
    assert changed.to_toml() == (
        'base = "fanuc-0i-f"\n\n[rules]\n'
        'refuses = "program-number-zero -jump-in-mdi"\nmax_nesting = 3\n'
        '\n[parameters]\n"6005#0" = 1\n6050 = 0.5\n'
    )


def test_an_own_control_keeps_its_notes(tmp_path: Path) -> None:
    control = own(tmp_path)
    text = control.to_toml()
    assert "without a note" not in text.replace("G200: as our-mill.toml says, without a note", "")
    read = again(control, tmp_path)
    assert read == control
    assert facts(read) == facts(control)
    assert (read.name, read.title) == ("our-mill", 'The mill "in" hall 3')


def test_a_changed_own_control_keeps_its_name_and_its_changes(tmp_path: Path) -> None:
    changed = own(tmp_path).replace(max_nesting=3, refuses="illegal-repeat-count")
    changed = changed.with_parameters({"6050": 71})
    read = again(changed, tmp_path)
    assert (read, read.name, facts(read)) == (changed, changed.name, facts(changed))


def test_a_project_may_name_a_changed_control(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from cncsub.cli.project import find_project

    (tmp_path / "cncsub.toml").write_text(
        '[control]\nbase = "fanuc-0i-f"\nrules.max_nesting = 3\n', encoding="utf-8"
    )
    project = find_project(tmp_path)
    assert project.control == "fanuc-0i-f + max_nesting=3"
    assert project.control_named(project.control) == FANUC.replace(max_nesting=3)


# ---- mistyped rules ----


@pytest.mark.parametrize(
    ("typed", "near"),
    [("max_nestng", "max_nesting"), ("nesting", "max_nesting"), ("Max_Nesting", "max_nesting")],
)
def test_a_mistyped_rule_is_answered_with_the_nearest(typed: str, near: str) -> None:
    with pytest.raises(ValueError, match=f"there is no rule {typed}; did you mean {near}"):
        FANUC.replace(**{typed: 3})


def test_a_rule_like_none_is_answered_with_where_they_are_listed() -> None:
    with pytest.raises(ValueError, match="cncsub controls fanuc-0i-f --all"):
        FANUC.replace(xyzzy=3)
