"""Laws of the editor's texts: whatever is edited and asked, the answers are those of the whole text."""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from lsprotocol.types import FormattingOptions, Position, Range

from cncsub.editing import EditError
from cncsub.editor import completing, explaining, navigation, rewriting, shown, symbols
from cncsub.editor.diagnostics import actions, diagnostics
from cncsub.editor.documents import UNITS, Document
from cncsub.editor.memory import Memories, Settings
from cncsub.editor.snapshot import Snapshot

PATH = "/nowhere/part.nc"
CONTROLS = ("fanuc-0i-f", "gsk-988ta", "linuxcnc", "siemens-one", "haas-ngc", "mitsubishi-m800")

# Pieces of programs and of what programs are not.
PIECES = (
    "O1\n", "O2 (SUB)\r\n", "N10 ", "G1 X10. F100", "M98 P2\n", "G65 P2 A1. B#2", "#100=#[1+#2]", "IF[#1EQ2]GOTO10",
    "WHILE[#1LT3]DO1\n", "END1\n", "M99\n", "M30\n", "%\n", "(\U0001f600 \u5f84)", "(", ")", "/2 ", ";", "\r", "\n", "\r\n", "\x00",
    "\u2028", "\x0b", "\ufeff", "\ud800", "o100 sub\n", "o100 endsub\n", "#<a>=1 ", "DEF REAL A=1\n", "LAB: ", "GOTOB LAB\n",
    "T1 M6\n", "X", "1", ".", "[", "]", '"', "N10 X1\n" * 3,
)  # fmt: skip
TEXTS = st.lists(st.sampled_from(PIECES), max_size=14).map("".join)
POSITIONS = st.builds(Position, st.integers(0, 12), st.integers(0, 24))
EDITS = st.tuples(TEXTS, st.none() | st.builds(Range, POSITIONS, POSITIONS))


def offset(text: str, at: Position, units: str) -> int:
    """Return the character of a position, counted through from the head of the text."""
    line = place = 0
    while line < at.line:
        ends = [n for n in (text.find("\n", place), text.find("\r", place)) if n >= 0]
        if not ends:
            return len(text)
        end = min(ends)
        place = end + (2 if text[end : end + 2] == "\r\n" else 1)
        line += 1
    used = 0
    while place < len(text) and text[place] not in "\r\n":
        used += size(text[place], units)
        if used > at.character:
            break
        place += 1
    return place


def size(letter: str, units: str) -> int:
    if units == "utf-32":
        return 1
    if units == "utf-16":
        return len(letter.encode("utf-16-le", "surrogatepass")) // 2
    return len(letter.encode("utf-8", "replace"))


@given(TEXTS, st.lists(EDITS, max_size=6), st.sampled_from(UNITS))
def test_edits_change_the_text_as_the_protocol_says(
    text: str, edits: list[tuple[str, Range | None]], units: str
) -> None:
    document = Document.of(text, units)
    for new, at in edits:
        if at is None:
            text = new
        else:
            first, last = sorted((offset(text, at.start, units), offset(text, at.end, units)))
            text = text[:first] + new + text[last:]
        document = document.edited(new, at)
        assert document.text == text
        assert list(document.lines) == list(Document.of(text).lines)


@given(TEXTS, st.integers(0, 9), st.integers(0, 30), st.sampled_from(UNITS))
def test_a_position_goes_there_and_back(text: str, line: int, character: int, units: str) -> None:
    document = Document.of(text, units)
    character = min(character, len(document.line(line)))
    if line < len(document.lines):
        assert document.place(document.position(line, character)) == (line, character)


