"""Holds LinuxCNC's interpreter `rs274` to a conformance suite: the rows of control linuxcnc.

    python tools/export_conformance.py conformance.json
    python tools/rs274_conformance.py conformance.json [--rs274 PATH]

It needs the JSON and `rs274` (Debian: linuxcnc-uspace), not cncsub: an adapter for another engine
looks like this. What `rs274 -g` prints are canonical calls; so moves, messages, errors and (from
its variable file) variables are compared, and the executed blocks as far as they make such calls.
Exit status: 0 where all rows that can be compared agree, 1 where some part, 2 for wrong use.
"""

from __future__ import annotations

import argparse
import base64
import itertools
import json
import re
import shutil
import sys
import tempfile
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "differential"))

from canonical import Move, Output, Rs274, with_length

CONTROL = "linuxcnc"
SECONDS = 10.0  # of a program
TOLERANCE = 0.001  # mm, degrees and seconds, beside what four decimals lose

# What a row can ask for that rs274 -g has no way to be given, or does not print.
_NOT_GIVEN = {
    "external": "rs274 has no external device",
    "mdi": "rs274 -g has no MDI",
    "parameters": "parameters of a control are not those of rs274",
    "rules": "the rules of rs274 cannot be changed",
    "setup": "rs274 takes no setup",
    "run.inputs": "rs274 -g has no inputs",
    "run.optional_stop": "rs274 -g has no optional stop",
    "run.start": "rs274 -g begins at the first block",
    "run.max_cycles": "rs274 -g knows no cycles",
    "run.max_blocks": "rs274 -g counts no blocks",
}
_NOT_PRINTED = ("calls", "tree", "frames", "arguments", "time", "dropped", "final_machine")
_NOT_PRINTED += ("variables_after_reset", "work_after_reset", "modal_after_reset", "centre")


@dataclass
class Report:
    agree: int = 0
    in_part: Counter[str] = field(default_factory=Counter)  # expectations that are not printed
    parted: list[tuple[str, str, list[str]]] = field(default_factory=list)
    left_out: Counter[str] = field(default_factory=Counter)
    worded: Counter[tuple[str, str]] = field(default_factory=Counter)  # the list's text, rs274's

    def lines(self) -> Iterator[str]:
        for topic, claim, found in self.parted:
            yield f"{topic}: {claim}"
            yield from (f"    {line}" for line in found)
        rows = self.agree + len(self.parted) + sum(self.left_out.values())
        yield (
            f"{rows} rows of {CONTROL}: {self.agree} agree, {len(self.parted)} part,"
            f" {sum(self.left_out.values())} left out"
        )
        yield from (f"left out: {n}: {why}" for why, n in self.left_out.most_common())
        for what, n in self.in_part.most_common():
            yield f"not compared in rows that agree or part: {what}, {n} times"
        # Which alarm it is rs274 tells by its text alone, and versions of it word one otherwise.
        for (listed, told), n in self.worded.items():
            yield f"worded otherwise, {n} times: {told!r}, listed {listed!r}"


def hold(suite: Mapping[str, Any], command: str, folder: Path) -> Report:
    """Runs the rows of the suite, one after the other."""
    report = Report()
    texts = suite["controls"].get(CONTROL, {}).get("texts", {})
    for place, case in enumerate(suite["cases"]):
        if CONTROL not in case["controls"]:
            continue
        why = left_out(case)
        if why:
            report.left_out[why] += 1
            continue
        own = folder / str(place)
        own.mkdir()
        made = run(case, command, own)
        found = differences(case, made, own)
        text = texts.get(case["expect"].get("alarm"))
        if made is not None and made.errors and text and not _fits(text, made.errors[0]):
            report.worded[text, made.errors[0]] += 1
        report.in_part.update(name for name in _NOT_PRINTED if name in case["expect"])
        if found:
            report.parted.append((case["topic"], case["claim"], found))
        else:
            report.agree += 1
    return report


