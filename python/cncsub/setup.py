"""What was set at the machine before the run: zero points, offsets, tools, rapid rates, travel
limits.
"""

from __future__ import annotations

import dataclasses
import os
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from cncsub.controls import did_you_mean

AXES = "XYZABCUVW"
MACHINES = ("mill", "lathe-a", "lathe-b")

_SYSTEM = re.compile(r"EXT|G5[4-9]|G54\.1 P[1-9][0-9]{0,2}")
_TOOL_KEYS = ("X", "Y", "Z", "R", "tip")

Point = Mapping[str, float]


@dataclass(frozen=True, kw_only=True)
class Setup:
    """The state of the machine before the run. Lengths in mm, X of a lathe as a diameter.

    `machine`: `"mill"`, `"lathe-a"` or `"lathe-b"` (G-code system A or B); `None` is what the
    control is by itself. `start`: where the tool stands, in work coordinates. `work_offsets`: zero
    points by `"G54"` to `"G59"`, `"EXT"` and `"G54.1 P1"`. `length_offsets`, `radius_offsets`: by H
    and by D. `tools`: a lathe's tool offsets by number, each with `"X"`, `"Z"`, `"R"` (nose radius)
    and `"tip"` (0 to 9). `reference`: reference points in machine coordinates, 1 is that of G28.
    `rapid`: mm/min by axis. `limits`: lowest and highest machine coordinate by axis; without them
    nothing is limited. `increment`: the least input increment in mm.

    Raises `TypeError` and `ValueError` that name the field.

    >>> import cncsub
    >>> setup = cncsub.Setup(start={"X": 0, "Y": 0, "Z": 5}, work_offsets={"G54": {"X": 100}})
    >>> run = cncsub.loads("O1\\nN10 G0 X10.\\nN20 M30\\n", control="fanuc-0i-f").run(setup=setup)
    >>> float(run.moves.x[0]), float(run.moves.mx[0])
    (10.0, 110.0)
    """

    machine: str | None = None
    start: Point = field(default_factory=dict)
    work_offsets: Mapping[str, Point] = field(default_factory=dict)
    length_offsets: Mapping[int, float] = field(default_factory=dict)
    radius_offsets: Mapping[int, float] = field(default_factory=dict)
    tools: Mapping[int, Mapping[str, float]] = field(default_factory=dict)
    reference: Mapping[int, Point] = field(default_factory=dict)
    rapid: Point = field(default_factory=dict)
    limits: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    increment: float = 0.001

    def __post_init__(self) -> None:
        self.to_core()

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> Setup:
        """Read the fields from a TOML file; the numbers of offsets and tools are its keys.

            machine = "lathe-a"
            start = { X = 100, Z = 50 }
            [tools.1]
            X = 0.1
            R = 0.4
            tip = 3

        Raises `FileNotFoundError`, and `ValueError` with the file's name for anything that is no
        setup.
        """
        import tomllib

        name = os.fspath(path)
        if Path(path).exists() and not Path(path).is_file():
            raise ValueError(f"{name}: not a regular file")
        with Path(path).open("rb") as file:
            try:
                return setup_from(tomllib.load(file))
            except (ValueError, TypeError) as error:
                raise ValueError(f"{name}: {error}") from None
            except RecursionError:
                raise ValueError(f"{name}: nested too deep") from None

    def to_core(self) -> dict[str, Any]:
        """The setup as the engine takes it: only what was given, every name and number checked."""
        core: dict[str, Any] = {
            "start": _point("start", self.start),
            "work_offsets": {
                _system(name): _point(f"work_offsets[{name!r}]", point)
                for name, point in _mapping("work_offsets", self.work_offsets).items()
            },
            "length_offsets": _numbered("length_offsets", self.length_offsets, _number),
            "radius_offsets": _numbered("radius_offsets", self.radius_offsets, _number),
            "tools": _numbered("tools", self.tools, _tool),
            "reference": _numbered("reference", self.reference, _point),
            "rapid": _rapid(self.rapid),
            "limits": _limits(self.limits),
            "increment": _positive("increment", self.increment),
        }
        if self.machine is not None:
            core["machine"] = _machine(self.machine)
        return {name: value for name, value in core.items() if value not in ({}, None)}


