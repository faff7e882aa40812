"""What an editor's command does with a program: run it, draw its path."""

from __future__ import annotations

import hashlib
from pathlib import Path

from cncsub.editor.last_run import options_of
from cncsub.editor.snapshot import Snapshot
from cncsub.program import find_program
from cncsub.run import Run
from cncsub.run_options import machine_with

MAX_SECONDS = 20.0  # of a run that somebody asked for


def _run(snap: Snapshot, path: str, name: str | None) -> Run | str:
    programs = snap.programs_of(path)
    place = find_program(snap.code, name) if name else -1
    if place < 0 and programs:
        place = programs[0].index
    if place < 0:
        return f"there is no program in {path}"
    core = machine_with(snap.code, place, **options_of(snap.project), max_seconds=MAX_SECONDS)
    core.run()
    return Run(core)


def run_program(snap: Snapshot, path: str, name: str | None) -> str:
    """Run a program with the texts that the editor shows, and return how it stopped."""
    run = _run(snap, path, name)
    return run if isinstance(run, str) else f"{name or ''} {run}".strip()


def plot_program(snap: Snapshot, path: str, name: str | None, folder: Path) -> str:
    """Draw the path of a program as a page in a folder, and return the file; or why there is none.
    The page of a program takes the place of the one before.
    """
    run = _run(snap, path, name)
    if isinstance(run, str):
        return run
    try:
        figure = run.plot()
    except ImportError as error:
        return str(error)
    mark = hashlib.sha256(f"{path} {name}".encode("utf-8", "surrogatepass")).hexdigest()[:12]
    page = folder / f"{Path(path).stem[:40]}-{mark}.html"
    figure.write_html(page)
    return str(page)
