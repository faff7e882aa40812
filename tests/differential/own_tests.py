"""Runs the test programs and samples of LinuxCNC's sources on cncsub and on its interpreter `rs274`.

    python tests/differential/own_tests.py ~/linuxcnc/tests/interp
    python tests/differential/own_tests.py ~/linuxcnc/nc_files

Every `.ngc` of the folder and below runs by itself, with the other programs and the tool table of its
folder; where there is none, tools 1 to 99 are in it. Compared are the moves of the tool's point or of its centre, the messages, and how the run
stopped. What disagrees is printed with the first difference.
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import canonical
import cncsub
from canonical import Move, Output, Rs274, with_length
from linuxcnc_paths import tool_moves

SECONDS = 20
MAX_BLOCKS = 200_000
INCH = 25.4  # rs274 by itself is a machine in inches: so is its tool table


TABLE = "".join(f"T{t} P{t} Z{t % 7 / 10} D{t % 5 / 64 + 0.01} ;\n" for t in range(1, 100))


def setup_of(folder: Path) -> cncsub.Setup:
    """Lengths and radii of the tool tables of a folder."""
    lengths: dict[int, float] = {}
    radii: dict[int, float] = {}
    for table in sorted(folder.glob("*.tbl")):
        for line in table.read_text(errors="replace").splitlines():
            words = {
                a: float(v) for a, v in re.findall(r"([TZD])\s*([-+.\d]+)", line.split(";")[0])
            }
            if 0 < words.get("T", 0) < 9999:
                lengths[int(words["T"])] = words.get("Z", 0.0) * INCH
                radii[int(words["T"])] = words.get("D", 0.0) / 2 * INCH
    return cncsub.Setup(increment=1e-7, length_offsets=lengths, radius_offsets=radii)


def on_cncsub(folder: Path, name: str) -> cncsub.Run:
    others = [p.name for p in sorted(folder.glob("*.ngc")) if p.name != name]
    library = cncsub.load(name, *others, control="linuxcnc")
    return library.run(max_blocks=MAX_BLOCKS, setup=setup_of(folder))


def moves_of(run: cncsub.Run, tool: bool) -> list[Move]:
    """The moves; `tool`: of the middle of the tool, in machine coordinates."""

    def place(row: Any, prefix: str, axes: str) -> dict[str, float]:
        values = {axis: getattr(row, prefix + axis.lower(), None) for axis in axes}
        return {axis: float(v) for axis, v in values.items() if v is not None and v == v}

    made = []
    for row in run.moves:
        if row.kind == "dwell":
            made.append(Move("dwell", seconds=float(row.time)))
            continue
        end = place(row, "", "XYZABC") | (place(row, "m", "XYZ") if tool else {})
        arc = row.kind in ("cw", "ccw")
        kind = "feed" if row.kind == "thread" else str(row.kind)
        made.append(Move(kind, end, place(row, "c", "XYZ") if arc else {}))
    return with_length(
        [
            m if m.seconds else Move(m.kind, dict.fromkeys("XYZABC", 0.0) | dict(m.end), m.centre)
            for m in made
        ]
    )


def alike(one: Move, other: Move, tolerance: float) -> bool:
    def near(a: float, b: float) -> bool:
        return abs(a - b) <= tolerance

    return (
        one.kind == other.kind
        and near(one.seconds, other.seconds)
        and all(near(value, other.end.get(axis, 0.0)) for axis, value in one.end.items())
        and all(near(value, other.centre.get(axis, value)) for axis, value in one.centre.items())
    )


def same_message(theirs: str, ours: str) -> bool:
    """Whether they say the same; a number of theirs may be inches of the machine, and ours mm."""
    number = re.compile(r"-?\d+\.\d+")
    if number.sub("", theirs).rstrip() != number.sub("", ours).rstrip():
        return False
    values = zip(map(float, number.findall(theirs)), map(float, number.findall(ours)))
    return all(abs(a - b) <= 1e-6 or abs(a * INCH - b) <= 1e-4 * max(1, abs(b)) for a, b in values)


def differences(theirs: Output, run: cncsub.Run) -> Iterator[str]:
    wanted = theirs.errors[0].rstrip() if theirs.errors else ""
    stopped = "" if run.stop is cncsub.Stop.END else str(run.stop)
    got = (run.alarm.text or run.alarm.cause).rstrip() if run.alarm else stopped
    if wanted != got:
        yield f"rs274 stops by {wanted!r}, cncsub by {got!r}"
    pairs = zip(theirs.messages, run.messages)
    if len(theirs.messages) != len(run.messages) or not all(same_message(*p) for p in pairs):
        yield "the messages are others"
    moves = with_length(theirs.moves)
    ways = [moves_of(run, tool) for tool in (False, True)] + [with_length(tool_moves(run))]
    small = theirs.tolerance
    if not any(
        len(way) == len(moves) and all(alike(a, b, small) for a, b in zip(moves, way, strict=True))
        for way in ways
    ):
        yield f"the moves are others: {len(moves)} and {len(ways[0])}"


def compare(command: str, file: Path) -> list[str] | None:
    """What differs; `None` where rs274 does not end in time."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for other in file.parent.iterdir():
            if other.is_file():
                shutil.copy(other, folder)
        for table in sorted(folder.glob("*.tbl"))[:1]:
            shutil.copy(table, folder / "tool.tbl") if table.name != "tool.tbl" else None
        if not any(folder.glob("*.tbl")):
            (folder / "tool.tbl").write_text(TABLE)
        theirs = Rs274(command, folder, SECONDS).run(file.name)
        if theirs is None:
            return None
        theirs.messages = [m for m in theirs.messages if not canonical.is_call(m)]
        before = Path.cwd()
        os.chdir(folder)
        try:
            return list(differences(theirs, on_cncsub(folder, file.name)))
        finally:
            os.chdir(before)


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n\n", 1)[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--command", default="rs274")
    arguments = parser.parse_args()
    agree = endless = 0
    files = sorted(arguments.folder.rglob("*.ngc"))
    for file in files:
        found = compare(arguments.command, file.resolve())
        agree += found == []
        endless += found is None
        for difference in found or ():
            print(f"{file.relative_to(arguments.folder)}: {difference}")
    print(f"{agree} of {len(files)} agree, {endless} do not end in rs274")
    return 0 if agree + endless == len(files) else 1


if __name__ == "__main__":
    sys.exit(main())
