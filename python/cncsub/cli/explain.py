"""The command `cncsub explain`."""

from __future__ import annotations

from typing import Annotated, Any

import typer

import cncsub
from cncsub.checking import CheckRule, rule_names
from cncsub.cli.options import ControlName, Format, Output, WrongUseError, control_named, wrong_use
from cncsub.cli.output import write_json, write_text
from cncsub.reports.explained import (
    known_facts,
    near_facts,
    print_check_rule,
    print_facts,
    print_near,
)
from cncsub.reports.facts import unknown_alarm
from cncsub.reports.nearest import is_told_by, nearest
from cncsub.reports.printing import Console, print_explanations


def explain(
    name: Annotated[
        list[str],
        typer.Argument(
            help="A code, a word of a program, an alarm number, a cause, a rule, a parameter;"
            " or a question.",
            show_default=False,
        ),
    ],
    control: ControlName = None,
    format: Annotated[Format, typer.Option()] = Format.TEXT,
    output: Output = None,
) -> None:
    """Explain a code, an alarm, a rule or a parameter; or find what a question is about.

    A few words find what is nearest to them by meaning: `cncsub explain nested too deep`.
    """
    asked = " ".join(name)
    among = list(cncsub.controls.values()) if control is None else [control_named(control)]
    with wrong_use():
        alarms, others, check = known_facts(asked, among)
    if not (check or alarms or others):
        _explain_near(asked, among, format, output)
        return
    if format is Format.JSON:
        if check is None:
            write_json(output, alarms + others)
        else:
            rule = check._asdict()
            write_json(output, [*alarms, *others, rule] if alarms or others else rule)
        return

    def write(console: Console) -> None:
        parts = 0
        for told in (alarms, others, check):
            if told and parts:
                console.print()
            parts += bool(told)
            if isinstance(told, CheckRule):
                print_check_rule(console, told)
            elif told is alarms:
                print_explanations(console, alarms)
            elif told:
                print_facts(console, others)

    write_text(output, write)


def _explain_near(asked: str, among: list[cncsub.Control], format: Format, output: Any) -> None:
    found = nearest(asked, among)
    if not found or (" " not in asked.strip() and not is_told_by(asked, found[0])):
        raise WrongUseError(unknown_alarm(asked, among, rule_names()))
    if format is Format.JSON:
        write_json(output, near_facts(found))
    else:
        write_text(output, lambda console: print_near(console, asked, found))
