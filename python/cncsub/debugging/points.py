"""Where a session pauses or writes a line: breakpoints with conditions, counts and log texts."""

from __future__ import annotations

import bisect
import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace

from cncsub import _core
from cncsub.breakpoints import At, Breakpoint, Compiled, blocks_of
from cncsub.debugging.frames import StackFrame, level_opener
from cncsub.debugging.values import is_state_name
from cncsub.program import Block, Program, block_at


@dataclass(frozen=True, slots=True)
class PausePoint:
    """A place or an event at which a session pauses.

    `at` and `when` are those of `cncsub.Breakpoint`. `hits` is a condition on how often it was met:
    `"3"` (the third time), `">=3"`, `">3"`, `"<3"`, `"<=3"`, `"%2"` (each second time). With a
    `log` the session does not pause: it writes the text, in which `{#100}` is the value of an
    expression and `{{` a brace. `call` is the call whose locals `changes` means, -1 the main
    program; `None`: those of the level that is open where the machine runs on.
    """

    at: At
    when: str | None = None
    hits: str | None = None
    log: str | None = None
    call: int | None = None


@dataclass(frozen=True, slots=True)
class PlacedPoint:
    """A point as it stands in a session. `refused` says why it cannot be placed; `moved` that it
    stands at another line than it was asked for. `block` is the block before which it pauses,
    `None` for an event.
    """

    id: int
    point: PausePoint
    block: Block | None = None
    moved: str = ""
    refused: str = ""


@dataclass(slots=True)
class ArmedPoint:
    """A point with its breakpoint, its condition on the count, and when it was met."""

    placed: PlacedPoint
    breakpoint: Breakpoint
    counts: Callable[[int], bool]
    met: list[int] = field(default_factory=list)  # the steps at which it was met

    def met_at(self, step: int) -> bool:
        """Count that the point was met, and return whether this time counts."""
        self.met.append(step)
        return self.counts(len(self.met))


class PausePoints:
    """The points of a session, by the set in which they were given: each set is replaced whole."""

    def __init__(self, core: _core.Machine) -> None:
        self._core = core
        self._sets: dict[str, list[ArmedPoint]] = {}
        self._refused: dict[str, list[PlacedPoint]] = {}
        self._ids: dict[tuple[str, PausePoint], int] = {}  # those that points had keep them

    def place(self, name: str, points: Sequence[PausePoint]) -> list[PlacedPoint]:
        """Replace the points of a set. A point that was in it before keeps its number and its
        count.
        """
        known = {armed.placed.point: armed for armed in self._sets.get(name, ())}
        made: list[ArmedPoint | PlacedPoint] = [
            known.pop(point) if point in known else self._armed(point, name) for point in points
        ]
        self._sets[name] = [one for one in made if isinstance(one, ArmedPoint)]
        self._refused[name] = [one for one in made if isinstance(one, PlacedPoint)]
        return [one.placed if isinstance(one, ArmedPoint) else one for one in made]

    def adopt(self, other: PausePoints) -> None:
        """Place the points of another session, under their numbers."""
        self._ids = other._ids
        for name in other._sets:
            refused = [each.point for each in other._refused[name]]
            self.place(name, [*(each.point for each in other.placed_in(name)), *refused])

    def tried(self, point: PausePoint) -> PlacedPoint:
        """Return a point as it would be placed, without placing it."""
        one = self._armed(point)
        return one.placed if isinstance(one, ArmedPoint) else one

    def _armed(self, point: PausePoint, name: str = "") -> ArmedPoint | PlacedPoint:
        number = self._ids.setdefault((name, point), len(self._ids) + 1)
        placed = PlacedPoint(number, point)
        try:
            counts = hit_condition(point.hits)
            breakpoint, placed = self._placed(placed)
            Compiled(self._core, [breakpoint])
            for text in log_expressions(point.log):
                if not is_state_name(self._core, text):
                    Compiled(self._core, [replace(breakpoint, when=text)])
        except (KeyError, TypeError, ValueError) as error:
            return replace(placed, refused=str(error.args[0]))
        return ArmedPoint(placed, breakpoint, counts)

    def _placed(self, placed: PlacedPoint) -> tuple[Breakpoint, PlacedPoint]:
        at = placed.point.at
        if isinstance(at, str) and (on_line := line_of(at)) is not None:
            file, line = on_line
            block = block_from(self._core.code, file, line)
            if block is not None:
                if block.line != line:
                    moved = f"line {line} has no block; the next one is on line {block.line}"
                    placed = replace(placed, moved=moved)
                at = f"{block.program.file}:{block.line}"
            placed = replace(placed, block=block)
        breakpoint = Breakpoint(at, when=placed.point.when)
        if placed.block is None and (blocks := blocks_of(self._core, breakpoint)):
            placed = replace(placed, block=block_at(self._core.code, blocks[0]))
        return breakpoint, placed

    @property
    def placed(self) -> list[PlacedPoint]:
        """All points, those that are refused too, in the order in which they were placed."""
        every = [each for name in self._sets for each in self.placed_in(name)]
        every += [each for refused in self._refused.values() for each in refused]
        return sorted(every, key=lambda each: each.id)

    def placed_in(self, name: str) -> list[PlacedPoint]:
        """The points of one set that could be placed."""
        return [armed.placed for armed in self._sets.get(name, ())]

    def armed(self) -> list[ArmedPoint]:
        return [armed for armed_set in self._sets.values() for armed in armed_set]

    def armed_in(self, frames: Sequence[StackFrame]) -> tuple[list[ArmedPoint], list[int]]:
        """Return the points that count where a machine stands with these frames. The locals that a
        point means may be those of an outer level: then it counts from where no more calls are
        open than the numbers that are returned too.
        """
        here, depths = [], []
        for armed in self.armed():
            call = armed.placed.point.call
            if call is None or call == level_opener(frames[0], frames):
                here.append(armed)
                continue
            inside = [f for f in frames if level_opener(f, frames) == call]
            if inside:
                depths.append(len(frames) - 1 - inside[0].index)
        return here, depths

    def pausing(self) -> list[Breakpoint]:
        """The breakpoints that pause, without those that write a line."""
        return [each.breakpoint for each in self.armed() if each.placed.point.log is None]

    def move_to(self, core: _core.Machine) -> None:
        """Be the points of another machine of the same library, at its head."""
        self._core = core
        for armed in self.armed():
            armed.met.clear()

    def forget_after(self, step: int) -> None:
        """Forget what was met after a step: the machine went back to it."""
        for armed in self.armed():
            del armed.met[bisect.bisect_right(armed.met, step) :]


