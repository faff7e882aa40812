"""The panes of the screen: which there are, and what a pause shows in them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from textual.app import ComposeResult
from textual.containers import Horizontal, Vertical
from textual.widgets import RichLog, Static

from cncsub import _core
from cncsub.debugging import Session, StackFrame, Value
from cncsub.debugging.scopes import MODAL_SCOPES
from cncsub.program import Block, Program
from cncsub.terminal.facts import AlarmPlace, Shown, scopes_of
from cncsub.terminal.panes import (
    Pane,
    PathPane,
    call_rows,
    point_mark,
    point_rows,
    position_text,
    value_rows,
)
from cncsub.terminal.source import SourceView, source_of

if TYPE_CHECKING:
    from textual.app import App

_RIGHT = ("variables", "modes", "path", "points")


class Board:
    """The panes, filled from what is known of a session at a pause."""

    def __init__(self, app: App[None], session: Session) -> None:
        self._app, self._session = app, session
        self.source = SourceView(id="source")
        self.calls = Pane(id="calls", title="5 calls")
        self.variables = Pane(id="variables", title="1 variables")
        self.modes = Pane(id="modes", title="2 modes")
        self.path = PathPane(id="path")
        self.points = Pane(id="points", title="4 breakpoints")
        self.messages = RichLog(id="messages", classes="pane", wrap=True, min_width=20,
                                max_lines=5000)  # fmt: skip
        self.messages.border_title = "6 messages"
        self.position = Static("", id="position", markup=False)
        self.position.border_title = "position"
        self._frames: tuple[StackFrame, ...] = ()
        self._alarm: AlarmPlace | None = None
        self._here: Block | None = None

    def compose(self) -> ComposeResult:
        with Horizontal(id="body"):
            with Vertical(id="left"):
                yield self.source
                yield self.calls
                yield self.messages
            with Vertical(id="right"):
                yield self.position
                with Vertical(id="panes"):
                    yield self.variables
                    yield self.modes
                    yield self.path
                    yield self.points

    def choose(self, name: str) -> None:
        """Show a pane; where there is room for one only, instead of the others."""
        for pane in self._app.query(".pane"):
            pane.set_class(pane.id == name, "-chosen")
            if name in _RIGHT:
                pane.set_class(pane.id == name, "-picked")
        self._app.screen_stack[0].set_class(name in _RIGHT, "-right")

    # ---- what a pause shows ----

    def show(self, facts: Shown, frame: int) -> None:
        self._frames, self._alarm = facts.frames, facts.alarm
        self._here = self._session.next
        self.calls.fill(call_rows(facts.frames))
        self.path.show(facts)
        self.show_points()
        self.show_frame(min(frame, len(facts.frames) - 1))

    def show_frame(self, index: int) -> None:
        """Show the source of a call that is open, and the values as its program sees them."""
        frame = self._frames[index]
        self.show_values(index)
        self.calls.highlighted = index
        if frame.block is None:
            return
        self.show_program(frame.block.program, frame.block.line)

    def show_values(self, index: int) -> None:
        scopes = scopes_of(self._session, index)
        self.position.update(position_text(scopes.pop("position", None)))
        modes = [scopes.pop(name) for name in (*MODAL_SCOPES, "switches") if name in scopes]
        self.modes.fill(value_rows(modes))
        self.variables.fill(value_rows(scopes.values()))

    def show_program(self, program: Program, line: int) -> None:
        """Show the file of a program, with the cursor on a line."""
        shown_file = self.source.text
        there = any(each.index == program.index for each in shown_file.programs)
        if not there:
            self.source.load(source_of(self._session.machine.core.code, program))
        self.source.show_title(program)
        self._mark()
        self.source.go(line)

    def _mark(self) -> None:
        """Mark the lines of the source that is shown."""
        programs = {each.index for each in self.source.text.programs}
        running = [
            (place, each.block)
            for place, each in enumerate(self._frames)
            if each.block is not None and each.block.program.index in programs
        ]
        lines = {block.line: place > 0 for place, block in reversed(running)}
        if self._here is None:  # what ran last does not run next
            lines = {line: caller for line, caller in lines.items() if caller}
        points = {
            each.block.line: point_mark(each)
            for each in self._session.points.placed
            if each.block is not None and each.block.program.index in programs
        }
        self.source.mark(lines, points, self._alarm)

    def show_points(self) -> None:
        """Show the breakpoints, in their list and beside the lines."""
        self.points.fill(point_rows(self._session.points.placed))
        self._mark()

    # ---- what is pointed at ----

    def place_of_cursor(self) -> str:
        return f"{self.source.text.file}:{self.source.cursor}"

    @property
    def chosen_value(self) -> Value | None:
        """The value that is highlighted in the list that has the focus."""
        pane = self._app.focused
        chosen = pane.chosen if isinstance(pane, Pane) else None
        return chosen if isinstance(chosen, Value) else None

    def watched_place(self) -> str:
        """Return the event that a watchpoint means on what is chosen."""
        value = self.chosen_value
        if value is None:
            return "passes Z " if self._app.focused is self.path else "changes "
        if self._app.focused is self.modes:
            return f"mode {value.expression}" if value.expression in _core.mode_names() else "mode"
        return f"changes {value.expression}"
