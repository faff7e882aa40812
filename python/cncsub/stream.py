"""A run in parts: what a long program does, in constant memory."""

from __future__ import annotations

import contextlib
import copy
import functools
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

from cncsub import _core
from cncsub.files import StrPath
from cncsub.run import Recorded, State, Stop
from cncsub.tables.table import Table, optional_module
from cncsub.variables import Variables

if TYPE_CHECKING:
    from pyarrow.parquet import ParquetWriter

TABLES = ("steps", "calls", "moves")


def _tables(trace: _core.Trace) -> tuple[str, ...]:
    return (*TABLES, "watch") if trace.watched else TABLES


class Part(Recorded):
    """The record of one stretch of a stream.

    The tables and the numbers in them are those of a run: all parts in order are the tables of the
    run. A call is a row of the part in which it ended. The columns are the same in every part:
    `moves` has those of all axes that the programs in memory name.
    """

    _instead = "send its tables: moves.to_arrow(), steps.to_arrow()"

    def __repr__(self) -> str:
        tables = (getattr(self, name).size_words() for name in _tables(self.recorded))
        return f"<Part: {', '.join(tables)}>"


class Stream(State):
    """A run that hands over its record part by part while it runs, and keeps no part.

    >>> import cncsub
    >>> text = "O1\\nN10 M98 P2 L9999\\nN20 M30\\nO2\\nN30 G91 G0 X1.\\nN40 M99\\n"
    >>> stream = cncsub.loads(text, control="fanuc-0i-f").stream(rows=8000)
    >>> [(len(part.steps), len(part.calls), len(part.moves)) for part in stream]
    [(8000, 0, 4000), (8000, 0, 4000), (4000, 1, 1999)]
    >>> stream.stop, stream.blocks, stream.position["X"]
    (<Stop.END: 'end'>, 20000, 9999.0)
    """

    def __init__(self, core: _core.Machine, rows: int, trace: str) -> None:
        super().__init__(core)
        self._rows = rows
        self._trace = trace
        self._axes = core.axes
        self._begun = False

    def __iter__(self) -> Iterator[Part]:
        return self

    def __next__(self) -> Part:
        """Run on for `rows` blocks and hand over what they did. A part is shorter at the end, and
        where its blocks made more than a million moves or changes.
        """
        if self.core.stop is not None:
            raise StopIteration
        self._begun = True
        self.core.run_blocks(self._rows)
        return Part(self.core.take(), self._axes)

    @property
    def stop(self) -> Stop | None:
        """Why the run stopped, `None` as long as there are parts to come."""
        return None if self.core.stop is None else Stop(self.core.stop)

    @functools.cached_property
    def variables(self) -> Variables:
        """The variables now; `#1` and so on are those of the main program."""
        return Variables(self.core, 0)

    def to_parquet(self, folder: StrPath) -> None:
        """Run to the end and write the tables as Parquet files into `folder`, which is made:
        `steps-000000.parquet`, `steps-000001.parquet` ..., and likewise `calls`, `moves` and, where
        variables are watched, `watch`. A file has a million rows and more. A table without rows, as
        `moves` is with `trace="blocks"`, is one file without rows. Needs `cncsub[arrow]`.

        Ctrl-C ends the run as `Stop.INTERRUPTED`. A file gets its name when it is complete.
        Whatever stops the run, even a power cut, every file in the folder can be read, and
        `pandas.read_parquet(sorted(folder.glob("moves-*.parquet")))` or
        `duckdb.sql("from 'folder/moves-*.parquet'")` gives what was written so far. Raises
        `FileExistsError` where the folder holds such files already; `ValueError` where parts of the
        stream were taken before, and with `trace="none"` and nothing watched, which leaves nothing
        to write.
        """
        if self._begun:
            raise ValueError(
                "parts of this stream were already read and would be missing from the files;"
                " make a new stream"
            )
        tables = _tables(self.core.trace)
        if self._trace == "none" and tables == TABLES:
            raise ValueError("a stream with trace='none' records nothing that could be written")
        folder = Path(folder)
        folder.mkdir(parents=True, exist_ok=True)
        for name in tables:
            if next(folder.glob(f"{name}-*.parquet*"), None) is not None:
                raise FileExistsError(f"{folder} holds {name} of another run; give another folder")
        with contextlib.ExitStack() as open_files:
            files = {name: open_files.enter_context(_Files(folder, name)) for name in tables}
            try:
                for part in self:
                    for name, table in files.items():
                        table.write(getattr(part, name))
            except KeyboardInterrupt:  # Ctrl-C while the part was written
                self.core.interrupt()

    def coverage(self) -> NoReturn:
        """Raise `ValueError`, which says what to do instead. A stream keeps no blocks to count, and
        a part does not know how the calls and loops that are open in it began.
        """
        raise ValueError(
            "a stream does not keep the blocks that coverage counts: use the coverage of"
            ' library.run(..., trace="blocks") or of library.machine()'
        )

    def __copy__(self) -> Stream:
        """Return a stream in the same state that runs on its own."""
        twin = Stream(self.core.copy(), self._rows, self._trace)
        twin._begun = self._begun
        return twin

    def __deepcopy__(self, memo: object) -> Stream:
        return copy.copy(self)

    def __repr__(self) -> str:
        return f"<Stream: {self.summary()}, {self.blocks:,} block{'s' if self.blocks != 1 else ''}>"


class _Files:
    """One table of a stream as numbered Parquet files."""

    _FULL = 1 << 20  # rows of a file

    def __init__(self, folder: Path, name: str) -> None:
        self._folder = folder
        self._name = name
        self._number = 0
        self._rows = 0
        self._writer: ParquetWriter | None = None
        self._schema: Any = None

    def write(self, table: Table[Any]) -> None:
        rows = table.to_arrow()
        if self._schema is None:
            self._schema = rows.schema
        if len(table) == 0:
            return
        if self._writer is None:
            parquet = optional_module("pyarrow.parquet")
            self._writer = parquet.ParquetWriter(self._path(whole=False), rows.schema)
        self._writer.write_table(rows)
        self._rows += len(table)
        if self._rows >= self._FULL:
            self._finish()

    def _path(self, *, whole: bool) -> Path:
        return self._folder / f"{self._name}-{self._number:06}.parquet{'' if whole else '.part'}"

    def _finish(self) -> None:
        if self._writer is None:
            return
        self._writer.close()
        part = self._path(whole=False)
        if part.exists():  # Ctrl-C may have come after the line below
            part.replace(self._path(whole=True))
        self._writer = None
        self._number += 1
        self._rows = 0

    def __enter__(self) -> _Files:
        return self

    def __exit__(self, *_: object) -> None:
        if self._number == 0 and self._writer is None and self._schema is not None:
            # A table without rows is a file without rows.
            parquet = optional_module("pyarrow.parquet")
            self._writer = parquet.ParquetWriter(self._path(whole=False), self._schema)
        self._finish()
        # Ctrl-C may have come when the next file was there and its writer was not.
        self._path(whole=False).unlink(missing_ok=True)
