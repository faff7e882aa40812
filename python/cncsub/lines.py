"""The lines of a text, counted as the engine counts them."""

from __future__ import annotations

from typing import AnyStr

from cncsub import _core


def lines_of(text: AnyStr) -> list[AnyStr]:
    """Return the lines of a text or of the bytes of a file, each with its end; together they are
    the text.

    >>> lines_of("O1\\n\\r\\rN10 M30\\r\\n%")
    ['O1\\n\\r\\r', 'N10 M30\\r\\n', '%']
    """
    if isinstance(text, str):
        data = text.encode("utf-8", "surrogatepass")
        return [line.decode("utf-8", "surrogatepass") for line in _split(data)]
    return _split(text)


def _split(data: bytes) -> list[bytes]:
    lines, at = [], 0
    for line in _core.unify_line_ends(data).split(b"\n"):
        lines.append(data[at : at + len(line) + 1])
        at += len(line) + 1
    return lines if lines[-1] else lines[:-1]


def diff_of(before: AnyStr, after: AnyStr, file: str, renamed: str | None = None) -> str:
    """Return the changes of a file as a unified diff, in which each line has its end. `renamed`:
    what the file is called afterwards.
    """
    import difflib  # seldom needed

    old, new = ([_shown(line) for line in lines_of(text)] for text in (before, after))
    parts = difflib.unified_diff(old, new, file, renamed or file)
    return "".join(part if part.endswith("\n") else part + "\n" for part in parts)


def _shown(line: str | bytes) -> str:
    return line if isinstance(line, str) else line.decode("utf-8", "surrogateescape")


def without_end(line: AnyStr) -> AnyStr:
    """Return a line of `lines_of` without its end."""
    if isinstance(line, str):
        return line.rstrip("\r\n")
    return line.rstrip(b"\r\n")
