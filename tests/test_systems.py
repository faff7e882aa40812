"""Code for one operating system stands in one place of each language, and the package reads and
writes alike on all systems.
"""

from __future__ import annotations

import ast
import io
import os
import re
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

import cncsub
from cncsub import cli, system

ROOT = Path(__file__).parent.parent
PACKAGE = ROOT / "python" / "cncsub"
NATIVE = [
    file
    for folder in ("cpp/cncsub", "cpp/controls", "cpp/selftest", "python/bindings")
    for file in sorted((ROOT / folder).rglob("*"))
    if file.suffix in {".cpp", ".hpp"}
]
PYTHON = sorted((ROOT / "python").rglob("*.py"))
ELSEWHERE = [file for file in PYTHON if file != PACKAGE / "system.py"]

# Names of Python's library that some systems lack, or that mean something else there.
NOT_EVERYWHERE = {
    "os": """O_\\w+ fork\\w* kill\\w* get[peu]*[gu]id\\w* set\\w*[gu]id\\w* uname nice mkfifo mknod chown
        lchown chroot fchmod fchown pread pwrite sched_\\w+ posix_\\w+ statvfs getloadavg wait\\w* WIF\\w+
        X_OK ttyname openpty set_blocking pipe2 dup2 devnull spawn\\w+ access name
        EX_\\w+ ctermid sendfile splice memfd_create copy_file_range confstr sysconf tc\\w+ sync
        register_at_fork setsid setpriority getpriority getlogin initgroups lchmod chmod umask
        rename link symlink readlink""",
    "sys": "platform getwindowsversion winver",
    "stat": "S_IS(FIFO|SOCK|CHR|BLK) FILE_ATTRIBUTE_\\w+ IO_REPARSE_\\w+",
    "signal": "(?!SIGINT$|SIGTERM$)SIG\\w+ pthread_\\w+ alarm pause setitimer sigwait",
    "platform": ".*",
    "time": "tzset clock_gettime\\w* CLOCK_\\w+ pthread_\\w+",
    "socket": "AF_\\w+ SO_\\w+ send_fds recv_fds",
    "asyncio": "start_unix_server open_unix_connection \\w*ChildWatcher",
    "shutil": "chown",
}
# Methods of paths that exist everywhere but fail, or mean something else, on some systems.
OF_PATHS = {"owner", "hardlink_to", "symlink_to", "lchmod", "chmod", "readlink", "rename"}
MODULES = {
    *("fcntl", "grp", "pwd", "termios", "tty", "pty", "resource", "syslog", "curses", "readline"),
    *("msvcrt", "winreg", "winsound", "_winapi", "nt", "posix", "select", "mmap", "platform"),
}

# Headers of one system, and what compilers spell each in its own way.
HEADERS = {
    *("fcntl.h", "unistd.h", "io.h", "windows.h", "malloc.h", "dirent.h", "pthread.h", "signal.h"),
    *("dlfcn.h", "sched.h", "immintrin.h", "x86intrin.h", "intrin.h", "arm_neon.h", "strings.h"),
}
COMPILERS = re.compile(
    r"__builtin_|__attribute__|__declspec|\[\[(gnu|clang|msvc)::|__int128|__uint128|(?<!py::)\bssize_t\b"
    r"|\boff_t\b|_MSC_VER|__GNUC__|__clang__|_WIN32|__APPLE__|__linux__|&&\w+\s*[,}]\s*//|goto \*"
    r"|\bstrto[dlu]|\bsetlocale|#pragma (?!once)|\b(mmap|madvise|aligned_alloc|posix_\w+)\("
    r"|std::from_chars\([^;]*chars_format"
)


def test_system_headers_stand_in_one_folder_of_the_engine() -> None:
    wrong = [
        f"{file.relative_to(ROOT)}: {name}"
        for file in NATIVE
        if file.parent.name != "system"
        for name in re.findall(r"^#\s*include <([^>]+)>", file.read_text("utf-8"), re.MULTILINE)
        if name in HEADERS or name.startswith(("sys/", "linux/", "mach/"))
    ]
    assert not wrong


