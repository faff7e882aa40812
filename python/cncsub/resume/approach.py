"""The way of the tool in a restart's head, to where the run stands."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from cncsub.resume.draft import REACHED, Draft, coordinate, stands_at
from cncsub.resume.errors import refused
from cncsub.resume.frames import bend, polar
from cncsub.resume.modes import texts_for
from cncsub.resume.start import Known, machine_coordinate
from cncsub.resume.tool import has_length, length_is_right, length_words, put_length_in_force

if TYPE_CHECKING:
    from cncsub.machine import Machine

_HOME = (28, 30)
_INCREMENTS = {"X": "U", "Y": "V", "Z": "W"}  # of a lathe
_AIR = ("rapid", "dwell")  # the kinds of moves that do not cut
_FEEDS = ("per-minute", "per-revolution")  # those that mean the same in another move


class Approach:
    """The moves of a head. `said`: the axes whose place the head has said where it starts.
    `mixes_units`: an axis moves in other units where those in force do not lead to its place.
    """

    def __init__(self, draft: Draft, said: set[str], *, mixes_units: bool) -> None:
        self._draft = draft
        self._mixes_units = mixes_units
        self._machine, self._state = draft.machine, draft.state
        self._starts, self._before = draft.starts, draft.before
        self._said = said
        self._references: dict[str, float | None] = {}
        self._commanded: set[str] = set()  # the axes that the head has moved

    def go(self, height: float | None, order: tuple[str, ...] | None, *, bends_first: bool) -> None:
        """Move to where the run stands: to a height (machine coordinate, mm), bend the path as the
        run does, then axis by axis of the order.
        """
        if not len(self._machine.moves):
            bend(self._draft)
            polar(self._draft)
            return
        aim = self._machine.moves[-1]
        axes = [
            axis
            for axis in self._machine.position
            if machine_coordinate(aim, axis) is not None and self._can_move(axis)
        ]
        if not self._draft.lathe and "Z" in axes and height is not None:
            self._retract(height)
        else:
            put_length_in_force(self._draft)
        if bends_first:
            bend(self._draft)
        self._go_across(aim, axes, order)

    def stay_in_frame(self) -> None:
        """Go with all axes to where the tool stands, in a frame that has come after the moves: an
        increment counts from where an axis has gone in its frame.
        """
        if not (self._draft.frames and len(self._machine.moves)):
            return
        aim = {
            axis: value
            for axis in self._commanded
            if (value := machine_coordinate(self._machine.moves[-1], axis)) is not None
        }
        if aim:
            line = self._line_to(aim, "G00")
            self._draft.add_where(self._draft.stands_still, line)

    def _go_across(self, aim: Any, axes: list[str], order: tuple[str, ...] | None) -> None:
        chosen = order or (("Z", "X") if self._draft.lathe else ())
        left = "".join(axis for axis in axes if axis not in "".join(chosen))
        every = (*chosen, left.replace("Z", ""))
        named = ("".join(axis for axis in group if axis in axes) for group in every)
        groups = [group for group in named if group]
        if "Z" in left:
            groups.append("Z")
        for index, group in enumerate(groups):
            wanted = {axis: coordinate(aim, axis) for axis in group}
            last = index == len(groups) - 1
            if not (last and self._cut_in(wanted)) and not self._go(wanted):
                self._draft.lacks.append(
                    f"the head cannot move {' and '.join(wanted)} to the place"
                )
            self._settle(wanted)
        polar(self._draft)

    def _settle(self, wanted: dict[str, float]) -> None:
        """Bring axes to where no word in the units in force leads exactly, where units are mixed.
        Tell what stands between the increments: the run came there in other units, or through a
        rotation.
        """
        now = self._draft.now
        between = {
            axis: value
            for axis, value in wanted.items()
            if not stands_at(now, {axis: value}) and stands_at(now, {axis: value}, REACHED)
        }
        if not between or self._go_in_other_units(between):
            return
        for axis, value in between.items():
            if not self._go_in_other_units({axis: value}):
                self._draft.lacks.append(
                    f"{axis} stands at {self._machine.position[axis]:.9g}, between the increments"
                    " of the control"
                )

    def _go_in_other_units(self, aim: dict[str, float]) -> bool:
        """Move axes in other units of the run; return whether they stand there exactly then."""
        if not self._mixes_units:
            return False
        draft = self._draft
        before = draft.lines, draft.now
        here = draft.modal.get("units", "")
        for code in draft.codes_of_group("units"):
            if (
                code != here
                and draft.add(code)
                and draft.add_where(lambda _: stands_at(draft.now, aim), self._line_to(aim, "G00"))
                and draft.add(here)
            ):
                return True
            draft.lines, draft.now = before
        return False

    def _cut_in(self, wanted: dict[str, float]) -> bool:
        """Move the last axes with the feed of the run, where a cut has brought the tool or one of
        these axes there: material may be in the way. Z goes with rapid down to the height from
        which the run has gone down with feed.
        """
        if self._state.modal.get("F", "0") in ("0", "") or not self._came_with_feed(wanted):
            return False
        if self._machine.moves[-1].feed_mode not in _FEEDS:
            return False
        if set(wanted) == {"Z"} and (above := self._height_of_descent()) > wanted["Z"]:
            self._go({"Z": above})
        if stands_at(self._draft.now, wanted) and set(wanted) <= self._commanded:
            return True
        return any(self._go(wanted, "G01", text) for text in texts_for(self._draft, "F"))

    def _came_with_feed(self, axes: Iterable[str]) -> bool:
        """Return whether the last move was a cut, or the last one of an axis was."""
        air = self._in_air()
        if not air[-1]:
            return True
        moved = (self._moves(axis).nonzero()[0] for axis in axes)
        return any(len(rows) and not air[rows[-1]] for rows in moved)

    def _height_of_descent(self) -> float:
        """Return the highest machine Z that the run has come to since its last rapid of Z."""
        moves = self._machine.moves
        rapids = (self._in_air() & self._moves("Z")).nonzero()[0]
        if len(rapids):
            return float(moves.mz[rapids[-1] :].max())
        return max(float(moves.msz[0]), float(moves.mz.max()))

    def _in_air(self) -> Any:
        """Return of each move of the run whether it does not cut."""
        import numpy as np

        moves = self._machine.moves
        return np.isin(moves.kind, [moves.kinds.index(kind) for kind in _AIR])

    def _moves(self, axis: str) -> Any:
        """Return of each move of the run whether it moves an axis."""
        import numpy as np

        moves = self._machine.moves
        ends = np.asarray(moves[f"m{axis.lower()}"], float)
        starts = np.concatenate([[self._starts.machine_start(axis)], ends[:-1]])
        return ~(np.abs(ends - starts) <= self._draft.near)

    def _can_move(self, axis: str) -> bool:
        """Return whether the head can move an axis to the place: not where its place depends on
        where the run began. Raises `ResumeError` where it has left that.
        """
        if not self._starts.stands_at_start(axis) and self._starts.offsets(axis) is Known.NEITHER:
            raise refused(
                f"{axis} stands where a block under other offsets has left it, and the setup does"
                " not give these offsets: give them, or a place after a block that moves"
                f" {axis} under the present ones",
                self._state.block,
            )
        if not self._starts.machine_depends(axis):
            return True
        if not self._starts.has_moved(axis):
            self._draft.note(f"the head does not move {axis}: the run has not moved it before")
            return False
        if self._starts.work_depends(axis) or axis not in self._said:
            raise refused(
                f"where {axis} stands depends on where the run begins: give the start of {axis} in"
                f" a setup (start = {{{axis} = ...}}), or a place after a block that moves it to a"
                " coordinate",
                self._state.block,
            )
        return True

    def _retract(self, height: float) -> None:
        """Go up, with the length of the tool."""
        leads = length_words(self._draft) if has_length(self._draft) else [""]
        for lead in leads:
            if self._go({"Z": height}, f"G00 {lead}".strip()) and length_is_right(self._draft):
                return
        put_length_in_force(self._draft)
        if not self._go({"Z": height}):
            raise refused(
                "the control takes no move to the safe height; give another one"
                " (safe_height, --safe-height)",
                self._state.block,
            )

    def _go(self, aim: dict[str, float], lead: str = "G00", tail: str = "") -> bool:
        """Move axes to machine coordinates, by the words that lead there, with others before and
        after them. Return whether they stand there then.
        """
        if not aim or (stands_at(self._draft.now, aim) and set(aim) <= self._commanded):
            return True
        of_machine = {a: at for a, at in aim.items() if self._is_of_machine(a, at)}
        if of_machine:
            others = {axis: at for axis, at in aim.items() if axis not in of_machine}
            return self._go_in_machine(of_machine) and self._go(others, lead, tail)
        line = self._line_to(aim, lead)
        if tail:
            line = f"{line} {tail}"
        if not self._draft.add_where(lambda _: stands_at(self._draft.now, aim, REACHED), line):
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
        return there is not None and abs(there - value) < self._draft.near

    def _stays_since(self, axis: str, step: int | None) -> float | None:
        moves = self._machine.moves
        if step is None or not len(moves):
            return None
        here = coordinate(moves[-1], axis)
        for index in range(len(moves) - 1, -1, -1):
            if abs(coordinate(moves[index], axis) - here) > self._draft.near:
                return None
            if moves[index].step <= step:
                return here
        return here

    def _go_in_machine(self, aim: dict[str, float]) -> bool:
        """Move axes whose machine coordinate alone is known, as after G28: offsets that are not
        given may be anything.
        """
        put_length_in_force(self._draft)  # G28 may suspend it, as it has in the run
        texts = " ".join(f"{axis}{self._draft.text(axis, value)}" for axis, value in aim.items())
        zeros = " ".join(f"{axis}0." for axis in aim)
        home = [f"G91 G28 {zeros}", "G90"]
        if self._draft.lathe:
            home = [f"G28 {' '.join(f'{_INCREMENTS.get(axis, axis)}0.' for axis in aim)}"]
        direct = [f"G53 G00 {texts}"]
        by_home = all(self._at_reference(axis, value) for axis, value in aim.items())
        for lines in (home, direct) if by_home else (direct, home):
            if self._draft.add_where(lambda _: stands_at(self._draft.now, aim), *lines):
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
            tried = self._draft.run([*self._draft.lines, line])
            if tried.alarm is not None or not len(tried.moves) or stands_at(tried, aim):
                break
            words = self._solved(words, aim, lead, tried)
            line = self._shortest(words, aim, lead)
        return line

    def _shortest(self, words: dict[str, float], aim: dict[str, float], lead: str) -> str:
        """Return the block with the fewest digits that leads to machine coordinates; where none
        does, that with those of the control's increment.
        """
        lines = {digits: self._rapid(words, lead, digits) for digits in (3, 4, 6, 10)}
        exact = (
            line
            for line in lines.values()
            if stands_at(self._draft.run([*self._draft.lines, line]), aim)
        )
        return next(exact, lines[4])

    def _rapid(self, words: dict[str, float], lead: str, digits: int | None = None) -> str:
        texts = (f"{axis}{self._draft.text(axis, value, digits)}" for axis, value in words.items())
        return " ".join([lead, *texts])

    def _solved(
        self, words: dict[str, float], aim: dict[str, float], lead: str, tried: Machine
    ) -> dict[str, float]:
        """Return the words that lead to machine coordinates: each axis tells how it moves the
        others, as mirror images, scales and rotations want it.
        """
        import numpy as np

        here = np.array([coordinate(tried.moves[-1], axis) for axis in aim])
        columns = []
        for axis in aim:
            line = self._rapid({**words, axis: words[axis] + 1}, lead)
            there = self._draft.run([*self._draft.lines, line])
            if there.alarm is not None or not len(there.moves):
                columns = list(np.eye(len(aim)))
                break
            columns.append(np.array([coordinate(there.moves[-1], each) for each in aim]) - here)
        try:
            by = np.linalg.solve(np.array(columns).T, np.array(list(aim.values())) - here)
        except np.linalg.LinAlgError:
            return words
        return {axis: round(words[axis] + float(d), 10) for axis, d in zip(aim, by, strict=True)}


def _goes_home(block: Any, axis: str) -> bool:
    words = block.words
    goes = any(w.address == "G" and w.value in _HOME for w in words)
    return goes and any(w.address in (axis, _INCREMENTS.get(axis)) for w in words)
