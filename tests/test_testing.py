"""cncsub.testing and its plugin, as a project of NC programs uses them."""

from __future__ import annotations

import inspect
import json
import re
import tomllib
from decimal import Decimal
from importlib.metadata import entry_points
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given

import cncsub
from cncsub.testing import case, cases, check_case, load_table
from cncsub.testing.strategies import arguments, call_words
from cncsub.testing.table_keys import KEYS, check_keys, schema

pytest_plugins = ["pytester"]

SQUARE = "O1\nN10 G65 P2 A3.\nN20 M30\nO2\nN30 #100=#1*#1\nN40 M99\n"


def square(**said: Any) -> Any:
    return case("a square", control="fanuc-0i-f", program=SQUARE, **said)


def test_a_case_that_holds_and_one_that_does_not() -> None:
    check_case(square(runs="N10 N30 N40 N20", vars={100: 9}))
    with pytest.raises(AssertionError) as failed:
        check_case(square(runs="N10 N30 N20", vars={100: 8}))
    told = str(failed.value)
    for words in (
        "control fanuc-0i-f", "N30 #100=#1*#1", "vars #100: expected 8, got 9",
        "they differ from place 3 of 3", "executed: O1:N10 O2:N30 O2:N40 O1:N20", "variables at the stop: #100=9",
    ):  # fmt: skip
        assert words in told
    with pytest.raises(AssertionError, match="the alarm:\n    PS0076"):
        check_case(case("ends", control="fanuc-0i-f", program="O1\nN10 M98 P9\n", m=[]))
    check_case(square(vars={100: 9}), "mitsubishi-m800")


def test_a_failure_names_the_block_the_calls_and_the_last_write() -> None:
    with pytest.raises(AssertionError) as failed:
        check_case(square(runs="N10 N30 N20", vars={100: 8}))
    told = str(failed.value)
    assert (
        "as expected up to: O2 N30, line 5: N30 #100=#1*#1\n"
        "      called from O1 N10, line 2 (G65 O2)\nthen ran: O2 N40, line 6: N40 M99\n"
    ) in told
    assert "#100 was last written by O2 N30, line 5: N30 #100=#1*#1" in told
    assert "the last block: O1 N20, line 3: N20 M30" in told


def test_a_case_that_means_nothing_is_refused() -> None:
    with pytest.raises(ValueError, match="has nothing to run"):
        case("nothing", control="fanuc-0i-f", runs="N10")
    with pytest.raises(ValueError, match="not what happened"):
        square()
    with pytest.raises(TypeError, match="rnus"):
        square(rnus="N10")


TABLE = """
from cncsub.testing import case
case("one", control="fanuc-0i-f", program="O1\\nN10 M30", runs="N10")
for control in ("gsk-988ta", "mitsubishi-m700"):
    case("two", control=control, program="O1\\nN10 M30", runs="N20")
"""

NCTEST = """
control = "fanuc-0i-f"
load = ["macros"]

[[case]]
claim = "the macro squares"
main = "O1"
vars = {100 = 9, 101 = "vacant"}
runs = "N10 N25 N30 N40 N20"

[[case]]
claim = "its argument is asked for"
mdi = "G65 P2"
alarm = "user-alarm"
number = "MC3001"
at = "O2 N25"
"""
MACRO = "O2\nN25 IF[#1 EQ #0]THEN #3000=1(NO A)\nN30 #100=#1*#1\nN40 M99\n"


def write_project(folder: Path) -> Path:
    (folder / "macros").mkdir()
    (folder / "macros" / "O1.nc").write_text("O1\nN10 G65 P2 A3.\nN20 M30\n")
    (folder / "macros" / "O2.nc").write_text(MACRO)
    table = folder / "square.nctest.toml"
    table.write_text(NCTEST)
    return table


def test_tables_are_loaded(tmp_path: Path) -> None:
    file = tmp_path / "table.py"
    file.write_text(TABLE)
    one, two, three = load_table(file)
    assert (one.claim, one.topic, one.line) == ("one", "table", 3)
    assert (two.controls, three.controls) == (("gsk-988ta",), ("mitsubishi-m700",))
    check_case(one)
    with pytest.raises(AssertionError):
        check_case(two)
    for found in load_table(write_project(tmp_path)):
        check_case(found)


