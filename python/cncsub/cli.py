"""The command line: `cncsub run`, `tree`, `list`, `check`, `coverage`, `compare`, `diff`,
`flatten`, `batch`, `controls`, `explain`.

Exit status: 0 where the program ran to its end (or used up its cycles) and where what is compared
is the same, 1 for an alarm and for a difference, 2 for wrong
use, which is told in one line, 3 where the run waits for an input nobody gave, 4 at a limit, 130
for Ctrl-C.
"""

from __future__ import annotations

import contextlib
import os
import re
import sys
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import IO, Annotated, Any

import typer
import typer.core

import cncsub
from cncsub.batch import batch
from cncsub.check_command import check
from cncsub.checking import rule_named
from cncsub.controls_command import controls
from cncsub.coverage_command import coverage
from cncsub.facts import (
    comparison_facts,
    explanations,
    run_facts,
    tree_facts,
    unknown_alarm,
)
from cncsub.flatten_command import flatten
from cncsub.hints import defaulted, hints_of, without_effect
from cncsub.list_command import list_programs
from cncsub.listing_command import Listing, Where, filters, write_listing
from cncsub.options import (
    ControlName,
    Encoding,
    External,
    Format,
    InputsFile,
    Main,
    MaxBlocks,
    MaxCycles,
    Mdi,
    OptionalStop,
    Output,
    Param,
    Paths,
    Prefer,
    RunFormat,
    Set,
    SetupFile,
    Skip,
    Start,
    VariablesFile,
    Watch,
    WrongUseError,
    control_named,
    memory_of,
    opened,
    run_options,
    status_of,
    tell_all,
    tell_hints,
    write_json,
    write_text,
    wrong_use,
)
from cncsub.printing import (
    console_on,
    print_explanations,
    print_run,
    print_stop,
    print_tree,
    shown,
)
from cncsub.report_command import report
from cncsub.static_command import draw_static_tree
from cncsub.tables import records
from cncsub.translate_command import Translate, tell_translation


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


FIRST_STEPS = """\
First steps:

  cncsub controls                         the controls there are
  cncsub run part.nc -c fanuc-0i-f        run a program: its calls, its end, its alarm
  cncsub check part.nc -c fanuc-0i-f      what would alarm or surprise, without running
  cncsub list folder/ -c fanuc-0i-f       the programs, and who calls whom
  cncsub explain PS0076                   what an alarm means, and its cure

CNCSUB_CONTROL=fanuc-0i-f, or a cncsub.toml beside the programs, names the control for them all."""


@app.callback(invoke_without_command=True)
def _every_command(
    context: typer.Context,
    version: Annotated[
        bool,
        typer.Option(
            "--version", callback=_print_version, is_eager=True, help="Print the version and exit."
        ),
    ] = False,
) -> None:
    """Run NC programs exactly as a named CNC control would."""
    if context.invoked_subcommand is None:
        typer.echo(f"{context.get_help()}\n\n{FIRST_STEPS}")
        raise typer.Exit


def main() -> None:
    """What the command `cncsub` does."""
    app(prog_name="cncsub")


@app.command()
def run(
    paths: Paths = None,
    control: ControlName = None,
    main: Main = None,
    mdi: Mdi = None,
    set: Set = None,
    variables: VariablesFile = None,
    param: Param = None,
    skip: Skip = None,
    external: External = None,
    prefer: Prefer = None,
    encoding: Encoding = None,
    max_cycles: MaxCycles = 1,
    max_blocks: MaxBlocks = 10_000_000,
    setup: SetupFile = None,
    inputs: InputsFile = None,
    start: Start = None,
    optional_stop: OptionalStop = False,
    watch: Watch = None,
    listing: Listing = False,
    where: Where = None,
    format: Annotated[
        RunFormat, typer.Option(help="csv and parquet write the moves.")
    ] = RunFormat.TEXT,
    output: Output = None,
) -> None:
    """Run a program and print its calls and how it stopped."""
    if format in (RunFormat.CSV, RunFormat.PARQUET):
        with wrong_use():
            if listing:
                raise ValueError("csv and parquet write the moves; --listing takes text or json")
        stream = _stream(locals())
        _write_moves(stream, format, output)
        print_stop(console_on(sys.stderr), stream)
        raise typer.Exit(status_of(stream))
    with wrong_use():
        asked = filters(where or ())
        if asked and not listing:
            raise ValueError("--where chooses blocks of the listing: give --listing too")
    made, title, notes, hints = _run(_watching(locals(), asked), trace="moves")
    if listing:
        with wrong_use():
            blocks = made.listing(**asked)
        write_listing(blocks, output, as_json=format is RunFormat.JSON)
        print_stop(console_on(sys.stderr), made)
        raise typer.Exit(status_of(made))
    if format is RunFormat.TEXT:
        write_text(output, lambda console: print_run(console, made, title))
        tell_hints(hints)
    else:
        write_json(output, {**run_facts(made, title), "notes": notes, "hints": hints})
    raise typer.Exit(status_of(made))


