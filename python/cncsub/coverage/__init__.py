"""Which blocks, branches and calls of the programs were executed."""

from cncsub.coverage.summary import Coverage, collecting

__all__ = ["Coverage", "collecting"]
