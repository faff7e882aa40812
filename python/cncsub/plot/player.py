"""The slider of `run.plot()`: the path up to an instant, and the tool at its end.

A line is drawn in its colour up to the instant and not at all after it. The colour of each point
encodes its place in the path, and an instant is a scale of colours that ends there. An instant thus
needs no points of its own.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from cncsub.drawing.colours import TEXT
from cncsub.drawing.points import Drawn, Numbers, Points
from cncsub.plot.figure import GRID, clock

TOOL = "#f5c400"
_INSTANTS = 120  # at most, on the slider
_NONE = "rgba(0,0,0,0)"


class Instants:
    """Instants of a path at equal times."""

    def __init__(self, points: Points) -> None:
        self.timed = float(points.time[-1]) > 0
        times = self.times_of(points)
        at = np.linspace(0, float(times[-1]), min(_INSTANTS, max(2, len(times))))
        self.at = at if self.timed else np.round(at)

    def times_of(self, points: Points) -> Numbers:
        """Return when each point is reached; its number where the path takes no time."""
        return points.time if self.timed else np.arange(len(points), dtype=float)

    def marked(self, drawn: Drawn) -> Drawn:
        """Return the path with a point on the line where the tool is at each instant."""
        points, times = drawn.points, self.times_of(drawn.points)
        behind = np.searchsorted(times, self.at, side="left")
        inside = (behind > 0) & (behind < len(times))
        behind, at = behind[inside], self.at[inside]
        cut = (points.key[behind] >= 0) & (times[behind] > at)
        behind, at = behind[cut], at[cut]
        part = (at - times[behind - 1]) / (times[behind] - times[behind - 1])
        middle = [
            column[behind - 1] + (column[behind] - column[behind - 1]) * part
            for column in (*points.columns, points.time)
        ]
        x, y, z, time = (
            np.insert(column, behind, between)
            for column, between in zip((*points.columns, points.time), middle)
        )
        move, key = (np.insert(of, behind, of[behind]) for of in (points.move, points.key))
        return replace(drawn, points=Points(x, y, z, move, key, time))

    def reached(self, points: Points) -> Numbers:
        """Return the last point that is reached at each instant."""
        found = np.searchsorted(self.times_of(points), self.at, side="right") - 1
        return np.maximum(found, 0)


class Line:
    """A line of some colours. Each colour has an equal share of the numbers from 0 to 1, and the
    points of the path go through that share in order.
    """

    def __init__(self, points: int, colours: Sequence[str]) -> None:
        self._points = points
        self._colours = colours

    def numbers(self, places: Numbers, codes: Numbers | int) -> Numbers:
        """Return the numbers of points at these places of the path, in the colours of
        these codes.
        """
        return (codes + (places + 0.5) / self._points) / len(self._colours)

    def scale(self, reached: int | None = None) -> list[tuple[float, str]]:
        """Return the scale of colours up to the point `reached`, or all of it without one."""
        whole = reached is None or reached >= self._points - 1
        part = 1.0 if reached is None else (reached + 1) / self._points
        stops: list[tuple[float, str]] = []
        count = len(self._colours)
        for place, colour in enumerate(self._colours):
            begin, end = place / count, (place + 1) / count
            if whole:
                stops += [(begin, colour), (end, colour)]
            else:
                middle = round((place + part) / count, 9)
                stops += [(begin, colour), (middle, colour), (middle, _NONE), (end, _NONE)]
        return stops

    def as_whole(self) -> dict[str, Any]:
        """Return what a line of plotly needs besides its numbers."""
        return {"cmin": 0, "cmax": 1, "colorscale": self.scale()}


def marker(drawn: Drawn) -> dict[str, Any]:
    x, y, z = (float(column[-1]) for column in drawn.points.columns)
    return {
        "type": "scatter3d",
        "mode": "markers",
        "x": [x],
        "y": [y],
        "z": [z],
        "marker": {"size": 5, "color": TOOL, "line": {"color": TEXT, "width": 2}},
        "name": "tool",
        "showlegend": False,
        "hovertemplate": "the tool<br>X%{x:.3f} Y%{y:.3f} Z%{z:.3f}<extra></extra>",
    }


def player(
    instants: Instants, drawn: Drawn, lines: Sequence[tuple[int, Line, Numbers]], tool: int
) -> tuple[list[dict[str, Any]], dict[str, Any]]:
    """Return the pictures at the instants, and the slider and keys that show them. `lines`: the
    place of a line in the figure, and the points it has reached at each instant; `tool`: the place
    of the marker.
    """
    at = drawn.xyz[instants.reached(drawn.points)].tolist()
    frames = []
    for number, (x, y, z) in enumerate(at):
        data: list[dict[str, Any]] = [
            {"type": "scatter3d", "line": {"colorscale": line.scale(int(reached[number]))}}
            for _, line, reached in lines
        ]
        data.append({"type": "scatter3d", "x": [x], "y": [y], "z": [z]})
        places = [*(place for place, _, _ in lines), tool]
        frames.append({"name": str(number), "traces": places, "data": data})
    return frames, controls(instants)


def controls(instants: Instants, below: int = 0) -> dict[str, Any]:
    """Return the slider and the keys that show the pictures at the instants, so many pixels below
    the picture.
    """
    steps = []
    for number in range(len(instants.at)):
        go = {"mode": "immediate", "frame": {"duration": 0, "redraw": True}}
        when = float(instants.at[number])
        label = clock(when) if instants.timed else f"point {when:.0f}"
        steps.append({"label": label, "method": "animate", "args": [[str(number)], go]})
    return {"sliders": [_slider(steps, below)], "updatemenus": [_keys(below)]}


def _slider(steps: list[dict[str, Any]], below: int) -> dict[str, Any]:
    return {
        "active": len(steps) - 1,
        "steps": steps,
        "x": 0,
        "len": 1,
        "y": 0,
        "yanchor": "top",
        "pad": {"t": 10 + below, "b": 0},
        "currentvalue": {
            "prefix": "at ",
            "xanchor": "right",
            "offset": 14,
            "font": {"size": 13, "color": TEXT},
        },
        "tickcolor": "rgba(0,0,0,0)",
        "ticklen": 0,
        "minorticklen": 0,
        "font": {"size": 1, "color": "rgba(0,0,0,0)"},
        "bordercolor": GRID,
        "bgcolor": GRID,
        "transition": {"duration": 0},
    }


def _keys(below: int) -> dict[str, Any]:
    go = {"frame": {"duration": 80, "redraw": True}, "fromcurrent": True, "mode": "immediate"}
    halt = {"frame": {"duration": 0, "redraw": False}, "mode": "immediate"}
    return {
        "type": "buttons",
        "direction": "left",
        "x": 0,
        "y": 0,
        "xanchor": "left",
        "yanchor": "top",
        "pad": {"t": 2 + below},
        "showactive": False,
        "bgcolor": "rgba(127,137,145,0.15)",
        "bordercolor": GRID,
        "font": {"size": 13},
        "buttons": [
            {"label": "&#9654;", "method": "animate", "args": [None, go]},
            {"label": "&#10074;&#10074;", "method": "animate", "args": [[None], halt]},
        ],
    }
