"""The record of a run."""

from __future__ import annotations

import enum
import functools
from collections.abc import Iterator
from typing import TYPE_CHECKING

from cncsub import _core
from cncsub._core import Alarm
from cncsub.analysis import assertions
from cncsub.pickling import NotPicklable
from cncsub.tables.of_runs import Calls, Codes, Conditions, Moves, Steps, Watch
from cncsub.tables.rows import Dropped, MissedSkip
from cncsub.variables import Variables

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

    from cncsub.analysis.endless import Endless
    from cncsub.analysis.listing import Listed
    from cncsub.coverage.summary import Coverage
    from cncsub.tables.polyline import Polyline


class Stop(enum.StrEnum):
    """Why a run stopped, as a text too: `END` (by M02, M30 or what else ends a program), `ALARM`,
    `CYCLES` (the main program started over `max_cycles` times), `LIMIT` (`max_blocks`,
    `max_seconds` or `max_memory`), `WAITING` (for an input that is not given),
    `INTERRUPTED` (Ctrl-C).

    >>> import cncsub
    >>> run = cncsub.loads("O1\\nN10 M99\\n", control="fanuc-0i-f").run(max_cycles=3)
    >>> run.stop is cncsub.Stop.CYCLES, run.stop == "cycles"
    (True, True)
    """

    END = "end"  # M02, M30 or what else ends a program
    ALARM = "alarm"
    CYCLES = "cycles"  # the main program started over `max_cycles` times
    LIMIT = "limit"  # `max_blocks` or `max_seconds`
    WAITING = "waiting"  # for an input that is not given
    INTERRUPTED = "interrupted"  # Ctrl-C


class AlarmError(Exception):
    """Raised by `raise_for_alarm`; the alarm is in `.alarm`, its message is the text.

    >>> import cncsub
    >>> try:
    ...     cncsub.loads("O1\\nN10 M98 P2\\n", control="fanuc-0i-f").run().raise_for_alarm()
    ... except cncsub.AlarmError as error:
    ...     error.alarm.number
    'PS0076'
    """

    def __init__(self, alarm: Alarm) -> None:
        super().__init__(str(alarm))
        self.alarm = alarm

    def __reduce__(self) -> tuple[type[AlarmError], tuple[Alarm]]:
        return AlarmError, (self.alarm,)


