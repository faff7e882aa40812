"""The documentation shows what happens: docstrings, pages, pictures, examples."""

from __future__ import annotations

import dataclasses
import doctest
import importlib
import json
import os
import pkgutil
import re
import shlex
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import NamedTuple

import pytest
import typer
from typer.testing import CliRunner

import cncsub
import pictures
from cncsub.cli import COMMANDS, app
from cncsub.workpiece import SHAPES
from generator import GENERATED

ROOT = Path(__file__).resolve().parent.parent
README = ROOT / "README.md"
EXAMPLES = ROOT / "examples"
CLI = typer.main.get_command(app)

MODULES = sorted(["cncsub", *(m.name for m in pkgutil.walk_packages(cncsub.__path__, "cncsub."))])


@pytest.mark.parametrize("module", MODULES)
def test_the_examples_of_the_docstrings(module: str) -> None:
    found = doctest.testmod(importlib.import_module(module), optionflags=doctest.ELLIPSIS)
    assert found.failed == 0


def test_the_documented_parts_have_examples() -> None:
    finder = doctest.DocTestFinder()
    shown = {
        test.name
        for module in MODULES
        for test in finder.find(importlib.import_module(module))
        if test.examples
    }
    classes = ["library.Library", "program.Program", "run.Run", "machine.Machine", "setup.Setup"]
    classes += [
        "inputs.Inputs",
        "tables.of_runs.Steps",
        "tables.of_runs.Calls",
        "tables.of_runs.Moves",
    ]
    assert {f"cncsub.{name}" for name in classes} - shown == set()


# ---- commands ----


def commands(text: str) -> list[list[str]]:
    """Return the calls of cncsub in a text, each as its arguments."""
    return [shlex.split(line)[1:] for line in re.findall(r"\bcncsub (?:run|tree) [^)`\n]*", text)]


def invoke(arguments: list[str]) -> tuple[int, str]:
    result = CliRunner().invoke(app, arguments)
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        raise result.exception
    return result.exit_code, result.output


# ---- the pages ----

DOCS = ROOT / "docs"
PAGES = sorted(
    [*ROOT.glob("*.md"), *DOCS.rglob("*.md"), *(ROOT / ".github").rglob("*.md")],
    key=lambda page: (len(page.parts), page),
)
# The languages of a page. `sh` alone is not run: it builds, installs or takes minutes. Those of other
# compilers run in tests of their own (test_cpp_library, test_javascript).
LANGUAGES = {"console", "python", "py", "c", "cpp", "js", "toml", "nc", "sh", "text", "yaml", "sql"}
LANGUAGES |= {"json", "lisp", "lua"}


class Block(NamedTuple):
    """A fenced block of a page."""

    language: str
    title: str  # the file that it is written to, "" for none
    text: str
    line: int


