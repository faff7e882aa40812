"""The points of a path that a picture draws: as many as it may, and what is told of the rest."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from cncsub import _core
from cncsub.polyline import Polyline, sampled_for_picture, size_of

Numbers = np.ndarray[Any, np.dtype[Any]]

_FINEST, _WIDEST = 1 / 20_000, 1 / 250  # of the size of the picture: first and last tolerance
_MOST_LOOKS = 4_000_000  # whether a line runs where another does


@dataclass(frozen=True)
class Drawn:
    """The points that are drawn, the family and the colour of the line that leads to each, and
    where a line begins.
    """

    points: Numbers
    move: Numbers
    part: Numbers  # how much of its move was made at a point
    keys: Numbers  # -1: no line leads to the point
    told: list[str]
    breaks: int  # where other coordinates came into force


def drawn_path(
    core: _core.Trace, coordinates: str, rows: tuple[int, int], keys: Numbers, most: int
) -> Drawn:
    """The points of the moves of some rows, from the first to the one behind the last, as many as
    may be drawn. `keys`: of each move that of its line, a number from 0 below 4,096, or -1: it is
    not drawn.
    """
    line, told = _sampled(core, coordinates, rows, most)
    first = int(line.move[0])
    key = keys[line.move - first]
    key[line.begins] = -1
    whole, size = len(line), size_of(line)
    kept = np.arange(whole)
    x, y, z = line.x, line.y, line.z
    off, tolerance = 0.0, size * _FINEST
    while len(kept) > most and tolerance <= size * _WIDEST:
        for _ in range(2):  # a second look finds what windows hid from the first
            if len(kept) <= most:
                break
            chosen = core.thinned(x, y, z, key, tolerance)
            off += tolerance
            before = len(kept)
            kept, key = kept[chosen], key[chosen]
            x, y, z = x[chosen], y[chosen], z[chosen]
            if len(kept) > before * 0.8:
                break
        if len(kept) > max(50 * most, 0.9 * whole):  # most of it goes here and there
            tolerance = max(tolerance * 3, size * _WIDEST)
        else:
            tolerance *= 1.5 if len(kept) < 4 * most else 3
    if len(kept) < whole:
        told.append(
            f"Thinned: {len(kept):,} of {whole:,} points; what is left out lies within"
            f" {_length(off)} of what is drawn."
        )
    last = int(kept[-1])
    kept, key, looked = _uncovered(kept, (x, y, z), key, size, most, told)
    return _finish(line, kept, key, told, most, looked, last)


def _sampled(
    core: _core.Trace, coordinates: str, rows: tuple[int, int], most: int
) -> tuple[Polyline, list[str]]:
    first, last = rows
    line, coarse = sampled_for_picture(
        core, coordinates, first, last, max(4 * most, 3 * (last - first))
    )
    arcs = [core.move_kinds.index(kind) for kind in ("cw", "ccw")]
    if coarse and np.isin(core.move_columns(["kind"])["kind"][first:last], arcs).any():
        return line, [f"Arcs are drawn within {_length(line.tolerance)}."]
    return line, []


def _uncovered(
    kept: Numbers,
    at: tuple[Numbers, Numbers, Numbers],
    key: Numbers,
    size: float,
    most: int,
    told: list[str],
) -> tuple[Numbers, Numbers, int]:
    """Without lines that run where others of their colour do already, as far as a picture
    shows; and the last point that was looked at.
    """
    if len(kept) <= most:
        return kept, key, int(kept[-1])
    cell = size * _WIDEST
    looked = _looked_at(at, cell)
    if looked < len(kept):  # the rest is cut
        kept, key = kept[:looked], key[:looked]
        at = (at[0][:looked], at[1][:looked], at[2][:looked])
    new = _new_lines(at, key, cell)
    told.append(
        f"Lines that run within {_length(cell * 2)} of one of their colour that was"
        " drawn before are left out."
    )
    ends = np.append(new[1:], False) | new  # the points that lines need
    drawn = np.where(new, key, -1)
    return kept[ends], drawn[ends], int(kept[-1])


def _finish(
    line: Polyline,
    kept: Numbers,
    key: Numbers,
    told: list[str],
    most: int,
    looked: int,
    last: int,
) -> Drawn:
    if len(kept) > most or looked < last:
        kept, key = kept[:most], key[:most]
        behind = int(line.move[kept[-1]])
        told.append(
            f"Cut: nothing behind move {behind:,} is drawn; moves=range({behind}, ...) shows"
            " the rest, most= draws more points."
        )
    points = np.column_stack((line.x[kept], line.y[kept], line.z[kept]))
    move = line.move[kept]
    firsts = np.searchsorted(line.move, move, side="left")
    lasts = np.searchsorted(line.move, move, side="right")
    begun = line.begins[firsts].astype(np.int64)  # its first point is where it starts
    part = (kept - firsts + 1 - begun) / np.maximum(1, lasts - firsts - begun)
    return Drawn(points, move, part, key, told, int(line.begins[1:].sum()))


def _length(mm: float) -> str:
    digit = 10.0 ** (math.floor(math.log10(mm)) - 1)
    return f"{math.ceil(mm / digit - 1e-9) * digit:.2g} mm"  # never less than it is


def _looks(at: tuple[Numbers, Numbers, Numbers], cell: float) -> Numbers:
    """In how many places to look where the line to each point but the first runs."""
    way = np.sqrt(sum(np.diff(column) ** 2 for column in at))
    looks: Numbers = np.ceil(way / (cell / 2)).astype(np.int64) + 1
    return looks


def _looked_at(at: tuple[Numbers, Numbers, Numbers], cell: float) -> int:
    """How many points there is time to look at."""
    return int(np.searchsorted(np.cumsum(_looks(at, cell)), _MOST_LOOKS, side="right")) + 1


def _new_lines(at: tuple[Numbers, Numbers, Numbers], key: Numbers, cell: float) -> Numbers:
    """Which points have a line that goes where none of its key went before, in cells of a grid."""
    x, y, z = at
    count_of = len(x)
    looks = _looks(at, cell)
    line = np.repeat(np.arange(1, count_of), looks)
    begun = np.cumsum(looks) - looks
    part = (np.arange(len(line)) - np.repeat(begun, looks)) / np.repeat(looks, looks)
    codes = np.zeros(len(line), dtype=np.int64)
    for column in (x, y, z):
        low = float(column.min())
        here = column[line - 1] + (column[line] - column[line - 1]) * part
        codes = codes * 1_024 + np.floor((here - low) / cell).astype(np.int64)
    codes = codes * 4_096 + key[line]
    _, first = np.unique(codes, return_index=True)
    new = np.zeros(count_of, dtype=bool)
    new[line[first]] = True
    return new & (key >= 0)


def line_runs(mask: Numbers, keys: Numbers) -> tuple[Numbers, Numbers]:
    """The points of the lines that are marked, as places in the path: each run with its start, and
    -1 between two runs; and which of them are starts. A run ends where the key changes.
    """
    marked = np.flatnonzero(mask)
    marked = marked[marked > 0]
    if not len(marked):
        return np.zeros(0, dtype=np.int64), np.zeros(0, dtype=bool)
    fresh = np.ones(len(marked), dtype=bool)
    fresh[1:] = (np.diff(marked) != 1) | (keys[marked[1:]] != keys[marked[:-1]])
    at = np.flatnonzero(fresh)
    # Before each start: a gap and the point that the line comes from.
    doubled = np.repeat(at, 2)
    added = np.column_stack((np.full(len(at), -1), marked[at] - 1)).ravel()
    places = np.insert(marked, doubled, added)
    starts = np.insert(np.zeros(len(marked), dtype=bool), doubled, np.tile([False, True], len(at)))
    return places[1:], starts[1:]
