"""Whatever a caller does with an object or a class of ours, and however the process ends, Python
goes on, or raises. Each claim is tried in a process of its own.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import cncsub

sanitized = "libasan" in os.environ.get("LD_PRELOAD", "")


def ends_well(code: str, folder: Path | None = None, *, timeout: float = 120) -> str:
    done = subprocess.run(
        [sys.executable, "-"], input=code,
        capture_output=True, text=True, timeout=timeout, cwd=folder, check=False,
    )  # fmt: skip
    assert done.returncode == 0, (done.returncode, done.stderr[-3000:])
    return done.stdout


# Every class of the package and of the engine, and objects of each. A class without an object is
# named here, so that a new one is not forgotten.
OBJECTS = """
import abc, collections.abc, copy, gc, inspect, itertools, pickle, pkgutil, typing, importlib
import cncsub
from cncsub import _core

TEXT = "O1 (T)\\nN10 G65 P2 A1. B2.\\nG0 X1. Y2.\\nT1 M6\\n#3006=1(A)\\nM98 P2\\nM98 P9\\nM30\\nO2\\nX3.\\nM99\\n"
library = cncsub.loads(TEXT, control="fanuc-0i-f")
run = library.run()
machine = library.machine()
deep = library.machine()
while not deep.stack: deep.step()
stream = library.stream(rows=3)
part = next(stream)
control = library.control
setup, inputs = cncsub.Setup(tools={1: {"X": 1}}), cncsub.Inputs(signals={1000: 1})
objects = [
    library, run, machine, deep, stream, part, control, setup, inputs, run.alarm, cncsub.AlarmError(run.alarm),
    cncsub.Stop.END, library.main, library.main.blocks, library.main.blocks[0], library.main.blocks[0].words,
    library.main.blocks[0].words[0], run.steps, run.calls, run.moves, run.steps[0], run.calls[0], run.moves[0],
    run.variables, machine.variables, run.alarm.frames, *deep.stack, cncsub.controls, cncsub.causes,
    next(iter(cncsub.causes.values())), *control.rules[:2], *list(control.parameters.values())[:2],
    *list(control.alarms.values())[:2], *control.variable_options.values(), library.external, run.calls.tree(), *run.calls.tree(),
    machine.core, machine.core.trace, machine.core.code, machine.core.code.program(0), _core.read_file(inspect.__file__, 1 << 20), *_core.read_found('', [inspect.__file__], 1 << 20, True),
    _core.flattening(library.machine().core, False), _core.flows(machine.core.code),
    _core.rule_exchange(control, cncsub.controls["mitsubishi-m700"]),
    run.messages, run.position, run.modal,
]
modules = [importlib.import_module(m.name) for m in pkgutil.walk_packages(cncsub.__path__, "cncsub.") if not m.name.endswith("__main__")]
classes = {
    value for module in [cncsub, *modules] for value in vars(module).values()
    if inspect.isclass(value) and value.__module__.startswith("cncsub")
}
classes |= {type(thing) for thing in objects if type(thing).__module__.startswith("cncsub")}
bound = {value for value in vars(_core).values() if inspect.isclass(value)}
assert bound <= classes and len(bound) > 10
shown = {type(thing) for thing in objects}
assert not bound - shown, f"an object of each: {bound - shown}"

def tried(use, *arguments, **named):
    "What a use gives, or the error it raises."
    try:
        return use(*arguments, **named)
    except Exception as error:
        assert str(error) is not None
        return error

def looked_at(thing):
    "Everything that can be asked of an object without arguments."
    for name in dir(type(thing)):
        tried(getattr, thing, name)
    for use in (dir, repr, str, hash, len, bool, list, sorted, iter, copy.copy, copy.deepcopy, vars, memoryview, int):
        tried(use, thing)
    tried(lambda: thing == thing), tried(lambda: thing != 1), tried(lambda: thing < thing), tried(lambda: 1 in thing)
    tried(lambda: thing[0]), tried(lambda: thing["x"]), tried(lambda: thing()), tried(lambda: -thing), tried(lambda: thing + thing)
"""

OBJECT_LAWS = {
    "made without being filled": """
