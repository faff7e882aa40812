"""`run.watch.plot()`: the values of variables, over steps or time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from cncsub import _core
from cncsub.option_errors import wrong_value
from cncsub.plot.figure import COLOURS, Places, axis, count, empty, figure, seconds

if TYPE_CHECKING:
    from cncsub.tables.of_runs import Watch

OVER = ("steps", "time")
_WIDE = 2_000  # columns of a picture: of each the first, the lowest, the highest and the last
_MOST = 12  # variables
_MOST_HOVERS = 4 * _WIDE

Numbers = np.ndarray[Any, np.dtype[Any]]


def watch_figure(watch: Watch, *, over: str = "steps", title: str | None = None) -> Any:
    """See `Watch.plot`."""
    if over not in OVER:
        raise wrong_value("over", f"over must be steps or time, not {over!r}")
    numbers = list(watch.beginning)
    changes = count(len(watch), "change")
    names = _names(watch.core, numbers)
    head = title if title is not None else f"{names or 'nothing watched'}: {changes}"
    if not numbers:
        hundred = _core.variable_name(watch.core.control, 100)
        return empty(f"Nothing is watched: run(watch=[100]) watches {hundred}.", head)
    return _Timeline(watch, over, numbers).figure(head)


class _Timeline:
    def __init__(self, watch: Watch, over: str, numbers: list[int]) -> None:
        self.watch = watch
        self.core = watch.core
        self.told: list[str] = []
        changed = set(np.unique(watch.variable).tolist())
        still = [number for number in numbers if number not in changed]
        moving = [number for number in numbers if number in changed] or numbers
        self.shown = moving[:_MOST]
        if still and moving is not numbers:
            self.told.append(f"Never changed: {_names(self.core, still)}.")
        if len(moving) > _MOST:
            self.told.append(
                f"Changed, and not drawn: {_names(self.core, moving[_MOST:])};"
                " run.watch(100).plot() draws one."
            )
        self.vacant: list[int] = []  # the drawn variables that were vacant at some time
        self.steps = np.asarray(watch.step)
        self.over = over
        self.at = self._places()
        self.end = self._end()

    def _places(self) -> Numbers:
        """Return where each change lies on the axis; a change from outside lies where the one
        before it does.
        """
        steps = np.maximum.accumulate(self.steps) if len(self.steps) else self.steps
        steps = np.maximum(steps, 0)
        if self.over == "steps":
            return steps.astype(float)
        ends = np.append(0.0, seconds(self.core)) if self.core.moves else np.zeros(1)
        of = self.core.move_columns(["step"])["step"] if self.core.moves else np.zeros(0)
        at: Numbers = ends[np.searchsorted(of, steps, side="right")]
        return at

    def _end(self) -> float:
        if self.over == "time":
            return float(self.core.time)
        last = float(self.at[-1]) if len(self.at) else 0.0
        if not self.core.steps:
            return last + 1
        return max(last, float(self.core.steps + self.core.step_column("step")[0]))

    def figure(self, title: str) -> Any:
        layout: dict[str, Any] = {"showlegend": False}
        data = []
        count_of = len(self.shown)
        for place, number in enumerate(self.shown):
            data.append(self._trace(number, place))
            high = 1 - place / count_of
            layout[_named("yaxis", place)] = axis(
                self._name(number), domain=[high - 0.88 / count_of, high], zeroline=False
            )
        if self.vacant:
            verb = "is" if len(self.vacant) == 1 else "are"
            self.told.append(
                f"{_names(self.core, self.vacant)} {verb} vacant where there is no line."
            )
        words = "time, s" if self.over == "time" else "step"
        bottom = "" if count_of == 1 else str(count_of)
        layout["xaxis"] = axis(words, anchor=f"y{bottom}", range=[0, self.end or 1], zeroline=False)
        height = 260 if count_of == 1 else 130 * count_of
        return figure(data, layout, title=title, told=self.told, height=height, below=44)

    def _trace(self, number: int, place: int) -> dict[str, Any]:
        rows = np.flatnonzero(np.asarray(self.watch.variable) == number)
        values = np.asarray(self.watch.value)[rows]
        kept = self._few(self.at[rows], values)
        if len(kept) < len(rows):
            self.told.append(
                f"{self._name(number)}: {count(len(rows), 'change')}; where many fall into one"
                " column of the picture, its first, lowest, highest and last are drawn."
            )
        rows, values = rows[kept], values[kept]
        before = self.watch.beginning[number]
        x = [0.0, *self.at[rows].tolist(), self.end]
        y = [before, *(None if np.isnan(v) else v for v in values.tolist())]
        y.append(y[-1])
        hover = ["before the run", *self._hovers(rows), ""]
        hover[-1] = "at the stop"
        vacant = [row for row, value in enumerate(y) if value is None]
        if vacant:
            self.vacant.append(number)
        colour = COLOURS[place % len(COLOURS)]
        return {
            "type": "scatter",
            "mode": "lines+markers" if len(rows) <= 300 else "lines",
            "x": x,
            "y": y,
            "yaxis": f"y{place + 1 if place else ''}",
            "line": {"shape": "hv", "width": 2, "color": colour},
            "marker": {"size": 5, "color": colour},
            "connectgaps": False,
            "name": self._name(number),
            "text": hover,
            "hovertemplate": f"{self._name(number)} = %{{y}}<br>%{{text}}<extra></extra>",
        }

    def _name(self, number: int) -> str:
        return _core.variable_name(self.core.control, number)

    def _few(self, at: Numbers, values: Numbers) -> Numbers:
        """Return the changes to draw."""
        if len(at) <= _MOST_HOVERS:
            return np.arange(len(at))
        columns = np.floor(at / (self.end or 1) * _WIDE).astype(np.int64)
        first = np.flatnonzero(np.diff(columns, prepend=-1))
        last = np.append(first[1:], len(columns)) - 1
        kept = [first, last]
        vacant = np.isnan(values)
        for bad, extreme in ((np.inf, np.minimum), (-np.inf, np.maximum)):
            known = np.where(vacant, bad, values)
            best = np.repeat(extreme.reduceat(known, first), np.diff(np.append(first, len(at))))
            hits = np.flatnonzero(known == best)
            kept.append(hits[np.unique(columns[hits], return_index=True)[1]])
        kept.append(np.flatnonzero(np.diff(vacant.astype(np.int8)) != 0)[:_WIDE] + 1)
        return np.unique(np.concatenate(kept))

    def _hovers(self, rows: Numbers) -> list[str]:
        places = Places(self.core)
        told = []
        for step in self.steps[rows].tolist():
            told.append("set from outside" if step < 0 else f"{places.of(step)}<br>step {step:,}")
        return told


def _names(core: _core.Trace, numbers: list[int]) -> str:
    told = ", ".join(_core.variable_name(core.control, number) for number in numbers[:_MOST])
    return told + (f" and {len(numbers) - _MOST:,} more" if len(numbers) > _MOST else "")


def _named(name: str, place: int) -> str:
    return name if place == 0 else f"{name}{place + 1}"
