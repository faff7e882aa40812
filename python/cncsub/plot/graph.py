"""`library.plot()`: the calls between programs, as a picture."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

from cncsub.drawing.colours import TEXT
from cncsub.plot.figure import COLOURS, GRID, OTHERS, count, empty, figure, shown_text
from cncsub.references import CallGraph, Computed, Edge

if TYPE_CHECKING:
    from cncsub.library import Library

_MOST = 250  # programs
_SWEEPS = 6  # to lay programs near those that call them
_MOST_EDGES = 6  # named on one arrow
_STATES = {
    "main": (COLOURS[0], "main program"),
    "called": (COLOURS[2], "called"),
    "unreached": (OTHERS, "not reached from the main program"),
    "missing": (COLOURS[5], "missing"),
    "computed": (COLOURS[4], "computed when it runs"),
}


def graph_figure(library: Library, *, title: str | None, entry: Iterable[str]) -> Any:
    """See `Library.plot`."""
    graph = library.call_graph(entry=entry)
    main = library.main
    head = title if title is not None else _title(graph)
    if not graph.programs:
        return empty("There are no programs.", head)
    return _Graph(graph, None if main is None else main.name, library).figure(head)


def _title(graph: CallGraph) -> str:
    return f"{count(len(graph.programs), 'program')}, {count(len(graph.edges), 'call')}"


class _Graph:
    def __init__(self, graph: CallGraph, main: str | None, library: Library) -> None:
        self.library = library
        self.told: list[str] = []
        self.state = _states(graph, main)
        self.arrows: dict[tuple[str, str], list[Edge]] = {}
        for edge in graph.edges:
            self.arrows.setdefault((edge.caller, _key(edge)), []).append(edge)
        self.layers = self._layers(main, graph)
        self._cut()
        self.at = _placed(self.layers, self.arrows)

    def _layers(self, main: str | None, graph: CallGraph) -> dict[str, int]:
        """Return how many calls away from the main program each program is; others are counted from
        the roots that lead to them.
        """
        after: dict[str, list[str]] = {}
        for caller, called in self.arrows:
            after.setdefault(caller, []).append(called)
        layers: dict[str, int] = {}
        starts = [*([main] if main is not None else []), *graph.roots, *self.state]
        for start in starts:
            if start in layers:
                continue
            layers[start] = 0
            front = [start]
            while front:
                new = [to for name in front for to in after.get(name, ()) if to not in layers]
                for to in new:
                    layers.setdefault(to, layers[front[0]] + 1)
                front = list(dict.fromkeys(new))
        return layers

    def _cut(self) -> None:
        """Keep no more programs than a picture can show, those near the main program first."""
        rank = {name: row for row, name in enumerate(self.layers)}
        reached = ("main", "called", "missing", "computed")
        order = sorted(
            self.layers,
            key=lambda n: (self.state[n] not in reached, self.layers[n], rank[n]),
        )
        if len(order) <= _MOST:
            return
        kept = set(order[:_MOST])
        self.told.append(
            f"{len(order) - _MOST:,} of {len(order):,} programs are not drawn: those farthest from"
            " the main program. library.call_graph() has all."
        )
        self.layers = {name: layer for name, layer in self.layers.items() if name in kept}
        self.arrows = {pair: of for pair, of in self.arrows.items() if kept.issuperset(pair)}

    def figure(self, title: str) -> Any:
        lines, middles = self._lines(), self._middles()
        data = [*lines, middles, *self._nodes()]
        widest = max(sum(1 for n in self.layers.values() if n == k) for k in self.layers.values())
        depth = max(self.layers.values()) + 1
        hidden = {"visible": False, "showgrid": False, "zeroline": False}
        layout = {
            "xaxis": {**hidden, "range": [-0.6, 0.6 + (depth - 1)]},
            "yaxis": {**hidden},
            "annotations": list(self._heads()),
            "hovermode": "closest",
        }
        height = min(2_400, 90 + 36 * widest)
        return figure(data, layout, title=title, told=self.told, height=height)

    def _nodes(self) -> Iterator[dict[str, Any]]:
        few = len(self.layers) <= 60
        calling = {caller for caller, _ in self.arrows}
        for state, (colour, words) in _STATES.items():
            names = [name for name in self.layers if self.state[name] == state]
            if not names:
                continue
            hollow = state in ("missing", "computed")
            yield {
                "type": "scatter",
                "mode": "markers+text",
                "x": [self.at[name][0] for name in names],
                "y": [self.at[name][1] for name in names],
                "text": [_label(name) for name in names],
                # The text is not where arrows come in from the left, or go on to the right.
                "textposition": [
                    "top center" if name in calling else "middle right" for name in names
                ],
                "textfont": {"size": 12 if few else 9, "color": TEXT},
                "hovertext": [self._told_of(name) for name in names],
                "hovertemplate": "%{hovertext}<extra></extra>",
                "name": words,
                "cliponaxis": False,
                "marker": {
                    "size": 14 if few else 9,
                    "color": colour,
                    "symbol": "circle-open" if hollow else "circle",
                    "line": {"width": 2 if hollow else 0, "color": colour},
                },
            }

    def _told_of(self, name: str) -> str:
        words = [f"<b>{shown_text(name)}</b>"]
        if self.state[name] in ("missing", "computed"):
            words.append(_STATES[self.state[name]][1])
        else:
            program = self.library[name]
            if program.comment:
                words.append(shown_text(program.comment))
            words.append(f"{count(len(program.blocks), 'block')}, {shown_text(program.file)}")
        calls = sum(len(of) for (_, to), of in self.arrows.items() if to == name)
        made = sum(len(of) for (caller, _), of in self.arrows.items() if caller == name)
        words.append(f"called by {count(calls, 'block')}, calls in {count(made, 'block')}")
        return "<br>".join(words)

    def _curve(self, pair: tuple[str, str]) -> list[tuple[float, float]]:
        """Return the points from program to program: straight to the next layer, else with a bow
        around what lies between.
        """
        (x0, y0), (x1, y1) = self.at[pair[0]], self.at[pair[1]]
        if pair[0] == pair[1]:
            return [(x0, y0), (x0 + 0.16, y0 + 0.45), (x0 - 0.16, y0 + 0.45), (x0, y0)]
        bow = 0.0 if x1 - x0 == 1 else 0.35 * (abs(x1 - x0) or 1.0)
        points = []
        for step in range(13):
            t = step / 12
            dx = bow * 4 * t * (1 - t) if x0 == x1 else 0.0
            dy = -bow * 4 * t * (1 - t) if x0 != x1 else 0.0
            points.append((x0 + (x1 - x0) * t + dx * 0.5, y0 + (y1 - y0) * t + dy))
        return points

    def _lines(self) -> list[dict[str, Any]]:
        x: list[float | None] = []
        y: list[float | None] = []
        for pair in self.arrows:
            for px, py in self._curve(pair):
                x.append(px)
                y.append(py)
            x.append(None)
            y.append(None)
        return [
            {
                "type": "scatter",
                "mode": "lines",
                "x": x,
                "y": y,
                "line": {"color": GRID.replace("0.3", "0.75"), "width": 1.5, "shape": "spline"},
                "hoverinfo": "skip",
                "showlegend": False,
            }
        ]

    def _middles(self) -> dict[str, Any]:
        """Return a point on each arrow that names its calls."""
        x, y, told = [], [], []
        for pair, edges in self.arrows.items():
            curve = self._curve(pair)
            middle = curve[len(curve) // 2]
            x.append(middle[0])
            y.append(middle[1])
            head = f"<b>{_label(pair[0])} calls {_label(pair[1])}</b>"
            lines = [_edge_words(edge) for edge in edges[:_MOST_EDGES]]
            if len(edges) > _MOST_EDGES:
                lines.append(f"and {len(edges) - _MOST_EDGES:,} more")
            told.append("<br>".join([head, *lines]))
        return {
            "type": "scatter",
            "mode": "markers",
            "x": x,
            "y": y,
            "marker": {"size": 6, "color": TEXT, "symbol": "diamond"},
            "hovertext": told,
            "hovertemplate": "%{hovertext}<extra></extra>",
            "showlegend": False,
        }

    def _heads(self) -> Iterator[dict[str, Any]]:
        """Yield the heads of the arrows."""
        for pair in self.arrows:
            curve = self._curve(pair)
            (ax, ay), (x, y) = curve[-2], curve[-1]
            yield {
                "x": x,
                "y": y,
                "ax": ax,
                "ay": ay,
                "xref": "x",
                "yref": "y",
                "axref": "x",
                "ayref": "y",
                "text": "",
                "showarrow": True,
                "arrowhead": 2,
                "arrowsize": 1.1,
                "arrowwidth": 1.5,
                "arrowcolor": TEXT,
                "standoff": 9,
            }


def _key(edge: Edge) -> str:
    """Return what an arrow leads to: a program, or the expression that computes it."""
    return edge.called.expression if isinstance(edge.called, Computed) else edge.called


def _states(graph: CallGraph, main: str | None) -> dict[str, str]:
    unreached = set(graph.unreached)
    state = {name: "unreached" if name in unreached else "called" for name in graph.programs}
    if main is not None:
        state[main] = "main"
    for edge in graph.edges:
        if isinstance(edge.called, Computed):
            state.setdefault(edge.called.expression, "computed")
        elif edge.exists is False:
            state.setdefault(edge.called, "missing")
        else:
            state.setdefault(edge.called, "called")
    return state


def _placed(
    layers: dict[str, int], arrows: dict[tuple[str, str], list[Edge]]
) -> dict[str, tuple[float, float]]:
    """Return the place of each program. Each layer is a column; in it each program is as near to
    those it has arrows with as there is room.
    """
    columns: dict[int, list[str]] = {}
    for name, layer in layers.items():
        columns.setdefault(layer, []).append(name)
    near: dict[str, list[str]] = {name: [] for name in layers}
    for caller, called in arrows:
        near[caller].append(called)
        near[called].append(caller)
    at: dict[str, float] = {}
    for names in columns.values():
        at.update({name: (len(names) - 1) / 2 - row for row, name in enumerate(names)})
    for _ in range(_SWEEPS):
        for names in columns.values():
            wanted = {
                name: sum(at[other] for other in near[name]) / len(near[name])
                if near[name]
                else at[name]
                for name in names
            }
            names.sort(key=lambda name: -wanted[name])
            at.update({name: (len(names) - 1) / 2 - row for row, name in enumerate(names)})
    return {name: (float(layer), at[name]) for name, layer in layers.items()}


def _label(name: str) -> str:
    return shown_text(name if len(name) <= 24 else name[:21] + "...")


def _edge_words(edge: Edge) -> str:
    where = f"line {edge.line}" if edge.n is None else f"N{edge.n} line {edge.line}"
    repeats = edge.repeats
    times = "" if repeats == 1 else f", {repeats} times"
    if isinstance(repeats, Computed):
        times = f", {repeats.expression} times"
    return shown_text(f"{edge.kind} at {where}{times}")
