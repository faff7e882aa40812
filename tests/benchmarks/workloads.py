"""The workloads that are measured: `python workloads.py SIZE FOLDER` writes the files of all.

A workload is a list of files, how much work they are, and the same work in the words of a peer that
does not know those of a control.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

import mixed
import texts

Text = Callable[[], str]
DEPTH = 12  # the depth of the nested calls
REPEATS = 9999  # the count of one M98 L
MACRO_BLOCKS = 1000  # G65 blocks in the loop
HALVES = ("a", "b")  # the two halves of the folder, each read by a thread


@dataclass(frozen=True)
class Size:
    """The sizes of the workloads, and how often each is measured."""

    rounds: int
    blocks: int  # the blocks of the flat files
    calls: int  # the M98 L9999 blocks
    subprograms: int
    macro_repeats: int  # the repeats of 1,000 G65 blocks
    holes: int
    passes: int  # the passes of the loops
    around: int  # the blocks before the jump loop, and those after it
    programs: int  # the programs of the folder
    patience: float = 20  # seconds of one program on one workload, after which it is not repeated


SIZES = {
    "tiny": Size(1, 2_000, 1, 20, 1, 200, 2_000, 100, 20),
    "small": Size(3, 100_000, 2, 2000, 100, 20_000, 300_000, 50_000, 1000, patience=5),
    "full": Size(5, 1_000_000, 10, 2000, 1000, 200_000, 3_000_000, 50_000, 10_000),
}


@dataclass(frozen=True)
class Workload:
    """Programs that every peer gets, and the result of a right execution."""

    name: str
    title: str
    files: Mapping[str, Text]
    count: int  # how many of the units the figures are given for
    unit: str
    blocks: int  # the blocks that are executed; 0: not known
    moves: int = 0  # the moves that are made; a run keeps them where there are any
    control: str = "fanuc-0i-f"
    plain: bool = False  # nothing but moves, so that a mere parser can take part
    own_words: Mapping[str, Mapping[str, Text]] = field(default_factory=dict)  # texts for a peer

    @property
    def trace(self) -> str:
        return "moves" if self.moves else "none"

    def paths(self, folder: Path, peer: str = "") -> list[Path]:
        """Return the files for a peer."""
        return [folder / name for name in self.own_words.get(peer, self.files)]


def workloads(size: Size) -> list[Workload]:
    """Return all workloads, in the order of the table."""
    return [
        *flat_workloads(size),
        *mixed_workloads(size),
        *call_workloads(size),
        *loop_workloads(size),
        folder_of(size),
    ]


def mixed_workloads(size: Size) -> list[Workload]:
    """Return programs that mix what real ones do; the blocks of their cycles are not counted."""
    count = size.blocks
    return [
        Workload(
            "mill",
            f"a milling program, {count:,} blocks: tools, drilling, contours, helices, five axes",
            {"mill.nc": partial(mixed.milling, count)},
            count=count,
            unit="block",
            blocks=0,
            moves=count,
            own_words={"rs274": {"mill.ngc": partial(mixed.milling, count, linuxcnc=True)}},
        ),
        Workload(
            "turn",
            f"a turning program, {count:,} blocks: roughing, nose radius, threads",
            {"turn.nc": partial(mixed.turning, count)},
            count=count,
            unit="block",
            blocks=0,
            moves=count,
            control="gsk-988ta",
        ),
    ]


def flat_workloads(size: Size) -> list[Workload]:
    count = size.blocks
    return [
        Workload(
            "flat",
            f"flat G1, {count:,} blocks",
            {"flat.nc": partial(texts.flat, count)},
            count=count,
            unit="block",
            blocks=count + 2,
            moves=count,
            plain=True,
        ),
        Workload(
            "arcs",
            f"flat G2 and G3, {count:,} blocks",
            {"arcs.nc": partial(texts.arcs, count)},
            count=count,
            unit="block",
            blocks=count + 3,
            moves=count + 1,
            plain=True,
        ),
    ]


def call_workloads(size: Size) -> list[Workload]:
    passes, macros = size.calls * REPEATS, MACRO_BLOCKS * size.macro_repeats
    return [
        Workload(
            "calls",
            f"M98 L{REPEATS} in {size.calls} blocks, eight G1 blocks a pass",
            {"calls.nc": partial(texts.call_loop, size.calls, REPEATS)},
            count=passes * 9,
            unit="block",
            blocks=passes * 9 + size.calls + 2,
            moves=passes * 8,
        ),
        Workload(
            "nested",
            f"{DEPTH} nested calls, {DEPTH * REPEATS:,} calls in all",
            {"nested.nc": partial(texts.nested, DEPTH, REPEATS)},
            count=DEPTH * REPEATS,
            unit="call",
            blocks=(2 * DEPTH - 1) * REPEATS + 2,
            control="gsk-988ta",  # allows twelve levels
        ),
        Workload(
            "subprograms",
            f"{size.subprograms:,} small subprograms, each called once",
            {"subprograms.nc": partial(texts.subprograms, size.subprograms)},
            count=size.subprograms,
            unit="call",
            blocks=3 * size.subprograms + 2,
            moves=size.subprograms,
        ),
        Workload(
            "macros",
            f"G65 with six arguments, {macros:,} calls",
            {"macros.nc": partial(texts.macro_calls, MACRO_BLOCKS, size.macro_repeats)},
            count=macros,
            unit="call",
            blocks=2 * macros + size.macro_repeats + 2,
            own_words=linuxcnc(
                "macros", texts.macro_calls_linuxcnc, MACRO_BLOCKS, size.macro_repeats
            ),
        ),
        Workload(
            "holes",
            f"G66 over {size.holes:,} holes",
            {"holes.nc": partial(texts.hole_pattern, size.holes)},
            count=size.holes,
            unit="hole",
            blocks=5 * size.holes + 4,
            moves=4 * size.holes + 1,
        ),
    ]


def loop_workloads(size: Size) -> list[Workload]:
    lua = {
        f"Lua {form}": {f"sine-{form}.lua": partial(texts.sine_loop_lua, size.passes, form)}
        for form in texts.LUA_FORMS
    }
    return [
        Workload(
            "sine",
            f"WHILE with two assignments and a sine, {size.passes:,} passes",
            {"sine.nc": partial(texts.sine_loop, size.passes)},
            count=size.passes,
            unit="pass",
            blocks=4 * size.passes + 4,
            own_words=lua | linuxcnc("sine", texts.sine_loop_linuxcnc, size.passes),
        ),
        jump_workload("jump", size.around, size.passes),
    ]


def jump_workload(name: str, around: int, passes: int) -> Workload:
    return Workload(
        name,
        f"IF/GOTO in a program of {2 * around + 4:,} blocks, {passes:,} passes",
        {f"{name}.nc": partial(texts.jump_loop, passes, around)},
        count=passes,
        unit="pass",
        blocks=2 * passes + 2 * around + 2,
    )


def short_jump(size: Size) -> Workload:
    """Return the workload that the jump in a long program is compared with."""
    return jump_workload("short jump", 5, size.passes)


def folder_of(size: Size) -> Workload:
    half = size.programs // 2
    files = {
        f"folder/{folder}/O{number:04}.nc": partial(texts.small_program, number)
        for folder in HALVES
        for number in range(1, half + 1)
    }
    return Workload(
        "folder",
        f"a folder of {2 * half:,} programs of 20 blocks, read and run",
        files,
        count=2 * half,
        unit="program",
        blocks=2 * half * 20,
        moves=2 * half * 18,
        plain=True,
    )


def linuxcnc(name: str, text: Callable[..., str], *arguments: int) -> dict[str, dict[str, Text]]:
    """Return the same work in the words of LinuxCNC, for its two faces."""
    files = {f"{name}.ngc": partial(text, *arguments)}
    return {"rs274": files, "gcode": files}


def other_files(size: Size) -> dict[str, Text]:
    """Return what is measured besides the workloads: a short jump loop, a library for each of two
    threads.
    """
    threads = {
        f"threads/{folder}.nc": partial(texts.flat, size.blocks // 2, seed)
        for seed, folder in enumerate(HALVES)
    }
    return {**threads, **short_jump(size).files}


def write_files(size: Size, folder: Path) -> None:
    wanted = other_files(size)
    for workload in workloads(size):
        for files in (workload.files, *workload.own_words.values()):
            wanted.update(files)
    for name, text in wanted.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text(), encoding="ascii")


if __name__ == "__main__":
    write_files(SIZES[sys.argv[1]], Path(sys.argv[2]))