# ---- hits and log texts ----

_COMPARE: dict[str, Callable[[int, int], bool]] = {
    ">=": lambda count, asked: count >= asked,
    "<=": lambda count, asked: count <= asked,
    "==": lambda count, asked: count == asked,
    ">": lambda count, asked: count > asked,
    "<": lambda count, asked: count < asked,
    "=": lambda count, asked: count == asked,
    "%": lambda count, asked: count % asked == 0,
}


def hit_condition(text: str | None) -> Callable[[int], bool]:
    """Return whether the so manieth time counts. `ValueError` for what is no condition.

    >>> [count for count in range(1, 7) if hit_condition("%2")(count)]
    [2, 4, 6]
    """
    asked = (text or ">=1").strip()
    sign = next((sign for sign in _COMPARE if asked.startswith(sign)), "")
    number = asked[len(sign) :].strip()
    if (
        not (number.isascii() and number.isdecimal())
        or not 1 <= len(number) <= 9
        or not int(number)
    ):
        raise ValueError(f"hits must be such as '3' (the third time), '>=3' or '%2', not {text!r}")
    compare, count = _COMPARE[sign or "=="], int(number)
    return lambda times: compare(times, count)


def log_pieces(text: str) -> Iterator[tuple[str, str | None]]:
    """Yield the pieces of a log text: words, and the expression that follows them or `None`.

    >>> list(log_pieces("pass {#30} of {{#6}}"))
    [('pass ', '#30'), (' of {#6}', None)]
    """
    words, at = "", 0
    while at < len(text):
        letter = text[at]
        if text[at : at + 2] in ("{{", "}}"):
            words, at = words + letter, at + 2
        elif letter == "{":
            end = text.find("}", at)
            if end < 0:
                raise ValueError(f"log: {{ without }} in {text!r}")
            yield words, text[at + 1 : end]
            words, at = "", end + 1
        else:
            words, at = words + letter, at + 1
    if words:
        yield words, None


def log_expressions(text: str | None) -> list[str]:
    pieces = log_pieces(text) if text is not None else ()
    return [expression for _, expression in pieces if expression is not None]


# ---- lines ----


def line_of(at: str) -> tuple[str, int] | None:
    """Return the file or program and the line of `"row.nc:12"`; `None` for any other text.

    >>> line_of("row.nc:12"), line_of("O1:N30"), line_of("call")
    (('row.nc', 12), None, None)
    """
    name, colon, line = at.rpartition(":")
    if not colon or not (line.isascii() and line.isdecimal()) or len(line) > 9:
        return None
    return name, int(line)


def programs_of(code: _core.Code, file: str) -> list[Program]:
    """Return the programs of a file, which is given by its name or by a path that leads to it."""
    every = [Program(code.program(i), i) for i in range(len(code))]
    for same in (_same_name, _same_path, _same_ending):
        if found := [program for program in every if same(program.file, file)]:
            return found
    return []


def _same_name(known: str, asked: str) -> bool:
    return known == asked


def _same_path(known: str, asked: str) -> bool:
    return "\0" not in asked and os.path.realpath(known) == os.path.realpath(asked)


def _same_ending(known: str, asked: str) -> bool:
    """Return whether a file that is not on the disk, or named alone, is meant."""
    name = asked.replace("\\", "/").rpartition("/")[2]
    return known == name or ("/" not in asked and known.endswith(f"/{asked}"))


def blocks_from(code: _core.Code, file: str, line: int) -> Iterator[Block]:
    """Yield the first block of each program of a file on a line or after it."""
    for program in programs_of(code, file):
        blocks = program.blocks
        at = bisect.bisect_left(blocks, line, key=lambda block: block.line)
        if at < len(blocks):
            yield blocks[at]


def blocks_between(program: Program, first: int, last: int) -> list[Block]:
    """Return the blocks of a program on the lines from `first` to `last`."""
    blocks = program.blocks
    begin = bisect.bisect_left(blocks, first, key=lambda block: block.line)
    return blocks[begin : bisect.bisect_right(blocks, last, key=lambda block: block.line)]


def block_from(code: _core.Code, file: str, line: int) -> Block | None:
    """Return the first block of a file on a line or after it, `None` where there is none."""
    return min(blocks_from(code, file, line), key=lambda block: block.line, default=None)
