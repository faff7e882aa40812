"""The rules of `cncsub check`, each with its example and what is found in it."""

from __future__ import annotations

import cncsub
from cncsub.checking import RULES, CheckRule
from generator.markdown import anchor, code, fenced, table, words

_PAGE = "reference/check.md"
_GROUPS = {
    "CS1": "What the control refuses",
    "CS2": "Calls",
    "CS3": "Ways",
    "CS4": "Nesting",
    "CS5": "Modes",
    "CS6": "Variables",
    "CS7": "Values",
    "CS8": "Writing",
}

_HEAD = """\
# Rules of check

What `cncsub check` finds, each with a program in which it is found. `cncsub explain CS201` prints
the same; a comment `(cncsub: ignore CS201)` switches a rule off for its line, `--ignore` and
`cncsub.toml` for all ([Checking](../guides/checking.md)).

"""


def names() -> list[str]:
    return [_PAGE]


def pages() -> dict[str, str]:
    rows = (
        [
            f"[{rule.number}](#{anchor(rule.number)})",
            code(rule.name),
            rule.severity,
            words(rule.meaning),
        ]
        for rule in RULES
    )
    text = _HEAD + table(("rule", "name", "severity", "finds"), rows) + "\n"
    group = ""
    for rule in RULES:
        if rule.number[:3] != group:
            group = rule.number[:3]
            text += f"## {_GROUPS.get(group, group)}\n\n"
        text += _told(rule)
    return {_PAGE: text}


def _told(rule: CheckRule) -> str:
    control = cncsub.controls[rule.control]
    library = cncsub.loads(rule.example, control=control)
    found = [finding for finding in library.check() if finding.rule == rule.number]
    if not found:
        raise ValueError(f"the example of {rule.number} has no such finding")
    return (
        f"### {rule.number} {rule.name} {{ #{anchor(rule.number)} }}\n\n"
        f"*{rule.severity}*: {words(rule.meaning)}.\n\n"
        f"Cure: {words(rule.hint)}.\n\n"
        f"On [{rule.control}](../controls/{rule.control}.md):\n\n"
        + fenced("nc", rule.example)
        + "\n"
        + fenced("text", str(found[0]))
        + "\n"
    )
