"""The texts that an editor shows: lines, edits, and positions in the units of its protocol."""

from __future__ import annotations

import io
from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate

from lsprotocol.types import Position, Range

from cncsub.files import clean

UNITS = ("utf-16", "utf-8", "utf-32")  # what a client may count characters in


def split(text: str) -> list[str]:
    """Return the lines of a text with their ends: `\\n`, `\\r\\n` or `\\r`, as the protocol says.

    >>> split("O1\\r\\nM30\\rM99")
    ['O1\\r\\n', 'M30\\r', 'M99']
    """
    return list(io.StringIO(text, newline=""))


def engine_text(text: str) -> bytes:
    """Return a text as the engine reads it here: a line is a line of the protocol, and a mark of
    the byte order counts as a blank, so that every character keeps its place.
    """
    if text.startswith("\ufeff"):
        text = " " + text[1:]
    if "\r" in text:
        text = text.replace("\r\n", "\n").replace("\r", "\n")
    return clean(text).encode()


@dataclass(frozen=True)
class Document:
    """One version of a text: its lines with their ends. An edit makes another document."""

    lines: Sequence[str]
    units: str = "utf-16"
    version: int | None = None

    @classmethod
    def of(cls, text: str, units: str = "utf-16", version: int | None = None) -> Document:
        """Return the document of a text."""
        return cls(split(text), units, version)

    @property
    def text(self) -> str:
        """The whole text."""
        return "".join(self.lines)

    def line(self, number: int) -> str:
        """Return a line, from 0, without its end; an empty text where there is none."""
        return self.lines[number].rstrip("\r\n") if 0 <= number < len(self.lines) else ""

    def edited(self, text: str, at: Range | None = None) -> Document:
        """Return the document in which `text` stands at a range, or in place of all."""
        if at is None:
            return Document.of(text, self.units, self.version)
        first, begin = self.place(at.start)
        last, end = self.place(at.end)
        if (last, end) < (first, begin):
            first, begin, last, end = last, end, first, begin
        before = self.lines[first][:begin] if first < len(self.lines) else ""
        after = self.lines[last][end:] if last < len(self.lines) else ""
        # A line end may be put together or cut apart: both neighbours are split anew.
        low, high = max(0, first - 1), min(len(self.lines), last + 2)
        head = "".join(self.lines[low:first])
        tail = "".join(self.lines[last + 1 : high])
        new = split(head + before + text + after + tail)
        return Document([*self.lines[:low], *new, *self.lines[high:]], self.units, self.version)

    def place(self, at: Position) -> tuple[int, int]:
        """Return the line and the character, both from 0, of a position; one that is beyond its
        line is at the end of the line, one beyond the text at the end of the text.
        """
        if at.line >= len(self.lines):
            last = len(self.lines) - 1
            if last < 0 or self.lines[last].endswith(("\n", "\r")):
                return len(self.lines), 0
            return last, len(self.lines[last])
        return at.line, character_of(self.line(at.line), at.character, self.units)

    def position(self, line: int, character: int) -> Position:
        """Return the position of a character; both from 0."""
        return Position(line, units_before(self.line(line), character, self.units))

    def range(self, line: int, character: int, width: int) -> Range:
        """Return the range of some characters of a line."""
        return Range(self.position(line, character), self.position(line, character + width))

    def whole_line(self, line: int) -> Range:
        """Return the range of a line without its end."""
        return self.range(line, 0, len(self.line(line)))


def units_before(line: str, character: int, units: str) -> int:
    """Return how many units stand before a character of a line.

    >>> units_before("(\U0001f600)X1", 3, "utf-16"), units_before("(\u00e9)X1", 3, "utf-8")
    (4, 4)
    """
    before = line[: max(0, character)]
    if units == "utf-32" or before.isascii():
        return len(before)
    if units == "utf-8":
        return len(before.encode("utf-8", "replace"))
    return len(before.encode("utf-16-le", "surrogatepass")) // 2


def character_of(line: str, unit: int, units: str) -> int:
    """Return the character of a line in which a unit stands; its length where there is none.

    >>> character_of("(\U0001f600)X1", 4, "utf-16"), character_of("X1", 90, "utf-16")
    (3, 2)
    """
    if units == "utf-32" or line.isascii():
        return min(max(0, unit), len(line))
    sizes = accumulate(_size(letter, units) for letter in line)
    return bisect_right(list(sizes), max(0, unit))


def _size(letter: str, units: str) -> int:
    if units == "utf-16":
        return 2 if letter > "\uffff" else 1
    return len(letter.encode("utf-8", "replace"))