ON = "[[case]]\nclaim = 'a'\ncontrol = 'fanuc-0i-f'\nmdi = 'M30'\n"


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("control = 1", "a table must have cases"),
        ("case = 1", "a table must have cases"),
        ("[[case]]\nmdi = 'M30'", "case 1 has no claim"),
        ("[[case]]\nclaim = 'a'\nmdi = 'M30'\nruns = ''", "has no control"),
        ("[[case]]\nclaim = 'a'\ncontrl = 'x'", "no 'contrl'; did you mean control"),
        ("control = 'fanuc-0i-f'\n[[case]]\nclaim = 'a'\nmdi = 'M30'\nvars = {a = 1}", "not the number of a variable"),
        ("control = 'fanuc-0i-f'\n[[case]]\nclaim = 'a'\nmdi = 'M30'\nvars = {1 = 'x'}", 'a number or "vacant"'),
        ("control = 'fanuc-0i-f'\n[[case]]\nclaim = 'a'\nmdi = 'M30'\nvars = 1", "table of variables"),
        ("control = 'fanuc-0i-f'\nload = ['../x']\n[[case]]\nclaim = 'a'", "outside the folder"),
        ("control = 'fanuc-0i-f'\nload = ['x']\n[[case]]\nclaim = 'a'", "there is no x"),
        ("control = 'fanuc-0i-f'\nload = 'x'\n[[case]]\nclaim = 'a'", "list of files"),
        ("control = 'fanuc-0i-f'\n[[case]]\nclaim = 'a'\nmdi = 'M30'\nruns = 'x'", "not a block"),
        ("= 1", "nctest.toml"),
        ("runs = 1\n[[case]]\nclaim = 'a'", "above the cases: runs must be a text, such as"),
        ("claim = 'a'\n[[case]]\nruns = ''", "claim belongs in a case"),
        (ON + "m = ['M3']", "case 1, 'a': m must be a list of whole numbers, such as [3, 8], not ['M3']"),
        (ON + "skip = true", "skip must be a list of whole numbers, such as [1], not True"),
        (ON + "max_blocks = true", "max_blocks must be a whole number, such as 1000, not True"),
        (ON + "time = '1'", "time must be a number, such as 1.5, not '1'"),
        (ON + "optional_stop = 1", "optional_stop must be true or false, such as true, not 1"),
        (ON + "params = {3401 = 'a'}", "params must be a table of numbers"),
        (ON + "number = 3", "number must be a text or a table of texts"),
        (ON + "stop = 'ended'", "stop must be one of end, alarm, cycles, limit, waiting"),
        (ON + "vars = {100 = 1, '#100' = 2}", "vars has #100 twice"),
        (ON + "setup = {work_offset = {}}", "setup: a setup has no 'work_offset'; did you mean work_offsets"),
        (ON + "inputs = {signal = {}}", "inputs: inputs has no 'signal'; did you mean signals"),
        (ON + "moves = 'Q X1'", "moves: not a kind of move: 'Q X1'"),
        (ON + "centre = 'X1 |'\nfinal_work = 'a'", "final_work: not a point: 'a'"),
        (ON + "setup = 'x.toml'", "setup: there is no x.toml in the folder of the table"),
        (ON + "inputs = '.'", "inputs: . is a folder, not a file"),
        (ON + "variables = 'wrong.nctest.toml'", "wrong.nctest.toml: variables: a variable number must be a whole number"),
        (ON + 'load = ["a\\u0000"]', "load has a NUL"),
        (ON + "load = ['wrong.nctest.toml']\nfiles = {a = 'O1'}", "both load and files"),
        (ON + "alarm = 'user-alrm'", "there is no cause 'user-alrm'; did you mean user-alarm"),
        (ON + "number = 'PS1'\nruns = ''", "not which alarm"),
    ],
)  # fmt: skip
def test_a_wrong_table_says_where(tmp_path: Path, text: str, told: str) -> None:
    file = tmp_path / "wrong.nctest.toml"
    file.write_text(text)
    with pytest.raises(ValueError, match="wrong.nctest.toml") as failed:
        load_table(file)
    assert told in str(failed.value)


