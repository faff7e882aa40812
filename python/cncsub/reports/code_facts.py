"""What a code or an address does on controls, with its words, rules and alarms: for `explain`."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from cncsub import _core
from cncsub._core import Control, Rule
from cncsub.controls import causes
from cncsub.loading import loads

_CODE = re.compile(r"([GM])(\d{1,4}(?:\.\d)?)", re.IGNORECASE)
_ADDRESS = re.compile(r"[A-Z]", re.IGNORECASE)
_NAMED = re.compile(r"\b([GM])(\d+(?:\.\d)?)(?: to [GM]?(\d+)\b)?")
_ARGUMENTS = "ABCDEFHIJKMQRSTUVWXYZ"
_MACRO_CALL = "macro-call"

Facts = dict[str, Any]


def code_named(asked: str) -> str | None:
    """Return a code or an address as the engine writes it, `None` where the text is neither.

    >>> code_named("g065"), code_named("t"), code_named("PS0076")
    ('G65', 'T', None)
    """
    text = asked.strip()
    if found := _CODE.fullmatch(text):
        whole, _, tenth = found[2].partition(".")
        return f"{found[1].upper()}{int(whole)}" + (f".{tenth}" if int(tenth or 0) else "")
    return text.upper() if _ADDRESS.fullmatch(text) else None


def names_of(asked: str, control: Control) -> list[str]:
    """Return what a control knows of a text: a code, a word, an address, a variable, or each of
    these in a block. Nothing where the text is a question.

    >>> import cncsub
    >>> one = cncsub.controls["siemens-one"]
    >>> names_of("CR=", one), names_of("$AA_IW[X]", one), names_of("gotof", one)
    (['CR'], ['$AA_IW'], ['GOTOF'])
    >>> names_of("IF R1==2 GOTOF END", one), names_of("how many characters has a text", one)
    (['IF', 'R1', 'GOTOF'], [])
    """
    whole = code_named(asked) or asked.strip().upper()
    if _core.code_facts(control, whole) is not None:
        return [whole]
    names = [code_named(name) or name.upper() for name in _core.names_in_block(control, asked)]
    if names and _has_index_alone(asked.strip(), names[0]):
        names = names[:1]
    known = [name for name in names if _core.code_facts(control, name) is not None]
    return known if known and _is_block(asked, names, known) else []


def _has_index_alone(asked: str, name: str) -> bool:
    """Return whether brackets, or an equals sign, and nothing else follow a name: `$AA_IW[X]`."""
    rest = asked[len(name) :].strip()
    return rest == "=" or (rest[:1] + rest[-1:] in ("[]", "()"))


def _is_block(asked: str, names: list[str], known: list[str]) -> bool:
    """Return whether a text is one of a program, and no question: its first name is known, and so
    are most of its names, or half of them in capitals.
    """
    if names[0] != known[0]:
        return False
    signs = any(sign in asked for sign in "=[(")
    bare = [name for name in known[1:] if len(name) == 1 and not signs]  # an X without a number
    known = [name for name in known if name not in bare]
    unknown = len(names) - len(known)
    as_typed = asked == asked.upper() and len(known[0]) > 1
    return unknown < len(known) or (as_typed and unknown == len(known))


def code_explanations(asked: str, among: list[Control], machine: str = "") -> list[Facts]:
    """Return what a code, or a word of a control's language, does, or what each part of a block
    does: an entry for each thing that it does, with the controls. `machine`: only what it does on
    this kind of machine.
    """
    entries: dict[tuple[Any, ...], Facts] = {}
    places: dict[str, int] = {}
    for control in among:
        for code in names_of(asked, control):
            places.setdefault(code, len(places))
            for kind in _machines(control) if _CODE.fullmatch(code) and code[0] == "G" else [""]:
                facts = _core.code_facts(control, code, kind)
                if facts is None:
                    continue
                words = tuple((letters, says) for letters, says, _ in facts["words"])
                key = (code, facts["treatment"], facts["does"], words)
                entry = entries.setdefault(key, _entry(facts))
                entry["on"].append(_on(control, kind, facts))
    ordered = (entries[key] for key in sorted(entries, key=lambda key: places[key[0]]))
    joined = [_joined(entry, machine) for entry in ordered]
    return [entry for entry in joined if entry["on"]]


def _entry(facts: Facts) -> Facts:
    return {
        "kind": "code",
        "code": facts["name"],
        "treatment": facts["treatment"],
        "does": facts["does"],
        "words": [{"letters": letters, "says": says} for letters, says, _ in facts["words"]],
        "on": [],
    }


def _joined(entry: Facts, machine: str) -> Facts:
    """Name the kinds of machine only where the code does not do the same on all of a control."""
    of: dict[str, list[Facts]] = {}
    for on in entry["on"]:
        of.setdefault(on["control"], []).append(on)
    entry["on"] = [whole for facts in of.values() if (whole := _whole(facts, machine))]
    return entry


def _whole(facts: list[Facts], machine: str) -> Facts | None:
    """Return the facts of a control's kinds of machine as one, `None` where none is the asked."""
    same_on_all = len(facts) == facts[0]["of_machines"]
    wanted = [each for each in facts if each["machine"] in ("", machine or each["machine"])]
    if not wanted:
        return None
    kinds = [] if same_on_all else [each["machine"] for each in wanted]
    return {**{k: v for k, v in wanted[0].items() if k != "of_machines"}, "machines": kinds}


