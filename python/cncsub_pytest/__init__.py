"""The plugin of cncsub for pytest: the fixture `cnc`, `--control`, snapshots, coverage, and tables
in TOML (`*.nctest.toml`) as tests.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    import cncsub
    from cncsub.testing.cases import Case


_REPORTS = {
    "html": "a page with the source",
    "lcov": "an lcov tracefile",
    "cobertura": "XML of Cobertura",
}


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("cncsub")
    group.addoption(
        "--control",
        action="append",
        metavar="NAME",
        help="The control of the fixture cnc; given again, tests run once on each.",
    )
    group.addoption(
        "--cncsub-update", action="store_true", help="Write the snapshots of cnc.snapshot anew."
    )
    group.addoption(
        "--cncsub-cov", action="store_true", help="Tell which NC blocks the tests went through."
    )
    group.addoption(
        "--cncsub-cov-fail-under", type=float, metavar="PERCENT", help="Fail below so many percent."
    )
    for name, what in _REPORTS.items():
        group.addoption(
            f"--cncsub-cov-{name}", metavar="FILE", help=f"Write the coverage as {what}."
        )
    parser.addini("cncsub_control", "The controls of the fixture cnc.", type="args", default=[])


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line("markers", "cnc(control): the control, or controls, of the fixture cnc")


def _controls(config: pytest.Config, marker: pytest.Mark | None) -> list[str]:
    """Return the controls of the command line, else of the marker, else of the settings."""
    asked: Any = config.getoption("--control")
    if not asked and marker is not None:
        asked = marker.kwargs.get("control", marker.args[0] if marker.args else ())
        asked = [asked] if isinstance(asked, str) else list(asked)
    return list(asked or config.getini("cncsub_control"))


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    if "cnc" not in metafunc.fixturenames:
        return
    names = _controls(metafunc.config, metafunc.definition.get_closest_marker("cnc"))
    metafunc.parametrize("cnc", names or [None], indirect=True, ids=lambda name: name or "control")


def _control_named(name: str, folder: Path) -> cncsub.Control:
    """Return the control of a name: a built-in one, or one of the project a folder belongs to."""
    from cncsub.cli.project import find_project

    return find_project(folder).control_named(name)


@pytest.fixture
def cnc(request: pytest.FixtureRequest) -> Cnc:
    """Load and run programs on the control of `--control`."""
    return Cnc(request.param, request)


class Cnc:
    """The control of a test. `control` is its name."""

    def __init__(self, control: str | None, request: pytest.FixtureRequest) -> None:
        self._control = control
        self._request = request
        self._snapshots = 0

    def _known(self) -> cncsub.Control:
        if self._control is None:
            pytest.fail(
                "which control? Give --control, the setting cncsub_control or"
                ' @pytest.mark.cnc("fanuc-0i-f")',
                pytrace=False,
            )
        try:
            return _control_named(self._control, self._request.path.parent)
        except ValueError as error:
            pytest.fail(str(error), pytrace=False)

    @property
    def control(self) -> str:
        return self._known().name

    def load(self, *paths: Any, **options: Any) -> cncsub.Library:
        """Load files and folders, named from the folder of the test; see `cncsub.load`."""
        import cncsub

        folder = self._request.path.parent
        return cncsub.load(*(folder / path for path in paths), control=self._known(), **options)

    def loads(self, text: str | bytes, **options: Any) -> cncsub.Library:
        """Load a text; see `cncsub.loads`."""
        import cncsub

        return cncsub.loads(text, control=self._known(), **options)

    def run(self, program: str | Path, main: str | int | None = None, **options: Any) -> cncsub.Run:
        """Run a text (of several lines), or a file or folder beside the test; `options` are those
        of `Library.run`.
        """
        text = isinstance(program, str) and "\n" in program
        library = self.loads(str(program)) if text else self.load(program)
        return library.run(main, **options)

    def snapshot(self, run: cncsub.Run, name: str | None = None) -> None:
        """Compare what a run did with the file that `--cncsub-update` writes: how it stopped, its
        calls, moves, codes, messages and variables.
        """
        from cncsub.testing.snapshots import told

        self._snapshots += 1
        place = self._place(name or str(self._snapshots))
        found = told(run)
        if self._request.config.getoption("--cncsub-update"):
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_text(found, encoding="utf-8", newline="\n")
            return
        if not place.exists():
            pytest.fail(f"there is no {place}: --cncsub-update writes it", pytrace=False)
        known = place.read_text(encoding="utf-8")
        if known == found:
            return
        lines = difflib.unified_diff(
            known.splitlines(), found.splitlines(), str(place), "this run", lineterm=""
        )
        pytest.fail("\n".join(lines), pytrace=False)

    def _place(self, name: str) -> Path:
        test = re.sub(r"[^\w.-]+", "-", f"{self._request.node.name}-{name}").strip("-")
        own = self._request.path
        return own.parent / "snapshots" / own.stem / f"{test}.txt"


# ---- tables in TOML ----


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> pytest.Collector | None:
    if not file_path.name.endswith(".nctest.toml"):
        return None
    return Table.from_parent(parent, path=file_path)


class Table(pytest.File):
    """A file `*.nctest.toml`."""

    def collect(self) -> Iterator[pytest.Item]:
        from cncsub.testing.table_files import load_table

        try:
            cases = load_table(self.path)
        except ValueError as error:
            raise self.CollectError(str(error)) from None
        asked = self.config.getoption("--control")
        for case in cases:
            for control in asked or case.controls:
                yield Item.from_parent(self, name=f"{case.claim} [{control}]", case=(case, control))


class Item(pytest.Item):
    """A case of a table, on one control."""

    def __init__(self, *, case: tuple[Case, str], **more: Any) -> None:
        super().__init__(**more)
        self._case, self._control = case

    def runtest(self) -> None:
        from cncsub.testing.outcome import check_case

        check_case(self._case, _control_named(self._control, self.path.parent))

    def repr_failure(self, excinfo: Any, style: Any = None) -> Any:
        if isinstance(excinfo.value, AssertionError | ValueError):
            return str(excinfo.value.args[0])
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, int | None, str]:
        return self.path, None, self.name


# ---- coverage ----


_COLLECTING = pytest.StashKey[Any]()


def _wants_coverage(config: pytest.Config) -> bool:
    limit = config.getoption("--cncsub-cov-fail-under")
    asked = config.getoption("--cncsub-cov") or any(_reports(config).values())
    return bool(asked) or limit is not None


def _reports(config: pytest.Config) -> dict[str, str | None]:
    """Return the files to write, by their form."""
    return {name: config.getoption(f"--cncsub-cov-{name}") for name in _REPORTS}


def pytest_sessionstart(session: pytest.Session) -> None:
    if _wants_coverage(session.config):
        from cncsub.coverage import collecting

        context = collecting()
        session.config.stash[_COLLECTING] = (context, context.__enter__())


def pytest_sessionfinish(session: pytest.Session) -> None:
    if _COLLECTING not in session.config.stash:
        return
    context, collected = session.config.stash[_COLLECTING]
    context.__exit__(None, None, None)
    for name, file in _reports(session.config).items():
        if file is not None:
            text = getattr(collected.total, f"to_{name}")()
            Path(file).parent.mkdir(parents=True, exist_ok=True)
            Path(file).write_text(text, encoding="utf-8", newline="\n")
    limit = session.config.getoption("--cncsub-cov-fail-under")
    if limit is not None and collected.total.percent < limit and session.exitstatus == 0:
        session.exitstatus = pytest.ExitCode.TESTS_FAILED


def pytest_terminal_summary(terminalreporter: Any, config: pytest.Config) -> None:
    if _COLLECTING not in config.stash:
        return
    _, collected = config.stash[_COLLECTING]
    terminalreporter.section("coverage of NC programs")
    from cncsub.coverage.formats import coverage_lines

    for line in coverage_lines(collected.total):
        terminalreporter.write_line(line)
    if collected.left_out:
        terminalreporter.write_line(
            f"left out: {collected.left_out} runs that kept no blocks, or whose programs have other"
            " texts under the same names; name= of loads tells them apart"
        )
    limit = config.getoption("--cncsub-cov-fail-under")
    if limit is not None and collected.total.percent < limit:
        terminalreporter.write_line(
            f"coverage of NC programs is {collected.total.percent:.2f} %, below {limit:g} %"
        )
