"""The path of a run as SVG: true to scale, with axes, holes, tool changes and the alarm's place.

A drawing stands alone: its colours are legible on white and on black, and a page may set others by
the classes of its groups.
"""

from __future__ import annotations

import itertools
import textwrap
from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from cncsub.drawing.axes import BOTTOM, INCH, LEFT, RIGHT, TOP, WIDTH, Frame
from cncsub.drawing.colours import ALARM, FAMILIES, HOLE, TEXT, TOOL_CHANGE
from cncsub.drawing.marks import Holes, Moved, ToolChange, holes_of, last_place, tool_changes
from cncsub.drawing.path import ABOVE, RAPID, TURNING, View, path_of
from cncsub.escapes import escape
from cncsub.option_errors import wrong_value

if TYPE_CHECKING:
    from cncsub._core import Alarm
    from cncsub.drawing.path import Path
    from cncsub.run import Outcome, Recorded

    Numbers = np.ndarray[Any, np.dtype[Any]]

Place = Callable[[int], tuple[str, str]]  # of a motion: the link and the words for its block

MOST_LINKED = 1_000  # moves that are links of their own
MOST_POINTS = 20_000  # of a drawing in a report
FEW_POINTS = 4_000  # of a drawing in a notebook
MOST_NUMBERED = 60  # holes with numbers
_MOST_TOLD = 300  # holes with a text of their own
_MOST_CHANGES = 30  # places of tool changes
_MOST_TOOLS = 3  # named at one place
_LETTER = 6.6  # the width of a letter, in the units of the drawing
_LINE = 16.0  # the height of a line of the legend
_SLANT = np.array([[0.866, 0.0], [-0.866, 0.0], [0.0, 1.0]]) + np.array(
    [[0.0, 0.5], [0.0, 0.5], [0.0, 0.0]]
)


class Picture:
    """What is drawn of a run, from any side."""

    def __init__(
        self,
        run: Recorded,
        *,
        coordinates: str = "work",
        linked: int = 0,
        most: int = FEW_POINTS,
        inch: bool = False,
        alarm: Alarm | None = None,
        rows: tuple[int, int] | None = None,
    ) -> None:
        core = run.recorded
        self.path = path_of(core, coordinates, linked=linked, most=most, rows=rows)
        self.moved = Moved(core, coordinates, self.path.diameters, *(rows or (0, core.moves)))
        self.linked = len(self.path.family) <= linked
        self.inch = inch
        self.alarm = alarm

    def frame(self, view: View | None = None) -> Frame:
        """Return where the points of a view lie on its drawing."""
        path = self.path
        return Frame(path.points, view or path.view, diameters=path.diameters, inch=self.inch)

    def svg(self, view: View | None = None, place: Place | None = None) -> str:
        """Return the drawing. `place`: the link and the words for a motion."""
        return _Drawing(self, self.frame(view), place).svg()

    def words(self, view: View | None = None) -> str:
        """Return the view and its size in words."""
        frame = self.frame(view)
        right, up = frame.view.letters()
        return f"{frame.view.name}, {right} and {up}: {frame.size_words()}"

    def slanted(self, place: Place | None = None) -> str:
        """Return the drawing from above and the side, without axes."""
        flat = self.path.points @ _SLANT
        points = np.column_stack((flat, np.zeros(len(flat))))
        frame = Frame(points, ABOVE, diameters=False, inch=self.inch)
        height = frame.height - BOTTOM + TOP
        lines = "".join(_lines(frame.placed(points), self, place))
        return _element(height, "path from above and the side", lines)


def svg_of(run: Outcome, coordinates: str) -> str:
    """See `Run.svg`."""
    if coordinates not in ("work", "machine"):
        raise wrong_value(
            "coordinates", f"coordinates must be work or machine, not {coordinates!r}"
        )
    if not len(run.moves):
        return ""
    core = run.core
    return Picture(run, coordinates=coordinates, inch=core.inch, alarm=core.alarm).svg()


def _element(height: float, words: str, inner: str) -> str:
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" class="path" viewBox="0 0 {WIDTH:.0f}'
        f' {height:.0f}" role="img" aria-label="{escape(words)}" font-family="system-ui,'
        f' sans-serif" font-size="12" style="max-width:36rem;width:100%">{inner}</svg>'
    )


def _group(name: str, inner: str, **attributes: Any) -> str:
    told = "".join(f' {key.replace("_", "-")}="{value}"' for key, value in attributes.items())
    return f'<g class="{name}"{told}>{inner}</g>' if inner else ""


