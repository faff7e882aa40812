"""The command `cncsub explain`."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Annotated

import typer

import cncsub
from cncsub.checking import rule_named, rule_names
from cncsub.cli.options import (
    ControlName,
    Format,
    Output,
    WrongUseError,
    control_named,
    write_json,
    write_text,
    wrong_use,
)
from cncsub.reports.facts import explanations, unknown_alarm
from cncsub.reports.printing import print_explanations


def explain(
    alarm: Annotated[str, typer.Argument(help="An alarm number such as P232, a cause, or a rule.")],
    control: ControlName = None,
    format: Annotated[Format, typer.Option()] = Format.TEXT,
    output: Output = None,
) -> None:
    """Explain what an alarm means, what raises it and how to cure it, or what a rule finds."""
    if re.fullmatch(r"CS\d*", alarm, re.IGNORECASE) or _names_rule(alarm):
        _explain_rule(alarm, format, output)
        return
    among = list(cncsub.controls.values()) if control is None else [control_named(control)]
    facts = explanations(alarm, among)
    if not facts:
        raise WrongUseError(unknown_alarm(alarm, among, rule_names()))
    if format is Format.JSON:
        write_json(output, facts)
    else:
        write_text(output, lambda console: print_explanations(console, facts))


def _names_rule(asked: str) -> bool:
    return asked.lower() in rule_names() and asked.lower() not in cncsub.causes


def _explain_rule(name: str, format: Format, output: Path | None) -> None:
    with wrong_use():
        rule = rule_named(name)
    if format is Format.JSON:
        write_json(output, rule._asdict())
        return
    example = "".join(f"      {line}\n" for line in rule.example.splitlines())
    lines = [
        f"{rule.number} {rule.name}, {rule.severity}",
        f"  finds: {rule.meaning}",
        f"  cure: {rule.hint}",
        f"  example, on {rule.control}:",
        example.rstrip("\n"),
    ]
    write_text(output, lambda console: console.print("\n".join(lines)))
