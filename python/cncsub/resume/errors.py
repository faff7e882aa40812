"""The error where a run cannot be started again at a block."""

from __future__ import annotations

from cncsub.analysis.block_errors import BlockError
from cncsub.program import Block


class ResumeError(BlockError):
    """The error where there is no restart program, or none can be written. `.reason`; `.program`,
    `.n` and `.line` give the block, `None` where no single block is the cause.
    """


def refused(reason: str, block: Block | None = None) -> ResumeError:
    if block is None:
        return ResumeError(reason)
    return ResumeError(reason, block.program.name, block.n, block.line)