def left_out(case: Mapping[str, Any]) -> str | None:
    """Why rs274 cannot run a row, or shows nothing of what it says."""
    asked = {name for name in case if name not in ("run", "expect")}
    asked |= {f"run.{name}" for name in case.get("run", {})}
    for name, why in _NOT_GIVEN.items():
        if name in asked:
            return why
    expect = case["expect"]
    if expect["stop"] not in ("end", "alarm"):
        return f"rs274 -g does not stop with {expect['stop']!r}"
    if expect["stop"] == "end" and not set(expect) - {"stop", *_NOT_PRINTED}:
        return "rs274 -g prints nothing of what the row says"
    return None


def run(case: Mapping[str, Any], command: str, folder: Path) -> Output | None:
    """What rs274 makes of a row, `None` where it does not end in time."""
    interpreter = Rs274(command, folder, SECONDS)
    options = ["-b"] if case.get("run", {}).get("block_skip") else []
    return interpreter.run(_write(case, folder), *options)


def differences(case: Mapping[str, Any], made: Output | None, folder: Path) -> list[str]:
    """What rs274 did otherwise than a row says; its variables lie in the folder."""
    expect = case["expect"]
    if made is None:
        return [f"does not end in {SECONDS:g} s"]
    found = list(_stop(expect, made))
    found += _moves(expect, made)
    found += _blocks(expect.get("runs"), made)
    if "messages" in expect and expect["messages"] != made.messages:
        found.append(f"messages: expected {expect['messages']}, got {made.messages}")
    if "variables" in expect:
        found += _variables(expect["variables"], folder / "variables")
    return found


def _write(case: Mapping[str, Any], folder: Path) -> str:
    """The files of a row, and the variables that it sets or asks for; the name of the main one."""
    files = case.get("files") or {"main.ngc": case["program"]}
    for name, text in files.items():
        data = base64.b64decode(text["base64"]) if isinstance(text, dict) else text.encode()
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data)
    # rs274 saves the variables that its file names, also behind an error.
    asked = dict.fromkeys(case["expect"].get("variables", {}), 0.0)
    given = asked | (case.get("run", {}).get("variables") or {})
    lines = [f"{number}\t{given[number] or 0}\n" for number in sorted(given, key=int)]
    (folder / "variables").write_text("".join(lines))
    stem = case.get("run", {}).get("main")
    named = (name for name in files if stem in (name, Path(name).stem))
    return next(named, next(iter(files)))


def _stop(expect: Mapping[str, Any], made: Output) -> Iterator[str]:
    if expect["stop"] == "end":
        if made.errors:
            yield f"stop: expected the end, got {made.errors[0]!r}"
        return
    if not made.errors:
        yield f"stop: expected the alarm {expect['alarm']}, got the end"
        return
    n = re.search(r" N(\d+)$", expect.get("at", ""))
    # What it looked for to the end of the file it tells with the last line of the file.
    searched = "EOF" in made.errors[0]
    if n and made.refused is not None and int(n[1]) != made.refused and not searched:
        yield f"alarm at: expected N{n[1]}, got {made.errors[1]!r}"


def _fits(text: str, told: str) -> bool:
    """Whether a text is the one of a list, whose braces stand for what differs."""
    pattern = "".join(
        ".*" if part.startswith("{") else re.escape(part) for part in re.split(r"(\{\w+\})", text)
    )
    # Values may follow it.
    return re.fullmatch(f"{pattern}(:.*)?", told.rstrip()) is not None


def _near(expected: float, got: float | None) -> bool:
    return got is not None and abs(expected - got) <= TOLERANCE


def _agrees(expected: Move, got: Move) -> bool:
    """Whether two moves are alike; the places of `expected` are whole."""
    return (
        expected.kind == got.kind
        and _near(expected.seconds, got.seconds)
        and all(_near(value, got.end.get(axis)) for axis, value in expected.end.items())
        and all(_near(value, got.centre.get(axis)) for axis, value in expected.centre.items())
    )


