"""The base of all tables of a run: rows and columns. Columns are NumPy arrays, rows small objects.

NumPy is imported when a column is asked for, pandas and pyarrow by `to_pandas`, `to_arrow` and
whatever reads the Arrow stream (`polars.DataFrame(run.moves)`, `duckdb.sql("select * from steps")`,
`pyarrow.table(run.calls)`).
"""

from __future__ import annotations

import math
import operator
import shutil
import textwrap
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Generic, TypeVar, overload

from cncsub import _core
from cncsub.pickling import NotPicklable
from cncsub.tables.rows import Call, Change, Compared, Move, Origin, SentCode, Step

if TYPE_CHECKING:
    import numpy as np
    import pandas as pd
    import pyarrow as pa

    from cncsub.tables.columns import ColumnFacts

    Column = np.ndarray[Any, Any]

Row = TypeVar("Row", bound=Step | Call | Move | Change | Origin | SentCode | Compared)

_NARROW = 80  # letters of a line, where a terminal has no more
_SHOWN = 5  # rows at the head and at the end of a printed table


class Table(NotPicklable, Generic[Row]):
    """Rows and columns of one kind. `table[5]` is a row, `table["n"]` and `table.n` are columns.

    A column is a NumPy array as long as the table, to be read. A column of texts holds `int32`
    codes; the texts stand beside it (`table.programs[code]`), it compares with them
    (`table.program == "O2"`), and they are written out in rows, pandas and Arrow. Where a row has
    `None`, an integer column has -1 and any other one NaN; in pandas, Arrow and polars it is a
    null.
    """

    _title: ClassVar[str]
    _nulls: ClassVar[frozenset[str]] = frozenset()  # columns of numbers where -1 or NaN is none
    _instead = "send to_arrow(), to_pandas() or list(rows)"

    def __init__(self, core: _core.Trace) -> None:
        self.core = core
        self._columns: dict[str, Column] = {}

    # The parts in which tables differ.

    @property
    def columns(self) -> list[str]:
        """The names of the columns, in order."""
        raise NotImplementedError

    @property
    def more_columns(self) -> list[str]:
        """The columns that are computed only when they are asked for by name, here or in
        `to_pandas` and `to_arrow`.
        """
        return []

    @property
    def column_facts(self) -> Mapping[str, ColumnFacts]:
        """What each column holds and its unit, by name; the fields of Arrow have it as metadata."""
        from cncsub.tables.columns import facts_of

        return facts_of(self._title, [*self.columns, *self.more_columns])

    def _rows(self) -> int:
        raise NotImplementedError

    def _row(self, index: int) -> Row:
        raise NotImplementedError

    def _fetch(self, names: list[str]) -> dict[str, Column]:
        raise NotImplementedError

    def texts_of(self, name: str) -> list[str] | None:
        """Return the texts of a column of codes, `None` for any other column."""
        raise NotImplementedError

    # Columns.

    def column(self, name: str) -> Column:
        """Return one column as a NumPy array. A `KeyError` names the columns there are."""
        self._check([name])
        return self.fetched([name])[name]

    def _check(self, names: Iterable[str]) -> list[str]:
        known = [*self.columns, *self.more_columns]
        wanted = list(names)
        for name in wanted:
            if name not in known:
                raise KeyError(
                    f"{self._title} have no column {name!r}; there are {', '.join(known)}"
                )
        return wanted

    def fetched(self, names: list[str]) -> dict[str, Column]:
        """Return these columns. Those that were not asked for before, or have grown, are made
        together.
        """
        rows = len(self)
        known = {name: self._columns.get(name) for name in names}
        missing = [n for n, column in known.items() if column is None or len(column) != rows]
        if missing:
            import numpy  # noqa: F401  # here, not below the engine's functions

            from cncsub.tables.text_column import text_column

            for name, column in self._fetch(missing).items():
                column.flags.writeable = False  # the record of a run cannot be changed
                texts = self.texts_of(name)
                self._columns[name] = column if texts is None else text_column(column, texts)
        return {name: self._columns[name] for name in names}

    def __getattr__(self, name: str) -> Column:
        # Names with an underscore and those of the class are never columns; asking for one must not
        # call back into this table.
        known = not name.startswith("_") and not hasattr(type(self), name)
        if not known or name not in (*self.columns, *self.more_columns):
            raise AttributeError(f"{self._title} have no column {name!r}")
        return self.column(name)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.columns, *self.more_columns]

    # Rows.

    def __len__(self) -> int:
        return self._rows()

    @overload
    def __getitem__(self, key: int) -> Row: ...
    @overload
    def __getitem__(self, key: slice) -> list[Row]: ...
    @overload
    def __getitem__(self, key: str) -> Column: ...
    def __getitem__(self, key: int | slice | str) -> Row | list[Row] | Column:
        if isinstance(key, str):
            return self.column(key)
        if isinstance(key, slice):
            return [self._row(index) for index in range(*key.indices(len(self)))]
        index = operator.index(key)
        if not -len(self) <= index < len(self):
            raise IndexError(f"row {index} of {len(self)} {self._title}")
        return self._row(index % len(self))

    def __iter__(self) -> Iterator[Row]:
        return map(self._row, range(len(self)))

    # Other libraries.

    def to_pandas(self, columns: Sequence[str] | None = None) -> pd.DataFrame:
        """Return a `pandas.DataFrame` of all columns, or of those named. Its data is its own, with
        texts written out. Whole numbers that may be missing are of a type of pandas that has a null
        (`Int32`). Needs pandas (`cncsub[pandas]`). Raises `KeyError` for an unknown name.
        """
        pandas = optional_module("pandas")
        names = self.columns if columns is None else self._check(columns)
        fetched = self._fetch(names)  # a copy: a frame may be changed
        frame: pd.DataFrame = pandas.DataFrame(
            {name: self._of_pandas(pandas, name, fetched[name]) for name in names}, copy=False
        )
        return frame

    def _of_pandas(self, pandas: Any, name: str, column: Column) -> Any:
        texts = self.texts_of(name)
        if texts is not None:
            from cncsub.tables.text_column import text_column

            return text_column(column, texts).to_texts()
        if name in self._nulls and column.dtype.kind == "i":
            return pandas.arrays.IntegerArray(column, column < 0)
        return column

    def to_arrow(self, columns: Sequence[str] | None = None) -> pa.Table:
        """Return a `pyarrow.Table` on all columns as they are, or on those named; a column of texts
        is a dictionary of its codes. The metadata of each field hold its `meaning` and its `unit`.
        Needs `cncsub[arrow]`. Raises `KeyError` for an unknown name.
        """
        arrow = optional_module("pyarrow")
        names = self.columns if columns is None else self._check(columns)
        fetched = self.fetched(names)

        def array(name: str) -> Any:
            import numpy as np

            column = fetched[name].view(np.ndarray)
            texts = self.texts_of(name)
            none = None
            if texts is not None or name in self._nulls:
                none = np.isnan(column) if column.dtype.kind == "f" else column < 0
                none = none if none.any() else None
            values = arrow.array(column, mask=none)
            if texts is None:
                return values
            return arrow.DictionaryArray.from_arrays(values, arrow.array(texts, arrow.string()))

        arrays = [array(name) for name in names]
        return arrow.table(arrays, schema=self._schema(arrow, names, arrays))

    def _schema(self, arrow: Any, names: list[str], arrays: list[Any]) -> Any:
        """Return the schema of these columns: each says what it holds and in what unit."""
        facts = self.column_facts
        return arrow.schema(
            arrow.field(
                name,
                array.type,
                metadata={key: value for key, value in facts[name]._asdict().items() if value},
            )
            for name, array in zip(names, arrays, strict=True)
        )

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        return self.to_arrow().__arrow_c_stream__(requested_schema)

    # Printing.

    def _printed(self) -> tuple[list[str], list[list[str]]]:
        """Return the names of the columns and the shown rows as texts, with a row of dots where
        rows are left out.
        """
        names = self.columns
        total = len(self)
        shown = list(range(total))
        if total > 2 * _SHOWN:
            shown = [*range(_SHOWN), -1, *range(total - _SHOWN, total)]
        rows = [
            ["..."] * len(names)
            if index < 0
            else [_cell(getattr(self._row(index), name)) for name in names]
            for index in shown
        ]
        return names, rows

    def size_words(self) -> str:
        """Return how many rows there are, such as `12 moves`."""
        count = len(self)
        return f"{count:,} {self._title[:-1] if count == 1 else self._title}"

    def __repr__(self) -> str:
        names, rows = self._printed()
        if not rows:
            return self.size_words()
        widths = [max(map(len, cells)) for cells in zip(names, *rows, strict=True)]
        shown = _fitting(widths, max(_NARROW, shutil.get_terminal_size((_NARROW, 24)).columns))
        lines = [
            "  ".join(cell.rjust(width) for cell, width in zip(row[:shown], widths)).rstrip()
            for row in (names, *rows)
        ]
        size = self.size_words()
        if shown < len(names):
            more = f"{size}; and the columns {', '.join(names[shown:])}"
            size = "\n".join(textwrap.wrap(more, _NARROW, subsequent_indent="  "))
        return "\n".join([*lines, size])

    def _repr_html_(self) -> str:
        from cncsub.escapes import escape

        names, rows = self._printed()
        head = "".join(f"<th>{escape(name)}</th>" for name in names)
        body = "".join(
            f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in row)}</tr>" for row in rows
        )
        table = f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"
        return f"{table}<p>{escape(self.size_words())}</p>"


