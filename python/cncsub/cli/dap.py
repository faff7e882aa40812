"""The command `cncsub dap`."""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Callable, Mapping
from typing import Annotated, Any

import typer

from cncsub import dap as protocol
from cncsub.cli.options import WrongUseError, wrong_use
from cncsub.cli.ports import Socket, listening_on, speaks_protocol
from cncsub.cli.sessions import session_of
from cncsub.debugging import Session
from cncsub.system import protocol_output

_MOST_CLIENTS = 8


def dap(
    port: Annotated[
        int | None,
        typer.Option(
            help="Listen on this port in place of the standard input; 0 takes a free one.",
            min=0,
            max=65535,
            metavar="N",
        ),
    ] = None,
    host: Annotated[
        str, typer.Option(help="The address to listen on. Whoever reaches it reads your programs.")
    ] = "127.0.0.1",
) -> None:
    """Serve an editor that debugs programs, over the Debug Adapter Protocol."""
    if port is None:
        with protocol_output() as writes:
            protocol.serve(sys.stdin.buffer, writes, make_session)
        return
    with listening_on(host, port) as listening:
        where = ":".join(map(str, listening.getsockname()[:2]))
        typer.echo(f"cncsub dap: listening on {where}")
        sys.stdout.flush()
        _serve_clients(listening)


def _serve_clients(listening: Socket) -> None:
    """Serve each client with a session of its own, some at the same time."""
    free = threading.Semaphore(_MOST_CLIENTS)
    while True:
        client, _ = listening.accept()
        if not free.acquire(blocking=False):
            client.close()
            continue
        threading.Thread(target=_serve_client, args=(client, free), daemon=True).start()


def _serve_client(client: Socket, free: threading.Semaphore) -> None:
    try:
        with client:
            if not speaks_protocol(client):
                return
            with client.makefile("rb") as reads, client.makefile("wb") as writes:
                protocol.serve(reads, writes, make_session)
    except OSError:
        pass  # the client is gone
    finally:
        free.release()


def make_session(options: Mapping[str, Any], tell: Callable[[str], None]) -> Session:
    """Return the session of a launch. What is wrong with it is a `ValueError`."""
    asked = {**options, "control": options["control"] or os.environ.get("CNCSUB_CONTROL")}
    try:
        with wrong_use():
            return session_of(asked, lambda notes: tell("\n".join(f"note: {n}" for n in notes)))
    except WrongUseError as error:
        raise ValueError(str(error)) from None
