"""Whole archives: a row for each file, whatever the file does, and on any executor."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
import warnings
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import active_children, get_context
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.archive.work import RUN_COLUMNS, Job, Row, Task, do_chunk, done_apart
from cncsub.cli import app

CONTROL = "fanuc-0i-f"


def good(number: int) -> str:
    return f"O{number}\nN10 G91 G1 X10. F100.\nN20 M30\n"


def write(folder: Path, name: str, text: str | bytes) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / name
    file.write_bytes(text if isinstance(text, bytes) else text.encode())
    return file


@pytest.fixture
def here() -> Any:
    """An executor of threads, for tests that need no processes."""
    with ThreadPoolExecutor(2) as executor:
        yield executor


def archive(folder: Path, count: int) -> Path:
    for i in range(1, count + 1):
        write(folder / f"{(i - 1) // 100:02}", f"O{i}.nc", good(i))
    return folder


def rows(table: Any) -> dict[str, dict[str, Any]]:
    return {Path(row["path"]).name: row for row in table.to_pylist()}


def test_two_thousand_files_are_two_thousand_rows_in_their_order(tmp_path: Path) -> None:
    archive(tmp_path, 2000)
    table = cncsub.run_many(tmp_path, CONTROL, jobs=2)
    assert [Path(p).name for p in table["path"].to_pylist()] == [f"O{i}.nc" for i in range(1, 2001)]
    assert set(table["status"].to_pylist()) == {"ran"}
    assert table["blocks"].to_pylist() == [2] * 2000
    assert table["length"].to_pylist() == [10.0] * 2000


def test_what_a_file_does_is_its_status(tmp_path: Path, here: Executor) -> None:
    write(tmp_path, "alarm.nc", "O1\nN10 M98 P9\n")
    write(tmp_path, "bytes.nc", b"O2\n(\xff\xfe\x81 \x93)\nN10 M30\n")
    write(tmp_path, "endless.nc", "O3\nN10 GOTO 10\n")
    write(tmp_path, "again.nc", "O4\nN10 G4 X1.\nN20 M99\n")
    write(tmp_path, "image", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR")
    write(tmp_path, "note.pdf", b"%PDF")
    (tmp_path / "broken.nc").symlink_to(tmp_path / "nowhere")
    (tmp_path / "folder.nc").mkdir()
    table = cncsub.run_many(
        [tmp_path, tmp_path / "missing.nc"], CONTROL, executor=here, max_blocks=1000
    )
    found = rows(table)
    assert {name: row["status"] for name, row in found.items()} == {
        "alarm.nc": "alarm",
        "bytes.nc": "ran",
        "endless.nc": "limit",
        "again.nc": "cycles",
        "image": "unreadable",
        "broken.nc": "unreadable",
        "missing.nc": "unreadable",
    }
    alarm = found["alarm.nc"]
    assert (alarm["cause"], alarm["program"], alarm["n"]) == ("program-not-found", "O1", 10)
    assert found["endless.nc"]["n"] == 10
    assert found["broken.nc"]["error"] == "a broken link"
    assert table.schema.metadata[b"cncsub.skipped"] == b'{".pdf files are not programs": 1}'


def test_a_link_out_of_the_folder_is_never_read(tmp_path: Path, here: Executor) -> None:
    outside = write(tmp_path / "outside", "O1.nc", good(1))
    write(tmp_path / "in", "O2.nc", good(2))
    (tmp_path / "in" / "O1.nc").symlink_to(outside)
    table = cncsub.run_many(tmp_path / "in", CONTROL, executor=here)
    assert list(rows(table)) == ["O2.nc"]
    assert b"outside the folder" in table.schema.metadata[b"cncsub.skipped"]


def test_names_in_two_folders_are_two_rows_and_a_file_given_twice_is_one(
    tmp_path: Path, here: Executor
) -> None:
    first = write(tmp_path / "a", "O1.nc", good(1))
    second = write(tmp_path / "b", "O1.nc", good(1))
    table = cncsub.run_many([tmp_path, first], CONTROL, executor=here)
    assert table["path"].to_pylist() == [str(first), str(second)]


def test_each_says_what_one_run_loads(tmp_path: Path, here: Executor) -> None:
    write(tmp_path / "job", "O1.nc", "O1\nN10 M98 P2\nN20 M30\n")
    write(tmp_path / "job", "O2.nc", "O2\nN30 M99\n")

    def statuses(each: str) -> list[str]:
        table = cncsub.run_many(tmp_path, CONTROL, executor=here, each=each)
        return list(table["status"].to_pylist())

    assert statuses("file") == ["alarm", "cycles"]
    assert statuses("beside") == ["ran", "cycles"]
    assert statuses("folder") == ["ran"]


def test_a_bad_file_of_a_folder_is_told_in_its_row(tmp_path: Path, here: Executor) -> None:
    write(tmp_path, "O1.nc", "O1\nN10 M30\n")
    write(tmp_path, "O2.nc", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR")
    (ran,) = cncsub.run_many(tmp_path, CONTROL, executor=here, each="folder").to_pylist()
    assert (ran["status"], ran["error"]) == ("ran", f"{tmp_path / 'O2.nc'}: not a text")
    (bad,) = cncsub.check_many(tmp_path, CONTROL, executor=here, each="folder").to_pylist()
    assert (bad["status"], bad["error"]) == ("unreadable", f"{tmp_path / 'O2.nc'}: not a text")


def test_wrong_options_are_told_before_anything_is_run(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="max_blocks must be at least 0"):
        cncsub.run_many(tmp_path, CONTROL, max_blocks=-1)
    with pytest.raises(TypeError, match="no option 'trace'"):
        cncsub.run_many(tmp_path, CONTROL, trace="none")
    with pytest.raises(ValueError, match="each must be one of file, beside, folder"):
        cncsub.run_many(tmp_path, CONTROL, each="all")
    with pytest.raises(ValueError, match="at least 1"):
        cncsub.run_many(tmp_path, CONTROL, jobs=0)


# ---- a folder of Parquet files ----


class Ending(Executor):
    """Does so many chunks at once, in this thread, and is then interrupted."""

    _max_workers = 1

    def __init__(self, chunks: int = 10**9) -> None:
        self.left = chunks
        self.jobs: list[Job] = []

    def submit(self, work: Callable[..., Any], /, *arguments: Any, **named: Any) -> Future[Any]:
        if not self.left:
            raise KeyboardInterrupt
        self.left -= 1
        self.jobs += arguments[1]
        future: Future[Any] = Future()
        future.set_result(work(*arguments, **named))
        return future


def test_a_batch_that_was_interrupted_goes_on_where_it_was(tmp_path: Path) -> None:
    archive(tmp_path / "in", 200)
    out = tmp_path / "out"
    with pytest.raises(KeyboardInterrupt):
        cncsub.run_many(tmp_path / "in", CONTROL, executor=Ending(6), out=out)
    written = len(list(out.glob("part-*.parquet")))
    assert 4 <= written <= 6
    rest = Ending()
    data = cncsub.run_many(tmp_path / "in", CONTROL, executor=rest, out=out)
    assert 0 < len(rest.jobs) < 200
    paths = data.to_table()["path"].to_pylist()
    assert len(paths) == len(set(paths)) == 200


def test_only_new_and_changed_files_are_run_again(tmp_path: Path) -> None:
    archive(tmp_path / "in", 30)
    out = tmp_path / "out"
    cncsub.run_many(tmp_path / "in", CONTROL, executor=Ending(), out=out)
    write(tmp_path / "in" / "00", "O7.nc", "O7\nN10 M98 P9\n")
    write(tmp_path / "in" / "00", "O31.nc", good(31))
    again = Ending()
    data = cncsub.run_many(tmp_path / "in", CONTROL, executor=again, out=out)
    assert [Path(job.path).name for job in again.jobs] == ["O7.nc", "O31.nc"]
    table = data.to_table()
    assert table.num_rows == 31
    assert rows(table)["O7.nc"]["status"] == "alarm"
    nothing = Ending()
    assert cncsub.run_many(tmp_path / "in", CONTROL, executor=nothing, out=out).count_rows() == 31
    assert nothing.jobs == []


def test_a_folder_of_another_batch_is_refused(tmp_path: Path) -> None:
    out = tmp_path / "out"
    assert cncsub.run_many([], CONTROL, executor=Ending(), out=out).count_rows() == 0
    with pytest.raises(ValueError, match="another control"):
        cncsub.run_many([], "gsk-988ta", executor=Ending(), out=out)
    with pytest.raises(ValueError, match="another options"):
        cncsub.run_many([], CONTROL, executor=Ending(), out=out, max_blocks=5)
    write(tmp_path / "full", "x.txt", "x")
    with pytest.raises(ValueError, match="is not the folder of a batch"):
        cncsub.run_many([], CONTROL, executor=Ending(), out=tmp_path / "full")


# ---- workers that die ----


def deadly(task: Task, jobs: Sequence[Job]) -> list[list[Row]]:
    """Kill the process that opens one certain file."""
    if any(job.names == ("O5.nc",) for job in jobs):
        os.kill(os.getpid(), signal.SIGKILL)
    return do_chunk(task, jobs)


def test_only_the_file_that_kills_its_worker_is_crashed(tmp_path: Path) -> None:
    jobs = [
        Job(str(write(tmp_path, f"O{i}.nc", good(i))), f"{tmp_path}/", (f"O{i}.nc",))
        for i in range(4, 8)
    ]
    task = Task("run", cncsub.controls[CONTROL], "file", None, None, {}, CONTROL)
    found = [row for (row,) in done_apart(deadly, task, jobs)]
    status = list(RUN_COLUMNS).index("status")
    assert [row[status] for row in found] == ["ran", "crashed", "ran", "ran"]


class Killing(Executor):
    """Two processes, one of which is killed when the third chunk is handed over.

    Both exist before that: Python 3.11 waits for ever for one that begins just then.
    """

    def __init__(self) -> None:
        self.pool = ProcessPoolExecutor(2, mp_context=get_context("spawn"))
        other = self.pool.submit(time.sleep, 0.2)
        self.victim = self.pool.submit(os.getpid).result()
        other.result()
        self.chunks = 0

    def submit(self, work: Callable[..., Any], /, *arguments: Any, **named: Any) -> Future[Any]:
        self.chunks += 1
        if self.chunks == 3:
            os.kill(self.victim, signal.SIGKILL)
        return self.pool.submit(work, *arguments, **named)


@pytest.mark.filterwarnings("ignore:a part of the work is repeated:RuntimeWarning")
def test_a_process_killed_on_the_way_costs_no_row(tmp_path: Path) -> None:
    archive(tmp_path, 600)
    killing = Killing()
    table = cncsub.run_many([tmp_path], CONTROL, executor=killing)
    killing.pool.shutdown()
    assert killing.chunks >= 3
    assert table["status"].to_pylist() == ["ran"] * 600


class Lost(Ending):
    """A cluster whose workers end with the third chunk."""

    def submit(self, work: Callable[..., Any], /, *arguments: Any, **named: Any) -> Future[Any]:
        self.left -= 1
        future: Future[Any] = Future()
        if self.left == 0:
            future.set_exception(OSError("the worker is gone"))
        else:
            future.set_result(work(*arguments, **named))
        return future


def test_a_chunk_that_is_lost_is_done_here_and_told(tmp_path: Path) -> None:
    archive(tmp_path, 40)
    with pytest.warns(RuntimeWarning, match="repeated .* OSError: the worker is gone"):
        table = cncsub.run_many(tmp_path, CONTROL, executor=Lost(3))
    assert [Path(p).name for p in table["path"].to_pylist()] == [f"O{i}.nc" for i in range(1, 41)]
    assert set(table["status"].to_pylist()) == {"ran"}


@pytest.mark.filterwarnings("ignore:a part of the work is repeated:RuntimeWarning")
def test_a_process_of_our_own_that_is_killed_is_replaced(tmp_path: Path) -> None:
    archive(tmp_path, 800)

    def paths() -> Iterator[Path]:
        for i, folder in enumerate(sorted(tmp_path.iterdir())):
            if i == 5:
                for process in active_children():
                    process.kill()
                    process.join()
            yield folder

    table = cncsub.run_many(paths(), CONTROL, jobs=2)
    assert table["status"].to_pylist() == ["ran"] * 800


STARTS = """
import sys
from cncsub.archive.work import new_pool

