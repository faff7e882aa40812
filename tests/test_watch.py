"""The variables that are watched: there is a row per change, whoever made it."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
import pytest
from typer.testing import CliRunner

import cncsub
from cncsub.cli import app
from cncsub.tables.table import records
from cncsub.testing.outcome import load
from conformance import Row, rows


class Watched(NamedTuple):
    """A watched run; `changes` are written `N20 #100=5`: the block by its N, or by line as `:4`."""

    control: str
    text: str
    watch: Sequence[int]
    changes: str
    options: Mapping[str, Any] = MappingProxyType({})


COUNT = "O1\nN10 #100=#100+1\nN20 IF[#100 LT 3]GOTO 10\nN30 #500=#100\nN40 M30\n"
MACRO = """O1
N10 #1=5
N20 G65 P2 A7. B8.
N30 #2=#1
N40 M30
O2
N50 #1=#1+1
N60 #100=#1
N70 M99
"""
LEVELS = "N10 #1=5, N20 #1=7, N20 #2=8, N50 #1=8, N70 #1=5, N70 #2=-, N30 #2=5"

TABLE = {
    "a loop counts a common, which another one takes over": Watched(
        "fanuc-0i-f", COUNT, [100, 500], "N10 #100=1, N10 #100=2, N10 #100=3, N30 #500=3"
    ),
    "what is not watched makes no row": Watched("gsk-988ta", COUNT, [500], "N30 #500=3"),
    "nothing is watched": Watched("fanuc-0i-f", COUNT, [], ""),
    "a number that is named twice is watched once": Watched(
        "fanuc-0i-f", COUNT, [500, 500], "N30 #500=3"
    ),
    "a block that writes what is there makes no row": Watched(
        "mitsubishi-m700", "O1\nN10 #100=5\nN20 #100=5\nN30 #100=#0\nN40 #100=#0\nM30\n",
        [100], "N10 #100=5, N30 #100=-",
    ),
    "what a run is given is the beginning and no row": Watched(
        "fanuc-0i-f", "O1\nN10 #100=5\nN20 #100=6\nM30\n", [100], "N20 #100=6",
        {"variables": {100: 5}},
    ),
    "locals are those of the level that is open after the block": Watched(
        "fanuc-0i-f", MACRO, [1, 2], LEVELS
    ),
    "locals of a GSK": Watched("gsk-988ta", MACRO, [1, 2], LEVELS),
    "locals of a Mitsubishi": Watched("mitsubishi-m800", MACRO, [1, 2], LEVELS),
    "a subprogram has the locals of its caller": Watched(
        "fanuc-0i-f", "O1\nN10 #1=5\nN20 M98 P2\nN30 M30\nO2\nN40 #1=6\nN50 M99\n",
        [1], "N10 #1=5, N40 #1=6",
    ),
    "the words of an M98 are locals of the HNC": Watched(
        "hnc-21m", "%1\nN10 M98 P2 A5\nN30 M30\n%2\nN40 #100=#0\nN50 M99\n",
        [0, 100], "N10 #0=5, N40 #100=5, N50 #0=-",
    ),
    "a work offset, written by number and by G10": Watched(
        "fanuc-0i-f", "O1\nN10 #5221=7\nN20 G90 G10 L2 P1 X9.\nM30\n",
        [5221], "N10 #5221=7, N20 #5221=9",
    ),
    "a computed number": Watched(
        "fanuc-0i-f", "O1\nN10 #1=500\nN20 #[#1+1]=3\nM30\n", [501], "N20 #501=3"
    ),
    "a position changes with the moves": Watched(
        "fanuc-0i-f", "O1\nN10 G90 G0 X5.\nN20 Y3.\nN30 G1 X6. F100\nM30\n",
        [5041], "N10 #5041=5, N30 #5041=6",
    ),
    "IF THEN": Watched(
        "fanuc-0i-f", "O1\nN10 IF[1 EQ 1]THEN #100=4\nN20 IF[1 EQ 2]THEN #100=5\nM30\n",
        [100], "N10 #100=4",
    ),
    "an assignment after a skipped block": Watched(
        "fanuc-0i-f", "O1\n/N10 #100=4\nN20 #100=5\nM30\n",
        [100], "N20 #100=5", {"block_skip": 1},
    ),
    "G65 H codes": Watched(
        "gsk-980tdi", "O1\nN10 G65 H01 P#200 Q5\nN20 G65 H02 P#200 Q#200 R3\nN30 M30\n",
        [200], "N10 #200=5, N20 #200=8",
    ),
    "the block that alarms makes no row": Watched(
        "fanuc-0i-f", "O1\nN10 #100=1\nN20 #100=1/0\nM30\n", [100], "N10 #100=1"
    ),
    "assignments of a block that alarms are taken back": Watched(
        "linuxcnc", "N1 #1=9\nN2 #1=5 #31=6 G2 X9\nM2\n", [1, 31, 5221], "N1 #1=9"
    ),
    "several assignments in a block of LinuxCNC": Watched(
        "linuxcnc", "N1 #1=9 #2=8 G0 X3\nN2 #1=#2 #2=#1\nM2\n",
        [1, 2], "N1 #1=9, N1 #2=8, N2 #1=8, N2 #2=9",
    ),
    "a block that assigns twice makes one row": Watched(
        "linuxcnc", "N1 #1=9 #1=7\nM2\n", [1], "N1 #1=7"
    ),
    "locals of O-words": Watched(
        "linuxcnc", "o1 sub\n#2=#1\no1 endsub\n#1=4\no1 call [7]\nM2\n",
        [1, 2], ":4 #1=4, :5 #1=7, :2 #2=7, :3 #1=4, :3 #2=-",
    ),
    "R parameters of Siemens": Watched(
        "siemens-one", "N10 R1=1\nN15 WHILE R1<3\nN20 R1=R1+1\nN22 R2=R1*2\nN25 ENDWHILE\nN30 M30\n",
        [1, 2], "N10 #1=1, N20 #1=2, N22 #2=4, N20 #1=3, N22 #2=6",
    ),
    "what another program writes while the run waits": Watched(
        "fanuc-0i-f", "O1\nN10 IF[#500 EQ 0]GOTO 10\nN20 #100=#500\nN30 M30\n",
        [100, 500], "N10 #500=3, N20 #100=3",
        {"variables": {500: 0}, "inputs": {"writes": [{500: 3}]}},
    ),
    "MDI": Watched("fanuc-0i-f", "O1\nN10 #100=1\nM99\n", [100], "N10 #100=1", {"mode": "mdi"}),
}  # fmt: skip


def told(change: cncsub.Change) -> str:
    where = f":{change.line}" if change.n is None else f"N{change.n}"
    return f"{where} #{change.variable}={'-' if change.value is None else f'{change.value:g}'}"


@pytest.mark.parametrize("trace", cncsub.run_options.TRACES)
@pytest.mark.parametrize("name", TABLE)
def test_a_row_for_each_change(name: str, trace: str) -> None:
    of = TABLE[name]
    library = cncsub.loads(of.text, control=of.control)
    run = library.run(watch=of.watch, trace=trace, **of.options)
    assert ", ".join(map(told, run.watch)) == of.changes


# ---- the law: there is a row wherever a variable reads otherwise after a step ----

NUMBERS = [*range(1, 6), *range(100, 104), 500, 501, 2001, 3001, 4001, 5041, 5221]


def readable(library: cncsub.Library) -> list[int]:
    def is_readable(number: int) -> bool:
        try:
            library.machine(watch=number)
        except ValueError:
            return False
        return True

    return [number for number in NUMBERS if is_readable(number)]


def seen(machine: cncsub.Machine, numbers: Sequence[int]) -> list[cncsub.Change]:
    """Return the changes that an observer notes who reads every variable after every step."""
    before = {number: machine.variables[number] for number in numbers}
    noted = []
    while (step := machine.step()) is not None:
        for number in numbers:
            value = machine.variables[number]
            if value != before[number]:
                noted.append(
                    cncsub.Change(step.step, number, value, step.program, step.n, step.line)
                )
            before[number] = value
    return noted


def some_rows() -> Iterator[Row]:
    """Yield, for every control, each seventeenth row in which something is computed or called."""
    met: dict[str, int] = {}
    for row in rows():
        text = str(row.case.program)
        if row.case.options.get("mdi") or not ("#" in text or "98" in text or "R1" in text):
            continue
        met[row.control] = met.get(row.control, 0) + 1
        if met[row.control] % 17 == 1:
            yield row


@pytest.mark.parametrize("row", list(some_rows()), ids=str)
def test_watching_notes_what_somebody_sees_who_looks_behind_every_step(row: Row) -> None:
    case = row.case
    library = load(case, cncsub.controls[row.control])
    options = {"max_blocks": 2000, **case.options, "setup": case.setup}
    numbers = readable(library)
    plain = library.run(**options)
    run = library.run(watch=numbers, **options)
    machine = library.machine(**options)
    assert list(run.watch) == seen(machine, numbers)
    # Watching changes nothing.
    assert (run.stop, run.alarm, run.blocks) == (plain.stop, plain.alarm, plain.blocks)
    assert list(run.steps) == list(plain.steps)
    assert dict(run.variables) == dict(plain.variables)
    assert run.moves.x.tolist() == plain.moves.x.tolist()


# ---- the start of a run, and values that are set from outside ----


def test_the_beginning_is_told_and_is_no_row() -> None:
    library = cncsub.loads(COUNT, control="fanuc-0i-f")
    run = library.run(variables={100: 2.5}, watch=[500, 100, 5041])
    assert run.watch.beginning == {500: None, 100: 2.5, 5041: 0.0}
    assert list(run.watch.beginning) == [500, 100, 5041]
    assert [told(change) for change in run.watch] == ["N10 #100=3.5", "N30 #500=3.5"]
    assert library.run().watch.beginning == {}


def test_what_is_set_between_two_steps_belongs_to_no_step() -> None:
    machine = cncsub.loads(COUNT, control="fanuc-0i-f").machine(watch=[100, 1])
    machine.variables[100] = 1
    machine.step()
    machine.variables[101] = 3
    machine.variables.level(0)[1] = 4
    machine.run()
    machine.reset()
    outside = {"step": None, "program": None, "n": None, "line": None}
    assert list(machine.watch) == [
        cncsub.Change(variable=100, value=1.0, **outside),  # type: ignore[arg-type]
        cncsub.Change(0, 100, 2.0, "O1", 10, 2),
        cncsub.Change(variable=1, value=4.0, **outside),  # type: ignore[arg-type]
        cncsub.Change(2, 100, 3.0, "O1", 10, 2),
        cncsub.Change(variable=100, value=None, **outside),  # type: ignore[arg-type]
        cncsub.Change(variable=1, value=None, **outside),  # type: ignore[arg-type]
    ]
    assert machine.watch.step.tolist() == [-1, 0, -1, 2, -1, -1]
    assert machine.watch.program.tolist() == [-1, 0, -1, 0, -1, -1]
    assert machine.watch.line.tolist() == [-1, 2, -1, 2, -1, -1]
    frame = machine.watch.to_pandas()
    assert frame.program.isna().tolist() == [True, False, True, False, True, True]
    programs = [None, "O1", None, "O1", None, None]
    assert machine.watch.to_arrow()["program"].to_pylist() == programs
    assert [record["program"] for record in records(machine.watch)] == programs
    assert [record["step"] for record in records(machine.watch)] == [None, 0, None, 2, None, None]


def test_a_signal_that_is_set() -> None:
    text = "O1\nN10 #100=#1004\nN20 M30\n"
    machine = cncsub.loads(text, control="fanuc-0i-f").machine(watch=1004)
    machine.signals[1004] = 1
    machine.run()
    assert [(change.step, change.value) for change in machine.watch] == [(None, 1.0)]


def test_a_copy_goes_on_by_itself() -> None:
    machine = cncsub.loads(COUNT, control="fanuc-0i-f").machine(watch=[100, 500])
    machine.step()
    copy = machine.copy()
    before = list(machine.watch)
    run = copy.run()
    assert run is not None
    assert list(machine.watch) == before == run.watch[:1]
    machine.variables[100] = 50
    machine.run()
    assert [change.value for change in machine.watch] == [1.0, 50.0, 50.0]
    assert [change.value for change in copy.watch] == [1.0, 2.0, 3.0, 3.0]


def test_steps_runs_and_pauses_note_the_same() -> None:
    library = cncsub.loads(MACRO, control="fanuc-0i-f")
    expected = list(library.run(watch=[1, 2, 100]).watch)
    stepped, paused = (library.machine(watch=[1, 2, 100]) for _ in range(2))
    assert len(list(stepped)) == 7
    paused.run(until=("O2", 60))
    paused.run(until=0)
    paused.run()
    assert list(stepped.watch) == list(paused.watch) == expected


def test_mdi_and_a_main_program_that_starts_over() -> None:
    library = cncsub.loads("O1\nN10 #100=#100+1\nN20 M99\n", control="fanuc-0i-f")
    assert library.run(watch=100, max_cycles=4).watch.step.tolist() == [0, 2, 4, 6]
    run = library.mdi("#100=7\nG65 P1\n", watch=[100])
    assert [(change.line, change.value) for change in run.watch] == [(1, 7.0), (2, 8.0)]


# ---- streams ----

LONG = "O1\nN10 #100=#100+1\nN20 G0 X#100\nN30 IF[#100 LT 5000]GOTO 10\nN40 M30\n"


@pytest.mark.parametrize("trace", ["none", "moves"])
def test_parts_of_a_stream_are_the_table_of_the_run(trace: str) -> None:
    library = cncsub.loads(LONG, control="fanuc-0i-f")
    run = library.run(watch=[100, 5041], trace=trace)
    assert len(run.watch) == 10_000
    parts = list(library.stream(rows=700, watch=[100, 5041], trace=trace))
    assert [change for part in parts for change in part.watch] == list(run.watch)
    beginnings = [part.watch.beginning for part in parts]
    assert beginnings[0] == run.watch.beginning
    for before, part, begins in zip(beginnings, parts, beginnings[1:], strict=False):
        assert begins == before | {change.variable: change.value for change in part.watch}
    assert "#100, #5041" in repr(parts[0])


@pytest.mark.parametrize("trace", ["none", "moves"])
def test_a_stream_writes_what_is_watched(tmp_path: Path, trace: str) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    library = cncsub.loads(LONG, control="fanuc-0i-f")
    library.stream(rows=700, watch=[100], trace=trace).to_parquet(tmp_path)
    (file,) = tmp_path.glob("watch-*")
    written = parquet.read_table(file)
    run = library.run(watch=[100])
    assert written["value"].to_pylist() == run.watch.value.tolist()
    assert written["program"].to_pylist() == ["O1"] * 5000
    library.stream().to_parquet(tmp_path / "plain")
    assert not list((tmp_path / "plain").glob("watch-*"))
    with pytest.raises(ValueError, match="records nothing"):
        library.stream(trace="none").to_parquet(tmp_path / "none")


# ---- the table ----


def test_the_table_is_one_as_the_others_are() -> None:
    run = cncsub.loads(MACRO, control="fanuc-0i-f").run(watch=[1, 2])
    table = run.watch
    assert table.columns == ["step", "variable", "value", "program", "n", "line"]
    kinds = {name: str(table.column(name).dtype) for name in table.columns}
    assert kinds == {
        "step": "int64", "variable": "int32", "value": "float64", "program": "int32", "n": "int32", "line": "int32",
    }  # fmt: skip
    for index, row in enumerate(table):
        step = run.steps[row.step or 0]
        assert (row.program, row.n, row.line) == (step.program, step.n, step.line)
        assert table.programs[table.program[index]] == row.program
        assert (table.step[index], table.n[index], table.line[index]) == (row.step, row.n, row.line)
        value = table.value[index]
        assert value == row.value or (math.isnan(value) and row.value is None)
    assert table[-1] == table[len(table) - 1]
    assert not table.value.flags.writeable
    assert table.to_pandas().program.tolist() == [row.program for row in table]
    assert table.to_arrow()["variable"].to_pylist() == [row.variable for row in table]
    assert np.array_equal(table["value"], table.value, equal_nan=True)
    with pytest.raises(KeyError, match="variable, value"):
        table.column("x")
    with pytest.raises(IndexError):
        table[len(table)]
    assert repr(table).splitlines()[1:3] == [
        "   0         1      5       O1  10     2",
        "   1         1      7       O1  20     3",
    ]
    assert repr(table).endswith("\n7 changes of #1, #2")
    assert "<td>-</td>" in table._repr_html_()


def test_a_run_that_watches_nothing_has_an_empty_table_that_says_how() -> None:
    run = cncsub.loads(COUNT, control="fanuc-0i-f").run()
    assert len(run.watch) == 0
    assert [len(run.watch.column(name)) for name in run.watch.columns] == [0] * 6
    assert repr(run.watch) == "0 changes of nothing: run(watch=[100]) watches #100"
    assert run.watch.to_pandas().empty
    assert run.watch.to_arrow().num_rows == 0


def test_columns_of_many_rows_are_the_rows() -> None:
    run = cncsub.loads(LONG, control="fanuc-0i-f").run(watch=[100, 5041])
    columns = zip(*(run.watch.column(name).tolist() for name in ("step", "value")), strict=True)
    assert list(columns) == [(change.step, change.value) for change in run.watch]


def test_what_is_watched_counts_as_memory() -> None:
    text = "O1\nN10 #100=#100+1\nGOTO 10\n"
    library = cncsub.loads(text, control="fanuc-0i-f")
    most = 1 << 20
    for watch in ([100], range(100, 150)):
        run = library.run(
            watch=watch, max_memory=most, max_blocks=2**62, max_seconds=60, trace="none"
        )
        assert run.stop is cncsub.Stop.LIMIT
        assert len(run.watch) * 24 < most * 1.5
        assert len(run.watch) * 24 > most * 0.5


def test_threads_watch_one_library() -> None:
    library = cncsub.loads(LONG, control="fanuc-0i-f")
    expected = library.run(watch=[100, 5041]).watch.value.tolist()
    with ThreadPoolExecutor(4) as pool:
        runs = pool.map(lambda _: library.run(watch=[100, 5041]).watch.value.tolist(), range(8))
        assert all(values == expected for values in runs)


# ---- wrong use ----


@pytest.mark.parametrize(
    ("control", "watch", "error", "said"),
    [
        ("fanuc-0i-f", "100", TypeError, r"watch must be a list of variable numbers such as \[100, 500\], not '100'"),
        ("fanuc-0i-f", None, TypeError, "watch must be a list of variable numbers"),
        ("fanuc-0i-f", 100.0, TypeError, "not 100.0"),
        ("fanuc-0i-f", True, TypeError, "watch: a variable number must be a whole number such as 100, not True"),
        ("fanuc-0i-f", [100.5], TypeError, "not 100.5"),
        ("fanuc-0i-f", [None], TypeError, "not None"),
        ("fanuc-0i-f", ["R1"], ValueError, "watch: fanuc-0i-f has no variable 'R1'"),
        ("linuxcnc", ["<_depth>"], ValueError, "watch: '<_depth>' is no variable that has a number"),
        ("siemens-one", ["#1"], ValueError, "watch: siemens-one has no variable '#1'"),
        ("fanuc-0i-f", [0], ValueError, "watch: #0 is always vacant"),
        ("fanuc-0i-f", [-1], ValueError, "watch: there is no variable #-1"),
        ("fanuc-0i-f", [2**31], ValueError, "watch: there is no variable #2147483648"),
        ("fanuc-0i-f", [100, 99999], ValueError, "watch: .*#99999"),
        ("fanuc-0i-f", [3000], ValueError, "watch: #3000 cannot be read"),
        ("gsk-928te", [7777], ValueError, "watch: .*#7777"),
        ("fanuc-0i-f", range(10**9), ValueError, "watch: at most 1000 variables can be watched in one run; give fewer"),
    ],
)  # fmt: skip
def test_what_cannot_be_watched_is_refused_in_words(
    control: str, watch: Any, error: type[Exception], said: str
) -> None:
    library = cncsub.loads("M30\n", control=control, name="a.nc")
    for begin in (library.run, library.machine, library.stream):
        with pytest.raises(error, match=said):
            begin(watch=watch)
    with pytest.raises(error, match=said):
        library.mdi("M30", watch=watch)


@pytest.mark.parametrize(
    "watch",
    [100, (100,), {100}, {100: 5}, iter([100]), np.array([100]), np.int64(100)],
    ids=lambda w: type(w).__name__,
)
def test_numbers_are_given_in_any_way(watch: Any) -> None:
    run = cncsub.loads("O1\nN10 #100=5\nM30\n", control="fanuc-0i-f").run(watch=watch)
    assert [told(change) for change in run.watch] == ["N10 #100=5"]


# ---- the command ----

COUNTER = "O1\nN10 #100=#100+1\nN20 IF[#100LT3]GOTO10\nN30 #500=#100\nN40 #100=#0\nM30\n"


def command(tmp_path: Path, *words: str, text: str = COUNTER) -> tuple[int, str]:
    file = tmp_path / "part.nc"
    file.write_text(text)
    done = CliRunner().invoke(app, ["run", str(file), "-c", "fanuc-0i-f", *words])
    return done.exit_code, done.output


def test_the_command_tells_each_change(tmp_path: Path) -> None:
    status, output = command(tmp_path, "--watch", "100-101,500", "--set", "100=0")
    assert status == 0
    assert [line for line in output.splitlines() if line.startswith("watch")] == [
        "watch: #100 begins 0",
        "watch: #101 begins vacant",
        "watch: #500 begins vacant",
        "watch: #100 0 -> 1 at O1 N10, line 2, step 0",
        "watch: 1 LT 3: true at O1 N20, line 3, step 1",
        "watch: #100 1 -> 2 at O1 N10, line 2, step 2",
        "watch: 2 LT 3: true at O1 N20, line 3, step 3",
        "watch: #100 2 -> 3 at O1 N10, line 2, step 4",
        "watch: 3 LT 3: false at O1 N20, line 3, step 5",
        "watch: #500 vacant -> 3 at O1 N30, line 4, step 6",
        "watch: #100 3 -> vacant at O1 N40, line 5, step 7",
    ]
    assert "watch" not in command(tmp_path)[1]


def test_the_command_prints_no_more_than_can_be_read(tmp_path: Path) -> None:
    text = "O1\nN10 #100=#100+1\nN20 IF[#100LT300]GOTO10\nM30\n"
    _, output = command(tmp_path, "--watch", "#100", "--set", "100=0", text=text)
    assert output.count("\nwatch: ") == 201
    assert "... 400 more" in output


def test_the_command_writes_the_changes_as_json(tmp_path: Path) -> None:
    _, output = command(tmp_path, "--watch", "500", "--format", "json")
    assert json.loads(output)["watch"] == {
        "beginning": {"500": None},
        "changes": [
            {"step": 6, "variable": 500, "value": 3.0, "program": "O1", "n": 30, "line": 4}
        ],
        "conditions": [],  # that read #500
    }
    assert json.loads(command(tmp_path, "--format", "json")[1])["watch"] is None


@pytest.mark.parametrize(
    ("watch", "words"),
    [
        ("a", "--watch must be numbers and ranges such as 500 or 100-149, not 'a'"),
        ("149-100", "the last number comes before the first"),
        ("1-9999", "at most 1,000 variables"),
        ("999999", "watch: "),
    ],
)
def test_a_wrong_watch_is_told(tmp_path: Path, watch: str, words: str) -> None:
    status, output = command(tmp_path, "--watch", watch)
    assert status == 2
    assert words in output


def test_moves_have_no_place_for_what_is_watched(tmp_path: Path) -> None:
    status, output = command(tmp_path, "--watch", "100", "--format", "csv")
    assert (status, "--watch takes text or json" in output) == (2, True)


def test_vacant_neighbours_begin_on_one_line(tmp_path: Path) -> None:
    (tmp_path / "p.nc").write_text("O1\n#100=1\nM30\n")
    command = ["run", str(tmp_path / "p.nc"), "-c", "fanuc-0i-f", "--watch", "1-33,100-102"]
    out = CliRunner().invoke(app, [*command, "--set", "101=5"]).stdout
    assert [line for line in out.splitlines() if "begin" in line] == [
        "watch: #1 to #33 begin vacant",
        "watch: #100 begins vacant",
        "watch: #101 begins 5",
        "watch: #102 begins vacant",
    ]
