"""The options of a run, each stated once, and the engine made with them.

`Library.run`, `mdi`, `machine`, `stream`, `flatten`, `compare`, `translate`, `run_many`, the
commands and their documentation take the options from here: the name, type, default, meaning and
check of each.
"""

# The annotations are values here: no `from __future__ import annotations`.

import inspect
import textwrap
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache
from typing import Annotated, Any, NamedTuple, TypedDict, TypeVar, Unpack

from cncsub import _core
from cncsub.controls import did_you_mean
from cncsub.inputs import (
    Inputs,
    Number,
    Values,
    by_number,
    checked_variables,
    checked_watch,
    inputs_by_number,
    inputs_of,
    number_of,
)
from cncsub.option_errors import carrying
from cncsub.setup import Setup, setup_of
from cncsub.signatures import with_options

F = TypeVar("F", bound=Callable[..., Any])

MODES = ("auto", "mdi")
TRACES = ("none", "calls", "blocks", "moves")


class Option(NamedTuple):
    """The facts of an option beside its name and its type.

    `default`: the value without it. `checked`: returns what the engine takes for a value; raises
    `TypeError` or `ValueError`. `meaning`: sentences for its documentation. `asked`: what the
    commands say of the option, where they have it under its own name; `least`: the least value they
    take.
    """

    default: Any
    checked: Callable[[Any], object]
    meaning: str
    asked: str | None = None
    least: int | None = None


# ---- how values are checked ----


def whole(what: str, value: object, least: int) -> int:
    if isinstance(value, bool) or not hasattr(value, "__index__"):
        raise TypeError(f"{what} must be a whole number, not {value!r}")
    number = int(value)
    if not least <= number < 2**63:
        raise ValueError(
            f"{what} must be at least {least}, not {number}"
            if number < least
            else f"{what} is too large"
        )
    return number


def _whole(what: str, least: int) -> Callable[[Any], int]:
    return lambda value: whole(what, value, least)


def _none_or(checked: Callable[[Any], object]) -> Callable[[Any], object]:
    return lambda value: None if value is None else checked(value)


def _one_of(what: str, known: Sequence[str]) -> Callable[[Any], str]:
    def checked(value: object) -> str:
        if value not in known:
            raise ValueError(f"{what} must be one of {', '.join(known)}, not {value!r}")
        return str(value)

    return checked


def _yes_or_no(what: str) -> Callable[[Any], bool]:
    def checked(value: object) -> bool:
        if isinstance(value, str | bytes) or not hasattr(value, "__bool__") or value not in (0, 1):
            raise TypeError(f"{what} must be True or False, not {value!r}")
        return bool(value)

    return checked


def _seconds(value: Any) -> float:
    if isinstance(value, bool) or not (hasattr(value, "__float__") or hasattr(value, "__index__")):
        raise TypeError(f"max_seconds must be a number of seconds, not {value!r}")
    try:
        seconds = float(value)
    except OverflowError:
        seconds = 0.0
    if not 0 < seconds < 1e300:
        raise ValueError(f"max_seconds must be more than 0 and finite, not {value!r}")
    return seconds


def switches(block_skip: object) -> tuple[int, ...]:
    if isinstance(block_skip, bool):
        return (1,) if block_skip else ()
    if hasattr(block_skip, "__index__"):
        block_skip = (block_skip,)
    if isinstance(block_skip, str | bytes) or not isinstance(block_skip, Iterable):
        raise TypeError(
            "block_skip must be the numbers of the switches that are on, such as (1,),"
            f" not {block_skip!r}"
        )
    switches = tuple(whole("block_skip", switch, 1) for switch in block_skip)
    if any(switch > 10 for switch in switches):
        raise ValueError(f"block_skip: a block-skip switch must be 1 to 10, not {max(switches)}")
    return switches


def _variables(values: object) -> dict[Number, float | None]:
    return checked_variables("variables", values)


# ---- the options ----


class FlattenOptions(TypedDict, total=False):
    """The options of `Library.flatten`: those of `Library.run` but `mode`, `trace`, `watch` and
    `conditions`.
    """

    start: Annotated[
        int | None,
        Option(
            None,
            _none_or(_whole("start, a sequence number,", 0)),
            "The sequence number to start at, in the modes of power-on: `Library.resume` starts in"
            " those of the run.",
            asked="The sequence number to start at, in the modes of power-on (`cncsub resume`"
            " starts in those of the run).",
        ),
    ]
    variables: Annotated[
        Values | None,
        Option(
            None,
            _none_or(_variables),
            "The values of variables before the run, by number or as programs of the control write"
            ' them, `{"R5": 3}`; `None` is vacant.',
        ),
    ]
    block_skip: Annotated[
        Iterable[int] | int,
        Option((), switches, "The block-skip switches 1 to 10 that are on."),
    ]
    optional_stop: Annotated[
        bool,
        Option(False, _yes_or_no("optional_stop"), "Whether M01 stops.", asked="M01 stops."),
    ]
    max_cycles: Annotated[
        int,
        Option(
            1,
            _whole("max_cycles", 1),
            "How often a main program that ends in M99 runs; then the run ends with a `Stop`.",
            asked="How often a main program that ends in M99 runs.",
            least=1,
        ),
    ]
    max_blocks: Annotated[
        int,
        Option(
            10_000_000,
            _whole("max_blocks", 0),
            "How many blocks are executed at most; at the limit the run ends with a `Stop`.",
            asked="How many blocks are executed at most.",
            least=0,
        ),
    ]
    max_seconds: Annotated[
        float | None,
        Option(
            None,
            _none_or(_seconds),
            "How many seconds the computer may take; at the limit the run ends with a `Stop`.",
        ),
    ]
    max_memory: Annotated[
        int | None,
        Option(
            None,
            _none_or(_whole("max_memory", 0)),
            "How many bytes the tables and messages may take, 4 GiB if it is not given; at the"
            " limit the run ends with a `Stop`.",
        ),
    ]
    inputs: Annotated[
        Inputs | Mapping[str, Any] | None,
        Option(None, inputs_of, "What the program reads from outside while it runs: see `Inputs`."),
    ]
    setup: Annotated[
        Setup | Mapping[str, Any] | None,
        Option(None, setup_of, "The settings of the machine before the run: see `Setup`."),
    ]


