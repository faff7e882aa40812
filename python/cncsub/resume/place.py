"""The place of a restart: a block, a line, a move, a tool, or a place in space."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from cncsub.breakpoints import At, Breakpoint, blocks_of
from cncsub.inputs import is_whole
from cncsub.resume.errors import refused
from cncsub.tables.rows import Step

if TYPE_CHECKING:
    from cncsub.library import Library
    from cncsub.machine import Machine
    from cncsub.run import Run

Place = At | Breakpoint | Step | int | Mapping[str, float]
_Found = Breakpoint | Step | int | dict[str, float]

_POINT = re.compile(r"([XYZABCUVW])(-?\d+\.?\d*|-?\.\d+)", re.IGNORECASE)
_TOOL = re.compile(r"T\d{1,9}", re.IGNORECASE)


def as_place(at: object, times: int) -> _Found:
    """Return what `at` names: a text of several axes is a place in space.

    Raises `TypeError` and `ValueError` for what names none.
    """
    if isinstance(at, Mapping):
        _once(times)
        return {_axis(axis): length("at: a coordinate", value) for axis, value in at.items()}
    if is_whole(at):
        _once(times)
        return int(at)  # type: ignore[call-overload,no-any-return]
    if isinstance(at, str) and (pieces := at.replace(",", " ").split()):
        found = [_POINT.fullmatch(piece) for piece in pieces]
        if all(found):
            _once(times)
            return {match[1].upper(): float(match[2]) for match in found if match}
    if isinstance(at, Breakpoint | Step):
        _once(times)
        return at
    return Breakpoint(at, hits=times)  # type: ignore[arg-type]


def _once(times: int) -> None:
    if times != 1:
        raise ValueError(
            f"times (--pass) must be 1 here, not {times}: it counts how often the run comes to a"
            " block; a move, a step and a place in space are met once, and a Breakpoint has its own"
            " hits"
        )


def _axis(name: object) -> str:
    if isinstance(name, str) and _POINT.fullmatch(f"{name}0"):
        return name.upper()
    raise ValueError(f"at: a place names axes such as X, not {name!r}")


def length(what: str, value: Any) -> float:
    """Return a length that was given; `ValueError` for what is none."""
    if isinstance(value, bool) or not isinstance(value, int | float) or not abs(value) < 1e15:
        raise ValueError(f"{what} must be a number of mm, not {value!r}")
    return float(value)


def stand_at(library: Library, machine: Machine, place: _Found, run: Run) -> None:
    """Run the machine to the place: the block there comes next."""
    if isinstance(place, Breakpoint):
        _run_to(machine, place)
        return
    if isinstance(place, Step):
        machine.run()
        machine.back(place.step)
        return
    move = place if isinstance(place, int) else _nearest(run, place)
    if not 0 <= move < len(run.moves):
        raise ValueError(f"at: the moves are 0 to {len(run.moves) - 1}, not {move}")
    machine.run()
    machine.back(int(run.moves.step[move]))


def _run_to(machine: Machine, place: Breakpoint) -> None:
    if _is_first(machine, place):  # what a machine stands at does not stop it
        if place.hits == 1:
            return
        place = dataclasses.replace(place, hits=place.hits - 1)
    if machine.run(until=place) is not None:
        raise refused(
            f"the run does not come to {place.at!r}"
            f"{'' if place.hits == 1 else f' {place.hits} times'}: {machine.summary()}",
            machine.next,
        )
    if isinstance(place.at, str) and _TOOL.fullmatch(place.at.strip()):
        machine.back()  # the tool is called again


def _is_first(machine: Machine, place: Breakpoint) -> bool:
    """Return whether the run begins at the place."""
    return machine.core.next_block in blocks_of(machine.core, place) and place.when is None


def _nearest(run: Run, place: Mapping[str, float]) -> int:
    """Return the move that comes nearest to a place, the first of several."""
    import numpy as np

    count = len(run.moves)
    names = [axis.lower() for axis in place]
    lacking = [name.upper() for name in names if name not in run.moves.columns]
    if not count or lacking:
        raise ValueError(f"at: the run does not move {' or '.join(lacking) or 'at all'}")
    ends = np.stack([np.asarray(run.moves[name], float) for name in names], axis=1)
    starts = np.vstack([ends[:1], ends[:-1]])
    aim = np.array(list(place.values()))
    along = ends - starts
    squares = (along * along).sum(axis=1)
    share = ((aim - starts) * along).sum(axis=1) / np.where(squares > 0, squares, 1)
    nearest = starts + np.clip(share, 0, 1)[:, None] * along
    return int((((nearest - aim) ** 2).sum(axis=1)).argmin())


__all__ = ["Place", "as_place", "length", "stand_at"]
