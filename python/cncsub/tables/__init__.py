"""The tables of a run: rows are small objects, columns NumPy arrays."""

from cncsub.tables.of_runs import Bounds, Calls, Codes, Conditions, Moves, Steps, Watch
from cncsub.tables.table import Table

__all__ = ["Bounds", "Calls", "Codes", "Conditions", "Moves", "Steps", "Table", "Watch"]
