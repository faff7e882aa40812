"""The settings of the machine before the run: zero points, offsets, tools, rapid rates, travel
limits.
"""

from __future__ import annotations

import dataclasses
import os
import re
from collections.abc import Callable, Mapping, Set
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeVar

from cncsub.controls import did_you_mean

AXES = "XYZABCUVW"
MACHINES = ("mill", "lathe-a", "lathe-b")

SMALLEST = 1e-9  # the least of what must be more than 0: a rapid rate, an increment
REFERENCES = 4  # G28 and G30 P2 to P4

# A key of n parts takes TOML a time of n squared.
_DEEP = re.compile(r"(?:\.[^.,=\[\]{}#\n]{0,80}){100}")
_SYSTEM = re.compile(
    r"EXT|G5[4-9]|G54\.1 P([1-9][0-9]?|[12][0-9]{2}|300)|G500|G5(0[5-9]|[1-9][0-9])"
)
_EDGE_KEYS = ("X", "Y", "Z", "R", "tip")
_TOOL_KEYS = (*_EDGE_KEYS, "name", "edges")  # the last two where D is an edge of the tool
_MOST_EDGES = 12  # [general knowledge of the SINUMERIK 840D]

Point = Mapping[str, float]
T = TypeVar("T")


@dataclass(frozen=True, kw_only=True)
class Setup:
    """The state of the machine before the run. Lengths in mm, X of a lathe as a diameter.

    `machine`: `"mill"`, `"lathe-a"` or `"lathe-b"` (G-code system A or B); `None` is the type of
    the control. `start`: where the tool is, in work coordinates. `work_offsets`: zero points by
    `"G54"` to `"G59"`, `"EXT"`, `"G54.1 P1"`, and on a SINUMERIK `"G505"` to `"G599"`.
    `length_offsets`, `radius_offsets`: by H and by D, or by T where D is an edge of the tool.
    `tools`: a lathe's tool offsets by number, each with `"X"`, `"Z"`, `"R"` (nose radius) and
    `"tip"` (0 to 9); where D is an edge of the tool, the lengths and the radius of tool T, its
    `"name"`, by which `T="MILL_10"` calls it, and the same of its other edges, `"edges"` by number
    from 2 on.
    `reference`: reference points 1 to 4 in machine coordinates, 1 is that of G28. `rapid`: mm/min
    by axis. `limits`: lowest and highest machine coordinate by axis; without them nothing is
    limited. `stroke_area`: the same for the area of G22, before a program sets it. `increment`:
    the least input increment in mm.

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
    tools: Mapping[int, Mapping[str, Any]] = field(default_factory=dict)
    reference: Mapping[int, Point] = field(default_factory=dict)
    rapid: Point = field(default_factory=dict)
    limits: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    stroke_area: Mapping[str, tuple[float, float]] = field(default_factory=dict)
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

        Raises `FileNotFoundError`, and `ValueError` with the file's name for a file that holds no
        setup.
        """
        return from_toml(path, setup_from)

    def to_core(self) -> dict[str, Any]:
        """Return the setup as the engine takes it: only what was given, every name and number
        checked.
        """
        core: dict[str, Any] = {
            "start": _point("start", self.start),
            "work_offsets": _checked("work_offsets", self.work_offsets, work_system, _point),
            "length_offsets": _checked(
                "length_offsets", self.length_offsets, _offset, checked_number
            ),
            "radius_offsets": _checked(
                "radius_offsets", self.radius_offsets, _offset, checked_number
            ),
            "tools": _checked("tools", self.tools, _offset, _tool),
            "reference": _checked("reference", self.reference, _reference, _point),
            "rapid": _checked("rapid", self.rapid, checked_axis, _positive),
            "limits": _checked("limits", self.limits, checked_axis, _limit),
            "stroke_area": _checked("stroke_area", self.stroke_area, checked_axis, _limit),
            "increment": _positive("increment", self.increment),
        }
        if self.machine is not None:
            core["machine"] = _machine(self.machine)
        return {name: value for name, value in core.items() if value not in ({}, None)}


def toml_of(text: str) -> dict[str, Any]:
    """Return what a text of TOML says; raise `RecursionError` where it nests too deep to
    be read.
    """
    import tomllib

    if _DEEP.search(text):
        raise RecursionError
    return tomllib.loads(text)


def from_toml(path: str | os.PathLike[str], read: Callable[[dict[str, Any]], T]) -> T:
    """Return what `read` makes of a TOML file; an error names the file."""
    name = os.fspath(path)
    if Path(path).exists() and not Path(path).is_file():
        raise ValueError(f"{name}: not a regular file")
    with Path(path).open("rb") as file:
        try:
            return read(toml_of(file.read().decode()))
        except OSError as error:  # a device that fails names no file
            raise OSError(error.errno, error.strerror, name) from None
        except (ValueError, TypeError) as error:
            raise ValueError(f"{name}: {error}") from None
        except RecursionError:
            raise ValueError(f"{name}: nested too deep") from None


def setup_of(setup: Setup | Mapping[str, Any] | None) -> dict[str, Any] | None:
    """Return what the engine takes for `setup=`: a `Setup`, or a mapping with the same keys."""
    if setup is None:
        return None
    if isinstance(setup, Setup):
        return setup.to_core()
    if not isinstance(setup, Mapping):
        raise TypeError(f"setup must be a cncsub.Setup or a mapping, not {type(setup).__name__}")
    return setup_from(setup).to_core()


