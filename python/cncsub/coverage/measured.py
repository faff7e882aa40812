"""Coverage of what a project names: these files only, also where nothing ran them."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from pathlib import Path

from cncsub import _core
from cncsub._core import Control
from cncsub.coverage.block_counts import MDI, Counted, not_executed, programs_of
from cncsub.coverage.summary import Coverage
from cncsub.files import Reading


def without_mdi(coverage: Coverage) -> Coverage:
    """Return the coverage without what was typed in MDI: it belongs to the tests.

    >>> import cncsub
    >>> from cncsub.coverage.measured import without_mdi
    >>> typed = cncsub.loads("O1\\nN10 M99\\n", control="fanuc-0i-f").mdi("M98 P1").coverage()
    >>> len(typed.blocks), len(without_mdi(typed).blocks)
    (2, 1)
    """
    return Coverage(counted=(p for p in coverage.programs if p.origin != MDI))


def below(coverage: Coverage, paths: Sequence[Path]) -> Coverage:
    """Return the coverage of the programs in some files and folders."""
    tops = [os.path.realpath(path) for path in paths]
    inside = (
        program
        for program in coverage.programs
        if any(Path(os.path.realpath(program.origin)).is_relative_to(top) for top in tops)
    )
    return Coverage(counted=inside)


def with_the_rest(coverage: Coverage, files: Reading, control: Control) -> Coverage:
    """Return the coverage with the programs of files that nobody loaded, as a control reads them:
    none of their blocks is executed. The control takes the files over.
    """
    known = {os.path.realpath(program.origin) for program in coverage.programs}
    code = _core.compile(control, files.rows(False), False)
    left = _unknown(programs_of(not_executed(code)), known)
    return Coverage(counted=[*coverage.programs, *left])


def _unknown(programs: Iterable[Counted], known: set[str]) -> Iterable[Counted]:
    return (program for program in programs if os.path.realpath(program.origin) not in known)