@app.command()
def tree(
    paths: Paths = None,
    control: ControlName = None,
    main: Main = None,
    mdi: Mdi = None,
    set: Set = None,
    variables: VariablesFile = None,
    param: Param = None,
    skip: Skip = None,
    external: External = None,
    prefer: Prefer = None,
    encoding: Encoding = None,
    max_cycles: MaxCycles = 1,
    max_blocks: MaxBlocks = 10_000_000,
    setup: SetupFile = None,
    inputs: InputsFile = None,
    start: Start = None,
    optional_stop: OptionalStop = False,
    static: Annotated[
        bool, typer.Option("--static", help="As it is written, without running.")
    ] = False,
    format: Annotated[Format, typer.Option()] = Format.TEXT,
    output: Output = None,
) -> None:
    """Draw the calls a program makes, their arguments and callers: as it ran, or as written."""
    if static:
        draw_static_tree(locals(), main, format, output)
        return
    made, title, notes, hints = _run(locals(), trace="blocks")
    if format is Format.JSON:
        write_json(output, {**tree_facts(made, title), "notes": notes, "hints": hints})
    else:
        write_text(output, lambda console: print_tree(console, made, title, callers=True))
        if made.stop not in (cncsub.Stop.END, cncsub.Stop.CYCLES):
            print_stop(console_on(sys.stderr), made)
            tell_hints(hints)
    raise typer.Exit(status_of(made))


app.command("list")(list_programs)


app.command()(check)


@app.command()
def compare(
    paths: Paths = None,
    control: Annotated[
        list[str] | None,
        typer.Option("-c", "--control", help="The controls: give it twice.", show_default=False),
    ] = None,
    main: Main = None,
    set: Set = None,
    variables: VariablesFile = None,
    skip: Skip = None,
    external: External = None,
    prefer: Prefer = None,
    encoding: Encoding = None,
    max_cycles: MaxCycles = 1,
    max_blocks: MaxBlocks = 10_000_000,
    setup: SetupFile = None,
    inputs: InputsFile = None,
    start: Start = None,
    optional_stop: OptionalStop = False,
    translate: Translate = False,
    format: Annotated[Format, typer.Option()] = Format.TEXT,
    output: Output = None,
) -> None:
    """Run a program on two controls: where they part, and the rules that make it.

    With --translate, calls are rewritten so that the second control does what the first one does,
    which is proved by running both: the changes are printed, or the programs written to folder -o.
    """
    options = {**locals(), "mdi": None, "param": None}
    with wrong_use():
        if control is None or len(control) != 2:
            raise ValueError("compare takes two controls: -c ONE -c ANOTHER")
        pair = [control_named(name) for name in control]
        library = memory_of({**options, "control": control[0]})
        asked = run_options(options, "moves")
        if translate:
            made = cncsub.translate(library.read_for(pair[0]), pair[1], main=main, **asked)
            tell_translation(made, output, as_json=format is Format.JSON)
            return
        compared = cncsub.compare(library, controls=pair, main=main, **asked)
    _tell(compared, format, output)


