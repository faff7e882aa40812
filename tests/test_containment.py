"""Nothing of a program gets out of its folders, into a page, onto a terminal, or is executed."""

from __future__ import annotations

import ast
import json
import os
import re
import subprocess
import sys
import unicodedata
from pathlib import Path

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app

CONTROL = "fanuc-30i"
PACKAGE = Path(cncsub.__file__).parent
EVIL = "\x1b[31m\x1b]0;own\x07\x9b31m\x08\x7f\u202e\u2066\u200f"
OBEYED = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\u200e\u200f\u202a-\u202e\u2066-\u2069]")

# ---- files ----


def outcome(folder: Path, *, control: str = CONTROL) -> cncsub.Run:
    return cncsub.load(folder, control=control, external=folder / "usb").run("O1", max_blocks=50)


@pytest.fixture
def job(tmp_path: Path) -> Path:
    """A memory with an external device, and next to it files that must not be read."""
    (tmp_path / "job" / "usb").mkdir(parents=True)
    (tmp_path / "job" / "usb" / "O3.nc").write_text("N10 M99\n")
    (tmp_path / "O2.nc").write_text("N10 #100=1\nM99\n")
    (tmp_path / "secret").write_text("N10 #100=1\nM99\n")
    return tmp_path / "job"


NAMES = [
    "../O2", "..\\O2", "../O2.nc", "./../secret", "usb/../../O2", "/etc/passwd", "~/O2", "$HOME/O2",
    "O2\0", "%2e%2e/O2", "file:///etc/passwd", "..%c0%af..", "CON", "\\\\host\\share", "C:\\O2", "*",
    "O?", "../" * 200 + "etc/passwd", "", " ", ".", "..", "`id`", "$(id)", "; id", "| id",
]  # fmt: skip


@pytest.mark.parametrize("name", NAMES)
def test_no_name_of_a_program_leads_out_of_the_folders(job: Path, name: str) -> None:
    for call in (f"M98 <{name}>", f"M198 <{name}>", f"G65 <{name}>", f"M98 P[{name}]"):
        (job / "O1.nc").write_text(f"N10 {call}\nN20 M30\n")
        for control in cncsub.controls:
            run = outcome(job, control=control)
            assert run.stop in (cncsub.Stop.ALARM, cncsub.Stop.END, cncsub.Stop.LIMIT)
            assert all(call.program in ("O1", "O3") for call in run.calls)
            assert run.variables.get(100) is None if control != "gsk-928te" else True


def test_an_external_device_of_links_shows_nothing_behind_them(job: Path) -> None:
    (job / "usb" / "O2.nc").symlink_to(job.parent / "O2.nc")
    (job / "usb" / "up").symlink_to(job.parent)
    os.mkfifo(job / "usb" / "O4.nc")
    (job / "usb" / "O5.nc").symlink_to("/dev/zero")
    for number in (2, 4, 5):
        (job / "O1.nc").write_text(f"N10 M198 P{number}\nN20 M30\n")
        run = outcome(job)
        assert run.alarm is not None
        assert run.alarm.cause == "external-program-not-found"


def test_names_of_two_unicode_forms_are_two_programs(tmp_path: Path) -> None:
    forms = [unicodedata.normalize(form, "PIÈCE") for form in ("NFC", "NFD")]
    for value, name in enumerate(forms):
        (tmp_path / f"{name}.nc").write_text(f"#100={value}\nM99\n", encoding="utf-8")
    library = cncsub.load(tmp_path, control="gsk-988ta")
    assert set(library) == set(forms)
    assert [library.run(name).variables[100] for name in forms] == [0, 1]
    for name in forms:  # a program can call neither of the two
        alarm = library.mdi(f"M98 P[{name}]").alarm
        assert alarm is not None
        assert alarm.cause == "illegal-program-name"


def test_names_that_are_no_text_are_read_and_shown(tmp_path: Path) -> None:
    with open(os.fsencode(tmp_path) + b"/O\xff1.nc", "w") as file:  # noqa: PTH123
        file.write("N10 M98 P9\n")
    run = cncsub.load(tmp_path, control="gsk-988ta").run()
    assert "O?1" in str(run.alarm)


def test_only_the_folders_that_were_named_are_opened(job: Path) -> None:
    (job / "O1.nc").write_text("N10 M198 P3\nPOPEN\nDPRNT[A]\nPCLOS\nN20 M98 <../O2>\nM30\n")
    code = f"""
import sys, cncsub
cncsub.loads("", control="{CONTROL}").run()
seen = []
sys.addaudithook(lambda event, arguments: seen.append((event, arguments)))
cncsub.load({str(job)!r}, control="{CONTROL}", external={str(job / "usb")!r}).run()
print([(event, str(arguments[0])) for event, arguments in seen
       if not isinstance(arguments[0], int)
       and event.startswith(("open", "os.", "socket", "subprocess", "exec", "ctypes", "import"))])
"""
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=job
    )
    events = ast.literal_eval(done.stdout)
    opened = {path for event, path in events if event == "open"}
    assert opened == {str(job / "O1.nc"), str(job / "usb" / "O3.nc")}
    listed = {path for event, path in events if event in ("os.listdir", "os.scandir")}
    assert all(Path(path).is_relative_to(job) for path in listed)
    assert {event for event, _ in events} <= {"open", "os.listdir", "os.scandir"}