for cls in sorted(classes, key=str):
    for base in (cls, object, *cls.__mro__[1:]):
        empty = tried(base.__new__, cls)
        if not isinstance(empty, Exception):
            assert cls not in bound, (base, cls)
            if "Live" not in str(cls): looked_at(empty)
    if cls in bound:
        assert isinstance(tried(cls), TypeError) and str(tried(cls)), cls
        for base in cls.__mro__:
            made = tried(base)
            assert isinstance(made, TypeError) or type(made) is object
""",
    "pickled, copied and put back": """
for thing in objects:
    for protocol in range(6):
        data = tried(pickle.dumps, thing, protocol)
        if isinstance(data, bytes):
            again = tried(pickle.loads, data)
            assert type(again) is type(thing), (thing, protocol, again)
            looked_at(again)
        for way in (thing.__reduce_ex__, lambda p: object.__reduce_ex__(thing, p)):
            tried(way, protocol)
    tried(thing.__reduce__), tried(object.__reduce__, thing)
for value in (run.alarm, deep.stack[0], control):
    for protocol in range(6):
        again = pickle.loads(pickle.dumps(value, protocol))
        assert repr(again) == repr(value) and (again == value or value is control)
""",
    "filled with rubbish": """
RUBBISH = [(), None, 1, "x", b"x", [], {}, {"x": 1}, (1,), (None,) * 8, ("x",) * 8, (1,) * 13, ("x",) * 13, (-1,) * 13,
           ("overflow",) * 13, ("fanuc-0i-f", {}, {"max_nesting": "x"}), ("fanuc-0i-f", {"6050": []}, {}), (2**99,) * 8, object()]
for thing, value in itertools.product(objects, RUBBISH):
    twin = tried(copy.copy, thing)
    for target in (twin,):
        for name in ("__setstate__", "__init__", "__setattr__", "__delattr__", "__class_getitem__", "__format__", "__eq__"):
            method = getattr(target, name, None)
            if method is not None:
                tried(method, value), tried(method, "x", value), tried(method)
    tried(setattr, twin, "x", value), tried(setattr, twin, "__class__", value), tried(setattr, twin, "__dict__", value)
    looked_at(twin)
for maker in (_core.alarm, _core.frame, _core.control, _core.read_file, _core.read_found, _core.names_in, _core.compile, _core.machine):
    for value in RUBBISH:
        tried(maker, value), tried(maker, value, value), tried(maker, value, value, value), tried(maker)
trace = cncsub.loads(TEXT, control="fanuc-0i-f").run().core.trace
for name in ("step_column", "call_column", "move_columns", "step_row", "call_row", "move_row", "call_arguments"):
    for value in (*RUBBISH, -1, 2**31, 2**63, ["x"], "step", ["step", "x", "x"]):
        tried(getattr(trace, name), value)
for value in (*RUBBISH, int, object, type("Short", (), {"__match_args__": ("step",)}), cncsub.Library):
    tried(trace.step_row, 0, value)
    tried(cncsub.loads(TEXT, control="fanuc-0i-f").machine().core.step, value)
""",
    "inherited from": """
for cls in sorted(classes, key=str):
    made = tried(type(cls), "Sub", (cls,), {"__init__": lambda self, *a, **k: None})
    if isinstance(made, type):
        assert cls not in bound
        for arguments in ((), (1,), (None, None)):
            empty = tried(made, *arguments)
            if not isinstance(empty, Exception): looked_at(empty)
    if cls in bound:
        assert isinstance(made, TypeError), cls
        base = type(cls)("Own", (cls.__base__,), {"__init__": lambda self: None})
        assert isinstance(tried(base), TypeError)
        assert isinstance(tried(base.__new__, base), TypeError)
        own = type(cls)("Own", (cls.__base__,), {"__new__": lambda cls: object.__new__(cls)})
        assert isinstance(tried(own), TypeError)
""",
    "given another class's objects": """
