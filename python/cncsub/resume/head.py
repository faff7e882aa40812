"""The head of a restart program: the blocks that bring a machine into the state of a run."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING, Any

from cncsub.resume.errors import ResumeError, place_text, refused
from cncsub.resume.history import Before
from cncsub.resume.start import Known, Starts, given_setup, machine_coordinate
from cncsub.resume.state import RestartState, group_of, roles_of

if TYPE_CHECKING:
    from cncsub.library import Library
    from cncsub.machine import Machine

_INCH = 25.4
_DIGITS = 10  # of a value of `modal`: one that has as many may have more
_NEAR = 1e-9  # mm
_REACHED = 0.01  # mm: words of a head that have so many digits
_ROTARY = "ABC"
_HOME = (28, 30)
_INCREMENTS = {"X": "U", "Y": "V", "Z": "W"}  # of a lathe
_AIR = ("rapid", "dwell")  # the kinds of moves that do not cut
_FEEDS = ("per-minute", "per-revolution")  # those that mean the same in another move
_CUT = 100_000  # moves of one cut that are looked at
# Modes that a head cancels before it moves, by their codes at power-on; and those that it writes.
_CANCELLED = ("radius", "cycle", "scaling", "rotation", "polar", "mirror")
_BENDING = _CANCELLED[2:]
# Modes that an aborted run may have left otherwise: a head writes them where the run has.
_LEFT = ("surface", "return", "path", "stroke")
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
        self,
        library: Library,
        machine: Machine,
        state: RestartState,
        starts: Starts,
        before: Before,
        options: dict[str, Any],
    ) -> None:
        self._library = library
        self._machine = machine
        self._state = state
        self._starts = starts
        self._before = before
        self._setup = given_setup(options)
        self._shifted_first: set[str] = set()  # the axes whose place it has said at the start
        self._references: dict[str, float | None] = {}
        self._commanded: set[str] = set()  # the axes that the head has moved
        self._options = {
            **options,
            "trace": "moves",
            "max_cycles": 1,
            "start": None,
        }
        self.lines: list[str] = []
        self.lacks: list[str] = []  # what could not be put in force
        self.notes: list[str] = []  # what whoever starts it should know
        self.now = self._run([])
        self._power_on = dict(self.now.modal)
        self._lathe = self._power_on.get("plane", "G18") == "G18"

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

        return any(self._add_where(right, *text.split("\n")) for text in texts if text)

    def _stays(self, before: Machine) -> bool:
        """Return whether the tool stands where it stood, and went nowhere on the way."""
        here = before.position
        if any(abs(self.now.position.get(a, 0.0) - value) > _NEAR for a, value in here.items()):
            return False
        moves = self.now.moves
        return all(moves[i].length < _NEAR for i in range(len(before.moves), len(moves)))

    # ---- what stands in it, in its order ----

    def modes_before_moves(self, *, units_late: bool) -> None:
        """Write units, plane and feed mode, cancel what bends a path, and choose absolute values
        and the work offset. `units_late`: the head moves in the units of power-on.
        """
        modal = self._state.modal
        moving = {**modal, "units": self._power_on["units"]} if units_late else modal
        codes = [moving[name] for name in _WRITTEN if name in modal]
        codes += [
            code
            for name in _CANCELLED
            if (code := self._power_on.get(name))
            and (name in _CANCELLED[:2] or self._used(name) or self._changed(name))
        ]
        if "length" in modal and not self._used("length"):
            codes.append(modal["length"])  # of the tool before
        codes += ["G90"] if "distance" in modal else []
        for code in codes:
            self._add_if_right(code)
        self._join(codes)
        if "work" in modal and not self.add(modal["work"]):
            raise refused(f"the control takes no block '{modal['work']}' here", self._state.block)
        self._modes_left()

    def _modes_left(self) -> None:
        """Write the modes that are as at power-on at the place, but were otherwise in the run."""
        for name in _LEFT:
            code = self._state.modal.get(name)
            if code is not None and code == self._power_on.get(name) and self._changed(name):
                self._add_for(name, [code])

    def _changed(self, mode: str) -> bool:
        """Return whether the run has changed a mode before the place."""
        return self._before.block_that_changed(mode) is not None

    def _add_if_right(self, code: str) -> None:
        """Add a code, unless it changes a mode that is right without it: a control may count the
        feed and the surface speed as one group.
        """
        keep = [
            name
            for name, mode in self.now.modal.items()
            if mode == self._state.modal.get(name) and name != "distance" and name not in _CANCELLED
        ]
        self._add_where(lambda before: all(self._in_force(name) for name in keep), code)

    def _in_force(self, name: str) -> bool:
        """Return whether a mode is as the state has it. One that is not told any more is of the
        group of another: G97 after G94 on a SINUMERIK.
        """
        wanted, now = self._state.modal.get(name), self.now.modal.get(name)
        return now == wanted or (now is None and wanted == self._power_on.get(name))

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
            word = f"T{'0' * (self._lathe and len(digits) > 2 and len(digits) % 2)}{digits}"
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
        told = "surface" in self.now.modal
        written = code and ((self._lathe and told) or not self._in_force("surface"))
        first = f"{code} " if written else ""
        if speed != "0" or turn:
            word = f"S{speed}" if speed != "0" else ""
            self.add(f"{first}{word}{turn}".strip())
        for coolant in state.coolant:
            self.add(coolant)

    def offsets(self) -> None:
        """Choose the edge of the tool, where D does that: no axis may move before."""
        edge = self._state.modal.get("D", "0")
        if "length" not in self._power_on and self.now.modal.get("D", edge) != edge:
            self.add(f"D{edge}")

    def approach(
        self, height: float | None, order: tuple[str, ...] | None, *, bends_first: bool
    ) -> None:
        """Move to where the run stands: to a height (machine coordinate, mm), bend the path as the
        run does, then axis by axis of the order.
        """
        if not len(self._machine.moves):
            self.bend()
            self.polar()
            return
        aim = self._machine.moves[-1]
        axes = [
            axis
            for axis in self._machine.position
            if machine_coordinate(aim, axis) is not None and self._can_move(axis)
        ]
        if not self._lathe and "Z" in axes and height is not None:
            self._retract(height)
        else:
            self._put_length_in_force()
        if bends_first:
            self.bend()
        self._go_across(aim, axes, order)

    def _go_across(self, aim: Any, axes: list[str], order: tuple[str, ...] | None) -> None:
        chosen = order or (("Z", "X") if self._lathe else ())
        left = "".join(axis for axis in axes if axis not in "".join(chosen))
        every = (*chosen, left.replace("Z", ""))
        named = ("".join(axis for axis in group if axis in axes) for group in every)
        groups = [group for group in named if group]
        if "Z" in left:
            groups.append("Z")
        for index, group in enumerate(groups):
            wanted = {axis: _at(aim, axis) for axis in group}
            last = index == len(groups) - 1
            if not (last and self._cut_in(wanted)) and not self._go(wanted):
                self.lacks.append(f"the head cannot move {' and '.join(wanted)} to the place")
            self._tell_between(wanted)
        self.polar()

    def _tell_between(self, wanted: dict[str, float]) -> None:
        """Tell where an axis stands that no word leads to: the run came there in other units or
        through a rotation.
        """
        for axis, value in wanted.items():
            if not _near(self.now, {axis: value}) and _near(self.now, {axis: value}, _REACHED):
                self.lacks.append(
                    f"{axis} stands at {self._machine.position[axis]:.9g}, between the increments"
                    " of the control"
                )

    def _cut_in(self, wanted: dict[str, float]) -> bool:
        """Move the last axes with the feed of the run, where the run came to the place with it:
        material may be in the way. Above the height from which it has cut Z goes with rapid.
        """
        moves = self._machine.moves
        feed = self._state.modal.get("F", "0")
        if moves[-1].kind in _AIR or feed in ("0", ""):
            return False
        if moves[-1].feed_mode not in _FEEDS:
            return False
        if set(wanted) == {"Z"} and (above := self._height_of_cut()) > wanted["Z"]:
            self._go({"Z": above})
        if _near(self.now, wanted) and set(wanted) <= self._commanded:
            return True
        return any(self._go(wanted, "G01", text) for text in self._texts_for("F"))

    def _height_of_cut(self) -> float:
        """Return the highest machine Z that the run has come to since its last rapid."""
        moves = self._machine.moves
        top = -math.inf
        for index in range(len(moves) - 1, max(-1, len(moves) - _CUT), -1):
            move = moves[index]
            if move.kind in _AIR:
                break
            top = max(top, _at(move, "Z"), float(getattr(move, "msz", top)))
        return top

    def _can_move(self, axis: str) -> bool:
        """Return whether the head can move an axis to the place: not where its place depends on
        where the run began. Raises `ResumeError` where it has left that.
        """
        starts = self._starts
        if not starts.stands_at_start(axis) and starts.offsets(axis) is Known.NEITHER:
            raise refused(
                f"{axis} stands where a block under other offsets has left it, and the setup does"
                " not give these offsets: give them, or a place after a block that moves"
                f" {axis} under the present ones",
                self._state.block,
            )
        if not starts.machine_depends(axis):
            return True
        if not starts.has_moved(axis):
            self._note(f"the head does not move {axis}: the run has not moved it before")
            return False
        if starts.work_depends(axis) or axis not in self._shifted_first:
            raise refused(
                f"where {axis} stands depends on where the run begins: give the start of {axis} in"
                f" a setup (start = {{{axis} = ...}}), or a place after a block that moves it to a"
                " coordinate",
                self._state.block,
            )
        return True

    def _note(self, text: str) -> None:
        if text not in self.notes:
            self.notes.append(text)

    def _retract(self, height: float) -> None:
        """Go up, with the length of the tool."""
        leads = self._length_words() if self._has_length() else [""]
        for lead in leads:
            if self._go({"Z": height}, f"G00 {lead}".strip()) and self._length_is_right():
                return
        self._put_length_in_force()
        if not self._go({"Z": height}):
            raise refused(
                "the control takes no move to the safe height; give another one"
                " (safe_height, --safe-height)",
                self._state.block,
            )

    def _length_words(self) -> list[str]:
        modal = self._state.modal
        found = self._before.block_that_changed("length")
        lines = [] if found is None else self._before.flat_text(found[1])
        own = (word for line in lines for word in self._words(line))
        kept = [w.text for w in own if w.address == "H" or f"{w.text}" == modal["length"]]
        return [f"{modal['length']} H{modal['H']}", " ".join(kept)]

    def _length_is_right(self) -> bool:
        return all(
            self.now.modal.get(name) == self._state.modal.get(name) for name in ("length", "H")
        )

    def _put_length_in_force(self) -> None:
        """Put the length of the tool in force before any axis moves: without it the tool would go
        too deep.
        """
        if not self._has_length() or self._length_is_right():
            return
        for words in self._length_words():
            if words and self._add_where(lambda _: self._length_is_right(), words):
                return
        raise refused(
            f"{self._state.modal['length']} H{self._state.modal['H']} cannot be put in force before"
            " the head moves",
            self._state.block,
        )

    def _has_length(self) -> bool:
        return self._used("length") and self._state.modal.get("H", "0") != "0"

    def _text(self, axis: str, value: float) -> str:
        """Return a coordinate in mm as a word has it."""
        if self.now.core.inch and axis not in _ROTARY:
            value /= _INCH
        most = 4 if self._used("polar") else 11  # the polar words say it exactly, and come after
        places = next((n for n in range(3, most) if abs(round(value, n) - value) < 1e-10), 4)
        whole, _, part = f"{round(value, places) + 0.0:.{places}f}".partition(".")
        return f"{whole}.{part.rstrip('0')}"

    def _go(self, aim: dict[str, float], lead: str = "G00", tail: str = "") -> bool:
        """Move axes to machine coordinates, by the words that lead there, with others before and
        after them. Return whether they stand there then.
        """
        if not aim or (_near(self.now, aim) and set(aim) <= self._commanded):
            return True
        of_machine = {a: at for a, at in aim.items() if self._is_of_machine(a, at)}
        if of_machine:
            others = {axis: at for axis, at in aim.items() if axis not in of_machine}
            return self._go_in_machine(of_machine) and self._go(others, lead, tail)
        line = self._line_to(aim, lead)
        if tail:
            line = f"{line} {tail}"
        if not self._add_where(lambda _: _near(self.now, aim, _REACHED), line):
            return False
        self._commanded |= set(aim)
        return True

    def _is_of_machine(self, axis: str, value: float) -> bool:
        """Return whether only a machine coordinate leads where the run stands."""
        known = self._starts.offsets(axis)
        return known is Known.MACHINE or self._at_reference(axis, value)

    def _at_reference(self, axis: str, value: float) -> bool:
        """Return whether a block of the run has sent an axis to the reference point, it has not
        moved since, and that is the machine coordinate asked for.
        """
        if axis not in self._references:
            step = self._before.last_executed(lambda block: _goes_home(block, axis))
            self._references[axis] = self._stays_since(axis, step)
        there = self._references[axis]
        return there is not None and abs(there - value) < _NEAR

    def _stays_since(self, axis: str, step: int | None) -> float | None:
        moves = self._machine.moves
        if step is None or not len(moves):
            return None
        here = _at(moves[-1], axis)
        for index in range(len(moves) - 1, -1, -1):
            if abs(_at(moves[index], axis) - here) > _NEAR:
                return None
            if moves[index].step <= step:
                return here
        return here

    def _go_in_machine(self, aim: dict[str, float]) -> bool:
        """Move axes whose machine coordinate alone is known, as after G28: offsets that are not
        given may be anything.
        """
        self._put_length_in_force()  # G28 may suspend it, as it has in the run
        texts = " ".join(f"{axis}{self._text(axis, value)}" for axis, value in aim.items())
        zeros = " ".join(f"{axis}0." for axis in aim)
        home = [f"G91 G28 {zeros}", "G90"]
        if self._lathe:
            home = [f"G28 {' '.join(f'{_INCREMENTS.get(axis, axis)}0.' for axis in aim)}"]
        direct = [f"G53 G00 {texts}"]
        by_home = all(self._at_reference(axis, value) for axis, value in aim.items())
        for lines in (home, direct) if by_home else (direct, home):
            if self._add_where(lambda _: _near(self.now, aim), *lines):
                self._commanded |= set(aim)
                return True
        raise refused(
            f"{' and '.join(aim)} can only be given as a machine coordinate, which the head cannot"
            " write here: give the offsets of work and tools in a setup, or another place",
            self._state.block,
        )

    def _line_to(self, aim: dict[str, float], lead: str) -> str:
        """Return the block that moves axes to machine coordinates: first with the words that the
        run has, then with those that lead there from where they led.
        """
        words = {axis: self._machine.position[axis] for axis in aim}
        line = self._rapid(words, lead)
        for _ in range(2):
            tried = self._run([*self.lines, line])
            if tried.alarm is not None or not len(tried.moves) or _near(tried, aim):
                break
            words = self._solved(words, aim, lead, tried)
            line = self._shortest(words, aim, lead)
        return line

    def _shortest(self, words: dict[str, float], aim: dict[str, float], lead: str) -> str:
        """Return the block with the fewest digits that leads to machine coordinates, else all."""
        line = ""
        for digits in (3, 4, 6, 10):
            rounded = {axis: round(value, digits) + 0.0 for axis, value in words.items()}
            line = self._rapid(rounded, lead)
            if _near(self._run([*self.lines, line]), aim):
                break
        return line

    def _rapid(self, words: dict[str, float], lead: str) -> str:
        texts = (f"{axis}{self._text(axis, value)}" for axis, value in words.items())
        return " ".join([lead, *texts])

    def _solved(
        self, words: dict[str, float], aim: dict[str, float], lead: str, tried: Machine
    ) -> dict[str, float]:
        """Return the words that lead to machine coordinates: each axis tells how it moves the
        others, as mirror images, scales and rotations want it.
        """
        import numpy as np

        here = np.array([_at(tried.moves[-1], axis) for axis in aim])
        columns = []
        for axis in aim:
            line = self._rapid({**words, axis: words[axis] + 1}, lead)
            there = self._run([*self.lines, line])
            if there.alarm is not None or not len(there.moves):
                columns = list(np.eye(len(aim)))
                break
            columns.append(np.array([_at(there.moves[-1], each) for each in aim]) - here)
        try:
            by = np.linalg.solve(np.array(columns).T, np.array(list(aim.values())) - here)
        except np.linalg.LinAlgError:
            return words
        return {axis: round(words[axis] + float(d), 10) for axis, d in zip(aim, by, strict=True)}

    def bend(self) -> None:
        """Bend the path as the run does: rotation, scaling, mirror image and frames, by the blocks
        of the run that did so.
        """
        for name in _BENDING:
            if name == "polar" or name not in self._state.modal or not self._used(name):
                continue
            found = self._before.block_that_changed(name)
            for step in self._before.steps_with(found[1] if found else 0, self._of_group(name)):
                self._add_where(lambda _: True, *self._before.flat_text(step))
        for step in self._before.frame_steps():
            self._add_where(lambda _: True, *self._before.flat_text(step))

    def _of_group(self, name: str) -> Callable[[Any], bool]:
        """Return what asks whether a block has a code of a group."""
        control = self._library.control
        machine = "" if self._setup.machine is None else self._setup.machine

        def asked(block: Any) -> bool:
            codes = (
                f"G{w.value:g}" for w in block.words if w.address == "G" and w.value is not None
            )
            return any(group_of(control, code, machine) == name for code in codes)

        return asked

    def polar(self) -> None:
        """Put polar coordinates in force, with the last radius and angle of the run."""
        if "polar" not in self._state.modal or not self._used("polar"):
            return
        found = self._before.block_that_changed("polar")
        if found is None:
            return
        begins, *lines = self._before.flat_text(found[1], self._state.step) or [""]
        of_plane = _PLANES.get(self._state.modal.get("plane", ""), "")
        kept = {w.address: w.text for line in lines for w in self._words(line)}
        if not len(self._machine.moves):
            self._add_where(lambda _: True, begins)
            return
        words = " ".join(kept[axis] for axis in of_plane if axis in kept)
        aim = {axis: _at(self._machine.moves[-1], axis) for axis in of_plane}
        if self._add_where(lambda _: True, begins) and words:
            self._add_where(lambda _: _near(self.now, aim, _REACHED), f"G00 {words}")

    def shift_first(self) -> None:
        """Write where the tool stands, as the run has done, where only that gives axes a place."""
        starts = self._starts
        axes = [a for a in self._state.position if starts.says_where(a)]
        if not axes:
            return
        words = " ".join(f"{axis}{self._text(axis, starts.start_in_work(axis))}" for axis in axes)
        for code in (92, 50):
            line = f"G{code} {words}"
            if self._writes(code) and self._add_where(
                lambda _: all(
                    abs(self.now.position[a] - starts.start_in_work(a)) < _NEAR for a in axes
                ),
                line,
            ):
                self._shifted_first |= set(axes)
                self._note(f"start it where the program starts: {line} says where the tool stands")
                return

    def shift(self) -> None:
        """Put the shift of the work coordinates in force that the program has set."""
        wanted = self._state.position
        here = self.now.position
        off = {axis: here[axis] - wanted[axis] for axis in wanted if axis in here}
        if all(abs(each) < _NEAR for each in off.values()) or self._used("rotation"):
            return
        shifted = [axis for axis, value in off.items() if abs(value) > _NEAR]
        by = " ".join(f"{axis}{self._text(axis, off[axis])}" for axis in shifted)
        to = " ".join(f"{axis}{self._text(axis, wanted[axis])}" for axis in shifted)
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

    def clamp(self) -> None:
        """Write the highest speed of the spindle that the program has set last."""
        found = self._before.last_executed(_sets_clamp)
        if found is not None:
            words = [word for line in self._before.flat_text(found) for word in self._words(line)]
            wanted = [w.text for w in words if w.address == "S" or w.value in _CLAMPS]
            self.repeat([" ".join(wanted)])

    def modes_after_moves(self) -> None:
        """Put in force what the run has in force; raise `ResumeError` where that cannot be."""
        modal = self._state.modal
        last = ("motion", "distance", "cycle")
        late = [name for name in modal if len(name) > 1 and name not in last]
        order = (*late, *_WORDS, "cycle", "distance", "motion")
        if self._used("cycle"):  # a code of motion would end the cycle
            order = (*late, "motion", "cycle", *_WORDS, "distance")
        for name in order:
            if name not in modal or self._in_force(name):
                continue
            if not self._add_for(name, self._texts_for(name)):
                lacking = self._lacking(name)
                if name not in _SOFT:
                    raise lacking
                self.lacks.append(lacking.reason)

    def _texts_for(self, name: str) -> Iterator[str]:
        code = self._state.modal[name]
        found = (
            None
            if name in _WORDS and len(code) < _DIGITS
            else self._before.block_that_changed(name)
        )
        if name in _WORDS:
            lines = self._before.flat_text(found[1]) if found is not None else []
            words = [word for line in lines for word in self._words(line) if word.address == name]
            yield from (word.text for word in words)
            yield from (f"{name}{code}", f"{name}{code}.")
            return
        if name == "cycle" and found is not None:
            data = self._cycle_data(self._before.flat_text(found[1], self._state.step))
            lead = self._rigid_before(found[1])
            chosen = self._before.block_that_changed("distance")
            if chosen is not None and chosen[1] <= found[1]:
                lead += f"{self._state.modal['distance']} "  # its data may be increments
            yield from (f"{lead}{data} {count}" for count in ("K0", "L0"))
            return
        if name in _BENDING and found is not None:
            return  # a code of these says nothing without its words
        yield code
        if found is None:
            return
        yield from self._before.flat_text(found[1])

    def _rigid_before(self, step: int) -> str:
        """Return the block that made the tapping cycle of a step rigid; empty where none did."""
        roles = roles_of(self._machine)
        moves = self._machine.moves.step
        for code in reversed(list(self._machine.codes)):
            if code.step > step or code.kind != "M":
                continue
            if ((moves >= code.step) & (moves < step)).any():
                return ""
            if code.value in roles.get("rigid-tapping", ()):
                words = self._words_of(code.step)
                return " ".join(w.text for w in words if w.address in "MS") + "\n"
        return ""

    def _words_of(self, step: int) -> list[Any]:
        return [word for line in self._before.flat_text(step) for word in self._words(line)]

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

    def _lacking(self, name: str) -> ResumeError:
        code = self._state.modal[name]
        found = self._before.block_that_changed(name)
        shown = f"{name}{code}" if name in _WORDS else f"{code} ({name})"
        since = (
            f"; it is in force since {place_text(found[0])}: start there"
            if found is not None
            else ""
        )
        return refused(f"{shown} cannot be put in force without a move{since}", self._state.block)


def _at(move: Any, axis: str) -> float:
    return machine_coordinate(move, axis) or 0.0


def _near(machine: Machine, aim: dict[str, float], most: float = _NEAR) -> bool:
    """Return whether the tool stands at machine coordinates."""
    if not len(machine.moves):
        return False
    here = machine.moves[-1]
    return all(abs(_at(here, axis) - value) < most for axis, value in aim.items())


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


def _goes_home(block: Any, axis: str) -> bool:
    words = block.words
    goes = any(w.address == "G" and w.value in _HOME for w in words)
    return goes and any(w.address in (axis, _INCREMENTS.get(axis)) for w in words)


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
