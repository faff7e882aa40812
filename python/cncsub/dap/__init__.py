"""The Debug Adapter Protocol: an editor debugs NC programs."""

from __future__ import annotations

from typing import IO

from cncsub.dap.adapter import Adapter, MakeSession
from cncsub.dap.handlers import HANDLERS
from cncsub.dap.stops import tell_pause

__all__ = ["MakeSession", "serve"]


def serve(reads: IO[bytes], writes: IO[bytes], make_session: MakeSession) -> None:
    """Serve one client until it leaves. `make_session` returns a session for the options of a
    launch, which are those of the command line, and is told where to write notes.
    """
    Adapter(reads, writes, make_session, HANDLERS, tell_pause).serve()
