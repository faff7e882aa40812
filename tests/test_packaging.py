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


def test_numpy_typer_and_rich_are_all_that_an_installation_draws_in() -> None:
    required = [r for r in metadata.requires("cncsub") or [] if "extra ==" not in r]
    assert sorted(re.split(r"[^a-z]", r)[0] for r in required) == ["numpy", "rich", "typer"]


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
