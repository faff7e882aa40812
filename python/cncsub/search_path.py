"""Folders on the disk that stand for folders of a control's search path."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from pathlib import Path

from cncsub._core import Control
from cncsub.controls import did_you_mean
from cncsub.option_errors import carrying, wrong_value

StrPath = str | os.PathLike[str]
Search = Mapping[str, StrPath]

MOST_LETTERS = 47  # bytes of the name of a folder, as the rule of a control holds it


def with_search(control: Control, search: Search | None) -> Control:
    """Return the control whose folders have other names on the disk: `{"CUS.DIR": "cycles"}`. A
    folder is known by its last name: each folder `cycles` is CUS.DIR then.

    Raises `ValueError` for a control without a search path, for a folder that is not in it, and for
    a path whose last name cannot stand in one; `TypeError` for what is no mapping of texts to
    paths.
    """
    if search is None:
        return control
    _check(search)
    if not search:
        return control
    known = [folder for folder, _ in searched(control)]
    if not known:
        raise wrong_value("search", f"search: {control.name} has no search path")
    names: dict[str, str] = {}
    for folder, path in search.items():
        name = folder.upper()
        if name not in known:
            near = did_you_mean(name, known, f"; there are {', '.join(known)}")
            raise wrong_value("search", f"search: {folder} is not a folder of the path{near}")
        if name in names:
            raise wrong_value("search", f"search: {folder} is given twice; give it one folder")
        names[name] = _last_name(folder, path)
    return control.replace(search_path=" ".join(f"{f}={name}" for f, name in names.items()))


def _check(search: object) -> None:
    cure = 'give the folders as {"CUS.DIR": "cycles"}'
    if not isinstance(search, Mapping):
        raise carrying(
            "search", TypeError(f"search must be a mapping, not {type(search).__name__}; {cure}")
        )
    for folder, path in search.items():
        if not isinstance(folder, str):
            told = f"search: the folder {folder!r} must be a text; {cure}"
            raise carrying("search", TypeError(told))
        if not isinstance(path, str | os.PathLike):
            told = f"search: {folder} must be a path, not {type(path).__name__}; {cure}"
            raise carrying("search", TypeError(told))


def _last_name(folder: str, path: StrPath) -> str:
    """Return the last name of a path on the disk, which can stand in the rule of the control."""
    if os.path.exists(path) and not os.path.isdir(path):  # noqa: PTH110, PTH112
        raise wrong_value("search", f"search: {folder} must be a folder, and {path} is a file")
    name = Path(os.path.abspath(path)).name  # noqa: PTH100
    wrong = (
        "has no name"
        if not name
        else "has blanks in its name"
        if name.split() != [name]
        else f"has a name of more than {MOST_LETTERS} bytes"
        if len(name.encode("utf-8", "surrogateescape")) > MOST_LETTERS
        else None
    )
    if wrong is not None:
        told = f"search: {folder} cannot be {path}: the folder {wrong}; rename it, or give a link"
        raise wrong_value("search", told)
    return name


def with_folder(path: StrPath, control: Control) -> StrPath:
    """Return a path such that the name of the folder of each of its programs stands in it, where
    the control searches by them: `../SHAFT.WPD/MAIN.MPF` for `MAIN.MPF` in that folder.
    """
    if not searched(control) or not isinstance(path, str | os.PathLike):
        return path
    named = os.fspath(path)
    is_folder = os.path.isdir(named)  # noqa: PTH112
    folder, last = (named, "") if is_folder else os.path.split(named)
    if os.path.basename(os.path.normpath(folder or ".")) not in (".", ".."):  # noqa: PTH119
        return path
    name = os.path.basename(os.path.realpath(folder or "."))  # noqa: PTH119
    if not _tells(name, control):
        return path
    up = os.path.join(folder, "..")  # noqa: PTH118
    if {os.sep, ".."}.issuperset(Path(folder).parts):  # no name in it that may be a link
        up = os.path.normpath(up)
    return os.path.join(up, name, last) if last else os.path.join(up, name)  # noqa: PTH118


def _tells(name: str, control: Control) -> bool:
    """Return whether the name of a folder on the disk says where its programs lie."""
    on_disk = {disk.upper() for _, disk in searched(control)}
    return name.upper() in on_disk or re.search(r"[._](DIR|WPD)$", name, re.I) is not None


def searched(control: Control) -> list[tuple[str, str]]:
    """Return the folders of a control's search path in their order, each with its other name on the
    disk, empty where it has none.
    """
    [path] = [rule.value for rule in control.rules if rule.name == "search_path"] or [""]
    entries = [entry.partition("=") for entry in str(path).split()]
    return [(folder, disk) for folder, _, disk in entries if folder != "CALLPATH"]
