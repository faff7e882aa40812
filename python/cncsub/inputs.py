"""The answers of the world outside to a program: signals, the clock, the operator, another program,
the probe.
"""

from __future__ import annotations

import dataclasses
import math
import os
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime
from typing import Any

from cncsub import _core
from cncsub._core import Control
from cncsub.controls import did_you_mean
from cncsub.files import clean
from cncsub.option_errors import wrong_value
from cncsub.setup import checked_axis, from_toml
from cncsub.workpiece import Workpiece, skip_signal, workpiece_of

Number = int | str  # of a variable, or its name as programs write it: R5, $A_IN[3]
Values = Mapping[int, float | None] | Mapping[str, float | None] | Mapping[Number, float | None]
Skips = Sequence[float | Mapping[str, float] | None]

LARGEST_VALUE = 1e47  # that a variable takes from a program
ANSWERS = ("start", "stop")


@dataclass(frozen=True, kw_only=True)
class Inputs:
    """What a program reads from outside while it runs, given in advance: the same inputs give the
    same run.

    `signals`: values of the interface inputs by variable number, bits (`#1000`...) and words
    (`#1032`...), or by their names as programs of the control write them, `{"$A_IN[3]": 1}`, as
    everywhere in the inputs. `clock`: a `datetime` for `#3011` and `#3012`, or the milliseconds
    `#3001` counts from; `None` leaves all at 0. `operator`: one answer for each M00, M01 or `#3006`
    in order, `"start"` (cycle start) or `"stop"` (the run stops and waits); without it the operator
    always presses cycle start, with it the run waits when no answer is left. `writes`: what another
    program writes into variables while this one waits for them, one mapping for each wait; `(3,
    {500: 1})` is written only at the third wait. `None` makes a variable vacant. `skips`: where the
    first G31, the second and so on get their skip signal: a coordinate of the path, `{"X": 40.0}`
    (work coordinates as they are programmed), a fraction 0 to 1 of it (of its time for a G04 that a
    signal may end), or `None` for one that gets no signal. A list is for all such blocks, whichever
    signal they watch; a mapping has a list for each signal, 1 to 8: `{1: [{"X": 40}], 2: [None,
    {"Z": -3}]}`, for P of G31 and Q of G04, and the control says which signals these watch (rule
    `skip_signals`). G36 and G37, which measure a tool, watch `"XAE"`, `"YAE"` and `"ZAE"`.
    `workpiece`: what the blocks after the end of the list touch, see `Workpiece`; a G31 without an
    answer gets no signal. `answers`: what the machine does when a code is sent to it, signals and
    variables by number: `{"M117": {1004: 1}}`.

    Raises `TypeError` and `ValueError` for wrong values.

    >>> import cncsub
    >>> text = "O1\\nN10 IF[#500 EQ #0]GOTO 10\\nN20 #501=#500*2\\nN30 M30\\n"
    >>> library = cncsub.loads(text, control="fanuc-0i-f")
    >>> library.run().stop
    <Stop.WAITING: 'waiting'>
    >>> run = library.run(inputs=cncsub.Inputs(writes=[{500: 21}]))
    >>> run.stop, run.variables[501]
    (<Stop.END: 'end'>, 42.0)
    """

    signals: Mapping[int, float] | Mapping[str, float] = field(default_factory=dict)
    clock: datetime | float | None = None
    operator: Sequence[str] | None = None
    writes: Sequence[Values | tuple[int, Values]] = ()
    skips: Skips | Mapping[int | str, Skips] = ()
    workpiece: Workpiece | Mapping[str, Any] | None = None
    answers: Mapping[str, Values] = field(default_factory=dict)

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> Inputs:
        """Read the fields from a TOML file. In `skips`, `"never"` is `None`; open ends are
        `-inf` and `inf`.

            answers = { M117 = { 1004 = 1 } }
            [workpiece]
            stylus = 3
            solids = [
                { box = { X = [0, 80], Y = [0, 50], Z = [-20, 0] } },
                { cylinder = { X = 40, Y = 25 }, radius = 10, inside = true },
            ]

        Raises `FileNotFoundError`, and `ValueError` with the file's name for a file that holds no
        inputs.
        """
        return from_toml(path, inputs_from_table)

    def __post_init__(self) -> None:
        self.to_core()

    def to_core(self) -> dict[str, Any]:
        """Return the inputs as the engine takes them."""
        core: dict[str, Any] = {
            "signals": {
                k: 0.0 if v is None else v for k, v in _variables("signals", self.signals).items()
            },
            "writes": [
                write for entry in _listed("writes", self.writes) for write in _write(entry)
            ],
            "skips": _skips(self.skips),
            "answers": _answers(self.answers),
            **_clock(self.clock),
        }
        if self.operator is not None:
            core["operator"] = [_answer(answer) for answer in _listed("operator", self.operator)]
        if self.workpiece is not None:
            core["workpiece"] = workpiece_of(self.workpiece)
        return core