class MdiOptions(FlattenOptions, total=False):
    """The options of `Library.mdi`, `compare` and `run_many`: those of `Library.run` but `mode`."""

    trace: Annotated[
        str,
        Option(
            "moves",
            _one_of("trace", TRACES),
            'What is recorded: `"none"`, `"calls"`, `"blocks"` or `"moves"`.',
        ),
    ]
    watch: Annotated[
        Iterable[int | str] | int | str,
        Option(
            (),
            checked_watch,
            "The numbers or names of at most a thousand variables whose changes are recorded in"
            " `Run.watch`. Each takes some time after every block, and 24 bytes for each change.",
        ),
    ]
    conditions: Annotated[
        bool,
        Option(
            False,
            _yes_or_no("conditions"),
            "Whether the values that conditions compare are recorded in `Run.conditions`, with 32"
            " bytes for each comparison.",
        ),
    ]


class RunOptions(MdiOptions, total=False):
    """The options of `Library.run`, `machine` and `stream`, for whoever hands them on:

    >>> import cncsub
    >>> from typing import Unpack
    >>> def carefully(library: cncsub.Library, **options: Unpack[cncsub.RunOptions]) -> cncsub.Run:
    ...     return library.run(**{"max_blocks": 1000, "max_seconds": 1.0, **options})
    """

    mode: Annotated[
        str,
        Option("auto", _one_of("mode", MODES), '`"auto"`, or `"mdi"` as a text that was typed.'),
    ]


@cache
def stated(of: type = RunOptions) -> dict[str, Option]:
    """Return the facts of each of the options, in their order."""
    return {name: kind.__metadata__[0] for name, kind in of.__annotations__.items()}


@cache
def _by_default() -> dict[str, object]:
    return {name: option.checked(option.default) for name, option in stated().items()}


def check_names(function: str, options: Mapping[str, object], of: type = RunOptions) -> None:
    """Raise `TypeError` for an option that the function does not have."""
    known = stated(of)
    for name in options:
        if name not in known:
            raise TypeError(
                f"{function} has no option {name!r}, only those of run{did_you_mean(name, known)}"
            )


def takes(
    of: type, *without: str, defaults: Mapping[str, Any] | None = None, told: bool = False
) -> Callable[[F], F]:
    """Return a decorator that shows each of the options in the signature in place of `**options`,
    with its default unless `defaults` has another. Where it is `told`, the help of the function
    says what each option means.
    """
    others = defaults or {}

    def shown(function: F) -> F:
        options = {name: option for name, option in stated(of).items() if name not in without}
        with_options(
            function,
            [
                inspect.Parameter(
                    name,
                    inspect.Parameter.KEYWORD_ONLY,
                    default=others.get(name, option.default),
                    annotation=of.__annotations__[name].__origin__,
                )
                for name, option in options.items()
            ],
        )
        if told:
            lines = (f"`{name}`: {option.meaning}" for name, option in options.items())
            words = "\n".join(textwrap.fill(line, 92, subsequent_indent="    ") for line in lines)
            function.__doc__ = f"{inspect.cleandoc(function.__doc__ or '')}\n\nOptions:\n\n{words}"
        return function

    return shown


# The options whose variables may be named, and what turns the names into numbers.
_NAMED: Mapping[str, Callable[[_core.Control, Any], Any]] = {
    "variables": lambda control, values: values and by_number("variables", control, values),
    "watch": lambda control, names: [number_of("watch", control, name) for name in names],
    "inputs": inputs_by_number,
}


def machine_with(code: _core.Code, main: int, **options: Unpack[RunOptions]) -> _core.Machine:
    """Return the engine with checked options; `main` is the number of the program, -1 the last. An
    error carries the name of the option as `.option`.
    """
    known, checked = stated(), dict(_by_default())
    for name, value in options.items():
        try:
            checked[name] = known[name].checked(value)
        except (TypeError, ValueError) as error:
            raise carrying(name, error) from None
    for name, numbered in _NAMED.items():
        try:
            checked[name] = numbered(code.control, checked[name])
        except ValueError as error:
            raise carrying(name, error) from None
    return _core.machine(code, main if main >= 0 else len(code) - 1, **checked)


def idle_machine(control: _core.Control, **options: Unpack[RunOptions]) -> _core.Machine:
    """Return a machine of a control without programs, which has executed nothing."""
    return machine_with(_core.compile(control, [], False).with_mdi(""), -1, **options)
