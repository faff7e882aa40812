"""A case and how it is written: its programs, how they run, and the expected outcome."""

from __future__ import annotations

import inspect
import re
import textwrap
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

from cncsub.signatures import spelled_out
from cncsub.testing.moves import Move, Point, read_moves, read_point

STOPS = ("end", "alarm", "cycles", "limit", "waiting")

Text = str | bytes
UNKNOWN = "unknown"
T = TypeVar("T")


@dataclass(frozen=True, kw_only=True)
class Case:
    """One claim: the programs, how they are run and the expected outcome.

    An expectation that is `None` is not compared, except `number`: there it says that no source
    gives the alarm a number.
    """

    claim: str
    controls: tuple[str, ...]
    source: str | Mapping[str, str]
    topic: str  # where it is written
    line: int

    # The memory: one text, or a folder of files. `external` is the folder of the external device.
    program: Text | None
    files: Mapping[str, Text] | None
    paths: tuple[Path, ...] = ()  # where the files stand, if they stand on disk already
    external: Mapping[str, Text] | None
    encoding: str | None

    # The run.
    mdi: str | None
    params: Mapping[str, int | float]
    replace: Mapping[str, bool | int | str]  # rules
    setup: Mapping[str, Any] | None
    options: Mapping[str, Any]  # the keywords of `library.run` as they are

    # What comes out.
    runs: tuple[str, ...] | None
    stop: str
    alarm: str | None
    number: str | Mapping[str, str | None] | None
    at: str | None
    word: str | Mapping[str, str] | None
    variables: Mapping[int, float | None]
    m: Sequence[int] | None
    t: Sequence[int] | None
    messages: Sequence[str] | None
    dropped: Sequence[str] | None
    calls: tuple[str, ...] | None
    tree: str | None
    frames: tuple[str, ...] | None
    arguments: Mapping[int, float | None] | None
    moves: tuple[Move, ...] | None
    moves_x: Sequence[float] | None
    centre: tuple[Point, ...] | None
    final_machine: Point | None
    final_work: Point | None
    time: float | None
    vars_after_reset: Mapping[int, float | None] | None
    work_after_reset: Point | None
    modal_after_reset: Mapping[str, str] | None

    def told_on(self, control: str) -> str:
        """Return the control and the source, for a report."""
        source = self.source_on(control)
        return f"control {control}" + (f"; source: {source}" if source else "")

    def source_on(self, control: str) -> str:
        """Return the source of the claim on a control."""
        return self.source if isinstance(self.source, str) else self.source[control]

    def number_on(self, control: str) -> str | None:
        """Return the number of the alarm; `UNKNOWN` on a control that the row does not mention."""
        if isinstance(self.number, Mapping):
            return self.number.get(control, UNKNOWN)
        return self.number

    def word_on(self, control: str) -> str | None:
        """Return the word under the caret."""
        return self.word.get(control) if isinstance(self.word, Mapping) else self.word

    @property
    def says_what_happened(self) -> bool:
        """Whether the case says more than how the run stopped."""
        said: tuple[object, ...] = (self.runs, self.m, self.t, self.messages, self.dropped)
        said += (self.calls, self.tree, self.arguments, self.final_work)
        some = any(expectation is not None for expectation in said)
        return some or bool(self.variables) or self.wants_moves or self.resets

    @property
    def resets(self) -> bool:
        """Whether the case says what holds after the reset key."""
        after = (self.vars_after_reset, self.work_after_reset, self.modal_after_reset)
        return any(expectation is not None for expectation in after)

    @property
    def wants_moves(self) -> bool:
        """Whether the case says something about moves."""
        motion = (self.moves, self.moves_x, self.centre, self.final_machine, self.time)
        return any(expectation is not None for expectation in motion)


class Row(NamedTuple):
    """A case on one of its controls."""

    case: Case
    control: str

    def __str__(self) -> str:
        return f"{self.case.topic}: {self.case.claim} [{self.control}]"


