"""A case run through the public face of cncsub, and the differences of its outcome."""

from __future__ import annotations

import atexit
import functools
import itertools
import shutil
import tempfile
import textwrap
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import cncsub
from cncsub._core import variable_name
from cncsub.analysis.steps_text import step_lines
from cncsub.setup import setup_from
from cncsub.testing import moves as motion
from cncsub.testing.cases import UNKNOWN, Case, Row, Text

# No row needs more; a row (or a changed rule) that never ends stops here.
MAX_BLOCKS = 100_000
TOLERANCE = 2e-5

_SHOWN = 12  # blocks at either end of a run, and names of files, that a failure shows
_LINES = 30  # of a program that it shows

# M codes that end the run; they count as codes to the machine only where a row asks for them.
END_CODES = (2, 30)


def differences(case: Case, control: cncsub.Control) -> Iterator[str]:
    """Yield what the engine did otherwise than the case says, one readable text for each
    expectation.

    The cheap comparisons come first: a caller who only asks whether there is a difference takes the
    first text.
    """
    library = load(case, control)
    run = execute(case, library)
    yield from _stop_differences(case, _name_in(case, control), run)
    yield from _value_differences(case, run)
    yield from _block_differences(case, run)
    if case.arguments is not None:
        yield from _argument_differences(case, library, run)
    if case.wants_moves or case.final_work is not None:
        yield from _motion_differences(case, run)
    if case.resets:
        yield from _reset_differences(case, library)


def _name_in(case: Case, control: cncsub.Control) -> str:
    """Return the name by which a case knows a control, which may be changed."""
    return control.base if control.base in case.controls else control.name


def load(case: Case, control: cncsub.Control, *, general_only: bool = False) -> cncsub.Library:
    """Load the memory of the case on the control, with the rules and parameters of the case."""
    if case.replace:
        control = control.replace(**case.replace)
    if case.params:
        control = control.with_parameters(dict(case.params))
    external = None if case.external is None else _folder(case, "external")
    if case.files is not None:
        paths = case.paths or (_folder(case, "files"),)
        return cncsub.load(
            *paths,
            control=control,
            external=external,
            encoding=case.encoding,
            general_only=general_only,
        )
    return cncsub.loads(
        case.program or "", control=control, external=external, general_only=general_only
    )


def execute(case: Case, library: cncsub.Library, **others: Any) -> cncsub.Run:
    """Run the case; `others` are options that override its own."""
    options = {**_options(case), **others}
    if case.mdi is not None:
        return library.mdi(case.mdi, **options)
    return library.run(**options)


def _options(case: Case) -> dict[str, Any]:
    trace = "moves" if case.wants_moves else "blocks"
    options = {"max_blocks": MAX_BLOCKS, "trace": trace, **case.options}
    if case.setup is not None:
        options["setup"] = setup_from(case.setup)
    return options


