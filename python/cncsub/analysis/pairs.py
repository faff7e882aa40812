"""Two runs side by side: the first difference between them, and what each does there."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from cncsub._core import Alarm, Control, variable_name
from cncsub.analysis.first_difference import alike, column_of, first_difference
from cncsub.interrupts import uninterrupted
from cncsub.run_options import FlattenOptions, idle_machine

if TYPE_CHECKING:
    from cncsub.analysis.first_difference import Column
    from cncsub.library import Library
    from cncsub.run import Run

LISTS = {"m_codes": "M code", "t_codes": "T code", "messages": "message"}
_WATCHED = 1000  # variables that can be watched at once
_CALLS = ("kind", "program", "start_n", "repeats", "level")
_NEAR = 1e-9  # s
_NEAR_LENGTH = 1e-6  # mm
_CUTS = ("feed", "cw", "ccw", "thread")
_ONLY_OF = {"feed": _CUTS, "feed_mode": _CUTS, "plane": ("cw", "ccw")}  # kinds of moves
# Not compared of moves: the block that makes them, and what follows from the other columns where X
# means the same.
_NOT_COMPARED = ("move", "step", "length", "time", "program", "n", "line")
_END_CODE = re.compile(r"\bM0*(\d+)=end\b")


# Of several columns that differ in a move, the first of these is named, else one of the others.
_NAMED_FIRST = ("kind", "plane")
_KINDS = {
    "rapid": "a rapid",
    "feed": "a line at the feed",
    "cw": "an arc, clockwise",
    "ccw": "an arc, counter-clockwise",
    "thread": "a thread",
    "dwell": "a dwell",
}


class Parting(NamedTuple):
    """The point where two runs part: a step of each, or the count of steps where a run has none.

    `column`: where it is a move that differs, the column that does.
    """

    first: int
    second: int
    what: str
    column: str = ""


def _move_text(run: Run, at: int, column: str) -> str:
    """Return what a move does, by the column that differs."""
    if at >= len(run.moves):
        return "no further move"
    value = getattr(run.moves[at], column, None)
    shown = f"{value:g}" if isinstance(value, float) else value
    if column == "kind":
        return f"move {at} is {_KINDS.get(str(value), shown)}"
    if column == "plane":
        return f"move {at} is in the plane of G{shown}"
    if re.fullmatch(r"m?c[xyz]", column):
        return f"move {at} has {'no ' + column if value is None else f'{column} = {shown}'}"
    if column in ("feed", "feed_mode", "spindle"):
        return f"move {at} has the {column.replace('_', ' ')} {shown}"
    if value is None:
        return f"move {at} has no {column}"
    goes = re.fullmatch(r"m?[xyzabcuvw]", column) is not None
    return f"move {at} {'goes to' if goes else 'has'} {column} = {shown}"


def _side(run: Run, at: int, does: str) -> str:
    """Return what a run does at a step, or that it has stopped without doing it."""
    if at >= len(run.steps):
        stopped = run.summary()
        if not does:
            return f"stopped: {stopped}"
        return f"{does} until {'the end' if stopped == 'end' else stopped}"
    step = run.steps[at]
    n = "" if step.n is None else f" N{step.n}"
    return f"{step.program}{n}, line {step.line}{': ' if does else ''}{does}"


class Pair:
    """Two libraries, and how they are run."""

    _of_a_call: tuple[str, ...] = _CALLS

    def __init__(
        self,
        libraries: tuple[Library, Library],
        names: tuple[str, str],
        main: str | int | None,
        options: FlattenOptions,
    ) -> None:
        self.libraries = libraries
        self.names = names
        self._main = main
        self._options = options

    def run(self, library: Library, **more: Any) -> Run:
        return uninterrupted(library.run(self._main, **{**self._options, **more}))

    def runs(self) -> tuple[Run, Run]:
        return self.run(self.libraries[0]), self.run(self.libraries[1])

    def parting(self, a: Run, b: Run) -> Parting | None:
        """Return the earliest of all differences."""
        found = list(self._partings(a, b))
        return min(found, key=lambda p: (min(p.first, p.second), p.first, p.second), default=None)

    def watched(self, a: Run, b: Run) -> tuple[Run, Run]:
        """Run both once more, with the variables watched that hold a value in one of them."""
        numbers = self._shared_variables(a, b)[:_WATCHED]
        one, other = (self.run(library, watch=numbers) for library in self.libraries)
        return one, other

    def _partings(self, a: Run, b: Run) -> Iterator[Parting]:
        yield from self._of_calls(a, b)
        yield from self._of_moves(a, b)
        for name in LISTS:
            yield from self._of_list(a, b, name)
        yield from self._of_variables(a, b)
        yield from self._of_stop(a, b)

    def _say(self, runs: tuple[Run, Run], at: tuple[int, int], does: tuple[str, str]) -> Parting:
        sides = zip(self.names, runs, at, does, strict=True)
        lines = (f"{name}: {_side(run, step, text)}" for name, run, step, text in sides)
        return Parting(*at, "\n".join(lines))

    def _of_calls(self, a: Run, b: Run) -> Iterator[Parting]:
        called = [self._called(run, library) for run, library in zip((a, b), self.libraries)]
        columns = [
            (column_of(a.calls, name, called[0]), column_of(b.calls, name, called[1]))
            for name in self._of_a_call
        ]
        at = first_difference(columns)
        if at is None:
            return
        steps, does = [], []
        for run in (a, b):
            call = run.calls[at] if at < len(run.calls) else None
            steps.append(len(run.steps) if call is None else call.caller_step)
            does.append(
                "no further call"
                if call is None
                else f"{call.kind} {call.program}{_start(call.start_n)}, {call.repeats} pass"
                + ("es" if call.repeats != 1 else "")
            )
        yield self._say((a, b), (steps[0], steps[1]), (does[0], does[1]))

    def _called(self, run: Run, library: Library) -> dict[str, str] | None:
        """Return what the programs that a run calls are compared by, where it is not
        their names.
        """
        return None

    def _moved(self, run: Run, name: str) -> Column:
        """Return a column of the moves, as it is compared."""
        return column_of(run.moves, name)

    def _sent(self, run: Run, library: Library, name: str) -> Sequence[object]:
        """Return one of the lists of a run, as it is compared."""
        return list(getattr(run, name))

    def _of_moves(self, a: Run, b: Run) -> Iterator[Parting]:
        names = list(dict.fromkeys([*_NAMED_FIRST, *a.moves.columns, *b.moves.columns]))
        apart = {
            name: at
            for name in names
            if name not in _NOT_COMPARED
            and (at := first_difference([(self._moved(a, name), self._moved(b, name))])) is not None
        }
        if not apart:
            return
        which = min(apart, key=lambda name: apart[name])
        at = apart[which]
        steps = [
            int(run.moves.step[at]) if at < len(run.moves) else len(run.steps) for run in (a, b)
        ]
        does = _move_text(a, at, which), _move_text(b, at, which)
        yield self._say((a, b), (steps[0], steps[1]), does)._replace(column=which)

    def _of_list(self, a: Run, b: Run, name: str) -> Iterator[Parting]:
        """Yield the first difference of lists that grow during a run. The step is found by shorter
        and shorter runs.
        """
        both = self.libraries
        lists = (self._sent(a, both[0], name), self._sent(b, both[1], name))
        count = min(len(lists[0]), len(lists[1]))
        at = next((i for i in range(count) if lists[0][i] != lists[1][i]), count)
        if at == len(lists[0]) == len(lists[1]):
            return
        steps, does = [], []
        for library, run, values in zip(self.libraries, (a, b), lists, strict=True):
            there = at < len(values)
            steps.append(self._step_of(library, run, name, at) if there else len(run.steps))
            if not there:
                does.append(f"no further {LISTS[name]}")
            else:
                value = values[at]
                does.append(
                    f"message {value!r}" if name == "messages" else f"{name[0].upper()}{value}"
                )
        yield self._say((a, b), (steps[0], steps[1]), (does[0], does[1]))

    def _step_of(self, library: Library, run: Run, name: str, at: int) -> int:
        low, high = 0, len(run.steps)
        while low < high:
            middle = (low + high) // 2
            if len(self._sent(self.run(library, max_blocks=middle + 1), library, name)) > at:
                high = middle
            else:
                low = middle + 1
        return low

    def _shared_variables(self, a: Run, b: Run) -> list[int]:
        """Return the numbers that both have and that hold a value in one of them. Where a control
        lists a variable by a number that the other has not, the numbers that the programs write
        count too.
        """
        held = {n for run in (a, b) for n, value in run.variables.items() if value is not None}
        if not all(_has(a, n) and _has(b, n) for n in held):
            held |= {n for library in self.libraries for n in _written(library)}
        return [n for n in sorted(held) if _has(a, n) and _has(b, n)]

    def _of_variables(self, a: Run, b: Run) -> Iterator[Parting]:
        numbers = [
            number
            for number in self._shared_variables(a, b)
            if not alike(a.variables[number], b.variables[number])
        ]
        if not numbers:
            return
        watched = [self.run(library, watch=numbers[:_WATCHED]).watch for library in self.libraries]
        names = ("variable", "value")
        at = first_difference([(watched[0][name], watched[1][name]) for name in names])
        if at is None:  # the values at the beginning differ
            at = 0
        steps, does = [], []
        for run, rows in zip((a, b), watched, strict=True):
            row = rows[at] if at < len(rows) else None
            steps.append(len(run.steps) if row is None or row.step is None else row.step)
            shown = "vacant" if row is None or row.value is None else f"{row.value:g}"
            name = "" if row is None else variable_name(run.recorded.control, row.variable)
            does.append(f"{name} = {shown}" if name else "no further change")
        yield self._say((a, b), (steps[0], steps[1]), (does[0], does[1]))

    def _of_stop(self, a: Run, b: Run) -> Iterator[Parting]:
        def stop(run: Run) -> tuple[object, ...]:
            alarm = run.alarm
            if alarm is None:
                return (run.stop, run.waiting_for)
            return (run.stop, run.waiting_for, alarm.cause, alarm.n, *self._place(alarm))

        if stop(a) != stop(b):
            yield self._say((a, b), (len(a.steps), len(b.steps)), ("", ""))

    def _place(self, alarm: Alarm) -> tuple[object, ...]:
        """Return where an alarm was raised, as it is compared."""
        return (alarm.program,)


class OtherControlPair(Pair):
    """A program and its rewriting for another control. Blocks and programs may differ; moves,
    codes, messages and stop have to stay.
    """

    def _moved(self, run: Run, name: str) -> Column:
        """Return a column without what makes no difference to a move and is not the same at
        power-on: the feed of a rapid, the plane of a straight move.
        """
        column = super()._moved(run, name)
        if name not in _ONLY_OF or not len(column):
            return column
        kinds = [run.moves.kinds[code] for code in run.moves.kind.tolist()]
        counts = [kind in _ONLY_OF[name] for kind in kinds]
        taken: Column = column.copy()
        taken[[not count for count in counts]] = 0
        return taken

    def _sent(self, run: Run, library: Library, name: str) -> Sequence[object]:
        """Return a list without the codes that end a program. The stop is compared, and controls
        differ in which of these codes they send to the machine.
        """
        sent = super()._sent(run, library, name)
        if name != "m_codes":
            return sent
        ends = _end_codes(library.control)
        return [code for code in sent if code not in ends]

    def _of_moves(self, a: Run, b: Run) -> Iterator[Parting]:
        """Yield the differences of the moves. Where coordinates are the same and lengths are not, X
        counts otherwise: X of a mill is no diameter.
        """
        found = list(super()._of_moves(a, b))
        yield from found
        count = min(len(a.moves), len(b.moves))
        apart = abs(a.moves.length[:count] - b.moves.length[:count]) > _NEAR_LENGTH
        if found or not apart.any():
            return
        at = int(apart.argmax())
        steps = (int(a.moves.step[at]), int(b.moves.step[at]))
        does = [f"move {at} is {run.moves.length[at]:g} mm long" for run in (a, b)]
        yield self._say((a, b), steps, (does[0], does[1]))

    def _partings(self, a: Run, b: Run) -> Iterator[Parting]:
        yield from self._of_moves(a, b)
        for name in LISTS:
            yield from self._of_list(a, b, name)
        yield from self._of_dwells(a, b)
        causes = [run.alarm.cause if run.alarm is not None else "" for run in (a, b)]
        if (a.stop, a.waiting_for, causes[0]) != (b.stop, b.waiting_for, causes[1]):
            yield self._say((a, b), (len(a.steps), len(b.steps)), ("", ""))

    def _of_dwells(self, a: Run, b: Run) -> Iterator[Parting]:
        at = _other_dwell(a, b)
        if at is not None:
            steps = (int(a.moves.step[at]), int(b.moves.step[at]))
            yield self._say((a, b), steps, (f"move {at}", f"move {at}, a dwell with another time"))


def _end_codes(control: Control) -> frozenset[int]:
    """Return the M codes that end a program."""
    roles = next((str(rule.value) for rule in control.rules if rule.name == "roles"), "")
    return frozenset(int(found) for found in _END_CODE.findall(roles))


def _other_dwell(a: Run, b: Run) -> int | None:
    """Return the first dwell that is not as long. A dwell has a time and no length, unlike
    a rapid.
    """
    moves = [run.moves for run in (a, b)]
    if len(moves[0]) != len(moves[1]) or not all("dwell" in table.kinds for table in moves):
        return None  # or the moves differ, which is reported before
    apart = abs(moves[0].time - moves[1].time) > _NEAR
    apart &= moves[0].kind == moves[0].kinds.index("dwell")
    return int(apart.argmax()) if apart.any() else None


def variables_lacking(control: Control, given: Mapping[int, float | None]) -> list[int]:
    """Return the given variables that a control does not have."""

    def lacks(number: int) -> bool:
        try:
            idle_machine(control, variables={number: given[number]})
        except ValueError:
            return True
        return False

    return [number for number in given if lacks(number)]


def _start(n: int | None) -> str:
    return "" if n is None else f" from N{n}"


def _written(library: Library) -> Iterator[int]:
    """Yield the numbers of the variables that blocks write."""
    for program in library.values():
        for block in program.blocks:
            for use in block.writes:
                if isinstance(use.variable, int):
                    yield use.variable


def _has(run: Run, number: int) -> bool:
    """Return whether the control has the variable."""
    try:
        run.variables[number]
    except KeyError:
        return False
    return True
