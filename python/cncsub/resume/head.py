"""The head of a restart program: the blocks that bring a machine into the state of a run."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING, Any

from cncsub.resume.errors import ResumeError, place_text, refused
from cncsub.resume.history import Before
from cncsub.resume.state import RestartState, roles_of

if TYPE_CHECKING:
    from cncsub.library import Library
    from cncsub.machine import Machine

_INCH = 25.4
_DIGITS = 10  # of a value of `modal`: one that has as many may have more
_NEAR = 1e-9  # mm
_ROTARY = "ABC"
# Modes that a head cancels before it moves, by their codes at power-on; and those that it writes.
_CANCELLED = ("radius", "cycle", "scaling", "rotation", "polar", "mirror")
_BENDING = _CANCELLED[2:]
_WRITTEN = ("units", "plane", "feed_mode")
_WORDS = ("F", "S", "T", "H", "D")
_DATA = (10, 10.1, 10.9, 52, 92)  # the G codes that set data
_CLAMPS = (50, 92)  # those that set the highest speed of the spindle beside S
_PLANES = {"G17": "XY", "G18": "ZX", "G19": "YZ"}  # [ISO 6983-1]
# Modes that a block may have to say itself: where the head cannot, the proof shows whether it has.
_SOFT = ("motion", "cycle")


class Head:
    """The blocks of a head, each of which has been run by the control."""

    def __init__(
        self, library: Library, machine: Machine, state: RestartState, options: dict[str, Any]
    ) -> None:
        self._library = library
        self._machine = machine
        self._state = state
        self._options = {
            **options,
            "trace": "moves",
            "max_cycles": 1,
            "start": None,
        }
        self.lines: list[str] = []
        self.lacks: list[str] = []  # what could not be put in force
        self.now = self._run([])
        self._power_on = dict(self.now.modal)

    def _run(self, lines: list[str]) -> Machine:
        text = "".join(f"{line}\n" for line in lines)
        library = self._library.of_text(f"{text}M30\n", self._library.control)
        machine = library.machine(**{**self._options, "max_blocks": len(lines)})
        machine.run()
        return machine

    def add(self, *lines: str) -> bool:
        """Add blocks, unless the control refuses them; return whether it took them."""
        tried = self._run([*self.lines, *lines])
        if tried.alarm is not None or tried.blocks != len(self.lines) + len(lines):
            return False
        self.lines = [*self.lines, *lines]
        self.now = tried
        return True

    def _add_where(self, right: Callable[[Machine], bool], *lines: str) -> bool:
        """Add blocks, unless the control refuses them or what comes of them is not right; `right`
        is asked with the machine that stood before them.
        """
        before = self.lines, self.now
        if self.add(*lines) and right(before[1]):
            return True
        self.lines, self.now = before
        return False

    def _add_for(self, name: str, texts: Iterable[str]) -> bool:
        """Add the first of the texts that puts a mode in force as the state has it, and leaves the
        position as it is.
        """
        wanted = self._state.modal[name]

        def right(before: Machine) -> bool:
            in_force = self.now.modal.get(name) == wanted
            return in_force and (name in _BENDING or self._stays(before))

        return any(self._add_where(right, text) for text in texts)

    def _stays(self, before: Machine) -> bool:
        """Return whether the tool stands where it stood, and went nowhere on the way."""
        here = before.position
        if any(abs(self.now.position.get(a, 0.0) - value) > _NEAR for a, value in here.items()):
            return False
        moves = self.now.moves
        return all(moves[i].length < _NEAR for i in range(len(before.moves), len(moves)))

    # ---- what stands in it, in its order ----

    def modes_before_moves(self) -> None:
        """Write units, plane and feed mode, cancel what bends a path, and choose absolute values
        and the work offset.
        """
        modal = self._state.modal
        codes = [modal[name] for name in _WRITTEN if name in modal]
        codes += [
            code
            for name in _CANCELLED
            if (code := self._power_on.get(name)) and (name in _CANCELLED[:2] or self._used(name))
        ]
        codes += ["G90"] if "distance" in modal else []
        for code in codes:
            self._add_if_right(code)
        self._join(codes)
        if "work" in modal:
            self.add(modal["work"])

    def _add_if_right(self, code: str) -> None:
        """Add a code, unless it changes a mode that is right without it: a control may count the
        feed and the surface speed as one group.
        """
        wanted = self._state.modal
        keep = [
            name
            for name, mode in self.now.modal.items()
            if mode == wanted.get(name) and name != "distance" and name not in _CANCELLED
        ]
        self._add_where(
            lambda before: all(self.now.modal.get(name) == wanted[name] for name in keep), code
        )

    def _used(self, mode: str) -> bool:
        return self._state.modal.get(mode) != self._power_on.get(mode)

    def _join(self, codes: list[str]) -> None:
        """Write the codes as one block, where the control takes them so with the same effect."""
        joined = self._run([" ".join(self.lines)])
        if joined.alarm is None and dict(joined.modal) == dict(self.now.modal):
            self.lines = [" ".join(self.lines)] if codes else []
            self.now = joined

    def variables(self, *, commons: bool) -> None:
        """Write the values of the variables that no call has of its own: those of the control that
        differ and, where they are asked for, those that programs may use as they like.
        """
        machine, fresh = self._machine, self.now
        of_main = machine.variables.level(0)
        lines = []
        for number in self._numbers():
            value = of_main[number]
            free = machine.core.can_be_vacant(number)
            if (free and not commons) or (
                value == fresh.variables[number] and (value is None or not free)
            ):
                continue
            if not machine.core.follows_time(number) and _settable(fresh, number, value):
                lines.append(machine.core.assignment(number, value))
        if lines and not self.add(*lines):
            wrong = next(line for line in lines if not self.add(line))
            raise refused(f"the control takes no block {wrong!r}", self._state.block)

    def _numbers(self) -> Iterator[int]:
        known = sorted(self._machine.variables.level(0))
        yield from known
        core = self._machine.core
        if not any(_sets_data(core, block) for block in self._blocks()):
            return
        seen = set(known)
        for number in range(1000, 20000):
            if number in seen or not _can_be_read(core.code, number):
                continue
            if _reads(self._machine, number) != _reads(self.now, number):
                yield number

    def _blocks(self) -> Iterator[Any]:
        for program in self._library.values():
            yield from program.blocks

    def tool(self) -> None:
        state = self._state
        if state.tool is not None:
            digits = str(state.tool)
            lathe = "Y" not in self._machine.position
            word = f"T{'0' * (lathe and len(digits) > 2 and len(digits) % 2)}{digits}"
            changes = roles_of(self._machine).get("tool-change", ())
            used = [code for code in changes if code in self._machine.m_codes]
            change = f" M{used[0]:02d}" if used else ""
            if not self.add(f"{word}{change}") and not self.add(word, change.strip()):
                raise refused(f"the control takes no block '{word}{change}' here", state.block)
        chosen = state.modal.get("T")
        if chosen is not None and self.now.modal.get("T") != chosen:
            self.add(f"T{chosen}")

    def spindle(self) -> None:
        state = self._state
        speed = state.modal.get("S", "0")
        turn = f" {state.spindle}" if state.spindle else ""
        code = state.modal.get("surface")
        first = f"{code} " if code and self.now.modal.get("surface") != code else ""
        if speed != "0" or turn:
            word = f"S{speed}" if speed != "0" else ""
            self.add(f"{first}{word}{turn}".strip())
        for coolant in state.coolant:
            self.add(coolant)

    def approach(self, safe: float | None, order: tuple[str, ...] | None) -> None:
        """Move to where the run stands: to the safe height, then axis by axis of the order."""
        if not len(self._machine.moves):
            return
        aim = self._machine.moves[-1]
        axes = [axis for axis in self._machine.position if _at(aim, axis) is not None]
        mill = "Y" in axes
        if mill and "Z" in axes:
            self._retract(safe)
        groups = order or (() if mill else ("Z", "X"))
        left = "".join(axis for axis in axes if axis not in "".join(groups))
        for group in (*groups, left.replace("Z", ""), "Z"):
            self._go({axis: _at(aim, axis) or 0.0 for axis in group if axis in axes})

    def _retract(self, safe: float | None) -> None:
        """Go up, with the length of the tool."""
        height = safe
        if height is None:
            height = float(max(self._machine.moves.z.max(), self._machine.position["Z"]))
        length = self._state.modal.get("length", "")
        code = f" {length} H{self._state.modal['H']}" if self._has_length() else ""
        value = self._text("Z", height)
        if not self.add(f"G00{code} Z{value}"):
            self.add(f"G00 Z{value}")

    def _has_length(self) -> bool:
        return self._used("length") and self._state.modal.get("H", "0") != "0"

    def _text(self, axis: str, value: float) -> str:
        """Return a coordinate in mm as a word has it."""
        if self.now.core.inch and axis not in _ROTARY:
            value /= _INCH
        places = next((n for n in range(3, 11) if abs(round(value, n) - value) < 1e-10), 4)
        whole, _, part = f"{value:.{places}f}".partition(".")
        return f"{whole}.{part.rstrip('0')}"

    def _go(self, aim: dict[str, float]) -> None:
        """Move axes to machine coordinates, by the words that lead there."""
        if not aim or _near(self.now, aim):
            return
        words = {axis: self._machine.position[axis] for axis in aim}
        line = ""
        for _ in range(3):
            texts = (f"{axis}{self._text(axis, value)}" for axis, value in words.items())
            line = f"G00 {' '.join(texts)}"
            tried = self._run([*self.lines, line])
            if tried.alarm is not None or not len(tried.moves) or _near(tried, aim):
                break
            here = tried.moves[-1]
            words = {axis: words[axis] + aim[axis] - (_at(here, axis) or 0.0) for axis in aim}
        self.add(line)

    def shift(self) -> None:
        """Put the shift of the work coordinates in force that the program has set."""
        wanted = self._state.position
        here = self.now.position
        off = {axis: here[axis] - wanted[axis] for axis in wanted if axis in here}
        if all(abs(each) < _NEAR for each in off.values()) or self._used("rotation"):
            return
        by = " ".join(f"{axis}{self._text(axis, value)}" for axis, value in off.items() if value)
        to = " ".join(
            f"{axis}{self._text(axis, wanted[axis])}" for axis, value in off.items() if value
        )
        used = [code for code in (52, 92, 50) if self._writes(code)]
        for code in used:
            if self._shifts(f"G{code} {by if code == 52 else to}"):
                return
        self._shifts(f"TRANS {by}")

    def _writes(self, code: int) -> bool:
        return any(
            word.address == "G" and word.value == code
            for block in self._blocks()
            for word in block.words
        )

    def repeat(self, lines: Iterable[str]) -> bool:
        """Add blocks of the run that the next one may depend on, where they make no move."""
        lines = list(lines)
        return bool(lines) and self._add_where(self._stays, *lines)

    def _shifts(self, line: str) -> bool:
        wanted = self._state.position

        def right(before: Machine) -> bool:
            here = self.now.position
            unmoved = len(self.now.moves) == len(before.moves)
            return unmoved and all(abs(here[axis] - wanted[axis]) < _NEAR for axis in wanted)

        return self._add_where(right, line)

    def clamp(self, before: Before) -> None:
        """Write the highest speed of the spindle that the program has set last."""
        found = before.last_executed(_sets_clamp)
        if found is not None:
            words = [word for line in before.flat_text(found) for word in self._words(line)]
            wanted = [w.text for w in words if w.address == "S" or w.value in _CLAMPS]
            self.repeat([" ".join(wanted)])

    def modes_after_moves(self, before: Before) -> None:
        """Put in force what the run has in force; raise `ResumeError` where that cannot be."""
        modal = self._state.modal
        late = [name for name in modal if len(name) > 1 and name not in ("motion", "distance")]
        for name in (*late, *_WORDS, "distance", "motion"):
            if name not in modal or self.now.modal.get(name) == modal[name]:
                continue
            if not self._add_for(name, self._texts_for(name, before)):
                lacking = self._lacking(name, before)
                if name not in _SOFT:
                    raise lacking
                self.lacks.append(lacking.reason)

    def _texts_for(self, name: str, before: Before) -> Iterator[str]:
        code = self._state.modal[name]
        found = None if name in _WORDS and len(code) < _DIGITS else before.block_that_changed(name)
        if name in _WORDS:
            lines = before.flat_text(found[1]) if found is not None else []
            words = [word for line in lines for word in self._words(line) if word.address == name]
            yield from (word.text for word in words)
            yield from (f"{name}{code}", f"{name}{code}.")
            return
        if name == "cycle" and found is not None:
            data = self._cycle_data(before.flat_text(found[1], self._state.step))
            yield from (f"{data} K0", f"{data} L0")
            return
        yield code
        if found is None:
            return
        yield from before.flat_text(found[1])

    def _cycle_data(self, lines: list[str]) -> str:
        """Return the words of a cycle's blocks that stay in force, the last of each address."""
        of_place = _PLANES.get(self._state.modal.get("plane", ""), "")
        kept: dict[str, str] = {}
        for word in (word for line in lines for word in self._words(line)):
            if word.address not in ("G", "N", "O", "K", "L", "M", "T", "S", *of_place):
                kept[word.address] = word.text
        return " ".join([self._state.modal["cycle"], *kept.values()])

    def _words(self, line: str) -> Iterator[Any]:
        library = self._library.of_text(f"{line}\n", self._library.control)
        for program in library.values():
            for block in program.blocks:
                yield from block.words

    def _lacking(self, name: str, before: Before) -> ResumeError:
        code = self._state.modal[name]
        found = before.block_that_changed(name)
        shown = f"{name}{code}" if name in _WORDS else f"{code} ({name})"
        since = (
            f"; it is in force since {place_text(found[0])}: start there"
            if found is not None
            else ""
        )
        return refused(f"{shown} cannot be put in force without a move{since}", self._state.block)


