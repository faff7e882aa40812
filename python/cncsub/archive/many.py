"""Whole archives: every program of some folders is run or checked, and each becomes a row.

The work goes in chunks to processes, or to any `concurrent.futures.Executor`; a Dask cluster is one
by `client.get_executor()`. As many chunks are under way as keep the workers busy, so that memory
does not grow with the archive.
"""

from __future__ import annotations

import contextlib
import os
import sys
import warnings
from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Executor, Future, wait
from itertools import islice
from pathlib import Path
from typing import Any, Unpack

from cncsub import system
from cncsub._core import Control
from cncsub.archive.store import Folder, InMemory
from cncsub.archive.work import Job, Row, Task, Work, do_chunk, done_apart, end_pool, new_pool
from cncsub.controls import control_of
from cncsub.files import Reading, StrPath, check_encoding, clean, first_time, walk
from cncsub.loading import loads
from cncsub.option_errors import wrong_value
from cncsub.run_options import MdiOptions, stated, takes
from cncsub.setup import Setup
from cncsub.tables.table import optional_module

EACH = ("file", "beside", "folder")
LIMITS: MdiOptions = {"max_blocks": 1_000_000, "max_seconds": 10.0, "max_memory": 1 << 29}
_LARGEST_CHUNK, _FIRST_CHUNK = 256, 8  # jobs
_MOST_JOBS = 1024
_MOST_UNKNOWN = 64  # chunks under way on an executor that does not tell its workers
# Reasons for which the walk leaves entries alone that may have been meant to be run.
_UNREADABLE = ("a broken link", "cannot be opened")

Paths = StrPath | Iterable[StrPath]


@takes(MdiOptions, "trace", defaults=LIMITS)
def run_many(
    paths: Paths,
    control: str | Control,
    *,
    each: str = "file",
    external: StrPath | None = None,
    encoding: str | None = None,
    executor: Executor | None = None,
    jobs: int | None = None,
    out: StrPath | None = None,
    progress: bool = False,
    **options: Unpack[MdiOptions],
) -> Any:
    """Run every program file of some files and folders: a row for each, in the order of the files.

    `each`: what is loaded for one run, `"file"` the file alone, `"beside"` the file with all files
    of its folder, and of the folders beside it that the control searches, as the memory,
    `"folder"` each folder with its first file as the main program.
    `external`, `encoding`: as in `load`. `options`: those of `Library.run` but `trace`; without
    them a run may take 1,000,000 blocks, 10 seconds and 512 MiB.

    `executor`: any `concurrent.futures.Executor`, such as `client.get_executor()` of Dask, whose
    workers must see the same files; without it `jobs` processes, as many as there are cores. They
    are spawned: a script calls this below `if __name__ == "__main__":`. A chunk whose worker dies
    is done again in a process of this machine, by halves, and a `RuntimeWarning` tells why.

    Returns a `pyarrow.Table`, or with `out` a `pyarrow.dataset.Dataset` on that folder: the same
    call resumes one that was ended, and only new and changed files are run (by size and time; what
    is outside their folder, as `external`, is not looked at). Rows of files that are no longer
    there stay in it, and resumed rows stand at its end.

    Columns: `path`, `control`, `status`, `stop`; `cause`, `number`, `text` of the alarm;
    `program`, `n`, `line`, `column` where it stopped; `blocks`, `calls`, `moves`; `length` in mm,
    `time` of machining in s, `seconds` of the computer, `error`. `status` is `ran`, `alarm`,
    `waiting`, `limit`, `cycles`, `unreadable` or `crashed`; a bad file is a row, never an error.
    What folders hold besides programs is counted by reason in the schema's `cncsub.skipped`.
    `progress` shows a bar on a terminal (`cncsub[cli]`).

    Raises `ValueError` and `TypeError` for wrong options, `ImportError` without `cncsub[arrow]`.

    >>> import cncsub
    >>> cncsub.run_many([], control="fanuc-0i-f").num_rows
    0
    """
    for name in options:
        if name not in stated(MdiOptions) or name == "trace":
            raise TypeError(f"run_many has no option {name!r}, only those of run")
    asked = {**LIMITS, **options}
    task = task_of("run", control, each, external, encoding, asked)
    # Wrong options are told now, not in every row.
    loads("", control=task.control, external=external).run(**asked)  # type: ignore[arg-type]
    return _batch(task, paths, executor, jobs, out, progress)


