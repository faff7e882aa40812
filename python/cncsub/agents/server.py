"""The server of the Model Context Protocol, with the tools and what an agent is told of them."""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence
from typing import Any

from mcp.server.mcpserver import MCPServer
from mcp.server.mcpserver.exceptions import ToolError
from mcp_types import ToolAnnotations

from cncsub._core import __version__
from cncsub.agents.programs import Folders
from cncsub.agents.tools import tools_on

INSTRUCTIONS = """\
cncsub runs NC programs (G code with subprograms and macros) block by block as a named CNC control \
would, down to the alarm on its screen. Write a program, `check` it, `run` it, and read the alarm: \
its number, the block, the cure. `explain` tells what a code does on one control, by which rule, \
with the source and how sure it is. Nothing is sent to a machine, and no file is written. An alarm \
whose number no source gives has none: do not invent one."""


def server_for(folders: Sequence[str]) -> MCPServer:
    """Return the server whose tools read files below these folders."""
    server: MCPServer = MCPServer("cncsub", instructions=INSTRUCTIONS, version=__version__)
    reads_only = ToolAnnotations(read_only_hint=True, idempotent_hint=True, open_world_hint=False)
    for tool in tools_on(Folders(tuple(folders))):
        server.add_tool(_answered(tool), annotations=reads_only, structured_output=True)
    return server


def _answered(tool: Callable[..., Any]) -> Callable[..., Any]:
    """Return a tool whose refusals are answers, with the reason."""

    @functools.wraps(tool)
    def answered(**given: Any) -> Any:
        try:
            return tool(**given)
        except (KeyError, OSError, TypeError, ValueError) as error:
            told = error.args[0] if isinstance(error, KeyError) and error.args else error
            raise ToolError(str(told)) from None

    return answered
