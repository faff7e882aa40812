"""The arguments of a request, each asked for by its type: a client may send anything."""

from __future__ import annotations

from typing import Any, TypeVar

T = TypeVar("T")
_MISSING: Any = object()
_TYPES = {str: "a text", int: "a whole number", bool: "true or false", list: "a list",
          dict: "an object"}  # fmt: skip


class RequestError(Exception):
    """A request that cannot be carried out; the text says why, and what to send instead."""


class Arguments:
    """The arguments of one request.

    >>> Arguments({"threadId": 1}).number("threadId")
    1
    >>> Arguments({"line": "3"}).number("line")
    Traceback (most recent call last):
    cncsub.dap.arguments.RequestError: line must be a whole number, not '3'
    """

    def __init__(self, given: Any) -> None:
        if given is None:
            given = {}
        if not isinstance(given, dict):
            raise RequestError(f"arguments must be an object, not {_short(given)}")
        self.given = given

    def text(self, name: str, default: Any = _MISSING) -> str:
        return self._get(name, str, default)

    def number(self, name: str, default: Any = _MISSING) -> int:
        number = self._get(name, int, default)
        if number is not default and not -(2**31) <= number < 2**31:
            raise RequestError(f"{name} is too large: {_short(number)}")
        return number

    def flag(self, name: str) -> bool:
        return self._get(name, bool, False)

    def sequence(self, name: str, default: Any = _MISSING) -> list[Any]:
        return self._get(name, list, default)

    def table(self, name: str, default: Any = _MISSING) -> Arguments:
        """Return the arguments in an object."""
        return Arguments(self._get(name, dict, default))

    def tables(self, name: str) -> list[Arguments]:
        """Return the arguments in each object of a list, which may be missing."""
        return [Arguments(each) for each in self._get(name, list, [])]

    def _get(self, name: str, kind: type[T], default: Any) -> T:
        value = self.given.get(name)
        if value is None:
            if default is _MISSING:
                raise RequestError(f"{name} is missing: it must be {_TYPES[kind]}")
            return default  # type: ignore[no-any-return]
        if not isinstance(value, kind) or (kind is int and isinstance(value, bool)):
            raise RequestError(f"{name} must be {_TYPES[kind]}, not {_short(value)}")
        return value


def _short(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 80 else f"{text[:77]}..."