def test_what_is_of_one_compiler_stands_in_the_same_folder() -> None:
    wrong = [
        f"{file.relative_to(ROOT)}:{number}: {found[0]}"
        for file in NATIVE
        if file.parent.name != "system"
        for number, line in enumerate(file.read_text("utf-8").splitlines(), 1)
        if (found := COMPILERS.search(line)) and not line.lstrip().startswith("//")
    ]
    assert not wrong


def test_doubles_are_read_and_written_by_one_file() -> None:
    """Some libraries that compile the rest lack `from_chars` and `to_chars` of doubles."""
    wrong = []
    for file in NATIVE:
        if file.stem == "decimal":
            continue
        text = file.read_text("utf-8")
        for call in re.finditer(r"std::(from|to)_chars\((?:[^()]|\([^()]*\))*\)", text):
            variable = call[0].rstrip(")").rsplit(",", 1)[-1].strip()
            declared = text[: call.start()].rfind(f"double {variable}")
            if call[1] == "to" or declared > text.rfind("\n}", 0, call.start()):
                wrong.append(f"{file.relative_to(ROOT)}: {call[0]}")
    assert not wrong


def _names(tree: ast.AST) -> list[tuple[int, str, str]]:
    """Return the names that a file takes of modules: line, module, name."""
    found = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            found.append((node.lineno, node.value.id, node.attr))
        if isinstance(node, ast.Import):
            found += [(node.lineno, alias.name, "") for alias in node.names]
        if isinstance(node, ast.ImportFrom):
            found += [(node.lineno, node.module or "", alias.name) for alias in node.names]
    return found


def _not_everywhere(file: str) -> list[str]:
    """Return the names in a file that some systems lack, each with its line."""
    tree = ast.parse(file)
    wrong = []
    for line, module, name in _names(tree):
        known = NOT_EVERYWHERE.get(module, "").split()
        if module.split(".")[0] in MODULES or (
            name and any(re.fullmatch(each, name) for each in known)
        ):
            wrong.append(f"{line}: {module}.{name}".rstrip("."))
    for node in ast.walk(tree):
        called = node.func if isinstance(node, ast.Call) else None
        if isinstance(called, ast.Attribute) and called.attr in OF_PATHS:
            wrong.append(f"{called.lineno}: .{called.attr}()")
        text = getattr(node, "value", None) if isinstance(node, ast.Constant) else None
        if isinstance(text, str) and re.match(r"/(dev|tmp|etc|proc|usr|var)/|fork(server)?$", text):
            wrong.append(f"{node.lineno}: {text}")
    return wrong


def test_only_one_python_file_names_what_is_not_everywhere() -> None:
    assert len(ELSEWHERE) > 80
    assert not [
        f"{file.relative_to(ROOT)}:{found}"
        for file in ELSEWHERE
        for found in _not_everywhere(file.read_text("utf-8"))
    ]


@pytest.mark.parametrize(
    "text",
    [
        "import fcntl",
        "from resource import getrusage",
        "import select as s",
        "import curses.ascii",
        "os.open(p, os.O_NONBLOCK)",
        "from os import O_CLOEXEC",
        "os.geteuid()",
        "os.killpg(1, 9)",
        "os.register_at_fork()",
        "signal.SIGALRM",
        "signal.setitimer(0, 1)",
        "sys.platform",
        "time.tzset()",
        "path.chmod(0o700)",
        "here.symlink_to(there)",
        "here.rename(there)",
        "open('/dev/null')",
        "multiprocessing.get_context('fork')",
    ],
)
def test_a_name_that_is_not_everywhere_is_noticed(text: str) -> None:
    assert _not_everywhere(text)


