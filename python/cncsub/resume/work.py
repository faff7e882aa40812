"""What a restart program is made from: the whole run, and its state at the place."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from cncsub.interrupts import uninterrupted
from cncsub.resume.draft import Draft
from cncsub.resume.errors import WholeRunError, place_text, refused
from cncsub.resume.head import Manner, write_head
from cncsub.resume.history import Before
from cncsub.resume.not_repeated import comment_of, not_repeated
from cncsub.resume.place import stand_at
from cncsub.resume.proof import Part, parting
from cncsub.resume.start import Starts, given_setup, machine_coordinate, with_start
from cncsub.resume.state import state_of
from cncsub.resume.tails import NoTailsError

if TYPE_CHECKING:
    from cncsub.library import Library
    from cncsub.machine import Machine


class Written(NamedTuple):
    """How a file is written: its line ends, and whether it stands between marks `%`."""

    line_end: str = "\n"
    marked: bool = False


class Work:
    """What a restart program is made from: the whole run, and the machine at the place."""

    def __init__(
        self,
        library: Library,
        main: str | int | None,
        at: Any,
        safe: float | None,
        options: dict[str, Any],
        chosen: str = "",
    ) -> None:
        self.library, self.main, self.options = library, main, options
        self.whole = uninterrupted(library.run(main, **options))
        if self.whole.stop not in ("end", "cycles"):
            raise WholeRunError(self.whole)
        self.machine: Machine = library.machine(main, **options)
        stand_at(library, self.machine, at, self.whole)
        block = self.machine.next
        if block is None:
            raise refused("the run ends there: nothing is left to be done")
        self.state = state_of(self.machine, block)
        self.before = Before(library, main, self.machine, options)
        self._refuse_compensation()
        self.starts = Starts(library, main, options, self.whole, self.machine, chosen)
        self.safe = safe
        self.why_flat = ""
        fresh = library.machine(main, **{**options, "max_blocks": 0})
        self.power_on = dict(fresh.modal)
        self.height = self._height() if self._needs_height() else None

    def has_units(self) -> bool:
        """Return whether the run has changed the units before the place."""
        return self.before.block_that_changed("units") is not None

    @property
    def sign(self) -> str:
        """The sign before the number of a program: that of the main one."""
        main = self.library.main if self.main is None else self.library[self.main]
        return "%" if main is not None and main.name.startswith("%") else "O"

    def _needs_height(self) -> bool:
        """Return whether the head goes up before it moves other axes: not on a lathe."""
        return (
            self.power_on.get("plane", "G18") != "G18"
            and bool(len(self.machine.moves))
            and "Z" in self.state.position
            and any(
                axis != "Z" and not self.starts.stands_at_start(axis)
                for axis in self.state.position
            )
        )

    def _height(self) -> float:
        """Return the height to which the head goes first, as a machine coordinate."""
        place = self._machine_z()
        at_start = self.starts.stands_at_start("Z")
        if self.safe is not None:
            here = self.state.position["Z"]
            if self.safe < here - 1e-9 and not at_start:
                raise ValueError(
                    f"safe_height {self.safe:g} lies below the place, which is at Z{here:g}"
                )
            height = place + self.safe - here
        else:
            known = self.starts.highest()
            if known is None:
                raise refused(
                    "no safe height is known: the run has not moved Z before, and where Z stands"
                    " depends on data that the setup does not give; give the Z to go to first"
                    " (safe_height, --safe-height), or the start of Z and the offsets in a setup",
                    self.state.block,
                )
            height = known
        limit = given_setup(self.options).limits.get("Z")
        if limit is None or height <= limit[1]:
            return height
        if self.safe is None:
            return max(place, limit[1])
        raise ValueError(
            f"safe_height {self.safe:g} is at {height:g} in machine coordinates, above the travel"
            f" limit of Z, {limit[1]:g}"
        )

    def _machine_z(self) -> float:
        return machine_coordinate(self.machine.moves[-1], "Z") or 0.0

    def begun_at_height(self, at: Any) -> Work:
        """Return the same work of a run that begins at the safe height, where the place of Z is
        that of the start of the run, which nobody gave.
        """
        if self.height is None or not self.starts.stands_at_start("Z"):
            return self
        start = self.starts.at_start["Z"] + self.height - self._machine_z()
        options = with_start(self.options, {"Z": start})
        return Work(self.library, self.main, at, None, options, "Z")

    def _refuse_compensation(self) -> None:
        """Refuse a start inside radius compensation: its path depends on the blocks before."""
        code = self.state.modal.get("radius")
        if code in (None, "G40"):
            return
        began = self.before.block_that_changed("radius")
        if began is None:
            return
        place = place_text(began[0])
        after = self.machine.copy()
        while after.run(until="mode radius") is None and after.modal.get("radius") != "G40":
            pass
        later = after.next
        cancelled = f" at {place_text(later)}" if after.stop is None and later else ""
        raise refused(
            f"radius compensation {code} is in force: start at {place}, which begins it, or"
            f"{cancelled or ' after it is cancelled'}"
            f"{', after it is cancelled' if cancelled else ''}",
            self.state.block,
        )

    def head(self, order: Any, manner: Manner, *, data: bool) -> Draft:
        """Return the head."""
        head = Draft(self.library, self.machine, self.state, self.starts, self.before, self.options)
        write_head(head, manner, self.height, order, commons=not data)
        if manner.repeats and not (self.state.step and self._repeat(head)):
            raise NoTailsError("the block before it moves")
        return head

    def _repeat(self, head: Draft) -> bool:
        return head.repeat(self.before.flat_text(self.state.step - 1))

    def told(self, head: Draft) -> list[str]:
        """Return what whoever starts it has to know."""
        return [*head.notes, *not_repeated(self.library, self.machine)]

    def comments(self, told: Iterable[str]) -> list[str]:
        return [text for line in told if (text := comment_of(self.library, line))]

    def written_as(self) -> Written:
        """Return how the file of the main program is written."""
        main = self.library.main if self.main is None else self.library[self.main]
        path = None if main is None else Path(main.file)
        if path is None or not path.is_file():
            return Written()
        with path.open("rb") as file:
            begin = file.read(1 << 16)
        marked = begin.partition(b"\n")[0].strip() == b"%"
        return Written("\r\n" if b"\r\n" in begin else "\n", marked)

    def causes(self) -> str:
        """Return the modes in force that no head could restore, with the blocks that began them."""
        found = []
        for name in ("rotation", "scaling", "polar", "mirror", "cycle"):
            code = self.state.modal.get(name)
            began = self.before.block_that_changed(name)
            if began is not None and code != self._cancelled(name):
                found.append(f"{code} is in force since {place_text(began[0])}")
        if self.machine.core.modal_calls:
            found.append("a modal call is in force")
        return "".join(f"\n{each}: start there, or after it is cancelled" for each in found)

    def _cancelled(self, name: str) -> str | None:
        return self.power_on.get(name)

    def differs(
        self, head: Draft, library: Library, main: str | None, *, variables: bool
    ) -> str | None:
        options = {**self.options, "start": None, "max_cycles": 1}
        run = uninterrupted(library.run(main, **options))
        return parting(
            Part(self.whole, self.state.step, len(self.machine.messages)),
            Part(run, len(head.lines), len(head.now.messages)),
            variables=variables,
        )
