"""Ctrl-C soon stops reading, running and stepping, and leaves Python and what ran whole."""

from __future__ import annotations

import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path

import pytest

import cncsub

SOON = 2.0  # seconds; on an idle machine it is a twentieth of one
ENDLESS = "O1\\nN10 #100=#100+1\\nN20 GOTO10\\n"
HEAVY = "O1\\nZ5.\\nN10 G91 G81 X1. Z-1. R1. F100 K20000\\nN20 GOTO10\\n"
START = f"""
import sys, cncsub
def endless(text="{ENDLESS}"):
    return cncsub.loads(text, control="fanuc-0i-f")
def go():
    print("go", flush=True)
"""
LIMITS = "max_blocks=2**62, trace='none'"

RUNS = {
    "run": f"lib = endless(); go(); run = lib.run({LIMITS}); assert run.variables[100] > 0",
    "mdi": f"lib = endless(); go(); run = lib.mdi('M98 P1', {LIMITS})",
    "machine.run": "m = endless().machine(max_blocks=2**62); go(); run = m.run()",
    "moves": f"lib = endless('{HEAVY}'); go(); run = lib.run(max_blocks=2**62, trace='none')",
}


def interrupted(code: str, *, after: float) -> tuple[str, float]:
    """Return what a program prints when Ctrl-C is pressed while it runs, and how long that took."""
    child = subprocess.Popen(
        [sys.executable, "-c", START + code], stdout=subprocess.PIPE, text=True
    )
    assert child.stdout is not None
    try:
        assert child.stdout.readline() == "go\n"
        time.sleep(after)
        pressed = time.monotonic()
        child.send_signal(signal.SIGINT)
        said = child.stdout.readline().strip()
        took = time.monotonic() - pressed
        assert child.wait(timeout=30) == 0
    finally:
        child.kill()
        child.stdout.close()
    return said, took


@pytest.mark.parametrize("name", RUNS)
def test_a_run_stops_and_shows_the_part_that_ran(name: str) -> None:
    code = f"""
{RUNS[name]}
print(run.stop, flush=True)
assert run.stop is cncsub.Stop.INTERRUPTED and run.alarm is None
repr(run), run.position, run.modal, dict(run.variables)
"""
    said, took = interrupted(code, after=0.3)
    assert said == "interrupted"
    assert took < SOON


def test_a_machine_that_is_iterated_keeps_its_steps_and_goes_on() -> None:
    code = """
m = endless().machine(max_blocks=2**62)
count = 0
try:
    go()
    for step in m:
        count += 1
except KeyboardInterrupt:
    print("raised", flush=True)
assert m.stop is None
assert count <= len(m.steps) <= count + 1
assert m.step().n in (10, 20)
"""
    said, took = interrupted(code, after=0.3)
    assert said == "raised"
    assert took < SOON


def test_an_interrupted_machine_can_be_run_on() -> None:
    code = """
m = endless().machine(max_blocks=2**62, trace="blocks")
go()
assert m.run().stop is cncsub.Stop.INTERRUPTED
print("stopped", flush=True)
before = len(m.steps)
n = m.steps[-1].n
copy = m.copy()
assert m.run(until=("O1", 10 if n == 10 else 20)) is None
assert len(m.steps) > before and len(copy.steps) == before
"""
    assert interrupted(code, after=0.2)[0] == "stopped"


@pytest.mark.parametrize("after", [0.05, 0.4, 1.0, 2.0])
def test_reading_a_large_file_is_given_up(tmp_path: Path, after: float) -> None:
    file = tmp_path / "large.nc"
    block = "".join(f"N{n} G1 X{n}.5 Y{n % 7}.25 (\u5de5) F100\n" for n in range(1, 9999))
    with file.open("w", encoding="utf-8") as out:
        out.write("O1\n")
        for _ in range(400):  # 120 MB
            out.write(block)
    code = f"""
try:
    go()
    while True:
        cncsub.load({str(file)!r}, control="fanuc-0i-f")
except KeyboardInterrupt:
    print("raised", flush=True)
assert len(cncsub.loads("N1 M30", control="fanuc-0i-f")) == 1
"""
    said, took = interrupted(code, after=after)
    assert said == "raised"
    assert took < SOON


