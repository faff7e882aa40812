"""The command line: `cncsub run`, `tree`, `compare`, `diff`, `flatten`, `controls`, `explain`.

Exit status: 0 where the program ran to its end (or used up its cycles) and where what is compared
is the same, 1 for an alarm and for a difference, 2 for wrong
use, which is told in one line, 3 where the run waits for an input nobody gave, 4 at a limit, 130
for Ctrl-C.
"""

from __future__ import annotations

import contextlib
import enum
import json
import os
import re
import sys
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import IO, Annotated, Any

import typer
import typer.core

import cncsub
from cncsub.controls import did_you_mean
from cncsub.facts import (
    comparison_facts,
    control_facts,
    explanations,
    run_facts,
    tree_facts,
    unknown_alarm,
)
from cncsub.printing import (
    Console,
    console_on,
    print_control,
    print_explanations,
    print_pairs,
    print_run,
    print_stop,
    print_tree,
    shown,
)
from cncsub.tables import records


class WrongUseError(Exception):
    """What the caller can mend; its text is the line that is printed."""


class OneLineGroup(typer.core.TyperGroup):
    """Wrong use is one line on the error stream and exit status 2, never a traceback."""

    def main(self, *args: Any, **options: Any) -> Any:
        options["standalone_mode"] = False
        try:
            status = super().main(*args, **options)
            sys.stdout.flush()
        except (typer.Abort, KeyboardInterrupt):
            sys.exit(130)
        except BrokenPipeError:
            # Whoever read the output has enough; nothing is left to write at the end.
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
            sys.exit(1)
        except Exception as error:
            typer.echo(f"cncsub: {shown(_one_line(error))}", err=True)
            sys.exit(2)
        sys.exit(status if isinstance(status, int) else 0)


def _one_line(error: Exception) -> str:
    """The words for wrong use; any other exception goes on."""
    # What typer finds wrong with a command line says so by this method, whatever its class is.
    words = getattr(error, "format_message", None)
    if words is None and not isinstance(error, WrongUseError):
        raise error
    return " ".join(str(words() if words else error).split())


app = typer.Typer(
    cls=OneLineGroup,
    name="cncsub",
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)


def _print_version(asked: bool) -> None:
    if asked:
        typer.echo(f"cncsub {cncsub.__version__}")
        raise typer.Exit


@app.callback()
def _every_command(
    version: Annotated[
        bool,
        typer.Option(
            "--version", callback=_print_version, is_eager=True, help="Print the version and exit."
        ),
    ] = False,
) -> None:
    """Run NC programs exactly as a named CNC control would."""


def main() -> None:
    """What the command `cncsub` does."""
    app(prog_name="cncsub")


class Format(enum.StrEnum):
    TEXT = "text"
    JSON = "json"


class RunFormat(enum.StrEnum):
    TEXT = "text"
    JSON = "json"
    CSV = "csv"
    PARQUET = "parquet"


# ---- options ----

Paths = Annotated[
    list[str] | None,  # an empty path is not the folder one stands in
    typer.Argument(
        help="Files and folders: the memory of the control. The first program runs.",
        show_default=False,
    ),
]
ControlName = Annotated[
    str | None, typer.Option("-c", "--control", help="The control; `cncsub controls` lists them.")
]
Main = Annotated[str | None, typer.Option(help="The program to run, such as O20.")]
Mdi = Annotated[str | None, typer.Option(help="Run this text as if it was typed in MDI.")]
Set = Annotated[
    list[str] | None,
    typer.Option("--set", help="A variable before the run: 100=23.34.", metavar="N=VALUE"),
]
Param = Annotated[
    list[str] | None,
    typer.Option(help="A parameter of the control: 6050=70, 6001#5=1.", metavar="NAME=VALUE"),
]
Skip = Annotated[
    list[int] | None, typer.Option(help="A block-skip switch that is on, 1 to 9.", metavar="N")
]
External = Annotated[
    Path | None, typer.Option(help="The folder of the external device, which M198 reads.")
]
Encoding = Annotated[str | None, typer.Option(help="Of comments and names; found out without it.")]
MaxCycles = Annotated[
    int, typer.Option(help="How often a main program that ends in M99 runs.", min=1)
]
MaxBlocks = Annotated[int, typer.Option(help="How many blocks are executed at most.", min=0)]
SetupFile = Annotated[
    Path | None, typer.Option("--setup", help="A TOML file with offsets, tools, limits.")
]
InputsFile = Annotated[
    Path | None,
    typer.Option("--inputs", help="A TOML file with signals, answers, a workpiece to probe."),
]
Start = Annotated[int | None, typer.Option(help="The sequence number to begin at.")]
OptionalStop = Annotated[bool, typer.Option("--optional-stop", help="M01 stops.")]
Output = Annotated[
    Path | None, typer.Option("-o", "--output", help="Write to this file, not to the terminal.")
]


