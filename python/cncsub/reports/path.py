"""The path of a run as drawings: SVG with a link from each motion to its block."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from cncsub.escapes import escape
from cncsub.plot.points import drawn_path

if TYPE_CHECKING:
    from cncsub.run import Run

MOST_LINKED = 1_000  # moves that are links of their own
MOST_POINTS = 20_000  # of the drawings
_SIDE = 1000.0  # of a drawing, in its own units
_SLANT = np.array([[0.866, 0.0], [-0.866, 0.0], [0.0, 1.0]]) + np.array(
    [[0.0, 0.5], [0.0, 0.5], [0.0, 0.0]]
)


@dataclass(frozen=True)
class Path:
    """The points of a path with their motions. `points`: mm, X Y Z, X as a radius. `begins`:
    whether no line leads to the point. `told`: notes on what is left out. `breaks`: whether other
    coordinates came into force in between.
    """

    points: np.ndarray[Any, np.dtype[np.float64]]
    moves: np.ndarray[Any, np.dtype[np.int64]]
    begins: np.ndarray[Any, np.dtype[np.bool_]]
    rapid: np.ndarray[Any, np.dtype[np.bool_]]  # by motion
    diameters: bool
    told: tuple[str, ...]
    breaks: bool


def path_of(run: Run, coordinates: str = "work") -> Path:
    """Return the programmed path in work coordinates, or the tool's path in machine coordinates."""
    core, moves = run.recorded, len(run.moves)
    rapid = np.asarray(run.moves.kind == "rapid")
    keys = np.arange(moves) if moves <= MOST_LINKED else np.where(rapid, 0, 1)
    drawn = drawn_path(core, coordinates, (0, moves), keys.astype(np.int32), MOST_POINTS)
    told = drawn.told
    if drawn.behind is not None:
        told = [*told, f"Cut: nothing after move {drawn.behind:,} of {moves:,} is drawn."]
    begins = drawn.keys < 0
    turned = bool(core.diameters & 1)
    return Path(drawn.xyz, drawn.points.move, begins, rapid, turned, tuple(told), drawn.breaks > 0)


# ---- drawings ----

Place = Callable[[int], tuple[str, str]]  # of a motion: the link and the words for its block


def views(path: Path, place: Place) -> Iterator[str]:
    """Yield the drawings that show something, each a figure with its caption."""
    wide = np.ptp(path.points, axis=0) > 1e-9
    if wide[0] and wide[2] and (path.diameters or not wide[1]):
        yield _figure("Z and X", path.points[:, [2, 0]], path, place)
        return
    for name, (a, b) in {"X and Y": (0, 1), "X and Z": (0, 2), "Y and Z": (1, 2)}.items():
        if (wide[a] and wide[b]) or (wide.sum() < 2 and (wide[a] or wide[b])):
            yield _figure(name, path.points[:, [a, b]], path, place)
            if wide.sum() < 2:
                return
    if wide.all():
        yield _figure("from above and the side", path.points @ _SLANT, path, place)


def _figure(name: str, flat: Any, path: Path, place: Place) -> str:
    low, size = flat.min(axis=0), float(np.ptp(flat, axis=0).max()) or 1.0
    scaled = (flat - low) / size * _SIDE
    scaled[:, 1] = scaled[:, 1].max() - scaled[:, 1]
    width, height = (max(float(side), 1.0) for side in scaled.max(axis=0))
    told = f"{name}, {size:.4g} mm across"
    lines = "".join(_lines(scaled, path, place))
    box = f"-20 -20 {width + 40:.1f} {height + 40:.1f}"
    return (
        f'<figure><svg viewBox="{box}" role="img" aria-label="path, {escape(told)}">{lines}</svg>'
        f"<figcaption>{escape(told)}</figcaption></figure>"
    )


def _lines(points: Any, path: Path, place: Place) -> Iterator[str]:
    """Yield a line for each motion while there are few, else for each stretch of one kind."""
    linked = len(path.rapid) <= MOST_LINKED
    moves = path.moves
    keys = moves.tolist() if linked else path.rapid[moves].tolist()
    begins = path.begins.tolist()
    stretch = np.cumsum(path.begins).tolist()
    for _, group in itertools.groupby(range(len(moves)), lambda row: (stretch[row], keys[row])):
        rows = list(group)
        drawn = rows if begins[rows[0]] else [rows[0] - 1, *rows]
        if len(drawn) < 2:
            continue
        move = int(moves[rows[0]])
        ends = " ".join(f"{x:.1f},{y:.1f}" for x, y in points[drawn])
        kind = ' class="rapid"' if path.rapid[move] else ""
        line = f'<polyline{kind} points="{ends}"/>'
        if linked:
            link, words = place(move)
            title = f"<title>{escape(words)}</title>"
            line = f'<a href="{escape(link)}" tabindex="-1">{title}{line}</a>'
        yield line
