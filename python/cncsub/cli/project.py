"""The settings of a project, which no command then has to repeat: `cncsub.toml`, or the table
`[tool.cncsub]` of `pyproject.toml`.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from cncsub import system
from cncsub.controls import Control, control_named, controls, did_you_mean
from cncsub.own_control import own_control
from cncsub.search_path import with_search
from cncsub.setup import toml_of

PLACES = ("setup", "inputs", "variables", "external")  # what a project names


@dataclass(frozen=True)
class Project:
    """The contents of `cncsub.toml`; paths are relative to it.

    `control`: the name of the control; `own_control`: where a table describes it, the control that
    it makes. `parameters`: those that differ. `places`: the paths it names for `setup` and
    `inputs`, TOML files, for `variables`, a file of variables before the run, and for `external`,
    the folder of the external device. `folders`: the programs, where a command names none.
    `entry`: the programs that something outside of the folders calls, by name or pattern.
    `search`: folders of the control's search path that have other names on the disk.
    `ignore`: rules of `check` that are off; `severity`: rules to another severity. `own`: whether
    it is the user's own project, which may name what lies outside its folder.
    """

    file: Path | None = None
    control: str | None = None
    own_control: Control | None = None
    parameters: Mapping[str, float] = field(default_factory=dict)
    places: Mapping[str, Path] = field(default_factory=dict)
    programs: tuple[Path, ...] = ()
    ignore: frozenset[str] = frozenset()
    severity: Mapping[str, str] = field(default_factory=dict)
    entry: tuple[str, ...] = ()
    search: Mapping[str, Path] = field(default_factory=dict)
    own: bool = True

    def control_named(self, name: str) -> Control:
        """Return the control of this name: a built-in one, or the project's own. `ValueError`
        suggests similar names.
        """
        own = {} if self.own_control is None else {self.own_control.name: self.own_control}
        return control_named(name, {**own, **controls})

    def configured(self, control: Control, name: str | None) -> Control:
        """Return the control of a name with the parameters and the search path of the project,
        where it is the one that the project names.
        """
        if name != self.control:
            return control
        if self.parameters:
            control = control.with_parameters(dict(self.parameters))
        return with_search(control, self.search)

    @property
    def setup(self) -> Path | None:
        """The TOML file of the setup."""
        return self._place("setup")

    @property
    def inputs(self) -> Path | None:
        """The TOML file of the inputs, which answer while a program runs."""
        return self._place("inputs")

    @property
    def variables(self) -> Path | None:
        """The file of variables before the run."""
        return self._place("variables")

    @property
    def external(self) -> Path | None:
        """The folder of the external device."""
        return self._place("external")

    @property
    def folders(self) -> tuple[str, ...]:
        """The files and folders of the programs."""
        searched = self.search.values() if self.programs else ()
        return tuple(str(self._allowed("folders", path)) for path in (*self.programs, *searched))

    def outside(self, name: str) -> Path | None:
        """Return where a place really lies that is outside the folder of the project."""
        path = self.places.get(name)
        return None if path is None or self._holds(path) else Path(os.path.realpath(path))

    @property
    def programs_outside(self) -> list[Path]:
        """The real paths of the programs that are outside the folder of the project."""
        return [
            Path(os.path.realpath(path))
            for path in (*self.programs, *self.search.values())
            if not self._holds(path)
        ]

    def _place(self, name: str) -> Path | None:
        path = self.places.get(name)
        return None if path is None else self._allowed(name, path)

    def _allowed(self, name: str, path: Path) -> Path:
        if self.own or self._holds(path):
            return path
        cure = "name the programs" if name == "folders" else f"give --{name} {path}"
        raise ValueError(
            f"{self.file}: {name} is outside the folder of the project, at"
            f" {os.path.realpath(path)}, and is read"
            f" only for a project of your own, in whose folder you stand: {cure}"
        )

    def _holds(self, path: Path) -> bool:
        """Return whether a path, its links followed, lies in the folder of the project."""
        assert self.file is not None
        return Path(os.path.realpath(path)).is_relative_to(os.path.realpath(self.file.parent))


def find_project(folder: Path) -> Project:
    """Return the project of the nearest folder above that has one; an empty project where none has.

    Raises `ValueError` for a file that says what no project can.
    """
    return _found(folder, own=True)


def project_beside(folder: Path) -> Project:
    """Return the project of a folder that somebody else may have written: it is not the user's own,
    and names nothing outside its folder.
    """
    return _found(folder, own=False)


def _found(folder: Path, *, own: bool) -> Project:
    for place in (folder, *folder.parents):
        for name in ("cncsub.toml", "pyproject.toml"):
            file = place / name
            if not file.is_file():
                continue
            real = Path(os.path.realpath(file))
            if not own and not real.is_relative_to(os.path.realpath(place)):
                raise ValueError(f"{file} is a link to a file outside its folder, and is not read")
            told = _toml(file)
            if name == "pyproject.toml":
                tool = told.get("tool", {})
                if not isinstance(tool, dict) or "cncsub" not in tool:
                    continue
                told = tool["cncsub"]
            return replace(_read(file, told), own=own and system.is_ours(file))
    return Project()


def project_for(paths: Sequence[str] | None) -> Project:
    """Return the project of the current folder; where it has none, that of the first path. Programs
    come from strangers, and so may the file beside them: such a project is not the user's own, nor
    is one that belongs to another user.
    """
    here = _found(Path.cwd(), own=True)
    if here.file is not None or not paths or paths[0] in ("", "-"):
        return here
    place = Path(paths[0]).absolute()
    return _found(place if place.is_dir() else place.parent, own=False)


def _toml(file: Path) -> dict[str, Any]:
    import tomllib

    try:
        return toml_of(file.read_text(encoding="utf-8"))
    except RecursionError:
        raise ValueError(f"{file}: nested too deep") from None
    except UnicodeDecodeError:
        raise ValueError(f"{file}: it is not a text in UTF-8") from None
    except tomllib.TOMLDecodeError as error:
        raise ValueError(f"{file}: {error}") from None


_KINDS: Mapping[str, type | tuple[type, ...]] = {
    "control": (str, dict),
    "parameters": dict,
    "setup": str,
    "inputs": str,
    "variables": str,
    "external": str,
    "folders": list,
    "entry": list,
    "search": dict,
    "check": dict,
}


def _read(file: Path, told: Any) -> Project:
    if not isinstance(told, dict):
        raise ValueError(f"{file}: tool.cncsub must be a table")
    for key, value in told.items():
        if key == "tool":
            raise ValueError(
                f"{file}: its keys belong at the top of the file; [tool.cncsub] is for"
                " pyproject.toml"
            )
        if key not in _KINDS:
            raise ValueError(f"{file}: a project has no {key!r}{did_you_mean(key, _KINDS)}")
        if not isinstance(value, _KINDS[key]):
            raise ValueError(f"{file}: {key} must be a {_NAMES[_KINDS[key]]}, not {value!r}")
        if isinstance(value, str) and "\0" in value:
            raise ValueError(f"{file}: {key} has a NUL character, which a name cannot have")
    check = told.get("check", {})
    for key in check:
        if key not in ("ignore", "severity"):
            raise ValueError(f"{file}: check has no {key!r}; its keys are ignore and severity")

    for key in ("folders", "entry"):
        for text in told.get(key, []):
            if not isinstance(text, str):
                raise ValueError(f"{file}: {key} must be a list of texts, not {text!r}")

    try:
        named = told.get("control")
        own = own_control(named, file.name) if isinstance(named, dict) else None
        return Project(
            file,
            named if own is None else own.name,
            own,
            _numbers(told.get("parameters", {})),
            {name: file.parent / told[name] for name in PLACES if name in told},
            tuple(file.parent / folder for folder in told.get("folders", [])),
            _ignored(check.get("ignore", [])),
            _severities(check["severity"]) if "severity" in check else {},
            tuple(told.get("entry", ())),
            _search(file, told.get("search", {})),
        )
    except (KeyError, TypeError, ValueError) as error:
        raise ValueError(f"{file}: {error.args[0]}") from None


_NAMES: Mapping[type | tuple[type, ...], str] = {
    str: "text",
    dict: "table",
    list: "list",
    (str, dict): "text or a table",
}


def _search(file: Path, told: Mapping[str, Any]) -> dict[str, Path]:
    for folder, path in told.items():
        if not isinstance(path, str):
            raise ValueError(f"search: the folder {folder} must be a path, not {path!r}")
    return {folder: file.parent / path for folder, path in told.items()}


def _numbers(parameters: Mapping[str, Any]) -> dict[str, float]:
    for name, value in parameters.items():
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise ValueError(f"the parameter {name} must be a number, not {value!r}")
    return {name: float(value) for name, value in parameters.items()}


def _ignored(told: Any) -> frozenset[str]:
    if told == []:
        return frozenset()
    from cncsub.checking import chosen_rules  # most commands ask for no rules

    return chosen_rules(told)


def _severities(told: Any) -> dict[str, str]:
    from cncsub.checking import SEVERITIES, rule_named

    if not isinstance(told, dict):
        raise TypeError("check.severity must be a table of rules")
    for name, severity in told.items():
        if severity not in SEVERITIES:
            raise ValueError(f"{name} is {severity!r}; a severity must be {', '.join(SEVERITIES)}")
    return {rule_named(name).number: severity for name, severity in told.items()}
