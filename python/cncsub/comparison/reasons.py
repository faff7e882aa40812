"""Why two controls part, in words: the modes in force, and the rules that make the difference."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from cncsub import _core
from cncsub._core import Control, Rule

MOST_WORDS = 8  # of a list that is shown whole

# The modes that a column of the moves follows from.
_MODES = {
    "plane": ("plane",),
    "cx": ("plane", "units"),
    "cy": ("plane", "units"),
    "cz": ("plane", "units"),
    "feed": ("units", "feed_mode"),
    "feed_mode": ("feed_mode",),
    "spindle": ("surface",),
    "kind": ("return",),
    "h": ("length",),
    "d": ("radius",),
}
_OF_AXES = ("distance", "units", "work", "return", "scaling", "rotation", "polar", "mirror")


def reasons(
    controls: tuple[Control, Control],
    names: tuple[str, str],
    modes: Sequence[str],
    rules: Sequence[str],
    parameters: Sequence[str],
    untried: Sequence[str],
) -> tuple[str, ...]:
    """Return lines that say why two controls part; `modes` say what is in force on each."""
    lines = list(modes)
    if modes and rules:
        told = ", ".join(f"{name}: {', '.join(_values(controls, name))}" for name in rules)
        lines[-1] += f" (rule{'' if len(rules) == 1 else 's'} {told})"
    else:
        for name in rules:
            lines += _rule_lines(controls, names, name)
    for name in parameters:
        lines += _parameter_lines(controls, names, name)
    if untried:
        lines.append("rules whose values could not be exchanged: " + ", ".join(untried))
    return tuple(lines)


# ---- modes ----


def modes_apart(
    controls: tuple[Control, Control],
    names: tuple[str, str],
    modals: tuple[Mapping[str, str], Mapping[str, str]],
    column: str,
    machine: str,
) -> Iterator[str]:
    """Yield the modes of two controls that mean different things and decide on a column of the
    moves: `G17 in force on A, G18 on B`.
    """
    for mode in _MODES.get(column, _OF_AXES if column.lstrip("m") in "xyzabcuvw" else ()):
        codes = tuple(modal.get(mode) for modal in modals)
        if codes[0] is None or codes[1] is None:
            continue
        does = [_does(*pair, machine) for pair in zip(controls, codes, strict=True)]
        if does[0] != does[1]:
            one, other = names
            yield f"{codes[0]} in force on {one}, {codes[1]} on {other}"


def _does(control: Control, code: str | None, machine: str) -> str:
    facts = _core.code_facts(control, (code or "").partition(" ")[0], machine)
    return "" if facts is None else str(facts["does"])


# ---- rules ----


def _rule_of(control: Control, name: str) -> Rule | None:
    return next((rule for rule in control.rules if rule.name == name), None)


def _values(controls: tuple[Control, Control], name: str) -> list[str]:
    found = [_rule_of(control, name) for control in controls]
    return told_apart(*(None if rule is None else rule.value for rule in found))


def _rule_lines(
    controls: tuple[Control, Control], names: tuple[str, str], name: str
) -> Iterator[str]:
    found = [_rule_of(control, name) for control in controls]
    meaning = next((rule.meaning for rule in found if rule is not None), "")
    yield f"because of the rule {name}, {meaning}:"
    width = max(map(len, names))
    for side, rule, value in zip(names, found, _values(controls, name), strict=True):
        pairs = () if rule is None else zip(rule.choices, rule.examples, strict=False)
        example = next((e for choice, e in pairs if rule and choice == rule.value), "")
        yield f"  {side.ljust(width)}  {value}" + (f": {example}" if example else "")


def _parameter_lines(
    controls: tuple[Control, Control], names: tuple[str, str], name: str
) -> Iterator[str]:
    found = [control.parameters[name] for control in controls]
    yield f"because of the parameter {name}, {found[0].meaning}:"
    width = max(map(len, names))
    for side, parameter in zip(names, found, strict=True):
        yield f"  {side.ljust(width)}  {parameter.value:g}"


def value_text(value: object) -> str:
    """Return the value of a rule or a parameter as text."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:g}" if isinstance(value, float) else str(value) or "none"


def told_apart(*values: Any) -> list[str]:
    """Return two values as texts; of long lists only what the other has not."""
    lists = [str(value).split() for value in values]
    if None in values or max(map(len, lists)) <= MOST_WORDS:
        return ["is not there" if value is None else value_text(value) for value in values]
    return [
        "besides: " + (" ".join(word for word in mine if word not in other) or "nothing")
        for mine, other in (lists, lists[::-1])
    ]
