"""Writes the rows of the conformance tables and the shipped examples, with what came out of each
run here, as one file for the engine's self-test.

    python tools/selftest_rows.py selftest.rows
    build/selftest/cpp/selftest/selftest selftest.rows

The self-test is C++ alone (`cmake -DCNCSUB_SELFTEST=ON -DCNCSUB_PYTHON=OFF`): what Python saw on
this machine it sees on another system, or says where the two part. `cpp/selftest/rows.hpp` tells
the format. A row that cannot be written so is counted by its reason.
"""

from __future__ import annotations

import argparse
import itertools
import math
import sys
from collections import Counter
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "conformance"))

import cncsub
from cncsub import _core
from cncsub.testing import outcome
from conformance import rows

ROOT = Path(__file__).parents[1]
FORMAT = 1  # as in cpp/selftest/rows.hpp
MOST = 300  # steps and moves of a run that are written out; all are counted
ESCAPES = str.maketrans({"\\": r"\\", "\t": r"\t", "\n": r"\n", "\r": r"\r"})


def line(key: str, *values: object) -> str:
    return "\t".join([key, *(written(value) for value in values)])


def written(value: object) -> str:
    if value is None:
        return "vacant"
    if isinstance(value, bool):
        return str(int(value))
    if isinstance(value, float):
        return "vacant" if math.isnan(value) else repr(value)
    return str(value).translate(ESCAPES)


class LeftOutError(Exception):
    """Why a run is no row."""


# ---- what is run ----


def control_lines(control: cncsub.Control) -> Iterator[str]:
    _, (state,) = control.__reduce__()  # its name, and what was changed
    name, parameters, changes = state
    yield line("control", name)
    for parameter, value in parameters.items():
        yield line("parameter", parameter, float(value))
    for rule, (value, source, _entries) in changes.items():
        kind = "yes" if isinstance(value, bool) else "number" if isinstance(value, int) else "text"
        yield line("rule", rule, kind, value, source)


def text_of(pieces: list[Any]) -> str:
    whole = b"".join(
        piece.part(0, len(piece))
        if isinstance(piece, _core.Text)
        else piece.encode()
        if isinstance(piece, str)
        else bytes(piece)
        for piece in pieces
    )
    return whole.decode()


def one_by_one(files: list[Any]) -> Iterator[tuple[str, str, str, bool]]:
    """The files that the engine is handed, of which several may stand together."""
    for row in files:
        if len(row) == 2:
            texts, outside = row
            for place in range(len(texts)):
                name, stem, text = texts.file(place)
                yield name, stem, text.decode(), outside
        else:
            name, stem, pieces, outside = row
            yield name, stem, text_of(list(pieces)), outside


def file_lines(files: list[Any], device: bool) -> Iterator[str]:
    for name, stem, pieces, external in files:
        yield line("file", name, stem, external, text_of(pieces))
    if device:
        yield line("device")


def setup_lines(setup: Mapping[str, Any] | None) -> Iterator[str]:
    for key, value in (setup or {}).items():
        if key in ("machine", "increment"):
            yield line(key, value)
        elif key in ("start", "rapid", "length_offsets", "radius_offsets"):
            for name, number in value.items():
                yield line(key, name, float(number))
        elif key in ("limits", "stroke_area"):
            for name, (low, high) in value.items():
                yield line(key, name, float(low), float(high))
        elif key in ("work_offsets", "reference", "tools"):
            for name, axes in value.items():
                for axis, number in axes.items():
                    if isinstance(number, str):
                        raise LeftOutError(f"a text in a setup's {key}")
                    yield line(key, name, axis, float(number))
        else:
            raise LeftOutError(f"a setup with {key}")


def inputs_lines(inputs: Mapping[str, Any] | None) -> Iterator[str]:
    for key, value in (inputs or {}).items():
        if key in ("clock_ms", "date", "time"):
            yield line(key, float(value))
        elif key == "signals":
            for number, now in value.items():
                yield line("signal", number, float(now))
        elif key == "operator":
            if value is not None:
                yield line("operator", *value)
        elif key == "writes":
            for number, values in enumerate(value):
                for variable, now in values.items():
                    yield line("write", number, variable, now)
                if not values:
                    yield line("write", number)
        elif key == "answers":
            for code, values in value.items():
                for variable, now in values.items():
                    yield line("answer", code[0], int(code[1:]), variable, now)
        elif key == "skips":
            for signal, skips in value.items():
                for skip in skips:
                    yield line("skip", signal, *skip)
        else:
            raise LeftOutError(f"inputs with {key}")


def option_lines(main: int, options: Mapping[str, Any]) -> Iterator[str]:
    yield line("main", main)
    for key, value in options.items():
        if key in ("inputs", "setup", "conditions") or value is None:
            continue
        if key in ("optional_stop", "start", "max_cycles", "max_blocks", "trace"):
            yield line(key, value)
        elif key == "mode":
            yield line("mdi", value == "mdi")
        elif key == "variables":
            for number, now in value.items():
                yield line("given", number, now)
        elif key == "block_skip":
            for number in value:
                yield line("skip_switch", number)
        elif key == "watch" and not len(value):
            continue
        else:
            raise LeftOutError(f"an option {key}")
    yield from setup_lines(options["setup"])
    yield from inputs_lines(options["inputs"])


