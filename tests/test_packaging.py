"""The contents of the installed package: version, types, files, and what importing it costs."""

import re
import subprocess
import sys
import tomllib
from importlib import metadata, resources
from pathlib import Path
from typing import Any

import pytest

import cncsub

ROOT = Path(__file__).resolve().parent.parent
HEAVY = ["numpy", "pandas", "plotly", "pyarrow", "polars", "rich", "typer", "click"]


def run_python(code: str) -> str:
    """Run `code` in an interpreter of its own and return what it prints."""
    command = [sys.executable, "-c", code]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


@pytest.mark.parametrize("name", ["py.typed", "_core.pyi"])
def test_the_package_carries_its_types(name: str) -> None:
    assert resources.files("cncsub").joinpath(name).is_file()


def test_the_version_of_the_package_is_that_of_the_newest_changelog_entry() -> None:
    changelog = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    newest = re.search(
        r"^## \[(\d[^\]]*)\] - (\d{4}-\d\d-\d\d|Unreleased)$", changelog, re.MULTILINE
    )
    assert newest is not None
    assert newest[1] == metadata.version("cncsub")


def test_the_version_is_written_once_and_reaches_the_module() -> None:
    assert cncsub.__version__ == metadata.version("cncsub")


def test_the_command_is_the_main_of_the_command_line() -> None:
    scripts = {e.name: e.value for e in metadata.distribution("cncsub").entry_points}
    assert scripts["cncsub"] == "cncsub.cli:main"


def test_numpy_is_all_that_an_installation_without_extras_draws_in() -> None:
    required = [r for r in metadata.requires("cncsub") or [] if "extra ==" not in r]
    assert [re.split(r"[^a-z]", r)[0] for r in required] == ["numpy"]


def test_the_extra_of_the_command_is_part_of_those_that_use_it() -> None:
    extras = _project()["project"]["optional-dependencies"]
    assert sorted(re.split(r"[^a-z]", r)[0] for r in extras["cli"]) == ["rich", "typer"]
    for name in ("test", "docs"):
        assert "cncsub[cli]" in extras[name]
    assert _project()["tool"]["cibuildwheel"]["test-extras"] == ["cli"]


def test_nothing_is_installed_outside_the_package_and_its_metadata() -> None:
    files = metadata.distribution("cncsub").files or []
    strangers = [
        str(f)
        for f in files
        if not re.match(
            r"cncsub/|cncsub_pytest/|cncsub-[^/]+\.dist-info/|.*/(bin|Scripts)/cncsub(\.exe)?$",
            f.as_posix(),
        )
    ]
    assert files
    assert strangers == []


def test_the_licence_comes_with_the_package() -> None:
    distribution = metadata.distribution("cncsub")
    assert distribution.metadata["License-Expression"] == "MIT"
    assert any(f.name == "LICENSE" for f in distribution.files or [])


@pytest.fixture(scope="module")
def imported() -> set[str]:
    """Return the names of the modules that `import cncsub` loads in a fresh interpreter."""
    return set(
        run_python(
            "import sys; before = set(sys.modules); import cncsub;"
            " print(*sorted(set(sys.modules) - before))"
        ).split()
    )


def test_importing_the_package_loads_the_engine(imported: set[str]) -> None:
    assert {"cncsub", "cncsub._core"} <= imported


@pytest.mark.parametrize("module", HEAVY)
def test_importing_the_package_does_not_import(module: str, imported: set[str]) -> None:
    assert module not in imported


def test_the_import_needs_no_optional_package() -> None:
    blocked = ["pandas", "plotly", "pyarrow"]
    code = f"import sys; sys.modules.update(dict.fromkeys({blocked})); import cncsub; print('ok')"
    assert run_python(code) == "ok\n"


# ---- without the extra of the command ----

CALLS = "import sys; sys.argv = ['cncsub', *sys.argv[1:]]; from cncsub.cli import main; main()"


