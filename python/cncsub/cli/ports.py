"""Ports on which a protocol of editors is served, and who may speak on them."""

from __future__ import annotations

import socket
import time

from cncsub.cli.options import WrongUseError

Socket = socket.socket

# Both protocols begin each message with such a line. A page in a browser can send a request to any
# port of the computer, and its body could be a message: what begins with another line is not read.
_BEGIN = b"content-"
_PATIENCE = 30.0  # seconds until the first bytes


def listening_on(host: str, port: int) -> Socket:
    """Return a socket that listens, or raise `WrongUseError` where none can."""
    try:
        return socket.create_server((host, port))
    except (OSError, OverflowError, UnicodeError) as error:
        raise WrongUseError(f"--port {port} on {host}: {error}") from None


def speaks_protocol(client: Socket) -> bool:
    """Return whether a client begins as the protocols say; its bytes are still there to be read."""
    end = time.monotonic() + _PATIENCE
    while (left := end - time.monotonic()) > 0:
        client.settimeout(left)
        try:
            begun = client.recv(len(_BEGIN), socket.MSG_PEEK).lower()
        except OSError:
            return False
        if not begun or begun != _BEGIN[: len(begun)]:
            return False
        if len(begun) == len(_BEGIN):
            client.settimeout(None)
            return True
        time.sleep(0.01)
    return False