def _alike(expected: Sequence[Move], got: Sequence[Move]) -> bool:
    return len(expected) == len(got) and all(map(_agrees, expected, got))


def _moves(expect: Mapping[str, Any], made: Output) -> Iterator[str]:
    """Moves of no length do not count: what makes one is not the same from engine to engine."""
    if "moves" in expect:
        wanted = with_length(list(_whole(expect["moves"])))
        got = with_length(made.moves)
        if not _alike(wanted, got):
            shown = zip(("expected", "got"), (wanted, got))
            yield "moves: " + ", ".join(f"{who} {' | '.join(map(str, of))}" for who, of in shown)
    ways = (made.moves, with_length(made.moves))
    travel = [[move for move in way if move.kind != "dwell"] for way in ways]
    if "moves_x" in expect:
        xs = [[move.end.get("X") for move in way] for way in travel]
        wanted: Sequence[float] = expect["moves_x"]
        if not any(len(wanted) == len(got) and all(map(_near, wanted, got)) for got in xs):
            yield f"moves_x: expected {list(wanted)}, got {xs[0]}"
    if "final_work" in expect:
        last = travel[0][-1].end if travel[0] else dict.fromkeys("XYZABC", 0.0)
        if not all(_near(value, last.get(axis)) for axis, value in expect["final_work"].items()):
            yield f"final work: expected {expect['final_work']}, got {dict(last)}"


def _whole(moves: Iterable[Mapping[str, Any]]) -> Iterator[Move]:
    """Each move with its whole end: an axis that is not named stays, from 0 on."""
    place = dict.fromkeys("XYZ", 0.0)
    for move in moves:
        if move["kind"] == "dwell":
            yield Move(**move)
            continue
        place = {**place, **move["end"]}
        # rs274 prints a thread as a feed, between two lines about the spindle.
        kind = "feed" if move["kind"] == "thread" else move["kind"]
        yield Move(kind, place, move.get("centre", {}))


def _blocks(runs: Sequence[str] | None, made: Output) -> Iterator[str]:
    """The blocks that make calls have to come in the order in which they were to run.

    A block makes several calls, and one that is refused may have made some before.
    """
    if runs is None:
        return
    left = iter([*(int(block.rpartition("N")[2]) for block in runs), made.refused])
    for n, _ in itertools.groupby(made.blocks):
        if n not in left:  # goes on behind the last one that was found
            yield f"runs: N{n} makes a call out of the order {' '.join(runs) or 'of no block'}"
            return


def _variables(expected: Mapping[str, float | None], file: Path) -> Iterator[str]:
    rows = (line.split() for line in file.read_text().splitlines())
    saved = {row[0]: float(row[1]) for row in rows if len(row) == 2}
    for number, value in expected.items():
        # rs274 has no vacant variables: they are 0.
        if not _near(value or 0.0, saved.get(number)):
            yield f"#{number}: expected {value}, got {saved.get(number)}"


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("suite", type=Path, metavar="JSON", help="the conformance suite")
    parser.add_argument("--rs274", default="rs274", metavar="PATH", help="the interpreter")
    options = parser.parse_args(arguments)
    command = shutil.which(options.rs274)
    if command is None:
        parser.error(f"there is no {options.rs274}: install linuxcnc-uspace, or give --rs274 PATH")
    suite = json.loads(options.suite.read_text(encoding="utf-8"))
    if suite.get("format") != "cncsub-conformance" or suite.get("version") != 1:
        parser.error(f"{options.suite} is not a conformance suite of version 1")
    with tempfile.TemporaryDirectory(prefix="rs274-") as folder:
        report = hold(suite, str(Path(command).absolute()), Path(folder))
    print("\n".join(report.lines()))
    return 1 if report.parted else 0


if __name__ == "__main__":
    raise SystemExit(main())
