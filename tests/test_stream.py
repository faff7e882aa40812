"""A run in parts is the run; copies of a machine share what was recorded until they go on."""

from __future__ import annotations

import itertools
import os
import signal
import subprocess
import sys
import textwrap
import threading
import time
from pathlib import Path

import duckdb
import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pyarrow import parquet

import cncsub

CONTROL = "fanuc-0i-f"
# The address sanitizer keeps memory that was freed.
KEPT = 600 if "asan" in os.environ.get("LD_PRELOAD", "") else 0  # MiB
TABLES = ("steps", "calls", "moves")

# Things that a part may cut through: nested calls, arguments, cycles, compensation, an arc, an axis
# that comes late, a corner that waits, messages.
PROGRAM = """\
O1
N10 G90 G54 G0 X0 Y0 Z5. F100. S500 M3
N20 M98 P2 L3
N30 G65 P3 A5. B2.
N40 G66 P4 Q7.
N50 X3.
N60 X4.
N70 G67
N80 G81 X1. Y1. Z-3. R2. L1
N90 X2.
N100 G80
N110 G41 D1 G1 X10. Y0
N120 Y10.
N130 G3 X0 Y20. R10.
N140 G1 X-10.
N150 G40 X-20. Y30.
N160 G1 A90. T12
N170 X1. ,C1.
N180 Y9.
N190 POPEN
N200 DPRNT[X#100[33]]
N210 PCLOS
N220 M30
O2
N10 G91 X1. G90
N20 M98 P4 L2
N30 M99
O3
N10 #100=#1+#2
N20 WHILE[#1 GT 0]DO1
N30 G1 Z[0-#1]
N40 #1=#1-1
N50 END1
N60 M98 P2
N70 M99
O4
N10 G4 P10
N20 M99
"""
SETUP = {"radius_offsets": {1: 2.0}, "start": {"A": 7.0}}


def together(parts: list[cncsub.Part], table: str, name: str) -> np.ndarray:
    return np.concatenate([getattr(part, table).column(name) for part in parts])


def assert_same(parts: list[cncsub.Part], run: cncsub.Run) -> None:
    for table in ("steps", "moves"):
        rows = getattr(run, table)
        for name in rows.columns:
            np.testing.assert_array_equal(together(parts, table, name), rows.column(name), name)
    # A call comes in the part in which it ended, with its number.
    order = np.argsort(together(parts, "calls", "call"))
    for name in run.calls.columns:
        np.testing.assert_array_equal(
            together(parts, "calls", name)[order], run.calls.column(name), name
        )
    streamed = {call.call: call.arguments for part in parts for call in part.calls}
    assert streamed == {call.call: call.arguments for call in run.calls}
    for name in ("messages", "m_codes", "t_codes"):
        assert list(itertools.chain(*(getattr(p, name) for p in parts))) == getattr(run, name)


@pytest.mark.parametrize("rows", [1, 2, 3, 5, 7, 11, 20, 64, 65536])
def test_the_parts_are_the_run(rows: int) -> None:
    library = cncsub.loads(PROGRAM, control=CONTROL)
    run = library.run(setup=SETUP)
    assert run.stop is cncsub.Stop.END
    stream = library.stream(rows=rows, setup=SETUP)
    parts = list(stream)
    assert all(len(part.steps) <= rows for part in parts)
    assert_same(parts, run)
    assert stream.stop is run.stop
    assert dict(stream.variables) == dict(run.variables)
    assert (stream.position, stream.modal) == (run.position, run.modal)
    for part in parts:
        for table in TABLES:
            rows_of = list(getattr(part, table))
            for name in getattr(part, table).columns:
                told = [getattr(row, name) for row in rows_of]
                assert len(told) == len(getattr(part, table).column(name))
        numbers = [step.step for step in part.steps]
        assert numbers == part.steps.step.tolist()
        assert [m.move for m in part.moves] == part.moves.move.tolist()
        assert [m.step for m in part.moves] == part.moves.step.tolist()


block = st.sampled_from(
    [
        "G0 X1.",
        "G91 G1 Y2. F100.",
        "G90",
        "M98 P2",
        "M98 P2 L3",
        "G65 P3 A1.",
        "G66 P3 A2. L2",
        "G67",
        "G2 X5. R4.",
        "G81 Z-1. R1. F50.",
        "G80",
        "B5.",
        "M98 P9",
        "#3006=1(HERE)",
        "IF[#100 LT 4]GOTO 1",
    ]
)
blocks = st.lists(block, max_size=8)


