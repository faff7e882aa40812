"""Generates programs that mean the same on every control, and the moves that they mean.

A program here is not yet text: lengths are whole micrometres, an arc has its centre. `spelling.py`
writes it as each control wants it. `moves_of` returns the moves that all of them have to make.

The programs leave out what the controls do differently, by the rules that say so: L0
(zero_repeats), calls of open programs (self_call, caller_call), words beside M98 and M99
(call-with-words-in-cycle, codes_not_with_call), more than four levels (max_nesting), arcs with R
that end where they start (no-arc-travel) and arcs with neither R nor centre (no_radius), a third
axis in the arcs of lathes (helix), the codes in force at power-on (power_on).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from random import Random

RAPID, FEED, CW, CCW = "rapid", "feed", "cw", "ccw"
ARCS = (CW, CCW)
PLANES = {17: "XY", 18: "ZX", 19: "YZ"}
MAX_DEPTH = 4  # the lowest limit of all controls
MAX_MOVES = 150

# Points on a circle around 0 with whole coordinates: ends of exact arcs.
QUARTERS = ((1, 0), (0, 1), (-1, 0), (0, -1))
FIVES = tuple((a, b) for a in range(-5, 6) for b in range(-5, 6) if a * a + b * b == 25)

Lengths = dict[str, int]  # micrometres by axis


@dataclass(frozen=True)
class Ground:
    """The axes and planes that programs of a kind may use."""

    axes: str
    planes: tuple[int, ...]


TURNING = Ground("XZ", (18,))
MILLING = Ground("XYZ", (17, 18, 19))


@dataclass(frozen=True)
class Modes:
    """The modes in force from block to block."""

    motion: str = RAPID
    absolute: bool = True
    plane: int = 17


@dataclass(frozen=True)
class Block:
    """The modes that a block writes (others are in force already), and the words of its move."""

    written: frozenset[str]
    modes: Modes
    axes: Lengths = field(default_factory=dict)
    centre: Lengths = field(default_factory=dict)  # from the start of an arc
    centre_words: str = ""  # the axes whose I, J or K is written
    radius: int = 0  # written instead of the centre, negative the long way around


@dataclass(frozen=True)
class Call:
    program: Program
    repeats: int


@dataclass
class Program:
    number: int
    entry: Modes  # the modes in force at its call
    blocks: list[Block | Call] = field(default_factory=list)
    exit: Modes = Modes()
    place: Lengths = field(default_factory=dict)  # the place where it ends, as far as it is known
    moves: int = 0
    depth: int = 0  # the levels of calls below it

    def called(self) -> Iterator[Program]:
        """Yield every program below this one, each once."""
        seen: dict[int, Program] = {}
        for block in self.blocks:
            if isinstance(block, Call) and block.program.number not in seen:
                seen[block.program.number] = block.program
                seen.update((below.number, below) for below in block.program.called())
        yield from seen.values()


@dataclass(frozen=True)
class Move:
    kind: str
    end: Lengths
    centre: Lengths  # of an arc, in its plane


def generate(random: Random, ground: Ground) -> Program:
    """Return a main program and the programs that it calls, up to `MAX_DEPTH` levels."""
    numbers = iter(random.sample(range(1, 10_000), 2 * MAX_DEPTH + 1))
    below: list[Program] = []
    for _ in range(random.choice((0, 1, 2, 3, MAX_DEPTH, MAX_DEPTH))):
        level = [_Author(random, ground, next(numbers)) for _ in range(random.randint(1, 2))]
        below += [author.write_subprogram(below) for author in level]
    return _Author(random, ground, next(numbers)).write_main(below)


class _Author:
    """Writes one program block by block and knows the modes in force at each."""

    def __init__(self, random: Random, ground: Ground, number: int) -> None:
        self.random = random
        self.ground = ground
        plane = random.choice(ground.planes)
        entry = Modes(random.choice((RAPID, FEED)), random.random() < 0.5, plane)
        self.program = Program(number, entry)
        self.modes = entry
        self.place: Lengths = {}

    def write_main(self, below: list[Program]) -> Program:
        home = {axis: self.length() for axis in self.ground.axes}
        self.modes = Modes(RAPID, True, self.modes.plane)
        self.add(Block(frozenset({"motion", "absolute", "plane"}), self.modes, home))
        self.write_body(below, self.random.randint(2, 8))
        return self.finish()

    def write_subprogram(self, below: list[Program]) -> Program:
        self.write_body(below, self.random.randint(1, 5))
        if self.random.random() < 0.5:
            self.require(self.program.entry)
        return self.finish()

    def finish(self) -> Program:
        self.program.exit = self.modes
        self.program.place = self.place
        return self.program

    def write_body(self, below: list[Program], blocks: int) -> None:
        for _ in range(blocks):
            kind = self.random.random()
            if below and kind < 0.4:
                # The program that was written last has the deepest calls.
                self.call(self.random.choice((below[-1], self.random.choice(below))))
            elif kind < 0.7:
                self.line()
            elif kind < 0.92:
                self.arc()
            else:
                self.require(self.other_modes())

    # ---- blocks ----

    def line(self) -> None:
        modes = self.other_modes()
        count = self.random.randint(1, len(self.ground.axes))
        axes = self.random.sample(self.ground.axes, count)
        self.add(Block(self.changes(modes), modes, {axis: self.length() for axis in axes}))

    def arc(self) -> None:
        plane = self.other_modes().plane
        first, second = PLANES[plane]
        known = first in self.place and second in self.place
        absolute = known and self.random.random() < 0.5
        modes = Modes(self.random.choice(ARCS), absolute, plane)
        start, end = self.around()
        axes = {first: end[0] - start[0], second: end[1] - start[1]}
        centre = {first: -start[0], second: -start[1]}
        radius = 0
        if start != end and self.random.random() < 0.4:
            radius = self.radius_of(start, end, modes.motion)
        # An axis that stays where it is, and a distance of 0, may be left out.
        axes = {axis: way for axis, way in axes.items() if way or self.random.random() < 0.4}
        words = [axis for axis, way in centre.items() if way or self.random.random() < 0.4]
        if absolute:
            axes = {axis: self.place[axis] + way for axis, way in axes.items()}
        across = next(axis for axis in "XYZ" if axis not in (first, second))
        if across in self.ground.axes and start != end and self.random.random() < 0.2:
            axes[across] = self.length()
        written = self.changes(modes)
        self.add(Block(written, modes, axes, centre, "" if radius else "".join(words), radius))

    def around(self) -> tuple[tuple[int, int], tuple[int, int]]:
        """Return two points of a circle around 0, one point twice for a full circle.

        LinuxCNC takes a radius of a thousandth for a mistake, "Zero-radius arc".
        """
        points = self.random.choice((QUARTERS, FIVES))
        scale = self.random.randint(10, 4000) * self.random.choice((1, 10))
        start, end = self.random.choice(points), self.random.choice(points)
        return (start[0] * scale, start[1] * scale), (end[0] * scale, end[1] * scale)

    def radius_of(self, start: tuple[int, int], end: tuple[int, int], motion: str) -> int:
        radius = round((start[0] ** 2 + start[1] ** 2) ** 0.5)
        side = start[0] * end[1] - start[1] * end[0]  # positive: less than half, counter-clockwise
        if side == 0:
            return self.random.choice((radius, -radius))
        return radius if (side > 0) == (motion == CCW) else -radius

    def call(self, program: Program) -> None:
        # A second pass starts with the modes that the first one left in force.
        most = 4 if program.exit == program.entry else 1
        repeats = self.random.randint(1, most)
        if self.program.moves + repeats * program.moves > MAX_MOVES:
            return
        self.require(program.entry)
        self.program.blocks.append(Call(program, repeats))
        self.program.moves += repeats * program.moves
        self.program.depth = max(self.program.depth, program.depth + 1)
        self.modes = program.exit
        self.place = dict(program.place)

    def require(self, modes: Modes) -> None:
        """Bring these modes into force by a block without a move."""
        needed = self.changes(modes, spare=0.1)
        if needed:
            self.add(Block(needed, modes))

    # ---- modes in force ----

    def other_modes(self) -> Modes:
        """Return modes for a line: some as they are, some changed."""
        motion = self.modes.motion
        if motion in ARCS or self.random.random() < 0.5:
            motion = self.random.choice((RAPID, FEED))
        absolute = self.modes.absolute != (self.random.random() < 0.25)
        plane = self.modes.plane
        if self.random.random() < 0.25:
            plane = self.random.choice(self.ground.planes)
        return Modes(motion, absolute, plane)

    def changes(self, modes: Modes, spare: float = 0.3) -> frozenset[str]:
        """Return the modes that a block has to write, and some that it need not."""
        return frozenset(
            name
            for name in ("motion", "absolute", "plane")
            if getattr(modes, name) != getattr(self.modes, name) or self.random.random() < spare
        )

    def length(self) -> int:
        return self.random.randint(-50, 50) * self.random.choice((1, 10, 100, 1000))

    def add(self, block: Block) -> None:
        self.program.blocks.append(block)
        self.program.moves += bool(block.axes or block.centre)
        self.modes = block.modes
        for axis, value in block.axes.items():
            if block.modes.absolute:
                self.place[axis] = value
            elif axis in self.place:
                self.place[axis] += value


def moves_of(program: Program) -> list[Move]:
    """Return the moves that the program means, without straight moves of no length."""
    return list(_moves(program, dict.fromkeys("XYZ", 0)))


def _moves(program: Program, place: Lengths) -> Iterator[Move]:
    for block in program.blocks:
        if isinstance(block, Call):
            for _ in range(block.repeats):
                yield from _moves(block.program, place)
            continue
        start = dict(place)
        for axis, value in block.axes.items():
            place[axis] = value if block.modes.absolute else place[axis] + value
        if block.centre:
            centre = {axis: start[axis] + way for axis, way in block.centre.items()}
            yield Move(block.modes.motion, dict(place), centre)
        elif place != start:
            yield Move(block.modes.motion, dict(place), {})
