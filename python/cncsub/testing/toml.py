"""Tables of cases in TOML, for people who write no Python."""

from __future__ import annotations

import inspect
import tomllib
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from cncsub.controls import did_you_mean
from cncsub.setup import toml_of
from cncsub.testing.cases import Case, read_case

_WORDS = [*list(inspect.signature(read_case).parameters)[1:], "load"]
_NUMBERED = ("vars", "variables", "arguments", "vars_after_reset")  # with variables for keys


def table_in(file: Path, *, needs_control: bool = True) -> tuple[Case, ...]:
    """Return the cases of a table; see `load_table`."""
    try:
        told = toml_of(file.read_text(encoding="utf-8"))
    except RecursionError:
        raise ValueError(f"{file}: nested too deep") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise ValueError(f"{file}: {error}") from None
    listed = told.pop("case", None)
    if not isinstance(listed, list) or not all(isinstance(row, dict) for row in listed):
        raise ValueError(f"{file}: a table has cases: [[case]]")
    found = []
    for number, row in enumerate(listed, 1):
        claim = row.get("claim")
        if not isinstance(claim, str):
            raise ValueError(f'{file}: case {number} has no claim = "..."')
        try:
            found.append(_case(file, claim, {**told, **row}, number))
        except (ValueError, TypeError, AttributeError) as error:
            raise ValueError(f"{file}: {claim!r}: {error}") from None
    return tuple(found)


def _case(file: Path, claim: str, said: dict[str, Any], number: int) -> Case:
    for word in said:
        if word not in (*_WORDS, "claim"):
            raise ValueError(f"a case has no {word!r}{did_you_mean(word, _WORDS)}")
    words = {word: value for word, value in said.items() if word not in ("claim", "load")}
    for name in _NUMBERED:
        if name in words:
            words[name] = _by_number(name, words[name])
    if "control" not in words:
        raise ValueError('it names no control: control = "fanuc-0i-f"')
    if "load" in said:
        words["files"] = _files(file.parent, said["load"])
    case = read_case(claim, topic=file.name, line=number, **words)
    # The files are read where they stand: coverage then counts them together with other tests.
    return replace(case, paths=tuple(file.parent / name for name in said.get("load", ())))


def _by_number(name: str, values: Any) -> dict[int, float | None]:
    """Return values by the numbers of variables. TOML has no vacant value: it is written
    `"vacant"`.
    """
    if not isinstance(values, Mapping):
        raise TypeError(f"{name} is a table of variables, such as {{100 = 9}}")
    found: dict[int, float | None] = {}
    for key, value in values.items():
        if not key.removeprefix("#").isdigit():
            raise ValueError(f"{name} has {key!r}, which is no number of a variable")
        vacant = isinstance(value, str) and value == "vacant"
        if not vacant and (isinstance(value, bool) or not isinstance(value, int | float)):
            raise ValueError(f'#{key} is a number or "vacant", not {value!r}')
        found[int(key.removeprefix("#"))] = None if vacant else value
    return found


def _files(folder: Path, named: Any) -> dict[str, bytes]:
    """Return the texts of files and folders beside the table."""
    if not isinstance(named, list) or not all(isinstance(name, str) for name in named):
        raise TypeError("load is a list of files and folders")
    found: dict[str, bytes] = {}
    for name in named:
        path = folder / name
        if not path.resolve().is_relative_to(folder.resolve()):
            raise ValueError(f"{name} lies outside the folder of the table")
        if not path.exists():
            raise ValueError(f"there is no {name} beside the table")
        files = sorted(path.rglob("*")) if path.is_dir() else [path]
        for each in files:
            if each.is_file() and each.resolve().is_relative_to(folder.resolve()):
                found[each.relative_to(folder).as_posix()] = each.read_bytes()
    return found