def write_shared(folder: Path, **said: str) -> Path:
    """Write a table two folders below the files that it names."""
    (folder / "shared").mkdir(parents=True, exist_ok=True)
    (folder / "shared" / "O5.nc").write_text(
        "O5\nN10 #100=#500\nN20 #101=#1000\nN30 G0 X0\nN40 M30\n"
    )
    (folder / "shared" / "setup.toml").write_text("work_offsets = {G54 = {X = 100}}")
    (folder / "shared" / "inputs.toml").write_text("signals = {1000 = 1}")
    (folder / "shared" / "variables.csv").write_text("500;2,5\n")
    tables = folder / "tests" / "tables"
    tables.mkdir(parents=True, exist_ok=True)
    words = {
        "setup": "'../../shared/setup.toml'",
        "inputs": "'../../shared/inputs.toml'",
        "variables": "'../../shared/variables.csv'",
        **said,
    }
    text = "control = 'fanuc-0i-f'\nload = ['../../shared/O5.nc']\n[[case]]\nclaim = 'files'\n"
    text += "vars = {100 = 2.5, 101 = 1}\nfinal_machine = 'X100'\n"
    table = tables / "files.nctest.toml"
    table.write_text(text + "".join(f"{name} = {value}\n" for name, value in words.items()))
    return table


@pytest.mark.parametrize("mark", ["cncsub.toml", "pyproject.toml", ".git", "pytest.ini"])
def test_a_table_takes_files_from_all_of_its_project(tmp_path: Path, mark: str) -> None:
    (tmp_path / mark).write_text("")
    table = write_shared(tmp_path / "job")
    (case,) = load_table(table)
    check_case(case)
    assert list(case.files or ()) == ["../../shared/O5.nc"]
    for said in (
        {"setup": "{work_offsets = {G54 = {X = 100}}}"},
        {"inputs": "{signals = {1000 = 1}}"},
        {"variables": "{500 = 2.5}"},
    ):
        check_case(*load_table(write_shared(tmp_path / "job", **said)))
    for said in (
        {"setup": "{work_offsets = {G54 = {X = 101}}}"},
        {"inputs": "{signals = {1000 = 0}}"},
        {"variables": "{500 = 'vacant'}"},
    ):
        with pytest.raises(AssertionError):
            check_case(*load_table(write_shared(tmp_path / "job", **said)))


@pytest.mark.parametrize("key", ["load", "setup", "inputs", "variables"])
def test_a_table_takes_no_file_from_outside_its_project(tmp_path: Path, key: str) -> None:
    table = write_shared(tmp_path)
    with pytest.raises(ValueError, match="outside the folder of the table; a cncsub.toml"):
        load_table(table)
    (tmp_path / "tests" / "cncsub.toml").write_text("")
    inside = dict.fromkeys(("setup", "inputs", "variables"), "{}") | {"load": "[]"}
    outside = "'../../shared/O5.nc'"
    with pytest.raises(
        ValueError, match=rf"{key}: ../../shared/O5.nc is outside the folder of the project"
    ):
        load_table(
            write_shared(tmp_path, **{**inside, key: f"[{outside}]" if key == "load" else outside})
        )
    (tmp_path / "tests" / "tables" / "link").symlink_to(tmp_path / "shared")
    linked = "'link/setup.toml'"
    with pytest.raises(
        ValueError, match=rf"{key}: link/setup.toml is outside the folder of the project"
    ):
        load_table(
            write_shared(tmp_path, **{**inside, key: f"[{linked}]" if key == "load" else linked})
        )


@pytest.mark.parametrize("alarm", ["PS0076", "program-not-found"])
def test_an_alarm_of_a_table_is_named_by_its_number_or_its_cause(
    tmp_path: Path, alarm: str
) -> None:
    file = tmp_path / "alarm.nctest.toml"
    file.write_text(ON.replace("M30", "M98 P7") + f"alarm = '{alarm}'")
    check_case(*load_table(file))
    file.write_text(ON.replace("M30", "M98 P7") + "alarm = 'PS0078'")
    with pytest.raises(
        AssertionError, match="^alarm: expected PS0078, got PS0076 program-not-found\n"
    ):
        check_case(*load_table(file))
    file.write_text(ON.replace("M30", "M98 P7") + "alarm = 'user-alarm'")
    with pytest.raises(
        AssertionError, match="^alarm: expected user-alarm, got program-not-found\n"
    ):
        check_case(*load_table(file))


