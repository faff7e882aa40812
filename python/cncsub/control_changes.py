"""What sets a changed control apart from the control it was made from: its name, and its TOML."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, NamedTuple

from cncsub._core import Control, Rule
from cncsub.controls import controls

BY_CALLER = "set by the caller"  # the engine's source of what `replace` sets
WITHOUT_NOTE = "as {} says, without a note"
_NO_NOTE = re.compile(WITHOUT_NOTE.format(".*"))
_BARE = re.compile(r"[A-Za-z0-9_-]+")
_SHOWN = 4  # changes in a name
_LETTERS = 40  # of a value in a name


class Change(NamedTuple):
    """A rule or a parameter with another value than before, as `replace` takes it, and where the
    value comes from.
    """

    name: str
    value: bool | int | float | str
    source: str


def name_of(own: str, control: Control) -> str:
    """Return the name of a control that a caller has changed: `fanuc-0i-f + max_nesting=3`."""
    state = _state(control)
    changes = [*_parameters(state), *_rules(control, state)]
    if _is_own(state):
        changes = [change for change in changes if change.source == BY_CALLER]
    told = [f"{name}={_shown(value)}" for name, value, _ in changes[:_SHOWN]]
    if (more := len(changes) - _SHOWN) > 0:
        told.append(f"and {more} more")
    return f"{own} + {', '.join(told)}" if told else own


def _shown(value: bool | int | float | str) -> str:
    if isinstance(value, float):
        return f"{value:g}"
    text = str(value)
    return text if len(text) <= _LETTERS else f"{text[:_LETTERS]}..."


def to_toml(control: Control) -> str:
    """Return a control as the TOML that `from_toml` reads; see `Control.to_toml`."""
    state = _state(control)
    head: dict[str, Any] = {"base": control.base}
    if _is_own(state):
        head = {"name": state[3], **head}
        if control.title != own_title(state[3], controls[control.base]):
            head["title"] = control.title
    tables = {
        "rules": _table(_rules(control, state), state),
        "parameters": _table(_parameters(state), state),
        "alarms": dict(_alarms(control, state)),
    }
    lines = [f"{key} = {_written(value)}" for key, value in head.items()]
    for name, table in tables.items():
        if table:
            lines += ["", f"[{name}]"]
            lines += [f"{_key(key)} = {_written(value)}" for key, value in table.items()]
    return "\n".join(lines) + "\n"


def own_title(name: str, base: Control) -> str:
    """Return the title of a control of one's own that gives none."""
    return f"{name} ({base.title})"


# A control as it is pickled: the name of its base, its parameters, its rules; of one's own also its
# name, its title, its parameters with their sources, its alarms.
_State = tuple[Any, ...]


def _state(control: Control) -> _State:
    state: _State = control.__reduce__()[1][0]
    return state


def _is_own(state: _State) -> bool:
    return len(state) > 3


def _parameters(state: _State) -> Iterator[Change]:
    sources = {name: (value, source) for name, value, source in state[5]} if _is_own(state) else {}
    for name, value in state[1].items():
        if name not in sources:
            yield Change(name, value, BY_CALLER)
    for name, (value, source) in sources.items():
        yield Change(name, value, source)


def _rules(control: Control, state: _State) -> Iterator[Change]:
    """Yield the rules that differ from those of the base with the same parameters. A list whose
    entries have several sources is several changes.
    """
    base = controls[control.base].with_parameters(state[1])
    before, now = _by_name(base), _by_name(control)
    for name, (_, source, sources) in state[2].items():
        if name not in now:  # what the language of the control does not ask
            continue
        rule, of = now[name], before[name]
        noted = _is_own(state) and source != of.source
        if given := _given(sources, of.sources):
            yield from _entry_changes(base, of, rule, given)
        elif rule.value != of.value or noted:
            is_list = isinstance(rule.value, str) and not rule.choices
            yield Change(name, _list_change(base, of, rule) if is_list else rule.value, source)


def _by_name(control: Control) -> dict[str, Rule]:
    return {rule.name: rule for rule in control.rules}


def _given(
    sources: Mapping[str, tuple[str, str]], before: Mapping[str, tuple[str, str]]
) -> dict[str, list[str]]:
    """Return by source the entries that it alone gives or takes away."""
    given: dict[str, list[str]] = {}
    for entry, (source, evidence) in sources.items():
        if before.get(entry) != (source, evidence):
            given.setdefault(source, []).append(entry)
    return given


def _entry_changes(
    base: Control, before: Rule, now: Rule, given: Mapping[str, list[str]]
) -> Iterator[Change]:
    if len(given) == 1:
        (source,) = given
        if now.value != before.value:
            yield Change(now.name, _list_change(base, before, now), source)
        return
    for source, entries in given.items():
        if changes := _entry_words(before, now, entries):
            yield Change(now.name, " ".join(changes), source)


def _list_change(base: Control, before: Rule, now: Rule) -> str:
    """Return the shortest text with which `replace` makes one list of another."""
    changes = " ".join(_list_words(before, now))
    for text in (changes, str(now.value)):
        if text and _list_after(base, now.name, text) == now.value:
            return text
    return f"= {now.value}"


def _list_after(base: Control, name: str, text: str) -> object:
    try:
        return _by_name(base.replace(**{name: text}))[name].value
    except ValueError:
        return None


def _list_words(before: Rule, now: Rule) -> list[str]:
    """Return the entries that came, and with a `-` those that went."""
    was, has = _entries(before), _entries(now)
    came = [entry for key, entry in has.items() if was.get(key) != entry]
    return [*came, *(f"-{key}" for key in was if key not in has)]


def _entry_words(before: Rule, now: Rule, keys: Iterable[str]) -> list[str]:
    """Return these entries as they are now: there, or taken away."""
    was, has = _entries(before), _entries(now)
    return [has.get(key, f"-{key}") for key in keys if key in has or key in was]


def _entries(rule: Rule) -> dict[str, str]:
    return {entry.partition("=")[0]: entry for entry in str(rule.value).split()}


def _table(changes: Iterator[Change], state: _State) -> dict[str, Any]:
    """Return a table of TOML: values alone, or with their notes; several of one name as a list."""
    values: dict[str, list[Any]] = {}
    for name, value, source in changes:
        noted = _is_own(state) and not _NO_NOTE.fullmatch(source)
        plain = int(value) if isinstance(value, float) and value.is_integer() else value
        values.setdefault(name, []).append({"value": plain, "note": source} if noted else plain)
    return {name: of if len(of) > 1 else of[0] for name, of in values.items()}


def _alarms(control: Control, state: _State) -> Iterator[tuple[str, Any]]:
    for slug, number, text, source in state[6] if _is_own(state) else ():
        entry = control.alarms[slug]
        told = {"number": number, "text": text}
        if number is None and text is None:
            told = {"number": entry.number or None, "text": None if entry.number else entry.text}
        if not _NO_NOTE.fullmatch(source):
            told["note"] = source
        yield slug, {key: value for key, value in told.items() if value is not None}


def _key(name: str) -> str:
    return name if _BARE.fullmatch(name) else _written(name)


def _written(value: Any) -> str:
    """Return a value as TOML writes it. The escapes of JSON are those of TOML."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, dict):
        return f"{{ {', '.join(f'{_key(key)} = {_written(of)}' for key, of in value.items())} }}"
    if isinstance(value, list):
        return f"[{', '.join(map(_written, value))}]"
    return json.dumps(value, ensure_ascii=False) if isinstance(value, str) else repr(value)
