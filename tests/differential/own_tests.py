"""Run the test programs and samples of LinuxCNC's sources on cncsub and on its interpreter `rs274`.

    python tests/differential/own_tests.py ~/linuxcnc/tests/interp
    python tests/differential/own_tests.py ~/linuxcnc/nc_files

Every `.ngc` of the folder and below runs by itself, with the other programs and the tool table of
its folder; if there is no table, one with tools 1 to 99 is used. Compared are the moves of the
point of the tool or of its centre, the messages, and how the run stopped. rs274 does not print the
places of splines, so only the moves between them are compared.

Up to the place where something of a machine decides, a program is compared too, and then it is
counted under that reason (`REASONS`). Any other difference is printed, the first of each program,
and the status is 1.
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import canonical
import cncsub
from canonical import Move, Output, Rs274, with_length
from linuxcnc_paths import tool_moves

SECONDS = 20
MAX_BLOCKS = 200_000
INCH = 25.4  # rs274 alone is a machine in inches, and so is its tool table


TABLE = "".join(f"T{t} P{t} Z{t % 7 / 10} D{t % 5 / 64 + 0.01} ;\n" for t in range(1, 100))
FLAT_TABLE = re.sub(r"Z\S+", "Z0", TABLE)
SPLINE = re.compile(r"G\s*0*5(\.1)?(?![\d.])", re.IGNORECASE)

# The reasons why a program may go on otherwise from some place on.
NOT_COMPUTED = "cncsub says that it does not compute a code (G5.2, G70 to G72)"
M_CODES = "M100 to M199 are programs in a folder of the machine, which rs274 alone has not"
AXES = "U, V and W are axes of the machine, which rs274 alone has not"
PINS = "a pin or a setting of the machine is asked for (_hal, _ini)"
PROBES = "a probe touches, for rs274 alone always 0.01 inch before the end"
NAMES = "a named parameter tells of the machine (overrides, axes, coolant)"
LENGTHS = "rs274 alone stands otherwise after G43 in the block of M6; without lengths all agrees"
REASONS = (NOT_COMPUTED, M_CODES, AXES, PINS, PROBES, NAMES, LENGTHS)
UNKNOWN = "######"  # in a message, a value that cncsub does not know


def setup_of(folder: Path) -> cncsub.Setup:
    """Return a setup with the lengths and radii of the tool tables of a folder."""
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
    """Return the moves; `tool`: of the middle of the tool, in machine coordinates."""

    def place(row: Any, prefix: str, axes: str) -> dict[str, float]:
        values = {axis: getattr(row, prefix + axis.lower(), None) for axis in axes}
        return {axis: float(v) for axis, v in values.items() if v is not None and v == v}

    made = []
    splines = {
        n for n, step in enumerate(run.steps) if step.block and SPLINE.search(step.block.text)
    }
    for row in run.moves:
        if row.step in splines:
            continue
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
    """Return whether both say the same; numbers of `theirs` may be in inches, of `ours` in mm."""
    number = re.compile(r"-?\d+\.\d+")
    if number.sub("", theirs).rstrip() != number.sub("", ours).rstrip():
        return False
    values = zip(map(float, number.findall(theirs)), map(float, number.findall(ours)))
    return all(abs(a - b) <= 1e-6 or abs(a * INCH - b) <= 1e-4 * max(1, abs(b)) for a, b in values)


def same_moves(theirs: Output, run: cncsub.Run, first: int | None = None) -> bool:
    """Return whether the moves are the same, or the first ones that both have."""
    moves = with_length(theirs.moves[:first])
    small = theirs.tolerance
    for way in (moves_of(run, False), moves_of(run, True), with_length(tool_moves(run))):
        if first is None and len(way) != len(moves):
            continue
        if all(alike(a, b, small) for a, b in zip(moves, way)):
            return True
    return False


def how_both_stop(theirs: Output, run: cncsub.Run) -> tuple[str, str]:
    stopped = "" if run.stop is cncsub.Stop.END else str(run.stop)
    got = (run.alarm.text or run.alarm.cause).rstrip() if run.alarm else stopped
    return theirs.errors[0].rstrip() if theirs.errors else "", got


def differences(theirs: Output, run: cncsub.Run) -> Iterator[str]:
    wanted, got = how_both_stop(theirs, run)
    if wanted != got:
        yield f"rs274 stops by {wanted!r}, cncsub by {got!r}"
    pairs = zip(theirs.messages, run.messages)
    if len(theirs.messages) != len(run.messages) or not all(same_message(*p) for p in pairs):
        yield "the messages are others"
    if not same_moves(theirs, run):
        yield f"the moves are others: {len(with_length(theirs.moves))} and {len(moves_of(run, False))}"


def reason(theirs: Output, run: cncsub.Run) -> str | None:
    """Return what of a machine decides where they part, if they are the same before."""
    wanted, got = how_both_stop(theirs, run)
    known = [pair for pair in zip(theirs.messages, run.messages) if UNKNOWN not in pair[1]]
    if not all(same_message(*pair) for pair in known):
        return None
    if theirs.probes_at is not None:
        return PROBES if same_moves(theirs, run, theirs.probes_at) else None
    if wanted == got and len(known) < len(run.messages) == len(theirs.messages):
        return NAMES if same_moves(theirs, run) else None
    if wanted == got or not same_moves(theirs, run, len(theirs.moves)):
        return None
    if run.alarm and run.alarm.cause == "code-not-computed":
        return NOT_COMPUTED
    if re.match(r"Unknown m code used: M1\d\d$", wanted):
        return M_CODES
    if re.match(r"Bad character '[uvw]' used", wanted):
        return AXES
    return PINS if re.match(r"Named parameter #<_(hal|ini)\[", got) else None


@dataclass
class Found:
    """The differences; `None` where rs274 does not end in time."""

    differences: list[str] | None
    reason: str | None = None


def compare(command: str, file: Path) -> Found:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for other in file.parent.iterdir():
            if other.is_file():
                shutil.copy(other, folder)
        for table in sorted(folder.glob("*.tbl"))[:1]:
            shutil.copy(table, folder / "tool.tbl") if table.name != "tool.tbl" else None
        own = any(folder.glob("*.tbl"))
        found = compare_with(command, folder, file.name, None if own else TABLE)
        unexplained = bool(found.differences) and not found.reason and not own
        if unexplained and compare_with(command, folder, file.name, FLAT_TABLE).differences == []:
            found.reason = LENGTHS
        return found


def compare_with(command: str, folder: Path, name: str, table: str | None) -> Found:
    if table is not None:
        (folder / "tool.tbl").write_text(table)
    (folder / "variables").write_text("")  # rs274 keeps them from run to run
    theirs = Rs274(command, folder, SECONDS).run(name)
    if theirs is None:
        return Found(None)
    theirs.messages = [m for m in theirs.messages if not canonical.is_call(m)]
    before = Path.cwd()
    os.chdir(folder)
    try:
        run = on_cncsub(folder, name)
        found = list(differences(theirs, run))
        return Found(found, reason(theirs, run) if found else None)
    finally:
        os.chdir(before)


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n\n", 1)[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--command", default="rs274")
    arguments = parser.parse_args()
    agree = endless = 0
    reasons: dict[str, list[str]] = {text: [] for text in REASONS}
    files = sorted(arguments.folder.rglob("*.ngc"))
    for file in files:
        found = compare(arguments.command, file.resolve())
        name = str(file.relative_to(arguments.folder))
        agree += found.differences == []
        endless += found.differences is None
        if found.reason:
            reasons[found.reason].append(name)
            continue
        for difference in found.differences or ():
            print(f"{name}: {difference}")
    for text, names in reasons.items():
        if names:
            print(f"{len(names):>4} {text}: {', '.join(names)}")
    others = sum(map(len, reasons.values()))
    print(f"{agree} of {len(files)} agree, {others} up to a machine, {endless} do not end in rs274")
    return 0 if agree + others + endless == len(files) else 1


if __name__ == "__main__":
    sys.exit(main())
