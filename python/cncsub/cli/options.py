"""The common parts of the commands: options, what is made of them, and how output is written."""

from __future__ import annotations

import contextlib
import enum
import inspect
import itertools
import json
import math
import os
import re
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any, TypeVar, get_type_hints

import typer

import cncsub
from cncsub import system
from cncsub.analysis.notes import Note, program_in_its_place, same_blocks
from cncsub.cli.project import PLACES, Project, project_for
from cncsub.controls import names_beginning
from cncsub.escapes import shown
from cncsub.loading import load_with
from cncsub.option_errors import option_of
from cncsub.program import named_like
from cncsub.reports.printing import Console, console_on, stop_text
from cncsub.run_options import RunOptions, stated
from cncsub.sibling_files import with_files_beside
from cncsub.writing import opened

F = TypeVar("F", bound=Callable[..., Any])

MOST_WATCHED = 1000  # variables of one range; the engine takes no more in all


class WrongUseError(Exception):
    """An error that the caller can mend; its text is the line that is printed."""


class Format(enum.StrEnum):
    TEXT = "text"
    JSON = "json"


class FindingFormat(enum.StrEnum):
    TEXT = "text"
    JSON = "json"
    SARIF = "sarif"
    JUNIT = "junit"
    GITHUB = "github"


class RunFormat(enum.StrEnum):
    TEXT = "text"
    JSON = "json"
    CSV = "csv"
    PARQUET = "parquet"


# ---- options ----

Paths = Annotated[
    list[str] | None,  # an empty path is not the current folder
    typer.Argument(
        help="Files and folders: the memory of the control. The first program runs.",
        show_default=False,
    ),
]
ControlName = Annotated[
    str | None,
    typer.Option(
        "-c",
        "--control",
        help="The control; `cncsub controls` lists them.",
        envvar="CNCSUB_CONTROL",
        show_envvar=False,
        autocompletion=names_beginning,
    ),
]
Main = Annotated[str | None, typer.Option(help="The program to run, such as O20.")]
Mdi = Annotated[str | None, typer.Option(help="Run this text as if it were typed in MDI.")]
Set = Annotated[
    list[str] | None,
    typer.Option("--set", help="A variable before the run: 100=23.34.", metavar="N=VALUE"),
]
VariablesFile = Annotated[
    Path | None,
    typer.Option(
        "--variables",
        help="A file of variables before the run: TOML, CSV, or the output of the control;"
        " --set overrides it.",
    ),
]
Param = Annotated[
    list[str] | None,
    typer.Option(help="A parameter of the control: 6050=70, 6001#5=1.", metavar="NAME=VALUE"),
]
Skip = Annotated[
    list[int] | None,
    typer.Option(help="A block-skip switch that is on, 1 to 10.", metavar="N"),
]
External = Annotated[
    Path | None, typer.Option(help="The folder of the external device, from which M198 calls.")
]
Encoding = Annotated[
    str | None,
    typer.Option(help="The encoding of comments and names; it is detected if not given."),
]
Prefer = Annotated[
    list[Path] | None,
    typer.Option(
        "--prefer",
        help="The file to use when several files have a program of the same number.",
        metavar="FILE",
    ),
]
SetupFile = Annotated[
    Path | None, typer.Option("--setup", help="A TOML file with offsets, tools and limits.")
]
InputsFile = Annotated[
    Path | None,
    typer.Option("--inputs", help="A TOML file with signals, answers and a workpiece to probe."),
]
Watch = Annotated[
    list[str] | None,
    typer.Option(
        "--watch", help="Report the changes of these variables: 500, 100-149,500.", metavar="N[-N]"
    ),
]
Output = Annotated[
    Path | None, typer.Option("-o", "--output", help="Write to this file, not to the terminal.")
]


