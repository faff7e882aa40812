"""The canonical calls of a program that LinuxCNC's interpreter `rs274 -g` prints, read as moves.

    7 N10    STRAIGHT_TRAVERSE(1.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)

Lengths are in mm, whatever the unit of the program.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

TOLERANCE = 0.0002  # mm; rs274 prints four decimals
INCH_TOLERANCE = 0.0015  # mm; rs274 prints four decimals of inches

_CALL = re.compile(r"\s*\d+ N(\S*)\s+([A-Z_0-9]+)\((.*)\)$")
_NUMBER = re.compile(r"/?\s*N\s*(\d+)", re.IGNORECASE)
_PLANES = {"XY": "XYZ", "XZ": "ZXY", "YZ": "YZX"}


@dataclass(frozen=True)
class Move:
    """A move; a dwell does not move and has seconds."""

    kind: str
    end: Mapping[str, float] = field(default_factory=dict)
    centre: Mapping[str, float] = field(default_factory=dict)
    seconds: float = 0.0

    def __str__(self) -> str:
        if self.kind == "dwell":
            return f"dwell {self.seconds:g} s"
        end, centre = (
            " ".join(f"{axis}{value:g}" for axis, value in place.items() if value or axis in "XYZ")
            for place in (self.end, self.centre)
        )
        return f"{self.kind} {end}" + (f" about {centre}" if centre else "")


@dataclass(frozen=True)
class Lost:
    """The place from which rs274 does not know what a machine would have answered.

    The fields say how many moves and messages come before it, and why.
    """

    moves: int
    messages: int
    why: str


@dataclass
class Output:
    """The result of a run of rs274; `blocks` are the sequence numbers of its calls, in order."""

    moves: list[Move] = field(default_factory=list)
    messages: list[str] = field(default_factory=list)
    blocks: list[int] = field(default_factory=list)
    errors: list[str] = field(default_factory=list)  # the message, and then its block
    tolerance: float = TOLERANCE  # of the printed numbers, in mm
    probes_at: int | None = None  # how many moves come before the first probe
    lost: Lost | None = None

    @property
    def travel(self) -> list[Move]:
        """The moves without dwells."""
        return [move for move in self.moves if move.kind != "dwell"]

    @property
    def refused(self) -> int | None:
        """The sequence number of the block that is printed after a message."""
        shown = _NUMBER.match(self.errors[1]) if self.errors[1:] else None
        return int(shown[1]) if shown else None


def read_output(stdout: str, stderr: str = "") -> Output:
    """Read the two outputs of rs274."""
    made = Output(errors=[line for line in stderr.splitlines() if line != "executing"])
    unit, axes, has_length = 1.0, "XYZ", False
    for line in stdout.splitlines():
        call = _CALL.match(line)
        if call is None:
            made.messages.append(line)  # from PRINT
            continue
        n, name, inner = call.groups()
        if n.isdigit():
            made.blocks.append(int(n))
        if made.lost is None and (why := _asks_machine(name, inner, unit, has_length)):
            made.lost = Lost(len(made.moves), len(made.messages), why)
        if name == "USE_LENGTH_UNITS":
            unit = 25.4 if "INCHES" in inner else 1.0
            made.tolerance = max(made.tolerance, INCH_TOLERANCE if unit > 1 else 0)
        elif name == "USE_TOOL_LENGTH_OFFSET":
            has_length = any(map(float, re.findall(r"[-\d.]+", inner)))
        elif name == "SELECT_PLANE":
            axes = _PLANES.get(inner[-2:], axes)  # the planes of U, V, W are unknown here
        elif name == "MESSAGE":
            made.messages.append(inner[1:-1])
        elif name == "DWELL":
            made.moves.append(Move("dwell", seconds=float(inner)))
        elif name in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "STRAIGHT_PROBE"):
            kind = "rapid" if name == "STRAIGHT_TRAVERSE" else "feed"
            if name == "STRAIGHT_PROBE" and made.probes_at is None:
                made.probes_at = len(made.moves)
            made.moves.append(Move(kind, _straight(_numbers(inner), unit)))
        elif name == "RIGID_TAP":  # there, and back along the same path
            before = made.moves[-1].end if made.moves else dict.fromkeys("XYZABC", 0.0)
            there = {**before, **_straight(_numbers(inner), unit)}
            made.moves += [Move("feed", there), Move("feed", before)]
        elif name == "ARC_FEED":
            made.moves.append(_arc(_numbers(inner), axes, unit))
    return made


def _asks_machine(name: str, inner: str, unit: float, has_length: bool) -> str:
    """Return what rs274 asks of its machine in this call if no machine would answer so; or nothing.

    [saicanon.cc: GET_EXTERNAL_TOOL_LENGTH_ZOFFSET gives the length in the unit it was given in;
    GET_EXTERNAL_POSITION_Z, which is asked after a tool change, gives the place without a length
    and before a move that waits; CHANGE_TOOL(0) and CHANGE_TOOL_NUMBER leave the tool where it is]
    """
    if has_length and name == "USE_LENGTH_UNITS" and (unit > 1) != ("INCHES" in inner):
        return "a change of units under a tool length"
    if has_length and name == "CHANGE_TOOL":
        return "a tool change under a tool length"
    if name == "CHANGE_TOOL_NUMBER":
        return "M61"
    return "M6 of no tool" if name == "CHANGE_TOOL" and inner == "0" else ""


def is_call(line: str) -> bool:
    """Return whether a line that was read as a message is a call with dots in its name."""
    return re.match(r"\s*\d+ N\S*\s+SPINDLE\.", line) is not None


def _numbers(inner: str) -> list[float]:
    return [float(value) for value in inner.split(",")]


def _straight(values: Sequence[float], unit: float) -> dict[str, float]:
    return {axis: value * unit for axis, value in zip("XYZ", values)} | dict(zip("ABC", values[3:]))


def _arc(values: Sequence[float], axes: str, unit: float) -> Move:
    """Return the arc of ARC_FEED: the end and the centre in the plane, the turns, the end across
    it.
    """
    first, second, one, other, turns, across = values[:6]
    end = dict(zip(axes, (first * unit, second * unit, across * unit))) | dict(
        zip("ABC", values[6:])
    )
    return Move("ccw" if turns > 0 else "cw", end, dict(zip(axes, (one * unit, other * unit))))


def with_length(moves: Sequence[Move], blur: float = TOLERANCE / 2) -> list[Move]:
    """Return the moves without straight moves of no length and dwells of no time.

    rs274 makes a move for a bare G0. `blur` is the distance, in mm, below which two printed ends
    are the same.
    """
    kept: list[Move] = []
    at = dict.fromkeys("XYZABC", 0.0)
    for move in moves:
        stays = all(abs(at[axis] - value) <= blur for axis, value in move.end.items())
        if move.kind in ("cw", "ccw") or move.seconds or not stays:
            kept.append(move)
            at |= move.end
    return kept


class Rs274:
    """Runs programs in files of a folder."""

    def __init__(self, command: str, folder: Path, seconds: float) -> None:
        self.command = command
        self.folder = folder
        self.seconds = seconds
        # The tool table lies in the home folder: two that share it kill each other (SIGBUS).
        self.environment = {**os.environ, "HOME": str(folder)}
        (folder / "tool.tbl").touch()
        (folder / "variables").touch()

    def run(self, main: str = "main.ngc", *options: str) -> Output | None:
        """Return the output of rs274 for a file of the folder, None if it does not end in time."""
        command = [self.command, *options, "-t", "tool.tbl", "-v", "variables", "-g", main]
        try:
            done = subprocess.run(
                command,
                cwd=self.folder,
                env=self.environment,
                capture_output=True,
                text=True,
                errors="replace",
                check=False,
                timeout=self.seconds,
            )
        except subprocess.TimeoutExpired:
            return None
        return read_output(done.stdout, done.stderr)


def command(
    what: str, text: Callable[..., str], compare: Callable[..., Any], kinds: Sequence[str] = ()
) -> int:
    """Run the command of a comparison with rs274: it compares programs, or shows one.

    `text(seed, numbers)` writes a text, `compare(seed, numbers, rs274, folder, together)` reports.
    Both take some of `kinds` as the last argument if there are any.
    """
    parser = argparse.ArgumentParser(description=what.split("\n\n", 1)[0])
    parser.add_argument("--programs", type=int, default=1000)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--together", type=int, default=1)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--show", type=int)
    parser.add_argument("--command", default="rs274")
    if kinds:
        parser.add_argument("--kinds", help=f"some of {','.join(kinds)}", default="")
    asked = parser.parse_args()
    chosen = [tuple(filter(None, asked.kinds.split(",")))] if kinds else []
    if unknown := [kind for some in chosen for kind in some if kind not in kinds]:
        parser.error(f"no kind {', '.join(unknown)}")
    if asked.show is not None:
        print(text(asked.seed, range(asked.show, asked.show + asked.together), *chosen))
        return 0
    begun = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        places = range(asked.first, asked.first + asked.programs)
        report = compare(asked.seed, places, asked.command, Path(folder), asked.together, *chosen)
    print(f"{report}\n{time.monotonic() - begun:.0f} s")
    return 1 if report.different else 0
