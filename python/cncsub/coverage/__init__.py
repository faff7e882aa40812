"""The blocks, branches and calls of the programs that were executed."""

from cncsub.coverage.summary import Coverage, collecting

__all__ = ["Coverage", "collecting"]
