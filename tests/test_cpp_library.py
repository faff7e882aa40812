"""The engine as a library for C++ and C: installed from this build, used from outside."""

from __future__ import annotations

import ctypes
import functools
import os
import re
import shutil
import sys
import textwrap
from collections.abc import Iterator
from pathlib import Path

import pytest
from commands import call, done

import cncsub
import conformance

ROOT = Path(__file__).resolve().parent.parent
INCLUDE = ROOT / "cpp" / "library" / "include" / "cncsub"
PAGE = ROOT / "docs" / "engine-in-your-program.md"
ALARMING = "O1\nN10 #100=1\nN20 G65 P2 A3\nN30 G1 X#100 F100\nN40 M30\nO2\nN50 #100=#1*2\nN60 #3000=1(BAD)\nM99\n"
MOVING = "O1\nN10 G90 G54 G0 X0 Y0 Z5.\nN20 G1 X10. Y5.5 F200.\nN30 G2 X20. Y5.5 I5. J0\nN40 M30\n"


def builds() -> Iterator[Path]:
    """Yield the folders in which this engine was built for the module that is tested, newest first."""
    caches = ROOT.glob("build/*/CMakeCache.txt")
    for cache in sorted(caches, key=lambda file: file.stat().st_mtime, reverse=True):
        told = dict(
            line.split("=", 1)
            for line in cache.read_text().splitlines()
            if "=" in line and ":" in line
        )
        plain = not told.get("CNCSUB_SANITIZE:STRING")
        if plain and cache.with_name("libcncsub_engine.a").exists():
            yield cache.parent


@pytest.fixture(scope="module")
def build() -> Path:
    found = next(builds(), None)
    if found is None or shutil.which("cmake") is None:
        pytest.skip("no folder with a built engine, from which the library could be linked")
    return found


