"""Finds the places of a C++ source where a small change would change what it does.

    >>> source = 'if (a < b && ready()) return false;  // a < b'
    >>> for mutant in mutants_of("x.cpp", source):
    ...     print(mutant.column, mutant.before, "->", mutant.after)
    5 a < b && ready() -> !(a < b && ready())
    7 < -> <=
    11 && -> ||
    30 false -> true

Text in quotes, comments and lines of the preprocessor are left alone. Mutants that do not compile
are sorted out later, so the search may be generous.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

# Each operator has spaces around it; the formatter writes none around templates and references.
OPERATORS = {
    "==": "!=",
    "!=": "==",
    "<": "<=",
    "<=": "<",
    ">": ">=",
    ">=": ">",
    "&&": "||",
    "||": "&&",
    "+": "-",
    "-": "+",
    "+=": "-=",
    "-=": "+=",
}
WORDS = {"true": "false", "false": "true", "break": "", "continue": ""}

_HIDDEN = re.compile(
    r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'|^[ ]*#[^\n]*',
    re.DOTALL | re.MULTILINE,
)
_OPERATOR = re.compile(r"(?<= )(?:[=!<>+-]=|&&|\|\||[<>+-])(?=\s)")
_WORD = re.compile(r"\b(?:true|false|break|continue)\b")
_NUMBER = re.compile(r"(?<![\w.])\d+(?![\w.])")
_ENUMERATOR = re.compile(r"\b([A-Z]\w+)::([A-Z]\w+)\b(?!\s*[(:{])")
_CONDITION = re.compile(r"\b(?:if|while) \(")
_NEGATION = re.compile(r"!(?=[\w(])")
_STATEMENT = re.compile(
    r"^[ ]+(?!return|break|continue|using|const\b|case\b|goto)[a-z+(][^\n;{}]*;[ ]*$", re.MULTILINE
)


@dataclass(frozen=True)
class Mutant:
    """One change: `before` at `start` of the file becomes `after`."""

    file: str
    start: int
    line: int
    column: int
    before: str
    after: str

    def applied(self, source: str) -> str:
        return source[: self.start] + self.after + source[self.start + len(self.before) :]

    def __str__(self) -> str:
        before, after = (" ".join(text.split()) for text in (self.before, self.after))
        return f"{self.file}:{self.line}:{self.column}: {before} -> {after or 'nothing'}"


def mutants_of(file: str, source: str) -> list[Mutant]:
    """Return every mutant of a source, in the order of the text."""
    seen = _HIDDEN.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), source)
    found = sorted(set(_changes(seen, source)))
    return [
        Mutant(
            file,
            start,
            source.count("\n", 0, start) + 1,
            start - source.rfind("\n", 0, start),
            source[start:end],
            after,
        )
        for start, end, after in found
    ]


def _changes(seen: str, source: str) -> Iterator[tuple[int, int, str]]:
    for match in _OPERATOR.finditer(seen):
        line = source[source.rfind("\n", 0, match.start()) + 1 : source.find("\n", match.end())]
        if not (
            match[0] in "+-" and ('"' in line or "to_string" in line)
        ):  # here texts are put together
            yield *match.span(), OPERATORS[match[0]]
    for match in _WORD.finditer(seen):
        yield *match.span(), WORDS[match[0]]
    for match in _NUMBER.finditer(seen):
        yield *match.span(), str(int(match[0]) + 1)
    for match in _NEGATION.finditer(seen):
        yield *match.span(), ""
    for match in _CONDITION.finditer(seen):
        end = _closing(seen, match.end())
        inside = seen[match.end() : end]
        # A condition of one comparison or negation is already inverted there.
        one = not re.search(r"&&|\|\|", inside) and re.search(r"^!| [=!<>]=? ", inside)
        if ";" not in inside and not one:
            yield match.end(), end, f"!({source[match.end() : end]})"
    for match in _STATEMENT.finditer(seen):
        start = match.end() - len(match[0].lstrip())
        # A line is a whole statement only after the end of another, or after the head of a block.
        if seen[:start].rstrip().endswith((";", "{", "}", ":", ")")) or not seen[:start].strip():
            yield start, match.end(), ";"
    yield from _other_enumerators(seen)


def _closing(text: str, place: int) -> int:
    """Return where the parenthesis that was opened before `place` is closed."""
    depth = 1
    while depth:
        depth += {"(": 1, ")": -1}.get(text[place], 0)
        place += 1
    return place - 1


def _other_enumerators(seen: str) -> Iterator[tuple[int, int, str]]:
    """Yield the next enumerator of the same type in the source; the last becomes the first."""
    matches = list(_ENUMERATOR.finditer(seen))
    names: dict[str, list[str]] = {}
    for match in matches:
        known = names.setdefault(match[1], [])
        if match[2] not in known:
            known.append(match[2])
    for match in matches:
        known = names[match[1]]
        other = known[(known.index(match[2]) + 1) % len(known)]
        if other != match[2]:
            yield *match.span(), f"{match[1]}::{other}"