def setup_of(setup: Setup | Mapping[str, Any] | None) -> dict[str, Any] | None:
    """What the engine takes for `setup=`: a `Setup`, or a mapping with the same keys."""
    if setup is None:
        return None
    if isinstance(setup, Setup):
        return setup.to_core()
    if not isinstance(setup, Mapping):
        raise TypeError(f"setup is a cncsub.Setup or a mapping, not {type(setup).__name__}")
    return setup_from(setup).to_core()


def setup_from(values: Mapping[str, Any]) -> Setup:
    known = [f.name for f in dataclasses.fields(Setup)]
    for key in values:
        if key not in known:
            near = did_you_mean(key, known, f"; there are {', '.join(known)}")
            raise ValueError(f"a setup has no {key!r}{near}")
    return Setup(**values)


def _machine(machine: object) -> str:
    if machine not in MACHINES:
        raise ValueError(f"machine is one of {', '.join(MACHINES)}, not {machine!r}")
    return str(machine)


def _mapping(what: str, values: object) -> Mapping[Any, Any]:
    if not isinstance(values, Mapping):
        raise TypeError(f"{what} is a mapping, not {type(values).__name__}")
    return values


def _number(what: str, value: object) -> float:
    if isinstance(value, bool | str):
        raise TypeError(f"{what} is a number, not {value!r}")
    try:
        number = float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        raise TypeError(f"{what} is a number, not {value!r}") from None
    if not abs(number) < 1e9:
        raise ValueError(f"{what} is out of range: {value!r}")
    return number


def _positive(what: str, value: object) -> float:
    number = _number(what, value)
    if number <= 0:
        raise ValueError(f"{what} must be more than 0, not {value!r}")
    return number


def _axis(what: str, axis: object) -> str:
    name = str(axis).upper()
    if len(name) != 1 or name not in AXES:
        raise ValueError(f"{what}: {axis!r} is no axis; the axes are {', '.join(AXES)}")
    return name


def _point(what: str, point: object) -> dict[str, float]:
    return {
        _axis(what, axis): _number(f"{what}[{axis!r}]", value)
        for axis, value in _mapping(what, point).items()
    }


def _system(name: object) -> str:
    system = re.sub(r"\s*P\s*", " P", str(name).upper().strip())
    if not _SYSTEM.fullmatch(system):
        raise ValueError(
            f"work_offsets: {name!r} is no work coordinate system;"
            " there are G54 to G59, EXT and G54.1 P1"
        )
    return system


def _numbered(what: str, values: object, read: Any) -> dict[int, Any]:
    checked = {}
    for key, value in _mapping(what, values).items():
        text = str(key)
        if not re.fullmatch(r"[0-9]{1,4}", text):
            raise ValueError(f"{what}: {key!r} is no number of an offset, tool or point")
        checked[int(text)] = read(f"{what}[{text}]", value)
    return checked


def _tool(what: str, tool: object) -> dict[str, float]:
    values = _mapping(what, tool)
    for key in values:
        if key not in _TOOL_KEYS:
            raise ValueError(f"{what} has no {key!r}; there are {', '.join(_TOOL_KEYS)}")
    numbers = {key: _number(f"{what}[{key!r}]", value) for key, value in values.items()}
    if numbers.get("tip", 0) not in range(10):
        raise ValueError(f"{what}: the tip is a direction 0 to 9, not {values['tip']!r}")
    return numbers


def _rapid(rapid: object) -> dict[str, float]:
    return {
        _axis("rapid", axis): _positive(f"rapid[{axis!r}]", value)
        for axis, value in _mapping("rapid", rapid).items()
    }


def _limits(limits: object) -> dict[str, tuple[float, float]]:
    checked = {}
    for axis, pair in _mapping("limits", limits).items():
        if isinstance(pair, str) or not hasattr(pair, "__len__") or len(pair) != 2:
            raise TypeError(
                f"limits[{axis!r}] is the lowest and the highest coordinate, not {pair!r}"
            )
        low, high = (_number(f"limits[{axis!r}]", value) for value in pair)
        if low > high:
            raise ValueError(f"limits[{axis!r}]: {low:g} is above {high:g}")
        checked[_axis("limits", axis)] = (low, high)
    return checked
