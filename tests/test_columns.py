"""Columns are computed in pieces, by several threads: they say the same as the rows, for every size
of a table, whoever else looks at it.
"""

from __future__ import annotations

import copy
import math
import pickle
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import pytest

import cncsub

PIECE = 1 << 15  # rows that one thread takes at a time

MILL = """O1
G90 G54 G0 X0 Y0 Z5. S1000 M3
G43 H1
#1=0
WHILE[#1LT#500]DO1
#1=#1+1
G1 X[#1MOD97] Y[#1MOD31] F[100+#1MOD3]
G2 X[#1MOD97+2.] I1.
G4 P10
IF[#1MOD100NE0]GOTO5
G31 Z-1.
G1 A[#1MOD360]
G55
N5 G0 Z1.
G54
END1
M30
"""
LATHE = """O1
G0 X0 Z0
G96 S100 M3
G50 S2000
#1=0
WHILE[#1LT#500]DO1
#1=#1+1
#2=#1-FIX[#1/9]*9
G1 X[10+#2] W-.1 F.2
G32 Z-5. F1.
G0 Z0
END1
M30
"""
COMPENSATED = """O1
G90 G0 X0 Y0
#1=0
WHILE[#1LT#500]DO1
#1=#1+1
G41 D1 G1 X10. Y10. F500
Y50.
G2 X20. Y60. R10.
G1 X50.
G40 X0 Y0
END1
M30
"""
CALLS = "O1\nM98 P2 L3\nM98 P3\nM30\nO2\nM98 P3 L#500\nM99\nO3\nG91 G1 X1. F100\nM99\n"
SETUP: dict[str, Any] = {
    "radius_offsets": {1: 2.0},
    "length_offsets": {1: 10.0},
    "work_offsets": {"G54": {"X": 10.1, "Z": -3.3}, "G55": {"X": 7, "A": 1.1}},
}
PROGRAMS = {
    "arcs, dwells, skips, a late axis": ("fanuc-0i-f", MILL),
    "inches, where a degree counts as one": ("fanuc-0i-f", MILL.replace("G90", "G20 G90")),
    "turning at a constant surface speed": ("gsk-988ta", LATHE),
    "beside its radius": ("fanuc-0i-f", COMPENSATED),
    "subprograms": ("fanuc-0i-f", CALLS.replace("L#500", "L9999")),
}


def ran(control: str, text: str, times: int = 9000) -> cncsub.Run:
    setup = cncsub.Setup() if control.startswith("gsk") else cncsub.Setup(**SETUP)
    library = cncsub.loads(text, control=control)
    run = library.run(variables={500: times}, setup=setup)
    assert str(run.stop) == "end", run.alarm
    return run


def whole(table: Any) -> dict[str, Any]:
    return {name: table.column(name).copy() for name in table.columns}


def assert_same(one: dict[str, Any], other: dict[str, Any]) -> None:
    assert list(one) == list(other)
    for name, column in one.items():
        assert column.dtype == other[name].dtype, name
        assert column.tobytes() == other[name].tobytes(), name


def assert_rows_say_the_same(table: Any, index: int) -> None:
    row = table[index]
    for name in table.columns:
        value, said = table.column(name)[index].item(), getattr(row, name)
        texts = table.texts_of(name)
        if texts is not None:
            assert texts[value] == said, (index, name)
        elif said is None:
            assert value == -1 or math.isnan(value), (index, name)
        else:
            assert value == said, (index, name)


@pytest.mark.parametrize("what", PROGRAMS)
def test_columns_of_several_pieces_say_what_the_rows_say(what: str) -> None:
    run = ran(*PROGRAMS[what])
    for table in (run.steps, run.moves):
        size = len(table)
        seams = [at + by for at in range(0, size, PIECE) for by in (-2, -1, 0, 1, 2)]
        for index in {0, size - 1, *range(0, size, 997), *seams}:
            if 0 <= index < size:
                assert_rows_say_the_same(table, index)
    assert len(run.moves) > PIECE or len(run.steps) > PIECE
    # Each piece is summed in order, and then the pieces, as the engine does.
    lengths = run.moves.length.tolist()
    pieces = [sum(lengths[at : at + PIECE]) for at in range(0, len(lengths), PIECE)]
    assert sum(pieces) == run.moves.total_length


@pytest.mark.parametrize("what", PROGRAMS)
def test_columns_one_by_one_are_those_asked_for_together(what: str) -> None:
    control, text = PROGRAMS[what]
    one, other = ran(control, text), ran(control, text)
    for of in ("steps", "moves"):
        together = getattr(other, of)
        together.fetched(together.columns)
        assert_same(whole(getattr(one, of)), whole(together))


