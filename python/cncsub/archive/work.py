"""The work on a chunk of jobs: each job becomes rows, whatever its files are."""

from __future__ import annotations

import itertools
import os
import time
from collections.abc import Callable, Sequence
from concurrent.futures import BrokenExecutor, Executor
from pathlib import Path
from typing import Any, NamedTuple

from cncsub import _core
from cncsub._core import Control
from cncsub.archive.gating import gated
from cncsub.files import CoreFile, Reading, StrPath, read_found_files, read_paths, walk
from cncsub.interrupts import uninterrupted
from cncsub.library import Library
from cncsub.reports.hints import foreign_language
from cncsub.run import Run, Stop
from cncsub.sibling_files import searched_folders
from cncsub.system import kept_from_children

Row = tuple[Any, ...]
RUN_COLUMNS = {
    "path": "string",
    "control": "string",
    "status": "string",
    "stop": "string",
    "cause": "string",
    "number": "string",
    "text": "string",
    "program": "string",
    "n": "int64",
    "line": "int64",
    "column": "int64",
    "blocks": "int64",
    "calls": "int64",
    "moves": "int64",
    "length": "float64",  # mm
    "time": "float64",  # s of machining
    "seconds": "float64",  # of the computer
    "error": "string",
}
CHECK_COLUMNS = {
    "path": "string",
    "control": "string",
    "status": "string",
    "rule": "string",
    "name": "string",
    "severity": "string",
    "program": "string",
    "n": "int64",
    "line": "int64",
    "column": "int64",
    "file": "string",
    "word": "string",
    "message": "string",
    "hint": "string",
    "count": "int64",  # in how many places
    "alarm": "string",
    "error": "string",
}
COLUMNS = {"run": RUN_COLUMNS, "check": CHECK_COLUMNS, "gate": CHECK_COLUMNS}


class Job(NamedTuple):
    """One main file, or one folder: its path, what stands before the names of its files, and the
    names. `fault`: why nothing can be read. `mark` changes when the files do.
    """

    path: str
    before: str
    names: tuple[str, ...]
    fault: str | None = None
    mark: str = ""


class Task(NamedTuple):
    """The work that is done with every job of a batch."""

    kind: str  # "run", "check" or "gate"
    control: Control
    each: str
    external: StrPath | None
    encoding: str | None
    options: dict[str, Any]
    name: str  # of the control, which a changed one has to work out


Work = Callable[[Task, Sequence[Job]], list[list[Row]]]


def do_chunk(task: Task, jobs: Sequence[Job]) -> list[list[Row]]:
    """Return the rows of each job, in order."""
    return [_rows(task, job) for job in jobs]


def _rows(task: Task, job: Job) -> list[Row]:
    begun = time.perf_counter()
    try:
        if job.fault is not None:
            raise OSError(job.fault)
        library = _library(task, job)
    except (OSError, ValueError) as error:
        return [bad_row(task, job, "unreadable", _words(error))]
    except Exception as error:  # one file never ends the batch
        return [bad_row(task, job, "crashed", f"{type(error).__name__}: {error}")]
    try:
        left_out = _left_out(task, library)
        if task.kind == "gate":
            return _gate_rows(task, job, library)
        if task.kind == "check":
            language = foreign_language(library, _own_files(job, library))
            found = finding_rows(task, job, library.check(**task.options), language)
            if language and not found:
                found = [bad_row(task, job, "foreign", language)]
            return found + ([bad_row(task, job, "unreadable", left_out)] if left_out else [])
        run = uninterrupted(library.run(**task.options))
        seconds = time.perf_counter() - begun
        language = foreign_language(library, _own_files(job, library))
        return [_run_row(task, job, run, seconds, left_out, language)]
    except Exception as error:
        return [bad_row(task, job, "crashed", f"{type(error).__name__}: {error}")]


def _gate_rows(task: Task, job: Job, library: Library) -> list[Row]:
    """Return a row for each finding, which is its last value."""
    own = _own_files(job, library)
    if (language := foreign_language(library, own)) is not None:
        return [bad_row(task, job, "foreign", language)]
    found = gated(library, own, task.options)
    return [(job.path, task.name, "finding", finding) for finding in found]


def _words(error: Exception) -> str:
    known = isinstance(error, OSError) and error.strerror
    return str(known or error)


def _library(task: Task, job: Job) -> Library:
    reading = Reading()
    real = os.path.realpath(job.before)
    read_found_files(job.before, list(job.names), real, task.encoding, reading)
    if not reading.files:
        raise ValueError(reading.skipped[0][1] if reading.skipped else "no program")
    if task.each == "beside":
        siblings = next(walk(Path(job.before), Reading()), ("", [], ""))[1]
        read_found_files(job.before, siblings, real, task.encoding, reading)
        for folder in searched_folders(job.path, task.control):
            for before, names, inner in itertools.islice(walk(folder, Reading()), 1):
                read_found_files(before, names, inner, task.encoding, reading)
    names = reading.names
    files: list[CoreFile] = reading.rows(False)
    if task.external is not None:
        outside = read_paths([task.external], encoding=task.encoding)
        files += outside.rows(True)
    code = _core.compile(task.control, files, task.external is not None)
    return Library(code, names, reading.skipped)


