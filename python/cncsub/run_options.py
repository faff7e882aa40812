"""The options of a run: their names and types, and the engine made with them once they are
checked.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, TypedDict, Unpack

from cncsub import _core
from cncsub.controls import did_you_mean
from cncsub.inputs import Inputs, checked_variables, checked_watch, inputs_of
from cncsub.setup import Setup, setup_of

MODES = ("auto", "mdi")
TRACES = ("none", "calls", "blocks", "moves")


class Options(TypedDict, total=False):
    """The options of `Library.run` but `main` and `mode`."""

    start: int | None
    variables: Mapping[int, float | None] | None
    block_skip: Iterable[int] | int
    optional_stop: bool
    max_cycles: int
    max_blocks: int
    max_seconds: float | None
    max_memory: int | None
    trace: str
    inputs: Inputs | Mapping[str, Any] | None
    setup: Setup | Mapping[str, Any] | None
    watch: Iterable[int] | int


class ModeOptions(Options, total=False):
    """The options of `Library.run` but `main`."""

    mode: str


def check_names(function: str, options: Mapping[str, object]) -> None:
    known = ModeOptions.__annotations__
    for name in options:
        if name not in known:
            raise TypeError(
                f"{function} has no option {name!r}{did_you_mean(name, known)};"
                " the options are those of run"
            )


def machine_with(
    code: _core.Code,
    main: int,
    *,
    mode: str = "auto",
    start: int | None = None,
    variables: Mapping[int, float | None] | None = None,
    block_skip: Iterable[int] | int = (),
    optional_stop: bool = False,
    max_cycles: int = 1,
    max_blocks: int = 10_000_000,
    max_seconds: float | None = None,
    max_memory: int | None = None,
    trace: str = "moves",
    inputs: Inputs | Mapping[str, Any] | None = None,
    setup: Setup | Mapping[str, Any] | None = None,
    watch: Iterable[int] | int = (),
) -> _core.Machine:
    """The engine with checked options; `main` is the number of the program, -1 the last."""
    return _core.machine(
        code,
        main if main >= 0 else len(code) - 1,
        mdi=_one_of("mode", mode, MODES) == "mdi",
        start=None if start is None else whole("start, a sequence number,", start, 0),
        variables=None if variables is None else checked_variables("variables", variables),
        block_skip=_switches(block_skip),
        optional_stop=_yes_or_no("optional_stop", optional_stop),
        max_cycles=whole("max_cycles", max_cycles, 1),
        max_blocks=whole("max_blocks", max_blocks, 0),
        max_seconds=None if max_seconds is None else _seconds(max_seconds),
        max_memory=None if max_memory is None else whole("max_memory", max_memory, 0),
        trace=_one_of("trace", trace, TRACES),
        inputs=inputs_of(inputs),
        setup=setup_of(setup),
        watch=checked_watch(watch),
    )


def idle_machine(control: _core.Control, **options: Unpack[Options]) -> _core.Machine:
    """A machine of a control without programs, which has executed nothing."""
    return machine_with(_core.compile(control, [], False).with_mdi(""), -1, **options)


def _one_of(what: str, value: object, known: Sequence[str]) -> str:
    if value not in known:
        raise ValueError(f"{what} is one of {', '.join(known)}, not {value!r}")
    return str(value)


def whole(what: str, value: object, least: int) -> int:
    if isinstance(value, bool) or not hasattr(value, "__index__"):
        raise TypeError(f"{what} is a whole number, not {value!r}")
    number = int(value)
    if not least <= number < 2**63:
        raise ValueError(
            f"{what} is at least {least}, not {number}"
            if number < least
            else f"{what} is too large"
        )
    return number


def _yes_or_no(what: str, value: object) -> bool:
    if isinstance(value, str | bytes) or not hasattr(value, "__bool__") or value not in (0, 1):
        raise TypeError(f"{what} is True or False, not {value!r}")
    return bool(value)


def _seconds(value: object) -> float:
    if isinstance(value, bool) or not (hasattr(value, "__float__") or hasattr(value, "__index__")):
        raise TypeError(f"max_seconds is a number of seconds, not {value!r}")
    try:
        seconds = float(value)  # type: ignore[arg-type]
    except OverflowError:
        seconds = 0.0
    if not 0 < seconds < 1e300:
        raise ValueError(f"max_seconds must be more than 0 and finite, not {value!r}")
    return seconds


def _switches(block_skip: object) -> tuple[int, ...]:
    if isinstance(block_skip, bool):
        return (1,) if block_skip else ()
    if hasattr(block_skip, "__index__"):
        block_skip = (block_skip,)
    if isinstance(block_skip, str | bytes) or not isinstance(block_skip, Iterable):
        raise TypeError(
            "block_skip holds the numbers of the switches that are on, such as (1,),"
            f" not {block_skip!r}"
        )
    switches = tuple(whole("block_skip", switch, 1) for switch in block_skip)
    if any(switch > 9 for switch in switches):
        raise ValueError(f"block_skip: the block-skip switches are 1 to 9, not {max(switches)}")
    return switches
