"""Questions to the owner of a machine: for a rule that no source settles, a program of at most five
lines whose run shows which value the rule has. That a program tells values apart is not written
down but tried: it is run with each of them.
"""

from __future__ import annotations

import functools
import json
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from importlib.resources import files
from typing import Any

from cncsub.controls import Control
from cncsub.questions.outcome import Seen, Short, seen
from cncsub.questions.values import changed, entries_of, rule_named

MOST_LINES = 5
MOST_VALUES = 10  # of a rule, that are tried
_INFERRED = "inferred"
ISO_FAMILY = ("iso", "syntec")
"""The languages that read the blocks of the ISO family: the examples of rules are of these."""


@dataclass(frozen=True)
class Answer:
    """What the machine may do, and which values of the rule that would mean. `ours`: whether the
    value that cncsub takes today is among them.
    """

    seen: str
    values: tuple[str, ...]
    ours: bool


@dataclass(frozen=True)
class Question:
    """A rule that no source settles, and how to settle it. `program` is empty, with no answers,
    where no program of five lines is known that shows its value.
    """

    rule: str
    entry: str
    meaning: str
    value: str
    source: str
    program: str = ""
    machine: str = ""
    answers: tuple[Answer, ...] = ()

    @property
    def name(self) -> str:
        return f"{self.rule}:{self.entry}" if self.entry else self.rule


def open_words(control: Control) -> list[str]:
    """Return what is inferred on a control: names of rules, and of entries of sets."""
    words = []
    for rule in control.rules:
        entries = entries_of(rule)
        for entry in entries:
            if _source_of(rule, entry)[1] == _INFERRED:
                words.append(f"{rule.name}:{entry}")
        if not entries and rule.evidence == _INFERRED:
            words.append(rule.name)
    return words


def questions(control: Control, words: tuple[str, ...] = ()) -> Iterator[Question]:
    """Yield what no source settles of a control; only of the rules whose names or meanings hold all
    of `words`, where some are given.
    """
    for name in open_words(control):
        about = f"{name} {rule_named(control, name.partition(':')[0]).meaning}".casefold()
        if all(word.casefold() in about for word in words):
            yield question(control, name)


def question(control: Control, name: str) -> Question:
    """Return the question about a rule, or about an entry of a set, with the program that tells the
    most of its values apart; of several the shortest. Those of rows come before those of examples.
    """
    rule_name, _, entry = name.partition(":")
    rule = rule_named(control, rule_name)
    values = _values(control, name)
    meaning = f"{rule.meaning}: {example}" if (example := _example(rule, entry)) else rule.meaning
    asked = Question(rule_name, entry, meaning, values[0][0], _source_of(rule, entry)[0])
    best: tuple[Short, list[tuple[Seen, list[int]]]] | None = None
    for programs in (_of_rows(name), _of_examples(control, rule, name)):
        for program in sorted(programs, key=lambda of: (of.lines, len(of.text))):
            groups = _groups(program, [of for _, of in values])
            if len(groups) > (1 if best is None else len(best[1])):
                best = program, groups
            if len(groups) == len(values):
                break  # no other program can tell more
        if best is not None:
            break
    if best is None:
        return asked
    program, groups = best
    return Question(
        rule_name,
        entry,
        meaning,
        asked.value,
        asked.source,
        program.text,
        program.machine,
        tuple(_answers(groups, [value for value, _ in values])),
    )


def unsettled(asked: Iterable[Question]) -> list[str]:
    """Return what no program is known for: names of rules, and sets with their entries."""
    left: dict[str, list[str]] = {}
    for one in asked:
        if not one.program:
            left.setdefault(one.rule, []).extend([one.entry] if one.entry else [])
    return [f"{rule} ({', '.join(entries)})" if entries else rule for rule, entries in left.items()]


def _example(rule: Any, entry: str) -> str:
    """Return the example of an entry of a set."""
    return dict(zip(rule.entries, rule.examples, strict=True)).get(entry, "") if entry else ""


def _source_of(rule: Any, entry: str) -> tuple[str, str]:
    """Return the source and the evidence of a rule, or of an entry of it: of M98 for `M98=call`."""
    told: tuple[str, str] = rule.sources.get(entry.partition("=")[0], (rule.source, rule.evidence))
    return told


