"""Writes what the fuzzers start from: every row of the conformance tables, on some of its controls,
and every example, as inputs in the format of `input.hpp`, and a dictionary of their words.

    python cpp/fuzz/seeds.py build/seeds       makes build/seeds/{read,run} and build/seeds/nc.dict
"""

from __future__ import annotations

import argparse
import hashlib
import re
import struct
import sys
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from datetime import datetime
from pathlib import Path
from typing import Any

import cncsub
from cncsub.files import decode
from cncsub.workpiece import skip_signal

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "tests" / "conformance"))

from conformance import Case, cases  # noqa: E402

CONTROLS = list(cncsub.controls)
AXES = "XYZABCUVW"
MACHINES = [None, "mill", "lathe-a", "lathe-b"]
FILE, EXTERNAL_FILE, MDI, NAME_END = "\x1c", "\x1d", "\x1e", "\x1f"
OPTIONS, CHANGES = 0x20, 0x40  # of the last byte
WHOLE_LIMIT = 2**31
SEEDS_A_ROW = 2


class Writer:
    """Collects what the reader takes from the end, first thing first."""

    def __init__(self) -> None:
        self._bytes = bytearray()

    def byte(self, value: int) -> None:
        self._bytes.append(value)

    def whole(self, value: int, size: int = 4) -> None:
        self._bytes += (value % (1 << 8 * size)).to_bytes(size, "little")

    def number(self, value: float | None) -> None:
        if value is None:
            self.byte(0)
        elif value == int(value) and abs(value) < WHOLE_LIMIT:
            self.byte(4)
            self.whole(int(value))
        else:
            self.byte(7)
            self._bytes += struct.pack("<d", value)

    def values(self, values: Mapping[int, float | None], most: int) -> None:
        taken = list(values.items())[:most]
        self.byte(len(taken))
        for number, value in taken:
            self.whole(number)
            self.number(value)

    def each(self, things: Iterable[Any], most: int) -> Iterator[Any]:
        taken = list(things)[:most]
        self.byte(len(taken))
        yield from taken

    def reversed(self) -> bytes:
        return bytes(reversed(self._bytes))


def point(out: Writer, axes: Mapping[str, float]) -> None:
    for axis, value in out.each(axes.items(), 4):
        out.byte(AXES.index(axis.upper()))
        out.number(value)


def write_inputs(out: Writer, inputs: Mapping[str, Any]) -> None:
    out.values(inputs.get("signals", {}), 4)
    clock = inputs.get("clock")
    dated = isinstance(clock, datetime)
    out.number(0 if clock is None or dated else clock)
    out.number(clock.year * 10_000 + clock.month * 100 + clock.day if dated else 0)
    out.number(clock.hour * 10_000 + clock.minute * 100 + clock.second if dated else 0)
    answers = inputs.get("operator")
    out.byte(answers is not None)
    for answer in out.each(answers or (), 8):
        out.byte(answer == "start")
    writes = [w if isinstance(w, Mapping) else w[1] for w in inputs.get("writes", ())]
    for write in out.each(writes, 4):
        out.values(write, 2)
    skips = inputs.get("skips", ())
    reported = [(0, skip) for skip in skips]  # of any signal
    if isinstance(skips, Mapping):
        reported = [
            (skip_signal("skips", of), skip) for of, those in skips.items() for skip in those
        ]
    for signal, skip in out.each(reported, 4):
        out.byte(signal)
        out.byte(round(skip * 255) if isinstance(skip, int | float) and 0 <= skip <= 1 else 255)


def work_system(name: str) -> int:
    """0 for EXT, 1 to 6 for G54 to G59, then G54.1 P1, or G501..."""
    if name == "EXT":
        return 0
    if len(name) == 4:
        return min(6 + int(name[2:]), 255)
    return int(name[2:]) - 3 if len(name) == 3 else min(6 + int(name.split("P")[1]), 255)


def write_setup(out: Writer, setup: Mapping[str, Any]) -> None:
    out.byte(MACHINES.index(setup.get("machine")))
    out.byte("increment" in setup)
    if "increment" in setup:
        out.number(setup["increment"])
    point(out, setup.get("start", {}))
    for name, axes in out.each(setup.get("work_offsets", {}).items(), 4):
        out.byte(work_system(name))
        point(out, axes)
    for field in ("length_offsets", "radius_offsets"):
        for number, value in out.each(setup.get(field, {}).items(), 4):
            out.whole(int(number), 2)
            out.number(value)
    for number, tool in out.each(setup.get("tools", {}).items(), 4):
        out.whole(int(number), 2)
        point(out, {axis: value for axis, value in tool.items() if axis in AXES})
        out.byte(int(tool.get("tip", 0)))
        out.number(tool.get("R", 0))
    for number, axes in out.each(setup.get("reference", {}).items(), 4):
        out.whole(int(number), 2)
        point(out, axes)
    for axis, rate in out.each(setup.get("rapid", {}).items(), 4):
        out.byte(AXES.index(axis))
        out.number(rate)
    for ranges in ("limits", "stroke_area"):
        for axis, limits in out.each(setup.get(ranges, {}).items(), 4):
            out.byte(AXES.index(axis))
            for limit in limits:
                out.number(limit)


