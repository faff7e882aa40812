"""The end of commands that are stopped: by Ctrl-C, by a closed pipe, by a system without room."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

resource = pytest.importorskip("resource", reason="this system sets no limits to a process")

C = "-c fanuc-0i-f"
SOON = 2.0  # seconds; on an idle machine it is a tenth of one
LONG = "--max-blocks 1000000000"

# Starts each command in a process of its own that has imported all, sends Ctrl-C to it and to those
# it started, and reports how it ended and how long that took.
PRESS = r"""
import json, os, signal, sys, time
from concurrent.futures import ThreadPoolExecutor
import cncsub.cli, cncsub.plot.figure, pyarrow.parquet
for name in cncsub.cli.COMMANDS.values():
    __import__("cncsub." + name[0].split(".")[0])

def begin(words, err):
    pid = os.fork()
    if pid == 0:
        os.setpgid(0, 0)
        out = os.open(os.devnull, os.O_WRONLY)
        for place, file in ((1, out), (2, os.open(err, os.O_WRONLY | os.O_CREAT))):
            os.dup2(file, place)
        sys.argv = ["cncsub", *words]
        try:
            cncsub.cli.main()
        except SystemExit as ended:
            with open(err + ".ended", "w") as file:
                file.write(str(time.monotonic()))
            sys.stdout.flush()
            os._exit(ended.code or 0)
        os._exit(99)
    return pid

def press(case):
    words, after, err = case
    pid = begins[err]
    time.sleep(after)
    done, status = os.waitpid(pid, os.WNOHANG)
    if done:
        return [None, 0.0, False]
    pressed = time.monotonic()
    os.killpg(pid, signal.SIGINT)
    while not done and time.monotonic() < pressed + 20:
        time.sleep(0.005)
        done, status = os.waitpid(pid, os.WNOHANG)
    if not done:
        os.killpg(pid, signal.SIGKILL)
    return [os.waitstatus_to_exitcode(status), time.monotonic() - pressed, had_ended(err, pressed)]

def had_ended(err, pressed):  # whether the command had its exit status when Ctrl-C reached it
    try:
        with open(err + ".ended") as file:
            return float(file.read()) < pressed + 0.01
    except FileNotFoundError:
        return False

cases, ended, begins = json.load(sys.stdin), [], {}
for first in range(0, len(cases), 4):
    part = cases[first:first + 4]
    for words, after, err in part:
        begins[err] = begin(words, err)
    with ThreadPoolExecutor(4) as crew:
        ended += crew.map(press, part)
print(json.dumps(ended))
"""


@pytest.fixture(scope="module")
def shop(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Programs that keep a command busy: while it reads, runs, looks at what ran, writes."""
    folder = tmp_path_factory.mktemp("shop")
    (folder / "endless.nc").write_text("O1\nN10 M98 P2 L99\nN20 GOTO10\nO2\n#100=#100+1\nM99\n")
    (folder / "moves.nc").write_text(
        "O1\nWHILE[#1LT400000]DO1\nG1 G90 X[#1] Y[SIN[#1]] F100\n#1=#1+1\nEND1\nM30\n"
    )
    block = "".join(f"N{n} G1 X{n}.5 Y{n % 7}.25 F100\n" for n in range(1, 9999))
    for name, feed in (("large.nc", "100"), ("other.nc", "101")):
        (folder / name).write_text("O1\n" + block.replace("F100", f"F{feed}") * 30 + "M30\n")
    (folder / "many").mkdir()
    for number in range(1, 301):
        calls = "".join(f"IF[#1EQ{n}]THEN#2={n}\nM98 P{n}\n" for n in range(1, 61))
        (folder / "many" / f"O{number}.nc").write_text(f"O{number}\n{calls}M99\n")
    return folder