@functools.cache
def scratch() -> Path:
    folder = Path(tempfile.mkdtemp(prefix="cncsub-cases-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder


# Each folder keeps its case: a new case may get the `id` of one that is gone.
_folders: dict[tuple[int, str], tuple[Case, Path]] = {}


def _folder(case: Case, which: str) -> Path:
    """Return the files of the case as a folder on disk, written once."""
    key = (id(case), which)
    if key not in _folders:
        folder = scratch() / str(len(_folders))
        folder.mkdir()
        files: Mapping[str, Text] = getattr(case, which)
        for name, text in files.items():
            file = folder / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(
                text if isinstance(text, bytes) else text.encode(case.encoding or "utf-8")
            )
        _folders[key] = (case, folder)
    return _folders[key][1]


def _stop_differences(case: Case, control: str, run: cncsub.Run) -> Iterator[str]:
    stop = run.stop.name.lower()
    alarm = run.alarm
    if stop != case.stop:
        yield f"stop: expected {case.stop}, got {stop}"
    if case.alarm is None or alarm is None:
        return
    if case.alarm not in (alarm.cause, alarm.number):
        got = alarm.cause if case.alarm in cncsub.causes else f"{alarm.number} {alarm.cause}"
        yield f"alarm: expected {case.alarm}, got {got}"
    number = case.number_on(control)
    if number is not UNKNOWN and alarm.number != number:
        yield f"alarm number: expected {number}, got {alarm.number}"
    if case.at is not None:
        at = alarm.program if alarm.n is None else f"{alarm.program} N{alarm.n}"
        if at != case.at:
            yield f"alarm at: expected {case.at}, got {at}"
    word = case.word_on(control)
    if word is not None and alarm.word != word:
        yield f"alarm word: expected {word}, got {alarm.word}"
    if case.frames is not None:
        open_calls = tuple(
            frame.program + ("" if frame.n is None else f" N{frame.n}") + f" {frame.kind}"
            for frame in alarm.frames
        )
        if open_calls != case.frames:
            yield f"alarm frames: expected {case.frames}, got {open_calls}"


def _value_differences(case: Case, run: cncsub.Run) -> Iterator[str]:
    for number, expected in case.variables.items():
        got = run.variables.get(number)
        yield from _variable_difference("vars", _name(run, number), expected, got)
    if case.m is not None:
        codes = [code for code in run.m_codes if code in case.m or code not in END_CODES]
        yield from _list_difference("m", case.m, codes)
    if case.t is not None:
        yield from _list_difference("t", case.t, run.t_codes)
    if case.dropped is not None:
        yield from _list_difference("dropped", case.dropped, [w.text for w in run.dropped])
    if case.messages is not None:
        yield from _list_difference("messages", case.messages, map(str, run.messages))


def _name(run: cncsub.Run, number: int) -> str:
    return variable_name(run.recorded.control, number)


def _variable_difference(
    what: str, name: str, expected: float | None, got: float | None
) -> Iterator[str]:
    if expected is None or got is None:
        same = expected is got
    else:
        same = abs(expected - got) <= TOLERANCE
    if not same:
        yield f"{what} {name}: expected {_value(expected)}, got {_value(got)}"


def _value(value: float | None) -> str:
    return "vacant" if value is None else f"{value:.10g}"


def _list_difference(what: str, expected: Any, got: Any) -> Iterator[str]:
    expected, got = list(expected), list(got)
    if expected != got:
        yield f"{what}: expected {expected}\n{' ' * len(what)}  got      {got}"


def _block_differences(case: Case, run: cncsub.Run) -> Iterator[str]:
    if case.runs is not None:
        got = executed(run, with_program=any(":" in block for block in case.runs))
        expected = _with_programs_as(got, case.runs)
        if expected != got:
            yield _order("runs", expected, got)
    if case.calls is not None:
        kinds, programs = run.calls.kinds, run.calls.programs
        codes = zip(run.calls.kind.tolist(), run.calls.program.tolist(), strict=True)
        entered = [f"{kinds[kind]}:{programs[program]}" for kind, program in codes]
        if list(case.calls) != entered:
            yield _order("calls", list(case.calls), entered)
    if case.tree is not None and (tree := call_tree(run)) != case.tree:
        yield f"tree: expected {case.tree}\n      got      {tree}"


def call_tree(run: cncsub.Run) -> str:
    """Return the calls as `tree` writes them. A call must lie in its caller's steps, one level
    deeper.
    """
    below: dict[int | None, list[Any]] = {}
    for call in run.calls:
        below.setdefault(call.parent, []).append(call)

    def written(parent: Any) -> str:
        parts = []
        for call in below.get(parent.call if parent else None, []):
            inside = parent is None or parent.first_step <= call.caller_step <= parent.last_step
            inner = written(call)
            parts.append(
                f"{call.kind}:{call.program}"
                + (f"({inner})" if inner else "")
                + ("" if inside else "!")
            )
        return " ".join(parts)

    return written(None)


def executed(run: cncsub.Run, *, with_program: bool) -> list[str]:
    """Return the executed blocks that carry an N, as `runs` writes them."""
    numbers = run.steps.n.tolist()
    if not with_program:
        return [f"N{n}" for n in numbers if n >= 0]
    names = run.steps.programs
    programs = run.steps.program.tolist()
    return [f"{names[p]}:N{n}" for p, n in zip(programs, numbers, strict=True) if n >= 0]


def _with_programs_as(got: list[str], expected: tuple[str, ...]) -> list[str]:
    """Give a block written without its program the program it met, so that only its N is
    compared.
    """
    if not any(":" in block for block in expected):
        return list(expected)
    met = itertools.chain(got, itertools.repeat(""))
    return [
        block if ":" in block else f"{there.rpartition(':')[0]}:{block}"
        for block, there in zip(expected, met, strict=False)
    ]


def _order(what: str, expected: list[str], got: list[str]) -> str:
    same = sum(1 for _ in itertools.takewhile(lambda pair: pair[0] == pair[1], zip(expected, got)))
    return (
        f"{what}: expected {_around(expected, same)}\n"
        f"{' ' * len(what)}  got      {_around(got, same)}\n"
        f"{' ' * len(what)}  they differ from place {same + 1} of {len(expected)}"
    )


def _around(blocks: list[str], place: int, width: int = 30) -> str:
    """Return the part of a long list around a place."""
    first = max(0, place - width // 2) if len(blocks) > width else 0
    shown = " ".join(blocks[first : first + width]) or "nothing"
    return ("... " if first else "") + shown + (" ..." if first + width < len(blocks) else "")


def _argument_differences(case: Case, library: cncsub.Library, run: cncsub.Run) -> Iterator[str]:
    """Stop after the step that enters the first call with locals of its own, and compare them."""
    levels = run.calls.level.tolist()
    first = next((call for call, level in enumerate(levels) if level > 0), None)
    if first is None:
        yield "arguments: no macro was called"
        return
    machine = library.machine(**_options(case))
    for _ in range(run.calls.caller_step.tolist()[first] + 1):
        machine.step()
    for number, expected in (case.arguments or {}).items():
        got = machine.variables.get(number)
        name = variable_name(library.control, number)
        yield from _variable_difference("arguments", name, expected, got)


def _reset_differences(case: Case, library: cncsub.Library) -> Iterator[str]:
    machine = library.machine(**_options(case))
    for _ in machine:
        pass
    machine.reset()
    for number, expected in (case.vars_after_reset or {}).items():
        got = machine.variables.get(number)
        name = variable_name(library.control, number)
        yield from _variable_difference("vars after reset", name, expected, got)
    if case.work_after_reset is not None:
        place = dict(machine.position)
        yield from _place_difference("work after reset", case.work_after_reset, place)
    for name, code in (case.modal_after_reset or {}).items():
        if machine.modal.get(name) != code:
            yield f"{name} after reset: expected {code}, got {machine.modal.get(name)}"


def _motion_differences(case: Case, run: cncsub.Run) -> Iterator[str]:
    made = motion.made_moves(run.moves) if case.wants_moves else []
    if case.moves is not None:
        yield from motion.compare(case.moves, made, _start(case))
    travel = [move for move in made if move.kind != "dwell"]
    if case.moves_x is not None:
        got = [move.end.get("X") for move in travel]
        if len(got) != len(case.moves_x) or not all(
            x is not None and abs(x - expected) <= motion.TOLERANCE
            for x, expected in zip(got, case.moves_x, strict=True)
        ):
            yield from _list_difference("moves_x", case.moves_x, got)
    if case.centre is not None:
        path = [place for move, place in zip(made, _machine_path(run)) if move.kind != "dwell"]
        if len(path) != len(case.centre) or not all(map(motion.near, case.centre, path)):
            expected = " | ".join(map(motion.write_point, case.centre))
            yield f"centre: expected {expected}\n        got      " + " | ".join(
                motion.write_point(place) for place in path
            )
    if case.final_machine is not None:
        path = _machine_path(run)
        yield from _place_difference("final machine", case.final_machine, path[-1] if path else {})
    if case.final_work is not None:
        yield from _place_difference("final work", case.final_work, dict(run.position))
    if case.time is not None:
        seconds = sum(move.seconds for move in made)
        if abs(seconds - case.time) > 0.002:
            yield f"time: expected {case.time} s, got {seconds:.4f} s"


def _start(case: Case) -> dict[str, float]:
    """Return where the axes stand at first in work coordinates, as far as the row says."""
    setup = case.setup or {}
    start = dict(setup.get("start", {}))
    if "work_offsets" not in setup:
        axes = "XZ" if str(setup.get("machine", "mill")).startswith("lathe") else "XYZ"
        start = dict.fromkeys(axes, 0.0) | start
    return start


def _machine_path(run: cncsub.Run) -> list[dict[str, float]]:
    columns = (getattr(run.moves, f"m{axis}").tolist() for axis in "xyz")
    return [dict(zip("XYZ", place, strict=True)) for place in zip(*columns, strict=True)]


def _place_difference(what: str, expected: Any, got: Mapping[str, float]) -> Iterator[str]:
    if not motion.near(expected, got):
        yield f"{what}: expected {motion.write_point(expected)}, got {motion.write_point(got)}"


def _parting(case: Case, run: cncsub.Run) -> Iterator[str]:
    """Yield where the executed blocks part from `runs`: the last block in common, and the
    next one.
    """
    if case.runs is None:
        return
    got = executed(run, with_program=any(":" in block for block in case.runs))
    expected = _with_programs_as(got, case.runs)
    if expected == got:
        return
    same = sum(1 for _ in itertools.takewhile(lambda pair: pair[0] == pair[1], zip(expected, got)))
    numbered = [step for step, n in enumerate(run.steps.n.tolist()) if n >= 0]
    for what, place in (("as expected up to", same - 1), ("then ran", same)):
        if 0 <= place < len(numbered):
            lines = "\n    ".join(step_lines(run, numbered[place]))
            yield f"{what}: {lines}"


def _last_writes(case: Case, library: cncsub.Library, run: cncsub.Run) -> Iterator[str]:
    """Yield which blocks gave the variables that differ their last values."""
    wrong = [
        number
        for number, expected in case.variables.items()
        if any(_variable_difference("", "", expected, run.variables.get(number)))
    ]
    if not wrong:
        return
    rows = list(execute(case, library, watch=wrong).watch)
    for number in wrong:
        steps = [row.step for row in rows if row.variable == number and row.step is not None]
        if steps and steps[-1] < len(run.steps):
            lines = "\n    ".join(step_lines(run, steps[-1]))
            yield f"{_name(run, number)} was last written by {lines}"


def report(row: Row, found: list[str], control: cncsub.Control | None = None) -> str:
    """Return what a person needs to see of a row that failed."""
    case = row.case
    library = load(case, control or cncsub.controls[row.control])
    run = execute(case, library)
    parts = [
        *found,
        f"of {_place_of(case)}: {case.claim}",
        case.told_on(row.control),
        *_parting(case, run),
        *_last_writes(case, library, run),
    ]
    if run.alarm is not None:
        parts.append(f"the alarm:\n{textwrap.indent(str(run.alarm), '    ')}")
    parts += _what_ran(run)
    values = run.variables
    told = [
        f"{_name(run, n)}={_value(values.get(n))}" for n in itertools.islice(sorted(values), 40)
    ]
    if told:
        parts.append(f"variables at the stop: {' '.join(told)}")
    return "\n".join([*parts, *_programs(case)])


def _place_of(case: Case) -> str:
    """Return where the case is written: a table that is no Python has no lines."""
    return f"{case.topic}{', case ' if case.topic.endswith('.toml') else ':'}{case.line}"


def _what_ran(run: cncsub.Run) -> Iterator[str]:
    """Yield the executed blocks: by N where all have one, else with their text."""
    count = len(run.steps)
    if all(n >= 0 for n in run.steps.n.tolist()):
        yield f"executed: {_around(executed(run, with_program=True), 0, 60)}"
        if count and run.alarm is None:
            lines = "\n    ".join(step_lines(run, count - 1))
            yield f"the last block: {lines}"
        return
    yield f"executed, {count} blocks:"
    first = range(min(count, _SHOWN))
    last = range(max(first.stop, count - _SHOWN), count)
    for part in (first, last):
        if part is last and last.start > first.stop:
            yield f"    ... {last.start - first.stop} more ..."
        for step in map(run.steps.__getitem__, part):
            yield f"    {step.program}:{step.line}  {step.text.strip()}"


def _programs(case: Case) -> Iterator[str]:
    """Yield the programs: files by name, and the first lines of texts."""
    if case.paths:
        names = list(case.files or {})
        more = f" and {len(names) - _SHOWN} more" if len(names) > _SHOWN else ""
        yield f"loaded: {', '.join(names[:_SHOWN])}{more}"
    else:
        yield from _listing("program", case.program)
    for what, files in (("file", case.files), ("external file", case.external)):
        for name, text in (files or {}).items():
            if what != "file" or not case.paths:
                yield from _listing(f"{what} {name}", text)
    yield from _listing("MDI", case.mdi)


def _listing(title: str, text: Text | None) -> Iterator[str]:
    if text is not None:
        shown = text if isinstance(text, str) else text.decode("utf-8", "backslashreplace")
        lines = shown.rstrip().split("\n")
        more = len(lines) - _LINES
        shown = "\n".join(lines[:_LINES]) + (f"\n... {more} more lines" if more > 0 else "")
        yield f"{title}:\n{textwrap.indent(shown, '    ')}"


def check_case(case: Case, control: str | cncsub.Control | None = None) -> None:
    """Run a case on its controls, or on one, and compare. Raises `AssertionError` with the
    programs, what ran, the alarm and the variables where something differs.
    """
    names = case.controls if control is None else (control,)
    for name in names:
        known = name if isinstance(name, cncsub.Control) else cncsub.controls[name]
        found = list(differences(case, known))
        if found:
            raise AssertionError(report(Row(case, _name_in(case, known)), found, known))
