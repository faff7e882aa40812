"""What the installed package is made of: version, types, files, and what importing it costs."""

import re
import subprocess
import sys
from importlib import metadata, resources
from pathlib import Path

import pytest

import cncsub

ROOT = Path(__file__).resolve().parent.parent
HEAVY = ["numpy", "pandas", "pyarrow", "polars", "rich", "typer", "click"]


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
            r"cncsub/|cncsub_pytest/|cncsub-[^/]+\.dist-info/|.*/bin/cncsub$", f.as_posix()
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
    """Names of the modules that `import cncsub` loads in a fresh interpreter."""
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
    blocked = ["pandas", "pyarrow"]
    code = f"import sys; sys.modules.update(dict.fromkeys({blocked})); import cncsub; print('ok')"
    assert run_python(code) == "ok\n"
