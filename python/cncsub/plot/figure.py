"""The common parts of the plots: the look, which is legible on dark and on light pages, the notes
under a picture, and the words of blocks and calls.
"""

from __future__ import annotations

import functools
import textwrap
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from cncsub.drawing.colours import TEXT
from cncsub.escapes import escape
from cncsub.plot.still import still_svg, still_text
from cncsub.tables.of_runs import Calls
from cncsub.tables.table import optional_module

if TYPE_CHECKING:
    import numpy as np

    from cncsub import _core

GRID = "rgba(127,137,145,0.3)"
SOLID_GRID = "#99a2a8"  # WebGL knows no transparent lines
# Colours that most eyes tell apart, on white as on black.
COLOURS = [
    *("#3d8fd6", "#e8833a", "#2fa36b", "#b565d8", "#c9a227", "#d9534f"),
    *("#1aa6a6", "#8a7a5c", "#7c83e0", "#e06c9f", "#6d9b2f", "#5f8fa0"),
]
OTHERS = "#8a949b"
_WIDE = 76  # letters of a line under a picture
_MOST_LETTERS = 90  # of a block
_MOST_CALLERS = 8
_INTERACTIVE = "application/vnd.plotly.v1+json"


def graph_objects() -> Any:
    """Return `plotly.graph_objects`; `ImportError` says how to install it."""
    return optional_module("plotly.graph_objects")


def figure(
    data: Iterable[Mapping[str, Any]],
    layout: Mapping[str, Any],
    *,
    title: str,
    told: Iterable[str],
    height: int = 480,
    frames: Iterable[Mapping[str, Any]] = (),
    below: int = 0,
    attached: Mapping[str, Any] | None = None,
) -> Any:
    """Return a figure with its title and its legend, `height` pixels of picture, and the notes
    `told`, `below` pixels under the picture. `attached`: what the figure carries along by name.
    """
    data = list(data)
    listed = sum(1 for one in data if one.get("showlegend", True) and one.get("name"))
    legend = listed > 1 or any(one.get("showlegend") for one in data)
    head = 48 if not legend else 84 if listed < 4 else 112  # lines of a legend on a narrow page
    lines = [line for part in told for line in textwrap.wrap(part, _WIDE)]
    note = {
        "text": "<br>".join(escape(line, quote=False) for line in lines),
        "showarrow": False,
        "xref": "paper",
        "yref": "paper",
        "x": 0,
        "y": 0,
        "xanchor": "left",
        "yanchor": "top",
        "yshift": -below - 8,
        "align": "left",
        "font": {"size": 11},
    }
    base: dict[str, Any] = {
        "template": "none",
        "title": {
            "text": escape(title, quote=False),
            "font": {"size": 15},
            "x": 0,
            "xref": "paper",
            "y": 1,
            "yref": "container",
            "yanchor": "top",
            "pad": {"t": 14},
        },
        "paper_bgcolor": "rgba(0,0,0,0)",
        "plot_bgcolor": "rgba(0,0,0,0)",
        "font": {"color": TEXT, "family": "system-ui, sans-serif"},
        "hoverlabel": {
            "bgcolor": "#1d2327",
            "font": {"color": "#f2f4f5", "family": "ui-monospace, monospace", "size": 12},
            "align": "left",
        },
        "margin": {"l": 16, "r": 16, "t": head, "b": below + 24 + 15 * len(lines)},
        "height": height + head + 24 + 15 * len(lines) + below,
        "showlegend": legend,
        "legend": {
            "orientation": "h",
            "x": 0,
            "y": 1,
            "yanchor": "bottom",
            "font": {"size": 12},
            "itemsizing": "constant",
            "bgcolor": "rgba(0,0,0,0)",
        },
        "colorway": COLOURS,
        "annotations": [note],
    }
    own = dict(layout)
    base["annotations"] = [note, *own.pop("annotations", ())]
    base.update(own)
    drawn = _figure_class(graph_objects())({"data": data, "layout": base, "frames": list(frames)})
    for name, value in (attached or {}).items():
        setattr(drawn, name, value)
    return drawn


@functools.cache
def _figure_class(objects: Any) -> Any:
    """Return plotly's figure with what is shown where plotly cannot draw: a drawing in SVG and a
    text. A page of GitHub shows the drawing, and so does a viewer without JavaScript.
    """
    plain: Any = objects.Figure

    class Figure(plain):  # type: ignore[misc]
        def _ipython_display_(self) -> None:
            bundle = self._repr_mimebundle_()
            if bundle.keys() <= {"image/svg+xml", "text/plain"}:  # shown outside the notebook
                super()._ipython_display_()
                return
            from IPython.display import display

            display(bundle, raw=True)  # type: ignore[no-untyped-call]

        def _repr_mimebundle_(self, *args: Any, **options: Any) -> dict[str, Any]:
            bundle: dict[str, Any] = super()._repr_mimebundle_(*args, **options)
            if _INTERACTIVE in bundle:
                bundle.pop("text/html", None)  # the same once more, with the library
            return {**bundle, "image/svg+xml": still_svg(self), "text/plain": still_text(self)}

        def __reduce__(self) -> tuple[Any, ...]:
            return (plain, *super().__reduce__()[1:])

    return Figure


