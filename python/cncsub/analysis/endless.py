"""Why a program had not ended when its run was stopped."""

from __future__ import annotations

import enum
from dataclasses import dataclass

from cncsub import _core

MOST_BLOCKS = 12  # of a loop, in a text


class Why(enum.StrEnum):
    """The kind of program that does not end: `REPEATS` (by design: M99 of the main program starts
    it over), `LOOP` (the whole state came back exactly, so that it never ends), `WAITING` (for an
    input that is not given), `LONG` (nothing is proven: it may end).
    """

    REPEATS = "repeats"  # by design: M99 of the main program starts it over
    LOOP = "loop"  # the whole state came back exactly, without a look outside: it never ends
    WAITING = "waiting"  # for an input that is not given
    LONG = "long"  # nothing is proven: it may end


@dataclass(frozen=True, slots=True)
class LoopBlock:
    """One block of a loop. `text` is the block as it is written."""

    program: str
    n: int | None
    line: int
    file: str
    text: str

    def __str__(self) -> str:
        where = f"line {self.line}" if self.n is None else f"N{self.n}"
        return f"{self.program} {where}"


@dataclass(frozen=True, slots=True)
class Endless:
    """Why a program had not ended when its run was stopped; `str(endless)` says it.

    `proven`: the whole state of the control came back exactly (variables of all levels, open calls
    with their passes, open loops, modes, position, what inputs are left), so that the program never
    ends. `period` counts the blocks between the two equal states, 0 where the state did not come
    back. Where it did, but the loop reads what the world outside may change, `outside` names that
    (`#3012`, `#1000`, `the skip signal`), and nothing is proven. `blocks` are those of the loop,
    each once, in the order in which they run, from the outermost program's first one on; the block
    that starts the program over where it `repeats`; the block that waits.

    `looked` is the number of blocks that were run on to find out. Where nothing is proven,
    `changing` names what differs when the program comes to a block again (`#100`, `X`), and `then`
    is how the program stops within those blocks, `None` where it does not.

    >>> import cncsub
    >>> library = cncsub.loads("O1\\nN10 #1=2\\nN20 GOTO10\\n", control="fanuc-0i-f")
    >>> run = library.run(max_blocks=1000)
    >>> print(run.endless)
    an endless loop, proven: after 2 blocks the state is the same again; O1 N10, O1 N20
    >>> [(block.n, block.line, block.text) for block in run.endless.blocks]
    [(10, 2, 'N10 #1=2'), (20, 3, 'N20 GOTO10')]
    """

    why: Why
    proven: bool
    period: int
    blocks: tuple[LoopBlock, ...]
    looked: int
    changing: tuple[str, ...]
    then: str | None
    waiting_for: str
    outside: str = ""

    def __str__(self) -> str:
        if self.why is Why.WAITING:
            return f"it waits for {self.waiting_for}{self._at()}"
        if self.why is Why.REPEATS:
            return f"it repeats by design{self._at()}{self._proof()}"
        if self.why is Why.LOOP:
            return (
                f"an endless loop, proven: after {_blocks(self.period)} the state is the"
                " same again;"
                f" {self._places()}"
            )
        return f"not proven to be endless: {self._seen()}"

    def _at(self) -> str:
        return f" at {self.blocks[0]}" if self.blocks else ""

    def _proof(self) -> str:
        if self.proven:
            return f"; after {_blocks(self.period)} the state is the same again"
        return f"; {self._seen()}" if self.looked or self.outside else ""

    def _places(self) -> str:
        left = len(self.blocks) - MOST_BLOCKS
        listed = ", ".join(map(str, self.blocks[:MOST_BLOCKS]))
        return listed + (f" and {_blocks(left)} more" if left > 0 else "")

    def _seen(self) -> str:
        if self.outside:
            return (
                f"after {_blocks(self.period)} the state is the same again, except for"
                f" {self.outside},"
                f" which it reads from outside; {self._places()}"
            )
        if self.then is not None:
            return f"after {_blocks(self.looked)} more it stops: {self.then}"
        seen = f"in {_blocks(self.looked)} more the same state did not come again"
        return f"{seen}; {', '.join(self.changing)} changed" if self.changing else seen


def _blocks(count: int) -> str:
    return f"{count:,} block{'' if count == 1 else 's'}"


def endless_of(core: _core.Machine) -> Endless | None:
    """Return why the program had not ended, `None` where it ended, runs, or was stopped by an alarm
    or by Ctrl-C.
    """
    if core.stop not in {"limit", "cycles", "waiting"}:
        return None
    facts = core.endless()
    return Endless(
        why=Why(facts["kind"]),
        proven=facts["proven"],
        period=facts["period"],
        blocks=tuple(LoopBlock(*place) for place in facts["blocks"]),
        looked=facts["looked"],
        changing=facts["changing"],
        then=facts["then"],
        waiting_for=core.waiting_for,
        outside=facts["outside"],
    )
