"""What the documentation shows is what happens: docstrings, the README, the examples."""

from __future__ import annotations

import doctest
import importlib
import os
import pkgutil
import re
import shlex
from pathlib import Path

import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app

ROOT = Path(__file__).resolve().parent.parent
README = ROOT / "README.md"
EXAMPLES = ROOT / "examples"

MODULES = sorted(["cncsub", *(f"cncsub.{m.name}" for m in pkgutil.iter_modules(cncsub.__path__))])


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
    classes = ["library.Library", "program.Program", "run.Run", "run.Machine", "setup.Setup"]
    classes += ["inputs.Inputs", "tables.Steps", "tables.Calls", "tables.Moves"]
    assert {f"cncsub.{name}" for name in classes} - shown == set()


# ---- commands ----


def commands(text: str) -> list[list[str]]:
    """The calls of cncsub in a text, each as its arguments."""
    return [shlex.split(line)[1:] for line in re.findall(r"\bcncsub (?:run|tree) [^)`\n]*", text)]


def invoke(arguments: list[str]) -> tuple[int, str]:
    result = CliRunner().invoke(app, arguments)
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        raise result.exception
    return result.exit_code, result.output


# ---- the README ----


def fenced(language: str) -> list[str]:
    if not README.exists():
        return []
    text = README.read_text(encoding="utf-8")
    return re.findall(rf"^```{language}\n(.*?)^```", text, re.MULTILINE | re.DOTALL)


@pytest.fixture
def at_root(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    monkeypatch.setenv("COLUMNS", "200")


@pytest.mark.usefixtures("at_root")
def test_the_python_of_the_readme_runs(capsys: pytest.CaptureFixture[str]) -> None:
    """One after the other, with the names of those before; `>>>` blocks with their output."""
    names: dict[str, object] = {}
    runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
    for number, block in enumerate(fenced("python")):
        if ">>>" in block:
            test = doctest.DocTestParser().get_doctest(block, names, f"block {number}", None, None)
            runner.run(test, clear_globs=False)
            names.update(test.globs)
        else:
            exec(compile(block, f"README.md, python block {number}", "exec"), names)
    assert runner.failures == 0, capsys.readouterr().out


def shown_commands() -> list[tuple[str, str]]:
    """`$ cncsub ...` in the shell blocks of the README, each with the output shown below it."""
    shown = []
    for language in ("console", "sh", "shell", "bash", "text", ""):
        for block in fenced(language):
            parts = re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]
            shown += [(c, o) for c, _, o in (part.partition("\n") for part in parts)]
    return [(command, output) for command, output in shown if command.startswith("cncsub ")]


@pytest.mark.usefixtures("at_root")
@pytest.mark.parametrize(("command", "output"), shown_commands())
def test_the_commands_of_the_readme_print_what_is_shown(command: str, output: str) -> None:
    _, printed = invoke(shlex.split(command)[1:])
    pattern = ".*?".join(re.escape(part) for part in output.strip().split("..."))
    assert re.fullmatch(pattern, printed.strip(), re.DOTALL), printed


# ---- the examples ----


def example_files() -> list[Path]:
    files = (Path(folder, name) for folder, _, names in os.walk(EXAMPLES) for name in names)
    return sorted(file for file in files if file.suffix not in (".toml", ".ipynb"))


def header(file: Path) -> str:
    """The comment lines at the head of an example."""
    lines = cncsub.files.decode(file.read_bytes()).splitlines()
    head = []
    for line in lines:
        if not re.match(r"\s*($|%|O\d|:\d|<|\(|;)", line):
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


def example_commands() -> list[tuple[str, list[str]]]:
    return [
        (str(file.relative_to(EXAMPLES)), command)
        for file in example_files()
        for command in commands(header(file))
    ]


@pytest.mark.usefixtures("at_root")
@pytest.mark.parametrize(("file", "command"), example_commands())
def test_an_example_ends_as_it_says(file: str, command: list[str]) -> None:
    """Without an alarm, unless its header names the alarm."""
    assert file in " ".join(command) or str(Path(file).parent) in " ".join(command)
    status, printed = invoke(command)
    alarms = re.search(r"\balarms?\b", header(EXAMPLES / file), re.IGNORECASE)
    if status == 0:
        assert "stopped: " in printed
    else:
        assert status == 1, printed
        assert alarms, printed


def tabled() -> list[tuple[str, str]]:
    """The rows of the table of controls: the control, and its rules by evidence."""
    return re.findall(r"^\| `([\w-]+)` \|.*\| ([\d /]+) \|$", README.read_text(), re.MULTILINE)


@pytest.mark.parametrize(("name", "counts"), tabled())
def test_the_table_of_controls_counts_their_rules(name: str, counts: str) -> None:
    kinds = ("source document", "maker's manual", "secondary", "inferred")
    rules = cncsub.controls[name].rules
    evidence = [str(rule.evidence) for rule in rules]
    evidence += [str(strength) for rule in rules for _, strength in rule.sources.values()]
    assert counts == " / ".join(str(evidence.count(kind)) for kind in kinds)
