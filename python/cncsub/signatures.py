"""Signatures that name each option, for help and editors, where options are handed on."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable
from typing import Any, TypeVar

F = TypeVar("F", bound=Callable[..., Any])


def with_options(function: F, options: Iterable[inspect.Parameter]) -> F:
    """Show these options in the signature in place of `**options`, but for those it names
    itself.
    """
    signature = inspect.signature(function)
    own = [p for p in signature.parameters.values() if p.kind is not p.VAR_KEYWORD]
    names = {p.name for p in own}
    more = [option for option in options if option.name not in names]
    function.__signature__ = signature.replace(parameters=[*own, *more])  # type: ignore[attr-defined]
    # Python itself uses these for named parameters alone; tools that read them find the options
    # too.
    function.__kwdefaults__ = {
        **(getattr(function, "__kwdefaults__", None) or {}),
        **{option.name: option.default for option in more},
    }
    return function


def spelled_out(like: Callable[..., Any], *without: str) -> Callable[[F], F]:
    """Return a decorator that shows the keyword options of `like` in place of `**options`."""
    options = [
        option
        for name, option in inspect.signature(like).parameters.items()
        if option.kind is option.KEYWORD_ONLY and name not in without
    ]
    return lambda function: with_options(function, options)