def _values(control: Control, name: str) -> list[tuple[str, Control]]:
    """Return the values of a rule in words, each with the control that has it: its own first."""
    rule_name, _, entry = name.partition(":")
    rule = rule_named(control, rule_name)
    own = entry in str(rule.value).split() if entry else rule.value
    found = [(_told(own, own), control)]
    for value, mutant in changed(control, name):
        if len(found) == MOST_VALUES:
            break
        found.append((_told(value, own), mutant))
    return found


def _told(value: Any, own: Any) -> str:
    """Return a value in words; of a list that is long, what is otherwise than in the own one."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    text = str(value) or "none"
    if value is own or len(text) < 40 or not isinstance(own, str):
        return text if len(text) < 60 else f"{text[:55]} ..."
    mine, theirs = own.split(), text.split()
    more = [entry for entry in theirs if entry not in mine]
    less = [entry for entry in mine if entry not in theirs]
    told = [f"with {' '.join(more[:5])}"] if more else []
    told += [f"without {' '.join(less[:5])}"] if less else []
    return " and ".join(told) or text[:55]


def _groups(program: Short, mutants: list[Control]) -> list[tuple[Seen, list[int]]]:
    """Return what is seen of a program, each with the places of the controls that show it; nothing
    where it does not run on the first one.
    """
    found: list[tuple[Seen, list[int]]] = []
    for place, control in enumerate(mutants):
        there = seen(program, control)
        if there is None:
            if place == 0:
                return []
            continue
        for known, places in found:
            if known == there:
                places.append(place)
                break
        else:
            found.append((there, [place]))
    return found


def _answers(groups: list[tuple[Seen, list[int]]], values: list[str]) -> Iterator[Answer]:
    """Yield what the machine may do, told by no more than what it takes to tell it apart."""
    shown: list[str] = []
    for key in _LOOKED_AT:
        if _kinds(groups, [*shown, key]) > _kinds(groups, shown):
            shown.append(key)
    for there, places in groups:
        told = "; ".join(there[key] if key == "stop" else f"{key}: {there[key]}" for key in shown)
        yield Answer(told, tuple(dict.fromkeys(values[place] for place in places)), 0 in places)


_LOOKED_AT = ("stop", "variables", "moves", "blocks", "codes", "time")  # the plainest first


def _kinds(groups: list[tuple[Seen, list[int]]], shown: list[str]) -> int:
    """Return how many groups are told apart by what is shown."""
    return len({tuple(there[key] for key in shown) for there, _ in groups})


# ---- the programs that are tried ----


def _of_rows(name: str) -> Iterator[Short]:
    """Yield what tools/questions.py made of the conformance rows."""
    yield from (Short(text, machine) for text, machine in stored().get(name, ()))


def _of_examples(control: Control, rule: Any, name: str) -> Iterator[Short]:
    """Yield programs made of the examples of the rule, which are of the ISO family."""
    if control.dialect in ISO_FAMILY:
        for span in dict.fromkeys(_spans(rule, name)):
            for form in _FORMS:
                if (made := Short(form.format(span))).lines <= MOST_LINES:
                    yield made


_FORMS = ("O1\n{}\nM30\n", "O1\n{}\nM30\nO2\nM99\n", "O1\nG1 X1. F100\n{}\nX2. Y1.\nM30\n")


def _spans(rule: Any, name: str) -> Iterator[str]:
    """Yield the pieces of programs in the examples of a rule, or of an entry of it."""
    entry = name.partition(":")[2]
    for known, example in zip(rule.choices or rule.entries, rule.examples, strict=True):
        if not entry or known == entry:
            yield from re.findall(r"`([^`{}]+)`", example)
    yield from re.findall(r"`([^`{}]+)`", rule.meaning)


@functools.cache
def stored() -> Mapping[str, list[tuple[str, str]]]:
    """Return the programs of the conformance rows by what they tell apart."""
    text = files("cncsub.questions").joinpath("programs.json").read_text("utf-8")
    read: dict[str, list[list[str]]] = json.loads(text)
    return {name: [(text, machine) for text, machine in rows] for name, rows in read.items()}
