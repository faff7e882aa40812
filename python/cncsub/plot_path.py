"""`run.plot()`: the path of the tool in three dimensions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from cncsub import _core
from cncsub.plot_player import marker, player
from cncsub.plot_points import Drawn, drawn_path, line_runs
from cncsub.plotting import (
    COLOURS,
    OTHERS,
    SOLID_GRID,
    TEXT,
    Places,
    clock,
    count,
    empty,
    figure,
    shown_text,
)
from cncsub.polyline import rows_of

if TYPE_CHECKING:
    from cncsub.run import Recorded

    Numbers = np.ndarray[Any, np.dtype[Any]]

MOST = 60_000  # points of a picture
_DENSE = 4_000  # points from which lines are thin
_BANDS = 24  # of colours that go over into each other
_MOST_NAMES = 11  # colours beside that of the rest
_SCENE = 1.9  # the diagonal of what is drawn, in the units of a camera
_FAMILIES = ("rapid", "feed", "cycle", "compensation")
_WORDS = {
    "rapid": "rapid",
    "feed": "feed",
    "cycle": "canned cycle",
    "compensation": "radius compensation",
}
_FAMILY_COLOURS = {
    "rapid": "#d9534f",
    "feed": "#3d8fd6",
    "cycle": "#2fa36b",
    "compensation": "#b565d8",
}
_BY_NAME = ("kind", "program", "call", "tool", "depth")
_BY_VALUE = {"feed": "F", "time": "s", "z": "mm"}
COLOURED_BY = (*_BY_NAME, *_BY_VALUE)


@dataclass(frozen=True)
class Colouring:
    """The colour of each move: a name of few, or a value on a scale."""

    by: str
    codes: Numbers  # by move, int32: a name, or a band of values
    names: list[str]  # of the codes, where they are names
    colours: list[str]
    values: Numbers | None = None  # by move

    @property
    def scaled(self) -> bool:
        return self.values is not None


def path_figure(
    run: Recorded,
    *,
    color: str = "kind",
    coordinates: str = "work",
    moves: slice | range | None = None,
    most: int = MOST,
    play: bool = True,
    title: str | None = None,
) -> Any:
    """See `Run.plot`."""
    core = run._trace
    if color not in COLOURED_BY:
        raise ValueError(f"color is one of {', '.join(COLOURED_BY)}, not {color!r}")
    if coordinates not in ("work", "machine"):
        raise ValueError(f"coordinates is work or machine, not {coordinates!r}")
    if isinstance(most, bool) or most < 100:
        raise ValueError(f"most is a number of points from 100 on, not {most!r}")
    first, last = rows_of(moves, core.moves)
    head = title if title is not None else _title(run, first, last)
    if first == last:
        why = "It moved nothing." if len(run.steps) else 'No moves: trace="moves" keeps them.'
        return empty(why, head)
    return _Picture(run, color, coordinates, first, last, most).figure(head, play)


def _title(run: Recorded, first: int, last: int) -> str:
    name = run.steps[0].program if len(run.steps) else "path"
    part = "" if (first, last) == (0, len(run.moves)) else f", moves {first:,} to {last - 1:,}"
    return f"{name}: {count(last - first, 'move')}{part}"


class _Picture:
    def __init__(
        self, run: Recorded, color: str, coordinates: str, first: int, last: int, most: int
    ) -> None:
        self.run = run
        self.core: _core.Trace = run._trace
        self.coordinates = coordinates
        self.first, self.last, self.most = first, last, most
        self.number = run.moves[0].move  # of the first row
        self.families = self._families()
        self.times = self._column("time").cumsum()
        self.colouring = self._colouring(color)
        self.places = Places(self.core)

    def _column(self, name: str) -> Numbers:
        column: Numbers = self.core.move_columns([name])[name]
        return column[self.first : self.last]

    def _families(self) -> Numbers:
        """By move: rapid, feed, cycle, compensation."""
        kinds = self._column("kind")
        families = np.ones(len(kinds), dtype=np.int32)
        families[self._column("compensated") != 0] = 3
        families[self._column("cycle") != 0] = 2
        families[kinds == self.core.move_kinds.index("rapid")] = 0
        return families

    # ---- colours ----

    def _colouring(self, by: str) -> Colouring:
        if by == "kind":
            words = [_WORDS[name] for name in _FAMILIES]
            return Colouring(by, self.families, words, [_FAMILY_COLOURS[f] for f in _FAMILIES])
        if by in _BY_VALUE:
            values = self._values(by)
            low, high = float(values.min()), float(values.max())
            wide = (high - low) or 1.0
            bands = np.minimum((values - low) / wide * _BANDS, _BANDS - 1).astype(np.int32)
            return Colouring(by, bands, [], [], values)
        return self._named(by)

    def _values(self, by: str) -> Numbers:
        if by == "time":
            return self.times
        if by == "feed":
            return self._column("feed")
        return self._column("z" if self.coordinates == "work" else "mz")

    def _named(self, by: str) -> Colouring:
        found, codes = np.unique(self._codes(by), return_inverse=True)
        names = [self._name(by, int(code)) for code in found]
        if len(names) <= _MOST_NAMES + 1:
            return Colouring(by, codes.astype(np.int32), names, _cycle(len(names)))
        # The names with the longest way have colours, the rest shares one.
        way = np.bincount(codes, weights=self._column("length"), minlength=len(names))
        kept = np.sort(np.argsort(-way, kind="stable")[:_MOST_NAMES])
        place = np.full(len(names), _MOST_NAMES, dtype=np.int32)
        place[kept] = np.arange(_MOST_NAMES)
        rest = f"{len(names) - _MOST_NAMES:,} others"
        return Colouring(
            by, place[codes], [*(names[k] for k in kept), rest], [*_cycle(_MOST_NAMES), OTHERS]
        )

    def _codes(self, by: str) -> Numbers:
        if by == "tool":
            return self._column("tool")
        column = self.core.step_column({"call": "frame"}.get(by, by))
        if not len(column):
            return np.zeros(self.last - self.first, dtype=np.int32)
        steps = self._column("step") - int(self.run.steps[0].step)
        found: Numbers = column[np.clip(steps, 0, len(column) - 1)]
        return found

    def _name(self, by: str, code: int) -> str:
        if by == "program":
            return self.core.program_names[code]
        if by == "tool":
            return f"T{code}" if code else "no tool"
        if by == "depth":
            return f"{count(code, 'call')} deep" if code else "main program"
        if code < 0:
            return "main program"
        calls = self.run.calls
        if code < len(calls) and calls[code].call == code:
            return f"{calls[code].kind} {calls[code].program}, call {code}"
        return f"call {code}"

    # ---- the path ----

    def _key_of_moves(self) -> Numbers:
        dwell = self._column("kind") == self.core.move_kinds.index("dwell")
        keys = self.families * np.int32(_BANDS + _MOST_NAMES) + self.colouring.codes
        # What stands still draws no line; its point goes with the line before.
        if dwell.any():
            rows = np.where(dwell, 0, np.arange(len(keys)))
            keys = keys[np.maximum.accumulate(rows)]
        return keys.astype(np.int32)

    # ---- the figure ----

    def figure(self, title: str, play: bool) -> Any:
        keys = self._key_of_moves()
        compensated = self.families == 3
        both = self.coordinates == "work" and bool(compensated.any())
        share = self.most * 2 // 3 if both else self.most
        rows = (self.first, self.last)
        drawn = drawn_path(self.core, self.coordinates, rows, keys, share)
        hover = self._hover(drawn)
        data = list(self._traces(drawn, hover))
        told = [self._told(drawn, both), *drawn.told]
        if both:
            of_tool = np.where(compensated, 0, -1).astype(np.int32)
            tool = drawn_path(self.core, "tool", rows, of_tool, self.most // 3)
            data.append(self._tool_trace(tool))
            told += [f"The tool: {text}" for text in tool.told]
        frames: list[dict[str, Any]] = []
        more: dict[str, Any] = {}
        if play:
            data.append(marker(drawn))
            frames, more = player(drawn, self._ended(drawn), len(data) - 1)
        layout = {"scene": self._scene(drawn), **more}
        return figure(
            data, layout, title=title, told=told, frames=frames, below=72 if play else 0, height=500
        )

    def _told(self, drawn: Drawn, both: bool) -> str:
        if self.coordinates == "machine":
            words = "Machine coordinates, mm: the tool with all its offsets."
        else:
            words = "Work coordinates, mm: the programmed path."
            if both:
                words += " Dotted: the tool with its radius offset."
            if drawn.breaks:
                words += (
                    " Other coordinates came into force in between, and parts of several may lie"
                    ' over each other; coordinates="machine" draws them apart.'
                )
        if self.core.diameters & 1:
            words += " X is drawn as a radius."
        if (self.families == 0).any():
            words += (
                " Rapid moves are drawn straight; a control may lead each axis at its own rate."
            )
        return words

    def _hover(self, drawn: Drawn) -> list[str]:
        rows = drawn.move - self.number
        columns = self.core.move_columns(["step", "feed", "tool", "kind"])
        picked = [columns[name][rows].tolist() for name in ("step", "kind", "feed", "tool")]
        ends = self.times[rows - self.first].tolist()
        kinds, of = self.core.move_kinds, self.places.of
        texts: list[str] = []
        known: dict[int, str] = {}
        for move, end, step, kind, feed, tool in zip(drawn.move.tolist(), ends, *picked):
            text = known.get(move)
            if text is None:
                word = kinds[kind] + ("" if kinds[kind] == "rapid" else f" F{feed:g}")
                text = known[move] = (
                    f"{of(step)}<br>{word}, T{tool}, move {move:,}, step {step:,}, {clock(end)}"
                )
            texts.append(text)
        return texts

    def _traces(self, drawn: Drawn, hover: list[str]) -> Iterator[dict[str, Any]]:
        wide = _BANDS + _MOST_NAMES
        family = np.where(drawn.keys < 0, -1, drawn.keys // wide)
        code = drawn.keys % wide
        rapid = family == 0
        if self.colouring.scaled:
            if (family > 0).any():
                yield self._trace(drawn, hover, family > 0, scaled=True)
            if rapid.any():
                yield self._trace(drawn, hover, rapid, name="rapid", colour=OTHERS, dash=True)
            return
        of_kind = self.colouring.by == "kind"
        for place, (name, colour) in enumerate(zip(self.colouring.names, self.colouring.colours)):
            mine = (code == place) & (family >= 0)
            cutting, quick = mine & ~rapid, mine & rapid
            group = f"{place}"
            if cutting.any():
                yield self._trace(drawn, hover, cutting, name=name, colour=colour, group=group)
            if quick.any():
                yield self._trace(
                    drawn,
                    hover,
                    quick,
                    name=name if of_kind or not cutting.any() else f"{name}, rapid",
                    colour=colour,
                    group=group,
                    dash=True,
                    listed=of_kind or not cutting.any(),
                )

    def _trace(
        self,
        drawn: Drawn,
        hover: list[str],
        mask: Numbers,
        *,
        name: str = "",
        colour: str = "",
        group: str | None = None,
        dash: bool = False,
        listed: bool = True,
        scaled: bool = False,
    ) -> dict[str, Any]:
        places, starts = line_runs(mask, drawn.keys)
        gaps = places < 0
        points = drawn.points[places]
        points[gaps] = np.nan
        text = [None if place < 0 else hover[place] for place in places.tolist()]
        many = len(drawn.points) > _DENSE
        line: dict[str, Any] = {"width": (1 if many else 2) if dash else (2 if many else 4)}
        if scaled:
            line |= self._scale(drawn, places, starts)
        else:
            line["color"] = colour
        if dash:
            line["dash"] = "dash"
        return {
            "type": "scatter3d",
            "mode": "lines",
            "x": points[:, 0],
            "y": points[:, 1],
            "z": points[:, 2],
            "text": text,
            "hovertemplate": "%{text}<br>X%{x:.3f} Y%{y:.3f} Z%{z:.3f}<extra></extra>",
            "name": shown_text(name),
            "legendgroup": group,
            "showlegend": listed and not scaled,
            "line": line,
            "connectgaps": False,
        }

    def _scale(self, drawn: Drawn, places: Numbers, starts: Numbers) -> dict[str, Any]:
        """A colour for each point: that of the line that leads there, at its start that which it
        begins with.
        """
        values = self.colouring.values
        assert values is not None
        rows = drawn.move - (self.number + self.first)
        shown = values[rows]
        if self.colouring.by == "time":
            took = np.diff(values, prepend=0.0)
            shown = shown - took[rows] * (1 - drawn.part)
        elif self.colouring.by == "z":
            shown = drawn.points[:, 2]
        colours = shown[places].astype(float)
        if self.colouring.by == "feed":  # the start of a line has the feed of the line
            begun = np.flatnonzero(starts)
            colours[begun] = shown[places[begun + 1]]
        words = {"feed": "feed, mm/min or mm/rev", "time": "time, s", "z": "Z, mm"}
        low, high = float(np.nanmin(colours)), float(np.nanmax(colours))
        ticks = {} if high > low else {"tickvals": [low], "ticktext": [f"{low:g}"]}
        return {
            "color": colours,
            "colorscale": _SCALE,
            "cmin": low if high > low else low - 1,
            "cmax": high if high > low else high + 1,
            "colorbar": {
                "title": {"text": words[self.colouring.by], "side": "right"},
                "thickness": 12,
                "len": 0.7,
                "outlinewidth": 0,
                **ticks,
            },
            "showscale": True,
        }

    def _tool_trace(self, tool: Drawn) -> dict[str, Any]:
        places, _ = line_runs(tool.keys == 0, tool.keys)
        points = tool.points[places]
        points[places < 0] = np.nan
        return {
            "type": "scatter3d",
            "mode": "lines",
            "x": points[:, 0],
            "y": points[:, 1],
            "z": points[:, 2],
            "name": "tool, radius offset",
            "line": {"width": 3, "color": "#c9a227", "dash": "dot"},
            "hovertemplate": "the tool<br>X%{x:.3f} Y%{y:.3f} Z%{z:.3f}<extra></extra>",
        }

    def _scene(self, drawn: Drawn) -> dict[str, Any]:
        flat = float(np.ptp(drawn.points[:, 1])) < 1e-9 < float(np.ptp(drawn.points[:, 0]))
        turning = flat and bool(self.core.diameters & 1)
        flat_z = not turning and float(np.ptp(drawn.points[:, 2])) < 1e-9
        camera: dict[str, Any] = {"projection": {"type": "orthographic"}}
        if turning:  # as on the drawing: Z to the right, X up
            camera |= {"eye": {"x": 0, "y": 2, "z": 0}, "up": {"x": 1, "y": 0, "z": 0}}
        elif flat_z:  # from above
            camera |= {"eye": {"x": 0, "y": 0, "z": 2}, "up": {"x": 0, "y": 1, "z": 0}}
        else:
            camera |= {"eye": {"x": -0.9, "y": -1.5, "z": 1.0}}
        name = "machine " if self.coordinates == "machine" else ""
        axes = {
            f"{letter}axis": {
                "title": {"text": f"{name}{letter.upper()}", "font": {"size": 12}},
                "color": TEXT,
                "gridcolor": SOLID_GRID,
                "zerolinecolor": SOLID_GRID,
                "showbackground": False,
                "showspikes": False,
                "tickfont": {"size": 11},
            }
            for letter in "xyz"
        }
        if turning or flat_z:  # one looks along it
            axes["yaxis" if turning else "zaxis"]["visible"] = False
        # As long as it is, whatever its shape: one millimetre is as long on every axis.
        sides = np.maximum(np.ptp(drawn.points, axis=0), 1e-3)
        sides = np.maximum(sides, sides.max() / 50) / float(np.linalg.norm(sides))
        ratio = {letter: float(side) * _SCENE for letter, side in zip("xyz", sides)}
        return {
            **axes,
            "aspectmode": "manual",
            "aspectratio": ratio,
            "camera": camera,
            "dragmode": "orbit",
        }

    def _ended(self, drawn: Drawn) -> Numbers:
        """When each drawn point is reached, s."""
        rows = drawn.move - (self.number + self.first)
        took = np.diff(self.times, prepend=0.0)
        ended: Numbers = self.times[rows] - took[rows] * (1 - drawn.part)
        return ended


# From blue over green to orange: as dark at one end as at the other, and told apart by most eyes.
_SCALE = [[0.0, "#3b5bdb"], [0.33, "#1c9c8f"], [0.66, "#c9a227"], [1.0, "#e8590c"]]


def _cycle(colours: int) -> list[str]:
    return [COLOURS[place % len(COLOURS)] for place in range(colours)]
