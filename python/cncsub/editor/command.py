"""The command `cncsub lsp`."""

from __future__ import annotations

import contextlib
import os
import sys
from collections.abc import Iterator
from typing import Annotated, BinaryIO

import typer

from cncsub.cli.options import ControlName, of_extra


def lsp(
    control: ControlName = None,
    port: Annotated[
        int | None,
        typer.Option(min=0, max=65535, help="Serve one client on this port of this computer."),
    ] = None,
) -> None:
    """Serve an editor by the Language Server Protocol, over the standard input and output.

    The control of a file is that of a comment in its head, (cncsub: control=fanuc-0i-f), of the
    cncsub.toml beside it, of the editor's settings, or -c. It needs `pip install 'cncsub[lsp]'`.
    """
    with of_extra("lsp", "the server for editors", "pygls", "lsprotocol", "cattrs"):
        from cncsub.editor.requests import server_for
    server = server_for(control)
    if port is None:
        with _only_messages() as output:
            server.start_io(sys.stdin.buffer, output)
    else:
        server.start_tcp("127.0.0.1", port)


@contextlib.contextmanager
def _only_messages() -> Iterator[BinaryIO]:
    """Give the standard output to the protocol alone: what anything else prints is no message, and
    goes to the error stream.
    """
    sys.stdout.flush()
    output = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())
    with contextlib.suppress(BrokenPipeError), output:
        yield output
