"""One library in many threads: every run is the run that one thread alone makes."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

import pytest

import cncsub

THREADS = 16

PROGRAM = """O1
N10 G21 G0 X0 Z5.
N20 M98 P2 L3
N30 G65 P3 A1. B2.
/N40 G1 X5. F200
N50 #101=#101+SIN[#100]
N60 G2 X10. Z-5. R5. F100
WHILE[#103 LT 20]DO1
N70 #103=#103+1
N80 G1 X#103 Z-#103
END1
N90 M98 P9
O2
N210 G1 X[#101/10] Z-1. F150
N220 M99
O3
N310 G66 P4 A#1
N320 G0 X#2
N330 G67
N340 M99
O4
N410 #104=#104+#1
N420 M99
"""


def outcome(run: cncsub.Run) -> tuple[object, ...]:
    """Return the result of a run, as values to compare."""
    return (
        run.stop,
        str(run.alarm),
        dict(run.variables),
        run.position,
        run.modal,
        run.steps.n.tolist(),
        run.moves.mx.tolist(),
        [(call.program, call.arguments) for call in run.calls],
    )


def in_threads(work: Callable[[int], object]) -> list[object]:
    """Return the results of `work` of 0 to 15, all begun at once."""
    together = threading.Barrier(THREADS)

    def begin(number: int) -> object:
        together.wait(30)
        return work(number)

    interval = sys.getswitchinterval()
    sys.setswitchinterval(1e-5)  # threads switch in the middle of things
    try:
        with ThreadPoolExecutor(THREADS) as pool:
            return list(pool.map(begin, range(THREADS)))
    finally:
        sys.setswitchinterval(interval)


def options(number: int) -> dict[str, object]:
    return {
        "variables": {100: number, 101: number / 8},
        "block_skip": number % 2 == 0,
        "max_blocks": 40 + number,
        "setup": {"start": {"X": number}, "work_offsets": {"G54": {"X": -number}}},
    }


def has_commons(library: cncsub.Library) -> bool:
    try:
        return library.machine().variables[100] is None
    except KeyError:
        return False


@pytest.mark.parametrize("control", list(cncsub.controls))
def test_threads_run_one_library_as_one_thread_does(control: str) -> None:
    library = cncsub.loads(PROGRAM, control=control)

    own = {} if has_commons(library) else {"variables": {}}

    def work(number: int) -> object:
        run = library.run(**(options(number) | own))
        return outcome(run), outcome(library.mdi("M98 P2 L2"))

    assert in_threads(work) == [work(number) for number in range(THREADS)]


def test_threads_read_one_run() -> None:
    def fresh() -> cncsub.Run:
        return cncsub.loads(PROGRAM, control="fanuc-0i-f").run()

    expected, shared = outcome(fresh()), fresh()
    assert in_threads(lambda _: outcome(shared)) == [expected] * THREADS


def test_threads_copy_one_machine() -> None:
    machine = cncsub.loads(PROGRAM, control="fanuc-0i-f").machine()
    for _ in range(12):
        machine.step()

    def work(number: int) -> object:
        copy = machine.copy()
        copy.variables[100] = number
        run = copy.run()
        assert run is not None
        return outcome(run)

    assert in_threads(work) == [work(number) for number in range(THREADS)]


def test_threads_load_libraries_and_change_controls() -> None:
    def work(number: int) -> object:
        control = cncsub.controls["fanuc-0i-f"].with_parameters({"6050": 70 + number})
        library = cncsub.loads(f"O1\nG{70 + number} A5.\nM30\nO9010\n#100=#1\nM99\n", control)
        return library.run().variables[100]

    assert in_threads(work) == [5.0] * THREADS