def check_many(
    paths: Paths,
    control: str | Control,
    *,
    each: str = "file",
    external: StrPath | None = None,
    encoding: str | None = None,
    executor: Executor | None = None,
    jobs: int | None = None,
    out: StrPath | None = None,
    progress: bool = False,
    rules: Iterable[str] | None = None,
    setup: Setup | Mapping[str, Any] | None = None,
    entry: Iterable[str] = (),
) -> Any:
    """Check every program file of some files and folders: a row for each finding, and one for each
    file that cannot be read. A file without findings has no row, unless it is `foreign`.

    `rules`, `setup` and `entry` are those of `Library.check`, the other arguments those of
    `run_many`, and so is what is returned and raised. Columns: `path`, `control`, `status`
    (`finding`, `unreadable`, `crashed`, or `foreign` where nothing is found in a language that no
    control reads), those of a `Finding`, with the number of its alarm, and `error`.

    >>> import cncsub
    >>> cncsub.check_many([], control="fanuc-0i-f").column_names[:4]
    ['path', 'control', 'status', 'rule']
    """
    entry = entry if isinstance(entry, str) else tuple(entry)
    asked = {"rules": rules, "setup": setup, "entry": entry or None}
    options = {name: value for name, value in asked.items() if value is not None}
    task = task_of("check", control, each, external, encoding, options)
    # Wrong options are reported now, not in every row.
    loads("", control=task.control).check(rules=rules, setup=setup, entry=entry)
    return _batch(task, paths, executor, jobs, out, progress)


def task_of(
    kind: str,
    control: str | Control,
    each: str,
    external: StrPath | None,
    encoding: str | None,
    options: Any,
) -> Task:
    if each not in EACH:
        raise wrong_value("each", f"each must be one of {', '.join(EACH)}, not {each!r}")
    check_encoding(encoding)
    place = None if external is None else str(Path(external).absolute())
    known = control_of(control)
    return Task(kind, known, each, place, encoding, dict(options), known.name)


def _batch(
    task: Task,
    paths: Paths,
    executor: Executor | None,
    jobs: int | None,
    out: StrPath | None,
    progress: bool,
) -> Any:
    if jobs is not None and jobs < 1:
        raise wrong_value(
            "jobs", f"jobs, the number of processes, must be at least 1, not {jobs!r}"
        )
    if jobs is not None and jobs > _MOST_JOBS:
        raise wrong_value(
            "jobs", f"jobs, the number of processes, must be at most {_MOST_JOBS:,}, not {jobs!r}"
        )
    store = InMemory(task) if out is None else Folder(Path(out), task)
    skipped: dict[str, int] = {}
    found = jobs_of(paths, task.each, skipped, marks=out is not None)
    wanted = (job for job in found if not store.is_done(job))
    with _bar(progress) as advance, contextlib.closing(Crew(executor, jobs)) as crew:
        for number, chunk, rows in crew.done(do_chunk, task, wanted):
            store.add(number, chunk, rows)
            advance(len(chunk))
    return store.result(skipped)


# ---- what is to be done ----


def listed_paths(paths: Paths) -> list[StrPath]:
    """Return one path or several as a list."""
    return [paths] if isinstance(paths, str | os.PathLike) else list(paths)


def jobs_of(
    paths: Paths, each: str, skipped: dict[str, int], *, marks: bool = False
) -> Iterator[Job]:
    """Yield the jobs in the order of the paths, each file and folder once."""
    reading = Reading()
    for given in listed_paths(paths):
        path = Path(given)
        if not path.is_dir():
            if first_time(os.path.realpath(path.parent), path.name, reading):
                yield _named_job(path, each, marks)
            continue
        for before, names, real in walk(path, reading):
            yield from _folder_jobs(before, names, real, each, reading, marks)
            yield from _left_out(reading, skipped)
        yield from _left_out(reading, skipped)


def _named_job(path: Path, each: str, marks: bool) -> Job:
    before = str(path.parent / "_")[:-1]
    fault = None
    if not os.path.lexists(path):
        fault = "no such file or folder"
    elif not path.exists():
        fault = "a broken link"
    siblings = next(walk(path.parent, Reading()), ("", [], ""))[1] if each == "beside" else []
    mark = _mark(before, [path.name, *siblings]) if marks else ""
    return Job(clean(str(path)), before, (path.name,), fault, mark)


def _folder_jobs(
    before: str, names: list[str], real: str, each: str, reading: Reading, marks: bool
) -> Iterator[Job]:
    if each == "folder":
        if names:
            mark = _mark(before, names) if marks else ""
            yield Job(clean(before.rstrip(os.sep) or os.sep), before, tuple(names), None, mark)
        return
    whole = _mark(before, names) if marks and each == "beside" else ""
    for name in names:
        if first_time(real, name, reading):
            mark = whole or (_mark(before, [name]) if marks else "")
            yield Job(clean(before + name), before, (name,), None, mark)