def test_a_failing_table_shows_the_difference_first_and_the_files_last(tmp_path: Path) -> None:
    for number in range(2, 30):
        (tmp_path / f"O{number}.nc").write_text(f"O{number}\n#100=1\nN20 #100=#100+1\nM99\n")
    file = tmp_path / "failing.nctest.toml"
    file.write_text(ON.replace("M30", "M98 P2") + "load = ['.']\nvars = {100 = 3}\nruns = 'N20'")
    (tmp_path / ".git").mkdir()
    (tmp_path / ".git" / "O90.nc").write_text("O90\nM99\n")  # hidden
    with pytest.raises(AssertionError) as failed:
        check_case(*load_table(file))
    lines = str(failed.value).splitlines()
    assert lines[:3] == [
        "vars #100: expected 3, got 2",
        "of failing.nctest.toml, case 1: a",
        "control fanuc-0i-f",
    ]
    ran = lines.index("executed, 4 blocks:")
    assert lines[ran + 1 : ran + 5] == [
        "    MDI:1  M98 P2",
        "    O2:2  #100=1",
        "    O2:3  N20 #100=#100+1",
        "    O2:4  M99",
    ]
    assert lines[-3].startswith("loaded: O10.nc, O11.nc, ")
    assert lines[-3].endswith(" and 17 more")
    assert lines[-2:] == ["MDI:", "    M98 P2"]


def test_a_long_run_and_a_long_program_are_shown_by_their_ends() -> None:
    text = "O1\n" + "".join(f"#100={i}\n" for i in range(100)) + "M30\n"
    with pytest.raises(AssertionError) as failed:
        check_case(case("long", control="fanuc-0i-f", program=text, vars={100: 1}))
    told = str(failed.value)
    assert "executed, 101 blocks:\n    O1:2  #100=0\n" in told
    assert "    O1:13  #100=11\n    ... 77 more ...\n    O1:91  #100=89\n" in told
    assert told.endswith("    #100=28\n    ... 72 more lines")


def test_every_word_of_a_case_is_a_key_of_a_table_and_fits_its_own_example() -> None:
    words = set(inspect.signature(cases.read_case).parameters) - {"topic", "line"}
    assert set(KEYS) == words | {"load"}
    for key in KEYS.values():
        check_keys(tomllib.loads(f"{key.name} = {key.example}"))


def test_the_schema_of_tables_is_up_to_date_and_says_what_the_reader_says() -> None:
    file = Path(__file__).parents[1] / "docs" / "nctest.schema.json"
    assert json.loads(file.read_text(encoding="utf-8")) == schema()
    jsonschema = pytest.importorskip("jsonschema")
    check = jsonschema.Draft7Validator(schema()).is_valid
    for key in KEYS.values():
        said = {"claim": "a", **tomllib.loads(f"{key.name} = {key.example}")}
        assert check({"case": [said]})
        assert not check({"case": [{"claim": "a", key.name: [[]]}]})
    assert not check({"case": [{"claim": "a", "rnus": ""}]})
    assert not check({"case": [{"runs": ""}]})
    assert check(tomllib.loads(NCTEST))


# ---- the plugin ----

# pytest finds the plugin of an installed package by itself.
INSTALLED = any(of.name == "cncsub" for of in entry_points(group="pytest11"))
PLUGIN = "" if INSTALLED else "-p cncsub_pytest"


@pytest.fixture
def project(pytester: pytest.Pytester) -> pytest.Pytester:
    write_project(pytester.path)
    pytester.makeini(f"[pytest]\naddopts = {PLUGIN}\n")
    return pytester


