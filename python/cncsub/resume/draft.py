"""The blocks of a restart's head under trial: each has been run by the control."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING, Any

from cncsub.resume.history import Before
from cncsub.resume.start import Starts, given_setup, machine_coordinate, nearness
from cncsub.resume.state import RestartState, group_of

if TYPE_CHECKING:
    from cncsub.library import Library
    from cncsub.machine import Machine

REACHED = 0.01  # mm: words of a head that have so many digits
BENDING = ("scaling", "rotation", "polar", "mirror")  # modes that change where words lead
PLANES = {"G17": "XY", "G18": "ZX", "G19": "YZ"}  # [ISO 6983-1]
_INCH = 25.4
_ROTARY = "ABC"


class Draft:
    """The blocks of a head so far: `lines`, and the modes after them: `modal`. `lacks` tells
    what could not be put in force, `notes` what whoever starts the program should know.
    """

    def __init__(
        self,
        library: Library,
        machine: Machine,
        state: RestartState,
        starts: Starts,
        before: Before,
        options: dict[str, Any],
    ) -> None:
        self.library = library
        self.machine = machine
        self.state = state
        self.starts = starts
        self.before = before
        self.setup = given_setup(options)
        self.near = nearness(library.control)  # mm
        self.options = {
            **options,
            "trace": "moves",
            "max_cycles": 1,
            "start": None,
        }
        self.lines: list[str] = []
        self.lacks: list[str] = []
        self.notes: list[str] = []
        self.now = self.run([])
        self.power_on = self.modal
        self.frames = machine.core.control_frames
        self.lathe = self.power_on.get("plane", "G18") == "G18"

    @property
    def now(self) -> Machine:
        """The machine that has run the blocks."""
        return self._now

    @now.setter
    def now(self, machine: Machine) -> None:
        self._now = machine
        self.modal = dict(machine.modal)  # the modes in force now

    def run(self, lines: list[str]) -> Machine:
        """Return the machine that has run some blocks."""
        text = "".join(f"{line}\n" for line in lines)
        library = self.library.of_text(f"{text}M30\n", self.library.control)
        machine = library.machine(**{**self.options, "max_blocks": len(lines)})
        machine.run()
        return machine

    def add(self, *lines: str) -> bool:
        """Add blocks, unless the control refuses them; return whether it took them."""
        tried = self.run([*self.lines, *lines])
        if tried.alarm is not None or tried.blocks != len(self.lines) + len(lines):
            return False
        self.lines = [*self.lines, *lines]
        self.now = tried
        return True

    def add_where(self, right: Callable[[Machine], bool], *lines: str) -> bool:
        """Add blocks, unless the control refuses them or what comes of them is not right; `right`
        is asked with the machine that stood before them.
        """
        before = self.lines, self.now
        if self.add(*lines) and right(before[1]):
            return True
        self.lines, self.now = before
        return False

    def add_mode(self, name: str, texts: Iterable[str]) -> bool:
        """Add the first of the texts that puts a mode in force as the state has it, and leaves the
        position as it is.
        """
        wanted = self.state.modal[name]

        def right(before: Machine) -> bool:
            in_force = self.modal.get(name) == wanted
            return in_force and (name in BENDING or self.stands_still(before))

        return any(self.add_where(right, *text.split("\n")) for text in texts if text)

    def repeat(self, lines: Iterable[str]) -> bool:
        """Add blocks of the run that the next one may depend on, where they make no move."""
        lines = list(lines)
        return bool(lines) and self.add_where(self.stands_still, *lines)

    def stands_still(self, before: Machine) -> bool:
        """Return whether the tool stands where it stood, and went nowhere on the way."""
        here = before.position
        if any(abs(self.now.position.get(a, 0.0) - value) > self.near for a, value in here.items()):
            return False
        moves = self.now.moves
        return all(moves[i].length < self.near for i in range(len(before.moves), len(moves)))

    def changed(self, mode: str) -> bool:
        """Return whether the run has changed a mode before the place."""
        return self.before.block_that_changed(mode) is not None

    def used(self, mode: str) -> bool:
        """Return whether a mode is another one at the place than at power-on."""
        return self.state.modal.get(mode) != self.power_on.get(mode)

    def in_force(self, name: str) -> bool:
        """Return whether a mode is as the state has it. One that is not told any more is of the
        group of another: G97 after G94 on a SINUMERIK.
        """
        wanted, now = self.state.modal.get(name), self.modal.get(name)
        return now == wanted or (now is None and wanted == self.power_on.get(name))

    def blocks(self) -> Iterator[Any]:
        """Yield the blocks of the library."""
        for program in self.library.values():
            yield from program.blocks

    def writes(self, code: int) -> bool:
        """Return whether a block of the library has a G code."""
        return any(
            word.address == "G" and word.value == code
            for block in self.blocks()
            for word in block.words
        )

    def is_of_group(self, word: Any, group: str) -> bool:
        """Return whether a word is a G code of a group."""
        if word.address != "G" or word.value is None:
            return False
        machine = self.setup.machine or ""
        return group_of(self.library.control, f"G{word.value:g}", machine) == group

    def codes_of_group(self, group: str) -> list[str]:
        """Return the G codes of a group that the programs have, as `modal` has them."""
        words = (word for block in self.blocks() for word in block.words)
        codes = (f"G{w.value:02g}" for w in words if self.is_of_group(w, group))
        return list(dict.fromkeys(codes))

    def words(self, line: str) -> Iterator[Any]:
        """Yield the words of a block that is given as a text."""
        library = self.library.of_text(f"{line}\n", self.library.control)
        for program in library.values():
            for block in program.blocks:
                yield from block.words

    def words_of(self, step: int) -> list[Any]:
        """Return the words that the block of a step was in a program without calls."""
        return [word for line in self.before.flat_text(step) for word in self.words(line)]

    def text(self, axis: str, value: float, digits: int | None = None) -> str:
        """Return a coordinate in mm as a word has it, in the units in force: exactly, or with so
        many digits after the point.
        """
        if self.now.core.inch and axis not in _ROTARY:
            value /= _INCH
        most = digits or 10
        if self.used("polar"):  # the polar words say it exactly, and come after
            most, digits = 3, None
        exact = (n for n in range(3, most + 1) if abs(round(value, n) - value) < 1e-10)
        places = next(exact, digits or 4)
        whole, _, part = f"{round(value, places) + 0.0:.{places}f}".partition(".")
        return f"{whole}.{part.rstrip('0')}"

    def note(self, text: str) -> None:
        """Tell whoever starts the program something, once."""
        if text not in self.notes:
            self.notes.append(text)


def coordinate(move: Any, axis: str) -> float:
    """Return the machine coordinate of the end of a move."""
    return machine_coordinate(move, axis) or 0.0


def stands_at(machine: Machine, aim: dict[str, float], most: float | None = None) -> bool:
    """Return whether the tool stands at machine coordinates, exactly or within so many mm."""
    near = nearness(machine.core.code.control) if most is None else most
    if not len(machine.moves):
        return False
    here = machine.moves[-1]
    return all(abs(coordinate(here, axis) - value) < near for axis, value in aim.items())