# The options of every command that runs programs, beside the options of a run that have one value.
_SHARED: dict[str, Any] = {
    "set": Set,
    "variables": VariablesFile,
    "param": Param,
    "skip": Skip,
    "external": External,
    "prefer": Prefer,
    "encoding": Encoding,
}
_FILES: dict[str, Any] = {"setup": SetupFile, "inputs": InputsFile}


def _asked() -> Iterator[tuple[str, Any, Any]]:
    """Yield the options of a run that are asked for by their own name, with type and default."""
    types = get_type_hints(RunOptions)
    for name, option in stated().items():
        if option.asked is None:
            continue
        metavar = None if types[name] is bool else "N"
        flag = typer.Option(flag_of(name), help=option.asked, min=option.least, metavar=metavar)
        yield name, Annotated[types[name], flag], option.default


def runs_programs(*without: str, **defaults: Any) -> Callable[[F], F]:
    """Return a decorator that gives a command, after its `main`, the options of every command that
    runs programs. Options in `without`, and those that stand in another place, are left out;
    `defaults` has other defaults.
    """

    def shown(function: F) -> F:
        shared = [
            *((name, kind, None) for name, kind in _SHARED.items()),
            *_asked(),
            *((name, kind, None) for name, kind in _FILES.items()),
        ]
        more = [
            inspect.Parameter(
                name,
                inspect.Parameter.POSITIONAL_OR_KEYWORD,
                default=defaults.get(name, default),
                annotation=kind,
            )
            for name, kind, default in shared
            if name not in without
        ]
        signature = inspect.signature(function, eval_str=True)
        own = [p for p in signature.parameters.values() if p.kind is not p.VAR_KEYWORD]
        names = [p.name for p in own]
        at = names.index("mdi" if "mdi" in names else "main") + 1
        parameters = [*own[:at], *more, *own[at:]]
        function.__signature__ = signature.replace(parameters=parameters)  # type: ignore[attr-defined]
        return function

    return shown


# Options that the command line calls otherwise than Python.
_FLAGS = {
    "block_skip": "--skip",
    "coordinates": "--machine",
    "most": "--points",
    "variables": "--set, --variables",
}


def flag_of(option: str) -> str:
    """Return how the command line writes an option of Python."""
    return _FLAGS.get(option, "--" + option.replace("_", "-"))


@contextlib.contextmanager
def wrong_use() -> Iterator[None]:
    """Make every wrong option a usage error, which names it as the command line does."""
    try:
        yield
    except KeyError as error:
        raise WrongUseError(_by_option(error)) from None
    except OSError as error:
        if error.filename is None or system.at_its_limit(error):
            raise
        raise WrongUseError(told_of(error)) from None
    except (ValueError, TypeError) as error:
        raise WrongUseError(_by_option(error)) from None


@contextlib.contextmanager
def of_extra(extra: str, what: str, *packages: str) -> Iterator[None]:
    """Report as wrong use that something needs one of these packages, which the extra installs."""
    try:
        yield
    except ModuleNotFoundError as error:
        missing = (error.name or "").partition(".")[0]
        if missing not in packages:
            raise
        raise WrongUseError(
            f"{what} needs {missing}, which is not installed: pip install 'cncsub[{extra}]'"
        ) from None


def told_of(error: OSError) -> str:
    """Return what the system says of a file, after the file's name."""
    named = f"{os.fsdecode(error.filename)}: " if error.filename is not None else ""
    return f"{named}{error.strerror or error}"


def _by_option(error: Exception) -> str:
    """Return what an error says. Where it begins with its option, that is written as on the command
    line.
    """
    words = str(error.args[0]) if isinstance(error, KeyError) else str(error)
    option = option_of(error)
    if option is None or not words.startswith(option):
        return words
    return flag_of(option) + words.removeprefix(option)


