"""The rows of a batch: one Arrow table, or a folder of Parquet files that can be resumed.

Each Parquet file holds the rows of one chunk and, in its schema, the path and mark (size and time
of the last change) of its jobs. It is written under another name first, so that every file that is
there is whole. These files alone tell what is done.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from cncsub._core import __version__
from cncsub.archive.work import COLUMNS, Job, Row, Task
from cncsub.files import clean
from cncsub.tables.table import optional_module
from cncsub.writing import put_whole

if TYPE_CHECKING:
    import pyarrow as pa

SKIPPED = "cncsub.skipped"  # metadata of the result: reason to count of what was left out
_DONE = b"cncsub.done"
_ABOUT = "_cncsub.json"  # Arrow reads no file whose name begins so as data


def arrow_schema(kind: str) -> pa.Schema:
    """Return the columns of a batch as Arrow has them."""
    arrow = optional_module("pyarrow")
    return arrow.schema([(name, getattr(arrow, t)()) for name, t in COLUMNS[kind].items()])


def arrow_table(kind: str, jobs: Sequence[Sequence[Row]]) -> pa.Table:
    """Return the rows of a chunk as an Arrow table."""
    arrow = optional_module("pyarrow")
    rows = [row for of_job in jobs for row in of_job]
    schema = arrow_schema(kind)
    columns = list(zip(*rows)) or [()] * len(schema)
    arrays = [arrow.array(map(_plain, column), f.type) for column, f in zip(columns, schema)]
    return arrow.table(arrays, schema=schema)


def _plain(value: Any) -> Any:
    """Return a text without what Arrow refuses in one; anything else as it is."""
    return clean(value) if isinstance(value, str) else value


class InMemory:
    """The tables of the chunks, joined in the order of the jobs."""

    def __init__(self, task: Task) -> None:
        self._task = task
        self._parts: dict[int, pa.Table] = {}
        optional_module("pyarrow")

    def is_done(self, job: Job) -> bool:
        return False

    def add(self, number: int, jobs: Sequence[Job], rows: list[list[Row]]) -> None:
        self._parts[number] = arrow_table(self._task.kind, rows)

    def result(self, skipped: dict[str, int]) -> Any:
        arrow = optional_module("pyarrow")
        parts = [self._parts[number] for number in sorted(self._parts)]
        table = arrow.concat_tables([arrow_table(self._task.kind, []), *parts])
        return table.replace_schema_metadata({SKIPPED: json.dumps(skipped)})


class Folder:
    """A folder of Parquet files, one a chunk.

    Raises `ValueError` for a folder that holds another batch, or something else.
    """

    def __init__(self, out: Path, task: Task) -> None:
        self._parquet = optional_module("pyarrow.parquet")
        self._out, self._task = out, task
        self._done: dict[str, tuple[str, Path]] = {}  # mark, and the file with the rows
        self._changed: dict[Path, set[str]] = {}
        self._first = 0
        about = _about(task)
        out.mkdir(parents=True, exist_ok=True)
        self._check(about)
        self._read_done()
        _put(out / _ABOUT, json.dumps(about, indent=2).encode())

    def _check(self, about: dict[str, str]) -> None:
        try:
            known = json.loads((self._out / _ABOUT).read_bytes())
        except FileNotFoundError:
            if any(self._out.iterdir()):
                raise ValueError(
                    f"{self._out} is not empty and is not the folder of a batch; give a new folder"
                ) from None
            return
        except ValueError:
            known = {}
        if known != about:
            parts = [key for key in about if known.get(key) != about[key]]
            raise ValueError(
                f"{self._out} is the folder of a batch with another {' and '.join(parts)};"
                " give another folder, or delete this one"
            )

    def _read_done(self) -> None:
        for left in self._out.glob(".part-*"):
            left.unlink()  # left by a batch that was ended while it wrote
        for file in sorted(self._out.glob("part-*.parquet")):
            self._first = max(self._first, int(file.stem.partition("-")[2]) + 1)
            for path, mark in json.loads(self._parquet.read_schema(file).metadata[_DONE]):
                if path in self._done:  # done again, and ended before the old rows were removed
                    self._changed.setdefault(self._done[path][1], set()).add(path)
                self._done[path] = mark, file

    def is_done(self, job: Job) -> bool:
        """Return whether the rows of this job are there and its files are as they were."""
        return job.path in self._done and self._done[job.path][0] == job.mark

    def add(self, number: int, jobs: Sequence[Job], rows: list[list[Row]]) -> None:
        """Write the rows of a chunk."""
        name = self._out / f"part-{self._first + number:08}.parquet"
        done = [(job.path, job.mark) for job in jobs]
        self._write(name, arrow_table(self._task.kind, rows), done)
        for job in jobs:
            if job.path in self._done:
                self._changed.setdefault(self._done[job.path][1], set()).add(job.path)

    def _write(self, name: Path, table: pa.Table, done: list[tuple[str, str]]) -> None:
        arrow = optional_module("pyarrow")
        sink = arrow.BufferOutputStream()
        metadata = {_DONE: json.dumps(done).encode()}
        self._parquet.write_table(table.replace_schema_metadata(metadata), sink)
        _put(name, sink.getvalue())

    def result(self, skipped: dict[str, int]) -> Any:
        """Return the folder as a data set, which is read when rows are asked for."""
        for file, paths in self._changed.items():
            self._forget(file, paths)
        self._changed = {}
        dataset = optional_module("pyarrow.dataset")
        files = sorted(str(file) for file in self._out.glob("part-*.parquet"))
        schema = arrow_schema(self._task.kind).with_metadata({SKIPPED: json.dumps(skipped)})
        if not files:
            return dataset.dataset(schema.empty_table())
        return dataset.dataset(files, schema=schema, format="parquet")

    def _forget(self, file: Path, paths: set[str]) -> None:
        """Take the rows of jobs that were done again out of their old file."""
        # One file, not a data set of one: the file may be named as a partition would be.
        table = self._parquet.ParquetFile(file).read()
        compute = optional_module("pyarrow.compute")
        arrow = optional_module("pyarrow")
        old = arrow.array(sorted(paths), arrow.string())
        kept = table.filter(compute.invert(compute.is_in(table["path"], value_set=old)))
        done = json.loads(table.schema.metadata[_DONE])
        self._write(file, kept, [(path, mark) for path, mark in done if path not in paths])


def _about(task: Task) -> dict[str, str]:
    """Return what tells a batch from another one."""
    options = repr((task.each, str(task.external), task.encoding, sorted(task.options.items())))
    control = repr(task.control.__reduce__()[1])
    return {
        "kind": task.kind,
        "control": f"{task.name} {_digest(control)}",
        "options": _digest(options),
        "version": __version__,
    }


def _digest(text: str) -> str:
    return hashlib.sha256(text.encode("utf-8", "replace")).hexdigest()[:16]


def _put(file: Path, data: Any) -> None:
    """Write a file so that it is there whole or not at all."""
    put_whole(file, data, file.with_name(f".{file.name}"))
