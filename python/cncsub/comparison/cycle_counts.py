"""The words that say how often a drilling cycle is repeated: K of one control is L of another."""

from __future__ import annotations

from collections.abc import Iterator

from cncsub import _core
from cncsub._core import Control
from cncsub.controls import rule_value
from cncsub.program import Block, Program

# The engine's names for G codes: those that begin a drilling cycle, and those that end one.
_BEGIN = {
    "PeckFast",
    "LeftTap",
    "FineBore",
    "Drill",
    "DrillDwell",
    "Peck",
    "Tap",
    "Bore",
    "BoreManual",
    "BoreStop",
    "BackBore",
    "BoreDwell",
}
_END = {"CycleOff", "Rapid", "Line", "Cw", "Ccw", "Thread"}


class CycleCounts:
    """The counts of a control's drilling cycles."""

    def __init__(self, control: Control, machine: str) -> None:
        codes = _core.g_codes(control, machine)
        self._meanings = {
            float(code[1:]): meaning for code, meaning in codes if code[1:2].isdecimal()
        }
        self._letters = letters_of(control)

    def words(self, program: Program) -> Iterator[tuple[Block, str]]:
        """Yield the blocks of a program that have a count where a cycle is in force, and its
        letter.
        """
        active = False
        for block in program.blocks:
            words = block.words
            for word in words:
                if word.address == "G" and word.value is not None:
                    meaning = self._meanings.get(word.value, "")
                    active = meaning in _BEGIN or (active and meaning not in _END)
            if not active or block.calls:
                continue
            found = [word.address for word in words if word.address in self._letters]
            if len(found) == 1:
                yield block, found[0]


def letters_of(control: Control) -> tuple[str, ...]:
    """Return the addresses that repeat a drilling cycle, the one that takes precedence first."""
    return tuple(str(rule_value(control, "cycle_repeats") or ""))