BUSY = [
    f"run endless.nc {C} {LONG}",
    f"run endless.nc {C} {LONG} --format json",
    f"run endless.nc {C} {LONG} --format csv",
    f"run endless.nc {C} --format parquet -o moves.parquet",
    f"run endless.nc {C} --listing",
    f"run moves.nc {C} --listing --format json",
    f"run large.nc {C} --format json",
    f"run {C} --mdi M98P1 endless.nc {LONG}",
    f"tree endless.nc {C} {LONG}",
    f"tree large.nc {C} --static",
    f"list many {C}",
    f"check large.nc {C}",
    f"check many {C} --format sarif",
    f"check large.nc {C} --diff",
    "compare endless.nc -c fanuc-0i-f -c fanuc-30i",
    "compare large.nc -c fanuc-0i-f -c mitsubishi-m700 --translate",
    f"diff large.nc other.nc {C}",
    f"diff endless.nc large.nc {C} {LONG}",
    f"flatten moves.nc {C}",
    f"flatten large.nc {C} --to fanuc-30i",
    f"coverage endless.nc {C} {LONG} --fail-under 50",
    f"coverage large.nc {C} --html coverage.html",
    f"report moves.nc {C} -o report.html",
    f"report endless.nc {C} {LONG} -o report.html",
    f"plot moves.nc {C} -o plot.html",
    f"plot large.nc {C} -o plot.html --of calls",
    f"plot many {C} -o plot.html --of programs",
]


LOST = """
import os, signal, sys, time, weakref
from cncsub import interrupts
interrupts.answer_in_time()
def press(*_):
    os.kill(os.getpid(), signal.SIGINT)
class Freed:
    __del__ = press if sys.argv[1] == "finalizer" else lambda self: None
freed = Freed()
called = weakref.ref(freed, press if sys.argv[1] == "callback" else None)
del freed
time.sleep(20)
"""


@pytest.mark.parametrize("place", ["finalizer", "callback"])
def test_ctrl_c_whose_exception_gets_lost_ends_the_process_without_a_word(place: str) -> None:
    began = time.monotonic()
    ended = subprocess.run(
        [sys.executable, "-c", LOST, place],
        capture_output=True, text=True, timeout=30, check=False,
    )  # fmt: skip
    assert (ended.returncode, ended.stdout, ended.stderr) == (130, "", "")
    assert time.monotonic() - began < SOON + 2


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system forks no process")
def test_every_command_answers_ctrl_c_in_each_phase(shop: Path) -> None:
    cases = [
        (line.split(), after, str(shop / f"{number}-{after}.err"))
        for after in (0.05, 0.3, 0.9)
        for number, line in enumerate(BUSY)
    ]
    told = subprocess.run(
        [sys.executable, "-c", PRESS],
        input=json.dumps(cases), capture_output=True, text=True, cwd=shop, timeout=120, check=True,
    )  # fmt: skip
    ended = json.loads(told.stdout)
    met: set[str] = set()
    for (words, after, err), (status, took, had_ended) in zip(cases, ended, strict=True):
        line = " ".join(words)
        said = Path(err).read_text() if Path(err).exists() else ""
        assert "Traceback" not in said, (line, after, said)
        if status is None:  # it had already ended
            continue
        met.add(line)
        assert status == 130 or (had_ended and status in (0, 1, 4)), (
            line,
            after,
            status,
        )  # 4: a limit
        assert took < SOON, (line, after, took)
    assert met == {" ".join(line.split()) for line in BUSY}


def begun(*words: str, **options: Any) -> subprocess.Popen[bytes]:
    """Return a command that has begun to work."""
    code = "import os, cncsub.cli; os.write(2, b'go\\n'); cncsub.cli.main()"
    child = subprocess.Popen(
        [sys.executable, "-c", code, *words], stderr=subprocess.PIPE, start_new_session=True,
        **options,
    )  # fmt: skip
    assert child.stderr is not None
    assert child.stderr.readline() == b"go\n"
    return child


def ended(child: subprocess.Popen[bytes], by: int) -> tuple[int, float, str]:
    """End a command by a signal; return its status, after how long, and what it printed."""
    pressed = time.monotonic()
    os.killpg(child.pid, by)
    status = child.wait(30)
    took = time.monotonic() - pressed
    assert child.stderr is not None
    with child.stderr:
        return status, took, child.stderr.read().decode()