def inputs_of(inputs: Inputs | Mapping[str, Any] | None) -> dict[str, Any] | None:
    """Return what the engine takes for `inputs=`: an `Inputs`, or a mapping with the same keys."""
    if inputs is None:
        return None
    if isinstance(inputs, Inputs):
        return inputs.to_core()
    if not isinstance(inputs, Mapping):
        raise TypeError(f"inputs must be a cncsub.Inputs or a mapping, not {type(inputs).__name__}")
    return _inputs_from(inputs).to_core()


def _inputs_from(inputs: Mapping[str, Any]) -> Inputs:
    known = [f.name for f in dataclasses.fields(Inputs)]
    for key in inputs:
        if key not in known:
            near = did_you_mean(key, known, f"; there are {', '.join(known)}")
            words = f"inputs has no {key!r}{near}"
            raise wrong_value("inputs", words)
    return Inputs(**inputs)


def inputs_from_table(table: Mapping[str, Any]) -> Inputs:
    """Return the inputs of a file; raise `TypeError` and `ValueError` for what they are not."""
    return _inputs_from(values_of_table(table))


def values_of_table(table: Mapping[str, Any]) -> dict[str, Any]:
    """Return the fields of a file, whose keys are texts and which has no `None`."""
    values = dict(table)
    if isinstance(values.get("signals"), dict):
        values["signals"] = numbered(values["signals"])
    if isinstance(values.get("writes"), list):
        values["writes"] = [
            numbered(write)
            if isinstance(write, dict)
            else [numbered(part) if isinstance(part, dict) else part for part in write]
            if isinstance(write, list)
            else write
            for write in values["writes"]
        ]
    if isinstance(values.get("answers"), dict):
        values["answers"] = {
            code: numbered(answer) if isinstance(answer, dict) else answer
            for code, answer in values["answers"].items()
        }
    if isinstance(values.get("skips"), list):
        values["skips"] = _never(values["skips"])
    if isinstance(values.get("skips"), dict):
        values["skips"] = {
            signal: _never(skips) if isinstance(skips, list) else skips
            for signal, skips in numbered(values["skips"]).items()
        }
    return values


def _never(skips: list[Any]) -> list[Any]:
    return [None if skip == "never" else skip for skip in skips]


def numbered(values: dict[str, Any]) -> dict[Any, Any]:
    """Return the values with whole numbers for keys that are numbers: files have texts only."""
    return {int(key) if re.fullmatch(r"[0-9]{1,10}", key) else key: v for key, v in values.items()}


def checked_variables(what: str, values: object) -> dict[Number, float | None]:
    """Return variables by number or by their names, which `by_number` turns into numbers; `None` is
    vacant.
    """
    return _variables(what, values)


def number_of(what: str, control: Control, name: Number) -> int:
    """Return the number of a variable that programs of the control write so."""
    if not isinstance(name, str):
        return name
    number = _core.variable_number(control, clean(name))
    if number is None:
        raise ValueError(f"{what}: {control.name} has no variable {name!r}")
    return number


