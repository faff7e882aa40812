"""Tables of two runs side by side: their columns, and the first row that differs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np

    Column = np.ndarray[Any, Any]

NEAR = 1e-9  # mm, degrees, mm/min: values that differ by less are alike


def alike(a: float | None, b: float | None) -> bool:
    """Return whether two values of a variable are the same."""
    return a == b or (a is not None and b is not None and abs(a - b) < NEAR)


def column_of(table: Any, name: str) -> Column:
    """Return a column with its texts written out; NaN where the table has no such column."""
    import numpy as np

    if name not in table.columns:
        return np.full(len(table), np.nan)
    column: Column = table[name]
    texts = table.texts_of(name)
    if texts is None:
        return column
    written: Column = np.asarray([*texts, None], dtype=object)
    return written[column]


def first_difference(pairs: Sequence[tuple[Column, Column]], precision: float = 0.0) -> int | None:
    """Return the first row in which one of the columns differs, or the end of the shorter table.
    `precision`: how exactly a control reads numbers, relative to them.
    """
    import numpy as np

    a, b = pairs[0]
    count = min(len(a), len(b))
    differs = np.zeros(count, dtype=bool)
    for one, other in pairs:
        x, y = one[:count], other[:count]
        if x.dtype.kind == "f" and y.dtype.kind == "f":
            near = np.maximum(NEAR, precision * np.maximum(np.abs(x), 1)) if precision else NEAR
            differs |= ~((np.abs(x - y) < near) | (np.isnan(x) & np.isnan(y)))
        else:
            differs |= x != y
    found = np.flatnonzero(differs)
    if len(found):
        return int(found[0])
    return None if len(a) == len(b) else count
