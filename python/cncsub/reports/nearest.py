"""What is nearest to a few words of a question, by meaning: causes, rules, codes, parameters."""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from cncsub import _core
from cncsub._core import Control
from cncsub.checking import RULES
from cncsub.controls import causes
from cncsub.gate_rules import RULES as GATE_RULES

MOST = 8  # entries that are listed
_UNKNOWN = 3.0  # the weight of a word that no entry has


class Entry(NamedTuple):
    """A thing that `explain` knows: its name, what kind of thing it is, what it means, and other
    texts by which it is found.
    """

    name: str
    kind: str
    meaning: str
    texts: tuple[str, ...] = ()


def nearest(question: str, among: list[Control]) -> list[Entry]:
    """Return the entries that are nearest to a question, the nearest first; none where less than
    half of its words are found, weighed by how much each says.

    >>> import cncsub
    >>> found = nearest("nested too deep", [cncsub.control("fanuc-0i-f")])
    >>> found[0].name
    'nesting-too-deep'
    """
    entries = list(_entries(among))
    wanted = list(dict.fromkeys(_stems(question)))
    found = [_weights(entry) for entry in entries]
    known = Counter(stem for weights in found for stem in weights)
    says = {s: math.log(len(entries) / known[s]) if known[s] else _UNKNOWN for s in wanted}
    whole = sum(says.values())
    scored: list[tuple[float, int, Entry]] = []
    for entry, weights in zip(entries, found, strict=True):
        there = [stem for stem in wanted if stem in weights]
        part = sum(says[stem] for stem in there) / whole if there else 0.0
        if part >= 0.5:
            score = part * sum(says[stem] * weights[stem] for stem in there)
            scored.append((-score, len(entry.name), entry))
    return [entry for _, _, entry in sorted(scored, key=lambda s: s[:2])[:MOST]]


def is_told_by(question: str, entry: Entry) -> bool:
    """Return whether all words of a question are found in an entry."""
    return set(_stems(question)) <= _weights(entry).keys()


def _weights(entry: Entry) -> dict[str, float]:
    """Return the stems of an entry: those of its name and meaning count most."""
    weights: dict[str, float] = {}
    for texts, weight in ((entry.texts, 0.6), ((entry.meaning,), 1.0), ((entry.name,), 1.3)):
        for text in texts:
            weights.update(dict.fromkeys(_stems(text), weight))
    return weights


# ---- words ----

_SAYS_NOTHING = (
    "a an and are as at be by can do does for from get had has have how i if in is it its me my no"
    " not of on or so than that the then there they this to too was what when where which why will"
    " with you your"
)
_NOTHING = frozenset(_SAYS_NOTHING.split())

# Words that people use for those of these texts.
_OTHER_WORDS = {
    "subroutine": "subprogram", "sub": "subprogram", "stack": "nest", "depth": "deep",
    "overflow": "deep", "recursive": "itself", "feedrate": "feed", "imperial": "inch",
    "mm": "millimetre", "metric": "millimetre", "empty": "vacant", "null": "vacant",
    "undefined": "vacant", "uninitialized": "vacant", "cutter": "radius", "label": "sequence",
    "times": "often", "iteration": "repeat",
    "missing": "without", "absent": "without", "decimal": "point",
    "dot": "point", "soft": "travel", "limit": "travel", "comp": "compensation",
    "circle": "arc", "circular": "arc", "wcs": "work", "pause": "wait",
}  # fmt: skip

_ENDINGS = "ations ation ings ing ions ion ers er ies ied ed es s e y".split(" ")  # noqa: SIM905


def _stems(text: str) -> Iterator[str]:
    """Yield the words of a text without their endings, and without those that say nothing."""
    for word in re.findall(r"[^\W_]+", text.casefold()):
        if word not in _NOTHING:
            yield _stem(_OTHER_WORDS.get(word, word))


def _stem(word: str) -> str:
    for ending in _ENDINGS:
        if word.endswith(ending) and len(word) - len(ending) >= 4:
            return word[: -len(ending)]
    return word


# ---- what there is ----


def _entries(among: list[Control]) -> Iterator[Entry]:
    for slug, cause in causes.items():
        texts = {c.alarms[slug].text or "" for c in among if slug in c.alarms}
        yield Entry(slug, "cause", cause.meaning, (cause.cure, *sorted(texts)))
    for check in RULES:
        yield Entry(f"{check.number} {check.name}", "rule of check", check.meaning, (check.hint,))
    for rule in GATE_RULES:
        yield Entry(f"{rule.number} {rule.name}", "rule of gate", rule.meaning, (rule.hint,))
    yield from _once(_rules(among))
    yield from _once(_codes(among))
    yield from _once(_keywords(among))
    if len(among) == 1:
        for parameter in among[0].parameters.values():
            yield Entry(parameter.name, "parameter", parameter.meaning)


def _once(entries: Iterable[Entry]) -> Iterator[Entry]:
    seen: dict[tuple[str, str], Entry] = {}
    for entry in entries:
        seen.setdefault((entry.name, entry.meaning), entry)
    yield from seen.values()


def _rules(among: list[Control]) -> Iterator[Entry]:
    for control in among:
        for rule in control.rules:
            if rule.choices:
                yield Entry(rule.name, "rule", rule.meaning, tuple(rule.examples))
            else:  # the examples of a set are many, and of its entries
                yield Entry(rule.name, "rule", rule.meaning)


def _keywords(among: list[Control]) -> Iterator[Entry]:
    """Yield the words of the languages that are computed."""
    for control in among:
        for name, treatment, does in _core.keywords(control):
            if treatment == "computed":
                yield Entry(name, "word", does)


def _codes(among: list[Control]) -> Iterator[Entry]:
    """Yield the codes that are computed."""
    for control in among:
        meanings = {rule.name: rule.meaning for rule in control.rules}
        roles = next((str(r.value) for r in control.rules if r.name == "roles"), "")
        names = [name for name, _ in _core.g_codes(control)]
        names += [entry.partition("=")[0] for entry in roles.split()]
        for name in dict.fromkeys(names):
            facts = _core.code_facts(control, name)
            if facts is not None and facts["treatment"] == "computed":
                says = [text for _, text, _ in facts["words"]]
                says += [meanings.get(rule, "") for _, _, rules in facts["words"] for rule in rules]
                yield Entry(facts["name"], "code", facts["does"], tuple(says))
