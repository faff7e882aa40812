"""The path in a report: its drawings, and where each block leads on the main one."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

import numpy as np

from cncsub.drawing.path import further_views
from cncsub.drawing.svg import MOST_LINKED, MOST_POINTS, Picture
from cncsub.escapes import escape

if TYPE_CHECKING:
    from cncsub.drawing.path import Path
    from cncsub.reports.code import Anchors
    from cncsub.run import Run


class Drawn:
    """The drawings of the path of a run, with links to its blocks."""

    def __init__(self, run: Run, anchors: Anchors) -> None:
        self._run = run
        self._anchors = anchors
        self._picture = self._of("work") if len(run.moves) else None
        self._steps, self._kinds = run.moves.step, run.moves.kind
        self._names = run.moves.kinds

    def _of(self, coordinates: str) -> Picture:
        run = self._run
        return Picture(
            run,
            coordinates=coordinates,
            linked=MOST_LINKED,
            most=MOST_POINTS,
            inch=run.core.inch,
            alarm=run.alarm,
        )

    def _place(self, move: int) -> tuple[str, str]:
        words, link = self._anchors.block_of_step(int(self._steps[move]))
        return link, f"{words}: {self._names[self._kinds[move]]}"

    def section(self) -> Iterator[str]:
        """Yield the drawings, the one that suits first, and what has to be known of them."""
        picture = self._picture
        if picture is None:
            stopped = self._run.alarm is not None
            why = (
                "The program moved nothing before the alarm"
                if stopped
                else "The program moved nothing"
            )
            yield f"<p>{why}, or the run recorded no moves.</p>"
            return
        if not any(extent > 0 for extent in picture.path.extents):
            yield "<p>No move goes anywhere.</p>"
            return
        yield _figure(picture.words(), picture.svg(place=self._place))
        yield f'<p class="pale">{_words(picture.path)}. {escape(" ".join(picture.path.told))}</p>'
        yield from self._further(picture)
        tool = self._of("machine")
        if _moved(picture.path, tool.path):
            words = "The tool in machine coordinates, with all its offsets"
            yield _folded(words, [_figure(tool.words(), tool.svg(place=self._place))])

    def _further(self, picture: Picture) -> Iterator[str]:
        drawn = [
            _figure(picture.words(view), picture.svg(view, self._place))
            for view in further_views(picture.path)
        ]
        if all(picture.path.extents):
            drawn.append(_figure("from above and the side", picture.slanted(self._place)))
        if drawn:
            yield _folded("From other sides", drawn)

    def places(self) -> Mapping[tuple[str, int], str]:
        """Return by program and line where its moves end on the main drawing: the first of them."""
        if self._picture is None:
            return {}
        picture, steps = self._picture, self._run.steps
        _, first = np.unique(self._steps, return_index=True)
        of_block = steps.program[self._steps[first]], steps.line[self._steps[first]]
        program, line = (np.asarray(column) for column in of_block)
        _, seen = np.unique(np.column_stack((program, line)), axis=0, return_index=True)
        rows = first[seen]
        placed = picture.frame().placed(picture.moved.ends[rows]).tolist()
        names = steps.programs
        return {
            (names[int(program[at])], int(line[at])): f"{x:.1f} {y:.1f}"
            for at, (x, y) in zip(seen.tolist(), placed)
        }


def _figure(words: str, svg: str) -> str:
    return f"<figure>{svg}<figcaption>{escape(words)}</figcaption></figure>"


def _folded(words: str, figures: list[str]) -> str:
    inner = "".join(figures)
    return f'<details><summary>{words}</summary><div class="views">{inner}</div></details>'


def _words(path: Path) -> str:
    told = ["The programmed path in work coordinates; rapid moves are dashed"]
    if path.diameters:
        told.append("X is drawn as a radius, its numbers are diameters")
    if path.breaks:
        told.append("other coordinates came into force during the run: parts may overlap")
    if len(path.family) > MOST_LINKED:
        told.append(f"the first {MOST_LINKED:,} moves are links to their blocks")
    else:
        told.append("each move is a link to its block")
    told.append("point at a block to see where it moves")
    return "; ".join(told)


def _moved(path: Path, tool: Path) -> bool:
    """Return whether the tool goes another path than the program, and not only a shifted one."""
    if len(path.points) != len(tool.points):
        return True
    shifts = tool.points - path.points
    return bool(np.ptp(shifts, axis=0).max() > 1e-6) if len(shifts) else False
