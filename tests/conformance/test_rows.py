"""Every row of the conformance tables, on every control it names."""

from __future__ import annotations

import pytest

import cncsub
from conformance import Row, rows
from outcome import differences, report


@pytest.mark.parametrize("row", rows(), ids=str)
def test_row(row: Row) -> None:
    found = list(differences(row.case, cncsub.controls[row.control]))
    if found:
        pytest.fail(report(row, found), pytrace=False)
