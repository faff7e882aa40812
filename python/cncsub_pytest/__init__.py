"""The plugin of cncsub for pytest: the fixture `cnc`, `--control`, snapshots, coverage, and tables
in TOML (`*.nctest.toml`) as tests.
"""

from __future__ import annotations

import difflib
import importlib
import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from cncsub_pytest import coverage
from cncsub_pytest.settings import WHERE, control_named, controls_for

if TYPE_CHECKING:
    import cncsub
    from cncsub.testing.cases import Case


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("cncsub")
    group.addoption(
        "--control",
        action="append",
        metavar="NAME",
        help="The control of the fixture cnc; give it several times to run the tests on each.",
    )
    group.addoption(
        "--cncsub-update", action="store_true", help="Write the snapshots of cnc.snapshot again."
    )
    coverage.add_options(group)
    parser.addini("cncsub_control", "The controls of the fixture cnc.", type="args", default=[])


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line("markers", "cnc(control): the control, or controls, of the fixture cnc")
    if coverage.is_wanted(config):
        config.pluginmanager.register(coverage.Measuring(config), "cncsub_coverage")


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    if "cnc" not in metafunc.fixturenames:
        return
    marker = metafunc.definition.get_closest_marker("cnc")
    own: Any = ()
    if marker is not None:
        own = marker.kwargs.get("control", marker.args[0] if marker.args else ())
    names = controls_for(metafunc.config, metafunc.definition.path.parent, own)
    metafunc.parametrize("cnc", names or [None], indirect=True, ids=lambda name: name or "control")


@pytest.fixture
def cnc(request: pytest.FixtureRequest) -> Cnc:
    """Load and run programs on the control of `--control`."""
    # Here, and not in the first example of hypothesis, which has to keep a deadline.
    for module in ("cncsub.cli.project", "cncsub.loading"):
        importlib.import_module(module)
    return Cnc(request.param, request)


class Cnc:
    """The control of a test. `control` is its name."""

    def __init__(self, control: str | None, request: pytest.FixtureRequest) -> None:
        self._control = control
        self._request = request
        self._snapshots = 0

    def _known(self) -> cncsub.Control:
        if self._control is None:
            pytest.fail(f"which control? {WHERE}", pytrace=False)
        try:
            return control_named(self._control, self._request.path.parent)
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
            pytest.fail(f"there is no {place}: run with --cncsub-update to write it", pytrace=False)
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
        from cncsub.testing.toml import table_in

        try:
            table = table_in(self.path, needs_control=False)
            if not self.config.getoption("--control"):
                self._check_controls({name: None for case in table for name in case.controls})
        except ValueError as error:
            raise self.CollectError(str(error)) from None
        for case in table:
            names = controls_for(self.config, self.path.parent, case.controls)
            for control in names or (None,):
                name = f"{case.claim} [{control or 'control'}]"
                yield Item.from_parent(self, name=name, case=(case, control))

    def _check_controls(self, names: Iterable[str]) -> None:
        for name in names:
            try:
                control_named(name, self.path.parent)
            except ValueError as error:
                raise ValueError(f"{self.path}: {error}") from None


class Item(pytest.Item):
    """A case of a table, on one control."""

    def __init__(self, *, case: tuple[Case, str | None], **more: Any) -> None:
        super().__init__(**more)
        self.case, self.control = case

    def runtest(self) -> None:
        from cncsub.testing.outcome import check_case

        if self.control is None:
            pytest.fail(f"which control? {WHERE}", pytrace=False)
        check_case(self.case, control_named(self.control, self.path.parent))

    def repr_failure(self, excinfo: Any, style: Any = None) -> Any:
        if isinstance(excinfo.value, AssertionError | ValueError):
            return str(excinfo.value.args[0])
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, int | None, str]:
        return self.path, None, self.name


# ---- tests without a control ----


_NO_CONTROL = "cncsub_no_control"  # what a worker sends
_USAGE = pytest.StashKey[str]()


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Stop with one usage error where tests have no control. A single test that has none, among
    others that have one, fails by itself.
    """
    controls = [(item, _control_of(item)) for item in items if _has_control(item)]
    left = [item for item, control in controls if control is None]
    if not left or (len(left) == 1 < len(controls)) or config.option.collectonly:
        return
    first = left[0].nodeid
    tests = f"{first} has" if len(left) == 1 else f"{len(left)} tests have"
    fault = f"which control? {tests} none{f', the first {first}' if len(left) > 1 else ''}. {WHERE}"
    if not hasattr(config, "workeroutput"):
        raise pytest.UsageError(fault)
    config.workeroutput[_NO_CONTROL] = fault  # the process that started the workers reports it
    items[:] = []


def _has_control(item: pytest.Item) -> bool:
    return isinstance(item, Item) or "cnc" in getattr(getattr(item, "callspec", None), "params", ())


def _control_of(item: pytest.Item) -> Any:
    return item.control if isinstance(item, Item) else item.callspec.params["cnc"]  # type: ignore[attr-defined]


@pytest.hookimpl(optionalhook=True)
def pytest_testnodedown(node: Any) -> None:
    fault = getattr(node, "workeroutput", {}).get(_NO_CONTROL)
    if fault is not None:
        node.config.stash[_USAGE] = fault


def pytest_sessionfinish(session: pytest.Session) -> None:
    if _USAGE in session.config.stash:
        session.exitstatus = pytest.ExitCode.USAGE_ERROR


def pytest_terminal_summary(terminalreporter: Any, config: pytest.Config) -> None:
    if _USAGE in config.stash:
        terminalreporter.write_line(f"ERROR: {config.stash[_USAGE]}", red=True)
