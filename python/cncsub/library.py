"""The programs that a control holds in its memory, and their runs."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any, Unpack

from cncsub import _core
from cncsub._core import Control
from cncsub.collectors import tell
from cncsub.controls import Named, control_of
from cncsub.files import TEXT, CoreFile, clean, cut, shown_and_stem, text_pieces
from cncsub.machine import Machine
from cncsub.program import Program, find_program, named_like, place_of_program
from cncsub.run import Run
from cncsub.run_options import (
    FlattenOptions,
    MdiOptions,
    RunOptions,
    check_names,
    machine_with,
    takes,
    whole,
)
from cncsub.setup import Setup, setup_of
from cncsub.stream import Stream

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

    from cncsub.analysis.flattening import Flat
    from cncsub.analysis.notes import Note
    from cncsub.checking import Finding, Flow
    from cncsub.references import CallGraph
    from cncsub.resume import Resume
    from cncsub.resume.place import Place

# A file of the memory: its name, its stem, its text in UTF-8, and whether it is external.
_Source = tuple[str, str, bytes, bool]


class Library(Mapping[str, Program]):
    """The memory of a control: program name to `Program`, in the order of the files.

    A program is found by any way to write its name: `library["O0002"]`, `library["O2"]` and
    `library[2]` are the same object. Of several programs with one name the control calls one; the
    others are in `.duplicates`.

    >>> import cncsub
    >>> text = "O1\\nN10 M98 P2\\nN20 M30\\nO0002\\nN30 M99\\n"
    >>> library = cncsub.loads(text, control="fanuc-0i-f")
    >>> list(library)
    ['O1', 'O0002']
    >>> library["O2"] is library[2]
    True
    >>> library.run().stop
    <Stop.END: 'end'>
    """

    def __init__(
        self,
        code: _core.Code,
        files: Sequence[str],
        skipped: Sequence[tuple[str, str]] = (),
        first: str | None = None,
    ) -> None:
        self.code = code
        self._first = first  # the name of the first program, where files were preferred to it
        self._files = tuple(files)
        self.left_out = tuple(skipped)
        self._made: dict[int, Program] = {}  # made when asked for: a memory may hold millions

    def _program(self, index: int) -> Program:
        made = self._made.get(index)
        return made or self._made.setdefault(index, Program(self.code.program(index), index))

    @cached_property
    def _names(self) -> list[str]:
        return self.code.names()

    # The memory.

    def __getitem__(self, name: str | int) -> Program:
        return self._program(self._find(name))

    def __contains__(self, name: object) -> bool:
        try:
            return find_program(self.code, name) >= 0
        except TypeError:
            return False

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)

    def __repr__(self) -> str:
        names = ", ".join(self._names[:8]) + (", ..." if len(self) > 8 else "")
        count = f"{len(self)} program{'s' if len(self) != 1 else ''}"
        return f"<Library of {self.control.name}, {count}: {names}>"

    def __reduce__(self) -> tuple[Any, ...]:
        # A library travels as its texts and is read again where it arrives.
        sources, device = self.code.sources, self.code.external_device
        return read_again, (
            self.control,
            sources,
            device,
            self._files,
            self.left_out,
            self._first,
            self.code.general_only,
        )

    def __copy__(self) -> Library:
        return self  # a library never changes

    def __deepcopy__(self, memo: object) -> Library:
        return self

    def _repr_html_(self) -> str:
        from cncsub.notebook import library_html

        return library_html(self)

    def _find(self, name: object) -> int:
        try:
            return place_of_program(self.code, name)
        except TypeError as error:
            raise KeyError(str(error)) from None

    @property
    def control(self) -> Control:
        """The control whose memory this is."""
        return self.code.control

    @property
    def main(self) -> Program | None:
        """The program that runs when none is given: the first, or on a SINUMERIK the first that is
        named as a main program (.MPF). `None` if there is no program.
        """
        first = self.code.main if self._first is None else self._find(self._first)
        return None if first is None else self._program(first)

    @property
    def files(self) -> tuple[str, ...]:
        """The files of the memory, in the order they were read."""
        return self._files

    @property
    def skipped(self) -> tuple[tuple[str, str], ...]:
        """What was left out of the folders and of the files: path and reason.

        >>> import cncsub
        >>> text = "PART 12\\n%\\nO1\\nM30\\n%\\n"
        >>> cncsub.loads(text, control="fanuc-0i-f", name="part.nc").skipped
        (('part.nc', 'the text before its first %: 1 line'),)
        """
        leaders = (
            (name, f"the text before its first %: {lines} line{'s' if lines != 1 else ''}")
            for name, lines in self.code.leaders
        )
        return (*self.left_out, *leaders)

    @property
    def external(self) -> Mapping[str, Program]:
        """The programs on the external device, by name."""
        places = self.code.places(external=True)
        programs = [self._program(place) for place in places]
        return Named("external program", lambda: {p.name: p for p in programs})

    @property
    def duplicates(self) -> tuple[Program, ...]:
        """Programs that the control never calls, because it uses another one of the same name."""
        return tuple(self._program(index) for index in self.code.duplicates)

    @cached_property
    def notes(self) -> tuple[Note, ...]:
        """The notes on this memory: programs that the control does not use because of another one
        of the same name, a first program without a head, what was left out. See `Note`.

        >>> import cncsub
        >>> text = "O1\\nM98 P2\\nM30\\nO2\\nM99\\nO2\\nG4 X1.\\nM99\\n"
        >>> library = cncsub.loads(text, control="fanuc-0i-f")
        >>> print(library.notes[0])
        <text>:6: this O2 is never called: O2 at <text>:4 counts, and they differ
        """
        from cncsub.analysis.notes import notes_of

        return tuple(notes_of(self))

    @classmethod
    def of_text(cls, text: str, control: Control) -> Library:
        """Return one text as the memory of a control, as `loads` reads it."""
        files: list[CoreFile] = [(TEXT, "", cut(text), False)]
        return cls(_core.compile(control, files, False), [TEXT])

    def read_for(self, control: str | Control) -> Library:
        """Return the same texts, read again as the memory of another control.

        >>> import cncsub
        >>> cncsub.loads("O1\\nM30\\n", control="fanuc-0i-f").read_for("gsk-988ta").control.name
        'gsk-988ta'
        """
        known = control_of(control)
        return self._read_again(known, self.code.sources, self._files, self._first)

    def with_program(self, text: str | bytes, *, name: str | None = None) -> Library:
        """Return this memory with one program in place of the one of its name, or added where there
        is none. Every other program stays as it is, with its file and its lines, and so do the
        control, the external device and the main program.

        `text` is one program. `name` is what its file would be called; its stem names a program
        without a name of its own. Raises `ValueError` for a text of no program or of several.

        >>> import cncsub
        >>> job = {"O1.nc": "O1\\nM98 P9000\\nM30\\n", "O9000.nc": "O9000\\n#500=1\\nM99\\n"}
        >>> library = cncsub.loads(job, control="fanuc-0i-f")
        >>> stub = library.with_program("O9000\\n#500=2\\nM99\\n")
        >>> library.run().variables[500], stub.run().variables[500]
        (1.0, 2.0)
        >>> stub.files
        ('O1.nc', '<text>')
        """
        shown, stem = shown_and_stem(name)
        file: CoreFile = (shown, stem, text_pieces(text), False)
        new = _core.compile(self.control, [file], False)
        program = _one_program(new, named=bool(stem))
        sources, files = list(self.code.sources), list(self._files)
        place = find_program(self.code, program.name)
        at = sum(not outside for *_, outside in sources)  # after the others of the memory
        if place >= 0:
            at = self._taken_out(self.code.program(place), sources, files)
        sources.insert(at, new.sources[0])
        files.insert(min(at, len(files)), shown)
        main = self.main
        first = None if main is None else main.name
        return self._read_again(self.control, sources, files, first)

    def _taken_out(self, old: _core.ProgramData, sources: list[_Source], files: list[str]) -> int:
        """Take a program out of the files, and return where its file stood. In a file that holds
        others too, blanks stand in its place, so that each of those keeps its lines.
        """
        if old.inside:
            raise ValueError(f"{old.name} is a part of {old.file}: replace that program as a whole")
        at, begin, end = old.span
        name, stem, text, outside = sources[at]
        others = (self.code.program(place) for place in range(len(self.code)))
        if all(each.span == old.span or each.span[0] != at for each in others):
            del sources[at]
            files.remove(name)
            return at
        blank = bytes(letter if letter in b"\r\n" else 0x20 for letter in text[begin:end])
        sources[at] = (name, stem, text[:begin] + blank + text[end:], outside)
        return at

    def with_texts(
        self, control: Control, texts: Mapping[str, str], renamed: Mapping[str, str] | None = None
    ) -> Library:
        """Return the memory of another control with other texts in its files. `renamed`: files with
        other names, old to new.
        """
        called = {old: shown_and_stem(new) for old, new in (renamed or {}).items()}
        sources = [
            (
                *called.get(n, (n, stem)),
                data if outside or n not in texts else texts[n].encode(errors="surrogateescape"),
                outside,
            )
            for n, stem, data, outside in self.code.sources
        ]
        files = [called[name][0] if name in called else name for name in self._files]
        return self._read_again(control, sources, files, self._first)

    def _read_again(
        self, control: Control, sources: Sequence[_Source], files: Sequence[str], first: str | None
    ) -> Library:
        return read_again(
            control,
            sources,
            self.code.external_device,
            files,
            self.left_out,
            first,
            self.code.general_only,
        )

    def call_graph(self, *, entry: Iterable[str] = ()) -> CallGraph:
        """Return the calls between programs, found without a run: see `CallGraph`. `entry` is as
        for `check`.
        """
        from cncsub.references import call_graph  # not imported before it is asked for

        main = self.main
        starts = [] if main is None else [main.index]
        return call_graph(self.code, [*starts, *named_like(self.code, entry)])

    def plot(self, *, title: str | None = None, entry: Iterable[str] = ()) -> Figure:
        """Draw the call graph as a figure of plotly (`cncsub[plot]`): a point for each program, the
        main program on the left, an arrow for the calls from one to another; missing programs and
        computed names are circles. Of a large library 250 programs are drawn, and the picture says
        so. `entry` is as for `check`. Raises `ImportError` without plotly.

        >>> import cncsub
        >>> text = "O1\\nN10 M98 P2\\nM30\\nO2\\nM98 P9\\nM99\\n"
        >>> library = cncsub.loads(text, control="fanuc-0i-f")
        >>> [trace.name for trace in library.plot().data if trace.name]
        ['main program', 'called', 'missing']
        """
        from cncsub.plot.graph import graph_figure

        return graph_figure(self, title=title, entry=entry)

    @cached_property
    def _flows(self) -> _core.Flows:
        return _core.flows(self.code)

    def flow(self, program: str | int) -> Flow:
        """Return the flow graph of a program, found without a run: see `Flow`."""
        index = self._find(program)
        data = self.code.program(index)
        from cncsub.checking import flow_of

        return flow_of(self._flows, data, data.blocks)

    def check(
        self,
        main: str | int | None = None,
        rules: Iterable[str] | None = None,
        *,
        setup: Setup | Mapping[str, Any] | None = None,
        entry: Iterable[str] = (),
    ) -> list[Finding]:
        """Return what the control would refuse or what will surprise, in any block, reached or not,
        without a run: see `Finding`; `cncsub.checking.RULES` lists the rules.

        `main`: the program that is run first, the first one without it. `rules`: the numbers
        (`CS201`), slugs or beginnings of numbers (`CS2`) of the rules to ask, all without it.
        `setup`: tells the kind of machine. `entry`: the programs that something outside of the
        memory calls, such as a machine or an operator, by their names or by patterns (`O90*`): they
        are not reported as never called, and may be given arguments. A comment
        `(cncsub: ignore CS201)` switches a rule off for its line.

        Raises `KeyError` for an unknown `main` or rule.

        >>> import cncsub
        >>> library = cncsub.loads("O1\\nN10 M98 P9\\nN20 M30\\n", control="fanuc-0i-f")
        >>> [(f.rule, f.name, f.n, f.alarm.number) for f in library.check()]
        [('CS201', 'program-missing', 10, 'PS0076')]
        >>> macros = cncsub.loads("O1\\nM30\\nO9010\\n#100=#1\\nM99\\n", control="fanuc-0i-f")
        >>> [f.rule for f in macros.check()], macros.check(entry=["O90*"])
        (['CS302'], [])
        """
        program = self.main
        first = self._find(main) if main is not None else None if program is None else program.index
        kind = (setup_of(setup) or {}).get("machine")
        from cncsub.checking import check

        entries = named_like(self.code, entry)
        return check(self.code, -1 if first is None else first, rules, kind, entries)

    @takes(FlattenOptions)
    def flatten(
        self,
        main: str | int | None = None,
        *,
        control: str | Control | None = None,
        comments: bool = False,
        **options: Unpack[FlattenOptions],
    ) -> Flat:
        """Write what `main` executes as one program without calls, jumps and loops that does the
        same: see `cncsub.flatten`.

        >>> import cncsub
        >>> text = "O1\\nN10 M98 P2 L2\\nN20 M30\\nO2\\nN30 G91 G0 X5.\\nN40 M99\\n"
        >>> print(cncsub.loads(text, control="fanuc-0i-f").flatten().text, end="")
        O1
        G91 G0 X5.
        G91 G0 X5.
        M30
        """
        from cncsub.analysis.flattening import (
            flatten,  # it runs libraries, and reads what it has written
        )

        return flatten(self, main, control=control, comments=comments, **options)

    @takes(FlattenOptions)
    def resume(
        self,
        main: str | int | None = None,
        *,
        at: Place,
        times: int = 1,
        safe_height: float | None = None,
        order: Iterable[str] | None = None,
        **options: Unpack[FlattenOptions],
    ) -> Resume:
        """Start a run of `main` again in the middle: return the state there, and a restart program
        for the control that goes on from it. See `Resume`.

        `at`: the block that comes next, a `Block` or a place as for a breakpoint (`"O2:N30"`,
        `"job.nc:12"`), `times` the so manieth time that the run comes to it; the number of a move;
        `"T3"`, the block that calls a tool; or a place in space (`"X10 Y5 Z-2"`, or a mapping; work
        coordinates, mm), the block whose move comes nearest. `safe_height`: the Z (work
        coordinates, mm) to which the head goes first, the highest of the run that is known without
        it: heights in other offsets only where the setup gives the offsets. `order`:
        the axes in the order in which the head goes to the place, one block each, such as
        `("XY", "Z")`. `options`: those of `run`.

        The text is proved: it is run on the control, and what it does after its head is compared
        with the whole run. Raises `ResumeError`, a `ValueError` with the reason and the block,
        where no restart program does the same, and what `run` and `machine.run` raise.

        >>> import cncsub
        >>> text = "O1\\nN10 G0 X0 Z5.\\nN20 M98 P2 L3\\nN30 M30\\nO2\\nN40 G91 X5.\\nN50 M99\\n"
        >>> library = cncsub.loads(text, control="fanuc-0i-f")
        >>> resume = library.resume(at="O2:N40", times=2)
        >>> resume.state.stack
        (<Frame O2 called from O1 N20 (M98, pass 2 of 3)>,)
        >>> list(resume.files)
        ['O9001.nc', 'O9002.nc']
        """
        from cncsub.resume import resume  # it runs libraries

        return resume(
            self,
            main,
            at=at,
            times=times,
            safe_height=safe_height,
            order=order,
            **options,
        )

    # Running.

    @takes(RunOptions, told=True)
    def run(self, main: str | int | None = None, **options: Unpack[RunOptions]) -> Run:
        """Execute a program as the control would, and return what it did.

        `main`: name or number of the program, the first one without it. `options`: those of
        `RunOptions`, by name.

        Raises `KeyError` for an unknown `main`, `ValueError` and `TypeError` for other wrong
        arguments, which carry the name of the option as `.option`. Whatever is wrong with a program
        is never raised: it is the `alarm` of the `Run`.
        """
        check_names("run", options)
        return _finished(self.begin(main, **options))

    @takes(MdiOptions)
    def mdi(self, text: str, **options: Unpack[MdiOptions]) -> Run:
        """Execute a text typed in MDI, with the memory as it is; `options` are those of `run` but
        `main` and `mode`.

        >>> import cncsub
        >>> library = cncsub.loads("O10\\nN10 M99\\n", control="fanuc-0i-f")
        >>> library.mdi("M98 P10").steps.n.tolist()
        [-1, 10]
        """
        if not isinstance(text, str):
            raise TypeError(f"mdi must be the text that was typed, not {type(text).__name__}")
        for name in ("main", "mode"):
            if name in options:
                raise TypeError(f"mdi runs the text that was typed and has no {name}; run has it")
        check_names("mdi", options)
        return _finished(machine_with(self.code.with_mdi(clean(text)), -1, **options, mode="mdi"))

    @takes(RunOptions)
    def machine(self, main: str | int | None = None, **options: Unpack[RunOptions]) -> Machine:
        """Return the engine at the head of a program, to be run step by step; `options` are those
        of `run`.
        """
        check_names("machine", options)
        if options.get("trace") in ("none", "calls"):
            options["trace"] = "blocks"  # a step is a row of the table of steps
        return Machine(self.begin(main, **options))

    @takes(RunOptions)
    def stream(
        self, main: str | int | None = None, *, rows: int = 65536, **options: Unpack[RunOptions]
    ) -> Stream:
        """Execute a program and hand over what it does while it runs, in parts of `rows` blocks: an
        iterator of `Part`, each with the `steps`, `calls`, `moves` and `watch` of its stretch.
        However long the run is, memory holds one part: set `max_blocks` to what the run may take.
        `options` are those of `run`.

        >>> import cncsub
        >>> library = cncsub.loads("O1\\nN10 G91 G1 X1. F100\\nN20 M99\\n", control="fanuc-0i-f")
        >>> sum(part.moves.total_length for part in library.stream(max_cycles=100_000))
        100000.0
        """
        check_names("stream", options)
        trace = options.get("trace", "moves")
        return Stream(self.begin(main, **options), whole("rows", rows, 1), trace)

    @takes(RunOptions)
    def begin(self, main: str | int | None, **options: Unpack[RunOptions]) -> _core.Machine:
        """Return the engine at the head of a program; what it hands out is not public."""
        if main is not None:
            return machine_with(self.code, self._find(main), **options)
        program = self.main
        if program is None:
            # Without a program an empty one runs: what it does is the control's business.
            return machine_with(self.code.with_mdi(""), -1, **options)
        return machine_with(self.code, program.index, **options)


def read_again(
    control: Control,
    sources: Sequence[_Source],
    external_device: bool,
    files: Sequence[str],
    skipped: Sequence[tuple[str, str]],
    first: str | None = None,
    general_only: bool = False,
) -> Library:
    rows: list[CoreFile] = [(name, stem, [text], outside) for name, stem, text, outside in sources]
    code = _core.compile(control, rows, external_device, general_only=general_only)
    known = first is not None and find_program(code, first) >= 0
    return Library(code, files, skipped, first if known else None)


def _one_program(code: _core.Code, *, named: bool) -> _core.ProgramData:
    """Return the only program of a text, which has a name of its own or that of its file."""
    programs = [code.program(place) for place in range(len(code))]
    whole = [program for program in programs if not program.inside and not program.system]
    if len(whole) > 1:
        names = ", ".join(program.name for program in whole)
        raise ValueError(f"with_program needs one program; this text has {names}")
    if not whole or not (named or whole[0].has_head):
        raise ValueError(
            "with_program needs a program with a name: begin it with O1000, or give name="
        )
    return whole[0]


def _finished(core: _core.Machine) -> Run:
    core.run()
    run = Run(core)
    tell(core.trace, core.code)
    return run