ASKED: dict[str, Callable[[Snapshot, int, int], Any]] = {
    "diagnostics": lambda s, _l, _c: diagnostics(s, PATH),
    "definition": lambda s, line, c: navigation.definition(s, PATH, line, c),
    "references": lambda s, line, c: navigation.references(s, PATH, line, c, definitions=True),
    "highlights": lambda s, line, c: navigation.highlights(s, PATH, line, c),
    "calls": lambda s, line, c: [
        (navigation.incoming(s, i), navigation.outgoing(s, i))
        for i in navigation.prepare_calls(s, PATH, line, c)
    ],
    "links": lambda s, _l, _c: navigation.links(s, PATH),
    "hover": lambda s, line, c: explaining.hover(s, PATH, line, c),
    "completion": lambda s, line, c: completing.completions(s, PATH, line, c),
    "signature": lambda s, line, c: completing.signature(s, PATH, line, c),
    "outline": lambda s, _l, _c: symbols.document_symbols(s, PATH),
    "symbols": lambda s, _l, _c: symbols.workspace_symbols(s, "O"),
    "folding": lambda s, _l, _c: symbols.folding(s, PATH),
    "colours": lambda s, line, _c: (
        shown.semantic_tokens(s, PATH),
        shown.semantic_tokens(s, PATH, line, line + 3),
    ),
    "hints": lambda s, _l, _c: shown.inlay_hints(s, PATH, 0, 30),
    "lenses": lambda s, _l, _c: shown.code_lenses(s, PATH, debugs=True),
    "rename": lambda s, line, c: (rewriting.prepare_rename(s, PATH, line, c), _renamed(s, line, c)),
    "format": lambda s, line, _c: (
        rewriting.formatted(s, PATH, FormattingOptions(2, True)),
        rewriting.formatted(s, PATH, FormattingOptions(2, True), line, line + 2),
    ),
    "actions": lambda s, line, _c: actions(s, PATH, Range(Position(line, 0), Position(line + 2, 0))),
}  # fmt: skip


def _renamed(snap: Snapshot, line: int, character: int) -> Any:
    try:
        return rewriting.renamed(snap, PATH, line, character, "77")
    except (EditError, KeyError, ValueError) as error:
        return str(error)


def of_text(text: str, control: str) -> Snapshot:
    memories = Memories(settings=Settings(control, max_blocks=300))
    memories.put(PATH, Document.of(text))
    snap = memories.snapshot(PATH)
    assert snap is not None
    return snap


@settings(deadline=None)
@given(
    st.sampled_from(CONTROLS),
    TEXTS,
    st.lists(st.tuples(EDITS, st.sampled_from(sorted(ASKED)), POSITIONS), min_size=1, max_size=4),
)
def test_the_answers_after_any_edits_are_those_of_the_whole_text(
    control: str, text: str, history: list[Any]
) -> None:
    memories = Memories(settings=Settings(control, max_blocks=300))
    memories.put(PATH, Document.of(text))
    for (new, at), asked, place in history:
        memories.put(PATH, memories.documents[PATH].edited(new, at))
        snap = memories.snapshot(PATH)
        assert snap is not None
        whole = of_text(memories.documents[PATH].text, snap.control.name)
        line, character = snap.document(PATH).place(place)
        assert ASKED[asked](snap, line, character) == ASKED[asked](whole, line, character)
    for ask in ASKED.values():
        ask(memories.snapshot(PATH), line, character)  # type: ignore[arg-type]


@pytest.mark.parametrize("control", CONTROLS)
def test_every_place_told_lies_in_the_text(control: str) -> None:
    text = "".join(PIECES)
    snap = of_text(text, control)
    document = snap.document(PATH)
    ranges = [each.range for each in diagnostics(snap, PATH)]
    for line in range(len(document.lines)):
        for character in range(0, len(document.line(line)) + 1, 3):
            ranges += [each.range for each in navigation.definition(snap, PATH, line, character)]
            with contextlib.suppress(AttributeError):
                ranges.append(explaining.hover(snap, PATH, line, character).range)  # type: ignore[union-attr]
    assert ranges
    for place in ranges:
        for end in (place.start, place.end):
            line, character = document.place(end)
            assert document.position(line, character) == end
