"""Objects that stay in their process."""

from __future__ import annotations

from typing import ClassVar, NoReturn


class NotPicklable:
    """An object whose state lies in the engine. Pickling it is a `TypeError`, which says what can
    be sent to another process instead.
    """

    _instead: ClassVar[str] = "send the library and what to run"

    def __reduce_ex__(self, protocol: object) -> NoReturn:
        name = type(self).__name__
        raise TypeError(f"{name} objects cannot be sent to another process; {self._instead}")