@pytest.mark.parametrize(
    "text", ["os.replace(a, b)", "signal.SIGINT", "path.open('rb')", "re.group()"]
)
def test_a_name_that_is_everywhere_is_not(text: str) -> None:
    assert not _not_everywhere(text)


def test_every_text_file_is_opened_in_an_encoding_that_is_named() -> None:
    """A file without a named encoding would be opened in that of the country on Windows."""
    wrong = []
    for file in PYTHON:
        for node in ast.walk(ast.parse(file.read_text("utf-8"))):
            if not isinstance(node, ast.Call):
                continue
            name = getattr(node.func, "attr", getattr(node.func, "id", ""))
            if name not in ("open", "read_text", "write_text") or getattr(
                getattr(node.func, "value", None), "id", ""
            ) in ("os", "options"):
                continue
            if name == "write_text" and isinstance(node.func, ast.Name):
                continue  # our own function, of the command line
            said = [ast.unparse(a) for a in [*node.args, *(k.value for k in node.keywords)]]
            named = {keyword.arg for keyword in node.keywords} & {"encoding"}
            binary = any("b" in text for text in said[-1:] if text.strip("'\"") in ("rb", "wb"))
            mode = any(text == "mode" for text in said)  # binary, as the line above it asks
            if not named and not binary and not mode and "'utf-8'" not in said:
                wrong.append(f"{file.relative_to(ROOT)}:{node.lineno}: {ast.unparse(node)}")
    assert not wrong


# ---- on another system ----


def entry(name: str = "O1.nc", *, link: bool = False, **marks: int) -> Any:
    return SimpleNamespace(
        name=name, is_symlink=lambda: link, stat=lambda **_: SimpleNamespace(**marks)
    )


def test_a_junction_leads_elsewhere_as_a_link_does(monkeypatch: pytest.MonkeyPatch) -> None:
    assert system.leads_elsewhere(entry(link=True))
    assert not system.leads_elsewhere(entry(st_reparse_tag=0xA0000003))
    monkeypatch.setattr(system, "WINDOWS", True)
    monkeypatch.setattr(system.stat, "IO_REPARSE_TAG_MOUNT_POINT", 0xA0000003, raising=False)
    assert system.leads_elsewhere(entry(st_reparse_tag=0xA0000003))
    assert not system.leads_elsewhere(entry(st_reparse_tag=0))
    assert not system.leads_elsewhere(entry(st_reparse_tag=0x9000001A))  # a file of OneDrive


def test_windows_marks_hidden_files_beside_their_names(monkeypatch: pytest.MonkeyPatch) -> None:
    assert system.is_hidden(entry(".O1.nc"))
    assert not system.is_hidden(entry("O1.nc", st_file_attributes=2))
    monkeypatch.setattr(system, "WINDOWS", True)
    assert system.is_hidden(entry("O1.nc", st_file_attributes=2 | 32))
    assert not system.is_hidden(entry("O1.nc", st_file_attributes=32))