for cls in sorted(classes, key=str):
    for name in dir(cls):
        member = inspect.getattr_static(cls, name)
        if name in ("__subclasses__", "__subclasshook__", "__class__"): continue
        for thing in (*objects, None, cls):
            tried(getattr(member, "__get__", lambda *a: None), thing, type(thing))
            function = tried(getattr, cls, name)
            if cls in bound and callable(function) and name not in ("__init_subclass__",):
                tried(function, thing), tried(function, thing, thing), tried(function)
        for inner in ("__self__", "__func__", "fget"):
            looked_at(getattr(getattr(cls, name, None), inner, None))
""",
}  # fmt: skip


@pytest.mark.parametrize("name", OBJECT_LAWS)
def test_no_object_breaks_when_it_is(name: str) -> None:
    ends_well(OBJECTS + OBJECT_LAWS[name])


# ---- the end of the process ----

PROGRAMS = """
import atexit, os, signal, sys, threading, time
import cncsub
endless = cncsub.loads("O1\\nN10 #100=#100+1\\nN20 GOTO10\\n", control="fanuc-0i-f")
moves = cncsub.loads("O1\\nN10 G91 G1 X1. F100\\nX-1.\\nM98 P2\\nN20 GOTO10\\nO2\\nM99\\n", control="fanuc-0i-f")
alarm = cncsub.loads("O1\\nM98 P2\\nO2\\nG999\\n", control="fanuc-0i-f")
large = "O1\\n" + "N10 G1 X1. Y#1\\n" * 200_000
"""
AT_WORK = {
    "run": "endless.run(max_blocks=2**62, trace='none')",
    "runs of moves": "moves.run(max_blocks=2**62, max_memory=2**28)",
    "load": "cncsub.loads(large, control='fanuc-0i-f')",
    "stream": "[0 for _ in moves.stream(max_blocks=2**62, rows=3000)]",
    "mdi": "endless.mdi('M98 P1', max_blocks=2**62, trace='none')",
    "a long text in mdi": "endless.mdi(large, max_blocks=1)",
    "step": "[0 for _ in endless.machine(max_blocks=2**62)]",
    "columns": "moves.run(max_blocks=100_000).moves.x",
    "alarms": "str(alarm.run().alarm)",
}


@pytest.mark.parametrize("name", AT_WORK)
def test_python_ends_while_a_daemon_is_at_work_in(name: str) -> None:
    for wait in (0, 0.003, 0.02, 0.05, 0.1, 0.2):
        ends_well(
            f"{PROGRAMS}\ndef work():\n    while True: {AT_WORK[name]}\n"
            "for _ in range(2): threading.Thread(target=work, daemon=True).start()\n"
            f"time.sleep({wait})\n"
        )


def test_whatever_is_called_when_python_ends_still_runs() -> None:
    said = ends_well(
        f"""{PROGRAMS}
machine = alarm.machine()
def last():
    assert machine.run().alarm.cause == "g-code-not-available"
    thread_runs = endless.run(max_blocks=100_000).stop
    print("ran", thread_runs)
atexit.register(last)
threading.Thread(target=lambda: endless.run(max_blocks=2**62), daemon=True).start()
class Late:
    def __del__(self):
        alarm.run()
late = Late()
"""
    )
    assert said == "ran limit\n"


@pytest.mark.skipif(
    sanitized, reason="the locks of the sanitizers do not survive a fork beside threads"
)
@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork here")
def test_a_fork_while_other_threads_are_at_work_leaves_a_child_that_works() -> None:
    said = ends_well(
        f"""{PROGRAMS}
import warnings
warnings.simplefilter("ignore")
def work():
    while True: moves.run(max_blocks=20_000), cncsub.loads(large[:200_000], control="gsk-988ta")
for _ in range(2): threading.Thread(target=work, daemon=True).start()
well = 0
for _ in range(20):
    child = os.fork()
    if child == 0:
        signal.alarm(20)
        run = moves.run(max_blocks=50_000)
        cncsub.loads("O1\\nM30\\n", control="hnc-21m").run()
        os._exit(0 if len(run.moves) > 100 else 1)
    well += os.waitpid(child, 0)[1] == 0
print(well)
"""
    )
    assert said == "20\n"


@pytest.mark.parametrize("isolated", [True, False])
def test_a_second_interpreter_is_refused(isolated: bool) -> None:
    said = ends_well(
        f"""
