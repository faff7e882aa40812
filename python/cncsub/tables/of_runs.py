"""The tables of a run: executed blocks, entered calls, moves, changes and codes."""

from __future__ import annotations

from dataclasses import fields
from typing import TYPE_CHECKING, Any

from cncsub import _core
from cncsub.tables.call_tree import CallTree, trees, write_lines
from cncsub.tables.rows import Call, Change, Compared, Move, SentCode, Step
from cncsub.tables.table import Table, known_or_none, number_or_none

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

    from cncsub.tables.table import Column

_DRAWN = 2000  # calls in a printed tree
_FIELDS = {
    row: [f.name for f in fields(row)] for row in (Step, Call, Move, Change, SentCode, Compared)
}


def _field_names(row: type[Step | Call | Move | Change | SentCode | Compared]) -> list[str]:
    return list(_FIELDS[row])


class Steps(Table[Step]):
    """One row per executed block: `step, program, n, line, depth, frame, repeat`.

    The column `text`, the block as it is written, is there when it is asked for by name. A row has
    `text` and `block` too.

    >>> import cncsub
    >>> text = "O1\\nN10 M98 P2 L2\\nN20 M30\\nO2\\nN30 M99\\n"
    >>> run = cncsub.loads(text, control="fanuc-0i-f").run()
    >>> run.steps.n.tolist()
    [10, 30, 30, 20]
    >>> run.steps[1]
    Step(step=1, program='O2', n=30, line=5, depth=1, frame=0, repeat=1)
    >>> run.steps[1].text, (run.steps.text == "N30 M99").tolist()
    ('N30 M99', [False, True, True, False])
    """

    _title = "steps"
    _nulls = frozenset(("n",))

    def __init__(self, core: _core.Trace) -> None:
        super().__init__(core)
        self._written: tuple[Column, list[str]] | None = None

    @property
    def columns(self) -> list[str]:
        return _field_names(Step)

    @property
    def more_columns(self) -> list[str]:
        return ["text"]

    @property
    def texts(self) -> list[str]:
        """The texts that the codes of the column `text` stand for, each once."""
        return self._text_column()[1]

    def _text_column(self) -> tuple[Column, list[str]]:
        if self._written is None or len(self._written[0]) != len(self):
            self._written = self.core.step_text_column()
        return self._written

    @property
    def programs(self) -> list[str]:
        """The names that the codes of the column `program` stand for."""
        return self.core.program_names

    def _rows(self) -> int:
        return self.core.steps

    def _row(self, index: int) -> Step:
        return self.core.step_row(index, Step)

    def _fetch(self, names: list[str]) -> dict[str, Column]:
        return {
            name: self._text_column()[0].copy() if name == "text" else self.core.step_column(name)
            for name in names
        }

    def texts_of(self, name: str) -> list[str] | None:
        if name == "text":
            return self.texts
        return self.programs if name == "program" else None