def test_tables_are_tests(project: pytest.Pytester) -> None:
    project.runpytest_inprocess("-q").assert_outcomes(passed=2)
    table = project.path / "square.nctest.toml"
    table.write_text(NCTEST.replace("100 = 9", "100 = 8"))
    done = project.runpytest_inprocess("-q")
    done.assert_outcomes(passed=1, failed=1)
    done.stdout.fnmatch_lines(["*vars #100: expected 8, got 9*"])
    done = project.runpytest_inprocess(
        "-q", "--control", "mitsubishi-m800", "--control", "fanuc-30i"
    )
    done.assert_outcomes(failed=3, passed=1)
    table.write_text("[[case]]\n")
    done = project.runpytest_inprocess("-q")
    done.assert_outcomes(errors=1)
    done.stdout.fnmatch_lines(["*case 1 has no claim*"])


def test_a_control_that_a_table_mistypes_is_told_once(project: pytest.Pytester) -> None:
    (project.path / "square.nctest.toml").write_text(NCTEST.replace("fanuc-0i-f", "fanuc-0ig"))
    done = project.runpytest_inprocess("-q")
    done.assert_outcomes(errors=1)
    done.stdout.fnmatch_lines(
        ["*square.nctest.toml: there is no control 'fanuc-0ig'; did you mean *"]
    )


def test_a_start_of_pytest_does_not_import_cncsub(project: pytest.Pytester) -> None:
    project.makepyfile("import sys\n\ndef test_it():\n    assert 'cncsub' not in sys.modules\n")
    (project.path / "square.nctest.toml").unlink()
    project.runpytest_subprocess("-q", "-p", "no:cacheprovider").assert_outcomes(passed=1)


SUITE = """
import pytest

def test_square(cnc):
    run = cnc.run("macros", main="O1")
    run.assert_ends()
    assert run.variables[100] == 9

@pytest.mark.cnc("gsk-988ta")
def test_marked(cnc):
    assert cnc.control == cnc.loads("O1\\nM30\\n").control.name == "gsk-988ta"
    cnc.run("O1\\nN10 M98 P9\\n").assert_alarm("083", at="O1 N10")

@pytest.mark.cnc(control=["gsk-988ta", "mitsubishi-m800"])
def test_two(cnc):
    assert len(cnc.load("macros")) == 2

def test_plain():
    pass
"""


def test_a_control_that_there_is_not_is_told_in_a_line(project: pytest.Pytester) -> None:
    project.makepyfile('def test_it(cnc):\n    cnc.run("O1\\nM30\\n")\n')
    done = project.runpytest("--control", "fanuc-0ig")
    done.stdout.fnmatch_lines(["there is no control 'fanuc-0ig'; did you mean *fanuc-0i-f*"])
    done.stdout.no_fnmatch_line("*Traceback*")
    done.stdout.no_fnmatch_line("*def test_it*")


def test_the_fixture_has_the_control_of_the_option_or_the_marker(project: pytest.Pytester) -> None:
    project.makepyfile(SUITE)
    (project.path / "square.nctest.toml").unlink()
    done = project.runpytest_inprocess("-q")
    done.assert_outcomes(passed=4, failed=1)
    done.stdout.fnmatch_lines(["*which control? Give --control, the setting cncsub_control*"])
    done = project.runpytest_inprocess("-q", "--control", "fanuc-0i-f", "-k", "square or plain")
    done.assert_outcomes(passed=2)
    project.makeini(f"[pytest]\naddopts = {PLUGIN}\ncncsub_control = fanuc-0i-f fanuc-30i\n")
    project.runpytest_inprocess("-q").assert_outcomes(passed=6)


def test_without_a_control_there_is_one_usage_error(project: pytest.Pytester) -> None:
    project.makepyfile(
        "def test_a(cnc): cnc.control\ndef test_b(cnc): cnc.control\ndef test_c(): pass"
    )
    table = project.path / "square.nctest.toml"
    table.write_text(NCTEST.replace('control = "fanuc-0i-f"', ""))
    done = project.runpytest("-q")
    assert done.ret == pytest.ExitCode.USAGE_ERROR
    done.assert_outcomes()
    done.stderr.fnmatch_lines(
        ["ERROR: which control? 4 tests have none, the first *. Give --control*"]
    )
    done.stdout.no_fnmatch_line("*which control*")
    assert project.runpytest("-q", "--collect-only").ret == 0
    project.runpytest("-q", "-k", "test_c").assert_outcomes(passed=1, deselected=4)
    done = project.runpytest("-q", "-k", "test_a or test_c")  # one alone, and it is all of them
    assert done.ret == pytest.ExitCode.USAGE_ERROR
    done.stderr.fnmatch_lines(["ERROR: which control? *::test_a* has none. Give --control*"])
    project.runpytest("-q", "--control", "fanuc-0i-f").assert_outcomes(passed=5)
    table.write_text(NCTEST)  # one test alone has none: it fails, and the others run
    done = project.runpytest(
        "-q", "--deselect", "test_without_a_control_there_is_one_usage_error.py::test_b"
    )
    done.assert_outcomes(passed=3, failed=1, deselected=1)
    (project.path / "cncsub.toml").write_text('control = "fanuc-30i"')
    project.runpytest("-q").assert_outcomes(passed=5)


