"""The places of a path that a drawing marks: holes, tool changes, and where an alarm stopped it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from cncsub import _core
    from cncsub.drawing.path import Path, View

    Numbers = np.ndarray[Any, np.dtype[Any]]

_STILL = 1e-6  # mm: less is no move
_SAME = 1e-3  # mm: nearer places are one


@dataclass(frozen=True)
class Holes:
    """The holes along one axis, in the order in which they were begun. `at`: their places, mm, X Y
    Z, X as a radius, at the lowest point. `first_move`: the first move that cuts in each. `passes`:
    how often the tool came to each.
    """

    at: Numbers
    first_move: Numbers
    passes: Numbers

    def __len__(self) -> int:
        return len(self.at)


@dataclass(frozen=True)
class ToolChange:
    """A place where tools were changed, and the move after it."""

    at: tuple[float, float, float]
    tools: tuple[int, ...]
    move: int


class Moved:
    """Where some moves of a run begin and end, mm, X as a radius."""

    def __init__(
        self,
        core: _core.Trace,
        coordinates: str,
        diameters: bool,
        first: int = 0,
        last: int | None = None,
    ) -> None:
        before = "m" if coordinates == "machine" else ""
        ends = [f"{before}{axis}" for axis in "xyz"]
        begins = [f"{before}s{axis}" if not before else f"ms{axis}" for axis in "xyz"]
        whole = core.move_columns([*ends, *begins, "kind", "tool"])
        columns = {name: column[first:last] for name, column in whole.items()}
        self.ends = np.column_stack([columns[name] for name in ends])
        self.begins = np.column_stack([columns[name] for name in begins])
        if diameters:
            self.ends[:, 0] /= 2
            self.begins[:, 0] /= 2
        self.kind, self.tool = columns["kind"], columns["tool"]
        self.kinds = core.move_kinds

    def is_kind(self, *names: str) -> Numbers:
        return np.isin(self.kind, [self.kinds.index(name) for name in names])


def holes_of(moved: Moved, view: View) -> Holes:
    """Return the holes that are seen as points in a view: a rapid move leads there, a cut goes
    straight along the axis of the view, and a rapid move leads away.
    """
    flat = moved.ends[:, (view.right, view.up)] - moved.begins[:, (view.right, view.up)]
    rapid = moved.is_kind("rapid")
    aside = (np.abs(flat).max(axis=1, initial=0) > _STILL) | moved.is_kind("cw", "ccw")
    depth = moved.ends[:, view.along] - moved.begins[:, view.along]
    cuts = ~aside & ~rapid & (np.abs(depth) > _STILL)
    sideways = np.flatnonzero(aside)
    stretch = np.cumsum(aside)  # the moves that stay in one place between two that do not
    count = len(sideways) + 1
    quick = np.ones(count + 1, dtype=bool)  # the first place has no move before it, the last none
    quick[1:-1] = rapid[sideways]  # after it
    is_hole = np.zeros(count, dtype=bool)
    is_hole[stretch[cuts]] = True
    is_hole &= quick[:-1] & quick[1:]
    rows = np.flatnonzero(cuts & is_hole[stretch])
    if not len(rows):
        return Holes(np.zeros((0, 3)), rows, rows)
    return _gathered(moved.ends[rows], rows, stretch[rows], view)


def _gathered(at: Numbers, rows: Numbers, stretch: Numbers, view: View) -> Holes:
    """Return the holes of cuts; cuts in one place are one hole."""
    places = np.round(at[:, (view.right, view.up)] / _SAME).astype(np.int64)
    _, first, hole = np.unique(places, axis=0, return_index=True, return_inverse=True)
    hole = hole.reshape(-1)
    order = np.argsort(first)
    lowest = at[first].copy()
    deep = np.full(len(first), np.inf)
    np.minimum.at(deep, hole, at[:, view.along])
    lowest[:, view.along] = deep
    visits = np.unique(np.column_stack((hole, stretch)), axis=0)[:, 0]
    passes = np.bincount(visits, minlength=len(first))
    return Holes(lowest[order], rows[first][order], passes[order])


def tool_changes(moved: Moved, view: View, most: int) -> list[ToolChange]:
    """Return where tools were changed, at most so many places as they are seen in a view; the tool
    before the first move is one of them.
    """
    tool = moved.tool
    rows = np.flatnonzero(np.diff(tool, prepend=0) != 0)
    rows = rows[tool[rows] != 0]
    found: dict[tuple[int, ...], ToolChange] = {}
    for row in rows.tolist():
        at = moved.begins[row]
        if not np.isfinite(at).all():
            continue
        key = tuple(np.round(at[[view.right, view.up]] / _SAME).astype(np.int64).tolist())
        before = found.get(key)
        if before is None:
            if len(found) == most:
                break
            x, y, z = at.tolist()
            found[key] = ToolChange((x, y, z), (int(tool[row]),), row)
        elif int(tool[row]) not in before.tools:
            tools = (*before.tools, int(tool[row]))
            found[key] = ToolChange(before.at, tools, before.move)
    return list(found.values())


def last_place(moved: Moved, path: Path) -> Sequence[float] | None:
    """Return where the tool stood at the stop, mm; `None` where nothing moved."""
    if not len(moved.ends):
        return None
    last: list[float] = moved.ends[-1].tolist()
    return last if np.isfinite(last).all() else path.points[-1].tolist()
