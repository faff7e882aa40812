"""The open calls of a machine, with their passes, arguments and levels."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from cncsub.machine import Machine
from cncsub.number_text import number_text
from cncsub.program import Block, block_at
from cncsub.tables.rows import Call


@dataclass(frozen=True, slots=True)
class StackFrame:
    """A program that runs: the innermost one has the index 0.

    `block` is the block that runs next, or that called the program of the frame inside; `None`
    where there is none. `kind` is the code that called it, empty for the main program; `repeat` of
    `repeats` is its pass. `arguments` are the locals it was given, by number or name. `call` is its
    row in the table of calls, -1 for the main program, `level` that of its locals.
    """

    index: int
    program: str
    block: Block | None
    kind: str = ""
    repeat: int = 1
    repeats: int = 1
    arguments: tuple[tuple[int | str, float | None], ...] = ()
    call: int = -1
    level: int = 0

    @property
    def title(self) -> str:
        """The program with its pass and its arguments, on one line."""
        passes = f" pass {self.repeat} of {self.repeats}" if self.repeats > 1 else ""
        given = ", ".join(
            f"{f'#{name}' if isinstance(name, int) else name}={number_text(value)}"
            for name, value in self.arguments
        )
        return f"{self.program}{passes}{f' ({given})' if given else ''}"


def frames_of(machine: Machine) -> list[StackFrame]:
    """Return the programs that run, the innermost first."""
    core, open_, calls = machine.core, machine.stack, open_calls(machine)[::-1]
    frames = []
    block = here(machine)
    for place, (entered, call) in enumerate(zip(open_, calls, strict=False)):
        given = tuple(call.arguments.items())
        passes = entered.repeat, entered.repeats
        frames.append(
            StackFrame(
                place, entered.called, block, entered.kind, *passes, given, call.call, call.level
            )
        )
        if call.kind == "MDI":  # it was typed before a block, and no block called it
            block = block_at(core.code, core.open_frames[len(open_) - place]["return_to"])
        else:
            block = machine.steps[call.caller_step].block
    name = open_[-1].program if open_ else "" if block is None else block.program.name
    return [*frames, StackFrame(len(frames), name, block)]


def frame_at(frames: Sequence[StackFrame], index: int) -> StackFrame:
    """Return the frame of an index. Raises `ValueError` where there is none."""
    if not 0 <= index < len(frames):
        raise ValueError(f"there is no frame {index}; there are 0 to {len(frames) - 1}")
    return frames[index]


def level_opener(frame: StackFrame, frames: Sequence[StackFrame]) -> int:
    """Return the call that opened the level of a program's locals, -1 for the main program's."""
    same = [each.call for each in frames if each.level == frame.level and each.call >= 0]
    return min(same, default=-1) if frame.level else -1


def here(machine: Machine) -> Block | None:
    """Return the block that runs next; at the end of the program that which ran last."""
    if (following := machine.next) is not None:
        return following
    return machine.steps[-1].block if machine.blocks and len(machine.steps) else None


def open_calls(machine: Machine) -> list[Call]:
    """Return the calls that are open, the outermost first; those of a machine that recorded its
    calls.
    """
    depth, blocks = len(machine.stack), machine.blocks
    table = machine.calls
    if not depth or not len(table):
        return []
    newest: Call | None = table[-1]
    if newest is not None and newest.first_step < blocks:  # it has begun: the last step tells more
        last = machine.steps[-1]
        newest = table[last.frame] if last.frame >= 0 else None
        for _ in range(last.depth - depth):
            newest = None if newest is None or newest.parent is None else table[newest.parent]
    chain: list[Call] = []
    while newest is not None:
        chain.append(newest)
        newest = None if newest.parent is None else table[newest.parent]
    return chain[::-1][:depth]  # a typed text that was given up is no more open