def _mark(before: str, names: Sequence[str]) -> str:
    """Return a text that changes when one of these files does."""
    marks = []
    for name in names:
        try:
            status = os.stat(before + name)  # noqa: PTH116
            marks.append(f"{status.st_size}:{status.st_mtime_ns}")
        except OSError:
            marks.append("none")
    return marks[0] if len(marks) == 1 else _hash_of(names, marks)


def _hash_of(names: Sequence[str], marks: Sequence[str]) -> str:
    """Return a short text for the marks of many files."""
    import hashlib

    text = "\n".join(f"{name}\0{mark}" for name, mark in zip(names, marks))
    return hashlib.sha256(text.encode("utf-8", "surrogateescape")).hexdigest()[:32]


def _left_out(reading: Reading, skipped: dict[str, int]) -> Iterator[Job]:
    """Yield a job for each entry that cannot be read; count the others by their reasons."""
    told, reading.skipped = reading.skipped, []
    for path, reason in told:
        # The system's words for a folder begin with a capital: "Permission denied".
        if reason in _UNREADABLE or reason[:1].isupper():
            yield Job(clean(path), "", (), reason)
        else:
            skipped[reason] = skipped.get(reason, 0) + 1


# ---- who does it ----


class Crew:
    """The workers: an executor that was given, or processes of our own."""

    def __init__(self, executor: Executor | None, jobs: int | None) -> None:
        self._given = executor
        self._own: Executor | None = None
        self._workers = jobs or system.cores()
        told = getattr(executor, "_max_workers", None)
        self._most = _MOST_UNKNOWN  # chunks under way
        if executor is None:
            self._most = 2 * self._workers
        elif isinstance(told, int):
            self._most = 2 * told

    def done(
        self, work: Work, task: Task, jobs: Iterator[Job]
    ) -> Iterator[tuple[int, list[Job], list[list[Row]]]]:
        """Yield each chunk when it is done: its number, its jobs and their rows."""
        waiting: dict[Future[list[list[Row]]], tuple[int, list[Job]]] = {}
        number = 0
        try:
            while chunk := list(islice(jobs, self._size(number))):
                if len(waiting) >= self._most:
                    yield from self._collected(work, task, waiting)
                waiting[self._submit(work, task, chunk)] = number, chunk
                number += 1
            while waiting:
                yield from self._collected(work, task, waiting)
        finally:
            for future in waiting:
                future.cancel()

    def _size(self, number: int) -> int:
        """Return the size of a chunk. The first chunks are small, so that few jobs keep all workers
        busy too.
        """
        return min(_LARGEST_CHUNK, _FIRST_CHUNK << min(number // self._most, 10))

    def _submit(self, work: Work, task: Task, chunk: list[Job]) -> Future[list[list[Row]]]:
        if self._given is not None:
            try:
                return self._given.submit(work, task, chunk)
            except BrokenExecutor:
                self._given = None  # it takes nothing more; the rest is done by processes here
        if self._own is not None:
            try:
                return self._own.submit(work, task, chunk)
            except BrokenExecutor:
                self.close()
        self._own = new_pool(self._workers)
        return self._own.submit(work, task, chunk)

    def _collected(
        self, work: Work, task: Task, waiting: dict[Future[list[list[Row]]], tuple[int, list[Job]]]
    ) -> Iterator[tuple[int, list[Job], list[list[Row]]]]:
        for future in wait(waiting, return_when=FIRST_COMPLETED).done:
            number, chunk = waiting.pop(future)
            try:
                rows = future.result()
            except Exception as error:
                # The fault may lie with the worker or the cluster: the chunk is done again here,
                # and meets it again or not.
                _warn_of(error)
                rows = done_apart(work, task, chunk)
            yield number, chunk, rows

    def close(self) -> None:
        """End the processes that were started here."""
        if self._own is not None:
            end_pool(self._own)
            self._own = None


def _warn_of(error: Exception) -> None:
    """Warn of an error: a cluster that can do nothing must not look like one that is slow."""
    warnings.warn(
        f"a part of the work is repeated in a process of this machine: {type(error).__name__}:"
        f" {error}",
        RuntimeWarning,
        stacklevel=2,
    )


@contextlib.contextmanager
def _bar(wanted: bool) -> Iterator[Any]:
    if not (wanted and sys.stderr.isatty()):
        yield lambda count: None
        return
    console = optional_module("rich.console").Console(stderr=True)
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

    columns = (BarColumn(), TextColumn("{task.completed:.0f} jobs"), TimeElapsedColumn())
    with Progress(*columns, console=console, transient=True) as bar:
        row = bar.add_task("", total=None)
        yield lambda count: bar.advance(row, count)