def _own_files(job: Job, library: Library) -> list[str]:
    """Return the files of a job, without those that lie beside them."""
    return list(library.files)[: len(job.names)]


def _left_out(task: Task, library: Library) -> str:
    """Return the files of a folder that could not be read, and why. In other batches each such file
    has a row of its own.
    """
    return "; ".join(f"{file}: {why}" for file, why in library.skipped if task.each == "folder")


def _run_row(
    task: Task, job: Job, run: Run, seconds: float, left_out: str, language: str | None
) -> Row:
    alarm = run.alarm
    told = [str(alarm.detail)] if alarm is not None else []
    told += [left_out] if left_out else []
    told += [language] if language else []
    ended = run.stop in (Stop.END, Stop.CYCLES)
    # The place where a run stopped that waits or met a limit is its last block.
    place = alarm or (None if ended or not len(run.steps) else run.steps[-1])
    return (
        job.path,
        task.name,
        "ran" if run.stop == Stop.END else str(run.stop),
        str(run.stop),
        alarm and alarm.cause,
        alarm and alarm.number,
        alarm and alarm.text,
        place and place.program,
        place and place.n,
        place and place.line,
        alarm and alarm.column,
        len(run.steps),
        len(run.calls),
        len(run.moves),
        run.moves.total_length,
        run.moves.total_time,
        seconds,
        "; ".join(told) if told else None,
    )


def finding_rows(
    task: Task, job: Job, findings: Sequence[Any], language: str | None = None
) -> list[Row]:
    """Return a row for each finding of one job; the first names a language that no control here
    reads.
    """
    names = list(CHECK_COLUMNS)[3:-2]
    return [
        (
            job.path,
            task.name,
            "finding",
            *(getattr(finding, name) for name in names),
            _number(finding.alarm),
            None if place else language,
        )
        for place, finding in enumerate(findings)
    ]


def _number(alarm: Any) -> str | None:
    """Return the number of an alarm, which is given as an alarm or as its number."""
    found = getattr(alarm, "number", alarm)
    return None if found is None else str(found)


def bad_row(task: Task, job: Job, status: str, error: str) -> Row:
    """Return the row of a job that cannot be done, with the reason."""
    known = {
        "path": job.path,
        "control": task.name,
        "status": status,
        "error": error,
    }
    return tuple(known.get(name) for name in COLUMNS[task.kind])


# ---- workers ----


class WorkersError(RuntimeError):
    """The error where the worker processes cannot start."""


def _ready() -> bool:
    return True


def _end_with_parent() -> None:
    """End a worker with the process that started it, even where that is killed: nothing else would
    tell the worker that no work comes any more.
    """
    import multiprocessing
    import threading

    parent = multiprocessing.parent_process()
    if parent is None:
        return

    def wait() -> None:
        parent.join()
        os._exit(1)

    threading.Thread(target=wait, daemon=True).start()


def new_pool(workers: int) -> Executor:
    """Start processes of our own. They are spawned, because a fork of a process with threads may
    hang.

    Raises `WorkersError` where they cannot start.
    """
    import multiprocessing
    from concurrent.futures import ProcessPoolExecutor

    class Pool(ProcessPoolExecutor):
        def submit(self, *work: Any, **options: Any) -> Any:
            with kept_from_children():
                return super().submit(*work, **options)

    spawned = multiprocessing.get_context("spawn")
    try:
        pool = Pool(workers, mp_context=spawned, initializer=_end_with_parent)
    except (OSError, NotImplementedError, ImportError) as error:  # no semaphores, no queues
        raise WorkersError(f"the worker processes cannot start: {error}") from None
    try:
        pool.submit(_ready).result()
    except OSError as error:
        end_pool(pool)
        raise WorkersError(f"the worker processes cannot start: {error}") from None
    except (BrokenExecutor, KeyboardInterrupt) as error:
        end_pool(pool)
        if isinstance(error, KeyboardInterrupt):
            raise
        raise WorkersError(
            "the worker processes cannot start; a script that runs a batch must call it below"
            ' `if __name__ == "__main__":`'
        ) from None
    return pool


def end_pool(pool: Executor) -> None:
    """End the processes at once, whatever they do."""
    processes = list((getattr(pool, "_processes", None) or {}).values())
    for process in processes:
        process.terminate()
    pool.shutdown(wait=True, cancel_futures=True)


def done_apart(work: Work, task: Task, jobs: Sequence[Job]) -> list[list[Row]]:
    """Return the rows of a chunk whose worker died, done in a process of its own. Where that dies
    too, the chunk is halved, so that only the job that kills it is marked `crashed`.
    """
    pool = new_pool(1)
    try:
        return pool.submit(work, task, jobs).result()
    except BrokenExecutor:
        pass
    finally:
        end_pool(pool)
    if len(jobs) == 1:
        return [[bad_row(task, jobs[0], "crashed", "the worker process of this file crashed")]]
    half = len(jobs) // 2
    return done_apart(work, task, jobs[:half]) + done_apart(work, task, jobs[half:])
