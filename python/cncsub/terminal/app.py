"""The screen of the debugger: what is shown where, and what the keys do."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import ClassVar

from rich.text import Text
from textual.app import App, ComposeResult
from textual.binding import BindingType
from textual.content import Content
from textual.message import Message
from textual.timer import Timer
from textual.widgets import Footer, OptionList, RichLog, Static

from cncsub.debugging import Output, Pause, PlacedPoint, Reason, Session, StackFrame, Value, Written
from cncsub.escapes import shown
from cncsub.terminal import asking
from cncsub.terminal.board import Board
from cncsub.terminal.dialogs import Tell
from cncsub.terminal.facts import Shown, pause_words, shown_of
from cncsub.terminal.keys import bindings, help_text
from cncsub.terminal.panes import Pane

_TICK = 0.2  # s between two looks at a program that runs
_MOST_WRITTEN = 1000  # lines of a movement that are kept for the messages
_MOST_FOUND = 200  # places where a variable was written
# What reads or changes the machine: not while another thread runs it.
_AT_REST = frozenset({
    "move", "to_cursor", "set_next", "back_to_cursor", "restart_frame", "ask", "toggle_point",
    "remove_point", "tell", "follow",
})  # fmt: skip
_FORWARDS = ("into", "over", "out", "to_return", "run")


class DebugApp(App[None]):
    """The debugger of a session. Movements run in a thread of their own, the screen stays alive."""

    CSS_PATH = Path(__file__).with_name("debug.tcss")
    BINDINGS: ClassVar[list[BindingType]] = [*bindings()]
    ENABLE_COMMAND_PALETTE = False

    class Moved(Message):
        """A movement has come to its end."""

        def __init__(self, facts: Shown, fault: str) -> None:
            super().__init__()
            self.facts, self.fault = facts, fault

    class Found(Message):
        """A search has come to its end."""

        def __init__(self, what: str, rows: list[Written], fault: str) -> None:
            super().__init__()
            self.what, self.rows, self.fault = what, rows, fault

    def __init__(self, session: Session, title: str, notes: Sequence[str] = ()) -> None:
        super().__init__()
        self.HORIZONTAL_BREAKPOINTS = [(0, "-narrow"), (70, "-normal"), (110, "-wide")]
        self.VERTICAL_BREAKPOINTS = [(0, "-low"), (18, "-high"), (32, "-tall")]
        self.session = session
        self.board = Board(self, session)
        self._heading, self._notes = title, notes
        self.frame = 0  # the call whose source and locals are shown
        self.moving = ""  # what is being done, in words; empty at rest
        self._began, self._ran, self._left = 0.0, 0, False
        self._ticking: Timer | None = None
        self._foot_is_of_moving = False  # the foot of the screen shows what may be done meanwhile
        self._written: deque[Output] = deque(maxlen=_MOST_WRITTEN)
        self._lines = 0  # that were written since they were shown
        session.output = self._on_output
        session.progress = self._on_progress

    # ---- the screen ----

    def compose(self) -> ComposeResult:
        yield Static(Content.styled(shown(self._heading), "bold"), id="head", markup=False)
        yield from self.board.compose()
        yield Static("", id="status", markup=False)
        yield Footer(show_command_palette=False, compact=True)

    def on_mount(self) -> None:
        for line in self._notes:
            self.write(line)
        self.board.choose("variables")
        self.board.source.focus()
        self._show(shown_of(self.session))

    def on_unmount(self) -> None:
        """Leave no thread behind: what runs is paused, however the screen came to its end."""
        if self.moving:
            self.session.pause()

    def write(self, line: str, style: str = "") -> None:
        """Write a line among the messages."""
        self.query_one("#messages", RichLog).write(Text(shown(line), style))

    def tell(self, words: str, *, wrong: bool = False) -> None:
        """Show a line at the foot of the screen."""
        status = self.query_one("#status", Static)
        status.set_class(wrong, "-wrong")
        status.update(Content(shown(words.partition("\n")[0])))

    def look_again(self) -> None:
        """Show the state after something was set."""
        self._show(shown_of(self.session))

    def _show(self, facts: Shown) -> None:
        self.board.show(facts, self.frame)
        self.screen_stack[0].set_class(facts.alarm is not None, "-alarm")
        stopped = facts.pause.reason in (Reason.ALARM, Reason.LIMIT, Reason.WAITING)
        self.tell(pause_words(facts), wrong=stopped)

    # ---- movements ----

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Say whether an action may be done now; `None` shows its key as one that does nothing."""
        if action == "pause":
            return True if self.moving else None
        return None if self.moving and action in _AT_REST else True

    def move(self, movement: Callable[[], object], words: str) -> None:
        """Do a movement of the session in another thread."""
        self._begin(words)
        self.run_worker(partial(self._moves, movement), thread=True, exit_on_error=True)

    def _begin(self, words: str) -> None:
        self.moving, self._began, self._ran = words, time.monotonic(), 0
        self._ticking = self.set_interval(_TICK, self._tick)

    def _moves(self, movement: Callable[[], object]) -> None:
        def moves() -> str:
            movement()
            return ""

        fault = asking.answered(moves)
        self.post_message(self.Moved(shown_of(self.session), fault.text if fault.wrong else ""))

    def _rest(self) -> None:
        if self._ticking is not None:
            self._ticking.stop()
        self.moving = ""
        if self._foot_is_of_moving:
            self._foot_is_of_moving = False
            self.refresh_bindings()
        self._write_output()
        if self._left:
            self.exit()

    def on_debug_app_moved(self, event: Moved) -> None:
        self._rest()
        self.frame = 0
        for line in event.facts.told:
            self.write(line, "bold red" if line.startswith("stopped: alarm") else "")
        self._show(event.facts)
        if event.fault:
            self.tell(event.fault, wrong=True)

    def _tick(self) -> None:
        if not self._foot_is_of_moving:  # a step is over before anybody reads the foot
            self._foot_is_of_moving = True
            self.refresh_bindings()
        self.session.tick()
        self._write_output()
        seconds = time.monotonic() - self._began
        blocks = f", {self._ran:,} blocks" if self._ran else ""
        self.tell(f"{self.moving}: {seconds:.0f} s{blocks}; p pauses")

    def _on_progress(self, blocks: int) -> None:
        self._ran = blocks

    def _on_output(self, output: Output) -> None:  # in the thread of the movement
        self._written.append(output)
        self._lines += 1

    def _write_output(self) -> None:
        lines, self._lines = self._lines, 0
        if (lost := lines - len(self._written)) > 0:
            self.write(f"... {lost:,} lines before; cncsub run prints them all")
        while self._written:
            output = self._written.popleft()
            place = f"{output.file}:{output.line}: " if output.line else ""
            self.write(f"{place}{output.text}" if output.kind == "log" else
                       f"message: {output.text}")  # fmt: skip

    # ---- what the keys do ----

    def action_move(self, name: str) -> None:
        movement: Callable[[], Pause] = getattr(self.session, name)
        self.move(movement, "running" if name in _FORWARDS else "going back")

    def action_to_cursor(self) -> None:
        self.move(partial(asking.run_to, self.session, self.board.place_of_cursor()), "running")

    def action_set_next(self) -> None:
        place = self.board.place_of_cursor()
        answer = asking.answered(lambda: self.session.goto(place).text)
        if answer.wrong:
            self.tell(answer.text, wrong=True)
            return
        self.frame = 0
        self.look_again()
        self.tell(f"{place}: {answer.text}")

    def action_back_to_cursor(self) -> None:
        self.go_back_to(self.board.place_of_cursor())

    def go_back_to(self, to: int | str) -> None:
        self.move(partial(self.session.back_to, to), "going back")

    def action_restart_frame(self) -> None:
        self.move(partial(self.session.restart_frame, self.frame), "going back")

    def action_pause(self) -> None:
        self.session.pause()

    def action_ask(self, name: str) -> None:
        self.push_screen(asking.ASKING[name](self), self._answered)

    def _answered(self, told: str | None) -> None:
        if told:
            self.tell(told)

    def action_toggle_point(self) -> None:
        answer = asking.toggle(self, self.board.place_of_cursor())
        self.tell(answer.text, wrong=answer.wrong)

    def action_remove_point(self) -> None:
        chosen = self.board.points.chosen
        if isinstance(chosen, PlacedPoint) and self.focused is self.board.points:
            asking.remove_point(self, chosen)
        else:
            self.tell("choose a breakpoint in pane 4 first", wrong=True)

    def action_tell(self) -> None:
        title, text = asking.known_of(self)
        self.push_screen(Tell(title, text))

    def action_pane(self, name: str) -> None:
        self.board.choose(name)
        self.query_one(f"#{name}").focus()

    def action_follow(self) -> None:
        self.frame = 0
        self.board.show_frame(0)
        self.board.source.focus()

    def action_dark(self) -> None:
        self.theme = "textual-light" if self.current_theme.dark else "textual-dark"

    def action_help(self) -> None:
        self.push_screen(Tell("Keys", help_text()))

    async def action_quit(self) -> None:
        """Leave; a program that runs is paused first. Asked twice, do not wait for it."""
        if self.moving and not self._left:
            self._left = True
            self.session.pause()
            return
        self.exit()

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        """Do what Enter does in a list: show a call, set a value, change a breakpoint."""
        chosen = event.option_list.chosen if isinstance(event.option_list, Pane) else None
        if self.moving or chosen is None:
            return
        if isinstance(chosen, StackFrame):
            self.frame = chosen.index
            self.board.show_frame(chosen.index)
        elif isinstance(chosen, Value):
            self.push_screen(asking.ask_set(self, chosen), self._answered)
        elif isinstance(chosen, PlacedPoint):
            self.push_screen(asking.ask_point(self, chosen), self._answered)

    # ---- searches ----

    def search(self, what: str) -> None:
        """Look for the blocks that gave something another value, and offer them."""
        self._begin("searching")
        self.run_worker(partial(self._searches, what), thread=True, exit_on_error=True)

    def _searches(self, what: str) -> None:
        rows: list[Written] = []

        def look() -> str:
            rows.extend(self.session.search(what, _MOST_FOUND))
            return ""

        fault = asking.answered(look)
        self.post_message(self.Found(what, rows, fault.text if fault.wrong else ""))

    def on_debug_app_found(self, event: Found) -> None:
        self._rest()
        if event.fault or not event.rows:
            nobody = f"no block so far gave {event.what} another value"
            self.tell(event.fault or nobody, wrong=True)
            return
        self.tell(f"{event.what} got another value in {len(event.rows)} blocks")
        self.push_screen(asking.choose_written(self, event.what, event.rows))
