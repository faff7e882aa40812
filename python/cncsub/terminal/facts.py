"""What the screen shows of a session at a pause: taken once, when the machine is at rest."""

from __future__ import annotations

import io
from dataclasses import dataclass

from cncsub.debugging import Pause, Reason, Scope, Session, StackFrame
from cncsub.drawing.path import Path, path_of
from cncsub.escapes import shown
from cncsub.number_text import length_text
from cncsub.reports.printing import Console, Text, print_stop
from cncsub.setup import AXES
from cncsub.tables.rows import Move

MOST_DRAWN = 20_000  # of the last moves
_MOST_POINTS = 1200
_LAST_MOVES = 8


class _Lines(Console):
    """A console that keeps plain lines, whatever the environment says of colours."""

    def __init__(self) -> None:
        self.written = io.StringIO()

    def print(self, text: str | Text = "", end: str = "\n") -> None:
        parts = [(text, "")] if isinstance(text, str) else text.parts
        self.written.write("".join(part for part, _ in parts) + end)


@dataclass(frozen=True, slots=True)
class AlarmPlace:
    """Where an alarm points: `width` columns from `column`, from 1, of a line of a file."""

    file: str
    line: int
    column: int
    width: int


@dataclass(frozen=True, slots=True)
class Shown:
    """The state of a session at a pause. `told`: how the program stopped, as `cncsub run` prints
    it, empty while it runs. `path`: of the last moves, `None` before the first.
    """

    pause: Pause
    frames: tuple[StackFrame, ...]
    blocks: int
    told: tuple[str, ...]
    alarm: AlarmPlace | None
    path: Path | None
    moves: tuple[str, ...]
    left_out: int  # moves before those that are drawn


def shown_of(session: Session) -> Shown:
    """Return what is shown of a session. It may take a moment: at a limit it is found out whether
    the program ever ends.
    """
    machine = session.machine
    count = len(machine.moves)
    first = max(0, count - MOST_DRAWN)
    rows = (first, count)
    path = path_of(machine.recorded, linked=0, most=_MOST_POINTS, rows=rows) if count else None
    return Shown(
        session.at,
        tuple(session.frames()),
        machine.blocks,
        tuple(_stop_lines(session)),
        _alarm_place(session),
        path,
        tuple(move_text(machine.moves[i]) for i in range(max(0, count - _LAST_MOVES), count)),
        first,
    )


def scopes_of(session: Session, frame: int) -> dict[str, Scope]:
    """Return the groups of values as a program that runs sees them, by their names."""
    return {scope.name: scope for scope in session.scopes(frame)}


def _stop_lines(session: Session) -> list[str]:
    if not session.ended:
        return []
    console = _Lines()
    print_stop(console, session.machine)  # type: ignore[arg-type]  # it has what a run has
    return console.written.getvalue().splitlines()


def _alarm_place(session: Session) -> AlarmPlace | None:
    alarm = session.machine.alarm
    if alarm is None:
        return None
    return AlarmPlace(alarm.file, alarm.line, max(1, alarm.column), max(1, len(alarm.word)))


def move_text(move: Move) -> str:
    """Return a move on one line: its kind, where it ends, and the feed of a cut."""
    ends = ((axis, getattr(move, axis.lower())) for axis in AXES)
    words = [f"{axis}{length_text(value)}" for axis, value in ends if value is not None]
    if move.feed is not None and move.kind != "rapid":
        words.append(f"F{length_text(move.feed)}")
    return f"{move.kind:<5} {' '.join(words)}"


def pause_words(facts: Shown) -> str:
    """Return on one line where the session stands, and why."""
    reason, text = facts.pause.reason, facts.pause.text
    ran = f"{facts.blocks:,} block{'' if facts.blocks == 1 else 's'} ran"
    if reason is Reason.WAITING:
        text += " (set it and run on)"
    if reason in (Reason.ALARM, Reason.END):  # the words name the place, or there is none
        return shown(f"{text}; {ran}")
    return shown(f"{place_of(facts.frames[0])}: {text}; {ran}")


def place_of(frame: StackFrame) -> str:
    """Return the program and the block of a frame: `O1 N20`, or with the line."""
    block = frame.block
    if block is None:
        return frame.program
    return f"{frame.program} {f'line {block.line}' if block.n is None else f'N{block.n}'}"
