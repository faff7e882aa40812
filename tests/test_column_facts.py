"""What columns hold and in what unit is told once: to Arrow, to Parquet, and in the pages."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import cncsub
from cncsub.analysis.flattening import Origins
from cncsub.tables import Table
from cncsub.tables.columns import all_facts

pyarrow = pytest.importorskip("pyarrow")

TEXT = "O1\nN10 T1 M6\nN20 S100 M3\nN30 G65 P2 A1.\nN40 M30\nO2\n#500=#1\nIF[#1EQ1]GOTO5\nN5 G1 X1. Y2. A3. F100\nM99\n"
TABLES = ("steps", "calls", "moves", "watch", "codes", "conditions")


@pytest.fixture(scope="module")
def run() -> cncsub.Run:
    made = cncsub.loads(TEXT, control="fanuc-0i-f").run(watch=[500], conditions=True)
    assert all(len(getattr(made, name)) for name in TABLES)
    return made


def metadata(table: Any, columns: list[str] | None = None) -> dict[str, dict[bytes, bytes]]:
    return {field.name: field.metadata or {} for field in table.to_arrow(columns).schema}


@pytest.mark.parametrize("name", TABLES)
def test_each_field_of_arrow_says_what_it_holds(name: str, run: cncsub.Run) -> None:
    table = getattr(run, name)
    names = [*table.columns, *table.more_columns]
    assert list(table.column_facts) == names
    for column, of in metadata(table, names).items():
        facts = table.column_facts[column]
        assert of[b"meaning"].decode() == facts.meaning
        assert of.get(b"unit", b"").decode() == facts.unit


def test_the_units_of_moves(run: cncsub.Run) -> None:
    units = {name: of.get(b"unit") for name, of in metadata(run.moves).items()}
    assert (units["x"], units["a"], units["mx"], units["ma"]) == (b"mm", b"deg", b"mm", b"deg")
    assert (units["length"], units["time"], units["spindle"]) == (b"mm", b"s", b"rev/min")
    assert units["feed"] == b"mm/min, mm/rev or 1/min"
    assert units["kind"] is None


def test_the_origins_of_a_flat_program_have_them_too() -> None:
    origins = (
        cncsub.loads("O1\nM98 P2\nM30\nO2\nG0 X1.\nM99\n", control="fanuc-0i-f").flatten().origins
    )
    assert metadata(origins)["pass"] == {b"meaning": b"pass of that call, from 1"}


def test_each_kind_of_table_has_facts() -> None:
    kinds = Table.__subclasses__()
    assert Origins in kinds
    assert len(kinds) > len(TABLES)
    assert all(all_facts(kind._title) for kind in kinds)


def test_no_facts_are_of_columns_that_no_table_has(run: cncsub.Run) -> None:
    for name in TABLES:
        table = getattr(run, name)
        known = [*table.columns, *table.more_columns]
        more = [of for of in all_facts(table._title) if of not in known]
        assert all(name == "moves" and of.lstrip("m") in "abcuvw" for of in more), more


def test_they_go_through_the_stream_and_parquet(run: cncsub.Run, tmp_path: Path) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    streamed = pyarrow.table(run.moves)
    assert streamed.schema.field("time").metadata[b"unit"] == b"s"
    parquet.write_table(streamed, tmp_path / "moves.parquet")
    read = parquet.read_table(tmp_path / "moves.parquet")
    assert read.schema.field("time").metadata[b"unit"] == b"s"
