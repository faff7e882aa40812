"""Columns of texts compare with texts; a missing text is null wherever there are nulls."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

import cncsub

TEXT = "O1\nN10 M98 P2 L2\nM30\nO2\n#100=#100+1\nN30 G0 X#100\nM99\n"


@pytest.fixture(scope="module")
def run() -> cncsub.Run:
    library = cncsub.loads(TEXT, control="fanuc-0i-f")
    return library.run(watch=[100], variables={100: None})


def test_a_column_of_texts_compares_with_texts(run: cncsub.Run) -> None:
    program = run.steps.program
    assert program.dtype == np.int32
    assert program.tolist() == [0, 1, 1, 1, 1, 1, 1, 0]
    inside = program == "O2"
    assert type(inside) is np.ndarray
    assert inside.tolist() == [False, *[True] * 6, False]
    assert ("O2" == program).tolist() == inside.tolist()  # noqa: SIM300
    assert (program != "O2").tolist() == (~inside).tolist()
    assert (program == "O77").sum() == 0
    assert (program != "O77").all()
    assert (program == ["O1", "O2"]).all()
    assert (program == np.array(["O1"])).tolist() == (~inside).tolist()
    assert run.moves.kind[run.moves.kind == "rapid"].size == 2
    assert set(run.calls.program.to_texts()) == {"O2"}


def test_the_codes_are_numbers_as_ever(run: cncsub.Run) -> None:
    program = run.steps.program
    assert (program == 1).tolist() == (program == "O2").tolist()
    assert type(program + 1) is np.ndarray
    assert (program + 1).tolist() == [1, 2, 2, 2, 2, 2, 2, 1]
    assert np.isin(program, [1]).sum() == np.bincount(program)[1] == 6
    assert (program == program.copy()).all()
    assert (program[2:4] == "O2").all()
    assert [run.steps.programs[code] for code in program[:2]] == ["O1", "O2"]
    with pytest.raises(ValueError, match="read-only"):
        program[0] = 1
    assert program.max() == 1


def test_columns_of_other_codes_compare_by_their_texts(run: cncsub.Run) -> None:
    other = cncsub.loads("O2\nM98 P1\nM30\nO1\nM99\n", control="fanuc-0i-f").run().steps.program
    assert other.texts == ("O2", "O1")
    assert (other == run.steps.program[: len(other)]).tolist() == [False, False, True]
    assert (run.steps.program == run.steps.program).all()


def test_a_column_survives_pickling_with_its_texts(run: cncsub.Run) -> None:
    again = pickle.loads(pickle.dumps(run.steps.program))
    assert (again == "O2").sum() == 6


def test_no_sequence_number_is_a_null(run: cncsub.Run) -> None:
    import polars as pl

    expected = [10, None, 30, None, None, 30, None, None]
    assert run.steps.n.tolist() == [-1 if n is None else n for n in expected]
    assert run.steps.to_arrow()["n"].to_pylist() == expected
    assert pl.DataFrame(run.steps)["n"].to_list() == expected
    frame = run.steps.to_pandas()
    assert frame.n.isna().tolist() == [n is None for n in expected]
    assert frame.n.dropna().tolist() == [10, 30, 30]
    assert str(frame.n.dtype) == "Int32"


def test_no_centre_no_value_and_no_parent_are_nulls(run: cncsub.Run) -> None:
    import polars as pl

    assert pl.DataFrame(run.moves)["cx"].null_count() == len(run.moves) == 2
    assert run.moves.to_pandas().cx.isna().all()
    assert run.calls.to_arrow()["parent"].null_count == 1
    assert run.calls.to_arrow()["start_n"].to_pylist() == [None]
    assert run.calls.to_pandas().parent.isna().all()
    changes = cncsub.loads("O1\n#1=5\n#1=#0\nM30\n", control="fanuc-0i-f").run(watch=[1]).watch
    assert changes.to_arrow()["value"].to_pylist() == [5.0, None]
    assert changes.to_arrow()["n"].null_count == 2


def test_a_column_without_a_hole_stays_as_it_is() -> None:
    run = cncsub.loads("O1\nN1 G0 X1.\nN2 M30\n", control="fanuc-0i-f").run()
    assert run.steps.to_arrow()["n"].null_count == 0
    assert run.steps.to_arrow()["n"].to_pylist() == [1, 2]
