"""The coverage of NC programs by the tests of a session, of all its workers together."""

from __future__ import annotations

import pickle
from argparse import ArgumentTypeError
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    import cncsub
    from cncsub.cli.project import Project
    from cncsub.coverage import Coverage
    from cncsub.coverage.block_counts import Counted
    from cncsub.files import Reading

_REPORTS = {
    "html": "a page with the source",
    "lcov": "an lcov tracefile",
    "cobertura": "XML of Cobertura",
}
_SENT = "cncsub_coverage"  # the counts of a worker


def add_options(group: pytest.OptionGroup) -> None:
    group.addoption(
        "--cncsub-cov",
        action="append",
        nargs="?",
        const="",
        default=[],
        metavar="FOLDER",
        help="Measure which NC blocks the tests executed. With =FOLDER (a folder or a file; can"
        " be given several times) it measures all programs there, and no others: a program that no"
        " test loads counts 0 %%. Without a folder it measures the folders of the project, or all"
        " programs that the tests load.",
    )
    group.addoption(
        "--cncsub-cov-fail-under",
        type=_percentage,
        metavar="PERCENT",
        help="Fail below this percentage, and if nothing was measured.",
    )
    group.addoption(
        "--cncsub-cov-skip-covered",
        action="store_true",
        help="Do not list programs that are fully covered.",
    )
    for name, what in _REPORTS.items():
        group.addoption(
            f"--cncsub-cov-{name}", metavar="FILE", help=f"Write the coverage as {what}."
        )