def test_reading_a_long_text_or_many_files_is_given_up(tmp_path: Path) -> None:
    for number in range(3000):
        (tmp_path / f"O{number + 1}.nc").write_text("N10 X1.\nN20 M99\n" * 50)
    reads = [
        f"cncsub.load({str(tmp_path)!r}, control='gsk-988ta')",
        "cncsub.loads('O1\\n' + 'N10 #1=#1+1\\n' * 3_000_000, control='fanuc-0i-f')",
        "cncsub.loads(b'O1\\n' + b'(\\xb9\\xa4)X1\\n' * 3_000_000, control='fanuc-0i-f')",
    ]
    for read in reads:
        code = f"""
try:
    go()
    while True:
        {read}
except KeyboardInterrupt:
    print("raised", flush=True)
"""
        said, took = interrupted(code, after=0.5)
        assert said == "raised"
        assert took < SOON


@pytest.mark.parametrize("look", ["check()", "call_graph()", "flow('O1')"])
def test_a_look_at_programs_that_all_call_each_other_is_given_up(look: str) -> None:
    code = f"""
import time
text = "".join(
    f"O{{i}}\\n" + "".join(f"M98 P{{j}}\\n#{{100 + j % 50}}=#{{1 + j % 30}}\\n" for j in range(1, 501)) + "M99\\n"
    for i in range(1, 501)
)
lib = cncsub.loads(text, control="fanuc-0i-f")
try:
    go()
    while True:
        lib.{look}
except KeyboardInterrupt:
    print("raised", flush=True)
"""
    said, took = interrupted(code, after=0.4)
    assert said == "raised"
    assert took < SOON


def test_the_command_line_ends_without_a_traceback(tmp_path: Path) -> None:
    file = tmp_path / "O1.nc"
    file.write_text("N10 #100=#100+1\nN20 GOTO10\n")
    command = [sys.executable, "-c", "from cncsub.cli import main; main()", "run", str(file)]
    child = subprocess.Popen(
        [*command, "-c", "fanuc-0i-f", "--max-blocks", str(2**62)],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
    )  # fmt: skip
    time.sleep(1.5)
    child.send_signal(signal.SIGINT)
    out, err = child.communicate(timeout=30)
    assert child.returncode == 130
    assert "Traceback" not in out + err


HOLES = "O1\nN5 G0 Z5.\nN10 G91 G81 X1. Z-1. R-1. F100 K240000\nN20 G80\nN30 M30\n"


CUTS = "N20 G0 X1.\n" + "G1 X1. W-.01\n" * 80_000 + "N30 G1 X900. F1\n"
ROUGH = f"O1\nN5 G0 X900. Z1.\nG71 U.36 R.1\nN10 G71 P20 Q30 U0 W0 F1\n{CUTS}N40 M30\n"


def test_a_contour_of_very_many_blocks_is_broken_off() -> None:
    control = cncsub.controls["gsk-988ta"].replace(max_profile_blocks=0)
    machine = cncsub.loads(ROUGH, control=control).machine(trace="none")
    machine.run(until=("O1", 10))
    old = signal.signal(signal.SIGALRM, signal.default_int_handler)
    try:
        for after in (0.01, 0.05, 0.1):  # the block takes half a second
            signal.setitimer(signal.ITIMER_REAL, after)
            begun = time.monotonic()
            run = machine.run()
            assert run is not None
            assert run.stop is cncsub.Stop.INTERRUPTED
            assert time.monotonic() - begun < after + SOON
            assert (machine.blocks, machine.position["X"]) == (2, 900)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, old)


@pytest.mark.parametrize("trace", ["none", "moves"])
def test_a_block_of_very_many_moves_is_broken_off(trace: str) -> None:
    library = cncsub.loads(HOLES, control="fanuc-0i-f")
    setup = cncsub.Setup(limits={"X": (-1, 999_999)})  # every move is checked against them
    machine = library.machine(trace=trace, setup=setup)
    machine.step()
    old = signal.signal(signal.SIGALRM, signal.default_int_handler)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.01)  # the block takes several times as long
        run = machine.run()
        assert run is not None
        assert run.stop is cncsub.Stop.INTERRUPTED
        # The block did nothing, and is executed as a whole when the run goes on.
        assert (machine.blocks, machine.position["X"], machine.alarm) == (1, 0, None)
        signal.setitimer(signal.ITIMER_REAL, 0.01)
        with pytest.raises(KeyboardInterrupt):
            machine.step()
        assert (machine.stop, machine.blocks, machine.position["X"]) == (None, 1, 0)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, old)
    run = machine.run()
    assert run is not None
    assert run.stop is cncsub.Stop.END
    assert (machine.blocks, machine.position["X"]) == (4, 240_000)
    whole = library.run(setup=setup)
    assert run.moves.total_time == whole.moves.total_time
    if trace == "moves":
        assert len(run.moves) == len(whole.moves)