def machine_of(setup: Setup | Mapping[str, Any] | None) -> str:
    """Return the kind of machine that a setup gives; empty for the control's own."""
    if setup is None:
        return ""
    told = setup.get("machine") if isinstance(setup, Mapping) else setup.machine
    return told or ""


def setup_from(values: Mapping[str, Any]) -> Setup:
    known = [f.name for f in dataclasses.fields(Setup)]
    for key in values:
        if key not in known:
            near = did_you_mean(key, known, f"; there are {', '.join(known)}")
            raise ValueError(f"a setup has no {key!r}{near}")
    return Setup(**values)


def _machine(machine: object) -> str:
    if machine not in MACHINES:
        raise ValueError(f"machine must be one of {', '.join(MACHINES)}, not {machine!r}")
    return str(machine)


def _mapping(what: str, values: object) -> Mapping[Any, Any]:
    if not isinstance(values, Mapping):
        raise TypeError(f"{what} must be a mapping, not {type(values).__name__}")
    return values


def _checked(
    what: str,
    values: object,
    key: Callable[[str, object], Any],
    value: Callable[[str, object], Any],
) -> dict[Any, Any]:
    """Return a mapping with checked keys and values; two ways to write the same key are
    an error.
    """
    checked: dict[Any, Any] = {}
    for written, given in _mapping(what, values).items():
        name = key(what, written)
        if name in checked:
            raise ValueError(f"{what} has {name} twice, also as {written!r}")
        checked[name] = value(f"{what}[{written!r}]", given)
    return checked


def checked_number(what: str, value: object) -> float:
    try:
        if isinstance(value, bool | str | bytes | bytearray):
            raise TypeError
        number = float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        raise TypeError(f"{what} must be a number, not {value!r}") from None
    if not abs(number) < 1e9:
        raise ValueError(f"{what} is out of range: {value!r}")
    return number


def _positive(what: str, value: object) -> float:
    number = checked_number(what, value)
    if number < SMALLEST:
        raise ValueError(f"{what} must be more than 0 (at least {SMALLEST:g}), not {value!r}")
    return number


def checked_axis(what: str, axis: object) -> str:
    name = axis.upper() if isinstance(axis, str) else ""
    if len(name) != 1 or name not in AXES:
        raise ValueError(f"{what}: {axis!r} is not an axis; the axes are {', '.join(AXES)}")
    return name


def _point(what: str, point: object) -> dict[str, float]:
    return _checked(what, point, checked_axis, checked_number)


def work_system(what: str, name: object) -> str:
    """Return the name of a work coordinate system in its full form: `g54.1p3` is `G54.1 P3`."""
    system = re.sub(r"\s*P\s*", " P", str(name).upper().strip())
    if not _SYSTEM.fullmatch(system):
        raise ValueError(
            f"{what}: {name!r} is not a work coordinate system;"
            " there are G54 to G59, EXT and G54.1 P1 to P300, on a SINUMERIK G500 and G505 to G599"
        )
    return system


def _offset(what: str, key: object) -> int:
    if not re.fullmatch(r"[0-9]{1,4}", str(key)):
        raise ValueError(f"{what}: {key!r} is not the number of an offset, tool or point")
    return int(str(key))


def _reference(what: str, key: object) -> int:
    number = _offset(what, key)
    if not 1 <= number <= REFERENCES:
        raise ValueError(f"{what}: the points must be 1 to {REFERENCES}, not {key!r}")
    return number


def _tool(what: str, tool: object) -> dict[str, Any]:
    values = dict(_mapping(what, tool))
    named: dict[str, Any] = {}
    if (name := values.pop("name", None)) is not None:
        if not isinstance(name, str) or not name.strip():
            raise TypeError(f"{what}['name'] must be a text, not {name!r}")
        named["name"] = name
    if (edges := values.pop("edges", None)) is not None:
        named["edges"] = _checked(f"{what}['edges']", edges, _edge_number, _edge)
    return {**_edge(what, values, _TOOL_KEYS), **named}


def _edge_number(what: str, key: object) -> int:
    number = _offset(what, key)
    if not 2 <= number <= _MOST_EDGES:
        raise ValueError(f"{what}: the edges must be 2 to {_MOST_EDGES}, not {key!r}")
    return number


def _edge(what: str, edge: object, keys: tuple[str, ...] = _EDGE_KEYS) -> dict[str, float]:
    values = _mapping(what, edge)
    for key in values:
        if key not in _EDGE_KEYS:
            raise ValueError(f"{what} has no {key!r}; there are {', '.join(keys)}")
    numbers = {key: checked_number(f"{what}[{key!r}]", value) for key, value in values.items()}
    if numbers.get("tip", 0) not in range(10):
        raise ValueError(f"{what}: the tip must be a direction 0 to 9, not {values['tip']!r}")
    return numbers


def _limit(what: str, pair: object) -> tuple[float, float]:
    # A set has no order, and a mapping has names.
    if isinstance(pair, str | bytes | bytearray | Mapping | Set) or not hasattr(pair, "__len__"):
        raise TypeError(f"{what} must be the lowest and the highest coordinate, not {pair!r}")
    values = [checked_number(what, value) for value in pair]  # type: ignore[attr-defined]
    if len(values) != 2:
        raise TypeError(f"{what} must be the lowest and the highest coordinate, not {pair!r}")
    low, high = values
    if low > high:
        raise ValueError(f"{what}: {low:g} is above {high:g}")
    return low, high
