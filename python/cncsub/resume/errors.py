"""The error where a run cannot be started again at a block."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from cncsub.analysis.block_errors import BlockError
from cncsub.program import Block
from cncsub.tables.rows import Step

if TYPE_CHECKING:
    from cncsub.run import Run


class ResumeError(BlockError):
    """The error where there is no restart program, or none can be written. `.reason`; `.program`,
    `.n` and `.line` give the block, `None` where no single block is the cause.
    """


class WholeRunError(ResumeError):
    """The error where the whole run does not come to its end: `.run`."""

    def __init__(self, run: Run) -> None:
        super().__init__(f"the whole run does not end: {run.summary()}")
        self.run = run

    def __reduce__(self) -> tuple[Any, ...]:
        return ResumeError, (self.reason,)


def refused(reason: str, block: Block | None = None) -> ResumeError:
    if block is None:
        return ResumeError(reason)
    return ResumeError(reason, block.program.name, block.n, block.line)


def place_text(of: Block | Step) -> str:
    """Return where a block stands: its program with its N, or with its line where it has none."""
    program = of.program if isinstance(of, Step) else of.program.name
    return f"{program} line {of.line}" if of.n is None else f"{program} N{of.n}"