def write_options(out: Writer, case: Case) -> None:
    options = case.options
    start, skips = options.get("start"), options.get("block_skip", ())
    variables, inputs = options.get("variables"), options.get("inputs")
    inputs = vars(inputs) if isinstance(inputs, cncsub.Inputs) else inputs
    out.byte(
        (case.mdi is not None)
        | bool(options.get("optional_stop")) << 1
        | (start is not None) << 3
        | bool(skips) << 4
        | bool(variables) << 5
        | bool(inputs) << 6
        | bool(case.setup) << 7
    )
    out.byte(min(options.get("max_cycles", 1), 4) - 1)
    if start is not None:
        out.whole(start)
    if skips:
        out.whole(sum(1 << switch for switch in skips), 2)
    if variables:
        out.values(variables, 8)
    if inputs:
        write_inputs(out, inputs)
    if case.setup:
        write_setup(out, case.setup)


def write_parameters(out: Writer, control: str, params: Mapping[str, float]) -> None:
    known = list(cncsub.controls[control].parameters)
    for name, value in out.each(params.items(), 4):
        if name in known:
            out.whole(known.index(name), 2)
        else:
            number, _, bit = name.partition("#")
            out.whole(int(number), 2)
            out.byte(int(bit) + 1 if bit else 0)
        out.number(value)
    out.byte(0)  # no rules


def texts(case: Case) -> bytes:
    def named(files: Mapping[str, str | bytes], kind: str) -> list[str]:
        return [kind + name + NAME_END + text_of(text) for name, text in files.items()]

    def text_of(text: str | bytes) -> str:
        return decode(text, case.encoding) if isinstance(text, bytes) else text

    parts = [FILE + text_of(case.program)] if case.program is not None else []
    parts += named(case.files or {}, FILE) + named(case.external or {}, EXTERNAL_FILE)
    parts += [MDI + case.mdi] if case.mdi is not None else []
    return "".join(parts).removeprefix(FILE).encode()


def of_case(case: Case, control: str) -> bytes:
    """The input that runs this row."""
    out = Writer()
    out.byte(CONTROLS.index(control) | OPTIONS | (CHANGES if case.params else 0))
    write_options(out, case)
    if case.params:
        write_parameters(out, control, case.params)
    return texts(case) + out.reversed()


def example_texts() -> Iterator[tuple[bytes, str]]:
    """Each example with the control its folder or file names."""
    for file in sorted((ROOT / "examples").rglob("*")):
        if file.suffix.lower() not in (".nc", ".cnc"):
            continue
        maker = file.relative_to(ROOT / "examples").parts[0]
        text = decode(file.read_bytes())
        named = [control for control in CONTROLS if re.search(rf"\b{control}\b", text)]
        for control in named or [c for c in CONTROLS if c.startswith(maker)][:1]:
            yield text.encode(), control


def dictionary(programs: Iterable[bytes]) -> str:
    """The words, names and signs that stand in more than one program, as libFuzzer reads them."""
    signs = r"[A-Z]{2,}\[?|[A-Z][0-9]+(?:\.[0-9])?|#[0-9]+=?|,[A-Z]|DO[1-3]|[%#\[\]()<>/;=*]"
    words = Counter[str]()
    for program in programs:
        words.update(set(re.findall(signs, program.decode("utf-8", "replace"))))
    kept = [word for word, count in words.items() if count > 1] + list("\x1c\x1d\x1e\x1f")
    quoted = ("".join(f"\\x{byte:02X}" for byte in word.encode()) for word in sorted(kept))
    return "".join(f'"{word}"\n' for word in quoted)


def write_seeds(folder: Path, inputs: Iterable[bytes]) -> int:
    folder.mkdir(parents=True, exist_ok=True)
    unique = {hashlib.sha1(data).hexdigest()[:16]: data for data in inputs}
    for name, data in unique.items():
        (folder / name).write_bytes(data)
    return len(unique)


def some(controls: Sequence[str], row: int) -> list[str]:
    """A few of the controls of a row, others than of the next. The fuzzer changes the control of
    an input soon enough, and trying something new finds more than reading every pair."""
    first = row % len(controls)
    return [*controls[first:], *controls[:first]][:SEEDS_A_ROW]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("folder", type=Path)
    folder = parser.parse_args().folder
    rows = [(case, control) for i, case in enumerate(cases()) for control in some(case.controls, i)]
    examples = [(text, bytes([CONTROLS.index(control)])) for text, control in example_texts()]
    run = [of_case(case, control) for case, control in rows]
    read = [texts(case) + bytes([CONTROLS.index(control)]) for case, control in rows]
    plain = [text + last for text, last in examples]
    print(f"{write_seeds(folder / 'read', read + plain)} seeds for reading")
    print(f"{write_seeds(folder / 'run', run + plain)} seeds for running")
    programs = [texts(case) for case in cases()] + [text for text, _ in examples]
    (folder / "nc.dict").write_text(dictionary(programs), encoding="ascii")


if __name__ == "__main__":
    main()