def test_snapshots_are_written_compared_and_missed(project: pytest.Pytester) -> None:
    project.makepyfile(
        test_snap='def test_it(cnc):\n    cnc.snapshot(cnc.run("macros", main="O1"), "all")\n'
    )
    (project.path / "square.nctest.toml").unlink()
    asked = ("-q", "--control", "fanuc-0i-f")
    done = project.runpytest_inprocess(*asked)
    done.assert_outcomes(failed=1)
    done.stdout.fnmatch_lines(["*run with --cncsub-update to write it*"])
    project.runpytest_inprocess(*asked, "--cncsub-update").assert_outcomes(passed=1)
    (file,) = (project.path / "snapshots").rglob("*.txt")
    assert (
        file.read_text()
        == "stop: end\nruns: O1:N10 O2:N25 O2:N30 O2:N40 O1:N20\ncalls: G65:O2\n#100 = 9\n"
    )
    project.runpytest_inprocess(*asked).assert_outcomes(passed=1)
    macro = project.path / "macros" / "O2.nc"
    macro.write_text(MACRO.replace("#1*#1", "#1+1"))
    done = project.runpytest_inprocess(*asked)
    done.assert_outcomes(failed=1)
    done.stdout.fnmatch_lines(["-#100 = 9", "+#100 = 4"])


def test_coverage_is_told_and_may_fail(project: pytest.Pytester) -> None:
    done = project.runpytest_inprocess("-q", "--cncsub-cov", "-k", "squares")
    done.assert_outcomes(passed=1, deselected=1)
    done.stdout.fnmatch_lines(["*coverage of NC programs*", "O2  blocks 3/3  branches 1/2*"])
    assert done.ret == 0
    done = project.runpytest_inprocess("-q", "--cncsub-cov-fail-under", "99", "-k", "squares")
    assert done.ret == 1
    done.stdout.fnmatch_lines(["*below 99 %*"])


def lines_of(done: pytest.RunResult) -> list[str]:
    """Return what the tests reported as coverage."""
    first = next(i for i, line in enumerate(done.outlines) if "coverage of NC programs" in line)
    return [line for line in done.outlines[first + 1 :] if not re.search(r" in \d|====", line)]


def test_the_sum_comes_first_and_what_was_typed_is_no_program(project: pytest.Pytester) -> None:
    done = project.runpytest_inprocess("-q", "--cncsub-cov", "--control", "fanuc-0i-f")
    assert lines_of(done) == [
        "Coverage: 100.0 %, 5 of 5 blocks, 2 of 2 branches, 1 of 1 calls",
        "O1  blocks 2/2  branches 0/0  macros/O1.nc",
        "O2  blocks 3/3  branches 2/2  macros/O2.nc",
    ]


IDLE = "O7\nN10 IF[#1 EQ 1]GOTO30\nN20 #2=1\nN30 M99\n"


