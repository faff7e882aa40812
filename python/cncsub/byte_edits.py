"""Edits of a file as bytes: every byte that no edit names stays as it is, whatever the encoding."""

from __future__ import annotations

import codecs
from collections.abc import Iterable

from cncsub.checking import Edit
from cncsub.lines import lines_of, without_end

_ENCODINGS = ("utf-8", "gb18030", "cp932", "cp1252", "latin-1")  # as files.py detects them
# The encodings whose characters are no bytes of ASCII, with the mark that begins such a file.
_WIDE = (
    (codecs.BOM_UTF32_LE, "utf-32-le"),
    (codecs.BOM_UTF32_BE, "utf-32-be"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)


class NoPlaceError(ValueError):
    """The error where the text of an edit is not in the file where it was read."""


def edited(data: bytes, edits: Iterable[Edit], shown: str) -> bytes:
    """Return the bytes of a file with its edits made. `shown`: its text as it was read, in which
    the edits count lines and columns. Raises `NoPlaceError` where the file is another one.
    """
    for mark, encoding in _WIDE:
        if data.startswith(mark):
            text = data[len(mark) :].decode(encoding, "surrogatepass")
            # Such a text is edited as if it were UTF-8, which has all of its characters.
            again = edited(text.encode("utf-8", "surrogatepass"), edits, shown)
            return mark + again.decode("utf-8", "surrogatepass").encode(encoding, "surrogatepass")
    mark = codecs.BOM_UTF8 if data.startswith(codecs.BOM_UTF8) else b""
    lines = lines_of(data[len(mark) :])
    read = shown.split("\n")
    for edit in sorted(edits, key=lambda edit: edit[1:3], reverse=True):
        line = lines[edit.line - 1] if edit.line <= len(lines) else b""
        text = read[edit.line - 1] if edit.line <= len(read) else ""
        made = _made(line, edit, text)
        if made is None:
            raise NoPlaceError(
                f"{edit.file}:{edit.line}:{edit.column}: there is no {edit.old!r} any more"
            )
        lines[edit.line - 1] = made
    return mark + b"".join(lines)


def _made(line: bytes, edit: Edit, shown: str) -> bytes | None:
    """Return a line with an edit made; `None` where its old text is not there. `shown`: the line as
    it was read. The encoding of the file is one that gives the same line.
    """
    at = edit.column - 1
    for encoding in _ENCODINGS:
        try:
            before, old, new = (
                text.encode(encoding, "surrogateescape")
                for text in (shown[:at], edit.old, edit.new)
            )
        except UnicodeEncodeError:
            continue
        if line.startswith(before + old):
            return before + new + line[len(before) + len(old) :]
    # Words of NC programs are ASCII: what stands after other characters is found from the end.
    behind = shown[at:].rstrip()
    words = without_end(line).rstrip()
    if not behind.isascii() or shown[:at].isascii() or not words.endswith(behind.encode()):
        return None
    place = len(words) - len(behind)
    return line[:place] + edit.new.encode() + line[place + len(edit.old) :]


def place_in(line: bytes, edit: Edit) -> int | None:
    """Return the first byte of an edit's old text in its line, where it stands after nothing but
    ASCII or is in the line once; otherwise `None`.
    """
    old = edit.old.encode("utf-8", "surrogateescape")
    at = edit.column - 1
    if line[:at].isascii() and line.startswith(old, at):
        return at
    return line.index(old) if line.count(old) == 1 else None