@pytest.fixture(scope="module")
def installed(build: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder into which the library was installed, and nothing else."""
    prefix = tmp_path_factory.mktemp("installed")
    done("cmake", "--build", build, "--target", "library")
    done("cmake", "--install", build, "--component", "library", "--prefix", prefix)
    return prefix


@pytest.fixture(scope="module")
def examples(installed: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with the examples, built in an empty folder by what the page says."""
    folder = tmp_path_factory.mktemp("examples")
    source = shutil.copytree(ROOT / "examples" / "cpp", folder / "source")
    done("cmake", "-S", source, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={installed}")
    done("cmake", "--build", folder / "build")
    return folder / "build"


@functools.cache
def library_of(folder: Path) -> ctypes.CDLL:
    found = next(path for path in folder.rglob("libcncsub.*") if path.suffix in (".so", ".dylib"))
    return ctypes.CDLL(str(found))


# ---- C++ ----


def test_what_is_installed(installed: Path) -> None:
    files = {str(path.relative_to(installed)) for path in installed.rglob("*") if path.is_file()}
    lib = "lib" if (installed / "lib" / "libcncsub.a").exists() else "lib64"
    expected = {
        "include/cncsub/cncsub.h",
        "include/cncsub/cncsub.hpp",
        "include/cncsub/comparison.hpp",
        "include/cncsub/recorded.hpp",
        f"{lib}/libcncsub.a",
        f"{lib}/libcncsub.so",
        f"{lib}/pkgconfig/cncsub.pc",
        f"{lib}/cmake/cncsub/cncsubConfig.cmake",
        f"{lib}/cmake/cncsub/cncsubConfigVersion.cmake",
        f"{lib}/cmake/cncsub/cncsub.cmake",
    }
    assert expected <= files
    assert not [file for file in files - expected if "libcncsub.so" not in file and "-" not in file]


def test_the_example_shows_the_alarm_of_the_command_line(examples: Path, tmp_path: Path) -> None:
    file = tmp_path / "job.nc"
    file.write_text(ALARMING)
    ran = call(examples / "run_files", "fanuc-0i-f", file)
    assert ran.returncode == 1
    shown = call(sys.executable, "-m", "cncsub", "run", file, "-c", "fanuc-0i-f").stdout
    first = shown.index("MC3001")
    alarm = shown[first : shown.index("cure:")]
    assert alarm in ran.stdout
    assert "cure: see the program's message" in ran.stdout


def test_the_example_steps_from_a_breakpoint(examples: Path, tmp_path: Path) -> None:
    file = tmp_path / "job.nc"
    file.write_text(ALARMING)
    ran = call(examples / "single_step", "fanuc-0i-f", file, "O2", 50, 100)
    assert ran.stdout.splitlines() == [
        "before N50 #100=#1*2, after 2 blocks",
        "  called by G65 in O1",
        "O2: N50 #100=#1*2   #100 = 0.006000",
        "O2: N60 #3000=1(BAD)",
        "alarm",
    ]
    wrong = call(examples / "single_step", "fanuc-0i-f", file, "O2", 51, 100)
    assert (wrong.returncode, wrong.stderr) == (2, "there is no block N51 in O2\n")


def test_the_example_fills_buffers_with_the_moves_of_python(examples: Path, tmp_path: Path) -> None:
    file = tmp_path / "job.nc"
    file.write_text(MOVING)
    ran = done(examples / "moves", "fanuc-0i-f", file).splitlines()
    assert ran == ["3 moves, 2 of them cut", "100 to 120", "50 to 55.5", "-195 to -195"]


def test_pkg_config_is_enough(installed: Path, tmp_path: Path) -> None:
    if shutil.which("pkg-config") is None or shutil.which("c++") is None:
        pytest.skip("no pkg-config or no c++")
    pc = next(installed.rglob("cncsub.pc")).parent
    environment = {**os.environ, "PKG_CONFIG_PATH": str(pc)}
    assert (
        done("pkg-config", "--modversion", "cncsub", env=environment).strip() == cncsub.__version__
    )
    flags = done("pkg-config", "--cflags", "--libs", "cncsub", env=environment).split()
    source = ROOT / "examples" / "cpp" / "run_files.cpp"
    done("c++", "-std=c++20", source, *flags, f"-Wl,-rpath,{pc.parent}", "-o", tmp_path / "run")
    ran = done(tmp_path / "run", "gsk-988ta", ROOT / "examples/gsk/988ta-nested-self-call.nc")
    assert ran.startswith("end, after 20 blocks")


def test_the_snippets_of_the_page_compile_and_run(installed: Path, tmp_path: Path) -> None:
    text = PAGE.read_text(encoding="utf-8")
    snippets = re.findall(r"```(cpp|c)\n(.*?)```\n+```text\n(.*?)```", text, re.DOTALL)
    assert len(snippets) >= 2
    library = next(installed.rglob("libcncsub.a"))
    for number, (language, source, printed) in enumerate(snippets):
        compiler = ("c++", "-std=c++20") if language == "cpp" else ("cc", "-std=c11")
        file = tmp_path / f"snippet{number}.{language}"
        file.write_text(source)
        include = f"-I{installed / 'include'}"
        warnings = ("-Wall", "-Wextra", "-Wpedantic", "-Werror")
        done(*compiler, *warnings, include, "-c", file, "-o", f"{file}.o")
        done("c++", f"{file}.o", library, "-pthread", "-o", tmp_path / "snippet")
        assert done(tmp_path / "snippet") == printed


def test_the_public_header_is_short() -> None:
    assert len((INCLUDE / "cncsub.hpp").read_text().splitlines()) <= 300
    assert len(functions()) <= 70


# ---- C ----


def functions() -> list[str]:
    """Return the functions of the C face, in the order of its header."""
    text = (INCLUDE / "cncsub.h").read_text()
    return re.findall(r"^CNCSUB_C [^;(]*?(\w+)\(", text, re.MULTILINE)


class Place(ctypes.Structure):
    _fields_ = [
        ("program", ctypes.c_char_p),
        ("file", ctypes.c_char_p),
        ("n", ctypes.c_int64),
        ("line", ctypes.c_uint32),
    ]


class Alarm(ctypes.Structure):
    _fields_ = [
        *((name, ctypes.c_char_p) for name in ("number", "cause", "text", "shown", "cure")),
        ("at", Place),
        ("column", ctypes.c_uint32),
    ]


class Call(ctypes.Structure):
    _fields_ = [
        ("at", Place),
        ("kind", ctypes.c_char_p),
        ("called", ctypes.c_char_p),
        ("repeat", ctypes.c_int64),
        ("repeats", ctypes.c_int64),
    ]


class Finding(ctypes.Structure):
    _fields_ = [
        *((name, ctypes.c_char_p) for name in ("rule", "severity", "message")),
        ("at", Place),
        ("column", ctypes.c_uint32),
    ]


class StepRow(ctypes.Structure):
    _fields_ = [
        ("at", Place),
        ("text", ctypes.c_char_p),
        ("depth", ctypes.c_int32),
        ("skipped", ctypes.c_int32),
    ]


CALL_STEPS = ("parent", "start_n", "repeats", "caller_step", "first_step", "last_step")


class CallMade(ctypes.Structure):
    _fields_ = [
        ("kind", ctypes.c_char_p),
        ("called", ctypes.c_char_p),
        *((name, ctypes.c_int64) for name in CALL_STEPS),
    ]


class Variable(ctypes.Structure):
    _fields_ = [
        ("number", ctypes.c_int64),
        ("name", ctypes.c_char_p),
        ("value", ctypes.c_double),
        ("text", ctypes.c_char_p),
    ]


class Rule(ctypes.Structure):
    _fields_ = [
        ("name", ctypes.c_char_p),
        ("meaning", ctypes.c_char_p),
        ("values", ctypes.c_char_p * 2),
        ("examples", ctypes.c_char_p * 2),
    ]


NUMBERS = ("x", "y", "z", "mx", "my", "mz", "cx", "cy", "cz", "feed", "length", "time")


class Columns(ctypes.Structure):
    _fields_ = [
        *((name, ctypes.POINTER(ctypes.c_double)) for name in NUMBERS),
        ("kind", ctypes.POINTER(ctypes.c_int32)),
        ("step", ctypes.POINTER(ctypes.c_int64)),
    ]


STRUCTS = {
    "cncsub_place": Place,
    "cncsub_alarm": Alarm,
    "cncsub_call": Call,
    "cncsub_finding": Finding,
    "cncsub_columns": Columns,
    "cncsub_step": StepRow,
    "cncsub_call_made": CallMade,
    "cncsub_variable": Variable,
    "cncsub_rule": Rule,
}


def face(folder: Path) -> ctypes.CDLL:
    """Return the C face with the types that are not int."""
    c = library_of(folder)
    texts = ["version", "error", "control", "library_program", "run_stop", "machine_stop"]
    texts += ["control_title", "library_hint", "run_message", "run_waiting_for", "comparison_what"]
    texts += ["run_alarm_word"]
    handles = ["library_new", "options_new", "library_run", "library_machine", "machine_so_far"]
    handles += ["library_for", "compare", "comparison_run"]
    doubles = ["run_variable", "machine_variable", "machine_position", "run_length", "run_time"]
    for names, type_ in (
        (texts, ctypes.c_char_p),
        (handles, ctypes.c_void_p),
        (doubles, ctypes.c_double),
    ):
        for name in names:
            getattr(c, f"cncsub_{name}").restype = type_
    sizes = ("run_moves", "library_check", "run_steps", "run_calls", "run_path", "run_variables")
    for name in sizes:
        getattr(c, f"cncsub_{name}").restype = ctypes.c_size_t
    c.cncsub_run_blocks.restype = c.cncsub_comparison_step.restype = ctypes.c_int64
    return c


def read(c: ctypes.CDLL, control: str, *texts: str) -> ctypes.c_void_p | None:
    bytes_ = [text.encode() for text in texts]
    names = (ctypes.c_char_p * len(texts))(*(f"file{i}.nc".encode() for i in range(len(texts))))
    data = (ctypes.c_char_p * len(texts))(*bytes_)
    sizes = (ctypes.c_size_t * len(texts))(*map(len, bytes_))
    handle = c.cncsub_library_new(control.encode(), ctypes.c_size_t(len(texts)), names, data, sizes)
    return ctypes.c_void_p(handle) if handle else None


def test_every_function_of_the_header_is_exported_and_nothing_else_of_c(installed: Path) -> None:
    if shutil.which("nm") is None:
        pytest.skip("no nm")
    shared = next(path for path in installed.rglob("libcncsub.so"))
    listed = done("nm", "-D", "--defined-only", shared)
    exported = {line.split()[-1] for line in listed.splitlines() if " T cncsub_" in line}
    assert exported == set(functions())


def test_the_structs_are_laid_out_as_every_compiler_of_c_lays_them_out(
    installed: Path, tmp_path: Path
) -> None:
    lines = [
        f'printf("{name} %zu", sizeof({name}));'
        + "".join(f'printf(" %zu", offsetof({name}, {field[0]}));' for field in struct._fields_)
        + 'printf("\\n");'
        for name, struct in STRUCTS.items()
    ]
    file = tmp_path / "layout.c"
    file.write_text(
        "#include <cncsub/cncsub.h>\n#include <stdio.h>\nint main(void) {"
        + "\n".join(lines)
        + "}\n"
    )
    flags = ("-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", f"-I{installed / 'include'}")
    done("cc", *flags, file, "-o", tmp_path / "layout")
    told = {
        name: list(map(int, rest))
        for name, *rest in map(str.split, done(tmp_path / "layout").splitlines())
    }
    for name, struct in STRUCTS.items():
        offsets = [getattr(struct, field[0]).offset for field in struct._fields_]
        assert told[name] == [ctypes.sizeof(struct), *offsets]


def declared() -> list[str]:
    """Return what the header declares: each function, each struct with its fields, each constant."""
    text = re.sub(r"/\*.*?\*/", "", (INCLUDE / "cncsub.h").read_text(), flags=re.DOTALL)
    text = " ".join(re.sub(r"^#.*$", "", text, flags=re.MULTILINE).split())
    structs = re.findall(r"typedef struct \w+ {[^}]*} \w+;", text)
    functions = re.findall(r"CNCSUB_C ([^;]*;)", text)
    return [re.sub(r" ?([*(){},;\[\]]) ?", r"\1", one) for one in [*structs, *functions]]


def test_what_abi_1_has_is_there_as_it_was() -> None:
    """A function or a struct that was published never changes. A new one is recorded with the
    others: by a line of its own in the file, which only grows.
    """
    recorded = (INCLUDE.parent.parent / "abi_1.txt").read_text().splitlines()
    now = declared()
    assert [line for line in recorded if line not in now] == [], "was published otherwise"
    assert [line for line in now if line not in recorded] == [], "is not recorded"
    assert "#define CNCSUB_ABI 1\n" in (INCLUDE / "cncsub.h").read_text()


@pytest.mark.parametrize(
    ("compiler", "language"), [("cc", "c99"), ("cc", "c11"), ("c++", "c++11"), ("c++", "c++20")]
)
def test_the_c_header_is_c_and_cpp(compiler: str, language: str, tmp_path: Path) -> None:
    """The page's program in C, which is C++ too but for nothing."""
    if shutil.which(compiler) is None:
        pytest.skip(f"no {compiler}")
    snippet = re.search(r"```c\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    assert snippet is not None
    file = tmp_path / ("program.c" if compiler == "cc" else "program.cpp")
    file.write_text(snippet[1])
    flags = ("-Wall", "-Wextra", "-Wpedantic", "-Werror", f"-I{INCLUDE.parent}")
    done(compiler, f"-std={language}", *flags, "-fsyntax-only", file)


def test_a_vacant_variable_is_no_error(installed: Path) -> None:
    c = face(installed)
    run = ctypes.c_void_p(c.cncsub_library_run(read(c, "fanuc-0i-f", MOVING), None))
    for number, refused in ((999_999, True), (100, False), (999_999, True)):
        value = c.cncsub_run_variable(run, ctypes.c_int64(number))
        assert value != value
        assert bool(c.cncsub_error()) == refused
    c.cncsub_run_free(run)


def test_a_run_through_c_is_the_run_of_python(installed: Path) -> None:
    c = face(installed)
    assert c.cncsub_version().decode() == cncsub.__version__
    assert c.cncsub_abi() == 1
    names = []
    while (name := c.cncsub_control(ctypes.c_size_t(len(names)))) is not None:
        names.append(name.decode())
    assert names == list(cncsub.controls)
    library = read(c, "fanuc-0i-f", MOVING)
    assert c.cncsub_library_program(library, ctypes.c_size_t(0)) == b"O1"
    options = ctypes.c_void_p(c.cncsub_options_new())
    assert c.cncsub_options_work_offset(options, b"G54", ctypes.c_char(b"X"), ctypes.c_double(7.5))
    run = ctypes.c_void_p(c.cncsub_library_run(library, options))
    setup = cncsub.Setup(work_offsets={"G54": {"X": 7.5}})
    same = cncsub.loads(MOVING, control="fanuc-0i-f").run(setup=setup)
    count = c.cncsub_run_moves(run)
    assert count == len(same.moves)
    columns = Columns()
    room = {name: (ctypes.c_double * count)() for name in NUMBERS}
    for name, array in room.items():
        setattr(columns, name, ctypes.cast(array, ctypes.POINTER(ctypes.c_double)))
    assert c.cncsub_run_write_moves(run, ctypes.byref(columns))
    for name, array in room.items():
        expected = getattr(same.moves, name)
        assert list(array) == pytest.approx(list(expected), nan_ok=True), name
    assert (c.cncsub_run_stop(run), c.cncsub_run_blocks(run)) == (b"end", 4)
    for free, handle in (("run", run), ("options", options), ("library", library)):
        getattr(c, f"cncsub_{free}_free")(handle)


def test_a_library_has_the_programs_and_the_main_program_of_python(installed: Path) -> None:
    c = face(installed)
    text = "%_N_PART_SPF\nR1=R1+1\nM17\n%_N_SHAFT_MPF\nPART\nPART\nM30\n"
    library, same = read(c, "siemens-one", text), cncsub.loads(text, control="siemens-one")
    names = []
    while (name := c.cncsub_library_program(library, ctypes.c_size_t(len(names)))) is not None:
        names.append(name.decode())
    assert names == list(same)  # none of the control's own
    run = ctypes.c_void_p(c.cncsub_library_run(library, None))
    assert c.cncsub_run_variable(run, ctypes.c_int64(1)) == same.run().variables[1] == 2
    assert c.cncsub_library_check(library) == len(same.check())


@pytest.mark.parametrize(
    ("control", "system"),
    [("siemens-one", "G501"), ("fanuc-0i-f", "G505")]
    + [("fanuc-0i-f", name) for name in ("G54.1 P01", "G54.1 P301", "G54.1P1", "G60", "")],
)
def test_an_offset_of_no_system_is_refused(installed: Path, control: str, system: str) -> None:
    c = face(installed)
    library, options = read(c, control, MOVING), ctypes.c_void_p(c.cncsub_options_new())
    axis, value = ctypes.c_char(b"X"), ctypes.c_double(7.5)
    assert c.cncsub_options_work_offset(options, system.encode(), axis, value)
    assert not c.cncsub_library_run(library, options)
    assert c.cncsub_error().decode() == f"{control} has no work offset {system}"


def test_an_alarm_through_c(installed: Path) -> None:
    c = face(installed)
    library = read(c, "fanuc-0i-f", ALARMING)
    run = ctypes.c_void_p(c.cncsub_library_run(library, None))
    alarm, caller = Alarm(), Call()
    assert c.cncsub_run_alarm(run, ctypes.byref(alarm)) == 1
    assert (alarm.number, alarm.cause, alarm.at.program, alarm.at.n) == (
        b"MC3001",
        b"user-alarm",
        b"O2",
        60,
    )
    assert c.cncsub_run_alarm_word(run) == b"#3000=1(BAD)"
    assert c.cncsub_run_alarm_call(run, ctypes.c_size_t(0), ctypes.byref(caller)) == 1
    assert (caller.kind, caller.called, caller.at.n) == (b"G65", b"O2", 20)
    assert c.cncsub_run_alarm_call(run, ctypes.c_size_t(1), ctypes.byref(caller)) == 0
    assert c.cncsub_run_variable(run, ctypes.c_int64(100)) == 0.006
    count = c.cncsub_library_check(library)
    finding = Finding()
    found = []
    for index in range(count):
        assert c.cncsub_library_finding(library, ctypes.c_size_t(index), ctypes.byref(finding))
        found.append(finding.rule.decode())
    assert sorted(found) == sorted(
        f.rule for f in cncsub.loads(ALARMING, control="fanuc-0i-f").check()
    )
    c.cncsub_run_free(run)
    c.cncsub_library_free(library)


def rows(next_: object, handle: object, row: type[ctypes.Structure]) -> list[ctypes.Structure]:
    """Return structs by their index, until there is none."""
    found, made = [], row()
    while next_(handle, ctypes.c_size_t(len(found)), ctypes.byref(made)):
        found.append(type(made).from_buffer_copy(made))
    return found


def test_blocks_calls_and_path_through_c_are_those_of_python(installed: Path) -> None:
    c = face(installed)
    run = ctypes.c_void_p(c.cncsub_library_run(read(c, "fanuc-0i-f", ALARMING), None))
    same = cncsub.loads(ALARMING, control="fanuc-0i-f").run()
    assert c.cncsub_run_steps(run) == len(same.steps)
    made = c.cncsub_run_step(run, ctypes.c_size_t(2), ctypes.byref(row := StepRow()))
    assert (made, row.at.program, row.at.n, row.text, row.depth) == (
        1,
        b"O2",
        50,
        b"N50 #100=#1*2",
        1,
    )
    made = c.cncsub_run_call(run, ctypes.c_size_t(0), ctypes.byref(call_row := CallMade()))
    assert (made, call_row.kind, call_row.called, call_row.parent) == (1, b"G65", b"O2", -1)
    assert (call_row.caller_step, call_row.first_step) == (1, 2)
    moving = ctypes.c_void_p(c.cncsub_library_run(read(c, "fanuc-0i-f", MOVING), None))
    count = c.cncsub_run_path(moving, ctypes.c_double(0.01))
    x, y = (ctypes.c_double * count)(), (ctypes.c_double * count)()
    assert c.cncsub_run_write_path(moving, x, y, None, None, None)
    assert ([x[0], y[0], x[count - 1]], count > 5) == ([0, 0, 20], True)
    assert (
        c.cncsub_run_length(moving)
        == cncsub.loads(MOVING, control="fanuc-0i-f").run().moves.total_length
    )


def test_variables_with_numbers_and_names_through_c(installed: Path) -> None:
    c = face(installed)
    text = 'DEF INT SIDES[2]=SET(3,4)\nDEF STRING[8] NAME="A"<<SIDES[1]\nR5=2.5\nM30\n'
    run = ctypes.c_void_p(c.cncsub_library_run(read(c, "siemens-one", text), None))
    c.cncsub_run_variables(run)
    found = [
        (row.number, row.name, row.text) for row in rows(c.cncsub_run_variable_at, run, Variable)
    ]
    assert (5, b"", b"2.5") in found
    assert found[-3:] == [(-1, b"SIDES[0]", b"3"), (-1, b"SIDES[1]", b"4"), (-1, b"NAME", b"A4")]


def test_rules_and_parameters_are_changed_through_c_as_in_python(installed: Path) -> None:
    c = face(installed)
    library = read(c, "fanuc-0i-f", ALARMING)
    changed = c.cncsub_library_for(library, b"fanuc-0i-f", b"max_nesting=0\n\n 6050 = 70")
    run = ctypes.c_void_p(c.cncsub_library_run(ctypes.c_void_p(changed), None))
    alarm = Alarm()
    assert c.cncsub_run_alarm(run, ctypes.byref(alarm))
    control = cncsub.controls["fanuc-0i-f"].replace(max_nesting=0)
    assert alarm.cause.decode() == cncsub.loads(ALARMING, control=control).run().alarm.cause
    for lines, why in (
        (b"max_nestin=1", b"there is no rule max_nestin; the nearest are max_nesting"),
        (b"max_nesting=deep", b"max_nesting must be a whole number, not deep"),
        (b"6050=x", b"parameter 6050 must be a number, not x"),
        (b"zero_repeats=never", b"zero_repeats must be one of once, skip, alarm"),
    ):
        assert not c.cncsub_library_for(library, b"fanuc-0i-f", lines)
        assert why in c.cncsub_error()


EXAMPLES = sorted((ROOT / "examples").glob("*/*.nc"))


@pytest.mark.parametrize("file", EXAMPLES, ids=lambda file: file.stem)
def test_a_comparison_through_c_is_that_of_python(installed: Path, file: Path) -> None:
    c = face(installed)
    text = file.read_text(encoding="utf-8")
    pairs = (
        ("fanuc-0i-f", "mitsubishi-m700"),
        ("gsk-988ta", "fanuc-0i-f"),
        ("fanuc-30i", "haas-ngc"),
    )
    for one, other in pairs:
        first = read(c, one, text)
        second = ctypes.c_void_p(c.cncsub_library_for(first, other.encode(), None))
        options = ctypes.c_void_p(c.cncsub_options_new())
        assert c.cncsub_options_number(options, b"max_blocks", ctypes.c_double(5000))
        compared = ctypes.c_void_p(c.cncsub_compare(first, second, options))
        same = cncsub.compare(
            cncsub.loads({"file0.nc": text}, control=one), controls=[one, other], max_blocks=5000
        )
        what = c.cncsub_comparison_what(compared).decode()
        assert what == ("" if same.same else same.what), (one, other)
        found = [row.name.decode() for row in rows(c.cncsub_comparison_rule, compared, Rule)]
        assert found == [*same.rules, *same.parameters], (one, other)
        c.cncsub_comparison_free(compared)


ROWS = [row for row in conformance.rows()[::97] if isinstance(row.case.program, str)]


def test_comparisons_of_rows_through_c_are_those_of_python(installed: Path) -> None:
    """The same law over programs of the conformance tables, on the control of a row and another."""
    c = face(installed)
    apart = []
    others = list(cncsub.controls)
    for number, row in enumerate(ROWS):
        text, one = textwrap.dedent(row.case.program).strip() + "\n", row.control
        other = others[number % len(others)]
        first = read(c, one, text)
        second = ctypes.c_void_p(c.cncsub_library_for(first, other.encode(), None))
        options = ctypes.c_void_p(c.cncsub_options_new())
        c.cncsub_options_number(options, b"max_blocks", ctypes.c_double(2000))
        compared = ctypes.c_void_p(c.cncsub_compare(first, second, options))
        library = cncsub.loads({"file0.nc": text}, control=one)
        same = cncsub.compare(library, controls=[one, other], max_blocks=2000)
        told = c.cncsub_comparison_what(compared).decode() if compared else c.cncsub_error()
        found = [row.name.decode() for row in rows(c.cncsub_comparison_rule, compared, Rule)]
        if (told, found) != ("" if same.same else same.what, [*same.rules, *same.parameters]):
            apart.append((row.case.claim, one, other, told, same.what, found, same.rules))
        for free, handle in (("comparison", compared), ("options", options)):
            getattr(c, f"cncsub_{free}_free")(handle)
    assert not apart, apart[:3]


def test_what_cannot_be_is_refused_with_a_reason(installed: Path) -> None:
    c = face(installed)
    assert read(c, "fanuc-99", MOVING) is None
    assert c.cncsub_error() == (
        b"there is no control fanuc-99; did you mean fanuc-16i, fanuc-30i, fanuc-31i?"
    )
    library = read(c, "fanuc-0i-f", ALARMING)
    options = ctypes.c_void_p(c.cncsub_options_new())
    assert not c.cncsub_options_number(options, b"speed", ctypes.c_double(1))
    assert c.cncsub_options_text(options, b"main", b"O7")
    assert not c.cncsub_library_run(library, options)
    assert c.cncsub_error() == b"there is no program O7"
    machine = ctypes.c_void_p(c.cncsub_library_machine(library, None))
    assert not c.cncsub_machine_run_to(machine, b"O2", ctypes.c_int64(51))
    assert c.cncsub_error() == b"there is no block N51 in O2"
    assert not c.cncsub_machine_set_variable(machine, ctypes.c_int64(0), ctypes.c_double(1))
    value = c.cncsub_machine_variable(machine, ctypes.c_int64(999_999))
    assert value != value
    assert c.cncsub_machine_run_to(machine, b"O2", ctypes.c_int64(50))
    assert c.cncsub_machine_step(machine)
    assert c.cncsub_machine_variable(machine, ctypes.c_int64(100)) == 0.006
    for free, handle in (("machine", machine), ("options", options), ("library", library)):
        getattr(c, f"cncsub_{free}_free")(handle)


def test_null_is_refused_everywhere(installed: Path) -> None:
    c = face(installed)
    header = (INCLUDE / "cncsub.h").read_text()
    for name in functions():
        signature = re.search(rf"{name}\(([^)]*)\)", header)
        assert signature is not None
        if name.endswith("_free") or "*" not in signature[1]:
            continue
        given = [
            None if "*" in parameter else ctypes.c_double(1) if "double" in parameter else 1
            for parameter in signature[1].split(",")
        ]
        getattr(c, name)(*given)
        assert b"NULL" in c.cncsub_error(), name


def test_what_is_no_file_is_no_program(examples: Path, tmp_path: Path) -> None:
    ran = call(examples / "run_files", "fanuc-0i-f", tmp_path)
    assert (ran.returncode, ran.stderr) == (2, f"{tmp_path} cannot be read\n")


ODD = [
    *(b"", b"\x00", b"%", b"O", b"(" * 5000, b"N" * 5000, bytes(range(256)) * 20, b"\xff\xfe\x00O"),
    b"O1\nN10 GOTO10\n",
    b"O1\nM98 P1\n",
    b"O1\nG1 X#1 F[" + b"[" * 3000,
    b"O1\nX99999999999999999999999.\nM30\n",
    "O1(äöü 深さ 🙂)\nN10 #3000=1(\u202e)\n".encode(),
]


@pytest.mark.parametrize("control", list(cncsub.controls))
def test_odd_input_has_a_defined_outcome(installed: Path, control: str) -> None:
    """Whatever is given, each function answers, and indices after the last one are refused."""
    c = face(installed)
    for text in ODD:
        names, data = (ctypes.c_char_p * 1)(b"\xff<odd>"), (ctypes.c_char_p * 1)(text)
        size = (ctypes.c_size_t * 1)(len(text))
        library = ctypes.c_void_p(
            c.cncsub_library_new(control.encode(), ctypes.c_size_t(1), names, data, size)
        )
        assert library, c.cncsub_error()
        c.cncsub_library_check(library)
        far = ctypes.c_size_t(2**64 - 1)
        assert not c.cncsub_library_finding(library, far, ctypes.byref(Finding()))
        options = ctypes.c_void_p(c.cncsub_options_new())
        c.cncsub_options_number(options, b"max_blocks", ctypes.c_double(500))
        for value in (float("nan"), float("inf"), -1e308):
            for name in (b"start", b"max_seconds", b"block_skip", b"record", b"max_cycles"):
                wrong = ctypes.c_void_p(c.cncsub_options_new())
                c.cncsub_options_number(wrong, name, ctypes.c_double(value))
                c.cncsub_options_length_offset(wrong, -1, ctypes.c_double(value))
                c.cncsub_options_start_position(wrong, ctypes.c_char(b"?"), ctypes.c_double(value))
                assert not c.cncsub_library_run(library, wrong)  # "?" is no axis
                c.cncsub_options_free(wrong)
        run = ctypes.c_void_p(c.cncsub_library_run(library, options))
        if run:
            assert c.cncsub_run_stop(run) in (b"end", b"alarm", b"limit", b"cycles", b"waiting")
            c.cncsub_run_alarm(run, ctypes.byref(Alarm()))
            assert not c.cncsub_run_step(run, far, ctypes.byref(StepRow()))
            assert not c.cncsub_run_call(run, far, ctypes.byref(CallMade()))
            assert not c.cncsub_run_alarm_call(run, far, ctypes.byref(Call()))
            assert not c.cncsub_run_variable_at(run, far, ctypes.byref(Variable()))
            for tolerance in (float("nan"), -1.0, 0.0, 1e308):
                c.cncsub_run_path(run, ctypes.c_double(tolerance))
            value = c.cncsub_run_variable(run, ctypes.c_int64(-(2**63)))
            assert value != value
            c.cncsub_run_free(run)
        for free, handle in (("options", options), ("library", library)):
            getattr(c, f"cncsub_{free}_free")(handle)
