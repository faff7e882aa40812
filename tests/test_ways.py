"""The short ways of common blocks do what the general way does: all rows and the generated programs
run both with them and without (`general_only`).
"""

from __future__ import annotations

from collections import defaultdict

import pytest

import cncsub
from comparison import Comparison
from conformance import Row, rows
from trials import Trials
from ways import by_both_ways, parting, runs_of


def by_folder() -> dict[str, list[Row]]:
    """Return the rows, a list for each folder of the tables."""
    lists = defaultdict(list)
    for row in rows():
        lists["/".join(row.case.topic.split("/")[:-1])].append(row)
    return dict(lists)


ROWS = by_folder()


@pytest.mark.parametrize("folder", ROWS)
def test_rows_do_the_same_by_the_general_way(folder: str) -> None:
    found = []
    for row in ROWS[folder]:
        difference = parting(*runs_of(row.case, cncsub.controls[row.control]))
        if difference is not None:
            found.append(f"{row}: {difference}")
    assert not found, f"{len(found)} rows:\n" + "\n".join(found[:20])


def test_generated_programs_do_the_same_by_the_general_way() -> None:
    comparison = Comparison(7)
    for place in range(30):
        program = comparison.program(place)
        for station in comparison.on(place):
            text = comparison.text(place, program, station)
            by_both_ways(text, station.control, setup=station.setup)


def test_contours_do_the_same_by_the_general_way() -> None:
    trials = Trials(7)
    for place in range(200):
        station, drawing, written = trials.contour(place)
        setup = trials.setup(station, drawing, written)
        by_both_ways(written.text, station.made(), setup=setup)


def test_a_copy_of_a_library_keeps_to_its_way() -> None:
    library = cncsub.loads("O1\nM30\n", control="fanuc-0i-f", general_only=True)
    again = library.read_for("gsk-988ta")
    assert [part.code.general_only for part in (library, again)] == [True, True]
