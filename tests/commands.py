"""Commands that tests start as processes of their own."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path


def call(*command: object, **options: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [str(word) for word in command], capture_output=True, text=True, check=False, **options
    )


def done(*command: object, **options: object) -> str:
    """Return what a command prints, which has to end well."""
    result = call(*command, **options)
    assert result.returncode == 0, result.stdout[-3000:] + result.stderr[-3000:]
    return result.stdout


def path_with_cncsub(folder: Path) -> str:
    """Make `cncsub` a command in a new folder, and return the path of commands that begins there."""
    folder.mkdir()
    command = folder / "cncsub"
    command.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m cncsub "$@"\n')
    command.chmod(0o755)
    return f"{folder}{os.pathsep}{os.environ['PATH']}"
