"""What is shown of a figure where plotly cannot draw: a drawing in SVG, and a text."""

from __future__ import annotations

import html
import math
import re
from collections.abc import Iterator
from typing import Any

from cncsub.drawing.axes import round_step, tick_text
from cncsub.drawing.colours import TEXT
from cncsub.escapes import escape

_WIDTH, _LEFT, _RIGHT, _TOP, _BOTTOM = 640.0, 64.0, 18.0, 30.0, 44.0
_LEAST, _MOST = 90.0, 420.0  # heights of what is inside the axes
_TICKS_APART = 70.0
_MOST_TEXTS = 80  # beside marks


def still_text(figure: Any) -> str:
    """Return the title of a figure, its legend and its notes."""
    lines = [_plain(figure.layout.title.text)]
    names = [one.name for one in figure.data if one.name and one.showlegend is not False]
    if names:
        lines.append("shown: " + ", ".join(map(_plain, dict.fromkeys(names))))
    lines += [_plain(note.text) for note in figure.layout.annotations if note.text]
    return "\n".join(lines)


def _plain(text: str | None) -> str:
    return html.unescape(re.sub(r"<br ?/?>", " ", text or ""))


def still_svg(figure: Any) -> str:
    """Return a figure as a drawing: that of the path, or the bars, lines and marks of its axes."""
    drawing = getattr(figure, "_drawing", None)
    return drawing() if drawing is not None else "".join(_Still(figure).svg())