@app.command()
def diff(
    before: Annotated[str, typer.Argument(help="A file or a folder.", show_default=False)],
    after: Annotated[str, typer.Argument(help="Its new version.", show_default=False)],
    control: ControlName = None,
    main: Main = None,
    set: Set = None,
    variables: VariablesFile = None,
    param: Param = None,
    skip: Skip = None,
    external: External = None,
    prefer: Prefer = None,
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
    with wrong_use():
        old, new = (memory_of({**options, "paths": [path]}) for path in (before, after))
        compared = cncsub.compare(old, new, main=main, **run_options(options, "moves"))
    _tell(compared, format, output)


app.command()(flatten)


def _tell(compared: cncsub.Comparison, format: Format, output: Path | None) -> None:
    if format is Format.JSON:
        write_json(output, comparison_facts(compared))
    else:
        lines = "\n".join(shown(line) for line in str(compared).split("\n"))
        write_text(output, lambda console: console.print(lines))
    raise typer.Exit(0 if compared.same else 1)


app.command()(coverage)


app.command()(report)


app.command()(controls)


@app.command()
def explain(
    alarm: Annotated[str, typer.Argument(help="An alarm number such as P232, a cause, or a rule.")],
    control: ControlName = None,
    format: Annotated[Format, typer.Option()] = Format.TEXT,
    output: Output = None,
) -> None:
    """Tell what an alarm means, what raises it and how to cure it; or what a rule finds."""
    if re.fullmatch(r"CS\d{3}", alarm, re.IGNORECASE):
        _explain_rule(alarm, format, output)
        return
    among = list(cncsub.controls.values()) if control is None else [control_named(control)]
    facts = explanations(alarm, among)
    if not facts:
        raise WrongUseError(unknown_alarm(alarm, among))
    if format is Format.JSON:
        write_json(output, facts)
    else:
        write_text(output, lambda console: print_explanations(console, facts))


def _explain_rule(name: str, format: Format, output: Path | None) -> None:
    with wrong_use():
        rule = rule_named(name)
    if format is Format.JSON:
        write_json(output, rule._asdict())
        return
    example = "".join(f"      {line}\n" for line in rule.example.splitlines())
    lines = [
        f"{rule.number} {rule.name}, {rule.severity}",
        f"  finds: {rule.meaning}",
        f"  cure: {rule.hint}",
        f"  such as, on {rule.control}:",
        example.rstrip("\n"),
    ]
    write_text(output, lambda console: console.print("\n".join(lines)))


app.command()(batch)


# ---- running ----


def _watching(options: Mapping[str, Any], asked: Mapping[str, Any]) -> Mapping[str, Any]:
    """With the variable watched that the listing asks for."""
    if "variable" not in asked:
        return options
    return {**options, "watch": [*(options["watch"] or ()), str(asked["variable"])]}


def _run(
    options: Mapping[str, Any], *, trace: str
) -> tuple[cncsub.Run, str, list[dict[str, Any]], list[str]]:
    """Run what the options say, name what ran, what is to be known of the memory and the options,
    and what leads on from an alarm.
    """
    with wrong_use():
        library = memory_of(options)
        asked = run_options(options, trace)
        where = f"on {library.control.title}"
        notes = [asdict(note) for note in library.notes]
        if options["mdi"] is not None:
            return library.mdi(options["mdi"], **asked), f"MDI {where}", notes, []
        program = library.main if options["main"] is None else library[options["main"]]
        name = "nothing" if program is None else program.name
        made = library.run(options["main"], **asked)
        idle = [*defaulted(options), *without_effect(library, asked)]
        tell_all(idle)
        notes += map(asdict, idle)
        return made, f"{name} {where}", notes, hints_of(library, made, asked, options["main"])


def _stream(options: Mapping[str, Any]) -> cncsub.Stream:
    """What the options say, to be run while its moves are written."""
    with wrong_use():
        if options["watch"]:
            raise ValueError("csv and parquet write the moves; --watch takes text or json")
        if options["mdi"] is not None:
            raise ValueError("csv and parquet write what a program moves; --mdi takes text or json")
        return memory_of(options).stream(options["main"], **run_options(options, "moves"))


def _write_moves(stream: cncsub.Stream, format: RunFormat, output: Path | None) -> None:
    if format is RunFormat.CSV:
        if output is None:
            _write_csv(stream, sys.stdout)
        else:
            with opened(output, "w") as file:
                _write_csv(stream, file)
        return
    if output is None:
        raise WrongUseError("parquet needs a file: --output moves.parquet")
    try:
        from pyarrow import parquet
    except ImportError:
        raise WrongUseError("parquet needs pyarrow: pip install 'cncsub[arrow]'") from None
    with contextlib.ExitStack() as files:
        file = files.enter_context(opened(output, "wb"))
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
