"""Calls drawn as trees."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from cncsub.tables.rows import Call


@dataclass(slots=True, repr=False, eq=False)
class CallTree:
    """One call, or `count` equal calls one after the other, and the calls made in it.

    `caller_step`: the row in `run.steps` of the block that called; `arguments`: the local variables
    that were given. Both are those of the first call. `varied`: whether another call was given
    other arguments.
    """

    kind: str
    program: str
    start_n: int | None
    repeats: int
    blocks: int | None  # executed in one call, called programs included; None where it did not end
    count: int = 1
    calls: list[CallTree] = field(default_factory=list)
    caller_step: int | None = None
    arguments: dict[int | str, float | None] = field(default_factory=dict)
    varied: bool = False

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"<CallTree: {self}, {len(self.calls)} inside>"

    def __eq__(self, other: object) -> bool:
        # Without recursion: programs nest deeper than Python does.
        if not isinstance(other, CallTree):
            return NotImplemented
        pairs = [(self, other)]
        while pairs:
            a, b = pairs.pop()
            if (*_shape(a), a.count, len(a.calls)) != (*_shape(b), b.count, len(b.calls)):
                return False
            pairs.extend(zip(a.calls, b.calls))
        return True

    def __str__(self) -> str:
        start = "" if self.start_n is None else f" from N{self.start_n}"
        passes = "" if self.repeats == 1 else f", {self.repeats} passes"
        count = "" if self.count == 1 else f" x {self.count}"
        blocks = (
            "not ended"
            if self.blocks is None
            else f"{self.blocks} block{'s' if self.blocks != 1 else ''}"
        )
        return f"{self.kind} {self.program}{start}{passes} ({blocks}){count}"


def trees(calls: Sequence[Call]) -> list[CallTree]:
    """Return the calls as trees, built from the last to the first: a call stands after its caller.
    A call whose caller is not among them is a root.
    """
    known = {row.call for row in calls}
    made_in: dict[int | None, list[tuple[int, CallTree]]] = {}
    # Equal trees have equal numbers, so that comparing two of them needs no descent.
    numbers: dict[tuple[object, ...], int] = {}
    for index in range(len(calls) - 1, -1, -1):
        row = calls[index]
        inner = made_in.pop(row.call, [])[::-1]
        blocks = None if row.last_step is None else row.last_step - row.first_step + 1
        tree = CallTree(
            row.kind,
            row.program,
            row.start_n,
            row.repeats,
            blocks,
            1,
            [t for _, t in inner],
            row.caller_step,
            row.arguments,
        )
        shape = (*_shape(tree), tuple((number, t.count) for number, t in inner))
        _add_in_front(
            made_in.setdefault(row.parent if row.parent in known else None, []),
            numbers.setdefault(shape, len(numbers)),
            tree,
        )
    return [tree for _, tree in made_in.get(None, [])[::-1]]


def _shape(tree: CallTree) -> tuple[object, ...]:
    return tree.kind, tree.program, tree.start_n, tree.repeats, tree.blocks


def _add_in_front(trees: list[tuple[int, CallTree]], number: int, tree: CallTree) -> None:
    """Add a tree to a reversed list; a tree equal to its neighbour only raises the count."""
    if trees and trees[-1][0] == number:
        same = trees[-1][1]
        same.count += 1
        same.varied |= same.arguments != tree.arguments
        same.arguments, same.caller_step = tree.arguments, tree.caller_step
    else:
        trees.append((number, tree))


def write_lines(trees: list[CallTree], write: Callable[[str], object], *, most: int) -> None:
    waiting = [(tree, 0) for tree in reversed(trees)]
    written = 0
    while waiting:
        if written == most:
            write("...")
            return
        tree, depth = waiting.pop()
        write("  " * depth + str(tree))
        waiting += [(inner, depth + 1) for inner in reversed(tree.calls)]
        written += 1
