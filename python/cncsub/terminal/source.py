"""The source of a file: its lines, the next block, breakpoints and the place of an alarm."""

from __future__ import annotations

import bisect
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import ClassVar

from rich.cells import cell_len
from rich.segment import Segment
from rich.style import Style
from rich.text import Text
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.geometry import Size
from textual.reactive import reactive
from textual.scroll_view import ScrollView
from textual.strip import Strip

from cncsub import _core
from cncsub.debugging.points import blocks_between, programs_of
from cncsub.escapes import shown
from cncsub.lines import lines_of, without_end
from cncsub.program import Block, Program
from cncsub.terminal.facts import AlarmPlace

_NESTED = 50  # programs that begin inside of another one before its next block


@dataclass(slots=True)
class SourceText:
    """The lines of a file and the programs in it, by the line on which they begin."""

    file: str = ""
    lines: list[str] = field(default_factory=list)
    programs: list[Program] = field(default_factory=list)

    def blocks_on(self, line: int) -> Iterator[Block]:
        """Yield the blocks that begin on a line, which is counted from 1."""
        at = bisect.bisect_right(self.programs, line, key=lambda program: program.line)
        for program in reversed(self.programs[max(0, at - _NESTED) : at]):
            if blocks := blocks_between(program, line, line):
                yield from blocks
                return


def source_of(code: _core.Code, program: Program) -> SourceText:
    """Return the file in which a program stands. A program of the control itself stands alone."""
    alone = program.data.system
    same = [p for p in programs_of(code, program.file) if not p.data.system]
    programs = [program] if alone else sorted(same, key=lambda each: each.line)
    lines = [] if alone else _lines_before(code, programs[0])
    for each in programs:
        if each.data.inside and not alone:
            continue  # its lines are those of the program around it
        lines += [""] * (each.line - 1 - len(lines))
        lines += [shown(without_end(line)) for line in lines_of(each.text)]
    return SourceText(program.file, lines, programs)


def _lines_before(code: _core.Code, program: Program) -> list[str]:
    """Return the lines of a file before its first program: comments, and what is left out."""
    if program.line == 1:
        return []
    _, begin, _ = program.data.span
    text = next((of for name, _, of, _ in code.sources if name == program.file), b"")
    before = lines_of(text[:begin].decode("utf-8", "replace"))
    return [shown(without_end(line)) for line in before][: program.line - 1]


