"""The command line: `cncsub run`, `tree`, `controls`, `explain`.

Exit status: 0 where the program ran to its end (or used up its cycles), 1 for an alarm and every
other stop, 2 for wrong use, which is told in one line.
"""

from __future__ import annotations

import enum
import json
import os
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from typing import IO, Annotated, Any

import typer
import typer.core
from rich.console import Console
from rich.text import Text

import cncsub
from cncsub.controls import did_you_mean
from cncsub.tables import CallTree, records

MOST_CALLS = 200  # lines of the tree of calls


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
            sys.exit(1)
        except BrokenPipeError:
            # Whoever read the output has enough; nothing is left to write at the end.
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
            sys.exit(1)
        except Exception as error:
            typer.echo(f"cncsub: {_one_line(error)}", err=True)
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
    help="Run NC programs exactly as a named CNC control would.",
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)


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
    list[Path] | None,
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
    start: Start = None,
    optional_stop: OptionalStop = False,
    format: Annotated[
        RunFormat, typer.Option(help="csv and parquet write the moves.")
    ] = RunFormat.TEXT,
    output: Output = None,
) -> None:
    """Run a program and print its calls and how it stopped."""
    with_moves = format is not RunFormat.TEXT
    made = _run(locals(), trace="moves")
    if format is RunFormat.TEXT:
        _write_text(output, lambda console: _print_run(console, made))
    elif format is RunFormat.JSON:
        _write_json(output, _run_facts(made.run, made.title, with_moves=with_moves))
    else:
        _write_moves(made.run, format, output)
        _print_stop(Console(stderr=True, highlight=False, soft_wrap=True), made.run)
    raise typer.Exit(_status(made.run))


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
    start: Start = None,
    optional_stop: OptionalStop = False,
    format: Annotated[Format, typer.Option()] = Format.TEXT,
    output: Output = None,
) -> None:
    """Draw the calls a program makes."""
    made = _run(locals(), trace="blocks")
    if format is Format.JSON:
        _write_json(output, _tree_facts(made))
    else:
        _write_text(output, lambda console: _print_tree(console, made))
        if made.run.stop not in (cncsub.Stop.END, cncsub.Stop.CYCLES):
            _print_stop(Console(stderr=True, highlight=False, soft_wrap=True), made.run)
    raise typer.Exit(_status(made.run))


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
            _write_text(output, lambda console: _print_pairs(console, listed))
        return
    control = _control(name)
    if format is Format.JSON:
        _write_json(output, _control_facts(control))
    else:
        _write_text(output, lambda console: _print_control(console, control))


@app.command()
def explain(
    alarm: Annotated[str, typer.Argument(help="An alarm number such as P232, or a cause.")],
    control: ControlName = None,
    format: Annotated[Format, typer.Option()] = Format.TEXT,
    output: Output = None,
) -> None:
    """Tell what an alarm means, what raises it and how to cure it."""
    among = list(cncsub.controls.values()) if control is None else [_control(control)]
    facts = _explanations(alarm, among, all_causes=True)
    if not facts:
        raise WrongUseError(_unknown_alarm(alarm, among))
    if format is Format.JSON:
        _write_json(output, facts)
    else:
        _write_text(output, lambda console: _print_explanations(console, facts))


# ---- running ----


class Made:
    """A run of the command line: the library, the run, and the name of what ran."""

    def __init__(self, library: cncsub.Library, run: cncsub.Run, program: str) -> None:
        self.library = library
        self.run = run
        self.title = f"{program} on {library.control.title}"


def _run(options: Mapping[str, Any], *, trace: str) -> Made:
    """Run what the options say; every wrong one is a usage error."""
    try:
        return _made(options, trace)
    except KeyError as error:
        raise WrongUseError(str(error.args[0])) from None
    except OSError as error:
        named = f"{error.filename}: " if error.filename else ""
        raise WrongUseError(f"{named}{error.strerror or error}") from None
    except (ValueError, TypeError) as error:
        raise WrongUseError(str(error)) from None


def _made(options: Mapping[str, Any], trace: str) -> Made:
    library = _library(options)
    mdi = options["mdi"]
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
    if mdi is None:
        program = library.main if options["main"] is None else library[options["main"]]
        found = library.run(options["main"], **asked)
        return Made(library, found, "nothing" if program is None else program.name)
    if options["main"] is not None:
        raise ValueError("--mdi runs what was typed and --main a program; give one of them")
    return Made(library, library.mdi(mdi, **asked), "MDI")


