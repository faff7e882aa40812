"""The cost of a check grows in proportion to the programs, not to their square."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

import cncsub

MILL = "fanuc-0i-f"


def all_call_all(n: int) -> str:
    calls = "".join(f"M98 P{i}\n" for i in range(1, n + 1))
    return "".join(f"O{i}\n{calls}M99\n" for i in range(1, n + 1))


def a_chain(n: int) -> str:
    return "".join(f"O{i}\nG91 #{100 + i % 90}=1\nM98 P{i + 1}\nM99\n" for i in range(1, n))


def a_ring(n: int) -> str:
    return "".join(
        f"O{i}\n#{100 + i % 90}=1\nG0 X#{100 + i % 90}\nM98 P{i % n + 1}\nG91 X1.\nM99\n"
        for i in range(1, n + 1)
    )


def many_parts(n: int) -> str:
    calls = "".join(f"M97 P{i}\n" for i in range(1, n))
    return (
        f"O1\n{calls}"
        + "".join(f"N{i} G0 X1.\nIF[#1 EQ 1]GOTO 9999\n" for i in range(1, n))
        + "N9999 M99\n"
    )


def many_returns(n: int) -> str:
    calls = "".join(f"N{i} M98 P2\n" for i in range(1, n))
    return (
        f"O1\n{calls}M30\nO2\n"
        + "".join(f"IF[#1 EQ {i}]THEN M99 P{i}\n" for i in range(1, n))
        + "M99\n"
    )


def many_profiles(n: int) -> str:
    return (
        "O1\n"
        + "".join(f"G71 P1 Q{n - i} U1. W0.\n" for i in range(n - 2))
        + "".join(f"N{i} G1 X{i}.\n" for i in range(1, n + 1))
        + "M30\n"
    )


def many_variables(n: int) -> str:
    names = "".join(f"#<_v{i}>=1\n#<_w{i}>=#<_v{i}>\n" for i in range(n))
    return f"o1 sub\n{names}o1 endsub\n{names}o1 call\n{names}m2\n"


def many_labels(n: int) -> str:
    subs = "".join(f"o{i} sub\ng91 g0 x1\no{i} endsub\n" for i in range(1, n))
    return subs + "".join(f"o{i} call\n" for i in range(1, n)) + "m2\n"


def many_jumps(n: int) -> str:
    return "O1\n" + "".join(f"N{i} GOTO#{100 + i % 90}\n" for i in range(1, n)) + "M30\n"


def many_loops(n: int) -> str:
    return "O1\n" + "".join(f"N{i} WHILE[#1 LT 3]DO{i % 3 + 1}\n" for i in range(1, n)) + "M30\n"


def one_line(n: int) -> str:
    return "O1\n" + "M98 P9;X1;Y2;M3 M4;" * n + "M30\n"


KINDS: dict[str, tuple[str, Callable[[int], str], int]] = {
    "all call all": (MILL, all_call_all, 150),
    "a chain": (MILL, a_chain, 2000),
    "a ring": (MILL, a_ring, 2000),
    "parts of a program": ("haas-ngc", many_parts, 3000),
    "returns to numbers": (MILL, many_returns, 3000),
    "profiles inside each other": ("gsk-988ta", many_profiles, 3000),
    "names of all programs": ("linuxcnc", many_variables, 500),
    "labels": ("linuxcnc", many_labels, 4000),
    "computed jumps": (MILL, many_jumps, 5000),
    "loops without an end": (MILL, many_loops, 5000),
    "one line": (MILL, one_line, 3000),
}


@pytest.mark.parametrize("kind", KINDS)
def test_twice_as_much_costs_no_more_than_a_few_times_as_much(kind: str) -> None:
    control, text, size = KINDS[kind]

    def cost(n: int) -> float:
        library = cncsub.loads(text(n), control=control)
        best = 1e9
        for _ in range(2):
            begun = time.process_time()
            library.check()
            best = min(best, time.process_time() - begun)
        return best

    squared = 16 if kind == "all call all" else 4  # there calls are the square of the programs
    assert cost(4 * size) < 3.2 * squared * max(cost(size), 0.01)


def test_a_look_at_each_of_many_programs_or_names_is_no_look_at_all_of_them() -> None:
    def cost(look: Callable[[int], object], n: int) -> float:
        begun = time.process_time()
        look(n)
        return time.process_time() - begun

    def flows(n: int) -> None:
        library = cncsub.loads(a_chain(n), control=MILL)
        assert all(library.flow(name).returns for name in library)

    def names(n: int) -> None:
        text = "".join(f"#<_v{i}>=1\n#<_w{i}>=#<_v{i}>\n" for i in range(n)) + "m2\n"
        library = cncsub.loads(text, control="linuxcnc")
        library.check()
        assert library.main is not None
        assert all(block.writes for block in list(library.main.blocks)[:-1])

    for look, size in ((flows, 1500), (names, 4000)):
        assert cost(look, 4 * size) < 12 * max(cost(look, size), 0.01)


def test_programs_that_all_call_each_other_are_one_circle() -> None:
    findings = cncsub.loads(all_call_all(60), control=MILL).check(rules=["CS402"])
    (circle,) = findings
    assert circle.count == 60 * 61 // 2
    assert len(circle.places) == 1000
    assert len(circle.path) < 100


@pytest.mark.skipif(
    "asan" in os.environ.get("LD_PRELOAD", ""), reason="the sanitizer keeps what was given back"
)
@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="Linux tells the peak there")
def test_a_million_calls_are_read_and_checked_in_300_megabytes(tmp_path: Path) -> None:
    calls = "".join(f"M98 P{i}\n" for i in range(1, 1001))
    for i in range(1, 1001):
        (tmp_path / f"O{i:04}.nc").write_text(f"O{i}\n{calls}M99\n")
    code = (
        "import os, pathlib, sys, cncsub\n"
        # How two threads share the reading makes the peak differ from run to run.
        "os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})\n"
        f"cncsub.load(sys.argv[1], control={MILL!r}).check()\n"
        "print(pathlib.Path('/proc/self/status').read_text())"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, str(tmp_path)], capture_output=True, text=True, check=True
    )
    (kilobytes,) = re.findall(r"VmHWM:\s+(\d+) kB", done.stdout)
    assert int(kilobytes) < 300 * 1024


def test_the_names_of_a_long_circle_are_told_in_part() -> None:
    ring = "".join(f"O{i}\nM98 P{i % 500 + 1}\nM99\n" for i in range(1, 501))
    (circle,) = cncsub.loads(ring, control=MILL).check(rules=["CS402"])
    assert circle.message.startswith("O1 > O2 > O3 > O4 > O5 > O6 > ... 488 more ... > O495")
    assert circle.message.endswith("O500 > O1")