class Recorded(NotPicklable):
    """The record of a run, of a machine so far, or of one part of a stream."""

    def __init__(self, core: _core.Trace, axes: list[str] | None = None) -> None:
        self.recorded = core
        self._axes = axes

    @functools.cached_property
    def steps(self) -> Steps:
        """One row per executed block (with `trace="blocks"` or `"moves"`)."""
        return Steps(self.recorded)

    @functools.cached_property
    def calls(self) -> Calls:
        """One row per entered call (with any `trace` but `"none"`)."""
        return Calls(self.recorded)

    @functools.cached_property
    def moves(self) -> Moves:
        """One row per motion (with `trace="moves"`)."""
        return Moves(self.recorded, self._axes)

    @functools.cached_property
    def watch(self) -> Watch:
        """One row per change of a variable named in `watch` (with any `trace`)."""
        return Watch(self.recorded)

    @functools.cached_property
    def conditions(self) -> Conditions:
        """One row per comparison of a condition (with `conditions=True`)."""
        return Conditions(self.recorded)

    @property
    def messages(self) -> list[str]:
        """The texts that `#3006` and `DPRNT` wrote, in order."""
        return self.recorded.messages

    @property
    def dropped(self) -> tuple[Dropped, ...]:
        """Words that the control read and ignored, in order (with any `trace` but `"none"`): M
        codes beyond those that it executes in a block, all but the last of an address or of a group
        of G codes, I and K beside R, U beside X. An M code that would start the spindle or the
        coolant has a `warning`, and so has a tool called by a name that the setup does not give.

        >>> import cncsub
        >>> run = cncsub.loads("O1\\nN10 M8 M3 S500\\nM30\\n", control="fanuc-0i-f").run()
        >>> run.dropped[0].text, run.dropped[0].n, run.m_codes
        ('M8', 10, [3])
        >>> print(run.dropped[0].warning.partition(":")[0])
        it would start the coolant
        """
        from cncsub.tables.dropped import dropped_words

        return tuple(dropped_words(self.recorded.dropped, self.recorded.control))

    @property
    def missed_skips(self) -> list[MissedSkip]:
        """The blocks of G31 that got no skip signal, in order.

        >>> import cncsub
        >>> text = "O1\\nN10 G31 Z-5. F50\\nN20 M30\\n"
        >>> for missed in cncsub.loads(text, control="fanuc-0i-f").run().missed_skips:
        ...     print(missed)
        O1 N10 got no skip signal
        """
        return [MissedSkip(*place) for place in self.recorded.missed_skips]

    @functools.cached_property
    def codes(self) -> Codes:
        """One row per M, T and S code sent to the machine (with any `trace` but `"none"`)."""
        return Codes(self.recorded)

    def polyline(
        self,
        tolerance: float = 0.01,
        *,
        coordinates: str = "work",
        moves: slice | range | None = None,
    ) -> Polyline:
        """Return the path as points: the ends of the moves as they are, and of arcs, helices and
        spirals as many points between them as keep every chord within `tolerance` (mm) of the true
        curve, four in a turn at least.

        `coordinates`: `"work"` is the programmed path in the work coordinates in force, `"tool"`
        that of the tool with its radius offset in the same coordinates, `"machine"` that of the
        tool with all its offsets in machine coordinates. `moves`: only those of a slice or a range
        of rows of `moves`. Rapid moves are straight lines.

        Raises `ValueError` for a tolerance that is not above 0 or asks for more points than
        50 million beside the ends, and for other coordinates.

        >>> import cncsub
        >>> text = "O1\\nN10 G0 X10. Y0\\nN20 G3 X10. Y0 I-10. F100\\nN30 M30\\n"
        >>> path = cncsub.loads(text, control="fanuc-0i-f").run().polyline(0.1)
        >>> path
        <Polyline: 25 points, work coordinates, within 0.1 mm>
        >>> path.points[0].tolist(), path.move[:4].tolist(), path.points[-1].tolist()
        ([0.0, 0.0, 0.0], [0, 0, 1, 1], [10.0, 0.0, 0.0])
        """
        from cncsub.tables.polyline import polyline_of

        return polyline_of(self.recorded, tolerance, coordinates, moves)

    @property
    def m_codes(self) -> list[int]:
        """The M codes sent to the machine, in order (with any `trace` but `"none"`)."""
        return self.recorded.m_codes

    @property
    def t_codes(self) -> list[int]:
        """The T codes sent to the machine, in order (with any `trace` but `"none"`)."""
        return self.recorded.t_codes


class State(NotPicklable):
    """The state of a machine."""

    def __init__(self, core: _core.Machine) -> None:
        self.core = core

    @property
    def alarm(self) -> Alarm | None:
        """The alarm that stopped the program."""
        return self.core.alarm

    @property
    def waiting_for(self) -> str:
        """What the run waits for if it stopped with `Stop.WAITING`; otherwise empty."""
        return self.core.waiting_for

    @property
    def endless(self) -> Endless | None:
        """Why the program had not ended when a limit stopped the run, or why it waits: it
        repeats by design (M99 of the main program), its state came back exactly (an endless loop,
        with its blocks), it waits, or it is only long. `None` where it ended, alarmed or runs.

        At a limit of blocks, time or memory a copy is run on for up to 100,000 blocks (and two
        seconds) to find out, at each access; the run itself does not change.

        >>> import cncsub
        >>> text = "O1\\nN10 M98 P2\\nN20 GOTO10\\nO2\\nN30 M99\\n"
        >>> print(cncsub.loads(text, control="fanuc-0i-f").run(max_blocks=1000).endless)
        an endless loop, proven: after 3 blocks the state is the same again; O1 N10, O2 N30, O1 N20
        """
        from cncsub.analysis.endless import endless_of

        return endless_of(self.core)

    @property
    def blocks(self) -> int:
        """How many blocks were executed."""
        return self.core.blocks

    @property
    def position(self) -> dict[str, float]:
        """The position of the tool: work coordinates by axis, mm."""
        return self.core.position

    @property
    def modal(self) -> dict[str, str]:
        """The modal codes in force, by group."""
        return self.core.modal

    def raise_for_alarm(self) -> None:
        """Raise `AlarmError` where an alarm stopped the program."""
        if self.alarm is not None:
            raise AlarmError(self.alarm)

    def summary(self) -> str:
        """Return how the run stopped, in a few words."""
        return _core.summary(self.core)