def test_a_program_that_no_test_loads_counts_in_a_folder(project: pytest.Pytester) -> None:
    (project.path / "idle").mkdir()
    (project.path / "idle" / "O7.nc").write_text(IDLE)
    done = project.runpytest_inprocess(
        "-q", "--cncsub-cov=idle", "--cncsub-cov-fail-under", "1", "--control", "fanuc-0i-f"
    )
    assert lines_of(done) == [
        "Coverage: 0.0 %, 0 of 3 blocks, 0 of 2 branches, 0 of 0 calls",
        "O7  blocks 0/3  branches 0/2  not executed: lines 2-4  idle/O7.nc",
        "coverage is 0.0 %, below 1 % (--cncsub-cov-fail-under)",
    ]
    assert done.ret == 1
    # Both folders, on the control that the tests ran on; what is covered in full is counted only.
    done = project.runpytest_inprocess(
        "-q", "--cncsub-cov=idle", "--cncsub-cov=macros", "--cncsub-cov-skip-covered"
    )
    assert lines_of(done) == [
        "Coverage: 58.3 %, 5 of 8 blocks, 2 of 4 branches, 1 of 1 calls",
        "O7  blocks 0/3  branches 0/2  not executed: lines 2-4  idle/O7.nc",
        "2 programs are fully covered and not listed",
    ]
    (project.path / "cncsub.toml").write_text('control = "fanuc-0i-f"\nfolders = ["idle"]')
    done = project.runpytest_inprocess("-q", "--cncsub-cov")
    assert lines_of(done)[0] == "Coverage: 0.0 %, 0 of 3 blocks, 0 of 2 branches, 0 of 0 calls"


@pytest.mark.parametrize("asked", [["-k", "no_such_test"], ["-k", "test_plain"]])
def test_nothing_measured_fails_a_limit(project: pytest.Pytester, asked: list[str]) -> None:
    project.makepyfile("def test_plain(): pass")
    done = project.runpytest_inprocess("-q", "--cncsub-cov-fail-under", "0", *asked)
    assert done.ret in (1, pytest.ExitCode.NO_TESTS_COLLECTED)
    assert (done.ret == 1) == ("test_plain" in asked)
    assert lines_of(done) == [
        "Coverage: nothing was measured, 0 of 0 blocks, 0 of 0 branches, 0 of 0 calls",
        "coverage measured nothing (0 of 0 blocks), and must reach 0 % (--cncsub-cov-fail-under)",
    ]


@pytest.mark.parametrize(
    ("asked", "told"),
    [
        (["--cncsub-cov=macrs"], "macrs does not exist"),
        (["--cncsub-cov", "test_it.py"], "test_it.py is a file of Python"),
        (["--cncsub-cov", "tests"], "there is no program in the folder"),
        (["--cncsub-cov-fail-under", "101"], "a percentage, 0 to 100, not '101'"),
        (["--cncsub-cov-fail-under", "nan"], "a percentage, 0 to 100, not 'nan'"),
    ],
)
def test_a_wrong_option_of_coverage_is_a_usage_error(
    project: pytest.Pytester, asked: list[str], told: str
) -> None:
    project.makepyfile(test_it="def test_plain(): pass")
    (project.path / "tests").mkdir()
    done = project.runpytest(*asked)
    assert done.ret == pytest.ExitCode.USAGE_ERROR
    done.stderr.fnmatch_lines([f"*{told}*"])


def test_a_report_that_cannot_be_written_fails(project: pytest.Pytester) -> None:
    done = project.runpytest_inprocess("-q", "--cncsub-cov-lcov", "macros")
    assert done.ret == 1
    assert lines_of(done)[-1].startswith("--cncsub-cov-lcov macros cannot be written: ")


def test_workers_count_together(project: pytest.Pytester) -> None:
    pytest.importorskip("xdist")
    project.makepyfile(
        """
        import pytest

        @pytest.mark.parametrize("a", range(4))
        def test_square(cnc, a):
            cnc.load("macros").mdi(f"G65 P2 A{a}.").assert_ends()
            cnc.loads(f"O1\\nN10 #100={a % 2}\\nM30\\n").run().assert_ends()
        """
    )
    asked = ("-q", "--cncsub-cov", "--control", "fanuc-0i-f", "--cncsub-cov-lcov=lcov")
    alone = lines_of(project.runpytest_subprocess(*asked, "-k", "test_square"))
    counts = (project.path / "lcov").read_text()
    assert "DA:4,4\n" in counts
    together = project.runpytest_subprocess(*asked, "-n", "2", "-k", "test_square")
    assert lines_of(together) == alone
    assert (project.path / "lcov").read_text() == counts


def test_a_worker_that_ends_early_is_named(project: pytest.Pytester) -> None:
    pytest.importorskip("xdist")
    project.makepyfile("import os\n\ndef test_it():\n    os._exit(3)\n")
    done = project.runpytest_subprocess("-q", "--cncsub-cov", "-n", "1", "-k", "test_it")
    assert "what worker gw0 ran is not counted: it ended too early" in lines_of(done)