def test_tables_around_the_size_of_a_piece() -> None:
    library = cncsub.loads("O1\nG91 G1 F100\nN1 X1. Y1.\nGOTO1\n", control="fanuc-0i-f")
    for blocks in (1, 2, 2 * PIECE - 2, 2 * PIECE, 2 * PIECE + 2, 2 * PIECE + 4, 4 * PIECE + 2):
        run = library.run(max_blocks=blocks)
        assert np.array_equal(run.steps.step, np.arange(len(run.steps)))
        assert np.array_equal(run.moves.move, np.arange(len(run.moves)))
        assert np.array_equal(run.moves.x, np.arange(1.0, len(run.moves) + 1))
        assert np.all(run.moves.length == math.sqrt(2))
        assert np.array_equal(run.moves.mx, run.moves.x)


def test_an_empty_table_has_all_its_columns() -> None:
    library = cncsub.loads("O1\nM30\n", control="fanuc-0i-f")
    for run in (library.run(), library.run(trace="none")):
        for table in (run.moves, run.calls):
            assert [len(column) for column in whole(table).values()] == [0] * len(table.columns)
    assert all(len(column) == 0 for column in whole(library.run(trace="none").steps).values())


def test_a_copy_goes_its_own_way_and_the_columns_of_each_are_its_own() -> None:
    machine = cncsub.loads(MILL, control="fanuc-0i-f").machine(variables={500: 12_000})
    machine.run(until=("O1", 5))
    for _ in range(50_000):
        machine.step()
    copy = machine.copy()
    before = whole(machine.moves)
    assert_same(before, whole(copy.moves))
    copy.run()
    assert_same(before, whole(machine.moves))
    machine.run()
    assert_same(whole(copy.moves), whole(machine.moves))
    assert_same(whole(copy.steps), whole(machine.steps))
    for name, column in before.items():
        assert np.array_equal(
            copy.moves.column(name)[: len(column)], column, equal_nan=column.dtype.kind == "f"
        )


def test_parts_of_a_stream_number_their_rows_through_the_run() -> None:
    library = cncsub.loads(MILL, control="fanuc-0i-f")
    run = library.run(variables={500: 9000})
    parts = list(library.stream(variables={500: 9000}, rows=3 * PIECE))
    for of in ("steps", "moves"):
        for name in ("step", "x", "kind") if of == "moves" else ("step", "line"):
            joined = np.concatenate([getattr(part, of).column(name) for part in parts])
            assert np.array_equal(joined, getattr(run, of).column(name)), (of, name)


def test_threads_look_at_one_run_at_once() -> None:
    expected = ran("fanuc-0i-f", MILL)
    moves, steps = whole(expected.moves), whole(expected.steps)
    run = ran("fanuc-0i-f", MILL)

    def look(_: int) -> None:
        assert_same(moves, run.moves.core.move_columns(run.moves.columns))
        assert_same(steps, {n: run.steps.core.step_column(n) for n in run.steps.columns})

    with ThreadPoolExecutor(8) as pool:
        list(pool.map(look, range(24)))


@pytest.mark.parametrize("trace", ["none", "calls", "blocks", "moves"])
def test_a_step_is_the_last_row_of_the_table(trace: Any) -> None:
    machine = cncsub.loads(CALLS.replace("L#500", "L2"), control="fanuc-0i-f").machine(trace=trace)
    taken = []
    while (step := machine.step()) is not None:
        assert step == machine.steps[-1]
        assert hash(step) == hash(machine.steps[-1])
        taken.append(step)
    assert taken == list(machine.steps)
    assert machine.step() is None
    first = taken[0]
    assert type(first) is type(machine.steps[0])
    assert repr(first) == (
        "Step(step=0, program='O1', n=None, line=2, depth=0, frame=-1, repeat=1)"
    )
    with pytest.raises(AttributeError):
        first.n = 3  # type: ignore[misc]


# ---- blocks and programs of steps and moves ----


def test_steps_have_their_text_and_their_block() -> None:
    library = cncsub.loads(CALLS.replace("L#500", "L3"), control="fanuc-0i-f")
    run = library.run()
    assert "text" not in run.steps.columns
    assert run.steps.more_columns == ["text"]
    texts = run.steps.text.to_texts().tolist()
    blocks = {(p.name, b.line): b for p in library.values() for b in p.blocks}
    for step, text in zip(run.steps, texts, strict=True):
        block = blocks[step.program, step.line]
        assert (step.text, text) == (block.text, block.text)
        assert step.block == block
        assert step.block.words == block.words
    assert sorted(run.steps.texts) == sorted(set(texts))
    assert run.steps.n[run.steps.text == "G91 G1 X1. F100"].tolist() == [-1] * texts.count(
        "G91 G1 X1. F100"
    )


