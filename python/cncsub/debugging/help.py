"""What is shown of a text that is pointed at or being typed, and where a variable was written."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

from cncsub import _core
from cncsub.breakpoints import Breakpoint, Compiled
from cncsub.debugging.frames import StackFrame
from cncsub.debugging.scopes import MODAL_SCOPES, StateFacts, value_text
from cncsub.debugging.values import evaluate, number_of
from cncsub.machine import Machine
from cncsub.program import Block
from cncsub.reports.code_facts import code_explanations


class Completion(NamedTuple):
    """A text that may stand in place of what was typed: `text` goes from the column `start`, from
    1, to the place of typing. `kind`: `"variable"`, `"mode"` or `"word"`; `told`: its value or what
    it does.
    """

    text: str
    start: int
    kind: str
    told: str


@dataclass(frozen=True, slots=True)
class Written:
    """A block that gave a variable another value. `step` is its row in the table of steps; `value`
    is what was written.
    """

    step: int
    block: Block
    value: str


def hover(machine: Machine, text: str, frame: StackFrame) -> str:
    """Return the value of what is pointed at and what is known of it, each on a line; empty where
    nothing is.
    """
    asked = text.strip()
    lines = []
    with contextlib.suppress(KeyError, TypeError, ValueError):  # a code, a word, half an expression
        lines.append(f"{asked} = {evaluate(machine, asked, frame)}")
    control = machine.core.code.control
    explained = code_explanations(asked, [control])
    for fact in explained:
        machines = [machine for on in fact["on"] for machine in on["machines"]]
        lines.append(f"{', '.join(machines)}: {fact['does']}" if machines else fact["does"])
    if not explained and (number := number_of(machine, asked)) is not None:
        facts = machine.core.code.variable_facts(number)
        lines += [] if facts is None else [f"one of the {facts[0]}"]
    return "\n".join(lines)


def completions(
    machine: Machine, facts: StateFacts, frames: list[StackFrame], frame: StackFrame, typed: str
) -> list[Completion]:
    """Return what the end of a typed text may become: variables, modes, words of the language."""
    start = len(typed)
    while start > 0 and (typed[start - 1].isalnum() or typed[start - 1] in "_#$<"):
        start -= 1
    begun = typed[start:].upper()
    found: dict[str, Completion] = {}
    for scope in facts.scopes(frames, frame):
        kind = "mode" if scope.name in MODAL_SCOPES else "variable"
        for value in scope.values:
            found.setdefault(
                value.expression, Completion(value.expression, start + 1, kind, value.text)
            )
    for word, _, does in _core.keywords(machine.core.code.control):
        found.setdefault(word, Completion(word, start + 1, "word", does))
    return [each for name, each in found.items() if name.upper().startswith(begun)]


def search(past: Machine, what: str, most: int = 20) -> Iterator[Written]:
    """Yield the blocks that gave an expression another value, the last one first, over all blocks
    that were executed. The machine, which goes back, is a copy. `ValueError` for what is no
    expression; `InterruptedError` where `pause` of the copy stops it.
    """
    for _ in range(most):
        step = Compiled(past.core, [Breakpoint(f"changes {what}")]).last_met()
        try:
            if step is None:
                raise InterruptedError
            if step < 0:
                return
            past.back(step)
        except InterruptedError:
            raise InterruptedError("the search was paused") from None
        block = past.next
        if block is None:
            return
        after = past.copy()
        after.step()
        value = after.evaluate(what)
        if value is None and len(after.stack) > len(past.stack):
            return  # nobody wrote it: the call opened the level of this local
        yield Written(step, block, value_text(value))