class _Labels:
    """Texts beside marks; one that would lie on another is left out."""

    def __init__(self) -> None:
        self._taken: list[tuple[float, float, float, float]] = []

    def beside(self, x: float, y: float, text: str, *, needed: bool = False) -> str:
        """Return the text beside a place: to its right or its left, above or below."""
        wide, bottom = _LETTER * len(text), WIDTH - RIGHT + 12
        for dx, dy in ((7, -5), (-7 - wide, -5), (7, 13), (-7 - wide, 13)):
            box = (x + dx, y + dy - 10, x + dx + wide, y + dy + 2)
            if box[0] < 2 or box[2] > bottom:
                continue
            if not any(_meet(box, other) for other in self._taken):
                return self._put(box, dx + x, dy + y, text)
        if not needed:
            return ""
        left = min(max(2.0, x - wide / 2), bottom - wide)
        return self._put((left, y - 20, left + wide, y - 8), left, y - 10, text)

    def _put(self, box: tuple[float, float, float, float], x: float, y: float, text: str) -> str:
        self._taken.append(box)
        return f'<text x="{x:.1f}" y="{y:.1f}">{escape(text)}</text>'


def _meet(one: tuple[float, ...], other: tuple[float, ...]) -> bool:
    return not (
        one[2] <= other[0] or other[2] <= one[0] or one[3] <= other[1] or other[3] <= one[1]
    )