def test_a_run_writes_no_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    text = "O1\nPOPEN\nDPRNT[PRNT.TXT]\nBPRNT[A#1[3]]\nPCLOS\nG10 L2 P1 X1.\nM30\n"
    for control in cncsub.controls:
        cncsub.loads(text, control=control, name="../O1.nc").run()
    assert list(tmp_path.iterdir()) == []


# ---- settings ----


@pytest.mark.parametrize(
    "text",
    [
        "start = 1", "[start]\nX = 'import os'", "machine = '''$(id)'''", "__class__ = 1",
        "[work_offsets.'../G54']\nX = 1", "include = '/etc/passwd'", "increment = nan",
        "increment = inf", "start = {X = 1e400}", "[tools.99999999999999999999]\nX = 1", "a = " + "[" * 50_000,
        "a" + ".a" * 5_000 + " = 1", "x = 1\nx = 2", "\0", "limits = {X = [2, 1]}",
    ],
)  # fmt: skip
def test_a_settings_file_is_data_or_refused(tmp_path: Path, text: str) -> None:
    file = tmp_path / "setup.toml"
    file.write_text(text)
    with pytest.raises(ValueError, match=re.escape(str(file))):
        cncsub.Setup.from_toml(file)


def test_a_settings_file_is_a_regular_file(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.toml")
    for path in (tmp_path / "pipe.toml", Path("/dev/zero"), tmp_path):
        with pytest.raises(ValueError, match="not a regular file"):
            cncsub.Setup.from_toml(path)


def test_nothing_that_is_read_can_be_code() -> None:
    refused = {"pickle", "marshal", "shelve", "dill", "yaml", "subprocess", "ctypes", "socket"}
    # The adapter of debuggers and the language server listen on a port where they are asked to.
    listens = PACKAGE / "cli" / "ports.py"
    for file in PACKAGE.glob("**/*.py"):
        here = refused - {"socket"} if file == listens else refused
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import):
                assert not here & {name.name.split(".")[0] for name in node.names}, file
            if isinstance(node, ast.ImportFrom) and node.module:
                assert node.module.split(".")[0] not in here, file
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
                assert node.func.id not in ("eval", "exec", "compile", "__import__"), file


# ---- pages ----


# The tags of our own pages; any other tag came from a program. None of these runs or loads
# anything.
OURS = "table|thead|tbody|tr|th|td|p|div|pre|span|svg|details|summary"
MARKUP_OF_A_PROGRAM = re.compile(rf"<(?!/?({OURS})\b)")


@pytest.mark.parametrize("words", ["list", "check", "tree --static", "batch", "batch --check"])
def test_folders_of_a_project_that_lie_outside_of_it_are_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, words: str
) -> None:
    for name in ("here", "out"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "O1.nc").write_text("O1\nG0 X1.\nM30\n")
    monkeypatch.chdir(tmp_path / "here")
    for folders, told in ((["../out"], 1), (["."], 0)):
        Path("cncsub.toml").write_text(f'control = "{CONTROL}"\nfolders = {folders!r}\n')
        done = CliRunner().invoke(app, words.split())
        assert done.exit_code == 0
        assert done.stderr.count("the project file gives it as folders, and it is outside") == told


def test_no_text_of_a_program_is_markup_in_a_page(tmp_path: Path) -> None:
    script = "<script>alert(1)</script>"
    file = tmp_path / f"{script.replace('/', '&')}\"'&lt;.nc"
    file.write_text(
        f"({script})\nN10 G65 P2 A1.({script})\nN15 #3006=1({script})\nN20 X1.\n"
        f"N30 #3000=1({script})\nO2 ({script})\nN40 G0 X1.\nN50 M98 P3\nM99\n<{script[:7]}>\nM99\n"
    )
    shown = 0
    for control in ("gsk-988ta", CONTROL):
        library = cncsub.load(file, control=control)
        run = library.run()
        machine = library.machine()
        first = library.main
        assert first is not None
        things = [
            library, first, first.blocks, first.blocks[0], run, run.steps, run.calls, run.moves,
            run.alarm, run.variables, machine, machine.steps, library.control, cncsub.controls,
            *run.steps[:3], *run.calls[:3], *run.moves[:3],
        ]  # fmt: skip
        for thing in things:
            page = getattr(thing, "_repr_html_", None)
            if page is not None:
                shown += 1
                html = page()
                assert "<script" not in html
                assert not MARKUP_OF_A_PROGRAM.search(html)
    assert shown > 4


