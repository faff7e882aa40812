"""The arithmetic of SINUMERIK programs: types, conversions, functions and rotations."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field

Value = float | int | bool | str
Matrix = tuple[tuple[float, float, float], ...]

ALIKE = 1e-12  # REAL values that differ by this share are equal
LARGEST_INT = 2**31 - 1
IDENTITY: Matrix = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


class UnclearError(Exception):
    """The program depends on what the manual does not say, or is too long."""


class AlarmError(Exception):
    """The control stops with an alarm; the argument is its cause."""


@dataclass
class Cell:
    """A variable: its type and its value, which a VAR parameter shares with its caller."""

    type: str
    value: Value


@dataclass
class Scope:
    """The variables of one program that runs."""

    cells: dict[str, Cell] = field(default_factory=dict)
    arrays: dict[str, tuple[tuple[int, ...], list[Cell]]] = field(default_factory=dict)
    frames: dict[str, object] = field(default_factory=dict)


def constant(text: str) -> float | int:
    """Return the value of a number as it is written."""
    if text.startswith("'"):
        return int(text[2:-1], 16 if text[1] == "H" else 2)
    mantissa, power, exponent = text.partition("EX")
    if power:
        return float(mantissa) * 10.0 ** int(exponent)
    return float(text) if "." in text else int(text)


def converted(value: Value, to: str) -> Value:
    """Return a value as a variable of this type keeps it."""
    if to == "STRING":
        return value or ""  # without a value it is empty
    if to == "AXIS":
        return value
    if to == "REAL":
        return float(value)
    if to == "BOOL":
        return bool(value)
    if not isinstance(value, float):
        return int(value)
    if value < 0 and value - math.floor(value) == 0.5:
        raise UnclearError  # whether -0.5 goes up or down
    whole = math.floor(value + 0.5)
    if abs(whole) > LARGEST_INT:
        raise AlarmError("value-out-of-range")
    return whole


def product(a: Matrix, b: Matrix) -> Matrix:
    return tuple(  # type: ignore[return-value]
        tuple(sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)) for i in range(3)
    )


def turned(axis: str, degrees: float) -> Matrix:
    """Return the rotation about an axis, counterclockwise seen against its direction."""
    s, c = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
    return {
        "X": ((1.0, 0.0, 0.0), (0.0, c, -s), (0.0, s, c)),
        "Y": ((c, 0.0, s), (0.0, 1.0, 0.0), (-s, 0.0, c)),
        "Z": ((c, -s, 0.0), (s, c, 0.0), (0.0, 0.0, 1.0)),
    }[axis]


def alike(a: Value, b: Value) -> bool:
    if isinstance(a, str) or isinstance(b, str):
        return a == b
    return abs(a - b) <= ALIKE * max(abs(a), abs(b))


def diagonal(of: list[float]) -> Matrix:
    return ((of[0], 0.0, 0.0), (0.0, of[1], 0.0), (0.0, 0.0, of[2]))


def _root(value: Value) -> float:
    if value < 0:
        raise AlarmError("square-root-of-negative")
    return math.sqrt(value)


def _degrees(function: Callable[[float], float]) -> Callable[[Value], float]:
    return lambda value: function(math.radians(value))


def _tangent(value: Value) -> float:
    if abs(math.cos(math.radians(value))) < 1e-3:
        raise UnclearError
    return math.tan(math.radians(value))


def _arc(function: Callable[[float], float]) -> Callable[[Value], float]:
    def angle(value: Value) -> float:
        if abs(value) > 1:
            raise UnclearError
        return math.degrees(function(value))

    return angle


def _direction(y: Value, x: Value) -> float:
    if y == 0 and x <= 0:
        raise UnclearError  # where a zero may have a sign
    return math.degrees(math.atan2(y, x))


def _part(text: str, first: int, count: int) -> str:
    if first + count > len(text):
        raise UnclearError  # what lies behind the end of a text is open
    return text[first : first + count]


def _logarithm(value: Value) -> float:
    if value <= 0:
        raise UnclearError
    return math.log(value)


def _any_of(text: str, letters: str) -> int:
    """Return the first place in a text that has one of the letters, or -1."""
    return min((place for place, letter in enumerate(text) if letter in letters), default=-1)


FUNCTIONS: dict[str, Callable[..., Value]] = {
    "SIN": _degrees(math.sin),
    "COS": _degrees(math.cos),
    "TAN": _tangent,
    "ASIN": _arc(math.asin),
    "ACOS": _arc(math.acos),
    "ATAN2": _direction,
    "SQRT": _root,
    "LN": _logarithm,
    "EXP": math.exp,
    "POT": lambda value: float(value) ** 2,
    "ABS": abs,
    "TRUNC": math.trunc,
    "ROUND": lambda value: converted(float(value), "INT"),
    "ROUNDUP": math.ceil,
    "MINVAL": min,
    "MAXVAL": max,
    "BOUND": lambda low, high, value: max(low, min(high, value)),
    "STRLEN": len,
    "INDEX": str.find,
    "RINDEX": str.rfind,
    "SUBSTR": _part,
    "TOUPPER": str.upper,
    "TOLOWER": str.lower,
    "MINDEX": _any_of,
    "ISNUMBER": lambda text: text.lstrip("-").replace(".", "", 1).isdigit(),
    "NUMBER": float,
}
