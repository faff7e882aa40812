"""Each allocation of a piece of work fails in turn: Python raises MemoryError, nothing is freed
twice.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

sanitized = "libasan" in os.environ.get("LD_PRELOAD", "")
COMPILER = os.environ.get("CXX") or shutil.which("c++")
ISO = r"O1\nN10 G91 G1 X#1 F1.\nG65 P2 A1.\n#3006=1(A)\nG81 Z-1. R1.\nM98 P2\nM30\nO2\nM99\n"
WORK = {
    "loads and run": f"lib = cncsub.loads('{ISO}', control='fanuc-0i-f'); run = lib.run(); str(run); list(run.steps); run.moves.x",
    "linuxcnc": r"run = cncsub.loads('o1 sub\nG1 F1 X#1\no1 endsub\no1 call [3]\n#<a>=5\nG0 X#<a>\nM2\n', control='linuxcnc').run(); str(run); run.moves.x",
    "siemens": r"run = cncsub.loads('%_N_A_MPF\nDEF REAL A=3\nG1 F1 X=A\nIF A>2\nMSG(\"A\")\nENDIF\nM30\n', control='siemens-one').run(); str(run); run.moves.x",
    "an alarm": "lib = cncsub.loads('O1\\nM98 P7\\n', control='fanuc-0i-f'); str(lib.run().alarm); lib.mdi('G999')",
    "a machine": f"machine = cncsub.loads('{ISO}', control='fanuc-0i-f').machine(); machine.step(); machine.copy().step(); machine.step(); machine.variables; machine.position; machine.moves.x",
    "a control": "cncsub.controls['fanuc-0i-f'].with_parameters({'6050': 900}).replace(max_words=30); pickle.loads(pickle.dumps(cncsub.controls['gsk-928te']))",
    "columns": "run = cncsub.loads('O1\\nN10 G91 X1.\\nGOTO10\\n', control='fanuc-0i-f').run(max_blocks=20_000); run.moves.x, run.steps.n, run.moves.time, run.moves.bounds",
}
EACH = """
import ctypes, os, pickle, sys, cncsub
news = ctypes.CDLL({library!r})
work = compile({work!r}, "work", "exec")
def do(): exec(work, {{"cncsub": cncsub, "pickle": pickle}})
do()
before = news.news_so_far(); do(); count = news.news_so_far() - before
assert count > 0, "what is counted is not what allocates"
for n in range(0, count, max(1, count // 1500)):
    child = os.fork()
    if not child:
        news.fail_after(n)
        raised = 0
        try: do()
        except MemoryError: pass
        except BaseException as error:
            print(type(error), error, file=sys.stderr)
            raised = 3
        news.fail_after(-1)
        sys.stderr.flush()
        os._exit(raised)
    _, status = os.waitpid(child, 0)
    if status: print("allocation", n, "of", count, "ended with", status)
"""


@pytest.fixture(scope="session")
def failing_new(tmp_path_factory: pytest.TempPathFactory) -> Path:
    library = tmp_path_factory.mktemp("memory") / "failing_new.so"
    source = Path(__file__).with_name("failing_new.cpp")
    subprocess.run(
        [str(COMPILER), "-std=c++20", "-shared", "-fPIC", source, "-o", library], check=True
    )
    return library


@pytest.mark.skipif(
    sanitized or not sys.platform.startswith("linux") or not COMPILER,
    reason="`new` is replaced here, by what a compiler makes",
)
@pytest.mark.parametrize("name", WORK)
def test_no_allocation_that_fails_does_harm(name: str, failing_new: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-c", EACH.format(library=str(failing_new), work=WORK[name])],
        env={**os.environ, "LD_PRELOAD": str(failing_new)},
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