def run_options(options: Mapping[str, Any], trace: str) -> dict[str, Any]:
    if options["mdi"] is not None and options["main"] is not None:
        raise ValueError("--mdi runs a typed text and --main a program; give only one of them")
    asked: dict[str, Any] = {
        "variables": _variables(options),
        "block_skip": options["skip"] or (),
        "trace": trace,
        **{name: options[name] for name, option in stated().items() if option.asked is not None},
    }
    if watched := watched_numbers(options.get("watch") or ()):
        asked["watch"] = watched
    if options.get("conditions"):
        asked["conditions"] = True
    project = project_for(options.get("paths"))
    if (setup := setup_for(options, project)) is not None:
        asked["setup"] = setup
    if (inputs := options["inputs"] or project.inputs) is not None:
        asked["inputs"] = cncsub.Inputs.from_toml(inputs)
    return asked


def _variables(options: Mapping[str, Any]) -> dict[int, float | None]:
    """Return the variables of the file, overridden by those of `--set`."""
    file = options.get("variables") or project_for(options.get("paths")).variables
    given = {} if file is None else dict(cncsub.read_variables(file))
    return given | dict(_assignment("--set", text, _vacant) for text in options["set"] or ())


def watched_numbers(texts: Iterable[str]) -> list[int]:
    """Return `100-102,500` as numbers, each once."""
    numbers: dict[int, None] = {}
    for text in ",".join(texts).split(",") if texts else ():
        first, dash, last = text.strip().replace("#", "").partition("-")
        try:
            low, high = int(first), int(last if dash else first)
        except ValueError:
            raise ValueError(
                f"--watch must be numbers and ranges such as 500 or 100-149, not {text!r}"
            ) from None
        if high < low:
            raise ValueError(f"--watch {text.strip()}: the last number comes before the first")
        if high - low >= MOST_WATCHED:
            raise ValueError(f"--watch {text.strip()}: at most {MOST_WATCHED:,} variables")
        numbers.update(dict.fromkeys(range(low, high + 1)))
    return list(numbers)


NOT_DONE = 5  # exit status: no room on the disk, in memory, for files, for processes
STATUS = {
    cncsub.Stop.END: 0,
    cncsub.Stop.CYCLES: 0,
    cncsub.Stop.ALARM: 1,
    cncsub.Stop.WAITING: 3,
    cncsub.Stop.LIMIT: 4,
    cncsub.Stop.INTERRUPTED: 130,
}


def whole_run(run: cncsub.Run) -> cncsub.Run:
    """Return the run. Where Ctrl-C broke it off, report where it stood and raise
    `KeyboardInterrupt`.
    """
    if run.stop is cncsub.Stop.INTERRUPTED:
        at = ""
        if len(run.steps):
            last = run.steps[-1]
            block = f"line {last.line}" if last.n is None else f"N{last.n}"
            at = f", at {shown(f'{last.program} {block}')}"
        typer.echo(f"stopped: {stop_text(run)}{at}", err=True)
        raise KeyboardInterrupt
    return run


def status_of(run: cncsub.Run | cncsub.Stream) -> int:
    """Return the exit status of a run; 1 for a stream that was left before its end."""
    return 1 if run.stop is None else STATUS[cncsub.Stop(run.stop)]


_WRITTEN = ("output", "html", "lcov", "cobertura")  # options that name a file to write
_READ = ("setup", "inputs", "variables")  # options that name a file to read beside the programs


def library_of(options: Mapping[str, Any]) -> cncsub.Library:
    library = _read(options)
    written = [Path(path) for name in _WRITTEN if (path := options.get(name)) is not None]
    project = project_for(options.get("paths")) if written else Project()
    read: list[str | Path] = [*library.files, *_files_beside_programs(options, project)]
    external = options.get("external") or project.places.get("external")
    for place, path in enumerate(written):
        _refuse_to_overwrite(path, read, written[:place], external)
    return library


def _files_beside_programs(options: Mapping[str, Any], project: Project) -> list[Path]:
    """Return the files of setup, inputs and variables that the options or the project name, and the
    file of the project itself.
    """
    named = [options.get(name) or project.places.get(name) for name in _READ]
    return [Path(path) for path in (*named, project.file) if path is not None]


