"""Texts of programs and names of files, as each kind of output can take them.

They come from strangers and may hold anything: characters that move a terminal, turn the direction
of a line, or end a cell, a field or an element.
"""

from __future__ import annotations

import functools
import re


def shown(text: str) -> str:
    """Return a text for a terminal, on one line: what is not seen becomes a blank."""
    return text if text.isprintable() else "".join(c if c.isprintable() else " " for c in text)


# Characters that browsers obey or hide: controls, marks that turn the direction of a line, and
# characters without width.
_OBEYED = (
    "[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u180e\u200b-\u200f\u2028-\u202e\u2060-\u206f"
    "\ud800-\udfff\ufeff\ufff9-\ufffb\U000e0000-\U000e007f]"
)
_NOT_XML = "[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]"


@functools.cache
def _compiled(pattern: str) -> re.Pattern[str]:
    return re.compile(pattern)  # when it is needed: such large sets take milliseconds


def escape(text: str, quote: bool = True) -> str:
    """Return a text for HTML: marks are escaped, and a sign replaces what a browser would obey."""
    import html

    return html.escape(_compiled(_OBEYED).sub("\ufffd", text), quote)


def for_xml(text: str) -> str:
    """Return a text in which a sign replaces the characters that XML does not take, not even as
    references.
    """
    return _compiled(_NOT_XML).sub("\ufffd", text)


def referred(xml: str) -> str:
    """Return XML in which what is not seen stands as references, which mean the same."""
    return "".join(c if c.isprintable() or c == "\n" else f"&#{ord(c)};" for c in xml)


_OF_COMMAND = {"%": "%25", "\r": "%0D", "\n": "%0A"}
_OF_PROPERTY = {**_OF_COMMAND, ":": "%3A", ",": "%2C"}


def for_github(text: str, *, property: bool = False) -> str:
    """Return a text for a workflow command of GitHub, which knows no escapes but for
    these marks.
    """
    marks = _OF_PROPERTY if property else _OF_COMMAND
    return "".join(marks.get(c) or shown(c) for c in text)


def cell(text: str) -> str:
    """Return a text as a cell of CSV: on one line, and nothing that a spreadsheet computes."""
    told = shown(text)
    return f"'{told}" if told.lstrip()[:1] in ("=", "+", "-", "@") else told
