"""The rooms of the engine and their arrows, drawn from what its files include."""

from __future__ import annotations

import re
from collections import defaultdict
from pathlib import Path

_CPP = Path(__file__).resolve().parents[2] / "cpp"
_WIDTH, _HEIGHT, _GAP = 110, 34, 26


def arrows() -> dict[str, set[str]]:
    """Which rooms each room includes files of."""
    found: dict[str, set[str]] = defaultdict(set)
    for folder in (_CPP / "cncsub", _CPP / "controls"):
        for file in folder.rglob("*.?pp"):
            of = _room(file.relative_to(_CPP).as_posix())
            for name in re.findall(r'^#include "([^"]+)"', file.read_text("utf-8"), re.MULTILINE):
                found[of].add(_room(name))
    return {room: known - {room, ""} for room, known in found.items() if room}


def _room(path: str) -> str:
    first, _, rest = path.partition("/")
    return (
        rest.partition("/")[0] if first == "cncsub" else ("controls" if first == "controls" else "")
    )


def _levels(known: dict[str, set[str]]) -> dict[str, int]:
    """How many rooms lie below each room at most."""
    levels: dict[str, int] = {}

    def level(room: str) -> int:
        if room not in levels:
            levels[room] = 1 + max((level(other) for other in known.get(room, ())), default=-1)
        return levels[room]

    for room in known:
        level(room)
    return levels


def drawing() -> str:
    """An SVG: an arrow leads to each room that is known, unless another arrow tells it already."""
    known = arrows()
    direct = {
        room: {one for one in others if not any(one in known.get(o, ()) for o in others - {one})}
        for room, others in known.items()
    }
    levels = _levels(known)
    rows: dict[int, list[str]] = defaultdict(list)
    for room in sorted(known):
        rows[levels[room]].append(room)
    widest = max(map(len, rows.values()))
    width = widest * (_WIDTH + _GAP) + _GAP
    height = len(rows) * (_HEIGHT + _GAP) + _GAP
    places = {}
    for level, rooms in rows.items():
        left = (width - len(rooms) * (_WIDTH + _GAP) + _GAP) / 2
        for number, room in enumerate(rooms):
            y = (len(rows) - 1 - level) * (_HEIGHT + _GAP) + _GAP
            places[room] = (left + number * (_WIDTH + _GAP), y)
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}"'
        ' role="img" class="rooms" aria-label="the rooms of the engine">',
        '<defs><marker id="to" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="7" markerHeight="7"'
        ' orient="auto"><path d="M0 0L8 4L0 8z" fill="currentColor"/></marker></defs>',
    ]
    for room, others in sorted(direct.items()):
        for other in sorted(others):
            (x1, y1), (x2, y2) = places[room], places[other]
            lines.append(
                f'<line x1="{x1 + _WIDTH / 2:g}" y1="{y1 + _HEIGHT:g}" x2="{x2 + _WIDTH / 2:g}"'
                f' y2="{y2 - 1:g}" stroke="currentColor" marker-end="url(#to)"/>'
            )
    for room, (x, y) in sorted(places.items()):
        lines.append(
            f'<rect x="{x:g}" y="{y:g}" width="{_WIDTH}" height="{_HEIGHT}" rx="4" fill="none"'
            ' stroke="currentColor"/>'
            f'<text x="{x + _WIDTH / 2:g}" y="{y + 22:g}" text-anchor="middle"'
            f' fill="currentColor" font-size="14">{room}</text>'
        )
    return "".join([*lines, "</svg>"])
