"""`cncsub ask`: what no source says of a control, as short programs for the owner of one."""

from __future__ import annotations

from dataclasses import asdict
from typing import Annotated, Any

import typer

from cncsub.cli.options import Format, Output, control_named, wrong_use
from cncsub.cli.output import write_json, write_text
from cncsub.controls import evidence_words, names_beginning
from cncsub.escapes import shown
from cncsub.questions.asking import MOST_LINES, Question, questions, unsettled
from cncsub.reports.printing import Console, print_wrapped

_HEAD = (
    "Each program shows, by what the machine does, which value a rule has. Run it with the machine"
    " locked, without a tool and without a part. What is seen is as cncsub computes it from X0 Y0"
    " Z0 with no offsets. The value that cncsub takes today has a *."
)


def ask(
    name: Annotated[
        str, typer.Argument(help="The control.", autocompletion=names_beginning, show_default=False)
    ],
    words: Annotated[
        list[str] | None,
        typer.Argument(
            help="Only rules whose names or meanings hold all of these words.", show_default=False
        ),
    ] = None,
    format: Annotated[Format, typer.Option()] = Format.TEXT,
    output: Output = None,
) -> None:
    """Print what no source says of a control, each with a program of at most five lines that an
    owner of the machine can run, and what each answer would mean.
    """
    control = control_named(name)
    asked = list(questions(control, tuple(words or ())))
    with wrong_use():
        if words and not asked:
            raise ValueError(
                f"nothing with {' and '.join(words)} is open on {control.name};"
                f" `cncsub ask {control.name}` prints all that is"
            )
    if format is Format.JSON:
        write_json(output, {"name": control.name, "questions": list(map(question_facts, asked))})
        return

    def told(console: Console) -> None:
        print_wrapped(
            console,
            shown(f"{control.title}: of its rules {evidence_words(control)} are inferred. {_HEAD}"),
        )
        for question in asked:
            if question.program:
                _print_question(console, question)
        if left := unsettled(asked):
            print_wrapped(console, "")
            head = (
                f"No program of {MOST_LINES} lines is known that tells the values of these apart:"
            )
            print_wrapped(console, shown(f"{head} {'; '.join(left)}."))

    write_text(output, told)


def question_facts(question: Question) -> dict[str, Any]:
    """Return a question as plain values."""
    return {"name": question.name} | asdict(question)


def _print_question(console: Console, question: Question) -> None:
    print_wrapped(console, "")
    print_wrapped(console, shown(f"{question.name}: {question.meaning} [{question.source}]"))
    if question.machine:
        print_wrapped(console, f"  on a machine of the kind {question.machine}")
    for line in question.program.splitlines():
        print_wrapped(console, shown(f"    {line}"))
    for answer in question.answers:
        mark = "*" if answer.ours else " "
        print_wrapped(console, shown(f" {mark} {answer.seen}  ->  {' or '.join(answer.values)}"))
