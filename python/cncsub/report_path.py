"""The path of a run as drawings: SVG with a link from each motion to its block."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from cncsub.run import Run

MOST_LINKED = 1_000  # motions that are links of their own
MOST_POINTS = 20_000  # of one drawing
MOST_ARCS = 50_000  # drawn round
FINEST, WIDEST = 0.5, 4.0  # grids for thinning, in thousandths of the drawing
_TURN = np.pi / 18  # between two points of an arc
_PLANES = {17: (0, 1), 18: (2, 0), 19: (1, 2)}
_SIDE = 1000.0  # of a drawing, in its own units
_SLANT = np.array([[0.866, 0.0], [-0.866, 0.0], [0.0, 1.0]]) + np.array(
    [[0.0, 0.5], [0.0, 0.5], [0.0, 0.0]]
)


@dataclass(frozen=True)
class Path:
    """The ends of motions with what lies between: `points` (mm, X Y Z, X as a radius), and for each
    the motion it ends or passes.
    """

    points: np.ndarray[Any, np.dtype[np.float64]]
    moves: np.ndarray[Any, np.dtype[np.int64]]
    rapid: np.ndarray[Any, np.dtype[np.bool_]]  # by motion
    diameters: bool
    chords: int  # arcs drawn straight


def path_of(run: Run) -> Path:
    """The programmed path in work coordinates."""
    moves = run.moves
    ends = np.column_stack([moves.column(axis) for axis in "xyz"]).astype(float)
    ends = np.nan_to_num(ends)
    kinds = np.array(moves.kinds)[moves.kind] if len(moves) else np.array([], dtype=str)
    diameters = _diameters(ends, kinds, np.asarray(moves.length))
    if diameters:
        ends[:, 0] /= 2
    arcs = np.flatnonzero(np.isin(kinds, ("cw", "ccw")))
    arcs = arcs[arcs > 0]
    chords = max(0, len(arcs) - MOST_ARCS)
    centres = np.column_stack([moves.column(name) for name in ("cx", "cy", "cz")])
    if diameters:
        centres[:, 0] /= 2
    between = {
        int(move): _arc(ends[move - 1], ends[move], centres[move], *_turn(moves, kinds, move))
        for move in arcs[:MOST_ARCS]
    }
    counts = np.ones(len(ends), dtype=np.int64)
    for move, points in between.items():
        counts[move] = len(points)
    numbers = np.repeat(np.arange(len(ends)), counts)
    points = np.repeat(ends, counts, axis=0)
    first = np.cumsum(counts) - counts
    for move, curve in between.items():
        points[first[move] : first[move] + len(curve)] = curve
    return Path(points, numbers, kinds == "rapid", diameters, chords)


def _turn(moves: Any, kinds: Any, move: int) -> tuple[int, bool]:
    return int(moves.plane[move]), bool(kinds[move] == "cw")


def _diameters(ends: Any, kinds: Any, lengths: Any) -> bool:
    """Whether X counts diameters: told by the lengths of straight motions."""
    straight = np.isin(kinds, ("rapid", "feed"))[1:]
    way = np.diff(ends, axis=0)[straight]
    length = lengths[1:][straight]
    off = [
        np.abs(length - np.linalg.norm(way * (scale, 1, 1), axis=1)).sum() for scale in (1.0, 0.5)
    ]
    return bool(off[1] < off[0])


def _arc(start: Any, end: Any, centre: Any, plane: int, clockwise: bool) -> Any:
    """Points of an arc behind its start, up to its end; helices rise evenly."""
    a, b = _PLANES.get(plane, (0, 1))
    if np.isnan(centre[a]) or np.isnan(centre[b]):
        return end[np.newaxis]
    first, last = (np.arctan2(p[b] - centre[b], p[a] - centre[a]) for p in (start, end))
    sweep = (first - last if clockwise else last - first) % (2 * np.pi)
    if sweep < 1e-9:
        sweep = 2 * np.pi
    part = np.linspace(0, 1, max(2, int(np.ceil(sweep / _TURN))) + 1)[1:]
    angle = first + part * (-sweep if clockwise else sweep)
    radii = [np.hypot(p[a] - centre[a], p[b] - centre[b]) for p in (start, end)]
    radius = radii[0] + part * (radii[1] - radii[0])
    points = start + part[:, np.newaxis] * (end - start)
    points[:, a] = centre[a] + radius * np.cos(angle)
    points[:, b] = centre[b] + radius * np.sin(angle)
    points[-1] = end
    return points


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
    kept, grid = _thinned(scaled)
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


def _thinned(points: Any) -> tuple[Any, float]:
    """The rows to draw: those that leave their cell of a grid, which gets wider until few enough
    are left, but no wider than what the eye sees. The first grid is finer than any screen.
    """
    grid = FINEST
    if len(points) <= MOST_POINTS:
        return np.arange(len(points)), 0.0
    while True:
        cells = np.floor(points / grid)
        moved = np.any(np.diff(cells, axis=0) != 0, axis=1)
        kept = np.flatnonzero(np.concatenate(([True], moved)))
        if len(kept) <= MOST_POINTS or grid >= WIDEST:
            return kept, grid
        grid *= 2


def _lines(points: Any, kept: Any, path: Path, place: Place) -> Iterator[str]:
    """A line for each motion while there are few, else for each stretch of one kind."""
    linked = len(path.rapid) <= MOST_LINKED
    moves = path.moves[kept]
    keys = moves.tolist() if linked else path.rapid[moves].tolist()
    before = 0
    for _, group in itertools.groupby(range(len(kept)), keys.__getitem__):
        rows = list(group)
        drawn = kept[[before, *rows]]
        before = rows[-1]
        move = int(moves[rows[0]])
        ends = " ".join(f"{x:.1f},{y:.1f}" for x, y in points[drawn])
        kind = ' class="rapid"' if path.rapid[move] else ""
        line = f'<polyline{kind} points="{ends}"/>'
        if linked:
            link, words = place(move)
            title = f"<title>{escape(words)}</title>"
            line = f'<a href="{escape(link)}" tabindex="-1">{title}{line}</a>'
        yield line
