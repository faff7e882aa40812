"""The path of the tool in three dimensions, and what pictures of two dimensions share with it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from cncsub import _core
from cncsub.drawing.colours import ALARM, TEXT
from cncsub.drawing.path import COMPENSATION, RAPID
from cncsub.drawing.points import Drawn, drawn_path, line_runs
from cncsub.drawing.svg import Picture as Drawing
from cncsub.plot.beside import Beside
from cncsub.plot.colours import (
    BANDS,
    MOST_NAMES,
    SCALE,
    WORDS,
    Moved,
    mixed,
)
from cncsub.plot.figure import (
    OTHERS,
    SOLID_GRID,
    Places,
    clock,
    figure,
    shown_text,
)
from cncsub.plot.player import Instants, Line, marker, player

if TYPE_CHECKING:
    from cncsub.run import Recorded

    Numbers = np.ndarray[Any, np.dtype[Any]]

_DENSE = 4_000  # points from which lines are thin
_LAST = {"work": ("x", "y", "z"), "machine": ("mx", "my", "mz")}
_WIDE, _HIGH = 2.2, 1.7  # the largest size as it is seen, in the units of a camera
CODES = BANDS + MOST_NAMES  # not fewer than the codes of colours


@dataclass(frozen=True)
class Stretches:
    """Some of the lines of a path, as one trace of a figure."""

    places: Numbers  # places of the points in the path; -1 between two lines
    starts: Numbers  # whether a line begins at a point
    name: str
    colours: Sequence[str]
    codes: Numbers | int = 0  # which of the colours each point has
    dash: str | None = None
    width: float = 4
    group: str | None = None
    listed: bool = False
    told: bool = True  # whether the pointer shows a text


class Picture:
    radius_words = " X is drawn as a radius."
    axes_height = 0  # pixels below the picture

    def __init__(
        self, run: Recorded, color: str, coordinates: str, first: int, last: int, most: int
    ) -> None:
        self.run = run
        self.core: _core.Trace = run.recorded
        self.coordinates = coordinates
        self.first, self.last, self.most = first, last, most
        self.number = run.moves[0].move  # the number of the first move
        self.moved = Moved(run, coordinates, first, last)
        self.families = self.moved.families
        self.colouring = self.moved.coloured(color)
        self.places = Places(self.core)
        self.beside = Beside(run)

    # ---- the path ----

    def _key_of_moves(self) -> Numbers:
        keys = self.families * np.int32(CODES) + self.colouring.codes
        # A dwell draws no line; its point goes with the line before it.
        dwell = self.moved.column("kind") == self.core.move_kinds.index("dwell")
        if dwell.any():
            rows = np.where(dwell, 0, np.arange(len(keys)))
            keys = keys[np.maximum.accumulate(rows)]
        return keys.astype(np.int32, copy=False)

    # ---- the figure ----

    def figure(self, title: str, play: bool) -> Any:
        compensated = self.families == COMPENSATION
        both = self.coordinates == "work" and bool(compensated.any())
        share = self.most * 2 // 3 if both else self.most
        rows = (self.first, self.last)
        drawn = drawn_path(self.core, self.coordinates, rows, self._key_of_moves(), share)
        told = [self._told(drawn, both), *left_out(drawn)]
        tool = None
        if both:
            of_tool = np.where(compensated, 0, -1).astype(np.int32)
            tool = drawn_path(self.core, "tool", rows, of_tool, self.most // 3)
            told += [f"The tool: {text}" for text in left_out(tool)]
        instants = Instants(drawn.points) if play else None
        if instants is not None:
            drawn = instants.marked(drawn)
            tool = None if tool is None else instants.marked(tool)
        data, more = self._data(drawn, tool, instants)
        scene = self._scene(drawn)
        layout = more if scene is None else {"scene": scene, **more}
        frames = layout.pop("frames", [])
        if instants is not None:
            at = drawn.points.move[instants.reached(drawn.points)] - self.number
            self.beside.of_frames = self.beside.of_moves[at].tolist()
        return figure(
            data,
            layout,
            title=title,
            told=told,
            frames=frames,
            below=self.axes_height + (72 if play else 0),
            height=500,
            attached={"_beside": self.beside, "_drawing": self._drawing},
        )

    def _drawing(self) -> str:
        """Return the path as a drawing in SVG, which is shown where plotly cannot draw."""
        return Drawing(
            self.run,
            coordinates=self.coordinates,
            inch=bool(getattr(getattr(self.run, "core", None), "inch", False)),
            alarm=self.stopped_by,
            rows=(self.first, self.last),
        ).svg()

    @property
    def stopped_by(self) -> Any:
        """The alarm that stopped the run after the last of these moves, `None` where none did."""
        return getattr(self.run, "alarm", None) if self.last == self.core.moves else None

    def _data(
        self, drawn: Drawn, tool: Drawn | None, instants: Instants | None
    ) -> tuple[list[dict[str, Any]], dict[str, Any]]:
        """Return the traces, and the instants of the slider."""
        hover = self._hover(drawn)
        paths = [(drawn, some) for some in self._stretches(drawn)]
        if tool is not None:
            paths.append((tool, self._of_tool(tool)))
        data: list[dict[str, Any]] = []
        lines = []
        for of, some in paths:
            text = hover if some.told else None
            if instants is None:
                data.append(self._trace(of, some, text, self._plain(of, some)))
                continue
            line = Line(len(of.points), some.colours)
            numbers = {"color": line.numbers(some.places, some.codes), **line.as_whole()}
            lines.append((len(data), line, instants.reached(of.points)))
            data.append({**self._trace(of, some, text, numbers), "showlegend": False})
        if instants is None:
            return data + self.alarm_mark(), {}
        data += [entry(some) for _, some in paths if some.listed]
        if self.colouring.scaled:
            data.append(self._scale_beside(drawn))
        data += self.alarm_mark()
        data.append(marker(drawn))
        frames, more = player(instants, drawn, lines, len(data) - 1)
        return data, {"frames": frames, **more}

    def alarm_mark(self) -> list[dict[str, Any]]:
        """Return the mark where an alarm stopped the run, if one did."""
        alarm = self.stopped_by
        if alarm is None:
            return []
        column = self.core.move_columns(list(_LAST[self.coordinates]))
        x, y, z = (float(column[name][-1]) for name in _LAST[self.coordinates])
        if self.core.diameters & 1:
            x /= 2
        words = shown_text(str(alarm).partition("\n")[0])
        return [
            {
                "type": "scatter3d",
                "mode": "markers",
                "x": [x],
                "y": [y],
                "z": [z],
                "name": f"stopped by {alarm.number or alarm.cause}",
                "showlegend": True,
                "marker": {"size": 8, "color": ALARM, "symbol": "x"},
                "hovertemplate": f"{words}<br>{shown_text(alarm_place(alarm))}<extra></extra>",
            }
        ]

    def _told(self, drawn: Drawn, both: bool) -> str:
        if self.coordinates == "machine":
            words = "Machine coordinates, mm: the tool with all its offsets."
        else:
            words = "Work coordinates, mm: the programmed path."
            if both:
                words += " Dotted: the tool with its radius offset."
            if drawn.breaks:
                words += (
                    " Other coordinates came into force during the run, and parts may overlap;"
                    ' coordinates="machine" separates them.'
                )
        if self.core.diameters & 1:
            words += self.radius_words
        if (self.families == RAPID).any():
            words += (
                " Rapid moves are drawn straight; on the machine each axis may go at its own rate."
            )
        return words

    def _hover(self, drawn: Drawn) -> list[str]:
        moves = drawn.points.move
        columns = self.core.move_columns(["step", "feed", "tool", "kind"])
        names = ("step", "kind", "feed", "tool")
        picked = [columns[name][moves - self.number].tolist() for name in names]
        kinds, of = self.core.move_kinds, self.places.of
        texts: list[str] = []
        known: dict[int, str] = {}
        times = drawn.points.time.tolist()
        for move, time, step, kind, feed, tool in zip(moves.tolist(), times, *picked):
            text = known.get(move)
            if text is None:
                word = kinds[kind] + ("" if kinds[kind] == "rapid" else f" F{feed:g}")
                text = known[move] = f"{of(step)}<br>{word}, T{tool}, move {move:,}, step {step:,}"
            texts.append(f"{text}, {clock(time)}")
        return texts

    # ---- its lines ----

    def _stretches(self, drawn: Drawn) -> Iterator[Stretches]:
        family = np.where(drawn.keys < 0, -1, drawn.keys // CODES)
        code = drawn.keys % CODES
        rapid = family == RAPID
        thin = 1 if len(drawn.points) > _DENSE else 2  # of rapid moves; others are twice as wide
        if self.colouring.scaled:
            if (family > RAPID).any():
                places, starts = line_runs(family > RAPID, drawn.keys)
                bands = [mixed((band + 0.5) / BANDS) for band in range(BANDS)]
                shown = np.minimum(self._shares(drawn, places, starts) * BANDS, BANDS - 1)
                yield Stretches(places, starts, "", bands, shown.astype(int), width=2 * thin)
            if rapid.any():
                runs = line_runs(rapid, drawn.keys)
                yield Stretches(*runs, "rapid", [OTHERS], dash="dash", width=thin)
            return
        of_kind = self.colouring.by == "kind"
        for place, (name, colour) in enumerate(zip(self.colouring.names, self.colouring.colours)):
            mine = (code == place) & (family >= 0)
            cutting, quick = mine & ~rapid, mine & rapid
            alone = of_kind or not cutting.any()
            group = f"{place}"
            if cutting.any():
                runs = line_runs(cutting, drawn.keys)
                yield Stretches(*runs, name, [colour], width=2 * thin, group=group, listed=True)
            if quick.any():
                yield Stretches(
                    *line_runs(quick, drawn.keys),
                    name if alone else f"{name}, rapid",
                    [colour],
                    dash="dash",
                    width=thin,
                    group=group,
                    listed=alone,
                )

    def _of_tool(self, tool: Drawn) -> Stretches:
        runs = line_runs(tool.keys == 0, tool.keys)
        name = "tool, radius offset"
        colours = ["#c9a227"]
        return Stretches(*runs, name, colours, dash="dot", width=3, listed=True, told=False)

    def _trace(
        self, drawn: Drawn, some: Stretches, hover: list[str] | None, line: dict[str, Any]
    ) -> dict[str, Any]:
        points = drawn.xyz[some.places]
        points[some.places < 0] = np.nan
        words = "the tool" if hover is None else "%{text}"
        trace: dict[str, Any] = {
            "type": "scatter3d",
            "mode": "lines",
            "x": points[:, 0],
            "y": points[:, 1],
            "z": points[:, 2],
            "hovertemplate": f"{words}<br>X%{{x:.3f}} Y%{{y:.3f}} Z%{{z:.3f}}<extra></extra>",
            "name": shown_text(some.name),
            "legendgroup": some.group,
            "showlegend": some.listed,
            "line": {"width": some.width, "dash": some.dash, **line},
            "connectgaps": False,
        }
        if hover is not None:
            trace["text"] = [None if at < 0 else hover[at] for at in some.places.tolist()]
            found = self.beside.of_moves[drawn.points.move[some.places] - self.number]
            trace["customdata"] = np.where(some.places < 0, -1, found).tolist()
        return trace

    # ---- what is coloured by a value ----

    def _plain(self, drawn: Drawn, some: Stretches) -> dict[str, Any]:
        """Return the colour of lines in a figure without a slider."""
        if len(some.colours) == 1:
            return {"color": some.colours[0]}
        colours = self._shown(drawn, some.places, some.starts)
        return {"color": colours, **self._whole_scale(drawn), "showscale": True}

    def _shown(self, drawn: Drawn, places: Numbers, starts: Numbers) -> Numbers:
        """Return a value for each point: that of the line that leads to it, or of the line that
        begins at it.
        """
        values = self.colouring.values
        assert values is not None
        points = drawn.points
        if self.colouring.by == "time":
            return points.time[places]
        if self.colouring.by == "z":
            return points.z[places]
        feeds = values[points.move - (self.number + self.first)]
        shown: Numbers = feeds[places]
        begun = np.flatnonzero(starts)  # the start of a line has the feed of the line
        shown[begun] = feeds[places[begun + 1]]
        return shown

    def _limits(self, drawn: Drawn) -> tuple[float, float]:
        cutting = drawn.keys // CODES > RAPID
        places, starts = line_runs(cutting, drawn.keys)
        shown = self._shown(drawn, places, starts)[places >= 0]
        return float(shown.min()), float(shown.max())

    def _shares(self, drawn: Drawn, places: Numbers, starts: Numbers) -> Numbers:
        low, high = self._limits(drawn)
        shares = (self._shown(drawn, places, starts) - low) / ((high - low) or 1.0)
        return np.clip(shares, 0.0, 1.0)

    def _whole_scale(self, drawn: Drawn) -> dict[str, Any]:
        low, high = self._limits(drawn)
        ticks = {} if high > low else {"tickvals": [low], "ticktext": [f"{low:g}"]}
        return {
            "colorscale": SCALE,
            "cmin": low if high > low else low - 1,
            "cmax": high if high > low else high + 1,
            "colorbar": {
                "title": {"text": WORDS[self.colouring.by], "side": "right"},
                "thickness": 12,
                "len": 0.7,
                "outlinewidth": 0,
                **ticks,
            },
        }

    def _scale_beside(self, drawn: Drawn) -> dict[str, Any]:
        """Return a trace with the scale of the colours, for a line whose own colours show
        progress.
        """
        beside = {"color": [0.0], **self._whole_scale(drawn), "showscale": True}
        return {**_nowhere("markers"), "marker": beside, "showlegend": False}

    # ---- where one looks from ----

    def _scene(self, drawn: Drawn) -> dict[str, Any] | None:
        flat = float(np.ptp(drawn.points.y)) < 1e-9 < float(np.ptp(drawn.points.x))
        turning = flat and bool(self.core.diameters & 1)
        flat_z = not turning and float(np.ptp(drawn.points.z)) < 1e-9
        eye, up = (-0.9, -1.5, 1.0), (0, 0, 1)
        if turning:  # as on the drawing: Z to the right, X up
            eye, up = (0, 2, 0), (1, 0, 0)
        elif flat_z:  # from above
            eye, up = (0, 0, 2), (0, 1, 0)
        camera = {
            "projection": {"type": "orthographic"},
            "eye": dict(zip("xyz", eye)),
            "up": dict(zip("xyz", up)),
        }
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
        if turning or flat_z:  # the view is along this axis
            axes["yaxis" if turning else "zaxis"]["visible"] = False
        # True to scale: one millimetre is as long on every axis.
        sides = np.maximum(np.ptp(drawn.xyz, axis=0), 1e-3)
        sides = np.maximum(sides, sides.max() / 50)
        wide, high = _seen(sides, np.array(eye), np.array(up))
        scale = min(_WIDE / wide, _HIGH / high)
        ratio = {letter: float(side * scale) for letter, side in zip("xyz", sides)}
        return {
            **axes,
            "aspectmode": "manual",
            "aspectratio": ratio,
            "camera": camera,
            "dragmode": "orbit",
        }


def _seen(sides: Numbers, eye: Numbers, up: Numbers) -> tuple[float, float]:
    """Return how wide and how high a box looks from `eye`."""
    right = np.cross(up, eye) / float(np.linalg.norm(np.cross(up, eye)))
    above = np.cross(eye, right) / float(np.linalg.norm(eye))
    return float(sides @ abs(right)), float(sides @ abs(above))


def alarm_place(alarm: Any) -> str:
    where = f"line {alarm.line}" if alarm.n is None else f"N{alarm.n} line {alarm.line}"
    return f"{alarm.program} {where}"


def left_out(drawn: Drawn) -> list[str]:
    if (behind := drawn.behind) is None:
        return drawn.told
    cut = (
        f"Cut: nothing after move {behind:,} is drawn; moves=range({behind}, ...) shows the rest,"
        " most= draws more points."
    )
    return [*drawn.told, cut]


def _nowhere(mode: str) -> dict[str, Any]:
    """Return a trace that draws nothing."""
    none = {axis: [None] for axis in "xyz"}
    return {"type": "scatter3d", "mode": mode, **none, "hoverinfo": "skip"}


def entry(some: Stretches) -> dict[str, Any]:
    """Return an entry of the legend for a line whose own colours show how far the path has come."""
    return {
        **_nowhere("lines"),
        "name": shown_text(some.name),
        "legendgroup": some.group,
        "showlegend": True,
        "line": {"width": some.width, "dash": some.dash, "color": some.colours[0]},
    }
