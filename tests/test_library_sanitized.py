"""The C++ library and the C face under the sanitizers: the examples, and a program that calls every function of the header
rightly and wrongly.

`.ci/run` and `.ci/nightly` give CNCSUB_SANITIZED, the folder in which the engine was built with the address and the
undefined-behaviour sanitizer. Nothing here loads Python's module, so leaks are found too.
"""

from __future__ import annotations

import os
import re
import shlex
from pathlib import Path

import pytest
from commands import call, done

ROOT = Path(__file__).resolve().parent.parent
FACE = ROOT / "tests" / "library" / "every_function.c"
HEADER = ROOT / "cpp" / "library" / "include" / "cncsub" / "cncsub.h"
SANITIZE = ("-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-g1", "-O1")
CONTROL = "fanuc-0i-f"
JOB = (
    "O1\nN10 #100=1\nN20 G65 P2 A3\nN30 M30\nO2\nN40 G0 X#1\nN50 #100=#1*2\nN60 #3000=1(BAD)\nM99\n"
)


def test_the_program_calls_every_function() -> None:
    named = set(re.findall(r"\bcncsub_\w+(?=\()", FACE.read_text()))
    declared = re.findall(r"^CNCSUB_C [^;(]*?(\w+)\(", HEADER.read_text(), re.MULTILINE)
    assert set(declared) <= named


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder into which the library was installed from the build under the sanitizers."""
    build = os.environ.get("CNCSUB_SANITIZED")
    if not build:
        pytest.skip("CNCSUB_SANITIZED names no build under the sanitizers")
    prefix = tmp_path_factory.mktemp("installed")
    done("cmake", "--build", build, "--target", "library")
    done("cmake", "--install", build, "--component", "library", "--prefix", prefix)
    return prefix


def built(installed: Path, source: Path, to: Path) -> Path:
    """Compile a program, and link it with the static library."""
    include = f"-I{installed / 'include'}"
    compiler = (
        ("gcc", "-std=c11", "-Wall", "-Wextra") if source.suffix == ".c" else ("g++", "-std=c++20")
    )
    done(*compiler, *SANITIZE, include, "-c", source, "-o", f"{to}.o")
    library = next(installed.rglob("libcncsub.a"))
    done("g++", *SANITIZE, f"{to}.o", library, "-pthread", "-o", to)
    return to


def run(*command: object) -> tuple[int, str]:
    environment = {
        **os.environ,
        "LD_PRELOAD": "",
        "ASAN_OPTIONS": "detect_leaks=1:allocator_may_return_null=1",
        "UBSAN_OPTIONS": "print_stacktrace=1",
    }
    ran = call(*command, env=environment)
    return ran.returncode, ran.stderr


def test_every_function_of_the_c_face(installed: Path, tmp_path: Path) -> None:
    assert run(built(installed, FACE, tmp_path / "face")) == (0, "")


@pytest.mark.parametrize(
    ("example", "arguments", "status"),
    [
        ("run_files", "", 1),
        ("single_step", "O2 50 100", 1),
        ("moves", "", 1),
    ],
)
def test_the_examples(
    installed: Path, tmp_path: Path, example: str, arguments: str, status: int
) -> None:
    program = built(installed, ROOT / "examples" / "cpp" / f"{example}.cpp", tmp_path / example)
    job = tmp_path / "job.nc"
    job.write_text(JOB)
    code, told = run(program, CONTROL, job, *shlex.split(arguments))
    assert (code, "Sanitizer" in told, "runtime error" in told) == (status, False, False), told
    for wrong in ((), ("no-control", job), (CONTROL, tmp_path), (CONTROL, job, "", "x", "y")):
        code, told = run(program, *wrong)
        assert code in (0, 1, 2), told
        assert "Sanitizer" not in told, told
