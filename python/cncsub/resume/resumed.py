"""A run started again in the middle."""

from __future__ import annotations

import errno
import itertools
import os
from collections.abc import Callable, Iterable, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Unpack

from cncsub.option_errors import carrying
from cncsub.pickling import NotPicklable
from cncsub.resume.draft import Draft
from cncsub.resume.errors import place_text, refused
from cncsub.resume.head import Manner
from cncsub.resume.history import FlatLines
from cncsub.resume.modes import with_motion
from cncsub.resume.place import Place, as_place, length
from cncsub.resume.start import given_setup
from cncsub.resume.state import RestartState
from cncsub.resume.tails import NoTailsError, Tails, free_numbers
from cncsub.resume.work import Work, Written
from cncsub.run_options import FlattenOptions, check_names, takes, whole
from cncsub.setup import AXES
from cncsub.writing import write_whole

if TYPE_CHECKING:
    from cncsub.library import Library


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
    G21 G17 G94 G40 G80 G49 G90
    G54
    G00 Z50.
    G00 X0. Y0.
    G01 Z-5. F100
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
        written: Written,
    ) -> None:
        self.state = state
        self._written = written
        self.files = dict(files)
        self.form = form
        self.notes = notes
        self._differs = differs

    @property
    def text(self) -> str:
        """The restart programs as one text, the one to start first."""
        return "".join(self.files.values())

    def write(self, path: str | os.PathLike[str], *, force: bool = False) -> None:
        """Write the text to a file; into a folder that exists, a file for each program. Lines end
        as in the file of the main program, between marks `%` where that begins with one.

        Raises `FileExistsError` for a file of the folder that is there and holds another program,
        unless `force` is true; nothing is written then.
        """
        if not Path(path).is_dir():
            write_whole(path, self._bytes(self.text))
            return
        files = {Path(path) / name: self._bytes(text) for name, text in self.files.items()}
        for file, data in files.items():
            if not force and file.exists() and file.read_bytes() != data:
                raise FileExistsError(errno.EEXIST, "holds another program", str(file))
        for file, data in files.items():
            write_whole(file, data)

    def _bytes(self, text: str) -> bytes:
        marked = f"%\n{text}%\n" if self._written.marked else text
        return marked.replace("\n", self._written.line_end).encode(errors="surrogateescape")

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


def _of_calls(work: Work, order: Any, manner: Manner) -> Resume:
    """Return the rest as programs that are called, or raise the reason why there is none."""
    tails = Tails(work.library, work.machine, starts_over=work.whole.stop == "cycles")
    head = work.head(order, manner, data=False)
    if manner.says_motion:
        tails.change = partial(with_motion, head)
    headed = tails.number is not None or work.sign == "%"
    form = f"{work.sign}{{}}" if headed else "RESTART{}"
    name = f"O{tails.number}" if tails.number else _free_name(work.library, form)
    told = work.told(head)
    lines = [*([name] if headed else []), *work.comments(told), *head.lines, *tails.main]
    files = _named(work, {name: "".join(f"{line}\n" for line in lines), **tails.programs})
    library = work.library
    for file, text in files.items():
        library = _with(library, text, None if headed else file)
    if name not in library:
        raise NoTailsError(f"the control does not read {name} as the name of a program")

    def differs() -> str | None:
        return work.differs(head, library, name, variables=True)

    _prove(head, differs())
    return _made(work, files, "calls", told, differs)


def _with(library: Library, text: str, file: str | None) -> Library:
    try:
        return library.with_program(text, name=file)
    except ValueError as error:
        raise NoTailsError(str(error)) from None


def _prove(head: Draft, told: str | None) -> None:
    if told is not None:
        raise NoTailsError("; ".join([*head.lacks, told]))


def _flat(work: Work, order: Any, manner: Manner) -> Resume:
    head = work.head(order, manner, data=True)
    rest = FlatLines(work.machine.core.copy())
    if rest.refusal is not None or not rest.ends:
        raise NoTailsError(rest.refusal[0] if rest.refusal else "the run does not end")
    lines = [*head.lines, *(with_motion(head, rest.lines) if manner.says_motion else rest.lines)]
    if work.whole.stop == "cycles" and lines[-1].strip() == "M99":
        lines[-1] = "M30"
    told = work.told(head)
    comments = work.comments(told)
    name = _free_name(work.library, f"{work.sign}{{}}")
    headed = _is_head(work.library, name)
    text = "".join(f"{line}\n" for line in [*([name] if headed else []), *comments, *lines])
    library = work.library.of_text(text, work.library.control)

    def differs() -> str | None:
        return work.differs(head, library, None, variables=False)

    _prove(head, differs())
    without = f"the rest stands without calls and loops, it sets no variables: {work.why_flat}"
    notes = [without, *told]
    name = name if headed else _free_name(work.library, "RESTART{}")
    return _made(work, _named(work, {name: text}), "flat", notes, differs)


