"""Every row of the conformance tables, on every control it names."""

from __future__ import annotations

import pytest

import cncsub
from cncsub.testing.outcome import differences, report
from conformance import Row, rows


@pytest.mark.parametrize("row", rows(), ids=str)
def test_row(row: Row) -> None:
    found = list(differences(row.case, cncsub.controls[row.control]))
    if found:
        pytest.fail(report(row, found), pytrace=False)
