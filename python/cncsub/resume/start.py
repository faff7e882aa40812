"""What of a run depends on data that nobody gave: where axes start, offsets of work and tools."""

from __future__ import annotations

import dataclasses
import enum
import functools
import itertools
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from cncsub.run_options import idle_machine
from cncsub.setup import Setup, setup_from, work_system

if TYPE_CHECKING:
    from cncsub._core import Control
    from cncsub.library import Library
    from cncsub.machine import Machine
    from cncsub.program import Block
    from cncsub.run import Run

_SHIFT = 0.005  # mm: small enough for the ends of an arc to agree still
_NEAR = 1e-9  # mm
_COARSE = 1e-4  # mm: the same where numbers have 32 bits


def nearness(control: Control) -> float:
    """Return within how many mm two coordinates of a control are the same."""
    return _COARSE if control.precision else _NEAR


_SYSTEMS = ("G54", "G55", "G56", "G57", "G58", "G59")


class CheckedSetup(Setup):
    """A setup that nobody changes: it is checked when it is made, and not again for each of the
    many runs of a restart.
    """

    def __post_init__(self) -> None:
        object.__setattr__(self, "_core", Setup.to_core(self))

    def to_core(self) -> dict[str, Any]:
        core: dict[str, Any] = self._core  # type: ignore[attr-defined]
        return core


def given_setup(options: Mapping[str, Any]) -> Setup:
    """Return the setup among the options of a run, an empty one where there is none."""
    given = options.get("setup")
    if given is None:
        return CheckedSetup()
    if isinstance(given, CheckedSetup):
        return given
    setup = given if isinstance(given, Setup) else setup_from(given)
    return CheckedSetup(**{f.name: getattr(setup, f.name) for f in dataclasses.fields(Setup)})


def with_start(options: dict[str, Any], start: Mapping[str, float]) -> dict[str, Any]:
    """Return the options of a run whose axes start elsewhere (work coordinates, mm)."""
    setup = given_setup(options)
    return {**options, "setup": dataclasses.replace(setup, start={**setup.start, **start})}


def machine_coordinate(move: Any, axis: str) -> float | None:
    value = getattr(move, f"m{axis.lower()}", None)
    if value is None:
        value = getattr(move, axis.lower(), None)
    return None if value is None else float(value)


def _position_at(machine: Machine, step: int, axis: str) -> float:
    """Return the work coordinate that an axis had at a step of a machine that has run."""
    there = machine.copy()
    there.core.remember()
    there.back(step)
    value: float = there.position[axis]
    return value


class Known(enum.Enum):
    """In which coordinates the place of an axis is known, whatever the offsets are."""

    BOTH = "both"
    WORK = "work"
    MACHINE = "machine"
    NEITHER = "neither"


