"""Folders on the disk that stand for folders of a control's search path."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

from cncsub._core import Control
from cncsub.controls import did_you_mean
from cncsub.option_errors import wrong_value

StrPath = str | os.PathLike[str]
Search = Mapping[str, StrPath]


def with_search(control: Control, search: Search | None) -> Control:
    """Return the control whose folders have other names on the disk: `{"CUS.DIR": "cycles"}`. A
    folder is known by its last name: each folder `cycles` is CUS.DIR then.

    Raises `ValueError` for a control without a search path, and for a folder that is not in it.
    """
    if not search:
        return control
    known = [folder for folder, _ in searched(control)]
    if not known:
        raise wrong_value("search", f"search: {control.name} has no search path")
    for folder in search:
        if folder.upper() not in known:
            near = did_you_mean(folder.upper(), known, f"; there are {', '.join(known)}")
            raise wrong_value("search", f"search: {folder} is not a folder of the path{near}")
    names = {folder.upper(): Path(os.path.abspath(path)).name for folder, path in search.items()}  # noqa: PTH100
    return control.replace(search_path=" ".join(f"{f}={name}" for f, name in names.items()))


def searched(control: Control) -> list[tuple[str, str]]:
    """Return the folders of a control's search path in their order, each with its other name on the
    disk, empty where it has none.
    """
    [path] = [rule.value for rule in control.rules if rule.name == "search_path"] or [""]
    entries = [entry.partition("=") for entry in str(path).split()]
    return [(folder, disk) for folder, _, disk in entries if folder != "CALLPATH"]
