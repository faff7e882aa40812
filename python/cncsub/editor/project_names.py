"""What can be written where a control is named: in the head of a program, in cncsub.toml."""

from __future__ import annotations

from collections.abc import Iterator

import attrs
from lsprotocol.types import CompletionItem, CompletionItemKind, TextEdit

from cncsub.controls import controls
from cncsub.editor.documents import Document
from cncsub.editor.memory import MARK, is_project

_SIGNS = "\"' ="


def names_at(document: Document, path: str, line: int, character: int) -> list[CompletionItem]:
    """Return the controls or the parameters that can be named at a place, each with the edit that
    it is; nothing where the place names none.
    """
    before = document.line(line)[:character]
    if is_project(path):
        begun = before[max(before.rfind(sign) for sign in _SIGNS) + 1 :]
        found = _of_project(document, line, before)
    else:
        _, mark, begun = before.rpartition(MARK)
        begun = begun.lstrip()
        found = _controls() if mark else iter(())
    place = document.range(line, character - len(begun), len(begun))
    return [
        attrs.evolve(item, text_edit=TextEdit(place, item.label))
        for item in found
        if item.label.upper().startswith(begun.upper())
    ]


def _of_project(document: Document, line: int, before: str) -> Iterator[CompletionItem]:
    table = ""
    for above in range(line):
        text = document.line(above).strip()
        table = text if text.startswith("[") else table
    key, equals, _ = before.partition("=")
    if equals:
        yield from _controls() if key.strip() in ("control", "base") else ()
    elif table in ("[parameters]", "[control.parameters]"):
        yield from _parameters(_control_named(document))


def _control_named(document: Document) -> str:
    """Return the control that a project names, as far as it is written."""
    for number in range(len(document.lines)):
        key, equals, value = document.line(number).partition("=")
        if equals and key.strip() in ("control", "base"):
            return value.split("#")[0].strip(" \t\"'")
    return ""


def _controls() -> Iterator[CompletionItem]:
    for name, control in controls.items():
        yield CompletionItem(name, kind=CompletionItemKind.EnumMember, detail=control.title)


def _parameters(name: str) -> Iterator[CompletionItem]:
    control = controls.get(name)
    for parameter in () if control is None else control.parameters.values():
        kind = CompletionItemKind.Property
        yield CompletionItem(parameter.name, kind=kind, detail=parameter.meaning)
