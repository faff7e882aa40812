"""The server of the Model Context Protocol, with the tools and what an agent is told of them."""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence
from typing import Any

from mcp.server.mcpserver import MCPServer
from mcp.server.mcpserver.exceptions import ToolError
from mcp.server.mcpserver.tools import Tool
from mcp_types import ToolAnnotations

from cncsub._core import __version__
from cncsub.agents.programs import Folders
from cncsub.agents.tools import tools_on
from cncsub.controls import did_you_mean

INSTRUCTIONS = """\
cncsub runs NC programs (G code with subprograms and macros) block by block as a named CNC control \
would, down to the alarm on its screen. Write a program, `check` it, `run` it, and read the alarm: \
its number, the block, the cure. `explain` tells what a code does on one control, by which rule, \
with the source and how sure it is. Nothing is sent to a machine, and no file is written. An alarm \
whose number no source gives has none: do not invent one."""


def server_for(folders: Sequence[str]) -> MCPServer:
    """Return the server whose tools read files below these folders."""
    tools = [_tool(each) for each in tools_on(Folders(tuple(folders)))]
    return MCPServer("cncsub", instructions=INSTRUCTIONS, version=__version__, tools=tools)


class _StrictTool(Tool):
    """A tool that refuses arguments it has not: an option that is dropped in silence would leave
    its agent with another answer than it asked for.
    """

    async def run(self, arguments: dict[str, Any], *given: Any, **more: Any) -> Any:
        known = self.parameters["properties"]
        for name in arguments:
            if name not in known:
                there = f"; it has {', '.join(known)}" if known else "; it has none"
                told = did_you_mean(name, known, there)
                raise ToolError(f"{self.name} has no argument {name!r}{told}")
        return await super().run(arguments, *given, **more)


def _tool(answer: Callable[..., Any]) -> Tool:
    reads_only = ToolAnnotations(read_only_hint=True, idempotent_hint=True, open_world_hint=False)
    tool = _StrictTool.from_function(
        _answered(answer), annotations=reads_only, structured_output=True
    )
    tool.parameters["additionalProperties"] = False
    return tool


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
