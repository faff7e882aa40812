"""Change the engine in one small place at a time, and look whether a row notices.

    python tests/mutants --count 300 --seed 1
    python tests/mutants --count 50 cpp/cncsub/code/target.cpp

A mutant is one comparison, number, enumerator, condition or statement of a C++ source changed. Only
its file is built again, and the rows of the conformance tables run until one fails: then the mutant
is killed. If no row fails, the mutant survived: either it means the same, or a row is missing. The
build tree stands outside the repository. The line and column that are printed select a place again.
"""

from __future__ import annotations

import argparse
import contextlib
import os
import random
import resource
import select
import signal
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from places import Mutant, mutants_of
from workshop import ENGINE, ROOT, Workshop

CONFORMANCE = ROOT / "tests" / "conformance"
SOURCES = ("code/c*", "dialect/iso/*", "motion/**/*", "machine/*")
MEMORY = 4 << 30  # for a process that runs rows
PASSED = "passed"
STOPPED = "no end"
CRASHED = "crashed"
NOT_COMPILED = "not compiled"


class Rows:
    """The rows, read once; every mutant runs them in a process of its own."""

    def __init__(self, package: Path, seconds: float) -> None:
        sys.path[:0] = [str(package), str(CONFORMANCE)]
        from conformance import rows

        self.rows = rows()
        self.order = list(range(len(self.rows)))
        self.seconds = seconds

    def first_failing(self) -> str:
        """Return the row that fails first, or `PASSED`, `STOPPED`, `CRASHED`."""
        reader, writer = os.pipe()
        child = os.fork()
        if child == 0:
            os.close(reader)
            self._run(writer)
        os.close(writer)
        answer = self._answer(reader)
        os.close(reader)
        if answer is None:
            os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        if answer is None:
            return STOPPED
        if not answer:
            return CRASHED
        failed = int(answer)
        if failed < 0:
            return PASSED
        # The row that has just found something is likely to find the next mutant.
        self.order.remove(failed)
        self.order.insert(0, failed)
        return str(self.rows[failed])

    def _answer(self, reader: int) -> bytes | None:
        ready, _, _ = select.select([reader], [], [], self.seconds)
        return os.read(reader, 100) if ready else None

    def _run(self, writer: int) -> None:
        """Run in the child: whatever happens there, it ends here and cleans up nothing."""
        try:
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            os.write(writer, str(self._search()).encode())
        finally:
            os._exit(0)

    def _search(self) -> int:
        """Return the place of the first row that fails, -1 if none does."""
        import cncsub
        from cncsub.testing.outcome import differences

        for place in self.order:
            row = self.rows[place]
            try:
                passed = next(differences(row.case, cncsub.controls[row.control]), None) is None
            except BaseException:  # a mutant may break anything
                passed = False
            if not passed:
                return place
        return -1


def chosen(sources: list[Path], count: int, seed: int) -> Iterator[tuple[Path, Mutant, str]]:
    """Yield a sample over all sources, in an order that the seed gives: file, mutant and changed
    text.
    """
    texts = {file: file.read_text() for file in sources}
    everything = [
        (file, mutant)
        for file, text in texts.items()
        for mutant in mutants_of(str(file.relative_to(ROOT)), text)
    ]
    random.Random(seed).shuffle(everything)
    print(f"{len(everything)} places in {len(sources)} files; {count} are tried", flush=True)
    yield from ((file, mutant, mutant.applied(texts[file])) for file, mutant in everything)


def try_mutants(workshop: Workshop, rows: Rows, options: argparse.Namespace) -> Counter[str]:
    outcomes: Counter[str] = Counter()
    for file, mutant, changed in chosen(options.sources, options.count, options.seed):
        if options.at and f"{mutant.file}:{mutant.line}:{mutant.column}" not in options.at:
            continue
        if outcomes.total() - outcomes[NOT_COMPILED] >= options.count:
            break
        if not workshop.build(file, changed):
            outcomes[NOT_COMPILED] += 1
            continue
        found = rows.first_failing()
        outcome = {PASSED: "survived", STOPPED: STOPPED}.get(found, "killed")
        outcomes[outcome] += 1
        print(f"{outcome:<8} {mutant}", flush=True)
        if outcome == "killed" and options.verbose:
            print(f"         {found}", flush=True)
    return outcomes


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("sources", nargs="*", type=Path, help="C++ files, else the control rules")
    parser.add_argument("--count", type=int, default=100, help="how many mutants are tried")
    parser.add_argument("--seed", type=int, default=1, help="which sample")
    parser.add_argument("--at", action="append", metavar="FILE:LINE:COLUMN", help="only these")
    parser.add_argument("--build", type=Path, help="a folder to keep the build tree in")
    parser.add_argument("--flags", default="-O1", help="how the compiler optimizes")
    parser.add_argument("--seconds", type=float, default=120, help="for the rows of one mutant")
    parser.add_argument("--verbose", action="store_true", help="name the row that noticed")
    options = parser.parse_args()
    options.sources = [file.resolve() for file in options.sources] or [
        file for name in SOURCES for file in sorted(ENGINE.glob(f"{name}.cpp"))
    ]
    with contextlib.ExitStack() as stack:
        folder = options.build or Path(stack.enter_context(tempfile.TemporaryDirectory()))
        folder = folder.resolve()
        if folder.is_relative_to(ROOT):
            sys.exit("the build tree has to stand outside the repository")
        workshop = Workshop(folder, options.flags)
        workshop.prepare()
        rows = Rows(workshop.package, options.seconds)
        start = time.monotonic()
        found = rows.first_failing()
        if found != PASSED:
            sys.exit(f"the unchanged engine fails already: {found}")
        print(f"{len(rows.rows)} rows pass in {time.monotonic() - start:.1f} s", flush=True)
        outcomes = try_mutants(workshop, rows, options)
    print(", ".join(f"{count} {outcome}" for outcome, count in sorted(outcomes.items())))
    return 1 if outcomes["survived"] else 0


if __name__ == "__main__":
    sys.exit(main())