class Outcome(State, Recorded):
    """The properties that a run and a machine share."""

    def __init__(self, core: _core.Machine) -> None:
        State.__init__(self, core)
        Recorded.__init__(self, core.trace)

    def listing(
        self,
        *,
        program: str | int | None = None,
        depth: int | None = None,
        n: int | None = None,
        variable: int | None = None,
    ) -> Iterator[Listed]:
        """Yield each executed block with its text, its pass and what it did: codes sent to the
        machine, moves, calls, changes of the watched variables. Where they are given, `program`,
        `depth` (of calls), `n` (a sequence number) and `variable` (one that was changed) select the
        blocks.

        Raises `KeyError` for a program that is not there, and `ValueError` for a variable that was
        not watched and for a run that kept no blocks.

        >>> import cncsub
        >>> text = "O1\\nN10 M98 P2 L2\\nN20 M30\\nO2\\nN30 #100=#100+1\\nN40 G0 X#100\\nM99\\n"
        >>> run = cncsub.loads(text, control="fanuc-0i-f").run(watch=[100], variables={100: 4})
        >>> for block in run.listing(program="O2", n=30):
        ...     print(block)
             1  | O2:5  N30 #100=#100+1  ->  #100 = 5
             4  | O2:5  pass 2  N30 #100=#100+1  ->  #100 = 6
        """
        from cncsub.analysis.listing import listing_of

        return listing_of(self, program=program, depth=depth, n=n, variable=variable)

    def plot(
        self,
        *,
        color: str = "kind",
        coordinates: str = "work",
        moves: slice | range | None = None,
        most: int = 60_000,
        play: bool = True,
        view: str = "auto",
        title: str | None = None,
    ) -> Figure:
        """Draw the path as a figure of plotly (`cncsub[plot]`): in a plane where it is seen whole
        from one side, else in three dimensions. Rapid moves, feeds, canned cycles and moves with a
        radius offset are separate lines. A point shows its block, the calls that led there and its
        move. A slider shows the path up to an instant, with the tool at its end. The place where
        an alarm stopped the run is marked, in a plane holes and tool changes too.

        `color`: `"kind"`, `"program"`, `"call"`, `"tool"`, `"depth"` (of the calls), `"feed"`,
        `"time"` or `"z"`. `coordinates`: `"work"` is the programmed path, and beside it the tool
        where a radius offset leads it elsewhere; `"machine"` is the tool with all its offsets.
        `moves`: only those of a slice or a range of rows of `moves`. `most`: so many points may be
        drawn. A longer path is thinned, and the picture tells how far what is left out may lie from
        what is drawn; what cannot be thinned is cut, and the picture tells where. `play`: whether
        there is a slider. `view`: `"2d"` or `"3d"`; `"auto"` is a plane for a lathe, for cuts that
        go sideways at one depth and for a path without extent along an axis. `title`: the text
        above the figure.

        Raises `ImportError` without plotly, and `ValueError` for another colour, coordinates or
        view.

        >>> import cncsub
        >>> text = "O1\\nN10 G0 X10. Y0\\nN20 G3 X10. Y0 I-10. F100\\nN30 M30\\n"
        >>> run = cncsub.loads(text, control="fanuc-0i-f").run()
        >>> [trace.name for trace in run.plot(play=False).data]
        ['rapid', 'feed']
        """
        from cncsub.plot.path import path_figure

        return path_figure(
            self,
            color=color,
            coordinates=coordinates,
            moves=moves,
            most=most,
            play=play,
            view=view,
            title=title,
        )

    def svg(self, *, coordinates: str = "work") -> str:
        """Return the path as a drawing in SVG, an empty text where nothing moved. It needs no other
        package, and a notebook shows it below a run.

        The view is the one that suits: from above, at right angles to the plane of the path or of
        its arcs, Z to the right and X upwards for a lathe. It is true to scale, with ticks in mm,
        or in inches where the program ended in inches, and diameters on a diameter axis. Rapid
        moves are dashed. Holes are numbered in the order in which they were begun; tool changes and
        the place where an alarm stopped the run are marked. `coordinates`: `"work"` or
        `"machine"`, as in `plot`. A long path is thinned to what the drawing can show.

        >>> import cncsub
        >>> text = "O1\\nG81 X10. Y5. Z-3. R1. F100\\nX20.\\nG80\\nM30\\n"
        >>> drawing = cncsub.loads(text, control="fanuc-0i-f").run().svg()
        >>> drawing[:4], "hole 2: X20 Y5 Z-3" in drawing
        ('<svg', True)
        """
        from cncsub.drawing.svg import svg_of

        return svg_of(self, coordinates)

    def coverage(self) -> Coverage:
        """Return the blocks, branches, calls and arguments that this run, or this machine so far,
        went through.

        Raises `ValueError` for a run with `trace="none"` or `"calls"`, which kept no blocks.

        >>> import cncsub
        >>> cncsub.loads("O1\\nN10 M30\\n", control="fanuc-0i-f").run().coverage().percent
        100.0
        """
        from cncsub.coverage.summary import coverage_of

        return coverage_of(self.recorded, self.core.code)