def test_workers_without_a_control_end_with_one_usage_error(project: pytest.Pytester) -> None:
    pytest.importorskip("xdist")
    project.makepyfile("def test_a(cnc): pass\ndef test_b(cnc): pass")
    done = project.runpytest_subprocess("-q", "-n", "2", "--cncsub-cov", "-k", "test_a or test_b")
    assert done.ret == pytest.ExitCode.USAGE_ERROR
    assert str(done.stdout).count("which control? 2 tests have none, the first") == 1
    done.stdout.no_fnmatch_line("*coverage of NC*")


def test_coverage_is_written_in_each_form(project: pytest.Pytester) -> None:
    asked = [f"--cncsub-cov-{name}=out/{name}" for name in ("html", "lcov", "cobertura")]
    project.runpytest_inprocess("-q", *asked).assert_outcomes(passed=2)
    texts = [(project.path / "out" / name).read_text() for name in ("html", "lcov", "cobertura")]
    starts = ("<!DOCTYPE html>", "TN:", "<?xml")
    assert [text.startswith(start) for text, start in zip(texts, starts)] == [True] * 3
    assert "(macros/O2.nc)" in texts[0]
    assert "SF:macros/O2.nc\n" in texts[1]
    assert 'filename="macros/O2.nc"' in texts[2]


def test_a_table_and_a_test_in_python_cover_the_same_files(project: pytest.Pytester) -> None:
    project.makepyfile(
        """
        def test_square(cnc):
            cnc.load("macros").mdi("G65 P2 A2.").assert_ends()
        """
    )
    done = project.runpytest_inprocess("-q", "--cncsub-cov", "--control", "fanuc-0i-f")
    lines = [line for line in done.outlines if line.startswith("O2  ")]
    assert lines == ["O2  blocks 3/3  branches 2/2  macros/O2.nc"]


def test_a_failure_stands_in_the_test(project: pytest.Pytester) -> None:
    project.makepyfile(
        """
        def test_square(cnc):
            cnc.load("macros").run("O1").assert_alarm("P232")
        """
    )
    done = project.runpytest_inprocess("-q", "--control", "fanuc-0i-f", "-k", "test_square")
    done.assert_outcomes(failed=1, deselected=2)
    done.stdout.no_fnmatch_line("*asserting.py*")
    done.stdout.fnmatch_lines(["*test_a_failure_stands_in_the_test.py:2: AssertionError"])


def test_arguments_by_hypothesis_meet_the_fixture(project: pytest.Pytester) -> None:
    project.makepyfile(
        """
        from hypothesis import HealthCheck, given, settings
        from cncsub.testing.strategies import arguments, call_words

        @settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=20)
        @given(arguments("A", A=(-50, 50)))
        def test_square(cnc, values):
            run = cnc.load("macros").mdi(f"G65 P2 {call_words(values)}")
            run.assert_ends()
            assert run.variables[100] >= 0
        """
    )
    done = project.runpytest_inprocess("-q", "--control", "fanuc-0i-f", "-k", "test_square")
    done.assert_outcomes(passed=1, deselected=2)


# ---- arguments of macros ----


@given(arguments("A", A=(-50, 50), B=(0, 10)))
def test_arguments_arrive_as_they_are_written(values: dict[str, Decimal]) -> None:
    assert -50 <= values["A"] <= 50
    assert 0 <= values.get("B", Decimal(0)) <= 10
    text = f"O1\nN10 G65 P2 {call_words(values)}\nN20 M30\nO2\nN30 #100=#1\nN40 #101=#2\nN50 M99\n"
    run = cncsub.loads(text, control="fanuc-0i-f").run()
    run.assert_ends()
    assert run.variables[100] == pytest.approx(float(values["A"]), abs=1e-9)
    given_b = values.get("B")
    assert run.variables.get(101) == (
        None if given_b is None else pytest.approx(float(given_b), abs=1e-9)
    )


def test_letters_that_are_no_arguments() -> None:
    with pytest.raises(ValueError, match="'P' is not an argument"):
        arguments("P")
