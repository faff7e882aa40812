"""The other programs that are measured: which of them are installed, and what they can run."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from importlib import metadata, util
from typing import Any

import texts
from workloads import Workload


@dataclass(frozen=True)
class Peer:
    """A program or module; `program` is its path, which is empty for a module."""

    name: str
    source: str
    found: Callable[[], str | None]  # its version, path or name; None where it is not installed
    job: str  # a job of measure.py
    only_reads: bool = False

    def refuses(self, workload: Workload) -> str | None:
        """Return why the peer is not even tried, or None."""
        if self.job == "lua":
            return None if self.name in workload.own_words else "another language"
        if self.job == "rs274" and len(workload.files) > 1:
            return "takes one program; gcode is the same interpreter"
        if self.only_reads and not workload.plain:
            return "a parser, runs nothing"
        if not workload.blocks and self.name not in workload.own_words:
            return "words of a control"
        return None

    def measurement(self, workload: Workload, files: list[str]) -> dict[str, Any]:
        """Return the job that measures it."""
        if self.job == "module":
            given = {"peer": self.name, "moves": workload.moves, "blocks": workload.blocks}
        else:
            given = {"program": self.found()}
        return {"job": self.job, "files": files, **given}


def module_version(name: str) -> str | None:
    if util.find_spec(name.replace("-", "_")) is None:
        return None
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:
        return "installed"  # no package manager of Python installed it


def module(name: str, source: str = "package index", **more: Any) -> Peer:
    return Peer(name, source, partial(module_version, name), "module", **more)


LINUXCNC = "Debian package linuxcnc-uspace"
PEERS = [
    Peer("rs274", LINUXCNC, partial(shutil.which, "rs274"), "rs274"),
    module("gcode", f"{LINUXCNC}, for the Python of that Debian"),
    module("nc-gcode-interpreter"),
    module("pygcode", only_reads=True),
    module("gcodeparser", only_reads=True),
    *(
        Peer(f"Lua {form}", "Debian package lua5.4", partial(shutil.which, "lua5.4"), "lua")
        for form in texts.LUA_FORMS
    ),
]
