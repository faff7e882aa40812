"""Draws the pictures of the documentation from runs of the examples.

python tools/pictures.py            # writes docs/pictures/path.svg and debug.svg
python tools/pictures.py --check    # exit status 1 where it would be another picture
"""

from __future__ import annotations

import argparse
import asyncio
import math
import re
from collections.abc import Iterable
from pathlib import Path

import cncsub

ROOT = Path(__file__).resolve().parent.parent
PATH = ROOT / "docs" / "pictures" / "path.svg"
SCREEN = ROOT / "docs" / "pictures" / "debug.svg"
MARGIN = 8.0  # mm around the drawing
Point = tuple[float, float]

STYLE = """\
    svg { background: #ffffff }
    path { fill: none; stroke-linejoin: round; stroke-linecap: round }
    .rapid { stroke: #9aa4ad; stroke-width: 0.35; stroke-dasharray: 1.4 1.2 }
    .cut { stroke: #1f5fa8; stroke-width: 0.9 }
    .tool { stroke: #d9742b; stroke-width: 0.5 }
    text { font: 3px sans-serif; fill: #40484f }"""


def path() -> str:
    """The profile of `examples/fanuc/milling.nc`, seen from above: what is programmed, and the way
    of the tool's centre beside it.
    """
    setup = cncsub.Setup.from_toml(ROOT / "examples" / "fanuc" / "milling.toml")
    library = cncsub.load(ROOT / "examples" / "fanuc" / "milling.nc", control="fanuc-0i-f")
    moves = list(library.run(setup=setup).moves)
    programmed = [((m.x, m.y), m) for m in moves]
    centre = [((m.mx, m.my), m) for m in moves]
    drawn = [
        ("rapid", _strokes(programmed, rapid=True)),
        ("tool", _strokes(centre, rapid=False)),
        ("cut", _strokes(programmed, rapid=False)),
    ]
    points = [point for point, _ in (*programmed, *centre)]
    left, right = min(x for x, _ in points) - MARGIN, max(x for x, _ in points) + MARGIN + 46
    low, high = min(y for _, y in points) - MARGIN, max(y for _, y in points) + MARGIN
    box = f"{_n(left)} {_n(-high)} {_n(right - left)} {_n(high - low)}"
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{box}" width="640" role="img"'
        ' aria-label="two equal profiles, milled by one subprogram called twice">',
        f"  <style>\n{STYLE}\n  </style>",
        *(f'  <path class="{kind}" d="{strokes}"/>' for kind, strokes in drawn),
    ]
    words = [
        ("cut", "the programmed path"),
        ("tool", "the tool's centre (G41)"),
        ("rapid", "rapid"),
    ]
    for row, (kind, word) in enumerate(words):
        y = _n(-high + 10 + 6 * row)
        x = right - 47
        lines.append(f'  <path class="{kind}" d="M{_n(x)} {y}h6"/>')
        lines.append(f'  <text x="{_n(x + 8)}" y="{_n(-high + 11 + 6 * row)}">{word}</text>')
    return "\n".join([*lines, "</svg>"]) + "\n"


def screen() -> str:
    """The debugger in the terminal, at the third hole of the macro of its page. It needs what
    `cncsub[debug]` installs, and is drawn as the version of Textual that is installed does it.
    """
    from cncsub.debugging import PausePoint, Session
    from cncsub.terminal.app import DebugApp

    page = (ROOT / "docs" / "guides" / "debugging-terminal.md").read_text(encoding="utf-8")
    text = page.partition('title="row.nc"\n')[2].partition("```")[0]
    session = Session(cncsub.loads({"row.nc": text}, control="fanuc-0i-f"))
    session.set_points("screen", [PausePoint("O9100:N140", when="#30 GE 2")])
    app = DebugApp(session, "cncsub debug: O1 on FANUC Series 0i-F")

    async def drawn() -> str:
        async with app.run_test(size=(80, 24)) as pilot:
            await pilot.press("c")
            while app.moving:
                await pilot.pause(0.01)
            await pilot.pause()
            return app.export_screenshot(title="cncsub debug", simplify=True)

    svg = re.sub(r"@font-face \{.*?\}", "", asyncio.run(drawn()), flags=re.DOTALL)
    svg = svg.replace("Fira Code", "DejaVu Sans Mono, DejaVu Sans")
    return re.sub(r"[ \t]+$|\n(?=\n)", "", svg, flags=re.MULTILINE)


def _strokes(ends: Iterable[tuple[Point, cncsub.Move]], *, rapid: bool) -> str:
    """The moves that are rapid, or those that are not, as the data of an SVG path; Y points up."""
    data: list[str] = []
    before: Point | None = None
    lifted = True
    for end, move in ends:
        wanted = (move.kind == "rapid") is rapid and before is not None and before != end
        if wanted and before is not None:
            if lifted:
                data.append(f"M{_n(before[0])} {_n(-before[1])}")
            data.append(_stroke(before, end, move))
        lifted = lifted and not wanted if before == end else not wanted
        before = end
    return " ".join(data)


def _stroke(start: Point, end: Point, move: cncsub.Move) -> str:
    to = f"{_n(end[0])} {_n(-end[1])}"
    if move.kind not in ("cw", "ccw") or move.cx is None or move.cy is None:
        return f"L{to}"
    a, b = (math.atan2(p[1] - move.cy, p[0] - move.cx) for p in (start, end))
    turn = (a - b if move.kind == "cw" else b - a) % (2 * math.pi)
    radius = _n(math.dist(end, (move.cx, move.cy)))
    return f"A{radius} {radius} 0 {int(turn > math.pi)} {int(move.kind == 'cw')} {to}"


def _n(number: float) -> str:
    return f"{round(number, 2) + 0.0:g}"


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--check", action="store_true", help="compare, write nothing")
    if parser.parse_args().check:
        return int(PATH.read_text(encoding="utf-8") != path())
    PATH.write_text(path(), encoding="utf-8")
    SCREEN.write_text(screen(), encoding="utf-8")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