def _library(options: Mapping[str, Any]) -> cncsub.Library:
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


def _status(run: cncsub.Run) -> int:
    return 0 if run.stop in (cncsub.Stop.END, cncsub.Stop.CYCLES) else 1


# ---- writing ----


def _write_text(output: Path | None, write: Callable[[Console], None]) -> None:
    if output is None:
        write(_console(sys.stdout))
        return
    with _opened(output, "w") as file:
        write(_console(file))


def _console(file: IO[str]) -> Console:
    """Colour on a terminal only; nothing is wrapped or marked up by rich."""
    return Console(file=file, highlight=False, markup=False, emoji=False, soft_wrap=True)


def _opened(output: Path, mode: str) -> IO[Any]:
    try:
        return output.open(mode, encoding=None if "b" in mode else "utf-8", newline=None)
    except OSError as error:
        raise WrongUseError(f"{output}: {error.strerror or error}") from None


def _write_json(output: Path | None, facts: object) -> None:
    text = json.dumps(facts, ensure_ascii=False, indent=2, allow_nan=False)
    if output is None:
        typer.echo(text)
    else:
        with _opened(output, "w") as file:
            file.write(text + "\n")


def _write_moves(run: cncsub.Run, format: RunFormat, output: Path | None) -> None:
    if format is RunFormat.CSV:
        if output is None:
            _write_csv(run, sys.stdout)
        else:
            with _opened(output, "w") as file:
                _write_csv(run, file)
        return
    if output is None:
        raise WrongUseError("parquet needs a file: --output moves.parquet")
    try:
        from pyarrow import parquet
    except ImportError:
        raise WrongUseError("parquet needs pyarrow: pip install 'cncsub[arrow]'") from None
    with _opened(output, "wb") as file:
        parquet.write_table(run.moves.to_arrow(), file)


def _write_csv(run: cncsub.Run, file: IO[str]) -> None:
    import csv

    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(run.moves.columns)
    writer.writerows(record.values() for record in records(run.moves))


# ---- text ----

_COLOURS = {"end": "green", "cycles": "green", "alarm": "bold red"}


def _print_run(console: Console, made: Made) -> None:
    run = made.run
    _print_tree(console, made)
    _print_stop(console, run)
    if len(run.moves):
        console.print(f"{len(run.moves):,} moves, length {run.moves.total_length:,.3f} mm,", end="")
        console.print(f" time {_duration(run.moves.total_time)}")
        for axis, (low, high) in run.moves.bounds.items():
            console.print(f"  {axis} {low:.10g} to {high:.10g}")
    for message in run.messages:
        console.print(f"message: {_shown(message)}")


def _print_tree(console: Console, made: Made) -> None:
    console.print(Text(_shown(made.title), style="bold"))
    lines = _tree_lines(made.run.calls.tree())
    for line, _ in zip(lines, range(MOST_CALLS), strict=False):
        console.print(line)
    left = sum(1 for _ in lines)
    if left:
        console.print(f"... {left:,} more lines")


def _tree_lines(trees: list[CallTree]) -> Iterator[Text]:
    waiting = [(call, "", call is trees[-1]) for call in reversed(trees)]
    while waiting:
        call, stem, last = waiting.pop()
        head = f"{call.kind} {call.program}"
        branch = stem + ("`-- " if last else "|-- ")
        yield Text.assemble((branch, "dim"), (head, "cyan"), str(call).removeprefix(head))
        below = stem + ("    " if last else "|   ")
        waiting += [(inner, below, inner is call.calls[-1]) for inner in reversed(call.calls)]


def _print_stop(console: Console, run: cncsub.Run) -> None:
    stop = Text(f"stopped: {_stop_text(run)}", style=_COLOURS.get(run.stop.value, "yellow"))
    console.print(stop)
    if run.alarm is not None:
        console.print(Text(str(run.alarm)))


