"""The command line: `cncsub` and a command, of which `COMMANDS` is the list.

Exit status: 0 where the program ran to its end (or used up its cycles) and where what is compared
is the same, 1 for an alarm and for a difference, 2 for wrong use, which is reported in one line, 3
where the run waits for an input that is not given, 4 at a limit, 5 where the system has no room
left (a full disk, a limit of files or memory), 130 for Ctrl-C.
"""

from __future__ import annotations

import contextlib
import sys
from collections import Counter
from importlib import import_module
from pathlib import Path
from typing import Annotated, Any

import typer
import typer.core
import typer.main

import cncsub
from cncsub import interrupts, system
from cncsub.cli.options import WrongUseError, told_of
from cncsub.cli.output import NOT_DONE
from cncsub.controls import did_you_mean
from cncsub.escapes import shown

# Each command with its function and module, which is imported when the command is asked for, and
# its line in the list of commands.
COMMANDS = {
    "run": ("cli.run.run", "Run a program, and print its calls and how it stopped."),
    "tree": ("cli.run.tree", "Draw the calls of a program, with arguments and callers."),
    "list": ("cli.list.list_programs", "List programs, what they call and who calls them."),
    "check": ("cli.check.check", "Find what would alarm or surprise, without running."),
    "compare": ("cli.compare.compare", "Compare two controls: where they differ, and why."),
    "diff": ("cli.compare.diff", "Compare two versions: what the new one does differently."),
    "flatten": ("cli.flatten.flatten", "Write one program without calls."),
    "resume": ("cli.resume.resume", "Start a run again in the middle."),
    "renumber": ("cli.editing.renumber", "Give blocks new numbers, with all that names them."),
    "format": ("cli.editing.format_files", "Lay out blocks alike: blanks, loops, capitals."),
    "coverage": ("cli.coverage.coverage", "Show which blocks and branches ran."),
    "report": ("cli.report.report", "Write a run as one page of HTML."),
    "plot": ("cli.plot.plot", "Draw the path of a run as one page of HTML."),
    "controls": ("cli.controls.controls", "List the controls, or show what is known of one."),
    "ask": ("cli.ask.ask", "Print programs that settle what no source says of a control."),
    "explain": ("cli.explain.explain", "Explain an alarm or a rule, with the cure."),
    "debug": ("cli.debug.debug", "Debug a program in the terminal."),
    "dap": ("cli.dap.dap", "Serve an editor that debugs programs (DAP)."),
    "lsp": ("editor.command.lsp", "Serve an editor: findings, definitions, hints."),
    "mcp": ("agents.command.mcp", "Serve an agent: run, check, explain, compare."),
    "batch": ("cli.batch.batch", "Run every program of some folders."),
    "gate": ("cli.gate.gate", "Let the output of a post processor pass, or not."),
}
LOOK: dict[str, Any] = {
    "pretty_exceptions_enable": False,
    "rich_markup_mode": None,
}


class OneLineGroup(typer.core.TyperGroup):
    """A group that reports wrong use in one line on the error stream, never with a traceback. The
    exit status is then 2.
    """

    def main(self, *args: Any, **options: Any) -> Any:
        options["standalone_mode"] = False
        system.write_what_can_be()
        try:
            status = super().main(*args, **options)
            sys.stdout.flush()
        except (Exception, KeyboardInterrupt) as error:
            sys.exit(_status_after(error))
        sys.exit(status if isinstance(status, int) else 0)

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        if args and not args[0].startswith("-") and args[0] not in COMMANDS:
            known = did_you_mean(args[0], COMMANDS, f"; there are {', '.join(COMMANDS)}")
            lead = f"; to run it: cncsub run {args[0]}" if Path(args[0]).exists() else known
            raise WrongUseError(f"there is no command {args[0]!r}{lead}")
        return super().resolve_command(ctx, args)

    def list_commands(self, ctx: Any) -> list[str]:
        return list(COMMANDS)

    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        if cmd_name not in COMMANDS:
            return None
        place, told = COMMANDS[cmd_name]
        module, _, function = place.rpartition(".")
        alone = typer.Typer(add_completion=False, **LOOK)
        alone.command(cmd_name, short_help=told)(
            getattr(import_module(f"cncsub.{module}"), function)
        )
        return _each_option_once(typer.main.get_command(alone))