def by_number(what: str, control: Control, values: Values) -> dict[int, float | None]:
    """Return variables by number, of which some may be named as programs of the control do."""
    numbered: dict[int, float | None] = {}
    for name, value in values.items():
        number = number_of(what, control, name)
        if number in numbered:
            raise ValueError(f"{what}: {name!r} is given twice")
        numbered[number] = value
    return numbered


def inputs_by_number(control: Control, core: dict[str, Any] | None) -> dict[str, Any] | None:
    """Return the inputs for the engine with the numbers of signals and variables."""
    if core is None:
        return None
    answers = {c: by_number(f"answers[{c!r}]", control, v) for c, v in core["answers"].items()}
    return core | {
        "signals": by_number("signals", control, core["signals"]),
        "writes": [by_number("writes", control, write) for write in core["writes"]],
        "answers": answers,
    }


_MOST_WATCHED = 1000


def checked_watch(numbers: object) -> list[Number]:
    """Return the numbers or names of the variables to watch, each once."""
    if hasattr(numbers, "__index__") and not hasattr(numbers, "__iter__"):
        numbers = (numbers,)
    if isinstance(numbers, str | bytes) or not isinstance(numbers, Iterable):
        raise TypeError(
            f"watch must be a list of variable numbers such as [100, 500], not {numbers!r}"
        )
    checked: dict[Number, None] = {}
    for number in numbers:
        if is_name(number):
            checked[number] = None
            continue
        if isinstance(number, str):
            raise ValueError(f"watch: {number!r} is no variable that has a number")
        if not is_whole(number):
            raise TypeError(
                f"watch: a variable number must be a whole number such as 100, not {number!r}"
            )
        if not 0 <= int(number) < 2**31:
            raise ValueError(f"watch: there is no variable #{number}")
        checked[int(number)] = None
        if len(checked) > _MOST_WATCHED:
            raise ValueError(
                f"watch: at most {_MOST_WATCHED} variables can be watched in one run; give fewer"
            )
    return list(checked)


def is_name(text: object) -> bool:
    """Return whether a text may be a variable as programs write it: R5, #500, $A_IN[3]."""
    return isinstance(text, str) and re.match(r"\s*[#$A-Za-z].*[0-9]", text) is not None


def _variables(what: str, values: object) -> dict[Number, float | None]:
    if not isinstance(values, Mapping):
        raise TypeError(
            f"{what} must be a mapping from variable numbers to values, such as {{100: 23.34}},"
            f" not {type(values).__name__}"
        )
    checked: dict[Number, float | None] = {}
    for number, value in values.items():
        if isinstance(number, str) and is_name(number):
            checked[number] = _value(f"{what}: {number}", value)
            continue
        if not is_whole(number):
            raise TypeError(
                f"{what}: a variable number must be a whole number such as 100, not {number!r}"
            )
        if not 0 <= int(number) < 2**31:
            raise ValueError(f"{what}: there is no variable #{number} to give a value to")
        checked[int(number)] = _value(f"{what}: #{number}", value)
    return checked


def _value(what: str, value: object) -> float | None:
    """Return a number, or `None` for vacant."""
    if value is None:
        return None
    try:
        if isinstance(value, bool | str | bytes | bytearray):
            raise TypeError
        number = float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        raise TypeError(f"{what} must be a number or None (vacant), not {value!r}") from None
    if math.isnan(number):
        raise ValueError(f"{what} must be a number or None (vacant), not nan")
    if abs(number) > LARGEST_VALUE:
        raise ValueError(f"{what} must be a number up to {LARGEST_VALUE:g}, not {value!r}")
    return number


def is_whole(number: object) -> bool:
    """Return whether this is an integer of Python or NumPy, and not a bool."""
    return hasattr(number, "__index__") and not isinstance(number, bool)


