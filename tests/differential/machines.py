"""Runs written programs: on the controls of cncsub, and on LinuxCNC's interpreter `rs274`.

Both return their moves as an array with a row for each: kind, end X Y Z, centre X Y Z (0 if there
is none). Straight moves of no length are left out: LinuxCNC makes one for a bare G0.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from random import Random
from typing import Any

import numpy as np

import cncsub
from cncsub.questions.asking import ISO_FAMILY
from programs import CCW, CW, FEED, RAPID, Move, Program
from spelling import Speller, Style

KINDS = (RAPID, FEED, CW, CCW)
SLOT = {"X": 1, "Y": 2, "Z": 3}
Moves = Any  # of shape (moves, 7)


def table(moves: Sequence[Move]) -> Moves:
    """Return the moves that a program means."""
    rows = np.zeros((len(moves), 7))
    for row, move in zip(rows, moves, strict=True):
        row[0] = KINDS.index(move.kind)
        for axis, value in move.end.items():
            row[SLOT[axis]] = value / 1000
        for axis, value in move.centre.items():
            row[SLOT[axis] + 3] = value / 1000
    return rows


def as_lengths(rows: Moves) -> Moves:
    """Return the moves with diameters halved."""
    return rows * np.array([1, 0.5, 1, 1, 0.5, 1, 1])


# ---- the controls ----


@dataclass(frozen=True)
class Station:
    """A control, as the machine it is set up for."""

    name: str
    control: str
    setup: cncsub.Setup
    style: Style

    def mills(self) -> bool:
        return self.setup.machine == "mill"

    def moves(self, text: str) -> Moves | str:
        """Return the moves of a run, or how it stopped if not at its end."""
        run = cncsub.loads(text, control=self.control).run(setup=self.setup)
        if run.stop is not cncsub.Stop.END:
            return f"{run.stop}\n{run.alarm or ''}"
        made = run.moves
        codes = np.array([KINDS.index(kind) if kind in KINDS else -1 for kind in made.kinds] or [0])
        columns = [made.x, made.y, made.z, made.cx, made.cy, made.cz]
        rows = np.column_stack([codes[made.kind], *(np.nan_to_num(c) for c in columns)])
        return _with_length(as_lengths(rows) if self.style.diameter else rows)


OTHER_LANGUAGES = {name for name, of in cncsub.controls.items() if of.dialect not in ISO_FAMILY}


def stations() -> list[Station]:
    """Return every control of the ISO language as its own kind of machine, and again as lathes
    those mills that can be lathes.
    """
    names = [name for name in cncsub.controls if name not in OTHER_LANGUAGES]
    return [station for name in names for station in _stations_of(name)]


def _stations_of(name: str) -> Iterator[Station]:
    rules = {rule.name: rule.value for rule in cncsub.controls[name].rules}
    own = str(rules["machine"])
    machines = [own]
    if own == "mill" and name.startswith(("fanuc", "mitsubishi")):
        machines += ["lathe-a", "lathe-b"]
    for machine in machines:
        is_lathe = machine != "mill"
        parts = rules["program_word"] == "sequence-number"
        style = Style(
            head="" if parts else "%" if "percent" in str(rules["program_heads"]).split() else "O",
            diameter=is_lathe,
            increments_by_letter=machine == "lathe-a",
            count_in_p=rules["program_word"] == "count-and-number",
            count_in_l=rules["count_and_l"] != "no-l",
            reflex_radius=not is_lathe or rules["negative_radius"] == "long-way",
            plane_codes=not rules["g_codes"] or "18" in str(rules["g_codes"]).split(),
        )
        called = name if machine == own else f"{name} {machine}"
        yield Station(called, name, cncsub.Setup(machine=machine), style)


def _with_length(rows: Moves) -> Moves:
    """Return the rows without the straight moves that end where they start."""
    before = np.vstack([np.zeros((1, 7)), rows[:-1]])
    stays = np.abs(rows[:, 1:4] - before[:, 1:4]).max(axis=1, initial=0) < 1e-6
    return rows[~(stays & (rows[:, 0] < KINDS.index(CW)))]


# ---- LinuxCNC ----

LINUXCNC = "LinuxCNC"
HEAD = "G21 G90 G94 G40 G49 G80"
BETWEEN = "G90 G17 G0 X0 Y0 Z0"
_LINE = re.compile(r"(COMMENT|SELECT_PLANE|STRAIGHT_TRAVERSE|STRAIGHT_FEED|ARC_FEED)\((.*)\)")
_PLANE_AXES = {"XY": "XYZ", "XZ": "ZXY", "YZ": "YZX"}


def rs274() -> str | None:
    """Return the path of the interpreter if it is installed."""
    return shutil.which("rs274")


class LinuxCnc:
    """Runs many programs in one file, because a process is slow to start."""

    def __init__(self, command: str, folder: Path) -> None:
        self.command = command
        self.file = folder / "programs.ngc"
        self.tables = [folder / "tool.tbl", folder / "variables"]
        for file in self.tables:
            file.touch()

    def text(self, programs: Sequence[Program], random: Random) -> str:
        """Return one main program with the blocks of all, and their subprograms after it."""
        main, behind = [HEAD], []
        for place, program in enumerate(programs):
            style = replace(Style(), plus_number=10_000 * (place + 1))
            speller = Speller(style, random)
            main += [BETWEEN, "(program)", *speller.body(program), "(end)"]
            behind += [line for below in program.called() for line in speller.below(below)]
        return "\n".join([*main, "M30", *behind]) + "\n"

    def moves(self, text: str, count: int) -> list[Moves] | str:
        """Return the moves of each program of the text, or the error of the interpreter."""
        self.file.write_text(text)
        tools, variables = map(str, self.tables)
        command = [self.command, "-t", tools, "-v", variables, "-g", str(self.file)]
        # The tool table lies in the home folder: two that share it kill each other (SIGBUS).
        environment = {**os.environ, "HOME": str(self.file.parent)}
        done = subprocess.run(command, capture_output=True, text=True, check=False, env=environment)
        rows = list(_read(done.stdout))
        if len(rows) != count:
            return f"{done.stderr}\nexit status {done.returncode}"
        return [_with_length(np.array(part).reshape(-1, 7)) for part in rows]


def _read(output: str) -> Iterator[list[list[float]]]:
    """Yield the rows of each program that came to its end."""
    rows: list[list[float]] | None = None
    axes = "XYZ"
    for word, inner in _LINE.findall(output):
        if word == "COMMENT":
            if inner == '"program"':
                rows = []
            elif inner == '"end"' and rows is not None:
                yield rows
                rows = None
        elif word == "SELECT_PLANE":
            axes = _PLANE_AXES[inner[-2:]]
        elif rows is not None:
            rows.append(_row(word, [float(value) for value in inner.split(",")], axes))


def _row(word: str, values: list[float], axes: str) -> list[float]:
    """Return the row of a call; ARC_FEED gives end and centre in the plane, the turn, the end
    across.
    """
    if word != "ARC_FEED":
        kind = RAPID if word == "STRAIGHT_TRAVERSE" else FEED
        return [KINDS.index(kind), *values[:3], 0, 0, 0]
    row = [0.0] * 7
    row[0] = KINDS.index(CCW if values[4] > 0 else CW)
    for axis, end, centre in zip(axes, [*values[:2], values[5]], [*values[2:4], 0.0], strict=True):
        row[SLOT[axis]], row[SLOT[axis] + 3] = end, centre
    return row