class Starts:
    """Which axes stand at a place where the start of the run puts them. The run is made again with
    the axes elsewhere: what is the same then does not depend on the start.
    """

    def __init__(
        self,
        library: Library,
        main: str | int | None,
        options: dict[str, Any],
        whole: Run,
        machine: Machine,
        chosen: str = "",
    ) -> None:
        self._near = nearness(library.control)
        self._chosen = chosen  # axes whose start is the place that a head gives them
        self._library, self._main, self._options = library, main, options
        self._whole, self._machine = whole, machine
        self._shifted: tuple[Machine | None] | None = None  # the run with other offsets
        fresh = library.machine(main, **{**options, "max_blocks": 0})
        given = {axis.upper() for axis in given_setup(options).start}
        self.at_start = dict(fresh.position)
        self._open = [axis for axis in machine.position if axis not in given]
        together = self._again(self._open)
        self._others = {
            axis: together if together is not None else self._again([axis]) for axis in self._open
        }

    def _again(self, axes: list[str]) -> Machine | None:
        start = {axis: self.at_start.get(axis, 0.0) + _SHIFT for axis in axes}
        return self._with(with_start(self._options, start))

    def _with(self, options: dict[str, Any]) -> Machine | None:
        """Return the machine of the same run with another setup; `None` where that run is another
        one.
        """
        machine = self._library.machine(self._main, **options)
        run = machine.run()
        if run is None or run.stop != self._whole.stop or machine.blocks != len(self._whole.steps):
            return None
        return machine if len(run.moves) == len(self._whole.moves) else None

    def machine_depends(self, axis: str) -> bool:
        """Return whether the machine coordinate of an axis at the place depends on its start."""
        if axis not in self._others:
            return False
        count = len(self._machine.moves)
        other = self._others[axis]
        if other is None or not count:
            return True
        here = machine_coordinate(self._machine.moves[count - 1], axis)
        there = machine_coordinate(other.moves[count - 1], axis)
        return here is None or there is None or abs(here - there) > self._near

    def work_depends(self, axis: str) -> bool:
        """Return whether its work coordinate does."""
        if axis not in self._others:
            return False
        if (other := self._others[axis]) is None:
            return True
        here: float = self._machine.position[axis]
        return abs(_position_at(other, self._machine.blocks, axis) - here) > self._near

    def says_where(self, axis: str) -> bool:
        """Return whether a block of the run says where an axis stands, and only the start of the
        run gives it a place on the machine.
        """
        return self.machine_depends(axis) and not self.work_depends(axis) and axis in self._others

    def start_in_work(self, axis: str) -> float:
        """Return the start of an axis in the work coordinates of the place."""
        moves = self._machine.moves
        here: float = self._machine.position[axis]
        if not len(moves):
            return here
        first, last = self.machine_start(axis), machine_coordinate(moves[-1], axis)
        return here + (first or 0.0) - (last or 0.0)

    def machine_start(self, axis: str) -> float | None:
        """Return where an axis stood before the first move, a machine coordinate; `None` where that
        is not known.
        """
        first = self._machine.moves[0]
        value = getattr(first, f"ms{axis.lower()}", getattr(first, f"s{axis.lower()}", None))
        return None if value is None else float(value)

    def has_moved(self, axis: str) -> bool:
        """Return whether an axis stands elsewhere than at the start."""
        moves = self._machine.moves
        if not len(moves):
            return False
        first = self.machine_start(axis)
        last = machine_coordinate(moves[-1], axis)
        return first is None or last is None or abs(first - last) > self._near

    def highest(self) -> float | None:
        """Return the highest machine Z of the run that is known; `None` where none is. Offsets that
        the setup does not give may be anything on a machine: they, too, are changed. What is known
        is known by itself, or in its distance from the place.
        """
        import numpy as np

        moves = self._whole.moves
        if not len(moves) or "mz" not in moves.columns:
            return None
        values = np.asarray(moves.mz, float)
        count = len(self._machine.moves)
        place = machine_coordinate(self._machine.moves[count - 1], "Z") if count else 0.0
        if self.stands_at_start("Z") and self.offsets("Z") is not Known.BOTH:
            return None
        other = self._with(self._other_offsets(["Z"], starts=True))
        if other is None:
            return None if self.machine_depends("Z") else place
        apart = np.asarray(other.moves.mz, float) - values
        of_place = 0.0 if self.stands_at_start("Z") else apart[count - 1]
        known = np.abs(apart - of_place) < self._near
        return float(values[known].max()) if known.any() else None

    def offsets(self, axis: str) -> Known:
        """Return in which coordinates the place of an axis is known: offsets of work and tools that
        the setup does not give may be anything on a machine.
        """
        count = len(self._machine.moves)
        if axis in self._chosen:
            return Known.BOTH
        if self._shifted is None:
            axes = list(self._machine.position)
            self._shifted = (self._with(self._other_offsets(axes, starts=False)),)
        if (other := self._shifted[0]) is None or not count:
            return Known.BOTH
        here = machine_coordinate(self._machine.moves[count - 1], axis) or 0.0
        there = machine_coordinate(other.moves[count - 1], axis) or 0.0
        of_machine = there - here
        of_work = _position_at(other, self._machine.blocks, axis) - self._machine.position[axis]
        if abs(of_machine - of_work) < self._near and self._names_system():
            return Known.BOTH
        if abs(of_work) < self._near:
            return Known.WORK
        return Known.MACHINE if abs(of_machine) < self._near else Known.NEITHER

    def _names_system(self) -> bool:
        """Return whether a setup can give the work offset in force at the place, such as not G59.1
        of LinuxCNC: what it is on the machine is not known.
        """
        name = self._machine.modal.get("work", _SYSTEMS[0])
        _, numbered, number = name.partition(" P")
        system = f"G54.1 P{number}" if numbered else name
        return _has(self._library.control, system)

    def stands_at_start(self, axis: str) -> bool:
        """Return whether an axis stands where the run began, and that is not given."""
        return self.machine_depends(axis) and not self.has_moved(axis)

    def _other_offsets(self, axes: Sequence[str], *, starts: bool) -> dict[str, Any]:
        """Return the options of the run with other offsets, where the setup does not give them;
        `starts`: with another start of Z, too.
        """
        setup = given_setup(self._options)
        shifts = (_SHIFT * step for step in itertools.count(1))
        start = dict(setup.start)
        if starts and "Z" in self._open:
            start["Z"] = self.at_start.get("Z", 0.0) + next(shifts)
        given = {work_system("work", name): at for name, at in setup.work_offsets.items()}
        systems: dict[str, Any] = {**{name: {} for name in systems_of(self._library)}, **given}
        work = {
            name: {**{axis: next(shifts) for axis in axes}, **values}
            for name, values in systems.items()
        }
        moves = self._whole.moves
        numbers = sorted({int(n) for name in ("h", "tool") for n in set(moves[name].tolist())})
        lengths = {n: next(shifts) for n in numbers if 0 < n < 10_000}
        for number in (*setup.length_offsets, *setup.tools):
            lengths.pop(int(number), None)  # keys of a file are texts
        changed = dataclasses.replace(
            setup,
            start=start,
            work_offsets=work,
            length_offsets={**lengths, **setup.length_offsets},
        )
        return {**self._options, "setup": changed}


def systems_of(library: Library) -> list[str]:
    """Return the work offsets that programs may use, as far as the control has them."""
    named = set(_SYSTEMS)
    for program in library.values():
        for block in program.blocks:
            named |= set(_systems_in(block))
    return [name for name in sorted(named) if _has(library.control, name)]


@functools.cache
def _has(control: Control, name: str) -> bool:
    try:
        system = work_system("work", name)
        idle_machine(control, setup=Setup(work_offsets={system: {"Z": 0}}))
    except ValueError:
        return False
    return system == name


def _systems_in(block: Block) -> Iterator[str]:
    words = block.words
    for word in words:
        if word.address == "G" and word.value is not None:
            code = f"{word.value:g}"
            yield f"G{code}"
            numbers = [f"{w.value:g}" for w in words if w.address == "P" and w.value]
            yield from (f"G54.1 P{number}" for number in numbers)  # G154 P2 of a Haas, too


__all__ = ["Known", "Starts", "given_setup", "machine_coordinate", "systems_of", "with_start"]
