"""What a drawing shows of a path: its points, its motions by family, and the view that suits it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from cncsub.drawing.points import drawn_path

if TYPE_CHECKING:
    from cncsub import _core

    Numbers = np.ndarray[Any, np.dtype[Any]]

RAPID, FEED, CYCLE, COMPENSATION = range(4)
_FLAT = 1e-6  # mm: less is no extent
_XY, _ZX, _YZ = 17, 18, 19


def families_of(core: _core.Trace, first: int, last: int) -> Numbers:
    """Return the family of each move: rapid, feed, cycle, compensation."""
    columns = core.move_columns(["compensated", "cycle", "kind"])
    compensated, cycle, kind = (columns[name][first:last] for name in columns)
    families = np.where(compensated, np.int32(COMPENSATION), np.int32(FEED))
    families[cycle != 0] = CYCLE
    families[kind == core.move_kinds.index("rapid")] = RAPID
    return families


@dataclass(frozen=True)
class View:
    """A view of a path along one axis. `right`, `up`, `along`: the axes, 0 for X."""

    name: str
    right: int
    up: int
    along: int

    def letters(self) -> tuple[str, str]:
        return "XYZ"[self.right], "XYZ"[self.up]


ABOVE = View("from above", 0, 1, 2)
FRONT = View("from the front", 0, 2, 1)
SIDE = View("from the right", 1, 2, 0)
TURNING = View("as on a lathe", 2, 0, 1)
VIEWS = (ABOVE, FRONT, SIDE)


@dataclass(frozen=True)
class Path:
    """The points of a path with their motions. `points`: mm, X Y Z, X as a radius. `begins`:
    whether no line leads to the point. `family`: by motion. `told`: notes on what is left out.
    `breaks`: whether other coordinates came into force in between. `view`: the one that suits.
    """

    points: np.ndarray[Any, np.dtype[np.float64]]
    moves: np.ndarray[Any, np.dtype[np.int64]]
    begins: np.ndarray[Any, np.dtype[np.bool_]]
    family: Numbers
    coordinates: str
    diameters: bool
    told: tuple[str, ...]
    breaks: bool
    view: View

    @property
    def rapid(self) -> np.ndarray[Any, np.dtype[np.bool_]]:
        """Whether each motion is a rapid one."""
        rapid: np.ndarray[Any, np.dtype[np.bool_]] = self.family == RAPID
        return rapid

    @property
    def extents(self) -> tuple[float, float, float]:
        """How far the path reaches along X, Y and Z, mm."""
        if not len(self.points):
            return 0.0, 0.0, 0.0
        x, y, z = np.ptp(self.points, axis=0).tolist()
        return x, y, z


def path_of(
    core: _core.Trace,
    coordinates: str = "work",
    *,
    linked: int,
    most: int,
    rows: tuple[int, int] | None = None,
) -> Path:
    """Return the programmed path in work coordinates, or the tool's path in machine coordinates, as
    `most` points at most. Up to `linked` motions are kept apart from each other. `rows`: the first
    of some moves, and the one after the last.
    """
    first, last = rows or (0, core.moves)
    moves = last - first
    families = families_of(core, first, last)
    keys = np.arange(moves) if moves <= linked else families
    drawn = drawn_path(core, coordinates, (first, last), keys.astype(np.int32), most)
    told = drawn.told
    if drawn.behind is not None:
        told = [*told, f"Cut: nothing after move {drawn.behind:,} of {core.moves:,} is drawn."]
    diameters = bool(core.diameters & 1)
    return Path(
        drawn.xyz,
        drawn.points.move - _number_of(core) - first,
        drawn.keys < 0,
        families,
        coordinates,
        diameters,
        tuple(told),
        drawn.breaks > 0,
        suitable_view(core, first, last, drawn.xyz, diameters),
    )


def _number_of(core: _core.Trace) -> int:
    """Return the number of the first move, which is not 0 in a later part of a stream."""
    return int(core.move_row(0)["move"]) if core.moves else 0


def suitable_view(
    core: _core.Trace, first: int, last: int, points: Numbers, diameters: bool
) -> View:
    """Return the view in which one looks at such a path: a lathe's path as on its drawing, a path
    in a plane at right angles to it, a path whose arcs all lie in G18 or G19 likewise, and any
    other from above.
    """
    columns = core.move_columns(["plane", "kind"])
    planes, kinds = columns["plane"][first:last], columns["kind"][first:last]
    x, y, z = (bool(np.ptp(points[:, axis]) > _FLAT) for axis in range(3))
    only = int(planes[0]) if len(planes) and (planes == planes[0]).all() else 0
    if diameters or (only == _ZX and not y):
        return TURNING
    if not y and z:
        return FRONT
    if not x and z:
        return SIDE
    arcs = planes[(kinds == core.move_kinds.index("cw")) | (kinds == core.move_kinds.index("ccw"))]
    if len(arcs) and z and (arcs == arcs[0]).all():
        return {_ZX: FRONT, _YZ: SIDE}.get(int(arcs[0]), ABOVE)
    return ABOVE


def in_a_plane(core: _core.Trace, first: int, last: int) -> bool:
    """Return whether a path is seen whole from one side: a lathe's path without Y, a path without
    extent along an axis, or cuts that go sideways at one depth only.
    """
    columns = core.move_columns([*"xyz", "sx", "sy", "sz", "kind", "plane"])
    begins = [columns[f"s{axis}"][first:last] for axis in "xyz"]
    ends = [columns[axis][first:last] for axis in "xyz"]
    kind, plane = columns["kind"][first:last], columns["plane"][first:last]
    arcs = (kind == core.move_kinds.index("cw")) | (kind == core.move_kinds.index("ccw"))
    x, y, z = (
        (np.abs(end - begin) > _FLAT) | (arcs & (plane != across))
        for end, begin, across in zip(ends, begins, (_YZ, _ZX, _XY))
    )
    if not (x.any() and y.any() and z.any()):
        return True
    if core.diameters & 1:
        return False
    sideways = (kind != core.move_kinds.index("rapid")) & (x | y)
    depths = np.concatenate((begins[2][sideways], ends[2][sideways]))
    return not (sideways & arcs & (plane != _XY)).any() and (
        not len(depths) or bool(np.ptp(depths) < _FLAT)
    )


def further_views(path: Path) -> list[View]:
    """Return the other views along an axis that show something."""
    if path.view == TURNING:
        return [ABOVE] if path.extents[1] > _FLAT else []
    wide = [extent > _FLAT for extent in path.extents]
    others = [view for view in VIEWS if view != path.view]
    return [view for view in others if wide[view.right] and wide[view.up]]