def _fitting(widths: Sequence[int], room: int) -> int:
    """Return how many of the first columns of a table fit into `room` together."""
    taken = 0
    for shown, width in enumerate(widths):
        taken += width + (2 if shown else 0)
        if taken > room:
            return max(1, shown)
    return len(widths)


def optional_module(module: str) -> Any:
    """Import a library that only some users need; `ImportError` says how to install it."""
    import importlib

    try:
        return importlib.import_module(module)
    except ImportError as error:
        package = module.partition(".")[0]
        extra = {"pyarrow": "arrow", "plotly": "plot", "rich": "cli"}.get(package, package)
        raise ImportError(
            f"this needs {package}; install it with: pip install 'cncsub[{extra}]'"
        ) from error


def _cell(value: object) -> str:
    if value is None:
        return "-"
    return f"{value:.4f}".rstrip("0").rstrip(".") if isinstance(value, float) else str(value)


def known_or_none(index: int | None) -> int | None:
    """Return `None` for -1, the missing number of a column."""
    return None if index is None or index < 0 else index


def number_or_none(value: Any) -> Any:
    """Return `None` for NaN, the missing number of a column."""
    return None if isinstance(value, float) and math.isnan(value) else value


def records(table: Table[Any], as_text: Callable[[str], str] = str) -> Iterator[Mapping[str, Any]]:
    """Yield the rows as mappings of the columns. They are read by columns, which is fast on long
    tables. NaN is `None`, and texts go through `as_text`.
    """
    names = table.columns
    table.fetched(names)
    columns = [_plain_values(table, name, as_text) for name in names]
    for values in zip(*columns, strict=True):
        yield dict(zip(names, values, strict=True))


_NO_INDEX = frozenset(("step", "n", "line", "parent", "start_n", "last_step"))


def _plain_values(table: Table[Any], name: str, as_text: Callable[[str], str]) -> list[Any]:
    texts = table.texts_of(name)
    values = table.column(name).tolist()
    if texts is not None:
        texts = [as_text(text) for text in texts]
        return [None if code < 0 else texts[code] for code in values]
    if name in _NO_INDEX:
        return [known_or_none(value) for value in values]
    return [number_or_none(value) for value in values]