def _made(
    work: Work,
    files: Mapping[str, str],
    form: str,
    notes: Iterable[str],
    differs: Callable[[], str | None],
) -> Resume:
    left_out = any("\0" in text for text in files.values())
    kept = {name: text.replace("\0", "") for name, text in files.items()}
    told = [*notes, *(["bytes of zero in its blocks are left out"] if left_out else [])]
    return Resume(work.state, kept, form, tuple(told), differs, work.written_as())


def _free_name(library: Library, form: str) -> str:
    """Return a name that no program of the memory has."""
    numbers: Iterable[Any] = itertools.chain([""], itertools.count(2))
    if not form.startswith("RESTART"):
        numbers = free_numbers(library)
    return next(name for n in numbers if (name := form.format(n)) not in library)


def _is_head(library: Library, name: str) -> bool:
    """Return whether the control reads the name at the head of a program."""
    alone = library.of_text(f"{name}\nM30\n", library.control)
    return alone.main is not None and alone.main.name == name and alone.run().stop == "end"


def _named(work: Work, programs: Mapping[str, str]) -> dict[str, str]:
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
    given = whole("times", times, 1)
    place = as_place(at, given)
    if isinstance(switches := options.get("block_skip"), Iterable):
        options["block_skip"] = tuple(switches)  # the program runs more than once
    try:
        options["setup"] = given_setup(options)
    except (TypeError, ValueError) as error:
        raise carrying("setup", error) from None
    height = None if safe_height is None else length("safe_height", safe_height)
    groups = _order(order)
    asked = _Asked(library, main, height, groups, dict(options))
    work, made, reasons = asked.at(place)
    if made is not None:
        return made
    pairs = zip(("with", "without"), reasons, strict=True)
    told = "".join(f"\n{form} calls: {reason}" for form, reason in pairs)
    raise refused(
        f"no restart program does the same from here on{work.causes()}{asked.near(work)}{told}",
        work.state.block,
    )


class _Asked:
    """What a restart is asked for, but its place."""

    def __init__(
        self,
        library: Library,
        main: str | int | None,
        height: float | None,
        order: tuple[str, ...] | None,
        options: dict[str, Any],
    ) -> None:
        self._library, self._main, self._height = library, main, height
        self._order, self._options = order, options

    def at(self, place: Any) -> tuple[Work, Resume | None, list[str]]:
        """Return the restart at a place, or the first reasons why none can be written: with calls,
        and without.
        """
        work = Work(self._library, self._main, place, self._height, self._options)
        work = work.begun_at_height(place)
        reasons: dict[Any, list[str]] = {_of_calls: [], _flat: []}
        in_units = work.state.modal.get("units") == work.power_on.get("units")
        for manner in _MANNERS:
            if (
                (manner.units_late and in_units)
                or (manner.mixes_units and not work.has_units())
                or (manner.is_empty and work.state.step > 0)
            ):
                continue
            for form in (_of_calls, _flat):
                try:
                    return work, form(work, self._order, manner), []
                except NoTailsError as error:
                    reasons[form].append(str(error))
                    if form is _of_calls:
                        work.why_flat = str(error).partition("\n")[0]
        return work, None, [each[0] for each in reasons.values()]

    def near(self, work: Work) -> str:
        """Return the nearest places, after and before, at which the run can be started again."""
        count = len(work.whole.steps)
        if count > _MOST_STEPS:
            return ""
        found = []
        for sign in (1, -1):
            steps = (work.state.step + sign * far for far in _FAR)
            places = (work.whole.steps[step] for step in steps if 0 <= step < count)
            place = next((place for place in places if self._works(place)), None)
            found += [] if place is None else [place_text(place)]
        return f"\nit can be started at {' or '.join(found)}" if found else ""

    def _works(self, place: Any) -> bool:
        try:
            return self.at(place)[1] is not None
        except ValueError:
            return False


_MOST_STEPS = 10_000  # of a run in which a place is looked for that works
_FAR = (1, 2, 3, 5, 8, 13)  # steps from the one asked for
# Tried in this order: the plain head first.
_MANNERS = (
    Manner(),
    Manner(bends_first=False),
    Manner(repeats=True),
    Manner(repeats=True, bends_first=False),
    Manner(units_late=True),
    Manner(mixes_units=True),
    Manner(is_empty=True),
    Manner(says_motion=True),
)
