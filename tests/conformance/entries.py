"""Checks that lists are pinned entry by entry: without the entry, a row has to fail.

`entries.json` names that row for every entry of every list of every control. The test runs these
rows alone. `python tests/conformance/entries.py` looks through all rows for the entries that have
no row, and forgets what is gone. An entry that no row can notice has its reason here, or its whole
rule has one in `unpinned.py`.
"""

from __future__ import annotations

import functools
import json
import re
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import cncsub
from cncsub.questions.values import answers
from conformance import Case, rows
from mutation import excused as is_inert
from mutation import on, passes

FILE = Path(__file__).parent / "entries.json"
HOW_TO_WRITE = "python tests/conformance/entries.py looks for rows and writes entries.json"

LETTERS = (  # noqa: SIM905
    "point_addresses minus_addresses name_marks dwell_words longer_words cycle_repeats"
    " lead_growth thread_words_not_computed call_words_not_computed cycle_words_not_computed"
).split()  # lists of one character an entry; the others have blanks between

# Each is a rule, a control or None for all, the entries, and why no row can notice them.
TE, HNC, SYNTEC, GRBLHAL = "gsk-928te", "hnc-21m", "syntec-22ma", "grblhal"
REASONS = [
    (
        "g_codes",
        None,
        "65 66 66.1 67",
        "a macro call is known by `macro_calls`, whatever the list says",
    ),
    (
        "g_codes",
        TE,
        "22 26 27 29 33 80",
        "a code that no source tells of alarms alike without the list",
    ),
    (
        "g_codes",
        HNC,
        "7 11 12 22 24 25 34",
        "a meaning of the control's own is known without the list",
    ),
    (
        "g_codes",
        SYNTEC,
        "31.1 31.2 31.3 37 37.1",
        "a meaning of the control's own is known without the list",
    ),
    ("g_meanings", TE, "33=not-computed", "a code that no source tells of alarms alike"),
    ("g_meanings", HNC, "7=not-computed 12=not-computed 34=not-computed", "the same"),
    (
        "refuses",
        GRBLHAL,
        "g10-axis-missing",
        "the language refuses it itself, whatever the list says",
    ),
    (
        "g_meanings",
        GRBLHAL,
        "66=not-computed 66.1=not-computed",
        "the language stops at the code itself, whatever the list says",
    ),
    (
        "g_meanings",
        GRBLHAL,
        "91.1=centre-from-start",
        "it is so from power-on, and no code of the control changes it",
    ),
    (
        "g_meanings",
        "mazak-smooth",
        "37=not-computed 37.1=not-computed",
        "no code of the control measures, whatever the list says",
    ),
    ("codes_not_with_macro_call", None, "65 66", "two macro calls in a block are another fault"),
    ("codes_not_with_modal_call", None, "65 66", "two macro calls in a block are another fault"),
    ("modal_groups", None, "rotation=16", "the group has this number on every control"),
    ("lead_growth", None, "K", "a control without the word has it by default"),
    ("longer_words", None, "D", "a control without the word has it by default"),
]

# The words by which a language writes a code, and the addresses that have the place of a letter.
WORDS = {
    f"{int(code) / 10:g}": word
    for code, word in re.findall(
        r'^WORD_CODE\((\d+), "(\w+)"\)',
        (FILE.parents[2] / "cpp/cncsub/control/word_codes.def").read_text(encoding="utf-8"),
        re.MULTILINE,
    )
}
LENT = {
    "rotation_words": {"E": "RPL"},
    "chamfer_words": {",D": "CHF"},
    "modal_round_words": {"O": "RNDM"},
    "corner_feed_words": {"G": "FRC"},
    "modal_corner_feed_words": {"M": "FRCM"},
    "contour_offset_words": {"N": "OFFN"},
}

# Control, rule, claim, and the entries whose absence that row notices, separated by blanks.
Pins = dict[str, dict[str, dict[str, str]]]


def lists(control: cncsub.Control) -> Iterator[Any]:
    """Yield the rules that are lists; entries of a set are pinned as rules are, except for
    `refuses`.
    """
    for rule in control.rules:
        is_list = isinstance(rule.value, str) and not rule.choices
        if is_list and (not rule.entries or rule.name == "refuses"):
            yield rule


def entries(rule: Any) -> list[str]:
    return list(dict.fromkeys(rule.value if rule.name in LETTERS else rule.value.split()))


# How `replace` takes a list as a whole; otherwise it adds to the list.
_PROBE = next(iter(cncsub.controls.values())).replace(g_codes="=0")
_WHOLE = "" if any(rule.value == "=0" for rule in _PROBE.rules) else "="


def without(control: cncsub.Control, rule: Any, entry: str) -> cncsub.Control:
    between = "" if rule.name in LETTERS else " "
    rest = between.join(other for other in entries(rule) if other != entry)
    return control.replace(**{rule.name: _WHOLE + rest})