class Watch(Table[Change]):
    """One row per change of a variable that is watched: `step, variable, value, program, n, line`.

    A row gives the value after a step, whatever wrote it: an assignment, an argument, a return to
    the caller's locals, a move where the variable is a position, another program while the run
    waits. `#1` and so on are those of the level that is open after the step. A step that writes the
    value that is there makes no row; a step that writes a variable twice makes one row.

    `value` is `None` (in the column NaN) where the variable became vacant. What
    `machine.variables[100] = 5` sets between two steps has no `step`, `program`, `n` and `line`
    (`None`; in a column -1). A block that alarms makes no row: its writes are rolled back.

    >>> import cncsub
    >>> text = "O1\\nN10 #100=#100+1\\nN20 IF[#100LT3]GOTO10\\nN30 #500=#100\\nN40 #100=#0\\nM30\\n"
    >>> library = cncsub.loads(text, control="fanuc-0i-f")
    >>> run = library.run(variables={100: 0}, watch=[100, 500])
    >>> run.watch.value[run.watch.variable == 100].tolist()
    [1.0, 2.0, 3.0, nan]
    >>> run.watch[3]
    Change(step=6, variable=500, value=3.0, program='O1', n=30, line=4)
    >>> run.watch.beginning
    {100: 0.0, 500: None}
    >>> len(run.watch), len(run.watch(500))
    (5, 1)
    """

    _title = "changes"
    _nulls = frozenset(("step", "value", "n", "line"))

    @property
    def columns(self) -> list[str]:
        return _field_names(Change)

    def __init__(self, core: _core.Trace, only: tuple[int, ...] | None = None) -> None:
        super().__init__(core)
        self._only = only
        self._places: Column | None = None  # the rows of the variables in `_only`
        self._looked = -1  # the number of changes when `_places` was found

    def __call__(self, *variables: int) -> Watch:
        """Return the changes of these variables alone, or of all where none is named, as a table.
        Raises `KeyError` for a variable that is not watched.
        """
        for number in variables:
            if number not in self.beginning:
                watched = ", ".join(map(self._name, self.beginning)) or "nothing"
                raise KeyError(
                    f"{self._name(number)} is not watched: run(watch=[{number}]); {watched} is"
                )
        return Watch(self.core, tuple(variables) or self._only)

    @property
    def beginning(self) -> dict[int, float | None]:
        """The watched variables with their values before the first row: those that `variables`
        gave; in a part of a stream, those that the part before left. Empty where nothing is
        watched.
        """
        watched = self.core.watched
        if self._only is None:
            return watched
        return {number: watched[number] for number in self._only}

    def plot(self, *, over: str = "steps", title: str | None = None) -> Figure:
        """Draw the values of each watched variable as a figure of plotly (`cncsub[plot]`). A vacant
        variable has no line. `over`: `"steps"` or `"time"` (s, that of the moves).
        `run.watch(100).plot()` shows `#100` alone; twelve variables are shown at most. Of many
        changes the picture shows the lowest and the highest, and says so.

        Raises `ImportError` without plotly, and `ValueError` for another axis.

        >>> import cncsub
        >>> text = "O1\\nN10 #100=#100+1\\nN20 IF[#100LT3]GOTO10\\nM30\\n"
        >>> run = cncsub.loads(text, control="fanuc-0i-f").run(variables={100: 0}, watch=[100])
        >>> run.watch(100).plot().data[0].y
        (0.0, 1.0, 2.0, 3.0, 3.0)
        """
        from cncsub.plot.watch import watch_figure

        return watch_figure(self, over=over, title=title)

    def _chosen(self) -> Column | None:
        """Return the rows of the variables that were asked for; `None` stands for all rows."""
        if self._only is None:
            return None
        if self._looked != self.core.changes:
            import numpy as np

            numbers = self.core.change_column("variable")
            self._looked = len(numbers)
            self._places = np.flatnonzero(np.isin(numbers, self._only))
        return self._places

    @property
    def programs(self) -> list[str]:
        """The names that the codes of the column `program` stand for."""
        return self.core.program_names

    def _rows(self) -> int:
        chosen = self._chosen()
        return self.core.changes if chosen is None else len(chosen)

    def _row(self, index: int) -> Change:
        chosen = self._chosen()
        return Change(*self.core.change_row(index if chosen is None else int(chosen[index])))

    def _fetch(self, names: list[str]) -> dict[str, Column]:
        chosen = self._chosen()
        columns = {name: self.core.change_column(name) for name in names}
        if chosen is None:
            return columns
        return {name: column[chosen] for name, column in columns.items()}

    def texts_of(self, name: str) -> list[str] | None:
        return self.programs if name == "program" else None

    def size_words(self) -> str:
        watched = ", ".join(map(self._name, self.beginning))
        nothing = f"nothing: run(watch=[100]) watches {self._name(100)}"
        return f"{super().size_words()} of {watched or nothing}"

    def _name(self, number: int) -> str:
        return _core.variable_name(self.core.control, number)


