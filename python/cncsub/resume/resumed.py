"""A run started again in the middle."""

from __future__ import annotations

import itertools
import os
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Unpack

from cncsub.interrupts import uninterrupted
from cncsub.pickling import NotPicklable
from cncsub.resume.errors import place_text, refused
from cncsub.resume.head import Head
from cncsub.resume.history import Before, FlatLines
from cncsub.resume.place import Place, as_place, length, stand_at
from cncsub.resume.proof import Part, parting
from cncsub.resume.state import RestartState, state_of
from cncsub.resume.tails import NoTailsError, Tails
from cncsub.run_options import FlattenOptions, check_names, takes, whole
from cncsub.setup import AXES
from cncsub.writing import write_whole

if TYPE_CHECKING:
    from cncsub.library import Library
    from cncsub.machine import Machine


class Resume(NotPicklable):
    """A restart program that has been proved: its `text`, and the `state` that it begins in.

    `form`: `"calls"`, where the programs that were open go on as programs, with loops and calls;
    `"flat"`, where the rest stands as blocks without calls, loops and variables. `files`: the
    programs, the one to start first, by file name. `notes`: what whoever starts it should know.

    >>> import cncsub
    >>> text = "O1\\nN10 G90 G54 G0 X0 Y0 Z50.\\nN20 G1 Z-5. F100\\nN30 X5.\\nN40 M30\\n"
    >>> resume = cncsub.loads(text, control="fanuc-0i-f").resume(at="O1:N30")
    >>> resume.state.modal["motion"], resume.state.position["Z"]
    ('G01', -5.0)
    >>> print(resume.text, end="")
    O9001
    G21 G17 G94 G40 G80 G90
    G54
    G00 Z50.
    G00 Z-5.
    F100
    G01
    N30 X5.
    N40 M30
    """

    _instead = "send its text"

    def __init__(
        self,
        state: RestartState,
        files: Mapping[str, str],
        form: str,
        notes: tuple[str, ...],
        differs: Callable[[], str | None],
    ) -> None:
        self.state = state
        self.files = dict(files)
        self.form = form
        self.notes = notes
        self._differs = differs

    @property
    def text(self) -> str:
        """The restart programs as one text, the one to start first."""
        return "".join(self.files.values())

    def write(self, path: str | os.PathLike[str]) -> None:
        """Write the text to a file; into a folder that exists, a file for each program."""
        if not Path(path).is_dir():
            write_whole(path, self.text)
            return
        for name, text in self.files.items():
            write_whole(Path(path) / name, text)

    def verify(self) -> None:
        """Run the restart program, and raise `AssertionError` with the first difference to the
        whole run from the place on: in moves (1e-9 mm, 1e-9 s), M and T codes, messages and the
        stop, and in the variables at the end where the form is `"calls"`.
        """
        differs = self._differs()
        if differs is not None:
            raise AssertionError(differs)

    def __repr__(self) -> str:
        place = place_text(self.state.block)
        count = len(self.files)
        programs = f"{count} program{'s' if count != 1 else ''}"
        return f"<Resume at {place}: {programs}, {self.form}>"


class _Work:
    """What a restart program is made from."""

    def __init__(
        self, library: Library, main: str | int | None, at: Any, options: dict[str, Any]
    ) -> None:
        self.library, self.main, self.options = library, main, options
        self.whole = uninterrupted(library.run(main, **options))
        if self.whole.stop not in ("end", "cycles"):
            raise refused(f"the whole run does not end: {self.whole.summary()}")
        self.machine: Machine = library.machine(main, **options)
        stand_at(library, self.machine, at, self.whole)
        block = self.machine.next
        if block is None:
            raise refused("the run ends there: nothing is left to be done")
        self.state = state_of(self.machine, block)
        self.before = Before(library, main, self.machine, options)
        self._refuse_compensation()

    def _refuse_compensation(self) -> None:
        """Refuse a start inside radius compensation: its path depends on the blocks before."""
        code = self.state.modal.get("radius")
        if code in (None, "G40"):
            return
        began = self.before.block_that_changed("radius")
        if began is None:
            return
        place = place_text(began[0])
        raise refused(
            f"radius compensation {code} is in force: start at {place}, which begins it, or after"
            " it is cancelled",
            self.state.block,
        )

    def head(self, approach: Any, *, data: bool, repeats: bool) -> Head:
        """Return the head; `repeats`: with the block before the place, where it makes no move."""
        head = Head(self.library, self.machine, self.state, self.options)
        head.modes_before_moves()
        head.variables(commons=not data)
        head.tool()
        head.clamp(self.before)  # before the surface speed turns the spindle
        head.spindle()
        head.approach(*approach)
        head.shift()
        head.modes_after_moves(self.before)
        if repeats and not (self.state.step and self._repeat(head)):
            raise NoTailsError("the block before it moves")
        return head

    def _repeat(self, head: Head) -> bool:
        return head.repeat(self.before.flat_text(self.state.step - 1))

    def differs(
        self, head: Head, library: Library, main: str | None, *, variables: bool
    ) -> str | None:
        options = {**self.options, "start": None, "max_cycles": 1}
        run = uninterrupted(library.run(main, **options))
        return parting(
            Part(self.whole, self.state.step, len(self.machine.messages)),
            Part(run, len(head.lines), len(head.now.messages)),
            variables=variables,
        )


