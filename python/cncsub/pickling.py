"""What stays in its process."""

from __future__ import annotations

from typing import ClassVar, NoReturn


class NotPicklable:
    """Something whose state lies in the engine: pickling it is a `TypeError` that tells what can be
    sent to another process instead.
    """

    _instead: ClassVar[str] = "send the library and what to run"

    def __reduce_ex__(self, protocol: object) -> NoReturn:
        name = type(self).__name__
        raise TypeError(f"{name} objects stay in their process; {self._instead}")
