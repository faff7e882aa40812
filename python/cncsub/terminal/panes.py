"""The panes beside the source: calls, values, path, breakpoints, drawn from what they are given."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import plotille
from rich.text import Text
from textual.content import Content
from textual.geometry import Size
from textual.widget import Widget
from textual.widgets import OptionList
from textual.widgets.option_list import Option

from cncsub.debugging import PausePoint, PlacedPoint, Scope, StackFrame, Value
from cncsub.drawing.path import RAPID, Path
from cncsub.escapes import shown
from cncsub.number_text import length_text
from cncsub.terminal.facts import Shown, place_of

_MOST_VALUES = 2000  # of a group
_MOST_PARTS = 200  # of an array
_TOOL = "+"
_BLANKS = (" ", "\u2800")
_NAME = 14  # columns of a name, at most


class Pane(OptionList):
    """A list whose rows stand for something: `chosen` is what the highlighted row stands for."""

    def __init__(self, *, id: str, title: str) -> None:
        super().__init__(id=id, classes="pane", markup=False, compact=True)
        self.border_title = title
        self._stands_for: list[object] = []

    def fill(self, rows: Iterable[tuple[Content, object]]) -> None:
        """Replace the rows; one that stands for nothing is a heading. The highlight stays."""
        kept, top = self.highlighted, self.scroll_offset.y
        listed = list(rows)
        self._stands_for = [of for _, of in listed]
        self.clear_options()
        self.add_options([Option(text, disabled=of is None) for text, of in listed])
        if kept is not None and kept < len(listed) and self._stands_for[kept] is not None:
            self.highlighted = kept
            self.scroll_to(y=top, animate=False)

    @property
    def chosen(self) -> object:
        at = self.highlighted
        return None if at is None or at >= len(self._stands_for) else self._stands_for[at]


# ---- values ----


def value_rows(scopes: Iterable[Scope]) -> Iterator[tuple[Content, object]]:
    """Yield the rows of groups of values: `*` stands before what is another one than at the last
    pause.
    """
    for scope in scopes:
        yield Content.styled(shown(scope.name), "bold $text-muted"), None
        names = [value.name for value in scope.values[:_MOST_VALUES]]
        width = min(_NAME, max(map(len, names), default=0))
        for value in scope.values[:_MOST_VALUES]:
            yield _value_row(value, width), value
            for part in value.parts[:_MOST_PARTS]:
                yield _value_row(part, width, "  "), part
        if (left := len(scope.values) - _MOST_VALUES) > 0:
            yield Content(f"... {left:,} more"), None


def _value_row(value: Value, width: int, indent: str = "") -> Content:
    mark = "* " if value.changed else "  "
    style = "bold $text-warning" if value.changed else ""
    name = shown(value.name).ljust(width)
    return Content.assemble(
        (f"{mark}{indent}", style), (name, "$text-primary"), " ", (shown(value.text), style)
    )


def position_text(scope: Scope | None) -> Content:
    """Return the axes with their work and machine coordinates, each axis on a line."""
    values = {} if scope is None else {value.name: value for value in scope.values}
    machine = " (machine)"
    axes = list(dict.fromkeys(name.removesuffix(machine) for name in values))
    lines = [Content.styled(f"   {'work':>11} {'machine':>11}", "$text-muted")]
    for axis in axes:
        work, there = values.get(axis), values.get(axis + machine)
        numbers = f"{_number(work):>11} {_number(there):>11}"
        changed = any(each is not None and each.changed for each in (work, there))
        style = "bold $text-warning" if changed else ""
        lines.append(Content.styled(f"{'*' if changed else ' '}{shown(axis)} {numbers}", style))
    return Content("\n").join(lines)


def _number(value: Value | None) -> str:
    return "" if value is None else value.text


# ---- calls and breakpoints ----


def call_rows(frames: Sequence[StackFrame]) -> Iterator[tuple[Content, object]]:
    """Yield the programs that run, the innermost first, each with its pass and arguments."""
    for frame in frames:
        kind = f"{frame.kind} " if frame.kind else ""
        words = frame.title.removeprefix(frame.program)
        place = place_of(frame).removeprefix(frame.program)
        yield (
            Content.assemble(
                (shown(kind), "$text-muted"), (shown(frame.program), "$text-primary"),
                shown(place), (shown(words), "$text-muted"),
            ),
            frame,
        )  # fmt: skip


def point_rows(placed: Iterable[PlacedPoint]) -> Iterator[tuple[Content, object]]:
    for each in placed:
        words = point_text(each.point)
        if each.refused:
            words += f": {each.refused.splitlines()[0]}"
        yield Content.assemble((point_mark(each), "$text-error"), f" {shown(words)}"), each


def point_mark(placed: PlacedPoint) -> str:
    """Return the mark of a point: refused, a log, with a condition, or neither."""
    if placed.refused:
        return "x"
    if placed.point.log is not None:
        return "◆"
    return "◉" if placed.point.when or placed.point.hits else "●"


def point_text(point: PausePoint) -> str:
    """Return a point on one line: its place, its condition, its count, its text."""
    words = point.at if isinstance(point.at, str) else str(point.at)
    words += f" when {point.when}" if point.when else ""
    words += f", hits {point.hits}" if point.hits else ""
    return words + (f", writes {point.log}" if point.log is not None else "")


# ---- path ----


class PathPane(Widget, can_focus=True):
    """The last moves, drawn with braille dots and listed below."""

    def __init__(self, *, id: str) -> None:
        super().__init__(id=id, classes="pane")
        self.border_title = "3 path"
        self._shown: Shown | None = None

    def show(self, facts: Shown) -> None:
        self._shown = facts
        self.refresh()

    def render(self) -> Text:
        facts, size = self._shown, self.content_size
        if facts is None or facts.path is None or not len(facts.path.points):
            return Text("nothing has moved", style="dim")
        if size.width < 4 or size.height < 2:
            return Text("")
        listed = facts.moves[-min(4, size.height // 3) :] if size.height >= 6 else ()
        words = [_view_words(facts.path)]
        if facts.left_out:
            words.append(f"without the first {facts.left_out:,} moves")
        room = Size(size.width, size.height - len(listed) - len(words))
        told = [Text(each[: size.width], style="dim") for each in words]
        lines = [told[0], drawing(facts.path, room), *told[1:]]
        lines += [Text(shown(each)[: size.width]) for each in listed]
        text = Text("\n").join(lines)
        text.no_wrap = True
        return text


def _view_words(path: Path) -> str:
    right, up = path.view.letters()
    wide, high = (path.extents[axis] for axis in (path.view.right, path.view.up))
    size = f"{right} {length_text(round(wide, 3))} by {up} {length_text(round(high, 3))}"
    return f"{path.view.name}, {size}"


def drawing(path: Path, room: Size) -> Text:
    """Return a path drawn in so many columns and rows, rapid moves dimmed, the tool as a plus."""
    if room.width < 2 or room.height < 1:
        return Text("")
    flat = path.points[:, (path.view.right, path.view.up)]
    low, high = flat.min(axis=0), flat.max(axis=0)
    dots = (2 * room.width - 1, 4 * room.height - 1)
    scale = max(float((high - low)[i]) / dots[i] for i in (0, 1)) or 1.0  # mm of a dot
    # What is narrow lies in the middle.
    spare = [dots[i] * scale - float((high - low)[i]) for i in (0, 1)]
    left, below = (float(low[i]) - spare[i] / 2 for i in (0, 1))
    right, top = left + (dots[0] + 1) * scale, below + (dots[1] + 1) * scale
    every, cuts = (
        plotille.Canvas(room.width, room.height, left, below, right, top) for _ in range(2)
    )
    points = [(float(x), float(y)) for x, y in flat]
    rapid = path.family == RAPID
    for i in range(1, len(points)):
        if not path.begins[i]:
            every.line(*points[i - 1], *points[i])
            if not rapid[path.moves[i]]:
                cuts.line(*points[i - 1], *points[i])
    every.text(*points[-1], _TOOL)
    return _in_two_colours(every.plot(), cuts.plot())


def _in_two_colours(every: str, cuts: str) -> Text:
    """Return a drawing in which the letters are bright where another one has dots."""
    text = Text()
    for mark, cut in zip(every, cuts):
        style = "bold red" if mark == _TOOL else "dim" if cut in _BLANKS else "bold cyan"
        text.append(" " if mark in _BLANKS else mark, style)
    return text