class SourceView(ScrollView, can_focus=True):
    """Draws the lines that are seen; the file may be long."""

    COMPONENT_CLASSES: ClassVar[set[str]] = {
        "source--number", "source--next", "source--caller", "source--cursor", "source--point",
        "source--alarm", "source--comment", "source--macro",
    }  # fmt: skip
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("up,k", "cursor(-1)", show=False),
        Binding("down,j", "cursor(1)", show=False),
        Binding("pageup", "page(-1)", show=False),
        Binding("pagedown", "page(1)", show=False),
        Binding("home", "to_end(False)", show=False),
        Binding("end", "to_end(True)", show=False),
    ]
    cursor = reactive(1)  # the line of the cursor, from 1

    def __init__(self, *, id: str) -> None:
        super().__init__(id=id)
        self.text = SourceText()
        self.running: Mapping[int, bool] = {}  # the lines that run, and whether each is a caller
        self.points: Mapping[int, str] = {}
        self.alarm: AlarmPlace | None = None
        self._named = "", ""  # the program and its file

    # ---- what is shown ----

    def load(self, text: SourceText) -> None:
        self.text = text
        longest = max((_width(line) for line in text.lines), default=0)
        self.virtual_size = Size(longest + self._gutter, max(1, len(text.lines)))
        self.set_reactive(SourceView.cursor, 1)
        self.scroll_to(0, 0, animate=False)
        self.refresh()

    def mark(
        self, running: Mapping[int, bool], points: Mapping[int, str], alarm: AlarmPlace | None
    ) -> None:
        """Mark the lines that run, each with whether it is that of a caller; the breakpoints; the
        alarm.
        """
        self.running, self.points = running, points
        self.alarm = alarm if alarm is not None and alarm.file == self.text.file else None
        self.refresh()

    def show_title(self, program: Program) -> None:
        self._named = shown(program.name), shown(program.file or "")
        self._fit_title()

    def _fit_title(self) -> None:
        """Write the program and its file over the source: of a path that is too long, the end."""
        name, file = self._named
        room = self.size.width - cell_len(name) - 6  # two blanks, and what frames a title
        if room > 0 and cell_len(file) > room:
            file = "…" + right_crop(file, room - 1)
        self.border_title = Content(f"{name}  {file}".rstrip())

    def go(self, line: int) -> None:
        """Put the cursor on a line, and show it."""
        self.cursor = line
        self._see_cursor()

    def validate_cursor(self, line: int) -> int:
        return max(1, min(line, len(self.text.lines)))

    def watch_cursor(self) -> None:
        self._see_cursor()
        self.refresh()

    def _see_cursor(self) -> None:
        height = self.scrollable_content_region.height
        margin = min(3, max(0, (height - 1) // 2))
        top, line = self.scroll_offset.y, self.cursor - 1
        if not top + margin <= line < top + height - margin:
            self.scroll_to(y=max(0, line - height // 2), animate=False, immediate=True)

    def on_resize(self) -> None:
        self._fit_title()
        self._see_cursor()

    def action_cursor(self, lines: int) -> None:
        self.cursor += lines

    def action_page(self, pages: int) -> None:
        self.cursor += pages * max(1, self.scrollable_content_region.height - 1)

    def action_to_end(self, end: bool) -> None:
        self.cursor = len(self.text.lines) if end else 1

    def on_click(self, event: object) -> None:
        offset = getattr(event, "y", 0)
        self.cursor = self.scroll_offset.y + offset + 1

    # ---- how it is drawn ----

    @property
    def _digits(self) -> int:
        return len(str(max(1, len(self.text.lines))))

    @property
    def _gutter(self) -> int:
        return self._digits + 4

    def render_line(self, y: int) -> Strip:
        width = self.scrollable_content_region.width
        line = y + self.scroll_offset.y + 1
        if line > len(self.text.lines):
            return Strip.blank(width, self.rich_style)
        text = self._line(line)
        background = self.rich_style
        if (is_caller := self.running.get(line)) is not None:
            name = "source--caller" if is_caller else "source--next"
            background = self.get_component_rich_style(name)
        elif line == self.cursor and self.has_focus:
            background = self.get_component_rich_style("source--cursor")
        code = Strip(text.render(self.app.console), text.cell_len)
        end = max(0, self.scroll_offset.x + width - self._gutter)
        if text.cell_len > end > self.scroll_offset.x:  # it goes on to the right
            more = Segment("…", self._style("source--number"))
            code = Strip([*code.crop_extend(self.scroll_offset.x, end - 1, None), more])
        else:
            code = code.crop_extend(self.scroll_offset.x, end, None)
        return Strip([*self._marks(line), *code]).apply_style(background).simplify()

    def _marks(self, line: int) -> list[Segment]:
        """Return the gutter: breakpoint, number of the line, next block or cursor."""
        at = "!" if self.alarm is not None and self.alarm.line == line else " "
        at = self.points.get(line, at)
        style = "source--alarm" if at == "!" else "source--point"
        arrows = {True: "▷", False: "▶", None: "›" if line == self.cursor else " "}
        pointer = arrows[self.running.get(line)]
        return [
            Segment(at, self._style(style)),
            Segment(f"{line:>{self._digits}} ", self._style("source--number")),
            Segment(f"{pointer} ", self._style("source--point")),
        ]

    def _line(self, line: int) -> Text:
        text = Text(self.text.lines[line - 1], end="", no_wrap=True)
        for block in self.text.blocks_on(line):
            for token in block.tokens:
                macro = token.word is not None and not token.word.address
                name = "source--comment" if token.kind != "word" else "source--macro"
                if token.kind == "comment" or token.kind == "ignored" or macro:
                    text.stylize(self._style(name), token.column - 1, token.end - 1)
        alarm = self.alarm
        if alarm is not None and alarm.line == line:
            end = alarm.column - 1 + alarm.width
            text.stylize(self._style("source--alarm"), alarm.column - 1, end)
        return text

    def _style(self, name: str) -> Style:
        """Return the ink of a part, which lies on the background of its line."""
        whole = self.get_component_rich_style(name)
        background = whole.bgcolor if name == "source--alarm" else None
        return Style(
            color=whole.color, bgcolor=background, bold=whole.bold, underline=whole.underline
        )


def right_crop(text: str, width: int) -> str:
    """Return the end of a text that fits into so many columns."""
    while text and cell_len(text) > width:
        text = text[1:]
    return text


def _width(line: str) -> int:
    return len(line) if line.isascii() else cell_len(line)
