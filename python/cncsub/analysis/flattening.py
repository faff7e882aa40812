"""A run written as one program without calls, jumps and loops."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any, NoReturn, Unpack

from cncsub import _core
from cncsub._core import Control
from cncsub.analysis.block_errors import BlockError
from cncsub.analysis.pairs import Pair, Parting, Question, variables_lacking
from cncsub.controls import control_of
from cncsub.inputs import by_number
from cncsub.interrupts import uninterrupted
from cncsub.pickling import NotPicklable
from cncsub.run_options import FlattenOptions, check_names, idle_machine, takes
from cncsub.tables.rows import Origin
from cncsub.tables.table import Table
from cncsub.writing import opened

if TYPE_CHECKING:
    import numpy as np

    from cncsub.library import Library

    Columns = Mapping[str, np.ndarray[Any, Any]]

_KEPT = 1 << 24  # bytes of text that are kept; a longer text is written anew at each look
_ORIGINS = ("program", "n", "line", "call", "pass")


class FlattenError(BlockError):
    """The error where no flat program exists or none can be written. `.reason`; `.program`, `.n`
    and `.line` give the block, `None` where no single block is the cause.
    """


class Origins(Table[Origin]):
    """The origins of the blocks of a flat program, one row each, in order.

    Columns: `program` (codes of `programs`), `n` (-1: none), `line`, `call` (the row of
    `run.calls`, -1: the main program) and `pass` (of its call, from 1).

    >>> import cncsub
    >>> text = "O1\\nN10 M98 P2 L2\\nN20 M30\\nO2\\nN30 G91 G0 X5.\\nN40 M99\\n"
    >>> origins = cncsub.loads(text, control="fanuc-0i-f").flatten().origins
    >>> origins[1]
    Origin(program='O2', n=30, line=5, call=0, repeat=2)
    >>> origins["pass"].tolist()
    [1, 2, 1]
    """

    _title = "blocks"

    def __init__(self, programs: list[str], columns: Columns) -> None:
        self._columns = dict(columns)
        self._programs = programs
        for column in self._columns.values():
            column.flags.writeable = False

    @property
    def columns(self) -> list[str]:
        return list(_ORIGINS)

    @property
    def programs(self) -> list[str]:
        """The names that the codes of the column `program` stand for."""
        return self._programs

    def _rows(self) -> int:
        return len(self._columns["n"])

    def _row(self, index: int) -> Origin:
        program, n, *rest = (int(self._columns[name][index]) for name in _ORIGINS)
        return Origin(self._programs[program], None if n < 0 else n, *rest)

    def _fetch(self, names: list[str]) -> dict[str, np.ndarray[Any, Any]]:
        return {name: self._columns[name].copy() for name in names}

    def texts_of(self, name: str) -> list[str] | None:
        return self._programs if name == "program" else None


class Flat(NotPicklable):
    """A flat program: its `text`, and `origins` with a row (an `Origin`) for each block.

    >>> import cncsub
    >>> text = "O1\\nN10 M98 P2\\nN20 M30\\nO2\\nN30 G0 X5.\\nN40 M99\\n"
    >>> flat = cncsub.loads(text, control="fanuc-0i-f").flatten()
    >>> flat.text.splitlines(), flat.origins[0].program, flat.origins[0].n
    (['O1', 'G0 X5.', 'M30'], 'O2', 30)

    A text of more than 16 MB is not kept: each use of `text`, `origins`, `pieces()` or `write()`
    runs the program again.
    """

    _instead = "send its text"

    def __init__(
        self,
        begin: Callable[[], _core.Flattening],
        parts: Callable[[str], Parting | None],
    ) -> None:
        self._begin = begin
        self._parts = parts
        self._blocks = 0
        self._edited: str | None = None
        self._kept: list[tuple[bytes, Columns]] | None = []
        size = 0
        for text, columns in self._written():
            size += len(text)
            self._blocks += len(columns["n"])
            if self._kept is not None:
                self._kept.append((text, columns))
            if size > _KEPT:
                self._kept = None

    def _written(self) -> Iterator[tuple[bytes, Columns]]:
        """Yield the pieces as the engine writes them; raise at the end what keeps the text from
        being whole.
        """
        core = self._begin()
        while (piece := core.next()) is not None:
            yield piece
        if core.refusal is not None:
            raise FlattenError(*core.refusal)
        if not core.ends:
            raise _does_not_end(core)

    def pieces(self) -> Iterator[str]:
        """Yield the text in pieces of about a megabyte, each of which ends with a block. A text
        that was set comes in one piece.
        """
        if self._edited is not None:
            yield self._edited
            return
        for text, _ in self._kept if self._kept is not None else self._written():
            yield text.decode(errors="surrogateescape")

    @property
    def text(self) -> str:
        """The flat program. Set it to see with `verify` what an edit changes."""
        return "".join(self.pieces())

    @text.setter
    def text(self, text: str) -> None:
        self._edited = text

    @cached_property
    def origins(self) -> Origins:
        """The origin of each block of the text: see `Origins`."""
        import numpy as np

        pieces = self._kept if self._kept is not None else list(self._columns_again())
        columns = {name: np.concatenate([of[name] for _, of in pieces]) for name in _ORIGINS}
        return Origins(self._begin().program_names, columns)

    def _columns_again(self) -> Iterator[tuple[bytes, Columns]]:
        for _, columns in self._written():
            yield b"", columns

    def write(self, path: str | os.PathLike[str]) -> None:
        """Write the text to a file piece by piece; memory holds one piece. Raises `OSError` where
        the file cannot be written.
        """
        with opened(path, "wb") as file:
            for piece in self.pieces():
                file.write(piece.encode(errors="surrogateescape"))

    def verify(self) -> None:
        """Run the program and the text, and raise `AssertionError` with the first difference
        between the two in moves (1e-9 mm), M and T codes, messages and the stop. Memory: that of
        both runs and of the text.
        """
        parting = self.parting()
        if parting is not None:
            raise AssertionError(parting.what)

    def parting(self) -> Parting | None:
        """Return the first difference between the runs of the program and of the text,
        or `None`.
        """
        return self._parts(self.text)

    def __repr__(self) -> str:
        return f"<Flat: {self._blocks:,} block{'s' if self._blocks != 1 else ''}>"


@takes(FlattenOptions)
def flatten(
    library: Library,
    main: str | int | None = None,
    *,
    control: str | Control | None = None,
    comments: bool = False,
    **options: Unpack[FlattenOptions],
) -> Flat:
    """Write what `main` executes as one program without calls, jumps and loops.

    The words of the blocks stand as they are written. Computed values stand as numbers that the
    control reads as the same value (in brackets where it accepts no plain number). Offsets, outputs
    and messages that statements set are set by statements without variables; what DPRNT prints
    stands in local variables.

    `control`: the one that the flat program is for, the library's where it is not given; for
    another one the flat program is run and compared before it is returned. `comments`: whether the
    origin of each block is written after it. The other options are those of `Library.run`.

    Raises `FlattenError`, a `ValueError` with the reason and the block, where there is no such
    program: the run does not end or ends by an alarm that is not the program's own, the control
    cannot write a value, or the program does not run alike on the other control.

    >>> import cncsub
    >>> text = "O1\\nG90 G0\\nM98 P2 L2\\nM30\\nO2\\nX#100\\n#100=#100+5\\nM99\\n"
    >>> library = cncsub.loads(text, control="fanuc-0i-f")
    >>> print(cncsub.flatten(library, variables={100: 0}).text, end="")
    O1
    G90 G0
    X0.
    X5.
    M30
    """
    check_names("flatten", options, FlattenOptions)
    if not isinstance(comments, bool):
        raise TypeError(f"comments must be True or False, not {comments!r}")
    if isinstance(switches := options.get("block_skip"), Iterable):
        options["block_skip"] = tuple(switches)  # the program runs more than once
    target = library.control if control is None else control_of(control)

    def written(in_its_words: bool) -> Flat:
        def begin() -> _core.Flattening:
            other = idle_machine(target, setup=options.get("setup")) if in_its_words else None
            return _core.flattening(library.begin(main, **options, trace="calls"), comments, other)

        return Flat(begin, lambda text: _parts(library, main, target, options, text))

    if control is None:
        return written(False)
    if target.dialect == library.control.dialect:
        flat = written(False)
        if flat.parting() is None:
            return flat
    flat = written(True)
    parting = flat.parting()
    if parting is not None:
        _refuse(parting, library, main, options)
    return flat


def _refuse(
    parting: Parting, library: Library, main: str | int | None, options: FlattenOptions
) -> NoReturn:
    """Refuse a flat program for another control that does not run alike."""
    run = uninterrupted(library.run(main, **options))
    reason = f"the flat program would not do the same\n{parting.what}"
    if not len(run.steps):
        raise FlattenError(reason)
    step = run.steps[min(parting.first, len(run.steps) - 1)]
    raise FlattenError(reason, step.program, step.n, step.line)


def _parts(
    library: Library, main: str | int | None, control: Control, options: FlattenOptions, text: str
) -> Parting | None:
    """Return the first difference between the runs of the program and of its flat program."""
    again: FlattenOptions = {
        **options,
        "max_cycles": 1,
        "start": None,
    }  # the flat program begins there
    flat = library.of_text(text, control)
    given = by_number("variables", library.control, options.get("variables") or {})
    lacking = variables_lacking(control, given)  # their values stand in the text
    again["variables"] = {n: value for n, value in given.items() if n not in lacking}
    question: Question = "flat" if control is library.control else "rewritten"
    pair = Pair(question, (library, flat), ("program", "flat"), main, options)
    try:
        run, other = map(uninterrupted, (library.run(main, **options), flat.run(**again)))
    except KeyError as error:  # read by this control, the text has no such program
        raise FlattenError(
            f"{control.name} reads the flat text differently: {error.args[0]}"
        ) from None
    if len(other.calls):
        call = other.calls[0]
        step = other.steps[call.caller_step]
        what = f"the flat program calls {call.program} in line {step.line}"
        return Parting(len(run.steps), call.caller_step, what)
    return pair.parting(run, other)


def _does_not_end(core: _core.Flattening) -> FlattenError:
    alarm = core.alarm
    if alarm is not None:
        what = " ".join(filter(None, (alarm.number, alarm.cause)))
        why = f", {alarm.detail}" if alarm.detail else ""
        return FlattenError(
            f"the run ends by an alarm: {what}{why}",
            alarm.program,
            alarm.n,
            alarm.line,
        )
    if core.stop == "interrupted":
        raise KeyboardInterrupt
    waits = f" for {core.waiting_for}" if core.waiting_for else ""
    return FlattenError(f"the run does not end: it stopped with {core.stop}{waits}")
