"""Bodies in the machine for a probe to touch: planes, boxes, cylinders and spheres."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from cncsub.controls import did_you_mean
from cncsub.setup import Point, checked_number, work_system

AXES = "XYZ"
MOST_SOLIDS = 1000
MOST_SIGNALS = 8
ARRIVALS = ("XAE", "YAE", "ZAE")

Direction = str | Point
Ends = tuple[float | None, float | None]


@dataclass(frozen=True)
class Plane:
    """A flat face without end: `Plane({"X": 40}, faces="-X")` is met by a probe that moves in +X.

    `at`: a point of the face, mm by axis; an axis left out is 0. `faces`: the direction out of the
    material, a sign and an axis, or the components of a direction, such as `{"X": 1, "Z": 1}`.
    `signal`: see `Workpiece`, which raises `ValueError` for what is no face.

    >>> import cncsub
    >>> cncsub.Plane({"Z": -5}).faces
    '+Z'
    """

    at: Point
    faces: Direction = "+Z"
    signal: int | str | None = None

    def to_core(self, where: str) -> dict[str, Any]:
        """Return the body as the engine takes it; `where` begins the message of an error."""
        return {
            "shape": "plane",
            "signal": _signal(where, self.signal),
            "at": _point(f"{where}: at", self.at),
            "direction": _direction(f"{where}: faces", self.faces),
        }


@dataclass(frozen=True)
class Box:
    """A box along the axes, or with `inside=True` a pocket of that shape; a solid of a `Workpiece`.

    `sides`: from and to by axis, mm, such as `{"X": (0, 80), "Y": (0, 50), "Z": (-20, 0)}`. An axis
    left out, and an end that is `None`, is without end. `signal`: see `Workpiece`, which raises
    `ValueError` for what is no box.

    >>> import cncsub
    >>> block = cncsub.Box({"X": (0, 80), "Y": (0, 50), "Z": (-20, 0)})
    >>> pocket = cncsub.Box({"X": (20, 60), "Y": (10, 40), "Z": (-5, None)}, inside=True)
    >>> len(cncsub.Workpiece([block, pocket], stylus=3).solids)
    2
    """

    sides: Mapping[str, Ends]
    inside: bool = False
    signal: int | str | None = None

    def to_core(self, where: str) -> dict[str, Any]:
        """Return the body as the engine takes it; `where` begins the message of an error."""
        low, high = [-math.inf] * 3, [math.inf] * 3
        for axis, ends in _by_axis(f"{where}: sides", self.sides).items():
            place = AXES.index(axis)
            low[place], high[place] = _ends(f"{where}: {axis}", ends)
        return {
            "shape": "box",
            "signal": _signal(where, self.signal),
            "hole": _yes(f"{where}: inside", self.inside),
            "low": low,
            "high": high,
        }


@dataclass(frozen=True)
class Cylinder:
    """A boss, or with `inside=True` a bore; a solid of a `Workpiece`.

    `at`: a point of its middle line, mm by axis. `radius`: mm. `axis`: the direction of that line,
    given as `faces` of a `Plane` are. `ends`: how far it reaches from `at` along the axis, mm, such
    as `(-20, 0)`; `None` is without end. `signal`: see `Workpiece`, which raises `ValueError` for
    what is no cylinder.

    >>> import cncsub
    >>> cncsub.Cylinder({"X": 40, "Y": 25}, radius=10, ends=(-20, 0), inside=True).axis
    'Z'
    """

    at: Point
    radius: float
    axis: Direction = "Z"
    ends: Ends = (None, None)
    inside: bool = False
    signal: int | str | None = None

    def to_core(self, where: str) -> dict[str, Any]:
        """Return the body as the engine takes it; `where` begins the message of an error."""
        first, last = _ends(f"{where}: ends", self.ends)
        return {
            "shape": "cylinder",
            "signal": _signal(where, self.signal),
            "hole": _yes(f"{where}: inside", self.inside),
            "at": _point(f"{where}: at", self.at),
            "direction": _direction(f"{where}: axis", self.axis),
            "radius": _positive(f"{where}: radius", self.radius),
            "first": first,
            "last": last,
        }


@dataclass(frozen=True)
class Sphere:
    """A ball, or with `inside=True` a hollow of that shape; a solid of a `Workpiece`.

    `at`: its centre, mm by axis; an axis left out is 0. `radius`: mm. `signal`: see `Workpiece`,
    which raises `ValueError` for what is no ball.

    >>> import cncsub
    >>> cncsub.Sphere({"X": 40, "Z": -10}, radius=12.5).inside
    False
    """

    at: Point
    radius: float
    inside: bool = False
    signal: int | str | None = None

    def to_core(self, where: str) -> dict[str, Any]:
        """Return the body as the engine takes it; `where` begins the message of an error."""
        return {
            "shape": "sphere",
            "signal": _signal(where, self.signal),
            "hole": _yes(f"{where}: inside", self.inside),
            "at": _point(f"{where}: at", self.at),
            "radius": _positive(f"{where}: radius", self.radius),
        }


Solid = Plane | Box | Cylinder | Sphere

# A mapping for a solid names its shape; the value there is the first field of the shape.
SHAPES: dict[str, type[Solid]] = {
    "plane": Plane,
    "box": Box,
    "cylinder": Cylinder,
    "sphere": Sphere,
}


@dataclass(frozen=True)
class Workpiece:
    """The bodies that a probe touches. A G31 stops where the ball of its stylus touches one.
    Lengths in mm, X of a lathe as a diameter.

    `solids`: in any order; those with `inside=True` are holes in the others, and holes alone are
    holes in something without end. A hole that ends at a surface is open there. Each may be a
    mapping as in TOML: `{"cylinder": {"X": 30, "Y": 20}, "radius": 10, "inside": True}`.
    `stylus`: the radius of the ball. `ball`: the point that is programmed is the `"centre"` of the
    ball or its `"end"` (then the tool length reaches to the lowest point). `length`: of the stylus,
    for programs that measure it; without it the length offset in force is the true one.
    `coordinates`: `"machine"`, or the work coordinate system whose zero point they count from as it
    is when the run starts, `"G54"`: what a program does to it later does not move the workpiece.

    Nothing turns with rotary axes. A ball that begins inside a solid touches at once; one that only
    grazes it, slides along it or leaves it does not. A solid with a `signal`, 1 to 8, stops only
    the blocks that watch this skip signal (P of G31), such as a tool setter beside the part.

    Raises `TypeError` and `ValueError` that name the solid.

    >>> import cncsub
    >>> text = "O1\\nN10 G90 G31 X100. F500\\nN20 #100=#5061\\nN30 M30\\n"
    >>> part = cncsub.Workpiece([cncsub.Plane({"X": 40}, faces="-X")], stylus=3)
    >>> library = cncsub.loads(text, control="fanuc-0i-f")
    >>> library.run(setup={"start": {"X": 0}}, inputs={"workpiece": part}).variables[100]
    37.0
    """

    solids: Sequence[Solid | Mapping[str, Any]]
    stylus: float = 0.0
    coordinates: str = "G54"
    ball: str = "centre"
    length: float | None = None

    def __post_init__(self) -> None:
        self.to_core()

    def to_core(self) -> dict[str, Any]:
        """Return the workpiece as the engine takes it."""
        if isinstance(self.solids, str | bytes | Mapping) or not isinstance(self.solids, Sequence):
            raise TypeError(f"workpiece: solids must be a list, not {type(self.solids).__name__}")
        if len(self.solids) > MOST_SOLIDS:
            raise ValueError(
                f"workpiece: {len(self.solids)} solids; at most {MOST_SOLIDS} are possible"
            )
        if self.ball not in ("centre", "end"):
            raise ValueError(f"workpiece: ball must be 'centre' or 'end', not {self.ball!r}")
        stylus = checked_number("workpiece: stylus", self.stylus)
        if stylus < 0:
            raise ValueError(
                f"workpiece: the radius of the stylus must not be negative: {stylus:g}"
            )
        core = {
            "solids": [_solid(place, solid) for place, solid in enumerate(self.solids)],
            "stylus": stylus,
            "by_end": self.ball == "end",
            "system": _coordinates(self.coordinates),
        }
        if self.length is not None:
            core["length"] = checked_number("workpiece: length", self.length)
        return core


def workpiece_of(workpiece: object) -> dict[str, Any]:
    """Return what the engine takes for a `Workpiece`, or a mapping with the same keys."""
    if isinstance(workpiece, Workpiece):
        return workpiece.to_core()
    if not isinstance(workpiece, Mapping):
        raise TypeError(
            f"workpiece must be a cncsub.Workpiece or a mapping, not {type(workpiece).__name__}"
        )
    _known("workpiece", workpiece, [f.name for f in dataclasses.fields(Workpiece)])
    if "solids" not in workpiece:
        raise ValueError("workpiece has no solids")
    return Workpiece(**workpiece).to_core()


def skip_signal(where: str, signal: object) -> int:
    """Return the number of a skip signal; those of G36 and G37 have names."""
    if signal in ARRIVALS:
        return MOST_SIGNALS + 1 + ARRIVALS.index(str(signal))
    if isinstance(signal, bool) or not hasattr(signal, "__index__"):
        raise TypeError(
            f"{where}: a skip signal must be a number 1 to {MOST_SIGNALS}, or one of"
            f" {', '.join(ARRIVALS)}, not {signal!r}"
        )
    number = int(signal.__index__())
    if not 1 <= number <= MOST_SIGNALS:
        raise ValueError(f"{where}: a skip signal must be 1 to {MOST_SIGNALS}, not {signal!r}")
    return number


def _signal(where: str, signal: object) -> int:
    return 0 if signal is None else skip_signal(f"{where}: signal", signal)


def _solid(place: int, solid: object) -> dict[str, Any]:
    where = f"workpiece: solids[{place}]"
    if isinstance(solid, Plane | Box | Cylinder | Sphere):
        return solid.to_core(f"{where}, a {type(solid).__name__.lower()}")
    if not isinstance(solid, Mapping):
        raise TypeError(
            f"{where} must be a Plane, Box, Cylinder, Sphere or a mapping, not {solid!r}"
        )
    shapes = [shape for shape in SHAPES if shape in solid]
    if len(shapes) != 1:
        raise ValueError(f"{where} must have a shape, one of {', '.join(SHAPES)}: {dict(solid)!r}")
    where = f"{where}, a {shapes[0]}"
    kind = SHAPES[shapes[0]]
    _, *others = (f.name for f in dataclasses.fields(kind))
    rest = {key: value for key, value in solid.items() if key != shapes[0]}
    _known(where, rest, others)
    if "radius" in others and "radius" not in rest:
        raise ValueError(f"{where} has no radius")
    return kind(solid[shapes[0]], **rest).to_core(where)


def _known(where: str, values: Mapping[Any, Any], known: Sequence[str]) -> None:
    for key in values:
        if key not in known:
            near = did_you_mean(str(key), known, f"; there are {', '.join(known)}")
            raise ValueError(f"{where} has no {key!r}{near}")


def _coordinates(name: object) -> str:
    if name == "machine":
        return "machine"
    try:
        system = work_system("coordinates", name)
    except ValueError:
        system = "EXT"
    if system == "EXT":
        raise ValueError(
            "workpiece: coordinates must be 'machine', 'G54' to 'G59' or 'G54.1 P1' to 'G54.1"
            " P300',"
            f" not {name!r}"
        )
    return system


def _positive(what: str, value: object) -> float:
    number = checked_number(what, value)
    if number <= 0:
        raise ValueError(f"{what} must be more than 0, not {value!r}")
    return number


def _yes(what: str, value: object) -> bool:
    if not isinstance(value, bool):
        raise TypeError(f"{what} must be True or False, not {value!r}")
    return value


def _by_axis(what: str, values: object) -> dict[str, Any]:
    if not isinstance(values, Mapping):
        raise TypeError(f'{what} must be a mapping such as {{"X": 40}}, not {values!r}')
    checked: dict[str, Any] = {}
    for axis, value in values.items():
        name = axis.upper() if isinstance(axis, str) else ""
        if len(name) != 1 or name not in AXES:
            raise ValueError(f"{what}: {axis!r} is not an axis; a solid has X, Y and Z")
        if name in checked:
            raise ValueError(f"{what} has {name} twice")
        checked[name] = value
    return checked


def _point(what: str, values: object) -> list[float]:
    point = _by_axis(what, values)
    return [checked_number(f"{what}: {axis}", point.get(axis, 0.0)) for axis in AXES]


def _direction(what: str, way: object) -> list[float]:
    if isinstance(way, str):
        name = way.strip().upper()
        axis, sign = name.strip("+-"), -1.0 if "-" in name else 1.0
        if len(axis) != 1 or axis not in AXES or len(name) > 2:
            raise ValueError(
                f"{what} must be a sign and an axis, such as '+Z' or '-X', not {way!r}"
            )
        return [sign if axis == other else 0.0 for other in AXES]
    components = _point(what, way)
    length = math.hypot(*components)
    if length == 0:
        raise ValueError(f"{what} must be a direction, and {way!r} has no length")
    return [component / length for component in components]


def _ends(what: str, ends: object) -> tuple[float, float]:
    if isinstance(ends, str | bytes) or not isinstance(ends, Sequence) or len(ends) != 2:
        raise TypeError(f"{what} must be a pair such as (-20, 0), not {ends!r}")
    low = _end(what, ends[0], -math.inf)
    high = _end(what, ends[1], math.inf)
    if not low < high:
        raise ValueError(f"{what} must go from the lower to the higher value, not {ends!r}")
    return low, high


def _end(what: str, end: object, open_end: float) -> float:
    return open_end if end is None or end == open_end else checked_number(what, end)