def excused(control: cncsub.Control, rule: Any, entry: str) -> bool:
    """Return whether there is a reason why no row can notice an entry."""
    if any(is_inert(control, word) for word in (rule.name, f"{rule.name}:{entry}")):
        return True
    if rule.name.startswith("codes_not_with"):
        codes = str(answers(control.name)["g_codes"]).split()
        if codes and entry not in codes:
            return True  # the code of a relative, which this control does not have
    return any(
        rule.name == name and only in (None, control.name) and entry in inert.split()
        for name, only, inert, _ in REASONS
    )


def read_pins() -> Pins:
    pins: Pins = json.loads(FILE.read_text(encoding="utf-8"))
    return pins


def _by_entry(pins: Pins, control: str, rule: str) -> dict[str, str]:
    claims = pins.get(control, {}).get(rule, {})
    return {entry: claim for claim, noticed in claims.items() for entry in noticed.split()}


def unnoticed() -> list[str]:
    """Return the entries of the lists in the file that no row notices. The row that is named for an
    entry is tried first, and then any other. A new list joins when the file is written.
    """
    by_place = {(row.control, row.case.claim): row.case for row in rows()}
    pins, found = read_pins(), []
    known = {rule for claims in pins.values() for rule in claims}
    for name, control in cncsub.controls.items():
        for rule in lists(control):
            claims = _by_entry(pins, name, rule.name)
            for entry in entries(rule) if rule.name in known else ():
                if excused(control, rule, entry):
                    continue
                case = by_place.get((name, claims.get(entry, "")))
                mutant = without(control, rule, entry)
                if case is not None and not passes(case, mutant):
                    continue
                likely = (c for c, text in _texts(name) if _may_notice(rule.name, entry, c, text))
                lent = (on(c, name) for c in named_elsewhere(pins, by_place, rule.name, entry))
                if all(passes(c, mutant) or not passes(c, control) for c in (*lent, *likely)):
                    found.append(f"{name}: {rule.name}: {entry}: {claims.get(entry)}")
    return found


def named_elsewhere(
    pins: Pins, by_place: Mapping[tuple[str, str], Case], rule: str, entry: str
) -> Iterator[Case]:
    """Yield the rows that are named for the same entry in the list of another control."""
    for control in pins:
        claim = _by_entry(pins, control, rule).get(entry, "")
        if (control, claim) in by_place:
            yield by_place[control, claim]


@functools.cache
def _texts(control: str) -> list[tuple[Case, str]]:
    """Return the rows of a control, each with all that it reads."""
    return [(row.case, _text(row.case)) for row in rows() if row.control == control]


def _text(case: Case) -> str:
    parts = [case.program, case.mdi, *(case.files or {}).values(), *(case.external or {}).values()]
    texts = [part.decode("latin-1") if isinstance(part, bytes) else part for part in parts if part]
    return "\n".join(texts).upper()


def _may_notice(rule: str, entry: str, case: Case, text: str) -> bool:
    """Return whether a row has the subject of the entry: its code, name, cause or letter."""
    if rule == "refuses":
        return case.alarm == entry
    if rule == "functions":
        return entry[:2] in text
    if "codes" in rule or rule == "g_meanings":
        letter = "M" if rule.startswith("m_") else "G"
        if word := WORDS.get(entry.split("=")[0]):
            return word in text
        return (
            re.search(rf"{letter}0*{re.escape(entry.split('=')[0])}(?![\d.]*[1-9])", text)
            is not None
        )
    lent = LENT.get(rule, {}).get(entry)
    if lent is not None and lent in text:
        return True
    return rule == "modal_groups" or entry.rstrip("?")[-1] in text


def find_pins() -> Pins:
    """Return the pins that hold, and for the other entries the first row that notices."""
    old, pins = read_pins() if FILE.exists() else {}, {}
    for name, control in cncsub.controls.items():
        claims: dict[str, dict[str, list[str]]] = {}
        for rule in lists(control):
            known = _by_entry(old, name, rule.name)
            tried_first: list[str] = []
            for entry in entries(rule):
                if excused(control, rule, entry):
                    continue
                first = [known.get(entry), *tried_first]
                likely = [c for c, text in _texts(name) if _may_notice(rule.name, entry, c, text)]
                likely.sort(key=lambda case: first.index(case.claim) if case.claim in first else 99)
                mutant = without(control, rule, entry)
                for case in likely:
                    if not passes(case, mutant) and passes(case, control):
                        claims.setdefault(rule.name, {}).setdefault(case.claim, []).append(entry)
                        tried_first.insert(0, case.claim)
                        break
        pins[name] = {
            rule: {claim: " ".join(noticed) for claim, noticed in by_claim.items()}
            for rule, by_claim in claims.items()
        }
    return pins


def main() -> None:
    pins = find_pins()
    FILE.write_text(json.dumps(pins, indent=1, ensure_ascii=True) + "\n", encoding="utf-8")
    print("\n".join(unnoticed()), file=sys.stderr)


if __name__ == "__main__":
    main()
