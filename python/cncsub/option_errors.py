"""Errors of options: built-in errors that carry the name of the option as `.option`."""

from __future__ import annotations

from typing import TypeVar

E = TypeVar("E", bound=Exception)


def carrying(option: str, error: E) -> E:
    """Return the error, which now names the option that it is about, unless it did so already."""
    if option_of(error) is None:
        error.option = option  # type: ignore[attr-defined]
    return error


def wrong_value(option: str, words: str) -> ValueError:
    """Return the error for a value that an option does not take."""
    return carrying(option, ValueError(words))


def option_of(error: BaseException) -> str | None:
    """Return the option that an error is about."""
    return getattr(error, "option", None)
