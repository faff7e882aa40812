"""A column of texts: an array of codes, which compares with the texts that they stand for."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np


class TextColumn(np.ndarray[Any, np.dtype[np.int32]]):
    """`int32` codes, -1 where there is no text; `column.texts[code]` is the text.

    `==` and `!=` take a text, or a list of texts (is it one of them?), and give an array of truth
    values. Every other operation works on the codes and gives a plain array.

    >>> import cncsub
    >>> text = "O1\\nN10 M98 P2 L2\\nN20 M30\\nO2\\nN30 M99\\n"
    >>> steps = cncsub.loads(text, control="fanuc-0i-f").run().steps
    >>> steps.program.tolist(), steps.program.texts
    ([0, 1, 1, 0], ('O1', 'O2'))
    >>> steps.n[steps.program == "O2"].tolist()
    [30, 30]
    >>> steps.program.to_texts().tolist()
    ['O1', 'O2', 'O2', 'O1']
    """

    texts: tuple[str, ...]

    def __array_finalize__(self, of: object) -> None:
        self.texts = getattr(of, "texts", ())

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        if method == "__call__" and ufunc in (np.equal, np.not_equal) and not options:
            found = self._compared(*inputs)
            if found is not None:
                return found if ufunc is np.equal else ~found
        if "out" in options:
            options["out"] = tuple(map(_plain, options["out"]))
        return getattr(ufunc, method)(*map(_plain, inputs), **options)

    def _compared(self, a: Any, b: Any) -> Any:
        """Return where the codes are those of a text, or of one of several; `None` where neither is
        a text.
        """
        codes, wanted = (a, b) if isinstance(a, TextColumn) else (b, a)
        if isinstance(wanted, TextColumn):
            return None if wanted.texts == codes.texts else codes.to_texts() == wanted.to_texts()
        names = _names(wanted)
        if names is None:
            return None
        places = [place for place, text in enumerate(codes.texts) if text in names]
        return np.isin(_plain(codes), places)

    def to_texts(self) -> np.ndarray[Any, np.dtype[np.object_]]:
        """Return the texts written out, `None` where there is none: an array of objects."""
        written: Any = np.array([*self.texts, None], dtype=object)
        return written[_plain(self)]  # type: ignore[no-any-return]  # the code -1 is the last

    def __reduce__(self) -> Any:
        return text_column, (np.asarray(self).view(np.ndarray), self.texts)


def _names(wanted: Any) -> frozenset[str] | None:
    if isinstance(wanted, str):
        return frozenset((wanted,))
    if isinstance(wanted, np.ndarray):
        wanted = wanted.tolist() if wanted.dtype.kind in "UO" else None
    if isinstance(wanted, str):
        return frozenset((wanted,))
    if isinstance(wanted, list | tuple | set | frozenset) and wanted:
        return frozenset(wanted) if all(isinstance(name, str) for name in wanted) else None
    return None


def _plain(array: Any) -> Any:
    return array.view(np.ndarray) if isinstance(array, TextColumn) else array


def text_column(codes: np.ndarray[Any, Any], texts: Sequence[str]) -> TextColumn:
    """Return the codes of a column with their texts."""
    column = codes.view(TextColumn)
    column.texts = tuple(texts)
    return column