@app.command()
def run(
    paths: Paths = None,
    control: ControlName = None,
    main: Main = None,
    mdi: Mdi = None,
    set: Set = None,
    param: Param = None,
    skip: Skip = None,
    external: External = None,
    encoding: Encoding = None,
    max_cycles: MaxCycles = 1,
    max_blocks: MaxBlocks = 10_000_000,
    setup: SetupFile = None,
    inputs: InputsFile = None,
    start: Start = None,
    optional_stop: OptionalStop = False,
    format: Annotated[
        RunFormat, typer.Option(help="csv and parquet write the moves.")
    ] = RunFormat.TEXT,
    output: Output = None,
) -> None:
    """Run a program and print its calls and how it stopped."""
    if format in (RunFormat.CSV, RunFormat.PARQUET):
        stream = _stream(locals())
        _write_moves(stream, format, output)
        print_stop(console_on(sys.stderr), stream)
        raise typer.Exit(_status(stream))
    made, title = _run(locals(), trace="moves")
    if format is RunFormat.TEXT:
        _write_text(output, lambda console: print_run(console, made, title))
    else:
        _write_json(output, run_facts(made, title))
    raise typer.Exit(_status(made))


@app.command()
def tree(
    paths: Paths = None,
    control: ControlName = None,
    main: Main = None,
    mdi: Mdi = None,
    set: Set = None,
    param: Param = None,
    skip: Skip = None,
    external: External = None,
    encoding: Encoding = None,
    max_cycles: MaxCycles = 1,
    max_blocks: MaxBlocks = 10_000_000,
    setup: SetupFile = None,
    inputs: InputsFile = None,
    start: Start = None,
    optional_stop: OptionalStop = False,
    format: Annotated[Format, typer.Option()] = Format.TEXT,
    output: Output = None,
) -> None:
    """Draw the calls a program makes."""
    made, title = _run(locals(), trace="blocks")
    if format is Format.JSON:
        _write_json(output, tree_facts(made, title))
    else:
        _write_text(output, lambda console: print_tree(console, made, title))
        if made.stop not in (cncsub.Stop.END, cncsub.Stop.CYCLES):
            print_stop(console_on(sys.stderr), made)
    raise typer.Exit(_status(made))


@app.command()
def compare(
    paths: Paths = None,
    control: Annotated[
        list[str] | None,
        typer.Option("-c", "--control", help="The controls: give it twice.", show_default=False),
    ] = None,
    main: Main = None,
    set: Set = None,
    skip: Skip = None,
    external: External = None,
    encoding: Encoding = None,
    max_cycles: MaxCycles = 1,
    max_blocks: MaxBlocks = 10_000_000,
    setup: SetupFile = None,
    inputs: InputsFile = None,
    start: Start = None,
    optional_stop: OptionalStop = False,
    format: Annotated[Format, typer.Option()] = Format.TEXT,
    output: Output = None,
) -> None:
    """Run a program on two controls: where they part, and the rules that make it."""
    options = {**locals(), "mdi": None, "param": None}
    with _wrong_use():
        if control is None or len(control) != 2:
            raise ValueError("compare takes two controls: -c ONE -c ANOTHER")
        pair = [_control(name) for name in control]
        library = _library({**options, "control": control[0]})
        asked = _asked(options, "moves")
        compared = cncsub.compare(library, controls=pair, main=main, **asked)
    _tell(compared, format, output)


@app.command()
def diff(
    before: Annotated[str, typer.Argument(help="A file or a folder.", show_default=False)],
    after: Annotated[str, typer.Argument(help="Its new version.", show_default=False)],
    control: ControlName = None,
    main: Main = None,
    set: Set = None,
    param: Param = None,
    skip: Skip = None,
    external: External = None,
    encoding: Encoding = None,
    max_cycles: MaxCycles = 1,
    max_blocks: MaxBlocks = 10_000_000,
    setup: SetupFile = None,
    inputs: InputsFile = None,
    start: Start = None,
    optional_stop: OptionalStop = False,
    format: Annotated[Format, typer.Option()] = Format.TEXT,
    output: Output = None,
) -> None:
    """Run two versions of a program: what the new one does otherwise."""
    options = {**locals(), "mdi": None}
    with _wrong_use():
        old, new = (_library({**options, "paths": [path]}) for path in (before, after))
        compared = cncsub.compare(old, new, main=main, **_asked(options, "moves"))
    _tell(compared, format, output)


