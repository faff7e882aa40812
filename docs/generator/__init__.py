"""Makes the pages of the site that are facts of the package: the controls, causes, sources, rules
of `check`, commands and the Python interface. A page is Markdown by its path below `docs`.

    PYTHONPATH=docs python -m generator build/docs    # all pages, written and made
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from generator import (
    api,
    cause_pages,
    checks,
    commands,
    control_pages,
    house,
    question_pages,
    source_pages,
    table_keys,
)

ROOT = Path(__file__).resolve().parents[2]

# What a written page leaves open: `<!-- made at the build: WHAT -->`.
OPEN: dict[str, Callable[[], str]] = {
    "the table of controls": control_pages.table_of_controls,
    "the other names": control_pages.table_of_aliases,
    "the drawing of the rooms": house.drawing,
    "the keys of tables of cases": table_keys.keys,
}

_PARTS = (control_pages, question_pages, cause_pages, source_pages, checks, commands, api)
GENERATED = sorted(name for part in _PARTS for name in part.names())


def pages() -> dict[str, str]:
    """Every page that is made, by its path."""
    return {name: text for part in _PARTS for name, text in part.pages().items()}


def filled(text: str) -> str:
    """A written page with what it leaves open."""
    for what, made in OPEN.items():
        mark = f"<!-- made at the build: {what} -->"
        if mark in text:
            text = text.replace(mark, made().strip())
    return text
