"""The path of the tool in a plane: from above, or as one looks at a lathe."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from cncsub.drawing import marks
from cncsub.drawing.colours import ALARM, HOLE, TEXT, TOOL_CHANGE
from cncsub.drawing.path import RAPID, TURNING, suitable_view
from cncsub.drawing.points import line_runs
from cncsub.plot.colours import BANDS, mixed
from cncsub.plot.figure import OTHERS, axis, count, shown_text
from cncsub.plot.player import TOOL, controls
from cncsub.plot.space import CODES, Picture, Stretches, alarm_place

if TYPE_CHECKING:
    from cncsub.drawing.path import View
    from cncsub.drawing.points import Drawn, Points
    from cncsub.plot.player import Instants

    Numbers = np.ndarray[Any, np.dtype[Any]]

_MANY = 15_000  # points from which the graphics processor draws
_TRAIL = 150  # points of the path up to an instant
_MOST_NUMBERED, _MOST_CHANGES = 60, 30
_PALE = 0.3  # of lines, while the tool is on its way


class PlanePicture(Picture):
    """A path that is seen whole from one side."""

    view: View
    axes_height = 44
    radius_words = " X is drawn as a radius; its numbers are diameters."

    def _data(
        self, drawn: Drawn, tool: Drawn | None, instants: Instants | None
    ) -> tuple[list[dict[str, Any]], dict[str, Any]]:
        turned = bool(self.core.diameters & 1)
        self.view = suitable_view(self.core, self.first, self.last, drawn.xyz, turned)
        self._factors = [2.0 if turned and at == 0 else 1.0 for at in self._axes]
        hover = self._hover(drawn)
        paths = [(drawn, some) for some in self._stretches(drawn)]
        if tool is not None:
            paths.append((tool, self._of_tool(tool)))
        data = [
            self._trace(of, some, hover if some.told else None, {"color": some.colours[0]})
            for of, some in paths
        ]
        lines = len(data)
        if self.colouring.scaled:
            data.append(self._scale_in_the_plane(drawn))
        data += [*self._holes(), *self._changes(), *self.alarm_mark()]
        if instants is None:
            return data, self._axes_of(drawn)
        data += list(self._tool_at(drawn))
        more = {
            "frames": self._frames(drawn, instants, lines, len(data)),
            **controls(instants, self.axes_height),
        }
        return data, {**self._axes_of(drawn), **more}

    @property
    def _axes(self) -> tuple[int, int]:
        return self.view.right, self.view.up

    def _flat(self, points: Numbers) -> tuple[Numbers, Numbers]:
        """Return points, X Y Z, as numbers on the axes."""
        right, up = (points[:, at] * f for at, f in zip(self._axes, self._factors))
        return right, up

    def _scene(self, drawn: Drawn) -> dict[str, Any] | None:
        return None

    def _axes_of(self, drawn: Drawn) -> dict[str, Any]:
        """Return the axes: a millimetre is as long on both."""
        sides = self._flat(drawn.xyz)
        room = 0.06 * max(float(np.ptp(s)) / f for s, f in zip(sides, self._factors)) or 1.0
        ranges = [
            [float(side.min()) - room * factor, float(side.max()) + room * factor]
            for side, factor in zip(sides, self._factors)
        ]
        name = "machine " if self.coordinates == "machine" else ""
        right, up = (
            f"{name}{letter}{' diameter' if factor == 2 else ''}, mm"
            for letter, factor in zip(self.view.letters(), self._factors)
        )
        true = {"scaleanchor": "x", "scaleratio": self._factors[0] / self._factors[1]}
        return {
            "xaxis": axis(right, range=ranges[0]),
            "yaxis": axis(up, range=ranges[1], **true),
            "dragmode": "pan",
            "hovermode": "closest",
        }

    # ---- lines ----

    def _stretches(self, drawn: Drawn) -> Iterator[Stretches]:
        if not self.colouring.scaled:
            yield from super()._stretches(drawn)
            return
        family = np.where(drawn.keys < 0, -1, drawn.keys // CODES)
        for band in range(BANDS):
            mask = (family > RAPID) & (drawn.keys % CODES == band)
            if mask.any():
                runs = line_runs(mask, drawn.keys)
                yield Stretches(*runs, "", [mixed((band + 0.5) / BANDS)], width=4)
        if (family == RAPID).any():
            runs = line_runs(family == RAPID, drawn.keys)
            yield Stretches(*runs, "rapid", [OTHERS], dash="dash", width=2)

    def _trace(
        self, drawn: Drawn, some: Stretches, hover: list[str] | None, line: dict[str, Any]
    ) -> dict[str, Any]:
        points = drawn.xyz[some.places]
        points[some.places < 0] = np.nan
        right, up = self._flat(points)
        made = super()._trace(drawn, some, hover, line)
        del made["z"]
        words = "the tool" if hover is None else "%{text}"
        many = len(drawn.points) > _MANY
        true = {} if many else {"simplify": False}  # else plotly leaves out points that can be seen
        return {
            **made,
            "type": "scattergl" if many else "scatter",
            "x": right,
            "y": up,
            "hovertemplate": f"{words}<br>{self._place_words()}<extra></extra>",
            "line": {**made["line"], "width": some.width / 2, **true},
        }

    def _place_words(self) -> str:
        right, up = self.view.letters()
        return f"{right}%{{x:.3f}} {up}%{{y:.3f}}"

    def _scale_in_the_plane(self, drawn: Drawn) -> dict[str, Any]:
        made = self._scale_beside(drawn)
        del made["z"]
        return {**made, "type": "scatter"}

    # ---- marks ----

    def _of_run(self) -> marks.Moved:
        turned = bool(self.core.diameters & 1)
        return marks.Moved(self.core, self.coordinates, turned, self.first, self.last)

    def _mark(self, points: Numbers, name: str, colour: str, symbol: str) -> dict[str, Any]:
        right, up = self._flat(points)
        return {
            "type": "scatter",
            "mode": "markers",
            "x": right,
            "y": up,
            "name": name,
            "showlegend": True,
            "marker": {"size": 11, "color": colour, "symbol": symbol, "line": {"width": 2}},
            "textfont": {"color": TEXT, "size": 11},
            "cliponaxis": False,
        }

    def _holes(self) -> Iterator[dict[str, Any]]:
        if self.view == TURNING:
            return
        holes = marks.holes_of(self._of_run(), self.view)
        if not len(holes):
            return
        made = self._mark(holes.at, count(len(holes), "hole"), HOLE, "circle-open")
        numbers = [str(number + 1) for number in range(len(holes))]
        if len(holes) <= _MOST_NUMBERED:
            made |= {"mode": "markers+text", "text": numbers, "textposition": "top right"}
        else:
            made |= {"text": numbers, "marker": {**made["marker"], "size": 6}}
        letter = "XYZ"[self.view.along]
        depth = "%{customdata:.3f}"
        words = f"hole %{{text}}<br>{self._place_words()} to {letter}{depth}<extra></extra>"
        yield {**made, "customdata": holes.at[:, self.view.along], "hovertemplate": words}

    def _changes(self) -> Iterator[dict[str, Any]]:
        changes = marks.tool_changes(self._of_run(), self.view, _MOST_CHANGES)
        if not changes:
            return
        at = np.array([change.at for change in changes])
        made = self._mark(at, "tool change", TOOL_CHANGE, "diamond-open")
        names = [" ".join(f"T{tool}" for tool in change.tools[:3]) for change in changes]
        words = f"tool change: %{{text}}<br>{self._place_words()}<extra></extra>"
        text = {"mode": "markers+text", "text": names, "textposition": "top right"}
        yield {**made, **text, "hovertemplate": words}

    def alarm_mark(self) -> list[dict[str, Any]]:
        alarm = self.stopped_by
        if alarm is None:
            return []
        at = self._of_run().ends[-1:]
        made = self._mark(at, f"stopped by {alarm.number or alarm.cause}", ALARM, "circle-x-open")
        made["marker"] |= {"size": 19, "line": {"width": 3}}
        words = shown_text(str(alarm).partition("\n")[0])
        return [
            {**made, "hovertemplate": f"{words}<br>{shown_text(alarm_place(alarm))}<extra></extra>"}
        ]

    # ---- the tool on its way ----

    def _tool_at(self, drawn: Drawn) -> Iterator[dict[str, Any]]:
        """Yield the path up to an instant, which is empty at the last one, and the tool."""
        yield {
            "type": "scatter",
            "mode": "lines",
            "x": [None],
            "y": [None],
            "line": {"color": TOOL, "width": 3},
            "hoverinfo": "skip",
            "showlegend": False,
            "name": "the path so far",
        }
        right, up = self._flat(drawn.xyz[-1:])
        yield {
            "type": "scatter",
            "mode": "markers",
            "x": right,
            "y": up,
            "marker": {"size": 10, "color": TOOL, "line": {"color": TEXT, "width": 2}},
            "name": "tool",
            "showlegend": False,
            "hovertemplate": f"the tool<br>{self._place_words()}<extra></extra>",
        }

    def _frames(
        self, drawn: Drawn, instants: Instants, lines: int, traces: int
    ) -> list[dict[str, Any]]:
        """Return the pictures at the instants: the path pale, what is done of it, the tool."""
        points = drawn.points
        reached = instants.reached(points)
        right, up = (column.round(3) for column in self._flat(drawn.xyz))
        kept = _few(self.core, points)
        frames: list[dict[str, Any]] = []
        for number, last in enumerate(reached.tolist()):
            done = number == len(reached) - 1
            trail = [] if done else [*kept[kept < last].tolist(), last]
            x: list[float | None] = [None]
            y: list[float | None] = [None]
            for at in trail:
                if points.key[at] < 0:
                    x.append(None)
                    y.append(None)
                x.append(float(right[at]))
                y.append(float(up[at]))
            data: list[dict[str, Any]] = [{"opacity": 1.0 if done else _PALE}] * lines
            data += [{"x": x, "y": y}, {"x": [float(right[last])], "y": [float(up[last])]}]
            places = [*range(lines), traces - 2, traces - 1]
            frames.append({"name": str(number), "traces": places, "data": data})
        return frames


def _few(core: Any, points: Points) -> Numbers:
    """Return the points that are enough to show how far the path has come."""
    kept = np.arange(len(points))
    size = max(float(np.ptp(column)) for column in points.columns) or 1.0
    tolerance = size / 2_000
    key = np.where(points.key < 0, -1, 0).astype(np.int32)
    while len(kept) > _TRAIL and tolerance < size / 100:
        some = points.at(kept)
        kept = kept[core.thinned(*some.columns, key[kept], tolerance)]
        tolerance *= 2
    step = -(-len(kept) // _TRAIL)
    few: Numbers = kept[::step]
    return few
