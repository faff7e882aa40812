"""Notes on what is easily overlooked in a memory, so that nothing happens in silence."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from cncsub.controls import Control, controls

if TYPE_CHECKING:
    from cncsub.library import Library
    from cncsub.program import Program


MOST_LOOKED_AT = 1_000  # programs, for one that may have been meant


@dataclass(frozen=True, slots=True)
class Note:
    """A fact about a memory that its user should know.

    `kind`: `"conflict"`, a program that does not count, because another one of its name with other
    blocks does; `"copy"`, the same where both have the same blocks; `"left-out"`, what was not
    read; `"no-head"`, the first program has no head and runs because its file comes first;
    `"beside"`, a file that the command also read, because a call names its program; `"defaulted"`,
    the control is the one of a project; `"outside"`, a file or folder that a project names outside
    its own folder; `"no-effect"`, what was given and changes nothing; `"increments"`, lengths
    without a decimal point, which the control counts in increments.
    `file`, `line`: the place, `None` for a file as a whole; of `"no-effect"` what was given.
    """

    kind: str
    message: str
    file: str
    line: int | None = None

    def __str__(self) -> str:
        place = self.file if self.line is None else f"{self.file}:{self.line}"
        return f"{place}: {self.message}"


def notes_of(library: Library) -> Iterator[Note]:
    """Yield the notes of a memory, those about programs first."""
    if (note := _no_head(library)) is not None:
        yield note
    for program in library.duplicates:
        counts = program_in_its_place(library, program)
        same = same_blocks(program, counts)
        yield Note(
            "copy" if same else "conflict",
            f"this {program.name} is never called: the control uses {counts.name} at"
            f" {counts.file}:{counts.line}, which is {'the same' if same else 'different'}",
            program.file,
            program.line,
        )
    for file, why in library.skipped:
        yield Note("left-out", f"left out: {why}", file)
    yield from _unused_parameters(library.control)


def _unused_parameters(control: Control) -> Iterator[Note]:
    """Yield notes on the parameters that were set and from which nothing is computed."""
    delivered = controls[control.base].parameters
    for name, parameter in control.parameters.items():
        if not parameter.used and parameter.value != delivered[name].value:
            told = f"no effect: cncsub computes nothing from it ({parameter.meaning})"
            yield Note("no-effect", told, f"parameter {name}")


def _no_head(library: Library) -> Note | None:
    """Return a note where the first file has no head and others have: it may be a text that is no
    program.
    """
    main = library.main
    if main is None or _has_head(main):
        return None
    others = (p for p in library.values() if p.file != main.file and _has_head(p))
    first = list(itertools.islice(others, MOST_LOOKED_AT))
    edges = library.call_graph().edges if first else ()
    called = {edge.called for edge in edges if isinstance(edge.called, str)}
    # Rather a program that nobody calls: it may be what was meant.
    headed = next((p for p in first if p.name not in called), first[0] if first else None)
    if headed is None:
        return None
    return Note(
        "no-head",
        f"the file has no program head, so it is the program {main.name}; it is the first file,"
        f" so it runs if no other program is named; {headed.name} of {headed.file} has a head,"
        " and runs if it is named",
        main.file,
        main.line,
    )


def _has_head(program: Program) -> bool:
    """Return whether the text of a program begins with its name, as O1, :1, %1 and <NAME> do."""
    # Only the head of a large program is read.
    text = program.beginning(4 * len(program.name) + 256).lstrip()
    first = program.blocks[0].text if len(program.blocks) else ""
    if first and text.startswith(first):  # `o100 sub` is a block: it begins a part of the file
        return False
    return text.startswith((":", "<")) or text.upper().startswith(program.name.upper())


def program_in_its_place(library: Library, duplicate: Program) -> Program:
    """Return the program that the control calls in place of a duplicate."""
    found = library[duplicate.name]
    digits = duplicate.name.lstrip("Oo:%")
    if found is duplicate and digits.isdecimal():  # O0002, where O2 counts
        found = library[int(digits)]
    return found


def same_blocks(one: Program, other: Program) -> bool:
    """Return whether two programs are the same but for their heads, blanks and empty lines."""
    return _blocks(one) == _blocks(other)


def _blocks(program: Program) -> list[str]:
    """Return the lines of a program without what makes no difference to a reader."""
    text = program.text.lstrip()
    if text.startswith(program.name):
        text = text[len(program.name) :]
    lines = (line.strip() for line in text.split("\n"))
    return [line for line in lines if line.strip("%")]