@pytest.mark.parametrize("more", [["--listing"], ["--format", "csv"]])
def test_ctrl_c_is_heard_where_nobody_empties_the_pipe(shop: Path, more: list[str]) -> None:
    child = begun("run", "moves.nc", *C.split(), *more, cwd=shop, stdout=subprocess.PIPE)
    time.sleep(1.0)  # the pipe is full
    status, took, said = ended(child, signal.SIGINT)
    assert child.stdout is not None
    child.stdout.close()
    assert status == 130
    assert took < SOON
    assert "Traceback" not in said


@pytest.mark.parametrize("by", [signal.SIGINT, signal.SIGTERM])
def test_a_batch_ends_with_its_workers(shop: Path, by: int) -> None:
    pytest.importorskip("pyarrow")
    (shop / "endless").mkdir(exist_ok=True)
    for number in range(4):
        (shop / "endless" / f"O{number + 1}.nc").write_text("N10 GOTO10\n")
    words = ("batch", "endless", *C.split(), "--max-blocks", "10000000000", "--max-seconds", "60")
    child = begun(*words, cwd=shop, stdout=subprocess.DEVNULL)
    time.sleep(0.8)  # some of its workers work, others are starting
    status, took, said = ended(child, by)
    assert status == (130 if by == signal.SIGINT else -by)
    assert took < SOON
    assert "Traceback" not in said
    for _ in range(200):
        try:
            os.killpg(child.pid, 0)
        except ProcessLookupError:
            return
        time.sleep(0.05)
    os.killpg(child.pid, signal.SIGKILL)
    pytest.fail("workers are left")


def test_a_command_ends_by_sigterm_as_any_process(shop: Path) -> None:
    child = begun("run", "endless.nc", *C.split(), *LONG.split(), cwd=shop)
    assert ended(child, signal.SIGTERM)[:1] == (-signal.SIGTERM,)


def test_a_command_that_is_to_ignore_ctrl_c_does(shop: Path) -> None:
    code = (
        "import os, signal, sys; signal.signal(signal.SIGINT, signal.SIG_IGN);"
        "import cncsub.cli; os.kill(os.getpid(), signal.SIGINT); cncsub.cli.main()"
    )
    words = ["run", "moves.nc", *C.split(), "--max-blocks", "10"]
    assert subprocess.run([sys.executable, "-c", code, *words], cwd=shop).returncode == 4


# ---- no room ----

FULL = Path("/dev/full")
WRITING = [
    f"run part.nc {C}", f"run part.nc {C} --format json", f"run part.nc {C} --format csv",
    f"run part.nc {C} --listing", f"tree part.nc {C}", f"tree part.nc {C} --static",
    f"list part.nc {C}", f"check part.nc {C}", f"check part.nc {C} --format sarif",
    f"check part.nc {C} --format junit", f"check part.nc {C} --format github",
    f"compare part.nc {C} -c fanuc-30i", f"diff part.nc other.nc {C}", f"flatten part.nc {C}",
    "controls", "controls fanuc-0i-f", "controls fanuc-0i-f --diff fanuc-30i", "explain PS0076",
]  # fmt: skip
OPTIONS = [
    *(f"coverage part.nc {C} --{form} @" for form in ("html", "lcov", "cobertura")),
    f"report part.nc {C} -o @",
    f"plot part.nc {C} -o @",
    f"run part.nc {C} --format parquet -o @",
]

# Runs commands one after the other in one process, which a limit or a full disk would fill.
EACH = r"""
import io, json, os, sys
import cncsub.cli
for words in json.load(sys.stdin):
    sys.argv = ["cncsub", *words]
    err, sys.stderr = sys.stderr, io.StringIO()
    place = os.dup(1)
    status, out = 0, sys.stdout
    sys.stdout = open(1, "w", closefd=False)
    try:
        cncsub.cli.app(prog_name="cncsub")
    except SystemExit as ended:
        status = ended.code or 0
    said, sys.stderr, sys.stdout = sys.stderr.getvalue(), err, out
    os.dup2(place, 1)
    os.close(place)
    err.write(json.dumps([status, said]) + "\n")
"""


