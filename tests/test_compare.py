"""The same programs on two controls, two versions of programs on one: where they part, and why."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import cncsub

sys.path.insert(0, str(Path(__file__).with_name("conformance")))
import mutation
from cncsub.testing import outcome
from conformance import Case, rows

MILL = "fanuc-0i-f"


def changed(program: str, control: str = MILL, **rules: Any) -> cncsub.Comparison:
    """A program on a control and on the same with other values for some rules."""
    one = cncsub.controls[control]
    library = cncsub.loads(program, control=one)
    return cncsub.compare(library, controls=[one, one.replace(**rules)])


CALL = "O1\nN10 M98 P2 L0\nN20 M30\nO2\nN30 M99\n"


def test_the_same_is_the_same() -> None:
    compared = cncsub.compare(
        cncsub.loads(CALL, control=MILL), controls=["fanuc-0i-f", "fanuc-0i-d"]
    )
    assert compared.same
    assert (compared.where, compared.rules, str(compared)) == (None, (), "the same")
    assert [run.stop for run in compared.runs] == ["end", "end"]


# program, rules changed, what is told of each
CHANGES: list[tuple[str, dict[str, Any], str]] = [
    (
        CALL,
        {"zero_repeats": "skip"},
        "first: O1 N10, line 2: M98 O2, 1 pass\nsecond: no further call before: end",
    ),
    (
        "O1\nN10 #100=1\nN20 M98 P2\nM30\nO2\nM98 P3\nM99\nO3\nM99\n",
        {"max_nesting": 1},
        "first: O2, line 6: M98 O3, 1 pass\nsecond: no further call before: alarm PS0077 nesting-too-deep at O2",
    ),
]


@pytest.mark.parametrize(("program", "rules", "what"), CHANGES)
def test_what_makes_the_difference_is_named(program: str, rules: dict[str, Any], what: str) -> None:
    compared = changed(program, **rules)
    assert not compared.same
    assert compared.rules == tuple(rules)
    assert compared.what == what


def test_two_rules_that_make_it_together() -> None:
    program = "O1\nM98 P2 L0\nM98 P3\nM30\nO2\nM99\nO3\nM99\n"
    compared = changed(program, zero_repeats="skip", max_nesting=0)
    assert compared.rules == ("zero_repeats",)  # the first difference


def test_a_difference_of_languages_is_no_rule() -> None:
    library = cncsub.loads("G0 X1.\nM2\n", control="linuxcnc", name="A.NC")
    compared = cncsub.compare(library, controls=["linuxcnc", "siemens-one"])
    assert compared.rules == ()


BEFORE = "O1\nN10 G0 X1. Y2.\nN20 M98 P2 L2\nN30 M3\n#100=5\n#3006=1(A)\nM30\nO2\nM99\n"


@pytest.mark.parametrize(
    ("old", "new", "what"),
    [
        ("Y2.", "Y3.", "before: O1 N10, line 2: move 0 with y = 2\nafter: O1 N10, line 2: move 0 with y = 3"),
        ("L2", "L3", "before: O1 N20, line 3: M98 O2, 2 passes\nafter: O1 N20, line 3: M98 O2, 3 passes"),
        ("M3\n", "M4\n", "before: O1 N30, line 4: M3\nafter: O1 N30, line 4: M4"),
        ("N30 M3\n", "", "before: O1 N30, line 4: M3\nafter: no further M code before: end"),
        ("#100=5", "#100=6", "before: O1, line 5: #100 = 5\nafter: O1, line 5: #100 = 6"),
        ("#100=5\n", "", "before: O1, line 5: #100 = 5\nafter: no further change before: end"),
        ("(A)", "(B)", "before: O1, line 6: message 'A'\nafter: O1, line 6: message 'B'"),
        ("M30", "M99", "before: stopped: end\nafter: stopped: cycles"),
        ("P2 L2", "P7", "before: O1 N20, line 3: M98 O2, 2 passes\nafter: no further call before: alarm PS0076 program-not-found at O1 N20"),
    ],
)  # fmt: skip
def test_what_a_new_version_changed(old: str, new: str, what: str) -> None:
    assert old in BEFORE
    before, after = (
        cncsub.loads(text, control=MILL) for text in (BEFORE, BEFORE.replace(old, new, 1))
    )
    compared = cncsub.compare(before, after)
    assert compared.what == what
    assert compared.rules == ()


@pytest.mark.parametrize(
    "after",
    [
        BEFORE.replace("N20", "(A COMMENT)\nN20"),
        BEFORE.replace("X1. Y2.", "Y2.0 X1.000"),
        BEFORE.replace("M98 P2 L2", "M98 P20002"),
    ],
)
def test_what_does_the_same_is_the_same(after: str) -> None:
    before, later = (cncsub.loads(text, control=MILL) for text in (BEFORE, after))
    assert cncsub.compare(before, later).same


def test_paths_are_read(tmp_path: Path) -> None:
    for name, text in (("a", BEFORE), ("b", BEFORE.replace("X1.", "X2."))):
        (tmp_path / name).mkdir()
        (tmp_path / name / "O1.NC").write_text(text)
    compared = cncsub.compare(tmp_path / "a", tmp_path / "b", control=MILL)
    assert compared.where is not None
    assert [step and step.n for step in compared.where] == [10, 10]
    assert cncsub.compare(tmp_path / "a", controls=[MILL, "fanuc-30i"]).same


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"controls": [MILL]}, "two controls"),
        ({"controls": MILL}, "two controls"),
        ({}, "a second library, or controls="),
        ({"controls": [MILL, "fanuc-30i"], "second": "x"}, "not both"),
        ({"second": "x"}, "give control="),
        ({"controls": [MILL, "fanuc-30i"], "trace": "none"}, "takes no trace"),
    ],
)
def test_wrong_use_is_told(arguments: dict[str, Any], says: str) -> None:
    library = cncsub.loads(BEFORE, control=MILL)
    with pytest.raises(TypeError, match=says):
        cncsub.compare(library, **arguments)


def test_unknown_controls_are_errors() -> None:
    with pytest.raises(ValueError, match="fanuc-0i-f"):
        cncsub.compare(cncsub.loads(BEFORE, control=MILL), controls=[MILL, "fanuc-0i-g"])


# ---- a rule that was changed is the rule that is named ----


def pairs() -> Iterator[tuple[Case, cncsub.Control, cncsub.Control, str]]:
    """Rows on their control, and on the control with another value of a rule that they pin."""
    for row in rows():
        case = row.case
        if case.mdi is not None or case.resets or case.setup is not None:
            continue
        for word in case.pins[:1]:
            control = cncsub.controls[row.control]
            if case.replace:
                control = control.replace(**case.replace)
            if case.params:
                control = control.with_parameters(dict(case.params))
            for mutant in mutation.mutants(control, word):
                yield case, control, mutant, word.partition(":")[0]


def misnamed(case: Case, one: cncsub.Control, other: cncsub.Control, rule: str) -> str:
    """What is wrong with the comparison, and "same" where the rule makes no difference here."""
    library = outcome.load(case, one)
    options = {"max_blocks": 2000, **case.options}
    try:
        compared = cncsub.compare(library, controls=[one, other], **options)
    except KeyError as error:  # its main program is none for the other
        return "same" if "no program" in str(error) else str(error)
    if compared.same:
        return "same"
    return "" if compared.rules == (rule,) else f"{case.claim}: {compared.rules}, not {rule}"


def test_the_rule_that_was_changed_is_named() -> None:
    found = [misnamed(*pair) for i, pair in enumerate(pairs()) if i % 211 == 0]
    assert [told for told in found if told not in ("", "same")] == []
    assert found.count("") > 10
