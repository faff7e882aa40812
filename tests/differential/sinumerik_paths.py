"""Compute the moves of a SINUMERIK program: frames, zero points, poles and arcs, by the manual.

Positions are those of the frame of the program. A move ends in machine coordinates: the frame of
the program first, then the zero point.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace

import sinumerik_language as l
from sinumerik_arithmetic import Scope, UnclearError, Value
from sinumerik_frames import AXES, UNCHANGED, FrameValue, Point, applied, chained, made

LARGEST = 1e6
# The two axes of each plane, in the order in which angles count, and the axis across it.
PLANES = {"G17": ("X", "Y", "Z"), "G18": ("Z", "X", "Y"), "G19": ("Y", "Z", "X")}


@dataclass(frozen=True)
class State:
    """What SAVE gives back: the codes that stay in force, the zero point and the frame."""

    rapid: bool = False
    absolute: bool = True
    plane: str = "G17"
    zero: str = "G54"
    held: Point | None = None  # the zero point in force, where its code has come
    frame: FrameValue = UNCHANGED


@dataclass
class Paths:
    """Where the tool is. `zeros` are the work offsets."""

    zeros: dict[str, Point] = field(default_factory=dict)
    moves: list[tuple[str, float, float, float]] = field(default_factory=list)
    local: list[float] = field(default_factory=lambda: [0.0, 0.0, 0.0])
    state: State = State()
    pole: tuple[float, float] = (0.0, 0.0)
    radius: float = 0.0
    angle: float = 0.0

    def value(self, of: l.Expression, scope: Scope) -> Value:
        raise NotImplementedError

    def length(self, of: l.Expression, scope: Scope) -> float:
        return float(self.value(of, scope))

    # ---- moves ----

    def path(self, of: l.Moving, scope: Scope) -> None:
        match of:
            case l.Move():
                self.move(of, scope)
            case l.MachineMove():
                self.machine_move(of, scope)
            case l.Polar():
                self.polar(of, scope)
            case l.Arc():
                self.arc(of, scope)

    def move(self, of: l.Move, scope: Scope) -> None:
        codes = of.code.split()
        old = self.state
        self.state = replace(
            old,
            absolute="G90" in codes or (old.absolute and "G91" not in codes),
            rapid="G0" in codes or (old.rapid and "G1" not in codes),
        )
        if of.words:
            self.go(self.straight(), self.reached(of.words, scope))

    def straight(self) -> str:
        return "rapid" if self.state.rapid else "feed"

    def reached(self, words: tuple[l.Word, ...], scope: Scope) -> list[float]:
        """Return where words lead to in the frame."""
        to = list(self.local)
        for word in words:
            place = self.axis(word.axis, scope)
            to[place] = self.coordinate(word, self.local[place], scope)
        return to

    def axis(self, of: str, scope: Scope) -> int:
        """Return the place of an axis by its name, by that of its variable, or by AX[...]."""
        name = of.removeprefix("AX[").removesuffix("]")
        return AXES.index(str(scope.cells[name].value) if name in scope.cells else name)

    def coordinate(self, word: l.Word, at: float, scope: Scope) -> float:
        add = word.manner == "IC" or (word.manner == "" and not self.state.absolute)
        return self.length(word.value, scope) + (at if add else 0.0)

    def go(self, kind: str, to: list[float]) -> None:
        self.local = to
        place = self.machine()
        if max(map(abs, (*to, *place))) > LARGEST:
            raise UnclearError
        self.moves.append((kind, *place))

    def machine(self) -> Point:
        """Return the position in machine coordinates."""
        frame, held = self.state.frame, self.state.held
        zero = self.zeros[self.state.zero] if held is None else held
        x, y, z = self.local
        a, b, c = zip(applied(frame.turn, (x, y, z)), frame.whole, zero, strict=True)
        return sum(a), sum(b), sum(c)

    def machine_move(self, of: l.MachineMove, scope: Scope) -> None:
        """Move to machine coordinates, with all axes: where the tool is in the frame is open."""
        self.moves.append(
            (
                self.straight(),
                *(self.length(word.value, scope) for word in of.words),  # type: ignore[arg-type]
            )
        )

    # ---- polar coordinates ----

    def ends(self) -> tuple[int, int]:
        one, other, _ = PLANES[self.state.plane]
        return AXES.index(one), AXES.index(other)

    def point(self, radius: float, angle: float) -> tuple[float, float]:
        turn = math.radians(angle)
        return self.pole[0] + radius * math.cos(turn), self.pole[1] + radius * math.sin(turn)

    def set_pole(self, of: l.Pole, scope: Scope) -> None:
        """G111 counts from the zero point, G110 from the tool, G112 from the pole before."""
        one, other = self.ends()
        from_ = {
            "G110": (self.local[one], self.local[other]),
            "G111": (0.0, 0.0),
            "G112": self.pole,
        }[of.code]
        given = {name: self.length(value, scope) for name, value in of.words}
        if "RP" in given:
            self.pole = from_
            self.pole = self.point(given["RP"], given["AP"])
        else:
            self.pole = from_[0] + given[AXES[one]], from_[1] + given[AXES[other]]

    def polar(self, of: l.Polar, scope: Scope) -> None:
        if "G0" in of.code or "G1" in of.code:
            self.state = replace(self.state, rapid="G0" in of.code)
        if of.radius is not None:
            add = self.radius if of.manners[0] == "IC" else 0.0
            self.radius = self.length(of.radius, scope) + add
        if of.angle is not None:
            add = self.angle if of.manners[1] == "IC" else 0.0
            self.angle = self.length(of.angle, scope) + add
        if self.radius < 0:
            raise UnclearError
        to = self.reached((of.along,) if of.along else (), scope)
        one, other = self.ends()
        to[one], to[other] = self.point(self.radius, self.angle)
        self.go(self.straight(), to)

    # ---- arcs ----

    def arc(self, of: l.Arc, scope: Scope) -> None:
        """Move along an arc. A frame that mirrors the plane changes its direction."""
        one, other = self.ends()
        across = 3 - one - other
        turn = self.state.frame.turn
        u, v = ([turn[i][j] for i in range(3)] for j in (one, other))
        if max(abs(u[across]), abs(v[across])) > 1e-9:
            raise UnclearError  # the plane is tilted
        clockwise = of.clockwise == (u[one] * v[other] - u[other] * v[one] > 0)
        self.go("cw" if clockwise else "ccw", self.reached(of.to, scope))

    # ---- frames ----

    def code(self, code: str) -> None:
        if code in PLANES:
            self.state = replace(self.state, plane=code)
        else:
            self.state = replace(self.state, zero=code, held=self.zeros[code])

    def frame(self, of: l.Frame, scope: Scope) -> None:
        """Change the programmable frame: words beginning with A are added to it, others replace."""
        given = {a: self.length(v, scope) if v is not None else 0.0 for a, v in of.words}
        old = self.state.frame if of.op.startswith("A") else FrameValue()
        if "RPL" in given:  # it turns about the axis across the plane
            given = {PLANES[self.state.plane][2]: given["RPL"]}
        values = {AXES.index(axis): value for axis, value in given.items()}
        frame = chained(old, made(f"C{of.op.removeprefix('A')}", values))
        self.state = replace(self.state, frame=frame)