@given(main=blocks, second=blocks, third=blocks, rows=st.integers(1, 40))
def test_the_parts_of_any_run_are_the_run(
    main: list[str], second: list[str], third: list[str], rows: int
) -> None:
    text = "O1\n#100=0\nN1 #100=#100+1\n" + "\n".join(main) + "\nM99\nO2\n" + "\n".join(second)
    text += "\nM99\nO3\n" + "\n".join(third) + "\nM99\n"
    library = cncsub.loads(text, control=CONTROL)
    run = library.run(max_blocks=150, max_cycles=2)
    stream = library.stream(rows=rows, max_blocks=150, max_cycles=2)
    parts = list(stream)
    axes = {axis for part in parts for axis in part.moves.axes}
    assert axes >= set(run.moves.axes)
    assert_same(parts, run)
    assert stream.stop is run.stop
    assert (stream.alarm and str(stream.alarm)) == (run.alarm and str(run.alarm))


def test_every_part_has_the_columns_of_all_axes_in_memory() -> None:
    library = cncsub.loads(PROGRAM, control=CONTROL)
    names = {tuple(part.moves.columns) for part in library.stream(rows=3, setup=SETUP)}
    assert len(names) == 1
    assert "a" in names.pop()
    lathe = cncsub.loads("O1\nG0 U1. W2.\nM30\n", control="gsk-988ta")
    assert next(lathe.stream()).moves.axes == ["x", "y", "z"]


@pytest.mark.parametrize("rows", [0, -1, True, 1.5, "7", 2**63])
def test_rows_is_a_count(rows: object) -> None:
    library = cncsub.loads("O1\nM30\n", control=CONTROL)
    with pytest.raises((TypeError, ValueError), match="rows (must be|is too large)"):
        library.stream(rows=rows)  # type: ignore[arg-type]


def test_parts_without_end_are_cut_where_they_hold_a_million_moves() -> None:
    library = cncsub.loads(
        "O1\nG0 X0 Y0 Z1.\nN1 G91 G83 Z-99. R0 Q.01 F99.\nGOTO 1\n", control=CONTROL
    )
    stream = library.stream(rows=2**63 - 1, max_blocks=300)
    assert len(list(stream)) > 1
    assert stream.blocks == 300


def test_a_trace_of_calls_streams_calls_alone() -> None:
    library = cncsub.loads(PROGRAM, control=CONTROL)
    parts = list(library.stream(rows=4, trace="calls", setup=SETUP))
    assert sum(len(part.calls) for part in parts) == len(library.run(setup=SETUP).calls)
    assert not any(len(part.steps) or len(part.moves) for part in parts)


LOOP = "O1\nN1 G91 G1 X.01 F900.\nN2 M98 P2\nN3 M99\nO2\nN4 G1 Y.01\nN5 M99\n"


def test_memory_stays_that_of_one_part() -> None:
    code = f"""
        import resource, cncsub
        library = cncsub.loads({LOOP!r}, control={CONTROL!r})
        peaks = []
        for blocks in (200_000, 5_000_000):
            rows = 0
            for part in library.stream(rows=20_000, max_cycles=10**9, max_blocks=blocks):
                rows += len(part.steps) + len(part.moves.x)
            peaks.append(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024)
        print(rows, *peaks)
    """
    done = subprocess.run(
        [sys.executable, "-c", textwrap.dedent(code)], capture_output=True, text=True, check=True
    )
    rows, first, second = map(int, done.stdout.split())
    assert rows == 7_000_000
    assert second - first < 16 + KEPT, "MiB: 25 times the blocks took that much more"


# ---- Parquet ----


def test_a_stream_goes_to_parquet(tmp_path: Path) -> None:
    library = cncsub.loads(PROGRAM, control=CONTROL)
    run = library.run(setup=SETUP)
    library.stream(rows=5, setup=SETUP).to_parquet(tmp_path / "run")
    for table in TABLES:
        files = sorted((tmp_path / "run").glob(f"{table}-*.parquet"))
        frame = pd.concat(map(pd.read_parquet, files))
        assert len(frame) == len(getattr(run, table))
    pattern = tmp_path / "run" / "steps-*.parquet"
    counted = duckdb.sql(f"select program, count(*) from '{pattern}' group by 1").fetchall()
    assert dict(counted) == pd.Series(run.steps.to_pandas()["program"]).value_counts().to_dict()
    library.stream(main="O4").to_parquet(tmp_path / "dwell")
    assert pd.read_parquet(tmp_path / "dwell" / "calls-000000.parquet").empty
    with pytest.raises(FileExistsError, match="another folder"):
        library.stream().to_parquet(tmp_path / "run")


