"""What a project says of itself, so that no command needs it again: `cncsub.toml`, or the table
`[tool.cncsub]` of `pyproject.toml`."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from cncsub.checking import SEVERITIES, chosen_rules, rule_named
from cncsub.controls import did_you_mean


@dataclass(frozen=True)
class Project:
    """What `cncsub.toml` may hold; paths are relative to it.

    `control`: the name of the control. `parameters`: those that differ. `setup`, `inputs`: TOML
    files. `variables`: a file of variables before the run. `external`: the folder of the external
    device. `folders`: the programs, where a command names none. `ignore`: rules of `check` that are
    off; `severity`: rules to another severity.
    """

    file: Path | None = None
    control: str | None = None
    parameters: Mapping[str, float] = field(default_factory=dict)
    setup: Path | None = None
    inputs: Path | None = None
    variables: Path | None = None
    external: Path | None = None
    folders: tuple[str, ...] = ()
    ignore: frozenset[str] = frozenset()
    severity: Mapping[str, str] = field(default_factory=dict)


def find_project(folder: Path) -> Project:
    """That of the nearest folder above that has one; an empty one where none has.

    Raises `ValueError` for a file that says what no project can.
    """
    for place in (folder, *folder.parents):
        own = place / "cncsub.toml"
        if own.is_file():
            return _read(own, _toml(own))
        shared = place / "pyproject.toml"
        if shared.is_file():
            tool = _toml(shared).get("tool", {})
            if isinstance(tool, dict) and "cncsub" in tool:
                return _read(shared, tool["cncsub"])
    return Project()


def project_for(paths: Sequence[str] | None) -> Project:
    """That of the folder one stands in; where there is none, that of the first path."""
    here = find_project(Path.cwd())
    if here.file is not None or not paths or paths[0] in ("", "-"):
        return here
    place = Path(paths[0]).absolute()
    return find_project(place if place.is_dir() else place.parent)


def _toml(file: Path) -> dict[str, Any]:
    try:
        return tomllib.loads(file.read_text(encoding="utf-8"))
    except UnicodeDecodeError:
        raise ValueError(f"{file}: it is no text in UTF-8") from None
    except tomllib.TOMLDecodeError as error:
        raise ValueError(f"{file}: {error}") from None


_KINDS: Mapping[str, type] = {
    "control": str,
    "parameters": dict,
    "setup": str,
    "inputs": str,
    "variables": str,
    "external": str,
    "folders": list,
    "check": dict,
}


def _read(file: Path, told: Any) -> Project:
    if not isinstance(told, dict):
        raise ValueError(f"{file}: tool.cncsub is a table")
    for key, value in told.items():
        if key == "tool":
            raise ValueError(
                f"{file}: its keys stand at the top; [tool.cncsub] is for pyproject.toml"
            )
        if key not in _KINDS:
            raise ValueError(f"{file}: a project has no {key!r}{did_you_mean(key, _KINDS)}")
        if not isinstance(value, _KINDS[key]):
            raise ValueError(f"{file}: {key} is a {_NAMES[_KINDS[key]]}, not {value!r}")
    check = told.get("check", {})
    for key in check:
        if key not in ("ignore", "severity"):
            raise ValueError(f"{file}: check has no {key!r}; it takes ignore and severity")

    for folder in told.get("folders", []):
        if not isinstance(folder, str):
            raise ValueError(f"{file}: folders is a list of texts, not {folder!r}")

    def path(name: str) -> Path | None:
        return file.parent / told[name] if name in told else None

    try:
        return Project(
            file,
            told.get("control"),
            _numbers(told.get("parameters", {})),
            path("setup"),
            path("inputs"),
            path("variables"),
            path("external"),
            tuple(str(file.parent / folder) for folder in told.get("folders", [])),
            chosen_rules(check.get("ignore", [])),
            _severities(check.get("severity", {})),
        )
    except (KeyError, TypeError, ValueError) as error:
        raise ValueError(f"{file}: {error.args[0]}") from None


_NAMES: Mapping[type, str] = {str: "text", dict: "table", list: "list"}


def _numbers(parameters: Mapping[str, Any]) -> dict[str, float]:
    for name, value in parameters.items():
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise ValueError(f"the parameter {name} is a number, not {value!r}")
    return {name: float(value) for name, value in parameters.items()}


def _severities(told: Any) -> dict[str, str]:
    if not isinstance(told, dict):
        raise TypeError("check.severity is a table of rules")
    for name, severity in told.items():
        if severity not in SEVERITIES:
            raise ValueError(f"{name} is {severity!r}; a finding is {', '.join(SEVERITIES)}")
    return {rule_named(name).number: severity for name, severity in told.items()}
