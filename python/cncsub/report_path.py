"""The path of a run as drawings: SVG with a link from each motion to its block."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np

from cncsub.polyline import rough_size, sampled, sampling

if TYPE_CHECKING:
    from cncsub.run import Run

MOST_LINKED = 1_000  # motions that are links of their own
MOST_POINTS = 20_000  # of one drawing
MOST_SAMPLED = 2_000_000  # points, before they are thinned
FINEST, WIDEST = 0.5, 4.0  # grids for thinning, in thousandths of the drawing
_SIDE = 1000.0  # of a drawing, in its own units
_SLANT = np.array([[0.866, 0.0], [-0.866, 0.0], [0.0, 1.0]]) + np.array(
    [[0.0, 0.5], [0.0, 0.5], [0.0, 0.0]]
)


@dataclass(frozen=True)
class Path:
    """The points of a path, and for each the motion it belongs to: `points` (mm, X Y Z, X as a
    radius), `begins`: no line leads to the point.
    """

    points: np.ndarray[Any, np.dtype[np.float64]]
    moves: np.ndarray[Any, np.dtype[np.int64]]
    begins: np.ndarray[Any, np.dtype[np.bool_]]
    rapid: np.ndarray[Any, np.dtype[np.bool_]]  # by motion
    diameters: bool
    off: float  # mm that arcs are drawn off; 0 where nobody sees it


def path_of(run: Run, coordinates: str = "work") -> Path:
    """The programmed path in work coordinates, or that of the tool in machine coordinates."""
    moves = len(run.moves)
    most = max(MOST_SAMPLED, 2 * moves)
    size = rough_size(run._trace, coordinates, 0, moves)
    fine, coarse = sampling(run._trace, coordinates, 0, moves, most, size)
    line = sampled(run._trace, coordinates, fine, 0, moves, 1 << 40)
    assert not isinstance(line, int)
    rapid = np.asarray(run.moves.kind == "rapid")
    off = line.tolerance if coarse else 0.0
    return Path(line.points, line.move, line.begins, rapid, line.diameters, off)


# ---- drawings ----

Place = Callable[[int], tuple[str, str]]  # of a motion: the link and the words for its block


def views(path: Path, place: Place) -> Iterator[str]:
    """The drawings that show something, each a figure with its caption."""
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
    kept, grid = _thinned(scaled, path.begins)
    width, height = (max(float(side), 1.0) for side in scaled.max(axis=0))
    told = f"{name}, {size:.4g} mm across"
    if len(kept) < len(flat):
        told += (
            f"; thinned: {min(len(kept), MOST_POINTS):,} of {len(flat):,} points,"
            f" what moves less than {grid / _SIDE * size:.2g} mm is not drawn"
        )
    if len(kept) > MOST_POINTS:
        kept = kept[:MOST_POINTS]
        told += f", and nothing behind motion {path.moves[kept[-1]]:,} of {len(path.rapid):,}"
    lines = "".join(_lines(scaled, kept, path, place))
    box = f"-20 -20 {width + 40:.1f} {height + 40:.1f}"
    return (
        f'<figure><svg viewBox="{box}" role="img" aria-label="path, {escape(told)}">{lines}</svg>'
        f"<figcaption>{escape(told)}</figcaption></figure>"
    )


def _thinned(points: Any, begins: Any) -> tuple[Any, float]:
    """The rows to draw: those that leave their cell of a grid, which gets wider until few enough
    are left, but no wider than what the eye sees. The first grid is finer than any screen.
    """
    grid = FINEST
    if len(points) <= MOST_POINTS:
        return np.arange(len(points)), 0.0
    while True:
        cells = np.floor(points / grid)
        moved = np.any(np.diff(cells, axis=0) != 0, axis=1) | begins[1:]
        kept = np.flatnonzero(np.concatenate(([True], moved)))
        if len(kept) <= MOST_POINTS or grid >= WIDEST:
            return kept, grid
        grid *= 2


def _lines(points: Any, kept: Any, path: Path, place: Place) -> Iterator[str]:
    """A line for each motion while there are few, else for each stretch of one kind."""
    linked = len(path.rapid) <= MOST_LINKED
    moves = path.moves[kept]
    keys = moves.tolist() if linked else path.rapid[moves].tolist()
    begins = path.begins[kept].tolist()
    stretch = np.cumsum(path.begins[kept]).tolist()
    for _, group in itertools.groupby(range(len(kept)), lambda row: (stretch[row], keys[row])):
        rows = list(group)
        drawn = kept[rows if begins[rows[0]] else [rows[0] - 1, *rows]]
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