# ---- the terminal ----

TEXTS = {
    "a title": f"O1 ({EVIL})\nN10 M98 P9\n",
    "a block": f"O1\nN10 M98 P9 ({EVIL})\n",
    "a word": f"O1\nN10 X{EVIL}1\n",
    "a character": f"O1\nN10 {EVIL}\n",
    "a message": f"O1\nN10 #3006=1({EVIL})\nN20 M30\n",
    "output": f"O1\nN10 DPRNT[A{EVIL}B]\nN20 M30\n",
    "an alarm": f"O1\nN10 #3000=1({EVIL})\n",
    "a name": "<A\x1b[31mB>\nN10 M98 <A\x1b[31mC>\nM30\n<A\x1b[31mC>\nM98 P9\nM99\n",
    "a name that is not there": f"O1\nN10 M98 <A{EVIL.replace(';', '')}>\n",
}


def on_a_terminal(*commands: list[str]) -> list[str]:
    """Return what each command writes to a terminal, outputs and errors alike."""
    code = """
import json, sys
from cncsub.cli import app
for arguments in json.loads(sys.argv[1]):
    try:
        app(arguments, prog_name="cncsub")
    except SystemExit:
        pass
    sys.stdout.flush()
    print("--- end", flush=True)
"""
    master, slave = os.openpty()
    environment = dict(os.environ, NO_COLOR="1", TERM="dumb", COLUMNS="200")
    command = [sys.executable, "-c", code, json.dumps(commands)]
    with subprocess.Popen(command, stdout=slave, stderr=slave, env=environment):
        os.close(slave)
        written = b""
        try:
            while piece := os.read(master, 65536):
                written += piece
        except OSError:  # the other end is closed
            pass
    os.close(master)
    text = written.decode("utf-8", "replace").replace("\r\n", "\n")
    *parts, rest = text.split("--- end\n")
    assert (len(parts), rest) == (len(commands), "")
    return parts


def test_the_terminal_is_told_nothing_by_a_program(tmp_path: Path) -> None:
    commands = []
    for number, text in enumerate(TEXTS.values(), 1):
        file = tmp_path / f"O{number}.nc"
        file.write_text(text, encoding="utf-8")
        for command in (["run"], ["tree"], ["run", "--format", "json"]):
            commands.append([*command, str(file), "-c", CONTROL])
    for command, written in zip(commands, on_a_terminal(*commands), strict=True):
        assert written, command
        assert not OBEYED.search(written), repr(written)


def test_the_terminal_is_told_nothing_by_what_was_typed(tmp_path: Path) -> None:
    file = tmp_path / "O1.nc"
    file.write_text("M30\n")
    commands = [
        ["run", str(file), "-c", EVIL],
        ["run", f"{tmp_path}/{EVIL}.nc", "-c", CONTROL],
        ["run", str(file), "-c", CONTROL, "--main", EVIL],
        ["run", str(file), "-c", CONTROL, "--mdi", f"X{EVIL}"],
        ["run", str(file), "-c", CONTROL, "--setup", EVIL],
        ["explain", EVIL],
    ]
    for command, written in zip(commands, on_a_terminal(*commands), strict=True):
        assert written, command
        assert not OBEYED.search(written), repr(written)


def test_json_says_what_the_terminal_is_not_told(tmp_path: Path) -> None:
    file = tmp_path / "O1.nc"
    file.write_text(TEXTS["an alarm"], encoding="utf-8")
    (written,) = on_a_terminal(["run", str(file), "-c", CONTROL, "--format", "json"])
    assert json.loads(written)["alarm"]["text"] == EVIL


def test_a_message_of_an_alarm_is_safe_to_print_wherever_it_goes() -> None:
    for text in TEXTS.values():
        run = cncsub.loads(text, control=CONTROL, name=f"{EVIL}.nc").run()
        assert not OBEYED.search(str(run.alarm))
        if run.alarm is not None:
            assert str(cncsub.AlarmError(run.alarm)) == str(run.alarm)


def test_entries_with_control_characters_in_their_names_are_left_out(tmp_path: Path) -> None:
    (tmp_path / "O1.nc").write_text("M30\n")
    (tmp_path / "O2.nc\n  --> O3").write_text("M30\n")
    (tmp_path / "O\x1b[31m.nc").write_text("M30\n")
    library = cncsub.load(tmp_path, control=CONTROL)
    assert list(library) == ["O1"]
    assert {why for _, why in library.skipped} == {"a name with control characters"}
