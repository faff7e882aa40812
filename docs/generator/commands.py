"""The command line, from the commands themselves."""

from __future__ import annotations

from typing import Any

import typer.main

from cncsub import cli
from generator.markdown import code, fenced, table, words

_PAGE = "reference/commands.md"

_HEAD = """\
# The command line

[Running programs](../guides/running.md) says what the commands are for, and what the exit status
means. `cncsub COMMAND --help` prints the same.

"""


def names() -> list[str]:
    return [_PAGE]


def pages() -> dict[str, str]:
    group: Any = typer.main.get_command(cli.app)
    commands = {name: group.get_command(None, name) for name in group.list_commands(None)}
    rows = (
        [f"[cncsub {name}](#cncsub-{name})", words(command.get_short_help_str(limit=400))]
        for name, command in commands.items()
    )
    text = _HEAD + table(("command", "does"), rows) + "\n"
    for name, command in commands.items():
        text += f"## cncsub {name}\n\n{words(' '.join((command.help or '').split()))}\n\n"
        text += fenced("text", _usage(name, command)) + "\n"
        text += table(("option", "what it is"), map(_option, _options(command))) + "\n"
    return {_PAGE: text}


def _usage(name: str, command: Any) -> str:
    arguments = [p for p in command.params if p.param_type_name == "argument"]
    named = "".join(
        f" [{p.human_readable_name}]{'...' if p.nargs == -1 else ''}" for p in arguments
    )
    return f"cncsub {name} [OPTIONS]{named}"


def _options(command: Any) -> list[Any]:
    return [p for p in command.params if p.param_type_name == "option"]


def _option(option: Any) -> list[str]:
    named = ", ".join(code(name) for name in (*option.opts, *option.secondary_opts))
    if not option.is_flag and option.metavar:
        named += f" {code(option.metavar)}"
    told = [option.help or ""]
    choices = getattr(option.type, "choices", None)
    if choices:
        told.append("One of " + ", ".join(f"`{getattr(c, 'value', c)}`" for c in choices) + ".")
    default = option.default
    if not option.is_flag and default not in (None, (), []) and not callable(default):
        told.append(f"Without it: `{getattr(default, 'value', default)}`.")
    return [named, words(" ".join(filter(None, told)))]
