"""The conditions of a run that read what is watched."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import Protocol

from cncsub.tables.of_runs import Conditions, Steps
from cncsub.tables.rows import Compared


class Ran(Protocol):
    """The part of a run that is read here."""

    @property
    def steps(self) -> Steps: ...
    @property
    def conditions(self) -> Conditions: ...


def conditions_on(run: Ran, watched: Collection[int]) -> Iterator[Compared]:
    """Yield the comparisons of conditions that read a watched variable by its number."""
    reading: dict[tuple[str, int], bool] = {}
    for row in run.conditions:
        key = (row.program, row.line)
        if key not in reading and row.step < len(run.steps):
            block = run.steps[row.step].block
            reads = block.reads if block is not None else ()
            reading[key] = any(use.variable in watched for use in reads)
        if reading.get(key):
            yield row