def ended_without(
    code: str, *words: str, missing: tuple[str, ...] = ("rich", "typer")
) -> subprocess.CompletedProcess[str]:
    """Run `code` where some packages cannot be imported, as if they were not installed."""
    without = f"import sys; sys.modules.update(dict.fromkeys({missing}));"
    command = [sys.executable, "-c", without + code, *words]
    return subprocess.run(command, capture_output=True, text=True, cwd=ROOT, check=False)


@pytest.mark.parametrize("words", [(), ("--version",), ("run", "part.nc"), ("--help",)])
def test_the_command_says_what_to_install(words: tuple[str, ...]) -> None:
    done = ended_without(CALLS, *words)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.count("\n") == 1
    assert "pip install 'cncsub[cli]'" in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize(("command", "package"), [("mcp", "mcp"), ("lsp", "pygls")])
def test_a_server_says_what_to_install(command: str, package: str) -> None:
    done = ended_without(CALLS, command, missing=(package,))
    assert done.returncode == 2
    assert f"pip install 'cncsub[{command}]'" in done.stderr


def test_another_module_that_is_missing_is_not_taken_for_the_extra() -> None:
    done = ended_without("sys.modules['cncsub.escapes'] = None;" + CALLS, "--version")
    assert "cncsub[cli]" in done.stderr  # typer is asked for first
    code = "import sys; sys.modules['cncsub.escapes'] = None;" + CALLS
    command = [sys.executable, "-c", code, "--version"]
    other = subprocess.run(command, capture_output=True, text=True, cwd=ROOT, check=False)
    assert "cncsub.escapes" in other.stderr
    assert "cncsub[cli]" not in other.stderr


@pytest.mark.parametrize(
    "code",
    [
        "run.raise_for_alarm(); assert len(run.steps) and len(run.moves)",
        "assert library.notes == () and library.check(rules=['CS201']) == []",
        "assert '<html' in cncsub.report(library, run)",
        "assert run._repr_html_() and library._repr_html_() and run.calls._repr_html_()",
        "print(run, run.calls, run.summary(), library.flatten().text)",
        "assert cncsub.compare(library, controls=['fanuc-0i-f', 'fanuc-30i']).same",
        "assert run.coverage().percent",
        "import cncsub.testing; cncsub.testing.load_table",
        "from cncsub.cli.project import find_project; import pathlib; find_project(pathlib.Path())",
    ],
)
def test_the_package_needs_no_extra(code: str) -> None:
    program = "O1\\nG65 P2 A1.\\nM30\\nO2\\nG0 X#1\\nM99\\n"
    head = f"import cncsub; library = cncsub.loads('{program}', control='fanuc-0i-f');"
    done = ended_without(f"{head} run = library.run(); {code}")
    assert (done.returncode, done.stderr) == (0, "")


def test_the_plugin_of_pytest_needs_no_extra(tmp_path: Path) -> None:
    (tmp_path / "test_it.py").write_text(
        'def test_it(cnc):\n    cnc.run("O1\\nM30\\n").assert_ends()\n', encoding="utf-8"
    )
    code = (
        "import pytest; sys.exit(pytest.main(['-q', '-p', 'no:cacheprovider', '--control',"
        f" 'fanuc-0i-f', '-c', '/dev/null', {str(tmp_path)!r}]))"
    )
    done = ended_without(code)
    assert "1 passed" in done.stdout, done.stdout + done.stderr


# ---- the hook of pre-commit ----


@pytest.mark.parametrize(
    ("file", "taken"),
    [
        ("O1000", True),
        ("macros/O9010", True),
        ("o0001", True),
        ("1000", True),
        ("O1000_ROUGH", True),
        ("job/part.nc", True),
        ("PART.MPF", True),
        ("PART.TAP", True),
        ("README", False),
        ("Makefile", False),
        ("O1000.txt", False),
        ("OPTIONS", False),
        ("notes/1000/readme.md", False),
        ("setup.toml", False),
    ],
)
def test_the_hook_takes_programs_with_and_without_an_ending(file: str, taken: bool) -> None:
    yaml = pytest.importorskip("yaml")
    (hook,) = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text(encoding="utf-8"))
    assert (re.search(hook["files"], file) is not None) is taken
    assert hook["additional_dependencies"] == [".[cli]"]


