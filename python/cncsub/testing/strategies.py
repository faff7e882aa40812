"""Arguments of macros for tests by hypothesis, as a program can write them."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal

from hypothesis import strategies as st

_NOT_ARGUMENTS = "GLNOP"  # of G65


def arguments(
    *required: str, decimals: int = 3, **ranges: tuple[float, float]
) -> st.SearchStrategy[dict[str, Decimal]]:
    """Return a strategy for the letters of a call, with values of `decimals` digits after the
    point.

    `ranges`: the least and the largest value of each letter; a letter among `required` is always
    given, another one sometimes, as a call may leave it out. Without a range a required letter lies
    between -9999 and 9999. Raises `ValueError` for a letter that G65 does not take as an argument.

    >>> from hypothesis import find
    >>> from cncsub.testing.strategies import arguments, call_words
    >>> call_words(find(arguments("A", A=(1, 5)), lambda _: True))
    'A1.'
    """
    for letter in (*required, *ranges):
        if len(letter) != 1 or not "A" <= letter <= "Z" or letter in _NOT_ARGUMENTS:
            raise ValueError(
                f"{letter!r} is not an argument of G65: use A to Z without G, L, N, O and P"
            )
    whole = dict.fromkeys(required, (-9999.0, 9999.0)) | ranges
    values = {
        letter: st.decimals(
            Decimal(repr(low)), Decimal(repr(high)), allow_nan=False, places=decimals
        )
        for letter, (low, high) in whole.items()
    }
    given = {letter: values[letter] for letter in required}
    left = {letter: values[letter] for letter in whole if letter not in required}
    return st.fixed_dictionaries(given, optional=left)


def call_words(values: Mapping[str, Decimal | float]) -> str:
    """Return the words of a call, each with a decimal point: no control then reads increments.

    >>> from cncsub.testing.strategies import call_words
    >>> call_words({"A": 1.5, "B": -2})
    'A1.5 B-2.'
    """
    return " ".join(f"{letter}{_written(value)}" for letter, value in values.items())


def _written(value: Decimal | float) -> str:
    text = f"{value:.6f}" if isinstance(value, float) else f"{value:f}"
    whole, _, rest = text.partition(".")
    rest = rest.rstrip("0")
    return f"{'0' if whole == '-0' and not rest else whole}.{rest}"