def _refuse_to_overwrite(
    path: Path, read: Sequence[str | Path], written: Sequence[Path], external: Path | None
) -> None:
    """Refuse to write over a file that was read, whatever name it goes by, or to write
    one twice.
    """
    real = Path(os.path.realpath(path))
    if str(path) == "-":
        raise ValueError(
            "- cannot be written as a file; without -o the output goes to the standard output"
        )
    if any(real == Path(os.path.realpath(other)) for other in written):
        raise ValueError(f"{path} cannot be written twice; give a different file for each output")
    if not path.exists():
        return
    for other in read:
        if Path(other).exists() and path.samefile(other):
            what = "the program" if str(path) == str(other) else f"{other}, which was read"
            raise ValueError(f"{path} is {what}; give another file for the output")
    if external is not None and real.is_relative_to(os.path.realpath(external)):
        raise ValueError(f"{path} is a file of the external device; give another file")


def _read(options: Mapping[str, Any]) -> cncsub.Library:
    project = project_for(options.get("paths"))
    places: dict[str, Any] = {
        "control": control_for(options, project),
        "external": options["external"] or project.external,
    }
    paths = options["paths"] or project.folders
    if options.get("prefer") and (not paths or paths == ["-"]):
        raise ValueError("--prefer chooses between files: give the files or folders to read")
    if "-" in paths and len(paths) > 1:
        raise ValueError(
            "- is the standard input, which is read alone: leave out either - or the files"
        )
    if paths == ["-"]:
        text = sys.stdin.buffer.read()
        return cncsub.loads(text, encoding=options["encoding"], **places)
    if paths:
        prefer = options.get("prefer") or ()

        def load(named: Sequence[str], siblings: Sequence[str] = ()) -> cncsub.Library:
            wanted = {"encoding": options["encoding"], "prefer": prefer, **places}
            return load_with(named, siblings, **wanted)

        _refuse_words_of_mdi(options["paths"] or (), options["mdi"])
        return with_files_beside(paths[0], load) if _is_one_file(paths) else load(paths)
    if options["mdi"] is None:
        raise ValueError("which program? Give a file, a folder or --mdi")
    return cncsub.loads("", **places)


def _refuse_words_of_mdi(paths: Sequence[str], mdi: str | None) -> None:
    """Refuse words split off by the shell: it makes a text and a file of `--mdi G65 P9100`."""
    word = next((p for p in paths if re.fullmatch(r"[A-Z][-+.\d]+", p, re.I)), None)
    if mdi is not None and word is not None and not Path(word).exists():
        whole = f'--mdi "{mdi} {word}"'
        raise ValueError(f"{word}: no such file; put quotes around a text with blanks: {whole}")


def control_for(options: Mapping[str, Any], project: Project) -> cncsub.Control:
    """Return the control of the options or the project, with the parameters of both."""
    named = options["control"] or project.control
    control = control_named(named, project)
    if named == project.control and project.parameters:
        control = control.with_parameters(dict(project.parameters))
    if options["param"]:
        pairs = (_named_value("--param", text) for text in options["param"])
        control = control.with_parameters(dict(pairs))
    return control


def setup_for(options: Mapping[str, Any], project: Project) -> cncsub.Setup | None:
    """Return the setup of the options or the project, where one of them names its file."""
    file = options["setup"] or project.setup
    return None if file is None else cncsub.Setup.from_toml(file)


def _is_one_file(paths: Sequence[str]) -> bool:
    return len(paths) == 1 and Path(paths[0]).is_file()


def files_beside(options: Mapping[str, Any], library: cncsub.Library) -> list[str]:
    """Return the files that were read because the named file calls their programs."""
    return list(library.files[1:]) if _is_one_file(options["paths"] or ()) else []


