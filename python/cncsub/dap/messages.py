"""The frames of the Debug Adapter Protocol: JSON behind a header with its length."""

from __future__ import annotations

import json
import threading
from typing import IO, Any

LARGEST = 16 << 20  # bytes of one message; a client sends no more than a page of text
_LONGEST_LINE, _MOST_LINES = 4096, 32


class LostError(Exception):
    """The stream says no more where the next message begins."""


class NoMessageError(Exception):
    """A message with a proper frame is none: the next one can be read."""


def read_message(stream: IO[bytes]) -> dict[str, Any] | None:
    """Return the next message, `None` at the end of the stream.

    Raises `LostError` for a header without a proper length, and `NoMessageError` for what is no
    JSON object.

    >>> import io
    >>> read_message(io.BytesIO(b'Content-Length: 10\\r\\n\\r\\n{"seq": 3}'))
    {'seq': 3}
    """
    length = _length(stream)
    if length is None:
        return None
    data = bytearray()
    while len(data) < length:
        part = stream.read(length - len(data))
        if not part:
            return None
        data += part
    try:
        message = json.loads(data)
    except (ValueError, RecursionError) as error:
        raise NoMessageError(f"the message is no JSON: {str(error)[:200]}") from None
    if not isinstance(message, dict):
        raise NoMessageError("the message is no JSON object")
    return message


def _length(stream: IO[bytes]) -> int | None:
    """Return the length that a header gives, `None` at the end of the stream."""
    length: int | None = None
    for _ in range(_MOST_LINES):
        line = stream.readline(_LONGEST_LINE)
        if not line:
            return None
        if not line.endswith(b"\n"):
            raise LostError("the header of the message has no end of line")
        if not line.strip():
            if length is None:
                raise LostError("the header of the message has no Content-Length")
            return length
        name, _, value = line.partition(b":")
        if name.strip().lower() == b"content-length":
            digits = value.strip()
            if not digits.isdigit() or len(digits) > 9 or int(digits) > LARGEST:
                raise LostError(f"Content-Length must be 0 to {LARGEST}, not {digits[:20]!r}")
            length = int(digits)
    raise LostError("the header of the message is too long")


class Writer:
    """Writes messages to a stream, one at a time, and counts them."""

    def __init__(self, stream: IO[bytes]) -> None:
        self._stream = stream
        self._lock = threading.Lock()
        self._seq = 0
        self.broken = False  # nobody reads any more

    def write(self, message: dict[str, Any]) -> None:
        with self._lock:
            if self.broken:
                return
            self._seq += 1
            # Only ASCII: every client reads it, whatever stands in names and comments.
            data = json.dumps({"seq": self._seq, **message}, allow_nan=False).encode()
            try:
                self._stream.write(b"Content-Length: %d\r\n\r\n%s" % (len(data), data))
                self._stream.flush()
            except (OSError, ValueError):  # the client is gone
                self.broken = True