def test_a_ctrl_c_between_a_file_and_its_writer_leaves_no_part_of_a_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")

    real = parquet.ParquetWriter
    made = []

    def writer(*arguments: object, **options: object) -> object:
        made.append(real(*arguments, **options))
        if len(made) == 8:  # each table has had its first file
            raise KeyboardInterrupt
        return made[-1]

    monkeypatch.setattr(parquet, "ParquetWriter", writer)
    monkeypatch.setattr(cncsub.stream._Files, "_FULL", 1000)
    stream = cncsub.loads(LOOP, control=CONTROL).stream(max_cycles=10**6, max_blocks=10**6)
    stream.to_parquet(tmp_path)
    assert stream.stop == cncsub.Stop.INTERRUPTED
    assert not list(tmp_path.glob("*.part"))


def test_a_stream_that_is_cut_off_leaves_whole_files(tmp_path: Path) -> None:
    code = f"""
        import cncsub
        cncsub.stream._Files._FULL = 100_000
        library = cncsub.loads({LOOP!r}, control={CONTROL!r})
        stream = library.stream(max_cycles=10**12, max_blocks=10**12)
        stream.to_parquet({str(tmp_path)!r})
        print(stream.stop.value)
    """
    for number in (signal.SIGINT, signal.SIGKILL):
        for file in tmp_path.glob("*"):
            file.unlink()
        with subprocess.Popen(
            [sys.executable, "-c", textwrap.dedent(code)], stdout=subprocess.PIPE, text=True
        ) as process:
            try:
                wait_for(lambda: len(list(tmp_path.glob("moves-*.parquet"))) > 1)
                os.kill(process.pid, number)
                told = process.communicate(timeout=60)[0]
            finally:
                process.kill()  # without this it would run for ever
        if number == signal.SIGINT:
            assert told.strip() == "interrupted"
            assert not list(tmp_path.glob("*.part"))
        for table in ("steps", "moves"):
            files = sorted(tmp_path.glob(f"{table}-*.parquet"))
            rows = pa.concat_tables(map(parquet.read_table, files))
            first = rows.column(0).to_numpy()
            np.testing.assert_array_equal(first, np.arange(len(first)))


def wait_for(happened: object, seconds: float = 60) -> None:
    end = time.monotonic() + seconds
    while not happened():  # type: ignore[operator]
        assert time.monotonic() < end
        time.sleep(0.01)


# ---- other libraries ----


def test_tables_reach_other_libraries_with_one_copy() -> None:
    run = cncsub.loads(PROGRAM, control=CONTROL).run(setup=SETUP)
    for table in TABLES:
        rows = getattr(run, table)
        arrow = pa.table(rows)
        frame = rows.to_pandas()
        for name in rows.columns:
            column = rows.column(name)
            chunk = arrow.column(name).chunk(0)
            codes = chunk.indices if pa.types.is_dictionary(chunk.type) else chunk
            assert codes.buffers()[1].address == column.ctypes.data, f"Arrow copies {name}"
            if rows.texts_of(name) is None:
                nullable = isinstance(frame[name].dtype, pd.api.extensions.ExtensionDtype)
                numbers = frame[name].array._data if nullable else frame[name].to_numpy()
                assert numbers.base is not None or nullable, f"pandas copies {name}"
                assert not np.shares_memory(numbers, column), "a frame is its own"
                series = pl.DataFrame(rows)[name]
                if series.null_count():  # polars has no NumPy array with nulls
                    continue
                assert np.shares_memory(series.to_numpy(allow_copy=False), column), name


def test_tables_say_the_same_in_four_libraries() -> None:
    run = cncsub.loads(PROGRAM, control=CONTROL).run(setup=SETUP)
    steps, calls, moves = run.steps, run.calls, run.moves
    for rows in (steps, calls, moves):
        expected = rows.to_pandas()
        for frame in (
            pa.table(rows).to_pandas(),
            pl.DataFrame(rows).to_pandas(),
            duckdb.sql("select * from rows").df(),
        ):
            assert list(frame.columns) == rows.columns
            for name in rows.columns:
                if rows.texts_of(name) is None:
                    np.testing.assert_array_equal(frame[name].to_numpy(), expected[name], name)
                else:
                    assert list(frame[name]) == list(expected[name])
    longest = duckdb.sql("select kind, sum(length) from moves group by kind order by 1").fetchall()
    assert dict(longest)["feed"] == pytest.approx(moves.length[moves.kind == 1].sum())
    assert pl.DataFrame(steps).filter(pl.col("program") == "O2").height == 12


