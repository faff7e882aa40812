"""Pieces of the HTML pages that a notebook shows. They have no scripts, and take the colours of the
page around them, dark or light.
"""

from __future__ import annotations

from collections.abc import Iterable

from cncsub.escapes import escape

_MOST_LINES = 8  # of messages and the like
_MOST_LETTERS = 200  # of a line


def page(parts: Iterable[str]) -> str:
    """Return the parts in one element."""
    return f"<div>{''.join(parts)}</div>"


def cut(text: str) -> str:
    return text if len(text) <= _MOST_LETTERS else text[:_MOST_LETTERS] + " ..."


def pale(text: str) -> str:
    return f'<span style="opacity:.55">{escape(text)}</span>'


def line(text: str, *, strong: bool = False) -> str:
    """Return a paragraph."""
    weight = ' style="font-weight:bold"' if strong else ""
    return f"<p{weight}>{escape(text)}</p>"


def pre(inner: str, style: str = "") -> str:
    return f'<pre style="background:none;color:inherit;{style}">{inner}</pre>'


def plain(text: str) -> str:
    """Return a text with its own spacing."""
    return pre(escape(text))


def marked(text: str) -> str:
    """Return a text with a red bar that is visible on dark and on light pages."""
    return pre(escape(text), "border-left:4px solid #d33;padding-left:.6em")


def few(word: str, texts: Iterable[str]) -> list[str]:
    """Return the first of many texts, each after a word."""
    told = list(texts)
    lines = [line(f"{word}: {cut(text)}") for text in told[:_MOST_LINES]]
    if (left := len(told) - _MOST_LINES) > 0:
        lines.append(line(f"... and {left:,} more"))
    return lines


def table(heads: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    """Return a table of plain texts."""
    head = "".join(f"<th>{escape(name)}</th>" for name in heads)
    body = "".join(
        f"<tr>{''.join(f'<td>{escape(cut(cell))}</td>' for cell in row)}</tr>" for row in rows
    )
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"