def read_case(
    claim: str,
    *,
    control: str | Sequence[str],
    source: str | Mapping[str, str] = "",
    topic: str = "",
    line: int = 0,
    program: Text | None = None,
    files: Mapping[str, Text] | None = None,
    external: Mapping[str, Text] | None = None,
    encoding: str | None = None,
    main: str | int | None = None,
    mdi: str | None = None,
    start: int | None = None,
    params: Mapping[str, int | float] | None = None,
    replace: Mapping[str, bool | int | str] | None = None,
    skip: Sequence[int] = (),
    optional_stop: bool = False,
    variables: Mapping[int, float | None] | None = None,
    inputs: Mapping[Any, Any] | None = None,
    setup: Mapping[str, Any] | None = None,
    max_cycles: int | None = None,
    max_blocks: int | None = None,
    runs: str | None = None,
    stop: str | None = None,
    alarm: str | None = None,
    number: str | Mapping[str, str | None] | None = None,
    at: str | None = None,
    word: str | Mapping[str, str] | None = None,
    vars: Mapping[int, float | None] | None = None,
    m: Sequence[int] | None = None,
    t: Sequence[int] | None = None,
    messages: Sequence[str] | None = None,
    dropped: Sequence[str] | None = None,
    calls: str | None = None,
    tree: str | None = None,
    frames: str | None = None,
    arguments: Mapping[int, float | None] | None = None,
    moves: str | None = None,
    moves_x: Sequence[float] | None = None,
    centre: str | None = None,
    final_machine: str | None = None,
    final_work: str | None = None,
    time: float | None = None,
    vars_after_reset: Mapping[int, float | None] | None = None,
    work_after_reset: str | None = None,
    modal_after_reset: Mapping[str, str] | None = None,
) -> Case:
    """Return the case that these words describe; see `case`. Raises `ValueError` for a case without
    a meaning.
    """
    controls = (control,) if isinstance(control, str) else tuple(control)
    options = {
        "main": main,
        "start": start,
        "block_skip": tuple(skip) or None,
        "optional_stop": optional_stop or None,
        "variables": variables,
        "inputs": inputs,
        "max_cycles": max_cycles,
        "max_blocks": max_blocks,
    }
    row = Case(
        claim=claim,
        controls=controls,
        source=source,
        topic=topic,
        line=line,
        program=None if program is None else as_program(program),
        files=None if files is None else {name: as_program(text) for name, text in files.items()},
        external=external and {name: as_program(text) for name, text in external.items()},
        encoding=encoding,
        mdi=None if mdi is None else textwrap.dedent(mdi).strip("\n"),
        params=params or {},
        replace=replace or {},
        setup=setup,
        options={name: value for name, value in options.items() if value is not None},
        runs=_read("runs", read_runs, runs),
        stop=stop or ("alarm" if alarm else "end"),
        alarm=alarm,
        number=number,
        at=at,
        word=word,
        variables=vars or {},
        m=m,
        t=t,
        messages=messages,
        dropped=dropped,
        calls=None if calls is None else tuple(calls.split()),
        tree=tree,
        frames=None if frames is None else tuple(f.strip() for f in frames.split("<") if f.strip()),
        arguments=arguments,
        moves=_read("moves", read_moves, moves),
        moves_x=moves_x,
        centre=_read("centre", _points, centre),
        final_machine=_read("final_machine", read_point, final_machine),
        final_work=_read("final_work", read_point, final_work),
        time=time,
        vars_after_reset=vars_after_reset,
        work_after_reset=_read("work_after_reset", read_point, work_after_reset),
        modal_after_reset=modal_after_reset,
    )
    fault = _fault(row)
    if fault:
        raise ValueError(f"{claim!r} {fault}")
    return row


def _read(key: str, read: Callable[[str], T], text: str | None) -> T | None:
    """Return what a text of a key says; an error names the key."""
    try:
        return None if text is None else read(text)
    except ValueError as error:
        raise ValueError(f"{key}: {error}") from None


def _points(text: str) -> tuple[Point, ...]:
    return tuple(map(read_point, text.split("|")))


def _fault(row: Case) -> str | None:
    """Return what makes a row meaningless, or `None`."""
    if not row.controls:
        return "names no control"
    if row.program is not None and row.files is not None:
        return "has both a program and files"
    if row.program is None and row.files is None and row.mdi is None:
        return "has nothing to run: it gives no program, files or mdi"
    if row.stop not in STOPS:
        return f"cannot stop with {row.stop!r}: a run stops with {', '.join(STOPS)}"
    if (row.stop == "alarm") != (row.alarm is not None):
        return (
            'stops with "alarm" but has no alarm'
            if row.alarm is None
            else f"has an alarm, but stops with {row.stop!r}"
        )
    if row.alarm is None and not row.says_what_happened:
        return "says how it stops, but not what happened before: add runs or vars"
    if row.alarm is None and (row.number or row.at or row.word or row.frames is not None):
        return "says where or how it alarms (number, at, word, frames), but not which alarm"
    if not isinstance(row.source, str) and set(row.source) != set(row.controls):
        return "gives sources for other controls than it runs on"
    if isinstance(row.number, Mapping) and set(row.number) != set(row.controls):
        return "gives alarm numbers for other controls than it runs on"
    return None


