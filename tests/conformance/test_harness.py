"""The languages in which rows are written are read as they are meant."""

from __future__ import annotations

import pytest

from cncsub.testing.cases import as_program, read_runs
from cncsub.testing.moves import Move, compare, read_moves, read_point, write_point


@pytest.mark.parametrize(
    ("text", "blocks"),
    [
        ("", ""),
        ("N10 N30 N20", "N10 N30 N20"),
        ("N0010  N020", "N10 N20"),
        ("N10*3 N20", "N10 N10 N10 N20"),
        ("N5 (N60 N70)*2 N80", "N5 N60 N70 N60 N70 N80"),
        ("(N1 (N2 N3)*2)*2", "N1 N2 N3 N2 N3 N1 N2 N3 N2 N3"),
        ("O1:N10 (O2:N010 O2:N20)*2", "O1:N10 O2:N10 O2:N20 O2:N10 O2:N20"),
        ("%1000:N10 N20*0", "%1000:N10"),
        ("MY:NAME:N5", "MY:NAME:N5"),
    ],
)
def test_runs_are_written_out(text: str, blocks: str) -> None:
    assert read_runs(text) == tuple(blocks.split())


@pytest.mark.parametrize(
    "text", ["10", "O1", "O1:10", "(N10", "N10)", "N10 (*2 N20)", "Nx", "N10*"]
)
def test_runs_that_mean_nothing_are_refused(text: str) -> None:
    with pytest.raises(ValueError, match="block|parenthesis|cannot read"):
        read_runs(text)


def test_a_program_loses_the_indentation_of_the_table() -> None:
    assert as_program("\n        O1\n        N10 M30\n    ") == "O1\nN10 M30\n"
    assert as_program("O1\nN10 M30") == "O1\nN10 M30\n"
    assert as_program("") == ""
    assert as_program(b"O1\r\n") == b"O1\r\n"


def test_moves_are_read() -> None:
    text = """
        R X1 Y2.5 Z-3
        CW X4 Y0 Z-1 C X2 Y0
        W 1.5
    """
    assert read_moves(text) == (
        Move("rapid", {"X": 1, "Y": 2.5, "Z": -3}),
        Move("cw", {"X": 4, "Y": 0, "Z": -1}, {"X": 2, "Y": 0}),
        Move("dwell", seconds=1.5),
    )
    assert read_moves("none") == read_moves("") == ()


@pytest.mark.parametrize(
    "line", ["G X1", "R", "R X1 X2", "R x1", "CW X1 Y2", "F X1 C X2", "W", "F X"]
)
def test_a_move_that_means_nothing_is_refused(line: str) -> None:
    with pytest.raises(ValueError, match=".+"):
        read_moves(line)


def test_a_point_is_written_as_it_is_read() -> None:
    assert write_point(read_point("X-0 Y86.6025 Z1.00001")) == "X0 Y86.6025 Z1"


def test_an_axis_that_is_not_named_stays() -> None:
    expected = read_moves("R X10\nF Y5\nW 1\nF X0")
    made = read_moves("R X10 Y0 Z7\nF X10 Y5 Z7\nW 1\nF X0 Y5 Z7")
    start = {"X": 0.0, "Y": 0.0, "Z": 7.0}
    assert list(compare(expected, made, start)) == []
    assert list(compare(expected, made, start | {"Z": 8.0})) != []


def test_the_first_move_that_differs_is_marked() -> None:
    expected = read_moves("R X10\nF X20")
    made = read_moves("R X10\nR X20\nF X30")
    (text,) = compare(expected, made, {})
    assert [line[2] for line in text.splitlines()[1:]] == [" ", ">", ">"]
