"""The notebooks of the examples run from their first cell to their last, and their outputs are
those that are stored.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tools"))

import notebooks  # noqa: E402

NOTEBOOKS = sorted((ROOT / "examples").rglob("*.ipynb"))


def test_there_are_notebooks() -> None:
    assert len(NOTEBOOKS) >= 5


# The parts of the kernel warn about each other; that is not ours to mend.
@pytest.mark.filterwarnings("ignore::DeprecationWarning", "ignore::RuntimeWarning")
@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_the_outputs_of_a_notebook_are_current(file: Path) -> None:
    for name in ("nbclient", "nbformat", "ipykernel"):
        pytest.importorskip(name, reason=f"{name} is not installed")
    assert notebooks.ran(file) == file.read_text(encoding="utf-8"), "run tools/notebooks.py"


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda file: file.stem)
def test_a_stored_notebook_is_small_and_shows_what_a_reader_looks_for(file: Path) -> None:
    text = file.read_text(encoding="utf-8")
    assert len(text) < 150_000
    assert str(ROOT) not in text
    assert " at 0x" not in text
    cells = [cell for cell in json.loads(text)["cells"] if cell["cell_type"] == "code"]
    outputs = [output for cell in cells for output in cell["outputs"]]
    assert not [output for output in outputs if output["output_type"] in ("error", "stream")]
    data = [output["data"] for output in outputs]
    assert all("text/plain" in shown for shown in data)
    if ".plot(" in text:
        assert any("image/svg+xml" in shown for shown in data)
        assert not any("application/vnd.plotly.v1+json" in shown for shown in data)
