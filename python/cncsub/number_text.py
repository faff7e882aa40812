"""Numbers as people read them."""

from __future__ import annotations

_FINEST = 6  # decimals of a length: a millionth of a millimetre


def number_text(value: float | None) -> str:
    """Return the shortest text of a value, so that two that differ look different.

    >>> number_text(5.0), number_text(0.9999999999999999), number_text(None)
    ('5', '0.9999999999999999', 'vacant')
    """
    return "vacant" if value is None else repr(float(value)).removesuffix(".0")


def length_text(value: float) -> str:
    """Return a length in mm or degrees without the digits that computing leaves.

    >>> length_text(12345.678), length_text(0.1 + 0.2), length_text(-0.0)
    ('12345.678', '0.3', '0')
    """
    return number_text(round(value, _FINEST) + 0.0)