def _each_option_once(command: Any) -> Any:
    """Report an option that takes one value and is given twice: none is dropped in silence."""
    make = command.make_parser

    def make_parser(context: Any) -> Any:
        parser = make(context)
        parse = parser.parse_args

        def parse_args(args: list[str]) -> Any:
            told, rest, order = parse(args)
            given = Counter(
                max(each.opts, key=len)
                for each in order
                if each.param_type_name == "option" and not each.multiple and not each.is_flag
            )
            for name, times in given.items():
                if times > 1:
                    raise WrongUseError(f"{name} is given {times} times; give it once")
            return told, rest, order

        parser.parse_args = parse_args
        return parser

    command.make_parser = make_parser
    return command


def _status_after(error: BaseException) -> int:
    """Report in one line what ended a command, and return its exit status. A mistake of cncsub is
    raised again.
    """
    if isinstance(error, typer.Abort | KeyboardInterrupt) or interrupts.pressed():
        system.say_nothing_more()  # a full pipe that nobody reads would block it
        return interrupts.STATUS
    if system.nobody_reads(error):
        system.say_nothing_more()
        return 1
    if system.at_its_limit(error) or isinstance(error, OSError):
        system.say_nothing_more()
        _tell(_of_system(error))
        return 2 if _names_wrong_file(error) else NOT_DONE
    _tell(_one_line(error))
    return 2


def _names_wrong_file(error: BaseException) -> bool:
    """Return whether the error is about a named file that cannot be read or written."""
    named = isinstance(error, OSError) and error.filename is not None
    return named and not system.at_its_limit(error)


def _of_system(error: BaseException) -> str:
    if isinstance(error, MemoryError):
        return "this computer has too little memory"
    assert isinstance(error, OSError)
    return told_of(error) if error.filename is not None else f"standard output: {told_of(error)}"


def _tell(words: str) -> None:
    with contextlib.suppress(OSError):  # the error stream may be full, too
        typer.echo(f"cncsub: {shown(words)}", err=True)


def _one_line(error: BaseException) -> str:
    """Return the words for wrong use; raise any other exception again."""
    # typer reports what is wrong with a command line by this method, whatever the class.
    words = getattr(error, "format_message", None)
    if words is None and not isinstance(error, WrongUseError):
        raise error
    told = " ".join(str(words() if words else error).split())
    context = getattr(error, "ctx", None)
    of_none = context is not None and context.parent is None
    if of_none and getattr(error, "option_name", None) and not getattr(error, "possibilities", 0):
        told += "; options follow the command: cncsub run part.nc -c fanuc-0i-f"
    return told


app = typer.Typer(cls=OneLineGroup, name="cncsub", **LOOK)


def _print_version(asked: bool) -> None:
    if asked:
        typer.echo(f"cncsub {cncsub.__version__}")
        raise typer.Exit


FIRST_STEPS = """\
First steps:

  cncsub controls                      all controls
  cncsub run part.nc -c fanuc-0i-f     its calls and how it stopped
  cncsub check part.nc -c fanuc-0i-f   what would alarm or surprise
  cncsub list folder/ -c fanuc-0i-f    the programs and their calls
  cncsub explain PS0076                an alarm and its cure

CNCSUB_CONTROL=fanuc-0i-f, or a cncsub.toml beside the programs, names the
control for them all."""


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
    """Run the command `cncsub`."""
    interrupts.answer_in_time()
    try:
        app(prog_name="cncsub")
    except (SystemExit, KeyboardInterrupt):
        interrupts.end()
        raise
