"""The text of what a run did, which stays the same as long as the run does."""

from __future__ import annotations

from collections.abc import Iterator

from cncsub._core import variable_name
from cncsub.run import Run
from cncsub.testing.moves import made_moves
from cncsub.testing.outcome import call_tree, executed


def told(run: Run) -> str:
    """Return the stop, blocks, calls, moves, codes, messages and variables of a run, a line for
    each.
    """
    return "\n".join(_lines(run)) + "\n"


def _lines(run: Run) -> Iterator[str]:
    yield f"stop: {run.stop.value}"
    if run.alarm is not None:
        at = run.alarm.program + ("" if run.alarm.n is None else f" N{run.alarm.n}")
        yield f"alarm: {run.alarm.cause} {run.alarm.number or ''} at {at}".replace("  ", " ")
    if len(run.steps):
        yield f"runs: {' '.join(executed(run, with_program=True))}"
    if len(run.calls):
        yield f"calls: {call_tree(run)}"
    for name, codes in (("m", run.m_codes), ("t", run.t_codes)):
        if codes:
            yield f"{name}: {' '.join(map(str, codes))}"
    yield from (f"message: {message}" for message in run.messages)
    yield from (f"dropped: {word.text}" for word in run.dropped)
    yield from (f"move: {move}" for move in made_moves(run.moves))
    for number in sorted(run.variables):
        value = run.variables[number]
        name = variable_name(run.recorded.control, number)
        yield f"{name} = {'vacant' if value is None else f'{value:.10g}'}"