class _Drawing:
    """One view as SVG."""

    def __init__(self, picture: Picture, frame: Frame, place: Place | None) -> None:
        self.picture = picture
        self.frame = frame
        self.place = place
        self.labels = _Labels()
        self.changes = tool_changes(picture.moved, frame.view, _MOST_CHANGES)
        self.holes = Holes(np.zeros((0, 3)), np.zeros(0), np.zeros(0))
        if frame.view != TURNING:  # what is drilled on a lathe lies along its axis
            self.holes = holes_of(picture.moved, frame.view)

    def svg(self) -> str:
        picture, frame = self.picture, self.frame
        placed = frame.placed(picture.path.points)
        alarm = self._alarm()  # its words come first, and others keep clear of them
        marks = [self._holes(), self._changes(), self._start(placed), alarm]
        lines = "".join(_lines(placed, picture, self.place))
        legend, rows = self._legend(_seen(placed, picture.path))
        inner = "".join([*self._grid(), lines, *marks, legend])
        notes, more = self._notes(frame.height + rows * _LINE)
        return _element(frame.height + (rows + more) * _LINE, self._words(), inner + notes)

    def _notes(self, top: float) -> tuple[str, int]:
        """Return what is left out, where no page around the drawing says it, and its lines."""
        if self.place is not None:
            return "", 0
        letters = int((WIDTH - 12) / _LETTER)
        lines = [line for told in self.picture.path.told for line in textwrap.wrap(told, letters)]
        texts = (
            f'<text x="6" y="{top + row * _LINE + 8:.1f}">{escape(line)}</text>'
            for row, line in enumerate(lines)
        )
        return _group("legend notes", "".join(texts), fill=TEXT), len(lines)

    def _words(self) -> str:
        told = [f"path {self.picture.words(self.frame.view)}"]
        if len(self.holes):
            told.append(_count(len(self.holes), "hole"))
        if self.changes:
            told.append(_count(len(self.changes), "place") + " of tool changes")
        if self.picture.alarm is not None:
            told.append(f"stopped by {_alarm_words(self.picture.alarm)}")
        return ", ".join(told)

    def _grid(self) -> Iterator[str]:
        """Yield the axes with their lines, numbers and names."""
        frame = self.frame
        end, bottom = WIDTH - RIGHT, TOP + frame.inner
        lines: list[str] = []
        zeros: list[str] = []
        texts: list[str] = []
        for tick in frame.ticks(0):
            line = f'<path d="M{tick.at:.1f} {TOP:.1f}V{bottom + 4:.1f}"/>'
            (zeros if tick.text == "0" else lines).append(line)
            texts.append(
                f'<text x="{tick.at:.1f}" y="{bottom + 17:.1f}" text-anchor="middle">{tick.text}'
                "</text>"
            )
        for tick in frame.ticks(1):
            line = f'<path d="M{LEFT - 4:.1f} {tick.at:.1f}H{end:.1f}"/>'
            (zeros if tick.text == "0" else lines).append(line)
            texts.append(
                f'<text x="{LEFT - 7:.1f}" y="{tick.at + 4:.1f}" text-anchor="end">{tick.text}'
                "</text>"
            )
        right, up = frame.names
        texts.append(f'<text x="{end:.1f}" y="{bottom + 33:.1f}" text-anchor="end">{right}</text>')
        texts.append(f'<text x="4" y="13">{up}</text>')
        thin = {"stroke": TEXT, "stroke_width": 1, "vector_effect": "non-scaling-stroke"}
        yield _group("grid", "".join(lines), **thin, stroke_opacity=0.25)
        yield _group("grid zero", "".join(zeros), **thin, stroke_opacity=0.8)
        yield _group("ticks", "".join(texts), fill=TEXT)

    # ---- marks ----

    def _holes(self) -> str:
        holes = self.holes
        if not len(holes):
            return ""
        at = self.frame.placed(holes.at)
        room = (WIDTH - LEFT - RIGHT) * self.frame.inner / len(holes)
        radius = float(np.clip(0.3 * room**0.5, 1.2, 4.5))
        look = {"fill": "none", "stroke": HOLE, "stroke_width": 1.6}
        if len(holes) > _MOST_TOLD:
            dots = "".join(f"M{x:.1f} {y:.1f}h0" for x, y in at.tolist())
            look |= {"stroke_linecap": "round", "stroke_width": round(2 * radius, 1)}
            return _group("holes", f'<path d="{dots}"/>', **look)
        rings, texts = [], []
        for number, (x, y) in enumerate(at.tolist()):
            title = f"<title>{escape(self._hole_words(number))}</title>"
            ring = f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius:.1f}">{title}</circle>'
            rings.append(self._linked(int(holes.first_move[number]), ring))
            if len(holes) <= MOST_NUMBERED:
                texts.append(self.labels.beside(x, y, str(number + 1)))
        numbers = _group("numbers", "".join(texts), fill=TEXT, stroke="none")
        return _group("holes", "".join(rings) + numbers, **look)

    def _linked(self, move: int, inner: str) -> str:
        if self.place is None or not self.picture.linked:
            return inner
        link, _ = self.place(move)
        return f'<a href="{escape(link)}" tabindex="-1">{inner}</a>'

    def _hole_words(self, number: int) -> str:
        holes = self.holes
        told = f"hole {number + 1}: {self._point(holes.at[number])}"
        if (passes := int(holes.passes[number])) > 1:
            told += f", {passes} times"
        if self.place is not None:
            told += f", {self.place(int(holes.first_move[number]))[1]}"
        return told

    def _point(self, at: Iterable[float]) -> str:
        factors = [2.0 if self.picture.path.diameters else 1.0, 1.0, 1.0]
        unit = INCH if self.picture.inch else 1.0
        values = (value * factor / unit for value, factor in zip(at, factors))
        return " ".join(f"{axis}{value + 0.0:.6g}" for axis, value in zip("XYZ", values))

    def _changes(self) -> str:
        marks = []
        for change in self.changes:
            ((x, y),) = self.frame.placed(np.array([change.at])).tolist()
            words = _tools(change)
            title = f"<title>tool change: {words} at {self._point(change.at)}</title>"
            diamond = f"M{x - 5:.1f} {y:.1f}l5 -5l5 5l-5 5z"
            mark = f'<path d="{diamond}" fill="none">{title}</path>'
            text = self.labels.beside(x, y, words)
            marks.append(self._linked(change.move, mark) + _group("numbers", text, stroke="none"))
        return _group(
            "tools", "".join(marks), stroke=TOOL_CHANGE, fill=TOOL_CHANGE, stroke_width=1.6
        )

    def _start(self, placed: Numbers) -> str:
        x, y = placed[0].tolist()
        title = "<title>start of the path</title>"
        square = f'<path d="M{x - 3:.1f} {y - 3:.1f}h6v6h-6z">{title}</path>'
        return _group("start", square, fill="none", stroke=TEXT, stroke_width=1.4)

    def _alarm(self) -> str:
        alarm, at = self.picture.alarm, last_place(self.picture.moved, self.picture.path)
        if alarm is None or at is None:
            return ""
        ((x, y),) = self.frame.placed(np.array([at])).tolist()
        words = _alarm_words(alarm)
        title = f"<title>{escape(words)}: the tool was at {escape(self._point(at))}</title>"
        cross = f"M{x - 6:.1f} {y - 6:.1f}l12 12M{x - 6:.1f} {y + 6:.1f}l12 -12"
        ring = f'<circle cx="{x:.1f}" cy="{y:.1f}" r="9"/>'
        text = self.labels.beside(x + 4, y, words, needed=True)
        label = _group("numbers", text, fill=ALARM, stroke="none", font_weight="bold")
        mark = f'{title}<path d="{cross}"/>{ring}{label}'
        return _group("alarm", mark, fill="none", stroke=ALARM, stroke_width=2.2)

    # ---- the legend ----

    def _legend(self, families: list[int]) -> tuple[str, int]:
        """Return what the lines and marks mean, and how many lines of text that is."""
        x, row = 6.0, 1
        parts = []
        top = self.frame.height - 2
        for mark, words in self._entries(families):
            wide = 26 + _LETTER * len(words) + 14
            if x + wide > WIDTH and x > 6:
                x, row = 6.0, row + 1
            y = top + row * _LINE - 6
            parts.append(
                f'<g transform="translate({x:.1f} {y - 4:.1f})">{mark}</g>'
                f'<text x="{x + 26:.1f}" y="{y:.1f}">{escape(words)}</text>'
            )
            x += wide
        return _group("legend", "".join(parts), fill=TEXT), row

    def _entries(self, families: list[int]) -> Iterator[tuple[str, str]]:
        """Yield what stands in the legend: a mark, and its words."""
        for family in families:
            name = list(FAMILIES)[family]
            yield _group(_class(family), '<path d="M0 0H20"/>', **_stroke(family)), name
        if count := len(self.holes):
            words = "hole, numbered in order" if count <= MOST_NUMBERED else f"{count:,} holes"
            ring = '<circle cx="10" cy="0" r="4.5"/>'
            yield _group("holes", ring, fill="none", stroke=HOLE, stroke_width=1.6), words
        if self.changes:
            mark = '<path d="M5 0l5 -5l5 5l-5 5z"/>'
            yield (
                _group("tools", mark, fill="none", stroke=TOOL_CHANGE, stroke_width=1.6),
                "tool change",
            )
        mark = '<path d="M7 -3h6v6h-6z"/>'
        yield _group("start", mark, fill="none", stroke=TEXT, stroke_width=1.4), "start"
        if self.picture.alarm is not None:
            mark = '<path d="M5 -5l10 10M5 5l10 -10"/>'
            yield _group("alarm", mark, stroke=ALARM, stroke_width=2.2), "stopped by the alarm"