@app.command()
def flatten(
    paths: Paths = None,
    control: ControlName = None,
    main: Main = None,
    set: Set = None,
    param: Param = None,
    skip: Skip = None,
    external: External = None,
    encoding: Encoding = None,
    max_cycles: MaxCycles = 1,
    max_blocks: MaxBlocks = 10_000_000,
    setup: SetupFile = None,
    inputs: InputsFile = None,
    start: Start = None,
    optional_stop: OptionalStop = False,
    comments: Annotated[bool, typer.Option(help="Write where each block comes from.")] = False,
    output: Output = None,
) -> None:
    """Write what a program executes as one program without calls, jumps and variables."""
    options = {**locals(), "mdi": None}
    with _wrong_use():
        library = _library(options)
        asked = _asked(options, "moves")
        flat = cncsub.flatten(library, main, comments=comments, **asked)
    if output is None:
        typer.echo(flat.text, nl=False)
    else:
        with _opened(output, "w") as file:
            file.write(flat.text)


def _tell(compared: cncsub.Comparison, format: Format, output: Path | None) -> None:
    if format is Format.JSON:
        _write_json(output, comparison_facts(compared))
    else:
        lines = "\n".join(shown(line) for line in str(compared).split("\n"))
        _write_text(output, lambda console: console.print(lines))
    raise typer.Exit(0 if compared.same else 1)


@app.command()
def controls(
    name: Annotated[str | None, typer.Argument(help="One control.", show_default=False)] = None,
    format: Annotated[Format, typer.Option()] = Format.TEXT,
    output: Output = None,
) -> None:
    """List the controls, or the rules, parameters and alarms of one with their sources."""
    if name is None:
        listed = {known.name: known.title for known in cncsub.controls.values()}
        if format is Format.JSON:
            _write_json(output, [{"name": key, "title": title} for key, title in listed.items()])
        else:
            _write_text(output, lambda console: print_pairs(console, listed))
        return
    control = _control(name)
    if format is Format.JSON:
        _write_json(output, control_facts(control))
    else:
        _write_text(output, lambda console: print_control(console, control))


@app.command()
def explain(
    alarm: Annotated[str, typer.Argument(help="An alarm number such as P232, or a cause.")],
    control: ControlName = None,
    format: Annotated[Format, typer.Option()] = Format.TEXT,
    output: Output = None,
) -> None:
    """Tell what an alarm means, what raises it and how to cure it."""
    among = list(cncsub.controls.values()) if control is None else [_control(control)]
    facts = explanations(alarm, among)
    if not facts:
        raise WrongUseError(unknown_alarm(alarm, among))
    if format is Format.JSON:
        _write_json(output, facts)
    else:
        _write_text(output, lambda console: print_explanations(console, facts))


# ---- running ----


def _run(options: Mapping[str, Any], *, trace: str) -> tuple[cncsub.Run, str]:
    """Run what the options say, and name what ran."""
    with _wrong_use():
        library = _library(options)
        asked = _asked(options, trace)
        where = f"on {library.control.title}"
        if options["mdi"] is not None:
            return library.mdi(options["mdi"], **asked), f"MDI {where}"
        program = library.main if options["main"] is None else library[options["main"]]
        name = "nothing" if program is None else program.name
        return library.run(options["main"], **asked), f"{name} {where}"


def _stream(options: Mapping[str, Any]) -> cncsub.Stream:
    """What the options say, to be run while its moves are written."""
    with _wrong_use():
        if options["mdi"] is not None:
            raise ValueError("csv and parquet write what a program moves; --mdi takes text or json")
        return _library(options).stream(options["main"], **_asked(options, "moves"))


@contextlib.contextmanager
def _wrong_use() -> Iterator[None]:
    """Every wrong option is a usage error."""
    try:
        yield
    except KeyError as error:
        raise WrongUseError(str(error.args[0])) from None
    except OSError as error:
        named = f"{error.filename}: " if error.filename else ""
        raise WrongUseError(f"{named}{error.strerror or error}") from None
    except (ValueError, TypeError) as error:
        raise WrongUseError(str(error)) from None


def _asked(options: Mapping[str, Any], trace: str) -> dict[str, Any]:
    if options["mdi"] is not None and options["main"] is not None:
        raise ValueError("--mdi runs what was typed and --main a program; give one of them")
    asked: dict[str, Any] = {
        "start": options["start"],
        "variables": dict(_assignment("--set", text, _vacant) for text in options["set"] or ()),
        "block_skip": options["skip"] or (),
        "optional_stop": options["optional_stop"],
        "max_cycles": options["max_cycles"],
        "max_blocks": options["max_blocks"],
        "trace": trace,
    }
    if options["setup"] is not None:
        asked["setup"] = cncsub.Setup.from_toml(options["setup"])
    if options["inputs"] is not None:
        asked["inputs"] = cncsub.Inputs.from_toml(options["inputs"])
    return asked


