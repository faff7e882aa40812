"""The options of the commands, as they are declared and as they are meant."""

from __future__ import annotations

import contextlib
import enum
import inspect
import math
import os
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from typing import Annotated, Any, TypeVar, get_type_hints

import typer

import cncsub
from cncsub import system
from cncsub.cli.project import Project, project_for
from cncsub.controls import alias_named, names_beginning
from cncsub.inputs import by_number, is_name
from cncsub.option_errors import option_of
from cncsub.run_options import RunOptions, stated
from cncsub.search_path import with_search

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
    typer.Option(
        "--set",
        help="A variable before the run, as programs write it: 100=23.34, R5=3.",
        metavar="N=VALUE",
    ),
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
    typer.Option(
        help="A block-skip switch that is on, 1 to 10: 1 skips /, 2 skips /2 (of a SINUMERIK /1).",
        metavar="N",
    ),
]
External = Annotated[
    Path | None, typer.Option(help="The folder of the external device, from which M198 calls.")
]
SearchPath = Annotated[
    list[str] | None,
    typer.Option(
        "--search",
        help="A folder of the control's search path by another name on the disk: CUS.DIR=cycles.",
        metavar="FOLDER=PATH",
    ),
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
        "--watch",
        help="Report the changes of these variables: 500, 100-149,500, R5.",
        metavar="N[-N]",
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
    "search": SearchPath,
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


def _variables(options: Mapping[str, Any]) -> dict[int | str, float | None]:
    """Return the variables of the file, overridden by those of `--set`."""
    project = project_for(options.get("paths"))
    file = options.get("variables") or project.variables
    given: dict[int | str, float | None] = {}
    if file is not None:
        given |= cncsub.read_variables(file)
    named = dict(_assignment("--set", text, _vacant) for text in options["set"] or ())
    if not given or all(isinstance(name, int) for name in (*given, *named)):
        return given | named
    control = project.control_named(str(options["control"] or project.control))
    numbered = by_number("--variables", control, given) | by_number("--set", control, named)
    return dict(numbered.items())


def watched_numbers(texts: Iterable[str]) -> list[int | str]:
    """Return `100-102,500,R5` as numbers and names, each once."""
    numbers: dict[int | str, None] = {}
    for text in _parted(",".join(texts)) if texts else ():
        if is_name(text) and not re.fullmatch(r"[#\d\s-]*", text):
            numbers[text.strip()] = None
            continue
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


def _parted(text: str) -> list[str]:
    """Return what stands between commas, but for those in the brackets of a name."""
    return re.split(r",(?![^\[]*\])", text)


def control_for(options: Mapping[str, Any], project: Project) -> cncsub.Control:
    """Return the control of the options or the project, with the parameters of both."""
    named = options["control"] or project.control
    control = project.configured(control_named(named, project), named)
    if options["param"]:
        pairs = (_named_value("--param", text) for text in options["param"])
        control = control.with_parameters(dict(pairs))
    return with_search(control, search_of(options))


def search_of(options: Mapping[str, Any]) -> dict[str, str]:
    """Return the folders of the search path that the options name, with those on the disk."""
    pairs = [text.partition("=") for text in options.get("search") or ()]
    named: dict[str, str] = {}
    for folder, _, path in pairs:
        if not folder or not path:
            raise ValueError(f"--search must be FOLDER=PATH such as CUS.DIR=cycles, not {folder!r}")
        if folder.strip() in named:
            raise ValueError(f"--search {folder} is given twice; give it one folder")
        named[folder.strip()] = path.strip()
    return named


def setup_for(options: Mapping[str, Any], project: Project) -> cncsub.Setup | None:
    """Return the setup of the options or the project, where one of them names its file."""
    file = options["setup"] or project.setup
    return None if file is None else cncsub.Setup.from_toml(file)


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
        found = (project or project_for(None)).control_named(name)
    except ValueError as error:
        raise WrongUseError(str(error)) from None
    alias = alias_named(name)
    if alias is not None and found.name == alias.control:
        told = f"{alias.name} is taken as {found.name}, {found.title} [{alias.source}]"
        typer.echo(f"note: {told}", err=True)
    return found


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
) -> tuple[int | str, float | None]:
    name, _, value = text.strip().partition("=")
    number = name.removeprefix("#")
    try:
        named = is_name(name) and not number.strip().isdecimal()
        return name.strip() if named else int(number), read(value)
    except ValueError:
        raise ValueError(
            f"{option} must be NUMBER=VALUE, such as 100=23.34 or 100=vacant, or R5=3 as"
            f" programs write it, not {text!r}"
        ) from None
