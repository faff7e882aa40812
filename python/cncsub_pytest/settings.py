"""The control of a test: of the command line, the settings, or the project."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    import cncsub

_PROJECTS = pytest.StashKey[dict[Path, tuple[str, ...]]]()
WHERE = (
    "Give --control, the setting cncsub_control, control in cncsub.toml, or"
    ' @pytest.mark.cnc("fanuc-0i-f"); in a table control = "fanuc-0i-f"'
)


def controls_for(config: pytest.Config, folder: Path, own: Any = ()) -> list[str]:
    """Return the controls of the command line, else the test's own, else those by default."""
    own = [own] if isinstance(own, str) else list(own)
    return config.getoption("--control") or own or default_controls(config, folder)


def default_controls(config: pytest.Config, folder: Path) -> list[str]:
    """Return the controls of the command line, else of the settings, else of the project that a
    folder belongs to.
    """
    asked: list[str] = config.getoption("--control") or config.getini("cncsub_control")
    return asked or list(_of_project(config, folder))


def _of_project(config: pytest.Config, folder: Path) -> tuple[str, ...]:
    """Return the control of the project, which is read once for each folder."""
    known = config.stash.setdefault(_PROJECTS, {})
    if folder not in known:
        from cncsub.cli.project import find_project

        try:
            control = find_project(folder).control
        except ValueError as error:
            raise pytest.UsageError(str(error)) from None
        known[folder] = () if control is None else (control,)
    return known[folder]


def control_named(name: str, folder: Path) -> cncsub.Control:
    """Return the control of a name: a built-in one, or one of the project a folder belongs to."""
    from cncsub.cli.project import find_project

    return find_project(folder).control_named(name)
