"""The tables themselves: their size, their sources, and that they cover the whole engine."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest

import cncsub
from cncsub import _core
from cncsub.questions.asking import ISO_FAMILY
from cncsub.questions.values import entries_of
from cncsub.reports.facts import explanations
from cncsub.testing.outcome import execute, load
from conformance import EVIDENCE, FOLDER, Case, cases, motion_causes, rows, topic_files
from entries import HOW_TO_WRITE as HOW_TO_PIN
from entries import unnoticed
from mutation import HOW_TO_FIND, lent, notices, passes, pinning, unpinned, words
from unpinned import UNPINNED

MINIMUM_CASES = 900
LISTS = Path(__file__).parents[2] / "cpp" / "controls"
strength = EVIDENCE.index


def test_there_are_enough_rows() -> None:
    assert len(cases()) >= MINIMUM_CASES


def test_every_topic_has_rows() -> None:
    topics = {case.topic for case in cases()}
    files = {file.relative_to(FOLDER).with_suffix("").as_posix() for file in topic_files()}
    assert files == topics


def test_about_half_of_the_rows_alarm() -> None:
    alarming = sum(case.alarm is not None for case in cases())
    assert 0.35 <= alarming / len(cases()) <= 0.65, f"{alarming} of {len(cases())}"


def test_every_claim_is_made_once() -> None:
    counts = Counter(case.claim for case in cases())
    assert [claim for claim, count in counts.items() if count > 1] == []


def test_every_row_says_where_it_comes_from() -> None:
    without = [
        f"{case.topic}.py:{case.line}: {case.claim}"
        for case, control in rows()
        if not case.source_on(control).strip() or case.evidence[control] not in EVIDENCE
    ]
    assert without == []


def test_no_row_is_stronger_than_its_source_is_on_the_control() -> None:
    """The manual of another maker or model is no manual of the control, whatever a row says."""
    stronger = []
    for case, control in rows():
        keys = _core.cited(case.source_on(control))
        best = min([cncsub.sources[key].on(control) for key in keys] or ["inferred"], key=strength)
        if strength(case.evidence[control]) < strength(best):
            stronger.append(f"{case.topic}.py:{case.line}: {case.claim} [{control}]")
    assert stronger == []


def test_the_text_of_an_alarm_is_that_of_the_printed_list() -> None:
    """Number and text of an alarm stand together in the list that is printed."""
    for file, own in (("fanuc/alarms_30i.def", ("fanuc-30i", "fanuc-0i-f", "fanuc-0i-d")),):
        listed = dict(re.findall(r'LISTED\("(\w+)", "(.*?)"[,)]', (LISTS / file).read_text()))
        for name in own:
            for alarm in cncsub.controls[name].alarms.values():
                assert not alarm.printed or alarm.text == listed[alarm.number]
                assert alarm.printed or "general knowledge" in alarm.source


@pytest.mark.parametrize("name", ["gsk-980tdi", "gsk-980mdi"])
def test_the_980s_print_four_digits_as_the_later_printing_of_their_paper_does(name: str) -> None:
    entries = cncsub.controls[name].alarms.values()
    printed = [
        number for a in entries for number in (a.number, *(n for n, _ in a.directed.values()))
    ]
    assert [number for number in printed if number and not re.fullmatch(r"\d{4}", number)] == []
    for asked in ("0096", "096", "96"):
        causes = {fact["cause"] for fact in explanations(asked, [cncsub.controls[name]])}
        assert causes == {"nesting-too-deep", "macro-nesting-too-deep"}


def test_only_a_list_that_is_printed_is_quoted() -> None:
    quoted = {n for n, c in cncsub.controls.items() if any(a.printed for a in c.alarms.values())}
    assert quoted == {
        "fanuc-0i-d",
        "fanuc-0i-f",
        "fanuc-30i",
        "grblhal",
        "linuxcnc",
        "mazak-smooth",
        "okuma-osp-p300",
    }


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


def test_every_motion_alarm_of_a_row_names_its_word() -> None:
    """A row that alarms for a cause of the motion says which word is under the caret."""
    causes = motion_causes()
    lacking = [
        str(row)
        for row in rows()
        if row.case.alarm in causes and row.case.word_on(row.control) is None
    ]
    assert lacking == [], "say word="


def test_every_rule_is_pinned() -> None:
    """If any rule of any control changes, a row that says that it pins it has to notice."""
    missing = [f"{control}: {word}" for control, word in unpinned()]
    assert missing == [], f"{HOW_TO_FIND}; no row that pins it notices\n{chr(10).join(missing)}"


def rows_on(control: cncsub.Control, word: str) -> Iterator[Case]:
    """Yield the rows of a control that pin a rule, and those of its relatives that hold on it."""
    yield from pinning(control.name, word)
    yield from (case for case in lent(control, word) if passes(case, control))


def test_a_language_of_its_own_asks_every_rule_that_it_prints() -> None:
    """A row in its language, its own or one of a relative that holds on it, notices each rule: no
    rule is excused as a whole.
    """
    own = [name for name, of in cncsub.controls.items() if of.dialect not in ISO_FAMILY]
    assert own
    idle = []
    for name in own:
        for rule in cncsub.controls[name].rules:
            said = [f"{rule.name}:{entry}" for entry in entries_of(rule)] or [rule.name]
            heard = (
                notices(case, cncsub.controls[name], word)
                for word in said
                for case in rows_on(cncsub.controls[name], word)
            )
            if not any(heard):
                idle.append(f"{name}: {rule.name}")
    assert idle == []


def test_a_row_notices_what_it_pins() -> None:
    """It does so on one of its controls at least: other rules of a control may make a rule inert.
    Of the rows that a loop writes, one is enough.
    """
    written: dict[tuple[str, int, str], list[tuple[Case, str]]] = {}
    for row in rows():
        for name in row.case.pins:
            place = (row.case.topic, row.case.line, name)
            written.setdefault(place, []).append((row.case, row.control))
    idle = [
        f"{topic}.py:{line}: {name}"
        for (topic, line, name), those in written.items()
        if not any(notices(case, cncsub.controls[c], name) for case, c in those)
    ]
    assert idle == []


def test_every_entry_of_every_list_is_pinned() -> None:
    """If a code, letter, name or cause is missing in its list, the row that pins it has to fail."""
    assert unnoticed() == [], HOW_TO_PIN


def test_what_is_unpinned_is_noticed_nowhere() -> None:
    known = {word for control in cncsub.controls.values() for word in words(control)}
    assert sorted(set(UNPINNED) - known) == []
    noticed = [
        f"{control}: {word}: {case.claim}"
        for control, reasons in _reasons().items()
        for word in sorted(reasons)
        for case in pinning(control, word)
        if notices(case, cncsub.controls[control], word)
    ]
    assert noticed == []


def _reasons() -> dict[str, set[str]]:
    """Return, by control, the rules that no row can notice there."""
    by_control: dict[str, set[str]] = {}
    for rule, controls in UNPINNED.items():
        for control in controls:
            by_control.setdefault(control, set()).add(rule)
    return by_control


def _line_of(case: Case, alarm: cncsub.Alarm) -> str | None:
    """Return the line that an alarm names, in the text of the row."""
    texts = [case.mdi] if alarm.file == "MDI" else [case.program, *(case.files or {}).values()]
    if case.files is not None or case.external is not None:
        named = {**(case.external or {}), **(case.files or {})}
        texts = [text for name, text in named.items() if (alarm.file or "").endswith(name)] or texts
    text = next((text for text in texts if isinstance(text, str)), None)
    lines = text.split("\n") if text is not None else []
    return lines[alarm.line - 1] if alarm.line is not None and alarm.line <= len(lines) else None


def _is_whole(line: str, start: int, word: str) -> bool:
    """Return whether `word` cuts no name or number, and no address stands without its value."""
    name = re.compile(r"[A-Za-z0-9._]")
    before, behind = line[start - 1 : start], line[start + len(word) :]
    cut = name.match(word) and name.match(before) and not re.match(r"\d", before)
    cut = cut or (name.match(word[-1]) and re.match(r"[0-9._]", behind))
    return not cut and not (re.fullmatch(r"[A-Za-z]", word) and re.match(r"\s*[-+0-9.#\[]", behind))


def test_the_word_of_a_motion_alarm_stands_where_it_says_and_is_whole() -> None:
    wrong = []
    for row in rows():
        if row.case.alarm is None or "motion" not in row.case.topic:
            continue
        alarm = execute(row.case, load(row.case, cncsub.controls[row.control])).alarm
        line = None if alarm is None else _line_of(row.case, alarm)
        if alarm is None or line is None or not alarm.word:
            continue
        start = alarm.column - 1
        if line[start : start + len(alarm.word)] != alarm.word:
            wrong.append(
                f"{row}: {alarm.word!r} does not stand at column {alarm.column} of {line!r}"
            )
        elif not _is_whole(line, start, alarm.word):
            wrong.append(f"{row}: {alarm.word!r} is no whole word of {line!r}")
    assert wrong == []
