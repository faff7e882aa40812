"""The command `cncsub mcp`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from cncsub.cli.options import WrongUseError, of_extra


def mcp(
    folders: Annotated[
        list[Path] | None,
        typer.Argument(help="The folders below which files may be read.", show_default=False),
    ] = None,
) -> None:
    """Serve an agent by the Model Context Protocol, over the standard input and output.

    Without folders the tools take texts alone. It needs `pip install 'cncsub[mcp]'`.
    """
    with of_extra("mcp", "the server for agents", "mcp", "mcp_types", "pydantic"):
        from cncsub.agents.server import server_for
    for folder in folders or ():
        if not folder.is_dir():
            raise WrongUseError(f"{folder} is no folder")
    server_for([str(folder) for folder in folders or ()]).run("stdio")
