"""A page for each control with what no source says of it: programs for the owner of a machine, and
what each answer would mean. `cncsub ask` prints the same.
"""

from __future__ import annotations

import cncsub
from cncsub.questions.asking import MOST_LINES, Question, questions, unsettled
from generator.markdown import code, fenced, table, words

_INDEX = "questions/index.md"
_HEAD = f"""\
# Open questions

What no source says of a control is inferred. An owner of the machine can settle much of it:
`cncsub ask CONTROL` prints, for each such rule, a program of at most {MOST_LINES} lines, what the
machine may do with it, and which value of the rule that would mean. The programs are what is left
of conformance rows after every line without which they still tell the values apart, or are made of
the examples of the rule; that they tell is tried on the engine with each value.
Run them with the machine locked, without a tool and without a part.

"""


def names() -> list[str]:
    return [_INDEX, *(f"questions/{name}.md" for name in cncsub.controls)]


def pages() -> dict[str, str]:
    asked = {name: list(questions(control)) for name, control in cncsub.controls.items()}
    rows = (
        [
            f"[{code(name)}]({name}.md)",
            str(sum(bool(one.program) for one in of)),
            str(sum(not one.program for one in of)),
        ]
        for name, of in asked.items()
    )
    heads = ("control", "questions with a program", "rules and entries without one")
    made = {f"questions/{name}.md": _page(name, of) for name, of in asked.items()}
    return {_INDEX: _HEAD + table(heads, rows), **made}


def _page(name: str, asked: list[Question]) -> str:
    title = words(cncsub.controls[name].title)
    text = f"# Open questions on the {title}\n\n`cncsub ask {name}` prints the same.\n\n"
    for one in asked:
        if one.program:
            text += f"## {one.name}\n\n{words(one.meaning)} ({words(one.source)})"
            text += f", on a machine of the kind `{one.machine}`:\n\n" if one.machine else ":\n\n"
            text += fenced("text", one.program) + "\n"
            rows = (
                [
                    words(answer.seen),
                    words(" or ".join(answer.values)),
                    "yes" if answer.ours else "",
                ]
                for answer in one.answers
            )
            text += table(("the machine", "means", "taken today"), rows) + "\n"
    if left := unsettled(asked):
        text += f"## Without a program\n\nNo program of {MOST_LINES} lines is known that tells the"
        text += f" values of these apart: {words('; '.join(left))}.\n"
    return text
