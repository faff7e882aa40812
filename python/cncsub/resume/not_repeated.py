"""The codes of a run before a place that a restart program does not repeat: they are told."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from cncsub.resume.errors import place_text
from cncsub.resume.state import COOLANT_CODES, roles_of

if TYPE_CHECKING:
    from cncsub.library import Library
    from cncsub.machine import Machine
    from cncsub.program import Block
    from cncsub.tables.rows import Step

_EXTENDED = re.compile(r"[MSH]\d+")  # M2=3, a code of another spindle
_DATA = "PQRSED"  # addresses whose words belong to a function of the machine
_MOVING = "XYZABCUVWIJKG"
_SHOWN = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 .,:=+-#/"


def not_repeated(library: Library, machine: Machine) -> list[str]:
    """Return a line for each function that the run sent to the machine before the place and that a
    head does not send again: what it does is not known, and it may be in force.
    """
    known = {code for codes in roles_of(machine).values() for code in codes} - set(
        roles_of(machine).get("rigid-tapping", ())
    )
    last: dict[str, int] = {}
    for code in machine.codes:
        if code.kind == "M" and code.value not in known and code.value not in COOLANT_CODES:
            last.pop(name := f"M{code.value:g}", None)
            last[name] = code.step
    last.update(_extended(library, machine))
    return [
        f"{_function(library, name, machine.steps[step])} ran at"
        f" {place_text(machine.steps[step])} and is not repeated"
        for name, step in sorted(last.items(), key=lambda item: item[1])
    ]


def _extended(library: Library, machine: Machine) -> dict[str, int]:
    """Return the functions with an extended address, such as M2=3, with their last steps."""
    texts: dict[tuple[str, int], list[str]] = {}
    for program in library.values():
        for block in program.blocks:
            found = [w.text for w in block.words if _EXTENDED.fullmatch(w.address)]
            if found:
                texts[program.name, block.line] = found
    if not texts:
        return {}
    return {
        text: index
        for index, step in enumerate(machine.steps)
        for text in texts.get((step.program, step.line), ())
    }


def _function(library: Library, name: str, step: Step) -> str:
    """Return a code with the words of its block that belong to it, where nothing else does."""
    block = _block(library, step)
    words = [] if block is None else list(block.words)
    if any(word.address in _MOVING for word in words):
        return name
    return " ".join([name, *(w.text for w in words if w.address in _DATA)])


def _block(library: Library, step: Step) -> Block | None:
    if step.program not in library:
        return None
    return next((b for b in library[step.program].blocks if b.line == step.line), None)


def comment_of(library: Library, text: str) -> str:
    """Return a text as a comment of the control; empty where it reads none."""
    plain = "".join(c if c in _SHOWN else "_" for c in text.upper())
    for comment in (f"({plain})", f"; {plain}"):
        read = library.of_text(f"{comment}\nM30\n", library.control)
        if [block.text for program in read.values() for block in program.blocks] == ["M30"]:
            return comment
    return ""


__all__ = ["comment_of", "not_repeated"]
