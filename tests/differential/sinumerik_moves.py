"""Generate the moves of SINUMERIK programs: words, frames, zero points, poles and arcs."""

from __future__ import annotations

from dataclasses import dataclass, field

import sinumerik_language as l
from sinumerik_paths import PLANES
from sinumerik_values import ValueWriter, integer, real

ZEROS = ("G54", "G55", "G500", "G505")


@dataclass
class MoveWriter(ValueWriter):
    """Writes blocks that move, and those that say where to."""

    here: l.Program = field(default_factory=lambda: l.Program("MAIN"))
    open: list[int] = field(default_factory=list)
    names: int = 0

    def name(self, stem: str) -> str:
        self.names += 1
        return f"{stem}_{self.names}"

    def put(self, action: l.Action, label: str = "") -> int:
        place = len(self.here.blocks)
        inside = tuple(self.open)
        self.here.blocks.append(l.Block(action, label=label, inside=inside))
        return place

    def move(self) -> None:
        r = self.random
        words = []
        for axis in "XYZ":
            if self.chance(0.5):
                manner = r.choice(("", "", "", "IC", "AC")) if self.has("increments") else ""
                words.append(l.Word(axis, self.length(), manner))
        words = words or [l.Word("X", self.length())]
        if self.known.numbers["AXIS"] and self.chance(0.2):
            name = r.choice(self.known.numbers["AXIS"])
            words = [l.Word(f"AX[{name}]", self.length(), r.choice(("", "IC", "AC")))]
        code = r.choice(("", "G0", "G1", "G90", "G91", "G90 G0"))
        self.put(l.Move(code, tuple(words)))

    def frame(self) -> None:
        """Write a frame, and a move of all axes: where an axis that is not named stands is open."""
        r = self.random
        op = r.choice(("TRANS", "ATRANS", "ROT", "AROT", "SCALE", "ASCALE", "MIRROR", "AMIRROR"))
        chosen = [axis for axis in "XYZ" if self.chance(0.5)]
        words: list[tuple[str, l.Expression | None]] = []
        if op.endswith("TRANS"):
            words = [(axis, self.length()) for axis in chosen]
        elif op.endswith("ROT"):
            angles = (30, 45, 90, 12.5, 180, 200)
            if self.chance(0.4):
                words = [("RPL", self.angle(r.choice(angles)))]
            else:
                words = [(axis, self.angle(r.choice(angles))) for axis in chosen]
        elif op.endswith("SCALE"):
            factor = real(r.choice((0.5, 2.0, 1.5, 0.25)))
            words = [(axis, factor) for axis in "XYZ"]  # one factor: it commutes with rotations
        else:
            words = [(axis, None) for axis in chosen]
        if not words and (op.startswith("A") or self.chance(0.5)):
            return
        if op.endswith("SCALE") and not op.startswith("A") and self.chance(0.2):
            words = []
        self.put(l.Frame(op, tuple(words)))
        self.everywhere()

    def frame_value(self, deep: int = 0) -> l.FrameValue:
        """Return a frame: a function, a variable, or a chain. All factors of a scale are one."""
        r = self.random
        if deep < 2 and self.chance(0.35):
            return l.Chain(self.frame_value(deep + 1), self.frame_value(2))
        if self.chance(0.3):
            return self.frame_name()
        name = r.choice(("CTRANS", "CFINE", "CROT", "CSCALE", "CMIRROR"))
        chosen = [self.axis()] if self.chance(0.3) else [a for a in "XYZ" if self.chance(0.6)]
        words: list[tuple[str, l.Expression | None]]
        if name == "CSCALE":
            factor = real(r.choice((0.5, 2.0, 1.5)))
            words = [(axis, factor) for axis in "XYZ"]
        elif name == "CROT":
            words = [(axis, self.angle(r.choice((30, 45, 12.5, 90, 100)))) for axis in chosen]
        elif name == "CMIRROR":
            words = [(axis, None) for axis in chosen]
        else:
            words = [(axis, self.length()) for axis in chosen]
        return l.FrameCall(name, tuple(words))

    def frame_values(self) -> None:
        """Write assignments of frames and of their parts, and lay one over the program."""
        r = self.random
        for _ in range(r.randint(1, 3)):
            to = self.frame_name()
            if self.chance(0.5):
                self.put(l.FrameAssign(to, self.frame_value()))
            else:
                self.part_assignment(to)
            if to.text == "$P_PFRAME":
                self.everywhere()
        self.put(l.FrameAssign(l.FrameName("$P_PFRAME"), self.frame_value()))
        self.everywhere()

    def part_assignment(self, to: l.FrameName) -> None:
        part = self.random.choice(("TR", "FI", "RT", "MI"))
        value = self.length()
        if part == "RT":
            value = self.angle(self.random.choice((10, 30, 75.5)))
        if part == "MI":
            value = integer(self.random.randint(0, 1))
        self.put(l.Assign(((l.Part(to, self.axis(), part), value),)))

    def stored_frame(self) -> None:
        """Write the frame of a work system, and its code, with which it takes effect."""
        r = self.random
        text, code = r.choice(tuple(l.SYSTEMS.items()))
        name = l.FrameName(text)
        if self.chance(0.5):
            words = tuple((axis, self.length()) for axis in "XYZ" if self.chance(0.7))
            self.put(l.FrameAssign(name, l.FrameCall(r.choice(("CTRANS", "CFINE")), words)))
        else:
            self.put(
                l.Assign(((l.Part(name, self.axis(), r.choice(("TR", "FI"))), self.length()),))
            )
        self.put(l.Assign(((self.parameter(), l.Part(name, self.axis(), r.choice(("TR", "FI")))),)))
        self.move()
        self.put(l.Code(code))
        self.everywhere()

    def everywhere(self) -> None:
        moves = tuple(l.Word(axis, self.length()) for axis in "XYZ")
        self.put(l.Move(self.random.choice(("G90 G0", "G90 G1")), moves))

    def angle(self, degrees: float) -> l.Expression:
        number = l.Number(f"{degrees:g}")
        return l.Unary("NEGATIVE", number) if self.chance(0.3) else number

    def pass_(self) -> None:
        """Write a block that neither moves nor computes."""
        words = ('MSG("part")', "G4 F0.1", "STOPRE", "M8", "S800 M3", "GOTOS", "MSG()", "G64")
        self.put(l.Passed(self.random.choice(words)))

    def plane(self) -> None:
        self.put(l.Code(self.random.choice(list(PLANES))))

    def zero_point(self) -> None:
        self.put(l.Code(self.random.choice(ZEROS)))
        self.everywhere()

    def machine_move(self) -> None:
        words = tuple(l.Word(axis, self.length()) for axis in "XYZ")
        self.put(l.Move("G90", ()))
        self.put(l.MachineMove(self.random.choice(("G53", "G153", "SUPA")), words))
        self.everywhere()

    def own_plane(self) -> tuple[str, str, str]:
        """Write a plane and a move of all axes; return the axes."""
        code = self.random.choice(list(PLANES))
        self.put(l.Code(code))
        self.everywhere()
        return PLANES[code]

    def polar(self) -> None:
        """Write poles, each with moves about it."""
        one, other, across = self.own_plane()
        for code in ["G111", *self.random.sample(("G110", "G112"), self.random.randint(0, 2))]:
            words: tuple[tuple[str, l.Expression], ...]
            words = ((one, self.length()), (other, self.length()))
            if self.chance(0.3):
                words = (("RP", self.distance()), ("AP", self.angle(35)))
            self.put(l.Pole(code, words))
            self.put(l.Polar("G0", self.distance(), self.angle(30)))
            for _ in range(self.random.randint(0, 2)):
                radius = self.distance() if self.chance(0.5) else None
                turn = self.angle(self.random.choice((45, 90, 10.5))) if self.chance(0.7) else None
                manners = self.random.choice((("", ""), ("IC", "IC"), ("AC", "IC")))
                along = l.Word(across, self.length()) if self.chance(0.3) else None
                if radius or turn:
                    self.put(l.Polar(self.random.choice(("", "G1")), radius, turn, manners, along))
        self.everywhere()

    def distance(self) -> l.Expression:
        return real(self.random.uniform(1, 30))

    def arc(self) -> None:
        """Write an arc of a quarter, a half or a whole circle, after a move to its first point."""
        r = self.random
        one, other, across = self.own_plane()
        a, b, radius = r.randint(-20, 20), r.randint(-20, 20), r.randint(1, 15)
        points = [(a + radius, b), (a, b + radius), (a - radius, b), (a, b - radius)]
        first, last = r.randrange(4), r.randrange(4)
        self.put(l.Move("G90 G1", self.words(one, other, points[first])))
        clockwise = self.chance(0.5)
        to = self.words(one, other, points[last])
        if self.chance(0.3):
            to = (*to, l.Word(across, self.length()))
        words: tuple[tuple[str, l.Expression], ...]
        if first != last and self.chance(0.4):
            way, words = "CR", (("CR", self.signed(radius if self.chance(0.7) else -radius)),)
        else:
            way = "AC" if self.chance(0.3) else ""
            from_ = (0, 0) if way else points[first]
            letters = {"X": "I", "Y": "J", "Z": "K"}
            words = (
                (letters[one], self.signed(a - from_[0])),
                (letters[other], self.signed(b - from_[1])),
            )
        self.put(l.Arc(clockwise, to, way, words))
        self.everywhere()

    def words(self, one: str, other: str, point: tuple[int, int]) -> tuple[l.Word, ...]:
        return l.Word(one, self.signed(point[0])), l.Word(other, self.signed(point[1]))

    def signed(self, value: int) -> l.Expression:
        return integer(value) if value >= 0 else l.Unary("NEGATIVE", integer(-value))