if __name__ == "__main__":
    pool = new_pool(2)
    [pool.submit(pow, 2, n).result() for n in range(8)]
    print(*pool._processes, flush=True)
    sys.stdin.read()
"""


LAUNCHER = "import sys\nfrom cncsub.cli import main\nsys.exit(main())\n"


@pytest.mark.parametrize("more", [["-j", "2"], ["--check", "-j", "2"]])
def test_a_launcher_need_not_ask_whether_it_is_the_main_module(
    tmp_path: Path, more: list[str]
) -> None:
    launcher = write(tmp_path, "launcher.py", LAUNCHER)
    write(tmp_path / "programs", "O1.nc", "O1\nG0 X1.\nM30\n")
    words = [sys.executable, launcher, "batch", str(tmp_path / "programs"), "-c", CONTROL, *more]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such limit")
def test_workers_that_cannot_start_are_told_in_one_line(tmp_path: Path) -> None:
    write(tmp_path, "O1.nc", "O1\nG0 X1.\nM30\n")
    code = (
        "import resource, sys; from cncsub.cli import main;"
        " resource.setrlimit(resource.RLIMIT_NOFILE, (9, 9)); main()"
    )
    words = [sys.executable, "-c", code, "batch", str(tmp_path), "-c", CONTROL, "-j", "2"]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    assert done.returncode == 5
    assert done.stderr.startswith("cncsub: the worker processes cannot start")
    assert done.stderr.count("\n") == 1


def test_the_workers_of_a_process_that_is_killed_end_with_it(tmp_path: Path) -> None:
    script = write(tmp_path, "starts.py", STARTS)
    ends = subprocess.PIPE
    with subprocess.Popen([sys.executable, script], stdin=ends, stdout=ends, text=True) as starting:
        assert starting.stdout is not None
        workers = [int(pid) for pid in starting.stdout.readline().split()]
        starting.kill()
    assert workers
    until = time.monotonic() + 20
    while any(is_running(pid) for pid in workers) and time.monotonic() < until:
        time.sleep(0.05)
    assert [pid for pid in workers if is_running(pid)] == []


def is_running(pid: int) -> bool:
    """Return whether a process is there and is still open here."""
    try:
        state = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
    except OSError:
        return False
    return state != "Z"


def test_an_executor_that_is_broken_is_replaced(tmp_path: Path) -> None:
    archive(tmp_path, 20)
    pool = ProcessPoolExecutor(1, mp_context=get_context("spawn"))
    with pytest.raises(Exception, match="terminated abruptly"):
        pool.submit(os._exit, 1).result()
    table = cncsub.run_many(tmp_path, CONTROL, executor=pool, jobs=1)
    pool.shutdown()
    assert table["status"].to_pylist() == ["ran"] * 20


def test_a_dask_cluster_is_an_executor_and_a_worker_may_die(tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed")
    dask = pytest.importorskip("dask")
    archive(tmp_path / "in", 1500)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of Dask: about ports, sockets and loops
        options = {"n_workers": 2, "threads_per_worker": 1, "processes": True}
        with (
            dask.config.set({"distributed.comm.timeouts.connect": "5s"}),  # to a dead worker
            distributed.LocalCluster(dashboard_address=None, **options) as cluster,
            distributed.Client(cluster) as client,
        ):
            victim = next(iter(client.run(os.getpid).values()))
            done = False

            def kill() -> None:
                # Wait for the first rows.
                while not done and not list((tmp_path / "out").glob("part-*")):
                    time.sleep(0.01)
                os.kill(victim, signal.SIGKILL)

            killer = threading.Thread(target=kill)
            killer.start()
            data = cncsub.run_many(
                tmp_path / "in", CONTROL, executor=client.get_executor(), out=tmp_path / "out"
            )
            done = True
            killer.join()
            table = data.to_table()
    assert table["status"].to_pylist() == ["ran"] * 1500
    assert len(set(table["path"].to_pylist())) == 1500


# ---- checking ----


def test_each_finding_is_a_row(tmp_path: Path, here: Executor) -> None:
    write(tmp_path, "O1.nc", "O1\nN10 M98 P9\nN20 G0 X1.5 Y2\nN30 M30\n")
    write(tmp_path, "O2.nc", good(2))
    (tmp_path / "O3.nc").symlink_to(tmp_path / "nowhere")
    missing, point, bad = cncsub.check_many(tmp_path, CONTROL, executor=here).to_pylist()
    assert (missing["status"], missing["rule"], missing["n"]) == ("finding", "CS201", 10)
    assert (missing["alarm"], missing["severity"], missing["word"]) == ("PS0076", "error", "P9")
    assert (point["rule"], point["alarm"], point["column"]) == ("CS701", None, 13)
    assert (bad["status"], bad["error"]) == ("unreadable", "a broken link")
    errors = cncsub.check_many(tmp_path, CONTROL, executor=here, rules=["CS2"]).to_pylist()
    assert [row["rule"] for row in errors] == ["CS201", None]
    with pytest.raises(KeyError, match="CS999"):
        cncsub.check_many(tmp_path, CONTROL, executor=here, rules=["CS999"])


# ---- the command ----


def test_the_command_tells_what_did_not_run(tmp_path: Path) -> None:
    write(tmp_path, "O1.nc", good(1))
    fine = CliRunner().invoke(app, ["batch", str(tmp_path), "-c", CONTROL, "--jobs", "1"])
    assert (fine.exit_code, fine.stdout) == (0, "       1 ran\n")
    bad = write(tmp_path, "O2.nc", "O2\nN10 M98 P9\n")
    told = CliRunner().invoke(
        app, ["batch", str(tmp_path), "-c", CONTROL, "--out", str(tmp_path / "out")]
    )
    assert told.exit_code == 1
    assert f"{bad}:2: alarm" in told.stdout
    lines = CliRunner().invoke(app, ["batch", str(bad), "-c", CONTROL, "--format", "json"])
    assert '"cause": "program-not-found"' in lines.stdout
    wrong = CliRunner().invoke(app, ["batch", str(bad), "-c", "fanuc"])
    assert wrong.exit_code == 2


def test_the_command_takes_from_the_project_what_no_command_needs_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    project = 'control = "fanuc-0i-f"\nfolders = ["job"]\n[parameters]\n"6050" = 100\n'
    write(tmp_path, "cncsub.toml", project)
    write(tmp_path / "job", "O1.nc", "O1\nN10 G100\nN20 M30\nO9010\nN30 M99\n")
    monkeypatch.chdir(tmp_path)
    done = CliRunner().invoke(app, ["batch", "--jobs", "1"])
    assert (done.exit_code, done.stdout) == (0, "       1 ran\n")
    (tmp_path / "cncsub.toml").unlink()
    done = CliRunner().invoke(app, ["batch", "-c", CONTROL])
    assert (done.exit_code, "Give files or folders" in done.stderr) == (2, True)


def test_the_command_checks_each_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    bad = write(tmp_path / "job", "O1.nc", "O1\nN10 M98 P9\nN20 G7.1 C1.\nN30 M30\n")
    told = CliRunner().invoke(app, ["batch", "job", "-c", CONTROL, "--check", "--jobs", "1"])
    assert told.exit_code == 1
    assert "O1.nc:2: error CS201 program-missing: O9 is not in the memory" in told.stdout
    write(tmp_path, "cncsub.toml", '[check]\nignore = ["CS2"]\n')
    told = CliRunner().invoke(app, ["batch", "job", "-c", CONTROL, "--check", "--jobs", "1"])
    assert (told.exit_code, told.stdout) == (0, "       1 note\n")
    write(tmp_path, "cncsub.toml", '[check.severity]\nCS105 = "error"\n')
    told = CliRunner().invoke(app, ["batch", "job", "-c", CONTROL, "--check", "--jobs", "1"])
    assert (told.exit_code, "error CS105" in told.stdout) == (1, True)
    bad.write_text(good(1))
    told = CliRunner().invoke(app, ["batch", "job", "-c", CONTROL, "--check", "--jobs", "1"])
    assert (told.exit_code, told.stdout) == (0, "nothing found\n")