# ---- what came out ----


def outcome_lines(run: cncsub.Run) -> Iterator[str]:
    yield line("stop", run.stop.value)
    if run.alarm is not None:
        alarm = run.alarm
        place = alarm.program, -1 if alarm.n is None else alarm.n, alarm.line, alarm.column
        yield line("alarm", alarm.cause, alarm.number or "", *place, alarm.word or "")
        yield line("message", str(alarm))
    yield line("steps", len(run.steps))
    for index in range(min(len(run.steps), MOST)):
        step = run.steps[index]
        yield line("step", step.program, step.line, -1 if step.n is None else step.n)
    for number in sorted(run.variables):
        yield line("variable", number, run.variables[number])
    for key in ("m_codes", "t_codes", "messages"):
        for value in getattr(run, key):
            yield line(key, value)
    for axis, value in run.position.items():
        yield line("position", axis, value)
    for group, code in run.modal.items():
        yield line("modal", group, code)
    for call in run.calls:
        yield line("call", call.kind, call.program, call.level, call.caller_step)
    yield line("moves", len(run.moves), run.moves.total_length, run.moves.total_time)
    columns = [f"{m}{axis}" for m in ("", "m") for axis in "xyz"] + ["feed", "time"]
    values = zip(*(getattr(run.moves, name).tolist() for name in columns))
    kinds = run.moves.kinds
    for kind, row, _ in zip(run.moves.kind.tolist(), values, range(MOST)):
        yield line("move", kinds[kind], *row)


# ---- the rows ----


class Told:
    """What the engine is handed in one run."""

    def __init__(self, scratch: str) -> None:
        self.scratch = scratch
        self.lines: list[str] = []
        self.begun: list[str] = []
        self._compile, self._machine = _core.compile, _core.machine
        _core.compile = self.compile
        _core.machine = self.machine

    def compile(self, control: Any, files: list[Any], device: bool, **how: Any) -> Any:
        kept = [
            (name.replace(self.scratch, "job").replace(f"{ROOT}/", ""), stem, [text], outside)
            for name, stem, text, outside in one_by_one(files)
        ]
        self.lines = [*control_lines(control), *file_lines(kept, device)]
        return self._compile(control, kept, device, **how)

    def machine(self, code: Any, main: int, **options: Any) -> Any:
        options["trace"] = "moves"  # a row that asks for less is compared in full too
        self.begun = list(option_lines(main, options))
        return self._machine(code, main, **options)


def row_lines(told: Told, name: str, library: Any, mdi: str | None, run: Any) -> list[str]:
    made = [line("row", name), *told.lines]
    if mdi is None and library.main is None:
        mdi = ""  # nothing to run runs
    if mdi is not None:
        made.append(line("typed", mdi))
    return [*made, *told.begun, *outcome_lines(run), line("end")]


def table_rows(told: Told, left_out: Counter[str], every: int) -> Iterator[list[str]]:
    for case, name in rows()[::every]:
        try:
            library = outcome.load(case, cncsub.controls[name])
            run = outcome.execute(case, library)
            yield row_lines(told, f"{case.topic}: {case.claim} [{name}]", library, case.mdi, run)
        except LeftOutError as reason:
            left_out[str(reason)] += 1
        except UnicodeDecodeError:
            left_out["a text that is no UTF-8"] += 1


def example_rows(told: Told, every: int) -> Iterator[list[str]]:
    """Each shipped program on every control: most alarm on most, and that is an outcome too."""
    files = sorted((ROOT / "examples").rglob("*.nc"))
    each = itertools.product(files, cncsub.controls)
    for file, control in itertools.islice(each, 0, None, every):
        library = cncsub.load(file, control=control)
        run = library.run(max_blocks=2000)
        name = f"{file.relative_to(ROOT).as_posix()} [{control}]"
        yield row_lines(told, name, library, None, run)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("output", type=Path, help="the file to write, such as selftest.rows")
    parser.add_argument("--every", type=int, default=1, help="only each so many-th row")
    arguments = parser.parse_args()
    output, every = arguments.output, arguments.every
    left_out: Counter[str] = Counter()
    told = Told(str(outcome.scratch()))
    written_rows = 0
    output.parent.mkdir(parents=True, exist_ok=True)
    begun = output.with_name(f"{output.name}.begun")  # what is cut off is no set of rows
    with begun.open("w", encoding="utf-8", newline="\n") as file:
        file.write(line("cncsub-selftest", FORMAT) + "\n")
        for source in (table_rows(told, left_out, every), example_rows(told, every)):
            for lines in source:
                file.write("\n".join(lines) + "\n")
                written_rows += 1
    begun.replace(output)
    print(f"{output}: {written_rows} rows, {output.stat().st_size >> 10} KiB")
    for reason, count in left_out.most_common():
        print(f"left out: {count} with {reason}")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