def test_a_reader_that_left_is_known_by_what_its_system_says(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    assert system.nobody_reads(BrokenPipeError())
    assert not system.nobody_reads(OSError(22, "Invalid argument"))
    assert not system.nobody_reads(ValueError())
    monkeypatch.setattr(system, "WINDOWS", True)
    assert system.nobody_reads(OSError(22, "Invalid argument"))
    assert not system.nobody_reads(OSError(22, "Invalid argument", "a?.nc"))  # no file name
    assert not system.nobody_reads(OSError(13, "Permission denied"))


def test_the_cores_are_counted_where_nothing_tells_which_may_be_used(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.delattr(os, "sched_getaffinity", raising=False)
    assert system.cores() == (os.cpu_count() or 1)


def test_windows_knows_a_file_by_small_letters_and_capitals(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    assert system.same_names(["O1.NC", "o1.nc"]) == ["O1.NC", "o1.nc"]
    monkeypatch.setattr(system, "WINDOWS", True)
    monkeypatch.setattr(os.path, "normcase", str.lower)
    assert system.same_names(["O1.NC", "o1.nc"]) == ["o1.nc", "o1.nc"]


CHINESE = "O1 (粗车)\nN10 M98 P2\nN20 M30\n"


class Window(io.TextIOWrapper):
    """A stream with the encoding of a country."""

    def __init__(self, encoding: str) -> None:
        super().__init__(io.BytesIO(), encoding=encoding, newline="\n")

    def text(self) -> str:
        self.flush()
        return self.buffer.getvalue().decode(self.encoding)  # type: ignore[attr-defined]


@pytest.mark.parametrize("encoding", ["cp1252", "cp437", "ascii", "utf-8"])
def test_a_window_of_another_country_shows_what_it_can(
    tmp_path: Path, encoding: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "O1.nc").write_text(CHINESE, encoding="utf-8")
    window = Window(encoding)
    monkeypatch.setattr(sys, "stdout", window)
    monkeypatch.setattr(sys, "argv", ["cncsub", "list", str(tmp_path), "-c", "gsk-988ta"])
    with pytest.raises(SystemExit) as status:
        cli.main()
    assert status.value.code == 0
    shown = "粗车" if encoding == "utf-8" else r"\u7c97\u8f66"
    assert shown in window.text()


@pytest.mark.parametrize("encoding", ["cp1252", "utf-8"])
def test_json_is_json_in_every_window(
    tmp_path: Path, encoding: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    import json

    (tmp_path / "O1.nc").write_text(CHINESE, encoding="utf-8")
    window = Window(encoding)
    monkeypatch.setattr(sys, "stdout", window)
    asked = ["cncsub", "list", str(tmp_path), "-c", "gsk-988ta", "--format", "json"]
    monkeypatch.setattr(sys, "argv", asked)
    with pytest.raises(SystemExit):
        cli.main()
    assert "粗车" in str(json.loads(window.text()))


def test_line_ends_of_windows_and_of_old_tapes_are_line_ends() -> None:
    text = "O1\nN10 #1=1\nN20 M98 P2\nN30 M30\nO2\nN40 #100=#1\nN50 M99\n"
    steps = [
        cncsub.loads(text.replace("\n", end).encode(), control="fanuc-0i-f").run().steps.n.tolist()
        for end in ("\n", "\r\n", "\r\r\n", "\n\r")
    ]
    assert steps[0][-1] == 30
    assert steps == [steps[0]] * 4


def test_written_files_have_the_same_line_ends_on_every_system(tmp_path: Path) -> None:
    from cncsub.writing import opened

    with opened(tmp_path / "out.txt", "w") as file:
        file.write("a\nb\r\n")
    assert (tmp_path / "out.txt").read_bytes() == b"a\nb\r\n"


def test_a_pipe_is_refused_and_nobody_waits_for_it(tmp_path: Path) -> None:
    if not hasattr(os, "mkfifo"):
        pytest.skip("there are no pipes with names here")
    os.mkfifo(tmp_path / "O1.nc")
    with pytest.raises(ValueError, match="not a regular file"):
        cncsub.load(tmp_path / "O1.nc", control="fanuc-0i-f")


def test_the_rows_of_the_self_test_can_be_written(tmp_path: Path) -> None:
    """What another system is held to; the options that a row has no word for are few."""
    file = tmp_path / "some.rows"
    tool = ROOT / "tools" / "selftest_rows.py"
    told = subprocess.run(
        [sys.executable, tool, "--every", "211", file], capture_output=True, text=True, check=False
    )
    assert told.returncode == 0, told.stderr[-2000:]
    written = int(re.search(r": (\d+) rows", told.stdout)[1])
    left_out = sum(map(int, re.findall(r"left out: (\d+)", told.stdout)))
    assert written > 50
    assert left_out < written / 20, told.stdout
    assert file.read_text(encoding="utf-8").count("\nend\n") == written
