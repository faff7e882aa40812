"""Tables of cases in TOML, for people who write no Python."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeVar

from cncsub.controls import causes, did_you_mean, near_names
from cncsub.inputs import inputs_from_table, values_of_table
from cncsub.setup import from_toml, setup_from, toml_of
from cncsub.testing.cases import UNKNOWN, Case, read_case
from cncsub.testing.table_keys import check_keys
from cncsub.variables_file import read_variables

T = TypeVar("T")
_NUMBERED = ("vars", "variables", "arguments", "vars_after_reset")  # with variables for keys
# What makes a folder the root of a project; those of the first row count before the others.
_ROOTS = (("cncsub.toml", "pyproject.toml"), (".git",), ("pytest.ini", "tox.ini", "setup.cfg"))


_LATER = "later"  # the control of a case that gets one where it runs


def table_in(file: Path, *, needs_control: bool = True) -> tuple[Case, ...]:
    """Return the cases of a table; see `load_table`. Cases may be without a control where none is
    needed.
    """
    try:
        told = toml_of(file.read_text(encoding="utf-8"))
    except RecursionError:
        raise ValueError(f"{file}: nested too deep") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise ValueError(f"{file}: {error}") from None
    listed = told.pop("case", None)
    if not isinstance(listed, list) or not all(isinstance(row, dict) for row in listed):
        raise ValueError(f"{file}: a table must have cases: [[case]]")
    if "claim" in told:
        raise ValueError(f"{file}: claim belongs in a case, below [[case]]")
    try:
        check_keys(told)
    except ValueError as error:
        raise ValueError(f"{file}: above the cases: {error}") from None
    found = []
    for number, row in enumerate(listed, 1):
        claim = row.get("claim")
        if not isinstance(claim, str):
            raise ValueError(f'{file}: case {number} has no claim = "..."')
        try:
            check_keys(row)
            found.append(_case(file, claim, {**told, **row}, number, needs_control))
        except (OSError, ValueError, TypeError, AttributeError) as error:
            fault = str(error).removeprefix(f"{claim!r} ")
            raise ValueError(f"{file}: case {number}, {claim!r}: {fault}") from None
    return tuple(found)


def _case(
    file: Path, claim: str, said: Mapping[str, Any], number: int, needs_control: bool
) -> Case:
    words = {word: value for word, value in said.items() if word not in ("claim", "load")}
    for name in _NUMBERED:
        if isinstance(words.get(name), dict):
            words[name] = _by_number(name, words[name])
    if "control" not in words and needs_control:
        raise ValueError('it has no control: write control = "fanuc-0i-f"')
    if "alarm" in words:
        _check_alarm(words["alarm"])
        words.setdefault("number", UNKNOWN)  # not compared
    places = _Places(file.parent)
    if isinstance(words.get("variables"), str):
        words["variables"] = read_variables(places.file("variables", words["variables"]))
    for name, read in (("inputs", _inputs), ("setup", _setup)):
        if isinstance(words.get(name), str):
            words[name] = from_toml(places.file(name, words[name]), read)
        elif name in words:
            words[name] = _named(name, read, words[name])
    paths = tuple(places.path("load", name) for name in said.get("load", ()))
    if "load" in said:
        if "files" in words:
            raise ValueError(
                "it has both load and files: give load, or write the texts under files"
            )
        words["files"] = places.texts(paths)
    words.setdefault("control", _LATER)
    case = read_case(claim, topic=file.name, line=number, **words)
    controls = () if case.controls == (_LATER,) else case.controls
    # The files are read where they stand: coverage then counts them together with other tests.
    return replace(case, paths=paths, controls=controls)


def _by_number(name: str, values: Mapping[str, Any]) -> dict[int, float | None]:
    """Return values by the numbers of variables. TOML has no vacant value: it is written
    `"vacant"`.
    """
    found: dict[int, float | None] = {}
    for key, value in values.items():
        digits = key.removeprefix("#")
        if not (digits.isascii() and digits.isdigit() and len(digits) < 10):
            raise ValueError(f"{name} has {key!r}, which is not the number of a variable")
        vacant = isinstance(value, str) and value == "vacant"
        if not vacant and (isinstance(value, bool) or not isinstance(value, int | float)):
            raise ValueError(f'{name}: #{digits} must be a number or "vacant", not {value!r}')
        if int(digits) in found:
            raise ValueError(f"{name} has #{digits} twice")
        found[int(digits)] = None if vacant else value
    return found


def _named(name: str, read: Callable[[dict[str, Any]], T], table: dict[str, Any]) -> T:
    try:
        return read(table)
    except (ValueError, TypeError) as error:
        raise ValueError(f"{name}: {error}") from None


def _inputs(table: dict[str, Any]) -> dict[str, Any]:
    inputs_from_table(table)  # names what is wrong
    return values_of_table(table)


def _setup(table: dict[str, Any]) -> dict[str, Any]:
    setup_from(table)  # names what is wrong
    return table


def _check_alarm(alarm: str) -> None:
    """Raise `ValueError` for an alarm that is neither a cause nor a number of a control."""
    if alarm in causes or any(map(str.isdigit, alarm)):
        return
    near = did_you_mean(alarm, causes)
    raise ValueError(f"alarm must be a number or a cause; there is no cause {alarm!r}{near}")


class _Places:
    """The files that a table names: beside it, and elsewhere in its project."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._root, mark = _project_root(folder)
        self._place = (
            f"project, {self._root}, which has {mark}"
            if mark
            else "table; a cncsub.toml in a folder above both makes them a project"
        )

    def path(self, key: str, name: str) -> Path:
        """Return where a file or folder lies. Raises `ValueError` where that is no part of the
        project, or where there is nothing.
        """
        if "\0" in name:
            raise ValueError(f"{key} has a NUL character, which a name cannot have")
        path = Path(os.path.normpath(self._folder / name))
        if not self._holds(path):
            raise ValueError(f"{key}: {name} is outside the folder of the {self._place}")
        if not path.exists():
            raise ValueError(f"{key}: there is no {name} in the folder of the table{_near(path)}")
        return path

    def file(self, key: str, name: str) -> Path:
        path = self.path(key, name)
        if not path.is_file():
            raise ValueError(f"{key}: {name} is a folder, not a file")
        return path

    def texts(self, paths: tuple[Path, ...]) -> dict[str, bytes]:
        """Return the files of paths by their names, as seen from the table, but those that are
        hidden.
        """
        found: dict[str, bytes] = {}
        for path in paths:
            for each in sorted(path.rglob("[!.]*")) if path.is_dir() else [path]:
                below = each.relative_to(path).parts
                hidden = any(part.startswith(".") for part in below)
                if not hidden and each.is_file() and self._holds(each):
                    name = Path(os.path.relpath(each, self._folder)).as_posix()
                    found[name] = each.read_bytes()
        return found

    def _holds(self, path: Path) -> bool:
        """Return whether a path, its links followed, lies in the project."""
        return Path(os.path.realpath(path)).is_relative_to(os.path.realpath(self._root))


def _near(path: Path) -> str:
    beside = sorted(each.name for each in path.parent.iterdir()) if path.parent.is_dir() else []
    near = near_names(path.name, beside)
    return f"; did you mean {', '.join(near)}?" if near else ""


def _project_root(folder: Path) -> tuple[Path, str]:
    """Return the folder of the project that a folder belongs to, and the file that says so; the
    folder itself and an empty text where none does.
    """
    above = (folder.absolute(), *folder.absolute().parents)
    for marks in _ROOTS:
        for place in above:
            for mark in marks:
                if (place / mark).exists():
                    return place, mark
    return folder.absolute(), ""