def blocks_of(page: Path) -> list[Block]:
    text = page.read_text(encoding="utf-8")
    fence = re.compile(r"^```([^\n]*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
    found = []
    for match in fence.finditer(text):
        language, _, rest = match[1].partition(" ")
        title = re.search(r'title="([^"]+)"', rest)
        line = text.count("\n", 0, match.start()) + 1
        found.append(Block(language, title[1] if title else "", match[2], line))
    return found


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_a_page_shows_what_happens(
    page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The blocks of a page run one after the other in a folder of their own, next to the examples.

    A block with a title is written as that file, commands print what is shown, Python runs.
    """
    blocks = blocks_of(page)
    assert {block.language for block in blocks} <= LANGUAGES
    (tmp_path / "examples").symlink_to(EXAMPLES)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "200")
    names: dict[str, object] = {}
    runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
    for block in blocks:
        if block.language == "json":
            json.loads(block.text)
        if block.language == "toml":
            tomllib.loads(block.text)
        if block.title:
            file = tmp_path / block.title
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(block.text, encoding="utf-8")
        elif block.language == "console":
            assert_shows(block)
        elif block.language == "python" and ">>>" in block.text:
            test = doctest.DocTestParser().get_doctest(block.text, names, page.name, None, None)
            assert "..." not in {example.want.strip() for example in test.examples}
            runner.run(test, clear_globs=False)
            names.update(test.globs)
        elif block.language == "python":
            exec(compile(block.text, f"{page.name}, line {block.line}", "exec"), names)
    assert runner.failures == 0, capsys.readouterr().out


def shown_commands(block: Block) -> list[tuple[str, str]]:
    """Return the commands after `$`, each with the output shown below it."""
    assert block.text.startswith("$ "), f"line {block.line}: a console begins with a command"
    parts = re.split(r"^\$ ", block.text, flags=re.MULTILINE)[1:]
    return [(command, output) for command, _, output in (part.partition("\n") for part in parts)]


def assert_shows(block: Block) -> None:
    """Check that the commands of a block print and return what is shown.

    A command that fails is followed by `$ echo $?` with its status.
    """
    status = 0
    shown = shown_commands(block)
    for place, (command, output) in enumerate(shown):
        if command == "echo $?":
            assert output.strip() == str(status), f"line {block.line}: the status is {status}"
            continue
        status, printed = printed_by(command)
        assert is_shown(printed, output), f"{command}\n{printed}"
        said = shown[place + 1 : place + 2] and shown[place + 1][0] == "echo $?"
        assert status == 0 or said, f"line {block.line}: {command} returns {status}: show `echo $?`"


def is_shown(printed: str, output: str) -> bool:
    """Return whether an output is the one shown: a line `...` there stands for one line or more,
    `...` within a line for any part of the line.
    """
    lines = output.strip().splitlines()
    assert not lines or any(re.search(r"\w", line) for line in lines), (
        "an output of `...` alone can never be wrong: show a line"
    )
    pattern = "".join(
        r"(?:[^\n]*\n)+?"
        if line.strip() == "..."
        else ".*".join(re.escape(part) for part in line.rstrip().split("...")) + r" *\n"
        for line in lines
    )
    return re.fullmatch(pattern or r"\n", printed.strip() + "\n") is not None


def printed_by(command: str) -> tuple[int, str]:
    """Return the exit status of a command and what a terminal shows of it."""
    if re.fullmatch(r"cncsub [^|&;<>$()]*", command):
        return invoke(shlex.split(command)[1:])
    here = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    settings = {"NO_COLOR": "1", "PYTHONUNBUFFERED": "1", "PYTEST_ADDOPTS": "-p no:cacheprovider"}
    # Where it is set, pytest prints more than at a reader's terminal.
    own = {name: value for name, value in os.environ.items() if name != "CI"}
    done = subprocess.run(
        ["bash", "-c", command],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        env={**own, "PATH": here, **settings},
        check=False,
    )
    return done.returncode, done.stdout


@pytest.mark.parametrize(
    ("shown", "printed", "same"),
    [
        ("", "", True),
        ("", "a\n", False),
        ("a\nb", "a\nb\n", True),
        ("a\nb", "a\nc\n", False),
        ("a\n...\nd", "a\nb\nc\nd\n", True),
        ("a\n...", "a\n", False),  # the dots stand for nothing
        ("1 passed in ...", "1 passed in 0.1s\n", True),
        ("1 passed in ...", "1 passed in 0.1s\n1 failed\n", False),
    ],
)
def test_dots_stand_for_lines_or_for_a_part_of_one(shown: str, printed: str, same: bool) -> None:
    assert is_shown(printed, shown) is same


@pytest.mark.parametrize("text", ["...", "...\n...\n", " ... "])
def test_an_output_of_dots_alone_is_refused(text: str) -> None:
    with pytest.raises(AssertionError, match="never be wrong"):
        is_shown("a", text)


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ("$ false\n", "returns 1"),
        ("$ false\n$ echo $?\n0\n", "the status is 1"),
        ("$ true\n$ echo $?\n1\n", "the status is 0"),
        ("$ echo a\n", "echo a"),
        ("$ false; echo a\na\n", None),
        ("$ false\n$ echo $?\n1\n", None),
    ],
)
def test_a_command_that_fails_shows_its_status(text: str, fault: str | None) -> None:
    block = Block("console", "", text, 1)
    if fault is None:
        assert_shows(block)
        return
    with pytest.raises(AssertionError, match=fault):
        assert_shows(block)


def test_the_page_of_inputs_shows_every_key() -> None:
    (told,) = (b for b in blocks_of(DOCS / "guides/inputs.md") if b.title == "inputs.toml")
    shapes = (cncsub.Inputs, cncsub.Workpiece, *SHAPES.values())
    keys = {field.name for shape in shapes for field in dataclasses.fields(shape)}
    keys -= {next(iter(dataclasses.fields(shape))).name for shape in SHAPES.values()}
    keys |= set(SHAPES)  # the name of a shape stands for its first field
    assert keys - keys_of(tomllib.loads(told.text)) == set()


def keys_of(value: object) -> set[str]:
    """Return the keys of tables in tables and lists."""
    if isinstance(value, dict):
        return set(value).union(*map(keys_of, value.values()))
    return set().union(*map(keys_of, value)) if isinstance(value, list) else set()


def test_the_readme_is_short() -> None:
    assert len(README.read_text(encoding="utf-8").splitlines()) <= 120


def test_the_readme_names_every_control_and_no_other() -> None:
    rows = re.findall(
        r"^\| (?!maker)\w[\w, ]+ \| (`.*`) \|$", README.read_text(encoding="utf-8"), re.MULTILINE
    )
    assert sorted(re.findall(r"`([\w-]+)`", " ".join(rows))) == sorted(cncsub.controls)


def written_commands() -> list[tuple[str, str]]:
    """Return the calls of cncsub in the text and in the `sh` and `yaml` blocks of pages."""
    found = []
    for page in PAGES:
        text = re.sub(
            r"^```(?!sh|yaml).*?^```$", "", page.read_text(encoding="utf-8"), flags=re.M | re.S
        )
        calls = re.findall(r"`(cncsub [a-z][^`]*)`", text) + re.findall(
            r"^[- ]*(?:run: |entry: )?(cncsub (?:" + "|".join(COMMANDS) + r") [^#\n]*)", text, re.M
        )
        found += [(str(page.relative_to(ROOT)), " ".join(call.split())) for call in calls]
    return sorted(set(found))


@pytest.mark.parametrize(("page", "call"), written_commands())
def test_a_command_in_a_text_has_the_options_it_names(page: str, call: str) -> None:
    words = [word for word in shlex.split(call)[1:] if word != "..."]
    command = CLI.get_command(None, words[0])
    assert command is not None, f"{page}: {call}"
    options = {name for each in command.params for name in (*each.opts, *each.secondary_opts)}
    named = {word.split("=")[0] for word in words if re.match(r"--?[a-z]", word)}
    assert named <= options, f"{page}: {call}"


def local_links() -> list[tuple[str, str]]:
    found = []
    for page in PAGES:
        text = re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.M | re.S)
        for link in re.findall(r"\]\(([^)\s]+)\)", text):
            if not re.match(r"https?:|#", link):
                found.append((str(page.relative_to(ROOT)), link))
    return sorted(set(found))


@pytest.mark.parametrize(("page", "link"), local_links())
def test_a_link_leads_to_a_file_or_to_a_page_that_is_made(page: str, link: str) -> None:
    target = (ROOT / page).parent.joinpath(link.partition("#")[0]).resolve()
    made = {DOCS / name for name in GENERATED}
    assert target.exists() or target in made


def test_the_picture_of_the_path_is_the_path() -> None:
    assert pictures.PATH.read_text(encoding="utf-8") == pictures.path()


# ---- the examples ----


def example_files() -> list[Path]:
    files = (Path(folder, name) for folder, _, names in os.walk(EXAMPLES) for name in names)
    return sorted(file for file in files if file.suffix not in (".toml", ".ipynb", ".cpp", ".txt"))


def header(file: Path) -> str:
    """Return the comment lines at the head of an example."""
    lines = cncsub.files.decode(file.read_bytes()).splitlines()
    head = []
    for line in lines:
        if not re.match(r"\s*($|%|O\w+ *(\(|$)|O\d|:\d|<|\(|;)", line):
            break
        head.append(line)
    return "\n".join(head)


def test_there_are_examples_for_every_control() -> None:
    named = " ".join(header(file) for file in example_files())
    controls = {c for command in commands(named) for c in command}
    assert set(cncsub.controls) - controls == set()


@pytest.mark.parametrize("file", example_files(), ids=lambda file: str(file.relative_to(EXAMPLES)))
def test_an_example_says_how_to_run_it_and_what_to_look_at(file: Path) -> None:
    head = header(file)
    assert len(head.splitlines()) >= 3 or not commands(head)
    beside = [header(other) for other in file.parent.iterdir() if other.is_file()]
    assert commands(head) or any(commands(text) for text in beside)


@pytest.fixture
def at_root(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    monkeypatch.setenv("COLUMNS", "200")


def example_commands() -> list[tuple[str, list[str]]]:
    return [
        (str(file.relative_to(EXAMPLES)), command)
        for file in example_files()
        for command in commands(header(file))
    ]


@pytest.mark.usefixtures("at_root")
@pytest.mark.parametrize(("file", "command"), example_commands())
def test_an_example_ends_as_it_says(file: str, command: list[str]) -> None:
    """An example ends without an alarm, unless its header names the alarm."""
    assert file in " ".join(command) or str(Path(file).parent) in " ".join(command)
    status, printed = invoke(command)
    alarms = re.search(r"\balarms?\b", header(EXAMPLES / file), re.IGNORECASE)
    if status == 0:
        assert "stopped: " in printed
    else:
        assert status == 1, printed
        assert alarms, printed