class Run(Outcome):
    """A run that has stopped.

    >>> import cncsub
    >>> run = cncsub.loads("O1\\nN10 M98 P2\\nN20 M30\\n", control="fanuc-0i-f").run()
    >>> run.stop
    <Stop.ALARM: 'alarm'>
    >>> run.alarm.cause, run.alarm.number, run.alarm.n
    ('program-not-found', 'PS0076', 10)
    """

    _instead = "send what you need of it: alarm, stop, dict(variables), moves.to_arrow()"

    def __copy__(self) -> Run:
        return self  # a run never changes

    def __deepcopy__(self, memo: object) -> Run:
        return self

    def _repr_html_(self) -> str:
        from cncsub.notebook import run_html

        return run_html(self, self.svg())

    @property
    def stop(self) -> Stop:
        """Why the run stopped."""
        return Stop(self.core.stop or "interrupted")

    def assert_ends(self) -> None:
        """Raise `AssertionError` where the program did not come to its end, with what a test needs
        to see: the alarm and the blocks that called, what ran last, the variables.

        >>> import cncsub
        >>> cncsub.loads("O1\\nM30\\n", control="fanuc-0i-f").run().assert_ends()
        """
        __tracebackhide__ = True
        assertions.assert_ends(self)

    def assert_alarm(self, expected: str, at: str | None = None) -> None:
        """Raise `AssertionError` where the program did not stop with this alarm. `expected` is its
        number or its cause, `at` the program, the sequence number, or both: `"O10 N30"`.

        Raises `ValueError` where `at` names a program that the library does not have.

        >>> import cncsub
        >>> run = cncsub.loads("O1\\nN10 M98 P2\\nM30\\n", control="fanuc-16i").run()
        >>> run.assert_alarm("078", at="O1 N10")
        >>> run.assert_alarm("program-not-found")
        """
        __tracebackhide__ = True
        assertions.assert_alarm(self, expected, at)

    @functools.cached_property
    def variables(self) -> Variables:
        """Variable number to value at the stop, `None` where it is vacant: commons and the main
        program's locals.
        """
        return Variables(self.core, 0)

    @property
    def variables_after_reset(self) -> dict[int, float]:
        """The `variables` that are left after M02, M30 or the reset key has cleared what the
        control clears (on FANUC by 6001#6 and 6001#7).

        >>> import cncsub
        >>> run = cncsub.loads("O1\\n#1=1\\n#500=5\\nM30\\n", control="fanuc-0i-f").run()
        >>> run.variables[1], run.variables_after_reset
        (1.0, {500: 5.0})
        """
        return {
            number: value
            for number, value in self.variables.items()
            if value is not None and not self.core.cleared_by_reset(number)
        }

    @functools.cached_property
    def endless(self) -> Endless | None:
        """Why the program had not ended, worked out once: see `Machine.endless`."""
        from cncsub.analysis.endless import endless_of

        return endless_of(self.core)

    def __repr__(self) -> str:
        return f"<Run: {self.summary()}, {self.steps.size_words()}, {self.calls.size_words()}>"

    def __str__(self) -> str:
        """Return `repr`, and why the program had not ended where a limit stopped it."""
        why = self.endless
        return repr(self) if why is None else f"{self!r}: {why}"
