"""The colours of `run.plot()`: by name, or by a value on a scale."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from cncsub.drawing.colours import FAMILIES
from cncsub.drawing.path import families_of
from cncsub.plot.figure import COLOURS, OTHERS, count

if TYPE_CHECKING:
    from cncsub.run import Recorded

    Numbers = np.ndarray[Any, np.dtype[Any]]

BANDS = 24  # of colours that blend into each other
MOST_NAMES = 11  # colours beside that of the rest
_BY_NAME = ("kind", "program", "call", "tool", "depth")
_COLUMNS = {"call": "frame"}
WORDS = {"feed": "feed, mm/min or mm/rev", "time": "time, s", "z": "Z, mm"}
COLOURED_BY = (*_BY_NAME, *WORDS)
# From blue over green to orange: both ends are equally dark, and most eyes tell the colours apart.
SCALE = [(0.0, "#3b5bdb"), (0.33, "#1c9c8f"), (0.66, "#c9a227"), (1.0, "#e8590c")]


@dataclass(frozen=True)
class Colouring:
    """The colour of each move: a name of few, or a value on a scale."""

    by: str
    codes: Numbers  # by move, int32: a name, or a band of values
    names: list[str]  # of the codes, where they are names
    colours: list[str]
    values: Numbers | None = None  # by move

    @property
    def scaled(self) -> bool:
        return self.values is not None


class Moved:
    """The moves of some rows of a run, and their colours."""

    def __init__(self, run: Recorded, coordinates: str, first: int, last: int) -> None:
        self.run = run
        self.core = run.recorded
        self.coordinates = coordinates
        self.first, self.last = first, last
        self.families = families_of(self.core, first, last)

    def column(self, name: str) -> Numbers:
        column: Numbers = self.core.move_columns([name])[name]
        return column[self.first : self.last]

    def coloured(self, by: str) -> Colouring:
        if by == "kind":
            return Colouring(by, self.families, list(FAMILIES), list(FAMILIES.values()))
        if by in WORDS:
            values = self._values(by)
            low, high = float(values.min()), float(values.max())
            shares = (values - low) * (BANDS / ((high - low) or 1.0))
            bands = np.minimum(shares, BANDS - 1, out=shares).astype(np.int32)
            return Colouring(by, bands, [], [], values)
        return self._named(by)

    def _values(self, by: str) -> Numbers:
        if by == "time":
            times: Numbers = self.column("time").cumsum()
            return times
        if by == "feed":
            return self.column("feed")
        return self.column("z" if self.coordinates == "work" else "mz")

    def _named(self, by: str) -> Colouring:
        column = self.column(_COLUMNS.get(by, by))
        low, high = int(column.min()), int(column.max())
        if high - low > len(column) + 65_536:  # numbers of tools may lie far apart
            known, codes = np.unique(column, return_inverse=True)
        else:
            codes = column - low
            known = np.arange(low, high + 1)
        moves = np.bincount(codes, minlength=len(known))
        found = np.flatnonzero(moves)
        if len(found) <= MOST_NAMES + 1:
            kept, rest = found, []
        else:  # the names with the longest path have colours, the rest shares one
            way = np.bincount(codes, weights=self.column("length"), minlength=len(known))
            least = np.partition(way[found], -MOST_NAMES)[-MOST_NAMES]
            longer, as_long = found[way[found] > least], found[way[found] == least]
            kept = np.sort(np.append(longer, as_long[: MOST_NAMES - len(longer)]))
            rest = [f"{len(found) - MOST_NAMES:,} others"]
        place = np.full(len(known), len(kept), dtype=np.int32)
        place[kept] = np.arange(len(kept))
        names = [self._name(by, int(known[code])) for code in kept]
        colours = [COLOURS[place % len(COLOURS)] for place in range(len(kept))]
        return Colouring(by, place[codes], names + rest, colours + [OTHERS] * len(rest))

    def _name(self, by: str, code: int) -> str:
        if by == "program":
            return self.core.program_names[code] if code >= 0 else "no program"
        if by == "tool":
            return f"T{code}" if code else "no tool"
        if by == "depth":
            return f"{count(code, 'call')} deep" if code else "main program"
        if code < 0:
            return "main program"
        calls = self.run.calls
        if code < len(calls) and calls[code].call == code:
            return f"{calls[code].kind} {calls[code].program}, call {code}"
        return f"call {code}"


def mixed(share: float) -> str:
    """Return the colour at a share of the scale, from 0 to 1."""
    for (low, one), (high, other) in itertools.pairwise(SCALE):
        if share <= high:
            part = (share - low) / (high - low)
            pairs = zip(_parts(one), _parts(other))
            return "#" + "".join(f"{round(a + (b - a) * part):02x}" for a, b in pairs)
    return SCALE[-1][1]


def _parts(colour: str) -> tuple[int, ...]:
    return tuple(int(colour[at : at + 2], 16) for at in (1, 3, 5))