def test_reading_a_long_text_of_mdi_is_given_up() -> None:
    code = """
lib = endless()
text = "G91 G1 X1. Y#1 F100\\n" * 3_000_000
try:
    go()
    while True:
        lib.mdi(text, max_blocks=1)
except KeyboardInterrupt:
    print("raised", flush=True)
"""
    said, took = interrupted(code, after=0.3)
    assert said == "raised"
    assert took < SOON


@pytest.mark.parametrize("what", ["cncsub.loads(text, control='fanuc-0i-f')", "block.words"])
@pytest.mark.parametrize("word", ["X1", "X[1]", "A1.", "/2"])
def test_one_long_line_is_given_up(word: str, what: str) -> None:
    code = f"""
text = "{word}" * 5_000_000
block = cncsub.loads(text, control="fanuc-0i-f").main.blocks[0]
try:
    go()
    while True:
        {what}
except KeyboardInterrupt:
    print("raised", flush=True)
"""
    said, took = interrupted(code, after=0.5)
    assert said == "raised"
    assert took < SOON


class Rang(Exception):  # noqa: N818
    pass


def test_what_another_signal_raises_goes_on_to_the_caller() -> None:
    def ring(*_: object) -> None:
        raise Rang

    old = signal.signal(signal.SIGALRM, ring)
    try:
        machine = cncsub.loads("O1\nN10 GOTO10\n", control="fanuc-0i-f").machine(
            max_blocks=2**62, trace="none"
        )
        signal.setitimer(signal.ITIMER_REAL, 0.2)
        with pytest.raises(Rang):
            machine.run()
        assert machine.stop is cncsub.Stop.INTERRUPTED
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, old)


# Accesses that go over all rows of a table.
LOOKS: dict[str, Callable[[cncsub.Run], object]] = {
    "columns of the moves": lambda run: run.moves._fetch(["time", "length", "mx"]),
    "axes that few moves name": lambda run: [run.moves._fetch(["c"]) for _ in range(20)],
    "whole numbers": lambda run: run.moves._fetch(["kind", "tool", "plane", "d", "h"]),
    "columns of the steps": lambda run: run.steps._fetch(["line", "n", "depth"] * 5),
    "columns of the calls": lambda run: run.calls._fetch(["kind", "level", "repeats"] * 20),
    "bounds": lambda run: run.moves.bounds,
    "length": lambda run: [run.core.trace.path_length for _ in range(20)],
    "messages": lambda run: run.core.trace.messages,
}


@pytest.fixture(scope="module")
def long_run() -> cncsub.Run:
    text = "O1\nG1 F1 C9.\nN1 M8\nDPRNT[A]\nG2 X1. I1.\nX2. I1.\nM98 P2\nGOTO1\nO2\nM99\n"
    return cncsub.loads(text, control="fanuc-0i-f").run(max_blocks=4_000_000)


@pytest.mark.parametrize("name", LOOKS)
def test_a_look_at_very_many_rows_is_given_up(name: str, long_run: cncsub.Run) -> None:
    def ring(*_: object) -> None:
        raise Rang

    look = LOOKS[name]
    look(long_run)  # so that NumPy is imported before the clock runs
    begun = time.monotonic()
    look(long_run)
    whole = time.monotonic() - begun
    old = signal.signal(signal.SIGALRM, ring)
    try:
        begun = time.monotonic()
        signal.setitimer(signal.ITIMER_REAL, whole / 10)
        with pytest.raises(Rang):
            look(long_run)
        assert time.monotonic() - begun < 0.6 * whole + 0.05
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, old)


def test_other_threads_go_on_while_a_program_runs() -> None:
    library = cncsub.loads("O1\nN10 GOTO10\n", control="fanuc-0i-f")
    runs: list[cncsub.Run] = []
    thread = threading.Thread(
        target=lambda: runs.append(library.run(max_seconds=0.5, max_blocks=2**62, trace="none"))
    )
    thread.start()
    looks = 0
    while thread.is_alive():
        time.sleep(0.01)
        looks += 1
    thread.join()
    assert runs[0].stop is cncsub.Stop.LIMIT
    assert looks > 5