# ---- copies ----


def tables_of(machine: cncsub.Machine) -> list[list[object]]:
    return [list(machine.steps), list(machine.calls), [str(m) for m in machine.moves]]


def test_snapshots_of_every_step_stay_as_they_were() -> None:
    machine = cncsub.loads(PROGRAM, control=CONTROL).machine(setup=SETUP)
    snapshots = []
    for _ in machine:
        snapshots.append((machine.copy(), tables_of(machine)))
    whole = tables_of(machine)
    for snapshot, then in snapshots:
        assert tables_of(snapshot) == then
    for snapshot, then in snapshots[::5]:
        going_on = snapshot.copy()
        going_on.run()
        assert tables_of(going_on) == whole
        assert tables_of(snapshot) == then


def test_a_copy_of_a_long_run_shares_its_rows() -> None:
    library = cncsub.loads(LOOP, control=CONTROL)
    machine = library.machine(max_cycles=10**9, max_blocks=1_000_000)
    machine.run()
    started = resident()
    copies = [machine.copy() for _ in range(200)]
    assert resident() - started < 64 + KEPT, "MiB for 200 copies of a million rows of 45 bytes"
    assert copies[-1].steps[-1] == machine.steps[-1]


def resident() -> float:
    """Return the MiB in memory now."""
    pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20


def test_copies_run_on_in_threads() -> None:
    library = cncsub.loads(LOOP, control=CONTROL)
    machine = library.machine(max_cycles=10**9, max_blocks=300_000)
    machine.run(until=cncsub_block(library))
    for _ in range(1000):
        machine.step()
    copies = [machine.copy() for _ in range(8)]
    threads = [threading.Thread(target=copy.run) for copy in copies]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for copy in copies[1:]:
        np.testing.assert_array_equal(copy.moves.x, copies[0].moves.x)
        np.testing.assert_array_equal(copy.steps.n, copies[0].steps.n)


def cncsub_block(library: cncsub.Library) -> cncsub.Block:
    return library["O2"].blocks[0]


def test_a_machine_at_work_is_not_asked() -> None:
    library = cncsub.loads("O1\nN1 GOTO 1\n", control=CONTROL)
    machine = library.machine(trace="none", max_blocks=10**12, max_seconds=2)
    thread = threading.Thread(target=machine.run)
    thread.start()
    wait_for(lambda: "at work" in repr(machine) or not thread.is_alive())
    if thread.is_alive():
        with pytest.raises(RuntimeError, match="another thread"):
            machine.step()
    thread.join()
    assert machine.stop is cncsub.Stop.LIMIT


# ---- max_memory ----

WRITERS = {
    "steps": "O1\nN1 GOTO 1\n",
    "moves": "O1\nN1 G91 G1 X1. F100\nGOTO 1\n",
    "messages": "O1\nPOPEN\nN1 DPRNT[" + "A" * 200 + "]\nGOTO 1\n",
    "long messages": "O1\nPOPEN\nN1 DPRNT[" + "A" * 100_000 + "]\nGOTO 1\n",
    "calls": "O1\nN1 G65 P2 A1. B2.\nGOTO 1\nO2\nM99\n",
    "cycles": "O1\nG0 X0 Y0 Z1.\nN1 G91 G83 Z-1000. R0 Q.01 F99.\nGOTO 1\n",
}


@pytest.mark.parametrize("what", WRITERS)
def test_memory_is_limited(what: str) -> None:
    limit = 50 * 2**20
    run = cncsub.loads(WRITERS[what], control=CONTROL).run(
        max_memory=limit, max_blocks=10**9, max_seconds=60
    )
    assert run.stop is cncsub.Stop.LIMIT
    assert run.alarm is None
    # A long block that is broken off has done nothing, so its moves do not count.
    assert 0.9 * limit < run.core.memory < 2 * limit
    machine = cncsub.loads(WRITERS[what], control=CONTROL).machine(
        max_memory=2**20, max_blocks=10**9
    )
    for _ in machine:
        pass
    assert machine.stop is cncsub.Stop.LIMIT
