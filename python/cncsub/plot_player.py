"""The slider of `run.plot()`, which leads the tool along the path."""

from __future__ import annotations

from typing import Any

import numpy as np

from cncsub.plot_points import Drawn, Numbers
from cncsub.plotting import GRID, TEXT, clock

_INSTANTS = 160  # of the slider


def marker(drawn: Drawn) -> dict[str, Any]:
    x, y, z = drawn.points[0].tolist()
    return {
        "type": "scatter3d",
        "mode": "markers",
        "x": [x],
        "y": [y],
        "z": [z],
        "marker": {"size": 6, "color": "#f5c400", "line": {"color": TEXT, "width": 2}},
        "name": "tool",
        "showlegend": False,
        "hovertemplate": "the tool<br>X%{x:.3f} Y%{y:.3f} Z%{z:.3f}<extra></extra>",
    }


def player(drawn: Drawn, ended: Numbers, trace: int) -> tuple[list[dict[str, Any]], dict[str, Any]]:
    """Instants at equal times, the tool on the line that is drawn, and the keys to go along.
    `ended`: when each point is reached, s; `trace`: the place of the marker in the figure.
    """
    total = float(ended[-1])
    if total <= 0:
        ended = np.arange(len(ended), dtype=float)
        total = float(ended[-1])
    instants = min(_INSTANTS, max(2, len(ended)))
    frames, steps = [], []
    for number, at in enumerate(np.linspace(0, total, instants)):
        behind = min(int(np.searchsorted(ended, at, side="left")), len(ended) - 1)
        point = _between(drawn, ended, behind, float(at))
        label = clock(float(at))
        frames.append(
            {
                "name": str(number),
                "traces": [trace],
                "data": [
                    {
                        "type": "scatter3d",
                        "x": [point[0]],
                        "y": [point[1]],
                        "z": [point[2]],
                    }
                ],
            }
        )
        go = {"mode": "immediate", "frame": {"duration": 0, "redraw": True}}
        steps.append({"label": label, "method": "animate", "args": [[str(number)], go]})
    return frames, {"sliders": [_slider(steps)], "updatemenus": [_keys()]}


def _between(drawn: Drawn, ended: Numbers, behind: int, at: float) -> list[float]:
    """Where the tool is at a time, on the line to the point `behind`."""
    to = drawn.points[behind]
    if behind == 0 or drawn.keys[behind] < 0:
        return [float(value) for value in to]
    took = float(ended[behind] - ended[behind - 1])
    part = 1.0 if took <= 0 else (at - float(ended[behind - 1])) / took
    way = drawn.points[behind - 1] + (to - drawn.points[behind - 1]) * min(1.0, max(0.0, part))
    return [float(value) for value in way]


def _slider(steps: list[dict[str, Any]]) -> dict[str, Any]:
    return {
        "active": 0,
        "steps": steps,
        "x": 0,
        "len": 1,
        "y": 0,
        "yanchor": "top",
        "pad": {"t": 10, "b": 0},
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


def _keys() -> dict[str, Any]:
    go = {"frame": {"duration": 80, "redraw": True}, "fromcurrent": True, "mode": "immediate"}
    halt = {"frame": {"duration": 0, "redraw": False}, "mode": "immediate"}
    return {
        "type": "buttons",
        "direction": "left",
        "x": 0,
        "y": 0,
        "xanchor": "left",
        "yanchor": "top",
        "pad": {"t": 2},
        "showactive": False,
        "bgcolor": "rgba(127,137,145,0.15)",
        "bordercolor": GRID,
        "font": {"size": 13},
        "buttons": [
            {"label": "&#9654;", "method": "animate", "args": [None, go]},
            {"label": "&#10074;&#10074;", "method": "animate", "args": [[None], halt]},
        ],
    }