def _listed(what: str, values: object) -> Sequence[Any]:
    if isinstance(values, str | bytes | Mapping) or not isinstance(values, Sequence):
        raise TypeError(f"{what} must be a list, not {type(values).__name__}")
    return values


def _write(entry: object) -> list[dict[Number, float | None]]:
    if isinstance(entry, Mapping):
        return [_variables("writes", entry)]
    if not isinstance(entry, tuple | list) or len(entry) != 2 or not is_whole(entry[0]):
        raise TypeError(
            "writes must have mappings such as {500: 1} or pairs such as (3, {500: 1}),"
            f" not {entry!r}"
        )
    if not 1 <= entry[0] <= 1_000_000:
        raise ValueError(f"writes: {entry[0]} is not the number of a wait; the first wait is 1")
    return [*({} for _ in range(entry[0] - 1)), _variables("writes", entry[1])]


def _answer(answer: object) -> str:
    if answer not in ANSWERS:
        raise ValueError(f"operator must be 'start' or 'stop', not {answer!r}")
    return str(answer)


def _skips(skips: object) -> dict[int, list[tuple[str, float]]]:
    """Return the skips of each signal; 0 stands for any signal."""
    if not isinstance(skips, Mapping):
        return {0: [_skip(f"skips[{i}]", skip) for i, skip in enumerate(_listed("skips", skips))]}
    return {
        skip_signal("skips", signal): [
            _skip(f"skips[{signal}][{i}]", skip)
            for i, skip in enumerate(_listed(f"skips[{signal}]", told))
        ]
        for signal, told in skips.items()
    }


def _skip(where: str, skip: object) -> tuple[str, float]:
    """Return where a skip signal comes: `("fraction", 0.5)`, `("X", 40.0)` or `("never", 0.0)`."""
    if skip is None:
        return "never", 0.0
    if isinstance(skip, Mapping):
        if len(skip) != 1:
            raise ValueError(
                f'{where} must be the coordinate of one axis, {{"X": 40.0}}, not {skip!r}'
            )
        ((axis, coordinate),) = skip.items()
        name = checked_axis(where, axis)
        value = _value(f"{where}: {name}", coordinate)
        if value is None:
            raise ValueError(f"{where}: {name} has no coordinate")
        return name, value
    takes = f'{where} must be a fraction of the move, a coordinate such as {{"X": 40.0}}, or None'
    try:
        value = _value(where, skip)
    except TypeError:
        raise TypeError(f"{takes}, not {skip!r}") from None
    if value is None or not 0 <= value <= 1:
        raise ValueError(f"{takes}; a fraction must be 0 to 1, not {skip!r}")
    return "fraction", value


def _answers(answers: object) -> dict[str, dict[Number, float | None]]:
    if not isinstance(answers, Mapping):
        raise TypeError(
            f'answers must be a mapping from codes to variables, such as {{"M117": {{1004: 1}}}},'
            f" not {type(answers).__name__}"
        )
    checked: dict[str, dict[Number, float | None]] = {}
    for code, values in answers.items():
        match = re.fullmatch(r"([MT])0*([0-9]{1,9})", str(code).strip().upper())
        if match is None:
            raise ValueError(f"answers: {code!r} is not an M or T code such as 'M117'")
        name = f"{match[1]}{match[2]}"
        if name in checked:
            raise ValueError(f"answers has {name} twice, also as {code!r}")
        checked[name] = _variables(f"answers[{code!r}]", values)
    return checked


def _clock(clock: datetime | float | None) -> dict[str, float | int]:
    if clock is None:
        return {}
    if isinstance(clock, datetime):
        return {
            "date": clock.year * 10_000 + clock.month * 100 + clock.day,
            "time": clock.hour * 10_000 + clock.minute * 100 + clock.second,
        }
    milliseconds = _value("clock, a datetime or a number of milliseconds,", clock)
    if milliseconds is None or not 0 <= milliseconds < 2**53:
        raise ValueError(f"clock must be milliseconds from 0, not {clock!r}")
    return {"clock_ms": milliseconds}