def _stop_text(run: cncsub.Run) -> str:
    blocks = f"{len(run.steps):,} block{'s' if len(run.steps) != 1 else ''}"
    if run.stop is cncsub.Stop.WAITING:
        return f"waiting for {run.waiting_for or 'an input nobody gave'}, after {blocks}"
    reasons = {
        cncsub.Stop.END: "the program ended",
        cncsub.Stop.ALARM: "alarm",
        cncsub.Stop.CYCLES: "the cycles are used up (--max-cycles)",
        cncsub.Stop.LIMIT: "the limit of blocks is reached (--max-blocks)",
        cncsub.Stop.INTERRUPTED: "interrupted",
    }
    return f"{reasons[run.stop]}, after {blocks}"


def _shown(text: str) -> str:
    """A text of a program without what a terminal would obey."""
    return "".join(c if c.isprintable() else " " for c in text)


def _duration(seconds: float) -> str:
    minutes, rest = divmod(seconds, 60)
    hours, minutes = divmod(int(minutes), 60)
    parts = [f"{hours} h" if hours else "", f"{minutes} min" if minutes or hours else ""]
    return " ".join([*filter(None, parts), f"{rest:.1f} s"])


def _print_pairs(console: Console, pairs: Mapping[str, str]) -> None:
    width = max(map(len, pairs))
    for name, text in pairs.items():
        console.print(Text.assemble((name.ljust(width), "cyan"), f"  {text}"))


def _print_control(console: Console, control: cncsub.Control) -> None:
    console.print(Text(f"{control.title} ({control.name})", style="bold"))
    rules = ((f"{r.name} = {_value(r.value)}", r.meaning, r) for r in control.rules)
    _print_facts(console, "Rules", rules)
    parameters = ((f"{p.name} = {p.value:g}", p.meaning, p) for p in control.parameters.values())
    _print_facts(console, "Parameters", parameters)
    alarms = (
        (f"{a.number or '(no number)'} {a.cause}", a.text or cncsub.causes[a.cause].meaning, a)
        for a in control.alarms.values()
    )
    _print_facts(console, "Alarms", alarms)


def _print_facts(console: Console, title: str, facts: Iterable[tuple[str, str, Any]]) -> None:
    console.print(Text(f"\n{title}", style="bold"))
    for head, text, fact in facts:
        console.print(Text.assemble((f"  {head}", "cyan"), f": {text}"))
        console.print(Text(f"      [{fact.source}; {fact.evidence}]", style="dim"))


def _value(value: bool | int | str) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return str(value) or "none"


# ---- alarms ----


def _explanations(
    asked: str, among: list[cncsub.Control], *, all_causes: bool
) -> list[dict[str, Any]]:
    """What is known about a cause or a number: one entry for each cause, with its controls."""
    wanted = asked.strip().casefold()
    slugs = [slug for slug in cncsub.causes if slug == wanted]
    if not slugs:
        slugs = _causes_of_number(wanted, among)
    by_number = wanted not in cncsub.causes
    return [_explanation(slug, among, wanted if by_number else None) for slug in slugs]


def _causes_of_number(wanted: str, among: list[cncsub.Control]) -> list[str]:
    exact = {a.cause for c in among for a in c.alarms.values() if _same(a.number, wanted)}
    loose = {a.cause for c in among for a in c.alarms.values() if _alike(a.number, wanted)}
    return [slug for slug in cncsub.causes if slug in (exact or loose)]


def _same(number: str | None, wanted: str) -> bool:
    return number is not None and number.casefold() == wanted


def _alike(number: str | None, wanted: str) -> bool:
    """`78` is said for `078` and for `PS0076`."""
    return bool(number) and _figures(number) == _figures(wanted) != ""


def _figures(number: str | None) -> str:
    text = (number or "").casefold().strip()
    for prefix in ("ps", "sr", "p/s", "p", "no.", "#"):
        if text.startswith(prefix) and text[len(prefix) :].strip().isdigit():
            text = text[len(prefix) :].strip()
            break
    return text.lstrip("0") if text.isdigit() else ""


def _explanation(slug: str, among: list[cncsub.Control], wanted: str | None) -> dict[str, Any]:
    cause = cncsub.causes[slug]
    entries = [(c, c.alarms[slug]) for c in among if slug in c.alarms]
    if wanted is not None:
        exact = [(c, a) for c, a in entries if _same(a.number, wanted)]
        entries = exact or [(c, a) for c, a in entries if _alike(a.number, wanted)]
    return {
        "cause": slug,
        "meaning": cause.meaning,
        "cure": cause.cure,
        "alarms": [{"control": control.name, **_alarm_entry(entry)} for control, entry in entries],
    }