def _count(number: int, what: str) -> str:
    return f"{number:,} {what}{'' if number == 1 else 's'}"


def _tools(change: ToolChange) -> str:
    names = [f"T{tool}" for tool in change.tools]
    if len(names) > _MOST_TOOLS:
        names = [*names[: _MOST_TOOLS - 1], "...", names[-1]]
    return " ".join(names)


def _alarm_words(alarm: Alarm) -> str:
    where = f"line {alarm.line}" if alarm.n is None else f"N{alarm.n}"
    return f"{alarm.number or alarm.cause} at {alarm.program} {where}"


# ---- lines ----


def _class(family: int) -> str:
    return list(FAMILIES)[family].split()[0]


def _stroke(family: int) -> dict[str, Any]:
    dash = {"stroke_dasharray": "5 4"} if family == RAPID else {}
    return {
        "fill": "none",
        "stroke": list(FAMILIES.values())[family],
        "stroke_width": 1 if family == RAPID else 1.8,
        "stroke_linejoin": "round",
        **dash,
    }


def _seen(placed: Numbers, path: Path) -> list[int]:
    """Return the families with a line that is not only a point on the drawing."""
    long = np.abs(np.diff(placed, axis=0)).max(axis=1, initial=0) > 0.5
    found: list[int] = np.unique(path.family[path.moves][1:][long & ~path.begins[1:]]).tolist()
    return found


def _lines(placed: Numbers, picture: Picture, place: Place | None) -> Iterator[str]:
    """Yield the lines of each family: rapid moves lie below the others."""
    path = picture.path
    of_point = path.family[path.moves]
    for family in range(len(FAMILIES)):
        rows = np.flatnonzero((of_point == family) & ~path.begins)
        if not len(rows):
            continue
        if picture.linked and place is not None:
            inner = "".join(_links(placed, rows, path, place))
        else:
            inner = f'<path d="{"".join(_strokes(placed, rows))}"/>'
        yield _group(_class(family), inner, **_stroke(family))


def _links(placed: Numbers, rows: Numbers, path: Path, place: Place) -> Iterator[str]:
    """Yield a line for each motion, which leads to its block."""
    moves = path.moves
    for move, group in itertools.groupby(rows.tolist(), lambda row: int(moves[row])):
        drawn = list(group)
        points = placed[[drawn[0] - 1, *drawn]].tolist()
        ends = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        link, words = place(move)
        yield (
            f'<a href="{escape(link)}" tabindex="-1"><title>{escape(words)}</title>'
            f'<polyline points="{ends}"/></a>'
        )


def _strokes(placed: Numbers, rows: Numbers) -> Iterator[str]:
    """Yield the data of a path along these points; what lies on one tenth of a unit is one."""
    tenths = np.rint(placed * 10).astype(np.int64)
    before = -2
    x = y = 0
    for row in rows.tolist():
        if before != row - 1:
            x, y = tenths[row - 1].tolist()
            yield f"M{x / 10:g} {y / 10:g}"
        before = row
        there = tenths[row].tolist()
        if there != [x, y]:
            x, y = there
            yield f"L{x / 10:g} {y / 10:g}"
