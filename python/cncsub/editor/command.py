"""The command `cncsub lsp`."""

from __future__ import annotations

import sys
from typing import Annotated

import typer

from cncsub.cli.options import ControlName, of_extra
from cncsub.cli.ports import Socket, listening_on, speaks_protocol
from cncsub.system import protocol_output


def lsp(
    control: ControlName = None,
    port: Annotated[
        int | None,
        typer.Option(min=1, max=65535, help="Serve one client on this port of this computer."),
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
        with protocol_output() as output:
            server.start_io(sys.stdin.buffer, output)
    else:
        with (
            _client(port) as client,
            client.makefile("rb") as reads,
            client.makefile("wb") as writes,
        ):
            server.start_io(reads, writes)


def _client(port: int) -> Socket:
    """Return the first one that speaks the protocol, of those that connect on this computer."""
    with listening_on("127.0.0.1", port) as listening:
        while True:
            client, _ = listening.accept()
            if speaks_protocol(client):
                return client
            client.close()
