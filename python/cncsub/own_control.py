"""A control of your own: a built-in one, with what a machine has otherwise, read from TOML."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from cncsub import _core
from cncsub.control_changes import WITHOUT_NOTE, own_title
from cncsub.controls import Control, causes, control_of, controls, did_you_mean
from cncsub.setup import from_toml as read_toml

KEYS = ("name", "base", "title", "rules", "parameters", "calls", "alarms")
_TABLES = ("rules", "parameters")
_OF_ANY = ("base", *_TABLES)  # what a control without a name of its own may have
_NAME = re.compile(r"[a-z0-9][a-z0-9._-]{0,63}")
_CODE = re.compile(r"[GM][1-9][0-9]{0,3}|[STB]")
_CALL = re.compile(r"(call|macro-call|modal-call|modal-call-every-block):[1-9][0-9]{0,7}")


def from_toml(path: str | os.PathLike[str]) -> Control:
    """Return the control that a TOML file describes; see `Control.from_toml`."""
    name = Path(path).name
    return read_toml(path, lambda told: own_control(_table(told), name))


def _table(told: Mapping[str, Any]) -> Any:
    """Return what a file says of a control: all of it, or its table `control`."""
    tool = told.get("tool")
    of = tool.get("cncsub") if isinstance(tool, dict) else told
    return of.get("control", of) if isinstance(of, dict) else of


def own_control(told: Any, file: str) -> Control:
    """Return the control of a table of TOML; `file` is the source of a value without a note.

    Raises `ValueError` for what no control can be.
    """
    if not isinstance(told, dict):
        raise ValueError(f"a control of your own must be a table with name and base, not {told!r}")
    for key in told:
        if key not in KEYS:
            raise ValueError(f"a control of your own has no {key!r}{did_you_mean(key, KEYS)}")
    if "name" not in told and "base" in told:
        return _changed(told)
    name, base = _name(told), _base(told)
    title = told.get("title", own_title(name, base))
    if not isinstance(title, str) or not title.isprintable():
        raise ValueError(f"title must be a text that can be printed, not {title!r}")
    nobody = WITHOUT_NOTE.format(file)
    tables = {key: _noted(told.get(key, {}), key, nobody) for key in KEYS[3:]}
    rules = [(rule, _rule_value(rule, value), note) for rule, value, note in tables["rules"]]
    calls = [(code, _call(code, to), note) for code, to, note in tables["calls"]]
    if calls:  # they are one rule, and its source gives the note of each
        notes = "; ".join(f"{code}: {note}" for code, _, note in calls)
        rules.append(("registered_codes", " ".join(call for _, call, _ in calls), notes))
    parameters = [(number, _number(number, of), note) for number, of, note in tables["parameters"]]
    alarms = [(_cause(slug), *_alarm(slug, of), note) for slug, of, note in tables["alarms"]]
    return _core.own_control(base, name, title, rules, parameters, alarms)


def _changed(told: Mapping[str, Any]) -> Control:
    """Return the control of a table without a name: a built-in one with other values."""
    base = _base(told)
    for key in told:
        if key not in _OF_ANY:
            raise ValueError(
                f'{key} needs a control with a name of its own: give name = "our-mill"'
            )
    for key in _TABLES:
        if key in told and not isinstance(told[key], dict):
            raise ValueError(f"{key} must be a table, not {told[key]!r}")
        for name, value in told.get(key, {}).items():
            if isinstance(value, dict | list):
                raise ValueError(
                    f"{key}.{name} must be a value: notes are for a control with a name of its own,"
                    ' such as name = "our-mill"'
                )
    parameters, rules = told.get("parameters", {}), told.get("rules", {})
    changed = base.with_parameters({name: _number(name, of) for name, of in parameters.items()})
    return changed.replace(**{rule: _rule_value(rule, of) for rule, of in rules.items()})


def _name(told: Mapping[str, Any]) -> str:
    name = told.get("name")
    if not isinstance(name, str) or not _NAME.fullmatch(name):
        raise ValueError(
            "the name of a control of your own must be small letters, digits, '.', '_' and '-',"
            " such as"
            f' name = "our-mill"; this one is {name!r}'
        )
    if name in controls:
        raise ValueError(f"{name} is a built-in control: give yours another name")
    return name


def _base(told: Mapping[str, Any]) -> Control:
    base = told.get("base")
    if not isinstance(base, str):
        raise ValueError(
            f'base must be a built-in control, such as base = "fanuc-0i-f", not {base!r}'
        )
    return control_of(base)


def _noted(told: Any, key: str, nobody: str) -> Iterator[tuple[str, Any, str]]:
    """Yield the entries of a table, each with its value and its note."""
    if not isinstance(told, dict):
        raise ValueError(f"{key} must be a table, not {told!r}")
    for name, told_of in told.items():
        for value in told_of if isinstance(told_of, list) and key == "rules" else [told_of]:
            yield name, *_value_and_note(value, f"{key}.{name}", nobody, key == "alarms")


def _value_and_note(value: Any, name: str, nobody: str, is_alarm: bool) -> tuple[Any, str]:
    """Return a value of a table and its note; of an alarm its table without the note."""
    if not isinstance(value, dict):
        return value, nobody
    of = dict(value)
    note = of.pop("note", nobody)
    if not isinstance(note, str) or not note.isprintable():
        raise ValueError(f"{name}: a note must be a text that can be printed, not {note!r}")
    if is_alarm:
        return of, note
    if set(of) != {"value"}:
        raise ValueError(f'{name} must be a value, or {{value = ..., note = "..."}}, not {value!r}')
    return of["value"], note


def _rule_value(rule: str, value: Any) -> bool | int | str:
    if isinstance(value, bool | int | str):
        return value
    raise ValueError(f"rules.{rule} must be true or false, a whole number or a text, not {value!r}")


def _call(code: str, to: Any) -> str:
    if not _CODE.fullmatch(code):
        raise ValueError(
            f"calls.{code}: a code that calls must be G1 to G9999, M1 to M9999, S, T or B"
        )
    if not isinstance(to, str) or not _CALL.fullmatch(to):
        raise ValueError(
            f"calls.{code} must be call:9001, macro-call:9010, modal-call:9010"
            f" or modal-call-every-block:9010, not {to!r}"
        )
    return f"{code}={to}"


def _number(parameter: str, value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise ValueError(f"parameters.{parameter} must be a number, not {value!r}")
    return float(value)


def _cause(slug: str) -> str:
    if slug not in causes:
        raise ValueError(f"alarms.{slug}: there is no cause {slug!r}{did_you_mean(slug, causes)}")
    return slug


def _alarm(slug: str, told: Any) -> tuple[str | None, str | None]:
    """Return the number and the text of an alarm, where they are given."""
    of = {"number": told} if isinstance(told, str) else told
    if not isinstance(of, dict) or not of or not set(of) <= {"number", "text"}:
        raise ValueError(
            f'alarms.{slug} must be a number, or {{number = "PS0077", text = "...", note = "..."}},'
            f" not {told!r}"
        )
    for key, value in of.items():
        if not isinstance(value, str) or not value or not value.isprintable():
            raise ValueError(
                f"alarms.{slug}.{key} must be a text that can be printed, not {value!r}"
            )
    return of.get("number"), of.get("text")