def _percentage(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = -1
    if not 0 <= value <= 100:
        raise ArgumentTypeError(f"it must be a percentage, 0 to 100, not {text!r}")
    return value


def is_wanted(config: pytest.Config) -> bool:
    limit = config.getoption("--cncsub-cov-fail-under")
    skip = config.getoption("--cncsub-cov-skip-covered")
    asked = config.getoption("--cncsub-cov") or any(_reports(config).values())
    return bool(asked) or skip or limit is not None


def _reports(config: pytest.Config) -> dict[str, str | None]:
    """Return the files to write, by their form."""
    return {name: config.getoption(f"--cncsub-cov-{name}") for name in _REPORTS}


class Measuring:
    """Counts the runs of this process. A worker of pytest-xdist sends its counts when it ends; the
    process that started the workers adds them up, reports and keeps the limit.
    """

    def __init__(self, config: pytest.Config) -> None:
        from cncsub.coverage import collecting

        self._config = config
        self._collecting = collecting()
        self._paths = [] if _is_worker(config) else list(_named(config))
        self._files = _read(self._paths)
        self._workers: dict[str, bytes | None] = {}  # what each sent, `None` as long as nothing
        self._faults: list[str] = []
        self._total: Coverage | None = None

    def pytest_sessionstart(self) -> None:
        self._collected = self._collecting.__enter__()

    @pytest.hookimpl(optionalhook=True)
    def pytest_configure_node(self, node: Any) -> None:
        self._workers[node.gateway.id] = None

    @pytest.hookimpl(optionalhook=True)
    def pytest_testnodedown(self, node: Any) -> None:
        self._workers[node.gateway.id] = getattr(node, "workeroutput", {}).get(_SENT)

    @pytest.hookimpl(trylast=True)
    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        self._collecting.__exit__(None, None, None)
        collected = self._collected
        controls = {part.code.control.name: None for part in collected.parts}
        own = collected.total.programs, list(controls), collected.left_out
        if _is_worker(self._config):
            self._config.workeroutput[_SENT] = pickle.dumps(own)  # type: ignore[attr-defined]
            return
        if session.exitstatus == pytest.ExitCode.USAGE_ERROR:
            return
        self._total = self._added_up([own, *self._sent()])
        self._write_reports(self._total)
        from cncsub.coverage.formats import below_limit

        limit = self._config.getoption("--cncsub-cov-fail-under")
        if fault := below_limit(self._total, limit):
            self._faults.append(f"{fault} (--cncsub-cov-fail-under)")
        if self._faults and session.exitstatus == pytest.ExitCode.OK:
            session.exitstatus = pytest.ExitCode.TESTS_FAILED

    def _sent(self) -> Iterator[Any]:
        for name, sent in self._workers.items():
            if sent is None:
                self._faults.append(f"what worker {name} ran is not counted: it ended too early")
            else:
                yield pickle.loads(sent)

    def _added_up(self, parts: Sequence[tuple[Sequence[Counted], list[str], int]]) -> Coverage:
        from cncsub.coverage import Coverage
        from cncsub.coverage.measured import below, without_mdi
        from cncsub.coverage.summary import Merged

        merged = Merged()
        self._left_out = sum(left_out for _, _, left_out in parts)
        for programs, _, _ in parts:
            for program in programs:
                try:
                    merged.add([program])
                except ValueError:
                    self._left_out += 1
        total = without_mdi(Coverage(counted=merged.programs))
        if not self._paths:
            return total
        return self._with_the_rest(
            below(total, self._paths), [name for _, controls, _ in parts for name in controls]
        )

    def _with_the_rest(self, total: Coverage, ran_on: list[str]) -> Coverage:
        """Return the coverage with the programs that no test loaded, as a control reads them: the
        control that is set, else the first that tests ran on.
        """
        from cncsub.coverage.measured import with_the_rest
        from cncsub_pytest.settings import control_named, default_controls

        names = [*default_controls(self._config, self._config.rootpath), *ran_on]
        try:
            if not names:
                raise ValueError("no control is set that could read them; give --control")
            control: cncsub.Control = control_named(names[0], self._config.rootpath)
            assert self._files is not None
            return with_the_rest(total, self._files, control)
        except ValueError as error:
            self._faults.append(f"programs that no test loaded are not counted: {error}")
            return total

    def _write_reports(self, total: Coverage) -> None:
        from cncsub.writing import write_whole

        for name, file in _reports(self._config).items():
            if file is None:
                continue
            text = getattr(total, f"to_{name}")(root=self._config.rootpath)
            try:
                Path(file).parent.mkdir(parents=True, exist_ok=True)
                write_whole(Path(file), text)
            except (OSError, ValueError) as error:
                self._faults.append(f"--cncsub-cov-{name} {file} cannot be written: {error}")

    def pytest_terminal_summary(self, terminalreporter: Any) -> None:
        if self._total is None:
            return
        from cncsub.coverage.formats import coverage_lines

        root = self._config.rootpath
        skip = self._config.getoption("--cncsub-cov-skip-covered")
        terminalreporter.section("coverage of NC programs")
        for line in coverage_lines(self._total, root=root, skip_covered=skip):
            terminalreporter.write_line(line)
        if self._left_out:
            terminalreporter.write_line(
                f"left out: {self._left_out} runs that recorded no blocks, or whose programs"
                " have other"
                " texts under the same names; name= of loads tells them apart"
            )
        for fault in self._faults:
            terminalreporter.write_line(fault, red=True)


def _is_worker(config: pytest.Config) -> bool:
    return hasattr(config, "workerinput")


def _named(config: pytest.Config) -> Iterator[Path]:
    """Yield the files and folders to measure: those of the option, else those of the project."""
    asked = [name for name in config.getoption("--cncsub-cov") if name]
    for name in asked:
        path = config.invocation_params.dir / name
        if path.suffix == ".py" or not path.exists():
            why = "is a file of Python" if path.suffix == ".py" else "does not exist"
            raise _no_programs(f"{name} {why}")
        yield path
    if not asked:
        yield from map(Path, _project(config).folders)


def _read(paths: list[Path]) -> Reading | None:
    from cncsub.files import read_paths

    try:
        return read_paths(paths) if paths else None
    except (OSError, ValueError) as error:
        raise _no_programs(str(error)) from None


def _no_programs(why: str) -> pytest.UsageError:
    return pytest.UsageError(
        f"--cncsub-cov: {why}. Write a folder of NC programs after the equals sign, as"
        " in --cncsub-cov=macros; without a folder write --cncsub-cov= before the names of tests"
    )


def _project(config: pytest.Config) -> Project:
    from cncsub.cli.project import find_project

    try:
        return find_project(config.rootpath)
    except ValueError as error:
        raise pytest.UsageError(str(error)) from None