def test_the_command_of_the_hook_checks_a_file_without_an_ending(tmp_path: Path) -> None:
    yaml = pytest.importorskip("yaml")
    (hook,) = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text(encoding="utf-8"))
    (tmp_path / "cncsub.toml").write_text('control = "fanuc-0i-f"\n', encoding="utf-8")
    (tmp_path / "O1000").write_text("O1000\nM98 P9\nM30\n", encoding="utf-8")
    words = [*hook["entry"].split()[1:], "O1000"]
    command = [sys.executable, "-c", CALLS, *words]
    done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, check=False)
    assert done.returncode == 1
    assert "CS201" in done.stdout


# ---- wheels for other systems ----


def _project() -> dict[str, Any]:
    return tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))


def _workflow(name: str) -> dict[str, Any]:
    yaml = pytest.importorskip("yaml")
    text = (ROOT / ".github" / "workflows" / f"{name}.yml").read_text(encoding="utf-8")
    told: dict[str, Any] = yaml.safe_load(text)
    return told


def test_wheels_are_built_for_every_python_that_the_package_takes() -> None:
    project = _project()
    built = project["tool"]["cibuildwheel"]["build"]
    oldest = int(re.fullmatch(r">=3\.(\d+)", project["project"]["requires-python"])[1])  # type: ignore[index]
    numbers = {int(re.fullmatch(r"cp3(\d+)t?-\*", name)[1]) for name in built}  # type: ignore[index]
    assert numbers == set(range(oldest, max(numbers) + 1))
    assert any("t-" in name for name in built), "no free-threaded build"
    # The versions that the classifiers claim were run; the build of any other tests itself.
    claimed = re.findall(r":: Python :: 3\.(\d+)", " ".join(project["project"]["classifiers"]))
    assert {oldest} <= set(map(int, claimed)) <= numbers


def test_every_architecture_of_the_configuration_has_a_machine_that_builds_it() -> None:
    asked = _project()["tool"]["cibuildwheel"]
    wanted = [(s, a) for s in ("linux", "macos", "windows") for a in asked[s]["archs"]]
    runs = _workflow("wheels")["jobs"]["wheels"]["strategy"]["matrix"]["include"]
    systems = {"ubuntu": "linux", "macos": "macos", "windows": "windows"}
    built = [(systems[run["os"].split("-")[0]], run["archs"]) for run in runs]
    assert sorted(built) == sorted(wanted)


def test_the_tests_of_a_wheel_are_there_and_run_from_what_is_copied_beside_them() -> None:
    asked = _project()["tool"]["cibuildwheel"]
    files = [w for line in asked["test-command"] for w in line.split() if "/" in w]
    assert any(file.startswith("tests/conformance/") for file in files)
    for file in files:
        assert (ROOT / file).exists(), file
        assert file.split("/")[0] in asked["test-sources"]
    for name in asked["test-sources"]:
        assert (ROOT / name).exists(), name


def test_publishing_needs_a_tag_and_trust_and_no_password() -> None:
    told = _workflow("wheels")
    publish = told["jobs"]["publish"]
    assert publish["permissions"] == {"id-token": "write"}
    assert publish["if"] == "startsWith(github.ref, 'refs/tags/v')"
    assert set(publish["needs"]) == {"sdist", "wheels"}
    assert told["permissions"] == {"contents": "read"}
    for name in ("tests", "wheels"):
        text = (ROOT / ".github" / "workflows" / f"{name}.yml").read_text(encoding="utf-8")
        assert not re.search(r"secrets\.|password:|token:\s*\$", text)


def test_the_workflows_run_files_that_are_there() -> None:
    for name in ("tests", "wheels"):
        text = (ROOT / ".github" / "workflows" / f"{name}.yml").read_text(encoding="utf-8")
        for file in re.findall(r"(?<![\w/.])(?:tests|tools|\.ci)/[\w./-]+\w", text):
            assert (ROOT / file).exists(), file


def test_the_source_distribution_is_without_what_only_a_forge_reads() -> None:
    assert {".ci", ".github"} <= set(_project()["tool"]["scikit-build"]["sdist"]["exclude"])