def notes_on(options: Mapping[str, Any], library: cncsub.Library) -> list[Note]:
    """Return the notes on a memory, except on files that the options name themselves."""
    project = project_for(options.get("paths"))
    known = {os.path.realpath(file) for file in _files_beside_programs(options, project)}
    siblings = [
        Note("beside", "also read, because a call names its program", file)
        for file in files_beside(options, library)
    ]
    return [*defaulted(options), *outside(options, project), *siblings] + [
        note
        for note in library.notes
        if note.kind != "left-out" or os.path.realpath(note.file) not in known
    ]


def defaulted(options: Mapping[str, Any]) -> Iterator[Note]:
    """Yield a note where the control is the project's, because no option named one."""
    project = project_for(options.get("paths"))
    if options["control"] is None and project.control is not None:
        told = f"the control is {project.control}, from the project file"
        yield Note("defaulted", told, str(project.file))


def outside(options: Mapping[str, Any], project: Project) -> Iterator[Note]:
    """Yield a note for each file and folder that the project names outside its own folder."""
    places = [
        (name, place)
        for name in PLACES
        if name in options and options[name] is None and (place := project.outside(name))
    ]
    if not options.get("paths"):
        places += [("folders", place) for place in project.programs_outside]
    for name, place in places:
        told = f"the project file gives it as {name}, and it is outside the folder of the project"
        yield Note("outside", told, str(place))


def idle_entries(
    options: Mapping[str, Any], project: Project, libraries: Sequence[cncsub.Library]
) -> Iterator[Note]:
    """Yield a note for each entry of the project that is the name of none of its programs."""
    for pattern in () if options.get("paths") else project.entry:
        if not any(named_like(library.code, [pattern]) for library in libraries):
            yield Note(
                "no-effect", "no program has such a name", f"entry {pattern} of {project.file}"
            )


def told_idle(
    library: cncsub.Library, asked: Mapping[str, Any], typed: cncsub.Program | None = None
) -> list[Note]:
    """Report and return the options that no block asks for; `typed` is what was typed in MDI."""
    from cncsub.reports.hints import without_effect

    idle = list(without_effect(library, asked, typed))
    tell_all(idle)
    return idle


def told_lengths(run: cncsub.Run, asked: Mapping[str, Any]) -> list[Note]:
    """Report and return what is told of lengths without a decimal point."""
    from cncsub.reports.hints import lengths_without_point

    notes = list(lengths_without_point(run, asked))
    tell_all(notes)
    return notes


def typed_in(run: cncsub.Run) -> cncsub.Program:
    """Return what was typed in MDI, as a program: the last one of the memory."""
    code = run.core.code
    return cncsub.Program(code.program(len(code) - 1), len(code) - 1)


MOST_NOTES = 20


def memory_of(
    options: Mapping[str, Any], tell: Callable[[Sequence[Note]], None] | None = None
) -> cncsub.Library:
    """Return the library as `library_of` does, for a run. The notes are reported on the error
    stream, or by `tell`. Of two different programs of one number one has to be chosen, because a
    control's memory holds only one.
    """
    library = library_of(options)
    chosen = {os.path.realpath(path) for path in options.get("prefer") or ()}
    for program in library.duplicates:
        counts = program_in_its_place(library, program)
        if os.path.realpath(counts.file) not in chosen and not same_blocks(program, counts):
            places = f"{counts.file}:{counts.line} and {program.file}:{program.line}"
            cure = _cure_of_two(library, program, counts)
            raise ValueError(f"{counts.name} exists twice with different blocks: {places}; {cure}")
    notes = notes_on(options, library)
    if notes:
        (tell or tell_all)(notes)
    return library


def _cure_of_two(library: cncsub.Library, program: cncsub.Program, counts: cncsub.Program) -> str:
    """Return what makes one of two programs of one name the only one."""
    from cncsub.reports.hints import other_reading

    if program.file != counts.file:
        return f"choose one with --prefer {counts.file}, or leave a file out"
    return other_reading(library, program.file) or "remove one of them"


