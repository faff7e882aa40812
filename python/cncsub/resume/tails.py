"""The rest of a run as programs: the rest of each open program, with what it calls as it is."""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

from cncsub.controls import first_made_number, rule_value
from cncsub.program import Block, Program

if TYPE_CHECKING:
    from cncsub.library import Library
    from cncsub.machine import Machine

_NUMBERED = re.compile(r"O(\d+)")
_ENDS = (2, 30, 99)


class NoTailsError(Exception):
    """The error where the rest cannot be written as programs; its text is the reason."""


class Tails:
    """The rest of the programs that are open where a machine stands: `main`, the blocks of the main
    program after the head, and `programs`, the texts of those that it calls, by name. `number`: of
    the main program, `None` where it has its name from its file. `change`, which may be set later,
    is what is done to the blocks that come first.
    """

    def __init__(self, library: Library, machine: Machine, *, starts_over: bool) -> None:
        self.change: Callable[[Iterable[str]], Iterable[str]] = iter
        self._starts_over = starts_over
        self._library = library
        self._machine = machine
        self._frames = machine.core.open_frames
        self._refuse()
        free = free_numbers(library)
        self._numbers = [next(free) for _ in self._frames]
        self.number = self._numbers[0] if _number(self._program_of(self._frames[0]).name) else None

    @property
    def main(self) -> list[str]:
        return self._rest(0)

    @property
    def programs(self) -> dict[str, str]:
        return {f"O{self._numbers[i]}": self._program(i) for i in self._deeper()}

    def _deeper(self) -> range:
        return range(1, len(self._frames))

    def _refuse(self) -> None:
        if self._machine.core.modal_calls:
            raise NoTailsError("a modal call is in force")
        if any(frame["modal"] or frame["part"] for frame in self._frames):
            raise NoTailsError("a modal call or a repeated part of a program is open")
        named = [self._program_of(frame).name for frame in self._frames]
        if not all(map(_number, named)) and len(named) > 1:
            raise NoTailsError("the programs that are open are not called by their number")
        if self._machine.variables.named:
            raise NoTailsError("variables that the program defines have values")

    def _program_of(self, frame: dict[str, Any]) -> Program:
        return Program(self._machine.core.code.program(frame["program"]), frame["program"])

    def _program(self, index: int) -> str:
        """Return the text of the rest of a called program."""
        lines = [f"O{self._numbers[index]}", *self._locals(index), *self._rest(index)]
        return "".join(f"{line}\n" for line in lines)

    def _locals(self, index: int) -> list[str]:
        """Return the assignments of the variables of the level that a program has opened."""
        if not self._frames[index]["own_locals"]:
            return []
        core = self._machine.core
        level = sum(frame["own_locals"] for frame in self._frames[1 : index + 1])
        values = self._machine.variables.level(level)
        own = [n for n in values if values[n] is not None and _is_local(core, n, level)]
        return [core.assignment(number, values[number]) for number in own]

    def _rest(self, index: int) -> list[str]:
        """Return the blocks of an open program from its place on: the call that is open in it comes
        first, then its further passes.
        """
        frame = self._frames[index]
        blocks = self._program_of(frame).blocks
        inner = self._frames[index + 1] if index + 1 < len(self._frames) else None
        address = self._machine.core.address if inner is None else inner["return_to"]
        lines = [] if inner is None else self._calls(index + 1)
        at = self._index(frame, address)
        pieces, contiguous = self._pieces(frame, at, blocks)
        texts = (block.text for block in pieces)
        lines += self.change(texts) if inner is None else texts
        if not pieces or not _ends(pieces[-1]):
            lines.append("M99" if index else "M30")
        elif index == 0 and self._starts_over and _ends(pieces[-1], 99):
            lines[-1] = re.sub(r"M0*99", "M30", lines[-1])
        if self._goes_before(pieces, contiguous):
            lines += [block.text for block in blocks]
        return lines

    def _index(self, frame: dict[str, Any], address: int) -> int:
        program, index = self._machine.core.code.place_of(address)
        if program != frame["program"]:
            raise NoTailsError("a program goes on in another one")
        return index

    def _pieces(
        self, frame: dict[str, Any], at: int, blocks: Sequence[Block]
    ) -> tuple[list[Block], int]:
        """Return the blocks from a place on: the rest of each open loop, the innermost first, with
        the loop once more after it; and the place from which the last of them go on to the end.
        """
        pieces: list[Block] = []
        for start, end in reversed(frame["loops"]):
            if end is None:
                raise NoTailsError("a loop of unknown end is open")
            pieces += blocks[at : self._index(frame, end)]
            at = self._index(frame, start)
        return [*pieces, *blocks[at:]], at

    def _goes_before(self, pieces: Sequence[Block], first: int) -> bool:
        """Return whether a block jumps to one that is not among the blocks from `first` on."""
        jumps = [jump for block in pieces for jump in block.jumps]
        if any(jump.block is None or jump.block < first for jump in jumps if not jump.in_caller):
            return True
        return any(
            jump.in_caller
            for program in self._library.values()
            for block in program.blocks
            for jump in block.jumps
        )

    def _calls(self, index: int) -> list[str]:
        """Return the call of the rest of a program, and of the passes that come after it."""
        frame = self._frames[index]
        macro = bool(frame["own_locals"])
        lines = [f"G65 P{self._numbers[index]}" if macro else f"M98 P{self._numbers[index]}"]
        left = frame["repeats"] - frame["repeat"]
        if left > 0:
            lines.append(self._passes(frame, left))
        return lines

    def _passes(self, frame: dict[str, Any], left: int) -> str:
        """Return the call that makes so many passes of a program."""
        code = self._machine.core.code
        program, place = code.place_of(frame["called_at"])
        block = Program(code.program(program), program).blocks[place]
        if len(block.calls) != 1 or not isinstance(block.calls[0].repeats, int):
            raise NoTailsError("the count of a call is computed")
        call = block.calls[0]
        assert isinstance(call.repeats, int)
        for text in _with_count(block, call.repeats, left):
            alone = self._library.of_text(f"O1\n{text}\nM30\n", code.control)
            read = [each for known in alone.values() for row in known.blocks for each in row.calls]
            if [(each.program, each.start, each.repeats) for each in read] == [
                (call.program, call.start, left)
            ]:
                return text
        raise NoTailsError("the rest of its passes cannot be written")