def _of_calls(work: _Work, approach: Any, repeats: bool) -> Resume:
    """Return the rest as programs that are called, or raise the reason why there is none."""
    tails = Tails(work.library, work.machine, starts_over=work.whole.stop == "cycles")
    head = work.head(approach, data=False, repeats=repeats)
    name = f"O{tails.number}" if tails.number else _free_name(work.library, "RESTART{}")
    lines = [*([name] if tails.number else []), *head.lines, *tails.main]
    files = _named(work, {name: "".join(f"{line}\n" for line in lines), **tails.programs})
    library = work.library
    for file, text in files.items():
        library = _with(library, text, None if tails.number else file)
    if name not in library:
        raise NoTailsError(f"the control does not read {name} as the name of a program")

    def differs() -> str | None:
        return work.differs(head, library, name, variables=True)

    _prove(head, differs())
    return Resume(work.state, files, "calls", (), differs)


def _with(library: Library, text: str, file: str | None) -> Library:
    try:
        return library.with_program(text, name=file)
    except ValueError as error:
        raise NoTailsError(str(error)) from None


def _prove(head: Head, told: str | None) -> None:
    if told is not None:
        raise NoTailsError("; ".join([*head.lacks, told]))


def _flat(work: _Work, approach: Any, repeats: bool) -> Resume:
    head = work.head(approach, data=True, repeats=repeats)
    rest = FlatLines(work.machine.core.copy())
    if rest.refusal is not None or not rest.ends:
        raise NoTailsError(rest.refusal[0] if rest.refusal else "the run does not end")
    lines = [*head.lines, *rest.lines]
    if work.whole.stop == "cycles" and lines[-1].strip() == "M99":
        lines[-1] = "M30"
    name = _free_name(work.library, "O{}")
    headed = _is_head(work.library, name)
    text = "".join(f"{line}\n" for line in ([name] if headed else []) + lines)
    library = work.library.of_text(text, work.library.control)

    def differs() -> str | None:
        return work.differs(head, library, None, variables=False)

    _prove(head, differs())
    notes = ("the rest stands without calls and loops; it sets no variables",)
    name = name if headed else _free_name(work.library, "RESTART{}")
    return Resume(work.state, _named(work, {name: text}), "flat", notes, differs)


def _free_name(library: Library, form: str) -> str:
    """Return a name that no program of the memory has."""
    numbers = range(9001, 99999) if form.startswith("O") else itertools.chain([""], range(2, 99999))
    return next(name for n in numbers if (name := form.format(n)) not in library)


def _is_head(library: Library, name: str) -> bool:
    """Return whether the control reads the name at the head of a program."""
    alone = library.of_text(f"{name}\nM30\n", library.control)
    return alone.main is not None and alone.main.name == name and alone.run().stop == "end"


def _named(work: _Work, programs: Mapping[str, str]) -> dict[str, str]:
    """Return the programs by the names of their files, which end as that of the main one does."""
    main = work.library.main if work.main is None else work.library[work.main]
    suffix = Path(main.file).suffix if main is not None else ""
    return {f"{name}{suffix or '.nc'}": text for name, text in programs.items()}


def _order(order: Iterable[str] | None) -> tuple[str, ...] | None:
    """Return the groups of axes; raise `ValueError` for what are none."""
    if order is None:
        return None
    groups = tuple(str(group).upper() for group in order)
    letters = "".join(groups)
    if not letters or not set(letters) <= set(AXES) or len(set(letters)) < len(letters):
        raise ValueError(f"order must name axes, each once, such as ['XY', 'Z'], not {order!r}")
    return groups


@takes(FlattenOptions)
def resume(
    library: Library,
    main: str | int | None = None,
    *,
    at: Place,
    times: int = 1,
    safe_height: float | None = None,
    order: Iterable[str] | None = None,
    **options: Unpack[FlattenOptions],
) -> Resume:
    """Start a run again in the middle: see `Library.resume`."""
    check_names("resume", options, FlattenOptions)
    place = as_place(at, whole("times", times, 1))
    if isinstance(switches := options.get("block_skip"), Iterable):
        options["block_skip"] = tuple(switches)  # the program runs more than once
    work = _Work(library, main, place, dict(options))
    height = None if safe_height is None else length("safe_height", safe_height)
    approach = height, _order(order)
    reasons = []
    for form, repeats in ((_of_calls, False), (_flat, False), (_of_calls, True), (_flat, True)):
        try:
            return form(work, approach, repeats)
        except NoTailsError as error:
            reasons.append(str(error))
    raise refused(
        f"no restart program does the same from here on\nwith calls: {reasons[0]}\n"
        f"without calls: {reasons[1]}",
        work.state.block,
    )