def _at(move: Any, axis: str) -> float | None:
    value = getattr(move, f"m{axis.lower()}", None)
    if value is None:
        value = getattr(move, axis.lower(), None)
    return None if value is None else float(value)


def _near(machine: Machine, aim: dict[str, float]) -> bool:
    """Return whether the tool stands at machine coordinates."""
    if not len(machine.moves):
        return False
    here = machine.moves[-1]
    return all(abs((_at(here, axis) or 0.0) - value) < _NEAR for axis, value in aim.items())


def _reads(machine: Machine, number: int) -> float | None:
    try:
        return machine.core.get_variable(number)
    except (KeyError, ValueError):
        return None


def _can_be_read(code: Any, number: int) -> bool:
    """Return whether the control has a variable that can be read: asking is ten times as fast as
    reading in vain, and most numbers are none.
    """
    facts = code.variable_facts(number)
    return facts is not None and facts[1]


def _settable(machine: Machine, number: int, value: float | None) -> bool:
    try:
        machine.core.copy().set_variable(number, value, 0)
    except (KeyError, ValueError):
        return False
    return True


def _sets_clamp(block: Any) -> bool:
    words = block.words
    return any(w.address == "S" for w in words) and any(
        w.address == "G" and w.value in _CLAMPS for w in words
    )


def _sets_data(core: Any, block: Any) -> bool:
    """Return whether a block may set what the control keeps: offsets, and variables of its own."""
    if any(word.address == "G" and word.value in _DATA for word in block.words):
        return True
    return any(
        not isinstance(use.variable, int) or not core.can_be_vacant(use.variable)
        for use in block.writes
    )
