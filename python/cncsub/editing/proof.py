"""The proof that edited programs do the same: read again, and run before and after."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from cncsub import _core
from cncsub.analysis.first_difference import alike
from cncsub.analysis.pairs import Pair, Parting
from cncsub.editing.errors import EditError, refusal
from cncsub.editing.mentions import Mention, mentions
from cncsub.library import Library
from cncsub.run import Run, Stop
from cncsub.run_options import FlattenOptions

if TYPE_CHECKING:
    from cncsub._core import Alarm
    from cncsub.editing.edits import Edits

MOST_BLOCKS = 1_000_000  # of each run, where the caller sets no limit


@dataclass(frozen=True)
class Proof:
    """What was run before and after, with the same moves, codes, messages, variables and stop.

    `ran`: the programs that came to their end, or to the number of cycles asked for. `partly`:
    those that stopped before: the blocks after that place were compared as they are written, not as
    they run. `O1: stopped after 3 blocks: ...`.
    """

    ran: tuple[str, ...]
    partly: tuple[str, ...]


class _EditedPair(Pair):
    """A program before and after: its numbers and names differ, what it does may not."""

    _of_a_call = ("kind", "program", "repeats", "level")

    def __init__(self, edits: Edits, main: str, after: str, options: FlattenOptions) -> None:
        super().__init__((edits.library, edits.after), ("before", "after"), main, options)
        self._edits = edits
        self._mains = {id(edits.library): main, id(edits.after): after}

    def run(self, library: Library, **more: object) -> Run:
        self._main = self._mains[id(library)]
        return super().run(library, **more)

    def _called(self, run: Run, library: Library) -> dict[str, str] | None:
        return {name: self._told_apart(name, library) for name in run.calls.programs}

    def _told_apart(self, name: str, library: Library) -> str:
        """Return the name of a program before, in capitals: languages do not tell them apart."""
        old = self._edits.names.get(name, name) if library is self._edits.after else name
        return old.upper()

    def _of_variables(self, a: Run, b: Run) -> Iterator[Parting]:
        new = self._edits.variables
        if not new:
            yield from super()._of_variables(a, b)
            return
        held = {new.get(n, n): value for n, value in a.variables.items() if value is not None}
        other = {n: value for n, value in b.variables.items() if value is not None}
        for n in sorted(held.keys() | other.keys()):
            if not alike(held.get(n), other.get(n)):
                at = (len(a.steps), len(b.steps))
                name = _core.variable_name(a.recorded.control, n)
                yield self._say((a, b), at, ("", f"{name} differs at the end"))
                return

    def _of_stop(self, a: Run, b: Run) -> Iterator[Parting]:
        def stop(run: Run, library: Library) -> tuple[object, ...]:
            alarm = run.alarm
            # What a run waits for may name a variable.
            waits = run.waiting_for if not self._edits.variables else None
            told = (run.stop, waits, len(run.steps))
            if alarm is None:
                return told
            return (*told, alarm.cause, self._told_apart(alarm.program, library), alarm.line)

        if stop(a, self._edits.library) != stop(b, self._edits.after):
            yield self._say((a, b), (len(a.steps), len(b.steps)), ("", ""))

    def _place(self, alarm: Alarm) -> tuple[object, ...]:
        return (alarm.line,)


def prove(edits: Edits, main: str | int | None, options: FlattenOptions) -> Proof:
    """See `Edits.prove`."""
    if edits.empty:
        return Proof((), ())
    same_as_written(edits)
    library, after = edits.library, edits.after
    new_names = {old: new for new, old in edits.names.items()}
    if main is not None:
        chosen = [library[main].name]
    else:
        first = [] if library.main is None else [library.main.name]
        roots = library.call_graph().roots
        chosen = list(dict.fromkeys([*first, *(name for name in roots if name in library)]))
    limits: FlattenOptions = {"max_blocks": MOST_BLOCKS, **options}
    ran, partly = [], []
    for name in chosen:
        pair = _EditedPair(edits, name, new_names.get(name, name), limits)
        run, other = pair.run(library), pair.run(after)
        parting = pair.parting(run, other)
        if parting is not None:
            raise EditError(f"edited, {name} does not do the same:\n{parting.what}")
        if run.stop in (Stop.END, Stop.CYCLES):
            ran.append(name)
        else:
            count = len(run.steps)
            blocks = f"{count:,} block{'' if count == 1 else 's'}"
            partly.append(f"{name}: stopped after {blocks}: {run.summary()}")
    return Proof(tuple(ran), tuple(partly))


def same_as_written(edits: Edits) -> None:
    """Compare the programs as they are read before and after: the same blocks are refused, and each
    mention names the same block, program or variable. Raises `EditError` where they differ.
    """
    library, after = edits.library, edits.after
    names = [
        [code.program(i).blocks for i in range(len(code))] for code in (library.code, after.code)
    ]
    if names[0] != names[1]:
        raise EditError("edited, the programs have other blocks")
    refused = [_core.refused_blocks(code) for code in (library.code, after.code)]
    if refused[0] != refused[1]:
        place = min(set(refused[0]) ^ set(refused[1]))
        raise refusal(library, [(*place, "edited, the control reads this block otherwise")])
    old, new = (
        _targets(mentions(each, "block program", machine=edits.machine))
        for each in (library, after)
    )
    for key in sorted(old.keys() | new.keys()):
        if old.get(key) != new.get(key):
            program, line = key
            name = library.code.program(program).name
            raise EditError("edited, it leads elsewhere", name, None, line)


def _targets(all_of_them: list[Mention]) -> dict[tuple[int, int], list[object]]:
    """Return what the mentions of each line name, apart from the numbers and names themselves."""
    found: dict[tuple[int, int], list[object]] = {}
    for m in all_of_them:
        if not m.defines:
            row = (m.kind, m.computed, m.in_caller, m.to_program, m.to_block)
            found.setdefault((m.program, m.line), []).append(row)
    for rows in found.values():
        rows.sort(key=repr)
    return found
