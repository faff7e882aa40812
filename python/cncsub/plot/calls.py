"""`run.calls.plot()`: the calls as an icicle over time."""

from __future__ import annotations

from typing import Any

import numpy as np

from cncsub import _core
from cncsub.option_errors import wrong_value
from cncsub.plot.figure import (
    COLOURS,
    OTHERS,
    Places,
    axis,
    clock,
    count,
    empty,
    figure,
    shown_text,
)
from cncsub.tables.of_runs import Calls

_WIDE = 1_200  # bars narrower than one part in so many are drawn together
_DEEPEST = 40  # rows
_MOST_NAMES = 11
OVER = ("time", "steps")

Numbers = np.ndarray[Any, np.dtype[Any]]


def calls_figure(calls: Calls, *, over: str = "time", title: str | None = None) -> Any:
    """See `Calls.plot`."""
    if over not in OVER:
        raise wrong_value("over", f"over must be time or steps, not {over!r}")
    head = title if title is not None else count(len(calls), "call")
    if not len(calls):
        return empty("The program called nothing.", head)
    return _Icicle(calls, over).figure(head)


class _Icicle:
    def __init__(self, calls: Calls, over: str) -> None:
        self.calls = calls
        self.core: _core.Trace = calls.core
        self.told: list[str] = []
        self.begun, self.ended = self._span(over)
        self.depth = _depths(np.asarray(calls.call), np.asarray(calls.parent))
        self.program = np.asarray(calls.program).view(np.ndarray)

    def _span(self, over: str) -> tuple[Numbers, Numbers]:
        """Return where each call begins and ends on the axis."""
        first = self.calls.first_step
        last = self.calls.last_step
        end = max(int(first.max()), int(last.max())) + 1
        if self.core.steps:
            end = self.core.steps + int(self.core.step_column("step")[0])
        last = np.where(last < 0, end - 1, last)
        open_calls = int((self.calls.last_step < 0).sum())
        if open_calls:
            self.told.append(f"{count(open_calls, 'call')} had not ended.")
        self.over = "steps"
        times = _times(self.core) if over == "time" else None
        if times is None:
            if over == "time":
                self.told.append("Over steps: no move took time.")
            self.whole = float(end)
            return first.astype(float), last + 1.0
        steps, ends = times
        self.over, self.whole = "time", float(ends[-1])
        before = np.append(0.0, ends)
        begun = before[np.searchsorted(steps, first, side="left")]
        ended = before[np.searchsorted(steps, last, side="right")]
        still = int((ended <= begun).sum())
        if still:
            self.told.append(
                f'{count(still, "call")} took no time: over="steps" shows what they did.'
            )
        return begun, ended

    def figure(self, title: str) -> Any:
        wide = self.ended - self.begun
        least = self.whole / _WIDE
        shown = (wide > 0) & (self.depth < _DEEPEST)
        if (deeper := int((self.depth >= _DEEPEST).sum())) > 0:
            self.told.append(f"{count(deeper, 'call')} deeper than {_DEEPEST} are not drawn.")
        alone = np.flatnonzero(shown & (wide >= least))
        together = list(self._together(np.flatnonzero(shown & (wide < least)), least))
        if together:
            self.told.append("Grey: calls too short to be drawn one by one.")
        data = [*self._bars(alone), *self._grey(together)]
        rows = int(self.depth[shown].max()) + 1 if shown.any() else 1
        words = "time, s" if self.over == "time" else "steps"
        layout = {
            "barmode": "overlay",
            "bargap": 0.08,
            "xaxis": axis(words, range=[0, self.whole], zeroline=False),
            "yaxis": axis(
                "depth",
                autorange="reversed",
                tickmode="linear" if rows <= 12 else "auto",
                dtick=1,
                showgrid=False,
                zeroline=False,
            ),
        }
        return figure(
            data, layout, title=title, told=self.told, height=60 + 34 * min(rows, 14), below=44
        )

    def _bars(self, alone: Numbers) -> list[dict[str, Any]]:
        names = self.core.program_names
        way = np.bincount(
            self.program[alone], weights=(self.ended - self.begun)[alone], minlength=len(names)
        )
        order = [int(p) for p in np.argsort(-way, kind="stable") if way[p] > 0]
        groups = [(names[p], COLOURS[i], [p]) for i, p in enumerate(order[:_MOST_NAMES])]
        if rest := order[_MOST_NAMES:]:
            groups.append((f"{len(rest):,} other programs", OTHERS, rest))
        places = Places(self.core)
        bars = []
        for name, colour, programs in groups:
            rows = alone[np.isin(self.program[alone], programs)]
            hover = [self._hover(int(row), places) for row in rows]
            bars.append(self._bar(rows, shown_text(name), colour, hover))
        return bars

    def _bar(self, rows: Numbers, name: str, colour: str, hover: list[str]) -> dict[str, Any]:
        names = self.core.program_names
        wide = self.ended[rows] - self.begun[rows]
        return {
            "type": "bar",
            "orientation": "h",
            "base": self.begun[rows],
            "x": wide,
            "y": self.depth[rows] + 1,
            "text": [
                shown_text(names[self.program[row]]) if part > self.whole / 40 else ""
                for row, part in zip(rows.tolist(), wide.tolist())
            ],
            "textposition": "inside",
            "insidetextanchor": "start",
            "textangle": 0,
            "constraintext": "inside",
            "textfont": {"color": "#ffffff"},
            "hovertext": hover,
            "hovertemplate": "%{hovertext}<extra></extra>",
            "name": name,
            "marker": {"color": colour, "line": {"color": "rgba(255,255,255,0.5)", "width": 0.5}},
        }

    def _hover(self, row: int, places: Places) -> str:
        call = self.calls[row]
        passes = f", {call.repeats:,} passes" if call.repeats != 1 else ""
        took = float(self.ended[row] - self.begun[row])
        words = clock(took) if self.over == "time" else count(int(took), "step")
        start = f" at N{call.start_n}" if call.start_n is not None else ""
        return (
            f"<b>{call.kind} {shown_text(call.program)}</b>{start}{passes}<br>"
            f"{words} from {self.begun[row]:,.6g}<br>called by {places.of(call.caller_step)}"
        )

    def _together(
        self, rows: Numbers, least: float
    ) -> list[tuple[int, float, float, int, dict[str, int]]]:
        """Return groups of short calls side by side: depth, begin, end, how many, and of which
        programs.
        """
        if not len(rows):
            return []
        bins = np.floor(self.begun[rows] / least).astype(np.int64)
        key = self.depth[rows].astype(np.int64) * (_WIDE * 4) + bins
        found, group = np.unique(key, return_inverse=True)
        begun = np.full(len(found), np.inf)
        ended = np.full(len(found), -np.inf)
        np.minimum.at(begun, group, self.begun[rows])
        np.maximum.at(ended, group, self.ended[rows])
        many = np.bincount(group)
        depth = found // (_WIDE * 4)
        names = self.core.program_names
        pairs, times = np.unique(
            np.column_stack((group, self.program[rows])), axis=0, return_counts=True
        )
        of: list[dict[str, int]] = [{} for _ in found]
        for (place, program), number in zip(pairs.tolist(), times.tolist()):
            of[place][names[program]] = number
        return list(zip(depth.tolist(), begun.tolist(), ended.tolist(), many.tolist(), of))

    def _grey(
        self, together: list[tuple[int, float, float, int, dict[str, int]]]
    ) -> list[dict[str, Any]]:
        if not together:
            return []
        least = self.whole / _WIDE
        hover = []
        for _, _, _, many, of in together:
            most = sorted(of.items(), key=lambda pair: -pair[1])[:5]
            lines = [f"{shown_text(name)}: {number:,}" for name, number in most]
            more = [f"and {len(of) - 5:,} other programs"] if len(of) > 5 else []
            hover.append("<br>".join([f"<b>{count(many, 'short call')}</b>", *lines, *more]))
        return [
            {
                "type": "bar",
                "orientation": "h",
                "base": [begun for _, begun, _, _, _ in together],
                "x": [max(least, ended - begun) for _, begun, ended, _, _ in together],
                "y": [depth + 1 for depth, *_ in together],
                "hovertext": hover,
                "hovertemplate": "%{hovertext}<extra></extra>",
                "name": "short calls",
                "marker": {"color": OTHERS},
            }
        ]


def _times(core: _core.Trace) -> tuple[Numbers, Numbers] | None:
    """Return the steps of the moves and when each ends; `None` where nothing takes time."""
    if not core.moves:
        return None
    columns = core.move_columns(["step", "time"])
    ends = np.cumsum(columns["time"])
    return (columns["step"], ends) if ends[-1] > 0 else None


def _depths(numbers: Numbers, parents: Numbers) -> Numbers:
    """Return how many calls are open around each call. A call stands after its parent, or the
    parent is in an earlier part.
    """
    row_of = {number: row for row, number in enumerate(numbers.tolist())}
    depths: list[int] = []
    for parent in parents.tolist():
        row = row_of.get(parent, -1) if parent >= 0 else -1
        depths.append(depths[row] + 1 if 0 <= row < len(depths) else 0)
    return np.array(depths, dtype=np.int64)