class Conditions(Table[Compared]):
    """One row per comparison that a condition made, in order: `step, left, operator, right, holds,
    program, n, line`. They are kept where `run(conditions=True)` asks for them.

    A condition of several comparisons, `[#1 LT 5] AND [#2 GT 0]`, has a row for each. One that
    compares nothing has a row with its value as `left` and an empty `operator`.

    >>> import cncsub
    >>> text = "O1\\nN10 #1=#1+1\\nN20 IF[#1LT3]GOTO10\\nM30\\n"
    >>> run = cncsub.loads(text, control="fanuc-0i-f").run(conditions=True)
    >>> [str(compared) for compared in run.conditions]
    ['1 LT 3: true', '2 LT 3: true', '3 LT 3: false']
    >>> run.conditions.left.tolist(), run.conditions.holds.tolist()
    ([1.0, 2.0, 3.0], [1, 1, 0])
    """

    _title = "comparisons"
    _nulls = frozenset(("left", "right", "n"))

    @property
    def columns(self) -> list[str]:
        return _field_names(Compared)

    @property
    def programs(self) -> list[str]:
        """The names that the codes of the column `program` stand for."""
        return self.core.program_names

    @property
    def operators(self) -> list[str]:
        """The texts that the codes of the column `operator` stand for."""
        return self.core.operator_texts

    def _rows(self) -> int:
        return self.core.compared

    def _row(self, index: int) -> Compared:
        return Compared(*self.core.compared_row(index))

    def _fetch(self, names: list[str]) -> dict[str, Column]:
        return {name: self.core.compared_column(name) for name in names}

    def texts_of(self, name: str) -> list[str] | None:
        return {"program": self.programs, "operator": self.operators}.get(name)


class Codes(Table[SentCode]):
    """One row per M, T and S code sent to the machine, in order: `kind, value, step, program, n,
    line`. Kinds are `M`, `T` and `S`; in a block they come as T, S, M. A code that calls a program
    or only ends one is not sent; S with G50 or G92 is no speed.

    >>> import cncsub
    >>> text = "O1\\nN10 T2 M6\\nN20 S1500 M3\\nN30 M30\\n"
    >>> run = cncsub.loads(text, control="fanuc-0i-f").run()
    >>> [(code.kind, code.value, code.n) for code in run.codes]
    [('T', 2, 10), ('M', 6, 10), ('S', 1500, 20), ('M', 3, 20)]
    >>> run.codes.value[run.codes.kind == "S"].tolist()
    [1500.0]
    """

    _title = "codes"
    _nulls = frozenset(("n",))

    @property
    def columns(self) -> list[str]:
        return _field_names(SentCode)

    @property
    def programs(self) -> list[str]:
        """The names that the codes of the column `program` stand for."""
        return self.core.program_names

    @property
    def kinds(self) -> list[str]:
        """The texts that the codes of the column `kind` stand for."""
        return ["M", "T", "S"]

    def _rows(self) -> int:
        return self.core.codes

    def _row(self, index: int) -> SentCode:
        return SentCode(*self.core.code_row(index))

    def _fetch(self, names: list[str]) -> dict[str, Column]:
        return {name: self.core.code_column(name) for name in names}

    def texts_of(self, name: str) -> list[str] | None:
        return {"program": self.programs, "kind": self.kinds}.get(name)


