"""Flatten generated programs of LinuxCNC's motion: the flat program makes the moves of its
original, on cncsub and on LinuxCNC's interpreter `rs274`.

    python tests/differential/linuxcnc_flat.py --programs 24000 --together 20
    python tests/differential/linuxcnc_flat.py --programs 1000 --kinds polar,turns
    python tests/differential/linuxcnc_flat.py --show 17

On cncsub the moves are the same to a billionth of a millimetre. Programs whose modes are saved in
calls have no flat program; they are counted.
"""

from __future__ import annotations

import re
import sys
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

import canonical
import cncsub
from linuxcnc_paths import KINDS, SETUP, Rs274, difference, program

NEAR = 1e-9  # mm
SHOWN = 5
COLUMNS = ("x", "y", "z", "a", "mx", "my", "mz", "cx", "cy", "cz", "feed", "time", "length")


@dataclass
class Report:
    programs: int = 0
    moves: int = 0
    refused: Counter[str] = field(default_factory=Counter)
    different: list[int] = field(default_factory=list)

    def __str__(self) -> str:
        lines = [
            f"{self.programs} programs flattened, {self.moves} moves, {sum(self.refused.values())} refused,"
            f" {len(self.different)} different",
            *(f"    {count:>6}  {reason}" for reason, count in self.refused.most_common()),
        ]
        return "\n".join(lines)


def apart(one: cncsub.Run, other: cncsub.Run) -> str:
    """Return how the moves and messages of two runs differ, empty if they are the same."""
    if len(one.moves) != len(other.moves):
        return f"{len(other.moves)} moves instead of {len(one.moves)}"
    if not np.array_equal(one.moves.kind, other.moves.kind):
        return "other kinds of moves"
    for name in COLUMNS:
        a, b = (
            np.asarray(getattr(run.moves, name, np.zeros(0)), dtype=float) for run in (one, other)
        )
        if a.shape != b.shape or not np.allclose(a, b, rtol=0, atol=NEAR, equal_nan=True):
            return f"another {name}"
    return "" if list(one.messages) == list(other.messages) else "other messages"


def compare(
    seed: int,
    places: range,
    command: str | None,
    folder: Path,
    together: int = 1,
    kinds: Sequence[str] = (),
) -> Report:
    """Compare programs; without `command` the flat programs run on cncsub alone."""
    rs274 = Rs274(command, folder) if command else None
    report = Report()
    for place in places[::together]:
        judge(report, seed, range(place, min(place + together, places.stop)), rs274, kinds)
    return report


def in_mm(flat: str, text: str) -> str:
    """Return the flat text, with the mark that a length is in mm where its original has it."""
    lengths = "|".join(set(re.findall(r"#(\d+) = \S+ \(mm\)", text)))
    return re.sub(rf"(?m)^#({lengths})=(\S+)$", r"#\1 = \2 (mm)", flat) if lengths else flat


def judge(
    report: Report, seed: int, many: range, rs274: Rs274 | None, kinds: Sequence[str]
) -> None:
    text = program(seed, many, True, kinds)
    library = cncsub.loads(text, control="linuxcnc", name="main.ngc")
    run = library.run(setup=SETUP)
    if run.stop is not cncsub.Stop.END:
        if len(many) > 1:
            return each(report, seed, many, rs274, kinds)
        report.programs += 1
        report.refused["the run does not end"] += 1
        return None
    try:
        flat = library.flatten(setup=SETUP).text
    except cncsub.FlattenError as error:
        if len(many) > 1:
            return each(report, seed, many, rs274, kinds)
        report.programs += 1
        report.refused[error.reason] += 1
        return None
    found = apart(run, cncsub.loads(flat, control="linuxcnc", name="main.ngc").run(setup=SETUP))
    if not found and rs274 is not None:
        before, after = rs274.run(text), rs274.run(in_mm(flat, text))
        found = difference(after, before) if before is not None and after is not None else ""
    if found and len(many) > 1:
        return each(report, seed, many, rs274, kinds)
    report.programs += len(many)
    report.moves += len(run.moves)
    if found:
        report.different.append(many.start)
        if len(report.different) <= SHOWN:
            print(f"---- program {many.start} of seed {seed}: {found}\n{text}\n----\n{flat}")
    return None


def each(report: Report, seed: int, many: range, rs274: Rs274 | None, kinds: Sequence[str]) -> None:
    for place in many:
        judge(report, seed, range(place, place + 1), rs274, kinds)


def main() -> int:
    def text(seed: int, numbers: range, kinds: Sequence[str]) -> str:
        library = cncsub.loads(program(seed, numbers, True, kinds), control="linuxcnc")
        return library.flatten(setup=SETUP).text

    return canonical.command(__doc__ or "", text, compare, tuple(KINDS))


if __name__ == "__main__":
    sys.exit(main())
