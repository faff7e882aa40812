"""Errors about a block of a program: what is wrong, and the place of the block in its text."""

from __future__ import annotations

from typing import Any


class BlockError(ValueError):
    """An error with its `.reason`, and the block that it is about: `.program`, `.n` and `.line`,
    `None` where no single block is the cause.
    """

    def __init__(
        self,
        reason: str,
        program: str | None = None,
        n: int | None = None,
        line: int | None = None,
    ) -> None:
        place = "" if n is None else f" N{n}"
        super().__init__(reason if program is None else f"{program}{place}, line {line}: {reason}")
        self.reason, self.program, self.n, self.line = reason, program, n, line

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.reason, self.program, self.n, self.line)