class Calls(Table[Call]):
    """One row per entered call, in the order of entry; printed as a tree.

    Columns: `call, parent, kind, program, start_n, repeats, level, first_step, last_step,
    caller_step`. A row also has `arguments`: the local variables that the call was given, by
    number or name.

    >>> import cncsub
    >>> text = "O1\\nN10 G65 P2 A1. B2.5\\nN20 M30\\nO2\\nN30 M98 P3 L4\\nN40 M99\\nO3\\nN50 M99\\n"
    >>> run = cncsub.loads(text, control="fanuc-0i-f").run()
    >>> run.calls
    G65 O2 (6 blocks)
      M98 O3, 4 passes (4 blocks)
    2 calls
    >>> run.calls[0].arguments
    {1: 1.0, 2: 2.5}
    >>> text = "%_N_MAIN_MPF\\nPART(4)\\nM30\\n%_N_PART_SPF\\nPROC PART(REAL DEPTH)\\nM17\\n"
    >>> cncsub.loads(text, control="siemens-one").run().calls[0].arguments
    {'DEPTH': 4.0}
    """

    _title = "calls"
    _nulls = frozenset(("parent", "start_n", "last_step"))

    @property
    def columns(self) -> list[str]:
        return [name for name in _field_names(Call) if name != "arguments"]

    @property
    def programs(self) -> list[str]:
        """The names that the codes of the column `program` stand for."""
        return self.core.program_names

    @property
    def kinds(self) -> list[str]:
        """The texts that the codes of the column `kind` stand for: `M98`, `G65`, `M-code` and so
        on.
        """
        return self.core.kind_names

    def _rows(self) -> int:
        return self.core.calls

    def _row(self, index: int) -> Call:
        call, parent, kind, program, start_n, *counts = self.core.call_row(index)
        repeats, level, first_step, last_step, caller_step = counts
        arguments = self.core.call_arguments(index)
        return Call(
            call,
            known_or_none(parent),
            kind,
            program,
            known_or_none(start_n),
            repeats,
            level,
            first_step,
            known_or_none(last_step),
            caller_step,
            arguments,
        )

    def _fetch(self, names: list[str]) -> dict[str, Column]:
        return {name: self.core.call_column(name) for name in names}

    def texts_of(self, name: str) -> list[str] | None:
        return {"program": self.programs, "kind": self.kinds}.get(name)

    def plot(self, *, over: str = "time", title: str | None = None) -> Figure:
        """Draw the calls as an icicle, a figure of plotly (`cncsub[plot]`): each call is a bar from
        its beginning to its end, below the call that made it. `over`: `"time"` (s, that of the
        moves) or `"steps"`. Calls too short to be seen are drawn together, with their number.

        Raises `ImportError` without plotly, and `ValueError` for another axis.

        >>> import cncsub
        >>> text = "O1\\nN10 M98 P2 L2\\nN20 M30\\nO2\\nN30 G91 G1 X9. F90\\nN40 M99\\n"
        >>> run = cncsub.loads(text, control="fanuc-0i-f").run()
        >>> [(bar.name, bar.base.tolist(), bar.x.tolist()) for bar in run.calls.plot().data]
        [('O2', [0.0], [12.0])]
        """
        from cncsub.plot.calls import calls_figure

        return calls_figure(self, over=over, title=title)

    def tree(self, *, most: int = _DRAWN) -> list[CallTree]:
        """Return the first `most` calls as trees; equal neighbours are one tree with a count."""
        return trees(self[:most])

    def __repr__(self) -> str:
        lines: list[str] = []
        write_lines(self.tree(), lines.append, most=40)
        if len(self) > _DRAWN:
            lines.append(f"... only the first {_DRAWN:,} calls are drawn")
        return "\n".join([*lines, self.size_words()])

    def _repr_html_(self) -> str:
        from cncsub.notebook import calls_html

        return calls_html(self)

    def __str__(self) -> str:
        return repr(self)


_ALL_AXES = "xyzabcuvw"
_LOOKED_AT = 500  # moves looked at for a feed that depends on the spindle
_WORKED_OUT = frozenset(("length", "time"))
_MORE = ("sx", "sy", "sz", "msx", "msy", "msz", "mcx", "mcy", "mcz", "cycle", "compensated")
_FEED_MODES = ["per-minute", "per-revolution", "inverse-time"]


class Bounds(dict[str, tuple[float, float]]):
    """Values by axis, found as `X` or, like the columns, as `x`."""

    def __missing__(self, axis: object) -> tuple[float, float]:
        if isinstance(axis, str) and axis.islower() and axis.upper() in self:
            return self[axis.upper()]
        raise KeyError(f"no move has the axis {axis!r}; there are {', '.join(self) or 'none'}")

    def __contains__(self, axis: object) -> bool:
        return super().__contains__(axis.upper() if isinstance(axis, str) else axis)

    def get(self, axis: str, default: Any = None) -> Any:
        try:
            return self[axis]
        except KeyError:
            return default


