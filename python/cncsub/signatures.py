"""Signatures that name each option, for help and editors, where options are handed on."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from typing import Any, TypeVar

F = TypeVar("F", bound=Callable[..., Any])


def spelled_out(
    like: Callable[..., Any], *without: str, defaults: Mapping[str, Any] | None = None
) -> Callable[[F], F]:
    """In place of `**options` the signature shows the keyword options of `like`, with its defaults
    unless there are others.
    """
    others = defaults or {}
    options = {
        name: option.replace(default=others.get(name, option.default))
        for name, option in inspect.signature(like).parameters.items()
        if option.kind is option.KEYWORD_ONLY and name not in without
    }

    def told(function: F) -> F:
        signature = inspect.signature(function)
        own = [p for p in signature.parameters.values() if p.kind is not p.VAR_KEYWORD]
        names = {p.name for p in own}
        more = [option for name, option in options.items() if name not in names]
        function.__signature__ = signature.replace(parameters=[*own, *more])  # type: ignore[attr-defined]
        return function

    return told