try:
    import _interpreters as interpreters
except ImportError:
    import _xxsubinterpreters as interpreters
before = {isolated}
if before:
    import cncsub
try:
    second = interpreters.create("isolated" if {isolated} else "legacy")
except (TypeError, ValueError):
    second = interpreters.create(isolated={isolated})
text = '''
try:
    import cncsub._core
except ImportError as error:
    print(error, flush=True)
'''
run = getattr(interpreters, "run_string", None) or interpreters.exec
run(second, text)
interpreters.destroy(second)
import cncsub
assert "hnc-21m" in cncsub.controls
""",
        timeout=60,
    )
    assert "interpreter" in said


# ---- no memory ----

SHORT = """
import resource, sys
def pages():
    with open("/proc/self/statm") as file: return int(file.read().split()[0]) * resource.getpagesize()
"""
HUNGRY = {
    "import": "import cncsub",
    "load": "import cncsub; limit(); cncsub.loads('O1\\n' + 'N10 G1 X1. Y#1 (A)\\n' * 60_000, control='fanuc-0i-f')",
    "programs": "import cncsub; limit(); len(cncsub.loads('O1\\nO2\\nO3\\n' * 20_000, control='fanuc-0i-f'))",
    "run": "import cncsub; lib = cncsub.loads('O1\\nN10 G91 X1.\\nM98 P2\\n#3006=1(A)\\nGOTO10\\nO2\\nM99\\n', control='fanuc-0i-f'); limit(); run = lib.run(max_blocks=300_000); repr(run)",
    "columns": "import cncsub, numpy; run = cncsub.loads('O1\\nN10 G91 X1.\\nGOTO10\\n', control='fanuc-0i-f').run(max_blocks=200_000); limit(); run.moves.x, run.steps.n, run.moves.time, run.moves.bounds",
    "a machine": "import cncsub; lib = cncsub.loads('O1\\nN10 G91 X1.\\nGOTO10\\n', control='fanuc-0i-f'); limit(); m = lib.machine(max_blocks=2**62); [m.step() and m.copy() for _ in range(20_000)]; m.variables; m.position",
    "an alarm": "import cncsub; lib = cncsub.loads('O1\\nM98 P2\\nO2\\n' + 'X1.' * 300_000 + 'G999', control='fanuc-0i-f'); limit(); [str(lib.run().alarm) for _ in range(9)]; lib.mdi('G999').alarm",
}


@pytest.mark.skipif(
    sanitized or not sys.platform.startswith("linux"), reason="address space is limited here"
)
@pytest.mark.parametrize("name", HUNGRY)
def test_without_memory_python_raises_in(name: str) -> None:
    work = HUNGRY[name] if "limit()" in HUNGRY[name] else f"limit(); {HUNGRY[name]}"
    for room in [*range(0, 2 << 20, 200 << 10), *(mega << 20 for mega in (3, 5, 8, 13, 21, 34))]:
        code = (
            f"{SHORT}def limit(): resource.setrlimit(resource.RLIMIT_AS, (pages() + {room},) * 2)\n"
        )
        done = subprocess.run(
            [sys.executable, "-"], input=code + work, capture_output=True, text=True, timeout=60, check=False,
        )  # fmt: skip
        said = done.stderr[-1500:]
        assert done.returncode in (0, 1), (room, done.returncode, said)
        # A module that cannot be loaded for want of memory is an ImportError, or a SystemError of
        # Python.
        assert (
            done.returncode == 0
            or "MemoryError" in said
            or "ImportError" in said
            or "SystemError" in said
            or "OSError" in said
        ), (room, said)


def test_a_column_that_is_asked_for_twice_is_made_once() -> None:
    text = "O1\nG1 F1\nN1 X1.\nX2.\nGOTO1\n"
    run = cncsub.loads(text, control="fanuc-0i-f").run(max_blocks=100_000)
    columns = run.moves.core.move_columns(["time", "x", "time", "kind", "x", "kind"])
    assert list(columns) == ["time", "x", "kind"]
    assert all(np.array_equal(columns[name], run.moves.column(name)) for name in columns)
