"""Blocks of the run before a restart, and what they were in its words."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from cncsub import _core
from cncsub.program import Block

if TYPE_CHECKING:
    from cncsub.library import Library
    from cncsub.machine import Machine

# The words that make the frame of a program, and those that add to it [SINUMERIK, G group 3].
_NEW_FRAMES = ("TRANS", "ROT", "ROTS", "SCALE", "MIRROR")
_MORE_FRAMES = tuple(f"A{word}" for word in _NEW_FRAMES)


class Before:
    """The run up to a restart."""

    def __init__(
        self, library: Library, main: str | int | None, machine: Machine, options: dict[str, Any]
    ) -> None:
        self._library = library
        self._main = main
        self._machine = machine
        self._options = options
        self._changed: dict[str, tuple[Block, int] | None] = {}  # by mode, as far as asked for
        self._flat: dict[tuple[int, int | None], list[str]] = {}

    def block_that_changed(self, mode: str) -> tuple[Block, int] | None:
        """Return the block that put a mode in force, and its step; `None` where none did."""
        if mode not in self._changed:
            self._changed[mode] = self._look_for_change(mode)
        return self._changed[mode]

    def _look_for_change(self, mode: str) -> tuple[Block, int] | None:
        machine = self._machine.copy()
        machine.core.remember()
        try:
            machine.back(f"mode {mode}")
        except ValueError:
            return None
        block = machine.next
        return None if block is None else (block, machine.blocks)

    def last_executed(self, asked: Callable[[Block], bool]) -> int | None:
        """Return the step of the last block of this kind, `None` where none was executed."""
        found = self.steps_with(0, asked)
        return found[-1] if found else None

    def steps_with(self, first: int, asked: Callable[[Block], bool]) -> list[int]:
        """Return the steps from one on whose blocks are of this kind."""
        import numpy as np

        steps = self._machine.steps
        lines = {
            program.name: [block.line for block in program.blocks if asked(block)]
            for program in self._library.values()
        }
        wanted = [
            code << 32 | line
            for code, name in enumerate(steps.programs)
            for line in lines.get(name, ())
        ]
        if not wanted:
            return []
        found = np.flatnonzero(np.isin(steps.program.astype(np.int64) << 32 | steps.line, wanted))
        return [int(step) for step in found if step >= first]

    def frame_steps(self) -> list[int]:
        """Return the steps that have made the frame in force: the last that makes a new one, and
        those that add to it.
        """
        makes = self.last_executed(lambda block: _has_word(block, _NEW_FRAMES))
        adds = self.steps_with(makes or 0, lambda block: _has_word(block, _MORE_FRAMES))
        return [*([] if makes is None else [makes]), *adds]

    def flat_text(self, step: int, end: int | None = None) -> list[str]:
        """Return what a flat program has of a block that was executed, or of those before the step
        `end`; none where it has nothing or cannot be written.
        """
        if (step, end) not in self._flat:
            self._flat[step, end] = self._flattened(step, step + 1 if end is None else end)
        return self._flat[step, end]

    def _flattened(self, step: int, end: int) -> list[str]:
        options = {**self._options, "max_blocks": end}
        machine = self._library.machine(self._main, **options)
        machine.run()
        machine.back(step)
        return FlatLines(machine.core.copy()).lines


class FlatLines:
    """The rest of a run as blocks without calls: `lines`, and how it ends."""

    def __init__(self, core: _core.Machine) -> None:
        flattening = _core.flattening(core, False, None)
        text = ""
        while (piece := flattening.next()) is not None:
            text += piece[0].decode(errors="surrogateescape")
        lines = text.split("\n")[:-1]
        if lines[:1] == ["%"]:
            lines = lines[1 : len(lines) - (lines[-1] == "%")]
        self.refusal = flattening.refusal
        self.ends = flattening.ends
        self.lines = lines[1:] if _is_head(core, lines) else lines


def _is_head(core: _core.Machine, lines: list[str]) -> bool:
    """Return whether the first line is the name of the program."""
    if not lines:
        return False
    alone = _core.compile(core.code.control, [("<text>", "", [lines[0] + "\n"], False)], False)
    return alone.program(0).blocks == 0 if len(alone) else False


def _has_word(block: Block, words: tuple[str, ...]) -> bool:
    return any(word.address in words for word in block.words)
