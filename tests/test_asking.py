"""What no source says of a control, as programs that tell the values of a rule apart."""

from __future__ import annotations

import pytest
from test_cli import Done

import cncsub
from cncsub.questions.asking import MOST_LINES, _values, open_words, question, stored, unsettled
from cncsub.questions.outcome import Short, seen

NAMES = list(cncsub.controls)
_EVERY = 12  # of the open rules and entries of a control, how many are left out between two


@pytest.mark.parametrize(("place", "name"), list(enumerate(NAMES)))
def test_a_program_tells_the_values_apart_as_its_answers_say(place: int, name: str) -> None:
    control = cncsub.controls[name]
    for word in open_words(control)[place % _EVERY :: _EVERY]:
        asked = question(control, word)
        if not asked.program:
            assert asked.answers == ()
            continue
        program = Short(asked.program, asked.machine)
        assert program.lines <= MOST_LINES
        assert len({answer.seen for answer in asked.answers}) == len(asked.answers) >= 2
        assert [answer.ours for answer in asked.answers].count(True) == 1
        shown = {value: seen(program, mutant) for value, mutant in _values(control, word)}
        for answer in asked.answers:
            of = [shown[value] for value in answer.values]
            assert all(there == of[0] for there in of), (name, word)
            assert answer.ours == (shown[asked.value] == of[0])


def test_most_of_what_is_open_has_a_program() -> None:
    for name in ("fanuc-0i-f", "mitsubishi-m700"):
        words = open_words(cncsub.controls[name])
        assert sum(word in stored() for word in words) > len(words) / 2


def test_only_what_is_inferred_is_asked() -> None:
    control = cncsub.controls["fanuc-0i-f"]
    evidence = {rule.name: rule.evidence for rule in control.rules}
    sources = {rule.name: rule.sources for rule in control.rules}
    for word in open_words(control):
        rule, _, entry = word.partition(":")
        of = sources[rule].get(entry.partition("=")[0], ("", evidence[rule]))
        assert of[1] == "inferred"


def test_the_stored_programs_are_short_and_of_rules_that_exist() -> None:
    known = {rule.name for control in cncsub.controls.values() for rule in control.rules}
    for word, programs in stored().items():
        assert word.partition(":")[0] in known
        assert all(len(text.splitlines()) <= MOST_LINES for text, _ in programs)


def test_the_command_prints_the_program_and_what_each_answer_means() -> None:
    done = Done("ask", "fanuc-31i", "max_nesting")
    assert done.status == 0
    assert "is taken as fanuc-30i" in done.error
    assert "max_nesting: how many subprogram calls may be open [" in done.out
    lines = done.out.splitlines()
    assert [line for line in lines if line.startswith(" * ") and line.endswith("->  10")]
    facts = Done("ask", "fanuc-30i", "max_nesting", "--format", "json").json
    asked = next(asked for asked in facts["questions"] if asked["name"] == "max_nesting")
    assert asked["program"]
    assert len(asked["answers"]) == 3


def test_a_rule_without_a_program_is_named() -> None:
    control = cncsub.controls["siemens-one"]
    left = unsettled(question(control, word) for word in open_words(control)[:20])
    assert left
    assert left[0].startswith("refuses (")


def test_a_word_that_nothing_has_is_told() -> None:
    done = Done("ask", "fanuc-0i-f", "frobnicate")
    assert (done.status, done.out) == (2, "")
    assert "nothing with frobnicate is open on fanuc-0i-f" in done.error