def _alarm_entry(entry: Any) -> dict[str, Any]:
    return {
        "number": entry.number or None,
        "text": entry.text,
        "source": entry.source,
        "evidence": entry.evidence,
    }


def _print_explanations(console: Console, facts: list[dict[str, Any]]) -> None:
    for place, fact in enumerate(facts):
        if place:
            console.print()
        console.print(Text(fact["cause"], style="bold"))
        console.print(f"  raised by: {fact['meaning']}")
        console.print(f"  cure: {fact['cure']}")
        for alarm in fact["alarms"]:
            number = alarm["number"] or "no number"
            text = f" {alarm['text']}" if alarm["text"] else ""
            console.print(Text.assemble((f"  {alarm['control']}: ", "cyan"), f"{number}{text}"))
            console.print(Text(f"      [{alarm['source']}; {alarm['evidence']}]", style="dim"))
        if not fact["alarms"]:
            console.print("  no source gives a number")


def _unknown_alarm(asked: str, among: list[cncsub.Control]) -> str:
    numbers = [a.number for c in among for a in c.alarms.values() if a.number]
    near = did_you_mean(asked, [*cncsub.causes, *dict.fromkeys(numbers)])
    where = f" on {among[0].name}" if len(among) == 1 else ""
    return f"no alarm or cause is called {asked!r}{where}{near}"


# ---- JSON ----


def _run_facts(run: cncsub.Run, title: str, *, with_moves: bool) -> dict[str, Any]:
    facts: dict[str, Any] = {
        "title": title,
        "stop": run.stop.value,
        "waiting_for": run.waiting_for or None,
        "alarm": None if run.alarm is None else _alarm_facts(run.alarm),
        "steps": len(run.steps),
        "calls": [dict(record) for record in records(run.calls)],
        "length": run.moves.total_length,
        "time": run.moves.total_time,
        "bounds": {axis: list(pair) for axis, pair in run.moves.bounds.items()},
        "messages": run.messages,
        "m_codes": run.m_codes,
        "t_codes": run.t_codes,
        "variables": {str(number): value for number, value in run.variables.items()},
        "position": run.position,
        "modal": run.modal,
    }
    if with_moves:
        facts["moves"] = [dict(record) for record in records(run.moves)]
    return facts


def _alarm_facts(alarm: cncsub.Alarm) -> dict[str, Any]:
    names = "cause number text program n line column word file detail".split()  # noqa: SIM905
    return {
        **{name: getattr(alarm, name) for name in names},
        "frames": [_frame_facts(frame) for frame in alarm.frames],
        "message": str(alarm),
    }


def _frame_facts(frame: cncsub.Frame) -> dict[str, Any]:
    names = "program n line file kind called repeat repeats".split()  # noqa: SIM905
    return {name: getattr(frame, name) for name in names}


def _tree_facts(made: Made) -> dict[str, Any]:
    return {
        "title": made.title,
        "stop": made.run.stop.value,
        "alarm": None if made.run.alarm is None else _alarm_facts(made.run.alarm),
        "calls": [_call_facts(call) for call in made.run.calls.tree()],
    }


def _call_facts(call: CallTree) -> dict[str, Any]:
    return {
        "kind": call.kind,
        "program": call.program,
        "start_n": call.start_n,
        "repeats": call.repeats,
        "blocks": call.blocks,
        "count": call.count,
        "calls": [_call_facts(inner) for inner in call.calls],
    }


def _control_facts(control: cncsub.Control) -> dict[str, Any]:
    return {
        "name": control.name,
        "title": control.title,
        "rules": [
            {
                "name": rule.name,
                "value": rule.value,
                "meaning": rule.meaning,
                "choices": list(rule.choices),
                "source": rule.source,
                "evidence": rule.evidence,
            }
            for rule in control.rules
        ],
        "parameters": [
            {
                "name": parameter.name,
                "value": parameter.value,
                "meaning": parameter.meaning,
                "source": parameter.source,
                "evidence": parameter.evidence,
            }
            for parameter in control.parameters.values()
        ],
        "alarms": [
            {"cause": alarm.cause, **_alarm_entry(alarm)} for alarm in control.alarms.values()
        ],
    }