def free_numbers(library: Library) -> Iterator[int]:
    """Yield the numbers of programs that the memory does not have and the control takes."""
    taken = {number for name in library if (number := _number(name)) is not None}
    most = rule_value(library.control, "max_program_number")
    first = first_made_number(library.control)
    last = 10**8 if most is None else int(str(most))
    numbers = itertools.chain(range(first, last + 1), range(first - 1, 0, -1))
    yield from (n for n in numbers if n not in taken)
    raise NoTailsError("the memory has no number left for a program")


def _with_count(block: Block, repeats: int, left: int) -> list[str]:
    """Return the call of a block with another count, as it may be written."""
    words = [word.text for word in block.words if word.address not in ("N", "O")]
    texts = []
    for index, text in enumerate(words):
        letter, digits = text[:1].upper(), text[1:]
        if letter in "LHK" and digits.isdigit() and int(digits) == repeats:
            count = "" if left == 1 else f"{letter}{left}"
            texts.append(" ".join([*words[:index], *filter(None, [count]), *words[index + 1 :]]))
        if letter == "P" and digits.startswith(str(repeats)):
            rest = digits[len(str(repeats)) :]
            texts.append(" ".join([*words[:index], f"P{left}{rest}", *words[index + 1 :]]))
    return texts


def _number(name: str) -> int | None:
    found = _NUMBERED.fullmatch(name)
    return int(found[1]) if found else None


def _ends(block: Block, *codes: int) -> bool:
    return any(w.address == "M" and w.value in (codes or _ENDS) for w in block.words)


def _is_local(core: Any, number: int, level: int) -> bool:
    """Return whether a variable is one of a level: another level has another one."""
    probe = core.copy()
    probe.set_variable(number, 0.5, level)
    probe.set_variable(number, 0.25, level - 1)
    return bool(probe.get_variable(number, level) == 0.5)


__all__ = ["NoTailsError", "Tails"]
