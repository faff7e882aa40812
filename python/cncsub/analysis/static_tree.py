"""The calls of programs as a tree, as their blocks are written: nothing runs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from cncsub.library import Library
    from cncsub.program import Block, Program
    from cncsub.references import Edge

MOST = 10_000  # calls of a tree
_NO_ARGUMENT = frozenset("NGOPLM/")  # addresses
_GIVE_NOTHING = ("M97", "M98", "M198", "M99")
LETTERS = dict(zip((*range(1, 10), 11, 13, *range(17, 27)), "ABCIJKDEFHMQRSTUVWXYZ", strict=True))


def letters(arguments: Mapping[int | str, float | None]) -> str:
    """Return arguments in words: `{1: 30.0, 150: 2.0}` as `A=30 #150=2`, names as they are."""
    return " ".join(
        f"{_word(of)}={'vacant' if value is None else f'{value:.10g}'}"
        for of, value in arguments.items()
    )


def _word(of: int | str) -> str:
    return of if isinstance(of, str) else LETTERS.get(of, f"#{of}")


@dataclass
class StaticCall:
    """A call as it is written. `program` is `None` where it is computed, by `expression`. `again`
    says why the calls of the called program do not follow: `"cycle"` where the program is open
    already, `"above"` where its calls were given before.
    """

    caller: str
    n: int | None
    line: int
    kind: str
    program: str | None
    expression: str | None
    exists: bool | None
    repeats: int | str
    arguments: tuple[str, ...]
    again: str = ""
    calls: list[StaticCall] = field(default_factory=list)

    def __str__(self) -> str:
        passes = "" if self.repeats == 1 else f", {self.repeats} passes"
        given = f" {' '.join(self.arguments)}" if self.arguments else ""
        missing = ", which does not exist" if self.exists is False else ""
        again = {"": "", "cycle": ", which is already open", "above": ", see above"}[self.again]
        at = f"line {self.line}" if self.n is None else f"N{self.n}"
        to = self.program if self.program is not None else f"[{self.expression}]"
        return f"{self.kind} {to}{given}{passes}{missing}{again}, from {self.caller} {at}"

    def facts(self) -> dict[str, Any]:
        """Return the call as plain values, without the calls it makes."""
        kept = {name: value for name, value in vars(self).items() if name != "calls"}
        return {**kept, "arguments": list(self.arguments), "again": self.again or None}


def static_tree(library: Library, main: str | int | None = None) -> tuple[list[StaticCall], bool]:
    """Return the calls of a program in the order of its blocks, and whether all of them
    were taken.
    """
    out: dict[str, list[Edge]] = {}
    for each in library.call_graph().edges:
        out.setdefault(each.caller, []).append(each)
    first = library.main if main is None else library[main]
    roots: list[StaticCall] = []
    if first is None:
        return roots, True
    told: set[str] = set()
    count = 0
    waiting: list[tuple[Iterator[Edge], list[StaticCall], str]] = []
    waiting.append((iter(out.get(first.name, ())), roots, first.name))
    opened = {first.name}
    while waiting:
        edges, calls, _ = waiting[-1]
        edge = next(edges, None)
        if edge is None:
            told.add(name := waiting.pop()[2])
            opened.discard(name)
            continue
        if count == MOST:
            return roots, False
        count += 1
        calls.append(call := _call(library, edge))
        called = call.program
        if called is None or not out.get(called):
            continue
        if called in opened:
            call.again = "cycle"
        elif called in told:
            call.again = "above"
        else:
            waiting.append((iter(out[called]), call.calls, called))
            opened.add(called)
    return roots, True


def _call(library: Library, edge: Edge) -> StaticCall:
    from cncsub.references import Computed

    called, repeats = edge.called, edge.repeats
    return StaticCall(
        edge.caller,
        edge.n,
        edge.line,
        edge.kind,
        None if isinstance(called, Computed) else called,
        called.expression if isinstance(called, Computed) else None,
        edge.exists,
        repeats.expression if isinstance(repeats, Computed) else repeats,
        () if edge.kind in _GIVE_NOTHING else _arguments(library, edge),
    )


def _arguments(library: Library, edge: Edge) -> tuple[str, ...]:
    """Return the words of the block that may be arguments, as they are written."""
    programs = (*_held(library, edge.caller),)
    block = next((b for p in programs if (b := _block_at(p, edge.line)) is not None), None)
    if block is None:
        return ()
    return tuple(w.text for w in block.words if w.address not in _NO_ARGUMENT)


def _held(library: Library, name: str) -> Iterator[Program]:
    if name in library:
        yield library[name]
    if name in library.external:
        yield library.external[name]


def _block_at(program: Program, line: int) -> Block | None:
    """Return the first block of a line. Blocks stand in the order of their lines."""
    low, high = 0, len(program.blocks)
    while low < high:
        middle = (low + high) // 2
        if program.blocks[middle].line < line:
            low = middle + 1
        else:
            high = middle
    found = program.blocks[low] if low < len(program.blocks) else None
    return found if found is not None and found.line == line else None
