"""Words, tables and links of Markdown."""

from __future__ import annotations

import functools
import re
from collections.abc import Iterable

import cncsub
from cncsub import _core

_SPECIAL = re.compile(r"([\\`*_{}\[\]|#])")
_CODE = re.compile(r"(`[^`]*`)")


def words(text: str) -> str:
    """A text as it stands: what is in backticks stays code, nothing else means anything."""
    parts = _CODE.split(text)
    return "".join(
        part.replace("|", "\\|") if part.startswith("`") else _plain(part) for part in parts
    )


def _plain(text: str) -> str:
    told = _SPECIAL.sub(r"\\\1", text.replace("&", "&amp;"))
    return told.replace("<", "&lt;").replace(">", "&gt;")


def code(text: object) -> str:
    """A text as code, empty where it is; one that holds a backtick is told as words."""
    told = " ".join(str(text).split())
    if not told:
        return ""
    return words(told) if "`" in told else f"`{told}`".replace("|", "\\|")


def table(heads: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    titles = list(heads)
    lines = ["| " + " | ".join(titles) + " |", "|" + " --- |" * len(titles)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def fenced(language: str, text: str) -> str:
    ticks = "`" * max(3, 1 + max(map(len, re.findall("`+", text)), default=0))
    return f"{ticks}{language}\n{text.rstrip()}\n{ticks}\n"


@functools.cache
def anchor(key: str) -> str:
    """The anchor of a source, a rule or a parameter."""
    return re.sub(r"[^a-z0-9]+", "-", key.casefold()).strip("-")


def cited(text: str, up: str) -> str:
    """What a source says, with a link to each source it cites. `up` leads to the folder of docs."""
    if not text:
        return "-"
    keys = sorted(_core.cited(text), key=len, reverse=True)
    if not keys:
        return words(text)
    places = re.compile("|".join(rf"(?<![\w-]){re.escape(key)}(?![\w-])" for key in keys))
    told, at, done = "", 0, set()
    for found in places.finditer(text):
        told += words(text[at : found.start()])
        at = found.end()
        if found[0] in done:
            told += words(found[0])
            continue
        done.add(found[0])
        told += f"[{words(found[0])}]({up}reference/sources.md#{source_anchor(found[0])})"
    return told + words(text[at:])


def source_anchor(key: str) -> str:
    """Unlike for every source, also where two keys differ by a mark."""
    same = [known for known in cncsub.sources if anchor(known) == anchor(key)]
    number = f"-{same.index(key) + 1}" if len(same) > 1 else ""
    return f"source-{anchor(key)}{number}"
