"""The programs that a tool is given: texts, or files below the folders that may be read."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import cncsub

LARGEST_TEXT = 8_000_000  # characters of all texts together
MOST_BLOCKS = 1_000_000
MOST_SECONDS = 10.0
MOST_MEMORY = 1 << 28


class RefusedError(ValueError):
    """A question that is not answered, with the reason and what to ask instead."""


@dataclass(frozen=True)
class Folders:
    """The folders below which files may be read; without any, only texts are taken."""

    roots: tuple[str, ...] = ()

    def path(self, path: str) -> str:
        """Return where a path leads, which is below one of the folders: a relative one below the
        first that has it. `RefusedError` where it is below none, and where there is nothing.
        """
        if "\0" in path:
            raise RefusedError("a path has no NUL")
        missing = []
        for root in self.roots:
            real = os.path.realpath(Path(root) / path)
            if Path(real).is_relative_to(os.path.realpath(root)):
                if os.path.exists(real):  # noqa: PTH110
                    return real
                missing.append(root)
        if missing:
            raise RefusedError(f"there is no {path} in {', '.join(missing)}")
        if not self.roots:
            raise RefusedError("no files are read here: give the texts as programs={name: text}")
        raise RefusedError(f"{path} is not below {', '.join(self.roots)}, and is not read")

    def library(
        self,
        control: str,
        programs: Mapping[str, str] | None,
        paths: Sequence[str] | None,
    ) -> cncsub.Library:
        """Return the memory of a control with texts by the names of their files, or with files."""
        if bool(programs) == bool(paths):
            raise RefusedError("give either programs, texts by their names, or paths")
        if paths:
            return cncsub.load(*map(self.path, paths), control=control)
        assert programs is not None
        if sum(map(len, programs.values())) > LARGEST_TEXT:
            raise RefusedError(f"the texts have more than {LARGEST_TEXT:,} characters")
        return cncsub.loads(programs, control=control)


def limits(max_blocks: int, max_seconds: float) -> dict[str, Any]:
    """Return the limits of a run, none above what the server allows."""
    return {
        "max_blocks": max(0, min(max_blocks, MOST_BLOCKS)),
        "max_seconds": max(0.001, min(max_seconds, MOST_SECONDS)),
        "max_memory": MOST_MEMORY,
    }