def own_machine(control: Control) -> str:
    """Return the kind of machine that a control is of where no setup tells another."""
    (kind,) = (str(rule.value) for rule in control.rules if rule.name == "machine")
    return kind


def _machines(control: Control) -> list[str]:
    """Return the kinds of machine of a control."""
    kind = own_machine(control)
    turning = any(rule.group == "turning" for rule in control.rules)
    return ["mill", "lathe-a", "lathe-b"] if kind == "mill" and turning else [kind]


def _on(control: Control, machine: str, facts: Facts) -> Facts:
    there = facts["treatment"] not in ("refused", "not-known", "not-computed")
    rules = list(_rules(control, machine, facts)) if there else []
    return {
        "control": control.name,
        "machine": machine,
        "of_machines": len(_machines(control)) if machine else 1,
        "sources": [_source(*by) for by in facts["sources"]],
        "calls": [
            {"kind": kind, "program": program if program >= 0 else None, **_source(*by)}
            for kind, program, by in facts["programs"]
        ],
        "arguments": _arguments(control, facts),
        "rules": [_rule(rule) for rule in rules],
        "alarms": [_alarm(control, slug) for slug in facts["causes"]],
    }


def _source(rule: str | None, source: str, evidence: str) -> Facts:
    return {"rule": rule, "source": source, "evidence": evidence}


def _rule(rule: Rule) -> Facts:
    return {
        "name": rule.name,
        "value": rule.value,
        "meaning": rule.meaning,
        "example": example_of(rule),
        "source": rule.source,
        "evidence": rule.evidence,
    }


def example_of(rule: Rule) -> str | None:
    """Return the example of the choice that a control makes."""
    pairs = zip(rule.choices, rule.examples, strict=False)
    return next((example for choice, example in pairs if choice == rule.value), None)


def _alarm(control: Control, slug: str) -> Facts:
    entry = control.alarms.get(slug)
    number = None if entry is None else entry.number or None
    return {"cause": slug, "number": number, "meaning": causes[slug].meaning}


# ---- the rules about a code ----


def _rules(control: Control, machine: str, facts: Facts) -> Iterator[Rule]:
    """Yield the rules that its words name, then those that speak of the code."""
    named = [rule for _, _, rules in facts["words"] for rule in rules]
    known = {rule.name: rule for rule in control.rules}
    yield from (known[name] for name in dict.fromkeys(named) if name in known)
    for rule in control.rules:
        if rule.name not in named and _speaks_of(rule, facts["usual"], machine):
            yield rule


def _speaks_of(rule: Rule, code: str, machine: str) -> bool:
    """Return whether a rule speaks of a code, by the usual name of what the code does."""
    if not code:
        return False
    lathe = machine.startswith("lathe")
    if rule.group == "turning" and machine and not lathe:
        return False
    if len(code) == 1:
        return re.search(rf"\b{code}\b(?! code)", rule.meaning) is not None
    if rule.group != "turning" and lathe and code in _OTHERWISE_ON_LATHES:
        return False
    texts = [rule.meaning, example_of(rule) or ""]
    return any(_names(text, code) for text in texts)


# What these codes are on a mill is what the rules of all machines speak of.
_OTHERWISE_ON_LATHES = {
    *(f"G{n}" for n in (36, 37, 50, 68, 69, 73, 74, 76, 90, 92, 94, 98, 99)),
}


def _names(text: str, code: str) -> bool:
    """Return whether a text names a code, or a range in which it is: `G71 to G73`."""
    if not code[1:2].isdecimal():  # a code that is written as a word
        return re.search(rf"\b{code}\b", text) is not None
    for letter, first, last in _NAMED.findall(text):
        if letter != code[0]:
            continue
        number = float(code[1:])
        if number == float(first) or (last and float(first) <= number <= float(last)):
            return True
    return False


def _arguments(control: Control, facts: Facts) -> Facts:
    """Return the local variable of each argument of a macro call; the control itself is asked."""
    if not any("arguments of the macro" in says for _, says, _ in facts["words"]):
        return {}
    found = {}
    for letter in _ARGUMENTS:
        text = f"O1\n{facts['name']} P2 {letter}1\nG0 X1.\nM30\nO2\nM99\n"
        run = loads(text, control=control).run(max_blocks=4, trace="calls")
        calls = [inner for call in run.calls.tree() for inner in (call, *call.calls)]
        locals_given = {number for call in calls for number in call.arguments}
        if len(locals_given) == 1:
            found[letter] = f"#{locals_given.pop()}"
    return found