def as_program(text: Text) -> Text:
    """Return a program as it would stand in a file: without the indentation of the table."""
    if isinstance(text, bytes):
        return text
    body = textwrap.dedent(text).strip("\n").rstrip(" ")
    return body + "\n" if body else ""


_RUN = re.compile(r"\s*(?:(?P<open>\()|(?P<close>\))|(?P<name>[^\s()*]+))(?:\*(?P<times>\d+))?")


def read_runs(text: str) -> tuple[str, ...]:
    """Write `runs` out: `(N1 O2:N02)*2` becomes `N1 O2:N2 N1 O2:N2`."""
    groups: list[list[str]] = [[]]
    place, end = 0, len(text.rstrip())
    while place < end:
        found = _RUN.match(text, place)
        if found is None or (found["open"] and found["times"]):
            raise ValueError(f"cannot read runs from {text[place:]!r}")
        times = int(found["times"] or 1)
        if found["open"]:
            groups.append([])
        elif found["close"]:
            if len(groups) == 1:
                raise ValueError(f"a parenthesis is closed that is not open: {text!r}")
            inner = groups.pop()
            groups[-1] += inner * times
        else:
            groups[-1] += [_read_block(found["name"])] * times
        place = found.end()
    if len(groups) > 1:
        raise ValueError(f"a parenthesis is not closed: {text!r}")
    return tuple(groups[0])


def _read_block(name: str) -> str:
    program, colon, n = name.rpartition(":N") if ":N" in name else ("", "", name.removeprefix("N"))
    if not n.isdigit() or (not colon and not name.startswith("N")):
        raise ValueError(f"not a block: {name!r}")
    return f"{program}:N{int(n)}" if colon else f"N{int(n)}"


_tables: list[list[Case]] = []  # the tables that are being read


@spelled_out(read_case, "topic", "line")
def case(claim: str, **said: Any) -> Case:
    """Write one case of a table; `load_table` collects those of a file.

    `control`: a name or several. `program`: a text, whose indentation is taken away; or `files`:
    name to text, and `external` those of the external device, in `encoding`; or `mdi`, what is
    typed. `params`, `replace`: parameters and rules of the control. `main`, `start`, `skip`,
    `optional_stop`, `variables`, `inputs`, `setup`, `max_cycles`, `max_blocks`: as `Library.run`
    takes them. `source`: where the claim comes from.

    The expected results: `runs`, the N numbers of all executed blocks in order, `O1:N10` where an N
    repeats between programs, `N10*5` and `(N60 N70)*5` for repeats; blocks without an N are left
    out. `stop`: `end` without it, `alarm` where `alarm`, a cause, is given; `number`, `at`
    (`"O2 N30"`), `word` and `frames` (`O2 N50 G65 < O1 N10 M98`) describe the alarm. `vars`:
    variables at the stop, `None` is vacant. `m`, `t`, `messages`, `dropped`: what was sent. `calls`
    (`"M98:O2 G65:O3"`), `tree` (`M98:O2(G65:O3)`), `arguments` of the first macro. `moves`: one
    line a move, `R X1 Y2` rapid, `F X1` feed, `CW X4 Y0 C X2 Y0` an arc and its centre, `W 1.5` a
    dwell; `moves_x`, `centre`, `final_machine`, `final_work`, `time` in seconds.
    `vars_after_reset`, `work_after_reset`, `modal_after_reset`: after the reset key. What is not
    said is not compared.

    Raises `ValueError` for a case that means nothing.

    >>> from cncsub.testing import case, check_case
    >>> check_case(
    ...     case(
    ...         "the macro squares its argument",
    ...         control="fanuc-0i-f",
    ...         program="O1\\nN10 G65 P2 A3.\\nN20 M30\\nO2\\nN30 #100=#1*#1\\nN40 M99",
    ...         runs="N10 N30 N40 N20",
    ...         vars={100: 9},
    ...     )
    ... )
    """
    here = inspect.currentframe()
    assert here is not None
    assert here.f_back is not None
    caller = here.f_back
    place = {"topic": Path(caller.f_code.co_filename).stem, "line": caller.f_lineno}
    made = read_case(claim, **{**place, **said})
    if _tables:
        _tables[-1].append(made)
    return made


@contextmanager
def collected() -> Iterator[list[Case]]:
    _tables.append([])
    try:
        yield _tables[-1]
    finally:
        _tables.pop()