def tell_all(notes: Sequence[Note]) -> None:
    """Report the first of many notes on the error stream."""
    for note in notes[:MOST_NOTES]:
        typer.echo(f"note: {shown(str(note))}", err=True)
    if (left := len(notes) - MOST_NOTES) > 0:
        typer.echo(f"note: ... and {left:,} more", err=True)


def tell_dropped(dropped: int, warnings: Iterable[str | None] = ()) -> None:
    """Report on the error stream that words were dropped, for commands that show none of them, and
    once what does not start because of that.
    """
    if dropped:
        words = f"{dropped:,} word{'' if dropped == 1 else 's'}"
        typer.echo(f"note: the control dropped {words}; cncsub run and check show which", err=True)
    for warning in sorted({each for each in warnings if each is not None}):
        typer.echo(f"warning: an M code was dropped: {warning}", err=True)


def tell_hints(hints: Iterable[str]) -> None:
    """Report on the error stream what leads on from an alarm."""
    for hint in hints:
        first, *more = hint.split("\n")
        typer.echo(f"hint: {shown(first)}", err=True)
        for line in more:  # of a file that is suggested
            typer.echo(f"      {shown(line)}", err=True)


def control_named(name: str | None, project: Project | None = None) -> cncsub.Control:
    """Return the control of a name, which may be the project's: of the current folder, where no
    project is given.
    """
    if name is None:
        raise WrongUseError(
            f"which control? Give -c and one of {', '.join(cncsub.controls)};"
            " CNCSUB_CONTROL or a cncsub.toml in the folder of the programs names it for all"
            " commands"
        )
    try:
        return (project or project_for(None)).control_named(name)
    except ValueError as error:
        raise WrongUseError(str(error)) from None


def _named_value(option: str, text: str) -> tuple[str, float]:
    name, equals, value = text.partition("=")
    try:
        if not equals or not name.strip():
            raise ValueError
        return name.strip(), float(value)
    except ValueError:
        raise ValueError(f"{option} must be NAME=VALUE, such as 6050=70, not {text!r}") from None


def _vacant(value: str) -> float | None:
    if value.strip().lower() in ("vacant", "none", "#0"):
        return None
    if not math.isfinite(number := float(value)):
        raise ValueError
    return number


def _assignment(
    option: str, text: str, read: Callable[[str], float | None]
) -> tuple[int, float | None]:
    number, _, value = text.strip().removeprefix("#").partition("=")
    try:
        return int(number), read(value)
    except ValueError:
        raise ValueError(
            f"{option} must be NUMBER=VALUE, such as 100=23.34 or 100=vacant, not {text!r}"
        ) from None


# ---- writing ----


def _escaped(found: re.Match[str]) -> str:
    """Return a character as JSON writes it in plain ASCII, where it cannot be seen."""
    return found[0] if found[0].isprintable() else json.dumps(found[0]).strip('"')


def write_text(output: Path | None, write: Callable[[Console], None]) -> None:
    if output is None:
        write(console_on(sys.stdout))
        return
    with opened(output, "w") as file:
        write(console_on(file))


def write_code(pieces: Iterable[str]) -> None:
    """Write programs, or their changes, as they are; on a terminal without what would move it."""
    if not sys.stdout.isatty():
        for piece in pieces:
            typer.echo(piece.encode(errors="surrogateescape"), nl=False)
        return
    for line in "".join(pieces).splitlines():
        typer.echo(shown(line))


def write_json(output: Path | None, facts: object) -> None:
    plain = output is None and not system.takes_any_text(sys.stdout)
    pieces = json.JSONEncoder(ensure_ascii=plain, indent=2, allow_nan=False).iterencode(facts)
    with contextlib.nullcontext(sys.stdout) if output is None else opened(output, "w") as file:
        while piece := "".join(itertools.islice(pieces, 10_000)):
            # Characters that a terminal would obey are escaped; all beyond ASCII is in a string.
            file.write(_BEYOND_ASCII.sub(_escaped, piece))
        file.write("\n")


_BEYOND_ASCII = re.compile(r"[^\x20-\x7e\n]")