def _library(options: Mapping[str, Any]) -> cncsub.Library:
    output = options["output"]
    if output is not None and any(
        output.resolve() == Path(path).resolve() for path in options["paths"] or ()
    ):
        raise ValueError(f"{output} is the program; name another file to write to")
    control = _control(options["control"])
    if options["param"]:
        pairs = (_named_value("--param", text) for text in options["param"])
        control = control.with_parameters(dict(pairs))
    places = {"control": control, "external": options["external"]}
    if options["paths"]:
        return cncsub.load(*options["paths"], encoding=options["encoding"], **places)
    if options["mdi"] is None:
        raise ValueError("which program? Name a file or a folder, or give --mdi")
    return cncsub.loads("", **places)


def _control(name: str | None) -> cncsub.Control:
    if name is None:
        raise WrongUseError(f"which control? Give -c and one of {', '.join(cncsub.controls)}")
    if name not in cncsub.controls:
        near = did_you_mean(name, cncsub.controls, f"; there are {', '.join(cncsub.controls)}")
        raise WrongUseError(f"no control is called {name!r}{near}")
    return cncsub.controls[name]


def _named_value(option: str, text: str) -> tuple[str, float]:
    name, equals, value = text.partition("=")
    try:
        if not equals or not name.strip():
            raise ValueError
        return name.strip(), float(value)
    except ValueError:
        raise ValueError(f"{option} takes NAME=VALUE, such as 6050=70, not {text!r}") from None


def _vacant(value: str) -> float | None:
    return None if value.strip().lower() in ("vacant", "none", "#0") else float(value)


def _assignment(
    option: str, text: str, read: Callable[[str], float | None]
) -> tuple[int, float | None]:
    number, _, value = text.strip().removeprefix("#").partition("=")
    try:
        return int(number), read(value)
    except ValueError:
        raise ValueError(
            f"{option} takes NUMBER=VALUE, such as 100=23.34 or 100=vacant, not {text!r}"
        ) from None


STATUS = {
    cncsub.Stop.END: 0,
    cncsub.Stop.CYCLES: 0,
    cncsub.Stop.ALARM: 1,
    cncsub.Stop.WAITING: 3,
    cncsub.Stop.LIMIT: 4,
    cncsub.Stop.INTERRUPTED: 130,
}


def _status(run: cncsub.Run | cncsub.Stream) -> int:
    return 1 if run.stop is None else STATUS[cncsub.Stop(run.stop)]


# ---- writing ----


def _escaped(character: str) -> str:
    """A character as JSON writes it in plain ASCII."""
    return json.dumps(character).strip('"')


def _write_text(output: Path | None, write: Callable[[Console], None]) -> None:
    if output is None:
        write(console_on(sys.stdout))
        return
    with _opened(output, "w") as file:
        write(console_on(file))


def _opened(output: Path, mode: str) -> IO[Any]:
    try:
        return output.open(mode, encoding=None if "b" in mode else "utf-8", newline=None)
    except OSError as error:
        raise WrongUseError(f"{output}: {error.strerror or error}") from None


def _write_json(output: Path | None, facts: object) -> None:
    text = json.dumps(facts, ensure_ascii=False, indent=2, allow_nan=False)
    # What a terminal would obey is written as an escape; everything outside ASCII is in a string.
    text = re.sub(r"[^\x20-\x7e\n]", lambda c: c[0] if c[0].isprintable() else _escaped(c[0]), text)
    if output is None:
        typer.echo(text)
    else:
        with _opened(output, "w") as file:
            file.write(text + "\n")


def _write_moves(stream: cncsub.Stream, format: RunFormat, output: Path | None) -> None:
    if format is RunFormat.CSV:
        if output is None:
            _write_csv(stream, sys.stdout)
        else:
            with _opened(output, "w") as file:
                _write_csv(stream, file)
        return
    if output is None:
        raise WrongUseError("parquet needs a file: --output moves.parquet")
    try:
        from pyarrow import parquet
    except ImportError:
        raise WrongUseError("parquet needs pyarrow: pip install 'cncsub[arrow]'") from None
    with contextlib.ExitStack() as files:
        file = files.enter_context(_opened(output, "wb"))
        writer = None
        for part in stream:
            rows = part.moves.to_arrow()
            if writer is None:
                writer = files.enter_context(parquet.ParquetWriter(file, rows.schema))
            writer.write_table(rows)


def _write_csv(stream: cncsub.Stream, file: IO[str]) -> None:
    import csv

    writer = csv.writer(file, lineterminator="\n")
    for number, part in enumerate(stream):
        if number == 0:
            writer.writerow(part.moves.columns)
        writer.writerows(record.values() for record in records(part.moves))
