"""Two runs side by side: the first difference between them, and what each does there."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, TypeAlias

from cncsub import _core
from cncsub._core import Control
from cncsub.interrupts import uninterrupted
from cncsub.run_options import FlattenOptions, idle_machine

if TYPE_CHECKING:
    from cncsub.library import Library
    from cncsub.run import Run

_WATCHED = 1000  # variables that can be watched at once
MOST_BLOCKS = 10_000_000  # of a run, where the caller sets no limit

# Why two runs are compared; cpp/cncsub/comparison/question.hpp says what counts for each.
Question = Literal["versions", "controls", "rewritten", "translated", "flat", "edited"]
# Runs a side once more: for as many blocks, with these variables watched.
Again: TypeAlias = Callable[[int | None, Sequence[int]], _core.Machine | None]
Side: TypeAlias = tuple[str, _core.Machine, Again]


class Parting(NamedTuple):
    """The point where two runs part: a step of each, or the count of steps where a run has none.

    `column`: where it is a move that differs, the column that does.
    """

    first: int
    second: int
    what: str
    column: str = ""


class Pair:
    """Two libraries, how they are run, and what is asked of their runs. `renamed`: programs that an
    edit renamed, new to old; `renumbered`: variables with another number, old to new.
    """

    def __init__(
        self,
        question: Question,
        libraries: tuple[Library, Library],
        names: tuple[str, str],
        main: str | int | tuple[str, str] | None,
        options: FlattenOptions,
        *,
        renamed: Mapping[str, str] | None = None,
        renumbered: Mapping[int, int] | None = None,
    ) -> None:
        self.libraries = libraries
        self.names = names
        self._question = question
        self._mains = main if isinstance(main, tuple) else (main, main)
        self._options = options
        self._renamed = dict(renamed or {})
        self._renumbered = dict(renumbered or {})

    def run(self, side: int, **more: Any) -> Run:
        """Run one of the libraries, 0 or 1."""
        options = {**self._options, **more}
        return uninterrupted(self.libraries[side].run(self._mains[side], **options))

    def runs(self) -> tuple[Run, Run]:
        return self.run(0), self.run(1)

    def again(self, side: int) -> Again:
        """Return what runs a library once more."""

        def run(most: int | None, watch: Sequence[int]) -> _core.Machine:
            own = self._options.get("max_blocks", MOST_BLOCKS)
            blocks = own if most is None else min(own, most)
            return self.run(side, max_blocks=blocks, watch=list(watch)).core

        return run

    def sides(self, a: Run, b: Run) -> tuple[Side, Side]:
        """Return both sides as the engine compares them."""
        one, other = self.names
        return (one, a.core, self.again(0)), (other, b.core, self.again(1))

    def parting(self, a: Run, b: Run) -> Parting | None:
        """Return the earliest of all differences that count."""
        sides = self.sides(a, b)
        found = _core.parting(self._question, sides, self._renamed, self._renumbered)
        return None if found is None else Parting(*found)

    def watched(self, a: Run, b: Run) -> tuple[Run, Run]:
        """Run both once more, with the variables watched that hold a value in one of them."""
        numbers = _core.shared_variables(a.core, b.core)[:_WATCHED]
        return self.run(0, watch=numbers), self.run(1, watch=numbers)


def variables_lacking(control: Control, given: Mapping[int, float | None]) -> list[int]:
    """Return the given variables that a control does not have."""

    def lacks(number: int) -> bool:
        try:
            idle_machine(control, variables={number: given[number]})
        except ValueError:
            return True
        return False

    return [number for number in given if lacks(number)]
