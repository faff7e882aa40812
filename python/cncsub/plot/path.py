"""`run.plot()`: the path of the tool, in a plane or in three dimensions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from cncsub.drawing.path import in_a_plane
from cncsub.option_errors import wrong_value
from cncsub.plot.colours import COLOURED_BY
from cncsub.plot.figure import count, empty
from cncsub.plot.plane import PlanePicture
from cncsub.plot.space import Picture, alarm_place
from cncsub.tables.polyline import rows_of

if TYPE_CHECKING:
    from cncsub.run import Recorded

MOST = 60_000  # points of a picture
VIEWS = ("auto", "2d", "3d")


def path_figure(
    run: Recorded,
    *,
    color: str = "kind",
    coordinates: str = "work",
    moves: slice | range | None = None,
    most: int = MOST,
    play: bool = True,
    view: str = "auto",
    title: str | None = None,
) -> Any:
    """See `Run.plot`."""
    core = run.recorded
    if color not in COLOURED_BY:
        raise wrong_value("color", f"color must be one of {', '.join(COLOURED_BY)}, not {color!r}")
    if coordinates not in ("work", "machine"):
        raise wrong_value(
            "coordinates", f"coordinates must be work or machine, not {coordinates!r}"
        )
    if isinstance(most, bool) or most < 100:
        raise wrong_value("most", f"most must be a number of points from 100, not {most!r}")
    if view not in VIEWS:
        raise wrong_value("view", f"view must be one of {', '.join(VIEWS)}, not {view!r}")
    first, last = rows_of(moves, core.moves)
    head = title if title is not None else _title(run, first, last)
    if first == last:
        return empty(_why_empty(run), head)
    drawn = PlanePicture if _is_plane(run, view, first, last) else Picture
    return drawn(run, color, coordinates, first, last, most).figure(head, play)


def _why_empty(run: Recorded) -> str:
    alarm = getattr(run, "alarm", None)
    if alarm is not None and not run.recorded.moves:
        words = str(alarm).partition("\n")[0]
        return f"The program moved nothing before the alarm at {alarm_place(alarm)}: {words}"
    return (
        "The program moved nothing."
        if len(run.steps)
        else 'No moves were recorded: trace="moves" records them.'
    )


def _is_plane(run: Recorded, view: str, first: int, last: int) -> bool:
    return view == "2d" or (view == "auto" and in_a_plane(run.recorded, first, last))


def _title(run: Recorded, first: int, last: int) -> str:
    name = run.steps[0].program if len(run.steps) else "path"
    part = "" if (first, last) == (0, len(run.moves)) else f", moves {first:,} to {last - 1:,}"
    return f"{name}: {count(last - first, 'move')}{part}"