def test_a_step_of_a_machine_and_of_mdi_has_its_text() -> None:
    library = cncsub.loads("O1\nN10 G4 X1.\nM30\nO2\nM99\n", control="fanuc-0i-f")
    machine = library.machine()
    assert [step.text for step in machine] == ["N10 G4 X1.", "M30"]
    assert machine.steps.text.to_texts().tolist() == ["N10 G4 X1.", "M30"]
    typed = library.mdi("G0 X5. M98 P2")
    assert [step.text for step in typed.steps] == ["G0 X5. M98 P2", "M99"]


def test_the_text_of_a_step_travels_and_its_block_does_not() -> None:
    step = cncsub.loads("O1\nN10 G4 X1.\nM30\n", control="fanuc-0i-f").run().steps[0]
    sent = pickle.loads(pickle.dumps(step))
    assert (sent, sent.text, sent.block) == (step, "N10 G4 X1.", None)
    assert pickle.loads(pickle.dumps(sent)).text == "N10 G4 X1."
    assert copy.deepcopy(step).text == "N10 G4 X1."
    assert cncsub.Step(0, "O1", 10, 2, 0, -1, 1) == step
    assert cncsub.Step(0, "O1", 10, 2, 0, -1, 1).text == ""


def test_the_column_of_texts_grows_with_a_machine() -> None:
    machine = cncsub.loads("O1\nN1 G4 X1.\nGOTO1\n", control="fanuc-0i-f").machine()
    machine.step()
    assert machine.steps.text.to_texts().tolist() == ["N1 G4 X1."]
    for _ in range(2):
        machine.step()
    assert machine.steps.text.to_texts().tolist() == ["N1 G4 X1.", "GOTO1", "N1 G4 X1."]


@pytest.mark.parametrize("what", PROGRAMS)
def test_moves_have_the_block_of_their_step(what: str) -> None:
    run = ran(*PROGRAMS[what], times=500)
    rows = run.moves.step
    for name in ("program", "n", "line"):
        assert run.moves.column(name).tolist() == run.steps.column(name)[rows].tolist(), name
    for index in range(0, len(run.moves), 97):
        move, step = run.moves[index], run.steps[run.moves[index].step]
        assert (move.program, move.n, move.line) == (step.program, step.n, step.line)


@pytest.mark.parametrize("rows", [1, 2, 3, 7])
def test_moves_that_were_held_back_have_their_block_in_a_part_behind(rows: int) -> None:
    text = COMPENSATED.replace("WHILE[#1LT#500]DO1", "WHILE[#1LT3]DO1").replace(
        "Y50.", "N40 Y50.\n#2=1\n#2=2\n#2=3"
    )
    library = cncsub.loads(text, control="fanuc-0i-f")
    setup = cncsub.Setup(**SETUP)
    whole = [(m.step, m.program, m.n, m.line) for m in library.run(setup=setup).moves]
    parts = list(library.stream(rows=rows, setup=setup))
    assert [(m.step, m.program, m.n, m.line) for part in parts for m in part.moves] == whole
    assert any(move.n == 40 for part in parts for move in part.moves)
    for part in parts:
        assert part.moves.line.tolist() == [move.line for move in part.moves]
        assert part.moves.program.to_texts().tolist() == ["O1"] * len(part.moves)


def test_tables_join_by_program_and_sequence_number() -> None:
    pl = pytest.importorskip("polars")
    run = cncsub.loads(CALLS.replace("L#500", "L3"), control="fanuc-0i-f").run()
    moves, steps = pl.DataFrame(run.moves), pl.DataFrame(run.steps)
    joined = moves.join(steps, on=["step", "program", "line"])
    assert len(joined) == len(run.moves)
    assert moves["n"].null_count() == len(run.moves)
    assert set(run.moves.to_pandas()["program"]) == {"O3"}
    texts = run.steps.to_arrow(["step", "text"]).column("text").to_pylist()
    assert texts == run.steps.text.to_texts().tolist()
    codes = pl.DataFrame(run.codes)
    assert {"step", "program", "n", "line"} <= set(codes.columns) & set(moves.columns)


def test_the_memory_of_a_large_column_is_its_own_while_somebody_looks() -> None:
    library = cncsub.loads("O1\nN10 G91 G1 X1. F1.\nGOTO10\n", control="fanuc-0i-f")
    rows = 600_000  # blocks, half of them moves: more than two megabytes a column

    def column() -> Any:
        return library.run(max_blocks=rows).moves.x

    first = column()
    part, wanted = first[1000:2000], first[1000:2000].copy()
    del first
    for _ in range(3):
        assert (column() * 0 == 0).all()
    assert (part == wanted).all()
