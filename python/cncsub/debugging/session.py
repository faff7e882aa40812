"""A debugging session: one program that is run, paused, looked at and taken back."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from typing import Unpack

from cncsub.breakpoints import At
from cncsub.debugging import help as helping
from cncsub.debugging import values
from cncsub.debugging.frames import StackFrame, frame_at, frames_of, level_opener
from cncsub.debugging.pauses import Output, Pause, Reason
from cncsub.debugging.points import (
    ArmedPoint,
    PausePoint,
    PausePoints,
    PlacedPoint,
    log_pieces,
)
from cncsub.debugging.running import name_of, run_to, standing_at, step_over_back
from cncsub.debugging.scopes import Scope, StateFacts
from cncsub.library import Library
from cncsub.machine import Machine, type_in
from cncsub.program import Block
from cncsub.run import Stop
from cncsub.run_options import RunOptions

_ANY_DEPTH = 1 << 30
_STOPS = {
    Stop.ALARM: Reason.ALARM,
    Stop.WAITING: Reason.WAITING,
    Stop.LIMIT: Reason.LIMIT,
    Stop.INTERRUPTED: Reason.PAUSE,
}


class Session:
    """One program that runs under a debugger. Every movement returns a `Pause`, which is `.at` too.

    >>> import cncsub
    >>> from cncsub.debugging import PausePoint, Session
    >>> text = "O1\\nN10 G65 P2 A7.\\nN20 M30\\nO2\\nN30 #100=#1\\nN40 M99\\n"
    >>> session = Session(cncsub.loads({"part.nc": text}, control="fanuc-0i-f"))
    >>> session.start().reason, session.next.text
    (<Reason.ENTRY: 'entry'>, 'N10 G65 P2 A7.')
    >>> session.set_points("lines", [PausePoint("part.nc:6")])[0].block.n
    40
    >>> session.run().text
    'breakpoint part.nc:6'
    >>> [(value.name, value.text) for value in session.scopes()[0].values]
    [('#1 (A)', '7')]
    >>> session.out().reason, session.next.n
    (<Reason.STEP: 'step'>, 20)
    >>> session.back().text, session.next.n
    ('one block back', 40)
    """

    def __init__(
        self, library: Library, main: str | int | None = None, **options: Unpack[RunOptions]
    ) -> None:
        """Raises what `library.machine` raises."""
        self._begin: Callable[[], Machine] = lambda: library.machine(main, **options)
        self.library = library
        self.machine = self._begin()
        self.points = PausePoints(self.machine.core)
        self.pauses_at_alarm: Callable[[str, str], bool] = lambda number, cause: True
        self.output: Callable[[Output], None] | None = None  # told at once what is written
        self._written: list[Output] = []
        self.progress: Callable[[int], None] = lambda blocks: None  # told at each tick
        self._told = 0  # of the messages
        self._facts = StateFacts(self.machine)
        self._asked, self._ticked = threading.Event(), threading.Event()
        self._searching: Machine | None = None  # a copy that looks for something in the past
        self.at = Pause(Reason.ENTRY, "before the first block")

    # ---- where it stands ----

    @property
    def next(self) -> Block | None:
        """The block that runs next, `None` at the end."""
        return self.machine.next

    @property
    def ended(self) -> bool:
        """Whether no block can run any more from here."""
        return self.machine.stop not in (None, Stop.INTERRUPTED)

    def frames(self) -> list[StackFrame]:
        """The programs that run, the innermost first."""
        return frames_of(self.machine)

    def frame(self, index: int = 0) -> StackFrame:
        """Return one of them. Raises `ValueError` where there is none of this index."""
        return frame_at(self.frames(), index)

    def level_opener(self, frame: int = 0) -> int:
        """Return the call that opened the level of a program's locals, -1 for the main program's:
        `PausePoint.call` means it.
        """
        frames = self.frames()
        return level_opener(frame_at(frames, frame), frames)

    def scopes(self, frame: int = 0) -> list[Scope]:
        """Return what the machine holds, as a program that runs sees it, in groups."""
        frames = self.frames()
        return self._facts.scopes(frames, frame_at(frames, frame))

    # ---- breakpoints ----

    def set_points(self, name: str, points: Sequence[PausePoint]) -> list[PlacedPoint]:
        """Replace the set of points of a name, and return them as they are placed. Of each that
        cannot be, `refused` says why.
        """
        return self.points.place(name, points)

    def toggle(self, at: At) -> PlacedPoint | None:
        """Set a point at a place, or take it away where one stands. Return it where it is set."""
        mine = [each.point for each in self.points.placed_in("toggled")]
        if any(point.at == at for point in mine):
            self.set_points("toggled", [point for point in mine if point.at != at])
            return None
        return self.set_points("toggled", [*mine, PausePoint(at)])[-1]

    # ---- forwards ----

    def start(self) -> Pause:
        """Stand before the first block, as after power-on; breakpoints stay."""
        self.machine = self._begin()
        self.points.move_to(self.machine.core)
        self._facts = StateFacts(self.machine)
        self._told = 0
        self._written = []
        return self._paused(Reason.ENTRY, "before the first block")

    def into(self) -> Pause:
        """Run one block; of a call, pause before the first block of what is called."""
        return self._go(_ANY_DEPTH, "one block")

    def over(self) -> Pause:
        """Run one block, and what it calls with all passes."""
        return self._go(len(self.machine.stack), "one block")

    def out(self) -> Pause:
        """Run until the program that runs has returned with all its passes, or to the end."""
        return self._go(len(self.machine.stack) - 1, "returned")

    def to_return(self) -> Pause:
        """Run to the block that leaves the program that runs; of several passes, in the last."""
        depth = len(self.machine.stack)
        before = self.machine.blocks
        pause = self._go(depth - 1, "before the return")
        if pause.reason in (Reason.STEP, Reason.END) and self.machine.blocks > before + 1:
            try:
                self._go_back(self.machine.blocks - 1)
            except InterruptedError as stopped:
                return self._stayed(stopped)
            return self._paused(Reason.STEP, "before the return", output=pause.output)
        return pause

    def run(self, *, here: bool = False) -> Pause:
        """Run to the next breakpoint, or to the end. `here`: whether a breakpoint at the block
        where it stands counts, as it does where the user has not seen this place yet.
        """
        if here and (pausing := self._count(standing_at(self.machine, self.points))):
            return self._at_points(pausing)
        return self._go(None, "")

    def pause(self) -> None:
        """Make the movement or the search that another thread is at come to an end soon. It returns
        a `Pause` of the reason `PAUSE`, or raises `InterruptedError`.
        """
        if not self.stop_search():
            self._asked.set()
            self.machine.pause()

    def stop_search(self) -> bool:
        """Make a search that another thread is at come to an end. Return whether there was one."""
        if (searching := self._searching) is None:
            return False
        searching.pause()
        return True

    def tick(self) -> None:
        """Have the movement that another thread is at write its messages, tell its `progress` and
        go on.
        """
        self._ticked.set()
        self.machine.core.pause(False)

    # ---- back ----

    def back(self) -> Pause:
        """Go back one block. At the head of the program it stays there."""
        return self._back_to(self.machine.blocks - 1, "one block back")

    def back_over(self) -> Pause:
        """Go back to the block before, past what it called; at the first block of a program to the
        one that called.
        """
        return self._back_to(step_over_back(self.machine), "one block back")

    def back_to_call(self) -> Pause:
        """Go back to the block that called the program that runs. The main program stays where it
        is.
        """
        if not self.machine.stack:
            return self._paused(Reason.STEP, "no call is open: the main program runs")
        return self._back_to(max(0, self.machine.core.step_of_call), "before the call")

    def reverse(self) -> Pause:
        """Go back to the breakpoint that was met last before this place, or to the head of the
        program. Of an event, such as a change, that is the block that did it.
        """
        self._remember()
        here = self.machine.blocks
        at_event = any(each.block is None for each in self.at.breakpoints)
        try:
            if not self._reversed() or (
                at_event and self.machine.blocks == here - 1 and not self._reversed()
            ):
                self._go_back(0)
                return self._paused(
                    Reason.ENTRY, "no breakpoint before: at the head of the program"
                )
        except InterruptedError as stopped:
            return self._stayed(stopped)
        return self._paused(Reason.BREAKPOINT, "back at the breakpoint met last")

    def _reversed(self) -> bool:
        """Go back to the breakpoint met last. Return whether there was one."""
        breakpoints = self.points.pausing()
        try:
            if not breakpoints:
                return False
            self.machine.back(breakpoints)  # type: ignore[arg-type]
        except ValueError:
            return False
        self._went_back()
        return True

    def back_to(self, to: int | At) -> Pause:
        """Go back as `Machine.back` does: to a step, to where `"#100"` was last written, to a
        place. Raises what it raises.
        """
        self._remember()
        try:
            self.machine.back(to)
        except InterruptedError as stopped:
            return self._stayed(stopped)
        self._went_back()
        return self._paused(Reason.STEP, f"back at step {self.machine.blocks}")

    def restart_frame(self, frame: int = 0) -> Pause:
        """Go back to the first block of a program that runs, in its first pass."""
        call = self.frame(frame).call
        step = 0 if call < 0 else self.machine.calls[call].first_step
        return self._back_to(step, "at the first block again")

    # ---- values ----

    def evaluate(self, text: str, frame: int = 0) -> str:
        """Return the value of an expression, a variable, a mode or an axis, as it is shown; see
        `values.evaluate`.
        """
        return values.evaluate(self.machine, text, self.frame(frame))

    def set(self, name: str, text: str, frame: int = 0) -> str:
        """Give a variable or a mode a value, and return it as it is shown: see `values.put`."""
        return values.put(self.machine, name, text, self.frame(frame))

    def hover(self, text: str, frame: int = 0) -> str:
        """Return the value of what is pointed at, and what is known of it, each on a line."""
        return helping.hover(self.machine, text, self.frame(frame))

    def completions(self, text: str, column: int, frame: int = 0) -> list[helping.Completion]:
        """Return what the text before a column, from 1, may become."""
        frames = self.frames()
        typed, its = text[: max(0, column - 1)], frame_at(frames, frame)
        return helping.completions(self.machine, self._facts, frames, its, typed)

    def search(self, what: str, most: int = 20) -> list[helping.Written]:
        """Return the blocks that gave a variable or an expression another value, the last one
        first. Raises `ValueError` for what is no expression, and `InterruptedError` where `pause`
        stops it.
        """
        self._searching = self.machine.copy()
        try:
            return list(helping.search(self._searching, what, most))
        finally:
            self._searching = None

    def goto(self, to: At) -> Pause:
        """Make another block of the program that runs the next one, without running what lies
        between. Raises what `Machine.goto` raises.
        """
        self._remember()
        self.machine.goto(to)
        return self._paused(Reason.GOTO, "made the next block")

    # ---- blocks that are typed ----

    def mdi(self, text: str) -> Pause:
        """Run blocks typed in MDI in the present state, and what they call, to a breakpoint in it
        or to their end. Raises what `Machine.mdi` raises.
        """
        self.type_in(text)
        return self.run_typed()

    def type_in(self, text: str) -> None:
        """Make typed blocks those that run next. Raises what `Machine.mdi` raises."""
        type_in(self.machine.core, text)

    def run_typed(self) -> Pause:
        """Run the blocks that were typed in."""
        return self._go(len(self.machine.stack) - 1, "the typed blocks are executed")

    # ---- how it moves ----

    def _go(self, depth: int | None, words: str) -> Pause:
        """Run to a point, or to the first block at which no more than so many calls are open."""
        self._remember()
        while True:
            met = run_to(self.machine, self.points, self.frames(), depth)
            pausing = self._count(met.points)
            if met.fault:
                return self._paused(Reason.BREAKPOINT, met.fault, pausing)
            stop = self.machine.stop
            if stop not in (None, Stop.INTERRUPTED):
                return self._stopped(stop, pausing)
            if pausing:
                return self._at_points(pausing)
            if depth is not None and met.stepped and len(self.machine.stack) <= depth:
                return self._paused(Reason.STEP, words)
            if self._asked.is_set() or (stop is not None and not met.tick):
                return self._paused(Reason.PAUSE, "paused")
            if met.tick or self._ticked.is_set():
                self._ticked.clear()
                self._take_messages()
                self.progress(self.machine.blocks)

    def _at_points(self, pausing: tuple[PlacedPoint, ...]) -> Pause:
        told = ", ".join(name_of(each) for each in pausing)
        return self._paused(Reason.BREAKPOINT, f"breakpoint {told}", pausing)

    def _count(self, reached: Sequence[ArmedPoint]) -> tuple[PlacedPoint, ...]:
        """Count what was met, write the lines of log points, and return the points that pause."""
        counted = [one for one in reached if one.met_at(self.machine.blocks)]
        for one in counted:
            if one.placed.point.log is not None:
                self._log(one.placed, one.placed.point.log)
        return tuple(one.placed for one in counted if one.placed.point.log is None)

    def _stopped(self, stop: Stop, pausing: tuple[PlacedPoint, ...]) -> Pause:
        alarm = self.machine.alarm
        if alarm is not None and not self.pauses_at_alarm(alarm.number or "", alarm.cause):
            return self._paused(Reason.END, f"ended: {self.machine.summary()}", pausing)
        reason = _STOPS.get(stop, Reason.END)
        words = {
            Reason.WAITING: f"waits for {self.machine.waiting_for}",
            Reason.LIMIT: "a limit of blocks, time or memory is reached",
            Reason.PAUSE: "paused",
            Reason.END: "the program has ended",
        }.get(reason, self.machine.summary())
        return self._paused(reason, words, pausing)

    def _log(self, placed: PlacedPoint, text: str) -> None:
        words = ""
        for piece, expression in log_pieces(text):
            words += piece
            if expression is not None:
                try:
                    words += self.evaluate(expression)
                except (KeyError, TypeError, ValueError) as error:
                    words += f"{{{expression}: {str(error.args[0]).splitlines()[0]}}}"
        block = placed.block or self.next
        file, line = ("", 0) if block is None else (block.program.file, block.line)
        self._take_messages()
        self._write(Output(words, "log", file, line))

    def _write(self, output: Output) -> None:
        self._written.append(output)
        if self.output is not None:
            self.output(output)

    def _take_messages(self) -> None:
        messages = self.machine.messages
        for text in messages[self._told :]:
            self._write(Output(text, "message"))
        self._told = len(messages)

    def _remember(self) -> None:
        self._facts.remember(self.frames())

    def _paused(
        self,
        reason: Reason,
        text: str,
        points: tuple[PlacedPoint, ...] = (),
        *,
        output: tuple[Output, ...] = (),
    ) -> Pause:
        self._take_messages()
        self._asked.clear()
        written = (*output, *self._written)
        self._written = []
        self.at = Pause(reason, text, points, written)
        return self.at

    def _back_to(self, step: int, words: str) -> Pause:
        self._remember()
        if self.machine.blocks == 0 and self.machine.stop is None:
            return self._paused(Reason.ENTRY, "at the head of the program")
        try:
            self._go_back(max(0, step))
        except InterruptedError as stopped:
            return self._stayed(stopped)
        return self._paused(Reason.STEP if step > 0 else Reason.ENTRY, words)

    def _go_back(self, step: int) -> None:
        self.machine.back(step)
        self._went_back()

    def _stayed(self, stopped: InterruptedError) -> Pause:
        return self._paused(Reason.PAUSE, str(stopped.args[0]))

    def _went_back(self) -> None:
        self._told = len(self.machine.messages)
        self.points.forget_after(self.machine.blocks)
