"""The last run of a program, as an editor shows it beside the blocks: values, positions, time."""

from __future__ import annotations

import time
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from cncsub import _core
from cncsub.cli.project import Project
from cncsub.inputs import Inputs
from cncsub.library import Library
from cncsub.machine import Machine
from cncsub.program import Block
from cncsub.run import Run
from cncsub.run_options import machine_with
from cncsub.setup import Setup
from cncsub.variables_file import read_variables

MOST_WATCHED = 1000  # variables that the engine records
MOST_STEPPED = 3_000  # blocks that are executed one by one for the values of their words
MOST_VALUES = 6  # of one word that are kept
_STEPPING = 0.2  # seconds

Place = tuple[int, int]  # a program of the memory, and a block of it


@dataclass
class LastRun:
    """A run, and the values that computed words took in its first blocks.

    `run`: the record. `words`: by program and block the values of each computed word, by its
    column; the first `MOST_VALUES` that differ.
    """

    run: Run
    library: Library
    words: dict[Place, dict[int, list[float | None]]] = field(default_factory=dict)

    @classmethod
    def of(
        cls, library: Library, project: Project, main: int, max_blocks: int, max_seconds: float
    ) -> LastRun:
        """Run a program, by its place in the memory, with what the project says of the machine."""
        options = options_of(project)
        watch, reads = _core.written_variables(library.code, MOST_WATCHED)
        limits: Any = {"max_blocks": max_blocks, "max_seconds": max_seconds}
        core = machine_with(library.code, main, **options, **limits, watch=watch, trace="moves")
        core.run()
        found = cls(Run(core), library)
        if reads:
            stepped: Any = {"max_blocks": min(max_blocks, MOST_STEPPED), "trace": "blocks"}
            found._step(Machine(machine_with(library.code, main, **options, **stepped)))
        return found

    def _step(self, machine: Machine) -> None:
        end = time.monotonic() + _STEPPING
        while (block := machine.next) is not None and time.monotonic() < end:
            place = block.program.index, block._index  # noqa: SLF001
            kept = self.words.setdefault(place, {})
            for column, text in computed_words(block):
                values = kept.setdefault(column, [])
                if len(values) < MOST_VALUES and (value := _value(machine, text)) not in values:
                    values.append(value)
            if machine.step() is None:
                return

    @property
    def took(self) -> str:
        """The time, the length and the number of blocks in words."""
        moves = self.run.moves
        seconds = moves.total_time
        clock = f"{int(seconds) // 60}:{int(seconds) % 60:02d} min"
        return f"{clock}, {moves.total_length:,.0f} mm, {self.run.blocks:,} blocks"

    def position_after(self, program: str, lines: Iterable[int]) -> dict[int, dict[str, float]]:
        """Return where the tool was after the blocks of some lines when they last moved it, in work
        coordinates by axis.
        """
        moves, steps = self.run.moves, self.run.steps
        if not len(moves) or program not in steps.programs:
            return {}
        of_step = np.asarray(moves.step)
        here = np.asarray(steps.program)[of_step] == steps.programs.index(program)
        line_of = np.asarray(steps.line)[of_step]
        rows = np.flatnonzero(here & np.isin(line_of, list(lines)))
        last = dict(zip(line_of[rows].tolist(), rows.tolist(), strict=True))
        return {
            line: {axis: float(getattr(moves, axis)[last[line]]) for axis in "xyz"}
            for line in sorted(last)
        }

    def values_of(self, variable: int) -> list[float | None]:
        """Return the values that a variable took, one after the other, the last `MOST_VALUES`."""
        watch = self.run.watch
        if variable not in watch.beginning:
            return []
        rows = np.flatnonzero(np.asarray(watch.variable) == variable)[-MOST_VALUES:]
        return [watch[int(row)].value for row in rows]


def options_of(project: Project) -> Any:
    """Return the options of a run that a project names files for."""
    options: dict[str, Any] = {}
    if project.setup is not None:
        options["setup"] = Setup.from_toml(project.setup)
    if project.inputs is not None:
        options["inputs"] = Inputs.from_toml(project.inputs)
    if project.variables is not None:
        options["variables"] = dict(read_variables(project.variables))
    return options


def computed_words(block: Block) -> list[tuple[int, str]]:
    """Return the column and the expression of each word whose value is computed."""
    found = []
    for token in block.tokens:
        word = token.word
        if word is not None and word.value is None and word.address.isalpha():
            expression = word.text[len(word.address) :].lstrip("=")
            if expression:
                found.append((token.column, expression))
    return found


def _value(machine: Machine, expression: str) -> float | None:
    try:
        value = machine.evaluate(expression)
        return None if isinstance(value, str) else value
    except (KeyError, ValueError):
        return None
