"""The error of edits, with every cause."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from cncsub.analysis.block_errors import BlockError
from cncsub.library import Library


class EditError(BlockError):
    """The error where programs cannot be edited so that they do the same. `.reason`; `.program`,
    `.n` and `.line` give the first block that is the cause, `None` where no single one is;
    `.reasons`: all causes, each with its place.
    """

    def __init__(
        self,
        reason: str,
        program: str | None = None,
        n: int | None = None,
        line: int | None = None,
        reasons: tuple[str, ...] = (),
    ) -> None:
        super().__init__(reason, program, n, line)
        self.reasons = reasons or (str(self),)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.reason, self.program, self.n, self.line, self.reasons)


def place_of(library: Library, program: int, block: int | None) -> tuple[str, int | None, int]:
    """Return the name of a program with the number and the line of one of its blocks."""
    data = library.code.program(program)
    if block is None:
        return data.name, None, data.line
    n, line, _ = data.block(block)
    return data.name, n, line


def refusal(library: Library, causes: Iterable[tuple[int, int | None, str]]) -> EditError:
    """Return the error for these causes: the place of a program, of one of its blocks, why."""
    errors = [EditError(why, *place_of(library, program, block)) for program, block, why in causes]
    first = errors[0]
    more = f" (and {len(errors) - 1} more)" if len(errors) > 1 else ""
    return EditError(
        first.reason + more, first.program, first.n, first.line, tuple(map(str, errors))
    )