class _Axis:
    """Where the numbers of an axis lie on the drawing."""

    def __init__(
        self, layout: Any, values: list[float], begin: float, end: float, *, padded: bool
    ) -> None:
        low, high = (min(values), max(values)) if values else (0.0, 1.0)
        pad = 0.06 * (high - low) or 0.5
        low, high = (low - pad, high + pad) if padded else (low, high)
        if layout.range is not None:
            low, high = layout.range
        if layout.autorange == "reversed":
            low, high = high, low
        self.low, self.high = float(low), float(high)
        self.begin, self.end = begin, end
        self.shown = layout.visible is not False
        self.title = _plain(layout.title.text)

    def at(self, value: float) -> float:
        part = (value - self.low) / ((self.high - self.low) or 1.0)
        return self.begin + (self.end - self.begin) * part

    def ticks(self) -> Iterator[tuple[float, str]]:
        if not self.shown:
            return
        room = abs(self.end - self.begin)
        low, high = sorted((self.low, self.high))
        if not high > low:
            return
        step = round_step((high - low) * min(1.0, _TICKS_APART / 1.6 / room))
        number = -(-low // step)
        while number * step <= high + step * 1e-6:
            yield self.at(number * step), tick_text(number * step, step)
            number += 1


class _Still:
    def __init__(self, figure: Any) -> None:
        self.figure = figure
        margin = figure.layout.margin
        inner = (figure.layout.height or 400) - (margin.t or 0) - (margin.b or 0)
        self.inner = min(_MOST, max(_LEAST, float(inner)))
        self.traces = [one for one in figure.data if one.type in ("scatter", "bar")]
        self.x = self._axis("xaxis", _LEFT, _WIDTH - _RIGHT)
        names = {self._y_name(one) for one in self.traces} or {"yaxis"}
        self.y = {name: self._y_axis(name) for name in sorted(names)}

    def _y_name(self, trace: Any) -> str:
        return "yaxis" + (trace.yaxis or "y")[1:]

    def _y_axis(self, name: str) -> _Axis:
        low, high = self.figure.layout[name].domain or (0.0, 1.0)
        bottom = _TOP + self.inner
        return self._axis(name, bottom - low * self.inner, bottom - high * self.inner)

    def _axis(self, name: str, begin: float, end: float) -> _Axis:
        values: list[float] = []
        padded = True
        for one in self.traces:
            if name != "xaxis" and self._y_name(one) != name:
                continue
            if one.type == "bar":
                values += self._bar_values(one, name)
                padded = False
            else:
                column = one.x if name == "xaxis" else one.y
                values += [float(v) for v in column if v is not None and v == v]
        return _Axis(self.figure.layout[name], values, begin, end, padded=padded)

    def _bar_values(self, one: Any, name: str) -> list[float]:
        if name != "xaxis":
            return [float(v) + side for v in one.y for side in (-0.5, 0.5)]
        return [float(v) for b, w in zip(one.base, one.x) for v in (b, b + w)]

    def svg(self) -> Iterator[str]:
        legend = list(self._legend())
        height = _TOP + self.inner + _BOTTOM + (18 if legend else 0)
        title = escape(_plain(self.figure.layout.title.text))
        yield (
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDTH:.0f} {height:.0f}"'
            f' role="img" aria-label="{title}" font-family="system-ui, sans-serif" font-size="12"'
            f' style="max-width:52rem;width:100%"><text x="8" y="16" font-size="14"'
            f' fill="{TEXT}">{title}</text>'
        )
        yield from self._axes()
        for one in self.traces:
            yield from self._bars(one) if one.type == "bar" else self._scatter(one)
        yield from self._heads()
        yield from legend
        yield "</svg>"

    def _axes(self) -> Iterator[str]:
        bottom = _TOP + self.inner
        line = f'stroke="{TEXT}" stroke-opacity=".3"'
        text = f'fill="{TEXT}"'
        for at, words in self.x.ticks():
            yield f'<path d="M{at:.1f} {_TOP:.0f}V{bottom + 4:.1f}" {line}/>'
            yield f'<text x="{at:.1f}" y="{bottom + 17:.1f}" text-anchor="middle" {text}>'
            yield f"{words}</text>"
        if self.x.shown and self.x.title:
            yield f'<text x="{_WIDTH - _RIGHT:.1f}" y="{bottom + 34:.1f}" text-anchor="end" {text}>'
            yield f"{escape(self.x.title)}</text>"
        for axis in self.y.values():
            for at, words in axis.ticks():
                yield f'<path d="M{_LEFT - 4:.1f} {at:.1f}H{_WIDTH - _RIGHT:.1f}" {line}/>'
                yield f'<text x="{_LEFT - 7:.1f}" y="{at + 4:.1f}" text-anchor="end" {text}>'
                yield f"{words}</text>"
            if axis.shown and axis.title:
                middle = (axis.begin + axis.end) / 2
                yield (
                    f'<text transform="translate(14 {middle:.1f}) rotate(-90)"'
                    f' text-anchor="middle" {text}>{escape(axis.title)}</text>'
                )

    def _bars(self, one: Any) -> Iterator[str]:
        y = self.y[self._y_name(one)]
        high = abs(y.at(0.92) - y.at(0))
        texts = one.text if one.text is not None else [""] * len(one.x)
        for base, wide, row, words in zip(one.base, one.x, one.y, texts):
            left, right = self.x.at(base), self.x.at(base + wide)
            top = y.at(row) - high / 2
            yield (
                f'<rect x="{left:.1f}" y="{top:.1f}" width="{max(right - left, 0.4):.1f}"'
                f' height="{high:.1f}" fill="{one.marker.color}"/>'
            )
            shown = _plain(words)
            if shown and right - left > 7 * len(shown) + 8:
                yield f'<text x="{left + 5:.1f}" y="{top + high / 2 + 4:.1f}" fill="#fff">'
                yield f"{escape(shown)}</text>"

    def _scatter(self, one: Any) -> Iterator[str]:
        y = self.y[self._y_name(one)]
        mode = one.mode or "lines"
        points = [
            None if a is None or b is None or a != a or b != b else (self.x.at(a), y.at(b))
            for a, b in zip(one.x, one.y)
        ]
        if "lines" in mode:
            yield self._line(one, points)
        if "markers" in mode:
            colour = one.marker.color or TEXT
            open_ = "open" in str(one.marker.symbol)
            fill = (
                f'fill="none" stroke="{colour}" stroke-width="2"' if open_ else f'fill="{colour}"'
            )
            size = (one.marker.size or 6) / 2
            marks = (
                f'<circle cx="{p[0]:.1f}" cy="{p[1]:.1f}" r="{size:g}" {fill}/>'
                for p in points
                if p
            )
            yield from marks
        if "text" in mode and len(points) <= _MOST_TEXTS:
            places = one.textposition
            for row, (point, words) in enumerate(zip(points, one.text)):
                place = places if isinstance(places, str) or places is None else places[row]
                if point and words:
                    yield _beside(point, words, place or "middle right")

    def _line(self, one: Any, points: list[tuple[float, float] | None]) -> str:
        data = []
        before: tuple[float, float] | None = None
        for point in points:
            if point is not None and before is None:
                data.append(f"M{point[0]:.1f} {point[1]:.1f}")
            elif point is not None and one.line.shape == "hv":
                data.append(f"H{point[0]:.1f}V{point[1]:.1f}")
            elif point is not None:
                data.append(f"L{point[0]:.1f} {point[1]:.1f}")
            before = point
        colour = one.line.color or TEXT
        wide = one.line.width or 2
        return f'<path d="{"".join(data)}" fill="none" stroke="{colour}" stroke-width="{wide}"/>'

    def _heads(self) -> Iterator[str]:
        """Yield the heads of arrows."""
        y = next(iter(self.y.values()))
        for note in self.figure.layout.annotations:
            if not note.showarrow:
                continue
            x1, y1 = self.x.at(note.x), y.at(note.y)
            dx, dy = x1 - self.x.at(note.ax), y1 - y.at(note.ay)
            turn = math.degrees(math.atan2(dy, dx))
            yield (
                f'<path transform="translate({x1:.1f} {y1:.1f}) rotate({turn:.1f})"'
                f' d="M-8 0l-8 -4v8z" fill="{TEXT}"/>'
            )

    def _legend(self) -> Iterator[str]:
        if not self.figure.layout.showlegend:
            return
        x, y = 8.0, _TOP + self.inner + _BOTTOM + 6
        for one in self.traces:
            words = _plain(one.name)
            if not words or one.showlegend is False:
                continue
            if x + 20 + 7 * len(words) > _WIDTH:
                yield f'<text x="{x:.1f}" y="{y:.1f}" fill="{TEXT}">...</text>'
                return
            colour = one.marker.color or one.line.color or TEXT
            yield f'<rect x="{x:.1f}" y="{y - 9:.1f}" width="10" height="10" fill="{colour}"/>'
            yield f'<text x="{x + 15:.1f}" y="{y:.1f}" fill="{TEXT}">{escape(words)}</text>'
            x += 30 + 7 * len(words)


def _beside(point: tuple[float, float], words: str, place: str) -> str:
    x, y = point
    anchor = "start" if "right" in place else "middle"
    x += 11 if anchor == "start" else 0
    y += -11 if "top" in place else 4
    text = escape(_plain(words))
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{TEXT}">{text}</text>'