class Moves(Table[Move]):
    """One row per motion (a canned cycle makes several).

    Columns: `move, step, kind`, the axes in use (`x, y, z` ...) and their machine positions (`mx,
    my, mz` ...), `cx, cy, cz, plane, feed, feed_mode, spindle, tool, h, d, length, time, skip` and
    the block of the step, `program, n, line`. The columns `more_columns` are there when they are
    asked for by name: `sx, sy, sz, msx, msy, msz, mcx, mcy, mcz, cycle, compensated`. A row has
    them all. `column_facts` says what each holds.

    >>> import cncsub
    >>> text = "O1\\nN10 G91 G1 X30. Y40. F100\\nN20 M30\\n"
    >>> run = cncsub.loads(text, control="fanuc-0i-f").run()
    >>> move = run.moves[0]
    >>> move.kind, move.x, move.y, move.length, move.time
    ('feed', 30.0, 40.0, 50.0, 30.0)
    >>> run.moves.total_length, run.moves.bounds["X"]
    (50.0, (30.0, 30.0))
    >>> move.sx, move.msy, run.moves.cycle.tolist()
    (0.0, 0.0, [False])
    """

    _title = "moves"
    _nulls = frozenset(("cx", "cy", "cz", "n", "line", "mcx", "mcy", "mcz"))

    def __init__(self, core: _core.Trace, axes: list[str] | None = None) -> None:
        super().__init__(core)
        self._axes = axes

    @property
    def axes(self) -> list[str]:
        """The axes that the moves name, written as the columns are; in a part of a stream, the axes
        that the programs in memory name.
        """
        return self.core.move_axes if self._axes is None else self._axes

    @property
    def columns(self) -> list[str]:
        in_use = {*self.axes, "x", "y", "z"}
        unused = {name for axis in _ALL_AXES for name in (axis, f"m{axis}") if axis not in in_use}
        unused.update(_MORE)
        return [name for name in _field_names(Move) if name not in unused]

    @property
    def more_columns(self) -> list[str]:
        return list(_MORE)

    @property
    def programs(self) -> list[str]:
        """The names that the codes of the column `program` stand for."""
        return self.core.program_names

    @property
    def kinds(self) -> list[str]:
        """The texts that the codes of the column `kind` stand for."""
        return self.core.move_kinds

    @property
    def feed_modes(self) -> list[str]:
        """The texts that the codes of the column `feed_mode` stand for."""
        return list(_FEED_MODES)

    @property
    def skips(self) -> list[str]:
        """The texts that the codes of the column `skip` stand for."""
        return self.core.skip_names

    @property
    def total_length(self) -> float:
        """The length of all moves, mm."""
        return self.core.path_length

    @property
    def total_time(self) -> float:
        """The time of all moves, s: feeds, rapid rates and dwells. Where a feed depends on a
        spindle that was never given a speed, the spindle counts as one revolution a minute.
        """
        return self.core.time

    @property
    def time_words(self) -> str:
        """The time of all moves for people, such as `1 h 16 min 20.6 s`. It says so where a feed
        depends on a spindle that was never given a speed.
        """
        words = _duration(self.total_time)
        looked_at = range(min(len(self), _LOOKED_AT))
        if any(_waits_for_spindle(self[row]) for row in looked_at):
            words += " (at one revolution per minute where the program gives no S)"
        return words

    @property
    def bounds(self) -> dict[str, tuple[float, float]]:
        """The lowest and the highest coordinate of the moves by axis, with the extremes of arcs;
        programmed path, work coordinates. `"x"` is `"X"`.
        """
        return Bounds({axis.upper(): pair for axis, pair in self.core.bounds.items()})

    def _rows(self) -> int:
        return self.core.moves

    def _row(self, index: int) -> Move:
        row = self.core.move_row(index)
        values = {name: number_or_none(row[name]) for name in (*self.columns, *_MORE)}
        return Move(**{**values, "feed_mode": self.feed_modes[row["feed_mode"]]})

    def _fetch(self, names: list[str]) -> dict[str, Column]:
        if not _WORKED_OUT.isdisjoint(names):  # one pass over the moves computes both
            names = [*names, *_WORKED_OUT.difference(names)]
        columns = self.core.move_columns(names)
        for name in ("cycle", "compensated"):
            if name in columns:
                columns[name] = columns[name].astype(bool)
        return columns

    def texts_of(self, name: str) -> list[str] | None:
        if name == "program":
            return self.programs
        texts = {"kind": self.kinds, "feed_mode": self.feed_modes, "skip": self.skips}
        return texts.get(name)


def _waits_for_spindle(move: Move) -> bool:
    turning = move.feed_mode == "per-revolution" and move.spindle == 0
    return turning and move.kind not in ("rapid", "dwell")


def _duration(seconds: float) -> str:
    """Return a duration as `1 h 16 min 20.6 s`."""
    minutes, rest = divmod(seconds, 60)
    hours, minutes = divmod(int(minutes), 60)
    parts = [f"{hours} h" if hours else "", f"{minutes} min" if minutes or hours else ""]
    return " ".join([*filter(None, parts), f"{rest:.1f} s"])