def each_ended(folder: Path, lines: list[str], **options: Any) -> list[tuple[int, str]]:
    """Return how the commands end, and what they print."""
    done = subprocess.run(
        [sys.executable, "-c", EACH], input=json.dumps([line.split() for line in lines]),
        stderr=subprocess.PIPE, text=True, cwd=folder, timeout=120, **options,
    )  # fmt: skip
    told = done.stderr.splitlines()
    assert len(told) == len(lines), done.stderr
    return [tuple(json.loads(line)) for line in told]


@pytest.fixture
def part(tmp_path: Path) -> Path:
    """A program with a warning, which calls, and another version of it."""
    text = "O1\nM98 P2\nM98 P3\nM30\nO2\nG91 G1 X5. F100\nM99\nO3\nM99\n"
    text += "O4\nIF[#1EQ2]#3=4\nM99\n"
    (tmp_path / "part.nc").write_text(text)
    (tmp_path / "other.nc").write_text(text.replace("X5.", "X6."))
    return tmp_path


@pytest.mark.skipif(not FULL.exists(), reason="this system has no full device")
def test_a_full_disk_is_a_status_of_its_own_and_one_line(part: Path) -> None:
    with FULL.open("wb") as full:
        found = each_ended(part, WRITING, stdout=full)
    for line, (status, said) in zip(WRITING, found, strict=True):
        last = said.splitlines()[-1]
        assert (status, last) == (5, "cncsub: standard output: No space left on device"), line
    lines = [f"{line} -o @" for line in WRITING] + OPTIONS
    lines = [line.replace("@", str(FULL)) for line in lines]
    for line, (status, said) in zip(lines, each_ended(part, lines), strict=True):
        last = said.splitlines()[-1]
        assert (status, last) == (5, f"cncsub: {FULL}: No space left on device"), line


def test_a_file_that_may_not_grow_is_told_and_nothing_that_was_is_lost(part: Path) -> None:
    before = (part / "part.nc").read_bytes()
    lines = [line.replace("@", "out") for line in OPTIONS]
    lines += [f"run part.nc {C} --format json -o out", f"check part.nc {C} --fix"]
    lines += [f"batch part.nc {C} --out rows", f"compare part.nc {C} -c haas-ngc --translate -o to"]

    def small() -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (20, 20))

    for line, (status, said) in zip(lines, each_ended(part, lines, preexec_fn=small), strict=True):
        assert (status, said.splitlines()[-1][-14:]) == (5, "File too large"), (line, said)
    assert (part / "part.nc").read_bytes() == before
    assert not list(part.glob(".*"))
    assert each_ended(part, [f"check part.nc {C} --fix"])[0][1].startswith("mended: part.nc")
    assert b"THEN #3=4" in (part / "part.nc").read_bytes()


def test_a_limit_of_open_files_leaves_no_program_out(part: Path) -> None:
    code = (
        "import resource, sys, cncsub.cli.commands, cncsub.cli.run, cncsub.reports.hints, cncsub.cli.batch;"
        "import cncsub.archive.many;"
        "resource.setrlimit(resource.RLIMIT_NOFILE, (3, 3)); cncsub.cli.main()"
    )
    for words in (["run", "."], ["run", "part.nc"], ["batch", "part.nc"]):
        done = subprocess.run(
            [sys.executable, "-c", code, *words, *C.split()],
            cwd=part, capture_output=True, text=True,
        )  # fmt: skip
        assert done.returncode == 5, (words, done.stderr)
        assert done.stderr.endswith("Too many open files\n")
        assert done.stderr.startswith("cncsub: ")


@pytest.mark.parametrize("closed", ["1", "2", "0"])
def test_a_stream_that_is_closed_makes_no_traceback(part: Path, closed: str) -> None:
    command = f"'{sys.executable}' -m cncsub run part.nc {C} -o out.txt {closed}>&-"
    done = subprocess.run(command, shell=True, cwd=part, capture_output=True, text=True)
    assert (done.returncode, done.stdout + done.stderr) == (0, "")
    assert "the program ended" in (part / "out.txt").read_text()