def axis(title: str, **more: Any) -> dict[str, Any]:
    """Return an axis in the colours of the plots."""
    return {
        "title": {"text": title, "font": {"size": 12}},
        "gridcolor": GRID,
        "zerolinecolor": GRID,
        "linecolor": GRID,
        "color": TEXT,
        "automargin": True,
        **more,
    }


def empty(why: str, title: str) -> Any:
    """Return a figure that says why it is empty."""
    hidden = {"visible": False}
    return figure([], {"xaxis": hidden, "yaxis": hidden}, title=title, told=[why], height=20)


def shown_text(text: str) -> str:
    """Return a block as a hover shows it: cut, and escaped because plotly knows some tags."""
    cut = text if len(text) <= _MOST_LETTERS else text[: _MOST_LETTERS - 3] + "..."
    return escape(cut, quote=False)


def count(number: int, what: str) -> str:
    return f"{number:,} {what}{'' if number == 1 else 's'}"


class Places:
    """The words for steps: their block, and the calls that led there. Each is made once."""

    def __init__(self, core: _core.Trace) -> None:
        from cncsub.tables.rows import Step

        self._core = core
        self._row = Step
        self._calls = Calls(core)
        self._first = int(core.step_row(0, Step).step) if core.steps else 0
        self._blocks: dict[int, str] = {}
        self._stacks: dict[int, str] = {}
        self._rows: dict[int, int] | None = None

    def of(self, step: int) -> str:
        """Return the block of a step, its text, and who called."""
        known = self._blocks.get(step)
        if known is None:
            known = self._blocks[step] = self._made(step)
        return known

    def _made(self, step: int) -> str:
        row = step - self._first
        if not 0 <= row < self._core.steps:
            return f"step {step:,}"
        at = self._core.step_row(row, self._row)
        (text,) = self._core.step_texts(row, row + 1)
        stack = self._stack(at.frame) if at.frame >= 0 else ""
        repeat = f", pass {at.repeat}" if at.repeat > 1 else ""
        head = f"<b>{_place(at)}</b>{repeat}<br>{shown_text(text)}"
        return f"{head}<br>{stack}" if stack else head

    def _stack(self, call: int) -> str:
        """Return the open calls, innermost first."""
        known = self._stacks.get(call)
        if known is not None:
            return known
        lines: list[str] = []
        at: int | None = call
        while at is not None and len(lines) < _MOST_CALLERS:
            row = self._call_row(at)
            if row is None:
                break
            called = self._calls[row]
            caller = called.caller_step - self._first
            from_block = ""
            if 0 <= caller < self._core.steps:
                from_block = f" from {_place(self._core.step_row(caller, self._row))}"
            lines.append(f"in {called.kind} {shown_text(called.program)}{from_block}")
            at = called.parent
        if at is not None and len(lines) == _MOST_CALLERS:
            lines.append("in ...")
        self._stacks[call] = text = "<br>".join(lines)
        return text

    def _call_row(self, call: int) -> int | None:
        if self._rows is None:
            numbers = self._calls.call
            plain = len(numbers) == 0 or (numbers[0] == 0 and numbers[-1] == len(numbers) - 1)
            self._rows = {} if plain else {int(c): i for i, c in enumerate(numbers.tolist())}
        if self._rows:
            return self._rows.get(call)
        return call if call < len(self._calls) else None


def _place(step: Any) -> str:
    where = f"line {step.line}" if step.n is None else f"N{step.n} line {step.line}"
    return f"{shown_text(step.program)} {where}"


def seconds(core: _core.Trace) -> np.ndarray[Any, Any]:
    """Return when each move ends, s."""
    import numpy as np

    return np.cumsum(core.move_columns(["time"])["time"])


def clock(seconds: float) -> str:
    """Return a time as people say it: 3.2 s, 4:05, 1:02:03."""
    if seconds < 60:
        return f"{seconds:.1f} s"
    whole = round(seconds)
    hours, rest = divmod(whole, 3600)
    minutes = f"{rest // 60:02}" if hours else f"{rest // 60}"
    return f"{hours}:{minutes}:{rest % 60:02}" if hours else f"{minutes}:{rest % 60:02}"
