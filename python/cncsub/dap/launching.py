"""What a launch configuration asks for, as the options of the command line."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from cncsub.controls import did_you_mean
from cncsub.dap.arguments import Arguments, RequestError

# The options of the command line that are texts; and others by the names of a launch configuration.
_TEXTS = ("control", "main", "setup", "inputs", "external", "encoding")
_NUMBERS = {"start": "start", "maxBlocks": "max_blocks", "maxCycles": "max_cycles"}
_FLAGS = {"optionalStop": "optional_stop"}
_OWN = ("program", "programs", "variables", "parameters", "blockSkip", "prefer", "stopOnEntry",
        "stopOnEnd", "noDebug")  # fmt: skip
KEYS = frozenset((*_TEXTS, *_NUMBERS, *_FLAGS, *_OWN))  # all that a configuration may have
# What editors add to every configuration.
_OF_EDITORS = frozenset(
    ("type", "request", "name", "cwd", "presentation", "preLaunchTask", "postDebugTask",
     "internalConsoleOptions", "debugServer", "serverReadyAction", "console", "windows", "linux",
     "osx", "restart", "suppressMultipleSessionWarning", "debugPort", "host", "port", "env",
     "dap-server-path", "program-to-start", "wait-for-port", "hostName", "mode",
     "environment-variables", "skip-debug-session", "startup-function", "output-filter-function",
     "launch-args", "cleanup-function"),
)  # fmt: skip


@dataclass(frozen=True)
class Launch:
    """A launch configuration. `options` are those of the command line; `unknown` says which names
    mean nothing, and what may have been meant.
    """

    options: Mapping[str, Any]
    stop_on_entry: bool = False
    stop_on_end: bool = False
    debug: bool = True
    unknown: tuple[str, ...] = ()


def launch_of(arguments: Arguments) -> Launch:
    """Return what a configuration asks for. Raises `RequestError` for a value of a wrong type."""
    options: dict[str, Any] = {"paths": _paths(arguments)}
    for name in _TEXTS:
        options[name] = arguments.text(name, None)
    for name, option in _NUMBERS.items():
        if (number := arguments.number(name, None)) is not None:
            options[option] = number
    for name, option in _FLAGS.items():
        options[option] = arguments.flag(name)
    options.update(_variables(arguments))
    options["param"] = _pairs(arguments, "parameters")
    options["skip"] = _numbers(arguments, "blockSkip")
    options["prefer"] = _texts(arguments, "prefer")
    return Launch(
        options,
        arguments.flag("stopOnEntry"),
        arguments.flag("stopOnEnd"),
        not arguments.flag("noDebug"),
        tuple(_unknown(arguments)),
    )


def _unknown(arguments: Arguments) -> list[str]:
    return [
        f"{name!r} means nothing in a launch configuration{did_you_mean(name, sorted(KEYS))}"
        for name in arguments.given
        if name not in KEYS and name not in _OF_EDITORS and not name.startswith("_")
    ]


def _paths(arguments: Arguments) -> list[str]:
    """Return the files and folders of the programs; without any the project's are read."""
    one = [] if arguments.given.get("program") is None else [arguments.text("program")]
    paths = [*one, *_texts(arguments, "programs")]
    for path in paths:
        if path in ("", "-"):
            raise RequestError(f"program must name a file or a folder, not {path!r}")
    return paths


def _texts(arguments: Arguments, name: str) -> list[str]:
    given = arguments.given.get(name)
    values = [given] if isinstance(given, str) else arguments.sequence(name, [])
    for value in values:
        if not isinstance(value, str):
            raise RequestError(f"{name} must be a list of texts, not {value!r}")
    return values


def _numbers(arguments: Arguments, name: str) -> list[int]:
    given = arguments.given.get(name)
    values = [given] if isinstance(given, int) and not isinstance(given, bool) else None
    values = arguments.sequence(name, []) if values is None else values
    for value in values:
        if isinstance(value, bool) or not isinstance(value, int):
            raise RequestError(f"{name} must be a list of whole numbers, not {value!r}")
    return values


def _variables(arguments: Arguments) -> dict[str, Any]:
    """Return the variables before the run: of a file, or given as `{"100": 23.34}`."""
    if isinstance(arguments.given.get("variables"), str):
        return {"variables": arguments.text("variables"), "set": []}
    return {"variables": None, "set": _pairs(arguments, "variables")}


def _pairs(arguments: Arguments, name: str) -> list[str]:
    values = arguments.table(name, {}).given
    for key, value in values.items():
        if value is not None and (isinstance(value, bool) or not isinstance(value, int | float)):
            raise RequestError(f"{name} must give numbers, not {value!r} for {key!r}")
    return [f"{key}={'vacant' if value is None else value}" for key, value in values.items()]
